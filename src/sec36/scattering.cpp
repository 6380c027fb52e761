#include "sec36/scattering.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace lattice {

// Divide the energy among the sites before the defect, the nine around it, and those behind
EnergyShares energy_shares(const StruckArray& blow, const std::vector<double>& density) {
  const std::size_t d = blow.array.defect;
  const auto part = [&](std::size_t from, std::size_t to) {
    return std::accumulate(density.begin() + std::ptrdiff_t(from),
                           density.begin() + std::ptrdiff_t(to), 0.0) /
           (blow.struck_velocity() * blow.struck_velocity() / 2);
  };
  return {part(0, d - 5), part(d - 5, d + 4), part(d + 4, density.size())};
}

// Stop when the front is five sites before the defect, whose neighbour must still be at rest
ImpactRun approach(const StruckArray& blow, double step, double longest) {
  const std::size_t d = blow.array.defect - 1;
  const auto there = [&](const State<double>& now, const auto&) { return now.y[d - 5] == 0; };
  ImpactRun run = strike(EventCorrected{step}, blow.impact(1, longest, 1), there);
  if (run.end.y[d - 1] != 0 || run.end.y[d - 5] == 0)
    throw NoPacket("the packet does not come to the defect as expected");
  return run;
}

// Go on with the defect in place; a second look, ten milliseconds earlier, tells what still changes
Scattering scatter(const StruckArray& blow, double ratio, ImpactRun run, double step, double end) {
  const Impact impact = blow.impact(ratio, end, blow.scales.time(end));
  const auto on = [&](double until) {
    follow(EventCorrected{step}, impact, run, blow.scales.time(until));
    return energy_shares(blow, run.density);
  };
  const EnergyShares earlier = on(end - 10);
  return {earlier, on(end)};
}

Fractions fractions(const ScatteringSetup& at, double ratio) {
  // Scatter with both steps: the finer gives the shares, its distance from the other the errors
  std::array<Scattering, 2> run;
  std::array<EnergyShares, 2> now, net;
  for (std::size_t k : {0, 1}) {
    run[k] = scatter(at.blow, ratio, at.start[k], at.steps[k], at.end);
    now[k] = run[k].later;
    net[k] = now[k].net(at.without[k]);
  }
  const auto both = [](const std::array<EnergyShares, 2>& l, double EnergyShares::*of) {
    return compare(l[0].*of, l[1].*of);
  };
  return {both(now, &EnergyShares::reflected),   both(now, &EnergyShares::near),
          both(now, &EnergyShares::transmitted), compare(run[0].earlier.near, run[1].earlier.near),
          both(net, &EnergyShares::reflected),   both(net, &EnergyShares::near),
          both(net, &EnergyShares::transmitted), {now[1].sum() - 1, std::abs(now[0].sum() - 1)}};
}

// The frequency of a bead, from a whole number of its turns
double frequency_of(const Watched& bead) {
  const auto turns = upward_crossings(bead.t, bead.v);
  return 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
}

// Watch what remains near the defect after the packet has left
Stay stay(const StruckArray& blow, double ratio, ImpactRun run, const RunResolution& r) {
  const Impact impact = blow.impact(ratio, 100.2, r.sample);
  const double energy_in = impact.velocity * impact.velocity / 2, from = 65;
  const std::size_t d = blow.array.defect - 1;
  Stay out{{}, {}, std::vector<double>(impact.chain.sites, 0.0)};
  Watched bead;
  const auto every = std::size_t(std::lround(2 * r.step / r.sample));
  std::size_t k = 0;
  const auto watch = [&](const State<double>& now, const std::vector<double>& density) {
    const double time = blow.scales.milliseconds(now.t);
    // The energy near the defect every half millisecond, at the same instants for both steps
    if (time >= 50 + 0.5 * double(out.t.size()) - 1e-6) {
      out.t.push_back(50 + 0.5 * double(out.t.size()));
      out.near.push_back(energy_shares(blow, density).near);
      out.before.push_back(window_sum(density, d - 4, 4) / energy_in);
    }
    if (time >= 70 && time <= 80)
      out.push = std::max(
          out.push, contact_push(impact.chain, now.y.data(), d - 1) * blow.scales.unit_force());
    // From 65 ms on, the motion of the defect and where the energy sits on average
    if (k++ % every != 0 || time < from) return;
    bead.t.push_back(now.t), bead.v.push_back(now.v[d]);
    for (std::size_t n = 0; n < density.size(); ++n) out.density[n] += density[n] / energy_in;
  };
  follow(EventCorrected{r.step}, impact, run, impact.time, watch);
  for (double& e : out.density) e /= double(bead.t.size());
  out.frequency = frequency_of(bead);
  return out;
}

}  // namespace lattice
