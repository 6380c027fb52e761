/**
# 5 Driving an array at one end

"A related aspect concerns the actuation of the system through the driving of a bead with a particular frequency",
says the conclusion of James, Kevrekidis and Cuevas (Physica D 251, 2013): it is hard to prepare an array, and easy
to shake its end. We shake the array of section 3.6, with a piston that touches the first bead or with the base of
the first beam.

![Thresholds of a driven array, the fold of its quiet motion, and what it does beside them.](fig:x27)
![Energy in a driven array below, just above and far above the threshold.](fig:x28)

All beams have one frequency, so nothing travels at small amplitude, and a drive above that frequency should shake
the first beads only. If it grows slowly it does so up to a sharp amplitude; beyond, the array sends out breathers. Elsewhere this is known as nonlinear
supratransmission (driven_end.hpp). Which amplitude is it, and what comes out? */

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/drive_chart.hpp"
#include "sec5/driven_array.hpp"
#include "sec5/driven_packets.hpp"

using namespace lattice;

/**
## Model

The chain has beams of 10 ms lifetime, all with the rate $\nu$ of losses, and a drive $G$ at its first bead,
$$\ddot y_n+y_n+\nu\dot y_n = (y_{n-1}-y_n)_+^{3/2}-(y_n-y_{n+1})_+^{3/2}+\delta_{n1}\,G(y_1,t),$$
where the first bead has no left neighbour, and $G = (a\sin\Omega t-y_1)_+^{3/2}$ for a piston, $G = a\sin\Omega t$ for
the base of the first beam (driven_chain.hpp). A motion of the period of the drive that decays along the chain is
*quiet*: it emits nothing. As $a$ grows two branches of such motions meet in a fold (a saddle-node bifurcation, panel b
of the first figure) and end there. In the DpS limit $y_n \simeq 2\epsilon u_n\cos\Omega t$ both are static solutions
that decay into the chain, $-u_n = D_n-D_{n-1}$ with $D_n$ the scaled contact force. Contacts whose stiffness goes like
$\epsilon^{1/2}$ must make up for the detuning $\delta$, so $\epsilon = (2\tau_0\delta)^2$. A piston prescribes a
displacement, $a = 2\epsilon|u_0|\propto\delta^2$. A base prescribes a force, which takes the place of that of the
contact 0; so close to resonance a force $F$ moves a bead by $F/2\delta$, so that $a = 4\delta\epsilon|D_0|$ has one
power more. The fold is at the first maximum of this displacement or force along the branch of static solutions that
begins at rest (driven_end.hpp):
$$a_{\rm piston} = 8\tau_0^2\,\delta^2\,\max|u_0|,\qquad a_{\rm base} = 16\tau_0^2\,\delta^3\,\max|D_0|.$$
We call this the *asymptotic threshold*, or the *law*. The maximum of $|u_0|$, [0.0504148](num:sec5_driving.top), is to
nine digits the largest displacement of the site-centred breather of section 3.2.

| symbol | program | meaning | unit |
|---|---|---|---|
| $f$, $\Omega = 2\pi f\tau_c$ | `frequency`, `omega` | of the drive | Hz, 1 |
| $a$ | `amplitude` | of piston or base | µm, $\xi$ |
| $\delta = \Omega-1$ | `delta` | distance from the frequency of a beam, relative | 1 |
| $\tau$ | `lifetime` | of the energy of a free beam | ms | */
std::string name_of(Drive::By by) {
  return by == Drive::By::piston ? "piston" : "base";
}

/**
## The fold and its asymptotic threshold

The quiet orbit has the period of the drive. Newton's method follows it from a weak drive by pseudo-arclength through the
fold, at two numbers of steps per period and two distances along the curve. */
struct Fold {
  std::string name;  ///< in facts; none without thresholds
  Drive::By by;
  double omega;
  Estimate amplitude{};
};

