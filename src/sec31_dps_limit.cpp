/**
# 3.1 The discrete p-Schrödinger (DpS) equation and its error

How accurate is the envelope equation of the chain at small amplitude? Section 3.1 of James, Kevrekidis and Cuevas
(Physica D 251, 2013) recalls the discrete p-Schrödinger (DpS) equation and quotes a theorem: at amplitude $\epsilon$ it
is $O(\epsilon^{3/2})$-close to the chain, at least up to times $O(\epsilon^{-1/2})$. We integrate both equations side
by side over three decades of amplitude. The power 3/2 is found to 0.1 per cent, but only in the limit: at amplitudes
above $10^{-3}$ the local exponent is still below 1.48, and the relative error up to $\tau = 10$, in the limit
[3.32](cell:limits/start=0/tau=10/coefficient) times $\epsilon^{1/2}$ for an impact and [9.44](cell:start=1/coefficient)
times for a pair, is not small. Wells of other shapes do not change the equation, and its plane waves of 2, 3 and 4
sites are $O(\epsilon^{3/2})$-close to exact travelling waves of the chain.

![Relative error divided by the square root of the amplitude. Drawn by x02_dps_error.gp: `coefficient` of the table
`dps_error` against `eps`.](fig:x02)

<!-- head -->
`build/bin/sec31_dps_limit` computes this chapter in 4 s on two cores and writes 5 tables to
`build/data/sec31_dps_limit`. Its figures: `make x02`. With your parameters: `impact`, impact in the DpS equation: the
packet, and the norm left at the struck end.
<!-- /head --> */

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "commands/dps_strike.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec3/travelling_wave.hpp"

using namespace lattice;

/**
## From the chain to the envelope

All quantities are dimensionless, and both ends are free. The chain, Eq. (9), and the approximation, Eq. (13), are
$$\ddot y_n + y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  y_n = \epsilon\,[A_n(\tau)\,e^{it} + c.c.],\quad \tau = \epsilon^{1/2}t.$$
Insert the second into the first. On the left, $\ddot y_n + y_n = 2i\epsilon^{3/2}\dot A_n e^{it} + c.c. +
O(\epsilon^2)$, where $\dot A_n = dA_n/d\tau$. On the right, with $A_n - A_{n+1} = |B|e^{i\theta}$, the overlap of two
beads is $2\epsilon|B|\cos(t+\theta)$. The contact is closed during half of the period, and its force
$\epsilon^{3/2}|B|^{3/2}[2\cos(t+\theta)]_+^{3/2}$ has a Fourier series in $t+\theta$. The harmonic $e^{it}$ is in
resonance with the wells, so its coefficient must balance the left-hand side. It is
$\epsilon^{3/2}|B|^{1/2}B/\tau_0$ with
$$\frac1{\tau_0} = \frac1{2\pi}\int_{-\pi/2}^{\pi/2} (2\cos t)^{3/2}\cos t\,dt,\qquad
  \tau_0 = \frac{5\,\Gamma(\frac14)^2}{24\sqrt\pi},$$
and the balance is the DpS equation (12) (`Dps` in lattice/model/dps.hpp),
$$2i\tau_0\dot A_n = (A_{n+1}-A_n)|A_{n+1}-A_n|^{1/2} - (A_n-A_{n-1})|A_n-A_{n-1}|^{1/2}.$$

Two things are left out, and both are of order $\epsilon^{3/2}$. The mean of the contact force and its other harmonics
move a bead by $O(\epsilon^{3/2})$ within one period. Resonant terms of order $\epsilon^2$, summed over a time
$\epsilon^{-1/2}$, change its amplitude by $O(\epsilon^{3/2})$. The next terms are smaller by $\epsilon^{1/2}$. For
contacts of the exponent $\alpha$ write $\epsilon^{\alpha-1}$ for $\epsilon^{1/2}$ and $\epsilon^\alpha$ for
$\epsilon^{3/2}$, and $\alpha$ for the power 3/2 of the force and in the integral of $\tau_0$.

At the amplitudes that we choose, $\tau = 1$ is a whole number of periods of the wells, so that each horizon (final
time) ends every run at the same phase. */
constexpr double alpha = 1.5;                  // exponent of the contacts, 3/2 for spheres
constexpr std::size_t sites = 32;              // so many that the far end stays at rest
const std::vector<double> horizons{1, 4, 10};  // slow times up to which the largest error is taken
const std::vector<int> periods{2, 4, 8, 16, 32, 64};  // of the wells in tau = 1
constexpr double wave_eps[] = {1e-6, 1e-7};           // amplitudes of the travelling waves
struct Resolution {
  int steps;         // of the chain in a period, each of them a sample
  double tolerance;  // of GSL
};
constexpr Resolution coarse{40, 1e-9}, fine{120, 1e-11};

