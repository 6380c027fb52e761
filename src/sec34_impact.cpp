/**
# 3.4 Strong impacts and soft wells

The impact of the chapter before was gentle. Now strike the first bead harder, and let the wells be
soft: what runs away, and what stays?

      v0                                                 X(t)
     ---> (1)   (2)   (3)   (4)   (5)   (6)  ...  (n)    (n+1)   (n+2)
           |     |     |     |     |     |         |       |       |
          \_/   \_/   \_/   \_/   \_/   \_/       \_/     \_/     \_/
       surface mode                                travelling breather

![Energy density and speed of the packet against impact velocity.](fig:19)

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) answers: a *packet* of energy some seven sites wide, the
travelling breather, and in soft wells an oscillation that does not leave the first beads, the *surface mode*. The curves
of the packet's speed and energy density against impact velocity coincide for weak impacts, whatever the well. For strong
impacts those of soft wells lie lower, up to a velocity at which the solution blows up. Up to moderate velocities the
packet is as narrow as after a gentle impact, and a small oscillatory tail follows it. Hard wells and pendulum wells have
chapters of their own. */

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
#include "sec34/blowup_band.hpp"
#include "sec34/packet.hpp"

using namespace lattice;

/**
## Model

The beads obey Eq. (9) with the wells of Eq. (10), $W(y) = y^2/2 + s\,y^4/4$, which are soft for
$s < 0$. The first one is struck, Eq. (26). All quantities are dimensionless and both ends are free:
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}, \qquad
  y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1}.$$
The energy density of Eq. (23) and its centre, Eq. (24), say where the packet is. The sums run over
the $m = 5$ sites on either side of the packet's largest density $e_{n'}$:
$$e_n = \tfrac12\dot y_n^2 + W(y_n) + \tfrac25 (y_n-y_{n+1})_+^{5/2}, \qquad
  X = \frac{\sum_{n=n'-m}^{n'+m} n\,e_n}{\sum_{n=n'-m}^{n'+m} e_n}.$$

| article | program | meaning |
|---|---|---|
| $\dot y_1(0)$, $s$ | `velocity`, `s` | impact velocity, anharmonicity of the well |
| $e_n$, $n'$, $X$ | `density`, `peak`, `path.centre` | Eqs. (23) and (24) | */
constexpr double fit_to = 60;                  // the packet is measured between sites 20 and 60
constexpr double tolerance = usual_tolerance;  // within which two runs must agree

/**
## Method

The loop in time (impact.hpp) samples the energy density at most every 0.2 units of time, about a thirtieth of an internal
period. Several packets may leave, and the slow ones can carry as much energy as the first; `front_packet` looks from the
far end and takes the front-most. A run ends when that one has passed the stretch on which it is measured, and it is valid
only if the last bead has not moved.

Contacts open and close all the time, which spoils the order of ordinary integrators, so we use a Runge–Kutta–Nyström
method that corrects its steps at contact events (event_corrected.hpp). The step is halved, and the samples with it, until the
*end states* of two successive runs agree to `tolerance`, relative to their largest entry. The error of every derived
number is its difference between these two runs, for a speed with the error of its fit added. */
Impact followed(double s, double velocity, double time) {
  return {.velocity = velocity, .chain = {90, Quartic{s}}, .time = time, .until = fit_to + 2};
}

/**
## Speed and energy against impact velocity

For each velocity of the sweep we ask for three numbers of the packet: the speed, which is the
slope of the least-squares line through $X(t)$ between sites 20 and 60 (the article fits it away
from the boundary and says no more); the largest maximum in time of $e_n$ on the same stretch; and
the energy within $m$ sites of the peak when the packet passes site 60. How long to wait follows from
the chapter before: at small $\epsilon = v_0/2$ a packet has the speed
[0.36129](num:sec34_dps_impact.dps_speed) times $\epsilon^{1/2}$. */
struct SweepPoint {
  double s, velocity;
  Estimate speed{}, peak{}, energy{};

