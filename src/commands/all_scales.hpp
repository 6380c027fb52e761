#pragma once
/**
# All constants of an array, with your own impact

`sec35_scales scales --velocity 1` prints the article's input for the array of cantilevers and everything that follows
from it in closed form. The last rows show that the beam's modulus in place of the beads' would have given a $\lambda$
that is not small. */

#include <string>

#include "lattice/model/cantilever.hpp"
#include "report/program.hpp"
#include "sec35/collision.hpp"

namespace lattice {

/// The command: an impact velocity in m/s.
struct AllScales {
  static constexpr Title title{"scales", "all constants in SI units"};
  double velocity = 1;

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "impact velocity in m/s", {1e-6, 1e3, "m/s"});
  }

  Table table() const {
    const CantileverArray array;
    const Scales s = array.scales(), steel{s.m, s.k, array.gamma(array.beam_modulus)};
    const Collision known = collision_by_energy();
    Table table{quantity_columns()};
    const auto add = [&](const std::string& name, double value, const std::string& unit = "") {
      table.add({name, exact(value), unit, "exact"});
    };
    // What is given and what follows
    for (const auto& [name, unit, value] : given_scales(array)) add(name, value, unit);
    add("impact_velocity", velocity, "m/s");
    for (const auto& [name, unit, value] : derived_scales(array, velocity)) add(name, value, unit);
    add("contact_time", known.contact_time * s.tau_h(velocity), "s");
    add("max_compression", known.compression * s.delta(velocity), "m");
    add("cradle_lambda_5_2", cradle(9.81, known.contact_time));
    add("gamma_with_beam_modulus", steel.gamma, "N/m^(3/2)");
    add("lambda_with_beam_modulus", steel.lambda(velocity));
    return table;
  }
};

}  // namespace lattice
