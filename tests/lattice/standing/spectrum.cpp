// Small motions about stationary DpS states: the contact matrix against the full linearisation, the margin to
// instability, scaling, and what the pinning pair does in time.

#include "lattice/standing/spectrum.hpp"

#include <algorithm>
#include <complex>

#include "lattice/dps/evolve.hpp"
#include "lattice/gsl/random.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/dps_motion.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

template <class T = double>
Stationary<T> state(Centre centre, double mu = 1, double alpha = 1.5) {
  return stationary<T>(centre, T(mu), sites_of(centre, alpha), alpha);
}

/// (m_2 - 2 mu / 3) / mu, by counting.
double margin(const Stationary<double>& s) {
  return instability_margin(s.mu, counted_eigenvalue(s, 2)) / s.mu;
}

/// The centre of |v_n|^4, in sites from where a breather with this centre rests.
double place_of(Centre centre, const Field& v) {
  const double origin = centre == Centre::bond ? 0.5 : 0;
  double all = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::pow(std::abs(v[i]), 4);
    all += weight;
    moment += weight * (double(site_number(i, v.size())) - origin);
  }
  return moment / all;
}

/// `breather` plus z times its translational mode.
Field pushed(const PinnedBreather& breather, std::complex<double> z) {
  Field v = breather.u;
  breather.pair.add(z, v);
  return v;
}

/// Carries `v` in the frame that turns with the breather of exponent `alpha`; calls `look` at equal intervals.
void evolve_field(const PinnedBreather& breather, Field& v, double time, std::size_t samples,
                  double tolerance, double alpha, const DpsObserver& look) {
  evolve_dps(RotatingDps{{v.size(), Ends::free, alpha, 1}, breather.mu}, v, time, samples,
             tolerance, look);
}

/// The same with a look per unit of slow time at the place, and at how far the energy drifts.
DpsRun run_of(const PinnedBreather& breather, Field v, double time, double tolerance) {
  const double start = energy(v);
  DpsRun run;
  evolve_field(breather, v, time, std::size_t(time), tolerance, 1.5, [&](double, const Field& now) {
    run.X.push_back(place_of(breather.centre, now));
    run.drift = std::max(run.drift, std::abs(energy(now) / start - 1));
  });
  return run;
}

/// At which rate the shift of `breather` changes along its growing (sign 1) or decaying (-1) direction.
double rate_along(const PinnedBreather& breather, double sign, double size, double time,
                  double alpha) {
  Field v = pushed(breather, {size, sign * size / breather.pair.leverage});
  double first = 0, last = 0;
  evolve_field(breather, v, time, 1, 1e-12, alpha, [&](double t, Field w) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] -= breather.u[i];
    (t > 0 ? last : first) = breather.pair.of(w).real();
  });
  return std::log(last / first) / time;
}

}  // namespace

TEST_CASE("one breather is unstable and one is stable, by five millionths", "[unit][dps]") {
  for (double mu : {1.0, 10.0}) {
    check_close(margin(state(Centre::site, mu)), 4.85297661617711e-06, 1e-14);
    check_close(margin(state(Centre::bond, mu)), -4.85326567483309e-06, 1e-14);
  }
  // One real pair, or none: the count at the edge is the verdict.
  const auto above = [](const auto& s) {
    return eigenvalues_above(contact_roots(s), 2 * s.mu / 3);
  };
  CHECK(above(state<long double>(Centre::site)) == 2);
  CHECK(above(state<long double>(Centre::bond)) == 1);
  // One strain wrong by a few hundred-thousandths is enough for a wrong verdict.
  auto site = state(Centre::site), bond = state(Centre::bond);
  site.strain[0] *= 1 - 1e-4;
  bond.strain[1] *= 1 + 1e-4;
  CHECK(margin(site) < 0);
  CHECK(margin(bond) > 0);
}

TEST_CASE("counting and solving give the same eigenvalues", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const auto s = state(centre, 3);
    const auto spectrum = contact_spectrum(s);
    REQUIRE(spectrum.m.size() == s.u.size());
    for (std::size_t k = 1; k <= 12; ++k) {
      check_close(counted_eigenvalue(s, k), spectrum.m[k - 1], 1e-14);
      CHECK(eigenvalues_above(contact_roots(s), spectrum.m[k - 1] + 1e-6) == k - 1);
    }
    // The state is the first eigenvector, so the second is orthogonal to it.
    const auto u = Eigen::Map<const Eigen::VectorXd>(s.u.data(), Eigen::Index(s.u.size()));
    check_close(u.dot(spectrum.second) / u.norm(), 0, 1e-14);
  }
}

