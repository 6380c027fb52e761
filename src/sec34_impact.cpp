/**
# 3.4 Strong impacts in soft wells: surface mode and blow-up

After a weak impact a packet about seven sites wide runs along the chain, whatever the wells (chapter before). What do
soft wells change when the impact is strong? Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) says that

- the curves of speed and energy density against impact velocity are very close for weak impacts; for strong impacts
  those of soft wells lie lower (figure 19), and they end where the solution blows up;
- the packet's energy becomes *much* smaller, as a part stays near the first bead, the *surface mode* (figures 20, 21);
- up to moderate velocities the packet is mainly on seven sites, decays faster than any exponential, and a small
  oscillatory tail follows it.

We find the first and the last as printed, if amplitudes are measured suitably, and the rest with limits:

- *Energy.* It falls with the scaled anharmonicity $\chi = |s|\,v_0^{3/2}$, to less than half for strong impacts: from
  $v_0 = 1.54$ at $s = -\frac16$ (not at 2.11) and from 0.65 at $s = -0.7$ on.
- *Where it stays.* Most of it is then near the first bead, except after three impacts just before the first escape.
  Newton's method finds the surface mode as a periodic orbit, weakly unstable at the frequency of figure 20.
- *Blow-up.* Up to the ends of our scans every impact above a threshold blows up, but below it impacts after which a
  bead escapes alternate with others.

![Energy density and speed of the packet against impact velocity. Drawn by fig19_impact_velocity.gp: `peak` and `speed`
against `velocity`, from the table `velocity_sweep`.](fig:19)

<!-- head -->
`build/bin/sec34_impact` computes this chapter in 7 s on two cores and writes 15 tables to `build/data/sec34_impact`.
Its figures: `make fig19`, `make fig20`, `make fig21`, `make x50`, `make x57`. With your parameters: `run`, one impact:
speed, centre and energies of the foremost packet.
<!-- /head -->

## Model

The beads obey Eq. (9) with the wells of Eq. (10), $W(y) = y^2/2 + s\,y^4/4$, which are soft for $s < 0$. The first one
is struck, Eq. (26). All quantities are dimensionless, and both ends are free:
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
At the amplitude of the impact, $v_0$, the anharmonic force $|s|\,v_0^3$ and the contact force $v_0^{3/2}$ have the
ratio $\chi$. The energy density of Eq. (23) and its centre, Eq. (24), locate the packet. The sums run over the $m = 5$
sites on either side of the packet's largest density $e_{n'}$:
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + \tfrac25 (y_n-y_{n+1})_+^{5/2}, \qquad
  X = \frac{\sum_{n=n'-m}^{n'+m} n\,e_n}{\sum_{n=n'-m}^{n'+m} e_n}.$$
The article does not say where it fits speeds, for which $s$ it draws figure 19, or how it integrates. We fit between
sites 20 and 60, and take the linear well and the two soft ones that the article uses elsewhere. */
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "commands/one_impact.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/diagnostics/path.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/orbits/floquet.hpp"
#include "lattice/orbits/shooting.hpp"
#include "report/program.hpp"
#include "sec34/escapes.hpp"
#include "sec34/packet.hpp"
#include "sec34/surface_mode.hpp"

using namespace lattice;

/**
## The experiment

We strike the chain and follow the foremost packet until it has passed site 60. `strike` (impact.hpp) integrates by a
Runge–Kutta–Nyström method of order six, corrected where contacts open and close, in steps of at most 0.2, and samples
the motion at least every 0.2 units of time, a thirtieth of an internal period. The packet is found from the far end, as
the first site whose density is the largest of eleven (`front_packet`), since slower packets behind can carry as much
energy. A run throws if the last bead has moved, so that nothing can have come back from there.

`refined(tolerance, run)` halves the step, and the distance of the samples with it, until the *end states* of two runs
agree to `tolerance`, relative to their largest entry. The finer run gives the numbers, its difference from the coarser
one their errors. If no step is short enough, if the energy drifts, or if a bead escapes, it throws. */
constexpr double fit_to = 60;  // the packet is measured from site 20 (fit_from) to this one
constexpr double fit_late = fit_to - 20;  // and, farther from the boundary, from here on
constexpr double tolerance = 1e-4;        // within which the end states of two runs must agree
constexpr double strong = 0.3;            // from where on an impact counts as strong
constexpr double figure_20 = 0.94, until_figure_20 = 300;  // impact and end of figure 20
constexpr double figure_21 = 1.87;                         // impact of figure 21
constexpr double softer = -1.0 / 6, softest = -0.7;        // s of the article's soft wells

struct Followed : ImpactRun {
  // Fractions of the energy on the first sites, at each sample
  std::vector<double> first_three{}, first_five{}, first_ten{};
  Front front{};  // largest density at each distance from the packet, from fit_late on
};

Followed followed(const EventCorrected& method, double s, double v0, double time,
                  double until = fit_to + 2) {
  const Impact impact{.velocity = v0,
                      .chain = {std::size_t(fit_to) + 30, Quartic{s}},
                      .time = time,
                      .until = until};
  Followed out;
  const auto watch = [&](const State<double>& now, const std::vector<double>& e) {
    const auto peak = front_packet(e);  // n'
    if (!peak || now.t == 0) return;
    out.first_three.push_back(boundary_share(e, 3));
    out.first_five.push_back(boundary_share(e, 5));
    out.first_ten.push_back(boundary_share(e, 10));
    if (energy_centre(e, *peak) > fit_late) out.front.add(e, *peak);
  };
  ImpactRun& run = out;
  run = strike(method, impact, watch);
  return out;
}

