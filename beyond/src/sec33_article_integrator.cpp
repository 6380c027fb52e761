/**
# Appendix: which integrator did the article use?

Six numbers of sections 3.2 and 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) depend on how the chain was
integrated. They belong to $\omega_b = 1.1$, $T_b = 2\pi/\omega_b$, in wells with the anharmonicity $s$, Eq. (10), which
is zero unless it is varied:

| number | printed |
|---|---|
| Newton's residual for the site-centred breather, after five iterations | $1.5\cdot10^{-9}$ |
| barrier $E_{PN} = \mathcal H_{\rm site}-\mathcal H_{\rm bond}$ | $1.77\cdot10^{-11}$ |
| $s$ at which the site-centred breather changes its stability | 0.05 |
| the same for the bond-centred one | 0.26 |
| size $c_c$ of the kick beyond which the bond-centred breather is free | $6.19\cdot10^{-6}$ |
| sites that the site-centred one jumps, to stay there, after a *weak* kick, of $3\cdot10^{-6}$ | 2 |

A kick adds velocities along the *pinning mode*, the direction of a shift along the chain; its size is their norm. The
residual seems to tell how accurate the article's breathers were (below it has another source); all others come out
differently when the integration is converged. The printed barrier differs from the converged one by no more than
breathers of that residual allow (`sec32_barrier`), the threshold and the two values of $s$ are discussed in their
chapters, and the jump has no explanation there. The article does not say which integrator it used. Here we ask whether
*one* choice, a method and a number of steps per period, explains them all. A setting is compatible with the printed
numbers or it is not; neither says what was done. */

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"
#include "sec33/printed_numbers.hpp"
#include "sec33/uncorrected.hpp"

using namespace lattice;

/**
## An adaptive method: the barrier

The chain is that of Eqs. (6) to (9). The force of a contact grows like the power $3/2$ of the overlap, so it is not
smooth at the instant at which the contact opens or closes, and an integrator that steps across this *contact event*
loses accuracy there. Our own steps correct for it (contact_rkn.hpp); nothing in the article says that its did.

The first trial puts an adaptive Runge-Kutta method without the correction into Newton's iteration for the two breathers
(uncorrected.hpp). It starts from the accurate breather, so that the residual is the error of the integration alone;
what a start from the DpS profile leaves is asked below. The iteration solves the equations with the breather's
symmetries, after half a period around a bond and a quarter around a site (symmetry.hpp), or those of the article, that
all beads return after one period. We record the residual that remains, to be compared with the printed one, and the
barrier that comes with it. */
// What it leaves
/**
With the symmetric equations the results resemble the printed ones. At the tolerance $10^{-9}$ both residuals are
between one and a half and two times the printed one, and the barrier is less than two per cent below the printed one;
at $10^{-8}$ only the bond-centred residual is as near, and the barrier is less than one per cent above. Of our ten
trials [1](num:sec33_article_integrator.adaptive_near_both) is near the printed residual and the printed barrier at
once, by the bounds of the section after next. With the equations of the article none of the five tolerances comes near
both: the barrier is far too high at first and too low at $10^{-11}$; at $10^{-12}$ it is converged, and the residual is
no longer near. So an adaptive method of a common tolerance *can* give both numbers. But this singles out nothing. The
converged barrier, [1.62422e-11](num:pn.omega11), is only eight per cent below the printed one; and with five other
adaptive methods, tried once by a program that is not part of this repository, the tolerance at which the residual is
near lies between $10^{-9}$ and $10^{-14}$, as the method and its control of errors have it. Wherever it was near, with
the symmetric equations, the barrier was between 1.56 and $1.98\cdot10^{-11}$. */
Cells barrier_trial(bool whole_period, double tolerance) {
  std::array<UncorrectedEnd, 2> ends{};
  for (std::size_t k : {0U, 1U}) {
    Shooting<double> problem = problem_of(both_centres[k], Setting::omega_b);
    const State<double> start = find_breather(problem).start;
    if (whole_period) problem.symmetry = returning(problem.chain.sites);
    ends[k] = uncorrected_newton(problem, start, tolerance);
  }
  return {tolerance, whole_period ? "full" : "symmetric", ends[0].residual, ends[1].residual,
          ends[0].energy - ends[1].energy};
}

