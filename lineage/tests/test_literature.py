"""Numbers of other authors: what has been read is judged, and nothing else."""

import unittest

from lineage import literature

from . import ROOT, WHOLE, Scratch, of_volume, table

COLUMNS = list(literature.COLUMNS)
GOOD = ["fact", "what it is", "2.0", "", "converged", "abs 0.5", "sec1_demo", "text", "reproduced", "An author (1999)", "page 1", ""]


def row(**changed):
    return [changed.get(name, cell) for name, cell in zip(COLUMNS, GOOD)]


class Literature(Scratch):
    def there_is(self, *rows):
        self.write("paper/literature.ecsv", table(COLUMNS, rows))

    def test_what_was_read_is_judged(self):
        self.there_is(row())
        self.assertIn("literature : 1 reproduced, 0 from memory", self.lineage("summary")[1])
        self.there_is(row(printed="3.0"))
        self.assertIn("discrepant fact", self.lineage("summary")[1])
        self.there_is(row(printed="3.0", obtained="memory", status=""))
        self.assertIn("literature : 1 from memory without a verdict", self.lineage("summary")[1])

    def test_a_row_that_could_not_be_judged_is_refused(self):
        for words, changed in [("obtained 'hearsay' (allowed: text", {"obtained": "hearsay"}), ("a verdict on what has been read", {"status": ""}),
                               ("a verdict on what has been read", {"obtained": "memory"}), ("the tolerance 'some' is none", {"tolerance": "some"})]:
            self.there_is(row(**changed))
            self.refuses("refresh", "paper/literature.ecsv: row 1", words)

    @of_volume
    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_here_six_numbers_of_three_sources_were_read(self):
        read = [row for row in literature.read_literature(ROOT / "beyond").values() if row["status"]]
        self.assertGreaterEqual(len(read), 6)
        self.assertGreaterEqual(len({row["citation"] for row in read}), 3)
        self.assertTrue(all(row["where"] for row in read))