  void measure() {
    const double slow = 0.36 * std::sqrt(velocity / 2);  // speed in the DpS limit
    const auto runs = refined(tolerance, [&](const EventCorrected& method) {
      return strike(method, followed(s, velocity, 3 * fit_to / slow));
    });
    if (runs.fine.run.escaped()) throw Failure("an impact below the blow-up band blows up");
    const Path &coarse = runs.coarse.path, &fine = runs.fine.path;
    speed = compare(packet_speed(coarse, fit_to), packet_speed(fine, fit_to));
    peak = compare(coarse.largest_peak(fit_from, fit_to).value,
                   fine.largest_peak(fit_from, fit_to).value);
    energy = compare(coarse.energy_at(fit_to), fine.energy_at(fit_to));
  }
};

/**
The article prints no values of $s$ for its curves; we take the linear well and the two soft ones
that it uses elsewhere. A bead that passes the maximum of a soft well, at $|y| = (-s)^{-1/2}$,
runs away to infinity. So each soft well has a largest velocity worth trying, and a range
in which its blow-up is looked for. Both are our choice. */
struct SweptWell {
  double s;
  std::string name;
  double fastest, band_from, band_to;
};
const SweptWell wells[] = {
    {0, "s_0", 2.5, 0, 0}, {-1.0 / 6, "s_1_6", 2.2, 2.05, 2.85}, {-0.7, "s_0_7", 1.0, 0.93, 1.33}};

using Curve = std::vector<SweepPoint>;

/**
### Coincidence

As $v_0 \to 0$ the DpS equation takes over, in which $s$ does not occur. So the curves must *meet* there and not only be
close to each other. Up to $v_0 = 0.05$ the speeds for $s = -1/6$ differ from the linear ones by a fraction of
[2e-5](num:sec34_impact.ampvel_speed_s_1_6_near), well within the error. The peak densities differ by
[0.0012](num:sec34_impact.ampvel_peak_s_1_6_near), which is [0.021](num:sec34_impact.ampvel_peak_s_1_6_near_over_far) of
their largest difference up to $v_0 = 0.5$. */
using Quantity = Estimate SweepPoint::*;

// The fraction by which a soft well lowers it after one impact
Estimate deficit(const SweepPoint& linear, const SweepPoint& soft, Quantity of) {
  const Estimate a = linear.*of, b = soft.*of;
  return {1 - b.value / a.value, (a.error + b.error) / a.value};
}

Estimate largest_distance(const Curve& linear, const Curve& soft, double up_to, Quantity of) {
  Estimate largest;
  for (std::size_t k = 0; k < std::min(linear.size(), soft.size()); ++k) {
    if (soft[k].velocity > up_to * (1 + 1e-9)) break;
    const Estimate apart = deficit(linear[k], soft[k], of);
    if (std::abs(apart.value) > largest.value) largest = {std::abs(apart.value), apart.error};
  }
  return largest;
}

/**
### Soft wells fall behind

For strong impacts, which for us begin at $v_0 = 0.3$, a soft well lowers speed, peak and energy at *every* velocity of
the sweep up to the blow-up, where its curve ends. Where the deficit, less its error, is least, the speed is still lower
by a fraction of [0.0009](num:sec34_impact.slower_speed_s_1_6) at $s = -\frac16$ and of
[0.0088](num:sec34_impact.slower_speed_s_0_7) at $s = -0.7$, small but beyond the errors; how far the curves part at
stronger impacts is seen in figure 19. */
Estimate least_deficit(const Curve& linear, const Curve& soft, double from, Quantity of) {
  Estimate least{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k < std::min(linear.size(), soft.size()); ++k) {
    if (soft[k].velocity < from * (1 - 1e-9)) continue;
    const Estimate one = deficit(linear[k], soft[k], of);
    if (one.value - one.error < least.value - least.error) least = one;
  }
  return least;
}

