// Floquet multipliers against formulas, against the monodromy matrix of the whole period, against the
// blocks of the symmetries, and what they do in wrong hands.

#include "lattice/orbits/floquet.hpp"

#include "commands/exchanges.hpp"
#include "commands/multipliers.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec33/exchange.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

using Problem = Shooting<double>;

Problem small_problem(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, centre == Centre::site ? 15 : 16);
}
Pairs<double> pairs_at(const Problem& problem, const Orbit<double>& orbit, double coarser = 1) {
  EventTolerance<double> rule;
  rule.tolerance *= coarser;
  return floquet_pairs(problem.chain, orbit.start, orbit.period(), rule);
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

TEST_CASE("a stiffness that is not that of the force has no multipliers", "[unit][floquet]") {
  for (const double off : {0.0, 5e-4, 1e-5}) {
    Problem problem = small_problem(Centre::site, 1.02, 1);
    const Orbit<double> orbit = find_breather(problem);
    problem.chain.well = Stiffer{off};
    CAPTURE(off);
    const auto said = refusal<NewtonFailed>([&] { pairs_at(problem, orbit); });
    const bool refused = said.find("not minus the derivative of its force") != std::string::npos;
    CHECK((off == 0 ? said.empty() : refused));
  }
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
  CHECK((Pair{{0, 0}, 1e-14}.multiplier_error()) > 1e-7);
  CHECK((Pair{{-0.3, 0}, 1e-14}.multiplier_error()) < 1e-13);
  // Unstable is a pair beyond +1 or -1 or off circle and axis, by more than its error.
  CHECK((Pair{{1e-6, 0}, 1e-9}.is_unstable()));
  CHECK((Pair{{-1 - 1e-6, 0}, 1e-9}.is_unstable()));
  CHECK((Pair{{-0.5, 1e-6}, 1e-9}.is_unstable()));
  CHECK_FALSE((Pair{{1e-10, 0}, 1e-9}.is_unstable()));
  CHECK_FALSE((Pair{{-1, 1e-10}, 1e-9}.is_unstable()));
  // What a double rounds off can neither hide that a pair is at -1 nor take it off the circle.
  const Pair rounded{{-1 - 2e-16, 0}, 1e-20};
  CHECK_FALSE(rounded.is_unstable());
  CHECK(rounded.multiplier_error() > 2e-8);
}

TEST_CASE("the largest modulus allows for the errors of all pairs", "[unit][floquet]") {
  const auto contains = [](const Estimate& e, double x) {
    return std::abs(e.value - x) <= e.error;
  };
  const Pair circle{-0.3, 1e-15}, quadruplet{{-0.5, 1e-3}, 1e-6}, at_one{1e-10, 1e-9};
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
  } const cases[] = {{3, 10, 1.0468009382067568, 0},
                     {1.9, -1 / 6., 1.2862005642672, 1e-12},
                     {1.91, -1 / 6., 1.843417022224, 1e-11},
                     {2.5, 1, 1.0301029405398695, 0}};
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

TEST_CASE("beads without contact have the multipliers of a pendulum at rest", "[unit][floquet]") {
  // All wells are linear, all contacts open: every kappa is -sin^2(T/2).
  Problem problem = small_problem(Centre::site, 1.3);
  State<double> start(15);
  for (std::size_t n = 0; n < 15; ++n) start.y[n] = double(n);
  const Matrix<double> half = monodromy(problem.chain, start, 1.0);
  const Matrix<double> k = pair_matrix(half);
  const double expected = -std::pow(std::sin(1.0), 2);
  CHECK((k - expected * Matrix<double>::Identity(15, 15)).cwiseAbs().maxCoeff() < 1e-13);
  CHECK(symplectic_defect(half) < 1e-13);
}

TEST_CASE("half a period gives the monodromy matrix of the whole one", "[property][floquet]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (double omega : {1.1, 1.5}) {
      const Problem problem = small_problem(centre, omega, 0.3);
      const Orbit<double> orbit = find_breather(problem);
      const Eigen::Index n = Eigen::Index(problem.chain.sites);
      const Matrix<double> whole = monodromy(problem.chain, orbit.start, orbit.period());
      const Matrix<double> half = monodromy(problem.chain, orbit.start, orbit.period() / 2);
      const Matrix<double> k = pair_matrix(half);
      const Matrix<double> block = Matrix<double>::Identity(n, n) + 2 * k;
      CHECK((whole.topLeftCorner(n, n) - block).cwiseAbs().maxCoeff() < 1e-11);
      CHECK((whole.bottomRightCorner(n, n) - block.transpose()).cwiseAbs().maxCoeff() < 1e-11);
      // The multipliers in pairs have the trace of the matrix, with the two of the phase.
      const Pairs<double> pairs = pairs_at(problem, orbit);
      std::complex<double> sum = 2;
      for (const auto& kappa : pairs.kappa) sum += multiplier(kappa, 1) + multiplier(kappa, -1);
      CHECK(std::abs(sum - whole.trace()) < 1e-11);
      CHECK(pairs.defect < 1e-12);
      CHECK(pairs.phase_error < 1e-12);
    }
}

