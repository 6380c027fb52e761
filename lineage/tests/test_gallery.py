"""The gallery of the README is current, and one that is not is noticed."""

import importlib.util
import shutil
import tempfile
import unittest
from pathlib import Path

from lineage import gallery
from lineage.refresh import read_figures

from . import ROOT

FIGURES = ROOT / "build/figures"
NAMES = [Path(figure["script"]).stem for figure in read_figures(ROOT).values()]


@unittest.skipUnless(importlib.util.find_spec("PIL") and shutil.which("rsvg-convert"), "no PIL or rsvg-convert for the gallery")
@unittest.skipUnless(all((FIGURES / f"{name}.svg").exists() for name in NAMES), "build/figures is not complete (make figures)")
class Gallery(unittest.TestCase):
    def test_it_is_current(self):
        self.assertEqual(gallery.faults(NAMES, FIGURES, ROOT / "figures/gallery"), [], "make gallery")

    def test_what_is_not_current_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            scratch = Path(folder)
            for path in (ROOT / "figures/gallery").glob("*.png"):
                shutil.copy(path, scratch)
            shutil.copy(scratch / f"{NAMES[11]}.png", scratch / f"{NAMES[10]}.png")
            (scratch / f"{NAMES[0]}.png").unlink()
            (scratch / "old.png").write_bytes(b"")
            said = "\n".join(gallery.faults(NAMES, FIGURES, scratch))
            for words in ("old.png: no such figure", f"{NAMES[0]}: missing", f"{NAMES[10]}: a patch differs by"):
                self.assertIn(words, said)
            self.assertEqual(said.count("\n"), 2, said)
