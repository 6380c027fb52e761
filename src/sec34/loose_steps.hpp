#pragma once
/**
# The DpS impact with loose steps

Do loose steps explain the printed amplitude of section 3.4? Here the DpS impact is followed by adaptive Runge–Kutta
methods (runge_kutta.hpp) whose tolerance, and the norm by which the estimated errors of all components become one
number, are chosen. A run keeps its tolerance in both resolutions; they differ in the first step and in the number of
samples, which are interpolated between the steps. (If a run must *stop* at each of a thousand samples, its steps are
too short to do harm, whatever the tolerance allows.) */

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/dps/dps_impact.hpp"
#include "lattice/integrators/runge_kutta.hpp"

namespace lattice {

/// One choice; the absolute tolerance is a thousandth of the relative one.
struct LooseSteps {
  RungeKutta method;
  ErrorNorm norm;
  double relative;
  std::size_t sites;
};

/// Both methods with all norms and tolerances on `sites` sites, and the usual tolerances on chains of several lengths.
std::vector<LooseSteps> loose_settings(std::size_t sites);

/// How a table calls a norm.
std::string name_of(ErrorNorm norm);

/// The struck DpS chain until `tau_end`, with so many samples and with twice as many.
DpsPair loose_runs(const LooseSteps& how, double tau_end, std::size_t samples);

/**
Two numbers tell a loose run from an accurate one: the norm $\sum|A_n|^2$, which should stay at one, and the difference
of the wave train, here the first sixty sites, from the converged one. */
double growth(const DpsOutcome& out);
double train_difference(const DpsOutcome& out, const DpsOutcome& converged);

}  // namespace lattice
