/**
# 3.6 Scattering of a breather by a defect in an array of cantilevers

How does a defect scatter a travelling breather, in a system that one can build? Section 3.6 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) proposes an array of stiff beams, clamped at both ends, with a bead on either side of each.
We strike the first beam and compute how much energy a beam with larger or smaller beads reflects, transmits and keeps.
Heavy beads reflect the packet almost totally, as the article says, and so do much lighter ones. One number decides: how
far the defect is detuned from its neighbours, over the amount by which the packet oscillates faster than they do.
Only beads slightly smaller than the others trap a noticeable part of the energy.

       V      n = 1   2   3          99   100  101
      --->       o|o o|o o|o   ...   o|o  O|O  o|o   ...     two beads on each, which touch their neighbours
                  |   |   |           |    |    |
               ===+===+===+===========+====+====+===         clamped at both ends

![Contact forces after an impact, with larger beads at n = 100. Drawn by fig24_defect.py: `force` over `n` and `t`,
from `contact_forces`.](fig:24)

<!-- head -->
`build/bin/sec36_cantilever_defect` computes this chapter in 6 s on two cores and writes 15 tables to
`build/data/sec36_cantilever_defect`. Its figures: `make fig24`, `make x09`, `make x66`, `make x54`. With your
parameters: `run`, one packet that meets a defect: reflected, remaining and transmitted energy.
<!-- /head -->

## Model

A beam with its two beads is a mass $m_n$ on a spring, with one degree of freedom, the deflection $x_n$ of its middle;
neighbouring beads push on each other by Hertz's law. Lengths are measured in units of $\xi$, at which spring and
contact are equally strong, and times in units of $\tau_c$, the free period over $2\pi$. The array then obeys Eq. (32),
$$\mu_n\,\ddot y_n + y_n = -\eta_n\,(y_n-y_{n+1})_+^{3/2} + \eta_{n-1}\,(y_{n-1}-y_n)_+^{3/2},
  \qquad \dot y_n(0) = \lambda^{5/2}\,\delta_{n,1},$$
with free ends. At the defect, $n = 100$, the beads have $\tilde R$ times the radius of the others. Its mass is $\mu =
(m^*_{\rm beam} + 2\tilde R^3 m_{\rm bead})/(m^*_{\rm beam} + 2m_{\rm bead})$, with 0.38 of a beam's mass as $m^*_{\rm
beam}$, and its two contacts have the stiffness $\eta = [2\tilde R/(1+\tilde R)]^{1/2}$; elsewhere both are one. The
impact $V$ enters only through $\lambda$, Eqs. (28) to (30). `sec35_scales` explains why these arrays and not Newton's
cradle. In the program $\tilde R$ is `ratio`; cantilever.hpp has $\mu$, $\eta$ and the units. */
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
sites around it, or behind. Steps are event-corrected, and `strike` rejects a run whose far end moves. */
const StruckArray article{.array = {.sites = 200, .defect = 100}, .velocity = 1};  // m/s
constexpr double run_end = 75;                                                     // ms
constexpr std::size_t near_sites = 4;  // on either side of the defect
constexpr TwoSteps full{0.1, 0.05};    // units of tau_c
constexpr TwoSteps of_scans{0.2, 0.1}, of_quick_scans{0.3, 0.15};

/// Fractions of the energy of the impact, and where the foremost packet is, in sites.
struct Energies {
  double before, near, behind, on_defect, packet;
};

Energies scatter(const StruckArray& struck, const Impact& impact, double step) {
  const ImpactRun run = strike(EventCorrected{step}, impact);
  const auto energy = [&](std::size_t first, std::size_t last) {  // sites, counted from one
    const auto site = run.density.begin();
    return std::accumulate(site + std::ptrdiff_t(first - 1), site + std::ptrdiff_t(last), 0.0) /
           struck.energy();
  };
  const std::size_t defect = struck.array.defect, from = defect - near_sites,
                    to = defect + near_sites;
  return {.before = energy(1, from - 1),
          .near = energy(from, to),
          .behind = energy(to + 1, impact.chain.sites),
          .on_defect = energy(defect, defect),
          .packet = run.path.centre.back()};
}

TwoRuns<Energies> energies(const StruckArray& struck, const Impact& impact, const TwoSteps& steps) {
  return {scatter(struck, impact, steps.coarse), scatter(struck, impact, steps.fine)};
}

