/**
# 3.6 Scattering of a breather by a defect in an array of cantilevers

How does a defect scatter a travelling breather, in a system that one can build? Section 3.6 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) proposes an array of stiff beams, clamped at both ends, with a bead on either side of each.
We strike the first beam and compute how much energy a beam with larger or smaller beads reflects, transmits and keeps.
Heavy beads reflect the packet almost totally, as the article says, and so do much lighter ones. What decides is how far
the defect is detuned from its neighbours, compared with the amount by which the packet oscillates faster than they do.
Only beads slightly smaller than the others trap a noticeable part of the energy.

       V      n = 1   2   3          99   100  101
      --->       o|o o|o o|o   ...   o|o  O|O  o|o   ...     two beads on each, which touch their neighbours
                  |   |   |           |    |    |
               ===+===+===+===========+====+====+===         clamped at both ends

![Contact forces after an impact, with larger beads at n = 100. Drawn by fig24_defect.py: `force` over `n` and `t`,
from `contact_forces`.](fig:24)

<!-- head -->
`build/bin/sec36_cantilever_defect` computes this chapter in 6 s on two cores and writes 13 tables to
`build/data/sec36_cantilever_defect`. Its figures: `make fig24`, `make x09`, `make x54`. With your parameters: `run`,
one packet that meets a defect: reflected, remaining and transmitted energy.
<!-- /head -->

## Model

A beam with its two beads is a mass $m_n$ on a spring, with one degree of freedom, the deflection $x_n$ of its middle;
neighbouring beads push on each other by Hertz's law. Lengths are measured in units of $\xi$, at which spring and
contact are equally strong, and times in units of $\tau_c$, the free period over $2\pi$. The array then obeys Eq. (32),
$$\mu_n\,\ddot y_n + y_n = -\eta_n\,(y_n-y_{n+1})_+^{3/2} + \eta_{n-1}\,(y_{n-1}-y_n)_+^{3/2},
  \qquad \dot y_n(0) = \lambda^{5/2}\,\delta_{n,1},$$
with free ends. At the defect, $n = 100$, the beads have $\tilde R$ times the radius of the others. It is heavier,
$\mu = (m_{\rm beam} + 2\tilde R^3 m_{\rm bead})/(m_{\rm beam} + 2m_{\rm bead})$, and its two contacts are stiffer,
$\eta = [2\tilde R/(1+\tilde R)]^{1/2}$; elsewhere both are one. The impact $V$ enters only through $\lambda$, Eqs. (28)
to (30). `sec35_scales` explains why these arrays and not Newton's cradle. In the program $\tilde R$ is `ratio`; $\mu$,
$\eta$ and the units are those of `CantileverArray` and `Scales` (cantilever.hpp derives them). */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "report/program.hpp"
#include "sec3/array_impact.hpp"
#include "sec36/definitions.hpp"
#include "sec36/trapped.hpp"

using namespace lattice;

/**
## The experiment

We strike the first beam, and 75 ms later, where figure 24 ends, see where the energy is: before the defect, on the nine
sites around it, or behind. Steps are event-corrected (event_corrected.hpp), and `strike` rejects a run whose far end
moves. */
const StruckArray article{.array = {.sites = 200, .defect = 100}, .velocity = 1};  // m/s
constexpr double run_end = 75;                                                     // ms
constexpr std::size_t near_sites = 4;  // on either side of the defect
constexpr TwoSteps full{0.1, 0.05};    // units of tau_c
constexpr TwoSteps of_quick_run{0.2, 0.1};

/// Fractions of the energy of the impact.
struct EnergyShares {
  double reflected, near, transmitted, on_defect;
};

EnergyShares scatter(const StruckArray& struck, double ratio, double until, double step) {
  const Impact impact = struck.impact({.ratio = ratio, .until = until});
  const std::vector<double> e = strike(EventCorrected{step}, impact).density;
  const auto energy = [&](std::size_t first, std::size_t last) {  // sites, counted from one
    return std::accumulate(e.begin() + std::ptrdiff_t(first - 1), e.begin() + std::ptrdiff_t(last),
                           0.0);
  };
  const std::size_t defect = struck.array.defect, from = defect - near_sites,
                    to = defect + near_sites;
  return {.reflected = energy(1, from - 1) / struck.energy(),
          .near = energy(from, to) / struck.energy(),
          .transmitted = energy(to + 1, e.size()) / struck.energy(),
          .on_defect = energy(defect, defect) / struck.energy()};
}

