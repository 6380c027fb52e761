"""Breathers in oscillator chains with Hertzian interactions, from Python.

The functions are the commands of the programs: `strike`, `breather`, `multipliers`, `barrier`, `travelling` and `dps`
take the same options, compute the same bits and refuse the same input with the same line (ValueError; a computation
that does not deliver what it promises is a RuntimeError). A `Chain` may have masses, contacts and wells of your own.

    >>> import lattice
    >>> lattice.strike(velocity=1.5, time=200, s="-1/6").speed

All quantities are dimensionless, as in Eqs. (9) and (10): the unit of time makes the frequency of small oscillations in
a well one, the unit of length does the same for the coefficient of the contact force. Equation numbers are those of
James, Kevrekidis and Cuevas, Physica D 251 (2013) 39-59. A long computation can be interrupted (Ctrl-C) and runs without
the interpreter's lock. No result depends on the number of threads (`set_threads`).
"""

import inspect
import math

import numpy as np

from . import _lattice

__version__ = _lattice.version
__all__ = ["Chain", "Contact", "Estimate", "Result", "Well", "barrier", "breather", "dps", "multipliers", "set_threads",
           "strike", "travelling"]


class Estimate(float):
    """A number that knows its error: a float with the attributes `error` (absolute, in the unit of the number), `unit`
    (empty if dimensionless), `exact` (True where nothing could be different) and `meaning` (what it is, in words). Errors
    are differences of two resolutions, as in the tables of the programs. Arithmetic returns plain floats."""

    def __new__(cls, value, error, unit="", exact=False, meaning=""):
        self = super().__new__(cls, value)
        self.error, self.unit, self.exact, self.meaning = float(error), unit, exact, meaning
        return self

    def __getnewargs__(self):
        return float(self), self.error, self.unit, self.exact, self.meaning

    def __str__(self):
        """The digits that the error allows, and the error."""
        value = float(self)
        if self.exact or not (self.error > 0 and math.isfinite(value)):
            text = f"{value:.17g}" if not math.isfinite(value) or self.error == 0 else f"{value:.3g}"
            return f"{text} {self.unit}".rstrip()
        sure = math.floor(math.log10(abs(value))) - math.floor(math.log10(self.error)) if value else 0
        digits = f"#.{min(sure + 1, 17)}" if sure > 0 else ".1"
        return f"{value:{digits}g} ± {self.error:.0e} {self.unit}".rstrip()

    __repr__ = __str__


class Result:
    """What a function found. `quantities` is a dictionary of Estimates, each with its `meaning`; they and the arrays are
    attributes too."""

    def __init__(self, quantities, **arrays):
        self.quantities = quantities
        self.__dict__.update(quantities)
        self.__dict__.update(arrays)

    def __repr__(self):
        width = max(map(len, self.quantities), default=0)
        lines = [f"{name:{width}} = {value}" for name, value in self.quantities.items()]
        arrays = [name for name, value in vars(self).items() if isinstance(value, np.ndarray)]
        return "\n".join(lines + (["arrays: " + ", ".join(arrays)] if arrays else []))


def _estimates(table):
    rows = zip(*(table[name] for name in ("quantity", "value", "error", "unit", "kind", "meaning")))
    return {name: Estimate(value, error, unit, kind == "exact", meaning) for name, value, error, unit, kind, meaning in rows}


def _words(options):
    """Options as they would be typed, with all digits."""
    words = []
    for name, value in options.items():
        if value is True:
            words.append(f"--{name}")
        elif value is not None and value is not False:
            words.append(f"--{name}={value if isinstance(value, str) else repr(_number(name, value))}")
    return words


def _number(name, value):
    try:
        return value if isinstance(value, int) else float(value)
    except (TypeError, ValueError):
        raise ValueError(f"--{name}: {value!r} is not a number") from None


def _described(target, command, extra=(), without=("profile",)):
    """Signature and list of options, from what the command declares."""
    lines, parameters = [], []
    for name, _, allowed, meaning, standard in _lattice.options[command]:
        if name in without:
            continue
        try:
            default = int(standard) if standard.lstrip("-").isdigit() else float(standard)
        except ValueError:
            default = standard if standard in allowed.split(", ") else None
        parameters.append(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default))
        lines.append(f"{name}: {meaning}; {allowed}" + (f" (default: {standard})" if standard else ""))
    # Python 3.13 takes the indentation out of docstrings itself
    target.__doc__ = inspect.cleandoc(target.__doc__).replace("\nOPTIONS\n", "\n" + "\n".join(lines) + "\n")
    more = [inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=None) for name in extra]
    target.__signature__ = inspect.Signature(more + parameters)
    return target


