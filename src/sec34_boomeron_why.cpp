/**
# 3.4 Why packets turn round

James, Kevrekidis and Cuevas (Physica D 251, 2013) leave open why packets turn round in the hard
wells of section 3.4. They suspect the waves that are confined between the packet and the struck
end. We test this with experiments whose outcome could contradict it.

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
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "lattice/numbers/random.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/packets/turning.hpp"
#include "lattice/stepping/damped.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the other boomeron chapters, Eqs. (9), (10) and (26),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2} - \nu_n\dot y_n,
  \qquad \dot y_n(0) = v_0\,\delta_{n,1},$$
with $s=1$, $v_0=1.9$ and a damping $\nu_n$ that is zero except where we absorb waves (damped.hpp).
Each experiment is made with two steps, for integration and damping at once. A packet has turned
when it has come back by five sites (turning.hpp); one that is only caught between two sites swings
by less than one.

| article | program | meaning |
|---|---|---|
| $s$, $v_0$ | `s`, `velocity` | the well and the impact |
| $X$ | `Path::centre` | energy centre of the strongest packet, Eq. (24) |
| – | `nu` | damping $\nu_n$ |
| – | `area` | area in phase space, $\int \sum \dot y_n^2\,dt$ over one internal period | */
constexpr double s = 1, velocity = 1.9, watched = 1000;
constexpr std::size_t sites = 150;

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

