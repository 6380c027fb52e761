/**
# 3.4 Strong impacts and soft wells

Section 3.4 of James, Kevrekidis and Cuevas (Physica D 251, 2013) hits the first bead of a
resting chain and watches what runs away from it. This program turns the impact up and the
wells soft ($s \le 0$), and draws figures 19, 20 and 21. The weak impact and its DpS
approximation are the chapter before; hard wells ($s > 0$), where the packet turns round, and
pendulum wells, where it becomes a kink, have chapters of their own.

What is claimed, with the identifiers under which the answers are recorded:

- speed and energy for several $s \le 0$ coincide at small impact (`impact.ampvel`) and fall
  behind at large one (`impact.slower`), up to a blow-up (`impact.blowup`);
- what is missing stays behind as a surface mode (`impact.surface_mode`,
  `impact.snapshot`). */

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lattice/measure/impact.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/model_options.hpp"
#include "lattice/report/program.hpp"
#include "lattice/stepping/reference.hpp"

using namespace lattice;

/**
## Model

The beads obey Eq. eqm with the wells of Eq. anpot,
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(0) = 0,\quad \dot y_n(0) = v_0\,\delta_{n,1},$$
with a free end at $n = 1$. All quantities are dimensionless. The chain is as long as
the run needs: nothing ever returns from the far end.

| article | program | meaning |
|---|---|---|
| $\dot y_1(0)$ | `velocity` | impact velocity |
| $s$ | `s` | anharmonicity of the well |
| $X$, $e_n$ | `Track::centre`, `energy_density` | energy centre and density (Eqs. encenter, endens) |

## Method

The chain is integrated by a Runge–Kutta–Nyström method that knows about contact
(contact_rkn.hpp says why that matters). We state a tolerance for the end state, relative
to its largest entry; the step is halved until two runs in a row agree to it, and each
derived number carries the difference of these two runs as its error. Beads ahead of the
front rest exactly and cost nothing. */
constexpr double tolerance = 1e-4;

/**
## Speed and energy against impact velocity (figure 19)

A run ends when the packet has passed site 60, so that every velocity is measured over the
same forty sites. The largest energy density is that of the same stretch. A soft well
lets go of a bead that passes its rim at $|y| = (-s)^{-1/2}$, and beyond some velocity the
first bead does: the solution blows up and the curve ends.

![Energy density and speed of the packet against impact velocity.](fig:19) */
constexpr double fit_to = 60;

struct SweepPoint {
  double s, velocity;
  bool blows_up = false;
  Estimate speed{}, peak{}, energy{};
};

void measure(SweepPoint& point) {
  const double slow = 0.36 * std::sqrt(point.velocity / 2);  // speed in the DpS limit
  const auto runs =
      follow_to(tolerance, {point.velocity, point.s, 3 * fit_to / slow, 90}, fit_to + 2, 0.2);
  if ((point.blows_up = runs.fine.run.escaped())) return;
  const Track &coarse = runs.coarse.track, &fine = runs.fine.track;
  point.speed = compare(packet_speed(coarse, fit_to), packet_speed(fine, fit_to));
  point.peak = compare(coarse.largest_peak(fit_from, fit_to), fine.largest_peak(fit_from, fit_to));
  point.energy = compare(coarse.energy.back(), fine.energy.back());
}

/// `count` velocities from `from` to `to` for one s.
std::vector<SweepPoint> grid(double s, double from, double to, std::size_t count) {
  std::vector<SweepPoint> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back({s, from + (to - from) * double(k) / double(count - 1)});
  return points;
}

/// The wells that we show, each with the largest velocity tried and the grid of its blow-up band.
/// The article prints no values of s for this figure; it uses these three elsewhere.
struct Well {
  double s, fastest, band_from, band_to;
};
const Well wells[] = {{0, 2.5, 0, 0}, {-1.0 / 6, 2.2, 2.05, 2.85}, {-0.7, 1.0, 0.93, 1.33}};

