"""The list of errors that tests must notice: every row can be put into its file, and names a test that there is."""

import unittest

import mutants

from lineage.volumes import volumes

from common import ROOT


class Mutants(unittest.TestCase):
    def test_every_row_stands_in_its_file_and_names_a_test(self):
        names = [f"/{path.relative_to(volume / 'tests').with_suffix('')}/" for volume in volumes(ROOT)
                 for path in (volume / "tests").rglob("*.cpp")]
        for file, _, _, tests, what in mutants.read_list([]):
            for test in tests:
                self.assertTrue(any(f"/{test.removeprefix('beyond/')}/" in name for name in names), f"{test}: {file}, {what}")
