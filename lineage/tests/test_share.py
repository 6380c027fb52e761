"""What counts as a line of physics and what as one that reports."""

import unittest

from lineage.share import shares


class Share(unittest.TestCase):
    def reporting(self, text, code, reporting):
        self.assertEqual(shares(text), (code, reporting), text)

    def test_comments_braces_and_includes_are_no_code(self):
        self.reporting("/** prose\nx = 1; */\n// title\n#include <cmath>\n\n{\n});\nusing namespace lattice;\n", 0, 0)

    def test_computing_is_physics(self):
        self.reporting("double force(double y) {\n  return y * y;  // a remark\n}\n", 2, 0)

    def test_a_table_reports_with_all_its_lines(self):
        self.reporting('Table& t = report.table("x", {number("a", "one"),\n  count("b", "two")});\nrun();\n', 3, 2)

    def test_a_record_that_passes_on_reports_and_one_that_computes_does_not(self):
        self.reporting('report.facts.add("x", speed);\n', 1, 1)
        self.reporting('report.facts.add("x", compare(coarse, fine));\n', 1, 0)
        self.reporting('report.facts.add("x - y", speed);\n', 1, 1)

    def test_options_and_names_report_and_judging_does_not(self):
        self.reporting('void parameters(Parameters& p) {\n  p.add("s", s, "well", {-1, 1});\n}\n', 2, 2)
        self.reporting('const std::string name = "a" + other;\n', 1, 1)
        self.reporting('judge(report, "pn.grows", growing);\n', 1, 0)


if __name__ == "__main__":
    unittest.main()
