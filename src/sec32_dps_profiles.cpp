/**
# 3.2 Static breathers of the DpS equation

In the limit of small amplitude a breather is a pattern that only turns, $v_n = u_n e^{i\mu t}$. Section 3.2 of James,
Kevrekidis and Cuevas (Physica D 251, 2013) has two, both narrow, with neighbours on opposite sides: one around a site,
$u_{-n} = u_n$, and one around a bond, $u_{1-n} = -u_n$.

![Both breathers, their quasi-continuum approximation and their tails.](fig:x03)

The article states that their amplitude is proportional to $\mu^2$ at unchanged width, and that an approximation which
vanishes outside of $|x| \le 3\pi/2$ is in excellent agreement with them. We compute both to the last digit, with their
tails, measure how good that approximation is, and find that the two have almost the same norm, which suggests that a
small breather moves at little cost (section 3.3). The breathers of the chain have a chapter of their own. */

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_profile.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/continuum.hpp"
#include "sec32/two_precisions.hpp"

using namespace lattice;

/**
## Model

In the rescaled time of Eq. (11) the DpS equation reads
$$i\dot v_n = (v_{n+1}-v_n)|v_{n+1}-v_n|^{1/2} - (v_n-v_{n-1})|v_n-v_{n-1}|^{1/2}.$$
With $v_n = u_n e^{i\mu t}$ and real $u_n$ it becomes Eq. (14), $-\mu u_n = w_n - w_{n-1}$, where $w_n = d_n|d_n|^{1/2}$
is the force of the strain $d_n = u_{n+1}-u_n$. The ends are free: there the outer contact is missing. A breather of the
chain with frequency $\omega_b$ is then nearly $y_n = 2\epsilon\,u_n\cos\omega_b t$, where $\mu = 1$ and
$\omega_b = 1 + \epsilon^{1/2}/(2\tau_0)$ (Eq. (20)). In the program $\mu$ is `mu`, $u_n$ is `Stationary::u`, $w_n$ is
`three_halves(strain[n])` and the approximate envelope $g$ is `quasi_continuum_envelope`. */
constexpr std::pair<Centre, const char*> centres[] = {{Centre::site, "site"},
                                                      {Centre::bond, "bond"}};

/**
## Method

The unknowns are the strains of one half of the chain; the symmetry gives the other half and removes the only direction
in which Newton's method could drift, a shift along the chain. The equations of Eq. (14) at neighbouring sites,
subtracted, contain strains alone, $w_{n+1} - 2w_n + w_{n-1} + \mu d_n = 0$. In the tail each strain follows from the
one before, $d_n \approx -w_{n-1}/\mu$, without cancellation, so every site is found with the same relative accuracy
(standing/stationary.hpp). Everything is computed in double and in quadruple precision, and the difference is the error
(sec32/two_precisions.hpp).

Does the computed profile solve the equation? We insert it and divide by $\mu u_n$ at each site, so that the tail is
tested as sharply as the centre; sites whose values are too small for the full mantissa are left out. The
double-precision profiles leave at most [4e-16](num:sec32_dps_profiles.residual_site) (site) and
[4e-16](num:sec32_dps_profiles.residual_bond) (bond). */
template <class T>
double relative_residual(const Stationary<T>& state) {
  using std::abs;
  const T least = least_exact<T>();
  const auto& u = state.u;
  double worst = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (abs(u[i]) < least) continue;
    const T right = i + 1 < u.size() ? three_halves<T>(u[i + 1] - u[i]) : T(0);
    const T left = i > 0 ? three_halves<T>(u[i] - u[i - 1]) : T(0);
    worst = std::max(worst, rounded<T>(abs((state.mu * u[i] + right - left) / (state.mu * u[i]))));
  }
  return worst;
}

