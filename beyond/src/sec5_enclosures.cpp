/**
# 5 Breathers between bounds

Do the breathers of section 3 exist on the infinite chain? Is the DpS breather around a site unstable, which its second
eigenvalue decides by five millionths? Do the two travelling waves of the preceding chapter differ? A number with an
error bar cannot prove it; bounds can. Here each number is an interval that contains the exact value, whatever was
rounded on the way; the digits in parentheses are the last ones of both ends. The answer is yes to all three, for the
linearised DpS equation, for breathers of the chain at $\omega_b = 1.1$ in linear wells, and for waves with $k = 1$.

| breather | quantity | around a site | around a bond |
|---|---|---|---|
| DpS, $\mu = 1$ | largest displacement | [0.05041478528092(235 to 301)](cell:dps_breathers/centre=site/u0) | [0.046232303401288(09 to 63)](cell:centre=bond/u0) |
| | norm | [0.00536042022797(0922 to 1055)](cell:dps_breathers/centre=site/norm) | [0.005360413092700(729 to 843)](cell:centre=bond/norm) |
| | second eigenvalue $m_2$ minus $\frac23$ | [4.8529766(071 to 191)e-6](cell:dps_breathers/centre=site/margin) | [-4.85326567(77 to 19)e-6](cell:centre=bond/margin) |
| chain, $\omega_b = 1.1$ | amplitude | [0.0107479(07 to 98)](cell:chain_breathers/centre=site/amplitude) | [0.0097842(646 to 707)](cell:centre=bond/amplitude) |
| | energy | [0.00015359(71 to 99)](cell:chain_breathers/centre=site/energy) | [0.00015359(785 to 916)](cell:centre=bond/energy) |

| travelling wave, $T = 2\pi$ | sign plus | sign minus |
|---|---|---|
| peak | [0.44624885825(58 to 95)](cell:waves/sign=plus/peak) | [0.4573219722(890 to 930)](cell:sign=minus/peak) |
| energy | [0.1808335135(734 to 864)](cell:waves/sign=plus/energy) | [0.1808335136(522 to 644)](cell:sign=minus/energy) |
| action | [0.48606403649(35 to 63)](cell:waves/sign=plus/action) | [0.4860640365(179 to 207)](cell:sign=minus/action) |

One proof, that of the DpS breathers, is written out with its code. The others repeat it. */

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
using namespace report;

using Number = Interval<double>;
using Numbers = std::vector<Number>;

/**
## The equation

A stationary solution $v_n = u_ne^{i\mu t}$ of Eq. (11) obeys Eq. (14), and by scaling, $u = \mu^2u^{(1)}$, it suffices
to take $\mu = 1$. Where neighbours move in opposite directions, $u_{n+1}-u_n = \pm(-1)^nr_n$ with *strains* $r_n > 0$,
and Eq. (14) says
$$F(r)_n = r_n - [\varphi(r_{n-1}) + 2\varphi(r_n) + \varphi(r_{n+1})] = 0,\qquad \varphi(x) = x|x|^{1/2}.$$
Conversely every bounded zero of $F$ gives a solution, $|u_n| = \varphi(r_{n-1})+\varphi(r_n)$. Contact $n$ lies between
the sites $n$ and $n+1$. Around a bond $r_{-n} = r_n$, around a site $r_{-1-n} = r_n$, so the contacts $n \ge 0$
suffice. On bounded sequences, with the largest modulus as the norm, $F$ is continuously differentiable, $\varphi' =
\frac32|x|^{1/2}$.

Section 3.2 computes a profile $c$. We keep twelve contacts of it, zero behind, and take for $A$ an approximate inverse
of $DF(c)$ on these twelve and the identity behind them. Let the map $r \mapsto r-AF(r)$ move the guess by at most
$\eta$, and let it multiply distances in the ball of radius $\rho$ around it by at most $q$. If
$$\eta+q\,\rho \le \rho,\qquad q < 1,$$
it maps the ball into itself, and by Banach's theorem the ball contains exactly one fixed point. That is a zero of $F$,
since $q < 1$ makes $A$ invertible (contraction.hpp). Guess and inverse may come from anywhere: the proof would fail if
they were wrong. */
/// A F(c) in the window; the first contact behind it has the strain `after`.
Numbers newton_step(const DpsGuess& guess, const Number& after) {
  const Numbers c = ball(guess, 0);
  Numbers out(c.size());
  for (std::size_t j = 0; j < c.size(); ++j) {
    const Number residual = c[j] - pull(guess.centre, c, j, after);
    for (std::size_t i = 0; i < c.size(); ++i) out[i] += guess.inverse[i][j] * residual;
  }
  return out;
}

