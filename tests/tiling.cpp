// Tiles in time and threads give the bits of the plain run; compensated sums lose fewer of them.

#include "lattice/integrators/tiling.hpp"

#include "check.hpp"
#include "lattice/packets/impact.hpp"

using namespace lattice;

namespace {

/// Everything moves, some contacts are open and some closed.
State<double> shaken(std::size_t sites) {
  State<double> s(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    s.y[n] = 0.3 * std::sin(0.7 * double(n * n % 101));
    s.v[n] = 0.2 * std::cos(1.3 * double(n * n % 89));
  }
  return s;
}

void check_same(const Chain& chain, const Tiled& tiled, std::size_t steps) {
  const Splitting plain{tiled.scheme, tiled.step};
  auto a = shaken(chain.sites), b = a;
  Window wa{0, chain.sites}, wb = wa;
  const double work = plain.advance(chain, a, wa, plain.step, steps);
  CAPTURE(chain.sites, int(chain.ends), tiled.threads, tiled.block, tiled.depth, steps);
  CHECK(tiled.advance(chain, b, wb, tiled.step, steps) == work);
  CHECK(a.y == b.y);
  CHECK(a.v == b.v);
}

void check_all_tiles(const Chain& chain) {
  for (std::size_t threads : {1, 2, 3, 7})
    for (std::size_t block : {1, 64, 300})
      for (std::size_t depth : {1, 5, 32})
        check_same(chain, {blanes_moan_4(), 0.05, threads, block, depth, 40}, 7);
}

}  // namespace

TEST_CASE("a tiled run has the bits of the plain run", "[property][tiling]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (std::size_t sites : {40, 41, 127, 1000, 2500})
      check_all_tiles(Chain{sites, Quartic{1}, {}, ends});
  check_all_tiles(Chain{777, Pendulum{}, CompressedHertz{0.3}, Ends::periodic});
}

TEST_CASE("so has one of a varied chain", "[property][tiling]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (int varied : {1, 2, 3}) {
      Chain chain{600, {}, {}, ends};
      std::vector<double> mass(varied & 1 ? 600 : 0), eta(varied & 2 ? 601 : 0);
      for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = 1 + 0.1 * double(n % 7);
      for (std::size_t n = 0; n < eta.size(); ++n) eta[n] = 1 + 0.2 * double(n % 5);
      if (ends == Ends::periodic && !eta.empty()) eta.front() = eta.back() = 1.7;
      vary(chain, mass, eta);
      check_all_tiles(chain);
      if (eta.empty() || ends != Ends::periodic) continue;
      chain.eta.front() = 99;  // the contact of a ring's ends has one stiffness, the last entry
      check_all_tiles(chain);
    }
}

TEST_CASE("so has one in extended precision", "[property][tiling]") {
  Chain chain{200, Quartic{1}, {}, Ends::fixed};
  std::vector<double> mass(200);
  for (std::size_t n = 0; n < 200; ++n) mass[n] = 1 + 0.1 * double(n % 7);
  vary(chain, mass, {});
  State<long double> a(200);
  for (std::size_t n = 0; n < 200; ++n) a.y[n] = 0.3L * std::sin(0.7L * (n * n % 101));
  State<long double> b = a;
  Window wa{0, 200}, wb = wa;
  Splitting{blanes_moan_4(), 0.05}.advance(chain, a, wa, 0.05, 7);
  Tiled{blanes_moan_4(), 0.05, 2, 64, 5, 40}.advance(chain, b, wb, 0.05, 7);
  CHECK(a.y == b.y);
  CHECK(a.v == b.v);
}

TEST_CASE("chunks of any length, long runs and default tiles", "[property][tiling]") {
  const Chain chain{30000, Quartic{1}};
  for (std::size_t steps : {0, 1, 2, 3, 31, 32, 33, 100})
    check_same(chain, {verlet(), 0.05}, steps);
  check_same(chain, {blanes_moan_6_14(), 0.05}, 9);
}

TEST_CASE("a tiled run of a sleeping chain falls back and wakes it", "[property][tiling]") {
  const Chain chain{300, Quartic{1}};
  auto a = struck(300, 1.9), b = a;
  evolve(Splitting{blanes_moan_6(), 0.05}, chain, a, 400, 50, Unobserved{});
  evolve(Tiled{blanes_moan_6(), 0.05, 2, 64, 16, 50}, chain, b, 400, 50, Unobserved{});
  CHECK(a.y == b.y);
  CHECK(a.v == b.v);
}
