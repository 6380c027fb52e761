"""What we found, and numbers of others: sentences that stand in one place, rows that are whole."""

import unittest

from lineage import claims
from lineage.lock import read_lock

from . import ROOT, VOLUME, WHOLE, Scratch, of_volume, table

COLUMNS = ["id", "sentence", "kind", "range", "tried", "criterion", "second", "figure"]
GOOD = ["pull", "Up to t = 10 it is [](num:a.one) and $x_1 > 0$.", "observed", "Up to t = 10; one well", "longer runs",
        "sec1_demo.one > 0.5; sec1_demo.fact > sec1_demo.one", "0.9 by hand", "01"]


class Findings(Scratch):
    def setUp(self):
        super().setUp()
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\nIt is [](num:a.one). [](finding:pull) */\n")
        self.write("paper/findings.ecsv", table(COLUMNS, [GOOD]))

    def test_it_is_shown_with_its_conditions(self):
        out = self.lineage("show", "pull")[1]
        self.assertIn("we found   Up to t = 10 it is 1.000 and $x_1 > 0$.", out)
        self.assertIn("condition  sec1_demo.fact > sec1_demo.one", out)  # not judged yet
        self.judged()
        path = "build/report/claims.ecsv"
        self.write(path, self.read(path) + 'findings,pull,"","","",nan,nan,"",holds,sec1_demo.one = 1 +- 1e-3 m > 0.5,sec1_demo\n')
        self.assertIn("condition  sec1_demo.one = 1 +- 1e-3 m > 0.5\n", self.lineage("show", "pull")[1])

    def test_a_sentence_stands_in_one_place(self):
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\n[](finding:push) */\n")
        self.refuses("refresh", "sec1_demo.cpp: paper/findings.ecsv has no finding 'push'")
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n*/\n")
        self.refuses("refresh", "pull: no chapter and no page of the report quotes it")
        self.write("src/sec1_demo.cpp", "/**\n# 1 A\n\n[](finding:pull) Up to t = 10 it\nis [1.0](num:a.one) and $x_1 > 0$. */\n")
        self.refuses("refresh", "sec1_demo.cpp: the sentence of pull is typed here")
        self.write("src/sec1_demo.cpp", "/**\n# 1 A\n\n(finding:pull) */\n")
        self.refuses("refresh", "this is no [](finding:id)")

    def test_the_pages_tell_it(self):
        self.write("README.md", "<!-- found -->\n<!-- /found -->\n")
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertIn("- Up to t = 10 it is 1.000 and $x_1 > 0$. (make fig01)", self.read("README.md"))

    def test_a_second_route_is_named_where_it_agrees(self):
        names = ["quantity", "value", "error", "unit", "method"]
        for value, told in ((1.0005, True), (1.01, False)):
            self.write("paper/second.ecsv", table(names, [["a.one", value, 1e-4, "m", "by hand"]]))
            self.assertEqual("by hand" in self.lineage("show", "a.one")[1], told)


@of_volume
class Here(unittest.TestCase):
    def test_the_rows_of_this_repository_are_whole(self):
        rows = claims.read_findings(VOLUME)
        self.assertGreater(len(rows), 5)
        for id, one in rows.items():
            self.assertNotIn("|", one["sentence"], id)
            self.assertEqual(one["sentence"].count("$") % 2, 0, id)
            self.assertIn(one["kind"], claims.KINDS, id)

    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_six_numbers_of_three_sources_were_read_by_ourselves(self):
        rows = claims.read_literature(ROOT / "beyond").values()
        read = [row for row in rows if row["covered_by"] != "memory"]
        self.assertGreaterEqual(len(read), 6)
        self.assertGreaterEqual(len({row["citation"] for row in read}), 3)
        self.assertTrue(all(row["where"] for row in read))
        for row in rows:
            self.assertEqual(row["obtained"] == "memory", row["covered_by"] == "memory", row["id"])
            self.assertIn(row["obtained"], claims.OBTAINED)

    def test_a_second_route_agrees_and_is_as_sharp_as_a_headline_needs(self):
        second, locked = claims.read_second(VOLUME), claims.by_name(read_lock(VOLUME), claims.read_claims(VOLUME))
        self.assertGreaterEqual(len(second), 8)
        for name, (theirs, _) in second.items():
            self.assertTrue(claims.agrees(name, locked[name], second), name)
            self.assertTrue(0 < theirs.error < 0.05 * abs(theirs.value), name)
