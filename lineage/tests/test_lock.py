"""What is locked, how a fresh value is compared, and what is said of one number."""

import math
import unittest

from lineage import lock

from . import FACTS_OF_DEMO, Scratch, finding


class Distance(unittest.TestCase):
    def test_within_the_sum_of_the_errors(self):
        for locked, fresh, agrees in [
                (finding(1, 1e-3), finding(1.0019, 1e-3), True), (finding(1, 1e-3), finding(1.0021, 1e-3), False),
                (finding(1.62e-11, 1e-20), finding(1.77e-11, 1e-20), False), (finding(1), finding(1 + 5e-16), True),
                (finding(1), finding(1 + 1e-11), False), (finding(1, 0, "m"), finding(1), False), (finding(1, 1), finding(math.nan, 1), False),
                (finding(1, 1), finding(1.5, math.nan), False), (finding(math.nan, 1), finding(math.nan, 1), True),
                (finding(3e-16, 0, "", "residue"), finding(2e-15), True),
                (finding(3e-16, 0, "", "residue"), finding(-4e-15), False),
                (finding(0, 0, "", "residue"), finding(3e-16), True)]:
            self.assertEqual(lock.distance(locked, fresh) <= 1, agrees, (locked, fresh))

    def test_what_was_not_run_keeps_its_rows(self):
        locked = {("a", "x"): finding(1e-15, 0, "", "residue"), ("b", "y"): finding(0.1), ("c", "z"): finding(3)}
        fresh = {("a", "x"): finding(2e-15), ("a", "w"): finding(7), ("a", "unquoted"): finding(8, id="no")}
        now = lock.renewed(locked, fresh, ["a", "b"], lambda f: f.id != "no")
        self.assertEqual(sorted(now), [("a", "w"), ("a", "x"), ("b", "y")])
        self.assertEqual((now["a", "x"].kind, now["a", "x"].value), ("residue", 2e-15))


class Locking(Scratch):
    def test_what_decides_is_quoted_or_a_headline_is_locked(self):
        self.assertIn("lock       : 2 values (3 computed), 0 changes", self.lineage("lock")[1])
        text = self.read("src/sec1_demo.cpp")
        for name, quotation in [("src/sec1_demo.cpp", text + "/** [](num:sec1_demo.other) */\n"),
                                ("paper/paper.tex", "\\num{sec1_demo.other}\n"), ("paper/paper.tex", "\\err{sec1_demo.other}\n"),
                                ("paper/supplement.tex", "\\both{sec1_demo.other}\n"),
                                ("book/start.md", "[](num:sec1_demo.other)\n"),
                                ("book/commands.txt", "# one\nsec1_demo.other run # it\n")]:
            self.write(name, quotation)
            self.assertIn("new      sec1_demo other: 1", self.lineage("lock")[1], name)
            self.write(name, text if name.endswith("cpp") else "% \\num{sec1_demo.other}\n# nothing\n")
            self.assertIn("dropped  sec1_demo other: nothing quotes it", self.lineage("lock")[1], name)
        self.write("paper/claims.ecsv", self.read("paper/claims.ecsv").replace("sec1_demo.fact > 1", "sec1_demo.other > 0"))
        said = self.lineage("lock")[1]
        self.assertIn("dropped  sec1_demo fact", said)
        self.assertIn("new      sec1_demo other", said)

    def test_a_headline_and_a_residue_are_marked_by_hand(self):
        marked = self.read("paper/converged.ecsv").replace('0.10000000000000001,"",value', '0.10000000000000001,"",headline')
        self.write("paper/converged.ecsv", marked)
        self.lineage("lock")
        self.assertEqual(lock.read_lock(self.root)["sec1_demo", "fact"].kind, "headline")

    def test_what_moved_is_said(self):
        _, other, fact = FACTS_OF_DEMO
        self.facts(["one", 1.0015, 1e-3, "m"], other, fact)
        self.assertIn("moved    sec1_demo one: 1.0000000000000002 -> 1.0015000000000001, 0.75 of the sum of the errors\n",
                      self.lineage("lock")[1])
        self.facts(["one", 2.0, 1e-3, "m"], other, fact)
        self.assertIn("<- outside", self.lineage("lock")[1])
        self.facts(other, fact)
        self.assertIn("gone     sec1_demo one: was 2.000", self.lineage("lock")[1])

    def test_what_is_farther_than_the_errors_fails(self):
        one, other, _ = FACTS_OF_DEMO
        self.facts(one, other, ["fact", 2.15, 0.1, ""])
        self.assertEqual(self.lineage("lock", "--check"), (0, "lock       : 2 of 2 values within the sum of the errors\n", ""))
        self.facts(["one", 2.0, 1e-3, "m"])
        code, said, _ = self.lineage("lock", "--check")
        self.assertEqual((code, said.count("\n")), (1, 3), said)
        for words in ("one: 1.0000000000000002 -> 2, 500 of the sum of the errors  <- outside\n", "gone     sec1_demo fact", ": 0 of 2"):
            self.assertIn(words, said)

    def test_the_lock_is_written_as_it_was(self):
        self.lineage("lock")
        before = self.read("paper/converged.ecsv")
        self.assertIn("lock       : 2 values (3 computed), 0 changes", self.lineage("lock")[1])
        self.assertEqual(self.read("paper/converged.ecsv"), before)


class Show(Scratch):
    def test_one_number(self):
        self.write("book/commands.txt", "a.one build/bin/sec1_demo one --exactly # exact\n")
        out = self.lineage("show", "a.one")[1]
        for line in ["printed    1.02", "converged  1.000 m", "error      0.001", "verdict    discrepant",
                     "why        they erred", "figure     01 (make fig01)",
                     "command    build/bin/sec1_demo one --exactly (prints it as exact)",
                     "chapter    src/sec1_demo.cpp (build/bin/sec1_demo, 3 s on two cores)",
                     "from       build/data"]:
            self.assertIn(f"  {line}", out)
        self.assertIn("converged  1\n", self.lineage("show", "sec1_demo.other")[1])
        self.assertIn("verdict    holds\n  condition  sec1_demo.fact > 1\n  assuming   of 1.000, Section wells", self.lineage("show", "a.two")[1])
        self.judged("reproduced")
        self.assertIn("verdict    reproduced\n", self.lineage("show", "a.one")[1])  # what `verdicts` says, not what is recorded
        self.assertIn("condition  sec1_demo.fact = 2 +- 0.1 > 1\n", self.lineage("show", "a.two")[1])
        self.write("paper/claims.ecsv", (text := self.read("paper/claims.ecsv")) + text.splitlines()[-1].replace("a.two", "a.new") + "\n")
        self.assertIn("verdict    holds", self.lineage("show", "a.new")[1])  # not judged yet
        (self.root / "build/data/sec1_demo/facts.ecsv").unlink()
        self.assertIn("not computed here yet", self.lineage("show", "sec1_demo.fact")[1])
