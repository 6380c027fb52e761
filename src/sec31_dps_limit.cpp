/**
# 3.1 The discrete p-Schrödinger (DpS) equation and its error

How accurate is the envelope equation of the chain at small amplitude? We integrate the chain and this discrete
p-Schrödinger (DpS) equation side by side, compute its one constant in two ways, and measure the error over four decades
of amplitude.

At small amplitude the beads oscillate almost at the frequency of their wells, and the contacts change amplitudes and
phases slowly. Section 3.1 of James, Kevrekidis and Cuevas (Physica D 251, 2013) recalls the equation of this slow
envelope and quotes a theorem: at amplitude $\epsilon$ it is $O(\epsilon^{3/2})$-close to the chain, at least up to
times $O(\epsilon^{-1/2})$. Wells of other shapes leave the equation unchanged, and some of its travelling waves are as
close to exact ones.

![Error of the approximation against its size, and the local order. Drawn by x02_dps_error.gp: `error` and `line` of
the table `dps_error` against `eps`, and `order` of `dps_order`.](fig:x02) */

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "commands/dps_strike.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"

using namespace lattice;
using Complex = std::complex<double>;

/**
## Both equations, side by side

All quantities are dimensionless, and both ends are free. In Eq. (9) each term on the left is $O(\epsilon)$, and the
contact forces on the right are $O(\epsilon^{3/2})$. So a bead oscillates at the frequency 1 of its well, and its
complex amplitude $A_n$ drifts in the slow time $\tau = \epsilon^{1/2}t$. The approximation is Eq. (13), with $A_n$ from
the DpS equation (12), where the dot is $d/d\tau$:
$$\ddot y_n + y_n = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},\qquad
  y_n^{app}(t) = 2\epsilon\,\mathrm{Re}\,[A_n(\epsilon^{1/2}t)\,e^{it}],$$
$$2i\tau_0\dot A_n = (A_{n+1}-A_n)|A_{n+1}-A_n|^{1/2} - (A_n-A_{n-1})|A_n-A_{n-1}|^{1/2}.$$

Both start from the same $A_n(0)$, the chain with what a start adds of order $\epsilon^{3/2}$ (`Start`). The chain takes
steps of at most 0.1 and treats the opening and closing of contacts (event_corrected.hpp). GSL's adaptive method of
order eight integrates the DpS equation, and, as an independent check, the chain once more. We compare at least every
0.2 units of time and record the largest deviation of any bead. */
struct Start {
  std::vector<Complex> A;
  double off = 0;  // added in units of eps^(3/2): to displacements, and subtracted from velocities
};

void chain_equation(const Chain& chain, const double* y, double* dy) {
  const double* v = y + chain.sites;  // the velocities follow the displacements
  double from_left = 0;
  for (std::size_t n = 0; n < chain.sites; ++n) {
    const double overlap = n + 1 < chain.sites ? y[n] - y[n + 1] : 0;
    const double to_right = overlap > 0 ? overlap * std::sqrt(overlap) : 0;
    dy[n] = v[n];
    dy[chain.sites + n] = chain.well.force(y[n]) + from_left - to_right;  // -y_n + ...
    from_left = to_right;
  }
}

void dps_equation(std::size_t sites, const double* a, double* da) {
  const auto A = [a](std::size_t n) { return Complex(a[2 * n], a[2 * n + 1]); };
  const double rate = 1 / (2 * tau_0());
  Complex from_left = 0;
  for (std::size_t n = 0; n < sites; ++n) {
    const Complex z = n + 1 < sites ? A(n + 1) - A(n) : 0;
    const Complex to_right = std::sqrt(std::sqrt(std::norm(z))) * z;  // |z|^(1/2) z
    da[2 * n] = rate * (to_right - from_left).imag();  // dA/dtau, after division by i
    da[2 * n + 1] = -rate * (to_right - from_left).real();
    from_left = to_right;
  }
}

