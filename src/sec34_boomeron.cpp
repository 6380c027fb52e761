/**
# 3.4 Packets that reverse their direction in hard wells

After an impact in hard wells, $s > 0$, the travelling breather slows down, turns round, comes back to the end that was
hit and is reflected there. How far does it get, how does it slow down, and for how long can its motion be predicted?
Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) compares it with *boomerons*, solitons that reverse
their direction, and says that

- with $s=1$ and $v_0=1.9$ the packet turns, returns and is reflected several times until its motion is erratic, while
  with $v_0 = 1.5$ it only slows down (figure 22);
- with $v_0=1.87$ it is close to turning at $t = 238$ and 241 (figure 23);
- during a few reflections its centre moves like a particle in an almost constant force, which grows with $s$ and $v_0$;
- it turns for $s\ge0.005$ and not for $s = 0$.

The first holds. The others hold only in part. How far a packet comes falls with the impact, though not evenly; *when*
it turns changes erratically, since for hundreds of units of time it hovers near its turning point; so at $v_0=1.87$ it
is there at the times of figure 23, and turns much later. The acceleration is not almost constant, and not even a
function of the position. Whether it grows with $v_0$ depends on the time over which it is averaged. At $s=0.005$ only
impacts far above those of the figures turn a packet as long as we look. And beyond the first reflection the packet of
1.9 is predictable only if $v_0$ is known to more than four digits. A chapter of volume two (`sec34_boomeron_map`) asks
which packets turn, and why.

![Energy density after impacts with 1.5 and 1.9, a zoom, and the spread of an ensemble. Drawn by
fig22_turning_maps.py: `e` over `t` and `n` from the table `density_maps`, `mean`, `low` and `high` from `ensemble`, the
dashed line from `predictable`.](fig:22)

<!-- head -->
`build/bin/sec34_boomeron` computes this chapter in 5 s on two cores and writes 14 tables to
`build/data/sec34_boomeron`. Its figures: `make fig22`, `make fig23`, `make x51`, `make x58`, `make x65`. With your
parameters: `run`, one impact: turning point, reflection at the struck end, decorrelation time.
<!-- /head -->

## Model

The chain has the wells of Eq. (10), and only its first bead moves at $t=0$, Eqs. (9) and (26):
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
All quantities are dimensionless and both ends are free. At the amplitude of the impact, $v_0$, the anharmonic force
$s\,v_0^3$ and the contact force $v_0^{3/2}$ have the ratio $\chi = s\,v_0^{3/2}$, which says how anharmonic an impact
is; for $s=1$ and $v_0=1.9$ it is 2.6. The packet is located by its energy, Eqs. (23) and (24) with $m=5$,
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + V(y_{n+1}-y_n),\qquad
  X = \sum_{|n-n'|\le m} n\,e_n \Big/ \sum_{|n-n'|\le m} e_n,$$
where $V$ is the energy of the contact to the right. Here $n'$ is the site of the largest $e_n$ in the whole chain,
because a packet on its way back need not be the foremost one. */
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "commands/one_turn.hpp"
#include "lattice/diagnostics/path.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/impact/turning.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/ensemble.hpp"

using namespace lattice;

/**
## The experiment

We strike the chain, follow the packet, smooth its path and find the turn. `strike` (impact.hpp) integrates Eq. (9) by
Runge–Kutta–Nyström steps of order six, corrected where a contact opens or closes, and records $X(t)$ every 0.2 units of
time (`path_sampling`). It throws if the last bead has moved, so that nothing can have come back from there. The beads
of the packet oscillate with a period of about four, and $X$ oscillates with them. So `smooth` averages it over 15 units
(`path_smoothing`) with the weight $1+\cos(2\pi t/15)$. `turn_of` (turning.hpp) finds three moments of the smoothed
path: the first *stop*, where the velocity vanishes; the *turning point* (`apex`), the farthest one before the packet
has come back by five sites; and the *reflection* (`rebound`), the nearest one before it has moved out again by three.
*/
constexpr double article_turning = 1.9, article_moderate = 1.5, article_profile = 1.87;  // v0
constexpr double reflected_for = 60;  // time after a reflection at which the packet is looked for
constexpr double most_drift = 1e-3;   // of the energy

struct Experiment {
  double v0 = article_turning, s = 1, time = 1200;
  std::size_t sites = 150;
  double step = 0.05;  // the shorter one of two
};

ImpactRun follow(const Experiment& of, const EventCorrected& method, const ImpactLook& look = {}) {
  const Impact impact{.velocity = of.v0,
                      .chain = {of.sites, Quartic{of.s}},
                      .time = of.time,
                      .every = path_sampling,
                      .denser = false,
                      .packet = WhichPacket::strongest};
  ImpactRun run = strike(method, impact, look);
  if (!(run.run.energy_drift < most_drift)) throw Failure("the energy is not conserved");
  return run;
}