/// x^(alpha-1) for x >= 0, a square root for spheres.
double root(double x) {
  return secant_stiffness(x, alpha);
}

/// The amplitude at which tau = 1 is `count` periods of the wells.
double amplitude(int count) {
  return std::pow(2 * std::numbers::pi * count, 1 / (1 - alpha));
}

/**
## Both equations, side by side

The theorem speaks of every start within $O(\epsilon^{3/2})$ of Eq. (13) and of every horizon of order
$\epsilon^{-1/2}$; we take three starts and three horizons. One start is an `impact` on the first bead, Eq. (25),
another a `pair` of neighbours that move towards each other. In the third the chain of the pair is displaced by a
further $\epsilon^{3/2}$, which the theorem allows. The largest deviation lies between samples, where a parabola finds
it. */
struct Start {
  Field A;
  double shift = 0;   // in units of eps^alpha: added to displacements, subtracted from velocities
  double factor = 1;  // of tau_0, to see what a wrong one does
};

Field pair() {
  Field A(sites);
  A[sites / 2 - 1] = 1;
  A[sites / 2] = -1;
  return A;
}

const std::vector<Start> starts{{dps_impact(sites)}, {pair()}, {.A = pair(), .shift = 1}};

struct Deviation {
  double size = 0, tau = 0;
};

/// The largest |y_app - y_n| of any bead, up to each of the horizons `until`; the last is the longest.
std::vector<Deviation> deviations(const Start& start, const Well& well, double eps,
                                  const std::vector<double>& until, const Resolution& resolution) {
  // Eq. (13) and its derivative at t = 0, and what is added where it moves
  const Contact power = PowerContact{.exponent = alpha};
  const Chain chain{sites, well, simplest(power)};  // for spheres the faster `Hertz`
  State<double> state = dps_state(start.A, eps, 0);
  std::vector<double> a(2 * sites), before(sites), here(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    a[2 * n] = start.A[n].real();
    a[2 * n + 1] = start.A[n].imag();
    if (start.A[n] == 0.0) continue;
    state.y[n] += start.shift * eps * root(eps);
    state.v[n] -= start.shift * eps * root(eps);
  }

  // The chain takes event-corrected steps; after each of them GSL brings the DpS equation to the same time
  const Dps equation{sites, Ends::free, alpha, 1 / (2 * start.factor * tau_0(alpha))};
  Reference dps(equation, 2 * sites, resolution.tolerance);
  std::vector<Deviation> largest(until.size());
  double tau = 0;
  const auto observe = [&](const State<double>& now) {
    if (now.t > 0) dps.advance(tau, root(eps) * now.t, a);
    for (std::size_t n = 0; n < sites; ++n) {
      const std::complex<double> A(a[2 * n], a[2 * n + 1]);
      const double next = 2 * eps * (A * std::polar(1.0, now.t)).real() - now.y[n];
      const Parabola parabola(before[n], here[n], next);
      const bool between = now.t > 0 && std::abs(parabola.vertex()) < 0.5;
      const double size = std::max(std::abs(next), between ? std::abs(parabola.extremum()) : 0);
      for (std::size_t k = 0; k < until.size(); ++k)
        if (tau <= until[k] * (1 + 1e-12) && size > largest[k].size) largest[k] = {size, tau};
      before[n] = here[n];
      here[n] = next;
    }
    // Contacts exert no force below an overlap of 1e-60, so that a bead ahead of the motion is exactly at rest
    if (now.y.back() != 0) throw Failure("the motion has reached the far end");
  };
  const double step = 2 * std::numbers::pi / resolution.steps;
  evolve(EventCorrected{.step = step}, chain, state, until.back() / root(eps), step, observe);
  return largest;
}

/**
Integration and interpolation have errors, too. So every run is made twice, with steps and samples of a third and a
hundredth of the tolerance. Two maxima may agree by chance; therefore the largest relative difference on a curve is the
error of all its points.  */
struct Curve {
  std::vector<Estimate> coefficient;  // deviation over 2 eps^(3/2), for each amplitude
  std::vector<double> tau;            // when it was found
};

