"""What is beyond the article, in Python: `lattice.travelling` and `lattice.drive`."""

import numpy as np

from . import Chain, Estimate, Result, _array, _beyond, _chain, _described, _estimates, _lattice, _short, _within, _words

_lattice.options["travelling"] = _beyond.options


def travelling(**options):
    """An exact travelling breather, y_n(t + T) = y_(n-1)(t), the open problem of section 5.

    OPTIONS

    Returns a Result with the quantities of `sec5_travelling_breathers orbit`: shift_time T, speed (sites per unit of time),
    energy, peak (largest energy density at t = 0), tail (left behind, relative to the amplitude), residual (relative to
    the amplitude) and multiplier_modulus (per shift); the arrays n, y and v, one entry per bead: site (around the
    centre), position and velocity at t = 0; and the `chain`. Errors are differences from a wider number type; those of tail
    and residual are their own size.

    ValueError: there is no such orbit; the message names the nearest."""
    found, profile, chain = _beyond.travelling(_words("travelling", options))
    return Result(_estimates(found), **profile, chain=_chain(chain))


def drive(chain, y, v, time, sample=0.2, tolerance=1e-4, damping=0, force=0, frequency=1):
    """The motion of a chain that is damped and driven at its first bead, as `Chain.evolve` follows one that is not.

    chain: a `Chain` with a number of sites
    y, v: positions and velocities at t = 0, arrays of `sites` numbers
    damping: rate nu >= 0 at which free oscillations lose energy, mass_n (y_n'' + nu y_n') = ..., or one rate a site,
        such as rates that grow towards an end that absorbs
    force, frequency: F and Omega of a force F sin(Omega t) on the first bead, from the start on; free ends only
    sample, tolerance: as in `Chain.evolve`

    Returns a Result with the arrays t, y and v of `Chain.evolve` and the quantities error, of the end state, injected,
    dissipated and energy (what the force gave, what the damping took, what is there at the end; their error is the largest
    of their differences in two runs) and imbalance (largest deviation of energy + dissipated - injected from its value at
    the start, relative to the most energy that was there or came in); the arrays injected_t, dissipated_t and energy_t say
    the same of every sample. Damping and force are of order two in the step, so that a tolerance below 1e-6 is seldom
    reached."""
    if not isinstance(chain, Chain):
        raise TypeError(f"chain: {_short(chain)} is not a lattice.Chain")
    run = chain._run(y, v, time, sample, tolerance)
    rates = _array("damping", damping, f"a rate, or {chain.sites}, one a site", lambda shape: shape in ((), (chain.sites,)))
    if np.any(rates < 0):
        raise ValueError(f"damping: {rates.min():g} (allowed: rates >= 0)")
    force, frequency = _within("force", force, -1e6, 1e6), _within("frequency", frequency, 0, 1e3)
    t, y, v, error, imbalance, injected, dissipated, energy, *courses = _beyond.drive(
        chain, *run, np.broadcast_to(rates, chain.sites).tolist(), force, frequency)
    known = {"error": Estimate(error, 0, "relative", meaning="difference of the end states of the last two runs"),
             "injected": Estimate(*injected, meaning="work of the force on the first bead"),
             "dissipated": Estimate(*dissipated, meaning="energy that the damping took"),
             "energy": Estimate(*energy, meaning="energy at the end, Eq. (6)"),
             "imbalance": Estimate(imbalance, 0, "relative", meaning="largest deviation of energy + dissipated - injected")}
    return Result(known, t=t, y=y, v=v, **dict(zip(("injected_t", "dissipated_t", "energy_t"), courses)))


_described(travelling, "travelling")
