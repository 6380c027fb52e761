/**
# 5 A theorem: exact travelling breathers exist

After an impact the article finds packets that travel like breathers. They are *approximate* travelling breathers: a
packet leaves something behind at every site. The article calls the computation of exact ones, which repeat themselves
one site further on after a shift time $T$, an open problem, and the preceding chapter computes them as orbits of a
lattice. Do they exist? In linear wells they do, whatever the exponent of the contacts, for every integer $k$ with $T =
2\pi k$.

<!-- travelling.existence -->
For every integer $k \ge 1$ and every contact law $r_+^\alpha$ with $\alpha > 1$ the chain with linear wells has an
exact travelling breather that moves by one site in the shift time $T = 2\pi k$. It decays double-exponentially in both
directions and has finite energy. (proved)
<!-- /travelling.existence -->

For these $T$ the whole lattice can be replaced by one scalar equation for one function,
$$d = K * d_+^{3/2},\qquad K(\sigma) = -\sin|\sigma| \ \text{ for } |\sigma| \le 2\pi k,\ \text{else } 0,$$
where $d(t)$ is the compression that every contact sees in its own time, and $*$ the convolution. The proof finds a
solution where an integral is largest. It is complete on this page, and nobody outside has refereed it. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/kernel_wave.hpp"
#include "sec5/two_signs.hpp"

using namespace lattice;
using namespace report;

/**
## One equation instead of a lattice

Let $y_n(t) = q(t-nT)$, and let the contacts repel with $r_+^\alpha$, $\alpha > 1$; Hertz has $\alpha = 3/2$. The
contact between $n$ and $n+1$ has the compression $d(t-nT)$ with $d(t) = q(t) - q(t-T)$ and the force $f(t-nT)$ with
$f = d_+^\alpha$. Newton's law is
$$\ddot q + q = f(t+T) - f(t).$$
For $T = 2\pi k$ the function
$$q(t) = \int_t^{t+T}\sin(t-s)\,f(s)\,ds = -\int_0^T\sin\sigma\,f(t+\sigma)\,d\sigma$$
solves it: by differentiating, $\dot q = \int_t^{t+T}\cos(t-s)f(s)\,ds$, because $\sin 0 = \sin T = 0$, and
$\ddot q = -q + f(t+T) - f(t)$, because $\cos T = 1$. As the sine has the period $T$, the neighbour takes the forces
before $t$ as $q(t)$ takes those after it,
$q(t-T) = \int_{t-T}^t\sin(t-T-s)\,f(s)\,ds = \int_{t-T}^t\sin(t-s)\,f(s)\,ds$, so that
$$d = q(t) - q(t-T) = -\int_{t-T}^{t+T}\sin|t-s|\,f(s)\,ds = K*f.$$
Any other solution differs from $q$ by $a\cos(t+\varphi)$, which has the period $T$ and cancels in $d$. So
*for every solution $d = K*d_+^\alpha$, and every $d$ that satisfies this equation gives a solution* $q$.

The kernel has bounded support, as the tent of solitary waves without wells, but changes its sign. Its transform is
$2(1-\cos\omega T)/(\omega^2-1)$. The zero of the numerator at $\omega = 1$, which $T = 2\pi k$ places there, removes
the resonance: every localized force gives a localized wave. */
double kernel(double sigma, double shift_time) {
  return std::abs(sigma) < shift_time ? -std::sin(std::abs(sigma)) : 0;
}

constexpr double two_pi = 2 * std::numbers::pi;
const PowerContact hertz{1.5, 0};

