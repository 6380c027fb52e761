#pragma once
/**
# 4 Checks: the NLS equation against the chain

The table of figure x07 and the order of the NLS approximation; the chapter `sec4_precompression_mi` says what they
show. Only the column `beta` and the scales of comparison come from the formulas of phonons.hpp. */

#include "report/program.hpp"

namespace lattice {

/// beta from the frequency of exact waves on 48 beads, and Phi from the growth of their modulations where these are
/// slow: not at q = pi/2, where backscattered waves grow faster, and not within 0.05 of q_c, where the curvature
/// vanishes.
void report_beta(Report& report);
/// The chain starts from a soliton; its largest distance from the ansatz of Eq. (35) up to t = eps^-2, and local
/// orders.
void report_ansatz(Report& report);

}  // namespace lattice
