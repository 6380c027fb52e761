"""Breathers in oscillator chains with Hertzian interactions, from Python.

The functions are commands of the programs: `strike`, `breather`, `multipliers`, `barrier` and `dps` take the same
options, compute the same bits and reject the same input with the same message (ValueError; a computation that fails is a
RuntimeError). A `Chain` may have masses, contacts and wells of your own.

    >>> import lattice
    >>> lattice.strike(velocity=1.5, time=200, s="-1/6").speed
    >>> lattice.strike(lattice.Chain(100, mass=[1, 1.1]), velocity=1, time=150).centre
    >>> lattice.breather(contact="power", alpha=1.8).amplitude

All quantities are dimensionless, as in Eqs. (9) and (10): in these units of time and length the frequency of small
oscillations in a well and the coefficient of the contact force are one. Equation numbers are those of
James, Kevrekidis and Cuevas, Physica D 251 (2013) 39-59. A long computation can be interrupted (Ctrl-C) and releases
the interpreter lock. Results do not depend on the number of threads (`set_threads`). A Chain and a Result can be pickled,
so that processes can share a scan; so can potentials of your own, if their functions can be pickled.
"""

import inspect
import math
import numbers
import reprlib
import sys
import warnings
from pathlib import Path

try:
    import numpy as np
except ImportError:
    raise ImportError(f"lattice needs numpy, which {sys.executable} lacks (Debian: apt install python3-numpy, and "
                      "call /usr/bin/python3; in a virtual environment: pip install numpy)") from None
try:
    from . import _lattice
except ImportError as _error:
    _found = [path.name for path in Path(__file__).parent.glob("_lattice.*")]
    raise ImportError(
        "lattice: the compiled part is missing (`make python` builds it; before cmake --install, cmake --build BUILD "
        "--target python_module)" if not _found else
        f"lattice: {_found[0]} cannot be loaded by {sys.executable}, a Python {sys.version.split()[0]}"
        + (f": {_error}" if "circular" not in str(_error) else " (it was compiled for a different Python)")) from None

__version__ = _lattice.version
__all__ = ["Chain", "Contact", "Estimate", "Result", "Well", "barrier", "breather", "dps", "multipliers", "set_threads",
           "strike"]


class Estimate(float):
    """A number with its error: a float with the attributes `error` (absolute, in the unit of the number), `unit`
    (empty if dimensionless), `exact` (True where no error can arise), `meaning` (a description) and `reason` (why it is
    nan; otherwise empty). Errors are differences of two resolutions, as in the tables of the programs.
    Arithmetic returns plain floats."""

    def __new__(cls, value, error, unit="", exact=False, meaning="", reason=""):
        self = super().__new__(cls, value)
        self.error, self.unit, self.exact, self.meaning, self.reason = float(error), unit, exact, meaning, reason
        return self

    def __getnewargs__(self):
        return float(self), self.error, self.unit, self.exact, self.meaning, self.reason

    def __str__(self):
        """The significant digits and the error; for a nan, its reason."""
        value = float(self)
        if self.reason:
            return f"{value} ({self.reason})"
        if self.exact or not (self.error > 0 and math.isfinite(value)):
            text = f"{value:.17g}" if not math.isfinite(value) or self.error == 0 else f"{value:.3g}"
            return f"{text} {self.unit}".rstrip()
        sure = math.floor(math.log10(abs(value))) - math.floor(math.log10(self.error)) if value else 0
        digits = f"#.{min(sure + 1, 17)}" if sure > 0 else ".1"
        return f"{value:{digits}g} +- {self.error:.0e} {self.unit}".rstrip()

    __repr__ = __str__


