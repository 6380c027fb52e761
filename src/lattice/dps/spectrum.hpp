#pragma once
/**
# Small motions about a stationary DpS state

Is a stationary state $v_n = u_n e^{i\mu t}$ (stationary.hpp) stable? We write a perturbation of it as
$v_n = e^{i\mu t}(u_n + x_n + iy_n)$. The force of a contact, $z|z|^{1/2}$, changes with
$z = d_n = u_{n+1}-u_n$ at the rate $\frac32|d_n|^{1/2}$ along $d_n$, which is real, and at the rate
$|d_n|^{1/2}$ across it. With the gradient $(\nabla x)_n = x_{n+1}-x_n$ both follow from one matrix,
$$M = \nabla^T\,\mathrm{diag}\,|d_n|^{1/2}\,\nabla, \qquad
  \dot x = L_-y,\quad \dot y = -L_+x, \qquad L_- = \mu - M,\quad L_+ = \mu - \tfrac32M.$$
Each eigenvector of $M$, with eigenvalue $m$, therefore moves independently, like $e^{\lambda t}$ with
$$\lambda^2 = -(\mu-m)(\mu-\tfrac32m).$$
Eq. (14) says $Mu = \mu u$. If the sign of every second entry is changed, $M$ has no negative entry and $u$
is a positive vector, so that by the Perron–Frobenius theorem $m_1 = \mu$ is simple and the largest:
$0 \le m < \mu$ for all others. Hence a state is unstable if and only if the second eigenvalue exceeds
$2\mu/3$, and then with one real pair $\pm\lambda$ for each such $m$. Far out, where contacts are slack,
$m = 0$ and $\lambda = \pm i\mu$: the essential spectrum. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>
#include "lattice/dps/dps.hpp"
#include "lattice/dps/stationary.hpp"
#include "lattice/numbers/estimate.hpp"

namespace lattice {

/// |d_n|^{1/2} of every contact, `sites - 1` of them, from the strains of the right half.
template <class T>
std::vector<T> contact_roots(const Stationary<T>& state) {
  using std::abs;
  using std::sqrt;
  const std::size_t sites = state.u.size();
  std::vector<T> roots(sites - 1, T(0));
  for (std::size_t i = 0; i + 1 < sites; ++i) {
    const long n = site_number(i, sites);  // the contact of n and n + 1, or its mirror image
    const long mirror = state.centre == Centre::bond ? -n : -1 - n;
    const auto k = std::size_t(n < 0 ? mirror : n);
    if (k < state.strain.size()) roots[i] = sqrt(abs(state.strain[k]));
  }
  return roots;
}

/**
## The spectrum of M

The matrix $M$ is symmetric and tridiagonal, so its eigenvalues are found to a rounding error of the
largest, in any precision. The invariance under a change of phase, $v \to e^{i\varphi}v$, which gives the
full problem a defective double eigenvalue $\lambda = 0$, is here the simple eigenvalue $m_1 = \mu$. */
template <class T>
struct ContactSpectrum {
  T mu;
  std::vector<T> m;    ///< from the largest on; m[0] is known to be mu and set to it
  T phase_defect{0};   ///< computed m[0] minus mu
  Vector<T> second{};  ///< unit eigenvector of m[1], if asked for
};

/// Diagonal of M and the line beside it: each contact stiffens its two sites and couples them.
template <class T>
auto contact_matrix(const std::vector<T>& roots) {
  const auto contacts = Eigen::Index(roots.size());
  Vector<T> diagonal(contacts + 1), beside(contacts);
  diagonal.setZero();
  for (Eigen::Index i = 0; i < contacts; ++i) {
    const T& root = roots[std::size_t(i)];
    diagonal(i) += root;
    diagonal(i + 1) += root;
    beside(i) = -root;
  }
  return std::pair(diagonal, beside);
}

