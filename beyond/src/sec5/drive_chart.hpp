#pragma once
/**
# A chart over frequency and amplitude of a drive

A piston drives an array of 300 beads at seven frequencies and ten amplitudes, in units of the asymptotic threshold; the
amplitude rises during a twelfth of the run. The points are independent of each other, and parts of them can be computed
alone (sweep.hpp). */

#include <filesystem>

#include "report/sweep.hpp"
#include "sec5/driven_array.hpp"

namespace lattice {

/// The points and columns of the chart; with `quick` six points of it.
Sweep drive_chart(const std::filesystem::path& folder, bool quick);

/// Computes the rows of a part.
void compute_chart(Sweep& sweep, const ArraySetup& setup, bool quick, Part part);

}  // namespace lattice
