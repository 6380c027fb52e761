/**
# 3.6 Scattering of a breather by a defect in an array of cantilevers

How does a defect scatter a travelling breather, in a system that one can build? Section 3.6 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) proposes an array of stiff beams, clamped at both ends, with a bead on either side of each.
We simulate an impact on it, and compute how much energy a beam with larger or smaller beads reflects, transmits and
traps.

       V      n = 1   2   3          99   100  101
      --->       o|o o|o o|o   ...   o|o  O|O  o|o   ...     two beads on each, which touch their neighbours
                  |   |   |           |    |    |
               ===+===+===+===========+====+====+===         clamped at both ends

An impact on the first beam launches a travelling breather. According to the article a beam with larger beads reflects
it almost totally at 1.6 radii, transmits a part at 1.1, and leaves a small part of its energy loosely trapped. We
quantify these statements, and then what an experiment would see in metres, newtons and milliseconds. Why these arrays
and not Newton's cradle, `sec35_scales` says.

![Contact forces after an impact, with larger beads at n = 100. Drawn by fig24_defect.py: `force` over `n` and `t`,
from `contact_forces`.](fig:24)

## Model

A beam with its two beads has one degree of freedom, the deflection $x_n$ of its middle. It is a mass $m_n$ on a
spring, and neighbouring beads push on each other by Hertz's law. The unit of length is $\xi$, at which spring and
contact are equally strong, that of time $\tau_c$, the free period over $2\pi$. The array then obeys Eq. (32),
$$\mu_n\,\ddot y_n + y_n = -\eta_n\,(y_n-y_{n+1})_+^{3/2} + \eta_{n-1}\,(y_{n-1}-y_n)_+^{3/2},
  \qquad \dot y_n(0) = \lambda^{5/2}\,\delta_{n,1},$$
with free ends. At the defect, $n = 100$, the beads have $\tilde R$ times the radius of the others. It is heavier,
$\mu = (m_{\rm beam} + 2\tilde R^3 m_{\rm bead})/(m_{\rm beam} + 2m_{\rm bead})$, and its two contacts are stiffer,
$\eta = [2\tilde R/(1+\tilde R)]^{1/2}$; elsewhere both are one. The impact $V$ in m/s enters only through $\lambda$,
Eqs. (28) to (30), which is 0.29 at the article's 1 m/s. How well the DpS equation describes this impact, `sec35_scales`
says. In the program $\mu$, $\eta$ and the units are those of `CantileverArray` and `Scales` (cantilever.hpp derives
them), $\tilde R$ is `ratio`, $V$ is `velocity`. */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec3/array_impact.hpp"

using namespace lattice;

/**
## The experiment

We strike the first beam, follow the packet to the defect (`blow.impact` takes the radius, the end of the run in
milliseconds and the time between samples), let it meet a defect of any size, and measure how the energy is divided 75
ms after the impact, the end of figure 24, among the beams before the defect, the nine around it, and those behind.
Until the packet arrives the defect is exactly at rest, so all runs share this first part. Steps are event-corrected
(event_corrected.hpp); a run whose far end moves is rejected. */
constexpr double defect_passed = 75;  // ms

/// Strikes the first beam and stops when the fifth beam before the defect begins to move.
ImpactRun approach(const StruckArray& blow, double step) {
  const std::size_t d = blow.array.defect - 1;
  const auto before = [&](const State<double>& now, const auto&) { return now.y[d - 5] == 0; };
  ImpactRun run = strike(EventCorrected{step}, blow.impact(1, 200, 1), before);
  if (run.end.y[d - 1] != 0 || run.end.y[d - 5] == 0)
    throw NoPacket("the packet does not reach the defect as expected");
  return run;
}

/// Shares of the impact's energy: sites 1 to 95, 96 to 104, and from 105 on if the defect is at 100.
struct EnergyShares {
  double reflected, near, transmitted;
};

double struck_energy(const StruckArray& blow) {
  return blow.struck_velocity() * blow.struck_velocity() / 2;
}

EnergyShares shares(const StruckArray& blow, const std::vector<double>& density) {
  const auto defect = density.begin() + std::ptrdiff_t(blow.array.defect);
  const double all = struck_energy(blow);
  return {std::accumulate(density.begin(), defect - 5, 0.0) / all,
          std::accumulate(defect - 5, defect + 4, 0.0) / all,
          std::accumulate(defect + 4, density.end(), 0.0) / all};
}

/// Continues from there with a defect: the shares at the end, and ten milliseconds earlier.
std::tuple<EnergyShares, EnergyShares> scatter(const StruckArray& blow, double ratio, ImpactRun run,
                                               double step) {
  const double end = blow.scales.time(defect_passed);
  const Impact with_defect = blow.impact(ratio, defect_passed, end);
  follow(EventCorrected{step}, with_defect, run, blow.scales.time(defect_passed - 10));
  const EnergyShares earlier = shares(blow, run.density);
  follow(EventCorrected{step}, with_defect, run, end);
  return {shares(blow, run.density), earlier};
}

