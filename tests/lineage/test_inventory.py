"""Tables and commands as they describe themselves."""

from lineage import ecsv, inventory

from common import HELP, Scratch


class Inventory(Scratch):
    def test_a_program_is_asked_what_it_can(self):
        self.program()
        rows = [tuple(row.values())[1:] for row in inventory.commands(self.root, self.root / "build/bin")]
        self.assertEqual(rows, [
            ("", "", "", "A demonstration (section 1)"), ("", "--help", "", "this text"),
            ("one", "", "", "one thing, of two"), ("one", "--help", "", "this text"),
            ("one", "--speed", "[0, 1]", "how fast it is, in sites (default: 0.5)"),
            ("one", "--well", "none, harmonic, quartic, pendulum", "well of every bead")])
        self.assertEqual(list(inventory.commands(self.root, self.root / "none")), [])
        self.write("build/bin/sec1_demo", HELP.replace("#!/bin/sh\n", "#!/bin/sh\nexit 3\n"))
        with self.assertRaisesRegex(ecsv.Fault, "sec1_demo: cannot print its help"):
            list(inventory.commands(self.root, self.root / "build/bin"))

    def test_a_table_describes_its_columns(self):
        rows = list(inventory.tables(self.root, self.root / "build/data"))
        self.assertEqual([(r["table"], r["column"]) for r in rows],
                         [("facts", c) for c in ("quantity", "value", "error", "unit", "made_by")])
        self.assertEqual(rows[1]["kind"] + ", " + rows[1]["description"], "float64, what value is")
