"""Commands as they describe themselves."""

from lineage import ecsv, inventory

from common import Scratch


class Inventory(Scratch):
    def test_a_program_is_asked_what_it_can(self):
        program = self.program()
        rows = list(inventory.commands(self.root, self.root / "build/bin"))
        self.assertEqual([(row["program"], row["command"], row["option"], inventory.allowed(row)) for row in rows], [
            ("sec1_demo", "", "", ""), ("sec1_demo", "", "help", ""), ("sec1_demo", "one", "", ""), ("sec1_demo", "one", "speed", "[1e-06, 1] m/s"),
            ("sec1_demo", "one", "well", "none, quartic"), ("sec1_demo", "one", "s", "[-1, 2]")])
        self.assertEqual(inventory.wells(program), {"none": [], "quartic": ["s"]})
        self.assertEqual(list(inventory.commands(self.root, self.root / "none")), [])
        self.program("exit 3\n")
        with self.assertRaisesRegex(ecsv.Fault, "sec1_demo: cannot describe itself"):
            list(inventory.commands(self.root, self.root / "build/bin"))
