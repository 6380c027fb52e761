/**
# 2 No breathers without an on-site potential

Does a chain of beads need wells to have breathers? Section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013)
proves that it does: beads that only repel each other have no motion that is both periodic in time and localized in
space. We check the identity behind the proof and watch a localized state disperse.

The proof is one integral. Bead $n$ obeys $m_n\ddot x_n = F_{n-1} - F_n$ with the force $F_n \ge 0$ of contact $n$, and
over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_{n-1}\,dt - \int_0^T F_n\,dt :$$
the mean force $\bar F_n$ is the same at every contact (`thm.mean_force`). Far to the right of a localized motion, Eq.
(5), the overlaps tend to zero, and so do the forces: by hypothesis (2) all contacts there obey one bound $F_n \le f$ of
the overlap with $f(0) = 0$. Without it ever stiffer contacts could carry the same mean at ever smaller overlaps. So the
mean is zero. A force that is never negative and has zero mean vanishes: the beads are free, and the only periodic
motion of free beads is rest, in which no contact overlaps, $x_n \ge x_{n-1}$ (`thm.equilibria`).

No computation proves a theorem, but ours could have refuted it, by a localized state that stays together or returns to
its start. (By Newton's law the means are equal on every periodic motion; that part tests our motions and averages.)
Each test has a control in the wells of section 3. Their mean force can balance unequal contact forces on the two sides
of a bead. So the proof does not forbid breathers there, and section 3 computes some.

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); energy and mean force of a
localized state (c, d). Drawn by x16_mean_force.py from the tables `mean_forces` (against `n`) and `dispersal` (against
`t`).](fig:x16) */
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3), dimensionless, with a mass for each bead and a stiffness for each contact. Wells
$W$ (section 3) add one more force:
$$m_n\ddot x_n = F_{n-1}-F_n-W'(x_n),\qquad F_n = \gamma_n\,(x_n-x_{n+1})_+^{\alpha}.$$
Its mean over a time $T$ is the balance of a bead, whose left side vanishes over a period:
$$\frac{m_n}{T}\bigl[\dot x_n\bigr]_0^T = \bar F_{n-1}-\bar F_n-\overline{W'(x_n)}.$$

## The experiment

We find a periodic motion and average the force of every contact over its period, $2\pi$ for what follows. Beads start
from rest, neighbours displaced in opposite directions. Newton's method corrects the start until all velocities vanish
after half a period; the motion then retraces its path and closes. The guess is the amplitude $A$ on a uniform ring with
only the first harmonic of each of the two forces on a bead, $0.458\,(2A)^{3/2}$. From there masses, stiffnesses and
exponents become uneven in stages: `part` of 15 per cent, or of the way to $\alpha$. */
constexpr double period = 2 * std::numbers::pi;

Chain uneven_chain(std::size_t sites, Ends ends, double alpha, double part) {
  Chain chain{sites, None{}, PowerContact{1.5 + part * (alpha - 1.5)}, ends};
  std::vector<double> gamma = shaken(std::vector<double>(sites + 1, 1), 0.15 * part, 12);
  if (ends == Ends::periodic) gamma.back() = gamma.front();  // one contact of a ring
  vary(chain, shaken(std::vector<double>(sites, 1), 0.15 * part, 11), gamma);
  return chain;
}

// The flow over half a period, its derivative, and what must vanish then: all velocities
Equations<double> rest_after_half(const Chain& chain) {
  return Shooting<double>{chain, even_in_time(chain.sites), 1}.equations();
}

// Far from a solution a step is halved until it lowers the residual. On a ring a motion may be shifted in time or along
// the chain, which makes the matrix singular; of all steps we take the shortest.
const NewtonRule<double> shortest{.most_steps = 60, .damped = true, .rank = 1e-9};

State<double> standing_wave(const std::function<Chain(double)>& chain_at) {
  Vector<double> y(chain_at(0).sites);
  const double A = std::pow(0.457 * std::pow(2, 2.5), -2);  // A = 2 * 0.457 (2 A)^(3/2)
  for (long n = 0; n < y.size(); ++n) y[n] = n % 2 == 0 ? A : -A;
  for (double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    y = newton(rest_after_half(chain_at(part)), y, shortest).x;
  State<double> start(y.size());
  start.y.assign(y.begin(), y.end());
  return start;
}

// GSL integrates the equations of motion, with the integrals of all pushes and of all W' as further unknowns
struct Means {
  Vector<double> push, well, y, v;  // means over the time, and the state at its end
};
Means mean_forces(const Chain& chain, const State<double>& start, double time, double tolerance) {
  const std::size_t N = chain.sites;
  const auto equations = [&](double, const double* x, double* rate) {
    double *velocity = rate, *acceleration = rate + N, *push = rate + 2 * N, *pull = push + N + 1;
    for (std::size_t i = 0; i <= N; ++i) push[i] = contact_push(chain, x, i);
    for (std::size_t n = 0; n < N; ++n) {
      pull[n] = -chain.well.force(x[n]);
      velocity[n] = x[N + n];
      acceleration[n] = (push[n] - push[n + 1] - pull[n]) / chain.mass_of(n);
    }
  };
  std::vector<double> z = start.y;
  z.insert(z.end(), start.v.begin(), start.v.end());
  z.resize(4 * N + 1, 0);
  double t = 0;
  Reference(equations, z.size(), tolerance).advance(t, time, z);
  const Vector<double> end = Eigen::Map<const Vector<double>>(z.data(), long(z.size()));
  return {end.segment(2 * N, N + 1) / time, end.tail(N) / time, end.head(N), end.segment(N, N)};
}

/**
## Checks and errors

Every number comes from two tolerances of GSL, $10^{-11}$ and $10^{-13}$; their difference is its error. The program
stops in three cases: if Newton's method does not converge; if contacts and wells do not add up to the change of
momentum of a bead, as they must on any motion, since then our averages are wrong; and if GSL, which shares nothing but
the force law with the integrator that found a motion, does not bring it back to its start, since then it is not
periodic. */
struct Motion {
  std::string name;
  Means coarse, fine;
  bool outermost;    // whether the outermost contacts exist, on a ring or between walls
  double amplitude;  // largest displacement or velocity at the start
};

Motion averaged(const std::string& name, const Chain& chain, const State<double>& start,
                double time, bool outermost, bool returns = true) {
  Motion m{name, mean_forces(chain, start, time, 1e-11), mean_forces(chain, start, time, 1e-13),
           outermost, largest(start)};
  const Means& end = m.fine;
  const double small = 1e-9 * m.amplitude;
  for (std::size_t n = 0; n < chain.sites; ++n) {
    const double gained = chain.mass_of(n) * (end.v[n] - start.v[n]) / time;
    if (!(std::abs(gained - (end.push[n] - end.push[n + 1] - end.well[n])) < small))
      throw Failure(name + ": the mean contact forces do not balance the momentum of a bead");
    const double off = std::max(std::abs(end.y[n] - start.y[n]), std::abs(end.v[n] - start.v[n]));
    if (returns && !(off < small)) throw Failure(name + " does not return to its start");
  }
  return m;
}

/**
## Equal means in free chains (figure x16 a)

Localized motions of the free chain do not exist, so we check the identity on motions that fill a ring or a box. A ring
of eight equal beads carries a wave that moves on by one site in the time $q$; there symmetry alone makes the means
equal, so this case checks the method. On two others masses and stiffnesses deviate from one by up to 15 per cent, with
$\alpha = 3/2$ on a ring and $\alpha = 2$ between walls. The guess for the wave, again with first harmonics only, is a
circle of radius $A$ with neighbours that are $2A\sin\frac q2$ apart. */
Orbit<double> wave_on_ring(double q) {
  const Shooting<double> ring{
      {8, None{}, PowerContact{1.5}, Ends::periodic}, travelling(8, 1, true), period / q};
  const double A = std::pow(0.457 * std::pow(2 * std::sin(q / 2), 2.5), -2);
  State<double> guess(8);
  for (std::size_t n = 0; n < 8; ++n) {
    guess.y[n] = A * std::cos(q * double(n));
    guess.v[n] = A * std::sin(q * double(n));
  }
  return newton(ring, ring.reduce(guess), shortest);
}

/**
The means of all three agree within the errors, which are two billionths of the largest at most. If one bead of the
uneven ring starts a thousandth off, the ring does not return, and its means differ by almost a thousandth.

| mean force over the largest one, at contact | 1 | 2 | 4 |
|---|---|---|---|
| equal beads, ring | [1.00000](cell:mean_forces/motion=ring_wave/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, ring | [1.00000](cell:mean_forces/motion=uneven_ring/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, between walls | [1.00000](cell:mean_forces/motion=walls/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, ring, does not return | [0.999579](cell:mean_forces/motion=not_returning/n=1/relative) | [0.999243](cell:n=2/relative) | [1.00000](cell:n=4/relative) | */
std::vector<Motion> of_free_chains() {
  std::vector<Motion> all;
  const auto add = [&](const std::string& name, const Chain& chain, const State<double>& start,
                       double time, bool returns = true) {
    all.push_back(averaged(name, chain, start, time, true, returns));
  };
  // Equal beads on a ring, while the wave goes round once
  const Orbit<double> wave = wave_on_ring(3 * period / 8);
  add("ring_wave", Chain{8, None{}, PowerContact{1.5}, Ends::periodic}, wave.start,
      8 * wave.period());

  // Uneven beads and contacts, on a ring and between walls
  const auto ring = [](double part) { return uneven_chain(8, Ends::periodic, 1.5, part); };
  const auto walls = [](double part) { return uneven_chain(6, Ends::fixed, 2, part); };
  const State<double> on_ring = standing_wave(ring);
  add("uneven_ring", ring(1), on_ring, period);
  add("walls", walls(1), standing_wave(walls), period);

  // A motion that does not return
  State<double> wrong = on_ring;
  wrong.y[0] *= 1.001;
  add("not_returning", ring(1), wrong, period, false);
  return all;
}

/**
## Unequal means in wells (figure x16 b)

The article remarks that the proof fails with an on-site potential, since the means then depend on $n$ (`thm.wells`). We
take breathers: periodic motions of a few beads in wells $W = \frac12y^2$, in which neighbours oscillate out of phase
and the other beads are nearly at rest. There are two kinds, one symmetric about a bead (*site*) and one about a contact
(*bond*); section 3.2 computes them by the same method (sec32_newton_breathers.cpp). We take both at the frequency
$\omega_b = 2\pi/T = 1.5$, on free chains long enough for their tails. Here the means differ as much as they can, since
the outermost contacts carry nothing, and each bead is balanced by its well: the program stops if it does not.

| mean force over the largest one, contacts from the middle | 0 | 1 | 2 | 4 |
|---|---|---|---|---|
| bond-centred breather | [1.000](cell:mean_forces/motion=breather_bond/n=12/relative) | [0.815](cell:n=13/relative) | [0.433](cell:n=14/relative) | [0.0249](cell:n=16/relative) | */
void of_wells(std::vector<Motion>& all) {
  for (Centre centre : {Centre::bond, Centre::site}) {
    const std::string name = centre == Centre::bond ? "breather_bond" : "breather_site";
    const auto problem = breather_problem(centre, 1.5, 0, sites_of(centre, Length::spare));
    const Orbit<double> orbit = find_breather(problem);
    all.push_back(averaged(name, problem.chain, orbit.start, orbit.period(), false));
  }
}

// Panels a and b, contact by contact
void report_means(Report& report, const std::vector<Motion>& all) {
  constexpr const char* from = "difference of two tolerances, against the largest force";
  Table& table = report.table("mean_forces");
  for (const Motion& m : all) {
    const Vector<double>& push = m.fine.push;
    const long sites = m.fine.well.size(), first = m.outermost ? 0 : 1;
    const double top = push.maxCoeff(), top_coarse = m.coarse.push.maxCoeff(), none = std::nan("");
    for (long i = first; i + first <= sites; ++i)
      table.add(
          {{"motion", "name of the motion; all are periodic but not_returning", m.name},
           {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
           {"force", "mean force of the contact over a period",
            Estimate{push[i], std::abs(push[i] - m.coarse.push[i])}, "", from},
           {"over_amplitude", "mean force over the largest displacement or velocity at the start",
            compare(m.coarse.push[i] / m.amplitude, push[i] / m.amplitude), "", from},
           {"relative", "mean force divided by the largest one of this motion",
            compare(m.coarse.push[i] / top_coarse, push[i] / top), "", from},
           {"step", "mean force of this contact minus that of the next",
            i < sites ? push[i] - push[i + 1] : none},
           {"well", "mean of W' at bead n; nan where there is no bead",
            i < sites ? m.fine.well[i] : none}});
  }
}

/**
## A localized state disperses (figure x16 c, d)

We start the breather of $\omega_b = 1.5$ in the middle of a long chain, once with its wells and once without. Every
unit of time we record the energy on the nine sites around its centre, and the force of the contact beside its central
bead, averaged from the start up to $t$ (by the trapezoidal rule over all steps). Steps are event-corrected
(event_corrected.hpp), of length 0.05 and half of it, and the difference of the two runs is the error. The program stops
if the motion reaches an end of the chain or the energy drifts: such a loss could pass for dispersal. */
struct Dispersal {
  std::vector<double> t, core, mean;
};

Dispersal let_go(const State<double>& breather, const Well& well, double time, int steps_per_unit) {
  const Chain chain{401, well};
  State<double> state(401);  // the centre of the breather is bead 200, from zero
  std::copy(breather.y.begin(), breather.y.end(),
            state.y.begin() + 200 - long(breather.y.size() / 2));
  const double all = energy(chain, state), step = 1. / steps_per_unit;
  Dispersal out;
  double impulse = 0, before = 0;
  int steps = 0;
  const auto look = [&](const State<double>& now) {
    const double push = contact_push(chain, now.y.data(), 201);  // of beads 200 and 201
    if (now.t > 0) impulse += (before + push) / 2 * step;
    before = push;
    if (steps++ % steps_per_unit != 0) return;
    out.t.push_back(now.t);
    out.core.push_back(window_sum(energy_density(chain, now), 200, 4) / all);
    out.mean.push_back(now.t > 0 ? impulse / now.t : push);
  };
  const Run run = evolve(EventCorrected{step}, chain, state, time, step, look);
  if (state.v.front() != 0 || state.v.back() != 0)
    throw Failure("the ends of the chain have moved");
  if (!(run.energy_drift < 1e-8)) throw Failure("the energy drifts");
  return out;
}

/**
If a contact transmits a finite total impulse, its mean force goes to zero like $1/t$ and halves over the second half of
the time. Without wells it nearly does; in wells it stays nearly constant.

| | without wells | in wells |
|---|---|---|
| energy on nine sites at $t = 200$ | [0.00163](cell:dispersal/chain=free/t=200/core) | [0.99998](cell:chain=wells/core) |
| mean force up to $t = 100$ | [0.00929](cell:dispersal/chain=free/t=100/mean) | [0.143](cell:chain=wells/mean) |
| mean force up to $t = 200$ | [0.00488](cell:dispersal/chain=free/t=200/mean) | [0.144](cell:chain=wells/mean) | */
void report_dispersal(Report& report) {
  // Without and with wells, each with two steps
  const auto breather = find_breather(breather_problem(Centre::site, 1.5, 0, 23)).start;
  const double time = report.quick ? 60 : 200;
  std::array<Dispersal, 4> runs;
  parallel_for(4, [&](std::size_t k) {
    runs[k] = let_go(breather, k < 2 ? Well{None{}} : Well{Harmonic{}}, time, k % 2 ? 40 : 20);
  });

  // Panels c and d, instant by instant
  Table& table = report.table("dispersal");
  for (std::size_t c : {0, 1}) {
    const Dispersal &coarse = runs[2 * c], &fine = runs[2 * c + 1];
    const std::string name = c == 0 ? "free" : "wells";
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"chain", "chain without wells (free) or with them (wells)", name},
                 {"t", "time", fine.t[i]},
                 {"core", "fraction of the energy on nine sites",
                  Estimate{fine.core[i], std::abs(fine.core[i] - coarse.core[i])}, "",
                  "difference of two resolutions, against the largest fraction"},
                 {"mean", "force of a central contact, averaged from 0 to t",
                  Estimate{fine.mean[i], std::abs(fine.mean[i] - coarse.mean[i])}, "",
                  "difference of two resolutions, against the largest mean"}});
  }
}

