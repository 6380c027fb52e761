"""The gallery of the README is current, and one that is not is noticed."""

import importlib.util
import os
import shutil
import tempfile
import unittest
from pathlib import Path

from lineage import gallery
from lineage.refresh import read_figures

from . import ROOT, VOLUME, of_volume

FIGURES = ROOT / "build/figures"
NAMES = [Path(figure["script"]).stem for figure in read_figures(VOLUME).values()]


@of_volume
@unittest.skipUnless(importlib.util.find_spec("PIL") and shutil.which("rsvg-convert"), "no PIL or rsvg-convert for the gallery")
@unittest.skipUnless(all((FIGURES / f"{name}.svg").exists() for name in NAMES), "build/figures is not complete (make figures)")
class Here(unittest.TestCase):
    def test_it_is_current_and_what_is_not_is_named_and_drawn_alone(self):
        self.assertEqual(gallery.faults(NAMES, FIGURES, VOLUME / "figures/gallery"), [], "make gallery")
        names = NAMES[9:12]
        with tempfile.TemporaryDirectory() as folder:
            scratch, pictures = Path(folder), [Path(folder) / f"{name}.png" for name in names]
            shutil.copy(VOLUME / "figures/gallery" / pictures[2].name, pictures[2])
            os.utime(pictures[2], (2e9, 2e9))
            shutil.copy(pictures[2], pictures[1])  # old enough, and another picture
            os.utime(pictures[1], (0, 0))
            (scratch / "old.png").write_bytes(b"")
            said = gallery.faults(names, FIGURES, scratch)
            self.assertEqual([one.split(" differs")[0] for one in said],
                             ["old.png: no such figure", f"{names[0]}: missing", f"{names[1]}: a patch"])
            gallery.draw(names, FIGURES, scratch)
            self.assertEqual((gallery.faults(names, FIGURES, scratch), pictures[2].stat().st_mtime), ([], 2e9))