void report_curves(Report& report, const std::vector<Curve>& curves) {
  const std::pair<std::string, Quantity> quantities[] = {
      {"speed", &SweepPoint::speed}, {"peak", &SweepPoint::peak}, {"energy", &SweepPoint::energy}};
  for (std::size_t w : {1, 2})
    for (const auto& [name, of] : quantities) {
      const std::string which = name + "_" + wells[w].name;
      report.facts.add("slower_" + which, least_deficit(curves[0], curves[w], 0.3, of));
      if (of == &SweepPoint::energy) continue;  // the article compares the other two
      const Estimate near = largest_distance(curves[0], curves[w], 0.05, of),
                     far = largest_distance(curves[0], curves[w], 0.5, of);
      report.facts.add("ampvel_" + which + "_near", near);
      report.facts.add("ampvel_" + which + "_near_over_far", quotient(near, far));
    }
}

/**
### Blow-up

Energy alone, whatever the integrator does, says which impacts are too weak: the impact must pay for the way to the maximum
of the potential, or no bead escapes,
$$v_0^2/2 > W\bigl((-s)^{-1/2}\bigr) = 1/(4|s|).$$
Above this bound there is no sharp threshold. The outcome depends on details of the collisions, and islands of velocities
at which no bead escapes lie between velocities at which one does. So we quote a band, from the lowest velocity with an
escape to the highest without, on a fine grid and up to a stated time (sec34/blowup_band.hpp). Every velocity is run with
two steps, and what must agree is the *outcome*; where it does not, the velocity counts for neither edge.

In both wells the scan begins with survivors and ends with escapes, but the transition is not sharp.
[](finding:blowup.bands) */
void report_band(Report& report, const SweptWell& well, const EscapeBand& band) {
  report.facts.add("blowup_first_escape_" + well.name, {band.first_escape, band.spacing});
  report.facts.add("blowup_last_survivor_" + well.name, {band.last_survivor, band.spacing});
  report.facts.add("blowup_disputed_" + well.name, exact(band.disputed));
}

/**
Inside the band the packets of those impacts that do not blow up can be faster, perhaps because the collision that keeps the
first bead from escaping feeds the packet. The curves therefore end one grid spacing below the band. Their last points, up
to 0.05 below it, where the first bead almost escapes before it returns, are erratic and are marked in figure 19: each is
right for its own velocity, but a finer scan would find more structure. */
void report_sweep(Report& report) {
  // Where do beads escape from soft wells?
  Table& scan =
      report.table("blowup_scan",
                   {number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
                    number("escape_time", "time of the blow-up, nan if there is none"),
                    count("agree", "1 where both resolutions agree on the outcome")});
  const std::size_t trials = report.quick ? 31 : 801;
  std::vector<EscapeBand> bands;
  for (const SweptWell& well : wells) {
    if (well.s == 0) continue;
    std::vector<Escape> all(trials);
    for (std::size_t i = 0; i < trials; ++i)
      all[i].velocity =
          well.band_from + (well.band_to - well.band_from) * double(i) / double(trials - 1);
    const auto row = [&](Escape& trial) {
      trial.measure(well.s, report.quick ? 100 : 500, tolerance);
      return Cells{well.s, trial.velocity, trial.gone(1) ? trial.time[1] : std::nan(""),
                   trial.agreed()};
    };
    scan.fill(all, row, "blow-up band");
    bands.push_back(band_of(all));
    report_band(report, well, bands.back());
  }

  // One curve a well, up to the velocity at which it may blow up
  Table& sweep =
      report.table("velocity_sweep",
                   {number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
                    estimate("speed", "of the centre between sites 20 and 60",
                             "site per unit of time", "of two resolutions and of the fit"),
                    estimate("peak", "largest maximum in time of e_n on the same stretch"),
                    estimate("energy", "energy of the packet when it passes site 60"),
                    count("ending", "1 in the last 0.05 of a curve that ends in a blow-up")});
  std::vector<Curve> curves;
  for (const SweptWell& well : wells) {
    const EscapeBand* band = well.s == 0 ? nullptr : &bands[curves.size() - 1];
    const double spacing = report.quick ? 0.05 : 0.01;
    Curve& curve = curves.emplace_back();
    for (long k = 1; k <= std::lround(well.fastest / spacing); ++k)
      if (!band || spacing * double(k) <= band->first_escape - band->spacing)
        curve.push_back({well.s, spacing * double(k)});
    const double last = curve.back().velocity;
    const auto row = [&](SweepPoint& p) {
      p.measure();
      return Cells{p.s, p.velocity, p.speed, p.peak, p.energy, band && p.velocity > last - 0.055};
    };
    sweep.fill(curve, row, "velocity sweep");
  }
  report_curves(report, curves);
}

