/**
# 5 Exact travelling breathers

An impact on the chain launches breathers that travel. Those of section 3.4 of James, Kevrekidis and Cuevas (Physica D
251, 2013) radiate a tail that weakens as they go. Section 5 leaves open whether one can compute exact ones, which after
a time $T$ are the same again, one site further:

      t = 0    .  .  o  O  o  .  .  .            y_n(t + T) = y_(n-1)(t)
      t = T    .  .  .  o  O  o  .  .            and nothing is left behind

In linear wells one can. Those that we find repeat themselves from site to site and have isolated speeds; a single sum
restricts which speeds are possible.

![Exact travelling breathers, and a packet that radiates a tail.](fig:x18) */

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_orbit.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/travelling.hpp"

using namespace lattice;

/**
## The question

The article generates travelling breathers by striking a chain and waiting, and calls the computation of exact ones by
Newton's method an interesting open problem. It prints no number for them. Two more chapters follow the exact orbits
into other wells and compare them with packets; the last one lists what is proved, computed and conjectured.

## Model

The wells are linear, later those of Eq. (10), and the contacts those of Eq. (9),
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2}.$$
All is dimensionless. $T$, the inverse of the speed, is called the *shift time* (`shift_time`); `sign` is that of the
velocity $\dot y_0(0)$ of the central bead; and `half_length` is $L$, where an orbit has the sites $-L \le n \le L+1$.

## Why only certain speeds

In linear wells the contact forces cancel in the sum $Z = \sum_n (y_n + i\dot y_n)$. If it converges absolutely, it only
rotates, $Z(t) = e^{-it}Z(0)$, and a shift by one site does not change it, so that $(e^{-iT}-1)Z = 0$: one of the two
factors vanishes. [](finding:travelling.speeds) An orbit with $T = 2\pi k$, which moves on by one site during $k$
oscillations of a free bead, is *type I*; one with $Z = 0$, at whatever $T$, is *type II*.

The same sum gives the tail that a packet radiates. A bead that has been passed keeps oscillating with the amplitude
$|\int e^{it}(f_{n-1}-f_n)\,dt|$, where $f_n$ is the force in the contact on its right. If these pulses repeat
themselves after $T$ from contact to contact, the amplitude is
$$|1-e^{-iT}|\,|g(1)|,\qquad g(1) = \int e^{it}f_0(t)\,dt.$$
It vanishes in just these two cases. The first factor does so for type I. As to the second, take the sum over the beads
beyond the contact alone: it is zero before the breather comes and all of $Z$ when it has gone through, and only the
pulse in the contact changes $e^{it}$ times this sum, so that $|g(1)| = |Z|$. The pulses of a packet that radiates
repeat themselves only approximately, so for it this is an order of magnitude (chapter on families).

## No orbit of opposite sign

Could an orbit return with the opposite sign after one site, $y_n(t+T) = -y_{n-1}(t)$? In wells with $W'(-y) = -W'(y)$
no localized one can. With $d_n = y_n-y_{n+1}$ the contact $n$ pushes with $(d_n)_+^{3/2}$ at $t$, and at $t+T$, where
its compression is $-d_{n-1}(t)$, with $(-d_{n-1})_+^{3/2}$: it is closed when the one before was open. So the sum of
Newton's law for the bead $n$ at $t+T$ and for the bead $n-1$ at $t$, whose left sides cancel, is
$$0 = (-d_{n-2})_+^{3/2}-(-d_{n-1})_+^{3/2}+(d_{n-2})_+^{3/2}-(d_{n-1})_+^{3/2} = |d_{n-2}|^{3/2}-|d_{n-1}|^{3/2}$$
at every $t$. At each instant all $|d_n|$ are equal; if the orbit is localized they vanish, and so does the orbit. In
other wells $W'(y_{n-1})+W'(-y_{n-1})$ takes the place of zero, and the argument fails.

## How orbits are found

This chapter finds orbits of type I, starting from the packet of an impact, cut out of the chain (travelling.hpp). Each
is computed in double precision and again in extended precision, which gives its errors. */
constexpr double two_pi = 2 * std::numbers::pi;
constexpr std::array signs{1, -1};  // of the central velocity

