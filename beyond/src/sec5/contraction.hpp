#pragma once
/**
# A zero close to a guess

All enclosures of this section end in one lemma. Let $F$ be continuously differentiable on a Banach space,
$c$ a guess, $A$ a linear map, and let the ball $|x-c| \le \rho$ be such that
$$|AF(c)| \le \eta, \qquad \|1-A\,DF(x)\| \le q \text{ for all $x$ in the ball}, \qquad q < 1, \qquad
  \eta+q\rho \le \rho.$$ Then $x \mapsto x-AF(x)$ maps the ball into itself and contracts it, and there is exactly one
  fixed point in the ball. That is a zero of $F$ if $A$ is injective. Our $A$ is the identity plus a map of finite rank,
  hence injective as soon as it is surjective, and it is surjective because $A\,DF(c)$ is invertible, $q$ being less
  than one.

Both conditions are needed. Without $q < 1$ the identity would pass with $\eta = 0$, and has no single fixed
point; with $\eta = 0$ put in by mistake $x \mapsto \frac12x+10$ would have a fixed point near zero. Since
$\eta+q\rho$ is rounded upwards, $q < 1$ follows from the other condition here; it is demanded, and tested, on its own
all the same. */

#include <stdexcept>
#include <utility>

#include "sec5/interval.hpp"

namespace lattice {

/// What the lemma needs to know; all are upper bounds, and the radius is exact.
struct Contraction {
  double eta = std::numeric_limits<double>::infinity();  ///< how far the map moves the centre
  double q = std::numeric_limits<double>::infinity();    ///< by what factor it shrinks distances
  double radius = 0;

  /// The map shrinks distances in the ball.
  bool contracts() const { return q >= 0 && q < 1; }
  /// The map does not leave the ball.
  bool stays_inside() const {
    const Interval<double> image = Interval<double>(eta) + Interval<double>(q) * radius;
    return eta >= 0 && radius > 0 && image.upper <= radius;
  }
  /// The hypotheses of the lemma.
  bool holds() const { return contracts() && stays_inside(); }
};

/**
The same guess is used with two balls. The largest one that passes says where there is *no other* solution,
a small one where the solution *is*. We look for the first by halving a radius, and take for the second
$\eta/(1-q)$, a little enlarged, with a $q$ that becomes smaller with the ball; if it fails, nothing is
claimed. */
struct NotProved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Ball of uniqueness and ball of existence, from eta and a bound q(radius). Throws NotProved.
template <class Bound>
std::pair<Contraction, Contraction> two_balls(double eta, double largest, Bound q) {
  Contraction unique{eta, q(largest), largest};
  for (int halvings = 0; !unique.holds(); ++halvings) {
    if (halvings == 60) throw NotProved("no ball is found on which the map contracts");
    const double radius = unique.radius / 2;
    unique = {eta, q(radius), radius};
  }
  Contraction exists = unique;
  for (int i = 0; i < 3; ++i) {
    const Interval<double> enough =
        Interval<double>(eta) * 1.0009765625 / (Interval<double>(1) - exists.q);
    const double radius = std::min(exists.radius, enough.upper);
    exists = {eta, q(radius), radius};
  }
  if (!exists.holds()) throw NotProved("no ball is found that the map leaves invariant");
  return {unique, exists};
}

/**
## When the unknown is a function of time

For the chain and for the kernel equation $DF(d) = 1-B_d$ with an integral operator $B_d$, and $A$ is made in the same
way. On nodes, functions are replaced by broken lines, an operation $\Pi$ of norm one. Let $B$ be $B_c$ with a stiffness
that is constant on small cells and zero behind a window, $N$ the values at the nodes, $E$ the broken line through
values, $\mathfrak B = NBE$, and $C$ a matrix, an approximate inverse of $1-\mathfrak B$. We take
$$A = 1+ECNB, \qquad
  1-A(1-B) = (1-\Pi)B+E[1-C(1-\mathfrak B)]NB+ECNB(1-\Pi)B,$$ an identity. All its terms are small. With $\|(1-\Pi)B\|
  \le \epsilon$, a bound from $(Bv)''$ and the distance of the nodes, $\|1-C(1-\mathfrak B)\| \le \delta$ and $\|CNB\|
  \le \beta$, and for any $d$ in the ball,
$$\|1-A\,DF(d)\| \le (1+\beta)(\epsilon+\|B_d-B\|)+\delta\|B\|$$
in the window. Behind it $A$ is the identity, and what is left of $B_d$ there has to contract by itself. */
struct ApproximateInverse {
  double beta = 0;     ///< at least |A| - 1
  double delta = 0;    ///< at least |1 - C (1 - B)| for the matrix
  double epsilon = 0;  ///< at least what broken lines miss of B
  double norm = 0;     ///< at least |B|

  /// |A F(c)| in the supremum norm, from |F(c)| inside the window and behind it.
  double eta(double inside, double behind) const {
    return std::max(((Interval<double>(1) + beta) * inside).upper, behind);
  }
  /// |1 - A DF(d)|, from |B_d - B| inside the window and the norm of B_d behind it.
  double q(double change, double behind) const {
    const Interval<double> inside =
        (Interval<double>(1) + beta) * (Interval<double>(epsilon) + change) +
        Interval<double>(delta) * norm;
    return std::max(inside.upper, behind);
  }
};

/// A solution that is a function of time: its balls, and the constants of the proof.
struct Enclosure {
  Contraction unique, exists;
  ApproximateInverse inverse;
  double residual;  ///< of the guess, in the supremum norm
};

}  // namespace lattice
