/**
# 2 No breathers without wells

Section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) proves that beads which only repel each
other have no breathers: no motion of theirs is both periodic in time and localized in space. The proof is one integral. Bead $n$
obeys $m_n\ddot x_n = F_{n-1} - F_n$ with the pushes $F_n \ge 0$ of contact $n$ on the bead to its right, and over a period
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_{n-1}\,dt - \int_0^T F_n\,dt :$$
the mean push from its left equals that from its right (`thm.mean_force`):

        . o --> o --> o --> o --> o .      mean force: the same at every contact,
              F     F     F     F          zero far away, hence zero everywhere

A push that is never negative and zero in the mean is zero always: nothing moves. No computation proves a
theorem, but ours could have refuted it, by an orbit with unequal means, a search that ends in a breather,
or a localized state that stays together. Each instrument is also tried where it must find something.

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); how searches from
small and large starts end (c); energy and mean force of a localized state (d, e).](fig:x16) */
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/integrators/contact_rkn.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"
#include "sec2/fixed_leapfrog.hpp"
#include "sec2/mean_force.hpp"
#include "sec2/periodic_motions.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3). Each bead has its own mass, each contact its stiffness and exponent,
$$m_n\ddot x_n = V_n'(x_{n+1}-x_n) - V_{n-1}'(x_n-x_{n-1}),\qquad
  V_n(x) = \frac{\gamma_n}{\alpha_n+1}\,(-x)_+^{\alpha_n+1}.$$
We compare it with the chain of section 3, in which linear *wells*, springs of their own, tie the beads to
their places. All quantities are dimensionless.

| article | program | meaning |
|---|---|---|
| $m_n$, $\gamma_n$ | `mass`, `eta` | masses and stiffnesses of the contacts |
| $\alpha_n$ | `exponent` | exponent of the contact force |
| $\bar F_n$ | `MeanForces::contact` | mean push on bead $n$ from its left (up to the sign) |
| $T$ | `period()` | period of the motion |

The claim is decided by a list of conditions on numbers, to which each part of this chapter adds its own.
Each condition is explained where it is made, and its margin is among the facts. Means are integrated at two
tolerances. */
constexpr std::array tolerances{1e-11, 1e-13};

/**
## The identity (figure x16)

On a localized motion of the free chain all means would be zero, but no such motion exists. So we check
the identity on motions that fill a ring or a box (sec2/periodic_motions.hpp). They are found by *shooting*: the chain is run from a
guess, and Newton's method corrects the guess until the run comes back to where it began; shooting.hpp has the
equations, and section 3.2 (`sec32_newton_breathers`) explains the method where it is needed most. We follow each once more over
a whole period, and integrate the means along with it at two tolerances, whose difference is the error. We
judge by two numbers: the spread of the mean force over the contacts, relative to the largest, and the
amount by which the balance of a bead, with the force of its well, is missed. */
struct Balance {
  double largest = 0, spread = 0, imbalance = 0;
};

struct MeanTable {
  Table table{};

  /// Both balances, and the rows of the table. Without walls or a ring the outermost contacts do not exist.
  template <class AnyChain>
  std::array<Balance, 2> add(const std::string& motion, const AnyChain& chain,
                             const State<double>& start, double period, bool ends_push);
};