/**
More than half of the energy never reaches the defect within this time: it is in the wave train near the struck end. We
therefore repeat each run without a defect. What is behind site 95 then, we call the arriving energy, and refer the
*net* fractions to it: the excess before the defect is reflected, the rest is near the defect or transmitted. The wave
train leaves a little near the defect in any case, which is not subtracted; figure x09 marks it. */
struct Scattering {
  EnergyShares with, without;  // the defect

  double arriving() const { return 1 - without.reflected; }
  double net_reflected() const { return (with.reflected - without.reflected) / arriving(); }
  double net_near() const { return with.near / arriving(); }
  double net_transmitted() const { return with.transmitted / arriving(); }
  double budget() const { return with.reflected + with.near + with.transmitted - 1; }
};

TwoRuns<EnergyShares> shares(const StruckArray& struck, double ratio, double until,
                             const TwoSteps& steps) {
  return {scatter(struck, ratio, until, steps.coarse), scatter(struck, ratio, until, steps.fine)};
}

TwoRuns<Scattering> scattering(const TwoRuns<EnergyShares>& with,
                               const TwoRuns<EnergyShares>& without) {
  return {{with.coarse, without.coarse}, {with.fine, without.fine}};
}

/**
## The packet on its way, at $n = 80$

First the packet itself, far from both ends, where the article describes it. We record the velocity and deflection of
beam 80 and the force of the contact behind it (array_impact.hpp). The contact closes once in each internal oscillation;
the *period* is half the time between the pushes before and after the strongest.

| quantity | article | here |
|---|---|---|
| largest velocity, m/s | 0.5 | [0.494](statement:cantilever.bead_velocity) |
| deflection, µm | 11 | [10.95](statement:cantilever.deflection) |
| force, N | 2.8 | [2.86](statement:cantilever.force) |
| internal period, ms | 0.14 | [0.144](statement:cantilever.period) |
| linear period over internal one | 1.1 | [1.10](statement:cantilever.frequency) |
| speed, slope of $X(t)$ between sites 20 and 40, sites/s | 2030 | [2030](statement:cantilever.speed) |
| duration, force above a thousandth of its maximum, ms | 3.8 | [3.79](statement:cantilever.duration) |
| period of weak breathers, that of a beam alone, ms | 0.15 | [0.158](statement:outlook.small_period) |
| sites in 10 ms, at this speed | 20 | [20.3](statement:outlook.travel_10ms) |
| oscillations in 10 ms | 70 | [69.5](statement:outlook.periods_10ms) |

Two numbers agree with the printed *close to* but not by rounding: the force and the period of weak breathers are the
printed ones if their digits are cut off. The last two rows are what the article's conclusion expects of an experiment
in 10 ms, the lifetime of breathers in diatomic chains; `sec5_experiment` adds damping. */
constexpr std::size_t watched_site = 80;
constexpr double packet_passed = 60;  // ms

TwoRuns<WatchedRun> watch(const StruckArray& struck, double until, const TwoSteps& steps) {
  const auto run = [&](double step) {
    return pass(struck, watched_site, until, {.step = step, .sample = step});
  };
  return {run(steps.coarse), run(steps.fine)};
}

void report_packet(Report& report, const TwoRuns<WatchedRun>& runs) {
  const Scales& scales = article.scales;
  const auto pulse = [&](auto of) {
    return runs.of([&](const WatchedRun& run) { return of(pulse_of(run.at, scales)); });
  };
  report.table("packet").add(
      {{"velocity", "largest velocity", pulse([](const Pulse& p) { return p.velocity; }), "m/s"},
       {"deflection", "largest deflection",
        pulse([](const Pulse& p) { return p.deflection * 1e6; }), "um"},
       {"force", "largest contact force", pulse([](const Pulse& p) { return p.force; }), "N"},
       {"period", "internal period", pulse([](const Pulse& p) { return p.period * 1e3; }), "ms"},
       {"frequency", "linear period over internal one",
        pulse([&](const Pulse& p) { return 2 * std::numbers::pi * scales.tau_c() / p.period; })}});
}