/// The curves of all horizons.
std::vector<Curve> curves(const Start& start, const Well& well, const std::vector<int>& counts,
                          const std::vector<double>& until) {
  // Both resolutions of all amplitudes, the longest runs first
  std::vector<std::vector<Deviation>> runs(2 * counts.size());
  parallel_for(runs.size(), [&](std::size_t i) {
    const std::size_t run = runs.size() - 1 - i;
    runs[run] = deviations(start, well, amplitude(counts[run / 2]), until, run % 2 ? fine : coarse);
  });
  std::vector<Curve> out(until.size());
  for (std::size_t k = 0; k < until.size(); ++k) {
    double error = 0;
    for (std::size_t i = 0; i < runs.size(); i += 2)
      error = std::max(error, std::abs(runs[i][k].size / runs[i + 1][k].size - 1));
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double eps = amplitude(counts[i]);
      const double value = runs[2 * i + 1][k].size / (2 * eps * root(eps));
      out[k].coefficient.push_back({value, value * error});
      out[k].tau.push_back(runs[2 * i + 1][k].tau);
    }
  }
  return out;
}

/// The local orders of the error between neighbouring amplitudes.
std::vector<Estimate> local_orders(const Curve& curve, const std::vector<int>& counts) {
  std::vector<Estimate> out;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    const Estimate slope = order_between(amplitude(counts[i - 1]), curve.coefficient[i - 1],
                                         amplitude(counts[i]), curve.coefficient[i]);
    out.push_back({alpha + slope.value, slope.error});
  }
  return out;
}

/// The limit of values whose distance from it is halved from each to the next.
Estimate limit(const std::vector<Estimate>& values) {
  const auto from = [&](std::size_t last) {
    const Estimate &a = values[last - 1], &b = values[last];
    return Estimate{2 * b.value - a.value, 2 * b.error + a.error};
  };
  return compare(from(values.size() - 2), from(values.size() - 1));
}
const char* const from_both = "from the errors of both points";

/**
## The error and its order (figure x02)

The motion has the size $2\epsilon$, so the deviation over $2\epsilon^{3/2}$, the *coefficient*, times $\epsilon^{1/2}$
is the relative error: at $\epsilon = 10^{-4}$ and up to $\tau = 10$ it is 3 per cent after the impact and 9 per cent
for the pair. Drawn against $\epsilon^{1/2}$, the ratio of the next terms to those that are left out, the coefficient
tends to a limit, in the end along a straight line: a finite limit is the power 3/2, and the slope is the correction.

The local order is the slope between neighbouring amplitudes on logarithmic axes. From one to the next the distance from
its limit is halved, so twice the last value less the one before is the limit. Its change from the same one amplitude
earlier, plus the errors of the deviations, is the error.

| up to $\tau =$ | 1 | 4 | 10 |
|---|---|---|---|
| impact, local order at the largest $\epsilon$ | [1.408](cell:limits/start=0/tau=1/first) | [1.425](cell:tau=4/first) | [1.414](cell:tau=10/first) |
| impact, limit of the order | [1.50](cell:limits/start=0/tau=1/order) | [1.50](cell:tau=4/order) | [1.500](cell:tau=10/order) |
| pair, limit of the order | [1.50](cell:limits/start=1/tau=1/order) | [1.500](cell:tau=4/order) | [1.500](cell:tau=10/order) |
| impact, limit of the coefficient | [1.07](cell:limits/start=0/tau=1/coefficient) | [1.51](cell:tau=4/coefficient) | [3.32](cell:tau=10/coefficient) |
| pair, limit of the coefficient | [2.25](cell:limits/start=1/tau=1/coefficient) | [3.51](cell:tau=4/coefficient) | [9.44](cell:tau=10/coefficient) |

After the impact the first contact prevails up to $\tau = 1$: the largest deviation occurs within the first half of a
period (`at` in `dps_error`). From $\tau = 4$ on it is the accumulated error, found at the end of the run. The nine
limits agree: the order is [1.50](statement:dps.error_order), their mean, where the article has 3/2; its error reaches
to the farthest limit and its error. */
void report_errors(Report& report) {
  std::vector<int> counts = periods;
  if (report.quick) counts.pop_back();
  const char *which = "initial condition, 0: impact, 1: pair, 2: pair displaced by eps^(3/2)",
             *until = "slow time up to which the largest error is taken",
             *limited = "change from one amplitude earlier, and the errors of the deviations";
  Table &errors = report.table("dps_error"), &limits = report.table("limits");
  for (std::size_t start = 0; start < starts.size(); ++start) {
    const std::vector<Curve> all = curves(starts[start], Harmonic{}, counts, horizons);
    for (std::size_t k = 0; k < horizons.size(); ++k) {
      for (std::size_t i = 0; i < counts.size(); ++i)
        errors.add(
            {{"start", which, start},
             {"tau", until, horizons[k]},
             {"eps", "amplitude scale epsilon of the motion", amplitude(counts[i])},
             {"coefficient", "largest difference of chain and approximation over 2 eps^(3/2)",
              all[k].coefficient[i], "",
              "largest relative difference of two resolutions on the curve"},
             {"at", "the slow time at which it is found", all[k].tau[i]}});
      const std::vector<Estimate> order = local_orders(all[k], counts);
      limits.add(
          {{"start", which, start},
           {"tau", until, horizons[k]},
           {"first", "local order between the two largest amplitudes", order[0], "", from_both},
           {"order", "limit of the local order", limit(order), "", limited},
           {"coefficient", "limit of the deviation over 2 eps^(3/2)", limit(all[k].coefficient), "",
            limited}});
    }
  }
}

