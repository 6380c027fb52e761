#!/usr/bin/env python3
"""Random calls of the Python module: whatever is asked, it answers as it promises.

    fuzz.py PYTHON_FOLDER [COUNT [SEED]]

PYTHON_FOLDER holds the package, as build/python does. The calls are of all that computes, with options that are declared,
and small enough for a short run; a share of the arguments is what people get wrong, and what nobody does. Asked is of every
call: it returns, or raises ValueError, TypeError or RuntimeError with one line of at most 400 characters; nothing else is
said, but the warnings that are documented; a run ends at the time that was asked for; what is returned is finite and knows
its error, and a nan its reason; no more than 2 GB are taken, and no more than thirty seconds (times LATTICE_SLACK); and the
interpreter lives. The calls are made in processes of their own. Call number k of a seed is always the same."""

import concurrent.futures.process
import faulthandler
import math
import os
import pickle
import random
import resource
import sys
import warnings
from fractions import Fraction

sys.path[:0] = [os.path.abspath(sys.argv[1]), os.path.join(os.path.dirname(os.path.abspath(__file__)), "../tests/programs")]
import lattice  # noqa: E402
import numpy as np  # noqa: E402
from fuzz import SIZES, good_value  # noqa: E402

SECONDS = 30 * float(os.environ.get("LATTICE_SLACK", "1"))
MOST = 2 << 30  # bytes
MOST_STIFF = {"alpha": 3, "precompression": 2}  # contacts that are stiffer take very many steps
CALLS = ["strike", "strike", "breather", "multipliers", "barrier", "dps", "chain", "pickle", "evolve", "evolve", "evolve",
         "accelerations", "energy_density"]
ODD = [math.nan, math.inf, -math.inf, 0, -0.0, -1, 1e-3, 5e-324, -1e-9, 1e5, 1e20, 1e308, -1e308, 2**31, 2**63, 2**64, 10**400,
       -(10**5000), Fraction(1, 3), Fraction(10**400), np.int8(3), np.longdouble("1e4000"), None, True, np.True_, "", "x", "1/0",
       "nan", "1\n2", "\0", "\udcff", "é", "9" * 5000, b"1", 1j, [1], [[1, 2], [3]], [], {}, print, object(), np.ones(100000),
       np.array(None), np.array([None, 1], object), np.array(["a"]), ..., np.datetime64("2020-01-01"), type, np.array(2.0),
       (n for n in range(3)), np.ma.masked, memoryview(b"1")]


class Mine(Exception):
    """What a potential of one's own raises."""


def raises(y):
    raise Mine("mine")


# A well of one's own: three functions, and what people give instead of one
WELL = [lambda y: 2 * np.sinh(y / 2) ** 2, lambda y: -np.sinh(y), np.cosh]
WRONG = [None, 5, raises, lambda y: y[:-1], lambda y: None, lambda y: 1.0, lambda y: y * math.nan, lambda y: y + 0j,
         lambda y: 1.5 * y, lambda: 1, lambda y: np.zeros((3, 3)), lambda y: y * 1e300 * 1e300, lambda y: np.array([None] * len(y)),
         lambda y: list(y), lambda y: np.where(abs(y) < 1.01, -np.sinh(y), math.nan)]


