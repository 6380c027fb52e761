// Decorated cantilevers: beam, scales, defect, budget, trapped mode, and maps computed in parts.

#include <filesystem>
#include <fstream>

#include "check.hpp"
#include "report/sweep.hpp"
#include "run.hpp"
#include "sec36/defect_mode.hpp"

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
  CHECK_FALSE(holds(almost_total({large.net_reflected, none.net_reflected})));
  CHECK_FALSE(holds(almost_total({large.net_reflected, slight.net_reflected})));
  CHECK(none.net_transmitted.value > 0.95);
  CHECK(large.net_reflected.value > 0.95);
  CHECK(slight.net_reflected.value > 0.1);
  CHECK(slight.net_transmitted.value > 0.1);
}

TEST_CASE("the shared way to the defect changes nothing", "[property][cantilever]") {
  const StruckArray blow = short_array();
  const Scattering there = scatter(blow, 1.6, approach(blow, 0.05), 0.05, 28);
  const ImpactRun run = strike(ContactAware{0.05}, blow.impact(1.6, 28, blow.scales.time(28)));
  const Division straight = division_of(blow, run.density);
  check_close(there.later.reflected, straight.reflected, 1e-8);
  check_close(there.later.transmitted, straight.transmitted, 1e-8);
}

TEST_CASE("each mark of a trapped mode can fail", "[unit][cantilever]") {
  Stay without{{75, 100}, {1e-3, 1e-3}, std::vector<double>(21, 0.1)};
  Stay good{{75, 100}, {1e-2, 0.99e-2}, std::vector<double>(21, 0.0)};
  good.density[10] = 1;
  const auto stays = [&](const Stay& s) {
    return holds(trapped_at(10, {s, s}, {without, without}));
  };
  CHECK(stays(good));
  Stay leaving = good, faint = good, beside = good;
  leaving.near[1] = 0.7e-2;
  CHECK_FALSE(stays(leaving));
  faint.near = {0.9e-3, 0.9e-3};
  CHECK_FALSE(stays(faint));
  beside.density[7] = 2;
  CHECK_FALSE(stays(beside));
  CHECK_FALSE(holds(trapped_at(10, {leaving, good}, {without, without})));
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
  evolve(ContactAware{0.01}, problem.chain, end, period, period, Unobserved{});
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

TEST_CASE("an interrupted map goes on where it stopped", "[unit][cantilever]") {
  Scratch folder;
  Sweep first = squares(folder.path);
  CHECK(work(first, {1, 2}) == 5);
  const auto file = fs::directory_iterator(folder.path)->path();
  fs::resize_file(file, fs::file_size(file) - 4);  // cut in the middle of the last row
  Sweep second = squares(folder.path);
  CHECK(second.known() == 4);
  CHECK(work(second, {}) == 6);
  Sweep other = squares(folder.path, "cubes");
  CHECK(other.known() == 0);
}

TEST_CASE("a row that was changed by hand is computed again", "[unit][cantilever]") {
  Scratch folder;
  Sweep first = squares(folder.path);
  const std::size_t all = work(first, {});
  const auto file = fs::directory_iterator(folder.path)->path();
  std::ifstream in(file);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto at = text.find("\n3,3,3,");
  REQUIRE(at != std::string::npos);
  text[at + 5] = '4';
  write_whole(file, text);
  CHECK(squares(folder.path).known() == all - 1);
}

TEST_CASE("without a folder a map keeps nothing", "[unit][cantilever]") {
  Sweep sweep = squares("");
  const std::size_t all = work(sweep, {});
  CHECK(sweep.known() == all);
  CHECK(sweep.table().rows.size() == all);
  sweep.forget();
  CHECK(squares("").known() == 0);
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
