/**
# 3.4 Why packets turn round

James, Kevrekidis and Cuevas (Physica D 251, 2013) leave open why packets turn round in the hard wells of section 3.4.
They name one possibility: waves confined between the packet and the end that was hit. We test it with experiments that
could refute it.

     waves     |~~~~~~~~~~~~~~~ (packet)              does it turn?
     behind    |xxxxxxxx<- d -> (packet)              with waves up to d sites behind it only?
     end       |x~~~~~~~~~~~~~~ (packet)              with waves that hardly return from the end?
     cut                        (packet)              alone on a chain at rest?
     beside              (breather) ~~~~~~            at rest, waves beside it: does it move?

One thing is puzzling. Beads only push, so anything that comes from behind pushes the packet forward. If this turns the
packet back, the packet has a negative effective mass: pushed forward, it slows down. A slow breather of section 3.3 is
such a body (`sec33_mobility`), and we find that this packet behaves like one.

![Experiments on the packet that turns.](fig:x12) */

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/at_rest.hpp"
#include "sec34/beside.hpp"
#include "sec34/wake.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the chapter `sec34_boomeron`, Eqs. (9), (10) and (26),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2} - \nu_n\dot y_n,
  \qquad \dot y_n(0) = v_0\,\delta_{n,1},$$
with a damping $\nu_n$ that is zero except where we absorb waves: it is 0.1 on all sites more than $d$ behind the
packet, or 0.2 on the first site alone. A *cut* isolates the packet: its own thirteen sites at a given time,
displacements and velocities unchanged, are put on a long chain that is otherwise at rest (wake.hpp). Every run is made
with two steps, on a chain so long that no wave comes back from its ends, which is checked.

As in that chapter $X$ is the energy centre of the strongest packet, Eq. (24), averaged over four internal periods. The
packet has *returned* when $X$ has come back by five sites; one that is trapped between two sites swings by less than
one.

| article | program | meaning |
|---|---|---|
| $s$, $v_0$ | `s`, `velocity` | the well and the impact, 1 and 1.9 if nothing else is said |
| $X$ | `Path::centre` | energy centre |
| – | `behind` | the distance $d$, 0: nothing is absorbed | */
constexpr double hard = 1, velocity = 1.9, long_time = 1e4;
constexpr std::size_t length = 800;  // of the chain

/// Two steps of one experiment, and what became of the packet.
struct WakeExperiment {
  std::string name;
  WavesRemoved impact;
  double until;
  std::array<LateFate, 2> fate{};
  Path path{};
};

/// A count is exact if two steps agree on it.
Estimate counted(double coarse, double fine) {
  return coarse == fine ? exact(fine) : compare(coarse, fine);
}

/**
## Do waves turn the packet?

Seven experiments are made at $v_0 = 1.9$: the undisturbed impact, the two absorbers, and cuts at four times. Only a
long run can show that a packet does *not* return. Absorbing behind the packet keeps the moving part of the chain short,
so this run goes to $t = 10^4$; the waves of an isolated packet spread over hundreds of sites, and those runs end
at 4000. */
std::vector<WakeExperiment> wake_experiments(bool quick) {
  std::vector<WakeExperiment> list{{"waves", {}, 1000},
                                   {"behind", {.behind = 6}, long_time},
                                   {"end", {.first_bead = true}, 4000}};
  for (int t : {60, 120, 200, 300})
    list.push_back({"cut" + std::to_string(t), {.cut = double(t)}, 4000});
  for (WakeExperiment& e : list) e.until = quick ? 600 : e.until;
  return list;
}

