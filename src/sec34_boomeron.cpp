/**
# 3.4 Packets that reverse their direction in hard wells

After an impact in hard wells, $s > 0$, the travelling breather slows down, turns round and comes back to the struck
end, which reflects it. How far does it get, how does it slow down, and for how long is its motion predictable? We
follow its energy centre with two steps, and compare impacts that differ in late digits. Section 3.4 of James,
Kevrekidis and Cuevas (Physica D 251, 2013) compares the packet with *boomerons*, solitons that reverse their direction,
and says that

- with $s=1$ and $v_0=1.9$ the packet turns and returns, and after some reflections its motion is erratic, while with
  $v_0 = 1.5$ it only slows down (figure 22);
- with $v_0=1.87$ it is close to turning at $t = 238$ and 241 (figure 23);
- during a few reflections its centre moves like a particle in an almost constant force, which grows with $s$ and $v_0$;
- it turns for $s\ge0.005$ and not for $s = 0$.

![Energy density after impacts with 1.5 and 1.9, a zoom, and the spread of an ensemble. Drawn by
fig22_turning_maps.py: `e` over `t` and `n` from the table `density_maps`, `mean`, `low` and `high` from `ensemble`, the
dashed line from `decorrelation`.](fig:22)

We find this, with four qualifications. The acceleration is largest near the end that was hit and, at $v_0=1.9$, several
times smaller around the turning point. At $v_0=1.87$ the packet comes to rest later than figure 23 suggests. At
$s=0.005$ we see packets turn only after impacts far above those of the figures. And *grows* depends on the stretch of
the way: on an early one the acceleration falls from one moderate $v_0$ to the next. A chapter of volume two asks which
packets turn, and why (`sec34_boomeron_map`).

## Model

The chain has the wells of Eq. (10), and only its first bead moves at $t=0$, Eqs. (9) and (26):
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
All is dimensionless. The end at $n=1$ is free, and the chain is so long that the other end stays at rest. We locate the
packet by its energy, Eqs. (23) and (24) with $m=5$,
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + V(y_{n+1}-y_n),\qquad
  X = \sum_{|n-n'|\le m} n\,e_n \Big/ \sum_{|n-n'|\le m} e_n,$$
where $V$ is the energy of the contact to the right. Here $n'$ is the site of the largest $e_n$ in the whole chain,
because a packet on its way back need not be the foremost one. The beads of the packet oscillate with a period of about
four, and its centre $X$ oscillates with them. */
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_turn.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/turning.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/acceleration.hpp"

using namespace lattice;

/**
## The experiment

We strike the chain, follow the packet, smooth its path and find the turn. `evolve` integrates Eq. (9) by
Runge–Kutta–Nyström steps of order six, corrected where a contact opens or closes (event_corrected.hpp), and reports the
state every 0.2 units of time. `smooth` averages $X(t)$ over 15 units, about four periods, with the weight
$1+\cos(2\pi t/15)$. `find_turn` reads three moments from the smoothed trajectory: the first at which the *velocity
vanishes* (`stop`), beyond site 8; the *turning point* (`apex`), the furthest one before the packet has come back by
five sites; and the *reflection* (`rebound`), the nearest one before it has moved out again by three. A packet can stop,
drift on and turn later, so the first two may differ. A parabola through three samples interpolates each moment; if one
does not occur, it is `nan`. */
struct Experiment {
  double v0, s, time;
  std::size_t sites = 150;
};
struct Trajectory {
  Path path{}, smoothed{};     // time, centre X and energy, sample by sample
  Turn turn{}, other_width{};  // read from the smoothed path; with half the smoothing
  State<double> end{};
  Run run{};  // energy drift
};
constexpr double sample = 0.2, width = 15;        // of time
constexpr double pictured = 1.87;                 // impact of figure 23
constexpr double back = 5, again = 3, clear = 8;  // sites, which define a turn
using Seen = std::function<void(double t, const std::vector<double>& e)>;

/// The strongest packet after an impact.
Trajectory trajectory(const Experiment& impact, const Method& method, const Seen& look = {}) {
  const Chain chain{impact.sites, Quartic{impact.s}};
  State<double> state(impact.sites);  // y = 0, v = 0
  state.v[0] = impact.v0;
  Trajectory out;
  out.run = evolve(method, chain, state, impact.time, sample, [&](const State<double>& now) {
    const std::vector<double> e = energy_density(chain, now);
    const auto strongest = std::max_element(e.begin(), e.end()) - e.begin();
    out.path.add(now.t, e, std::size_t(strongest));
    if (look) look(now.t, e);
    if (std::abs(now.v.back()) > 1e-9 * impact.v0) throw Failure("the far end has moved");
  });
  if (!(out.run.energy_drift < 1e-3)) throw Failure("the energy is not conserved");
  out.end = state;
  out.smoothed = smooth(out.path, width);
  out.turn = find_turn(out.smoothed, back, again, clear);
  out.other_width = find_turn(smooth(out.path, width / 2), back, again, clear);
  return out;
}

/// The same impact with two steps; `.of(number)` is the finer result with its difference from the coarser one.
TwoRuns<Trajectory> two_runs(const Experiment& impact, double step) {
  return {trajectory(impact, EventCorrected{2 * step}), trajectory(impact, EventCorrected{step})};
}