void report_barrier_trials(Report& report) {
  std::vector<std::pair<bool, double>> trials;
  for (bool whole_period : {false, true})
    for (double tolerance : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12})
      trials.emplace_back(whole_period, tolerance);
  Table& table =
      report.table("barrier_trials", {number("tolerance", "of the adaptive integration"),
                                      label("equations", "symmetric or full period map"),
                                      number("residual_site", "left by the site-centred breather"),
                                      number("residual_bond", "left by the bond-centred breather"),
                                      number("barrier", "E_site - E_bond")});
  table.fill(
      trials, [](const auto& trial) { return barrier_trial(trial.first, trial.second); }, "trials");

  // How many of them come near the printed residual and the printed barrier at once
  const auto residual = table.numbers("residual_site"), barrier = table.numbers("barrier");
  int near = 0;
  for (std::size_t i = 0; i < residual.size(); ++i)
    near += is_near_residual(residual[i]) && is_near(barrier[i], printed::barrier);
  report.facts.add("adaptive_near_both", exact(near), "trials");
}

/**
## Fixed steps: can they pin a breather?

With fixed steps the error at a contact event depends on where in its step the event falls. If the steps are
*commensurate with the period*, a whole number of them to it, this is the same place in every period: errors that would
cancel on average may add up, as long as the breather stays where it is, and act like a Peierls-Nabarro potential of the
integrator's own. We take the classical Runge-Kutta method with $T_b/k$ as its step, for several $k$, commensurate and
not, and repeat two of the article's experiments: the site-centred breather after the weak kick, and the bond-centred
one after a kick of $5.5\cdot10^{-6}$, which lies between the converged threshold [4.4518e-6](num:moving.c_threshold)
and the printed one.

With 80 and with 120 commensurate steps a period the bond-centred breather stays within half a site of its start until
$t = 8\cdot10^4$; with steps of about the same length that are not commensurate it moves. The site-centred one moves in
all four runs. But none of these runs conserves the energy: it drifts by
[6e2](num:sec33_article_integrator.least_drift_of_trials) to [1e5](num:sec33_article_integrator.largest_drift_of_trials)
times the energy $c^2/2$ of the kick. They show that commensurate steps can pin a breather, not that they do so at a
conserved energy. In a control, 120 commensurate steps of our own method, corrected for the contact events, let the
energy drift by [0.1](num:sec33_article_integrator.drift_of_control) times that of the kick, and the breather moves. */
std::vector<StepTrial> step_trials() {
  std::vector<StepTrial> trials;
  for (double steps : {80, 120})
    for (bool commensurate : {true, false})
      for (std::size_t k : {0, 1})
        trials.push_back({k, k ? 5.5e-6 : printed::weak_kick, steps, commensurate});
  trials.push_back({1, 5.5e-6, 120, true, true});
  return trials;
}

void report_step_trials(Report& report) {
  const RestingBreather at[] = {
      resting_breather(Centre::site, Phase::compressed, Setting::omega_b, 26),
      resting_breather(Centre::bond, Phase::stretched, Setting::omega_b, 22)};
  Table& table = report.table(
      "printed_trials",
      {label("centre", "where the breather starts"),
       number("c", "size of the kick", "site per unit of time"), number("steps", "for one period"),
       count("locked", "1 where that number is whole"),
       count("corrected", "1 where the opening and closing of contacts is corrected"),
       number("energy_drift", "largest relative change of the energy"),
       number("drift_over_kick", "the same in units of the energy of the kick"),
       number("farthest", "largest distance from the start", "site"),
       number("travelled", "distance from the start at the end", "site")});
  const auto row = [&](const StepTrial& trial) {
    const RestingBreather& breather = at[trial.which];
    const Creep found = trial.path(breather, report.quick ? 500 : 8e4);
    return Cells{trial.which ? "bond_stretched" : "site",
                 trial.c,
                 trial.steps,
                 trial.commensurate,
                 trial.corrected,
                 found.run.energy_drift,
                 1 / found.drift_margin(trial.c, breather.energy),
                 found.farthest(),
                 std::abs(found.travelled())};
  };
  table.fill(step_trials(), row, "trials");

  // How well do they conserve the energy, to an order of magnitude, and does the control pin?
  const auto drift = table.numbers("drift_over_kick");
  const auto [least, most] = std::minmax_element(drift.begin(), drift.end() - 1);
  report.facts.add("least_drift_of_trials", {*least, *least}, "c^2/2");
  report.facts.add("largest_drift_of_trials", {*most, *most}, "c^2/2");
  report.facts.add("drift_of_control", {drift.back(), drift.back()}, "c^2/2");
}

