// Lines of the library that no other test would miss: ends of chains, members before anything happens, bounds.

#include <limits>

#include "check.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/events/location.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/accuracy.hpp"
#include "lattice/integrators/driven_chain.hpp"
#include "lattice/model/cantilever.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/model/quasi_continuum.hpp"
#include "lattice/model/typed.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/orbits/other_chains.hpp"
#include "sec3/breather_like.hpp"

namespace library_again {

using namespace lattice;

namespace {

/// Positions, velocities and area after one step, from those in `z`.
std::vector<double> stepped(const Chain& chain, std::vector<double> z, double dt) {
  Leapfrog<double>(chain, false).step(z, dt);
  return z;
}

}  // namespace

TEST_CASE("the probe is the derivative of a step, on every site of every kind of chain",
          "[unit][tangent]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (std::size_t n : {1U, 2U, 3U, 6U})
      for (bool heavy : {false, true}) {
        if (ends == Ends::periodic && n < 3) continue;
        Chain chain{.sites = n, .well = Quartic{0.7}, .ends = ends};
        std::vector<double> mass(n), z;
        for (std::size_t i = 0; i < n; ++i) mass[i] = 1 + 0.3 * double(i);
        if (heavy) vary(chain, mass, {});
        for (std::size_t i = 0; i < 2 * n; ++i) z.push_back(std::sin(3.0 * double(i) + 0.4));
        z.push_back(0);
        // The probe, and the step from two neighbours along it
        std::vector<double> with = z, ahead = z, behind = z;
        const double change = 1e-6, dt = 0.1;
        for (std::size_t i = 0; i < 2 * n; ++i) {
          const double u = std::cos(2.0 * double(i) + 0.1);
          with.push_back(u), ahead[i] += change * u, behind[i] -= change * u;
        }
        Leapfrog<double>(chain, true).step(with, dt);
        const auto more = stepped(chain, ahead, dt), less = stepped(chain, behind, dt);
        CAPTURE(n, int(ends), heavy);
        for (std::size_t i = 0; i < 2 * n; ++i)
          check_close(with[2 * n + 1 + i], (more[i] - less[i]) / (2 * change), 1e-8);
      }
}

TEST_CASE("a flow that has not begun has done nothing", "[unit][tangent]") {
  const FlowReport<double> none;
  CHECK((none.switchings == 0 && none.unlanded == 0 && none.steps == 0 && none.evaluations == 0));
  CHECK((none.error == 0 && none.energy_drift == 0 && none.area == 0));
  const Chain chain{3};
  Leapfrog<double> leapfrog(chain, false);
  CHECK(leapfrog.evaluations == 0);
  std::vector<double> z(7);
  leapfrog.step(z, 0.1);
  CHECK(leapfrog.evaluations == 1);
  CHECK(Crossing<double>(chain, {}, 1).evaluations == 0);
  const EventTolerance<double> usual;
  check_close(usual.tolerance, 128 * std::numeric_limits<double>::epsilon(), 0);
  CHECK((usual.floor == -1 && usual.sight == 0.05 && usual.levels == 9));
}

TEST_CASE("the history of steps says which broke, which held and how far they were apart",
          "[unit][accuracy]") {
  Attempts all;
  Run broken, good;
  broken.escape_time = 3, broken.leave_time = std::numeric_limits<double>::infinity();
  broken.energy_defect = 1;
  REQUIRE(broken.broken());
  all.add(0, broken, 0);
  CHECK(all.held < 0);
  all.add(1, good, 0);
  CHECK(all.held == 0);
  all.add(2, good, 0.5);
  CHECK(all.held == 1);
  CHECK(all.history.find("breaks at t = 3") != std::string::npos);
  CHECK(all.history.find(": holds") != std::string::npos);
  CHECK(all.history.find(": 0.5") != std::string::npos);
  CHECK(all.history.find("breaks") < all.history.find("holds"));
}

TEST_CASE("what is said of breathers in words fails just beyond its bounds", "[unit][orbits]") {
  // The value is at the same time its error
  CHECK(holds(symmetric_by_nature(1e-7, 0.49e-9)));
  CHECK_FALSE(holds(symmetric_by_nature(1e-7, 0.51e-9)));
  CHECK(holds(symmetric_by_nature(1e-9, 0.49e-10)));
  CHECK_FALSE(holds(symmetric_by_nature(1e-9, 0.51e-10)));
  CHECK(holds(super_exponential(1.499, 1.502)));
  CHECK_FALSE(holds(super_exponential(1.498, 1.502)));  // 0.002 off, and 0.004 from the site before
  CHECK_FALSE(holds(super_exponential(1.506, 1.506)));
  CHECK_FALSE(holds(super_exponential(1.494, 1.494)));
  CHECK(holds(worse_when_large({1, 0.1}, {1.21, 0.1})));
  CHECK_FALSE(holds(worse_when_large({1, 0.1}, {1.19, 0.1})));
  CHECK_FALSE(holds(worse_when_large({1.21, 0.1}, {1, 0.1})));
}

TEST_CASE("the discrete gradient, its direction, and how many sites a tail needs",
          "[unit][orbits]") {
  const Vector<double> g = gradient({1, 2, 4, 8, 16});
  CHECK(g == (Vector<double>(5) << 0, 3, 6, 12, 0).finished());
  check_close(alignment(g, -2 * g), 1, 1e-15);
  check_close(alignment(Vector<double>::Unit(5, 1), Vector<double>(g)), 3 / std::sqrt(189.0),
              1e-15);
  // A tail of which the power 3/2 is below the precision times (omega^2 - 1) times the amplitude
  Orbit<double> orbit;
  orbit.omega = 1.5, orbit.amplitude = 0.8;
  const double bound = 1e-6 * 1.25 * 0.8, edge = std::pow(bound, 2.0 / 3);
  const auto needed = [&](std::vector<double> y) {
    orbit.start.y = std::move(y);
    return sites_needed(orbit, 1e-6);
  };
  const double weak = 0.99 * edge, strong = 1.01 * edge;
  CHECK(needed({0, weak, strong, 1, -1, -strong, -weak, 0}) == 6);
  CHECK(needed({0, 0, weak, strong, 1, -1, -strong, -weak, 0, 0}) == 6);
  CHECK(needed({0, weak, weak, 1, -1, -strong, -weak, 0}) == 6);  // both ends have to be weak
  CHECK(needed({0, weak, strong, 1, -1, -weak, -weak, 0}) == 6);
  CHECK(needed({0, strong, 1, -1, -strong, 0}) == 6);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0, 0}) == 4);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0}) == 3);
}