/// Twice, with a step and half of it; `.of(number)` is the finer result with its difference from the coarser one.
TwoRuns<ImpactRun> two_runs(const Experiment& of) {
  return {follow(of, EventCorrected{2 * of.step}), follow(of, EventCorrected{of.step})};
}

Path smoothed(const ImpactRun& run) {
  return smooth(run.path, path_smoothing);
}

double centre_at(const Path& path, double t) {
  return path.centre.at(std::size_t(std::lround((t - path.t[0]) / path_sampling)));
}

/**
## The motion (figure 22)

A map of snapshots would show spurious stripes, since it would sample the packet's oscillation at nearly its own rate.
So figure 22 shows averages over four or five units of time, and over one in the zoom. The dashed line is the time up to
which the centres of impacts that differ by a millionth at most have a standard deviation of less than half a site (*How
long the motion is predictable*). */
struct Panel {
  int number;
  double v0, time, interval;
  std::size_t sites;
};
const std::vector<Panel> panels = {{1, article_moderate, 1000, 4, 110},
                                   {2, article_turning, 2500, 5, 40},
                                   {3, article_turning, 900, 1, 28}};

void report_maps(Report& report) {
  Table& table = report.table(
      "density_maps", {count("panel", "1: v0 = 1.5, 2: v0 = 1.9, 3: beginning of panel 2"),
                       number("t", "time"), count("n", "site", "site"),
                       number("e", "energy density, averaged between two successive times")});
  for (const Panel& panel : panels) {
    std::vector<double> sum(panel.sites, 0.0);
    double samples = 0, until = panel.interval;
    const auto average = [&](const State<double>& now, const std::vector<double>& e) {
      for (std::size_t n = 0; n < panel.sites; ++n) sum[n] += e[n];
      ++samples;
      if (now.t < until - 1e-9) return;
      for (std::size_t n = 0; n < panel.sites; ++n)
        table.add({panel.number, until - panel.interval / 2, n + 1, sum[n] / samples});
      sum.assign(panel.sites, 0.0);
      samples = 0;
      until += panel.interval;
    };
    follow({.v0 = panel.v0, .time = panel.time, .sites = 400},
           EventCorrected{report.quick ? 0.2 : 0.05}, average);
  }
}

/**
## Where and when the packet turns

At $v_0=1.9$ the packet reaches site [20.1](cell:turns/s=1/velocity=1.9/apex_site), comes back and is reflected at $t =$
[898](cell:turns/s=1/velocity=1.9/return_time). But this impact is printed with two digits. Over what rounds to 1.9 the
turning point falls from site [24.0](cell:turns/s=1/velocity=1.85/apex_site) to
[16.9](cell:turns/s=1/velocity=1.95/apex_site), by up to 1.3 sites from one impact to the next and not always downwards.
Its *time* jumps to and fro by hundreds: the packet slows down on a plateau, where $X$ has several maxima that are
almost equally far out, and a tenth of a site decides which of them is the farthest. Times and later motion belong to
exactly 1.9; that the packet turns and is reflected is robust.

![Turning point and its time for impacts that round to 1.9. Drawn by x65_turning_scan.gp: `apex_site` and `apex_time`
against `velocity`, from the table `printed_range`.](fig:x65)

The packet of 1.5, the article's example of slow deceleration, turns in the end too, far outside the figure: at site
[183](cell:turns/s=1/velocity=1.5/apex_site) and $t =$ [4.36e3 ± 2e1](cell:turns/s=1/velocity=1.5/apex_time). An error
has a part from the step and one from the smoothing: what half the width changes (`estimate_turn`). Near its turning
point a packet is almost at rest, so that small errors decide in which direction it moves, and steps are short. */
const std::vector<Experiment> turning = {
    {.v0 = article_moderate, .time = 5500, .sites = 260, .step = 0.025},  // a long way out
    {.v0 = article_profile, .time = 1300, .step = 0.025},
    {.v0 = article_turning, .time = 1200, .step = 0.025},
    {.v0 = 1.85, .time = 1200, .step = 0.025},
    {.v0 = 1.95, .time = 900, .step = 0.025},
    {.v0 = 132, .s = 0.005, .time = 400, .sites = 800, .step = 0.01},  // weakly hard wells
    {.v0 = 44, .s = 0.02, .time = 500, .sites = 400, .step = 0.02},
    {.v0 = 12, .s = 0.1, .time = 530, .sites = 300, .step = 0.025},
    {.v0 = 3.5, .s = 0.5, .time = 450, .step = 0.025}};