/**
For other $T$ no choice of the solution keeps $q$ localized, unless $f$ has no component at the frequency of the
wells, $V = \int f\cos t\,dt = 0$ for even $d$. Such waves are of *type II* (`sec5_travelling_breathers`).

We call a wave *localized* if $d$ is not zero and tends to zero in both directions, and take the $q$ above for it,
without $a\cos(t+\varphi)$. Multiplying Newton's law by $q$ and integrating gives $\int(\dot q^2 - q^2)\,dt = \int f
d\,dt = A$ with $A = \int d_+^{\alpha+1}dt$. Hamilton's action of one site over all times is a multiple of it, $\frac A2
- \frac{A}{\alpha+1} = \frac{\alpha-1}{2(\alpha+1)}A$, so we call $A$ itself the *action* of a wave. The energy follows
from $q$ and $\dot q$ at one instant, or as a mean over a shift,
$$TE = \tfrac12\int(q^2+\dot q^2)\,dt + \frac{A}{\alpha+1}.$$

## The theorem

**Theorem.** *For every integer $k \ge 1$ and every $\alpha > 1$ there is a function $q \ne 0$, three
times continuously differentiable, such that $y_n(t) = q(t-2\pi kn)$ solves $\ddot y_n + y_n = (y_{n-1}-y_n)_+^\alpha
- (y_n-y_{n+1})_+^\alpha$ on the infinite chain. $|q|$ falls double-exponentially in both directions, and the energy
is finite.*

**Corollary.** *No localized wave with the same $k$ and $\alpha$ has a smaller action than the one that the proof
finds.*

## The proof

We look for the maximum $S$ of $Q(f) = \int f\,(K*f)\,dt$ among all $f \ge 0$ with $\int f^p dt = 1$, $p = 1 +
1/\alpha$, a Rayleigh quotient with the norm of $L^p$ in the place of that of $L^2$. The dual exponent is $p' = \alpha +
1$. A maximum on the whole line may be missed in two ways, which Lions's *concentration-compactness* keeps apart: a
maximizing sequence may spread out ever more thinly, or fall into pieces that move away from each other. The plan:

1. *Bounds*: $S$ is finite and positive.
2. *No vanishing*: $K$ is bounded and of bounded support, so an $f$ that is spread out thinly has a small $Q$.
3. *No dichotomy*: pieces far apart do not interact, and one piece with all of the mass has more than several.
4. *A maximum*: what is left converges, and the limit has $Q = S$.
5. *Its equation*: because $f \ge 0$ was asked for, the positive part appears by itself.
6. *Smoothness and decay* follow from the equation.

*Bounds.* Young's inequality gives $Q(f) \le \|K_+\|_\theta\|f\|_p^2$ with $2/p + 1/\theta = 2$, that is $\theta =
(\alpha+1)/2$, so $S$ is finite. Two narrow pulses of equal height and width $w$ at the distance $3\pi/2$, at which $K =
1$, while $K(0) = 0$, have $Q > 0$ for small $w$, so $S > 0$. By scaling, $Q(f) \le S\|f\|_p^2$.

*No vanishing.* Divide the line into cells of length one and let $a_i$ be the norm of $f$ in cell $i$. Since $|K| \le
1$ and its support has the length $2T$, $Q(f) \le C\sum a_i^2 \le C(\max a_i)^{2-p}\sum a_i^p$, with $C$ depending on
$T$ only. Since $p < 2$ and $\sum a_i^p = 1$, every $f$ with $Q(f) \ge S/2$ has a cell with $a_i^{2-p} \ge S/2C$. We
take a maximizing sequence $f_j$ and shift each $f_j$ such that this is the cell at 0.

*No dichotomy.* Let $\lambda$ be the limit, first $j \to \infty$ along a subsequence that serves every integer $R$,
then $R \to \infty$, of the mass $\int_{|t|<R}f_j^p$; it is positive. For every $\delta > 0$ there is an $R$ such
that for all large $j$ the mass within $R$ is between $\lambda - \delta$ and $\lambda + \delta$, and that between $R$
and $R + T$ at most $2\delta$. Cut $f_j$ with the indicator functions of the three regions; the parts are not
negative. The inner and the outer one do not interact, because $K$ vanishes beyond $T$, and what contains the middle
one is at most $C'\delta^{1/p}$. So $S \le S[\lambda^{2/p} + (1-\lambda)^{2/p}]$ in the limit $\delta \to 0$, and
since $2/p > 1$ the bracket is less than one unless $\lambda = 1$. The sequence is *tight*: outside a large interval
there is little, for all $j$.

*A maximum.* A subsequence converges weakly in $L^p$ to some $f \ge 0$ with $\|f\|_p \le 1$. $K$ is Lipschitz
continuous, so on a bounded interval $f \to K*f$ maps bounded sets of $L^p$ into equicontinuous sets and is compact
from $L^p$ to $L^{p'}$. There $Q(f_j) \to Q(f)$, and by tightness what is outside changes nothing: $Q(f) = S$. As
$Q(f) \le S\|f\|_p^2$, no mass is lost, $\|f\|_p = 1$, and $f_j \to f$ strongly.

*Its equation.* For $h \ge 0$ bounded and with bounded support, $Q(f+\epsilon h) \le S\|f+\epsilon h\|_p^2$ for
$\epsilon \ge 0$, with equality at $\epsilon = 0$. The derivative there says $\int h\,(K*f) \le S\int h f^{1/\alpha}$,
so $K*f \le Sf^{1/\alpha}$ almost everywhere. But $\int f(Sf^{1/\alpha} - K*f)\,dt = S - S = 0$, so that equality holds
where $f > 0$; where $f = 0$ we have $K*f \le 0$. Both together are $Sf^{1/\alpha} = (K*f)_+$. Then
$S^{-\alpha/(\alpha-1)}f$ satisfies $f = (K*f)_+^\alpha$, and its $d = K*f$ is what we looked for.

*Smoothness and decay.* $K$ is in $L^{p'}$ with bounded support, so $d$ is continuous and tends to zero. Then $f$ is
continuous, $d$ continuously differentiable, hence so is $f$, as $\alpha > 1$, and $q$ three times. Let $M(t)$ be the
largest value of $d_+$ beyond $t$. Since $\int K_+ = 4k$,
$$M(t+T) \le 4k\,M(t)^\alpha,$$
so $(4k)^{1/(\alpha-1)}M$ is at most the power $\alpha$ of its value one shift before. Once that is below one, its
negative logarithm grows at least by the factor $\alpha$ with every shift; the same holds for $t \to -\infty$. And
$|q(t)|$ and $|\dot q(t)|$ are at most $4k \max f$ over $[t, t+T]$, so that they fall alike and the sums over the sites
converge. $\square$

## What else follows

By the last step of the proof every localized wave of this $T$ falls double-exponentially, so its $A$ is finite.

- *Least action.* With $f = d_+^\alpha$ every localized wave has $Q(f) = \int f d\,dt = A = \|f\|_p^p$, hence
  $Q(f)/\|f\|_p^2 = A^{-(\alpha-1)/(\alpha+1)} \le S$. The maximum reaches $S$: it has the least action $A =
  S^{-(\alpha+1)/(\alpha-1)}$ of all. From now on the *quotient* of a wave is this power of its $A$.
- *Any maximizing sequence* converges in $L^p$, up to translations, along a subsequence.
- *Peaks.* From $\max d \le 4k(\max d)^\alpha$ every localized wave has $\max d \ge (4k)^{-1/(\alpha-1)}$.
- *No compacton.* If $f$ ended at $b$, then for $b+T-\pi < t < b+T$ the integral $d(t) = \int_{t-T}^b K(t-s)f(s)\,ds$
  would have $K > 0$ only, since $T-\pi < t-s < T$. So $d(t) > 0$ and $f(t) > 0$ beyond $b$, a contradiction; the other
  end is the same.
- *Contacts open.* $\int K = 0$, so $\int d\,dt = 0$ and $d$ is negative somewhere.
- *Energy.* With constants $c$ and $C$ that depend on $\alpha$ only and may change from place to place, the energy of
  the maximum lies between $ck^{-2/(\alpha-1)}$ and $Ck^{-2/(\alpha-1)}$; for Hertzian contacts that is the fourth power
  of the speed. At some instant two neighbours differ by $\max d$, so that $E \ge \frac14(4k)^{-2/(\alpha-1)}$. For the
  other bound take $k \ge 2$ equal pulses of width $w$ whose centres are $2\pi-\pi/2k$ apart. Between two centres that
  are $j$ places apart $K = \sin(j\pi/2k) > 0$, on average over all pairs at least a constant, and the widths change $K$
  by $w$ at most. So a small $w$ that does not depend on $k$ gives $Q(f) \ge ck^2$, while $\|f\|_p^2 = Ck^{2/p}$, hence
  $S \ge ck^{2/(\alpha+1)}$ and $A \le Ck^{-2/(\alpha-1)}$. In the mean over a shift $\int(q^2+\dot q^2)\,dt =
  \iint(T-|s-s'|)_+\cos(s-s')\,f(s)f(s')\,ds\,ds'$, by Young's inequality at most
  $CT^{1+2/(\alpha+1)}A^{2\alpha/(\alpha+1)}$. Divided by $T$ this is $Ck^{-2/(\alpha-1)}$, and $A/T$ is less.

The proof uses only that $K$ is even, Lipschitz continuous, of compact support, not negative at zero and positive
somewhere. So it holds with no other change for

- *identical linear cells*, in which contacts push a mass with any linear resonators inside, with or
  without a well, if $T\omega_j \in 2\pi\mathbb N$ for all frequencies $\omega_j > 0$ of the cell. Then
  $K = c_0(T-|\sigma|) - \sum (c_j/\omega_j)\sin\omega_j|\sigma|$ for $|\sigma| \le T$ with $c_0, c_j
  \ge 0$, so that $K$ is positive at $0$ or near $T$; if $c_0 > 0$, without a well, $d$ is localized,
  $q$ is a step, and other solutions have a drift that is seen in $d$;
- *odd contact laws* $r|r|^{\alpha-1}$ at all $T = \pi j$ with $y_n(t) = (-1)^{jn}q(t-nT)$, which have
  the same $K$ on $|\sigma| \le \pi j$. Here $f$ may have any sign, the maximum is sought without a cone,
  two pulses of opposite signs give $S > 0$ at $j = 1$ too, and $\int|K|$ takes the place of $4k$.

## Where it stands

All linear waves of the chain at rest have the frequency 1, so a wave of any speed is in resonance with one of them and
would in general drag a tail. At $T = 2\pi k$ that one is the uniform oscillation, which no contact feels. Solitary
waves in resonance with a band are called embedded solitons (Champneys, Malomed, Yang and Kaup, Physica D 152, 340,
2001); here an identity protects them.

That a resonance can be removed in this way is known from mass-in-mass chains, beads with one resonator each, as
*anti-resonance*. Kevrekidis, Stefanov and Xu (arXiv:1502.01995) prove that bell-shaped travelling waves exist there
under anti-resonance conditions between the mass of the resonator and the speed; our identical linear cells with one
resonator are chains of this kind. Away from anti-resonance Faver (arXiv:1910.12313) proves waves with periodic tails
for small resonators. In our chain the bead in its well is itself the resonator, the kernel changes its sign, and the
waves oscillate. Of these two works we read the abstracts. Others we have not read and name for what they are known for:
solitary waves without wells (Friesecke and Wattis, Commun. Math. Phys. 161, 391, 1994), their double-exponential fall
in Hertzian chains (English and Pego, Proc. AMS 133, 1763, 2005) and concentration-compactness (Lions, Ann. Inst. H.
Poincaré C 1, 109, 1984).

In the freely accessible literature we found no theorem like this one; journals behind a paywall were not searched. The
proof has not been refereed. It does not say whether the maximum is even, unique or stable, nor which sign its central
velocity has, and says nothing about other speeds or wells with $s \ne 0$. For waves that repeat themselves only after
$m$ sites, or for masses of period $m$ in wells of one frequency, the resonance leaves $m-1$ complex conditions.

## Waves of both signs

![The kernel, two waves, and the quotients of both signs.](fig:x24)

Newton's method (kernel_wave.hpp) finds two even solutions for each $k$, one with the central contact closed at $t = 0$
and one with it open (panel b). They are the two orbits of the chapter before, named by the sign of the central
velocity $\dot y_0$ at the instant at which positions are odd. Two grids give the errors. The product $Ek^4$, which
stays between two constants for the maximum of the theorem, falls more and more slowly.

| | $k = 1$ | $k = 3$ | $k = 6$ |
|---|---|---|---|
| energy $E$, sign plus | [0.18083](cell:waves/k=1/sign=1/energy) | [8.958e-4](cell:k=3/energy) | [4.301e-5](cell:k=6/energy) |
| $Ek^4$, sign plus | [0.1808](cell:waves/k=1/sign=1/scaled_energy) | [0.0726](cell:k=3/scaled_energy) | [0.0557](cell:k=6/scaled_energy) |
| largest compression, sign plus | [0.446](cell:waves/k=1/sign=1/peak) | [0.0417](cell:k=3/peak) | [0.00995](cell:k=6/peak) |
| the same, sign minus | [0.457](cell:waves/k=1/sign=-1/peak) | [0.0420](cell:k=3/peak) | [0.00993](cell:k=6/peak) |

The signs differ in their largest compression, but have the same energy to nine digits at $k = 1$, and to rounding for
slower waves. At $k = 1$ the next chapter proves that both exist and that their actions differ, in the eleventh digit.
The sign plus, whose phase is pinned, has the smaller action, so the wave minus is not the maximum of the theorem.
Whether the wave plus is remains open. Panel c shows how fast both fall. */
std::vector<TwoGridWave> waves(const std::vector<std::size_t>& ks) {
  std::vector<std::vector<TwoGridWave>> found(2 * ks.size());
  parallel_for(found.size(), [&](std::size_t i) {
    // The slowest waves take longest and come first
    const std::size_t k = ks[ks.size() - 1 - i / 2];
    found[i].push_back(wave_on_two_grids(k, i % 2 ? 1 : -1, hertz.exponent));
  });
  std::vector<TwoGridWave> all;
  for (auto it = found.rbegin(); it != found.rend(); ++it) all.push_back(it->front());
  return all;
}

