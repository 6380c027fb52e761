/**
# 3.4 Strong impacts in soft wells: surface mode and blow-up

How do strong impacts and soft wells change the travelling breather? After a weak impact a *packet* about seven sites
wide runs along the chain (chapter before). Here we vary the impact velocity in three wells, measure the speed and
energy of the packet, and find the energy that stays behind.

      v0                                                 X(t)
     ---> (1)   (2)   (3)   (4)   (5)   (6)  ...  (n)    (n+1)   (n+2)
           |     |     |     |     |     |         |       |       |
          \_/   \_/   \_/   \_/   \_/   \_/       \_/     \_/     \_/
       surface mode                                travelling breather

![Energy density and speed of the packet against impact velocity. Drawn by fig19_impact_velocity.gp: `peak` and `speed`
against `velocity`, from the table `velocity_sweep`.](fig:19)

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) says:

- the curves of speed and energy density against impact velocity coincide for weak impacts, whatever the well;
- for strong impacts those of soft wells lie lower (figure 19), and they end where the solution blows up;
- the missing energy stays near the first bead as a *surface mode* (figures 20 and 21);
- up to moderate velocities the packet is mainly on seven sites, and a small oscillatory tail follows it.

All of this holds, with two qualifications. The blow-up has no single threshold: impacts after which a bead escapes
alternate with others over a range of velocities. And by our measure a moderate impact makes a packet of eleven sites.

## Model

The beads obey Eq. (9) with the wells of Eq. (10), $W(y) = y^2/2 + s\,y^4/4$, which are soft for $s < 0$. The first one
is struck, Eq. (26). All quantities are dimensionless, and both ends are free:
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
The energy density of Eq. (23) and its centre, Eq. (24), locate the packet. The sums run over the $m = 5$ sites on
either side of the packet's largest density $e_{n'}$:
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + \tfrac25 (y_n-y_{n+1})_+^{5/2}, \qquad
  X = \frac{\sum_{n=n'-m}^{n'+m} n\,e_n}{\sum_{n=n'-m}^{n'+m} e_n}.$$
The article does not say how far from the boundary it fits speeds, for which $s$ it draws figure 19, or how it
integrates. We fit between sites 20 and 60, and take the linear well and the two soft ones that the article uses
elsewhere. */
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_impact.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "report/program.hpp"
#include "sec34/packet.hpp"

using namespace lattice;

/**
## The experiment

We strike the chain and follow the packet until it has passed site 60. The integrator is a Runge–Kutta–Nyström method of
order six, corrected where contacts open and close (event_corrected.hpp). Steps are at most 0.2 long and samples at most
0.2 apart, about a thirtieth of an internal period. `front_packet` looks from the far end for the first site whose
energy is the largest of the eleven around it, since slower packets behind can carry as much energy. The run stops with
an error if the last bead has moved, so that nothing can have come back from there. */
constexpr double fit_to = 60;       // the packet is measured between sites 20 and 60
constexpr double tolerance = 1e-4;  // within which the end states of two runs must agree

/// The first bead of a chain at rest is struck; `look` receives every sample and may end the run.
Run impact(const EventCorrected& method, const Chain& chain, double v0, State<double>& state,
           double time, Every every, const Look& look = {}) {
  state = State<double>(chain.sites);  // y_n = 0
  state.v[0] = v0;                     // Eq. (26)
  return evolve(method, chain, state, time, every, [&](const State<double>& now) {
    if (std::abs(now.v.back()) > 1e-9 * v0) throw Failure("the motion has reached the far end");
    return look(now);
  });
}

/// What is recorded: the last state, and at each sample the packet and the first five sites.
struct Followed {
  State<double> end{};
  Run run{};                    // energy drift, steps, whether a bead escaped
  Path path{};                  // t, X, energy within m sites of the peak, e_n' at the peak
  std::vector<double> stays{};  // share of the energy that the first five sites hold
  Front front{};                // largest density at each distance from the peak, from X = 40 on
};