/**
Since $m_1 = \mu$ is known beforehand, the computed value checks state and solver at once. We keep its
defect and put $\mu$ itself in its place, so that the exponent of the phase is exactly zero. */
/// Throws std::runtime_error if Eigen's iteration does not converge.
template <class T>
ContactSpectrum<T> contact_spectrum(const Stationary<T>& state, bool vector = false) {
  const auto [diagonal, beside] = contact_matrix(contact_roots(state));
  const auto sites = Eigen::Index(state.u.size());
  Eigen::SelfAdjointEigenSolver<Matrix<T>> solver;
  solver.computeFromTridiagonal(diagonal, beside,
                                vector ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of the contact matrix did not converge");
  ContactSpectrum<T> out{state.mu, {}};
  for (Eigen::Index i = sites; i-- > 0;) out.m.push_back(solver.eigenvalues()(i));
  out.phase_defect = out.m[0] - state.mu;
  out.m[0] = state.mu;
  if (vector) out.second = solver.eigenvectors().col(sites - 2);
  return out;
}

/**
Eigenvalues can also be counted. By Sylvester's law of inertia as many are larger than $x$ as there are
positive pivots in the elimination of $M-x$, one per site, which works in any number type; halving an
interval then finds a single eigenvalue to the last digit. The count at $x = \frac23\mu$ is the verdict
itself: one for a stable state, $1+k$ for one with $k$ real pairs. */
template <class T>
std::size_t eigenvalues_above(const std::vector<T>& roots, const T& x) {
  std::size_t count = 0;
  T pivot(1), left(0);
  for (std::size_t i = 0; i <= roots.size(); ++i) {
    const T right = i < roots.size() ? roots[i] : T(0);
    pivot = left + right - x - left * left / pivot;
    if (pivot == T(0)) pivot = std::numeric_limits<T>::epsilon() * (-x);
    count += pivot > T(0);
    left = right;
  }
  return count;
}

/**
The interval is halved until no number of the format is left inside it, whatever the format. So no
tolerance has to be chosen, and the error is one rounding. */
/// The k-th largest eigenvalue of M, k >= 1, between 0 and 2 mu, by halving.
template <class T>
T counted_eigenvalue(const Stationary<T>& state, std::size_t k) {
  const auto roots = contact_roots(state);
  T low(0), high = T(2) * state.mu;
  for (;;) {
    const T middle = (low + high) / T(2);
    if (!(low < middle) || !(middle < high)) return middle;
    (eigenvalues_above(roots, middle) >= k ? low : high) = middle;
  }
}

/**
Near $m = 2\mu/3$ the square $\lambda^2$ is small, and its factor $m-2\mu/3$ is the one quantity
that loses digits: an error $\delta$ of $m$ changes $\lambda^2$ by about $\mu\delta/2$. */
template <class T>
T lambda_squared(const T& mu, const T& m) {
  return (mu - m) * (T(3) * m - T(2) * mu) / T(2);
}

/// |lambda|, a rate where lambda^2 > 0 and a frequency where it is < 0.
template <class T>
T lambda_modulus(const T& mu, const T& m) {
  using std::abs;
  using std::sqrt;
  return sqrt(abs(lambda_squared(mu, m)));
}

/// m - 2 mu / 3: for the second eigenvalue, unstable if and only if positive.
template <class T>
T instability_margin(const T& mu, const T& m) {
  return (T(3) * m - T(2) * mu) / T(3);
}

/**
Since $m$ and $\lambda^2$ are real, an exponent is either real or imaginary, and its other part is exactly
zero: a spectrum from $M$ cannot show a small growth that comes from rounding. */
/// Both exponents of each m, two per site, as (real, imaginary): lambda, then -lambda.
template <class T>
std::vector<std::pair<T, T>> exponents(const ContactSpectrum<T>& spectrum) {
  std::vector<std::pair<T, T>> out;
  for (const T& m : spectrum.m) {
    const T size = lambda_modulus(spectrum.mu, m);
    const bool real = lambda_squared(spectrum.mu, m) > T(0);
    for (int sign : {1, -1})
      out.emplace_back(real ? T(sign) * size : T(0), real ? T(0) : T(sign) * size + T(0));
  }
  return out;
}

/**
## How close to the edge

The verdict is a sign, so it is worth nothing without an error. Two things could turn it: rounding, and the
ends of the chain. We vary both, the precision from double to `Fine` and the length by ten sites, and add
the two changes. */
/// The margin (m_2 - 2 mu / 3) / mu and |lambda| / mu.
struct Margin {
  Estimate margin, exponent;
  /// The margin with its error a hundredfold, by which a verdict must stay clear of the edge.
  Estimate safe() const { return {margin.value, 100 * margin.error}; }
};

/// (m_2 - 2 mu / 3) / mu and |lambda| / mu, computed with numbers of type T.
template <class T>
std::pair<double, double> margin_and_exponent(Centre centre, double mu, std::size_t sites) {
  const auto state = stationary<T>(centre, T(mu), sites);
  const T m = counted_eigenvalue(state, 2);
  return {static_cast<double>(T(instability_margin(state.mu, m) / state.mu)),
          static_cast<double>(T(lambda_modulus(state.mu, m) / state.mu))};
}

/**
Divided by $\mu$ both numbers are free of its scale, so margins at different frequencies may be compared
digit by digit. */
template <class Fine>
Margin margin_of(Centre centre, double mu, std::size_t sites) {
  const auto [margin, exponent] = margin_and_exponent<Fine>(centre, mu, sites);
  const auto [short_margin, short_exponent] = margin_and_exponent<double>(centre, mu, sites);
  const auto [long_margin, long_exponent] = margin_and_exponent<Fine>(centre, mu, sites + 10);
  Margin out{compare(short_margin, margin), compare(short_exponent, exponent)};
  out.margin.error += std::abs(margin - long_margin);
  out.exponent.error += std::abs(exponent - long_exponent);
  return out;
}

/**
## The full matrix

The article writes the perturbation as $a_ne^{\lambda t}+b_n^*e^{\lambda^*t}$, Eq. (22), and finds the
exponents from a full matrix of $2N$ rows; with our $x+iy = a+b^*$ at $t = 0$ this is
$$i\lambda\begin{pmatrix}a\\b\end{pmatrix} =
  \begin{pmatrix}\mu-\frac54M & -\frac14M\\ \frac14M & -\mu+\frac54M\end{pmatrix}
  \begin{pmatrix}a\\b\end{pmatrix},$$
because $\delta(z|z|^{1/2}) = |z|^{1/2}(\frac54\delta z+\frac14\delta z^*)$ for real $z$. We keep it as a
check: its entries come from the displacements, and nothing of its structure is used. */
template <class T>
auto full_matrix(const Stationary<T>& state) {
  using std::abs;
  using std::sqrt;
  const auto sites = Eigen::Index(state.u.size());
  Matrix<T> full(2 * sites, 2 * sites);
  full.setZero();
  const auto add = [&](Eigen::Index i, Eigen::Index k, const T& value) {
    full(i, k) -= T(1.25) * value;
    full(i, sites + k) -= T(0.25) * value;
    full(sites + i, k) += T(0.25) * value;
    full(sites + i, sites + k) += T(1.25) * value;
  };
  for (Eigen::Index i = 0; i < sites; ++i) {
    full(i, i) += state.mu;
    full(sites + i, sites + i) -= state.mu;
    if (i + 1 == sites) break;
    const T slope = sqrt(abs(state.u[std::size_t(i) + 1] - state.u[std::size_t(i)]));
    add(i, i, slope);
    add(i + 1, i + 1, slope);
    add(i, i + 1, -slope);
    add(i + 1, i, -slope);
  }
  return full;
}

/**
The eigenvalues $\kappa$ of this matrix are $i\lambda$. A solver for matrices without symmetry returns
them in no particular order and with both parts rounded, which is why it serves as a check and not as the
method. Throws std::runtime_error if it does not converge. */
template <class T>
std::vector<std::complex<T>> full_exponents(const Stationary<T>& state) {
  std::vector<std::complex<T>> out;
  for (const std::complex<T>& kappa : eigenvalues_of(full_matrix(state)))
    out.emplace_back(kappa.imag(), -kappa.real());
  return out;
}

/**
The pair nearest to zero, after the two zeros of the phase, is the pinning pair. The difference of the two
routes to it, including the part that should vanish, shows how well they agree; and the computed zeros of
the phase show how large a real part has to be before it means anything. */
struct Remainders {
  double pair, zero;
};

/// Remainders of the full matrix of `state`.
template <class T>
Remainders remainders(const Stationary<T>& state) {
  using std::abs;
  auto full = full_exponents(state);
  std::sort(full.begin(), full.end(),
            [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); });
  const T m = contact_spectrum(state).m[1], pair = lambda_modulus(state.mu, m);
  const bool real = lambda_squared(state.mu, m) > T(0);
  const T found = abs(real ? full[2].real() : full[2].imag());
  const T wrong = abs(real ? full[2].imag() : full[2].real());
  return {double(abs(found - pair) + wrong), double(abs(full[1]))};
}

