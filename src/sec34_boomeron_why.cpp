/**
# 3.4 Why packets turn round

James, Kevrekidis and Cuevas (Physica D 251, 2013) have no clear explanation of the packets of
section 3.4 that turn round in hard wells. They suspect the waves which are confined between the
packet and the struck end, and close with the question. We ask it by experiments that can fail.

     waves     |~~~~~~~~~~~~~~~ (packet)              does it turn?
     behind    |xxxxxxxxx       (packet)              waves absorbed: still?
     end       |x~~~~~~~~~~~~~~ (packet)              waves not returned: still?
     cut                        (packet)              alone on a quiet chain: still?
     beside              (breather) ~~~~~~            at rest, waves beside it: does it move?

![Four experiments on the turning packet.](fig:x12)

The answer, with its evidence, stands under *Results*. */

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/measure/turning.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/numbers/random.hpp"
#include "lattice/orbits/ladder.hpp"
#include "lattice/report/program.hpp"
#include "lattice/stepping/damped.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the other boomeron chapters, Eqs. (9), (10) and (26),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2} - \gamma_n\dot y_n,
  \qquad \dot y_n(0) = v_0\,\delta_{n,1},$$
with $s=1$, $v_0=1.9$ and a damping $\gamma_n$ that is zero except where we absorb (damped.hpp).
Each experiment is made at two steps, of the integration and of the damping at once. The criterion
of the figure is that a packet has turned when it has come back by five sites (turning.hpp); one
that is merely caught between two sites swings by less than one.

| article | program | meaning |
|---|---|---|
| $s$, $v_0$ | `s`, `velocity` | the well and the impact |
| $X$ | `Path::centre` | energy centre of the strongest packet, Eq. (24) |
| $\mathcal A$ | `area` | $\int \sum \dot y_n^2\,dt$ over one internal period | */
constexpr double s = 1, velocity = 1.9, watched = 1000;
constexpr std::size_t sites = 150;
using HardChain = Chain<Quartic, Hertz>;

/// Damping of what lies more than `behind` sites behind the packet, or on the first `first` sites,
/// from a time on. Zero sites: none.
struct Absorber {
  std::size_t behind = 0, first = 0;
  double rate = 0, from = 60;
};

/// One experiment: its name in the facts, when it begins, and what is done.
struct Experiment {
  std::string name;
  Absorber absorber{};
  double cut = 0;  ///< time at which the packet is cut out and put on a quiet chain, 0: never
  Path path{}, coarse{};
};

std::size_t strongest(const std::vector<double>& e) {
  return std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
}

/**
## The experiments

*Behind* damps everything more than six sites behind the packet, so that no wave lies between it and
the end. *End* damps the first site only, after the packet has left: waves stay, but are
no longer returned. *Cut* takes the packet's own thirteen sites at a given time, displacements and
velocities untouched, and puts them on a chain that is at rest otherwise and has no end nearby. */
std::vector<double> rates(const Absorber& absorber, const HardChain& chain,
                          const State<double>& state) {
  if (absorber.rate == 0 || state.t < absorber.from) return {};
  std::size_t until = absorber.first;
  if (absorber.behind > 0) {
    const std::size_t peak = strongest(energy_density(chain, state));
    until = peak > absorber.behind ? peak - absorber.behind : 0;
  }
  std::vector<double> nu(chain.sites, 0.0);
  std::fill_n(nu.begin(), until, absorber.rate);
  return nu;
}

/**
To cut is to copy the packet alone onto a longer chain, `shift` sites further on, with one site more
on either side than its energy centre takes into account. If it behaves differently afterwards, the
missing waves are the reason, or the missing end. */
State<double> cut_out(const HardChain& chain, const State<double>& state, std::size_t shift) {
  constexpr std::size_t reach = 6;
  const std::size_t peak = strongest(energy_density(chain, state));
  State<double> alone(chain.sites + shift);
  alone.t = state.t;
  for (std::size_t n = peak > reach ? peak - reach : 0; n <= peak + reach; ++n)
    alone.y[n + shift] = state.y[n], alone.v[n + shift] = state.v[n];
  return alone;
}