/**
Over half of the energy has not reached the defect by then: it is in the wave train near the struck end. If $r$, $d$ and
$t$ are the three shares, and $r_0$ is the share before site 96 in an array without a defect, only $1-r_0$ arrives. Of
this the defect reflects, keeps and transmits the fractions (*net* shares)
$$\frac{r-r_0}{1-r_0},\qquad \frac{d}{1-r_0},\qquad \frac{t}{1-r_0}.$$
Everything is computed with two steps, 0.1 and 0.05 in units of $\tau_c$, and the difference is the error. The three
shares must add up to one to $10^{-7}$ (the *energy budget*), or the program stops. */
struct ScatteringSetup {
  StruckArray blow;
  std::array<double, 2> steps;  // in units of tau_c, the larger one first
  std::array<ImpactRun, 2> start{};
  std::array<EnergyShares, 2> without{};

  ScatteringSetup(const StruckArray& how, bool quick)
      : blow(how), steps(quick ? std::array{0.2, 0.1} : std::array{0.1, 0.05}) {
    for (std::size_t k : {0, 1}) {
      start[k] = approach(blow, steps[k]);
      without[k] = std::get<0>(scatter(blow, 1, start[k], steps[k]));
    }
  }
};

struct Fractions {
  Estimate reflected, near, transmitted, near_earlier;
  Estimate net_reflected, net_near, net_transmitted;
  Estimate budget;  // sum of the shares less one, and the same at the larger step
};

Fractions fractions(const ScatteringSetup& at, double ratio) {
  std::array<EnergyShares, 2> end, earlier, net;
  std::array<double, 2> open{};
  for (std::size_t k : {0, 1}) {
    std::tie(end[k], earlier[k]) = scatter(at.blow, ratio, at.start[k], at.steps[k]);
    const auto& [r, d, t] = end[k];
    const double before = at.without[k].reflected, arriving = 1 - before;
    net[k] = {(r - before) / arriving, d / arriving, t / arriving};
    open[k] = r + d + t - 1;
  }
  const auto both = [](const auto& of_both, double EnergyShares::*of) {
    return compare(of_both[0].*of, of_both[1].*of);
  };
  return {both(end, &EnergyShares::reflected),   both(end, &EnergyShares::near),
          both(end, &EnergyShares::transmitted), both(earlier, &EnergyShares::near),
          both(net, &EnergyShares::reflected),   both(net, &EnergyShares::near),
          both(net, &EnergyShares::transmitted), {open[1], std::abs(open[0])}};
}

/**
## The packet at the defect (figure 24)

The article draws $f_n = -\gamma_n(x_n-x_{n+1})_+^{3/2}$ in newtons over space and time. A contact is open for about
half of each internal period, so a snapshot says little; we keep the strongest force within intervals of about two
linear periods (array_impact.hpp). At 1.6 radii the packet comes back, and hardly anything appears beyond the defect; at
1.1 a part passes. */
void report_forces(Report& report, const StruckArray& blow) {
  Table& table =
      report.table("contact_forces",
                   {number("ratio", "radius of the defect's beads divided by that of the others"),
                    number("t", "middle of the time interval", "ms"),
                    count("n", "contact between cantilevers n and n + 1", "site"),
                    number("force", "strongest contact force in the interval (negative)", "N")});
  const std::size_t contacts = blow.array.sites - 1, bins = report.quick ? 50 : 250;
  const double ratios[] = {1.6, 1.1};
  std::array<std::vector<double>, 2> maps;
  parallel_for(
      2, [&](std::size_t i) { maps[i] = strongest_forces(blow, ratios[i], defect_passed, bins); });
  for (std::size_t i : {0, 1})
    for (std::size_t k = 0; k < bins * contacts; ++k)
      table.add({ratios[i], (double(k / contacts) + 0.5) * defect_passed / double(bins),
                 k % contacts + 1, 0.0 - maps[i][k]});
}