/// The largest |y_app - y| of any bead up to each of the slow times `horizons`, of which the last is the longest.
std::vector<double> deviations(const Start& start, const Well& well, double eps,
                               const std::vector<double>& horizons, int halvings,
                               double tolerance) {
  // The start: Eq. (13) at t = 0, and what is added where it moves
  const auto& A = start.A;
  const std::size_t sites = A.size();
  const Chain chain{sites, well};
  State<double> state(sites);
  std::vector<double> a(2 * sites), y(2 * sites), largest(horizons.size());
  for (std::size_t n = 0; n < sites; ++n) {
    a[2 * n] = A[n].real(), a[2 * n + 1] = A[n].imag();
    const double more = std::abs(A[n]) > 0 ? start.off * eps * std::sqrt(eps) : 0;
    y[n] = state.y[n] = 2 * eps * A[n].real() + more;
    y[sites + n] = state.v[n] = -2 * eps * A[n].imag() - more;
  }
  // Two integrators of GSL, one for either equation
  Reference dps([=](double, const double* x, double* dx) { dps_equation(sites, x, dx); }, 2 * sites,
                tolerance);
  Reference gsl([&](double, const double* x, double* dx) { chain_equation(chain, x, dx); },
                2 * sites, {tolerance * eps, tolerance, gsl_odeiv2_step_rk8pd});
  // The observation: both are integrated to the time of each sample of the chain
  double tau = 0, t = 0, apart = 0;
  const auto look = [&](const State<double>& now) {
    if (now.t == 0) return;
    dps.advance(tau, std::sqrt(eps) * now.t, a);
    if (halvings == 0) gsl.advance(t, now.t, y);  // one of the two runs is enough for this check
    for (std::size_t n = 0; n < sites; ++n) {
      const Complex A_n(a[2 * n], a[2 * n + 1]);
      const double y_app = 2 * eps * (A_n * std::polar(1.0, now.t)).real();
      for (std::size_t k = 0; k < horizons.size(); ++k)
        if (tau <= horizons[k] * (1 + 1e-12))  // but for rounding
          largest[k] = std::max(largest[k], std::abs(y_app - now.y[n]));
      if (halvings == 0) apart = std::max(apart, std::abs(y[n] - now.y[n]));
    }
    // An overlap up to 1e-60 exerts no force (contact.hpp), so distant beads are exactly at rest
    if (now.y.back() != 0) throw Failure("the motion has reached the far end");
  };
  // The run
  const EventCorrected method{.step = 0.1, .halvings = halvings};
  evolve(method, chain, state, horizons.back() / std::sqrt(eps), denser(0.2), look);
  if (!(apart < 1e-3 * largest.back())) throw Failure("two integrators of the chain disagree");
  return largest;
}

/**
Three other errors could be mistaken for that of the approximation: those of the two integrations, and that of a maximum
over samples. So every deviation is computed twice, the second time with half the step, twice the samples and a
hundredth of the tolerance. The difference is the error in the tables. */
constexpr double tolerances[] = {1e-9, 1e-11};

std::vector<Estimate> deviations_with_errors(const Start& start, const Well& well, double eps,
                                             const std::vector<double>& horizons) {
  const auto coarse = deviations(start, well, eps, horizons, 0, tolerances[0]);
  const auto fine = deviations(start, well, eps, horizons, 1, tolerances[1]);
  std::vector<Estimate> out;
  for (std::size_t k = 0; k < fine.size(); ++k) out.push_back(compare(coarse[k], fine[k]));
  return out;
}

