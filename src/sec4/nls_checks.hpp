#pragma once
/**
# The band at other compressions, and the NLS equation against the chain

What the article says about the band holds for any compression, so it is evaluated from 1e-8 to 1e4. The formulas of
section 4.1 are tested by the frequency of exact waves (exact_waves.hpp), by the growth of their modulations at the
wavenumber that the formulas call the fastest one, and by runs from the soliton of Eq. (38). */

#include <span>

#include "report/program.hpp"

namespace lattice {
using namespace report;

/// Writes `contact_series` (of the compression `d`), `compressions`, `inflection_signs`, `sides`, `band_edges` and
/// `instability` and `inflection` (of `d`).
void report_band(Report& report, double d, std::span<const double> wells);
/// Writes `edge_waves`, `measured_coefficient`, `umklapp` and `ansatz_error`.
void report_nls_checks(Report& report, double d, std::span<const double> wells);

}  // namespace lattice
