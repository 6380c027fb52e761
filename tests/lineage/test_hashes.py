"""The record of the bytes: what is compared, what is said, and that sha256sum reads it."""

import subprocess
from unittest import mock

from lineage import ecsv, hashes

from common import RESULTS_OF_DEMO, ROOT, VOLUME, Scratch, of_volume, of_run, table

NAME = "sec1_demo/results.ecsv"
RESULTS, RECORD = f"build/data/{NAME}", "paper/full.sha256"


class Hashes(Scratch):
    def setUp(self):
        super().setUp()
        self.quick("1")
        self.judged()
        self.says(0)

    def quick(self, value, quick="yes"):
        self.computed(NAME, of_run(quick, table(["quantity", "value"], [["one", float(value)]])), "build/quick/data")

    def says(self, code, *words, check=None):
        """What is answered when bytes are recorded, or compared, which has these words."""
        got, out, err = self.lineage("accept") if check is None else self.lineage("hashes", *check.split())
        self.assertEqual(got, code, out + err)
        for word in words:
            self.assertIn(word, out + err)
        return out + err

    def test_a_digit_counts_and_a_header_and_not_where_a_program_was_built(self):
        text = self.read(RESULTS)
        self.change("build/data/sec1_demo/run.ecsv", "GNU 12", "GNU 14")
        self.assertEqual(self.says(0, check=""), "bytes      : 1 of 1 tables of the full run are as recorded\n")
        self.write(f"twin/{NAME}", text)
        for old, new, words in [("two,2,", "two,2.0000000000000004,", "row 3, value: 2.0000000000000004 instead of 2.0 (1 of 3 rows differ)"),
                                ("what value is", "of both", "another header"), ("two,2,", "two,2.0,", "other spelling"),
                                ("two,2,0.10000000000000001\n", "", "2 rows instead of 3")]:
            self.write(RESULTS, text)
            self.change(RESULTS, old, new)
            self.says(1, f"differs  {RESULTS}: not the bytes that are recorded; {words}\n", "0 of 1 tables", check="--against twin")
        with mock.patch("platform.machine", return_value="aarch64"):
            self.says(hashes.OTHER_PROCESSOR, "here     aarch64, GNU 14, GSL 2.7.1\n", "GNU 12, GSL 2.7.1\n", check="")

    def test_a_table_more_or_less_is_told(self):
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0]]))
        self.says(0, "new      sec1_demo/speeds.ecsv (full)\n")
        speeds = self.root / "build/data/sec1_demo/speeds.ecsv"
        speeds.rename(speeds.with_name("new.ecsv"))
        self.computed(NAME, self.read(RESULTS))
        self.says(1, "new.ecsv: not recorded", "speeds.ecsv: recorded and not there", check="")
        self.says(0, "new      sec1_demo/new.ecsv (full)\n", "gone     sec1_demo/speeds.ecsv (full)\n")

    def test_what_has_not_run_is_not_compared_and_what_did_not_finish_is(self):
        self.change(RECORD, NAME, f"sec2_other/results.ecsv\n{'0' * 64}  {NAME}")
        self.says(1, "0 of 1 tables", check="")
        (self.root / "build/data/sec2_other").mkdir()
        self.says(1, "build/data/sec2_other/results.ecsv: recorded and not there", check="")

    def test_the_quick_run_has_its_own_bytes(self):
        self.quick("2")
        self.says(0, check="")
        self.says(1, check="--run quick --data build/quick/data")
        self.says(0, f"moved    {NAME} (quick)\n")

    def test_sha256sum_reads_it(self):
        def check():
            return subprocess.run(["sha256sum", "--strict", "-c", f"../../{RECORD}"], cwd="build/data", capture_output=True, text=True, check=False)

        self.assertEqual((check().returncode, check().stdout, check().stderr), (0, f"{NAME}: OK\n", ""))
        self.change(RESULTS, "two,2,", "two,3,")
        self.assertEqual(check().returncode, 1)

    def test_nothing_is_recorded_of_a_run_of_another_kind_or_that_was_changed_or_did_not_finish(self):
        record = self.read(RECORD), self.read("paper/quick.sha256")

        def refused(words, check=None):
            self.says(1, words, check=check)
            self.assertEqual((self.read(RECORD), self.read("paper/quick.sha256")), record)

        self.results(["one", 2.0, 1e-3])
        self.quick("1", "no")
        refused(f"quick/data/{NAME}: from a full run; remove")
        self.quick("1")
        self.computed(NAME, of_run("yes", self.read(RESULTS)))
        for check in (None, ""):
            refused(f"{RESULTS}: from a quick run; remove", check)
        self.results(*RESULTS_OF_DEMO)
        self.change(RESULTS, "two,2,", "two,3,")
        refused(f"{NAME}: not as SHA256SUMS has it; remove it to recompute it")
        (self.root / "build/quick/data/sec1_demo/SHA256SUMS").unlink()
        self.results(*RESULTS_OF_DEMO)
        refused("sec1_demo did not finish")

    @of_volume
    def test_this_record_is_complete(self):
        for run in hashes.RUNS:
            record = ecsv.sums_of(hashes.record_of(VOLUME, run))
            self.assertEqual({name.partition("/")[0] for name in record}, set(hashes.programs_of(VOLUME)))
            self.assertEqual(list(record), sorted(record))