/**
## How narrow, and with what tail

The width of a packet is read off its undisturbed side, as in the chapter before: if $k$ sites ahead of the peak ever exceed
one per cent of its amplitude, the width is $2k+1$. The tail is the largest amplitude, relative to the peak's, on the ten
sites that follow the window of Eq. (24). Both are taken in linear wells while the centre moves from site 40 to 60. A contact of
unit overlap pushes as hard as a well pulls back at unit displacement; so $v_0 = 1$ counts as moderate.

After such an impact the packet has [11.0000](num:sec34_impact.packet_width_moderate) sites, not seven as after a gentle one:
where the contacts push as strongly as the wells, the DpS limit is left, and two more sites on either side rise above the
hundredth. This is no contradiction to the article, which speaks of *mainly* seven sites and of *moderate* velocities
without a measure for either; the hundredth and the velocity are ours.

The tail is small, [0.09840](num:impact.tail) times the packet's amplitude. It grows with the impact velocity, from
[0.08428](num:sec34_impact.tail_gentle) at $v_0 = 0.05$ to [0.10348](num:sec34_impact.tail_strong) at $v_0 = 1.9$. */
void report_tail(Report& report) {
  struct Followed : ImpactRun {
    Front front{};
  };
  const auto follow = [](double velocity, const EventCorrected& method) {
    const double time = 3 * fit_to / (0.36 * std::sqrt(velocity / 2));
    Front front;
    const auto watch = [&](const State<double>&, const std::vector<double>& density) {
      const auto peak = front_packet(density);
      if (peak && energy_centre(density, *peak) > 40) front.add(density, *peak);
    };
    return Followed{
        strike(method, {.velocity = velocity, .chain = {90}, .time = time, .until = fit_to}, watch),
        front};
  };
  Table& shape = report.table(
      "packet_shape", {number("velocity", "impact velocity"),
                       estimate("width", "sites of the packet that exceed a hundredth", "site"),
                       estimate("tail", "amplitude behind the packet over that of its peak")});
  const std::vector<double> velocities{0.05, 0.1, 0.2, 0.5, 1, 1.5, 1.9, 2.5};
  shape.fill(velocities, [&](double velocity) {
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return follow(velocity, method); });
    const Front &coarse = runs.coarse.front, &fine = runs.fine.front;
    return Cells{velocity, compare(double(coarse.width()), double(fine.width())),
                 compare(coarse.tail(), fine.tail())};
  });
  const auto at = [&](const char* column, std::size_t i) {
    return Estimate{shape.numbers(column)[i], shape.numbers(std::string(column) + "_error")[i]};
  };
  report.facts.add("tail_moderate", at("tail", 4));
  report.facts.add("packet_width_moderate", at("width", 4), "site");
  report.facts.add("tail_gentle", at("tail", 0));
  report.facts.add("tail_strong", at("tail", 6));
}