std::vector<Fold> fold_points(const ArraySetup& setup, bool quick) {
  const auto piston = Drive::By::piston, base = Drive::By::base;
  if (quick) return {{"threshold_first", piston, 1.1}, {"base_first", base, 1.1}};
  return {{"", piston, 1.025},
          {"", piston, 1.05},
          {"threshold_first", piston, 1.1},
          {"recipe_7000", piston, setup.omega(7000)},
          {"threshold_second", piston, 1.2},
          {"", piston, 1.35},
          {"", base, 1.05},
          {"base_first", base, 1.1},
          {"base_second", base, 1.2}};
}

Estimate fold_of(const ArraySetup& setup, Drive::By by, double omega) {
  const DrivenChain driven = setup.driven(by, omega, 0, 0, 0, 10);
  return compare(quiet_orbits(driven, 32, 0.1, 1).fold, quiet_orbits(driven, 64, 0.05, 1).fold);
}

/// The exponent of delta between two points of the curve of folds.
Estimate local_exponent(const Fold& a, const Fold& b) {
  const double apart = std::log((b.omega - 1) / (a.omega - 1));
  const double relative =
      a.amplitude.error / a.amplitude.value + b.amplitude.error / b.amplitude.value;
  return {std::log(b.amplitude.value / a.amplitude.value) / apart, relative / apart};
}

Estimate in_micrometres(const ArraySetup& setup, const Estimate& a) {
  return {setup.micrometres(a.value), setup.micrometres(a.error)};
}

std::vector<Fold> report_folds(Report& report, const ArraySetup& setup) {
  report.facts.add("top", dps_threshold(Drive::By::piston));
  std::vector<Fold> folds = fold_points(setup, report.quick);
  parallel_for(folds.size(), [&](std::size_t i) {
    folds[i].amplitude = fold_of(setup, folds[i].by, folds[i].omega);
  });
  Table& table = report.table(
      "folds",
      {label("by", "what is driven"), number("delta", "distance from the beams' frequency"),
       number("frequency", "of the drive", "Hz"), estimate("fold", "amplitude of the fold", "um"),
       number("law", "its asymptotic value as delta -> 0", "um"), estimate("ratio", "of the two")});
  for (const Fold& f : folds) {
    const double law = threshold_law(f.by, f.omega);
    const Estimate ratio{f.amplitude.value / law, f.amplitude.error / law};
    table.add({name_of(f.by), f.omega - 1, setup.hertz(f.omega), in_micrometres(setup, f.amplitude),
               setup.micrometres(law), ratio});
    if (f.omega == 1.025) report.facts.add("fold_over_law_small", ratio);
    if (f.name == "threshold_first") report.facts.add("fold_over_law", ratio);
  }
  if (report.quick) return folds;

  // Without losses, the exponents, and numbers for whoever builds the array
  ArraySetup free = setup;
  free.lifetime = 0;
  const auto ratio = [&, by = Drive::By::piston](double omega) {
    return quotient(fold_of(free, by, omega), law_estimate(by, omega));
  };
  report.facts.add("fold_over_law_lossless", ratio(1.025));
  report.facts.add("fold_over_law_first_lossless", ratio(1.1));
  report.facts.add("recipe_7000", in_micrometres(setup, folds[3].amplitude), "um");
  report.facts.add("recipe_7000_law",
                   in_micrometres(setup, law_estimate(Drive::By::piston, folds[3].omega)), "um");
  report.facts.add("beam_frequency", exact(setup.hertz(1)), "Hz");
  report.facts.add("exponent_piston_weak", local_exponent(folds[1], folds[2]));
  report.facts.add("exponent_piston_strong", local_exponent(folds[4], folds[5]));
  report.facts.add("exponent_base_weak", local_exponent(folds[6], folds[7]));
  report.facts.add("exponent_base_strong", local_exponent(folds[7], folds[8]));
  return folds;
}

