// Exact travelling breathers: the sum that selects their speeds, the equations, orbits of type I, what they leave
// behind, the flow over a shift, and their limit of small amplitude.

#include "sec5/travelling.hpp"
#include "sec5/dps_travelling.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// All equations, the one included that a family leaves out.
Vector<double> all_equations(const Orbit<double>& orbit, double s = 0) {
  const auto problem = with_free_time(travelling_problem(shift_time(orbit), s));
  return problem.evaluate(with_time(orbit.x, shift_time(orbit)), {}, false).residual /
         orbit.amplitude;
}

/// Largest amplitude left behind by `shifts` shifts, relative to the orbit's.
double left_behind(const Orbit<double>& orbit, std::size_t shifts) {
  const Chain chain{shifts + 24};
  State<double> state = embed(orbit.start, chain.sites, 0);
  evolve(method_for(1e-12, 0.025), chain, state, double(shifts) * shift_time(orbit), Every{10});
  double left = 0;
  for (std::size_t n = 0; n + 8 < shifts; ++n)
    left = std::max(left, std::hypot(state.y[n], state.v[n]));
  return left / orbit.amplitude;
}

const Orbit<double>& first_orbit(int sign) {
  static const Orbit<double> plus = TypeOneOrbits(1).orbit_at(1),
                             minus = TypeOneOrbits(-1).orbit_at(1);
  return sign > 0 ? plus : minus;
}

}  // namespace

TEST_CASE("the equation that a family leaves out is V sin(T/2) in the linear well",
          "[property][travelling]") {
  // For any unknowns whatever, not only for orbits: the position equations add up to it.
  for (const auto& [time, s] : {std::pair{2 * pi<double>(), 0.0}, {5.3, 0.0}, {5.3, 0.7}}) {
    const auto problem = with_free_time(travelling_problem(time, s, 4));
    Vector<double> x(10);
    x << -0.2, 0.1, 0.02, 0.001, 0.4, -0.2, -0.03, 0.004, 1e-5, time;
    const Vector<double> residual = problem.evaluate(x, {}, false).residual;
    double sum = 0;
    for (Eigen::Index i = 0; i < residual.size(); i += 2) sum += residual[i];
    const double v = x[4] + 2 * x.segment(5, 4).sum();
    CAPTURE(time, s);
    if (s == 0)
      check_close(sum, v * std::sin(time / 2), 1e-12);
    else
      CHECK(std::abs(sum - v * std::sin(time / 2)) > 1e-4);
  }
}

TEST_CASE("the state at a part of the way between two others", "[unit][travelling]") {
  State<double> a(2), b(2);
  a.y = {1, 2}, a.v = {3, -4};
  b.y = {5, 0}, b.v = {3, 4};
  const State<double> z = between(a, b, 0.25);
  CHECK(z.y == std::vector<double>{2, 1.5});
  CHECK(z.v == std::vector<double>{3, -2});
}

TEST_CASE("an impact's packet becomes an exact orbit in a few steps", "[convergence][travelling]") {
  for (int sign : {1, -1}) {
    const Orbit<double> orbit =
        newton(type_one<double>(5), cut_packet(TypeOneOrbits::first_velocity, 15, 30, sign));
    CAPTURE(sign, orbit.residual());
    CHECK(orbit.iterations() <= 9);
    CHECK(sign * orbit.start.v[usual_half_length] > 0);
    CHECK(sup(all_equations(orbit)) < 1e-12);
    check_close(orbit.energy, 9.41445093783471e-5, 0, 1e-11);
  }
}

TEST_CASE("both orbits with one oscillation a site", "[convergence][travelling]") {
  const double energies[]{0.180833513579908, 0.180833513658335};
  for (int sign : {1, -1}) check_close(first_orbit(sign).energy, energies[sign < 0], 0, 2e-13);
  check_close(shift_time(first_orbit(1)), 2 * pi<double>(), 0, 1e-15);
  // A longer chain has the same orbit
  check_close(TypeOneOrbits(1, 9).orbit_at(1).energy, energies[0], 0, 1e-12);
}

TEST_CASE("an exact orbit leaves nothing behind, its neighbours on the family do",
          "[property][travelling]") {
  CHECK(left_behind(first_orbit(1), 24) < 1e-10);
  const auto family = follow_family(first_orbit(1), 6.1, 0.1);
  const double expected =
      2 * std::abs(std::sin(shift_time(family.back()) / 2) * velocity_sum(family.back()));
  const double left = left_behind(family.back(), 24);
  CHECK(left > 0.3 * expected);
  CHECK(left < 3 * expected);
  CHECK(expected > 1e-5);
  check_close(std::abs(all_equations(family.back())[0]), expected / 2, 1e-12);
}

TEST_CASE("the DpS equation has its own orbit of type I, the limit of the chain's",
          "[convergence][travelling]") {
  DpsTravelling problem;
  const DpsMember member = dps_member(problem, cut_dps_packet(40, problem.half_length));
  CHECK(std::abs(problem.residuals(member.x)[0]) < 1e-12);
  const double limit = 2 * member.norm * std::pow(problem.shift_time, 4);
  check_close(limit, 65.55230988, 0, 1e-8);
  // The chain comes closer with 1/k.
  TypeOneOrbits orbits(1);
  const auto off = [&](std::size_t k) {
    return orbits.orbit_at(k).energy * std::pow(2 * pi<double>() * double(k), 4) - limit;
  };
  const double five = off(5), ten = off(10);
  CHECK(ten < 0.55 * five);
  CHECK(ten > 0.4 * five);
  // The left-out equation again.
  problem.phase = 0.3;
  const DpsMember next = dps_member(problem, member.x);
  check_close(problem.residuals(next.x)[0], next.V * std::sin(0.15), 0, 1e-8);
}

