/**
# 5 Driving an array at one end

"A related aspect concerns the actuation of the system through the driving of a bead with a particular frequency", says
the conclusion of James, Kevrekidis and Cuevas (Physica D 251, 2013), without pursuing it. We shake one end of the array
of section 3.6. All its beams have one frequency, so that no wave of small amplitude carries energy, and a drive at a
higher frequency moves the first few beads only. But contacts harden: breathers are faster than the beams. Above which
amplitude does the drive send breathers into the array, and which ones?

![Energy in an array driven below, just above and far above its threshold. Drawn by x28_driven_maps.py: `energy` over
`n` and `t`, for each `ratio` of `maps`.](fig:x28)

- Below a threshold nothing leaves the end. A little above it breathers leave one after the other, far above
  irregularly.
- The threshold depends on how the drive begins. If the amplitude rises slowly, it is where the non-emitting motion ends
  in a fold, a saddle-node bifurcation; a drive that is switched on emits earlier.
- Close to the frequency of the beams the threshold of a piston scales like the square of the distance $\delta$ from it,
  that of a shaken base like the cube. The limit of small amplitude gives both laws, and an asymptotic threshold.
- The packets are travelling breathers: two numbers of a packet predict its energy to about one per cent.

## Model

In the units of section 3.6, $\xi$ of length and $\tau_c$ of time (cantilever.hpp), the beams obey
$$\ddot y_n+y_n+\nu\dot y_n = (y_{n-1}-y_n)_+^{3/2}-(y_n-y_{n+1})_+^{3/2}+\delta_{n1}\,G(y_1,t),$$
and the first bead has no left neighbour. Its drive $G$ is the push of a *piston*, a bead that moves as $a\sin\Omega t$
and cannot be pushed back, $G = (a\sin\Omega t-y_1)_+^{3/2}$, or that of the *base*, the clamp of the first beam, which
is shaken, $G = a\sin\Omega t$. All beads are at rest at $t = 0$. Eq. (32) of the article has no losses. We let each
beam lose its energy in 10 ms, the lifetime that its conclusion quotes for diatomic chains.

| symbol | program | meaning | unit |
|---|---|---|---|
| $f$, $\Omega = 2\pi f\tau_c$ | `frequency`, `omega` | of the drive | Hz, 1 |
| $a$ | `amplitude` | of piston or base | µm, $\xi$ |
| $\delta = \Omega-1$ | `delta` | distance from the frequency of a beam, relative | 1 |
| $1/\nu$ | `lifetime` | of the energy of a free beam | ms | */
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "commands/sweep.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/driven_array.hpp"
#include "sec5/packet_members.hpp"
#include "sec5/solution_curve.hpp"

using namespace lattice;
using By = Drive::By;

/**
## The experiment

An array of 120 beads at rest is driven at its first bead, with a detector at bead 20. A packet passes when the energy
density of this bead, as its maximum in each period of the drive, rises fourfold and above 0.03 $a^2$, or 0.03
$(a/\delta)^2$ for a base, whose force moves a bead by about $a/\delta$; it must fall to half before the next one counts
(`PacketCounter`). `evolve` lets losses and drive act for half a step before and after each event-corrected step, and
records the energy that they take and give (driven_chain.hpp). Energy and losses less work must stay constant to
$10^{-4}$ of the largest energy, or the program stops. Times and steps are in units of $\tau_c$, 25 µs. */
constexpr std::size_t detector = 20;

struct BeamArray : Scales {
  double lifetime = 10;  // of the energy of a beam, in ms; 0: no losses

  BeamArray() : Scales(CantileverArray{}.scales()) {}
  /// Linear beams, Hertz contacts, free ends. A drive is {what, Omega, a, amplitude at the start, time to come to a}.
  DrivenChain driven(const Drive& drive, std::size_t beads = 120) const {
    return {Chain{beads}, Losses{rate(lifetime), 0}, drive};
  }
};

/// What a drive sends past the detector.
struct Sent {
  std::vector<double> passages{};  // times at which packets pass
  double power = 0;                // mean of the drive's in the second half of the run
  double far = 0;                  // largest displacement of the last bead
};
using Enough = std::function<bool(const Sent& so_far, double t)>;

/// Drives an array from rest for some time, or until it is `enough`.
Sent drive(const DrivenChain& array, double time, double step, const Enough& enough = {}) {
  State<double> state(array.chain.sites);
  PacketCounter counter(array.drive);
  const TimeGrid grid = two_halves(time, step);
  double half = 0;
  Sent sent;
  const double open = evolve(array, state, grid, [&](const auto& now, const EnergyBudget& budget) {
    const double y = now.y[detector - 1], v = now.v[detector - 1];
    if (counter.passes(now.t, (y * y + v * v) / 2)) sent.passages.push_back(now.t);
    if (now.t < (time + grid.interval()) / 2) half = budget.work;
    sent.power = (budget.work - half) / (time / 2);
    sent.far = std::max(sent.far, std::abs(now.y.back()));
    return !enough || !enough(sent, now.t);
  });
  if (!(open < 1e-4)) throw Failure("the energy budget does not close");
  return sent;
}

