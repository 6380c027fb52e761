#include "lattice/integrators/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace lattice {

double distance(const State<double>& a, const State<double>& b) {
  constexpr double far = std::numeric_limits<double>::infinity();
  if (a.t != b.t || a.y.size() != b.y.size()) return far;
  double apart = 0, scale = 0;
  for (std::size_t n = 0; n < a.y.size(); ++n) {
    const double y = std::abs(a.y[n] - b.y[n]), v = std::abs(a.v[n] - b.v[n]);
    if (!(y < far && v < far)) return far;
    apart = std::max({apart, y, v});
    scale = std::max({scale, std::abs(b.y[n]), std::abs(b.v[n])});
  }
  return scale > 0 ? apart / scale : apart;
}

// Of the times at which two runs end early, from the last sample before to the first one after in both; infinite if
// only one does, or if one is broken
static double escape_difference(const Run& a, const Run& b) {
  if (a.broken() || b.broken() || a.escaped() != b.escaped())
    return std::numeric_limits<double>::infinity();
  return (std::max(a.escape_time, b.escape_time) - std::min(a.t_end, b.t_end)) / b.escape_time;
}

EventCorrected method_for(double tolerance, double step, int halvings) {
  EventCorrected method{step};
  if (tolerance < 1e-10) method.base = nystrom(blanes_moan_6_14());
  method.halvings = halvings;
  method.finer = halvings;
  return method;
}

// Whether the `error` after `halvings` of the largest step at which a run holds cannot come down to the tolerance by the
// `left` ones: each divides it by 64 at best. The first two errors do not tell, nor does an infinite one
static bool hopeless(double error, double tolerance, int halvings, int left) {
  return halvings >= 3 && std::isfinite(error) && error * std::pow(largest_gain, -left) > tolerance;
}

bool run_holds(const Run& run) {
  return !run.escaped() && run.energy_error <= largest_energy_error;
}

static const char* hopeless_advice(double error) {
  return error < 1e-6 ? ", and smaller steps will not help: rounding leaves no more digits; take a "
                        "larger tolerance"
                      : ", and smaller steps will not help: the motion is too erratic for so long "
                        "a run; take a shorter run or a larger tolerance";
}

// How many halvings are left after the k-th: seven of a run that holds, and more where a run costs little or ends soon
static int halvings_left(int k, const Run& run, int held) {
  const int most = most_halvings - k;
  if (run.escaped()) return k >= usual_halvings && run.steps > many_steps ? 0 : most;
  const int usual = usual_halvings - std::max(held, held < 0 ? k : 0);
  const int cheap = run.work > 0 ? int(std::floor(std::log2(little_work / run.work))) : 0;
  return std::min(most, std::max({usual, cheap, 0}));
}

// More is due to steps that are too long, or to forces that are wrong
static double allowed_energy_error(double tolerance) {
  return std::max(tolerance, rounded_energy_error);
}

// Zero if the defect of `b` is below the tolerance
static double defect_difference(const Run& a, const Run& b, double tolerance) {
  if (b.energy_error <= allowed_energy_error(tolerance)) return 0;
  return std::abs(a.energy_error - b.energy_error);
}

static void assert_conserved(const Run& run, double tolerance) {
  if (run.energy_error <= allowed_energy_error(tolerance)) return;
  std::ostringstream text;
  text << "the energy drifts by " << run.energy_error
       << ", also with half the step (allowed: " << allowed_energy_error(tolerance)
       << "): a force may not be minus the derivative of its energy, or the motion is lost in the "
          "rounding of larger displacements; a larger tolerance allows more drift";
  throw RefinementFailed(text.str());
}

[[noreturn]] static void refuse_escape(const Run& run) {
  std::ostringstream text;
  text.precision(4);
  text << "a bead runs away at t = " << (run.t_end + run.escape_time) / 2
       << ", having left its well at t = " << run.leave_time
       << ": take a shorter run or another initial state (a small change of velocity may suffice)";
  throw RanAway(text.str());
}

EventCorrected Attempts::method() const {
  EventCorrected next = method_for(tolerance_, largest_step, runs_);
  next.finer = held_ + 1;
  return next;
}

EventCorrected Attempts::method_before() const {
  return method_for(tolerance_, largest_step, -1);
}

