/**
# 3.3 Stability of the DpS breathers

Are the two static breathers of the discrete p-Schrödinger (DpS) equation (section 3.2) stable? We compute their
spectra, with errors small enough to fix the sign of a tiny margin, and integrate the equation from perturbed breathers.
Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) says that

- the bond-centred breather is spectrally stable at the frequencies $\mu = 1$ and 10 (figure 8);
- the site-centred one has a real pair of exponents, and its growth rate is linear in $\mu$ (figure 9);
- a random perturbation of amplitude 0.01 sets the site-centred one in motion (figure 10);
- the bond-centred one "should be structurally robust (a result confirmed by our direct numerical simulations)".

![The site-centred breather has a real pair of exponents. Drawn by fig09_site_spectrum.py: `u` against `n` from
`profile_site_mu1` and `_mu10`, `imag` against `real` from the tables `spectrum_site_mu1` and `_mu10`, and `rate` of
`growth` against `mu`.](fig:09)

The first three hold; the *signs* of the two margins hang on the sixth digit. The fourth is not quantified, and its
simulations are not shown. We find that one number decides whether a breather leaves: the push that the perturbation
gives to its centre. The stable breather leaves, too, if this push exceeds a threshold that a pendulum predicts to 2 per
cent. It stays localized all the same.

<!-- head -->
`build/bin/sec33_dps_stability` computes this chapter in 4 s on two cores and writes 20 tables to
`build/data/sec33_dps_stability`. Its figures: `make fig08`, `make fig09`, `make fig10`, `make x46`, `make x56`. With
your parameters: `spectrum`, linear stability of one static DpS breather: all its exponents, per unit of tau/(2 tau_0).
<!-- /head -->

## Model

The DpS equation, Eq. (11), has the force $w_n = d_n|d_n|^{1/2}$ of the strain $d_n = v_{n+1}-v_n$:
$$i\dot v_n = w_n - w_{n-1}.$$
Everything is dimensionless, the ends are free, and there are 31 sites around a site, 32 around a bond. The breathers
are $v_n = u_ne^{i\mu t}$ with real $u_n$, Eq. (14), found by Newton's method (`sec32_dps_profiles`). A perturbation is
added in the frame that rotates with them, $v_n = e^{i\mu t}(u_n+x_n+iy_n)$, as in Eq. (22).

A contact is stiffer along its strain than across it: a change $\xi+i\eta$ of $d_n$ changes the force by
$|d_n|^{1/2}(\frac32\xi+i\eta)$. So one symmetric matrix $M$, the second difference with the weights $|d_n|^{1/2}$, acts
on both parts, $\dot x = (\mu-M)y$ and $\dot y = -(\mu-\frac32M)x$. Each eigenvector of $M$ evolves independently, like
$e^{\sigma t}$ (the article's $\lambda$) with $\sigma^2 = -(\mu-m)(\mu-\frac32m)$, where $m$ is its eigenvalue. The
function `contact_spectrum` (spectrum.hpp) fills $M$ and calls Eigen, `exponents` returns both signs of $\sigma$. */
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_spectrum.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/quadruple/extended.hpp"
#include "report/program.hpp"
#include "sec33/dps_noise.hpp"

using namespace lattice;

/**
## The experiment

We find a breather, add a perturbation and follow it in the frame that rotates with $\mu$, where the equation reads
$i\dot v_n = \mu v_n + w_n - w_{n-1}$. There the breather is at rest, and the integrator, the adaptive method of Prince
and Dormand of order eight (GSL), follows the perturbation alone. We record the displacement $X$, in sites, of the
centre of $|v_n|^4$ (the fourth power suppresses small noise far away), the participation number
$(\sum|v_n|^2)^2/\sum|v_n|^4$, and the drift of norm and energy, a few per cent of what the smallest push that moves a
breather adds to them. */
constexpr double alpha = 1.5;           // exponent of the contact force: spheres
constexpr double mu_in_motion = 10;     // frequency of breathers that are followed (figure 10)
constexpr double amplitude = 0.01;      // of the noise (figure 10)
constexpr double run_time = 500;        // of a breather under noise
constexpr double largest_drift = 3e-8;  // of norm or energy
constexpr Accuracy loose{1e-8, 1}, tight{1e-10, 2};  // tolerance, samples per unit of time