/**
More than half of the energy never reaches the defect within this time: it is in the wave train near the struck end. We
therefore repeat each run without a defect. What is behind site 95 then, we call the arriving energy, and refer the
*net* fractions to it: the excess before the defect is *reflected*, the rest is near the defect or *transmitted*. The
wave train leaves a little near the defect in any case, which is not subtracted; figure x09 marks it. For this to have a
meaning the packet must have met the defect: without one it must end a packet's width, 11 sites, beyond the nine. */
struct Scattering {
  Energies with, without;  // the defect

  double arriving() const { return 1 - without.before; }
  double reflected() const { return (with.before - without.before) / arriving(); }
  double kept() const { return with.near / arriving(); }
  double transmitted() const { return with.behind / arriving(); }
  double budget() const { return with.before + with.near + with.behind - 1; }
};

TwoRuns<Scattering> net(const StruckArray& struck, const TwoRuns<Energies>& with,
                        const TwoRuns<Energies>& without) {
  const std::size_t beyond = struck.array.defect + near_sites + 2 * packet_half_width + 1;
  if (without.fine.packet < double(beyond))
    throw Failure("the packet has not passed the defect: without it, it would end at site " +
                  std::to_string(int(without.fine.packet)) + " and not yet at " +
                  std::to_string(beyond));
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

The printed force and the printed period of weak breathers are ours, truncated. The last two rows are what the article's
conclusion expects within 10 ms, the lifetime of breathers in diatomic chains; `sec5_experiment` adds damping. */
constexpr std::size_t watched_site = 80;
constexpr double packet_passed = 60;  // ms

double frequency_of(const WatchedRun& run) {  // in units of that of a beam alone
  const Scales& scales = article.scales;
  return 2 * std::numbers::pi * scales.tau_c() / pulse_of(run.at, scales).period;
}

TwoRuns<WatchedRun> watch(const StruckArray& struck, double until, const TwoSteps& steps) {
  return {pass(struck, watched_site, until, {steps.coarse, steps.coarse}),
          pass(struck, watched_site, until, {steps.fine, steps.fine})};
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
       {"frequency", "linear period over internal one", runs.of(frequency_of)}});
}

/**
Speed and duration depend on their definition, which the article does not print. The packet radiates and slows down, so
the slope of the energy centre $X(t)$, by which section 3.4 measures speeds, depends on the stretch; from 20 to 40 it
gives the printed number. The *duration* lasts from the first to the last instant at which the force exceeds a fraction
of its maximum; a thousandth of the force is a hundredth of the compression. `sec36/definitions.cpp` has the variants.

| definition | speed, sites/s | definition | duration, ms |
|---|---|---|---|
| slope between sites 20 and 60 | [1999](cell:speeds/from=20/to=60/speed) | force above 0.5 | [1.17](cell:durations/above=0.5/duration) |

The boundary emits a wave train, too. Just before the packet meets the defect the train has
[0.562](cell:wave_train/at=defect/share) of the energy, on [32.1](cell:wave_train/at=defect/sites) sites by its
participation number $(\sum e_n)^2/\sum e_n^2$; the packet's own number is [2.71](cell:wave_train/at=defect/packet).

## What decides (figure x66)

While its contacts are open a beam swings alone, at the frequency $\mu_n^{-1/2}$. Contacts without compression have no
linear stiffness. So the linearised array has no band of waves but two frequencies only, 1 and that of the defect, and
no linear theory of scattering: all transport is nonlinear. The contacts push a beam back, which raises its frequency
with the amplitude, in the packet by 0.10. In the DpS equation (`sec31_dps_limit`) one term does this and carries energy
from beam to beam; a defect adds its detuning $\mu^{-1/2}-1$ as a frequency of its own. Only the ratio of the two can
then matter, detuning over frequency shift, as long as the equation holds.

![Transmitted energy against the detuning of the defect over the frequency shift of the packet. Drawn by
x66_detuning_law.gp: `transmitted` over `scaled` from `impacts`.](fig:x66)

It is so: after impacts of 0.5, 1 and 2 m/s the fractions fall nearly on one curve, for light defects as for heavy ones,
on which half is transmitted where the detuning is 0.4 of the shift. The stiffness of its contacts, which differs by 2
per cent, matters little: with $\eta = 1$ a defect of 1.1 radii transmits [0.263](cell:equal_contacts/transmitted) and
not 0.294. */
void report_law(Report& report, const TwoSteps& steps) {
  const std::vector<double> impacts{0.5, 1, 2};  // m/s
  std::vector<double> radii{0.8, 0.85, 0.9, 0.95, 1.05, 1.1, 1.15, 1.2};
  if (report.quick) radii = {0.9, 1.1};
  const auto passed = [](const Scattering& s) { return s.transmitted(); };
  Table& table = report.table("impacts");
  for (double velocity : impacts) {
    StruckArray struck = article;
    struck.velocity = velocity;
    const double slower = std::sqrt(article.velocity / velocity);  // about
    const auto impact = [&](double ratio) {
      return struck.impact({.ratio = ratio, .until = run_end * slower});
    };
    const auto without = energies(struck, impact(1), steps);
    const TwoRuns<WatchedRun> packet = watch(struck, packet_passed * slower, full);
    const auto row = [&](double ratio) -> Row {
      const auto at = net(struck, energies(struck, impact(ratio), steps), without);
      const double detuning = struck.array.linear_frequency(ratio) - 1;
      return {
          {"velocity", "of the impact", velocity, "m/s"},
          {"ratio", "radius of the defect's beads divided by that of the others", ratio},
          {"scaled", "detuning of the defect over the frequency shift of the packet",
           packet.of([&](const WatchedRun& run) { return detuning / (frequency_of(run) - 1); })},
          {"transmitted", "fraction of the arriving energy", at.of(passed)}};
    };
    table.fill(radii, row, "impacts");

    // With the mass of the defect alone
    if (velocity != article.velocity) continue;
    Impact heavy = impact(1.1);
    heavy.chain.eta.assign(heavy.chain.eta.size(), 1);
    report.table("equal_contacts")
        .add(Row{{"transmitted", "fraction of the arriving energy, 1.1 radii, eta = 1",
                  net(struck, energies(struck, heavy, steps), without).of(passed)}});
  }
}

