"""What we found: rows that can be judged, sentences that stand in one place."""

import unittest

from lineage import findings
from lineage.claims import name_of, read_claims
from lineage.lock import read_lock

from . import VOLUME, Scratch, of_volume, table

COLUMNS = list(findings.COLUMNS)
GOOD = ["pull", "Up to t = 10 it is [](num:a.one) and $x_1 > 0$.", "observed", "Up to t = 10; one well", "longer runs",
        "a.one > 0.5; sec1_demo.fact > a.one", "0.9 by hand", "01"]


def row(**changed):
    return [changed.get(name, cell) for name, cell in zip(COLUMNS, GOOD)]


class Findings(Scratch):
    def setUp(self):
        super().setUp()
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\nIt is [](num:a.one). [](finding:pull) */\n")
        self.found()

    def found(self, *rows):
        self.write("paper/findings.ecsv", table(COLUMNS, rows or [GOOD]))

    def test_a_row_is_judged_with_its_margins(self):
        out = self.lineage("show", "pull")[1]
        self.assertIn("we found   Up to t = 10 it is 1.000 and $x_1 > 0$.", out)
        self.assertIn("sec1_demo.fact = 2.0 > a.one, margin 1 (error 0.1)", out)
        self.assertIn("0 proved, 0 enclosed, 0 computed, 1 observed", self.lineage("summary")[1])
        self.found(row(criterion="a.one > 0.9995"))
        self.assertIn("fails      pull", self.lineage("summary")[1])

    def test_a_row_that_could_not_be_judged_is_refused(self):
        for words, changed in [("is none (allowed: proved", {"kind": "seen"}), ("no list of conditions", {"criterion": ""}),
                               ("no list of conditions", {"criterion": "a.one"}), ("no range", {"range": ""}),
                               ("does not say 'Up to t = 20'", {"range": "Up to t = 20; one well"})]:
            self.found(row(**changed))
            self.refuses("refresh", "paper/findings.ecsv: row 1", words)
        self.found(GOOD, row(id="again"))
        self.refuses("refresh", "again: says the same as pull")
        self.found(*(row(id=f"a{i}", sentence=f"Up to t = 10 {i}") for i in range(31)))
        self.refuses("refresh", "31 findings")
        self.found(row(criterion="sec1_demo.lost > 1"))
        self.assertIn("sec1_demo.lost", self.lineage("summary")[2])

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
        rows = findings.read_findings(VOLUME)
        self.assertGreater(len(rows), 5)
        for id, one in rows.items():
            self.assertNotIn("|", one["sentence"], id)
            self.assertEqual(one["sentence"].count("$") % 2, 0, id)

    def test_a_second_route_agrees_and_is_as_sharp_as_a_headline_needs(self):
        claims, second = read_claims(VOLUME), findings.read_second(VOLUME)
        locked = {name_of(f, claims): f for f in read_lock(VOLUME).values()}
        self.assertGreaterEqual(len(second), 8)
        for name, (theirs, _) in second.items():
            self.assertTrue(findings.agrees(name, locked[name], second), name)
            self.assertTrue(0 < theirs.error < 0.05 * abs(theirs.value), name)
