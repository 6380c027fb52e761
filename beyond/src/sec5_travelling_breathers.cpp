/**
# 5 Exact travelling breathers

An impact on the chain launches breathers that travel, but those of section 3.4 of James, Kevrekidis and Cuevas (Physica
D 251, 2013) radiate a tail and weaken as they go. Do breathers exist that travel without radiating? After the *shift
time* $T$ such a breather would be the same again, one site further on:

      t = 0    .  .  o  O  o  .  .  .            y_n(t + T) = y_(n-1)(t)
      t = T    .  .  .  o  O  o  .  .            and nothing is left behind

Section 5 calls their computation by Newton's method an interesting open problem. It works:

- In linear wells we find two exact travelling breathers, with opposite signs of the central velocity, for every shift
  time $T = 2\pi k$ that we tried. Others lie at isolated shift times in between. One sum over the chain restricts which
  shift times are possible.
- Breathers at other shift times radiate a tail. In other wells the exact ones continue, and in hard wells their
  branches turn back.
- Packets of impacts come near the line through them, at shift times without an exact one. Over 16,000 sites their tail
  weakens, but no exact breather that we know captures them.

![Exact travelling breathers, and a packet that radiates a tail.](fig:x18) */
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_orbit.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/dps_travelling.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;
using namespace report;

/**
## Model and method

The contacts are those of Eq. (9) and the wells those of Eq. (10), linear ($s = 0$) unless we say otherwise; all is
dimensionless:
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
We look for *reversible* motions on the sites $-L$ to $L+1$. At $t = 0$ positions are odd and velocities even about
the site 0, and at $T/2$ they are so about the next contact:
$$y_n+y_{1-n} = 0,\qquad \dot y_n-\dot y_{1-n} = 0\qquad\text{at } t = T/2,\ n = 1,\dots,L+1 .$$
The two together, $y_n(t) = -y_{-n}(-t) = -y_{1-n}(T-t)$, make $y_n(t+T) = y_{n-1}(t)$. There are as many equations as
unknowns if $T$ is an unknown beside $y_1,\dots,y_L$ and $\dot y_0,\dots,\dot y_L$. If $T$ is prescribed we leave out
the equation of $y_1+y_0$; at $T = 2\pi k$ it holds by itself, as shown below.

The first guess for Newton's method is the packet of an impact with $v_0 = 0.0174$, which takes about five oscillations
from site to site, cut out of the chain when it is most nearly symmetrical (`cut_packet`, travelling.hpp). From $k = 5$
we go down to the fastest orbit, $k = 1$, and up to slower ones. */
constexpr double two_pi = 2 * std::numbers::pi;

/// An exact breather, found twice; the differences of both are the errors.
struct Exact {
  int type;       // 1 if T = 2 pi k, otherwise 2
  std::size_t k;  // for type 2 that of the family on which it lies
  int sign;       // of the central velocity
  Orbit<double> orbit;
  Estimate time, energy;
};

std::vector<Exact> type_one_orbits(int sign, const std::vector<std::size_t>& from_five) {
  std::vector<Exact> found;
  const auto add = [&](std::size_t k, const Orbit<double>& orbit) {
    found.push_back({1, k, sign, orbit, exact(two_pi * double(k)), energy_of_type_one(k, orbit)});
  };
  TypeOneOrbits down(sign), up = down;
  for (std::size_t k : {4, 3, 2, 1}) add(k, down.orbit_at(k));
  for (std::size_t k : from_five) add(k, up.orbit_at(k));
  return found;
}

const Exact& orbit_of(const std::vector<Exact>& all, std::size_t k, int sign) {
  return *std::find_if(all.begin(), all.end(),
                       [=](const Exact& e) { return e.k == k && e.sign == sign; });
}

/// By how much an orbit misses itself one shift later and one site further on, relative to its amplitude.
template <class T>
double missed(const Chain& chain, const Orbit<T>& orbit) {
  State<T> later = orbit.start;
  flow(chain, later, shift_time(orbit));
  T most = std::max(std::abs(later.y[0]), std::abs(later.v[0]));  // left behind
  for (std::size_t n = 1; n < chain.sites; ++n)
    most = std::max({most, std::abs(later.y[n] - orbit.start.y[n - 1]),
                     std::abs(later.v[n] - orbit.start.v[n - 1])});
  return double(most / orbit.amplitude);
}