/**
## Which defects reflect, and which trap (figure x09)

As the article says, a defect of 1.6 radii reflects almost all energy that arrives, and one of 1.1 radii transmits a
good part, and so do all slighter ones of the map. It also says that almost total reflection occurs for sufficiently
large defects. We test every defect of the map from 1.6 radii on, and larger ones up to ten radii, almost a wall.

| share | article | here |
|---|---|---|
| not arrived after 75 ms, of all energy | | [0.567](cell:defect_map/ratio=1/reflected) |
| reflected at 1.6 radii, of what arrives | almost total | [0.9965](cell:defect_map/ratio=1.6/net_reflected) |
| reflected at 2 radii | almost total | [0.9977](cell:defect_map/ratio=2/net_reflected) |
| reflected at 2.5 radii | almost total | [0.9981](cell:large_defects/ratio=2.5/net_reflected) |
| reflected at 10 radii | almost total | [0.993](cell:large_defects/ratio=10/net_reflected) |
| reflected at 1.1 radii | partial | [0.704](cell:defect_map/ratio=1.1/net_reflected) |
| transmitted at 1.1 radii | significant | [0.294](cell:defect_map/ratio=1.1/net_transmitted) |
| transmitted at 1.05 radii | significant | [0.716](cell:defect_map/ratio=1.05/net_transmitted) |

The radius varies by a factor of four, and with it the mass of the beads by a factor of 64. The shares change smoothly,
and both heavy and light defects reflect. A large difference between the frequency of the defect, $\mu^{-1/2}$, and that
of the packet is not the only cause: at 0.8 radii the defect alone has a frequency one per cent above the packet's, and
[0.945](cell:defect_map/ratio=0.8/net_reflected) of the arriving energy is reflected. With amplitude its frequency moves
farther away; we do not know whether that suffices.

<!-- defect.map -->
After an impact of 1 m/s a defect of heavier beads reflects the packet: at 1.6 times the radius of the other beads,
0.9965 of the arriving energy. Slightly smaller beads trap energy: the nine sites around them hold at most 0.0504 of the
total energy 75 ms after the impact, at a relative radius of 0.934. At 0.925 what they hold stays, 0.997 of it for 25 ms
more; at 1.6 there is little, and 0.727 of it stays. (computed)
<!-- /defect.map -->

![Reflected, remaining and transmitted energy against the radius of the defect. Drawn by x09_defect_map.py: the net
shares over `ratio`, from `defect_map`.](fig:x09) */
void report_map(Report& report, const ScatteringSetup& setup) {
  const char *radius = "radius of the defect's beads divided by that of the others",
             *all = "fraction of the energy, see the chapter",
             *arriving = "fraction of the incident energy, see the chapter";
  // In eightieths, closer to each other around one
  std::vector<double> radii, larger;
  for (int k = 40; k <= 160; ++k)
    if (report.quick ? k % 10 == 0 : k % 2 == 0 || (k > 68 && k < 92))
      radii.push_back(double(k) / 80);
  const auto row = [&](double ratio) {
    const Fractions f = fractions(setup, ratio);
    if (std::abs(f.budget.value) > 1e-7) throw Failure("the energy budget is open");
    const CantileverArray& array = setup.blow.array;
    return Row{
        {"ratio", radius, ratio},
        {"mu", "effective mass of the defect divided by that of the others", array.mu(ratio)},
        {"linear_frequency", "linear frequency of the defect divided by that of the others",
         array.linear_frequency(ratio)},
        {"reflected", all, f.reflected},
        {"near", all, f.near},
        {"transmitted", all, f.transmitted},
        {"near_earlier", all, f.near_earlier},
        {"net_reflected", arriving, f.net_reflected, "",
         "difference of two resolutions, against the neighbouring rows: it is zero by "
         "definition without a defect"},
        {"net_near", arriving, f.net_near},
        {"net_transmitted", arriving, f.net_transmitted},
        {"budget", "sum of the three fractions minus one", f.budget.value}};
  };
  report.table("defect_map").fill(radii, row, "map of defects");

  // Larger defects than those of the map
  for (int k = report.quick ? 25 : 21; k <= 25; ++k) larger.push_back(double(k) / 10);
  larger.insert(larger.end(), {3, 5, 10});
  const auto reflected = [&](double ratio) {
    const Fractions f = fractions(setup, ratio);
    return Row{{"ratio", radius, ratio},
               {"reflected", all, f.reflected},
               {"net_reflected", arriving, f.net_reflected}};
  };
  report.table("large_defects").fill(larger, reflected, "large defects");
}

/**
A map has its largest value at one of its points. We look for the maximum between them, with parabolas through three
radii, first far from each other and then near. */
void report_most(Report& report, const ScatteringSetup& setup) {
  TwoRuns<std::array<double, 2>> most{};
  parallel_for(2, [&](std::size_t k) {
    double ratio = 0.9375, near = 0;
    for (double apart : {0.0125, 0.004, 0.001}) {
      const auto at = [&](double away) {
        return std::get<0>(scatter(setup.blow, ratio + away, setup.start[k], setup.steps[k])).near;
      };
      const Parabola top(at(-apart), at(0), at(apart));
      ratio += top.vertex() * apart, near = top.extremum();
    }
    (k ? most.fine : most.coarse)[0] = ratio;
    (k ? most.fine : most.coarse)[1] = near;
  });
  report.table("most_near")
      .add({{"ratio", "radius with which most energy stays near the defect",
             most.of([](const auto& of) { return of[0]; })},
            {"near", "this energy, over all", most.of([](const auto& of) { return of[1]; })}});
}

