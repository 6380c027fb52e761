"""One version and one title in all that names them, and a licence for every file."""

import importlib.util
import json
import re
import subprocess
import unittest

from lineage import ecsv
from lineage.claims import read_claims


from common import ROOT

LICENCES = ["MIT", "CC-BY-4.0"]


class Here(unittest.TestCase):
    def test_version_and_title_agree(self):
        meta, said = json.loads(ecsv.text_of(ROOT / "codemeta.json")), ecsv.text_of(ROOT / "CITATION.cff")
        cited = dict(re.findall(r'^([\w-]+): "(.*)"$', said, re.M))
        self.assertEqual([cited[name] for name in ("title", "version", "date-released")],
                         [meta[name] for name in ("name", "version", "datePublished")])
        self.assertEqual(re.search(r"^## (\d\S+)", ecsv.text_of(ROOT / "CHANGELOG.md"), re.M)[1], meta["version"])
        self.assertEqual(ecsv.text_of(ROOT / "README.md").splitlines()[0], "# " + meta["name"])
        for name in ("CITATION.cff", "paper/paper.tex", "paper/refs.bib"):
            text = ecsv.text_of(ROOT / name).replace("{H}", "H")
            self.assertTrue(meta["referencePublication"]["name"] in text, name)

    def test_they_count_the_statements(self):
        all = len(read_claims(ROOT))
        for name, words in (("codemeta.json", "published numbers and statements"), ("CITATION.cff", "published numbers and statements"),
                            ("README.md", "statements of the article")):
            self.assertIn(f" {all} {words}", ecsv.text_of(ROOT / name))

    @unittest.skipUnless(importlib.util.find_spec("tomllib"), "this python has no tomllib")
    @unittest.skipUnless((ROOT / ".git").exists(), "this is no checkout")
    def test_every_file_has_a_licence_that_is_there_and_no_choice(self):
        """REUSE.toml by the rules of its specification, for machines whose `reuse` does not know it yet."""
        import tomllib
        self.assertEqual({path.stem for path in (ROOT / "LICENSES").iterdir()}, set(LICENCES))
        self.assertEqual(ecsv.text_of(ROOT / "LICENSE"), ecsv.text_of(ROOT / "LICENSES/MIT.txt"))
        files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
        told = {}
        for rule in tomllib.loads(ecsv.text_of(ROOT / "REUSE.toml"))["annotations"]:
            for glob in [rule["path"]] if isinstance(rule["path"], str) else rule["path"]:
                pattern = re.escape(glob).replace(r"\*\*", ".*").replace(r"\*", "[^/]*")
                self.assertTrue(met := [name for name in files if re.fullmatch(pattern, name)], f"REUSE.toml: no file is named by {glob}")
                told |= dict.fromkeys(met, rule["SPDX-License-Identifier"])
        self.assertEqual([name for name in files if told.get(name) not in LICENCES], [])
        self.assertEqual([told[name] for name in ("tools/lineage/ecsv.py", "figures/style.gp", "README.md", "paper/paper.tex")], LICENCES[:1] * 2 + LICENCES[1:] * 2)
