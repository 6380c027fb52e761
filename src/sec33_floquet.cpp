/**
# 3.3 Floquet multipliers of the breathers of the chain

Which of the two breathers of the chain is stable, and in which wells? We compute their *Floquet multipliers* $\lambda$,
the eigenvalues of the matrix $M$ by which one period multiplies a small disturbance: a multiplier outside the unit
circle makes it grow. Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) finds four multipliers so close
to $+1$ that the breathers are almost free to move. It says that

- in the linear well, at $\omega_b = 1.1$, the site-centred breather is weakly unstable and the bond-centred one stable;
- in wells of anharmonicity $s$ the bond-centred one loses its stability at $s_0^b \approx 0.26$ and the site-centred
  one gains it at $s_0^s \approx 0.05$, where a pair of multipliers collides at $+1$ (figures 11 and 12);
- there are four multipliers near $+1$, and others accumulate on the unit circle near $e^{\pm2\pi i/\omega_b}$;
- the *pinning mode* is very close to the discrete gradient of the breather (figure 13);
- near $\omega_b = 1$ the instability is weaker than that of the DpS equation by a factor of $O(\epsilon^{1/2})$.

![Arguments and moduli of the four multipliers near one, bond-centred.](fig:11)

At $\omega_b = 1.1$ these hold but for the two values of $s_0$ (*very close* has no bound; we give the angle). Both
breathers exchange their stability next to the same well, $s_0 =$ [0.1525](cell:exchange/site), and not far apart. At
higher frequencies the structure is lost in hard wells, where the pinning pair leaves $+1$, and in very soft ones. The
multipliers are hard to compute because two are exactly $+1$ and share one eigenvector: an error $\eta$ of $M$ can split
such a pair by as much as $\sqrt\eta$. We compute a quantity that has no such pair.

<!-- head -->
`build/bin/sec33_floquet` computes this chapter in 4 s on two cores and writes 13 tables to `build/data/sec33_floquet`.
Its figures: `make fig11`, `make fig12`, `make fig13`, `make x47`, `make x64`. With your parameters: `multipliers`, all
Floquet multipliers of one breather; `exchange`, exchange of stability: the anharmonicity s at which the pinning
(translational) pair of multipliers passes +1.
<!-- /head -->

## Model

The chain is that of Eqs. (6) and (10), with free ends,
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},$$
and the breathers are those of section 3.2, with the period $T_b = 2\pi/\omega_b$. They start from rest and are at rest
again after half a period. Let $F$ be the derivative of the flow over this half with respect to displacements and
velocities, with blocks $A, B, C, D$. The second half of the period is the first one run backwards. With
$R = \mathrm{diag}(1,-1)$, which reverses velocities, the whole period has the matrix $M = RF^{-1}RF$, and as $F$ is
symplectic, $M+M^{-1} = 2+4\,\mathrm{diag}(K, K^T)$ with $K = B^TC$. So one number describes each pair of multipliers
$\lambda, 1/\lambda$:
$$\kappa = \tfrac14\Bigl(\lambda+\frac1\lambda-2\Bigr),\qquad\text{an eigenvalue of } K.$$
A pair is on the unit circle if and only if $\kappa$ is real and $-1\le\kappa\le0$. If $\kappa > 0$, the pair is real
and $\ln\lambda = 2\,\mathrm{arsinh}\sqrt\kappa$.

The pair that is always $+1$ belongs to a shift in time. It changes the velocities along the accelerations $f$, and
after half a period, where all beads are at rest again, no position: $Bf = 0$. Hence $f^TK = 0$, and leaving out the
direction of $f$ removes this pair exactly. The *pinning pair* is the one next to $+1$, and its mode shifts the breather
along the chain; such modes are how breathers in other lattices were set in motion (Chen, Aubry and Tsironis 1996; Aubry
and Cretegny 1998). Its $\kappa$ is now a simple eigenvalue: an error $\eta$ of $F$ moves it by $O(\eta)$. */
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "commands/exchanges.hpp"
#include "commands/multipliers.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"
#include "sec33/matrix_errors.hpp"
#include "sec33/plane.hpp"

using namespace lattice;

