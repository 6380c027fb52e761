"""Tests of the second half of the Python module. Argument: the folder of the programs."""

import sys
import unittest
from pathlib import Path

import lattice
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


if __name__ == "__main__":
    unittest.main()
