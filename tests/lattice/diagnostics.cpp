// Windows, centres, fits, smoothed paths and pushes, on densities and paths made by hand.

#include "lattice/diagnostics/path.hpp"

#include <array>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/impact/impact.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

using Numbers = std::vector<double>;

}  // namespace

TEST_CASE("windows, centres and the foremost packet by hand", "[unit][observe]") {
  CHECK(window_sum({1, 2, 3, 4}, 0, 1) == 3);
  CHECK(window_sum({1, 2, 3, 4}, 2, 1) == 9);
  check_close(energy_centre({1, 2, 3, 4}, 3, 1), 25 / 7.0, 1e-14);
  // Exactly the share that is asked for is enough, and of two equal sites the first one is taken
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 1) == 3);
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 0) == 3);
  CHECK(front_packet({0, 0, 1, 1, 0}, 0.1, 1) == 2);
  CHECK_FALSE(front_packet({1, 1, 1}, 0.9, 0));
  CHECK_FALSE(front_packet(Numbers(10, 0.0)));
  check_close(participation({1, 2, 0, 4}), 49.0 / 21, 1e-14);
}

TEST_CASE("a packet is eleven sites wide, as below Eq. (24), with a hundredth of the energy",
          "[unit][observe]") {
  const Numbers flat(100, 1.0);
  CHECK(window_sum(flat, 50) == 11);
  CHECK(energy_centre(flat, 50) == 51);
  // A second peak six sites away is another packet, one five sites away is not
  Numbers e(100, 0);
  e[50] = 1, e[56] = 0.5;
  CHECK(*front_packet(e) == 56);
  e[56] = 0, e[55] = 0.5;
  CHECK(*front_packet(e) == 50);
  e[55] = 0;
  for (const auto& [ahead, where] : {std::pair(0.0102, 90U), {0.0100, 50U}}) {
    e[90] = ahead;
    CHECK(*front_packet(e) == where);
  }
}

