// Packet tracking, centres and fits on densities made by hand.

#include "lattice/diagnostics/path.hpp"

#include <functional>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "lattice/impact/impact.hpp"
#include "support/check.hpp"
#include "support/estimates.hpp"

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
  Path path;
  for (int k = 0; k < 20; ++k) {
    const double t = 0.2 * k;
    path.add(t, {0, 1 + std::cos(2 * (t - 1.05)), 0}, 1);
  }
  const Estimate highest = path.largest_peak(0, 10);
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

namespace {

using Numbers = std::vector<double>;

/// Numbers between 0 and 1 without any order.
Numbers dust(std::size_t count, double seed) {
  Numbers x(count);
  for (std::size_t n = 0; n < count; ++n)
    x[n] = std::pow(std::sin(seed + 12.9898 * double(n * n) + 3.7 * double(n)), 2);
  return x;
}

/// The sum of f(n) e_n over the sites within `m` of `peak`.
double near_sum(const Numbers& e, std::size_t peak, int m, std::function<double(int)> f) {
  double sum = 0;
  for (int n = int(peak) - m; n <= int(peak) + m; ++n)
    if (n >= 0 && n < int(e.size())) sum += f(n) * e[std::size_t(n)];
  return sum;
}

double window_by_hand(const Numbers& e, std::size_t peak, int m = 5) {
  return near_sum(e, peak, m, [](int) { return 1.0; });
}

double centre_by_hand(const Numbers& e, std::size_t peak, int m = 5) {
  return near_sum(e, peak, m, [](int n) { return n + 1.0; }) / window_by_hand(e, peak, m);
}

/// The same numbers to ten digits.
void check_all(const Numbers& value, const Numbers& expected, double absolute = 1e-10) {
  REQUIRE(value.size() == expected.size());
  std::size_t worst = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
    if (!(std::abs(value[i] - expected[i]) <= std::abs(value[worst] - expected[worst])) &&
        std::isfinite(value[worst]))
      worst = i;
  CAPTURE(worst);
  check_close(value[worst], expected[worst], absolute);
}

}  // namespace

TEST_CASE("windows, centres and the foremost packet by plain sums", "[unit][observe]") {
  for (int k = 0; k < 12; ++k) {
    Numbers e = dust(23, 0.7 * k);
    for (double& x : e) x = x * x * x * x;
    if (k % 3 == 1) std::fill(e.end() - 1 - k / 2, e.end(), 0.0);
    for (int m : {0, 1, 2, 5}) {
      double total = 0;
      for (double x : e) total += x;
      for (double share : {0.01, 0.2, 0.35}) {
        std::optional<std::size_t> first;
        for (std::size_t n = e.size(); n-- > 0 && !first;) {
          bool most = e[n] > 0 && window_by_hand(e, n, m) >= share * total;
          for (int i = int(n) - m; i <= int(n) + m; ++i)
            if (i >= 0 && i < 23 && e[std::size_t(i)] > e[n]) most = false;
          if (most) first = n;
        }
        CHECK(front_packet(e, share, std::size_t(m)) == first);
      }
      for (std::size_t n = 0; n < e.size(); ++n) {
        check_close(window_sum(e, n, std::size_t(m)), window_by_hand(e, n, m), 1e-14);
        if (window_by_hand(e, n, m) > 0)
          check_close(energy_centre(e, n, std::size_t(m)), centre_by_hand(e, n, m), 1e-12);
      }
    }
  }
  // Exactly the share that is asked for is enough, and of two equal sites the first one is taken
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 1) == 3);
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 0) == 3);
  CHECK(front_packet({0, 0, 1, 1, 0}, 0.1, 1) == 2);
  CHECK_FALSE(front_packet({1, 1, 1}, 0.9, 0));
  check_close(participation({1, 2, 0, 4}), 49.0 / 21, 1e-14);
}