void report_turns(Report& report) {
  const auto row = [&](Experiment of) -> Row {
    if (report.quick) of.step *= 4;
    const auto runs = two_runs(of);
    const TurnEstimate turn = estimate_turn(runs.coarse.path, runs.fine.path);
    const auto out_again = [](const ImpactRun& run) {
      const Path path = smoothed(run);
      const double then = find_turn(path).rebound.time + reflected_for;
      return then < path.t.back() ? centre_at(path, then) : std::nan("");
    };
    const char *well = "from step and smoothing, known to 4 per cent; nan where there is none",
               *poorly = "from step and smoothing, known to 40 per cent; nan where there is none";
    return {{"s", "anharmonicity", of.s},
            {"velocity", "impact velocity", of.v0},
            {"apex_site", "turning point, the farthest site reached on the way out", turn.apex_site,
             "site", well},
            {"apex_time", "time of the turning point", turn.apex_time, "", well},
            {"return_time", "time of the reflection at the struck end", turn.return_time, "", well},
            {"return_site", "site of the reflection", turn.return_site, "site", poorly},
            {"out_again", "site of the centre 60 units of time after the reflection",
             runs.of(out_again), "site", poorly}};
  };
  report.table("turns").fill(turning, row, "turning packets");
}

/**
## How long the motion is predictable (figure 22, last panel)

We draw impacts at random from an interval around $v_0 = 1.9$ of relative width $10^{-4}$, $10^{-6}$ or $10^{-8}$ and
see how the standard deviation $\sigma_X$ of the centres grows. Centres of smoothed paths are compared; otherwise the
phases of the oscillations would count as a spread. */
constexpr double compared_every = 10;  // of time
constexpr double unpredictable = 0.5;  // of a site: the standard deviation from which on it is
constexpr unsigned long seed = 20130501;

/// Impacts within a fraction `noise` of 1.9.
std::vector<double> draws(double noise, std::size_t count) {
  Random random(seed);
  std::vector<double> v0(count);
  for (double& v : v0) v = article_turning * (1 + random.uniform(-noise / 2, noise / 2));
  return v0;
}

std::vector<Spread> spreads(const std::vector<double>& v0, double step, double time) {
  std::vector<Path> paths(v0.size());
  parallel_for(v0.size(), [&](std::size_t i) {
    paths[i] = smoothed(follow({.v0 = v0[i], .time = time, .sites = 300}, EventCorrected{step}));
  });
  return spread_of(paths, std::size_t(std::lround(compared_every / path_sampling)));
}

