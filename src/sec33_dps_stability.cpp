/**
# 3.3 Are the breathers of the DpS equation stable?

Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) first asks for the stability of the
static breathers in the limit of small amplitude. It linearises the discrete p-Schrödinger (DpS)
equation about both of them, draws the eigenvalues, and lets the unstable one go. This program finds
that both spectra hang on the sixth digit of one number, and watches what that means in time.

What is claimed, with the identifiers under which the answers are recorded:

- the bond-centred breather is spectrally stable at $\mu = 1$ and 10 (`dps.bond_stable`);
- the site-centred one has a real pair $\pm\lambda$, and $\lambda$ is linear in $\mu$
  (`dps.site_growth`);
- a random perturbation of amplitude 0.01 sets it in motion (`dps.instability_moves`). */

#include <gsl/gsl_rng.h>
#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/dps/spectrum.hpp"
#include "lattice/numbers/line_fit.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/program.hpp"

using namespace lattice;

/// 113 bits, as IEEE quadruple precision.
using Quadruple = boost::multiprecision::cpp_bin_float_quad;

/**
## Model

The DpS equation, Eq. (11),
$$i\dot v_n = (v_{n+1}-v_n)|v_{n+1}-v_n|^{1/2} - (v_n-v_{n-1})|v_n-v_{n-1}|^{1/2},$$
has the solutions $v_n = u_ne^{i\mu t}$ with real $u_n$ (Eq. (14); stationary.hpp computes them,
the chain has free ends). A perturbation is added inside the turning frame, Eq. (22),
$v_n = e^{i\mu t}[u_n + a_ne^{\lambda t} + b_n^*e^{\lambda^*t}]$. Everything is dimensionless, and $t$
is the slow time of this equation.

| article | program | meaning |
|---|---|---|
| $\mu$, $u_n$ | `Stationary::mu`, `u` | frequency and profile of a breather |
| $\lambda$ | `exponents` | exponents of small perturbations |
| – | `m`, `margin` | eigenvalues of the contact matrix $M$, and $m_2-2\mu/3$ | */
constexpr std::pair<Centre, const char*> centres[] = {{Centre::site, "site"},
                                                      {Centre::bond, "bond"}};

std::size_t chain_length(Centre centre) {
  return centre == Centre::site ? 31 : 32;
}

/**
## Both spectra (figures 08 and 09)

Drawn as in the article, both spectra look alike: a point at zero and two arcs on the imaginary axis.
The insets show what decides, a pair a thousand times closer to zero than the rest.

![The bond-centred breather and its spectrum: all exponents are imaginary.](fig:08)
![The site-centred breather has a real pair, whose size is linear in the frequency.](fig:09) */
Table profile_table(Centre centre, double mu) {
  Table table{{count("n", "site", "site"), number("u", "stationary DpS breather")}};
  const auto u = stationary<double>(centre, mu, chain_length(centre)).u;
  for (std::size_t i = 0; i < u.size(); ++i)
    table.add({std::int64_t(site_number(i, u.size())), u[i]});
  return table;
}

/**
## Method: one small matrix

A contact is stiffer along its strain than across it: for small $x$ and $y$, $z|z|^{1/2}$ changes by
$|d|^{1/2}(\frac32x+iy)$ at $z = d+x+iy$. Hence $\dot x = (\mu-M)y$ and
$\dot y = -(\mu-\frac32M)x$, where the *same* symmetric matrix $M$, the Laplacian of the chain weighted
by $|d_n|^{1/2}$, stands in both. It commutes with itself, so that each of its
eigenvectors moves alone, with
$$\lambda^2 = -(\mu-m)(\mu-\tfrac32m).$$
The breather is itself an eigenvector, $Mu = \mu u$, the largest one: it gives $\lambda = 0$, a change
of phase, and no perturbation grows unless some other $m$ lies in $(\frac23\mu,\mu)$. So a breather is
stable if and only if $m_2 \le \frac23\mu$. Eigenvalues of a tridiagonal symmetric matrix cost no
digit, and we compute them in two precisions. spectrum.hpp has the details. */
template <class T>
ContactSpectrum<T> spectrum_of(Centre centre, const T& mu, std::size_t sites) {
  return contact_spectrum(stationary<T>(centre, mu, sites));
}