Followed followed(const EventCorrected& method, double s, double v0, double time,
                  double until = fit_to + 2) {
  const Chain chain{90, Quartic{s}};
  // End states can be compared only if all resolutions end at the same instant: a sample of the coarsest
  const std::size_t denser_by = std::size_t(1) << std::max(method.halvings, 0);
  std::size_t sample = 0;
  Followed out;
  out.run = impact(method, chain, v0, out.end, time, denser(0.2), [&](const State<double>& now) {
    const bool may_end = sample++ % denser_by == 0;
    const std::vector<double> e = energy_density(chain, now);  // Eq. (23)
    const auto peak = front_packet(e);                         // n'
    if (!peak || now.t == 0) return true;
    out.path.add(now.t, e, *peak);  // X, Eq. (24)
    out.stays.push_back(boundary_share(e, 5));
    const double X = out.path.centre.back();
    if (X > 40) out.front.add(e, *peak);
    return !(may_end && X >= until);
  });
  return out;
}

/**
`refined(tolerance, run)` halves the step, and the distance of the samples with it, until the *end states* of two
successive runs agree to `tolerance`, relative to their largest entry. The finer one gives the numbers, its difference
from the coarser one their errors; a third run, with twice the step, tells where those two agree by chance. If no step
is short enough, if the energy drifts, or if a bead escapes, it throws.

## Speed and energy against impact velocity (figure 19)

For each velocity of the sweep we compute three numbers of the packet: the speed, which is the slope of the
least-squares line through $X(t)$ between sites 20 and 60; the largest maximum in time of $e_{n'}$ on the same stretch,
from parabolas through three samples; and the energy within $m$ sites of the peak when the packet passes site 60. The
error of the fit is added to that of the speed. The length of the run follows from the chapter before: at small
$\epsilon = v_0/2$ the packet moves with the speed [0.361](num:sec34_dps_impact.dps_speed) times $\epsilon^{1/2}$. */
// Three times what the slowest packets need to reach the end of the stretch
double time_for(double velocity) {
  return 3 * fit_to / (0.36 * std::sqrt(velocity / 2));
}

struct SweepPoint {
  double s, velocity;
  Estimate speed{}, peak{}, energy{};

  void measure() {
    const auto runs = refined(tolerance, [&](const EventCorrected& method) {
      return followed(method, s, velocity, time_for(velocity));
    });
    speed = runs.of([](const Followed& f) { return packet_speed(f.path, fit_to); });
    peak = runs.of([](const Followed& f) { return f.path.largest_peak(fit_from, fit_to).value; });
    energy = runs.of([](const Followed& f) { return f.path.energy_at(fit_to); });
  }
};

/**
A bead that passes the maximum of a soft well, at $|y| = (-s)^{-1/2}$, escapes to infinity. So we choose for each soft
well a largest velocity of the sweep and a range in which we look for the blow-up. A curve ends below the first velocity
at which a bead escapes (`ends`, from the scan in the section on the blow-up). */
struct SweptWell {
  double s;
  std::string name;
  double fastest, band_from, band_to;
};
const std::vector<SweptWell> wells = {
    {0, "s_0", 2.5, 0, 0}, {-1.0 / 6, "s_1_6", 2.2, 2.05, 2.85}, {-0.7, "s_0_7", 1.0, 0.93, 1.33}};

using Curve = std::vector<SweepPoint>;

