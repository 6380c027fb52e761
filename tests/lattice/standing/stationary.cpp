// Stationary DpS states: equation, symmetry, scaling, tails, identity, quasi-continuum profile, and what is refused.

#include "lattice/standing/stationary.hpp"

#include <complex>

#include "lattice/dps/evolve.hpp"
#include "lattice/quadruple/quadruple.hpp"
#include "sec3/article_chains.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// Largest residual of -mu u_n = D_n - D_{n-1} relative to mu |u_n|, written out independently.
template <class T>
double residual(const Stationary<T>& s, double alpha) {
  using std::abs, std::pow, std::sqrt;
  const auto pull = [&](std::size_t i) {
    if (i == 0 || i >= s.u.size()) return T(0);
    const T r = s.u[i] - s.u[i - 1], size = abs(r),
            force = alpha == 1.5 ? T(size * sqrt(size)) : T(pow(size, T(alpha)));
    return r < T(0) ? T(-force) : force;
  };
  double worst = 0;
  for (std::size_t i = 0; i < s.u.size(); ++i) {
    if (abs(s.u[i]) < least_exact<T>()) continue;
    const auto rest = static_cast<double>(T(abs(T(1) + (pull(i + 1) - pull(i)) / (s.mu * s.u[i]))));
    if (!(rest <= worst)) worst = rest;
  }
  return worst;
}

}  // namespace

TEST_CASE("stationary states solve their equation in every precision", "[unit][dps]") {
  for (Centre centre : both_centres)
    for (std::size_t sites : {4, 6, 30, 60}) {
      const std::size_t n = sites + (centre == Centre::site);
      CAPTURE(int(centre), n);
      const auto one = stationary<double>(centre, 1, n);
      const auto quad = stationary<Quadruple>(centre, 1, n);
      CHECK(residual(one, 1.5) < 2e-15);
      CHECK(residual(stationary<long double>(centre, 1, n), 1.5) < 2e-15);
      CHECK(residual(quad, 1.5) < 4e-33);
      for (std::size_t i = 0; i < n; ++i) {
        CHECK(quad.u[i] == (centre == Centre::site ? quad.u[n - 1 - i] : -quad.u[n - 1 - i]));
        const auto exact = static_cast<double>(quad.u[i]);
        if (std::abs(exact) > 1e-290) check_close(one.u[i], exact, 0, 1e-12);
      }
    }
  CHECK(site_number(0, 8) == -3);
  CHECK(site_number(7, 8) == 4);
  CHECK(site_number(3, 7) == 0);
  for (std::size_t i = 0; i < 8; ++i) CHECK(site_index(site_number(i, 8), 8) == i);
}

TEST_CASE("static breathers of any exponent solve their equation", "[unit][dps][exponents]") {
  for (double alpha : {1.02, 1.2, 2.5, 10.0})
    for (Centre centre : both_centres) {
      CAPTURE(alpha, int(centre));
      const std::size_t sites = sites_of(centre, alpha);
      const auto s = stationary<double>(centre, 2, sites, alpha);
      CHECK(residual(s, alpha) < 1e-14 * alpha);
      CHECK(residual(s, alpha + 0.01) > 1e-4);
      check_close(s.contact_sum() / (s.mu * s.norm()), 1, 1e-13);
      const auto wide = stationary<Quadruple>(centre, Quadruple(2), sites, alpha);
#ifdef LATTICE_FLOAT128
      CHECK(residual(wide, alpha) < 1e-31);
#else  // Boost's own type takes powers by exp(alpha ln r) and loses the digits of ln r, down to -1e4 in the tails
      CHECK(residual(wide, alpha) < 2e-34 * alpha * 1e4);
#endif
      // At another frequency the same profile is found, larger by the scaling law
      const auto one = stationary<double>(centre, 1, sites, alpha);
      const double factor = std::pow(2, 1 / (alpha - 1));
      for (std::size_t i = 0; i < sites; ++i) {
        const auto exact = static_cast<double>(wide.u[i]);
        if (!(std::abs(exact) > 1e-250)) continue;
        check_close(s.u[i], exact, 0, 1e-11);
        check_close(one.u[i] * factor, exact, 0, 1e-11);
      }
    }
}