/// Each exponent from a long mantissa, with its distance from the one in double precision.
Table spectrum_table(Centre centre, double mu, std::size_t sites) {
  const auto coarse = exponents(spectrum_of<double>(centre, mu, sites));
  const auto fine = exponents(spectrum_of<long double>(centre, mu, sites));
  Table table{
      {number("real", "growth rate", "1 per unit of time"),
       number("imag", "frequency in the turning frame", "1 per unit of time"),
       number("error", "distance from the value in double precision", "1 per unit of time")}};
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double re = double(fine[i].first), im = double(fine[i].second);
    table.add({re, im, std::hypot(re - coarse[i].first, im - coarse[i].second)});
  }
  return table;
}

/**
## How close to the edge

The whole verdict is the sign of the margin $m_2/\mu-\frac23$. Its error is the sum of two
differences: double against a longer mantissa, and the chain against one that is ten sites longer. In
quadruple precision we find $m_2$ by counting eigenvalues instead of computing all. */
struct Margin {
  Estimate margin, exponent;  ///< m_2 / mu - 2/3 and |lambda| / mu
  bool certain() const { return std::abs(margin.value) > 100 * margin.error; }
  bool unstable() const { return margin.value > 0; }
};

template <class T>
Margin margin_and_exponent(Centre centre, double mu, std::size_t sites) {
  const auto state = stationary<T>(centre, T(mu), sites);
  const T m = counted_eigenvalue(state, 2);
  const auto rounded = [&](const T& x) { return Estimate{static_cast<double>(x), 0}; };
  return {rounded(instability_margin(state.mu, m) / state.mu),
          rounded(lambda_modulus(state.mu, m) / state.mu)};
}

template <class Fine>
Margin margin_of(Centre centre, double mu) {
  const std::size_t sites = chain_length(centre);
  Margin out = margin_and_exponent<Fine>(centre, mu, sites);
  for (const Margin& other : {margin_and_exponent<double>(centre, mu, sites),
                              margin_and_exponent<Fine>(centre, mu, sites + 10)}) {
    out.margin.error += std::abs(out.margin.value - other.margin.value);
    out.exponent.error += std::abs(out.exponent.value - other.exponent.value);
  }
  return out;
}

/**
The bond-centred breather is stable if its margin is negative at both frequencies, by a hundred times
the error: a sign within the error would be no verdict, and the answer zero. */
void report_margins(Report& report) {
  bool stable = true;
  for (const auto& [centre, name] : centres)
    for (const double mu : {1.0, 10.0}) {
      const Margin found = margin_of<Quadruple>(centre, mu);
      const std::string suffix = std::string("_") + name + (mu > 1 ? "_mu10" : "");
      report.facts.add("margin" + suffix, found.margin, "mu");
      report.facts.add("exponent" + suffix, found.exponent, "mu");
      if (centre == Centre::bond) stable = stable && found.certain() && !found.unstable();
    }
  report.results.claim("dps.bond_stable", stable);
}

/**
Scale invariance makes $\lambda/\mu$ a pure number. Newton's method and the matrix know nothing of that,
so we compute $\lambda$ anew for frequencies over six decades. It counts as linear if $\lambda/\mu$
varies by less than $10^{-8}$ of itself, about what double precision leaves of it, and if the real pair
is there at every $\mu$, a hundred errors from the edge. */
void report_growth(Report& report) {
  std::vector<double> mus{1e-3, 1e-2, 0.1};
  for (int k = 1; k <= 20; ++k) mus.push_back(0.5 * k);
  mus.insert(mus.end(), {100, 1000});
  Table table{{number("mu", "frequency"), number("rate", "growth rate", "1 per unit of time"),
               number("rate_error", "from two precisions and two lengths", "1 per unit of time"),
               number("line", "slope at mu = 1 times mu", "1 per unit of time"),
               number("ratio", "growth rate over mu")}};
  const double slope = margin_of<long double>(Centre::site, 1).exponent.value;
  double apart = 0;
  bool unstable = true;
  for (const double mu : mus) {
    const Margin found = margin_of<long double>(Centre::site, mu);
    const Estimate& rate = found.exponent;
    table.add({mu, mu * rate.value, mu * rate.error, mu * slope, rate.value});
    apart = std::max(apart, std::abs(rate.value / slope - 1) + rate.error / slope);
    unstable = unstable && found.certain() && found.unstable();
  }
  report.output.add("growth", table);
  report.facts.add("linearity", {apart, 0});
  report.results.claim("dps.site_growth", unstable && apart < 1e-8);
}

