// Shooting by leapfrog steps, and a wave of a ring without wells.

#include <numbers>

#include "lattice/gsl/random.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec2/searches.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// A chain of six unequal beads between walls, at rest and far from equilibrium.
template <class Onsite>
std::pair<Chain, State<double>> walled() {
  Chain chain{6, Onsite{}, {}, Ends::fixed};
  vary(chain, shaken(std::vector<double>(6, 1), 0.3, 1), shaken(std::vector<double>(7, 1), 0.3, 2));
  State<double> state(6);
  for (std::size_t n = 0; n < 6; ++n) state.y[n] = (n % 2 == 0 ? 0.3 : -0.2) + 0.01 * double(n);
  return {chain, state};
}

}  // namespace

TEST_CASE("shooting by leapfrog has the exact derivative of its map", "[unit][orbits]") {
  searches::LeapfrogShooting problem;
  problem.chain = walled<Harmonic>().first;
  problem.symmetry = travelling(6, 0, false);
  problem.omega = 1.3;
  Vector<double> x(12);
  x << 0.3, -0.2, 0.25, -0.3, 0.2, -0.1, 0.1, 0, -0.1, 0.05, 0, 0.1;
  const Evaluation<double> here = problem.evaluate(x);
  for (Eigen::Index k = 0; k < 12; ++k) {
    const Vector<double> h = 1e-6 * Vector<double>::Unit(12, k);
    const Vector<double> slope =
        (problem.evaluate(x + h, false).residual - problem.evaluate(x - h, false).residual) / 2e-6;
    CAPTURE(k);
    CHECK(sup<double>(slope - here.jacobian.col(k)) < 1e-4);
  }
}

namespace {

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

TEST_CASE("a wave of a ring without wells moves on by one site", "[unit][orbits]") {
  // A wave moves on by one site in its period, and all 6 pi / N of its phase
  const double q = 6 * std::numbers::pi / 9;
  const Shooting<double> problem{{9, None{}, Hertz{.floor = 0}, Ends::periodic},
                                 travelling(9, 1, true),
                                 2 * std::numbers::pi / q};
  const double amplitude = std::pow(0.457 * std::pow(2 * std::sin(q / 2), 2.5), -2);
  State<double> guess(9);
  for (std::size_t n = 0; n < 9; ++n) {
    guess.y[n] = amplitude * std::cos(q * double(n));
    guess.v[n] = amplitude * std::sin(q * double(n));
  }
  const Orbit<double> wave =
      newton(problem, problem.reduce(guess), {.most_steps = 60, .damped = true, .rank = 1e-9});
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
}