/**
## Norm and contact sum

Newton's method does not use every consequence of the equation, and one of them is a check. Multiplying by $u_n$ and
summing by parts gives $\sum|u_{n+1}-u_n|^{5/2} = \mu N$ with the norm $N = \sum u_n^2$. In quadruple precision this
holds to [2e-34](num:sec32_dps_profiles.identity_quad_site) and [2e-34](num:sec32_dps_profiles.identity_quad_bond).

How easily does a small breather move? On the way from site to site it has to cross the other centre. In the limit of
small amplitude the energy of the chain's breather is $2\epsilon^2 N$, so at equal frequency the two energies differ by
the same fraction as the two norms. (A breather that moves keeps its area, not its frequency; what the crossing then
costs is the subject of sec32_barrier.cpp.) The norms are [0.00536042](num:sec32_dps_profiles.norm_site) around a site
and [0.00536041](num:sec32_dps_profiles.norm_bond) around a bond; the second minus the first, relative to the first, is
[-1.33110e-6](num:sec32_dps_profiles.norm_gap_relative), which makes it plausible that tiny breathers move at a slight
push. */
template <class T>
std::pair<T, T> gap_and_norm(T one) {
  const T site = stationary<T>(Centre::site, one, 31).norm();
  return {stationary<T>(Centre::bond, one, 32).norm() - site, site};
}

void report_norms(Report& report) {
  const auto broken = [](const auto& s) {
    return std::abs(rounded(s.contact_sum() / (s.mu * s.norm()) - 1));
  };
  for (const auto& [centre, name] : centres) {
    const auto add = [&](const std::string& what, const Estimate& e) {
      report.facts.add(what + "_" + name, e);
    };
    add("norm", in_two_precisions(centre, [](const auto& s) { return s.norm(); }));
    add("amplitude", in_two_precisions(centre, [](const auto& s) { return largest(s); }));
    add("identity_quad", remainder<Quadruple, FiftyDigits>(centre, broken));
    add("residual",
        remainder<double, long double>(centre, [](const auto& s) { return relative_residual(s); }));
  }
  const auto extended = gap_and_norm(1.0L);
  const auto quad = gap_and_norm(Quadruple(1));
  const Estimate difference = compare(rounded(extended.first), rounded(quad.first));
  const double site = rounded(quad.second);
  report.facts.add("norm_gap", difference);
  report.facts.add("norm_gap_relative", {difference.value / site, difference.error / site});
}

/**
## The approximate profile

The forces $w_n$ of both breathers alternate in sign with a smooth envelope, $w_n = (-1)^n f(n)$. Replacing $f(n\pm1)$
by three terms of a Taylor series gives Eq. (17), $F'' = -4F + F|F|^{-1/3}$. Its last term has an infinite slope at
$F = 0$, which lets a solution reach zero and stay there. Multiplied by $F'$ and integrated with $F = F' = 0$ at the
edge it becomes $F'^2 = \frac65F^{5/3} - 4F^2$. So $F$ is largest at $F^{1/3} = \frac3{10}$, and the half-width of the
support is the integral of $dF/|F'|$ from zero to there, [4.71239](num:dps.qc_support).

The printed $g(x) = (3/10)^3\cos^6(x/3)$ is that solution, as one sees by inserting it, and it vanishes there.

With $F = z^3$ the integrand behaves like an inverse square root at both ends. GSL has the Gauss rule for exactly that
weight, named after Chebyshev. We divide the integrand by the weight and apply the rule with 8 and with 16 nodes; the
difference is the error. */
double quasi_continuum_half_width(std::size_t nodes) {
  const double top = 0.3;
  using Rule =
      std::unique_ptr<gsl_integration_fixed_workspace, void (*)(gsl_integration_fixed_workspace*)>;
  const Rule rule(gsl_integration_fixed_alloc(gsl_integration_fixed_chebyshev, nodes, 0, top, 0, 0),
                  gsl_integration_fixed_free);
  if (!rule) throw Failure("half-width of the support: no memory for the rule");
  gsl_function remainder{[](double z, void* end) {
                           const double z2 = z * z, slope = z2 * std::sqrt(z * (1.2 - 4 * z));
                           const double from_end = *static_cast<const double*>(end) - z;
                           return 3 * z2 * std::sqrt(z * from_end) / slope;
                         },
                         const_cast<double*>(&top)};
  double width = 0;
  gsl_integration_fixed(&remainder, &width, rule.get());
  return width;
}

