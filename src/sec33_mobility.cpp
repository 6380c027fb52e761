/**
# 3.3 Kicked breathers and the depinning threshold

How hard must one kick a breather to set it in motion? A breather at rest sits in a periodic potential of its centre,
and must pass the *Peierls-Nabarro barrier* between neighbouring sites, a notion from discrete solitons (Kivshar and
Campbell, Phys. Rev. E 48, 1993). Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) kicks breathers of
frequency $\omega_b = 1.1$ with size $c$ and says that

- after $c = 2\cdot10^{-4}$ both breathers travel almost steadily, at $5.446\cdot10^{-4}$ around a site and
  $5.364\cdot10^{-4}$ around a bond, with negligible dispersion (figure 14);
- after $c = 3\cdot10^{-6}$ the bond-centred breather stays, and the site-centred one jumps two sites and is pinned
  again (figure 15);
- the bond-centred one is depinned above $c_c = 6.19\cdot10^{-6}$, and $c_c^2/2 = 1.92\cdot10^{-11}$ is quite close to
  the barrier of section 3.2 at equal frequency, $E_{PN} = 1.77\cdot10^{-11}$.

![Energy density after a kick of the bond-centred and of the site-centred breather. Drawn by fig14_moving.py: `e` over
`n` and `t`, from `map_bond` and `map_site`.](fig:14)

We find the same speeds to 0.02 per cent, but no second pinning, and a lower threshold, $4.45\cdot10^{-6}$. It obeys
$|\varphi|\,c_c^2/2 = |\tilde E_{PN}|$: only the small fraction $|\varphi|$ of the kick's energy moves the breather, and
the barrier to be passed, $\tilde E_{PN}$, is that at equal *action*, which is smaller, too. That $c_c^2/2$ and $E_{PN}$
have the same order of magnitude comes from two small factors that nearly cancel.

<!-- head -->
`build/bin/sec33_mobility` computes this chapter in 32 s on two cores and writes 14 tables to
`build/data/sec33_mobility`. Its figures: `make fig14`, `make fig15`, `make x15`, `make x48`. With your parameters:
`kick`, speed of a breather after a kick along its discrete gradient; `threshold`, depinning threshold: the least kick
that sets a pinned breather moving.
<!-- /head -->

## Model

The chain has harmonic wells, Eqs. (6) to (9), and free ends,
$$\ddot y_n + y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
At $t = 0$ all beads of a breather are at rest, and the kick adds velocities $c\,g_n$ along the discrete gradient,
$g_n\propto y_{n+1}-y_{n-1}$. This is close to the *pinning mode*, the disturbance that shifts the breather
(`sec33_floquet`), along which breathers were first set in motion (Chen, Aubry and Tsironis, Phys. Rev. Lett. 77, 1996;
Aubry and Cretegny, Physica D 119, 1998). We take $\sum g_n^2 = 1$: only then does the kick add the energy $c^2/2$, as
the article says. The position of a breather is the energy centre $X$, Eq. (24), of the eleven sites about the largest
density. It swings with every oscillation, so we average it over eleven periods, with 89 samples that the golden ratio
spreads evenly over the phases, and measure distances from the first average. */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_kick.hpp"
#include "sec33/other_kicks.hpp"

using namespace lattice;

/**
## The experiment

Newton's method finds the breather (`resting_breather`), `after` gives its beads the velocities $c\,g_n$ and integrates
the equation of motion, and a `KickedPath` has the averages of $X$; these functions, in kick.cpp and
kick_threshold.cpp, are also those of the commands. A breather that starts at a bond is *free*, or depinned, once it is
0.6 sites away, beyond the site at 0.5, and *pinned* if it comes back by 0.02 sites before that (`mobility_of`).

Around a bond the central contact is either stretched or compressed at the kick, and we follow both. Each run is made
with two methods, whose difference is the error. `EventCorrected` takes Runge-Kutta steps of order six and gives every
contact that opens or closes its exact impulse; long runs have fourteen forces a step instead of five. */
constexpr double omega_b = 1.1, s = 0;  // of the breathers: frequency, anharmonicity of the wells
constexpr double strong = 2e-4, weak = 3e-6, printed = 6.19e-6;   // kicks, and the printed c_c
constexpr double travel = 32000, watch[] = {2.85e5, 1.7e5, 8e4};  // time after a strong, weak kick
constexpr double decision = 3e5;                                  // at most, near the threshold
// Sites around a site and around a bond: to travel, to stay, and for comparison
constexpr std::size_t far[] = {53, 52}, near[] = {27, 22}, longer[] = {31, 26};

