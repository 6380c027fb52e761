// The worked example of CONTRIBUTING.md: a well that the library does not know, added here in
// fifteen lines, checked, put in a list, struck and refined, without touching anything else.

#include "check_potential.hpp"
#include "lattice/packets/impact.hpp"

using namespace lattice;

namespace {

/// W = cosh y - 1: stiffer and stiffer, like no polynomial.
struct Cosh {
  static constexpr const char* name = "cosh";
  template <class T>
  T energy(T y) const {
    using std::sinh;
    const T half = sinh(y / T(2));
    return T(2) * half * half;
  }
  template <class T>
  T force(T y) const {
    using std::sinh;
    return -sinh(y);
  }
  template <class T>
  T stiffness(T y) const {
    using std::cosh;
    return cosh(y);
  }
};

/// Where the packet is at the end, and what the run says about itself.
struct Struck {
  State<double> end;
  Run run;
};

Struck strike(double step) {
  const Chain chain{60, Cosh{}};
  Struck out{struck(60, 1.5), {}};
  out.run = evolve(ContactAware{step}, chain, out.end, 60, 60, Unobserved{});
  return out;
}

}  // namespace

TEST_CASE("a new well passes the checks of all wells", "[unit][potential]") {
  check_well(Cosh{});
}

TEST_CASE("its name and its chain need a place in a list, no more", "[unit][potential]") {
  using Wells = std::variant<None, Harmonic, Quartic, Pendulum, Cosh>;
  CHECK(std::holds_alternative<Cosh>(named<Wells>("cosh")));
  CHECK(comma_list(names_of<Wells>()) == "none, harmonic, quartic, pendulum, cosh");
}

TEST_CASE("a chain of new wells is struck, and the run converges", "[convergence]") {
  const Struck coarse = strike(0.1), middle = strike(0.05), fine = strike(0.025);
  const double first = distance(coarse.end, middle.end), second = distance(middle.end, fine.end);
  CAPTURE(first, second, middle.run.energy_drift, fine.run.energy_drift);
  CHECK(second > 0);
  CHECK(second < first / 8);  // at least order three where contacts switch
  CHECK(second < 1e-5);
  CHECK(fine.run.energy_drift < 1e-6);
  CHECK(front_packet(energy_density(Chain{60, Cosh{}}, fine.end)).value_or(0) > 5);
}