/**
Up to the first reflection, near $t = 900$, $\sigma_X$ is proportional to the width of the interval, but for spikes. It
rises and falls as the packet moves, and on the average it grows exponentially, at a rate of 0.007 (lines fitted to
$\ln\sigma_X$). After the reflection it grows faster (with $10^{-8}$, where the line is long enough, nearly three times
as fast), until it is as large as the way of the packet. The spikes are not motion, we guess: for a moment the strongest
site, about which the centre is taken, is another one in some packets than in the others. With an interval of a
millionth, seven digits of $v_0$, the position is known to half a site until [1.29e3 ± 4e1](cell:predictable/noise=1e-6/t), with one of $10^{-4}$ until shortly after the reflection. Figure 22 marks the first
of these times; the later part of its map is one possibility among many. The runs with steps of 0.05 and 0.025 differ as
those of two impacts that differ by some $10^{-9}$.

![Spread of the centres against time for three widths of the interval of impacts, and the difference of two steps. Drawn
by x51_spread.gp: `deviation` against `t` from the table `ensemble`, `apart` from `steps`.](fig:x51)

| interval of $v_0$, relative | $10^{-4}$ | $10^{-6}$ | $10^{-8}$ |
|---|---|---|---|
| half a site reached at $t$ | [9.7e2 ± 3e1](cell:predictable/noise=1e-4/t) | [1.29e3 ± 4e1](cell:noise=1e-6/t) | [1.43e3 ± 5e1](cell:noise=1e-8/t) |
| rate of growth, $100 < t < 850$ | [0.0070 ± 0.0004](cell:predictable/noise=1e-4/before) | [0.0069 ± 0.0009](cell:noise=1e-6/before) | [0.0067 ± 0.0004](cell:noise=1e-8/before) |
| from 950 until half a site | | [0.013 ± 0.006](cell:predictable/noise=1e-6/after) | [0.0188 ± 0.0009](cell:noise=1e-8/after) |
| $\sigma_X$, mean for $2000 < t < 2600$ | [8 ± 4](cell:spread/noise=1e-4/part=late/deviation) | [9 ± 1](cell:noise=1e-6/part=late/deviation) | [8 ± 2](cell:noise=1e-8/part=late/deviation) |

Long after the first reflection the motion is erratic, as the article says: $\sigma_X$ is as large as that of centres
equally likely to be anywhere up to site 20 ($20/\sqrt{12} \approx 6$), or larger. */
void report_ensemble(Report& report) {
  struct Interval {
    double noise;
    std::size_t members;
  };
  std::vector<Interval> intervals = {{1e-6, 24}, {1e-4, 12}, {1e-8, 12}};
  if (report.quick) intervals = {{1e-6, 8}};
  const double time = report.quick ? 2200 : 2600;
  Table& table = report.table(
      "ensemble", {number("noise", "relative width of the interval of impacts"),
                   number("t", "time"), number("mean", "mean of the packets' centres", "site"),
                   number("deviation", "standard deviation of the packets' centres", "site"),
                   number("low", "lower decile of the centres", "site"),
                   number("high", "upper decile of the centres", "site")});
  table.meta = {{"seed", std::to_string(seed)},
                {"members", report.quick ? "8" : "24, of 1e-4 and 1e-8 12"}};
  Table &parts = report.table("spread"), &predictable = report.table("predictable");
  for (const auto& [noise, members] : intervals) {
    const std::vector<double> v0 = draws(noise, members);
    const TwoRuns<std::vector<Spread>> both{spreads(v0, 0.2, time), spreads(v0, 0.1, time)};
    for (const Spread& at : both.fine)
      table.add({noise, at.t, at.mean, at.deviation, at.low, at.high});
    // Its mean over two parts of the motion, and when it reaches half a site
    const auto add = [&](const char* part, double from, double to) {
      parts.add({{"noise", "the relative width of the interval of impacts", noise},
                 {"part", "part of the motion", part},
                 {"from", "its first time", from},
                 {"to", "its last time", to},
                 {"deviation", "mean of the standard deviation of the centres",
                  both.of([&](const auto& all) { return mean_deviation(all, from, to); }), "site",
                  "difference of two resolutions, known to 50 per cent"}});
    };
    add("out_and_back", 0, 850);
    add("late", report.quick ? 1900 : 2000, time);
    Estimate t = both.of([](const auto& all) { return time_to_spread(all, unpredictable); });
    const double end = t.value;
    t.error += compared_every;
    const auto rate = [&](double from, double to) {
      return both.of([&](const auto& all) { return growth(all, from, to); });
    };
    predictable.add({{"noise", "the relative width of the interval of impacts", noise},
                     {"t", "time at which the standard deviation exceeds half a site", t, "",
                      "two steps, and the time between two comparisons; known to 5 per cent"},
                     {"before", "rate of growth of the deviation, t = 100 to 850", rate(100, 850),
                      "", "two steps and the fit, known to 13 per cent"},
                     {"after", "from 950 to this time", end > 1100 ? rate(950, end) : undefined, "",
                      "two steps and the fit, known to 50 per cent; nan if there is no time"}});
  }
}

// How far two steps lead one packet apart
void report_steps(Report& report) {
  Table& table = report.table("steps");
  const double step = report.quick ? 0.1 : 0.025;
  const auto runs = two_runs({.time = report.quick ? 2200. : 2600., .sites = 300, .step = step});
  const Path coarse = smoothed(runs.coarse), fine = smoothed(runs.fine);
  for (double t = fine.t[0]; t < fine.t.back(); t += compared_every)
    table.add({{"t", "time", t},
               {"apart", "distance of the centres of one packet with steps of 0.05 and 0.025",
                std::abs(centre_at(coarse, t) - centre_at(fine, t)), "site"}});
}

/**
## The acceleration of the packet

Is the force almost constant? The mass of a packet is unknown, even in sign; so we compare accelerations and not forces.
A parabola, fitted to the smoothed path over 120 units of time, gives the mean acceleration $\ddot X$
(sec34/acceleration.hpp). Its errors are the changes made by twice the step and by half the smoothing.

![Acceleration of the packet against its position on the way out and back, for three impacts. Drawn by
x58_acceleration.gp: `acceleration` against `centre` from the table `acceleration_path`.](fig:x58)

The acceleration depends on more than the position. At $v_0 = 1.9$ the deceleration weakens from the struck end to the
turning point, where for a while the acceleration is even directed outwards. It is weaker on the way back, and so is the
motion itself: at site 14.8 the packet has the velocity
[0.0663 ± 0.0009](cell:acceleration_path/velocity=1.9/t=125/speed) on the way out and
[-0.045](cell:acceleration_path/velocity=1.9/t=725/speed) on the way back. A particle in a field of force, constant or
not, would have the same speed both times. */
constexpr double fitted_over = 120, fitted_every = 10;  // of time