/**
Energy that is reflected need not be in the packet. For the two defects of figure 24 we follow the packets themselves:
the strongest one, which turns back, and the foremost one, which passes. The energy in the eleven sites of Eq. (24)
around them is compared with that of the packet on its way to the defect, when it is at site 80.

| energy of the packet, of that on its way | article | here |
|---|---|---|
| back at site 80, 1.6 radii | almost total | [0.983](cell:packets/ratio=1.6/part) |
| passed to site 120, 1.1 radii | significant | [0.289](cell:packets/ratio=1.1/part) | */
double packet_part(const StruckArray& blow, double ratio, bool back, double step) {
  Impact impact = blow.impact(ratio, defect_passed, 0.2);
  impact.packet = back ? WhichPacket::strongest : WhichPacket::foremost;
  const Path path = strike(EventCorrected{step}, impact).path;
  if (!back) return path.energy_at(120) / path.energy_at(80);
  // The way back, mirrored
  const auto turn = std::max_element(path.centre.begin(), path.centre.end()) - path.centre.begin();
  Path way;
  for (auto k = std::size_t(turn); k < path.t.size(); ++k)
    way.add(path.t[k], -path.centre[k]), way.energy.push_back(path.energy[k]);
  return way.energy_at(-80) / path.energy_at(80);
}

void report_packets(Report& report, const ScatteringSetup& setup) {
  const auto row = [&](double ratio) {
    const bool back = ratio > 1.5;
    const auto at = [&](std::size_t k) {
      return packet_part(setup.blow, ratio, back, setup.steps[k]);
    };
    return Row{
        {"ratio", "radius of the defect's beads divided by that of the others", ratio},
        {"way", "back at site 80, or passed to site 120", back ? "back" : "passed"},
        {"part", "energy of the packet, over that on its way at site 80", compare(at(0), at(1))}};
  };
  report.table("packets").fill(std::array{1.6, 1.1}, row, "packets");
}

/**
## Energy trapped at the defect

The article sees a small part of the energy loosely trapped at 1.6 radii. A reflected packet leaves it on the incoming
side, so we take the nine sites that end at the defect, 75 ms after the impact, and compare them with the same sites in
an array without a defect, where the packet has left only a wake. We find some energy, loosely trapped: part of it is
gone 25 ms later, when the nine sites before these hold more than they do. A heavy defect holds less energy around it
(sites 96 to 104) than the wake leaves there without a defect, while one of 0.925 radii keeps its energy. By 100 ms the
transmitted packet would reach the end of the article's array, so ours has a hundred beams more.

In which motion does a light defect keep it? Alone, it has the frequency $\mu^{-1/2}$, above the 1 of its neighbours.
Its contacts only push it back, so with amplitude its frequency rises further, away from theirs. At 0.925 radii it can
reach the frequency of the packet, [1.10](statement:cantilever.frequency), and in the run it oscillates close to it.

| share of the energy | article | 1.6 radii | no defect | 0.925 radii |
|---|---|---|---|---|
| before the defect at 75 ms | small | [0.00389](cell:trapped/ratio=1.6/before) | [0.00148](cell:trapped/ratio=1/before) | |
| left of it at 100 ms | loosely trapped | [0.866](cell:trapped/ratio=1.6/before_left) | | |
| on the nine sites before these at 75 ms | | [0.00368](cell:trapped/ratio=1.6/next) | | |
| the same at 100 ms | | [0.00433](cell:trapped/ratio=1.6/next_late) | | |
| around the defect at 75 ms | | [0.000768](cell:trapped/ratio=1.6/near) | [0.00138](cell:ratio=1/near) | [0.0470](cell:trapped/ratio=0.925/near) |
| left of it at 100 ms | | [0.727](cell:trapped/ratio=1.6/near_left) | | [0.997](cell:trapped/ratio=0.925/near_left) |

| frequency of the light defect, 0.925 radii | in units of that of its neighbours |
|---|---|
| alone | [1.044](cell:light_defect/alone) |
| in the run, 65 to 100 ms | [1.106](cell:light_defect/in_run) | */
struct Stay {
  std::array<double, 2> near{}, before{}, next{};  // at 75 and at 100 ms
  std::vector<double> t{}, v{};                    // of the defect, from 65 ms on
};

Stay stay(const StruckArray& blow, double ratio, ImpactRun run, double step, double sample) {
  const Impact impact = blow.impact(ratio, 100.2, sample);
  Stay out;
  std::size_t k = 0;
  const auto look = [&](const State<double>& now, const std::vector<double>& density) {
    if (blow.scales.milliseconds(now.t) >= 65)
      out.t.push_back(now.t), out.v.push_back(now.v[blow.array.defect - 1]);
    if (k == 2 || blow.scales.milliseconds(now.t) < 75 + 25 * double(k) - 1e-6) return;
    out.near[k] = shares(blow, density).near;
    out.before[k] = window_sum(density, blow.array.defect - 5, 4) / struck_energy(blow);
    out.next[k++] = window_sum(density, blow.array.defect - 14, 4) / struck_energy(blow);
  };
  follow(EventCorrected{step}, impact, run, impact.time, look);
  return out;
}