/// eta, which is at least |A F(c)|.
double dps_eta(const DpsGuess& guess) {
  // Behind the window the guess is zero, and only the first contact there is pulled
  double eta = phi(guess.r.back()).upper;
  for (const Number& x : newton_step(guess, 0)) eta = std::max(eta, magnitude(x));
  return eta;
}

/**
The factor $q$ is the largest sum of moduli in a row of $1-A\,DF(r)$, for all $r$ in the ball. In intervals this is one
evaluation of $DF$ with each strain replaced by its range. */
/// 1 - A DF over ranges of the strains, in the window.
std::vector<Numbers> remainder(const DpsGuess& guess, const Numbers& r) {
  const auto df = dps_derivative(guess.centre, r);
  const std::size_t n = r.size();
  std::vector<Numbers> out(n, Numbers(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) out[i][j] = 1;
      for (std::size_t k = 0; k < n; ++k) out[i][j] -= guess.inverse[i][k] * df[k][j];
    }
  return out;
}

/// q, which is at least |1 - A DF(r)| for all r in the ball.
double dps_q(const DpsGuess& guess, double radius) {
  const Numbers r = ball(guess, radius);
  const Number behind{-radius, radius};
  const auto matrix = remainder(guess, r);
  // Behind the window: the first contact sees the last of the window, the others only the tail
  Number q = phi_slope(abs(r.back())) + 3 * phi_slope(behind);
  q = hull(q, 4 * phi_slope(behind));
  double worst = magnitude(q);
  for (std::size_t i = 0; i < r.size(); ++i) {
    // The last contact of the window is pulled by the first behind it
    Number sum = abs(Number(guess.inverse[i].back())) * phi_slope(behind);
    for (const Number& entry : matrix[i]) sum += abs(entry);
    worst = std::max(worst, sum.upper);
  }
  return worst;
}

/// The inequality, for the largest ball that fulfils it and for a small one. Throws NotProved.
std::pair<Contraction, Contraction> dps_lemma(const DpsGuess& guess) {
  return two_balls(dps_eta(guess), 0.0625, [&](double radius) { return dps_q(guess, radius); });
}

/**
## Where the inequality holds

![Both DpS breathers, the search for others, and where the inequality holds.](fig:x25)

Panel c draws $\eta/\rho+q(\rho)$. It is below one between two radii: within the smaller, some $10^{-16}$, the solution
lies; within the larger, [0.00781](cell:dps_breathers/centre=site/unique_radius), there is no other. The latter is less
than a tenth of $r_0$. */
void report_lemma(Report& report) {
  Table& table = report.table("lemma", {number("radius", "radius of the ball, in strains"),
                                        number("site", "eta / radius + q, site-centred"),
                                        number("bond", "the same, bond-centred")});
  const DpsGuess site = dps_guess(Centre::site), bond = dps_guess(Centre::bond);
  for (int k = -104; k <= -8; ++k) {
    const double radius = std::exp2(0.5 * k);
    table.add({radius, dps_eta(site) / radius + dps_q(site, radius),
               dps_eta(bond) / radius + dps_q(bond, radius)});
  }
}

