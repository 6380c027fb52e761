#include "sec34/wake.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace lattice {

namespace {

// Friction is that of the chapter: strong enough to absorb a wave within some ten sites
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

Absorber absorber(const WavesRemoved& impact, std::size_t peak, double t) {
  if (impact.first_bead && t >= packet_has_left) return {1, rate_at_end};
  if (impact.behind == 0 || t < impact.cut) return {};
  return {peak > impact.behind ? peak - impact.behind : 0, rate};
}

// Friction for a time is exact: velocities shrink by a factor, and the energy that is lost is known
double rub(const Absorber& absorber, double time, State<double>& state, bool counted) {
  const double factor = std::exp(-absorber.nu * time);
  double energy = 0;
  for (std::size_t n = 0; counted && n < absorber.beads; ++n) energy += state.v[n] * state.v[n] / 2;
  for (std::size_t n = 0; n < absorber.beads; ++n) state.v[n] *= factor;
  return energy * (1 - factor * factor);
}

/// One chain on its way, up to the cut or after it.
struct WakeRun {
  WavesRemoved impact;
  double step;
  std::size_t shift;
  double dissipated;

  // Until a time is reached, or nobody wants to see more
  bool go(const Chain& chain, State<double>& state, double until, Path& path,
          const WakeLook& observe);
};

bool WakeRun::go(const Chain& chain, State<double>& state, double until, Path& path,
                 const WakeLook& observe) {
  const Advance advance = Method(EventCorrected{step}).on(chain);
  Window moving = waking(chain, state);
  const double look = look_every(step);
  const TimeGrid grid = time_grid(look, look, step);
  const double from = state.t;
  for (std::size_t k = 0; state.t < until - look / 2; ++k) {
    const std::vector<double> density = energy_density(chain, state);
    const std::size_t peak = peak_index(density);
    path.add(state.t, density, peak);
    path.centre.back() -= double(shift);
    if (!observe({chain, state, density, peak, shift, dissipated})) return false;
    const Absorber now = absorber(impact, peak, state.t);
    for (std::size_t i = 0; i < grid.steps; ++i) {
      dissipated += rub(now, grid.step() / 2, state, impact.counted);
      advance(state, moving, grid.step(), 1);
      dissipated += rub(now, grid.step() / 2, state, impact.counted);
    }
    state.t = from + look * double(k + 1);
  }
  return true;
}

}  // namespace

// Where the energy is largest
std::size_t peak_index(const std::vector<double>& density) {
  return std::size_t(std::max_element(density.begin(), density.end()) - density.begin());
}

// Copy the packet and nothing else
State<double> cut_out(const Chain& chain, const State<double>& state, std::size_t shift) {
  constexpr std::size_t half_width = packet_half_width + 1;
  const std::size_t peak = peak_index(energy_density(chain, state));
  State<double> alone(chain.sites + shift);
  alone.t = state.t;
  for (std::size_t n = peak > half_width ? peak - half_width : 0; n <= peak + half_width; ++n)
    alone.y[n + shift] = state.y[n], alone.v[n + shift] = state.v[n];
  return alone;
}

// Up to the cut on the struck chain, then on one that reaches as far behind the packet
Path follow_without(const WavesRemoved& impact, double step, double until, std::size_t sites,
                    const WakeLook& observe) {
  Chain chain{sites, Quartic{impact.s}};
  State<double> state = struck(sites, impact.velocity);
  Path path;
  WakeRun run{impact, step, 0, 0};
  if (impact.cut > 0) {
    if (!run.go(chain, state, std::min(impact.cut, until), path, observe)) return path;
    state = cut_out(chain, state, sites);
    state.t = impact.cut;
    run.shift = sites;
    chain.sites += sites;
  }
  run.go(chain, state, until, path, observe);
  const double first = impact.cut > 0 ? std::abs(state.v.front()) : 0;
  if (std::max(first, std::abs(state.v.back())) > 1e-9)
    throw std::runtime_error("a wave has reached an end of the chain of " + std::to_string(sites) +
                             " sites");
  return path;
}

// Watch plain means over the width of the smoothing: they tell whether the packet comes back
LateFate late_fate(const WavesRemoved& impact, double step, double until, std::size_t sites,
                   Path* way) {
  LateFate out;
  const auto width = std::size_t(std::lround(path_smoothing / look_every(step)));
  Path recent;
  double mean = 0, late = std::nan("");
  const auto watch = [&](const WakeSample& now) {
    recent.add(now.state.t, now.density, now.peak);
    recent.centre.back() -= double(now.shift);
    if (recent.t.size() < width) return true;
    mean = std::accumulate(recent.centre.begin(), recent.centre.end(), 0.0) / double(width);
    if (mean > out.furthest)
      out.furthest = mean, out.when = (recent.t.front() + recent.t.back()) / 2;
    if (std::isnan(late) && now.state.t > 0.9 * until) late = mean;
    recent = {};
    if (mean < out.furthest - 5) out.late = Late::returns;
    return out.late != Late::returns;
  };
  Path path = follow_without(impact, step, until, sites, watch);
  if (out.late != Late::returns && std::abs(mean - late) < 1) out.late = Late::trapped;
  if (way) *way = std::move(path);
  return out;
}