PinnedBreather breather_at_rest(Centre centre) {
  return PinnedBreather(stationary<double>(centre, mu_in_motion, sites_of(centre, alpha), alpha));
}

DpsRun follow(const PinnedBreather& breather, Field v, double time, const Accuracy& accuracy,
              const DpsLook& look = {}) {
  const Dps chain{.sites = v.size(), .near_end = Ends::free, .exponent = alpha, .rate = 1};
  const auto samples = std::size_t(std::ceil(accuracy.samples * time));
  const double rest = breather.centre == Centre::bond ? 0.5 : 0, start = energy(v, false, alpha);
  DpsRun run;
  const auto observe = [&](double t, const Field& now) {
    double squares = 0, fourth = 0, moment = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double density = std::norm(now[i]), weight = density * density;
      squares += density;
      fourth += weight;
      moment += weight * double(site_number(i, now.size()));
    }
    run.t.push_back(t);
    run.X.push_back(moment / fourth - rest);
    run.participation.push_back(squares * squares / fourth);
    run.drift = std::max(run.drift, std::abs(energy(now, false, alpha) / start - 1));
    look(t, now);
  };
  const TurningDps equation{chain, breather.mu};
  const double norm_drift = evolve_dps(equation, v, time, samples, accuracy.tolerance, observe);
  run.drift = std::max(run.drift, norm_drift);
  if (run.drift > largest_drift) throw Failure("norm or energy drifts by " + short_text(run.drift));
  return run;
}

/**
## Both spectra (figures 8 and 9)

Do the two spectra differ? They agree but for one pair: a point at zero, and the others in two segments of the imaginary
axis. The pair is nearly three hundred times closer to zero than the next one and visible in the insets; it is real
around a site and imaginary around a bond. The error of each exponent is its change from double to extended precision (a
mantissa of 64 bits).

![The bond-centred breather and its spectrum: all exponents are imaginary. Drawn by fig08_bond_spectrum.py in the same
way.](fig:08) */
constexpr std::pair<Centre, const char*> centres[] = {{Centre::site, "site"},
                                                      {Centre::bond, "bond"}};

void report_spectra(Report& report) {
  for (const auto& [centre, name] : centres)
    for (const auto& [mu, suffix] : {std::pair(1.0, "_mu1"), {10.0, "_mu10"}}) {
      const std::string which = std::string("_") + name + suffix;
      const auto breather = stationary<double>(centre, mu, sites_of(centre, alpha), alpha);
      Table& profile = report.table("profile" + which);
      for (std::size_t i = 0; i < breather.u.size(); ++i)
        profile.add({{"n", "site", site_number(i, breather.u.size()), "site"},
                     {"u", "stationary DpS breather", breather.u[i]}});
      // What the command `spectrum` prints
      OneSpectrum chosen;
      chosen.centre = centre;
      chosen.mu = mu;
      chosen.alpha = alpha;
      report.table("spectrum" + which) = chosen.table();
    }
}

/**
## Distance from the edge of stability

Which eigenvalue can make a perturbation grow? $\sigma^2$ is positive if and only if $\frac23\mu < m < \mu$. The
breather is itself an eigenvector, since $Mu = \mu u$ is Eq. (14). It gives $\sigma = 0$, a change of phase. Neighbours
have opposite signs in $u$, and of all eigenvectors of such a chain the one whose sign changes at every contact has the
largest eigenvalue (Perron–Frobenius, spectrum.hpp). So with $m_2$ the second largest, a breather is spectrally stable
if and only if $m_2 \le \frac23\mu$. The sign of the *margin* $m_2/\mu-\frac23$ decides.

Both margins are $5\cdot10^{-6}$ in size, and opposite in sign. No other eigenvalue is near the edge. How well are they
known? We find $m_2$ by bisection on the number of eigenvalues above a bound, counted by the signs of pivots
(spectrum.hpp), on chains of increasing length and in two precisions. */
template <class T>
T margin(Centre centre, std::size_t sites) {
  const auto breather = stationary<T>(centre, T(1), sites, alpha);
  return instability_margin(breather.mu, counted_eigenvalue(breather, 2), alpha);
}