/**
## The surface mode (figure 20)

The energy that the packet lacks must be somewhere, and figure 20 shows where. It compares the
contact forces $f_n = -(y_n-y_{n+1})_+^{3/2}$ for a linear and a very soft well after the same
impact, $v_0 = 0.94$, just below the first escape.

Why should a soft well keep energy? Between contacts all beads in linear wells swing at the frequency 1, however far they move,
and what one bead gives, the next one takes up in step. In a soft well the bead that moves far is slower. If the impact is
strong enough, this exceeds what the contact adds: in the run of the figure the first bead swings at a frequency
clearly below 1, while its neighbours move less and are, by themselves, faster. So they are pushed below their resonance,
and the energy stays where it is. After weaker impacts it travels on. This is an explanation by the frequencies and not a
proof: we have not computed the surface mode as a periodic orbit.

![Contact forces for a linear and a very soft well.](fig:20) */
void add_forces(Table& table, double s, double velocity) {
  const std::size_t shown = 60;
  const Impact impact{velocity, {80, Quartic{s}}, 300, 0.5, 1e-9, false};
  const auto watch = [&](const State<double>& now, const auto&) {
    const auto force = contact_forces(impact.chain, now.y);
    for (std::size_t n = 0; n < shown; ++n) table.add({s, now.t, n + 1, 0.0 - force[n]});
  };
  strike(method_for(tolerance, largest_step, 2), impact, watch);
}

/**
Energy is *trapped* if the first five sites hold more than the packet when the packet passes site 60, long after the
impact. In the soft well the first five sites keep [0.798919](num:sec34_impact.trapped_soft) of the energy, and the packet takes
[0.0650178](num:sec34_impact.packet_soft) and travels at [0.12701](num:sec34_impact.speed_soft) sites per unit of time; in the
linear well it is [0.101827](num:sec34_impact.trapped_linear) against [0.441095](num:sec34_impact.packet_linear), and the
packet has the speed [0.18320](num:sec34_impact.speed_linear). */
struct Shares {
  Estimate trapped, packet, speed;
};

Shares shares(double s, double velocity) {
  struct Shared : ImpactRun {
    Path boundary{};  ///< that of the packet, with the share of the first five sites as its energy
  };
  const auto run = [&](const EventCorrected& method) {
    std::vector<double> held;
    const auto watch = [&](const State<double>& now, const std::vector<double>& density) {
      if (now.t > 0 && front_packet(density)) held.push_back(boundary_share(density));
    };
    Shared out{strike(method, followed(s, velocity, 900), watch)};
    out.boundary = out.path, out.boundary.energy = held;
    return out;
  };
  const auto runs = refined(tolerance, run);
  const Shared &coarse = runs.coarse, &fine = runs.fine;
  const auto packet = [](const ImpactRun& out) {
    return out.path.energy_at(fit_to) / total(out.density);
  };
  return {compare(coarse.boundary.energy_at(fit_to), fine.boundary.energy_at(fit_to)),
          compare(packet(coarse), packet(fine)),
          compare(packet_speed(coarse.path, fit_to), packet_speed(fine.path, fit_to))};
}

/**
## A snapshot (figure 21)

The article shows the surface mode and the travelling breather together, in the velocities of all beads
at one instant. In between there are other waves, a slow second packet among them. We call the two
*visible* if each rises above everything that lies between them. Both do: the lower of the two is
[1.34120](num:sec34_impact.snapshot_prominence) times as high as the highest wave there.

![Surface mode and packet side by side.](fig:21) */
void report_surface(Report& report) {
  // The same impact on a linear and on a soft well
  Table& forces = report.table("surface_mode_forces",
                               {number("s", "anharmonicity of the well"), number("t", "time"),
                                count("n", "contact of sites n and n + 1", "site"),
                                number("force", "contact force, negative where the beads touch")});
  for (double s : {0.0, -0.7}) add_forces(forces, s, 0.94);
  const Shares linear = shares(0, 0.94), soft = shares(-0.7, 0.94), shown = shares(-1.0 / 6, 1.87);

  // One instant at which both excitations are seen
  const auto runs = refined(tolerance, [&](const EventCorrected& method) {
    return strike(method, {1.87, {160, Quartic{-1.0 / 6}}, 587, 1});
  });
  const auto &coarse = runs.coarse.end.v, &fine = runs.fine.end.v;
  Table& profile = report.table("surface_mode_snapshot",
                                {count("n", "site", "site"), estimate("v", "velocity")});
  for (std::size_t n = 0; n < fine.size(); ++n)
    profile.add({n + 1, fine[n], std::abs(fine[n] - coarse[n])});
  const auto rises = [](const ImpactRun& out) {
    return prominence(out.end.v, *front_packet(out.density));
  };
  report.facts.add("snapshot_prominence", compare(rises(runs.coarse), rises(runs.fine)));
  const auto fastest_ahead = [](const std::vector<double>& v) {
    return *std::max_element(v.begin() + 79, v.end());
  };
  report.facts.add("bead_velocity_snapshot", compare(fastest_ahead(coarse), fastest_ahead(fine)));

  // How packet and boundary share the energy, in the snapshot's run too
  const std::pair<std::string, const Shares&> rows[] = {
      {"linear", linear}, {"soft", soft}, {"snapshot", shown}};
  for (const auto& [name, s] : rows) {
    report.facts.add("trapped_" + name, s.trapped, "share of the energy");
    report.facts.add("packet_" + name, s.packet, "share of the energy");
    report.facts.add("speed_" + name, s.speed, "site per unit of time");
  }
}