class Result:
    """The result of a function. `quantities` is a dictionary of Estimates, each with its `meaning`; they and the arrays are
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
    rows = zip(*(table[name] for name in ("quantity", "value", "error", "unit", "kind", "meaning", "reason")))
    return {name: Estimate(value, error, unit, kind == "exact", meaning, reason)
            for name, value, error, unit, kind, meaning, reason in rows}


def _short(value):
    """A value in one short line, for a complaint."""
    return f"array of shape {value.shape}" if isinstance(value, np.ndarray) else " ".join(reprlib.repr(value).split())


def _number(name, value):
    """A real number as a float: no text, no truth value, no array."""
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise ValueError(f"{name}: {_short(value)} is not a number")
    return float(value)


def _within(name, value, least, most):
    x = _number(name, value)
    if not least <= x <= most:
        raise ValueError(f"{name}: {_short(value)} is not in the allowed range [{least:g}, {most:g}]")
    return x


def _array(name, value, shapes, fits):
    """Finite real numbers as an array that fits. `shapes` tells which do."""
    try:
        array = np.asarray(value)
        if array.dtype.kind in "biufO" and not np.ma.is_masked(value):
            with np.errstate(all="ignore"):
                array = np.ascontiguousarray(array, float).reshape(array.shape)
    except (TypeError, ValueError, OverflowError):
        array = None
    if array is None or array.dtype != float or np.ma.is_masked(value):
        raise ValueError(f"{name}: {_short(value)} is not an array of real numbers")
    if not fits(array.shape):
        has = f"{len(array)} entries" if array.ndim == 1 else _short(value) if not array.ndim else f"shape {array.shape}"
        raise ValueError(f"{name}: {has} (allowed: {shapes})")
    bad = np.flatnonzero(~np.isfinite(array))
    if len(bad):
        at = np.unravel_index(bad[0], array.shape)
        raise ValueError(f"{name}: {array[at]} in entry {', '.join(map(str, at))} (allowed: finite numbers)")
    return array


def _words(command, options):
    """Options as they would be typed, with all digits."""
    declared = {name: (flag, allowed) for name, flag, allowed, *_ in _lattice.options[command]}
    words = []
    for name, value in options.items():
        name = _DASHED.get(name, name)
        flag, allowed = declared.get(name, (False, ""))
        if name not in declared or flag and value is True:
            words.append(f"--{name}")
        elif value is not None and not (flag and value is False):
            words.append(f"--{name}={_typed(name, value, allowed)}")
    return words


def _typed(name, value, allowed):
    """A value as it would be typed."""
    if isinstance(value, str):
        return value
    if isinstance(value, (_lattice.Well, _lattice.Contact)):
        kind = type(value).__name__
        raise ValueError(f"--{name}: a {kind} of your own is accepted only in a Chain (allowed: {allowed})")
    if not allowed.startswith("["):
        raise ValueError(f"--{name}: {_short(value)} is not one of the allowed names {allowed}")
    return str(value) if isinstance(value, numbers.Integral) and not isinstance(value, bool) else repr(_number(f"--{name}", value))


def _described(target, command, extra=()):
    """Signature and list of options, from what the command declares."""
    lines, parameters = [], []
    for name, flag, allowed, meaning, standard in _lattice.options[command]:
        if flag:
            continue  # --profile, which is for programs
        try:
            default = int(standard) if standard.lstrip("-").isdigit() else float(standard)
        except ValueError:
            default = standard if standard in allowed.split(", ") else None
        name = name.replace("-", "_")
        if name not in extra:
            parameters.append(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default))
        lines.append(f"{name}: {meaning}; {allowed}" + (f" (default: {standard})" if standard else ""))
    if target.__doc__:  # which `python -OO` throws away; Python 3.13 takes the indentation out itself
        target.__doc__ = inspect.cleandoc(target.__doc__).replace("\nOPTIONS\n", "\n" + "\n".join(lines) + "\n")
    more = [inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=None) for name in extra]
    target.__signature__ = inspect.Signature(more + parameters)
    return target


class Well(_lattice.Well):
    """A well of your own.

    energy, force, stiffness: functions of a numpy array of displacements that return arrays of the same length: W(y),
        -W'(y) and W''(y). Errors come from a second computation in extended precision, so the functions receive float64
        or longdouble and should return the same type, as numpy's own functions do.
    rim: displacement beyond which the well no longer pulls a bead back (default: none)

    Breathers need a well with W''(0) = 1; a suitable unit of time always gives this."""

    def __init__(self, energy, force, stiffness, rim=math.inf):
        functions = _functions(energy=energy, force=force, stiffness=stiffness)
        super().__init__(*functions.values(), _number("rim", rim))
        narrow = [name for name, function in functions.items() if _is_narrow(function)]
        if narrow:
            warnings.warn(f"{' and '.join(narrow)} of the well: not longdouble for longdouble arguments, so the errors of "
                          "breathers and multipliers will be too small", stacklevel=2)
        if self._loses_digits:
            warnings.warn(_lattice.digits_hint, stacklevel=2)

    def __reduce__(self):
        return type(self), (*self.functions, self.rim)

    def __repr__(self):
        return f"Well of your own, rim {self.rim:g}"


class Contact(_lattice.Contact):
    """A contact law of your own, as functions of the relative displacement r = y_(n+1) - y_n.

    energy, force, stiffness: functions of a numpy array: V(r), -V'(r) (not negative where beads repel) and V''(r);
        float64 or longdouble, as for a Well
    opening: the r at which the beads separate
    exponent: the exponent with which the force grows from there; the integrator needs it to correct steps in which a
        contact opens or closes"""

    def __init__(self, energy, force, stiffness, opening=0.0, exponent=1.5):
        super().__init__(*_functions(energy=energy, force=force, stiffness=stiffness).values(),
                         _number("opening", opening), _number("exponent", exponent))
        if self._loses_digits:
            warnings.warn("the force of the contact loses digits in small motions: write it with expm1, log1p or the like",
                          stacklevel=2)

    def __reduce__(self):
        return type(self), (*self.functions, self.opening, self.exponent)

    def __repr__(self):
        return f"Contact of your own, exponent {self.exponent:g}, opening {self.opening:g}"


def _functions(**functions):
    for name, function in functions.items():
        if not callable(function):
            raise TypeError(f"{name}: {_short(function)} is not a function")
    return functions


def _is_narrow(function):
    """Whether digits are lost where more are asked for. Whole numbers have none to lose."""
    try:
        y = np.asarray(function(np.array([-0.1, 0.1], np.longdouble)))
        return y.dtype != np.longdouble and bool(np.any(y != np.round(y)))
    except Exception:  # some functions know no longdouble
        return True


_DASHED = {"mass_ratio": "mass-ratio", "defect_mass": "defect-mass"}  # names that Python would take for a difference


def _given(chain, options, named=()):
    """A chain that a function takes, beside which the options of chains have no place, nor have those that are `named`."""
    if chain is None:
        return None
    if not isinstance(chain, Chain):
        raise TypeError(f"chain: {_short(chain)} is not a lattice.Chain")
    for name in options:
        if name in named or name in {option[0] for option in _lattice.options["Chain"]}:
            raise ValueError(f"--{name}: belongs to the given chain (allowed: in Chain)")
    return chain


def _own(options, name, kind):
    """Takes a potential of one's own out of the options, which then have no parameters of the library's."""
    if not isinstance(options.get(name), kind):
        return None
    for parameter in _lattice.parameters[name]:
        if options.get(parameter) is not None:
            raise ValueError(f"--{parameter}: a {kind.__name__} of your own does not have it (allowed: with a named potential)")
    return options.pop(name)


def _repeated(name, row, count, ring):
    """A row of `count` numbers, or a pattern that is repeated along the chain. The two ends of a ring are one contact."""
    if row is None:
        return []
    if count < 2:
        raise ValueError(f"{name}: the chain has no number of sites (allowed: with `sites`)")
    row = _array(name, row, f"{count}, or a pattern that fits at least twice",
                 lambda shape: len(shape) < 2 and (shape in ((), (count,)) or 0 < 2 * shape[0] <= count)).ravel()
    around = count - (name == "eta")
    if ring and 1 < len(row) < count and around % len(row):
        raise ValueError(f"{name}: a pattern of length {len(row)} does not close on a ring of {around} sites "
                         f"(allowed: a length that divides {around})")
    return np.append(np.resize(row, around), row[:count - around]) if len(row) < count and ring else np.resize(row, count)


def _range(name, row):
    """The range of masses or stiffnesses, in words; nothing where all are one."""
    return "" if np.all(row == 1) else f"; {name} {row.min():g} to {row.max():g}"


class Chain(_lattice.Chain):
    """A chain of beads, Eq. (32) with wells and contacts of any kind:

        mass_n y_n'' = -W'(y_n) + eta_(n+1) V'(y_(n+1) - y_n) - eta_n V'(y_n - y_(n-1)).

    OPTIONS
    mass: masses of the beads, `sites` numbers > 0, or a pattern that is repeated along the chain, such as [1, 0.5]
        (default: one)
    eta: stiffnesses of the contacts, `sites` + 1 numbers >= 0, or a pattern; eta[n] belongs to the contact on the left of
        bead n, the last one to the contact at the right end (default: one)

    `well` may be a `Well` and `contact` a `Contact` of your own. The attributes `sites`, `well`, `contact`, `ends`,
    `mass` and `eta` describe the chain. Beads are counted from zero here, and from one in the article."""

    def __init__(self, sites=None, mass=None, eta=None, **options):
        well, contact = _own(options, "well", Well), _own(options, "contact", Contact)
        super().__init__(_words("Chain", {"sites": sites, **options}), well, contact)
        self._vary(_repeated("mass", mass, self.sites, self.ends == "periodic"),
                   _repeated("eta", eta, self.sites and self.sites + 1, self.ends == "periodic"))

    def __reduce__(self):
        options = {"sites": self.sites or None, "ends": self.ends}
        for name, own, kind in (("well", self._well, Well), ("contact", self._contact, Contact)):
            word, *parameters = getattr(self, name).split(", ")
            if own:
                word = kind(*own.functions, *([own.rim] if kind is Well else [own.opening, own.exponent]))
            options |= {name: word} | dict(parameter.split(" = ") for parameter in parameters)
        for name in ("mass", "eta"):
            if len(getattr(self, name)):
                options[name] = getattr(self, name)
        return _made, (type(self), options), self.__dict__ or None

    def __repr__(self):
        return f"Chain of {self.sites or 'as many'} beads{'' if self.sites else ' as needed'}: wells {self.well}; " \
               f"contacts {self.contact}; ends {self.ends}{_range('mass', self.mass)}{_range('eta', self.eta)}"

    def _rows(self, samples=True, **arrays):
        """Positions or velocities: one number a site, or a whole run of such rows where that may be; all of one shape."""
        if not self.sites:
            raise ValueError("the chain has no number of sites (allowed: Chain(sites=...))")
        shapes = f"{self.sites}, one per site" + (f", or samples x {self.sites}" if samples else "")
        out = [_array(name, value, shapes, lambda shape: 0 < len(shape) < 2 + samples and shape[-1] == self.sites)
               for name, value in arrays.items()]
        if out[0].shape != out[-1].shape:
            raise ValueError(f"y and v: shapes {out[0].shape} and {out[-1].shape} (allowed: equal shapes)")
        return out

    def _run(self, y, v, time, sample, tolerance):
        """What begins a run: one number a site, a time and how to look at it."""
        return *self._rows(samples=False, y=y, v=v), _within("time", time, 0, 1e9), _within("sample", sample, 1e-9, 1e9), _within("tolerance", tolerance, 1e-14, 0.1)

    def evolve(self, y, v, time, sample=0.2, tolerance=1e-4):
        """The motion from positions `y` and velocities `v` (arrays of `sites` numbers) over `time`.

        The step is halved until the final states of two runs agree to `tolerance`, relative to their largest entry.

        Returns a Result with the arrays t (samples), y and v (samples x sites; 2 GB at most), the samples being at most
        `sample` apart, and the quantities error, of the final state, and energy_drift, the largest relative deviation of
        the energy, Eq. (6). The error is zero only where rounding leaves no difference, as in a chain at rest.

        RuntimeError: the runs do not agree (the message has the history), or a bead runs away."""
        t, y, v, error, drift = super().evolve(*self._run(y, v, time, sample, tolerance))
        known = {"error": Estimate(error, 0, "relative", meaning="twice the difference between the final states of the last two "
                                                                 "runs, if the tolerance allows it"),
                 "energy_drift": Estimate(drift, 0, "relative", meaning="largest deviation of the energy, Eq. (6)")}
        return Result(known, t=t, y=y, v=v)

    def _orbit(self, y, period):
        """What begins an orbit: one number a site, and a period."""
        if self.sites > 1000:
            raise ValueError(f"the chain has {self.sites} sites (allowed: at most 1000)")
        return *self._rows(samples=False, y=y), _within("period", period, 1e-3, 1e5)

    def orbit(self, y, period):
        """A periodic orbit of the given period, even in time, near a guess of your own: at t = 0 at rest at the positions `y`
        (an array of `sites` numbers). Any wells, contacts, masses and ends; found by Newton's method as in `breather`.

        Returns a Result with the quantities amplitude (half the distance between the extreme positions of the bead that moves
        most), energy (Eq. (6)), area (2 pi times the action), residual and iterations as in `breather`, and repeats (how many
        times the motion repeats itself in the given period; 1 if that is the minimal one), and the arrays y and y_error, the
        positions at t = 0. Errors are differences from extended precision. Near a bifurcation, or from a distant guess,
        Newton's method may find a different orbit: compare y with the guess. Where a shift of the whole chain costs nothing,
        the orbit is the one nearest to the guess.

        ValueError: nothing moves. RuntimeError: Newton's method fails (the message has its history), shrinks to rest, or
        leaves the guess far behind."""
        found, y, y_error = super().orbit(*self._orbit(y, period))
        return Result(_estimates(found), y=y, y_error=y_error)

    def multipliers(self, y, period):
        """All Floquet multipliers of a periodic orbit, as `orbit` finds it, that begins at rest at the positions `y` (an array of
        `sites` numbers) and returns after `period`.

        Returns a Result with the quantity largest_modulus (the orbit is unstable if it exceeds one by more than its error)
        and the arrays multiplier (complex) and multiplier_error, two entries per bead, as `lattice.multipliers` does: the
        first two are the time-translation pair, exactly +1, followed by those next to +1. Errors are differences of two
        precisions.

        ValueError: no periodic orbit begins within a thousandth of the amplitude, or nothing moves. RuntimeError: Newton's
        method fails."""
        modulus, error, found = super().multipliers(*self._orbit(y, period))
        numbers, errors = zip(*found)
        known = {"largest_modulus": Estimate(modulus, error, meaning="largest modulus of all multipliers; the orbit is "
                                                                     "unstable if it exceeds 1 by more than its error")}
        return Result(known, multiplier=np.array(numbers), multiplier_error=np.array(errors))

    def energy_density(self, y, v):
        """e_n of Eq. (23), an array of `sites` numbers that adds up to the energy of Eq. (6); `y` and `v` may be those of a
        whole run (samples x sites)."""
        return _finite("energy density", super().energy_density(*self._rows(y=y, v=v)))

    def accelerations(self, y):
        """The accelerations of all beads at the positions `y`, an array of `sites` numbers, or samples x sites."""
        return _finite("acceleration", super().accelerations(*self._rows(y=y)))


def _finite(what, array):
    bad = np.flatnonzero(~np.isfinite(array))
    if len(bad):
        raise RuntimeError(f"the {what} of bead {bad[0] % array.shape[-1]} is {array.flat[bad[0]]}: outside the range of "
                           "double precision, or of a potential of your own")
    return array


def _made(kind, options):
    """A chain made again, as it was before it was pickled."""
    chain = kind.__new__(kind)
    Chain.__init__(chain, **options)
    return chain


def _chain(found):
    """A chain that comes from the compiled half, with the methods of this one."""
    chain = Chain.__new__(Chain)
    _lattice.Chain.__init__(chain, found)
    return chain


def strike(chain=None, **options):
    """Strikes the first bead of a chain at rest, Eq. (26), and follows the packet of energy that travels away (section 3.4).

    chain: a `Chain`; without one, wells and contacts are options. A chain without a number of sites is made as long as
        the packet needs; one with a number keeps it, and reflections from its far end are part of the run.
    OPTIONS

    Returns a Result with the quantities of `sec34_impact run`: speed (of the foremost packet's centre X, Eq. (24), from site
    20 to twenty sites before the far end; sites per unit of time), centre (site, from one), strongest_site (of the largest
    energy density beyond the first five sites, which in hard wells may lie outside the foremost packet),
    peak_energy_density (the foremost packet's largest maximum in time from site 20 on), packet_energy_fraction,
    boundary_energy_fraction (first five sites), energy_drift, escaped and far_end_moved (both 0 or 1); one that does not
    exist is nan. It has the arrays n, y, v and e, one entry per bead: site (from one), position, velocity and energy
    density, Eq. (23), at the end; t, track_centre, track_energy and track_peak, one entry per sample: the packet's centre,
    energy and largest density; and the `chain`. Errors are differences of the last two of a series of runs with halved steps.

    RuntimeError: a bead runs away, the motion reaches the far end, or no step reaches the tolerance."""
    found, end, track, chain = _lattice.strike(_words("strike", options), _given(chain, options))
    path = {"t": track["t"]} | {f"track_{name}": track[name] for name in ("centre", "energy", "peak")}
    return Result(_estimates(found), **end, **path, chain=_chain(chain))


def breather(chain=None, **options):
    """A static breather, a localised periodic motion (section 3.2), by Newton's method.

    chain: a `Chain`; without one, wells, contacts and masses are options. Its masses and stiffnesses must be symmetric
        about its middle, its ends free. A chain without a number of sites is made as long as the tail needs.
    OPTIONS

    `well` may be a `Well` of your own; its calls into Python turn seconds into minutes. All exponents are found like that
    of spheres; compression and masses are reached by continuation from equal, uncompressed beads at the same frequency,
    which must be above the linear waves of the chain.

    Returns a Result with the quantities of `sec32_newton_breathers breather`: amplitude, energy (Eq. (6)), area (the
    integral of twice the kinetic energy over a period, 2 pi times the action), residual (distance after a period, relative
    to the amplitude) and iterations; the arrays n, y and y_error, one entry per bead: site (from the centre), position at
    t = 0, when all beads are at rest, and its error; and the `chain`. Errors are differences of two precisions, those of
    positions of two tolerances.

    RuntimeError: Newton's method fails, the branch from omega = 1 does not reach `omega`, or the continuation stops."""
    _given(chain, options, _DASHED)
    well = _own(options, "well", Well)
    found, profile, chain = _lattice.breather(_words("breather", options), well, chain)
    return Result(_estimates(found), **profile, chain=_chain(chain))


def multipliers(chain=None, **options):
    """The Floquet multipliers of a static breather (section 3.3), those next to +1 first.

    chain: a `Chain`, as in `breather`
    OPTIONS

    `well` may be a `Well` of your own, as in `breather`.

    Returns a Result with the quantities kappa = (lambda + 1/lambda - 2)/4 of the pinning (translational) pair, the one
    nearest to +1, and largest_modulus of all multipliers; and the arrays multiplier (complex) and multiplier_error, two
    entries per bead, beginning with the time-translation pair, exactly +1, as `sec33_floquet multipliers` prints them. The
    breather is unstable if largest_modulus exceeds one by more than its error, as it does where kappa is positive by more
    than its error; a negative kappa says nothing about the other pairs. Errors are differences of two tolerances."""
    _given(chain, options, _DASHED)
    well = _own(options, "well", Well)
    found, all_of_them = _lattice.multipliers(_words("multipliers", options), well, chain)
    return Result(_estimates(found), multiplier=all_of_them["real"] + 1j * all_of_them["imag"],
                  multiplier_error=all_of_them["error"])


def barrier(chain=None, **options):
    """The Peierls-Nabarro barrier, the energy difference of the site- and the bond-centred breather (section 3.2).

    chain: a `Chain` without a number of sites, since the two breathers need chains of different length; without one, wells
        and contacts are options, and `well` may be a `Well` of your own
    OPTIONS

    Returns a Result with the quantities of `sec32_barrier barrier`: equal_frequency, E_site - E_bond at the same frequency,
    as in the article but with its sign, and equal_area, the same at equal area (2 pi times the action), which a moving
    breather keeps. Errors are differences of two tolerances in extended precision."""
    if _given(chain, options) and (chain.sites or chain.ends != "free"):
        raise ValueError(f"chain: {chain.sites or 'no'} beads, ends {chain.ends} (allowed: no number of sites, free ends)")
    well = _own(options, "well", Well)
    return Result(_estimates(_lattice.barrier(_words("barrier", options), well, chain)[0]))


def dps(**options):
    """An impact in the limit of small amplitude, the discrete p-Schroedinger equation (12) with Eq. (25).

    OPTIONS

    Returns a Result with the quantities of `sec31_dps_limit impact`: centre (site, from one), speed (sites per unit of
    slow time), amplitude, norm_window (fraction of the norm in the packet) and residual_boundary (fraction left on the
    first ten sites); the arrays n, amplitude_n and amplitude_error, one entry per site: site (from one), complex amplitude
    A_n at the end and its error; and tau, track_centre, track_energy and track_peak, one entry per sample, which follow the
    packet in |A_n|^2. The results hold for every epsilon. Errors are differences of two tolerances.

    RuntimeError: the motion is too erratic for so long a run."""
    found, end, track = _lattice.dps(_words("dps", options))
    path = {"tau": track["t"]} | {f"track_{name}": track[name] for name in ("centre", "energy", "peak")}
    return Result(_estimates(found), n=end["n"], amplitude_n=end["real"] + 1j * end["imag"],
                  amplitude_error=end["error"], **path)


def set_threads(count=0):
    """Sets the number of threads; zero means all cores that the process may use. Results do not depend on it."""
    for half in filter(None, (_lattice, _beyond)):
        half.set_threads(int(_within("count", count, 0, 1024)))


_described(Chain, "Chain", extra=["sites", "mass", "eta"])
for _function in (strike, breather, multipliers, barrier):
    _described(_function, _function.__name__, extra=["chain"])
_described(dps, "dps")
# Volume two, where it is built
try:
    from ._volume_two import _beyond, drive, travelling
    __all__ += ["drive", "travelling"]
except ModuleNotFoundError:
    _beyond = None
