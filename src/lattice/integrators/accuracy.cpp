#include "lattice/integrators/accuracy.hpp"

#include <limits>
#include <sstream>

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

// From the last sample before to the first one after, in both runs
double escape_difference(const Run& a, const Run& b) {
  if (a.broken() || b.broken() || a.escaped() != b.escaped())
    return std::numeric_limits<double>::infinity();
  return (std::max(a.escape_time, b.escape_time) - std::min(a.t_end, b.t_end)) / b.escape_time;
}

ContactAware stepper_for(double tolerance, double step, int halvings) {
  ContactAware stepper{step};
  if (tolerance < 1e-10) stepper.base = nystrom(blanes_moan_6_14());
  stepper.halvings = halvings;
  stepper.finer = halvings;
  return stepper;
}

bool hopeless(double error, double tolerance, int halvings) {
  const int left = usual_halvings - halvings;
  return halvings >= 3 && std::isfinite(error) && std::ldexp(error, -6 * left) > tolerance;
}

// What a run with a shorter step would cost: seven halvings of one that holds, but many more of one that ends soon
static bool is_last(int k, const Run& run, int held) {
  if (k >= most_halvings) return true;
  return run.escaped() ? k >= usual_halvings && run.steps > many_steps : held >= usual_halvings;
}

// The history begins anew where a run ends early
void Attempts::add(int k, const Run& run, double error) {
  held = run.broken() ? -1 : held + 1;
  spent = is_last(k, run, held);
  if (run.escaped()) history.clear();
  if (k == 0 && held == 0) return;
  std::ostringstream text;
  text << (history.empty() ? "" : ", ") << "step " << std::ldexp(largest_step, -k) << ": ";
  if (held < 0)
    text << "breaks at t = " << run.escape_time;
  else if (held == 0)
    text << "holds";
  else
    text << error;
  history += text.str();
}

// More is due to steps that are too long, or to forces that are wrong
static double allowed_defect(double tolerance) {
  return std::max(tolerance, rounded_defect);
}

double defect_difference(const Run& a, const Run& b, double tolerance) {
  if (b.energy_defect <= allowed_defect(tolerance)) return 0;
  return std::abs(a.energy_defect - b.energy_defect);
}

void assert_conserved(const Run& run, double tolerance) {
  if (run.energy_defect <= allowed_defect(tolerance)) return;
  std::ostringstream text;
  text
      << "the energy drifts by " << run.energy_defect
      << ", with half of the step as well (allowed: " << allowed_defect(tolerance)
      << "): a force may not be minus the derivative of its energy; a larger tolerance allows more";
  throw RefinementFailed(text.str());
}

// What is said of runs that end early
std::string escape_message(const Run& run) {
  std::ostringstream text;
  text.precision(4);
  text << "a bead runs away at t = " << (run.t_end + run.escape_time) / 2
       << ", having left its well at t = " << run.leave_time
       << ": take a shorter run or another start (a little more or less velocity may decide it)";
  return text.str();
}

std::string broken_message(const std::string& history) {
  return "no step is short enough (" + history +
         "): contacts may be too stiff, a force not finite there, or a well without a rim "
         "lets go of a bead";
}

// With a sample for every step only where the run ends early
EndOfRun end_of_run(const ContactAware& stepper, const Chain& chain, const State<double>& start,
                    double duration, double sample) {
  EndOfRun out{start, {}};
  for (double apart : {sample, std::min(sample, stepper.step)}) {
    out.end = start;
    out.run =
        evolve(stepper, chain, out.end, dense_time_grid(stepper, duration, apart), Unobserved{});
    if (!out.run.escaped()) break;
  }
  return out;
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

}  // namespace lattice
