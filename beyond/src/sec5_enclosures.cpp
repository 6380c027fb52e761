/**
# 5 Breathers between bounds

Some results that section 3 computes with error bars can be proved. This chapter encloses breathers in intervals that
include all rounding errors: a map sends a ball around an approximate solution into itself and contracts distances in
it, so the ball contains exactly one exact solution.

![Both DpS breathers, the search for others, and what the proofs need.](fig:x25)

It begins with the static breathers of the DpS equation, whose instability, with a margin of five millionths, is one of
the closest cases of the article. Then it turns to the breathers of the chain itself, and to waves of the kernel
equation. */

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "report/program.hpp"
#include "sec5/chain_enclosure.hpp"
#include "sec5/dps_enclosure.hpp"
#include "sec5/wave_enclosure.hpp"

using namespace lattice;

/**
## Method

To solve $F(x) = 0$ we take the map $x \to x-AF(x)$ with an approximate inverse $A$ of the derivative. Let it move the
guess by at most $\eta$, and let it multiply distances in the ball of radius $\rho$ around it by $q(\rho)<1$ at most. If
$$\eta+q(\rho)\,\rho \le \rho,$$
the ball is sent into itself, and by Banach's theorem there is exactly one solution in it (contraction.hpp). $\eta$ and
$q$ are computed in intervals whose ends are rounded outwards (interval.hpp), with bounds for all that a finite
computation leaves out. The last panel of the figure draws $\eta/\rho+q(\rho)$ for the DpS breathers: it is below one
between two radii. Within the smaller one the solution lies; within the larger there is no other.

An interval becomes a value with an error: the middle, and half the width rounded up. This error is a bound, not an
estimate. */
Estimate estimate_of(const Interval<double>& x) {
  return {x.middle(), x.radius()};
}

/**
## What is proved about the DpS equation

Stationary solutions $v_n = u_ne^{i\mu t}$ of Eq. (11) obey Eq. (14). By scaling, $u = \mu^2u^{(1)}$, it
suffices to take $\mu = 1$. The *strain* of contact $n$ is $u_{n+1}-u_n = \pm(-1)^nr_n$. For each of the two centres,
on the infinite lattice:

1. There is a solution with the symmetry of this centre whose strains alternate in sign, decrease outwards in
   modulus and fall double-exponentially. They lie in the intervals of the tables `strains_site` and
   `strains_bond`.
2. Among the nonzero profiles of this symmetry whose strains alternate, tend to zero and do not increase outwards in
   modulus it is the only one, up to its sign.
3. Around a site the linearised equation has exactly one real pair $\pm\lambda$, of modulus
   [0.00156](num:sec5_enclosures.exponent_site); around a bond it has none. All other exponents are imaginary.
4. The bond-centred breather is orbitally stable in $\ell^2$: what starts close to it stays close to its
   multiples $e^{i\varphi}u$ for all times.
5. The energy of the site-centred breather minus that of the bond-centred one is positive at equal $\mu$,
   [2.85e-9](num:sec5_enclosures.barrier_equal_mu) at $\mu = 1$, and negative at equal norm, the physically relevant
   comparison, [-7.14e-10](num:sec5_enclosures.barrier_equal_norm).

Existence of both is known (James and Starosvetsky 2014). We prove nothing about solutions without these signs or
symmetries, nor whether the instability of the linearised equation implies that of the full one. */
struct Both {
  DpsBreather<double> site = enclose_dps<double>(Centre::site);
  DpsBreather<double> bond = enclose_dps<double>(Centre::bond);

  const DpsBreather<double>& of(Centre centre) const {
    return centre == Centre::site ? site : bond;
  }
};
constexpr std::pair<Centre, const char*> centres[] = {{Centre::site, "site"},
                                                      {Centre::bond, "bond"}};

