/**
# 3.4 Packets that turn round in hard wells

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) also strikes a chain whose wells are hard, $s > 0$.
The packet, a travelling breather, slows down, turns round, comes back to the struck end and bounces off it; the
article compares it with *boomerons*, solitons that reverse their direction. How far does it get, how does it slow down,
and for how long can its motion be known?

The article shows three impacts, all in wells with $s=1$. At $v_0=1.9$ the packet turns, returns and rebounds, and after some
rebounds its motion is erratic; at $v_0=1.5$ it only slows down; at $v_0=1.87$ it is close to turning at $t=238$. During
the first rebounds, it says, the centre moves like a particle in an almost constant force, which grows with $s$ and
$v_0$. Which packets turn, and why, is asked in two later chapters (`sec34_boomeron_map`, `sec34_boomeron_why`).

![Energy density after impacts with 1.5 and 1.9, and a zoom.](fig:22) */

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "commands/one_turn.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/turning.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/decorrelation.hpp"

using namespace lattice;

/**
## Model

The chain is that of the chapter before, Eqs. (9), (10) and (26),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1},$$
now with $s \ge 0$, a free end at $n=1$, and so long that the packet does not see the other end. It is integrated with
event-corrected Runge–Kutta–Nyström steps (event_corrected.hpp), with several step lengths each time. Energy density and
centre of the packet are those of Eqs. (23) and (24) with $m=5$ and the Hertz energy $V$ of a contact; $n'$ is the site
with the largest $e_n$ of all, because a packet on its way back need not be the front-most one:
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + V(y_{n+1}-y_n),\qquad
  X = \sum_{|n-n'|\le m} n\,e_n \Big/ \sum_{|n-n'|\le m} e_n .$$

All is dimensionless. The packet's own oscillation, its *internal period*, takes about four units of time.

| article | program | meaning |
|---|---|---|
| $\dot y_1(0) = v_0$, $s$ | `velocity`, `s` | impact velocity, anharmonicity of the well |
| $X$, $e_n$ | `Path::centre`, `energy_density` | energy centre and density | */
struct NamedImpact {
  const char* name;  ///< in the facts
  Impact impact;     ///< of this velocity, s, length of the run, sites
};
const NamedImpact impacts[] = {{"150", turning_impact(1.5, 1, 5500, 260)},
                               {"187", turning_impact(1.87, 1, 1300)},
                               {"190", turning_impact(1.9, 1, 1200)}};

/**
## The motion (figure 22)

A packet pulsates while it travels, and a map that samples the pulsation at nearly its own rate shows
stripes that do not exist. So figure 22 shows the energy density averaged over about one internal period,
and over one unit of time in the zoom. The dashed line marks the time after which the motion is no longer
determined by what we know of the impact; what the map shows beyond it is one possibility among many. */
struct MapPanel {
  std::int64_t panel;
  double velocity, to, interval;
  std::size_t sites;
};
const MapPanel panels[] = {{1, 1.5, 1000, 4, 110}, {2, 1.9, 2500, 5, 40}, {3, 1.9, 900, 1, 28}};

// A colour can be read to a few per cent at best, so the maps come from runs with a longer step
void report_maps(Report& report, double determined_until) {
  Table& table =
      report.table("density_maps",
                   {count("panel", "1: v0 = 1.5, 2: v0 = 1.9, 3: the beginning of 2"),
                    number("t", "time"), count("n", "site", "site"),
                    number("e", "energy density, averaged over the interval between two times")});
  table.meta = {{"decorrelation_time", number_text(determined_until)}};
  for (const MapPanel& f : panels) {
    std::vector<double> sum(f.sites, 0.0);
    double weight = 0, next = f.interval;
    const auto average = [&](const State<double>& now, const std::vector<double>& e) {
      for (std::size_t n = 0; n < f.sites; ++n) sum[n] += e[n];
      if (++weight, now.t < next - 1e-9) return;
      for (std::size_t n = 0; n < f.sites; ++n)
        table.add({f.panel, next - f.interval / 2, n + 1, sum[n] / weight});
      std::fill(sum.begin(), sum.end(), 0.0);
      weight = 0, next += f.interval;
    };
    strike(EventCorrected{report.quick ? 0.2 : 0.05}, turning_impact(f.velocity, 1, f.to, 400),
           average);
  }
}