void report_kernel(Report& report) {
  Table& table =
      report.table("kernel", {count("k", "oscillations per site"),
                              number("turns", "sigma over 2 pi"), number("kernel", "K(sigma)")});
  for (std::size_t k : {1, 2})
    for (int i = -400; i <= 400; ++i) {
      const double turns = i / 160.0;
      table.add({k, turns, kernel(two_pi * turns, two_pi * double(k))});
    }
}

void report_waves(Report& report, const std::vector<TwoGridWave>& all) {
  Table& table = report.table(
      "waves", {count("k", "oscillations per site"), count("sign", "sign of the central velocity"),
                estimate("energy", "energy"), estimate("action", "integral of d_+^(5/2)"),
                estimate("quotient", "Q, the action to the power -1/5"),
                estimate("peak", "largest compression"),
                count("contacts", "number of time intervals in which a contact is closed"),
                estimate("scaled_energy", "energy times k^4")});
  for (const TwoGridWave& w : all) {
    const auto scaled = [&](const KernelWave& g) { return g.energy() * std::pow(double(w.k), 4); };
    table.add({w.k, w.sign, w(&KernelWave::energy), w(&KernelWave::action),
               w(&KernelWave::quotient), w(&KernelWave::peak), w.fine().contacts(), w(scaled)});
  }
}