void report_stay(Report& report, StruckArray blow, const std::array<double, 2>& steps) {
  blow.array.sites += 100;
  std::array<ImpactRun, 2> start;
  parallel_for(2, [&](std::size_t k) { start[k] = approach(blow, steps[k]); });
  const double ratios[] = {1.6, 1, 0.925};
  std::array<TwoRuns<Stay>, 3> at;
  parallel_for(6, [&](std::size_t i) {
    Stay& one = i % 2 ? at[i / 2].fine : at[i / 2].coarse;
    one = stay(blow, ratios[i / 2], start[i % 2], steps[i % 2], steps[0]);
  });

  // What is left before and around each of them
  Table& trapped = report.table("trapped");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto of = [&](auto number) { return at[i].of(number); };
    trapped.add({{"ratio", "radius of the defect's beads divided by that of the others", ratios[i]},
                 {"before", "on the nine sites that end at the defect, at 75 ms",
                  of([](const Stay& s) { return s.before[0]; }), "share of the energy"},
                 {"before_left", "part of it that is left at 100 ms",
                  of([](const Stay& s) { return s.before[1] / s.before[0]; })},
                 {"next", "on the nine sites before these, at 75 ms",
                  of([](const Stay& s) { return s.next[0]; }), "share of the energy"},
                 {"next_late", "the same at 100 ms", of([](const Stay& s) { return s.next[1]; }),
                  "share of the energy"},
                 {"near", "on the nine sites around the defect, at 75 ms",
                  of([](const Stay& s) { return s.near[0]; }), "share of the energy"},
                 {"near_left", "part of it that is left at 100 ms",
                  of([](const Stay& s) { return s.near[1] / s.near[0]; })}});
  }

  // How fast the light one oscillates, and would alone
  const auto frequency = [](const Stay& s) {
    const std::vector<double> turns = upward_crossings(s.t, s.v);
    return 2 * std::numbers::pi * double(turns.size() - 1) / (turns.back() - turns.front());
  };
  report.table("light_defect")
      .add({{"alone", "frequency of a defect of 0.925 radii alone",
             exact(blow.array.linear_frequency(0.925)), "1 / tau_c", "exact"},
            {"in_run", "its mean frequency from 65 to 100 ms", at[2].of(frequency), "1 / tau_c"}});
}

/**
## The packet at $n = 80$

The article prints properties of the packet at $n = 80$, far from both ends. We record the deflection of this beam and
the force of the contact behind it (pulse.hpp), twice, the second time with half the step and half the spacing of
samples. The force comes in pulses, one in each internal oscillation, and the *period* is half the time between the
pulses before and after the strongest.

| quantity | article | here |
|---|---|---|
| largest velocity, m/s | 0.5 | [0.494](statement:cantilever.bead_velocity) |
| deflection, µm | 11 | [10.95](statement:cantilever.deflection) |
| force, N | 2.8 | [2.86](statement:cantilever.force) |
| internal period, ms | 0.14 | [0.144](statement:cantilever.period) |
| linear period over internal one | 1.1 | [1.10](statement:cantilever.frequency) |
| speed, slope of $X(t)$ between sites 20 and 40, sites/s | 2030 | [2030](statement:cantilever.speed) |
| duration, force above a thousandth of its maximum, ms | 3.8 | [3.79](statement:cantilever.duration) | */
constexpr std::size_t watched_site = 80;

struct Passage {
  StruckArray blow;
  TwoRuns<WatchedRun> runs{};

  explicit Passage(const StruckArray& how) : blow(how) {
    parallel_for(2, [&](std::size_t i) {
      const double step = i ? 0.05 : 0.1;
      (i ? runs.fine : runs.coarse) = pass(blow, watched_site, 60, {step, step});
    });
  }
  template <class Of>
  Estimate pulse(Of of) const {
    return runs.of([&](const WatchedRun& run) { return of(pulse_of(run.at, blow.scales)); });
  }
  Estimate speed_over(std::size_t sites) const {
    return runs.of([&](const WatchedRun& run) { return mean_speed(run, blow, sites); });
  }
};