void report_convergence(Report& report) {
  Table& table = report.table("convergence");
  for (const auto& [centre, name] : centres) {
    const Quadruple reference = margin<Quadruple>(centre, sites_of(centre, alpha));
    const auto error = [&](const Quadruple& found) {
      return double(Quadruple(abs(Quadruple(found - reference))));
    };
    // From the compact approximation's length on
    const std::size_t shortest = 2 * short_chain(alpha) + (centre == Centre::site ? 1 : 0);
    for (std::size_t sites = shortest; sites <= shortest + 8; sites += 2)
      table.add({{"centre", "site or bond", name},
                 {"sites", "length of the chain", sites},
                 {"in_double", "error of the margin in double precision",
                  error(Quadruple(margin<double>(centre, sites)))},
                 {"in_quadruple", "the same in quadruple precision",
                  error(margin<Quadruple>(centre, sites))}});
  }
}

/**
![Error of both margins against the length of the chain, in double and in quadruple precision; grey: the margin
itself. Drawn by x46_margin_error.gp from the table `convergence`.](fig:x46)

The error falls faster than exponentially, as the tail of the breather does, until machine precision limits it. On 8
sites it is larger than the margin; on the article's 31 and 32 sites, even in double precision, it is ten orders of
magnitude smaller. So the signs are certain for this equation, though a relative error of $10^{-4}$ in one strain would
reverse either (tests/lattice/standing/spectrum.cpp).

| at $\mu = 1$ | around a site | around a bond |
|---|---|---|
| margin $m_2/\mu-\frac23$ | [4.8530e-6](cell:margins/centre=site/mu=1/margin) | [-4.8533e-6](cell:centre=bond/margin) |
| type of the pair (article: the same) | real | imaginary |
| $\lvert\sigma\rvert/\mu$ | [0.00155771](cell:margins/centre=site/mu=1/exponent) | [0.00155778](cell:centre=bond/exponent) |

Why are the margins equal and opposite? Suppose the centre moves in a periodic potential, as in other lattices (the
Peierls–Nabarro barrier; Kivshar and Campbell 1993). Both breathers are its extrema, and if it is a sine, its curvatures
there are equal and opposite, and $\sigma^2$ is proportional to them. The motion below tests this; why the potential is
so flat, and so nearly a sine, we do not know. */
constexpr const char* two_precisions = "from two precisions and two chain lengths";

void report_margins(Report& report) {
  Table& table = report.table("margins");
  for (const auto& [centre, name] : centres)
    for (const double mu : {1.0, 10.0}) {
      const Margin found = margin_of<Quadruple>(centre, mu, sites_of(centre, alpha), alpha);
      table.add({{"centre", "site or bond", name},
                 {"mu", "frequency", mu},
                 {"margin", "m_2/mu - 2/3, positive if unstable", found.margin, "", two_precisions},
                 {"exponent", "|sigma|/mu of this pair", found.exponent, "", two_precisions}});
    }
}

/**
The growth rate is linear in $\mu$ by scaling (figure 9, bottom): if $v_n(t)$ solves Eq. (11), so does
$\mu^2v_n(\mu t)$, and $\sigma/\mu$ is a pure number. Newton's method works with relative corrections and scales in the
same way, so the values from $\mu = 10^{-3}$ to $10^3$ agree to machine precision: a check of the arithmetic, not of the
law. */
void report_growth(Report& report) {
  std::vector<double> mus{1e-3, 1e-2, 0.1};
  for (int k = 1; k <= 20; ++k) mus.push_back(0.5 * k);
  mus.insert(mus.end(), {100, 1000});
  Table& table = report.table("growth");
  for (const double mu : mus) {
    const auto found =
        margin_of<long double>(Centre::site, mu, sites_of(Centre::site, alpha), alpha);
    const Estimate rate{mu * found.exponent.value, mu * found.exponent.error};
    table.add({{"mu", "frequency", mu},
               {"rate", "growth rate", rate, rate_unit, two_precisions},
               {"margin", "m_2/mu - 2/3, positive if unstable", found.margin, "", two_precisions}});
  }
}