/**
## Which speeds are possible

In linear wells the contact forces cancel in the sum $Z = \sum_n (y_n + i\dot y_n)$. If it converges absolutely, it only
rotates, $Z(t) = e^{-it}Z(0)$. A shift by one site does not change it, so that $(e^{-iT}-1)Z = 0$, and one of the two
factors vanishes.

<!-- travelling.speeds -->
Let $y_n(t+T) = y_{n-1}(t)$ be an exact travelling breather in linear wells. If the sum $Z = \sum_n(y_n+i\dot y_n)$
converges absolutely, then $T = 2\pi k$ with an integer $k$, or $Z = 0$. In symmetric wells no localized travelling
breather satisfies $y_n(t+T) = -y_{n-1}(t)$. (proved)
<!-- /travelling.speeds -->

An orbit with $T = 2\pi k$, which moves on by one site during $k$
oscillations of a free bead, is *type I*. One with $Z = 0$, at whatever $T$, is *type II*.

*The equation left out.* At $t = 0$ the positions are odd, so $Z = iV$ with $V = \sum\dot y_n$. At $T/2$ the real part
of $Z$, the sum of all positions, is $V\sin(T/2)$. It is also the sum of the left sides of the equations for positions,
and all of these vanish but the one left out. So that equation reads $V\sin(T/2) = 0$: it holds at $T = 2\pi k$, and
wherever $V = 0$.

*The tail*, an estimate. A bead that has been passed keeps oscillating with the amplitude $|\int
e^{it}(f_{n-1}-f_n)\,dt|$, where $f_n$ is the force in the contact on its right. If these pulses repeat themselves after
$T$ from contact to contact, it is $|1-e^{-iT}|\,|g|$ with $g = \int e^{it}f_0\,dt$. Take $Z$ over the beads beyond this
contact alone: it is zero before the breather comes and all of $Z$ when it has gone through, and only the pulse changes
$e^{it}$ times this sum. Hence $|g| = |Z|$, and the amplitude is
$$|1-e^{-iT}|\,|Z|,$$
which vanishes in just the two cases.

*No orbit of opposite sign.* In wells with $W'(-y) = -W'(y)$ no localized orbit satisfies $y_n(t+T) = -y_{n-1}(t)$. With
$d_n = y_n-y_{n+1}$ the compression of the contact $n$ at $t+T$ is $-d_{n-1}(t)$. Add Newton's law for the bead $n$ at
$t+T$ and for the bead $n-1$ at $t$. The left sides cancel, and
$$0 = (-d_{n-2})_+^{3/2}-(-d_{n-1})_+^{3/2}+(d_{n-2})_+^{3/2}-(d_{n-1})_+^{3/2} = |d_{n-2}|^{3/2}-|d_{n-1}|^{3/2} .$$
So at each instant all $|d_n|$ are equal. If the orbit is localized they vanish, and so does the orbit.

## How exact they are

For $k = 1$ to 3 we repeat Newton's method in extended precision, let each orbit flow over a whole shift, without its
symmetry, and compare it with itself one site further on. All six agree to within $10^{-15}$ of their amplitude (table
`exactness`). A small residual is no proof that an orbit exists. That there is one for every $k$ is proved in
`sec5_kernel_equation`, that both of $k = 1$ exist in `sec5_enclosures`.

The fastest orbit of type I, $k = 1$, has the energy [0.181](cell:orbits/type=1/k=1/sign=1/energy) with the sign plus.
With the sign minus it is higher by only [7.84e-11](cell:exactness/k=1/energy_difference): the two are nearly the same
packet at two phases of its internal oscillation. (At equal $T$; a barrier would compare them at equal action.) */
Orbit<long double> in_extended_precision(const Exact& e) {
  NewtonRule<long double> rule;
  rule.events.tolerance /= 2;
  return newton(type_one<long double>(e.k), e.orbit, rule);
}

void report_exactness(Report& report, const std::vector<Exact>& all) {
  const std::string only_size = "only its size counts, known to 100 per cent";
  Table& table = report.table(
      "exactness",
      {count("k", "oscillations per site"),
       estimate("missed_plus", "by how much the orbit with the sign plus misses itself",
                "amplitude", only_size),
       estimate("missed_minus", "the same of that with the sign minus", "amplitude", only_size),
       estimate("energy_difference", "energy of that with the sign minus, minus that with plus", "",
                "against the largest: difference of two precisions")});
  for (std::size_t k : {1, 2, 3}) {
    const Exact &plus = orbit_of(all, k, 1), &minus = orbit_of(all, k, -1);
    const auto wide_plus = in_extended_precision(plus), wide_minus = in_extended_precision(minus);
    const auto size = [&](const Orbit<long double>& wide) {
      const double most = missed(type_one<long double>(k).chain, wide);
      return Estimate{most, most};
    };
    table.add({k, size(wide_plus), size(wide_minus),
               with_error(minus.orbit.energy - plus.orbit.energy,
                          double(wide_minus.energy - wide_plus.energy))});
  }
}

/**
## Profiles and maps (figure x18)

Do the tails fit on eight sites? Going outwards, the force on each bead is the power 3/2 of its neighbour's
displacement, so that the orbit falls off double-exponentially. The profiles are found again on a chain with one more
site on either side, from a disturbed guess, so that Newton's method takes the steps that the far tail needs. At $t = 0$
both tails are mirror images, and the table has one of them. */
Orbit<double> lengthened(const Exact& e) {
  constexpr auto L = Eigen::Index(usual_half_length);
  Vector<double> x = Vector<double>::Zero(2 * L + 3);
  x.head(L) = 1.01 * e.orbit.x.head(L);
  x.segment(L + 1, L + 1) = 1.01 * e.orbit.x.tail(L + 1);
  return newton(type_one<double>(e.k, usual_half_length + 1), x);
}

void report_profiles(Report& report, const std::vector<Exact>& shown) {
  Table& table = report.table(
      "profiles",
      {count("k", "oscillations per site"), count("sign", "sign of the central velocity"),
       count("n", "site", "site"), number("y", "position at t = 0"),
       number("v", "velocity at t = 0"),
       number("log_size", "log10 of the larger of |y| and |v|, divided by the amplitude")});
  for (const Exact& e : shown) {
    const Orbit<double> orbit = lengthened(e);
    for (std::size_t n = 0; n <= usual_half_length; ++n) {
      const std::size_t i = usual_half_length + 1 + n;
      const double y = orbit.start.y[i], v = orbit.start.v[i];
      table.add(
          {e.k, e.sign, n, y, v, std::log10(std::max(std::abs(y), std::abs(v)) / orbit.amplitude)});
    }
  }
}

