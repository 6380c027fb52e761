// What is measured of packets after an impact: energy, width, tail, acceleration.

#include "lattice/dps/dps_impact.hpp"
#include "lattice/impact/impact.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/packet.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// A front whose amplitude is that of a compact packet of `width` sites, with a tail ahead.
Front compact(double width) {
  std::vector<double> e(40, 0.0);
  for (int k = -10; k <= 10; ++k) {
    const double x = 2 * k / (width + 1);
    const double a = std::abs(x) < 1 ? std::pow(std::cos(M_PI * x / 2), 2) : 0;
    e[std::size_t(20 + k)] = a * a + 1e-7;
  }
  Front front;
  front.add(e, 20);
  return front;
}

}  // namespace

TEST_CASE("the front of a linear wave is no travelling breather", "[property]") {
  const Dps linear{140, Ends::free, 1, 0.5};
  const Path front = follow_dps(linear, dps_impact(140), 100, 2000, 1e-8).path;
  CHECK(front.centre.back() > 80);
  CAPTURE(speed_change(front).value, energy_change(front));
  CHECK(std::abs(speed_change(front).value) < 0.05);
  CHECK(energy_change(front) < -0.1);
}

TEST_CASE("a packet's width is not any number", "[unit]") {
  for (std::size_t width : {3, 5, 7, 9}) {
    CAPTURE(width);
    const Front front = compact(double(width));
    CHECK(front.width() == width);
    check_close(front.tail(), std::sqrt(1e-7), 0, 1e-6);
  }
}

TEST_CASE("only what rises above the waves between is visible", "[property]") {
  std::vector<double> v(100, 0.0);
  v[1] = 1, v[50] = 0.2, v[80] = -0.3;
  check_close(prominence(v, 80), 1.5, 1e-14);
  v[50] = -0.4;
  CHECK(prominence(v, 80) < 1);
  v[50] = 0.2, v[1] = 0.1;
  CHECK(prominence(v, 80) < 1);
  // The same impact on linear wells leaves no surface mode, on soft ones it does.
  const auto shot = [](double s) {
    const ImpactRun out =
        strike(EventCorrected{0.1}, on_long_chain({1.87, {.well = Quartic{s}}, 400, 400}));
    return prominence(out.end.v, *front_packet(out.density));
  };
  CHECK(shot(-1.0 / 6) > 1);
  CHECK(shot(0) < 1);
}

TEST_CASE("a packet's energy changes from the mean of one half of its way to that of the other",
          "[unit]") {
  Path path;
  double first = 0, second = 0;  // of seven samples, three and four
  for (int k = 0; k < 7; ++k) {
    path.t.push_back(k), path.centre.push_back(fit_from + k), path.peak.push_back(1);
    path.energy.push_back(3 + std::cos(k));
    (k < 3 ? first : second) += path.energy.back() / (k < 3 ? 3 : 4);
  }
  check_close(energy_change(path), second / first - 1, 1e-13);
}

TEST_CASE("forces rise though two of them are alike", "[unit]") {
  CHECK(largest_fall({{-1, 0.1}, {-0.95, 0.1}, {-2, 0.1}, {-3, 0.2}}) < 0);
  check_close(largest_fall({{-1, 0.1}, {-3, 0.1}, {-2, 0.1}, {-4, 0.1}}), 0.8, 1e-14);
  CHECK(largest_fall({{-3, 0.1}, {-2, 0.1}, {-1, 0.1}}) > 0);
}
