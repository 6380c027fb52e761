/**
# 5 Driving an array at one end

"A related aspect concerns the actuation of the system through the driving of a bead with a particular frequency",
says the conclusion of James, Kevrekidis and Cuevas (Physica D 251, 2013): it is hard to prepare an array, and easy
to shake its end. We shake the array of section 3.6, with a piston that touches the first bead or with the base of
the first beam.

![Thresholds of a driven array, and what it does beside them.](fig:x27)
![Energy in a driven array below, just above and far above the threshold.](fig:x28)

All beams have one frequency, so nothing travels at small amplitude, and a drive above that frequency should shake
the first beads only. It does so up to a sharp amplitude; beyond it the array sends out breathers (what kind of
breathers is another chapter, `sec5_driven_packets`). */

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "report/program.hpp"
#include "report/sweep.hpp"
#include "sec5/driven_array.hpp"

using namespace lattice;

/**
In short: the threshold is the fold of the quiet motion, whose amplitude grows with the square of the distance
$\delta = f/f_0-1$ from the frequency of a beam for a piston, and with its cube for a base. The constants are those
of a static breather of the DpS equation, which the drive has to lift to its top: [0.0504148](num:sec5_driving.top)
is the largest displacement of the site-centred one (section 3.2). At 7000 Hz a piston needs
[6.970](num:sec5_driving.recipe_7000) micrometres.

## Model

The chain is that of bench.hpp with beams of 10 ms lifetime; thresholds and folds are explained in driven.hpp.

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
## The fold against the law of the DpS limit

The quiet orbit has the period of the drive. Newton's method follows it from a weak drive through the fold, at two
numbers of steps per period and two distances along the curve. The ratio of fold and law tends to one with $\delta$,
faster for the piston; damping, which the law leaves out, keeps it from doing so altogether. */
struct Fold {
  Drive::By by;
  double delta;
};

std::vector<Fold> fold_points(bool quick) {
  const auto piston = Drive::By::piston, base = Drive::By::base;
  if (quick) return {{piston, 0.1}, {base, 0.1}};
  return {{piston, 0.05}, {piston, 0.1}, {piston, 0.2}, {piston, 0.35},
          {base, 0.05},   {base, 0.1},   {base, 0.2}};
}

Estimate fold_of(const Rig& rig, Drive::By by, double omega) {
  const Bench bench = rig.bench(by, omega, 0, 0, 0, 10);
  return compare(quiet_branch(bench, 32, 0.1).fold, quiet_branch(bench, 64, 0.05).fold);
}

void report_folds(Report& report, const Rig& rig) {
  report.facts.add("top", exact(dps_threshold(Drive::By::piston)));
  report.facts.add("top_strain", exact(dps_threshold(Drive::By::base)));
  Table& table = report.table(
      "folds",
      {label("by", "what is driven"), number("delta", "distance from the beams' frequency"),
       number("frequency", "of the drive", "Hz"), estimate("fold", "amplitude of the fold", "um"),
       number("law", "the same in the DpS limit", "um"), estimate("ratio", "of the two")});
  table.fill(fold_points(report.quick), [&](const Fold& p) {
    const Estimate fold = fold_of(rig, p.by, 1 + p.delta);
    const double law = threshold_law(p.by, 1 + p.delta), unit = rig.micrometres(1);
    return Cells{name_of(p.by),
                 p.delta,
                 rig.hertz(1 + p.delta),
                 Estimate{fold.value * unit, fold.error * unit},
                 law * unit,
                 Estimate{fold.value / law, fold.error / law}};
  });
  // The quiet orbits themselves, for the figure
  const double omega = 1.1, unit = rig.micrometres(1);
  const auto branch = quiet_branch(rig.bench(Drive::By::piston, omega, 0, 0, 0, 10), 64, 0.1);
  Table& orbits =
      report.table("quiet_orbits", {number("amplitude", "of the piston", "um"),
                                    number("response",
                                           "of the first bead in the orbit, its amplitude at the "
                                           "beginning of a period",
                                           "um")});
  for (std::size_t k = 0; k < branch.amplitude.size(); ++k)
    orbits.add({branch.amplitude[k] * unit, branch.response[k] * unit});
}

/**
## Thresholds, up and down

A threshold depends on how one comes to it. We raise the amplitude slowly from zero, switch the drive on at once, or
come down slowly from twice the law. Upward and at once the first packet at the gate decides. Downward the array
still holds packets of the stronger drive, so that it is the power that decides: emission goes on if the drive gives
more than twice as much in the second half of the run as to the quiet motion of the same amplitude. The array must be
long, or packets come back from the far end and pass the gate again: at $\delta = 0.2$ and 1.04 times the law a drive
that comes down gives [43](num:sec5_driving.power_left_50) times the power of the quiet motion in an array of 50 beads,
[1.01](num:sec5_driving.power_left_120) times in our 120 and [1.01](num:sec5_driving.power_left_240) times in 240.

Downward there is no sharp amplitude. Near the threshold emission stops after a time that is erratic, so that a
stronger drive may be quiet where a weaker one still emits. After halving an interval we therefore look at eleven
amplitudes around the result: the threshold lies between the highest quiet and the lowest one that emits. Each
threshold comes from two runs, of which one is half as long, has a ramp twice as fast and twice the step. */
enum class Way { up, once, down };

