#pragma once
/**
# Stating a tolerance instead of a step

Nobody should have to guess a step. The functions of this file repeat a computation with
half the step until two runs in a row agree, and hand out both: the finer one is the
result, and whatever is derived from it has the difference to the coarser one as its
error. That difference overestimates the error of the finer run, by a factor of about
twenty at order 4.5, and it is what the tables quote.

Where the motion is chaotic no step is small enough for a long run. The history of the
attempts is then the message of the exception. */

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

/// Two resolutions did not agree as well as was asked for; the message holds the history.
struct NotConverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Largest difference of two states relative to the largest displacement or velocity; infinite if
/// they belong to different times.
inline double distance(const State<double>& a, const State<double>& b) {
  if (a.t != b.t || a.y.size() != b.y.size()) return std::numeric_limits<double>::infinity();
  double apart = 0, scale = 0;
  for (std::size_t n = 0; n < a.y.size(); ++n) {
    apart = std::max({apart, std::abs(a.y[n] - b.y[n]), std::abs(a.v[n] - b.v[n])});
    scale = std::max({scale, std::abs(b.y[n]), std::abs(b.v[n])});
  }
  return scale > 0 ? apart / scale : apart;
}

/**
Down to ten digits the contact-aware scheme of Dormand, El-Mikkawy and Prince is the
cheapest; beyond that the composition with fourteen stages has the smaller constant. */
inline ContactAware stepper_for(double tolerance, double step) {
  if (tolerance >= 1e-10) return {step};
  return {step, nystrom(blanes_moan_6_14())};
}

/// Steps are halved from the first to the last of these. The fastest motion has a period of 2 pi.
inline constexpr double largest_step = 0.2, smallest_step = 0.2 / 128;

/// The last two of a sequence of runs, the relative distance of their end states, the finer step,
/// and whether they agree to the tolerance.
template <class Result>
struct Refined {
  Result coarse, fine;
  double error, step;
  bool converged;
  std::string history;
};

/// Two runs that both escape agree as far as the times of their escapes do.
template <class Result>
double disagreement(const Result& coarse, const Result& fine) {
  if (coarse.run.escaped() && fine.run.escaped())
    return std::abs(coarse.run.escape_time / fine.run.escape_time - 1);
  return distance(coarse.end, fine.end);
}

/// Repeats `compute(stepper)`, whose result has an `end` state and its `run`, until two results in a
/// row agree to `tolerance` or the smallest step is reached.
template <class Compute>
auto refine(double tolerance, Compute compute) {
  using Result = decltype(compute(stepper_for(tolerance, largest_step)));
  std::ostringstream history;
  double step = largest_step, error = 0;
  Result coarse = compute(stepper_for(tolerance, step));
  for (;;) {
    step /= 2;
    Result fine = compute(stepper_for(tolerance, step));
    error = disagreement(coarse, fine);
    history << (history.tellp() > 0 ? ", " : "") << "step " << step << ": " << error;
    const bool good = error <= tolerance;
    if (good || step <= smallest_step)
      return Refined<Result>{std::move(coarse), std::move(fine), error, step, good, history.str()};
    coarse = std::move(fine);
  }
}

/// As `refine`; throws NotConverged where the tolerance is not reached.
template <class Compute>
auto converge(double tolerance, Compute compute) {
  auto pair = refine(tolerance, compute);
  if (!pair.converged)
    throw NotConverged("the end states of two resolutions differ by more than the tolerance (" +
                       pair.history + ")");
  return pair;
}

/**
This is `evolve` for those who state a tolerance: the relative error of the end state. The
step is found by unobserved runs, `observe` sees only the one that counts, and the
returned `error` is the distance between it and the run with twice the step. */
template <class Onsite, class Contact, class Observer>
Run evolve_to(double tolerance, const Chain<Onsite, Contact>& chain, State<double>& state,
              double duration, double sample, Observer observe) {
  struct End {
    State<double> end;
    Run run;
  };
  const auto pair = converge(tolerance, [&](const ContactAware& stepper) {
    End out{state, {}};
    out.run = evolve(stepper, chain, out.end, duration, sample, Unobserved{});
    return out;
  });
  Run run =
      evolve(stepper_for(tolerance, pair.step), chain, state, duration, sample, std::move(observe));
  run.error = pair.error;
  return run;
}

}  // namespace lattice