TEST_CASE("equations of a travelling breather of the DpS equation", "[unit][travelling]") {
  DpsTravelling problem;
  CHECK((problem.half_length == 8 && problem.phase == 0 &&
         DpsTravelling::shift_time == 2 * pi<double>()));
  CHECK(problem.tolerance == 1e-13);
  problem.half_length = 3, problem.phase = 0.7;
  Vector<double> x(7);
  x << 0.5, -0.2, 0.3, 0.1, 0.05, -0.03, 0.02;
  const auto residuals = [&](const Vector<double>& u) {
    // Sites -3 to 4; those on the left are the mirror images
    Field a{{-u[5], u[6]}, {-u[3], u[4]}, {-u[1], u[2]}, {0, u[0]},
            {u[1], u[2]},  {u[3], u[4]},  {u[5], u[6]},  0};
    evolve_dps(Dps{8}, a, pi<double>(), 1, 1e-13, [](double, const Field&) {});
    Vector<double> out(8);
    for (int n = 1; n <= 4; ++n) {
      const std::complex<double> w = std::polar(1.0, -0.35) * a[std::size_t(3 + n)],
                                 v = std::polar(1.0, -0.35) * a[std::size_t(4 - n)];
      out[2 * n - 2] = (w + v).real(), out[2 * n - 1] = (w - v).imag();
    }
    return out;
  };
  const Vector<double> expected = residuals(x), all = problem.residuals(x);
  const Equations<double> equations = problem.equations();
  const Evaluation<double> here = equations.evaluate(x, {}, true),
                           bare = equations.evaluate(x, {}, false);
  for (int i = 0; i < 8; ++i) check_close(all[i], expected[i], 1e-11);
  CHECK((here.residual == all.tail(7) && bare.residual == here.residual &&
         bare.jacobian.size() == 0));
  for (int k = 0; k < 7; ++k) {
    const Vector<double> e = 1e-5 * Vector<double>::Unit(7, k),
                         slope = (residuals(x + e) - residuals(x - e)) / 2e-5;
    for (int i = 0; i < 7; ++i) check_close(here.jacobian(i, k), slope[i + 1], 2e-7);
    check_close(equations.sizes(x, false).unknown[k], 0.5, 0);
    check_close(equations.sizes(x, true).equation[k], 0.5, 0);
  }
}

TEST_CASE("the flow over a shift and its multipliers", "[unit][travelling]") {
  Chain chain{4};
  State<double> start(4);
  start.y = {0.3, -0.1, 0.2, -0.25}, start.v = {0.1, -0.2, 0.3, 0.05};
  const Matrix<double> map = shifted_map(chain, start, 1.7);
  const auto after = [&](std::size_t k, double change) {
    State<double> z = start;
    (k < 4 ? z.y[k] : z.v[k - 4]) += change;
    flow(chain, z, 1.7);
    return z;
  };
  for (std::size_t k = 0; k < 8; ++k) {
    const State<double> more = after(k, 1e-5), less = after(k, -1e-5);
    for (std::size_t n = 0; n < 4; ++n) {
      const bool last = n == 3;
      check_close(map(Eigen::Index(n), Eigen::Index(k)),
                  last ? 0 : (more.y[n + 1] - less.y[n + 1]) / 2e-5, 1e-7);
      check_close(map(Eigen::Index(4 + n), Eigen::Index(k)),
                  last ? 0 : (more.v[n + 1] - less.v[n + 1]) / 2e-5, 1e-7);
    }
  }
  Matrix<double> diagonal = Matrix<double>::Zero(3, 3);
  diagonal.diagonal() << 0.5, -2, 1.5;
  const auto all = multipliers_of(diagonal);
  for (std::size_t i = 0; i < 3; ++i)
    check_close(all[i].real(), std::array{-2.0, 1.5, 0.5}[i], 1e-14);
  // The four next to +1: 1 +- i/2, 1.25 and 0.75; (z - 1)^2 / z = -1/4 / z and so on
  const double kappa = (-0.25 * 2 / 1.25 + 0.0625 / 1.25 + 0.0625 / 0.75) / 8;
  check_close(
      phase_kappa<double>({{3, 0}, {1, 0.5}, {0.4, 0}, {1.25, 0}, {1, -0.5}, {0.75, 0}, {-1, 0}}),
      kappa, 1e-15);
}

TEST_CASE("the derivative with respect to a free period is exact", "[unit][travelling]") {
  Shooting<double> problem = breather_problem(Centre::site, 1.1, 0.3, 11);
  problem.chain.sites = 10;
  problem.symmetry = travelling_reversible(4, true);
  Vector<double> x(10);
  x << 0.02, -0.01, 0.001, 0, 0.03, -0.02, 0.004, 0.001, 0, 6;
  const Evaluation<double> here = problem.evaluate(x, {});
  for (Eigen::Index k : {0, 4, 5, 9}) {
    const Vector<double> slope = slope_along(problem, x, k, k == 9 ? 1e-6 : 1e-8);
    CAPTURE(k);
    CHECK(sup<double>(slope - here.jacobian.col(k)) < 1e-5);
  }
}
