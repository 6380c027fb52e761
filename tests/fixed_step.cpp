// Methods that take no notice of contacts: tables, orders, step control, and maps of fixed steps.

#include "sec33/fixed_step.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "lattice/integrators/contact_rkn.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/integrators/runge_kutta.hpp"
#include "lattice/orbits/floquet.hpp"

using namespace lattice;

namespace {

constexpr double period = 2 * std::numbers::pi / 1.1;

/// An oscillator whose frequency depends on its amplitude, as an equation of first order.
const Rhs pendulum = [](double, const double* x, double* dx) {
  dx[0] = x[1];
  dx[1] = -std::sin(x[0]);
};

/// Order from two runs with `steps` steps and twice as many, against one with many more.
double order_of(const RungeKutta& method, std::size_t steps) {
  const auto end = [&](std::size_t count) {
    std::vector<double> x{1.5, 0};
    integrate_fixed(method, pendulum, x, 5, 1, count, Unwatched{});
    return x;
  };
  const auto exact = end(64 * steps);
  const auto error = [&](std::size_t count) { return std::abs(end(count)[0] - exact[0]); };
  return std::log2(error(steps) / error(2 * steps));
}

/// A breather's map in a short chain.
FixedStep map_with(const Nystrom& method, std::size_t steps, Centre centre = Centre::bond) {
  return {breather_problem(centre, 1.1, 0, centre == Centre::bond ? 12 : 13).chain, method, steps,
          period};
}
State<double> breather_at(Centre centre) {
  return find_breather(breather_problem(centre, 1.1, 0, centre == Centre::bond ? 12 : 13)).start;
}

std::size_t steps_of(ErrorNorm norm, std::size_t idle, double relative = 1e-4) {
  std::vector<double> x(2 + idle, 0);
  x[0] = 1.5;
  const auto rhs = [&](double t, const double* z, double* dz) {
    pendulum(t, z, dz);
    std::fill(dz + 2, dz + 2 + idle, 0);
  };
  return integrate_controlled(dormand_prince_5(), rhs, x, 20, 1, {relative, 1e-3 * relative, norm},
                              Unwatched{})
      .accepted;
}

}  // namespace

TEST_CASE("Runge-Kutta methods have their order", "[convergence][runge-kutta]") {
  check_close(order_of(classical_4(), 40), 4, 0.3);
  check_close(order_of(fehlberg_5(), 40), 5, 0.3);
  check_close(order_of(dormand_prince_5(), 40), 5, 0.3);
}

TEST_CASE("the tables are consistent", "[unit][runge-kutta]") {
  for (const RungeKutta& m : {classical_4(), fehlberg_5(), dormand_prince_5()}) {
    CAPTURE(m.name);
    // sum b = 1, sum b c = 1/2, and an error estimate vanishes for a constant slope and a linear one
    double sum = 0, first = 0, error = 0, error_first = 0;
    for (std::size_t i = 0; i < m.weights.size(); ++i) {
      double time = 0;
      for (double a : m.stages[i]) time += a;
      sum += m.weights[i];
      first += m.weights[i] * time;
      if (m.error.empty()) continue;
      error += m.error[i];
      error_first += m.error[i] * time;
    }
    check_close(sum, 1, 1e-14);
    check_close(first, 0.5, 1e-14);
    CHECK(std::abs(error) < 1e-15);
    CHECK(std::abs(error_first) < 1e-15);
  }
}

TEST_CASE("eliminating the velocities of the classical method gives its known form",
          "[unit][runge-kutta]") {
  const Nystrom made = nystrom(classical_4()), known = classical_runge_kutta();
  REQUIRE(made.c.size() == known.c.size());
  for (std::size_t i = 0; i < made.c.size(); ++i) {
    check_close(made.c[i], known.c[i], 1e-15);
    check_close(made.b[i], known.b[i], 1e-15);
    for (std::size_t j = 0; j < i; ++j) check_close(made.a[i][j], known.a[i][j], 1e-15);
  }
}

TEST_CASE("a controlled run obeys its tolerance, and its samples lie on the orbit",
          "[unit][runge-kutta]") {
  const auto error_at = [](double relative) {
    double worst = 0;
    std::vector<double> x{1};
    const Rhs decay = [](double, const double* z, double* dz) { dz[0] = -z[0]; };
    integrate_controlled(dormand_prince_5(), decay, x, 5, 40, {relative, relative, ErrorNorm::two},
                         [&](double t, const std::vector<double>& now) {
                           worst = std::max(worst, std::abs(now[0] - std::exp(-t)));
                         });
    return worst;
  };
  const double loose = error_at(1e-4), tight = error_at(1e-9);
  CHECK(loose < 3e-3);
  CHECK(tight < 1e-2 * loose);
}

