// Section 2: leapfrog shooting, mean forces and motions without wells,
// by second formulas.

#include <numbers>

#include "check.hpp"
#include "sec2/fixed_leapfrog.hpp"
#include "sec2/mean_force.hpp"
#include "sec2/periodic_motions.hpp"

namespace sections_again {

using namespace lattice;

namespace {

const std::vector<double> masses{1.2, 0.8, 1.1, 0.9}, start_y{0.1, -0.05, 0.08, -0.02},
    start_v{0.05, 0.02, -0.07, 0.03};

/// Four unequal beads; the contacts stay closed.
LeapfrogShooting four(Ends ends) {
  LeapfrogShooting problem;
  problem.chain = {4, Quartic{0.4}, CompressedHertz{0.5}, ends};
  vary(problem.chain, masses, {1.1, 0.9, 1.2, 0.8, 1.1});
  problem.omega = 1.3;
  return problem;
}

double push(double x, double power = 1.5) {
  return x > 0 ? std::pow(x, power) : 0;
}

/// Fourth-order steps of x' = rate(x).
template <class Rate>
std::vector<double> carried(std::vector<double> x, double time, int steps, Rate rate) {
  const double h = time / steps;
  const auto at = [&](double by, const std::vector<double>& k) {
    std::vector<double> z(x);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * k[i];
    return z;
  };
  for (int s = 0; s < steps; ++s) {
    const auto a = rate(x), b = rate(at(h / 2, a)), c = rate(at(h / 2, b)), e = rate(at(h, c));
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
  }
  return x;
}

}  // namespace

TEST_CASE("leapfrog with all kinds of ends, and its derivative", "[unit][orbits]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic}) {
    LeapfrogShooting problem = four(ends);
    CHECK((problem.scale == 1 && problem.steps == 128));
    problem.steps = 12;
    // A step at a time, by hand
    const double h = 2 * std::numbers::pi / 1.3 / 12, eta[] = {1.1, 0.9, 1.2, 0.8, 1.1};
    std::vector<double> y = start_y, v = start_v, seen;
    State<double> z(4);
    z.y = y, z.v = v;
    problem.fly(z, nullptr, 3, [&](const State<double>& now) { seen.push_back(now.y[0]); });
    for (int k = 0; k < 3; ++k) {
      for (std::size_t n = 0; n < 4; ++n) y[n] += h / 2 * v[n];
      std::vector<double> f(5, 0);  // of contact i on the bead to its right
      for (std::size_t i = 0; i <= 4; ++i) {
        if (ends == Ends::free && (i == 0 || i == 4)) continue;
        const bool ring = ends == Ends::periodic;
        const double left = i > 0  ? y[i - 1]
                            : ring ? y[3]
                                   : 0,
                     right = i < 4  ? y[i]
                             : ring ? y[0]
                                    : 0;
        f[i] = eta[i] * (push(0.5 - right + left) - std::pow(0.5, 1.5));
      }
      for (std::size_t n = 0; n < 4; ++n)
        v[n] += h / masses[n] * (f[n] - f[n + 1] - y[n] - 0.4 * std::pow(y[n], 3));
      for (std::size_t n = 0; n < 4; ++n) y[n] += h / 2 * v[n];
      check_close(seen.at(std::size_t(k)), y[0], 1e-13);
    }
    for (std::size_t n = 0; n < 4; ++n) check_close(z.v[n], v[n], 1e-13);
    // All of a period, or the half of it that a motion even in time needs
    for (int parts : {1, 2}) {
      problem.symmetry = parts == 1 ? travelling(4, 0, false) : even_in_time(4);
      Vector<double> x(parts == 1 ? 8 : 4);
      for (Eigen::Index k = 0; k < x.size(); ++k)
        x[k] = k < 4 ? start_y[std::size_t(k)] : start_v[std::size_t(k - 4)];
      const Shot<double> shot = problem.shoot(x, {});
      State<double> end = problem.expand(x), begin = end;
      problem.fly(end, nullptr, 12 / parts, [](const State<double>&) {});
      CHECK((shot.miss - problem.residuals(begin, end)).cwiseAbs().maxCoeff() < 1e-15);
      REQUIRE(shot.jacobian.cols() == x.size());
      for (Eigen::Index k = 0; k < x.size(); ++k) {
        const Vector<double> by = 1e-5 * Vector<double>::Unit(x.size(), k);
        const Vector<double> slope =
            (problem.shoot(x + by, {}, false).miss - problem.shoot(x - by, {}, false).miss) / 2e-5;
        CAPTURE(int(ends), parts, k);
        CHECK((slope - shot.jacobian.col(k)).cwiseAbs().maxCoeff() < 1e-8);
      }
      problem.scale = 3;
      CHECK(problem.sizes(x, true).unknown == Vector<double>::Constant(x.size(), 3));
      CHECK(problem.sizes(x, true).equation == Vector<double>::Constant(shot.miss.size(), 3));
    }
  }
}