/**
Speed and duration hang on their definition, which the article does not print; ours give its numbers. The speed is the
slope of the energy centre $X(t)$, as in section 3.4. The packet radiates and slows down, so the slope depends on the
stretch. The *duration* lasts from the first to the last instant at which the force exceeds a fraction of its maximum. A
thousandth of the force is a hundredth of the compression, the criterion of section 3.4 for the sites of a packet.
`sec36/definitions.cpp` computes the variants.

| definition | speed, sites/s | definition | duration, ms |
|---|---|---|---|
| slope between sites 20 and 60 | [1999](cell:speeds/from=20/to=60/speed) | force above 0.5 | [1.17](cell:durations/above=0.5/duration) |
| slope between sites 20 and 100 | [1964](cell:speeds/from=20/to=100/speed) | above 0.01 | [3.06](cell:durations/above=0.01/duration) |
| slope between sites 75 and 85 | [1937](cell:speeds/from=75/to=85/speed) | above 0.0015 | [3.64](cell:durations/above=1.5e-3/duration) |
| 80 sites over the arrival of the largest force | [2030](cell:speeds/how=arrival/from=0/speed) | above 0.0005 | [3.94](cell:durations/above=5e-4/duration) |

The packet leaves a wave train behind, which the boundary emits. Just before the packet meets the defect the train has
[0.562](cell:wave_train/at=defect/share) of the energy, on [32.1](cell:wave_train/at=defect/sites) sites by its
participation number $(\sum e_n)^2/\sum e_n^2$, and reaches back to the boundary; the packet's own number is
[2.71](cell:wave_train/at=defect/packet).

## What to expect of a defect

While its contacts are open a beam swings alone, at the frequency $\mu_n^{-1/2}$. Contacts without compression have no
linear stiffness. So the linearised array has no band of waves but two frequencies only, 1 and that of the defect, and
no linear theory of scattering: all transport is nonlinear. The contacts push a beam back, which raises its frequency
with the amplitude, in the packet to 1.10. In the DpS equation (`sec31_dps_limit`) the term that does this is also the
one that carries energy from beam to beam. A defect adds its detuning $\mu^{-1/2}-1$ to that equation, as a frequency of
its own. Hence we expect that a defect transmits if its detuning is small compared with the packet's 0.10, and reflects
otherwise, whether it is heavy or light. A light defect differs in one respect: its frequency, raised by its contacts,
can reach that of the packet. Then it can take up energy, and keep it when the packet has gone, since its neighbours
cannot follow.

## Which defects reflect (figures 24 and x09)

The scan bears this out. Detunings of $-0.045$ and $+0.044$, at 1.075 and 0.925 radii, transmit about half of the
arriving energy each. What counts is the distance from the frequency of the neighbours and not from the packet's: at 0.8
radii the defect alone has the packet's own frequency, 1.11 against 1.10, and reflects nearly all.

| radius | defect alone, $\mu^{-1/2}$ | reflected | near the defect | transmitted | article |
|---|---|---|---|---|---|
| 0.5 | [1.236](cell:defect_map/ratio=0.5/linear_frequency) | [0.9935](cell:net_reflected) | [0.0034](cell:net_near) | [0.0030](cell:net_transmitted) | |
| 0.8 | [1.113](cell:defect_map/ratio=0.8/linear_frequency) | [0.945](cell:net_reflected) | [0.0142](cell:net_near) | [0.0406](cell:net_transmitted) | |
| 0.85 | [1.086](cell:defect_map/ratio=0.85/linear_frequency) | [0.889](cell:net_reflected) | [0.0073](cell:net_near) | [0.104](cell:net_transmitted) | |
| 0.925 | [1.044](cell:defect_map/ratio=0.925/linear_frequency) | [0.436](cell:net_reflected) | [0.109](cell:net_near) | [0.456](cell:net_transmitted) | |
| 1 | 1 | 0 | [0.0032](cell:defect_map/ratio=1/net_near) | [0.997](cell:net_transmitted) | |
| 1.075 | [0.955](cell:defect_map/ratio=1.075/linear_frequency) | [0.522](cell:net_reflected) | [0.0013](cell:net_near) | [0.477](cell:net_transmitted) | |
| 1.1 | [0.94](cell:defect_map/ratio=1.1/linear_frequency) | [0.704](cell:net_reflected) | [0.0019](cell:net_near) | [0.294](cell:net_transmitted) | partial reflection |
| 1.6 | [0.671](cell:defect_map/ratio=1.6/linear_frequency) | [0.9965](cell:net_reflected) | [0.0018](cell:net_near) | [0.0017](cell:net_transmitted) | almost total |
| 5 | [0.1414](cell:large_defects/ratio=5/linear_frequency) | [0.9984](cell:net_reflected) | [0.0016](cell:net_near) | | almost total |
| 10 | [0.0503](cell:large_defects/ratio=10/linear_frequency) | [0.9926](cell:net_reflected) | [0.0074](cell:net_near) | | almost total |

Two details surprise. At 0.8 radii the energy near the defect has a second, small maximum, the trace of that resonance.
And a beam with beads of 10 radii, almost a wall, reflects *less* than one of 5. What it does not reflect is not
transmitted but on the defect itself, [0.0025](cell:large_defects/ratio=10/on_defect) of all energy. We suppose that the
packet excites it as a whole: its pushes all have the same direction, and last about as long as this slow beam needs for
one swing.

The article draws $f_n = -\gamma_n(x_n-x_{n+1})_+^{3/2}$ over space and time (figure 24). A contact is open for about
half of each internal period, so a snapshot says little; we keep the strongest force within intervals of about two
linear periods.

<!-- defect.map -->
After an impact of 1 m/s a defect of heavier beads reflects the packet: at 1.6 times the radius of the other beads,
0.9965 of the arriving energy. Slightly smaller beads trap energy: the nine sites around them hold at most 0.0504 of the
total energy 75 ms after the impact, at a relative radius of 0.934. At 0.925 what they hold stays, 0.997 of it for 25 ms
more; at 1.6 there is little, and 0.727 of it stays. (computed)
<!-- /defect.map -->

![Reflected, remaining and transmitted energy against the radius of the defect. Drawn by x09_defect_map.py: the net
fractions over `ratio`, from `defect_map`.](fig:x09) */
void report_forces(Report& report) {
  Table& table =
      report.table("contact_forces",
                   {number("ratio", "radius of the defect's beads divided by that of the others"),
                    number("t", "middle of the time interval", "ms"),
                    count("n", "contact between cantilevers n and n + 1", "site"),
                    number("force", "strongest contact force in the interval (negative)", "N")});
  const std::size_t contacts = article.array.sites - 1, bins = report.quick ? 50 : 250;
  for (double ratio : {1.6, 1.1}) {
    const std::vector<double> map = strongest_forces(article, ratio, run_end, bins);
    for (std::size_t k = 0; k < map.size(); ++k)
      table.add({ratio, (double(k / contacts) + 0.5) * run_end / double(bins), k % contacts + 1,
                 0.0 - map[k]});
  }
}

