/**
# 3.2 Static breathers of the chain

Section 3.2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) computes breathers: motions of the chain that repeat
themselves and stay where they are. Neighbours swing against each other, a few beads carry nearly all the energy, and
the rest of the chain is almost at rest. There are two kinds. Around a *site* one bead swings against both of its
neighbours; around a *bond* two neighbours swing against each other.

![Bond-centred breathers, of the DpS equation and of the chain, and their quasi-continuum approximation.](fig:02)

The article finds both by Newton's method, with a residual of $1.5\cdot10^{-9}$ and a last variation of
$1.7\cdot10^{-11}$, from an approximate profile that is excellent at small amplitude. Their tails fall off
super-exponentially, and a site-centred one looks the same after a hundred periods. With the frequency the amplitude,
the energy and the asymmetry around a site grow, the energies of both kinds are indistinguishable, and both exist in
wells of every anharmonicity $s \in [-1,1]$. Are these statements true, and how good can the breathers be made? How much
energy separates the two kinds is the question of the next chapter. */

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_breather.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/branches.hpp"
#include "sec3/continuum.hpp"
#include "sec32/full_map.hpp"
#include "sec32/tail.hpp"

using namespace lattice;

/**
## Model

The beads sit in the wells of Eq. (10), mostly linear ones ($s = 0$), and push on their neighbours,
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(t+T_b) = y_n(t),\quad T_b = 2\pi/\omega_b,$$
with free ends (Eqs. (6) and (9)), dimensionless. A breather starts from rest, and its unknowns are the positions at
$t = 0$. In the program `omega_b` is $\omega_b$, `Orbit::start` the breather at $t = 0$, and `Orbit::energy` its energy
$\mathcal H$, Eq. (6). Most is shown on one breather. */
constexpr double omega_b = 1.1;

/**
## Method: a quarter of a period

We guess the positions from Eqs. (18) to (20) and integrate over a part of a period, after which the symmetry of the
breather makes as many demands $R(y) = 0$ as there are unknowns. Newton's method corrects the guess,
$y \leftarrow y - DR(y)^{-1}R(y)$, with the exact derivative $DR$ from the linearised equations of motion.

Which demands? What starts at rest is at rest again after half a period. A mirror image of the chain must also change
the sign of all positions, $y_n \to -y_{-n}$: contacts push and never pull, and a mirror image alone would turn every
overlap into a gap. Around a bond the breather is its own image, so the right half of the chain tells all, and its
velocities must vanish after half a period. Around a site the image is the breather half a period later. As the breather
runs backward from there as it runs forward, image and breather meet at a quarter:
$$\dot y_n(T_b/2) = 0 \quad\text{(bond)},\qquad
  y_n+y_{-n} = 0,\quad \dot y_n-\dot y_{-n} = 0 \quad\text{at } t = T_b/4 \quad\text{(site)}.$$
The integrator ends a step at every *contact event*, the opening or closing of a contact, because a step across it would
spoil the orbit at $10^{-9}$ and its derivative much earlier (event_driven.hpp). Every number is computed at two
tolerances or in two precisions, and the difference is its error. */
Orbit<double> article_breather(const NewtonRule<double>& rule) {
  const Shooting<double> problem = problem_of(Centre::site, omega_b);
  return newton(problem, problem.reduce(ansatz(Centre::site, omega_b, problem.chain.sites)), rule);
}

std::string name_of(Centre centre) {
  return centre == Centre::site ? "site" : "bond";
}