/**
## Signs and digits

The ball leaves open what sign the small strains have. Let $r_j$ be certainly positive, let $|r_n| < \frac1{16}$ for all
$n > j$, and let $-z$ be the infimum of these. If $z$ were positive, the equation would give $r_n \ge -4\varphi(z)$ for
all of them, hence $z \le 4z^{3/2} < z$. So they are not negative, and by the equation positive one after the other. */
/// Clips the strains at zero where that argument allows it. Throws NotProved where it does not.
void demand_no_negative(DpsBreather& b) {
  double largest = magnitude(b.tail);
  std::size_t m = b.r.size();
  while (m > 0 && magnitude(b.r[m - 1]) < 0.0625) largest = std::max(largest, magnitude(b.r[--m]));
  if (!(largest < 0.0625)) throw NotProved("the strains cannot be shown to be small");
  for (std::size_t n = 0; n < std::max<std::size_t>(m, 1); ++n)
    if (!(b.r[n].lower > 0)) throw NotProved("the central strains cannot be shown to be positive");
  for (Number& r : b.r) r = positive_part(r);
  b.tail = positive_part(b.tail);
}

/**
The solution is a fixed point, so each of its strains lies in the interval that the map makes of the ball, in the form
of the mean value. Repeated, that gives the last digits. A mean value is taken on the way from the guess to the
solution, so the intervals have to hold both. */
/// Each strain as narrow as repeated images make it.
void tighten(const DpsGuess& guess, DpsBreather& b) {
  Numbers& r = b.r;
  for (int round = 0; round < 20; ++round) {
    const auto shift = newton_step(guess, b.tail);
    Numbers segment;
    for (std::size_t i = 0; i < r.size(); ++i) segment.push_back(hull(r[i], Number(guess.r[i])));
    const auto matrix = remainder(guess, segment);
    Numbers image(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      image[i] = guess.r[i] - shift[i];
      for (std::size_t j = 0; j < r.size(); ++j) image[i] += matrix[i][j] * (r[j] - guess.r[j]);
    }
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = common(r[i], image[i]);
    // From outside inwards the equation itself is sharper where strains are small
    for (std::size_t i = r.size(); i-- > 1;) r[i] = common(r[i], pull(b.centre, r, i, b.tail));
    b.tail = common(b.tail, Number(0, (phi(r.back()) + 3 * phi(b.tail)).upper));
  }
}

/**
That strains decrease in the window is read from the intervals. Beyond, let $r_n$ be the largest strain from $n$ on.
Then $R = \sup_{j>n}r_j$ obeys $R \le r_n^{3/2}+3R^{3/2}$ and $\sup_{j>n+1}r_j \le R^{3/2}/(1-3\sqrt R) < r_n^{3/2} \le
r_{n+1}$ if $R < \frac1{100}$, so that $r_{n+1}$ is the largest from $n+1$ on. With $r_n^{3/2} \le r_{n+1} \le
r_n^{3/2}/(1-3\sqrt{r_{n+1}})$ the tail falls double-exponentially. */
/// Positive, decreasing, and the tail below 1/100. Throws NotProved otherwise.
void demand_decrease(const DpsBreather& b) {
  for (std::size_t i = 0; i < b.r.size(); ++i) {
    const Number& next = i + 1 < b.r.size() ? b.r[i + 1] : b.tail;
    if (empty(b.r[i]) || !(b.r[i] > Number(0)) || !(next < b.r[i]))
      throw NotProved("the strains cannot be shown to decrease");
  }
  if (!(b.tail.upper < 0.01)) throw NotProved("the tail cannot be shown to be small");
}

/// The whole proof: the inequality, the signs, the digits, and that strains decrease. Throws NotProved.
DpsBreather enclose_dps(Centre centre) {
  const DpsGuess guess = dps_guess(centre);
  const auto [unique, exists] = dps_lemma(guess);
  DpsBreather b{
      centre, unique, exists, ball(guess, exists.radius), {-exists.radius, exists.radius}};
  demand_no_negative(b);
  tighten(guess, b);
  demand_decrease(b);
  return b;
}

/**
So for each of the two centres there is a DpS breather on the infinite lattice whose strains alternate in sign, decrease
outwards and fall double-exponentially (panel a). Existence was known (James and Starosvetsky 2014); bounds we have not
found elsewhere. In tables a bound is the middle of the interval, with half of its width, rounded up, as the error. */
struct Bound {
  const char* quantity;
  Number x;
  const char* meaning;
};
using Bounds = std::vector<Bound>;

constexpr const char* half_width = "half of the width of the interval, rounded up";

Estimate enclosed(const Number& x) {
  return {x.middle(), x.radius()};
}