/**
## Existence

The strains $r_n$ are sought with the contraction of dps_enclosure.hpp, from the profile that section 3.2 computes. That
profile is only a guess, and the proof would fail if it were wrong. The map contracts on all sequences of this symmetry
that differ from it by less than [0.00781](num:sec5_enclosures.unique_radius_site) in each contact (about a twelfth of
$r_0$), and it moves the guess by some $10^{-16}$. So the solution is that close to the guess, and the only one in the
large ball. Its components are then tightened until the tail, too, is known to many digits. The norms are
[0.00536](num:sec5_enclosures.norm_site) and [0.00536](num:sec5_enclosures.norm_bond), the largest displacements
[0.0504](num:sec5_enclosures.u0_site) and [0.0462](num:sec5_enclosures.u0_bond). */
void report_strains(Report& report, const DpsBreather<double>& b, const std::string& who) {
  Table& table = report.table(
      "strains" + who,
      {count("n", "contact, counted from the centre outwards"),
       number("lower", "lower bound of |u_(n+1) - u_n|, mu = 1"), number("upper", "upper bound"),
       number("relative", "width of the interval divided by the lower bound")});
  for (std::size_t n = 0; n < b.r.size(); ++n)
    table.add({n, b.r[n].lower, b.r[n].upper, (b.r[n].upper - b.r[n].lower) / b.r[n].lower});
}

// Norm and largest displacement follow from the strains
void report_profile(Quantities& facts, const DpsBreather<double>& b, const std::string& who) {
  facts.add("u0" + who, estimate_of(b.largest()), "at mu = 1");
  facts.add("norm" + who, estimate_of(b.norm()), "at mu = 1");
  facts.add("unique_radius" + who, exact(b.unique.radius), "strain");
}

/**
## Uniqueness

How many breathers of each kind are there? With $r_0$ given, the equation yields $r_1$, $r_2$ and so on, and each must
be positive and no larger than the one before. Intervals of $r_0$ are followed outwards until this fails, or until all
their profiles lie in the ball in which there is just one. Around a site [362](num:sec5_enclosures.discarded_site)
intervals are discarded and [60](num:sec5_enclosures.inside_site) end in the ball, around a bond
[480](num:sec5_enclosures.discarded_bond) and [68](num:sec5_enclosures.inside_bond). None remains; otherwise the program
would stop here. */
Table search_table(const std::vector<Piece<double>>& pieces) {
  Table table{{number("from", "lower end of the interval of r_0"), number("to", "upper end"),
               count("contact", "contact at which the interval is decided"),
               count("inside", "1 if its profiles lie in the ball of uniqueness, 0 if discarded")}};
  for (const Piece<double>& p : pieces)
    table.add({p.r_0.lower, p.r_0.upper, p.contact, std::int64_t(p.decision == Decision::inside)});
  return table;
}

void report_search(Report& report, const DpsBreather<double>& b, const std::string& who) {
  const auto pieces = search_profiles(b);
  const auto number_of = [&](Decision fate) {
    return std::count_if(pieces.begin(), pieces.end(),
                         [&](const Piece<double>& p) { return p.decision == fate; });
  };
  if (number_of(Decision::open) > 0) throw Failure("search for profiles: some intervals stay open");
  report.facts.add("discarded" + who, exact(double(number_of(Decision::discarded))), "intervals");
  report.facts.add("inside" + who, exact(double(number_of(Decision::inside))), "intervals");
  report.output.add("search" + who, search_table(pieces));
}