/**
With all its waves the packet returns, after its turning point at site [20.0](num:sec34_boomeron_why.furthest_waves). An
end that reflects hardly any wave only moves this point to site [33.3](num:sec34_boomeron_why.furthest_end). With the
waves absorbed more than six sites behind it, the packet has not returned by $t = 10^4$ (nor by $10^5$, run once). This
is true of most but not of all packets of such impacts: of eighty neighbours within half a per cent of this impact four
return by $10^4$ in another program, from beyond site 58. Isolated at $t = 120$ on a chain at rest, the packet still
returns, but long afterwards; with its waves it turns much earlier.

With either step the same packets return: those with all waves, with the absorbing end, and isolated at $t = 120$
and 200. Those with the waves absorbed behind them and those isolated at $t = 60$ and 300 do not, by the end of their
runs. We see no order in the four cuts: the fate of a packet that drifts slowly seems a matter of chance. Had the two
steps disagreed on a packet, we could only say that its motion is chaotic by then. */
void report_experiments(Report& report) {
  std::vector<WakeExperiment> list = wake_experiments(report.quick);
  parallel_for("experiments", 2 * list.size(), [&](std::size_t i) {
    WakeExperiment& e = list[i / 2];
    e.fate[i % 2] =
        late_fate(e.impact, i % 2 ? 0.05 : 0.1, e.until, length, i % 2 ? &e.path : nullptr);
  });

  // What became of each packet, from both steps
  for (const WakeExperiment& e : list) {
    const auto& [coarse, fine] = e.fate;
    const auto back = [](const LateFate& f) { return f.late == Late::returns ? 1.0 : 0.0; };
    report.facts.add("returned_" + e.name, counted(back(coarse), back(fine)), "1 if it came back");
    report.facts.add("furthest_" + e.name, compare(coarse.furthest, fine.furthest), "site");
    const Estimate when = compare(coarse.when, fine.when);
    report.facts.add("when_" + e.name, {when.value, when.error + path_smoothing / 2});
  }

  // The ways, smoothed; after a cut only from the cut on
  Table& tracks =
      report.table("experiments",
                   {count("experiment",
                          "0: all waves kept, 1: absorbed behind the packet, 2: absorbed at the "
                          "struck end, then waves removed at t = 60, 120, 200, 300"),
                    number("t", "time"), number("centre", "centre of the packet, smoothed", "site"),
                    number("energy", "energy of the packet, smoothed")});
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Path p = smooth(list[k].path, path_smoothing);
    for (std::size_t i = 0; i < p.t.size() && p.t[i] < 4000; i += 100)
      if (p.t[i] > list[k].impact.cut) tracks.add({k, p.t[i], p.centre[i], p.energy[i]});
  }
}

/**
## Which waves slow it down?

The acceleration $\ddot X$ on the way out, between $t = 100$ and 220, is the slope of a line through the velocities
(sec34/acceleration.hpp); it is negative where the packet slows down. If waves act from afar, its modulus should grow
with the distance $d$ up to which they are left; if it is the packet's own fresh wake that acts, it should grow in the
same way after a cut. The linear well, in which we saw no packet turn, is the control. */
struct WakeAcceleration {
  double s, cut;
  std::size_t behind;
  Estimate mean{};
};

Estimate packet_acceleration(const WavesRemoved& impact, double step, double from, double to) {
  const Path p = smooth(follow_without(impact, step, 240, 150), path_smoothing);
  const double look = p.t[1] - p.t[0];
  const auto half = std::size_t(std::lround(5 / look));
  const auto at = [&](double t) {
    return std::size_t(std::upper_bound(p.t.begin(), p.t.end(), t) - p.t.begin());
  };
  const auto [t, v] = velocities(p, (at(from) + half - 1) / half * half, at(to) + half, look);
  return fit_line(t, v).estimate();
}

