/**
# 3.4 Strong impacts in soft wells: surface mode and blow-up

After a weak impact a packet about seven sites wide runs along the chain, whatever the wells (chapter before). What do
soft wells change when the impact is strong? Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) says that

- the curves of speed and energy density against impact velocity are very close for weak impacts; for strong impacts
  those of soft wells lie lower (figure 19), and they end where the solution blows up;
- the packet's energy becomes *much* smaller, as a part stays near the first bead, the *surface mode* (figures 20, 21);
- up to moderate velocities the packet is mainly on seven sites, decays faster than any exponential, and a small
  oscillatory tail follows it.

The first holds for $s$ of our choice, if *threshold* means the one of the last point below, and the last if the seven
sites are counted by energy. For the second there are limits:

- *Energy.* The packet has less than half of the energy that the same impact gives it in linear wells from $v_0 = 1.54$
  on at $s = -\frac16$ (except at 2.11, the last impact before an escape) and from 0.65 on at $s = -0.7$.
- *Where it stays.* Compared with linear wells the first five sites gain more than half of what these packets lose,
  except after three impacts just before the first escape: there a second, slower and much stronger packet has it. After
  weaker impacts it is spread more widely: after 0.8 at $s=-\frac16$ the five sites gain 20 per cent of it.
- *Surface mode.* It swings about a periodic orbit, which is unstable; yet the mode survives.
- *Blow-up.* From a threshold up to the end of the scan every impact ejects a bead, but below it impacts after which a
  bead escapes alternate with others.

![Energy density and speed of the packet against impact velocity.](fig:19)

<!-- head -->
`build/bin/sec34_impact` computes this chapter in 7 s on two cores and writes 12 tables to `build/data/sec34_impact`.
Its figures: `make fig19`, `make fig20`, `make fig21`, `make x50`, `make x57`. With your parameters: `run`, one impact:
speed, centre and energies of the foremost packet.
<!-- /head -->

## Model

The beads obey Eq. (9) with the wells of Eq. (10), $W(y) = y^2/2 + s\,y^4/4$, which are soft for $s < 0$. The first one
is struck, Eq. (26). All quantities are dimensionless, and both ends are free:
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
At the amplitude of the impact, $v_0$, the anharmonic force $|s|\,v_0^3$ and the contact force $v_0^{3/2}$ have the
ratio $\chi = |s|\,v_0^{3/2}$. The energy density of Eq. (23) and its centre, Eq. (24), locate the packet. The sums run
over the $m = 5$ sites on either side of the packet's largest density $e_{n'}$:
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + \tfrac25 (y_n-y_{n+1})_+^{5/2}, \qquad
  X = \frac{\sum_{n=n'-m}^{n'+m} n\,e_n}{\sum_{n=n'-m}^{n'+m} e_n}.$$
The article does not say where it fits speeds, for which $s$ it draws figure 19, or how it integrates. We fit between
sites 20 and 60, and take the linear well and the two soft ones that the article uses elsewhere. */
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_impact.hpp"
#include "lattice/diagnostics/path.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/orbits/floquet.hpp"
#include "lattice/orbits/shooting.hpp"
#include "report/program.hpp"
#include "sec34/packet.hpp"

using namespace lattice;
using namespace report;

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
constexpr double figure_20 = 0.94, figure_21 = 1.87, until_figure_20 = 300;  // impacts, an end
constexpr double mildly_soft = -1.0 / 6, very_soft = -0.7;  // s of the article's soft wells
constexpr double weak_speed = 0.36;  // of weak packets over (v0 / 2)^(1/2) (chapter before)

Impact impact_with(double s, double v0) {
  return {.velocity = v0,
          .chain = {std::size_t(fit_to) + 20, Quartic{s}},
          .time = 3 * fit_to / (weak_speed * std::sqrt(v0 / 2)),  // thrice what a weak packet needs
          .until = fit_to};
}