void report_path(Report& report) {
  Table& table = report.table("acceleration_path");
  const double step = report.quick ? 0.1 : 0.05;
  for (const Experiment& of : {Experiment{.v0 = article_moderate, .time = 1000, .step = step},
                               {.v0 = article_turning, .time = 1100, .step = step},
                               {.v0 = 2, .time = 700, .step = step}}) {
    const auto runs = two_runs(of);
    const Path path = smoothed(runs.fine);
    const Turn turn = find_turn(path);
    const double half = fitted_over / 2,
                 end = (turn.rebound.found() ? turn.rebound.time : of.time) - path_smoothing;
    for (double t = path_smoothing + half; t + half < end; t += fitted_every) {
      const WayPart around{"around", WayPart::Kind::times, t - half, t + half};
      const bool back = turn.apex.found() && t > turn.apex.time;
      table.add(
          {{"velocity", "impact velocity; s = 1", of.v0},
           {"t", "time", t},
           {"way", "1 before the turning point, 2 after it", back ? 2 : 1},
           {"centre", "the packet's centre at this time", centre_at(path, t), "site"},
           {"acceleration", "mean acceleration over 120 units of time around it",
            acceleration_of(runs.coarse.path, runs.fine.path, around).mean,
            "site per squared unit of time",
            "against the largest: from the time step and the smoothing"},
           {"speed", "velocity over ten units of time around it",
            mean_speed(runs.coarse.path, runs.fine.path, t - 5, t + 5), "site per unit of time",
            "against the largest, known to 3 per cent: from the time step and the smoothing"}});
    }
  }
}

/**
The article's sentence is quantified by the mean acceleration *at the turn* (`between`), where the packet is above nine
tenths of its turning point: at exactly 1.9, where it hovers, this is [0.14](statement:boomeron.constant_force) of the
acceleration on the way out, $100 < t < 220$. At 1.93, which rounds to 1.9 too, it is two thirds of it. *Back* is from
nine tenths to three tenths of the turning point on the way in. In figure 22 the path looks like a parabola, since it is
off one by only [0.060](cell:arcs/arc=1/deviation) of its range (root mean square). This says little: a wedge, the path
of a particle with no force but at its tip, is off by $(\frac1{12}-\frac5{64})^{1/2} = 0.072$.

| $\ddot X$, sites per squared unit of time | out | at the turn | back |
|---|---|---|---|
| $s=1$, $v_0=1.9$ | [-0.00044](cell:acceleration/s=1/velocity=1.9/part=out/acceleration) | [-6e-5](cell:part=between/acceleration) | [-0.00028](cell:part=back/acceleration) |
| $s=1$, $v_0=1.93$ | [-0.00045](cell:acceleration/s=1/velocity=1.93/part=out/acceleration) | [-0.000297](cell:part=between/acceleration) | [-0.00042](cell:part=back/acceleration) |

Does it grow with $s$ and $v_0$? For $100 < t < 220$ its modulus grows from each of nine impacts from 1.1 to 2 to the
next, and from each of six wells from $s = 0.005$ to 1 to the next (table `acceleration`). Earlier, for $60 < t < 180$,
it falls from [-0.000238 ± 2e-6](cell:acceleration/s=1/velocity=1.1/part=earlier/acceleration) at $v_0 = 1.1$ to
[-0.000233](cell:acceleration/s=1/velocity=1.3/part=earlier/acceleration) at 1.3, and from $s = 0.005$ to 0.05. In
linear wells a packet slows down too, most of all at first: with $v_0 = 1.9$ by
[-0.000175](cell:acceleration/s=0/part=earlier/acceleration) in the earlier time and
[-8.73e-5 ± 7e-7](cell:acceleration/s=0/part=out/acceleration) in the later one. */
const std::vector<WayPart> parts = {  // those after the turn last
    {"out", WayPart::Kind::times, 100, 220},
    {"earlier", WayPart::Kind::times, 60, 180},
    {"later", WayPart::Kind::times, 140, 260},
    {"between", WayPart::Kind::turn},
    {"back", WayPart::Kind::back}};
constexpr std::size_t on_way_out = 3;  // of them
void report_acceleration(Report& report) {
  const double step = report.quick ? 0.1 : 0.05;
  struct Measured {
    Experiment of;
    std::size_t parts = on_way_out;
  };
  std::vector<Measured> list;
  for (double v0 : {1.1, 1.3, 1.5, 1.6, 1.7, 1.8, article_profile, 2.0})
    list.push_back({{.v0 = v0, .time = 300, .step = step}});
  for (double s : {0.0, 0.005, 0.05, 0.25, 0.5, 0.75})
    list.push_back({{.s = s, .time = 300, .step = step}});
  for (double v0 : {article_turning, 1.93})
    list.push_back({{.v0 = v0, .time = 1100, .step = step}, parts.size()});
  // All of them on all cores
  std::vector<std::vector<Cells>> rows(list.size());
  parallel_for(list.size(), [&](std::size_t i) {
    const auto& [of, measured] = list[i];
    const auto runs = two_runs(of);
    for (std::size_t k = 0; k < measured; ++k) {
      const Acceleration seen = acceleration_of(runs.coarse.path, runs.fine.path, parts[k]);
      rows[i].push_back({of.s, of.v0, parts[k].name, seen.mean, seen.mean_change});
    }
  });
  const std::string from = "from the time step and the smoothing; known to ";
  Table& table = report.table(
      "acceleration",
      {number("s", "anharmonicity"), number("velocity", "impact velocity"),
       label("part",
             "part of the way: out (t from 100 to 220), earlier (60 to 180), later "
             "(140 to 260), between (above nine tenths of the turning point), back"),
       estimate("acceleration", "mean acceleration of the packet's centre",
                "site per squared unit of time", from + "2 per cent"),
       estimate("mean_change",
                "velocity at the end of the part minus that at its beginning, over the time",
                "site per squared unit of time", from + "90 per cent")});
  for (const auto& of_one : rows)
    for (const Cells& row : of_one) table.add(row);
}

