#pragma once
/**
# How a packet falls off from bead to bead

An exponential tail falls by the same factor from each bead to the next. Table `decay` of `sec1_the_chain` has the
logarithm of this factor, $\ln(a_n/a_{n\pm1})$, on either side of the bead with the most energy, for three measures
$a_n$ of the size of a bead's motion: its mean energy over the samples, its energy in the last of them, and its largest
displacement. */

#include <Eigen/Core>
#include <vector>

#include "report/table.hpp"

namespace lattice {

/// A packet at one instant: energy density and displacement of every bead.
struct Sample {
  Eigen::VectorXd energy, displacement;
};

/// The rows of table `decay`, from the same samples at two steps, as far as the energy does not underflow.
void report_tail(Table& table, const std::vector<Sample>& coarse, const std::vector<Sample>& fine);

}  // namespace lattice
