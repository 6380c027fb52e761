/**
# 3.6 Decorated cantilevers, and a defect that reflects

In a cradle a collision is over long before a pendulum has moved, so no travelling breather can be
seen (`sec35_scales`). Section 3.6 of James, Kevrekidis and Cuevas (Physica D 251, 2013) proposes stiff
cantilevers with beads instead, one of them with larger beads:

       V      n = 1   2   3          99   100  101
      --->       o|o o|o o|o   ...   o|o  O|O  o|o   ...     two beads on each, which touch their neighbours
                  |   |   |           |    |    |
               ===+===+===+===========+====+====+===         clamped at both ends

![Contact forces after an impact, with larger beads at n = 100.](fig:24)

We strike the array and send the packet to the defect. */

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/dps/dps_impact.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "report/sweep.hpp"
#include "sec3/array_impact.hpp"
#include "sec36/scattering.hpp"
#include "sec36/trapped_mode.hpp"

using namespace lattice;

/**
## Plan

The array is struck at its first cantilever. We watch the packet pass the eightieth, in metres, newtons and milliseconds,
and compare it with what the DpS equation predicts. Then it meets the hundredth, whose beads are larger: how much of its
energy comes back, how much passes, and how much stays, for beads of any size? Some of what stays is caught in a
vibration of the defect (sec36/trapped_mode.hpp). The last sections ask what an experiment would see. */
constexpr std::size_t watched_site = 80;

/**
## Model

A cantilever with beads of radius $R_n$ has one degree of freedom, its largest deflection $x_n$. With
$\xi$ as the unit of length and $\tau_c$ as that of time the array obeys Eq. (32),
$$\mu_n\,\ddot y_n + y_n = -\eta_n\,(y_n-y_{n+1})_+^{3/2} + \eta_{n-1}\,(y_{n-1}-y_n)_+^{3/2},$$
with $\mu_n = m_n/m$ and both ends free. The first cantilever starts with the velocity $V$, Eq. (28),
which is $\lambda^{5/2}$ in these units, Eq. (29). All radii but that at $n = 100$ are equal.

| article | program | meaning | unit |
|---|---|---|---|
| $\tau_h$, $\tau_c$ | `Scales` | times of a collision and of the linear oscillation | s |
| $\xi$, $\lambda$ | `Scales` | where contact and linear force are equal; $(\tau_c/\tau_h)^2$, Eq. (30) | m, 1 |
| $\mu_n$, $\eta_n$ | `mu`, `eta` | mass and contact stiffness, relative | 1 |
| $\tilde R_{100}$ | `ratio` | radius of the defect's beads over that of the others | 1 |
| $V$ | `velocity` | impact velocity | m/s |

The constants are derived in cantilever.hpp. Hertz's coefficient needs the Young modulus of the
beads, $\gamma = \mathcal E\sqrt{2R}/(3(1-\nu^2))$; the article prints the symbol of the beam's. */
constexpr double shown_until = 75;  // ms

/**
## The packet at $n = 80$

The article prints six numbers and says of one how it was measured: in section 3.4 a speed is the slope of
the least-squares line through the energy centre $X(t)$, far enough from the boundary. For the others we need
definitions. We watch site $n$ and the contact between $n$ and $n+1$ at closely spaced times (pulse.hpp). The
*period* is half the time between the pushes before and after the strongest. The *duration* is the time from the
first to the last instant at which the force is a given share of its maximum.

Neither the stretch of the line nor this share is printed, and both matter. The packet slows down on its way, so
that later stretches are slower; the table `speeds` has eight of them. The duration grows by one internal period at
a time as its threshold is lowered, and the table `durations` has ten thresholds. Both are read in the article's
favour: sites 20 to 40, which begin where our fits of section 3.4 do, and a thousandth of the largest force. (Five
stretches and a single threshold, a hundredth, are too few to say that no natural one gives the printed numbers.)
The mean over the whole way, $n$ over the time of the largest force at $n$, needs no centre at all. */
constexpr Resolution rough{0.1, 0.1}, fine{0.05, 0.05};
using WatchedRuns = std::array<WatchedRun, 2>;