std::vector<Curve> report_sweep(Report& report, const std::vector<double>& ends) {
  Table& sweep =
      report.table("velocity_sweep",
                   {number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
                    estimate("speed", "speed of the packet's centre between sites 20 and 60",
                             "site per unit of time", "from two resolutions and the fit"),
                    estimate("peak", "largest maximum in time of e_n between these sites"),
                    estimate("energy", "energy of the packet when it passes site 60"),
                    count("ending", "1 in the last 0.05 of a curve that ends in a blow-up")});
  const double spacing = report.quick ? 0.05 : 0.01;
  std::vector<Curve> curves(wells.size());
  for (std::size_t w = 0; w < wells.size(); ++w) {
    Curve& curve = curves[w];
    for (long k = 1; k <= std::lround(wells[w].fastest / spacing); ++k)
      if (spacing * double(k) <= ends[w]) curve.push_back({wells[w].s, spacing * double(k)});
    const double last = curve.back().velocity;
    const auto row = [&](SweepPoint& p) {
      p.measure();
      return Cells{p.s,    p.velocity, p.speed,
                   p.peak, p.energy,   std::isfinite(ends[w]) && p.velocity > last - 0.055};
    };
    sweep.fill(curve, row, "velocity sweep");
  }
  return curves;
}

/**
As $v_0 \to 0$ the DpS equation takes over, in which $s$ does not occur. So the curves must *meet* there and not only be
close to each other: up to $v_0 = 0.05$ they should be far closer than up to 0.5. They are, and no difference of the
speeds there exceeds its error. For strong impacts, which we take to begin at $v_0 = 0.3$, a soft well lowers speed,
peak and energy at *every* velocity of the sweep: the last rows of the table are the least deficits, errors included.
The ripple of the peak density is resolved: a packet passes a site in a time comparable to its internal period, so the
largest density should depend on the phase between the two.

| fraction of the value in linear wells | article | $s = -\frac16$ | $s = -0.7$ |
|---|---|---|---|
| speeds apart, $v_0\le0.05$ | coincide | [2e-5 ± 0.0002](num:sec34_impact.ampvel_speed_s_1_6_near) | [6e-5 ± 0.0002](num:sec34_impact.ampvel_speed_s_0_7_near) |
| peaks apart, $v_0\le0.05$ | coincide | [0.0012 ± 0.0004](num:sec34_impact.ampvel_peak_s_1_6_near) | [0.0053 ± 0.0003](num:sec34_impact.ampvel_peak_s_0_7_near) |
| the same over that for $v_0\le0.5$ | | [0.021 ± 0.008](num:sec34_impact.ampvel_peak_s_1_6_near_over_far) | [0.0167 ± 0.0009](num:sec34_impact.ampvel_peak_s_0_7_near_over_far) |
| speed lower by, at least, $v_0\ge0.3$ | lower | [0.0009 ± 0.0003](num:sec34_impact.slower_speed_s_1_6) | [0.0088 ± 0.0003](num:sec34_impact.slower_speed_s_0_7) |
| peak lower by, at least | lower | [0.0236 ± 0.0006](num:sec34_impact.slower_peak_s_1_6) | [0.1074 ± 0.0004](num:sec34_impact.slower_peak_s_0_7) |
| energy lower by, at least | lower | [0.023848 ± 4e-6](num:sec34_impact.slower_energy_s_1_6) | [0.109459 ± 3e-6](num:sec34_impact.slower_energy_s_0_7) | */
using Quantity = Estimate SweepPoint::*;

void report_curves(Report& report, const std::vector<Curve>& curves) {
  const std::pair<std::string, Quantity> quantities[] = {
      {"speed", &SweepPoint::speed}, {"peak", &SweepPoint::peak}, {"energy", &SweepPoint::energy}};
  for (std::size_t w = 1; w < wells.size(); ++w)
    for (const auto& [name, of] : quantities) {
      Estimate near, far, least{far_away, 0};
      for (std::size_t k = 0; k < curves[w].size(); ++k) {  // velocity by velocity
        const Estimate linear = curves[0][k].*of, soft = curves[w][k].*of;
        const Estimate lower{1 - soft.value / linear.value,
                             (linear.error + soft.error) / linear.value};
        const Estimate apart{std::abs(lower.value), lower.error};
        const double v0 = curves[w][k].velocity;
        if (v0 < 0.0501 && apart.value > near.value) near = apart;
        if (v0 < 0.501 && apart.value > far.value) far = apart;
        if (v0 > 0.299 && lower.value - lower.error < least.value - least.error) least = lower;
      }
      const std::string which = name + "_" + wells[w].name;
      report.facts.add("slower_" + which, least);
      if (of == &SweepPoint::energy) continue;  // the article compares the other two
      report.facts.add("ampvel_" + which + "_near", near);
      if (of == &SweepPoint::peak)
        report.facts.add("ampvel_" + which + "_near_over_far", quotient(near, far));
    }
}