// One defect of the scan
Row row_of(double ratio, const TwoRuns<Scattering>& at) {
  const char *all = "fraction of all energy", *arriving = "fraction of the arriving energy";
  if (std::abs(at.fine.budget()) > 1e-7) throw Failure("the energy budget is open");
  return {
      {"ratio", "radius of the defect's beads divided by that of the others", ratio},
      {"linear_frequency", "frequency of the defect alone over that of the others",
       exact(article.array.linear_frequency(ratio)), "", "exact"},
      {"reflected", all, at.of([](const Scattering& s) { return s.with.reflected; })},
      {"near", all, at.of([](const Scattering& s) { return s.with.near; })},
      {"transmitted", all, at.of([](const Scattering& s) { return s.with.transmitted; }), "",
       "difference of two resolutions, against the largest"},
      {"on_defect", "fraction of all energy, on the defect itself",
       at.of([](const Scattering& s) { return s.with.on_defect; }), "",
       "difference of two resolutions, against the largest"},
      {"net_reflected", arriving, at.of([](const Scattering& s) { return s.net_reflected(); }), "",
       "difference of two resolutions, against the neighbouring rows: it is zero by "
       "definition without a defect"},
      {"net_near", arriving, at.of([](const Scattering& s) { return s.net_near(); })},
      {"net_transmitted", arriving, at.of([](const Scattering& s) { return s.net_transmitted(); }),
       "", "difference of two resolutions, against the largest"}};
}

