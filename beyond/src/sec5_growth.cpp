/**
# 5 Modulational instability without precompression

"An extensive study of MI in the cradle model (with the help of the DpS equation) would be of interest", says the
conclusion of James, Kevrekidis and Cuevas (Physica D 251, 2013), because such an instability could create static
breathers where no bead can be set in motion by itself. This chapter carries out the study for plane waves.

![Which waves are unstable to which modulations, and how nearly the chain agrees.](fig:x32)
![What two unstable waves become, and the breathers that they leave.](fig:x33)

Nothing is compressed: the contacts of a plane wave are open for half of the time, and there is no linear band. James
(Math. Models Methods Appl. Sci. 21 (2011) 2335, arXiv:1008.1153) derived the DpS equation with its plane waves, proved
that the chain has such waves too, and saw in runs that some of them break up into static and travelling breathers. Two
lines of algebra show which modulations grow, and how fast. */

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_plane_wave.hpp"
#include "lattice/model/cantilever.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec5/dps_tracks.hpp"
#include "sec5/dps_waves.hpp"
#include "sec5/leftovers.hpp"

using namespace lattice;
using std::numbers::pi;

/**
## Model

In the slow time $\tau = \epsilon^{1/2}t$ the DpS equation (12) is $2i\tau_0\,\partial_\tau A_n = D_n-D_{n-1}$ with
$D_n = (A_{n+1}-A_n)|A_{n+1}-A_n|^{1/2}$, and plane waves $A_n = A\,e^{i(qn-\Omega\tau)}$ solve it with $\Omega =
-4\rho\sin^2\frac q2$ and the rate $\rho = |2A\sin\frac q2|^{1/2}/2\tau_0$. A modulation changes $A_n$ by the factor
$1+x\,e^{iQn+\sigma\tau}+\bar y\,e^{-iQn+\bar\sigma\tau}$. To first order a force $z|z|^{1/2}$ changes by
$|z|^{1/2}(\frac54\,\delta z+\frac z{4\bar z}\,\delta\bar z)$, and the sums over both contacts of a bead give, with $c =
\cos q$ and $C = \cos Q$,
$$\frac{i\sigma}\rho\begin{pmatrix}x\\y\end{pmatrix} =
  \begin{pmatrix}a+e & k\\ -k & e-a\end{pmatrix}\begin{pmatrix}x\\y\end{pmatrix},\qquad
  a = \tfrac52cC-\tfrac12-2c,\quad e = -\tfrac52\sin q\sin Q,\quad k = \tfrac12(c-C).$$
$e$ shifts only the frequency of the modulation. It grows if the coupling of the side bands $q\pm Q$ exceeds their
detuning, $|k|>|a|$. Rates go like $|A|^{1/2}$, so $|A| = 1$ throughout; a bead of the chain, $y_n =
2\epsilon\,\mathrm{Re}(A_ne^{it})$, then oscillates by $\pm2\epsilon$.

| symbol | program | meaning |
|---|---|---|
| $q$, $\Omega$ | `q`, `frequency` | wavenumber and frequency of the wave |
| $Q$, $Q_*$ | `modulation`, `edge` | wavenumber of the modulation, edge of the unstable band |
| $\mathrm{Re}\,\sigma$ | `growth` | growth rate per unit of the slow time $\tau = \epsilon^{1/2}t$ |
| $\epsilon$ | `eps` | amplitude scale of the chain | */
void report_chart(Report& report) {
  const int points = report.quick ? 20 : 60;
  Table& growth =
      report.table("growth", {number("q", "wavenumber q of the plane wave", "1/site"),
                              number("modulation", "wavenumber Q", "1/site"),
                              number("growth", "growth rate per unit of slow time, at |A| = 1")});
  for (int i = 0; i < points; ++i)
    for (int k = 0; k < points; ++k) {
      const double q = pi * (0.4 + 0.6 * (i + 0.5) / points), Q = pi * (k + 0.5) / points;
      growth.add({q, Q, DpsWave<double>{q}.growth(Q)});
    }
  Table& edge = report.table(
      "edge", {number("q", "wavenumber q of the plane wave", "1/site"),
               number("edge", "edge Q_* of the unstable band", "1/site"),
               number("fastest", "wavenumber Q of the fastest-growing modulation", "1/site")});
  for (int i = 1; i <= 400; ++i) {
    const DpsWave<double> wave{pi / 2 * (1 + i / 400.0)};
    edge.add({wave.q, wave.edge(), wave.fastest()});
  }
}