/**
## Three kinds of motion (figure x28)

The amplitude of a piston at $\delta = 0.1$ rises for 7.6 ms, to 0.95, 1.3 and 3 times the asymptotic threshold that is
derived below. We draw the largest energy of each bead in short intervals. */
void report_maps(Report& report, const BeamArray& beams) {
  const std::array ratios{0.95, 1.3, 3.0};
  const std::size_t bins = report.quick ? 40 : 160, drawn = 60;
  const double omega = 1.1, time = 2000;
  std::array<std::vector<double>, 3> maps;
  parallel_for(3, [&](std::size_t i) {
    const double a = ratios[i] * threshold_law(By::piston, omega);
    const DrivenChain array = beams.driven({By::piston, omega, a, 0, 300});
    State<double> state(array.chain.sites);
    maps[i].resize(bins * drawn);
    evolve(array, state, time_grid(time, 0.8, 0.2), [&](const auto& now, const auto&) {
      const std::size_t bin = std::min(bins - 1, std::size_t(now.t / time * double(bins)));
      for (std::size_t n = 0; n < drawn; ++n) {
        double& most = maps[i][bin * drawn + n];
        most = std::max(most, (now.y[n] * now.y[n] + now.v[n] * now.v[n]) / 2);
      }
      return true;
    });
  });
  Table& table = report.table(
      "maps",
      {number("ratio", "amplitude divided by the asymptotic threshold"),
       number("t", "middle of the time interval", "ms"), count("n", "bead", "site"),
       number("energy", "largest energy of the bead in the interval, contacts excluded", "J")});
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < bins * drawn; ++k)
      table.add({ratios[i], beams.milliseconds((double(k / drawn) + 0.5) * time / double(bins)),
                 k % drawn + 1, maps[i][k] * beams.unit_energy()});
}

/**
## The non-emitting motion and its fold (figure x27 b)

Below the threshold the end of the array settles on a motion with the period of the drive, which decays along the chain
faster than exponentially; ten beads hold all of it. Newton's method finds it directly: unknown are all positions and
velocities at the beginning of a period, and they must return after it. The flow is that of the experiment, with a fixed
number of steps in a period. */
Vector<double> return_error(DrivenChain array, const Vector<double>& x, std::size_t steps) {
  const Eigen::Index n = x.size() / 2;
  State<double> state{std::size_t(n)};
  std::copy_n(x.data(), n, state.y.begin());
  std::copy_n(x.data() + n, n, state.v.begin());
  array.drive.amplitude = x[2 * n];
  evolve(array, state, TimeGrid{2 * std::numbers::pi / array.drive.omega, 1, steps});
  Vector<double> after(2 * n);
  std::copy_n(state.y.begin(), n, after.data());
  std::copy_n(state.v.begin(), n, after.data() + n);
  return after - x.head(2 * n);
}

/**
The last unknown is the amplitude, because at a fold two motions of one amplitude merge. The solutions are a curve,
which begins at rest without a drive and is followed in its own length beyond the fold (solution_curve.hpp). Lengths are
in units of the asymptotic threshold of a piston. */
SolutionCurve non_emitting(const DrivenChain& array, std::size_t steps, double apart,
                           double beyond) {
  const double unit = threshold_law(By::piston, array.drive.omega);
  const double first = 0.2 * threshold_law(array.drive.by, array.drive.omega) / unit;
  return follow_solutions([&](const auto& x) { return return_error(array, x, steps); },
                          Eigen::Index(2 * array.chain.sites + 1), first, apart, unit, beyond);
}

/**
Does the array settle on this motion? A run over 2000 periods from rest, at about half the amplitude of the fold, must
end on the orbit to a millionth of $a$, or the program stops.

![Thresholds of a driven array, its non-emitting motion, and what it sends out. Drawn by x27_driven_thresholds.py: (a)
`ratio` of `folds` and `over_law` of `thresholds` over `delta`, (b) `response` over `amplitude` of `quiet_orbits`, (c)
`amplitude` over `frequency` for each `kind` of `chart`, (d) its `power` over `ratio`.](fig:x27) */
void report_orbits(Report& report, const BeamArray& beams) {
  DrivenChain array = beams.driven({By::piston, 1.1}, 10);
  const SolutionCurve curve = non_emitting(array, 64, 0.1, 0.8);
  Table& orbits = report.table(
      "quiet_orbits",
      {number("amplitude", "of the piston", "um"),
       number("response", "amplitude of the first bead in the orbit, at the beginning of a period",
              "um")});
  for (const Vector<double>& x : curve.points)
    orbits.add({beams.micrometres(x[20]), beams.micrometres(std::hypot(x[0], x[10]))});

  // The run
  const Vector<double>& orbit =
      *std::find_if(curve.points.begin(), curve.points.end(),
                    [&](const auto& x) { return x[20] > curve.fold / 2; });
  State<double> state(10);
  array.drive.amplitude = orbit[20];
  evolve(array, state, TimeGrid{2000 * 2 * std::numbers::pi / 1.1, 2000, 64});
  for (Eigen::Index n = 0; n < 10; ++n) {
    const double y = state.y[std::size_t(n)] - orbit[n],
                 v = state.v[std::size_t(n)] - orbit[10 + n];
    if (!(std::hypot(y, v) < 1e-6 * orbit[20]))
      throw Failure("the array does not settle on the non-emitting orbit");
  }
}

