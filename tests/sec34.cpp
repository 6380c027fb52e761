// What decides statements in words measures what the words describe.

#include "sec34/acceleration.hpp"
#include "sec34/packet.hpp"

#include <complex>

#include "lattice/impact/impact.hpp"
#include "sec3/branches.hpp"
#include "sec33/dps_motion.hpp"
#include "sec33/exchange.hpp"
#include "sec4/phonons.hpp"
#include "support/check.hpp"
#include "support/estimates.hpp"

using namespace lattice;

namespace {

/// The front of a linear wave: 2i A' = A_(n+1) - 2 A_n + A_(n-1), struck at its free end.
Path linear_front() {
  Field a = dps_impact(140);
  const auto rate = [](const Field& x) {
    Field f(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      const auto right = n + 1 < x.size() ? x[n + 1] - x[n] : 0;
      const auto left = n > 0 ? x[n] - x[n - 1] : 0;
      f[n] = std::complex<double>(0, -0.5) * (right - left);
    }
    return f;
  };
  const auto moved = [](const Field& x, double h, const Field& f) {
    Field y = x;
    for (std::size_t n = 0; n < x.size(); ++n) y[n] += h * f[n];
    return y;
  };
  Path path;
  const double h = 0.05;
  for (int k = 1; k <= 2000; ++k) {
    const Field f1 = rate(a), f2 = rate(moved(a, h / 2, f1)), f3 = rate(moved(a, h / 2, f2)),
                f4 = rate(moved(a, h, f3));
    for (std::size_t n = 0; n < a.size(); ++n)
      a[n] += h / 6 * (f1[n] + 2.0 * f2[n] + 2.0 * f3[n] + f4[n]);
    const auto d = density(a);
    if (const auto site = front_packet(d, 0.05)) path.add(h * k, d, *site);
  }
  return path;
}

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

/// Breathers of three sites, of which the first `moving` pass a site, as both tolerances say.
NoiseTrials breathers(std::size_t count, std::size_t moving, double time = 4) {
  NoiseTrials list(count);
  for (std::size_t k = 0; k < count; ++k) {
    list[k].fine.sites = {3, 3};
    list[k].fine.t = {0, time};
    list[k].fine.X = {0, k < moving ? 1.4 : 0.4};
    list[k].coarse = list[k].fine;
  }
  return list;
}

/// The pairs on 31 sites: that of `second` beside the pinning pair, all others at the edge.
std::vector<Pair> pairs_with(std::complex<double> second) {
  const double edge = -std::pow(std::sin(M_PI / 1.1), 2);
  std::vector<Pair> all{{1e-8, 1e-12}, {second, 1e-12}};
  while (all.size() + 1 < 31) all.push_back({edge, 1e-12});
  return all;
}

}  // namespace

TEST_CASE("a condition counts its error bar", "[unit]") {
  CHECK(above("x", {1.2, 0.1}, 1).holds());
  CHECK_FALSE(above("x", {1.05, 0.1}, 1).holds());
  CHECK(below("x", {0.8, 0.1}, 1).holds());
  CHECK_FALSE(below("x", {1.2, 0.1}, 1).holds());
  CHECK_FALSE(below("x", {std::nan(""), 0.1}, 1).holds());
  CHECK_FALSE(above("x", {2, std::nan("")}, 1).holds());
  CHECK_FALSE(holds({}));
  CHECK_FALSE(holds({above("x", exact(2), 1), below("y", exact(2), 1)}));
}

TEST_CASE("the larger and the smaller of two count their error bars", "[unit]") {
  const Estimate wide{1.0, 0.3}, sharp{1.1, 0.05}, narrow{1.0, 0.05}, blurred{1.1, 0.3};
  CHECK(larger(wide, sharp).value == 1.0);
  CHECK(larger(sharp, narrow).value == 1.1);
  CHECK(smaller(narrow, blurred).value == 1.1);
  CHECK(smaller(narrow, sharp).value == 1.0);
}

