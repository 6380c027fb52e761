"""One version, one title, one article: of codemeta.json, CMake, the changelog and the bibliography; and a licence for every file."""

import importlib.util
import re
import subprocess
import unittest

from lineage import ecsv, metadata

from common import ROOT, Scratch


class Here(unittest.TestCase):
    def setUp(self):
        self.meta = metadata.read(ROOT)

    def test_one_version(self):
        version, cmake = self.meta["version"], ecsv.text_of(ROOT / "CMakeLists.txt")
        headings = re.findall(r"^## (\S+)", ecsv.text_of(ROOT / "CHANGELOG.md"), re.M)
        self.assertEqual(next(h for h in headings if h != "Unreleased"), version)
        self.assertIn('string(JSON version GET "${codemeta}" version)', cmake)
        self.assertIn("project(lattice VERSION ${version} ", cmake)
        for name in ("README.md", "paper/refs.bib"):
            self.assertIn(metadata.article(self.meta)["title"], re.sub(r"\s+", " ", ecsv.text_of(ROOT / name)).replace("{H}", "H"))

    @unittest.skipUnless(importlib.util.find_spec("tomllib"), "this python has no tomllib")
    @unittest.skipUnless((ROOT / ".git").exists(), "this is no checkout")
    def test_every_file_has_a_licence_that_is_there_and_no_choice(self):
        """REUSE.toml by the rules of its specification, for machines whose `reuse` does not know it yet."""
        import tomllib
        self.assertEqual((licences := metadata.licences(self.meta)), ["MIT", "CC-BY-4.0"])
        self.assertEqual({path.stem for path in (ROOT / "LICENSES").iterdir()}, set(licences))
        self.assertEqual(ecsv.text_of(ROOT / "LICENSE"), ecsv.text_of(ROOT / "LICENSES/MIT.txt"))
        files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
        told = {}
        for rule in tomllib.loads(ecsv.text_of(ROOT / "REUSE.toml"))["annotations"]:
            for glob in [rule["path"]] if isinstance(rule["path"], str) else rule["path"]:
                pattern = re.escape(glob).replace(r"\*\*", ".*").replace(r"\*", "[^/]*")
                self.assertTrue(met := [name for name in files if re.fullmatch(pattern, name)], f"REUSE.toml: no file is named by {glob}")
                told |= dict.fromkeys(met, rule["SPDX-License-Identifier"])
        self.assertEqual([name for name in files if told.get(name) not in licences], [])
        self.assertEqual([told[name] for name in ("tools/lineage/ecsv.py", "figures/style.gp", "README.md", "paper/paper.tex")], licences[:1] * 2 + licences[1:] * 2)


class Told(Scratch):
    def test_what_cannot_be_used_is_named(self):
        good = self.read("codemeta.json")
        self.lineage("refresh")
        self.write("codemeta.json", good.replace('"1.0.0"', '"1.0.1"'))
        self.assertIn("stale  CITATION.cff", self.lineage("refresh", "--check")[1])
        self.write("codemeta.json", good.replace('"version"', '"versoin"'))
        self.refuses("refresh", "codemeta.json: there is no 'version'")
        self.write("codemeta.json", good[:-5])
        self.refuses("refresh", "codemeta.json: line", "not JSON")