/**
## Checks: the full matrix

The article's way, a matrix of $2N$ rows, is the independent route. It agrees on the pair near zero, and
it shows a trap: the two zeros of the phase share one eigenvector, so an error $\delta$ of the matrix
moves them by $\sqrt\delta$, and they may leave on either axis. A real pair is evidence only where it
is far larger. We record both, in double and in extended precision. */
template <class T>
void report_full_matrix(Report& report, const std::string& precision) {
  for (const auto& [centre, name] : centres) {
    const auto state = stationary<T>(centre, T(1), chain_length(centre));
    auto full = full_exponents(state);
    std::sort(full.begin(), full.end(),
              [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); });
    const T pair = lambda_modulus(T(1), contact_spectrum(state).m[1]);
    const bool real = centre == Centre::site;
    const T found = std::abs(real ? full[2].real() : full[2].imag());
    const T wrong = std::abs(real ? full[2].imag() : full[2].real());
    const std::string suffix = "_" + precision + "_" + name;
    report.facts.add("full_matrix_difference" + suffix,
                     {double(std::abs(found - pair) + wrong), 0});
    report.facts.add("full_matrix_zero" + suffix, {double(std::abs(full[1])), 0});
  }
}

/**
## The eigenvectors, for figure x06

How lonely is $m_2$? Figure x06 draws all eigenvalues of $M$ against the edge $\frac23\mu$.

![The second eigenvalue of both breathers sits on the edge of instability; what follows in time.](fig:x06) */
Table contact_table(Centre centre) {
  Table table{{count("k", "number of the eigenvalue"),
               number("m", "eigenvalue of the contact matrix, mu = 1"),
               number("from_edge", "m - 2/3, in millionths")}};
  const auto s = spectrum_of<long double>(centre, 1, chain_length(centre));
  for (std::size_t k = 0; k < s.m.size(); ++k)
    table.add(
        {std::int64_t(k + 1), double(s.m[k]), double(1e6L * instability_margin(s.mu, s.m[k]))});
  return table;
}

/**
## The instability at work

We now let the breathers of $\mu = 10$ go. Their centre is $\sum n|v_n|^4/\sum|v_n|^4$, where the fourth
power keeps the small noise of the whole chain out, and $X$ is its distance from the initial one. We
integrate in the turning frame at two tolerances (evolve.hpp), and also take samples twice as densely
in the finer run, because times are read from them. */
constexpr double mu_high = 10, duration = 500;

struct Accuracy {
  double tolerance;
  std::size_t samples;  ///< per 500 units of time
};
constexpr Accuracy coarse{1e-8, 500}, fine{1e-10, 1000};

struct Course {
  std::vector<double> t{}, X{};
  double norm_drift = 0, energy_drift = 0;

  double largest() const {
    double top = 0;
    for (const double x : X) top = std::max(top, std::abs(x));
    return top;
  }
  /// When the centre has gone `distance` sites; nan if it never does.
  double reaches(double distance) const {
    for (std::size_t k = 1; k < X.size(); ++k)
      if (const double now = std::abs(X[k]), before = std::abs(X[k - 1]); now > distance)
        return t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
    return std::nan("");
  }
};

double centre_of(Centre centre, const Field& v) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double weight = std::norm(v[i]) * std::norm(v[i]);
    sum += weight;
    moment += weight * double(site_number(i, v.size()));
  }
  return moment / sum - (centre == Centre::bond ? 0.5 : 0);
}

