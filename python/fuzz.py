#!/usr/bin/env python3
"""Random calls of the Python module: whatever is asked, it answers as it promises.

    fuzz.py PYTHON_FOLDER [COUNT [SEED]]

PYTHON_FOLDER holds the package, as build/python does. The calls have options that are declared, small enough for a short
run; a share of the arguments is what people get wrong, and what nobody does. Asked is of every call: it returns, or raises
ValueError, TypeError or RuntimeError with one line of at most 400 characters; it warns of nothing but what is documented; a
run ends at the time that was asked for; what is returned is finite and knows its error, and a nan its reason; no more than
2 GB and thirty seconds (times LATTICE_SLACK) are taken; and the interpreter lives. Call number k of a seed is always the
same."""

import concurrent.futures.process
import faulthandler
import math
import os
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
CALLS = ["strike", "breather", "multipliers", "barrier", "dps", "evolve", "evolve", "evolve", "accelerations", "energy_density"]
ODD = [math.nan, math.inf, -math.inf, 0, -0.0, -1, 1e-3, 5e-324, -1e-9, 1e5, 1e20, 1e308, -1e308, 2**31, 2**63, 2**64, 10**400,
       -(10**5000), Fraction(1, 3), Fraction(10**400), np.int8(3), np.longdouble("1e4000"), None, True, np.True_, "", "x", "1/0",
       "nan", "1\n2", "\0", "\udcff", "é", "9" * 5000, b"1", 1j, [1], [[1, 2], [3]], [], {}, print, object(), np.ones(100000),
       np.array(None), np.array([None, 1], object), np.array(["a"]), ..., np.datetime64("2020-01-01"), type, np.array(2.0),
       (n for n in range(3)), np.ma.masked, memoryview(b"1")]


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
        x = np.array([self.chance.gauss(0, scale) if n <= count // 3 else 0 for n in range(count)])
        hole = np.where(np.arange(count) == self.chance.randrange(count), self.chance.choice([math.nan, 1e20, 1e300, 1e-310]), x)
        return self.either(x, list(x), tuple(x), x.astype(np.float32), x.astype(np.longdouble), np.repeat(x, 2)[::2],
                           odd=[self.chance.choice(ODD), x[:-1], [x] * 3, [], hole])

    def run(self):
        """Makes the call; returns what came back."""
        if self.what in lattice._lattice.options:
            return getattr(lattice, self.what)(**self.options(self.what))
        options = self.options("Chain", without=("sites",)) | self.some(sites=self.either(2, 3, 5, 8, 20))
        for name in ("mass", "eta"):
            options |= self.some(0.3, **{name: self.either(1, 2.5, [1], [1, 0.5], (2, 1, 1), range(1, 4), [1e-5])})
        chain = lattice.Chain(**options)
        state = self.some(y=self.numbers(chain.sites or 3, 0.3), v=self.numbers(chain.sites or 3, 1.0))
        if self.what != "evolve":
            return chain.accelerations(state["y"]) if self.what == "accelerations" else chain.energy_density(**state)
        rest = self.some(time=self.either(0.1, 3, 20, 20.5)) | self.some(0.5, sample=self.either(0.01, 0.2, 1, 100))
        rest |= self.some(0.5, tolerance=self.either(1e-2, 1e-6, 1e-9))
        if driven := self.chance.random() < 0.3 and hasattr(lattice, "drive"):  # volume two has it
            rest |= self.some(damping=self.either(0, 0.1, 2), force=self.either(0, 0.3), frequency=self.either(0, 1.1))
        if isinstance(rest["time"], (int, float)) and 1e3 < rest["time"] <= 1e9:
            rest["time"] = 1e3
        found = lattice.drive(chain, **state, **rest) if driven else chain.evolve(**state, **rest)
        if not math.isclose(found.t[-1], rest["time"], rel_tol=1e-12) or not found.y.shape == found.v.shape == (len(found.t), chain.sites):
            raise AssertionError(f"it ends at {found.t[-1]}, with the shapes {found.y.shape} and {found.v.shape}")
        return found


def complaints_of(found):
    """What is wrong with what came back."""
    for name, value in getattr(found, "quantities", {}).items():
        if math.isinf(value) or math.isnan(value) and not value.reason or math.isfinite(value) and not value.error >= 0:
            yield f"{name} is {float(value)} with the error {value.error} and the reason '{value.reason}'"
    for name, value in {"the array": found}.items() if isinstance(found, np.ndarray) else vars(found).items():
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
            wrong += complaints_of(found)
        except BaseException as error:
            kind, line = type(error).__name__, str(error)
            if type(error) not in (ValueError, TypeError, RuntimeError) or "\n" in line or not line.isprintable() or len(line) > 400:
                wrong.append(f"{kind} with {len(line)} characters: {line[:1000]!r}")
            if any(word in line for word in ("incompatible", "bad ", "std::", "variant", "vector", "stod", "_lattice")):
                wrong.append(f"speaks C++: {line}")
    wrong += [f"warns: {one.message}" for one in warned
              if not any(word in str(one.message) for word in ("expm1", "longdouble", "encountered"))]
    return kind, f"{call.what}({', '.join(call.said)})", wrong


def limited():
    """A process that may take a little more than is allowed, so that it lives to say so."""
    most = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize() + MOST + (1 << 30)
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
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
