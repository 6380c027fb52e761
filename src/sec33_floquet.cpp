/**
# 3.3 Stability of the breathers

A breather is stable if small changes stay small. The Floquet multipliers $\lambda$ are the factors by which
small changes grow in one period. Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) finds
four of them so close to $+1$ that the breathers are almost free to move. In the linear well at $\omega_b = 1.1$ the
site-centred breather is weakly unstable and the bond-centred one stable. This depends on the strength and the sign of
the anharmonicity $s$ of the well, the article says: the multipliers pass through $+1$ at some $s_0$, beyond which the
site-centred breather is the stable one. It prints $s_0 \approx 0.26$ around a bond and $0.05$ around a site. We find
that the two differ by [3.22e-7](num:sec33_floquet.exchange_gap) only, and that between them there is a third breather,
which is centred neither on a site nor on a bond.

The article says more: near $\omega_b = 1$ the instability is weaker than that of the DpS equation by a factor of
$O(\epsilon^{1/2})$, where $\epsilon$ is the size of the breather; and the *pinning mode*, which shifts the breather along
the chain, is very close to its discrete gradient. That all other multipliers lie on the unit circle, where they
accumulate at $e^{\pm 2\pi i/\omega_b}$, is true on the lines $\omega_b = 1.1$ and $s = 0$; that unstable ones exceed
one by less than $10^{-3}$ is true at the frequency of its figures. `sec33_between` looks at the whole plane. */
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "commands/multipliers.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/numerics/progress.hpp"
#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"
#include "sec33/exchange.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eqs. (6) and (10), the breathers those of section 3.2. Multipliers come in pairs
$\lambda, 1/\lambda$. One pair is exactly $+1$ for every breather, the *time-translation pair*. The *pinning pair* belongs
to a shift along the chain. Each pair is one number
$$\kappa = \tfrac14\Bigl(\lambda+\frac1\lambda-2\Bigr),$$
an eigenvalue of an $N\times N$ matrix made of half a period of the linearised flow, from which the time-translation pair is
removed (floquet.hpp). Why not $\lambda$ itself? At $+1$ the monodromy matrix has a double eigenvalue with one
eigenvector, and an error $\eta$ of the matrix splits it by $\sqrt\eta$: $10^{-8}$ in the flow would cost $10^{-4}$ in
$\lambda$. The $\kappa$ of the pinning pair is a simple eigenvalue and changes in proportion to $\eta$ only. A pair on the unit circle
has $-1\le\kappa\le0$; a pinning pair becomes unstable where $\kappa$ passes zero, and there
$\ln\lambda \simeq 2\sqrt\kappa$: then a small shift along the chain grows instead of swinging back, and the breather
slides away from its place. Other pairs may leave the circle at $-1$ ($\kappa < -1$) or as a quadruplet (complex
$\kappa$); here, at $\omega_b = 1.1$, we look at all of them, and `sec33_between` at other frequencies. The whole
spectrum is computed on the article's chains of 31 and 32 sites, the rest on shorter ones.

| article | program | meaning |
|---|---|---|
| $\omega_b$, $s$ | `omega_b`, `s` | frequency and anharmonicity |
| $\lambda$ | `multiplier` | Floquet multiplier |
| $s_0^b$, $s_0^s$ | `exchange` | where $\kappa$ of the pinning pair changes its sign |
| $g_n$ | `gradient` | discrete gradient, here of length one | */
constexpr double omega_b = 1.1;

std::string name_of(Centre centre) {
  return centre == Centre::bond ? "bond" : "site";
}