/**
## The time constant

Where does $\tau_0$ come from? Two neighbours with the amplitude difference $B = |B|e^{i\theta}$ have the relative
displacement $2|B|\cos(t+\theta)$ in units of $\epsilon$. Their contact is closed during one half of the period only,
and its force is the power 3/2 of this number. Only the Fourier component of that force at the frequency of the well has
a lasting effect. Its coefficient is $|B|^{1/2}B/\tau_0$ with
$$\frac1{\tau_0} = \frac1{2\pi}\int_{-\pi/2}^{\pi/2} (2\cos t)^{3/2}\cos t\,dt.$$
The article prints the closed form $\tau_0 = 5\,\Gamma(\frac14)^2/(24\sqrt\pi)$. We evaluate that form, and the integral
itself with GSL's adaptive quadrature, which copes with the fractional powers at the two ends. The difference is the
error: $\tau_0 =$ [1.545](statement:dps.tau0). */
double tau_0_by_quadrature() {
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(200);
  gsl_function push{[](double t, void*) {
                      const double r = 2 * std::max(0.0, std::cos(t));
                      return r * std::sqrt(r) * std::cos(t);
                    },
                    nullptr};
  const double half = std::numbers::pi / 2;
  double integral = 0, error = 0;
  gsl_set_error_handler_off();
  const int status =
      gsl_integration_qags(&push, -half, half, 0, 1e-13, 200, workspace, &integral, &error);
  gsl_integration_workspace_free(workspace);
  if (status) throw Failure(std::string("the integral for tau_0: ") + gsl_strerror(status));
  return 2 * std::numbers::pi / integral;
}

/**
## The error and its order (figure x02)

The theorem speaks of every initial condition within $O(\epsilon^{3/2})$ of Eq. (13) and of every horizon (final time)
of order $\epsilon^{-1/2}$; we sample them. The starts are localized: an `impact` on the first bead, $A_1 = -i$, and a
`pair` of neighbours in the middle that are pushed together and released, $A_{16} = 1$ and $A_{17} = -1$. A third one is
the pair with each of its displacements and velocities off by $\epsilon^{3/2}$. The horizons are $\tau = 1$, 4 and 10.
On 32 sites nothing reaches the far end within these times. */
const std::vector<double> horizons{1, 4, 10};
enum { impact, pair, pair_off };

Start start_of(std::size_t which) {
  Start start{std::vector<Complex>(32), which == pair_off ? 1. : 0.};
  if (which == impact)
    start.A[0] = Complex(0, -1);
  else
    start.A[15] = 1, start.A[16] = -1;
  return start;
}

struct Point {
  double eps;
  std::vector<Estimate> error{};
};
using Points = std::vector<std::vector<Point>>;  // of all starts, the largest eps first

Points measure_errors(std::size_t decades) {
  const std::size_t sizes = 2 * decades + 1;
  Points points{std::vector<Point>(sizes), std::vector<Point>(sizes), std::vector<Point>(2)};
  const std::size_t runs = 2 * sizes + 2;  // of the third start only the two smallest sizes
  parallel_for("error of the approximation", runs, [&](std::size_t i) {
    const std::size_t start = 2 - (i < 2 ? 0 : 1 + (i - 2) / sizes);  // the longest runs first
    const std::size_t k = i < 2 ? 1 - i : sizes - 1 - (i - 2) % sizes;
    const double eps = std::pow(10, -2 - double(i < 2 ? sizes - 2 + k : k) / 2);
    points[start][k] = {eps, deviations_with_errors(start_of(start), Harmonic{}, eps, horizons)};
  });
  return points;
}

