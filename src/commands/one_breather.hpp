#pragma once
/**
# One breather with your own parameters

`sec32_newton_breathers breather --centre site --omega 1.1` computes one breather of section 3.2. The chain
must be long enough for it: a bead at the end must not feel that its outer neighbour is missing, and a longer
chain tells how much it would. `--well pendulum` takes another well. All have the same frequency at rest, so that their
families begin alike, and each is followed from there.

Contacts may have another exponent (`--contact power --alpha 1.8`) or be compressed (`--precompression 1e-3
--omega 1.3`), and beads may have two masses in turn (`--mass-ratio 0.8 --omega 1.3`) or one other in the middle
(`--defect-mass 1.5`); the frequency must then be above the linear waves of the chain. In Python this is
`lattice.breather`. */

#include <vector>

#include "sec3/breather_options.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;

/// An orbit in double and in extended precision (a 64-bit mantissa), from which all that is said of it is read.
struct FoundOrbit : Fitted {
  Orbit<Wide> wide;
  std::vector<Estimate> y;  ///< positions at t = 0

  /// A number of the orbit, with the difference of the two precisions.
  template <class Of>
  Estimate of(Of number) const {
    return with_error(double(number(orbit)), double(number(wide)));
  }
};

/**
A reader may want the tail, and so every site is asked for relative accuracy (`scaled_rule`). Where the tail leaves the
range of the numbers within a few sites, as it does between stiff contacts, that cannot be reached: then the orbit is
accurate relative to its amplitude, and a second solve, from a point beside the first one, brings the tail. The
positions are compared with those of an orbit that begins at rest in the tail and has the tolerance of double
precision: what the equations do not determine differs, and the error says so. No site is believed to be known better
than the worst of the large ones, which excludes agreement by chance. */
/// The breather in extended precision. Throws NewtonFailed.
inline FoundOrbit in_two_precisions(const Fitted& found) {
  const auto problem = in_precision<Wide>(found.problem);
  // Double precision often tells at once that not every site can be asked
  bool scaled = true;
  const auto solve_scaled = [&](const Orbit<double>& from, const EventTolerance<Wide>& events) {
    NewtonRule<Wide> how = scaled_rule<Wide>();
    how.events.tolerance = events.tolerance, how.most_steps = 10;
    return newton(problem, from, how);
  };
  const auto solve = [&](const Orbit<double>& from, bool fine) {
    NewtonRule<Wide> how = rule<Wide>(Resolution::fine);
    if (!fine) how.events.tolerance = rule<double>(Resolution::fine).events.tolerance;
    try {
      if (scaled) return solve_scaled(from, how.events);
    } catch (const NewtonFailed&) {
      scaled = false;
    }
    Orbit<Wide> orbit = newton(problem, from, how);
    if (!fine) return orbit;
    orbit.x *= Wide(1.000001);
    return newton(problem, orbit, how);
  };
  try {
    newton(found.problem, found.orbit, scaled_rule<double>());
  } catch (const NewtonFailed&) {
    scaled = false;
  }
  Orbit<double> other = found.orbit;
  for (double& x : other.x)
    if (std::abs(x) < 1e-10 * found.orbit.amplitude) x = 0;
  FoundOrbit out{found, solve(found.orbit, true), {}};
  const Orbit<Wide> coarse = solve(other, false);
  double worst = 0;
  for (std::size_t n = 0; n < coarse.start.y.size(); ++n) {
    out.y.push_back(with_error(double(coarse.start.y[n]), double(out.wide.start.y[n])));
    const auto& [y, error, is_exact] = out.y.back();
    if (std::abs(y) > 0.01 * found.orbit.amplitude) worst = std::max(worst, error / std::abs(y));
  }
  for (Estimate& y : out.y) y.error = std::max(y.error, worst * std::abs(y.value));
  return out;
}

/// What is said of an orbit beside its positions. The residual is that of the whole period, relative to `amplitude`.
inline void add_orbit(Answers& q, const FoundOrbit& found, const Estimate& amplitude,
                      const std::string& meaning) {
  const Orbit<double>& orbit = found.orbit;
  State<double> end = orbit.start;
  const FlowReport<double> run = flow(found.problem.chain, end, found.problem.period(), {});
  const double size = amplitude.value, miss = largest_difference(end, orbit.start) / size;
  q.add("amplitude", amplitude, "", meaning);
  q.add("energy", found.of([](const auto& o) { return o.energy; }), "",
        "energy of the whole chain, Eq. (6)");
  q.add("area", found.of([](const auto& o) { return o.action_integral; }), "",
        "integral over a period of the sum of mass times squared velocity, 2 pi times the action");
  q.add_small("residual", {miss, double(run.error) * orbit.amplitude / size},
              "relative to amplitude",
              "largest difference between positions and velocities at the start and after one "
              "period");
  q.add("iterations", exact(double(orbit.iterations())), "",
        "number of Newton steps in the last solve");
}

/// The command: which breather, what Newton finds, its tables.
struct OneBreather : ChosenBreather {
  static constexpr Title title{
      "breather", "one breather: amplitude, energy, area (2 pi times the action) and residual"};
  bool as_profile = false;  ///< whether `table` is the profile

  void parameters(Parameters& p) {
    add_omega(p);
    add_well(p);
    add_contacts(p);
    add_masses(p);
    add_centre(p);
    p.add("sites", sites, "number of sites (default: 31 or 32)", {3, 1001});
    add_phase(p);
    p.add("profile", as_profile, "print the positions at t = 0 (columns n, y, y_error) instead");
  }
  /// The breather. Throws UsageError, NewtonFailed, NoBranch.
  FoundOrbit find() const { return in_two_precisions(find_chosen(*this, 1e-17)); }

  /// Errors are differences of the two precisions.
  Table quantities(const FoundOrbit& found) const {
    Answers q;
    add_orbit(q, found, found.of([](const auto& o) { return o.amplitude; }),
              "largest displacement of a bead at t = 0, when all beads are at rest");
    return q.table;
  }

  /// The positions at t = 0.
  Table profile(const FoundOrbit& found) const {
    Table table{
        {count("n", "site", "site"),
         estimate("y", "position at t = 0", "",
                  "difference of two tolerances, which leaves no digit far out in the tail")}};
    for (std::size_t i = 0; i < found.y.size(); ++i)
      table.add({site_number(i, found.y.size()), found.y[i]});
    return table;
  }
  Table table() const { return as_profile ? profile(find()) : quantities(find()); }
};

}  // namespace lattice