/**
## One setting for all numbers (figure x30)

Now the question itself. A *setting* is a method and a number $k$ of steps per period, and the period map of such an
integration is the $k$-th power of one step (fixed_step.hpp):

     flow   Y(0) ~~~~~~~~~~~~~~~~~~~~~~~~~~~> Y(T)
     map    Y(0) -> o -> o -> o -> o -> o -> o -> Y(T)     k steps, contact events ignored

All numbers are computed from this map: its own breathers, its own derivative (by variational equations or by difference
quotients), its own runs. The methods are velocity Verlet, the classical Runge-Kutta method, those of Fehlberg and of
Dormand and Prince of order five, and the symplectic one of Calvo and Sanz-Serna, often used in this field.

![Numbers of the article, computed with five methods and fixed steps.](fig:x30) */
std::vector<Setting> all_settings(bool quick) {
  const std::vector<std::size_t> steps =
      quick ? std::vector<std::size_t>{40, 100}
            : std::vector<std::size_t>{40, 60, 80, 100, 120, 128, 140, 160, 200, 256, 400};
  std::vector<Setting> all;
  for (std::size_t k : steps)
    for (const Nystrom& method : Setting::methods()) {
      Setting at{method, k};
      at.is_long =
          quick ? k == 100 && method.name == "runge-kutta-4" : k == 100 || k == 120 || k == 128;
      all.push_back(at);
    }
  return all;
}

/**
*Breathers.* Many of these maps have no periodic orbit near the breather. The flow has a circle of them, one for each
phase; a map has no continuous shift in time, so that of the circle single points survive at best, and none where the
energy drifts. Then we take the state that returns most nearly, in the sense of least squares. For the residual we make
five iterations from the DpS profile, as the article did, and for all else three from the accurate breather.

*Multipliers.* Four lie next to $+1$: a pair for shifts in time, exactly $+1$ for the flow, and the *pinning pair* for
shifts along the chain, which decides the stability where all others are on the circle. A map knows only shifts in
time by whole steps, so its first pair does not stay at $+1$. As in `sec33_floquet`, $\kappa$ is a quarter of the sum
of $\lambda+1/\lambda-2$ over both pairs.
If one of them stays at $+1$ the other is $2\sqrt{|\kappa|}$ away from it. We record this distance in the linear well;
$s_0$ is where the parabola through $\kappa$ in the wells $s = -1$, 0 and 1 vanishes.

*Threshold.* A kick frees the breather if it has got away within 20000 periods. This is costly, so only 100, 120 and 128
steps are tried. First we ask whether it lies within twelve per cent of the printed one, with a kick on either side; if
so, three halvings narrow it down.

*Jump.* Only where the threshold is near the printed one is the site-centred breather followed. It has jumped and is
pinned if it is two sites away, by half a site more or less, from $t = 2.5\cdot10^5$ to five times that. One horizon is
not enough: a slow one that happens to be two sites away at that time looks as if it had stopped. */
// What counts as near
/**
A number is near the printed one within ten per cent for barrier and threshold, 0.03 for $s_0$, half a site for the jump
and a factor of two for the residual: generous bounds, so that a negative answer does not depend on a digit
(`near_printed` of printed_numbers.hpp). They are so wide that the converged flow meets
[2](num:sec33_article_integrator.near_of_flow) of them: its barrier, and the residual that five iterations leave. To be
near these two is therefore no evidence for a coarse integration; the threshold, the two $s_0$ and the jump are what
tells. */
void measure(Setting& at) {
  at.measure_residual();
  at.measure_breathers();
  if (!at.is_long) return;
  at.measure_threshold();
  if (is_near(at.threshold(), printed::threshold)) at.measure_jump();
}

/// What was found: between two kicks, or beyond one of the first two.
std::string outcome(const Setting& at) {
  return std::isnan(at.pinned_at) ? "below" : std::isnan(at.freed_at) ? "above" : "between";
}