/**
## Where and when it turns

What the eye sees in figure 22 has to become numbers. The centre trembles with the internal oscillation, so we smooth
$X(t)$ over four internal periods (turning.hpp). Of the smoothed path we take the first instant at which the *velocity
vanishes*; the *turning point*, which is the furthest point of the way out; and the *rebound*, the nearest point of the way
back. A packet can come to rest, drift slowly on and turn later, so the first two may differ. The errors are those of the
step and of the smoothing.

At $v_0=1.9$ the velocity vanishes at $t =$ [289](num:sec34_boomeron.stop_time_190), the turning point is at site
[20.065](num:sec34_boomeron.apex_site_190) and time [467](num:sec34_boomeron.apex_time_190), and the rebound at
[897.7](num:sec34_boomeron.return_time_190). The packet of $v_0 = 1.5$, the article's example of a slow deceleration,
turns in the end too, far outside the figure: at site [183.239](num:sec34_boomeron.apex_site_150) and time
[4.36e3](num:sec34_boomeron.apex_time_150).

Near a turning point a packet is almost at rest, and small errors decide which way it goes. So a table holds each of these
moments at three steps, which shows whether they are short enough. */
std::vector<TurnEstimate> report_turns(Report& report) {
  const std::vector<double> steps =
      report.quick ? std::vector<double>{0.2, 0.1} : std::vector<double>{0.1, 0.05, 0.025};
  const std::size_t count = steps.size();
  std::vector<ImpactRun> runs(std::size(impacts) * count);  // by impact and step
  parallel_for(runs.size(), [&](std::size_t i) {
    runs[i] = strike(EventCorrected{steps[i % count]}, impacts[i / count].impact);
  });

  // Each moment at every step
  Table& table = report.table(
      "step_dependence",
      {number("velocity", "impact velocity"), number("step", "time step"),
       number("stop_time", "time when the velocity vanishes first"),
       number("apex_site", "turning point, the furthest of the way out", "site"),
       number("apex_time", "time of the turning point"), number("return_time", "time of rebound")});
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Turn turn = turn_of(runs[i].path);
    table.add({impacts[i / count].impact.velocity, steps[i % count], turn.stop.time, turn.apex.site,
               turn.apex.time, turn.rebound.time});
  }

  // The facts come from the two finer steps; at v0 = 1.5 the way out takes most of the run
  std::vector<TurnEstimate> reads;
  for (std::size_t k = 0; k < std::size(impacts); ++k) {
    const ImpactRun* last = &runs[(k + 1) * count - 1];
    reads.push_back(estimate_turn(last[-1].path, last[0].path));
    const std::string name = impacts[k].name;
    report.facts.add("stop_time_" + name, reads[k].stop_time);
    report.facts.add("stop_site_" + name, reads[k].stop_site, "site");
    report.facts.add("apex_site_" + name, reads[k].apex_site, "site");
    report.facts.add("apex_time_" + name, reads[k].apex_time);
    if (k > 0) report.facts.add("return_time_" + name, reads[k].return_time);
    if (k == 2) report.facts.add("reversal_return_time_error", exact(reads[k].return_time.error));
  }
  return reads;
}

/**
## The acceleration

The article likens the packet to a particle in an almost constant force. What can be seen of a force is the acceleration of
the packet's centre, $\ddot X$, and that is what we measure, in sites per squared unit of time: the slope of a line through
the velocities of the smoothed path (sec34/acceleration.hpp), on the way out, for $100 < t < 220$, on the way back, between
sites 18 and 6, and between the two, around the turning point. For a force one would have to know the packet's mass, and
there is reason to expect a negative one, as slow breathers of section 3.3 have (`sec33_mobility`): what is pushed forward
then slows down. The waves behind this packet, which can only push it forward, do slow it down (`sec34_boomeron_why`).

At $s=1$, $v_0 = 1.9$ the acceleration is [-0.00046](num:sec34_boomeron.force_190) on the way out,
[-7.8e-5](num:sec34_boomeron.force_190_between) around the turning point and [-0.00029](num:sec34_boomeron.force_190_back) on the way back,
and it changes by a fraction of [0.3](num:sec34_boomeron.force_190_bend) from the first half of the way out to the second.
The article does not say how constant *almost constant* is. The ratio of back and out is [0.63](num:boomeron.constant_force):
within a factor of two the force is constant on the two ways, but not around the turning point. At $v_0 = 1.5$ it is
[-0.000171](num:sec34_boomeron.force_150) and in the linear well [-9e-5](num:sec34_boomeron.force_linear_well): there too a
packet slows down, though none was seen to turn. */
struct ImpactAcceleration {
  double velocity, s;
  Leg leg = Leg::out;
  Acceleration seen{};
};