/**
Close to the threshold the outcome depends on details of the collisions, and islands of
surviving velocities lie between escaping ones. We therefore quote a band, from the lowest
velocity that escapes to the highest one that survives, on a fine grid and up to a stated
time; a longer wait can only lower its lower edge. Every velocity runs at both steps, and
where they disagree it counts for neither edge. */
struct Band {
  double first_escape, last_survivor, spacing;
};

Band blowup_band(const Well& well, std::size_t count, double time, Table& scan) {
  std::vector<double> velocity(count), escape[2] = {velocity, velocity};
  Progress progress("blow-up band", count);
  parallel_for(count, [&](std::size_t i) {
    velocity[i] = well.band_from + (well.band_to - well.band_from) * double(i) / double(count - 1);
    for (std::size_t k : {0, 1}) {
      const ContactAware stepper{k ? 0.1 : 0.2};
      const Chain<Quartic, Hertz> chain{100, {well.s}};
      State<double> state = struck(chain.sites, velocity[i]);
      escape[k][i] = evolve(stepper, chain, state, time, 2, Unobserved{}).escape_time;
    }
    progress.tick();
  });
  Band band{well.band_to, well.band_from, velocity[1] - velocity[0]};
  for (std::size_t i = 0; i < count; ++i) {
    const bool gone[] = {std::isfinite(escape[0][i]), std::isfinite(escape[1][i])};
    if (gone[0] && gone[1]) band.first_escape = std::min(band.first_escape, velocity[i]);
    if (!gone[0] && !gone[1]) band.last_survivor = std::max(band.last_survivor, velocity[i]);
    scan.add({well.s, velocity[i], gone[1] ? escape[1][i] : std::nan(""),
              std::int64_t(gone[0] == gone[1])});
  }
  return band;
}

/// One row a velocity; the same velocities for every well, as far as each goes.
std::vector<std::vector<SweepPoint>> velocity_sweep(double spacing) {
  std::vector<std::vector<SweepPoint>> curves;
  std::vector<SweepPoint*> all;
  for (const Well& well : wells)
    curves.push_back(
        grid(well.s, spacing, well.fastest, std::size_t(std::lround(well.fastest / spacing))));
  for (auto& curve : curves)
    for (auto& point : curve) all.push_back(&point);
  Progress progress("velocity sweep", all.size());
  parallel_for(all.size(), [&](std::size_t i) {
    measure(*all[i]);
    progress.tick();
  });
  return curves;
}

Table sweep_table(const std::vector<std::vector<SweepPoint>>& curves) {
  Table table{{number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
               number("speed", "sites per unit of time, centre between sites 20 and 60", "site"),
               number("speed_error", "difference of two resolutions and error of the fit", "site"),
               number("peak", "largest energy density on the same stretch"),
               number("peak_error", "difference of two resolutions"),
               number("energy", "energy of the packet when it passes site 60"),
               number("energy_error", "difference of two resolutions")}};
  for (const auto& curve : curves)
    for (const SweepPoint& p : curve)
      if (!p.blows_up)
        table.add({p.s, p.velocity, p.speed.value, p.speed.error, p.peak.value, p.peak.error,
                   p.energy.value, p.energy.error});
  return table;
}

/// By how much, relatively, a quantity of the second curve lies below that of the first: the
/// largest difference up to `velocity`, and the least deficit, less its error, beyond it.
template <class Of>
std::pair<double, double> compare_curves(const std::vector<SweepPoint>& linear,
                                         const std::vector<SweepPoint>& soft, double velocity,
                                         Of of) {
  double apart = 0, deficit = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(linear.size(), soft.size()); ++k) {
    const Estimate a = of(linear[k]), b = of(soft[k]);
    const double gap = 1 - b.value / a.value, error = (a.error + b.error) / a.value;
    if (soft[k].velocity <= velocity)
      apart = std::max(apart, std::abs(gap) + error);
    else
      deficit = std::min(deficit, gap - error);
  }
  return {apart, deficit};
}