/**
## All multipliers at $\omega_b = 1.1$

What does the whole spectrum look like? Four multipliers lie near $+1$: around a site the fourth is at a distance of
[0.000214282](num:sec33_floquet.fourth_distance), the fifth at [0.229543](num:sec33_floquet.fifth_distance), and around
a bond these distances are the same to three digits. No other pair leaves the unit circle by more than its error, and
the others accumulate at $e^{\pm2\pi i/\omega_b}$: ten more sites add
[20](num:sec33_floquet.added_at_edge_site) multipliers there, within $10^{-9}$ in $\kappa$, and nowhere else. The table
holds the multipliers of both breathers on the article's chains, with the two of the time-translation pair, which are
exact. */
void report_spectrum(Report& report) {
  const Column bond = count("bond", "1 around a bond, 0 around a site");
  Table& table = report.table("multipliers", {multiplier_columns(), bond});
  for (Centre centre : both_centres) {
    const auto problem = problem_at(centre, {}, 10);
    const Spectrum all = spectrum<double>(problem, find_breather(problem));
    for (const auto& [z, error] : multipliers_of(all))
      table.add({z.real(), z.imag(), std::abs(z), std::arg(z), error, centre == Centre::bond});
    if (centre == Centre::bond) continue;

    // The fourth and the fifth, and what ten more sites add
    const auto longer = problem_at(centre, {}, 20);
    const Quadruplet here = quadruplet(all, omega_b),
                     there = quadruplet(spectrum<double>(longer, find_breather(longer)), omega_b);
    report.facts.add("fourth_distance", compare(there.fourth, here.fourth));
    report.facts.add("fifth_distance", compare(there.fifth, here.fifth));
    report.facts.add("added_at_edge_site", exact(there.at_edge - here.at_edge));
  }
}

/**
## The quadruplet against $s$ (figures 11 and 12)

Which breather is stable in which wells? Both are extrema of one potential of the centre, which has the period of the
chain (`sec32_barrier`). If that potential is nearly a sine, they are its only extrema in a period, one stable and the
other one not; which one also depends on the sign of the effective mass (`sec33_mobility`). When its amplitude passes
through zero as $s$ is changed, the potential turns upside down, and the two *exchange* their stability in almost the same
well. Only where the sine vanishes do higher harmonics matter; they decide what happens in between (`sec33_between`). So
two values as far apart as the printed ones would require a potential that is far from a sine in all wells between them.
To find them we follow each breather from the linear well to both ends of $-1 \le s \le 1$.

![Arguments and moduli of the four multipliers near one, bond-centred.](fig:11)
![The same around a site.](fig:12) */
struct OnLine : Spectrum {
  Spot spot{};
  Orbit<double> orbit{};
};

/// The breathers on a line through the plane, followed both ways from number `first`, which is known.
std::vector<OnLine> along(Centre centre, const std::vector<Spot>& line, std::size_t first,
                          const Orbit<double>& known) {
  const auto at = [&](std::size_t k) { return problem_at(centre, line[k]); };
  std::vector<OnLine> out(line.size());
  out[first].orbit = known;
  for (std::size_t k = first + 1; k < line.size(); ++k)
    out[k].orbit = follow(at(k), out[k - 1].orbit);
  for (std::size_t k = first; k-- > 0;) out[k].orbit = follow(at(k), out[k + 1].orbit);
  parallel_for(line.size(), [&](std::size_t k) {
    static_cast<Spectrum&>(out[k]) = spectrum<double>(at(k), out[k].orbit);
    out[k].spot = line[k];
  });
  return out;
}

std::vector<OnLine> along_wells(Centre centre, const std::vector<double>& wells) {
  std::vector<Spot> line;
  for (double s : wells) line.push_back({omega_b, s});
  const std::size_t middle = line.size() / 2;
  return along(centre, line, middle, find_breather(problem_at(centre, line[middle])));
}