void report_map(Report& report, const TwoSteps& steps) {
  // In eightieths, closer to each other around one
  std::vector<double> radii, larger;
  for (int k = 40; k <= 160; ++k)
    if (report.quick ? k % 5 == 0 : k % 2 == 0 || (k > 68 && k < 92))
      radii.push_back(double(k) / 80);
  for (int k = report.quick ? 25 : 21; k <= 25; ++k) larger.push_back(double(k) / 10);
  larger.insert(larger.end(), {3, 5, 10});

  const TwoRuns<EnergyShares> without = shares(article, 1, run_end, steps);
  const auto row = [&](double ratio) {
    return row_of(ratio, scattering(shares(article, ratio, run_end, steps), without));
  };
  report.table("large_defects").fill(larger, row, "large defects");
  Table& map = report.table("defect_map");
  map.fill(radii, row, "map of defects");

  // The radius that keeps most, from parabolas through three radii around the map's largest value
  const std::vector<double> near = map.numbers("near");
  const double best = radii[std::size_t(std::max_element(near.begin(), near.end()) - near.begin())];
  struct Most {
    double ratio, near;
  };
  const auto most = [&](double step) {
    Most out{.ratio = best, .near = 0};
    for (double apart : {0.0125, 0.004, 0.001}) {
      const auto at = [&](double ratio) { return scatter(article, ratio, run_end, step).near; };
      const Parabola top(at(out.ratio - apart), at(out.ratio), at(out.ratio + apart));
      out = {.ratio = out.ratio + top.vertex() * apart, .near = top.extremum()};
    }
    return out;
  };
  const TwoRuns<Most> both{most(steps.coarse), most(steps.fine)};
  report.table("most_near")
      .add({{"ratio", "radius with which most energy stays near the defect",
             both.of([](const Most& m) { return m.ratio; })},
            {"near", "this energy, over all", both.of([](const Most& m) { return m.near; })}});
}

/**
The fractions hang on the definition in their third digit. They count all energy that comes back or passes. The packet
alone, the eleven sites of Eq. (24), returns from 1.6 radii with [0.983](cell:packets/ratio=1.6/part) of the energy that
it had on its way at site 80, and passes 1.1 radii with [0.289](cell:packets/ratio=1.1/part).

## Energy trapped at the defect

The article sees a small part of the energy loosely trapped at 1.6 radii. A reflected packet leaves it on the incoming
side, so we add up the nine sites that end at the defect, and compare them with the nine before and with an array
without a defect. By 100 ms the transmitted packet would reach the end of the article's array, so ours has a hundred
beams more.

| fraction of all energy | article | 75 ms | 100 ms | 110 ms |
|---|---|---|---|---|
| 1.6 radii, sites 92 to 100 | small | [0.00389](cell:trapped/ratio=1.6/t=75/before) | [0.00337](cell:t=100/before) | [0.00317](cell:t=110/before) |
| 1.6 radii, sites 83 to 91 | | [0.00368](cell:trapped/ratio=1.6/t=75/next) | [0.00433](cell:t=100/next) | |
| no defect, sites 92 to 100 | | [0.00148](cell:trapped/ratio=1/t=75/before) | [0.00150](cell:t=100/before) | [0.00151](cell:t=110/before) |
| 1.6 radii, sites 96 to 104 | | [0.000768](cell:trapped/ratio=1.6/t=75/near) | [0.000558](cell:t=100/near) | [0.00051](cell:t=110/near) |
| 0.925 radii, sites 96 to 104 | | [0.0470](cell:trapped/ratio=0.925/t=75/near) | [0.0469](cell:t=100/near) | [0.0469](cell:t=110/near) |

At 1.6 radii the sites before the defect hold more than twice what the wave train leaves there, and lose it slowly, at a
steady rate, into the sites before them: energy is indeed loosely trapped. (At 110 ms the front of the wave train is
already on those.) Around the heavy defect itself there is less energy than without it. The light defect, in contrast,
keeps its energy. It does so in the motion that the linear estimate suggests: alone it has the frequency
[1.044](cell:light_defect/alone), and in the run, raised by its contacts, [1.106](cell:light_defect/in_run), close to
the packet's. Its neighbours, which without contact oscillate at 1, do not follow. */
constexpr std::size_t longer_by = 100;                     // beams
constexpr std::array<double, 3> trapped_at{75, 100, 110};  // ms

