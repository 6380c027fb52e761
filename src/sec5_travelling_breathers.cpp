/**
# 5 Exact travelling breathers

Struck chains send out breathers that travel. Those of section 3.4 of James, Kevrekidis and Cuevas
(Physica D 251, 2013) shed a tail as they go, ever more weakly. Section 5 leaves open whether one can
compute exact ones, which after a time $T$ are the same again, one site further:

      t = 0    .  .  o  O  o  .  .  .            y_n(t + T) = y_(n-1)(t)
      t = T    .  .  .  o  O  o  .  .            and nothing is left behind

One can. In the linear well those that repeat themselves from site to site have isolated speeds, and one sum
says which.

![Exact travelling breathers, and a packet that sheds a tail.](fig:x18) */

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "lattice/stepping/reference.hpp"
#include "report/program.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

/**
## The question

The article generates travelling breathers by striking a chain and waiting, and calls the computation
of exact ones by Newton's method an interesting open problem. It prints no number for them, so this
chapter has no claims to answer. Two more chapters follow the exact orbits into other wells and compare
them with packets; the last one sorts what is proved, computed and conjectured.

## Model

The wells are linear, later those of Eq. (10), and the contacts those of Eq. (9),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
All is dimensionless. In the program the *shift time* $T$ is `shift_time`, so that the speed is $1/T$
sites per unit of time; `sign` is that of the velocity $\dot y_0(0)$ of the central bead; and `reach` is
$L$, where an orbit has the sites $-L \le n \le L+1$. */
constexpr double two_pi = 2 * std::numbers::pi;

/**
## Why only certain speeds

In linear wells the contact forces cancel in the sum $Z = \sum_n (y_n + i\dot y_n)$, which therefore
only rotates, $Z(t) = e^{-it}Z(0)$. A shift does not change $Z$, so $(e^{-iT}-1)Z = 0$: either
$T = 2\pi k$, one site during $k$ oscillations of a free bead (type I), or $Z = 0$ (type II).

The same sum says what a packet leaves behind. A bead that has been passed keeps oscillating with the
amplitude $|\int e^{it}(f_{n-1}-f_n)\,dt|$, where $f_n$ is the force in the contact on its right. If
these pulses repeat themselves after $T$ from contact to contact, the amplitude is
$$|1-e^{-iT}|\,|g(1)|,\qquad g(1) = \int e^{it}f_0(t)\,dt.$$
It vanishes in just these two cases, because the pulse that has passed a contact is all that has
changed the sum over the beads beyond it, and so $|g(1)| = |Z|$.

This chapter finds orbits of type I, starting from a packet cut out of an impact (travelling.hpp).
Each is computed in double precision and again in a wider type, which gives its errors. */
constexpr std::array signs{1, -1};

struct Exact {
  std::size_t k;
  int sign;
  Orbit<double> orbit;
  Orbit<long double> wide;

  Estimate energy() const { return compare(orbit.energy, double(wide.energy)); }
  double shift_time() const { return two_pi * double(k); }
};

/**
In the wider type the shift time must be $2\pi k$ with all its digits. The derivative for Newton's
method may come from the orbit in double precision. */
Exact confirmed(std::size_t k, int sign, const Orbit<double>& orbit) {
  NewtonRule<long double> rule;
  rule.events.tolerance /= 2;
  return {k, sign, orbit,
          polish(type_one<long double>(k, orbit.start.y.size() / 2 - 1), orbit, rule)};
}

/// The orbits of type I with the given k, in ascending order, of one sign.
std::vector<Exact> type_one_orbits(int sign, const std::vector<std::size_t>& ks) {
  std::vector<Exact> found;
  Staircase down(sign), up = down;
  for (auto k = ks.rbegin(); k != ks.rend(); ++k)
    if (*k <= Staircase::first) found.push_back(confirmed(*k, sign, down.reach(*k)));
  std::reverse(found.begin(), found.end());
  for (std::size_t k : ks)
    if (k > Staircase::first) found.push_back(confirmed(k, sign, up.reach(k)));
  return found;
}