/**
After the impact the acceleration is [-0.000186](num:sec34_boomeron_why.force_waves_5) if only waves up to five sites
behind the packet are left, and [-0.00044](num:sec34_boomeron_why.force_waves_15) with fifteen; what lies further behind
adds no more than the errors after this impact and until $t = 220$. The waves between the fifth and the fifteenth site
thus more than double it. They are those that the impact has launched along with the packet: after a cut at $t = 60$ it
is [-0.000192](num:sec34_boomeron_why.force_cut_15) with all of the fresh wake and
[-0.000191](num:sec34_boomeron_why.force_cut_5) with five sites of it. In the linear well it does not matter what is
left: [-9.0e-5](num:sec34_boomeron_why.force_linear_15) and [-8.9e-5](num:sec34_boomeron_why.force_linear_5). */
void report_distance(Report& report) {
  std::vector<WakeAcceleration> list;
  for (double s : {hard, 0.0})
    for (double cut : {0.0, 60.0})
      for (std::size_t d : {4, 5, 6, 7, 8, 10, 12, 15, 20, 0}) list.push_back({s, cut, d});
  const double step = report.quick ? 0.2 : 0.1, from = 100, to = 220;

  // The error is that of the fit and of the step
  const auto row = [&](WakeAcceleration& p) {
    const WavesRemoved impact{p.s, velocity, p.cut, p.behind};
    p.mean = compare(packet_acceleration(impact, step, from, to),
                     packet_acceleration(impact, step / 2, from, to));
    return Cells{p.s, p.cut, p.behind, p.mean.value, p.mean.error};
  };
  report
      .table("force_against_distance",
             {number("s", "anharmonicity"),
              number("cut", "time at which the waves are removed; 0: never"),
              count("behind", "waves are kept up to this many sites behind the packet; 0: all",
                    "site"),
              number("force", "acceleration of the centre", "site per squared unit of time"),
              number("force_uncertainty", "from the fit and the time step",
                     "site per squared unit of time")})
      .fill(list, row, "distances");
  for (const WakeAcceleration& p : list) {
    const std::string name = p.s == 0 ? "linear" : p.cut > 0 ? "cut" : "waves";
    if ((p.behind == 5 || p.behind == 15) && (p.s > 0 || p.cut == 0))
      report.facts.add("force_" + name + "_" + std::to_string(p.behind), p.mean,
                       "site per squared unit of time");
  }
}

/**
## A negative effective mass

Where do energy and momentum go between $t=100$ and 220? The momentum of the packet's eleven sites is changed by the
push $F$ of the contact behind them, by that of the contact ahead, and by the wells. These are true forces, unlike the
acceleration of the centre. With its waves the packet is pushed forward, *away* from them, by a mean force $F =$
[0.0113](num:sec34_boomeron_why.push_waves), and by [0.00498](num:sec34_boomeron_why.push_behind) if those beyond six
sites are absorbed; the wells take up the momentum. So the packet that is pushed forward more slows down more, like a
body of negative effective mass.

With its waves it also does not lose the energy that it radiates without them: with them its energy changes by
[0.00821](num:sec34_boomeron_why.gain_waves), and with those beyond six sites absorbed by
[-0.0556](num:sec34_boomeron_why.gain_behind). In the linear well it is [-0.0664](num:sec34_boomeron_why.gain_linear)
with the waves and [-0.0662](num:sec34_boomeron_why.gain_linear_behind) without: there they matter little. */
void report_budgets(Report& report) {
  struct Case {
    std::string name;
    WavesRemoved impact;
  };
  const std::vector<Case> cases{{"waves", {hard, velocity}},
                                {"behind", {hard, velocity, 0, 6}},
                                {"linear", {0, velocity}},
                                {"linear_behind", {0, velocity, 0, 6}}};
  const double step = report.quick ? 0.1 : 0.05;
  std::vector<Budget> coarse(cases.size()), fine(cases.size());
  parallel_for(cases.size(), [&](std::size_t k) {
    coarse[k] = budget(cases[k].impact, step, 100, 220);
    fine[k] = budget(cases[k].impact, step / 2, 100, 220);
  });
  Table& table = report.table(
      "budgets",
      {number("s", "anharmonicity"),
       count("behind", "waves are kept up to this many sites behind the packet; 0: all", "site"),
       number("packet", "change of the packet's energy"),
       number("near", "change of the energy up to 15 sites behind the packet's centre"),
       number("far", "change of the energy farther behind"),
       number("friction", "energy dissipated by the absorbing layer"),
       number("push_behind", "mean force of the contact behind the packet"),
       number("push_ahead", "mean force of the contact ahead of it"),
       number("wells", "mean force of its wells, backwards")});
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Budget& b = fine[k];
    table.add({cases[k].impact.s, cases[k].impact.behind, b.packet, b.near, b.far, b.friction,
               b.push_behind, b.push_ahead, b.wells});
    const auto both = [&](double Budget::*of) { return compare(coarse[k].*of, fine[k].*of); };
    report.facts.add("gain_" + cases[k].name, both(&Budget::packet),
                     "change of the packet's energy");
    report.facts.add("push_" + cases[k].name, both(&Budget::push_behind), "mean force");
  }
}

