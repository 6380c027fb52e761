// Breathers that are held at a centre, between a site and a bond.

#include "sec3/resolutions.hpp"
#include "sec33/held.hpp"

#include "lattice/orbits/breather.hpp"
#include "sec3/exchange.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

const double half_turn = std::acos(-1.0);

}  // namespace

TEST_CASE("a breather in between is found twice, by solutions of their own",
          "[property][floquet]") {
  Shooting<double> problem = problem_at(Centre::site, {1.1, 0.1525196});
  const Orbit<double> site = find_breather(problem);
  problem.symmetry = even_in_time(21);
  Vector<double> x(22);
  x << site.x, 0.1525196;
  const Vector<Wide> near =
      moved_to_centre(Held<double>{problem, along_s<double>(), 0.25}, x).cast<Wide>();
  const Held<Wide> held{in_precision<Wide>(problem), along_s<Wide>(), Wide(0.25)};
  const Wide fine = newton(held.equations(), near, rule<Wide>(Resolution::fine)).x[21];
  const Wide coarse = newton(held.equations(), near, rule<Wide>(Resolution::coarse)).x[21];
  CHECK(double(fine) > 0.15251949);  // the exchange around a site
  CHECK(double(fine) < 0.15251982);  // and around a bond
  CHECK(fine != coarse);
  check_close(double(coarse), double(fine), 1e-8);
}

TEST_CASE("a breather held at a centre: its equations and their derivative", "[unit][exchange]") {
  Shooting<double> problem = breather_problem(Centre::site, 1.3, 0.1, 7);
  const Orbit<double> orbit = find_breather(problem);
  problem.symmetry = even_in_time(7);
  const Held<double> held{problem, along_omega<double>(), 0.3};
  CHECK((Held<double>{}.centre == 0 && Held<double>{}.change == 1e-5));
  Vector<double> x(8);
  x << problem.reduce(orbit.start), 1.35;
  x[1] += 0.01, x[4] -= 0.02;
  const auto residual = [&](const Vector<double>& at) {
    State<double> z(7);
    for (std::size_t n = 0; n < 7; ++n) z.y[n] = at[Eigen::Index(n)];
    flow(problem.chain, z, half_turn / at[7]);
    Vector<double> out(8);
    double weight = 0, moment = 0;
    for (int n = 0; n < 7; ++n) {
      out[n] = z.v[n];
      const double w = at[n] * at[n] + z.y[n] * z.y[n];
      weight += w, moment += (n - 3) * w;
    }
    out[7] = moment / weight - 0.3;
    return out;
  };
  const Evaluation<double> here = held.evaluate(x, {});
  check_close((here.residual - residual(x)).cwiseAbs().maxCoeff(), 0, 1e-12);
  CHECK(held.evaluate(x, {}, false).jacobian.size() == 0);
  const double size = here.jacobian.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Vector<double> h = 2e-6 * Vector<double>::Unit(8, k);
    CAPTURE(k);
    check_close(
        ((residual(x + h) - residual(x - h)) / 4e-6 - here.jacobian.col(k)).cwiseAbs().maxCoeff(),
        0, 1e-6 * size);
  }
  const Sizes<double> inner = problem.sizes(x.head(7), true), sizes = held.sizes(x, true);
  for (int n = 0; n < 7; ++n)
    CHECK((sizes.unknown[n] == inner.unknown[n] && sizes.equation[n] == inner.equation[n]));
  CHECK((sizes.unknown[7] == 1 && sizes.equation[7] == 1 && sizes.unknown.size() == 8));
  // Moved to the centre, all equations hold but for a share of the gradient
  const Vector<double> there = moved_to_centre(held, x), rest = residual(there);
  CHECK(there[7] == 1.35);
  check_close(rest[7], 0, 1e-7);
  Vector<double> slope = Vector<double>::Zero(7);
  for (int n = 1; n < 6; ++n) slope[n] = there[n + 1] - there[n - 1];
  const Vector<double> left =
      rest.head(7) - slope * (slope.dot(rest.head(7)) / slope.squaredNorm());
  check_close(left.cwiseAbs().maxCoeff(), 0, 1e-6);
  CHECK(rest.head(7).cwiseAbs().maxCoeff() > 1e-5);
}