struct Exact {
  std::size_t k;
  int sign;
  Orbit<double> orbit;
  Orbit<long double> wide;

  Estimate energy() const { return compare(orbit.energy, double(wide.energy)); }
  double shift_time() const { return two_pi * double(k); }
};

/**
In extended precision the shift time must be $2\pi k$ to all digits. The derivative for Newton's method may come from
the orbit in double precision. */
Exact confirmed(std::size_t k, int sign, const Orbit<double>& orbit) {
  NewtonRule<long double> rule;
  rule.events.tolerance /= 2;
  return {k, sign, orbit,
          newton(type_one<long double>(k, orbit.start.y.size() / 2 - 1), orbit, rule)};
}

/// The orbits of type I with the given k, in ascending order, of one sign.
std::vector<Exact> type_one_orbits(int sign, const std::vector<std::size_t>& ks) {
  std::vector<Exact> found;
  TypeOneOrbits down(sign), up = down;
  for (auto k = ks.rbegin(); k != ks.rend(); ++k)
    if (*k <= TypeOneOrbits::first) found.push_back(confirmed(*k, sign, down.orbit_at(*k)));
  std::reverse(found.begin(), found.end());
  for (std::size_t k : ks)
    if (k > TypeOneOrbits::first) found.push_back(confirmed(k, sign, up.orbit_at(k)));
  return found;
}

/**
## How exact they are

How well do these orbits satisfy the equations? Newton's method solves all but one of them; that one, which reads
$\sin(T/2)\sum\dot y_n = 0$ (chapter on families), holds by itself at $T = 2\pi k$ and serves as a check. We
distinguish three residuals: that of the orbit in double precision, that of the extended orbit rounded to double, as
it can be printed, and that of the latter before rounding. The first two are evaluated in extended precision and for
all equations. A residual is rounding only, so its error is as large as itself. */
template <class T>
double residual_in_wide(const Exact& e, const Vector<T>& x_given) {
  const auto problem = with_free_time(type_one<long double>(e.k));
  const Vector<long double> x = with_time<long double>(x_given.template cast<long double>(),
                                                       2 * pi<long double>() * (long double)(e.k));
  return double(sup<long double>(problem.evaluate(x, {}, false).residual)) / e.orbit.amplitude;
}

