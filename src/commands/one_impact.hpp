#pragma once
/**
# One impact with your own parameters

`sec34_impact run --velocity 1.87 --s -0.1667 --time 587` measures a single impact in the way of section 3.4
(sec34_impact.cpp), for any well and, with `--precompression`, for the compressed contacts of section 4. The
speed is fitted on the way out, from site 20 to twenty sites before the far end; where the packet never
gets there it is `nan`. Over a long stretch a packet slows down as it sheds energy, so the value
depends on the window. If a bead runs away the command fails, because then there is no packet to
measure. It also fails if the motion reaches the far end, unless you choose the end yourself with
`--sites`: then what it sends back belongs to the run, and `far_end_moved` says whether there is any.

The packet that is measured is the foremost one. In hard wells it may be weak, and `strongest_site` tells where most of
the energy is. In Python this is `lattice.strike`, which also takes chains that no option can describe. */

#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

namespace lattice {

/// The command: the impact (dimensionless), its two runs, its tables.
struct OneImpact {
  static constexpr Title title{
      "run", "one impact: speed, centre, energies of the foremost packet",
      "A quantity that does not exist is nan, and its reason says why.\n"
      "For s > 0 most of the energy may lag behind the foremost packet, at strongest_site;\n"
      "sec34_boomeron run follows this packet, which turns."};
  Impact impact{1.87, {.well = Quartic{}}, 600};
  std::optional<std::size_t> sites{};  ///< otherwise as many as needed
  bool as_profile = false;             ///< whether `table` is the profile
  double tolerance = 1e-4;  ///< of the end states of two runs, relative to their largest entry

  /// Declares them with wells and contacts of any name.
  void parameters(Parameters& p);

  struct Found {
    Impact impact;            ///< on a chain that has a length
    Refined<ImpactRun> runs;  ///< that agree to the tolerance
  };
  /// Both runs. Throws RefinementFailed, FarEndReached, and RanAway if a bead runs away.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// The state at the end, bead by bead.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