TEST_CASE("mean forces and what they leave, by hand", "[unit][mean_force]") {
  MeanForces means{{5, 2, 9, 4, 3}, {3.5, -7.25, 5, 0.5}, State<double>(4)};
  CHECK(means.spread(1, 3) == 7);
  CHECK(means.spread(3, 4) == 1);
  CHECK(means.spread(0, 1) == 3);
  check_close(means.imbalance(), 0.5, 1e-15);  // of the first and of the last
  means.well = {3, -7, 5, 3};
  check_close(means.imbalance(), 2, 1e-15);
  means.well = {3, -7, 4.25, 1};
  check_close(means.imbalance(), 0.75, 1e-15);
  CHECK(MeanForces{{2, 1}, {1}, State<double>(1)}.imbalance() == 0);
  // Two unequal beads between walls, each contact of its own kind
  const motions::MixedChain chain{2, {}, {1.3, 0.7}, {1.1, 0.9, 1.2}, {1.5, 1.7, 1.4}};
  const double y[] = {0.3, -0.2};
  check_close(motions::contact_push(chain, y, 1), 0.9 * std::pow(0.5, 1.7), 1e-15);
  CHECK(motions::contact_push(chain, y, 0) == 0);
  CHECK(motions::contact_push(chain, y, 2) == 0);
  const double other[] = {-0.3, 0.2};
  check_close(motions::contact_push(chain, other, 0), 1.1 * std::pow(0.3, 1.5), 1e-15);
  check_close(motions::contact_push(chain, other, 2), 1.2 * std::pow(0.2, 1.4), 1e-15);
  CHECK(motions::contact_push(chain, other, 1) == 0);
  State<double> start(2);
  start.t = 4, start.y = {0.3, -0.2}, start.v = {0.1, -0.05};
  const MeanForces walls = mean_forces(chain, start, 2, 1e-12);
  const auto rate = [](const std::vector<double>& x) {
    const double a = 1.1 * push(-x[0]), b = 0.9 * push(x[0] - x[1], 1.7), c = 1.2 * push(x[1], 1.4);
    return std::vector<double>{x[2], x[3], (a - b) / 1.3, (b - c) / 0.7, a, b, c};
  };
  const auto end = carried({0.3, -0.2, 0.1, -0.05, 0, 0, 0}, 2, 2000, rate);
  CHECK(walls.end.t == 6);
  for (std::size_t k = 0; k < 2; ++k) {
    check_close(walls.end.y[k], end[k], 1e-8);
    check_close(walls.end.v[k], end[2 + k], 1e-8);
    CHECK(walls.well[k] == 0);
  }
  for (std::size_t k = 0; k < 3; ++k) check_close(walls.contact[k], end[4 + k] / 2, 1e-8);
  // Wells pull as well
  const Chain held{1, Quartic{2}, Hertz{}, Ends::fixed};
  State<double> one(1);
  one.y = {0.4};
  const MeanForces pulled = mean_forces(held, one, 3, 1e-12);
  const auto hold = carried({0.4, 0, 0}, 3, 2000, [](const std::vector<double>& x) {
    const double pull = x[0] + 2 * x[0] * x[0] * x[0];
    return std::vector<double>{x[1], push(-x[0]) - push(x[0]) - pull, pull};
  });
  check_close(pulled.well[0], hold[2] / 3, 1e-8);
  check_close(pulled.end.v[0], hold[1], 1e-8);
}