/**
The sign of $\kappa$ tells what a figure of moduli and arguments must show. A pair on the circle has modulus
one exactly, a pair on the real axis the argument zero. The formulas of the columns keep all digits of a small
$\kappa$.

Near an exchange the multipliers leave $+1$ like square roots, so the sweep is denser there. Its largest instability,
[0.000583922](num:sec33_floquet.largest_excess), occurs around a site and is smaller than the $10^{-3}$ of the
article's conclusion. At $s = 0$, $\kappa$ is [1.14767e-8](num:sec33_floquet.kappa_site) around a site and
[-1.14768e-8](num:sec33_floquet.kappa_bond) around a bond: opposite and nearly equal, like the curvatures of a sine at
its top and its bottom. All other pairs are on the circle, so the article's verdict holds: around a site a multiplier
exceeds one by [0.000214282](num:sec33_floquet.excess_site), around a bond none does, within the error. */
std::array<std::vector<OnLine>, 2> report_wells(Report& report) {
  // From the linear well to both ends, more densely beside the exchange
  std::vector<double> wells;
  for (int steps = report.quick ? 4 : 40, k = -steps; k <= steps; ++k)
    wells.push_back(double(k) / steps);
  for (double beside : {0.001, 0.004, 0.01})
    wells.insert(wells.end(), {0.1525 - beside, 0.1525 + beside});
  std::sort(wells.begin(), wells.end());

  Estimate largest{};
  int off_circle = 0;
  std::array<std::vector<OnLine>, 2> lines;
  for (Centre centre : both_centres) {
    Table& table =
        report.table(name_of(centre) + "_against_s",
                     {number("s", "anharmonicity of the well"),
                      estimate("kappa", "(lambda + 1/lambda - 2) / 4 of the pinning pair", "",
                               "from two tolerances, against the neighbouring rows"),
                      number("argument", "of the multiplier in the upper half plane", "rad"),
                      number("argument_below", "of its partner", "rad"),
                      number("excess", "modulus of the larger multiplier minus one"),
                      number("excess_below", "modulus of the smaller multiplier minus one"),
                      number("error_of_multiplier", "of either multiplier"),
                      estimate("largest_modulus", "of all multipliers")});
    const auto& all = lines[centre == Centre::bond] = along_wells(centre, wells);
    for (std::size_t k = 0; k < wells.size(); ++k) {
      // On the circle a pair has arguments, on the real axis it has moduli
      const Pair& pair = all[k].pairs.front();
      const double kappa = pair.kappa.real(), error = pair.multiplier_error();
      const double angle = 2 * std::asin(std::sqrt(std::max(0.0, -kappa)));
      const double rate = 2 * std::asinh(std::sqrt(std::max(0.0, kappa)));
      table.add({wells[k], all[k].kappa(), angle, -angle, std::expm1(rate), std::expm1(-rate),
                 error, all[k].largest_modulus()});
      off_circle += quadruplet(all[k], omega_b).off_circle;
      largest = larger(largest, excess(all[k].pairs));
    }
  }

  // The largest instability at this frequency, and how many other pairs leave the circle in any of these wells
  report.facts.add("largest_excess", largest);
  report.facts.add("others_off_circle", exact(off_circle));
  return lines;
}

