"""Tests of the package: on texts, on a small repository that is made and broken, and on this one.

`make test-lineage` runs them all; what needs a tool that is not installed is skipped, with a word. A file is named
after the module that it tests, and here is what they share."""

import contextlib
import io
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from lineage import ecsv
from lineage.__main__ import main
from lineage.values import Finding

ROOT = Path(__file__).resolve().parents[2]
# The volume that is asked for: what is said of this repository is said of it.
VOLUME = ROOT / os.environ.get("LINEAGE_VOLUME", "")
# Volume two may be left out of a checkout.
WHOLE = (ROOT / "beyond").is_dir()


def of_volume(test):
    """Marks a test, or a class of tests, of this repository that each volume has to pass."""
    test.of_volume = True
    return test


CLAIMS = ["id", "section", "where", "quantity", "printed", "unit", "tolerance", "assumption", "covered_by", "reason", "cause", "status"]
LOCK = ["program", "what", "id", "value", "error", "unit"]
STATEMENTS = '''/**
# Statements: a demonstration */
STATEMENT("a.one") {
  answer(table("results").at("name", "one")["value"]);
}
STATEMENT("a.two") {
  less(1, table("results").at("name", "two")["value"]);
}
'''
RESULTS = ["name", "value", "value_error"]
RESULTS_OF_DEMO = ["one", 1.0, 1e-3], ["other", 1.0, 0.0], ["two", 2.0, 0.1]
FIGURES = ["id", "label", "section", "program", "script", "data", "caption", "details"]
REAL = ("value", "error", "value_error", "failures", "small", "small_error", "large", "large_error", "seconds",
        "lowest", "highest")
NAN = float("nan")
DESCRIPTION = ["command", "option", "meaning", "takes", "lowest", "highest", "unit", "words", "default", "chosen_by", "choices"]
OPTIONS = [["", "", "A demonstration (section 1)", "", NAN, NAN, *[""] * 5], ["", "help", "this text", "flag", NAN, NAN, *[""] * 5],
           ["one", "", "one thing, of two", "", NAN, NAN, *[""] * 5],
           ["one", "speed", "how fast it is, in sites", "number", 1e-6, 1.0, "m/s", "", "0.5", "", ""],
           ["one", "well", "well of every bead", "name", NAN, NAN, "", "none, quartic", "none", "", ""],
           ["one", "s", "anharmonicity", "number", -1.0, 2.0, "", "", "0", "well", "quartic"]]


def table(names, rows):
    """The text of a table; columns with the names of REAL hold numbers."""
    columns = [ecsv.Column(n, "float64" if n in REAL else "string", f"what {n} is") for n in names]
    return ecsv.to_text(ecsv.Table(columns, [dict(zip(names, row)) for row in rows]))


def finding(value, error=0.0, unit="", id="x"):
    return Finding("p", id, value, error, unit)


class Scratch(unittest.TestCase):
    """A small repository, in which the test stands: one chapter, two statements, three results, one figure."""

    def setUp(self):
        self.root = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.root)
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\nIt is [](statement:a.one), not [](cell:results/name=two/value). */\n")
        self.write("paper/claims.ecsv", table(CLAIMS, [
            ["a.one", "1", "Fig. demo", "one", "1.02", "", "about", "", "", "they erred", "their ruler", "discrepant"],
            ["a.two", "1", "text", "two", "yes", "", "", "of {a.one}, Section wells", "", "", "", "holds"]]))
        self.write("src/statements/sec1_demo.cpp", STATEMENTS)
        self.write("paper/converged.ecsv", table(LOCK, [
            ["sec1_demo", "answer", "a.one", 1.0000000000000002, 1e-3, "m"],
            ["sec1_demo", "cell", "results/name=two/value", 2.0, 0.1, ""]]))
        self.write("figures/figures.ecsv", table(FIGURES, [
            ["01", "demo", "1", "sec1_demo", "fig01.gp", "results", "A line.", "(a–c) At $t = \\frac12$."]]))
        self.write("paper/costs.ecsv", table(["program", "seconds"], [["sec1_demo", 3.0]]))
        self.write("codemeta.json", ecsv.text_of(ROOT / "codemeta.json"))
        self.write("README.md", "<!-- discrepant -->\n<!-- /discrepant -->\n")
        self.results(*RESULTS_OF_DEMO)

    def write(self, name, text):
        ecsv.write_whole(self.root / name, text)

    def read(self, name):
        return ecsv.text_of(self.root / name)

    def change(self, name, old, new):
        """Puts `new` where `old` stands in a file."""
        self.assertIn(old, text := self.read(name))
        self.write(name, text.replace(old, new))

    def judged(self, verdict="discrepant", one=1.0):
        """What `verdicts` would have written."""
        nan = float("nan")
        self.report(["claims", "a.one", one, 1e-3, "m", 0.0, verdict, "1 +- 1e-3 m", "judged", "sec1_demo"],
                    ["claims", "a.two", nan, nan, "", 0.0, "holds", "results.value: 1 < 2 +- 0.1", "judged", "sec1_demo"])

    def report(self, *rows):
        columns = ["list", "id", "value", "error", "unit", "failures", "verdict", "found", "state", "program"]
        self.write("build/report/claims.ecsv", table(columns, rows))

    def beside(self, what, columns, *rows):
        """A table that `verdicts` would have written beside it."""
        self.write(f"build/report/claims_{what}.ecsv", table(columns, rows))

    def results(self, *rows):
        self.computed("sec1_demo/results.ecsv", table(RESULTS, rows))

    def computed(self, name, text):
        """Writes a table as a program does, with a new list of all that are there."""
        path = self.root / "build/data" / name
        ecsv.write_whole(path, text)
        sums = [f"{ecsv.sha256(ecsv.text_of(one))}  {one.name}\n" for one in sorted(path.parent.glob("*.ecsv")) if one.stem != "run"]
        made = [{"what": "build", "value": "GNU 12"}, {"what": "libraries", "value": "GSL 2.7.1"}]
        ecsv.write_whole(path.with_name("run.ecsv"), ecsv.to_text(ecsv.Table([ecsv.Column("what"), ecsv.Column("value")], made)))
        ecsv.write_whole(path.with_name("SHA256SUMS"), "".join(sums))

    def program(self, before=""):
        """A program with a command, that says so in the form of ours."""
        path = self.root / "build/bin/sec1_demo"
        self.write("build/bin/sec1_demo", f"#!/bin/sh\n{before}cat <<'END'\n{table(DESCRIPTION, OPTIONS)}END\n")
        path.chmod(0o755)
        return path

    def lineage(self, verb, *more):
        """Exit code, standard output and error of a verb."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = main([verb, *more])
            except SystemExit as left:
                code = left.code
        return code, out.getvalue(), err.getvalue()

    def refuses(self, verb, *words, code=1, lines=1):
        """The verb, with its words, answers in one line that has these words."""
        got, out, err = self.lineage(*verb.split())
        self.assertEqual((got, out), (code, ""), err)
        self.assertEqual(err.count("\n"), lines, err)
        for word in words:
            self.assertIn(word, err)