/**
## Speed and energy against impact velocity (figure 19)

For each velocity of the sweep we compute the speed, the slope of the least-squares line through $X(t)$; the largest
maximum in time of $e_{n'}$ while $20 < X < 60$; and the fractions of all energy in the packet when it passes site 60,
and on the first sites then.

A bead escapes to infinity only beyond the maximum of a soft well, at $|y| = |s|^{-1/2}$. A curve ends below the first
velocity at which a bead escapes (*The blow-up*); its last 0.05 are marked in the figure (`ending`), since the outcome
is erratic there. */
struct SweptWell {
  double s, largest_v0;
  double scan_from = 0, scan_to = 0;
};
const std::vector<SweptWell> wells = {
    {.s = 0, .largest_v0 = 2.2},
    {.s = mildly_soft, .largest_v0 = 2.2, .scan_from = 2.05, .scan_to = 2.85},
    {.s = very_soft, .largest_v0 = 1.0, .scan_from = 0.93, .scan_to = 1.33}};
constexpr double ending_over = 0.05;  // of velocity, before the first escape

/**
As $v_0 \to 0$ the dynamics becomes that of the DpS equation (section 2), in which $s$ does not occur, so the three
curves must *meet* there, with a *deficit* of the packet's energy in soft wells of first order in $\chi$. Divided by
$\chi$ it is [0.612](cell:velocity_sweep/s=-1/6/velocity=0.02/per_chi) and
[0.613](cell:velocity_sweep/s=-0.7/velocity=0.02/per_chi) in the two wells after an impact of 0.02; from 0.01 to 0.02
the deficit grows like $\chi^{1.05}$, its power still approaching one. After strong impacts the ratio is up to 2.7 times
as large, and at equal $\chi$ up to 19 per cent smaller in the softer well, apart from the erratic ends of the curves.

![Energy that a soft well takes from the packet, against the scaled anharmonicity.](fig:x57)

A soft well lowers peak and energy at *every* velocity of the sweep. The speeds are equal within their errors up to $v_0
= 0.1$ at $s = -0.7$ and up to 0.2 at $s = -\frac16$; from there on every packet is slower than in linear wells. */
struct SweepPoint {
  double velocity;
  Estimate packet{};                 // fraction of the energy in the packet at site 60
  std::optional<Estimate> linear{};  // and after this impact in linear wells
};

// Sets p.packet as well
Row sweep_row(double s, SweepPoint& p, bool ending) {
  const Impact impact = impact_with(s, p.velocity);
  const auto runs =
      refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
  const double given = p.velocity * p.velocity / 2;
  p.packet = runs.of([&](const ImpactRun& f) { return f.path.energy_at(fit_to) / given; });
  const double chi = std::abs(s) * p.velocity * std::sqrt(p.velocity);
  Estimate lost = undefined;
  if (p.linear) {
    const Estimate kept = quotient(p.packet, *p.linear);
    lost = Estimate(1 - kept.value, kept.error);
  }
  const auto late = [](const ImpactRun& f) {
    return f.path.line(fit_late, fit_to).value().estimate();
  };
  const auto peak = [](const ImpactRun& f) { return f.path.largest_peak(fit_from, fit_to).value; };

  return {{"s", s},
          {"velocity", p.velocity},
          {"chi", chi},
          {"speed", runs.of([](const ImpactRun& f) { return packet_speed(f.path, fit_to); })},
          {"beyond_site_40", runs.of(late)},
          {"peak", runs.of(peak)},
          {"packet", p.packet},
          {"first_five", runs.of([](const ImpactRun& f) { return boundary_share(f.density, 5); })},
          {"first_ten", runs.of([](const ImpactRun& f) { return boundary_share(f.density, 10); })},
          {"ending", ending},
          {"deficit", lost},
          {"per_chi", Estimate(lost.value / chi, lost.error / chi)}};
}

// In soft wells up to the first escape, `ends`
void report_sweep(Report& report, const std::vector<std::optional<double>>& ends) {
  Table& sweep = report.table("velocity_sweep");
  const double spacing = report.quick ? 0.2 : 0.01;
  std::vector<SweepPoint> linear;
  for (std::size_t w = 0; w < wells.size(); ++w) {
    const double largest = std::min(wells[w].largest_v0, ends[w].value_or(far_away));
    std::vector<SweepPoint> curve;
    for (std::size_t k = 0; spacing * double(k + 1) <= largest + 1e-9; ++k) {
      curve.push_back({spacing * double(k + 1)});
      if (w > 0) curve[k].linear = linear[k].packet;
    }
    const double last = curve.back().velocity;
    const auto row = [&](SweepPoint& p) {
      return sweep_row(wells[w].s, p, ends[w] && p.velocity > last - ending_over - spacing / 2);
    };
    sweep.fill(curve, row, "velocity sweep");
    if (w == 0) linear = curve;
  }
}

