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

A stated slope is compared with central differences at steps that become shorter by factors of eight. An honest
potential agrees at one of them; where it does not, be it that the function is steep, has a kink or loses digits,
the differences disagree with each other too. So we refuse a slope only if the three shortest steps tell of the same
error. What is left of an error below the slack shows in the tangent map of an orbit (orbits/floquet.hpp). */
constexpr double steps[] = {0x1p-6, 0x1p-9, 0x1p-12, 0x1p-15, 0x1p-18, 0x1p-21, 0x1p-24};
constexpr double slack = 1e-3;  ///< relative error of a slope that is still believed

/// Where the check is made, in units of a length; no place at which a table or a kink is likely.
constexpr double places[] = {0.83541, 0.31273, 0.071639, 6.1343e-4};
/// The energy is checked at the first two only: it may lose digits near rest, where the dynamics does not need it.
constexpr std::size_t energy_places = 2;
constexpr std::size_t samples = 1 + 2 * std::size(steps);

/// What the three functions return at the points `x`: rest, then the samples of one place after the other.
struct Rows {
  std::vector<double> x, energy, force, stiffness;

  Rows(const OwnPotential& p, std::vector<double> at)
      : x(std::move(at)), energy(x.size()), force(x.size()), stiffness(x.size()) {
    p.energies(x.data(), energy.data(), x.size());
    p.forces(x.data(), force.data(), x.size());
    p.stiffnesses(x.data(), stiffness.data(), x.size());
  }
};

/// A complaint about `what`, a well or a contact, in one line.
template <class... Word>
std::invalid_argument complaint(const std::string& what, const Word&... word) {
  std::ostringstream text;
  text << "the " << what << "'s ";
  (text << ... << word);
  return std::invalid_argument(text.str());
}

/// Throws for the first value that is no finite number.
void require_finite(const std::string& what, const Rows& rows) {
  const auto look = [&](const char* name, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw complaint(what, name, "(", rows.x[i], ") is ", values[i], ", not a finite number");
  };
  look("energy", rows.energy);
  look("force", rows.force);
  look("stiffness", rows.stiffness);
}

/**
A well may end in a wall or grow beyond all numbers: then the places come closer to the centre. */
/// The values on both sides of `centre`, at places in units of `length` or less. Throws if there are none.
Rows rows_about(const std::string& what, const OwnPotential& p, double centre, double length) {
  for (double unit = length;; unit /= 10) {
    std::vector<double> x{0};
    for (const double side : {-1.0, 1.0})
      for (const double place : places) {
        const double distance = side * place * unit;
        x.push_back(centre + distance);
        for (const double step : steps)
          for (const double way : {-1.0, 1.0}) x.push_back(centre + distance * (1 + way * step));
      }
    Rows rows(p, std::move(x));
    try {
      require_finite(what, rows);
      return rows;
    } catch (const std::invalid_argument&) {
      if (unit < 1e-12 * length) throw;
    }
  }
}

/**
The samples of a place are its middle and a pair of neighbours for each step. Rounding is part of a difference,
and it may reach the size of a few units in the last place of what is subtracted. */
/// What the slope in the middle is instead of `stated`, if it is another one.
std::optional<double> other_slope(const double* x, const double* f, double stated) {
  std::vector<double> off;
  double slope = 0;
  for (std::size_t k = 1; k < samples; k += 2) {
    const double width = x[k + 1] - x[k], size = std::max(std::abs(f[k]), std::abs(f[k + 1]));
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * size / std::abs(width);
    slope = (f[k] - f[k + 1]) / width;
    off.push_back(stated - slope);
    const double most = slack * std::max(std::abs(stated), std::abs(slope)) + rounding;
    if (std::abs(off.back()) <= most || !std::isfinite(off.back())) return std::nullopt;
  }
  const auto [low, high] = std::minmax_element(off.end() - 3, off.end());
  if (*high - *low > 0.5 * std::min(std::abs(*low), std::abs(*high))) return std::nullopt;
  return slope;
}

