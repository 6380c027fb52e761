// Section 3: the DpS error, travelling waves, the quasi-continuum profile, branches and chosen breathers.

#include <algorithm>
#include <complex>
#include <numbers>

#include "check.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "sec3/branches.hpp"
#include "sec3/breather_options.hpp"
#include "sec3/continuum.hpp"
#include "sec3/dps_error.hpp"
#include "sec3/travelling_wave.hpp"

namespace branches_again {

using namespace lattice;

namespace {

double push(double x) {
  return x > 0 ? x * std::sqrt(x) : 0;
}

Orbit<double> orbit_at(double omega, double amplitude) {
  Orbit<double> orbit;
  orbit.omega = omega, orbit.amplitude = amplitude;
  return orbit;
}

}  // namespace

TEST_CASE("the order of the DpS error may be off by 0.03", "[unit][criteria]") {
  for (double off : {0.029, -0.029}) CHECK(holds(order_stays({{1.5, 1e-4}, {1.5 + off, 1e-4}})));
  for (double off : {0.031, -0.031})
    CHECK_FALSE(holds(order_stays({{1.5, 1e-4}, {1.5 + off, 1e-4}})));
  CHECK_FALSE(holds(order_stays({{1.52, 0.011}})));
  const Criterion two = order_stays({{1.5, 0}, {1.6, 0}});
  CHECK((two.at(0).name == "order_off_1" && two.at(1).name == "order_off_2"));
}

TEST_CASE("the deviation of the DpS equation is that of two plain runs", "[unit][dps]") {
  // Five beads: chain and approximation by fourth-order steps
  const double eps = 1e-3, rate = 0.3, times[] = {0.3, 1.0};
  const Compared both{dps_impact(5), Quartic{-1}, rate};
  check_close(Compared{{}}.rate, 1 / (2 * tau_0()), 1e-15);
  using Complex = std::complex<double>;
  const auto slow = [&](const std::vector<Complex>& a) {
    std::vector<Complex> out(5);
    for (std::size_t n = 0; n < 5; ++n) {
      const Complex right = n < 4 ? a[n + 1] - a[n] : 0, left = n > 0 ? a[n] - a[n - 1] : 0;
      out[n] = Complex(0, -rate) *
               (right * std::sqrt(std::abs(right)) - left * std::sqrt(std::abs(left)));
    }
    return out;
  };
  const auto fast = [](const std::vector<double>& z) {
    std::vector<double> out(z.begin() + 5, z.end());
    for (std::size_t n = 0; n < 5; ++n)
      out.push_back(-z[n] + std::pow(z[n], 3) + (n > 0 ? push(z[n - 1] - z[n]) : 0) -
                    (n < 4 ? push(z[n] - z[n + 1]) : 0));
    return out;
  };
  const auto step = [](auto x, double h, auto f) {
    const auto at = [&](double by, const auto& k) {
      auto z = x;
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * k[i];
      return z;
    };
    const auto a = f(x), b = f(at(h / 2, a)), c = f(at(h / 2, b)), d = f(at(h, c));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += h / 6 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    return x;
  };
  // The samples are at most 0.2 apart, or half of that
  for (int halved : {0, 1}) {
    const double time = 1 / std::sqrt(eps);
    const int samples = int(std::ceil(time / 0.2)) << halved;
    const double h = time / samples;
    std::vector<Complex> a(5);
    a[0] = Complex(0, -1);
    std::vector<double> z(10, 0), most(2, 0);
    z[5] = 2 * eps;
    for (int k = 1; k <= samples; ++k) {
      for (int i = 0; i < 8; ++i) {
        a = step(a, h * std::sqrt(eps) / 8, slow);
        z = step(z, h / 8, fast);
      }
      double apart = 0;
      for (std::size_t n = 0; n < 5; ++n)
        apart = std::max(apart, std::abs(z[n] - 2 * eps * (a[n] * std::polar(1.0, h * k)).real()));
      for (std::size_t i : {0, 1})
        if (h * k * std::sqrt(eps) <= times[i] * (1 + 1e-9)) most[i] = std::max(most[i], apart);
    }
    const auto seen = deviations(both, eps, error_resolutions[halved], {0.3, 1.0});
    for (std::size_t i : {0, 1}) check_close(seen.at(i), most[i], 0, 1e-4);
  }
}

TEST_CASE("two resolutions tell how well a deviation is known", "[unit][dps]") {
  const double eps = 1e-3;
  const Compared both{dps_impact(5), Quartic{-1}, 0.3};
  CHECK((error_resolutions[0].halvings == 0 && error_resolutions[1].halvings == 1));
  const auto coarse = deviations(both, eps, {0, 1e-9}, {0.3, 1.0}),
             fine = deviations(both, eps, {1, 1e-11}, {0.3, 1.0});
  const auto refined = refined_deviations(both, eps, {0.3, 1.0});
  REQUIRE(refined.size() == 2);
  for (std::size_t i : {0, 1}) {
    CHECK(refined[i].value == fine[i]);
    CHECK(refined[i].error == compare(coarse[i], fine[i]).error);
  }
}

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

TEST_CASE("a profile is compared at every site, whatever its sign", "[unit][dps]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (double sign : {1.0, -1.0}) {
      Stationary<double> state{
          centre, 1, std::vector<double>(centre == Centre::site ? 7 : 8, 0), {}, {}};
      double apart = 0;
      for (std::size_t i = 0; i < state.u.size(); ++i) {
        state.u[i] = 0.1 * double(i);
        apart = std::max(apart, std::abs(0.1 * double(i) -
                                         quasi_continuum(centre, site_number(i, state.u.size()))));
      }
      check_close(continuum_difference(state), apart / (0.1 * double(state.u.size() - 1)), 1e-14);
      for (double& x : state.u) x *= sign;
      check_close(largest(state), 0.1 * double(state.u.size() - 1), 1e-15);
      state.u[0] = 5 * sign;
      CHECK(largest(state) == 5);
    }
}