WatchedRuns pass_twice(const StruckArray& blow) {
  WatchedRuns runs;
  parallel_for(2, [&](std::size_t i) { runs[i] = pass(blow, watched_site, 60, i ? fine : rough); });
  return runs;
}

template <class Of>
Estimate both(const WatchedRuns& runs, Of of) {
  return compare(of(runs[0]), of(runs[1]));
}

/// Least-squares speed between two sites, in sites per second.
Estimate speed_between(const WatchedRuns& runs, const StruckArray& blow, double from, double to) {
  return both(runs, [&](const WatchedRun& run) {
    return run.track.line(from, to)->slope / blow.scales.tau_c();
  });
}

void report_packet(Report& report, const StruckArray& blow, const WatchedRuns& runs) {
  // Read off at n = 80
  const auto answer = [&](const char* id, double Pulse::*of, double unit, const char* text) {
    const auto value = [&](const WatchedRun& run) {
      return pulse_of(run.at, blow.scales).*of * unit;
    };
    report.results.add(id, both(runs, value), text);
  };
  answer("cantilever.bead_velocity", &Pulse::velocity, 1, "m/s");
  answer("cantilever.deflection", &Pulse::deflection, 1e6, "um");
  answer("cantilever.force", &Pulse::force, 1, "N");
  answer("cantilever.period", &Pulse::period, 1e3, "ms");
  report.results.add("cantilever.frequency", both(runs, [&](const WatchedRun& run) {
                       return 2 * std::numbers::pi * blow.scales.tau_c() /
                              pulse_of(run.at, blow.scales).period;
                     }));

  // The speed on several stretches, and as a mean over the way
  Table& speeds = report.table("speeds", {number("from", "site where the stretch begins", "site"),
                                          number("to", "site where it ends", "site"),
                                          estimate("speed", "of the packet", "sites/s")});
  for (const auto& [from, to] : {std::pair{10.0, 40.0},
                                 {10, 60},
                                 {15, 45},
                                 {20, 40},
                                 {20, 60},
                                 {20, 80},
                                 {20, 100},
                                 {60, 100}})
    speeds.add({from, to, speed_between(runs, blow, from, to)});
  const Estimate mean =
      both(runs, [&](const WatchedRun& run) { return mean_speed(run, blow, watched_site); });
  report.results.add("cantilever.speed", speed_between(runs, blow, 20, 40), "sites/s");
  report.facts.add("speed_10_to_40", speed_between(runs, blow, 10, 40), "sites/s");
  report.facts.add("speed_20_to_60", speed_between(runs, blow, 20, 60), "sites/s");
  report.facts.add("speed_60_to_100", speed_between(runs, blow, 60, 100), "sites/s");
  report.facts.add("speed_mean", mean, "sites/s");

  // The duration with several thresholds
  Table& durations = report.table(
      "durations", {number("threshold", "force over its maximum at n = 80"),
                    estimate("duration", "time between first and last crossing", "ms")});
  const auto above = [&](double share) {
    return both(runs, [&](const WatchedRun& run) { return duration_above(run, blow, share); });
  };
  for (double share : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4})
    durations.add({share, above(share)});
  report.results.add("cantilever.duration", above(1e-3), "ms");
  report.facts.add("duration_half", above(0.5), "ms");
  report.facts.add("duration_hundredth", above(0.01), "ms");
  report.facts.add("duration_two_thousandth", above(5e-4), "ms");
  report.facts.add("energy_drift",
                   both(runs, [](const WatchedRun& run) { return run.run.energy_drift; }));
}

