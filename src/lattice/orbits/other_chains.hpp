#pragma once
/**
# Breathers of other chains

The article's breathers live on equal beads, between contacts of spheres that are not compressed. Here contacts
have any exponent, may be compressed at rest, and beads may have different masses. The quasi-continuum profile
knows exponents but neither compression nor masses, and so these are reached on a path: from a chain whose breather is
known to the one that is wanted, at one frequency. */

#include "lattice/orbits/breather.hpp"

namespace lattice {

/**
## A path between two chains

Masses, stiffnesses, the anharmonicity of quartic wells, the exponent and the root of the compression change linearly along the path: the stiffness of a
contact is $\frac32\sqrt d$. A contact of the caller's own is that of the target from the start. */
/// The same law by its simplest type and without a floor, lest it cut off the tail.
Contact bare(const Contact& contact);

/// The chain at `part` of the way from `a` to `b`, from 0 to 1, of the same length; ends, and wells but quartic ones, are
/// those of `b`.
Chain between(const Chain& a, const Chain& b, double part);

/**
Each point of the path gives a guess for the next one, on the line through the last two. Newton's method is
damped, lest it loses its way. A step is halved if it fails or goes farther than a tenth of the amplitude, which
may lead to another family, and doubled otherwise. Where a branch folds back there is no step that leads on, and
the message says how far the path went. */
/// The orbit of `problem` followed to the chain `target` at fixed frequency. Throws NewtonFailed with the history of
/// the last attempt, std::invalid_argument if the lengths differ.
Orbit<double> continue_to(Shooting<double> problem, const Orbit<double>& from, const Chain& target);

}  // namespace lattice
