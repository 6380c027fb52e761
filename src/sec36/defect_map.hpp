#pragma once
/**
# The map of defects (figure x09)

What a defect does to a packet is computed for radii of its beads from one half to twice that of the others. The points
are independent: a part `k/n` of them can be computed alone, an interrupted map goes on where it stopped, and the full
run collects what the parts have left in the folder (sweep.hpp). */

#include <filesystem>
#include <vector>

#include "report/sweep.hpp"
#include "sec36/scattering.hpp"

namespace lattice {

/// The end of figure 24, in ms, when the packet has left the defect.
inline constexpr double defect_passed = 75;

/// The radii of the map, closer to each other around one.
std::vector<double> map_radii(bool quick);

/// The columns and the key of the map; its rows wait in `folder`.
Sweep defect_map_sweep(const std::filesystem::path& folder, bool quick);

/// Two steps for every point; the energy budget shows whether the smaller one suffices.
ScatteringSetup setup_for(const StruckArray& blow, bool quick);

/// Computes a part of the map.
void compute_defect_map(Sweep& sweep, const ScatteringSetup& setup, bool quick, Part part);

}  // namespace lattice
