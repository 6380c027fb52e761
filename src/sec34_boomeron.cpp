/**
# 3.4 Packets that reverse their direction in hard wells

After an impact in hard wells, $s > 0$, the travelling breather slows down, turns round, comes back to the end that was
hit and is reflected there. How far does such a packet get, how does it slow down, and for how long can one predict it?
Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) compares it with *boomerons*, solitons that reverse
their direction, and says that

- with $s=1$ and $v_0=1.9$ the packet turns, returns and is reflected several times until its motion is erratic, while
  with $v_0 = 1.5$ it only slows down (figure 22);
- with $v_0=1.87$ it is close to turning at $t = 238$ and 241, and nonlinear waves are confined between it and the end
  that was hit, which may be why it turns (figure 23);
- during a few reflections its centre moves like a particle in an almost constant force, which grows with $s$ and $v_0$;
- it turns for $s\ge0.005$ and not for $s = 0$.

The turn at 1.9, the erratic end and the waves hold as printed; that of 1.5 is slow if we compare decelerations, and it
turns much later. Three more hold with an assumption: that *close to turning* is meant in space, since the packet of
1.87 hovers near its turning point for 250 units of time before it turns; that the force is compared at $t = 160$, since
earlier it does not always grow; that at $s=0.005$ any impact will do, as of ours only that of 132 turns a packet. But
the acceleration is not almost constant, not even a function of the position, and at 1.9 an uncertainty of $10^{-4}$ of
$v_0$ makes the position uncertain soon after the first reflection.

![Energy density after impacts with 1.5 and 1.9, a zoom, and the spread of an ensemble.](fig:22)

<!-- head -->
`build/bin/sec34_boomeron` computes this chapter in 5 s on two cores and writes 9 tables to `build/data/sec34_boomeron`.
Its figures: `make fig22`, `make fig23`, `make x51`, `make x58`, `make x65`, `make x73`. With your parameters: `run`,
one impact: turning point, reflection at the struck end, decorrelation time.
<!-- /head -->

## Model

The chain has the wells of Eq. (10), and only its first bead moves at $t=0$, Eqs. (9) and (26):
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
All quantities are dimensionless and both ends are free. At the amplitude of the impact, $v_0$, the anharmonic force
$s\,v_0^3$ and the contact force $v_0^{3/2}$ have the ratio $\chi = s\,v_0^{3/2}$, which says how anharmonic an impact
is; for $s=1$ and $v_0=1.9$ it is 2.6. The packet is located by its energy, Eqs. (23) and (24) with $m=5$,
$$e_n = \tfrac12\dot y_n^2 + \tfrac12 y_n^2 + \tfrac s4 y_n^4 + \tfrac25(y_n-y_{n+1})_+^{5/2},\qquad
  X = \sum_{|n-n'|\le m} n\,e_n \Big/ \sum_{|n-n'|\le m} e_n.$$
Here $n'$ is the site of the largest $e_n$ in the whole chain, because a packet on its way back need not be the foremost
one. */
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "commands/one_turn.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/impact/turning.hpp"
#include "lattice/integrators/schemes.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/acceleration.hpp"

using namespace lattice;
using namespace report;

/**
## The experiments

We strike a chain, follow the packet, smooth its path and find the turn. The tables `turns`, `acceleration` and `onward`
come from one list of impacts: */
struct Experiment {
  double v0 = 0, s = 1, time = 1200;  // followed until then
  std::size_t sites = 150;            // so many that nothing comes back from the far end
};
constexpr double v0_slow = 1.5, v0_fig23 = 1.87, v0_reversed = 1.9;  // the article's, for s = 1
constexpr double way_out = 300;  // time of runs for the acceleration on the way out only

