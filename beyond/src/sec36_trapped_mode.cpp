/**
# 3.6 What a light defect traps

The array of section 3.6 of James, Kevrekidis and Cuevas (Physica D 251, 2013) has one beam with larger beads, and the
article sees a small part of a packet's energy loosely trapped there. Heavy beads hold almost no energy
(`sec36_cantilever_defect`), but beads a little smaller than the others retain the energy that they trap. In which
motion?

![Energy around the defect against time, and the mode in which it is trapped.](fig:x10)

A light defect has a higher frequency than its neighbours. Breathers of the homogeneous array bifurcate from their
frequency 1; a family of breathers at the defect bifurcates from its own, $\mu^{-1/2}$. We find the member of this
family that has the trapped energy, and compare it with the run. */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"
#include "sec3/array_impact.hpp"
#include "sec36/defect_mode.hpp"

using namespace lattice;

/**
## The run

The array and its units are those of `sec36_cantilever_defect`: an impact of 1 m/s, the defect at $n = 100$. Until the
front of the packet arrives the defect is at rest, so all radii share the run up to there. From 50 to 100 ms we record
the energy on the sites 96 to 104, from 65 ms on the mean distribution over the sites and the frequency of the defect,
from the upward crossings of its velocity through zero. By 100 ms the transmitted packet would reach the end of the
article's array, so this one has a hundred beams more. */
ImpactRun approach(const StruckArray& blow, double step) {
  const std::size_t d = blow.array.defect - 1;
  const auto before = [&](const State<double>& now, const auto&) { return now.y[d - 5] == 0; };
  ImpactRun run = strike(EventCorrected{step}, blow.impact(1, 200, 1), before);
  if (run.end.y[d - 1] != 0 || run.end.y[d - 5] == 0)
    throw NoPacket("the packet does not reach the defect as expected");
  return run;
}

struct Stay {
  std::vector<double> t, near;  // ms, share of the energy on sites 96 to 104
  std::vector<double> density;  // mean share at each site from 65 to 100 ms
  double frequency = 0;         // of the defect in the same time, 1 / tau_c

  double at(double time) const { return near.at(std::size_t(std::lround(2 * (time - 50)))); }
};

Stay stay(const StruckArray& blow, double ratio, ImpactRun run, const RunResolution& r) {
  const Impact impact = blow.impact(ratio, 100.2, r.sample);
  const double energy_in = impact.velocity * impact.velocity / 2, from = 65;
  const std::size_t d = blow.array.defect - 1;
  Stay out{{}, {}, std::vector<double>(impact.chain.sites, 0.0)};
  std::vector<double> time, velocity;
  const auto every = std::size_t(std::lround(2 * r.step / r.sample));
  std::size_t k = 0;
  const auto watch = [&](const State<double>& now, const std::vector<double>& density) {
    const double ms = blow.scales.milliseconds(now.t);
    // Every half millisecond, at the same instants for both steps: a passing packet changes the shares quickly
    if (ms >= 50 + 0.5 * double(out.t.size()) - 1e-6) {
      out.t.push_back(50 + 0.5 * double(out.t.size()));
      out.near.push_back(std::accumulate(density.begin() + std::ptrdiff_t(d) - 4,
                                         density.begin() + std::ptrdiff_t(d) + 5, 0.0) /
                         energy_in);
    }
    // The motion of the defect from samples two steps apart, so that its error covers their distance as well
    if (k++ % every != 0 || ms < from) return;
    time.push_back(now.t), velocity.push_back(now.v[d]);
    for (std::size_t n = 0; n < density.size(); ++n) out.density[n] += density[n] / energy_in;
  };
  follow(EventCorrected{r.step}, impact, run, impact.time, watch);
  for (double& e : out.density) e /= double(time.size());
  const auto turns = upward_crossings(time, velocity);
  out.frequency = 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
  return out;
}

