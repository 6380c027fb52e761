// Floquet multipliers against formulas and the matrix of the whole period, and their errors.

#include "lattice/orbits/floquet.hpp"

#include "commands/multipliers.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/breather.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

namespace {

using Problem = Shooting<double>;

Problem small_problem(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, centre == Centre::site ? 15 : 16);
}
MultiplierPairs<double> pairs_at(const Problem& problem, const Orbit<double>& orbit) {
  return floquet_pairs(problem.chain, orbit.start, orbit.period());
}

/// A quartic well whose stiffness is wrong by too little to be seen when it is made.
struct Stiffer {
  double off = 0;
  template <class T>
  T energy(T y) const {
    return Quartic{1}.energy(y);
  }
  template <class T>
  T force(T y) const {
    return Quartic{1}.force(y);
  }
  template <class T>
  T stiffness(T y) const {
    return Quartic{1}.stiffness(y) + T(off) * std::min(T(1e3) * y * y, T(1));
  }
};

}  // namespace

TEST_CASE(
    "an orbit that moves at first, or a stiffness that is not that of the force, has no "
    "multipliers",
    "[unit][floquet]") {
  for (const double off : {0.0, 5e-4, 1e-5}) {
    Problem problem = small_problem(Centre::site, 1.02, 1);
    const Orbit<double> orbit = find_breather(problem);
    problem.chain.well = Stiffer{off};
    CAPTURE(off);
    const auto said = refusal<NewtonFailed>([&] { pairs_at(problem, orbit); });
    const bool refused = said.find("not minus the derivative of its force") != std::string::npos;
    CHECK((off == 0 ? said.empty() : refused));
  }
  const Problem problem = small_problem(Centre::site, 1.1);
  Orbit<double> orbit = find_breather(problem);
  orbit.start.v[3] = 1e-3;
  CHECK_THROWS_AS(pairs_at(problem, orbit), std::invalid_argument);
}

TEST_CASE("a pair follows from kappa", "[unit][floquet]") {
  for (const std::complex<double> kappa :
       {std::complex<double>(-0.3, 0), {1e-12, 0}, {2, 0}, {-1.5, 0}, {-0.2, 0.1}}) {
    const auto outer = multiplier(kappa, 1), inner = multiplier(kappa, -1);
    CAPTURE(kappa);
    CHECK(std::abs(outer * inner - 1.0) < 1e-14);
    CHECK(std::abs(outer + inner - 2.0 - 4.0 * kappa) < 1e-14);
  }
  // On the unit circle, outside, and so close to +1 that lambda + 1/lambda would be 2.
  CHECK(std::abs(std::abs(multiplier({-0.3, 0}, 1)) - 1) < 1e-15);
  check_close(std::log(multiplier({1e-18, 0}, 1).real()), 2e-9, 0, 1e-6);
  // An error of kappa costs its square root at +1 and no more than itself elsewhere.
  CHECK((MultiplierPair{{0, 0}, 1e-14}.multiplier_error()) > 1e-7);
  CHECK((MultiplierPair{{-0.3, 0}, 1e-14}.multiplier_error()) < 1e-13);
  // Unstable is a pair beyond +1 or -1 or off circle and axis, by more than its error.
  CHECK((MultiplierPair{{1e-6, 0}, 1e-9}.is_unstable()));
  CHECK((MultiplierPair{{-1 - 1e-6, 0}, 1e-9}.is_unstable()));
  CHECK((MultiplierPair{{-0.5, 1e-6}, 1e-9}.is_unstable()));
  CHECK_FALSE((MultiplierPair{{1e-10, 0}, 1e-9}.is_unstable()));
  CHECK_FALSE((MultiplierPair{{-1, 1e-10}, 1e-9}.is_unstable()));
  // What a double rounds off can neither hide that a pair is at -1 nor take it off the circle.
  const MultiplierPair rounded{{-1 - 2e-16, 0}, 1e-20};
  CHECK_FALSE(rounded.is_unstable());
  CHECK(rounded.multiplier_error() > 2e-8);
}

TEST_CASE("the largest modulus allows for the errors of all pairs", "[unit][floquet]") {
  const auto contains = [](const Estimate& e, double x) {
    return std::abs(e.value - x) <= e.error;
  };
  const MultiplierPair circle{-0.3, 1e-15}, quadruplet{{-0.5, 1e-3}, 1e-6}, at_one{1e-10, 1e-9};
  CHECK(excess({circle}).value + excess({circle}).error < 1e-14);
  // A quadruplet shows beside a pinning pair on the circle: cosh ln|lambda| = |kappa| + |1 + kappa|
  const double off = std::acosh(2 * std::abs(std::complex<double>(0.5, 1e-3)));
  CHECK(contains(excess({circle, quadruplet}), std::expm1(off)));
  CHECK(excess({circle, quadruplet}).error < 1e-5);
  // A pair that may be real or not leaves both open, and an uncertain one counts beside a larger one
  for (double kappa : {-9e-10, 0.0, 1.1e-9})
    CHECK(contains(excess({circle, at_one}), std::max(0.0, multiplier(kappa, 1).real() - 1)));
  CHECK(contains(excess({{1e-10, 1e-16}, at_one}), multiplier(1.1e-9, 1).real() - 1));
}