/**
## Convergence

The article's residual is the distance after a whole period, relative to the start, without any symmetry. For our
breather, which was found on a quarter of one, it is [4e-14](num:newton.residual) after
[4](num:sec32_newton_breathers.newton_iterations) steps, and the last variation is [7e-14](num:newton.variation).

How did the article get its larger numbers? We also solve its equations, the whole period map in the sense of least
squares (sec32/full_map.hpp). These equations are ill-conditioned: the
condition number is [1.75392e6](num:sec32_newton_breathers.condition_full), against
[22.3356](num:sec32_newton_breathers.condition_site) of the symmetric equations. The least singular vector is nearly a
shift along the chain, the *pinning mode* of section 3.3; its angle with the discrete gradient $y_{n+1}-y_{n-1}$ has the
cosine [0.987389](num:sec32_newton_breathers.softest_along_gradient). After ten steps the residual is
[1e-14](num:sec32_newton_breathers.full_residual), but Newton's method still demands a step of
[8e-9](num:sec32_newton_breathers.full_step). After five, the article's number, the residual is
[3.6091e-10](num:sec32_newton_breathers.full_residual_5) and the step
[5.63924e-5](num:sec32_newton_breathers.full_step_5). An iteration that takes no step along the pinning mode cannot mend
a guess that is shifted a little: it stops at a residual of
[2.00689e-9](num:sec32_newton_breathers.pinned_residual_5), with a last step of
[2e-14](num:sec32_newton_breathers.pinned_step_5). Each of the printed numbers lies between those of the two iterations;
what the article did with this mode, and how accurately it integrated, it does not say. */
void report_convergence(Report& report) {
  // The symmetric equations at two tolerances
  const auto problem = problem_of(Centre::site, omega_b);
  const Orbit<double> orbit = article_breather(rule<double>(0)),
                      coarse = article_breather(rule<double>(1));
  report.facts.add("residual", compare(distance_after_period<double>(problem, orbit.start),
                                       double(distance_after_period<Wide>(problem, orbit.start))));
  report.facts.add("variation", compare(coarse.variation(), orbit.variation()));
  report.facts.add("newton_iterations", exact(double(orbit.iterations())));
  const auto symmetric = [&](const Orbit<double>& o) {
    return condition_of(problem.evaluate(o.x, {}).jacobian).condition;
  };
  report.facts.add("condition_site", compare(symmetric(coarse), symmetric(orbit)));

  // The full map after nine and after ten steps: the difference shows how much of its result is wandering
  const FullMap full = solve_full_map(omega_b, 10), before = solve_full_map(omega_b, 9);
  const auto last = [&](double Iteration::*what) {
    return compare(before.history.back().*what, full.history.back().*what);
  };
  const Vector<double> sideways = gradient(orbit.start.y);
  report.facts.add("condition_full", compare(before.soft.condition, full.soft.condition));
  report.facts.add("softest_along_gradient", compare(alignment(before.soft.softest, sideways),
                                                     alignment(full.soft.softest, sideways)));
  report.facts.add("full_residual", last(&Iteration::residual), "relative to amplitude");
  report.facts.add("full_step", last(&Iteration::step), "relative to amplitude");

  // After five steps, as in the article, in all directions and without the pinning mode
  for (const auto& [name, rank] : {std::pair{"full", 0.0}, {"pinned", 1e-5}}) {
    std::array<History, 2> at;
    for (const int coarser : {0, 1}) {
      NewtonRule<double> how = rule<double>(coarser);
      how.rank = rank;
      at[coarser] = solve_full_map(omega_b, 5, how).history;
    }
    report.facts.add(name + std::string("_residual_5"),
                     compare(at[1][5].residual, at[0][5].residual), "relative to amplitude");
    report.facts.add(name + std::string("_step_5"), compare(at[1][4].step, at[0][4].step),
                     "relative to amplitude");
  }

  // Both start from the same profile, so their histories share one table
  Table& table = report.table(
      "newton_history", {label("equations", "symmetric or full period map"),
                         count("iteration", "number of Newton steps made"),
                         number("residual", "of the equations solved, relative to the amplitude"),
                         number("step", "of the next iteration, relative to the amplitude")});
  for (const auto& [name, history] :
       {std::pair{"symmetric", orbit.history}, {"full", full.history}})
    for (std::size_t k = 0; k < history.size(); ++k)
      table.add({name, k, history[k].residual, history[k].step});
}

/**
## Symmetry

We impose both symmetries, so finding them in the result proves nothing. We therefore look for the breathers without
them: all positions are unknown, the start is shaken at random by a thousandth (a recorded seed), and we demand only
that the chain comes to rest at $T_b/2$. If the breathers have their symmetries by nature, the symmetries come back: the
images under $y_{1-n} = -y_n$ and $y_n(t) = -y_{-n}(t+T_b/2)$ then agree with the orbit far better than the guess did.
What is left is rounding times the condition number of these equations, and shrinks with the precision; a breather
without symmetry would keep the thousandth. */
template <class T>
double broken_symmetry(Centre centre) {
  auto problem = in_precision<T>(problem_of(centre, omega_b));
  State<T> start(problem.chain.sites);
  const auto y = shaken(find_breather(problem_of(centre, omega_b)).start.y, 1e-3, 7);
  std::copy(y.begin(), y.end(), start.y.begin());
  problem.symmetry = even_in_time(problem.chain.sites);
  const Orbit<T> orbit = newton(problem, problem.reduce(start));
  State<T> image = orbit.start;
  if (centre == Centre::site) flow(problem.chain, image, problem.period() / T(2));
  T most(0);
  for (std::size_t n = 0, last = image.y.size() - 1; n <= last; ++n)
    most = std::max(most, magnitude<T>(orbit.start.y[n] + image.y[last - n]));
  return double(most / orbit.amplitude);
}