/**
At $v_0=1.5$ the packet slows down from quarter to quarter of the time of figure 22, from
[0.129](cell:slowing/quarter=1/speed) sites per unit of time in the first to [0.0660](cell:slowing/quarter=4/speed) in
the last. The article calls this slow: for $100<t<220$ the acceleration at 1.1, 1.3 and 1.5 is less than half of that at
1.9. */
void report_slowing(Report& report) {
  const double step = report.quick ? 0.1 : 0.05;
  const auto slow = two_runs({.v0 = article_moderate, .time = 1000, .step = step});
  Table &slowing = report.table("slowing"), &arcs = report.table("arcs");
  for (std::size_t quarter = 1; quarter <= 4; ++quarter) {
    const auto speed = [&](const ImpactRun& run) {
      return speed_in_quarter(smoothed(run), quarter);
    };
    slowing.add(
        {{"quarter", "quarter of the time until 1000", quarter},
         {"speed", "mean speed at v0 = 1.5, s = 1", slow.of(speed), "site per unit of time"}});
  }
  // How far the path of 1.9 is from a parabola
  const auto runs = two_runs({.time = 1900, .step = step / 2});
  for (int arc : {1, 2}) {
    const auto off = [&](const ImpactRun& run) { return deviation_of_arc(smoothed(run), arc); };
    arcs.add(
        {{"arc", "1: until the first reflection, 2: from there to the second one", arc},
         {"deviation",
          "root mean square distance of the path at v0 = 1.9, s = 1, from the best parabola, over "
          "its range",
          runs.of(off), "", "difference of two steps, known to 40 per cent"}});
  }
}

/**
## Profiles close to the turning (figure 23)

The article shows the velocities of all beads at $v_0 = 1.87$ for two times at which, it says, the packet is close to
turning. It is close in place: at $t = 238$ the centre is [2.46](cell:close_to_turning/t=238/distance) sites from its
turning point, less than half the width of the packet. It is not close in time. It still moves with
[0.031](cell:close_to_turning/t=238/speed) sites per unit of time, a fifth of the speed with which it left the end
([0.14](cell:close_to_turning/t=238/first_speed)), and its velocity first vanishes later: of eleven impacts from 1.865
to 1.875, which round to the printed one, none stops before
[296](cell:printed_range/velocity=1.868/smoothed_less), even with half the smoothing. A velocity profile does not
distinguish a packet at rest from one that moves slowly.

![Velocities close to the turning. Drawn by fig23_turning_profiles.gp: `v` against `n` for two `t`, from the table
`turning_profiles`.](fig:23)

Between the packet and the struck end the beads move with up to [0.27](cell:turning_profiles/t=238/n=15/v), a third of
the packet's largest velocity; a few sites ahead of it all are at rest. */
void report_profiles(Report& report) {
  const double step = report.quick ? 0.1 : 0.025;
  const auto whole = two_runs({.v0 = article_profile, .time = 1300, .step = step});
  const Path &coarse = whole.coarse.path, &fine = whole.fine.path;
  const Estimate apex = estimate_turn(coarse, fine).apex_site;
  Table &profiles = report.table("turning_profiles"), &near = report.table("close_to_turning");
  for (double time : {238.0, 241.0}) {
    const auto runs = two_runs({.v0 = article_profile, .time = time, .step = step});
    for (std::size_t n = 0; n < 40; ++n)
      profiles.add({{"t", "time", time},
                    {"n", "site", n + 1, "site"},
                    {"v", "velocity", runs.of([n](const ImpactRun& run) { return run.end.v[n]; }),
                     "", "against the largest: difference of two steps"}});
    // Where the packet is, and how fast
    const auto centre = [time](const ImpactRun& run) { return centre_at(smoothed(run), time); };
    const Estimate here = whole.of(centre);
    const char *both = "from the time step and the smoothing",
               *poorly = "from the time step and the smoothing, known to 20 per cent";
    near.add({{"t", "time", time},
              {"distance", "distance of the centre from its turning point",
               Estimate(apex.value - here.value, apex.error + here.error), "site", both},
              {"speed", "over ten units of time", mean_speed(coarse, fine, time - 5, time + 5),
               "site per unit of time", poorly},
              {"first_speed", "between t = 10 and 30", mean_speed(coarse, fine, 10, 30),
               "site per unit of time", poorly}});
  }
}