/**
## No localized state returns

A periodic motion returns to its start. So we start localized motions in a free chain and ask how near they come to
their starts again: one bead that is displaced, one that is kicked, two neighbours pushed together, and the breather.
Each starts once among equal beads with $\alpha = \frac32$ and once in the uneven chain with $\alpha = 2$. The distance
is the largest change of a displacement or velocity. A motion first goes away; we divide the distance by the largest one
until then, and take the least such ratio, at 168 instants in each of 24 periods of the breather. It is one for a motion
that only goes away and zero for a periodic one, unless its period is longer than that.

The theorem leaves states of rest in which no contact overlaps. So a sequence of displacements that increases, with
random steps, must stay, and must not if one step is reversed.

| least distance over the largest one before | equal beads | uneven beads |
|---|---|---|
| displaced bead | [0.512](cell:returns/start=displaced/chain=equal/back) | [0.630](cell:chain=uneven/back) |
| kicked bead | [0.97](cell:returns/start=kicked/chain=equal/back) | [0.902](cell:chain=uneven/back) |
| pair pushed together | [0.698](cell:returns/start=pair/chain=equal/back) | [0.755](cell:chain=uneven/back) |
| breather | [0.67](cell:returns/start=breather/chain=equal/back) | [0.659](cell:chain=uneven/back) |
| one step down | [0.997](cell:returns/start=step_down/chain=equal/back) | [0.978](cell:chain=uneven/back) |

The increasing sequence does not move at all, and in wells the breather returns to its start. */
constexpr std::size_t middle = 100;  // of 201 beads