/**
## The experiment

We continue the breather from the linear well to $s = 1$ and to $s = -1$ and compute all pairs of multipliers for each
$s$. `find_breather` solves the conditions on a breather by Newton's method from the profile of Eqs. (18) to (20), and
`newton_from` starts from a neighbouring breather of the chain of `problem_at` (exchange.hpp). The pairs follow as in
the model: `monodromy` (floquet.hpp) integrates $F$, ending a step at every contact event, and `pairs_of` returns the
eigenvalues of $K$ perpendicular to $f$, the smallest $|\kappa|$ first. */
constexpr double omega_b = 1.1;                             // figures 11 to 13
constexpr int steps_to_one = 30;                            // values of s between 0 and 1
constexpr double beside_exchange[] = {0.001, 0.004, 0.01};  // more of them there

/// All pairs of a breather that starts from rest in a chain of equal beads.
std::vector<std::complex<double>> kappas(const Chain& chain, const Orbit<double>& breather,
                                         const EventTolerance<double>& rule) {
  const auto n = Eigen::Index(chain.sites);
  const Matrix<double> F = monodromy(chain, breather.start, breather.period() / 2, rule);
  const Matrix<double> B = F.topRightCorner(n, n), C = F.bottomLeftCorner(n, n);
  const Matrix<double> K = B.transpose() * C;
  const std::vector<double> a = accelerations(chain, breather.start.y);
  const Vector<double> f = Eigen::Map<const Vector<double>>(a.data(), n);
  return pairs_of(K, f).kappa;
}

/// The breathers of a centre for s from -1 to 1, with all pairs.
std::vector<BreatherAt> over_s(Centre centre, int steps) {
  std::vector<BreatherAt> family;
  for (int k = -steps; k <= steps; ++k) family.push_back({{omega_b, double(k) / steps}});
  const auto problem = [&](std::size_t k) { return problem_at(centre, family[k].spot); };
  // From the linear well, which is in the middle, to both ends
  const auto linear = std::size_t(steps);
  family[linear].orbit = find_breather(problem(linear));
  for (std::size_t k = linear + 1; k < family.size(); ++k)
    family[k].orbit = newton_from(problem(k), family[k - 1].orbit);
  for (std::size_t k = linear; k > 0; --k)
    family[k - 1].orbit = newton_from(problem(k - 1), family[k].orbit);
  parallel_for(family.size(), [&](std::size_t k) {
    family[k].spectrum = spectrum<double>(problem(k), family[k].orbit);
  });
  return family;
}

/**
`spectrum` does the same twice, the second time with a tolerance sixteen times larger and the breather found again from
a point beside it. The difference plus the symplectic defect of $F$ is the error of $\kappa$. The program stops if
Newton's method does not converge, or if $F$ does not map a shift in time to a shift in time. Chains have 21 and 22
sites: the force on a bead beyond their ends would be below machine precision.

## How accurate is it?

How accurate must $M$ be if the four multipliers are computed directly as its eigenvalues? They cannot be assigned to
pairs, but the symmetric function
$$\kappa \simeq \frac18\sum_{k=1}^4\frac{(\lambda_k-1)^2}{\lambda_k}$$
needs no assignment. For the stable, bond-centred breather in the linear well we loosen the tolerance of the flow and
compare with extended precision (`Wide`, a mantissa of 64 bits). */
void report_tolerances(Report& report, const Shooting<double>& problem,
                       const Orbit<double>& breather) {
  const double kappa = spectrum<Wide>(problem, breather).kappa().value;
  Table& table = report.table("tolerances");
  for (int power = -4; power >= -13; --power) {
    EventTolerance<double> rule;
    rule.tolerance = std::pow(10.0, power);
    const auto M = monodromy(problem.chain, breather.start, breather.period(), rule);
    const double from_K = kappas(problem.chain, breather, rule).front().real();
    const Displaced by = displaced(M, kappa);
    table.add({{"tolerance", "of the flow", rule.tolerance},
               {"multipliers", "error of the eigenvalues of M next to +1", by.multipliers},
               {"symmetric", "error of kappa from the four of them", by.kappa},
               {"kappa", "error of kappa from K", std::abs(from_K - kappa)}});
  }
}

