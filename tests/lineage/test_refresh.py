"""Numbers in prose and the tables of the pages: what is renewed, what is refused, and that nothing here is stale."""

import unittest

from lineage import ecsv, refresh

from common import VOLUME, Scratch, finding, of_volume

NUMBERS = {"pn.omega11": finding(1.62e-11, 1e-14), "sec1/p/x": finding(3),
           "sec1/t/s=-1/6/x": finding(0.2012, 1e-3), "sec1/t/s=0/y": finding(0.31251, 1e-5)}


class Texts(unittest.TestCase):
    def test_links_show_the_value_and_dangle_nowhere(self):
        prose = "is [](statement:pn.omega11), and [17](cell:p/x) of [these](fig:07), as `[](cell:...)` says."
        ought = "is [1.62e-11](statement:pn.omega11), and [3](cell:p/x) of [these](fig:07), as `[](cell:...)` says."
        self.assertEqual(refresh.with_numbers(prose, NUMBERS, "sec1"), ought)
        for text in ("to", "1.61(5 to 9)e-11"):
            self.assertEqual(refresh.with_numbers(f"[{text}](statement:pn.omega11)", NUMBERS), "[1.6(1899 to 2100)e-11](statement:pn.omega11)")
        prose = "[0.1](cell:t/s=-1/6/x) and [](cell:s=0/y), [1.6](statement:pn.omega11)"
        ought = "[0.2](cell:t/s=-1/6/x) and [0.313](cell:s=0/y), [1.6e-11](statement:pn.omega11)"
        self.assertEqual(refresh.with_numbers(prose, NUMBERS, "sec1"), ought)
        for bad in ("[](statement:pn.omega12)", "](cell:p/x)", "[](cell:p/x", "[](cell:t/s=1/x)", "[](cell:y)", "[](cell:t/s=-1/6/x)\n[](cell:s=0/y)"):
            with self.assertRaises(ecsv.Fault):
                refresh.with_numbers(bad, NUMBERS, "sec1")

    def test_a_page_gets_the_tables_for_which_it_has_marks(self):
        page = "a\n<!-- t -->\nold\n<!-- /t -->\nb\n"
        self.assertEqual(refresh.fresh_page(page, {"t": ["x", "y"], "u": []}), "a\n<!-- t -->\nx\ny\n<!-- /t -->\nb\n")
        for bad in (page.replace("t -->", "u -->"), page.replace("/t", "/s"), page + "<!-- /t -->", page * 2):
            with self.assertRaises(ecsv.Fault):
                refresh.fresh_page(bad, {"t": []})
        self.assertEqual(refresh.fresh_page(page, {"t": None}), page)


class Refreshing(Scratch):
    def test_only_what_is_stale_is_written(self):
        self.assertEqual(self.lineage("refresh", "--check")[0], 1)
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertIn("It is [1.00](statement:a.one), not [2.0 ± 0.1](cell:results/name=two/value).", self.read("src/sec1_demo.cpp"))
        self.assertIn("| one | 1.02 | 1.00 m | their ruler |", self.read("README.md"))
        self.assertEqual(self.lineage("refresh", "--check"), (0, "", ""))
        self.write("build/report/cost/sec1_demo", "9.1\n")
        self.assertIn("renewed", self.lineage("refresh")[1])
        self.assertIn("sec1_demo,9.1", self.read("paper/costs.ecsv"))

    def test_statements_stand_at_the_end_of_their_chapter_when_they_are_judged(self):
        mark = "<!-- statements -->\n<!-- /statements -->"
        self.write("src/sec1_demo.cpp", f"/**\n# 1 A demonstration\n\n{mark} */\n")
        self.lineage("refresh")
        self.assertIn(mark, self.read("src/sec1_demo.cpp"))
        self.judged()
        self.lineage("refresh")
        for line in ("| `a.one`: one | 1.02 | 1.00 m | discrepant |", "| `a.two`: two | yes | results.value: 1 < 2 | holds |"):
            self.assertIn(line, self.read("src/sec1_demo.cpp"))

    def test_what_is_quoted_must_be_locked(self):
        self.write("src/sec1_demo.cpp", "/** [](cell:results/name=other/value) */\n")
        self.refuses("refresh", "src/sec1_demo.cpp: there is no reference value 'sec1_demo/results/name=other/value'")


class Here(unittest.TestCase):
    @of_volume
    def test_nothing_is_stale(self):
        stale = [str(path) for path, text in refresh.fresh_texts(VOLUME, {}) if text != ecsv.text_of(path)]
        self.assertEqual(stale, [], "make refresh")