/**
An absorber that follows the packet changes with it, so a run is made of short stretches of two
steps each, with rates that are constant in one. The stretch shrinks with the step, so that the
error of the moving absorber is seen by the comparison of two steps as well. */
void carry_on(const HardChain& chain, State<double>& state, const std::vector<double>& nu,
              double step) {
  const ContactAware stepper{step};
  const Pace pace{2 * step, 1, 2};
  if (nu.empty())
    evolve(stepper, chain, state, pace, Unobserved{});
  else
    evolve(Damped(stepper, nu), chain, state, pace, Unobserved{});
}

/**
Now an experiment can be carried out. After a cut the centre is still told in sites of the old
chain, and `watch` sees every stretch. */
template <class Watch>
Path perform(const Experiment& experiment, double step, double time, Watch watch) {
  HardChain chain{sites, {s}};
  State<double> state = struck(sites, velocity);
  const std::size_t shift = 80;
  const double stretch = 2 * step;
  const auto per_look = std::size_t(std::lround(sampling / stretch));
  Path path;
  bool moved = false;
  for (std::size_t k = 0; k * stretch < time; ++k) {
    if (experiment.cut > 0 && !moved && state.t >= experiment.cut - 1e-9) {
      state = cut_out(chain, state, shift);
      chain.sites += shift;
      moved = true;
    }
    if (k % per_look == 0) {
      path.add(state.t, energy_density(chain, state));
      if (moved) path.centre.back() -= double(shift);
    }
    watch(std::as_const(state));
    carry_on(chain, state, rates(experiment.absorber, chain, state), step);
  }
  return path;
}

/**
The decision is one line: did the packet come back? With the waves it does, and the question is
whether it does without. A packet that is cut out late has already been slowed down and may be
caught by the lattice; the facts say how far each one moves in the last half of the time. */
std::vector<Experiment> experiments() {
  std::vector<Experiment> list{
      {"waves", {}, 0}, {"behind", {6, 0, 0.1, 0}, 0}, {"end", {0, 1, 0.2, 60}, 0}};
  for (int t : {60, 120, 200, 300}) list.push_back({"cut" + std::to_string(t), {}, double(t)});
  return list;
}

/// How far the smoothed centre moves between two times.
double advance(const Path& path, double from, double to) {
  const Path p = smooth(path, smoothing);
  const auto at = [&](double t) {
    const auto i = std::lower_bound(p.t.begin(), p.t.end(), t) - p.t.begin();
    return p.centre[std::min(std::size_t(i), p.t.size() - 1)];
  };
  return at(to) - at(from);
}

/**
The figure draws the smoothed centres and energies. After a cut the first window of the smoothing
still reaches back before it, so a path is drawn from the cut on. */
Table tracks(const std::vector<Experiment>& list) {
  Table table{{count("experiment",
                     "0 waves left, 1 absorbed behind, 2 absorbed at the end, then cut at "
                     "60, 120, 200, 300"),
               number("t", "time"), number("centre", "centre of the packet, smoothed", "site"),
               number("energy", "energy of the packet, smoothed")}};
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Path p = smooth(list[k].path, smoothing);
    for (std::size_t i = 0; i < p.t.size(); i += 20)
      if (p.t[i] > list[k].cut) table.add({std::int64_t(k), p.t[i], p.centre[i], p.energy[i]});
  }
  return table;
}

/**
Whether a packet came back must not depend on the step: where two steps disagree there is no answer,
and the program says so and stops. */
void add_experiment(Quantities& facts, const Experiment& e) {
  const auto turned = [](const Path& p) { return find_turn(smooth(p, smoothing)).apex.found(); };
  const auto late = [](const Path& p) { return advance(p, watched / 2, watched - 20); };
  if (turned(e.coarse) != turned(e.path))
    throw Failure(e.name + ": two steps disagree on the turning");
  facts.add("turned_" + e.name, exact(turned(e.path)), "1 if it came back");
  facts.add("late_advance_" + e.name, compare(late(e.coarse), late(e.path)), "site");
}

void report_experiments(Report& report) {
  std::vector<Experiment> list = experiments();
  const double step = report.quick ? 0.1 : 0.05;
  parallel_for(2 * list.size(), [&](std::size_t i) {
    Experiment& e = list[i / 2];
    (i % 2 ? e.path : e.coarse) = perform(e, i % 2 ? step / 2 : step, watched, Unobserved{});
  });
  for (const Experiment& e : list) add_experiment(report.facts, e);
  report.output.add("experiments", tracks(list));
}