/**
According to the article the force grows with $s$ and with $v_0$. So the list varies $v_0$ at $s=1$, then $s$ at
$v_0=1.9$, with $s = 0$ for comparison; its last rows are the way back and the turning. Both lists rise in modulus: no
value is smaller than an earlier one beyond the errors of both, and the last exceeds the first by a factor of
[3.7](num:sec34_boomeron.force_grows_velocity_last_over_first) and of
[5](num:sec34_boomeron.force_grows_s_last_over_first). Below $v_0 = 1.5$ the errors are larger than the differences between
neighbours. */
std::vector<ImpactAcceleration> report_accelerations(Report& report, double step) {
  std::vector<ImpactAcceleration> list;
  for (double v : {1.1, 1.3, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0}) list.push_back({v, 1});
  for (double s : {0.0, 0.25, 0.5, 0.75}) list.push_back({1.9, s});
  for (Leg leg : {Leg::back, Leg::between}) list.push_back({1.9, 1, leg});
  const auto path = [&](double velocity, double s, double time, double h) {
    return strike(EventCorrected{h}, turning_impact(velocity, s, time)).path;
  };
  std::array<Path, 2> returning;
  parallel_for(2, [&](std::size_t k) { returning[k] = path(1.9, 1, 1000, k ? step : 2 * step); });
  const auto row = [&](ImpactAcceleration& p) {
    p.seen = p.leg == Leg::out ? acceleration_of(path(p.velocity, p.s, 300, 2 * step),
                                                 path(p.velocity, p.s, 300, step), p.leg)
                               : acceleration_of(returning[0], returning[1], p.leg);
    return Cells{p.s, p.velocity, p.leg, p.seen.mean.value, p.seen.mean.error, p.seen.bend.value};
  };
  report
      .table(
          "force",
          {number("s", "anharmonicity"), number("velocity", "impact velocity"),
           count("outward", "1 on the way out, 0 on the way back, 2 between the two"),
           number("force", "acceleration of the centre", "site per squared unit of time"),
           number("force_uncertainty", "fit, step and smoothing", "site per squared unit of time"),
           number("bend", "relative difference of the slopes of both halves")})
      .fill(list, row, "forces");
  return list;
}

/**
The packet of $v_0=1.5$ slows down *slowly*: within the time of figure 22 it does not turn, and its speed in the last
quarter of that time is [0.510831](num:sec34_boomeron.speed_ratio_150) of that in the first. */
Estimate slowing(double step) {
  const auto speed = [](const Path& p, std::size_t quarter) {
    const std::size_t n = p.t.size() / 4, i = quarter * n, j = std::min(i + n, p.t.size() - 1);
    return (p.centre[j] - p.centre[i]) / (p.t[j] - p.t[i]);
  };
  const auto ratio = [&](double h) {
    const Path p =
        smooth(strike(EventCorrected{h}, turning_impact(1.5, 1, 1000)).path, path_smoothing);
    return speed(p, 3) / speed(p, 0);
  };
  return compare(ratio(2 * step), ratio(step));
}