/**
The curves are said to coincide at small velocity: we ask for one per cent in speed and peak
density up to $v_0 = 0.05$. From $v_0 = 0.3$ to the blow-up band, where each curve ends, a soft
well must lower the speed, the peak and the energy of the packet at every velocity by more
than the errors. (Inside the band the few survivors can be faster: the collision that saves
the first bead feeds the packet.) */
void report_sweep(Report& report) {
  auto curves = velocity_sweep(report.quick ? 0.05 : 0.01);
  Table scan{{number("s", "anharmonicity of the well"), number("velocity", "impact velocity"),
              number("escape_time", "time of the blow-up, nan if there is none"),
              count("agree", "1 where both resolutions agree on the outcome")}};
  bool coincide = true, lower = true, thresholds = true;
  for (std::size_t w : {1, 2}) {
    const Well& well = wells[w];
    const Band band = blowup_band(well, report.quick ? 31 : 801, report.quick ? 200 : 1000, scan);
    thresholds =
        thresholds && band.first_escape > well.band_from && band.last_survivor < well.band_to;
    std::erase_if(curves[w], [&](const SweepPoint& p) { return p.velocity >= band.first_escape; });
    const std::string name = w == 1 ? "_s_1_6" : "_s_0_7";
    report.facts.add("first_escape" + name, {band.first_escape, band.spacing});
    report.facts.add("last_survivor" + name, {band.last_survivor, band.spacing});
    const auto judge = [&](const std::string& quantity, bool needed, auto of) {
      const double apart = compare_curves(curves[0], curves[w], 0.05, of).first;
      const double deficit = compare_curves(curves[0], curves[w], 0.3, of).second;
      coincide = coincide && (!needed || apart < 0.01);
      lower = lower && deficit > 0;
      report.facts.add(quantity + "_apart_at_small_velocity" + name, {apart, 0});
      report.facts.add(quantity + "_least_deficit" + name, {deficit, 0});
    };
    judge("speed", true, [](const SweepPoint& p) { return p.speed; });
    judge("peak", true, [](const SweepPoint& p) { return p.peak; });
    judge("energy", false, [](const SweepPoint& p) { return p.energy; });
  }
  report.output.add("velocity_sweep", sweep_table(curves));
  report.output.add("blowup_scan", std::move(scan));
  report.results.claim("impact.ampvel", coincide);
  report.results.claim("impact.slower", lower);
  report.results.claim("impact.blowup", thresholds);
}

/**
## The surface mode (figures 20 and 21)

Much of the energy that the packet lacks stays at the boundary. Figure 20 compares the contact
forces for a linear and a very soft well, figure 21 shows both excitations in a snapshot of
the velocities. Whether a mode is trapped we decide by the share of the energy on the first
five sites when the packet passes site 60, long after the impact.

![Contact forces for a linear and a very soft well.](fig:20)
![Surface mode and packet side by side.](fig:21) */
struct Surface {
  Estimate trapped, packet, speed;
};

Surface surface(double s, double velocity) {
  const auto runs = follow_to(tolerance, {velocity, s, 900, 90}, fit_to + 2, 0.2);
  const Outcome &coarse = runs.coarse, &fine = runs.fine;
  const auto share = [](const Outcome& out) {
    return out.track.energy.back() / total(out.density);
  };
  Estimate speed = compare(packet_speed(coarse.track, fit_to), packet_speed(fine.track, fit_to));
  return {compare(boundary_share(coarse.density), boundary_share(fine.density)),
          compare(share(coarse), share(fine)), speed};
}

/// Contact forces f_n = -(y_n - y_{n+1})_+^{3/2} on a grid of times and sites.
void add_forces(Table& table, double s, double velocity) {
  const std::size_t sites = 80, shown = 60;
  follow(stepper_for(tolerance, largest_step / 4), {velocity, s, 300, sites}, far_away, 0.5,
         [&](const State<double>& now, const std::vector<double>&) {
           const auto force = contact_forces(Chain<Quartic, Hertz>{sites, {s}}, now.y);
           for (std::size_t n = 0; n < shown; ++n)
             table.add({s, now.t, std::int64_t(n + 1), 0.0 - force[n]});
         });
}

