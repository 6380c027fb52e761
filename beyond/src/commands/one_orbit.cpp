#include "commands/one_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "lattice/numerics/progress.hpp"

namespace lattice {
using namespace report;

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

template std::pair<double, double> phase_and_rest(const Shooting<double>&, const Orbit<double>&,
                                                  const EventTolerance<double>&);
template std::pair<double, double> phase_and_rest(const Shooting<long double>&,
                                                  const Orbit<long double>&,
                                                  const EventTolerance<long double>&);

/// The largest modulus of a multiplier; one where no growth shows above the error.
static Estimate largest_multiplier(const MultiplierPair& phase, const Estimate& rest) {
  if (rest.value > 1 + rest.error) return rest;
  const bool grows = phase.kappa.real() > phase.error;
  return {grows ? multiplier(phase.kappa, 1).real() : 1, phase.multiplier_error()};
}

/**
The equations cover one shift; here an orbit runs on. It is integrated over one shift at a time by the method
that ends a step at every contact event (event_driven.hpp), and then the frame moves on by one site.
What the last site of the frame holds is left behind. */
static double left_behind(const Shooting<double>& problem, const Orbit<double>& orbit,
                          std::size_t shifts, const EventTolerance<double>& rule) {
  State<double> z = orbit.start;
  const double time = shift_time(orbit);
  double left = 0;
  Progress progress("shifts", shifts);
  for (std::size_t k = 0; k < shifts; ++k) {
    flow(problem.chain, z, time, rule);
    left = std::max(left, std::hypot(z.y.front(), z.v.front()));
    move_on(z, 1);
    progress.tick();
  }
  return left / orbit.amplitude;
}

/**
An orbit can be named by its $k$ or by a shift time near it. */
void OneOrbit::parameters(Parameters& p) {
  const Option& type_one =
      p.add("k", k,
            "oscillations per site of a type I orbit, whose shift time is 2 pi k in harmonic wells",
            {1, 60});
  p.add("sign", sign, "sign of the central velocity at t = 0", {"plus", "minus"});
  const Option& well = p.add("s", s, "anharmonicity s of the quartic well", {-10, 10});
  p.add("near", near,
        "instead of --k, the orbit without a radiated tail nearest to this shift time", {4, 100})
      .excludes(type_one)
      .excludes(well);
  p.add("reach", half_length, "number of sites on either side of the centre", {2, 10});
  p.add("profile", as_profile, "print the orbit at t = 0 instead of its quantities");
}

constexpr double two_pi = 2 * std::numbers::pi;

/**
The branch is followed in double precision, and its end is confirmed in extended precision. */
static OneOrbit::Found found_with_free_time(const Shooting<double>& problem,
                                            const Orbit<double>& orbit) {
  const auto wide = in_precision<long double>(problem);
  return {problem, orbit, wide, newton(wide, orbit)};
}

static OneOrbit::Found on_branch(const OneOrbit& choice, const Orbit<double>& start) {
  const int direction = choice.s > 0 ? 1 : -1;
  auto branch = branch_in_s(start, direction, 0.3);
  try {
    const Orbit<double> orbit = branch.orbit_at(choice.s);
    auto problem = branch.problem();
    problem.chain.well = Quartic{choice.s};
    return found_with_free_time(problem, orbit);
  } catch (const NoBranch&) {
    auto again = branch_in_s(start, direction, 0.3);
    const double fold = again.fold();
    throw UsageError("--s: " + short_text(choice.s) + " has no orbit with k = " +
                     std::to_string(choice.k) + " and the sign " + choice.sign +
                     " (allowed: s up to " + short_text(fold) + ", where the branch folds)");
  }
}

/**
The reader may choose the length of the chain. It is too short if its last bead moves so much that the
missing one would be felt. */
static void need_half_length(const OneOrbit& choice, const Orbit<double>& orbit) {
  State<double> half = orbit.start;
  auto problem = travelling_problem(shift_time(orbit), choice.s, choice.half_length);
  flow(problem.chain, half, shift_time(orbit) / 2);
  const double edge = std::hypot(half.y.back(), half.v.back()) / orbit.amplitude;
  if (edge > 1e-10)
    throw UsageError("--reach: " + std::to_string(choice.half_length) +
                     " sites are too few for the tail: the last bead still moves by " +
                     short_text(edge) + " of the amplitude (allowed: more sites, at most 10)");
}

static OneOrbit::Found chosen_type_one(const OneOrbit& choice) {
  TypeOneOrbits orbits(choice.sign == "plus" ? 1 : -1, choice.half_length);
  const Orbit<double> orbit = orbits.orbit_at(choice.k);
  if (choice.s != 0) return on_branch(choice, orbit);
  const auto problem = type_one<long double>(choice.k, choice.half_length);
  return {type_one<double>(choice.k, choice.half_length), orbit, problem, newton(problem, orbit)};
}

/**
One can also ask for the orbit without a tail nearest to a shift time. It may be of type I, or of type II: those lie
at somewhat shorter shift times, on families that begin at the orbits of type I (sec5_travelling_breathers.cpp). We
follow the family that begins at the next multiple of $2\pi$ above the time asked for. */
static OneOrbit::Found chosen_near(const OneOrbit& choice, double near) {
  const auto above = std::size_t(std::max(1.0, std::ceil(near / two_pi)));
  TypeOneOrbits orbits(choice.sign == "plus" ? 1 : -1, choice.half_length);
  const Orbit<double> start = orbits.orbit_at(above);
  const double end = std::max(near - 0.6, 3.0);
  const auto members = follow_family(start, std::min(end, shift_time(start)), 0.1);
  std::vector<OneOrbit::Found> candidates{{type_one<double>(above, choice.half_length),
                                           start,
                                           type_one<long double>(above, choice.half_length),
                                           {}}};
  for (std::size_t i = 1; i < members.size(); ++i)
    if (velocity_sum(members[i - 1]) * velocity_sum(members[i]) < 0) {
      const Orbit<double> orbit = type_two(members[i - 1], members[i]);
      const auto problem =
          with_free_time(travelling_problem(shift_time(orbit), 0, choice.half_length));
      candidates.push_back({problem, orbit, in_precision<long double>(problem), {}});
    }
  // If none of them is near, the command fails and names the nearest one
  const auto distance = [&](const OneOrbit::Found& f) {
    return std::abs(shift_time(f.orbit) - near);
  };
  OneOrbit::Found best =
      *std::min_element(candidates.begin(), candidates.end(),
                        [&](auto& a, auto& b) { return distance(a) < distance(b); });
  if (distance(best) > 0.25)
    throw UsageError("--near: no orbit without a tail within 0.25 of " + short_text(near) +
                     " (allowed: a time near one; the nearest is " +
                     number_text(shift_time(best.orbit)) + ")");
  best.wide = newton(best.wide_problem, best.orbit);
  return best;
}

/**
The residual is that of the profile as printed, so the wider orbit is rounded first. */
static double residual_of(const OneOrbit::Found& f) {
  const Vector<double> printed = f.wide.x.cast<double>();
  const Vector<long double> x = printed.cast<long double>();
  return double(sup<long double>(f.wide_problem.evaluate(x, {}, false).residual)) /
         f.orbit.amplitude;
}

/**
Every quantity needs an error. Times, speeds and energies are compared between double and
extended precision; what is left behind, and the multipliers of slow orbits, for which extended precision would
take long, between two tolerances of the flow. */
Table OneOrbit::quantities(const Found& f) const {
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
  const MultiplierPair phase{better.first, with_error(narrow.first, better.first).error};
  const double tail = left_behind(f.problem, f.orbit, shifts, fine);
  // A tail or a residual that is only rounding is printed as it is, because its smallness is the result. Two tolerances
  // share the rounding of the start, so that their difference is not its error
  Answers q;
  q.add("shift_time", with_error(t, t_wide), "time",
        "time T after which every bead repeats the motion of its neighbour behind, one site of "
        "travel");
  q.add("speed", with_error(1 / t, 1 / t_wide), "site per unit of time",
        "speed of the breather, one site per shift time");
  q.add("energy", with_error(f.orbit.energy, double(f.wide.energy)), "",
        "energy of the whole chain, Eq. (6)");
  q.add("peak", with_error(peak(f.problem, f.orbit), peak(f.wide_problem, f.wide)), "",
        "largest energy density of a site at t = 0");
  q.add_small("tail", {tail, std::max(tail, left_behind(f.problem, f.orbit, shifts, coarse))},
              "relative to amplitude",
              "largest (y^2 + v^2)^(1/2) of a bead left behind: the radiated tail");
  q.add_small("residual", {residual_of(f), residual_of(f)}, "relative to amplitude",
              "difference between the printed profile and itself one shift time later and one site "
              "further on");
  q.add("multiplier_modulus", largest_multiplier(phase, with_error(narrow.second, better.second)),
        "", "largest modulus of a multiplier per shift; 1 where no perturbation is seen to grow");
  return q.table;
}

/**
The profile is that of extended precision, rounded to double. */
Table OneOrbit::profile(const Found& f) const {
  Table table{{count("n", "site", "site"), number("y", "position at t = 0"),
               number("v", "velocity at t = 0")}};
  const long half_length = long(f.problem.chain.sites / 2) - 1;
  for (std::size_t i = 0; i < f.problem.chain.sites; ++i)
    table.add({long(i) - half_length, f.wide.start.y[i], f.wide.start.v[i]});
  return table;
}

OneOrbit::Found OneOrbit::find() const {
  Found f = near ? chosen_near(*this, *near) : chosen_type_one(*this);
  need_half_length(*this, f.orbit);
  return f;
}

Table OneOrbit::table() const {
  const Found f = find();
  return as_profile ? profile(f) : quantities(f);
}

}  // namespace lattice