/**
Between sites 20 and 40 the speed is [2029.69](num:cantilever.speed) sites/s, the printed 2030. On the eight stretches it
goes from [2073.54](num:sec36_cantilever_defect.speed_10_to_40), between sites 10 and 40, to
[1937.80](num:sec36_cantilever_defect.speed_60_to_100) beyond 60; from 20 to 60 it is
[1998.60](num:sec36_cantilever_defect.speed_20_to_60), and the mean over the whole way is
[2029.93](num:sec36_cantilever_defect.speed_mean). The duration above a thousandth of the largest force is
[3.78752](num:cantilever.duration) ms, which would be printed as 3.8; it is
[1.17055](num:sec36_cantilever_defect.duration_half) ms above a half,
[3.06486](num:sec36_cantilever_defect.duration_hundredth) above a hundredth and
[3.94122](num:sec36_cantilever_defect.duration_two_thousandth) above a two-thousandth.

## Is this the DpS regime? (`cantilever.dps_valid`)

The article infers from $\lambda \approx 0.29$ that the DpS equation, Eq. (12), is valid in the homogeneous
part of the array. We strike the DpS chain, Eq. (25), with $\epsilon = \lambda^{5/2}/2$ and measure its
packet at $n=80$ as that of the array: the largest deflection $2\epsilon\,|A_{80}|$, and the speed between
sites 20 and 60. The relative error of the deflection answers the claim. */
void report_dps(Report& report, const StruckArray& blow, const WatchedRuns& runs) {
  const double eps = blow.struck_velocity() / 2, tau = 320;
  const Dps dps{150};
  std::array<double, 2> deflection, speed;
  parallel_for(2, [&](std::size_t k) {
    std::vector<double> at, amplitude;
    const auto watch = [&](double now, const Field& field) {
      at.push_back(now);
      amplitude.push_back(std::abs(field[watched_site - 1]));
    };
    const DpsOutcome out =
        follow_dps(dps, dps_impact(dps.sites), tau, k ? 2560 : 1280, k ? 1e-10 : 1e-8, watch);
    deflection[k] = 2 * eps * largest_modulus(at, amplitude);
    speed[k] = out.track.line(20, 60)->slope * std::sqrt(eps);
  });
  // The same two numbers of the array, in units of xi and tau_c
  const Estimate largest =
      both(runs, [](const WatchedRun& run) { return largest_modulus(run.at.t, run.at.y); });
  const Estimate array_speed =
      both(runs, [](const WatchedRun& run) { return run.track.line(20, 60)->slope; });
  const Estimate by_deflection = quotient(compare(deflection[0], deflection[1]), largest);
  const Estimate by_speed = quotient(compare(speed[0], speed[1]), array_speed);
  report.results.add("cantilever.dps_valid", {by_deflection.value - 1, by_deflection.error});
  report.facts.add("dps_speed_apart", {by_speed.value - 1, by_speed.error});
}

/**
The DpS packet deflects the cantilever by a fraction of [0.149806](num:cantilever.dps_valid) more than that of the
array does and is faster by [0.11218](num:sec36_cantilever_defect.dps_speed_apart).

## Contact forces (figure 24)

The article draws $f_n = -\gamma_n(x_n-x_{n+1})_+^{3/2}$ in newtons over space and time. A contact is open for about
half of each internal period, so that a snapshot says little; we keep the strongest force within intervals of about
two linear periods.

![Contact forces for beads of 1.6 and of 1.1 radii at n = 100.](fig:24) */
void report_forces(Report& report, const StruckArray& blow, std::size_t bins) {
  Table& table =
      report.table("contact_forces",
                   {number("ratio", "radius of the defect's beads over the others'"),
                    number("t", "middle of the time interval", "ms"),
                    count("n", "contact of cantilevers n and n + 1", "site"),
                    number("force", "strongest contact force in the interval, negative", "N")});
  const std::size_t contacts = blow.array.sites - 1;
  const double ratios[] = {1.6, 1.1};
  std::array<std::vector<double>, 2> maps;
  parallel_for(
      2, [&](std::size_t i) { maps[i] = strongest_forces(blow, ratios[i], shown_until, bins); });
  for (std::size_t i : {0, 1})
    for (std::size_t k = 0; k < bins * contacts; ++k)
      table.add({ratios[i], (double(k / contacts) + 0.5) * shown_until / double(bins),
                 k % contacts + 1, 0.0 - maps[i][k]});
}