/**
## Which defects reflect (figures 24 and x09)

In the article's array the frequency shift is 0.10, so all but defects within some 15 per cent of the radius reflect. At
0.8 radii the defect alone has the packet's own frequency and still reflects nearly all: for what is transmitted the
distance from the frequency of the neighbours counts. But it holds twice as much energy as its neighbours in the map, at
0.75 and 0.85 radii.

| radius | defect alone, $\mu^{-1/2}$ | reflected | near the defect | transmitted | article |
|---|---|---|---|---|---|
| 0.8 | [1.113](cell:defect_map/ratio=0.8/linear_frequency) | [0.945](cell:net_reflected) | [0.0142](cell:net_near) | [0.0406](cell:net_transmitted) | |
| 0.925 | [1.044](cell:defect_map/ratio=0.925/linear_frequency) | [0.436](cell:net_reflected) | [0.109](cell:net_near) | [0.456](cell:net_transmitted) | |
| 1 | 1 | 0 | [0.0032](cell:defect_map/ratio=1/net_near) | [0.997](cell:net_transmitted) | |
| 1.1 | [0.94](cell:defect_map/ratio=1.1/linear_frequency) | [0.704](cell:net_reflected) | [0.0019](cell:net_near) | [0.294](cell:net_transmitted) | partial reflection |
| 1.6 | [0.671](cell:defect_map/ratio=1.6/linear_frequency) | [0.9965](cell:net_reflected) | [0.0018](cell:net_near) | [0.0017](cell:net_transmitted) | almost total |
| 5 | [0.1414](cell:large_defects/ratio=5/linear_frequency) | [0.9984](cell:net_reflected) | [0.0016](cell:net_near) | | almost total |
| 10 | [0.0503](cell:large_defects/ratio=10/linear_frequency) | [0.9926](cell:net_reflected) | [0.0074](cell:net_near) | | almost total |

A surprise: beads of 10 radii, almost a wall, reflect *less* than those of 5. What they do not reflect is on the defect
itself, [0.0025](cell:large_defects/ratio=10/on_defect) of all energy. Figure 24 shows, as in the article, the contact
forces $f_n = -\gamma_n(x_n-x_{n+1})_+^{3/2}$; since a contact opens in each internal period, we draw the strongest
force within intervals of about two linear periods.

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
                 0.0 - map[k]});  // not the negative zero of an open contact
  }
}

// What is computed of one defect
struct Fraction {
  const char *name, *meaning;
  Estimate value;
};

std::vector<Fraction> fractions(const TwoRuns<Scattering>& at) {
  if (std::abs(at.fine.budget()) > 1e-7) throw Failure("the energy budget is open");
  using S = Scattering;
  return {
      {"reflected", "of all energy, before the defect",
       at.of([](const S& s) { return s.with.before; })},
      {"near", "of all energy, on the nine sites", at.of([](const S& s) { return s.with.near; })},
      {"transmitted", "of all energy, behind them",
       at.of([](const S& s) { return s.with.behind; })},
      {"on_defect", "of all energy, on the defect itself",
       at.of([](const S& s) { return s.with.on_defect; })},
      {"net_reflected", "of the arriving energy", at.of([](const S& s) { return s.reflected(); })},
      {"net_near", "of the arriving energy", at.of([](const S& s) { return s.kept(); })},
      {"net_transmitted", "of the arriving energy",
       at.of([](const S& s) { return s.transmitted(); })}};
}

void report_map(Report& report, const TwoSteps& steps) {
  const auto impact = [](double ratio) {
    return article.impact({.ratio = ratio, .until = run_end});
  };
  const TwoRuns<Energies> without = energies(article, impact(1), steps);
  const auto row = [&](double ratio) {
    Row out{{"ratio", "radius of the defect's beads divided by that of the others", ratio},
            {"linear_frequency", "frequency of the defect alone over that of the others",
             exact(article.array.linear_frequency(ratio)), "", "exact"}};
    for (const auto& part :
         fractions(net(article, energies(article, impact(ratio), steps), without)))
      out.cells.push_back({part.name, part.meaning, part.value, "",
                           "difference of two resolutions, against the largest"});
    return out;
  };
  report.table("large_defects").fill(std::array{2.1, 2.5, 3.0, 5.0, 10.0}, row, "large defects");
  // Radii in eightieths, all of them close to one
  std::vector<double> radii;
  for (int k = 40; k <= 160; ++k)
    if (k % 4 == 0 || (!report.quick && std::abs(k - 80) < 12)) radii.push_back(double(k) / 80);
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
      const auto at = [&](double ratio) { return scatter(article, impact(ratio), step).near; };
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
The fractions depend on their definition in the third digit. They count all energy that comes back or passes. The packet
alone, the eleven sites of Eq. (24), returns from 1.6 radii with [0.983](cell:packets/ratio=1.6/part) of the energy that
it had on its way at site 80, and passes 1.1 radii with [0.289](cell:packets/ratio=1.1/part).

## Energy trapped at the defect

The article sees a small part of the energy loosely trapped at 1.6 radii. A reflected packet leaves it on the incoming
side, so we add up the nine sites that end at the defect, also without a defect and 25 ms later. By then the transmitted
packet would reach the end of the article's array, so ours has a hundred beams more.

| fraction of all energy | article | 75 ms | 100 ms |
|---|---|---|---|
| 1.6 radii, sites 92 to 100 | small | [0.00389](cell:trapped/ratio=1.6/t=75/before) | [0.00337](cell:t=100/before) |
| no defect, sites 92 to 100 | | [0.00148](cell:trapped/ratio=1/t=75/before) | [0.00150](cell:t=100/before) |
| 0.925 radii, sites 96 to 104 | | [0.0470](cell:trapped/ratio=0.925/t=75/near) | [0.0469](cell:t=100/near) |

At 1.6 radii the sites before the defect hold more than twice what the wave train leaves there, and lose it slowly, as
the article says of energy that is loosely trapped. We cannot tell it from the end of the reflected packet: sites 83 to
91 hold as much at that time (column `next`). The light defect keeps its energy, two thirds of it on the defect itself
([0.0307](cell:defect_map/ratio=0.925/on_defect)). Alone it has the frequency [1.044](cell:light_defect/alone), and in
the run, raised by its contacts, [1.106](cell:light_defect/in_run), close to the packet's. So it can take up energy from
the packet, and when this has gone the neighbours, which without contact oscillate at 1, are out of tune. */
constexpr std::array<double, 2> trapped_at{75, 100};  // ms