// A profile is symmetric, and its tail falls so fast that only the logarithm shows it
void report_profiles(Report& report, const std::vector<TwoGridWave>& all) {
  Table& table = report.table(
      "profiles", {count("k", "oscillations per site"),
                   count("sign", "sign of the central velocity"), number("turns", "t over 2 pi"),
                   estimate("d", "compression", "", "against the largest: difference of two grids"),
                   number("log_d", "log10 of |d| divided by the peak")});
  for (const TwoGridWave& w : all)
    for (int i = 0; i <= 600; ++i) {
      const double turns = i / 100.0;
      const auto at = [&](const KernelWave& g) { return g.line.at(g.d, two_pi * turns); };
      const Estimate d = w(at);
      const double size = std::abs(d.value) / w.fine().d.maxCoeff();
      table.add({w.k, w.sign, turns, d, std::log10(std::max(size, 1e-30))});
    }
}

/**
## Other exponents

At $\alpha = 3/2$ the quotients of the two signs differ in the eleventh digit, at larger $\alpha$ much earlier, and not
always in the same sense (panel d). We compare them together with $\kappa$ of the internal phase (chapter on exact
travelling breathers), which is negative where the phase is pinned: does stability pass from one sign to the other where
the quotients exchange their order? The signs can be told apart down to $\alpha = 1.38$; below that their difference is
rounding, and below $\alpha = 3/2$ so is $\kappa$ (two_signs.hpp). */
std::vector<double> contact_exponents(bool quick) {
  if (quick) return {2, 3, 4};
  return {1.2,  1.3, 1.35, 1.38, 1.4, 1.42, 1.44, 1.46, 1.48, 1.5, 1.52, 1.55, 1.58, 1.6, 1.62,
          1.65, 1.7, 1.72, 1.75, 1.8, 1.85, 1.9,  1.95, 2,    2.1, 2.2,  2.3,  2.4,  2.6, 2.8,
          3,    3.2, 3.4,  3.6,  3.8, 4,    4.5,  5,    5.5,  6,   6.5,  7,    7.5,  8};
}