/**
## Where the energy goes (figure x09)

The words "almost total" call for numbers. At 75 ms the packet has left the defect, and we divide the
energy into what is on the sites up to 95 (reflected), from 96 to 104 (near the defect) and beyond
(transmitted). Over half of it, [0.566749](num:sec36_cantilever_defect.left_behind), has not got so far by
then: it is in the wave train of the boundary; the *net* shares count only what arrives
(scattering.hpp). The three must add up to one; the excess is the error of the *energy budget*. The radius of
the defect's beads varies by a factor of four, their mass by one of 64. The points are independent: `map --part k/n`
computes a part of them, an interrupted map goes on where it stopped, and the full run collects what
the parts have left in the folder (sweep.hpp).

![Reflected, remaining and transmitted energy against the radius of the defect.](fig:x09) */
std::vector<double> map_radii(bool quick) {
  std::vector<double> radii;
  for (int k = 40; k <= 160; ++k)  // in eightieths
    if (quick ? k % 10 == 0 : k % 2 == 0 || (k > 68 && k < 92)) radii.push_back(double(k) / 80);
  return radii;
}

Sweep map_sweep(const std::filesystem::path& folder, bool quick) {
  Columns columns{number("ratio", "radius of the defect's beads over the others'"),
                  number("mu", "effective mass of the defect over the others'"),
                  number("linear_frequency", "of the defect, over that of the others")};
  for (const auto& share : Fractions{}.named())
    columns = {columns, estimate(share.name, std::string(share.unit) + ", see the chapter", "",
                                 std::string("difference of two resolutions") + share.judged)};
  columns = {columns, number("budget", "sum of the three shares less one")};
  return {folder, "defect_map", columns.all, map_radii(quick).size(),
          std::string("defect map, velocity 1 m/s, ") + (quick ? "quick" : "full")};
}

/**
Every point is computed with two steps, and the energy budget shows whether the smaller one suffices. */
ScatteringSetup setup_for(const StruckArray& blow, bool quick) {
  if (quick) return {blow, {0.2, 0.1}, shown_until};
  return {blow, {0.1, 0.05}, shown_until};
}

void compute_map(Sweep& sweep, const ScatteringSetup& setup, bool quick, Part part) {
  const CantileverArray& array = setup.blow.array;
  const std::vector<double> radii = map_radii(quick);
  sweep.compute(part, [&](std::size_t i) {
    const Fractions f = fractions(setup, radii[i]);
    Cells row{radii[i], array.mu(radii[i]), array.linear_frequency(radii[i])};
    for (const auto& named : f.named())
      row.insert(row.end(), {named.share.value, named.share.error});
    row.push_back(f.budget.value);
    return row;
  });
}

/**
To decide the claims we call a reflection *almost total* if more than 95 per cent of what arrives is
reflected, and *partial* if between a tenth and nine tenths of it is transmitted. The shares change smoothly from one
radius of the map to the next, and heavy and light defects reflect. That their own frequencies are far from the
packet's is not the reason, or not the only one: at 0.8 radii the two agree to about one per cent, and more than nine
tenths are reflected. [](finding:defect.map)

What the packet leaves behind, the fairly extended wave train of `cantilever.wavetrain`, has no number in the article.
Just before the packet meets the defect we take the sites up to ten behind its largest one, as in section 3.4. They
hold a share of [0.562407](num:sec36_cantilever_defect.wavetrain_share) of the energy, and by their participation number
[32.1373](num:cantilever.wavetrain) of them share it. */
Estimate in_train(const ScatteringSetup& setup, double (*of)(const std::vector<double>&)) {
  const auto train = [&](const std::vector<double>& density) {
    return of({density.begin(), density.begin() + std::ptrdiff_t(*front_packet(density)) - 10});
  };
  return compare(train(setup.start[0].density), train(setup.start[1].density));
}

void report_shares(Report& report, const ScatteringSetup& setup) {
  const Fractions large = fractions(setup, 1.6), slight = fractions(setup, 1.1);
  judge(report, "cantilever.reflect16", almost_total(large.net_reflected));
  judge(report, "cantilever.partial11", partial(slight.net_transmitted));
  const std::pair<std::string, const Fractions&> rows[] = {{"_16", large}, {"_11", slight}};
  for (const auto& [name, f] : rows) {
    for (const auto& named : f.named())
      report.facts.add(named.name + name, named.share, named.unit);
    report.facts.add("budget" + name, f.budget);
  }
  report.facts.add("left_behind", compare(setup.without[0].reflected, setup.without[1].reflected),
                   "share of the energy");
  const double struck = setup.blow.struck_velocity();
  const Estimate train = in_train(setup, total);
  report.results.add("cantilever.wavetrain",
                     in_train(setup, [](const auto& e) { return participation(e); }), "site");
  report.facts.add("wavetrain_share", quotient(train, exact(struck * struck / 2)),
                   "share of the energy");
}