/**
The local order is the slope between two neighbouring sizes in the doubly logarithmic plot. The next term of the
expansion is smaller only by a factor $\epsilon^{1/2}$, so the local order approaches 3/2 slowly, and a fit over all
sizes would mix the asymptotic law with its corrections. At sizes that a simulation would use the order is lower. Our
result is the mean order between the two smallest sizes, over the three starts and the three horizons; its error is the
largest departure of any of the nine, the error of that one included.

| local order, up to $\tau =$ | 1 | 4 | 10 |
|---|---|---|---|
| impact, $\epsilon$ from $10^{-2}$ to $10^{-2.5}$ | [1.38](cell:dps_order/start=0/tau=1/eps=5.623413252e-3/order) | [1.378](cell:tau=4/order) | [1.40](cell:tau=10/order) |
| impact, $\epsilon$ from $10^{-5.5}$ to $10^{-6}$ | [1.498](cell:dps_order/start=0/tau=1/eps=1.778279410e-6/order) | [1.499](cell:tau=4/order) | [1.50](cell:tau=10/order) |
| pair, $\epsilon$ from $10^{-2}$ to $10^{-2.5}$ | [1.49](cell:dps_order/start=1/tau=1/eps=5.623413252e-3/order) | [1.44](cell:tau=4/order) | [1.376](cell:tau=10/order) |
| pair, $\epsilon$ from $10^{-5.5}$ to $10^{-6}$ | [1.496 ± 0.004](cell:dps_order/start=1/tau=1/eps=1.778279410e-6/order) | [1.50](cell:tau=4/order) | [1.50](cell:tau=10/order) |
| pair, off by $\epsilon^{3/2}$, the same | [1.500](cell:dps_order/start=2/tau=1/eps=1.778279410e-6/order) | [1.50](cell:tau=4/order) | [1.50](cell:tau=10/order) |

The mean is [1.498 ± 0.006](statement:dps.error_order), where the article has 3/2. The table `dps_error` has the
constants, too, the error over $\epsilon^{3/2}$. They grow with the horizon: after an impact from 1.5 to 2.1 up to
$\tau = 1$, from 4.9 to 6.6 up to $\tau = 10$, for the pairs up to 21. */
void report_errors(Report& report, const Points& points) {
  const char *start = "initial condition, 0: impact, 1: pair, 2: pair that is off by eps^(3/2)",
             *tau = "slow time up to which the largest error is taken";

  // Panel (a): errors, and the lines of slope 3/2 through the points of smallest eps
  Table& errors = report.table("dps_error");
  const auto power = [](double eps) { return eps * std::sqrt(eps); };
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t which = 0; which < points.size(); ++which)
      for (const Point& p : points[which]) {
        const Point& smallest = points[which].back();
        errors.add({{"start", start, which},
                    {"tau", tau, horizons[k]},
                    {"eps", "amplitude scale epsilon of the motion", p.eps},
                    {"error", "largest difference between chain and approximation", p.error[k]},
                    {"constant", "error divided by eps^(3/2)", p.error[k].value / power(p.eps)},
                    {"line", "power law of exponent 3/2 through the point of smallest eps",
                     smallest.error[k].value * power(p.eps / smallest.eps)}});
      }

  // Panel (b): local orders
  Table& orders = report.table("dps_order");
  for (std::size_t which = 0; which < points.size(); ++which)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i + 1 < points[which].size(); ++i) {
        const Point &large = points[which][i], &small = points[which][i + 1];
        orders.add({{"start", start, which},
                    {"tau", tau, horizons[k]},
                    {"eps", "geometric mean of two neighbouring values of eps",
                     std::sqrt(large.eps * small.eps)},
                    {"order", "local order of the error in eps",
                     order_between(large.eps, large.error[k], small.eps, small.error[k]), "",
                     "from the errors of both points"}});
      }
}

/**
## Wells of other shapes

To first order a force $y^2$ has no component at the frequency of the well; it shifts the beads and adds a second
harmonic, both $O(\epsilon^2)$. To second order it shifts the phase, as $y^3$ does to first: by $O(\epsilon^{3/2})$
within times $O(\epsilon^{-1/2})$, which changes the displacements by $O(\epsilon^{5/2})$. All this is small against
$\epsilon^{3/2}$. So the order should stay in hard wells, $s = 1$ in Eq. (10), and with a quadratic force, which that
equation does not have. We measure it between $\epsilon = 10^{-5}$ and $10^{-5.5}$, up to $\tau = 4$. As in harmonic
wells it approaches 3/2 slowly, from below.

| local order | impact | pair |
|---|---|---|
| hard wells, $s = 1$ | [1.495](cell:other_wells/well=hard/start=0/order) | [1.498](cell:start=1/order) |
| force $-y-y^2$ | [1.497](cell:other_wells/well=lopsided/start=0/order) | [1.498](cell:start=1/order) | */
struct Lopsided {
  static constexpr const char* name = "lopsided";
  template <class T>
  T energy(T y) const {
    return y * y / T(2) + y * y * y / T(3);
  }
  template <class T>
  T force(T y) const {
    return -(y + y * y);
  }
  template <class T>
  T stiffness(T y) const {
    return T(1) + T(2) * y;
  }
};