/**
## Checks

A state on which our runs agree could still be wrong. So the struck chain of figure 20 is computed
once more by an independent method, GSL's of order eight, and must arrive at the same state. */
void report_check(Report& report) {
  const double time = 60;
  const Impact impact{0.94, {40, Quartic{-0.7}}, time, 1};
  const auto runs =
      refined(1e-9, [&](const EventCorrected& method) { return strike(method, impact); });
  const double apart =
      distance_from_reference(impact.chain, struck(40, 0.94), time, runs.fine.end, 1e-8);
  report.facts.add("independent_route_difference", {apart, runs.error});
}

/**
## Differences and limits

The article does not say how far from the boundary it fits speeds, for which $s$ it draws figure 19, or how it integrates;
our choices are stated where they are made. The ripple on the peak density of figure 19 is resolved. A packet passes a
site in a time comparable to its internal period, so that the largest density should depend on the phase between the
two. */
void reproduce(Report& report) {
  report.output.note("tolerance", "end state " + short_text(tolerance));
  report_sweep(report);
  report_tail(report);
  report_surface(report);
  report_check(report);
}

/**
## Try it

1. *Easy.* Where is the energy in a soft well? `build/bin/sec34_impact run --s -0.7 --velocity 0.9` gives
   `boundary_energy_fraction` = 0.76318 and `packet_energy_fraction` = 0.073459. Hint: with `--s 0` most of it travels; a
   soft well lowers the frequency of a bead that moves far.
2. *Harder.* By which power of the impact does the speed grow without wells?
   `build/bin/sec34_impact run --well none --velocity 1` gives `speed` = 0.840509, and
   `build/bin/sec34_impact run --well none --velocity 4` gives `speed` = 1.109058. Hint: scale lengths and times in
   $\ddot y = y^{3/2}$; the power is one fifth.
3. *Harder.* How close to the escape can one go? `build/bin/sec34_impact run --s -1/6 --velocity 2.02 --time 300` gives
   `boundary_energy_fraction` = 0.68959. Hint: the energy bound is $v_0 = (2|s|)^{-1/2} = 1.73$; part of the impact's energy
   leaves the first bead before it comes to the maximum. Try 2.11, 2.3 and 2.51.
4. *Open.* Is there a fastest packet at $s = -1/6$? Why are there just these bands of survival?
5. *Open.* Is the surface mode a time-periodic breather of the half-chain? Compute it by Newton's method.

## With your own parameters

`build/bin/sec34_impact run` measures a single impact, also for other wells and contacts (one_impact.hpp). */
int main(int argc, char** argv) {
  return run({"sec34_impact", "3.4", "Impact at one end of the chain (section 3.4, s <= 0)",
              reproduce, commands<OneImpact>()},
             argc, argv);
}
