#pragma once
/**
# Scattering at a defect

In section 3.6 one cantilever of an array, the defect, has larger beads. A packet runs into it, and after a
while its energy is divided among three parts of the array: the sites before the defect, the nine around
it, and those behind. All shares refer to the energy of the impact, so that their sum differs from one by
the drift of the run.

Much of the energy does not come near the defect in this while, but stays behind in the wave train near the
struck end. If a share $1-r_0$ passes the same place in an array without a defect, then the defect divides that
share as
$$\frac{r-r_0}{1-r_0} + \frac{d}{1-r_0} + \frac{t}{1-r_0} = 1,$$
with $r$, $d$, $t$ the shares of the three parts. These are the *net* reflected, remaining and transmitted
energies. */

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec3/array_impact.hpp"

namespace lattice {

/// Shares of the impact's energy before, near and behind the defect.
struct EnergyShares {
  double reflected = 0, near = 0, transmitted = 0;

  /// One, but for the drift.
  double sum() const { return reflected + near + transmitted; }
  /// What becomes of the energy that passes the defect's place in the run `without` it.
  EnergyShares net(const EnergyShares& without) const {
    const double arriving = 1 - without.reflected;
    return {(reflected - without.reflected) / arriving, near / arriving, transmitted / arriving};
  }
};

/// Shares of the impact's energy: sites 1 to 95, 96 to 104, and from 105 on if the defect is at 100.
EnergyShares energy_shares(const StruckArray& blow, const std::vector<double>& density);

/**
Until the front of the packet arrives the defect is exactly at rest, so all runs that differ in the defect
alone share the way there. `approach` makes it: it ends when the fifth site before the defect has begun to
move, and checks that the one next to the defect has not. Throws NoPacket if this is not so within
`longest`, in ms. */
ImpactRun approach(const StruckArray& blow, double step, double longest = 200);

/// The division 10 ms before the end and at the end. `scatter` goes on from `approach` to `end` (ms).
struct Scattering {
  EnergyShares earlier, later;
};

/// `ratio` is that of the defect's radius to the usual one; throws FarEndReached.
Scattering scatter(const StruckArray& blow, double ratio, ImpactRun run, double step, double end);

/**
Every point of a map over the size of the defect is computed with two steps. The common way and the run
without a defect are computed only once for each step. */
struct ScatteringSetup {
  StruckArray blow;
  std::array<double, 2> steps;  ///< in units of tau_c, the larger one first
  double end;                   ///< ms
  std::array<ImpactRun, 2> start{};
  std::array<EnergyShares, 2> without{};

  ScatteringSetup(const StruckArray& how, const std::array<double, 2>& both_steps, double end_time)
      : blow(how), steps(both_steps), end(end_time) {
    for (std::size_t k : {0, 1}) {
      start[k] = approach(blow, steps[k]);
      without[k] = scatter(blow, 1, start[k], steps[k], end).later;
    }
  }
};

/**
The result for one defect are the shares with their errors; `near_earlier` belongs to ten milliseconds
before the end. */
struct Fractions {
  Estimate reflected, near, transmitted, near_earlier;
  Estimate net_reflected, net_near, net_transmitted;
  Estimate budget;  ///< sum of the shares less one, and the same at the larger step

  struct Named {
    const char *name, *unit;
    Estimate share;
    const char* meaning;
    const char* judged = "";  ///< against what its error is to be judged, if not itself
  };
  /// All but the energy budget, as tables call them.
  std::vector<Named> named() const {
    const char *all = "share of the energy", *arriving = "share of what arrives";
    return {{"reflected", all, reflected,
             "energy of the sites up to the fifth before the defect, at the end"},
            {"near", all, near, "energy of the defect and four sites on either side, at the end"},
            {"transmitted", all, transmitted,
             "energy from the fifth site behind the defect, at the end"},
            {"near_earlier", all, near_earlier, "energy about the defect 10 ms before the end"},
            {"net_reflected", arriving, net_reflected,
             "what comes back of the energy that would pass in an array without a defect",
             ", against the neighbouring rows: it is zero by definition without a defect"},
            {"net_near", arriving, net_near,
             "what stays about the defect of the energy that would pass"},
            {"net_transmitted", arriving, net_transmitted,
             "what passes the defect of the energy that would pass without it"}};
  }
};

/**
The run with the smaller step gives the values, its difference from the other one the errors. */
Fractions fractions(const ScatteringSetup& at, double ratio);

/**
## What stays

The article finds that a small part of the energy remains loosely trapped near the defect. To see what it
is we record the energy around the defect as a function of time, the mean distribution of the energy, and
the frequency of the defect, from the upward crossings of its velocity through zero. A packet that is
reflected leaves its energy *before* the defect, so the nine sites that end at the defect are recorded as
well as the nine around it, and the strongest push of the second contact before it. */
struct Stay {
  std::vector<double> t, near;   ///< ms, share of the energy on sites 96 to 104
  std::vector<double> density;   ///< mean share at each site from 65 to 100 ms
  double frequency = 0;          ///< of the defect in the same time, 1 / tau_c
  std::vector<double> before{};  ///< share of the energy on sites 92 to 100, at the times t
  double push = 0;               ///< strongest push of the contact 98 | 99 from 70 to 80 ms, N

  /// A recorded share at a time in ms.
  double at(double time, std::vector<double> Stay::*of = &Stay::near) const {
    const auto i = std::lower_bound(t.begin(), t.end(), time - 1e-9) - t.begin();
    return (this->*of).at(std::size_t(i));
  }
  /// What is left at 100 ms of the energy at 75 ms.
  double kept(std::vector<double> Stay::*of = &Stay::near) const {
    return at(100, of) / at(75, of);
  }
};

/// Angular frequency of a bead: its whole turns between the first and the last upward crossing of its
/// velocity through zero, over their time.
double frequency_of(const Watched& bead);

/**
The run is watched from 50 to 100 ms. Energies at a given time can be compared between two steps only if
both runs are sampled at the same instants, because a passing packet changes them by several per cent
from one sample to the next. The frequency is read from samples two steps apart, so that its error covers
their distance as well. */
Stay stay(const StruckArray& blow, double ratio, ImpactRun run, const RunResolution& r);

}  // namespace lattice