TEST_CASE("a pinning pair on the circle does not make a breather stable", "[property][floquet]") {
  // True moduli by a program of its own: eighty-bit numbers, extrapolated midpoint rule from event to event
  struct {
    double omega, s, modulus, known;
  } const cases[] = {{3, 10, 1.0468009382067568, 0}, {1.9, -1 / 6., 1.2862005642672, 1e-12}};
  for (const auto& [omega, s, modulus, known] : cases) {
    Multipliers command;
    command.omega_b = omega, command.well = Quartic{s};
    const Spectrum all = command.find();
    CAPTURE(omega, s);
    CHECK(all.kappa().value + all.kappa().error < 0);
    check_close(all.largest_modulus().value, modulus, all.largest_modulus().error + known);
    CHECK(all.largest_modulus().error < 1e-12);
    CHECK(command.quantities(all).rows.size() == 2);
  }
  // Around a bond all pairs are on the circle, and the error is small enough to say so
  Multipliers bond;
  bond.centre = Centre::bond;
  const Estimate largest = bond.find().largest_modulus();
  CHECK((std::abs(largest.value - 1) <= largest.error && largest.error < 1e-12));
  // Where the pair nearest to +1 is half of a quadruplet its kappa is no number
  const Spectrum four{{{{-0.01, 1e-3}, 1e-12}, {{-0.01, -1e-3}, 1e-12}}, {}};
  CHECK(std::isnan(std::get<double>(bond.quantities(four).rows[0][1])));
}

TEST_CASE("half a period gives the monodromy matrix of the whole one", "[property][floquet]") {
  for (const auto& [centre, omega] : {std::pair{Centre::site, 1.1}, {Centre::bond, 1.5}}) {
    const Problem problem = small_problem(centre, omega, 0.3);
    const Orbit<double> orbit = find_breather(problem);
    const Eigen::Index n = Eigen::Index(problem.chain.sites);
    const Matrix<double> whole = monodromy(problem.chain, orbit.start, orbit.period());
    const Matrix<double> half = monodromy(problem.chain, orbit.start, orbit.period() / 2);
    const Matrix<double> b = half.topRightCorner(n, n), c = half.bottomLeftCorner(n, n);
    const Matrix<double> block = Matrix<double>::Identity(n, n) + 2 * b.transpose() * c;
    CHECK((whole.topLeftCorner(n, n) - block).cwiseAbs().maxCoeff() < 1e-11);
    CHECK((whole.bottomRightCorner(n, n) - block.transpose()).cwiseAbs().maxCoeff() < 1e-11);
    // The multipliers in pairs have the trace of the matrix, with the two of the phase.
    const MultiplierPairs<double> pairs = pairs_at(problem, orbit);
    std::complex<double> sum = 2;
    for (const auto& kappa : pairs.kappa) sum += multiplier(kappa, 1) + multiplier(kappa, -1);
    CHECK(std::abs(sum - whole.trace()) < 1e-11);
    CHECK(pairs.symplectic_error < 1e-12);
  }
}

TEST_CASE("a chain of two masses has the multipliers of its period map", "[property][floquet]") {
  Multipliers chosen;
  chosen.omega_b = 1.3;
  chosen.like.sites = 5;
  vary(chosen.like, {1, 0.8, 1, 0.8, 1}, {});
  const Fitted found = find_chosen(chosen, 1e-17);
  const MultiplierPairs<double> pairs = pairs_at(found.problem, found.orbit);
  CHECK(pairs.symplectic_error < 1e-12);
  const auto z = eigenvalues_of(
      monodromy<double>(found.problem.chain, found.orbit.start, found.orbit.period()));
  const Spectrum all = chosen.find();
  REQUIRE(z.size() == 2 * all.pairs.size() + 2);
  for (const auto& [one, error] : multipliers_of(all)) {
    double nearest = 1;
    for (const auto& other : z) nearest = std::min(nearest, std::abs(other - one));
    CHECK(nearest < 1e-5 + error);
  }
  // Far beads of mass 1 and .8 turn alone
  for (const double mass : {1.0, 0.8}) {
    const double turn = -std::pow(std::sin(pi<double>() / 1.3 / std::sqrt(mass)), 2);
    CHECK(std::count_if(all.pairs.begin(), all.pairs.end(), [&](const MultiplierPair& p) {
            return std::abs(p.kappa - turn) < 1e-9;
          }) >= 4);
  }
}