/// Around a site, and around a bond with its central contact stretched and compressed at the kick.
Breathers breathers(const std::size_t (&sites)[2]) {
  Breathers all{resting_breather(Centre::site, Phase::compressed, omega_b, sites[0], s),
                resting_breather(Centre::bond, Phase::stretched, omega_b, sites[1], s),
                resting_breather(Centre::bond, Phase::compressed, omega_b, sites[1], s)};
  for (RestingBreather& at : all) at.g = kick_direction(at.rest.y);
  return all;
}

// The largest steps, of the coarser and of the finer run
struct Methods {
  TwoRuns<EventCorrected> strong, weak, threshold, speed;
};
Methods methods(bool quick) {
  if (quick) return {{{0.4}, {0.2}}, {{0.4}, {0.3}}, {{0.4}, {0.3}}, {{0.4}, {0.2}}};
  return {.strong = {{0.2}, {0.1}},
          .weak = {{0.15}, fourteen_stages(0.047)},      // as a kick is weaker and a run longer,
          .threshold = {{0.15}, fourteen_stages(0.06)},  // `check_energy` needs shorter steps
          .speed = {{0.3}, {0.2}}};                      // many runs, not checked
}

/// The energy may change by a hundredth of what the kick adds.
void check_energy(const RestingBreather& at, double c, const KickedPath& path) {
  if (path.drift_margin(c, at.energy) < 100) throw Failure("the energy drifts");
}

/// All three breathers after one kick; `looks` see the finer runs.
using Paths = std::array<TwoRuns<KickedPath>, 3>;
Paths kick_all(const Breathers& at, double c, const TwoRuns<EventCorrected>& by,
               const std::array<double, 3>& times, bool quick,
               const std::array<KickLook, 3>& looks = {}) {
  Paths paths;
  parallel_for("kicks", paths.size(), [&](std::size_t k) {
    paths[k] = {at[k].after(c, by.coarse, times[k]), at[k].after(c, by.fine, times[k], looks[k])};
    if (paths[k].fine.share < 0.9) throw Failure("the breather breaks up after the kick");
    if (!quick) check_energy(at[k], c, paths[k].fine);
  });
  return paths;
}

/**
## A strong kick (figure 14)

Does the breather travel steadily, and does it keep its energy? In the time of the run it makes more than 5000
oscillations and passes about seventeen sites. The speed is the slope of $X$, over the whole run, its halves, and every
site. What the kick has added to the energy must still be there at the end. The radiated energy is bounded by the
largest fraction of the energy, at some 45000 samples, that is more than five sites from the largest density; the
breather's own tail is part of it. */
/// Draws the energy density at every fourth average.
KickLook drawn_in(Table& map) {
  return [&map](const KickedPath& path, const State<double>& now, const std::vector<double>& e) {
    if (path.t.size() % 4 != 1) return;
    for (std::size_t n = 0; n < e.size(); ++n) map.add({now.t, site_number(n, e.size()), e[n]});
  };
}

void report_strong(Report& report) {
  const Columns columns{number("t", "time"), count("n", "site", "site"),
                        number("e", "energy density")};
  Table &bond = report.table("map_bond", columns), &site = report.table("map_site", columns);
  const Breathers at = breathers(far);
  const double time = report.quick ? 6000 : travel;
  const Paths paths = kick_all(at, strong, methods(report.quick).strong, {time, time, time},
                               report.quick, {drawn_in(site), drawn_in(bond), KickLook{}});

  // Both breathers of the article pass all phases, so the error of sampling is about their difference
  const auto outside = [](const KickedPath& path) { return 1 - path.share; };
  const double sampling = std::abs(outside(paths[0].fine) - outside(paths[1].fine));
  Table& table = report.table("strong_kicks");
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto speed = [&](double since, double until) {
      return paths[k].of([&](const KickedPath& p) { return speed_of(p, since, until); });
    };
    const double to = paths[k].fine.run.t_end, middle = to / 2;
    const Estimate mean = speed(0, to);
    Estimate unsteadiness{}, lost = paths[k].of(outside);
    lost.error += sampling;
    for (double t = 0; t + 1 / mean.value <= to; t += 1 / mean.value) {
      const Estimate one = quotient(speed(t, t + 1 / mean.value), mean);
      unsteadiness = larger(unsteadiness, {std::abs(one.value - 1), one.error});
    }
    const double at_rest = energy(at[k].chain, at[k].rest);
    const Estimate gained = paths[k].of([&](const KickedPath& p) { return p.energy - at_rest; });
    const char *how = "from two steps and the fit", *unit = "site per unit of time";
    table.add(Row{{"breather", "its centre and, at the kick, its contact", breather_names[k]},
                  {"speed", "slope of X", mean, unit, how},
                  {"first_half", "the same, first half", speed(0, middle), unit, how},
                  {"second_half", "the same, second half", speed(middle, to), unit, how},
                  {"unsteadiness", "largest change of the speed over a site, as a fraction of it",
                   unsteadiness, "", "relative, from two steps and the fit"},
                  {"kick", "energy at the end of the run less that of the resting breather", gained,
                   "", "from two steps, known to 2 per cent"},
                  {"outside", "largest fraction of the energy beyond five sites", lost, "",
                   "from two steps and two breathers, known to 2 per cent"}});
  }
}

