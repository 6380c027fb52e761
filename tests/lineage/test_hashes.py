"""The record of the bytes: what counts, what is said, what is kept by hand."""

from unittest import mock

from lineage import hashes

from common import FACTS_OF_DEMO, VOLUME, Scratch, of_volume, of_run, table

FACTS, RECORD = "build/data/sec1_demo/facts.ecsv", "paper/hashes.ecsv"


class Hashes(Scratch):
    def setUp(self):
        super().setUp()
        self.quick("1")
        self.judged()
        self.says(0)

    def quick(self, value, quick="yes"):
        self.computed("sec1_demo/facts.ecsv", of_run(quick, table(["quantity", "value"], [["one", float(value)]])), "build/quick/data")

    def says(self, code, *words, check=None):
        """What is answered when bytes are recorded, or compared, which has these words."""
        got, out, err = self.lineage("accept") if check is None else self.lineage("hashes", *check.split())
        self.assertEqual(got, code, out + err)
        for word in words:
            self.assertIn(word, out + err)
        return out + err

    def test_a_header_does_not_count_and_the_last_digit_does(self):
        text = self.read(FACTS)
        self.write(FACTS, "# another machine\n" + text)
        said = self.says(0, check="")
        self.assertEqual(said, "bytes      : 1 of 1 tables of the full run are as recorded\n")
        self.write("twin/sec1_demo/facts.ecsv", text)
        self.write(FACTS, text.replace("fact,2,", "fact,2.0000000000000004,"))
        self.says(1, f"differs  {FACTS}: not the bytes that are recorded", "0 of 1 tables", "row 3, value: 2.0000000000000004 "
                  "instead of 2.0 (1 of 3 rows differ)", check="--against twin")
        with mock.patch("platform.machine", return_value="aarch64"):
            self.says(hashes.OTHER_PROCESSOR, check="")

    def test_a_table_more_or_less_is_told(self):
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0]]))
        self.says(0, "new      sec1_demo speeds")
        speeds = self.root / "build/data/sec1_demo/speeds.ecsv"
        speeds.rename(speeds.with_name("new.ecsv"))
        self.computed("sec1_demo/facts.ecsv", self.read(FACTS))
        self.says(1, "new.ecsv: not recorded", "speeds.ecsv: recorded and not there", check="")

    def test_the_quick_run_has_its_own_bytes(self):
        self.quick("2")
        self.says(0, check="")
        self.says(1, check="--run quick --data build/quick/data")
        self.says(0, "moved    sec1_demo facts: quick\n")

    def test_nothing_is_recorded_of_a_run_of_another_kind_or_that_was_changed_or_did_not_finish(self):
        record = self.read(RECORD)

        def refused(words, check=None):
            self.says(1, words, check=check)
            self.assertEqual(self.read(RECORD), record)

        self.quick("1", "no")
        refused("quick/data/sec1_demo/facts.ecsv: from a full run; remove")
        self.quick("1")
        self.computed("sec1_demo/facts.ecsv", of_run("yes", self.read(FACTS)))
        for check in (None, ""):
            refused(f"{FACTS}: from a quick run; remove", check)
        self.facts(*FACTS_OF_DEMO)
        self.change(FACTS, "fact,2,", "fact,3,")
        refused("sec1_demo/facts.ecsv: changed since sec1_demo wrote it; remove it to recompute it")
        (self.root / "build/quick/data/sec1_demo/facts.ecsv").unlink()
        self.facts(*FACTS_OF_DEMO)
        refused("sec1_demo did not finish")

    def test_rows_and_columns_are_left_out_by_hand_and_with_a_reason(self):
        self.change(RECORD, ',"",""', ",fact error,rounding")
        self.says(0)
        for row, code in ((["other", 1.0, 7.0, ""], 0), (["other", 1.5, 0.0, ""], 1)):
            self.facts(FACTS_OF_DEMO[0], row, ["fact", 2.5, 0.2, ""])
            self.says(code, check="")
        self.says(0)
        self.change(RECORD, ",fact error,rounding", ',fact error,""')
        self.says(1, "needs a reason", check="")

    @of_volume
    def test_this_record_is_complete(self):
        record = hashes.read_record(VOLUME)[0]
        self.assertEqual({p for p, t in record if t == "facts"}, set(hashes.programs_of(VOLUME)))