void report_force(Report& report) {
  const double step = report.quick ? 0.1 : 0.05;
  const std::vector<ImpactAcceleration> list = report_accelerations(report, step);
  const Estimate slow = list[2].seen.mean, fast = list[6].seen.mean, back = list[12].seen.mean;
  const std::string unit = "site per squared unit of time";
  report.facts.add("force_150", slow, unit);
  report.facts.add("force_190", fast, unit);
  report.facts.add("force_190_back", back, unit);
  report.facts.add("force_190_between", list[13].seen.mean, unit);
  report.facts.add("force_190_bend", list[6].seen.bend);
  report.facts.add("force_190_back_over_out", quotient(back, fast));
  report.facts.add("force_linear_well", list[8].seen.mean, unit);

  // Harder impacts and harder wells
  std::vector<Estimate> velocities, wells;
  for (std::size_t i = 0; i <= 7; ++i) velocities.push_back(list[i].seen.mean);
  for (std::size_t i : {8U, 9U, 10U, 11U, 6U}) wells.push_back(list[i].seen.mean);
  for (const auto& [name, forces] : {std::pair{"velocity", velocities}, std::pair{"s", wells}}) {
    const std::string grows = std::string("force_grows_") + name;
    report.facts.add(grows + "_largest_fall", exact(largest_fall(forces)));
    report.facts.add(grows + "_last_over_first", quotient(forces.back(), forces.front()));
  }
  report.facts.add("moderate_force_over_190", quotient(slow, fast));
  report.facts.add("speed_ratio_150", slowing(step), "last quarter to first");
}

/**
## Profiles close to the turning (figure 23)

The article shows the velocities at $v_0 = 1.87$ when, as it says, the packet is close to turning, and we show the same times
for comparison. How close is close? At $t = 238$ the centre is [2.459](num:boomeron.turning_time) sites from its turning
point, site [23.175](num:sec34_boomeron.apex_site_187), and still moves, at [0.0308568](num:sec34_boomeron.speed_187_at_238)
sites per unit of time, a fraction [0.354492](num:sec34_boomeron.speed_ratio_187) of its mean speed on the way out. Its
velocity vanishes first at [5e2](num:sec34_boomeron.stop_time_187), a time that is badly known because the path is almost flat there: another smoothing
moves its zero a long way. So the packet is close to turning in place, but not in time.

![Velocities close to the turning.](fig:23) */
void report_profiles(Report& report, const TurnEstimate& turn) {
  Table& table =
      report.table("turning_profiles",
                   {number("t", "time"), count("n", "site", "site"),
                    estimate("v", "velocity", "", "against the largest: difference of two steps")});
  const double step = report.quick ? 0.1 : 0.025;
  for (double time : {238.0, 241.0}) {
    const State<double> coarse =
                            strike(EventCorrected{2 * step}, turning_impact(1.87, 1, time)).end,
                        fine = strike(EventCorrected{step}, turning_impact(1.87, 1, time)).end;
    for (std::size_t n = 0; n < 40; ++n) table.add({time, n + 1, compare(coarse.v[n], fine.v[n])});
  }

  // Where the centre is at the first of these times, and how fast
  double centre[2]{}, speed[2]{}, mean[2]{};
  for (int k : {0, 1}) {
    const Path p =
        smooth(strike(EventCorrected{k ? step : 2 * step}, turning_impact(1.87, 1, 260)).path,
               path_smoothing);
    const auto at = [&](double t) {
      return p.centre.at(std::size_t(std::lround((t - p.t[0]) / path_sampling)));
    };
    centre[k] = at(238), speed[k] = (at(243) - at(233)) / 10;
    mean[k] = speed[k] * 238 / centre[k];
  }
  const Estimate here = compare(centre[0], centre[1]);
  report.facts.add("speed_187_at_238", compare(speed[0], speed[1]), "site per unit of time");
  report.facts.add("speed_ratio_187", compare(mean[0], mean[1]), "to the mean speed so far");
  report.facts.add("apex_distance_187_at_238",
                   {turn.apex_site.value - here.value, turn.apex_site.error + here.error}, "site");
}

