// Decorated cantilevers: beam, scales, defect, budget, trapped mode, and maps computed in parts.

#include <filesystem>
#include <fstream>
#include <map>

#include "check.hpp"
#include "commands/all_scales.hpp"
#include "report/sweep.hpp"
#include "run.hpp"
#include "sec35/collision.hpp"
#include "sec36/defect_mode.hpp"
#include "sec36/trapped_mode.hpp"

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

namespace {

/// A short array whose packet meets the defect early.
StruckArray short_array() {
  StruckArray blow;
  blow.array.sites = 72;
  blow.array.defect = 32;
  return blow;
}

}  // namespace

TEST_CASE("the energy budget closes and knows a defect from none", "[property][cantilever]") {
  const ScatteringSetup at(short_array(), {0.1, 0.05}, 28);
  const Fractions none = fractions(at, 1), large = fractions(at, 1.6), slight = fractions(at, 1.1);
  for (const Fractions* f : {&none, &large, &slight}) {
    check_close(f->reflected.value + f->near.value + f->transmitted.value, 1, 2e-9);
    check_close(f->net_reflected.value + f->net_near.value + f->net_transmitted.value, 1, 2e-8);
    CHECK(f->net_reflected.error < 1e-7);
  }
  check_close(none.net_reflected.value, 0, 1e-12);
  CHECK(none.net_transmitted.value > 0.95);
  CHECK(large.net_reflected.value > 0.95);
  CHECK(slight.net_reflected.value > 0.1);
  CHECK(slight.net_transmitted.value > 0.1);
}

TEST_CASE("the shared way to the defect changes nothing", "[property][cantilever]") {
  const StruckArray blow = short_array();
  const Scattering there = scatter(blow, 1.6, approach(blow, 0.05), 0.05, 28);
  const ImpactRun run = strike(EventCorrected{0.05}, blow.impact(1.6, 28, blow.scales.time(28)));
  const EnergyShares straight = energy_shares(blow, run.density);
  check_close(there.later.reflected, straight.reflected, 1e-8);
  check_close(there.later.transmitted, straight.transmitted, 1e-8);
}

TEST_CASE("the mode of a light defect is a breather", "[property][cantilever]") {
  const CantileverArray array;
  const Shooting<double> problem = mode_problem(array, 0.925);
  const Orbit<double> orbit = mode_of_energy(problem, 1e-5);
  check_close(orbit.energy, 1e-5, 0, 1e-9);
  CHECK(orbit.residual() < 1e-12);
  CHECK(orbit.omega > array.linear_frequency(0.925));
  State<double> end = orbit.start;
  const double period = 2 * 3.141592653589793 / orbit.omega;
  evolve(EventCorrected{0.01}, problem.chain, end, period, period);
  for (std::size_t n = 0; n < mode_sites; ++n) {
    check_close(end.y[n], orbit.start.y[n], 1e-9);
    check_close(end.v[n], 0, 1e-9);
  }
  const auto e = energy_density(problem.chain, orbit.start);
  CHECK(e[mode_sites / 2] > 0.5 * orbit.energy);
  CHECK(e.front() < 1e-12 * orbit.energy);
}

namespace {

Sweep squares(const fs::path& folder, const std::string& parameters = "squares") {
  return {folder,
          "squares",
          {number("x", "root"), number("y", "a third of its square")},
          10,
          parameters};
}

/// Computes a part and counts the points that had to be computed.
std::size_t work(Sweep& sweep, Part part) {
  std::atomic<std::size_t> count{0};
  sweep.compute(part, [&](std::size_t i) {
    ++count;
    return Cells{double(i), double(i * i) / 3};
  });
  return count;
}

}  // namespace

TEST_CASE("parts of a map merge to the same bytes", "[unit][cantilever]") {
  Scratch whole, parts;
  Sweep all = squares(whole.path);
  CHECK(work(all, {}) == 10);
  for (std::size_t k : {3, 1, 2}) {
    Sweep one = squares(parts.path);
    CHECK(work(one, {k, 3}) == (k == 1 ? 4 : 3));
    CHECK(one.known({k, 3}) == one.size({k, 3}));
  }
  Sweep merged = squares(parts.path);
  CHECK(work(merged, {}) == 0);
  CHECK(to_text(merged.table()) == to_text(all.table()));
  merged.forget();
  CHECK(parts.empty());
}

TEST_CASE("a row that failed is not kept", "[unit][cantilever]") {
  Scratch folder;
  Sweep sweep = squares(folder.path);
  CHECK_THROWS_AS(sweep.compute({},
                                [](std::size_t i) {
                                  if (i == 4) throw std::runtime_error("no");
                                  return Cells{double(i), 1.0};
                                }),
                  std::runtime_error);
  CHECK(squares(folder.path).known() < 10);
}