/**
## Four multipliers near $+1$ on two lines

The article does not say for which values of $\omega_b$ and $s$ it has computed the spectrum. We look at
$\omega_b = 1.1$, where it shows multipliers, for all $s$, and at all frequencies in the linear well. For $\omega_b \to 1$
the point of accumulation itself comes near $+1$, so that only the ratio of the distances of the fourth and the fifth
multiplier means something. Ten more sites add twenty multipliers at the point of accumulation only to $10^{-4}$ in
$\kappa$, because the tail of the breather still reaches the first of the new beads; we try every thirteenth frequency and
three wells.

On the two lines the statement is true: the fourth multiplier is no farther from $+1$ than
[0.000815379](num:sec33_floquet.spectrum_fourth), which is at most
[0.00254445](num:sec33_floquet.spectrum_share_of_fifth) of the distance of the fifth. Elsewhere it is not: in hard wells
the pinning pair leaves the neighbourhood of $+1$ towards high frequencies, and around a bond at $\omega_b = 2$ and
$s = 1$ it is [1.06121](num:sec33_floquet.fourth_in_hard_wells) away. */
void report_lines(Report& report, std::array<std::vector<OnLine>, 2> lines) {
  const int frequencies = report.quick ? 34 : 80;
  Estimate fourth{}, share{}, others{};
  std::vector<int> missing;
  for (std::size_t k : {0U, 1U}) {
    const Centre centre = both_centres[k];
    std::vector<OnLine>& seen = lines[centre == Centre::bond];
    std::vector<OnLine> ends;
    for (const OnLine& at : seen)
      if (const double s = at.spot.s; s == -1 || s == 0 || s == 1) ends.push_back(at);

    // The linear well from 1.01 to 2, and a breather at the corner of the plane
    std::vector<Spot> linear, corner;
    for (int i = 0; i < frequencies; ++i)
      linear.push_back({1.01 + 0.99 * double(i) / (frequencies - 1), 0});
    for (int i = 0; i <= 24; ++i) corner.push_back({2, double(i) / 24});
    const auto low = find_breather(problem_at(centre, linear.front()));
    const auto across = along(centre, linear, 0, low);
    if (centre == Centre::bond)
      report.facts.add("fourth_in_hard_wells",
                       from_one(along(centre, corner, 0, across.back().orbit).back().pairs[0]));
    for (std::size_t i = 0; i < across.size(); i += 13) ends.push_back(across[i]);
    seen.insert(seen.end(), across.begin(), across.end());

    for (const OnLine& at : seen) {
      fourth = larger(fourth, from_one(at.pairs[0]));
      share = larger(share, quotient(from_one(at.pairs[0]), from_one(at.pairs[1])));
      others = larger(others, excess(at.pairs, 1));
    }
    for (const OnLine& at : ends)
      missing.push_back(std::abs(20 - added_at_edge(centre, at.spot, at.orbit, at.pairs)));
  }
  report.facts.add("spectrum_fourth", fourth);
  report.facts.add("spectrum_share_of_fifth", share);
  report.facts.add("spectrum_others", others);
  report.facts.add("spectrum_not_at_edge",
                   exact(*std::max_element(missing.begin(), missing.end())));
}

/**
At $s = 0$ the sign of $\kappa$ is taken in extended precision (a 64-bit mantissa), where its error is eight orders of
magnitude below $\kappa$. As an independent check the pinning
pair is also computed from a matrix that the breather's symmetry has reduced. */
void report_harmonic(Report& report) {
  int off_circle = 0;
  for (Centre centre : both_centres) {
    const auto problem = problem_at(centre, {});
    const Orbit<double> orbit = find_breather(problem);

    // Two roads to one number: the pairs in extended precision, and the matrix that symmetry has reduced
    const Spectrum all = spectrum<Wide>(problem, orbit);
    off_circle += quadruplet(all, omega_b).off_circle;
    const Matrix<double> half = monodromy(problem.chain, orbit.start, orbit.period() / 2);
    const double again = pinning_by_symmetry(half, centre);
    report.facts.add("kappa_" + name_of(centre), all.kappa());
    report.facts.add("kappa_by_symmetry_" + name_of(centre), compare(all.kappa().value, again));
    if (centre == Centre::site) report.facts.add("excess_site", from_one(all.pairs.front()));
  }
  report.facts.add("harmonic_off_circle", exact(off_circle));
}