std::vector<Experiment> experiments() {
  std::vector<Experiment> all = {{v0_slow, 1, 5500, 260},  // v0, s, time, sites; turns far out
                                 {2, 1, 700},
                                 {3.5, 0.5, 450},  // impacts that turn in less hard wells
                                 {12, 0.1, 530, 300},
                                 {44, 0.02, 500, 400},
                                 {132, 0.005, 400, 800},
                                 {132, 0, 450, 620},  // none of these turns
                                 {1.5, 0, 1000, 620},
                                 {1.9, 0, 2500, 620},
                                 {1.5, 0.005, 1000, 620},
                                 {1.9, 0.005, 2500, 620},
                                 {5, 0.005, 1500, 620},
                                 {27, 0.005, 900, 620},
                                 {60, 0.005, 800, 620}};
  // What rounds to 1.9, and closer to each other what rounds to 1.87
  for (int k = 185; k <= 195; ++k) all.push_back({k / 100.0});
  for (int k = 1865; k <= 1875; ++k)
    if (k != 1870) all.push_back({k / 1000.0});
  for (double v0 : {1.1, 1.3, 1.6, 1.7, 1.8}) all.push_back({v0, 1, way_out});
  for (double s : {0.05, 0.25, 0.5, 0.75}) all.push_back({v0_reversed, s, way_out});
  return all;
}

/**
`strike` (impact.hpp) integrates Eq. (9) by Runge–Kutta–Nyström steps of order six, corrected where a contact opens or
closes, and records $X(t)$ every 0.2 units of time (`path_sampling`). It throws if the last bead has moved, so that
nothing can have come back from there. The step follows the fastest motion, that of well, contact or quartic term, with
the rates one, $v_0^{1/5}$ and $(sv_0^2)^{1/4}$. */
double finer_step(const Experiment& of, const Report& report) {
  const double rate = std::max({1.0, std::pow(of.v0, 0.2), std::pow(of.s * of.v0 * of.v0, 0.25)});
  return (report.quick ? 0.2 : 0.05) / rate;
}

ImpactRun run_of(const Experiment& of, const EventCorrected& method, const ImpactLook& look = {}) {
  const Impact impact{.velocity = of.v0,
                      .chain = {of.sites, Quartic{of.s}},
                      .time = of.time,
                      .every = path_sampling,
                      .denser = false,
                      .packet = WhichPacket::strongest};
  return strike(method, impact, look);
}

TwoRuns<ImpactRun> two_runs(const Experiment& of, double step) {
  return {run_of(of, EventCorrected{2 * step}), run_of(of, EventCorrected{step})};
}

/**
The beads of the packet oscillate, and $X$ oscillates with them. So `smooth` averages it over 15 units
(`path_smoothing`) with the weight $1+\cos(2\pi t/15)$. Numbers read from the path, but for `centre` of `acceleration`,
have an error from the step and one from the smoothing: what twice the step and half the width change. */
struct Packet {
  Experiment with{};
  TurnEstimate turn;
  Path coarse, fine, less_smooth;

  bool turns() const { return !std::isnan(turn.apex_time.value); }
  /// A number of the path.
  template <class Number>
  Estimate of(Number number) const {
    Estimate e = with_error(number(coarse), number(fine));
    e.error += std::abs(number(less_smooth) - number(fine));
    return e;
  }
};

Packet packet_of(const Experiment& with, double step) {
  const TwoRuns<ImpactRun> runs = two_runs(with, step);
  return {.with = with,
          .turn = estimate_turn(runs.coarse.path, runs.fine.path),
          .coarse = smooth(runs.coarse.path, path_smoothing),
          .fine = smooth(runs.fine.path, path_smoothing),
          .less_smooth = smooth(runs.fine.path, path_smoothing / 2)};
}

double centre_at(const Path& path, double t) {
  return path.samples.at(std::size_t(std::lround((t - path[0].t) / path_sampling))).centre;
}
/// Mean velocity over ten units of time.
double velocity_at(const Path& path, double t) {
  return (centre_at(path, t + 5) - centre_at(path, t - 5)) / 10;
}