double centre_at(const Trajectory& run, double t) {
  return run.smoothed.centre.at(std::size_t(std::lround((t - run.smoothed.t[0]) / sample)));
}

/**
A moment of the turn has an error from the step and one from the width of the smoothing. The width is our choice, and a
shorter step does not reduce its part of the error, which is the change that half the width makes. */
Estimate measured(const TwoRuns<Trajectory>& runs, Moment Turn::*moment, double Moment::*number) {
  Estimate e = runs.of([&](const Trajectory& run) { return run.turn.*moment.*number; });
  e.error += std::abs(runs.fine.other_width.*moment.*number - e.value);
  return e;
}

/**
## The motion (figure 22)

A map of snapshots would show spurious stripes, since it would sample the oscillation of the packet at nearly its own
rate. So figure 22 shows averages over four or five units of time, and over one in the zoom. The dashed line is the time
beyond which the motion depends on unknown digits of $v_0$ (see *How long the motion is predictable*). */
void report_maps(Report& report) {
  struct Panel {
    std::int64_t number;
    double v0, time, interval;
    std::size_t sites;
  };
  Table& table = report.table(
      "density_maps", {count("panel", "1: v0 = 1.5, 2: v0 = 1.9, 3: beginning of panel 2"),
                       number("t", "time"), count("n", "site", "site"),
                       number("e", "energy density, averaged between two successive times")});
  for (const Panel& panel :
       {Panel{1, 1.5, 1000, 4, 110}, {2, 1.9, 2500, 5, 40}, {3, 1.9, 900, 1, 28}}) {
    std::vector<double> sum(panel.sites, 0.0);
    double samples = 0, next = panel.interval;
    const auto average = [&](double t, const std::vector<double>& e) {
      for (std::size_t n = 0; n < panel.sites; ++n) sum[n] += e[n];
      if (++samples, t < next - 1e-9) return;
      for (std::size_t n = 0; n < panel.sites; ++n)
        table.add({panel.number, next - panel.interval / 2, n + 1, sum[n] / samples});
      std::fill(sum.begin(), sum.end(), 0.0);
      samples = 0, next += panel.interval;
    };
    trajectory({panel.v0, 1, panel.time, 400}, EventCorrected{report.quick ? 0.2 : 0.05}, average);
  }
}

/**
## Where and when the packet turns

At $v_0=1.9$ the packet stops, drifts on by a fifth of a site, turns, and comes back to the struck end. The packet of
$v_0=1.5$, the article's example of a slow deceleration, turns in the end too, far outside the figure. Near a turning
point a packet is almost at rest, and small errors decide in which direction it moves. So the steps are short, and the
time at which the velocity vanishes is known least.

| $s=1$ | article | here |
|---|---|---|
| $v_0 = 1.9$: velocity vanishes first, time | | [289 ± 7](cell:turns/velocity=1.9/stop_time) |
| its site | | [19.9](cell:turns/velocity=1.9/stop_site) |
| $v_0 = 1.9$: turning point, site | | [20.1](cell:turns/velocity=1.9/apex_site) |
| $v_0 = 1.9$: turning point, time | | [467 ± 1](cell:turns/velocity=1.9/apex_time) |
| $v_0 = 1.9$: reflection, time | | [898](cell:turns/velocity=1.9/return_time) |
| $v_0 = 1.5$: velocity vanishes first, time | not by 1000 | [4.36e3 ± 4e1](cell:turns/velocity=1.5/stop_time) |
| $v_0 = 1.5$: turning point, site | | [183](cell:turns/velocity=1.5/apex_site) |
| $v_0 = 1.5$: turning point, time | not by 1000 | [4.36e3 ± 2e1](cell:turns/velocity=1.5/apex_time) | */
struct TurningImpact {
  Experiment impact;
  double step;
};
// At v0 = 1.5 the way out takes most of the run; 1.85 and 1.95 are the ends of what rounds to 1.9. Those of the last row
// belong to the section on weakly hard wells
const std::vector<TurningImpact> turning = {
    {{1.5, 1, 5500, 260}, 0.025}, {{pictured, 1, 1300}, 0.025}, {{1.9, 1, 1200}, 0.025},
    {{1.85, 1, 1200}, 0.025},     {{1.95, 1, 900}, 0.025},      {{132, 0.005, 400, 800}, 0.01},
    {{44, 0.02, 500, 400}, 0.02}, {{12, 0.1, 530, 300}, 0.025}, {{3.5, 0.5, 450}, 0.025}};