/**
## The chart, and why its edge is at $q = \pi/2$

The eigenvalues are $\sigma = \rho\,(-ie\pm\sqrt{k^2-a^2})$, and the root factorises,
$$(\mathrm{Re}\,\sigma)^2 = \rho^2(k-a)(k+a) = \tfrac14\rho^2(1+5c)(1-C)\bigl[(5c-1)C-(1+3c)\bigr].$$
The bracket is linear in $C$: it is $-2(1-c)$ for the longest modulations, $C = 1$, and $-8c$ for the shortest, $C =
-1$. For $c\ge0$ it is positive nowhere, and nothing grows. Beyond $q = \pi/2$ it becomes positive at $C = -1$ first:
the shortest modulations grow, neighbours against each other, from the edge $\cos Q_* = (1+3c)/(5c-1)$ on. At $c =
-\frac15$ the factor $1+5c$ vanishes for every $Q$, and beyond it is negative: now those grow for which the bracket is
negative, the long ones up to $Q_*$, in proportion to $Q$, as $1-C\simeq\frac12Q^2$. Under precompression (section 4) a
linear dispersion of fixed strength acts against the nonlinearity, and the band narrows with the amplitude. Here both
come from the contacts, and $Q_*$ does not depend on the amplitude. In short: [](finding:growth.bands) */
void report_fastest(Report& report) {
  const auto growth = [](const auto& w) { return w.growth(w.fastest()); };
  const auto fastest = [](const auto& w) { return w.fastest(); };
  const auto edge = [](const auto& w) { return w.edge(); };
  report.facts.add("greatest_growth", in_two_precisions(pi, growth));
  report.facts.add("fastest_modulation", in_two_precisions(pi, fastest), "1/site");
  report.facts.add("edge_at_pi", in_two_precisions(pi, edge), "1/site");
}

/**
## Two checks without the algebra

The matrix of a ring, from differences of the right side of the DpS equation, must have the exponents of the closed
form. For the waves $0<q<\pi$ on rings of 18 and 30 sites and all their modulations the largest distance is
[6e-10](num:sec5_growth.exponents_apart) of the wave's rate. And runs of the DpS equation must show the growth:
theirs differs by [2.96e-8](num:sec5_growth.dps_runs_apart) at most. */
std::vector<ModulatedWave> waves_tried() {
  return {{8, 4, 1}, {12, 4, 2}, {16, 6, 2}, {16, 5, 2}, {34, 9, 17}};
}

void report_checks(Report& report) {
  std::array<double, 2> apart{};
  for (int k = 1; k < 15; ++k) {
    if (k < 9) apart[0] = std::max(apart[0], exponents_apart(18, k));
    apart[1] = std::max(apart[1], exponents_apart(30, k));
  }
  report.facts.add("exponents_apart", compare(apart[0], apart[1]));
  Estimate runs{};
  for (const ModulatedWave& wave : waves_tried()) {
    const double rough = run_in_dps(wave, 1e-10).growth, fine = run_in_dps(wave, 1e-12).growth;
    runs = larger(runs,
                  compare(std::abs(rough / wave.growth() - 1), std::abs(fine / wave.growth() - 1)));
  }
  report.facts.add("dps_runs_apart", runs);
  if (!(apart[1] < 1e-6 && runs.value < 1e-5))
    throw Failure("the closed form of the growth is not that of the DpS equation");
}

/**
## The chain

[](finding:growth.chain) The limit is reached slowly. Averaging leaves corrections of relative size $\epsilon^{1/2}$,
and so should growth and frequency approach those of the DpS equation. We follow five unstable waves of the chain,
computed by Newton's method, down to $\epsilon = 10^{-7}$, and compare the fastest growth on a ring (`chain_rates`,
dps_waves.hpp). The orders of the other four lie between [0.500](num:sec5_growth.order_growth_16_6) and
[0.51](num:sec5_growth.order_growth_16_5). The prefactor is large: at $\epsilon = 10^{-2}$ the wave $q = \pi$ loses more
than a quarter of its growth. */
struct ChainPoint {
  ModulatedWave wave;
  double eps;
};

