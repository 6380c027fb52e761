#pragma once
/**
# Stating a tolerance instead of a step

Nobody should have to guess a step. The functions of this file repeat a computation with half the step
until two successive runs agree, and return both: the finer one is the result, and the error of whatever
is derived from it is its difference from the coarser one. Where the runs converge that difference
overestimates the error of the finer one (by a factor $2^p - 1$ at order $p$, about twenty at the order
4.5 of contact_rkn.hpp), and it is what the tables quote.

The caller says what must agree: by default the end states, otherwise the number that will be reported,
such as a velocity, a threshold or a share. Two runs that turn out to be the same run prove nothing, and
count as an error rather than an agreement.

If the motion is chaotic, no step is small enough for a long run. The exception then carries the history
of the attempts as its message, and comes as soon as it is clear that there is no hope. A run that breaks
because its steps are too long is no run, and the step is halved until one holds. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/integrators/contact_rkn.hpp"

namespace lattice {

/// Thrown if two resolutions do not agree as well as was asked for; the message holds the history.
struct RefinementFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
In a well with a rim the solution itself may end: a bead leaves, and in a soft well it is infinitely far away within
a finite time. We believe this if the bead was seen beyond the rim with the energy still conserved (`Run`), and
if two runs agree to a thousandth on when it has gone; a sample more or less is a difference. */
/// Thrown if a bead runs away; the message says when.
struct RanAway : std::runtime_error {
  using std::runtime_error::runtime_error;
};
inline constexpr double escape_tolerance = 1e-3;

/// The relative difference of the times at which two runs end early; infinite if only one does, or if one is broken.
double escape_difference(const Run& a, const Run& b);

/**
Energy tells what end states do not. Where a step is too long its drift changes with the step, and so it has to agree as
well. If it does, and is large, a force does not belong to its energy: then all steps agree on a wrong motion. */
/// The difference of the energy defects of two runs, zero if that of `b` is below `tolerance`.
double defect_difference(const Run& a, const Run& b, double tolerance);

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
most seven times. The period of small oscillations in a well is $2\pi$, so that as a rule even the first step
resolves the motion. Strong contacts and light beads are faster; where runs break, the seven halvings count from
the first that holds. A run that ends early costs little, so that more halvings are tried unless it has many steps;
if it breaks after so many, it does for another reason. */
inline constexpr double largest_step = 0.2;
inline constexpr int usual_halvings = 7, most_halvings = 20;
inline constexpr std::size_t many_steps = 16384;  ///< of a run that ends early

/// The grid of a run in a refinement whose samples become denser together with the steps.
inline TimeGrid dense_time_grid(const ContactAware& stepper, double duration, double sample) {
  return denser_samples(time_grid(duration, sample, stepper.step), stepper.halvings);
}

/**
What must agree is a function of two results, such as the distance of their end states. */
struct EndState {
  std::string name = "end states";

  template <class Result>
  double operator()(const Result& coarse, const Result& fine) const {
    return distance(coarse.end, fine.end);
  }
};

/**
A refinement returns the last two of its runs with the difference of what must agree, the finer step, and
whether the tolerance was reached. */
template <class Result>
struct Refined {
  Result coarse, fine;
  double error;            ///< of what must agree: the difference of the two
  double step;             ///< of the finer run, before it is fitted to the samples
  bool converged;          ///< whether the error is below the tolerance
  std::string history;     ///< steps and errors of all attempts, for messages
  ContactAware stepper{};  ///< of the finer run
  bool gave_up = false;    ///< whether shorter steps were not tried any more
};

/// The run that belongs to a result; an empty one if none does.
template <class Result>
Run run_of(const Result& result) {
  if constexpr (requires { Run(result.run); }) return result.run;
  return {};
}

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
/// Whether the `error` after `halvings` of the largest step at which a run holds cannot come down to the tolerance.
bool hopeless(double error, double tolerance, int halvings);

/// What can be done about it, to be appended to the history.
inline constexpr const char* hopeless_advice =
    ", and smaller steps cannot mend it: the motion is too erratic for so long a run; ask for a "
    "shorter one or a larger tolerance";

/// Goes on to the smallest step whatever the errors are.
inline constexpr auto to_the_end = [](double, double, int) { return false; };

/// The attempts of a refinement, for its message and its end.
struct Attempts {
  std::string history{};  ///< the last step that was too long, the shorter ones and their errors
  int held = -1;          ///< halvings of the largest step at which a run holds; -1 if none does
  bool spent = false;     ///< whether no step is left

  /// Adds the run with the largest step halved `k` times, and what it differs by from the one before.
  void add(int k, const Run& run, double error);
};

/**
Now the refinement itself. It says with which stepper the next run is to be made and is given the run, until two
successive ones agree to `tolerance` in the sense of `differ(coarse, fine)`, the smallest step is reached, or
`give_up(error, tolerance, halvings)` says so. Of runs that end early the times must agree. */
template <class Result, class Differ = EndState, class GiveUp = decltype(to_the_end)>
class Refinement {
 public:
  explicit Refinement(double tolerance, Differ differ = {}, GiveUp give_up = {})
      : tolerance_(tolerance), differ_(std::move(differ)), give_up_(give_up) {}

