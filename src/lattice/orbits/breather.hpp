#pragma once
/**
# Static breathers of the chain

A static breather is a vibration with one frequency $\omega_b$ that is localized at a few sites. The
article's are periodic orbits of a chain with free ends. At small amplitude their profile $u_n$ is known
approximately, in the quasi-continuum limit of the DpS equation (quasi_continuum.hpp), Eqs. (18) to (20):
$$y_n(0) = 2\epsilon\,u_n,\qquad \epsilon = \bigl(2\tau_0(\omega_b-1)\bigr)^2.$$
Close to $\omega_b = 1$ Newton's method converges from there. To reach higher frequencies we follow the
branch (continuation.hpp), so that we know to which family a breather belongs. */

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/orbits/continuation.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// A bond-centred breather at t = 0: its central contact is compressed, as in Eq. (18), or stretched,
/// as it is half a period later.
enum class Phase { compressed, stretched };

/**
In the limit of small amplitude only the frequency of a well at rest counts, and the unit of time makes it
one. So the families begin in the same way in wells of any shape, and what follows asks for nothing else. */
/// The problem of a breather of frequency `omega` in wells of a kind. The contacts have no floor, because
/// the tail is part of the breather. Throws std::invalid_argument if the number of sites does not fit the
/// centre, or if the well has not the frequency one at rest, is not even or loses digits (`loses_digits`).
template <class T>
Shooting<T> breather_problem(Centre centre, const T& omega, const Well& well, std::size_t sites);

/**
The article's wells are named by their anharmonicity $s$, Eq. (10). */
template <class T>
Shooting<T> breather_problem(Centre centre, const T& omega, double s, std::size_t sites) {
  return breather_problem(centre, omega, Well(Quartic{s}), sites);
}

/**
Newton's method needs a guess, and close to $\omega_b = 1$ the quasi-continuum profile is a good one. */
/// The approximate breather of Eq. (20), at rest, and the same for contacts that are none of spheres. Throws
/// std::invalid_argument unless the exponent of the contact is above one.
State<double> ansatz(Centre centre, double omega, std::size_t sites,
                     Phase phase = Phase::compressed, const Contact& contact = Hertz{});

/// Up to this frequency, that of the article's figure 4, Newton's method starts from the quasi-continuum profile.
constexpr double direct_up_to = 1.1;

/// The breather of a problem in double precision, on the branch that begins at omega_b = 1. Throws
/// NewtonFailed, and NoBranch if the branch does not reach the frequency.
Orbit<double> find_breather(const Shooting<double>& problem, Phase phase = Phase::compressed,
                            const NewtonRule<double>& rule = {});

/**
Double precision finds an orbit, and extended precision confirms its digits (shooting.hpp). */
/// The same problem in another precision.
template <class T>
Shooting<T> in_precision(const Shooting<double>& problem) {
  return {problem.chain, problem.symmetry, T(problem.omega)};
}

/**
How long must a chain be? The last bead would push on the next one, which is missing, with the force
$|y|^{3/2}$. We compare this with the force $(\omega_b^2-1)|y|$ at the centre, which distinguishes the
breather from a free oscillation. If the ratio is below the precision, longer chains give the same
breather. The shortest such chain is read off a long one.

Between compressed beads of stiffness $k$ the push is linear, $k\,|y|$, and the tail falls no faster than an
exponential. What the missing push changes decays on its way back to the centre as the tail did on its way out, so that
there we compare $k\,y^2/\max|y|$. The last few positions are then those of the finite chain. */
/// The shortest chain with this `contact` that has the breather to a relative `precision`.
template <class T>
std::size_t sites_needed(const Orbit<T>& orbit, double precision, const Contact& contact = {});

/// The positions of the middle `sites` beads, and rest where there are none. The parity stays.
State<double> resized(const State<double>& state, std::size_t sites);

/**
A reader who asks for a chain of some length gets that chain, or is told why it will not do. */
/// A breather on a chain that can hold it.
struct Fitted {
  Shooting<double> problem;
  Orbit<double> orbit;
};

/// Thrown if the chain cannot hold the breather's tail; it needs `needed` sites.
struct ShortChain : std::invalid_argument {
  std::size_t needed;
  /// `sites` are needed.
  explicit ShortChain(std::size_t sites)
      : std::invalid_argument("the breather needs " + std::to_string(sites) + " sites"),
        needed(sites) {}
};

/**
So the breather is first found on a chain that is certainly long enough. Far up a branch it is also the
best guess for the shorter one. */
/// The breather on `sites` sites, which must hold its tail down to `precision`. With `sites` = 0
/// the chain is as long as necessary but not shorter than `usual`. Throws ShortChain, NewtonFailed.
Fitted fit_chain(Centre centre, double omega, const Well& well, std::size_t sites,
                 std::size_t usual, double precision, Phase phase);
/// The same in wells with anharmonicity `s`.
inline Fitted fit_chain(Centre centre, double omega, double s, std::size_t sites, std::size_t usual,
                        double precision, Phase phase) {
  return fit_chain(centre, omega, Quartic{s}, sites, usual, precision, phase);
}

/**
A breather can be shifted along the chain at almost no cost in energy. The article finds that the direction
in which this happens, the pinning mode, is nearly the discrete gradient of its profile. */
/// Discrete gradient of a profile, y_(n+1) - y_(n-1), not normalised, and zero at both ends.
Vector<double> gradient(const std::vector<double>& y);

/// Cosine of the angle between two directions, without sign.
double alignment(const Vector<double>& a, const Vector<double>& b);

/**
## The barrier

To move along the chain a breather passes from bond to site to bond, and if the energies of the two kinds differ
there is a barrier (named after Peierls and Nabarro). The article, section 3.2, takes the difference at the same
frequency. The effective Hamiltonian that it refers to compares breathers of the same area
$\mathcal A = \oint\sum\dot y_n^2\,dt$ instead. We keep the frequency of the bond-centred breather and correct that
of the site-centred one until the areas agree. Along a branch $dE = d\mathcal A/T_b$; this turns the remaining
difference of the areas into energy, and what is neglected is of second order in it: less than rounding, after one
correction or a few. */
template <class T>
struct Barrier {
  T equal_frequency{};  ///< E_site - E_bond at the same frequency
  T equal_area{};       ///< the same at the same area
  T omega_site{};       ///< frequency of the site-centred breather of the bond-centred one's area
};

/// Both barriers, from the site-centred breather's problem and the two breathers of one frequency.
/// Throws NewtonFailed.
template <class T>
Barrier<T> barrier(const Shooting<T>& site_problem, const Orbit<T>& site, const Orbit<T>& bond,
                   const NewtonRule<T>& rule = {});

}  // namespace lattice