/**
## How well it is known

All numbers come from two runs, with steps of 0.1 and 0.05 in units of $\tau_c$, and the difference is the error. Figure
x54 shows that this is far from what limits them. The fractions converge with an
irregular order near 5, since contact events fall differently into the steps (`secA_integrators`). The force is read
from a parabola through three samples, one in each step, and is the least accurate. Certain is that none of this moves a
printed digit; definitions do, from the third digit on.

![Error of the results against the step. Drawn by x54_defect_convergence.gp, from `convergence`.](fig:x54)

Energy conservation alone does not prove the forces right, so an independent method, GSL's adaptive one of order eight,
also computes an array with a heavy defect near the impact, where the motion is strong, and must arrive at the same
state to $10^{-8}$, or the program stops. What is left is the model: a beam with its beads as one point mass (what that
costs is in `sec35_scales`), without torsion, higher modes and dissipation. */
void report_convergence(Report& report) {
  std::vector<double> steps{0.8, 0.4, 0.2, 0.1};
  if (report.quick) steps.resize(3);
  struct Results {
    double reflected, near, force;
  };
  const auto results = [](double step) {
    const WatchedRun run =
        pass(article, watched_site, packet_passed, {.step = step, .sample = step});
    return Results{.reflected = scatter(article, 1.1, run_end, step).reflected,
                   .near = scatter(article, 0.925, run_end, step).near,
                   .force = pulse_of(run.at, article.scales).force};
  };

  // Against a much shorter step
  const Results best = results(steps.back() / 4);
  const auto row = [&](double step) {
    const Results at = results(step);
    return Row{{"step", "largest step of the integration", step, "tau_c"},
               {"reflected", "error of the reflected fraction at 1.1 radii, relative",
                std::abs(at.reflected / best.reflected - 1)},
               {"near", "error of the fraction near a defect of 0.925 radii, relative",
                std::abs(at.near / best.near - 1)},
               {"force", "error of the largest force at n = 80, relative",
                std::abs(at.force / best.force - 1)}};
  };
  report.table("convergence").fill(steps, row, "steps");
}

// The same state by another method
void check_by_gsl() {
  StruckArray shorter = article;
  shorter.array.sites = 30;
  shorter.array.defect = 8;
  const Impact impact = shorter.impact({.ratio = 1.6, .until = 4, .sample = 100});
  const ImpactRun ours = strike(EventCorrected{0.0125}, impact);
  distance_from_reference(impact.chain, struck(impact.chain.sites, impact.velocity), impact.time,
                          ours.end, 1e-8);  // or it throws
}

