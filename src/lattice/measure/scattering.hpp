#pragma once
/**
# Scattering at a defect

In section 3.6 one cantilever of an array, the defect, has larger beads. A packet runs into it, and after a
while its energy is divided among three parts of the array: the sites before the defect, the nine around
it, and those behind. All shares refer to the energy of the impact, so that their sum differs from one by
the drift of the run.

Much of the energy never comes near the defect, because it stays behind in the wave train near the struck
end. If a share $1-r_0$ passes the same place in an array without a defect, then the defect divides that
share as
$$\frac{r-r_0}{1-r_0} + \frac{d}{1-r_0} + \frac{t}{1-r_0} = 1,$$
with $r$, $d$, $t$ the shares of the three parts. These are the *net* reflected, remaining and transmitted
energies. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "lattice/measure/array_impact.hpp"
#include "lattice/numbers/criterion.hpp"
#include "lattice/numbers/estimate.hpp"

namespace lattice {

/// Shares of the impact's energy before, near and behind the defect.
struct Ledger {
  double reflected = 0, near = 0, transmitted = 0;

  double sum() const { return reflected + near + transmitted; }
  /// What becomes of the energy that passes the defect's place in the run `without` it.
  Ledger net(const Ledger& without) const {
    const double arriving = 1 - without.reflected;
    return {(reflected - without.reflected) / arriving, near / arriving, transmitted / arriving};
  }
};

/// Shares of the impact's energy: sites 1 to 95, 96 to 104, and from 105 on if the defect is at 100.
inline Ledger ledger_of(const ArrayImpact& impact, const std::vector<double>& density) {
  const std::size_t d = impact.array.defect;
  const auto part = [&](std::size_t from, std::size_t to) {
    return std::accumulate(density.begin() + std::ptrdiff_t(from),
                           density.begin() + std::ptrdiff_t(to), 0.0) /
           (impact.struck_velocity() * impact.struck_velocity() / 2);
  };
  return {part(0, d - 5), part(d - 5, d + 4), part(d + 4, density.size())};
}

/**
Until the front of the packet arrives the defect is exactly at rest, so all runs that differ in the defect
alone share the way there. `approach` makes it: it ends when the fifth site before the defect has begun to
move, and checks that the one next to the defect has not. Throws NoPacket if this is not so within
`patience`, in ms. */
inline State<double> approach(const ArrayImpact& impact, double step, double patience = 200) {
  const auto chain = cantilever_chain(impact.array, 1);
  const std::size_t d = impact.array.defect - 1;
  State<double> state = struck(chain.sites, impact.struck_velocity());
  evolve(ContactAware{step}, chain, state, impact.time(patience), 1,
         [&](const State<double>& now) { return now.y[d - 5] == 0; });
  if (state.y[d - 1] != 0 || state.y[d - 5] == 0)
    throw NoPacket("the packet does not come to the defect as expected");
  return state;
}

/// The ledger 10 ms before the end and at the end. `scatter` goes on from `approach` to `end` (ms).
struct Scattering {
  Ledger earlier, later;
};