class Call:
    """One call: what is done, and what it is done with."""

    def __init__(self, number, seed):
        self.chance = random.Random(f"{seed} {number}")
        self.share = self.chance.choice([0, 0, 0, 0.1, 0.3, 1])  # of odd arguments
        self.said = []
        self.what = self.chance.choice(CALLS)

    def either(self, *right, odd=ODD):
        """One of the right values, or an odd one."""
        return self.chance.choice(odd if self.chance.random() < self.share else right)

    def some(self, share=1, **arguments):
        """These arguments, which are noted, or none."""
        if self.chance.random() >= share:
            return {}
        self.said += [f"{name}={lattice._short(value)}" for name, value in arguments.items()]
        return arguments

    def option(self, name, allowed):
        """A value that is declared as allowed, and cheap."""
        if not allowed.startswith("["):
            return self.either(*allowed.split(", "))
        least, most = (float(x) for x in allowed[1:].split("]")[0].split(", "))
        x = good_value(self.chance, name, [least, min(most, MOST_STIFF.get(name, most))])
        return self.either(x, float(x), np.float64(x), Fraction(x))

    def options(self, command, without=()):
        out = {}
        for name, flag, allowed, *_ in lattice._lattice.options[command]:
            if not flag and name not in without:
                out |= self.some(1 if name in SIZES else 0.3, **{name: self.option(name, allowed)})
        return out | self.some(self.share / 3, **{self.chance.choice(["bogus", "", "x" * 1000, "a b", "s=1 --s", "help", "\udcff"]): 1})

    def numbers(self, count, scale):
        """A row, as people write one."""
        x = np.zeros(count)
        x[:max(1, count // 3)] = [self.chance.gauss(0, scale) for _ in range(max(1, count // 3))]
        hole = np.where(np.arange(count) == self.chance.randrange(count), self.chance.choice([math.nan, 1e20, 1e300, 1e-310]), x)
        return self.either(x, list(x), tuple(x), x.astype(np.float32), x.astype(np.longdouble), np.repeat(x, 2)[::2],
                           odd=[self.chance.choice(ODD), x[:-1], [x] * 3, [], hole])

    def well(self):
        functions = list(WELL)
        functions[self.chance.randrange(3)] = self.either(*WELL, odd=WRONG)
        return lattice.Well(*self.either(WELL, odd=[functions]), rim=self.either(math.inf))

    def chain(self, sites=1.0):
        own = self.chance.random() < 0.2
        options = self.options("Chain", without=("sites",) + ("well", "s") * own) | ({"well": self.well()} if own else {})
        options |= self.some(sites, sites=self.either(2, 3, 5, 8, 20))
        # Light beads take very many steps, which is long where each of them calls Python
        for name in ("mass", "eta"):
            options |= self.some(0.3, **{name: self.either(1, 2.5, [1], [1, 0.5], (2, 1, 1), range(1, 4), [0.01] if own else [1e-5])})
        return lattice.Chain(**options)

    def run(self):
        """Makes the call; returns what came back."""
        if self.what == "pickle":
            chain = self.chain()
            again = chain if chain._well else pickle.loads(pickle.dumps(chain, self.chance.choice([2, 3, 4, 5])))
            assert repr(again) == repr(chain) and np.array_equal(again.eta, chain.eta), "another chain comes back"
            return again
        if self.what == "chain":
            return lattice.strike(self.chain(sites=0.2), **self.options("strike", without=[o[0] for o in lattice._lattice.options["Chain"]]))
        if self.what in CALLS[:6]:
            return getattr(lattice, self.what)(**self.options(self.what))
        chain = self.chain()
        sites = chain.sites or 3
        state = self.some(y=self.numbers(sites, 0.3), v=self.numbers(sites, 1.0))
        if self.what != "evolve":
            return chain.accelerations(state["y"]) if self.what == "accelerations" else chain.energy_density(**state)
        rest = self.some(time=self.either(0.1, 3, 20, 20.5)) | self.some(0.5, sample=self.either(0.01, 0.2, 1, 100))
        rest |= self.some(0.5, tolerance=self.either(1e-2, 1e-6, 1e-9))
        if driven := self.chance.random() < 0.3 and hasattr(lattice, "drive"):  # volume two has it
            rest |= self.some(damping=self.either(0, 0.1, 2), force=self.either(0, 0.3), frequency=self.either(0, 1.1))
        most = 1e3 if chain.sites < 100 else 1
        if isinstance(rest["time"], (int, float)) and most < rest["time"] <= 1e9:
            rest["time"] = most
        found = lattice.drive(chain, **state, **rest) if driven else chain.evolve(**state, **rest)
        self.asked = float(rest["time"]), len(state["y"])
        return found


def complaints_of(call, found):
    """What is wrong with what came back."""
    if call.what == "evolve":
        time, sites = call.asked
        if not math.isclose(found.t[-1], time, rel_tol=1e-12) or not found.y.shape == found.v.shape == (len(found.t), sites):
            yield f"a run of {sites} sites over {time} ends at {found.t[-1]}, with the shapes {found.y.shape} and {found.v.shape}"
        if found.error == 0 and time >= 1 and np.ptp(found.y, axis=0).max() > 1e-9 * abs(found.y).max():
            yield "the error is zero"
    for name, value in getattr(found, "quantities", {}).items():
        if math.isinf(value) or math.isnan(value) and not value.reason or math.isfinite(value) and not value.error >= 0:
            yield f"{name} is {float(value)} with the error {value.error} and the reason '{value.reason}'"
    arrays = {"the array": found} if isinstance(found, np.ndarray) else vars(found) if hasattr(found, "quantities") else {}
    for name, value in arrays.items():
        # A packet that is not there has no place
        if isinstance(value, np.ndarray) and not np.all(np.isfinite(value)) and not name.startswith("track"):
            yield f"{name} has {value[~np.isfinite(value)][0]}"
    if len(text := repr(found)) > 4000 or not text.isascii():
        yield f"it is shown in {len(text)} characters"


def tried(number, seed):
    """How call number `number` was answered, the call in words, and what is wrong."""
    call, wrong = Call(number, seed), []
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            found = call.run()
            kind = "answered"
            wrong += complaints_of(call, found)
        except BaseException as error:
            kind, line = type(error).__name__, str(error)
            if type(error) not in (Mine, ValueError, TypeError, RuntimeError) or "\n" in line or not line.isprintable() or len(line) > 400:
                wrong.append(f"{kind} with {len(line)} characters: {line[:1000]!r}")
            if any(word in line for word in ("incompatible", "bad ", "std::", "variant", "vector", "stod", "_lattice")):
                wrong.append(f"speaks C++: {line}")
    wrong += [f"warns: {one.message}" for one in warned
              if not any(word in str(one.message) for word in ("expm1", "longdouble", "encountered"))]
    return kind, f"{call.what}({', '.join(call.said)})", wrong


def limited():
    """A process that may take a little more than is allowed, so that it lives to say so."""
    used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + MOST + (1 << 30), used + MOST + (1 << 30)))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def one(number, seed):
    """The answer to a call. One that hangs or dies ends its process, and the run."""
    faulthandler.dump_traceback_later(2 * SECONDS, exit=True)
    before = os.times().user
    kind, call, wrong = tried(number, seed)
    faulthandler.cancel_dump_traceback_later()
    taken = os.times().user - before, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    if taken[0] > SECONDS or taken[1] > MOST >> 10:
        wrong.append(f"takes {taken[0]} s and {taken[1]} KB")
    return kind, call, wrong


def main():
    count, seed = [int(word) for word in sys.argv[2:4]] + [150, 1][len(sys.argv[2:4]):]
    print(f"seed {seed}", flush=True)
    kinds, bad = {}, 0
    faulthandler.enable()
    with concurrent.futures.ProcessPoolExecutor(len(os.sched_getaffinity(0)), initializer=limited) as pool:
        answers = [pool.submit(one, number, seed) for number in range(count)]
        for number, answer in enumerate(answers):
            try:
                kind, call, wrong = answer.result()
            except concurrent.futures.process.BrokenProcessPool:
                sys.exit(f"the interpreter ends or hangs in call {number} or one of the next")
            kinds[kind] = kinds.get(kind, 0) + 1
            bad += bool(wrong)
            for what in wrong:
                print(f"{number}: {call}: {what}", flush=True)
    print(f"{count} random calls, seed {seed}: {dict(sorted(kinds.items()))}, {bad} answers wrong")
    sys.exit(bad > 0 or kinds.get("answered", 0) < count / 8 or kinds.get("ValueError", 0) < count / 8)


if __name__ == "__main__":
    main()
