"""Lists of claims and findings: what a row mentions, sentences that stand in one place, and the lists of this repository,
with the quick runs that must answer them."""

import unittest

from lineage import claims, ecsv
from lineage.lock import read_lock

from common import ROOT, STATEMENTS, VOLUME, Scratch, finding, of_volume, table

FINDINGS = ["id", "sentence", "kind", "range", "tried", "second", "figure", "front"]
GOOD = ["pull", "Up to t = 10 it is [](statement:a.one) and $x_1 > 0$.", "observed", "Up to t = 10; one well", "longer runs",
        "0.9 by hand", "01", "yes"]


class Rows(Scratch):
    def test_our_numbers_in_a_row(self):
        self.assertEqual(claims.said("It is {p.q}, {not a name}.", {"p.q": finding(1.25, 1e-4)}), "It is 1.250, {not a name}.")
        with self.assertRaisesRegex(ecsv.Fault, "there is no number 'p.none'"):
            claims.said("{p.none}", {})
        row = {"sentence": "It is [](statement:a.one).", "assumption": "with {sec1_demo/t/s=-1/6/q}", "covered_by": "a.two^2"}
        self.assertEqual(claims.quoted_in(row), {"a.one", "sec1_demo/t/s=-1/6/q"})

    def test_two_routes_agree_within_the_sum_of_their_errors(self):
        for value, agree in ((1.0019, True), (1.0021, False)):
            self.assertEqual(claims.agrees("p", finding(1, 1e-3), {"p": (finding(value, 1e-3), "")}), agree)

    def test_every_row_is_judged_by_a_statement(self):
        self.assertEqual({id: row["program"] for id, row in claims.read_claims(self.root).items()}, {"a.one": "sec1_demo", "a.two": "sec1_demo"})
        self.change("src/statements/sec1_demo.cpp", "a.two", "a.three")
        self.refuses("refresh", "paper/claims.ecsv: row 2: a.two: no statement in src/statements judges it")

    def test_a_sentence_shows_a_number_or_both_ends_of_a_bound(self):
        numbers = {"p.q": finding(0.18083351357990812, 6.4137584132595309e-12)}
        self.assertEqual(claims.in_plain("[](statement:p.q), [to](statement:p.q).", numbers), "0.181, 0.1808335135(734 to 864).")

    def test_the_sentence_of_a_finding_stands_in_one_place(self):
        self.write("paper/findings.ecsv", table(FINDINGS, [GOOD]))
        self.write("src/statements/sec1_demo.cpp", STATEMENTS + 'STATEMENT("pull") {\n  less(1, table("results").at("name", "one")["value"]);\n}\n')
        mark = "<!-- pull -->\n<!-- /pull -->"
        for prose, words in [("", "pull: it is quoted in no chapter and no page of the report"),
                             (mark + mark.replace("pull", "push"), "sec1_demo.cpp: there is no table 'push'"),
                             (mark + mark, "sec1_demo.cpp: the two marks of the table 'pull' do not match")]:
            self.write("src/sec1_demo.cpp", f"/**\n# 1 A demonstration\n\n{prose} */\n")
            self.refuses("refresh", words)
        self.write("src/sec1_demo.cpp", f"/**\n# 1 A demonstration\n\n{mark} */\n")
        self.write("README.md", "<!-- found -->\n<!-- /found -->\n")
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertIn("- Up to t = 10 it is 1.00 and $x_1 > 0$. (make fig01)", self.read("README.md"))
        self.assertIn("<!-- pull -->\nUp to t = 10 it is 1.00 and $x_1 > 0$. (observed)\n<!-- /pull -->", self.read("src/sec1_demo.cpp"))
        self.change("src/sec1_demo.cpp", "1.00", "1.01")
        self.assertEqual(self.lineage("refresh", "--check")[0], 1)

        nan = float("nan")
        self.report(["findings", "pull", nan, nan, "", 0.0, "holds", "one: 0.9 < 1 +- 1e-3; one: 1 < 2", "judged", "sec1_demo"])
        out = self.lineage("show", "pull")[1]
        self.assertIn("we found   Up to t = 10 it is 1.00 and $x_1 > 0$.", out)
        self.assertIn("found      one: 0.9 < 1 +- 1e-3\n  found      one: 1 < 2\n  judged     src/statements/sec1_demo.cpp:9\n", out)


@of_volume
class Here(unittest.TestCase):
    def test_the_findings_are_whole(self):
        rows = claims.read_findings(VOLUME)
        self.assertGreater(len(rows), 5)
        for id, one in rows.items():
            self.assertNotIn("|", one["sentence"], id)
            self.assertEqual(one["sentence"].count("$") % 2, 0, id)
            self.assertIn(one["kind"], claims.KINDS, id)

    def test_verdicts_that_moved_lead_to_those_of_today(self):
        dates = [row["date"] for row in claims.read_moved(VOLUME)]
        self.assertEqual(dates, sorted(dates))
        now, status = {}, {id: row["status"] for id, row in claims.read_claims(VOLUME).items()}
        for row in claims.read_moved(VOLUME):
            self.assertEqual(now.setdefault(row["id"], row["before"]), row["before"], row)
            self.assertNotEqual(row["before"], row["after"])
            self.assertTrue({row["before"], row["after"]} <= {*claims.meanings()}, row)
            now[row["id"]] = row["after"]
        self.assertEqual(now, {id: status.get(id) for id in now})

    def test_a_second_route_agrees_and_is_sharp(self):
        second, locked = claims.read_second(VOLUME), claims.by_name(read_lock(VOLUME))
        self.assertGreaterEqual(len(second), 8)
        for name, (theirs, _) in second.items():
            self.assertTrue(claims.agrees(name, locked[name], second), name)
            self.assertTrue(0 < theirs.error < 0.05 * abs(theirs.value), name)


FULL, QUICK = ROOT / "build/data", ROOT / "build/quick/data"
PROGRAMS = claims.programs_of(VOLUME)


@of_volume
@unittest.skipUnless(all((QUICK / program / "SHA256SUMS").exists() for program in PROGRAMS), "no quick run (make test makes it)")
class Quick(unittest.TestCase):
    def test_it_leaves_tables_and_nothing_else_and_coarser_ones(self):
        self.assertEqual([str(fault) for fault in ecsv.altered(QUICK)], [])
        for program in PROGRAMS:
            names = list(ecsv.sums_in(QUICK / program))
            self.assertEqual({path.name for path in (QUICK / program).glob("[!.]*")}, {*names, "run.ecsv", "SHA256SUMS"})
            rows = [[ecsv.rows_of(ecsv.text_of(run / program / name)) for run in (QUICK, FULL)] for name in names]
            self.assertTrue(any(coarse != fine for coarse, fine in rows), program)
