"""The live pages: chains that the reader's browser computes, by the library compiled to WebAssembly (CMakeLists.txt). They are
left out where it was not compiled."""

import base64
import gzip
import json
import re
from pathlib import Path

from lineage import ecsv

PAGES = ("strike", "breather", "defect", "drive")
SCRIPT = '\n\n<script src="live.js" defer></script>\n'


def found(volumes, compiled):
    """The live pages of these volumes, [(folder, name)], if all of them were compiled."""
    lives = [(v / "book/live", name) for name in PAGES for v in volumes if (v / f"book/live/{name}.cpp").exists()]
    return lives if all((compiled / f"{name}.wasm").exists() for _, name in lives) else []


def read_buttons(path):
    """Figures that can be computed in the page: [(words, address)] by id."""
    out = {}
    for line in ecsv.text_of(path).splitlines():
        if line.strip() and not line.startswith("#"):
            id, _, rest = line.strip().partition(" ")
            words, page, parameters = rest.split("|")
            out.setdefault(id, []).append((words, f"{page}.html?{parameters}"))
    return out


def wells_of(root):
    """The wells that the library knows by name, in the order of its list, each with the names of its parameters."""
    text = ecsv.text_of(Path(root) / "src/lattice/model/well.hpp")
    structs = dict(re.findall(r"^struct (\w+).*?\{\n(.*?)^\};", text, re.M | re.S))
    listed = re.search(r"^struct Well : OneOf<OwnWell, ([\w,\s]+)>", text, re.M)
    if not listed:
        raise ecsv.Fault("src/lattice/model/well.hpp: no list of wells")
    bodies = [structs[name] for name in re.split(r",\s*", listed[1])]
    return {re.search(r'name = "(\w+)"', body)[1]: re.findall(r'Parameter<\w+>\{"(\w+)"', body) for body in bodies}


def copy(lives, compiled, root, out):
    """The library as scripts, because a page from a folder may not fetch a file."""
    for _, name in lives:
        packed = base64.b64encode(gzip.compress((compiled / f"{name}.wasm").read_bytes(), mtime=0)).decode()
        (out / f"{name}.module.js").write_text(f'(window.LIVE_MODULES ??= {{}}).{name} = "{packed}";\n', encoding="utf-8")
    if lives:
        paths = [Path(__file__).with_name("live.js"), *(folder / f"{name}.js" for folder, name in lives)]
        shared, *kinds = map(ecsv.text_of, paths)
        (out / "live.js").write_text(f"{shared}Live.wells = {json.dumps(wells_of(root))};\n{''.join(kinds)}", encoding="utf-8")