/**
Could the digits of $v_0$ that are not printed explain the later time? They leave a range from 1.865 to 1.875, over which the
velocity vanishes first between $t =$ [319.813](num:sec34_boomeron.stop_time_187_earliest) and
[492.97](num:sec34_boomeron.stop_time_187_latest), well after the article's 240. A velocity profile, which is all that
figure 23 shows, does not tell a packet at rest from one that moves slowly. */
void report_printed_range(Report& report) {
  const std::size_t count = report.quick ? 3 : 11;
  std::vector<double> stop[2] = {std::vector<double>(count), std::vector<double>(count)};
  parallel_for(2 * count, [&](std::size_t i) {
    const double v = 1.865 + 0.01 * double(i / 2) / double(count - 1);
    stop[i % 2][i / 2] =
        turn_of(strike(EventCorrected{i % 2 ? 0.1 : 0.2}, turning_impact(v, 1, 700)).path)
            .stop.time;
  });
  const auto a = std::minmax_element(stop[0].begin(), stop[0].end());
  const auto b = std::minmax_element(stop[1].begin(), stop[1].end());
  const std::string range = "over the printed digits of v0";
  report.facts.add("stop_time_187_earliest", compare(*a.first, *b.first), range);
  report.facts.add("stop_time_187_latest", compare(*a.second, *b.second), range);
}

/**
## In the softest of hard wells

The article sees reversals for $s \ge 0.005$ and none for $s = 0$, and prints neither an impact nor a time. In so soft a
well packets turn soon after very strong impacts only: with $s = 0.005$ and $v_0 = 132$ the turning point is at site
[26.804](num:sec34_boomeron.turning_site_softest), and the packet is back at $t =$ [310.03](num:sec34_boomeron.return_time_softest), at
site [2.566](num:sec34_boomeron.return_site_softest). After the same impact on linear wells the packet is at site
[441.554](num:sec34_boomeron.centre_without_hardness) at $t = 450$, has moved outward all the time, and still does at
[0.954685](num:sec34_boomeron.speed_without_hardness) sites per unit of time. After the weaker impacts of figure 22 a packet in such a well may turn much farther out. */
void report_softest(Report& report) {
  const double step = report.quick ? 0.02 : 0.01;
  Path hard[2], linear[2];
  parallel_for(4, [&](std::size_t k) {
    const Impact impact =
        k < 2 ? turning_impact(132, 0.005, 400, 800) : turning_impact(132, 0, 460, 800);
    (k < 2 ? hard : linear)[k % 2] = strike(EventCorrected{k % 2 ? step : 2 * step}, impact).path;
  });
  const TurnEstimate turn = estimate_turn(hard[0], hard[1]);
  report.facts.add("turning_site_softest", turn.apex_site, "site");
  report.facts.add("return_time_softest", turn.return_time);
  report.facts.add("return_site_softest",
                   compare(turn_of(hard[0]).rebound.site, turn_of(hard[1]).rebound.site), "site");

  // Where the centre is at t = 450, how fast, and the farthest that it has ever fallen back
  double centre[2], speed[2], back[2]{};
  for (int k : {0, 1}) {
    const Path p = smooth(linear[k], path_smoothing);
    const auto at = [&](double t) {
      return p.centre.at(std::size_t(std::lround((t - p.t[0]) / path_sampling)));
    };
    centre[k] = at(450), speed[k] = (at(450) - at(440)) / 10;
    double most = p.centre[0];
    for (double x : p.centre) most = std::max(most, x), back[k] = std::max(back[k], most - x);
  }
  report.facts.add("centre_without_hardness", compare(centre[0], centre[1]), "site");
  report.facts.add("speed_without_hardness", compare(speed[0], speed[1]), "site per unit of time");
  report.facts.add("turns_back_without_hardness", compare(back[0], back[1]), "sites");
}

/**
## How long the motion is determined

The motion is chaotic, so two runs that differ by as little as a rounding error part sooner or later. We say that they have
parted when their states differ by a tenth of the largest displacement or velocity (sec34/decorrelation.hpp). One impact
computed with two steps tells for how long *we* can compute the motion; two impacts that differ by a fraction $\delta$ tell
for how long anybody can who knows the impact to so many digits only. The article prints its impact velocities with two or
three digits; half a unit of the last digit of 1.87 means $\delta\approx 3\cdot10^{-3}$.

At $v_0 = 1.9$ our runs agree until $t =$ [1.38e3](num:sec34_boomeron.resolved_until), and up to this time we know the motion
after this impact. Two impacts that differ by $\delta = 10^{-6}$ part at [1.05e3](num:sec34_boomeron.decorrelation_time_190),
and figure 22 marks this time, since nobody would print an impact velocity with more digits. */
struct TwoImpacts {
  double delta, coarse, fine;
  double when = 0, check = 0;
};

