/**
# 5 Families of travelling breathers

An exact travelling breather of the linear well needs the right speed. Its shift time $T$, in which it moves on by one
site, must be $2\pi k$ (type I) or such that the sum $Z = \sum_n(y_n+i\dot y_n)$ vanishes (type II). At other shift
times a breather radiates a tail. This chapter follows the families on which both types lie and asks how strong the tail
of the members between the exact ones is. Then it continues the exact ones into soft wells and into hard wells, where
those of $k = 1$, 2 and 3 turn back in folds. Does the packet that turns round in section 3.4 follow one of them?

![The radiated tail of travelling breathers against their shift time.](fig:x19) */

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/branches_in_s.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of the chapter before, $\ddot y_n+y_n+s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2}-(y_n-y_{n+1})_+^{3/2}$, with $s
= 0$ at first. We look for motions that are *reversible*: at $t = 0$ positions are odd and velocities even about the
central site, and at $T/2$ they are so about the next contact,
$$y_n+y_{1-n} = 0,\qquad \dot y_n-\dot y_{1-n} = 0\qquad\text{at } t = T/2,\ n = 1,\dots,L+1,$$
on the sites $-L$ to $L+1$ (symmetry.hpp). The two together, $y_n(t) = -y_{-n}(-t) = -y_{1-n}(T-t)$, make $y_n(t+T) =
y_{n-1}(t)$; even wells allow them. There are as many equations as unknowns if $T$ is one of them: the state at $t = 0$
has $L$ positions and $L+1$ velocities, the bead $L+1$ being at rest.

For a prescribed $T$ we leave out one equation, that of $y_1+y_0$. The others have a solution for every $T$ at which we
look for one, in the stretches named below, and these solutions form a *family*. Which condition do they violate? At
$t = 0$ the positions cancel in the sum, so that $Z = iV$ with $V = \sum\dot y_n$. In linear wells $Z$ turns with
$e^{-it}$, and at $T/2$ its real part, the sum of all positions, is $V\sin(T/2)$. This sum consists of the left sides of
the equations for positions, all of which vanish but the first. So the equation left out reads $V\sin(T/2) = 0$: $T =
2\pi k$ gives an orbit of type I, at which a family begins, and each zero of $V$ an orbit of type II. The full
equations, with $T$ unknown, confirm the latter and give its digits in two precisions. */
constexpr double two_pi = 2 * std::numbers::pi;

struct Family {
  std::size_t k;
  int sign;
  double fastest;  ///< T of the last member, over 2 pi
  std::vector<Orbit<double>> members{}, found{};
};

/**
We follow five families from their orbit of type I towards shorter shift times: that of $k = 1$ for both
signs of the central velocity down to $T/2\pi = 0.7$, and those of $k = 2$, $3$ and $4$ with the sign plus down to
$1.5$, $2.6$ and $3.7$. A change of the sign of $V$ marks an orbit of type II. */
std::vector<Family> families(bool quick) {
  if (quick) return {{1, 1, 0.88}};
  return {{1, 1, 0.70}, {1, -1, 0.70}, {2, 1, 1.50}, {3, 1, 2.60}, {4, 1, 3.70}};
}

void follow(Family& f, double step) {
  const Orbit<double> start = TypeOneOrbits(f.sign).orbit_at(f.k);
  f.members = follow_family(start, two_pi * f.fastest, step);
  for (std::size_t i = 1; i < f.members.size(); ++i)
    if (velocity_sum(f.members[i - 1]) * velocity_sum(f.members[i]) < 0)
      f.found.push_back(type_two(f.members[i - 1], f.members[i]));
}

/**
## The radiated tail (figure x19)

What becomes of a member that is not an exact orbit? We release it in a chain at rest, and behind it each bead keeps
oscillating. If the pulses in the contacts repeat themselves after $T$, it does so with the amplitude
$|1-e^{-iT}|\,|g(1)|$ (chapter on exact travelling breathers). A member that radiates loses energy, and its pulses
repeat themselves only approximately. So this can only give the order of magnitude, and we measure how well it does. The
integral $g(1)$ needs no quadrature: it is the change of $e^{it}Z$, with the sum $Z$ taken over the beads on the right
of the contact only. */
struct Left {
  double beads = 0, pulse = 0;  ///< both relative to the amplitude
};