/**
## The error against the step

How good are these numbers? We repeat the impact of 0.94 at $s=-0.7$ with fixed steps and equal samples. The differences
of speed, energy and peak to a step of 1/160 fall irregularly, from 0.2 to 1/80 on the average with a power of the step
between four and five: less than the method's six, presumably as contact events fall at other places within each step.
At the longest step of the tables, 0.2, they are below $10^{-6}$. The errors in the tables are larger: they include
that of the fitted line, limited by the ripple of $X(t)$, and the distance of the samples.

![Error of speed, energy and peak against the step.](fig:x50)

A test repeats the impact by a method of order eight from the GNU Scientific Library, which shares only the forces with
ours, and asks that speed, energy and peak agree to $10^{-6}$ (`make test T=sec34`). */
struct Numbers {
  double speed, energy, peak;
};

void report_convergence(Report& report) {
  Table& table = report.table("convergence");
  Impact impact = impact_with(very_soft, figure_20);
  impact.denser = false;
  const auto with = [&](int halvings) -> Numbers {
    const Path path = strike(method_for(tolerance, largest_step, halvings), impact).path;
    return {packet_speed(path, fit_to).value, path.energy_at(fit_to),
            path.largest_peak(fit_from, fit_to).value};
  };
  const int shortest = report.quick ? 3 : 5;  // halvings of a step of 0.2
  const Numbers best = with(shortest);
  for (int halvings = 0; halvings < shortest; ++halvings) {
    const Numbers here = with(halvings);
    table.add({{"step", largest_step * std::pow(0.5, halvings)},
               {"speed", std::abs(here.speed / best.speed - 1)},
               {"energy", std::abs(here.energy / best.energy - 1)},
               {"peak", std::abs(here.peak / best.peak - 1)}});
  }
}

/**
## The surface mode (figure 20)

Where is the energy that the packet lacks? Figure 20 compares the contact forces $f_n = -(y_n-y_{n+1})_+^{3/2}$ for a
linear and a very soft well after the same impact, $v_0 = 0.94$, just below the first escape. In linear wells the packet
leaves waves behind. In the very soft ones the first contacts close again and again.

![Contact forces for a linear and a very soft well.](fig:20) */
Impact impact_of_figure_20(double s) {
  return {.velocity = figure_20, .chain = {80, Quartic{s}}, .time = until_figure_20};
}

void report_forces(Report& report) {
  Table& forces = report.table("surface_mode_forces");
  const EventCorrected method = method_for(tolerance, largest_step, 2);  // steps of 0.05
  for (double s : {0.0, very_soft}) {
    Impact impact = impact_of_figure_20(s);
    impact.every = 0.5;
    impact.denser = false;
    const auto look = [&](const State<double>& now, const std::vector<double>&) {
      const auto force = contact_forces(impact.chain, now.y);
      for (std::size_t n = 0; n < 60; ++n)  // 0 less the force is not -0 where the beads are apart
        forces.add({{"s", s}, {"t", now.t}, {"n", n + 1}, {"force", 0.0 - force[n]}});
    };
    if (strike(method, impact, look).run.escaped()) throw Failure("a bead escapes in figure 20");
  }
}

