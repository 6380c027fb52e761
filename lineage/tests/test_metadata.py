"""One version, one title, one article: what GitHub, the archive, ReScience C, CMake, the changelog and the paper are told."""

import importlib.util
import re
import subprocess
import unittest

from lineage import ecsv, metadata

from . import ROOT, Scratch

# What these files must have at their top; ReScience C asks for all of its names and no others.
REQUIRED = {"CITATION.cff": {"authors", "cff-version", "message", "title"}, "codecheck.yml": {"version", "paper", "manifest"},
            ".zenodo.json": {"upload_type", "title", "description", "creators", "access_right"}}
RESCIENCE = {"title", "authors", "affiliations", "keywords", "code", "data", "replication", "abstract", "bibliography", "type",
             "domain", "language", "review", "contributors", "dates", "article", "journal"}


class Here(unittest.TestCase):
    def setUp(self):
        self.meta = metadata.read(ROOT)

    def test_each_file_has_what_its_readers_ask_for(self):
        for name, required in REQUIRED.items():
            self.assertEqual(required - set(re.findall(r'^(?:  ")?([a-z_-]+)"?:', ecsv.text_of(ROOT / name), re.M)), set())
        self.assertEqual(set(re.findall(r"^([a-z]+):", ecsv.text_of(ROOT / "paper/metadata.yaml"), re.M)), RESCIENCE)
        manifest = re.findall(r'^  - file: "(.*)"\n    comment: "\S.*"$', ecsv.text_of(ROOT / "codecheck.yml"), re.M)
        figures = [f"build/figures/{path.stem}.pdf" for path in sorted((ROOT / "figures/gallery").iterdir())]
        self.assertEqual((sorted(manifest[:-1]), manifest[-1]), (figures, "build/report/claims.ecsv"))

    def test_one_version(self):
        version, cmake = self.meta["version"], ecsv.text_of(ROOT / "CMakeLists.txt")
        headings = re.findall(r"^## (\S+)", ecsv.text_of(ROOT / "CHANGELOG.md"), re.M)
        self.assertEqual(next(h for h in headings if h != "Unreleased"), version)
        self.assertIn('string(JSON version GET "${codemeta}" version)', cmake)
        self.assertIn("project(lattice VERSION ${version} ", cmake)

    def test_the_article_is_that_of_the_bibliography(self):
        a, bib = metadata.article(self.meta), ecsv.text_of(ROOT / "paper/refs.bib").split("@article{james2013breathers,")[1]
        said = {name: re.search(rf"\b{name}\s*=\s*\{{(.*?)\}}[,\n]", bib)[1].replace("{H}", "H")
                for name in ("title", "journal", "volume", "pages", "year", "doi")}
        self.assertEqual(said, {"title": a["title"], "journal": a["journal"], "volume": str(a["volume"]),
                                "pages": f"{a['start']}--{a['end']}", "year": str(a["year"]), "doi": a["doi"]})
        self.assertIn(a["title"], ecsv.text_of(ROOT / "README.md").replace("\n", " "))

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
        self.assertEqual([told[name] for name in ("lineage/ecsv.py", "figures/style.gp", "README.md", "paper/paper.tex")], licences[:1] * 2 + licences[1:] * 2)


class Told(Scratch):
    def test_a_version_has_the_day_that_codemeta_says_and_no_other(self):
        self.write("paper/paper.tex", r"\wide{01}\gone{a.one}{cause}")
        bare = re.sub(r' *"datePublished": "\d{4}-\d\d-\d\d",\n', "", self.read("codemeta.json"))
        dated = bare.replace('"version": "1.0.0"', '"version": "1.0.0", "datePublished": "2001-02-03"')
        for text, lines, edition in [(bare, 0, "Version 1.0.0"), (dated, 1, "Version 1.0.0, 2001-02-03")]:
            self.write("codemeta.json", text)
            self.assertEqual((self.lineage("refresh")[0], self.lineage("macros")[0]), (0, 0))
            self.assertEqual(self.read("CITATION.cff").count('date-released: "2001-02-03"\n'), lines)
            self.assertEqual(self.read("CITATION.cff").count("date-released"), lines)
            self.assertIn(rf"\define{{meta}}{{edition}}{{{edition}}}", self.read("build/paper/numbers.tex"))

    def test_what_cannot_be_used_is_named(self):
        good = self.read("codemeta.json")
        self.lineage("refresh")
        self.write("codemeta.json", good.replace('"1.0.0"', '"1.0.1"'))
        self.assertIn("stale  CITATION.cff", self.lineage("refresh", "--check")[1])
        self.write("codemeta.json", good.replace('"version"', '"versoin"'))
        self.refuses("refresh", "codemeta.json: there is no 'version'")
        self.write("codemeta.json", good[:-5])
        self.refuses("refresh", "codemeta.json: line", "no JSON")