// What is left in extended precision, and as a share of what is left in double precision
void report_symmetry(Report& report) {
  Estimate broken{}, share{};
  for (Centre centre : both_centres) {
    const double left = broken_symmetry<double>(centre), wide = broken_symmetry<Wide>(centre);
    broken = larger(broken, compare(0.0, wide));
    share = larger(share, compare(0.0, wide / left));
  }
  report.facts.add("broken_symmetry", broken, "relative to amplitude");
  report.facts.add("broken_symmetry_share", share);
}

/**
## Profiles (figures 02 and 03)

How good is the quasi-continuum approximation for the chain itself? The figures have three panels each: the stationary
DpS breather, and the breathers of the chain at $\omega_b = 1.01$ and $1.1$, each with its approximation.

![Site-centred breathers and their quasi-continuum approximation.](fig:03)

Two errors add up. The continuum differs from the DpS breather even in the limit, by
[0.0574512](num:sec32_newton_breathers.continuum_limit_site) around a site and
[0.0614325](num:sec32_newton_breathers.continuum_limit_bond) around a bond. The DpS equation differs from the chain: at
$1.01$ this takes a little off the first error, at $1.1$ it has made the sum far larger. */
Estimate approximation_error(Centre centre, double omega_b) {
  const auto problem = problem_of(centre, omega_b);
  const auto off = [&](int coarser) {
    const auto orbit = find_breather(problem, Phase::compressed, rule<double>(coarser));
    const State<double> near = ansatz(centre, omega_b, problem.chain.sites);
    return largest_difference(orbit.start, near) / orbit.amplitude;
  };
  return compare(off(1), off(0));
}

/**
The article calls the approximation excellent at $1.01$ and worse at $1.1$. At $1.01$ the difference is
[0.0511267](num:sec32_newton_breathers.continuum_101_site) of the amplitude around a site and
[0.0475461](num:sec32_newton_breathers.continuum_101_bond) around a bond, at $1.1$ it is
[0.117550](num:sec32_newton_breathers.continuum_110_site) and
[0.0977687](num:sec32_newton_breathers.continuum_110_bond). */
void report_profiles(Report& report) {
  for (Centre centre : both_centres) {
    // Three breathers, each with its approximation, site by site
    Table& table =
        report.table(name_of(centre) + "_profiles",
                     {count("n", "site", "site"), number("u", "stationary DpS breather, mu = 1"),
                      number("u_continuum", "its quasi-continuum approximation"),
                      number("y_101", "positions at t = 0, omega_b = 1.01"),
                      number("y_101_continuum", "their quasi-continuum approximation"),
                      number("y_110", "positions at t = 0, omega_b = 1.1"),
                      number("y_110_continuum", "their quasi-continuum approximation")});
    const std::size_t sites = sites_of(centre);
    const auto y_101 = find_breather(problem_of(centre, 1.01)).start.y,
               y_110 = find_breather(problem_of(centre, 1.1)).start.y,
               near_101 = ansatz(centre, 1.01, sites).y, near_110 = ansatz(centre, 1.1, sites).y,
               u = stationary<double>(centre, 1, sites).u;
    for (std::size_t i = 0; i < sites; ++i) {
      const long n = site_number(i, sites);
      table.add(
          {n, u[i], quasi_continuum(centre, n), y_101[i], near_101[i], y_110[i], near_110[i]});
    }

    // How far each approximation is off, in the limit and at the two frequencies
    const auto limit = [&]<class T>(T one) {
      return double(continuum_difference(stationary<T>(centre, one, sites)));
    };
    report.facts.add("continuum_101_" + name_of(centre), approximation_error(centre, 1.01),
                     "relative to amplitude");
    report.facts.add("continuum_110_" + name_of(centre), approximation_error(centre, 1.1),
                     "relative to amplitude");
    report.facts.add("continuum_limit_" + name_of(centre), compare(limit(1.0), limit(Wide(1))),
                     "relative to amplitude");
  }
}

