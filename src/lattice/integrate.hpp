#pragma once
/**
# Time stepping

The Hamiltonian splits into a part that moves the beads, $\sum \dot y_n^2/2$, and a
part that kicks them. Alternating exact kicks and drifts with suitable weights is
symplectic, reversible and cheap, and this file holds three such schemes.

Contact limits them all. When a contact opens or closes at $t^*$ its force behaves
like $(t-t^*)_+^{3/2}$: one derivative, no more. A step of length $h$ across such a
point makes an error $O(h^{5/2})$ whatever the order of the scheme, because the
quadrature of the force sees a function with a kink in its slope. In a chain the
switchings come at a fixed rate per unit time, their errors have random signs and
the observed order is about 2.5. A precompressed chain whose contacts stay closed
recovers the full order. The tests measure both. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "chain.hpp"

namespace lattice {

/**
A scheme is a list of pairs: kick by `kick[i]` h, then drift by `drift[i]` h. All are
symmetric, so that a run can be reversed by turning the velocities round. Because a
step ends with the operation with which the next one begins, a run of many steps
merges the two; `order` is the order on a smooth problem. */
struct Scheme {
  std::string name;
  int order;
  std::vector<double> kick, drift;
};

/// Velocity Verlet: one force evaluation a step, order 2.
inline Scheme verlet() {
  return {"verlet", 2, {0.5, 0.5}, {1.0, 0.0}};
}

/// Blanes and Moan (J. Comput. Appl. Math. 142, 2002, table 3): order 4, six force evaluations a
/// step, for Hamiltonians whose kinetic energy is quadratic (Runge-Kutta-Nystrom splitting).
inline Scheme blanes_moan_4() {
  const double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  const double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
  const double b4 = 1 - 2 * (b1 + b2 + b3);
  return {"blanes-moan-4", 4, {b1, b2, b3, b4, b3, b2, b1}, {a1, a2, a3, a3, a2, a1, 0}};
}

/// Blanes and Moan (ibid.): order 6, eleven force evaluations a step.
inline Scheme blanes_moan_6() {
  const double b1 = 0.0414649985182624, b2 = 0.198128671918067, b3 = -0.0400061921041533;
  const double b4 = 0.0752539843015807, b5 = -0.0115113874206879;
  const double b6 = 0.5 - (b1 + b2 + b3 + b4 + b5);
  const double a1 = 0.123229775946271, a2 = 0.290553797799558, a3 = -0.127049212625417;
  const double a4 = -0.246331761062075, a5 = 0.357208872795928;
  const double a6 = 1 - 2 * (a1 + a2 + a3 + a4 + a5);
  return {"blanes-moan-6",
          6,
          {b1, b2, b3, b4, b5, b6, b6, b5, b4, b3, b2, b1},
          {a1, a2, a3, a4, a5, a6, a5, a4, a3, a2, a1, 0}};
}

/// Blanes and Moan (ibid., SRKN 14a): order 6 with fourteen force evaluations and smaller errors. It
/// begins and ends with a drift, hence the empty first and last kicks.
inline Scheme blanes_moan_6_14() {
  Scheme scheme{"blanes-moan-6-14",
                6,
                {0, 0.09171915262446165, 0.183983170005006, -0.05653436583288827,
                 0.004914688774712854, 0.143761127168358, 0.328567693746804},
                {0.0378593198406116, 0.102635633102435, -0.0258678882665587, 0.314241403071447,
                 -0.130144459517415, 0.106417700369543, -0.00879424312851058}};
  std::vector<double>&kick = scheme.kick, &drift = scheme.drift;
  double kicks = 0.5, drifts = 1;
  for (double k : kick) kicks -= k;
  for (double d : drift) drifts -= 2 * d;
  kick.push_back(kicks);
  drift.push_back(drifts);
  for (std::size_t i = 8; i-- > 0;) kick.push_back(kick[i]);
  for (std::size_t i = 7; i-- > 0;) drift.push_back(drift[i]);
  drift.push_back(0);
  return scheme;
}

/**
A run of many steps is one long list of stages, each a kick and a drift. Between two
steps the last kick of the one and the first of the other are merged, so that `count`
steps of a scheme with `m` kicks have `count * (m - 1) + 1` stages. */
template <class T>
struct Stage {
  T kick, drift;
};

inline std::size_t stage_count(const Scheme& scheme, std::size_t steps) {
  return steps > 0 ? steps * (scheme.kick.size() - 1) + 1 : 0;
}