/// These columns behind those of `row`.
Row with(const Bounds& bounds, Row row = {}) {
  for (const auto& [quantity, x, meaning] : bounds)
    row.cells.push_back({quantity, meaning, enclosed(x), "", half_width});
  return row;
}

void report_strains(Report& report, const DpsBreather& b, const std::string& centre) {
  Table& table = report.table(
      "strains_" + centre,
      {count("n", "contact, counted from the centre outwards"),
       number("lower", "lower bound of |u_(n+1) - u_n|, mu = 1"), number("upper", "upper bound"),
       number("relative", "width of the interval divided by the lower bound")});
  for (std::size_t n = 0; n < b.r.size(); ++n)
    table.add({n, b.r[n].lower, b.r[n].upper, (b.r[n].upper - b.r[n].lower) / b.r[n].lower});
}

/**
## No other profile

With $r_0$ given, the equation yields $r_1$, $r_2$ and so on, and each must be positive and no larger than the one
before; at the centre this leaves $\frac1{16} \le r_0 \le \frac14$. Intervals of $r_0$ in this range are followed
outwards until a requirement fails, or until all their profiles lie in the ball in which there is just one (panel b;
search_profiles in dps_enclosure.hpp). No interval stays undecided. So among the nonzero profiles of this
symmetry whose strains alternate, tend to zero and do not increase outwards the breather is the only one, up to its
sign. */
void report_search(Report& report, const DpsBreather& b, const std::string& centre) {
  Table& table =
      report.table("search_" + centre,
                   {number("from", "lower end of the interval of r_0"), number("to", "upper end"),
                    count("contact", "contact at which the interval is decided"),
                    count("inside",
                          "1 if its profiles lie in the ball of uniqueness, "
                          "0 if discarded")});
  for (const Piece& p : search_profiles(b)) {
    if (p.decision == Decision::open) throw Failure("search for profiles: an interval stays open");
    table.add({p.r_0.lower, p.r_0.upper, p.contact, std::int64_t(p.decision == Decision::inside)});
  }
}

/**
## Stability

By section 3.3 all exponents follow from the eigenvalues $m$ of one matrix, $M = \nabla^T\mathrm{diag}(r_n^{1/2})\nabla$
with $(\nabla x)_n = x_{n+1}-x_n$, by $\lambda^2 = -(1-m)(1-\frac32m)$. $M$ is compact, its largest eigenvalue is $m_1 =
1$ and simple, and a real pair exists for each further $m > \frac23$. As many eigenvalues exceed $\frac23$ as the
elimination of $M-\frac23$ has positive pivots, and intervals give each pivot a certain sign:
$$\text{site: } m_2 > \tfrac23 > m_3,\qquad \text{bond: } \tfrac23 > m_2.$$
Around a site the linearised equation has exactly one real pair, of modulus
[0.00156](cell:dps_breathers/centre=site/exponent); around a bond it has none.

The bond-centred breather is even stable in the full equation: what starts close to it in $\ell^2$ stays close to its
multiples $e^{i\theta}u$ for all times. The argument is the one for which Weinstein (1986) and Grillakis, Shatah and
Strauss (1987) are known. Energy $H = \frac25\sum|v_{n+1}-v_n|^{5/2}$ and norm $N = \sum|v_n|^2$ are conserved, and
solutions exist for all times because the right side of Eq. (11) is locally Lipschitz on $\ell^2$ and $N$ is bounded.
Take $v = e^{i\theta}(u+x+iy)$ with $N(v) = N(u)$ and with the phase that is closest, so that $y\perp u$. Then $2\langle
x,u\rangle = -|x|^2-|y|^2$: to first order $x\perp u$ as well. Since $H$ is twice differentiable with a Hölder
continuous second derivative,
$$H(u)-H(v) = \tfrac12\langle x,(1-\tfrac32M)x\rangle+\tfrac12\langle y,(1-M)y\rangle+O(|x|^{5/2}+|y|^{5/2}).$$
On $u^\perp$ the first form is at least $(1-\frac32m_2)|x|^2$ and the second $(1-m_2)|y|^2$, both positive.
So $H$ has a strict maximum at the orbit of $u$ among states of its norm, with a quadratic bound, and a
solution that starts close cannot leave. If its norm is slightly different, we compare it with $\mu^2u$ of
the same norm. */
Bounds bounds_of(const DpsBreather& b) {
  const Number edge = Number(2) / Number(3);
  const Number m2 = contact_eigenvalue(b, 2), m3 = contact_eigenvalue(b, 3);
  const bool decided =
      b.centre == Centre::site ? m2 > edge && m2 < Number(1) && m3 < edge : m2 < edge;
  if (!decided) throw Failure("stability of the DpS breather: the eigenvalues do not decide");
  return {{"u0", b.largest(), "largest |u_n|, mu = 1"},
          {"norm", b.norm(), "sum of u_n^2 over all sites"},
          {"second_eigenvalue", m2,
           "second largest eigenvalue of the linearised contacts, which decides the stability"},
          {"margin", m2 - edge, "the same minus 2/3"},
          {"exponent", root(abs(square_of_exponent(m2))),
           "modulus of the exponent of the second eigenvalue, a growth rate if its square is "
           "positive"}};
}