/// How long a run is, and its step.
struct Patience {
  double horizon, step;
};

/// The power that a drive gives coming down from twice the law over that of the quiet motion; infinite without one.
double power_left(const Rig& rig, double omega, double a, const Patience& p,
                  std::size_t sites = Rig::sites) {
  const auto by = Drive::By::piston;
  // The quiet motion settles within ten lifetimes
  const double rise = std::min(p.horizon, 4000.0);
  const Emission quiet =
      drive_chain(rig.bench(by, omega, a, 0, rise / 3, sites), rise, Rig::gate, p.step, 1);
  if (!quiet.passages.empty()) return std::numeric_limits<double>::infinity();
  // Down in a third of the run
  const double twice = 2 * threshold_law(by, omega);
  const Bench falling = rig.bench(by, omega, a, twice, p.horizon / 3, sites);
  return drive_chain(falling, p.horizon, Rig::gate, p.step).power / quiet.power;
}

/// Is something sent through the gate?
bool emits(const Rig& rig, Way way, double omega, double a, const Patience& p) {
  if (way == Way::down) return power_left(rig, omega, a, p) > 2;
  const Bench bench =
      rig.bench(Drive::By::piston, omega, a, 0, way == Way::once ? 0 : p.horizon / 2);
  return !drive_chain(bench, p.horizon, Rig::gate, p.step, 1).passages.empty();
}

struct Threshold {
  Way way;
  double omega;
};

Estimate threshold_at(const Rig& rig, const Threshold& t, const Patience& p, double accuracy) {
  const double law = threshold_law(Drive::By::piston, t.omega);
  const auto sends = [&](double a) { return emits(rig, t.way, t.omega, a, p); };
  // Upward and at once there is one edge, downward the middle of a strip
  if (t.way != Way::down) return bisect_threshold(0.3 * law, 1.9 * law, accuracy, sends);
  const Estimate halved = bisect_threshold(0.9 * law, 1.4 * law, 2 * accuracy, sends);
  return threshold_among(halved.value, accuracy / 2 * law, 5, sends);
}

void report_thresholds(Report& report, const Rig& rig) {
  const auto way_name = [](Way w) {
    return w == Way::up ? "up" : w == Way::once ? "once" : "down";
  };
  std::vector<Threshold> points;
  for (double omega : report.quick ? std::vector{1.2} : std::vector{1.1, 1.2})
    for (Way w : {Way::up, Way::once, Way::down}) points.push_back({w, omega});
  const double accuracy = report.quick ? 0.05 : 0.01;
  const Patience rising{report.quick ? 800.0 : 3000, 0.2},
      falling{report.quick ? 4000.0 : 16000, 0.2};
  Table& table = report.table(
      "thresholds",
      {label("way", "slowly up, at once, or slowly down"),
       number("delta", "distance from the beams' frequency"),
       number("frequency", "of the piston", "Hz"),
       number("threshold", "amplitude above which packets come", "um"),
       number("at_half", "the same from runs half as long with twice the step", "um"),
       number("bracket", "between the highest quiet amplitude and the lowest that emits", "um"),
       number("over_law", "the same over the law of the DpS limit")});

  // Each threshold from runs of two lengths
  table.fill(points, [&](const Threshold& t) {
    const Patience& whole = t.way == Way::down ? falling : rising;
    const Estimate half = threshold_at(rig, t, {whole.horizon / 2, 2 * whole.step}, accuracy);
    const Estimate full = threshold_at(rig, t, whole, accuracy);
    const double unit = rig.micrometres(1);
    return Cells{way_name(t.way),
                 t.omega - 1,
                 rig.hertz(t.omega),
                 full.value * unit,
                 half.value * unit,
                 2 * full.error * unit,
                 full.value / threshold_law(Drive::By::piston, t.omega)};
  });
  const auto a = table.numbers("threshold"), half = table.numbers("at_half"),
             bracket = table.numbers("bracket");
  const auto name = [&](std::size_t k) {
    return std::string(k < 3 ? "threshold_first_" : "threshold_second_") + table.texts("way")[k];
  };
  for (std::size_t k = 0; k < a.size(); ++k)
    report.facts.add(name(k), {a[k], std::abs(a[k] - half[k]) + bracket[k] / 2}, "um");

  // Does the far end matter?
  for (const std::size_t sites : {50, 120, 240}) {
    const double drive = 1.04 * threshold_law(Drive::By::piston, 1.2);
    const auto left = [&](double step) { return power_left(rig, 1.2, drive, {4000, step}, sites); };
    report.facts.add("power_left_" + std::to_string(sites), compare(left(0.4), left(0.2)));
  }
}