// Steps that are too long for a chain lose its energy, whether or not the run ends early. The history begins anew with
// the last of them
void Attempts::enter(const Run& run) {
  const int k = runs_++;
  const bool lossy = !run.escaped() && !run_holds(run);
  held_ = run.broken() || lossy ? -1 : held_ + 1;
  left_ = halvings_left(k, run, held_);
  if (run.escaped() || lossy) history.clear();
  if (k == 0 && held_ == 0) return;
  std::ostringstream text;
  text << (history.empty() ? "" : ", ") << "step " << std::ldexp(largest_step, -k) << ": ";
  if (lossy)
    text << "changes the energy by " << run.energy_error;
  else if (held_ < 0)
    text << "fails at t = " << run.escape_time;
  else if (held_ == 0)
    text << "succeeds";
  else
    text << error;
  history += text.str();
}

// By chance two runs can agree better than their steps allow; the run before them tells
bool Attempts::agree(const Run& coarse, const Run& fine, const std::function<double()>& differ,
                     const std::function<double()>& before) {
  const bool early = coarse.escaped() || fine.escaped();
  const double tolerance = early ? std::max(tolerance_, escape_tolerance) : tolerance_;
  const double last = difference_, before_last = std::exchange(last_, last);
  difference_ = early ? escape_difference(coarse, fine)
                      : std::max(differ(), defect_difference(coarse, fine, tolerance_));
  error = difference_;
  bool known = true;
  if (!early && error <= tolerance) {
    const double earlier = held_ > 0 ? last : runs_ == 1 && before ? before() : runs_ > 1 ? NAN : 0;
    known = !std::isnan(earlier) || !run_holds(fine);
    if (held_ > 1) gain = std::clamp(before_last / last, 1.0, largest_gain);
    if (std::isfinite(earlier)) error = std::max(error, earlier / gain);
  }
  const bool good = error <= tolerance && (known || left_ == 0);
  enter(fine);
  const bool spent = left_ == 0;
  const bool vain = !good && !spent && !early && hopeless(error, tolerance_, held_, left_);
  if (!good && !spent && !vain) return false;
  // The last two: is it a result?
  if (fine.broken())
    throw RefinementFailed("no step is short enough (" + history +
                           "): a contact may be too stiff, a force may not be finite, or a bead "
                           "may leave a well for which no rim is given");
  if (!good)
    throw RefinementFailed("the " + (fine.escaped() ? "times of escape" : named_) +
                           " of two resolutions differ by more than the tolerance (" + history +
                           ")" + (vain ? hopeless_advice(error) : ""));
  if (fine.escaped()) refuse_escape(fine);
  assert_conserved(fine, tolerance_);
  return true;
}

void assert_usable(const State<double>& start, double tolerance) {
  const auto refuse = [](const std::string& what, double value, const std::string& allowed) {
    std::ostringstream text;
    text << what << value << " (allowed: " << allowed << ")";
    throw std::invalid_argument(text.str());
  };
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    refuse("tolerance = ", tolerance, "finite and positive");
  for (std::size_t n = 0; n < start.y.size(); ++n)
    for (const auto& [name, value] :
         {std::pair("displacement", start.y[n]), std::pair("velocity", start.v[n])})
      if (!(std::abs(value) < escape_displacement))
        refuse("bead " + std::to_string(n + 1) + " starts with the " + name + " ", value,
               "finite and smaller than a million");
}

Run evolve(const Converged& stated, const Chain& chain, State<double>& state, double duration,
           Every every, const Look& look) {
  assert_usable(state, stated.tolerance);
  struct EndOfRun {
    State<double> end;
    Run run;
  };
  const auto runs = refined(stated.tolerance, [&](const EventCorrected& method) {
    EndOfRun out{state, {}};
    // With a sample for every step only where the run ends early
    for (double apart : {every.time, std::min(every.time, method.step)}) {
      out.end = state;
      out.run = evolve(method, chain, out.end, duration, denser(apart));
      if (!out.run.escaped()) break;
    }
    return out;
  });
  Run run = evolve(runs.method, chain, state, duration, every, look);
  // Stiff contacts make convergence irregular, so that twice the difference is stated, if the tolerance allows it. What two
  // runs agree on beyond some roundings nobody knows
  const double twice = std::min(2 * runs.error, std::max(runs.error, stated.tolerance));
  if (runs.error > 0) run.error = std::max(twice, 4 * std::numeric_limits<double>::epsilon());
  return run;
}

Run evolve(const Converged& stated, const Chain& chain, State<double>& state, double duration) {
  return evolve(stated, chain, state, duration, Every{duration > 0 ? duration : 1});
}

}  // namespace lattice