/**
*Almost total reflection occurs* for large defects (`cantilever.total_reflection`): from 1.6 radii, where the article
shows it, to 2.5 every defect must reflect more than 95 per cent. The map has the radii up to two, the table
`large_defects` those beyond, and three more that show where this leads: at five radii
[2.99728e-9](num:sec36_cantilever_defect.net_transmitted_5) of what arrives is transmitted. */
void report_large(Report& report, const ScatteringSetup& setup, const Table& map) {
  std::vector<Estimate> reflected;
  const auto ratio = map.numbers("ratio"), share = map.numbers("net_reflected"),
             error = map.numbers("net_reflected_error");
  for (std::size_t i = 0; i < ratio.size(); ++i)
    if (ratio[i] >= 1.6) reflected.push_back({share[i], error[i]});
  const std::vector<double> radii =
      report.quick ? std::vector{2.5, 5.0} : std::vector{2.1, 2.2, 2.3, 2.4, 2.5, 3.0, 4.0, 5.0};
  std::vector<Fractions> large(radii.size());
  parallel_for(radii.size(), [&](std::size_t i) { large[i] = fractions(setup, radii[i]); });
  Table& table =
      report.table("large_defects",
                   {number("ratio", "radius of the defect's beads over the others'"),
                    estimate("net_reflected", "share of what arrives, see the chapter"),
                    estimate("net_transmitted", "share of what arrives, see the chapter", "",
                             "difference of two resolutions, against the net reflected share")});
  for (std::size_t i = 0; i < radii.size(); ++i) {
    table.add({radii[i], large[i].net_reflected, large[i].net_transmitted});
    if (radii[i] <= 2.5) reflected.push_back(large[i].net_reflected);
  }
  judge(report, "cantilever.total_reflection", almost_total(reflected));
  report.facts.add("net_transmitted_5", large.back().net_transmitted, "share of what arrives");
}

/**
The map of all radii takes longest and comes last, because its rows are kept in the folder until all
tables are written. */
void report_map(Report& report, const ScatteringSetup& setup, const std::filesystem::path& folder) {
  Sweep sweep = map_sweep(folder, report.quick);
  compute_map(sweep, setup, report.quick, {});
  const Table table = sweep.table();
  const auto near = table.numbers("near"), budget = table.numbers("budget");
  const auto most = std::size_t(std::max_element(near.begin(), near.end()) - near.begin());
  double open = 0;
  for (double x : budget) open = std::max(open, std::abs(x));
  report.facts.add("budget_worst", {open, open});
  report.facts.add("most_trapped", {near[most], table.numbers("near_error")[most]},
                   "share of the energy");
  report.facts.add("most_trapped_at",
                   {table.numbers("ratio")[most], report.quick ? 0.125 : 0.0125});
  report_large(report, setup, table);
  report.output.add("defect_map", table);
  sweep.forget();
}