void report_wells(Report& report) {
  const std::pair<const char*, Well> wells[] = {{"hard", Quartic{1}}, {"lopsided", Lopsided{}}};
  const double large = report.quick ? -4.5 : -5;
  const double sizes[] = {std::pow(10, large), std::pow(10, large - 0.5)};
  Estimate found[4][2];
  parallel_for("other wells", 8, [&](std::size_t i) {
    const Start start = start_of(i / 2 % 2);
    const Well& well = wells[i / 4].second;
    found[i / 2][i % 2] = deviations_with_errors(start, well, sizes[i % 2], {4}).back();
  });
  Table& table = report.table("other_wells");
  for (std::size_t i = 0; i < 4; ++i)
    table.add({{"well", "hard, s = 1, or lopsided, of the force -y - y^2", wells[i / 2].first},
               {"start", "initial condition, 0: impact, 1: pair", i % 2},
               {"order", "local order of the error in eps, up to tau = 4",
                order_between(sizes[0], found[i][0], sizes[1], found[i][1]), "",
                "from the errors of both points"}});
}

/**
## Periodic travelling waves

The DpS equation has the plane waves $A_n = e^{i(qn-\Omega\tau)}$ with $-2\tau_0\Omega = (2\sin\frac q2)^{5/2}$. By
Eq. (13) they represent $y_n = 2\epsilon\cos(qn+\omega t)$ with $\omega = 1-\epsilon^{1/2}\Omega$. The exact wave is
$y_n(t) = \epsilon u(qn+\omega t)$, where $u$ has the period $2\pi$ and
$$\omega^2u'' + u = \epsilon^{1/2}\bigl[(u(\varphi-q)-u(\varphi))_+^{3/2} - (u(\varphi)-u(\varphi+q))_+^{3/2}\bigr].$$
The equation is invariant under a change of sign of both $\varphi$ and $u$, so we look for odd waves,
$u = \sum_k b_k\sin k\varphi$. The right-hand side, with the harmonics $\epsilon^{1/2}G_k$, is small. For $k\ge2$ it
gives $b_k = \epsilon^{1/2}G_k/(1-k^2\omega^2)$ by iteration.

At $k = 1$ the left-hand side is small too, and it relates frequency and amplitude. The article does not say which of
the two the plane wave shares with the exact one. At *equal frequency* the equation fixes $b_1$, since $G_1$ grows like
$b_1^{3/2}$; at *equal amplitude*, $b_1 = 2$, it fixes $\omega$, and the two waves drift apart. */
enum class Equal { frequency, amplitude };

struct Wave {
  std::vector<double> sine, b;  // sin(phi) at equal distances, and all amplitudes
  double drift;                 // by how much its frequency exceeds that of the plane wave

  /// u less the plane wave, at each phase, when the exact wave is ahead by `ahead`.
  std::vector<double> apart(double ahead) const {
    std::vector<double> out;
    for (std::size_t j = 0; j < sine.size(); ++j) {
      const double phase = 2 * std::numbers::pi * double(j) / double(sine.size()) + ahead;
      double u = 0;
      for (std::size_t k = 0; k < b.size(); ++k) u += b[k] * std::sin(double(k + 1) * phase);
      out.push_back(u - 2 * sine[j]);
    }
    return out;
  }
};