/**
## The asymptotic threshold (figure x27 a)

Where does the fold lie? For small amplitudes section 3.1 of the article sets $y_n \simeq 2\epsilon u_n\cos\Omega t$ and
averages Hertz's force over a period, which brings in its constant $\tau_0$ (the DpS limit). The motion is then a static
solution of Eq. (14) that decays into the chain, $-u_n = D_n-D_{n-1}$ with $D_n = (u_{n+1}-u_n)|u_{n+1}-u_n|^{1/2}$, the
scaled force of contact $n$. Contacts, whose stiffness goes like $\epsilon^{1/2}$, must make up for the detuning, so
$\epsilon = (2\tau_0\delta)^2$. A piston prescribes a displacement, $a = 2\epsilon|u_0|\propto\delta^2$. A base
prescribes a force instead of that of contact 0. So close to resonance a force $F$ moves a bead by $F/2\delta$, so that
$a = 4\delta\epsilon|D_0|$ has one power more. Decaying solutions are a curve, found by iterating a map of two lines
(driven_array.hpp), and the fold is at the first maximum of $|u_0|$ or $|D_0|$ along it:
$$a_{\rm piston} = 8\tau_0^2\,\delta^2\,\max|u_0|,\qquad a_{\rm base} = 16\tau_0^2\,\delta^3\,\max|D_0|.$$
We call this the *asymptotic threshold*. To nine digits $\max|u_0|$ is the largest displacement of the site-centred
static breather: a piston has to lift the first bead to its top.

In chains with a band gap this mechanism is known as nonlinear supratransmission (Geniet and Leon, Phys. Rev. Lett. 89,
134102, 2002). Leon (Phys. Lett. A 319, 130, 2003) explains the threshold by the largest amplitude at the end of a
static decaying solution, Susanto (arXiv:0809.3861, 2008) proves the fold for a discrete Schrödinger equation. Maniadis,
Kopidakis and Aubry (Physica D 216, 121, 2006) study it with discrete breathers, Yousefzadeh and Phani
(arXiv:1510.00058, 2015) in damped, finite and disordered structures. */
struct Fold {
  std::string name;  // in facts; none without thresholds
  By by;
  double omega;
  Estimate amplitude{};
};

std::vector<Fold> fold_points(const BeamArray& beams, bool quick) {
  if (quick) return {{"threshold_first", By::piston, 1.1}, {"base_first", By::base, 1.1}};
  return {{"", By::piston, 1.025},
          {"", By::piston, 1.05},
          {"threshold_first", By::piston, 1.1},
          {"recipe_7000", By::piston, beams.omega(7000)},
          {"threshold_second", By::piston, 1.2},
          {"", By::piston, 1.35},
          {"", By::base, 1.05},
          {"base_first", By::base, 1.1},
          {"base_second", By::base, 1.2}};
}

/// With two numbers of steps in a period, and two distances between the points of the curve.
Estimate fold_of(const BeamArray& beams, By by, double omega) {
  const DrivenChain array = beams.driven({by, omega}, 10);
  return compare(non_emitting(array, 32, 0.1, 1).fold, non_emitting(array, 64, 0.05, 1).fold);
}

/// The exponent of delta between two folds.
Estimate exponent(const Fold& a, const Fold& b) {
  const double apart = std::log((b.omega - 1) / (a.omega - 1));
  const double relative =
      a.amplitude.error / a.amplitude.value + b.amplitude.error / b.amplitude.value;
  return {std::log(b.amplitude.value / a.amplitude.value) / apart, relative / apart};
}

std::string name_of(By by) {
  return by == By::piston ? "piston" : "base";
}

std::vector<Fold> report_folds(Report& report, const BeamArray& beams) {
  const auto um = [&](const Estimate& a) {
    return Estimate{beams.micrometres(a.value), beams.micrometres(a.error)};
  };
  report.facts.add("top", dps_threshold(By::piston));
  std::vector<Fold> folds = fold_points(beams, report.quick);
  parallel_for(folds.size(), [&](std::size_t i) {
    folds[i].amplitude = fold_of(beams, folds[i].by, folds[i].omega);
  });
  Table& table =
      report.table("folds", {label("by", "drive: piston or base"),
                             number("delta", "relative detuning from the beams' frequency"),
                             number("frequency", "frequency of the drive", "Hz"),
                             estimate("fold", "amplitude of the drive at the fold", "um"),
                             number("law", "asymptotic value of the fold as delta -> 0", "um"),
                             estimate("ratio", "ratio fold / law")});
  for (const Fold& f : folds) {
    const double law = threshold_law(f.by, f.omega);
    const Estimate ratio{f.amplitude.value / law, f.amplitude.error / law};
    table.add({name_of(f.by), f.omega - 1, beams.hertz(f.omega), um(f.amplitude),
               beams.micrometres(law), ratio});
    if (f.omega == 1.025) report.facts.add("fold_over_law_small", ratio);
    if (f.name == "threshold_first") report.facts.add("fold_over_law", ratio);
    if (!f.name.empty() && f.name != "recipe_7000")
      report.facts.add(f.name + "_fold", um(f.amplitude), "um");
  }
  if (report.quick) return folds;

  // Without losses, at 7000 Hz, and the exponents
  BeamArray free = beams;
  free.lifetime = 0;
  const auto ratio = [&](double omega) {
    return quotient(fold_of(free, By::piston, omega), law_estimate(By::piston, omega));
  };
  report.facts.add("fold_over_law_lossless", ratio(1.025));
  report.facts.add("fold_over_law_first_lossless", ratio(1.1));
  report.facts.add("recipe_7000", um(folds[3].amplitude), "um");
  report.facts.add("recipe_7000_law", um(law_estimate(By::piston, folds[3].omega)), "um");
  report.facts.add("beam_frequency", exact(beams.hertz(1)), "Hz");
  report.facts.add("exponent_piston_weak", exponent(folds[1], folds[2]));
  report.facts.add("exponent_piston_strong", exponent(folds[4], folds[5]));
  report.facts.add("exponent_base_weak", exponent(folds[6], folds[7]));
  report.facts.add("exponent_base_strong", exponent(folds[7], folds[8]));
  return folds;
}