/**
## Where and when a packet turns

`find_turn` (turning.hpp) finds three moments of the smoothed path: the first *stop*, where the velocity vanishes; the
*turning point* (`apex`), the farthest one before the packet has come back by five sites; and the *reflection*
(`rebound`), the nearest one before it has moved out again by three.

At $v_0=1.9$ the packet reaches site [20.1](cell:turns/s=1/velocity=1.9/apex_site), comes back and is reflected at $t =$
[898](cell:turns/s=1/velocity=1.9/return_time). But this impact is printed with two digits. Over what rounds to 1.9 the
turning point falls from site [24.0](cell:turns/s=1/velocity=1.85/apex_site) to
[16.9](cell:turns/s=1/velocity=1.95/apex_site), though not smoothly: it rises between 1.86 and 1.87, and from 1.870 to
1.871 it drops by a whole site, from [23.2](cell:turns/s=1/velocity=1.87/apex_site) to
[22.2](cell:turns/s=1/velocity=1.871/apex_site). For the packet slows down on a plateau, where $X$ has several maxima,
often within a tenth of a site of each other, and the farthest counts. Its *time* jumps by hundreds as another one takes
over. So times and later motion belong to exactly 1.9. That the packet turns is robust; all but that of 1.86 are
reflected within our runs.

![Turning point and its time for impacts that round to 1.9.](fig:x65)

The packet of 1.5, the article's example of slow deceleration, turns in the end too, far outside the figure: at site
[183](cell:turns/s=1/velocity=1.5/apex_site) and $t =$ [4.36e3 ± 2e1](cell:turns/s=1/velocity=1.5/apex_time). */
constexpr double reflected_for = 60;  // time after a reflection at which the packet is looked for
constexpr double near_turn = 0.9;     // of the way to the turning point

void report_turns(Report& report, const std::vector<Packet>& packets) {
  const auto out_again = [](const Path& p) {
    const double then = find_turn(p).rebound.time + reflected_for;
    return then < p.back().t ? centre_at(p, then) : std::nan("");
  };
  const auto at_turn = [](const Path& p) {
    const Moment apex = find_turn(p).apex;
    double from = apex.time, to = apex.time;
    while (centre_at(p, from) > near_turn * apex.site) from -= path_sampling;
    while (to < p.back().t && centre_at(p, to) > near_turn * apex.site) to += path_sampling;
    return to < p.back().t ? fit_parabola(p, from, to).acceleration : std::nan("");
  };
  const auto off_parabola = [](const Path& p) {
    const Moment end = find_turn(p).rebound;
    return end.found() ? fit_parabola(p, 0, end.time).deviation : std::nan("");
  };
  Table& turns = report.table("turns");
  for (const Packet& packet : packets)
    if (packet.turns())
      turns.add({{"s", packet.with.s},
                 {"velocity", packet.with.v0},
                 {"apex_site", packet.turn.apex_site},
                 {"apex_time", packet.turn.apex_time},
                 {"stop_time", packet.turn.stop_time},
                 {"return_time", packet.turn.return_time},
                 {"return_site", packet.turn.return_site},
                 {"out_again", packet.of(out_again)},
                 {"at_turn", packet.of(at_turn)},
                 {"parabola", packet.of(off_parabola)}});
}