TEST_CASE("the strongest site is looked for outside of the first five", "[unit][observe]") {
  CHECK(strongest_site({9, 9, 9, 9, 9, 1, 3, 2}) == 7);
  CHECK(strongest_site({9, 8, 7}, 1) == 2);
  CHECK_FALSE(strongest_site({1, 2, 3, 4, 5}));
  CHECK_FALSE(strongest_site({1, 2, 3, 4, 5, 0, 0}));
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

/// Centres and peaks, sampled every `apart`.
static Path path_of(const Numbers& centre, const Numbers& peak, double apart = 1) {
  Path path;
  for (std::size_t i = 0; i < centre.size(); ++i)
    path.samples.push_back({apart * double(i), centre[i], 1, peak[i]});
  return path;
}

TEST_CASE("a path is read between its samples", "[unit][observe]") {
  const Path path{
      {{0, 10, 6, 1}, {2, 12, 5, 4}, {4, 15, 3, 5}, {6, 19, 2, 2}, {8, 24, 8, 7}, {10, 22, 1, 3}}};
  CHECK(path.count_before(19) == 4);
  CHECK(path.count_before(99) == 6);
  CHECK(path.between(12, 23).first == Numbers{2, 4, 6});  // the last one is back too late
  CHECK(path.between(12, 23).second == Numbers{12, 15, 19});
  check_close(path.line(12, 19)->slope, 1.75, 1e-14);
  CHECK_FALSE(path.line(13, 19));
  check_close(path.energy_at(13), 5 - 2.0 / 3, 1e-14);
  check_close(path.energy_at(20), 2 + 6 / 5.0, 1e-14);
  for (double beside : {9.0, 24.0}) CHECK_THROWS_AS(path.energy_at(beside), std::runtime_error);
}

TEST_CASE("the largest peak is found between samples", "[unit][observe]") {
  const Path path = path_of({10, 12, 15, 19, 24, 22}, {1, 4, 5, 2, 7, 3}, 2);
  // Peaks through (4, 5, 2), at 15 - 7/8, and through (2, 7, 3), which is beyond what counts
  const double first = 5 + 1 / 8.0, second = 7 + 1 / 72.0;
  check_close(path.largest_peak(0, 99).value, second, 1e-13);
  check_close(path.largest_peak(0, 20).value, first, 1e-13);
  check_close(path.largest_peak(14, 20).value, first, 1e-13);
  // 1 and 7 beside it: no wider top
  check_close(path.largest_peak(14, 20).error, (first - 5) / 3, 1e-13);
  // The wider parabola leaves 3 at the first maximum, and makes 3 + 1/40 of 3 + 1/48 at the second
  const Path pair = path_of({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {0, 2, 3, 2, 0, 1, 2.5, 3, 2, 0});
  const Estimate near = pair.largest_peak(0, 6), far = pair.largest_peak(0, 9);
  check_close(near.value, 3, 1e-13);
  check_close(near.error, 0, 1e-13);
  check_close(far.value, 3 + 1 / 48.0, 0, 1e-9);
  check_close(far.error, (1 / 40.0 - 1 / 48.0) / 3, 0, 1e-9);
  // Lies at 14.125, and what follows is its flank; only a flank; nothing
  CHECK(std::isnan(path.largest_peak(14.2, 20).value));
  CHECK(std::isnan(path.largest_peak(12, 13).value));
  CHECK(std::isnan(path.largest_peak(30, 40).value));
  const Path flat = path_of({1, 2, 3, 4}, {2, 2, 2, 2});
  CHECK(flat.largest_peak(0, 9).value == 2);
  // Over the last site only, from 9 to 10; the last two sites; and no maximum
  const auto amplitude = [](const Numbers& centre, const Numbers& peak) {
    return packet_amplitude(path_of(centre, peak)).value;
  };
  check_close(amplitude({8, 8.5, 9, 9.5, 10}, {1, 9, 1, 4, 1}), 2, 1e-14);
  check_close(amplitude({8, 8.5, 9, 9.6, 10.2}, {1, 2, 4, 3, 5}), std::sqrt(4 + 1 / 24.0), 1e-14);
  CHECK(std::isnan(amplitude({8, 8.5, 9}, {1, 2, 4})));
}

TEST_CASE("a path is smoothed, and vertices are found, by hand", "[unit][turning]") {
  // Two samples on either side, with the weights 1/2, 3/2, 2, 3/2 and 1/2
  Path path = path_of({0, 1, 8, 0, 3, 5}, Numbers(6));
  for (std::size_t i = 0; i < 6; ++i) path.samples[i].energy = double(i * i);
  const Path smoothed = smooth(path, 4);
  REQUIRE(smoothed.size() == 2);
  CHECK(smoothed[0].t == 2);
  check_close(smoothed[0].centre, (1.5 + 16 + 1.5) / 6, 1e-14);
  check_close(smoothed[1].centre, (0.5 + 12 + 4.5 + 2.5) / 6, 1e-14);
  check_close(smoothed[1].energy, (0.5 + 6 + 18 + 24 + 12.5) / 6, 1e-14);
  Path three = path_of({1, 2, 3}, {1, 1, 1});
  CHECK(smooth(three, 1).size() == 1);
  three.samples.pop_back();
  CHECK_THROWS_AS(smooth(three, 1), std::invalid_argument);

  // Vertices: an inner one, one that is no extremum, one just at the bound, a straight line, both ends
  const Path way = path_of({1, 5, 4, 2, 1, 0, 0}, Numbers(7), 2);
  const std::vector<std::array<double, 3>> known{{1, 5 + 2.25 / 10, 2 + 2 * 0.3},
                                                 {2, 4, 4},
                                                 {3, 2, 6},
                                                 {4, 1, 8},
                                                 {5, 0 - 0.125, 11},
                                                 {0, 1, 0},
                                                 {6, 0, 12}};
  for (const auto& [i, site, time] : known) {
    CAPTURE(i);
    check_close(vertex(way, std::size_t(i)).site, site, 1e-14);
    check_close(vertex(way, std::size_t(i)).time, time, 1e-14);
  }
  CHECK_FALSE(Moment{}.found());
  CHECK(std::isnan(Moment{}.site));
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
  CHECK(upward_crossings({0, 2, 4, 6, 8}, {0, 1, 2, -1, 1}, 1) == Numbers{2, 8});
  CHECK(upward_crossings({0, 2, 4}, {-1, 3, 0}) == Numbers{0.5});
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