/**
[](finding:driving.law) At finite $\delta$ the fold grows faster than its asymptotic value, and the exponents rise with
$\delta$. The asymptotic threshold leaves losses out. Closer to the beams' frequency they matter more, so that at a
fixed lifetime the ratio does not tend to one.

| quantity | expected as $\delta\to0$ | here |
|---|---|---|
| exponent of $\delta$, piston, from 0.05 to 0.1 | 2 | [2.076 ± 0.001](num:sec5_driving.exponent_piston_weak) |
| from 0.2 to 0.35 | 2 | [2.277 ± 0.003](num:sec5_driving.exponent_piston_strong) |
| exponent, base, from 0.05 to 0.1 | 3 | [3.18701 ± 2e-5](num:sec5_driving.exponent_base_weak) |
| from 0.1 to 0.2 | 3 | [3.36910 ± 1e-5](num:sec5_driving.exponent_base_strong) |
| fold over asymptotic threshold, piston, $\delta = 0.1$ | 1 | [1.1167 ± 0.0006](num:sec5_driving.fold_over_law) |
| the same without losses | 1 | [1.1160 ± 0.0006](num:sec5_driving.fold_over_law_first_lossless) |
| at $\delta = 0.025$ | 1 | [1.0376 ± 0.0001](num:sec5_driving.fold_over_law_small) |
| the same without losses | 1 | [1.0280 ± 0.0002](num:sec5_driving.fold_over_law_lossless) |
| frequency of a free beam, Hz | | [6310.91](num:sec5_driving.beam_frequency) |
| fold of a piston at 7000 Hz, µm | | [6.970 ± 0.004](num:sec5_driving.recipe_7000) |
| its asymptotic threshold, µm | | [6.18000 ± 1e-15](num:sec5_driving.recipe_7000_law) |
| $\max\lvert u_0\rvert$ | | [0.0504148 ± 1e-17](num:sec5_driving.top) |

## Where emission begins (figure x27 a)

A threshold depends on how it is approached, and on the definition of emission. *Up*: the amplitude rises slowly from
zero, for 0.15 s, and the first packet decides. *Once*: the drive is switched on, and again the first packet
decides. *Lasting*: it is switched on, and packets must still come at the end of the run. *Down*: the same for an
amplitude that falls slowly from 1.2 times the fold. Emission counts as over after five lifetimes without a packet. */
enum class Way { up, once, lasting, down };

/// How long a run is, for how long the amplitude changes, and the step, in units of tau_c.
struct RunLength {
  double time, ramp, step;
};

RunLength run_length_for(Way way, bool rough) {
  const double step = rough ? 0.4 : 0.2, stays = rough ? 4000 : 8000;
  if (way == Way::up) return {rough ? 4000.0 : 8000, rough ? 3000.0 : 6000, step};
  if (way == Way::once) return {1500, 0, step};
  const double ramp = way == Way::down ? 4000 : 0;
  return {ramp + stays, ramp, step};
}

bool emits(const BeamArray& beams, Way way, const Fold& fold, double a, const RunLength& run) {
  const double from = way == Way::down ? 1.2 * fold.amplitude.value : 0;
  const DrivenChain array = beams.driven({fold.by, fold.omega, a, from, run.ramp});
  if (way == Way::up || way == Way::once) {
    const auto any = [](const Sent& sent, double) { return !sent.passages.empty(); };
    return any(drive(array, run.time, run.step, any), run.time);
  }
  // Not yet over at the end
  const double silence = 5 / array.losses.rate;
  const auto over = [&](const Sent& sent) {
    return silence + (sent.passages.empty() ? 0 : sent.passages.back());
  };
  const auto decided = [&](const Sent& sent, double t) {
    return over(sent) > run.time || t >= over(sent);
  };
  return over(drive(array, run.time, run.step, decided)) > run.time;
}

/**
Near the threshold of lasting emission, packets cease after a time that is erratic: a stronger drive may fall silent
where a weaker one still emits, and a longer run finds a higher threshold. Bisection would miss this. So we look at
thirteen amplitudes, from 0.9175 to 0.9775 of the fold; the threshold lies between the lowest one that emits and the
highest one that does not. First packets under a sudden drive are found by a scan upwards, then by bisection. */
Estimate threshold(const BeamArray& beams, Way way, const Fold& fold, bool rough) {
  const auto sends = [&](double share) {
    return emits(beams, way, fold, share * fold.amplitude.value, run_length_for(way, rough));
  };
  if (way == Way::up) return bisect_threshold(0.98, 1.01, 0.001, sends);
  if (way != Way::once) return threshold_among(0.9475, 0.005, 6, sends);
  double share = 0.3;
  while (share < 1 && !sends(share)) share += 0.04;
  return bisect_threshold(share - 0.04, share, 0.002, sends);
}