// Impacts that round to 1.9, and closer to each other those that round to 1.87
void report_printed_range(Report& report) {
  std::vector<double> velocities;
  for (int i = report.quick ? 0 : -15; i <= (report.quick ? 10 : 85); ++i)
    if ((i + 5) % (i >= 0 && i <= 10 && !report.quick ? 1 : 10) == 0 ||
        (report.quick && i % 5 == 0))
      velocities.push_back(1.865 + 0.01 * double(i) / 10);
  const auto row = [](double v0) -> Row {
    const auto runs = two_runs({.v0 = v0, .time = 1000, .step = 0.1});
    const auto less = [](const ImpactRun& run) {
      return turn_of(run.path, path_smoothing / 2).stop.time;
    };
    const TurnEstimate turn = estimate_turn(runs.coarse.path, runs.fine.path);
    const char* known = "from the time step and the smoothing; known to 40 per cent; nan if later";
    return {{"velocity", "impact velocity", v0},
            {"apex_site", "turning point", turn.apex_site, "site", known},
            {"apex_time", "its time", turn.apex_time, "", known},
            {"stop_time", "time at which the velocity first vanishes", turn.stop_time, "", known},
            {"smoothed_less", "the same with half the smoothing", runs.of(less), "",
             "difference of two steps, known to 5 per cent"}};
  };
  report.table("printed_range").fill(velocities, row, "impacts within the printed digits");
}

/**
## Weakly hard wells, $s = 0.005$

The article sees reversals for $s\ge0.005$ and none for $s=0$, and prints neither an impact nor a time. With the impacts
of the figures $\chi$ is a hundredth at $s=0.005$, and the packet of 1.9 is almost where it is in linear wells. After
132 a packet turns; in linear wells one that strong has never moved inward. All our packets with $\chi$ above 2.5 turn,
within 700 units of time. Below, that of 1.5 at $s=1$ turns at $4.4\cdot10^3$, and those of the table do not as long as
we follow them; so no threshold can be read off, and weaker ones may turn farther out.

| | $\chi$ | followed until | turning point, site | centre at the end, site |
|---|---|---|---|---|
| $s=0.005$, $v_0=132$ | 7.6 | 400 | [26.8](cell:turns/velocity=132/apex_site) | |
| $s=0.1$, $v_0=12$ | 4.2 | 530 | [19.5](cell:turns/velocity=12/apex_site) | |
| $s=1$, $v_0=1.9$ | 2.6 | 1200 | [20.1](cell:turns/velocity=1.9/apex_site) | |
| $s=0.005$, $v_0=60$ | 2.3 | 800 | none | [404.7](cell:weakly_hard/s=0.005/velocity=60/centre) |
| $s=1$, $v_0=1.5$ | 1.8 | 5500 | [183](cell:turns/velocity=1.5/apex_site) | |
| $s=0.005$, $v_0=1.9$ | 0.013 | 2500 | none | [565](cell:weakly_hard/s=0.005/velocity=1.9/centre) |
| $s=0$, $v_0=1.9$ | 0 | 2500 | none | [566](cell:weakly_hard/s=0/velocity=1.9/centre) |
| $s=0$, $v_0=132$ | 0 | 450 | none | [434](cell:weakly_hard/s=0/velocity=132/centre) | */
void report_weakly_hard(Report& report) {
  std::vector<Experiment> list = {{.v0 = 1.5, .s = 0, .time = 1000, .sites = 620, .step = 0.1},
                                  {.v0 = 1.9, .s = 0, .time = 2500, .sites = 620, .step = 0.1},
                                  {.v0 = 132, .s = 0, .time = 450, .sites = 620, .step = 0.025},
                                  {.v0 = 1.5, .s = 0.005, .time = 1000, .sites = 620, .step = 0.1},
                                  {.v0 = 1.9, .s = 0.005, .time = 2500, .sites = 620, .step = 0.1},
                                  {.v0 = 5, .s = 0.005, .time = 1500, .sites = 620, .step = 0.1},
                                  {.v0 = 27, .s = 0.005, .time = 900, .sites = 620, .step = 0.05},
                                  {.v0 = 60, .s = 0.005, .time = 800, .sites = 620, .step = 0.05}};
  if (report.quick) list.resize(1);
  const auto row = [&](Experiment of) -> Row {
    if (report.quick) of.step *= 2;
    const auto runs = two_runs(of);
    const TwoRuns<Path> paths{smoothed(runs.coarse), smoothed(runs.fine)};
    return {{"s", "anharmonicity", of.s},
            {"velocity", "impact velocity", of.v0},
            {"until", "end of the run", of.time},
            {"centre", "centre of the packet, at the end of the smoothed path",
             paths.of([](const Path& p) { return p.centre.back(); }), "site"},
            {"speed", "its speed in the last ten units of time",
             paths.of([](const Path& p) { return last_speed(p, 10); }), "site per unit of time"},
            {"fallen_back", "the farthest that it has ever fallen back", paths.of(farthest_return),
             "site"}};
  };
  report.table("weakly_hard").fill(list, row, "weakly hard wells");
}