/**
How well does the integration know a path on which small errors grow? Figure x73 shows the errors at $v_0 = 1.9$ against
the step, for our scheme and for one of fourteen stages (Blanes and Moan), both compared with the latter at a step of
1/80. They fall with a high power of the step. Ours, 0.036 for this impact, is shorter than 0.05, at which the turning
point is known to $2\cdot10^{-7}$ sites and the reflection to $10^{-4}$ units of time; an integrator of the GNU
Scientific Library agrees (`make test T=sec34`). So the errors of this turn are those of the smoothing; the ensemble
below has errors of the step only.

![Error of turning point and reflection against the step, by two schemes.](fig:x73) */
void report_convergence(Report& report) {
  const auto turn_by = [](const EventCorrected& method) {
    return turn_of(run_of({v0_reversed, 1, 1000}, method).path);
  };
  const auto other = [](double step) { return EventCorrected{step, nystrom(blanes_moan_6_14())}; };
  const auto error = [](double of, double from) { return std::abs(of - from); };
  const Turn best = turn_by(other(report.quick ? 0.05 : 0.0125));
  const auto row = [&](double step) -> Row {
    const Turn ours = turn_by(EventCorrected{step}), theirs = turn_by(other(step));
    return {{"step", step},
            {"site", error(ours.apex.site, best.apex.site)},
            {"time", error(ours.rebound.time, best.rebound.time)},
            {"other_site", error(theirs.apex.site, best.apex.site)},
            {"other_time", error(theirs.rebound.time, best.rebound.time)}};
  };
  report.table("convergence").fill(std::array{0.2, 0.1, 0.05, 0.025}, row, "steps");
}

/**
## How long the motion is predictable (figure 22)

We draw impacts at random from an interval around $v_0 = 1.9$ of relative width $10^{-4}$ or $10^{-6}$ and see how the
standard deviation $\sigma_X$ of the centres grows. Centres of smoothed paths are compared; otherwise the phases of the
oscillations would count as a spread.

Up to the first reflection $\sigma_X$ is about proportional to the width of the interval, except for spikes, where the
packets do not all have the same strongest site. It rises and falls as the packet moves, and on the average it grows
like $e^{0.007\,t}$ (grey in figure x51), by a factor of ten in 330 units of time; after the reflection it grows faster.
With $10^{-6}$ the position is known to half a site until [1.29e3 ± 1e1](cell:predictable/noise=1e-6/t), with $10^{-4}$
until [9.7e2 ± 1e1](cell:predictable/noise=1e-4/t), shortly after the reflection. Figure 22 marks the first of these
times; the later part of its map is one possibility among many.

Long after the first reflection the motion is erratic, as the article says. For $t > 1900$ the mean $\sigma_X$ is
[8.9 ± 0.6](cell:predictable/noise=1e-6/late) sites with $10^{-6}$ and [9 ± 3](cell:predictable/noise=1e-4/late) with
$10^{-4}$, and the upper decile of the centres (figure 22) always farther out than the first turning point.

![Spread of the centres against time for two widths of the interval of impacts.](fig:x51) */
constexpr double compared_every = 10, ensemble_step = 0.1;  // of time; a step twice as long too
constexpr double unpredictable = 0.5;  // of a site: the standard deviation from which on it is
constexpr unsigned long seed = 20130501;

/// The centres at one time: mean, standard deviation, lower and upper decile.
struct Spread {
  double t, mean, deviation, low, high;
};

/// The spread of smoothed paths with equal times, at every sample whose number is a multiple of `every`.
std::vector<Spread> spread_of(const std::vector<Path>& smoothed, std::size_t every) {
  const std::size_t members = smoothed.size(), tenth = members / 10;
  std::vector<Spread> out;
  for (std::size_t k = 0; k < smoothed.at(0).size(); k += every) {
    std::vector<double> x;
    double mean = 0, square = 0;
    for (const Path& p : smoothed) {
      x.push_back(p.samples.at(k).centre);
      mean += x.back() / double(members);
    }
    for (double c : x) square += (c - mean) * (c - mean) / double(members - 1);
    std::sort(x.begin(), x.end());
    out.push_back({smoothed[0][k].t, mean, std::sqrt(square), x[tenth], x[members - 1 - tenth]});
  }
  return out;
}

/// The part of it from one time to another.
std::vector<Spread> between(std::vector<Spread> all, double from, double to) {
  std::erase_if(all, [&](const Spread& at) { return at.t < from || at.t > to; });
  return all;
}