std::vector<ChainPoint> chain_points(const std::vector<ModulatedWave>& waves,
                                     const std::vector<double>& sizes) {
  std::vector<ChainPoint> points;
  for (const ModulatedWave& wave : waves)
    for (double eps : sizes) points.push_back({wave, eps});
  return points;
}

void report_chain(Report& report) {
  Table& table = report.table(
      "chain_growth",
      {count("sites", "length of the ring", "site"), number("q", "wavenumber", "1/site"),
       number("eps", "amplitude scale"),
       number("dps", "largest growth rate on the ring in the DpS equation"),
       estimate("growth", "largest growth rate on the ring in the chain"),
       estimate("apart", "modulus of the relative difference of the growth rates"),
       estimate("shift_apart", "modulus of the relative difference of the frequency shifts")});
  std::vector<double> sizes{1e-2, 1e-3, 1e-4};
  if (!report.quick) sizes.insert(sizes.end(), {1e-5, 1e-6, 1e-7});
  table.fill(chain_points(waves_tried(), sizes), [](const ChainPoint& p) {
    const WaveRates coarse = chain_rates(p.wave, p.eps, 12), fine = chain_rates(p.wave, p.eps, 24);
    const double dps = largest_growth(p.wave), shift = p.wave.wave().frequency();
    const auto off = [](double value, double limit) { return std::abs(value / limit - 1); };
    return Cells{std::int64_t(p.wave.sites),
                 p.wave.wave().q,
                 p.eps,
                 dps,
                 compare(coarse.growth, fine.growth),
                 compare(off(coarse.growth, dps), off(fine.growth, dps)),
                 compare(off(coarse.frequency, shift), off(fine.frequency, shift))};
  });

  // The order between neighbouring amplitudes; that of the next pair tells how far it is from its limit
  const auto apart = table.numbers("apart");
  const auto order = [&](std::size_t k) { return std::log10(apart[k - 1] / apart[k]); };
  const std::vector<ModulatedWave> waves = waves_tried();
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const ModulatedWave& wave = waves[i];
    const std::string name = std::to_string(wave.sites) + "_" + std::to_string(wave.waves);
    const std::size_t last = (i + 1) * sizes.size() - 1;
    report.facts.add("order_growth_" + name, compare(order(last - 1), order(last)));
    const std::size_t thousandth = i * sizes.size() + 1;
    report.facts.add("growth_3_" + name, {table.numbers("growth")[thousandth],
                                          table.numbers("growth_error")[thousandth]});
  }
}

/**
Runs test the linearisation. The growth of the side band in runs of the chain is measured at $\epsilon = 10^{-3}$. The
runs start from the field of the DpS equation, which is a wave of the chain up to $\epsilon^{1/2}$ only and brings
harmonics; of $q = \pi$ and $\frac23\pi$ these are stable modulations, and harmless. */
void report_runs(Report& report) {
  const double eps = 1e-3;
  for (const ModulatedWave& wave : {waves_tried()[0], waves_tried()[1]}) {
    const double own = chain_rates(wave, eps, 24).growth;
    report.facts.add("run_over_eigenvalue_" + std::to_string(wave.sites),
                     compare(run_in_chain(wave, eps, 0.2).growth / own,
                             run_in_chain(wave, eps, 0.1).growth / own));
  }
}

