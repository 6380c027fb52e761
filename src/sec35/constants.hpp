#pragma once
/**
# From materials to constants

This file integrates the equation of a beam (cantilever.hpp) and the pressure between two spheres. */

#include <cmath>
#include <numbers>

#include "lattice/cantilever/cantilever.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

/// Table `beam`: stiffness, frequency and effective mass of a clamped beam, and what the model with a point mass costs.
inline void report_beam(Report& report, const CantileverArray& array) {
  const double root = clamped_root(), shooting = ClampedBeam{}.wavenumber();
  const auto mass = [](double x) { return 192 / (x * x * x * x); };
  const double load = 2 * array.bead_mass() / array.beam_mass();
  const auto model_over_beam = [&](std::size_t steps) {  // with two beads
    const double x = ClampedBeam{steps, load}.wavenumber();
    return std::sqrt(192 / (mass(root) + load)) / (x * x);
  };
  const Estimate stiffness =
                     with_error(ClampedBeam{200}.stiffness(0), ClampedBeam{400}.stiffness(0)),
                 model = with_error(model_over_beam(200), model_over_beam(400));
  report.table("beam").add({{"stiffness", stiffness},
                            {"frequency", with_error(shooting * shooting, root * root)},
                            {"mass", with_error(mass(shooting), mass(root))},
                            {"model", model}});
}

/**
## Two spheres touch

A pressure $p$ on the surface of a half space presses it in by $\frac{1-\nu^2}{\pi\mathcal E}\int p\,d^2r'/|r-r'|$, with
the Young modulus $\mathcal E$ and Poisson's ratio $\nu$. Hertz's pressure on a disc of radius $a$, $p_0(1-r^2/a^2)^{1/2}$,
makes a hollow that is a paraboloid. We integrate along all chords through a point of the disc, on which the pressure is
half an ellipse. */
/// How far, in units of a and of p_0 (1 - nu^2)/(pi E).
inline double pressed_in(double r, std::size_t points) {
  const auto weight = std::numbers::pi / double(points);
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t j = 0; j < points; ++j) {
      const double across = r * std::sin(weight * double(i)), along = std::cos(weight * double(j));
      sum += weight * weight * (1 - across * across) * along * along;
    }
  return sum;
}

/// The force between two beads of the array over (their approach)^(3/2), in N/m^(3/2), for a contact disc of 0.1 mm.
inline double hertz(const CantileverArray& array, double first, double second, std::size_t points) {
  const double a = 1e-4, soft = (1 - array.nu * array.nu) / (std::numbers::pi * array.bead_modulus);
  const double curved = (1 / first + 1 / second) / array.radius, middle = pressed_in(0, points);
  const auto pressure = [&](double r) {  // with which both hollows make room for both spheres
    return r * r * a * curved / 2 / (2 * soft * (middle - pressed_in(r, points)));
  };
  if (std::abs(pressure(0.25) / pressure(0.75) - 1) > 1e-12)
    throw Failure("Hertz's pressure does not fit to spheres");
  const double force = 2 * std::numbers::pi / 3 * a * a * pressure(0.5),
               approach = 2 * soft * a * pressure(0.5) * middle;
  return force / (approach * std::sqrt(approach));
}

/// Table `hertz`: the article's coefficients over the force between two elastic spheres, for pairs of radii.
inline void report_hertz(Report& report, const CantileverArray& array) {
  Table& table = report.table("hertz");
  const double radii[] = {0.5, 1, 1.6, 2.5};  // in units of the usual one
  for (double first : radii)
    for (double second : radii) {
      const Estimate ours =
          with_error(hertz(array, first, second, 16), hertz(array, first, second, 32));
      const double eta = std::sqrt(2 * first * second / (first + second));
      const auto over = [&](double modulus) {
        return quotient(exact(array.gamma(modulus) * eta), ours);
      };
      table.add({{"first", first},
                 {"second", second},
                 {"printed", over(array.bead_modulus)},
                 {"with_beam", over(array.beam_modulus)}});
    }
}

/// Table `schematic`: what figure 1 needs.
inline void report_schematic(Report& report, const CantileverArray& array, double string_length) {
  Table& drawn = report.table("schematic");
  const auto add = [&](const char* id, const char* parameter, double value, const char* unit) {
    drawn.add({{"id", id}, {"parameter", parameter}, {"value", value}, {"unit", unit}});
  };
  add("cradle", "string_length", string_length, "m");
  add("cradle", "beads_drawn", 5, "");
  add("cradle", "bead_radius_drawn", 0.04, "m");
  for (const auto& [name, unit, value] : given_scales(array)) add("cantilever", name, value, unit);
  add("cantilever", "beads_per_cantilever", 2, "");
  add("cantilever", "pitch", array.thickness + 4 * array.radius, "m");
  add("cantilever", "cantilevers_drawn", 5, "");
}

}  // namespace lattice