/**
[](finding:driving.onset) [](finding:driving.law) The powers $\delta^2$ and $\delta^3$ are those of $\delta\to0$.
Between $\delta = 0.05$ and 0.1 the fold of a piston grows with the exponent
[2.076](num:sec5_driving.exponent_piston_weak), between 0.2 and 0.35 with
[2.277](num:sec5_driving.exponent_piston_strong); that of a base with [3.18701](num:sec5_driving.exponent_base_weak)
and, between 0.1 and 0.2, [3.36910](num:sec5_driving.exponent_base_strong). At $\delta = 0.1$ a piston needs
[1.1167](num:sec5_driving.fold_over_law) times the asymptotic threshold, at 0.025
[1.0376](num:sec5_driving.fold_over_law_small) times. The asymptotic threshold leaves damping out; without losses these are
[1.1160](num:sec5_driving.fold_over_law_first_lossless) and [1.0280](num:sec5_driving.fold_over_law_lossless). Closer to
the beams' frequency damping matters more, so that at a fixed lifetime the ratio does not tend to one. */
void report_orbits(Report& report, const ArraySetup& setup) {
  const auto branch = quiet_orbits(setup.driven(Drive::By::piston, 1.1, 0, 0, 0, 10), 64, 0.1);
  Table& orbits =
      report.table("quiet_orbits", {number("amplitude", "of the piston", "um"),
                                    number("response",
                                           "of the first bead in the orbit, its amplitude at the "
                                           "beginning of a period",
                                           "um")});
  for (std::size_t k = 0; k < branch.amplitude.size(); ++k)
    orbits.add({setup.micrometres(branch.amplitude[k]), setup.micrometres(branch.response[k])});
}

/**
## Thresholds: slowly up, at once, slowly down

A threshold depends on how one comes to it, and on what one calls emission. *Up*: the amplitude rises slowly from
zero, and the first packet at the detector (bead 20) decides. *Once*: the drive begins at once, and again the first packet
decides. *Lasting*: it begins at once, and emission must go on to the end of the run. *Down*: the same for an amplitude
that falls slowly from 1.2 times the fold. Emission that has been silent for five lifetimes is over.

Near the threshold emission stops after a time that is erratic, so that a stronger drive may be quiet where a weaker one
still emits, and a longer run finds a higher threshold. A bisection would miss this. So we look at thirteen amplitudes
from 0.9175 to 0.9775 of the fold, a stretch with quiet and emitting ones: the threshold of lasting emission lies
between the highest quiet one and the lowest one that emits. Each threshold comes from two runs, the rougher one shorter
and with twice the step; the difference belongs to the error, for emission that lasts the larger one of the two ways. */
enum class Way { up, once, lasting, down };

struct Threshold {
  Way way;
  Fold fold;
};

/// How long a run is, for how long the amplitude changes, and the step.
struct RunLength {
  double horizon, ramp, step;
};

RunLength run_length_for(Way way, bool rough) {
  const double step = rough ? 0.4 : 0.2, stays = rough ? 4000 : 8000;
  if (way == Way::up) return {rough ? 4000.0 : 8000, rough ? 3000.0 : 6000, step};
  if (way == Way::once) return {1500, 0, step};
  const double ramp = way == Way::down ? 4000 : 0;
  return {ramp + stays, ramp, step};
}

/// Is something sent past the detector, or still sent at the end?
bool emits(const ArraySetup& setup, const Threshold& t, double a, const RunLength& p) {
  const double from = t.way == Way::down ? 1.2 * t.fold.amplitude.value : 0;
  const DrivenChain driven = setup.driven(t.fold.by, t.fold.omega, a, from, p.ramp);
  if (t.way == Way::up || t.way == Way::once)
    return !drive_chain(driven, p.horizon, ArraySetup::detector, p.step, 1).passages.empty();
  const std::size_t all = std::numeric_limits<std::size_t>::max();
  const double silence = 5 / setup.rate(setup.lifetime);
  return drive_chain(driven, p.horizon, ArraySetup::detector, p.step, all, silence)
      .lasts(p.horizon, silence);
}