TEST_CASE("a breather far up its branch is the same on chains that are shorter or longer",
          "[property][orbits]") {
  const double omega = 1.15;
  REQUIRE(omega > direct_up_to);
  const auto middle = [](const Fitted& f) { return f.orbit.start.y[f.problem.chain.sites / 2]; };
  for (Centre centre : both_centres) {
    const std::size_t odd = centre == Centre::site;
    const auto fitted = [&](std::size_t sites) {
      return fit_chain(centre, omega, Harmonic{}, sites, 16 + odd, 1e-10, Phase::compressed);
    };
    const Fitted usual = fitted(0), longer = fitted(40 + odd);
    CHECK(usual.problem.chain.sites == 16 + odd);
    CHECK(longer.problem.chain.sites == 40 + odd);
    check_close(longer.orbit.energy, usual.orbit.energy, 0, 1e-9);
    check_close(middle(longer), middle(usual), 0, 1e-9);
    CHECK_THROWS_AS(fitted(4 + odd), ShortChain);
  }
}

TEST_CASE("the approximate breather has the signs of its phase", "[unit][orbits]") {
  const double scale = 2 * breather_eps(1.1);
  for (std::size_t sites : {9U, 10U}) {
    const Centre centre = sites % 2 ? Centre::site : Centre::bond;
    const State<double> one = ansatz(centre, 1.1, sites),
                        other = ansatz(centre, 1.1, sites, Phase::stretched);
    for (std::size_t i = 0; i < sites; ++i) {
      check_close(one.y[i], scale * quasi_continuum(centre, site_number(i, sites)), 1e-15);
      CHECK(other.y[i] == -one.y[i]);
    }
  }
  CHECK_THROWS_AS(ansatz(Centre::site, 1.1, 9, Phase::compressed, PowerContact{.exponent = 1}),
                  std::invalid_argument);
}

