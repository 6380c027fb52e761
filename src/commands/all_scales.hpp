#pragma once
/**
# All constants of an array, with your own impact

`sec35_scales scales --velocity 1` prints the article's input for the array of cantilevers and everything that follows
from it in closed form, so that every constant can be checked. The last rows show that the beam's modulus in place of
the beads' would have given a $\lambda$ that is not small. */

#include "report/program.hpp"

namespace lattice {

/// The command: an impact velocity in m/s.
struct AllScales {
  static constexpr Title title{"scales", "all constants in SI units"};
  double velocity = 1;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "impact velocity in m/s", {1e-6, 1e3, "m/s"});
  }
  Table table() const;
};

}  // namespace lattice