/**
## How exact they are

How well do these orbits satisfy the equations? Newton's method solves all but one of them; that one
follows from the sum $Z$ and serves as a check. We distinguish three residuals: that of the orbit in
double precision, that of the wider type's orbit rounded to double, as it can be printed, and that of
the latter before rounding. The first two are evaluated in the wider type and for all equations. A
residual is rounding only, so its error is as large as itself. */
template <class T>
double residual_in_wide(const Exact& e, const Vector<T>& x_given) {
  const auto problem = with_free_time(type_one<long double>(e.k));
  const Vector<long double> x = with_time<long double>(x_given.template cast<long double>(),
                                                       2 * pi<long double>() * (long double)(e.k));
  return double(sup<long double>(problem.shoot(x, {}, false).miss)) / e.orbit.amplitude;
}

/**
The energies deserve as much care as the residuals. The orbits of the two signs are the same packet
with two internal phases, and the difference of their energies is all that could hold the phase. */
void report_exactness(Report& report, const std::vector<Exact>& plus,
                      const std::vector<Exact>& minus) {
  double narrow = 0, rounded = 0, wide = 0;
  for (const auto* orbits : {&plus, &minus})
    for (const Exact& e : *orbits) {
      if (e.k > 3) continue;
      narrow = std::max(narrow, residual_in_wide(e, e.orbit.x));
      rounded = std::max(rounded, residual_in_wide<double>(e, e.wide.x.cast<double>()));
      wide = std::max(wide, e.wide.residual());
    }
  Quantities& facts = report.facts;
  facts.add("residual_double", {narrow, narrow}, "largest of k = 1, 2, 3, relative to amplitude");
  facts.add("residual_rounded", {rounded, rounded}, "of the wider type's orbit rounded to double");
  facts.add("residual_wide", {wide, wide}, "largest of k = 1, 2, 3, relative to amplitude");
  facts.add("newton_steps_from_cut", exact(double(Staircase(1).orbit().iterations())));
  const Exact &p = plus.front(), &m = minus.front();
  facts.add("energy_plus", p.energy());
  facts.add("energy_minus", m.energy());
  facts.add("energy_difference",
            compare(m.orbit.energy - p.orbit.energy, double(m.wide.energy - p.wide.energy)));
}

/**
## Profiles, ends and maps (figure x18)

An orbit is computed on a few sites, so we must show that its tails fit on them. At $t = 0$ positions
are odd and velocities even, so both tails are mirror images. Going outwards, the force on each bead
is the power 3/2 of its neighbour's displacement, so the orbit falls off double-exponentially. Two
lengths of the chain show whether the end matters. */
double log_size(const State<double>& z, std::size_t i, double amplitude) {
  return std::log10(std::max(std::abs(z.y[i]), std::abs(z.v[i])) / amplitude);
}

/// The orbit again on a longer chain, from a guess that is disturbed so that Newton's method takes the
/// steps that the new sites of the tail need.
Orbit<double> lengthened(const Exact& e, std::size_t reach) {
  Vector<double> x = Vector<double>::Zero(2 * Eigen::Index(reach) + 1);
  const auto old = Eigen::Index(usual_reach);
  x.head(old) = 1.01 * e.orbit.x.head(old);
  x.segment(Eigen::Index(reach), old + 1) = 1.01 * e.orbit.x.tail(old + 1);
  return newton(type_one<double>(e.k, reach), x);
}

constexpr std::size_t longer = 9, shorter = usual_reach;

/**
The table holds one half only, the other being its mirror image. */
void add_profile(Table& table, const Exact& e, const Orbit<double>& orbit,
                 const Orbit<double>& check) {
  for (std::size_t j = 0; j <= shorter; ++j) {
    const State<double>& z = orbit.start;
    const double size = log_size(z, longer + j, orbit.amplitude);
    table.add({e.k, e.sign, j, z.y[longer + j], z.v[longer + j],
               compare(log_size(check.start, shorter + j, orbit.amplitude), size)});
  }
}