/**
![Errors of the multipliers next to $+1$ and of $\kappa$.](fig:x47)

On average, though in jumps, both ways to $\kappa$ gain a digit with each digit of the tolerance. The eigenvalues of $M$
gain half a digit. An error may split a pair along the circle or off it; the splitting shows up in the moduli, so a
stable breather can look unstable.

## The four multipliers against $s$ (figures 11 and 12)

Where does the pinning pair pass through $+1$? We follow $\kappa$ over $s$. A pair on the circle has modulus one, a pair
on the real axis argument zero. Near an exchange of stability the multipliers leave $+1$ like square roots, so there are
more values of $s$. We find the exchange first: `exchange_on` takes two neighbours with opposite signs of $\kappa$,
improves its zero by regula falsi and takes two last steps in extended precision. Its error is that of $\kappa$ over the
slope of $\kappa$ in $s$.

![The same around a site.](fig:12) */
/// A breather over s, and its exchange of stability.
struct Family {
  Centre centre;
  std::vector<BreatherAt> breathers;
  Exchange exchange;
};

Family family_of(Centre centre, int steps) {
  Family family{centre, over_s(centre, steps), {}};
  family.exchange = exchange_on<Wide>(centre, family.breathers);
  const Orbit<double>& near = family.exchange.orbit;
  const double s_0 = family.exchange.place.value;
  for (const double beside : beside_exchange)
    for (const double s : {s_0 - beside, s_0 + beside}) {
      const auto problem = problem_at(centre, {omega_b, s});
      const Orbit<double> orbit = newton_from(problem, near);
      family.breathers.push_back({{omega_b, s}, orbit, spectrum<double>(problem, orbit)});
    }
  std::sort(family.breathers.begin(), family.breathers.end(),
            [](const BreatherAt& a, const BreatherAt& b) { return a.spot.s < b.spot.s; });
  return family;
}

void report_over_s(Report& report, const Family& family) {
  Table& table = report.table(name_of(family.centre) + "_against_s");
  for (const BreatherAt& at : family.breathers) {
    const double kappa = at.spectrum.kappa().value;
    const double on_circle = std::sqrt(std::max(0.0, -kappa));
    const double on_axis = std::sqrt(std::max(0.0, kappa));
    table.add(
        {{"s", "anharmonicity of the well", at.spot.s},
         {"kappa", "(lambda + 1/lambda - 2) / 4 of the pinning pair of multipliers",
          at.spectrum.kappa(), "", "from two tolerances, against the neighbouring rows"},
         {"argument", "argument of the multiplier in the upper half plane",
          2 * std::asin(on_circle), "rad"},
         {"growth", "ln of the larger modulus", 2 * std::asinh(on_axis)},
         {"largest_modulus", "largest modulus of all multipliers", at.spectrum.largest_modulus()}});
  }
}

/**
At $\omega_b = 1.1$ strong anharmonicity reverses the stability found in the linear well if it is hard, but not if it is
soft. So the stability depends on the strength and the sign of the anharmonicity, and all moduli are below 1.001, as the
article's conclusion says. Away from the exchange the two values of $\kappa$ are opposite and equal to about $10^{-4}$.

| | $\kappa$ around a site | around a bond | largest modulus of the unstable one |
|---|---|---|---|
| $s = 0$ | [1.148e-8](cell:site_against_s/s=0/kappa) | [-1.148e-8](cell:bond_against_s/s=0/kappa) | [1.000214](cell:site_against_s/s=0/largest_modulus) |
| $s = 1$ | [-6.491e-8](cell:site_against_s/s=1/kappa) | [6.490e-8](cell:bond_against_s/s=1/kappa) | [1.000510](cell:bond_against_s/s=1/largest_modulus) |

## The exchange of stability

The zeros of $\kappa$ are far from the printed values and next to each other. A program that shares no line with this
one (`tests/second`) finds both, too, to $10^{-7}$ (`paper/second.ecsv`).

<!-- exchange.equal -->
At $\omega_b = 1.1$ the site- and bond-centred breathers exchange stability at almost the same anharmonicity, and not at
$s = 0.05$ and $0.26$: the stability of the former changes at $s =$ 0.1525195, that of the latter at $s =$ 0.1525198.
The two values are 3.2e-7 apart, and in between both breathers are stable. (computed)
<!-- /exchange.equal -->

The table `exchange` has errors below $10^{-9}$. Why together? A picture: the centre of the breather moves in a
potential with the period of the chain, and the two breathers are its extrema. If it is nearly a sine, there are no
others, one breather is stable and the other unstable. Where its amplitude passes through zero, both exchange their
stability in a symmetry-breaking bifurcation; higher harmonics of the potential decide what happens in between
(`sec33_between`). In this picture exchanges as far apart as the printed ones need a potential that is far from a sine
at every $s$ between them. */
Estimate slope_of_kappa(const Family& family) {
  const auto kappa = [&](double s) {
    const auto problem = problem_at(family.centre, {omega_b, s});
    return spectrum<double>(problem, newton_from(problem, family.exchange.orbit)).kappa();
  };
  const auto fall = [&](double h) {
    const double s_0 = family.exchange.place.value;
    const Estimate below = kappa(s_0 - h), above = kappa(s_0 + h);
    return Estimate{std::abs(above.value - below.value) / (2 * h),
                    (above.error + below.error) / (2 * h)};
  };
  return compare(fall(0.02), fall(0.01));
}