/**
## How well it is known

All numbers come from two runs, with steps of 0.1 and 0.05 in units of $\tau_c$ (0.2 and 0.1 in the scans), and the
difference is the error. The fractions converge, at no steady order (figure x54), since contact events fall differently
into the steps (`secA_integrators`). The force is read from a parabola through three samples, one in each step, and is
the least accurate. None of this moves a printed digit; definitions do.

![Error of the results against the step. Drawn by x54_defect_convergence.gp, from `convergence`.](fig:x54)

GSL's adaptive method of order eight must arrive at the same state to $10^{-8}$ for an array with a heavy defect near
the impact, or the program stops. What is left is the model: a beam with its beads as one point mass (`sec35_scales`),
without torsion, higher modes and dissipation. */
void report_convergence(Report& report) {
  std::vector<double> steps{1. / 2, 1. / 3, 1. / 4, 1. / 5, 1. / 8};
  if (report.quick) steps.resize(4);
  const auto results = [](double step) -> std::array<double, 3> {
    const auto at = [&](double ratio) {
      return scatter(article, article.impact({.ratio = ratio}), step);
    };
    const WatchedRun run = pass(article, watched_site, packet_passed, {step, step});
    return {at(1.1).before, at(0.925).near, pulse_of(run.at, article.scales).force};
  };
  const auto best = results(report.quick ? 0.05 : 0.025);
  const auto row = [&](double step) {
    const auto at = results(step);
    const auto error = [&](std::size_t k) { return std::abs(at[k] / best[k] - 1); };
    return Row{{"step", "largest step of the integration", step, "tau_c"},
               {"reflected", "error of the energy before 1.1 radii, relative", error(0)},
               {"near", "error of the energy near 0.925 radii, relative", error(1)},
               {"force", "error of the largest force at n = 80, relative", error(2)}};
  };
  report.table("convergence").fill(steps, row, "steps");
}