/**
## The surface mode (figure 20)

Figure 20 shows where the missing energy of the packet is. It compares the contact forces $f_n = -(y_n-y_{n+1})_+^{3/2}$
for a linear and a very soft well after the same impact, $v_0 = 0.94$, just below the first escape.

![Contact forces for a linear and a very soft well. Drawn by fig20_surface_mode.py: `force` over `n` and `t`, from the
table `surface_mode_forces`.](fig:20)

Why does a soft well keep energy? In linear wells all beads oscillate at frequency 1 between contacts, whatever their
amplitude, so energy passes resonantly from one to the next. In a soft well the frequency falls with the amplitude. If
the impact is strong enough, this outweighs the increase due to the contact: the first bead oscillates at a frequency
below 1, while its neighbours move less and are, by themselves, faster. So they are driven below their resonance, and
the energy stays where it is. This argument by frequencies is no proof. */
void report_forces(Report& report) {
  Table& forces = report.table("surface_mode_forces",
                               {number("s", "anharmonicity of the well"), number("t", "time"),
                                count("n", "contact between sites n and n + 1", "site"),
                                number("force", "contact force, negative where the beads touch")});
  const EventCorrected method = method_for(tolerance, largest_step, 2);  // steps of 0.05
  for (double s : {0.0, -0.7}) {
    const Chain chain{80, Quartic{s}};
    State<double> state;
    impact(method, chain, 0.94, state, 300, 0.5, [&](const State<double>& now) {
      const auto force = contact_forces(chain, now.y);
      for (std::size_t n = 0; n < 60; ++n) forces.add({s, now.t, n + 1, 0.0 - force[n]});
    });
  }
}

/**
We call energy *trapped* if the first five sites hold more than the packet long after the impact, when the packet passes
site 60. Both shares are interpolated between the two samples around that instant (table `shares`). The last row is the
impact of figure 21.

| $v_0$, $s$ | first five sites | packet | speed of the packet |
|---|---|---|---|
| 0.94, 0 | [0.101827 ± 3e-7](num:sec34_impact.trapped_linear) | [0.441095 ± 4e-6](num:sec34_impact.packet_linear) | [0.18320 ± 5e-5](num:sec34_impact.speed_linear) |
| 0.94, $-0.7$ | [0.798919 ± 1e-6](num:sec34_impact.trapped_soft) | [0.0650178 ± 4e-8](num:sec34_impact.packet_soft) | [0.12701 ± 3e-5](num:sec34_impact.speed_soft) |
| 1.87, $-\frac16$ | [0.591931 ± 2e-6](num:sec34_impact.trapped_snapshot) | [0.128864 ± 2e-7](num:sec34_impact.packet_snapshot) | [0.19420 ± 7e-5](num:sec34_impact.speed_snapshot) | */
void report_shares(Report& report) {
  struct Share {
    std::string name;
    double velocity, s;
  };
  Table& shares = report.table(
      "shares", {number("velocity", "impact velocity"), number("s", "anharmonicity of the well"),
                 estimate("first_five", "share of the energy on the first five sites"),
                 estimate("packet", "share of the energy within m sites of the packet's peak"),
                 estimate("speed", "speed of the packet", "site per unit of time",
                          "from two resolutions and the fit")});
  for (const auto& [name, v0, s] :
       {Share{"linear", 0.94, 0}, {"soft", 0.94, -0.7}, {"snapshot", 1.87, -1.0 / 6}}) {
    const auto runs = refined(
        tolerance, [v0, s](const EventCorrected& method) { return followed(method, s, v0, 900); });
    const auto trapped = runs.of([](const Followed& run) {
      Path first = run.path;
      first.energy = run.stays;
      return first.energy_at(fit_to);
    });
    const auto packet = runs.of([s](const Followed& run) {
      return run.path.energy_at(fit_to) / total(energy_density({90, Quartic{s}}, run.end));
    });
    const auto speed = runs.of([](const Followed& run) { return packet_speed(run.path, fit_to); });
    shares.add({v0, s, trapped, packet, speed});
    report.facts.add("trapped_" + name, trapped, "share of the energy");
    report.facts.add("packet_" + name, packet, "share of the energy");
    report.facts.add("speed_" + name, speed, "site per unit of time");
  }
}