/**
## Inside the packet

If the packet is a breather that moves, its frequency, energy and area should follow those of the
breathers at rest at the same $s$, computed by Newton's method for both families. The frequency is
read from the upward zeros of $\sum(-1)^n y_n$ over the packet, which oscillates with the sign
pattern of the breather; the area is the mean of $\sum\dot y_n^2$ over stretches of twenty units of
time, times the period. Where a chain pins is told by the barrier $E_{\rm site}-E_{\rm bond}$ at
equal area (chapter 3.2): it is a periodic force, of both signs within one site, and its size
compares with the energy that the packet has for moving. */
struct Inside {
  double t = 0, site = 0, energy = 0, area = 0, omega = 0;
};

/// Sums over a stretch of time, and the zeros that fell into it.
struct Gauge {
  std::vector<Inside> rows{};
  double before = 0, before_t = 0, first = 0, last = 0;
  int zeros = 0;
  Inside sum{};
  double samples = 0, begin = 0;

  void operator()(const State<double>& now);
  void look_for_zero(double pattern, double t);
  void finish(double t);
};

/**
One look at the chain adds to the sums. The alternating sign of the pattern takes out long waves
that run through the packet, which would shift the zeros of a single site. */
void Gauge::operator()(const State<double>& now) {
  const std::vector<double> e = energy_density(HardChain{now.y.size(), {s}}, now);
  const std::size_t peak = strongest(e), m = packet_half_width;
  double pattern = 0;
  for (std::size_t n = peak > m ? peak - m : 0; n <= peak + m; ++n) {
    pattern += (n % 2 ? -1 : 1) * now.y[n];
    sum.area += now.v[n] * now.v[n];
  }
  sum.site += energy_centre(e, peak), sum.energy += window_sum(e, peak), ++samples;
  look_for_zero(pattern, now.t);
  if (now.t - begin >= 20 - 1e-9) finish(now.t);
}

/**
The frequency is the number of periods between the first and the last upward zero of a stretch over
the time between them, each zero placed by a straight line between two looks. */
void Gauge::look_for_zero(double pattern, double t) {
  if (before < 0 && pattern >= 0) {
    last = before_t + (t - before_t) * before / (before - pattern);
    if (zeros++ == 0) first = last;
  }
  before = pattern, before_t = t;
}

void Gauge::finish(double t) {
  const double omega =
      zeros > 1 ? 2 * std::numbers::pi * (zeros - 1) / (last - first) : std::nan("");
  rows.push_back({(begin + t) / 2, sum.site / samples, sum.energy / samples,
                  sum.area / samples * 2 * std::numbers::pi / omega, omega});
  begin = t, sum = {}, samples = 0, zeros = 0;
}

std::vector<Inside> gauge(const Experiment& experiment, double step) {
  Gauge gauge;
  perform(experiment, step, 420, [&](const State<double>& now) { gauge(now); });
  return gauge.rows;
}

/**
What the packet is compared with are both families of breathers at rest, climbed rung by rung in
frequency from the bottom of the packet's range on. The barrier is taken on the way, where both
orbits of a rung are at hand. */
struct Family {
  std::vector<Orbit<double>> bond, site;
  std::vector<double> gap;  ///< E_site - E_bond at equal area
};

Family family() {
  std::vector<double> omegas;
  for (int k = 0; k <= 14; ++k) omegas.push_back(1.58 + 0.02 * k);
  Family f{climb(Centre::bond, s, omegas), climb(Centre::site, s, omegas), {}};
  for (std::size_t k = 0; k < std::min(f.bond.size(), f.site.size()); ++k)
    f.gap.push_back(
        barrier(problem_of(Centre::site, omegas[k], s), f.site[k], f.bond[k]).equal_area);
  return f;
}

/// A quantity of the bond-centred family at the frequency `omega`, between two of every `each` rungs.
template <class Of>
double at_frequency(const Family& f, double omega, Of of, std::size_t each = 1) {
  std::size_t k = each;
  while (k + each < f.gap.size() && f.bond[k].omega < omega) k += each;
  const double a = f.bond[k - each].omega, b = f.bond[k].omega;
  return of(k - each) + (of(k) - of(k - each)) * (omega - a) / (b - a);
}

