#include "lattice/integrators/integrate.ipp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "lattice/model/precisions.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

std::size_t stage_count(const Scheme& scheme, std::size_t steps) {
  return steps > 0 ? steps * (scheme.kick.size() - 1) + 1 : 0;
}

TimeGrid time_grid(double duration, double sample, double step) {
  constexpr double most_steps = 1e12;
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  // Of a subnormal number nothing might be left in a step
  const bool good = (duration == 0 || std::isnormal(duration)) && duration >= 0 &&
                    positive(sample) && positive(step) &&
                    duration / std::min(sample, step) <= most_steps;
  if (!good) {
    std::ostringstream text;
    text << "a run of duration " << duration << " with samples " << sample << " apart and steps of "
         << step << " (allowed: positive normal numbers, a zero duration, at most " << most_steps
         << " steps)";
    throw std::invalid_argument(text.str());
  }
  TimeGrid p{duration, std::size_t(std::ceil(duration / sample * (1 - 1e-12)))};
  if (p.samples > 0) p.steps = std::size_t(std::ceil(p.interval() / step * (1 - 1e-12)));
  p.steps = std::max<std::size_t>(p.steps, 1);
  return p;
}

// The step is halved, and the samples with it if they are to become denser; doubled are both, since no step is longer than
// the distance of two samples
TimeGrid time_grid(const Method& method, double duration, Every every) {
  const double longer = std::ldexp(1, std::max(-method.halvings, 0));
  TimeGrid grid = time_grid(duration, longer * every.time, longer * method.step);
  (every.denser ? grid.samples : grid.steps) <<= std::max(method.halvings, 0);
  return grid;
}

Run joined(const Run& first, const Run& second) {
  Run both = second;
  both.energy_drift += first.energy_drift;
  both.energy_error += first.energy_error;
  both.work += first.work;
  both.steps += first.steps;
  return both;
}

bool bounded(const State<double>& state) {
  return std::all_of(state.y.begin(), state.y.end(),
                     [](double y) { return std::abs(y) < escape_displacement; });
}

namespace {

/// What a run must keep: its energy, and its beads.
class Audit {
 public:
  /// Of a run that starts with the energy `start`.
  Audit(const Chain& chain, double start, double duration) : chain_(chain), start_(start) {
    // Beyond the wells and beyond the flight of the lightest bead with all of the energy
    double mass = 1;
    if (chain.variation)
      mass = *std::min_element(chain.variation->mass.begin(), chain.variation->mass.end());
    const double flight = std::sqrt(2 * std::max(start, 0.0) / mass) * duration;
    if (std::isfinite(flight)) far_ += flight;
  }

  /// Enters a sample into the run; false if the solution has run away.
  bool holds(const State<double>& state, const Window& window, Run& run) {
    const double now = energy(chain_, state), off = std::abs(now - start_);
    double reach = 0, kinetic = 0;
    for (std::size_t n = window.first; n < window.last; ++n) {
      if (!(std::abs(state.y[n]) < far_)) return false;
      reach = std::max(reach, std::abs(state.y[n]));
      kinetic += chain_.mass_of(n) * state.v[n] * state.v[n] / 2;
    }
    if (!std::isfinite(now)) return false;
    largest_ = std::max(largest_, kinetic);
    run.energy_drift = std::max(run.energy_drift, off / scale_);
    run.energy_error = std::max(run.energy_error, off / largest_);
    if (reach < rim_)
      run.leave_time = std::numeric_limits<double>::infinity();
    else if (run.energy_error <= largest_energy_error)
      run.leave_time = std::min(run.leave_time, state.t);
    run.t_end = state.t;
    return true;
  }

 private:
  const Chain& chain_;
  double start_, far_ = escape_displacement, scale_ = start_ != 0 ? std::abs(start_) : 1,
                 largest_ = scale_;
  double rim_ = chain_.well.rim();
};

}  // namespace

// March from sample to sample, watch energy and rim, and stop where the solution runs away
Run evolve(const Method& method, const Chain& chain, State<double>& state, const TimeGrid& grid,
           const Look& look) {
  const Advance advance = method.on(chain);
  const double t0 = state.t, interval = grid.interval();
  Progress progress(number_label("step", grid.step()), 1);
  const double start = energy(chain, state);
  Window window = waking(chain, state);
  Audit audit(chain, start, grid.duration);
  Run run{.t_end = t0};
  audit.holds(state, window, run);
  if (!look(state)) return run;
  for (std::size_t k = 1; k <= grid.samples; ++k) {
    heed_stop();
    run.work += advance(chain, state, window, grid.step(), grid.steps);
    run.steps += grid.steps;
    // Times are multiples of the interval and not sums of steps, so that rounding does not pile up
    state.t = t0 + interval * double(k);
    if (!audit.holds(state, window, run)) {
      run.escape_time = state.t;
      break;
    }
    if (!look(state)) break;
    progress.reach(double(k) / double(grid.samples));
  }
  return run;
}

Run evolve(const Method& method, const Chain& chain, State<double>& state, double duration,
           Every every, const Look& look) {
  return evolve(method, chain, state, time_grid(method, duration, every), look);
}

Run evolve(const Method& method, const Chain& chain, State<double>& state, double duration) {
  return evolve(method, chain, state, duration, Every{duration > 0 ? duration : 1});
}

LATTICE_IN_EACH_PRECISION(LATTICE_STEPPING)
template Method::Method(const Splitting&);

}  // namespace lattice