/**
## A snapshot of both (figure 21)

The article shows surface mode and travelling breather together in the velocities of all beads at $t = 587$ after an
impact of 1.87 at $s = -\frac16$. We call the two *visible* if each rises above all waves between them. Both do: the
lower of the two is [1.34](num:sec34_impact.snapshot_prominence) times as high as the highest wave there.

![Surface mode and packet side by side. Drawn by fig21_snapshot.gp: `v` against `n`, from the table
`surface_mode_snapshot`.](fig:21) */
Refined<ImpactRun> states_after(double accuracy, const Chain& chain, double v0, double time) {
  return refined(accuracy, [&](const EventCorrected& method) {
    ImpactRun out;
    out.run = impact(method, chain, v0, out.end, time, denser(1));
    return out;
  });
}

void report_snapshot(Report& report) {
  const Chain chain{160, Quartic{-1.0 / 6}};
  const auto runs = states_after(tolerance, chain, 1.87, 587);
  const auto &coarse = runs.coarse.end.v, &fine = runs.fine.end.v;
  Table& profile = report.table("surface_mode_snapshot",
                                {count("n", "site", "site"), estimate("v", "velocity")});
  for (std::size_t n = 0; n < fine.size(); ++n)
    profile.add({n + 1, fine[n], std::abs(fine[n] - coarse[n])});
  report.facts.add("snapshot_prominence", runs.of([&](const ImpactRun& run) {
    return prominence(run.end.v, *front_packet(energy_density(chain, run.end)));
  }));
  report.facts.add("bead_velocity_snapshot", runs.of([](const ImpactRun& run) {
    return *std::max_element(run.end.v.begin() + 79, run.end.v.end());
  }));
}

/**
## The width and the tail of the packet

The width of a packet is read off its undisturbed side, as in the chapter before: if $k$ sites ahead of the peak ever
exceed one per cent of its amplitude, the width is $2k+1$. The tail is the largest amplitude, relative to the peak's, on
the ten sites that follow the window of Eq. (24). Both are taken in linear wells while the centre moves from site 40 to
60. The article does not define *mainly* seven sites and *moderate* velocities. The hundredth is ours, and $v_0 = 1$,
   where contacts push as hard as the wells, counts as moderate.

After such an impact the packet has [11.0](num:sec34_impact.packet_width_moderate) sites: this is beyond the DpS limit,
and two more sites on either side exceed the hundredth.

| amplitude of the tail over that of the peak | article | here |
|---|---|---|
| $v_0 = 0.05$ | small | [0.08428 ± 4e-5](num:sec34_impact.tail_gentle) |
| $v_0 = 1$ | small | [0.09840 ± 1e-5](num:impact.tail) |
| $v_0 = 1.9$ | | [0.10348 ± 2e-5](num:sec34_impact.tail_strong) | */
void report_tail(Report& report) {
  Table& shape = report.table(
      "packet_shape",
      {number("velocity", "impact velocity"),
       estimate("width", "number of sites that exceed a hundredth of the packet's peak", "site"),
       estimate("tail", "amplitude behind the packet divided by that of its peak")});
  const std::vector<double> velocities{0.05, 0.1, 0.2, 0.5, 1, 1.5, 1.9, 2.5};
  shape.fill(velocities, [&](double velocity) {
    const auto runs = refined(tolerance, [&](const EventCorrected& method) {
      return followed(method, 0, velocity, time_for(velocity), fit_to);
    });
    return Cells{velocity, runs.of([](const Followed& run) { return double(run.front.width()); }),
                 runs.of([](const Followed& run) { return run.front.tail(); })};
  });
  const auto at = [&](const std::string& column, double velocity) {
    const auto i = std::size_t(std::ranges::find(velocities, velocity) - velocities.begin());
    return Estimate{shape.numbers(column).at(i), shape.numbers(column + "_error").at(i)};
  };
  report.facts.add("packet_width_moderate", at("width", 1), "site");
  report.facts.add("tail_gentle", at("tail", 0.05));
  report.facts.add("tail_strong", at("tail", 1.9));
}