/**
## Speed and energy against impact velocity (figure 19)

For each velocity of the sweep we compute the speed, the slope of the least-squares line through $X(t)$; the largest
maximum in time of $e_{n'}$ while $20 < X < 60$; and the energy of the packet when it passes site 60, with the fraction
of all energy on the first sites then. How long a run may last follows from the chapter before: at small $\epsilon =
v_0/2$ the speed tends to [0.361](cell:sec34_dps_impact/speeds/model=dps/per_slow_time) times $\epsilon^{1/2}$. */
// Three times what the slowest packets need to reach the end
double time_for(double velocity) {
  return 3 * fit_to / (0.36 * std::sqrt(velocity / 2));
}

struct SweepPoint {
  double s, velocity;
  Estimate speed{}, late{}, peak{}, energy{}, first_five{}, first_ten{};

  void measure() {
    const auto runs = refined(tolerance, [&](const EventCorrected& method) {
      return followed(method, s, velocity, time_for(velocity));
    });
    speed = runs.of([](const Followed& f) { return packet_speed(f.path, fit_to); });
    late =
        runs.of([](const Followed& f) { return f.path.line(fit_late, fit_to).value().estimate(); });
    peak = runs.of([](const Followed& f) { return f.path.largest_peak(fit_from, fit_to).value; });
    energy = runs.of([](const Followed& f) { return f.path.energy_at(fit_to); });
    first_five = runs.of([](const Followed& f) { return f.path.when_at(fit_to, f.first_five); });
    first_ten = runs.of([](const Followed& f) { return f.path.when_at(fit_to, f.first_ten); });
  }
};

/**
A bead that passes the maximum of a soft well, at $|y| = |s|^{-1/2}$, escapes to infinity. So each soft well has a
largest velocity of the sweep, and a range that is scanned for escapes. A curve ends below the first velocity at which a
bead escapes (*The blow-up*); its last 0.05 are marked in the figure (`ending`), since the first bead almost escapes
there before it returns, and the outcome is erratic. */
struct SweptWell {
  double s, fastest;
  double scan_from = 0, scan_to = 0;
};
const std::vector<SweptWell> wells = {
    {.s = 0, .fastest = 2.5},
    {.s = softer, .fastest = 2.2, .scan_from = 2.05, .scan_to = 2.85},
    {.s = softest, .fastest = 1.0, .scan_from = 0.93, .scan_to = 1.33}};
constexpr double erratic = 0.05;  // of velocity, before the first escape

using Curve = std::vector<SweepPoint>;

// In soft wells up to the first escape, `ends`
std::vector<Curve> report_sweep(Report& report, const std::vector<double>& ends) {
  Table& sweep = report.table("velocity_sweep");
  const double spacing = report.quick ? 0.05 : 0.01;
  std::vector<Curve> curves(wells.size());
  for (std::size_t w = 0; w < wells.size(); ++w) {
    Curve& curve = curves[w];
    for (long k = 1; k <= std::lround(wells[w].fastest / spacing); ++k)
      if (spacing * double(k) <= ends[w]) curve.push_back({wells[w].s, spacing * double(k)});
    const double last = curve.back().velocity;
    const auto row = [&](SweepPoint& p) -> Row {
      p.measure();
      const bool ending = std::isfinite(ends[w]) && p.velocity > last - 1.1 * erratic;
      const char *fit = "from two resolutions and the fit",
                 *fraction = "difference of two resolutions, known to 5 per cent";
      return {{"s", "anharmonicity of the well", p.s},
              {"velocity", "impact velocity", p.velocity},
              {"speed", "speed of the packet's centre between sites 20 and 60", p.speed,
               "site per unit of time", fit},
              {"beyond_site_40", "the same between sites 40 and 60", p.late,
               "site per unit of time", fit},
              {"peak", "largest maximum in time of e_n between these sites", p.peak},
              {"energy", "energy of the packet when it passes site 60", p.energy},
              {"first_five", "fraction of all energy on the first five sites then", p.first_five,
               "", fraction},
              {"first_ten", "the same of ten sites", p.first_ten, "", fraction},
              {"ending", "1 in the last 0.05 of a curve that ends in a blow-up", ending}};
    };
    sweep.fill(curve, row, "velocity sweep");
  }
  return curves;
}