/**
## Two marginal waves

At $q = \frac\pi2$ and where $\cos q = -\frac15$ nothing grows exponentially in the DpS equation, and yet these waves
are not stable but marginal: where $k^2 = a^2\ne0$ two exponents coincide with one eigenvector, and a modulation grows
linearly in time. A phase modulation $Q = \pi$ of the first becomes [154](num:sec5_growth.side_band_400) times as large
in 400 units of slow time. The second nearly fits on a ring of 39 sites, where it grows at
[0.00193](num:sec5_growth.growth_on_39) at most; on twice that ring, with noise of one per cent, it keeps
[0.016](num:sec5_growth.share_left_fifth) in 300 units.

In the chain both waves are exponentially unstable; the table has the growth of a modulation of $q = \frac\pi2$. Between
the two smallest amplitudes the growth has the order [0.248](num:sec5_growth.order_quarter) and on 39 sites
[0.242](num:sec5_growth.order_fifth), close to $\frac14$: corrections of the size $\epsilon^{1/2}$ split a double
exponent by the root of their size. So here the chain does not agree with the DpS equation up to $\epsilon^{1/2}$. Four
waves below $\frac\pi2$ show no growth beyond [5e-5](num:sec5_growth.growth_below_quarter), the root of an error, at the
same $\epsilon$.

| $\epsilon$ | growth per unit of slow time |
|---|---|
| $10^{-6}$ | [0.0179886 ± 2e-7](num:sec5_growth.growth_quarter_6) |
| $10^{-4}$ | [0.0533953 ± 4e-8](num:sec5_growth.growth_quarter_4) |
| $10^{-3}$ | [0.0809977 ± 2e-7](num:sec5_growth.growth_quarter_3) |
| $10^{-2}$ | [0.0731881 ± 2e-7](num:sec5_growth.growth_quarter_2) | */
/// The largest growth in the chain of four waves below pi/2 at four amplitudes.
double growth_below_quarter(std::size_t steps) {
  double most = 0;
  for (const ModulatedWave& wave : {ModulatedWave{32, 7, 0}, {16, 3, 0}, {8, 1, 0}, {12, 2, 0}})
    for (double eps : {1e-2, 1e-3, 1e-4, 1e-6})
      most = std::max(most, chain_rates(wave, eps, steps).growth);
  return most;
}