/**
## A hundred periods (figure 04)

The site-centred breather is weakly unstable (section 3.3), so rounding errors must grow. A second run with another
tolerance measures their growth: the difference of the two is the error of the first. The article finds the positions
visually equal after a hundred periods; they have moved by [3e-12](num:newton.persistence) of the amplitude.

![The breather at the start and after a hundred periods.](fig:04) */
void report_persistence(Report& report) {
  const auto problem = problem_of(Centre::site, omega_b);
  const State<double> start = find_breather(problem).start;
  std::array<State<double>, 2> end{start, start};
  parallel_for(2, [&](std::size_t k) {
    for (int period = 0; period < (report.quick ? 10 : 100); ++period)
      flow(problem.chain, end[k], problem.period(), rule<double>(int(k)).events);
  });
  const double moved = largest_difference(end[0], start) / largest(start);
  const double error = largest_difference(end[0], end[1]) / largest(start);
  report.facts.add("persistence", {moved, error}, "relative to amplitude");

  Table& table = report.table("persistence",
                              {count("n", "site", "site"), number("y_start", "positions at t = 0"),
                               estimate("y_end", "positions after 100 periods")});
  for (std::size_t i = 0; i < start.y.size(); ++i) {
    const Estimate late{end[0].y[i], std::abs(end[0].y[i] - end[1].y[i])};
    table.add({site_number(i, start.y.size()), start.y[i], late});
  }
}

/**
## The tail (figure 05)

How fast do the breathers decay? A bead far out is pushed by its inner neighbour alone, with the power $3/2$ of the
neighbour's displacement, so that $\ln|y_{n+1}|/\ln|y_n| \to 3/2$: the decay is double-exponential. Newton's method
follows it to the end of the number format (sec32/tail.hpp), in double precision to site
[14](num:sec32_newton_breathers.tail_last_double), in extended precision to site
[21](num:sec32_newton_breathers.tail_last_wide).

![The tail of the site-centred breather.](fig:05)

At the last place where it can be formed the exponent is [1.4999](num:sec32_newton_breathers.tail_exponent), with its
change since the place before as its error; an exponential tail would have the exponent one. The figure tests the law by
eye: moduli on one side and, on the other, the straight line that it demands of $\ln(-\ln|y_n|)$. */
void report_tail(Report& report) {
  // Where both precisions end, and the exponent there
  const Tail tail(omega_b);
  long last = 0, last_wide = 0;
  while (tail.wide_size(last_wide + 1) > 0) ++last_wide;
  while (tail.size(last + 1) > 1e-300) ++last;
  report.facts.add("tail_exponent",
                   compare(tail.exponent(last_wide - 2), tail.exponent(last_wide - 1)));
  report.facts.add("tail_last_double", exact(double(last)), "site");
  report.facts.add("tail_last_wide", exact(double(last_wide)), "site");

  report_tail_table(report, tail, last_wide);
}

/**
## The branches (figure 06)

Both families are followed by arclength from $\omega_b = 1.001$ to $2$ (continuation.hpp). At one frequency their
amplitudes differ by up to the fraction [0.130228](num:newton.amplitude_differs); their energies, which the article
finds indistinguishable, by [1.18591e-6](num:newton.energy_equal), at
[1.001](num:sec32_newton_breathers.largest_energy_difference_at). Towards $\omega_b = 1$ this must tend to the relative
difference of the DpS norms, bond minus site, of [-1.33110e-6](num:sec32_dps_profiles.norm_gap_relative).

![Amplitude and energy of both families.](fig:06)

The site-centred breather is its own mirror image only in the limit of small amplitude. Its asymmetry is the largest
$|y_n(0)-y_{-n}(0)|$ relative to the largest $|y_n(0)|$. */
double asymmetry(const Orbit<double>& orbit) {
  double most = 0;
  for (std::size_t n = 0, last = orbit.start.y.size() - 1; n < last - n; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] - orbit.start.y[last - n]));
  return most / orbit.amplitude;
}

