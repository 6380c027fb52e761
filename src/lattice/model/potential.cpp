#include "lattice/model/potential.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace lattice {

namespace {

/**
## The check of a potential

A stated slope is believed if a central difference with either of two steps agrees with it: the short one where the
function is steep or has fine structure, the long one where it loses digits. What is left of an error below the slack
shows in the tangent map of an orbit (orbits/floquet.hpp). */
constexpr double steps[] = {0x1p-24, 0x1p-9};
constexpr double slack = 1e-3;  ///< relative error of a slope that is still believed

/// Where the check is made, in units of a length; no place at which a table or a kink is likely.
constexpr double places[] = {0.83541, 0.31273, 0.071639, 6.1343e-4};
/// The energy is checked at the first two only: it may lose digits near rest, where the dynamics does not need it.
constexpr std::size_t energy_places = 2;
constexpr std::size_t samples = 1 + 2 * std::size(steps);

/// The index of the middle of place `k`, the four on the left of the centre first.
constexpr std::size_t middle(std::size_t k) {
  return 1 + k * samples;
}

/// What one of the three functions returns at the points `x`.
struct Row {
  const char* name;
  std::vector<double> at;
};

/// All three at rest, then at the samples of one place after the other: its middle and two neighbours for each step.
struct Probe {
  std::string what;  ///< well or contact
  std::vector<double> x;
  Row energy{"energy", x}, force{"force", x}, stiffness{"stiffness", x};

  Probe(const std::string& kind, const OwnPotential& p, std::vector<double> points)
      : what(kind), x(std::move(points)) {
    p.row(PotentialFunction::energy, x.data(), energy.at.data(), x.size());
    p.row(PotentialFunction::force, x.data(), force.at.data(), x.size());
    p.row(PotentialFunction::stiffness, x.data(), stiffness.at.data(), x.size());
  }
};

/// A complaint in one line.
template <class... Word>
std::invalid_argument complaint(const std::string& what, const Word&... word) {
  std::ostringstream text;
  text << "the " << what << "'s ";
  (text << ... << word);
  return std::invalid_argument(text.str());
}

/// Throws for the first value that is no finite number.
void require_finite(const Probe& probe) {
  for (const Row* row : {&probe.energy, &probe.force, &probe.stiffness})
    for (std::size_t i = 0; i < probe.x.size(); ++i)
      if (!std::isfinite(row->at[i]))
        throw complaint(probe.what, row->name, "(", probe.x[i], ") is ", row->at[i],
                        ", not a finite number");
}

/// The values on both sides of `centre`, at places in units of `length`. A well may end in a wall or grow beyond all
/// numbers: then the places come closer to the centre. Throws if there are none.
Probe probe_about(const std::string& what, const OwnPotential& p, double centre, double length) {
  for (double unit = length;; unit /= 10) {
    std::vector<double> x{0};
    for (const double side : {-1.0, 1.0})
      for (const double place : places) {
        const double distance = side * place * unit;
        x.push_back(centre + distance);
        for (const double step : steps)
          for (const double way : {-1.0, 1.0}) x.push_back(centre + distance * (1 + way * step));
      }
    Probe probe(what, p, std::move(x));
    try {
      require_finite(probe);
      return probe;
    } catch (const std::invalid_argument&) {
      if (unit < 1e-12 * length) throw;
    }
  }
}

/// What the slope in the middle is instead of `stated`, if it is another one. Rounding is part of a difference, and it may
/// reach the size of a few units in the last place of what is subtracted.
std::optional<double> other_slope(const double* x, const double* f, double stated) {
  double slope = 0;
  for (std::size_t k = 1; k < samples; k += 2) {
    const double width = x[k + 1] - x[k], size = std::max(std::abs(f[k]), std::abs(f[k + 1]));
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * size / std::abs(width);
    slope = (f[k] - f[k + 1]) / width;
    const double most = slack * std::max(std::abs(stated), std::abs(slope)) + rounding;
    if (!(std::abs(stated - slope) > most)) return std::nullopt;
  }
  return slope;
}

/// Throws unless the functions belong together at every place of the probe.
void require_slopes(const Probe& probe) {
  const auto look = [&](const Row& slope, const Row& of, std::size_t at) {
    if (const auto found = other_slope(&probe.x[at], &of.at[at], slope.at[at]))
      throw complaint(probe.what, slope.name, "(", probe.x[at], ") is ", slope.at[at],
                      ", but minus the slope of its ", of.name, " is ", *found, " there");
  };
  for (std::size_t k = 0; k < 2 * std::size(places); ++k) {
    if (k % std::size(places) < energy_places) look(probe.force, probe.energy, middle(k));
    look(probe.stiffness, probe.force, middle(k));
  }
}

/// Throws unless energy and force vanish at rest, up to the rounding of larger terms.
void require_rest(const Probe& probe) {
  const auto look = [&](const Row& row, const char* cure) {
    double most = 0;
    for (const double value : row.at) most = std::max(most, std::abs(value));
    if (std::abs(row.at[0]) > 1e-6 * most)
      throw complaint(probe.what, row.name, "(0) is ", row.at[0], " and must be 0: ", cure);
  };
  look(probe.energy, "subtract it");
  look(probe.force, "measure displacements from the rest position");
}

}  // namespace

void require_well(const OwnPotential& well, double rim) {
  if (!(rim > 0))
    throw complaint("well", "rim is ", rim, " and must be > 0 (infinite if there is no rim)");
  const Probe probe = probe_about("well", well, 0, std::min(rim, 1.0));
  require_rest(probe);
  require_slopes(probe);
}

// A contact has a corner at its opening, and beads that are pressed may rest elsewhere: then both are looked at
void require_contact(const OwnPotential& contact, double opening, double exponent) {
  const std::string what = "contact";
  if (!std::isfinite(opening))
    throw complaint(what, "opening is ", opening, " and must be a finite number");
  if (!(exponent >= 1 && std::isfinite(exponent)))
    throw complaint(what, "exponent is ", exponent, " and must be a finite number >= 1");
  const Probe probe = probe_about(what, contact, opening, 1);
  require_rest(probe);
  require_slopes(probe);
  if (opening != 0)
    require_slopes(probe_about(what, contact, 0, std::min(std::abs(opening) / 2, 1.0)));
  // Just before the opening and just beyond it, the last of the places on either side
  const std::size_t before = middle(std::size(places) - 1),
                    beyond = middle(2 * std::size(places) - 1);
  const double pressed = probe.force.at[before], open = probe.force.at[beyond];
  if (pressed < open - 1e-9 * std::abs(open))
    throw complaint(what, "force(", probe.x[before], ") is ", pressed, " and must be at least ",
                    open, ", that of an open contact: the contact pulls");
}

/**
Close to zero a force is a power of the displacement, and so its values at $y$, $2y$ and $4y$ have a common
ratio. That of a force which subtracts numbers of size one has none, or vanishes. */
bool loses_digits(const OwnPotential& potential) {
  for (const double y : {0.83541e-20, -0.83541e-20}) {
    if (std::abs(potential.stiffness(y)) < 1e-200) continue;
    const double force = potential.force(2 * y), ratio = force / potential.force(y);
    const double next = potential.force(4 * y) / force;
    if (!(std::abs(next - ratio) < 1e-6 * std::abs(ratio))) return true;
  }
  return false;
}

}  // namespace lattice