/// In units of the fold.
Estimate threshold_at(const ArraySetup& setup, const Threshold& t, const RunLength& p) {
  const auto sends = [&](double share) {
    return emits(setup, t, share * t.fold.amplitude.value, p);
  };
  if (t.way == Way::up) return bisect_threshold(0.98, 1.01, 0.001, sends);
  if (t.way != Way::once) return threshold_among(0.9475, 0.005, 6, sends);
  // The lowest of a scan, where the answer need not be monotonic
  double share = 0.3;
  while (share < 1 && !sends(share)) share += 0.04;
  return bisect_threshold(share - 0.04, share, 0.002, sends);
}

std::vector<Threshold> threshold_points(const std::vector<Fold>& folds) {
  std::vector<Threshold> points;
  for (const Fold& fold : folds) {
    if (fold.name.empty()) continue;
    const bool recipe = fold.name == "recipe_7000";
    if (!recipe) points.push_back({Way::up, fold});
    points.push_back({Way::once, fold});
    points.push_back({Way::lasting, fold});
    if (!recipe && fold.by == Drive::By::piston) points.push_back({Way::down, fold});
  }
  return points;
}

const Table& report_thresholds(Report& report, const ArraySetup& setup,
                               const std::vector<Fold>& folds) {
  const std::array<std::string, 4> ways{"up", "once", "lasting", "down"};
  Table& table = report.table(
      "thresholds",
      {label("name", "of the case in the facts"), label("by", "what is driven"),
       label("way", "first packet, slowly up or at once; lasting emission, at once or slowly down"),
       number("delta", "distance from the beams' frequency"),
       number("frequency", "of the drive", "Hz"),
       number("threshold", "amplitude above which packets come", "um"),
       number("rougher", "the same from rougher runs", "um"),
       number("bracket", "between the highest quiet amplitude and the lowest that emits", "um"),
       number("over_fold", "the same over the fold"),
       number("over_law", "and over the asymptotic threshold")});

  // Each threshold from two runs
  table.fill(threshold_points(folds), [&](const Threshold& t) {
    const Estimate rough = threshold_at(setup, t, run_length_for(t.way, true));
    const Estimate full = threshold_at(setup, t, run_length_for(t.way, false));
    const double fold = t.fold.amplitude.value, unit = setup.micrometres(fold);
    return Cells{t.fold.name,
                 name_of(t.fold.by),
                 ways[std::size_t(t.way)],
                 t.fold.omega - 1,
                 setup.hertz(t.fold.omega),
                 full.value * unit,
                 rough.value * unit,
                 2 * full.error * unit,
                 full.value,
                 full.value * fold / threshold_law(t.fold.by, t.fold.omega)};
  });
  // How lasting emission depends on the length of a run is known no better than from the worse of two onsets
  const auto name = table.texts("name"), way = table.texts("way");
  const auto a = table.numbers("threshold"), rough = table.numbers("rougher"),
             bracket = table.numbers("bracket");
  for (std::size_t k = 0; k < a.size(); ++k) {
    double change = std::abs(a[k] - rough[k]);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (name[i] == name[k] && (way[i] == "lasting" || way[i] == "down") &&
          (way[k] == "lasting" || way[k] == "down"))
        change = std::max(change, std::abs(a[i] - rough[i]));
    report.facts.add(name[k] + "_" + way[k], {a[k], change + bracket[k] / 2}, "um");
  }
  return table;
}