void report_turns(Report& report) {
  const auto row = [&](const TurningImpact& of) -> Row {
    const auto runs = two_runs(of.impact, report.quick ? 4 * of.step : of.step);
    constexpr auto stop = &Turn::stop, apex = &Turn::apex, rebound = &Turn::rebound;
    const char *well = "from step and smoothing, known to 4 per cent; nan where there is none",
               *poorly = "from step and smoothing, known to 40 per cent; nan where there is none";
    const Estimate out_again = runs.of([](const Trajectory& run) {
      const double then = run.turn.rebound.time + 60;
      return then < run.smoothed.t.back() ? centre_at(run, then) : std::nan("");
    });
    return {
        {"s", "anharmonicity", of.impact.s},
        {"velocity", "impact velocity", of.impact.v0},
        {"stop_time", "time at which the velocity first vanishes",
         measured(runs, stop, &Moment::time), "", poorly},
        {"stop_site", "site at which it vanishes", measured(runs, stop, &Moment::site), "site",
         poorly},
        {"apex_site", "turning point, the farthest site reached on the way out",
         measured(runs, apex, &Moment::site), "site", well},
        {"apex_time", "time of the turning point", measured(runs, apex, &Moment::time), "", well},
        {"return_time", "time of the reflection at the struck end",
         measured(runs, rebound, &Moment::time), "", well},
        {"return_site", "site of the reflection", measured(runs, rebound, &Moment::site), "site",
         poorly},
        {"out_again", "site of the centre 60 units of time after the reflection", out_again, "site",
         poorly}};
  };
  report.table("turns").fill(turning, row, "turning packets");
}

/**
## The acceleration of the packet

Is the force almost constant, and does it grow with $s$ and $v_0$? A particle on which a constant force acts moves on a
parabola. So we fit one to the smoothed path of the centre; its bend is the mean acceleration $\ddot X$
(sec34/acceleration.hpp). We measure it on the way *out*, for $100 < t < 220$ and, to see whether this choice matters,
for $60 < t < 180$ and $140 < t < 260$; *between* the ways, where the packet is above nine tenths of its turning
point; and on the way *back*, from there to three tenths. The errors are the changes made by twice the step and by half
the smoothing width.

To infer a force one also needs a mass, and that of a packet nobody has measured. So the acceleration is the force but
for a factor, whose sign is not known.

| $\ddot X$, sites per squared unit of time | out | between | back |
|---|---|---|---|
| $s=1$, $v_0=1.9$ | [-0.00044](cell:acceleration/s=1/velocity=1.9/leg=out/acceleration) | [-6e-5](cell:leg=between/acceleration) | [-0.00028](cell:leg=back/acceleration) |
| second half minus first half, over the mean | [-0.2](cell:acceleration/s=1/velocity=1.9/leg=out/change) | [-0.3](cell:leg=between/change) | [1.2](cell:leg=back/change) |
| $s=1$, $v_0=1.93$ | [-0.00045](cell:acceleration/s=1/velocity=1.93/leg=out/acceleration) | [-0.000297](cell:leg=between/acceleration) | [-0.00042](cell:leg=back/acceleration) |

The article does not quantify *almost constant*. Around the turning point the acceleration is
[0.14](statement:boomeron.constant_force) of that on the way out. On the way back it grows, so it is largest near the
end that was hit. How small it is in between depends on digits of $v_0$ that are not printed: at 1.93, which rounds to
1.9 too, the three differ by less than a factor of two. The path is off a parabola by
[0.060](cell:arcs/arc=1/deviation) of its range (root mean square). This says little, since a wedge, the path of a
particle with no force but at its tip, is off by 0.072.

| way out, $s=1$ | $v_0 = 1.1$ | 1.3 | 1.5 | 1.9 | 2 |
|---|---|---|---|---|---|
| $100 < t < 220$ | [-0.0001454 ± 8e-7](cell:acceleration/s=1/velocity=1.1/leg=out/acceleration) | [-0.000149](cell:velocity=1.3/leg=out/acceleration) | [-0.000163](cell:velocity=1.5/leg=out/acceleration) | [-0.00044](cell:velocity=1.9/leg=out/acceleration) | [-0.00057](cell:velocity=2/leg=out/acceleration) |
| $60 < t < 180$ | [-0.000238 ± 2e-6](cell:acceleration/s=1/velocity=1.1/leg=earlier/acceleration) | [-0.000233](cell:velocity=1.3/leg=earlier/acceleration) | [-0.000254](cell:velocity=1.5/leg=earlier/acceleration) | [-0.00054](cell:velocity=1.9/leg=earlier/acceleration) | [-0.00066](cell:velocity=2/leg=earlier/acceleration) |

| way out, $v_0=1.9$ | $s=0$ | 0.005 | 0.05 | 0.25 | 0.5 | 1 |
|---|---|---|---|---|---|---|
| $100 < t < 220$ | [-8.73e-5 ± 7e-7](cell:acceleration/s=0/leg=out/acceleration) | [-8.75e-5 ± 7e-7](cell:s=0.005/leg=out/acceleration) | [-9.2e-5 ± 1e-6](cell:s=0.05/leg=out/acceleration) | [-0.0001459 ± 7e-7](cell:s=0.25/leg=out/acceleration) | [-0.0001539 ± 5e-7](cell:s=0.5/leg=out/acceleration) | [-0.00044](cell:s=1/velocity=1.9/leg=out/acceleration) |
| $60 < t < 180$ | [-0.000175](cell:acceleration/s=0/leg=earlier/acceleration) | [-0.000174](cell:s=0.005/leg=earlier/acceleration) | [-0.000167](cell:s=0.05/leg=earlier/acceleration) | [-0.000226 ± 2e-6](cell:s=0.25/leg=earlier/acceleration) | [-0.000237](cell:s=0.5/leg=earlier/acceleration) | [-0.00054](cell:s=1/velocity=1.9/leg=earlier/acceleration) |

In the window from 100 to 220 the modulus grows from each value of both lists to the next, in $s$ from 0.005 on (table
`acceleration`), and by a factor of three or more in all. From 60 to 180 it falls between $v_0 = 1.1$ and 1.3, and
between $s = 0.005$ and 0.05. In linear wells a packet slows down as well, but none turns until the end of our runs
(table `weakly_hard`). In hard wells at $v_0 = 1.5$ it slows down from quarter to quarter of the time of figure 22, and
does not turn:

| $s=1$, $v_0=1.5$, until $t = 1000$ | first quarter | second | third | fourth |
|---|---|---|---|---|
| speed, sites per unit of time | [0.129](cell:slowing/quarter=1/speed) | [0.0936](cell:quarter=2/speed) | [0.0785](cell:quarter=3/speed) | [0.0660](cell:quarter=4/speed) | */
struct Accelerated {
  double v0, s;
  bool turns = false;
};
using Way = Leg::Kind;
const std::vector<std::pair<const char*, Leg>> ways_out = {{"out", {Way::out, 100, 220}},
                                                           {"earlier", {Way::out, 60, 180}},
                                                           {"later", {Way::out, 140, 260}}},
                                               other_ways = {{"between", {Way::between}},
                                                             {"back", {Way::back}}};