/**
## The fate of the packet

A smaller deceleration may still turn a packet, only later. So packets of five impacts around $v_0 = 1.9$ are followed
until they have returned, or to $t = 10^4$, with waves left up to different distances, with and without a cut. Long runs
are chaotic and no single one is conclusive, so we show both steps and count.

Of the five packets [4](num:sec34_boomeron_why.of_five_return_waves_15) return if the waves up to fifteen sites behind
them are left, [3](num:sec34_boomeron_why.of_five_return_waves_10) with ten sites,
[0](num:sec34_boomeron_why.of_five_return_waves_8) with eight and [1](num:sec34_boomeron_why.of_five_return_waves_6)
with six; the others go on or are trapped. If they are isolated at $t = 60$,
[1](num:sec34_boomeron_why.of_five_return_cut_30) of five returns with thirty sites of the fresh wake, and
[0](num:sec34_boomeron_why.of_five_return_cut_6) with six. An error of one means that the steps disagree on one packet.
In these trials the distance mainly decides how far a packet that was not isolated gets by the end of its run: with
fifteen sites none of the five passes site 40, with six all pass site 50. */
struct Packet {
  WavesRemoved impact;
  std::array<LateFate, 2> fate{};

  void follow(double until, double step) {
    for (int k : {0, 1}) fate[k] = late_fate(impact, k ? step : 2 * step, until, length);
  }
  /// A row: which packet it is, and what becomes of it.
  Cells row(Cells which) const {
    const Cells what{impact.behind, fate[1].late, fate[0].late, fate[1].furthest, fate[1].when};
    which.insert(which.end(), what.begin(), what.end());
    return which;
  }
};

Columns with_fates(const Columns& which) {
  return {which,
          count("behind", "waves are kept up to this many sites behind the packet; 0: all", "site"),
          count("fate", "0 goes on, 1 returns, 2 trapped"),
          count("fate_coarse", "fate with twice the time step"),
          number("furthest", "farthest mean centre by the end of the run", "site"),
          number("when", "time at which it is reached")};
}

void report_late_fates(Report& report) {
  std::vector<Packet> list;
  for (const auto& [cut, distances] :
       {std::pair<double, std::vector<std::size_t>>{0, {6, 8, 10, 15}}, {60, {6, 30}}})
    for (std::size_t d : distances)
      for (double v : {1.8, 1.84, 1.88, 1.92, 1.96}) list.push_back({{hard, v, cut, d}});
  const double until = report.quick ? 500 : long_time, step = report.quick ? 0.2 : 0.1;

  const auto row = [&](Packet& p) {
    p.follow(until, step);
    return p.row({p.impact.velocity, p.impact.cut});
  };
  report
      .table("late_fates",
             with_fates({number("velocity", "impact velocity"),
                         number("cut", "time at which the waves are removed; 0: never")}))
      .fill(list, row, "packets");

  // How many of five return, for each distance
  for (std::size_t i = 0; i < list.size(); i += 5) {
    double back[2] = {};
    for (std::size_t k = i; k < i + 5; ++k)
      for (int f : {0, 1}) back[f] += list[k].fate[f].late == Late::returns;
    const WavesRemoved& impact = list[i].impact;
    const std::string name = (impact.cut > 0 ? "cut_" : "waves_") + std::to_string(impact.behind);
    report.facts.add("of_five_return_" + name, counted(back[0], back[1]), "packets");
  }
}