/**
Slowly upward the threshold comes to the fold from below as the ramp becomes slower:
[5.75](num:sec5_driving.threshold_first_up) µm at $\delta = 0.1$. At once it is
[5.07](num:sec5_driving.threshold_first_once) µm, since the onset shakes the bead more than the orbit does; another
onset shakes it less. Downward emission ends at [5.53](num:sec5_driving.threshold_first_down) µm, below the fold: in
between the array is quiet or emits, as it was before. At $\delta = 0.2$ the same numbers are
[25.6](num:sec5_driving.threshold_second_up), [22.22](num:sec5_driving.threshold_second_once) and
[24.0](num:sec5_driving.threshold_second_down) µm.

## A chart for the bench

The chart goes over frequencies and amplitudes in units of the law and holds the rate of packets, how regular they
are and what power the drive gives. A drive below its threshold is *quiet* (nothing passes the gate), one above it
makes a *train* if the intervals between packets differ by less than a tenth, and is *irregular* otherwise. Each point
has a second run, half as long and with twice the step: where an irregular drive becomes a train after a while, or
where a step decides, the two are of different kinds, at [8](num:sec5_driving.chart_undecided) of the 70 points. The
points are independent; `chart --part k/n` computes a part of them. */
struct ChartPoint {
  double delta, ratio;
};

std::vector<ChartPoint> chart_points(bool quick) {
  std::vector<ChartPoint> out;
  for (int i = 0; i < (quick ? 2 : 7); ++i)
    for (int k = 0; k < (quick ? 3 : 10); ++k)
      out.push_back({0.1 + 0.05 * i, quick ? 0.7 + 0.6 * k : 0.6 + 0.25 * k});
  return out;
}

// The table that holds the chart
Sweep chart_sweep(const std::filesystem::path& folder, bool quick) {
  const Columns columns{
      number("delta", "distance from the beams' frequency"),
      number("frequency", "of the piston", "Hz"),
      number("ratio", "amplitude over the law of the DpS limit"),
      number("amplitude", "of the piston", "um"),
      count("kind", "0 quiet, 1 train, 2 irregular or fewer than four packets"),
      count("kind_rough", "the same for half the time and steps twice as long"),
      number("rate", "packets that pass the gate", "1/s"),
      number("rate_rough", "the same for half the time and steps twice as long", "1/s"),
      number("spread", "relative standard deviation of their intervals; -1: too few"),
      number("power", "mean power of the drive", "W"),
      number("power_rough", "the same for half the time and steps twice as long", "W")};
  return {folder, "chart", columns, chart_points(quick).size(),
          std::string("chart of a driven array, ") + (quick ? "quick" : "full")};
}

int kind_of(const Emission& e, double horizon) {
  const double spread = e.spread(horizon);
  return e.passages.empty() ? 0 : spread >= 0 && spread < 0.1 ? 1 : 2;
}

// Each point twice: is it quiet, a train or irregular?
void compute_chart(Sweep& sweep, const Rig& rig, bool quick, Part part) {
  const auto points = chart_points(quick);
  const double horizon = quick ? 2400 : 4800;
  sweep.compute(part, [&](std::size_t i) {
    const ChartPoint& p = points[i];
    const double omega = 1 + p.delta, a = p.ratio * threshold_law(Drive::By::piston, omega);
    const Bench bench = rig.bench(Drive::By::piston, omega, a, 0, horizon / 12);
    const Emission coarse = drive_chain(bench, horizon / 2, Rig::gate, 0.4);
    const Emission fine = drive_chain(bench, horizon, Rig::gate, 0.2);
    const double per_second = rig.per_second(1);
    return Cells{p.delta,
                 rig.hertz(omega),
                 p.ratio,
                 rig.micrometres(a),
                 kind_of(fine, horizon),
                 kind_of(coarse, horizon / 2),
                 fine.rate(horizon) * per_second,
                 coarse.rate(horizon / 2) * per_second,
                 fine.spread(horizon),
                 rig.watts(fine.power),
                 rig.watts(coarse.power)};
  });
}

