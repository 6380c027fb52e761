"""Commands as they describe themselves."""

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
