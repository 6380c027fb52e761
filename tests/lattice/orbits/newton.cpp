// Newton's method and the equations of shooting: derivatives, convergence, precisions, symmetries, and what is refused.

#include "lattice/orbits/newton.hpp"

#include "lattice/gsl/random.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/resolutions.hpp"
#include "support/check.hpp"
#include "support/return_error.hpp"

using namespace lattice;

namespace {

using Problem = Shooting<double>;

/// The quartic well, but by another name, so that nothing is known of its anharmonicity.
struct Nameless {
  double s;
  double energy(double y) const { return Quartic{s}.energy(y); }
  double force(double y) const { return Quartic{s}.force(y); }
  double stiffness(double y) const { return Quartic{s}.stiffness(y); }
};

/// Why a breather between contacts of exponent `alpha` in such wells is not found.
std::string refused(double omega, double s, double alpha) {
  Problem problem = breather_problem(Centre::site, omega, Nameless{s}, 61);
  problem.chain.contact = PowerContact{alpha};
  return refusal<NewtonFailed>([&] { find_breather(problem); });
}

}  // namespace

TEST_CASE("the derivatives of the equations are exact", "[unit][periodic]") {
  for (Centre centre : both_centres) {
    const auto p = problem_of(centre, 1.1, 0.5);
    const Orbit<double> o = find_breather(p);
    const Evaluation<double> here = p.evaluate(o.x, {});
    // The equations have derivatives of order 3/2 only, so the difference quotient errs by h^{1/2}.
    const double h = 1e-8 * o.amplitude;
    for (Eigen::Index k : {o.x.size() / 2, o.x.size() / 2 + 1})
      CHECK(sup<double>(slope_along(p, o.x, k, h) - here.jacobian.col(k)) < 3e-5);
    auto faster = p, slower = p;
    faster.omega += 1e-6;
    slower.omega -= 1e-6;
    const Vector<double> slope =
        (faster.evaluate(o.x, {}, false).residual - slower.evaluate(o.x, {}, false).residual) /
        2e-6;
    CHECK(sup<double>(slope + p.period() / p.omega * here.residual_period) < 1e-7 * o.amplitude);
  }
}

TEST_CASE("Newton's method converges quadratically", "[convergence][periodic]") {
  for (Centre centre : both_centres) {
    const History history = find_breather(problem_of(centre, 1.1)).history;
    REQUIRE(history.size() >= 4);
    CHECK(history.size() <= 7);
    for (std::size_t k = 1; k + 1 < history.size() && history[k + 1].residual > 1e-12; ++k) {
      CAPTURE(k, history[k].residual, history[k + 1].residual);
      CHECK(history[k + 1].residual < 30 * history[k].residual * history[k].residual);
    }
  }
}

TEST_CASE("Newton's method takes any residual", "[unit][orbits]") {
  // Where a circle meets a hyperbola, from differences and from a derivative that was computed before
  const auto residual = [](const Vector<double>& x) {
    return Vector<double>{{x[0] * x[0] + x[1] * x[1] - 4, x[0] * x[1] - 1}};
  };
  const Equations<double> equations = by_differences("the crossing", residual, 1e-6);
  const Vector<double> guess{{2, 0.5}};
  const Solution<double> found = newton(equations, guess);
  check_close(found.x[0], std::sqrt(2 + std::sqrt(3.0)), 1e-14);
  check_close(found.x[0] * found.x[1], 1, 1e-14);
  CHECK(found.history.size() < 7);
  const Matrix<double> derivative{{4, 1}, {0.5, 2}};
  const Solution<double> chord = newton(equations, guess, {}, &derivative);
  CHECK(sup<double>(chord.x - found.x) < 1e-13);
  CHECK(chord.evaluation.jacobian == derivative);
  CHECK(refusal<NewtonFailed>([&] {
          newton(equations, Vector<double>{{1, -1}});
        }).find("the crossing: ") == 0);
}