/**
Each orbit shown is computed on both chains; the difference is the error in the table. The velocities
of the orbit that the rest of the chapter uses are compared with those on the longer chain. */
Table profiles(Report& report, const std::vector<Exact>& shown) {
  Table table{{count("k", "oscillations a site"), count("sign", "of the central velocity"),
               count("n", "site", "site"), number("y", "position at t = 0"),
               number("v", "velocity at t = 0"),
               estimate("log_size", "log10 of the larger modulus of both over the amplitude", "",
                        "against the largest: difference of two chain lengths")}};
  std::vector<Orbit<double>> orbits(2 * shown.size());
  parallel_for(orbits.size(), [&](std::size_t i) {
    orbits[i] = lengthened(shown[i / 2], i % 2 ? shorter : longer);
  });
  double apart = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Exact& e = shown[i];
    add_profile(table, e, orbits[2 * i], orbits[2 * i + 1]);
    for (std::size_t j = 0; j < usual_reach; ++j)
      apart = std::max(
          apart, std::abs(orbits[2 * i].start.v[longer + j] - e.orbit.start.v[usual_reach + j]) /
                     e.orbit.amplitude);
  }
  report.facts.add("lengths_apart", {apart, apart}, "relative to amplitude, two chain lengths");
  return table;
}

/**
What does exact mean to the eye? The maps compare the energy density of an exact orbit with that of a
struck packet of about the same speed, on a logarithmic scale, on which a tail of a millionth would
still be seen. */
void add_map(Table& table, int which, const Chain& chain, State<double> state, double from,
             double first_site) {
  const double duration = 12 * two_pi;
  evolve(ContactAware{0.05}, chain, state, from, 1, Unobserved{});
  const double start = state.t;
  evolve(ContactAware{0.05}, chain, state, duration, 0.4, [&](const State<double>& now) {
    const auto e = energy_density(chain, now);
    for (int j = 0; j < 30; ++j)
      table.add(
          {which, now.t - start, j, std::log10(std::max(e[std::size_t(first_site + j)], 1e-14))});
  });
}

Table maps(const Exact& orbit) {
  Table table{{count("packet", "0 exact, 1 of an impact"), number("t", "time"),
               count("n", "site", "site"), number("log_e", "log10 of the energy density")}};
  const Chain chain{120};
  add_map(table, 0, chain, embed(orbit.orbit.start, chain.sites, 0), 0, 0);
  const double arrival = 47 * two_pi;  // the packet has then come to site 50 or so
  add_map(table, 1, chain, struck(chain.sites, 0.6676), arrival, 40);
  return table;
}

/**
## What an orbit leaves behind, and whether it is stable

The equations cover one shift; now we let an orbit run on. It is integrated over one shift at a time by
the method that lands on every opening and closing of a contact (landing.hpp), and then the frame moves
on by one site. What the last site of the frame holds is left behind. */
double left_behind(const Shooting<double>& problem, const Orbit<double>& orbit, std::size_t shifts,
                   const EventTolerance<double>& rule) {
  State<double> z = orbit.start;
  const double time = shift_time(orbit);
  double left = 0;
  for (std::size_t k = 0; k < shifts; ++k) {
    flow(problem.chain, z, time, rule);
    left = std::max(left, std::hypot(z.y.front(), z.v.front()));
    move_on(z, 1);
  }
  return left / orbit.amplitude;
}

/**
Do small disturbances grow? The derivative of the flow over $T$, read one site further, is the *shifted
map* (travelling.hpp), and its eigenvalues are the multipliers per shift. Two of them are one: they
belong to a shift in time and a change of speed. The pair $\lambda$, $1/\lambda$ of the internal phase
also lies close to one, so it is judged by $\kappa = (\lambda+\lambda^{-1}-2)/4$: the phase is held if
$\kappa < 0$, and a disturbance grows if $\kappa > 0$. All other multipliers are judged by their
moduli. */
template <class T>
std::pair<double, double> phase_and_rest(const Shooting<T>& problem, const Orbit<T>& orbit,
                                         const EventTolerance<T>& rule) {
  const auto all = multipliers_of(shifted_map(problem.chain, orbit.start, shift_time(orbit), rule));
  T rest(0);
  std::vector<std::complex<T>> near = all;
  std::stable_sort(near.begin(), near.end(),
                   [](auto a, auto b) { return std::norm(a - T(1)) < std::norm(b - T(1)); });
  for (std::size_t i = 4; i < near.size(); ++i) rest = std::max(rest, std::abs(near[i]));
  return {double(phase_kappa(all)), double(rest)};
}

/// The largest modulus of a multiplier; one where no growth shows above the error.
Estimate largest_modulus(const Pair& phase, const Estimate& rest) {
  if (rest.value > 1 + rest.error) return rest;
  const bool grows = phase.kappa.real() > phase.error;
  return {grows ? multiplier(phase.kappa, 1).real() : 1, phase.multiplier_error()};
}

