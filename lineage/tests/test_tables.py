"""The reader of tables and digits, and what is said of files that cannot be used."""

import math
import random
import re
import sys
import unittest
from unittest import mock

from lineage import ecsv
from lineage.claims import quoted_in, said

from . import LOCK, Scratch, finding, of_run, table


class Tables(unittest.TestCase):
    def test_what_is_written_is_read(self):
        rows = [{"a": "it's, \"so\" #1", "b": 0.1, "c": 3}, {"a": "", "b": math.inf, "c": -1}]
        columns = [ecsv.Column("a", "string", "l'un"), ecsv.Column("b", "float64", "x", "m"), ecsv.Column("c", "int64", "n")]
        text = ecsv.to_text(ecsv.Table(columns, rows, {"title": "it's"}))
        read = ecsv.parse(text)
        self.assertEqual((read.columns, read.rows, read.meta), (columns, rows, {"title": "it's"}))
        self.assertEqual(ecsv.to_text(read), text)
        self.assertIn("0.10000000000000001", text)

    def test_what_cannot_be_read_is_one_line(self):
        good = table(LOCK, [["p", "a", 1.0, 0.0, "", "value"], ["p", "b", 2.0, 0.0, "", "value"]])
        for bad, message in [("", "t: no table (it is empty)"), (good[:300], "t: no table (it ends in its header)"),
                             (good[:-9], "row 2: 5 cells under 6 columns"), (good[:-1], "t: row 2: the file is cut off"),
                             (good.replace("p,b,2", "p,b,two"), "t: row 2: 'two' in the column 'value' is not a number"),
                             (good.replace("p,b,", 'p,"b,'), "t: quotes that do not close"),
                             (good.replace("program,id", "program,name"), "names above the rows")]:
            with self.assertRaises(ecsv.Fault) as caught:
                ecsv.parse(bad, "t")
            self.assertIn(message, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(ecsv.Fault, "no column 'x'"):
            ecsv.parse(good, "t", ["x"])
        with self.assertRaisesRegex(ecsv.Fault, "nowhere.ecsv is missing"):
            ecsv.read("nowhere.ecsv")

    def test_numbers_are_those_of_the_other_reader(self):
        """As tests/report/table.cpp asks of src/report/table.cpp: no blanks, no underscores, nothing too large."""
        real, whole = ecsv.Column("x", "float64"), ecsv.Column("k", "int64")
        for text, number in [("031", 31), ("+31", 31), ("3.1e+01", 31), (".5", 0.5), ("-5e-324", -5e-324), ("0e9", 0)]:
            self.assertEqual(ecsv.value_of(text, real), number)
        for text in (" 1", "1 ", "1_0", "0x1f", "1e", "--1", "+-1", "+", "one", "1e999", "1e-999", "1,5", "\u0663", "1\r"):
            self.assertRaises(ValueError, ecsv.value_of, text, real)
        for text in ("", "+1", " 1", "1.0", "1_0", "9223372036854775808", "1" * 5000, "\u0663"):
            self.assertRaises(ValueError, ecsv.value_of, text, whole)
        self.assertEqual(ecsv.value_of("-9223372036854775808", whole), -2 ** 63)

    def test_no_text_makes_the_reader_fail_otherwise(self):
        """Letters lost, doubled, changed or moved: a text is refused as a Fault of one line, or its rows fit."""
        columns = [ecsv.Column("a", "string", "l'un"), ecsv.Column("b", "float64", "x", "m"), ecsv.Column("c", "int64", "n")]
        good = ecsv.to_text(ecsv.Table(columns, [{"a": 'so, "it" #', "b": 0.1 * k, "c": k} for k in range(4)], {"title": "t"}))
        chance, letters, count = random.Random(20130601), "\"',\n#{}:-+.0eE\r\\ na_\x00\x85\u2028\u0663", [0, 0]
        for _ in range(3000):
            text = good
            for _ in range(chance.randint(1, 4)):
                at, length = chance.randrange(len(text) + 1), chance.randrange(12)
                piece = chance.choice(["", chance.choice(letters), text[at // 2:at // 2 + length]])
                text = text[:at] + piece + text[at + chance.choice([0, len(piece), length]):]
            try:
                table = ecsv.parse(text, "t")
            except ecsv.Fault as fault:
                count[0] += 1
                self.assertNotIn("\n", str(fault).replace(text, ""))
                continue
            count[1] += 1
            for row in table.rows:
                self.assertEqual(list(row), [c.name for c in table.columns])
        self.assertGreater(min(count), 300)

    def test_a_number_shows_the_digits_that_its_error_allows(self):
        for f, shown in [
                (finding(1.6242247200089819e-11, 4e-20), "1.62422e-11"), (finding(-7.5714e-08, 1e-10), "-7.57e-8"),
                (finding(0.00091771471, 1.17e-06), "0.000918"), (finding(1.4978440800419035, 0.0057), "1.498"),
                (finding(857.52737275438153, 0.0036), "857.527"), (finding(24934.60966977202, 0.104), "24934.6"),
                (finding(2.0000000000000004, 5e-17), "2.00000"), (finding(7e-15, 4e-14), "7e-15"),
                (finding(500, 200), "5e2"), (finding(14), "14"), (finding(-3), "-3"), (finding(0), "0"),
                (finding(1.5), "1.5"), (finding(1.0009999999999999), "1.001"), (finding(1753921.9), "1.75392e6"),
                (finding(1.75e19), "1.75e19"), (finding(4.3822562009170496e-16, 0, "", "residue"), "4e-16"),
                (finding(math.nan, 1), "nan"), (finding(-math.inf), "-inf"), (finding(1, math.nan), "1")]:
            self.assertEqual(f.shown, shown)
        self.assertEqual([finding(1, e).shown_error for e in (3.7e-9, 0)], ["4e-9", "exact"])


class Words(unittest.TestCase):
    def test_our_numbers_in_the_list_of_claims(self):
        self.assertEqual(said("It is {p.q}, {not a name}.", {"p.q": finding(1.25, 1e-3)}), "It is 1.250, {not a name}.")
        with self.assertRaisesRegex(ecsv.Fault, "nothing is known of 'p.none'"):
            said("{p.none}", {})

    def test_what_a_row_mentions(self):
        row = {"sentence": "It is [](num:a.one).", "criterion": "sec1_demo.fact > 1; sec1_demo.other < sec2_why.so", "answer": "",
               "assumption": "with {sec1_demo.q}", "covered_by": "a.two^2"}
        self.assertEqual(quoted_in(row), {"a.one", "sec1_demo.fact", "sec1_demo.other", "sec2_why.so", "sec1_demo.q", "a.two"})
        self.assertEqual(quoted_in({"answer": "sec1_demo.x", "covered_by": "method"}), {"sec1_demo.x"})


class Faults(Scratch):
    """Each is one line that names file and row, and an exit code."""

    def test_a_claim_given_twice(self):
        path, text = "paper/claims.ecsv", self.read("paper/claims.ecsv")
        self.write(path, text + text.splitlines()[-1].replace('two,yes', 'again,yes') + "\n")
        for verb in ("show a.one", "lock", "refresh", "macros"):
            self.refuses(verb, "claims.ecsv: row 3: two claims for 'a.two' (the first: row 2)")

    def test_facts_that_mean_nothing(self):
        self.facts(["fact", 1.0, 0.1, ""], ["fact", 1.0, 0.1, ""])
        self.refuses("lock", "sec1_demo/facts.ecsv: row 2: two values for 'fact'")
        self.facts(["fact", 1.0, -0.1, ""])
        self.refuses("lock", "facts.ecsv: row 1: fact: the error -0.1 is negative")

    def test_files_that_are_not_whole(self):
        path = "build/data/sec1_demo/facts.ecsv"
        good = self.read(path)
        self.write(path, "")
        self.refuses("lock", "sec1_demo/facts.ecsv: no table (it is empty)")
        self.write(path, good[:-12])
        self.refuses("lock", "sec1_demo/facts.ecsv: row 3: ", "cut off")
        # Whole, and not what the program wrote: a digit, a row less, no checksums
        self.write(path, good.replace("one,1,", "one,2,"))
        for verb in ("show a.one", "lock"):
            self.refuses(verb, "sec1_demo/facts.ecsv: not what sec1_demo wrote")
        self.write(path, "".join(good.splitlines(True)[:-1]))
        self.refuses("lock", "sec1_demo/facts.ecsv: not what sec1_demo wrote")
        self.write(path, re.sub("# - {tables: .*\n", "", good))
        self.refuses("lock", "facts.ecsv: not what sec1_demo wrote")
        self.write(path, good)
        self.write("paper/converged.ecsv", self.read("paper/converged.ecsv").replace("m,value", "m,vaule"))
        self.refuses("refresh", "converged.ecsv: row 1: one: the kind 'vaule' is none")
        (self.root / "build/data").rename(self.root / "build/gone")
        self.refuses("lock", "build/data is missing: compute it first")
        (self.root / "paper/converged.ecsv").unlink()
        self.refuses("macros", "converged.ecsv is missing")

    def test_tables_that_no_number_is_read_from(self):
        """Who changes one, or takes one away, stops everything that reads the run."""
        path, verbs = "build/data/sec1_demo/speeds.ecsv", ("tables", "lock", "show a.one", "inventory")
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0], [2.0]]))
        good = self.read(path)
        self.write(path, good.replace("\n2\n", "\n3\n"))
        for verb in verbs:
            self.refuses(verb, "build/data/sec1_demo/speeds.ecsv: not what sec1_demo wrote; remove it to have it computed again")
        self.write("build/data/sec1_demo/older.ecsv", good)
        self.refuses("tables", "older.ecsv: not what sec1_demo wrote", "speeds.ecsv: not", lines=2)
        (self.root / "build/data/sec1_demo/older.ecsv").unlink()
        (self.root / path).unlink()
        for verb in verbs[1:]:
            self.refuses(verb, "build/data/sec1_demo/speeds.ecsv is missing")
        facts = self.read("build/data/sec1_demo/facts.ecsv")
        self.assertEqual(self.lineage("tables"), (0, f"  missing  {path}: its program runs again\n", ""))
        self.assertFalse((self.root / "build/data/sec1_demo/facts.ecsv").exists())
        self.write("build/data/sec1_demo/facts.ecsv", re.sub("# - {tables: .*\n", "", facts))
        self.assertIn("facts.ecsv with checksums: its program runs again", self.lineage("tables")[1])
        self.write("build/data/sec1_demo/facts.ecsv", facts)
        self.write(path, "# a header does not count\n" + good)
        self.write("apt-packages.txt", "")
        for verb in verbs:
            self.assertEqual(self.lineage(*verb.split())[0], 0, verb)

    def test_quick_tables_are_for_quick_folders(self):
        path = "sec1_demo/facts.ecsv"
        text = of_run("yes, and = more", self.read(f"build/data/{path}"))
        for data in ("build/data", "build/quick/data"):
            self.computed(path, text, data)
        for verb in ("lock", "show a.one", "inventory"):
            self.refuses(verb, "ecsv: of a quick run; remove", "build/data/sec1_demo to have it computed again")
        self.assertEqual(self.lineage("show", "a.one", "--data", "build/quick/data")[0], 0)
        self.computed(path, text.replace("quick = yes", "quick = no, not quick = yesterday"))
        self.assertEqual(self.lineage("lock")[0], 0)

    def test_rows_that_are_broken(self):
        """A cell lost, doubled or turned into a word, in what is claimed and in what is locked."""
        for path, row in [("paper/claims.ecsv", 'a.one,1,Fig. demo,one,'), ("paper/converged.ecsv", "sec1_demo,one,")]:
            good, name = self.read(path), path.rpartition("/")[2]
            for bad, message in [(good.replace(row, row + "x,"), "row 1: "), (good.replace(row, ""), "row 1: "),
                                 (good.replace(row, '"' + row), "quotes that do not close"), (good[:-1], "cut off"),
                                 (good.replace("# - {name: 'id'", "# - {name: 'di'"), "names above the rows")]:
                self.assertNotEqual(bad, good)
                self.write(path, bad)
                self.refuses("lock", name, message)
            self.write(path, good)

    def test_a_python_that_lacks_a_module_says_which(self):
        with mock.patch.dict(sys.modules, {"PIL": None}):
            self.refuses("gallery", f"lineage gallery: {sys.executable} has no module PIL (Debian: python3-pil; PYTHON=")

    def test_the_command_line(self):
        for arguments in (["lock", "--dat"], ["show"], ["show", "a.one", "a.two"]):
            code, out, err = self.lineage(*arguments)
            self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
        self.assertEqual(self.lineage("show", "a.on")[::2],
                         (2, "lineage show: ID: there is no number 'a.on' (near it: a.one, a.two)\n"))