/**
## The barrier

The norms of both breathers agree to five digits. In intervals their difference keeps eight digits, and it has a sign:
the energy of the site-centred breather minus that of the bond-centred one is
[2.85e-9](cell:dps_barrier/equal_mu) at $\mu = 1$. At equal norm, the physically relevant comparison, it is
[-7.14e-10](cell:dps_barrier/equal_norm). There the bond-centred breather, the stable one, is the higher of
the two and a local *maximum* of $H$.

<!-- dps.enclosed -->
On the infinite lattice the DpS equation has a site-centred and a bond-centred breather. The equation linearised about
the site-centred one has exactly one real pair of exponents, $\pm$0.001558 $\mu$; about the bond-centred one it has no
real pair, and the bond-centred breather is orbitally stable. The energy of the site-centred breather minus that of the
bond-centred one is 2.854e-9 at $\mu = 1$ and -7.135e-10 at equal norm. (enclosed)
<!-- /dps.enclosed --> */
Bounds bounds_of(const DpsBarrier& barrier) {
  if (!(barrier.equal_mu > Number(0) && barrier.equal_norm < Number(0)))
    throw Failure("barrier of the DpS equation: its signs are not decided");
  return {{"equal_mu", barrier.equal_mu, "H_site - H_bond of the two breathers at mu = 1"},
          {"equal_norm", barrier.equal_norm,
           "H_site - H_bond at the norm of the bond-centred breather"}};
}

constexpr std::pair<Centre, const char*> centres[] = {{Centre::site, "site"},
                                                      {Centre::bond, "bond"}};

void report_dps(Report& report) {
  Table& breathers = report.table("dps_breathers");
  const DpsBreather both[] = {enclose_dps(Centre::site), enclose_dps(Centre::bond)};
  for (std::size_t i = 0; i < 2; ++i) {
    const DpsBreather& b = both[i];
    const char* centre = centres[i].second;
    report_strains(report, b, centre);
    report_search(report, b, centre);
    breathers.add(with(bounds_of(b), {{"centre", "where the breather is centred", centre},
                                      {"unique_radius", "strains of no other one are so near",
                                       exact(b.unique.radius), "", "exact"}}));
  }
  report.table("dps_barrier").add(with(bounds_of(dps_barrier(both[0], both[1]))));
}

/**
## The breathers of the chain

The same lemma serves Eqs. (6) and (10) in the linear well, $s = 0$, at $\omega_b = 1.1$ (chain_enclosure.hpp). The
unknowns are now functions of time, the compressions of all contacts, and the guess is a sum of cosines. For each of the
two centres there is a periodic solution with this frequency and the symmetry of its centre, even in time, which falls
double-exponentially along the chain. The table `constants` has what the proof needs, rounded upwards: $\beta \ge
\|A\|-1$, the errors $\delta$ and $\epsilon$ of the approximate inverse, the residual, $\eta \le (1+\beta)\,$residual,
and $q$. The energies differ by $10^{-11}$, far less than their bounds resolve, and nothing is proved about Floquet
multipliers. */
const std::pair<int, int> omega_b{11, 10};

