// The DpS equation: its time constant, its invariants, its symmetries and its relation to the chain.

#include "lattice/model/dps.hpp"

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <numbers>

#include "lattice/events/event_driven.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "support/check.hpp"
#include "support/dps_deviation.hpp"
#include "support/estimates.hpp"

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
  const Field start = dps_impact(12);
  const auto stays = [&](const auto&... changed) {
    const auto error = [&](double eps) { return dps_deviation(start, eps, changed...); };
    return holds(within(order_between(1e-4, error(1e-4), 1e-5, error(1e-5)), 1.47, 1.53));
  };
  CHECK(stays());
  CHECK(stays(Well(Quartic{-1})));
  CHECK_FALSE(stays(Well(Stiff{})));
  for (const double wrong : {1.5, 1.6}) CHECK_FALSE(stays(Well(Harmonic{}), 1 / (2 * wrong)));
}

TEST_CASE("a fixed end takes part, a free one does not", "[unit][dps]") {
  std::vector<double> a{0, -1, 0, 0}, free(4), fixed(4);
  Dps{2, Ends::free}(0, a.data(), free.data());
  Dps{2, Ends::fixed}(0, a.data(), fixed.data());
  check_close(fixed[0], 2 * free[0], 1e-15);
  CHECK(fixed[2] == free[2]);
}