/**
A long flight is the strictest test that an orbit leaves nothing behind. For a thousand shifts an
ordinary stepper is cheaper; its error shows in what it leaves behind. The frame moves on by twenty
sites at a time, and resting beads come in ahead. A hundred shifts are repeated by GSL, with which our
steppers have nothing in common, in one long chain. */
struct Flown {
  double left, off;  ///< left behind, and distance from the orbit where it should be
};

double passed(const State<double>& z, std::size_t shifts) {
  double left = 0;
  for (std::size_t n = 0; n + usual_reach < shifts; ++n)
    left = std::max(left, std::hypot(z.y[n], z.v[n]));
  return left;
}

/**
After each round of twenty shifts we look at the beads that have been passed and drop them. */
Flown by_steps(const Exact& e, std::size_t shifts, double step) {
  constexpr std::size_t round = 20;
  const Chain chain{round + 3 * usual_reach};
  const State<double> start = embed(e.orbit.start, chain.sites, 0);
  State<double> state = start;
  const auto steps = std::size_t(std::ceil(e.shift_time() / step));
  double left = 0;
  for (std::size_t k = 0; k < shifts; k += round) {
    evolve(stepper_for(1e-12, step), chain, state, TimeGrid{round * e.shift_time(), round, steps},
           Unobserved{});
    left = std::max(left, passed(state, round));
    move_on(state, round);
  }
  return {left / e.orbit.amplitude, largest_difference(state, start) / e.orbit.amplitude};
}

/**
GSL needs no frame: its chain holds all the sites that the packet passes. */
Flown by_gsl(const Exact& e, std::size_t shifts, double tolerance) {
  const Chain chain{shifts + 3 * usual_reach};
  State<double> state = embed(e.orbit.start, chain.sites, 0);
  evolve_reference(chain, state, double(shifts) * e.shift_time(), Tolerance(tolerance));
  const State<double> ought = embed(e.orbit.start, chain.sites, shifts);
  return {passed(state, shifts) / e.orbit.amplitude,
          largest_difference(state, ought) / e.orbit.amplitude};
}

/**
We fly the fastest orbit, $k = 1$, with the sign for which the phase is held; with the other sign
errors would grow. */
void report_flights(Report& report, const Exact& e) {
  const std::size_t many = report.quick ? 100 : 1000, few = report.quick ? 10 : 100;
  std::array<Flown, 4> f{};
  parallel_for(4, [&](std::size_t i) {
    f[i] = i == 0   ? by_steps(e, many, 0.01)
           : i == 1 ? by_steps(e, many, 0.02)
           : i == 2 ? by_gsl(e, few, 1e-14)
                    : by_gsl(e, few, 1e-12);
  });
  report.facts.add("left_by_thousand_shifts", compare(f[1].left, f[0].left), "of the amplitude");
  report.facts.add("off_after_thousand_shifts", compare(f[1].off, f[0].off), "of the amplitude");
  report.facts.add("left_by_hundred_gsl", compare(f[3].left, f[2].left), "of the amplitude");
  report.facts.add("off_after_hundred_gsl", compare(f[3].off, f[2].off), "of the amplitude");
}

/**
Two numbers describe the stability of an orbit: $\kappa$ of the phase, and the largest modulus of the
other multipliers. These lie inside the unit circle, which does not mean that anything is damped: the frame
travels, a bead's free oscillation does not, and so what disturbs the orbit leaves the frame. */
void report_stability(Report& report, const Exact& e) {
  const auto narrow = phase_and_rest(type_one<double>(e.k), e.orbit, {});
  const auto wide = phase_and_rest(type_one<long double>(e.k), e.wide, {});
  const std::string name = "_k" + std::to_string(e.k) + (e.sign > 0 ? "_plus" : "_minus");
  const Estimate kappa = compare(narrow.first, wide.first);
  report.facts.add("kappa" + name, kappa);
  if (kappa.value > kappa.error)
    report.facts.add("growth" + name,
                     {2 * std::asinh(std::sqrt(kappa.value)), kappa.error / std::sqrt(kappa.value)},
                     "per shift");
  report.facts.add("next_modulus" + name, compare(narrow.second, wide.second));
}