TEST_CASE("arches, means and beginnings at both sides of their bounds", "[unit][criteria]") {
  check_close(growth_exponent(orbit_at(1.01, 3), orbit_at(1.05, 3 * std::pow(5, 1.3))), 1.3, 1e-12);
  for (double off : {0.049, -0.049}) CHECK(begins_at_rest({2 + off, 1e-4}).holds());
  for (double off : {0.051, -0.051}) CHECK_FALSE(begins_at_rest({2 + off, 1e-4}).holds());
  CHECK_FALSE(begins_at_rest({2, 0.051}).holds());
  // Three arches of heights 2, 5 and 9; the last but one value is the highest before the end
  const Criterion all =
      increasing_on_the_whole({{1, 0.1}, {2, 0.2}, {-5, 0.3}, {-4, 0.4}, {7, 0.5}, {9, 0.6}});
  REQUIRE(all.size() == 2);
  CHECK((all[0].name == "arches_least_ratio" && all[1].name == "end_over_highest_before"));
  check_close(all[0].value.value, 1.8, 1e-14);
  check_close(all[0].value.error, (0.6 + 1.8 * 0.3) / 5, 1e-14);
  check_close(all[1].value.value, 9.0 / 7, 1e-14);
  check_close(all[1].value.error, (0.6 + 9.0 / 7 * 0.5) / 7, 1e-14);
  const Criterion falling = increasing_on_the_whole({{1, 0}, {-3, 0}, {-2, 0}});
  check_close(falling.at(1).value.value, 2.0 / 3, 1e-14);
  CHECK(increasing_on_the_whole({{1, 0}, {3, 0}}).size() == 1);
  const Estimate mean = mean_size({{1, 0.1}, {-2, 0.2}, {3, 0.3}, {-6, 0.4}, {-5, 0.1}});
  check_close(mean.value, 17.0 / 5, 1e-14);
  check_close(mean.error, 17.0 / 5 - 3 + 1.1 / 5, 1e-14);
  const Condition smaller = smaller_on_the_whole("x", {{1, 0}, {1, 0}}, {{-1.25, 0}, {1.25, 0}});
  check_close(smaller.value.value, 0.8, 1e-14);
  CHECK((smaller.holds() && smaller.name == "x" && smaller.limit == 1));
}

