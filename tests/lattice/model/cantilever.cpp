// Decorated cantilevers: beam, scales, defect.

#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "commands/all_scales.hpp"
#include "sec3/array_impact.hpp"
#include "sec35/collision.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;
namespace fs = std::filesystem;

TEST_CASE("the clamped beam", "[unit][cantilever]") {
  check_close(std::cos(clamped_root()) * std::cosh(clamped_root()), 1, 1e-12);
  // Under a heavy mass the beam is a spring with 13/35 of its own mass (that of its static shape).
  const double x = ClampedBeam{400, 100}.wavenumber();
  check_close(x * x * x * x, 192 / (100 + 13. / 35), 0, 1e-5);
}

TEST_CASE("the vibration of a beam converges with order four", "[convergence][cantilever]") {
  const auto error = [](std::size_t steps) {
    return std::abs(ClampedBeam{steps}.wavenumber() - clamped_root());
  };
  check_close(std::log2(error(20) / error(40)), 4, 0.1);
}

TEST_CASE("scales belong together", "[unit][cantilever]") {
  const Scales s = CantileverArray{}.scales();
  // Eqs. (29) and (30): the dimensionless impact velocity is lambda^(5/2) for every V.
  for (double v : {0.1, 1.0, 3.0}) {
    const double lambda = s.lambda(v);
    check_close(StruckArray{.velocity = v}.struck_velocity(), lambda * lambda * std::sqrt(lambda),
                0, 1e-12);
  }
  check_close(s.gamma * s.xi() * std::sqrt(s.xi()), s.k * s.xi(), 0, 1e-12);
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

TEST_CASE("pushes of a passing packet", "[unit][cantilever]") {
  std::vector<double> t, f;
  for (int k = 0; k < 4000; ++k) {
    t.push_back(0.01 * k);
    const double swing = std::cos(5 * (t.back() - 20.3)), far = t.back() - 20.3;
    f.push_back(3 * std::exp(-far * far / 8) * std::max(0.0, swing));
  }
  const auto push = strongest_push(t, f);
  REQUIRE(push);
  check_close(push->t, 20.3, 1e-6);
  check_close(push->force, 3, 1e-6);
  check_close(push->period, 2 * 3.14159265358979 / 5, 0, 2e-2);
  const double longest = time_above(t, f, 3e-3), shorter = time_above(t, f, 0.3);
  CHECK(longest > shorter);
  const double envelope =
      2 * std::sqrt(8 * std::log(1000.));  // less than a period is lost at each end
  CHECK(longest < envelope);
  CHECK(longest > envelope - 2 * push->period);
  CHECK(time_above(t, f, 4) == 0);
  CHECK_FALSE(strongest_push(t, std::vector<double>(t.size(), 0.0)));
  const auto up = upward_crossings({0, 1, 2, 3}, {-1, 3, -1, 1});
  REQUIRE(up.size() == 2);
  check_close(up[0], 0.25, 1e-15);
  check_close(up[1], 2.5, 1e-15);
}

TEST_CASE("two beads collide, and a cradle's ratio", "[unit][cantilever]") {
  const Collision by_energy = collision_by_energy();
  // The integral of ds / sqrt(1 - s^(5/2)) with 1 - s = u^2
  const double x = std::pow(5 / 8.0, 2 / 5.0);
  double time = 0;
  for (int k = 0; k < 4000; ++k) {
    const double u = (k + 0.5) / 4000, s = 1 - u * u;
    time += 2 * u / std::sqrt(1 - s * s * std::sqrt(s)) / 4000;
  }
  check_close(by_energy.compression, x, 1e-14);
  check_close(by_energy.contact_time, 2 * x * time, 1e-6);
  check_close(cradle(9.81, 2.43), std::pow(0.5 / 9.81, 2.5) * std::pow(2.43 / 0.077e-3, 5), 0,
              1e-12);
}

TEST_CASE("the table of scales has its closed forms", "[unit][cantilever]") {
  const Table table = AllScales{.velocity = 2}.table();
  std::map<std::string, double> value;
  const auto names = table.texts("quantity");
  for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = table.numbers("value")[i];
  const CantileverArray array;
  const Scales s = array.scales();
  const Collision hit = collision_by_energy();
  const double V = 2, tau = std::pow(s.m * s.m / (s.gamma * s.gamma * V), 0.2);
  check_close(value.at("impact_velocity"), 2, 0);
  check_close(value.at("contact_time"), hit.contact_time * tau, 0, 1e-12);
  check_close(value.at("max_compression"), hit.compression * std::pow(s.m * V * V / s.gamma, 0.4),
              0, 1e-12);
  check_close(value.at("cradle_lambda_5_2"), cradle(9.81, hit.contact_time), 0, 1e-12);
  const double gamma = 193e9 * std::sqrt(2 * 2.38e-3) / 3 / (1 - 0.46 * 0.46);
  check_close(value.at("gamma_with_beam_modulus"), gamma, 0, 1e-12);
  check_close(value.at("lambda_with_beam_modulus"),
              s.m / s.k * std::pow(gamma * gamma * V / s.m / s.m, 0.4), 0, 1e-12);
}

TEST_CASE("units of an array, there and back", "[unit][cantilever]") {
  const CantileverArray array;
  const Scales s = array.scales();
  check_close(s.milliseconds(s.time(2.5)), 2.5, 1e-12);
  check_close(s.time(1), 1e-3 / s.tau_c(), 0, 1e-12);
  check_close(s.hertz(s.omega(7000)), 7000, 0, 1e-12);
  check_close(s.omega(7000), 2 * std::numbers::pi * 7000 * std::sqrt(s.m / s.k), 0, 1e-12);
  check_close(s.micrometres(2), 2e6 * (s.k / s.gamma) * (s.k / s.gamma), 0, 1e-12);
  check_close(s.velocity(3), 3 * s.tau_c() / s.xi(), 0, 1e-12);
  check_close(s.per_second(2), 2 / s.tau_c(), 0, 1e-12);
  check_close(s.watts(2), 2 * s.k * s.xi() * s.xi() / s.tau_c(), 0, 1e-12);
  check_close(s.unit_force(), s.k * s.xi(), 0, 1e-12);
  check_close(s.rate(10), s.tau_c() / 10e-3, 0, 1e-12);
  CHECK(s.rate(0) == 0);
  check_close(s.tau_h(2), std::pow(s.m * s.m / (s.gamma * s.gamma * 2), 0.2), 0, 1e-12);
  check_close(s.delta(2), std::pow(s.m * 4 / s.gamma, 0.4), 0, 1e-12);
  check_close(array.area_moment(), 5e-3 * 1e-9 / 12, 0, 1e-12);
  check_close(array.beam_mass(), 8e3 * 5e-3 * 1e-3 * 25e-3, 0, 1e-12);
  check_close(array.bead_mass(1.5), 4 * std::numbers::pi / 3 * 2.2e3 * std::pow(1.5 * 2.38e-3, 3),
              0, 1e-12);
}
