// The chain: forces derive from the energy, contacts act on both sides, boundaries, masses, linearisation.

#include "lattice/model/chain.hpp"

#include "lattice/events/event_driven.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/quadruple/orbits.hpp"
#include "sec3/breather_like.hpp"
#include "support/check.hpp"
#include "support/states.hpp"

using namespace lattice;

namespace {

/// Chains of twelve beads with all ends, plain and varied.
template <class Check>
void for_all_ends(Check check) {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic}) {
    CAPTURE(int(ends));
    const Chain plain{12, Quartic{0.7}, {}, ends}, bare{12, NoWell{}, PowerContact{2, 0.2}, ends};
    std::vector<double> mass(12, 1), eta(13, 1);
    mass[5] = 2.5, mass[11] = 0.3;
    eta[5] = 1.3, eta[6] = 0.7;
    eta[0] = eta[12] = 1.6;
    const auto varied = [&](Chain chain, const auto& masses, const auto& etas) {
      vary(chain, masses, etas);
      check(chain);
    };
    check(plain);
    varied(plain, mass, eta);
    varied(plain, mass, std::vector<double>{});
    varied(plain, std::vector<double>{}, eta);
    varied(bare, mass, eta);
  }
}

}  // namespace

TEST_CASE("accelerations are minus the gradient of the energy over the mass", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto s = random_state(12);
    const auto wide = random_state<long double>(12);
    const auto a = accelerations(chain, s.y);
    const auto b = accelerations(chain, wide.y);
    for (std::size_t n = 0; n < 12; ++n) {
      CHECK(a[n] == acceleration(chain, s.y.data(), n));
      check_close(double(b[n]), a[n], 1e-14, 1e-14);
      // Difference quotients of the wide energy, to more digits than double has.
      const auto slope = [&](long double h) {
        State<long double> p = wide, q = wide;
        p.y[n] += h, q.y[n] -= h;
        return (energy(chain, p) - energy(chain, q)) / (2 * h);
      };
      const long double h = 1e-4L;
      const long double fine =
          (64 * slope(h / 4) - 20 * slope(h / 2) + slope(h)) / 45;  // error of order h^6
      check_close(double(b[n] * (long double)chain.mass_of(n) + fine), 0, 1e-13);
    }
    check_close(double(energy(chain, wide)), energy(chain, s), 0, 1e-14);
  });
}

TEST_CASE("the linearisation is the derivative of the force", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto y = random_state(12).y;
    const auto h = linearise(chain, y);
    for (std::size_t j = 0; j < 12; ++j) {
      auto p = y, q = y;
      p[j] += 1e-6, q[j] -= 1e-6;
      const auto a = accelerations(chain, p), b = accelerations(chain, q);
      for (std::size_t i = 0; i < 12; ++i) {
        double expected = 0;
        if (i == j)
          expected = h.diagonal[i];
        else if (i + 1 == j || j + 1 == i)
          expected = h.off[std::min(i, j)];
        else if (i + j == 11 && (i == 0 || j == 0))
          expected = h.off[11];
        check_close(-(a[i] - b[i]) / 2e-6 * chain.mass_of(i), expected, 1e-7, 1e-7);
      }
    }
  });
}

TEST_CASE("the energy density by hand", "[unit][formulas]") {
  State<double> s(3);
  s.y = {-1, -2, 4};
  s.v = {1, 2, -3};
  const auto check = [&](Ends ends, double first, double last, double push) {
    Chain chain{3, {}, {}, ends};
    vary(chain, {2, 3, 5}, {2, 3, 4, 2});
    const auto e = energy_density(chain, s);
    // Kinetic 1, 6, 22.5; wells 0.5, 2, 8; contacts to the right 3 * 0.4, 0, and at the ends.
    check_close(e[0], 1.5 + 1.2 + first, 1e-13);
    check_close(e[1], 8, 1e-13);
    check_close(e[2], 30.5 + last, 1e-13);
    check_close(energy(chain, s), e[0] + e[1] + e[2], 0, 1e-14);
    CHECK(contact_forces(chain, s.y) == std::vector<double>{3, 0, push});
  };
  check(Ends::free, 0, 0, 0);
  check(Ends::fixed, 0.8, 25.6, 16);
  check(Ends::periodic, 0, 0.4 * 50 * std::sqrt(5), 10 * std::sqrt(5));
}