// The packet of v0 = 1.5 within the time of figure 22
void report_slowing(Report& report, double step) {
  Table& slowing = report.table(
      "slowing", {count("quarter", "quarter of the time until 1000"),
                  estimate("speed", "mean speed at v0 = 1.5, s = 1", "site per unit of time")});
  const auto slow = two_runs({1.5, 1, 1000}, step);
  for (std::size_t quarter = 0; quarter < 4; ++quarter)
    slowing.add({quarter + 1, slow.of([&](const Trajectory& run) {
                   const std::vector<double>&t = run.smoothed.t, &x = run.smoothed.centre;
                   const std::size_t n = t.size() / 4, from = quarter * n,
                                     to = std::min(from + n, t.size() - 1);
                   return (x[to] - x[from]) / (t[to] - t[from]);
                 })});
}

// From the impact to the first reflection, and from there to the second one
void report_arcs(Report& report, double step) {
  const auto runs = two_runs({1.9, 1, 1900}, step / 2);
  const auto deviation = [](const Trajectory& run, int arc) {
    const Path& p = run.smoothed;
    const double first = run.turn.rebound.time;
    if (arc == 1) return fit_parabola(p, stretch(p, 0, first)).deviation;
    Path rest;
    for (std::size_t i = stretch(p, first, first).first; i < p.t.size(); ++i)
      rest.add(p.t[i], p.centre[i]);
    return fit_parabola(p, stretch(p, first, find_turn(rest, back, again, clear).rebound.time))
        .deviation;
  };
  Table& table = report.table(
      "arcs", {count("arc", "1: until the first reflection, 2: from there to the second one"),
               estimate("deviation",
                        "root mean square distance of the path at v0 = 1.9, s = 1, from the best "
                        "parabola, over its range",
                        "", "difference of two steps, known to 40 per cent")});
  for (int arc : {1, 2})
    table.add({arc, runs.of([&](const Trajectory& run) { return deviation(run, arc); })});
}

// Each impact twice; where packets turn, also between rebounds and on the way back
void report_acceleration(Report& report) {
  const double step = report.quick ? 0.1 : 0.05;
  std::vector<Accelerated> list;
  for (double v0 : {1.1, 1.3, 1.5, 1.6, 1.7, 1.8, pictured, 2.0}) list.push_back({v0, 1});
  for (double s : {0.0, 0.005, 0.05, 0.25, 0.5, 0.75}) list.push_back({1.9, s});
  for (double v0 : {1.9, 1.93}) list.push_back({v0, 1, true});
  std::vector<std::vector<Cells>> rows(list.size());
  parallel_for(list.size(), [&](std::size_t i) {
    const auto [v0, s, turns] = list[i];
    const auto runs = two_runs({v0, s, turns ? 1100.0 : 300.0}, step);
    auto legs = ways_out;
    if (turns) legs.insert(legs.end(), other_ways.begin(), other_ways.end());
    for (const auto& [name, leg] : legs) {
      const Acceleration seen = acceleration_of(runs.coarse.path, runs.fine.path, leg);
      rows[i].push_back({s, v0, name, seen.mean, seen.change, seen.lost});
    }
  });
  const std::string from = "from the time step and the smoothing; known to ";
  Table& table = report.table(
      "acceleration",
      {number("s", "anharmonicity"), number("velocity", "impact velocity"),
       label("leg",
             "the part of the way: out (t from 100 to 220), earlier (60 to 180), later "
             "(140 to 260), between (above nine tenths of the turning point), back"),
       estimate("acceleration", "mean acceleration of the packet's centre",
                "site per squared unit of time", from + "2 per cent"),
       estimate("change",
                "acceleration in the second half of the leg minus that in the first, relative to "
                "that of the whole",
                "", "relative; " + from + "40 per cent"),
       estimate("lost", "velocity at the end of the leg minus that at its beginning, over the time",
                "site per squared unit of time", from + "90 per cent")});
  for (const auto& of_one : rows)
    for (const Cells& row : of_one) table.add(row);
  report_slowing(report, step);
  report_arcs(report, step);
}