void report_marginal(Report& report) {
  const std::vector<ModulatedWave> waves{{8, 2, 4}, {39, 11, 0}};
  Table& table = report.table(
      "marginal_growth", {count("sites", "length of the ring", "site"),
                          number("q", "wavenumber", "1/site"), number("eps", "amplitude scale"),
                          estimate("growth", "largest growth rate on the ring, in the chain")});
  const std::vector<double> sizes{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
  table.fill(chain_points(waves, sizes), [](const ChainPoint& p) {
    return Cells{
        std::int64_t(p.wave.sites), p.wave.wave().q, p.eps,
        compare(chain_rates(p.wave, p.eps, 12).growth, chain_rates(p.wave, p.eps, 24).growth)};
  });

  // Growth at four amplitudes, and how it goes with the amplitude at the smallest ones
  const auto growth = table.numbers("growth"), error = table.numbers("growth_error");
  const auto at = [&](std::size_t k) { return Estimate{growth[k], error[k]}; };
  for (std::size_t k : {0u, 1u, 2u, 4u})
    report.facts.add("growth_quarter_" + std::to_string(k + 2), at(k));
  const auto order = [&](std::size_t first, std::size_t k) {
    return order_between(sizes[k - 1], at(first + k - 1), sizes[k], at(first + k));
  };
  report.facts.add("order_quarter", compare(order(0, 4), order(0, 5)));
  report.facts.add("order_fifth", compare(order(6, 4), order(6, 5)));
  report.facts.add("growth_on_39", in_two_precisions(waves[1].wave().q, [](const auto& w) {
                     return w.growth(2 * pi * 32 / 39);
                   }));
  report.facts.add("growth_below_quarter",
                   compare(growth_below_quarter(12), growth_below_quarter(24)));
}

/**
Runs show the same. The chain at $\epsilon = 10^{-3}$ starts from the field of the DpS equation with noise of
$10^{-4}$ on 32 sites. After 80 units of slow time the wave $q = \frac\pi2$ has kept
[0.0550](num:sec5_growth.share_left_quarter) of the norm and $q = \frac7{16}\pi$
[0.999571](num:sec5_growth.share_left_below); the third harmonic of the first is its own marginal modulation. */
/// By what a modulation Q = pi of the wave pi/2 grows in 400 units of slow time.
double side_band_400(double tolerance) {
  const ModulatedWave quarter{8, 2, 4};
  const double size = 1e-7, q = quarter.wave().q;
  Field field(quarter.sites);
  for (std::size_t n = 0; n < field.size(); ++n)
    field[n] = std::polar(1.0, q * double(n)) * std::complex<double>(1, n % 2 ? -size : size);
  evolve_dps(Dps{quarter.sites, Ends::periodic}, field, 400, 1, tolerance,
             [](double, const Field&) {});
  return std::sqrt(wave_share(field, q + pi)) / size;
}

void report_marginal_runs(Report& report) {
  report.facts.add("side_band_400", compare(side_band_400(1e-11), side_band_400(1e-13)));

  const unsigned long seeds = report.quick ? 2 : 8;
  std::vector<std::vector<double>> left(2, std::vector<double>(seeds));
  parallel_for("marginal waves", 2 * seeds, [&](std::size_t i) {
    Field field = noisy_wave(78, 22, 0.01, i % seeds + 1);
    evolve_dps(Dps{78, Ends::periodic}, field, 300, 1, i < seeds ? 1e-7 : 1e-8,
               [](double, const Field&) {});
    left[i / seeds][i % seeds] = wave_share(field, 2 * pi * 22 / 78);
  });
  report.facts.add("share_left_fifth", over_seeds(left));

  const auto in_chain = [](int waves, double step) {
    Field field = noisy_wave(32, waves, 1e-4, 1);
    evolve_in_chain(field, 1e-3, 80, 80, step, [](double, const Field&) {});
    return wave_share(field, 2 * pi * waves / 32);
  };
  report.facts.add("share_left_quarter", compare(in_chain(8, 0.2), in_chain(8, 0.1)));
  report.facts.add("share_left_below", compare(in_chain(7, 0.2), in_chain(7, 0.1)));
}

/**
## In the array

In the array of section 3.6 a wave with $q = \pi$ and an amplitude of one micrometre has its fastest growth among the
modulations of a ring of 62 sites, e-fold in [15.6](num:sec5_growth.periods_at_1um) periods of a beam (a ring of 54
gives the error), in the DpS equation in [14.0](num:sec5_growth.periods_at_1um_dps); both go nearly like $a^{-1/2}$. */
void report_array(Report& report) {
  const double eps = 1 / CantileverArray{}.scales().micrometres(1) / 2;
  const auto periods = [&](double growth) { return 1 / (growth * std::sqrt(eps) * 2 * pi); };
  const auto on_ring = [&](std::size_t sites) {
    const ModulatedWave wave{sites, int(sites) / 2, 0};
    return compare(periods(chain_rates(wave, eps, 12).growth),
                   periods(chain_rates(wave, eps, 24).growth));
  };
  report.facts.add("periods_at_1um", compare(on_ring(54), on_ring(62)));
  report.facts.add("periods_at_1um_dps", in_two_precisions(pi, [&](const auto& wave) {
                     return 1 / (wave.growth(wave.fastest()) * std::sqrt(eps) * 2 * pi);
                   }));
}

/**
## What is left

Eight waves with noise of one per cent (seeds 1 to 8) run for 600 units of slow time on rings of 64 sites; from $\tau =
100$ on we look for breathers that live for at least 25 units, about ten of their periods (leftovers.hpp). These runs
are chaotic. A tolerance ten times smaller gives other breathers, so only means are significant: their errors are the
standard error over the seeds and the difference of both tolerances.

Norm and energy are conserved. A field of independent normal amplitudes, the motion of infinite temperature, has the
energy $\frac25\,2^{5/4}\,\Gamma(\frac94) =$ [1.08](num:sec5_growth.random_energy) per site at norm one, on average and
on a long ring. A wave with more energy cannot relax to such a state, and its surplus is expected to localise. This is
the argument of Rasmussen, Cretegny, Kevrekidis and Grønbech-Jensen (Phys. Rev. Lett. 84, 3740, 2000) for the discrete
nonlinear Schrödinger equation. Waves pass that energy at $q =$ [1.68](num:sec5_growth.neutral_q), a little beyond
$\pi/2$, so that most unstable waves are above. On 64 sites fluctuations are large: the eight random fields that we run
beside the waves scatter by [0.1](num:sec5_growth.random_energy_scatter) in energy, and
[3](num:sec5_growth.random_with_surplus) of them have a surplus themselves. */
/// Energy per site at infinite temperature and norm one.
template <class T>
T random_energy() {
  return T(0.4L) * std::pow(T(2), T(1.25)) * std::tgamma(T(2.25));
}

/// The wavenumber of the wave that has as much, (2/5) (2 sin(q/2))^{5/2}.
template <class T>
T neutral_wavenumber() {
  return T(2) * std::asin(std::pow(random_energy<T>() / T(0.4L), T(0.4L)) / T(2));
}

// A breather is at rest if it stays within two sites for all of its life
void report_leftovers(Report& report) {
  const std::vector<int> waves{32, 24, 20, 18, 17, 0};
  const double duration = report.quick ? 240 : 600, watched = duration * 5 / 6, least = 25;
  const unsigned long seeds = report.quick ? 2 : 8;
  std::vector<Leftover> runs[2];
  for (int k = 0; k < 2; ++k)
    for (int w : waves)
      for (unsigned long seed = 1; seed <= seeds; ++seed) runs[k].push_back({w, seed});
  parallel_for("breathers", 2 * runs[0].size(), [&](std::size_t i) {
    const std::size_t k = i / runs[0].size();
    runs[k][i % runs[0].size()].run(duration, least, k == 0 ? 1e-7 : 1e-8);
  });
  report.output.note("seeds", "1 to " + std::to_string(seeds));

  // The breathers of the finer runs, one by one
  Table& table = report.table(
      "breathers",
      {number("q", "wavenumber q of the plane wave", "1/site"), count("seed", "seed of the noise"),
       number("born", "slow time of its birth"), number("lived", "lifetime in slow time"),
       number("norm", "norm on five sites"), number("energy", "contact energy of these sites"),
       number("static_energy", "energy of a static breather with this norm"),
       number("speed", "speed: slope of the path", "site per unit of slow time"),
       number("strayed", "range of the path, from the lowest position to the highest", "site")});
  for (const Leftover& r : runs[1])
    for (const BreatherTrack& b : r.found)
      table.add({2 * pi * r.waves / 64, std::int64_t(r.seed), b.born, b.lived, b.norm, b.energy,
                 static_energy(b.norm), b.speed, b.strayed});

  // Means of each wave: how many at a time, how they move, and their energy
  for (int w : waves) {
    const auto [number, rest, share, speed, size] = statistics_of(runs, w, watched);
    const std::string name = w > 0 ? "_" + std::to_string(w) : "_random";
    // One born in the last `least` units would not have been counted
    if (std::min(w, 20) < 20)
      report.facts.add("births_below" + name,
                       compare(rate_below(rest[0].size(), double(seeds) * watched),
                               rate_below(rest[1].size(), double(seeds) * (watched - least))));
    else
      report.facts.add("breathers_at_a_time" + name, over_seeds(number));
    if (std::min(rest[0].size(), rest[1].size()) < 3) continue;
    const auto share_below = [](const std::vector<double>& still) {
      return rate_below(std::size_t(std::count(still.begin(), still.end(), 1)),
                        double(still.size()));
    };
    report.facts.add("at_rest_below" + name, compare(share_below(rest[0]), share_below(rest[1])));
    report.facts.add("mean_speed" + name, over_seeds(speed), "site per unit of slow time");
    report.facts.add("mean_size_of_speed" + name, over_seeds(size), "site per unit of slow time");
    report.facts.add("energy_over_static" + name, over_seeds(share));
  }
}

/**
[](finding:growth.left) These are means over time and seeds; after $\frac{20}{32}\pi$ the mean is
[0.03](num:sec5_growth.breathers_at_a_time_20). The breathers after the first two waves have
[0.963](num:sec5_growth.energy_over_static_32) and [0.89](num:sec5_growth.energy_over_static_24) of the energy of static
ones. Of the fields that left none, $\frac{18}{32}\pi$ has a little surplus, and $\frac{17}{32}\pi$ is unstable but has
none; the bounds for the latter, [0.00079](num:sec5_growth.births_below_17), and for the random fields,
[0.00079](num:sec5_growth.births_below_random), are the same. They say no more than that births are rare: in runs of
30,000 units, made once, breathers were born in all three, more often where there was a surplus.

Few are at rest, at 95 per cent fewer than [0.2](num:sec5_growth.at_rest_below_32) and
[0.1](num:sec5_growth.at_rest_below_24) of those after the first two waves: they travel, and collisions or waves reverse
them. After $q = \pi$ they go both ways: their mean velocity is [0.06](num:sec5_growth.mean_speed_32), the mean of its
modulus [0.16](num:sec5_growth.mean_size_of_speed_32). After $q = \frac34\pi$ they go with the energy of the wave, at
[-0.28](num:sec5_growth.mean_speed_24) on average, more slowly than its group velocity
[-0.778](num:sec5_growth.group_velocity_24). Static breathers, which the article hopes for, are the exception in these
runs, and of the waves tried $q = \pi$ leaves the most. */
void report_energies(Report& report) {
  report.facts.add("random_energy",
                   compare(random_energy<double>(), double(random_energy<long double>())));
  report.facts.add("neutral_q",
                   compare(neutral_wavenumber<double>(), double(neutral_wavenumber<long double>())),
                   "1/site");
  const unsigned long seeds = report.quick ? 2 : 8;
  const RandomEnergies fields = random_energies(seeds, random_energy<double>());
  report.facts.add("random_energy_scatter", fields.scatter);
  report.facts.add("random_with_surplus", exact(fields.above));
  report.facts.add(
      "group_velocity_24",
      in_two_precisions(0.75 * pi, [](const auto& wave) { return wave.group_velocity(); }),
      "site per unit of slow time");
}

/**
The second figure begins with the wave $q = \pi$ in the DpS equation and, from the same field, in the chain with
$\epsilon = 10^{-3}$. The chain makes its breathers elsewhere: its corrections exceed the noise of one per cent. */
void report_maps(Report& report) {
  const double duration = 160, eps = 1e-3;
  const std::size_t sites = 64, rows = report.quick ? 40 : 160;
  Table& table = report.table(
      "maps",
      {count("panel", "0: q = pi, DpS; 1: the same in the chain; 2: q = 3 pi / 4, DpS"),
       number("tau", "slow time"), count("n", "site", "site"), number("density", "|A_n|^2")});
  const auto row = [&](int panel, double tau, const Field& field) {
    for (std::size_t n = 0; n < sites; ++n)
      table.add({panel, tau, std::int64_t(n + 1), std::norm(field[n])});
  };
  const auto in_dps = [&](int panel, int waves) {
    Field field = noisy_wave(sites, waves, 0.01, 1);
    evolve_dps(Dps{sites, Ends::periodic}, field, duration, rows, 1e-8,
               [&](double tau, const Field& now) { row(panel, tau, now); });
  };
  in_dps(0, 32);
  Field field = noisy_wave(sites, 32, 0.01, 1);
  evolve_in_chain(field, eps, duration, duration / double(rows), 0.2,
                  [&](double tau, const Field& now) { row(1, tau, now); });
  in_dps(2, 24);
}

/**
## Differences and limits

The growth has four routes: the closed form, the matrix of a ring, runs of the DpS equation, and the linearised chain
with a run of it. Of the study that the article proposes, this covers plane waves in linear wells without losses.
Spectral stability is not stability for ever: in a run made once, on 64 sites with noise of one per cent, the wave $q =
\frac{15}{32}\pi$ of the DpS equation lost more than half of its norm within 4000 units. The energy of a random field
says where a surplus is, not how fast it gathers, nor whether a breather is left in the end. */
void reproduce(Report& report) {
  report_chart(report);
  report_fastest(report);
  report_checks(report);
  report_chain(report);
  report_runs(report);
  report_marginal(report);
  report_marginal_runs(report);
  report_array(report);
  report_leftovers(report);
  report_energies(report);
  report_maps(report);
}

/**
## Try it

1. *Easy.* A wave of four times the amplitude: how fast does its fastest modulation grow?
   `build/bin/sec5_growth growth --amplitude 4` gives `fastest_growth` = 0.747349.
   Hint: the rate $\rho$ goes like $|A|^{1/2}$. Does the band move, too?
2. *Easy.* Which modulations of the wave $q = 1.7$ grow, the short or the long ones?
   `build/bin/sec5_growth growth --q 1.7 --modulation 3.1` gives `edge` = 1.95315.
   Hint: is $\cos q$ above or below $-\frac15$? Compare the growth on either side of the edge.
3. *Harder.* Do long modulations grow in proportion to $Q$?
   `build/bin/sec5_growth growth --modulation 0.02` gives `growth` = 0.0129423.
   Hint: halve $Q$, then the amplitude. Where dispersion does not depend on it, the edge $Q_*$ is proportional to it.
4. *Open.* Do standing waves, $\cos qn$, have a band of instability in closed form?
5. *Open.* With the losses of an experiment (the chapter on damping), which breathers are left when the waves are gone?
   */
int main(int argc, char** argv) {
  return run({"sec5_growth", "5", "Modulational instability without precompression (section 5)",
              reproduce, commands<OnePlaneWave>()},
             argc, argv);
}