/**
## How far behind the waves may be

So far we used one well. Do fifteen sites suffice in others, and at other velocities? Four packets that turn, between
sites 20 and 80, are followed to $t = 4000$, with all waves and with those up to a distance $d$ behind them. The table
has the furthest site by then.

| $s$, $v_0$ | all waves | $d = 30$ | $20$ | $15$ | $6$ |
|---|---|---|---|---|---|
| 1, 1.9 | [20.0468 ± 0.0006](num:sec34_boomeron_why.apex_10_19_all) | [20.0468 ± 0.0006](num:sec34_boomeron_why.apex_10_19_30) | [20.0468 ± 0.0006](num:sec34_boomeron_why.apex_10_19_20) | [20.12 ± 0.04](num:sec34_boomeron_why.apex_10_19_15) | [87 ± 2](num:sec34_boomeron_why.apex_10_19_6) |
| 0.8, 2.2 | [26.1075 ± 3e-6](num:sec34_boomeron_why.apex_08_22_all) | [26.1075 ± 3e-6](num:sec34_boomeron_why.apex_08_22_30) | [26.1258 ± 8e-5](num:sec34_boomeron_why.apex_08_22_20) | [27.1809 ± 0.0006](num:sec34_boomeron_why.apex_08_22_15) | [117 ± 1](num:sec34_boomeron_why.apex_08_22_6) |
| 1, 1.7 | [54.2 ± 0.2](num:sec34_boomeron_why.apex_10_17_all) | [55.30 ± 0.03](num:sec34_boomeron_why.apex_10_17_30) | [63.123 ± 0.002](num:sec34_boomeron_why.apex_10_17_20) | [64.3195 ± 0.0008](num:sec34_boomeron_why.apex_10_17_15) | [191.102 ± 0.0001](num:sec34_boomeron_why.apex_10_17_6) |
| 0.6, 2.5 | [77.3 ± 0.9](num:sec34_boomeron_why.apex_06_25_all) | [75.10 ± 0.02](num:sec34_boomeron_why.apex_06_25_30) | [84.241 ± 0.002](num:sec34_boomeron_why.apex_06_25_20) | [128.34 ± 0.02](num:sec34_boomeron_why.apex_06_25_15) | [227.63 ± 0.01](num:sec34_boomeron_why.apex_06_25_6) |

With fifteen sites the turning point moves the more, the farther out it is; the first packet is then trapped where it
would have turned, and the last is still on its way out. With six sites none returns in that time. (At $v_0 = 1.7$ with
all waves only the finer of two steps has the packet back by $t = 4000$.)

At $s = 0.6$, $v_0 = 1.9$ the packet has not turned by $t = 4000$, and until then the waves make no difference: with all
of them and with six sites of them it is at the same place, within [0.017](num:sec34_boomeron_why.apart_without_turn)
sites. Later they do: followed once to $t = 20000$ it is beyond site 1100 with all waves, and beyond site 1400 with six
sites. */
void report_range(Report& report) {
  std::vector<Packet> list;
  for (const auto& [s, velocity] : {std::pair{1.0, 1.9}, {0.8, 2.2}, {1.0, 1.7}, {0.6, 2.5}})
    for (std::size_t d : {0, 6, 15, 20, 30}) list.push_back({{s, velocity, 0, d}});
  for (std::size_t d : {0, 6}) list.push_back({{0.6, 1.9, 0, d}});
  const double until = report.quick ? 300 : 4000, step = report.quick ? 0.2 : 0.1;
  const auto row = [&](Packet& p) {
    p.follow(until, step);
    return p.row({p.impact.s, p.impact.velocity});
  };
  report
      .table("range_of_waves",
             with_fates({number("s", "anharmonicity"), number("velocity", "impact velocity")}))
      .fill(list, row, "wells");

  // The furthest place of each packet, and how far apart those are that do not turn
  const auto tenths = [](double x) { return (x < 1 ? "_0" : "_") + short_text(10 * x); };
  for (const Packet& p : list)
    report.facts.add("apex" + tenths(p.impact.s) + tenths(p.impact.velocity) + "_" +
                         (p.impact.behind ? std::to_string(p.impact.behind) : "all"),
                     compare(p.fate[0].furthest, p.fate[1].furthest), "site");
  const auto &all = list[list.size() - 2].fate, &six = list.back().fate;
  report.facts.add("apart_without_turn",
                   compare(std::abs(all[0].furthest - six[0].furthest),
                           std::abs(all[1].furthest - six[1].furthest)),
                   "site");
}