/**
Each threshold is found twice, with steps of 0.4 and of 0.2, the second time in runs twice as long (but for *once*). The
difference and half the bracket are the error. Emission that lasts depends on the length of a run in both of its ways,
and gets the larger difference of the two. */
void report_thresholds(Report& report, const BeamArray& beams, const std::vector<Fold>& folds) {
  const std::array<std::string, 4> ways{"up", "once", "lasting", "down"};
  std::vector<std::pair<Way, Fold>> points;
  for (const Fold& fold : folds) {
    const bool full = fold.name != "recipe_7000";
    if (fold.name.empty()) continue;
    if (full) points.emplace_back(Way::up, fold);
    points.emplace_back(Way::once, fold);
    points.emplace_back(Way::lasting, fold);
    if (full && fold.by == By::piston) points.emplace_back(Way::down, fold);
  }
  Table& table = report.table(
      "thresholds",
      {label("name", "name of the case in the facts"), label("by", "drive: piston or base"),
       label("way",
             "criterion and ramp: first packet, amplitude raised slowly or at once; lasting "
             "emission, set at once or lowered slowly"),
       number("delta", "relative detuning from the beams' frequency"),
       number("frequency", "frequency of the drive", "Hz"),
       number("threshold", "amplitude above which packets are emitted", "um"),
       number("rougher", "threshold from coarser runs", "um"),
       number("bracket",
              "distance between the highest non-emitting amplitude and the lowest emitting one",
              "um"),
       number("over_fold", "threshold divided by the fold"),
       number("over_law", "threshold divided by the asymptotic threshold")});
  // In units of the fold, and in micrometres
  table.fill(points, [&](const std::pair<Way, Fold>& point) {
    const auto& [way, f] = point;
    const Estimate rough = threshold(beams, way, f, true), fine = threshold(beams, way, f, false);
    const double fold = f.amplitude.value, unit = beams.micrometres(fold);
    return Cells{f.name,
                 name_of(f.by),
                 ways[std::size_t(way)],
                 f.omega - 1,
                 beams.hertz(f.omega),
                 fine.value * unit,
                 rough.value * unit,
                 2 * fine.error * unit,
                 fine.value,
                 fine.value * fold / threshold_law(f.by, f.omega)};
  });

  // The errors
  const auto name = table.texts("name"), way = table.texts("way");
  const auto a = table.numbers("threshold"), rough = table.numbers("rougher"),
             bracket = table.numbers("bracket");
  const auto lasts = [&](std::size_t k) { return way[k] == "lasting" || way[k] == "down"; };
  for (std::size_t k = 0; k < a.size(); ++k) {
    double change = std::abs(a[k] - rough[k]);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (name[i] == name[k] && lasts(i) && lasts(k))
        change = std::max(change, std::abs(a[i] - rough[i]));
    report.facts.add(name[k] + "_" + way[k], {a[k], change + bracket[k] / 2}, "um");
  }
}

/**
[](finding:driving.onset) Under a slow rise (*up*) the threshold comes to the fold, from below. Lasting emission begins
below the fold, whether the drive is switched on or comes down. In between the array emits or not, depending on its
history. Amplitudes are in µm.

| drive | fold | up | lasting | down | once |
|---|---|---|---|---|---|
| piston, $\delta = 0.1$ | [5.788 ± 0.003](num:sec5_driving.threshold_first_fold) | [5.77 ± 0.01](num:sec5_driving.threshold_first_up) | [5.53 ± 0.07](num:sec5_driving.threshold_first_lasting) | [5.56 ± 0.07](num:sec5_driving.threshold_first_down) | [5.07 ± 0.01](num:sec5_driving.threshold_first_once) |
| piston, 0.109 (7000 Hz) | [6.970 ± 0.004](num:sec5_driving.recipe_7000) | | [6.62 ± 0.05](num:sec5_driving.recipe_7000_lasting) | | [6.09 ± 0.01](num:sec5_driving.recipe_7000_once) |
| piston, 0.2 | [25.76 ± 0.02](num:sec5_driving.threshold_second_fold) | [25.7 ± 0.2](num:sec5_driving.threshold_second_up) | [24.1 ± 0.3](num:sec5_driving.threshold_second_lasting) | [24.0 ± 0.3](num:sec5_driving.threshold_second_down) | [22.27 ± 0.08](num:sec5_driving.threshold_second_once) |
| base, 0.1 | [0.754976 ± 3e-6](num:sec5_driving.base_first_fold) | [0.7530 ± 0.0004](num:sec5_driving.base_first_up) | [0.721 ± 0.002](num:sec5_driving.base_first_lasting) | | [0.5658 ± 0.0005](num:sec5_driving.base_first_once) |
| base, 0.2 | [7.80072 ± 5e-5](num:sec5_driving.base_second_fold) | [7.79 ± 0.02](num:sec5_driving.base_second_up) | [7.49 ± 0.02](num:sec5_driving.base_second_lasting) | | [5.61 ± 0.01](num:sec5_driving.base_second_once) |

A sudden drive shakes the first bead more than the non-emitting orbit does, so that one packet leaves below the
threshold of lasting emission, and no other follows. A base that is switched on sends something weaker at weaker drives
too, which would count if the detector were ten times as sensitive. Both are tested (`beyond/tests/sec5/driven_chain.cpp`).

## A chart over frequency and amplitude (figure x27 c and d)

A piston drives an array of 300 beads at seven frequencies and ten amplitudes. Its amplitude rises during a twelfth of
the run, 0.12 s. Nothing passes the detector, or packets do, and their emission is *periodic* if the intervals between
them differ by less than a tenth in the second half of the run, and *irregular* otherwise. */
std::ptrdiff_t late_packets(const Sent& sent, double time) {
  return std::count_if(sent.passages.begin(), sent.passages.end(),
                       [&](double t) { return t >= time / 2; });
}

/// Relative standard deviation of the intervals in the second half; -1 if there are fewer than three.
double spread(const std::vector<double>& passages, double time) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < passages.size(); ++k)
    if (passages[k - 1] >= time / 2) gaps.push_back(passages[k] - passages[k - 1]);
  if (gaps.size() < 3) return -1;
  double mean = 0, square = 0;
  for (double g : gaps) mean += g / double(gaps.size());
  for (double g : gaps) square += (g - mean) * (g - mean) / double(gaps.size());
  return std::sqrt(square) / mean;
}

