"""Tests of the Python module. Argument: the folder of the programs, whose numbers and complaints are the measure."""

import csv
import importlib.util
import inspect
import math
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import lattice
import notebooks

BIN = Path(sys.argv.pop(1))
HERE = Path(__file__).parent


def program(command, *options):
    """What a program says: its rows by column, or the line with which it refuses."""
    name, *words = command.split()
    run = subprocess.run([BIN / name, *words, *options], capture_output=True, text=True)
    if run.returncode:
        return run.stderr.strip().removeprefix(name + ": ")
    rows = list(csv.reader(line for line in run.stdout.splitlines() if not line.startswith("#")))
    return {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])}


def bits(x):
    return np.asarray(x, float).tobytes()


class SameBits(unittest.TestCase):
    """Numbers are those of the programs to the last bit, and so are errors, units and profiles."""

    def check(self, function, command, profile=(), **options):
        words = [f"--{name}={value}" for name, value in options.items()]
        found = function(**options)
        table = program(command, *words)
        self.assertEqual(list(found.quantities), table["quantity"])
        got = list(found.quantities.values())
        self.assertEqual(bits(got), bits(table["value"]))
        self.assertEqual(bits([q.error for q in got]), bits(table["error"]))
        self.assertEqual([q.unit for q in got], table["unit"])
        self.assertEqual(["exact" if q.exact else "estimate" for q in got], table["kind"])
        self.assertEqual([q.meaning for q in got], table["meaning"])
        self.assertTrue(all(table["meaning"]))
        if profile:
            table = program(command, *words, "--profile")
            for name in profile:
                self.assertEqual(bits(getattr(found, name)), bits(table[name]), name)
        return found

    def test_strike(self):
        found = self.check(lattice.strike, "sec34_impact run", "nyve", velocity=1.5, time=150, s="-1/6")
        self.assertEqual(len(found.y), found.chain.sites)
        self.assertEqual(len(found.t), len(found.track_centre))
        self.assertEqual(found.track_centre[-1], found.centre)
        self.check(lattice.strike, "sec34_impact run", "y", velocity=1, time=60, contact="power", alpha=2, onsite="pendulum")

    def test_a_chain_says_the_same_as_options(self):
        chain = lattice.Chain(onsite="quartic", s=-1 / 6)
        found, other = lattice.strike(chain, velocity=1.5, time=100), lattice.strike(velocity=1.5, time=100, s="-1/6")
        self.assertEqual(bits(found.y), bits(other.y))
        self.assertEqual(found.quantities.keys(), other.quantities.keys())

    def test_breather(self):
        found = self.check(lattice.breather, "sec32_newton_breathers breather", "ny", centre="bond", omega=1.2,
                           onsite="pendulum")
        self.assertEqual(len(found.y), found.chain.sites)

    def test_multipliers(self):
        found = lattice.multipliers(centre="site", omega=1.1)
        table = program("sec33_floquet multipliers", "--centre=site", "--omega=1.1")
        self.assertEqual(bits(found.multiplier.real), bits(table["real"]))
        self.assertEqual(bits(found.multiplier.imag), bits(table["imag"]))
        self.assertEqual(bits(found.multiplier_error), bits(table["error"]))
        z = found.multiplier[2]
        self.assertAlmostEqual(((z + 1 / z - 2) / 4).real, found.kappa, delta=1e-15)

    def test_barrier(self):
        self.check(lattice.barrier, "sec32_barrier barrier", omega=1.1, s=0)

    def test_travelling(self):
        self.check(lattice.travelling, "sec5_travelling_breathers orbit", "nyv", k=1, sign="minus")

    def test_dps(self):
        found = self.check(lattice.dps, "sec31_dps_limit impact", tau=60)
        self.assertAlmostEqual(np.sum(np.abs(found.amplitude_n) ** 2), 1, delta=1e-9)