/**
The maps compare the energy density of an exact orbit with that of the packet of an impact at about the same speed. The
scale is logarithmic, so that a tail of a millionth would still be seen. */
void add_map(Table& table, int which, const Chain& chain, State<double> state, double from,
             double first_site) {
  evolve(EventCorrected{0.05}, chain, state, from, Every{1});
  const double start = state.t;
  evolve(EventCorrected{0.05}, chain, state, 12 * two_pi, Every{0.4},
         [&](const State<double>& now) {
           const auto e = energy_density(chain, now);
           for (int j = 0; j < 30; ++j)
             table.add({which, now.t - start, j,
                        std::log10(std::max(e[std::size_t(first_site + j)], 1e-14))});
         });
}

void report_maps(Report& report, const Exact& e) {
  Table& table = report.table(
      "maps", {count("packet", "0: exact breather, 1: packet of an impact"), number("t", "time"),
               count("n", "site", "site"), number("log_e", "log10 of the energy density")});
  const Chain chain{120};
  add_map(table, 0, chain, embed(e.orbit.start, chain.sites, 0), 0, 0);
  const double arrival = 47 * two_pi;  // the packet has then come to site 50 or so
  add_map(table, 1, chain, struck(chain.sites, 0.6676), arrival, 40);
}

/**
## Stability

The multipliers per shift, the eigenvalues of the flow over $T$ read one site further on, say whether a small
disturbance of the eighteen sites grows. Two of them are one: a change of the speed neither grows nor dies out. The pair
$\lambda$, $1/\lambda$ of the internal phase has $\kappa = (\lambda+\lambda^{-1}-2)/4$, and the phase is pinned if
$\kappa<0$. The other multipliers lie inside the unit circle, though nothing is damped: a free oscillation of the beads
is left behind, and the disturbance with it.

| $k = 1$, sign | plus | minus |
|---|---|---|
| $\kappa$ of the internal phase | [-8.89e-11](cell:stability/sign=1/kappa) | [8.9e-11](cell:sign=-1/kappa) |
| its growth per shift | none: pinned | [1.89e-5](cell:stability/sign=-1/growth) |
| largest modulus of the others | [0.8706](cell:stability/sign=1/others) | [0.8706](cell:sign=-1/others) |

<!-- travelling.stability -->
A small disturbance of the fastest travelling breather of type I ($T = 2\pi k$ with $k = 1$) has three parts. A change
of speed persists. The internal phase is pinned if the central velocity has the sign plus (its pair of multipliers over
one shift has $\kappa =$ -8.888e-11) and unstable if it has the sign minus, growing by the fraction 1.89e-5 per shift.
In the co-moving frame everything else is eventually multiplied by 0.8706 or less per shift. (computed)
<!-- /travelling.stability --> */
void report_stability(Report& report, const std::vector<Exact>& orbits) {
  Table& table = report.table(
      "stability",
      {count("k", "oscillations per site"), count("sign", "sign of the central velocity"),
       estimate("kappa", "kappa of the internal phase over one shift", "",
                "difference of two precisions"),
       estimate("growth", "growth of a shift of the phase, logarithm of its multiplier; 0: pinned",
                "", "from that of kappa; 0 where exact"),
       estimate("others", "largest modulus of the multipliers not near one", "",
                "difference of two precisions")});
  for (const Exact& e : orbits) {
    const auto in_double = phase_and_rest(type_one<double>(e.k), e.orbit, {});
    const auto wide = phase_and_rest(type_one<long double>(e.k), in_extended_precision(e), {});
    const Estimate kappa = with_error(in_double.first, wide.first);
    const double root = std::sqrt(std::max(kappa.value, 0.0));
    const Estimate growth =
        root > 0 ? Estimate{2 * std::asinh(root), kappa.error / root} : exact(0);
    table.add({e.k, e.sign, kappa, growth, with_error(in_double.second, wide.second)});
  }
}

/**
## Families in the shift time (figure x19)

Which motions lie between the exact ones? Without the equation of $y_1+y_0$ there was a solution for every $T$ that we
tried, and these solutions form a *family*. Along it one number, $V$, tells where a breather is exact. We follow five
families from their orbit of type I towards shorter shift times: that of $k = 1$ for both signs down to $T/2\pi = 0.7$,
and those of $k = 2$, 3 and 4 with the sign plus. A change of the sign of $V$ marks an orbit of type II, and the full
equations, with $T$ unknown, confirm it in two precisions.

![The radiated tail of the family of $k = 1$, and all exact breathers found.](fig:x19) */
struct Family {
  std::size_t k;
  int sign;
  double fastest;  ///< T of the last member, over 2 pi
  std::vector<Orbit<double>> members{};
  std::vector<Exact> found{};
};

void follow_family(Family& f, double step) {
  const Orbit<double> start = TypeOneOrbits(f.sign).orbit_at(f.k);
  f.members = follow_family(start, two_pi * f.fastest, step);
  for (std::size_t i = 1; i < f.members.size(); ++i) {
    if (velocity_sum(f.members[i - 1]) * velocity_sum(f.members[i]) > 0) continue;
    const Orbit<double> orbit = type_two(f.members[i - 1], f.members[i]);
    const auto problem = with_free_time(travelling_problem(shift_time(orbit)));
    const auto wide = newton(in_precision<long double>(problem), orbit);
    f.found.push_back({2, f.k, f.sign, orbit,
                       with_error(shift_time(orbit), double(shift_time(wide))),
                       with_error(orbit.energy, double(wide.energy))});
  }
}

