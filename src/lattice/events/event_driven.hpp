#pragma once
/**
# Event-driven integration

A contact event is the instant at which a contact opens or closes. Between two of them the motion is smooth, and such
a segment costs little and is exact to the last digits (location.hpp). What remains is to find its end. We look ahead
with a plain leapfrog and small steps (event detection), integrate up to the instant where it saw an event, correct
that instant with the overlap $x$ found there, and repeat (event location). The second derivative of the overlap is
known from the forces, and with the root of the parabola $x + \dot x\tau + \ddot x\tau^2/2$ (overlap.hpp) the
correction converges with order three: two or three integrations of the
segment suffice. The columns of a tangent (tangent.hpp) follow only the last one.

The result does not rest on the detection being right. The forces are those of the true contact law
everywhere, never those of a contact held open or closed. An event that the detection missed shows
at the end of the segment as an overlap with the wrong sign, and we then locate it. */

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "lattice/events/location.hpp"
#include "lattice/events/overlap.hpp"
#include "lattice/events/tangent.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
Errors of the orbit are relative to its amplitude, for which we take the largest position or velocity at
the start. */
template <class T>
T largest(const State<T>& state) {
  T most(0);
  for (std::size_t n = 0; n < state.y.size(); ++n)
    most = std::max({most, magnitude(state.y[n]), magnitude(state.v[n])});
  return most > T(0) ? most : T(1);
}

/// Largest difference of two states in any position or velocity.
template <class T>
T largest_difference(const State<T>& a, const State<T>& b) {
  T most(0);
  for (std::size_t n = 0; n < a.y.size(); ++n)
    most = std::max({most, magnitude<T>(a.y[n] - b.y[n]), magnitude<T>(a.v[n] - b.v[n])});
  return most;
}

/**
`flow` advances `state` by `duration` and replaces `tangent`, if there is one, by its image under the
derivative of the flow. A runaway raises no exception: it shows in the `error` of what is returned. */
template <class T>
FlowReport<T> flow(const Chain& chain, State<T>& state, std::type_identity_t<T> duration,
                   const EventTolerance<T>& rule = {}, Tangent<T>* tangent = nullptr);

/**
To compare it with other methods, a flow can be used as a method of integrate.hpp. It needs no steps; they
only say where it may be interrupted. `advance` returns the number of site-force evaluations. */
struct EventDriven {
  double step;  ///< between two interruptions
  /// Advances `state` by `n` times `h`.
  double advance(const Chain& chain, State<double>& state, Window&, double h, std::size_t n) const {
    return double(flow(chain, state, h * double(n)).evaluations * chain.sites);
  }
};

}  // namespace lattice
