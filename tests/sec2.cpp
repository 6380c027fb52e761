// Shooting by leapfrog steps, and a wave of a ring without wells.

#include <numbers>

#include "lattice/gsl/random.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec2/searches.hpp"
#include "support/check.hpp"

using namespace lattice;

TEST_CASE("shooting by leapfrog has the exact derivative of its map", "[unit][orbits]") {
  searches::LeapfrogShooting problem;
  problem.chain = {6, Harmonic{}, {}, Ends::fixed};
  vary(problem.chain, shaken(std::vector<double>(6, 1), 0.3, 1),
       shaken(std::vector<double>(7, 1), 0.3, 2));
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

TEST_CASE("a wave of a ring without wells moves on by one site", "[unit][orbits]") {
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
  State<double> end = wave.start;
  flow(problem.chain, end, q);
  const double shift = end.y[1] - wave.start.y[0];
  CHECK(wave.amplitude > 0.1);
  for (std::size_t n = 0; n < 9; ++n) {
    check_close(end.y[(n + 1) % 9] - shift, wave.start.y[n], 1e-6 * wave.amplitude);
    check_close(end.v[(n + 1) % 9], wave.start.v[n], 1e-6 * wave.amplitude);
  }
}