/**
## The result

No setting of fixed steps comes near more than [1](num:sec33_article_integrator.most_at_once) of the six numbers: some
with 100 to 128 steps are near the threshold, some with 200 or more near the residual, as the flow is, and none near any
other of the six. Panels (a), (b) and (d) of figure x30 show residual, barrier and threshold against the steps, the line
being what is printed; an arrow means that the threshold lies beyond the kicks tried. Panel (c) shows how far the four
multipliers around a bond are from $+1$; its line is $10^{-3}$, within which the article finds unstable ones. Panel (e)
counts the numbers that are near.

*The threshold.* We tried [15](num:sec33_article_integrator.thresholds_tried) settings. Of these
[5](num:sec33_article_integrator.thresholds_below) free the bond-centred breather already twelve per cent below the
printed threshold, [3](num:sec33_article_integrator.thresholds_above) not even twelve per cent above, and
[6](num:sec33_article_integrator.thresholds_near) come within ten per cent, among them the classical Runge-Kutta method
with 120 steps, [6.05e-6](num:sec33_article_integrator.threshold_runge-kutta-4_120), and with 128,
[6.43e-6](num:sec33_article_integrator.threshold_runge-kutta-4_128), that of Calvo and Sanz-Serna with 100,
[6.24e-6](num:sec33_article_integrator.threshold_calvo-sanz-serna-4_100), and Fehlberg's with 120,
[6.43e-6](num:sec33_article_integrator.threshold_fehlberg-5_120). The remaining one lies between ten and twelve per cent
away. So the printed number singles out no method. This compares numbers only: in the trials above the classical method
changed the energy by far more than the kick brings, and that of the others was not watched, so that these are not known
to be barriers of a conserved energy. And a breather that seems pinned need not stay so: with 120 steps of the classical
method a kick of $4\cdot10^{-6}$, too weak for a converged run, has freed it after 200000 periods (run once, with that
number in `measure_threshold`). */
// And the jump
/**
*The jump.* In [0](num:sec33_article_integrator.settings_near_jump) of the
[6](num:sec33_article_integrator.thresholds_near) settings near the threshold the site-centred breather jumps two sites
and stays. With 120 steps of the classical method it is two sites away at $t = 2.5\cdot10^5$, but it has not stopped
there: it leaves that place at [3.191e5](num:sec33_article_integrator.left_runge-kutta-4_120).

*The residual.* The classical method leaves [1.60775e-8](num:sec33_article_integrator.residual_runge-kutta-4_120) at 120
steps, ten times the printed residual. But the printed one need not be an error of integration at all. Near the breather
our iteration takes no step along its weakly pinned shift, which changes the equations more than ten thousand times less
than other directions do; so it cannot mend a start that is shifted a little. And the start is: the DpS profile is
symmetric about its site, the breather only together with a change of sign and half a period. For the converged flow the
iteration stops at a residual of [2.1e-9](num:sec33_article_integrator.residual_flow) with a last step of
[5e-15](num:sec33_article_integrator.variation_flow). What it leaves is the breather shifted along the chain, by
[0.0162081](num:sec33_article_integrator.shift_of_flow) sites if one divides by the slope of its profile: of the
difference, the fraction [0.999978](num:sec33_article_integrator.share_of_shift) is along the direction that the
equations feel least. Once the iteration may go along it too, the residual falls to
[5e-15](num:sec33_article_integrator.residual_released). The article prints $1.5\cdot10^{-9}$ beside a last step of
$1.7\cdot10^{-11}$, which is compatible with such an iteration and an accurate integration. */
// What the maps say of stability and of the barrier
/**
*The multipliers.* What decides the stability is how far the pinning pair is from $+1$, in the linear well by
[0.000214282](num:sec33_floquet.fourth_distance) around a site. There the time-translation pair of a map has left $+1$
by more: the distance of its four multipliers from $+1$ is at least
[0.000410771](num:sec33_article_integrator.least_off) in all settings, and
[0.005](num:sec33_article_integrator.off_runge-kutta-4_120) at 120 steps of the classical method. So the error of the
one pair hides the other, and $s_0$ cannot be read off: both centres show an exchange in $[-1, 1]$ in
[0](num:sec33_article_integrator.settings_with_both_s0) of [55](num:sec33_article_integrator.settings) settings, and a
single setting shows one around a bond, far from the printed value. Difference quotients do not change this. Two
exchanges as far apart as the printed ones come from adaptive variational equations at tolerances from $10^{-8}$ to
$10^{-9}$ instead (`sec33_multiplier_errors`).

*The barrier* of the maps scatters about the converged one; at 120 steps its largest modulus is
[6.35779e-10](num:sec33_article_integrator.largest_barrier_120), many times the barrier itself. It comes within ten
per cent of the printed value in [0](num:sec33_article_integrator.settings_near_barrier) settings.

So none of these settings of *fixed* steps comes near more than one of the six numbers. Some of the methods, with 100 to
128 commensurate steps per period, give a threshold of the printed size if one waits for 20000 periods. Residual and
barrier need no such explanation: an accurate integration is near both, and so is the adaptive one of the first section
at $10^{-9}$. Two $s_0$ as far apart as printed came from variational equations of about that tolerance. Kicks were not
tried with adaptive steps, and nothing that we tried explains the jump. */
Columns report_columns() {
  return {label("method", "integrator"),
          count("steps", "for one period"),
          number("residual", "after five iterations, site-centred, relative to the amplitude"),
          number("variation", "last change of the positions, relative to the amplitude"),
          number("residual_differences", "the residual with difference quotients"),
          number("variation_differences", "the variation with difference quotients"),
          number("barrier", "E_site - E_bond"),
          number("barrier_size", "modulus of the barrier"),
          number("off_site", "distance of the four multipliers from +1, around a site"),
          number("off_bond", "the same around a bond"),
          number("s0_site", "exchange of stability around a site; nan where none in [-1, 1]"),
          number("s0_bond", "the same around a bond; may be nan"),
          number("s0_site_differences", "with difference quotients; may be nan"),
          number("s0_bond_differences", "with difference quotients; may be nan"),
          count("near", "how many of the six numbers are near the printed ones")};
}

