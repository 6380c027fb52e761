#pragma once
/**
# Linear damping

Friction takes away a fixed share $\nu_n$ of every velocity per unit of time,
$$\ddot y_n = \frac{F_n}{\mu_n} - \nu_n\,\dot y_n,$$
where $F_n$ is the force of the well and the contacts (chain.hpp). Without the forces this is solved
exactly, $\dot y_n \to e^{-\nu_n\tau}\,\dot y_n$ after a time $\tau$ at fixed positions, and without the
friction we have good steppers. So we alternate the two (Strang): half a step of friction, a conservative
step, half a step of friction. The order is two, whatever that of the conservative stepper, with an error
proportional to $\nu$. One rate for all sites makes a damped chain; rates that grow towards an end make
an end that absorbs waves.

The energy that friction takes is also known exactly, $\frac12\mu_n\dot y_n^2\,(1-e^{-2\nu_n\tau})$. Energy
and dissipated energy together are constant but for the drift of the conservative stepper, and this sum
replaces the energy in the report of a run. It says nothing about the error of the alternation, which
only a shorter step reveals. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "lattice/integrators/integrate.hpp"

namespace lattice {

/// What a damped run keeps from one step to the next.
template <class T, class Memory>
struct DampedMemory {
  Memory inner;                 ///< of the conservative stepper
  std::vector<T> factor, loss;  ///< for half a step: of the velocity, of the kinetic energy,
  double step = -1;             ///< and the step for which they were computed
  T dissipated = T(0);          ///< energy that the friction has taken so far
};

/// Stands in for the memory of a stepper that needs none.
struct NoMemory {};

/**
The damped stepper is a stepper around a stepper. `nu` holds one rate for all sites, or one per site. Each
step calls the conservative stepper anew, so that a splitting cannot merge its kicks across steps and
pays one more force evaluation per step. Without any friction the bits are those of the inner stepper. */
template <class Stepper>
struct Damped {
  Stepper stepper;         ///< of the conservative motion
  std::vector<double> nu;  ///< rates of the velocities, per unit of time: one, or one per site
  double step;             ///< that of `stepper`
  int halvings = 0;        ///< likewise (accuracy.hpp)

  /// Throws std::invalid_argument if there is no rate, or one is negative or not finite.
  Damped(Stepper inner, std::vector<double> rates)
      : stepper(std::move(inner)), nu(std::move(rates)), step(stepper.step) {
    if constexpr (requires { stepper.halvings; }) halvings = stepper.halvings;
    const auto good = [](double rate) { return rate >= 0 && std::isfinite(rate); };
    if (nu.empty() || !std::all_of(nu.begin(), nu.end(), good))
      throw std::invalid_argument("a damping rate must be finite and >= 0");
  }
  /// The same rate for all sites.
  Damped(Stepper inner, double rate) : Damped(std::move(inner), std::vector<double>{rate}) {}

  /**
  A damped run must remember the energy that has gone, even if its stepper remembers nothing. So its
  memory wraps that of the conservative stepper, if there is one. This is also where the chain is first
  known: throws std::invalid_argument if the rates do not fit its length. */

  /// Memory for `advance`; one serves a whole run and holds its dissipated energy.
  template <class T>
  auto memory(const Chain& chain) const {
    if (nu.size() != 1 && nu.size() != chain.sites)
      throw std::invalid_argument("damping needs one rate, or one rate a site");
    if constexpr (requires { stepper.template memory<T>(chain); })
      return DampedMemory<T, decltype(stepper.template memory<T>(chain))>{
          stepper.template memory<T>(chain), {}, {}};
    else
      return DampedMemory<T, NoMemory>{};
  }

  /**
  Next comes the alternation itself. Without friction all steps go to the conservative stepper at once:
  friction with the factor one would still cut its run into single steps, and the merged kicks of a
  splitting would round differently. */

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T, class Memory>
  double advance(const Chain& chain, State<T>& state, Window& window, double h, std::size_t count,
                 DampedMemory<T, Memory>& at) const {
    const bool frictionless =
        std::all_of(nu.begin(), nu.end(), [](double rate) { return rate == 0; });
    if (frictionless) return conserve(chain, state, window, h, count, at);
    if (at.step != h) prepare(h, at);
    double work = 0;
    for (std::size_t k = 0; k < count; ++k) {
      rub(chain, state, window, at);
      work += conserve(chain, state, window, h, 1, at);
      rub(chain, state, window, at);
    }
    return work;
  }

