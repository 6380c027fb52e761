// The chain: forces derive from the energy, contacts act on both sides, boundaries, linearisation.

#include "lattice/model/chain.hpp"

#include <random>

#include "lattice/events/event_driven.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/quadruple_orbits/orbits.hpp"
#include "sec3/breather_like.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// Displacements of size one, some contacts closed and some open; the same on every machine.
State<double> shaken(std::size_t sites, unsigned seed = 1) {
  std::mt19937_64 bits(seed);
  State<double> s(sites);
  for (auto* x : {&s.y, &s.v})
    for (double& value : *x) value = double(bits() >> 11) * 0x1p-52 - 1;
  return s;
}

double potential_energy(const Chain& chain, std::vector<double> y) {
  State<double> s(chain.sites);
  s.y = std::move(y);
  return energy(chain, s);
}

/// Fourth-order difference quotient of the potential energy along site n.
double slope(const Chain& chain, const std::vector<double>& y, std::size_t n) {
  const auto d = [&](double h) {
    auto a = y, b = y;
    a[n] += h;
    b[n] -= h;
    return (potential_energy(chain, a) - potential_energy(chain, b)) / (2 * h);
  };
  return (4 * d(5e-4) - d(1e-3)) / 3;
}

template <class Check>
void for_all_ends(Check check) {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic}) {
    CAPTURE(int(ends));
    Chain plain{12, Quartic{0.7}, {}, ends};
    check(plain);
    Chain varied = plain;
    std::vector<double> mass(12, 1), eta(13, 1);
    mass[5] = 2.5, mass[11] = 0.3;
    eta[5] = 1.3, eta[6] = 0.7;
    eta[0] = eta[12] = 1.6;
    vary(varied, mass, eta);
    check(varied);
    vary(varied, mass, {});
    check(varied);
    vary(varied, {}, eta);
    check(varied);
    Chain bare{12, None{}, PowerContact{2, 0.2}, ends};
    vary(bare, mass, eta);
    check(bare);
  }
}

}  // namespace

TEST_CASE("accelerations are minus the gradient of the energy over the mass", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto y = shaken(12).y;
    const auto a = accelerations(chain, y);
    for (std::size_t n = 0; n < 12; ++n) {
      check_close(a[n] * chain.mass_of(n), -slope(chain, y, n), 1e-7, 1e-7);
      CHECK(a[n] == acceleration(chain, y.data(), n));
    }
  });
}

TEST_CASE("so they are in extended precision, for the same chain", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto s = shaken(12);
    State<long double> wide(12);
    std::copy(s.y.begin(), s.y.end(), wide.y.begin());
    std::copy(s.v.begin(), s.v.end(), wide.v.begin());
    const auto a = accelerations(chain, s.y);
    const auto b = accelerations(chain, wide.y);
    for (std::size_t n = 0; n < 12; ++n) {
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

TEST_CASE("runs of a varied chain agree in every scalar", "[property][chain]") {
  for_all_ends([](const auto& chain) {
    const auto run = [&]<class T>(T) {
      const auto s = shaken(12);
      State<T> x(12);
      std::copy(s.y.begin(), s.y.end(), x.y.begin());
      std::copy(s.v.begin(), s.v.end(), x.v.begin());
      const T before = energy(chain, x);
      Window all{0, 12};
      Splitting{blanes_moan_6(), 0.01}.advance(chain, x, all, 0.01, 100);
      check_close(double(energy(chain, x) - before), 0, 1e-4 * double(before));
      std::vector<double> end;
      for (const T& y : x.y) end.push_back(double(y));
      return end;
    };
    const auto narrow = run(double{}), wide = run(0.0L), widest = run(Quadruple{});
    for (std::size_t n = 0; n < 12; ++n) {
      check_close(narrow[n], wide[n], 1e-12);
      check_close(widest[n], wide[n], 1e-15);
      CHECK(narrow[n] != shaken(12).y[n]);
    }
  });
}

TEST_CASE("every contact exists where its end says so", "[unit][chain]") {
  const double q[] = {1, 3, 7};
  const Chain open{.sites = 3}, wall{.sites = 3, .ends = Ends::fixed},
      ring{.sites = 3, .ends = Ends::periodic, .eta = {5, 1, 1, 7}};
  for (std::size_t i : {1, 2})
    for (const Chain& chain : {open, wall, ring}) {
      CHECK((chain.pushes(i) && touches(chain, i)));
      CHECK(stretch(chain, q, i) == q[i] - q[i - 1]);
    }
  for (std::size_t i : {0, 3}) {
    CHECK_FALSE(open.pushes(i));
    CHECK_FALSE(touches(open, i));
    CHECK((wall.pushes(i) && touches(wall, i)));
    CHECK(ring.pushes(i));
    CHECK(touches(ring, i) == (i == 3));
    CHECK(ring.eta_of(i) == 7);
    CHECK(stretch(ring, q, i) == 1 - 7);
  }
  CHECK(stretch(wall, q, 0) == 1);   // the first bead moves away from the left wall
  CHECK(stretch(wall, q, 3) == -7);  // the last one into the right wall
}

TEST_CASE("contact forces sum to zero", "[property][chain]") {
  // Without wells (subtracted here) a free chain feels no net force: the third law.
  Chain chain{40, Quartic{0.3}};
  const auto y = shaken(40).y;
  const auto a = accelerations(chain, y);
  double net = 0, scale = 0;
  for (std::size_t n = 0; n < 40; ++n) {
    net += a[n] - chain.well.force(y[n]);
    scale += std::abs(a[n]);
  }
  check_close(net, 0, 1e-14 * scale);
}

TEST_CASE("the energy density adds up to the energy", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto s = shaken(12);
    double kinetic = 0;
    for (std::size_t n = 0; n < 12; ++n) kinetic += chain.mass_of(n) * s.v[n] * s.v[n] / 2;
    double sum = kinetic + potential_energy(chain, s.y);
    check_close(energy(chain, s), sum, 0, 1e-14);
  });
}