// The settings whose threshold was tried have a table of their own
void report_kicks(Report& report, const std::vector<Setting>& all) {
  const std::string unit = "site per unit of time";
  Table& table = report.table(
      "thresholds",
      {label("method", "integrator"), count("steps", "for one period"),
       label("outcome", "of the threshold: between the next two; below or above the kicks tried"),
       number("pinned_at", "largest kick that did not free; nan if all did", unit),
       number("freed_at", "least kick that freed; nan if none did", unit),
       number("left_at",
              "when the site-centred breather of the weak kick was not two sites from "
              "its start any more, or yet; nan where not followed"),
       number("away", "sites from its start then; nan where not followed", "site")});
  int tried = 0, below = 0, above = 0, near = 0;
  for (const Setting& at : all) {
    if (!at.is_long) continue;
    const bool followed = !at.path.t.empty();
    table.add({at.method.name, at.steps, outcome(at), at.pinned_at, at.freed_at,
               followed ? at.path.t.back() : std::nan(""),
               followed ? std::abs(at.path.travelled()) : std::nan("")});
    ++tried, below += outcome(at) == "below", above += outcome(at) == "above";
    if (!is_near(at.threshold(), printed::threshold)) continue;

    // Settings that come near the threshold are quoted
    ++near;
    const std::string name = "_" + at.method.name + "_" + std::to_string(at.steps);
    report.facts.add("threshold" + name, {at.threshold(), at.freed_at - at.threshold()}, unit);
    report.facts.add("left" + name, {at.path.t.back(), 64 * Setting::period});
    report.facts.add("residual" + name, compare(at.residual_differences, at.residual));
    report.facts.add("off" + name, compare(at.off_circle[1], at.off_circle[0]));
  }
  report.facts.add("thresholds_tried", exact(tried));
  report.facts.add("thresholds_below", exact(below));
  report.facts.add("thresholds_above", exact(above));
  report.facts.add("thresholds_near", exact(near));
}