std::vector<TwoImpacts> part_pairs(bool quick) {
  std::vector<TwoImpacts> pairs{{0, 0.1, 0.05}, {0, 0.05, 0.025}};
  for (double delta : {3e-3, 1e-4, 1e-6, 1e-8}) pairs.push_back({delta, 0.1, 0.1});
  if (quick) pairs = {{0, 0.2, 0.1}, {1e-6, 0.1, 0.1}};
  const double v = 1.9, time = 1700;
  parallel_for(pairs.size(), [&](std::size_t i) {
    TwoImpacts& p = pairs[i];
    const auto at = [&](double shrink) {
      return decorrelation_of_impacts({p.coarse * shrink}, v, {p.fine * shrink}, v * (1 + p.delta),
                                      Chain{150, Quartic{1}}, time);
    };
    p.when = at(1);
    if (p.delta > 0) p.check = at(2);
  });
  return pairs;
}

double report_decorrelation(Report& report) {
  Table& table = report.table(
      "decorrelation",
      {number("delta", "relative difference of the impacts, 0 for one impact and two steps"),
       number("coarse", "first step"), number("fine", "second step"),
       number("t", "time when the two have parted")});
  double marked = 0;
  Estimate resolved;
  for (const TwoImpacts& p : part_pairs(report.quick)) {
    table.add({p.delta, p.coarse, p.fine, p.when});
    if (p.delta == 0) resolved = {p.when, std::abs(p.when - resolved.value)};
    if (p.delta != 1e-6) continue;
    marked = p.when;
    report.facts.add("decorrelation_time_190", decorrelation_of(p.check, p.when));
  }
  report.facts.add("resolved_until", resolved);
  return marked;
}

/**
## What erratic means

Beyond that time only statements about ensembles make sense. So we draw 24 impacts at random from an interval of relative
width $10^{-6}$, with a recorded seed, and see how far their packets spread. A centre that is equally likely to be anywhere
up to the turning point would have a spread of six sites. Ours is
[0.00022](num:sec34_boomeron.erratic_spread_until_return) on the way out and back and
[9](num:sec34_boomeron.erratic_spread_late) long after, as some packets then get beyond the first turning point (`high` in
the table). */
constexpr unsigned long seed = 20130501;

std::vector<double> random_impacts(std::size_t members) {
  Random random(seed);
  std::vector<double> velocity(members);
  for (double& v : velocity) v = 1.9 * (1 + random.uniform(-5e-7, 5e-7));
  return velocity;
}

struct Spread {
  double t, mean, deviation, low, high;  // of the centres; the tenths
};

Spread spread_at(const std::vector<Path>& paths, std::size_t k) {
  const std::size_t members = paths.size();
  std::vector<double> x;
  double mean = 0, square = 0;
  for (const Path& p : paths) x.push_back(p.centre.at(k)), mean += x.back() / double(members);
  for (double c : x) square += (c - mean) * (c - mean) / double(members - 1);
  std::sort(x.begin(), x.end());
  return {paths[0].t[k], mean, std::sqrt(square), x[members / 10], x[members - 1 - members / 10]};
}

// The smoothed centres: otherwise packets that differ only in the phase of their pulsation would seem to have spread
std::vector<Spread> ensemble(std::size_t members, double step, double time) {
  const std::vector<double> velocity = random_impacts(members);
  std::vector<Path> paths(members);
  parallel_for(members, [&](std::size_t i) {
    paths[i] = smooth(strike(EventCorrected{step}, turning_impact(velocity[i], 1, time, 300)).path,
                      path_smoothing);
  });
  std::vector<Spread> out;
  for (std::size_t k = 0; k < paths[0].t.size(); k += 50) out.push_back(spread_at(paths, k));
  return out;
}

double mean_deviation(const std::vector<Spread>& spreads, double from, double to) {
  double sum = 0, n = 0;
  for (const Spread& s : spreads)
    if (s.t >= from && s.t <= to) sum += s.deviation, ++n;
  return sum / n;
}