/// Throws unless the functions belong together at every place of the rows.
void require_slopes(const std::string& what, const Rows& rows) {
  const auto look = [&](const char* slope, const char* of, const std::vector<double>& stated,
                        const std::vector<double>& f, std::size_t at) {
    if (const auto found = other_slope(&rows.x[at], &f[at], stated[at]))
      throw complaint(what, slope, "(", rows.x[at], ") is ", stated[at],
                      ", and minus the slope of its ", of, " is ", *found, " there");
  };
  for (std::size_t k = 0; k < 2 * std::size(places); ++k) {
    const std::size_t at = 1 + k * samples;
    if (k % std::size(places) < energy_places) look("force", "energy", rows.force, rows.energy, at);
    look("stiffness", "force", rows.stiffness, rows.force, at);
  }
}

double largest_of(const std::vector<double>& values) {
  double most = 0;
  for (const double x : values) most = std::max(most, std::abs(x));
  return most;
}

/// Throws unless energy and force vanish at rest, up to the rounding of larger terms.
void require_rest(const std::string& what, const Rows& rows) {
  const auto look = [&](const char* name, const std::vector<double>& values, const char* cure) {
    if (std::abs(values[0]) > 1e-6 * largest_of(values))
      throw complaint(what, name, "(0) is ", values[0], " and must be 0: ", cure);
  };
  look("energy", rows.energy, "subtract it");
  look("force", rows.force, "count displacements from the place of rest");
}

}  // namespace

void require_well(const OwnPotential& well, double rim) {
  if (!(rim > 0)) throw complaint("well", "rim is ", rim, " and must be > 0 (infinite: none)");
  const Rows rows = rows_about("well", well, 0, std::min(rim, 1.0));
  require_rest("well", rows);
  require_slopes("well", rows);
}

/**
A contact has a corner at its opening, and beads that are pressed may rest elsewhere: then both are looked at. */
void require_contact(const OwnPotential& contact, double opening, double exponent) {
  const std::string what = "contact";
  if (!std::isfinite(opening))
    throw complaint(what, "opening is ", opening, " and must be a finite number");
  if (!(exponent >= 1 && std::isfinite(exponent)))
    throw complaint(what, "exponent is ", exponent, " and must be a finite number >= 1");
  const Rows rows = rows_about(what, contact, opening, 1);
  require_rest(what, rows);
  require_slopes(what, rows);
  if (opening != 0)
    require_slopes(what, rows_about(what, contact, 0, std::min(std::abs(opening) / 2, 1.0)));
  // Just beyond the opening and just before it, the last of the places on either side
  const double open = rows.force[1 + (2 * std::size(places) - 1) * samples];
  const double pressed = rows.force[1 + (std::size(places) - 1) * samples];
  if (pressed < open - 1e-9 * std::abs(open))
    throw complaint(what, "force(", rows.x[1 + (std::size(places) - 1) * samples], ") is ", pressed,
                    " and must be at least ", open, ", that of an open contact: it pulls");
}

/**
## Digits near rest

Close to zero a force is a power of the displacement, and so its values at $y$, $2y$ and $4y$ have a common
ratio. That of a force which subtracts numbers of size one has none, or vanishes. */
bool loses_digits(const OwnPotential& potential) {
  for (const double y : {0.83541e-20, -0.83541e-20}) {
    const double x[] = {y, 2 * y, 4 * y};
    double force[3], stiffness[3];
    potential.forces(x, force, 3);
    potential.stiffnesses(x, stiffness, 3);
    if (std::abs(stiffness[0]) < 1e-200) continue;
    const double ratio = force[1] / force[0], next = force[2] / force[1];
    if (!(std::abs(next - ratio) < 1e-6 * std::abs(ratio))) return true;
  }
  return false;
}

}  // namespace lattice
