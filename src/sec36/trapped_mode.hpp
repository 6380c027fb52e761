#pragma once
/**
# 3.6 Does energy stay at the defect? (figure x10)

After the packet has been reflected, the article sees a small part of the energy loosely trapped near
the defect. This part of the chapter belongs to the program sec36_cantilever_defect.cpp. It follows the
energy around defects of five radii, and finds the state in which a light defect keeps it. */

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"
#include "sec36/defect_mode.hpp"
#include "sec36/scattering.hpp"

namespace trapped {

using namespace lattice;

/**
The word *loosely* and the word *small* have no number, so we measure. What a reflected packet leaves is on
the side from which it came: we answer with the share of the energy on the nine sites that end at the
defect, at 75 ms, and compare it with the same sites in an array without a defect, where the packet has only
left its wake. The facts also have what is left of it at 100 ms, and the push of a contact there.

Another question is whether a defect can hold energy firmly, on its own beads and for longer than the wake of a packet
lasts. From 75 to 100 ms beads of 0.925 radii keep [0.997443](num:sec36_cantilever_defect.kept_0925) of the energy
around them, most of it on the defect itself, and those of 0.8 radii [0.954976](num:sec36_cantilever_defect.kept_08);
those of 1.6 radii keep [0.726684](num:sec36_cantilever_defect.kept_16), of less than a packet's wake. A light defect
oscillates faster than its neighbours: a family of breathers begins at its linear frequency, and at 0.925 radii what the
packet leaves is close to one of them (defect_mode.hpp).

![Energy around the defect against time, and the mode in which it is trapped.](fig:x10)

Is the trapped state really such a breather? We compare the two at equal energy around the defect, by
their frequencies and by the overlap $1-\frac12\sum_n|p_n-q_n|$ of the distributions $p_n$, $q_n$ of
their energy over the sites. The run also swings slowly from side to side, as a state does that is
nearly but not quite the breather. */
inline Table mode_table(const StruckArray& blow, const Profile& now, const Orbit<double>& orbit) {
  Table table{{count("n", "site", "site"), number("run", "share of the energy in the impact's run"),
               number("mode", "share of the energy in the breather"),
               number("y", "displacement of the breather at rest", "um")}};
  for (std::size_t i = 0; i < now.mode.size(); ++i)
    table.add({std::int64_t(blow.array.defect - 4 + i), now.run[i], now.mode[i],
               orbit.start.y[mode_sites / 2 - 4 + i] * blow.scales.xi() * 1e6});
  return table;
}

/**
How well do we know this breather? An error of the energy that stayed moves it along its family, so we
compute it at two energies. It should also be symmetric about the defect, so we note its residual in
the equations for symmetric orbits, and in its own. Both are rounding if they shrink with
the precision, so the orbit is computed in two types, and the difference is the error. */
/// Relative to the amplitude: the residual of the mode's own equations, and of the symmetric ones.
template <class T>
std::array<double, 2> mode_residuals(const Shooting<double>& problem, const Orbit<double>& orbit) {
  Shooting<T> in_t{problem.chain, problem.symmetry, T(problem.omega)};
  const Orbit<T> mode = newton(in_t, orbit);
  in_t.symmetry = site_centred(mode_sites);
  const Evaluation<T> here = in_t.evaluate(in_t.reduce(mode.start), {}, false);
  return {mode.residual(), double(sup(here.residual) / mode.amplitude)};
}

/**
The facts have the numbers of the mode and those of the run. */
inline void report_mode(Report& report, const StruckArray& blow, const std::array<Stay, 2>& stays,
                        double ratio) {
  const Estimate share = compare(stays[0].at(75), stays[1].at(75));
  const double unit = blow.struck_velocity() * blow.struck_velocity() / 2;
  Shooting<double> problem = mode_problem(blow.array, ratio);
  const Orbit<double> orbit = mode_of_energy(problem, share.value * unit);
  const Orbit<double> moved = mode_of_energy(problem, (share.value + share.error) * unit);
  const Profile now = profile(blow.array, problem, orbit, stays[1], 256);
  report.output.add("trapped_mode", mode_table(blow, now, orbit));
  problem.omega = orbit.omega;
  const auto in_double = mode_residuals<double>(problem, orbit),
             wide = mode_residuals<Wide>(problem, orbit);
  report.facts.add("mode_frequency", compare(moved.omega, orbit.omega), "1 / tau_c");
  report.facts.add("mode_run_frequency", compare(stays[0].frequency, stays[1].frequency),
                   "1 / tau_c");
  report.facts.add("mode_linear_frequency", exact(blow.array.linear_frequency(ratio)), "1 / tau_c");
  report.facts.add(
      "mode_overlap",
      compare(profile(blow.array, problem, orbit, stays[0], 128).overlap(), now.overlap()));
  report.facts.add("mode_residual", compare(in_double[0], wide[0]));
  report.facts.add("mode_asymmetry", compare(in_double[1], wide[1]));
}

/**
The energy around the defect is followed for five radii. The first two are those of figure 24, the third is no
defect and serves for comparison, and two are smaller. Until 100 ms the packet that passes would come to the
end of the article's array, so this one has a hundred cantilevers more. */
inline void report_trapping(Report& report, StruckArray blow) {
  blow.array.sites += 100;
  const std::vector<double> ratios{1.6, 1.1, 1, 0.925, 0.8};
  const char* names[] = {"_16", "_11", "_without", "_0925", "_08"};
  std::vector<std::array<Stay, 2>> stays(ratios.size());
  const std::array<double, 2> steps{report.quick ? 0.2 : 0.1, report.quick ? 0.1 : 0.05};
  std::array<ImpactRun, 2> start;
  parallel_for(2, [&](std::size_t k) { start[k] = approach(blow, steps[k]); });
  parallel_for(2 * ratios.size(), [&](std::size_t i) {
    stays[i / 2][i % 2] = stay(blow, ratios[i / 2], start[i % 2], {steps[i % 2], steps[0]});
  });

  // The energy around the defect against time
  Table& trapping =
      report.table("trapping", {number("ratio", "radius of the defect's beads over the others'"),
                                number("t", "time", "ms"),
                                estimate("near", "share of the energy on sites 96 to 104")});
  for (std::size_t i = 0; i < ratios.size(); ++i)
    for (std::size_t k = 0; k < stays[i][1].t.size(); ++k)
      trapping.add(
          {ratios[i], stays[i][1].t[k], compare(stays[i][0].near[k], stays[i][1].near[k])});

  // What each defect holds, on both sides and before it, and for how long
  const std::size_t at = blow.array.defect - 1;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto fact = [&](const std::string& name, auto of, const char* unit = "") {
      report.facts.add(name + names[i], compare(of(stays[i][0]), of(stays[i][1])), unit);
    };
    const char* share = "share of the energy";
    fact(
        "near_75", [](const Stay& s) { return s.at(75); }, share);
    fact("kept", [](const Stay& s) { return s.kept(); });
    fact(
        "at_defect", [&](const Stay& s) { return s.density[at]; }, share);
    fact(
        "before_75", [](const Stay& s) { return s.at(75, &Stay::before); }, share);
    fact("kept_before", [](const Stay& s) { return s.kept(&Stay::before); });
    fact(
        "push", [](const Stay& s) { return s.push * 1e3; }, "mN");
  }
  report_mode(report, blow, stays[3], ratios[3]);
}

}  // namespace trapped