std::vector<Family> families(bool quick) {
  std::vector<Family> all{{1, 1, 0.88}};
  if (!quick) all = {{1, 1, 0.70}, {1, -1, 0.70}, {2, 1, 1.50}, {3, 1, 2.60}, {4, 1, 3.70}};
  parallel_for(all.size(), [&](std::size_t i) {
    follow_family(all[i], quick ? 0.2 : all[i].k == 1 ? 0.06 : 0.1);
  });
  return all;
}

/**
We release each member in a chain at rest and measure the beads that it has passed. A member that radiates loses energy,
so its pulses do not quite repeat themselves, and $|1-e^{-iT}|\,|V|$ gives its tail to a factor of 2.5 only. The
members drawn lie beside the exact orbits, so the figure shows dips and no zeros. Near $T/2\pi = 0.95$ there is a dip
without an exact orbit: at the members that we computed $V$ becomes small and keeps its sign. */
double beads_behind(const Orbit<double>& member, double step) {
  const Chain chain{64};
  const double time = shift_time(member);
  State<double> state = embed(member.start, chain.sites, 0);
  evolve(EventCorrected{step}, chain, state, time_grid(24 * time, time, step));
  double left = 0;
  for (std::size_t n = 16; n < 20; ++n)
    left += std::hypot(state.y[n], state.v[n]) / 4 / member.amplitude;
  return left;
}

void report_left_behind(Report& report, const std::vector<Family>& all) {
  Table& table = report.table(
      "left_behind",
      {count("k", "k of the type I orbit at which the family begins"),
       count("sign", "sign of the central velocity"), number("turns", "shift time over 2 pi"),
       number("energy", "energy"),
       number("log_tail", "log10 of |1 - exp(-iT)| |V| divided by the amplitude"),
       estimate("beads", "amplitude of the beads left behind, divided by that of the member", "",
                "against the largest: difference of two steps"),
       number("log_beads", "log10 of beads")});
  const auto log = [](double x) { return std::log10(std::max(x, 1e-14)); };
  for (const Family& f : all)
    table.fill(f.members, [&](const Orbit<double>& m) -> Cells {
      const double tail = 2 * std::abs(std::sin(shift_time(m) / 2) * velocity_sum(m));
      const Estimate beads = with_error(beads_behind(m, 0.1), beads_behind(m, 0.05));
      return {f.k, f.sign, shift_time(m) / two_pi, m.energy, log(tail), beads, log(beads.value)};
    });
}

/**
Beside the orbits of type I, $k = 1$ to 6 with both signs, the chart shows those of type II on the five families. Along
a family the energy grows as the shift time falls.

| orbits of type II, $T/2\pi$ | first | second | third | fourth |
|---|---|---|---|---|
| $k = 1$, sign plus | [0.897407](cell:orbits/type=2/k=1/sign=1/number=1/turns) | [0.8329](cell:number=2/turns) | [0.7993](cell:number=3/turns) | [0.7258](cell:number=4/turns) |
| $k = 1$, sign minus | [0.897413](cell:orbits/type=2/k=1/sign=-1/number=1/turns) | [0.8328](cell:number=2/turns) | [0.7951](cell:number=3/turns) | [0.7289](cell:number=4/turns) |
| $k = 2$, sign plus | [1.940](cell:orbits/type=2/k=2/sign=1/number=1/turns) | [1.869](cell:number=2/turns) | [1.779](cell:number=3/turns) | [1.658](cell:number=4/turns) |
| energy, $k = 1$, plus | [1.31](cell:orbits/type=2/k=1/sign=1/number=1/energy) | [4.36](cell:number=2/energy) | [8.12](cell:number=3/energy) | [32.4](cell:number=4/energy) | */
void report_orbits(Report& report, const std::vector<Exact>& type_one,
                   const std::vector<Family>& all) {
  Table& table = report.table(
      "orbits",
      {count("type", "1 or 2"), count("k", "k of the type I orbit at which the family begins"),
       count("sign", "sign of the central velocity"),
       count("number", "place among the orbits of type II of the family; 0: type I"),
       estimate("turns", "shift time over 2 pi", "", "difference of two precisions; 0 where exact"),
       estimate("energy", "energy", "", "difference of two computations")});
  const auto add = [&](const Exact& e, std::size_t number) {
    table.add({e.type, e.k, e.sign, number, Estimate{e.time.value / two_pi, e.time.error / two_pi},
               e.energy});
  };
  for (const Exact& e : type_one)
    if (e.k <= 6) add(e, 0);
  for (const Family& f : all)
    for (std::size_t i = 0; i < f.found.size(); ++i) add(f.found[i], i + 1);
}

