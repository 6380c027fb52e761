// Decorated cantilevers: beam, units, defect.

#include "lattice/cantilever/cantilever.hpp"

#include "support/check.hpp"

using namespace lattice;

TEST_CASE("the clamped beam", "[convergence][cantilever]") {
  check_close(std::cos(clamped_root()) * std::cosh(clamped_root()), 1, 1e-12);
  const auto error = [](std::size_t steps) {
    return std::abs(ClampedBeam{steps}.wavenumber() - clamped_root());
  };
  check_close(std::log2(error(20) / error(40)), 4, 0.1);
  // Under a heavy mass the beam is a spring with 13/35 of its own mass (that of its static shape).
  const double x = ClampedBeam{400, 100}.wavenumber();
  check_close(x * x * x * x, 192 / (100 + 13. / 35), 0, 1e-5);
}

TEST_CASE("a defect changes one mass and two contacts", "[unit][cantilever]") {
  const CantileverArray array;
  const auto chain = cantilever_chain(array, 1.6);
  for (std::size_t n = 1; n <= array.sites; ++n)
    check_close(chain.mass_of(n - 1), n == 100 ? array.mu(1.6) : 1, 1e-15);
  for (std::size_t i = 0; i <= array.sites; ++i)  // i lies between cantilevers i and i + 1
    check_close(chain.eta_of(i), i == 99 || i == 100 ? std::sqrt(3.2 / 2.6) : 1, 1e-15);
  const auto without = cantilever_chain(array, 1);
  for (std::size_t n = 0; n < array.sites; ++n) CHECK(without.mass_of(n) == 1);
}

TEST_CASE("units of an array, there and back", "[unit][cantilever]") {
  const CantileverArray array;
  const Scales s = array.scales();
  const auto close = [](double value, double expected) { check_close(value, expected, 0, 1e-12); };
  close(s.milliseconds(s.time(2.5)), 2.5);
  close(s.time(1), 1e-3 / s.tau_c());
  close(s.hertz(s.omega(7000)), 7000);
  close(s.omega(7000), 2 * std::numbers::pi * 7000 * std::sqrt(s.m / s.k));
  close(s.micrometres(2), 2e6 * (s.k / s.gamma) * (s.k / s.gamma));
  close(s.velocity(3), 3 * s.tau_c() / s.xi());
  close(s.per_second(2), 2 / s.tau_c());
  close(s.watts(2), 2 * s.k * s.xi() * s.xi() / s.tau_c());
  close(s.unit_force(), s.k * s.xi());
  close(s.unit_force(), s.gamma * std::pow(s.xi(), 1.5));
  close(s.rate(10), s.tau_c() / 10e-3);
  CHECK(s.rate(0) == 0);
  close(s.tau_h(2), std::pow(s.m * s.m / (s.gamma * s.gamma * 2), 0.2));
  close(s.delta(2), std::pow(s.m * 4 / s.gamma, 0.4));
  // Eqs. (29) and (30): the velocity of an impact in units of the chain is lambda^(5/2)
  close(s.velocity(0.1), std::pow(s.lambda(0.1), 2.5));
  close(array.area_moment(), 5e-3 * 1e-9 / 12);
  close(array.beam_mass(), 8e3 * 5e-3 * 1e-3 * 25e-3);
  close(array.bead_mass(1.5), 4 * std::numbers::pi / 3 * 2.2e3 * std::pow(1.5 * 2.38e-3, 3));
}
