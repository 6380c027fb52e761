#pragma once
/**
# Where one breather exchanges its stability

`sec33_floquet exchange --centre bond --omega 1.1` prints the anharmonicities $s$ between $-1$ and $1$ at which the pinning
pair passes $+1$ (exchange.hpp), the one nearest to the linear well first. Other pairs may leave the circle elsewhere and
are not searched.

$\kappa$ is computed in steps of a fortieth, or so short that the amplitude changes by less than three per cent, from the
linear well to $s = \pm1$, to where the family ends, or to where the article's 31 or 32 sites do not hold its tail. A
breather may lose and regain its stability between two of these of one sign. Then $|\kappa|$ is least at one of them, and
the parabola through it and its neighbours has its extremum nearest to zero in between; two parabolas more, each a tenth
as wide, follow. */

#include <vector>

#include "sec3/breather_options.hpp"
#include "sec3/exchange.hpp"

namespace lattice {
using namespace report;

/// The ends of the search, and all exchanges between them, in extended precision.
struct InWells {
  double from, to;
  std::vector<Estimate> places;
};
InWells exchanges_in_wells(Centre centre, double omega_b);

/// The command. Without an exchange it fails rather than print an empty table.
struct Exchanges : ChosenBreather {
  static constexpr Title title{"exchange",
                               "exchange of stability: the anharmonicity s at which the pinning "
                               "(translational) pair of multipliers passes +1"};

  Table table() const;
};

}  // namespace lattice