/**
## One orbit of the reader's choice

The command `orbit` computes one exact breather, also in other wells. At $s \ne 0$ the sum $Z$ no
longer rotates freely, the shift time is an unknown, and we follow the branch of orbits that begins at
$s = 0$. If it folds before the $s$ that was asked for, the command says where. */
struct OneOrbit {
  static constexpr Title title{"orbit", "one exact travelling breather"};
  std::size_t k = 1, reach = usual_reach;
  std::string sign = "plus";
  double s = 0, near = 0;
  bool profile = false;

  /**
  An orbit can be named by its $k$ or by a shift time near it. */
  void parameters(Parameters& p) {
    const Option& type_one = p.add("k", k, "oscillations a site, of type I", {1, 60});
    p.add("sign", sign, "of the central velocity at t = 0", {"plus", "minus"});
    const Option& well = p.add("s", s, "anharmonicity of the well", {-10, 10});
    p.add("near", near, "the orbit without a tail nearest to this shift time", {4, 100})
        .excludes(type_one)
        .excludes(well)
        .shows("none");
    p.add("reach", reach, "sites on either side of the centre", {2, 10});
    p.add("profile", profile, "the orbit at t = 0 instead of its quantities");
  }
  Table table() const;
};

struct Found {
  Shooting<double> problem;
  Orbit<double> orbit;
  Shooting<long double> wide_problem;
  Orbit<long double> wide;
};

constexpr Stride in_s{.first = 0.02, .least = 1e-6, .most = 0.3};

Branch<double> branch_in_s(const Orbit<double>& start, int direction) {
  const double time = shift_time(start);
  auto problem = with_free_time(travelling_problem(time, 0, start.start.y.size() / 2 - 1));
  const Vector<double> x = start.x.size() % 2 ? with_time(start.x, time) : start.x;
  return {problem, along_s<double>(), newton(problem, x), direction, {}, in_s};
}

/**
Whatever was asked for, the answer comes in two precisions, which give its error. */
Found found_with_free_time(const Shooting<double>& problem, const Orbit<double>& orbit) {
  const auto wide = in_precision<long double>(problem);
  return {problem, orbit, wide, polish(wide, orbit)};
}

Found on_branch(const OneOrbit& choice, const Orbit<double>& start) {
  const int direction = choice.s > 0 ? 1 : -1;
  auto branch = branch_in_s(start, direction);
  try {
    const Orbit<double> orbit = branch.reach(choice.s);
    auto problem = branch.problem();
    problem.chain.well = Quartic{choice.s};
    return found_with_free_time(problem, orbit);
  } catch (const NoBranch&) {
    auto again = branch_in_s(start, direction);
    const double fold = again.fold();
    throw UsageError("--s: " + short_text(choice.s) + " has no orbit with k = " +
                     std::to_string(choice.k) + " and the sign " + choice.sign +
                     " (allowed: s up to " + short_text(fold) + ", where the branch folds)");
  }
}

/**
The reader may choose the length of the chain. It is too short if its last bead moves so much that the
missing one would be felt. */
void need_reach(const OneOrbit& choice, const Orbit<double>& orbit) {
  State<double> half = orbit.start;
  auto problem = travelling_problem(shift_time(orbit), choice.s, choice.reach);
  flow(problem.chain, half, shift_time(orbit) / 2);
  const double edge = std::hypot(half.y.back(), half.v.back()) / orbit.amplitude;
  if (edge > 1e-10)
    throw UsageError("--reach: " + std::to_string(choice.reach) +
                     " sites are too few for the tail, whose last bead still moves by " +
                     short_text(edge) + " of the amplitude (allowed: more sites, at most 10)");
}

Found chosen_type_one(const OneOrbit& choice) {
  Staircase stairs(choice.sign == "plus" ? 1 : -1, choice.reach);
  const Orbit<double> orbit = stairs.reach(choice.k);
  if (choice.s != 0) return on_branch(choice, orbit);
  const auto problem = type_one<long double>(choice.k, choice.reach);
  return {type_one<double>(choice.k, choice.reach), orbit, problem, polish(problem, orbit)};
}

