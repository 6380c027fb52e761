"""The gallery of the README is current, and one that is not is noticed."""

import importlib.util
import shutil
import tempfile
import unittest
from pathlib import Path

from lineage import gallery
from lineage.refresh import read_figures

from common import ROOT, VOLUME, of_volume

FIGURES = ROOT / "build/figures"
NAMES = [Path(figure["script"]).stem for figure in read_figures(VOLUME).values()]


@of_volume
@unittest.skipUnless(importlib.util.find_spec("PIL") and shutil.which("rsvg-convert"), "no PIL or rsvg-convert for the gallery")
@unittest.skipUnless(all((FIGURES / f"{name}.svg").exists() for name in NAMES), "build/figures is not complete (make figures)")
class Here(unittest.TestCase):
    def test_it_is_current_and_what_is_not_is_named(self):
        self.assertEqual(gallery.faults(NAMES, FIGURES, VOLUME / "figures/gallery"), [], "make gallery")
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(VOLUME / f"figures/gallery/{NAMES[1]}.png", Path(folder) / f"{NAMES[0]}.png")
            (Path(folder) / "old.png").write_bytes(b"")
            said = gallery.faults(NAMES[:2], FIGURES, Path(folder))
            self.assertEqual([one.split(" differs")[0] for one in said],
                             ["old.png: no such figure", f"{NAMES[0]}: a patch", f"{NAMES[1]}: missing"])