/**
| after $c = 2\cdot10^{-4}$ | around a site | around a bond, stretched | compressed |
|---|---|---|---|
| article: speed | $5.446\cdot10^{-4}$ | $5.364\cdot10^{-4}$ | |
| speed | [5.444898e-4 ± 3e-10](statement:moving.v_site) | [5.362962e-4 ± 2e-10](statement:moving.v_bond) | [5.526778e-4 ± 2e-10](cell:strong_kicks/breather=bond_compressed/speed) |

From site to site the speed changes by at most [5e-5 ± 2e-5](cell:strong_kicks/breather=site/unsteadiness) of itself
(*almost steadily*), and no more than [3.5e-9](cell:strong_kicks/breather=bond_compressed/outside) of the energy is
outside (*negligible dispersion*). After the run the bond-centred breather still has
[2.00e-8 ± 4e-10](statement:moving.kick_energy) more energy than at rest. The direction is a surprise. Neighbours in
these breathers have opposite signs, so that velocities $c\,g_n$ with $c > 0$ begin to shift the profile to the right;
but it travels to the left. Its effective mass is negative, as we shall see.

## A weak kick (figure 15)

After $c = 3\cdot10^{-6}$ the bond-centred breather oscillates about its bond: in either phase it turns back at
a quarter of a site. The site-centred one starts at a maximum of the potential. It passes the same position at every
further site, slowly, and is faster over the bonds. Is it pinned at the second site? Then it would never pass a third
one, and would slow down before. So we note how far it comes, and its speed at every site and bond, as a fraction of
that at the bond at 1.5 sites.

![Energy centre after a weak kick. Drawn by fig15_energy_centre.gp: the columns `X_` of `paths` against `t`.](fig:15) */
TwoRuns<KickedPath> report_weak(Report& report, const Breathers& at) {
  const std::array<double, 3> times =
      report.quick ? std::array{2e4, 2e4, 2e4} : std::to_array(watch);
  const Paths paths = kick_all(at, weak, methods(report.quick).weak, times, report.quick);

  // The figure: the longest run has all times
  const char* how =
      "from two integrators, against the largest displacement; nan after the end of a run";
  Columns columns{number("t", "time")};
  for (const char* name : breather_names)
    columns = {columns, estimate(std::string("X_") + name, "energy centre", "site", how)};
  Table& drawn = report.table("paths", columns);
  const auto place = [&](std::size_t k, std::size_t i) {
    const auto& [coarse, fine] = paths[k];
    return i < fine.centre.size() ? compare(coarse.centre[i], fine.centre[i]) : undefined;
  };
  for (std::size_t i = 0; i < paths[0].fine.t.size(); i += 8)
    drawn.add({paths[0].fine.t[i], place(0, i), place(1, i), place(2, i)});

  // How far they come
  const auto farthest = [](const KickedPath& p) { return p.farthest(); };
  const auto came_back = [](const KickedPath& p) { return p.farthest() - std::abs(p.travelled()); };
  Table& table = report.table("weak_kicks");
  for (std::size_t k = 0; k < paths.size(); ++k)
    table.add(Row{
        {"breather", "its centre and, at the kick, its contact", breather_names[k]},
        {"until", "end of the run", exact(times[k]), "", "exact"},
        {"farthest", "largest distance", paths[k].of(farthest), "site", how},
        {"came_back", "how much closer it is at the end", paths[k].of(came_back), "site", how}});
  return paths[0];
}