State<double> localized(const std::string& name, const State<double>& breather) {
  State<double> state(201);
  const std::vector<double> random = shaken(std::vector<double>(20, 0.05), 0.8, 13);
  if (name == "displaced") state.y[middle] = 1;
  if (name == "kicked") state.v[middle] = 1;
  if (name == "pair") state.y[middle] = 0.5, state.y[middle + 1] = -0.5;
  if (name == "breather")
    std::copy(breather.y.begin(), breather.y.end(),
              state.y.begin() + long(middle - breather.y.size() / 2));
  // Twenty steps upwards, between two ends at rest
  if (name == "increasing" || name == "step_down")
    for (std::size_t n = middle; n < 201; ++n)
      state.y[n] = state.y[n - 1] + (n < middle + 20 ? random[n - middle] : 0);
  if (name == "step_down")
    for (std::size_t n = middle + 10; n < 201; ++n) state.y[n] -= 2 * random[10];
  return state;
}

// How a motion comes back, looked at after every step
struct Return {
  double away = 0, back = std::nan("");  // the largest distance, and the least ratio
};

Return closest_return(const Chain& chain, const State<double>& start, double step, double time) {
  Return out;
  const auto look = [&](const State<double>& now) {
    double apart = 0;
    for (std::size_t n = 0; n < chain.sites; ++n)
      apart = std::max({apart, std::abs(now.y[n] - start.y[n]), std::abs(now.v[n] - start.v[n])});
    out.away = std::max(out.away, apart);
    if (out.away > 1e-3 && !(apart / out.away > out.back)) out.back = apart / out.away;
  };
  State<double> state = start;
  const Run run = evolve(EventCorrected{step}, chain, state, time, step, look);
  if (state.v.front() != 0 || state.v.back() != 0)
    throw Failure("the ends of the chain have moved");
  if (energy(chain, start) > 0 && !(run.energy_drift < 1e-8)) throw Failure("the energy drifts");
  return out;
}

