#pragma once
/**
# Refinement: a tolerance in the place of a step

`refined` repeats a computation with half the step until two successive runs agree, and returns both: the finer one is
the result, and the error of whatever is derived from it is its difference from the coarser one, which overestimates it
(about twentyfold at the order 4.5 of event_corrected.hpp). The run before the two is kept, too, and sets a least error,
lest they agree by chance (`after_halving`); where the first two runs agree it is made for this purpose:

    const auto runs = refined(1e-6, [&](const EventCorrected& method) { return strike(method, impact); });
    const Estimate speed = runs.of([](const ImpactRun& run) { return packet_speed(run.path); });

The caller says what must agree: by default the end states, otherwise the number that will be reported. If the motion is
chaotic, no step is small enough for a long run; the exception then carries the history of the attempts. */

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Thrown if two resolutions do not agree as well as was asked for; the message holds the history.
struct RefinementFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown if a bead runs away; the message says when. It was seen beyond the rim of its well with the energy still
/// conserved (`Run`), and two runs agree to `escape_tolerance` on when it has gone; a sample more or less is a
/// difference.
struct RanAway : std::runtime_error {
  using std::runtime_error::runtime_error;
};
inline constexpr double escape_tolerance = 1e-3;

/// The largest difference of two states, relative to the largest displacement or velocity of the second; infinite if
/// they belong to different times.
double distance(const State<double>& a, const State<double>& b);

/// The method for a relative tolerance, with steps of at most `step`, halved `halvings` times by the run: the scheme of
/// Dormand, El-Mikkawy and Prince up to ten digits, the splitting with fourteen force evaluations beyond.
EventCorrected method_for(double tolerance, double step, int halvings = 0);

/**
A refinement begins with a step of 0.2, or one step per sample if samples are closer, and halves it seven
times, or more often as long as a run costs little. Where steps are too long for strong contacts or light beads, so that
runs break or lose their energy, the seven halvings count from the first that holds. Of a run that ends early more
halvings are tried unless it has many steps; if it breaks after so many, it does for another reason. */
inline constexpr double largest_step = 0.2;
inline constexpr int usual_halvings = 7, most_halvings = 20;
inline constexpr std::size_t many_steps = 16384;  ///< of a run that ends early
inline constexpr double little_work = 1 << 26;    ///< site-force evaluations, about a second

/// What must agree, a function of two results with a name for messages: by default the end states.
struct SameEnd {
  std::string name = "final states";

  template <class Result>
  double operator()(const Result& coarse, const Result& fine) const {
    return distance(coarse.end, fine.end);
  }
};

/// Two runs that agree.
template <class Result>
struct Refined : TwoRuns<Result> {
  EventCorrected method;             ///< of the finer run
  double error;                      ///< of what must agree: the difference of the two
  std::string history;               ///< steps and errors of all attempts
  std::optional<Result> coarsest{};  ///< the run before both, if it says anything
  double gain = largest_gain;        ///< see `after_halving`

  /// What `number` reads from the finer run, with its difference from the coarser one and what the coarsest adds.
  template <class Number>
  Estimate of(Number number) const {
    const Estimate last = TwoRuns<Result>::of(number);
    if (!coarsest) return last;
    const TwoRuns<const Result&> before{*coarsest, this->coarse};
    return after_halving(before.of(number), last, gain);
  }
  /// The same of what is read from the end states. Where these differ two runs may agree on a number by chance; the finer
  /// one is better by a factor of twenty.
  template <class Number>
  Estimate at_end(Number number) const {
    Estimate e = of(number);
    e.error = std::max(e.error, std::abs(e.value) * error / 20);
    return e;
  }
};

/// Decides which step comes next and when two runs agree; of runs that end early the times must. The energy drifts of
/// two runs have to agree as well: a large one that does not change with the step belongs to a wrong force.
class Attempts {
 public:
  Attempts(double tolerance, std::string named) : tolerance_(tolerance), named_(std::move(named)) {}