/**
At $v_0 = 0.94$ the very soft well adds more to the first five sites than it takes from the packet. But trapping is not
robust so close to the escape. At 0.95 the energy has left the first five sites, but not far: most of it is a *second
packet*, compact and slow, whose peak is at site 10 at $t = 480$ and at site 31 at 2000, while the packet that we follow
is at 64 and 228 (exercise 3). This impact and two at $s = -\frac16$, 2.08 and 2.09, are the three exceptions of the
beginning; for those, too, `run` finds the strongest site far behind the packet at $t=480$, at 12 and 22.

| $v_0$, $s$ | first five sites | first ten | packet | its speed |
|---|---|---|---|---|
| 0.94, 0 | [0.102](cell:velocity_sweep/s=0/velocity=0.94/first_five) | [0.203](cell:first_ten) | [0.441](cell:packet) | [0.183](cell:speed) |
| 0.94, $-0.7$ | [0.799](cell:velocity_sweep/s=-0.7/velocity=0.94/first_five) | [0.827](cell:first_ten) | [0.0650](cell:packet) | [0.127](cell:speed) |
| 0.95, $-0.7$ | [0.00434](cell:velocity_sweep/s=-0.7/velocity=0.95/first_five) | [0.587](cell:first_ten) | [0.156](cell:packet) | [0.134](cell:speed) |
| 0.96, $-0.7$ | [0.722](cell:velocity_sweep/s=-0.7/velocity=0.96/first_five) | [0.793](cell:first_ten) | [0.0651](cell:packet) | [0.128](cell:speed) |
| 1.87, $-\frac16$ (figure 21) | [0.592](cell:velocity_sweep/s=-1/6/velocity=1.87/first_five) | [0.620](cell:first_ten) | [0.129](cell:packet) | [0.194](cell:speed) |

Why does a soft well keep energy? In linear wells all beads oscillate at frequency 1 between contacts, whatever their
amplitude, so energy passes resonantly from one to the next. In a soft well the frequency of a free bead falls with its
amplitude, and the contacts raise it. After $v_0=0.94$ the first bead oscillates at 0.86. Its neighbours follow at this
frequency, to a fifth of a per cent, though by themselves they would be faster: they are driven below their resonance.
The fourth oscillates by itself.

Is this a mode, or only a transient? A breather is a localised periodic orbit (Flach and Gorbach 2008 for a review), and
so is a surface mode that lasts. We look for one by Newton's method (shooting.hpp): starting from rest at $y(0)$, all
beads are at rest again after half a period, $\dot y_n(T_b/2) = 0$. We fix the frequency at that of bead 1 in the run,
and start from the mean displacements of the three beads that move together when bead 1 turns back towards the end. The
method converges to a state near this mean. Its energy of [0.341](cell:surface_orbit/energy) is nearly that of the first
five sites in the run, [0.355](cell:surface_orbit/trapped).

| $s=-0.7$, $v_0=0.94$, $150 < t < 300$ | bead 1 | 2 | 3 | 4 | 5 |
|---|---|---|---|---|---|
| frequency | [0.862](cell:surface_mode/n=1/frequency) | [0.862](cell:n=2/frequency) | [0.863](cell:n=3/frequency) | [0.995](cell:n=4/frequency) | [0.99](cell:n=5/frequency) |
| of a free bead with its amplitude | [0.683](cell:surface_mode/n=1/alone) | [0.951](cell:n=2/alone) | [0.979](cell:n=3/alone) | [0.993](cell:n=4/alone) | [1.0](cell:n=5/alone) |
| displacement where bead 1 turns, mean | [0.74](cell:surface_mode/n=1/run) | [0.310](cell:n=2/run) | [0.145](cell:n=3/run) | [0.058](cell:n=4/run) | [0.024](cell:n=5/run) |
| of the periodic orbit | [0.752](cell:surface_mode/n=1/orbit) | [0.302](cell:n=2/orbit) | [0.132](cell:n=3/orbit) | [0.042](cell:n=4/orbit) | [0.011](cell:n=5/orbit) |

So the first three beads are, to ten per cent, those of a breather at the end of the chain; the next two move up to 2.3
times as far. Without precompression small oscillations have the frequency 1 only, and 0.862 and its
multiples miss it: the breather has no linear wave to radiate into. Surprisingly it is unstable:
[1](cell:surface_orbit/unstable) Floquet multiplier lies outside the unit circle, at
[-1.12](cell:surface_orbit/multiplier). A disturbance changes its sign and grows tenfold in twenty periods. Yet the
mode survives: the first five sites hold 0.80 of the energy at $t = 300$, and 0.79 still at 2000, after 270 periods
(exercise 2). It does not leave the orbit by turns to either side, as this multiplier suggests: where bead 1 turns, its
displacement swings slowly between [0.7144](cell:turnings/turn=20/y) and [0.7652](cell:turnings/turn=11/y), once in
about six turnings. What holds the mode together we do not know. */
constexpr double settled = 150;                 // time after which beads are watched
constexpr std::size_t watched = 5, locked = 3;  // beads; those of them that follow the first one
constexpr double off_circle = 1e-4;             // a multiplier farther out is unstable

struct WatchedBeads : ImpactRun {
  std::vector<Oscillation> beads{};
  std::vector<std::vector<double>> turns{};  // displacements when bead 1 turns towards the end

