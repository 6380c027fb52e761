"""The record of the bytes: what counts, what is said, what is kept by hand."""

from unittest import mock

from lineage import ecsv, hashes

from . import FACTS_OF_DEMO, VOLUME, Scratch, of_volume, of_run, table


class Hashes(Scratch):
    def setUp(self):
        super().setUp()
        self.quick("1")
        self.renew()

    def quick(self, value, quick="yes"):
        self.computed("sec1_demo/facts.ecsv", of_run(quick, table(["quantity", "value"], [["one", float(value)]])), "build/quick/data")

    def call(self, *more):
        code, out, err = self.lineage("hashes", *more)
        return code, out + err

    def renew(self):
        code, said = self.call()
        self.assertEqual(code, 0, said)
        return said

    def leave_out(self, names, reason):
        record, meta = hashes.read_record(self.root)
        record["sec1_demo", "facts"].left_out, record["sec1_demo", "facts"].reason = names, reason
        rows = [dict(zip((c.name for c in hashes.COLUMNS), (*key, *vars(e).values()))) for key, e in record.items()]
        self.write("paper/hashes.ecsv", ecsv.to_text(ecsv.Table(hashes.COLUMNS, rows, meta)))

    def test_what_is_recorded_is_found_again(self):
        self.assertEqual(self.call("--check"), (0, "hashes     : 1 of 1 tables of the full run have the recorded bytes\n"))

    def test_a_header_does_not_count_and_the_last_digit_does(self):
        name, text = "build/data/sec1_demo/facts.ecsv", self.read("build/data/sec1_demo/facts.ecsv")
        self.write(name, "# another machine\n" + text)
        self.assertEqual(self.call("--check")[0], 0)
        self.write(name, text.replace("fact,2,", "fact,2.0000000000000004,"))
        code, said = self.call("--check")
        self.assertEqual(code, 1, said)
        self.assertIn(f"differs  {name}: not the bytes that are recorded\n", said)
        self.assertIn("0 of 1 tables", said)

    def test_another_platform_tells_the_row(self):
        self.write("twin/sec1_demo/facts.ecsv", self.read("build/data/sec1_demo/facts.ecsv"))
        self.facts(*FACTS_OF_DEMO[:2], ["fact", 2.5, 0.1, ""])
        self.assertIn("row 3, value: 2.5 instead of 2.0 (1 of 3 rows differ)",
                      self.call("--check", "--against", "twin")[1])

    def test_another_processor_is_no_failure(self):
        self.facts(["fact", 2.5, 0.1, ""])
        with mock.patch("platform.machine", return_value="aarch64"):
            self.assertEqual(self.call("--check")[0], hashes.OTHER_PROCESSOR)

    def test_a_table_more_or_less_is_told(self):
        self.computed("sec1_demo/speeds.ecsv", table(["value"], [[1.0]]))
        self.renew()
        speeds = self.root / "build/data/sec1_demo/speeds.ecsv"
        self.computed("sec1_demo/new.ecsv", ecsv.text_of(speeds))
        speeds.unlink()
        self.computed("sec1_demo/facts.ecsv", self.read("build/data/sec1_demo/facts.ecsv"))
        code, said = self.call("--check")
        self.assertEqual(code, 1)
        self.assertIn("new.ecsv: not recorded", said)
        self.assertIn("speeds.ecsv: recorded and not there", said)

    def test_the_quick_run_has_its_own_bytes(self):
        self.quick("2")
        self.assertEqual(self.call("--check")[0], 0)
        self.assertEqual(self.call("--check", "--run", "quick", "--data", "build/quick/data")[0], 1)
        self.assertIn("moved    sec1_demo facts: quick\n", self.renew())

    def test_each_folder_has_runs_of_its_kind(self):
        """And tables that were not changed since: else nothing is recorded."""
        record = self.read("paper/hashes.ecsv")

        def refused(words, *more):
            code, said = self.call(*more)
            self.assertEqual((code, said.count("\n")), (1, 1), said)
            self.assertIn(words, said)
            self.assertEqual(self.read("paper/hashes.ecsv"), record)

        self.quick("1", "no")
        refused("quick/data/sec1_demo/facts.ecsv: of a full run; remove")
        self.quick("1")
        self.computed("sec1_demo/facts.ecsv", of_run("yes", self.read("build/data/sec1_demo/facts.ecsv")))
        for more in ((), ("--check",)):
            refused("build/data/sec1_demo/facts.ecsv: of a quick run; remove", *more)
        self.facts(*FACTS_OF_DEMO)
        name, text = "build/data/sec1_demo/facts.ecsv", self.read("build/data/sec1_demo/facts.ecsv")
        self.write(name, text.replace("fact,2,", "fact,3,"))
        refused("sec1_demo/facts.ecsv: not what sec1_demo wrote; remove it to have it computed again")

    def test_a_row_or_a_column_is_left_out_by_hand_and_with_a_reason(self):
        for names, same, other in [("fact", ["other", 1.0, 0.0, ""], ["other", 1.5, 0.0, ""]),
                                   ("error", ["other", 1.5, 7.0, ""], ["other", 1.25, 7.0, ""])]:
            self.leave_out(names, "rounding")
            self.renew()
            for row, code in ((same, 0), (other, 1)):
                self.facts(FACTS_OF_DEMO[0], row, ["fact", 2.5, 0.2, ""])
                self.assertEqual(self.call("--check")[0], code)
            self.renew()
            self.assertEqual(hashes.read_record(self.root)[0]["sec1_demo", "facts"].reason, "rounding")
        self.leave_out("fact", "")
        self.assertIn("with a reason", self.call("--check")[1])

    def test_a_run_that_did_not_finish_is_not_recorded(self):
        (self.root / "build/quick/data/sec1_demo/facts.ecsv").unlink()
        code, said = self.call()
        self.assertEqual((code, said.count("\n")), (1, 1))
        self.assertIn("sec1_demo did not finish", said)

    @of_volume
    def test_this_record_is_complete(self):
        record = hashes.read_record(VOLUME)[0]
        self.assertEqual({p for p, t in record if t == "facts"}, set(hashes.programs_of(VOLUME)))
