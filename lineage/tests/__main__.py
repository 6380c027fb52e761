"""Runs all tests and says in two lines what came out; with `-v` it names each."""

import os
import sys
import unittest

with open(os.devnull, "w", encoding="utf-8") as quiet:
    here = os.path.dirname(os.path.abspath(__file__))
    suite = unittest.defaultTestLoader.discover(here, top_level_dir=os.path.dirname(os.path.dirname(here)))
    runner = unittest.TextTestRunner(sys.stderr if "-v" in sys.argv else quiet, verbosity=2)
    result = runner.run(suite)
for _, error in result.failures + result.errors:
    print(error)
for reason in sorted({reason for _, reason in result.skipped}):
    print("lineage    : skipped, " + reason)
failed = len(result.failures) + len(result.errors)
print(f"lineage    : {result.testsRun - failed - len(result.skipped)} of {result.testsRun} tests in order")
sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
