#pragma once
/**
# Time stepping

The Hamiltonian, Eq. (6), is a sum of two parts that can each be solved exactly: the kinetic energy
makes the beads drift at constant velocity, the potential energy kicks them at fixed positions. Alternating exact kicks
and drifts (schemes.hpp) is symplectic, reversible and cheap. Its order falls where contacts open or close;
event_corrected.hpp has the remedy. */

#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>

#include "lattice/integrators/schemes.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/numerics/observer.hpp"

namespace lattice {

/// A kick and a drift. Between two steps the last kick of one is merged with the first of the next, so that `count`
/// steps of a scheme with `m` kicks have `count * (m - 1) + 1` stages.
template <class T>
struct Stage {
  T kick, drift;  ///< durations, the weights of the scheme times the step
};

/// The number of stages of `steps` steps.
std::size_t stage_count(const Scheme& scheme, std::size_t steps);

/// Stage `k` of a run of `steps` steps of length `h`.
template <class T>
Stage<T> stage_at(const Scheme& scheme, double h, std::size_t steps, std::size_t k);

/// A splitting scheme with the largest step that it may take: the plainest method.
struct Splitting {
  Scheme scheme;
  double step;  ///< the largest that it may take

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T>
  double advance(const Chain& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const;
};

/// A run divided by counts, so that doubling one of them halves the step exactly.
struct TimeGrid {
  double duration = 0;
  std::size_t samples = 0, steps = 1;  ///< intervals in the duration, steps in an interval

  /// Time between two samples; zero if there are none.
  double interval() const { return samples > 0 ? duration / double(samples) : 0; }
  /// Length of a step.
  double step() const { return interval() / double(steps); }
};

/// The coarsest division of `duration` with samples at most `sample` apart and steps of at most `step`, safe from
/// rounding at whole numbers. Throws std::invalid_argument if the duration is negative or not finite, or `sample` or
/// `step` is not positive.
TimeGrid time_grid(double duration, double sample, double step);

/// When a run is looked at: at least once in `time`, and with `denser` in half of it wherever a refinement halves the
/// step, for maxima and instants that are read from the samples.
struct Every {
  double time;
  bool denser = false;
};
/// Looks that become denser with the steps.
inline Every denser(double time) {
  return {time, true};
}

/**
At every sample the energy is compared with that at the start. A run may end early for two reasons. In a well with a rim
a bead may run away, and then it is first seen beyond the rim, with the energy still conserved. Otherwise the steps
are too long for the forces: such a run is *broken* and says nothing. */
struct Run {
  double energy_drift = 0;  ///< largest change of the energy, relative to the start
  double energy_error = 0;  ///< the same, relative to the largest kinetic energy if that is more
  double work = 0;          ///< site-force evaluations
  std::size_t steps = 0;    ///< time steps
  double error = 0;  ///< of the end state, relative; zero unless from `Converged` (refinement.hpp)
  double t_end = 0;  ///< time of the last sample that is not a runaway
  /// Times of the first sample that is one, and of that since which a bead has been beyond the rim of its well.
  double escape_time = std::numeric_limits<double>::infinity(),
         leave_time = std::numeric_limits<double>::infinity();
  /// Whether the solution has run away, or seems to.
  bool escaped() const { return std::isfinite(escape_time); }
  /// Whether it seems to, but no bead was seen to leave its well.
  bool broken() const { return escaped() && !std::isfinite(leave_time); }
};

/// With a larger `energy_error` the energy is not conserved.
inline constexpr double largest_energy_error = 1e-3;
/// A smaller one is not worth a thought, whether it is rounding or not.
inline constexpr double rounded_energy_error = 1e-5;

/// Two runs one after the other, as one; drifts and defects add up.
Run joined(const Run& first, const Run& second);

/// A displacement beyond this, and beyond the way that a bead can fly with all of the energy, counts as a runaway.
inline constexpr double escape_displacement = 1e6;

/// Whether no displacement is a runaway; one that is not a number is.
bool bounded(const State<double>& state);

/**
## The loop

A method is anything that has a `step`, the largest that it may take, and that can `advance` a chain. One with a
`memory` (event_corrected.hpp) has it set up once for a run; one with `halvings` comes from a refinement. */
template <class M>
concept AdvancesChain = requires(const M& method, const Chain& chain, State<double>& state,
                                 Window& window, double h, std::size_t count) {
  { method.step } -> std::convertible_to<double>;
  requires requires {
    { method.advance(chain, state, window, h, count) } -> std::convertible_to<double>;
  } || requires {
    method.memory(chain);
  };
};

/// Carries a state of a chain by `count` steps of length `h`; returns the number of site-force evaluations.
using Advance =
    std::function<double(const Chain&, State<double>&, Window&, double h, std::size_t count)>;

/// Any method, by what a run asks of it.
struct Method {
  double step;
  int halvings = 0;
  std::function<Advance(const Chain&)> on;  ///< ready to advance this chain, and only this one

  template <AdvancesChain M>
  Method(const M& method);
};

template <AdvancesChain M>
Method::Method(const M& method) : step(method.step) {
  if constexpr (requires { method.halvings; }) halvings = method.halvings;
  on = [method](const Chain& of) -> Advance {
    if constexpr (requires { method.memory(of); })
      return [method, memory = method.memory(of)](const Chain& chain, State<double>& state,
                                                  Window& window, double h, std::size_t n) mutable {
        return method.advance(chain, state, window, h, n, memory);
      };
    else
      return [method](const Chain& chain, State<double>& state, Window& window, double h,
                      std::size_t n) { return method.advance(chain, state, window, h, n); };
  };
}
extern template Method::Method(const Splitting&);

/// The grid of a run: the coarsest that suits the method's step, then its halvings.
TimeGrid time_grid(const Method& method, double duration, Every every);

/// What sees the states of a run; it may end the run by returning false.
using Look = Observer<State<double>>;

/// Carries a state forward over the time `duration` and shows it to `look` at the start and after every sample. Stops
/// early when `look` returns false, or when the solution runs away; the runaway state is not shown. Throws
/// std::invalid_argument for a grid that cannot be.
Run evolve(const Method& method, const Chain& chain, State<double>& state, double duration,
           Every every, const Look& look = {});

/// Without a look between start and end.
Run evolve(const Method& method, const Chain& chain, State<double>& state, double duration);

/// On a grid whose steps are counted and not measured, as those of a periodic orbit.
Run evolve(const Method& method, const Chain& chain, State<double>& state, const TimeGrid& grid,
           const Look& look = {});

}  // namespace lattice