/**
## How good is it? (figure x03)

The article calls the agreement of breathers and approximation excellent, a word without a number. We give the number
and pass no judgement: the largest difference over the sites relative to the largest displacement
(`continuum_difference` of continuum.hpp) is [0.0574512](num:sec32_dps_profiles.qc_difference_site) around a site and
[0.0614325](num:sec32_dps_profiles.qc_difference_bond) around a bond. It occurs one or two sites beside the largest
displacement, where the approximate profile is too wide.

One number hides where the profiles differ, so we also compare the largest displacement alone,
[0.0149102](num:sec32_dps_profiles.qc_peak_difference_site) and
[0.000187130](num:sec32_dps_profiles.qc_peak_difference_bond), and the norm $N$, of which the approximation has too much
by the fraction [0.0600350](num:sec32_dps_profiles.qc_norm_difference_site) and
[0.0600365](num:sec32_dps_profiles.qc_norm_difference_bond). */
template <class T>
T peak_difference(const Stationary<T>& state) {
  using std::abs;
  const long n = state.centre == Centre::site ? 0 : 1;
  return abs(quasi_continuum<T>(state.centre, n) / state.u[site_index(n, state.u.size())] - T(1));
}

template <class T>
T norm_difference(const Stationary<T>& state) {
  using std::abs;
  T norm(0);
  for (std::size_t i = 0; i < state.u.size(); ++i) {
    const T u = quasi_continuum<T>(state.centre, site_number(i, state.u.size()));
    norm += u * u;
  }
  return abs(norm / state.norm() - T(1));
}

// Some moduli are far below the smallest double, so their logarithms are taken in quadruple precision
void report_profiles(Report& report) {
  report.facts.add("qc_support",
                   compare(quasi_continuum_half_width(8), quasi_continuum_half_width(16)));
  for (const auto& [centre, name] : centres) {
    // How far each breather is from it: as a whole, at its peak, in its norm
    const std::string suffix = std::string("_") + name;
    report.facts.add(
        "qc_difference" + suffix,
        in_two_precisions(centre, [](const auto& s) { return continuum_difference(s); }),
        "share of the amplitude");
    report.facts.add("qc_peak_difference" + suffix,
                     in_two_precisions(centre, [](const auto& s) { return peak_difference(s); }));
    report.facts.add("qc_norm_difference" + suffix,
                     in_two_precisions(centre, [](const auto& s) { return norm_difference(s); }));

    // Site by site
    Table& table = report.table(
        "profile" + suffix,
        {count("n", "site", "site"),
         estimate("u", "stationary DpS breather, mu = 1", "",
                  "difference of double and quadruple precision"),
         number("quasi_continuum", "quasi-continuum profile"),
         number("log10_u", "decimal logarithm of |u_n|"),
         number("log10_quasi_continuum", "that of the profile's modulus; nan where it is zero"),
         number("double_log", "ln(-ln|u_n|)"),
         number("tail_line", "slope ln(3/2), through the last point")});
    const auto u = stationary<double>(centre, 1, sites_of(centre)).u;
    const auto wide = stationary<Quadruple>(centre, 1, u.size()).u;
    const auto double_log = [&](std::size_t i) {
      return rounded(Quadruple(log(-log(abs(wide[i])))));
    };
    for (std::size_t i = 0; i < u.size(); ++i) {
      const long n = site_number(i, u.size()), last = site_number(u.size() - 1, u.size());
      const long distance = centre == Centre::bond && n < 1 ? 1 - n : std::abs(n);
      const double near = quasi_continuum(centre, n);
      table.add({n, Estimate{u[i], std::abs(rounded(Quadruple(u[i] - wide[i])))}, near,
                 rounded(Quadruple(log10(abs(wide[i])))),
                 near != 0 ? std::log10(std::abs(near)) : std::nan(""), double_log(i),
                 double_log(u.size() - 1) + double(distance - last) * std::log(1.5)});
    }
  }
}