/**
The energies deserve as much care as the residuals. The orbits of the two signs are nearly the same packet at two
phases of its internal oscillation. On the way from one to the other the energy changes, and the difference of both
is the barrier that pins the phase. */
void report_exactness(Report& report, const std::vector<Exact>& plus,
                      const std::vector<Exact>& minus) {
  double in_double = 0, rounded = 0, wide = 0;
  for (const auto* orbits : {&plus, &minus})
    for (const Exact& e : *orbits) {
      if (e.k > 3) continue;
      in_double = std::max(in_double, residual_in_wide(e, e.orbit.x));
      rounded = std::max(rounded, residual_in_wide<double>(e, e.wide.x.cast<double>()));
      wide = std::max(wide, e.wide.residual());
    }
  Quantities& facts = report.facts;
  facts.add("residual_double", {in_double, in_double},
            "largest of k = 1, 2, 3, relative to amplitude");
  facts.add("residual_rounded", {rounded, rounded}, "of the extended orbit rounded to double");
  facts.add("residual_wide", {wide, wide}, "largest of k = 1, 2, 3, relative to amplitude");
  facts.add("newton_steps_from_cut", exact(double(TypeOneOrbits(1).orbit().iterations())));
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
Orbit<double> lengthened(const Exact& e, std::size_t half_length) {
  Vector<double> x = Vector<double>::Zero(2 * Eigen::Index(half_length) + 1);
  const auto old = Eigen::Index(usual_half_length);
  x.head(old) = 1.01 * e.orbit.x.head(old);
  x.segment(Eigen::Index(half_length), old + 1) = 1.01 * e.orbit.x.tail(old + 1);
  return newton(type_one<double>(e.k, half_length), x);
}

constexpr std::size_t longer = 9, shorter = usual_half_length;

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
Each orbit shown is computed on both chains; the difference is the error in the table. */
void report_profiles(Report& report, const std::vector<Exact>& shown) {
  Table& table = report.table(
      "profiles",
      {count("k", "oscillations per site"), count("sign", "sign of the central velocity"),
       count("n", "site", "site"), number("y", "position at t = 0"),
       number("v", "velocity at t = 0"),
       estimate("log_size", "log10 of the larger of |y| and |v|, divided by the amplitude", "",
                "against the largest: difference of two chain lengths")});
  std::vector<Orbit<double>> orbits(2 * shown.size());
  parallel_for(orbits.size(), [&](std::size_t i) {
    orbits[i] = lengthened(shown[i / 2], i % 2 ? shorter : longer);
  });
  for (std::size_t i = 0; i < shown.size(); ++i)
    add_profile(table, shown[i], orbits[2 * i], orbits[2 * i + 1]);
}

/**
How does an exact orbit look? The maps compare its energy density with that of the packet of an impact at about the same
speed, on a logarithmic scale, on which a tail of a millionth would still be seen. */
void add_map(Table& table, int which, const Chain& chain, State<double> state, double from,
             double first_site) {
  const double duration = 12 * two_pi;
  evolve(EventCorrected{0.05}, chain, state, from, 1);
  const double start = state.t;
  evolve(EventCorrected{0.05}, chain, state, duration, 0.4, [&](const State<double>& now) {
    const auto e = energy_density(chain, now);
    for (int j = 0; j < 30; ++j)
      table.add(
          {which, now.t - start, j, std::log10(std::max(e[std::size_t(first_site + j)], 1e-14))});
  });
}

void report_maps(Report& report, const Exact& orbit) {
  Table& table = report.table(
      "maps", {count("packet", "0: exact breather, 1: packet of an impact"), number("t", "time"),
               count("n", "site", "site"), number("log_e", "log10 of the energy density")});
  const Chain chain{120};
  add_map(table, 0, chain, embed(orbit.orbit.start, chain.sites, 0), 0, 0);
  const double arrival = 47 * two_pi;  // the packet has then come to site 50 or so
  add_map(table, 1, chain, struck(chain.sites, 0.6676), arrival, 40);
}

/**
## The radiated tail, and stability

The equations cover one shift; now we let an orbit run on and measure the tail that it radiates. The multipliers per
shift, the eigenvalues of the flow over $T$ read one site further on, say whether small disturbances grow: the pair
$\lambda$, $1/\lambda$ of the internal phase by $\kappa = (\lambda+\lambda^{-1}-2)/4$, the phase being pinned if
$\kappa<0$ (travelling.hpp).

A long run is the strictest test that an orbit leaves nothing behind. For a thousand shifts an ordinary integrator is
cheaper; its error shows in the tail. The frame moves on by twenty sites at a time, and resting beads come in ahead. A
hundred shifts are repeated in one long chain by GSL, which shares nothing with our integrators. */
/// The largest of the beads that have been passed.
double passed(const State<double>& z, std::size_t shifts) {
  double left = 0;
  for (std::size_t n = 0; n + usual_half_length < shifts; ++n)
    left = std::max(left, std::hypot(z.y[n], z.v[n]));
  return left;
}

/**
After each round of twenty shifts we look at the beads that have been passed and drop them. */
double by_steps(const Exact& e, std::size_t shifts, double step) {
  constexpr std::size_t round = 20;
  const Chain chain{round + 3 * usual_half_length};
  State<double> state = embed(e.orbit.start, chain.sites, 0);
  const auto steps = std::size_t(std::ceil(e.shift_time() / step));
  double left = 0;
  for (std::size_t k = 0; k < shifts; k += round) {
    evolve(method_for(1e-12, step), chain, state, TimeGrid{round * e.shift_time(), round, steps});
    left = std::max(left, passed(state, round));
    move_on(state, round);
  }
  return left / e.orbit.amplitude;
}

/**
GSL needs no frame: its chain holds all the sites that the packet passes. */
double by_gsl(const Exact& e, std::size_t shifts, double tolerance) {
  const Chain chain{shifts + 3 * usual_half_length};
  State<double> state = embed(e.orbit.start, chain.sites, 0);
  evolve_reference(chain, state, double(shifts) * e.shift_time(), Tolerance(tolerance));
  return passed(state, shifts) / e.orbit.amplitude;
}

/**
We follow the fastest orbit of type I, $k = 1$, with the sign for which the phase is pinned; with the
other sign errors would grow. */
void report_long_runs(Report& report, const Exact& e) {
  const std::size_t many = report.quick ? 100 : 1000, few = report.quick ? 10 : 100;
  std::array<double, 4> left{};
  parallel_for(4, [&](std::size_t i) {
    left[i] = i < 2 ? by_steps(e, many, i ? 0.02 : 0.01) : by_gsl(e, few, i == 2 ? 1e-14 : 1e-12);
  });
  report.facts.add("left_by_thousand_shifts", compare(left[1], left[0]), "of the amplitude");
  report.facts.add("left_by_hundred_gsl", compare(left[3], left[2]), "of the amplitude");
}

/**
A small change of the speed neither grows nor dies out: two multipliers are one. Beside them two numbers describe the
stability of an orbit to first order, $\kappa$ of the phase, and the largest modulus of the others. These lie inside the
unit circle, though nothing is damped: in the co-moving frame a free oscillation of the beads is left behind, and the
disturbance with it. All this holds for disturbances of the eighteen sites of the breather.

## Results

Newton's method finds two exact travelling breathers, one of each sign, for every $k$ from 1 to 5 (and for 6, 8, 10, 15
and 20 in the next chapters). It finds the first in [6](num:sec5_travelling_breathers.newton_steps_from_cut) steps from
the cut packet. The residuals are [7e-14](num:sec5_travelling_breathers.residual_double) in double precision,
[3e-17](num:sec5_travelling_breathers.residual_wide) in extended precision and
[8e-17](num:sec5_travelling_breathers.residual_rounded) after rounding. A thousand shifts leave
[2e-14](num:sec5_travelling_breathers.left_by_thousand_shifts) of the amplitude behind, no more than the error of the
steps. That of $k = 1$, the fastest of type I, has the speed $1/(2\pi)$ and the energy
[0.181](num:sec5_travelling_breathers.energy_plus); with the other sign it is higher by only
[7.84e-11](num:sec5_travelling_breathers.energy_difference). This is the barrier that pins the internal phase, and the
multipliers agree: $\kappa =$ [-8.89e-11](num:sec5_travelling_breathers.kappa_k1_plus) with the sign plus,
[8.89e-11](num:sec5_travelling_breathers.kappa_k1_minus) with the sign minus, a growth of
[1.89e-5](num:sec5_travelling_breathers.growth_k1_minus) per shift. At $k = 2$ no $\kappa$ is left above the errors.
[](finding:travelling.stability) */
void report_stability(Report& report, const Exact& e) {
  const auto in_double = phase_and_rest(type_one<double>(e.k), e.orbit, {});
  const auto wide = phase_and_rest(type_one<long double>(e.k), e.wide, {});
  const std::string name = "_k" + std::to_string(e.k) + (e.sign > 0 ? "_plus" : "_minus");
  const Estimate kappa = compare(in_double.first, wide.first);
  report.facts.add("kappa" + name, kappa);
  if (kappa.value > kappa.error)
    report.facts.add("growth" + name,
                     {2 * std::asinh(std::sqrt(kappa.value)), kappa.error / std::sqrt(kappa.value)},
                     "per shift");
  report.facts.add("next_modulus" + name, compare(in_double.second, wide.second));
}

/**
## Differences and limits

A small residual is no proof that an orbit exists; for $k = 1$ the chapter on enclosures gives one. Orbits that repeat
themselves only after $m > 1$ sites, or never, were not looked for. For a shift by $m$ sites the sum $Z$ still demands
$T = 2\pi k$, and the speeds $m/2\pi k$ are dense: so this identity alone does not isolate speeds. But it fixes only one
of the $m$ complex amplitudes that such an orbit may leave on $m$ successive beads, and $m-1$ conditions remain without
an unknown to satisfy them. We therefore expect such orbits only at particular $s$ or exponents.

That tails vanish at countably many speeds, where the resonance meets a zero, is known from chains of beads with
resonators (Kevrekidis, Stefanov and Xu, Letters in Mathematical Physics 106, 2016, arXiv:1502.01995); here the well
itself is the resonator. In the DpS equation travelling breathers were computed by James (Philosophical Transactions A
376, 20170138, 2018), who finds tails except at particular parameters. Moving breathers on a tail, and the conditions
under which it vanishes, are discussed for other lattices by Flach and Kladko (Physica D 127, 61, 1999), Iooss and
Kirchgässner (Communications in Mathematical Physics 211, 439, 2000) and Sire and James (Physica D 204, 15, 2005). */
void reproduce(Report& report) {
  const std::vector<std::size_t> ks =
      report.quick ? std::vector<std::size_t>{1, 2, 3} : std::vector<std::size_t>{1, 2, 3, 4, 5};
  std::vector<std::vector<Exact>> all(2);
  parallel_for(2, [&](std::size_t i) { all[i] = type_one_orbits(signs[i], ks); });
  const Exact &plus = all[0].front(), &minus = all[1].front();
  report_exactness(report, all[0], all[1]);
  report_profiles(report, {plus, minus, all[0][2]});
  report_maps(report, plus);
  report_long_runs(report, plus);
  for (const auto& orbits : all)
    for (const Exact& e : {orbits[0], orbits[1]}) report_stability(report, e);
}

/**
## Try it

1. *Easy.* Half the speed: which energy? `build/bin/sec5_travelling_breathers orbit --k 2` gives `energy` = 0.00581039.
   Hint: at small amplitude $E\propto T^{-4}$, a factor of 16. Is $k = 1$ a small amplitude?
2. *Easy.* How high is the barrier that pins the internal phase?
   `build/bin/sec5_travelling_breathers orbit --sign minus` gives `energy` = 0.1808335136583.
   Hint: compare with the sign plus, digit by digit.
3. *Harder.* Must the shift time be a multiple of $2\pi$ in soft wells?
   `build/bin/sec5_travelling_breathers orbit --s -0.3` gives `shift_time` = 6.48005.
   Hint: the forces of the wells no longer cancel in $Z$; $T$ is an unknown of Newton's method, and there is still no
   tail.
4. *Harder.* And is that orbit stable further down?
   `build/bin/sec5_travelling_breathers orbit --s -1` gives `multiplier_modulus` = 1.000453.
   Hint: after how many shifts is a disturbance $e$ times as large? At $s = -0.3$ none grows.
5. *Open.* With the sign minus the phase is weakly unstable. What does it do after a hundred thousand shifts?
6. *Open.* Why do the energies of the two signs differ by so little, and by what law in $k$? */
int main(int argc, char** argv) {
  return run({"sec5_travelling_breathers", "5", "Exact travelling breathers (section 5)", reproduce,
              commands<OneOrbit>()},
             argc, argv);
}
