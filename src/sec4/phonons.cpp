#include "sec4/phonons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lattice {

template <class T>
ContactSeries<T> contact_series(T d) {
  using std::sqrt;
  if (!(d > T(0))) throw std::invalid_argument("a phonon band needs a compression d > 0");
  const T root = sqrt(d);
  return {T(3) / T(2) * root, -T(3) / T(8) / root, -T(1) / T(16) / (d * root)};
}

template <class T>
Phonon<T> phonon(T q, T v1) {
  using std::cos, std::sin, std::sqrt;
  const T square = T(1) + T(2) * v1 * (T(1) - cos(q)), omega = sqrt(square);
  return {omega, v1 * sin(q) / omega, cos(q) - v1 * sin(q) * sin(q) / square};
}

template <class T>
T upper_edge(T v1) {
  using std::sqrt;
  return sqrt(T(1) + T(4) * v1);
}

// The positive root of a quadratic equation for 1 - cos q_c, written so that nothing cancels
template <class T>
T inflection(T v1) {
  using std::acos, std::sqrt;
  return acos(T(1) - T(2) / (T(1) + sqrt(T(1) + T(4) * v1)));
}

// The detour through the second harmonic, then the cubic parts of contact and well
template <class T>
T nls_beta(T q, const ContactSeries<T>& v, T s) {
  using std::sin;
  const T half = sin(q / T(2)), x = T(4) * half * half * half * half;  // (1 - cos q)^2
  return T(16) * v.v2 * v.v2 * sin(q) * sin(q) * x / (T(4) * v.v1 * x + T(3)) +
         T(3) / T(2) * (T(4) * v.v3 * x + s);
}

template <class T>
Coefficients<T> coefficients(T q, T d, T s) {
  const ContactSeries<T> v = contact_series(d);
  const Phonon<T> p = phonon(q, v.v1);
  const T beta = nls_beta(q, v, s);
  return {p.omega, p.group_velocity, p.curvature(v.v1), beta, p.omega_2, -beta * p.omega_2};
}

// A modulation grows as long as nonlinearity outweighs dispersion
double nls_growth(const Coefficients<double>& at, double a, double modulation) {
  const double spread = at.curvature * modulation * modulation / 2;
  const double square = -spread * (spread + at.h() * a * a / 2);
  return square > 0 ? std::sqrt(square) : 0;
}

double fastest_modulation(const Coefficients<double>& at, double a) {
  return std::sqrt(-at.h() * a * a / (2 * at.curvature));
}

std::vector<double> unstable_on_ring(double d, double s, std::size_t sites, std::size_t every) {
  const auto phi = [&](double q) { return coefficients(q, d, s).phi; };
  std::vector<double> band;
  for (std::size_t k = every; 2 * k < sites; k += every) {
    const double q = 2 * std::numbers::pi * double(k) / double(sites);
    if (phi(q) > 0) band.push_back(q);
  }
  std::stable_sort(band.begin(), band.end(), [&](double a, double b) { return phi(a) > phi(b); });
  return band;
}

double sign_change_of_phi(double d, double s, double low, double high) {
  const auto phi = [d, s](double q) { return coefficients(q, d, s).phi; };
  if (!(phi(low) * phi(high) < 0))
    throw std::invalid_argument("phi does not change its sign between the two wavenumbers");
  const bool rises = phi(high) > 0;
  for (int i = 0; i < 70; ++i) {
    const double middle = (low + high) / 2;
    ((phi(middle) > 0) == rises ? high : low) = middle;
  }
  return (low + high) / 2;
}

double largest_phi(double d, double s, std::size_t points) {
  double best = 0;
  for (std::size_t k = 0; k <= points; ++k)
    best = std::max(best, coefficients(std::numbers::pi * double(k) / double(points), d, s).phi);
  return best;
}

// The scalars that are used
#define LATTICE_PHONONS(T)                            \
  template ContactSeries<T> contact_series(T);        \
  template Phonon<T> phonon(T, T);                    \
  template T upper_edge(T);                           \
  template T inflection(T);                           \
  template T nls_beta(T, const ContactSeries<T>&, T); \
  template Coefficients<T> coefficients(T, T, T);

LATTICE_PHONONS(double)
LATTICE_PHONONS(long double)

}  // namespace lattice
