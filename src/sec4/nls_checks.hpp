#pragma once
/**
# The NLS equation against the chain

Three tests of the formulas of section 4.1 that do not use them: the frequency of exact waves, the growth of their
modulations (exact_waves.hpp), and runs from the soliton of Eq. (38). */

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
/// Writes `rate_error`, the error of the NLS growth rate at the amplitudes of the carriers and below.
void report_rate_error(Report& report, std::span<const Carrier> carriers);

}  // namespace lattice