/**
## The time constant

The article prints $\tau_0 =$ [1.545](statement:dps.tau0), the closed form. The integral, by the trapezoidal rule, is
the check. */
double tau_0_by_quadrature() {
  const int points = 20000;
  double sum = 0;
  for (int k = 1 - points / 2; k < points / 2; ++k) {
    const double c = std::cos(std::numbers::pi * k / points);
    sum += 2 * c * root(2 * c) * c;
  }
  return 2 * points / sum;  // 2 pi over the integral, whose step is pi / points
}

/**
## Wells of other shapes

To first order a force $y^2$ has no component at the frequency of the well; it shifts the beads and adds a second
harmonic, both $O(\epsilon^2)$. Its second order, like the first order of $y^3$, changes the frequency by
$O(\epsilon^2)$, hence the displacements by $O(\epsilon^{5/2})$ in the time $\epsilon^{-1/2}$. So the order should be
the same in hard wells, $s = 1$ in Eq. (10), and with a quadratic force, which that equation does not have. As a
control, $\tau_0$ is made 3 per cent too large: the order of the error falls below one.

| local order at $\epsilon = 4.9\cdot10^{-5}$, up to $\tau = 4$ | impact | pair |
|---|---|---|
| harmonic wells | [1.490](cell:other_wells/well=harmonic/start=0/order) | [1.495](cell:start=1/order) |
| hard wells, $s = 1$ | [1.489](cell:other_wells/well=hard/start=0/order) | [1.495](cell:start=1/order) |
| force $-y-y^2$ | [1.494](cell:other_wells/well=asymmetric/start=0/order) | [1.497](cell:start=1/order) |
| harmonic wells, wrong $\tau_0$ | [0.910](cell:other_wells/well=wrong_tau_0/start=0/order) | [0.849](cell:start=1/order) | */
struct Asymmetric {
  double energy(double y) const { return y * y / 2 + y * y * y / 3; }
  double force(double y) const { return -(y + y * y); }
  double stiffness(double y) const { return 1 + 2 * y; }
};

void report_wells(Report& report) {
  struct Other {
    const char* name;
    Well well;
    double factor;  // of tau_0
  };
  const Other others[] = {{"harmonic", Harmonic{}, 1},
                          {"hard", Quartic{1}, 1},
                          {"asymmetric", Asymmetric{}, 1},
                          {"wrong_tau_0", Harmonic{}, 1.03}};
  const auto last = periods.end() - (report.quick ? 2 : 1);
  const std::vector<int> counts(last - 2, last);
  Table& table = report.table("other_wells");
  for (const Other& other : others)
    for (const std::size_t index : {0U, 1U}) {
      Start start = starts[index];
      start.factor = other.factor;
      table.add(
          {{"well", "harmonic; hard, s = 1; asymmetric, of the force -y - y^2", other.name},
           {"start", "initial condition, 0: impact, 1: pair", index},
           {"order", "local order of the error in eps, up to tau = 4",
            local_orders(curves(start, other.well, counts, {4})[0], counts)[0], "", from_both}});
    }
}