void report_chart(Report& report, const Rig& rig) {
  Sweep sweep = chart_sweep(report.output.folder(), report.quick);
  compute_chart(sweep, rig, report.quick, {});
  const Table table = sweep.table();
  const auto kind = table.numbers("kind"), rough = table.numbers("kind_rough");
  // How many points are of a kind, and how many more or fewer by the shorter runs
  const auto of_kind = [&](double k) {
    return compare(double(std::count(rough.begin(), rough.end(), k)),
                   double(std::count(kind.begin(), kind.end(), k)));
  };
  std::size_t undecided = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) undecided += kind[i] != rough[i];
  report.facts.add("chart_trains", of_kind(1));
  report.facts.add("chart_irregular", of_kind(2));
  report.facts.add("chart_undecided", exact(double(undecided)));
  report.output.add("chart", table);
  sweep.forget();
}

/**
The second figure shows the three kinds in space and time, for a piston at $\delta = 0.1$. */
void report_maps(Report& report, const Rig& rig) {
  const std::array<double, 3> ratios{0.95, 1.3, 3};
  const std::size_t bins = report.quick ? 40 : 160, sites = Rig::sites;
  const double omega = 1.1, horizon = 2000;
  std::array<std::vector<double>, 3> maps;
  parallel_for(3, [&](std::size_t i) {
    const double a = ratios[i] * threshold_law(Drive::By::piston, omega);
    maps[i] = drive_map(rig.bench(Drive::By::piston, omega, a, 0, 300), horizon, bins, 0.2);
  });
  Table& table = report.table(
      "maps",
      {number("ratio", "amplitude over the law of the DpS limit"),
       number("t", "middle of the time interval", "ms"), count("n", "bead", "site"),
       number("energy", "largest energy of the bead in the interval, without contacts", "J")});
  const double unit = rig.scales.unit_energy();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t bin = 0; bin < bins; ++bin)
      for (std::size_t n = 0; n < DrivenArray::drawn; ++n)
        table.add({ratios[i], rig.milliseconds((double(bin) + 0.5) * horizon / double(bins)),
                   std::int64_t(n + 1), maps[i][bin * sites + n] * unit});
}

/**
## A recipe

Whoever builds the array wants numbers for the bench: frequency, and the amplitude of the fold in micrometres, with a
lifetime of 10 ms. Close to the beams' frequency small amplitudes suffice, but the packets are slow and damping stops
them early. */
void report_recipe(Report& report, const Rig& rig) {
  const Estimate fold = fold_of(rig, Drive::By::piston, rig.omega(7000));
  const double unit = rig.micrometres(1);
  report.facts.add("recipe_7000", {fold.value * unit, fold.error * unit}, "um");
  report.facts.add("recipe_7000_law",
                   exact(threshold_law(Drive::By::piston, rig.omega(7000)) * unit), "um");
  report.facts.add("beam_frequency", exact(rig.hertz(1)), "Hz");
}

/**
The books are kept whether anything is sent out or not. Three drives with the steps of the command show how well they
close. */
void report_ledger(Report& report) {
  std::vector<DrivenArray> cases(3);
  for (DrivenArray& drive : cases) drive.duration = 20;
  cases[1].amplitude = 20;
  cases[2].by = Drive::By::base;
  Estimate most{};
  for (const DrivenArray& drive : cases)
    most = larger(most, compare(drive.run(2 * drive.step).ledger, drive.run(drive.step).ledger));
  report.facts.add("ledger", most);
  if (!(most.value < 1e-10)) throw Failure("the ledger is open by " + number_text(most.value));
}

/**
## One drive with your own numbers

`sec5_driving drive --frequency 7000 --amplitude 5` tells what comes out. */
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
    Sweep sweep = chart_sweep(folder, false);
    compute_chart(sweep, Rig{}, false, mine());
    return sweep.table(mine());
  }
};

/**
A full run follows the chapter, with the chart at the end. */
void reproduce(Report& report) {
  const Rig rig;
  report_folds(report, rig);
  report_recipe(report, rig);
  report_thresholds(report, rig);
  report_maps(report, rig);
  report_ledger(report);
  report_chart(report, rig);
}

/**
## Checks, differences and limits

The threshold has three routes: runs, Newton's method on the driven orbit, and a map of two lines in the DpS limit,
which shares no code with the others. The bookkeeping of `drive`, energy and losses less work over the most energy
that was there or came in, closes to [1e-12](num:sec5_driving.ledger) at its steps in a quiet motion, a train and a
driven base; the program stops if it does not close to 1e-10. The piston is a bead of the same size that cannot be
pushed back; a real shaker can, and its force is what `power` tells. That a quiet motion vanishes in a fold does not
tell what comes after it: trains and irregular emission are what runs show, with one lifetime.

## Extensions

- Where is the second threshold, from trains to irregular emission, and is it a bifurcation of the train?
- Drive two ends: do trains pass through each other?
- Tune the frequency during the run and make one breather only. */
int main(int argc, char** argv) {
  return run({"sec5_driving", "5", "Driving an array at one end (section 5)", reproduce,
              commands<OneDrive, Chart>()},
             argc, argv);
}