/**
As $v_0 \to 0$ the DpS equation takes over, in which $s$ does not occur, so the three curves must *meet* there. They do:
what a soft well takes from the packet's energy falls in proportion to $\chi$. Divided by $\chi$ it is the same in both
wells after weak impacts, and tends to a constant near 0.5 along a line in $v_0^{1/2}$, the size of the corrections to
the DpS limit. After strong impacts it is two to three times as large, and at equal $\chi$ the wells differ by a fifth.

![Energy that a soft well takes from the packet, against the scaled anharmonicity. Drawn by x57_energy_deficit.gp:
`deficit` against `chi`, from the table `deficit`.](fig:x57)

| energy that the packet lacks, as a fraction, over $\chi$ | $v_0 = 0.02$ | 0.1 | 0.5 |
|---|---|---|---|
| $s = -\frac16$ | [0.612](cell:deficit/s=-1/6/velocity=0.02/per_chi) | [0.723](cell:velocity=0.1/per_chi) | [1.01](cell:velocity=0.5/per_chi) |
| $s = -0.7$ | [0.613](cell:deficit/s=-0.7/velocity=0.02/per_chi) | [0.735](cell:velocity=0.1/per_chi) | [1.21](cell:velocity=0.5/per_chi) |

For strong impacts, which we take to begin at $v_0 = 0.3$, a soft well lowers speed, peak and energy at *every* velocity
of the sweep. Weak packets are as fast as in linear wells within their errors. All packets still slow down: in linear
wells the speed between sites 40 and 60 is lower than that between 20 and 60 by 1.2 to 1.6 per cent. The ripple of the
peak density in figure 19 is resolved; a packet passes a site in a time comparable to its internal period, and we guess
that the largest density depends on the phase between the two.

Is a packet slower because it has less energy? A weaker impact on linear wells makes a packet of the same energy. This
packet is *slower* than that of the soft well, by up to 3 per cent: the loss of energy explains more than the whole
difference (table `equal_energy`; there are exceptions in the last 0.05 before the blow-up).

| packet | $v_0$ | speed | in linear wells, same impact | same energy |
|---|---|---|---|---|
| $s = -\frac16$ | 1 | [0.1830](cell:equal_energy/s=-1/6/velocity=1/speed) | [0.1878](cell:velocity_sweep/s=0/velocity=1/speed) | [0.179](cell:equal_energy/s=-1/6/velocity=1/linear) |
| $s = -\frac16$ | 1.8 | [0.196](cell:equal_energy/s=-1/6/velocity=1.8/speed) | [0.237](cell:velocity_sweep/s=0/velocity=1.8/speed) | [0.190](cell:equal_energy/s=-1/6/velocity=1.8/linear) |
| $s = -0.7$ | 0.5 | [0.1353](cell:equal_energy/s=-0.7/velocity=0.5/speed) | [0.1416](cell:velocity_sweep/s=0/velocity=0.5/speed) | [0.1316](cell:equal_energy/s=-0.7/velocity=0.5/linear) |
| $s = -0.7$ | 0.9 | [0.1286](cell:equal_energy/s=-0.7/velocity=0.9/speed) | [0.1800](cell:velocity_sweep/s=0/velocity=0.9/speed) | [0.125](cell:equal_energy/s=-0.7/velocity=0.9/linear) | */
// Equal energies with the change that every other impact makes; all curves begin with the same velocities
void report_lost_energy(Report& report, const std::vector<Curve>& curves) {
  Table &deficit = report.table("deficit"), &equal = report.table("equal_energy");
  const Curve& linear = curves[0];
  std::vector<PacketSpeed> all, every_other;
  for (std::size_t i = 0; i < linear.size(); ++i) {
    all.push_back({linear[i].energy.value, linear[i].speed});
    if (i % 2 == 0) every_other.push_back(all.back());
  }
  for (std::size_t w = 1; w < curves.size(); ++w)
    for (std::size_t i = 0; i < curves[w].size(); ++i) {
      const SweepPoint& p = curves[w][i];
      const double chi = std::abs(p.s) * p.velocity * std::sqrt(p.velocity);
      const Estimate ratio = quotient(p.energy, linear[i].energy),
                     lost(1 - ratio.value, ratio.error);
      deficit.add({{"s", "anharmonicity of the well", p.s},
                   {"velocity", "impact velocity", p.velocity},
                   {"chi", "|s| v0^(3/2)", chi},
                   {"deficit", "energy of the packet that linear wells have more, as a fraction",
                    lost, "", "from two resolutions, known to 5 per cent"},
                   {"per_chi", "the same over chi", Estimate(lost.value / chi, lost.error / chi),
                    "", "from two resolutions, known to 5 per cent"}});
      if (p.velocity < strong - 1e-9) continue;
      const Estimate fine = speed_at_energy(all, p.energy.value),
                     coarse = speed_at_energy(every_other, p.energy.value);
      equal.add({{"s", "anharmonicity of the well", p.s},
                 {"velocity", "impact velocity", p.velocity},
                 {"speed", "of the packet in the soft well", p.speed, "site per unit of time",
                  "from two resolutions and the fit"},
                 {"linear", "of the packet with the same energy in linear wells",
                  Estimate(fine.value, fine.error + std::abs(fine.value - coarse.value)),
                  "site per unit of time",
                  "of the neighbouring impacts, and with every other impact left out"}});
    }
}

/**
## The error against the step

How good are these numbers? We repeat the impact of 0.94 at $s=-0.7$ with fixed steps and equal samples. The errors of
speed, energy and peak, taken from the difference to a step of 1/160, fall like the fifth power of the step: the method
is of order six between contact events and of about 4.5 at them. At the longest step of the tables, 0.2, they are below
$10^{-5}$. The errors in the tables are larger, since they hold the fit of the line, limited by the ripple of $X(t)$,
and the distance of the samples.

![Error of speed, energy and peak against the step. Drawn by x50_error_against_step.gp from the table
`convergence`.](fig:x50)

One route is independent: a test repeats the impact on the soft chain by a method of order eight from the GNU Scientific
Library, which shares only the forces with ours, and asks that speed, energy and peak agree to $10^{-6}$
(`make test T=sec34`). */
struct Numbers {
  double speed, energy, peak;
};

void report_convergence(Report& report) {
  Table& table = report.table("convergence");
  const Impact impact{.velocity = figure_20,
                      .chain = {std::size_t(fit_to) + 30, Quartic{softest}},
                      .time = time_for(figure_20),
                      .denser = false,
                      .until = fit_to + 2};
  const auto with = [&](int halvings) -> Numbers {
    const Path path = strike(method_for(tolerance, largest_step, halvings), impact).path;
    return {packet_speed(path, fit_to).value, path.energy_at(fit_to),
            path.largest_peak(fit_from, fit_to).value};
  };
  const int shortest = report.quick ? 3 : 5;  // halvings of a step of 0.2
  const Numbers best = with(shortest);
  for (int halvings = -2; halvings < shortest; ++halvings) {
    const Numbers here = with(halvings);
    table.add(
        {{"step", "time step", largest_step * std::pow(0.5, halvings)},
         {"speed", "relative error of the packet's speed", std::abs(here.speed / best.speed - 1)},
         {"energy", "of its energy at site 60", std::abs(here.energy / best.energy - 1)},
         {"peak", "of its largest density", std::abs(here.peak / best.peak - 1)}});
  }
}