void report_quotients(Report& report, const std::vector<TwoSigns>& all) {
  Table& table = report.table(
      "quotients",
      {number("alpha", "exponent of the contacts"),
       estimate("plus", "Q of the wave with the sign plus"),
       estimate("minus", "Q of the wave with the sign minus"),
       estimate("difference", "relative difference of the quotients, sign plus minus sign minus",
                "", "against the largest: difference of two grids"),
       number("log_difference", "log10 of the modulus of the difference, at least -16"),
       estimate("kappa_plus", "kappa of the internal phase; nan where it is rounding", "",
                "against the largest: difference of two grids and tolerances; may be nan"),
       estimate("kappa_minus", "kappa of the internal phase; nan where it is rounding", "",
                "against the largest: difference of two grids and tolerances; may be nan")});
  for (const TwoSigns& c : all) {
    const Estimate apart = c.difference();
    table.add({c.alpha, c.plus(&KernelWave::quotient), c.minus(&KernelWave::quotient), apart,
               std::log10(std::max(std::abs(apart.value), 1e-16)), c.kappa_plus, c.kappa_minus});
  }
}

/**
At every exponent of the list from 3/2 on the phase of the wave with the larger quotient is pinned and that of the other
is not. It is not a law: between the exchanges of the table below it fails, and with larger exponents in
`contact_exponents` neither phase is pinned beyond $\alpha = 8.5$.

<!-- travelling.exchanges -->
For contact laws $r_+^\alpha$ with $\alpha$ between 1.38 and 8 the two even travelling waves with $k = 1$ exchange at
least nine times which of them has the larger Rayleigh-type quotient, last at $\alpha =$ 5.82355. Nearby, but not at the
same exponent, they exchange which of them has a pinned phase: between 3.10381 and 3.10475 both have, between 5.79556
and 5.85298 neither has. (computed)
<!-- /travelling.exchanges -->

Beyond the largest exchange, up to $\alpha = 8$, the sign minus has the larger quotient.

| exchange | of the quotients, $\alpha$ | phase plus pinned | phase minus pinned |
|---|---|---|---|
| 1 | [5.82355](cell:exchanges/exchange=1/alpha) | up to [5.79556](cell:alpha_plus) | from [5.85298](cell:alpha_minus) on |
| 2 | [3.10428](cell:exchanges/exchange=2/alpha) | from [3.10381](cell:alpha_plus) on | up to [3.10475](cell:alpha_minus) |
| 3 | [2.307](cell:exchanges/exchange=3/alpha) | | |
| 4 | [1.945](cell:exchanges/exchange=4/alpha) | | |
| 5 | [1.738](cell:exchanges/exchange=5/alpha) | | |
| 6 | [1.605](cell:exchanges/exchange=6/alpha) | | |
| 7 | [1.512](cell:exchanges/exchange=7/alpha) | | |
| 8 | [1.443](cell:exchanges/exchange=8/alpha) | | |
| 9 | [1.391](cell:exchanges/exchange=9/alpha) | | |

Stability does not pass from one sign to the other at a single exponent. At the second exchange both phases are pinned
over a short range of $\alpha$, at the first one neither is: a third wave, without symmetry, should exist at both.
(Another program finds one near $\alpha = 3.104$, with a quotient below both.) */
struct Exchange {
  std::size_t number;
  const TwoSigns &low, &high;  // the exponents on either side
};