Columns constants() {
  return {label("solution",
                "site- or bond-centred breather of the chain, travelling wave by its "
                "sign"),
          number("beta", "norm of the approximate inverse minus one"),
          number("delta", "defect of the approximate inverse of the matrix"),
          number("epsilon", "error of the operator on piecewise linear functions"),
          number("residual", "residual of the approximation, in the supremum norm"),
          number("eta", "distance by which the map moves the approximation"),
          number("q", "contraction factor in the large ball"),
          estimate("unique_radius", "radius of the large ball, in which the solution is unique", "",
                   "exact"),
          estimate("radius", "radius of the small ball, which contains the solution", "", "exact")};
}

void add_constants(Table& table, const std::string& solution, const Enclosure& e) {
  table.add({solution, e.inverse.beta, e.inverse.delta, e.inverse.epsilon, e.residual, e.unique.eta,
             e.unique.q, exact(e.unique.radius), exact(e.exists.radius)});
}

Bounds bounds_of(const ChainBreather& b) {
  return {{"amplitude", b.amplitude, "largest |y_n| at t = 0, when all beads are at rest"},
          {"energy", b.energy, "energy of the whole chain, Eq. (6)"}};
}

void report_chain(Report& report, Table& constants) {
  ChainBreather found[2];
  Fineness fine;
  if (report.quick) fine.samples /= 2, fine.harmonics /= 2;
  parallel_for(2, [&](std::size_t i) {
    found[i] = enclose_chain(centres[i].first, omega_b.first, omega_b.second, fine);
  });
  Table& breathers = report.table("chain_breathers");
  for (std::size_t i = 0; i < 2; ++i) {
    const char* centre = centres[i].second;
    breathers.add(with(bounds_of(found[i]), {{"centre", "where it is centred", centre}}));
    add_constants(constants, centre, found[i]);
  }
}

/**
## The travelling waves

The theorem of the preceding chapter gives one wave of $d = K*d_+^{3/2}$, $K(\sigma) = -\sin|\sigma|$ for $|\sigma| \le
2\pi$, but neither says that it is even nor that there is a second one. For each of the two signs of the central
velocity it is proved here (wave_enclosure.hpp) that there is an even solution $d$ in a ball of the radius
[1.78e-12](cell:constants/solution=plus/radius) (plus) or [1.94e-12](cell:constants/solution=minus/radius) (minus)
around the guess, in the largest modulus over all times, and that it is the only even one in a ball of the radius
[1.53e-5](cell:constants/solution=plus/unique_radius). The guess is cubic on cells, its tail is zero, and the true tail
is bounded by the inequality of the theorem: one shift later the largest compression is at most four times its power
$3/2$.

Energy and peak are uncertain by the order of the small radius. The action $\int d_+^{5/2}dt$ is a critical value, so
its error is of second order in the radius and is dominated by the residual. The actions of the two signs agree to ten
digits and yet do not overlap.

<!-- travelling.two_waves -->
For Hertzian contacts, linear wells and $T = 2\pi$ there are at least two exact travelling breathers, one with either
sign of the central velocity. The energy of the one with the sign plus, minus that of the one with the sign minus, is
(-9.1 to -6.5)e-11; the corresponding difference of their actions is -2.(72 to 16)e-11. The signs of both differences
are proved, so the breather with the sign minus is not the maximizer of the existence theorem. (enclosed)
<!-- /travelling.two_waves --> */
constexpr std::pair<int, const char*> signs[] = {{1, "plus"}, {-1, "minus"}};

Bounds bounds_of(const EnclosedWave& w) {
  return {{"energy", w.energy, "energy of the whole chain that carries the wave"},
          {"peak", w.peak, "largest compression of a contact"},
          {"action", w.action,
           "integral over all times of d_+^(5/2), with d the compression of a contact"}};
}