/**
## Stability

By section 3.3 all exponents follow from the eigenvalues $m$ of one matrix, $M = \nabla^T\mathrm{diag}(r_n^{1/2})\nabla$
with $(\nabla x)_n = x_{n+1}-x_n$, by $\lambda^2 = -(1-m)(1-\frac32m)$. $M$ is compact, its largest eigenvalue is $m_1 =
1$ and simple, and a real pair exists for each further $m > \frac23$. As many eigenvalues exceed $\frac23$ as the
elimination of $M-\frac23$ has positive pivots, and intervals give each pivot a certain sign:

$$\text{site: } m_2 > \tfrac23 > m_3,\qquad \text{bond: } \tfrac23 > m_2;$$
$m_2-\frac23$ is [4.85e-6](num:sec5_enclosures.margin_site) around a site and
[-4.85e-6](num:sec5_enclosures.margin_bond) around a bond. Why does that make the bond-centred breather stable in the
full equation (Weinstein 1986; Grillakis, Shatah and Strauss 1987)? Energy $H = \frac25\sum|v_{n+1}-v_n|^{5/2}$ and norm
$N = \sum|v_n|^2$ are conserved, and solutions exist for all times because the right side of Eq. (11) is locally
Lipschitz on $\ell^2$ and $N$ is bounded. Take $v = e^{i\varphi}(u+x+iy)$ with $N(v) = N(u)$ and with the phase that is
closest, so that $y\perp u$. Then $2\langle x,u\rangle = -|x|^2-|y|^2$: to first order $x\perp u$ as well. Since $H$ is
twice differentiable with a Hölder continuous second derivative,
$$H(u)-H(v) = \tfrac12\langle x,(1-\tfrac32M)x\rangle+\tfrac12\langle y,(1-M)y\rangle+O(|x|^{5/2}+|y|^{5/2}).$$
On $u^\perp$ the first form is at least $(1-\frac32m_2)|x|^2$ and the second $(1-m_2)|y|^2$, both positive.
So $H$ has a strict maximum at the orbit of $u$ among states of its norm, with a quadratic bound, and a
solution that starts close cannot leave. If its norm is slightly different, we compare it with $\mu^2u$ of
the same norm. */
void report_eigenvalues(Report& report, const DpsBreather<double>& b, const std::string& who) {
  Table& table = report.table("eigenvalues" + who,
                              {count("k", "index of the eigenvalue of M"),
                               number("lower", "lower bound"), number("upper", "upper bound")});
  for (std::size_t k = 1; k <= 4; ++k) {
    const Interval<double> m = contact_eigenvalue(b, k);
    table.add({k, m.lower, m.upper});
  }
}

/// The verdict, and the modulus of the translational pair.
void report_stability(Quantities& facts, const DpsBreather<double>& b, const std::string& who) {
  const Interval<double> edge = Interval<double>(2) / Interval<double>(3);
  const Interval<double> m2 = contact_eigenvalue(b, 2), m3 = contact_eigenvalue(b, 3);
  const bool decided =
      b.centre == Centre::site ? m2 > edge && m2 < Interval<double>(1) && m3 < edge : m2 < edge;
  if (!decided) throw Failure("stability of the DpS breather: the eigenvalues do not decide");
  facts.add("margin" + who, estimate_of(m2 - edge));
  facts.add("exponent" + who, estimate_of(root(abs(square_of_exponent(m2)))), "mu");
}

/**
## The barrier

The norms of both breathers agree to six digits. In intervals their difference keeps eight digits, and it has a
sign. The energy at equal norm has the opposite one: the bond-centred breather, the stable one, is the
higher of the two and, at fixed norm, a local *maximum* of $H$. [](finding:dps.enclosed) */
DpsBarrier<double> certain_barrier(const Both& both) {
  const DpsBarrier<double> barrier = dps_barrier(both.site, both.bond);
  if (!(barrier.equal_mu > Interval<double>(0) && barrier.equal_norm < Interval<double>(0)))
    throw Failure("barrier of the DpS equation: its signs are not decided");
  return barrier;
}

/**
## The breathers of the chain

The same lemma applies to the chain of Eqs. (6) and (10) in the linear well, $s = 0$, at $\omega_b = 1.1$
(chain_enclosure.hpp): unknown are now functions of time, the compressions of all contacts of the infinite chain in the
supremum norm. Proved, for each of the two centres: there is a periodic solution with this frequency and the symmetry of
its centre, even in time, which falls double-exponentially along the chain. It differs by no more than `radius` from the
guess, a sum of cosines, in each contact at each time, and among the solutions with these symmetries it is the only one
that differs by no more than `unique_radius`. Amplitude and energy follow. The table `bounds` has the constants of the
proof, all rounded upwards: $\beta \ge \|A\|-1$ (column `kappa`), the residual of the guess, $\eta \le
(1+\beta)\,$residual, and $q$.

The amplitudes are [0.0107](num:sec5_enclosures.amplitude_site) (site) and [0.00978](num:sec5_enclosures.amplitude_bond)
(bond), the energies [0.000154](num:sec5_enclosures.energy_site) and [0.000154](num:sec5_enclosures.energy_bond), whose
difference, of order $10^{-11}$, is far below what these intervals resolve. Nothing is proved about Floquet
multipliers. */
const std::pair<int, int> omega_b{11, 10};

