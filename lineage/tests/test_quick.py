"""Every program with --quick: the same answers as the full run, coarser, and soon."""

import unittest

from lineage import chapters, ecsv
from lineage.claims import FACTS, programs_of, read_claims, read_facts, read_literature

from . import ROOT, VOLUME, of_volume

FULL, QUICK = ROOT / "build/data", ROOT / "build/quick/data"
PROGRAMS = programs_of(VOLUME)


def slowness():
    """How many times longer the full runs have just taken than paper/costs.ecsv says; one where they were faster."""
    then, now = chapters.read_costs(VOLUME), chapters.measured_costs(ROOT / "build/report/cost")
    known = [program for program in then if program in now and then[program] > 0]
    return max(1, sum(now[program] for program in known) / max(1, sum(then[program] for program in known)))


@of_volume
@unittest.skipUnless(all((QUICK / program / "facts.ecsv").exists() for program in PROGRAMS), "no quick run (make test makes it)")
class Quick(unittest.TestCase):
    def test_it_answers_everything_and_soon(self):
        # Ten seconds on two cores
        budget, costs = 2 * 10 * slowness(), chapters.measured_costs(ROOT / "build/quick/report/cost", 1)
        rows = [*read_claims(ROOT).values(), *read_literature(VOLUME).values()]
        facts = {name for row in rows for name in FACTS.findall(f"{row['answer']} {row.get('criterion')}") if name.split(".")[0] in PROGRAMS}
        quick, full = ({f"{program}.{id}" for program, id in read_facts(run, PROGRAMS)} for run in (QUICK, FULL))
        self.assertEqual(facts - full, set())
        self.assertEqual(facts - quick, set())
        for program in PROGRAMS:
            self.assertLessEqual(costs[program], budget, program)

    def test_it_leaves_tables_and_nothing_else_and_coarser_ones(self):
        self.assertEqual([str(fault) for fault in ecsv.altered(QUICK)], [])
        for program in PROGRAMS:
            with self.subTest(program):
                names = [path.name for path in (QUICK / program).glob("[!.]*")]
                self.assertEqual([name for name in names if not name.endswith(".ecsv")], [])
                rows = [[ecsv.rows_of(ecsv.text_of(run / program / name)) for run in (QUICK, FULL)] for name in names]
                self.assertTrue(any(coarse != fine for coarse, fine in rows))