/**
The slower the amplitude rises, the closer the threshold comes to the fold, from below. A rise of 0.15 s leads to
[5.77](num:sec5_driving.threshold_first_up) and [25.7](num:sec5_driving.threshold_second_up) µm for a piston at $\delta
= 0.1$ and 0.2, and to [0.7530](num:sec5_driving.base_first_up) and [7.79](num:sec5_driving.base_second_up) µm for a
base. In these cases lasting emission begins below the fold: for a piston at
[5.53](num:sec5_driving.threshold_first_lasting) and [24.1](num:sec5_driving.threshold_second_lasting) µm if the drive
begins at once, at [5.56](num:sec5_driving.threshold_first_down) and [24.0](num:sec5_driving.threshold_second_down) µm
if it comes down; for a base that begins at once at [0.721](num:sec5_driving.base_first_lasting) and
[7.49](num:sec5_driving.base_second_lasting) µm. In between the array is quiet or emits, as it was before.

## What leaves below the threshold of lasting emission

A sudden drive shakes the first bead more than the quiet orbit does, and a packet may leave although emission does not
last. How many do, half-way between the first packet and lasting emission? And what is a packet? A base that begins at
once sends something at weaker amplitudes too: at $\delta = 0.2$ the largest energy density at the detector is
[1.32](num:sec5_driving.base_second_strong) $(a/\delta)^2$ at 1.1 times the threshold and still
[0.0088](num:sec5_driving.base_second_weak) $(a/\delta)^2$ at 0.9 times. We count from 0.03 on (driven_end.hpp); a lower
bar would find weaker packets at weaker drives. */
void report_onset(Report& report, const ArraySetup& setup, const std::vector<Fold>& folds,
                  const Table& thresholds) {
  const auto name = thresholds.texts("name"), way = thresholds.texts("way");
  const auto over_fold = thresholds.numbers("over_fold");
  const auto share = [&](const Fold& f, const std::string& by) {
    std::size_t k = 0;
    while (name.at(k) != f.name || way[k] != by) ++k;
    return over_fold[k];
  };
  const auto at_detector = [&](const Fold& f, double of_fold, double step) {
    const DrivenChain driven = setup.driven(f.by, f.omega, of_fold * f.amplitude.value, 0, 0);
    return drive_chain(driven, 4000, ArraySetup::detector, step);
  };
  for (const Fold& f : folds) {
    const double once = f.name.empty() ? 0 : share(f, "once");
    if (f.name == "threshold_first" || f.name == "threshold_second") {
      const double half_way = (once + share(f, "lasting")) / 2;
      const auto sent = [&](double step) { return at_detector(f, half_way, step).passages.size(); };
      report.facts.add(f.name + "_packets", compare(sent(0.4), sent(0.2)));
    }
    if (f.name != "base_second") continue;
    const auto loudest = [&](double of_once) {
      return compare(at_detector(f, of_once * once, 0.4).loudest,
                     at_detector(f, of_once * once, 0.2).loudest);
    };
    report.facts.add("base_second_weak", loudest(0.9));
    report.facts.add("base_second_strong", loudest(1.1));
  }
}

/**
A piston sends the first packet at [5.07](num:sec5_driving.threshold_first_once) and
[22.27](num:sec5_driving.threshold_second_once) µm for $\delta = 0.1$ and 0.2. Half-way from there to lasting emission
[1](num:sec5_driving.threshold_first_packets) and [1](num:sec5_driving.threshold_second_packets) packet leaves within
0.1 s, and no other. A base sends its first one at [0.5658](num:sec5_driving.base_first_once) µm for $\delta = 0.1$,
which is below the asymptotic threshold, and at [5.61](num:sec5_driving.base_second_once) µm for 0.2, which is above it.
These packets belong to the onset: a slow rise has none of them. */
void report_far_end(Report& report, const ArraySetup& setup) {
  const double law = threshold_law(Drive::By::piston, 1.2);
  for (const std::size_t sites : {30, 120, 300}) {
    const auto late = [&](double step) {
      const DrivenChain falling =
          setup.driven(Drive::By::piston, 1.2, 1.04 * law, 2 * law, 1333, sites);
      return std::lround(2000 * drive_chain(falling, 4000, ArraySetup::detector, step).rate(4000));
    };
    report.facts.add("late_" + std::to_string(sites), compare(late(0.4), late(0.2)));
  }
}