TEST_CASE("a step is lengthened ten times and shortened five times at most",
          "[unit][runge-kutta]") {
  // Without a force every step is accepted: 1, 10, 100, and the rest of a duration of 1000
  std::vector<double> x{1};
  const Rhs rest = [](double, const double*, double* dz) { dz[0] = 0; };
  const ControlledRun run = integrate_controlled(dormand_prince_5(), rest, x, 1000, 1,
                                                 {1e-3, 1e-3, ErrorNorm::two, 1}, Unwatched{});
  CHECK(run.accepted == 4);
  CHECK(run.rejected == 0);
  // And shortened to a fifth at most: the second stage is at 1 - 1000 h / 5, first for h = 1, then for h = 1/5
  std::vector<double> stages;
  x = {1};
  const Rhs steep = [&](double, const double* z, double* dz) {
    stages.push_back(z[0]), dz[0] = -1000 * z[0];
  };
  integrate_controlled(dormand_prince_5(), steep, x, 1, 1, {1e-3, 1e-3, ErrorNorm::two, 1},
                       Unwatched{});
  check_close(stages.at(1), -199, 1e-9);
  const auto next = [&](double value) {
    return std::any_of(stages.begin() + 2, stages.begin() + 9,
                       [&](double z) { return std::abs(z - value) < 1e-9; });
  };
  CHECK(next(-39));
}

TEST_CASE("the mean over idle components loosens a tolerance, the other norms do not",
          "[property][runge-kutta]") {
  CHECK(steps_of(ErrorNorm::two, 0) == steps_of(ErrorNorm::two, 500));
  CHECK(steps_of(ErrorNorm::largest, 0) == steps_of(ErrorNorm::largest, 500));
  CHECK(steps_of(ErrorNorm::rms, 500) < 0.7 * double(steps_of(ErrorNorm::rms, 0)));
  // The root of the mean of n squares is that of the sum over the root of n
  CHECK(steps_of(ErrorNorm::rms, 0) < steps_of(ErrorNorm::two, 0));
}

TEST_CASE("a solution that runs away stops a controlled run", "[unit][runge-kutta]") {
  std::vector<double> x{1};
  const Rhs explosion = [](double, const double* z, double* dz) { dz[0] = z[0] * z[0]; };
  CHECK_THROWS_AS(integrate_controlled(dormand_prince_5(), explosion, x, 2, 10, {}, Unwatched{}),
                  std::runtime_error);
}

TEST_CASE("the caller's method follows the same DpS packet as GSL", "[unit][dps]") {
  const Dps dps{40};
  const DpsOutcome ours = follow_dps_by(
      dps, dps_impact(40), [](const Rhs& rhs, std::vector<double>& x, const auto& observe) {
        integrate_fixed(dormand_prince_5(), rhs, x, 60, 60, 20, observe);
      });
  const DpsOutcome theirs = follow_dps(dps, dps_impact(40), 60, 60, 1e-10, Unwatched{});
  check_close(packet_amplitude(ours.track).value, packet_amplitude(theirs.track).value, 0, 1e-5);
  check_close(ours.track.centre.back(), theirs.track.centre.back(), 1e-4);
  CHECK(ours.norm_drift < 1e-6);
}

TEST_CASE("splittings are symplectic, and that of Calvo and Sanz-Serna is not symmetric",
          "[property]") {
  State<double> start(4);
  start.y = {0.7, -0.22, 0.17, 0.4};
  const auto map_by = [](const Nystrom& method) {
    return FixedStep{Chain{4, Quartic{1}}, method, 10, 3};
  };
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), calvo_sanz_serna_4()})
    CHECK(symplectic_defect(derivative(map_by(nystrom(scheme)), start, 8, 0)) < 1e-13);
  CHECK(symplectic_defect(derivative(map_by(classical_runge_kutta()), start, 8, 0)) > 1e-6);
  // A retraced run does not come back to rounding, one of Verlet does
  const auto miss = [&](const Nystrom& method) {
    State<double> state = start;
    carry(map_by(method), state);
    for (double& v : state.v) v = -v;
    carry(map_by(method), state);
    return std::abs(state.y[0] - start.y[0]);
  };
  CHECK(miss(nystrom(verlet())) < 1e-14);
  CHECK(miss(nystrom(calvo_sanz_serna_4())) > 1e-10);
}