/**
`watch` sees every sample: the maps of figure 10 and the projections are taken there. */
template <class Watch>
Course follow(Centre centre, Field v, double time, const Accuracy& accuracy, Watch watch) {
  Course out;
  const double start = energy(v);
  const auto samples = std::size_t(std::ceil(double(accuracy.samples) * time / duration));
  const TurningDps equation{{v.size(), Ends::free, 1}, mu_high};
  out.norm_drift =
      evolve_dps(equation, v, time, samples, accuracy.tolerance, [&](double t, const Field& now) {
        out.t.push_back(t);
        out.X.push_back(centre_of(centre, now));
        out.energy_drift = std::max(out.energy_drift, std::abs(energy(now) / start - 1));
        watch(t, now);
      });
  return out;
}

void unwatched(double, const Field&) {}

/// A breather of mu = 10 with its pinning pair.
struct Breather {
  Centre centre;
  Field u;
  PinningPair pair;

  explicit Breather(Centre c) : Breather(c, stationary<double>(c, mu_high, chain_length(c))) {}
  Breather(Centre c, const Stationary<double>& state)
      : centre(c), u(state.u.begin(), state.u.end()), pair(contact_spectrum(state, true)) {
    if (shift() < 0) pair.V = -pair.V;
  }
  /// How far the centre moves, in sites, for a unit of V: the derivative of `centre_of`.
  double shift() const {
    double sum = 0, moment = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double x = u[i].real(),
                   n = double(site_number(i, u.size())) - (centre == Centre::bond ? 0.5 : 0);
      sum += x * x * x * x;
      moment += 4 * n * x * x * x * pair.V(Eigen::Index(i));
    }
    return moment / sum;
  }
};

/**
### Growth in time against the eigenvalue

Does the exponent of the matrix come out of the nonlinear equation? We displace the breather along the
growing direction, by a millionth of its size, and fit a line to the logarithm of the growing share
over four times $1/\lambda$. The error is the difference of two tolerances, plus that of a displacement
ten times larger, which measures what the nonlinear terms do. */
double measured_rate(const Breather& breather, double size, const Accuracy& accuracy) {
  Field v = breather.u;
  breather.pair.add({size, size / breather.pair.push}, v);
  std::vector<double> t, share;
  follow(breather.centre, v, 4 / breather.pair.rate, accuracy, [&](double now, const Field& w) {
    Field rest = w;
    for (std::size_t i = 0; i < w.size(); ++i) rest[i] -= breather.u[i];
    t.push_back(now);
    share.push_back(std::log(breather.pair.growing(rest)));
  });
  return fit_line(t, share).slope;
}

void report_rate(Report& report, const Breather& site) {
  const double size = 1e-6 * std::abs(site.u[site_index(0, site.u.size())]);
  Estimate rate =
      compare(measured_rate(site, size, {1e-11, 500}), measured_rate(site, size, {1e-13, 1000}));
  rate.error += std::abs(rate.value - measured_rate(site, 10 * size, {1e-13, 1000}));
  report.facts.add("rate_in_time", rate, "1 per unit of time");
  report.facts.add("rate_of_matrix", {site.pair.rate, 0}, "1 per unit of time");
}

/**
### What kind of perturbation?

The article says "uniformly distributed" and "of amplitude 0.01", and no more. As $v_n$ is complex, our
main reading adds $0.01(\xi_n+i\eta_n)$ at every site, $\xi_n$ and $\eta_n$ uniform in $(-1,1)$. Other
readings are tried beside it: real noise, positive real noise (what a routine that returns numbers
from 0 to 1 gives), and noise that is proportional to $u_n$. The generator is GSL's `mt19937`, with the
seed recorded in each row. */
struct Reading {
  const char* name;
  bool imaginary, positive, relative;
};
constexpr Reading readings[] = {{"complex", true, false, false},
                                {"real", false, false, false},
                                {"positive", false, true, false},
                                {"relative", true, false, true}};
constexpr double amplitude = 0.01;

Field noise(const Breather& breather, const Reading& reading, std::size_t seed) {
  const std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> rng(gsl_rng_alloc(gsl_rng_mt19937),
                                                         gsl_rng_free);
  gsl_rng_set(rng.get(), seed);
  const auto draw = [&] {
    const double x = gsl_rng_uniform(rng.get());
    return amplitude * (reading.positive ? x : 2 * x - 1);
  };
  Field w;
  for (const auto& u : breather.u) {
    const double re = draw(), im = reading.imaginary ? draw() : 0;
    w.push_back(std::complex<double>(re, im) * (reading.relative ? u : 1.0));
  }
  return w;
}