  double mean_at_turns(std::size_t bead) const {
    double sum = 0;
    for (const std::vector<double>& y : turns) sum += y[bead];
    return sum / double(turns.size());
  }
};

// Displacements when bead 1 was at rest between two samples, by the trapezoidal rule
std::vector<double> at_rest(const State<double>& before, const State<double>& now) {
  const double back = now.v[0] / (now.v[0] - before.v[0]);  // fraction of the interval
  std::vector<double> y = now.y;
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double then = now.v[n] + back * (before.v[n] - now.v[n]);
    y[n] -= back * (now.t - before.t) * (now.v[n] + then) / 2;
  }
  return y;
}

WatchedBeads watch_beads(const EventCorrected& method, const Impact& impact) {
  std::vector<Oscillation> beads(watched);
  std::vector<std::vector<double>> turns;
  State<double> before;
  const auto watch = [&](const State<double>& now, const std::vector<double>&) {
    if (now.t > settled) {
      for (std::size_t n = 0; n < watched; ++n) beads[n].add(now.t, now.y[n], now.v[n]);
      if (before.v[0] > 0 && now.v[0] <= 0) turns.push_back(at_rest(before, now));
    }
    before = now;
  };
  return {strike(method, impact, watch), beads, turns};  // in this order
}

struct SurfaceMode {
  double energy;
  std::complex<double> multiplier;  // the one of largest modulus
  std::size_t unstable = 0;         // multipliers outside the unit circle
  std::vector<double> y;
};

SurfaceMode surface_mode(const WatchedBeads& run) {
  const std::size_t sites = 16;  // its force on the next bead would be below rounding
  // No contact force is neglected; an orbit even in time begins at rest
  const Chain chain{sites, Quartic{very_soft}, Hertz{.negligible = 0}};
  const double omega = run.beads[0].frequency();
  Vector<double> guess = Vector<double>::Zero(sites);
  for (std::size_t n = 0; n < locked; ++n) guess[Eigen::Index(n)] = run.mean_at_turns(n);
  const Orbit<double> orbit =
      newton(Shooting<double>{chain, even_in_time(sites), omega}, guess, {.damped = true});
  SurfaceMode mode{.energy = orbit.energy, .multiplier = 0, .y = orbit.start.y};
  // Each kappa is a pair of multipliers (floquet.hpp)
  for (const auto& kappa : floquet_pairs(chain, orbit.start, orbit.period()).kappa)
    for (int sign : {-1, 1}) {
      const std::complex<double> mu = multiplier(kappa, sign);
      if (std::abs(mu) > 1 + off_circle) ++mode.unstable;
      if (std::abs(mu) > std::abs(mode.multiplier)) mode.multiplier = mu;
    }
  return mode;
}

// The impact of figure 20, and the orbit near its mean
void report_mode(Report& report) {
  const Impact impact = impact_of_figure_20(very_soft);
  const auto runs =
      refined(tolerance, [&](const EventCorrected& method) { return watch_beads(method, impact); });
  const TwoRuns<SurfaceMode> modes{surface_mode(runs.coarse), surface_mode(runs.fine)};
  Table& table = report.table("surface_mode");
  for (std::size_t n = 0; n < watched; ++n) {
    const auto alone = [n](const WatchedBeads& w) {
      return free_frequency(very_soft, w.beads[n].amplitude());
    };
    table.add(
        {{"n", n + 1},
         {"frequency", runs.of([n](const WatchedBeads& w) { return w.beads[n].frequency(); })},
         {"alone", runs.of(alone)},
         {"run", runs.of([n](const WatchedBeads& w) { return w.mean_at_turns(n); })},
         {"orbit", modes.of([n](const SurfaceMode& m) { return m.y[n]; })}});
  }
  Table& turnings = report.table("turnings");
  for (std::size_t i = 0; i < runs.coarse.turns.size(); ++i)
    turnings.add(
        {{"turn", i + 1}, {"y", runs.of([i](const WatchedBeads& w) { return w.turns[i][0]; })}});
  const auto trapped = [](const WatchedBeads& w) {
    return boundary_share(w.density) * total(w.density);
  };
  report.table("surface_orbit")
      .add({{"energy", modes.of(&SurfaceMode::energy)},
            {"trapped", runs.of(trapped)},
            {"unstable", modes.fine.unstable},
            {"multiplier", modes.of([](const SurfaceMode& m) { return m.multiplier.real(); })}});
}

