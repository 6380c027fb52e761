#pragma once
/**
# The smooth segments between contact events

Periodic orbits and their Floquet multipliers are wanted to the last digits, and contact events stand in
the way. A contact of overlap $x$ pushes with $x_+^{3/2}$. Where it opens or closes, at $t^*$, its overlap
crosses zero at a finite speed, so along an orbit the force behaves like $(t-t^*)_+^{3/2}$ and the
stiffness, its derivative, like $(t-t^*)_+^{1/2}$. A formula of any order that takes a step $h$ across
$t^*$ integrates these as if they were polynomials, and errs by $h\cdot h^{3/2}$ in the state and by
$h\cdot h^{1/2}$ in the tangent map (tangent.hpp). Ending a step at $t^*$ is not enough: the derivatives of
the square root still blow up at the end of the step.

A change of the independent variable repairs this. With $t = t^* + u^2$ the root $(t-t^*)^{1/2} = u$
becomes a straight line, and the whole solution, which is a power series in $(t-t^*)^{1/2}$, becomes one
in $u$. The formula then has its full accuracy again. This file integrates across a segment whose ends are
contact events; event_driven.hpp finds the ends. */

#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/events/tangent.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
An interval $[a, a+L]$ between two events needs the square at both ends, and the simplest map with
that property is the cubic
$$t = a + L\,\varphi(s), \qquad \varphi(s) = 3s^2 - 2s^3, \qquad 0 \le s \le 1,$$
for which $t - a \simeq 3Ls^2$ and $a + L - t \simeq 3L(1-s)^2$. We use it on every interval; at an end
without an event it does no harm. Unlike a cosine it needs no library function, so that its bits are
the same everywhere.

The tangent map passes a contact event without a jump. In general the derivative of a flow across a surface
in phase space gains a term proportional to the jump of the vector field there. Here the contact force
is continuous and the jump is zero; that the instant of the event depends on the initial state does not
matter to first order.

Only differences $\varphi(e)-\varphi(s)$ are needed, and they factorise, so that short ones lose no
digits to cancellation. */
template <class T>
T span(T s, T e) {
  return (e - s) * (T(3) * (s + e) - T(2) * (s * s + s * e + e * e));
}

/**
A single number governs the accuracy: `tolerance` bounds the error of a step, relative to the amplitude
for the orbit and absolute for a tangent of order one. By default it is 128 units in the last place. The
other members rarely need to be set. `floor` is explained at `EventThresholds` in event_driven.cpp; `search_step` is
short against the period $2\pi$ of a well; and a number type with more digits needs more `levels` of the
extrapolation below. */
template <class T>
struct EventTolerance {
  T tolerance = T(128) * std::numeric_limits<T>::epsilon();  ///< sixteen units at least
  T floor = T(-1);          ///< slower events are not located; < 0: from the tolerance
  T search_step = T(0.05);  ///< time step in the search for contact events
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
  T energy_drift = T(0);  ///< relative
  T area = T(0);          ///< time integral of sum mu_n v_n^2
};

/**
The orbit takes one tangent vector along, an arbitrary one. It shows how accurate the columns of a tangent will be, and
whether the step suits them, before we advance all of them: the orbit is smoother than its tangent by one
derivative and would be content with too long a step. Positions `y`, velocities `v`, the area and, if
there is a tangent vector, its two halves lie in one array.

The area $\mathcal A = \int\sum\mu_n\dot y_n^2\,dt$ over a period, the action by which breathers
are compared, travels along as one more position: while the chain drifts its velocities are
constant, and so is the rate of the area. Its extrapolation is then as accurate as that of the orbit.

The leapfrog drifts, kicks and drifts, so that it never evaluates a contact at the very instant of
an event, where the square root would magnify rounding errors. */
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

/**
What integrating across a segment gives: the state in which it ends, the sum of the errors of its steps,
and the records that the columns will follow. */
template <class T>
struct SmoothSegment {
  std::vector<T> z;  ///< positions, velocities and area, 2 * sites + 1 numbers
  T error = T(0);
  std::vector<StepRecord<T>>
      records;  ///< of each step; without nodes if there is no tangent vector
};

/**
A step adds one leapfrog level after another until the last two extrapolated values agree, so that a short
interval costs two or three levels and a long one as many as the precision allows. If they do not suffice,
the step is shortened. We compare the value of $j$ levels with that of $j-1$, which estimates the error
of the latter. The usual comparison within level $j$ gives a number smaller by a factor $j^2$, and trusts
the asymptotic series too early while a recent event is still near.

Agreement is measured on the orbit and on the tangent vector. A runaway, a bead beyond the rim of a soft well,
never agrees: a step of 1/16384 of the interval is accepted as it is, and if the error then exceeds one
the integration gives up. */
template <class T>
class SegmentIntegrator {
 public:
  /// `chain` must live as long; errors of the orbit are relative to `amplitude`.
  SegmentIntegrator(const Chain& chain, const EventTolerance<T>& rule, T amplitude);
  /// Integrates across a segment of the given length (in time) from the positions, velocities and area in `z`,
  /// 2 * sites + 1 numbers; with a tangent vector it leaves records for the columns.
  SmoothSegment<T> integrate(const std::vector<T>& z, T length, bool tangent_vector);
  std::size_t evaluations = 0;  ///< of the force on the whole chain, in all segments

 private:
  std::vector<T> append_tangent_vector(std::vector<T> z) const;
  T step(Leapfrog<T>& leapfrog, std::vector<T>& z, T length, T s, T h, StepRecord<T>& record);
  T difference(const std::vector<T>& a, const std::vector<T>& b) const;

  const Chain& chain_;
  EventTolerance<T> rule_;
  T amplitude_;
  std::vector<std::vector<T>> table_;
  std::vector<T> previous_;  ///< its first entry before the latest level
};

}  // namespace lattice
