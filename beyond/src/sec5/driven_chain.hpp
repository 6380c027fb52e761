#pragma once
/**
# Damping and driving

A real array loses energy and is driven from outside. This file adds both to the chain of chain.hpp, in its
units:
$$\mu_n\ddot y_n = F_n - \nu_n\,\mu_n\dot y_n + \varphi_n - \varphi_{n+1} + \delta_{n1}\,G(y_1,t).$$
The rate $\nu_n$ is that of a beam; free oscillations lose their energy like $e^{-\nu_n t}$. One rate for all sites
makes a damped chain, rates that grow towards an end make an end that absorbs waves. Contacts lose
energy by the viscosity of their material: in the law of Kuwabara and Kono (Jpn. J. Appl. Phys. 26, 1230,
1987) the push of a contact with the overlap $x$ is $\eta\,(x^{3/2}+\frac32A\sqrt x\,\dot x)$, so that
$\varphi_n = \frac32A\,\eta_n\sqrt{x_n}\,\dot x_n$ acts on bead $n$, and its opposite on the bead before. The
drive $G$ is the push of a *piston* that touches the first bead and moves as $a\sin\Omega t$,
$G = (a\sin\Omega t-y_1)_+^{3/2}$, or the pull of the first beam, whose *base* moves in this way,
$G = a\sin\Omega t$.

One step alternates these forces with a conservative step of event_corrected.hpp in the symmetric order of
Strang. Each force alone is solved exactly at fixed positions, and the energy that it gives or takes is then
a difference of kinetic energies. So every joule is in the energy budget: energy plus losses minus work stays
constant but for the drift of the conservative step. As the budget cannot see the error of the alternation,
which is of order two, that error is found by halving the step. */

#include <cmath>
#include <vector>

#include "lattice/integrators/refinement.hpp"

namespace lattice {

/// What takes energy out of a chain: the rate nu of the beams, and the time A of the contacts.
struct Losses {
  double rate = 0, contact = 0;  ///< per unit of time, and in units of time
  /// Rates of the single beams, where they differ, instead of `rate`.
  std::vector<double> of_site{};
};

/**
A drive may begin suddenly or slowly: its amplitude goes on a straight line from `from` to `amplitude` in
the time `ramp`, up or down, and stays there. */
struct Drive {
  enum class By { nothing, piston, base } by = By::nothing;
  double omega = 1, amplitude = 0, from = 0, ramp = 0;

  /// a at the time `t`.
  double amplitude_at(double t) const {
    return t < ramp ? from + (amplitude - from) * (t / ramp) : amplitude;
  }
  /// a sin Omega t.
  double displacement(double t) const { return amplitude_at(t) * std::sin(omega * t); }
  /// Force on the first bead, at its position `y`.
  double force(double t, double y) const;
};

/// Where the energy went since the start: into beams and contacts, and what the drive gave.
struct EnergyBudget {
  double beams = 0, contacts = 0, work = 0;
};

/// Chain, losses and drive.
struct DrivenChain {
  Chain chain;
  Losses losses{};
  Drive drive{};
};

/**
`evolve` carries a state forward and shows it with the energy budget at the start and after each sample, until
the observer returns false. The result is the largest deviation of energy + losses - work from its value at
the start, relative to the largest energy that was there or came in. */
using DrivenLook = Observer<State<double>, EnergyBudget>;

/// Carries `state` over the grid; returns that deviation. Throws std::invalid_argument for losses that are negative or
/// not finite, for rates that do not fit the chain's length, and if a chain whose ends are not free has losses in its
/// contacts or is driven.
double evolve(const DrivenChain& driven, State<double>& state, const TimeGrid& grid,
              const DrivenLook& look = {});

/**
The same for a stated tolerance (refinement.hpp): the step is halved until the end states of two runs agree, and
the budgets of both tell how well it is known. */
/// Where a driven run ends, what was booked on the way, and the energy and deviation there.
struct DrivenEnd {
  State<double> end;
  EnergyBudget budget;
  double energy, imbalance;
};

/// Both runs; `look` sees the finer one, and `state` becomes its end. Throws like `refined`, and as above.
Refined<DrivenEnd> evolve(const Converged& stated, const DrivenChain& driven, State<double>& state,
                          double duration, Every every, const DrivenLook& look = {});

/**
The constant $A$ of a material follows from a collision. Two equal beads that meet with the relative
velocity $v$ separate with $ev$; the *coefficient of restitution* $e$ is what a drop test measures. */
/// The restitution of two beads of mass one that meet with `velocity`, for the time `contact`.
double restitution(double contact, double velocity);

/// The time A for which two such beads have the restitution `e` at `velocity`, by bisection.
double contact_loss(double e, double velocity);

}  // namespace lattice