TEST_CASE("the contact matrix gives the spectrum of the full linearisation",
          "[property][dps][exponents]") {
  for (double alpha : {1.25, 1.5, 4.0})
    for (Centre centre : both_centres) {
      CAPTURE(alpha, int(centre));
      const auto s = state(centre, 2, alpha);
      const auto spectrum = contact_spectrum(s);
      CHECK(std::abs(spectrum.phase_residual) < 1e-14);
      auto full = full_exponents(s);
      const auto reduced = exponents(spectrum);
      REQUIRE(full.size() == reduced.size());
      for (const auto& [real, imaginary] : reduced) {
        const std::complex<double> lambda(real, imaginary);
        auto nearest = std::min_element(full.begin(), full.end(), [&](auto a, auto b) {
          return std::abs(a - lambda) < std::abs(b - lambda);
        });
        // The defective zero, and pairs near zero, are off by the root of rounding
        check_close(std::abs(*nearest - lambda), 0, std::abs(lambda) < 1e-3 ? 1e-6 : 1e-10);
        full.erase(nearest);
      }
      // The full matrix alone, in the longer type, has a growing exponent around a site only
      long double growth = 0;
      for (const auto& lambda : full_exponents(state<long double>(centre, 2, alpha)))
        growth = std::max(growth, lambda.real());
      CHECK((growth > 1e-7L) == (centre == Centre::site));
      CHECK(eigenvalues_above(contact_roots(s), s.mu / alpha) ==
            (centre == Centre::site ? 2U : 1U));
    }
}

TEST_CASE("exponents are proportional to the frequency", "[property][dps]") {
  for (double mu : {1e-6, 1e6})
    check_close(lambda_modulus(mu, counted_eigenvalue(state(Centre::site, mu), 2)) / mu,
                0.00155770760446738, 1e-12);
}

TEST_CASE("perturbations grow and decay at the rate of their exponent",
          "[property][dps][exponents]") {
  const PinnedBreather site(state(Centre::site, 10));
  for (double sign : {1.0, -1.0})
    check_close(rate_along(site, sign, 1e-5, 60, 1.5), sign * site.pair.rate, 0, 1e-4);
  const PinnedBreather other(state(Centre::site, 1, 3));
  check_close(rate_along(other, 1, 1e-7, 4 / other.pair.rate, 3), other.pair.rate, 0, 1e-4);
  // Removed, the pair is gone.
  Field w(site.u.size(), {0.3, -0.2});
  w[3] = {1, 1};
  site.pair.add(-site.pair.of(w), w);
  check_close(std::abs(site.pair.of(w)), 0, 1e-14);
}

TEST_CASE("a stationary state stands still in the turning frame", "[property][dps]") {
  for (Centre centre : both_centres) {
    const PinnedBreather breather(state(centre, 10));
    check_close(place_of(centre, breather.u), 0, 1e-13);
    const DpsRun run = run_of(breather, breather.u, 20, 1e-10);
    CHECK(run.farthest() < 1e-9);
    CHECK(run.drift < 1e-12);
  }
}

TEST_CASE("a pendulum tells which push frees a breather", "[property][dps]") {
  const PinnedBreather bond(state(Centre::bond, 10));
  for (double factor : {0.95, 1.1}) {
    const Field v = pushed(bond, {0, factor * bond.pendulum_push()});
    CHECK((run_of(bond, v, 500, 1e-9).farthest() > 1) == (factor > 1));
  }
}

TEST_CASE("a breather of the DpS equation and its pendulum", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const PinnedBreather b(stationary<double>(centre, 2.5, centre == Centre::site ? 9 : 8));
    CHECK((b.centre == centre && b.mu == 2.5));
    // A small shift along the pair moves the centre by g, to larger n
    const double g =
        (place_of(centre, pushed(b, 1e-5)) - place_of(centre, pushed(b, -1e-5))) / 2e-5;
    CHECK(g > 0);
    check_close(b.centre_per_shift, g, 0, 1e-7);
    check_close(b.pendulum_push(), b.pair.rate / M_PI / b.centre_per_shift / (2.5 - b.pair.m), 0,
                1e-13);
  }
  // Shift, push and growing part of any perturbation
  const PinnedBreather site(stationary<double>(Centre::site, 2.5, 9));
  Random random(5);
  Field w;
  std::complex<double> kick = 0;
  for (Eigen::Index n = 0; n < 9; ++n) {
    const double re = random.uniform(-1, 1);
    w.emplace_back(re, random.uniform(-1, 1));
    kick += w.back() * site.pair.V[n];
  }
  check_close(std::abs(site.pair.of(w) - kick), 0, 1e-14);
  const double growing = (kick.real() + (2.5 - site.pair.m) / site.pair.rate * kick.imag()) / 2;
  check_close(site.pair.growing(w), growing, 0, 1e-13);
}
