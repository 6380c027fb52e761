"""The reader of tables, what is said of files that cannot be used, and whether our tables are known to one per cent."""

import csv
import math
import re
import sys
import unittest
from math import isfinite, nan

from lineage import ecsv
from lineage.claims import programs_of

from common import LOCK, ROOT, VOLUME, Scratch, table

COLUMNS = [ecsv.Column("a", "string", "l'un"), ecsv.Column("b", "float64", "x", "m"), ecsv.Column("c", "int64", "n")]


class Reader(unittest.TestCase):
    def test_what_is_written_is_read(self):
        rows = [{"a": "it's, \"so\" #1", "b": 0.1, "c": 3}, {"a": "", "b": math.inf, "c": -1}]
        text = ecsv.to_text(ecsv.Table(COLUMNS, rows, {"title": "it's"}))
        read = ecsv.parse(text)
        self.assertEqual((read.columns, read.rows, read.meta), (COLUMNS, rows, {"title": "it's"}))
        self.assertEqual(ecsv.to_text(read), text)
        self.assertIn("0.10000000000000001", text)

    def test_what_cannot_be_read_is_one_line(self):
        good = table(LOCK, [["p", "cell", "a", 1.0, 0.0, "m"], ["p", "cell", "b", 2.0, 0.0, "m"]])
        for bad, message in [("", "t: not a table (it is empty)"), (good[:300], "t: not a table (it ends in its header)"),
                             (good[:-3], "row 2: 5 cells under 6 columns"), (good[:-1], "t: row 2: the file is cut off"),
                             (good.replace("b,2", "b,two"), "t: row 2: 'two' in the column 'value' is not a number"),
                             (good.replace("l,b,", 'l,"b,'), "t: unbalanced quotes"),
                             (good.replace("program,what", "program,name"), "column names above the rows")]:
            with self.assertRaises(ecsv.Fault) as caught:
                ecsv.parse(bad, "t")
            self.assertIn(message, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(ecsv.Fault, "no column 'x'"):
            ecsv.parse(good, "t", ["x"])


class Files(Scratch):
    """What is wrong with one is a line that names file and row."""

    RESULTS, SPEEDS = "build/data/sec1_demo/results.ecsv", "build/data/sec1_demo/speeds.ecsv"

    def test_what_means_nothing(self):
        text = self.read("paper/claims.ecsv")
        self.write("paper/claims.ecsv", text + text.splitlines()[-1].replace('two,yes', 'again,yes') + "\n")
        for verb in ("show a.one", "refresh", "macros"):
            self.refuses(verb, "claims.ecsv: row 3: two claims for 'a.two' (the first: row 2)")
        self.write("paper/claims.ecsv", text)
        (self.root / "build/data").rename(self.root / "build/gone")
        self.refuses("accept", "build/data is missing: compute it first")
        (self.root / "paper/converged.ecsv").unlink()
        self.refuses("macros", "converged.ecsv is missing")

    def test_a_table_that_was_changed_stops_everything_that_reads_the_run(self):
        """Also if no number is read from it."""
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0], [2.0]]))
        self.write("apt-packages.txt", "")
        changed, readers = "not as SHA256SUMS has it; remove it to recompute it", ("show a.one", "tables")
        for path, old, new, words, verbs in [
                (self.RESULTS, r"(?s).*", "", changed, readers), (self.RESULTS, r"(?s).{12}$", "", changed, readers),
                (self.RESULTS, "one,1,", "one,2,", changed, readers), (self.RESULTS, r"two,.*\n", "", changed, readers),
                (self.RESULTS, "what value is", "of both", changed, readers), (self.SPEEDS, "\n2\n", "\n3\n", changed, readers)]:
            good = self.read(path)
            self.write(path, re.sub(old, new, good, count=1))
            for verb in verbs:
                self.refuses(verb, f"{path}: {words}")
            self.write(path, good)
        self.change("build/data/sec1_demo/run.ecsv", "GNU 12", "GNU 14")
        for verb in readers:
            self.assertEqual(self.lineage(*verb.split())[0], 0, verb)
        self.write("build/data/sec1_demo/older.ecsv", good)
        self.refuses("tables", f"older.ecsv: {changed}")

    def test_a_run_that_has_lost_a_table_is_made_again(self):
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0], [2.0]]))
        (self.root / self.SPEEDS).unlink()
        self.refuses("show a.one", f"{self.SPEEDS} is missing")
        self.assertEqual(self.lineage("tables"), (0, f"  missing  {self.SPEEDS}: its program will run again\n", ""))
        self.assertFalse((self.root / "build/data/sec1_demo/SHA256SUMS").exists())