TEST_CASE("a path is read between its samples", "[unit][observe]") {
  const Path path{
      {0, 2, 4, 6, 8, 10}, {10, 12, 15, 19, 24, 22}, {6, 5, 3, 2, 8, 1}, {1, 4, 5, 2, 7, 3}};
  CHECK(path.until(19) == 4);
  CHECK(path.until(99) == 6);
  CHECK(path.between(12, 23).first == Numbers{2, 4, 6});  // the last one is back too late
  CHECK(path.between(12, 23).second == Numbers{12, 15, 19});
  check_close(path.line(12, 19)->slope, 1.75, 1e-14);
  CHECK_FALSE(path.line(13, 19));
  check_close(path.energy_at(13), 5 - 2.0 / 3, 1e-14);
  check_close(path.energy_at(20), 2 + 6 / 5.0, 1e-14);
  CHECK_THROWS_AS(path.energy_at(9), std::runtime_error);
  CHECK_THROWS_AS(path.energy_at(24), std::runtime_error);
  // Passes 13 at 8/3; 3 later, at 17/3, it is at 15 + 4 * 5/6
  check_close(path.travelled(13, 3), 15 + 10 / 3.0 - 13, 1e-13);
  check_close(path.travelled(12, 8), 22 - 12, 1e-13);
  CHECK_THROWS_AS(path.travelled(13, 7.4), std::runtime_error);
  CHECK_THROWS_AS(path.travelled(9, 2), std::runtime_error);
  CHECK_THROWS_AS(path.travelled(24, 2), std::runtime_error);
  // Peaks through (4, 5, 2), at 15 - 7/8, and through (2, 7, 3), which is beyond what counts
  const double first = 5 + 1 / 8.0, second = 7 + 1 / 72.0;
  check_close(path.largest_peak(0, 99).value, second, 1e-13);
  check_close(path.largest_peak(0, 20).value, first, 1e-13);
  check_close(path.largest_peak(14, 20).value, first, 1e-13);
  check_close(path.largest_peak(14, 20).error, (first - 5) / 3,
              1e-13);  // 1 and 7 beside it: no wider top
  // The wider parabola leaves 3 at the first maximum, and makes 3 + 1/40 of 3 + 1/48 at the second
  const Path pair{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                  {1, 2, 3, 4, 5, 6, 7, 8, 9, 10},
                  {},
                  {0, 2, 3, 2, 0, 1, 2.5, 3, 2, 0}};
  check_estimate(pair.largest_peak(0, 6), 3, 0);
  check_estimate(pair.largest_peak(0, 9), 3 + 1 / 48.0, (1 / 40.0 - 1 / 48.0) / 3);
  CHECK(std::isnan(
      path.largest_peak(14.2, 20).value));  // lies at 14.125, and what follows is its flank
  CHECK(std::isnan(path.largest_peak(12, 13).value));  // only a flank
  CHECK(std::isnan(path.largest_peak(30, 40).value));
  // Over the last site only, from 9 to 10
  check_close(packet_amplitude({{0, 1, 2, 3, 4}, {8, 8.5, 9, 9.5, 10}, {}, {1, 9, 1, 4, 1}}).value,
              2, 1e-14);
  // The last two sites, and no maximum
  check_close(
      packet_amplitude({{0, 1, 2, 3, 4}, {8, 8.5, 9, 9.6, 10.2}, {}, {1, 2, 4, 3, 5}}).value,
      std::sqrt(4 + 1 / 24.0), 1e-14);
  CHECK(std::isnan(packet_amplitude({{0, 1, 2}, {8, 8.5, 9}, {}, {1, 2, 4}}).value));
  Path flat{{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 1, 1, 1}, {2, 2, 2, 2}};
  CHECK(flat.largest_peak(0, 9).value == 2);
}

TEST_CASE("a train of pushes by hand", "[unit][pulse]") {
  const Numbers t{0, 2, 4, 6, 8, 10, 12, 14, 16}, x{0, 3, 1, 1, 5, 4, -7, -6, -8};
  const std::vector<Top> tops = maxima(t, x);
  REQUIRE(tops.size() == 3);
  // Vertex at -slope / bend in samples, height middle - slope^2 / (2 bend)
  check_close(tops[0].t, 2 + 2 * 0.5 / 5, 1e-14);
  check_close(tops[0].x, 3 + 0.25 / 10, 1e-14);
  check_close(tops[1].t, 8 + 2 * 1.5 / 5, 1e-14);
  check_close(tops[1].x, 5 + 2.25 / 10, 1e-14);
  check_close(tops[2].t, 14 - 2 * 0.5 / 3, 1e-14);
  check_close(largest_modulus(t, x), 7 + 1 / 8.0, 1e-14);  // 4, 7, 6 of the moduli
  CHECK(largest_modulus({0, 1, 2}, {3, 2, 1}) == 0);
  CHECK(maxima({0, 1, 2, 3}, {1, 2, 2, 1}).size() == 1);  // a plateau counts once
  const auto push = strongest_push(t, x);
  REQUIRE(push);
  check_close(push->t, 8.6, 1e-14);
  check_close(push->force, 5.225, 1e-14);
  check_close(push->period, (tops[2].t - tops[0].t) / 2, 1e-14);
  CHECK_FALSE(strongest_push(t, {0, 6, 1, 1, 5, 4, 4, 4.5, 3}));  // the first one
  CHECK_FALSE(strongest_push(t, {0, 3, 1, 1, 5, 4, 4, 6, 3}));    // the last one
  CHECK_FALSE(strongest_push({0, 1, 2, 3, 4}, {0, 1, 0, 2, 0}));
  check_all(upward_crossings({0, 2, 4, 6, 8}, {0, 1, 2, -1, 1}, 1), {2, 8});
  check_all(upward_crossings({0, 2, 4}, {-1, 3, 0}), {0.5});
  // From the upward passage of 1 at 1 to the last downward one at 11
  check_close(time_above({0, 2, 4, 8, 10, 12}, {0, 2, 0, 3, 2, 0}, 1), 10, 1e-14);
  CHECK(time_above({0, 1}, {0, 2}, 1) == 0);
  CHECK(time_above({0, 1}, {2, 0}, 1) == 0);
}

TEST_CASE("a surface mode is what the first sites hold", "[unit][observe]") {
  const Numbers e{1, 2, 3, 4, 5, 6};
  check_close(boundary_share(e), 15.0 / 21, 1e-15);
  check_close(boundary_share(e, 2), 3.0 / 21, 1e-15);
}
