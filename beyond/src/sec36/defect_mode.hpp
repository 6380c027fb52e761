#pragma once
/**
# The mode of a defect

In section 3.6 a cantilever with other beads reflects a breather, and some of the energy stays with it. If the defect
is light, $\mu < 1$, it is an oscillator of the frequency $\mu^{-1/2} > 1$, faster than its neighbours. From this
frequency a family of localized periodic orbits begins, as from $\omega_b = 1$ in the chain without a defect.
Newton's method follows it from a guess in which the defect alone moves. Its amplitude $a$ is that at which its two
contacts, which together push back with $\eta\,|y|^{1/2}y$, raise the frequency to $\omega_b$. The first harmonic of
this force, with the factor $\frac1\pi\int_0^{2\pi}|\cos\theta|^{5/2}d\theta \approx 0.915$, gives
$\mu\,\omega_b^2 \approx 1 + 0.915\,\eta\sqrt a$. We demand evenness in time only; that the mode has the mirror
symmetry of the defect is then a result. */

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/model/cantilever.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// Sites of the piece of chain that holds the mode, with its tail down to rounding.
inline constexpr std::size_t mode_sites = 31;

/// The problem of a mode around a defect in the middle of a short array; `ratio` is that of the radii of
/// its beads and the others (cantilever.hpp).
Shooting<double> mode_problem(const CantileverArray& array, double ratio);

/**
A mode in a run is compared with the member of the family that has the same energy. Newton's method in
$\omega_b$ finds it quickly for the fourth root of the energy, which is nearly linear in $\omega_b$. We
begin a little above the linear frequency and change $\omega_b$ by at most 0.01 at a time. Throws
NewtonFailed, and std::runtime_error if there is no such member within 40 steps. */
Orbit<double> mode_of_energy(Shooting<double> problem, double energy);

/**
Next we need to know where the energy of the mode is: its mean over a period at each site, from `instants`
equal intervals. */
std::vector<double> mean_density(const Shooting<double>& problem, const Orbit<double>& orbit,
                                 std::size_t instants);

}  // namespace lattice
