#pragma once
/**
# The monodromy matrix

Problem M: one period of a site-centred breather of frequency 1.1 in harmonic wells, and
the derivative of the flow. The peer integrates orbit and columns as one system, and it
gets the best we know: a tridiagonal product with the columns next to each other in
memory, compiled for wide vectors. */

#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/model/kernel.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/quadruple/orbits.hpp"
#include "measure.hpp"

namespace bench {

using Quad = lattice::Quadruple;
using lattice::EventTolerance, lattice::Harmonic, lattice::Hertz, lattice::Tangent;
using Cradle = lattice::Chain;

constexpr double breather_frequency = 1.1;
inline const double period = 2 * std::numbers::pi / breather_frequency;

/// The approximate breather of Eq. (20), good to some percent; the matrix is computed about it.
template <class T>
lattice::State<T> breather(std::size_t sites) {
  const auto profile = lattice::ansatz(lattice::Centre::site, breather_frequency, sites);
  lattice::State<T> s(sites);
  std::copy(profile.y.begin(), profile.y.end(), s.y.begin());
  return s;
}

inline Cradle cradle(std::size_t sites) {
  return {sites, Harmonic{}, Hertz{0}};
}

/// The matrix by our own integrator with scalar `T`.
template <class T>
Tangent<T> event_driven(std::size_t sites, T tolerance, double* evaluations = nullptr) {
  lattice::State<T> s = breather<T>(sites);
  Tangent<T> m(sites, 2 * sites);
  EventTolerance<T> rule;
  if (tolerance > T(0)) rule.tolerance = tolerance;
  const auto report = try_flow(cradle(sites), s, T(period), rule, &m);
  if (evaluations) *evaluations = double(report.evaluations);
  return m;
}

template <class T>
double largest_difference(const std::vector<T>& a, const std::vector<Quad>& b) {
  Quad most(0);
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, Quad(abs(Quad(a[i]) - b[i])));
  return double(most);
}

/**
The peer's right-hand side. The state is $y$, $v$, then all changes of the positions and
all changes of the velocities, row by row. */
LATTICE_WIDE inline void tangent_rows(const double* z, double* dz, const double* stiffness,
                                      std::size_t n, std::size_t columns) {
  const double *y = z + 2 * n, *v = y + n * columns;
  double *dy = dz + 2 * n, *dv = dy + n * columns;
  for (std::size_t i = 0; i < n * columns; ++i) dy[i] = v[i];
  for (std::size_t i = 0; i < n; ++i) {
    const double left = stiffness[i], right = stiffness[i + 1], self = -(1 + left + right);
    const double *here = y + i * columns, *before = i > 0 ? here - columns : here;
    const double* after = i + 1 < n ? here + columns : here;
    double* __restrict__ out = dv + i * columns;
    for (std::size_t k = 0; k < columns; ++k)
      out[k] = self * here[k] + left * before[k] + right * after[k];
  }
}

struct OrbitAndColumns {
  std::size_t n;
  Cradle chain = cradle(n);
  mutable double count = 0;
  mutable std::vector<double> stiffness = std::vector<double>(n + 1, 0.0);

  std::vector<double> start() const {
    std::vector<double> z(2 * n + 4 * n * n, 0.0);
    const auto orbit = breather<double>(n);
    std::copy(orbit.y.begin(), orbit.y.end(), z.begin());
    for (std::size_t i = 0; i < 2 * n; ++i) z[2 * n + i * 2 * n + i] = 1;
    return z;
  }
  void operator()(double, const double* x, double* dx) const {
    lattice::Window all{0, n};
    std::copy(x + n, x + 2 * n, dx);
    accelerate(chain, x, dx + n, all);
    for (std::size_t i = 1; i < n; ++i) stiffness[i] = chain.contact.stiffness(x[i] - x[i - 1]);
    tangent_rows(x, dx, stiffness.data(), n, 2 * n);
    count += 1;
  }
  Score score(const std::vector<double>& z, const std::vector<Quad>& exact) const {
    const std::vector<double> columns(z.begin() + long(2 * n), z.end());
    return {.tangent = largest_difference(columns, exact), .evaluations = count};
  }
};

inline Score adaptive_peer(std::size_t n, const gsl_odeiv2_step_type* type, double tolerance,
                           const std::vector<Quad>& exact) {
  const OrbitAndColumns system{n};
  std::vector<double> z = system.start();
  const auto rhs = [&](double t, const double* x, double* dx) { system(t, x, dx); };
  lattice::Reference reference(rhs, z.size(), lattice::Tolerance(tolerance, 0, type));
  double t = 0;
  reference.advance(t, period, z);
  return system.score(z, exact);
}

/**
The reference is our own integrator with 128 bits, or with 80 where only double is judged; that another method with
another tolerance comes close to it is seen in the peer's rows. */
inline void race_monodromies(Book& book, std::size_t sites, int rounds, bool digits) {
  const std::string name = "M, N=" + std::to_string(sites);
  std::vector<Quad> exact;
  if (digits)
    exact = event_driven<Quad>(sites, Quad(1e-21)).entries;
  else
    for (long double x : event_driven<long double>(sites, 0).entries) exact.emplace_back(x);
  const auto peer = [&](const char* label, const gsl_odeiv2_step_type* type) {
    return Contender{label, false, 1e-6, std::pow(10, -0.25),
                     [=, &exact](double s) { return adaptive_peer(sites, type, s, exact); }};
  };
  const Contender ours{"event location", true, 1e-6, std::pow(10, -0.25), [=, &exact](double s) {
                         Score score;
                         const auto m = event_driven<double>(sites, s, &score.evaluations);
                         score.tangent = largest_difference(m.entries, exact);
                         return score;
                       }};
  const std::vector<Contender> methods{ours, peer("GSL rk8pd, tridiagonal", gsl_odeiv2_step_rk8pd),
                                       peer("GSL rkf45, tridiagonal", gsl_odeiv2_step_rkf45)};
  race(book, name, methods, {1, 1, 1e-12}, digits ? 1 : 3, 1e-15, rounds);
  if (!digits) return;
  book.ratio(name, "demand: 1e-12", "tangent error, double",
             largest_difference(event_driven<double>(sites, 0).entries, exact), 1e-12);
  book.ratio(name, "demand: 1e-15", "tangent error, long double",
             largest_difference(event_driven<long double>(sites, 0).entries, exact), 1e-15);
}

}  // namespace bench