/**
## The blow-up

Conservation of energy gives a lower bound. No bead escapes unless the energy of the impact exceeds the maximum of the
potential:
$$v_0^2/2 > W\bigl((-s)^{-1/2}\bigr) = 1/(4|s|).$$
Above this bound there is no sharp threshold. The outcome depends on details of the collisions, and islands of
velocities at which no bead escapes lie between velocities at which one does. So we quote a band, from the lowest
velocity with an escape to the highest without one, on a grid of 801 velocities and up to $t = 500$ (table
`blowup_scan`). Both scans begin with survivors and end with escapes. [](finding:blowup.bands)

Every velocity is run with two steps on a chain that nothing can cross within the time. Where the *outcomes* differ, the
velocity is disputed and counts for neither edge of the band. The scans begin above the energy bound, which is 1.73 for
$s = -\frac16$ and 0.85 for $s = -0.7$. The sweep of figure 19 tests it: it has a run at every velocity from 0.01 up to
the band and would end with an error if a bead escaped.

| edge of the band, ± spacing of the grid | $s = -\frac16$ | $s = -0.7$ |
|---|---|---|
| scanned | 2.05 to 2.85 | 0.93 to 1.33 |
| lowest velocity with an escape | [2.1130 ± 0.001](num:sec34_impact.blowup_first_escape_s_1_6) | [0.9665 ± 0.0005](num:sec34_impact.blowup_first_escape_s_0_7) |
| highest velocity without | [2.5120 ± 0.001](num:sec34_impact.blowup_last_survivor_s_1_6) | [1.1130 ± 0.0005](num:sec34_impact.blowup_last_survivor_s_0_7) |
| share of disputed velocities | [0](num:sec34_impact.blowup_disputed_s_1_6) | [0](num:sec34_impact.blowup_disputed_s_0_7) | */
struct Trial {
  double velocity;
  double escape[2] = {0, 0};  // its time at two resolutions, infinite if there is none

  void measure(double s, double until) {
    const Chain chain = on_long_chain({velocity, {.well = Quartic{s}}, until}).chain;
    State<double> state;
    for (int k : {0, 1})
      escape[k] = impact(method_for(tolerance, largest_step, k), chain, velocity, state, until, 2)
                      .escape_time;
  }
  bool gone() const { return std::isfinite(escape[1]); }
  bool agreed() const { return gone() == std::isfinite(escape[0]); }
};