TEST_CASE("a pair takes its values from the finer resolution and its errors from both",
          "[unit][orbits]") {
  BreatherPair pair{
      0.0,
      1.1,
      {find_breather(problem_of(Centre::site, 1.1)), find_breather(problem_of(Centre::bond, 1.1))}};
  const Measured<double> fine(pair, 0);
  Measured<double> coarse = fine;
  check_close(fine.orbit[0].energy, pair.orbit[0].energy, 0, 1e-12);
  check_close(fine.gap.equal_frequency, fine.orbit[0].energy - fine.orbit[1].energy, 0);
  // Every number of the coarser one is off by a part of its own
  for (int k : {0, 1}) coarse.orbit[k].energy *= 1.01 + k, coarse.orbit[k].amplitude *= 1.02 + k;
  for (int k : {0, 1}) coarse.orbit[k].energy_omega *= 1.03 + k;
  coarse.gap.equal_frequency *= 5, coarse.gap.equal_area *= 6, coarse.gap.omega_site += 0.01;
  assess(pair, coarse, fine);
  const double rounding = 2048 * std::numeric_limits<double>::epsilon();
  const auto is = [&](const Estimate& found, double value, double other, double size) {
    check_close(found.value, value, 0, 1e-15);
    check_close(found.error, std::abs(value - other) + rounding * std::abs(size), 0, 1e-12);
  };
  for (int k : {0, 1}) {
    const auto &a = coarse.orbit[k], &b = fine.orbit[k];
    is(pair.energy[k], b.energy, a.energy, b.energy);
    is(pair.amplitude[k], b.amplitude, a.amplitude, b.amplitude);
  }
  const double energy = fine.orbit[1].energy, slope = fine.orbit[1].energy_omega;
  is(pair.equal_frequency, fine.gap.equal_frequency, coarse.gap.equal_frequency, energy);
  is(pair.equal_area, fine.gap.equal_area, coarse.gap.equal_area, energy / 4);
  is(pair.slope, fine.orbit[0].energy_omega - slope,
     coarse.orbit[0].energy_omega - coarse.orbit[1].energy_omega, slope);
  is(pair.slope_area, slope * (fine.gap.omega_site / 1.1 - 1),
     coarse.orbit[1].energy_omega * (coarse.gap.omega_site / 1.1 - 1), slope);
  CHECK_FALSE(pair.wide);
  // Two tolerances are two computations: errors are larger than rounding alone
  BreatherPair both = pair;
  measure_in<double>(both);
  CHECK(both.energy[0].error > rounding * both.energy[0].value);
  CHECK(settled({1, 2.9e-3}));
  CHECK_FALSE(settled({-1, 3.1e-3}));
  measure_once<double>(both);
  check_close(both.energy[0].error, rounding * both.energy[0].value, 0, 1e-12);
}

TEST_CASE("frequencies of pairs, up to where branches fold", "[unit][orbits]") {
  CHECK(pair_frequencies(0, 4) == std::vector{1.005, 1.25, 1.5, 1.75, 2.0});
  const auto soft = pair_frequencies(-0.1, 4);
  const std::vector<double> expected{1.005, 1.25, 1.5, 1.75, 1.85, 1.9};
  REQUIRE(soft.size() == expected.size());
  for (std::size_t k = 0; k < soft.size(); ++k) check_close(soft[k], expected[k], 1e-15);
  // A pair in between lies on both branches
  const auto at = [](double omega) {
    return BreatherPair{0,
                        omega,
                        {find_breather(problem_of(Centre::site, omega)),
                         find_breather(problem_of(Centre::bond, omega))}};
  };
  const BreatherPair between = pair_between(at(1.02), at(1.08), 1.05);
  for (int k : {0, 1}) check_close(between.orbit[k].energy, at(1.05).orbit[k].energy, 0, 1e-8);
}

TEST_CASE("a flow as a stepper counts the forces on all sites", "[unit][tangent]") {
  const Chain chain{5};
  State<double> one = struck(5, 0.3), other = one;
  Window window{0, 5};
  const double work = EventDriven{0.5}.advance(chain, one, window, 0.5, 3);
  const auto report = flow(chain, other, 1.5);
  CHECK(work == double(5 * report.evaluations));
  CHECK(largest_difference(one, other) == 0);
}

TEST_CASE("chains longer than a block of the loops, whatever they are made of", "[unit][chain]") {
  const std::size_t n = 150;
  std::vector<double> y(n), mass(n), eta(n + 1);
  for (std::size_t i = 0; i < n; ++i)
    y[i] = std::sin(0.7 * double(i * i)), mass[i] = 1 + 0.5 * std::cos(double(i));
  for (std::size_t i = 0; i <= n; ++i) eta[i] = 1 + 0.4 * std::sin(double(i));
  eta[0] = eta[n];
  const auto force = [](double x) { return x > 0 ? x * std::sqrt(x) : 0; };
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (bool varied : {false, true}) {
      Chain chain{.sites = n, .well = Quartic{0.3}, .ends = ends};
      if (varied) vary(chain, mass, eta);
      const std::vector<long double> wide(y.begin(), y.end());
      const auto a = accelerations(chain, y);
      const auto b = accelerations(chain, wide);
      for (std::size_t i = 0; i < n; ++i) {
        const auto push = [&](std::size_t k) {
          const double before = k > 0                    ? y[k - 1]
                                : ends == Ends::periodic ? y[n - 1]
                                                         : 0,
                       behind = k < n                    ? y[k]
                                : ends == Ends::periodic ? y[0]
                                                         : 0;
          if ((k == 0 || k == n) && ends == Ends::free) return 0.0;
          return force(before - behind) * (varied ? eta[k] : 1);
        };
        const double expected =
            (-y[i] - 0.3 * y[i] * y[i] * y[i] + push(i) - push(i + 1)) / (varied ? mass[i] : 1);
        check_close(a[i], expected, 1e-13);
        check_close(double(b[i]), expected, 1e-13);
      }
    }
}

