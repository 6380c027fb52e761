"""Reads a C++ source as a chapter: prose and code in turn.

Prose stands in `/** ... */` blocks that begin a line; everything else is code. Nothing is
reordered, so that line numbers of the page are line numbers of the file.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

from ..ecsv import Fault, text_of


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
                raise Fault(f"{path}:{number}: text after the end of a block: {after.strip()}")
            blocks.append(prose)
            prose = None
    if prose is not None:
        raise Fault(f"{path}:{prose.first}: a block of prose has no end")
    end_code(text.count("\n") + 2)
    return blocks


def title_of(blocks):
    """The first heading in prose; empty where there is none."""
    found = (re.search(r"^# (.+)$", block.text, re.M) for block in blocks if block.kind == "prose")
    return next((one[1].strip().replace("'", "’") for one in found if one), "")


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
            if match := next(filter(None, (pattern.match(line) for pattern in (TYPE, ALIAS, CONSTANT, FUNCTION))), None):
                found.setdefault(match[1], block.first + offset)
    return found


@dataclass(eq=False)
class Source:
    path: str  # from the root of the repository
    text: str
    blocks: list = field(default_factory=list)
    title: str = ""
    includes: list = field(default_factory=list)

    @property
    def name(self):
        return Path(self.path).name

    @property
    def stem(self):
        return Path(self.path).stem

    @property
    def is_header(self):
        return self.path.endswith(".hpp")

    @property
    def included(self):
        """What other sources call it."""
        return self.path.removeprefix("beyond/").removeprefix("src/")

    @property
    def module(self):
        """The module of the library or the section of its code, empty for chapters."""
        return Path(self.path).parent.name if "/" in self.included else ""

    @property
    def page(self):
        stem = self.stem if self.is_header or not self.module else self.name.replace(".", "-")
        return (f"{self.module}-{stem}" if self.module else stem) + ".html"


def read_source(root, path, name=""):
    """A source; where it has no title, such as the compiled half of a header, it takes the name that is given."""
    text, path = text_of(Path(root) / path), str(path)
    blocks = split_blocks(text, path)
    title = title_of(blocks) or name
    if not title:
        raise Fault(f"{path}: no title (a line '# ...' in its first block of prose)")
    return Source(path, text, blocks, title, re.findall(r'^\s*#include "([^"]+)"', text, re.M))


def in_order_of_need(sources):
    """Headers of one module such that each comes after those that it includes; ties by name."""
    by_path = {s.included: s for s in sorted(sources, key=lambda s: s.path)}
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


def modules_of(root):
    """The modules of the library in their order, and what each is about: the table of the README."""
    readme = Path(root) / "README.md"
    return dict(re.findall(r"^\| \[`(\w+)`\]\(src/[^)]*\) \| (.*) \|$", text_of(readme) if readme.exists() else "", re.M))


def read_module(root, folder):
    """The headers of a folder, each before the source that is compiled for it."""
    path = folder.relative_to(root)
    headers = in_order_of_need([read_source(root, f"{path}/{h.name}", h.name) for h in sorted(folder.glob("*.hpp"))])
    how = {f"{header.stem}.cpp": f"{header.title}: how" for header in headers}
    halves = {p.name: read_source(root, f"{path}/{p.name}", how.get(p.name, p.name)) for p in sorted(folder.glob("*.cpp"))}
    out = [s for header in headers for s in (header, halves.pop(f"{header.stem}.cpp", None)) if s]
    return out + list(halves.values())


def find_sources(root, folders, order=()):
    """Chapters of these volumes in the order of the book, and the sources of the library and of section code by folder.

    `order` lists the chapters by name; a chapter that it does not know follows the last known one
    of its section, so that a new chapter has a page at once."""
    root, texts = Path(root), [Path(folder) / "src" for folder in folders]
    chapters = {path.stem: read_source(root, path.relative_to(root)) for src in texts for path in src.glob("sec*.cpp")}
    known = [n for n in order if n in chapters]
    for name in sorted(set(chapters) - set(known)):
        section = name.split("_")[0]
        same = [i for i, n in enumerate(known) if n.split("_")[0] == section]
        before = [i for i, n in enumerate(known) if n.split("_")[0] < section]
        known.insert((same or before or [-1])[-1] + 1, name)
    parts = {}
    for folder in sorted({p.parent for src in texts for p in src.rglob("*.[ch]pp") if p.parent != src}):
        parts.setdefault(folder.name, []).append(folder)
    modules = [m for m in modules_of(root) if m in parts]
    modules += [m for m in sorted(parts, key=lambda m: str(parts[m][0])) if m not in modules]
    return [chapters[name] for name in known], {m: [s for folder in parts[m] for s in read_module(root, folder)] for m in modules}