Wave exact_wave(Equal equal, std::size_t beads, double eps, std::size_t points,
                std::size_t harmonics) {
  // The frequency of the plane wave, and its profile as first guess
  const double s = 2 * std::sin(std::numbers::pi / double(beads));  // 2 sin(q/2)
  const double plane = 1 + std::sqrt(eps) * (s * s * std::sqrt(s)) / (2 * tau_0());
  double omega = plane, change = 1;
  std::vector<double> sine(points), b(harmonics);
  for (std::size_t j = 0; j < points; ++j)
    sine[j] = std::sin(2 * std::numbers::pi * double(j) / double(points));
  b[0] = 2;
  for (int round = 0; round <= 200; ++round) {
    if (change < 1e-14) return {sine, b, omega - plane};
    std::vector<double> u(points), force(points);
    for (std::size_t k = 1; k <= harmonics; ++k)
      for (std::size_t j = 0; j < points; ++j) u[j] += b[k - 1] * sine[k * j % points];
    // The forces of this wave, and harmonic by harmonic the next one
    const auto push = [](double x) { return x > 0 ? x * std::sqrt(x) : 0; };
    for (std::size_t j = 0, q = points / beads; j < points; ++j)
      force[j] = push(u[(j + points - q) % points] - u[j]) - push(u[j] - u[(j + q) % points]);
    change = 0;
    for (std::size_t k = 1; k <= harmonics; ++k) {
      double G = 0;
      for (std::size_t j = 0; j < points; ++j) G += force[j] * sine[k * j % points];
      G *= 2 * std::sqrt(eps) / double(points);
      const double stiffness = 1 - omega * omega * double(k * k), ratio = G / (stiffness * b[0]);
      double next = k == 1 ? b[0] / (ratio * ratio) : G / stiffness;
      if (k == 1 && equal == Equal::amplitude) {
        const double found = std::sqrt(1 - G / b[0]);
        change = std::abs(found - omega), omega = found, next = b[0];
      }
      change = std::max(change, std::abs(next - b[k - 1]));
      b[k - 1] = next;
    }
  }
  throw Failure("the iteration for a travelling wave does not converge");
}

/**
At equal frequency the distance from the plane wave is the largest over all phases, so it holds for all times, and
another norm is the root mean square. At equal amplitude it is the largest up to $t = \epsilon^{-1/2}$. By then the
exact wave is ahead by a phase of order $\epsilon^{1/2}$, which is a distance of order $\epsilon^{3/2}$ as well. 24
harmonics and 48 give the errors. The orders follow from $\epsilon = 10^{-6}$ and $10^{-7}$.

| wavelength, sites | article | 2 | 3 | 4 |
|---|---|---|---|---|
| distance at $\epsilon = 10^{-6}$ | | [3.72e-9](cell:travelling_waves/wavelength=2/distance) | [1.77e-9](cell:wavelength=3/distance) | [8.40e-10](cell:wavelength=4/distance) |
| order | 3/2 | [1.500](cell:travelling_waves/wavelength=2/order) | [1.500](cell:wavelength=3/order) | [1.499](cell:wavelength=4/order) |
| order of the root mean square | 3/2 | [1.500](cell:travelling_waves/wavelength=2/order_rms) | [1.500](cell:wavelength=3/order_rms) | [1.500](cell:wavelength=4/order_rms) |
| order at equal amplitude | 3/2 | [1.499](cell:travelling_waves/wavelength=2/order_amplitude) | [1.500](cell:wavelength=3/order_amplitude) | [1.500](cell:wavelength=4/order_amplitude) | */
struct Distances {
  Estimate largest, rms, at_equal_amplitude;
};

Distances distances(std::size_t beads, double eps) {
  const auto largest = [&](const Wave& wave, double ahead) {
    double most = 0;
    for (const double x : wave.apart(ahead)) most = std::max(most, std::abs(x));
    return eps * most;
  };
  const auto rms = [&](const Wave& wave) {
    double sum = 0;
    for (const double x : wave.apart(0)) sum += x * x;
    return eps * std::sqrt(sum / double(wave.sine.size()));
  };
  const auto late = [&](const Wave& wave) {
    return std::max(largest(wave, 0), largest(wave, wave.drift / std::sqrt(eps)));
  };
  // Of one wave each, with two resolutions
  const auto both = [&](Equal equal, const auto& of) {
    return compare(of(exact_wave(equal, beads, eps, 1536, 24)),
                   of(exact_wave(equal, beads, eps, 3072, 48)));
  };
  const auto now = [&](const Wave& wave) { return largest(wave, 0); };
  return {both(Equal::frequency, now), both(Equal::frequency, rms), both(Equal::amplitude, late)};
}

