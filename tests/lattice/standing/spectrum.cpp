// Small motions about stationary DpS states: the contact matrix against the full linearisation, the margin to
// instability, and what the pinning pair does in time.

#include "lattice/standing/spectrum.hpp"

#include <algorithm>
#include <complex>

#include "lattice/algebra/dense.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/model/contact.hpp"
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

/// At which rate the shift of `breather` changes along its growing (sign 1) or decaying (-1) direction.
double rate_along(const PinnedBreather& breather, double sign, double size, double time,
                  double alpha) {
  Field v = pushed(breather, {size, sign * size / breather.pair.leverage});
  double first = 0, last = 0;
  const RotatingDps equation{{v.size(), Ends::free, alpha, 1}, breather.mu};
  evolve_dps(equation, v, time, 1, 1e-12, [&](double t, Field w) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] -= breather.u[i];
    (t > 0 ? last : first) = breather.pair.of(w).real();
  });
  return std::log(last / first) / time;
}

/// The exponents lambda of Eq. (22): i lambda are the eigenvalues of the full matrix of a and b* in the perturbation
/// a_n e^{lambda t} + b_n^* e^{lambda^* t}, in which a contact couples a and b. Nothing of its structure is used.
std::vector<std::complex<double>> full_exponents(const Stationary<double>& state) {
  const Eigen::Index n = Eigen::Index(state.u.size());
  Matrix<double> m = Matrix<double>::Zero(n, n);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    const double strain = state.u[std::size_t(i) + 1] - state.u[std::size_t(i)];
    m.block(i, i, 2, 2) +=
        secant_stiffness(strain, state.exponent) * Matrix<double>{{1, -1}, {-1, 1}};
  }
  const double p = (state.exponent + 1) / 2, q = (state.exponent - 1) / 2;
  const Matrix<double> same = state.mu * Matrix<double>::Identity(n, n) - p * m;
  Matrix<double> full(2 * n, 2 * n);
  full << same, -q * m, q * m, -same;
  std::vector<std::complex<double>> out;
  for (const auto& sigma : eigenvalues_of(full)) out.emplace_back(sigma.imag(), -sigma.real());
  return out;
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
      CHECK(eigenvalues_above(contact_roots(s), s.mu / alpha) ==
            (centre == Centre::site ? 2U : 1U));
    }
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