std::complex<double> sum_from(const State<double>& z, std::size_t first) {
  std::complex<double> sum = 0;
  for (std::size_t n = first; n < z.y.size(); ++n) sum += std::complex<double>(z.y[n], z.v[n]);
  return std::polar(1.0, z.t) * sum;
}

/**
The contact lies ahead of the packet at first; the four beads on its right are measured when the packet
has left them behind. */
Left set_free(const Orbit<double>& member, double step) {
  const Chain chain{64};
  const std::size_t contact = 2 * usual_half_length, beads = 4;
  const double time = shift_time(member);
  State<double> state = embed(member.start, chain.sites, 0);
  const std::complex<double> before = sum_from(state, contact);
  evolve(EventCorrected{step}, chain, state, time_grid(24 * time, time, step));
  Left left;
  for (std::size_t n = contact; n < contact + beads; ++n)
    left.beads += std::hypot(state.y[n], state.v[n]) / double(beads) / member.amplitude;
  left.pulse = std::abs(2 * std::sin(time / 2)) * std::abs(sum_from(state, contact) - before) /
               member.amplitude;
  return left;
}

/**
The figure compares both with $|1-e^{-iT}|\,|V|$ (beside some orbits of type II the pulse misses the dip or makes it too
deep), since $|g(1)| = |V|$ as long as little is radiated: then the whole sum $Z = iV$ passes from the beads on the left
of the contact to those on its right. The error of the run is the difference between two steps. For the error of $V$ we
evaluate the equation that was left out and compare it with $V\sin(T/2)$, which also checks this identity for every
member. */
double missed_identity(const Orbit<double>& member) {
  const double time = shift_time(member);
  const auto problem = with_free_time(travelling_problem(time));
  const double first = problem.evaluate(with_time(member.x, time), {}, false).residual[0];
  return std::abs(first / member.amplitude - velocity_sum(member) * std::sin(time / 2));
}

/**
We compare the amplitude of the beads with that expected from the sum $Z = iV$ of the member at the start, at the
[141](num:sec5_travelling_families.left_compared) members of the five families whose tail is above $10^{-7}$. There the
tail has the order of magnitude given by the sum $Z$, from [0.40](num:sec5_travelling_families.left_over_sum_least) to
[1.05](num:sec5_travelling_families.left_over_sum_most) of $\lvert1-e^{-iT}\rvert\,\lvert Z\rvert$, but at
[126](num:sec5_travelling_families.left_off_by_a_fifth) of them it is more than a fifth off. One might expect the two to
agree very close to an orbit of type I, closer than the table goes, because there the tail is weak and the pulses nearly
repeat themselves. They do not: with this measurement at $T/2\pi = k-10^{-4}$, made once by a program that is not part
of this repository, the ratio was 1.079, 0.961 and 0.889 for $k = 1$, $2$ and $4$; we do not know why. At the orbits of
type II $V$ vanishes, and nothing should be left behind; the members drawn lie beside them, so that the figure shows
dips and no zeros. */
// The errors are to be compared with the largest value of their column, because these columns pass through zero
Cells row_of(const Family& f, const Orbit<double>& member, double step) {
  const double tail = 2 * std::abs(std::sin(shift_time(member) / 2) * velocity_sum(member));
  const Left fine = set_free(member, step / 2), coarse = set_free(member, step);
  const auto log = [](double x) { return std::log10(std::max(x, 1e-14)); };
  return {f.k,
          f.sign,
          shift_time(member) / two_pi,
          member.energy,
          Estimate{tail, 2 * missed_identity(member)},
          log(tail),
          compare(coarse.beads, fine.beads),
          log(fine.beads),
          log(fine.pulse)};
}

const Table& report_left_behind(Report& report, const std::vector<Family>& all, double step) {
  Table& table = report.table(
      "left_behind",
      {count("k", "k of the type I orbit at which the family begins"),
       count("sign", "sign of the central velocity"), number("turns", "shift time over 2 pi"),
       number("energy", "energy"),
       estimate("tail", "|1 - exp(-iT)| |V| divided by the amplitude", "",
                "against the largest tail: from the equation left out"),
       number("log_tail", "log10 of tail"),
       estimate("beads", "amplitude of the beads left behind, divided by that of the member", "",
                "against the largest: difference of two steps"),
       number("log_beads", "log10 of beads"),
       number("log_pulse", "log10 of |1 - exp(-iT)| |g(1)| divided by the amplitude")});
  for (const Family& f : all)
    table.fill(
        f.members, [&](const Orbit<double>& member) { return row_of(f, member, step); }, "members");
  return table;
}