TEST_CASE("a sweep asks for contacts inside the chain and for no others", "[unit][chain]") {
  struct Along {
    std::size_t sites;
    double contact(std::size_t i, double push) const {
      CHECK((i >= 1 && i < sites));
      return push;
    }
    double bead(std::size_t, double force) const { return force; }
  };
  for (std::size_t n : {3U, 64U, 65U, 150U}) {
    const std::vector<double> y(n + 2, 0.1);  // longer than what is swept
    std::size_t beads = 0;
    detail::sweep_blocks<double>(Quartic{0.3}, Hertz{}, y.data(), Along{n}, n, 0.0, 0.0,
                                 [&](std::size_t, double) { ++beads; });
    CHECK(beads == n);
  }
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
  // Beams of steel and beads of teflon, as section 3.6 has them
  CHECK((array.sites == 200 && array.defect == 100 && array.beam_share == 0.38));
  CHECK((array.beam_density == 8e3 && array.beam_modulus == 193e9 && array.length == 25e-3 &&
         array.width == 5e-3 && array.thickness == 1e-3));
  CHECK((array.bead_density == 2.2e3 && array.bead_modulus == 1.46e9 && array.nu == 0.46 &&
         array.radius == 2.38e-3));
  check_close(array.area_moment(), 5e-3 * 1e-9 / 12, 0, 1e-12);
  check_close(array.beam_mass(), 8e3 * 5e-3 * 1e-3 * 25e-3, 0, 1e-12);
  check_close(array.bead_mass(1.5), 4 * pi<double>() / 3 * 2.2e3 * std::pow(1.5 * 2.38e-3, 3), 0,
              1e-12);
}

TEST_CASE("a chain runs with the length of its masses and in states of that length only",
          "[unit][chain]") {
  Chain twelve{12};
  vary(twelve, std::vector<double>(12, 1), {});
  const auto refused = [](const Chain& chain, const State<double>& start) {
    State<double> state = start;
    CAPTURE(chain.sites, chain.mass.size(), state.y.size());
    CHECK_THROWS_AS(energy_density(chain, state), std::invalid_argument);
    CHECK_THROWS_AS(evolve(ContactAware{0.1}, chain, state, 1, 1, Unobserved{}),
                    std::invalid_argument);
    CHECK_THROWS_AS(flow<double>(chain, state, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(run_driven({chain, {}, {}}, state, time_grid(1, 1, 0.1),
                               [](const auto&, const auto&) { return true; }),
                    std::invalid_argument);
    if (state.y.size() == chain.mass.size()) return;
    CHECK_THROWS_AS(accelerations(chain, state.y), std::invalid_argument);
    CHECK_THROWS_AS(contact_forces(chain, state.y), std::invalid_argument);
    CHECK_THROWS_AS(linearise(chain, state.y), std::invalid_argument);
  };
  for (const std::size_t sites : {8, 13, 136}) {
    Chain other = twelve;
    other.sites = sites;
    refused(other, struck(sites, 1));
    refused(twelve, struck(sites, 1));
    refused(Chain{12}, struck(sites, 1));
    CHECK_THROWS_AS(lengthened(other, sites + 2), std::invalid_argument);
    CHECK_THROWS_AS(between(other, Chain{sites}, 0.5), std::invalid_argument);
    CHECK_THROWS_AS(between(Chain{sites}, other, 1), std::invalid_argument);
  }
  State<double> torn = struck(12, 1);
  torn.v.pop_back();
  refused(twelve, torn);
  // Masses without stiffnesses, and the other way round
  Chain half{12};
  half.mass = half.inverse_mass = twelve.mass;
  refused(half, struck(12, 1));
  half.mass = half.inverse_mass = {}, half.eta = twelve.eta;
  refused(half, struck(12, 1));
  // Nor is it made longer; as it is it has the bits of a chain without masses
  CHECK_THROWS_AS(endless({1, twelve, 20}), std::invalid_argument);
  const Impact plain{1, {12}, 20, 0.2, may_move}, heavy{1, twelve, 20, 0.2, may_move};
  CHECK(strike(ContactAware{0.1}, plain).end.y == strike(ContactAware{0.1}, heavy).end.y);
}

}  // namespace library_again