void report_exchange(Report& report, Estimate site, Estimate bond, Estimate slope) {
  const Estimate gap{bond.value - site.value, site.error + bond.error};
  const char* how = "from that of kappa";
  report.table("exchange")
      .add({{"site", "s where the site-centred breather becomes stable", site, "", how},
            {"bond", "s where the bond-centred one becomes unstable", bond, "", how},
            {"gap", "bond minus site", gap, "", how},
            {"slope", "by which kappa falls with s, around a site", slope, "", "two intervals"}});
}

/**
## What may have moved the printed exchanges

Can one cause move the exchange around a site to 0.05 and that around a bond to 0.26, at $\omega_b = 1.1$? We know two
possible ones, and cannot tell which it was. The first is a threshold $\theta$: if a multiplier counts as off the circle
only beyond $1+\theta$, the instability seems to end too early around a site and to begin too late around a bond. So we
compute $\lambda-1$ for all $s$ that are rounded to the printed values. All $\theta$ from
[0.00017604](cell:beside_printed/centre=bond/s=0.255/beyond_one) to
[0.00017998](cell:beside_printed/centre=site/s=0.045/beyond_one) give both. The article names no threshold.

The second are errors of the matrix. We add uniform noise of size $\eta$ to $M$ of the stable, bond-centred breather in
the linear well, eight times (matrix_errors.hpp). It then looks unstable: the largest distance from the circle in eight
draws is [0.000496](cell:matrix_errors/source=noise/delta=1e-6/modulus) at $\eta = 10^{-6}$, more than twice the
instability of the other breather. And $\kappa$ changes, in the geometric mean, by as much as in
[0.411](cell:matrix_errors/source=noise/delta=1e-6/in_s) of $s$, at $10^{-7}$ in
[0.0411](cell:matrix_errors/source=noise/delta=1e-7/in_s). The printed exchanges are 0.1 from ours. That does not tell
why one is too low and the other too high. */
constexpr std::pair<Centre, double> printed_exchanges[] = {{Centre::site, 0.05},
                                                           {Centre::bond, 0.26}};

void report_threshold(Report& report) {
  Table& table = report.table("beside_printed");
  for (const auto& [centre, printed] : printed_exchanges)
    for (const double rounding : {-0.005, 0.0, 0.005}) {
      const auto problem = problem_at(centre, {omega_b, printed + rounding});
      const Pair pinning = spectrum<double>(problem, find_breather(problem)).pairs.front();
      table.add({{"centre", "site or bond", name_of(centre)},
                 {"s", "anharmonicity of the well", printed + rounding},
                 {"beyond_one", "largest multiplier minus one", from_one(pinning)}});
    }
}

