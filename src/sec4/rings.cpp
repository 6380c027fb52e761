#include "sec4/rings.hpp"

#include <algorithm>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

static constexpr double interval = 50;  // between two looks at a pair of runs

static double peak_over_mean(const std::vector<double>& e) {
  return *std::max_element(e.begin(), e.end()) / (total(e) / double(e.size()));
}

// Averaged over five sites; from the top down to half of its height, on either side, between two sites
double packet_width(const std::vector<double>& density) {
  const std::size_t n = density.size();
  std::vector<double> mean(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 5; ++k) mean[i] += density[(i + n + k - 2) % n] / 5;
  const auto top = std::size_t(std::max_element(mean.begin(), mean.end()) - mean.begin());
  const double half = mean[top] / 2;
  double width = 0;
  for (std::size_t step : {std::size_t(1), n - 1}) {
    std::size_t k = 0, at = top;
    for (; k < n && mean[at] > half; ++k) at = (at + step) % n;
    if (k == n) return double(n);
    const double inside = mean[(at + n - step) % n];
    width += double(k) - (half - mean[at]) / (inside - mean[at]);
  }
  return std::min(width, double(n));
}

// The two richest windows on the ring that have no site in common
RingSample ring_sample(const Chain& ring, const State<double>& state) {
  const std::vector<double> e = energy_density(ring, state);
  const std::size_t n = e.size(), half_width = envelope_half_width;
  std::vector<double> content(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k <= 2 * half_width; ++k) content[i] += e[(i + n + k - half_width) % n];
  const auto first =
      std::size_t(std::max_element(content.begin(), content.end()) - content.begin());
  double second = 0;
  for (std::size_t k = 2 * half_width + 1; k + 2 * half_width < n; ++k)
    second = std::max(second, content[(first + k) % n]);
  const double peak = *std::max_element(e.begin(), e.end()) * double(n) / total(e);
  const double sharing = participation(e);
  return {
      state.t,        peak, sharing, second / content[first], peak > 5 && 2 * sharing < double(n),
      packet_width(e)};
}

WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state) {
  WatchedRing out{std::move(state)};
  const auto look = [&](const State<double>& now) {
    out.density = energy_density(ring, now);
    out.t.push_back(now.t);
    out.centre.push_back(packet_sample(now.t, out.density).centre);
  };
  out.drift = evolve(method, ring, out.end, 60, 1, look).energy_drift;
  out.shown = snapshot(ring, out.end);
  return out;
}

// The slope of the centre's path is its speed
Formed formed(const WatchedRing& coarse, const WatchedRing& fine) {
  const auto both = [&](auto of) { return compare(of(coarse.density), of(fine.density)); };
  const auto share = [](const std::vector<double>& e) {
    return participation(e) / double(e.size());
  };
  const Line rough = fit_line(coarse.t, coarse.centre), best = fit_line(fine.t, fine.centre);
  return {both(peak_over_mean),
          both(share),
          {best.slope, best.slope_error + std::abs(best.slope - rough.slope)},
          both(packet_width)};
}

// Two steps side by side, as long as they give the same state
RingPair side_by_side(const Chain& ring, const State<double>& start, double longest,
                      const std::array<double, 2>& steps, double patience) {
  std::array<State<double>, 2> state{start, start};
  RingPair out;
  const auto method = [&](std::size_t k) { return Splitting{blanes_moan_6_14(), steps[k]}; };
  bool together = true;
  Progress progress("ring", 1);
  while (together && state[1].t < longest && !(state[1].t > patience * out.gathered)) {
    std::array<RingSample, 2> seen;
    for (std::size_t k : {0, 1}) {
      evolve(method(k), ring, state[k], interval, interval);
      seen[k] = ring_sample(ring, state[k]);
    }
    progress.reach(state[1].t / longest);
    together = distance(state[0], state[1]) < 0.1;
    if (!together) break;
    out.samples.push_back(seen);
    if (!std::isnan(out.gathered) || !seen[0].gathered || !seen[1].gathered) continue;
    out.gathered = seen[1].t;
    for (std::size_t k : {0, 1}) out.packet[k] = watch_packet(method(k), ring, state[k]);
  }
  out.agree = together ? exact(state[1].t) : Estimate{state[1].t, interval};
  return out;
}

// What is read from a pair
Estimate RingPair::gathering() const {
  return {gathered, interval};
}

Formed RingPair::formed() const {
  return lattice::formed(packet[0], packet[1]);
}

Estimate RingPair::width() const {
  Estimate least{std::numeric_limits<double>::infinity(), 0};
  for (const auto& [coarse, fine] : samples)
    if (fine.t >= gathered && fine.t <= 1.5 * gathered && fine.width < least.value)
      least = compare(coarse.width, fine.width);
  return least;
}

Estimate RingPair::highest() const {
  const auto lower = [](const auto& a, const auto& b) {
    return a[1].peak_over_mean < b[1].peak_over_mean;
  };
  const auto& at = *std::max_element(samples.begin(), samples.end(), lower);
  return compare(at[0].peak_over_mean, at[1].peak_over_mean);
}

bool RingPair::travels() const {
  if (std::isnan(gathered)) return false;
  const Formed p = formed();
  return p.peak_over_mean.value - p.peak_over_mean.error > 5 &&
         p.width.value + p.width.error < double(packet[1].density.size()) / 4 &&
         p.speed.value > p.speed.error;
}

// One pulse on its way round the ring, then two, and in the end two that stand apart
PulseSplits pulse_splits(const RingPair& pair, double round) {
  double since = std::nan(""), alone = 0, split = std::nan(""), apart = std::nan("");
  for (const auto& [coarse, fine] : pair.samples) {
    if (!(fine.t >= pair.gathered)) continue;
    const bool one = coarse.second < 0.5 && fine.second < 0.5;
    const bool two = coarse.second >= 0.5 && fine.second >= 0.5;
    if (std::isnan(split)) {
      if (one && std::isnan(since)) since = fine.t;
      if (one) alone = std::max(alone, fine.t - since);
      if (two && alone >= round) split = fine.t;
      if (two) since = std::nan("");
    }
    if (!std::isnan(split) && std::isnan(apart) && two && coarse.gathered && fine.gathered)
      apart = fine.t;
  }
  return {{alone, interval}, {split, interval}, {apart, interval}};
}

}  // namespace lattice