/**
| after $c = 3\cdot10^{-6}$ | around a site | around a bond, stretched | compressed |
|---|---|---|---|
| article | pinned after 2 sites | pinned | pinned |
| followed until $t$ | [285000](cell:weak_kicks/breather=site/until) | [170000](cell:breather=bond_stretched/until) | [80000](cell:breather=bond_compressed/until) |
| farthest, sites | [3.124](cell:weak_kicks/breather=site/farthest) | [0.2356](cell:weak_kicks/breather=bond_stretched/farthest) | [0.2441](cell:breather=bond_compressed/farthest) |
| closer by then, sites | [0](cell:weak_kicks/breather=site/came_back) | [0.0667](cell:breather=bond_stretched/came_back) | [0.1050](cell:breather=bond_compressed/came_back) |

| site-centred, distance in sites | time | speed over that at 1.5 |
|---|---|---|
| 1 (a site) | [9.018e4](cell:passages/distance=1/time) | [0.590](cell:speed_ratio) |
| 2 (a site) | [1.803e5](cell:passages/distance=2/time) | [0.590](cell:speed_ratio) |
| 2.5 (a bond) | [2.254e5](cell:passages/distance=2.5/time) | [1.000](cell:speed_ratio) |
| 3 (a site) | [2.705e5](cell:passages/distance=3/time) | [0.590](cell:speed_ratio) |

It passes every site as fast as the one before, also the third, so it is not pinned at the second. A figure that ends
at $t = 1.8\cdot10^5$ would show two sites but no pinning. We do not know what the article saw.

## Why most of a kick is wasted

The barrier that a breather has to pass is far lower than $c_c^2/2$. Where does the rest of the energy go? A slowly
moving breather keeps its action, so it moves in the *effective Hamiltonian*, which the article takes from the work of
Sepulchre and MacKay: the energy at given action as a function of the centre. Its barrier is $\tilde E_{PN} = E_{\rm
site}-E_{\rm bond}$ between breathers of equal action (`sec32_barrier`). But the kick changes the action, too. Along the
family of breathers $dE = \omega_b\,dI$, and only what is left of $c^2/2$ at equal action, $\varphi\,c^2/2 =
dE-\omega_b\,dI$, moves the centre. So
$$|\varphi|\,\frac{c_c^2}2 = |\tilde E_{PN}|,\qquad\text{not}\qquad \frac{c_c^2}2 = E_{PN}.$$
The monodromy matrix $M$ gives $\varphi$. Its slow plane is spanned by the pinning mode $\xi$, a shift of the positions,
and a push $\zeta$ of the velocities. If $M_{yy}$ and $M_{yv}$ are the derivatives of the positions after a period with
respect to the initial positions and velocities,
$$M_{yy}\,\xi = \cos\theta\,\xi,\qquad M_{yy}^T\zeta = \cos\theta\,\zeta,\qquad
  \zeta\cdot M_{yv}\zeta = b\,\zeta\cdot\xi,\qquad
  \varphi = \frac{b\,(\xi\cdot g)^2}{T_b\;\xi\cdot\zeta}$$
is the fraction of $c^2/2$ that becomes kinetic energy of this plane. About a stable centre the plane is an oscillator
with the pinning frequency $\Omega$, $\Omega^2 = 2(1-\cos\theta)/T_b^2$ (`pinning_of`, kick_threshold.hpp). We find
$\varphi < 0$: the moving breather has *less* energy than the resting one of the same action. That is the negative
effective mass, and with it the stable centre is the one of *higher* energy.

Sign and size follow at small amplitudes, with $\delta = \omega_b-1$. Without contacts a kick along $\xi$ changes action
and energy by $c^2/2$ each, which leaves $-\delta\,c^2/2$. A velocity changes the complex amplitude of a bead at right
angles to the breather's own, real one, and in this direction a contact of strain $d_n$ has the stiffness $|d_n|^{1/2}$.
So the contacts add $\frac{c^2}2\,\xi\cdot K\xi$, with $K$ the matrix of these stiffnesses (spectrum.hpp). The pinning
mode nearly solves $(\delta-\frac32K)\,\xi = 0$, and $g$ is nearly $\xi$; hence
$$\varphi \approx \tfrac23\delta-\delta = -\frac{\omega_b-1}3.$$
In this limit $\tilde E_{PN}$ is $-(\omega_b-1)/5$ times $E_{PN}$ (`sec32_barrier`). The ratio of the two small factors
gives $c_c^2/2 \approx \frac35E_{PN}$: two different quantities have the same order of magnitude. This does not explain
why they are close at $\omega_b = 1.1$, for below it both barriers change sign, $E_{PN}$ first at
[1.0146](cell:sec32_barrier/sign_changes/s=0/zero=1/omega), and not at the same frequencies (`sec32_barrier`), so
that their ratio takes all values.

## The threshold

We test this law in the full chain. The speed $V$ with which a free breather passes the maximum at the next site
vanishes at the threshold, and $V^2$ is linear in $c^2$. Kicks 5, 20 and 40 per cent beyond the prediction give three
lines, whose disagreement, with the difference of two methods, is the error (`depinning`). An extrapolation is no proof:
a kick half a per cent below the threshold must leave the breather pinned, and one half a per cent above must free it,
or the program stops. */
void check_bracket(const RestingBreather& at, double threshold, const Method& method) {
  const KickedPath below = decided_path(at, 0.995 * threshold, method, decision),
                   above = decided_path(at, 1.005 * threshold, method, decision);
  check_energy(at, 0.995 * threshold, below);
  check_energy(at, 1.005 * threshold, above);
  if (mobility_of(below) != Mobility::pinned || mobility_of(above) != Mobility::free)
    throw Failure("the threshold is not within its bracket");
}