Sweep chart_of(const std::filesystem::path& folder, const BeamArray& beams, bool quick, Part part) {
  const std::size_t frequencies = quick ? 2 : 7, amplitudes = quick ? 3 : 10;
  Sweep sweep{
      folder,
      "chart",
      {number("delta", "relative detuning from the beams' frequency"),
       number("frequency", "of the piston", "Hz"),
       number("ratio", "amplitude divided by the asymptotic threshold"),
       number("amplitude", "of the piston", "um"),
       count("kind",
             "0: no emission, 1: periodic emission, 2: irregular, or fewer than four packets"),
       count("kind_rough", "the same for half the time and steps twice as long"),
       number("rate", "packets per second that pass the detector site", "1/s"),
       number("rate_rough", "the same for half the time and steps twice as long", "1/s"),
       number("spread",
              "relative standard deviation of the intervals between packets; -1: too few packets"),
       number("power", "mean power of the drive", "W"),
       number("power_rough", "the same for half the time and steps twice as long", "W"),
       number("far", "largest displacement of the last bead", "um")},
      frequencies * amplitudes,
      std::string("chart of a driven array, ") + (quick ? "quick" : "full")};
  const auto kind = [](const Sent& sent, double time) {
    const double gaps = spread(sent.passages, time);
    return sent.passages.empty() ? 0 : gaps >= 0 && gaps < 0.1 ? 1 : 2;
  };
  const auto rate = [&](const Sent& sent, double time) {
    return double(late_packets(sent, time)) / (time / 2) * beams.per_second(1);
  };
  // Each point twice
  sweep.compute(part, [&](std::size_t i) {
    const double delta = 0.1 + 0.05 * double(i / amplitudes), k = double(i % amplitudes);
    const double ratio = quick ? 0.7 + 0.6 * k : 0.6 + 0.25 * k, time = quick ? 2400 : 4800;
    const double omega = 1 + delta, a = ratio * threshold_law(By::piston, omega);
    const DrivenChain array = beams.driven({By::piston, omega, a, 0, time / 12}, 300);
    const Sent rough = drive(array, time / 2, 0.2), fine = drive(array, time, 0.1);
    return Cells{delta,
                 beams.hertz(omega),
                 ratio,
                 beams.micrometres(a),
                 kind(fine, time),
                 kind(rough, time / 2),
                 rate(fine, time),
                 rate(rough, time / 2),
                 spread(fine.passages, time),
                 beams.watts(fine.power),
                 beams.watts(rough.power),
                 beams.micrometres(fine.far)};
  });
  return sweep;
}

/**
Each point has a second run, half as long and with twice the step. Where irregular emission becomes periodic after a
while, or where a step decides, the two are of different kinds. At the strongest drives the last bead moves, so that
something may come back.

| points of the chart, of 70 | here |
|---|---|
| whose two runs are of different kinds | [2](num:sec5_driving.chart_undecided) |
| whose last bead moves by more than a millionth of the amplitude | [13](num:sec5_driving.chart_reached) | */
void report_chart(Report& report, const BeamArray& beams) {
  const Sweep sweep = chart_of(report.output.folder(), beams, report.quick, {});
  const Table table = sweep.table();
  const auto kind = table.numbers("kind"), rough = table.numbers("kind_rough");
  const auto far = table.numbers("far"), a = table.numbers("amplitude");
  std::size_t undecided = 0, reached = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) {
    undecided += kind[i] != rough[i];
    reached += far[i] > 1e-6 * a[i];
  }
  report.facts.add("chart_undecided", exact(double(undecided)));
  report.facts.add("chart_reached", exact(double(reached)));
  report.output.add("chart", table);
  sweep.forget();
}

/**
## What the packets are (figure x29)

In the frame that turns with a free bead, $z_n = e^{it}(y_n+i\dot y_n)$, a travelling breather repeats itself one site
further on after the *shift time* $T$ but for a phase, $z_n(t+T) = e^{-i\varphi}z_{n-1}(t)$. The chain has such
breathers on curves $\varphi = 2\pi k-T$, one *family* for each integer $k$ (`sec5_travelling_breathers`), and on a
family $T$ fixes energy and width. If the packets of a drive are travelling breathers, their $T$ and $\varphi$ must
therefore predict both, and nothing is fitted. We measure $T$ as the mean time from one bead to the next and $\varphi$
as the mean angle by which the seven $z_n$ about the centre have turned back (packet_members.hpp), on beads 12 to 28.
The piston begins at once at $\delta = 0.1$, and there are no losses.

![The first packet of a drive against its strength. Drawn by x29_driven_packets.py: `family` and `phase`, `energy_ratio`
and `width_ratio` of `strengths` over `strength`.](fig:x29) */
/// `strength`: of the piston over the asymptotic threshold, 0 for an impact of 1 m/s; `lifetime` in ms, 0: no losses.
Traveller packet(double strength, double lifetime, const WatchedBeads& stretch, double step) {
  BeamArray beams;
  beams.lifetime = lifetime;
  const Drive drive{strength > 0 ? By::piston : By::nothing, 1.1,
                    strength * threshold_law(By::piston, 1.1)};
  // So long that earlier packets are not back from the far end before the fifth has passed
  State<double> start(240);
  if (strength == 0) start.v[0] = beams.velocity(1);
  return traveller_on(beams.driven(drive, 240), start, 3000, step, stretch);
}

/// On the whole stretch, from two beads later on with twice the step, and on either half.
Looks look_at(double strength, double lifetime, const WatchedBeads& stretch) {
  const auto look = [&](std::size_t from, std::size_t to, double step) {
    return packet(strength, lifetime, {from, to, stretch.which}, step);
  };
  const auto& [from, to, which] = stretch;
  const std::size_t middle = (from + to) / 2;
  return {look(from, to, 0.1), look(from + 2, to, 0.2), look(from, middle, 0.1),
          look(middle, to, 0.1)};
}

double phase_of(const Traveller& p) {
  return p.phase;
}