/**
## Profiles close to the turning (figure 23)

The article shows the velocities of all beads at $v_0 = 1.87$ for two times at which, it says, the packet is close to
turning. At the first of them the centre is two and a half sites short of its turning point, nearer than half the width
of the packet, and still moves with a fifth of the speed that it had when it left the end. The time at which its
velocity first vanishes is poorly determined, because the trajectory is almost flat there: with half the smoothing it is
[315](cell:printed_range/velocity=1.87/smoothed_less), still later than the article's times. So the packet is close to
turning in place, but not in time. Between it and the end the beads move with up to
[0.27](cell:turning_profiles/t=238/n=15/v), a third of its largest velocity; a few sites ahead of it all are at rest.

![Velocities close to the turning. Drawn by fig23_turning_profiles.gp: `v` against `n` for two `t`, from the table
`turning_profiles`.](fig:23) */
/// How fast the centre moves between two times; half the smoothing shows what the smoothing does.
Estimate mean_speed(const TwoRuns<Trajectory>& runs, double from, double to) {
  const auto speed = [&](const Path& p) {
    const Stretch of = stretch(p, from, to);
    return (p.centre[of.last - 1] - p.centre[of.first]) / (p.t[of.last - 1] - p.t[of.first]);
  };
  Estimate e = runs.of([&](const Trajectory& run) { return speed(run.smoothed); });
  e.error += std::abs(speed(smooth(runs.fine.path, width / 2)) - e.value);
  return e;
}

void report_profiles(Report& report) {
  Table& table =
      report.table("turning_profiles",
                   {number("t", "time"), count("n", "site", "site"),
                    estimate("v", "velocity", "", "against the largest: difference of two steps")});
  Table& near = report.table(
      "close_to_turning", {number("t", "time"),
                           estimate("distance", "distance of the centre from its turning point",
                                    "site", "from the time step and the smoothing"),
                           estimate("speed", "over ten units of time", "site per unit of time",
                                    "from the time step and the smoothing, known to 20 per cent"),
                           estimate("first_speed", "between t = 10 and 30", "site per unit of time",
                                    "from the time step and the smoothing, known to 20 per cent")});
  const double step = report.quick ? 0.1 : 0.025;
  const auto whole = two_runs({pictured, 1, 1300}, step);
  const Estimate apex = measured(whole, &Turn::apex, &Moment::site);
  for (double time : {238.0, 241.0}) {
    const auto runs = two_runs({pictured, 1, time}, step);
    for (std::size_t n = 0; n < 40; ++n)
      table.add({time, n + 1, runs.of([&](const Trajectory& run) { return run.end.v[n]; })});
    const Estimate here = whole.of([&](const Trajectory& run) { return centre_at(run, time); });
    near.add({time, Estimate(apex.value - here.value, apex.error + here.error),
              mean_speed(whole, time - 5, time + 5), mean_speed(whole, 10, 30)});
  }
}

/**
Can the rounding of $v_0$ explain this? It leaves a range from 1.865 to 1.875, of which we take eleven impacts (table
`printed_range`). The velocity first vanishes at [319.8 ± 0.8](cell:printed_range/velocity=1.875/stop_time) at the
earliest, with half the smoothing at [296](cell:printed_range/velocity=1.868/smoothed_less), well after the article's
240. A velocity profile does not distinguish a packet at rest from one that moves slowly.

| $s=1$, $v_0=1.87$ | article | here |
|---|---|---|
| distance from the turning point at $t=238$, sites | close | [2.46](cell:close_to_turning/t=238/distance) |
| at $t=241$ | close | [2.36](cell:close_to_turning/t=241/distance) |
| speed at $t=238$, sites per unit of time | | [0.031](cell:close_to_turning/t=238/speed) |
| speed from $t=10$ to 30 | | [0.14](cell:close_to_turning/t=238/first_speed) |
| turning point, site | | [23.2](cell:turns/velocity=1.87/apex_site) |
| turning point, time | | [493](cell:turns/velocity=1.87/apex_time) |
| velocity vanishes first, time | close to 238 and 241 | [5e2 ± 2e2](cell:turns/velocity=1.87/stop_time) |
| $v_0=1.865$: the same | | [3.7e2 ± 3e1](cell:printed_range/velocity=1.865/stop_time) |
| $v_0=1.875$: the same | | [319.8 ± 0.8](cell:printed_range/velocity=1.875/stop_time) | */
void report_printed_range(Report& report) {
  std::vector<double> velocities(report.quick ? 3 : 11);
  for (std::size_t i = 0; i < velocities.size(); ++i)
    velocities[i] = 1.865 + 0.01 * double(i) / double(velocities.size() - 1);
  Table& table = report.table(
      "printed_range", {number("velocity", "impact velocity"),
                        estimate("stop_time", "time at which the velocity first vanishes", "",
                                 "from the time step and the smoothing; known to 40 per cent"),
                        estimate("smoothed_less", "the same with half the smoothing", "",
                                 "difference of two steps, known to 5 per cent")});
  const auto row = [](double v0) {
    const auto runs = two_runs({v0, 1, 700}, 0.1);
    return Cells{v0, measured(runs, &Turn::stop, &Moment::time),
                 runs.of([](const Trajectory& run) { return run.other_width.stop.time; })};
  };
  table.fill(velocities, row, "impacts within the printed digits");
}