// Members with less than 1e-7 are left out, for which the step errs as much
void report_left(Report& report, const Table& table) {
  const auto tail = table.numbers("tail"), tail_error = table.numbers("tail_error"),
             beads = table.numbers("beads"), beads_error = table.numbers("beads_error");
  int compared = 0, off = 0;
  Estimate least{1e300}, most;
  for (std::size_t i = 0; i < tail.size(); ++i) {
    if (tail[i] < 1e-7) continue;
    const Estimate share = quotient({beads[i], beads_error[i]}, {tail[i], tail_error[i]});
    ++compared, off += std::abs(share.value - 1) > 0.2;
    if (share.value < least.value) least = share;
    if (share.value > most.value) most = share;
  }
  report.facts.add("left_compared", exact(compared), "members");
  report.facts.add("left_off_by_a_fifth", exact(off), "members");
  report.facts.add("left_over_sum_least", least, "beads left behind over |1 - exp(-iT)| |V|");
  report.facts.add("left_over_sum_most", most, "beads left behind over |1 - exp(-iT)| |V|");
}

/**
## All orbits in one chart (figure x20)

The chart shows the orbits of type I, for $k = 1$ to 6 and both signs of the central velocity, and those of type II on
the five families. An orbit found once has no estimate of its error, so each is found twice: those of type I again from
a disturbed guess and with contact events located less precisely, those of type II in extended precision. On the family
that begins at $T = 2\pi$ the first orbit of type II lies at $T/2\pi =$
[0.897](num:sec5_travelling_families.turns_type_two_1); in all we found
[12](num:sec5_travelling_families.found_type_one) orbits of type I and [18](num:sec5_travelling_families.found_type_two)
of type II. For $k = 1$ the two signs give different orbits of nearly the same energy. Near $T/2\pi = 0.95$, where the
figure before has a dip, there is none: $V$ becomes small and keeps its sign. */
struct Twice {
  int type;
  std::size_t k;
  int sign;
  Estimate time, energy;
  double central;
};

Twice type_one_twice(std::size_t k, int sign, const Orbit<double>& orbit) {
  return {
      1, k, sign, exact(two_pi * double(k)), energy_of_type_one(k, orbit), central_velocity(orbit)};
}

Twice type_two_twice(const Family& f, const Orbit<double>& orbit) {
  const auto problem = with_free_time(travelling_problem(shift_time(orbit)));
  const auto wide = newton(in_precision<long double>(problem), orbit);
  return {2,
          f.k,
          f.sign,
          compare(shift_time(orbit), double(shift_time(wide))),
          compare(orbit.energy, double(wide.energy)),
          central_velocity(orbit)};
}

/**
The orbits of type I follow from the first one that Newton's method finds, at $k = 5$: down to the
fastest, $k = 1$, and up to slower ones. */
std::vector<Twice> all_orbits(const std::vector<Family>& all, std::size_t slowest) {
  std::vector<std::vector<Twice>> lists(2 + all.size());
  parallel_for(lists.size(), [&](std::size_t i) {
    if (i >= 2) {
      for (const auto& orbit : all[i - 2].found)
        lists[i].push_back(type_two_twice(all[i - 2], orbit));
      return;
    }
    const int sign = i == 0 ? 1 : -1;
    TypeOneOrbits down(sign), up = down;
    for (std::size_t k : {4, 3, 2, 1})
      lists[i].push_back(type_one_twice(k, sign, down.orbit_at(k)));
    for (std::size_t k = 5; k <= slowest; ++k)
      lists[i].push_back(type_one_twice(k, sign, up.orbit_at(k)));
  });
  std::vector<Twice> orbits;
  for (const auto& list : lists) orbits.insert(orbits.end(), list.begin(), list.end());
  return orbits;
}

