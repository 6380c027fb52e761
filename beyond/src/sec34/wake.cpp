#include "sec34/wake.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lattice {

namespace {

// Strong enough to absorb a wave within some ten sites
constexpr double rate = 0.1, rate_at_end = 0.2, packet_has_left = 60;

// Looks become denser with the step, so that two steps also show the error of what is read from them
double look_every(double step) {
  return std::min(path_sampling, 2 * step);
}

/// Beads, counted from the first one, that are damped at rate `nu`.
struct Absorber {
  std::size_t beads = 0;
  double nu = 0;
};

Absorber absorber(const WavesAbsorbed& impact, std::size_t peak, double t) {
  if (impact.first_bead && t >= packet_has_left) return {1, rate_at_end};
  if (impact.behind == 0) return {};
  return {peak > impact.behind ? peak - impact.behind : 0, rate};
}

// Friction for a time is exact: velocities shrink by a factor
void rub(const Absorber& absorber, double time, State<double>& state) {
  const double factor = std::exp(-absorber.nu * time);
  for (std::size_t n = 0; n < absorber.beads; ++n) state.v[n] *= factor;
}

}  // namespace

// Until the time is reached, or nobody wants to see more
Path follow_without(const WavesAbsorbed& impact, double step, double until, std::size_t sites,
                    const ImpactLook& watch) {
  const Chain chain{sites, Quartic{impact.s}};
  State<double> state = struck(sites, impact.velocity);
  const Advance advance = Method(EventCorrected{step}).on(chain);
  Window moving = waking(chain, state);
  const double look = look_every(step);
  const TimeGrid grid = time_grid(look, look, step);
  Path path;
  for (std::size_t k = 0; state.t < until - look / 2; ++k) {
    const std::vector<double> density = energy_density(chain, state);
    const auto peak =
        std::size_t(std::max_element(density.begin(), density.end()) - density.begin());
    path.add(state.t, density, peak);
    if (!watch(state, density)) break;
    const Absorber now = absorber(impact, peak, state.t);
    for (std::size_t i = 0; i < grid.steps; ++i) {
      rub(now, grid.step() / 2, state);
      advance(chain, state, moving, grid.step(), 1);
      rub(now, grid.step() / 2, state);
    }
    state.t = look * double(k + 1);
  }
  if (std::abs(state.v.back()) > 1e-9)
    throw std::runtime_error("a wave has reached the end of the chain of " + std::to_string(sites) +
                             " sites");
  return path;
}

// Watch plain means over the width of the smoothing: they tell whether the packet comes back
LateFate late_fate(const WavesAbsorbed& impact, double step, double until, std::size_t sites) {
  LateFate out;
  const auto width = std::size_t(std::lround(path_smoothing / look_every(step)));
  Path recent;
  double mean = 0, late = std::nan("");
  const auto watch = [&](const State<double>& now, const std::vector<double>& density) {
    recent.add(now.t, density);
    if (recent.size() < width) return true;
    mean = 0;
    for (const PathSample& at : recent) mean += at.centre;
    mean /= double(width);
    if (mean > out.furthest) out.furthest = mean, out.when = (recent[0].t + recent.back().t) / 2;
    if (std::isnan(late) && now.t > 0.9 * until) late = mean;
    recent = {};
    if (mean < out.furthest - 5) out.late = Late::returns;
    return out.late != Late::returns;
  };
  out.path = follow_without(impact, step, until, sites, watch);
  if (out.late != Late::returns && std::abs(mean - late) < 1) out.late = Late::trapped;
  return out;
}

}  // namespace lattice