/**
## Weakly hard wells, $s = 0.005$

The article sees reversals for $s\ge0.005$ and none for $s=0$, and prints neither an impact nor a time. At $s=0.005$ the
largest impact that it prints, 1.9, turns no packet until the end of figure 22, nor do impacts thirty times as strong as
long as we look (table `weakly_hard`); after 1.9 the packet is almost where it is in linear wells. Packets turn soon
after an impact of 132. In linear wells one has then never moved inward by $t=450$, and still moves outward. For three
values of $s$ between 0.005 and 1 we give an impact that turns a packet soon. Weaker ones may turn packets much farther
out.

| | article | here |
|---|---|---|
| $s=0.005$, $v_0=132$: turning point, site | turns | [26.8](cell:turns/velocity=132/apex_site) |
| reflection, time | | [310](cell:turns/velocity=132/return_time) |
| $s=0.02$, $v_0=44$: turning point, site | turns | [24.9](cell:turns/velocity=44/apex_site) |
| $s=0.1$, $v_0=12$: turning point, site | turns | [19.5](cell:turns/velocity=12/apex_site) |
| $s=0.5$, $v_0=3.5$: turning point, site | turns | [12.9](cell:turns/velocity=3.5/apex_site) |
| $s=0$, $v_0=132$: centre by $t=450$, site | does not turn | [434](cell:weakly_hard/s=0/velocity=132/centre) |
| $s=0$, $v_0=1.9$: centre by $t=2500$, site | does not turn | [566](cell:weakly_hard/s=0/velocity=1.9/centre) |
| $s=0.005$, $v_0=1.9$: the same | turns? | [565](cell:weakly_hard/s=0.005/velocity=1.9/centre) | */
void report_weakly_hard(Report& report) {
  std::vector<TurningImpact> list = {
      {{1.5, 0, 1000, 620}, 0.1},     {{1.9, 0, 2500, 620}, 0.1},     {{132, 0, 450, 620}, 0.01},
      {{1.5, 0.005, 1000, 620}, 0.1}, {{1.9, 0.005, 2500, 620}, 0.1}, {{5, 0.005, 1500, 620}, 0.1},
      {{27, 0.005, 900, 620}, 0.05},  {{60, 0.005, 800, 620}, 0.025}};
  const auto row = [&](const TurningImpact& of) -> Row {
    const auto runs = two_runs(of.impact, report.quick ? 2 * of.step : of.step);
    const auto last = [](const Trajectory& p) { return p.smoothed.centre.back(); };
    const auto speed = [](const Trajectory& p) {
      const auto& [t, x, energy, peak] = p.smoothed;
      return (x.back() - x[x.size() - 51]) / (t.back() - t[t.size() - 51]);
    };
    const auto fallen = [](const Trajectory& p) {
      double most = p.smoothed.centre[0], back = 0;
      for (double x : p.smoothed.centre) most = std::max(most, x), back = std::max(back, most - x);
      return back;
    };
    return {
        {"s", "anharmonicity", of.impact.s},
        {"velocity", "impact velocity", of.impact.v0},
        {"until", "end of the run", of.impact.time},
        {"centre", "centre of the packet, at the end of the smoothed path", runs.of(last), "site"},
        {"speed", "its speed in the last ten units of time", runs.of(speed),
         "site per unit of time"},
        {"fallen_back", "the farthest that it has ever fallen back", runs.of(fallen), "site"}};
  };
  if (report.quick) list.resize(1);
  report.table("weakly_hard").fill(list, row, "weakly hard wells");
}

/**
## How long the motion is predictable

The motion is chaotic: two runs that differ by as little as a rounding error separate sooner or later. We call them
*decorrelated* when their states differ by a tenth of the largest displacement or velocity. One impact with two steps
shows for how long we can compute the motion. Two impacts that differ by a fraction $\delta$ show for how long it is
predictable if $v_0$ is known to that accuracy; half a unit of the last digit of 1.87 is $\delta\approx3\cdot10^{-3}$.
*/
constexpr double compared_every = 2;  // of time

double decorrelation_time(double v0, double step, double other_v0, double other_step) {
  const Chain chain{150, Quartic{1}};
  State<double> one(chain.sites), other(chain.sites);
  one.v[0] = v0, other.v[0] = other_v0;
  for (double t = 0; t < 1700; t += compared_every) {
    if (distance(one, other) > 0.1) return t;
    evolve(EventCorrected{step}, chain, one, compared_every, compared_every);
    evolve(EventCorrected{other_step}, chain, other, compared_every, compared_every);
    for (const auto& [state, v] : {std::pair{&one, v0}, {&other, other_v0}}) {
      if (std::abs(state->v.back()) > 1e-9 * v) throw Failure("the far end has moved");
      if (!(std::abs(energy(chain, *state) / (v * v / 2) - 1) < 1e-3))
        throw Failure("the energy is not conserved");
    }
  }
  throw Failure("two impacts have not decorrelated");
}