/**
The curves of figure 19 end one grid spacing below the band. Their last points, up to 0.05 below it, the velocity of
figure 20 among them, are erratic and are marked in the figure: the first bead almost escapes before it returns. A finer
scan would find more structure. */
std::vector<double> report_blowup(Report& report) {
  Table& scan =
      report.table("blowup_scan",
                   {number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
                    number("escape_time", "time of the blow-up; nan if the run has no blow-up"),
                    count("escaped", "1 if a bead escapes"),
                    count("agree", "1 where both resolutions agree on the outcome")});
  std::vector<double> ends;  // of the curves of figure 19
  for (const SweptWell& well : wells) {
    if (well.s >= 0) {  // no bead can escape
      ends.push_back(far_away);
      continue;
    }
    std::vector<Trial> trials(report.quick ? 31 : 801);
    for (std::size_t i = 0; i < trials.size(); ++i)
      trials[i].velocity =
          well.band_from + (well.band_to - well.band_from) * double(i) / double(trials.size() - 1);
    const auto row = [&](Trial& trial) {
      trial.measure(well.s, report.quick ? 100 : 500);
      return Cells{well.s, trial.velocity, trial.gone() ? trial.escape[1] : std::nan(""),
                   trial.gone(), trial.agreed()};
    };
    scan.fill(trials, row, "blow-up band");

    // The band, and where the well's curve ends
    const double spacing = trials[1].velocity - trials[0].velocity;
    double first = trials.back().velocity, last = trials.front().velocity, disputed = 0;
    for (const Trial& trial : trials)
      if (!trial.agreed())
        disputed += 1 / double(trials.size());
      else if (trial.gone())
        first = std::min(first, trial.velocity);
      else
        last = std::max(last, trial.velocity);
    report.facts.add("blowup_first_escape_" + well.name, {first, spacing});
    report.facts.add("blowup_last_survivor_" + well.name, {last, spacing});
    report.facts.add("blowup_disputed_" + well.name, exact(disputed));
    ends.push_back(first - spacing);
  }
  return ends;
}

/**
## An independent route

The struck chain of figure 20 is computed once more by a method of order eight from the GNU Scientific Library. It
shares only the forces with ours, and must arrive at the same state at $t = 60$: the program stops with an error if the
two differ by more than $10^{-8}$ of the largest entry. */
void check_by_gsl() {
  const Chain chain{40, Quartic{-0.7}};
  const auto runs = states_after(1e-9, chain, 0.94, 60);
  distance_from_reference(chain, struck(chain.sites, 0.94), 60, runs.fine.end,
                          1e-8);  // or it throws
}

/**
## Try it

**To change it.** Another anharmonicity in figure 19 is a row of `wells`, after the linear one and with no faster
impacts than that, and a curve in its script; a well that beads cannot leave needs no band. Another kind of well is the
second member of `Chain` in `followed`, and in the energy of `report_shares`. Another observation of the packet is a
member of `Followed`, a line in the loop of `followed`, a row of `SweepPoint::measure` and a column. The figures read
columns by name.

1. *Easy.* Where is the energy in a soft well? `build/bin/sec34_impact run --s -0.7 --velocity 0.9` gives
   `boundary_energy_fraction` = 0.76318 and `packet_energy_fraction` = 0.073459. Hint: with `--s 0` most of it travels.
2. *Harder.* How close to the escape can one go? `build/bin/sec34_impact run --s -1/6 --velocity 2.02 --time 300` gives
   `boundary_energy_fraction` = 0.68959. Hint: part of the impact's energy leaves the first bead before it reaches the
   maximum. Try 2.11, 2.3 and 2.51.

`run` also takes other wells and contacts (commands/one_impact.hpp). */
void reproduce(Report& report) {
  report.output.note("tolerance", "end state " + short_text(tolerance));
  const std::vector<double> ends = report_blowup(report);
  report_curves(report, report_sweep(report, ends));
  report_tail(report);
  report_forces(report);
  report_snapshot(report);
  report_shares(report);
  check_by_gsl();
}

int main(int argc, char** argv) {
  return run({"sec34_impact", "3.4", "Impact at one end of the chain (section 3.4, s <= 0)",
              reproduce, commands<OneImpact>()},
             argc, argv);
}