/**
## Inside the packet

What kind of body do the waves turn? If the packet is a moving breather, its frequency $\omega$, energy and area in
phase space, $\int \sum \dot y_n^2\,dt$ over one internal period ($2\pi$ times its action), should be related as in
breathers at rest with the same $s$. We average them over the way from $t = 100$, when the packet has left the end, to
300, before it turns (wake.hpp), and compare with the breather of the same mean frequency, which Newton's method finds
(sec34/at_rest.hpp).

The packet is close to a moving breather: at its frequency, [1.68](num:sec34_boomeron_why.omega_waves), its area is
[5.99](num:sec34_boomeron_why.area_waves) and that of a breather at rest
[5.83](num:sec34_boomeron_why.area_at_rest_waves). With the waves its energy is
[1.49](num:sec34_boomeron_why.energy_waves), without them [1.37](num:sec34_boomeron_why.energy_behind), so they do feed
it. The lattice itself could stop a packet: its barrier is $E_{\rm site}-E_{\rm bond}$ at equal area (chapter 3.2),
[0.00040](num:sec34_boomeron_why.barrier_waves), which can trap a slow packet, as we see after late cuts; close to it
chance decides which way a slow packet goes. But the force that belongs to it has both signs within one site, and can by
itself neither slow a packet over many sites nor speed up its return. */
void report_inside(Report& report) {
  // The packet with all its waves and with those behind it absorbed, at two steps each
  const double step = report.quick ? 0.1 : 0.05;
  const WavesRemoved impacts[] = {{hard, velocity}, {hard, velocity, 0, 6}};
  std::vector<Inside> rows[4];
  parallel_for(
      4, [&](std::size_t i) { rows[i] = gauge(impacts[i / 2], i % 2 ? step / 2 : step, 420); });
  Table& along = report.table(
      "packet_inside",
      {count("experiment", "0: all waves kept, 1: absorbed behind the packet"), number("t", "time"),
       number("centre", "centre of the packet", "site"), number("energy", "energy of the packet"),
       number("area", "area of the packet (2 pi times the action)"),
       number("omega", "frequency of the packet")});
  for (int k : {0, 1})
    for (const Inside& r : rows[2 * k + 1]) along.add({k, r.t, r.site, r.energy, r.area, r.omega});

  // The breathers at rest
  const BreathersAtRest f = breathers_at_rest(hard);
  Table& rest = report.table(
      "breathers_at_rest",
      {number("omega", "frequency"), number("energy_bond", "energy of the bond-centred breather"),
       number("energy_site", "energy of the site-centred breather"),
       number("area_bond", "area of the bond-centred breather (2 pi times the action)"),
       number("area_site", "area of the site-centred breather (2 pi times the action)"),
       number("barrier", "E_site - E_bond at equal area (2 pi times the action)")});
  for (std::size_t k = 0; k < f.gap.size(); ++k)
    rest.add({f.bond[k].omega, f.bond[k].energy, f.site[k].energy, f.bond[k].area, f.site[k].area,
              f.gap[k]});
  compare_inside(report.facts, "_waves", f, rows[0], rows[1]);
  compare_inside(report.facts, "_behind", f, rows[2], rows[3]);
}

/**
## Waves beside a breather at rest

The last experiment reverses the first: instead of taking the waves away from a packet that turns, we give waves to a
breather at rest. On one side of a bond-centred breather, from its sixth neighbour on, we set fifteen sites oscillating
with the amplitude 0.15 and phases drawn at random from a recorded seed (sec34/beside.hpp). If waves pull, the breather
moves towards them on whichever side they are; if they push, it moves away. The linear well serves as the control, with
the same waves and a breather of the same energy.

The outcome of a single draw depends much on chance, so there are many draws, and each is used four times: in both wells
and, mirrored, on both sides. The result for a well is the mean displacement towards the waves. The two sides of one
draw share their phases and are not independent, so the standard error is that of the draws, each the mean of its two
sides.

[](finding:turning.pull) */
void report_waves(Report& report) {
  std::vector<ExposedBreather> list = exposed_breathers(report.quick ? 3 : 12);
  const double step = report.quick ? 0.2 : 0.1;
  const auto resting = [](double omega, double well, int coarser) {
    return find_breather(problem_of(Centre::bond, omega, well), Phase::compressed,
                         rule<double>(coarser));
  };
  const Orbit<double> hard = resting(1.68, 1, 0), linear = resting(1.6045, 0, 0);
  parallel_for(2 * list.size(), [&](std::size_t i) {
    ExposedBreather& t = list[i / 2];
    (i % 2 ? t.path : t.coarse) = expose(t, t.well > 0 ? hard : linear, i % 2 ? step / 2 : step);
  });

  // Every trial, so that one sees how much they scatter
  Table& table = report.table(
      "waves_beside", {number("s", "anharmonicity of the well"),
                       count("side", "-1: waves on the left, 1: on the right"),
                       count("trial", "number of the random draw"), number("t", "time"),
                       number("displacement", "displacement of the centre, smoothed", "site")});
  table.meta = {{"seed", std::to_string(phase_seed)}};
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Path p = smooth(list[k].path, path_smoothing);
    for (std::size_t i = 0; i < p.t.size(); i += 25)
      table.add({list[k].well, list[k].side, k / 4, p.t[i], p.centre[i] - p.centre[0]});
  }
  for (double well : {1.0, 0.0}) add_pull(report.facts, list, well);
  report.facts.add("energy_beside_hard", compare(resting(1.68, 1, 1).energy, hard.energy));
  report.facts.add("energy_beside_linear", compare(resting(1.6045, 0, 1).energy, linear.energy));
}