/// The first time at which the deviation exceeds `sites`.
double time_to_spread(const std::vector<Spread>& all, double sites) {
  for (const Spread& at : all)
    if (at.deviation > sites) return at.t;
  throw Failure("the packets stay together");
}

/// Smoothed paths of impacts within a fraction `noise` of 1.9, compared.
std::vector<Spread> spread_within(double noise, std::size_t members, double step, double time) {
  Random random(seed);
  std::vector<Experiment> drawn(members, {v0_reversed, 1, time, 240});
  for (Experiment& one : drawn) one.v0 *= 1 + random.uniform(-noise / 2, noise / 2);
  std::vector<Path> paths(members);
  parallel_for(members, [&](std::size_t i) {
    paths[i] = smooth(run_of(drawn[i], EventCorrected{step}).path, path_smoothing);
  });
  return spread_of(paths, std::size_t(std::lround(compared_every / path_sampling)));
}

void report_ensemble(Report& report) {
  Table &table = report.table("ensemble"), &predictable = report.table("predictable");
  table.meta = {{"seed", std::to_string(seed)}};
  const double time = report.quick ? 1600 : 2500;
  const auto mean = [](const std::vector<Spread>& all) {
    double sum = 0;
    for (const Spread& at : all) sum += at.deviation / double(all.size());
    return sum;
  };
  const auto add = [&](double noise, std::size_t members) {
    const TwoRuns<std::vector<Spread>> both{spread_within(noise, members, 2 * ensemble_step, time),
                                            spread_within(noise, members, ensemble_step, time)};
    for (const Spread& at : both.fine)
      table.add({{"noise", noise},
                 {"t", at.t},
                 {"mean", at.mean},
                 {"deviation", at.deviation},
                 {"low", at.low},
                 {"high", at.high}});
    Estimate t = both.of([](const auto& all) { return time_to_spread(all, unpredictable); });
    t.error += compared_every;
    const auto early = [&](const auto& all) { return mean(between(all, 0, 850)); };
    const auto late = [&](const auto& all) { return mean(between(all, time - 600, time)); };
    predictable.add(
        {{"noise", noise}, {"t", t}, {"early", both.of(early)}, {"late", both.of(late)}});
  };
  add(1e-6, report.quick ? 3 : 20);
  if (!report.quick) add(1e-4, 10);
}

/**
A map of snapshots would show spurious stripes, since it would sample the packet's oscillation too rarely.
So figure 22 shows averages over one to five units of time. Of the reflections only the first is measured. */
void report_maps(Report& report) {
  Table& table = report.table("density_maps");
  const auto add = [&](int panel, double v0, double time, double interval, std::size_t sites) {
    std::vector<double> sum(sites, 0.0);
    double samples = 0, until = interval;
    const auto average = [&](const State<double>& now, const std::vector<double>& e) {
      for (std::size_t n = 0; n < sites; ++n) sum[n] += e[n];
      ++samples;
      if (now.t < until - 1e-9) return;
      for (std::size_t n = 0; n < sites; ++n)
        table.add(
            {{"panel", panel}, {"t", until - interval / 2}, {"n", n + 1}, {"e", sum[n] / samples}});
      sum.assign(sites, 0.0);
      samples = 0;
      until += interval;
    };
    run_of({v0, 1, time, 400}, EventCorrected{report.quick ? 0.2 : 0.05}, average);
  };
  add(1, v0_slow, 1000, 4, 110);
  add(2, v0_reversed, 2500, 5, 40);
  add(3, v0_reversed, 900, 1, 28);
}