  /// Whether another run is wanted, and its stepper; fast contacts are resolved better with every run that held.
  bool wants_more() const { return !done_; }
  ContactAware stepper() const {
    ContactAware next = stepper_for(tolerance_, largest_step, runs_);
    next.finer = attempts_.held + 1;
    return next;
  }
  /// Takes the run that was made with it. Throws std::logic_error if it ignores the halvings of its stepper, so that
  /// it is the one before.
  void add(Result run);
  /// The last two.
  Refined<Result> last_two() && { return std::move(*pair_); }

 private:
  double tolerance_;
  Differ differ_;
  GiveUp give_up_;
  Attempts attempts_{};
  std::optional<Result> last_{};
  std::optional<Refined<Result>> pair_{};
  int runs_ = 0;
  bool done_ = false;
};

template <class Result, class Differ, class GiveUp>
void Refinement<Result, Differ, GiveUp>::add(Result fine) {
  const ContactAware made_with = stepper();
  const int k = runs_++;
  const Run b = run_of(fine);
  if (k == 0) {
    attempts_.add(0, b, 0);
    last_ = std::move(fine);
    return;
  }
  Result& coarse = *last_;
  if (same_run(coarse, fine))
    throw std::logic_error("two resolutions are the same run of " + std::to_string(b.steps) +
                           " steps, which proves nothing");
  // Runs that end early are compared by when they do
  const Run a = run_of(coarse);
  const bool early = a.escaped() || b.escaped();
  const double error = early ? escape_difference(a, b)
                             : std::max(differ_(coarse, fine), defect_difference(a, b, tolerance_));
  const bool good = error <= (early ? std::max(tolerance_, escape_tolerance) : tolerance_);
  attempts_.add(k, b, error);
  const bool vain =
      !good && !attempts_.spent && !early && give_up_(error, tolerance_, attempts_.held);
  done_ = good || attempts_.spent || vain;
  if (done_)
    pair_ = Refined<Result>{
        std::move(coarse), std::move(fine), error, std::ldexp(largest_step, -k), good,
        attempts_.history, made_with,       vain};
  else
    last_ = std::move(fine);
}

/// The last two of the results of `compute(stepper)`.
template <class Compute, class Differ = EndState, class GiveUp = decltype(to_the_end)>
auto refine(double tolerance, Compute compute, Differ differ = {}, GiveUp give_up = {}) {
  using Result = decltype(compute(stepper_for(tolerance, largest_step)));
  Refinement<Result, Differ, GiveUp> runs(tolerance, std::move(differ), give_up);
  while (runs.wants_more()) runs.add(compute(runs.stepper()));
  return std::move(runs).last_two();
}

/**
Most callers have no use for a result that has not converged, and none for a run that ended early. `converged`
throws in both cases, and also if the energy drifts by more than the tolerance, with each
step alike. */
/// Throws RefinementFailed if the energy drifts by more than `tolerance` allows.
void assert_conserved(const Run& run, double tolerance);

/// What is said of a run in which a bead runs away, and of one that breaks, with the `history`.
std::string escape_message(const Run& run);
std::string broken_message(const std::string& history);

/// `pair`, which must agree in what is `named`. Throws RefinementFailed if the tolerance is not reached or can no more
/// be reached, if no step is short enough, or if the energy drifts; RanAway if a bead does.
template <class Result>
Refined<Result> converged(Refined<Result> pair, double tolerance, const std::string& named) {
  const Run fine = run_of(pair.fine);
  if (fine.broken()) throw RefinementFailed(broken_message(pair.history));
  if (!pair.converged)
    throw RefinementFailed("the " + (fine.escaped() ? "times of escape" : named) +
                           " of two resolutions differ by more than the tolerance (" +
                           pair.history + ")" + (pair.gave_up ? hopeless_advice : ""));
  if (fine.escaped()) throw RanAway(escape_message(fine));
  assert_conserved(fine, tolerance);
  return pair;
}

/// The last two results of `compute(stepper)`, which agree. Throws like `converged`.
template <class Compute, class Differ = EndState>
auto converge(double tolerance, Compute compute, Differ differ = {}) {
  return converged(refine(tolerance, compute, differ, hopeless), tolerance, differ.name);
}

/**
Finally `evolve` of integrate.hpp for a stated tolerance, the relative error of the end state. The step
is found in runs that nobody observes; `observe` sees only the last one, and the returned `error` is the
distance between its end and that of the run with twice the step. Where a run ends early it is repeated with a sample
for every step, to see when and whether a bead left its well. */
/// One of the runs in which the step is found: its end, and how it went.
struct EndOfRun {
  State<double> end;
  Run run;
};
EndOfRun end_of_run(const ContactAware& stepper, const Chain& chain, const State<double>& start,
                    double duration, double sample);

/// Throws std::invalid_argument if the start or the tolerance is not finite, or absurdly large.
void assert_usable(const State<double>& start, double tolerance);

/// Throws like `converge`, and std::invalid_argument for input that cannot be used.
template <class Observer>
Run evolve_to(double tolerance, const Chain& chain, State<double>& state, double duration,
              double sample, Observer observe) {
  assert_usable(state, tolerance);
  const auto pair = converge(tolerance, [&](const ContactAware& stepper) {
    return end_of_run(stepper, chain, state, duration, sample);
  });
  Run run = evolve(pair.stepper, chain, state, duration, sample, std::move(observe));
  // What two runs agree on beyond rounding nobody knows
  if (pair.error > 0) run.error = std::max(pair.error, std::numeric_limits<double>::epsilon());
  return run;
}

}  // namespace lattice