class Well(_lattice.Well):
    """A well of your own.

    energy, force, stiffness: functions of a numpy array of displacements that return arrays of the same length: W(y),
        -W'(y) and W''(y). Errors are found by computing in extended precision too, so the functions get float64 or
        longdouble and should return what they get; numpy's own functions do.
    rim: displacement beyond which the well no longer pulls a bead back (default: none)

    Breathers need a well with W''(0) = 1, which the unit of time can always give."""

    def __init__(self, energy, force, stiffness, rim=math.inf):
        super().__init__(energy, force, stiffness, rim)


class Contact(_lattice.Contact):
    """A contact law of your own, as functions of the relative displacement r = y_(n+1) - y_n.

    energy, force, stiffness: functions of a numpy array: V(r), -V'(r) (not negative where beads repel) and V''(r);
        float64 or longdouble, as for a Well
    opening: the r at which the beads separate
    exponent: the exponent with which the force grows from there; it must be known, because steps across an opening or
        closing contact are corrected for it"""

    def __init__(self, energy, force, stiffness, opening=0.0, exponent=1.5):
        super().__init__(energy, force, stiffness, opening, exponent)


def _own(options, name, kind):
    """Takes a potential of one's own out of the options."""
    return options.pop(name) if isinstance(options.get(name), kind) else None


class Chain(_lattice.Chain):
    """A chain of beads, Eq. (32) with wells and contacts of any kind:

        mass_n y_n'' = -W'(y_n) + eta_(n+1) V'(y_(n+1) - y_n) - eta_n V'(y_n - y_(n-1)).

    OPTIONS
    mass: masses of the beads, `sites` numbers > 0 (default: one)
    eta: stiffnesses of the contacts, `sites` + 1 numbers >= 0; eta[n] is that of the contact on the left of bead n
        (default: one)

    `onsite` may be a `Well` and `contact` a `Contact` of your own. The attributes `sites`, `onsite`, `contact`, `ends`,
    `mass` and `eta` tell what the chain is. Beads are counted from zero here, and from one in the article."""

    def __init__(self, mass=None, eta=None, **options):
        well, contact = _own(options, "onsite", Well), _own(options, "contact", Contact)
        arrays = [[] if a is None else np.asarray(a, float).ravel().tolist() for a in (mass, eta)]
        super().__init__(_words(options), *arrays, well, contact)

    def __repr__(self):
        varied = "".join(f", {name} varied" for name in ("mass", "eta") if len(getattr(self, name)))
        return f"Chain of {self.sites or 'as many'} beads{'' if self.sites else ' as needed'}: " \
               f"wells {self.onsite}; contacts {self.contact}; ends {self.ends}{varied}"

    def evolve(self, y, v, time, sample=0.2, tolerance=1e-4):
        """The motion from positions `y` and velocities `v` (arrays of `sites` numbers) over `time`.

        The steps are halved until the end states of two runs agree to `tolerance`, relative to their largest entry;
        otherwise RuntimeError with the history. Returns a Result with the arrays t (samples), y and v (samples x sites),
        samples being at most `sample` apart, and the quantities error, of the end state, and energy_drift, the largest
        relative deviation of the energy, Eq. (6)."""
        t, y, v, error, drift = super().evolve(np.asarray(y, float).tolist(), np.asarray(v, float).tolist(), float(time),
                                               float(sample), float(tolerance))
        known = {"error": Estimate(error, 0, "relative", meaning="difference of the end states of the last two runs"),
                 "energy_drift": Estimate(drift, 0, "relative", meaning="largest deviation of the energy, Eq. (6)")}
        return Result(known, t=t, y=y, v=v)

    def energy_density(self, y, v):
        """e_n of Eq. (23), an array of `sites` numbers that adds up to the energy of Eq. (6)."""
        return super().energy_density(np.asarray(y, float).tolist(), np.asarray(v, float).tolist())

    def accelerations(self, y):
        """The accelerations of all beads at the positions `y`, an array of `sites` numbers."""
        return super().accelerations(np.asarray(y, float).tolist())


def _chain(found):
    """A chain that comes from the compiled half, with the methods of this one."""
    chain = Chain.__new__(Chain)
    _lattice.Chain.__init__(chain, found)
    return chain


def _refuse_both(options):
    for name in options:
        if name in {option[0] for option in _lattice.options["Chain"]}:
            raise ValueError(f"--{name}: belongs to the chain that is given (allowed: in Chain)")


def strike(chain=None, **options):
    """Strikes the first bead of a resting chain, Eq. (26), and follows the packet of energy that runs away (section 3.4).

    chain: a `Chain`; without one the wells and contacts are options. If it has no number of sites it is made as long as
        the packet needs; if it has, what its far end sends back belongs to the run.
    OPTIONS

    Returns a Result with the quantities of `sec34_impact run`: speed (of the foremost packet's centre X, Eq. (24), from site
    20 to twenty sites before the far end; sites per unit of time), centre (site, from one), strongest_site (of the largest
    energy density outside of the first five, which in hard wells need not be the foremost packet's), peak_energy_density,
    packet_energy_fraction, boundary_energy_fraction (first five sites), energy_drift and escaped (0 or 1), nan where one
    does not exist; the arrays n, y, v and e, one entry per bead: site (from one), position, velocity and energy density,
    Eq. (23), at the end; t, track_centre, track_energy and track_peak, one entry per sample: the packet's way, energy and
    largest density; and the `chain`. Errors are differences of the last two of a series of runs with halved steps.

    RuntimeError: a bead runs away, the motion reaches the far end, or no step reaches the tolerance."""
    if chain is not None:
        _refuse_both(options)
    found, end, track, chain = _lattice.strike(_words(options), chain)
    path = {"t": track["t"]} | {f"track_{name}": track[name] for name in ("centre", "energy", "peak")}
    return Result(_estimates(found), **end, **path, chain=_chain(chain))