/**
Its error has two sources: the distance of the rungs, which we see from every second one, and the error
of the frequency. */
template <class Of>
Estimate at_rest(const Family& f, const Estimate& omega, Of of) {
  const double here = at_frequency(f, omega.value, of);
  Estimate out = compare(at_frequency(f, omega.value, of, 2), here);
  out.error += std::abs(at_frequency(f, omega.value + omega.error, of) - here);
  return out;
}

/**
Both sides of the comparison become tables, the packet along its way and the breathers along their
frequency, so that the figure can lay one over the other. */
Table packet_inside(const std::vector<Inside>* rows) {
  Table along{{count("experiment", "0 waves left, 1 absorbed behind"), number("t", "time"),
               number("centre", "centre of the packet", "site"), number("energy", "its energy"),
               number("area", "its area"), number("omega", "its frequency")}};
  for (int k : {0, 1})
    for (const Inside& r : rows[2 * k + 1])
      along.add({std::int64_t(k), r.t, r.site, r.energy, r.area, r.omega});
  return along;
}

Table breathers_at_rest(const Family& f) {
  Table rest{{number("omega", "frequency"), number("energy_bond", "energy, bond-centred"),
              number("energy_site", "energy, site-centred"),
              number("area_bond", "area, bond-centred"), number("area_site", "area, site-centred"),
              number("barrier", "E_site - E_bond at equal area")}};
  for (std::size_t k = 0; k < f.gap.size(); ++k)
    rest.add({f.bond[k].omega, f.bond[k].energy, f.site[k].energy, f.bond[k].area, f.site[k].area,
              f.gap[k]});
  return rest;
}

/**
The facts are means over the times from 100, when the packet has left the end, to 300, before it
turns, at two steps. The breather to compare with is the one of the same mean frequency. */
Estimate mean_inside(const std::vector<Inside>& coarse, const std::vector<Inside>& fine,
                     double Inside::*of) {
  const auto over = [&](const std::vector<Inside>& list) {
    double sum = 0, n = 0;
    for (const Inside& r : list)
      if (r.t > 100 && r.t < 300) sum += r.*of, ++n;
    return sum / n;
  };
  return compare(over(coarse), over(fine));
}

void compare_inside(Quantities& facts, const std::string& name, const Family& f,
                    const std::vector<Inside>& coarse, const std::vector<Inside>& fine) {
  const auto mean = [&](double Inside::*of) { return mean_inside(coarse, fine, of); };
  const Estimate omega = mean(&Inside::omega);
  const std::string same = "bond-centred breather of the packet's frequency";
  facts.add("omega" + name, omega);
  facts.add("energy" + name, mean(&Inside::energy));
  facts.add("area" + name, mean(&Inside::area));
  facts.add("energy_at_rest" + name, at_rest(f, omega, [&](auto i) { return f.bond[i].energy; }),
            same);
  facts.add("area_at_rest" + name, at_rest(f, omega, [&](auto i) { return f.bond[i].area; }), same);
  facts.add("barrier" + name, at_rest(f, omega, [&](auto i) { return f.gap[i]; }),
            "E_site - E_bond at equal area");
}

/**
Two packets are looked at, the one that turns and the one that does not because everything behind it
is absorbed. If the waves feed the packet, the two should differ in energy.

The packet is a breather that moves: its frequency [1.68362](num:sec34_boomeron_why.omega_waves) and
its area [5.9885](num:sec34_boomeron_why.area_waves) lie by those of a breather at rest, whose area
at this frequency is [5.83399](num:sec34_boomeron_why.area_at_rest_waves). While it feeds on the
waves it carries [1.48728](num:sec34_boomeron_why.energy_waves), without them
[1.3694](num:sec34_boomeron_why.energy_behind). The barrier,
[0.000398715](num:sec34_boomeron_why.barrier_waves), can hold a slow packet, which is what we see of
late cuts, but being periodic it can neither slow one over many sites nor send it back. */
void report_inside(Report& report) {
  const std::vector<Experiment> list = experiments();
  const double step = report.quick ? 0.1 : 0.05;
  std::vector<Inside> rows[4];
  parallel_for(4, [&](std::size_t i) { rows[i] = gauge(list[i / 2], i % 2 ? step / 2 : step); });
  const Family f = family();
  report.output.add("packet_inside", packet_inside(rows));
  report.output.add("breathers_at_rest", breathers_at_rest(f));
  compare_inside(report.facts, "_waves", f, rows[0], rows[1]);
  compare_inside(report.facts, "_behind", f, rows[2], rows[3]);
}