/**
## Soft and hard wells (figure x21)

At $s \ne 0$ the sum $Z$ does not merely rotate, and $T$ is an unknown. By the implicit function theorem an orbit whose
equations are regular continues to $s \ne 0$. We follow those of type I with the sign plus, $k = 1$, 2 and 3, by
pseudo-arclength, so that we pass *folds*, at which a branch turns back in $s$. In hard wells all three fold and come
back to an orbit of type II at $s = 0$, that of $k = 1$ after two more folds close to $s = 0$. The slower the orbit, the
later it folds: slow orbits are small and feel the quartic term less. So as far as we follow the branches of $k = 1$ and
2, they have no orbit at $s = 1$, where packets of impacts turn round in section 3.4.

<!-- travelling.wells -->
In hard wells the branches of the fastest exact travelling breathers of type I turn back in first folds, at $s =$
0.0103004 for $k = 1$, 0.325582 for $k = 2$ and 1.90266 for $k = 3$. (computed)
<!-- /travelling.wells -->

Those of the sign minus and of type II were not followed. The branches are shown for a limited number of steps within
$|s|\le3$ and $T\ge\pi$, which are our choice, or until Newton's method fails, which seems to happen where a bead of the
tail only just touches its neighbour.

![Exact breathers in soft and hard wells.](fig:x21) */
using Points = std::vector<std::pair<double, double>>;  // s and T/2pi

Points branch_points(const Orbit<double>& start, int direction, int steps) {
  Branch branch = branch_in_s(start, direction);
  Points points;
  try {
    for (int i = 0;; ++i, branch.advance()) {
      const Vector<double> x = branch.unknowns();
      const double s = branch.parameter(), turns = x[x.size() - 1] / two_pi;
      points.push_back({s, turns});
      if (i == steps || std::abs(s) > 3 || turns < 0.5) break;
    }
  } catch (const NewtonFailed&) {
    // the branch is shown up to there
  }
  return points;
}

void report_branches(Report& report, const std::vector<Exact>& starts) {
  // The folds (table `folds`) come from shorter steps than the branches
  std::vector<Estimate> folds(starts.size());
  std::vector<Points> hard(starts.size()), soft = hard;
  parallel_for(starts.size(), [&](std::size_t i) {
    folds[i] = fold_of(branch_in_s(starts[i].orbit, 1));
    hard[i] = branch_points(starts[i].orbit, 1, report.quick ? 8 : 40);
    soft[i] = branch_points(starts[i].orbit, -1, report.quick ? 2 : 10);
  });
  Table& table =
      report.table("branches", {count("k", "k of the orbit at which the branch begins, s = 0"),
                                count("direction", "direction in which s changes at the start"),
                                number("s", "anharmonicity of the well"),
                                number("turns", "shift time over 2 pi")});
  Table& first = report.table("folds");
  for (std::size_t i = 0; i < starts.size(); ++i) {
    first.add({{"k", "k of the orbit at which the branch begins, s = 0", starts[i].k},
               {"s", "anharmonicity at its first fold in hard wells", folds[i]}});
    for (const auto& [s, turns] : hard[i]) table.add({starts[i].k, 1, s, turns});
    for (const auto& [s, turns] : soft[i]) table.add({starts[i].k, -1, s, turns});
  }
}

/**
## The tail of a packet (figure x22)

Does an exact breather capture the packet of an impact in linear wells? Strike the first bead of a chain at rest. A bead
that the packet has passed oscillates like $z_n = y_n+i\dot y_n\propto e^{-it}$, and two numbers describe the tail: the
amplitude $|z_n|$, and the angle $\vartheta$ by which the phase turns from one bead to the next. For an exact breather
$\vartheta = T$, modulo $2\pi$. A packet need not do so: its *internal phase* may turn by the extra angle $T-\vartheta$
while its envelope moves on by a site. If $\vartheta$ tends to zero at another $T$, nothing is left behind either, but
one site further on the packet is the same only up to its phase.

A frame of sites moves with the packet, and beads far behind are dropped; without precompression there is no sound by
which they could catch up. The tail is read eleven sites behind the largest density. A row is written at twelve sites to
a decade, with means since the row before.

![The tail of an impact's packet weakens, and its speed and energy tend to the line through exact breathers.](fig:x22)

<!-- travelling.packets -->
Over sixteen thousand sites no exact orbit that we know captures the packets of two impacts on linear wells, $v_0 =
0.66$ and $1.5$. The beads left behind oscillate more and more in phase with their neighbours, and the tail decays with
this: over the last decade of sites with the exponent -0.721 after the weaker impact. Extrapolated, the shift times tend
to $T/2\pi =$ 1.157 and 0.847 ± 0.001. (observed)
<!-- /travelling.packets --> */
struct Frame {
  std::size_t sites, drop;  // how many beads it has, how many are dropped at a time
  double step;  // of the integrator, which has order six and corrects for contact events
};

/// A packet, row by row. Speed and energy are means since the row before.
struct PacketRow {
  double site, left, angle, speed, energy;  // `left` is |z_n|, `angle` is theta
};
using Course = std::vector<PacketRow>;