/**
## The outlook: sizes and periods

The article's conclusion gives "ranges of parameters" that suit an experiment: "beads of about 1cm diameter, loads of
about 1N, and cantilever width of about 1cm" (`outlook.ranges`). In the array of section 3.6 the beads have a diameter
of twice 2.38 mm, the load is the strongest push at $n = 80$, and the width is 5 mm. The facts have the three factors
that lie between; the largest, [2.86448](num:outlook.ranges), is that of the load, and
[2.10084](num:sec36_cantilever_defect.range_diameter) and [2](num:sec36_cantilever_defect.range_width) are those of diameter
and width. The period of weak breathers, 0.15 ms (`outlook.small_period`), tends to $2\pi\tau_c =$
[0.158456](num:outlook.small_period) ms, that of a cantilever alone. */
void report_ranges(Report& report, const StruckArray& blow, const WatchedRuns& runs) {
  const auto apart = [](const Estimate& a, double printed) {
    return a.value < printed ? quotient(exact(printed), a) : quotient(a, exact(printed));
  };
  const Estimate load = apart(
      both(runs, [&](const WatchedRun& run) { return pulse_of(run.at, blow.scales).force; }), 1);
  const Estimate diameter = apart(exact(2 * blow.array.radius), 1e-2);
  const Estimate width = apart(exact(blow.array.width), 1e-2);
  report.facts.add("range_diameter", diameter);
  report.facts.add("range_width", width);
  report.facts.add("range_load", load);
  const auto smaller = [](const Estimate& a, const Estimate& b) { return a.value < b.value; };
  report.results.add("outlook.ranges", std::max({diameter, width, load}, smaller));
  report.results.add("outlook.small_period",
                     exact(2 * std::numbers::pi * blow.scales.tau_c() * 1e3), "ms");
}

/**
## The outlook: ten milliseconds

Would one see the packet in a laboratory? The article's conclusion expects about 20 sites and 70
oscillations in 10 ms, the lifetime of breathers measured in diatomic chains, if damping changes speed
and frequency moderately. Without damping we take the packet of figure 24 as it passes $n = 80$. With
damping it is followed in `sec5_experiment`, from the impact on, where the packet is fastest: if the amplitude of a
cantilever falls like $e^{-t/\tau}$, $\tau = 10$ ms, it covers [17.0208](num:sec5_experiment.sites_5ms) sites in
10 ms, and if, as a milder reading of the lifetime, the energy does, [18.7717](num:sec5_experiment.sites_10ms),
instead of [20.9992](num:sec5_experiment.sites_undamped) without damping. The frequency hardly changes; the speed
after 10 ms is [0.683016](num:sec5_experiment.speed_share_5ms) or [0.833898](num:sec5_experiment.speed_share) of that
of the undamped packet. */
void report_outlook(Report& report, const StruckArray& blow, const WatchedRuns& runs) {
  // The packet of figure 24, as it passes n = 80
  report.results.add(
      "outlook.travel_10ms",
      both(runs,
           [&](const WatchedRun& run) { return run.track.travelled(80, blow.scales.time(10)); }),
      "sites");
  report.results.add("outlook.periods_10ms", both(runs, [&](const WatchedRun& run) {
                       return 10 / (pulse_of(run.at, blow.scales).period * 1e3);
                     }));
}

/**
## Checks

Over the whole map the energy budget is zero to within [4e-10](num:sec36_cantilever_defect.budget_worst). A
conserved energy does not prove the forces right, so an array with a heavy defect, close enough to
the impact to be hit hard, is also computed by an independent method, GSL's adaptive one of order
eight, and must arrive at the same state. */
void report_check(Report& report, const StruckArray& blow) {
  StruckArray shorter = blow;
  shorter.array.sites = 30, shorter.array.defect = 8;
  const Impact impact = shorter.impact(1.6, 4, shorter.scales.time(4));
  const ImpactRun ours = strike(ContactAware{0.0125}, impact);
  const double apart = distance_from_reference(
      impact.chain, struck(impact.chain.sites, impact.velocity), impact.time, ours.end, 1e-8);
  report.facts.add("independent_route_difference", {apart, apart});
}

/**
## One defect with your own radius

`sec36_cantilever_defect run --ratio 1.6` measures one defect in the same way. It fails if the
transmitted packet reaches the far end in 75 ms; `--sites` then makes the array longer. `map --part 2/8` computes one part
of the map of figure x09, whose rows it leaves in `--folder` for the full run. */
struct OneDefect {
  static constexpr Title title{"run", "one defect: reflected, remaining, transmitted energy"};
  double ratio = 1.6, velocity = 1;
  std::size_t sites = 200;

  void parameters(Parameters& p) {
    p.add("ratio", ratio, "radius of the defect's beads over that of the others", {0.1, 5})
        .formerly("radius");
    p.add("velocity", velocity, "impact velocity in m/s", {0.5, 2, "m/s"});
    p.add("sites", sites, "number of cantilevers, the defect being the hundredth", {110, 1e4});
  }
  Table table() const;
};