void report_ensemble(Report& report) {
  const std::size_t members = report.quick ? 8 : 24;
  const double time = report.quick ? 2200 : 2600, step = 0.2;
  const auto coarse = ensemble(members, step, time), fine = ensemble(members, step / 2, time);
  Table& table = report.table(
      "ensemble", {number("t", "time"), number("mean", "mean of the centres", "site"),
                   number("deviation", "standard deviation of the centres", "site"),
                   number("low", "lower tenth", "site"), number("high", "upper tenth", "site")});
  table.meta = {{"seed", std::to_string(seed)}, {"members", std::to_string(members)}};
  for (const Spread& s : fine) table.add({s.t, s.mean, s.deviation, s.low, s.high});
  const auto over = [&](double from, double to) {
    return compare(mean_deviation(coarse, from, to), mean_deviation(fine, from, to));
  };
  report.facts.add("erratic_spread_until_return", over(0, 850));
  report.facts.add("erratic_spread_late", over(report.quick ? 1900 : 2000, time));
}

/**
## Checks

A turning point that depended on our own integrator would be no fact about the chain. For the way out the
independent route is GSL's adaptive method of order eight, which knows nothing of contacts; it must
agree within $10^{-7}$, far below the errors of this chapter's numbers. For the whole way, where GSL
would be slow, we use another scheme of our own, with fourteen stages. */
void report_check(Report& report) {
  const Impact impact = turning_impact(1.9, 1, 100, 60);
  const double apart =
      distance_from_reference(impact.chain, struck(60, impact.velocity), impact.time,
                              strike(EventCorrected{0.0125}, impact).end, 1e-7);
  report.facts.add("independent_route_difference", compare(0.0, apart));
  const double step = report.quick ? 0.1 : 0.025;
  const ImpactRun one = strike(EventCorrected{step}, impacts[2].impact),
                  other =
                      strike(EventCorrected{step, nystrom(blanes_moan_6_14())}, impacts[2].impact);
  report.facts.add("other_scheme_return_time",
                   compare(turn_of(one.path).rebound.time, turn_of(other.path).rebound.time));
  report.facts.add("energy_drift_190", compare(one.run.energy_drift, other.run.energy_drift),
                   "relative, largest");
}

/**
## Differences and limits

The article does not say how it integrates or averages, nor how long its chain is. Reversal at 1.9 and growth of the
force are found; at $v_0\approx1.87$ the velocity vanishes later than the times that it calls close to the reversal. */
void reproduce(Report& report) {
  const std::vector<TurnEstimate> reads = report_turns(report);
  const double marked = report_decorrelation(report);
  report_maps(report, marked);  // the maps show one of the decorrelation times
  report_force(report);
  report_profiles(report, reads[1]);
  report_printed_range(report);
  report_softest(report);
  report_ensemble(report);
  report_check(report);
}

/**
## Try it

1. *Easy.* A packet that the article calls close to turning at $t = 238$ turns later:
   `build/bin/sec34_boomeron run --velocity 1.87` gives `apex_site` = 23.175 and `apex_time` = 493. Hint: the velocity
   of a packet that is about to turn is small for a long time.
2. *Easy.* Make the wells harder: `build/bin/sec34_boomeron run --s 1.2 --time 600` gives `apex_site` = 8.8. Hint: at
   $s = 1$ it is site 20; figure x11 shows what matters, $s\,v_0^{3/2}$.
3. *Harder.* For how long can a harder impact be known? `build/bin/sec34_boomeron run --velocity 2.2` gives
   `decorrelation_time` = 580, less than half the time of $v_0 = 1.9$. Hint: this packet stays near the struck end, where it
   meets its own waves again and again.
4. *Harder.* Compress the contacts by $d = 0.01$: `build/bin/sec34_boomeron run --precompression 0.01` gives
   `apex_site` = 28.144. Hint: beads that stay in contact carry small waves away from the packet.
5. *Open.* What decides how many rebounds there are before the motion becomes erratic? Does the return begin where the
   frequency of the packet meets that of a pinned breather? What remains of it with the damping of an experiment?

## With your own parameters

`build/bin/sec34_boomeron run --help` lists wells, contacts and the length of the run (commands/one_turn.hpp). */
int main(int argc, char** argv) {
  return run({"sec34_boomeron", "3.4", "Packets that turn round in hard wells (section 3.4)",
              reproduce, commands<OneTurn>()},
             argc, argv);
}