/**
The figure needs the mean of every contact, not only the spread. The rows quote the finer integration. */
template <class AnyChain>
std::array<Balance, 2> MeanTable::add(const std::string& motion, const AnyChain& chain,
                                      const State<double>& start, double period, bool ends_push) {
  const auto coarse = mean_forces(chain, start, period, tolerances[0]);
  const auto fine = mean_forces(chain, start, period, tolerances[1]);
  const std::size_t sites = chain.sites, first = ends_push ? 0 : 1;
  const double top = *std::max_element(fine.contact.begin(), fine.contact.end());
  for (std::size_t i = first; i + first <= sites; ++i) {
    const bool bead = i < sites;
    const double here = fine.contact[i], none = std::nan("");
    table.add({{"motion", "which periodic motion", motion},
               {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
               {"force", "mean force of the contact over a period",
                Estimate{here, std::abs(here - coarse.contact[i])}, "",
                "difference of two tolerances, against the largest force"},
               {"relative", "mean force over the largest one of the motion", here / top},
               {"step", "mean force of this contact minus that of the next",
                bead ? here - fine.contact[i + 1] : none},
               {"well", "mean force of the well on bead n, nan where there is no bead",
                bead ? fine.well[i] : none}});
  }
  const auto of = [&](const MeanForces& m) {
    const double most = *std::max_element(m.contact.begin(), m.contact.end());
    return Balance{most, m.spread(first, sites - first) / most, m.imbalance() / most};
  };
  return {of(coarse), of(fine)};
}

/**
A constant mean force would mean nothing if it were zero, so that of a free chain must exceed a thousandth
of the amplitude. Its spread must stay below a hundred-millionth, errors included: orbits in double
precision, followed at a tolerance of a hundred-billionth, leave less, and a start that is wrong by a
thousandth leaves far more. */
constexpr double same = 1e-8;

template <class AnyChain>
Criterion equal_means(MeanTable& means, const std::string& name, const AnyChain& chain,
                      const State<double>& start, double period) {
  const auto [coarse, fine] = means.add(name, chain, start, period, true);
  const double size = largest(start);
  return {below("spread_" + name, compare(coarse.spread, fine.spread), same),
          above("force_" + name, compare(coarse.largest / size, fine.largest / size), 1e-3)};
}

/**
We need chains on which only the theorem makes the means equal. On the ring of equal beads symmetry alone
does, so this case only checks the instrument. Masses and stiffnesses then differ from bead to bead, with
$\alpha = 3/2$ on a ring and $\alpha = 2$ between walls, and in the last chain every contact has an exponent
of its own. The last condition is for a motion that must fail: the uneven ring from a start that is wrong
by a thousandth at one bead, so that it does not return. */
Criterion of_free_chains(MeanTable& means) {
  // Equal beads on a ring: symmetry alone makes the means equal
  Shooting<double> ring{{8, None{}, PowerContact{1.5}, Ends::periodic}, {}, 1}, uneven_ring = ring;
  const Orbit<double> wave = motions::ring_wave(ring);
  Criterion all = equal_means(means, "ring_wave", ring.chain, wave.start, 8 * wave.period());

  // Uneven beads and contacts, on a ring, between walls, and with mixed exponents: only the theorem does
  const Orbit<double> standing = motions::standing_wave(uneven_ring, 1.5);
  Shooting<double> walls{{6, None{}, PowerContact{1.5}, Ends::fixed}, {}, 1};
  const Orbit<double> between = motions::standing_wave(walls, 2);
  append(all,
         equal_means(means, "uneven_ring", uneven_ring.chain, standing.start, standing.period()));
  append(all, equal_means(means, "walls", walls.chain, between.start, between.period()));
  append(all, equal_means(means, "mixed_exponents", motions::mixed_chain(1).chain,
                          motions::mixed_wave(), 2 * std::numbers::pi));

  // A motion that does not return must be told apart
  State<double> wrong = standing.start;
  wrong.y[0] *= 1.001;
  MeanTable aside;
  const auto [coarse, fine] = aside.add("", uneven_ring.chain, wrong, standing.period(), true);
  all.push_back(above("spread_not_periodic", compare(coarse.spread, fine.spread), 1e3 * same));
  return all;
}

/**
The contrast comes from breathers: periodic motions of a few beads in wells of unit stiffness, which section 3.2
computes. We take both kinds, around a site and around a bond, at $\omega_b = 1.5$, on chains long enough for their
tails. There the spread must be of order one, and each bead must be balanced by its well. */
Criterion of_wells(MeanTable& means) {
  Criterion all;
  for (Centre centre : {Centre::bond, Centre::site}) {
    const std::string name = centre == Centre::bond ? "breather_bond" : "breather_site";
    const auto problem = breather_problem(centre, 1.5, 0, sites_of(centre, Length::spare));
    const Orbit<double> orbit = find_breather(problem);
    const auto [coarse, fine] = means.add(name, problem.chain, orbit.start, orbit.period(), false);
    all.push_back(above("spread_" + name, compare(coarse.spread, fine.spread), 0.5));
    all.push_back(below("imbalance_" + name, compare(coarse.imbalance, fine.imbalance), same));
  }
  return all;
}

/**
## Searches

Next we look for breathers of the free open chain by brute force. Three beads in the middle get random
positions, and in half of the searches random velocities too; a damped Newton method then looks for a motion
with the period of a breather, $\omega_b = 1.2$. Finding nothing means something only if the same search
finds what does exist, so each series of searches, a *hunt*, has its control. Small starts, of the size of a
breather, are also tried in wells of unit stiffness. Large starts have the size of motions of this frequency
without wells: about $0.3$ when neighbours swing against each other. Such motions of a few beads exist
between walls, and there the same search looks for them with three beads. */
struct Hunt {
  std::string name;
  std::size_t sites;
  Ends ends;
  bool wells;
  double least, most;  ///< size of the starts
};
const std::array<Hunt, 4> hunts{{{"free", 15, Ends::free, false, 0.02, 0.08},
                                 {"wells", 15, Ends::free, true, 0.02, 0.08},
                                 {"free_large", 15, Ends::free, false, 0.3, 2},
                                 {"walls", 3, Ends::fixed, false, 0.3, 2}}};

/**
A search should be cheap, so it moves the chain by leapfrog steps (fixed_leapfrog.hpp), for which the theorem
holds as well. The hunt and the seed alone fix the search and its start. Odd seeds begin at rest. */
using Search = LeapfrogShooting;

std::pair<Search, State<double>> draw(const Hunt& hunt, unsigned long seed, int steps) {
  const std::size_t sites = hunt.sites, middle = sites / 2;
  const bool at_rest = seed % 2 == 1;
  Search search;
  search.chain = {sites, hunt.wells ? Well{Harmonic{}} : Well{None{}}, Hertz{.floor = 0},
                  hunt.ends};
  search.omega = 1.2;
  search.steps = steps;
  search.symmetry = at_rest ? even_in_time(sites) : travelling(sites, 0, false);
  Random random(seed);
  const double size = std::exp(random.uniform(std::log(hunt.least), std::log(hunt.most)));
  State<double> start(sites);
  for (std::size_t n = middle - 1; n <= middle + 1; ++n) {
    start.y[n] = size * random.uniform(-1, 1);
    if (!at_rest) start.v[n] = size * random.uniform(-1, 1);
  }
  search.scale = largest(start);
  return {search, start};
}

/**
To count the outcomes we need a complete list of them. A search can converge to a state of rest, with
displacements that increase with $n$ up to rounding; to a localized motion, whose end beads carry less than
a millionth of the energy; to a motion that is not localized; or to a doubtful case, which somebody would
have to look at. Or it does not converge. On the free chain the theorem allows only the first and the last
of these. One count in any of the other three would refute it. */
enum class End { rest, localized, extended, doubtful, failed };
constexpr std::array end_names{"rest", "localized", "extended", "doubtful", "failed"};

End classify(const Search& search, const State<double>& start) {
  State<double> z = start;
  double swing = 0, overlap = 0;
  search.fly(z, nullptr, search.steps, [&](const State<double>& now) {
    for (std::size_t n = 0; n < now.y.size(); ++n) {
      swing = std::max(swing, std::abs(now.y[n] - start.y[n]) / search.scale);
      if (n > 0) overlap = std::max(overlap, (now.y[n - 1] - now.y[n]) / search.scale);
    }
  });
  if (swing < 1e-6 && overlap < 1e-6) return End::rest;
  if (!(swing > 1e-2)) return End::doubtful;
  const auto e = energy_density(search.chain, start);
  const double all = energy(search.chain, start);
  return std::max(e.front(), e.back()) < 1e-6 * all ? End::localized : End::extended;
}

/**
The leapfrog chain is not the chain itself, so every motion that was found must survive the exact flow: the
library's Newton method starts from it, may move it by no more than a tenth of its size, and must end
in an orbit of the same kind. */
struct Nearby : Shooting<double> {
  using Base = Shooting<double>;
  Vector<double> from;

  Shot<double> shoot(const Vector<double>& x, const EventTolerance<double>& rule,
                     bool jacobian = true) const {
    if (sup<double>(x - from) < 0.1 * sup(from)) return Base::shoot(x, rule, jacobian);
    throw NewtonFailed("Newton's method leaves the neighbourhood", {});
  }
};

bool confirmed(const Search& search, const Vector<double>& x, End end) try {
  const Nearby nearby{search, x};
  NewtonRule<double> rule;
  if (search.symmetry.parts == 1) rule.rank = 1e-9;  // such orbits may be shifted in time
  return classify(search, nearby.expand(solve(nearby, x, rule).x)) == end;
} catch (const NewtonFailed&) {
  return false;
}

/**
A motion that fails this test is not dismissed: it is counted as doubtful. */
End run_search(const Hunt& hunt, unsigned long seed, int steps) {
  const auto [search, start] = draw(hunt, seed, steps);
  NewtonRule<double> rule = motions::free_rule();
  rule.most = 200;
  try {
    const Vector<double> x = solve(search, search.reduce(start), rule).x;
    const End end = classify(search, search.expand(x));
    const bool moves = end == End::localized || end == End::extended;
    return moves && !confirmed(search, x, end) ? End::doubtful : end;
  } catch (const NewtonFailed&) {
    return End::failed;
  }
}

/**
The counts of a hunt depend on the length of the step and on the sample. Their error is the difference
between two steps plus the statistical error: another hundred seeds would give other counts. */
struct Counts {
  std::array<std::array<double, end_names.size()>, 2> of{};
  double all = 0;

  Estimate sum(const std::vector<End>& ends) const {
    std::array<double, 2> n{};
    for (End end : ends)
      for (std::size_t k : {0, 1}) n[k] += of[k][std::size_t(end)];
    const double error = std::abs(n[1] - n[0]) + std::sqrt(n[1] * (all - n[1]) / all);
    return error > 0 ? Estimate{n[1], error} : exact(n[1]);
  }
};

/**
The searches are independent and run side by side. Each kind of end is counted at both steps. */
Counts search_all(const Hunt& hunt, unsigned long seeds) {
  std::vector<End> ends(2 * seeds);
  parallel_for("searches, " + hunt.name, ends.size(), [&](std::size_t i) {
    const unsigned long seed = i / 2 + 1;
    const int steps = i % 2 == 0 ? 128 : 256;
    ends[i] = run_search(hunt, seed, steps);
  });
  Counts counts{{}, double(seeds)};
  for (std::size_t i = 0; i < ends.size(); ++i) counts.of[i % 2][std::size_t(ends[i])] += 1;
  return counts;
}

/**
In the free chain nothing may move, and more than half of the searches must come to rest, or they would
prove too little. Of the controls more than one in twenty must find a confirmed breather in wells, or a
motion between walls, or the search is blind. */
Criterion found_in(const Hunt& hunt, const Counts& counts) {
  const Estimate moving = counts.sum({End::localized, End::extended, End::doubtful});
  const Estimate rest = counts.sum({End::rest});
  if (hunt.wells) return {above("localized_wells", counts.sum({End::localized}), counts.all / 20)};
  if (hunt.ends == Ends::fixed)
    return {above("moving_walls", counts.sum({End::localized, End::extended}), counts.all / 20)};
  return {below("moving_" + hunt.name, moving, 1),
          above("rest_" + hunt.name, rest, counts.all / 2)};
}

/**
The figure compares all hunts, so the table has a column for each hunt and step. */
Criterion of_searches(Report& report) {
  const unsigned long seeds = report.quick ? 40 : 100;
  report.output.note("seed", "searches 1 to " + std::to_string(seeds) + ", unevenness 11 to 14");
  report.facts.add("searches", exact(double(seeds)), "searches");

  // Every hunt fills two columns, and adds what it must and must not have found
  Table& table = report.table("searches", label("ends_in", "how a search ends"));
  for (const char* name : end_names) table.add({name});
  Criterion all;
  for (const Hunt& hunt : hunts) {
    const Counts counts = search_all(hunt, seeds);
    table.columns.push_back(count(hunt.name, "searches with 128 steps a period"));
    table.columns.push_back(count(hunt.name + "_fine", "searches with 256 steps a period"));
    for (std::size_t k : {0, 1})
      for (std::size_t i = 0; i < end_names.size(); ++i)
        table.rows[i].push_back(std::int64_t(counts.of[k][i]));
    append(all, found_in(hunt, counts));
  }
  return all;
}

/**
## A localized state disperses (figure x16)

A third way to find a breather is to start from one. We put the breather at $\omega_b = 1.5$ into a long
chain, once with its wells and once without, and watch two quantities: the energy on the nine sites around
its centre, and the push of the contact beside its central bead, averaged from the start up to $t$. Two
runs with different steps and samples agree to the errors in the table. */
struct Course {
  std::vector<double> t, core, mean;
  std::int64_t woken = 0;  ///< sites that are not exactly at rest when the run ends
  Run run{};
};

/// The chain at rest with a breather of the wells in its middle, site 200.
State<double> breather_in_long_chain() {
  const Orbit<double> orbit = find_breather(breather_problem(Centre::site, 1.5, 0, 23));
  State<double> state(401);
  std::copy(orbit.start.y.begin(), orbit.start.y.end(), state.y.begin() + 200 - 11);
  return state;
}

/**
The mean push is an integral over samples. They follow the steps, so that both become denser together. */
Course course(const Well& well, double time, int halvings) {
  const Chain chain{401, well};
  State<double> state = breather_in_long_chain();
  const double all = energy(chain, state);
  const TimeGrid p = denser_samples(time_grid(time, 0.05, 0.05), halvings);
  Course out;
  double impulse = 0, before = 0;
  std::size_t k = 0;
  out.run = evolve(ContactAware{p.step()}, chain, state, p, [&](const State<double>& now) {
    const double push = contact_push(chain, now.y.data(), 201);
    if (k > 0) impulse += (before + push) / 2 * p.interval();
    before = push;
    if (k++ % (std::size_t(20) << halvings) != 0) return;
    out.t.push_back(now.t);
    out.core.push_back(window_sum(energy_density(chain, now), 200, 4) / all);
    out.mean.push_back(now.t > 0 ? impulse / now.t : push);
  });
  out.woken = std::count_if(state.v.begin(), state.v.end(), [](double v) { return v != 0; });
  return out;
}

/**
We call a free state dispersed if its core keeps less than a tenth of the energy and its mean force goes
to zero like $1/t$, as it does when the contact transmits a finite impulse in all: over the second half of
the time the mean must fall to one half, within a tenth. In wells the core must keep more than 99 per cent
and the mean force its value. Some beads must still be at rest, or the ends of the chain would matter. */
Estimate deviation(const Course& coarse, const Course& fine, double expected) {
  const auto late = [&](const Course& course) {
    return course.mean.back() / course.mean[course.mean.size() / 2] - expected;
  };
  const Estimate e = compare(late(coarse), late(fine));
  return {std::abs(e.value), e.error};
}

Criterion disperses(const Course& coarse, const Course& fine) {
  return {below("core_free", compare(coarse.core.back(), fine.core.back()), 0.1),
          below("late_mean_free", deviation(coarse, fine, 0.5), 0.1),
          below("woken_free", compare(coarse.woken, fine.woken), 401)};
}
Criterion persists(const Course& coarse, const Course& fine) {
  return {above("core_wells", compare(coarse.core.back(), fine.core.back()), 0.99),
          below("late_mean_wells", deviation(coarse, fine, 1), 0.1)};
}

/**
A loss of energy by the integrator could pass for dispersal, so every run is listed with its drift. */
Criterion of_dispersal(Report& report) {
  // Without and with wells, each at two resolutions
  const double time = report.quick ? 60 : 200;
  std::array<Course, 4> runs;
  parallel_for(4, [&](std::size_t k) {
    const int halvings = int(k % 2);
    runs[k] = course(k < 2 ? Well{None{}} : Well{Harmonic{}}, time, halvings);
  });

  // What the figure shows, instant by instant
  Table& table = report.table("dispersal");
  for (std::size_t c : {0, 1}) {
    const Course &coarse = runs[2 * c], &fine = runs[2 * c + 1];
    const std::string name = c == 0 ? "free" : "wells";
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"chain", "free or wells", name},
                 {"t", "time", fine.t[i]},
                 {"core", "share of the energy on nine sites",
                  Estimate{fine.core[i], std::abs(fine.core[i] - coarse.core[i])}, "",
                  "difference of two resolutions, against the largest share"},
                 {"mean", "push of a central contact, averaged from 0 to t",
                  Estimate{fine.mean[i], std::abs(fine.mean[i] - coarse.mean[i])}, "",
                  "difference of two resolutions, against the largest mean"}});
    report.facts.add("mean_" + name, compare(coarse.mean.back(), fine.mean.back()));
    report.facts.add("drift_" + name, compare(coarse.run.energy_drift, fine.run.energy_drift));
  }

  // One must disperse, the other persist
  Criterion all = disperses(runs[0], runs[1]);
  append(all, persists(runs[2], runs[3]));
  return all;
}