/**
## Conclusion and limits

**Waves close behind a packet turn it early.** [](finding:turning.waves) At $s = 1$, $v_0 = 1.9$ these waves come
from the impact. So the possibility that the article names, that other waves turn the packet, is supported, but they
need not be confined: an end that absorbs them only moves the turning point.

**A part of the slowing down needs no waves beyond the fifth site behind the packet.** At $s = 1$, $v_0 = 1.9$ an
isolated packet that meets only its own fresh wake slows down about as much as one that keeps five sites of the waves of
the impact, however much of the fresh wake is left; and as it goes on, it slows down less and less.

**Neither waves nor the end are necessary for an eventual return.** [](finding:turning.alone) Others that are isolated
early go on or are trapped; of six within a millionth of this impact, tried once, four return by $t = 4000$.

*Not shown*: why waves pull. The packet is pushed forward and slows down; that neighbours in it oscillate in opposite
phase (figure 23), as at the upper edge of a band, while the waves behind are long and in phase, fits a negative mass
but does not prove it. Nor do we know why the breather of the linear well hardly responds to waves beside it, nor what
slows the packet down without waves: it radiates energy, but in the linear well it radiates as much. Damping so close to
the packet may affect the packet itself. "Returns" and "goes on" refer to the times that we followed. */
void reproduce(Report& report) {
  report_experiments(report);
  report_distance(report);
  report_late_fates(report);
  report_range(report);
  report_budgets(report);
  report_inside(report);
  report_waves(report);
}

/**
## Try it

1. *Easy.* Is the packet a moving breather? One at rest with its frequency: `build/bin/sec32_newton_breathers
   breather --omega 1.68362 --s 1 --centre bond` gives `energy` = 1.44065 and `area` = 5.8312. Hint: the packet has
   1.487 and 5.99, a few per cent more.
2. *Easy.* Could the lattice trap it? `build/bin/sec32_barrier barrier --omega 1.68 --s 1` gives `equal_area` =
   3.56415e-4. Hint: on its way from $t = 100$ to 220 the packet with its waves gains more than twenty times as much,
   and without those beyond six sites it loses more than a hundred times as much.
3. *Harder.* And in the linear well? `build/bin/sec32_barrier barrier --omega 1.68 --s 0` gives
   `equal_area` = -2.2978e-9, a hundred thousand times less and of the other sign. Hint: it tells which of the two breathers has more energy, and at a negative mass the stable one is that of *higher* energy (`sec33_mobility`).
4. *Open.* By which law does the pull depend on amplitude and frequency of the waves? Does a frequency below 1.4 push?
5. *Open.* Measure the mass of both breathers by kicking them, and compare the ratio with that of the pulls. Does a
   packet also turn when waves come towards it? */
int main(int argc, char** argv) {
  return run(
      {"sec34_boomeron_why", "3.4", "Why packets turn round (section 3.4, s > 0)", reproduce}, argc,
      argv);
}
