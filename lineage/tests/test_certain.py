"""Is what a table shows known to one per cent? Asked point by point, because a column may span decades. The description of
the error column says where another scale is meant:

    "against the largest ..."           the largest modulus of the column
    "against the neighbouring rows"     the largest modulus of this row and two on either side (where it crosses zero)
    "relative ..."                      the error is relative already
    "... nan ..."                       values or errors may be missing, but not all
    "exact ..."                         the error may be zero everywhere
"""

import csv
import unittest
from math import isfinite, nan

from lineage import ecsv
from lineage.claims import programs_of

from . import ROOT


def scales(values, how):
    """The moduli against which the errors of a column are judged, row by row."""
    sizes = [abs(x) if isfinite(x) else 0 for x in values]
    if "against the largest" in how:
        return [max(sizes, default=0)] * len(sizes)
    if "against the neighbouring rows" in how:
        return [max(sizes[max(0, i - 2):i + 3]) for i in range(len(sizes))]
    return [1] * len(sizes) if "relative" in how else sizes


def doubts(columns, rows):
    """A complaint for each column with an error that is not known to one per cent."""
    place = {column.name: i for i, column in enumerate(columns)}
    for column in columns:
        if not column.name.endswith("_error"):
            continue
        how = column.description
        values, errors = ([float(row[place[name]]) for row in rows] for name in (column.name.removesuffix("_error"), column.name))
        scale = scales(values, how)
        known = [i for i, (x, e) in enumerate(zip(values, errors)) if isfinite(x) and isfinite(e)]
        bad = [i for i in known if not 0 <= errors[i] <= 0.01 * scale[i]]
        if bad:
            yield f"column {column.name}: {len(bad)} rows not known to one per cent, first {values[bad[0]]} +- {errors[bad[0]]}"
        elif not known:
            yield f"column {column.name}: no row has a value and an error"
        elif len(known) < len(values) and "nan" not in how:
            yield f"column {column.name}: {len(values) - len(known)} rows are not numbers"
        elif not any(errors[i] > 0 for i in known) and "exact" not in how:
            yield f"column {column.name}: every error is zero"


class Certain(unittest.TestCase):
    def test_certainty_is_asked_for_point_by_point(self):
        same, relative, gaps = [1e-3] * 5, " (relative)", "; nan where it has left"
        for values, errors, note, count in [
                ([1, 1e-6], [1e-3, 1e-9], "", 0), ([1, 1e-6], [1e-3, 1e-7], "", 1),  # ten per cent of its own
                ([1, 1e-6], [1e-3, 1e-7], ", against the largest of the column", 0), ([1, -0.5, 1e-4, 0.5, 1], same, "", 1),
                ([1, -0.5, 1e-4, 0.5, 1], same, ", against the neighbouring rows", 0),
                ([1, 1e-3, 1e-6, 1e-9], [1e-4] * 4, ", against the neighbouring rows", 1),
                ([1, 1e-6], [1e-3, 1e-3], relative, 0), ([1, 1e-6], [1e-3, 2e-2], relative, 1), ([nan, nan], [nan, nan], "", 1),
                ([nan, nan], [nan, nan], gaps, 1), ([1, nan], [1e-3, nan], gaps, 0), ([1, nan], [1e-3, nan], "", 1),
                ([1, 1], [1e-3, nan], "", 1), ([1, 1], [1e-3, -1e-3], "", 1), ([1, 1], [0, 0], "", 1), ([1, 1], [0, 0], ", exact", 0)]:
            columns = [ecsv.Column("x", "float64", "a quantity"), ecsv.Column("x_error", "float64", "two resolutions" + note)]
            self.assertEqual(len(list(doubts(columns, list(zip(values, errors))))), count, (values, errors, note))

    def test_what_is_plotted_is_known_to_one_per_cent_and_says_where_it_comes_from(self):
        paths = sorted((ROOT / "build/data").glob("*/[!.]*.ecsv"))
        self.assertLessEqual(set(programs_of(ROOT)), {path.parent.name for path in paths})
        for path in paths:
            with self.subTest(path):
                columns, meta = ecsv.header_of(text := ecsv.text_of(path))
                self.assertLessEqual({"program", "section", "command", "revision", "build"}, meta.keys())
                self.assertEqual(list(doubts(columns, list(csv.reader(ecsv.rows_of(text)))[1:])), [])