/**
## The pinning pair

The second eigenvector $V$ of $M$ looks like the derivative of the breather along the chain, around a bond
as around a site: added to the field it shifts the breather, and $iV$ pushes it. In the coordinates
$x = V\cdot\mathrm{Re}\,w$ and $y = V\cdot\mathrm{Im}\,w$ a perturbation $w$ moves like a pendulum near one
of its rest positions, $\dot x = (\mu-m)y$, $\dot y = \frac32(m-\frac23\mu)x$. If the rest position is
unstable, the growing direction is $y = \lambda x/(\mu-m)$ and the decaying one has the other sign. The
growing share of a perturbation is then $\frac12(x + (\mu-m)y/\lambda)$: a push counts $(\mu-m)/\lambda$
times as much as a shift of the same size. */
struct PinningPair {
  Eigen::VectorXd V;
  double mu, m, rate;  ///< rate: |lambda|
  double push;         ///< (mu - m) / |lambda|

  explicit PinningPair(const ContactSpectrum<double>& spectrum)
      : V(spectrum.second),
        mu(spectrum.mu),
        m(spectrum.m[1]),
        rate(lambda_modulus(mu, m)),
        push((mu - m) / rate) {}

  /**
  A perturbation is given as a field, but its effect depends on $x$ and $y$. The projection is exact, since
  $V$ has unit length and the eigenvectors of $M$ are orthogonal. */
  /// (x, y) of the perturbation `w`.
  std::complex<double> of(const Field& w) const {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i) sum += V(Eigen::Index(i)) * w[i];
    return sum;
  }
  /// Share of the growing direction, measured by the x that belongs to it.
  double growing(const Field& w) const {
    const auto xy = of(w);
    return (xy.real() + push * xy.imag()) / 2;
  }
  /// Adds z V to `w`: the real part shifts, the imaginary part pushes.
  void add(std::complex<double> z, Field& w) const {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] += z * V(Eigen::Index(i));
  }
};

}  // namespace lattice