TEST_CASE("the blocks of the symmetries hold the same pinning pair", "[property][floquet]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const Problem problem = small_problem(centre, 1.1);
    const Orbit<double> orbit = find_breather(problem);
    const Pairs<double> pairs = pairs_at(problem, orbit);
    const Matrix<double> half = monodromy(problem.chain, orbit.start, orbit.period() / 2);
    const double other = pinning_by_symmetry(half, centre);
    CAPTURE(pairs.pinning());
    CHECK(std::abs(pairs.pinning()) > 1e-9);
    check_close(other, pairs.pinning(), 3e-13);
  }
}

TEST_CASE("masses enter the symplectic form and the force", "[property][floquet]") {
  Problem problem = small_problem(Centre::site, 1.1);
  const Orbit<double> plain = find_breather(problem);
  std::vector<double> mass(15, 1);
  mass[8] = 1.01;
  vary(problem.chain, mass, std::vector<double>(16, 1));
  problem.symmetry = even_in_time(15);
  const Orbit<double> orbit = newton(problem, problem.reduce(plain.start));
  const Pairs<double> pairs = pairs_at(problem, orbit);
  CHECK(pairs.defect < 1e-12);
  CHECK(pairs.phase_error < 1e-12);
  // The heavy bead changes the pinning pair far beyond the error of its two computations.
  Problem uniform = small_problem(Centre::site, 1.1);
  uniform.symmetry = even_in_time(15);
  const Orbit<double> same = newton(uniform, uniform.reduce(plain.start));
  CHECK(std::abs(pairs.pinning() - pairs_at(uniform, same).pinning()) > 1e-8);
  const Matrix<double> raw = monodromy(problem.chain, orbit.start, orbit.period() / 2);
  CHECK(symplectic_defect(raw) > 1e6 * pairs.defect);  // in the form that forgets the masses
}

TEST_CASE("an orbit that does not begin at rest is refused", "[unit][floquet]") {
  const Problem problem = small_problem(Centre::site, 1.1);
  Orbit<double> orbit = find_breather(problem);
  orbit.start.v[3] = 1e-3;
  CHECK_THROWS_AS(pairs_at(problem, orbit), std::invalid_argument);
}

TEST_CASE("two tolerances and two precisions agree within the error", "[convergence][floquet]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const Problem problem = small_problem(centre, 1.1);
    const Orbit<double> orbit = find_breather(problem);
    const auto narrow = compare_pairs(pairs_at(problem, orbit, 16), pairs_at(problem, orbit));
    const auto wide_problem = in_precision<long double>(problem);
    const auto wide_orbit = newton(wide_problem, orbit);
    const auto wide = floquet_pairs(wide_problem.chain, wide_orbit.start, wide_orbit.period());
    CHECK(narrow.front().error < 1e-13);
    check_close(narrow.front().kappa.real(), double(wide.pinning()), narrow.front().error);
  }
}