/**
## A snapshot of both (figure 21)

The article shows surface mode and travelling breather together in the velocities of all beads at $t = 587$ after an
impact of 1.87 at $s = -\frac16$. We call the two *visible* if each rises above all waves between them. Both do: the
lower of the two is [1.34](cell:snapshot/prominence) times as high as the highest wave there (`prominence`, packet.hpp).

![Surface mode and packet side by side.](fig:21) */
void report_snapshot(Report& report) {
  Table& profile = report.table("surface_mode_snapshot");
  const Impact impact{
      .velocity = figure_21, .chain = {160, Quartic{mildly_soft}}, .time = 587, .every = 1};
  const auto runs =
      refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
  for (std::size_t n = 0; n < impact.chain.sites; ++n)
    profile.add({{"n", n + 1}, {"v", with_error(runs.coarse.end.v[n], runs.fine.end.v[n])}});
  const auto visible = [](const ImpactRun& run) {
    return prominence(run.end.v, *front_packet(run.density));
  };
  report.table("snapshot").add(Row{{"prominence", runs.of(visible)}});
}

/**
## Width, tail and decay of the packet

How many sites carry a packet? The article says mainly seven, up to moderate velocities, and does not say how it counts.
By energy, seven sites about the peak hold most of the eleven of Eq. (24) at all times. By *amplitude*, here
$(e_n/e_{n'})^{1/2}$, the width is read off the undisturbed side: if $k$ sites ahead of the peak ever exceed one per
cent, which a drawing still shows, the width is $2k+1$. The two answer differently. The tail is the largest amplitude on
the ten sites that follow the eleven. All is taken in linear wells while the centre moves from site 40 to 60, up to 1.5,
which the article calls moderate later in the section, for hard wells.

| $v_0$ | 0.0019 | 0.05 | 0.1 | 0.5 | 1 | 1.5 |
|---|---|---|---|---|---|---|
| energy on seven of eleven sites, at least | [0.996](cell:packet_shape/velocity=0.0019096/seven) | [0.996](cell:velocity=0.05/seven) | [0.996](cell:velocity=0.1/seven) | [0.991](cell:velocity=0.5/seven) | [0.97](cell:velocity=1/seven) | [0.950 ± 0.005](cell:velocity=1.5/seven) |
| width by amplitude (article: mainly 7) | [7](cell:packet_shape/velocity=0.0019096/width) | [7](cell:velocity=0.05/width) | [9](cell:velocity=0.1/width) | [9](cell:velocity=0.5/width) | [11](cell:velocity=1/width) | [11](cell:velocity=1.5/width) |
| amplitude of the tail (article: small) | [0.081](cell:packet_shape/velocity=0.0019096/tail) | [0.084](cell:velocity=0.05/tail) | [0.086](cell:velocity=0.1/tail) | [0.093](cell:velocity=0.5/tail) | [0.098](cell:velocity=1/tail) | [0.102](cell:velocity=1.5/tail) |

An exponential falls by one factor from each site to the next. On the six sites ahead of the packet's centre this factor
itself falls, after each of seven impacts (table `packet_decay`): the decay is faster than exponential as far as we
follow it, to an amplitude of [1e-10](cell:packet_decay/velocity=0.0019096/distance=6/amplitude) after the weakest
impact and [8e-5](cell:packet_decay/velocity=1.5/distance=6/amplitude) after the strongest. If the sites are counted
from that of the peak, which jumps from site to site, this is so up to 0.5 only. */
struct Shape : ImpactRun {
  Front front{};
};
Shape shape_of(const EventCorrected& method, const Impact& impact) {
  Front front;
  const auto watch = [&](const State<double>& now, const std::vector<double>& e) {
    const auto peak = front_packet(e);  // n'
    if (peak && now.t > 0 && energy_centre(e, *peak) > fit_late) front.add(e, *peak);
  };
  return {strike(method, impact, watch), front};  // in this order
}