// Numbered from large alpha to small; kappa is looked for at the first two
void report_exchanges(Report& report, const std::vector<TwoSigns>& all) {
  Table& table = report.table(
      "exchanges",
      {count("exchange", "number of the exchange, from large exponents to small"),
       estimate("alpha", "exponent at which the quotients are equal", "",
                "difference of two grids, and rounding"),
       estimate("alpha_plus", "exponent at which kappa of the sign plus is zero", "",
                "difference of two grids and tolerances; nan where it is not looked for"),
       estimate("alpha_minus", "exponent at which kappa of the sign minus is zero", "",
                "difference of two grids and tolerances; nan where it is not looked for")});
  std::vector<Exchange> found;
  for (std::size_t i : exchanges_among(all))
    found.push_back({found.size() + 1, all[i], all[i + 1]});
  const std::size_t searched = report.quick ? 0 : 2;
  const auto row = [&](const Exchange& e) {
    const auto phase = [&](int sign) {
      return e.number > searched ? undefined : exchange_of_stability(e.low, e.high, sign);
    };
    return Cells{e.number, exchange_of_quotients(e.low, e.high), phase(1), phase(-1)};
  };
  table.fill(found, row, "exchanges");
}

/**
## Type II

Along the family that begins at $T = 2\pi$ (kernel_wave.hpp) $V$ changes its sign. The zero is the first orbit of type
II of the chapter on exact travelling breathers, found here by another method, with $T/2\pi =$
[0.897](cell:type_two/turns). */
void report_type_two(Report& report) {
  const auto turns = [](const WaveGrid& grid) {
    const KernelWave start = wave_of_type_one(1, 1, hertz, grid);
    return wave_of_type_two(start, 0.87 * two_pi, 0.03 * two_pi, grid).shift_time() / two_pi;
  };
  report
      .table("type_two", {estimate("turns", "shift time of the first wave of type II, over 2 pi",
                                   "", "difference of two grids")})
      .add({with_error(turns(usual_grids[0]), turns(usual_grids[1]))});
}