// The breather in wells is the control
void report_returns(Report& report) {
  const auto breather = find_breather(breather_problem(Centre::site, 1.5, 0, 23)).start;
  struct Case {
    const char *start, *chain;
  };
  std::vector<Case> cases{{"breather", "wells"}};
  for (const char* chain : {"equal", "uneven"})
    for (const char* start : {"displaced", "kicked", "pair", "breather", "increasing", "step_down"})
      cases.push_back({start, chain});
  const auto row = [&](const Case& one) {
    const std::string name = one.chain;
    const Chain chain = name == "wells" ? Chain{201, Harmonic{}}
                                        : uneven_chain(201, Ends::free, 2, name == "uneven");
    const State<double> start = localized(one.start, breather);
    const double step = period / 1.5 / 168, time = (report.quick ? 5 : 24) * 168 * step;
    const Return coarse = closest_return(chain, start, step, time),
                 fine = closest_return(chain, start, step / 2, time);
    return Row{
        {"start", "motion at the start", one.start},
        {"chain", "free chain of equal or uneven beads, or chain with wells", name},
        {"away", "largest distance from the start", compare(coarse.away, fine.away)},
        {"back", "least distance from the start over the largest one before; nan if it stays",
         compare(coarse.back, fine.back), "",
         "difference of two steps, against the largest ratio; nan if it stays"}};
  };
  report.table("returns").fill(cases, row, "starts");
}