/**
## The acceleration of a packet

Is the force almost constant? The mass of a packet is unknown, even in sign; so we compare accelerations and not forces.
A parabola, fitted to the smoothed path over 120 units of time around $t$ (a choice that the errors do not contain),
gives the mean acceleration $\ddot X$ (sec34/acceleration.hpp).

![Acceleration of the packet against its position on the way out and back, for three impacts.](fig:x58)

The acceleration depends on more than the position. At $v_0 = 1.9$ the deceleration weakens from the struck end to the
turning point, where for a while the acceleration is even directed outwards. It is weaker on the way back, and so is the
motion itself: at site 15.0 the packet has the velocity [0.063](cell:acceleration/s=1/velocity=1.9/t=130/speed) on the
way out and [-0.044 ± 0.002](cell:acceleration/s=1/velocity=1.9/t=720/speed) on the way back. A particle in a field of
force, constant or not, would have the same speed both times. At $v_0=1.5$ the packet slows down all the way in figure
22, from [0.122](cell:acceleration/s=1/velocity=1.5/t=120/speed) sites per unit of time at $t=120$ to
[0.0651 ± 0.0007](cell:acceleration/s=1/velocity=1.5/t=870/speed) at 870.

To put a number on *almost constant* we compare the acceleration *at the turn*, above nine tenths of the turning point,
with that on the way out, around $t = 160$. At exactly 1.9, where the packet hovers, it is
[-6e-5](cell:turns/s=1/velocity=1.9/at_turn), only [0.14](statement:boomeron.constant_force) of it; at 1.93, which
rounds to 1.9 too, two thirds. In figure 22 the path looks like a parabola, since it is off one by only
[0.060 ± 0.002](cell:turns/s=1/velocity=1.9/parabola) of its range (root mean square). This says little: a wedge, the
path of a particle with no force but at its tip, is off by $(\frac1{12}-\frac5{64})^{1/2} = 0.072$.

Does it grow with $s$ and $v_0$? At $t = 160$, on the way out, its modulus grows from each of nine impacts from 1.1 to 2
to the next, and from each of six wells from $s = 0.005$ to 1; between impacts that are closer it may fall, as by 3 per
cent from 1.91 to 1.92. Earlier, at $t=120$, it falls from
[-0.000238 ± 2e-6](cell:acceleration/s=1/velocity=1.1/t=120/acceleration) at $v_0 = 1.1$ to
[-0.000233](cell:acceleration/s=1/velocity=1.3/t=120/acceleration) at 1.3, and from $s = 0.005$ to 0.05. In linear wells
a packet slows down too, most of all at first: with $v_0 = 1.9$ by
[-0.000175](cell:acceleration/s=0/velocity=1.9/t=120/acceleration) at $t=120$ and
[-8.73e-5 ± 7e-7](cell:acceleration/s=0/velocity=1.9/t=160/acceleration) at 160. */
constexpr double fitted_over = 120, fitted_every = 10, article_end = 1000;  // of time
constexpr double strongest_fitted = 2;                                      // v0

void report_acceleration(Report& report, const std::vector<Packet>& packets) {
  Table& table = report.table("acceleration");
  const double half = fitted_over / 2;
  for (const Packet& packet : packets) {
    if (packet.with.v0 > strongest_fitted) continue;
    double end = std::min(packet.with.time, article_end) - path_smoothing;
    if (packet.turn.return_time.value < end) end = packet.turn.return_time.value - path_smoothing;
    for (double t = half + 2 * fitted_every; t + half < end; t += fitted_every) {
      const auto mean = [&](const Path& p) {
        return fit_parabola(p, t - half, t + half).acceleration;
      };
      const auto velocity = [&](const Path& p) { return velocity_at(p, t); };
      table.add({{"s", packet.with.s},
                 {"velocity", packet.with.v0},
                 {"t", t},
                 {"way", t > packet.turn.apex_time.value ? 2 : 1},
                 {"centre", centre_at(packet.fine, t)},
                 {"acceleration", packet.of(mean)},
                 {"speed", packet.of(velocity)}});
    }
  }
}

