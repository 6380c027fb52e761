// Steppers: order, reversibility, symplecticity, energy, the window, and an independent reference.

#include "lattice/integrators/integrate.hpp"

#include <gsl/gsl_fit.h>

#include "check.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/packets/impact.hpp"

using namespace lattice;

namespace {

template <class Stepper>
State<double> after(const Stepper& stepper, const Chain& chain, State<double> s, double time) {
  evolve(stepper, chain, s, time, time, Unobserved{});
  return s;
}

/// Measured order: slope of log error against log step, the error summed over several impacts.
double measured_order(const Scheme& scheme, const std::vector<double>& steps) {
  std::vector<double> x, y;
  for (double h : steps) {
    double error = 0;
    for (double v0 : {1.3, 1.5, 1.7, 1.9}) {
      const Chain chain{60, Quartic{1}};
      const auto exact = after(Splitting{blanes_moan_6(), 5e-4}, chain, struck(60, v0), 20);
      error += largest_difference(after(Splitting{scheme, h}, chain, struck(60, v0), 20), exact);
    }
    x.push_back(std::log(h));
    y.push_back(std::log(error));
  }
  double c0, c1, cov00, cov01, cov11, chi;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &c0, &c1, &cov00, &cov01, &cov11, &chi);
  return c1;
}

/// A wave on a compressed ring whose contacts never open.
struct Smooth {
  Chain chain{20, Quartic{1}, CompressedHertz{2}, Ends::periodic};
  State<double> start{20};
  Smooth() {
    for (int n = 0; n < 20; ++n) start.y[n] = 0.3 * std::sin(0.1 * M_PI * n * 3);
  }
};

double smooth_order(const Scheme& scheme, double h) {
  const Smooth s;
  const auto exact = after(Splitting{blanes_moan_6(), 0.005}, s.chain, s.start, 5);
  const auto error = [&](double step) {
    return largest_difference(after(Splitting{scheme, step}, s.chain, s.start, 5), exact);
  };
  return std::log2(error(h) / error(h / 2));
}

}  // namespace

TEST_CASE("schemes have their order where contacts stay closed", "[convergence]") {
  check_close(smooth_order(verlet(), 0.02), 2, 0.1);
  check_close(smooth_order(blanes_moan_4(), 0.1), 4, 0.2);
  check_close(smooth_order(blanes_moan_6(), 0.2), 6, 0.4);
  check_close(smooth_order(calvo_sanz_serna_4(), 0.1), 4, 0.2);
}

TEST_CASE("switching contacts hold every splitting near order 2.5", "[convergence]") {
  const double order4 = measured_order(blanes_moan_4(), {0.08, 0.04, 0.02, 0.01});
  const double order6 = measured_order(blanes_moan_6(), {0.08, 0.04, 0.02, 0.01});
  CAPTURE(order4, order6);
  CHECK(order4 > 2);
  CHECK(order4 < 3.2);
  CHECK(order6 > 2);
  CHECK(order6 < 3.2);
  check_close(measured_order(verlet(), {0.02, 0.01, 0.005}), 2, 0.3);
}

TEST_CASE("a run is undone by turning the velocities round", "[property]") {
  const Chain chain{60, Quartic{1}};
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6()}) {
    CAPTURE(scheme.name);
    auto s = after(Splitting{scheme, 0.05}, chain, struck(60, 1.9), 20);
    for (double& v : s.v) v = -v;
    s.t = 0;
    s = after(Splitting{scheme, 0.05}, chain, s, 20);
    auto start = struck(60, 1.9);
    start.v[0] = -1.9;
    check_close(largest_difference(s, start), 0, 1e-11);
  }
}

TEST_CASE("one step is symplectic", "[property]") {
  // The Jacobian M of a step satisfies M^T J M = J; central differences give it to 1e-8.
  const Chain chain{4, Quartic{0.5}};
  State<double> s(4);
  s.y = {0.31, -0.22, 0.17, 0.4};
  s.v = {0.1, 0.3, -0.2, 0.05};
  const auto flow = [&](std::vector<double> z) {
    State<double> x(4);
    std::copy_n(z.begin(), 4, x.y.begin());
    std::copy_n(z.begin() + 4, 4, x.v.begin());
    x = after(Splitting{blanes_moan_4(), 0.3}, chain, x, 0.3);
    x.y.insert(x.y.end(), x.v.begin(), x.v.end());
    return x.y;
  };
  std::vector<double> z = s.y;
  z.insert(z.end(), s.v.begin(), s.v.end());
  double m[8][8];
  for (int j = 0; j < 8; ++j) {
    auto p = z, q = z;
    p[j] += 1e-5;
    q[j] -= 1e-5;
    const auto a = flow(p), b = flow(q);
    for (int i = 0; i < 8; ++i) m[i][j] = (a[i] - b[i]) / 2e-5;
  }
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      double form = 0;
      for (int k = 0; k < 4; ++k) form += m[k][i] * m[k + 4][j] - m[k + 4][i] * m[k][j];
      check_close(form, j == i + 4 ? 1 : i == j + 4 ? -1 : 0, 1e-7);
    }
}

TEST_CASE("energy drift is small and reported", "[property]") {
  const Chain chain{200, Quartic{1}};
  auto s = struck(200, 1.9);
  const Run run = evolve(Splitting{blanes_moan_6(), 0.02}, chain, s, 200, 1, Unobserved{});
  CHECK(run.energy_drift > 0);
  CHECK(run.energy_drift < 1e-5);
  check_close(energy(chain, s), 1.9 * 1.9 / 2, 0, run.energy_drift * 1.01);
}

TEST_CASE("a windowed run has the bits of the full run", "[property][window]") {
  const Chain chain{120, Quartic{1}};
  const Splitting stepper{blanes_moan_6(), 0.05};
  auto windowed = struck(120, 1.9), full = windowed;
  Window some = waking(chain, windowed), all{0, 120};
  CHECK(some == Window{0, 1});
  stepper.advance(chain, windowed, some, 0.05, 4000);
  stepper.advance(chain, full, all, 0.05, 4000);
  CHECK(some.last > 20);
  CHECK(some.last < 120);
  CHECK(windowed.y == full.y);
  CHECK(windowed.v == full.v);
}

TEST_CASE("the chain agrees with GSL's adaptive method", "[property]") {
  const Chain chain{40, Quartic{-0.3}};
  auto ours = struck(40, 0.9), theirs = ours;
  ours = after(Splitting{blanes_moan_6(), 1e-3}, chain, ours, 30);
  evolve_reference(chain, theirs, 30, 1e-13);
  check_close(largest_difference(ours, theirs), 0, 2e-8);
  check_close(distance_from_reference(chain, struck(40, 0.9), 30, ours, 1e-6), 0, 1e-7);
  ours.v[3] += 1e-5;  // a state that GSL does not confirm is refused
  CHECK_THROWS_AS(distance_from_reference(chain, struck(40, 0.9), 30, ours, 1e-6),
                  std::runtime_error);
}

TEST_CASE("a runaway is seen and stops the run", "[unit]") {
  const Chain chain{30, Quartic{-0.7}};
  auto s = struck(30, 1.3);
  int shown = 0;
  const Run run =
      evolve(Splitting{blanes_moan_4(), 0.05}, chain, s, 100, 1, [&](const State<double>& now) {
        ++shown;
        for (double y : now.y) REQUIRE(std::isfinite(y));
      });
  CHECK(run.escaped());
  CHECK(run.escape_time < 20);
  CHECK(shown < 20);
}