/// Stage `k` of a run with steps of length `h`.
template <class T>
Stage<T> stage_at(const Scheme& scheme, double h, std::size_t steps, std::size_t k) {
  const std::size_t last = scheme.kick.size() - 1, i = k == steps * last ? last : k % last;
  const bool merged = i == 0 && k > 0;
  const T kick = T(scheme.kick[i] * h), before = merged ? T(scheme.kick[last] * h) : T(0);
  return {kick + before, T(scheme.drift[i] * h)};
}

/// A splitting scheme with its step: the plainest stepper.
struct Splitting {
  Scheme scheme;
  double step;

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T, class Onsite, class Contact>
  double advance(const Chain<Onsite, Contact>& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const {
    double work = 0;
    for (std::size_t k = 0; k < stage_count(scheme, count); ++k) {
      const Stage<T> stage = stage_at<T>(scheme, h, count, k);
      kick_drift(chain, state, window, stage.kick, stage.drift);
      work += double(window.last - window.first);
    }
    return work;
  }
};

/**
A run reports how far it can be trusted. `energy_drift` is the largest relative
deviation of the energy seen at the samples; `escape_time` is set where the solution
leaves every bound, as it does beyond the rim of a soft well. */
struct Run {
  double energy_drift = 0;
  double work = 0;  ///< site-force evaluations
  double error =
      0;  ///< relative error of the end state, where a tolerance was asked for (accuracy.hpp)
  double t_end = 0;
  double escape_time = std::numeric_limits<double>::infinity();
  bool escaped() const { return std::isfinite(escape_time); }
};

/// Displacements beyond this are a runaway: wells are of order one, and a bead that rolls over the
/// rims of a pendulum potential travels at a speed of order ten.
inline constexpr double escape_displacement = 1e6;

/// Shows `state` to an observer, whose answer may be to stop; one that returns nothing goes on.
template <class Observer>
bool goes_on(Observer& observe, const State<double>& state) {
  if constexpr (std::is_same_v<decltype(observe(state)), bool>) return observe(state);
  observe(state);
  return true;
}

/// Some steppers keep work space between two calls of `advance`, the others do not ask for it.
template <class Stepper, class Onsite, class Contact>
auto advance_with_memory(const Stepper& stepper, const Chain<Onsite, Contact>& chain) {
  if constexpr (requires { stepper.template memory<double>(chain); })
    return [&, memory = stepper.template memory<double>(chain)](
               State<double>& state, Window& window, double h, std::size_t n) mutable {
      return stepper.advance(chain, state, window, h, n, memory);
    };
  else
    return [&](State<double>& state, Window& window, double h, std::size_t n) {
      return stepper.advance(chain, state, window, h, n);
    };
}

/**
`evolve` carries a state forward by `duration` and shows it to `observe(state)` at
the start and after every `sample` units of time. Samples are equally spaced and
the step divides the sampling interval, so `sample` and the step are shortened to
fit. It stops early when `observe` returns false, or when the solution escapes, in
which case the escape itself is not shown. */
template <class Stepper, class Onsite, class Contact, class Observer>
Run evolve(const Stepper& stepper, const Chain<Onsite, Contact>& chain, State<double>& state,
           double duration, double sample, Observer observe) {
  const auto samples = std::size_t(std::ceil(duration / sample * (1 - 1e-12)));
  const double interval = duration / double(samples), t0 = state.t;
  const auto steps = std::size_t(std::ceil(interval / stepper.step * (1 - 1e-12)));
  const double start = energy(chain, state), scale = start != 0 ? std::abs(start) : 1;
  Window window = waking(chain, state);
  auto advance = advance_with_memory(stepper, chain);
  Run run{.t_end = t0};
  if (!goes_on(observe, state)) return run;
  for (std::size_t k = 1; k <= samples; ++k) {
    run.work += advance(state, window, interval / double(steps), steps);
    state.t = t0 + interval * double(k);
    const double e = energy(chain, state);
    const bool bounded = std::all_of(state.y.begin(), state.y.end(),
                                     [](double y) { return std::abs(y) < escape_displacement; });
    if (!std::isfinite(e) || !bounded) {
      run.escape_time = state.t;
      break;
    }
    run.energy_drift = std::max(run.energy_drift, std::abs(e - start) / scale);
    run.t_end = state.t;
    if (!goes_on(observe, state)) break;
  }
  return run;
}

/// Where nothing needs to be watched.
struct Unobserved {
  void operator()(const State<double>&) const {}
};

}  // namespace lattice