TEST_CASE("what rests has no energy, whatever the sum is over", "[unit][model]") {
  Chain chain{50, Quartic{1}, CompressedHertz{0.5}};
  State<double> state(50);
  state.v[20] = 1, state.y[20] = 0.3, state.y[22] = -0.1;
  const auto all = energy_density(chain, state);
  for (std::size_t n = 0; n < 50; ++n)
    CHECK(all[n] == state.v[n] * state.v[n] / 2 + chain.well.energy(state.y[n]) +
                        contact_energy(chain, state.y.data(), n + 1));
}

TEST_CASE("runs of a varied chain agree in every scalar", "[property][chain]") {
  for_all_ends([](const auto& chain) {
    const auto run = [&]<class T>(T) {
      State<T> x = random_state<T>(12);
      const T before = energy(chain, x);
      Window all{0, 12};
      Splitting{blanes_moan_6(), 0.01}.advance(chain, x, all, 0.01, 30);
      check_close(double(energy(chain, x) - before), 0, 1e-4 * double(before));
      return std::vector<double>(x.y.begin(), x.y.end());
    };
    const auto narrow = run(double{}), wide = run(0.0L), widest = run(Quadruple{});
    for (std::size_t n = 0; n < 12; ++n) {
      check_close(narrow[n], wide[n], 1e-12);
      check_close(widest[n], wide[n], 1e-15);
      CHECK(narrow[n] != random_state(12).y[n]);
    }
  });
}

TEST_CASE("chains longer than a block of the loops, whatever they are made of", "[unit][chain]") {
  const std::size_t n = 150;
  std::vector<double> y(n), mass(n), eta(n + 1);
  for (std::size_t i = 0; i < n; ++i)
    y[i] = std::sin(0.7 * double(i * i)), mass[i] = 1 + 0.5 * std::cos(double(i));
  for (std::size_t i = 0; i <= n; ++i) eta[i] = 1 + 0.4 * std::sin(double(i));
  eta[0] = eta[n];
  const std::vector<long double> wide(y.begin(), y.end());
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (bool varied : {false, true}) {
      Chain chain{.sites = n, .well = Quartic{0.3}, .ends = ends};
      const auto plain = accelerations(chain, y);
      vary(chain, std::vector<double>(n, 1), std::vector<double>(n + 1, 1));
      CHECK(accelerations(chain, y) == plain);
      if (varied) vary(chain, mass, eta);
      const auto a = accelerations(chain, y);
      const auto b = accelerations(chain, wide);
      for (std::size_t i = 0; i < n; ++i) {
        CHECK(a[i] == acceleration(chain, y.data(), i));
        check_close(double(b[i]), a[i], 1e-13);
      }
    }
}

TEST_CASE("impossible masses are refused", "[unit][chain]") {
  Chain chain{3};
  CHECK_THROWS_AS(vary(chain, {1, 1}, {1, 1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(vary(chain, {1, 0, 1}, {1, 1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(vary(chain, {1, std::nan(""), 1}, {}), std::invalid_argument);
  CHECK_THROWS_AS(vary(chain, {}, {1, -1, 1, 1}), std::invalid_argument);
  chain.ends = Ends::periodic;
  CHECK_THROWS_AS(vary(chain, {}, {1, 1, 1, 2}), std::invalid_argument);
}

TEST_CASE("a chain runs with the length of its masses and in states of that length only",
          "[unit][chain]") {
  Chain twelve{12};
  vary(twelve, std::vector<double>(12, 1), {});
  Chain eight = twelve;
  eight.sites = 8;
  for (const auto& [chain, state] : {std::pair(eight, struck(8, 1)), {Chain{12}, struck(8, 1)}}) {
    CAPTURE(chain.sites, state.y.size());
    CHECK_THROWS_AS(energy_density(chain, state), std::invalid_argument);
    State<double> moved = state;
    CHECK_THROWS_AS(evolve(EventCorrected{0.1}, chain, moved, 1), std::invalid_argument);
    CHECK_THROWS_AS(flow<double>(chain, moved, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(accelerations(chain, state.y), std::invalid_argument);
    CHECK_THROWS_AS(contact_forces(chain, state.y), std::invalid_argument);
    CHECK_THROWS_AS(linearise(chain, state.y), std::invalid_argument);
  }
  CHECK_THROWS_AS(lengthened(eight, 10), std::invalid_argument);
  CHECK_THROWS_AS(on_long_chain({1, twelve, 20}), std::invalid_argument);
}
