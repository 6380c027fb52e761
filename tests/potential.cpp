// Each potential: force and stiffness are the derivatives they claim to be, and known values.

#include "lattice/model/contact.hpp"

#include <string>

#include "check.hpp"
#include "lattice/model/well.hpp"

using namespace lattice;

namespace {

/// Central difference with one Richardson step: error of order h^4.
template <class F>
double derivative(F f, double x) {
  const double h = 1e-3;
  const auto d = [&](double k) { return (f(x + k) - f(x - k)) / (2 * k); };
  return (4 * d(h / 2) - d(h)) / 3;
}

template <class Potential>
void check_derivatives(const std::string& name, const Potential& p) {
  DYNAMIC_SECTION(name) {
    for (double x : {-1.3, -0.4, -0.1, 0.2, 0.9, 1.7}) {
      CAPTURE(x);
      check_close(p.force(x), -derivative([&](double u) { return p.energy(u); }, x), 1e-9, 1e-9);
      check_close(p.stiffness(x), -derivative([&](double u) { return p.force(u); }, x), 1e-8, 1e-8);
    }
    CHECK(p.energy(0.0) == 0);
    CHECK(p.force(0.0) == 0);
  }
}

}  // namespace

TEST_CASE("force is minus the gradient, stiffness its slope", "[unit][potential]") {
  check_derivatives("harmonic", Harmonic{});
  check_derivatives("quartic, hard", Quartic{1});
  check_derivatives("quartic, soft", Quartic{-1.0 / 6});
  check_derivatives("pendulum", Pendulum{});
  check_derivatives("Hertz", Hertz{});
  check_derivatives("Hertz, precompressed", CompressedHertz{0.5});
  check_derivatives("power, alpha = 2", PowerContact{2, 0});
  check_derivatives("power, alpha = 3/2, precompressed", PowerContact{1.5, 0.5});
}

TEST_CASE("contacts push and never pull", "[unit][potential]") {
  CHECK(Hertz{}.force(-0.25) == 0.125);  // (1/4)^(3/2)
  CHECK(Hertz{}.force(0.25) == 0);
  CHECK(Hertz{}.force(-1e-61) == 0);  // below the floor
  CHECK(Hertz{.floor = 0}.force(-1e-61) > 0);
  CHECK(Hertz{}.stiffness(0.1) == 0);
  CHECK(CompressedHertz{0.25}.force(0.3) == -0.125);  // open: only the compression is missing
}

TEST_CASE("the general power agrees with the 3/2 law", "[unit][potential]") {
  for (double r : {-2.0, -0.3, -1e-3, 0.1}) {
    check_close(PowerContact{}.force(r), Hertz{}.force(r), 1e-300, 1e-14);
    check_close(PowerContact{}.energy(r), Hertz{}.energy(r), 1e-300, 1e-14);
    check_close(PowerContact{1.5, 0.5}.force(r), CompressedHertz{0.5}.force(r), 1e-15, 1e-13);
  }
}

TEST_CASE("potentials work in extended precision", "[unit][potential]") {
  const long double x = -0.3L;
  check_close(double(Hertz{}.force(x) - 0.3L * sqrtl(0.3L)), 0, 1e-19);
  check_close(double(Quartic{1}.force(x) - (0.3L + 0.027L)), 0, 1e-18);
}