void report_orbit_chart(Report& report, const std::vector<Twice>& orbits) {
  Table& table = report.table(
      "orbits",
      {count("type", "1 or 2"), count("k", "k of the type I orbit at which the family begins"),
       count("sign", "sign of the central velocity"),
       estimate("turns", "shift time over 2 pi", "", "difference of two precisions; 0 where exact"),
       number("speed", "speed", "site per unit of time"),
       estimate("energy", "energy", "", "difference of two computations"),
       number("central_velocity", "velocity of the central bead at t = 0")});
  for (const Twice& o : orbits)
    table.add({o.type, o.k, o.sign, Estimate{o.time.value / two_pi, o.time.error / two_pi},
               1 / o.time.value, o.energy, o.central});
}

// Those of type II on the family of k = 1, and how many orbits we found
void report_orbits(Report& report, const std::vector<Twice>& orbits) {
  int count = 0, found[2] = {0, 0};
  for (const Twice& o : orbits) {
    ++found[o.type - 1];
    if (o.type != 2 || o.k != 1 || o.sign < 0) continue;
    const std::string name = "_type_two_" + std::to_string(++count);
    report.facts.add("turns" + name, {o.time.value / two_pi, o.time.error / two_pi},
                     "shift time over 2 pi");
    report.facts.add("energy" + name, o.energy);
  }
  report.facts.add("found_type_one", exact(found[0]));
  report.facts.add("found_type_two", exact(found[1]));
}

/**
## Soft and hard wells (figure x21)

What happens to exact orbits in other wells? For $s \ne 0$ the sum $Z$ does not merely rotate, and it no longer tells
which speeds are possible. But with $T$ as an unknown there are as many equations as unknowns, so that by the implicit
function theorem an orbit at which their derivative is invertible continues to $s \ne 0$. We follow it by
pseudo-arclength, so that we can pass *folds*, at which a branch turns back in $s$ (branches_in_s.hpp).

In soft wells none of the four branches of type I ends within the steps that we take: ten, and two for $k = 4$. Followed
further, that of $k = 1$ folds at $s =$ [-5.73](num:sec5_travelling_families.soft_fold_k1). In hard wells those of $k =
1$, 2 and 3 fold, and come back from there to an orbit of type II at $s = 0$, for $k = 1$ after two folds more close to
$s = 0$. The slower the orbit, the later it folds: slow orbits are small and feel the quartic term less.

| $k$ | soft wells: followed to $s =$ | hard wells: fold at $s =$ |
|---|---|---|
| 1 | [-1.163](num:sec5_travelling_families.soft_k1) | [0.0103004 ± 2e-9](num:sec5_travelling_families.fold_k1) |
| 2 | [-1.38](num:sec5_travelling_families.soft_k2) | [0.325582 ± 5e-7](num:sec5_travelling_families.fold_k2) |
| 3 | [-1.392](num:sec5_travelling_families.soft_k3) | [1.90266 ± 2e-11](num:sec5_travelling_families.fold_k3) |
| 4 | [-0.049](num:sec5_travelling_families.soft_k4) | | */
using Start = std::pair<std::size_t, Orbit<double>>;  ///< k and its orbit at s = 0

// The folds come from shorter steps than the branches
void report_folds(Report& report, const std::vector<Start>& starts) {
  const std::size_t hard = starts.size();
  std::vector<Estimate> folds(hard + (report.quick ? 0 : 1));
  parallel_for(folds.size(), [&](std::size_t i) {
    folds[i] = fold_of(branch_in_s(starts[i % hard].second, i < hard ? 1 : -1));
  });
  for (std::size_t i = 0; i < hard; ++i)
    report.facts.add("fold_k" + std::to_string(starts[i].first), folds[i], "s");
  if (folds.size() > hard) report.facts.add("soft_fold_k1", folds[hard], "s");
}

// Branches of slow orbits need few steps
Table branch_table(const std::vector<Start>& starts, int steps) {
  Table table{{count("k", "k of the orbit at which the branch begins, s = 0"),
               count("direction", "direction in which s changes at the start"),
               count("sign", "sign of the central velocity at s = 0"),
               number("s", "anharmonicity of the well"), number("turns", "shift time over 2 pi"),
               number("speed", "speed", "site per unit of time"), number("energy", "energy")}};
  std::vector<std::vector<Place>> ways(2 * starts.size());
  parallel_for(ways.size(), [&](std::size_t i) {
    const int most = starts[i / 2].first > 3 ? steps / 4 : steps;
    ways[i] = follow_branch(starts[i / 2].second, i % 2 ? -1 : 1, i % 2 ? most / 4 : most);
  });
  for (std::size_t i = 0; i < ways.size(); ++i)
    for (const Place& p : ways[i])
      table.add({starts[i / 2].first, i % 2 ? -1 : 1,
                 central_velocity(starts[i / 2].second) > 0 ? 1 : -1, p.s, p.turns,
                 1 / (two_pi * p.turns), p.energy});
  return table;
}