/**
The array must be long, or packets come back from the far end and pass the detector again: at $\delta = 0.2$ and 1.04
times the asymptotic threshold a drive that comes down from twice of it sends
[17](num:sec5_driving.late_30) packets past the detector in the second half of 0.1 s in an array of 30 beads,
[0](num:sec5_driving.late_120) in one of 120 and [0](num:sec5_driving.late_300) in one of 300. We take 120 beads for
thresholds and 300 for the chart, whose drives are stronger.

## A chart over frequency and amplitude

The chart (drive_chart.hpp) goes over frequencies and amplitudes in units of the asymptotic threshold. It holds the rate
of packets, how regular they are and what power the drive gives. A run is *quiet* if nothing passes the detector, its
emission is *periodic*, a train of packets, if the intervals between them differ by less than a tenth, and *irregular*
otherwise. Each point has a second run, half as long and with twice the step: where irregular emission becomes periodic
after a while, or where a step decides, the two are of different kinds, at [2](num:sec5_driving.chart_undecided) of the
70 points. At [13](num:sec5_driving.chart_reached) of them the last bead moves, by more than a millionth of the
amplitude, so that something may come back. */
void report_chart(Report& report, const ArraySetup& setup) {
  Sweep sweep = drive_chart(report.output.folder(), report.quick);
  compute_chart(sweep, setup, report.quick, {});
  const Table table = sweep.table();
  const auto kind = table.numbers("kind"), rough = table.numbers("kind_rough");
  std::size_t undecided = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) undecided += kind[i] != rough[i];
  report.facts.add("chart_undecided", exact(double(undecided)));
  const auto far = table.numbers("far"), a = table.numbers("amplitude");
  std::size_t reached = 0;
  for (std::size_t i = 0; i < far.size(); ++i) reached += far[i] > 1e-6 * a[i];
  report.facts.add("chart_reached", exact(double(reached)));
  report.output.add("chart", table);
  sweep.forget();
}

// The second figure: the three kinds in space and time, for a piston at delta = 0.1
void report_maps(Report& report, const ArraySetup& setup) {
  const std::array<double, 3> ratios{0.95, 1.3, 3};
  const std::size_t bins = report.quick ? 40 : 160, sites = ArraySetup::sites;
  const double omega = 1.1, horizon = 2000;
  std::array<std::vector<double>, 3> maps;
  parallel_for(3, [&](std::size_t i) {
    const double a = ratios[i] * threshold_law(Drive::By::piston, omega);
    maps[i] = drive_map(setup.driven(Drive::By::piston, omega, a, 0, 300), horizon, bins, 0.2);
  });
  Table& table = report.table(
      "maps",
      {number("ratio", "amplitude over the asymptotic threshold"),
       number("t", "middle of the time interval", "ms"), count("n", "bead", "site"),
       number("energy", "largest energy of the bead in the interval, without contacts", "J")});
  const double unit = setup.unit_energy();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t bin = 0; bin < bins; ++bin)
      for (std::size_t n = 0; n < DrivenArray::drawn; ++n)
        table.add({ratios[i], setup.milliseconds((double(bin) + 0.5) * horizon / double(bins)),
                   std::int64_t(n + 1), maps[i][bin * sites + n] * unit});
}

// How well the energy budget closes, with the steps of the command, in three drives
void report_budget(Report& report) {
  std::vector<DrivenArray> cases(3);
  for (DrivenArray& drive : cases) drive.duration = 20;
  cases[1].amplitude = 20;
  cases[2].by = Drive::By::base;
  Estimate most{};
  for (const DrivenArray& drive : cases)
    most = larger(most, compare(drive.run(2 * drive.step).budget, drive.run(drive.step).budget));
  report.facts.add("budget", most);
  if (!(most.value < 1e-10))
    throw Failure("the energy budget is open by " + number_text(most.value));
}