/**
Two steps agree until well beyond the first reflection. Figure 22 marks the time at which two impacts that differ by
$10^{-6}$ decorrelate, since velocities are hardly ever printed with more digits. So turning point and first reflection
are well defined, and the much later part of the map is one possibility among many. With three digits two impacts
decorrelate even before they turn.

| $s=1$, $v_0=1.9$ | decorrelated at |
|---|---|
| one impact, steps of 0.05 and 0.025 | [1.38e3 ± 6e1](cell:decorrelation/coarse=0.05/t) |
| two impacts, $\delta = 3\cdot10^{-3}$ | [58 ± 2](cell:decorrelation/delta=0.003/t) |
| $\delta = 10^{-4}$ | [632 ± 2](cell:decorrelation/delta=1e-4/t) |
| $\delta = 10^{-6}$ | [1.05e3 ± 1e1](cell:decorrelation/delta=1e-6/t) |
| $\delta = 10^{-8}$ | [1.33e3 ± 1e1](cell:decorrelation/delta=1e-8/t) | */
void report_decorrelation(Report& report) {
  struct Pair {
    double delta, coarse, fine;
  };
  std::vector<Pair> pairs{{0, 0.1, 0.05}, {0, 0.05, 0.025}};
  for (double delta : {3e-3, 1e-4, 1e-6, 1e-8}) pairs.push_back({delta, 0.1, 0.1});
  if (report.quick) pairs = {{0, 0.2, 0.1}, {1e-6, 0.1, 0.1}};
  Table& table = report.table(
      "decorrelation",
      {number("delta",
              "relative difference of the impact velocities; 0 for one impact with two time steps"),
       number("coarse", "first time step"), number("fine", "second time step"),
       estimate("t", "time at which the two runs have decorrelated", "",
                "change made by steps twice as long, and the time between two comparisons; known "
                "to 26 per cent")});
  const auto row = [](const Pair& p) {
    const auto time = [&](double longer) {
      return decorrelation_time(1.9, longer * p.coarse, 1.9 * (1 + p.delta), longer * p.fine);
    };
    const double t = time(1);
    return Cells{p.delta, p.coarse, p.fine, Estimate(t, std::abs(t - time(2)) + compared_every)};
  };
  table.fill(pairs, row, "pairs of runs");
}

/**
## Erratic motion (figure 22, last panel)

Beyond that time only statements about ensembles make sense. So we draw 24 impacts at random from an interval of
relative width $10^{-6}$ around $v_0 = 1.9$ and see how far the centres of their packets spread. Centres that are
equally likely to be anywhere up to the turning point would have a standard deviation of six sites; after $t = 2000$ at
least a tenth of the packets is beyond it, up to site 34. With twelve impacts we try an interval a hundred times as wide
and one of a hundredth of the width.

| standard deviation of the centres, sites | article | here |
|---|---|---|
| mean until $t = 850$, out and back | | [0.00022 ± 4e-5](cell:spread/noise=1e-6/part=out_and_back/deviation) |
| mean for $2000 < t < 2600$ | erratic | [9 ± 1](cell:spread/noise=1e-6/part=late/deviation) |
| relative width $10^{-4}$: until $t = 850$ | | [0.017](cell:spread/noise=1e-4/part=out_and_back/deviation) |
| relative width $10^{-8}$: for $2000 < t < 2600$ | | [8 ± 2](cell:spread/noise=1e-8/part=late/deviation) | */
struct Spread {
  double t, mean, deviation, low, high;  // of the centres; the tenths
};

// Of smoothed trajectories, every ten units of time; otherwise the phases of the oscillations would count as a spread
std::vector<Spread> spreads(const std::vector<double>& v0, double step, double time) {
  const std::size_t members = v0.size(), tenth = members / 10;
  std::vector<Path> paths(members);
  parallel_for(members, [&](std::size_t i) {
    paths[i] = trajectory({v0[i], 1, time, 300}, EventCorrected{step}).smoothed;
  });
  std::vector<Spread> out;
  for (std::size_t k = 0; k < paths[0].t.size(); k += 50) {
    std::vector<double> x;
    double mean = 0, square = 0;
    for (const Path& p : paths) x.push_back(p.centre.at(k)), mean += x.back() / double(members);
    for (double c : x) square += (c - mean) * (c - mean) / double(members - 1);
    std::sort(x.begin(), x.end());
    out.push_back({paths[0].t[k], mean, std::sqrt(square), x[tenth], x[members - 1 - tenth]});
  }
  return out;
}

/// Impacts within a fraction `noise` of 1.9, drawn at random.
constexpr unsigned long seed = 20130501;
std::vector<double> draws(double noise, std::size_t count) {
  Random random(seed);
  std::vector<double> v0(count);
  for (double& v : v0) v = 1.9 * (1 + random.uniform(-noise / 2, noise / 2));
  return v0;
}

