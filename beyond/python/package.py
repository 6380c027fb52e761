"""Beyond the article, in Python: `lattice.travelling` and `lattice.drive`."""

import numpy as np

from . import Chain, Estimate, Result, _array, _beyond, _chain, _described, _estimates, _lattice, _short, _within, _words

_lattice.options["travelling"] = _beyond.options


def travelling(**options):
    """An exact travelling breather, y_n(t + T) = y_(n-1)(t), the open problem of section 5.

    OPTIONS

    Returns a Result with the quantities of `sec5_travelling_breathers orbit`: shift_time T, speed (sites per unit of time),
    energy, peak (largest energy density at t = 0), tail (radiated, relative to the amplitude), residual (relative to the
    amplitude) and multiplier_modulus (per shift); the arrays n, y and v, one entry per bead: site (from the centre),
    position and velocity at t = 0; and the `chain`. Errors are differences from extended precision; those of tail and
    residual are their own size.

    ValueError: no such orbit exists; the message names the nearest."""
    found, profile, chain = _beyond.travelling(_words("travelling", options))
    return Result(_estimates(found), **profile, chain=_chain(chain))


def drive(chain, y, v, time, sample=0.2, tolerance=1e-4, damping=0, force=0, frequency=1):
    """The motion of a damped chain driven at its first bead, as `Chain.evolve` does without damping and drive.

    chain: a `Chain` with a number of sites
    y, v: positions and velocities at t = 0, arrays of `sites` numbers
    damping: rate nu >= 0 at which free oscillations lose energy, mass_n (y_n'' + nu y_n') = ..., or one rate per site,
        such as rates that grow towards an absorbing end
    force, frequency: F and Omega of a force F sin(Omega t) on the first bead from t = 0 on; free ends only
    sample, tolerance: as in `Chain.evolve`

    Returns a Result with the arrays t, y and v of `Chain.evolve` and the quantities error, of the final state, injected,
    dissipated and energy (the work of the force, the energy lost to damping and the final energy; their error is the
    largest of their differences in two runs) and imbalance (largest deviation of energy + dissipated - injected from its
    initial value, relative to the largest energy present or supplied); the arrays injected_t, dissipated_t and energy_t
    hold the same for every sample. Damping and force are of order two in the step, so a tolerance below 1e-6 is seldom
    reached."""
    if not isinstance(chain, Chain):
        raise TypeError(f"chain: {_short(chain)} is not a lattice.Chain")
    run = chain._run(y, v, time, sample, tolerance)
    rates = _array("damping", damping, f"a rate, or {chain.sites}, one per site", lambda shape: shape in ((), (chain.sites,)))
    if np.any(rates < 0):
        raise ValueError(f"damping: {rates.min():g} (allowed: rates >= 0)")
    force, frequency = _within("force", force, -1e6, 1e6), _within("frequency", frequency, 0, 1e3)
    t, y, v, error, imbalance, injected, dissipated, energy, *courses = _beyond.drive(
        chain, *run, np.broadcast_to(rates, chain.sites).tolist(), force, frequency)
    known = {"error": Estimate(error, 0, "relative", meaning="difference between the final states of the last two runs"),
             "injected": Estimate(*injected, meaning="work of the force on the first bead"),
             "dissipated": Estimate(*dissipated, meaning="energy lost to damping"),
             "energy": Estimate(*energy, meaning="energy at the end, Eq. (6)"),
             "imbalance": Estimate(imbalance, 0, "relative", meaning="largest deviation of energy + dissipated - injected")}
    return Result(known, t=t, y=y, v=v, **dict(zip(("injected_t", "dissipated_t", "energy_t"), courses)))


_described(travelling, "travelling")