/**
## Profiles close to the turning, and the waves behind (figure 23)

At the two times of the article's profiles the packet of 1.87 is close to turning in place: at $t = 238$ its centre is
[2.5](cell:close_to_turning/t=238/distance) sites from the turning point, less than half the width of the packet. It is
not close in time. It still moves with [0.031](cell:close_to_turning/t=238/speed) sites per unit of time, less than a
quarter of the speed with which it left the end ([0.13](cell:close_to_turning/t=238/first_speed)), and of eleven impacts
from 1.865 to 1.875, which round to the printed one, none stops before
[3.2e2](cell:turns/s=1/velocity=1.875/stop_time).

![Velocities close to the turning.](fig:23)

Why does a packet turn? The article guesses that it is the waves which are confined between the packet and the end. They
are there: behind the packet beads move with up to [0.27](cell:turning_profiles/t=238/n=15/v), a third of the packet's
largest velocity; a few sites ahead of it all are at rest. If they caused the turn, a packet without them would go on.
Volume two (`sec34_why_packets_turn`) takes them away. Those more than eight sites behind are not missed if they are
wiped out once: nine of nine impacts about 1.9 return. If the first bead is damped none of the nine is back by $t =
1200$, and two to five are if the packet is moved to a chain at rest. So the end helps it back, as the guess says; its
slowing down is accounted for by the slow waves that it sheds, wherever these go.*/
void report_profiles(Report& report) {
  const Packet whole = packet_of({v0_fig23}, finer_step({v0_fig23}, report));
  Table &profiles = report.table("turning_profiles"), &near = report.table("close_to_turning");
  for (double time : {238.0, 241.0}) {
    const Experiment until{v0_fig23, 1, time};
    const auto runs = two_runs(until, finer_step(until, report));
    for (std::size_t n = 0; n < 40; ++n) {
      const Estimate v = runs.of([n](const ImpactRun& run) { return run.end.v[n]; });
      profiles.add({{"t", time}, {"n", n + 1}, {"v", v}});
    }
    const auto distance = [time](const Path& p) {
      return find_turn(p).apex.site - centre_at(p, time);
    };
    const auto now = [time](const Path& p) { return velocity_at(p, time); };
    const auto first = [](const Path& p) { return velocity_at(p, 20); };
    near.add({{"t", time},
              {"distance", whole.of(distance)},
              {"speed", whole.of(now)},
              {"first_speed", whole.of(first)}});
  }
}

/**
## Weakly hard wells, $s = 0.005$

The article sees reversals for $s\ge0.005$ and none for $s=0$, and prints neither an impact nor a time. With the impacts
of the figures $\chi$ is a hundredth at $s=0.005$, and the packet of 1.9 is almost where it is in linear wells; after
132 one turns. All our packets with $\chi$ above 2.5 turn, within 700 units of time. Below, that of 1.5 at $s=1$ turns
at $4.4\cdot10^3$, and the others of the table do not as long as we follow them; 1.6 to 1.8 at $s=1$, with $\chi$ from
2.0 to 2.4, are followed until 300 only. So no threshold can be read off, and weaker packets may turn farther out.

| | $\chi$ | followed until | turning point, site | centre 15 before, site |
|---|---|---|---|---|
| $s=0.005$, $v_0=132$ | 7.6 | 400 | [26.8](cell:turns/velocity=132/apex_site) | |
| $s=1$, $v_0=1.9$ | 2.6 | 1200 | [20.1](cell:turns/velocity=1.9/apex_site) | |
| $s=0.005$, $v_0=60$ | 2.3 | 800 | none | [401.1](cell:onward/s=0.005/velocity=60/centre) |
| $s=1$, $v_0=1.5$ | 1.8 | 5500 | [183](cell:turns/velocity=1.5/apex_site) | |
| $s=0.005$, $v_0=1.9$ | 0.013 | 2500 | none | [563.7](cell:onward/s=0.005/velocity=1.9/centre) |
| $s=0$, $v_0=1.9$ | 0 | 2500 | none | [564.0](cell:onward/s=0/velocity=1.9/centre) |
| $s=0$, $v_0=132$ | 0 | 450 | none | [427.2](cell:onward/s=0/velocity=132/centre) | */
void report_onward(Report& report, const std::vector<Packet>& packets) {
  Table& table = report.table("onward");
  const auto fallen_back = [](const Path& p) {
    double farthest = 0, back = 0;
    for (const PathSample& at : p) {
      farthest = std::max(farthest, at.centre);
      back = std::max(back, farthest - at.centre);
    }
    return back;
  };
  for (const Packet& packet : packets) {
    if (packet.turns() || packet.with.time <= way_out) continue;
    const double end = packet.with.time - path_smoothing;
    const auto centre = [&](const Path& p) { return centre_at(p, end); };
    table.add({{"s", packet.with.s},
               {"velocity", packet.with.v0},
               {"until", packet.with.time},
               {"centre", packet.of(centre)},
               {"fallen_back", packet.of(fallen_back)}});
  }
}