/// Prediction and chain, for the two phases of the bond-centred breather.
struct Threshold {
  Prediction law{};
  TwoRuns<Depinning> runs{};
  Estimate found() const { return compare(runs.coarse.threshold, runs.fine.threshold); }
};
using Thresholds = std::array<Threshold, 2>;

Thresholds report_thresholds(Report& report, const Breathers& at) {
  const BreatherPair pair = barriers_at(omega_b, s);
  const auto by = methods(report.quick).threshold;
  Thresholds out;
  parallel_for("thresholds", out.size(), [&](std::size_t i) {
    const RestingBreather& bond = at[i + 1];
    out[i].law = predict_threshold(bond, pair.equal_area);
    const double predicted = out[i].law.threshold.value;
    out[i].runs = {depinning(bond, predicted, by.coarse, decision),
                   depinning(bond, predicted, by.fine, decision)};
    if (!report.quick) check_bracket(bond, out[i].found().value, by.fine);
  });

  // The table
  const double plain = 2 * std::abs(pair.equal_frequency.value);
  Table& table = report.table("thresholds");
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto& [law, runs] = out[i];
    const Estimate c = out[i].found();
    table.add(Row{{"breather", "its centre and, at the kick, its contact", breather_names[i + 1]},
                  {"kinetic_share", "fraction phi of c^2/2", law.share, "", "two tolerances"},
                  {"frequency", "pinning frequency Omega", law.frequency, "", "two tolerances"},
                  {"barrier", "E_site - E_bond at equal action", law.barrier},
                  {"predicted", "threshold c_c by these", law.threshold},
                  {"threshold", "c_c of the chain", c, "", "from two schemes and three kicks"},
                  {"energy", "c_c^2/2", Estimate{c.value * c.value / 2, c.value * c.error}},
                  {"over_barrier", "c_c^2/2 over the barrier E_PN at equal frequency",
                   Estimate{c.value * c.value / plain, 2 * c.value * c.error / plain}}});
  }
  return out;
}