// Energies at the end minus those at the beginning, and the mean forces in between
Budget budget(WavesRemoved impact, double step, double from, double to) {
  impact.counted = true;
  constexpr double ends = 16;  // energies are means over four internal periods
  constexpr std::size_t m = packet_half_width;
  Budget out;
  double all = 0, at_ends = 0;
  follow_without(impact, step, to, 150, [&](const WakeSample& now) {
    const double t = now.state.t + 1e-9;
    if (t < from) return true;
    const std::vector<double>&e = now.density, &y = now.state.y;
    const std::size_t peak = peak_index(e), back = peak - m, front = peak + m;

    // Energies at the end minus those at the beginning
    if (const double sign = t < from + ends ? -1 : t > to - ends ? 1 : 0; sign != 0) {
      const auto sum = [&](std::size_t a, std::size_t b) {
        return std::accumulate(e.begin() + long(a), e.begin() + long(b), 0.0);
      };
      const std::size_t edge = peak > 15 ? peak - 15 : 0;
      out.packet += sign * sum(back, front + 1), out.near += sign * sum(edge, back);
      out.far += sign * sum(0, edge), out.friction += sign * now.dissipated;
      at_ends += 0.5;
    }

    // Forces on the sites of the packet
    const auto push = [&](std::size_t n) {
      const double x = std::max(0.0, y[n - 1] - y[n]);
      return x * std::sqrt(x);
    };
    out.push_behind += push(back), out.push_ahead += push(front + 1), ++all;
    for (std::size_t n = back; n <= front; ++n) out.wells += y[n] + impact.s * y[n] * y[n] * y[n];
    return true;
  });
  for (double* x : {&out.packet, &out.near, &out.far, &out.friction}) *x /= at_ends;
  for (double* x : {&out.push_behind, &out.push_ahead, &out.wells}) *x /= all;
  return out;
}

namespace {

/// Sums over a stretch of time, and the zeros that fell into it.
struct Gauge {
  std::vector<Inside> rows{};
  double before = 0, before_t = 0, first = 0, last = 0;
  int zeros = 0;
  Inside sum{};
  double samples = 0, begin = 0;

  void operator()(const WakeSample& seen);
  void look_for_zero(double pattern, double t);
  void finish(double t);
};

// Each look at the chain adds to the sums
void Gauge::operator()(const WakeSample& seen) {
  const State<double>& now = seen.state;
  const std::vector<double>& e = seen.density;
  const std::size_t peak = peak_index(e), m = packet_half_width;
  double pattern = 0;
  for (std::size_t n = peak > m ? peak - m : 0; n < std::min(peak + m + 1, e.size()); ++n) {
    pattern += (n % 2 ? -1 : 1) * now.y[n];
    sum.area += now.v[n] * now.v[n];
  }
  sum.site += energy_centre(e, peak), sum.energy += window_sum(e, peak), ++samples;
  look_for_zero(pattern, now.t);
  if (now.t - begin >= 20 - 1e-9) finish(now.t);
}

// A straight line between two looks places a zero, which counts if it is an upward one
void Gauge::look_for_zero(double pattern, double t) {
  if (before < 0 && pattern >= 0) {
    last = before_t + (t - before_t) * before / (before - pattern);
    if (zeros++ == 0) first = last;
  }
  before = pattern, before_t = t;
}

// The frequency follows from the number of periods between the first and the last zero
void Gauge::finish(double t) {
  const double omega =
      zeros > 1 ? 2 * std::numbers::pi * (zeros - 1) / (last - first) : std::nan("");
  rows.push_back({(begin + t) / 2, sum.site / samples, sum.energy / samples,
                  sum.area / samples * 2 * std::numbers::pi / omega, omega});
  begin = t, sum = {}, samples = 0, zeros = 0;
}

}  // namespace

// Look at every sample of the run
std::vector<Inside> gauge(const WavesRemoved& impact, double step, double until) {
  Gauge gauge;
  follow_without(impact, step, until, 150, [&](const WakeSample& now) { return gauge(now), true; });
  return gauge.rows;
}

}  // namespace lattice