void reproduce(Report& report) {
  const TwoSteps steps = report.quick ? of_quick_run : full;
  const TwoRuns<WatchedRun> homogeneous = watch(article, packet_passed, steps);
  report_packet(report, homogeneous);
  report_experiment(report, article, watched_site, homogeneous);
  report_speeds(report, article, watched_site, homogeneous);
  report_durations(report, article, homogeneous);
  report_wave_train(report, article, steps);
  report_forces(report);
  report_map(report, steps);
  report_packets(report, article, steps);
  StruckArray longer = article;
  longer.array.sites += longer_by;
  report_trapped(report, longer, {.times = trapped_at, .near_sites = near_sites}, steps);
  report_convergence(report);
  check_by_gsl();
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

**To change it.** Array, impact, the end of the run and the nine sites are the constants of the experiment; materials
and dimensions are further members of `.array`, such as `.length = 27e-3`. Let `run_end` follow the packet: it must have
passed the defect, and not yet the end. Two changed beams are two masses and three contacts in `cantilever_chain`
(cantilever.cpp).

1. *Easy.* How much does a slightly heavier defect transmit? `build/bin/sec36_cantilever_defect run --ratio 1.1` gives
   `net_transmitted` = 0.29443. Hint: its mass differs by an eighth, its own frequency only by six per cent.
2. *Harder.* Does a weaker packet pass it? `build/bin/sec36_cantilever_defect run --ratio 1.1 --velocity 0.5 --until 100`
   gives `net_transmitted` = 0.13607. Hint: the packet's frequency exceeds 1 by less, the detuning of the defect stays.
3. *Harder.* Which radius traps most? `build/bin/sec36_cantilever_defect run --ratio 0.925` gives `net_near` = 0.10858;
   with 0.934 it is 0.11622. Hint: the defect alone has the frequency 1.044, between 1 and the packet's 1.1.

`run` also takes `--sites` and `--defect`; it fails if the packet that passes reaches the far end. */
struct OneDefect {
  static constexpr Title title{
      "run", "one packet that meets a defect: reflected, remaining and transmitted energy"};
  double ratio = 1.6, velocity = article.velocity, until = run_end;
  std::size_t sites = article.array.sites, defect = article.array.defect;

  void parameters(Parameters& p) {
    p.add("ratio", ratio, "radius of the defect's beads divided by that of the others", {0.1, 10});
    p.add("velocity", velocity, "velocity of the impact on the first bead, in m/s",
          {0.1, 2, "m/s"});
    p.add("sites", sites, "number of cantilevers", {110, 1e4});
    p.add("defect", defect, "which of them is the defect", {20, 1e4});
    p.add("until", until, "end of the run after the impact, in ms", {10, 1000, "ms"});
  }
  Table table() const;
};

Table OneDefect::table() const {
  if (defect + 10 > sites) throw Failure("--defect must lie 10 sites before the end of the array");
  const StruckArray struck{.array = {.sites = sites, .defect = defect}, .velocity = velocity};
  TwoRuns<Scattering> at{};
  TwoRuns<WatchedRun> homogeneous{};
  try {
    at = scattering(shares(struck, ratio, until, full), shares(struck, 1, until, full));
    homogeneous = watch(struck, until, full);
  } catch (const FarEndReached&) {
    throw Failure("the packet that passes the defect reaches the end of the array within " +
                  short_text(until) + " ms: --sites " + std::to_string(sites) + " are too few");
  }
  const char *all = "fraction of the energy", *arriving = "fraction of the arriving energy";
  // The transmitted or reflected energy may be zero
  Answers q;
  q.add_small("reflected", at.of([](const Scattering& s) { return s.with.reflected; }), all,
              "energy of the sites up to the fifth before the defect, at the end");
  q.add_small("near", at.of([](const Scattering& s) { return s.with.near; }), all,
              "energy of the defect and four sites on either side, at the end");
  q.add_small("transmitted", at.of([](const Scattering& s) { return s.with.transmitted; }), all,
              "energy from the fifth site behind the defect, at the end");
  q.add_small("net_reflected", at.of([](const Scattering& s) { return s.net_reflected(); }),
              arriving, "what a defect adds to the energy before it, at the end");
  q.add_small("net_near", at.of([](const Scattering& s) { return s.net_near(); }), arriving,
              "energy near the defect, at the end");
  q.add_small("net_transmitted", at.of([](const Scattering& s) { return s.net_transmitted(); }),
              arriving, "energy behind the defect, at the end");
  q.add_small("budget", at.of([](const Scattering& s) { return s.budget(); }), "",
              "reflected + near + transmitted - 1, zero up to numerical errors");
  q.add("speed", homogeneous.of([&](const WatchedRun& run) {
    return mean_speed(run, struck, watched_site);
  }),
        "sites/s", "80 sites divided by the time of the largest force at n = 80, without a defect");
  // The constants of the defect, Eq. (32)
  q.add("mu", exact(struck.array.mu(ratio)), "",
        "effective mass of the defect divided by that of the other cantilevers, Eq. (32)");
  q.add("eta", exact(CantileverArray::eta(ratio)), "",
        "stiffness of the defect's two contacts divided by that of the others, Eq. (32)");
  q.add("linear_frequency", exact(struck.array.linear_frequency(ratio)), "1 / tau_c",
        "angular frequency of the isolated defect, without its contacts");
  return q.table;
}

int main(int argc, char** argv) {
  return run({"sec36_cantilever_defect", "3.6",
              "Decorated cantilevers and a defect that reflects (section 3.6)", reproduce,
              commands<OneDefect>()},
             argc, argv);
}
