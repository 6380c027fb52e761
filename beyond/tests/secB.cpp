// Contacts of any exponent: which static DpS breather is stable, and both ends of the exponents.

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "secB/alternating.hpp"
#include "secB/dimer_wave.hpp"
#include "secB/exponents.hpp"
#include "secB/solitary_wave.hpp"
#include "support/check.hpp"

using namespace lattice;

TEST_CASE("the site-centred breather is unstable and the bond-centred one stable for all exponents",
          "[property][dps][exponents]") {
  const auto rows = scan_exponents({1.09, 1.2, 1.5, 2, 3, 4});
  double before = 0;
  for (const OfExponent& row : rows) {
    CAPTURE(row.alpha);
    const double margin = row.site.margin.value;
    CHECK(margin > 1e3 * row.site.margin.error);
    CHECK(row.bond.margin.value < -1e3 * row.bond.margin.error);
    CHECK(row.norm_difference.value < -1e3 * row.norm_difference.error);
    CHECK(margin > before);
    before = margin;
    check_close(row.site.rate.value, std::sqrt((1 - 1 / row.alpha - margin) * row.alpha * margin),
                0, 1e-12);
  }
}

TEST_CASE("both ends of the exponents are what the equation says", "[convergence][exponents]") {
  // Towards one: a Gaussian of the logarithmic equation
  const auto rows = scan_exponents({1.08, 1.1, 1.12});
  const auto near = breathers_of_exponent(1.16), nearer = rows[0];
  for (Centre centre : both_centres) {
    const double off = near.of(centre).bend.value - 1, less = nearer.of(centre).bend.value - 1;
    check_close(less / off, 0.5, 0.06);
  }
  // What pins it falls like exp(-c / (alpha - 1)): local slopes are straight in alpha - 1
  const auto slope_of = [&](std::size_t i, auto of) {
    const double a = 1 / (rows[i].alpha - 1), b = 1 / (rows[i + 1].alpha - 1);
    return std::pair(2 / (a + b), std::log(of(rows[i]) / of(rows[i + 1])) / (b - a));
  };
  const auto at_one = [&](auto of) {
    const auto [x0, y0] = slope_of(0, of);
    const auto [x1, y1] = slope_of(1, of);
    return y0 - (y1 - y0) / (x1 - x0) * x0;
  };
  const Estimate c = pinning_exponent();
  check_close(c.value, 6.490174694, 1e-6);
  check_close(at_one([](const auto& r) { return r.site.margin.value; }), c.value, 0.006);
  check_close(at_one([](const auto& r) { return r.norm_difference.value; }), c.value, 0.012);
  CHECK(std::abs(at_one([](const auto& r) { return r.site.norm.value; }) - c.value) > 1);
  // Far from one: two or three sites
  const auto far = breathers_of_exponent(20), farther = breathers_of_exponent(40);
  const auto closer = [](const Estimate& a, const Estimate& b, double limit) {
    CAPTURE(a.value, b.value, limit);
    CHECK(std::abs(b.value - limit) < 0.7 * std::abs(a.value - limit));
    check_close(b.value, limit, 0.05);
  };
  closer(far.site.norm, farther.site.norm, 2.0 / 3);
  closer(far.bond.norm, farther.bond.norm, 0.5);
  closer(far.site.margin, farther.site.margin, 1.0 / 3);
  closer(far.bond.margin, farther.bond.margin, 0);
  closer(far.norm_difference, farther.norm_difference, -0.25);
}

namespace {

/// A half of an even function at any point of its grid.
double at(const std::vector<double>& half, long j) {
  const auto k = std::size_t(std::abs(j));
  return k < half.size() ? half[k] : 0;
}

}  // namespace

