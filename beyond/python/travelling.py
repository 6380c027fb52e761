"""What is beyond the article, in Python: `lattice.travelling`."""

from . import Result, _beyond, _chain, _described, _estimates, _lattice, _words

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


_described(travelling, "travelling")