/**
## What the packets are (figure x29)

Two numbers of a packet are measured from bead to bead, its shift time $T$ and its phase $\varphi$ (driven_packets.hpp),
without losses, on beads 12 to 28, for drives that begin at once at $\delta = 0.1$. The strength of a drive is its
amplitude over the asymptotic threshold. The energies agree with those of the families of travelling breathers.
[](finding:driving.packets) At the two strongest drives the ratio is uncertain by more than one per cent, as four looks at
the packet differ. This tests one combination of $T$ and $\varphi$: a phase that is wrong by a tenth would multiply the
ratio by [0.8636](num:sec5_driving.energy_ratio_mistimed), an error in time is hardly seen. After an impact, where the packet
still sheds a tail, the ratio is [1.009](num:sec5_driving.energy_ratio_impact). The width tests little; its ratio farthest from
one is [0.986](num:sec5_driving.width_ratio_worst).

A drive that locked its packets to an exact breather would keep $(T+\varphi)/2\pi$ at a whole number over a range of
strengths. From each of the seventeen strengths to the next it changes by more than the errors of both, at least by
[1.58478](num:sec5_driving.family_least_change) times their sum, so that a plateau could only hide between two of them. A packet
is exact if besides $\varphi$ is zero or the sum of all $y_n+i\dot y_n$ is; no packet meets both conditions, but those
near 1.23 and 1.63 nearly do.

![What the packets of a drive are, against its strength.](fig:x29) */
Estimate farthest_from_one(const std::vector<Estimate>& ratio) {
  return *std::max_element(ratio.begin(), ratio.end(), [](const Estimate& a, const Estimate& b) {
    return std::abs(a.value - 1) < std::abs(b.value - 1);
  });
}

void report_packets(Report& report) {
  std::vector<double> strengths{1.05, 1.1, 1.15, 1.2,  1.22, 1.24, 1.26, 1.3, 1.35,
                                1.4,  1.5, 1.6,  1.65, 1.7,  1.8,  2.0,  2.4};
  if (report.quick) strengths = {1.1, 1.3, 2.0};
  const Families families;
  const std::size_t count = strengths.size();
  std::vector<Looks> looks(count + 1);  // the last one at the packet of an impact
  parallel_for("packets", count + 1,
               [&](std::size_t i) { looks[i] = look_at({i < count ? strengths[i] : 0}); });

  // What each packet is
  const auto seen = [](const std::string& name, const std::string& meaning) {
    return Columns{number(name, meaning), number(name + "_spread", "largest difference of looks")};
  };
  Table& table = report.table(
      "strengths",
      {number("strength", "amplitude of the piston over the asymptotic threshold"),
       seen("phase", "from site to site"), seen("family", "shift time and phase over 2 pi"),
       seen("energy_ratio", "energy over that of the family's member"),
       seen("width_ratio", "width over that of the family's member")});
  std::vector<Estimate> family(count), energy(count), width(count);
  for (std::size_t i = 0; i < count; ++i) {
    family[i] = looks[i](family_of);
    energy[i] = families.ratio(looks[i], &Traveller::energy);
    width[i] = families.ratio(looks[i], &Traveller::width);
    table.add({strengths[i], looks[i]([](const Traveller& p) { return p.phase; }), family[i],
               energy[i], width[i]});
  }

  // How far from the families, how sharp the test, and whether anything stays the same
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < count; ++i)
    least = std::min(least, std::abs(family[i].value - family[i - 1].value) /
                                (family[i].error + family[i - 1].error));
  const Looks& middle = looks[report.quick ? 1 : 7];  // strength 1.3
  report.facts.add("energy_ratio_worst", farthest_from_one(energy));
  report.facts.add("width_ratio_worst", farthest_from_one(width));
  report.facts.add("energy_ratio_impact", families.ratio(looks.back(), &Traveller::energy));
  report.facts.add("energy_ratio_mistimed", families.mistimed(middle, &Traveller::energy, 0.1));
  report.facts.add("family_least_change", exact(least), "sum of two errors");
}