TEST_CASE("the solitary wave solves its equation of motion", "[unit][solitary]") {
  for (double alpha : {1.5, 1.25, 3.0}) {
    CAPTURE(alpha);
    const SolitaryWave w = solitary_wave(alpha, 16, 8);
    // Sums in the place of integrals: the tent over the force is the overlap, up to the square of h
    const auto missed = [&](std::size_t points) {
      const SolitaryWave fine = solitary_wave(alpha, points, 8);
      const long m = long(points);
      double sum = 0;
      for (long k = -m; k <= m; ++k)
        sum += (1 - double(std::labs(k)) / double(m)) / double(m) *
               std::pow(at(fine.overlap, 3 + k), alpha);
      return sum - fine.overlap[3];
    };
    CHECK(std::abs(missed(16)) < 2e-2);
    CHECK(std::abs(missed(32)) < 0.5 * std::abs(missed(16)));
    // 2 K = (alpha + 1) U, and no digit depends on the grid
    check_close(w.kinetic_share(), (alpha + 1) / (alpha + 3), 1e-12);
    check_close(solitary_wave(alpha, 32, 8).velocity[0], w.velocity[0], 1e-10);
  }
  CHECK(solitary_wave(3, 16, 8).width(0.5) < solitary_wave(1.5, 16, 8).width(0.5));
}

TEST_CASE("a struck chain carries that wave", "[unit][solitary]") {
  const SolitaryWave w = solitary_wave(1.5, 16, 6);
  State<double> state = struck(90, 1);
  std::vector<double> t, a, b;
  evolve(EventCorrected{0.05}, Chain{90, None{}}, state, 95, 0.05, [&](const State<double>& now) {
    t.push_back(now.t), a.push_back(now.v[39]), b.push_back(now.v[59]);
  });
  const auto crest = [&](const std::vector<double>& v) {
    return std::size_t(std::max_element(v.begin(), v.end()) - v.begin());
  };
  const double speed = 20 / (t[crest(b)] - t[crest(a)]);
  check_close(speed, std::pow(b[crest(b)] / w.velocity[0], 0.2), 0, 3e-3);
  // From the crest on, in sites, the run and the wave
  const double step = 0.05 * speed * 16;
  for (long k : {5L, 10L, 20L, 30L}) {
    const double x = double(k) * step, low = std::floor(x), rest = x - low;
    const double wave =
        (1 - rest) * at(w.velocity, long(low)) + rest * at(w.velocity, long(low) + 1);
    check_close(b[crest(b) + std::size_t(k)] / b[crest(b)], wave / w.velocity[0], 2e-2);
  }
}

TEST_CASE("dimer waves leave both beads equally displaced and at rest", "[unit][solitary]") {
  const DimerWave w = dimer_wave(passing_pulse(0.155, 40));
  const auto n = long(w.force.size()), middle = n / 2;
  const double h = w.period / 40;
  const auto G = [&](long j) {
    return j >= -middle && j <= middle ? w.force[std::size_t(j + middle)] : 0;
  };
  double X = 0, V = 0, Z = 0, U = 0, most = 0;
  for (long j = -middle; j <= middle; ++j) {
    if (j % 20 == 0 && std::abs(j) < 80) check_close(G(j), Hertz{0}.force(Z - X), 4e-3);
    V += h * (G(-j) - G(j)), U += h / w.mass_ratio * (G(j) - G(40 - j));
    X += h * V, Z += h * U;
    most = std::max(most, V);
  }
  CHECK(most > 0.3);
  check_close(V, 0, 1e-6);
  check_close(U, 0, 1e-5);
  check_close(X, Z, 0, 5e-3);
  CHECK_THROWS_AS(dimer_wave(passing_pulse(0.25, 40)), std::runtime_error);
}

TEST_CASE("the pulse of alternating contacts keeps its energy where it should",
          "[unit][solitary]") {
  CHECK(TwoExponents{1.5, 1.5, 1e-6}.strength_ratio() == 1);
  check_close(TwoExponents{1.5, 2, 1e-6}.strength_ratio(), 1.2e-3, 0, 1e-12);
  const auto loss = [](double second) {
    return loss_per_site({1.5, second, 1.62697e-6}, 41, 71, 1e-9);
  };
  CHECK(loss(1.56) > 1e-3);
  CHECK(std::abs(loss(1.635)) < 1e-5);
  CHECK(loss(1.66) > loss(1.65));
  CHECK(std::abs(loss_per_site({1.5, 1.5, 1e-6}, 41, 71, 1e-9)) < 1e-5);
}