class Refusals(unittest.TestCase):
    """The line of the program, as a ValueError, or as a RuntimeError if the computation fails."""

    def check(self, kind, function, command, **options):
        with self.assertRaises(kind) as caught:
            function(**options)
        self.assertEqual(str(caught.exception), program(command, *(f"--{n}={v}" for n, v in options.items())))

    def test_wrong_input(self):
        run = "sec34_impact run"
        self.check(ValueError, lattice.strike, run, velocity=-1.0)
        self.check(ValueError, lattice.strike, run, velocity="fast")
        with self.assertRaisesRegex(ValueError, "velocty.*--velocity"):
            lattice.strike(velocty=1.0)
        self.check(ValueError, lattice.strike, run, onsite="pendulum", s=1.0)
        self.check(ValueError, lattice.breather, "sec32_newton_breathers breather", centre="bond", sites=31)
        self.check(ValueError, lattice.breather, "sec32_newton_breathers breather", onsite="none")
        self.check(ValueError, lattice.travelling, "sec5_travelling_breathers orbit", k=1, near=5.5)
        self.check(ValueError, lattice.dps, "sec31_dps_limit impact", end="loose")

    def test_failures(self):
        self.check(RuntimeError, lattice.strike, "sec34_impact run", velocity=1.3, s=-0.7, time=100)

    def test_chains(self):
        for message, options in [("mass", {"sites": 3, "mass": [1, -1, 1]}), ("mass", {"sites": 3, "mass": [1, 1]}),
                                 ("--onsite", {"onsite": "cubic"}), ("--sites", {"sites": 1}), ("--ends", {"ends": "open"})]:
            with self.assertRaisesRegex(ValueError, message):
                lattice.Chain(**options)
        with self.assertRaisesRegex(ValueError, "--s: belongs to the chain"):
            lattice.strike(lattice.Chain(sites=30), s=1)
        with self.assertRaisesRegex(ValueError, "2 entries .allowed: 3"):
            lattice.Chain(sites=3).accelerations([1, 2])


class OwnChains(unittest.TestCase):
    def test_forces_of_a_dimer(self):
        """Eq. (32), written once more: masses, stiffnesses, another exponent, and the ends."""
        rng = np.random.default_rng(1)
        n, alpha = 9, 1.75
        mass, eta, y = rng.uniform(0.5, 2, n), rng.uniform(0.5, 2, n + 1), rng.normal(size=n)
        for ends in ("free", "fixed"):
            chain = lattice.Chain(sites=n, onsite="quartic", s=0.3, contact="power", alpha=alpha, ends=ends, mass=mass, eta=eta)
            z = np.concatenate([[0], y, [0]])
            push = eta * np.maximum(z[:-1] - z[1:], 0) ** alpha
            if ends == "free":
                push[[0, -1]] = 0
            a = (-(y + 0.3 * y**3) + push[:-1] - push[1:]) / mass
            np.testing.assert_allclose(chain.accelerations(y), a, rtol=1e-13, atol=1e-14)

    def test_a_dimer_keeps_its_energy(self):
        chain = lattice.Chain(sites=40, mass=np.resize([1.0, 3.0], 40))
        v = np.zeros(40)
        v[0] = 1
        run = chain.evolve(np.zeros(40), v, time=20, sample=0.5, tolerance=1e-8)
        self.assertEqual(run.y.shape, (len(run.t), 40))
        self.assertLess(run.energy_drift, 1e-8)
        self.assertAlmostEqual(chain.energy_density(run.y[-1], run.v[-1]).sum(), 0.5, delta=1e-8)
        light = lattice.strike(lattice.Chain(sites=40, mass=np.ones(40)), velocity=1, time=20)
        heavy = lattice.strike(chain, velocity=1, time=20)
        self.assertLess(heavy.centre, light.centre)

    def test_potentials_in_python(self):
        """The article's well and contact, written in Python, against those of the library."""
        well = lattice.Well(lambda y: y * y / 2, lambda y: -y, np.ones_like)
        contact = lattice.Contact(lambda r: 2 / r.dtype.type(5) * np.maximum(-r, 0) ** 2 * np.sqrt(np.maximum(-r, 0)),
                                  lambda r: np.maximum(-r, 0) * np.sqrt(np.maximum(-r, 0)),
                                  lambda r: 3 / r.dtype.type(2) * np.sqrt(np.maximum(-r, 0)))
        mine = lattice.strike(lattice.Chain(sites=30, onsite=well, contact=contact), velocity=1, time=20)
        theirs = lattice.strike(lattice.Chain(sites=30), velocity=1, time=20)
        np.testing.assert_allclose(mine.y, theirs.y, rtol=0, atol=1e-12)

    def test_a_breather_in_a_well_of_ones_own(self):
        well = lattice.Well(lambda y: y * y / 2, lambda y: -y, np.ones_like)
        mine, theirs = lattice.breather(onsite=well, omega=1.05, sites=31), lattice.breather(s=0, omega=1.05, sites=31)
        self.assertAlmostEqual(mine.energy, theirs.energy, delta=1e-12 * theirs.energy)
        with self.assertRaisesRegex(ValueError, "frequency at rest is one"):
            lattice.breather(onsite=lattice.Well(lambda y: y * y, lambda y: -2 * y, lambda y: 2 * np.ones_like(y)))

    def test_what_python_raises_arrives(self):
        def broken(y):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            lattice.Chain(sites=4, onsite=lattice.Well(broken, broken, broken)).accelerations(np.zeros(4))
        short = lattice.Well(lambda y: y, lambda y: y[:-1], lambda y: y)
        with self.assertRaisesRegex(ValueError, "force returns 3 numbers for 4"):
            lattice.Chain(sites=4, onsite=short).accelerations(np.zeros(4))


