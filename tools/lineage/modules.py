"""The modules of the library as CMake links them: what CONTRIBUTING.md draws. CMake writes it down for whoever installs
the library, so that nothing has to be configured once more."""

import re
from pathlib import Path

from . import ecsv

EXPORT = "build/CMakeFiles/Export/*/lattice-targets.cmake"
MODULE = re.compile(r"^add_library\(lattice::(\w+) STATIC.*?INTERFACE_LINK_LIBRARIES \"(.*?)\"", re.M | re.S)


def drawing(root):
    """A line for each module, uppermost first, with those right below it, and a gap between layers. None where nothing
    is configured."""
    written = max(Path(root).glob(EXPORT), key=lambda path: path.stat().st_mtime, default=None)
    links = {name: set(re.findall(r"lattice::(\w+)", all)) - {"flags"}
             for name, all in MODULE.findall(ecsv.text_of(written) if written else "")}

    def height(name):
        return 1 + max(map(height, links[name]), default=0)

    def below(name):
        return links[name].union(*map(below, links[name]))

    rows, width = [], max(map(len, links), default=0)
    for name in sorted(links, key=height, reverse=True):
        near = links[name] - set().union(*map(below, links[name]))
        gap = [""] if rows and height(name) < height(rows[-1].split()[0]) else []
        rows += gap + [f"{name:{width}}  {', '.join(sorted(near))}".rstrip()]
    return ["```", *rows, "```"] if rows else None