/**
## The rate from the motion

Does a perturbation of the nonlinear equation grow at this rate? The second eigenvector $V$ of $M$ is the *translational
mode* (the article's pinning mode; Chen, Aubry and Tsironis 1996): the perturbation $(a+ib)V$ shifts the breather along
the chain by its real part, the *shift* $a$, and pushes it by the *push* $b$, since $\dot a = (\mu-m_2)b$. Near a site
the growing direction is $b = \sigma a/(\mu-m_2)$, and the growing part of any perturbation is
$\frac12(a+(\mu-m_2)b/\sigma)$. We displace the breather along this direction by a millionth of its size, and fit a line
to the logarithm of the growing part over the time $4/\sigma$. The error is the difference of two tolerances, plus the
change that a displacement ten times larger makes, which measures the effect of the nonlinear terms. */
double measured_rate(const PinnedBreather& site, double size, const Accuracy& accuracy) {
  Field v = site.u;
  site.pair.add({size, size / site.pair.push}, v);  // pair.push is (mu - m_2) / sigma
  std::vector<double> t, growth;
  follow(site, v, 4 / site.pair.rate, accuracy, [&](double now, Field w) {
    for (std::size_t i = 0; i < w.size(); ++i) w[i] -= site.u[i];
    t.push_back(now);
    growth.push_back(std::log(site.pair.growing(w)));
  });
  return fit_line(t, growth).slope;
}

/**
At $\mu = 10$ the motion has $\sigma =$ [0.01558](cell:growth_in_time/rate), ten times the value of the table. */
void report_rate(Report& report, const PinnedBreather& site) {
  const double size = 1e-6 * std::abs(site.u[site_index(0, site.u.size())]);
  const Accuracy looser{1e-11, 1}, tighter{1e-13, 2};
  Estimate rate = compare(measured_rate(site, size, looser), measured_rate(site, size, tighter));
  rate.error += std::abs(rate.value - measured_rate(site, 10 * size, tighter));
  report
      .table("growth_in_time", {estimate("rate", "growth rate of a small perturbation, mu = 10",
                                         rate_unit, "from two tolerances and two sizes")})
      .add({rate});
}