/**
## With your own parameters

`sec5_kernel_equation wave --alpha 3 --sign minus` solves the equation for one $k$, one sign and one exponent. */
struct OneKernelWave {
  static constexpr Title title{
      "wave",
      "one solution of the kernel equation: an exact travelling breather in harmonic wells"};
  enum class Sign { plus = 1, minus = -1 };
  std::size_t k = 1;
  Sign sign = Sign::plus;
  double alpha = 1.5;

  void parameters(Parameters& p) {
    p.add("k", k, "oscillations per site; the shift time is 2 pi k", {1, 12});
    p.add("sign", sign, "sign of the central velocity",
          {{"plus", Sign::plus}, {"minus", Sign::minus}});
    p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", {1.1, 8});
  }
  Table table() const {
    // Two grids give the errors
    const TwoGridWave w = wave_on_two_grids(k, int(sign), alpha);
    const double residual = w.fine().residual();
    Answers q;
    q.add("energy", w(&KernelWave::energy), "",
          "energy of the whole chain that carries the wave, Eq. (6)");
    q.add("action", w(&KernelWave::action), "",
          "integral over all times of d_+^(alpha+1), with d the compression of a contact");
    q.add("peak", w(&KernelWave::peak), "", "largest compression of a contact");
    q.add("contacts", with_error(w.grids[0].contacts(), w.fine().contacts()), "",
          "number of time intervals in which a contact is compressed by more than 2.2e-16 of the "
          "peak");
    q.add("quotient", w(&KernelWave::quotient), "",
          "value Q of the variational quotient, action^(-(alpha-1)/(alpha+1))");
    q.add_small("residual", {residual, residual}, "relative to the peak",
                "residual of the kernel equation at the nodes of the finer grid");
    return q.table;
  }
};

// The whole section
void reproduce(Report& report) {
  const bool quick = report.quick;
  const auto all =
      waves(quick ? std::vector<std::size_t>{1, 2} : std::vector<std::size_t>{1, 2, 3, 4, 5, 6});
  report_kernel(report);
  report_waves(report, all);
  report_profiles(report, {all[0], all[1]});
  const std::vector<TwoSigns> sweep = compare_signs(contact_exponents(quick));
  report_quotients(report, sweep);
  report_exchanges(report, sweep);
  report_type_two(report);
}

/**
## Try it

**To change it.** The exponents of panel d are `contact_exponents`, which the statement reads from 3/2 to 8; the $k$ of
`waves` stand in `reproduce`. `wave_on_two_grids` computes any other wave.

1. *Easy.* Slow breathers are small. What is the energy of the one with two oscillations a site?
   `build/bin/sec5_kernel_equation wave --k 2` gives `energy` = 0.00581039.
   Hint: $Ek^4$ tends to a constant, but slowly: compare $k = 1$, 2 and 4.
2. *Harder.* Which sign has the larger quotient at $\alpha = 3$?
   `build/bin/sec5_kernel_equation wave --alpha 3 --sign minus` gives `quotient` = 0.670594, and
   `build/bin/sec5_kernel_equation wave --alpha 3` gives `quotient` = 0.670570.
   Hint: at $\alpha = 3/2$ it is the other sign; count the exchanges in between. */
int main(int argc, char** argv) {
  return run(
      {"sec5_kernel_equation", "5", "A theorem: exact travelling breathers exist (section 5)",
       reproduce, commands<OneKernelWave>()},
      argc, argv);
}