TEST_CASE("the chain is symmetric under n -> -n with y -> -y", "[property][chain]") {
  const Chain chain{31, Quartic{1}};
  auto y = shaken(31).y;
  auto mirrored = y;
  for (std::size_t n = 0; n < 31; ++n) mirrored[n] = -y[30 - n];
  const auto a = accelerations(chain, y), b = accelerations(chain, mirrored);
  for (std::size_t n = 0; n < 31; ++n) check_close(b[n], -a[30 - n], 1e-15, 1e-14);
}

TEST_CASE("the linearisation is the derivative of the force", "[unit][chain]") {
  for_all_ends([](const auto& chain) {
    const auto y = shaken(12).y;
    const auto h = linearise(chain, y);
    for (std::size_t j = 0; j < 12; ++j) {
      const auto column = [&](double d) {
        auto p = y, q = y;
        p[j] += d;
        q[j] -= d;
        auto a = accelerations(chain, p);
        const auto b = accelerations(chain, q);
        for (std::size_t i = 0; i < 12; ++i) a[i] = -(a[i] - b[i]) / (2 * d) * chain.mass_of(i);
        return a;
      };
      const auto c = column(1e-6);
      for (std::size_t i = 0; i < 12; ++i) {
        double expected = 0;
        if (i == j)
          expected = h.diagonal[i];
        else if (i + 1 == j || j + 1 == i)
          expected = h.off[std::min(i, j)];
        else if (i + j == 11 && (i == 0 || j == 0))
          expected = h.off[11];
        check_close(c[i], expected, 1e-7, 1e-7);
      }
    }
  });
}

TEST_CASE("a chain of equal masses given one by one has the bits of the plain chain",
          "[unit][chain]") {
  Chain plain{700, Quartic{0.7}};
  Chain varied = plain;
  vary(varied, std::vector<double>(700, 1), std::vector<double>(701, 1));
  const auto y = shaken(700).y;
  CHECK(accelerations(plain, y) == accelerations(varied, y));
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

TEST_CASE("a chain runs with the length of its masses and in states of that length only",
          "[unit][chain]") {
  Chain twelve{12};
  vary(twelve, std::vector<double>(12, 1), {});
  const auto refused = [](const Chain& chain, const State<double>& start) {
    State<double> state = start;
    CAPTURE(chain.sites, chain.mass.size(), state.y.size());
    CHECK_THROWS_AS(energy_density(chain, state), std::invalid_argument);
    CHECK_THROWS_AS(evolve(EventCorrected{0.1}, chain, state, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(flow<double>(chain, state, 1.0), std::invalid_argument);
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
  CHECK_THROWS_AS(on_long_chain({1, twelve, 20}), std::invalid_argument);
  const Impact plain{1, {12}, 20, 0.2, may_move}, heavy{1, twelve, 20, 0.2, may_move};
  CHECK(strike(EventCorrected{0.1}, plain).end.y == strike(EventCorrected{0.1}, heavy).end.y);
}