void report_scan(Report& report) {
  std::vector<Setting> all = all_settings(report.quick);
  parallel_for("settings", all.size(), [&](std::size_t i) {
    measure(all[all.size() - 1 - i]);  // the most expensive first
  });
  report_kicks(report, all);

  // All settings, and how many come near in what
  Table& table = report.table("settings", report_columns());
  std::array<int, 7> near_counts{};  // by the number near: none, one, ...
  int barriers = 0, both_s0 = 0, jumps = 0;
  const Setting *nearest = &all.front(), *highest = nullptr;
  for (const Setting& at : all) {
    const Near near = near_printed(at);
    table.add({at.method.name, at.steps, at.residual, at.variation, at.residual_differences,
               at.variation_differences, at.barrier, std::abs(at.barrier), at.off_circle[0],
               at.off_circle[1], at.s0[0], at.s0[1], at.s0_differences[0], at.s0_differences[1],
               near.count()});
    ++near_counts[std::size_t(near.count())];
    barriers += near.barrier, jumps += near.jump;
    both_s0 += !std::isnan(at.s0[0]) && !std::isnan(at.s0[1]);
    if (at.least_off() < nearest->least_off()) nearest = &at;
    if (at.steps == 120 && (!highest || std::abs(at.barrier) > std::abs(highest->barrier)))
      highest = &at;
  }
  const auto most = std::find_if(near_counts.rbegin(), near_counts.rend(), [](int k) { return k; });
  report.facts.add("settings", exact(double(all.size())));
  report.facts.add("most_at_once", exact(double(near_counts.rend() - most - 1)));
  report.facts.add("settings_near_barrier", exact(barriers));
  report.facts.add("settings_near_jump", exact(jumps));
  report.facts.add("settings_with_both_s0", exact(both_s0));

  // The two extremes again, on longer chains
  const auto longer = [](Setting at) {
    at.sites += 4;
    at.measure_breathers();
    return at;
  };
  report.facts.add("least_off", compare(longer(*nearest).least_off(), nearest->least_off()));
  if (highest)
    report.facts.add("largest_barrier_120",
                     compare(std::abs(longer(*highest).barrier), std::abs(highest->barrier)));
}

// The flow itself, by many steps of a better method
void report_flow(Report& report) {
  const auto of_flow = [](std::size_t steps) {
    Setting at{nystrom(blanes_moan_6()), steps};
    at.measure_residual();
    return at;
  };
  const Setting coarse = of_flow(400), fine = of_flow(800);
  report.facts.add("residual_flow", compare(coarse.residual, fine.residual));
  report.facts.add("variation_flow", compare(coarse.variation, fine.variation));

  // What the iteration leaves, and how many of the six numbers an accurate computation is near
  const Shifted rough = coarse.shift_left(), shifted = fine.shift_left();
  report.facts.add("shift_of_flow", compare(rough.sites, shifted.sites), "site");
  report.facts.add("share_of_shift", compare(rough.share, shifted.share), "of the difference");
  report.facts.add("residual_released", {shifted.released, shifted.released});  // rounding
  std::array<double, 2> energies{};
  for (std::size_t k : {0U, 1U})
    energies[k] = find_breather(problem_of(both_centres[k], Setting::omega_b)).energy;
  report.facts.add("near_of_flow", exact(is_near_residual(fine.residual) +
                                         is_near(energies[0] - energies[1], printed::barrier)));
}

/**
## Differences and limits

Nothing here says what the article did. The scan has steps that divide the period and breathers on short chains;
adaptive steps were tried for the barrier and for the multipliers (`sec33_multiplier_errors`), not for kicks. Steps of a
round length, such as 0.05, are not commensurate, and in the trials with incommensurate steps the breather moves. A kick
that has not freed the breather within 20000 periods, or after which it has turned round before, counts as too weak;
with 16000, run once, some thresholds come out three per cent higher, and with 12000 one more setting seems to come
near. A map has no finer resolution to be compared with, so its numbers have no error of that kind; as that of a
threshold we give half of its bracket, as that of a time the 64 periods between two looks, and that of a residual is its
difference from the one with difference quotients. */
void reproduce(Report& report) {
  report.output.note("tolerance", "none: the fixed steps are what is studied");
  report_scan(report);
  report_flow(report);
  if (!report.quick) report_barrier_trials(report);
  report_step_trials(report);
}

/**
## Try it

1. *Easy.* By how much does the printed barrier exceed the converged one?
   `build/bin/sec32_barrier barrier --omega 1.1` gives `equal_frequency` = 1.624225e-11.
   Hint: compare the excess with the scatter of the barriers in the table of adaptive trials.
2. *Harder.* Which error of the frequency changes the energy by that excess?
   `build/bin/sec32_newton_breathers breather --omega 1.1001` gives `energy` = 0.00015428151472.
   Hint: subtract the energy at 1.1. The phase of a breather is then wrong by this error times $T_b$ after one period, and
   the velocities of its beads by as much of their accelerations; compare with the printed residual.
3. *Open.* Can commensurate steps pin a breather at a conserved energy? In the trials here they lose or gain far more
   energy than the kick brings.
4. *Open.* What makes a breather jump two sites and stay? */
int main(int argc, char** argv) {
  return run({"sec33_article_integrator", "3.3", "Which integrator did the article use? (appendix)",
              reproduce},
             argc, argv);
}
