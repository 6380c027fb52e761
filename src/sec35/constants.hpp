#pragma once
/**
# From materials to constants

The article takes the stiffness and the mass of a beam from a textbook, and the force between two beads from Hertz. This file
derives them: it integrates the equation of a beam (cantilever.hpp) and the pressure between two spheres. */

#include "lattice/model/cantilever.hpp"
#include "report/program.hpp"

namespace lattice {

/// Table `beam`: stiffness, frequency and effective mass of a clamped beam, and what the model with a point mass costs.
void report_beam(Report& report, const CantileverArray& array);

/// Table `hertz`: the article's coefficients over the force between two elastic spheres, for pairs of radii.
void report_hertz(Report& report, const CantileverArray& array);

/// Table `schematic`: what figure 1 needs.
void report_schematic(Report& report, const CantileverArray& array, double string_length);

}  // namespace lattice
