"""One version and one title in all that names them."""

import json
import re
import unittest

from lineage import ecsv
from lineage.claims import read_claims

from common import ROOT


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