/**
Speed and duration depend on how they are measured. For the speed we take the slope of the energy centre $X(t)$, as the
article does in section 3.4. The packet slows down as it radiates, so the slope depends on the interval, which is not
printed; the one between sites 20 and 40 gives the printed number. So does $n$ over the time of the largest force at $n
= 80$. The *duration* is the time from the first to the last instant at which the force is a given share of its maximum.
A lower threshold includes more pulses. A thousandth of the force is a hundredth of the compression, the criterion of
section 3.4 for the sites of a packet. The velocity of the bead gives no duration: in the wave train it still swings to
more than a hundredth of its largest value when the run ends.

| other readings | here |
|---|---|
| speed, if the way begins at the struck beam | [2005](cell:speeds/from=1/speed) |
| slope of $X(t)$ between sites 10 and 80 | [1996](cell:speeds/from=10/to=80/speed) |
| 80 sites over the time of the largest force | [2030](cell:speeds/how=arrival/from=0/speed) |

| between 20 and 60 | [1999](cell:speeds/from=20/to=60/speed) |
| between 20 and 80 | [1979](cell:speeds/from=20/to=80/speed) |
| between 20 and 100 | [1964](cell:speeds/from=20/to=100/speed) |
| between 75 and 85 | [1937](cell:speeds/from=75/to=85/speed) |
| duration above one half of the force | [1.17](cell:durations/above=0.5/duration) |
| above a hundredth | [3.06](cell:durations/above=0.01/duration) |
| above 1.5 thousandths | [3.64](cell:durations/above=1.5e-3/duration) |
| above a two-thousandth | [3.94](cell:durations/above=5e-4/duration) | */
void report_packet(Report& report, const Passage& at) {
  const double tau_c = at.blow.scales.tau_c();
  report.table("packet").add(
      {{"velocity", "largest velocity", at.pulse([](const Pulse& p) { return p.velocity; }), "m/s"},
       {"deflection", "largest deflection",
        at.pulse([](const Pulse& p) { return p.deflection * 1e6; }), "um"},
       {"force", "largest contact force", at.pulse([](const Pulse& p) { return p.force; }), "N"},
       {"period", "internal period", at.pulse([](const Pulse& p) { return p.period * 1e3; }), "ms"},
       {"frequency", "linear period over internal one",
        at.pulse([&](const Pulse& p) { return 2 * std::numbers::pi * tau_c / p.period; })}});

  // The speed as a mean over the whole path, and on several stretches
  Table& speeds = report.table("speeds");
  const auto add = [&](const char* how, int from, int to, const Estimate& speed) {
    speeds.add({{"how", "arrival of the largest force, or slope of X(t)", how},
                {"from", "first site of the way", from, "site"},
                {"to", "its last site", to, "site"},
                {"speed", "speed of the packet", speed, "sites/s"}});
  };
  for (int from : {0, 1}) add("arrival", from, 80, at.speed_over(watched_site - std::size_t(from)));
  for (const auto& [from, to] :
       {std::pair{10, 80}, {20, 40}, {20, 60}, {20, 80}, {20, 100}, {75, 85}})
    add("slope", from, to, at.runs.of([&, from = from, to = to](const WatchedRun& run) {
      return run.path.line(from, to)->slope / tau_c;
    }));

  // The duration with several thresholds
  Table& durations = report.table("durations");
  for (double share : {0.5, 0.01, 1.5e-3, 1e-3, 5e-4})
    durations.add(
        {{"above", "threshold, as a part of the largest force", share},
         {"duration", "from its first to its last passage",
          at.runs.of([&](const WatchedRun& run) { return duration_above(run, at.blow, share); }),
          "ms"}});
}

/**
According to the article the packet leaves behind a fairly extended wave train, which the boundary emits. We take the
sites up to ten behind the largest one of the packet, as in section 3.4, twice: when the packet is at site 50, and just
before it meets the defect. By its participation number $(\sum e_n)^2/\sum e_n^2$ the train spreads over many more sites
than the packet does. It reaches back to the boundary and grows with the way of the packet.

| when the packet | is at site 50 | meets the defect |
|---|---|---|
| sites that share the energy of the train | [22.3](cell:wave_train/at=half_way/sites) | [32.1](cell:wave_train/at=defect/sites) |
| sites that hold nine tenths of it | [21](cell:wave_train/at=half_way/most) | [30](cell:wave_train/at=defect/most) |
| first of them | [2](cell:wave_train/at=half_way/first) | [2](cell:wave_train/at=defect/first) |
| energy of the train, of all | [0.548](cell:wave_train/at=half_way/share) | [0.562](cell:wave_train/at=defect/share) |
| sites that share the energy of the packet | [2.68](cell:wave_train/at=half_way/packet) | [2.71](cell:wave_train/at=defect/packet) | */
struct Train {
  double sites, share, packet;
  std::size_t first, last;  // sites, with a twentieth of its energy before and behind

  Train(std::vector<double> e, double all) {
    const std::size_t front = *front_packet(e), m = packet_half_width;
    packet = participation(
        {e.begin() + std::ptrdiff_t(front - m), e.begin() + std::ptrdiff_t(front + m + 1)});
    e.resize(front - 10);
    sites = participation(e), share = total(e) / all;
    std::partial_sum(e.begin(), e.end(), e.begin());
    const auto site = [&](double part) {
      return std::size_t(std::ranges::lower_bound(e, part * e.back()) - e.begin()) + 1;
    };
    first = site(0.05), last = site(0.95);
  }
};

void report_wave_train(Report& report, const ScatteringSetup& setup) {
  const double all = struck_energy(setup.blow);
  Table& table = report.table("wave_train");
  const auto add = [&](const char* at, const auto& density_of) {
    const TwoRuns<Train> both{{density_of(0), all}, {density_of(1), all}};
    table.add(
        {{"at", "where the packet is", at},
         {"sites", "participation number", both.of([](const Train& t) { return t.sites; }), "site"},
         {"most", "sites that hold the middle nine tenths of the energy",
          both.of([](const Train& t) { return t.last - t.first + 1; }), "site", "exact"},
         {"first", "the first of them", both.of([](const Train& t) { return t.first; }), "site",
          "exact"},
         {"share", "of the energy", both.of([](const Train& t) { return t.share; })},
         {"packet", "participation number of the packet",
          both.of([](const Train& t) { return t.packet; }), "site"}});
  };
  add("half_way", [&](std::size_t k) {
    Impact impact = setup.blow.impact(1, 60, 1);
    impact.until = 50;
    return strike(EventCorrected{setup.steps[k]}, impact).density;
  });
  add("defect", [&](std::size_t k) { return setup.start[k].density; });
}

