"""Tests of the Python module. Argument: the folder of the programs, whose numbers and complaints are the measure."""

import concurrent.futures
import csv
import functools
import importlib.util
import inspect
import math
import multiprocessing
import os
import pickle
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
import zipfile
from fractions import Fraction
from pathlib import Path

import numpy as np

import backend
import lattice
import notebooks

BIN = Path(sys.argv.pop(1)) if __name__ == "__main__" else None  # a process of a test reads this file too
HERE = Path(__file__).parent


def program(command, *options):
    """What a program says: its rows by column, or the line with which it refuses."""
    name, *words = command.split()
    run = subprocess.run([BIN / name, *words, *options], capture_output=True, text=True)
    if run.returncode:
        return run.stderr.strip().removeprefix(name + ": ")
    rows = list(csv.reader(line for line in run.stdout.splitlines() if not line.startswith("#")))
    return {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])}


def python(code, env=(), **more):
    """An interpreter of its own that runs this code."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, env=os.environ | dict(env), **more)


def bits(x):
    return np.asarray(x, float).tobytes()


class SameBits(unittest.TestCase):
    """Numbers are those of the programs to the last bit, and so are errors, units and profiles."""

    def check(self, function, command, profile=(), **options):
        words = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
        found = function(**options)
        table = program(command, *words)
        self.assertEqual(list(found.quantities), table["quantity"])
        got = list(found.quantities.values())
        self.assertEqual(bits(got), bits(table["value"]))
        self.assertEqual(bits([q.error for q in got]), bits(table["error"]))
        self.assertEqual([q.unit for q in got], table["unit"])
        self.assertEqual(["exact" if q.exact else "estimate" for q in got], table["kind"])
        self.assertEqual([q.meaning for q in got], table["meaning"])
        self.assertEqual([q.reason for q in got], table["reason"])
        self.assertTrue(all(table["meaning"]))
        if profile:
            table = program(command, *words, "--profile")
            for name in profile:
                self.assertEqual(bits(getattr(found, name)), bits(table[name]), name)
        return found

    def test_strike(self):
        found = self.check(lattice.strike, "sec34_impact run", "nyve", velocity=1.5, time=150, s="-1/6")
        self.assertEqual((len(found.y), len(found.t)), (found.chain.sites, len(found.track_centre)))
        self.assertEqual(found.track_centre[-1], found.centre)
        self.check(lattice.strike, "sec34_impact run", "y", velocity=1, time=60, contact="power", alpha=2, well="pendulum")

    def test_a_nan_has_its_reason(self):
        found = self.check(lattice.strike, "sec34_impact run", velocity=1, time=10)
        self.assertTrue(math.isnan(found.speed) and found.speed.reason)
        self.assertIn(f"= nan ({found.speed.reason})", repr(found))

    def test_a_chain_and_an_earlier_name_say_the_same_as_options(self):
        chain = lattice.Chain(onsite="quartic", s=-1 / 6)
        found, other = lattice.strike(chain, velocity=1.5, time=100), lattice.strike(velocity=1.5, time=100, s="-1/6")
        self.assertEqual(bits(found.y), bits(other.y))
        self.assertEqual(found.quantities.keys(), other.quantities.keys())

    def test_multipliers(self):
        found = lattice.multipliers(centre="site", omega=1.1)
        table = program("sec33_floquet multipliers", "--centre=site", "--omega=1.1")
        self.assertEqual(bits(found.multiplier.real), bits(table["real"]))
        self.assertEqual(bits(found.multiplier.imag), bits(table["imag"]))
        self.assertEqual(bits(found.multiplier_error), bits(table["error"]))
        z = found.multiplier[2]
        self.assertAlmostEqual(((z + 1 / z - 2) / 4).real, found.kappa, delta=1e-15)
        self.assertAlmostEqual(found.largest_modulus, np.abs(found.multiplier).max(), delta=1e-15)

    def test_breathers_and_barriers(self):
        breather = "sec32_newton_breathers breather"
        self.check(lattice.breather, breather, "ny", centre="bond", omega=1.2, well="pendulum")
        self.check(lattice.breather, breather, "ny", omega=1.2, contact="power", alpha=1.8)
        self.check(lattice.breather, breather, "y", omega=1.3, precompression=1e-3, centre="bond")
        self.check(lattice.barrier, "sec32_barrier barrier", omega=1.4)
        found = self.check(lattice.breather, breather, "y", omega=1.3, mass_ratio=0.8)
        period = 2 * np.pi / 1.3
        run = found.chain.evolve(found.y, 0 * found.y, period, sample=period / 1000, tolerance=1e-9)
        self.assertAlmostEqual(found.area / (period * np.mean(run.v[1:] ** 2 @ found.chain.mass)), 1, delta=1e-7)
        # A chain says the same, in numbers that are not rounded alike
        chain = lattice.Chain(31, mass=np.resize([0.8, 1], 31))
        self.assertAlmostEqual(lattice.breather(chain, omega=1.3).energy, found.energy, delta=1e-14)
        self.assertAlmostEqual(lattice.multipliers(chain, omega=1.3).kappa, lattice.multipliers(omega=1.3, mass_ratio=0.8).kappa,
                               delta=1e-14)

    def test_dps(self):
        found = self.check(lattice.dps, "sec31_dps_limit impact", tau=60)
        self.assertAlmostEqual(np.sum(np.abs(found.amplitude_n) ** 2), 1, delta=1e-9)


class Refusals(unittest.TestCase):
    """The line of the program, as a ValueError, or as a RuntimeError if the computation fails."""

    def check(self, kind, function, command, **options):
        with self.assertRaises(kind) as caught:
            function(**options)
        self.assertEqual(str(caught.exception), program(command, *(f"--{n}={v}" for n, v in options.items())))

    def test_options(self):
        breather = "sec32_newton_breathers breather"
        self.check(ValueError, lattice.strike, "sec34_impact run", velocity="fast")
        self.check(ValueError, lattice.breather, breather, centre="bond", sites=31)
        self.check(ValueError, lattice.breather, breather, precompression=0.01, omega=1.2)
        self.check(RuntimeError, lattice.strike, "sec34_impact run", velocity=1.3, s=-0.7, time=100)
        with self.assertRaisesRegex(ValueError, "unknown option; did you mean --velocity"):
            lattice.strike(velocty=None)
        for value in (True, np.True_, 1j, b"1", np.ones(1)):
            with self.assertRaisesRegex(ValueError, "--velocity: .* is not a number"):
                lattice.strike(velocity=value)

    def refused(self, *cases, kind=ValueError):
        """Each call is refused in one line that has its words."""
        for words, call in cases:
            with self.assertRaisesRegex(kind, words) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))

    def test_chains(self):
        self.refused(
            ("mass must be finite and > 0", lambda: lattice.Chain(3, mass=[1, -1, 1])), ("mass", lambda: lattice.Chain(3, mass=[1, 1])),
            ("--well", lambda: lattice.Chain(well="cubic")), ("--ends", lambda: lattice.Chain(ends="open")),
            ("mass: the chain has no number of sites", lambda: lattice.Chain(mass=[1, 0.5])),
            ("symmetric about the centre", lambda: lattice.breather(lattice.Chain(31, mass=range(1, 32)), omega=1.2)),
            ("--sites: 31 does not fit --centre bond", lambda: lattice.breather(lattice.Chain(31), centre="bond")),
            ("free ends", lambda: lattice.breather(lattice.Chain(31, ends="fixed"))),
            ("--mass_ratio: belongs to the given chain", lambda: lattice.multipliers(lattice.Chain(31), mass_ratio=2)),
            ("linear waves of the chain, .1, 1.26491.", lambda: lattice.multipliers(lattice.Chain(precompression=0.01))),
            ("chain: 31 beads", lambda: lattice.barrier(lattice.Chain(31))))
        self.refused(("chain: 5 is not a lattice.Chain", lambda: lattice.breather(5)), kind=TypeError)

    def test_states_and_runs(self):
        """Lengths, types and numbers that cannot be meant, said with the name and in a few words."""
        chain, zero, v = lattice.Chain(4), np.zeros(4), np.eye(4)[0]
        for message, y in [("5 entries .allowed: 4", range(5)), ("None", None), ("not an array of real", zero + 1j),
                           ("not an array of real", np.ma.masked_equal([0, 1, 2, 3], 1)), ("nan in entry 1", [0, math.nan, 0, 0])]:
            for call in (chain.accelerations, lambda y: chain.energy_density(y, zero), lambda y: chain.evolve(y, zero, 1)):
                self.refused((f"^y.*{message}", lambda: call(y)))
        for name, value in [("time", -1), ("time", "20"), ("time", True), ("sample", 0), ("tolerance", 1), ("tolerance", 1e-30)]:
            self.refused((f"^{name}: ", lambda: chain.evolve(zero, v, **{"time": 1, name: value})))
        for row in (chain.mass, chain.eta):
            self.assertRaisesRegex(ValueError, "read-only", row.fill, 2)
        self.refused(("^y.*shapes", lambda: chain.energy_density([zero, zero], zero)),
                     ("no number of sites", lambda: lattice.Chain().accelerations([])),
                     ("sample: y and v would take 160 GB .allowed: 2;",
                      lambda: lattice.Chain(1000).evolve(np.zeros(1000), np.eye(1000)[0], time=1e6, sample=0.1)))
        self.refused(("the acceleration of bead 0 is -inf", lambda: chain.accelerations([1e308, -1e308, 0, 0])), kind=RuntimeError)
        for y in ((1, 2, 3, 4), np.arange(1, 5, dtype=np.float32), [Fraction(n) for n in (1, 2, 3, 4)]):
            self.assertEqual(bits(chain.accelerations(y)), bits(chain.accelerations(np.arange(1, 5))))

    def test_what_is_no_orbit(self):
        chain, rest = lattice.Chain(5, well="quartic", s=1), np.zeros(5)
        self.refused(("nothing moves", lambda: chain.orbit(rest, 5)), ("period: -5", lambda: chain.orbit(np.ones(5), -5)),
                     ("misses its start", lambda: chain.multipliers(np.eye(5)[2], rest, 5)),
                     ("cannot be followed", lambda: lattice.Chain(5, well="quartic", s=-1).multipliers(rest + 1.1, rest, 5)),
                     (r"^y: shape \(2, 5\) .allowed: 5, one per site.$", lambda: chain.multipliers(np.zeros((2, 5)), np.zeros((2, 5)), 5)),
                     (r"^y: shape \(2, 5\) .allowed: 5, one per site.$", lambda: chain.orbit(np.zeros((2, 5)), 5)),
                     ("1001 sites .allowed: at most 1000", lambda: lattice.Chain(1001).orbit(np.zeros(1001), 5)),
                     ("no number of sites", lambda: lattice.Chain().orbit([1], 5)), kind=(ValueError, RuntimeError))

    def test_potentials_that_are_none(self):
        """They used to give wrong multipliers, or a drift, without a word."""
        energy, force = lambda y: y * y / 2, lambda y: -y
        self.refused(
            ("force", lambda: lattice.Well(energy, lambda y: -1.01 * y, np.ones_like)), ("stiffness", lambda: lattice.Well(energy, force, lambda y: 2)),
            (r"force returns (\d+) numbers for \d+ .allowed: the same number, or one", lambda: lattice.Well(energy, lambda y: -y[1:], np.ones_like)),
            ("energy does not return real numbers", lambda: lattice.Well(lambda y: y * y / 2 + 0j, force, np.ones_like)),
            ("rim is nan", lambda: lattice.Well(energy, force, np.ones_like, math.nan)),
            ("exponent", lambda: lattice.Contact(overlap_energy, overlap_force, overlap_stiffness, exponent=math.inf)),
            ("--s: a Well of your own does not have it", lambda: lattice.breather(well=lattice.Well(energy, force, np.ones_like), s=0.1)),
            (r"wells with W''\(0\) = 1", lambda: lattice.breather(well=lattice.Well(lambda y: y * y, lambda y: -2 * y, lambda y: 2 * np.ones_like(y)))))
        self.refused(("stiffness: 1 is not a function", lambda: lattice.Well(energy, force, 1)), kind=TypeError)
        one = lattice.Chain(3, well=lattice.Well(energy, force, lambda y: 1.0))  # a number stands for a row of it
        self.assertEqual(list(one.accelerations([1, 1, 1])), [-1, -1, -1])


# What nobody can mean, or hardly
ODD = [math.nan, math.inf, -math.inf, 0, -0.0, -1, 1e-3, 5e-324, -1e-9, 1e20, 1e308, -1e308, 2**31, 2**63, 2**64, 10**400,
       -(10**5000), Fraction(1, 3), Fraction(10**400), np.int8(3), np.longdouble("1e4000"), None, True, np.True_, "", "x", "1/0",
       "nan", "1\n2", "\0", "\udcff", "é", "9" * 5000, b"1", 1j, [1], [[1, 2], [3]], [], {}, object(), np.ones(100000),
       np.array(None), np.array([None, 1], object), np.array(["a"]), ..., np.datetime64("2020-01-01"), type, np.array(2.0),
       (n for n in range(3)), np.ma.masked, memoryview(b"1"), [0, 1e300, math.nan, 1e-310], np.ones((3, 4), np.float32)]


class Whatever(unittest.TestCase):
    def test_it_is_answered_with_what_is_known_or_refused_in_one_line(self):
        """Random calls in which arguments are odd: `tests.py BIN Whatever`, with COUNT and SEED in the environment."""
        count, chance = int(os.environ.get("COUNT", "400")), random.Random(os.environ.get("SEED", "1"))
        chain, v = lattice.Chain(4), np.eye(4)[0]
        calls = [(chain.evolve, {"y": 0 * v, "v": v, "time": 3, "sample": 1, "tolerance": 1e-3}), (chain.accelerations, {"y": v}),
                 (chain.energy_density, {"y": v, "v": v}), (lattice.Chain, {"sites": 4, "mass": 1, "eta": 1}),
                 (lattice.Well, {"energy": lambda y: y * y / 2, "force": lambda y: -y, "stiffness": np.ones_like, "rim": 2.0})]
        calls += [(getattr(lattice, name), dict.fromkeys((o[0].replace("-", "_") for o in options if not o[1]))) for name, options
                  in lattice._lattice.options.items() if name != "Chain"]
        kinds = set()
        for _ in range(count):
            function, right = chance.choice(calls)
            odd = {name: chance.choice(ODD) for name in right if chance.random() < 1 / len(right)} or {chance.choice(list(right)): chance.choice(ODD)}
            given = {name: value for name, value in right.items() if value is not None} | odd
            with self.subTest(function.__name__, given=lattice._short(odd)), warnings.catch_warnings():
                warnings.filterwarnings("error", "(?!.*(expm1|longdouble|encountered))")
                try:
                    found = function(**given)
                except (ValueError, TypeError, RuntimeError) as error:
                    kinds.add(type(error))
                    self.assertTrue(str(error).isprintable() and 5 <= len(str(error)) <= 400, str(error)[:1000])
                    self.assertNotRegex(str(error), "std::|bad |incompatible|variant|vector|stod")
                else:
                    kinds.add(True)
                    if function == chain.evolve:
                        self.assertAlmostEqual(found.t[-1], float(given["time"]), delta=1e-12 * abs(found.t[-1]))
                    for name, value in getattr(found, "quantities", {}).items():
                        self.assertTrue(value.error >= 0 if math.isfinite(value) else math.isnan(value) and value.reason, name)
                    self.assertRegex(repr(found), r"\A[ -~\n]{1,4000}\Z")
        self.assertLessEqual({True, ValueError}, kinds)


class OwnChains(unittest.TestCase):
    def test_a_struck_chain_keeps_its_length(self):
        """As a run of the chain itself, with the far end in it."""
        for n, mass, eta, ends in [(12, [1, 1.5], 1, "free"), (9, np.linspace(1, 0.5, 9), np.linspace(0.5, 2, 10), "fixed")]:
            chain = lattice.Chain(n, mass, eta, ends=ends)
            found = lattice.strike(chain, velocity=1.5, time=40, tolerance=1e-7)
            self.assertEqual((len(found.y), found.chain.mass.tolist()), (n, chain.mass.tolist()))
            run = chain.evolve(np.zeros(n), 1.5 * np.eye(n)[0], 40, tolerance=1e-9)
            np.testing.assert_allclose([found.y, found.v], [run.y[-1], run.v[-1]], rtol=0, atol=1e-6)
            self.assertEqual(found.far_end_moved, 1)
        self.assertEqual(lattice.strike(lattice.Chain(60), velocity=1, time=20).far_end_moved, 0)
        chain = lattice.Chain(17, mass=[1.2, 1])  # shorter than breathers usually are
        self.assertEqual(len(lattice.multipliers(chain, omega=1.3).multiplier), 34)

    def test_a_dimer_keeps_its_energy(self):
        chain, v = lattice.Chain(sites=40, mass=[1, 3]), np.eye(40)[0]
        run = chain.evolve(0 * v, v, time=20, sample=0.5, tolerance=1e-8)
        self.assertLess(run.energy_drift, 1e-8)
        e = chain.energy_density(run.y, run.v)
        self.assertTrue(e.shape == run.y.shape == (len(run.t), 40))
        np.testing.assert_allclose(e.sum(axis=1), 0.5, rtol=0, atol=1e-8)
        self.assertEqual(bits(e[7]), bits(chain.energy_density(run.y[7], run.v[7])))
        self.assertEqual(bits(chain.accelerations(run.y)[7]), bits(chain.accelerations(run.y[7])))

    def test_any_orbit_of_any_chain(self):
        """Values of a program of its own: extrapolated midpoint rule with 64 bits and step control, no event location."""
        uneven = lattice.Chain(6, [1, 2.5], 1 + 0.25 * np.arange(7), well="quartic", s=-0.3, ends="fixed")
        ring = lattice.Chain(5, contact="power", alpha=2.2, well="pendulum", ends="periodic")
        smooth = lattice.Chain(2, [1, 1.5], ends="fixed",
                               well=lattice.Well(lambda y: 2 * np.sinh(y / 2) ** 2, lambda y: -np.sinh(y), np.cosh),
                               contact=lattice.Contact(lambda r: (np.expm1(-2 * r) + 2 * r) / 2, lambda r: np.expm1(-2 * r),
                                                       lambda r: 2 * np.exp(-2 * r), opening=50))
        cases = [(uneven, [0, 0.05, -0.1, 0.02, 0, 0], 1.15, [-0.00223955351575268, -0.000216858915964582, -0.0512510239993128,
                                                               0.00422081885777325, 0.0272110633167490, 8.22835549323168e-06], 1),
                 (ring, [0.3, -0.2, 0.05, 0.1, -0.25], 1.02, [-0.058111980459978, -0.126285459711585, 0, 0.126285459711585,
                                                             0.058111980459978], 1.036530678258063),
                 (smooth, [0.5, -0.3], 2.55, [0.440402677840540, -0.168730841153150], 1)]
        for chain, guess, omega, y, modulus in cases:
            period = 2 * np.pi / omega
            found = chain.orbit(guess, period)
            np.testing.assert_allclose(found.y, y, atol=5e-14)
            self.assertTrue((found.y_error < 1e-12).all())
            run = chain.evolve(found.y, 0 * found.y, period, sample=period / 5, tolerance=1e-9)
            np.testing.assert_allclose(run.y[-1], found.y, atol=1e-8)
            at_rest = chain.multipliers(found.y, 0 * found.y, period)
            moving = at_rest if chain is smooth else chain.multipliers(run.y[1], run.v[1], period)  # slow in Python
            for all_of_them in (at_rest, moving):
                self.assertLess(abs(all_of_them.largest_modulus - modulus), all_of_them.largest_modulus.error + 5e-14)
                size = np.sort(np.abs(all_of_them.multiplier))
                np.testing.assert_allclose(size * size[::-1], 1, atol=1e-9)
            np.testing.assert_allclose(np.sort(at_rest.multiplier.real), np.sort(moving.multiplier.real), atol=1e-9)

    def test_a_pattern_is_repeated(self):
        self.assertEqual(bits(lattice.Chain(5, mass=(1, 0.5)).mass), bits([1, 0.5, 1, 0.5, 1]))
        self.assertEqual(bits(lattice.Chain(6, eta=[1, 3], ends="periodic").eta), bits([1, 3, 1, 3, 1, 3, 1]))
        for message, options in [("eta: a pattern of length 2 does not close on a ring of 5 sites", {"sites": 5, "eta": [1, 3], "ends": "periodic"}),
                                 ("mass: .*allowed: 4, or a pattern that fits at least twice", {"sites": 4, "mass": [1, 2, 3]})]:
            with self.assertRaisesRegex(ValueError, message):
                lattice.Chain(**options)

    def test_a_run_that_ends_before_its_time(self):
        """In a soft well the solution itself ends. It used to be a run of 44 units with the error zero."""
        soft, v = lattice.Chain(sites=60, well="quartic", s="-1/6"), np.eye(60)[0]
        with self.assertRaisesRegex(RuntimeError, r"a bead runs away at t = 44\.4"):
            soft.evolve(0 * v, 2.12 * v, 100)
        with self.assertRaises(ValueError):
            soft.evolve(0 * v, 1e300 * v, 100)
        well = lattice.Well(lambda y: y * y / 2, lambda y: np.where(abs(y) < 1.2, -y, math.nan), np.ones_like)
        with self.assertRaisesRegex(RuntimeError, "no step is short enough"):
            lattice.Chain(4, well=well).evolve(np.zeros(4), 3e4 * np.eye(4)[0], 10)  # soon: slow in Python

    def test_what_is_taken_along(self):
        """A chain, and a result with its chain, goes to another process and moves there to the same bits."""
        contact = lattice.Contact(overlap_energy, overlap_force, functools.partial(overlap_stiffness))
        for chain in (lattice.Chain(), lattice.Chain(12, mass=[1, 1.1], eta=range(13), ends="fixed"),
                      lattice.Chain(12, well="quartic", s="-1/6", contact="power", alpha=1.75, precompression=0.3),
                      lattice.Chain(12, well=lattice.Well(cosh_energy, cosh_force, np.cosh, rim=9), contact=contact)):
            again = pickle.loads(pickle.dumps(chain))
            self.assertEqual(repr(again), repr(chain))
            if chain.sites:
                y = np.random.default_rng(1).normal(size=12)
                self.assertEqual(bits(again.accelerations(y)), bits(chain.accelerations(y)))
        with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
            there = pool.submit(lattice.strike, chain, velocity=1, time=20).result()
        here = lattice.strike(chain, velocity=1, time=20)
        self.assertEqual((repr(there), repr(there.chain), bits(there.y)), (repr(here), repr(here.chain), bits(here.y)))
        self.assertEqual(there.speed.reason, here.speed.reason)

    def test_what_python_raises_arrives(self):
        def broken(y):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            late = lattice.Well(lambda y: y * y / 2, lambda y: broken(y) if abs(y).max() > 1.5 else -y, np.ones_like)
            lattice.Chain(4, well=late).accelerations([2, 0, 0, 0])

    def test_digits_that_are_lost(self):
        with self.assertWarnsRegex(UserWarning, "expm1"):
            lattice.Well(lambda y: np.exp(-y) - 1 + y, lambda y: np.exp(-y) - 1, lambda y: np.exp(-y))
        with self.assertWarnsRegex(UserWarning, "^force of the well: not longdouble"):
            lattice.Well(lambda y: y * y / 2, lambda y: (-y).astype(float), np.ones_like)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            lattice.Well(lambda y: np.expm1(-y) + y, lambda y: np.expm1(-y), lambda y: np.exp(-y))
            lattice.Well(cosh_energy, cosh_force, np.cosh)
            lattice.Contact(lambda r: r * r / 2, lambda r: -r, np.ones_like, opening=10, exponent=1)
        with self.assertWarnsRegex(UserWarning, "the contact loses digits"):
            lattice.Contact(lambda r: np.maximum(1 - r, 0)**3 / 3 + r - 1 / 3, lambda r: np.maximum(1 - r, 0)**2 - 1,
                            lambda r: 2 * np.maximum(1 - r, 0), opening=1, exponent=2)


class AnotherRoute(unittest.TestCase):
    """True values of programs of their own: Taylor series with 113 bits that stop where a contact opens or closes, Newton's
    method with them, or a formula. Most of them were once refused, or wrong."""

    def evolves(self, chain, y, v, duration, end, **options):
        """A final state (positions, velocities) has the error it states, relative to its largest entry."""
        run = chain.evolve(y, v, duration, **options)
        found = np.array([run.y[-1], run.v[-1]])
        self.assertLessEqual(np.abs(found - end).max(), run.error * np.abs(end).max())
        self.assertLess(run.error, options.get("tolerance", 1e-4))
        return found

    def test_compressed_contacts_that_hardly_move(self):
        three, end = lattice.Chain(3, precompression=0.5), np.array([
            [2.914830527933692502e-14, 3.267495384497144556e-14, -3.345704057798574327e-14],
            [4.491615460798708356e-16, -1.694333262320170166e-14, 1.123865985434356806e-13]])
        small, larger = (self.evolves(three, [size, 0, 0], [0] * 3, 5, size / 1e-13 * end) for size in (1e-13, 1e-12))
        np.testing.assert_allclose(larger, 10 * small, rtol=1e-9)
        duration, other = 0.6448704513403603, 1.394748019862705
        self.evolves(lattice.Chain(5, precompression=0.5), [-3.1739525144780505e-08, -4.929035307401593e-08, 0, 0, 0],
                     [0, 4.142084664035903e-08, 1.1231597435988461e-08, 0, 0], duration,
                     [[-2.657767486575533395e-8, -5.29448931667203458e-9, -1.394361975457283417e-9, 1.525607695762023526e-10,
                       5.814358700215546058e-12], [2.004942009831911729e-8, 8.030239791257681427e-8, -9.817524576348616158e-9,
                                                   2.145373004897657813e-10, 3.64729587135517505e-11]],
                     sample=duration / 4, tolerance=9.76022510193086e-11)
        # Contacts so stiff that halving the step does not yet gain what it does for short ones: 6.4e-13 where 6.0e-13 is stated
        found = self.evolves(lattice.Chain(2, [16.78900451414646, 1.3750096782857841], [1e8, 1, 1e8], well="pendulum", ends="fixed"),
                             [-6.152283002576166e-10, -6.972319848180651e-08], [0, 0], other,
                             [[8.292768061611281044e-9, -2.593936580982951765e-8], [6.375521967993526529e-9, 5.51989913186533082e-8]],
                             sample=other / 4, tolerance=2.699448762175587e-11)
        self.assertAlmostEqual(found[0, 0], 8.292768061611e-9, delta=2.7e-11 * 5.52e-8)
        # Other exponents, amplitudes, ends, masses and stiffnesses
        self.evolves(lattice.Chain(2, contact="power", alpha=3.61690045489219, precompression=1.3999280251523296, ends="fixed"),
                     [0, -3.023534778931801e-13], [8.921433263927807e-12, -5.23061543367038e-12], 4.764460711368227,
                     [[2.905449796438340795e-13, 7.989746388460682668e-13], [6.133839021295339159e-12, -7.85690266809315714e-12]],
                     tolerance=1.6861893798886952e-11)
        self.evolves(lattice.Chain(4, well="quartic", s=0.006417106986208676, contact="power", alpha=3.1233576337262665,
                                   precompression=1.7618505571079228,
                                   mass=[0.6244048831414221, 1.94549746328385, 1.92639861889103, 2.6824459171072017],
                                   eta=[1.6002840667744704, 4.374136499682119, 1.7546078798655456, 0.4752304296392799, 0.33482543616499183]),
                     [0, 0, -1.4101390959033286e-14, 0], [0, 1.3346010509110176e-14, 0, 0], 3.9063487167874027,
                     [[-1.502018415506403874e-15, 1.170878049508644523e-15, 9.265617093907825082e-15, 5.291128622315630819e-15],
                      [3.78454380868634023e-14, 1.82076704460107557e-14, -3.065587853656918243e-14, -5.789412778165412999e-15]],
                     tolerance=2.2830177336543124e-08)

    def test_steep_contacts_of_light_beads(self):
        """Hundreds of collisions, in which a bead turns in a small part of a period."""
        rings = [(9.92480773739799, [0.003756104156777914, 0.1393321301243357, 0.004414980895062473, 0.010365869202619548,
                                     0.0010333815775004898],
                  [-2.189024276129052e-05, 2.6245818922045715e-05, 2.353142113441385e-05, -2.694581836186353e-05, -1.8261851561904505e-05],
                  [-2.7638183832412866e-05, 2.6239612987880498e-05, 0, 3.363506256035733e-06, 0], 16.367454237372595, 2.552446106197122e-10,
                  [[2.192773085266105048e-5, 2.470568261855459069e-5, 6.62406376155332812e-6, 2.295147539360339189e-5,
                    -1.783007608048696829e-5], [1.807043143072923714e-5, 3.537965759791075655e-5, -3.398260050956732643e-4,
                                                -1.387030592798939755e-4, 1.22801499548179453e-4]]),
                 (9.41923422485479, [0.0012864211256129238, 0.0016195263627529703, 0.005397295649061301, 0.49808262687167787, 0.007958486326179093],
                  [0.0003417762630881209, 6.338321060852637e-05, 1.0692992517459323e-07, -0.0004987206159063611, 0.00028546645603500154],
                  [0, 0, -0.00017427292178562724, 0, -0.0004357864192069316], 16.11642128883237, 1.9855066606471964e-12,
                  [[-3.402588350651605281e-4, -4.990049786405318888e-6, 6.672467301614191446e-6, 3.311134636018792961e-4,
                    4.310621460364598669e-5], [8.969450357079110074e-4, 1.570110168045184958e-3, -1.487422508022060734e-4,
                                               -5.284345562696431456e-4, 3.193110117705337405e-3]])]
        for alpha, mass, y, v, duration, tolerance, end in rings:
            self.evolves(lattice.Chain(5, mass, ends="periodic", contact="power", alpha=alpha), y, v, duration, end, tolerance=tolerance)
        chance = random.Random(12)
        mass, eta = ([chance.uniform(0.2, 2) for _ in range(count)] for count in (12, 13))
        y, v = ([chance.uniform(-9e-7, 9e-7) for _ in range(12)] for _ in "yv")
        self.evolves(lattice.Chain(12, mass, eta, well="quartic", s=2.89, contact="power", alpha=2.5, ends="fixed"), y, v, 20,
                     [[1.159488258297711968e-7, 6.656008043365366772e-7, -3.57841706269351229e-7, -9.947980555988933324e-8,
                       2.822874662764804449e-7, 6.655778600452855876e-7, -2.990024084084943863e-8, 5.989213171009378956e-7,
                       1.019173101403781701e-6, -3.470697843125886738e-7, -1.032755179815809249e-6, -1.07101267204521118e-6],
                      [-1.08111011696648996e-6, 1.737804746275280199e-7, -7.86590730105467744e-7, 1.301521218078565252e-6,
                       1.61347181719227031e-6, 2.819857962053059148e-7, -1.673892714972458978e-7, 2.950252897529814587e-7,
                       2.707659815058081143e-7, 3.306239609706827925e-7, 3.565906299874020286e-7, 1.799259613416429289e-8]], tolerance=3e-11)

    def test_breathers_near_the_frequency_of_the_wells(self):
        for centre, omega, alpha, amplitude in [
                ("site", 1.01, 3, 0.08744770302678816879), ("bond", 1.003, 3, 0.040907607931452184724), ("bond", 1.001, 2.5, 0.0077725859206916417),
                ("bond", 1.0001, 2.5, 0.0016739364893801590), ("bond", 1.0003, 2.5, 0.0034822133207912221),
                ("bond", 1.0001879, 2.7467, 0.0055991032116657985132), ("site", 1.0035344, 2.2442, 0.0097840324089401606922)]:
            found = lattice.breather(centre=centre, omega=omega, contact="power", alpha=alpha)
            self.assertAlmostEqual(found.amplitude, amplitude, delta=found.amplitude.error)
            k = np.abs(found.y).argmax()
            self.assertAlmostEqual(abs(found.y[k]), amplitude, delta=found.y_error[k])
            self.assertTrue((found.y_error >= 0).all() and (found.y_error < 1e-11 * amplitude).all())

    def test_a_profile_of_the_dps_equation_has_errors(self):
        """By the Runge-Kutta method with 60000 steps and 64 bits."""
        found = lattice.dps(tau=5, sites=12, end="fixed")
        true = [0.062380922824305987 + 0.134912173809837096j, 0.623610390923929461 + 0.011051498131245378j,
                -0.097630091949056623 - 0.702341641121089685j, -0.262890387571219563 + 0.124669570997991393j]
        self.assertTrue((np.abs(found.amplitude_n[:4] - true) <= found.amplitude_error[:4]).all())
        self.assertTrue((found.amplitude_error > 0).all() and (found.amplitude_error < 1e-9).all())
        with self.assertRaisesRegex(RuntimeError, "too erratic"):
            lattice.dps(tau=1000, sites=5, end="fixed", alpha=3)

    def orbits(self, chain, guess, period, amplitude, energy, repeats=1, within=None):
        """An orbit with this half range and energy, to its errors or to `within`."""
        found = chain.orbit(guess, period)
        self.assertAlmostEqual(found.amplitude, amplitude, delta=within or found.amplitude.error)
        self.assertAlmostEqual(found.energy, energy, delta=within or found.energy.error)
        self.assertEqual((found.repeats, found.repeats.exact), (repeats, True))
        return found

    def test_periods_of_which_an_orbit_repeats_itself(self):
        uneven = lattice.Chain(6, [1, 2.5], 1 + 0.25 * np.arange(7), well="quartic", s=-0.3, ends="fixed")
        ring = lattice.Chain(5, contact="power", alpha=2.2, well="pendulum", ends="periodic")
        for chain, guess, period in [(uneven, [0, 0.05, -0.1, 0.02, 0, 0], 2 * np.pi / 1.15), (ring, [0.3, -0.2, 0.05, 0.1, -0.25], 2 * np.pi / 1.02)]:
            one = chain.orbit(guess, period)
            self.assertEqual((one.repeats, one.repeats.exact), (1, True))
            for times in (2, 3, 4):
                many = self.orbits(chain, one.y, times * period, one.amplitude, one.energy, times, within=1e-12)
                np.testing.assert_allclose(many.y, one.y, rtol=0, atol=1e-12)

    def test_a_chain_without_wells_stays_where_the_guess_is(self):
        """On a ring of two halves that move in opposite directions, a bead is alone in a potential: a quadrature has its period."""
        theta = (np.arange(64) + 0.5) * np.pi / 64
        for sites, d, alpha, mean, a in [(6, 0.5, 1.5, 0.001 / 6, 0.1), (4, 0.794, 1.5, 0.221148, 0.06391928202826868522),
                                         (4, 0.492, 3.236, 0.01, 0.017540659671119712587)]:
            U = lambda x: ((d + 2 * x) ** (alpha + 1) + (d - 2 * x) ** (alpha + 1) - 2 * d ** (alpha + 1)) / 2 / (alpha + 1)
            period = 4 * np.mean(a * np.cos(theta / 2) / np.sqrt(2 * (U(a) - U(a * np.sin(theta / 2))))) * np.pi / 2
            chain, sign = lattice.Chain(sites, well="none", ends="periodic", contact="power", alpha=alpha, precompression=d), np.resize([1, -1], sites)
            guess = mean + 1.002 * a * sign
            found = self.orbits(chain, guess, period, a, sites * U(a), within=1e-11)
            np.testing.assert_allclose(found.y - mean, a * sign, rtol=0, atol=1e-11)
            self.assertAlmostEqual(found.y.mean(), guess.mean(), delta=1e-12)
        guess = [0.101, -0.1, 0.1, -0.1, 0.1, -0.1]
        found = lattice.Chain(6, well="none", ends="periodic", precompression=0.5).orbit(guess, 3.0582943064629133)
        self.assertAlmostEqual(found.amplitude, 0.1, delta=1e-10)
        self.assertAlmostEqual(found.y.mean(), np.mean(guess), delta=1e-12)

    def test_multipliers_of_a_chain_without_wells(self):
        """Of a shift, of a drift, and of the time: all are one, and stable are the others."""
        three, four = (lattice.Chain(3, well="none", precompression=0.5), lattice.Chain(4, well="none", ends="periodic", precompression=0.794))
        middle, a = 0.221148, 0.06391928202826868522
        for chain, y, period, shift in [(three, np.array([0.3, 0, -0.3]), 6.21682, 0.2), (four, middle + a * np.array([1, -1, 1, -1]), 2.718478, 3.7)]:
            for where, v in [(y, 0), (y, 1e-30), (y + shift, 0)]:
                found = chain.multipliers(where, np.full(len(y), v), period)
                self.assertAlmostEqual(found.largest_modulus, 1, delta=found.largest_modulus.error)
                self.assertLess(found.largest_modulus.error, 1e-6)
                self.assertTrue((np.abs(found.multiplier[:4] - 1) <= found.multiplier_error[:4] + 1e-15).all())

    def test_what_is_at_rest_is_no_orbit(self):
        ring, nothing = lattice.Chain(4, well="none", ends="periodic", precompression=0.5), "nothing moves"
        with self.assertRaisesRegex(RuntimeError, "rest"):
            ring.orbit([0.05, -0.05, 0.05, -0.05], 5)  # shorter than any period
        for call in (lambda: ring.orbit([0.05] * 4, 5), lambda: ring.multipliers([0.01] * 4, [0] * 4, 5),
                     lambda: lattice.Chain(3, well="pendulum").multipliers([0, 0, 2 * np.pi], [0, 0, 0], 7),
                     lambda: lattice.Chain(3, well="quartic", s=-1).orbit([0, 0, 1], 6)):
            with self.assertRaisesRegex(ValueError, nothing):
                call()

    def test_orbits_about_another_minimum(self):
        """A well with minima at 0 and 4 is symmetric about 2: u = y - 2 swings between sqrt(4 - h) and sqrt(4 + h) with the energy h^2/32
        and the period 4 pi over the arithmetic-geometric mean of the two."""
        well = lattice.Well(lambda y: y * y * (y - 4) ** 2 / 32, lambda y: -y * (y - 4) * (y - 2) / 8, lambda y: (3 * y * y - 12 * y + 8) / 8)
        h, two = 0.05, lattice.Chain(2, well=well)
        high, low = math.sqrt(4 + h), math.sqrt(4 - h)
        mean, other = high, low
        for _ in range(6):
            mean, other = (mean + other) / 2, math.sqrt(mean * other)
        period = 4 * math.pi / mean
        about_four, about_zero = (self.orbits(two, [start] * 2, period, (high - low) / 2, 2 * h * h / 32, within=1e-11)
                                  for start in (2 + high, 2 - high))
        self.assertAlmostEqual(about_four.energy, about_zero.energy, delta=1e-9)
        np.testing.assert_allclose(about_four.y + about_zero.y, 4, rtol=0, atol=1e-11)
        # Pendulums about 2 pi, which do not move alike
        three = lattice.Chain(3, well="pendulum")
        here = three.orbit([0.5, 0.45, -0.4], 6.6)
        there = self.orbits(three, here.y + 2 * np.pi, 6.6, here.amplitude, here.energy, within=1e-12)
        np.testing.assert_allclose(there.y - 2 * np.pi, here.y, rtol=0, atol=1e-12)

    def test_strongly_unstable_orbits(self):
        """Over several periods multipliers are powers; as errors are differences of two precisions, true ones may be twice as large."""
        ring = lattice.Chain(3, well="quartic", s=-0.5, ends="periodic")
        orbit = ring.orbit([0.9, 0.8, -1], 5.7)
        self.assertAlmostEqual(orbit.energy, 2.4613368925309436366, delta=orbit.energy.error)
        once = np.array([1, 332.59538897442274627, 13.3097762406774658, 1 / 13.3097762406774658, 1 / 332.59538897442274627, 1])
        for times in (1, 2, 3):
            for v in ([0, 0, 0], [0, 0, 1e-30]):
                found = ring.multipliers(orbit.y, v, times * 5.7)
                self.assertAlmostEqual(found.largest_modulus / once[1] ** times, 1, delta=2 * found.largest_modulus.error / once[1] ** times)
                self.assertLess(found.largest_modulus.error, 1e-6 * found.largest_modulus)
                order = np.argsort(found.multiplier.real)
                error = np.abs(found.multiplier[order] - np.sort(once) ** times)
                self.assertTrue((error <= 2 * found.multiplier_error[order] + 1e-14).all(), error)

    def test_beads_that_move_alike(self):
        """A bead in such a well, from 0.7: the period is an elliptic integral. Contacts that open leave nothing to compare."""
        begin = time.monotonic()
        found = lattice.Chain(3, well="quartic", s=1).orbit([0.7, 0.7001, 0.7], 5.381111920499866)
        self.assertLess(time.monotonic() - begin, 3)
        self.assertTrue((np.abs(found.y - 0.7) <= found.y_error + 1e-13).all())
        self.assertAlmostEqual(found.energy, 3 * (0.7**2 / 2 + 0.7**4 / 4), delta=found.energy.error + 1e-13)
        k = math.sin(0.4)  # a pendulum: the period of amplitude 0.8 is 2 pi over the mean of 1 and cos 0.4
        mean, other = 1, math.cos(0.4)
        for _ in range(6):
            mean, other = (mean + other) / 2, math.sqrt(mean * other)
        ring = lattice.Chain(4, well="pendulum", ends="periodic")
        found = self.orbits(ring, [0.8, 0.8004, 0.8, 0.7999], 2 * math.pi / mean, 0.8, 8 * k * k, within=1e-12)
        self.assertTrue((np.abs(found.y - 0.8) <= found.y_error + 1e-13).all())


def cosh_energy(y):
    return 2 * np.sinh(y / 2) ** 2


def cosh_force(y):
    return -np.sinh(y)


def overlap_energy(r):
    return np.maximum(-r, 0) ** 2 * np.sqrt(np.maximum(-r, 0)) * 2 / 5


def overlap_force(r):
    return np.maximum(-r, 0) * np.sqrt(np.maximum(-r, 0))


def overlap_stiffness(r):
    return np.sqrt(np.maximum(-r, 0)) * 3 / 2


class LongWork(unittest.TestCase):
    def test_it_can_be_interrupted_and_leaves_others_alone(self):
        ticks, over = [], threading.Event()
        other = threading.Thread(target=lambda: ticks.extend(0 for _ in iter(lambda: over.wait(0.01), True)))
        other.start()
        for call in (lambda: lattice.strike(velocity=1, time=1e5, sites=3000, tolerance=1e-10), lambda: lattice.dps(tau=1e4, sites=2000),
                     lambda: lattice.Chain(3000).evolve(np.ones(3000), np.zeros(3000), 1e6, sample=1e6),
                     lambda: lattice.multipliers(omega=1.1, sites=301)):
            timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            begin = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                call()
            self.assertLess(time.monotonic() - begin, 60)
        over.set()
        other.join()
        self.assertGreater(len(ticks), 3)

    def test_an_exit_ends_what_still_computes(self):
        """Daemons in the library, or in functions of Python, while the interpreter goes."""
        for own in ("", "well=lattice.Well(lambda y: y * y / 2, lambda y: -y, np.ones_like)"):
            code = f"""if True:
                import lattice, numpy as np, threading, time
                def evolve():
                    while True:
                        lattice.Chain(20, {own}).evolve(np.zeros(20), np.eye(20)[0], 20)
                def strike():
                    while True:
                        lattice.strike(lattice.Chain(20, {own}), velocity=1, time=20)
                for work in (evolve, strike):
                    threading.Thread(target=work, daemon=True).start()
                time.sleep(0.3)"""
            run = python(code)
            self.assertEqual((run.returncode, run.stderr), (0, ""))


class Documentation(unittest.TestCase):
    def test_everything_is_described(self):
        for name in lattice.__all__:
            self.assertTrue(text := inspect.getdoc(getattr(lattice, name)), name)
            self.assertNotIn("OPTIONS", text)
        for name, options in lattice._lattice.options.items():
            target = getattr(lattice, name)
            for option in {option.replace("-", "_") for option, *_ in options} - {"profile"}:
                self.assertIn(f"{option}:", target.__doc__, name)
                self.assertIn(option, inspect.signature(target).parameters)
        self.assertIn("Eq. (26)", lattice.strike.__doc__)
        self.assertEqual(python("import lattice; print(lattice.strike.__doc__)", {"PYTHONOPTIMIZE": "2"}).stdout, "None\n")
        self.assertEqual(inspect.signature(lattice.breather).parameters["omega"].default, 1.1)

    def test_a_wheel_has_all_that_an_import_needs_and_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            name = backend.pack(Path(lattice.__file__).parent, folder)
            self.assertRegex(name, r"^breathers_lattice-[0-9.]+-cp3\d+-cp3\d+-\w+\.whl$")
            with zipfile.ZipFile(Path(folder) / name) as wheel:
                wheel.extractall(folder)
                listed = [row[0] for row in csv.reader(wheel.read(f"{'-'.join(name.split('-')[:2])}.dist-info/RECORD").decode().splitlines())]
                self.assertEqual(sorted(wheel.namelist()), sorted(listed))
                self.assertIn("lattice/__init__.py", listed)
            run = python("import lattice; print(lattice.__file__, lattice.Chain(3).sites)", {"PYTHONPATH": folder}, cwd=folder)
            self.assertEqual(run.stdout, f"{Path(folder) / 'lattice/__init__.py'} 3\n", run.stderr)

    def test_a_number_shows_what_is_known(self):
        self.assertEqual([str(lattice.Estimate(*of)) for of in ((0.361294, 2e-5, "site"), (4, 0, "", True), (math.nan, math.nan))],
                         ["0.36129 +- 2e-05 site", "4", "nan"])
        copy = pickle.loads(pickle.dumps(lattice.Estimate(1.5, 0.1, "site", reason="none")))
        self.assertEqual((copy, copy.error, copy.unit, copy.reason), (1.5, 0.1, "site", "none"))


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "there is no matplotlib")
class Notebooks(unittest.TestCase):
    def test_they_say_what_they_hold(self):
        paths = sorted(HERE.glob("*.ipynb"))
        self.assertGreaterEqual(len(paths), 3)
        for path in paths:
            self.assertEqual(notebooks.run(path), [])


if __name__ == "__main__":
    unittest.main()