// The deviation, averaged over a part of the time; with more and less noise for fewer impacts
void report_ensemble(Report& report) {
  const std::size_t members = report.quick ? 8 : 24;
  const double time = report.quick ? 2200 : 2600;
  Table& table = report.table(
      "ensemble", {number("t", "time"), number("mean", "mean of the packets' centres", "site"),
                   number("deviation", "standard deviation of the packets' centres", "site"),
                   number("low", "lower decile of the centres", "site"),
                   number("high", "upper decile of the centres", "site")});
  table.meta = {{"seed", std::to_string(seed)}, {"members", std::to_string(members)}};
  Table& parts = report.table(
      "spread", {number("noise", "the relative width of the interval of impacts"),
                 label("part", "part of the motion"), number("from", "its first time"),
                 number("to", "its last time"),
                 estimate("deviation", "mean of the standard deviation of the centres", "site",
                          "difference of two resolutions, known to 50 per cent")});
  for (const double noise : {1e-6, 1e-4, 1e-8}) {
    if (report.quick && noise != 1e-6) continue;
    const std::vector<double> v0 = draws(noise, noise == 1e-6 ? members : members / 2);
    const TwoRuns<std::vector<Spread>> both{spreads(v0, 0.2, time), spreads(v0, 0.1, time)};
    if (noise == 1e-6)
      for (const Spread& at : both.fine) table.add({at.t, at.mean, at.deviation, at.low, at.high});
    const auto add = [&](const char* part, double from, double to) {
      parts.add({noise, part, from, to, both.of([&](const std::vector<Spread>& all) {
                   double sum = 0, n = 0;
                   for (const Spread& at : all)
                     if (at.t >= from && at.t <= to) sum += at.deviation, ++n;
                   return sum / n;
                 })});
    };
    add("out_and_back", 0, 850);
    add("late", report.quick ? 1900 : 2000, time);
  }
}

/**
## Accuracy and checks

Every number comes from two resolutions. Only those of the last two sections and of the second arc depend on chaos.
Every run, also those whose decorrelation we time, stops with an error if its far end moves or if its energy drifts by
more than a thousandth. Two other integrators check ours, and the program fails where they disagree. GSL's adaptive
method of order eight, which has no event detection, has to arrive at the same state at $t=100$ within $10^{-7}$. For
the whole trajectory, where GSL would be slow, another scheme, with fourteen stages, has to give the time of the
reflection within 0.2. The tests check `find_turn` and `fit_parabola` on constructed trajectories. The article does not
say how it integrates or averages, or how long its chain is. */
void check_by_other_routes(bool quick) {
  const Experiment out{1.9, 1, 100, 60};
  State<double> start(out.sites);
  start.v[0] = out.v0;
  distance_from_reference({out.sites, Quartic{out.s}}, start, out.time,
                          trajectory(out, EventCorrected{0.0125}).end, 1e-7);  // or it throws

  const EventCorrected usual{quick ? 0.1 : 0.025}, other{usual.step, nystrom(blanes_moan_6_14())};
  const auto back = [](const EventCorrected& method) {
    return trajectory({1.9, 1, 1200}, method).turn.rebound.time;
  };
  if (!(std::abs(back(other) - back(usual)) < 0.2))
    throw Failure("another integrator returns at another time");
}

void reproduce(Report& report) {
  report_maps(report);
  report_turns(report);
  report_profiles(report);
  report_decorrelation(report);
  report_acceleration(report);
  report_printed_range(report);
  report_weakly_hard(report);
  report_ensemble(report);
  check_by_other_routes(report.quick);
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
| `boomeron.force_grows`: the effective force increases with s and with the impact velocity | increases | acceleration.acceleration (s = 1, velocity = 1.1, leg = out), (s = 1, velocity = 1.3, leg = out): 0.0001454 < 0.0001493 (the closest of 14) | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** Another impact that turns is a row of `turning`, $\{v_0, s, t\}$, the length of the chain and the
shorter of two steps. Another one whose acceleration is measured is in `list` of `report_acceleration`; figure 22 has
those of `report_maps`, with names in its script, and figure 23 that of `pictured`. The sites `back`, `again` and
`clear` define a turn; the smoothing is `width`. Lengths of chains and stretches of fits are chosen for these wells: try
others with `sec34_boomeron run --well`. The figures read columns by name.

1. *Easy.* When does the packet of figure 23 turn? `build/bin/sec34_boomeron run --velocity 1.87` gives
   `apex_site` = 23.175 and `apex_time` = 493. Hint: before it turns it is slow for a long time.
2. *Harder.* For how long is a harder impact predictable? `build/bin/sec34_boomeron run --velocity 2.2` gives
   `decorrelation_time` = 580. Hint: this packet stays near the struck end and meets its own waves again and again.

`run` takes wells, contacts and a length of your choice, and a tolerance instead of a step (commands/one_turn.hpp). */
int main(int argc, char** argv) {
  return run({"sec34_boomeron", "3.4", "Packets that turn round in hard wells (section 3.4)",
              reproduce, commands<OneTurn>()},
             argc, argv);
}