/**
## A check

Another scheme, with fourteen stages, has to give the time of the reflection within 0.2. The article does not say how it
integrates or averages, or how long its chain is. */
void check_by_another_scheme(bool quick) {
  const EventCorrected usual{quick ? 0.1 : 0.025}, other{usual.step, nystrom(blanes_moan_6_14())};
  const auto reflected = [](const EventCorrected& method) {
    return turn_of(follow({}, method).path).rebound.time;
  };
  if (!(std::abs(reflected(other) - reflected(usual)) < 0.2))
    throw Failure("another integrator returns at another time");
}

void reproduce(Report& report) {
  report_maps(report);
  report_turns(report);
  report_ensemble(report);
  report_steps(report);
  report_path(report);
  report_acceleration(report);
  report_slowing(report);
  report_profiles(report);
  report_printed_range(report);
  report_weakly_hard(report);
  check_by_another_scheme(report.quick);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `boomeron.reversal`: s = 1 and v_0 = 1.9: deceleration; reversal; return; rebound | reverses | turns.out_again (s = 1, velocity = 1.9), turns.return_site (s = 1, velocity = 1.9): 4.404 < 7.48 (the closest of 6) | holds |
| `boomeron.moderate`: s = 1 and v_0 = 1.5 decelerates slowly | slow | slowing.speed (quarter = 3), (quarter = 4): 0.06603 < 0.07845 (the closest of 11) | holds, assuming |
| `boomeron.turning_time`: close to direction reversal at v_0 = 1.87 | close at 238 and 241 | close_to_turning.distance (t = 238): 2.459 < 3.5; close_to_turning.distance (t = 241): 2.362 < 3.5 | holds, assuming |
| `boomeron.waves`: nonlinear waves are confined between the packet and the boundary | visible | turning_profiles.v (t = 238, n = 1) and 39 other values: 0.04543 < 0.2728 (the closest of 4) | holds |
| `boomeron.any_s`: reversal takes place for s >= 0.005 and not for s = 0 | s >= 0.005 | turns.apex_site (s = 0.5), turns.return_site (s = 0.5): 6.692 < 12.88 (the closest of 8) | holds, assuming |
| `boomeron.erratic`: after some rebounds the motion is trapped or erratic | erratic | spread.deviation (noise = 1e-06, part = out_and_back): 0.000216 < 0.25; spread.deviation (noise = 1e-06, part = late): 3 < 8.964 | holds |
| `boomeron.constant_force`: during a few rebounds the centre moves like a particle in an almost constant force field | almost constant | 0.139 | quantified |
| `boomeron.force_grows`: the effective force increases with s and with the impact velocity | increases | acceleration.acceleration (s = 1, velocity = 1.1, part = out), (s = 1, velocity = 1.3, part = out): 0.0001454 < 0.0001493 (the closest of 14) | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** Another impact that turns is a row of `turning`; if it does not turn within its `time`, its cells are
`nan`. Its chain has to be so long that the packet and the waves do not cross it: the program says so. Another one whose
acceleration is measured is in the lists of `report_acceleration` or `report_path`. The article's impacts are the
constants `article_*`. What counts as a turn are the defaults of `find_turn`, the smoothing is `path_smoothing`
(turning.hpp), of which volume two makes use as well. The figures read columns by name.

1. *Easy.* When does the packet of figure 23 turn? `build/bin/sec34_boomeron run --velocity 1.87` gives
   `apex_site` = 23.175 and `apex_time` = 493. Hint: try 1.86 and 1.88, and compare both numbers.
2. *Harder.* When do the *states* of two impacts that differ by $10^{-8}$ part, all beads and phases included?
   `build/bin/sec34_boomeron run --velocity 2.2` gives `decorrelation_time` = 580. Hint: this packet stays near the
   struck end and meets its own waves again and again. Try 1.9, and compare with the spread of the centres.

`run` takes wells, contacts and a length of your choice, and a tolerance instead of a step (commands/one_turn.hpp). */
int main(int argc, char** argv) {
  return run({"sec34_boomeron", "3.4", "Packets that turn round in hard wells (section 3.4)",
              reproduce, commands<OneTurn>()},
             argc, argv);
}