/**
Now the two exchanges themselves, the zeros of $\kappa$ in $s$ (exchange.hpp): [0.152519](num:floquet.s0_site) around a
site and [0.152520](num:floquet.s0_bond) around a bond. [](finding:exchange.equal) The slope of $\kappa$ there,
[7.5451e-8](num:sec33_floquet.exchange_slope) per unit of $s$, converts errors of $\kappa$ into errors of $s$: whoever
wants two digits of $s_0$ must know $\kappa$ to $10^{-9}$. */
std::array<Exchange, 2> both_exchanges() {
  // Around a site and around a bond; both lie between 0.1 and 0.2
  std::array<Exchange, 2> found;
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    found[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  return found;
}

/**
Could one cause move the first to 0.05 and the second to 0.26? Whoever reads exchanges from computed moduli has to say how
far beyond one a multiplier counts as off the circle. With such a threshold $\theta$ the instability seems to end too
early around a site and to begin too late around a bond. At the printed $s = 0.05$ a multiplier around a site exceeds one
by [0.000175756](num:sec33_floquet.excess_s_005_site), at $s = 0.26$ one around a bond by
[0.000180293](num:sec33_floquet.excess_s_026_bond); every $\theta$ from [0.000176041](num:sec33_floquet.theta_from) to
[0.000179983](num:sec33_floquet.theta_to) gives both numbers as they are printed, with two decimals. The article names no
threshold, so this is a possible cause and no more. */
void report_threshold(Report& report, const std::array<Exchange, 2>& found) {
  const auto excess_at = [&](std::size_t k, double s) {
    const auto problem = problem_at(both_centres[k], {omega_b, s});
    return from_one(spectrum<double>(problem, follow(problem, found[k].orbit)).pairs.front());
  };
  report.facts.add("excess_s_005_site", excess_at(0, 0.05));
  report.facts.add("excess_s_026_bond", excess_at(1, 0.26));
  // The instability falls with s around a site and rises around a bond
  report.facts.add("theta_from", larger(excess_at(0, 0.055), excess_at(1, 0.255)));
  report.facts.add("theta_to", smaller(excess_at(0, 0.045), excess_at(1, 0.265)));
}

void report_exchange(Report& report) {
  const std::array<Exchange, 2> found = both_exchanges();
  const Estimate site = found[0].place, bond = found[1].place;
  report.facts.add("exchange_site", site);
  report.facts.add("exchange_bond", bond);
  report.facts.add("exchange_gap", {bond.value - site.value, site.error + bond.error});

  // The slope of kappa between two wells, h on either side of the exchange
  const auto slope = [&](double h) {
    const auto kappa = [&](double s) {
      const auto problem = problem_at(Centre::site, {omega_b, s});
      return spectrum<double>(problem, follow(problem, found[0].orbit)).kappa();
    };
    const Estimate below = kappa(site.value - h), above = kappa(site.value + h);
    return Estimate{std::abs(above.value - below.value) / (2 * h),
                    (above.error + below.error) / (2 * h)};
  };
  report.facts.add("exchange_slope", compare(slope(0.02), slope(0.01)));
  report_threshold(report, found);
}

/**
The conclusion of the article says that the stability depends on the strength and the sign of the anharmonicity. In
weakly anharmonic wells of either sign the verdict is that of the linear one: at $s = -0.1$, 0 and $0.1$, $\kappa$ is
[1.89678e-8](num:sec33_floquet.kappa_s_minus_01_site), [1.14767e-8](num:sec33_floquet.kappa_site) and
[3.95898e-9](num:sec33_floquet.kappa_s_01_site) around a site,
[-1.89680e-8](num:sec33_floquet.kappa_s_minus_01_bond), [-1.14768e-8](num:sec33_floquet.kappa_bond) and
[-3.95900e-9](num:sec33_floquet.kappa_s_01_bond) around a bond. It is reversed in hard wells beyond the exchange,
$s >$ [0.152519](num:floquet.s0_site), and not in soft wells down to $s = -1$; all other pairs stay on the circle. At
$s = 1$ $\kappa$ is [-6.49051e-8](num:sec33_floquet.kappa_s_1_site) around a site and
[6.49031e-8](num:sec33_floquet.kappa_s_1_bond) around a bond, at $s = -1$
[8.51915e-8](num:sec33_floquet.kappa_s_minus_1_site) and [-8.51949e-8](num:sec33_floquet.kappa_s_minus_1_bond). So the
stability depends on both: a stronger anharmonicity of the same sign reverses both verdicts, one of the other sign that
is as strong does not. */
void report_strength(Report& report) {
  const std::vector<double> wells{-1, -0.5, -0.1, 0, 0.1, 0.5, 1};
  for (Centre centre : both_centres) {
    const auto all = along_wells(centre, wells);
    for (const auto& [k, well] : {std::pair(2, "minus_01"), {4, "01"}, {0, "minus_1"}, {6, "1"}})
      report.facts.add(std::string("kappa_s_") + well + "_" + name_of(centre), all[k].kappa());
  }
}

/**
## Towards $\omega_b = 1$

In the DpS equation the site-centred breather of frequency $\mu$ grows unstable at the rate
[0.00155771](num:sec33_floquet.dps_rate) $\mu$ in slow time, whatever its size. By Eq. (20) a breather of the chain of
size $\epsilon$ has $\omega_b-1 = \epsilon^{1/2}/(2\tau_0)$, and if the same happens in the chain its rate is
$\ln\lambda/T_b =$ [0.00155771](num:sec33_floquet.dps_rate) $(\omega_b-1)$, weaker by a factor of $O(\epsilon^{1/2})$.
Computed with $\omega_b-1 = 2\cdot10^{-4}$ and $10^{-4}$, the rate goes like $\epsilon$ to the power
[0.497](num:floquet.weaker); the error of this exponent is its change from $4\cdot10^{-4}$ and $2\cdot10^{-4}$. The rate
over $\omega_b-1$ tends to [0.00155770](num:sec33_floquet.slow_rate_limit), but slowly: at $\omega_b-1 = 10^{-4}$ it is
[0.0015503](num:sec33_floquet.slow_rate), and at $\omega_b = 1.1$ only a quarter of the limit. At
$\omega_b-1 = 10^{-4}$ $\kappa$ is so small that extended precision is needed for the rates. */
Estimate site_growth_rate(double beyond_one) {
  // ln(lambda) / T_b, since sinh(ln(lambda) / 2) is the root of kappa
  const auto problem = problem_at(Centre::site, {1 + beyond_one, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Estimate kappa = spectrum<Wide>(problem, orbit).kappa();
  const double root = std::sqrt(kappa.value);
  return {2 * std::asinh(root) / orbit.period(), kappa.error / root / orbit.period()};
}

void report_slow(Report& report) {
  const double beyond[] = {4e-4, 2e-4, 1e-4};
  std::array<Estimate, 3> rate;
  parallel_for(rate.size(), [&](std::size_t k) { rate[k] = site_growth_rate(beyond[k]); });

  // The exponent in eps, and what the rate over omega_b - 1 tends to, linearly
  const auto exponent = [&](std::size_t k) {
    const double ratio = std::log(breather_eps(1 + beyond[k]) / breather_eps(1 + beyond[k + 1]));
    return Estimate{
        std::log(rate[k].value / rate[k + 1].value) / ratio,
        (rate[k].error / rate[k].value + rate[k + 1].error / rate[k + 1].value) / ratio};
  };
  const auto limit = [&](std::size_t k) {
    return 2 * rate[k + 1].value / beyond[k + 1] - rate[k].value / beyond[k];
  };
  report.facts.add("rate_exponent", compare(exponent(0), exponent(1)));
  report.facts.add("slow_rate", {rate[2].value / beyond[2], rate[2].error / beyond[2]});
  report.facts.add("slow_rate_limit", compare(limit(0), limit(1)));
  report.facts.add("dps_rate",
                   margin_of<long double>(Centre::site, 1, sites_of(Centre::site)).exponent);
}

/**
## The pinning mode is the gradient (figure 13)

What motion belongs to the pinning pair? The breather starts from rest, so that the two eigenvectors, of $\lambda$ and
$1/\lambda$, have the same positions at $t = 0$ and opposite velocities. We compare these positions with
$y_{n+1}(0)-y_{n-1}(0)$, both of length one. (The article's $g_n$ divides by the sum of the squares, but an energy of
$c^2/2$ needs the square root of that sum.) The cosine of the angle between them is
[0.979741](num:sec33_floquet.cosine_bond) around a bond and [0.987389](num:sec33_floquet.cosine_site) around a site.

![Pinning mode and discrete gradient.](fig:13)

An eigenvector has no sign of its own, so it gets that of the gradient. The error of the cosine comes from two
precisions. */
void report_mode(Report& report) {
  for (Centre centre : both_centres) {
    const auto problem = problem_at(centre, {});
    const Orbit<double> orbit = find_breather(problem);
    Vector<double> g = gradient(orbit.start.y);
    g /= g.norm();

    // The angle between mode and gradient, in two precisions
    Vector<double> mode = spectrum<Wide>(problem, orbit).mode;
    const double coarse = alignment(spectrum<double>(problem, orbit).mode, g);
    report.facts.add("cosine_" + name_of(centre), compare(coarse, alignment(mode, g)));

    // Both vectors, bead by bead
    if (mode.dot(g) < 0) mode = -mode;
    Table& table =
        report.table("mode_" + name_of(centre),
                     {count("n", "site"), number("mode", "pinning mode, positions at t = 0"),
                      number("gradient", "discrete gradient, of length one"),
                      number("difference", "mode minus gradient")});
    for (Eigen::Index i = 0; i < g.size(); ++i)
      table.add(
          {site_number(std::size_t(i), std::size_t(g.size())), mode[i], g[i], mode[i] - g[i]});
  }
}

/**
## Differences and limits

The printed exchanges, 0.26 and 0.05, are discrepant. One threshold gives both, and `sec33_multiplier_errors` shows that
common tolerances, too, pull one number apart into two, with a gap of the printed size. The verdict at $s = 0$ survives,
because there $\kappa$ is far enough from zero. All this holds at $\omega_b = 1.1$, in quartic wells, and is no general
rule: at $s = 0$ the two breathers exchange their stability six times between $\omega_b = 1.003$ and 2, and near an
exchange a third breather may lie between them. `sec33_between` finds the exchanges and follows two families of such
breathers. Why the potential turns upside down at just these places is not known. */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  report_spectrum(report);
  report_lines(report, report_wells(report));
  report_harmonic(report);
  report_exchange(report);
  report_strength(report);
  report_slow(report);
  report_mode(report);
}

/**
## With your own parameters

`sec33_floquet multipliers` prints all multipliers of one breather (multipliers.hpp), and `sec33_floquet exchange
--centre bond` where the pinning pair passes $+1$ in the article's wells; other pairs, which may leave the circle
elsewhere, are not looked at. A pair may pass several times. The exchanges that are seen between $s=-1$ and $1$ are
printed, the one nearest to the linear well first; if there is none, the command fails rather than print an empty table. */
struct Exchanges : ChosenBreather {
  static constexpr Title title{"exchange", "anharmonicity at which the pinning pair passes +1"};

  Table table() const {
    auto [from, to, found] = exchanges_in_wells(centre, omega_b);
    if (found.empty())
      throw Failure("no exchange of stability between s = " + short_text(from) + " and " +
                    short_text(to) + " at omega_b = " + short_text(omega_b));
    const auto nearer = [](const Estimate& a, const Estimate& b) {
      return std::abs(a.value) < std::abs(b.value);
    };
    std::sort(found.begin(), found.end(), nearer);
    Answers q;
    for (std::size_t k = 0; k < found.size(); ++k)
      q.add_small(
          k ? "s0_" + std::to_string(k + 1) : "s0", found[k], "",
          "anharmonicity s at which kappa of the pinning pair changes its sign; looked for "
          "from s = " +
              short_text(from) + " to " + short_text(to) +
              ", where the amplitude changes by less than three per cent from one look to the "
              "next; two zeros between two looks may be missed");
    return q.table;
  }
};

/**
## Try it

1. *Easy.* At a frequency a little higher the exchange lies elsewhere:
   `build/bin/sec33_floquet exchange --centre bond --omega 1.15` gives `s0` = 0.018781, while at 1.05 the command finds none.
   Hint: the curves of exchange on the chart of `sec33_between` are slanted, and cross $s = 0$ at six frequencies. To which
   of them does this curve lead?
2. *Harder.* Which breather is stable can be told without multipliers.
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.05` gives `equal_area` = -1.58248e-13, and
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.26` gives `equal_area` = 1.66492e-13.
   Hint: at equal action the breather of higher energy is the stable one here, because the effective mass is negative
   (`sec33_mobility`). Is this in accord with $\kappa$, and with the printed exchanges?
3. *Open.* Near the ends of soft families other pairs leave the unit circle (`sec33_between`): by which collisions? */
int main(int argc, char** argv) {
  return run({"sec33_floquet", "3.3", "Stability of the breathers (section 3.3)", reproduce,
              commands<Multipliers, Exchanges>()},
             argc, argv);
}