/**
## The surface mode (figure 20)

Where is the energy that the packet lacks? Figure 20 compares the contact forces $f_n = -(y_n-y_{n+1})_+^{3/2}$ for a
linear and a very soft well after the same impact, $v_0 = 0.94$, just below the first escape. In linear wells the packet
leaves waves behind. In the very soft ones the first contacts are pressed again and again.

![Contact forces for a linear and a very soft well. Drawn by fig20_surface_mode.py: `force` over `n` and `t`, from the
table `surface_mode_forces`.](fig:20) */
void report_forces(Report& report) {
  Table& forces = report.table("surface_mode_forces",
                               {number("s", "anharmonicity of the well"), number("t", "time"),
                                count("n", "contact between sites n and n + 1", "site"),
                                number("force", "contact force, negative where the beads touch")});
  const EventCorrected method = method_for(tolerance, largest_step, 2);  // steps of 0.05
  for (double s : {0.0, softest}) {
    const Impact impact{.velocity = figure_20,
                        .chain = {80, Quartic{s}},
                        .time = until_figure_20,
                        .every = 0.5,
                        .denser = false};
    const auto look = [&](const State<double>& now, const std::vector<double>&) {
      const auto force = contact_forces(impact.chain, now.y);
      for (std::size_t n = 0; n < 60; ++n)
        forces.add({s, now.t, n + 1, 0.0 - force[n]});  // not -0 where the beads are apart
    };
    if (strike(method, impact, look).run.escaped()) throw Failure("a bead escapes in figure 20");
  }
}

/**
We call energy *trapped* if the first five sites hold more than the packet long after the impact, when the packet passes
site 60; the rest are waves between. At $v_0 = 0.94$ the softer well adds more to the first five sites than it takes
from the packet. But trapping is not robust so close to the escape: at 0.95 the first bead gives its energy away, most
of it to slow waves, and at 0.96 it keeps it again. The last row is the impact of figure 21.

| $v_0$, $s$ | first five sites | packet | rest | speed of the packet |
|---|---|---|---|---|
| 0.94, 0 | [0.102](cell:shares/velocity=0.94/s=0/first_five) | [0.441](cell:packet) | [0.457](cell:rest) | [0.183](cell:speed) |
| 0.93, $-0.7$ | [0.798](cell:shares/velocity=0.93/s=-0.7/first_five) | [0.0662](cell:packet) | [0.135](cell:rest) | [0.127](cell:speed) |
| 0.94, $-0.7$ | [0.799](cell:shares/velocity=0.94/s=-0.7/first_five) | [0.0650](cell:packet) | [0.136](cell:rest) | [0.127](cell:speed) |
| 0.95, $-0.7$ | [0.00443 ± 6e-5](cell:shares/velocity=0.95/s=-0.7/first_five) | [0.156](cell:packet) | [0.840](cell:rest) | [0.134](cell:speed) |
| 0.96, $-0.7$ | [0.722](cell:shares/velocity=0.96/s=-0.7/first_five) | [0.0651](cell:packet) | [0.213](cell:rest) | [0.128](cell:speed) |
| 1.87, $-\frac16$ | [0.592](cell:shares/velocity=1.87/s=-1/6/first_five) | [0.129](cell:packet) | [0.279](cell:rest) | [0.194](cell:speed) | */
struct Struck {
  double velocity, s;
};

void report_shares(Report& report) {
  const auto packet = [](const Followed& run) {
    return run.path.energy_at(fit_to) / total(run.density);
  };
  const auto five = [](const Followed& run) { return run.path.when_at(fit_to, run.first_five); };
  Table& shares = report.table("shares");
  for (const auto& [v0, s] : {Struck{figure_20, 0},
                              {0.93, softest},
                              {figure_20, softest},
                              {0.95, softest},
                              {0.96, softest},
                              {figure_21, softer}}) {
    const auto runs = refined(
        tolerance, [&](const EventCorrected& method) { return followed(method, s, v0, 900); });
    const char* known = "difference of two resolutions, known to 2 per cent";
    shares.add(
        {{"velocity", "impact velocity", v0},
         {"s", "anharmonicity of the well", s},
         {"first_three", "fraction of the energy on the first three sites",
          runs.of([](const Followed& f) { return f.path.when_at(fit_to, f.first_three); }), "",
          known},
         {"first_five", "the same of five sites", runs.of(five), "", known},
         {"first_ten", "the same of ten sites",
          runs.of([](const Followed& f) { return f.path.when_at(fit_to, f.first_ten); }), "",
          known},
         {"packet", "fraction of the energy within m sites of the packet's peak", runs.of(packet)},
         {"rest", "fraction of the energy elsewhere",
          runs.of([&](const Followed& f) { return 1 - five(f) - packet(f); })},
         {"speed", "speed of the packet",
          runs.of([](const Followed& f) { return packet_speed(f.path, fit_to); }),
          "site per unit of time", "from two resolutions and the fit"}});
  }
}