/**
## Waves beside a breather at rest

The last experiment reverses the first: instead of taking the waves away from a packet that turns,
we give waves to a breather that rests. A bond-centred breather gets fifteen oscillating sites on
one side, beyond its fifth neighbours, with phases drawn from a recorded seed. If waves pull, it
moves towards them from either side; if they push, away. The linear well, in which nothing turns,
serves as the control, with a breather of the same energy and the same waves. */
constexpr unsigned long seed = 20130502;
constexpr double wave_amplitude = 0.15, wave_time = 300;

struct Trial {
  double well, omega;
  int side;  ///< -1: waves on the left
  std::vector<double> phase;
  Path path{}, coarse{};

  double moved(const Path& p) const {
    const Path q = smooth(p, smoothing);
    return q.centre.back() - q.centre.front();
  }
};

/**
The breather is laid into the middle of a quiet chain and the waves beside it; the displacement is
told from the bond at which the breather rested. */
Path expose(const Trial& trial, const Orbit<double>& orbit, double step) {
  const std::size_t length = 160, first = 64, centre = first + orbit.start.y.size() / 2;
  const HardChain chain{length, {trial.well}};
  State<double> state(length);
  for (std::size_t i = 0; i < orbit.start.y.size(); ++i)
    if (std::abs(orbit.start.y[i]) > 1e-30) state.y[first + i] = orbit.start.y[i];
  for (std::size_t k = 0; k < trial.phase.size(); ++k) {
    const std::size_t n = trial.side < 0 ? centre - 6 - k : centre + 5 + k;
    state.y[n] += wave_amplitude * std::cos(trial.phase[k]);
    state.v[n] += wave_amplitude * std::sin(trial.phase[k]);
  }
  Path path;
  evolve(ContactAware{step}, chain, state, wave_time, sampling, [&](const State<double>& now) {
    path.add(now.t, energy_density(chain, now));
    path.centre.back() -= double(centre) + 0.5;
  });
  return path;
}

/**
Chance decides much in a single draw, so there are many, and each is used four times: in both wells
and on both sides, with the same phases, mirrored. What the four have in common cannot be chance. */
std::vector<Trial> trials(std::size_t count) {
  Random random(seed);
  std::vector<Trial> list;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> phase(15);
    for (double& x : phase) x = random.uniform(0, 2 * std::numbers::pi);
    for (const auto& [well, omega] : {std::pair{1.0, 1.68}, {0.0, 1.6045}})
      for (int side : {-1, 1}) list.push_back({well, omega, side, phase});
  }
  return list;
}

/**
The result for a well is the mean displacement towards the waves, with the standard error over the
trials. We also count, at both steps, how many breathers moved towards the waves by more than a tenth of
a site, and keep the largest difference of two steps in any trial, beside which the mean has to be seen. */
void add_pull(Quantities& facts, const std::vector<Trial>& list, double well) {
  double sum = 0, square = 0, steps = 0, n = 0;
  std::array<std::int64_t, 2> towards{};
  for (const Trial& t : list) {
    if (t.well != well) continue;
    const double x = t.side * t.moved(t.path), rough = t.side * t.moved(t.coarse);
    sum += x, square += x * x, ++n;
    towards[0] += rough > 0.1, towards[1] += x > 0.1;
    steps = std::max(steps, std::abs(x - rough));
  }
  const double mean = sum / n, error = std::sqrt((square / n - mean * mean) / (n - 1));
  const std::string name = well > 0 ? "_hard" : "_linear";
  facts.add("pull" + name, {mean, error}, "site towards the waves");
  facts.add("pull_steps" + name, compare(0.0, steps), "largest difference of two steps");
  const Estimate pulled = compare(towards[0], towards[1]);
  facts.add("pulled" + name, {pulled.value / n, pulled.error / n, pulled.is_exact},
            "share of the trials");
}

