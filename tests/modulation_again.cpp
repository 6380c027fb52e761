// Envelopes and modulated rings: what is measured by a second formula, and the criteria at their bounds.

#include <algorithm>
#include <numbers>

#include "check.hpp"
#include "sec4/modulation.hpp"
#include "sec4/nls.hpp"

namespace modulation_again {

using namespace lattice;
using std::numbers::pi;

namespace {

/// The energy of a site that only moves.
double speed_of(double energy) {
  return std::sqrt(2 * energy);
}

/// Whether one of the conditions of this name fails.
bool fails(const Criterion& c, const std::string& name) {
  return std::any_of(c.begin(), c.end(),
                     [&](const Condition& x) { return x.name == name && !x.holds(); });
}

Formed ring_of(double peak, double sites, double speed, double width) {
  return {peak, sites, speed, 0.01, 100, width};
}

}  // namespace

TEST_CASE("windows, and the richest of them by counting", "[unit]") {
  CHECK(around(5, 3, 20) == Window{2, 9});
  CHECK(around(2, 3, 20) == Window{0, 6});
  CHECK(around(3, 3, 20) == Window{0, 7});
  CHECK(around(4, 3, 20) == Window{1, 8});
  CHECK(around(18, 3, 20) == Window{15, 20});
  CHECK(around(16, 3, 20) == Window{13, 20});
  for (unsigned seed = 1; seed < 40; ++seed) {
    std::vector<double> e(12);
    unsigned x = seed;
    for (double& value : e) value = double((x = (x * 75 + 74) % 65537) % 10);
    for (std::size_t reach : {1, 3, 5}) {
      std::vector<double> sums;
      for (int n = 0; n < 12; ++n) {
        sums.push_back(0);
        for (int k = 0; k < 12; ++k)
          if (std::abs(k - n) <= int(reach)) sums.back() += e[std::size_t(k)];
      }
      CHECK(richest(e, reach) ==
            std::size_t(std::max_element(sums.begin(), sums.end()) - sums.begin()));
    }
  }
}

TEST_CASE("the envelope is that of the carrier in the window", "[unit]") {
  const Chain chain{4, Harmonic{}, Hertz{}, Ends::free};
  State<double> state(4);
  state.y = {0.1, -0.15, 0.1, 0.3};
  state.v = {0.5, 0.7, -0.2, 0.4};
  const double push = std::pow(0.25, 1.5);  // of the first bead on the second, the only one
  const double a[] = {-0.1 - push, 0.15 + push, -0.1, -0.3};
  const Envelope e = envelope(chain, state, {1, 3});
  const double omega = std::sqrt((a[1] * a[1] + a[2] * a[2]) / (0.49 + 0.04));
  check_close(e.omega, omega, 1e-14);
  REQUIRE(e.amplitude.size() == 4);
  for (std::size_t n = 0; n < 4; ++n)
    check_close(e.amplitude[n], std::sqrt(state.v[n] * state.v[n] + std::pow(a[n] / omega, 2)),
                1e-14);
}

TEST_CASE("no sech near the one that is fitted fits better", "[unit]") {
  const auto sech = [](double n, double height, double centre, double width) {
    return height / std::cosh((n - centre) / width);
  };
  struct Case {
    double centre, width, start;
    Window range;
  };
  for (const Case& c : {Case{30.4, 4, 8, {20, 41}},
                        {31.7, 3, 8, {18, 44}},
                        {29.6, 7, 2, {20, 41}},
                        {30.2, 2, 12, {20, 41}},
                        {33, 5, 1.5, {20, 41}},
                        {30, 9, 3, {25, 50}},
                        {27.3, 4, 20, {20, 41}}}) {
    std::vector<double> a(60, 0.9);
    for (std::size_t n = 15; n < 50; ++n) {
      const double x = double(n + 1);
      a[n] = sech(x, 0.7, c.centre, c.width) + 0.04 * std::sin(1.3 * x) + 0.002 * (x - 30);
    }
    const Sech f = fit_sech(a, c.range, c.start);
    const auto misfit = [&](double height, double centre, double width) {
      double sum = 0;
      for (std::size_t n = c.range.first; n < c.range.last; ++n)
        sum += std::pow(a[n] - sech(double(n + 1), height, centre, width), 2);
      return sum;
    };
    const double least = misfit(f.height, f.centre, f.width), h = 1e-4;
    CAPTURE(c.centre, f.centre, f.width);
    check_close(misfit(f.height + h, f.centre, f.width), misfit(f.height - h, f.centre, f.width),
                1e-11);
    check_close(misfit(f.height, f.centre + h, f.width), misfit(f.height, f.centre - h, f.width),
                1e-11);
    check_close(misfit(f.height, f.centre, f.width + h), misfit(f.height, f.centre, f.width - h),
                1e-11);
    check_close(f.residual, std::sqrt(least / double(c.range.last - c.range.first)) / f.height,
                1e-13);
    check_close(f.width, c.width, 0, 0.15);
    check_close(f.at(28), sech(28, f.height, f.centre, f.width), 1e-15);
  }
}

TEST_CASE("the phonon of Eq. (39) with the article's numbers", "[unit]") {
  const ModulatedPhonon article;
  CHECK(article.sites == 200);
  const double v1 = 1.5 * std::sqrt(0.5), c = std::cos(pi / 4), s = std::sin(pi / 4);
  const double omega = std::sqrt(1 + 2 * v1 * (1 - c));
  check_close(article.round(), 200 * omega / (v1 * s), 1e-10);
  const Chain ring = article.ring();
  CHECK(ring.sites == 200);
  CHECK(ring.ends == Ends::periodic);
  CHECK(ring.well.as<Quartic>().s == -1.0 / 6);
  CHECK(ring.contact.opening() == 0.5);
  const State<double> start = article.start();
  for (int n : {1, 2, 77, 200}) {
    const double factor = 0.15 * (1 + 0.01 * std::cos(pi * n / 100));
    check_close(start.y[std::size_t(n - 1)], factor * std::sin(pi / 4 * n), 1e-14);
    check_close(start.v[std::size_t(n - 1)], -omega * factor * std::cos(pi / 4 * n), 1e-14);
  }
  // The wavenumbers that fit on a ring, without that of the upper edge
  const std::vector<double> two = unstable_band({.s = 4, .sites = 16}, 2);
  std::vector<double> expected;
  for (int k : {2, 4, 6})
    if (coefficients(pi * k / 8, 0.5, 4.0).phi > 0) expected.push_back(pi * k / 8);
  std::sort(expected.begin(), expected.end(), [](double a, double b) {
    return coefficients(a, 0.5, 4.0).phi > coefficients(b, 0.5, 4.0).phi;
  });
  CHECK(expected.size() > 1);
  REQUIRE(two.size() == expected.size());
  for (std::size_t k = 0; k < two.size(); ++k) check_close(two[k], expected[k], 1e-14);
  CHECK(unstable_band({.s = -1, .sites = 16}, 1).front() < 0.4);
  CHECK(unstable_band({.s = 0, .sites = 200}, 1).size() == 37);
}

TEST_CASE("the width of a packet, site by site", "[unit]") {
  std::vector<double> one(20, 0), plateau(30, 0), slope(30, 0);
  one[10] = 1;
  check_close(packet_width(one), 5, 1e-13);
  // A hump at half the height of the other is not part of it, however wide
  for (std::size_t i = 0; i < 5; ++i) plateau[i + 2] = 10;
  for (std::size_t i = 7; i < 25; ++i) plateau[i] = 5;
  check_close(packet_width(plateau), 5 + 2.5, 1e-13);
  std::reverse(plateau.begin(), plateau.end());
  check_close(packet_width(plateau), 5 + 2.5, 1e-13);
  // Flanks of different slope across the joint, by steps of a thousandth of a site
  for (std::size_t i = 0; i < 12; ++i)
    slope[(i + 22) % 30] = i < 8 ? double(i * i) : 260 - 20 * double(i);
  for (int turn = 0; turn < 30; turn += 7) {
    std::rotate(slope.begin(), slope.begin() + 7, slope.end());
    std::vector<double> mean(30, 0);
    for (int i = 0; i < 30; ++i)
      for (int k = -2; k <= 2; ++k)
        mean[std::size_t(i)] += slope[std::size_t((i + k + 30) % 30)] / 5;
    const auto at = [&](double x) {
      const auto i = std::size_t(std::floor(x));
      return mean[i % 30] + (x - double(i)) * (mean[(i + 1) % 30] - mean[i % 30]);
    };
    double wide = 0;
    const double half = *std::max_element(mean.begin(), mean.end()) / 2;
    for (int k = 0; k < 30000; ++k) wide += at((k + 0.5) / 1000) > half ? 1e-3 : 0;
    check_close(packet_width(slope), wide, 2e-3);
  }
}

TEST_CASE("what is seen of a ring at one instant", "[unit]") {
  const Chain ring = ModulatedPhonon{}.ring();
  const auto seen = [&](const std::vector<double>& energies) {
    State<double> state(200);
    state.t = 3;
    for (std::size_t n = 0; n < 200; ++n) state.v[n] = speed_of(energies[n]);
    return ring_sample(ring, state);
  };
  // The window about site 50 holds three heaps; the next ones end at sites 39 and 61,
  // wherever on the ring that is
  for (const auto& [site, share] : {std::pair{61, 0.1}, {39, 0.1}, {60, 0.0}, {40, 0.0}, {70, 0.1}})
    for (std::size_t turn : {0, 100, 145, 150, 157}) {
      std::vector<double> e(200, 0);
      for (std::size_t n : {40, 50, 60}) e[(n + turn) % 200] = 1;
      e[(std::size_t(site) + turn) % 200] += 0.3;
      const RingSample at = seen(e);
      CAPTURE(site, turn);
      CHECK(at.t == 3);
      check_close(at.second, share, 1e-12);
      check_close(at.participation, 3.3 * 3.3 / (share > 0 ? 3.09 : 3.69), 1e-12);
      check_close(at.width, packet_width(e), 1e-12);
    }
  // Gathered: more than five times the mean, and shared by less than half of the ring
  const auto gathered = [&](std::size_t sites, double background, double spike) {
    std::vector<double> e(200, background);
    for (std::size_t n = 0; n < sites; ++n) e[3 * n] = spike;
    return seen(e);
  };
  CHECK(gathered(39, 0, 0.5).gathered);
  check_close(gathered(39, 0, 0.5).peak_over_mean, 200.0 / 39, 1e-12);
  CHECK(gathered(40, 0, 0.5).peak_over_mean == 5);
  CHECK_FALSE(gathered(40, 0, 0.5).gathered);
  CHECK_FALSE(gathered(1, 1, 16).gathered);  // shared by 102 sites
  CHECK(gathered(1, 1, 17).gathered);        // by 96
}

TEST_CASE("what a course was on its way", "[unit]") {
  RingCourse course;
  CHECK(std::isnan(course.gathered));
  CHECK(RingSample{}.width == 0);
  CHECK(Modulated{}.drift == 0);
  course.gathered = 100;
  const auto add = [&](double t, double peak, double sites, double width) {
    course.samples.push_back({RingSample{t, peak + 0.1, sites + 0.2, 0, true, width + 0.3},
                              RingSample{t, peak, sites, 0, true, width}});
  };
  add(50, 3, 90, 2), add(100, 7, 40, 8), add(125, 9, 30, 9), add(150, 8, 35, 7), add(200, 4, 50, 1);
  check_close(course.narrowest().value, 30, 0);
  check_close(course.narrowest().error, 0.2, 1e-13);
  check_close(course.highest().value, 9, 0);
  check_close(course.highest().error, 0.1, 1e-13);
  check_close(course.width().value, 7, 0);
  check_close(course.width().error, 0.3, 1e-13);
  course.samples[3][1].width = 10;
  check_close(course.width().value, 8, 0);
  course.samples[3][1].width = 8;
  course.samples[3][0].width = 8.1;  // the first of equals
  check_close(course.width().error, 0.3, 1e-13);
}

TEST_CASE("a breather on the ring, at both sides of every bound", "[unit][criteria]") {
  Modulated m{State<double>(4), {1, 5, 2, 0}, {0, 1, 2}, {3, 5, 8}};
  const Formed f = formed(m);
  check_close(f.peak_over_mean, 2.5, 1e-14);
  check_close(f.participation, 64.0 / 30, 1e-14);
  check_close(f.speed, 2.5, 1e-14);
  check_close(f.speed_error, std::sqrt(1.0 / 12), 1e-13);
  CHECK(f.sites == 4);
  CHECK(f.width == packet_width({1, 5, 2, 0}));
  const Estimate speed = ring_speed(ring_of(6, 40, 0.2, 20), ring_of(6, 40, 0.25, 20));
  check_close(speed.value, 0.25, 0);
  check_close(speed.error, 0.06, 1e-15);
  const auto moves = [](const Formed& x) {
    return holds(formed_breather(x, x)) ? 1 + int(holds(formed_packet(x, x))) : 0;
  };
  CHECK(moves(ring_of(5.1, 49, 0.011, 24)) == 2);
  CHECK(moves(ring_of(5.1, 49, 0.011, 26)) == 1);
  for (const Formed& x :
       {ring_of(4.9, 49, 0.011, 24), ring_of(5.1, 51, 0.011, 24), ring_of(5.1, 49, 0.009, 24)}) {
    CHECK(moves(x) == 0);
    CHECK(holds(uniform_still(x, x)) == (x.peak_over_mean < 5));
    CHECK(holds(formed_packet(x, x)) == (x.participation > 50));
  }
  CHECK_FALSE(holds(uniform_still(ring_of(5.1, 0, 0, 0), ring_of(5.1, 0, 0, 0))));
  // What two steps see differently does not count
  const Formed good = ring_of(5.1, 49, 0.011, 24);
  for (const auto& [name, other] :
       {std::pair<std::string, Formed>{"peak_over_mean", ring_of(5.4, 49, 0.011, 24)},
        {"share_of_sites", ring_of(5.1, 46, 0.011, 24)},
        {"speed", ring_of(5.1, 49, 0.013, 24)}})
    CHECK(fails(formed_breather(other, good), name));
  CHECK(fails(formed_packet(ring_of(5.1, 49, 0.011, 22), good), "packet_width"));
  CHECK(fails(formed_packet(ring_of(5.4, 49, 0.011, 24), good), "peak_over_mean"));
  CHECK_FALSE(holds(uniform_still(ring_of(4.6, 0, 0, 0), ring_of(4.9, 0, 0, 0))));
}

}  // namespace modulation_again
