"""C++ sources as a reader sees them: prose in blocks `/** ... */`, which begin a line, and code between them; the names that
a header defines; the line that names a number."""

import re
from dataclasses import dataclass
from pathlib import Path

from . import ecsv

BLOCK = re.compile(r"^([ \t]*)/\*\*(?![*/<])(.*?)\*/[ \t]*$", re.M | re.S)
DEFINED = [re.compile(pattern) for pattern in (
    r"(?:struct|class|enum class|enum|concept)\s+(\w+)\s*(?:final\s*)?(?::[^:]|\{|;|=|$)", r"(?:using|concept)\s+(\w+)\s*=",
    r"(?:inline\s+)?(?:static\s+)?const(?:expr|init)?\s+[\w:<>, ]+?\s\*?(\w+)(?:\[\w*\])?\s*(?:=|\{)",
    r"(?!return\b|using\b|else\b|namespace\b|static_assert\b)[\w:<>,&*\s\[\]]*?[\s&*>](\w+)\(")]


def blocks_of(text, path="<text>"):
    """The blocks of a source in turn: (whether it is prose, number of its first line, text)."""
    out, at = [], 0

    def code(until):
        piece = text[at:until]
        start = at + len(piece) - len(piece.lstrip("\n"))
        if found := re.search(r"^[ \t]*/\*\*(?![*/<])", piece, re.M):
            line = text.count("\n", 0, at + found.start()) + 1
            raise ecsv.Fault(f"{path}:{line}: a block of prose without its own end")
        if piece.strip():
            out.append((False, text.count("\n", 0, start) + 1, text[start:until].rstrip()))

    for found in BLOCK.finditer(text):
        code(found.start())
        indent = len(found[1])
        lines = [line[min(indent, len(line) - len(line.lstrip())):].rstrip() for line in found[2].split("\n")]
        out.append((True, text.count("\n", 0, found.start()) + 1, "\n".join([lines[0].strip(), *lines[1:]])))
        at = found.end()
    code(len(text))
    return out


def definitions(text):
    """Names that a header defines for others, with their lines: those that begin a line."""
    out = {}
    for prose, first, code in blocks_of(text):
        for offset, line in enumerate(() if prose else code.split("\n")):
            line = re.sub(r"^template\s*<[^<>]*(?:<[^<>]*>[^<>]*)*>\s*", "", line)
            if line[:1].isalpha() and (found := next(filter(None, (one.match(line) for one in DEFINED)), None)):
                out.setdefault(found[1], first + offset)
    return out


@dataclass(eq=False)
class Source:
    """A file of src/, which is a page."""
    path: str  # from the root of the repository
    text: str
    named: str = ""  # its title where it has none of its own

    def __post_init__(self):
        self.blocks = blocks_of(self.text, self.path)
        self.included = self.path.removeprefix("beyond/").removeprefix("src/")  # what others call it
        self.module = Path(self.path).parent.name if "/" in self.included else ""
        self.name, self.stem = Path(self.path).name, Path(self.path).stem
        self.is_header = self.name.endswith(".hpp")
        self.page = f"{self.module}-{self.stem}{'' if self.is_header else self.name.replace('.', '-')[len(self.stem):]}" if self.module else self.stem
        self.includes = re.findall(r'^\s*#include "([^"]+)"', self.text, re.M)
        own = re.search(r"^# (.+)$", "\n".join(text for prose, _, text in self.blocks if prose), re.M)
        self.title, self.titled = own[1] if own else self.named or self.name, bool(own)


def sources_of(root, folders, order):
    """The chapters of these volumes in the order of the book, and all other sources by folder, each header before what
    is compiled for it. A chapter that is not named in the order follows its section."""
    def read(path, named=""):
        return Source(str(path.relative_to(root)), ecsv.text_of(path), named)

    texts = [Path(folder) / "src" for folder in folders]
    chapters = {path.stem: read(path) for src in texts for path in sorted(src.glob("sec*.cpp"))}
    known = [name for name in order if name in chapters]
    for name in sorted(set(chapters) - set(known)):
        before = [i for i, other in enumerate(known) if other.split("_")[0] <= name.split("_")[0]]
        known.insert((before or [-1])[-1] + 1, name)
    rest = {}
    for path in sorted(path for src in texts for path in src.rglob("*.[chi]pp") if path.parent != src):
        if path.suffix == ".hpp" or not path.with_suffix(".hpp").exists():
            header = read(path)
            rest.setdefault(path.parent.name, []).append(header)
            for half in (path.with_suffix(suffix) for suffix in (".ipp", ".cpp") if path.suffix == ".hpp"):
                if half.exists():
                    rest[path.parent.name].append(read(half, f"{header.title}: how"))
    return [chapters[name] for name in known], rest


def local_names(text):
    """Names that a source declares itself."""
    return set(re.findall(r"\b(?:auto|double|int|bool|size_t|string)&? (\w+)\b", text)) | set(definitions(text))