/**
## The energy around the defect (figure x10)

Five radii: two heavy defects, those of figure 24, no defect for comparison, and two light ones. Every run has two
steps, and the difference is the error. From 75 to 100 ms only light defects keep the energy around them.

| radius of the beads | around the defect at 75 ms, of all energy | left at 100 ms of that |
|---|---|---|
| 1.6 | [0.000767683 ± 5e-11](num:sec36_trapped_mode.near_75_16) | [0.726684 ± 7e-8](num:sec36_trapped_mode.kept_16) |
| 1.1 | [0.000806191 ± 4e-11](num:sec36_trapped_mode.near_75_11) | [0.757746 ± 2e-8](num:sec36_trapped_mode.kept_11) |
| 1, no defect | [0.00137600 ± 2e-11](num:sec36_trapped_mode.near_75_without) | [1.01512 ± 2e-9](num:sec36_trapped_mode.kept_without) |
| 0.925 | [0.0470436 ± 3e-9](num:sec36_trapped_mode.near_75_0925) | [0.997443 ± 3e-8](num:sec36_trapped_mode.kept_0925) |
| 0.8 | [0.00616066 ± 2e-12](num:sec36_trapped_mode.near_75_08) | [0.954976 ± 9e-10](num:sec36_trapped_mode.kept_08) | */
using Stays = std::array<Stay, 2>;  // with both steps, the smaller one last

Stays report_trapping(Report& report, const StruckArray& blow) {
  const std::pair<double, const char*> radii[] = {
      {1.6, "_16"}, {1.1, "_11"}, {1, "_without"}, {0.925, "_0925"}, {0.8, "_08"}};
  const std::array<double, 2> steps{report.quick ? 0.2 : 0.1, report.quick ? 0.1 : 0.05};
  std::array<ImpactRun, 2> start;
  parallel_for(2, [&](std::size_t k) { start[k] = approach(blow, steps[k]); });
  std::array<Stays, 5> stays;
  parallel_for("defects", 10, [&](std::size_t i) {
    stays[i / 2][i % 2] = stay(blow, radii[i / 2].first, start[i % 2], {steps[i % 2], steps[0]});
  });

  Table& table = report.table(
      "trapping",
      {number("ratio", "radius of the defect's beads divided by that of the others"),
       number("t", "time", "ms"), estimate("near", "fraction of the energy on sites 96 to 104")});
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const auto& [coarse, fine] = stays[i];
    for (std::size_t k = 0; k < fine.t.size(); ++k)
      table.add({radii[i].first, fine.t[k], compare(coarse.near[k], fine.near[k])});
    const auto kept = [](const Stay& s) { return s.at(100) / s.at(75); };
    report.facts.add(std::string("near_75") + radii[i].second, compare(coarse.at(75), fine.at(75)),
                     "share of the energy");
    report.facts.add(std::string("kept") + radii[i].second, compare(kept(coarse), kept(fine)));
  }
  return stays[3];
}

/**
## The trapped breather

Newton's method follows the family from the frequency of the defect alone (defect_mode.hpp). A run and its breather are
compared at equal energy around the defect, by their frequencies and by the overlap $1-\frac12\sum_n|p_n-q_n|$ of the
distributions $p_n$, $q_n$ of their energy over the nine sites. In the run the energy also moves slowly from side to
side, as in a state that is close to the breather but not equal to it. */
std::vector<double> nine_sites(const std::vector<double>& density, std::size_t middle) {
  std::vector<double> part(density.begin() + std::ptrdiff_t(middle) - 4,
                           density.begin() + std::ptrdiff_t(middle) + 5);
  const double sum = std::accumulate(part.begin(), part.end(), 0.0);
  for (double& x : part) x /= sum;
  return part;
}

double overlap(const std::vector<double>& p, const std::vector<double>& q) {
  double apart = 0;
  for (std::size_t i = 0; i < p.size(); ++i) apart += std::abs(p[i] - q[i]);
  return 1 - apart / 2;
}

