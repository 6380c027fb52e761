// Periodic orbits: residuals, symmetries, quadratic convergence, branches, folds, precisions, barriers.

#include "lattice/orbits/breather_pairs.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

using Problem = Shooting<double>;

double farthest_apart(const State<double>& a, const State<double>& b, double sign = 1) {
  double d = 0;
  for (std::size_t n = 0; n < a.y.size(); ++n)
    d = std::max({d, std::abs(a.y[n] - sign * b.y[n]), std::abs(a.v[n] - sign * b.v[n])});
  return d;
}

State<double> mirrored(State<double> s) {
  std::reverse(s.y.begin(), s.y.end());
  std::reverse(s.v.begin(), s.v.end());
  return s;
}

State<double> after(const Shooting<double>& p, State<double> s, double time) {
  flow(p.chain, s, time);
  return s;
}

}  // namespace

TEST_CASE("a breather returns after its period", "[property][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (double s : {-1.0 / 6, 0.0, 1.0})
      for (double omega : {1.003, 1.1, 1.5}) {
        CAPTURE(int(centre), s, omega);
        const auto p = problem_of(centre, omega, s);
        const Orbit<double> o = find_breather(p);
        CHECK(farthest_apart(after(p, o.start, p.period()), o.start) < 4e-13 * o.amplitude);
        CHECK(o.residual() < 2e-13);
      }
}

TEST_CASE("at omega_b = 1.1 the residual is at most 1e-13", "[published][periodic]") {
  const auto p = problem_of(Centre::site, 1.1);
  const Orbit<double> o = find_breather(p);
  CHECK(o.residual() < 1e-13);
  CHECK(farthest_apart(after(p, o.start, p.period()), o.start) < 1e-13 * o.amplitude);
}

TEST_CASE("symmetries hold at all times", "[property][periodic]") {
  for (double omega : {1.1, 1.6}) {
    const auto site = problem_of(Centre::site, omega), bond = problem_of(Centre::bond, omega);
    const auto a = find_breather(site), b = find_breather(bond);
    for (double part : {0.13, 0.37, 0.81}) {
      const State<double> now = after(site, a.start, part * site.period());
      const State<double> later = after(site, now, site.period() / 2);
      CHECK(farthest_apart(now, mirrored(later), -1) < 1e-12 * a.amplitude);
      const State<double> then = after(bond, b.start, part * bond.period());
      CHECK(farthest_apart(then, mirrored(then), -1) < 1e-12 * b.amplitude);
    }
  }
}

TEST_CASE("the two phases of a bond-centred breather are half a period apart",
          "[property][periodic]") {
  const auto p = problem_of(Centre::bond, 1.1);
  const auto pressed = find_breather(p), stretched = find_breather(p, Phase::stretched);
  CHECK(pressed.start.y[15] > 0);
  CHECK(stretched.start.y[15] < 0);
  CHECK(farthest_apart(after(p, pressed.start, p.period() / 2), stretched.start) <
        1e-12 * pressed.amplitude);
  check_close(pressed.energy, stretched.energy, 0, 1e-12);
  check_close(pressed.area, stretched.area, 0, 1e-12);
}

TEST_CASE("Newton's method converges quadratically", "[convergence][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const History history = find_breather(problem_of(centre, 1.1)).history;
    REQUIRE(history.size() >= 4);
    CHECK(history.size() <= 7);
    for (std::size_t k = 1; k + 1 < history.size() && history[k + 1].residual > 1e-12; ++k) {
      CAPTURE(k, history[k].residual, history[k + 1].residual);
      CHECK(history[k + 1].residual < 30 * history[k].residual * history[k].residual);
    }
  }
}

TEST_CASE("the derivatives of the equations are exact", "[unit][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
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

TEST_CASE("along a branch dE = dA / T, and the energy's derivative is exact",
          "[property][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (double omega : {1.02, 1.1, 1.4}) {
      const double h = 1e-4 * (omega - 1);
      const auto up = find_breather(problem_of(centre, omega + h));
      const auto down = find_breather(problem_of(centre, omega - h));
      const auto here = find_breather(problem_of(centre, omega));
      CAPTURE(int(centre), omega);
      check_close((up.energy - down.energy) / (2 * h), here.energy_omega, 0, 1e-6);
      check_close((up.energy - down.energy) / (up.area - down.area),
                  1 / problem_of(centre, omega).period(), 0, 1e-6);
    }
}

TEST_CASE("the area is the integral of twice the kinetic energy", "[unit][periodic]") {
  // A single bead: y = a cos t with the area pi a^2 over 2 pi.
  Chain chain;
  chain.sites = 1;
  State<double> s(1);
  s.y[0] = 0.3;
  check_close(flow(chain, s, 2 * pi<double>()).area, pi<double>() * 0.09, 1e-13);
}

TEST_CASE("a breather does not depend on how it was reached", "[property][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto p = problem_of(centre, 1.1, 0.5);
    const Orbit<double> direct = find_breather(p);
    const auto low = problem_of(centre, 1.03, 0.5), linear = problem_of(centre, 1.1, 0);
    Branch rising(low, along_omega<double>(), find_breather(low), 1);
    Branch hardening(linear, along_s<double>(), find_breather(linear), 1);
    for (const Orbit<double>& other : {rising.orbit_at(1.1), hardening.orbit_at(0.5)}) {
      CHECK(sup<double>(other.x - direct.x) < 1e-12 * direct.amplitude);
      check_close(other.energy, direct.energy, 0, 1e-12);
    }
  }
}