Course course_after(double v0, const Frame& frame, std::size_t rows) {
  const Chain chain{frame.sites};
  State<double> state(chain.sites);  // y_n = 0
  state.v[0] = v0;                   // Eq. (26)
  Course course;
  double begin_t = 0, begin_x = 0, energy = 0, samples = 0, dropped_energy = 0;
  for (std::size_t dropped = 0; course.size() < rows;) {
    evolve(EventCorrected{frame.step}, chain, state, 1);
    const std::vector<double> e = energy_density(chain, state);  // Eq. (23)
    const auto peak = front_packet(e);  // the foremost site with the largest density of eleven
    if (!peak || *peak < 13) continue;
    if (std::abs(state.v.back()) > 1e-9 * v0) throw Failure("the packet outruns its frame");
    if (std::abs(total(e) + dropped_energy - v0 * v0 / 2) > 1e-4 * v0 * v0 / 2)
      throw Failure("the energy in and behind the frame is not that of the impact");
    // The packet has thirteen sites; its centre is that of Eq. (24)
    const double x = energy_centre(e, *peak) + double(dropped);
    for (std::size_t n = *peak - 6; n <= *peak + 6; ++n) energy += e[n];
    ++samples;
    // A row, if it has come to the next site: what it leaves behind, and the means
    if (x >= 20 * std::pow(10.0, double(course.size()) / 12)) {
      const std::size_t n = *peak - 11;
      const std::complex<double> z(state.y[n], state.v[n]), behind(state.y[n - 1], state.v[n - 1]);
      course.push_back({x, std::abs(z), std::arg(z / behind), (x - begin_x) / (state.t - begin_t),
                        energy / samples});
      begin_t = state.t, begin_x = x, energy = samples = 0;
    }
    if (*peak + 20 > chain.sites) {
      move_on(state, frame.drop), dropped += frame.drop;
      dropped_energy += total(e) - total(energy_density(chain, state));
    }
  }
  return course;
}

/**
How should the tail fall? The pulse of force in one contact gives a bead the complex amplitude $g$, and that in the next
one takes it back, turned by $\vartheta$. So the bead keeps $|z| \simeq |\vartheta|\,|g|$, and with it the energy
$|z|^2/2$, which the packet loses. If the packet's energy is linear in $\vartheta$ and $|g|$ tends to a constant, then
$1/\vartheta$ grows linearly with $n$, and the tail falls like $1/n$. It does not yet: $1/\vartheta$ grows more and more
slowly (figure x22b), and over the last decade of sites the exponent of the tail is nearer to zero than $-1$. Its final
law is open.

Each impact is followed twice, the second time in a longer frame with half the step. The end of a packet is read off
straight lines in $\vartheta$ through the last half decade of sites, at $\vartheta = 0$. A quarter of a decade and a
whole one give other values; the larger difference is most of the error. */
constexpr std::array frames{Frame{64, 16, 0.2}, Frame{96, 16, 0.1}};
constexpr std::size_t decade = 12, half = 6, quarter = 3;  // rows

/// The straight line through the last rows, `intervals` of them and one more.
Line late_line(const Course& c, std::size_t intervals, auto x, auto y) {
  std::vector<double> xs, ys;
  for (std::size_t i = c.size() - 1 - intervals; i < c.size(); ++i)
    xs.push_back(std::invoke(x, c[i])), ys.push_back(std::invoke(y, c[i]));
  return fit_line(xs, ys);
}

double tail_exponent(const Course& c) {
  const auto site = [](const PacketRow& r) { return std::log10(r.site); };
  const auto left = [](const PacketRow& r) { return std::log10(r.left); };
  return late_line(c, decade, site, left).slope;
}

/// A function of the speed and the energy at theta = 0.
Estimate at_the_end(const TwoRuns<Course>& runs, auto of) {
  const auto end = [&](const Course& c, std::size_t rows) {
    return of(late_line(c, rows, &PacketRow::angle, &PacketRow::speed).intercept,
              late_line(c, rows, &PacketRow::angle, &PacketRow::energy).intercept);
  };
  Estimate e = with_error(end(runs.coarse, half), end(runs.fine, half));
  e.error += std::max(std::abs(end(runs.fine, quarter) - e.value),
                      std::abs(end(runs.fine, decade) - e.value));
  return e;
}

/**
We compare the end with the orbits of type I, single points in the plane of speed and energy. At small amplitude their
speed $c$ scales like $E^{1/4}$, and $cE^{-1/4}$ changes little from orbit to orbit. The *line of type I* is the
polynomial for it in $c$ through $k = 1$ to 7: between the points it holds no exact breather that we know, and beyond
$k = 1$ it is an extrapolation. Leaving out the slowest orbit gives its error.

One impact gives a packet that ends slower than the orbit $k = 1$, the other one that ends faster. Both end on the line,
but at shift times that are no multiples of $2\pi$. (The orbits of type II near the shift time of the faster one have
some ten times the energy, figure x19b.) Could an exact breather still capture the phase farther out? The orbit $k = 1$
pins it like a very weak pendulum: displaced a little, the phase swings by $2|\kappa|^{1/2}$ per shift, some $10^{-5}$,
and only a phase that turns not much faster could be captured. That of the weaker packet turns by $T-\vartheta$, modulo
$2\pi$, which at the end is nearly fifty thousand times as much.

| at the end | after $v_0 = 0.66$ | after $v_0 = 1.5$ |
|---|---|---|
| exponent of the tail | [-0.721](cell:packet_ends/velocity=0.66/tail_exponent) | [-0.68](cell:velocity=1.5/tail_exponent) |
| $T/2\pi$ | [1.1566 ± 0.0003](cell:packet_ends/velocity=0.66/turns) | [0.847 ± 0.001](cell:velocity=1.5/turns) |
| $cE^{-1/4}$ of the packet | [0.25467 ± 3e-5](cell:packet_ends/velocity=0.66/scaled_speed) | [0.2312 ± 0.0002](cell:velocity=1.5/scaled_speed) |
| $cE^{-1/4}$ on the line | [0.25466 ± 2e-5](cell:packet_ends/velocity=0.66/on_line) | [0.2312 ± 0.0001](cell:velocity=1.5/on_line) |
| turn of the internal phase per site | [0.887](cell:packet_ends/velocity=0.66/phase_turn) | [-1.09](cell:velocity=1.5/phase_turn) | */
using TypeOneLine = std::vector<std::pair<double, double>>;  // speed and scaled speed, k = 7 to 1