/**
The oscillation within a packet makes all means fluctuate, and a packet changes on its way. So we look four times: on
the whole stretch; on one that begins two beads later, with twice the step; and on either half. The error is the
difference of the first two looks, or half of that of the last two if it is larger. A packet may lie between the curves
of the families. There we join the members of families 2 to 5 with six phases each by polynomials; the change made by
leaving out the farthest member belongs to the error, too. Beyond them there is no ratio. */
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
               [&](std::size_t i) { looks[i] = look_at(i < count ? strengths[i] : 0, 0, {}); });

  // What each packet is
  const auto seen = [](const std::string& name, const std::string& meaning) {
    return Columns{number(name, meaning),
                   number(name + "_spread", "largest difference between repeated measurements")};
  };
  Table& table = report.table(
      "strengths",
      {number("strength", "amplitude of the piston divided by the asymptotic threshold"),
       seen("phase", "phase advance from site to site"),
       seen("family", "(shift time + phase) / 2 pi"),
       seen("energy_ratio", "energy divided by that of the family member"),
       seen("width_ratio", "width divided by that of the family member")});
  std::vector<Estimate> family(count), energy(count), width(count);
  for (std::size_t i = 0; i < count; ++i) {
    family[i] = looks[i](family_of);
    energy[i] = families.ratio(looks[i], &Traveller::energy);
    width[i] = families.ratio(looks[i], &Traveller::width);
    table.add({strengths[i], looks[i](phase_of), family[i], energy[i], width[i]});
  }

  // How far from the families, how sharp the test, and whether anything stays the same
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < count; ++i)
    least = std::min(least, std::abs(family[i].value - family[i - 1].value) /
                                (family[i].error + family[i - 1].error));
  const auto mistimed = [&](const Traveller& p) {
    Traveller later = p;
    later.phase += 0.1;
    return families.over(later, &Traveller::energy) / families.over(p, &Traveller::energy);
  };
  report.facts.add("energy_ratio_worst", farthest_from_one(energy));
  report.facts.add("width_ratio_worst", farthest_from_one(width));
  report.facts.add("energy_ratio_impact", families.ratio(looks.back(), &Traveller::energy));
  report.facts.add("energy_ratio_mistimed", looks[report.quick ? 1 : 7](mistimed));
  report.facts.add("family_least_change", exact(least), "sum of two errors");
}

/**
[](finding:driving.packets) The test is of one combination of $T$ and $\varphi$: a phase that is wrong by a tenth
changes the ratio by a seventh, while an error in time is hardly seen. The width tests little. At the two strongest
drives the four looks differ, and the ratio is uncertain by more than one per cent. The packet of an impact still
radiates a tail.

A drive that locked its packets to an exact breather would keep $(T+\varphi)/2\pi$ at an integer over a range of
strengths. From each of the seventeen strengths to the next it changes by more than the errors of both, so that a
plateau could only hide between two of them. A packet is exact if besides $\varphi$ is zero or the sum of all $y_n+i\dot
y_n$ is. No packet meets both conditions; those near 1.23 and 1.63 nearly do.

| quantity | expected | here |
|---|---|---|
| ratio of energies, farthest from one | 1 | [1.009 ± 0.005](num:sec5_driving.energy_ratio_worst) |
| ratio of widths, farthest from one | 1 | [0.986 ± 0.002](num:sec5_driving.width_ratio_worst) |
| ratio of energies after an impact of 1 m/s | 1 | [1.009 ± 0.007](num:sec5_driving.energy_ratio_impact) |
| factor by which a phase that is wrong by 0.1 changes it | | [0.8636 ± 0.0006](num:sec5_driving.energy_ratio_mistimed) |
| least change of $(T+\varphi)/2\pi$ over the sum of both errors | above 1 if nothing locks | [1.58478](num:sec5_driving.family_least_change) |

## How well this is known

A closed budget does not see the error of alternating losses, drive and motion, which is of order two in the step; that
one is in the differences between two steps. The array must be long, or packets come back from its far end and pass the
detector again. To see this we let a piston at $\delta = 0.2$ come down from twice the asymptotic threshold to 1.04
times it, and count packets in the second half of 0.1 s. Three drives, a non-emitting piston, one that emits and a base,
are also computed with the small steps of the command `drive`. It must count the same packets as the chapter. */
void report_far_end(Report& report, const BeamArray& beams) {
  const double law = threshold_law(By::piston, 1.2);
  for (const std::size_t sites : {30, 120, 300}) {
    const auto late = [&](double step) {
      const Drive falling{By::piston, 1.2, 1.04 * law, 2 * law, 1333};
      return late_packets(drive(beams.driven(falling, sites), 4000, step), 4000);
    };
    report.facts.add("late_" + std::to_string(sites), compare(late(0.4), late(0.2)));
  }
}

void report_budget(Report& report) {
  std::vector<DrivenArray> cases(3);
  for (DrivenArray& one : cases) one.duration = 20;
  cases[1].amplitude = 20;
  cases[2].by = By::base;
  Estimate most{};
  for (const DrivenArray& one : cases) {
    const Emission rough = one.run(2 * one.step), fine = one.run(one.step);
    most = larger(most, compare(rough.budget, fine.budget));
    if (drive(one.driven(), one.horizon(), one.step).passages != fine.passages)
      throw Failure("the command and the chapter count different packets");
  }
  report.facts.add("budget", most);
  if (!(most.value < 1e-10))
    throw Failure("the energy budget is open by " + number_text(most.value));
}

/**
| quantity | expected | here |
|---|---|---|
| packets that pass late in an array of 30 beads | 0 | [17 ± 1](num:sec5_driving.late_30) |
| of 120 beads, as for the thresholds | 0 | [0](num:sec5_driving.late_120) |
| of 300 beads, as for the chart | 0 | [0](num:sec5_driving.late_300) |
| energy and losses less work, over the most energy that was there or came in | 0 | [1e-12](num:sec5_driving.budget) |

The fold has independent routes: slow runs, Newton's method, and the map of the DpS limit, which shares no code with the
others; at 7000 Hz another program finds it too (`tests/second`). The article has no number for such a drive. All
thresholds are for one lifetime and for one sensitivity of the detector. The fold alone does not determine the motion
beyond it; runs do.

## With your own parameters

`drive` shows the result of one drive, `packet` the properties of a packet, and `chart --part 1/10` computes a tenth of
the chart.
*/
struct OneDrive : DrivenArray {
  static constexpr Title title{"drive", "packets that a driven array emits"};

