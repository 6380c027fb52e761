#pragma once
/**
# All constants of an array, with your own impact

`sec35_scales scales --velocity 1` prints the article's input for the array of cantilevers and everything that follows
from it in closed form. The last rows show that the beam's modulus in place of the beads' would have given a $\lambda$
that is not small. */

#include <cmath>
#include <numbers>
#include <string>

#include "lattice/cantilever/cantilever.hpp"
#include "report/program.hpp"
#include "sec35/collision.hpp"

namespace lattice {
using namespace report;

/// The command: an impact velocity in m/s.
struct AllScales {
  static constexpr Title title{"scales",
                               "constants of the cantilever array and of the cradle, in SI units"};
  double velocity = 1;
  CantileverArray array{};
  Cradle cradle{};

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "velocity of the impact on the first bead, in m/s",
          {1e-6, 1e3, "m/s"});
  }
  Table table() const {
    const Scales s = array.scales(), steel{s.m, s.k, array.gamma(array.beam_modulus)};
    const double lambda = s.lambda(velocity);
    const Collision known = collision_by_energy();
    Table table{quantity_columns()};
    const auto add = [&](const std::string& name, double value, const std::string& unit = "") {
      table.add({name, exact(value), unit, "exact"});
    };
    // What an experimenter chooses
    for (const auto& [name, unit, value] : given_scales(array)) add(name, value, unit);
    add("impact_velocity", velocity, "m/s");
    // The model: masses, stiffnesses, and the scales of time, length and energy
    add("area_moment", array.area_moment(), "m^4");
    add("beam_mass", array.beam_mass(), "kg");
    add("bead_mass", array.bead_mass(), "kg");
    add("effective_mass", s.m, "kg");
    add("stiffness", s.k, "N/m");
    add("gamma", s.gamma, "N/m^(3/2)");
    add("tau_h", s.tau_h(velocity), "s");
    add("tau_c", s.tau_c(), "s");
    add("linear_period", 2 * std::numbers::pi * s.tau_c(), "s");
    add("delta", s.delta(velocity), "m");
    add("hertz_stiffness", s.gamma * std::sqrt(s.delta(velocity)), "N/m");
    add("xi", s.xi(), "m");
    add("lambda", lambda);
    add("lambda_5_2", lambda * lambda * std::sqrt(lambda));
    add("unit_velocity", s.unit_velocity(), "m/s");
    add("unit_force", s.unit_force(), "N");
    add("unit_energy", s.unit_energy(), "J");
    add("contact_time", known.contact_time * s.tau_h(velocity), "s");
    add("max_compression", known.compression * s.delta(velocity), "m");
    add("cradle_lambda_5_2", cradle.lambda_5_2(9.81, known.contact_time));
    add("gamma_with_beam_modulus", steel.gamma, "N/m^(3/2)");
    add("lambda_with_beam_modulus", steel.lambda(velocity));
    return table;
  }
};

}  // namespace lattice