/**
Why does a soft well keep energy? In linear wells all beads oscillate at frequency 1 between contacts, whatever their
amplitude, so energy passes resonantly from one to the next. In a soft well the frequency of a free bead falls with its
amplitude, and the contacts raise it. After $v_0=0.94$ the first bead oscillates at 0.86. Its neighbours follow at this
frequency, to a fifth of a per cent, though by themselves they would be faster: they are driven below their resonance.
The fourth oscillates by itself (table `surface_mode_beads`, means after $t = 150$). After a weaker impact the argument
predicts that nothing stays, and after 0.5 nothing does: all beads have nearly the frequency and the amplitude of the
first one. In linear wells the same holds after 0.94.

| $s=-0.7$ | bead 1 | 2 | 3 | 4 |
|---|---|---|---|---|
| frequency after $v_0=0.94$ | [0.862](cell:surface_mode_beads/velocity=0.94/s=-0.7/n=1/frequency) | [0.862](cell:n=2/frequency) | [0.863](cell:n=3/frequency) | [0.995](cell:n=4/frequency) |
| of the free bead with its amplitude | [0.683](cell:surface_mode_beads/velocity=0.94/s=-0.7/n=1/alone) | [0.951](cell:n=2/alone) | [0.979](cell:n=3/alone) | [0.993](cell:n=4/alone) |
| frequency after $v_0=0.5$ | [0.997](cell:surface_mode_beads/velocity=0.5/s=-0.7/n=1/frequency) | [0.997](cell:n=2/frequency) | [0.998](cell:n=3/frequency) | [0.998](cell:n=4/frequency) | */
constexpr double moderate = 0.5;                // an impact that leaves no surface mode
constexpr double settled = 150;                 // time after which beads are watched
constexpr std::size_t watched = 6, locked = 3;  // beads; those of them that follow the first one
constexpr std::size_t orbit_sites = 16;  // its force on the next bead would be below rounding

WatchedBeads watched_after(const Struck& of, const EventCorrected& method) {
  return watch_beads(
      method, {.velocity = of.velocity, .chain = {80, Quartic{of.s}}, .time = until_figure_20},
      watched, settled);
}

/**
Is there such a mode, or only a transient? A breather is a localised periodic orbit (Flach and Gorbach 2008 for a
review), and so is a surface mode that lasts. We look for one by Newton's method (shooting.hpp): starting from rest at
$y(0)$, all beads are at rest again after half a period, $\dot y_n(T_b/2) = 0$, as many equations as sites. The
frequency is that of bead 1 in the run, the first guess the mean displacements of three beads where the first one turns
back towards the end. The method converges, to a state near the mean of the run, with nearly the energy of the first
five sites (tables `surface_mode`, `surface_orbit`).

| $s=-0.7$, $v_0=0.94$ | bead 1 | 2 | 3 | 4 | 5 | energy |
|---|---|---|---|---|---|---|
| run, mean at these moments | [0.74](cell:surface_mode/n=1/run) | [0.310](cell:n=2/run) | [0.144](cell:n=3/run) | [0.058](cell:n=4/run) | [0.024](cell:n=5/run) | [0.355](cell:surface_orbit/trapped) |
| periodic orbit | [0.752](cell:surface_mode/n=1/orbit) | [0.302](cell:n=2/orbit) | [0.132](cell:n=3/orbit) | [0.042](cell:n=4/orbit) | [0.011](cell:n=5/orbit) | [0.341](cell:surface_orbit/energy) |

So the surface mode is, apart from waves that pass through it, a breather at the end of the chain. Surprisingly it is
not stable: one pair of Floquet multipliers is real and negative, and a perturbation changes its sign and grows by a
factor of [1.12](cell:surface_orbit/modulus) each period. What this does to the mode in the long run is not known. */
struct SurfaceMode {
  double omega, energy, modulus;
  std::vector<double> y;
};

SurfaceMode surface_mode(const WatchedBeads& run, double s) {
  const double omega = run.beads[0].frequency();
  const Chain chain{orbit_sites, Quartic{s}, Hertz{.floor = 0}};
  Vector<double> guess = Vector<double>::Zero(orbit_sites);
  for (std::size_t n = 0; n < locked; ++n) guess[Eigen::Index(n)] = run.inner[n];
  const Shooting<double> problem{chain, even_in_time(orbit_sites), omega};
  const Orbit<double> orbit = newton(problem, guess, {.damped = true});
  // Its Floquet multipliers
  double modulus = 0;
  for (const auto& kappa : floquet_pairs(chain, orbit.start, orbit.period()).kappa)
    for (int sign : {-1, 1}) modulus = std::max(modulus, std::abs(multiplier(kappa, sign)));
  return {omega, orbit.energy, modulus, orbit.start.y};
}

void report_beads(Report& report) {
  Table& table = report.table("surface_mode_beads");
  const char* radian = "radian per unit of time";
  for (const Struck& of : {Struck{figure_20, 0}, {figure_20, softest}, {moderate, softest}}) {
    const auto& [v0, s] = of;
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return watched_after(of, method); });
    for (std::size_t n = 0; n < watched; ++n) {
      const auto amplitude = [n](const WatchedBeads& w) { return w.beads[n].amplitude(); };
      const auto alone = [&](const WatchedBeads& w) { return free_frequency(s, amplitude(w)); };
      table.add(
          {{"velocity", "impact velocity", v0},
           {"s", "anharmonicity of the well", s},
           {"n", "site", n + 1, "site"},
           {"frequency", "mean frequency of the bead, t = 150 to 300",
            runs.of([n](const WatchedBeads& w) { return w.beads[n].frequency(); }), radian},
           {"amplitude", "largest displacement of the bead in this time", runs.of(amplitude)},
           {"alone", "frequency of a free bead with this displacement", runs.of(alone), radian}});
    }
    if (v0 != figure_20 || s == 0) continue;
    // The periodic orbit beside the mean of the run
    const TwoRuns<SurfaceMode> modes{surface_mode(runs.coarse, s), surface_mode(runs.fine, s)};
    Table& profile = report.table("surface_mode");
    for (std::size_t n = 0; n < watched; ++n)
      profile.add({{"n", "site", n + 1, "site"},
                   {"run", "displacement, mean over the moments when bead 1 turns towards the end",
                    runs.of([n](const WatchedBeads& w) { return w.inner[n]; }), "",
                    "against the largest: difference of two resolutions"},
                   {"orbit", "of the periodic orbit that begins at rest",
                    modes.of([n](const SurfaceMode& m) { return m.y[n]; }), "",
                    "against the largest: difference of two resolutions"}});
    const auto trapped = [](const WatchedBeads& w) {
      return boundary_share(w.density) * total(w.density);
    };
    report.table("surface_orbit")
        .add({{"omega", "its frequency", modes.of([](const SurfaceMode& m) { return m.omega; }),
               radian},
              {"energy", "its energy", modes.of([](const SurfaceMode& m) { return m.energy; })},
              {"trapped", "energy of the first five sites at the end of the run", runs.of(trapped)},
              {"modulus", "of the largest Floquet multiplier",
               modes.of([](const SurfaceMode& m) { return m.modulus; })}});
  }
}