/**
## Results

The mean forces of the uneven ring agree to [4e-12](num:sec2_nonexistence.mean_force_spread_uneven_ring) of
the largest; those of a motion that misses its start by a thousandth agree only to
[0.000756758](num:sec2_nonexistence.mean_force_spread_not_periodic). Of
[100](num:sec2_nonexistence.searches) small starts in the free chain
[100](num:sec2_nonexistence.mean_force_rest_free) end at rest and
[0](num:sec2_nonexistence.mean_force_moving_free) in a motion; in wells
[2e1](num:sec2_nonexistence.mean_force_localized_wells) end in a breather. Of as many large ones
[99](num:sec2_nonexistence.mean_force_rest_free_large) end at rest and
[0](num:sec2_nonexistence.mean_force_moving_free_large) in a motion, while between walls
[29](num:sec2_nonexistence.mean_force_moving_walls) find one. Without wells
[0.00162601](num:sec2_nonexistence.mean_force_core_free) of the energy stays in the core, with them
[0.999982](num:sec2_nonexistence.mean_force_core_wells). */
void reproduce(Report& report) {
  MeanTable means;
  Criterion all = of_free_chains(means);
  append(all, of_wells(means));
  append(all, of_searches(report));
  append(all, of_dispersal(report));
  judge(report, "thm.mean_force", all);
  report.output.add("mean_forces", std::move(means.table));
}

/**
## Differences and limits

The article proves and does not compute, so every parameter here is ours. The frequency of the searches,
$\omega_b = 1.2$, was chosen so that those in wells succeed. Some of these end in doubt, more of them at
the longer step: the energy barrier between a site and a bond is so low at this frequency that the
leapfrog chain has breathers centred in between, near which Newton's method finds none of the exact flow.
Between walls it is tried with three beads only; it may be a weak instrument for motions of many, but a
breather has few. Without wells contacts in the core still close now and then, ever more faintly, so we
judge the fall of the mean and do not wait for silence. Where each contact has its own exponent both the
search and the check use GSL's integrator, and only the identity is tested.

## Extensions

- Which periodic motions does the free chain have between walls, and which of them are stable?
- With attracting contacts (cohesion) the argument fails. How little attraction makes a breather?
- What is the mean force in a compressed ring, as a function of the energy? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without wells (section 2)", reproduce}, argc,
             argv);
}
