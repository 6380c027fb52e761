"""Lists of claims and findings: what a row mentions, sentences that stand in one place, and the lists of this repository,
with the quick runs that must answer them."""

import unittest

from lineage import chapters, claims, ecsv
from lineage.lock import read_lock

from common import ROOT, VOLUME, Scratch, finding, of_volume, table

FINDINGS = ["id", "sentence", "kind", "range", "tried", "criterion", "second", "figure", "front"]
GOOD = ["pull", "Up to t = 10 it is [](num:a.one) and $x_1 > 0$.", "observed", "Up to t = 10; one well", "longer runs",
        "sec1_demo.one > 0.5; sec1_demo.fact > sec1_demo.one", "0.9 by hand", "01", "yes"]


class Rows(Scratch):
    def test_our_numbers_in_a_row(self):
        self.assertEqual(claims.said("It is {p.q}, {not a name}.", {"p.q": finding(1.25, 1e-3)}), "It is 1.250, {not a name}.")
        with self.assertRaisesRegex(ecsv.Fault, "there is no number 'p.none'"):
            claims.said("{p.none}", {})
        row = {"sentence": "It is [](num:a.one).", "criterion": "sec1_demo.fact > 1; sec1_demo.other < sec2_why.so", "answer": "",
               "assumption": "with {sec1_demo.q}", "covered_by": "a.two^2"}
        self.assertEqual(claims.quoted_in(row), {"a.one", "sec1_demo.fact", "sec1_demo.other", "sec2_why.so", "sec1_demo.q", "a.two"})
        self.assertEqual(claims.quoted_in({"answer": "sec1_demo.x", "covered_by": "method"}), {"sec1_demo.x"})

    def test_a_sentence_shows_a_number_or_both_ends_of_a_bound(self):
        numbers = {"p.q": finding(0.18083351357990812, 6.4137584132595309e-12)}
        self.assertEqual(claims.in_plain("[](num:p.q), [to](num:p.q).", numbers), "0.180834, 0.1808335135(734 to 864).")

    def test_the_sentence_of_a_finding_stands_in_one_place(self):
        self.write("paper/findings.ecsv", table(FINDINGS, [GOOD]))
        for prose, words in [("[](finding:push)", "sec1_demo.cpp: paper/findings.ecsv has no finding 'push'"),
                             ("", "pull: it is quoted in no chapter and no page of the report"),
                             ("[](finding:pull) Up to t = 10 it\nis [1.0](num:a.one) and $x_1 > 0$.", "the sentence of pull is typed"),
                             ("(finding:pull)", "this is not of the form [](finding:id)")]:
            self.write("src/sec1_demo.cpp", f"/**\n# 1 A demonstration\n\n{prose} */\n")
            self.refuses("refresh", words)
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\n[](finding:pull) */\n")
        self.write("README.md", "<!-- found -->\n<!-- /found -->\n")
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertIn("- Up to t = 10 it is 1.000 and $x_1 > 0$. (make fig01)", self.read("README.md"))

        self.judged()
        path = "build/report/claims.ecsv"
        self.write(path, self.read(path) + 'findings,pull,"","","",nan,nan,"",holds,sec1_demo.one = 1 +- 1e-3 m > 0.5,sec1_demo\n')
        out = self.lineage("show", "pull")[1]
        self.assertIn("we found   Up to t = 10 it is 1.000 and $x_1 > 0$.", out)
        self.assertIn("condition  sec1_demo.one = 1 +- 1e-3 m > 0.5\n", out)


@of_volume
class Here(unittest.TestCase):
    def test_the_findings_are_whole(self):
        rows = claims.read_findings(VOLUME)
        self.assertGreater(len(rows), 5)
        for id, one in rows.items():
            self.assertNotIn("|", one["sentence"], id)
            self.assertEqual(one["sentence"].count("$") % 2, 0, id)
            self.assertIn(one["kind"], claims.KINDS, id)

    def test_a_second_route_agrees_and_is_as_sharp_as_a_headline_needs(self):
        second, locked = claims.read_second(VOLUME), claims.by_name(read_lock(VOLUME), claims.read_claims(VOLUME))
        self.assertGreaterEqual(len(second), 8)
        for name, (theirs, _) in second.items():
            self.assertTrue(claims.agrees(name, locked[name], second), name)
            self.assertTrue(0 < theirs.error < 0.05 * abs(theirs.value), name)


FULL, QUICK = ROOT / "build/data", ROOT / "build/quick/data"
PROGRAMS = claims.programs_of(VOLUME)


@of_volume
@unittest.skipUnless(all((QUICK / program / "facts.ecsv").exists() for program in PROGRAMS), "no quick run (make test makes it)")
class Quick(unittest.TestCase):
    def test_it_answers_everything_and_soon(self):
        # Ten seconds on two cores, or more where the full runs have just taken longer than paper/costs.ecsv says
        then, now = chapters.read_costs(VOLUME), chapters.measured_costs(ROOT / "build/report/cost")
        known = [program for program in then if program in now and then[program] > 0]
        slowness = max(1, sum(now[program] for program in known) / max(1, sum(then[program] for program in known)))
        costs = chapters.measured_costs(ROOT / "build/quick/report/cost", 1)
        self.assertEqual([program for program in PROGRAMS if costs[program] > 2 * 10 * slowness], [])
        rows = [*claims.read_claims(ROOT).values(), *claims.read_literature(VOLUME).values()]
        names = {name for row in rows for name in claims.FACTS.findall(f"{row['answer']} {row.get('criterion')}")}
        for run in (FULL, QUICK):
            found = {f"{program}.{id}" for program, id in claims.read_facts(run, PROGRAMS)}
            self.assertEqual({name for name in names if name.split(".")[0] in PROGRAMS} - found, set())

    def test_it_leaves_tables_and_nothing_else_and_coarser_ones(self):
        self.assertEqual([str(fault) for fault in ecsv.altered(QUICK)], [])
        for program in PROGRAMS:
            names = [path.name for path in (QUICK / program).glob("[!.]*")]
            self.assertEqual([name for name in names if not name.endswith(".ecsv")], [])
            rows = [[ecsv.rows_of(ecsv.text_of(run / program / name)) for run in (QUICK, FULL)] for name in names]
            self.assertTrue(any(coarse != fine for coarse, fine in rows), program)
