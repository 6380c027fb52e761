#pragma once
/**
# A zero close to a guess

All enclosures of this section end in one lemma. Let $F$ be continuously differentiable on a Banach space,
$c$ a guess, $A$ a linear map, and let the ball $|x-c| \le r$ be such that
$$|AF(c)| \le \eta, \qquad \|1-A\,DF(x)\| \le q \text{ for all $x$ in the ball}, \qquad q < 1, \qquad
  \eta+qr \le r.$$
Then $K(x) = x-AF(x)$ maps the ball into itself and contracts it, and there is exactly one $x$ in the ball
with $K(x) = x$. That is a zero of $F$ if $A$ is injective. Our $A$ is the identity plus a map of finite rank,
hence injective as soon as it is surjective, and it is surjective because $A\,DF(c)$ is invertible, $q$ being
less than one.

Both conditions are needed. Without $q < 1$ the identity would pass with $\eta = 0$, and has no single fixed
point; with $\eta = 0$ put in by mistake $x \mapsto \frac12x+10$ would have a fixed point near zero. Since
$\eta+qr$ is rounded upwards, $q < 1$ follows from the other condition here; it is demanded, and tested, on its own
all the same. */

#include <stdexcept>
#include <utility>

#include "sec5/interval.hpp"

namespace lattice {

/// What the lemma needs to know; all are upper bounds, and the radius is exact.
template <class T>
struct Contraction {
  T eta = std::numeric_limits<T>::infinity();  ///< how far K moves the centre
  T q = std::numeric_limits<T>::infinity();    ///< by what factor K shrinks distances
  T radius = 0;

  /// The map shrinks distances in the ball.
  bool contracts() const { return q >= 0 && q < 1; }
  /// The map does not leave the ball.
  bool stays_inside() const {
    const Interval<T> image = Interval<T>(eta) + Interval<T>(q) * Interval<T>(radius);
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
template <class T, class Bound>
std::pair<Contraction<T>, Contraction<T>> two_balls(T eta, T largest, Bound q) {
  Contraction<T> unique{eta, q(largest), largest};
  for (int halvings = 0; !unique.holds(); ++halvings) {
    if (halvings == 60) throw NotProved("no ball is found on which the map contracts");
    const T radius = unique.radius / 2;
    unique = {eta, q(radius), radius};
  }
  Contraction<T> exists = unique;
  for (int i = 0; i < 3; ++i) {
    const Interval<T> enough =
        Interval<T>(eta) * T(1.0009765625) / (Interval<T>(1) - Interval<T>(exists.q));
    const T radius = std::min(exists.radius, enough.upper);
    exists = {eta, q(radius), radius};
  }
  if (!exists.holds()) throw NotProved("no ball is found that the map leaves invariant");
  return {unique, exists};
}

}  // namespace lattice