TEST_CASE("parts are written k/n", "[unit][cantilever]") {
  CHECK(parse_part("2/8").index == 2);
  for (const char* bad :
       {"", "0/3", "4/3", "1", "1/", "a/b", "1/2/3", "-1/2", "1/0", " 1/2", "1/999999"})
    CHECK_THROWS_AS(parse_part(bad), std::invalid_argument);
}

namespace {

using Numbers = std::vector<double>;

const double half_turn = std::acos(-1.0);

double metres(const StruckArray& blow) {
  return std::pow(blow.scales.k / blow.scales.gamma, 2);
}

double sum_of(const Numbers& e, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t n = from; n < to; ++n) sum += e[n];
  return sum;
}

}  // namespace

TEST_CASE("the mode of a light defect by plain formulas", "[unit][cantilever]") {
  const CantileverArray array;
  const Shooting<double> problem = mode_problem(array, 0.9);
  CHECK((mode_sites == 31 && problem.chain.sites == 31));
  for (std::size_t n = 0; n < 31; ++n)
    check_close(problem.chain.mass_of(n), n == 15 ? array.mu(0.9) : 1, 1e-15);
  for (std::size_t i = 0; i <= 31; ++i)
    check_close(problem.chain.eta_of(i), i == 15 || i == 16 ? std::sqrt(1.8 / 1.9) : 1, 1e-15);
  CHECK(problem.chain.contact.force(-1e-100) > 0);
  const Orbit<double> orbit = mode_of_energy(problem, 2e-4);
  check_close(orbit.energy, 2e-4, 0, 2e-10);
  Shooting<double> there = problem;
  there.omega = orbit.omega;
  check_close(newton(there, orbit.x).energy, 2e-4, 0, 1e-9);
  CHECK(orbit.start.y[15] > 0);
  CHECK_THROWS_AS(mode_of_energy(problem, 1e-40), std::runtime_error);

  Numbers mean(31, 0);
  State<double> now = orbit.start;
  for (int k = 0; k <= 5; ++k) {
    const Numbers e = energy_density(problem.chain, now);
    for (std::size_t n = 0; n < 31; ++n) mean[n] += e[n] / 6;
    evolve(EventCorrected{0.05}, problem.chain, now, 2 * half_turn / orbit.omega / 5, 9);
  }
  const Numbers found = mean_density(problem, orbit, 5);
  for (std::size_t n = 0; n < 31; ++n) check_close(found[n], mean[n], 1e-13);
  Stay stay;
  for (int n = 0; n < 200; ++n) stay.density.push_back(1 + 0.1 * (n % 7));
  const Profile shares = profile(array, problem, orbit, stay, 5);
  REQUIRE((shares.run.size() == 9 && shares.mode.size() == 9));
  double apart = 0;
  for (std::size_t n = 0; n < 9; ++n) {
    const double run = stay.density[95 + n] / sum_of(stay.density, 95, 104),
                 mode = mean[11 + n] / sum_of(mean, 11, 20);
    check_close(shares.run[n], run, 1e-13);
    check_close(shares.mode[n], mode, 1e-11);
    apart += std::abs(run - mode);
  }
  check_close(shares.overlap(), 1 - apart / 2, 1e-11);

  const StruckArray blow;
  const Table table = trapped::mode_table(blow, shares, orbit);
  REQUIRE(table.rows.size() == 9);
  CHECK(table.numbers("n")[0] == 96);
  check_close(table.numbers("run")[3], shares.run[3], 1e-15);
  check_close(table.numbers("mode")[3], shares.mode[3], 1e-15);
  check_close(table.numbers("y")[5], orbit.start.y[16] * metres(blow) * 1e6, 0, 1e-12);
  CHECK(table.numbers("n")[8] == 104);
  const auto left = trapped::mode_residuals<double>(there, orbit);
  there.symmetry = site_centred(31);
  const double asymmetry =
      there.evaluate(there.reduce(orbit.start), {}, false).residual.cwiseAbs().maxCoeff();
  CHECK(left[0] < 1e-11);
  CHECK(left[1] > 0.03 * asymmetry / orbit.amplitude);
  CHECK(left[1] < 30 * asymmetry / orbit.amplitude);
}

TEST_CASE("the frequency of what stays, from the first upward passage to the last",
          "[unit][cantilever]") {
  // At 0.5 and 4.25, with one between
  check_close(frequency_of({{0, 1, 2, 3, 4, 5, 6}, {}, {-1, 1, -1, 1, -1, 3, 1}, {}}),
              4 * half_turn / (4.25 - 0.5), 1e-13);
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
  check_close(s.omega(7000), 2 * pi<double>() * 7000 * std::sqrt(s.m / s.k), 0, 1e-12);
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
  check_close(array.bead_mass(1.5), 4 * pi<double>() / 3 * 2.2e3 * std::pow(1.5 * 2.38e-3, 3), 0,
              1e-12);
}
