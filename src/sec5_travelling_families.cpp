/**
# 5 Families of travelling breathers

An exact travelling breather of the linear well needs the right speed: $T = 2\pi k$ for a shift by one
site, or one of the times at which the sum $Z = \sum_n(y_n+i\dot y_n)$ vanishes. In between, a
breather sheds a tail. This chapter follows the families on which both kinds lie:

        V ^   type I                          what is left behind ~ |1 - exp(-iT)| |V|
          |*
          |  *                  zeros of V: type II
          |    * . _ o____._o__
          +----------------------->  2 pi k - T

and continues the exact ones into soft and hard wells, where the two kinds meet and end.

![What travelling breathers leave behind, against their shift time.](fig:x19) */

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/measure/turning.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/orbits/travelling.hpp"
#include "lattice/report/program.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the chapter before, $\ddot y_n + y_n + s y_n^3$ on the left, Hertz contacts on the
right. A family is what solves all equations of a travelling breather but one (travelling.hpp). It
exists for every shift time $T$; the equation that is left over reads $V\sin(T/2) = 0$ in the linear
well, with $V = \sum\dot y_n$ at $t = 0$, and each zero of $V$ is an exact orbit of type II. The full
equations, with $T$ unknown, confirm it and give its digits in two precisions. */
constexpr double two_pi = 2 * std::numbers::pi;

struct Family {
  std::size_t k;
  int sign;
  double fastest;  ///< T of the last member, over 2 pi
  std::vector<Orbit<double>> members{}, found{};
};

/**
What is shown: the first family with both signs, and three more. */
std::vector<Family> families(bool quick) {
  std::vector<Family> list{{1, 1, 0.70}, {1, -1, 0.70}, {2, 1, 1.50}, {3, 1, 2.50}, {4, 1, 3.60}};
  if (quick) list = {{1, 1, 0.85}, {1, -1, 0.85}};
  return list;
}

void follow(Family& f, double step) {
  const Orbit<double> start = Staircase(f.sign).reach(f.k);
  f.members = follow_family(start, two_pi * f.fastest, step);
  for (std::size_t i = 1; i < f.members.size(); ++i)
    if (velocity_sum(f.members[i - 1]) * velocity_sum(f.members[i]) < 0)
      f.found.push_back(type_two(f.members[i - 1], f.members[i]));
}

/**
## What is left behind (figure x19)

A member is set free in a resting chain. It is no exact orbit and must shed what does not fit: behind it
each bead keeps oscillating. If the pulses $f$ that pass through the contacts repeat themselves after
$T$, its amplitude is $|1-e^{-iT}|\,|g(1)|$ with $g(1) = \int e^{it}f\,dt$. We measure both sides, the
beads that have been passed and the pulse in one contact, in the same flight. */
struct Left {
  double beads = 0, pulse = 0;  ///< both relative to the amplitude
};

Left set_free(const Orbit<double>& member, double step) {
  const Chain<Harmonic, Hertz> chain{64};
  const std::size_t contact = 2 * usual_reach, beads = 4;
  const double time = shift_time(member);
  const Pace way = pace(24 * time, step, step);
  State<double> state = embed(member.start, chain.sites, 0);
  std::complex<double> pulse = 0;
  evolve(ContactAware{step}, chain, state, way, [&](const State<double>& now) {
    pulse += way.interval() * std::polar(contact_push(chain, now.y.data(), contact), now.t);
  });
  Left left;
  for (std::size_t n = contact; n < contact + beads; ++n)
    left.beads += std::hypot(state.y[n], state.v[n]) / double(beads) / member.amplitude;
  left.pulse = std::abs(2 * std::sin(time / 2)) * std::abs(pulse) / member.amplitude;
  return left;
}

/**
The figure shows both, and $|V|$ beside them: ahead of the packet all is at rest, so the sum over what
is right of a contact is the pulse that came through it, and $|g(1)| = |V|$ where nothing is shed.
Errors are those of the flight with half the step, and for $V$ those of a coarser landing. */
double checked_sum(const Orbit<double>& member) {
  NewtonRule<double> coarse;
  coarse.landing.tolerance *= 8;
  return velocity_sum(polish(travelling_problem(shift_time(member)), member, coarse));
}

Table left_behind(const std::vector<Family>& all, double step) {
  Table table{{count("k", "where the family begins"), count("sign", "of the central velocity"),
               number("turns", "shift time over 2 pi"), number("energy", "energy"),
               number("V", "sum of the velocities at t = 0 over the amplitude"),
               number("V_error", "against the largest V: difference of two tolerances"),
               number("log_V", "log10 of |1 - exp(-iT)| |V|"),
               number("beads", "amplitude of the beads left behind over that of the member"),
               number("beads_error", "against the largest: difference of two steps"),
               number("log_beads", "its log10"),
               number("log_pulse", "log10 of |1 - exp(-iT)| |g(1)|")}};
  for (const Family& f : all) {
    std::vector<std::vector<Cell>> rows(f.members.size());
    parallel_for(f.members.size(), [&](std::size_t i) {
      const Orbit<double>& m = f.members[i];
      const double v = velocity_sum(m), tail = std::abs(2 * std::sin(shift_time(m) / 2));
      const Left fine = set_free(m, step / 2), coarse = set_free(m, step);
      rows[i] = {std::int64_t(f.k),
                 std::int64_t(f.sign),
                 shift_time(m) / two_pi,
                 m.energy,
                 v,
                 std::abs(checked_sum(m) - v),
                 std::log10(std::max(tail * std::abs(v), 1e-14)),
                 fine.beads,
                 std::abs(fine.beads - coarse.beads),
                 std::log10(std::max(fine.beads, 1e-14)),
                 std::log10(std::max(fine.pulse, 1e-14))};
    });
    for (auto& row : rows) table.add(row);
  }
  return table;
}