/**
## A snapshot of both (figure 21)

The article shows surface mode and travelling breather together in the velocities of all beads at $t = 587$ after an
impact of 1.87 at $s = -\frac16$. We call the two *visible* if each rises above all waves between them. Both do: the
lower of the two is [1.34](cell:snapshot/velocity=1.87/t=587/prominence) times as high as the highest wave there
(`prominence`, packet.hpp), and as visible at the ends of what rounds to the printed velocity and time (`snapshot`).

![Surface mode and packet side by side. Drawn by fig21_snapshot.gp: `v` against `n`, from the table
`surface_mode_snapshot`.](fig:21) */
void report_snapshot(Report& report) {
  Table& profile = report.table("surface_mode_snapshot",
                                {count("n", "site", "site"), estimate("v", "velocity")});
  Table& snapshot = report.table("snapshot");
  const auto visible = [](const ImpactRun& run) {
    return prominence(run.end.v, *front_packet(run.density));
  };
  struct When {
    double velocity, t;
  };
  // The ends of what rounds to the printed numbers
  for (const auto& [v0, t] :
       {When{figure_21, 587}, {figure_21, 586.5}, {figure_21, 587.5}, {1.865, 587}, {1.875, 587}}) {
    const Impact impact{.velocity = v0, .chain = {160, Quartic{softer}}, .time = t, .every = 1};
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
    snapshot.add({{"velocity", "impact velocity", v0},
                  {"t", "time", t},
                  {"prominence",
                   "height of the lower of surface mode and packet over that of the highest wave "
                   "in between",
                   runs.of(visible)}});
    if (v0 != figure_21 || t != 587) continue;  // the printed ones are drawn
    const auto &coarse = runs.coarse.end.v, &fine = runs.fine.end.v;
    for (std::size_t n = 0; n < fine.size(); ++n)
      profile.add({n + 1, fine[n], std::abs(fine[n] - coarse[n])});
  }
}