void report_wells(Report& report, const std::vector<Start>& starts) {
  const bool quick = report.quick;
  report_folds(report, {starts.begin(), starts.begin() + (quick ? 1 : 3)});
  const Table branches = branch_table(starts, quick ? 8 : 40);
  const auto k = branches.numbers("k"), direction = branches.numbers("direction"),
             s = branches.numbers("s");
  for (const Start& start : starts) {
    double softest = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
      if (k[i] == double(start.first) && direction[i] < 0) softest = std::min(softest, s[i]);
    report.facts.add("soft_k" + std::to_string(start.first),
                     exact(std::trunc(1000 * softest) / 1000), "s to which it is followed");
  }
  report.output.add("branches", branches);
}

/**
## The boomeron again

In section 3.4 the packet of an impact with $v_0 = 1.9$ slows down in hard wells, $s = 1$, and turns round:
the *boomeron*. At a given $s$ the exact orbits that we know are single points in the plane of speed and energy. Does
the path of the packet come near any of them, and does it turn there? A branch may pass $s = 1$ on its way out, and
again after its fold; those of $k = 1$ and 2 fold before and have no orbit there. The fastest orbit found at $s = 1$ has
the speed [0.0540](num:sec5_travelling_families.fastest_at_one) and the energy
[0.00166](num:sec5_travelling_families.fastest_energy_at_one); when the packet is as slow as that it still has
[1.52](num:sec5_travelling_families.packet_energy_then), some nine hundred times as much (figure x21d). The other two
that we found are slower and have less energy still, while the packet has kept most of its own. A packet on an exact
orbit would have its speed and its energy, so this one is on none of those found. [](finding:travelling.wells)
`sec34_boomeron_map` asks what turns it instead. */
Path packet_at_one(double step) {
  Path path;
  strike(EventCorrected{step}, {1.9, {160, Quartic{1}}, 400, 0.5},
         [&](const State<double>& now, const std::vector<double>& e) { path.add(now.t, e); });
  return smooth(path, 40);
}

double speed_in(const Path& p, std::size_t i) {
  return (p.centre[i + 1] - p.centre[i - 1]) / (p.t[i + 1] - p.t[i - 1]);
}

Cells crossing(std::size_t k, Branch& branch) {
  const Orbit<double> orbit = branch.orbit_at(1);
  Shooting<double> problem = branch.problem();
  problem.chain.well = Quartic{1};
  const auto wide = newton(in_precision<long double>(problem), orbit);
  return {k, compare(1 / shift_time(orbit), 1 / double(shift_time(wide))),
          compare(orbit.energy, double(wide.energy))};
}

Table exact_at_one(const std::vector<Start>& starts) {
  Table table{{count("k", "k of the orbit at which the branch begins, s = 0"),
               estimate("speed", "speed", "site per unit of time", "difference of two precisions"),
               estimate("energy", "energy", "", "difference of two precisions")}};
  std::vector<std::vector<Cells>> rows(starts.size());
  parallel_for(starts.size(), [&](std::size_t i) {
    const std::size_t k = starts[i].first;
    Branch branch = branch_in_s(starts[i].second, 1);
    try {
      rows[i].push_back(crossing(k, branch));
      if (k > 3) return;
      branch.fold();
      rows[i].push_back(crossing(k, branch));
    } catch (const NoBranch&) {
      // it folds before s = 1
    }
  });
  for (const auto& branch : rows)
    for (const Cells& row : branch) table.add(row);
  return table;
}