// An independent route
void check_by_gsl() {
  const StruckArray shorter{.array = {.sites = 30, .defect = 8}};
  const Impact impact = shorter.impact({.ratio = 1.6, .until = 4, .sample = 100});
  const ImpactRun ours = strike(EventCorrected{0.0125}, impact);
  distance_from_reference(impact.chain, struck(impact.chain.sites, impact.velocity), impact.time,
                          ours.end, 1e-8);  // or it throws
}

void reproduce(Report& report) {
  const TwoSteps steps = report.quick ? of_scans : full,
                 scans = report.quick ? of_quick_scans : of_scans;
  const TwoRuns<WatchedRun> homogeneous = watch(article, packet_passed, steps);
  report_packet(report, homogeneous);
  report_experiment(report, article, watched_site, homogeneous);
  report_speeds(report, article, watched_site, homogeneous);
  report_durations(report, article, homogeneous);
  report_wave_train(report, article, steps);
  report_law(report, scans);
  report_forces(report);
  report_map(report, scans);
  report_packets(report, article, steps);
  StruckArray longer = article;
  longer.array.sites += 100;
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
| `cantilever.total_reflection`: almost total reflection occurs for sufficiently large defects | almost total | large_defects.net_reflected (ratio = 5): 0.9984 < 1 (the closest of 28) | holds |
<!-- /statements -->

## Try it

**To change it.** Array, impact, the end of the run and the nine sites are the constants of the experiment; materials
and dimensions are further members of `.array`, such as `.length = 27e-3`. Let `run_end` follow the packet: the program
stops unless the packet has passed the defect and not yet reached the end. For two changed beams, or for a disordered
array, change `mass`, `inverse_mass` and `eta` of an `Impact::chain` before `scatter`, as `report_law` changes `eta`.

1. *Easy.* How much does a slightly heavier defect transmit? `build/bin/sec36_cantilever_defect run --ratio 1.1` gives
   `net_transmitted` = 0.29443. Hint: the table of radii has this row.
2. *Harder.* Does a weaker packet pass it? `build/bin/sec36_cantilever_defect run --ratio 1.1 --velocity 0.5 --until 100`
   gives `net_transmitted` = 0.13607. Hint: the packet's frequency exceeds 1 by less, the detuning of the defect stays.

`run` also takes `--sites` and `--defect`; it refuses a packet that has not passed the defect or reaches the far end. */
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
  try {
    const auto run = [&](double radius) {
      return energies(struck, struck.impact({.ratio = radius, .until = until}), full);
    };
    at = net(struck, run(ratio), run(1));
  } catch (const FarEndReached&) {
    throw Failure("the packet that passes the defect reaches the end of the array within " +
                  short_text(until) + " ms: --sites " + std::to_string(sites) + " are too few");
  }
  Answers q;
  for (const auto& part : fractions(at))  // each may be zero within its error
    q.add_small(part.name, part.value, "fraction", part.meaning);
  return q.table;
}

int main(int argc, char** argv) {
  return run({"sec36_cantilever_defect", "3.6",
              "Decorated cantilevers and a defect that reflects (section 3.6)", reproduce,
              commands<OneDefect>()},
             argc, argv);
}