  /// The method of the next run; fast contacts are resolved better with every run that held.
  EventCorrected method() const;
  /// That of a run before the first one, with twice its step and, where those are close, half of its samples.
  EventCorrected method_before() const;
  /// Takes the first run that was made with it.
  void enter(const Run& run);
  /// Takes the next run, `fine`, and the one before; whether they agree. `differ` compares their results, and `before`
  /// those of the first run and of the one before it, or is nan if that one fails. Throws RefinementFailed if no step is short enough or left, or if
  /// the energy drifts; RanAway if a bead does.
  bool agree(const Run& coarse, const Run& fine, const std::function<double()>& differ,
             const std::function<double()>& before = {});

  double error = 0;  ///< of the last two
  double gain =
      largest_gain;       ///< by which a halving may have divided it: as in the halvings before
  std::string history{};  ///< the last step that was too long, the shorter ones and their errors

 private:
  double tolerance_;
  std::string named_;
  int runs_ = 0;
  int held_ = -1;  ///< halvings of the largest step at which a run holds; -1 if none does
  int left_ = 0;   ///< halvings that may still be made
  double difference_ = 0, last_ = 0;  ///< of the last two runs, and of the two before
};

/// The run that belongs to a result; an empty one if none does.
template <class Result>
Run run_of(const Result& result) {
  if constexpr (requires { Run(result.run); }) return result.run;
  return {};
}

/// Throws std::logic_error for one run made twice, with equal numbers of steps and equal bits at the end: then
/// the halvings of the method were ignored.
template <class Result>
void refuse_same_run(const Result& a, const Result& b) {
  if constexpr (requires { a.run.steps, a.end.y; })
    if (a.run.steps > 0 && a.run.steps == b.run.steps && a.end.t == b.end.t && a.end.y == b.end.y &&
        a.end.v == b.end.v)
      throw std::logic_error("two resolutions are the same run of " + std::to_string(b.run.steps) +
                             " steps, so comparing them proves nothing");
}

/// Whether a run kept its beads and its energy.
bool run_holds(const Run& run);

/// Two results of `compute(method)` that agree to `tolerance`, by default in their end states. Throws RefinementFailed,
/// RanAway, and std::logic_error for one run made twice.
template <class Compute, class Differ = SameEnd>
auto refined(double tolerance, Compute compute, Differ differ = {}) {
  using Result = std::decay_t<decltype(compute(EventCorrected{largest_step}))>;
  Attempts attempts(tolerance, differ.name);
  std::optional<Result> coarsest, coarse(compute(attempts.method()));
  attempts.enter(run_of(*coarse));
  // With so long a step a run may fail where the others do not, and then it says nothing
  const auto before = [&] {
    try {
      coarsest.emplace(compute(attempts.method_before()));
    } catch (const std::runtime_error&) {
    }
    if (coarsest && !run_holds(run_of(*coarsest))) coarsest.reset();
    return coarsest ? differ(*coarsest, *coarse) : NAN;
  };
  for (;;) {
    const EventCorrected method = attempts.method();
    Result fine = compute(method);
    refuse_same_run(*coarse, fine);
    if (attempts.agree(
            run_of(*coarse), run_of(fine), [&] { return differ(*coarse, fine); }, before))
      return Refined<Result>{{std::move(*coarse), std::move(fine)},
                             method,
                             attempts.error,
                             attempts.history,
                             std::move(coarsest),
                             attempts.gain};
    coarsest.reset();
    if (run_holds(run_of(*coarse))) coarsest = std::move(coarse);
    coarse.emplace(std::move(fine));
  }
}

/// A stated tolerance in the place of a method: the step is found in runs that nobody observes, `look` sees only the
/// last one, and the `error` of the run is twice the distance between its end and that of the run with twice the step. Where
/// a run ends early it is repeated with a sample for every step, to see when and whether a bead left its well.
struct Converged {
  double tolerance;  ///< relative error of the end state
};

/// Throws std::invalid_argument if the start or the tolerance is not finite, or absurdly large.
void assert_usable(const State<double>& start, double tolerance);

/// As `evolve` of integrate.hpp. Throws like `refined`, and std::invalid_argument for input that cannot be used.
Run evolve(const Converged& method, const Chain& chain, State<double>& state, double duration,
           Every every, const Look& look = {});
Run evolve(const Converged& method, const Chain& chain, State<double>& state, double duration);

}  // namespace lattice
