#include "sec4/nls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lattice {

// The detour through the second harmonic, then the cubic parts of contact and well
template <class T>
T nls_beta(T q, const ContactSeries<T>& v, T s) {
  using std::sin;
  const T half = sin(q / T(2)), x = T(4) * half * half * half * half;  // (1 - cos q)^2
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

// Phi is positive at q = 0 if beta is negative there, and changes its sign at each zero of omega_2 and of beta
template <class T>
std::vector<Wavenumbers<T>> unstable_wavenumbers(T d, T s) {
  using std::asin, std::sqrt;
  const T root = sqrt(d), b = T(2) * s * d * root - T(1) / (T(4) * root);
  const auto positive = [&](T x) { return x * x * (x * (T(1) - x) + b) + s * d > T(0); };
  // The polynomial is monotone between these places
  std::vector<T> places{T(0)};
  if (const T square = T(9) + T(32) * b; square > T(0)) {
    const T top = (T(3) + sqrt(square)) / T(8);
    for (T x : {-b / (T(2) * top), top})
      if (x > T(0) && x < T(2)) places.push_back(x);
  }
  places.push_back(T(2));
  std::vector<T> zeros{T(2) / (T(1) + sqrt(T(1) + T(6) * root))};  // that of omega_2
  for (std::size_t k = 1; k < places.size(); ++k) {
    T low = places[k - 1], high = places[k], middle;
    const bool before = positive(low);
    if (positive(high) == before) continue;
    while ((middle = low + (high - low) / T(2)) > low && middle < high)
      (positive(middle) == before ? low : high) = middle;
    zeros.push_back(middle);
  }
  std::sort(zeros.begin(), zeros.end());
  // From one zero to the next
  std::vector<Wavenumbers<T>> out;
  bool inside = !positive(T(0));
  if (inside) out.push_back({T(0), std::numbers::pi_v<T>});
  for (T x : zeros) {
    const T q = T(2) * asin(sqrt(x / T(2)));
    inside = !inside;
    if (inside)
      out.push_back({q, std::numbers::pi_v<T>});
    else
      out.back().to = q;
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
  template std::vector<Wavenumbers<T>> unstable_wavenumbers(T, T);

LATTICE_NLS(double)
LATTICE_NLS(long double)

}  // namespace lattice