/**
| bond-centred breather | article | contact stretched | compressed |
|---|---|---|---|
| fraction $\varphi$ | | [-0.02374](cell:thresholds/breather=bond_stretched/kinetic_share) | [-0.02521](cell:breather=bond_compressed/kinetic_share) |
| frequency $\Omega$ | | [3.751e-5](cell:thresholds/breather=bond_stretched/frequency) | [3.751e-5](cell:breather=bond_compressed/frequency) |
| barrier $\tilde E_{PN}$ | | [-2.352e-13](cell:thresholds/breather=bond_stretched/barrier) | [-2.352e-13](cell:breather=bond_compressed/barrier) |
| $c_c$ predicted | | [4.4516e-6 ± 3e-10](cell:thresholds/breather=bond_stretched/predicted) | [4.3196e-6 ± 3e-10](cell:breather=bond_compressed/predicted) |
| $c_c$ of the chain | $6.19\cdot10^{-6}$ | [4.4518e-6 ± 4e-10](statement:moving.c_threshold) | [4.3198e-6 ± 4e-10](cell:thresholds/breather=bond_compressed/threshold) |
| $c_c^2/2$ | $1.92\cdot10^{-11}$ | [9.91e-12](statement:moving.pn_dynamic) | [9.33e-12](cell:thresholds/breather=bond_compressed/energy) |
| $E_{PN}$ | $1.77\cdot10^{-11}$ | [1.624e-11](statement:pn.omega11) | the same |
| $c_c^2/2$ over it | 1.08, *quite close* | [0.610](statement:moving.barrier_close) | [0.574](cell:thresholds/breather=bond_compressed/over_barrier) |

<!-- depinning.law -->
The smallest kick $c$ along the discrete gradient that sets a stable breather of the linear well ($s = 0$) in motion
follows from the flow linearised over one period: only a small fraction $\varphi$ of $c^2/2$ becomes translational
kinetic energy, and this must reach the barrier at equal area. At $\omega_b = 1.1$, with the central contact stretched
at the kick, $\varphi =$ -0.02374; the prediction for the bond-centred breather is $c =$ 4.4516e-6 ± 3e-10, and the
chain has 4.4518e-6 ± 4e-10. (computed)
<!-- /depinning.law -->

How accurately must the energy be conserved? The kick at the threshold adds only $7\cdot10^{-8}$ of the breather's
energy, and one expects that a drift must be smaller. It need not be, as figure x48 shows. With a step of 0.4 the energy
drifts by thousands of times what the kick adds, yet $V^2$ stays on its line, and $c_c$ moves by a fraction of
$10^{-4}$. Our explanation is that a drift changes the action slowly but gives the centre no push. Then it acts only on
$\varphi$ and $\tilde E_{PN}$, which vary smoothly with the action, and $c_c$ should move by no more than the drift as
a fraction of the energy of the *breather*; this is what we find. At shorter steps the three kicks limit $c_c$: their
lines disagree by $10^{-5}$. So the runs of the next sections, with large steps, count although they would not pass
`check_energy`.

![Square of the speed at the maximum against that of the kick, and the threshold against the step. Drawn by
x48_threshold.gp from `speeds_at_maximum` and `threshold_steps`.](fig:x48) */
void report_steps(Report& report, const RestingBreather& at, const Threshold& best) {
  const double predicted = best.law.threshold.value, c_c = best.found().value,
               rise = best.law.frequency.value / std::numbers::pi;
  const std::vector<double> steps = report.quick ? std::vector{0.4} : std::vector{0.4, 0.3, 0.2};
  std::vector<Depinning> runs(steps.size());
  parallel_for("steps", steps.size(), [&](std::size_t i) {
    runs[i] = depinning(at, predicted, EventCorrected{steps[i]}, decision);
  });
  Table& table = report.table("threshold_steps");
  for (std::size_t i = 0; i < steps.size(); ++i)
    table.add(Row{{"step", "time step", steps[i]},
                  {"shift", "change of c_c by the step, relative",
                   std::abs(runs[i].threshold.value - c_c) / c_c},
                  {"drift", "largest change of the energy, relative", runs[i].drift},
                  {"kick", "energy c_c^2/2 of the kick, relative", c_c * c_c / 2 / at.energy}});

  // The line begins at the predicted threshold, and rises to (Omega/pi)^2 at twice its square
  Table& squares =
      report.table("speeds_at_maximum",
                   {number("c2", "square of the kick"), number("predicted", "V^2 predicted"),
                    number("coarse", "V^2 with the largest step; nan without a run"),
                    number("fine", "V^2 with the smallest step; nan without a run")});
  squares.add({predicted * predicted, 0.0, undefined.value, undefined.value});
  for (std::size_t i = 0; i < kicks_beyond.size(); ++i) {
    const double c = best.runs.fine.c[i], coarse = runs[0].speed[i], fine = best.runs.fine.speed[i];
    squares.add(
        {c * c, rise * rise * (c * c / (predicted * predicted) - 1), coarse * coarse, fine * fine});
  }
}

/**
## Speed against kick (figure x15)

The prediction goes farther. If the potential is a sine, the centre is a pendulum, which needs the speed $\Omega/\pi$ at
the minimum to reach the maximum. A kick gives it the speed
$$V_0 = \frac\Omega\pi\,\frac{c}{c_c},\qquad c_c^2 = 2\,\Bigl|\frac{\tilde E_{PN}}\varphi\Bigr|,$$
around a site with the $\varphi$ of that breather, and no constant is fitted. Its mean speed over a site is the
arithmetic-geometric mean of the speeds at maximum and minimum, whose squares differ by $(\Omega/\pi)^2$
(`pendulum_speed`). In the chain we time the passage over one site from the first and from the second average of $X$.
From just above the threshold, where the breather lingers near the maximum, to kicks 40 times as strong, chain and
pendulum agree to $10^{-4}$; beyond one per cent the program stops.

![Mean speed against kick. Drawn by x15_speed_against_kick.py: `speed` and `pendulum` of `speeds` against `c`, and
`threshold` of `thresholds`.](fig:x15) */
Estimate speed_over_a_site(const RestingBreather& at, double c, const Method& method) {
  const KickedPath path = at.after(c, method, 1e6, [](const KickedPath& so_far, auto&...) {
    return std::abs(so_far.travelled()) < 1.1;
  });
  return compare(path.mean_speed(1, 1), path.mean_speed(1, 0));
}