TEST_CASE("contact sum and norm", "[unit][dps]") {
  const auto s = stationary<double>(Centre::bond, 0.01, 24);
  check_close(s.contact_sum(), 0.01 * s.norm(), 0, 1e-14);
  // Our digits, found again by quadruple precision on another chain length.
  const auto site = stationary<Quadruple>(Centre::site, 1, 51).norm();
  const auto bond = stationary<Quadruple>(Centre::bond, 1, 50).norm();
  check_close(static_cast<double>(site), 0.0053604202279709888, 0, 1e-15);
  check_close(static_cast<double>(bond), 0.0053604130927007855, 0, 1e-15);
  check_close(static_cast<double>(Quadruple(bond - site)), -7.1352702032507e-9, 0, 1e-13);
}

TEST_CASE("static breathers only turn their phase", "[property][dps][exponents]") {
  for (double alpha : {1.2, 1.5, 4.0})
    for (Centre centre : both_centres) {
      const auto s = stationary<double>(centre, 3, sites_of(centre, alpha), alpha);
      Field field(s.u.begin(), s.u.end());
      const Field start = field;
      evolve_dps(Dps{.sites = field.size(), .exponent = alpha}, field, 2, 1, 1e-13);
      const auto turn = std::polar(1.0, 3 * 2 / (2 * tau_0(alpha)));
      const double size = std::abs(start[field.size() / 2]);
      for (std::size_t i = 0; i < field.size(); ++i)
        check_close(std::abs(field[i] - start[i] * turn) / size, 0, 1e-9);
    }
}

TEST_CASE("the quasi-continuum profile by hand, and how close it is", "[unit][dps]") {
  const auto g = [](double x) { return 0.027 * std::pow(std::cos(x / 3), 6); };
  for (long n = -3; n <= 3; ++n) {
    CAPTURE(n);
    const double sign = n % 2 == 0 ? 1 : -1;
    check_close(quasi_continuum(Centre::bond, n), sign * (g(double(n)) + g(double(n) - 1)), 1e-15);
    check_close(quasi_continuum(Centre::site, n), sign * (g(double(n) + 0.5) + g(double(n) - 0.5)),
                1e-15);
  }
  // With alpha = 2 the envelope is cos^4(x/2)/9
  const auto h = [](double x) { return std::pow(std::cos(x / 2), 4) / 9; };
  check_close(quasi_continuum(Centre::bond, 1, 2), -h(1) - h(0), 1e-15);
  check_close(quasi_continuum(Centre::site, 2, 2), h(2.5) + h(1.5), 1e-15);
  CHECK(quasi_continuum(Centre::bond, 5, 2) == 0);
  CHECK(quasi_continuum_envelope(4.7) > 0);
  CHECK(quasi_continuum_envelope(4.72) == 0);
  for (Centre centre : both_centres) {
    const auto state = stationary<double>(centre, 1, centre == Centre::site ? 31 : 30);
    for (std::size_t i = 0; i < state.u.size(); ++i)
      check_close(quasi_continuum(centre, site_number(i, state.u.size())), state.u[i], 3e-3);
  }
}

TEST_CASE("stationary states that cannot be are refused", "[unit][dps]") {
  const auto refused = [](Centre centre, double mu, std::size_t sites, double alpha = 1.5) {
    CHECK_THROWS_AS(stationary<double>(centre, mu, sites, alpha), std::invalid_argument);
  };
  refused(Centre::site, 1, 20);
  refused(Centre::bond, 1, 21);
  refused(Centre::site, 1, 1);
  for (double mu : {0.0, -1.0, std::nan("")}) refused(Centre::site, mu, 21);
  for (double alpha : {1.0, 0.5, std::nan("")}) refused(Centre::site, 1, 21, alpha);
}
