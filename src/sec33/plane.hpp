#pragma once
/**
# Breathers over the plane of frequency and anharmonicity

Each frequency is reached in the linear well. From there the breather is continued to harder and to softer wells, as far
as the family reaches: in soft wells it ends in a fold, and at high frequencies before the softest of the wells. */

#include <vector>

#include "report/table.hpp"
#include "sec33/exchange.hpp"

namespace lattice {

/// The breathers of these increasing frequencies in these wells, with their pairs; wells beyond the end of a family are
/// left out. Where the tail reaches the ends of the chain, it gets ten more sites. Throws NewtonFailed.
std::vector<BreatherAt> breathers_over_the_plane(Centre centre, const std::vector<double>& omegas,
                                                 const std::vector<double>& wells);

/// The rows of a table: how near the fourth multiplier is to +1, where the fifth is, and how far the others leave the
/// circle.
void add_spectra(Table& table, Centre centre, const std::vector<BreatherAt>& breathers);

/// The rows of a table for the wells s = -1, 0 and 1: how many multipliers ten more sites add at the point of
/// accumulation.
void add_edges(Table& table, Centre centre, const std::vector<BreatherAt>& breathers);

}  // namespace lattice