TEST_CASE("motions without wells return", "[unit][orbits]") {
  using namespace motions;
  check_close(wave_amplitude(std::numbers::pi, 1.5), std::pow(0.457 * std::pow(2, 2.5), -2), 1e-15);
  check_close(wave_amplitude(std::numbers::pi / 3, 2), 1 / 0.457, 1e-12);
  CHECK((free_rule().damped && free_rule().most == 60 && free_rule().rank == 1e-9));
  CHECK(uneven(3, 0.2, 5) == shaken({1, 1, 1}, 0.2, 5));
  const State<double> swing = zigzag(3);
  for (std::size_t n : {0, 1, 2})
    check_close(swing.y[n], (n == 1 ? -1 : 1) * wave_amplitude(std::numbers::pi, 1.5), 1e-15);
  // A wave moves on by one site in its period, and all 6 std::numbers::pi / N of its phase
  Shooting<double> problem;
  problem.chain = {9, None{}, Hertz{.floor = 0}, Ends::periodic};
  const Orbit<double> wave = ring_wave(problem);
  const double q = 6 * std::numbers::pi / 9;
  check_close(problem.omega, 2 * std::numbers::pi / q, 1e-13);
  std::vector<double> x(wave.start.y);
  x.insert(x.end(), wave.start.v.begin(), wave.start.v.end());
  const auto rate = [](const std::vector<double>& z) {
    std::vector<double> out(z.begin() + 9, z.end());
    for (std::size_t n = 0; n < 9; ++n)
      out.push_back(push(z[(n + 8) % 9] - z[n]) - push(z[n] - z[(n + 1) % 9]));
    return out;
  };
  x = carried(x, q, 800, rate);
  const double shift = x[1] - wave.start.y[0];
  CHECK(wave.amplitude > 0.1);
  for (std::size_t n = 0; n < 9; ++n) {
    check_close(x[(n + 1) % 9] - shift, wave.start.y[n], 1e-6 * wave.amplitude);
    check_close(x[9 + (n + 1) % 9], wave.start.v[n], 1e-6 * wave.amplitude);
  }
  // Standing waves of uneven chains, and the exponents on the way to them
  for (Ends ends : {Ends::fixed, Ends::periodic}) {
    Shooting<double> standing;
    standing.chain = {4, None{}, PowerContact{}, ends};
    standing.omega = 1;
    const Orbit<double> orbit = standing_wave(standing, 1.8);
    CHECK(standing.chain.contact.exponent() == 1.8);
    CHECK(standing.chain.mass == uneven(4, 0.15, 11));
    std::vector<double> eta = uneven(5, 0.15, 12);
    if (ends == Ends::periodic) eta[4] = eta[0];
    CHECK(standing.chain.eta == eta);
    const MeanForces half = mean_forces(standing.chain, orbit.start, std::numbers::pi, 1e-11);
    for (double v : half.end.v) check_close(v, 0, 1e-8 * orbit.amplitude);
    CHECK(orbit.start.v == std::vector<double>(4, 0));
  }
  const MixedProblem half = mixed_chain(0.5);
  const double expected[] = {1.5, 1.6, 1.45, 1.55, 1.65, 1.5};
  for (std::size_t k = 0; k < 6; ++k) check_close(half.chain.exponent[k], expected[k], 1e-15);
  CHECK(half.chain.sites == 5);
  CHECK(half.half_period == std::numbers::pi);
  CHECK(half.chain.mass == uneven(5, 0.075, 13));
  CHECK(half.chain.stiffness == uneven(6, 0.075, 14));
  const State<double> mixed = mixed_wave();
  const MixedChain whole = mixed_chain(1).chain;
  CHECK(whole.exponent == std::vector<double>{1.5, 1.7, 1.4, 1.6, 1.8, 1.5});
  for (double v : mean_forces(whole, mixed, std::numbers::pi, 1e-11).end.v)
    check_close(v, 0, 1e-8 * sup(Eigen::Map<const Vector<double>>(mixed.y.data(), 5).eval()));
}

}  // namespace sections_again