/**
## Width, tail and decay of the packet

How many sites carry a packet? The article says mainly seven, up to moderate velocities, and does not say how it counts.
By energy, seven sites about the peak hold most of the eleven of Eq. (24) at all times. By *amplitude*, here
$(e_n/e_{n'})^{1/2}$, the width is read off the undisturbed side: if $k$ sites ahead of the peak ever exceed one per
cent, which a drawing still shows, the width is $2k+1$. The two answer differently: by amplitude there are seven sites
after the impact of the chapter before and eleven after impacts of 1 and 1.5. The tail is the largest amplitude on the
ten sites that follow the eleven. All is taken in linear wells while the centre moves from site 40 to 60. Later in the
same section the article calls an impact of 1.5 moderate, and so do we.

| $v_0$ | 0.0019 | 0.05 | 0.1 | 0.5 | 1 | 1.5 |
|---|---|---|---|---|---|---|
| energy on seven of eleven sites, at least | [0.996](cell:packet_shape/velocity=0.0019096/seven) | [0.996](cell:velocity=0.05/seven) | [0.996](cell:velocity=0.1/seven) | [0.991](cell:velocity=0.5/seven) | [0.97](cell:velocity=1/seven) | [0.950 ± 0.005](cell:velocity=1.5/seven) |
| on five | [0.993](cell:packet_shape/velocity=0.0019096/five) | [0.983](cell:velocity=0.05/five) | [0.973](cell:velocity=0.1/five) | [0.892](cell:velocity=0.5/five) | [0.834](cell:velocity=1/five) | [0.786](cell:velocity=1.5/five) |
| width by amplitude (article: mainly 7) | [7](cell:packet_shape/velocity=0.0019096/width) | [7](cell:velocity=0.05/width) | [9](cell:velocity=0.1/width) | [9](cell:velocity=0.5/width) | [11](cell:velocity=1/width) | [11](cell:velocity=1.5/width) |
| amplitude of the tail (article: small) | [0.081](cell:packet_shape/velocity=0.0019096/tail) | [0.084](cell:velocity=0.05/tail) | [0.086](cell:velocity=0.1/tail) | [0.093](cell:velocity=0.5/tail) | [0.098](cell:velocity=1/tail) | [0.102](cell:velocity=1.5/tail) |

An exponential falls by one factor from each site to the next. On the six sites ahead of the packet's centre this factor
itself falls, after each of seven impacts (table `packet_decay`): the decay is faster than exponential as far as we
follow it. If the sites are counted from that of the peak, which jumps from site to site, this is so up to 0.5 only.

| amplitude ahead of the centre | 1 site | 2 | 3 | 4 | 5 | 6 |
|---|---|---|---|---|---|---|
| $v_0 = 0.0019$ | [0.8](cell:packet_decay/velocity=0.0019096/distance=1/amplitude) | [0.2](cell:distance=2/amplitude) | [0.03](cell:distance=3/amplitude) | [5e-4](cell:distance=4/amplitude) | [1e-6](cell:distance=5/amplitude) | [1e-10](cell:distance=6/amplitude) |
| $v_0 = 1.5$ | [0.8](cell:packet_decay/velocity=1.5/distance=1/amplitude) | [0.5](cell:distance=2/amplitude) | [0.2](cell:distance=3/amplitude) | [0.04](cell:distance=4/amplitude) | [3e-3](cell:distance=5/amplitude) | [8e-5](cell:distance=6/amplitude) | */
void report_shape(Report& report) {
  Table &shape = report.table("packet_shape"), &decay = report.table("packet_decay");
  const double weak = 2 * 0.9548e-3;  // the impact of the chapter before
  const std::vector<double> velocities{weak, 0.05, 0.1, 0.2, 0.5, 1.0, 1.5};
  std::vector<TwoRuns<Front>> fronts(velocities.size());
  parallel_for("shapes of packets", velocities.size(), [&](std::size_t i) {
    const auto runs = refined(tolerance, [&](const EventCorrected& method) {
      return followed(method, 0, velocities[i], time_for(velocities[i]), fit_to);
    });
    fronts[i] = {runs.coarse.front, runs.fine.front};
  });
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const TwoRuns<Front>& front = fronts[i];
    shape.add({{"velocity", "impact velocity", velocities[i]},
               {"width", "number of sites that exceed a hundredth of the packet's peak",
                front.of([](const Front& f) { return f.width(); }), "site",
                "two resolutions agree: exact"},
               {"five", "fraction of the energy of eleven sites on five of them, at least",
                front.of([](const Front& f) { return f.share(2); })},
               {"seven", "the same on seven of them",
                front.of([](const Front& f) { return f.share(3); })},
               {"tail", "amplitude behind the packet divided by that of its peak",
                front.of([](const Front& f) { return f.tail(); })}});
    const char* known = "difference of two resolutions, known to 50 per cent";
    for (std::size_t k = 1; k <= 6; ++k)
      decay.add({{"velocity", "impact velocity", velocities[i]},
                 {"distance", "from the packet, ahead of it", k, "site"},
                 {"amplitude", "largest at this distance from the centre over that of the peak",
                  front.of([k](const Front& f) { return f.from_centre(k); }), "", known},
                 {"from_peak", "the same at this distance from the peak's site",
                  front.of([k](const Front& f) { return f.amplitude(k); }), "", known}});
  }
}

/**
## The blow-up

Conservation of energy gives a lower bound. No bead escapes unless the energy of the impact exceeds the maximum of the
potential:
$$v_0^2/2 > W\bigl(|s|^{-1/2}\bigr) = 1/(4|s|).$$
Above this bound escapes do not begin at one velocity: between velocities at which a bead escapes lie islands at which
none does. So we scan 801 velocities up to $t = 500$ (table `blowup_scan`) and quote a band, from the lowest velocity
with an escape to the highest without one (table `blowup_bands`).

<!-- blowup.bands -->
In two soft wells the blow-up after an impact has no single threshold. Up to $t = 500$ the smallest impact velocity at
which a bead escapes is 2.113 ± 0.001 and the largest at which none does is 2.512 ± 0.001 at $s = -\frac16$, and 0.9665
± 0.0005 and 1.1130 ± 0.0005 at $s = -0.7$; in between, bands of escape and survival alternate. (computed)
<!-- /blowup.bands -->

Every velocity is run with two steps on a chain that nothing can cross within the time. Where the *outcomes* differ, the
velocity is disputed and counts for neither edge of the band. The error of an edge is the spacing of the grid. Both
scans begin with survivors above the energy bound and end with escapes, none of which is late. Below the scans there is
only the sweep of figure 19, on a grid ten to twenty times coarser and until the packet has passed site 60; no bead
escapes there.

| | $s = -\frac16$ | $s = -0.7$ |
|---|---|---|
| energy bound | 1.732 | 0.845 |
| scanned | 2.05 to 2.85 | 0.93 to 1.33 |
| time of the latest escape | [46 ± 2](cell:blowup_bands/s=-1/6/latest) | [34 ± 2](cell:s=-0.7/latest) |
| disputed velocities | [0](cell:blowup_bands/s=-1/6/disputed) | [0](cell:s=-0.7/disputed) | */
constexpr double seen_every = 2;  // time after which we look again for a bead that has escaped