  /// The same with a memory of its own; the dissipated energy is not reported.
  template <class T>
  double advance(const Chain& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const {
    auto at = memory<T>(chain);
    return advance(chain, state, window, h, count, at);
  }

 private:
  /**
  The conservative step is that of the given stepper, which may want its memory or have none. */
  template <class T, class Memory>
  double conserve(const Chain& chain, State<T>& state, Window& window, double h, std::size_t count,
                  DampedMemory<T, Memory>& at) const {
    if constexpr (std::is_same_v<Memory, NoMemory>)
      return stepper.advance(chain, state, window, h, count);
    else
      return stepper.advance(chain, state, window, h, count, at.inner);
  }

  /**
  With $x = \nu h/2$ the friction of half a step leaves the share $e^{-x}$ of a velocity and takes the
  share $1-e^{-2x}$ of its kinetic energy. If damping is weak the latter is a small difference of two
  numbers close to one, which `expm1` computes without loss: the energy budget has to balance over millions
  of steps. Friction acts on the moving sites only, since those at rest have nothing to lose. */
  template <class T, class Memory>
  void prepare(double h, DampedMemory<T, Memory>& at) const {
    using std::exp, std::expm1;
    at.factor.clear(), at.loss.clear();
    for (double rate : nu) {
      const T x = T(rate) * T(h) / T(2);
      at.factor.push_back(exp(-x));
      at.loss.push_back(-expm1(T(-2) * x) / T(2));
    }
    at.step = h;
  }

  /// Half a step of friction at the sites of the window.
  template <class T, class Memory>
  void rub(const Chain& chain, State<T>& state, Window window, DampedMemory<T, Memory>& at) const {
    T sum(0);
    for (std::size_t n = window.first; n < window.last; ++n) {
      const std::size_t i = nu.size() == 1 ? 0 : n;
      sum += T(chain.mass_of(n)) * state.v[n] * state.v[n] * at.loss[i];
      state.v[n] *= at.factor[i];
    }
    at.dissipated += sum;
  }
};

/**
To its caller a damped run looks like any other, except that it also reports what friction took, and that
its `energy_drift` is that of energy and dissipated energy together. For this we must be able to read the
stepper's memory during the run, so `evolve` gets a stepper whose memory we own. */
struct DampedRun : Run {
  double dissipated = 0;  ///< during the run
};

/// A damped stepper with a memory that belongs to someone else.
template <class Stepper, class Memory>
struct WithBudget {
  const Damped<Stepper>& damped;
  Memory& memory;
  double step;   ///< that of the damped stepper
  int halvings;  ///< likewise

  /// Advances like every stepper (integrate.hpp), and notes what was lost in the memory.
  double advance(const Chain& chain, State<double>& state, Window& window, double h,
                 std::size_t count) const {
    return damped.advance(chain, state, window, h, count, memory);
  }
};

/**
The energy alone says nothing about a damped run, which is meant to lose it. What must not change is the
sum of energy and dissipated energy, so we wrap the observer: at each sample the sum is compared with the
energy at the start. An observer that wants to know the dissipated energy takes it as a second argument. */

/// Calls `go(stepper, observer)`, which runs the chain, and keeps the energy budget meanwhile.
template <class Stepper, class Observer, class Go>
DampedRun with_budget(const Damped<Stepper>& damped, const Chain& chain, const State<double>& start,
                      Observer& observe, Go go) {
  auto memory = damped.template memory<double>(chain);
  const WithBudget<Stepper, decltype(memory)> stepper{damped, memory, damped.step, damped.halvings};
  const double energy0 = energy(chain, start), scale = energy0 != 0 ? std::abs(energy0) : 1;
  double drift = 0;
  const auto watch = [&](const State<double>& now) {
    drift = std::max(drift, std::abs(energy(chain, now) + memory.dissipated - energy0) / scale);
    if constexpr (requires { observe(now, memory.dissipated); }) {
      const auto told = [&](const State<double>& s) { return observe(s, memory.dissipated); };
      return goes_on(told, now);
    } else {
      return goes_on(observe, now);
    }
  };
  DampedRun run{go(stepper, watch)};
  run.energy_drift = drift;
  run.dissipated = memory.dissipated;
  return run;
}

/**
A caller should not have to know whether there is friction. So `evolve` has the same two forms as in
integrate.hpp, with samples a stated time apart or at a given grid, and the type of the stepper selects
it. */
template <class Stepper, class Observer>
DampedRun evolve(const Damped<Stepper>& damped, const Chain& chain, State<double>& state,
                 double duration, double sample, Observer observe) {
  return with_budget(damped, chain, state, observe, [&](const auto& stepper, const auto& watch) {
    return evolve(stepper, chain, state, duration, sample, watch);
  });
}

/// The same on a given time grid.
template <class Stepper, class Observer>
DampedRun evolve(const Damped<Stepper>& damped, const Chain& chain, State<double>& state,
                 const TimeGrid& grid, Observer observe) {
  return with_budget(damped, chain, state, observe, [&](const auto& stepper, const auto& watch) {
    return evolve(stepper, chain, state, grid, watch);
  });
}

}  // namespace lattice