TEST_CASE("the front of a linear wave is no travelling breather", "[property]") {
  const Path front = linear_front();
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

TEST_CASE("a control that moves later, and a trial that is torn", "[unit]") {
  const auto later = [](const auto& controls) { return delay_of(controls, breathers(16, 16, 1)); };
  const auto is = [](const Delay& d, double share, double ratio) {
    return d.later.value == share && std::abs(d.ratio.value - ratio) < 1e-12;
  };
  CHECK(is(later(breathers(16, 16, 4)), 1, 4));
  CHECK(is(later(breathers(16, 16, 1)), 0, 1));
  CHECK(later(breathers(16, 0, 9)).ratio.value > 9);  // none moves: the end of the run counts
  auto some = breathers(16, 16, 4);
  for (std::size_t k = 0; k < 5; ++k) some[k].fine.t[1] = some[k].coarse.t[1] = 1;
  CHECK(is(later(some), 11.0 / 16, 4));
  auto one = breathers(16, 16);
  CHECK(torn(one) == 0);
  one[3].coarse.X = {0, 0.9};
  CHECK(torn(one) == 1);
  one[2].fine.sites[1] = 7;
  CHECK(largest_spread(one).value == 7.0 / 3);
}

TEST_CASE("four multipliers near one, and pairs that leave the circle", "[unit]") {
  CHECK(off_circle(pairs_with(-0.013)) == 0);
  CHECK(at_edge(pairs_with(-0.013), 1.1) == 56);
  CHECK(off_circle(pairs_with(0.013)) == 1);
  CHECK(off_circle(pairs_with({-0.5, 0.1})) == 1);
  CHECK(off_circle(pairs_with(-1.013)) == 1);  // beyond -1
  CHECK(from_one(pairs_with(-0.013)[1]).value > 0.1);
  CHECK(from_one(pairs_with(-1e-4)[1]).value < 0.1);
  // The larger multiplier counts, beyond +1 as beyond -1 and off the axis
  const std::vector<Pair> pairs{{0.25, 1e-12}, {-1.25, 1e-12}, {{-0.5, 0.1}, 1e-12}, {-0.5, 1e-12}};
  check_close(excess(pairs).value, 0.5 + std::sqrt(1.25), 1e-14);
  check_close(excess({pairs[0]}).value, 0.5 + std::sqrt(1.25), 1e-14);
  check_close(excess(pairs, 1).value, 0.5 + std::sqrt(1.25), 1e-14);
  CHECK(excess(pairs, 2).value > 0.1);
  CHECK(excess(pairs, 3).value < 1e-15);
  check_close(from_one(pairs[0]).value, 0.5 + std::sqrt(1.25), 1e-14);
}

TEST_CASE("what increases does so at every step, beyond its errors", "[unit]") {
  const auto increases = [](const std::vector<Estimate>& values) {
    return above("", least_ratio(values), 1).holds();
  };
  CHECK(increases({{1, 1e-3}, {2, 1e-3}, {2.1, 1e-3}}));
  CHECK_FALSE(increases({{1, 1e-3}, {3, 1e-3}, {2, 1e-3}, {4, 1e-3}}));
  CHECK_FALSE(increases({{1, 0.05}, {1.01, 0.05}}));
  CHECK_FALSE(increases({{1, 0}, {std::nan(""), 0}, {3, 0}}));
  CHECK_FALSE(increases({{1, 0}}));
  // A barrier that vanishes between two of its values, although its modulus grows from each to the next.
  CHECK(increases({{-1, 1e-3}, {-3, 1e-3}, {-9, 1e-3}}));
  CHECK_FALSE(increases({{-1, 1e-3}, {3, 1e-3}, {9, 1e-3}}));
}

TEST_CASE("a curve increases as a whole if its arches do", "[unit]") {
  const auto whole = [](std::vector<double> values) {
    std::vector<Estimate> curve;
    for (double v : values) curve.push_back({v, 1e-3});
    const Arches arches(curve);
    return failing({above("arches", arches.growth, 1), above("end", arches.end_over_before, 1)});
  };
  CHECK(whole({1, 2, -3, -5, -2, 4, 8, 6, -9, -20}).empty());
  CHECK(whole({1, 2, 3}).empty());
  CHECK(whole({1, 3, 2}) == "arches end");           // one arch, not growing
  CHECK(whole({20, 9, -6, -8, 4}) == "arches end");  // reversed
  CHECK(whole({1, 2, -5, -4, 3, 6, -4, -7, 5}) == "arches end");
  CHECK(whole({1, 2, -3, -9, -4}) == "end");     // falls at the end
  CHECK(whole({1, -1.0005, 3, 4}) == "arches");  // within the errors
}

TEST_CASE("the size of a curve is the mean of its moduli, known from every second", "[unit]") {
  check_estimate(mean_size({{1, 0}, {2, 0}, {-3, 0}, {4, 0}}), 2.5, 0.5);
  check_estimate(mean_size({{1, 1}, {1, 1}}), 1, 1);
}

TEST_CASE("a family begins at rest only with the square of the detuning", "[unit]") {
  const auto at = [](double omega, double power, double rest) {
    Orbit<double> orbit;
    orbit.omega = omega;
    orbit.amplitude = rest + std::pow(omega - 1, power);
    return orbit;
  };
  const auto begins = [&](double power, double rest) {
    const auto exponent = [&](double omega) {
      return growth_exponent(at(omega, power, rest), at(1 + 2 * (omega - 1), power, rest));
    };
    return holds(within(compare(exponent(1.001), exponent(1.0005)), 1.95, 2.05));
  };
  CHECK(begins(2, 0));
  CHECK_FALSE(begins(0.5, 0));
  CHECK_FALSE(begins(2, 1e-3));
}

TEST_CASE("for s = 0.3 Phi is not much smaller than for the article's soft wells", "[property]") {
  double largest = 0;
  for (int k = 0; k <= 400; ++k)
    largest = std::max(largest, coefficients(M_PI * k / 400, 0.5, 0.3).phi);
  CHECK(largest > 0.1 * 0.25);  // theirs is 1/4
}

TEST_CASE("forces rise though two of them are alike", "[unit]") {
  CHECK(largest_fall({{-1, 0.1}, {-0.95, 0.1}, {-2, 0.1}, {-3, 0.2}}) < 0);
  check_close(largest_fall({{-1, 0.1}, {-3, 0.1}, {-2, 0.1}, {-4, 0.1}}), 0.8, 1e-14);
  CHECK(largest_fall({{-3, 0.1}, {-2, 0.1}, {-1, 0.1}}) > 0);
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
