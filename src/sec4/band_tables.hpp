#pragma once
/**
# The phonon band at other compressions

What the article says about the band of a compressed chain holds for any compression. These tables evaluate it from 1e-8
to 1e4, where the chapter has one compression. */

#include <span>

#include "report/program.hpp"

namespace lattice {

/// Writes `contact_series` (of the compression `d`), `compressions`, `inflection_signs`, `sides`, `band_edges` and
/// `instability` and `inflection` (of `d`).
void report_band(Report& report, double d, std::span<const double> wells);

}  // namespace lattice
