// A well that the library does not know, as in CONTRIBUTING.md: named in a list, struck and refined.

#include "lattice/impact/impact.hpp"
#include "support/check_potential.hpp"

using namespace lattice;

namespace {

/// W = cosh y - 1: stiffer and stiffer, like no polynomial.
struct Stiffer {
  static constexpr const char* name = "stiffer";
  double energy(double y) const { return 2 * std::pow(std::sinh(y / 2), 2); }
  double force(double y) const { return -std::sinh(y); }
  double stiffness(double y) const { return std::cosh(y); }
};

/// Where the packet is at the end, and what the run says about itself.
struct Struck {
  State<double> end;
  Run run;
};

Struck strike(double step) {
  const Chain chain{60, Stiffer{}};
  Struck out{struck(60, 1.5), {}};
  out.run = evolve(EventCorrected{step}, chain, out.end, 60, 60);
  return out;
}

}  // namespace

TEST_CASE("the name of a new well needs a place in a list, no more", "[unit][potential]") {
  using Wells = std::variant<None, Harmonic, Quartic, Pendulum, Stiffer>;
  CHECK(std::holds_alternative<Stiffer>(named<Wells>("stiffer")));
  CHECK(comma_list(names_of<Wells>()) == "none, harmonic, quartic, pendulum, stiffer");
}

TEST_CASE("a chain of new wells is struck, and the run converges", "[convergence]") {
  const Struck coarse = strike(0.1), middle = strike(0.05), fine = strike(0.025);
  const double first = distance(coarse.end, middle.end), second = distance(middle.end, fine.end);
  CAPTURE(first, second, middle.run.energy_drift, fine.run.energy_drift);
  CHECK(second > 0);
  CHECK(second < first / 8);  // at least order three where contacts switch
  CHECK(second < 1e-5);
  CHECK(fine.run.energy_drift < 1e-6);
  CHECK(front_packet(energy_density(Chain{60, Stiffer{}}, fine.end)).value_or(0) > 5);
}
