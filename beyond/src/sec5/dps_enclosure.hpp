#pragma once
/**
# Strains of the DpS breathers in intervals

The stationary DpS equation at $\mu = 1$ for strains of alternating signs is $F(r) = 0$ (chapter on bounds). This file
has $F$ and its derivative in intervals, a guess, and what follows from strains that are enclosed: stability, energies,
and the search for other profiles. The proof itself stands in the chapter. */

#include <vector>

#include "lattice/model/sites.hpp"
#include "sec5/contraction.hpp"

namespace lattice {

/// Contacts of the half chain that are enclosed one by one.
inline constexpr std::size_t dps_contacts = 12;

/// A guess and the approximate inverse of F's derivative at it; nothing in it is trusted.
struct DpsGuess {
  Centre centre;
  std::vector<double> r;                     ///< strains, from the centre outwards
  std::vector<std::vector<double>> inverse;  ///< of the derivative, in the window
};

/// The breather of the DpS equation with mu = 1, found in ordinary arithmetic (stationary.hpp).
DpsGuess dps_guess(Centre centre);

/// The strains of the ball of this radius around the guess.
std::vector<Interval<double>> ball(const DpsGuess& guess, double radius);
/// phi(x) = x |x|^(1/2).
Interval<double> phi(const Interval<double>& x);
/// phi'(x).
Interval<double> phi_slope(const Interval<double>& x);
/// phi(r_(n-1)) + 2 phi(r_n) + phi(r_(n+1)), `after` being the strain behind the last.
Interval<double> pull(Centre centre, const std::vector<Interval<double>>& r, std::size_t n,
                      const Interval<double>& after);
/// DF on the window, from strains; the neighbour behind the window is left out.
std::vector<std::vector<Interval<double>>> dps_derivative(Centre centre,
                                                          const std::vector<Interval<double>>& r);

/// A breather whose strains are enclosed.
struct DpsBreather {
  Centre centre;
  Contraction unique, exists;
  std::vector<Interval<double>> r;  ///< strains of the contacts 0, 1, ...
  Interval<double> tail;            ///< holds all strains behind them

  /// |u_n| at the site where it is largest.
  Interval<double> largest() const;
  /// The norm sum u_n^2, which the equation makes equal to sum r_n^(5/2).
  Interval<double> norm() const;
};

/**
## Stability

Small perturbations of the breather have the exponents $\lambda^2 = -(1-m)(1-\frac32m)$, $m$ in the spectrum
of the contact matrix $M$ (spectrum.hpp), which is a compact operator on $\ell^2$. With alternating signs its
entries are nonnegative and $u$ is a positive eigenvector for $m = 1$, hence $m_1 = 1$ is simple
and the largest (Perron and Frobenius). If the strains behind the window are put to zero, $M$ loses a positive
operator of norm at most $4\sqrt{r}$, and by Weyl's inequality no eigenvalue rises and none falls by more. */
/// The k-th largest eigenvalue of M on the infinite chain.
Interval<double> contact_eigenvalue(const DpsBreather& breather, std::size_t k);

/// lambda^2 with its sign, for an eigenvalue m.
Interval<double> square_of_exponent(const Interval<double>& m);

/**
## Energies

At other frequencies $u$ scales as $\mu^2$, so $N = \mu^4N_1$ for the norm and, as the contact sum is $\mu N$,
$H = \frac25\mu N = \frac25N_1^{-1/4}N^{5/4}$ for the energy. Of both breathers at $\mu = 1$ the difference is
$\frac25(N_{site}-N_{bond})$. At equal norm, that of the bond-centred one at $\mu = 1$, it is
$\frac25N_{bond}[(N_{bond}/N_{site})^{1/4}-1]$, of the opposite sign. */
struct DpsBarrier {
  Interval<double> equal_mu, equal_norm;  ///< H_site - H_bond
};
/// Both differences, for the breathers at mu = 1.
DpsBarrier dps_barrier(const DpsBreather& site, const DpsBreather& bond);

/**
## No other profile

A nonnegative symmetric profile that tends to zero, does not increase outwards and is not zero everywhere is
fixed by $r_0$. The equation of the central contact gives $\varphi(r_1)$, the next one $\varphi(r_2)$, and
so on; positivity and monotony require $\varphi(r_n) \le r_{n+1} \le r_n$. At the centre they leave
$\frac1{16} \le r_0 \le \frac14$. We cut this range into intervals and follow each outwards. It is discarded
where the requirements fail, it is done where its profiles lie in the ball of uniqueness, and it is halved
otherwise.

One profile would never be decided: the constant one, $r_n = \frac1{16}$, which solves the equation and does
not tend to zero. Close to it the forces $P_n = \varphi(r_n)$ differ from $\frac1{64}$ by $y_n$ with
$y_{n+1} = (g-2)y_n-y_{n-1}$, where $g$ is a slope of $P^{2/3}$, about $\frac83$. These deviations rotate by
some seventy degrees from contact to contact, so the profile increases again before it has left, or is
constant. */
/// Whether a profile with this r_0 > 1/16 certainly increases somewhere before it has left the constant one.
bool turns_back(Centre centre, const Interval<double>& r_0);

/// What became of an interval of r_0: discarded or decided at a contact, or open.
enum class Decision { discarded, inside, open };

/// An interval of r_0 and what became of it.
struct Piece {
  Interval<double> r_0;
  Decision decision;
  std::size_t contact;
};

/// The range of r_0 in pieces, from the smallest on, each from at most `depth` halvings. There is no other profile
/// if none is open.
std::vector<Piece> search_profiles(const DpsBreather& breather, int depth = 30);

}  // namespace lattice
