#pragma once
/**
# Static breathers of the chain

A static breather is a vibration with one frequency $\omega_b$ that is localized at a few sites. At small amplitude its
profile $u_n$ is known approximately (quasi_continuum.hpp), Eqs. (18) to (20),
$$y_n(0) = 2\epsilon\,u_n,\qquad \epsilon = \bigl(2\tau_0(\omega_b-1)\bigr)^2,$$
and close to $\omega_b = 1$ Newton's method converges from there. To reach higher frequencies we follow the branch
(continuation.hpp), so that we know to which family a breather belongs. */

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/model/sites.hpp"
#include "lattice/orbits/continuation.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// A bond-centred breather at t = 0: its central contact is compressed, as in Eq. (18), or stretched,
/// as it is half a period later.
enum class Phase { compressed, stretched };

/// The approximate breather of Eq. (20), at rest, and the same for contacts that are none of spheres. Throws
/// std::invalid_argument unless the exponent of the contact is above one.
State<double> ansatz(Centre centre, double omega, std::size_t sites,
                     Phase phase = Phase::compressed, const Contact& contact = Hertz{});

/// That of a chain: around a bond if it has an even number of sites.
inline State<double> ansatz(const Chain& chain, double omega, Phase phase) {
  return ansatz(chain.sites % 2 == 0 ? Centre::bond : Centre::site, omega, chain.sites, phase,
                chain.contact);
}

/// The problem of a breather of frequency `omega` in wells of a kind. No overlap is negligible, because
/// the tail is part of the breather. Throws std::invalid_argument if the number of sites does not fit the
/// centre, or if the well has not the frequency one at rest, is not even or loses digits (`loses_digits`).
template <class T>
Shooting<T> breather_problem(Centre centre, const T& omega, const Well& well, std::size_t sites);

/// The same in the article's wells, of anharmonicity $s$, Eq. (10).
template <class T>
Shooting<T> breather_problem(Centre centre, const T& omega, double s, std::size_t sites) {
  return breather_problem(centre, omega, Well(Quartic{s}), sites);
}

/// The breather of a problem in double precision, on the branch that begins at omega_b = 1. Throws
/// NewtonFailed, and NoBranch if the branch does not reach the frequency.
Orbit<double> find_breather(const Shooting<double>& problem, Phase phase = Phase::compressed,
                            const NewtonRule<double>& rule = {});

/// Newton's rule for orbits that are only passed: the last evaluations need no derivative of their own.
NewtonRule<double> on_the_way();

/// The family of the breather of `problem` at increasing frequencies, as far as it reaches.
std::vector<Orbit<double>> breathers_at(Shooting<double> problem,
                                        const std::vector<double>& omegas);

/// The same problem in another precision.
template <class T>
Shooting<T> in_precision(const Shooting<double>& problem) {
  return {problem.chain, problem.symmetry, T(problem.omega)};
}

/**
The last bead would push on the next one, which is missing, with the force $|y|^{3/2}$. If its ratio to the force
$(\omega_b^2-1)|y|$ at the centre is below the precision, longer chains give the same breather. Between compressed beads
of stiffness $k$ the push is $k\,|y|$, and what it changes decays on its way back to the centre as the tail did on its
way out, so that we compare $k\,y^2/\max|y|$. */
/// The shortest chain with this `contact` that has the breather to a relative `precision`, read off a long one.
std::size_t sites_needed(const Orbit<double>& orbit, double precision, const Contact& contact = {});

/// The positions of the middle `sites` beads, and rest where there are none. The parity stays.
State<double> resized(const State<double>& state, std::size_t sites);

/// A breather on a chain that can hold it.
struct Fitted {
  Shooting<double> problem;
  Orbit<double> orbit;
};

/// Thrown if the chain cannot hold the breather's tail; it needs `needed` sites.
struct ShortChain : std::invalid_argument {
  std::size_t needed;
  explicit ShortChain(std::size_t sites)
      : std::invalid_argument("the breather needs " + std::to_string(sites) + " sites"),
        needed(sites) {}
};

/// The breather on `sites` sites, which must hold its tail down to `precision`. With `sites` = 0
/// the chain is as long as necessary but not shorter than `usual`. Throws ShortChain, NewtonFailed.
Fitted fit_chain(Centre centre, double omega, const Well& well, std::size_t sites,
                 std::size_t usual, double precision, Phase phase);

/// Discrete gradient of a profile, y_(n+1) - y_(n-1), not normalised, and zero at both ends: nearly the pinning mode.
Vector<double> discrete_gradient(const std::vector<double>& y);

/// Cosine of the angle between two directions, without sign.
double alignment(const Vector<double>& a, const Vector<double>& b);

/**
## The barrier

The Peierls-Nabarro barrier is the difference of the energies of site- and bond-centred breathers, in the article's
section 3.2 at the same frequency. The effective Hamiltonian that it refers to compares breathers of the same action
integral $\mathcal A = \oint\sum\dot y_n^2\,dt$, the article's area, instead. We correct the frequency of the
site-centred one until these agree. Along a branch $dE = d\mathcal A/T_b$, which turns the remaining difference into
energy; what is neglected is of second order in it, less than rounding. */
template <class T>
struct Barrier {
  T equal_frequency{};  ///< E_site - E_bond at the same frequency
  T equal_action{};     ///< the same at the same action
  T omega_site{};  ///< frequency of the site-centred breather with the bond-centred one's action
};

/// Both barriers, from the site-centred breather's problem and the two breathers of one frequency.
/// Throws NewtonFailed.
template <class T>
Barrier<T> barrier(const Shooting<T>& site_problem, const Orbit<T>& site, const Orbit<T>& bond,
                   const NewtonRule<T>& rule = {});

}  // namespace lattice
