#pragma once
/**
# The smooth segments between contact events

With $t = t^* + u^2$ about an instant $t^*$ at which a contact opens or closes the solution is a power series in $u$, and
a formula has its full accuracy; the appendix (`secA_integrators`) shows it for one bead. This file has the map and the
leapfrog; event_driven.cpp extrapolates it across a segment and finds the ends. */

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "lattice/events/tangent.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
An interval $[a, a+L]$ between two events needs the square at both ends, and the simplest map with
that property is the cubic
$$t = a + L\,\varphi(s), \qquad \varphi(s) = 3s^2 - 2s^3, \qquad 0 \le s \le 1,$$
for which $t - a \simeq 3Ls^2$ and $a + L - t \simeq 3L(1-s)^2$. We use it on every interval; at an end
without an event it does no harm. Unlike a cosine it has the same bits everywhere.

The tangent map passes a contact event without a jump, because the contact force is continuous. */
/// $\varphi(e)-\varphi(s)$, in factors, so that short intervals lose no digits to cancellation.
template <class T>
T span(T s, T e) {
  return (e - s) * (T(3) * (s + e) - T(2) * (s * s + s * e + e * e));
}

/// `tolerance` bounds the error of a step, relative to the amplitude for the orbit and absolute for a tangent of order
/// one.
template <class T>
struct EventTolerance {
  T tolerance = T(128) * std::numeric_limits<T>::epsilon();  ///< sixteen units at least
  std::optional<T>
      slowest_event{};  ///< slower ones are not located; by default the tolerance tells
  int levels = 2 + std::numeric_limits<T>::digits10 / 2;  ///< of the extrapolation, at most
};

/// What a flow did. `error` is the sum of the estimates of all steps, measured like the tolerance; if
/// the solution runs away it exceeds one or is infinite, and the state is the last one computed.
template <class T>
struct FlowReport {
  std::size_t contact_events = 0;  ///< contacts that opened or closed at the end of an interval
  std::size_t missed_events = 0;   ///< contacts that did so in the middle of a step all the same
  std::size_t steps = 0;           ///< of the segments as accepted
  std::size_t evaluations = 0;     ///< of the force on the whole chain
  T error = T(0);
  T energy_drift = T(0);     ///< relative
  T action_integral = T(0);  ///< time integral of sum mu_n v_n^2
};

/**
The orbit takes an arbitrary tangent vector along. It shows how accurate the columns of a tangent will be before we
advance all of them: the orbit is smoother than its tangent by one derivative and would be content with too long a step.
Positions, velocities, the action integral $\int\sum\mu_n\dot y_n^2\,dt$ as one more position and, if there is a tangent vector,
its two halves lie in one array. The leapfrog drifts, kicks and drifts, so that it never evaluates a contact at the very
instant of an event, where the square root would magnify rounding errors. */
template <class T>
class Leapfrog {
 public:
  /// `chain` must live as long; with a tangent vector the array is twice as long.
  Leapfrog(const Chain& chain, bool tangent_vector)
      : chain_(chain),
        has_vector_(tangent_vector),
        push_(chain.sites + 1, T(0)),
        pull_(chain.sites, T(0)) {}

  /// `kicks` kicks from `s` to `s + h` on an interval of the given length; adds to `record`.
  void run(std::vector<T>& z, T length, T s, T h, std::size_t kicks, StepRecord<T>& record);
  /// One plain step of duration `dt`: drift for half of it, kick, drift for the other half.
  void step(std::vector<T>& z, T dt);
  std::size_t evaluations = 0;  ///< of the force on the whole chain

 private:
  void drift(std::vector<T>& z, T dt) const;
  void kick(std::vector<T>& z, const Curvature<T>& node);
  void kick_tangent_vector(const Curvature<T>& node, const T* y, T* v) const;
  void evaluate(const T* y, T* well, T* link);

  const Chain& chain_;
  bool has_vector_;
  std::vector<T> push_, pull_;
  Curvatures<T> own_{};  ///< that of the latest kick, where no record is kept
};

}  // namespace lattice
