#pragma once
/**
# Integrators that could follow a kicked breather

A run after a weak kick is worth something if the energy drifts by far less than the kick adds, for $10^5$ periods. Here
is every integrator of the library under one name each, with several steps, as a run after a kick. */

#include <functional>
#include <string>
#include <vector>

#include "sec33/kick_threshold.hpp"

namespace lattice {

/// An integrator with its (largest) step, and the run that it makes.
struct Candidate {
  std::string name;
  double step;
  std::function<KickedPath()> run;
};

/// Splittings in double and in extended precision, contact-aware steps of two methods, and exact event location, which
/// gets a fifth of `time`. `at` must outlive them.
std::vector<Candidate> candidates(const RestingBreather& at, double c, double time);

}  // namespace lattice
