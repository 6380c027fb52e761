"""What is locked, what is said of what moved, and whether the lock of this repository keeps to its rule."""

import unittest

from lineage import lock
from lineage.volumes import joined, volumes

from common import FACTS_OF_DEMO, ROOT, VOLUME, WHOLE, Scratch, finding, of_volume


class Locking(Scratch):
    def test_what_was_not_run_keeps_its_rows(self):
        locked = {("a", "x"): finding(1e-15, 0, "", "residue"), ("b", "y"): finding(0.1), ("c", "z"): finding(3)}
        fresh = {("a", "x"): finding(2e-15), ("a", "w"): finding(7), ("a", "unquoted"): finding(8, id="no")}
        now = lock.renewed(locked, fresh, ["a", "b"], lambda f: f.id != "no")
        self.assertEqual(sorted(now), [("a", "w"), ("a", "x"), ("b", "y")])
        self.assertEqual((now["a", "x"].kind, now["a", "x"].value), ("residue", 2e-15))

    def test_what_decides_or_is_quoted_is_locked(self):
        self.assertIn("lock       : 2 values (3 computed), 0 changes", self.lineage("lock")[1])
        before, text = self.read("paper/converged.ecsv"), self.read("src/sec1_demo.cpp")
        for name, quotation in [("src/sec1_demo.cpp", text + "/** [](num:sec1_demo.other) */\n"),
                                ("paper/paper.tex", "\\num{sec1_demo.other}\n"), ("paper/theorem.tex", "\\both{sec1_demo.other}\n"),
                                ("book/start.md", "[](num:sec1_demo.other)\n"),
                                ("book/commands.txt", "# one\nsec1_demo.other run # it\n")]:
            self.write(name, quotation)
            self.assertIn("new      sec1_demo other: 1", self.lineage("lock")[1], name)
            self.write(name, text if name.endswith("cpp") else "% \\num{sec1_demo.other}\n# nothing\n")
            self.assertIn("dropped  sec1_demo other: nothing quotes it", self.lineage("lock")[1], name)
        self.assertEqual(self.read("paper/converged.ecsv"), before)
        self.change("paper/claims.ecsv", "sec1_demo.fact > 1", "sec1_demo.other > 0")
        said = self.lineage("lock")[1]
        self.assertIn("dropped  sec1_demo fact", said)
        self.assertIn("new      sec1_demo other", said)

        self.change("paper/converged.ecsv", 'other,1,0,"",value', 'other,1,0,"",headline')  # marked by hand
        self.change("paper/claims.ecsv", "sec1_demo.other > 0", "sec1_demo.fact > 1")
        self.lineage("lock")
        self.assertEqual(lock.read_lock(self.root)["sec1_demo", "other"].kind, "headline")

    def test_what_is_farther_than_the_errors_fails(self):
        one, other, _ = FACTS_OF_DEMO
        self.facts(one, other, ["fact", 2.15, 0.1, ""])
        self.assertEqual(self.lineage("lock", "--check"), (0, "lock       : 2 of 2 values within the sum of the errors\n", ""))
        self.assertIn("moved    sec1_demo fact: 2 -> 2.1499999999999999, 0.75 of the sum of the errors\n", self.lineage("lock")[1])
        self.facts(["one", 2.0, 1e-3, "m"])
        code, said, _ = self.lineage("lock", "--check")
        self.assertEqual((code, said.count("\n")), (1, 3), said)
        for words in ("one: 1 -> 2, 500 of the sum of the errors  <- outside\n", "gone     sec1_demo fact", ": 0 of 2"):
            self.assertIn(words, said)


class Here(unittest.TestCase):
    def test_what_is_claimed_and_quoted_is_locked(self):
        known = {f"{program}.{id}" for program, id in joined(lock.read_lock, volumes(ROOT))}
        self.assertEqual(lock.quoted(ROOT) - known, set())

    @of_volume
    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_it_holds_what_is_claimed_quoted_or_a_headline(self):
        locked, names = lock.read_lock(VOLUME), lock.quoted(VOLUME)
        self.assertGreater(len(locked), 100)
        self.assertEqual([key for key, f in locked.items() if not lock.is_kept(f, names)], [], "make lock")
