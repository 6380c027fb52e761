#pragma once
/**
# Strong impacts on pendulum wells stay bounded

With $W = 1-\cos y$ no term of the energy is negative, so no bead is faster than $v_0$ or farther away than $v_0t$. This file
sees whether the runs keep to it, and for how long. */

#include <vector>

#include "lattice/model/chain.hpp"
#include "report/program.hpp"

namespace lattice {

/// Table `confinement`: largest speed and displacement until `time`, and the drift of the energy, for these impacts.
void report_confinement(Report& report, const Chain& chain, const std::vector<double>& velocities,
                        double time);

}  // namespace lattice
