"""The record of the bytes: what is compared, what is said, and that sha256sum reads it."""

import subprocess
from unittest import mock

from lineage import ecsv, hashes

from common import RESULTS_OF_DEMO, VOLUME, Scratch, of_volume, table

NAME = "sec1_demo/results.ecsv"
RESULTS, RECORD = f"build/data/{NAME}", "paper/full.sha256"


class Hashes(Scratch):
    def setUp(self):
        super().setUp()
        self.judged()
        self.says(0)

    def says(self, code, *words, check=False):
        """What is answered when bytes are recorded, or compared, which has these words."""
        got, out, err = self.lineage("accept", *["--check"] * check)
        self.assertEqual(got, code, out + err)
        for word in words:
            self.assertIn(word, out + err)

    def test_a_digit_counts_and_a_table_and_not_where_a_program_was_built(self):
        self.change("build/data/sec1_demo/run.ecsv", "GNU 12", "GNU 14")
        self.says(0, "1 of 1 tables are as recorded", check=True)
        self.computed(NAME, self.read(RESULTS).replace("two,2,", "two,2.0000000000000004,"))
        self.says(1, f"differs  {RESULTS}: not the bytes that are recorded\n", "0 of 1 tables", check=True)
        self.change("build/data/sec1_demo/run.ecsv", "GNU 12", "GNU 14")
        with mock.patch("platform.machine", return_value="aarch64"):
            self.says(hashes.OTHER_PROCESSOR, "here     aarch64, GNU 14, GSL 2.7.1\n", "GNU 12, GSL 2.7.1\n", check=True)
        self.computed("sec1_demo/new.ecsv", table(["value"], [[1.0]]))
        self.change(RECORD, NAME, f"sec1_demo/gone.ecsv\n{'0' * 64}  {NAME}")
        self.says(1, "new.ecsv: not recorded", "gone.ecsv: recorded and not there", check=True)
        self.says(0, "new      sec1_demo/new.ecsv\n", "gone     sec1_demo/gone.ecsv\n", f"moved    {NAME}\n")

    def test_sha256sum_reads_it(self):
        run = subprocess.run(["sha256sum", "--strict", "-c", f"../../{RECORD}"], cwd="build/data", capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, f"{NAME}: OK\n", ""))

    def test_nothing_is_recorded_of_a_quick_run_or_one_that_was_changed_or_did_not_finish(self):
        record = self.read(RECORD)

        def refused(words):
            self.says(1, words)
            self.assertEqual(self.read(RECORD), record)

        self.computed(NAME, self.read(RESULTS).replace("# schema", "# - {parameters: 'quick = yes'}\n# schema"))
        refused(f"{RESULTS}: from a quick run; remove")
        self.results(*RESULTS_OF_DEMO)
        self.change(RESULTS, "two,2,", "two,3,")
        refused(f"{NAME}: not as SHA256SUMS has it; remove it to recompute it")
        (self.root / "build/data/sec1_demo/SHA256SUMS").unlink()
        refused("sec1_demo did not finish")

    @of_volume
    def test_this_record_is_complete(self):
        record = ecsv.sums_of(hashes.record_of(VOLUME))
        self.assertEqual({name.partition("/")[0] for name in record}, set(hashes.programs_of(VOLUME)))
        self.assertEqual(list(record), sorted(record))
