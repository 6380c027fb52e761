// Small motions about stationary DpS states: the contact matrix against the full linearisation, the
// margin to instability, scaling, and what the pinning pair does in time.

#include "lattice/standing/spectrum.hpp"

#include <algorithm>

#include "lattice/gsl/random.hpp"
#include "support/check.hpp"
#include "support/dps_run.hpp"

using namespace lattice;

namespace {

std::size_t length(Centre centre) {
  return centre == Centre::site ? 25 : 24;
}

template <class T = double>
Stationary<T> state(Centre centre, double mu = 1) {
  return stationary<T>(centre, T(mu), length(centre));
}

/// (m_2 - 2 mu / 3) / mu, by counting.
double margin(const Stationary<double>& s) {
  return instability_margin(s.mu, counted_eigenvalue(s, 2)) / s.mu;
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
  CHECK(above(state(Centre::site)) == 2);
  CHECK(above(state(Centre::bond)) == 1);
  CHECK(above(state<long double>(Centre::site)) == 2);
  CHECK(above(state<long double>(Centre::bond)) == 1);
}

TEST_CASE("a wrong profile gets a wrong verdict", "[unit][dps]") {
  // One strain wrong by a few hundred-thousandths is enough.
  auto site = state(Centre::site), bond = state(Centre::bond);
  site.strain[0] *= 1 - 1e-4;
  bond.strain[1] *= 1 + 1e-4;
  CHECK(margin(site) < 0);
  CHECK(margin(bond) > 0);
}

TEST_CASE("counting and solving give the same eigenvalues", "[unit][dps]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto s = state(centre, 3);
    const auto spectrum = contact_spectrum(s);
    REQUIRE(spectrum.m.size() == s.u.size());
    CHECK(std::abs(spectrum.phase_defect) < 1e-14);
    for (std::size_t k = 1; k <= 12; ++k) {
      check_close(counted_eigenvalue(s, k), spectrum.m[k - 1], 1e-14);
      CHECK(eigenvalues_above(contact_roots(s), spectrum.m[k - 1] + 1e-6) == k - 1);
    }
    // The state is the first eigenvector, so the second is orthogonal to it.
    double dot = 0, norm = 0;
    for (std::size_t i = 0; i < s.u.size(); ++i) {
      dot += s.u[i] * spectrum.second(Eigen::Index(i));
      norm += s.u[i] * s.u[i];
    }
    check_close(dot / std::sqrt(norm), 0, 1e-14);
  }
}

TEST_CASE("the reduction gives the spectrum of the full linearisation", "[property][dps]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto s = state(centre, 2);
    auto full = full_exponents(s);
    auto reduced = exponents(contact_spectrum(s));
    REQUIRE(full.size() == reduced.size());
    // Each reduced exponent has a partner; the defective zero may be off by the root of rounding.
    for (std::size_t k = 0; k < reduced.size(); ++k) {
      const std::complex<double> lambda(reduced[k].first, reduced[k].second);
      auto nearest = std::min_element(full.begin(), full.end(), [&](auto a, auto b) {
        return std::abs(a - lambda) < std::abs(b - lambda);
      });
      check_close(std::abs(*nearest - lambda), 0, k < 2 ? 1e-6 : 1e-10);
      full.erase(nearest);
    }
    const bool unstable = reduced[2].first > 0;
    CHECK(unstable == (centre == Centre::site));
  }
}

TEST_CASE("exponents are proportional to the frequency", "[property][dps]") {
  for (double mu : {1e-6, 1e6})
    check_close(lambda_modulus(mu, counted_eigenvalue(state(Centre::site, mu), 2)) / mu,
                0.00155770760446738, 1e-12);
  check_close(lambda_squared(1.0, 0.0), -1, 0);
  check_close(lambda_squared(2.0, 2.0), 0, 0);
}

TEST_CASE("growing and decaying directions", "[property][dps]") {
  const PinnedBreather site(state(Centre::site, 10));
  check_close(rate_along(site, 1, 1e-5, 60), site.pair.rate, 0, 1e-4);
  check_close(rate_along(site, -1, 1e-5, 60), -site.pair.rate, 0, 1e-4);
  // Removed, the pair is gone.
  Field w(site.u.size(), {0.3, -0.2});
  w[3] = {1, 1};
  site.pair.add(-site.pair.of(w), w);
  check_close(std::abs(site.pair.of(w)), 0, 1e-14);
}

TEST_CASE("a stationary state stands still in the turning frame", "[property][dps]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const PinnedBreather breather(state(centre, 10));
    check_close(place_of(centre, breather.u), 0, 1e-13);
    const DpsRun run = run_of(breather, breather.u, 20, 1e-10);
    CHECK(std::isnan(run.reaches(1e-9)));
    CHECK(run.drift < 1e-12);
  }
}

TEST_CASE("a pendulum tells which push frees a breather", "[property][dps]") {
  const PinnedBreather bond(state(Centre::bond, 10));
  for (double factor : {0.95, 1.1}) {
    const Field v = pushed(bond, {0, factor * bond.freeing_push()});
    CHECK((run_of(bond, v, 500, 1e-9).reaches(1) > 0) == (factor > 1));
  }
}

namespace {

const double half_turn = std::acos(-1.0), never = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a breather of the DpS equation and its pendulum", "[unit][dps]") {
  for (Centre centre : both_centres) {
    const PinnedBreather b(stationary<double>(centre, 2.5, centre == Centre::site ? 9 : 8));
    CHECK((b.centre == centre && b.mu == 2.5));
    // A small shift along the pair moves the centre by g, to larger n
    const double g =
        (place_of(centre, pushed(b, 1e-5)) - place_of(centre, pushed(b, -1e-5))) / 2e-5;
    CHECK(g > 0);
    check_close(b.shift, g, 0, 1e-7);
    check_close(b.freeing_push(), b.pair.rate / half_turn / b.shift / (2.5 - b.pair.m), 0, 1e-13);
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

TEST_CASE("what is read from a run of a DpS breather", "[unit][dps]") {
  DpsRun run;
  run.t = {0, 1, 2, 3}, run.X = {0, -0.25, -0.75, 0.5};
  check_close(run.reaches(0.5), 1.5, 1e-15);
  CHECK(std::isnan(run.reaches(0.8)));
  // Three leave, at 1, 2 and 3; of four the median counts the one that stays as never
  NoiseTrials trials(4);
  for (std::size_t k = 0; k < 4; ++k) {
    trials[k].fine.t = {0, double(k + 1)};
    trials[k].fine.X = {0, k < 3 ? 0.5 + 1e-12 : 0.4};
    trials[k].coarse = trials[k].fine;
  }
  CHECK(passing(trials, 0.5).value == 3);
  CHECK(passing(trials, 0.5, 2.5).value == 2);
  CHECK(passing(trials, 0.5).is_exact);
  check_close(median_departure(trials, 9).value, 3, 1e-9);
  CHECK(median_departure(trials, 2.5).value == never);
  trials[1].coarse.X[1] = 0.4;
  CHECK(passing(trials, 0.5).error == 1);
}
