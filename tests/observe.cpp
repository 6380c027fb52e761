// Packet tracking, centres and fits on densities made by hand.

#include "lattice/diagnostics/observe.hpp"

#include "check.hpp"
#include "lattice/impact/impact.hpp"

using namespace lattice;

TEST_CASE("the tracker takes the front-most packet, not the largest", "[unit][observe]") {
  std::vector<double> e(100, 0);
  e[2] = 10;                            // surface mode
  e[40] = 3, e[41] = 2;                 // slow packet
  e[69] = 0.5, e[70] = 1, e[71] = 0.5;  // front
  e[90] = 1e-9;                         // dust
  REQUIRE(front_packet(e));
  CHECK(*front_packet(e) == 70);
  check_close(energy_centre(e, 70), 71, 1e-12);
  check_close(window_sum(e, 70), 2, 1e-12);
  CHECK_FALSE(front_packet(std::vector<double>(10, 0.0)).has_value());
}

TEST_CASE("windows are cut at the ends of the chain", "[unit][observe]") {
  const std::vector<double> e{1, 2, 3};
  check_close(window_sum(e, 0), 6, 1e-15);
  check_close(window_sum(e, 2, 1), 5, 1e-15);
  check_close(energy_centre(e, 1), (1 + 4 + 9) / 6.0, 1e-15);
}

TEST_CASE("a line is recovered with its error", "[unit][observe]") {
  const Line exact = fit_line({0, 1, 2, 3}, {1, 3, 5, 7});
  check_close(exact.slope, 2, 1e-14);
  check_close(exact.intercept, 1, 1e-14);
  check_close(exact.slope_error, 0, 1e-14);
  // Residuals +-1 about slope 0: sum of squares 4, two degrees of freedom, sum (t - mean)^2 = 5.
  check_close(fit_line({0, 1, 2, 3}, {1, -1, -1, 1}).slope_error, std::sqrt(4 / 2.0 / 5), 1e-14);
  CHECK_THROWS_AS(fit_line({0, 1}, {0, 1}), std::invalid_argument);
}

TEST_CASE("participation counts sites", "[unit][observe]") {
  check_close(participation({0, 1, 1, 1, 0}), 3, 1e-14);
  check_close(participation({0, 7, 0}), 1, 1e-14);
}

TEST_CASE("the highest peak is found between samples", "[unit][observe]") {
  Track track;
  for (int k = 0; k < 20; ++k) {
    const double t = 0.2 * k;
    track.add(t, {0, 1 + std::cos(2 * (t - 1.05)), 0}, 1);
  }
  const Estimate highest = track.largest_peak(0, 10);
  check_close(highest.value, 2, 2e-4);
  check_close(highest.value, 2, highest.error);
}

TEST_CASE("a packet is eleven sites wide, as below Eq. (24)", "[unit][observe]") {
  const std::vector<double> flat(100, 1.0);
  CHECK(window_sum(flat, 50) == 11);
  CHECK(energy_centre(flat, 50) == 51);
  // A second peak six sites away is another packet, one five sites away is not
  std::vector<double> e(100, 0);
  e[50] = 1, e[56] = 0.5;
  CHECK(*front_packet(e) == 56);
  e[56] = 0, e[55] = 0.5;
  CHECK(*front_packet(e) == 50);
}

TEST_CASE("a packet holds a hundredth of the energy", "[unit][observe]") {
  std::vector<double> e(100, 0);
  e[20] = 1;
  for (const auto& [ahead, where] : {std::pair(0.0102, 70U), {0.0100, 20U}}) {
    e[70] = ahead;
    CHECK(*front_packet(e) == where);
  }
}

TEST_CASE("the strongest site is looked for outside of the first five", "[unit][observe]") {
  CHECK(strongest_site({9, 9, 9, 9, 9, 1, 3, 2}) == 7);
  CHECK(strongest_site({9, 8, 7}, 1) == 2);
  CHECK_FALSE(strongest_site({1, 2, 3, 4, 5}));
  CHECK_FALSE(strongest_site({1, 2, 3, 4, 5, 0, 0}));
}