void report_shape(Report& report) {
  Table &shape = report.table("packet_shape"), &decay = report.table("packet_decay");
  const double weak = 2 * 0.9548e-3;  // the impact of the chapter before
  const std::vector<double> velocities{weak, 0.05, 0.1, 0.2, 0.5, 1.0, 1.5};
  // Largest densities around the packet at two resolutions, all impacts on all cores
  std::vector<TwoRuns<Front>> fronts(velocities.size());
  parallel_for("shapes of packets", velocities.size(), [&](std::size_t i) {
    const Impact impact = impact_with(0, velocities[i]);
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return shape_of(method, impact); });
    fronts[i] = {runs.coarse.front, runs.fine.front};
  });
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const TwoRuns<Front>& front = fronts[i];
    shape.add({{"velocity", velocities[i]},
               {"width", front.of(&Front::width)},
               {"seven", front.of(&Front::seven)},
               {"tail", front.of(&Front::tail)}});
    for (std::size_t k = 1; k <= 6; ++k)
      decay.add({{"velocity", velocities[i]},
                 {"distance", k},
                 {"amplitude", front.of([k](const Front& f) { return f.from_centre(k); })},
                 {"from_peak", front.of([k](const Front& f) { return f.amplitude(k); })}});
  }
}

/**
## The blow-up

Conservation of energy gives a lower bound. No bead escapes unless the energy of the impact exceeds the maximum of the
potential:
$$v_0^2/2 > W\bigl(|s|^{-1/2}\bigr) = 1/(4|s|).$$
Above this bound escapes do not begin at one velocity: between velocities at which a bead escapes lie islands at which
none does. So we scan 801 velocities up to $t = 300$ (table `blowup_scan`) and quote a band, from the lowest velocity
with an escape to the highest without one (table `blowup_bands`).

<!-- blowup.bands -->
In two soft wells the blow-up after an impact has no single threshold. Up to $t = 300$ the smallest impact velocity at
which a bead escapes is 2.113 ± 0.001 and the largest at which none does is 2.512 ± 0.001 at $s = -\frac16$, and 0.9665
± 0.0005 and 1.1130 ± 0.0005 at $s = -0.7$; in between, bands of escape and survival alternate. (computed)
<!-- /blowup.bands -->

Every velocity is run with two steps on a chain whose last bead stays at rest. Where the *outcomes* differ, the velocity
is disputed and counts for neither edge of the band. The error of an edge is the spacing of the grid, which would miss a
narrower band. Both scans begin with survivors above the energy bound and end with escapes, none of which is late. Below
the scans there is only the sweep of figure 19, until the packet has passed site 60; no bead escapes there.

| | $s = -\frac16$ | $s = -0.7$ |
|---|---|---|
| energy bound | 1.732 | 0.845 |
| scanned | 2.05 to 2.85 | 0.93 to 1.33 |
| time of the latest escape | [46 ± 2](cell:blowup_bands/s=-1/6/latest) | [34 ± 2](cell:s=-0.7/latest) |
| disputed velocities | [0](cell:blowup_bands/s=-1/6/disputed) | [0](cell:s=-0.7/disputed) | */
constexpr double seen_every = 2;  // time after which we look again for a bead that has escaped

// The times of the escape with two steps, infinite if none is seen
struct Trial {
  double velocity, coarse = 0, fine = 0;
  bool escaped() const { return std::isfinite(fine); }
  bool agreed() const { return escaped() == std::isfinite(coarse); }
};

/// Returns where the curve of figure 19 ends: one grid spacing below the band.
double add_band(Table& bands, double s, const std::vector<Trial>& trials) {
  double first_escape = far_away, last_survivor = 0, latest = 0;
  std::size_t disputed = 0;
  for (const Trial& trial : trials)
    if (!trial.agreed()) {
      ++disputed;
    } else if (trial.escaped()) {
      first_escape = std::min(first_escape, trial.velocity);
      latest = std::max(latest, trial.fine);
    } else {
      last_survivor = std::max(last_survivor, trial.velocity);
    }
  if (!(last_survivor > 0 && first_escape < far_away))
    throw Failure("all impacts of a scan have the same outcome: choose another range");
  const double spacing = trials[1].velocity - trials[0].velocity;
  bands.add({{"s", s},
             {"first_escape", Estimate(first_escape, spacing)},
             {"last_survivor", Estimate(last_survivor, spacing)},
             {"disputed", disputed},
             {"latest", Estimate(latest, seen_every)}});
  return first_escape - spacing;
}