Table bound_table(const Column& which) {
  return {{which, number("kappa", "beta: norm of the inverse minus one"),
           number("delta", "defect of the approximate inverse of the matrix"),
           number("epsilon", "error of the operator on piecewise linear functions"),
           number("residual", "residual of the approximation, in the supremum norm"),
           number("eta", "distance by which the map moves the approximation"),
           number("q", "contraction factor in the large ball"),
           number("unique_radius", "radius of the large ball, in which the solution is unique"),
           number("radius", "radius of the small ball, which contains the solution")}};
}

void report_chain(Report& report) {
  Table& bounds = report.output.add("bounds", bound_table(label("centre", "site or bond")));
  std::vector<ChainBreather> found(2);
  Fineness fine;
  if (report.quick) fine.samples /= 2, fine.harmonics /= 2;
  parallel_for(2, [&](std::size_t i) {
    found[i] = enclose_chain(centres[i].first, omega_b.first, omega_b.second, fine);
  });
  for (std::size_t i = 0; i < 2; ++i) {
    const ChainBreather& b = found[i];
    const std::string name = centres[i].second;
    bounds.add({name, b.inverse_excess, b.delta, b.epsilon, b.residual, b.unique.eta, b.unique.q,
                b.unique.radius, b.exists.radius});
    report.facts.add("amplitude_" + name, estimate_of(b.amplitude), "largest |y_n(0)|");
    report.facts.add("energy_" + name, estimate_of(b.energy));
    report.facts.add("chain_unique_radius_" + name, exact(b.unique.radius), "compression");
  }
}

/**
## The travelling breathers of the kernel equation

The travelling breathers of type I with $k = 1$ obey one scalar equation, $d = K*d_+^{3/2}$ with
$K(\sigma) = -\sin|\sigma|$ for $|\sigma| \le 2\pi$ (chapter on the kernel equation). Its theorem gives a wave, but
neither says that it is even nor that there is a second one. For each of the two signs of the central velocity it is
proved here (wave_enclosure.hpp): there is an even solution $d$, it differs by no more than `radius` from the guess
at all times, and it is the only even one within `unique_radius`. The guess is cubic on cells, its tail is zero, and
the true tail is bounded by the inequality of the theorem, $M(t+T) \le 4M(t)^{3/2}$.

Energy and peak follow with errors of the order of the small radius. The action $\int d_+^{5/2}dt$ is a critical
value, so that its error is of second order in the radius and is dominated by the residual. The actions of
the two signs therefore do not overlap, although they agree to ten digits. The energies are
[0.181](num:sec5_enclosures.wave_energy_plus) and [0.181](num:sec5_enclosures.wave_energy_minus), the peaks
[0.446](num:sec5_enclosures.wave_peak_plus) and [0.457](num:sec5_enclosures.wave_peak_minus), within
[1.78e-12](num:sec5_enclosures.wave_radius_plus) or [1.94e-12](num:sec5_enclosures.wave_radius_minus) at all times;
each is alone within [1.53e-5](num:sec5_enclosures.wave_unique_radius_plus). [](finding:travelling.two_waves) */
constexpr std::pair<int, const char*> signs[] = {{1, "plus"}, {-1, "minus"}};

