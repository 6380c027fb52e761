#include "lattice/standing/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <stdexcept>

#include "lattice/model/contact.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/quadruple/quadruple.hpp"

namespace lattice {

// A state is symmetric, so the strains of its right half give all contacts
template <class T>
std::vector<T> contact_roots(const Stationary<T>& state) {
  const std::size_t sites = state.u.size();
  std::vector<T> roots(sites - 1, T(0));
  for (std::size_t i = 0; i + 1 < sites; ++i) {
    const long n = site_number(i, sites);  // the contact of n and n + 1, or its mirror image
    const long mirror = state.centre == Centre::bond ? -n : -1 - n;
    const auto k = std::size_t(n < 0 ? mirror : n);
    if (k < state.strain.size()) roots[i] = secant_stiffness(state.strain[k], state.exponent);
  }
  return roots;
}

// All eigenvalues of the tridiagonal M, from the largest on
template <class T>
ContactSpectrum<T> contact_spectrum(const Stationary<T>& state) {
  const std::vector<T> roots = contact_roots(state);
  const auto sites = Eigen::Index(state.u.size());
  // Each contact stiffens its two sites and couples them
  const Eigen::Map<const Vector<T>> stiff(roots.data(), sites - 1);
  Vector<T> diagonal = Vector<T>::Zero(sites), beside = -stiff;
  diagonal.head(sites - 1) += stiff;
  diagonal.tail(sites - 1) += stiff;
  Eigen::SelfAdjointEigenSolver<Matrix<T>> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::ComputeEigenvectors);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of the contact matrix did not converge");
  // The largest must be mu: keep by how much the solver misses it, and put mu itself in its place
  ContactSpectrum<T> out{state.mu, {}, state.exponent};
  for (Eigen::Index i = sites; i-- > 0;) out.m.push_back(solver.eigenvalues()(i));
  out.phase_residual = out.m[0] - state.mu;
  out.m[0] = state.mu;
  out.second = solver.eigenvectors().col(sites - 2);
  return out;
}

// Eliminate M - x from site to site and count the positive pivots
template <class T>
std::size_t eigenvalues_above(const std::vector<T>& roots, const T& x) {
  std::size_t count = 0;
  T pivot(1), left(0);
  for (std::size_t i = 0; i <= roots.size(); ++i) {
    const T right = i < roots.size() ? roots[i] : T(0);
    pivot = left + right - x - left * left / pivot;
    // A pivot that vanishes counts as negative, by a rounding error of x
    if (pivot == T(0)) pivot = std::numeric_limits<T>::epsilon() * (-x);
    count += pivot > T(0);
    left = right;
  }
  return count;
}

// Halve the interval until it holds no further number of the format
template <class T>
T counted_eigenvalue(const Stationary<T>& state, std::size_t k) {
  const auto roots = contact_roots(state);
  T low(0), high = T(2) * state.mu;
  for (;;) {
    T middle = (low + high) / T(2);
    if (!(low < middle) || !(middle < high)) return middle;
    (eigenvalues_above(roots, middle) >= k ? low : high) = middle;
  }
}

template <class T>
std::vector<std::pair<T, T>> exponents(const ContactSpectrum<T>& spectrum) {
  std::vector<std::pair<T, T>> out;
  for (const T& m : spectrum.m) {
    const T size = lambda_modulus(spectrum.mu, m, spectrum.exponent);
    const bool real = lambda_squared(spectrum.mu, m, spectrum.exponent) > T(0);
    for (int sign : {1, -1})
      out.emplace_back(real ? T(sign) * size : T(0), real ? T(0) : T(sign) * size + T(0));
  }
  return out;
}

/// (m_2 - mu / alpha) / mu and |lambda| / mu, computed with numbers of type T.
template <class T>
static std::pair<double, double> margin_and_exponent(Centre centre, double mu, std::size_t sites,
                                                     double alpha) {
  const auto state = stationary<T>(centre, T(mu), sites, alpha);
  const T m = counted_eigenvalue(state, 2);
  return {static_cast<double>(T(instability_margin(state.mu, m, alpha) / state.mu)),
          static_cast<double>(T(lambda_modulus(state.mu, m, alpha) / state.mu))};
}

// The error of a margin: its change with the precision plus its change with ten more sites
template <class Fine>
Margin margin_of(Centre centre, double mu, std::size_t sites, double alpha) {
  const auto [margin, exponent] = margin_and_exponent<Fine>(centre, mu, sites, alpha);
  const auto [short_margin, short_exponent] = margin_and_exponent<double>(centre, mu, sites, alpha);
  const auto [long_margin, long_exponent] =
      margin_and_exponent<Fine>(centre, mu, sites + 10, alpha);
  Margin out{with_error(short_margin, margin), with_error(short_exponent, exponent)};
  out.margin.error += std::abs(margin - long_margin);
  out.exponent.error += std::abs(exponent - long_exponent);
  return out;
}

// The plane in which a breather is shifted and pushed along the chain
PinningMode::PinningMode(const ContactSpectrum<double>& spectrum)
    : V(spectrum.second),
      mu(spectrum.mu),
      m(spectrum.m[1]),
      rate(lambda_modulus(mu, m, spectrum.exponent)),
      leverage((mu - m) / rate) {}

std::complex<double> PinningMode::of(const Field& w) const {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < w.size(); ++i) sum += V(Eigen::Index(i)) * w[i];
  return sum;
}

double PinningMode::growing(const Field& w) const {
  const auto xy = of(w);
  return (xy.real() + leverage * xy.imag()) / 2;
}

void PinningMode::add(std::complex<double> z, Field& w) const {
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += z * V(Eigen::Index(i));
}

// The scalars that are used: all eigenvalues in two, a single one in three
#define LATTICE_SPECTRUM(T)                                           \
  template ContactSpectrum<T> contact_spectrum(const Stationary<T>&); \
  template std::vector<std::pair<T, T>> exponents(const ContactSpectrum<T>&);

#define LATTICE_COUNTED(T)                                                 \
  template std::vector<T> contact_roots(const Stationary<T>&);             \
  template std::size_t eigenvalues_above(const std::vector<T>&, const T&); \
  template T counted_eigenvalue(const Stationary<T>&, std::size_t);

LATTICE_SPECTRUM(double)
LATTICE_SPECTRUM(long double)
LATTICE_COUNTED(double)
LATTICE_COUNTED(long double)
LATTICE_COUNTED(Quadruple)
template Margin margin_of<long double>(Centre, double, std::size_t, double);
template Margin margin_of<Quadruple>(Centre, double, std::size_t, double);

}  // namespace lattice