/**
How well do we know it? An error of the energy that stayed moves it along its family, so it is computed at two energies.
It should be symmetric about the defect, although we demand evenness in time only. So we also note its residual in the
equations for symmetric orbits. If it shrinks with the precision it is rounding, so the orbit is computed in two
precisions.

| quantity | here |
|---|---|
| frequency of the defect alone | [1.04396](num:sec36_trapped_mode.mode_linear_frequency) |
| of the breather | [1.10607 ± 9e-10](num:sec36_trapped_mode.mode_frequency) |
| of the defect in the run | [1.10583 ± 8e-9](num:sec36_trapped_mode.mode_run_frequency) |
| overlap of breather and run | [0.9439 ± 0.0001](num:sec36_trapped_mode.mode_overlap) |
| residual in the symmetric equations | [6e-17](num:sec36_trapped_mode.mode_asymmetry) | */
template <class T>
double asymmetry(const Shooting<double>& problem, const Orbit<double>& orbit) {
  Shooting<T> in_t{problem.chain, problem.symmetry, T(problem.omega)};
  const Orbit<T> mode = newton(in_t, orbit);
  in_t.symmetry = site_centred(mode_sites);
  const Evaluation<T> here = in_t.evaluate(in_t.reduce(mode.start), {}, false);
  return double(sup(here.residual) / mode.amplitude);
}

void report_mode(Report& report, const StruckArray& blow, const Stays& stays) {
  constexpr double ratio = 0.925;
  const auto& [coarse, fine] = stays;
  const Estimate share = compare(coarse.at(75), fine.at(75));
  const double energy_in = blow.struck_velocity() * blow.struck_velocity() / 2;
  Shooting<double> problem = mode_problem(blow.array, ratio);
  const Orbit<double> orbit = mode_of_energy(problem, share.value * energy_in);
  const Orbit<double> moved = mode_of_energy(problem, (share.value + share.error) * energy_in);

  // Site by site
  const std::size_t middle = mode_sites / 2, defect = blow.array.defect - 1;
  const auto mode = [&](std::size_t instants) {
    return nine_sites(mean_density(problem, orbit, instants), middle);
  };
  const auto run = nine_sites(fine.density, defect), breather = mode(256);
  Table& table = report.table(
      "trapped_mode",
      {count("n", "site"), number("run", "fraction of the energy in the run of the impact"),
       number("mode", "fraction of the energy in the breather"),
       number("y", "displacement of the breather when all beads are at rest", "um")});
  for (std::size_t i = 0; i < breather.size(); ++i)
    table.add({defect - 3 + i, run[i], breather[i],
               orbit.start.y[middle - 4 + i] * blow.scales.xi() * 1e6});

  // Frequencies, overlap, symmetry
  problem.omega = orbit.omega;
  report.facts.add("mode_frequency", compare(moved.omega, orbit.omega), "1 / tau_c");
  report.facts.add("mode_run_frequency", compare(coarse.frequency, fine.frequency), "1 / tau_c");
  report.facts.add("mode_linear_frequency", exact(blow.array.linear_frequency(ratio)), "1 / tau_c");
  report.facts.add("mode_overlap", compare(overlap(nine_sites(coarse.density, defect), mode(128)),
                                           overlap(run, breather)));
  report.facts.add("mode_asymmetry",
                   compare(asymmetry<double>(problem, orbit), asymmetry<Wide>(problem, orbit)));
}

/**
## Differences and limits

One impact, five radii, fifty milliseconds. A heavy defect is slower than its neighbours; at 1.6 radii the packet drives
it far above its own frequency, and what stays lies before it. We have not examined whether heavy defects have breathers
of their own that other waves could excite. */
void reproduce(Report& report) {
  StruckArray blow;
  blow.array.sites += 100;
  report_mode(report, blow, report_trapping(report, blow));
}

/**
## Try it

1. *Easy.* How much of what arrives does the defect keep? `build/bin/sec36_cantilever_defect run --ratio 0.925` gives
   `net_near` = 0.10858. Hint: its own frequency lies between that of its neighbours and the packet's.
2. *Harder.* At 0.8 radii the defect's own frequency is that of the packet, and yet less stays:
   `build/bin/sec36_cantilever_defect run --ratio 0.8` gives `net_near` = 0.01422. Hint: above which frequency do the
   breathers of this defect lie?
3. *Open.* Is the motion from side to side one of the breather's Floquet multipliers? */
int main(int argc, char** argv) {
  return run({"sec36_trapped_mode", "3.6", "What a light defect traps (section 3.6)", reproduce},
             argc, argv);
}