TEST_CASE("energies that a residual hides, and a family in linear wells", "[unit][orbits]") {
  // By the square of the detuning: what differs by 2e-6 leaves twice as much as what differs by 1e-6
  auto problem = problem_of(Centre::site, 1.1);
  const Orbit<double> here = find_breather(problem);
  problem.omega = 1.1 + 1e-4;
  const Orbit<double> there = newton(problem, here.x);
  State<double> end = there.start;
  flow(problem.chain, end, 2 * std::numbers::pi / 1.1);
  double left = 0, top = 0;
  for (std::size_t n = 0; n < end.y.size(); ++n) {
    left = std::max(
        {left, std::abs(end.y[n] - there.start.y[n]), std::abs(end.v[n] - there.start.v[n])});
    top = std::max({top, std::abs(there.start.y[n]), std::abs(there.start.v[n])});
  }
  check_close(hidden_energy(1e-3, 1e-4), std::abs(there.energy - here.energy) * 1e-3 / (left / top),
              0, 1e-7);
  const Family family = family_from_rest(Centre::site, 0);
  CHECK((family.end.value == 2 && family.end.is_exact));
  std::vector<Orbit<double>> low = climb(Centre::site, 0, {1.0005, 1.001, 1.01});
  const double near = growth_exponent(low[0], low[1]), far = growth_exponent(low[1], low[2]);
  check_close(family.exponent.value, near, 1e-9);
  check_close(family.exponent.error, std::abs(near - far), 1e-9);
}

TEST_CASE("a breather is asked for by options, and refused where it does not fit", "[unit]") {
  ChosenBreather chosen;
  CHECK((chosen.centre == Centre::site && chosen.phase == Phase::compressed));
  CHECK((chosen.omega_b == 1.1 && chosen.sites == 0 && chosen.well.as<Quartic>().s == 0));
  Parameters p;
  chosen.parameters(p), chosen.add_phase(p);
  const auto complaint = [&](const std::string& value) {
    return p.find("omega")->check.complaint(value);
  };
  for (const char* good : {"1.0001", "3"}) CHECK(complaint(good).empty());
  for (const char* bad : {"1.00005", "1", "3.01"}) CHECK_FALSE(complaint(bad).empty());
  CHECK(breather_range(1.5, 2).least == 1.5);
  CHECK(breather_range(1.5, 2).most == 2);
  p.find("centre")->take("bond"), p.find("phase")->take("stretched");
  CHECK((chosen.centre == Centre::bond && chosen.phase == Phase::stretched));
  const auto make = [] { return 7; };
  const auto said = [&](Centre centre, std::size_t sites) {
    chosen.centre = centre, chosen.sites = sites;
    return refusal<UsageError>([&] { on_chosen_chain(chosen, make); });
  };
  for (std::size_t sites : {0, 8, 9}) {
    CHECK(said(Centre::site, sites).empty() == (sites != 8));
    CHECK(said(Centre::bond, sites).empty() == (sites != 9));
  }
  check_line(said(Centre::site, 8), "--sites: 8 does not fit --centre site (allowed: odd numbers)");
  check_line(said(Centre::bond, 9),
             "--sites: 9 does not fit --centre bond (allowed: even numbers)");
  chosen.centre = Centre::site, chosen.sites = 3;
  check_line(
      refusal<UsageError>([&] { on_chosen_chain(chosen, []() -> int { throw ShortChain(11); }); }),
      "--sites: 3 cannot hold this breather's tail (allowed: 11 or more)");
  chosen.sites = 0;
  const Fitted found = find_chosen(chosen, 1e-10);
  CHECK(found.problem.chain.sites == sites_of(Centre::site));
  CHECK(found.orbit.omega == 1.1);
}

}  // namespace branches_again
