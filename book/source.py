"""Reads a C++ source as a chapter: prose and code in turn.

Prose stands in `/** ... */` blocks that begin a line; everything else is code. Nothing is
reordered, so that line numbers of the page are line numbers of the file.
"""

import os
import re
from dataclasses import dataclass, field


class BookError(Exception):
    """Something that must stop the build; the message names the place."""


@dataclass
class Block:
    kind: str  # 'prose' or 'code'
    first: int  # number of its first line, from 1
    lines: list

    @property
    def text(self):
        return "\n".join(self.lines)

    @property
    def last(self):
        return self.first + len(self.lines) - 1


def split_blocks(text, path="<text>"):
    """The blocks of a source in their order; code blocks lose empty lines at both ends."""
    blocks, code, prose, indent = [], [], None, 0

    def end_code(number):
        first = number - len(code)
        while code and not code[0].strip():
            code.pop(0)
            first += 1
        while code and not code[-1].strip():
            code.pop()
        if code:
            blocks.append(Block("code", first, code[:]))
        code.clear()

    for number, line in enumerate(text.split("\n"), 1):
        if prose is None:
            if not re.match(r"\s*/\*\*(?![*/<])", line):
                code.append(line)
                continue
            end_code(number)
            indent = len(line) - len(line.lstrip())
            prose = Block("prose", number, [])
            line = line.replace("/**", "", 1).strip() if "*/" not in line else line.strip()[3:].strip()
        else:
            line = line[min(indent, len(line) - len(line.lstrip())):]
        before, end, after = line.partition("*/")
        prose.lines.append(before.rstrip())
        if end:
            if after.strip():
                raise BookError(f"{path}:{number}: text after the end of a block: {after.strip()}")
            blocks.append(prose)
            prose = None
    if prose is not None:
        raise BookError(f"{path}:{prose.first}: a block of prose has no end")
    end_code(text.count("\n") + 2)
    return blocks


def title_of(text, path="<text>"):
    """The first heading of the first block of prose."""
    for block in split_blocks(text, path):
        if block.kind == "prose":
            found = re.search(r"^# (.+)$", block.text, re.M)
            if found:
                return found.group(1).strip().replace("'", "’")
    raise BookError(f"{path}: no title (a line '# ...' in its first block of prose)")


def includes_of(text):
    """What a source includes in quotes."""
    return re.findall(r'^\s*#include "([^"]+)"', text, re.M)


TEMPLATE = re.compile(r"^template\s*<.*>\s*$")
TYPE = re.compile(r"^(?:struct|class|enum class|enum|concept)\s+(\w+)\s*(?:final\s*)?(?::[^:]|\{|;|=|$)")
ALIAS = re.compile(r"^(?:using|concept)\s+(\w+)\s*=")
CONSTANT = re.compile(r"^(?:inline\s+)?(?:static\s+)?const(?:expr|init)?\s+[\w:<>, ]+?\s\*?(\w+)(?:\[\w*\])?\s*(?:=|\{)")
FUNCTION = re.compile(r"^(?!return\b|using\b|else\b|namespace\b|static_assert\b)[\w:<>,&*\s\[\]]*?[\s&*>](\w+)\(")


def definitions(blocks):
    """Names that a header defines for others, with the line of each: those that begin a line."""
    found = {}
    for block in blocks:
        if block.kind != "code":
            continue
        for offset, line in enumerate(block.lines):
            if not line or not (line[0].isalpha() or line[0] == "_"):
                continue
            if line.startswith("template"):
                line = re.sub(r"^template\s*<[^<>]*(?:<[^<>]*>[^<>]*)*>\s*", "", line)
            for pattern in (TYPE, ALIAS, CONSTANT, FUNCTION):
                match = pattern.match(line)
                if match:
                    found.setdefault(match.group(1), block.first + offset)
                    break
    return found


@dataclass
class Source:
    path: str  # from the root of the repository
    text: str
    blocks: list = field(default_factory=list)
    title: str = ""
    includes: list = field(default_factory=list)

    @property
    def name(self):
        return os.path.basename(self.path)

    @property
    def stem(self):
        return os.path.splitext(self.name)[0]

    @property
    def room(self):
        """The room of the library, empty for chapters and their parts."""
        parts = self.path.split("/")
        return parts[2] if parts[:2] == ["src", "lattice"] else ""

    @property
    def page(self):
        return (f"{self.room}-{self.stem}" if self.room else self.stem) + ".html"


def read_source(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        text = file.read()
    return Source(path, text, split_blocks(text, path), title_of(text, path), includes_of(text))


def in_order_of_need(sources):
    """Headers of one room such that each comes after those that it includes; ties by name."""
    by_path = {s.path[len("src/"):]: s for s in sorted(sources, key=lambda s: s.path)}
    done, order = set(), []

    def visit(key, above):
        if key in done or key in above:
            return
        for other in by_path[key].includes:
            if other in by_path:
                visit(other, above | {key})
        done.add(key)
        order.append(by_path[key])

    for key in by_path:
        visit(key, frozenset())
    return order


ROOMS = ["numbers", "model", "stepping", "landing", "measure", "dps", "orbits", "report"]


def find_sources(root, order=()):
    """Chapters with their parts, in the order of the book, and the headers of the library by room.

    `order` lists the chapters by name; a chapter that it does not know follows the last known one
    of its section, so that a new chapter has a page at once."""
    folder = os.path.join(root, "src")
    names = sorted(n for n in os.listdir(folder) if n.startswith("sec"))
    chapters = {n[:-4]: read_source(root, "src/" + n) for n in names if n.endswith(".cpp")}
    parts = {n: read_source(root, "src/" + n) for n in names if n.endswith(".hpp")}
    known = [n for n in order if n in chapters]
    for name in sorted(set(chapters) - set(known)):
        section = name.split("_")[0]
        same = [i for i, n in enumerate(known) if n.split("_")[0] == section]
        before = [i for i, n in enumerate(known) if n.split("_")[0] < section]
        known.insert((same or before or [-1])[-1] + 1, name)
    book = []
    for name in known:
        book.append(chapters[name])
        book += [parts.pop(i) for i in chapters[name].includes if i in parts]
    if parts:
        raise BookError("no chapter includes " + ", ".join(sorted(parts)))
    library = {}
    rooms = sorted(os.listdir(os.path.join(folder, "lattice")))
    for room in [r for r in ROOMS if r in rooms] + [r for r in rooms if r not in ROOMS]:
        at = os.path.join(folder, "lattice", room)
        headers = [f"src/lattice/{room}/{n}" for n in sorted(os.listdir(at)) if n.endswith(".hpp")]
        library[room] = in_order_of_need([read_source(root, h) for h in headers])
    return book, library
