#pragma once
/**
# Event-driven integration

A contact event is the instant at which a contact opens or closes. Between two of them the motion is smooth
(location.hpp). overlap.hpp has the formulas that detect and locate events; the appendix (`secA_integrators`) shows the
error of a tangent vector against the work. Location converges with order three. The columns of a tangent (tangent.hpp)
follow only the last integration.

The result does not rest on the detection being right. The forces are those of the true contact law everywhere. An event
that the detection missed shows at the end of the segment as an overlap with the wrong sign, and we then locate it. */

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>

#include "lattice/events/location.hpp"
#include "lattice/events/overlap.hpp"
#include "lattice/events/tangent.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/// The largest position or velocity, the unit in which errors of an orbit are measured; one at rest.
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

/// Whether a flow is good enough for an orbit: every step met the tolerance, and no contact that matters opened or
/// closed in the middle of one.
template <class T>
bool is_accurate(const FlowReport<T>& report, const EventTolerance<T>& rule);

/// Its message says that the motion ran away, how many events were missed, or which error was made and which is allowed.
struct FlowFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Advances `state` by `duration` and replaces `tangent`, if there is one, by its image under the derivative of the
/// flow. Throws FlowFailed unless the result is accurate.
template <class T>
FlowReport<T> flow(const Chain& chain, State<T>& state, std::type_identity_t<T> duration,
                   const EventTolerance<T>& rule = {}, Tangent<T>* tangent = nullptr);

/// The same without an exception, as Newton's method needs it: a runaway and missed events only show in what is
/// returned.
template <class T>
[[nodiscard]] FlowReport<T> try_flow(const Chain& chain, State<T>& state,
                                     std::type_identity_t<T> duration,
                                     const EventTolerance<T>& rule = {},
                                     Tangent<T>* tangent = nullptr);

}  // namespace lattice
