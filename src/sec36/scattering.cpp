#include "sec36/scattering.hpp"

namespace lattice {

// Divide the energy among the sites before the defect, the nine around it, and those behind
Ledger ledger_of(const ArrayImpact& impact, const std::vector<double>& density) {
  const std::size_t d = impact.array.defect;
  const auto part = [&](std::size_t from, std::size_t to) {
    return std::accumulate(density.begin() + std::ptrdiff_t(from),
                           density.begin() + std::ptrdiff_t(to), 0.0) /
           (impact.struck_velocity() * impact.struck_velocity() / 2);
  };
  return {part(0, d - 5), part(d - 5, d + 4), part(d + 4, density.size())};
}

// Stop when the front is five sites before the defect, whose neighbour must still be at rest
State<double> approach(const ArrayImpact& impact, double step, double patience) {
  const auto chain = cantilever_chain(impact.array, 1);
  const std::size_t d = impact.array.defect - 1;
  State<double> state = struck(chain.sites, impact.struck_velocity());
  evolve(ContactAware{step}, chain, state, impact.time(patience), 1,
         [&](const State<double>& now) { return now.y[d - 5] == 0; });
  if (state.y[d - 1] != 0 || state.y[d - 5] == 0)
    throw NoPacket("the packet does not come to the defect as expected");
  return state;
}

// Go on with the defect in place; a second look, ten milliseconds earlier, tells what still changes
Scattering scatter(const ArrayImpact& impact, double ratio, State<double> state, double step,
                   double end) {
  const auto chain = cantilever_chain(impact.array, ratio);
  const auto on = [&](double until) {
    const double duration = impact.time(until) - state.t;
    evolve(ContactAware{step}, chain, state, duration, duration, Unobserved{});
    return ledger_of(impact, energy_density(chain, state));
  };
  const Ledger earlier = on(end - 10);
  return {earlier, on(end)};
}

Fractions fractions(const Workshop& at, double ratio) {
  // Scatter with both steps: the finer gives the shares, its distance from the other the errors
  std::array<Scattering, 2> run;
  std::array<Ledger, 2> now, net;
  for (std::size_t k : {0, 1}) {
    run[k] = scatter(at.impact, ratio, at.start[k], at.steps[k], at.end);
    now[k] = run[k].later;
    net[k] = now[k].net(at.without[k]);
  }
  const auto both = [](const std::array<Ledger, 2>& l, double Ledger::*of) {
    return compare(l[0].*of, l[1].*of);
  };
  return {both(now, &Ledger::reflected),   both(now, &Ledger::near),
          both(now, &Ledger::transmitted), compare(run[0].earlier.near, run[1].earlier.near),
          both(net, &Ledger::reflected),   both(net, &Ledger::near),
          both(net, &Ledger::transmitted), {now[1].sum() - 1, std::abs(now[0].sum() - 1)}};
}

Criterion almost_total(const Estimate& reflected) {
  return within(reflected, 0.95, 1);
}

Criterion partial(const Estimate& transmitted) {
  return within(transmitted, 0.1, 0.9);
}

// The frequency of a bead, from a whole number of its turns
double frequency_of(const Watched& bead) {
  const auto turns = upward_crossings(bead.t, bead.v);
  return 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
}

// Watch what remains near the defect after the packet has left
Stay stay(const ArrayImpact& impact, double ratio, State<double> state, const Resolution& r) {
  const auto chain = cantilever_chain(impact.array, ratio);
  const double energy_in = impact.struck_velocity() * impact.struck_velocity() / 2, from = 65;
  const std::size_t d = impact.array.defect - 1;
  Stay out{{}, {}, std::vector<double>(chain.sites, 0.0)};
  Watched bead;
  const auto every = std::size_t(std::lround(2 * r.step / r.sample));
  std::size_t k = 0;
  const auto watch = [&](const State<double>& now) {
    const double time = impact.milliseconds(now.t);
    const auto density = energy_density(chain, now);
    // The energy near the defect every half millisecond, at the same instants for both steps
    if (time >= 50 + 0.5 * double(out.t.size()) - 1e-6) {
      out.t.push_back(50 + 0.5 * double(out.t.size()));
      out.near.push_back(ledger_of(impact, density).near);
    }
    // From 65 ms on, the motion of the defect and where the energy sits on average
    if (k++ % every != 0 || time < from) return;
    bead.t.push_back(now.t), bead.v.push_back(now.v[d]);
    for (std::size_t n = 0; n < density.size(); ++n) out.density[n] += density[n] / energy_in;
  };
  evolve(ContactAware{r.step}, chain, state, impact.time(100.2) - state.t, r.sample, watch);
  for (double& e : out.density) e /= double(bead.t.size());
  out.frequency = frequency_of(bead);
  return out;
}

// Trapped energy stays, is more than a passing packet leaves behind, and sits at the defect
Criterion trapped_at(std::size_t defect, const std::array<Stay, 2>& stay,
                     const std::array<Stay, 2>& without) {
  const auto off = [&](const Stay& s) {
    const auto begin = s.density.begin() + std::ptrdiff_t(defect) - 4;
    return std::abs(std::max_element(begin, begin + 9) - begin - 4);
  };
  const auto there = [](const std::array<Stay, 2>& s) { return compare(s[0].at(75), s[1].at(75)); };
  return {above("kept", compare(stay[0].kept(), stay[1].kept()), 0.95),
          above("over_wake", quotient(there(stay), there(without)), 1),
          below("top_from_defect", compare(off(stay[0]), off(stay[1])), 1.5)};
}

}  // namespace lattice