/**
## All orbits in one chart (figure x20)

Orbits of type I for many k, and those of type II of the families. The small ones have a limit in
which only ratios are left, the DpS equation: $E \propto c^4$. */
Table orbit_chart(std::vector<Family>& all, const std::vector<std::size_t>& ks) {
  Table table{{count("type", "1 or 2"), count("k", "where the family begins"),
               count("sign", "of the central velocity"), number("turns", "shift time over 2 pi"),
               number("turns_error", "difference of two precisions"),
               number("speed", "speed", "site per unit of time"), number("energy", "energy"),
               number("energy_error", "difference of two precisions"),
               number("inverse_k", "2 pi over the shift time"),
               number("scaled_energy", "energy over the fourth power of the speed"),
               number("scaled_speed", "speed over the fourth root of the energy"),
               number("central_velocity", "velocity of the central bead at t = 0")}};
  const auto add = [&](int type, std::size_t k, int sign, const Orbit<double>& o, double time,
                       double energy) {
    const double t = shift_time(o);
    table.add({std::int64_t(type), std::int64_t(k), std::int64_t(sign), time / two_pi,
               compare(t, time).error / two_pi, 1 / time, energy, compare(o.energy, energy).error,
               two_pi / time, energy * std::pow(time, 4), 1 / time / std::pow(energy, 0.25),
               central_velocity(o)});
  };
  for (int sign : {1, -1}) {
    Staircase down(sign), up = down;
    for (std::size_t k : ks) {
      const Orbit<double> o = (k > Staircase::first ? up : down).reach(k);
      NewtonRule<double> coarse;
      coarse.landing.tolerance *= 8;
      add(1, k, sign, o, two_pi * double(k), polish(type_one<double>(k), o, coarse).energy);
    }
  }
  for (Family& f : all)
    for (const Orbit<double>& o : f.found) {
      const auto problem =
          in_precision<long double>(with_free_time(travelling_problem(shift_time(o))));
      const auto wide = polish(problem, o);
      add(2, f.k, f.sign, o, double(shift_time(wide)), double(wide.energy));
    }
  return table;
}

/**
## Soft and hard wells (figure x21)

For $s \ne 0$ no sum returns and no speed is distinguished. But an exact orbit is a regular solution
of square equations with $T$ unknown, and continues. We follow it by its arclength, through folds. */
constexpr Stride in_s{.first = 0.02, .least = 1e-6, .most = 0.25};

using Free = TravellingProblem<double>;

Branch<Free> branch_from(const Orbit<double>& start, int direction, const Stride& stride) {
  const Free problem = with_free_time(travelling_problem(shift_time(start)));
  const Orbit<double> orbit = newton(problem, with_time(start.x, shift_time(start)));
  return {problem, along_s<Free>(), orbit, direction, {}, stride};
}

/// A point of a branch.
struct Place {
  double s, turns, energy;
};
Place place(const Branch<Free>& branch) {
  const Free problem = branch.problem();
  const Vector<double> x = branch.unknowns();
  return {problem.chain.onsite.s, x[x.size() - 1] / two_pi,
          energy(problem.chain, problem.unfold(x))};
}

/**
A branch is followed within bounds; beyond them it goes on. */
std::vector<Place> follow_branch(const Orbit<double>& start, int direction, int steps) {
  Branch<Free> branch = branch_from(start, direction, in_s);
  std::vector<Place> way{place(branch)};
  try {
    for (int i = 0; i < steps; ++i) {
      branch.advance();
      way.push_back(place(branch));
      if (std::abs(way.back().s) > 3 || way.back().turns < 0.5) break;
    }
  } catch (const NoConvergence&) {
    // Newton's method fails where beads of the tail only just touch; the branch is shown up to there.
  }
  return way;
}

/**
Two strides give each fold and its error. */
void report_folds(Report& report,
                  const std::vector<std::pair<std::size_t, Orbit<double>>>& starts) {
  std::vector<Estimate> folds(starts.size());
  parallel_for(starts.size(), [&](std::size_t i) {
    Stride finer = in_s;
    finer.first /= 2, finer.most /= 2;
    const auto fold = [&](const Stride& stride) {
      return branch_from(starts[i].second, 1, stride).fold();
    };
    folds[i] = compare(fold(in_s), fold(finer));
  });
  for (std::size_t i = 0; i < starts.size(); ++i)
    report.facts.add("fold_k" + std::to_string(starts[i].first), folds[i], "s");
}