/**
## With your own parameters

`sec5_driving drive --frequency 7000 --amplitude 5` tells what comes out of one drive, `chart --part 1/10` computes a
tenth of the chart. */
struct OneDrive : DrivenArray {
  static constexpr Title title{"drive", "what a driven array sends out"};

  void parameters(Parameters& p) {
    p.add("frequency", frequency, "of the drive in Hz", {500, 20000, "Hz"});
    p.add("amplitude", amplitude, "of piston or base in micrometres", {0, 200, "um"});
    p.add("by", by, "what is driven: a piston that touches the first bead, or the first base",
          {{"piston", Drive::By::piston}, {"base", Drive::By::base}});
    p.add("lifetime", lifetime, "of the energy of a beam that swings freely, in ms",
          {0.5, 1e6, "ms"});
    p.add("time", duration, "how long the drive lasts, in ms; shorter than 20 ms is a transient",
          {20, 500, "ms"});
  }
  Table table() const {
    Answers q;
    // Below the threshold all of them may be nothing
    for (const DrivenQuantity& one : quantities())
      q.add_small(one.name, one.value, one.unit, one.meaning);
    return q.table;
  }
};

struct Chart : MapPart {
  static constexpr Title title{"chart", "a part of the chart over frequency and amplitude"};

  Table table() const {
    Sweep sweep = drive_chart(folder, false);
    compute_chart(sweep, ArraySetup{}, false, mine());
    return sweep.table(mine());
  }
};

/**
## Differences and limits

The fold has three routes: slow runs, Newton's method on the driven orbit, and a map of two lines in the DpS limit,
which shares no code with the others. The bookkeeping of `drive`, energy and losses less work over the most energy
that was there or came in, closes to [1e-12](num:sec5_driving.budget) at its steps in a quiet motion, a periodic one
and a driven base. The article has no number for such a drive. The piston is a bead that cannot be pushed back; a real
shaker can. That a quiet motion vanishes in a fold does not tell what comes after it: runs do, with one lifetime. */
void reproduce(Report& report) {
  const ArraySetup setup;
  const std::vector<Fold> folds = report_folds(report, setup);
  report_orbits(report, setup);
  report_onset(report, setup, folds, report_thresholds(report, setup, folds));
  report_far_end(report, setup);
  report_maps(report, setup);
  report_budget(report);
  report_packets(report);
  report_chart(report, setup);
}

/**
## Try it

1. *Easy.* How far must a piston move at 6600 Hz instead of 7000?
   `build/bin/sec5_driving drive --frequency 6600 --time 20` gives `threshold_law` = 1.08769.
   Hint: the beams swing at [6310.91](num:sec5_driving.beam_frequency) Hz; how does the law go with $\delta$?
2. *Easy.* What does the end do below the fold, at 4 µm?
   `build/bin/sec5_driving drive --amplitude 4 --time 20` gives `response` = 1.3200.
   Hint: this is a point of the lower branch of quiet orbits. By which factor does it jump at 7 µm, with emission?
3. *Harder.* Do losses move the threshold? With a lifetime of 1 ms and 7 µm nothing passes the detector:
   `build/bin/sec5_driving drive --amplitude 7 --lifetime 1 --time 20` gives `response` = 4.0521.
   Hint: either the fold is above 7 µm now, or packets die before bead 20. Is the response that of a quiet or of an
   emitting end?
4. *Harder.* Is a packet that loses energy still a breather of the family?
   `build/bin/sec5_driving packet --lifetime 10 --from 9 --beads 8` gives `energy_ratio` = 1.01.
   Hint: shift time and phase change on the way, and the energy with them. The ratio compares all three at the same place.
5. *Open.* Where does periodic emission become irregular, and is this a bifurcation of the periodic motion?
6. *Open.* Which law gives the phase of a driven packet as a function of strength and frequency? */
int main(int argc, char** argv) {
  return run({"sec5_driving", "5", "Driving an array at one end (section 5)", reproduce,
              commands<OneDrive, Chart, OnePacket>()},
             argc, argv);
}