inline Scattering scatter(const ArrayImpact& impact, double ratio, State<double> state, double step,
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

/**
Every point of a map over the size of the defect is computed with two steps. The common way and the run
without a defect are computed only once for each step. */
struct Workshop {
  ArrayImpact impact;
  std::array<double, 2> steps;  ///< in units of tau_c, the larger one first
  double end;                   ///< ms
  std::array<State<double>, 2> start{};
  std::array<Ledger, 2> without{};

  Workshop(const ArrayImpact& how, const std::array<double, 2>& both_steps, double end_time)
      : impact(how), steps(both_steps), end(end_time) {
    for (std::size_t k : {0, 1}) {
      start[k] = approach(impact, steps[k]);
      without[k] = scatter(impact, 1, start[k], steps[k], end).later;
    }
  }
};

/**
The result for one defect are the shares with their errors; `near_earlier` belongs to ten milliseconds
before the end. */
struct Fractions {
  Estimate reflected, near, transmitted, near_earlier;
  Estimate net_reflected, net_near, net_transmitted;
  Estimate ledger;  ///< sum of the shares less one, and the same at the larger step

  struct Named {
    const char *name, *unit;
    Estimate share;
    const char* judged = "";  ///< against what its error is to be judged, if not itself
  };
  /// All but the ledger, as tables call them.
  std::vector<Named> named() const {
    const char *all = "share of the energy", *arriving = "share of what arrives";
    return {{"reflected", all, reflected},
            {"near", all, near},
            {"transmitted", all, transmitted},
            {"near_earlier", all, near_earlier},
            {"net_reflected", arriving, net_reflected,
             ", against the neighbouring rows: it is zero by definition without a defect"},
            {"net_near", arriving, net_near},
            {"net_transmitted", arriving, net_transmitted}};
  }
};

/**
The run with the smaller step gives the values, its difference from the other one the errors. */
inline Fractions fractions(const Workshop& at, double ratio) {
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

/**
A reflection is almost total if more than 95 per cent of what arrives is reflected, and partial if between a
tenth and nine tenths of it is transmitted; the bounds are ours. */
/// From the net reflected energy.
inline Criterion almost_total(const Estimate& reflected) {
  return within(reflected, 0.95, 1);
}
/// From the net transmitted energy.
inline Criterion partial(const Estimate& transmitted) {
  return within(transmitted, 0.1, 0.9);
}

/**
## What stays

The article finds that a small part of the energy remains loosely trapped near the defect. To see what it
is we record the energy around the defect as a function of time, the mean distribution of the energy, and
the frequency of the defect, from the upward passages of its velocity through zero. */
struct Stay {
  std::vector<double> t, near;  ///< ms, share of the energy on sites 96 to 104
  std::vector<double> density;  ///< mean share at each site from 65 to 100 ms
  double frequency = 0;         ///< of the defect in the same time, 1 / tau_c

  double at(double time) const {
    return near.at(std::size_t(std::lower_bound(t.begin(), t.end(), time - 1e-9) - t.begin()));
  }
  /// What is left at 100 ms of the energy at 75 ms.
  double kept() const { return at(100) / at(75); }
};

/// Angular frequency of a bead: its whole turns between the first and the last upward passage of its
/// velocity through zero, over their time.
inline double frequency_of(const Watched& bead) {
  const auto turns = upward_crossings(bead.t, bead.v);
  return 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
}

/**
The run is watched from 50 to 100 ms. Energies at a given time can be compared between two steps only if
both runs are sampled at the same instants, because a passing packet changes them by several per cent
from one sample to the next. The frequency is read from samples two steps apart, so that its error covers
their distance as well. */
inline Stay stay(const ArrayImpact& impact, double ratio, State<double> state,
                 const Resolution& r) {
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
    if (time >= 50 + 0.5 * double(out.t.size()) - 1e-6) {
      out.t.push_back(50 + 0.5 * double(out.t.size()));
      out.near.push_back(ledger_of(impact, density).near);
    }
    if (k++ % every != 0 || time < from) return;
    bead.t.push_back(now.t), bead.v.push_back(now.v[d]);
    for (std::size_t n = 0; n < density.size(); ++n) out.density[n] += density[n] / energy_in;
  };
  evolve(ContactAware{r.step}, chain, state, impact.time(100.2) - state.t, r.sample, watch);
  for (double& e : out.density) e /= double(bead.t.size());
  out.frequency = frequency_of(bead);
  return out;
}

/**
We call energy trapped if at least 95 per cent of it stays from 75 to 100 ms, if there is more of it than
in the wake that a packet leaves in an array without a defect, and if it is densest at the defect or next
to it. */
/// From runs with two steps, the finer one second; `defect` counts sites from zero.
inline Criterion trapped_at(std::size_t defect, const std::array<Stay, 2>& stay,
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