TEST_CASE("the map is what the contact-aware stepper does without its correction", "[unit]") {
  const FixedStep map = map_with(classical_runge_kutta(), 40);
  State<double> ours = breather_at(Centre::bond), theirs = ours;
  carry(map, ours, 3);
  const ContactAware blind{.step = period / 40,
                           .base = classical_runge_kutta(),
                           .negligible = std::numeric_limits<double>::infinity()};
  evolve(blind, map.chain, theirs, 3 * period, 3 * period, Unobserved{});
  for (std::size_t n = 0; n < ours.y.size(); ++n) check_close(ours.y[n], theirs.y[n], 1e-15);
}

TEST_CASE("variational equations are the derivative of the map", "[property]") {
  for (const Nystrom& method : {classical_runge_kutta(), nystrom(calvo_sanz_serna_4())}) {
    const FixedStep map = map_with(method, 30);
    const State<double> start = breather_at(Centre::bond);
    const std::size_t all = 2 * start.y.size();
    const Matrix<double> exact = derivative(map, start, all, 0);
    CHECK((derivative(map, start, all, 1e-9) - exact).cwiseAbs().maxCoeff() < 1e-3);
    CHECK(exact.cwiseAbs().maxCoeff() > 0.1);
  }
}

TEST_CASE("a symmetric map has breathers, one that loses energy has none", "[unit]") {
  const State<double> guess = breather_at(Centre::bond);
  const auto residual = [&](const Nystrom& method, std::size_t steps) {
    return find_breather(map_with(method, steps), guess, {5, 0, 1e-4}).residual;
  };
  CHECK(residual(nystrom(verlet()), 80) < 1e-12);
  const double coarse = residual(classical_runge_kutta(), 80),
               fine = residual(classical_runge_kutta(), 160);
  CHECK(coarse > 1e-8);
  // The loss in one period is of order five
  CHECK(std::log2(coarse / fine) > 4);
  CHECK(std::log2(coarse / fine) < 6);
}

TEST_CASE("the zero of kappa in three wells", "[unit]") {
  const auto parabola = [](double s) { return (s - 0.25) * (3 - s); };
  check_close(zero_in_wells({parabola(-1), parabola(0), parabola(1)}), 0.25, 1e-14);
  check_close(zero_in_wells({-1.1, -0.1, 0.9}), 0.1, 1e-14);
  CHECK(std::isnan(zero_in_wells({2, 1, 2})));
  CHECK(std::isnan(zero_in_wells({3, 2, 1.5})));
}

TEST_CASE(
    "a strong kick frees a breather of the map, and a short look at a weak one decides nothing",
    "[unit]") {
  const FixedStep map{breather_problem(Centre::bond, 1.1, 0, 18).chain,
                      nystrom(calvo_sanz_serna_4()), 60, period};
  const State<double> start =
      find_breather(breather_problem(Centre::bond, 1.1, 0, 18), Phase::stretched).start;
  CHECK(frees(map, start, 4e-4, 2000));
  CHECK_FALSE(frees(map, start, 1e-6, 2000));
}

TEST_CASE("two sites away for one horizon is no jump if the breather travels on", "[unit]") {
  const auto path = [](const std::vector<double>& X) {
    Creep out;
    for (std::size_t k = 0; k < X.size(); ++k) out.t.push_back(double(k)), out.X.push_back(X[k]);
    return out;
  };
  CHECK(stays_away(path({0, -1, -2, -1.8, -2.1, -2}), 2, 2));
  CHECK_FALSE(stays_away(path({0, 0.7, 1.4, 2, 2.6}), 2, 3));    // at constant speed
  CHECK_FALSE(stays_away(path({0, 1, 1.9, 1.9, 1.2}), 2, 2));    // comes back
  CHECK_FALSE(stays_away(path({0, 0.9, 0.9, 0.9, 0.9}), 2, 2));  // one site only
  CHECK_FALSE(stays_away(path({0, 2, 2}), 2, 4));                // not followed so far
  CHECK_FALSE(stays_away({}, 2, 0));
}