def breather(**options):
    """A static breather, a periodic motion at rest in space (section 3.2), by Newton's method.

    OPTIONS

    `onsite` may be a `Well` of your own, and is then computed with calls into Python: seconds become minutes.

    Returns a Result with the quantities of `sec32_newton_breathers breather`: amplitude, energy (Eq. (6)), area (the
    integral of the squared velocities over a period), residual (distance after a period, relative to the amplitude) and
    iterations; the arrays n and y, one entry per bead: site (around the centre) and position at t = 0, where all are at
    rest; and the `chain`. Errors are differences from a wider number type.

    RuntimeError: Newton's method fails, or the branch that begins at omega = 1 does not reach `omega`."""
    well = _own(options, "onsite", Well)
    found, profile, chain = _lattice.breather(_words(options), well)
    return Result(_estimates(found), **profile, chain=_chain(chain))


def multipliers(**options):
    """The Floquet multipliers of a static breather (section 3.3), those next to +1 first.

    OPTIONS

    `onsite` may be a `Well` of your own, as in `breather`.

    Returns a Result with the quantity kappa = (lambda + 1/lambda - 2)/4 of the pinning pair, positive if the breather is
    unstable; and the arrays multiplier (complex) and multiplier_error, two entries per bead, the first two being the pair
    of the phase, which is exactly +1, as `sec33_floquet multipliers` prints them. Errors are differences of two
    tolerances."""
    well = _own(options, "onsite", Well)
    found, all_of_them = _lattice.multipliers(_words(options), well)
    return Result(_estimates(found), multiplier=all_of_them["real"] + 1j * all_of_them["imag"],
                  multiplier_error=all_of_them["error"])


def barrier(**options):
    """The Peierls-Nabarro barrier, the energy between the site-centred and the bond-centred breather (section 3.2).

    OPTIONS

    Returns a Result with the quantities of `sec32_barrier barrier`: equal_frequency, E_site - E_bond at one frequency, as
    in the article but with its sign, and equal_area, the same at equal area, which is what a moving breather keeps.
    Errors are differences of two tolerances in a wider number type."""
    return Result(_estimates(_lattice.barrier(_words(options))[0]))


def travelling(**options):
    """An exact travelling breather, y_n(t + T) = y_(n-1)(t), the open problem of section 5.

    OPTIONS

    Returns a Result with the quantities of `sec5_travelling_breathers orbit`: shift_time T, speed (sites per unit of time),
    energy, peak (largest energy density at t = 0), tail (left behind, relative to the amplitude), residual (relative to
    the amplitude) and multiplier_modulus (per shift); the arrays n, y and v, one entry per bead: site (around the
    centre), position and velocity at t = 0; and the `chain`. Errors are differences from a wider number type or of two
    tolerances.

    ValueError: there is no such orbit; the message names the nearest."""
    found, profile, chain = _lattice.travelling(_words(options))
    return Result(_estimates(found), **profile, chain=_chain(chain))


def dps(**options):
    """The same impact in the limit of small amplitude, the discrete p-Schroedinger equation (12) with Eq. (25).

    OPTIONS

    Returns a Result with the quantities of `sec31_dps_limit impact`: centre (site, from one), speed (sites per unit of
    slow time), amplitude, norm_window (share of the norm in the packet) and residual_boundary (share left on the first
    ten sites); the arrays n and amplitude_n, one entry per site: site (from one) and complex amplitude A_n at the end;
    and tau, track_centre, track_energy and track_peak, one entry per sample, the packet's way in |A_n|^2. They hold for
    every epsilon. Errors are differences of two tolerances."""
    found, end, track = _lattice.dps(_words(options))
    path = {"tau": track["t"]} | {f"track_{name}": track[name] for name in ("centre", "energy", "peak")}
    return Result(_estimates(found), n=end["n"], amplitude_n=end["real"] + 1j * end["imag"], **path)


def set_threads(count=0):
    """Sets the number of threads; zero stands for all cores that the process may use. No result depends on it."""
    _lattice.set_threads(count)


_described(Chain, "Chain", extra=["mass", "eta"])
_described(strike, "strike", extra=["chain"])
for _function in (breather, multipliers, barrier, travelling, dps):
    _described(_function, _function.__name__)
