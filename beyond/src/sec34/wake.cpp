#include "sec34/wake.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Beads, counted from the first one, that are damped at rate `nu`, and all from `ahead` on.
struct Absorber {
  std::size_t beads = 0;
  double nu = 0;
  std::size_t ahead = std::numeric_limits<std::size_t>::max();
};

Absorber absorber(const WavesAbsorbed& impact, std::size_t peak, double t) {
  if (impact.first_bead && t >= packet_has_left) return {1, rate_at_end};
  if (impact.around > 0 && t >= impact.moved)
    return {peak > impact.around ? peak - impact.around : 0, rate, peak + impact.around + 1};
  if (impact.behind == 0) return {};
  return {peak > impact.behind ? peak - impact.behind : 0, rate};
}

// Friction for a time is exact: velocities shrink by a factor
void rub(const Absorber& absorber, double time, State<double>& state) {
  const double factor = std::exp(-absorber.nu * time);
  for (std::size_t n = 0; n < absorber.beads; ++n) state.v[n] *= factor;
  for (std::size_t n = absorber.ahead; n < state.v.size(); ++n) state.v[n] *= factor;
}

// Sets to rest what is more than `kept` sites behind the packet, or ahead of it, too, which is then moved to the middle.
// Returns by how many sites it was moved.
double isolate(State<double>& state, std::size_t peak, bool to_the_middle) {
  const std::size_t sites = state.y.size(), first = peak > kept ? peak - kept : 0,
                    last = to_the_middle ? std::min(peak + kept + 1, sites) : sites,
                    to = to_the_middle ? sites / 2 - (peak - first) : first;
  State<double> alone(sites);
  alone.t = state.t;
  for (std::size_t n = first; n < last; ++n)
    alone.y[to + n - first] = state.y[n], alone.v[to + n - first] = state.v[n];
  state = alone;
  return double(to) - double(first);
}

}  // namespace

// Until the time is reached, or nobody wants to see more
Path follow_without(const WavesAbsorbed& impact, double step, double until, std::size_t sites,
                    const PacketLook& watch) {
  const Chain chain{sites, Quartic{impact.s}};
  State<double> state = struck(sites, impact.velocity);
  Advance advance = Method(EventCorrected{step}).on(chain);
  Window moving = waking(chain, state);
  const double look = look_every(step);
  const TimeGrid grid = time_grid(look, look, step);
  Path path;
  double shift = 0;  // of a packet that was moved
  bool waits = impact.wiped > 0 || impact.moved > 0;
  for (std::size_t k = 0; state.t < until - look / 2; ++k) {
    std::vector<double> density = energy_density(chain, state);
    auto peak = std::size_t(std::max_element(density.begin(), density.end()) - density.begin());
    if (waits && state.t >= std::max(impact.wiped, impact.moved) - look / 2) {
      shift = isolate(state, peak, impact.moved > 0);
      advance = Method(EventCorrected{step}).on(chain);  // its memory is that of the old window
      moving = waking(chain, state);
      density = energy_density(chain, state);
      peak += std::size_t(shift);
      waits = false;
    }
    path.add(state.t, density, peak);
    path.samples.back().centre -= shift;
    if (!watch(state, density, path.back().centre)) break;
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
  const auto watch = [&](const State<double>& now, const std::vector<double>&, double centre) {
    recent.add(now.t, centre);
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
