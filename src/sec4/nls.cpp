#include "sec4/nls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lattice {

// The detour through the second harmonic, then the cubic parts of contact and well
template <class T>
T nls_beta(T q, const ContactSeries<T>& v, T s) {
  using std::cos, std::sin;
  const T x = (T(1) - cos(q)) * (T(1) - cos(q));
  return T(16) * v.v2 * v.v2 * sin(q) * sin(q) * x / (T(4) * v.v1 * x + T(3)) +
         T(3) / T(2) * (T(4) * v.v3 * x + s);
}

// All that the NLS equation says about one wavenumber
template <class T>
Coefficients<T> coefficients(T q, T d, T s) {
  const ContactSeries<T> v = contact_series(d);
  const Phonon<T> p = phonon(q, v.v1);
  const T beta = nls_beta(q, v, s);
  return {p.omega, p.group_velocity, p.curvature(v.v1), beta, p.omega_2, -beta * p.omega_2};
}

// A modulation grows as long as nonlinearity outweighs dispersion
template <class T>
T nls_growth(const Coefficients<T>& at, T a, T modulation) {
  using std::sqrt;
  const T spread = at.curvature * modulation * modulation / T(2);
  const T square = -spread * (spread + at.h() * a * a / T(2));
  return square > T(0) ? sqrt(square) : T(0);
}

template <class T>
T fastest_modulation(const Coefficients<T>& at, T a) {
  using std::sqrt;
  return sqrt(-at.h() * a * a / (T(2) * at.curvature));
}

// Where the modulational instability sets in, by bisection in the wavenumber
template <class T>
T sign_change_of_phi(T d, T s, T low, T high) {
  const auto phi = [d, s](T q) { return coefficients(q, d, s).phi; };
  if (!(phi(low) * phi(high) < T(0)))
    throw std::invalid_argument("phi does not change its sign between the two wavenumbers");
  const bool rises = phi(high) > T(0);
  for (int i = 0; i < 70; ++i) {
    const T middle = (low + high) / T(2);
    ((phi(middle) > T(0)) == rises ? high : low) = middle;
  }
  return (low + high) / T(2);
}

// The wavenumbers of the grid are middles of its cells, so that no end of the band, where phi may vanish, decides
template <class T>
std::vector<Wavenumbers<T>> unstable_wavenumbers(T d, T s) {
  constexpr std::size_t cells = 2000;
  const T pi = std::numbers::pi_v<T>;
  const auto at = [&](std::size_t k) { return pi * (T(double(k)) + T(0.5)) / T(double(cells)); };
  const auto unstable = [&](std::size_t k) { return coefficients(at(k), d, s).phi > T(0); };
  std::vector<Wavenumbers<T>> out;
  bool inside = false;
  for (std::size_t k = 0; k < cells; ++k) {
    if (unstable(k) == inside) continue;
    inside = !inside;
    const T edge = k == 0 ? T(0) : sign_change_of_phi(d, s, at(k - 1), at(k));
    if (inside)
      out.push_back({edge, pi});
    else
      out.back().to = edge;
  }
  return out;
}

// How unstable is the most unstable wave of the band?
double largest_phi(double d, double s, std::size_t points) {
  double best = 0;
  for (std::size_t k = 0; k <= points; ++k)
    best = std::max(best, coefficients(std::numbers::pi * double(k) / double(points), d, s).phi);
  return best;
}

// The scalars that are used
#define LATTICE_NLS(T)                                      \
  template T nls_beta(T, const ContactSeries<T>&, T);       \
  template Coefficients<T> coefficients(T, T, T);           \
  template T nls_growth(const Coefficients<T>&, T, T);      \
  template T fastest_modulation(const Coefficients<T>&, T); \
  template T sign_change_of_phi(T, T, T, T);                \
  template std::vector<Wavenumbers<T>> unstable_wavenumbers(T, T);

LATTICE_NLS(double)
LATTICE_NLS(long double)

}  // namespace lattice