void report_waves(Report& report, Table& constants) {
  EnclosedWave found[2];
  WaveFineness fine;
  if (report.quick) fine.per_turn /= 4;
  parallel_for(2, [&](std::size_t i) { found[i] = enclose_wave(signs[i].first, fine); });
  Table& waves = report.table("waves");
  for (std::size_t i = 0; i < 2; ++i) {
    const char* sign = signs[i].second;
    waves.add(with(bounds_of(found[i]), {{"sign", "of the central velocity", sign}}));
    add_constants(constants, sign, found[i]);
  }
  const Number action = found[0].action - found[1].action,
               energy = found[0].energy - found[1].energy, zero;
  if (!report.quick && !(action < zero && energy < zero))
    throw Failure("waves of the kernel equation: their order is not decided");
  const char* how = "half of the width of the interval, rounded up: known to 20 per cent";
  report.table("plus_minus_minus")
      .add({{"energy", "energy of plus less that of minus", enclosed(energy), "", how},
            {"action", "action of plus less that of minus", enclosed(action), "", how}});
}

/**
## With your own parameters

`sec5_enclosures dps --centre bond` prints the bounds for the DpS equation, and `sec5_enclosures breather --centre site`
those for the chain, at the frequency of the article's example. The barriers belong to both centres. */
Table both_ends(const Bounds& bounds) {
  Table table{{label("quantity", "name of the enclosed quantity"), number("lower", "lower bound"),
               number("upper", "upper bound"), label("meaning", "meaning of the quantity")}};
  for (const auto& [quantity, x, meaning] : bounds)
    table.add({quantity, x.lower, x.upper, meaning});
  return table;
}

struct OneCentre {
  static constexpr const char* certified = "A quantity that cannot be certified is not printed.";
  Centre centre = Centre::site;

  void parameters(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
  }
};

struct EnclosedDps : OneCentre {
  static constexpr Title title{
      "dps", "rigorous bounds on a static breather of the DpS equation, mu = 1", certified};

  Table table() const {
    const DpsBreather site = enclose_dps(Centre::site), bond = enclose_dps(Centre::bond);
    Bounds all = bounds_of(centre == Centre::site ? site : bond);
    for (const Bound& b : bounds_of(dps_barrier(site, bond))) all.push_back(b);
    return both_ends(all);
  }
};

struct EnclosedBreather : OneCentre {
  static constexpr Title title{
      "breather",
      "rigorous bounds on a static breather of the chain in linear wells, omega_b = 1.1",
      certified};

  Table table() const {
    return both_ends(bounds_of(enclose_chain(centre, omega_b.first, omega_b.second)));
  }
};

/**
## Limits

A proof of this kind relies on its program, the compiler and the arithmetic of the processor; interval.hpp says what is
assumed of them. It does not rely on the numbers that it starts from. Nobody outside has refereed it. We prove nothing
about DpS breathers without these signs or symmetries, nor whether the instability of the linearised equation implies
that of the full one. Whether the wave plus is the maximum of the theorem remains open.

The interval arithmetic is tested on a million random operations against four-fold precision. A second program in
another language, with other intervals and eighty digits, repeats for the DpS equation all but the search for other
profiles; its intervals lie in ours. Chain and waves are only compared with what Newton's method finds. Errors that the
tests introduce into the proof, one at a time, make it fail. */
void reproduce(Report& report) {
  report_dps(report);
  report_lemma(report);
  Table& table = report.table("constants", constants());
  report_chain(report, table);
  report_waves(report, table);
}

/**
## Try it

*To change it*: `omega_b` is the frequency of the chain's breathers, a fraction between 1 and 2; where the proof fails
it says why.

1. *Easy.* Does Newton's method find the wave that is enclosed?
   `build/bin/sec5_kernel_equation wave --sign minus` gives `peak` = 0.457321972291.
   Hint: the value must lie between the bounds of the second table, its own error included.
2. *Harder.* How much narrower would the energies of the chain's breathers have to be for their barrier to have a sign?
   `build/bin/sec32_barrier barrier --omega 1.1` gives `equal_frequency` = 1.62422e-11.
   Hint: compare with the widths that `sec5_enclosures breather` prints for both centres. */
int main(int argc, char** argv) {
  return run({"sec5_enclosures", "5", "Breathers between bounds (section 5)", reproduce,
              commands<EnclosedDps, EnclosedBreather>()},
             argc, argv);
}