/**
The control takes the same noise and removes its part in the pinning pair, both the growing and the
decaying direction, and nothing else. To first order it cannot move. */
enum class Case { site, control, bond };
constexpr const char* case_names[] = {"site", "control", "bond"};

struct Trial {
  const Reading* reading;
  Case which;
  std::size_t seed;
  double time;
  std::complex<double> kick{};  ///< shift and push of the noise
  double growing = 0;
  Course rough{}, good{};
};

Field perturbed(const Breather& breather, const Trial& trial) {
  Field w = noise(breather, *trial.reading, trial.seed);
  if (trial.which == Case::control) breather.pair.add(-breather.pair.of(w), w);
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += breather.u[i];
  return w;
}

void run(const Breather& breather, Trial& trial) {
  const Field w = noise(breather, *trial.reading, trial.seed);
  if (trial.which != Case::control) {
    trial.kick = breather.pair.of(w);
    trial.growing = breather.pair.growing(w);
  }
  const Field v = perturbed(breather, trial);
  trial.rough = follow(breather.centre, v, trial.time, coarse, unwatched);
  trial.good = follow(breather.centre, v, trial.time, fine, unwatched);
}

/**
Sixteen seeds for the main reading; the others, whose breathers wait longer, get six seeds and half as much
time again. */
double run_time(const Reading& reading) {
  return &reading == readings ? duration : 1.5 * duration;
}

std::vector<Trial> run_trials(bool quick, const Breather& site, const Breather& bond) {
  std::vector<Trial> trials;
  for (const Reading& reading : readings) {
    const bool main = &reading == readings;
    const std::size_t seeds = quick ? (main ? 4 : 1) : (main ? 16 : 6);
    for (std::size_t seed = 1; seed <= seeds; ++seed)
      for (const Case which : {Case::site, Case::control, Case::bond})
        if (main || which != Case::control)
          trials.push_back({&reading, which, seed, run_time(reading)});
  }
  Progress progress("perturbed breathers", trials.size());
  parallel_for(trials.size(), [&](std::size_t i) {
    run(trials[i].which == Case::bond ? bond : site, trials[i]);
    progress.tick();
  });
  return trials;
}

/**
### Why: a pendulum

With $X = gx$, $g$ the derivative of the centre (`shift`), the pinning pair obeys
$\ddot X = \pm\lambda^2X$ with a plus at a site and a minus at a bond. The simplest landscape with
both is a sine, which makes the centre a pendulum, $\ddot X = \frac{\lambda^2}{2\pi}\sin2\pi X$ about a
site, and a push $y$ its initial speed $g(\mu-m)y$. It predicts three things that we compare with the
full equation: a bond-centred breather is freed by a push above $|\lambda|/(\pi g(\mu-m))$, a growing
share $c$ of the perturbation takes a site-centred one to the neighbouring bond after a time that is a
complete elliptic integral, and what is freed goes on at a mean speed that is half a site over that
time. */
double freeing_push(const Breather& bond) {
  const PinningPair& p = bond.pair;
  return p.rate / (std::numbers::pi * bond.shift() * (p.mu - p.m));
}

double pendulum_departure(const Breather& site, double growing) {
  const double speed = 2 * site.shift() * site.pair.rate * std::abs(growing);
  const double k = site.pair.rate / (std::numbers::pi * speed), root = std::sqrt(1 + k * k);
  return gsl_sf_ellint_Kcomp(k / root, GSL_PREC_DOUBLE) / (root * std::numbers::pi * speed);
}