/**
## The push that moves a stable breather

How hard must the stable breather be pushed? In the potential of a sine the centre moves like a pendulum, $\ddot X =
\pm\frac{|\sigma|^2}{2\pi}\sin2\pi X$, around a bond with the lower sign. The push that carries it over the site is $b_c
= |\sigma|/(\pi g(\mu-m_2))$, where $g$ is the displacement $X$ for a unit of $a$ (dps_motion.hpp). To test the pendulum
we bisect, without noise, the push that depins the breather of the full equation, between 0.8 and 1.2 of the predicted
one. Runs of $12/|\sigma|$ are long enough to resolve a push $e^{-8}$ from the threshold. */
double bisected_push(const PinnedBreather& bond, int halvings, const Accuracy& accuracy) {
  const auto depins = [&](double push) {
    Field v = bond.u;
    bond.pair.add({0, push}, v);
    return follow(bond, v, 12 / bond.pair.rate, accuracy).farthest() > 1;
  };
  double low = 0.8 * bond.pendulum_push(), high = 1.2 * bond.pendulum_push();
  if (depins(low) || !depins(high))
    throw Failure("the push that depins the breather is not within 20 per cent of " +
                  short_text(bond.pendulum_push()));
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (depins(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

Estimate depinning_push(const PinnedBreather& bond, int halvings) {
  Estimate push =
      compare(bisected_push(bond, halvings, loose), bisected_push(bond, halvings, tight));
  push.error += 0.2 * bond.pendulum_push() / std::exp2(halvings);  // the last bracket
  return push;
}

/**
The threshold is [0.00654](cell:depinning/push), which is [1.02](cell:depinning/over_pendulum) times that of the
pendulum. A push of this size is less than the amplitude of the article's noise. A shift acts far less: to move the
centre as far as a push does, it has to be $(\mu-m_2)/|\sigma|$, more than two hundred times, as large.

## Noise sets the breather in motion (figure 10)

The article perturbs the site-centred breather of $\mu = 10$ once, "uniformly distributed" and "of amplitude 0.01",
which admits several definitions. As $v_n$ is complex, our *main* noise is $0.01(\xi_n+i\eta_n)$ at every site, with
$\xi_n$ and $\eta_n$ uniform in $(-1,1)$. *Narrow* noise is half as large, so that 0.01 is the width of the interval.
Each gets sixteen seeds, and the bond-centred breather, which leaves only sometimes, 64 in the main one. A *control*
gets the main noise without its component along $V$. To first order it cannot move, and it is followed twice as long. */
std::vector<NoiseGroup> groups_under_noise(const PinnedBreather& site, const PinnedBreather& bond) {
  const Noise main{amplitude}, narrow{amplitude / 2};
  const double t = run_time;
  return {{"complex", "site", site, main, 16, t, t},
          {"complex", "control", site, main, 16, 2 * t, t, true},
          {"complex", "bond", bond, main, 64, t, t},
          {"narrow", "site", site, narrow, 16, t, t},
          {"narrow", "bond", bond, narrow, 16, t, t}};
}

void run_trials(std::vector<NoiseGroup>& groups, bool quick) {
  std::vector<std::pair<const NoiseGroup*, NoiseTrial*>> all;
  for (NoiseGroup& group : groups) {
    const std::size_t seeds = quick ? std::max<std::size_t>(1, group.seeds / 4) : group.seeds;
    for (std::size_t seed = 1; seed <= seeds; ++seed) group.trials.push_back({seed});
    for (NoiseTrial& trial : group.trials) all.emplace_back(&group, &trial);
  }
  parallel_for("perturbed breathers", all.size(), [&](std::size_t i) {
    const auto& [group, trial] = all[i];
    const Field v = group->perturbed(*trial);
    trial->coarse = follow(group->breather, v, group->time, loose);
    trial->fine = follow(group->breather, v, group->time, tight);
  });
}

/**
The article shows one run as a map of $|v_n(t)|^2$. We show one of the sixteen seeds, whose breather moves early, with
its control and with a bond-centred breather under the same noise.

![The perturbed site-centred breather leaves; under the same noise without the translational mode it stays for a long
time. Drawn by fig10_instability.py: `density` over `n` and `t` from `map_site`, `map_control` and `map_bond`.](fig:10)
*/
constexpr std::size_t map_seed = 10;

void report_map(Report& report, const NoiseGroup& group) {
  Table& map = report.table(std::string("map_") + group.start);
  NoiseTrial trial{map_seed};
  const Accuracy every_other{tight.tolerance, 0.5};
  follow(group.breather, group.perturbed(trial), run_time, every_other,
         [&](double t, const Field& now) {
           for (std::size_t i = 0; i < now.size(); ++i)
             map.add({{"t", "time", t, "unit of time"},
                      {"n", "site", site_number(i, now.size()), "site"},
                      {"density", "|v_n|^2", std::norm(now[i])}});
         });
}

/**
A breather has *left* when its centre is half a site away, $|X| > \frac12$. It has *passed on* at $|X| > 1$: from a site
this is the next site, from a bond the next bond. All site-centred breathers leave under the main and under the narrow
noise. The control passes the next site later for every seed, in the median after
[863 ± 5](cell:departures/noise=complex/start=control/passage) instead of [227](cell:start=site/passage) units of time.
So the component along the translational mode moves the breather, as the article says. But the main noise moves also
[15](cell:departures/noise=complex/start=bond/left) of [64](cell:departures/noise=complex/start=bond/seeds) *stable*
breathers.

Does the push decide which? We compare it with the threshold, seed by seed. Nothing is fitted.

![The largest displacement of bond-centred breathers under noise, by t = 500, against the push of the noise over the
threshold. Line: a pendulum. Drawn by x56_push_and_outcome.gp from the table `pushes`.](fig:x56)

It does for [64](cell:depinning/predicted) of the [64](cell:depinning/breathers), and those that stay swing as far as
the pendulum does, $\sin\pi X = b/b_c$. Of a thousand other draws of the main noise a fraction of
[0.27](cell:depinning/share) has a larger push, of the narrow noise [0.015](cell:depinning/share_narrow), so sixteen
seeds of it need not show one that leaves. */
void report_pushes(Report& report, const std::vector<NoiseGroup>& groups, const Estimate& least) {
  Table& table = report.table("pushes");
  for (const NoiseGroup& group : groups) {
    if (group.breather.centre != Centre::bond) continue;
    for (const NoiseTrial& trial : group.trials)
      table.add({{"noise", "complex (main) or narrow", group.noise},
                 {"seed", "of the noise", trial.seed},
                 {"over_threshold", "push of the noise over the least that moves the breather",
                  std::abs(trial.kick.imag()) / least.value},
                 {"farthest", "largest |X| by t = 500", trial.fine.farthest(), "site"}});
  }
}

void report_threshold(Report& report, const NoiseGroup& main, const Estimate& least) {
  const PinnedBreather& bond = main.breather;
  const double low = least.value - least.error, high = least.value + least.error;
  int predicted = 0;  // beyond doubt: push and threshold with its error, at both tolerances
  for (const NoiseTrial& trial : main.trials) {
    const double push = std::abs(trial.kick.imag());
    const bool both = trial.fine.passes(1) && trial.coarse.passes(1);
    const bool none = !trial.fine.passes(1) && !trial.coarse.passes(1);
    if ((push > high && both) || (push < low && none)) ++predicted;
  }
  // How often the push of other draws is larger
  const auto fraction = [&](const Noise& noise) {
    return compare(fraction_beyond(low, noise, bond), fraction_beyond(high, noise, bond));
  };
  const char* how = "from two tolerances and the last bracket";
  report.table("depinning")
      .add({{"push", "least push that sets the bond-centred breather in motion", least, "", how},
            {"over_pendulum", "the same over that of the pendulum",
             Estimate{least.value / bond.pendulum_push(), least.error / bond.pendulum_push()}, "",
             how},
            {"predicted", "bond-centred breathers under the main noise whose outcome it predicts",
             predicted},
            {"breathers", "how many there are", main.trials.size()},
            {"share", "of a thousand other draws of the main noise whose push is larger",
             fraction(main.of), "", how},
            {"share_narrow", "the same of the narrow noise", fraction(Noise{amplitude / 2}), "",
             how}});
}

/**
## Other noise

Other definitions of the article's noise change the numbers but not the mechanism (dps_noise.hpp, tables `departures`
and `noise_runs`). *Real* noise has no push and is slow: all leave their site, but by $t = 750$ only [6](cell:departures/noise=real/start=site/moved) have passed on, and none leaves its
bond. *Relative* noise, $0.01\,u_n(\xi_n+i\eta_n)$, reaches 0.05, since $|u_n|$ goes up to 5, and is far stronger; it
moves [13](cell:departures/noise=relative/start=bond/left) of 16 from
their bond. Under all noise the bond-centred breather stays localized: its participation number grows by a factor of
[1.011](cell:departures/noise=relative/start=bond/spread) at most. A breather that a push carries to the next bond is
still stable, so this does not contradict the linear result. (Counts are exact where both tolerances agree, and do not
include the sampling error of so few seeds.) */
void reproduce(Report& report) {
  report.output.note("seed", "GSL mt19937, 1 to 16 or 1 to 64; map: " + std::to_string(map_seed));
  report_spectra(report);
  report_convergence(report);
  report_margins(report);
  report_growth(report);

  // The rate and the threshold, without noise
  const PinnedBreather site = breather_at_rest(Centre::site), bond = breather_at_rest(Centre::bond);
  report_rate(report, site);
  const Estimate least = depinning_push(bond, report.quick ? 3 : 9);

  // Under noise: the main one around a site, its control, and around a bond come first
  std::vector<NoiseGroup> groups = groups_under_noise(site, bond);
  run_trials(groups, report.quick);
  for (std::size_t k : {0U, 1U, 2U}) report_map(report, groups[k]);
  report_pushes(report, groups, least);
  report_threshold(report, groups[2], least);
  add_controls(report.table("controls"), groups[0], groups[1]);
  std::vector<NoiseGroup> others = real_and_relative_noise(site, bond, amplitude);
  run_trials(others, report.quick);
  for (const NoiseGroup& group : others) groups.push_back(group);
  add_runs(report.table("noise_runs"), groups);
  add_departures(report.table("departures"), groups);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.bond_stable`: bond-centred DpS breather is spectrally stable for mu = 1 and 10 | stable | margins.margin (centre = bond, mu = 1): -4.853e-06 < 0; margins.margin (centre = bond, mu = 10): -4.853e-06 < 0 | holds |
| `dps.site_growth`: growth rate of the site-centred DpS breather is linear in mu | linear | growth.rate (mu = 0.001) and 24 other values: 1.71e-14 < 1e-08 (the closest of 26) | holds |
| `dps.instability_moves`: random perturbation of amplitude 0.01 sets the site-centred DpS breather in motion | moves | noise_runs.left (noise = complex, start = site, seed = 1) and 15 other values: 0.9 < 1; noise_runs.moved (noise = complex, start = site, seed = 1) and 15 other values: 0.5 < 1; controls.later (seed = 1) and 15 other values: 0.75 < 1 | holds, assuming |
| `dps.bond_robust`: bond-centred DpS breather is structurally robust in simulations | robust | 0.2344 of the breathers leave their bond | quantified |
<!-- /statements -->

## Try it

**To change it.** The constants of the experiment are its knobs; another noise is a line of `groups_under_noise`. With
`alpha` = 2, another contact law, the run asks for the tolerances $10^{-9}$ and $10^{-11}$ in `loose` and `tight`. The
table `margins` then has 0.00243 around a site, `depinning` a threshold of 0.061, far above the noise, and none of the
64 bond-centred breathers leaves.

1. *Easy.* DpS breathers of all frequencies are alike. In the chain this holds in the limit $\omega_b\to1$:
   `build/bin/sec32_barrier barrier --omega 1.001` gives `equal_frequency` = 1.164686e-18, and
   `build/bin/sec32_barrier barrier --omega 1.002` gives `equal_frequency` = 1.658345e-17. Hint: energies of size
   $\epsilon^2$ go like $(\omega_b-1)^4$. By which factor should the barrier grow?
2. *Harder.* How flat is the potential, and is that due to the exponent $3/2$?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `energy` = 9.820924e-13, with contacts of exponent
   two `build/bin/sec32_newton_breathers breather --omega 1.001 --contact power --alpha 2` gives `energy` = 7.443482e-7,
   and `build/bin/sec32_barrier barrier --omega 1.001 --contact power --alpha 2` gives `equal_frequency` = 5.924102e-10.
   Hint: compare barrier over energy with that of the first exercise, and `spectrum --alpha 2` with `spectrum`.

`sec33_dps_stability spectrum --centre bond --mu 1 --sites 32` prints all exponents, two for each site
(one_spectrum.hpp). */
int main(int argc, char** argv) {
  return run({"sec33_dps_stability", "3.3", "Stability of the DpS breathers (section 3.3)",
              reproduce, commands<OneSpectrum>()},
             argc, argv);
}