/**
The figure shows every trial and not only their mean, so that the reader sees how far chance goes.
*/
Table waves_beside(const std::vector<Trial>& list) {
  Table table{{number("s", "anharmonicity of the well"),
               count("side", "-1 waves on the left, 1 on the right"),
               count("trial", "number of the draw"), number("t", "time"),
               number("displacement", "of the centre, smoothed", "site")}};
  table.meta = {{"seed", std::to_string(seed)}};
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Path p = smooth(list[k].path, smoothing);
    for (std::size_t i = 0; i < p.t.size(); i += 25)
      table.add({list[k].well, std::int64_t(list[k].side), std::int64_t(k / 4), p.t[i],
                 p.centre[i] - p.centre[0]});
  }
  return table;
}

/**
The two breathers have the same energy, and both energies stand among the facts, so that the control
can be checked.

A breather at rest that nothing else could move is drawn towards waves on either side, by
[6.4](num:sec34_boomeron_why.pull_hard) sites in the share [1](num:sec34_boomeron_why.pulled_hard)
of the trials; in the linear well the same waves move a breather of the same energy by
[0.20](num:sec34_boomeron_why.pull_linear), and there nothing turns. */
void report_waves(Report& report) {
  std::vector<Trial> list = trials(report.quick ? 3 : 12);
  const double step = report.quick ? 0.2 : 0.1;
  const auto resting = [](double omega, double well, int coarser) {
    return find_breather(problem_of(Centre::bond, omega, well), Phase::compressed,
                         rule<double>(coarser));
  };
  const Orbit<double> hard = resting(1.68, 1, 0), linear = resting(1.6045, 0, 0);
  parallel_for(2 * list.size(), [&](std::size_t i) {
    Trial& t = list[i / 2];
    (i % 2 ? t.path : t.coarse) = expose(t, t.well > 0 ? hard : linear, i % 2 ? step / 2 : step);
  });
  report.output.add("waves_beside", waves_beside(list));
  for (double well : {1.0, 0.0}) add_pull(report.facts, list, well);
  report.facts.add("energy_beside_hard", compare(resting(1.68, 1, 1).energy, hard.energy));
  report.facts.add("energy_beside_linear", compare(resting(1.6045, 0, 1).energy, linear.energy));
}

/**
## Results

**The packet turns because of the waves that it left behind, as the article suspected, and they
pull.** With the waves it comes back; with everything behind it absorbed it does not, nor if only
the first site absorbs, and in the last half of the time it still moves on by
[13.1](num:sec34_boomeron_why.late_advance_behind) and
[5.8](num:sec34_boomeron_why.late_advance_end) sites. Put on a quiet chain at time 60 or 120 it
moves on as well; cut out later, when it is almost at rest, it is caught or creeps
([-2.961](num:sec34_boomeron_why.late_advance_cut200) sites for a cut at 200,
[-0.2285](num:sec34_boomeron_why.late_advance_cut300) at 300), but never returns. So the slowing
down has two parts, a loss of speed that the packet brings along and that fades, and a backward
force that needs waves. */
Results reproduce(Report& report) {
  report_experiments(report);
  report_inside(report);
  report_waves(report);
  report.output.add("facts", report.facts.table);
  return report.results;
}

/**
## Differences and limits

The packet does not turn where exact travelling breathers end (section 5). At its energy there are none
at $s = 1$: the fastest one there has the speed [0.0539509](num:sec5_travelling_families.fastest_at_one) and the
energy [0.00165802](num:sec5_travelling_families.fastest_energy_at_one).

Why waves pull we show but do not derive. A contact only pushes; that pushing from behind draws a
packet back suggests a negative mass: in figure 23 neighbours in the packet oscillate in opposite
phase, as at the upper edge of a band, while the waves behind it are long and in phase. Nor does the
experiment say why the linear well's breather hardly answers; it may be heavier, or feed less. The
amplitude of the waves in the last experiment, 0.15, is of the size of those behind the packet; the
dependence on it was not mapped.

## Extensions

- How does the pull depend on amplitude and frequency of the waves? Is there a frequency that pushes?
- Measure the mass of both breathers by kicking them, and compare the ratio with that of the pulls.
- Does a packet turn round in front of waves that come towards it? */
int main(int argc, char** argv) {
  Program program({"sec34_boomeron_why", "3.4", "Why packets turn round (section 3.4, s > 0)"},
                  argc, argv);
  program.everything = [&](Output& output) {
    Report report{output, program.quick};
    return reproduce(report);
  };
  return program.run(argc, argv);
}