/**
## The pinning mode (figure 13)

What does the pinning mode look like? The breather starts from rest, so the eigenvectors of $\lambda$ and $1/\lambda$
have the same displacements at $t = 0$ and opposite velocities. We compare these displacements with the discrete
gradient $y_{n+1}(0)-y_{n-1}(0)$, both of length one. The article calls the two very close. We compute in the
linear well.

![Pinning mode and discrete gradient.](fig:13)

Both shift the breather along the chain. But the mode is more concentrated: the gradient is larger on most of the
flanks, and around a bond smaller at the centre. The angle between them is [9.1](cell:harmonic/centre=site/angle)
degrees around a site and [11.6](cell:harmonic/centre=bond/angle) around a bond, where its cosine is
[0.980](cell:harmonic/centre=bond/cosine). What this means for a kick is a matter of `sec33_mobility`. */
void report_pinning_mode(Report& report, Table& harmonic, Centre centre) {
  const auto problem = problem_at(centre, {omega_b, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Spectrum all = spectrum<Wide>(problem, orbit);
  const Vector<double> g = gradient(orbit.start.y).normalized();
  const double in_double = alignment(spectrum<double>(problem, orbit).mode, g);
  const double cosine = alignment(all.mode, g);
  const auto degrees = [](double x) { return std::acos(x) * 180 / std::numbers::pi; };
  harmonic.add({{"centre", "site or bond", name_of(centre)},
                {"kappa", "of the pinning pair", all.kappa()},
                {"others", "largest modulus of the other multipliers, minus one",
                 excess(all.pairs, 1), "", "difference of two resolutions, relative to one"},
                {"cosine", "of the angle between pinning mode and discrete gradient",
                 compare(in_double, cosine), "", "from two precisions"},
                {"angle", "this angle", compare(degrees(in_double), degrees(cosine)), "degree",
                 "from two precisions"}});

  // Both vectors, bead by bead; the sign of an eigenvector is chosen as that of the gradient
  const Vector<double> mode = all.mode.dot(g) < 0 ? -all.mode : all.mode;
  Table& table = report.table("mode_" + name_of(centre));
  for (Eigen::Index i = 0; i < g.size(); ++i)
    table.add({{"n", "site", site_number(std::size_t(i), std::size_t(g.size()))},
               {"mode", "pinning mode, positions at t = 0", mode[i]},
               {"gradient", "discrete gradient of the breather, normalised", g[i]}});
}

/**
## Towards $\omega_b = 1$

Is the instability of the DpS equation that of the chain? There the site-centred breather of frequency $\mu$ is unstable
at the rate $\sigma = 0.00156\,\mu$ (`sec33_dps_stability`), in units of the slow time of section 3.1, with the constant
$\tau_0$. By Eq. (20) a breather of the chain of size $\epsilon$ has $\delta = \omega_b-1 = \epsilon^{1/2}/(2\tau_0)$.
So if the same holds for the chain, its rate $\ln\lambda/T_b$ tends to $0.00156\,\delta$: weaker by $O(\epsilon^{1/2})$,
as the article says. We compute breathers near $\omega_b = 1$ in extended precision. Neighbours give the exponent of the
rate in $\epsilon$, and both the exponent and the rate over $\delta$ are extrapolated linearly in $\delta$. The error is
the difference from the extrapolation one breather earlier, plus what the errors of the rates contribute.

| quantity | article | here |
|---|---|---|
| rate over $\delta$, at $\delta = 0.1$ | | [0.00038](cell:towards_one/delta=0.1/relative_rate) |
| the same at $10^{-4}$ | | [0.00155](cell:towards_one/delta=1e-4/relative_rate) |
| its limit | | [0.0015577 ± 3e-7](cell:slow_limit/relative_rate) |
| the same by the DpS equation | | [0.0015577](cell:slow_limit/dps) |
| rate $\propto\epsilon^p$, exponent $p$ | 1/2 | [0.500](cell:slow_limit/exponent) |

The two routes agree. The limit is approached slowly: at $\omega_b = 1.1$ the instability of the chain is four times
weaker than the DpS equation suggests. */
constexpr double deltas[] = {omega_b - 1, 8e-4, 4e-4, 2e-4, 1e-4};  // from the second on halved

/// ln(lambda) / T_b of the site-centred breather in the linear well, where lambda is real.
Estimate growth_rate(double delta) {
  const auto problem = problem_at(Centre::site, {1 + delta, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Estimate kappa = spectrum<Wide>(problem, orbit).kappa();
  const double root = std::sqrt(kappa.value);
  return {2 * std::asinh(root) / orbit.period(), kappa.error / root / orbit.period()};
}

/// To delta = 0 from the last two of these values and from the two before them, where delta is halved each time.
Estimate extrapolated_to_zero(const std::vector<Estimate>& x) {
  const std::size_t n = x.size();
  const auto line = [](const Estimate& far, const Estimate& near) {
    return Estimate{2 * near.value - far.value, 2 * near.error + far.error};
  };
  return compare(line(x[n - 3], x[n - 2]), line(x[n - 2], x[n - 1]));
}

void report_slow(Report& report) {
  Table& table = report.table("towards_one");
  std::vector<double> log_eps;
  std::vector<Estimate> log_rate, relative, exponent;
  for (const double delta : deltas) {
    const Estimate rate = growth_rate(delta);
    const double eps = breather_eps(1 + delta);
    table.add({{"delta", "omega_b - 1", delta},
               {"eps", "size of the breather, Eq. (20)", eps},
               {"rate", "growth rate of a perturbation of the site-centred breather", rate,
                "inverse unit of time"},
               {"relative_rate", "the same over delta", quotient(rate, exact(delta))}});
    relative.push_back(quotient(rate, exact(delta)));
    log_eps.push_back(std::log(eps));
    log_rate.push_back({std::log(rate.value), rate.error / rate.value});
  }
  for (std::size_t k = 1; k < relative.size(); ++k) {
    const Estimate change{log_rate[k].value - log_rate[k - 1].value,
                          log_rate[k].error + log_rate[k - 1].error};
    exponent.push_back(quotient(change, exact(log_eps[k] - log_eps[k - 1])));
  }
  const char* how = "from two extrapolations, and from the errors of the rates";
  report.table("slow_limit")
      .add({{"exponent", "of the rate as a power of eps", extrapolated_to_zero(exponent), "", how},
            {"relative_rate", "limit of rate over omega_b - 1", extrapolated_to_zero(relative), "",
             how},
            {"dps", "the same by the DpS equation",
             margin_of<long double>(Centre::site, 1, sites_of(Centre::site)).exponent}});
}

/**
## Over the plane of $\omega_b$ and $s$

Is it always so, for the values of $\omega_b$ in $(1,2]$ and $s$ in $[-1,1]$ that the article does not list? We add ten
frequencies and ten values of $s$, as far as the families reach (plane.hpp). *Near* $+1$ is ours: the fourth multiplier
within 0.01 of it and ten times nearer than the fifth. To test the accumulation we add ten sites, which must add twenty
multipliers there, for $s = -1$, 0 and 1. */
const std::vector<double> wells_of_plane{1, 0.75, 0.5, 0.25, 0, -1.0 / 6, -0.25, -0.5, -0.75, -1};

std::vector<double> frequencies_of_plane(bool quick) {
  std::vector<double> omegas{1.01};  // 1.1 is in the tables against s
  for (int k = 2; k <= (quick ? 3 : 10); ++k) omegas.push_back(1 + 0.1 * k);
  return omegas;
}

/**
![Distance of the fourth multiplier from $+1$, bond-centred; triangles: others have left the circle.](fig:x64)

Ten sites always add twenty multipliers. In the linear well, and at $\omega_b = 1.1$ for all $s$, the structure is as
the article says. It is lost in two places. In hard wells of $s \ge \frac14$ the pinning pair leaves $+1$ as the
frequency grows: at $s = 1$ its distance is [0.0207](cell:spectra/centre=bond/omega=1.5/s=1/fourth) at $\omega_b = 1.5$
and [1.061](cell:spectra/centre=bond/omega=2/s=1/fourth) at 2, about as far as that of the fifth. In soft wells, near
the end of the family, others collide elsewhere on the circle and leave it, by
[0.286](cell:spectra/centre=bond/omega=1.9/s=-1/6/others) at $\omega_b = 1.9$ and $s = -\frac16$, which the article's
word *includes* does not exclude. */
void report_plane(Report& report, const Family& site, const Family& bond) {
  Table &spectra = report.table("spectra"), &edges = report.table("edges");
  const std::vector<double> omegas = frequencies_of_plane(report.quick);
  for (const auto& [centre, at_omega_b, exchange] : {site, bond}) {
    std::vector<BreatherAt> all = at_omega_b;
    for (const BreatherAt& at : breathers_over_the_plane(centre, omegas, wells_of_plane))
      all.push_back(at);
    add_spectra(spectra, centre, all);
    add_edges(edges, centre, all);
  }
}

/**
The exchange at 0.1525 belongs to $\omega_b = 1.1$ and quartic wells: at other frequencies it lies elsewhere, and next
to it a third breather, centred on neither site nor bond, may exist (`sec33_between`). We do not know why it lies at
this $s$. */
void reproduce(Report& report) {
  report.output.note("tolerance", "128 and 2048 machine epsilons, unless a table says else");
  report.output.note("seed", "1 to 8 for the noise on the matrix");
  // All s at one frequency, and the exchange of stability
  const int steps = report.quick ? 4 : steps_to_one;
  const Family site = family_of(Centre::site, steps), bond = family_of(Centre::bond, steps);
  for (const Family& family : {site, bond}) report_over_s(report, family);
  const Estimate slope = slope_of_kappa(site);
  report_exchange(report, site.exchange.place, bond.exchange.place, slope);

  // How accurate the multipliers are, and what errors do to the exchange
  const auto problem = problem_at(Centre::bond, {omega_b, 0});
  const Orbit<double> breather = find_breather(problem);
  report_tolerances(report, problem, breather);
  report_threshold(report);
  add_noise(report.table("matrix_errors"), problem, breather, slope);

  // The pinning mode, small amplitudes, and all other breathers
  Table& harmonic = report.table("harmonic");
  for (Centre centre : both_centres) report_pinning_mode(report, harmonic, centre);
  report_slow(report);
  report_plane(report, site, bond);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `floquet.spectrum`: the spectrum always includes four multipliers in the immediate vicinity of +1, and others accumulate on the circle at exp(+-2 pi i/omega_b) | structure | fails 68 of 670 comparisons; first spectra.fourth (centre = site, omega = 1.5, s = 0.75): 0.01222 < 0.01; by most spectra.fourth (centre = bond, omega = 2, s = 1): 1.061 < 0.01 | in part |
| `floquet.s0_bond`: anharmonicity at which the bond-centred breather loses stability (omega_b = 1.1) | 0.26 | 0.1525 | discrepant |
| `floquet.s0_site`: anharmonicity above which the site-centred breather is stable (omega_b = 1.1) | 0.05 | 0.1525 | discrepant |
| `floquet.collision`: a pair of multipliers leaves the circle at +1 for larger s around a bond, and one with lambda > 1 enters it there for larger s around a site | above; below | spectra.fourth (centre = site, omega = 1.1, s = 0.1515): 1.737e-05 < 0.0001 (the closest of 138) | holds |
| `floquet.harmonic`: at s = 0 and omega_b = 1.1 the site-centred breather is weakly unstable and the bond-centred one stable | verdict | site_against_s.largest_modulus (s = 0): 0.0002143 < 0.001 (the closest of 5) | holds |
| `floquet.instability_size`: unstable multipliers of section 3.3 (omega_b = 1.1) exceed 1 by less than | 1e-3 | site_against_s.largest_modulus (s = -1): 0.0005839 < 0.001 (the closest of 134) | holds, assuming |
| `pinning.gradient`: pinning mode is close to the discrete gradient for both breathers | very close | 0.9797 | quantified |
| `outlook.sign_of_s`: stability depends on the strength (and sign) of the anharmonicity | depends | site_against_s.kappa (s = 0.1): 0 < 3.959e-09 (the closest of 140) | holds |
| `floquet.weaker`: the instability is O(epsilon^(1/2)) times weaker in the chain than in the DpS equation | 0.5 | 0.500 | reproduced |
<!-- /statements -->

## Try it

**To change it.** `omega_b` is the frequency of figures 11 to 13 (with 1.15 the exchange moves to 0.0188; the section on
the printed values, at 1.1, then means nothing), `wells_of_plane` and `frequencies_of_plane` span the plane, `deltas`
leads to $\omega_b = 1$. The exchange is sought between neighbours in $s$; the run stops if there is none. Other wells,
contacts or masses: `multipliers --well`, `--contact`, `--mass-ratio`, or `kappas` with your chain and breather.

1. *Easy.* At a slightly higher frequency the exchange lies elsewhere:
   `build/bin/sec33_floquet exchange --centre bond --omega 1.15` gives `s0` = 0.018781. Hint: follow it on. Where
   does the curve of exchange reach the linear well?
2. *Harder.* Which breather is stable can be decided without multipliers.
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.05` gives `equal_area` = -1.58248e-13, and
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.26` gives `equal_area` = 1.66492e-13. Hint: at equal action the
   breather of higher energy is the stable one here, because the effective mass is negative (`sec33_mobility`). Does
   this agree with $\kappa$, and with the printed exchanges? */
int main(int argc, char** argv) {
  return run({"sec33_floquet", "3.3", "Stability of the breathers (section 3.3)", reproduce,
              commands<Multipliers, Exchanges>()},
             argc, argv);
}
