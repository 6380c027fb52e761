// Breathers that are held at a centre, between a site and a bond.

#include "sec33/held.hpp"

#include "check.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec33/exchange.hpp"

using namespace lattice;

TEST_CASE("a breather held at a site or bond stands at the exchange", "[property][floquet]") {
  // In double precision the parameter is known to a few digits only, see held.hpp.
  Problem problem = small_problem(Centre::site, 1.1, 0.15);
  const Orbit<double> orbit = find_breather(problem);
  problem.symmetry = even_in_time(15);
  Held<double> held{problem, along_s<double>(), 0.2};
  Vector<double> x(16);
  x << problem.reduce(orbit.start), 0.15;
  const Shot<double> shot = held.shoot(x, {});
  for (Eigen::Index k : {5, 7, 8, 15}) {
    const Vector<double> slope = slope_along(held, x, k, k == 15 ? 1e-4 : 1e-7);
    CAPTURE(k);
    CHECK(sup<double>(slope - shot.jacobian.col(k)) < 1e-5 * (1 + sup<double>(slope)));
  }
  check_close(shot.miss[15], -0.2, 1e-12);  // the orbit is at its site, not at 0.2
}

TEST_CASE("a breather in between is found twice, by solutions of their own",
          "[property][floquet]") {
  Problem problem = problem_at(Centre::site, {1.1, 0.1525196});
  const Orbit<double> site = find_breather(problem);
  problem.symmetry = even_in_time(21);
  Vector<double> x(22);
  x << site.x, 0.1525196;
  const Vector<Wide> near =
      moved_to_centre(Held<double>{problem, along_s<double>(), 0.25}, x).cast<Wide>();
  const Held<Wide> held{in_precision<Wide>(problem), along_s<Wide>(), Wide(0.25)};
  const Wide fine = solve(held, near, rule<Wide>(0)).x[21];
  const Wide coarse = solve(held, near, rule<Wide>(1)).x[21];
  CHECK(double(fine) > 0.15251949);  // the exchange around a site
  CHECK(double(fine) < 0.15251982);  // and around a bond
  CHECK(fine != coarse);
  check_close(double(coarse), double(fine), 1e-8);
}
