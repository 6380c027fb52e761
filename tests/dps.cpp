// The DpS equation: its time constant, its invariants, its symmetries and its relation to the chain.

#include "lattice/model/dps.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <numbers>

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/impact/impact.hpp"
#include "sec3/dps_error.hpp"
#include "sec3/travelling_wave.hpp"

using namespace lattice;

namespace {

/// A well whose frequency at rest is not one.
struct Stiff {
  static constexpr const char* name = "stiff";
  template <class T>
  T energy(T y) const {
    return T(0.501) * y * y;
  }
  template <class T>
  T force(T y) const {
    return T(-1.002) * y;
  }
  template <class T>
  T stiffness(T) const {
    return T(1.002);
  }
};

}  // namespace

TEST_CASE("tau_0 is the first harmonic of the contact force", "[unit][dps]") {
  // The force (2 a cos t)_+^{3/2} has the first Fourier coefficient c a^{3/2}, c = 1 / (2 tau_0) * 2.
  gsl_integration_workspace* w = gsl_integration_workspace_alloc(1000);
  gsl_function f{[](double t, void*) { return std::pow(2 * std::cos(t), 1.5) * std::cos(t); },
                 nullptr};
  double integral = 0, error = 0;
  const double half = std::numbers::pi / 2;
  gsl_integration_qags(&f, -half, half, 1e-13, 1e-13, 1000, w, &integral, &error);
  gsl_integration_workspace_free(w);
  // i dA/dtau * 2 = (average of force * e^{-it}); average = integral / (2 pi) = 1 / tau_0.
  check_close(integral / (2 * std::numbers::pi), 1 / tau_0(), 1e-10);
  check_close(tau_0(), 1.545, 5e-4);
}

TEST_CASE("the energy is the sum of two fifths of |r|^(5/2)", "[unit][dps]") {
  using namespace std::complex_literals;
  check_close(energy({0.0, 0.3 + 0.4i}), 0.4 * std::pow(0.5, 2.5), 1e-15);
  check_close(energy({0.0, 0.0, 2.0, 0.0}), 0.8 * std::pow(2.0, 2.5), 0, 1e-15);
  check_close(energy({0.0, 0.0, 2.0}, true), energy({0.0, 0.0, 2.0, 0.0}), 0, 1e-15);
}

TEST_CASE("norm and energy are conserved", "[property][dps]") {
  Field field = dps_impact(40);
  field[3] = {0.3, 0.2};
  const double n0 = norm(field), e0 = energy(field);
  const double drift = evolve_dps(Dps{40}, field, 30, 10, 1e-11);
  CHECK(drift < 1e-9);
  check_close(norm(field), n0, 0, 1e-9);
  check_close(energy(field), e0, 0, 1e-9);
}

TEST_CASE("a v(sqrt(a) t) is a solution with v(t)", "[property][dps]") {
  Field one = dps_impact(30), large = dps_impact(30);
  for (auto& a : large) a *= 4;
  evolve_dps(Dps{30}, one, 20, 1, 1e-12);
  evolve_dps(Dps{30}, large, 10, 1, 1e-12);
  for (std::size_t n = 0; n < 30; ++n) {
    check_close(large[n].real(), 4 * one[n].real(), 1e-8);
    check_close(large[n].imag(), 4 * one[n].imag(), 1e-8);
  }
}

TEST_CASE("the approximation approaches the chain as eps goes to zero", "[property][dps]") {
  // Error / eps should fall like eps^{1/2} over a time of order eps^{-1/2}.
  const auto relative_error = [](double eps) {
    const double tau = 1, t = tau / std::sqrt(eps);
    Field field = dps_impact(20);
    evolve_dps(Dps{20}, field, tau, 1, 1e-12);
    State<double> chain = struck(20, 2 * eps);
    evolve(Splitting{blanes_moan_6(), 0.02}, Chain{20}, chain, t, t);
    const auto y = dps_state(field, eps, t).y;
    double error = 0;
    for (std::size_t n = 0; n < 20; ++n) error = std::max(error, std::abs(y[n] - chain.y[n]));
    return error / eps;
  };
  const double coarse = relative_error(1e-4), fine = relative_error(1e-6);
  CHECK(coarse < 0.1);
  check_close(coarse / fine, 10, 4);
}