void reproduce(Report& report) {
  std::vector<Experiment> all = experiments();
  if (report.quick) all = {all.begin() + 1, all.begin() + 8};
  std::vector<Packet> packets(all.size());
  parallel_for("packets", all.size(),
               [&](std::size_t i) { packets[i] = packet_of(all[i], finer_step(all[i], report)); });
  report_turns(report, packets);
  report_convergence(report);
  report_ensemble(report);
  report_maps(report);
  report_acceleration(report, packets);
  report_profiles(report);
  report_onward(report, packets);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `boomeron.reversal`: s = 1 and v_0 = 1.9: deceleration; reversal; return; rebound | reverses | turns.out_again (s = 1, velocity = 1.9), turns.return_site (s = 1, velocity = 1.9): 4.404 < 7.48 (the closest of 5) | holds |
| `boomeron.moderate`: s = 1 and v_0 = 1.5 decelerates slowly | slow | acceleration.speed (s = 1, velocity = 1.5, t = 620), (s = 1, velocity = 1.5, t = 870): 0.06514 < 0.07818 (the closest of 11) | holds, assuming |
| `boomeron.turning_time`: close to direction reversal at v_0 = 1.87 | close at 238 and 241 | close_to_turning.distance (t = 238): 2.459 < 3.5; close_to_turning.distance (t = 241): 2.362 < 3.5 | holds, assuming |
| `boomeron.waves`: nonlinear waves are confined between the packet and the boundary | visible | turning_profiles.v (t = 238, n = 1) and 39 other values: 0.04543 < 0.2728 (the closest of 4) | holds |
| `boomeron.any_s`: reversal takes place for s >= 0.005 and not for s = 0 | s >= 0.005 | turns.apex_site (s = 0.5), turns.return_site (s = 0.5): 6.692 < 12.88 (the closest of 6) | holds, assuming |
| `boomeron.erratic`: after some rebounds the motion is trapped or erratic | erratic | predictable.early (noise = 1e-06): 0.0002124 < 0.25; predictable.late (noise = 1e-06): 3 < 8.905 | holds |
| `boomeron.constant_force`: during a few rebounds the centre moves like a particle in an almost constant force field | almost constant | 0.139 | quantified |
| `boomeron.force_grows`: the effective force increases with s and with the impact velocity | increases | acceleration.acceleration (s = 1, velocity = 1.1, t = 160), (s = 1, velocity = 1.3, t = 160): 0.0001454 < 0.0001493 (the closest of 13) | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** Another impact is a line of `experiments`; the program sorts it into `turns` or, if it does not come
back by five sites within a `time` above `way_out`, into `onward` (as 2.5 at $s=1$, which stays near the struck end),
and up to `strongest_fitted` also into `acceleration`. If its chain is so short that the packet or the waves cross it,
the program says so. The statements need the article's impacts. What counts as a turn are the constants of `find_turn`,
the smoothing is `path_smoothing` (turning.hpp).

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