def doubts(columns, rows):
    """A complaint for each column `..._error` that is not known to one per cent, point by point, because a column may span
    decades. Its description says where another scale is meant (the largest of the column, the neighbouring rows where it
    crosses zero, or an error that is relative already), that they are known to so many per cent only, that rows may be
    `nan`, or that all may be `exact`. Of zero the least number of the type is the error."""
    for column in (c for c in columns if c.name.endswith("_error")):
        how, names = column.description, [c.name for c in columns]
        values, errors = ([float(row[names.index(name)]) for row in rows] for name in (column.name.removesuffix("_error"), column.name))
        sizes = [abs(x) if isfinite(x) else 0 for x in values]
        known = [i for i in range(len(rows)) if isfinite(values[i]) and isfinite(errors[i])]
        part = 0.01 * float((re.findall(r"known to (\d+) per cent", how) or [1])[0])
        bad = [i for i in known if not 0 <= errors[i] <= max(sys.float_info.min, part * (
            max(sizes) if "against the largest" in how else max(sizes[max(0, i - 2):i + 3]) if "against the neighbouring" in how
            else 1 if "relative" in how else sizes[i]))]
        if bad:
            yield f"{column.name}: {len(bad)} rows not known to one per cent, first {values[bad[0]]} +- {errors[bad[0]]}"
        elif not known or len(known) < len(rows) and "nan" not in how:
            yield f"{column.name}: {len(rows) - len(known)} rows are not numbers"
        elif not any(errors[i] > 0 for i in known) and "exact" not in how:
            yield f"{column.name}: every error is zero"


class Here(unittest.TestCase):
    def test_what_is_plotted_is_known_to_one_per_cent_and_says_where_it_comes_from(self):
        for values, errors, note, count in [
                ([1, 1e-6], [1e-3, 1e-9], "", 0), ([1, 1e-6], [1e-3, 1e-7], "", 1), ([1, 1e-6], [1e-3, 1e-7], "against the largest", 0),
                ([1, 1e-3, 1e-6, 1e-9], [1e-4] * 4, "against the neighbouring rows", 1), ([1, 1e-6], [1e-3, 2e-2], "relative", 1),
                ([1, 2], [0.1, 0.1], "known to 10 per cent", 0), ([1, 2], [0.11, 0.1], "known to 10 per cent", 1),
                ([nan], [nan], "nan", 1), ([1, nan], [1e-3, nan], "", 1), ([1, 1], [0, 0], "", 1)]:
            columns = [ecsv.Column("x", "float64", "a quantity"), ecsv.Column("x_error", "float64", note)]
            self.assertEqual(len(list(doubts(columns, list(zip(values, errors))))), count, (values, errors, note))
        paths = [path for folder in sorted((ROOT / "build/data").iterdir()) for path in ecsv.tables_in(folder)]
        self.assertLessEqual(set(programs_of(ROOT)), {path.parent.name for path in paths})
        for path in paths:
            with self.subTest(path):
                columns, meta = ecsv.header_of(text := ecsv.text_of(path))
                self.assertLessEqual({"program", "section", "command", "parameters"}, meta.keys())
                self.assertFalse({"revision", "build", "libraries"} & meta.keys())
                self.assertEqual(list(doubts(columns, list(csv.reader(ecsv.rows_of(text)))[1:])), [])

    def test_every_column_says_what_it_is_and_no_list_names_another(self):
        for program in programs_of(VOLUME):
            written = []
            for path in ecsv.tables_in(ROOT / "build/data" / program):
                columns = ecsv.header_of(ecsv.text_of(path))[0]
                self.assertFalse([f"{path}: src/columns does not say what {column.name} is" for column in columns if not column.description])
                written += [(path.stem, column.name) for column in columns]
            listed = VOLUME / f"src/columns/{program}.csv"
            for row in csv.DictReader(listed.open()) if listed.exists() else ():
                self.assertTrue(any(column == row["column"] and row["table"] in ("", table) for table, column in written),
                                f"{listed}: no {row['table'] or 'table'} has a column {row['column']} (src/columns)")
