#pragma once
/**
# The NLS equation against the chain

Three tests of the formulas of section 4.1: the frequency of exact waves (exact_waves.hpp), the growth of their modulations
at the wavenumber that the formulas call the fastest one, and runs from the soliton of Eq. (38). */

#include <span>

#include "report/program.hpp"
#include "sec4/phonons.hpp"

namespace lattice {

/// A wave of one wavenumber and amplitude in a compressed chain.
struct Carrier {
  double s, q, d, amplitude;
};

/// Writes `edge_waves`, `measured_coefficient`, `umklapp` and `ansatz_error`.
void report_nls_checks(Report& report, double d, std::span<const double> wells);
}  // namespace lattice