If the waves turn the packet, it must not turn without them, so we take them away in three ways.
*Behind* damps everything more than six sites behind the packet, so that no wave lies between it and
the end. *End* damps the first site only, after the packet has left: waves remain, but the end
reflects fewer of them. *Cut* takes the packet's own thirteen sites at a given time, displacements
and velocities untouched, and puts them on a chain that is otherwise at rest and has no end nearby.
*/
std::vector<double> rates(const Absorber& absorber, const Chain& chain,
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
A cut copies only the packet onto a longer chain, `shift` sites further on, with one site more on
either side than its energy centre takes into account. If it behaves differently afterwards, the
reason is that the waves or the end are missing. */
State<double> cut_out(const Chain& chain, const State<double>& state, std::size_t shift) {
  constexpr std::size_t reach = 6;
  const std::size_t peak = strongest(energy_density(chain, state));
  State<double> alone(chain.sites + shift);
  alone.t = state.t;
  for (std::size_t n = peak > reach ? peak - reach : 0; n <= peak + reach; ++n)
    alone.y[n + shift] = state.y[n], alone.v[n + shift] = state.v[n];
  return alone;
}

/**
An absorber that follows the packet changes with it, so a run consists of short stretches of two
steps each, with constant rates in each of them. The stretch shrinks with the step, so that the
comparison of two steps also shows the error of the moving absorber. */
void carry_on(const Chain& chain, State<double>& state, const std::vector<double>& nu,
              double step) {
  const ContactAware stepper{step};
  const TimeGrid grid{2 * step, 1, 2};
  if (nu.empty())
    evolve(stepper, chain, state, grid, Unobserved{});
  else
    evolve(Damped(stepper, nu), chain, state, grid, Unobserved{});
}

/**
Now we can carry out an experiment and follow its packet. After a cut the centre is still given in
sites of the old chain; `watch` sees the state before every stretch. */
template <class Watch>
Path perform(const Experiment& experiment, double step, double time, Watch watch) {
  Chain chain{sites, Quartic{s}};
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
Seven experiments are made: the undisturbed run, the two absorbers, and cuts at four times. Of each
we ask whether the packet comes back. A packet that is cut out late has already been slowed down and
may be caught by the lattice, so the facts also say how far each one moves in the second half of the
time. */
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
The figure draws the smoothed centres and energies, after a cut only those from the cut on. */
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
Whether a packet came back must not depend on the step: if two steps disagree there is no answer,
and the program fails. */
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

What is it that the waves turn? If the packet is a breather that moves, its frequency, energy and
area should be related as in the breathers at rest of the same $s$, which we compute by Newton's
method. The frequency is read from the upward zeros of $\sum(-1)^n y_n$ over the packet, since
neighbours in a breather have opposite signs; the area is the mean of $\sum\dot y_n^2$ over
stretches of twenty units of time, times the period.

The lattice itself could stop a packet. Its barrier is the energy difference of site-centred and
bond-centred breathers, $E_{\rm site}-E_{\rm bond}$, at equal area (chapter 3.2). It repeats itself
from site to site, so the force that belongs to it has both signs within one site. */
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
Each look at the chain adds to the sums. The alternating sign cancels long waves that run through
the packet; they would shift the zeros of a single site. */
void Gauge::operator()(const State<double>& now) {
  const std::vector<double> e = energy_density(Chain{now.y.size(), Quartic{s}}, now);
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
To place a zero between two looks we draw a straight line. The frequency of a stretch then follows
from the number of periods between its first and its last upward zero. */
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
For the comparison we need both families of breathers at rest over the packet's range of
frequencies. We follow them in small steps of the frequency, each starting Newton's method from the
breather before, and take the barrier on the way. */
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

/// A quantity of the bond-centred family at the frequency `omega`, interpolated linearly between two of
/// every `each` rungs.
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
The figure draws the packet, as it moves, over the breathers at rest, so both become tables. */
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
For the facts we average from $t = 100$, when the packet has left the end, to $t = 300$, before it
turns, and compare with the breather of the same mean frequency. */
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
We compare two packets, the one that turns and the one that does not because everything behind it is
absorbed. If the waves feed the packet, the two should differ in energy.

The packet is close to a breather that moves: at its frequency,
[1.68362](num:sec34_boomeron_why.omega_waves), its area is
[5.9885](num:sec34_boomeron_why.area_waves) and that of a breather at rest
[5.83](num:sec34_boomeron_why.area_at_rest_waves). With the waves its energy is
[1.48728](num:sec34_boomeron_why.energy_waves), without them
[1.3694](num:sec34_boomeron_why.energy_behind), so they do feed it. The barrier,
[0.00040](num:sec34_boomeron_why.barrier_waves), can hold a slow packet, as we see after late
cuts. But a force of both signs within one site can neither slow a packet over many sites nor send
it back. */
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
we give waves to a breather at rest. On one side of a bond-centred breather, from its sixth
neighbour on, we set fifteen sites oscillating, with phases drawn at random from a recorded seed. If
waves pull, the breather moves towards them on whichever side they are; if they push, it moves away.
The linear well, in which no packet turns, serves as the control, with a breather of the same energy
and the same waves. */
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
We put the breather into the middle of a quiet chain and the waves beside it. Its displacement is
measured from the bond at which it rested. */
Path expose(const Trial& trial, const Orbit<double>& orbit, double step) {
  const std::size_t length = 160, first = 64, centre = first + orbit.start.y.size() / 2;
  const Chain chain{length, Quartic{trial.well}};
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
The outcome of a single draw depends much on chance, so there are many draws, and each is used four
times: in both wells and, mirrored, on both sides. */
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
The result for a well is the mean displacement towards the waves. The two sides of one draw share their
phases and are not independent, so the standard error is that of the draws, each the mean of its two sides.
We also count, at both steps, the breathers that moved towards the waves by more than a tenth of a site, and
note the largest difference between two steps in any trial, which must be far below the mean. */
void add_pull(Quantities& facts, const std::vector<Trial>& list, double well) {
  std::vector<double> draws(list.size() / 4, 0.0);
  std::array<std::int64_t, 2> towards{};
  double steps = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Trial& t = list[k];
    if (t.well != well) continue;
    const double x = t.side * t.moved(t.path), rough = t.side * t.moved(t.coarse);
    draws[k / 4] += x / 2;
    towards[0] += rough > 0.1, towards[1] += x > 0.1;
    steps = std::max(steps, std::abs(x - rough));
  }
  const double n = double(draws.size()),
               mean = std::accumulate(draws.begin(), draws.end(), 0.0) / n;
  double square = 0;
  for (double x : draws) square += (x - mean) * (x - mean);
  const double error = std::sqrt(square / (n - 1) / n);
  const std::string name = well > 0 ? "_hard" : "_linear";
  facts.add("pull" + name, {mean, error}, "site towards the waves");
  facts.add("pull_steps" + name, compare(0.0, steps), "largest difference of two steps");
  const Estimate pulled = compare(towards[0], towards[1]);
  facts.add("pulled" + name, quotient(pulled, exact(2 * n)), "share of the trials");
}

/**
The figure shows every trial and not only their mean, so that the reader sees how much they scatter.
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
The frequencies of the two breathers are chosen such that their energies agree; both energies stand
among the facts, so that this can be checked.

In the hard well the waves draw the breather towards them, by
[6.4](num:sec34_boomeron_why.pull_hard) sites on average, in a fraction
[1](num:sec34_boomeron_why.pulled_hard) of the trials. In the linear well the same waves move a
breather of the same energy by [0.20](num:sec34_boomeron_why.pull_linear) sites. */
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

**The packet turns because the waves that it left behind, which the article suspected, pull it
back.** With the waves it comes back. With everything behind it absorbed it does not, nor if only
the first site absorbs: in the second half of the time it still moves on by
[13.1](num:sec34_boomeron_why.late_advance_behind) and
[5.8](num:sec34_boomeron_why.late_advance_end) sites. Put on a quiet chain at $t = 60$ or 120 it
moves on as well. Cut out later, when it is almost at rest, it is caught or creeps (by
[-2.961](num:sec34_boomeron_why.late_advance_cut200) sites after a cut at $t = 200$ and
[-0.2285](num:sec34_boomeron_why.late_advance_cut300) at 300), but does not come back within the
time watched. So the slowing down has two parts: a loss of speed that needs no waves and that fades,
and a backward force that needs them. */
void reproduce(Report& report) {
  report_experiments(report);
  report_inside(report);
  report_waves(report);
}

/**
## Differences and limits

Exact travelling breathers (section 5) do not explain the turning. At the packet's energy we know of
none at $s = 1$: the fastest one found there has the speed
[0.0539509](num:sec5_travelling_families.fastest_at_one) and the energy
[0.00165802](num:sec5_travelling_families.fastest_energy_at_one).

We show that waves pull but do not derive it. A contact only pushes, and that a push from behind
draws a packet back suggests a negative effective mass: in figure 23 neighbours in the packet
oscillate in opposite phase, as at the upper edge of a band, while the waves behind it are long and
in phase. Nor do we know why the breather of the linear well hardly responds; it may be heavier, or
take less energy from the waves. The waves of the last experiment have the amplitude 0.15, about
that of the waves behind the packet; the dependence on it was not mapped.

## Extensions

- How does the pull depend on amplitude and frequency of the waves? Is there a frequency that pushes?
- Measure the mass of both breathers by kicking them, and compare the ratio with that of the pulls.
- Does a packet also turn when waves come towards it? */
int main(int argc, char** argv) {
  return run(
      {"sec34_boomeron_why", "3.4", "Why packets turn round (section 3.4, s > 0)", reproduce}, argc,
      argv);
}