void report_speeds(Report& report, const Breathers& at, const Prediction& bond) {
  const double omega = bond.frequency.value, barrier = std::abs(bond.barrier.value);
  const double phi[] = {pinning_of(at[0]).share, bond.share.value};
  struct Kick {
    std::size_t breather;
    double c;
  };
  std::vector<Kick> kicks;
  for (double c : {2e-6, 4e-6, 8e-6, 2e-5, 5e-5, 2e-4}) kicks.push_back({0, c});
  for (double c : {4.7e-6, 5.5e-6, 8e-6, 2e-5, 5e-5, 2e-4}) kicks.push_back({1, c});
  if (report.quick) kicks = {{0, strong}, {1, strong}};
  const auto by = methods(report.quick).speed;
  // The chain with two steps, and the pendulum
  const auto row = [&](const Kick& kick) {
    const auto& [k, c] = kick;
    const Estimate speed =
        compare(speed_over_a_site(at[k], c, by.coarse), speed_over_a_site(at[k], c, by.fine));
    const double start = omega / std::numbers::pi * c * std::sqrt(std::abs(phi[k]) / (2 * barrier)),
                 pendulum = pendulum_speed(start, omega, k == 0);
    if (std::abs(speed.value - pendulum) > 0.01 * pendulum)
      throw Failure("these speeds are not those of a pendulum");
    const char* unit = "site per unit of time";
    return Row{{"centre", "centre at which the breather starts", breather_names[k]},
               {"c", "size c of the kick", c},
               {"speed", "mean speed over one site", speed, unit,
                "from two time steps and two starting points"},
               {"pendulum", "mean speed of a pendulum by the linearised flow and the barrier",
                pendulum, unit}};
  };
  report.table("speeds").fill(kicks, row, "speeds");
}

/**
## What else the article may mean

The phase is not printed. The article's approximate breather, Eqs. (18) and (20), begins with the central contact
compressed, but then the bond-centred one is 3 per cent too fast; stretched, its speed is the printed one, so that we
quote this phase. The sign of $c$ is not printed either. The reflected chain sees the kick $-c$. The bond-centred
breather is its own mirror image, so the sign does not matter. The image of the site-centred one is its other phase, so
we fix the phase and try both signs. The caption of figure 14 says that the kick is along the pinning mode itself. As
printed, without the root of the sum, $g$ has a norm far from one, and the kick not the energy $c^2/2$. Last, a short
run counts as pinned what has not yet passed the next site: we time this passage after a kick of the printed $c_c$, and
see where the site-centred breather of figure 15 is by then. */
void report_other_kicks(Report& report, const Breathers& at, const TwoRuns<KickedPath>& site,
                        const Thresholds& found) {
  const auto by = methods(report.quick);
  report_other_strong(report, breathers(far), strong, by.strong);
  report_other_thresholds(report, at, breathers(longer), {found[0].law, found[1].law},
                          {found[0].found(), found[1].found()});
  if (report.quick) return;
  report_other_weak(report, at[0], weak);
  const TwoRuns<KickedPath> runs{decided_path(at[1], printed, by.threshold.coarse, decision),
                                 decided_path(at[1], printed, by.threshold.fine, decision)};
  check_energy(at[1], printed, runs.fine);
  report_short_run(report, runs, site);
}