/**
The first of the three is tested without noise. A push is bisected between 0.8 and 1.2 of the prediction,
where the ends must decide differently. Free means beyond the next site, which no oscillation in the
well of this bond reaches; a run of $12/|\lambda|$ resolves a push that is $e^{-8}$ from the edge. */
double bisect_push(const Breather& bond, const Accuracy& accuracy, int steps) {
  const auto freed = [&](double push) {
    Field v = bond.u;
    bond.pair.add({0, push}, v);
    return follow(bond.centre, v, 12 / bond.pair.rate, accuracy, unwatched).largest() > 1;
  };
  double low = 0.8 * freeing_push(bond), high = 1.2 * freeing_push(bond);
  if (freed(low) || !freed(high))
    throw Failure("the push that frees the bond-centred breather is not between " +
                  std::to_string(low) + " and " + std::to_string(high));
  for (int k = 0; k < steps; ++k) {
    const double middle = (low + high) / 2;
    (freed(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

double report_push(Report& report, const Breather& bond) {
  const int steps = report.quick ? 3 : 9;
  double found[2];
  parallel_for(2, [&](std::size_t i) { found[i] = bisect_push(bond, i ? fine : coarse, steps); });
  Estimate push = compare(found[0], found[1]);
  push.error += 0.2 * freeing_push(bond) / std::exp2(steps);
  report.facts.add("freeing_push", push);
  report.facts.add("freeing_push_of_pendulum", {freeing_push(bond), 0});
  return push.value;
}

/**
### Verdict

Motion means that the centre passes the neighbouring site within the 500 units of time,
$|X| > 1$: a breather that only falls into the well beside it swings back before. The statement is
statistical. We let it stand if at least half of the sixteen seeds move and none of the sixteen controls
does, and if both tolerances count the same. */
bool moved(const Course& course) {
  return course.largest() > 1;
}

struct Census {
  std::size_t seeds = 0, moved = 0, left = 0;
  bool agreed = true;
  std::vector<double> departures{}, speeds{};
};

Census tally(const std::vector<Trial>& trials, const Reading& reading, Case which) {
  Census out;
  for (const Trial& trial : trials) {
    if (trial.reading != &reading || trial.which != which) continue;
    const double leaves = trial.good.reaches(0.5), there = trial.good.reaches(1.5);
    ++out.seeds;
    out.moved += moved(trial.good);
    out.left += std::isfinite(leaves);
    out.agreed = out.agreed && moved(trial.good) == moved(trial.rough);
    out.departures.push_back(std::isfinite(leaves) ? leaves : HUGE_VAL);
    if (std::isfinite(there)) out.speeds.push_back(1 / (there - leaves));
  }
  std::sort(out.departures.begin(), out.departures.end());
  std::sort(out.speeds.begin(), out.speeds.end());
  return out;
}

/// The trials of the main reading, a row each; what did not happen is nan.
Table trial_table(const std::vector<Trial>& trials, Case which, const Breather& site) {
  const std::string time = "unit of time";
  Table table{{count("seed", "seed of the generator"),
               number("shift", "real part of the noise along the pinning mode"),
               number("push", "imaginary part of the noise along the pinning mode"),
               number("push_size", "its modulus"),
               number("growing", "size of the growing share of the noise"),
               number("leaves", "time at which |X| = 1/2", time),
               number("leaves_error", "difference of two tolerances", time),
               number("pendulum", "the same time for a pendulum on a site", time),
               number("speed", "mean over the site from |X| = 1/2 to 3/2", "site per unit of time"),
               number("largest", "largest |X|", "site"),
               number("largest_error", "difference of two tolerances", "site"),
               number("energy_drift", "relative drift of the energy"),
               number("norm_drift", "relative drift of the norm")}};
  for (const Trial& trial : trials) {
    if (trial.reading != readings || trial.which != which) continue;
    const Course& c = trial.good;
    const double leaves = c.reaches(0.5), pendulum = pendulum_departure(site, trial.growing);
    table.add({std::int64_t(trial.seed), trial.kick.real(), trial.kick.imag(),
               std::abs(trial.kick.imag()), std::abs(trial.growing), leaves,
               std::abs(leaves - trial.rough.reaches(0.5)),
               which == Case::site ? pendulum : std::nan(""), 1 / (c.reaches(1.5) - leaves),
               c.largest(), std::abs(c.largest() - trial.rough.largest()), c.energy_drift,
               c.norm_drift});
  }
  return table;
}

/// X(t) of the main reading.
Table path_table(const std::vector<Trial>& trials, Case which) {
  Table table{{count("seed", "seed of the generator"), number("t", "time", "unit of time"),
               number("X", "displacement", "site")}};
  for (const Trial& trial : trials)
    if (trial.reading == readings && trial.which == which)
      for (std::size_t k = 0; k < trial.good.t.size(); k += 10)
        table.add({std::int64_t(trial.seed), trial.good.t[k], trial.good.X[k]});
  return table;
}

/**
For each reading and case we count how many seeds there were, how many left their place, how many moved,
and give the middle one of the times and of the speeds. */
Table reading_table(const std::vector<Trial>& trials) {
  Table table{
      {label("reading", "kind of noise"), label("case", "site, control or bond"),
       count("seeds", "number of runs"), number("time", "length of a run", "unit of time"),
       count("left", "runs with |X| > 1/2"), count("moved", "runs with |X| > 1"),
       number("departure", "middle time at which |X| = 1/2", "unit of time"),
       number("speed", "middle speed of those that got to |X| = 3/2", "site per unit of time")}};
  for (const Reading& reading : readings)
    for (const Case which : {Case::site, Case::control, Case::bond}) {
      const Census c = tally(trials, reading, which);
      if (c.seeds == 0) continue;
      const double middle = c.departures[c.seeds / 2];
      table.add({std::string(reading.name), std::string(case_names[int(which)]),
                 std::int64_t(c.seeds), run_time(reading), std::int64_t(c.left),
                 std::int64_t(c.moved), std::isfinite(middle) ? middle : std::nan(""),
                 c.speeds.empty() ? std::nan("") : c.speeds[c.speeds.size() / 2]});
    }
  return table;
}

/**
The counts and middle values that the text quotes are facts; whole numbers are exact once both
tolerances agree on them. */
void report_census(Report& report, const std::vector<Trial>& trials) {
  const auto fact = [&](const std::string& name, double value, const std::string& unit = "") {
    report.facts.add(name, {value, 0}, unit);
  };
  for (const Reading& reading : readings)
    for (const Case which : {Case::site, Case::control, Case::bond}) {
      const Census c = tally(trials, reading, which);
      if (c.seeds == 0) continue;
      const std::string suffix = std::string("_") + reading.name + "_" + case_names[int(which)];
      fact("seeds" + suffix, double(c.seeds));
      fact("left" + suffix, double(c.left));
      fact("moved" + suffix, double(c.moved));
      if (which != Case::bond)
        fact("departure" + suffix, c.departures[c.seeds / 2], "unit of time");
      if (c.speeds.empty()) continue;
      fact("slowest" + suffix, c.speeds.front(), "site per unit of time");
      fact("fastest" + suffix, c.speeds.back(), "site per unit of time");
    }
}

/**
The pendulum's margin: by how much its departures differ from those of the equation, and whether it names
the bond-centred breathers that move. */
void report_pendulum(Report& report, const std::vector<Trial>& trials, const Breather& site,
                     double freeing) {
  double apart = 0, drift = 0, agree = 0, pushed = 0;
  for (const Trial& trial : trials) {
    drift = std::max({drift, trial.good.energy_drift, trial.good.norm_drift});
    if (trial.reading != readings) continue;
    if (trial.which == Case::site)
      apart = std::max(
          apart, std::abs(trial.good.reaches(0.5) / pendulum_departure(site, trial.growing) - 1));
    const bool over = std::abs(trial.kick.imag()) > freeing;
    if (trial.which == Case::bond) {
      pushed += over;
      agree += over == moved(trial.good);
    }
  }
  report.facts.add("pendulum_departure_difference", {apart, 0});
  report.facts.add("bond_pushed_over", {pushed, 0});
  report.facts.add("bond_as_pushed", {agree, 0});
  report.facts.add("largest_drift", {drift, 0});
}

void report_motion(Report& report, const Breather& site, const Breather& bond) {
  const auto trials = run_trials(report.quick, site, bond);
  report.output.add("readings", reading_table(trials));
  report_census(report, trials);
  report_pendulum(report, trials, site, report_push(report, bond));
  for (const Case which : {Case::site, Case::control, Case::bond}) {
    const std::string suffix = std::string("_") + case_names[int(which)];
    report.output.add("trials" + suffix, trial_table(trials, which, site));
    report.output.add("paths" + suffix, path_table(trials, which));
  }
  const Census free = tally(trials, readings[0], Case::site);
  const Census held = tally(trials, readings[0], Case::control);
  report.results.claim("dps.instability_moves",
                       free.agreed && held.agreed && 2 * free.moved >= free.seeds && !held.moved);
}

/**
## The article's picture (figure 10)

One seed as a map of $|v_n(t)|^2$, beside its control and the bond-centred breather under the noise of
the same seed.

![The perturbed site-centred breather leaves; without the pinning pair the same noise holds it for
long.](fig:10) */
constexpr std::size_t map_seed = 1;

void report_maps(Report& report, const Breather& site, const Breather& bond) {
  for (const Case which : {Case::site, Case::control, Case::bond}) {
    const Breather& breather = which == Case::bond ? bond : site;
    Table map{{number("t", "time", "unit of time"), count("n", "site", "site"),
               number("density", "|v_n|^2")}};
    const Field v = perturbed(breather, {readings, which, map_seed, duration});
    follow(breather.centre, v, duration, {fine.tolerance, 250}, [&](double t, const Field& now) {
      for (std::size_t i = 0; i < now.size(); ++i)
        map.add({t, std::int64_t(site_number(i, now.size())), std::norm(now[i])});
    });
    report.output.add(std::string("map_") + case_names[int(which)], std::move(map));
  }
}

/**
## Results

TODO */
Results everything(Output& output, bool quick) {
  Report report{output, quick};
  report_margins(report);
  report_growth(report);
  report_full_matrix<double>(report, "double");
  report_full_matrix<long double>(report, "extended");
  for (const double mu : {1.0, 10.0}) {
    const std::string suffix = mu > 1 ? "_mu10" : "_mu1";
    for (const auto& [centre, name] : centres) {
      output.add("profile_" + std::string(name) + suffix, profile_table(centre, mu));
      output.add("spectrum_" + std::string(name) + suffix,
                 spectrum_table(centre, mu, chain_length(centre)));
    }
  }
  for (const auto& [centre, name] : centres)
    output.add("contacts_" + std::string(name), contact_table(centre));
  const Breather site(Centre::site), bond(Centre::bond);
  report_rate(report, site);
  report_motion(report, site, bond);
  report_maps(report, site, bond);
  output.add("facts", report.facts.table);
  return report.results;
}

/**
## One spectrum with your own parameters

`sec33_dps_stability spectrum --centre bond --mu 1 --sites 32` prints all exponents, two a site, those
closest to instability behind the two zeros of the phase. */
struct SpectrumOptions {
  std::string centre = "site";
  double mu = 1;
  std::size_t sites = 0;  ///< 0: as in the full run
};

Table spectrum_command(const SpectrumOptions& options) {
  const Centre centre = options.centre == "site" ? Centre::site : Centre::bond;
  const std::size_t sites = options.sites ? options.sites : chain_length(centre);
  if (!fits(centre, sites))
    throw UsageError("--sites: '" + std::to_string(sites) + "' does not fit a " + options.centre +
                     "-centred breather (allowed: an " + (centre == Centre::bond ? "even" : "odd") +
                     " number)");
  return spectrum_table(centre, options.mu, sites);
}

void add_options(CLI::App& spectrum, SpectrumOptions& options) {
  spectrum.add_option("--centre", options.centre, "centre: site or bond")
      ->check(CLI::IsMember({"site", "bond"}))
      ->capture_default_str();
  spectrum.add_option("--mu", options.mu, "frequency of the breather")
      ->check(in_range(1e-6, 1e6))
      ->capture_default_str();
  spectrum.add_option("--sites", options.sites, "chain length (default: 31 or 32)")
      ->check(in_range(4, 1001));
}

/**
## Differences and limits

TODO */
int main(int argc, char** argv) {
  Program program({"sec33_dps_stability", "3.3", "Stability of the DpS breathers (section 3.3)"},
                  argc, argv);
  SpectrumOptions options;
  CLI::App* spectrum = program.command("spectrum", "all exponents of a breather",
                                       [&] { return spectrum_command(options); });
  add_options(*spectrum, options);
  program.everything = [&](Output& output) { return everything(output, program.quick); };
  return program.run(argc, argv);
}
