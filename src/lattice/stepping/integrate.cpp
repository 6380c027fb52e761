#include "lattice/stepping/integrate.hpp"

#include <algorithm>
#include <stdexcept>

#include "lattice/model/typed.hpp"
#include "lattice/numbers/interrupt.hpp"
#include "lattice/numbers/progress.hpp"

namespace lattice {

#ifndef LATTICE_QUADRUPLE
// With the kicks between steps merged, only the very last kick of a run is a stage of its own
std::size_t stage_count(const Scheme& scheme, std::size_t steps) {
  return steps > 0 ? steps * (scheme.kick.size() - 1) + 1 : 0;
}

// The coarsest division into equal samples and steps, safe from rounding at whole numbers
TimeGrid time_grid(double duration, double sample, double step) {
  const bool good = duration >= 0 && duration < 1e15 && sample > 0 && step > 0;
  if (!good)
    throw std::invalid_argument("a run needs a finite duration and positive samples and steps");
  TimeGrid p{duration, std::size_t(std::ceil(duration / sample * (1 - 1e-12)))};
  if (p.samples > 0) p.steps = std::size_t(std::ceil(p.interval() / step * (1 - 1e-12)));
  p.steps = std::max<std::size_t>(p.steps, 1);
  return p;
}

// Two refinements: of the steps alone, or of the samples together with the steps
TimeGrid shorter_steps(TimeGrid p, int times) {
  p.steps <<= times;
  return p;
}

TimeGrid denser_samples(TimeGrid p, int times) {
  p.samples <<= times;
  return p;
}

Run joined(const Run& first, const Run& second) {
  Run both = second;
  both.energy_drift += first.energy_drift;
  both.work += first.work;
  both.steps += first.steps;
  return both;
}

// Has no bead run away over the rim of a soft well?
bool bounded(const State<double>& state) {
  return std::all_of(state.y.begin(), state.y.end(),
                     [](double y) { return std::abs(y) < escape_displacement; });
}

// March from sample to sample, watch the energy, and stop where the solution runs away
Run evolve(const Advance& advance, const Chain& chain, State<double>& state, const TimeGrid& grid,
           const Look& look) {
  const double start = energy(chain, state), scale = start != 0 ? std::abs(start) : 1;
  const double t0 = state.t, interval = grid.interval();
  Window window = waking(chain, state);
  Run run{.t_end = t0};
  if (!look(state)) return run;
  Progress progress(number_label("step", grid.step()), 1);
  for (std::size_t k = 1; k <= grid.samples; ++k) {
    heed_stop();
    run.work += advance(state, window, grid.step(), grid.steps);
    run.steps += grid.steps;
    // Times are multiples of the interval and not sums of steps, so that rounding does not pile up
    state.t = t0 + interval * double(k);
    const double e = energy(chain, state);
    if (!std::isfinite(e) || !bounded(state)) {
      run.escape_time = state.t;
      break;
    }
    run.energy_drift = std::max(run.energy_drift, std::abs(e - start) / scale);
    run.t_end = state.t;
    if (!look(state)) break;
    progress.reach(double(k) / double(grid.samples));
  }
  return run;
}
#endif

// Where one step ends and the next begins, the last kick and the first become one
template <class T>
Stage<T> stage_at(const Scheme& scheme, double h, std::size_t steps, std::size_t k) {
  const std::size_t last = scheme.kick.size() - 1, i = k == steps * last ? last : k % last;
  const bool merged = i == 0 && k > 0;
  const T kick = T(scheme.kick[i] * h), before = merged ? T(scheme.kick[last] * h) : T(0);
  return {kick + before, T(scheme.drift[i] * h)};
}

// Kick and drift, stage after stage; the work counts the sites inside the moving window
template <class T>
double Splitting::advance(const Chain& chain, State<T>& state, Window& window, double h,
                          std::size_t count) const {
  const auto move = detail::plain_kick_drifter<T>(chain);
  double work = 0;
  for (std::size_t k = 0; k < stage_count(scheme, count); ++k) {
    const Stage<T> stage = stage_at<T>(scheme, h, count, k);
    move(chain, state, window, stage.kick, stage.drift, {});
    work += double(window.last - window.first);
  }
  return work;
}

#define LATTICE_INSTANCES(T)                                                                   \
  template Stage<T> stage_at<T>(const Scheme&, double, std::size_t, std::size_t);              \
  template double Splitting::advance<T>(const Chain&, State<T>&, Window&, double, std::size_t) \
      const;
#include "lattice/model/instances.hpp"

}  // namespace lattice
