#pragma once
/**
# The DpS impact with your own parameters

`sec31_dps_limit impact --tau 250` strikes the first site of a DpS chain, $A_1(0) = -i$, and measures
the packet that runs away, in the way of the impact chapter (sec34_dps_impact.cpp). It prints the
packet's centre (site), its speed (sites per unit of $\tau$, fitted from site 20 to twenty sites before
the far end), its amplitude (the largest maximum in time of $|A_n|$ while the centre moves over the last site), its share of
the norm within five sites of its peak, and the share left on the first ten sites. All are dimensionless
and hold for every $\epsilon$. With `--alpha` the force of the contacts has another exponent than the article's $3/2$.
The error is the difference from a run with a thousand times the tolerance
and half the samples; the speed also carries the error of the fit. A quantity that does not exist is
`nan`. In Python this is `lattice.dps`.

How fast a front is nobody has proved, and after an impact on a fixed end it is faster. So a chain whose last site
has moved is lengthened and struck again. If you choose the end yourself with `--sites`, what it sends back
belongs to the run. */

#include <array>
#include <cstddef>
#include <optional>

#include "lattice/dps/dps_impact.hpp"
#include "report/program.hpp"

namespace lattice {

/// The command: its parameters (dimensionless), its two runs, its tables.
struct DpsStrike {
  static constexpr Title title{"impact", "the DpS impact: its packet and its residue"};
  double tau = 250;                    ///< length of the run in slow time
  std::optional<std::size_t> sites{};  ///< otherwise long enough for the packet
  Ends end = Ends::free;               ///< where the impact is: free or fixed
  double alpha = 1.5;                  ///< exponent of the contact force

  /// Declares them, as every command does (program.hpp).
  void parameters(Parameters& p);
  using Found = std::array<DpsOutcome, 2>;  ///< the coarser and the finer run
  /// Throws std::runtime_error if GSL cannot go on.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// The field at the end, site by site.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const { return quantities(find()); }
};

}  // namespace lattice