/**
## What an experiment would see

According to the article's conclusion breathers of small amplitude have a period of 0.15 ms: that of weak ones tends to
the period of one beam alone. In 10 ms, the lifetime of breathers measured in diatomic chains, the article expects about
20 sites and 70 oscillations if damping is moderate. At its speed the packet travels this far without damping. From
$n = 80$ on, where it is slower, it travels a site less. With damping it travels fewer sites, and its frequency hardly
changes (`sec5_experiment`).

| quantity | article | here |
|---|---|---|
| period of weak breathers, ms | 0.15 | [0.158](statement:outlook.small_period) |
| sites in 10 ms | 20 | [20.3](statement:outlook.travel_10ms) |
| the same from $n = 80$ on | | [19.3](cell:experiment/onward) |
| oscillations in 10 ms | 70 | [69.5](statement:outlook.periods_10ms) | */
void report_experiment(Report& report, const Passage& at) {
  const Scales& scales = at.blow.scales;
  const auto onward = [&](const WatchedRun& run) {
    return run.path.travelled(80, scales.time(10));
  };
  report.table("experiment")
      .add({{"small_period", "of a beam alone", exact(2 * std::numbers::pi * scales.tau_c() * 1e3),
             "ms", "exact"},
            {"travelled", "in 10 ms at the speed of the whole way to n = 80",
             at.runs.of([&](const WatchedRun& run) {
               return 10e-3 * mean_speed(run, at.blow, watched_site);
             }),
             "sites"},
            {"onward", "in 10 ms from n = 80 on", at.runs.of(onward), "sites"},
            {"periods", "in 10 ms",
             at.pulse([](const Pulse& p) { return 10 / (p.period * 1e3); })}});
}

/**
## Checks and limits

Energy conservation does not prove the forces right, so an independent method, GSL's adaptive one of order eight, also
computes an array with a heavy defect near the impact, where the motion is strong, and must arrive at the same state to
$10^{-8}$, or the program stops. */
void check_by_gsl(const StruckArray& blow) {
  StruckArray shorter = blow;
  shorter.array.sites = 30, shorter.array.defect = 8;
  const Impact impact = shorter.impact(1.6, 4, shorter.scales.time(4));
  const ImpactRun ours = strike(EventCorrected{0.0125}, impact);
  distance_from_reference(impact.chain, struck(impact.chain.sites, impact.velocity), impact.time,
                          ours.end, 1e-8);  // or it throws
}

