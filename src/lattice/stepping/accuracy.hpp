#pragma once
/**
# Stating a tolerance instead of a step

Nobody should have to guess a step. The functions of this file repeat a computation with half the step
until two successive runs agree, and return both: the finer one is the result, and the error of whatever
is derived from it is its difference from the coarser one. That difference overestimates the error of
the finer run (by a factor $2^p - 1$ at order $p$, about twenty at the order 4.5 of contact_rkn.hpp), and
it is what the tables quote.

The caller says what must agree: by default the end states, otherwise the number that will be reported,
such as a velocity, a threshold or a share. Two runs that turn out to be the same run prove nothing, and
count as an error rather than an agreement.

If the motion is chaotic, no step is small enough for a long run. The exception then carries the history
of the attempts as its message, and comes as soon as it is clear that there is no hope. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/stepping/contact_rkn.hpp"

namespace lattice {

/// Thrown if two resolutions do not agree as well as was asked for; the message holds the history.
struct RefinementFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
How far apart are two runs? We take the largest difference between the two states, relative to the
largest displacement or velocity of the second. It is infinite if they belong to different times. */
double distance(const State<double>& a, const State<double>& b);

/**
Which scheme is the cheapest depends on the tolerance: up to ten digits it is that of Dormand, El-Mikkawy
and Prince, beyond that the splitting with fourteen force evaluations (schemes.hpp), whose errors are
smaller. Both are used with the treatment of contacts of contact_rkn.hpp. */
/// The stepper for a relative tolerance, with steps of at most `step`, halved `halvings` times by the run.
ContactAware stepper_for(double tolerance, double step, int halvings = 0);

/**
A refinement begins with a step of 0.2, or one step per sample if samples are closer, and halves it at
most seven times. The period of small oscillations in a well is $2\pi$, so that even the first step
resolves the motion. */
inline constexpr double largest_step = 0.2, smallest_step = 0.2 / 128;

/// The grid of a run in a refinement whose samples become denser together with the steps.
inline TimeGrid dense_time_grid(const ContactAware& stepper, double duration, double sample) {
  return denser_samples(time_grid(duration, sample, stepper.step), stepper.halvings);
}

/**
What must agree is a function of two results. The first is the distance of their end states. If both runs
escape, it is the relative difference of the times of escape. */
struct EndState {
  std::string name = "end states";

  template <class Result>
  double operator()(const Result& coarse, const Result& fine) const {
    if (coarse.run.escaped() && fine.run.escaped())
      return std::abs(coarse.run.escape_time / fine.run.escape_time - 1);
    return distance(coarse.end, fine.end);
  }
};

/**
The second is the relative difference of a number that is read from each result. */
template <class Of>
struct Reading {
  std::string name;
  Of of;

  template <class Result>
  double operator()(const Result& coarse, const Result& fine) const {
    const double a = of(coarse), b = of(fine);
    return a == b ? 0 : std::abs(a - b) / std::max(std::abs(a), std::abs(b));
  }
};

/// For example `reading("speeds", [](const ImpactRun& run) { return ...; })`.
template <class Of>
Reading<Of> reading(std::string name, Of of) {
  return {std::move(name), std::move(of)};
}

/**
A refinement returns the last two of its runs with the difference of what must agree, the finer step, and
whether the tolerance was reached. */
template <class Result>
struct Refined {
  Result coarse, fine;
  double error;         ///< of what must agree: the difference of the two
  double step;          ///< of the finer run, before it is fitted to the samples
  bool converged;       ///< whether the error is below the tolerance
  std::string history;  ///< steps and errors of all attempts, for messages
  int halvings = 0;     ///< of the finer run
};

/// Whether two results come from one run made twice: equal numbers of steps and equal bits at the end.
template <class Result>
bool same_run(const Result& a, const Result& b) {
  if constexpr (requires { a.run.steps, a.end.y; })
    return a.run.steps > 0 && a.run.steps == b.run.steps && a.end.t == b.end.t &&
           a.end.y == b.end.y && a.end.v == b.end.v;
  return false;
}

/**
A halving costs as much as all runs before it, and at the order six of the schemes it divides an error by 64 at best.
So after a look at the error one may know that the halvings which are left are in vain. The first two errors do not
tell: with such large steps the next one may be smaller by more. An infinite error, of a run that escapes and one that
does not, does not tell either. */
/// Whether the `error` after `halvings` of the largest step cannot come down to the tolerance at the smallest one.
bool hopeless(double error, double tolerance, int halvings);

/// What can be done about it, to be appended to the history.
inline constexpr const char* hopeless_advice =
    ", and smaller steps cannot mend it: the motion is too erratic for so long a run; ask for a "
    "shorter one or a larger tolerance";

/// Goes on to the smallest step whatever the errors are.
inline constexpr auto to_the_end = [](double, double, int) { return false; };

/**
Now the refinement itself: `compute(stepper)` is repeated until two successive results agree to
`tolerance` in the sense of `differ(coarse, fine)`, the smallest step is reached, or `give_up(error, tolerance,
halvings)` says so. Throws std::logic_error if `compute` ignores the halvings of its stepper, so that both runs are
the same. */
template <class Compute, class Differ = EndState, class GiveUp = decltype(to_the_end)>
auto refine(double tolerance, Compute compute, Differ differ = {}, GiveUp give_up = {}) {
  using Result = decltype(compute(stepper_for(tolerance, largest_step)));
  std::ostringstream history;
  Result coarse = compute(stepper_for(tolerance, largest_step));
  for (int k = 1;; ++k) {
    Result fine = compute(stepper_for(tolerance, largest_step, k));
    if (same_run(coarse, fine))
      throw std::logic_error("two resolutions are the same run of " +
                             std::to_string(fine.run.steps) + " steps, which proves nothing");
    const double error = differ(coarse, fine), step = std::ldexp(largest_step, -k);
    history << (history.tellp() > 0 ? ", " : "") << "step " << step << ": " << error;
    const bool good = error <= tolerance;
    if (good || step <= smallest_step || give_up(error, tolerance, k))
      return Refined<Result>{
          std::move(coarse), std::move(fine), error, step, good, history.str(), k};
    coarse = std::move(fine);
  }
}

/**
Most callers have no use for a result that has not converged. `converge` does the same as `refine` and
throws RefinementFailed if the tolerance is not reached, or cannot be reached any more. */
template <class Compute, class Differ = EndState>
auto converge(double tolerance, Compute compute, Differ differ = {}) {
  auto pair = refine(tolerance, compute, differ, hopeless);
  if (pair.converged) return pair;
  const bool early = pair.step > smallest_step;
  throw RefinementFailed("the " + differ.name +
                         " of two resolutions differ by more than the tolerance (" + pair.history +
                         ")" + (early ? hopeless_advice : ""));
}

/**
Finally `evolve` of integrate.hpp for a stated tolerance, the relative error of the end state. The step
is found in runs that nobody observes; `observe` sees only the last one, and the returned `error` is the
distance between its end and that of the run with twice the step. Throws RefinementFailed like `converge`. */
template <class Observer>
Run evolve_to(double tolerance, const Chain& chain, State<double>& state, double duration,
              double sample, Observer observe) {
  struct End {
    State<double> end;
    Run run;
  };
  const auto pair = converge(tolerance, [&](const ContactAware& stepper) {
    End out{state, {}};
    out.run = evolve(stepper, chain, out.end, duration, sample, Unobserved{});
    return out;
  });
  Run run = evolve(stepper_for(tolerance, largest_step, pair.halvings), chain, state, duration,
                   sample, std::move(observe));
  run.error = pair.error;
  return run;
}

}  // namespace lattice