void report_kernel_waves(Report& report) {
  Table& bounds =
      report.output.add("wave_bounds", bound_table(label("sign", "sign of the central velocity")));
  std::vector<EnclosedWave> found(2);
  WaveFineness fine;
  if (report.quick) fine.per_turn /= 4;
  parallel_for(2, [&](std::size_t i) { found[i] = enclose_wave(signs[i].first, fine); });
  for (std::size_t i = 0; i < 2; ++i) {
    const EnclosedWave& w = found[i];
    const std::string name = signs[i].second;
    bounds.add({name, w.inverse_excess, w.delta, w.epsilon, w.residual, w.unique.eta, w.unique.q,
                w.unique.radius, w.exists.radius});
    report.facts.add("wave_energy_" + name, estimate_of(w.energy));
    report.facts.add("wave_peak_" + name, estimate_of(w.peak), "largest compression");
    report.facts.add("wave_radius_" + name, exact(w.exists.radius), "compression");
    report.facts.add("wave_unique_radius_" + name, exact(w.unique.radius), "compression");
  }
  const Interval<double> action = found[0].action - found[1].action,
                         energy = found[0].energy - found[1].energy, zero;
  if (!report.quick && !(action < zero && energy < zero))
    throw Failure("waves of the kernel equation: their order is not decided");
  report.facts.add("wave_action_difference", estimate_of(action), "plus minus minus");
  report.facts.add("wave_energy_difference", estimate_of(energy), "plus minus minus");
}

// Between which radii the lemma proves something
void report_lemma(Report& report) {
  Table& table = report.table("lemma", {number("radius", "radius of the ball, in strains"),
                                        number("site", "eta / radius + q, site-centred"),
                                        number("bond", "the same, bond-centred")});
  const DpsGuess<double> site = dps_guess<double>(Centre::site),
                         bond = dps_guess<double>(Centre::bond);
  for (int k = -104; k <= -8; ++k) {
    const double radius = std::exp2(0.5 * k);
    table.add({radius, dps_eta(site) / radius + dps_q(site, radius),
               dps_eta(bond) / radius + dps_q(bond, radius)});
  }
}

/**
## With your own parameters

`sec5_enclosures dps --centre bond` prints the bounds for the DpS equation, `sec5_enclosures breather --centre site`
those for the chain and `sec5_enclosures wave --sign minus` those for the kernel equation. The barriers belong to
both centres. A quantity that cannot be certified is not printed. */
struct EnclosureTable {
  Table table{{label("quantity", "name of the enclosed quantity"), number("lower", "lower bound"),
               number("upper", "upper bound"), label("meaning", "meaning of the quantity")}};
  void add(const std::string& quantity, const Interval<double>& x, const std::string& meaning) {
    table.add({quantity, x.lower, x.upper, meaning});
  }
};

constexpr const char* certified = "A quantity that cannot be certified is not printed.";

struct EnclosedDps {
  static constexpr Title title{
      "dps", "rigorous bounds on a static breather of the DpS equation, mu = 1", certified};
  Centre centre = Centre::site;

  void parameters(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
  }
  Table table() const {
    const Both both;
    const DpsBreather<double>& b = both.of(centre);
    const DpsBarrier<double> barrier = certain_barrier(both);
    EnclosureTable bounds;
    bounds.add("u0", b.largest(), "largest |u_n| of the breather");
    bounds.add("norm", b.norm(), "sum of u_n^2 over all sites");
    bounds.add("second_eigenvalue", contact_eigenvalue(b, 2),
               "second largest eigenvalue of the linearised contacts, which decides the stability");
    bounds.add("exponent", root(abs(square_of_exponent(contact_eigenvalue(b, 2)))),
               "modulus of the exponent of the second eigenvalue, a growth rate if its square is "
               "positive");
    bounds.add("barrier_equal_mu", barrier.equal_mu,
               "H_site - H_bond of the two breathers at mu = 1");
    bounds.add("barrier_equal_norm", barrier.equal_norm,
               "H_site - H_bond at the norm of the bond-centred breather");
    return bounds.table;
  }
};

// For the chain there is one frequency, that of the article's example
struct EnclosedBreather {
  static constexpr Title title{
      "breather",
      "rigorous bounds on a static breather of the chain in linear wells, omega_b = 1.1",
      certified};
  Centre centre = Centre::site;

  void parameters(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
  }
  Table table() const {
    const ChainBreather b = enclose_chain(centre, omega_b.first, omega_b.second);
    EnclosureTable bounds;
    bounds.add("amplitude", b.amplitude,
               "largest displacement of a bead at t = 0, when all are at rest");
    bounds.add("energy", b.energy, "energy of the whole chain, Eq. (6)");
    return bounds.table;
  }
};

// The kernel equation is that of Hertzian contacts, alpha = 3/2, at k = 1
enum class Sign { plus = 1, minus = -1 };

