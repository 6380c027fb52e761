// Stationary DpS states: equation, symmetry, scaling, tails, identity, and what is refused.

#include "lattice/standing/stationary.hpp"

#include <complex>

#include "lattice/dps/dps_impact.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/quadruple/extended.hpp"
#include "sec3/continuum.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// Largest residual of -mu u_n = D_n - D_{n-1} relative to mu |u_n|, written out independently.
template <class T>
T residual(const Stationary<T>& s) {
  const T least = least_exact<T>();
  const auto size = [](T x) { return x < T(0) ? T(-x) : x; };
  const auto pull = [&](std::size_t i) {
    if (i == 0 || i >= s.u.size()) return T(0);
    const T r = s.u[i] - s.u[i - 1];
    using std::sqrt;
    return T(r * sqrt(size(r)));
  };
  T worst(0);
  for (std::size_t i = 0; i < s.u.size(); ++i) {
    if (size(s.u[i]) < least) continue;
    const T rest = size(T(1 + (pull(i + 1) - pull(i)) / (s.mu * s.u[i])));
    if (!(rest <= worst)) worst = rest;
  }
  return worst;
}

template <class T>
void check_symmetry(const Stationary<T>& s) {
  const std::size_t n = s.u.size();
  for (std::size_t i = 0; i < n; ++i)
    CHECK(s.u[i] == (s.centre == Centre::site ? s.u[n - 1 - i] : T(0) - s.u[n - 1 - i]));
}

}  // namespace

TEST_CASE("the difference from the quasi-continuum profile is the largest one", "[unit][dps]") {
  auto state = stationary<double>(Centre::site, 1.0, 31);
  for (std::size_t i = 0; i < state.u.size(); ++i)
    state.u[i] = quasi_continuum(Centre::site, site_number(i, state.u.size()));
  CHECK(continuum_difference(state) == 0);
  const double top = largest(state);
  state.u[3] += 0.1 * top;
  state.u[20] -= 0.2 * top;
  check_close(continuum_difference(state), 0.2, 1e-12);
}

TEST_CASE("sites carry the article's numbers", "[unit][dps]") {
  CHECK(site_number(0, 8) == -3);
  CHECK(site_number(7, 8) == 4);
  CHECK(site_number(3, 7) == 0);
  for (std::size_t sites : {7, 8})
    for (std::size_t i = 0; i < sites; ++i) CHECK(site_index(site_number(i, sites), sites) == i);
}

TEST_CASE("stationary states solve their equation in every precision", "[unit][dps]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (std::size_t sites : {4, 6, 10, 20, 30, 60}) {
      const std::size_t n = sites + (centre == Centre::site);
      CAPTURE(int(centre), n);
      const auto one = stationary<double>(centre, 1, n);
      const auto quad = stationary<Quadruple>(centre, 1, n);
      CHECK(residual(one) < 2e-15);
      CHECK(residual(stationary<long double>(centre, 1, n)) < 2e-15L);
      CHECK(residual(quad) < Quadruple(4e-33));
      check_symmetry(one);
      check_symmetry(quad);
      for (std::size_t i = 0; i < n; ++i) {
        const auto exact = static_cast<double>(quad.u[i]);
        if (std::abs(exact) > 1e-290) check_close(one.u[i], exact, 0, 1e-12);
      }
    }
}

TEST_CASE("contact sum and norm", "[unit][dps]") {
  for (double mu : {0.01, 1.0, 30.0})
    for (Centre centre : {Centre::site, Centre::bond}) {
      const auto s = stationary<double>(centre, mu, centre == Centre::site ? 25 : 24);
      check_close(s.contact_sum(), mu * s.norm(), 0, 1e-14);
    }
  // Our digits, found again by quadruple precision on another chain length.
  const auto site = stationary<Quadruple>(Centre::site, 1, 51).norm();
  const auto bond = stationary<Quadruple>(Centre::bond, 1, 50).norm();
  check_close(static_cast<double>(site), 0.0053604202279709888, 0, 1e-15);
  check_close(static_cast<double>(bond), 0.0053604130927007855, 0, 1e-15);
  check_close(static_cast<double>(Quadruple(bond - site)), -7.1352702032507e-9, 0, 1e-13);
}

TEST_CASE("the tail's logarithms grow by 3/2 a site", "[property][dps]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto u = stationary<double>(centre, 1, centre == Centre::site ? 25 : 24).u;
    for (long n = 5; n <= 10; ++n) {
      const std::size_t i = site_index(n, u.size());
      check_close(std::log(std::abs(u[i + 1])) / std::log(std::abs(u[i])), 1.5, 5e-4);
    }
    CHECK(u[site_index(6, u.size())] * u[site_index(7, u.size())] < 0);
  }
}

TEST_CASE("a stationary state only turns its phase", "[property][dps]") {
  // An independent route: integrated by GSL, A_n = a u_n turns by e^{i a^{1/2} tau / (2 tau_0)}.
  const double scale = 20;
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto s = stationary<double>(centre, 1, centre == Centre::site ? 21 : 20);
    Field field(s.u.begin(), s.u.end());
    for (auto& a : field) a *= scale;
    const Field start = field;
    evolve_dps(Dps{field.size()}, field, 5, 1, 1e-12);
    const auto turn = std::polar(1.0, std::sqrt(scale) * 5 / (2 * tau_0()));
    for (std::size_t i = 0; i < field.size(); ++i)
      check_close(std::abs(field[i] - start[i] * turn), 0, 1e-9);
  }
}

TEST_CASE("the quasi-continuum profile is close and compact", "[unit][dps]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto s = stationary<double>(centre, 1, centre == Centre::site ? 21 : 20);
    for (std::size_t i = 0; i < s.u.size(); ++i)
      check_close(quasi_continuum(centre, site_number(i, s.u.size())), s.u[i], 3e-3);
    CHECK(quasi_continuum(centre, 6) == 0);
    CHECK(quasi_continuum(centre, 3) * quasi_continuum(centre, 4) < 0);
  }
  CHECK(quasi_continuum_envelope(4.7) > 0);
  CHECK(quasi_continuum_envelope(4.72) == 0);
}

TEST_CASE("stationary states that cannot be are refused", "[unit][dps]") {
  CHECK_THROWS_AS(stationary<double>(Centre::site, 1, 20), std::invalid_argument);
  CHECK_THROWS_AS(stationary<double>(Centre::bond, 1, 21), std::invalid_argument);
  CHECK_THROWS_AS(stationary<double>(Centre::site, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(stationary<double>(Centre::site, 0, 21), std::invalid_argument);
  CHECK_THROWS_AS(stationary<double>(Centre::site, -1, 21), std::invalid_argument);
  CHECK_THROWS_AS(stationary<double>(Centre::site, std::nan(""), 21), std::invalid_argument);
  const auto text =
      refusal<std::runtime_error>([] { stationary<double>(Centre::site, 1, 21, 1.5, 2); });
  check_line(text, "did not converge");
  CHECK(std::count(text.begin(), text.end(), ',') >= 2);
}