struct DefectMap : MapPart {
  static constexpr Title title{"map", "a part of the map of defects"};
  Table table() const;
};

/// The shares; throws Failure if the array is too short for them.
static Fractions within_array(const StruckArray& blow, double ratio) try {
  return fractions(setup_for(blow, false), ratio);
} catch (const FarEndReached&) {
  throw Failure("the packet that passes the defect comes to the end of the array within " +
                short_text(shown_until) + " ms: --sites " + std::to_string(blow.array.sites) +
                " are too few");
}

/**
The quantities of `run` are those of the map, with the speed and the constants of the defect. */
Table OneDefect::table() const {
  StruckArray blow{.velocity = velocity};
  blow.array.sites = sites;
  const Fractions f = within_array(blow, ratio);
  // What a defect lets through, or sends back, may be nothing
  Answers q;
  for (const auto& named : f.named())
    q.add_small(named.name, named.share, named.unit, named.meaning);
  q.add_small("budget", f.budget, "", "reflected + near + transmitted - 1: zero but for errors");
  q.add("speed", speed_between(pass_twice(blow), blow, 20, 40), "sites/s",
        "speed of the packet between sites 20 and 40, before it meets the defect");
  q.add("mu", exact(blow.array.mu(ratio)), "",
        "mass of the defect over that of the other cantilevers, Eq. (32)");
  q.add("eta", exact(CantileverArray::eta(ratio)), "",
        "stiffness of the defect's two contacts over that of the others, Eq. (32)");
  q.add("linear_frequency", exact(blow.array.linear_frequency(ratio)), "1 / tau_c",
        "angular frequency of the defect alone, without its contacts");
  return q.table;
}

Table DefectMap::table() const {
  Sweep sweep = map_sweep(folder, false);
  if (sweep.known(mine()) < sweep.size(mine()))
    compute_map(sweep, setup_for(StruckArray{}, false), false, mine());
  return sweep.table(mine());
}

/**
A full run follows the chapter, with the maps at the end; `--quick` takes coarser steps and fewer
radii. */
void reproduce(Report& report) {
  const StruckArray blow;
  const WatchedRuns runs = pass_twice(blow);
  report_packet(report, blow, runs);
  report_dps(report, blow, runs);
  report_ranges(report, blow, runs);
  report_outlook(report, blow, runs);
  report_check(report, blow);
  report_forces(report, blow, report.quick ? 50 : 250);
  trapped::report_trapping(report, blow);
  const ScatteringSetup setup = setup_for(blow, report.quick);
  report_shares(report, setup);
  report_map(report, setup, report.output.folder());
}

/**
## Differences and limits

The article prints neither the stretch of its speed nor a threshold for the duration, which are read in its favour,
and gives no energies for its reflections; our definitions are given where they are used. Replacing a beam with beads
by a point mass costs a tenth of a per cent of its frequency; twisting of the beams, their higher modes and dissipation in the contacts are left out.

The article sees a small part of the energy loosely trapped at 1.6 radii. At 75 ms the nine sites up to the defect
hold [0.00389406](num:cantilever.trapped) of the energy, against
[0.00147795](num:sec36_cantilever_defect.before_75_without) without a defect, so there is indeed some. It is loosely
held: after 25 ms [0.866036](num:sec36_cantilever_defect.kept_before_16) of it is left. Of the five radii that we
watch only 0.925 and 0.8 keep the energy around them during these 25 ms, and they keep it on the defect itself.

## Extensions

- Which radius reflects best if two neighbouring cantilevers are changed, or if only the
  stiffness of the contact is ($\mu = 1$)?
- How does the map change with the impact velocity? In the DpS limit only $\mu$ and $\eta$ compared
  with $\lambda$ should matter.
- Compute the Floquet multipliers of the trapped mode: is its swing from side to side one of them? */
int main(int argc, char** argv) {
  return run({"sec36_cantilever_defect", "3.6",
              "Decorated cantilevers and a defect that reflects (section 3.6)", reproduce,
              commands<OneDefect, DefectMap>()},
             argc, argv);
}
