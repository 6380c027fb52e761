#include "lattice/model/dps.hpp"

#include <cmath>
#include <numbers>

namespace lattice {

// The two scales: of time, and of the amplitude at a given breather frequency
double tau_0(double alpha) {
  const double root = std::sqrt(std::numbers::pi);
  constexpr double gamma_quarter = 3.6256099082219083119;  // Gamma(1/4)
  if (alpha == 1.5) return 5 * gamma_quarter * gamma_quarter / (24 * root);
  return root * std::tgamma((alpha + 3) / 2) /
         (std::pow(2, alpha - 1) * std::tgamma(alpha / 2 + 1));
}

double breather_eps(double omega_b, double alpha) {
  return std::pow(2 * tau_0(alpha) * (omega_b - 1), 1 / (alpha - 1));
}

namespace {

/**
A contact acts on its two beads with opposite forces, so each is computed once: that of the contact in front of each site
goes into `da`, in a loop that the compiler can vectorise, and is then replaced by the difference, from the far end on.
`power` makes $|d|^{\alpha-1}$ of $|d|^2$. */
template <class Power>
void walk_along(const Dps& dps, const double* __restrict a, double* __restrict da, Power power) {
  const auto stiffness = [&](double x, double y) {
    const double square = x * x + y * y;
    return square > 1e-120 ? power(square) : 0;
  };
  const auto [sites, near_end, exponent, rate] = dps;
  const std::size_t last = sites - 1;
  for (std::size_t n = 0; n < last; ++n) {
    const double x = a[2 * n + 2] - a[2 * n], y = a[2 * n + 3] - a[2 * n + 1];
    const double m = stiffness(x, y);
    da[2 * n] = m * x;
    da[2 * n + 1] = m * y;
  }
  // The contact before the first site, which on a ring is that behind the last one
  const bool ring = near_end == Ends::periodic;
  double re = 0, im = 0;
  if (near_end != Ends::free) {
    const double x = ring ? a[0] - a[2 * last] : a[0], y = ring ? a[1] - a[2 * last + 1] : a[1];
    const double m = stiffness(x, y);
    re = m * x;
    im = m * y;
  }
  da[2 * last] = ring ? re : 0;
  da[2 * last + 1] = ring ? im : 0;
  for (std::size_t n = last; n > 0; --n) {
    const double along = da[2 * n] - da[2 * n - 2], across = da[2 * n + 1] - da[2 * n - 1];
    da[2 * n] = rate * across;
    da[2 * n + 1] = -rate * along;
  }
  const double along = da[0] - re, across = da[1] - im;
  da[0] = rate * across;
  da[1] = -rate * along;
}

}  // namespace

// The power is chosen once for the chain: spheres have the fourth root of the square
void Dps::operator()(double, const double* a, double* da) const {
  if (exponent == 1.5)
    walk_along(*this, a, da, [](double square) { return std::sqrt(std::sqrt(square)); });
  else
    walk_along(*this, a, da,
               [half = (exponent - 1) / 2](double square) { return std::pow(square, half); });
}

// The two conserved quantities of the DpS equation, and the density whose sum is one of them
double norm(const Field& field) {
  double sum = 0;
  for (const auto& a : field) sum += std::norm(a);
  return sum;
}

double energy(const Field& field, bool ring, double alpha) {
  double sum = 0;
  for (std::size_t n = 0; n + 1 < field.size() + std::size_t(ring); ++n) {
    const double d = std::abs(field[n + 1 < field.size() ? n + 1 : 0] - field[n]);
    sum += alpha == 1.5 ? 0.4 * (d * d * std::sqrt(d)) : std::pow(d, alpha + 1) / (alpha + 1);
  }
  return sum;
}

std::vector<double> density(const Field& field) {
  std::vector<double> d;
  for (const auto& a : field) d.push_back(std::norm(a));
  return d;
}

// An impact on the first bead gives it a velocity and no displacement: A_1 is imaginary
Field dps_impact(std::size_t sites) {
  Field field(sites);
  field[0] = {0, -1};
  return field;
}

// Back to the chain: the slow amplitudes turn with the fast oscillation of the wells
State<double> dps_state(const Field& field, double eps, double t) {
  State<double> state(field.size());
  const std::complex<double> phase(std::cos(t), std::sin(t));
  for (std::size_t n = 0; n < field.size(); ++n) {
    state.y[n] = 2 * eps * (field[n] * phase).real();
    state.v[n] = -2 * eps * (field[n] * phase).imag();
  }
  state.t = t;
  return state;
}

}  // namespace lattice
