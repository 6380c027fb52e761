#pragma once
/**
# Time stepping

The Hamiltonian, Eq. (6), is a sum of two parts that can each be solved exactly: the kinetic energy
$\sum \dot y_n^2/2$ makes the beads drift at constant velocity, the potential energy kicks them at fixed
positions. Alternating exact kicks and drifts with suitable weights is symplectic, reversible and cheap;
the weights are in schemes.hpp.

All such methods are limited by the contacts. We say that a contact *switches* when it opens or closes. If
this happens at $t^*$, its force behaves like $(t-t^*)_+^{3/2}$, which has one derivative and no more. A
step of length $h$ across $t^*$ therefore makes an error $O(h^{5/2})$, however high the order of the
scheme. In a chain the number of switchings per unit of time does not depend on $h$, so that the order is
about 2.5. A precompressed chain whose contacts stay closed recovers the full order. The tests measure
both. */

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

#include "lattice/integrators/schemes.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/numerics/observer.hpp"

namespace lattice {

/**
A run of many steps is one long list of stages, each a kick and a drift. Between two steps the last kick
of one is merged with the first of the next, so that `count` steps of a scheme with `m` kicks have
`count * (m - 1) + 1` stages. */
template <class T>
struct Stage {
  T kick, drift;  ///< durations, the weights of the scheme times the step
};

/// The number of stages of `steps` steps.
std::size_t stage_count(const Scheme& scheme, std::size_t steps);

/**
Listing the stages of a long run would take more memory than the chain, so each is made when it is due:
here stage `k` of a run of `steps` steps of length `h`. */
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

/**
A run is divided by counts and not by lengths: into `samples` equal intervals of `steps` equal steps
each. Doubling either count then halves the step exactly. Dividing by lengths would not do: where a step
has to be shortened to fit an interval, half of it may end up as the same step. */
struct TimeGrid {
  double duration = 0;
  std::size_t samples = 0, steps = 1;  ///< intervals in the duration, steps in an interval

  /// Time between two samples; zero if there are none.
  double interval() const { return samples > 0 ? duration / double(samples) : 0; }
  /// Length of a step.
  double step() const { return interval() / double(steps); }
};

/**
`time_grid` is the coarsest division of `duration` with samples at most `sample` apart and steps of at most
`step`; without duration there are no samples. The factor $1 - 10^{-12}$ keeps a quotient that rounding
has put just above a whole number from adding one more interval. Throws std::invalid_argument if the
duration is negative or not finite, or `sample` or `step` is not positive. */
TimeGrid time_grid(double duration, double sample, double step);

/**
An error is found by repeating a run with a finer grid (refinement.hpp). The step is halved, and either the samples stay
where they are, or they become denser together with the steps: for maxima and instants that are read from the samples,
whose own error must shrink together with that of the steps. */
/// When a run is looked at: at least once in `time`, and with `denser` in half of it wherever the step is halved.
struct Every {
  double time;
  bool denser = false;
  Every(double apart) : time(apart) {}
};
/// Looks that become denser with the steps.
inline Every denser(double time) {
  Every every = time;
  every.denser = true;
  return every;
}

/**
A run reports how far it can be trusted. At every sample its energy is compared with that at the start. The
difference is given relative to the latter, and relative to the largest energy that occurs: a bead that falls
from a height has more than it started with. A run may end early for two reasons. In a well with a rim a bead
may run away, and then it is first seen beyond the rim, with the energy still conserved. Otherwise the steps
are too long for the forces: such a run is *broken* and says nothing. */
struct Run {
  double energy_drift = 0;  ///< largest change of the energy, relative to the start
  /// The same, relative to the largest kinetic energy if that is more.
  double energy_defect = 0;
  double work = 0;        ///< site-force evaluations
  std::size_t steps = 0;  ///< time steps
  double error = 0;  ///< of the end state, relative; zero unless from `Converged` (refinement.hpp)
  double t_end = 0;  ///< time of the last sample that is not a runaway
  /// Time of the first sample that is one.
  double escape_time = std::numeric_limits<double>::infinity();
  /// Time of the sample since which a bead has been beyond the rim of its well.
  double leave_time = std::numeric_limits<double>::infinity();
  /// Whether the solution has run away, or seems to.
  bool escaped() const { return std::isfinite(escape_time); }
  /// Whether it seems to, but no bead was seen to leave its well.
  bool broken() const { return escaped() && !std::isfinite(leave_time); }
};

/// With a larger `energy_defect` the energy is not conserved.
inline constexpr double largest_defect = 1e-3;
/// A smaller one is not worth a thought, whether it is rounding or not.
inline constexpr double rounded_defect = 1e-5;

/// Two runs one after the other, as one; drifts and defects add up.
Run joined(const Run& first, const Run& second);

/**
A displacement beyond this counts as a runaway. Wells have a width of order one, and a bead that rolls over the
rims of a pendulum potential travels at a speed of order ten. The way that a bead can fly freely, with all of
the energy, is added to it. */
inline constexpr double escape_displacement = 1e6;

/// Whether no displacement is a runaway; one that is not a number is.
bool bounded(const State<double>& state);

/**
## The loop

A method is anything that has a `step`, the largest that it may take, and that can `advance` a chain; a run of one that
keeps work space between two calls (event_corrected.hpp) sets it up once. A refinement hands out methods that say how often
the step is halved. To a run all look alike. */
/// Carries a state by `count` steps of length `h`; returns the number of site-force evaluations.
using Advance = std::function<double(State<double>&, Window&, double h, std::size_t count)>;

/// Any method, once it is given to a run.
struct Method {
  double step;
  int halvings = 0;
  std::function<Advance(const Chain&)> on;  ///< at work on a chain, which must live as long

  template <class Any>
  requires requires(const Any& any) { any.step; }
  Method(const Any& any) : step(any.step) {
    if constexpr (requires { any.halvings; }) halvings = any.halvings;
    on = [any](const Chain& chain) -> Advance {
      if constexpr (requires { any.template memory<double>(chain); })
        return [any, &chain, memory = any.template memory<double>(chain)](
                   State<double>& state, Window& window, double h, std::size_t n) mutable {
          return any.advance(chain, state, window, h, n, memory);
        };
      else
        return [any, &chain](State<double>& state, Window& window, double h, std::size_t n) {
          return any.advance(chain, state, window, h, n);
        };
    };
  }
};

/// The grid of a run: the coarsest that suits the method's step, then its halvings.
TimeGrid time_grid(const Method& method, double duration, Every every);

/**
`evolve` carries a state forward and shows it to `look` at the start and after every sample. It stops early when `look`
returns false, or when the solution runs away; the runaway state is not shown. */
using Look = Observer<State<double>>;

/// Over the time `duration`. Throws std::invalid_argument for a grid that cannot be.
Run evolve(const Method& method, const Chain& chain, State<double>& state, double duration,
           Every every, const Look& look = {});

/// On a grid whose steps are counted and not measured, as those of a periodic orbit.
Run evolve(const Method& method, const Chain& chain, State<double>& state, const TimeGrid& grid,
           const Look& look = {});

}  // namespace lattice