/// Where the curves of figure 19 end.
std::vector<std::optional<double>> report_blowup(Report& report) {
  Table &scan = report.table("blowup_scan"), &bands = report.table("blowup_bands");
  std::vector<std::optional<double>> ends;
  for (const SweptWell& well : wells) {
    ends.push_back({});
    if (well.s >= 0) continue;  // no bead can escape
    std::vector<Trial> trials(report.quick ? 31 : 801);
    for (std::size_t i = 0; i < trials.size(); ++i)
      trials[i].velocity =
          well.scan_from + (well.scan_to - well.scan_from) * double(i) / double(trials.size() - 1);
    const auto row = [&](Trial& trial) -> Row {
      const Impact impact = on_long_chain({.velocity = trial.velocity,
                                           .chain = {.well = Quartic{well.s}},
                                           .time = report.quick ? 100. : 300.,
                                           .every = seen_every,
                                           .denser = false});
      const auto escape = [&](int halvings) {
        return strike(method_for(tolerance, largest_step, halvings), impact).run.escape_time;
      };
      trial.coarse = escape(0);
      trial.fine = escape(1);
      return {{"s", well.s},
              {"velocity", trial.velocity},
              {"escaped", trial.escaped()},
              {"agree", trial.agreed()}};
    };
    scan.fill(trials, row, "blow-up band");
    ends.back() = add_band(bands, well.s, trials);
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
| `impact.trapped`: the energy is much smaller because a part of the initial energy remains trapped near n = 1 | trapped | fails 3 of 89 comparisons; first velocity_sweep.ending (s = -0.1667, velocity = 2.08) and 4 other values: 0.1786 < -0.07049; by most velocity_sweep.ending (s = -0.7, velocity = 0.95) and 4 other values: 0.1427 < -0.09785 | in part |
| `impact.blowup`: blow-up above a threshold velocity when s < 0 | threshold | blowup_scan.agree (s = -0.1667, velocity = 2.05) and 1601 other values: 2.763 < 2.85 (the closest of 6) | holds, assuming |
| `impact.surface_mode`: s = -0.7 and v_0 = 0.94 traps a surface mode near n = 1 and makes a slower packet with less energy; s = 0 traps none | trapped | velocity_sweep.speed (s = 0, velocity = 0.94), (s = -0.7, velocity = 0.94): 0.127 < 0.1832 (the closest of 4) | holds |
| `impact.snapshot`: surface mode and travelling breather at t = 587 for s = -1/6 and v_0 = 1.87 | both visible | snapshot.prominence: 1 < 1.341 | holds, assuming |
| `impact.tail`: up to moderate velocities the packet is followed by a small oscillatory tail | small | 0.102 | quantified |
<!-- /statements -->

## Try it

**To change it.** Another well of figure 19 is a row of `wells` and a curve in its script (and, to be judged, a number
in `soft_wells` of the statements). Its `largest_v0` must not exceed that of the first row, whose packets its own are
divided by; its scan has to begin with survivors and end with escapes, or the program says so. Packets end at `fit_to`.

1. *Easy.* Where is the energy in a soft well? `build/bin/sec34_impact run --s -0.7 --velocity 0.9` gives
   `boundary_energy_fraction` = 0.76318 and `packet_energy_fraction` = 0.073459. Hint: with `--s 0` the packet has 0.43,
   the first five sites 0.07, and the waves between the rest.
2. *Harder.* Does the surface mode last? `build/bin/sec34_impact run --s -0.7 --velocity 0.94 --time 1000` gives
   `boundary_energy_fraction` = 0.79077. Hint: compare with `--time 300`. What does 2.02 leave at $s = -\frac16$?
3. *Harder.* Where does the energy go after 0.95? `build/bin/sec34_impact run --s -0.7 --velocity 0.95 --time 480` gives
   `strongest_site` = 10 and `centre` = 63.854. Hint: `--profile` shows both packets, and `--time 2000` where they get.

`run` also takes other wells and contacts (commands/one_impact.hpp). */
void reproduce(Report& report) {
  report.output.note("tolerance", "end state " + short_text(tolerance));
  report_sweep(report, report_blowup(report));  // which finds where the curves end
  report_convergence(report);
  report_forces(report);
  report_mode(report);
  report_snapshot(report);
  report_shape(report);
}

int main(int argc, char** argv) {
  return run({"sec34_impact", "3.4", "Impact at one end of the chain (section 3.4, s <= 0)",
              reproduce, commands<OneImpact>()},
             argc, argv);
}