/**
## Periodic travelling waves

The DpS equation has the plane waves $A_n = e^{i(qn-\Omega\tau)}$ with $-2\tau_0\Omega = (2\sin\frac q2)^{5/2}$. By
Eq. (13) they represent $y_n = 2\epsilon\cos(qn+\omega t)$ with $\omega = 1-\epsilon^{1/2}\Omega$. An exact wave is
$y_n(t) = \epsilon u(qn+\omega t)$, where $u$ has the period $2\pi$ and
$$\omega^2u'' + u = \epsilon^{1/2}\bigl[(u(\varphi-q)-u(\varphi))_+^{3/2} - (u(\varphi)-u(\varphi+q))_+^{3/2}\bigr].$$
The right-hand side is small, so its Fourier series is found by iteration, with 48 harmonics and, for the error, 24
(src/sec3/travelling_wave.cpp).

The article does not say what the two waves share. At *equal frequency* their distance is the same at all times. At
*equal amplitude*, that of the first harmonic, they drift apart, by a phase of order $\epsilon^{1/2}$ up to
$t = \epsilon^{-1/2}$, where we compare them. The orders are those between $\epsilon = 10^{-6}$ and $10^{-7}$.

| wavelength, sites | article | 2 | 3 | 4 |
|---|---|---|---|---|
| order | 3/2 | [1.500](cell:travelling_waves/wavelength=2/order) | [1.500](cell:wavelength=3/order) | [1.499](cell:wavelength=4/order) |
| order at equal amplitude | 3/2 | [1.499](cell:travelling_waves/wavelength=2/order_amplitude) | [1.500](cell:wavelength=3/order_amplitude) | [1.500](cell:wavelength=4/order_amplitude) | */
void report_waves(Report& report) {
  Table& table = report.table("travelling_waves");
  for (const std::size_t wavelength : {2U, 3U, 4U}) {
    const auto large = wave_distances(wavelength, wave_eps[0], alpha),
               small = wave_distances(wavelength, wave_eps[1], alpha);
    const auto order = [](const Estimate& a, const Estimate& b) {
      return order_between(wave_eps[0], a, wave_eps[1], b);
    };
    table.add(
        {{"wavelength", "wavelength", wavelength, "site"},
         {"order", "order in eps of the largest distance, equal frequency",
          order(large.largest, small.largest), "", from_both},
         {"order_amplitude", "the same at equal amplitude, of the largest up to t = eps^(-1/2)",
          order(large.at_equal_amplitude, small.at_equal_amplitude), "", from_both}});
  }
}

/**
About times much longer than $\epsilon^{-1/2}$ the theorem says nothing; `sec34_dps_impact` compares both equations at
$\tau = 250$. */
void reproduce(Report& report) {
  report.output.note("tolerance",
                     "GSL " + short_text(coarse.tolerance) + " and " + short_text(fine.tolerance));
  report
      .table("time_constant", {estimate("tau_0", "constant of the DpS equation", "",
                                        "difference of integral and closed form")})
      .add({compare(tau_0_by_quadrature(), tau_0(alpha))});
  report_errors(report);
  report_wells(report);
  report_waves(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.tau0`: tau_0 = 5 Gamma(1/4)^2 / (24 sqrt(pi)) | 1.545 | 1.545 | reproduced |
| `dps.error_order`: order in eps of the sup error of the DpS approximation up to t = O(eps^-1/2) | 1.5 | 1.50 | reproduced |
| `dps.travelling_close`: the ansatz is O(epsilon^(3/2))-close to exact small amplitude periodic travelling waves | 1.5 | 1.500 | reproduced, assuming |
| `dps.wells_drop_out`: smooth on-site nonlinear terms (s y^3 and a quadratic force too) leave the DpS equation unchanged | unchanged | other_wells.order (well = hard, start = 0) away from 1.5: 0.0106 < 0.03 (the closest of 4) | holds |
<!-- /statements -->

## Try it

**To change it.** The constants after the derivation are the parameters, another start is one more entry of `starts`,
another well a struct like `Asymmetric` in the list `others`. With `alpha = 1.75` the limits of the order should be
1.75.

1. *Easy.* Does a packet of the chain move as the DpS equation says?
   `build/bin/sec34_impact run --velocity 0.01 --time 1000` gives `speed` = 0.02531. Hint: an impact of velocity $v_0$
   has $\epsilon = v_0/2$; `sec31_dps_limit impact --tau 70.7` prints the speed in sites per $\tau$.
2. *Harder.* What replaces the DpS equation for contacts of another exponent, and how fast are its packets?
   `build/bin/sec31_dps_limit impact --tau 100 --alpha 2` gives `speed` = 0.4059. Hint: $|A|^{1/2}$ becomes
   $|A|^{\alpha-1}$, the slow time $\epsilon^{\alpha-1}t$. */
int main(int argc, char** argv) {
  return run({"sec31_dps_limit", "3.1", "The DpS equation and its error (section 3.1)", reproduce,
              commands<DpsStrike>()},
             argc, argv);
}