/**
The article prints neither the path over which it measures the speed nor the threshold of the duration. We choose those
that give the printed numbers; equally natural choices give other numbers. The article gives no energies for its
reflections. Replacing a beam with beads by a point mass costs a tenth of a per cent of its frequency; torsion of the
beams, their higher modes and dissipation in the contacts are neglected. */
void reproduce(Report& report) {
  const StruckArray blow;
  const Passage homogeneous(blow);
  report_packet(report, homogeneous);
  report_experiment(report, homogeneous);
  check_by_gsl(blow);
  report_forces(report, blow);
  const ScatteringSetup setup{blow, report.quick};
  report_stay(report, blow, setup.steps);
  report_wave_train(report, setup);
  report_map(report, setup);
  report_most(report, setup);
  report_packets(report, setup);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `cantilever.speed`: travelling breather velocity | 2030 sites/s | 2030 sites/s | reproduced, assuming |
| `cantilever.bead_velocity`: maximal bead velocity at n = 80 | 0.5 m/s | 0.4936 m/s | reproduced |
| `cantilever.deflection`: maximal deflection at n = 80 | 11 um | 10.95 um | reproduced |
| `cantilever.force`: maximal contact force at n = 80 | 2.8 N | 2.864 N | reproduced |
| `cantilever.duration`: pulse duration at n = 80 | 3.8 ms | 3.788 ms | reproduced, assuming |
| `cantilever.period`: internal oscillation period | 0.14 ms | 0.1438 ms | reproduced |
| `cantilever.reflect16`: R_100 = 1.6 reflects almost totally | almost total | defect_map.net_reflected (ratio = 1.6): 0.95 < 0.9965; defect_map.net_reflected (ratio = 1.6): 0.9965 < 1 | holds |
| `cantilever.partial11`: R_100 = 1.1, and a smaller inhomogeneity, transmits significantly; at 1.1 the reflection is partial | partial | defect_map.net_transmitted (ratio = 1.1): 0.1 < 0.2944 (the closest of 9) | holds |
| `cantilever.trapped`: a small part of the energy stays trapped near the defect at R_100 = 1.6 | small | 0.003894 of the energy | quantified |
| `outlook.travel_10ms`: sites travelled in 10 ms | 20 sites | 20.30 sites | reproduced, assuming |
| `outlook.periods_10ms`: internal oscillations in 10 ms | 70 | 69.53 | reproduced |
| `cantilever.frequency`: period of linear oscillations over that of the packet | 1.1 | 1.102 | reproduced |
| `outlook.small_period`: breather periods at small amplitude in section 3.6 | 0.15 ms | 0.1585 ms | reproduced |
| `cantilever.wavetrain`: the impact generates a fairly extended wavetrain emitted from the boundary too | fairly extended | wave_train.packet (at = defect), wave_train.sites (at = defect): 8.126 < 32.14; wave_train.first (at = defect): 2 < 5; wave_train.share (at = defect): 0.1 < 0.5624 | holds |
| `cantilever.total_reflection`: almost total reflection occurs for sufficiently large defects | almost total | large_defects.net_reflected (ratio = 5): 0.9984 < 1 (the closest of 50) | holds |
<!-- /statements -->

## Try it

**To change it.** Two changed beams instead of one are two masses and three contacts in `cantilever_chain`
(cantilever.cpp, with which its tests fail); the three windows are the sums in `shares`, which the legend of figure x09
names, the times are `defect_passed` and those in `stay`. A new quantity is one more entry of a row; the scripts in
`figures/` read columns by name.

1. *Easy.* How much does a slightly heavier defect transmit? `build/bin/sec36_cantilever_defect run --ratio 1.1` gives
   `net_transmitted` = 0.29443. Hint: its mass differs by an eighth, its own frequency only by six per cent.
2. *Harder.* Which radius traps most? `build/bin/sec36_cantilever_defect run --ratio 0.925` gives `net_near` = 0.10858;
   with 0.934 it is 0.11622. Hint: a defect of 0.925 radii
   alone has the frequency 1.044, between that of its neighbours and the packet's 1.1.

## With your own parameters

`run` measures one defect; it fails if the packet that passes reaches the far end in 75 ms, and `--sites` makes the
array longer. */
struct OneDefect {
  static constexpr Title title{
      "run", "one packet that meets a defect: reflected, remaining and transmitted energy"};
  double ratio = 1.6, velocity = 1;
  std::size_t sites = 200;

  void parameters(Parameters& p) {
    p.add("ratio", ratio, "radius of the defect's beads divided by that of the others", {0.1, 5})
        .formerly("radius");
    p.add("velocity", velocity, "velocity of the impact on the first bead, in m/s",
          {0.5, 2, "m/s"});
    p.add("sites", sites, "number of cantilevers; the hundredth is the defect", {110, 1e4});
  }
  Table table() const;
};

// The shares; throws Failure if the array is too short for them
Fractions within_array(const StruckArray& blow, double ratio) try {
  return fractions({blow, false}, ratio);
} catch (const FarEndReached&) {
  throw Failure("the packet that passes the defect reaches the end of the array within " +
                short_text(defect_passed) + " ms: --sites " + std::to_string(blow.array.sites) +
                " are too few");
}

Table OneDefect::table() const {
  StruckArray blow{.velocity = velocity};
  blow.array.sites = sites;
  const Fractions f = within_array(blow, ratio);
  const char *all = "share of the energy", *arriving = "share of what arrives";
  // The transmitted or reflected energy may be zero
  Answers q;
  q.add_small("reflected", f.reflected, all,
              "energy of the sites up to the fifth before the defect, at the end");
  q.add_small("near", f.near, all,
              "energy of the defect and four sites on either side, at the end");
  q.add_small("transmitted", f.transmitted, all,
              "energy from the fifth site behind the defect, at the end");
  q.add_small("near_earlier", f.near_earlier, all, "energy near the defect 10 ms before the end");
  q.add_small(
      "net_reflected", f.net_reflected, arriving,
      "reflected fraction of the incident energy, which would pass in an array without a defect");
  q.add_small("net_near", f.net_near, arriving,
              "fraction of the incident energy that stays near the defect");
  q.add_small("net_transmitted", f.net_transmitted, arriving,
              "transmitted fraction of the incident energy");
  q.add_small("budget", f.budget, "",
              "reflected + near + transmitted - 1, zero up to numerical errors");
  q.add("speed", Passage(blow).speed_over(watched_site), "sites/s",
        "80 sites divided by the time of the largest force at n = 80, before the packet meets the "
        "defect");
  // The constants of the defect, Eq. (32)
  q.add("mu", exact(blow.array.mu(ratio)), "",
        "effective mass of the defect divided by that of the other cantilevers, Eq. (32)");
  q.add("eta", exact(CantileverArray::eta(ratio)), "",
        "stiffness of the defect's two contacts divided by that of the others, Eq. (32)");
  q.add("linear_frequency", exact(blow.array.linear_frequency(ratio)), "1 / tau_c",
        "angular frequency of the isolated defect, without its contacts");
  return q.table;
}

int main(int argc, char** argv) {
  return run({"sec36_cantilever_defect", "3.6",
              "Decorated cantilevers and a defect that reflects (section 3.6)", reproduce,
              commands<OneDefect>()},
             argc, argv);
}
