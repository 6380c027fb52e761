#include "sec4/modulation.hpp"

#include "lattice/numerics/progress.hpp"
#include "sec4/nls.hpp"

#include <algorithm>

namespace lattice {

// Follow the packet's centre for sixty units of time
static Modulated look_closely(const Splitting& method, const Chain& ring, State<double> state) {
  Modulated out{std::move(state)};
  const auto look = [&](const State<double>& now) {
    out.density = energy_density(ring, now);
    out.t.push_back(now.t);
    out.centre.push_back(packet_sample(now.t, out.density).centre);
  };
  out.drift = evolve(method, ring, out.end, 60, 1, look).energy_drift;
  out.shown = snapshot(ring, out.end);
  return out;
}

// Let the modulation grow, then look closely during the last part of the run
Modulated modulate(const ModulatedPhonon& phonon, double time, double step) {
  const Chain ring = phonon.ring();
  const Splitting method{blanes_moan_6_14(), step};
  State<double> state = phonon.start();
  const Run wait = evolve(method, ring, state, time - 60, 60);
  Modulated out = look_closely(method, ring, std::move(state));
  out.drift = std::max(wait.energy_drift, out.drift);
  return out;
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

// Two steps side by side, as long as they give the same state
RingPair run_ring_pair(const ModulatedPhonon& phonon, double longest,
                       const std::array<double, 2>& steps, double patience) {
  const double interval = 50;
  const Chain ring = phonon.ring();
  std::array<State<double>, 2> state{phonon.start(), phonon.start()};
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
    for (std::size_t k : {0, 1}) out.packet[k] = look_closely(method(k), ring, state[k]);
  }
  out.agree = together ? exact(state[1].t) : Estimate{state[1].t, interval};
  return out;
}

// What is narrowest and highest on the way
Estimate RingPair::narrowest() const {
  const auto narrower = [](const auto& a, const auto& b) {
    return a[1].participation < b[1].participation;
  };
  const auto& at = *std::min_element(samples.begin(), samples.end(), narrower);
  return compare(at[0].participation, at[1].participation);
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

// By the wavenumbers that fit on the ring
std::vector<double> unstable_band(const ModulatedPhonon& phonon, std::size_t every) {
  const auto phi = [&](double q) { return coefficients(q, phonon.d, phonon.s).phi; };
  std::vector<double> band;
  for (std::size_t k = every; 2 * k < phonon.sites; k += every) {
    const double q = 2 * std::numbers::pi * double(k) / double(phonon.sites);
    if (phi(q) > 0) band.push_back(q);
  }
  std::stable_sort(band.begin(), band.end(), [&](double a, double b) { return phi(a) > phi(b); });
  return band;
}

// The state of the wave at the end, in numbers; the slope of the centre's path is its speed
Formed formed(const Modulated& coarse, const Modulated& fine) {
  const auto both = [&](auto of) { return compare(of(coarse.density), of(fine.density)); };
  const auto peak = [](const std::vector<double>& e) {
    return *std::max_element(e.begin(), e.end()) / (total(e) / double(e.size()));
  };
  const auto share = [](const std::vector<double>& e) {
    return participation(e) / double(e.size());
  };
  const Line rough = fit_line(coarse.t, coarse.centre), best = fit_line(fine.t, fine.centre);
  return {both(peak),
          both(share),
          {best.slope, best.slope_error + std::abs(best.slope - rough.slope)},
          both(packet_width)};
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
  const double interval = 50;
  return {{alone, interval}, {split, interval}, {apart, interval}};
}

}  // namespace lattice