/**
One can also ask for the orbit without a tail nearest to a shift time. It may be of type I, or of
type II: those lie at somewhat shorter shift times, on families that begin at the orbits of type I (next
chapter). We follow the family that begins at the next multiple of $2\pi$ above the time asked for. */
Found chosen_near(const OneOrbit& choice) {
  const auto above = std::size_t(std::max(1.0, std::ceil(choice.near / two_pi)));
  Staircase stairs(choice.sign == "plus" ? 1 : -1, choice.reach);
  const Orbit<double> start = stairs.reach(above);
  const double end = std::max(choice.near - 0.6, 3.0);
  const auto members = follow_family(start, std::min(end, shift_time(start)), 0.1);
  std::vector<Found> candidates{{type_one<double>(above, choice.reach),
                                 start,
                                 type_one<long double>(above, choice.reach),
                                 {}}};
  for (std::size_t i = 1; i < members.size(); ++i)
    if (velocity_sum(members[i - 1]) * velocity_sum(members[i]) < 0) {
      const Orbit<double> orbit = type_two(members[i - 1], members[i]);
      const auto problem = with_free_time(travelling_problem(shift_time(orbit), 0, choice.reach));
      candidates.push_back({problem, orbit, in_precision<long double>(problem), {}});
    }
  // If none of them is near, the command fails and names the nearest one
  const auto distance = [&](const Found& f) { return std::abs(shift_time(f.orbit) - choice.near); };
  Found best = *std::min_element(candidates.begin(), candidates.end(),
                                 [&](auto& a, auto& b) { return distance(a) < distance(b); });
  if (distance(best) > 0.25)
    throw UsageError("--near: no orbit without a tail within 0.25 of " + short_text(choice.near) +
                     " (allowed: a time near one; the nearest is " +
                     number_text(shift_time(best.orbit)) + ")");
  best.wide = polish(best.wide_problem, best.orbit);
  return best;
}

/**
The residual is that of the profile as printed, so the wider orbit is rounded first. */
double residual_of(const Found& f) {
  const Vector<double> printed = f.wide.x.cast<double>();
  const Vector<long double> x = printed.cast<long double>();
  return double(sup<long double>(f.wide_problem.shoot(x, {}, false).miss)) / f.orbit.amplitude;
}

/**
Every quantity needs an error. Times, speeds and energies are compared between double precision and
the wider type; what is left behind, and the multipliers of slow orbits, for which the wider type would
take long, between two tolerances of the landing. */
Table orbit_table(const Found& f) {
  const auto peak = [](const auto& problem, const auto& orbit) {
    const auto e = energy_density(problem.chain, orbit.start);
    return double(*std::max_element(e.begin(), e.end()));
  };
  EventTolerance<double> fine, coarse;
  coarse.tolerance *= 8;
  const double t = shift_time(f.orbit), t_wide = double(shift_time(f.wide));
  const std::size_t shifts = f.problem.chain.sites;
  const auto narrow = phase_and_rest(f.problem, f.orbit, coarse);
  const auto better = t < 30 ? phase_and_rest(f.wide_problem, f.wide, {})
                             : phase_and_rest(f.problem, f.orbit, fine);
  const Pair phase{better.first, compare(narrow.first, better.first).error};
  // A tail or a residual that is only rounding is printed as it is, because its smallness is the result
  Quantities q;
  q.add("shift_time", compare(t, t_wide), "time");
  q.add("speed", compare(1 / t, 1 / t_wide), "site per unit of time");
  q.add("energy", compare(f.orbit.energy, double(f.wide.energy)));
  q.add("peak", compare(peak(f.problem, f.orbit), peak(f.wide_problem, f.wide)),
        "largest energy density at t = 0");
  q.add("tail",
        compare(left_behind(f.problem, f.orbit, shifts, coarse),
                left_behind(f.problem, f.orbit, shifts, fine)),
        "left behind, relative to amplitude");
  q.add("residual", {residual_of(f), residual_of(f)},
        "of the profile as printed, relative to amplitude");
  q.add("multiplier_modulus", largest_modulus(phase, compare(narrow.second, better.second)));
  return q.table;
}

/**
The profile is that of the wider type, rounded to double. */
Table profile_table(const Found& f) {
  Table table{{count("n", "site", "site"), number("y", "position at t = 0"),
               number("v", "velocity at t = 0")}};
  const long reach = long(f.problem.chain.sites / 2) - 1;
  for (std::size_t i = 0; i < f.problem.chain.sites; ++i)
    table.add({long(i) - reach, f.wide.start.y[i], f.wide.start.v[i]});
  return table;
}