TEST_CASE("near +1 an error of the matrix costs its root, of kappa itself", "[property][floquet]") {
  const Problem problem = small_problem(Centre::bond, 1.1);
  const Orbit<double> orbit = find_breather(problem);
  const auto n = Eigen::Index(problem.chain.sites);
  const Matrix<double> exact_map = monodromy(problem.chain, orbit.start, orbit.period());
  const double delta = 1e-7;
  const std::vector<double> noise = shaken(std::vector<double>(std::size_t(4 * n * n), 1), 1, 7);
  Matrix<double> map = exact_map;
  for (Eigen::Index i = 0; i < map.size(); ++i)
    map.data()[i] += delta * (noise[std::size_t(i)] - 1);
  double worst = 0;
  const auto kappa =
      [&](const Matrix<double>& of) {  // 8 kappa is a sum over the four nearest to +1
        std::complex<double> sum = 0;
        for (const auto& lambda : eigenvalues_of(of))
          if (const double from = std::abs(lambda - 1.0); from < 0.1)
            worst = std::max(worst, from), sum += (lambda - 1.0) * (lambda - 1.0) / lambda;
        return sum.real() / 8;
      };
  const double change = kappa(exact_map) - kappa(map);
  CHECK(worst > std::sqrt(delta) / 10);
  CHECK(std::abs(change) < 100 * delta);
}

TEST_CASE("an exchange is found between two frequencies and nowhere else", "[property][floquet]") {
  const Cut cut{false, 0};
  const Orbit<double> near = find_breather(problem_at(Centre::site, {1.07, 0}));
  const Exchange found = exchange<double>(Centre::site, cut, 1.07, 1.08, near);
  check_close(found.place.value, 1.07503529, 5e-8 + found.place.error);
  CHECK(found.place.error < 1e-6);
  CHECK_THROWS_AS(exchange<double>(Centre::site, cut, 1.08, 1.09, near), NoBranch);
}

TEST_CASE("exchanges near the end of a family are found one by one", "[property][floquet]") {
  // Near the fold kappa turns within a step; by a program of its own, in 113 bits where a value is given
  const InWells all = exchanges_in_wells(Centre::site, 1.9);
  CHECK(all.places.size() == 14);
  for (double s : {-0.1124255782044, -0.1672073123952, -0.1700711611364})
    CHECK(std::count_if(all.places.begin(), all.places.end(), [&](const Estimate& e) {
            return std::abs(e.value - s) < 3 * e.error + 1e-13 && e.error < 1e-9;
          }) == 1);
  for (const auto& [low, high] : {std::pair{-0.1733, -0.172}, {-0.1742, -0.1733}})
    CHECK(std::count_if(all.places.begin(), all.places.end(),
                        [&, low = low, high = high](const Estimate& e) {
                          return e.value - e.error > low && e.value + e.error < high;
                        }) == 1);
}

TEST_CASE("two exchanges between neighbouring wells are found", "[property][exchange]") {
  const double omega_b = 1.3265;
  const auto kappa = [&](double s) {
    Orbit<double> orbit = find_breather(problem_at(Centre::site, {omega_b, 0}));
    return quick_kappa(Centre::site, {omega_b, s}, orbit);
  };
  const auto found = exchanges_in_wells(Centre::site, omega_b);
  CHECK((found.from == -1 && found.to == 1));
  REQUIRE(found.places.size() == 2);
  CHECK(kappa(0) * kappa(0.05) > 0);  // at the neighbours nothing is seen
  for (const Estimate& e : found.places) {
    CHECK((e.value > 0 && e.value < 0.05));
    CHECK(kappa(e.value - 1e-5) * kappa(e.value + 1e-5) < 0);
  }
  CHECK(exchanges_in_wells(Centre::bond, 1.1).places.size() == 1);
  // Whichever end of the bracket comes first; kappa, in extended precision, vanishes there
  const Orbit<double> linear = find_breather(problem_at(Centre::site, {1.5, 0}));
  for (const auto& [low, high] : {std::pair{-0.25, -0.2}, {-0.2, -0.25}}) {
    const Estimate place = exchange<double>(Centre::site, {true, 1.5}, low, high, linear).place;
    check_close(place.value, -0.202052324796, 3 * place.error);
    CHECK(place.error < 1e-6);
  }
}
