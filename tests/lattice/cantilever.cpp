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
  close(s.hertz(s.omega(7000)), 7000);
  close(s.unit_force(), s.gamma * std::pow(s.xi(), 1.5));
  CHECK(s.rate(0) == 0);
  // Eqs. (29) and (30): the velocity of an impact in units of the chain is lambda^(5/2)
  close(s.velocity(0.1), std::pow(s.lambda(0.1), 2.5));
}