Table OneOrbit::table() const {
  const Found f = near > 0 ? chosen_near(*this) : chosen_type_one(*this);
  need_reach(*this, f.orbit);
  return profile ? profile_table(f) : orbit_table(f);
}

/**
## Results

There are two exact travelling breathers, one of each sign, for every $k$ that we tried. Newton's method
finds the first in [6](num:sec5_travelling_breathers.newton_steps_from_cut) steps from the cut packet.
The residuals are [7e-14](num:sec5_travelling_breathers.residual_double) in double precision,
[3e-17](num:sec5_travelling_breathers.residual_wide) in the wider type and
[8e-17](num:sec5_travelling_breathers.residual_rounded) after rounding. A thousand shifts leave
[2e-14](num:sec5_travelling_breathers.left_by_thousand_shifts) of the amplitude behind, no more than the
error of the steps. The fastest, $k = 1$, has the speed $1/(2\pi)$ and the energy
[0.180834](num:sec5_travelling_breathers.energy_plus); with the other sign it is higher by only
[7.843e-11](num:sec5_travelling_breathers.energy_difference). So little holds the internal phase, and the
multipliers agree: $\kappa =$ [-8.8883e-11](num:sec5_travelling_breathers.kappa_k1_plus) with the sign plus,
[8.888e-11](num:sec5_travelling_breathers.kappa_k1_minus) with the sign minus, a growth of
[1.8856e-5](num:sec5_travelling_breathers.growth_k1_minus) per shift. At $k = 2$ no $\kappa$ is left above
the errors. All other disturbances are left behind by the travelling frame, in which per shift at most
[0.870581](num:sec5_travelling_breathers.next_modulus_k1_plus) of them remain. */
void reproduce(Report& report) {
  const std::vector<std::size_t> ks =
      report.quick ? std::vector<std::size_t>{1, 2, 3} : std::vector<std::size_t>{1, 2, 3, 4, 5};
  std::vector<std::vector<Exact>> all(2);
  parallel_for(2, [&](std::size_t i) { all[i] = type_one_orbits(signs[i], ks); });
  const Exact &plus = all[0].front(), &minus = all[1].front();
  report_exactness(report, all[0], all[1]);
  report.output.add("profiles", profiles(report, {plus, minus, all[0][2]}));
  report.output.add("maps", maps(plus));
  report_flights(report, plus);
  for (const auto& orbits : all)
    for (const Exact& e : {orbits[0], orbits[1]}) report_stability(report, e);
}

/**
## Limits and extensions

Orbits that repeat themselves only after $m > 1$ sites, or with the opposite sign after each shift, or never,
were not looked for. For a shift by $m$ sites the sum $Z$ still demands $T = 2\pi k$, and the speeds
$m/2\pi k$ are dense: so it is not this identity alone that isolates speeds. But it settles only one of the $m$
complex amplitudes that such an orbit may leave behind on $m$ successive beads, so that $m - 1$ conditions
remain without an unknown to meet them. We therefore expect such orbits only at particular $s$ or exponents.

That tails vanish at countably many speeds, where the resonance meets a zero, is known from chains of beads
with resonators (Kevrekidis, Stefanov and Xu, Letters in Mathematical Physics 106, 2016, arXiv:1502.01995);
here the well itself is the resonator. In the DpS equation travelling breathers were computed by James
(Philosophical Transactions A 376, 20170138, 2018), who finds tails but for particular parameters. Moving
breathers on a tail, and the conditions under which it vanishes, are discussed for other lattices by Flach and
Kladko (Physica D 127, 61, 1999), Iooss and Kirchgässner (Communications in Mathematical Physics 211, 439,
2000) and Sire and James (Physica D 204, 15, 2005).

- `sec5_travelling_breathers orbit --k 1 --sign minus` is weakly unstable. What does its phase do after
  a hundred thousand shifts?
- `orbit --near 5.6` prints an orbit of type II. Is the nearest one always on the family that begins at
  the next larger $2\pi k$?
- Why do the energies of the two signs differ by so little, and by what law in $k$? */
int main(int argc, char** argv) {
  return run({"sec5_travelling_breathers", "5", "Exact travelling breathers (section 5)", reproduce,
              commands<OneOrbit>()},
             argc, argv);
}