TEST_CASE("the order 3/2 needs a well of frequency one and the right tau_0", "[property][dps]") {
  const auto stays = [](const Compared& both) {
    const auto error = [&](double eps) { return refined_deviations(both, eps, {1}).front(); };
    return holds(within(order_between(1e-4, error(1e-4), 1e-5, error(1e-5)), 1.47, 1.53));
  };
  const Field start = dps_impact(12);
  CHECK(stays({start}));
  CHECK(stays({start, Quartic{-1}}));
  CHECK_FALSE(stays({start, Stiff{}}));
  for (const double wrong : {1.5, 1.6}) CHECK_FALSE(stays({start, Harmonic{}, 1 / (2 * wrong)}));
}

TEST_CASE("a travelling wave comes back, its ansatz does not", "[property][dps]") {
  for (const std::size_t beads : {2U, 3U, 4U}) {
    TravellingWave wave(beads, 1e-3);
    const auto misses = [&] {
      Chain ring{12};
      ring.ends = Ends::periodic;
      const State<double> start = wave.on_ring(12);
      State<double> end = start;
      flow(ring, end, 2 * std::numbers::pi / wave.omega);
      return largest_difference(start, end) / wave.eps;
    };
    CHECK(misses() < 1e-5);
    std::fill(wave.b.begin() + 1, wave.b.end(), 0.0);
    CHECK(misses() > 1e-4);
  }
}

TEST_CASE("a fixed end takes part, a free one does not", "[unit][dps]") {
  std::vector<double> a{0, -1, 0, 0}, free(4), fixed(4);
  Dps{2, Ends::free}(0, a.data(), free.data());
  Dps{2, Ends::fixed}(0, a.data(), fixed.data());
  check_close(fixed[0], 2 * free[0], 1e-15);
  CHECK(fixed[2] == free[2]);
}

namespace {

double push(double x) {
  return x > 0 ? x * std::sqrt(x) : 0;
}

}  // namespace

TEST_CASE("a travelling wave obeys its equation in every harmonic", "[unit][dps]") {
  for (std::size_t beads : {3, 4, 8}) {
    const std::size_t points = 240;
    const double eps = 1e-3, q = 2 * std::numbers::pi / double(beads);
    const TravellingWave wave(beads, eps, points, 10);
    CHECK((wave.points == points && wave.harmonics == 10 && wave.b.size() == 10));
    check_close(wave.omega, 1 + std::sqrt(eps) * std::pow(2 * std::sin(q / 2), 2.5) / (2 * tau_0()),
                1e-13);
    const auto u = [&](double x) {
      double sum = 0;
      for (int k = 1; k <= 10; ++k) sum += wave.b[std::size_t(k - 1)] * std::sin(k * x);
      return sum;
    };
    double most = 0;
    std::vector<double> G(10, 0);
    for (std::size_t j = 0; j < points; ++j) {
      const double x = 2 * std::numbers::pi * double(j) / double(points);
      check_close(wave.profile().at(j), u(x), 1e-13);
      most = std::max(most, std::abs(u(x) - 2 * std::sin(x)));
      const double force = push(u(x - q) - u(x)) - push(u(x) - u(x + q));
      for (int k = 1; k <= 10; ++k)
        G[std::size_t(k - 1)] += 2 * force * std::sin(k * x) / double(points);
    }
    check_close(wave.b[0], 2, 0.1);  // rest would obey it too
    check_close(wave.from_ansatz(), eps * most, 1e-15);
    for (std::size_t k = 1; k <= 10; ++k)
      check_close(wave.b[k - 1] * (1 - std::pow(wave.omega * double(k), 2)),
                  std::sqrt(eps) * G[k - 1], 1e-12);
    const State<double> ring = wave.on_ring(2 * beads);
    for (std::size_t n = 0; n < 2 * beads; ++n) {
      const double x = q * double(n), h = 1e-4;
      check_close(ring.y[n], eps * u(x), 1e-15);
      check_close(
          ring.v[n],
          eps * wave.omega * (8 * (u(x + h) - u(x - h)) - u(x + 2 * h) + u(x - 2 * h)) / (12 * h),
          1e-13);
    }
  }
  const TravellingWave usual(4, 1e-10);
  CHECK((usual.points == 3072 && usual.harmonics == 48));
}