TypeOneLine line_of_type_one() {
  TypeOneLine line;
  TypeOneOrbits orbits(1);
  for (std::size_t k : {7, 6, 5, 4, 3, 2, 1}) {
    const double c = 1 / (two_pi * double(k));
    line.emplace_back(c, c / std::pow(orbits.orbit_at(k).energy, 0.25));
  }
  return line;
}

/// Lagrange's polynomial for the scaled speed at c, through all points from number `from` on.
double scaled_speed(const TypeOneLine& line, double c, std::size_t from = 0) {
  double sum = 0;
  for (std::size_t i = from; i < line.size(); ++i) {
    double w = line[i].second;
    for (std::size_t j = from; j < line.size(); ++j)
      if (j != i) w *= (c - line[j].first) / (line[i].first - line[j].first);
    sum += w;
  }
  return sum;
}

// Where each packet ends, and where the line is there
void report_ends(Report& report, const std::vector<double>& velocities,
                 const std::vector<TwoRuns<Course>>& runs, const TypeOneLine& line) {
  const auto turn = [](const Course& c) { return 1 / c.back().speed - c.back().angle - two_pi; };
  const char *two = "difference of two frames and steps",
             *end = "from two frames and steps, and from other stretches of the line";
  Table& table = report.table("packet_ends");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto on_line = [&](std::size_t from) {
      return at_the_end(runs[k], [&](double c, double) { return scaled_speed(line, c, from); });
    };
    Estimate there = on_line(0);
    there.error += std::abs(on_line(1).value - there.value);
    table.add(
        {{"velocity", "velocity of the impact", velocities[k]},
         {"turns", "shift time over 2 pi at theta = 0, extrapolated",
          at_the_end(runs[k], [](double c, double) { return 1 / (two_pi * c); }), "", end},
         {"scaled_speed", "c E^(-1/4) of the packet there",
          at_the_end(runs[k], [](double c, double energy) { return c / std::pow(energy, 0.25); }),
          "", end},
         {"on_line", "the same on the line of type I", there, "", end},
         {"tail_exponent", "exponent of the tail over the last decade of sites",
          runs[k].of(tail_exponent), "", two},
         {"phase_turn", "turn of the internal phase per site in the last row, T - theta - 2 pi",
          runs[k].of(turn), "", two}});
  }
}

// Row by row: the tail, its phase, and the packet
void report_courses(Report& report, const std::vector<double>& velocities,
                    const std::vector<TwoRuns<Course>>& runs) {
  const std::string two = "difference of two frames and steps";
  Table& table = report.table(
      "courses",
      {number("velocity", "velocity of the impact"), number("site", "centre of the packet", "site"),
       estimate("left", "amplitude of the bead left behind", "", two),
       estimate("angle", "phase difference between one bead left behind and the next", "",
                "against the largest: " + two),
       number("inverse_angle", "inverse of the angle"),
       number("turns", "mean shift time since the previous row, over 2 pi"),
       number("energy", "mean energy of the packet")});
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (std::size_t i = 0; i < runs[k].fine.size(); ++i) {
      const PacketRow &c = runs[k].coarse[i], &f = runs[k].fine[i];
      table.add({velocities[k], f.site, with_error(c.left, f.left), with_error(c.angle, f.angle),
                 1 / f.angle, 1 / (two_pi * f.speed), f.energy});
    }
}

void report_packets(Report& report) {
  const std::vector<double> impacts = report.quick ? std::vector{0.66} : std::vector{0.66, 1.5};
  std::vector<TwoRuns<Course>> runs(impacts.size());
  parallel_for(2 * impacts.size(), [&](std::size_t i) {
    (i % 2 ? runs[i / 2].fine : runs[i / 2].coarse) =
        course_after(impacts[i / 2], frames[i % 2], report.quick ? 24 : 36);
  });
  report_courses(report, impacts, runs);
  const TypeOneLine line = line_of_type_one();
  report_ends(report, impacts, runs, line);
  // The line as a curve in the plane of shift time and energy
  Table& table = report.table(
      "line_of_type_one", {count("exact", "1: an orbit, 0: a point between orbits"),
                           number("turns", "shift time over 2 pi"), number("energy", "energy")});
  for (int i = 0; i <= 41; ++i) {
    const double turns = i > 40 ? 1 : 0.8 + 0.0125 * i, c = 1 / (two_pi * turns);
    table.add({i > 40, turns, std::pow(c / scaled_speed(line, c), 4)});
  }
}

