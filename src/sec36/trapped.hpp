#pragma once
/**
# Energy that stays near a defect

The same run as in the chapter, carried on until later times, for a heavy defect, none, and a light one. Until the first of
the times nothing but the end is of interest; after it the motion of the defect is recorded for its frequency. */

#include <array>
#include <cstddef>

#include "report/program.hpp"
#include "sec3/array_impact.hpp"
#include "sec36/definitions.hpp"

namespace lattice {

/// When, and on how many sites: `2 near_sites + 1` of them around, before and again before the defect.
struct TrappedAt {
  std::array<double, 2> times;  ///< ms
  std::size_t near_sites;
};

/// Tables `trapped`, for 1.6 and 0.925 radii and without a defect, and `light_defect`, the frequency of the last.
void report_trapped(Report& report, const StruckArray& struck, const TrappedAt& where,
                    const TwoSteps& steps);

}  // namespace lattice
