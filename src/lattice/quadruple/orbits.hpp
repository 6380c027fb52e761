#pragma once
/**
# Orbits with 34 digits

Chains, their motion with its linearisation, and the search for periodic orbits are also there for `Quadruple`.
The compiler needs nearly as long for that as for all the rest of the library, so a program that wants it says so
by this header. */

#include "lattice/orbits/shooting.hpp"
#include "lattice/quadruple/quadruple.hpp"
