#pragma once
/**
# Breathers of other chains

The quasi-continuum profile knows exponents of contacts but neither compression nor masses: such breathers are reached
on a path from a chain whose breather is known, at one frequency. */

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// The chain at `part` of the way from `a` to `b`, from 0 to 1, of the same length. Masses, stiffnesses, the
/// anharmonicity of quartic wells, the exponent and the root of the compression change linearly; ends, other wells and
/// a contact of the caller's own are those of `b`.
Chain between(const Chain& a, const Chain& b, double part);

/// The orbit of `problem` followed to the chain `target` at fixed frequency. A step is halved if it fails or goes
/// farther than a tenth of the amplitude, which may lead to another family, and doubled otherwise. Throws NewtonFailed
/// where the branch folds back, with how far the path went; std::invalid_argument if the lengths differ.
Orbit<double> continue_to(Shooting<double> problem, const Orbit<double>& from, const Chain& target);

}  // namespace lattice