/**
## Differences and limits

The article gives a proof and no computation, so every parameter here is ours. Without wells contacts in the core still
close now and then, ever more weakly, so we watch the decay of the mean. */
void reproduce(Report& report) {
  std::vector<Motion> means = of_free_chains();
  of_wells(means);
  report_dispersal(report);
  report_returns(report);
  report_means(report, means);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `thm.mean_force`: period-averaged contact force is the same at every bond and zero for a localized periodic motion |  | mean_forces.force (motion = ring_wave, n = 5): 9.412e-12 < 1e-08 (the closest of 27) | holds |
| `thm.equilibria`: all time-periodic solutions that are localized to the right are independent of t and increasing with n (in the proof x_n >= x_(n-1)) |  | returns.back (start = displaced, chain = equal): 0.1 < 0.5121 (the closest of 12) | holds |
| `thm.wells`: with an on-site potential the average interaction forces are no more independent of n |  | mean_forces.force (motion = breather_site, n = 13), (motion = breather_site, n = 14): 0.0958 < 0.1449 (the closest of 10) | holds |
<!-- /statements -->

## Try it

**To change it.** Another chain without wells is a function like `uneven_chain`, one more `add` in `of_free_chains`, and
its name in the script; another state is the first argument of `let_go`.

1. *Easy.* What becomes of an impact when there are no wells?
   `build/bin/sec34_impact run --well none --velocity 1 --time 200` gives `packet_energy_fraction` = 0.99366. Hint:
   nearly all energy leaves in one solitary wave; it is localized but not periodic.
2. *Harder.* Shallow wells at a fixed period are unit wells at a high frequency. How large is a breather then?
   `build/bin/sec32_newton_breathers breather --omega 2` gives `amplitude` = 2.45676. Hint: substitute
   $y(t) = k^2\,Y(k^{1/2}t)$ in the equation with wells of stiffness $k$. What does the theorem say of $k \to 0$? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without wells (section 2)", reproduce}, argc,
             argv);
}