/**
The article says of three quantities that they increase with $\omega_b$: the amplitude and the energy of both families,
and this asymmetry. All do, from each frequency of the figure to the next. The asymmetry is
[0.000515165](num:sec32_newton_breathers.asymmetry_1001) at $1.001$ and
[0.463687](num:sec32_newton_breathers.asymmetry_200) at 2. */
void report_branches(Report& report) {
  // Both families, frequency by frequency
  std::vector<double> omegas = pair_frequencies(0, report.quick ? 6 : 80);
  omegas.insert(omegas.begin(), 1.001);
  const BreatherPairs pairs = breather_pairs_at(0, omegas, measure_in<double>);
  Table& table = report.table(
      "branches", {number("omega", "frequency"), number("amplitude_bond", "largest |y_n(0)|"),
                   number("amplitude_site", "largest |y_n(0)|"),
                   estimate("energy_bond", "energy, bond-centred"),
                   estimate("energy_site", "energy, site-centred")});
  Estimate apart{}, where{}, amplitudes{};
  for (const BreatherPair& r : pairs) {
    const auto& [site, bond] = r.energy;
    table.add({r.omega, r.amplitude[1].value, r.amplitude[0].value, bond, site});
    const Estimate ratio = quotient(r.amplitude[0], r.amplitude[1]);
    amplitudes = larger(amplitudes, {std::abs(ratio.value - 1), ratio.error});
    const Estimate gap = quotient(r.equal_frequency, bond);
    if (std::abs(gap.value) > apart.value)
      apart = {std::abs(gap.value), gap.error}, where = exact(r.omega);
  }
  report.facts.add("largest_amplitude_difference", amplitudes, "relative");
  report.facts.add("largest_energy_difference", apart, "relative");
  report.facts.add("largest_energy_difference_at", where);

  // Amplitude and energy grow with the frequency
  Estimate growth{HUGE_VAL};
  for (std::size_t k : {0U, 1U}) {
    std::vector<Estimate> amplitude, energy;
    for (const BreatherPair& r : pairs) {
      amplitude.push_back(r.amplitude[k]);
      energy.push_back(r.energy[k]);
    }
    growth = smaller(growth, smaller(least_ratio(amplitude), least_ratio(energy)));
  }
  report.facts.add("least_growth", growth);

  // So does the asymmetry around a site, from orbits at two tolerances
  std::vector<Estimate> asymmetries(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t i) {
    const Orbit<double>& orbit = pairs[i].orbit[0];
    const Vector<double> beside = orbit.x * 1.000001;
    const auto problem = problem_of(Centre::site, pairs[i].omega);
    asymmetries[i] = compare(asymmetry(newton(problem, beside, rule<double>(1))), asymmetry(orbit));
  });
  report.facts.add("asymmetry_least_growth", least_ratio(asymmetries));
  report.facts.add("asymmetry_1001", asymmetries.front());
  report.facts.add("asymmetry_200", asymmetries.back());
}

/**
## The width

A breather of the DpS equation keeps its width when its amplitude goes to zero, whereas one of the discrete nonlinear
Schrödinger equation broadens like $(\omega_b-1)^{-1/2}$. The article's section 1 says that those of the chain nearly
keep it, too. As width we take the number of sites on which the displacements live, $(\sum y_n^2)^2/\sum y_n^4$ at
$t = 0$. Around a site it is [2.96314](num:sec32_newton_breathers.width_limit_site) in the limit,
[2.96507](num:sec32_newton_breathers.width_1001_site) at $\omega_b = 1.001$ and
[3.05955](num:sec32_newton_breathers.width_105_site) at 1.05; around a bond
[2.97033](num:sec32_newton_breathers.width_limit_bond), [2.97330](num:sec32_newton_breathers.width_1001_bond) and
[3.12164](num:sec32_newton_breathers.width_105_bond). In this range the amplitude grows about 2500-fold and the width by
a fraction of [0.0498881](num:chain.width_constant) at most; a width like $(\omega_b-1)^{-1/2}$ would change by a factor
of seven. */
template <class Profile>
double sites_filled(const Profile& y) {
  std::vector<double> squares;
  for (const double y_n : y) squares.push_back(y_n * y_n);
  return participation(squares);
}

