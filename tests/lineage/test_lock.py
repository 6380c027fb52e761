"""What is locked, what is said of what moved, and whether the lock of this repository keeps to its rule."""

import unittest

from lineage import claims, lock
from lineage.claims import by_name
from lineage.volumes import joined, volumes

from common import RESULTS_OF_DEMO, ROOT, VOLUME, WHOLE, Scratch, finding, of_volume


class Locking(Scratch):
    def setUp(self):
        super().setUp()
        self.judged()
        self.lineage("accept")

    def test_what_was_not_run_keeps_its_rows(self):
        locked = {("a", "cell", "x"): finding(1), ("b", "cell", "y"): finding(0.1), ("c", "cell", "z"): finding(3)}
        fresh = {("a", "cell", "x"): finding(2), ("a", "cell", "w"): finding(7), ("a", "cell", "unquoted"): finding(8, id="no")}
        now = lock.renewed(locked, fresh, ["a", "b"], lambda f: f.id != "no")
        self.assertEqual(sorted(now), [("a", "cell", "w"), ("a", "cell", "x"), ("b", "cell", "y")])
        self.assertEqual(now["a", "cell", "x"].value, 2)

    def test_answers_and_what_is_quoted_are_locked(self):
        self.assertIn("values     : 2 (2 computed), 0 changes", self.lineage("accept")[1])
        before, text = self.read("paper/converged.ecsv"), self.read("src/sec1_demo.cpp")
        for name, quotation in [("src/sec1_demo.cpp", text + "/** [](cell:sec1_demo/results/name=other/value) */\n"),
                                ("paper/paper.tex", "\\num{sec1_demo/results/name=other/value}\n"), ("paper/theorem.tex", "\\both{sec1_demo/results/name=other/value}\n"),
                                ("book/start.md", "[](cell:sec1_demo/results/name=other/value)\n"),
                                ("book/commands.txt", "# one\nsec1_demo/results/name=other/value run # it\n")]:
            self.write(name, quotation)
            self.assertIn("new      sec1_demo results/name=other/value: 1", self.lineage("accept")[1], name)
            self.write(name, text if name.endswith("cpp") else "% \\num{sec1_demo/results/name=other/value}\n# nothing\n")
            self.assertIn("dropped  sec1_demo results/name=other/value: nothing quotes it", self.lineage("accept")[1], name)
        self.assertEqual(self.read("paper/converged.ecsv"), before)
        self.judged()
        self.change("build/report/claims.ecsv", ",judged,", ",quick,")
        self.assertEqual([key for key in claims.read_answers(self.root) if key[2] == "a.one"], [])
        self.judged()
        self.change("build/report/claims.ecsv", ",0,holds", ",1,holds")
        self.assertEqual(claims.read_answers(self.root)["sec1_demo", "failures", "a.two"].value, 1)
        self.judged()
        self.change("build/report/claims.ecsv", ",0,holds", ",3,holds")
        self.assertIn("new      a.two (failures): 3", self.lineage("accept")[1])

    def test_what_is_gone_fails(self):
        self.judged()
        self.lineage("accept")
        (self.root / "build/report/claims.ecsv").unlink()
        code, said, _ = self.lineage("accept", "--check")
        self.assertEqual(code, 1, said)
        self.assertIn("gone     a.one (answer)", said)

    def test_what_is_farther_than_the_errors_fails(self):
        self.judged(one=1.0005)
        self.assertEqual(self.lineage("accept", "--check")[:2], (0, "values     : 2 of 2 within the sum of the errors\n"
                         "bytes      : 1 of 1 tables are as recorded\n"))
        self.assertIn("moved    a.one (answer): 1 -> 1.0004999999999999, 0.25 of the sum of the errors\n", self.lineage("accept")[1])
        self.judged(one=2.0)
        one, other, _ = RESULTS_OF_DEMO
        self.results(one, other, ["two", 2.5, 0.1])
        code, said, _ = self.lineage("accept", "--check")
        self.assertEqual(code, 1, said)
        for words in ("a.one (answer): 1.0004999999999999 -> 2, 500 of the sum of the errors  <- outside\n", "moved    sec1_demo results/name=two/value: 2 -> 2.5",
                      ": 0 of 2", "differs  build/data/sec1_demo/results.ecsv", "1 table, 2 values changed; if you meant it: make accept\n"):
            self.assertIn(words, said)


class Here(unittest.TestCase):
    def test_what_is_claimed_and_quoted_is_locked(self):
        self.assertEqual(lock.quoted(ROOT) - set(by_name(joined(lock.read_lock, volumes(ROOT)))), set())

    @of_volume
    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_it_holds_what_is_claimed_or_quoted(self):
        locked, names = lock.read_lock(VOLUME), lock.quoted(VOLUME)
        self.assertGreater(len(locked), 100)
        self.assertEqual([key for key, f in locked.items() if not lock.is_kept(f, names)], [], "make accept")
