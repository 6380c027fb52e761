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

#include "lattice/orbits/breather_pairs.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {

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
    p.add("profile", as_profile, "print the positions at t = 0 (columns n, y) instead");
  }
  /// The breather. Throws UsageError, NewtonFailed, NoBranch.
  Fitted find() const { return find_chosen(*this, 1e-17); }

  /**
  Errors are differences from an orbit in extended precision (a 64-bit mantissa). The residual is that of the whole
  period. */
  Table quantities(const Fitted& found) const {
    const Orbit<double>& orbit = found.orbit;
    const Orbit<Wide> wide = newton(in_precision<Wide>(found.problem), orbit, rule<Wide>(0));
    State<double> end = orbit.start;
    const FlowReport<double> run = flow(found.problem.chain, end, found.problem.period(), {});
    const double miss = largest_difference(end, orbit.start) / orbit.amplitude;
    const auto differs = [](double a, const Wide& b) {
      return Estimate{a, double(magnitude<double>(a - double(b)))};
    };
    Answers q;
    q.add("amplitude", differs(orbit.amplitude, wide.amplitude), "",
          "largest displacement of a bead at t = 0, when all beads are at rest");
    q.add("energy", differs(orbit.energy, wide.energy), "", "energy of the whole chain, Eq. (6)");
    q.add(
        "area", differs(orbit.area, wide.area), "",
        "integral over a period of the sum of mass times squared velocity, 2 pi times the action");
    q.add_small(
        "residual", {miss, double(run.error)}, "relative to amplitude",
        "largest difference between positions and velocities at the start and after one period");
    q.add("iterations", exact(double(orbit.iterations())), "",
          "number of Newton steps in the last solve");
    return q.table;
  }

  /// The positions at t = 0. A reader may want the tail, so they have relative accuracy at every site.
  Table profile(const Fitted& found) const {
    const Orbit<double> orbit = newton(found.problem, found.orbit, scaled_rule<double>());
    Table table{{count("n", "site", "site"), number("y", "position at t = 0")}};
    for (std::size_t i = 0; i < orbit.start.y.size(); ++i)
      table.add({site_number(i, orbit.start.y.size()), orbit.start.y[i]});
    return table;
  }
  Table table() const { return as_profile ? profile(find()) : quantities(find()); }
};

}  // namespace lattice
