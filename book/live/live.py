"""The live pages: chains that the reader's browser computes, by the library compiled to WebAssembly (CMakeLists.txt). They are
left out where it was not compiled."""

import base64
import gzip
import json
from pathlib import Path

from lineage import ecsv, inventory

PAGES = ("strike", "breather", "defect", "drive")
KNOWS_WELLS = "../bin/sec34_impact"
SCRIPT = '\n\n<script src="live.js" defer></script>\n'


def found(volumes, compiled):
    """The live pages of these volumes, [(folder, name)], if all of them and the program with the wells were compiled."""
    lives = [(v / "book/live", name) for name in PAGES for v in volumes if (v / f"book/live/{name}.cpp").exists()]
    needed = [compiled / KNOWS_WELLS, *(compiled / f"{name}.wasm" for _, name in lives)]
    return lives if all(path.exists() for path in needed) else []


def read_buttons(path):
    """Figures that can be computed in the page: [(words, address)] by id."""
    out = {}
    for line in ecsv.lines_of(path):
        id, _, rest = line.partition(" ")
        words, page, parameters = rest.split("|")
        out.setdefault(id, []).append((words, f"{page}.html?{parameters}"))
    return out


def copy(lives, compiled, out):
    """The library as scripts, because a page from a folder may not fetch a file."""
    for _, name in lives:
        packed = base64.b64encode(gzip.compress((compiled / f"{name}.wasm").read_bytes(), mtime=0)).decode()
        (out / f"{name}.module.js").write_text(f'(window.LIVE_MODULES ??= {{}}).{name} = "{packed}";\n', encoding="utf-8")
    if lives:
        paths = [Path(__file__).with_name("live.js"), *(folder / f"{name}.js" for folder, name in lives)]
        shared, *kinds = map(ecsv.text_of, paths)
        (out / "live.js").write_text(f"{shared}Live.wells = {json.dumps(inventory.wells(compiled / KNOWS_WELLS))};\n{''.join(kinds)}", encoding="utf-8")