/// Where the curves of figure 19 end: one grid spacing below the band.
std::vector<double> report_blowup(Report& report) {
  Table &scan = report.table("blowup_scan"), &bands = report.table("blowup_bands");
  std::vector<double> ends;
  for (const SweptWell& well : wells) {
    if (well.s >= 0) {  // no bead can escape
      ends.push_back(far_away);
      continue;
    }
    std::vector<Trial> trials(report.quick ? 31 : 801);
    for (std::size_t i = 0; i < trials.size(); ++i)
      trials[i].velocity =
          well.scan_from + (well.scan_to - well.scan_from) * double(i) / double(trials.size() - 1);
    const auto row = [&](Trial& trial) -> Row {
      trial = trial_of({.velocity = trial.velocity,
                        .chain = {.well = Quartic{well.s}},
                        .time = report.quick ? 100. : 500.,
                        .every = seen_every,
                        .denser = false},
                       tolerance);
      return {{"s", "anharmonicity of the well", well.s},
              {"velocity", "impact velocity", trial.velocity},
              {"escape_time", "time of the blow-up; nan if the run has no blow-up",
               trial.escaped() ? trial.fine : std::nan("")},
              {"escaped", "1 if a bead escapes", trial.escaped()},
              {"agree", "1 where both resolutions agree on the outcome", trial.agreed()}};
    };
    scan.fill(trials, row, "blow-up band");

    // The band
    const EscapeBand band = band_of(trials);
    const double spacing = trials[1].velocity - trials[0].velocity;
    bands.add(
        {{"s", "anharmonicity of the well", well.s},
         {"first_escape", "lowest velocity at which a bead escapes",
          Estimate(band.first_escape, spacing), "", "spacing of the scan"},
         {"last_survivor", "highest velocity at which none does",
          Estimate(band.last_survivor, spacing), "", "spacing of the scan"},
         {"disputed", "velocities at which two resolutions disagree on the outcome", band.disputed},
         {"latest", "time at which the latest escape is seen", Estimate(band.latest, seen_every),
          "", "time between two samples, known to 6 per cent"}});
    ends.push_back(band.first_escape - spacing);
  }
  return ends;
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `impact.support`: up to moderate velocities the travelling breather is mainly supported by 7 sites | mainly 7 sites | packet_shape.seven (velocity = 1.5): 0.9 < 0.9505 (the closest of 7) | holds, assuming |
| `impact.decay`: breathers obtained by an impact decay faster than any exponential | super-exponential | packet_decay.amplitude (velocity = 1.5, distance = 1), (velocity = 1.5, distance = 2), (velocity = 1.5, distance = 3): 0.433 < 0.6149 (the closest of 28) | holds, assuming |
| `impact.ampvel`: velocity and peak energy density against impact velocity for several s <= 0 are very close at small velocity and differ at larger ones | very close | velocity_sweep.peak (s = 0, velocity = 0.05), (s = -0.7, velocity = 0.05): 0.005309 < 0.01 (the closest of 24) | holds, assuming |
| `impact.slower`: below the blow-up negative s lowers velocity and energy of the travelling breather | lower | velocity_sweep.peak (s = 0, velocity = 0.02), (s = -0.1667, velocity = 0.02): 5.74e-05 < 5.741e-05 (the closest of 921) | holds, assuming |
| `impact.much_smaller`: below the blow-up the energy of the travelling breather is much smaller for s < 0 | much smaller | 0.2890 of that in linear wells | quantified |
| `impact.trapped`: the energy is much smaller because a part of the initial energy remains trapped near n = 1 | trapped | fails 3 of 89 comparisons; first velocity_sweep.ending (s = -0.1667, velocity = 2.08) and 4 other values: 0.1786 < -0.07055; by most velocity_sweep.ending (s = -0.7, velocity = 0.95) and 4 other values: 0.1427 < -0.09784 | in part |
| `impact.blowup`: blow-up above a threshold velocity when s < 0 | threshold | blowup_scan.agree (s = -0.1667, velocity = 2.05) and 1601 other values: 2.763 < 2.85 (the closest of 6) | holds, assuming |
| `impact.surface_mode`: s = -0.7 and v_0 = 0.94 traps a surface mode near n = 1 and makes a slower packet with less energy; s = 0 traps none | trapped | shares.speed (velocity = 0.94, s = 0), (velocity = 0.94, s = -0.7): 0.127 < 0.1832 (the closest of 4) | holds |
| `impact.snapshot`: surface mode and travelling breather at t = 587 for s = -1/6 and v_0 = 1.87 | both visible | snapshot.prominence (velocity = 1.87, t = 587): 1 < 1.341 | holds, assuming |
| `impact.tail`: up to moderate velocities the packet is followed by a small oscillatory tail | small | 0.102 | quantified |
<!-- /statements -->

## Try it

**To change it.** Another well of figure 19 is a row of `wells`, a curve in its script, and a number in `soft_wells` of
the statements, if it is to be judged; its scan has to begin with survivors and end with escapes, or the program says
so. Another kind of well is `Quartic` in `followed`; one that beads cannot leave needs no scan. Another observation of
the packet is a member of `Followed`, a line of its `watch`, a line of `SweepPoint::measure` and a column. The stretch
ends at `fit_to`, and the chain is 30 sites longer. The figures read columns by name.

1. *Easy.* Where is the energy in a soft well? `build/bin/sec34_impact run --s -0.7 --velocity 0.9` gives
   `boundary_energy_fraction` = 0.76318 and `packet_energy_fraction` = 0.073459. Hint: with `--s 0` the packet has most,
   and about as much is in the waves behind it.
2. *Harder.* How close to the escape can one go? `build/bin/sec34_impact run --s -1/6 --velocity 2.02 --time 300` gives
   `boundary_energy_fraction` = 0.68959. Hint: part of the impact's energy leaves the first bead before it reaches the
   maximum. Try 2.11, 2.3 and 2.51.

`run` also takes other wells and contacts (commands/one_impact.hpp). */
void reproduce(Report& report) {
  report.output.note("tolerance", "end state " + short_text(tolerance));
  const std::vector<double> ends = report_blowup(report);
  const std::vector<Curve> curves = report_sweep(report, ends);
  report_lost_energy(report, curves);
  report_convergence(report);
  report_forces(report);
  report_shares(report);
  report_beads(report);
  report_snapshot(report);
  report_shape(report);
}

int main(int argc, char** argv) {
  return run({"sec34_impact", "3.4", "Impact at one end of the chain (section 3.4, s <= 0)",
              reproduce, commands<OneImpact>()},
             argc, argv);
}