/**
## The tail

The article calls the decay super-exponential, and this follows from the equation. Far from the centre $u_n$ is small
against $u_{n-1}$, so $-\mu u_n \approx -w_{n-1}$ and $|u_n| \approx |u_{n-1}|^{3/2}/\mu$. At $\mu = 1$ the ratio
$\ln|u_{n+1}|/\ln|u_n|$ therefore tends to 3/2, and $\ln(-\ln|u_n|)$ in the figure to a straight line of slope
$\ln\frac32$. It does so very fast: from one site to the next the distance from 3/2 is raised to nearly the power 3/2.
At $n = 4$, where the profile has just become invisible in a plot, the ratio is
[1.49856](num:sec32_dps_profiles.tail_ratio_4_site), and at $n = 8$ it differs from 3/2 by
[1.0588e-12](num:sec32_dps_profiles.tail_distance_8_site).

The tail also shows how little the free ends matter: a missing contact would have pulled by the size of the tail. On 15
sites the breather differs from that on 31 by [1.15790e-21](num:sec32_dps_profiles.free_end_effect_15_sites), less than
the rounding of double precision, so quadruple precision is compared with 50 digits. */
template <class T>
double free_end_effect() {
  const auto short_one = stationary<T>(Centre::site, T(1), 15);
  const auto long_one = stationary<T>(Centre::site, T(1), 31);
  T apart(0);
  for (std::size_t i = 0; i < 15; ++i)
    if (abs(short_one.u[i] - long_one.u[i + 8]) > apart)
      apart = abs(short_one.u[i] - long_one.u[i + 8]);
  return rounded(apart);
}

void report_tails(Report& report) {
  Table& table = report.table(
      "tails", {label("centre", "site or bond"), count("n", "site", "site"),
                estimate("ratio", "ln|u_(n+1)| / ln|u_n|", "",
                         "difference of double and quadruple precision, nan beyond double"),
                number("distance", "|ratio - 3/2| in quadruple precision")});
  for (const auto& [centre, name] : centres) {
    const auto one = stationary<double>(centre, 1, sites_of(centre)).u;
    const auto four = stationary<Quadruple>(centre, 1, sites_of(centre)).u;
    for (std::size_t i = site_index(1, four.size()); i + 1 < four.size(); ++i) {
      // The ratio in both precisions, as far as double goes
      const Quadruple wide = log(abs(four[i + 1])) / log(abs(four[i]));
      const double coarse = one[i + 1] != 0
                                ? std::log(std::abs(one[i + 1])) / std::log(std::abs(one[i]))
                                : std::nan("");
      const Estimate ratio = compare(coarse, rounded(wide));
      const Estimate distance{rounded(Quadruple(abs(wide - Quadruple(1.5)))), ratio.error};
      const long n = site_number(i, four.size());
      table.add({name, n, ratio, distance.value});

      // Two sites for the text
      if (centre == Centre::site && n == 4) report.facts.add("tail_ratio_4_site", ratio);
      if (centre == Centre::site && n == 8) report.facts.add("tail_distance_8_site", distance);
    }
  }
  report.facts.add("free_end_effect_15_sites",
                   compare(free_end_effect<Quadruple>(), free_end_effect<FiftyDigits>()));
}

/**
## Scaling with the frequency

If $u$ solves the equation at $\mu = 1$, $\mu^2u$ solves it at $\mu$. The computation must find this law without being
told, so we continue the branch from $\mu = 1$ to 64 and to 1/64 in steps of an eighth of an octave, and each time start
Newton's method from the *unscaled* strains of the neighbour. The exponent is the slope of $\ln\max|u_n|$ against
$\ln\mu$, the width is the participation number $(\sum u_n^2)^2/\sum u_n^4$, the number of sites that share the norm.
The amplitude grows with the exponent [2.00000](num:dps.scaling), and over 12 octaves of $\mu$ the relative change of
the width is [7e-16](num:sec32_dps_profiles.width_change_site). */
struct Scaling {
  Estimate exponent{}, width{}, width_change{};
};