Table snapshot(double s, double velocity, double time) {
  const auto runs = follow_to(tolerance, {velocity, s, time, 160}, far_away, 1);
  const Outcome &coarse = runs.coarse, &fine = runs.fine;
  Table table{{count("n", "site", "site"), number("v", "velocity"),
               number("v_error", "difference of two resolutions")}};
  for (std::size_t n = 0; n < fine.end.v.size(); ++n)
    table.add({std::int64_t(n + 1), fine.end.v[n], std::abs(fine.end.v[n] - coarse.end.v[n])});
  return table;
}

void report_surface(Report& report) {
  Table forces{{number("s", "anharmonicity of the well"), number("t", "time"),
                count("n", "contact of sites n and n + 1", "site"),
                number("force", "contact force, negative where the beads touch")}};
  for (double s : {0.0, -0.7}) add_forces(forces, s, 0.94);
  report.output.add("surface_mode_forces", std::move(forces));
  report.output.add("surface_mode_snapshot", snapshot(-1.0 / 6, 1.87, 587));

  const Surface linear = surface(0, 0.94), soft = surface(-0.7, 0.94);
  const Surface shown = surface(-1.0 / 6, 1.87);
  report.results.claim("impact.surface_mode", soft.trapped.value > 0.5 &&
                                                  soft.trapped.value > 3 * linear.trapped.value &&
                                                  soft.speed.value < linear.speed.value);
  report.results.claim("impact.snapshot", shown.trapped.value > 0.2 && shown.packet.value > 0.05);
  const std::pair<std::string, const Surface&> rows[] = {
      {"linear", linear}, {"soft", soft}, {"snapshot", shown}};
  for (const auto& [name, s] : rows) {
    report.facts.add("trapped_" + name, s.trapped, "share of the energy");
    report.facts.add("packet_" + name, s.packet, "share of the energy");
    report.facts.add("speed_" + name, s.speed, "site per unit of time");
  }
}

/**
## Checks

Every number comes from two runs whose end states agree to the tolerance. Here the struck chain of
figure 20 takes the independent route, GSL's adaptive method of order eight, and must arrive at the
same state. */
void report_check(Report& report) {
  const double time = 60;
  const auto runs = follow_to(1e-9, {0.94, -0.7, time, 40}, far_away, 1);
  State<double> theirs = struck(40, 0.94);
  evolve_reference(Chain<Quartic, Hertz>{40, {-0.7}}, theirs, time, 1e-13);
  theirs.t = runs.fine.end.t;
  const double apart = distance(theirs, runs.fine.end);
  if (!(apart < 1e-8)) throw Failure("our integrator and GSL's disagree by " + number_text(apart));
  report.facts.add("independent_route_difference", {apart, runs.error});
}

/**
## One impact with your own parameters

`sec34_impact run --velocity 1.87 --s -0.1667 --time 587` measures a single impact in the same
way, with any well and with precompression. The speed is fitted from site 20 to twenty sites
before the far end, on the way out; where the packet never gets there it is `nan`. Over a long
stretch a packet slows down as it sheds energy, so the value depends on the window. A runaway is a failure,
because nothing of what was asked for exists then. */
struct RunOptions {
  Impact impact{1.87, {}, 600, 0};
  bool profile = false;
  double tolerance = ::tolerance;

  /// Completes what the reader left open: a chain that the motion does not reach the end of.
  Impact complete() const {
    Impact out = impact;
    if (out.sites == 0) out.sites = std::min<std::size_t>(100 + std::size_t(2 * out.time), 4000);
    return out;
  }
};