// The energy of the fastest exact orbit at s = 1 and that of the packet when it has slowed down to the same speed
void report_boomeron(Report& report, const Table& exact_orbits, const Path& coarse,
                     const Path& fine) {
  const auto speeds = exact_orbits.numbers("speed"), energies = exact_orbits.numbers("energy"),
             speed_errors = exact_orbits.numbers("speed_error"),
             energy_errors = exact_orbits.numbers("energy_error");
  if (speeds.empty()) return;
  const auto top = std::size_t(std::max_element(speeds.begin(), speeds.end()) - speeds.begin());
  report.facts.add("fastest_at_one", {speeds[top], speed_errors[top]}, "site per unit of time");
  report.facts.add("fastest_energy_at_one", {energies[top], energy_errors[top]});
  const auto energy_then = [&](const Path& p) {
    for (std::size_t i = 1; i + 1 < p.t.size(); ++i)
      if (p.t[i] > 100 && speed_in(p, i) < speeds[top]) return p.energy[i];
    return std::nan("");
  };
  report.facts.add("packet_energy_then", compare(energy_then(coarse), energy_then(fine)),
                   "when it is as fast as the fastest exact orbit");
}

void report_packet(Report& report, const Path& p) {
  Table& table =
      report.table("packet_at_one",
                   {number("t", "time"), number("centre", "smoothed centre of the packet", "site"),
                    number("speed", "speed of the smoothed centre", "site per unit of time"),
                    number("energy", "smoothed energy of the packet")});
  for (std::size_t i = 1; i + 1 < p.t.size(); i += 2)
    table.add({p.t[i], p.centre[i], speed_in(p, i), p.energy[i]});
}

/**
## Differences and limits

The branches of the table are followed within $|s|\le3$ and $T\ge\pi$, which are our choice, and for a limited number of
steps; the soft folds quoted were searched beyond. Some of them end where Newton's method fails, which seems to happen
at orbits in which a bead of the tail only just touches its neighbour. We do not prove that nothing else exists at $s =
1$; we looked only for what is connected with $s = 0$: branches of type I with the sign plus, $k\le4$. Those of the sign
minus, of type II and of orbits that repeat themselves after several sites were not followed to $s = 1$. */
void reproduce(Report& report) {
  const bool quick = report.quick;
  std::vector<Family> all = families(quick);
  parallel_for(all.size(), [&](std::size_t i) {
    follow(all[i], quick ? 0.2 : i < 2 ? 0.06 : 0.1);
  });
  report_left(report, report_left_behind(report, all, 0.1));
  const std::vector<Twice> orbits = all_orbits(all, quick ? 4 : 6);
  report_orbits(report, orbits);
  report_orbit_chart(report, orbits);
  std::vector<Start> starts;
  for (std::size_t k : quick ? std::vector<std::size_t>{1} : std::vector<std::size_t>{1, 2, 3, 4})
    starts.emplace_back(k, TypeOneOrbits(1).orbit_at(k));
  report_wells(report, starts);
  const Table at_one = exact_at_one(starts);
  std::array<Path, 2> packet;
  parallel_for(2, [&](std::size_t i) { packet[i] = packet_at_one(i ? 0.05 : 0.1); });
  report_boomeron(report, at_one, packet[0], packet[1]);
  report.output.add("exact_at_one", at_one);
  report_packet(report, packet[1]);
}

/**
## Try it

1. *Easy.* How much energy has the first orbit of type II on the family that begins at $T = 2\pi$?
   `build/bin/sec5_travelling_breathers orbit --near 5.6` gives `energy` = 1.313832.
   Hint: a little faster than the orbit of type I at the family's beginning, and yet several times its energy.
2. *Harder.* And near $T = 12$, on the family of $k = 2$?
   `build/bin/sec5_travelling_breathers orbit --near 12` gives `shift_time` = 12.187932.
   Hint: divide by $2\pi$, and ask for shift times a little shorter: zeros of $V$ follow one another.
3. *Harder.* Do slow orbits notice the well?
   `build/bin/sec5_travelling_breathers orbit --k 2 --s -1` gives `shift_time` = 12.65551.
   Hint: compare the relative change of the shift time with that of $k = 1$ (`--k 1 --s -1`), and the peaks of both.
4. *Open.* Follow type II into the limit of small amplitude: do all of them merge with type I?
5. *Open.* Kick an exact orbit at $s = 0$ and watch its phase: does it ever lose the kick? */
int main(int argc, char** argv) {
  return run(
      {"sec5_travelling_families", "5", "Families of travelling breathers (section 5)", reproduce},
      argc, argv);
}