/**
## The limit of small amplitude

Do exact breathers survive at small amplitude? With $y_n = 2\epsilon\,\mathrm{Re}\,[A_ne^{it}]$ and the slow time $\tau
= \epsilon^{1/2}t$ the chain obeys the DpS equation (12), and a travelling breather becomes $A_n(\tau+\tau_T) =
e^{i\varphi}A_{n-1}(\tau)$. The sum $\sum A_n$ is conserved, so that either $\varphi = 0$ or $\sum A_n = 0$. The
equation has no scale of its own, and we choose $\tau_T = 2\pi$. Newton's method finds the breather of $\varphi = 0$ in
the same way as those of the chain, from the packet of an impact on a DpS chain (dps_travelling.hpp).

The chain's orbits of type I should tend to it as $k\to\infty$. Its energy is $E = 2\epsilon^2\sum|A_n|^2$ and its speed
$c = \epsilon^{1/2}/\tau_T$, so that $E/c^4$ does not depend on $\epsilon$. We extrapolate $ET^4$ of the orbits with the
sign plus by the parabola in $1/k$ through the last three; without the slowest orbit, $k = 20$, it gives the error. Two
equations and two integrators agree:

| limit of small amplitude | DpS equation | chain, $k\to\infty$ |
|---|---|---|
| $E/c^4$ | [65.55](cell:small_amplitude/equation=dps/energy) | [65.56 ± 0.01](cell:equation=chain/energy) | */
double limit_of(const std::vector<Exact>& orbits) {
  double sum = 0;
  for (std::size_t i = orbits.size() - 3; i < orbits.size(); ++i) {
    const double k = double(orbits[i].k);
    double w = orbits[i].energy.value * std::pow(two_pi * k, 4);
    for (std::size_t j = orbits.size() - 3; j < orbits.size(); ++j)
      if (j != i) w *= k / (k - double(orbits[j].k));
    sum += w;
  }
  return sum;
}

void report_small_amplitude(Report& report, const std::vector<Exact>& plus) {
  const auto dps = [](double tolerance) {
    const DpsTravelling problem{.tolerance = tolerance};
    const DpsMember breather = dps_member(problem, cut_dps_packet(40, problem.half_length));
    return 2 * breather.norm * std::pow(problem.shift_time, 4);
  };
  Table& table = report.table(
      "small_amplitude",
      {label("equation", "dps, or chain: its orbits of type I, extrapolated to k = infinity"),
       estimate("energy", "over the fourth power of the speed", "",
                "two tolerances, or without the slowest orbit")});
  table.add({"dps", with_error(dps(1e-12), dps(1e-13))});
  table.add({"chain", with_error(limit_of({plus.begin(), plus.end() - 1}), limit_of(plus))});
}

/**
## What is proved, and what is open

*Proved*: in linear wells $T = 2\pi k$ or $Z = 0$; no orbit of opposite sign in any symmetric well; an orbit of type I
for every $k$ (`sec5_kernel_equation`), and two for $k = 1$ (`sec5_enclosures`). *Computed*: the others, those of type
II and all in other wells, to the errors stated. *Open*: how the tail of a packet falls in the end; whether an exact
orbit captures a packet later than we follow these two; orbits that repeat themselves only after $m > 1$ sites. $Z$
still demands $T = 2\pi k$ of the latter, but it fixes only one of the $m$ complex amplitudes that such an orbit may
leave on successive beads, and $m-1$ conditions remain without an unknown.

That tails vanish at countably many speeds is known from chains of beads with resonators (Kevrekidis, Stefanov and Xu,
Letters in Mathematical Physics 106, 2016, arXiv:1502.01995); here the well itself is the resonator. In the DpS equation
travelling breathers were computed by James (Philosophical Transactions A 376, 20170138, 2018), who finds tails except
at particular parameters.

**To change it.** Families are the list in `families`, impacts that in `report_packets`, with frames in `frames`. The packets get wells as a second member of `Chain` in `course_after`; in others than linear ones the frequency of a passed
bead depends on its amplitude, and $\vartheta$ means less. */
void reproduce(Report& report) {
  std::vector<std::size_t> from_five{5, 6, 8};
  if (!report.quick) from_five.insert(from_five.end(), {10, 15, 20});
  std::array<std::vector<Exact>, 2> of_sign;
  parallel_for(2, [&](std::size_t i) { of_sign[i] = type_one_orbits(i ? -1 : 1, from_five); });
  std::vector<Exact> all = of_sign[0];
  all.insert(all.end(), of_sign[1].begin(), of_sign[1].end());
  const Exact &plus = orbit_of(all, 1, 1), &minus = orbit_of(all, 1, -1);
  // One orbit
  report_exactness(report, all);
  report_profiles(report, {plus, minus, orbit_of(all, 3, 1)});
  report_maps(report, plus);
  report_stability(report, {plus, minus});
  // Families in T and in s
  const std::vector<Family> found = families(report.quick);
  report_left_behind(report, found);
  report_orbits(report, all, found);
  std::vector<Exact> starts{plus};
  if (!report.quick) starts.insert(starts.end(), {orbit_of(all, 2, 1), orbit_of(all, 3, 1)});
  report_branches(report, starts);
  // Packets, and small amplitudes
  report_packets(report);
  report_small_amplitude(report, of_sign[0]);
}

/**
## Try it

1. *Easy.* Half the speed: which energy? `build/bin/sec5_travelling_breathers orbit --k 2` gives `energy` = 0.00581039.
   Hint: at small amplitude $E\propto T^{-4}$, a factor of 16. Is $k = 1$ a small amplitude?
2. *Harder.* Must the shift time be a multiple of $2\pi$ in soft wells?
   `build/bin/sec5_travelling_breathers orbit --s -0.3` gives `shift_time` = 6.48005.
   Hint: the forces of the wells no longer cancel in $Z$; $T$ is an unknown of Newton's method, and there is still no
   tail. */
int main(int argc, char** argv) {
  return run({"sec5_travelling_breathers", "5", "Exact travelling breathers (section 5)", reproduce,
              commands<OneOrbit>()},
             argc, argv);
}
