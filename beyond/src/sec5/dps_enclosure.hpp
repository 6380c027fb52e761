#pragma once
/**
# The DpS breathers, enclosed

The stationary DpS equation at $\mu = 1$ has strains of alternating signs. With $u_{n+1}-u_n = \pm(-1)^nr_n$ and
$\varphi(x) = x|x|^{1/2}$ it becomes
$$F(r)_n = r_n - [\varphi(r_{n-1}) + 2\varphi(r_n) + \varphi(r_{n+1})] = 0,$$
for bounded sequences, and conversely every bounded zero of $F$ gives a solution,
$|u_n| = \varphi(r_{n-1})+\varphi(r_n)$ with alternating signs. Contact $n$ lies between the sites $n$ and $n+1$.
Around a bond $r_{-n} = r_n$, around a site $r_{-1-n} = r_n$, so that the contacts $n \ge 0$ suffice. The map $F$ is
continuously differentiable on $\ell^\infty$, since $\varphi' = \frac32|x|^{1/2}$ is continuous. It has no second
derivative at zero, and none is used.

The ball of the lemma in contraction.hpp has one radius in all contacts. In a window of `contacts` contacts
$A$ is an approximate inverse of the derivative, outside it is the identity. There the map reads
$K(r)_n = \varphi(r_{n-1})+2\varphi(r_n)+\varphi(r_{n+1})$ and contracts as soon as $6\sqrt{r} < 1$. */

#include <vector>

#include "lattice/model/sites.hpp"
#include "sec5/contraction.hpp"

namespace lattice {

/// Contacts of the half chain that are enclosed one by one.
inline constexpr std::size_t dps_contacts = 12;

/**
The guess and the inverse may come from anywhere. The proof needs two numbers: how far the map moves the guess, and
the largest row sum of $|1-A\,DF|$ over the ball. */
/// A guess and the approximate inverse of F's derivative at it; nothing in it is trusted.
template <class T>
struct DpsGuess {
  Centre centre;
  std::vector<T> r;                     ///< strains, from the centre outwards
  std::vector<std::vector<T>> inverse;  ///< of the derivative, in the window
};

/// The breather of the DpS equation with mu = 1, found in ordinary arithmetic (stationary.hpp).
template <class T>
DpsGuess<T> dps_guess(Centre centre);

/// |A F(c)| for the guess c, in the supremum norm.
template <class T>
T dps_eta(const DpsGuess<T>& guess);

/// Largest row sum of |1 - A DF(r)| over the ball around the guess, tail included.
template <class T>
T dps_q(const DpsGuess<T>& guess, T radius);

/**
The ball leaves open what sign the small strains have. Let $r_m$ be certainly positive, let
$|r_n| < \frac1{16}$ for all $n > m$, and let $-z$ be the infimum of these. If $z$ were positive, the
equation would give $r_n \ge -4\varphi(z)$ for all of them, hence $z \le 4z^{3/2} < z$. So they are not
negative, and by the equation positive one after the other.

A solution in the ball is a fixed point of $x \mapsto x-AF(x)$, and each of its components lies in the interval
that this map makes of the ball, in the form of the mean value; repeated, that gives the last digits. A mean
value is taken on the way from the guess to the solution, so the boxes have to hold both, as those of both
breathers do. The tail shrinks as $r_n^{3/2} \le r_{n+1} \le r_n^{3/2}/(1-3\sqrt{r_{n+1}})$: the left inequality
holds because all terms are positive, the right one because the profile decreases. That it does is read from the
intervals in the window. Beyond, let $r_n$ be the largest strain from $n$ on. Then $M = \sup_{m>n}r_m$ obeys $M
\le r_n^{3/2}+3M^{3/2}$ and $\sup_{m>n+1}r_m \le M^{3/2}/(1-3\sqrt M) < r_n^{3/2} \le r_{n+1}$ if $M$ is less
than $1/100$, so that $r_{n+1}$ is the largest from $n+1$ on. */
template <class T>
struct DpsBreather {
  Centre centre;
  Contraction<T> unique, exists;
  std::vector<Interval<T>> r;  ///< strains of the contacts 0, 1, ...
  Interval<T> tail;            ///< holds all strains behind them

  /// |u_n| at the site where it is largest.
  Interval<T> largest() const;
  /// The norm sum u_n^2, which the equation makes equal to sum r_n^(5/2).
  Interval<T> norm() const;
};

/// Clips all strains at zero where the equation allows it: behind a contact that is certainly positive, where strains
/// are less than 1/16. Throws NotProved where they are not.
template <class T>
void demand_no_negative(DpsBreather<T>& b);

/// The bounds of the strains in words: positive and decreasing, and the tail below 1/100. Throws NotProved otherwise.
template <class T>
void demand_decrease(const DpsBreather<T>& b);

/// The breather with this centre. Throws NotProved if the hypotheses of the lemma cannot be verified.
template <class T>
DpsBreather<T> enclose_dps(Centre centre);

/**
## Stability

Small perturbations of the breather have the exponents $\lambda^2 = -(1-m)(1-\frac32m)$, $m$ in the spectrum
of the contact matrix $M$ (spectrum.hpp), which is a compact operator on $\ell^2$. With alternating signs its
entries are nonnegative and $u$ is a positive eigenvector for $m = 1$, hence $m_1 = 1$ is simple
and the largest (Perron and Frobenius). If the strains behind the window are put to zero, $M$ loses a positive
operator of norm at most $4\sqrt{r}$, and by Weyl's inequality no eigenvalue rises and none falls by more. */
/// The k-th largest eigenvalue of M on the infinite chain.
template <class T>
Interval<T> contact_eigenvalue(const DpsBreather<T>& breather, std::size_t k);

/// lambda^2 with its sign, for an eigenvalue m.
template <class T>
Interval<T> square_of_exponent(const Interval<T>& m);

/**
## Energies

At other frequencies $u$ scales as $\mu^2$, so $N = \mu^4N_1$ for the norm and, as the contact sum is $\mu N$,
$H = \frac25\mu N = \frac25N_1^{-1/4}N^{5/4}$ for the energy. Of both breathers at $\mu = 1$ the difference is
$\frac25(N_{site}-N_{bond})$. At equal norm, that of the bond-centred one at $\mu = 1$, it is
$\frac25N_{bond}[(N_{bond}/N_{site})^{1/4}-1]$, of the opposite sign. */
template <class T>
struct DpsBarrier {
  Interval<T> equal_mu, equal_norm;  ///< H_site - H_bond
};
/// Both differences, for the breathers at mu = 1.
template <class T>
DpsBarrier<T> dps_barrier(const DpsBreather<T>& site, const DpsBreather<T>& bond);

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
template <class T>
bool turns_back(Centre centre, const Interval<T>& r_0);

/// What became of an interval of r_0: discarded or decided at a contact, or open.
enum class Decision { discarded, inside, open };

/// An interval of r_0 and what became of it.
template <class T>
struct Piece {
  Interval<T> r_0;
  Decision decision;
  std::size_t contact;
};

/// The range of r_0 in pieces, from the smallest on, each from at most `depth` halvings. There is no other profile
/// if none is open.
template <class T>
std::vector<Piece<T>> search_profiles(const DpsBreather<T>& breather, int depth = 30);

}  // namespace lattice