  void parameters(Parameters& p) {
    p.add("frequency", frequency, "frequency of the drive in Hz", {500, 20000, "Hz"});
    p.add("amplitude", amplitude, "amplitude of the piston or base in micrometres", {0, 200, "um"});
    p.add("by", by, "type of drive: a piston that touches the first bead, or the first base",
          {{"piston", By::piston}, {"base", By::base}});
    p.add("lifetime", lifetime, "lifetime of the energy of a freely oscillating beam, in ms",
          {0.5, 1e6, "ms"});
    p.add("time", duration, "duration of the drive in ms; less than 20 ms is a transient",
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

/// Shift time, phase, energy and width of one packet, and what they are over those of a breather of the families.
struct OnePacket {
  static constexpr Title title{
      "packet",
      "one packet of a driven or struck array, compared with the family of travelling breathers"};
  double strength = 1.3, lifetime = 0;
  std::size_t which = 1, from = 12, beads = 16;

  void parameters(Parameters& p) {
    p.add("strength", strength,
          "amplitude of the piston divided by the asymptotic threshold; 0: an impact at 1 m/s "
          "instead",
          {0, 2.4});
    p.add("lifetime", lifetime,
          "lifetime of the energy of a freely oscillating beam, in ms; 0: no losses",
          {0, 1e6, "ms"});
    p.add("which", which, "number of the packet, in the order of arrival at bead --from", {1, 5});
    p.add("from", from, "first bead of the stretch over which the packet is measured", {5, 70});
    p.add("beads", beads, "length of this stretch", {8, 40});
  }
  Table table() const {
    // Beyond the members that we have there is no ratio
    const Looks looks = look_at(strength, lifetime, {from, from + beads, which});
    const Families families;
    const std::string beyond =
        "at least one of four measurements lies outside the computed members: family 2 to 5, phase "
        "-0.4 to 0.75";
    Answers q;
    q.add("shift_time", looks([](const Traveller& p) { return p.shift_time; }), "tau_c",
          "shift time: the time from site to site");
    q.add_small("phase", looks(phase_of), "",
                "phase advance from site to site, in the rotating frame of a single bead");
    q.add("family", looks(family_of), "",
          "(shift time + phase) / 2 pi, a whole number for an exact breather");
    q.add("energy", looks([](const Traveller& p) { return p.energy; }), "units of the chain",
          "geometric mean over time of the energy on the seven sites about the peak");
    q.add("energy_ratio", families.ratio(looks, &Traveller::energy), "",
          "energy divided by that of the family member with this shift time and phase", beyond);
    q.add("width_ratio", families.ratio(looks, &Traveller::width), "",
          "mean participation number of these sites divided by that of the same member", beyond);
    return q.table;
  }
};

struct Chart : MapPart {
  static constexpr Title title{
      "chart", "chart of the emission over frequency and amplitude of the drive, or a part of it"};

  Table table() const { return chart_of(folder, {}, false, mine()).table(mine()); }
};

void reproduce(Report& report) {
  const BeamArray beams;
  const std::vector<Fold> folds = report_folds(report, beams);
  report_orbits(report, beams);
  report_thresholds(report, beams, folds);
  report_far_end(report, beams);
  report_maps(report, beams);
  report_budget(report);
  report_packets(report);
  report_chart(report, beams);
}

/**
## Try it

**To change it.** Other losses, wells or masses are members of the chain in `BeamArray::driven`, another drive is a line
of `Drive::force` (driven_chain.cpp), and what counts as a packet stands in `PacketCounter::passes` (driven_array.cpp).
The frequencies are those of `fold_points` and `chart_of`. The figures read columns by name.

1. *Easy.* How far must a piston move at 6600 Hz instead of 7000?
   `build/bin/sec5_driving drive --frequency 6600 --time 20` gives `threshold_law` = 1.08769.
   Hint: the table of folds has the frequency of the beams; how does the threshold go with $\delta$?
2. *Easy.* What does the end do below the fold, at 4 µm? `build/bin/sec5_driving drive --amplitude 4 --time 20` gives
   `response` = 1.3200. Hint: this is a point of the lower branch of non-emitting orbits. By which factor does it jump
   at 7 µm, with emission?
3. *Harder.* Do losses move the threshold? With a lifetime of 1 ms and 7 µm nothing passes the detector:
   `build/bin/sec5_driving drive --amplitude 7 --lifetime 1 --time 20` gives `response` = 4.0521. Hint: either the fold
   is above 7 µm now, or packets die before bead 20. Is the response that of a non-emitting or of an emitting end?
4. *Harder.* Is a packet that loses energy still a breather of the family?
   `build/bin/sec5_driving packet --lifetime 10 --from 9 --beads 8` gives `energy_ratio` = 1.01. Hint: shift time and
   phase change on the way, and the energy with them. The ratio compares all three at the same place.
5. *Open.* Where does periodic emission become irregular, and is this a bifurcation of the periodic motion?
6. *Open.* Which law gives the phase of a driven packet as a function of strength and frequency? */
int main(int argc, char** argv) {
  return run({"sec5_driving", "5", "Driving an array at one end (section 5)", reproduce,
              commands<OneDrive, Chart, OnePacket>()},
             argc, argv);
}