Table run_quantities(const Impact& impact, const Outcome& coarse, const Outcome& fine) {
  const double to = double(impact.sites) - 20, undefined = std::nan("");
  const auto both = [&](auto of) { return compare(of(coarse), of(fine)); };
  const auto tracked = [&](auto of) {
    return both([&](const Outcome& out) { return out.track.t.empty() ? undefined : of(out); });
  };
  Quantities q;
  const auto line = [&](const Outcome& out) {
    return out.track.line(fit_from, to).value_or(Line{undefined, undefined, undefined});
  };
  Estimate speed = compare(line(coarse).slope, line(fine).slope);
  speed.error += line(fine).slope_error;
  q.add("speed", speed, "site per unit of time");
  q.add("centre", tracked([](const Outcome& out) { return out.track.centre.back(); }), "site");
  q.add("peak_energy_density", both([&](const Outcome& out) {
          const double peak = out.track.largest_peak(fit_from, to);
          return peak > 0 ? peak : undefined;
        }));
  q.add("packet_energy_fraction",
        tracked([](const Outcome& out) { return out.track.energy.back() / total(out.density); }));
  q.add("boundary_energy_fraction",
        both([](const Outcome& out) { return boundary_share(out.density); }));
  q.add("energy_drift", {fine.run.energy_drift, coarse.run.energy_drift});
  q.add("escaped", both([&](const Outcome& out) {
          return out.reach > rim_of(impact.model.onsite) ? 1.0 : 0.0;
        }));
  return q.table;
}

Table run_profile(const Outcome& fine) {
  Table table{{count("n", "site", "site"), number("y", "displacement"), number("v", "velocity"),
               number("e", "energy density")}};
  for (std::size_t n = 0; n < fine.density.size(); ++n)
    table.add({std::int64_t(n + 1), fine.end.y[n], fine.end.v[n], fine.density[n]});
  return table;
}

Table run_command(const RunOptions& options) {
  const Impact impact = options.complete();
  const auto runs = follow_to(options.tolerance, impact, far_away, 0.2);
  const Outcome &coarse = runs.coarse, &fine = runs.fine;
  if (fine.run.escaped())
    throw Failure("the solution blows up at t = " + std::to_string(fine.run.escape_time) +
                  ": --velocity is beyond the threshold of this well");
  return options.profile ? run_profile(fine) : run_quantities(impact, coarse, fine);
}

/**
## Differences and limits

The article does not say how far from the boundary it fits speeds, for which $s$ it draws
figure 19, or how it integrates; our choices stand where they are made. The ripple on the
peak density of figure 19 is resolved and real: a packet passes a site in a time
comparable to its internal period, and the largest value depends on how the two beats meet. Just below the
blow-up band the soft curves become erratic: the first bead all but escapes, and what it gives
back on its return feeds the packet. Their last points, marked in the figure, are right for their
velocities, but a finer scan would find more structure.

## Extensions

- How does the speed depend on the amplitude alone, and is there a fastest packet at $s = -1/6$?
- What do the islands of survival in `blowup_scan` look like on a finer grid?
- Is the surface mode a time-periodic breather of the half-chain? Compute it by Newton. */
int main(int argc, char** argv) {
  Program program({"sec34_impact", "3.4", "Impact at one end of the chain (section 3.4, s <= 0)"},
                  argc, argv);
  RunOptions options;
  CLI::App* run = program.command("run", "one impact: speed, centre, energies of the packet",
                                  [&] { return run_command(options); });
  Impact& impact = options.impact;
  run->add_option("--velocity", impact.velocity, "impact velocity")->check(in_range(1e-6, 100));
  run->add_option("--time", impact.time, "length of the run")->check(in_range(1, 1e5));
  run->add_option("--sites", impact.sites, "chain length (default: as long as needed)")
      ->check(in_range(2, 1e6));
  add_model_options(*run, impact.model);
  run->add_option("--tolerance", options.tolerance, "relative error allowed in the end state")
      ->check(in_range(1e-11, 0.1));
  run->add_flag("--profile", options.profile, "print the final profile n,y,v,e instead");

  program.everything = [&](Output& output) {
    output.note("tolerance", "end state " + short_text(tolerance));
    Report report{output, program.quick};
    report_sweep(report);
    report_surface(report);
    report_check(report);
    output.add("facts", report.facts.table);
    return report.results;
  };
  return program.run(argc, argv);
}
