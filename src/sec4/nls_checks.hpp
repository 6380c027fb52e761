#pragma once
/**
# 4 Checks: the NLS equation against the chain, and the integrator

The tables of figures x07 and x08; the chapter `sec4_precompression_mi` says what they show. Nothing but the columns
`beta` and `nls` and the scales of comparison comes from the formulas of phonons.hpp.

![Error against step with closed and with opening contacts.](fig:x08) */

#include "lattice/model/chain.hpp"
#include "report/program.hpp"

namespace lattice {

/// beta from the frequency of exact waves on 48 beads, and Phi from the growth of their modulations where these are
/// slow: not at q = pi/2, where backscattered waves grow faster, and not within 0.05 of q_c, where the curvature
/// vanishes. How fast the former grow, over |h||A|^2.
void report_beta(Report& report);
/// Growth at the amplitudes 0.15 and 0.05, by eigenvalues and in runs. Throws Failure if they differ by a thousandth.
void report_growth(Report& report);
/// The chain starts from a soliton; its largest distance from the ansatz of Eq. (35) up to t = eps^-2, and local
/// orders.
void report_ansatz(Report& report);
/// Orders of four splittings for the wave `phonon` on `ring`, which opens no contact until t = 50, and for a struck
/// chain, against an event-corrected run with a very short step whose end state GSL's method of order eight confirms.
void report_order(Report& report, const Chain& ring, const State<double>& phonon);

}  // namespace lattice