Table branch_table(const std::vector<std::pair<std::size_t, Orbit<double>>>& starts, int steps) {
  Table table{{count("k", "where the branch begins at s = 0"),
               count("direction", "of s at the start"),
               count("sign", "of the central velocity at s = 0"),
               number("s", "anharmonicity of the well"), number("turns", "shift time over 2 pi"),
               number("speed", "speed", "site per unit of time"), number("energy", "energy")}};
  std::vector<std::vector<Place>> ways(2 * starts.size());
  parallel_for(ways.size(), [&](std::size_t i) {
    ways[i] = follow_branch(starts[i / 2].second, i % 2 ? -1 : 1, i % 2 ? steps / 3 : steps);
  });
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (const Place& p : ways[i])
      table.add({std::int64_t(starts[i / 2].first), std::int64_t(i % 2 ? -1 : 1),
                 std::int64_t(central_velocity(starts[i / 2].second) > 0 ? 1 : -1), p.s, p.turns,
                 1 / (two_pi * p.turns), p.energy});
  return table;
}

/**
## The boomeron again

At $s = 1$ a packet slows down and turns (section 3.4). If it followed exact orbits as it slows, it
would turn where they end. So we draw its way, its speed against its energy, among the orbits that
exist at $s = 1$: those branches of type I that have not folded before. */
Table packet_at_one(double step) {
  const Chain<Quartic, Hertz> chain{160, {1}};
  State<double> state = struck(chain.sites, 1.9);
  Path path;
  evolve(ContactAware{step}, chain, state, 500, 0.5,
         [&](const State<double>& now) { path.add(now.t, energy_density(chain, now)); });
  const Path smoothed = smooth(path, 40);
  Table table{{number("t", "time"), number("centre", "smoothed centre", "site"),
               number("speed", "of the smoothed centre", "site per unit of time"),
               number("energy", "smoothed energy of the packet")}};
  for (std::size_t i = 1; i + 1 < smoothed.t.size(); i += 2)
    table.add({smoothed.t[i], smoothed.centre[i],
               (smoothed.centre[i + 1] - smoothed.centre[i - 1]) /
                   (smoothed.t[i + 1] - smoothed.t[i - 1]),
               smoothed.energy[i]});
  return table;
}

/**
Which of the branches reach $s = 1$, and with what energy and speed. */
Table exact_at_one(const std::vector<std::pair<std::size_t, Orbit<double>>>& starts) {
  Table table{{count("k", "where the branch begins at s = 0"),
               number("speed", "speed", "site per unit of time"), number("energy", "energy"),
               number("energy_error", "difference of two precisions")}};
  std::vector<std::vector<Cell>> rows(starts.size());
  parallel_for(starts.size(), [&](std::size_t i) {
    Branch<Free> branch = branch_from(starts[i].second, 1, in_s);
    try {
      const Orbit<double> orbit = branch.reach(1);
      Free problem = branch.problem();
      problem.chain.onsite.s = 1;
      const auto wide = polish(in_precision<long double>(problem), orbit);
      rows[i] = {std::int64_t(starts[i].first), 1 / double(shift_time(wide)), double(wide.energy),
                 compare(orbit.energy, double(wide.energy)).error};
    } catch (const NoBranch&) {
      // folds before
    }
  });
  for (auto& row : rows)
    if (!row.empty()) table.add(row);
  return table;
}

/**
## Results */
Results reproduce(Report& report) {
  const bool quick = report.quick;
  std::vector<Family> all = families(quick);
  parallel_for(all.size(), [&](std::size_t i) { follow(all[i], quick ? 0.2 : 0.06); });
  const std::vector<std::size_t> ks =
      quick ? std::vector<std::size_t>{4, 3, 2, 1, 6}
            : std::vector<std::size_t>{4, 3, 2, 1, 5, 6, 8, 10, 15, 20, 30};
  report.output.add("left_behind", left_behind(all, quick ? 0.1 : 0.05));
  report.output.add("orbits", orbit_chart(all, ks));
  std::vector<std::pair<std::size_t, Orbit<double>>> starts;
  for (std::size_t k :
       quick ? std::vector<std::size_t>{1, 2} : std::vector<std::size_t>{1, 2, 3, 4, 6})
    starts.emplace_back(k, Staircase(1).reach(k));
  report_folds(report, {starts.begin(), starts.begin() + (quick ? 1 : 3)});
  report.output.add("branches", branch_table(starts, quick ? 12 : 60));
  report.output.add("exact_at_one", exact_at_one(starts));
  report.output.add("packet_at_one", packet_at_one(quick ? 0.1 : 0.05));
  report.output.add("facts", report.facts.table);
  return report.results;
}

int main(int argc, char** argv) {
  Program program({"sec5_travelling_families", "5", "Families of travelling breathers (section 5)"},
                  argc, argv);
  program.everything = [&](Output& output) {
    Report report{output, program.quick};
    return reproduce(report);
  };
  return program.run(argc, argv);
}