/**
| | around a site | around a bond, stretched | compressed |
|---|---|---|---|
| $c = 2\cdot10^{-4}$: speed, other sign | [5.4449e-4](cell:other_strong/breather=site/kick=reversed/speed) | the mirror image | the mirror image |
| along the pinning mode | [5.514e-4](cell:other_strong/breather=site/kick=along_mode/speed) | [5.382e-4](cell:other_strong/breather=bond_stretched/kick=along_mode/speed) | [5.641e-4](cell:other_strong/breather=bond_compressed/kick=along_mode/speed) |
| $c = 3\cdot10^{-6}$: farthest, other sign | [3.1](cell:other_weak/kick=reversed/farthest), going on | | |
| along the pinning mode | [3.1](cell:other_weak/kick=along_mode/farthest), going on | | |
| $c_c$ along the mode, predicted | | [4.436e-6](cell:readings/breather=bond_stretched/along_mode) | [4.232e-6](cell:breather=bond_compressed/along_mode) |
| norm of $g$ as printed | | [63.00](cell:readings/breather=bond_stretched/printed_norm) | [64.45](cell:breather=bond_compressed/printed_norm) |
| $c_c$ for this $g$ | | [7.07e-8](cell:readings/breather=bond_stretched/as_printed) | [6.70e-8](cell:breather=bond_compressed/as_printed) |

None of these gives the printed threshold, and after none is the site-centred breather pinned. With the norm as printed
even $c = 3\cdot10^{-6}$ would depin every breather. The passage after the printed $c_c$ takes until $t =$
[3.588e4](cell:short_run/time), so runs of that length would give the printed threshold; but by then the other breather
has moved by [0.3688](cell:short_run/moved) sites and not by two, so at least the run of figure 15 was longer. Both our
strong speeds are lower than the printed ones by about one unit of the last digit, the same fraction. Neither the time
over which they are fitted nor the sign of the kick explains this, and we do not know why. The law is tested for slow
motion in linear wells.

## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `moving.v_site`: velocity after a kick c = 2e-4 of the site-centred breather | 5.446e-4 sites/time | 5.445e-4 site per unit of time | in part |
| `moving.v_bond`: velocity after a kick c = 2e-4 of the bond-centred breather | 5.364e-4 sites/time | 5.363e-4 site per unit of time | in part |
| `moving.speeds_close`: the speeds of both breathers are very close | very close | 0.01505 relative | quantified |
| `moving.kick_energy`: kinetic energy of the kick c^2/2 | 2e-8 | 2.0e-8 | reproduced, assuming |
| `moving.above_below`: the kinetic energy of the kick c = 2e-4 is well above E_PN and c^2/2 for c = 3e-6 below | well above; below | key_pairs.equal_frequency (s = 0, omega = 1.1): 4.5e-12 < 1.624e-11 (the closest of 4) | holds |
| `moving.site_moves`: for c = 3e-6 the unstable site-centred breather is able to move along the lattice and to jump 2 sites | moves | weak_kicks.farthest (breather = site): 2 < 3.124 | holds |
| `moving.site_below`: for c = 3e-6 the site-centred breather, after a jump of 2 sites, gets pinned | pinned after 2 sites | weak_kicks.farthest (breather = site): 3.124 < 3 | discrepant |
| `moving.bond_pinned`: for c = 3e-6 the bond-centred breather stays pinned | pinned | weak_kicks.farthest (breather = bond_compressed): 0.2441 < 0.5 (the closest of 4) | holds |
| `moving.c_threshold`: depinning threshold c_c of the bond-centred breather | 6.19e-6 | 4.452e-6 | discrepant |
| `moving.pn_dynamic`: dynamic barrier c_c^2/2 | 1.92e-11 | 9.91e-12 | follows |
| `moving.steady`: after the kick c = 2e-4 both breathers move with an almost constant velocity | almost constant | strong_kicks.unsteadiness (breather = site): 4.863e-05 < 0.01; strong_kicks.unsteadiness (breather = bond_stretched): 4.67e-05 < 0.01; strong_kicks.unsteadiness (breather = bond_compressed): 4.306e-05 < 0.01 | holds |
| `moving.barrier_close`: c_c^2 / 2 is quite close to E_PN | quite close | 0.610 | quantified |
| `moving.dispersion`: the moving breather has negligible dispersion | negligible | strong_kicks.outside (breather = site): 2.951e-09 < 0.01; strong_kicks.outside (breather = bond_stretched): 2.913e-09 < 0.01; strong_kicks.outside (breather = bond_compressed): 3.473e-09 < 0.01 | holds |
<!-- /statements -->

## Try it

**To change it.** The parameters stand at the top. Another frequency or well needs `decision` and `watch` of about
$11/\Omega$, kicks in `report_speeds` above the threshold, longer chains if `resting_breather` asks for them, and steps
that pass `check_energy`; take $\omega_b$ and $s$ where the bond-centred breather is the stable one (`sec33_floquet`).
Another kick is another unit vector `at.g` in `breathers`: runs, prediction and threshold follow it. Another observable is a member of `KickedPath` (kick.hpp), another rule for
free and pinned is `mobility_of` (kick.cpp).

1. *Easy.* What does a kick of twice the size do to the speed?
   `build/bin/sec33_mobility kick --phase stretched --c 4e-4 --time 8000` gives `velocity` = -0.00107228. Hint: far
   beyond the threshold the velocity is the momentum of the kick divided by a negative mass.
2. *Harder.* Predict the threshold of the bond-centred breather at $\omega_b = 1.001$.
   `build/bin/sec32_barrier barrier --omega 1.001` gives `equal_area` = -2.3723e-22. Hint: with
   $\varphi = -(\omega_b-1)/3$, $|\varphi|\,c_c^2/2$ is the modulus of this barrier. How far is $c_c^2/2$ then from
   three fifths of `equal_frequency`?

`sec33_mobility kick` kicks a breather of your choice, `sec33_mobility threshold` finds the kick that depins it
(one_kick.hpp). */
void reproduce(Report& report) {
  report.output.note("sites", "52 and 53 for strong kicks, 22 to 31 otherwise");
  const Breathers at = breathers(near);
  report_strong(report);
  const TwoRuns<KickedPath> site = report_weak(report, at);
  if (!report.quick) report_passages(report, site);
  const Thresholds thresholds = report_thresholds(report, at);
  report_steps(report, at[1], thresholds[0]);
  report_speeds(report, at, thresholds[0].law);
  report_other_kicks(report, at, site, thresholds);
}

int main(int argc, char** argv) {
  return run({"sec33_mobility", "3.3", "Kicked breathers and their threshold (section 3.3)",
              reproduce, commands<OneKick, OneThreshold>()},
             argc, argv);
}
