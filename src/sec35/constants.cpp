#include "sec35/constants.hpp"

#include <cmath>
#include <numbers>

namespace lattice {

void report_beam(Report& report, const CantileverArray& array) {
  const auto both = [](auto of) { return compare(of(200), of(400)); };
  const double x = clamped_root(), by_shooting = ClampedBeam{}.wavenumber();
  const auto mass = [](double root) { return 192 / (root * root * root * root); };
  const double load = 2 * array.bead_mass() / array.beam_mass();
  // Lowest frequency of spring and point mass, with the printed fraction of the beam's mass or with ours
  const auto model = [&](double effective) { return std::sqrt(192 / (effective + load)); };
  const auto over_decorated = [&](double frequency, std::size_t steps) {
    const double root = ClampedBeam{steps, load}.wavenumber();
    return frequency / (root * root);
  };

  // Two resolutions each, or two routes
  const double printed = model(array.beam_share), own = model(mass(x));
  report.table("beam").add(
      {{"stiffness", "force at the middle over its deflection",
        both([](std::size_t steps) { return ClampedBeam{steps}.stiffness(0); }), "E I/l^3"},
       {"frequency", "lowest frequency, the square of the wavenumber",
        compare(by_shooting * by_shooting, x * x), "(E I/(rho A))^(1/2)/l^2",
        "shooting against cos x cosh x = 1"},
       {"mass", "mass with which the spring has this frequency",
        compare(mass(by_shooting), mass(x)), "mass of the beam",
        "shooting against cos x cosh x = 1"},
       {"model_over_decorated",
        "frequency of spring and mass over that of the beam with two beads, 0.38 as printed",
        compare(over_decorated(printed, 200), over_decorated(printed, 400))},
       {"own_over_decorated", "the same with all digits of the effective mass",
        compare(over_decorated(own, 200), over_decorated(own, 400))}});
}

/**
## Two spheres touch

A pressure $p$ on the surface of a half space presses it in by $\frac{1-\nu^2}{\pi\mathcal E}\int p\,d^2r'/|r-r'|$, with
the Young modulus $\mathcal E$ and Poisson's ratio $\nu$. Hertz's pressure on a disc of radius $a$, $p_0(1-r^2/a^2)^{1/2}$,
makes a hollow that is a paraboloid. We integrate along all chords through a point of the disc, on which the pressure is
half an ellipse. */
/// How far, in units of a and of p_0 (1 - nu^2)/(pi E).
static double pressed_in(double r, std::size_t points) {
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
static double hertz(const CantileverArray& array, double first, double second, std::size_t points) {
  const double a = 1e-4, soft = (1 - array.nu * array.nu) / (std::numbers::pi * array.bead_modulus);
  const double curved = (1 / first + 1 / second) / array.radius, middle = pressed_in(0, points);
  const auto pressure = [&](double r) {  // with which both hollows make room for both spheres
    return r * r * a * curved / 2 / (2 * soft * (middle - pressed_in(r, points)));
  };
  if (std::abs(pressure(0.25) / pressure(0.75) - 1) > 1e-12)
    throw Failure("Hertz's pressure does not fit to spheres");

  // Force and approach of the two spheres
  const double force = 2 * std::numbers::pi / 3 * a * a * pressure(0.5),
               approach = 2 * soft * a * pressure(0.5) * middle;
  return force / (approach * std::sqrt(approach));
}

// All pairs of radii
void report_hertz(Report& report, const CantileverArray& array) {
  Table& table = report.table("hertz");
  const double radii[] = {0.5, 1, 1.6, 2.5};  // in units of the usual one

  for (double first : radii)
    for (double second : radii) {
      const Estimate ours =
          compare(hertz(array, first, second, 16), hertz(array, first, second, 32));
      const double eta = std::sqrt(2 * first * second / (first + second));
      const auto over = [&](double modulus) {
        return quotient(exact(array.gamma(modulus) * eta), ours);
      };
      table.add({{"first", "radius of a bead over the usual one", first},
                 {"second", "that of the bead which it touches", second},
                 {"printed", "the article's coefficient over Hertz's, with the beads' modulus",
                  over(array.bead_modulus)},
                 {"with_beam", "the same with the beams' modulus", over(array.beam_modulus)}});
    }
}

void report_schematic(Report& report, const CantileverArray& array, double string_length) {
  Table& drawn = report.table(
      "schematic", {label("id", "part of the figure"), label("parameter", "name of the dimension"),
                    number("value", "value of the dimension"), label("unit", "unit of the value")});
  drawn.add({"cradle", "string_length", string_length, "m"});
  drawn.add({"cradle", "beads_drawn", 5.0, ""});
  drawn.add({"cradle", "bead_radius_drawn", 0.04, "m"});
  for (const auto& [name, unit, value] : given_scales(array))
    drawn.add({"cantilever", name, value, unit});
  drawn.add({"cantilever", "beads_per_cantilever", 2.0, ""});
  drawn.add({"cantilever", "pitch", array.thickness + 4 * array.radius, "m"});
  drawn.add({"cantilever", "cantilevers_drawn", 5.0, ""});
}

}  // namespace lattice