class LongWork(unittest.TestCase):
    def test_it_can_be_interrupted_and_leaves_others_alone(self):
        ticks, over = [], threading.Event()

        def tick():
            while not over.wait(0.01):
                ticks.append(0)

        other = threading.Thread(target=tick)
        for call in (lambda: lattice.strike(velocity=1, time=1e5, sites=3000, tolerance=1e-10),
                     lambda: lattice.dps(tau=1e4, sites=2000),
                     lambda: lattice.multipliers(omega=1.1, sites=301)):
            timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            if not ticks:
                other.start()
            begin = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                call()
            self.assertLess(time.monotonic() - begin, 60)
        over.set()
        other.join()
        self.assertGreater(len(ticks), 3)

    def test_threads_decide_nothing(self):
        lattice.set_threads(1)
        one = lattice.dps(tau=30)
        lattice.set_threads(0)
        self.assertEqual(bits(one.amplitude_n.real), bits(lattice.dps(tau=30).amplitude_n.real))


class Documentation(unittest.TestCase):
    def test_everything_is_described(self):
        for name in lattice.__all__:
            text = inspect.getdoc(getattr(lattice, name))
            self.assertTrue(text, name)
            self.assertNotIn("OPTIONS", text)
        for name, options in lattice._lattice.options.items():
            target = getattr(lattice, name)
            for option, *_ in options:
                if option != "profile":
                    self.assertIn(f"{option}:", target.__doc__, name)
                    self.assertIn(option, inspect.signature(target).parameters)
        self.assertIn("Eq. (26)", lattice.strike.__doc__)
        self.assertEqual(inspect.signature(lattice.breather).parameters["omega"].default, 1.1)

    def test_a_number_shows_what_is_known(self):
        self.assertEqual(str(lattice.Estimate(0.361294, 2e-5, "site")), "0.36129 ± 2e-05 site")
        self.assertEqual(str(lattice.Estimate(4, 0, "", True)), "4")
        self.assertEqual(str(lattice.Estimate(math.nan, math.nan)), "nan")
        copy = pickle.loads(pickle.dumps(lattice.Estimate(1.5, 0.1, "site")))
        self.assertEqual((copy, copy.error, copy.unit), (1.5, 0.1, "site"))
        self.assertIn("speed", repr(lattice.strike(velocity=1, time=10)))


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "there is no matplotlib")
class Notebooks(unittest.TestCase):
    def test_they_say_what_they_hold(self):
        paths = sorted(HERE.glob("*.ipynb"))
        self.assertGreaterEqual(len(paths), 2)
        for path in paths:
            self.assertEqual(notebooks.run(path), [])


if __name__ == "__main__":
    unittest.main()
