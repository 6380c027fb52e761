"""Every program with --quick: the same answers as the full run, coarser, and soon."""

import unittest

from lineage import chapters, ecsv
from lineage.claims import findings_in, programs_of

from . import ROOT, VOLUME, of_volume

FULL, QUICK = ROOT / "build/data", ROOT / "build/quick/data"
PROGRAMS = programs_of(VOLUME)


def slowness():
    """How many times longer the full runs have just taken than paper/costs.ecsv says; one where they were faster."""
    then, now = chapters.read_costs(VOLUME), chapters.measured_costs(ROOT / "build/report/cost")
    known = [program for program in then if program in now and then[program] > 0]
    return max(1, sum(now[program] for program in known) / max(1, sum(then[program] for program in known)))


@of_volume
@unittest.skipUnless(all((QUICK / program / "results.ecsv").exists() for program in PROGRAMS), "no quick run (make test makes it)")
class Quick(unittest.TestCase):
    def test_it_answers_everything_and_soon(self):
        # Ten seconds on two cores
        budget, costs = 2 * 10 * slowness(), chapters.measured_costs(ROOT / "build/quick/report/cost", 1)
        for program in PROGRAMS:
            with self.subTest(program):
                quick, full = (findings_in(run / program / "results.ecsv", program, "id") for run in (QUICK, FULL))
                self.assertEqual(quick.keys(), full.keys())
                self.assertLessEqual(costs[program], budget)

    def test_it_leaves_tables_and_nothing_else_and_coarser_ones(self):
        self.assertEqual([str(fault) for fault in ecsv.altered(QUICK)], [])
        for program in PROGRAMS:
            with self.subTest(program):
                names = [path.name for path in (QUICK / program).glob("[!.]*")]
                self.assertEqual([name for name in names if not name.endswith(".ecsv")], [])
                rows = [[ecsv.rows_of(ecsv.text_of(run / program / name)) for run in (QUICK, FULL)] for name in names]
                self.assertTrue(any(coarse != fine for coarse, fine in rows))
