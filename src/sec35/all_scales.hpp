#pragma once
/**
# All constants of a cradle and of an array

A cradle's $\lambda^{5/2}$, Eq. (29), rests on a length of half a metre and on a collision that was measured to take
0.077 ms. */

#include <string>

#include "report/program.hpp"
#include "sec3/array_impact.hpp"
#include "sec35/collision.hpp"

namespace lattice {

/// lambda^(5/2) of a cradle, for gravity in m/s^2 and the contact time in units of tau_h.
inline double cradle(double gravity, double contact_time) {
  return cradle_ratio(gravity, 0.5, 0.077e-3, contact_time);  // length in m, contact in s
}

/**
To let the reader check every constant, `scales` prints them: the article's input and everything that
follows from it in closed form. The last rows show that the beam's modulus in place of the beads'
would have given a $\lambda$ that is not small. */
inline Table scales_table(const StruckArray& blow) {
  const CantileverArray& a = blow.array;
  const Scales &s = blow.scales, steel{s.m, s.k, a.gamma(a.beam_modulus)};
  const double v = blow.velocity;
  const Collision known = collision_by_energy();
  Table table{quantity_columns()};
  const auto add = [&](const std::string& name, double value, const std::string& unit = "") {
    table.add({name, exact(value), unit, "exact"});
  };
  for (const auto& [name, unit, value] : given_scales(a)) add(name, value, unit);
  add("impact_velocity", v, "m/s");
  for (const auto& [name, unit, value] : derived_scales(a, v)) add(name, value, unit);
  add("contact_time", known.contact_time * s.tau_h(v), "s");
  add("max_compression", known.compression * s.delta(v), "m");
  add("cradle_lambda_5_2", cradle(9.81, known.contact_time));
  add("gamma_with_beam_modulus", steel.gamma, "N/m^(3/2)");
  add("lambda_with_beam_modulus", steel.lambda(v));
  return table;
}

/**
Figure 1 is drawn to scale, so it needs these lengths. The two beads of each cantilever, one on either
side, touch those of its neighbours, so that the pitch is one thickness and four radii. The cradle's
string has the length of section 3.5; the size of its beads is not given there and is ours. */
inline void report_scales(Report& report, const StruckArray& blow) {
  const Scales& s = blow.scales;
  const CantileverArray& a = blow.array;
  report.output.add("scales", scales_table(blow));
  report.facts.add("tau_h", exact(s.tau_h(blow.velocity) * 1e3), "ms");
  report.facts.add("tau_c", exact(s.tau_c() * 1e3), "ms");
  report.facts.add("lambda", exact(s.lambda(blow.velocity)));

  // What the drawing needs
  Table& drawn = report.table(
      "schematic", {label("id", "part of the figure"), label("parameter", "what is measured"),
                    number("value", "its size"), label("unit", "unit of the value")});
  drawn.add({"cradle", "string_length", 0.5, "m"});
  drawn.add({"cradle", "beads_drawn", 5.0, ""});
  drawn.add({"cradle", "bead_radius_drawn", 0.04, "m"});
  for (const auto& [name, unit, value] : given_scales(a))
    drawn.add({"cantilever", name, value, unit});
  drawn.add({"cantilever", "beads_per_cantilever", 2.0, ""});
  drawn.add({"cantilever", "pitch", a.thickness + 4 * a.radius, "m"});
  drawn.add({"cantilever", "cantilevers_drawn", 5.0, ""});
}

/**
The command `scales` prints them for an impact velocity of your choice. */
struct AllScales {
  static constexpr Title title{"scales", "all constants in SI units"};
  double velocity = 1;  ///< m/s

  void parameters(Parameters& p) {
    p.add("velocity", velocity, "impact velocity in m/s", {1e-6, 1e3, "m/s"});
  }
  Table table() const { return scales_table(StruckArray{.velocity = velocity}); }
};

}  // namespace lattice
