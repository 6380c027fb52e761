"""Tests of the Python module. Argument: the folder of the programs, whose numbers and complaints are the measure."""

import concurrent.futures
import csv
import doctest
import functools
import inspect
import math
import multiprocessing
import os
import pickle
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

    def test_a_chain_says_the_same_as_options(self):
        chain = lattice.Chain(well="quartic", s=-1 / 6)
        found, other = lattice.strike(chain, velocity=1.5, time=100), lattice.strike(velocity=1.5, time=100, s="-1/6")
        self.assertEqual(bits(found.y), bits(other.y))

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
        ring = lattice.Chain(4, well="none", ends="periodic", precompression=0.5)
        self.refused(("nothing moves", lambda: chain.orbit(rest, 5)), ("nothing moves", lambda: ring.multipliers([0.01] * 4, 5)),
                     ("rest", lambda: ring.orbit([0.05, -0.05, 0.05, -0.05], 5)),  # shorter than any period
                     ("period: -5", lambda: chain.orbit(np.ones(5), -5)),
                     ("no periodic orbit; the nearest one", lambda: chain.multipliers(np.ones(5), 5)),
                     (r"^y: shape \(2, 5\) .allowed: 5, one per site.$", lambda: chain.multipliers(np.zeros((2, 5)), 5)),
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
                 (smooth, [0.45, -0.17], 2.55, [0.440402677840540, -0.168730841153150], 1)]
        for chain, guess, omega, y, modulus in cases:
            period = 2 * np.pi / omega
            y = np.array(y)
            if chain is not smooth:  # slow in Python
                found = chain.orbit(guess, period)
                np.testing.assert_allclose(found.y, y, atol=5e-14)
                self.assertTrue((found.y_error < 1e-12).all())
                self.assertEqual((found.repeats, chain.orbit(found.y, 4 * period).repeats), (1, 4))
            run = chain.evolve(y, 0 * y, period, sample=period / 5, tolerance=1e-9)
            np.testing.assert_allclose(run.y[-1], y, atol=1e-8)
            all_of_them = chain.multipliers(y, period)
            self.assertLess(abs(all_of_them.largest_modulus - modulus), all_of_them.largest_modulus.error + 5e-14)
            size = np.sort(np.abs(all_of_them.multiplier))
            np.testing.assert_allclose(size * size[::-1], 1, atol=1e-9)

    def test_a_pattern_is_repeated(self):
        self.assertEqual(bits(lattice.Chain(5, mass=(1, 0.5)).mass), bits([1, 0.5, 1, 0.5, 1]))
        self.assertEqual(bits(lattice.Chain(6, eta=[1, 3], ends="periodic").eta), bits([1, 3, 1, 3, 1, 3, 1]))
        for message, options in [("eta: a pattern of length 2 does not close on a ring of 5 sites", {"sites": 5, "eta": [1, 3], "ends": "periodic"}),
                                 ("mass: .*allowed: 4, or a pattern that fits at least twice", {"sites": 4, "mass": [1, 2, 3]})]:
            with self.assertRaisesRegex(ValueError, message):
                lattice.Chain(**options)

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
    """True values, of programs of their own or of a formula."""

    def test_a_run_has_the_error_that_it_states(self):
        """Contacts so stiff that halving the step does not yet gain what it does for short ones; half the stated error is too small."""
        chain = lattice.Chain(2, [16.78900451414646, 1.3750096782857841], [1e8, 1, 1e8], well="pendulum", ends="fixed")
        end = [[8.292768061611281044e-9, -2.593936580982951765e-8], [6.375521967993526529e-9, 5.51989913186533082e-8]]
        run = chain.evolve([-6.152283002576166e-10, -6.972319848180651e-08], [0, 0], 1.394748019862705,
                           sample=1.394748019862705 / 4, tolerance=2.699448762175587e-11)
        self.assertLessEqual(np.abs([run.y[-1] - end[0], run.v[-1] - end[1]]).max(), run.error * np.abs(end).max())
        self.assertLess(run.error, 2.7e-11)

    def test_a_profile_of_the_dps_equation_has_errors(self):
        """By the Runge-Kutta method with 60000 steps and 64 bits."""
        found = lattice.dps(tau=5, sites=12, end="fixed")
        true = [0.062380922824305987 + 0.134912173809837096j, 0.623610390923929461 + 0.011051498131245378j,
                -0.097630091949056623 - 0.702341641121089685j, -0.262890387571219563 + 0.124669570997991393j]
        self.assertTrue((np.abs(found.amplitude_n[:4] - true) <= found.amplitude_error[:4]).all())
        self.assertTrue((found.amplitude_error > 0).all() and (found.amplitude_error < 1e-9).all())
        with self.assertRaisesRegex(RuntimeError, "too erratic"):
            lattice.dps(tau=1000, sites=5, end="fixed", alpha=3)

    def orbits(self, chain, guess, period, amplitude, energy, within):
        """An orbit with this half range and energy."""
        found = chain.orbit(guess, period)
        self.assertAlmostEqual(found.amplitude, amplitude, delta=within)
        self.assertAlmostEqual(found.energy, energy, delta=within)
        return found

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

    def test_multipliers_of_a_chain_without_wells(self):
        """Of a shift, of a drift, and of the time: all are one, and stable are the others."""
        three, four = (lattice.Chain(3, well="none", precompression=0.5), lattice.Chain(4, well="none", ends="periodic", precompression=0.794))
        middle, a = 0.221148, 0.06391928202826868522
        for chain, y, period, shift in [(three, np.array([0.3, 0, -0.3]), 6.21682, 0.2), (four, middle + a * np.array([1, -1, 1, -1]), 2.718478, 3.7)]:
            for where in (y, y + shift):
                found = chain.multipliers(where, period)
                self.assertAlmostEqual(found.largest_modulus, 1, delta=found.largest_modulus.error)
                self.assertLess(found.largest_modulus.error, 1e-6)
                self.assertTrue((np.abs(found.multiplier[:4] - 1) <= found.multiplier_error[:4] + 1e-15).all())

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
            found = ring.multipliers(orbit.y, times * 5.7)
            self.assertAlmostEqual(found.largest_modulus / once[1] ** times, 1, delta=2 * found.largest_modulus.error / once[1] ** times)
            self.assertLess(found.largest_modulus.error, 1e-6 * found.largest_modulus)
            order = np.argsort(found.multiplier.real)
            error = np.abs(found.multiplier[order] - np.sort(once) ** times)
            self.assertTrue((error <= 2 * found.multiplier_error[order] + 1e-14).all(), error)


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

    def test_what_the_page_shows_comes_out(self):
        self.assertEqual(doctest.testfile(str(HERE / "own_chain.md"), module_relative=False).failed, 0)

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


if __name__ == "__main__":
    unittest.main()
