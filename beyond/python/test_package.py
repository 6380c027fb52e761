"""Tests of the second half of the Python module. Argument: the folder of the programs."""

import doctest
import math
import sys
import unittest
from pathlib import Path

import lattice
import numpy as np
import tests

tests.BIN = Path(sys.argv.pop(1))


class Travelling(unittest.TestCase):
    def test_it_has_the_bits_and_the_complaints_of_the_program(self):
        command = "sec5_travelling_breathers orbit"
        tests.SameBits.check(self, lattice.travelling, command, "nyv", k=1, sign="minus")
        tests.Refusals.check(self, ValueError, lattice.travelling, command, k=1, near=5.5)
        self.assertEqual(lattice.travelling(k=1).chain.sites, len(lattice.travelling(k=1).y))

    def test_it_is_described(self):
        tests.Documentation.test_everything_is_described(self)


class Drive(unittest.TestCase):
    def test_damping_and_a_force(self):
        """A bead alone, which every textbook has, and the budget of a chain."""
        two = lattice.Chain(2, mass=[1, 1], eta=0)
        run = lattice.drive(two, [0.3, 0], [0, 0], 50, tolerance=1e-6, damping=0.1)
        w = math.sqrt(1 - 0.05**2)
        want = 0.3 * np.exp(-0.05 * run.t) * (np.cos(w * run.t) + 0.05 / w * np.sin(w * run.t))
        np.testing.assert_allclose(run.y[:, 0], want, rtol=0, atol=1e-6)
        self.assertEqual(run.injected, 0)
        shaken = lattice.drive(two, [0, 0], [0, 0], 400, tolerance=1e-6, damping=0.1, force=0.05, frequency=1.2)
        far = 0.05 / (1 - 1.2**2 + 0.12j) * np.exp(1.2j * shaken.t)
        np.testing.assert_allclose(shaken.y[-99:, 0], far.imag[-99:], rtol=0, atol=1e-6)
        chain, rest = lattice.Chain(20), np.zeros(20)
        run = lattice.drive(chain, rest, rest, 60, damping=np.linspace(0, 0.3, 20), force=0.2, frequency=1.1)
        self.assertEqual((run.injected_t[-1], run.dissipated_t[-1], run.energy_t[-1]), (run.injected, run.dissipated, run.energy))
        self.assertGreater(run.dissipated, 0)
        np.testing.assert_allclose(run.energy_t + run.dissipated_t, run.injected_t, rtol=0, atol=1e-6 * run.injected)
        self.assertLess(abs(run.energy - chain.energy_density(run.y[-1], run.v[-1]).sum()), 1e-12)
        # Without both it is the motion of a free chain
        plain = chain.evolve(rest, np.eye(20)[0], 30)
        free = lattice.drive(chain, rest, np.eye(20)[0], 30, damping=0, force=0, frequency=7)
        self.assertEqual(tests.bits(free.y), tests.bits(plain.y))
        self.assertEqual((free.injected, free.dissipated), (0, 0))

    def test_what_cannot_be_meant_is_refused(self):
        chain, v = lattice.Chain(4), np.eye(4)[0]
        for message, options in [("damping: -1", {"damping": -1}), ("damping: 3 entries", {"damping": [1, 1, 1]}),
                                 ("force: nan", {"force": math.nan}), ("frequency: -1", {"frequency": -1, "force": 1})]:
            with self.assertRaisesRegex(ValueError, f"^{message}"):
                lattice.drive(chain, 0 * v, v, time=1, **options)
        with self.assertRaisesRegex(ValueError, "free ends"):
            lattice.drive(lattice.Chain(4, ends="fixed"), 0 * v, v, 1, force=1)

    def test_what_the_page_shows_comes_out(self):
        page = Path(__file__).parent / "driven_end.md"
        self.assertEqual(doctest.testfile(str(page), module_relative=False).failed, 0)


if __name__ == "__main__":
    unittest.main()