struct EnclosedWaves {
  static constexpr Title title{
      "wave",
      "rigorous bounds on an exact travelling breather in linear wells, shift time T = 2 pi",
      certified};
  Sign sign = Sign::plus;

  void parameters(Parameters& p) {
    p.add("sign", sign, "sign of the central velocity",
          {{"plus", Sign::plus}, {"minus", Sign::minus}});
  }
  Table table() const {
    const EnclosedWave w = enclose_wave(int(sign));
    EnclosureTable bounds;
    bounds.add("energy", w.energy, "energy of the whole chain that carries the wave, Eq. (6)");
    bounds.add("peak", w.peak, "largest compression of a contact");
    bounds.add("action", w.action,
               "integral over all times of d_+^(5/2), with d the compression of a contact");
    return bounds.table;
  }
};

/**
## Differences and limits

The article computes such breathers without proof. A proof of this kind relies on its program, the compiler and the
arithmetic of the processor. It does not rely on the numbers that it starts from: guesses and approximate inverses may
come from anywhere, since the bounds are checked for them as they are. Whether the sign plus is the maximum of the
theorem remains open.

The interval arithmetic is tested on a million random operations against four-fold precision. Boost.Interval is put to
the same test and fails it without a special option of the compiler. A second program in another language, with the
intervals of the Python package mpmath and eighty digits, repeats for the DpS equation: existence, with the norm and the
largest displacement; the second eigenvalue, its exponent, and how many eigenvalues lie above $\frac23$; both barriers;
and the radius of uniqueness. Its intervals lie in ours. It does not repeat the search for other profiles, or anything
about the chain and the kernel equation, whose waves and breathers are only compared with those that Newton's method
finds. Errors that the tests introduce into the proof, one at a time, make it fail. */
void reproduce(Report& report) {
  const Both both;
  for (const auto& [centre, name] : centres) {
    const std::string who = std::string("_") + name;
    const DpsBreather<double>& b = both.of(centre);
    report_strains(report, b, who);
    report_eigenvalues(report, b, who);
    report_profile(report.facts, b, who);
    report_search(report, b, who);
    report_stability(report.facts, b, who);
  }
  const DpsBarrier<double> barrier = certain_barrier(both);
  report.facts.add("barrier_equal_mu", estimate_of(barrier.equal_mu), "energy at mu = 1");
  report.facts.add("barrier_equal_norm", estimate_of(barrier.equal_norm),
                   "energy at the norm of the bond-centred breather at mu = 1");
  report_lemma(report);
  report_chain(report);
  report_kernel_waves(report);
}

/**
## Try it

1. *Easy.* Does Newton's method find the wave that is enclosed?
   `build/bin/sec5_kernel_equation wave --sign minus` gives `peak` = 0.457321972291.
   Hint: `sec5_enclosures wave --sign minus` prints bounds; the value must lie between them, its own error included.
2. *Harder.* How much narrower would the energies of the chain's breathers have to be for their barrier to have a sign?
   `build/bin/sec32_barrier barrier --omega 1.1` gives `equal_frequency` = 1.62422e-11.
   Hint: compare with the widths that `sec5_enclosures breather` prints for both centres.
3. *Harder.* Has the barrier at equal area the sign of the DpS limit? `build/bin/sec32_barrier barrier --omega 1.01`
   gives `equal_area` = -7.99392e-18. Hint: the area takes the place of the norm. The enclosed `barrier_equal_norm` goes
   like $\mu^5$; does this one between $\omega_b-1 = 0.01$ and 0.1?
4. *Open.* Does the site-centred breather leave its place in the full DpS equation, as a theorem?
5. *Open.* The waves with $k \ge 2$: only the integrals of $|K|$ and $K_+$ change. How does the margin fall with $k$?
6. *Open.* Is there a third even wave at $k = 1$? The balls of uniqueness exclude it near the two known ones only. */
int main(int argc, char** argv) {
  return run({"sec5_enclosures", "5", "Breathers between bounds (section 5)", reproduce,
              commands<EnclosedDps, EnclosedBreather, EnclosedWaves>()},
             argc, argv);
}
