"""What is said of one number, and of a command line that means nothing."""

from common import NAN, RESULTS_OF_DEMO, Scratch

COMPARISONS = ["id", "role", "cells", "small", "small_error", "large", "large_error", "outcome"]
READINGS = ["id", "reading", "choice", "value", "error", "unit", "outcome"]


class Show(Scratch):
    def test_one_number(self):
        self.judged()
        self.write("book/commands.txt", "a.one build/bin/sec1_demo one --exactly # exact\n")
        out = self.lineage("show", "a.one")[1]
        for line in ["printed    1.02", "converged  1.000 m", "error      0.001", "verdict    discrepant",
                     "why        they erred", "figure     01 (make fig01)",
                     "command    build/bin/sec1_demo one --exactly (prints it as exact)",
                     "chapter    src/sec1_demo.cpp (build/bin/sec1_demo, 3 s on two cores)",
                     "from       build/data"]:
            self.assertIn(f"  {line}", out)
        self.assertIn("converged  1\n", self.lineage("show", "sec1_demo/results/name=other/value")[1])
        (self.root / "build/data/sec1_demo/SHA256SUMS").unlink()
        (self.root / "build/report/claims.ecsv").unlink()
        self.assertIn("not computed here yet", self.lineage("show", "sec1_demo/results/name=two/value")[1])

    def test_the_verdict_is_the_one_that_was_given_or_that_is_recorded(self):
        out = self.lineage("show", "a.two")[1]
        self.assertIn("verdict    holds\n  found      not run\n  judged     src/statements/sec1_demo.cpp:6 (not run)\n"
                      "             STATEMENT(\"a.two\") {\n", out)
        self.assertIn("             }\n  remark     of 1.00, Section wells\n", out)
        self.judged("reproduced")
        self.assertIn("verdict    reproduced\n", self.lineage("show", "a.one")[1])
        self.assertIn("found      results.value: 1 < 2 +- 0.1\n  judged     src/statements/sec1_demo.cpp:6\n", self.lineage("show", "a.two")[1])
        self.beside("comparisons", COMPARISONS, *(["a.two", "claim", f"t.x (n = {n})", 1.0, 0.0, 2.0 + n, 0.1, "holds"] for n in range(14)),
                    ["a.two", "control", "t.y", 3.0, 0.0, 2.0, 0.0, "fails"])
        self.beside("readings", READINGS, ["a.two", "in all wells", "s is not printed", NAN, NAN, "", "in part"])
        out = self.lineage("show", "a.two")[1]
        self.assertNotIn("found", out)
        self.assertIn("  controls   t.y: 3 < 2  fails\n  compares   t.x (n = 0): 1 < 2 +- 0.1  holds\n", out)  # the worst first
        self.assertIn("and 3 more (in all 14 hold): build/report\n  reading    in all wells: in part (s is not printed)\n", out)
        self.results(*RESULTS_OF_DEMO[:2], ["two", 2.5, 0.1])
        self.assertIn("converged  2.5", self.lineage("show", "sec1_demo/results/name=two/value")[1])  # the fresh one
        self.change("src/statements/sec1_demo.cpp", 'STATEMENT("a.two")', 'STATEMENT("a.new") {\n}\nSTATEMENT("a.two")')
        text = self.read("paper/claims.ecsv")
        self.write("paper/claims.ecsv", text + text.splitlines()[-1].replace("a.two", "a.new") + "\n")
        self.assertIn("verdict    holds", self.lineage("show", "a.new")[1])  # not judged yet

    def test_the_command_line(self):
        for arguments in (["hashes", "--dat"], ["show"], ["show", "a.one", "a.two"]):
            code, out, err = self.lineage(*arguments)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
        self.refuses("show a.on", "lineage show: ID: there is no number 'a.on' (near it: a.one, a.two)\n", code=2)