/**
Each state starts from the four strains of a short chain around the centre of its neighbour; its tail is computed anew.
*/
template <class T>
Line branch_exponent(Centre centre, int steps, std::vector<double>& widths) {
  using std::exp2;
  using std::log;
  std::vector<double> x, y;
  for (int direction : {1, -1}) {
    auto state = stationary<T>(centre, T(1), sites_of(centre));
    for (int k = 1; k <= steps; ++k) {
      const T mu = exp2(T(direction * k) / T(8));
      std::vector<T> start(state.strain.begin(), state.strain.begin() + long(short_chain()));
      state = stationary_from<T>(centre, mu, std::move(start), sites_of(centre));
      std::vector<double> density;
      for (const T& u : state.u) density.push_back(rounded<T>(u * u / (mu * mu)));
      x.push_back(rounded<T>(log(mu)));
      y.push_back(rounded<T>(log(largest(state))));
      widths.push_back(participation(density));
    }
  }
  return fit_line(x, y);
}

/**
The exponent needs an error. Double and extended precision follow it separately; their difference and the error of the
fit are added. */
Scaling scaling(Centre centre, int steps) {
  Scaling out;
  std::vector<double> widths, widths_extended;
  const Line one = branch_exponent<double>(centre, steps, widths);
  const Line two = branch_exponent<long double>(centre, steps, widths_extended);
  out.exponent = compare(one.slope, two.slope);
  out.exponent.error += one.slope_error;
  out.width = compare(widths.front(), widths_extended.front());
  const auto change = [](const std::vector<double>& all) {
    const auto [narrow, wide] = std::minmax_element(all.begin(), all.end());
    return *wide / *narrow - 1;
  };
  out.width_change = rounding_at_least<double>(compare(change(widths_extended), change(widths)));
  return out;
}

/**
Of the two exponents the one farther from 2 counts. A quick run goes two octaves each way instead of six. */
void report_scaling(Report& report) {
  Estimate farther{2, 0};
  for (const auto& [centre, name] : centres) {
    const Scaling s = scaling(centre, report.quick ? 16 : 48);
    const std::string suffix = std::string("_") + name;
    report.facts.add("width" + suffix, s.width, "site");
    report.facts.add("width_change" + suffix, s.width_change);
    if (std::abs(s.exponent.value - 2) + s.exponent.error >
        std::abs(farther.value - 2) + farther.error)
      farther = s.exponent;
  }
  report.facts.add("scaling", farther);
}

/**
## Differences and limits

The article prints no number for the agreement that it calls excellent. The difference is easily overlooked at the size
of the article's figure, and the approximation is a good first guess for Newton's method, which is what the article uses
it for. Why the two norms are so nearly equal, and why the one around a bond is the smaller, we do not know. Tails end
where the number format does; beyond, the tables say zero. */
void reproduce(Report& report) {
  report.output.note("tolerance", "relative corrections of the strains below a hundred roundings");
  report_norms(report);
  report_tails(report);
  report_profiles(report);
  report_scaling(report);
}

/**
## Try it

`sec32_dps_profiles profile` prints one profile beside its approximation, for any $\mu$ and any exponent of the contacts
(commands/one_profile.hpp). How it shows in the chain:

1. *Easy.* How good is $y_n = 2\epsilon u_n\cos\omega_bt$ for a small breather of the chain?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `amplitude` = 9.63900e-7. Hint: Eq. (20) gives
   $\epsilon$, and `profile` gives $u_0$; the rest is of relative size $\epsilon^{1/2}$.
2. *Harder.* Does its energy follow from the norm, $\mathcal H \approx 2\epsilon^2N$?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `energy` = 9.82092e-13. Hint: how large is the
   relative error, and how does it change at `--omega 1.002`?
3. *Harder.* Are the two energies as close for contacts of another exponent?
   `build/bin/sec32_barrier barrier --omega 1.01 --contact power --alpha 2` gives `equal_frequency` = 3.79482e-8. Hint:
   divide by the energy that `breather` prints with the same options, and compare with the gap of the norms for spheres.
4. *Open.* The norms are almost equal for the exponent 3/2, more nearly so below it, and at none of the exponents from 1.1 to 4
   that were computed equal (`secB_other_numbers`). Is there an argument why the one around a bond is smaller?
5. *Open.* The strains obey a two-dimensional map. Which breathers with two or more humps follow from its stable and
   unstable manifolds? */
int main(int argc, char** argv) {
  return run({"sec32_dps_profiles", "3.2", "Static breathers of the DpS equation (section 3.2)",
              reproduce, commands<OneProfile>()},
             argc, argv);
}
