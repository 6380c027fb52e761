"""The list of errors that tests must notice: every row can be put into its file, and names a test that there is."""

import re
from unittest import mock

import mutants

from lineage.volumes import volumes

from common import ROOT, Scratch


class Mutants(Scratch):
    def test_every_row_stands_in_its_file_and_names_a_test(self):
        names = [f"/{path.relative_to(volume / 'tests').with_suffix('')}/" for volume in volumes(ROOT)
                 for path in (volume / "tests").rglob("*.cpp")]
        for file, _, _, tests, what in mutants.read_list([]):
            for test in tests:
                self.assertTrue(any(f"/{test.removeprefix('beyond/')}/" in name for name in names), f"{test}: {file}, {what}")

    def test_a_row_whose_text_is_gone_is_a_mistake(self):
        for text, count in (("int x = 1;", 1), ("int x = 2;", 0), ("int x = 1; int x = 1;", 2)):
            self.write("src/a.cpp", text)
            self.write("tools/mutants.tsv", "src/a.cpp\tx = 1\tx = 3\tsec1\tthe number\n")
            with mock.patch.object(mutants, "ROOT", self.root):
                if count == 1:
                    self.assertEqual(len(mutants.read_list([])), 1)
                else:
                    self.assertRaisesRegex(SystemExit, re.escape(f"mutants.tsv:1: 'x = 1' stands {count} times in src/a.cpp (allowed: once)"),
                                           mutants.read_list, [])