TEST_CASE("damped Newton converges from where the plain one runs away", "[property][orbits]") {
  const Problem problem = breather_problem(Centre::site, 1.1, 0, 21);
  const Orbit<double> orbit = find_breather(problem);
  NewtonRule<double> damped;
  damped.damped = true;
  damped.most_steps = 60;
  std::size_t found = 0;
  for (unsigned long seed = 1; seed <= 4; ++seed) {
    State<double> start = orbit.start;
    start.y = perturbed(start.y, 0.5, seed);
    try {
      CHECK(return_error(problem, newton(problem, problem.reduce(start), damped)) < 1e-11);
      ++found;
    } catch (const NewtonFailed& error) {
      CHECK(error.history.size() > 1);
    }
  }
  CHECK(found >= 2);
}

TEST_CASE("extended precision agrees, and refines with the derivative of double precision",
          "[convergence][orbits]") {
  for (Centre centre : both_centres) {
    const Problem problem = problem_of(centre, 1.1);
    const Orbit<double> orbit = find_breather(problem);
    const auto wide = in_precision<long double>(problem);
    const auto chord = newton(wide, orbit);
    const auto full = newton(wide, orbit.x.cast<long double>().eval());
    CHECK(sup<long double>(chord.x - full.x) < 1e-15L * full.amplitude);
    CHECK(chord.residual() < 1e-15);
    check_close(double(chord.energy_omega), double(full.energy_omega), 0, 1e-9);
    check_close(orbit.energy, double(full.energy), 0, 1e-12);
    check_close(orbit.action_integral, double(full.action_integral), 0, 1e-12);
  }
}

TEST_CASE("every site of the tail is known to relative accuracy", "[convergence][periodic]") {
  const auto p = problem_of(Centre::site, 1.1);
  const Orbit<double> o = find_breather(p);
  const auto a = newton(p, o, scaled_rule<double>());
  const auto b = newton(in_precision<long double>(p), o, scaled_rule<long double>());
  for (std::size_t n = 15; n < 29; ++n) check_close(a.start.y[n], double(b.start.y[n]), 0, 1e-9);
  CHECK(std::abs(a.start.y[28]) < 1e-130);
  CHECK(std::abs(a.start.y[28]) > 0);
}

TEST_CASE("an orbit is refused where its flow is not accurate", "[unit][orbits]") {
  const Problem good = problem_of(Centre::site, 1.1);
  const Orbit<double> orbit = find_breather(good);
  CHECK_NOTHROW(newton(good, orbit.x));
  // An integrator that is given too few levels, and a flow that reports what it missed
  NewtonRule<double> coarse;
  coarse.events.levels = 1;
  CHECK_THROWS_AS(newton(good, orbit.x, coarse), NewtonFailed);
  Equations<double> missing = good.equations();
  missing.evaluate = [&](const Vector<double>& x, const EventTolerance<double>& rule, bool slopes) {
    Evaluation<double> here = good.evaluate(x, rule, slopes);
    ++here.flow.missed_events;
    return here;
  };
  CHECK_THROWS_AS(newton(missing, orbit.x), NewtonFailed);
}

TEST_CASE("a large extended motion is not taken for a breather", "[unit][orbits]") {
  // Newton's method converges to a motion of energy 65.8, with an error of 1e-13
  check_line(refused(1.1, 5, 2.8), "not the breather but a motion of size");
  // Nor is one whose middle beads move together
  CHECK(refused(1.01, 3, 3).find("with neighbours in phase") != std::string::npos);
  // Nor does an iteration go on that leaps to violent motions, whose next flow took minutes
  CHECK(refused(1.1, 3, 2.5).find("the iterate grows far beyond the guess, from size 0.2 to") !=
        std::string::npos);
}

TEST_CASE("an orbit that shrinks to rest is none", "[unit][orbits]") {
  // The breather of spheres is a bad guess for other contacts: numbers of size 1e-321 came of it
  Problem problem = breather_problem(Centre::bond, 1.05, 0, 16);
  problem.chain.contact = PowerContact{1.75};
  const State<double> guess = ansatz(Centre::bond, 1.05, 16);
  const auto far = [&] { newton(problem, problem.reduce(guess)); };
  const std::string why = refusal<NewtonFailed>(far);
  CAPTURE(why);
  CHECK(why.find("bond-centred orbit at omega_b = 1.05: the iterate shrinks to rest, from size "
                 "0.0021 to ") == 0);
  CHECK(why.find("; relative residuals 1.1e-01, ") != std::string::npos);
  CHECK(why.find('\n') == std::string::npos);
  CHECK_THROWS_AS(newton(problem, problem.reduce(State<double>(16))), NewtonFailed);
}
