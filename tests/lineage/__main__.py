"""Runs all tests and says in two lines what came out; with `-v` it names each. With `beyond` only what that volume has
to pass, on its files."""

import os
import sys
import unittest

second = "beyond" in sys.argv
if second:
    os.environ["LINEAGE_VOLUME"] = "beyond"


def chosen(suite):
    """Its tests; for the second volume those that are marked."""
    for one in suite:
        if isinstance(one, unittest.TestSuite):
            yield from chosen(one)
        elif not second or hasattr(one, "of_volume") or hasattr(getattr(one, one._testMethodName), "of_volume"):
            yield one


with open(os.devnull, "w", encoding="utf-8") as quiet:
    suite = unittest.defaultTestLoader.discover(os.path.dirname(os.path.abspath(__file__)))
    runner = unittest.TextTestRunner(sys.stderr if "-v" in sys.argv else quiet, verbosity=2)
    result = runner.run(unittest.TestSuite(chosen(suite)))
for _, error in result.failures + result.errors:
    print(error)
for reason in sorted({reason for _, reason in result.skipped}):
    print("lineage    : skipped, " + reason)
failed = len(result.failures) + len(result.errors)
print(f"lineage    : {result.testsRun - failed - len(result.skipped)} of {result.testsRun} tests in order")
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