// Three wavelengths at two sizes
void report_waves(Report& report) {
  Table& table = report.table("travelling_waves");
  for (const std::size_t beads : {2U, 3U, 4U}) {
    const Distances large = distances(beads, 1e-6), small = distances(beads, 1e-7);
    const auto order = [](const Estimate& a, const Estimate& b) {
      return order_between(1e-6, a, 1e-7, b);
    };
    const char* from = "from the errors of both distances";
    table.add(
        {{"wavelength", "wavelength", beads, "site"},
         {"distance", "largest difference of exact and plane wave at eps = 1e-6, equal frequency",
          large.largest},
         {"order", "its order in eps, from there to 1e-7", order(large.largest, small.largest), "",
          from},
         {"order_rms", "the same of the root mean square", order(large.rms, small.rms), "", from},
         {"order_amplitude", "the same at equal amplitude, of the largest up to t = eps^(-1/2)",
          order(large.at_equal_amplitude, small.at_equal_amplitude), "", from}});
  }
}

/**
## Accuracy and checks

The run stops if GSL and the library disagree on the chain, at the larger step, by more than a thousandth of the
deviation, or if the last bead has moved. The order is a sharp test: with $\tau_0$ off by three per cent, or wells whose
stiffness is off by two thousandths, it is lost (tests/lattice/model/dps.cpp). Maxima over beads and sampled times, at
sizes from $10^{-6}$ to $10^{-2}$, do not prove the theorem. It says nothing about times much longer than
$\epsilon^{-1/2}$; `sec34_dps_impact` compares both equations at $\tau = 250$. */
void reproduce(Report& report) {
  report.output.note("tolerance",
                     "GSL " + short_text(tolerances[0]) + " and " + short_text(tolerances[1]));
  report
      .table("time_constant", {estimate("tau_0", "constant of the DpS equation, by quadrature", "",
                                        "difference from the closed form")})
      .add({compare(tau_0(), tau_0_by_quadrature())});
  const Points points = measure_errors(report.quick ? 2 : 4);
  report_errors(report, points);
  report_wells(report);
  report_waves(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.tau0`: tau_0 = 5 Gamma(1/4)^2 / (24 sqrt(pi)) | 1.545 | 1.545 | reproduced |
| `dps.error_order`: order in eps of the sup error of the DpS approximation up to t = O(eps^-1/2) | 1.5 | 1.5 | reproduced |
| `dps.travelling_close`: the ansatz is O(epsilon^(3/2))-close to exact small amplitude periodic travelling waves | 1.5 | 1.500 | reproduced, assuming |
| `dps.wells_drop_out`: smooth on-site nonlinear terms (s y^3 and a quadratic force too) leave the DpS equation unchanged | unchanged | other_wells.order (well = hard, start = 0) away from 1.5: 0.004524 < 0.03 (the closest of 4) | holds |
<!-- /statements -->

## Try it

**To change it.** Another start is a vector of complex amplitudes in `start_of`, another well a struct like `Lopsided`,
in its place in `wells`. For another contact law of the power $\alpha$, whose order is $\alpha$ as well, change both
lines called `to_right`, the third member of `Chain` in `deviations`, `tau_0(alpha)`, the power in `report_errors`, and
in `deviations` the slow time, $\epsilon^{\alpha-1}$ for `sqrt(eps)`, and what the third start is off by,
$\epsilon^\alpha$; the sections on the constant and on exact waves are for spheres.

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