void report_width(Report& report) {
  const std::vector<double> omegas{1.001, 1.002, 1.005, 1.01, 1.02, 1.03, 1.04, 1.05};
  Estimate change{};
  for (Centre centre : both_centres) {
    std::vector<Estimate> width(omegas.size());
    parallel_for(omegas.size(), [&](std::size_t k) {
      const auto at = [&](int coarser) {
        const auto problem = problem_of(centre, omegas[k]);
        return sites_filled(
            find_breather(problem, Phase::compressed, rule<double>(coarser)).start.y);
      };
      width[k] = compare(at(1), at(0));
    });
    Estimate least = width[0], most = width[0];
    for (const Estimate& w : width) least = smaller(least, w), most = larger(most, w);
    const Estimate ratio = quotient(most, least);
    change = larger(change, {ratio.value - 1, ratio.error});

    const std::string around = name_of(centre);
    const auto& limit = stationary<double>(centre, 1, sites_of(centre)).u;
    const auto& wide = stationary<Wide>(centre, 1, sites_of(centre)).u;
    report.facts.add(
        "width_limit_" + around,
        compare(sites_filled(limit), sites_filled(std::vector<double>(wide.begin(), wide.end()))),
        "site");
    report.facts.add("width_1001_" + around, width.front(), "site");
    report.facts.add("width_105_" + around, width.back(), "site");
  }
  report.facts.add("width_change", change, "relative");
}

/**
## Other wells

For $s \in [-1, 1]$ the article finds both families, without showing them. We follow them from rest in four more wells,
$s = \pm1$ and $\pm\frac12$, as far as they go: through $\omega_b = 2$, or to a fold. In all of them both families
begin at rest, with an amplitude like $(\omega_b-1)^2$. In the soft ones they end before $\omega_b = 2$: at $s = -1$
they fold at [1.61967](num:sec32_newton_breathers.end_s_minus_1_site) around a site and
[1.61972](num:sec32_newton_breathers.end_s_minus_1_bond) around a bond, at $s = -1/2$ at
[1.72385](num:sec32_newton_breathers.end_s_minus_05_site) and
[1.72391](num:sec32_newton_breathers.end_s_minus_05_bond). */
void report_other_wells(Report& report) {
  std::vector<std::pair<double, std::string>> wells{{1, "1"}};
  if (!report.quick)
    wells.insert(wells.begin(), {{-1, "minus_1"}, {-0.5, "minus_05"}, {0.5, "05"}});
  std::vector<FamilyExtent> families(2 * wells.size());
  parallel_for("other wells", families.size(), [&](std::size_t i) {
    families[i] = family_from_rest(both_centres[i % 2], wells[i / 2].first);
  });

  Estimate off{};
  for (std::size_t i = 0; i < families.size(); ++i) {
    const auto& [exponent, end] = families[i];
    if (!end.is_exact)
      report.facts.add("end_s_" + wells[i / 2].second + "_" + name_of(both_centres[i % 2]), end);
    off = larger(off, {std::abs(exponent.value - 2), exponent.error});
  }
  report.facts.add("growth_exponent_off", off);
}

/**
## Differences and limits

The article counts five iterations of its Gauss-Newton method. Ours continues until rounding stops it. The article's
chain lengths are 31 and 99 around a site; around a bond we take one bead more. We follow no family through its fold.
`sec32_newton_breathers breather` computes a breather with your own parameters (commands/one_breather.hpp). */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  report_convergence(report);
  report_symmetry(report);
  report_profiles(report);
  report_persistence(report);
  report_tail(report);
  report_branches(report);
  report_width(report);
  report_other_wells(report);
}

/**
## Try it

1. *Easy.* How does the amplitude grow with $\omega_b - 1$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 1.002` gives `amplitude` = 3.53917e-6. Hint: at
   1.001 it is a quarter of that; Eq. (20) says why.
2. *Easy.* Which centre costs more energy at $\omega_b = 1.5$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 1.5` gives `energy` = 0.461486. Hint: ask for
   `--centre site` too, and look at the digits that are the same; the next chapter is about the others.
3. *Harder.* What does a lighter bead at the centre change?
   `build/bin/sec32_newton_breathers breather --omega 1.3 --defect-mass 0.8` gives `energy` = 0.00545725. Hint: with
   equal beads it is five times as large; a lighter bead swings faster by itself, so that less of the frequency has to
   come from the contacts.
4. *Harder.* What is the law of exercise 1 for contacts of another exponent?
   `build/bin/sec32_newton_breathers breather --contact power --alpha 2 --omega 1.1` gives `amplitude` = 0.0998154.
   Hint: the shift of the frequency goes like the contact force over the displacement, amplitude$^{\alpha-1}$; try
   `--omega 1.05`.
5. *Open.* Are there breathers around two neighbouring sites that swing in phase? */
int main(int argc, char** argv) {
  return run({"sec32_newton_breathers", "3.2", "Static breathers of the chain (section 3.2)",
              reproduce, commands<OneBreather>()},
             argc, argv);
}