TEST_CASE("a branch passes its fold", "[property][periodic]") {
  const auto p = problem_of(Centre::bond, 1.2, -1);
  Branch branch(p, along_omega<double>(), find_breather(p), 1);
  const double fold = branch.fold();
  CHECK(branch.slope() < 0);
  CHECK(fold > 1.6);
  CHECK(fold < 1.65);
  CHECK_THROWS_AS(find_breather(problem_of(Centre::bond, fold + 0.01, -1)), NoBranch);
  CHECK_NOTHROW(find_breather(problem_of(Centre::bond, fold - 0.01, -1)));
}

TEST_CASE("failure comes with its history", "[unit][periodic]") {
  const auto p = problem_of(Centre::site, 1.1);
  NewtonRule<double> hasty;
  hasty.most_steps = 2;
  try {
    newton(p, p.reduce(ansatz(Centre::site, 1.1, 31)), hasty);
    FAIL("two iterations are not enough");
  } catch (const NewtonFailed& error) {
    CHECK(error.history.size() == 3);
    CHECK(std::string(error.what()).find("e-0") != std::string::npos);
  }
  CHECK_THROWS_AS(breather_problem(Centre::site, 1.1, 0, 30), std::invalid_argument);
  CHECK_THROWS_AS(breather_problem(Centre::bond, 1.1, 0, 31), std::invalid_argument);
}

TEST_CASE("double and extended precision agree", "[convergence][periodic]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto p = problem_of(centre, 1.1);
    const Orbit<double> o = find_breather(p);
    const auto wide = newton(in_precision<long double>(p), o);
    check_close(o.energy, double(wide.energy), 0, 1e-12);
    check_close(o.area, double(wide.area), 0, 1e-12);
    CHECK(wide.residual() < 1e-15);
  }
}

TEST_CASE("every site of the tail is known to relative accuracy", "[convergence][periodic]") {
  const auto p = problem_of(Centre::site, 1.1);
  const Orbit<double> o = find_breather(p);
  NewtonRule<double> scaled;
  scaled.scaled = true;
  scaled.events.floor = 0;
  NewtonRule<long double> wide;
  wide.scaled = true;
  wide.events.floor = 0;
  const auto a = newton(p, o, scaled);
  const auto b = newton(in_precision<long double>(p), o, wide);
  for (std::size_t n = 15; n < 29; ++n) check_close(a.start.y[n], double(b.start.y[n]), 0, 1e-9);
  CHECK(std::abs(a.start.y[28]) < 1e-130);
  CHECK(std::abs(a.start.y[28]) > 0);
}

TEST_CASE("barriers agree with an independent computation", "[published][periodic]") {
  // Quadruple precision, another implementation of Newton's method: see the chapter's claims.
  const struct {
    double omega, s, expected;
  } rows[] = {{1.1, 0, 1.62422471641e-11}, {1.01, 0, 2.704657e-15}, {1.5, 0, 6.83194e-9},
              {1.9, 0, 1.41073e-6},        {2.0, 0, -2.15054e-6},   {1.1, 0.2, -7.6413e-12}};
  for (const auto& [omega, s, expected] : rows) {
    CAPTURE(omega, s);
    const auto ps = problem_of(Centre::site, omega, s), pb = problem_of(Centre::bond, omega, s);
    const auto site = find_breather(ps), bond = find_breather(pb);
    const auto gap = barrier(ps, site, bond);
    check_close(gap.equal_frequency, expected, 0, 1e-5);
    auto moved = ps;
    moved.omega = gap.omega_site;
    check_close(newton(moved, site.x).area, bond.area, 0, 1e-10);
  }
}

TEST_CASE("near omega_b = 1 the barrier at equal area follows the scaling law",
          "[convergence][periodic]") {
  double before = 1;
  for (double omega : {1.004, 1.002, 1.001}) {
    const auto ps = problem_of(Centre::site, omega), pb = problem_of(Centre::bond, omega);
    const auto gap = barrier(ps, find_breather(ps), find_breather(pb));
    const double off = gap.equal_area / gap.equal_frequency / (-(omega - 1) / 5) - 1;
    CAPTURE(omega, off);
    CHECK(std::abs(off) < 0.8 * before);
    before = std::abs(off);
  }
  CHECK(before < 0.03);
}

TEST_CASE("a zero of the barrier does not depend on the pairs around it",
          "[convergence][periodic]") {
  const auto zero = [](double from, double to, Estimate BreatherPair::*gap) {
    BreatherPair pairs[] = {{0, from}, {0, to}};
    for (BreatherPair& r : pairs) {
      for (int k : {0, 1}) r.orbit[k] = find_breather(problem_of(both_centres[k], r.omega));
      measure_in<Wide>(r);
    }
    return frequency_of_zero(pairs[0], pairs[1], gap);
  };
  const auto agree = [](const Estimate& a, const Estimate& b) {
    CAPTURE(a.value, a.error, b.value, b.error);
    CHECK(std::abs(a.value - b.value) <= a.error + b.error);
    CHECK(a.error < 1e-8);
  };
  agree(zero(1.05, 1.075, &BreatherPair::equal_frequency),
        zero(1.06, 1.065, &BreatherPair::equal_frequency));
  agree(zero(1.01, 1.025, &BreatherPair::equal_area), zero(1.016, 1.02, &BreatherPair::equal_area));
}
