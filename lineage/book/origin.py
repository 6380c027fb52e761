"""The lines of a program that recorded a number.

The column `made_by` of a table names the function that recorded a row: the place is the statement in it that says
most of the number's name, or its first line. Where a table does not say, `guessed` looks through the sources."""

import re
from dataclasses import dataclass
from functools import cache

STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


@dataclass(frozen=True)
class Place:
    """Lines of a source."""
    path: str
    first: int
    last: int
    text: str


@cache
def statements(source):
    """Statements with literal texts: (place, literals)."""
    return list(found_statements(source))


def found_statements(source):
    for block in source.blocks:
        if block.kind != "code":
            continue
        start, held = None, []
        for offset, line in enumerate(block.lines):
            if line.lstrip().startswith(("#", "//")):
                continue
            if start is None:
                start = block.first + offset
            held.append(line)
            code = re.sub(r"\s*//.*$", "", line).rstrip()
            if code.endswith((";", "{", "}", "},", "),")) or len(held) >= 8:
                text = "\n".join(held)
                if literals := STRING.findall(text):
                    yield Place(source.path, start, block.first + offset, text), literals
                start, held = None, []


def functions(source, name):
    """The definitions of a function: from the line with its name to the brace that closes it."""
    lines = source.text.split("\n")
    for i, line in enumerate(lines):
        if not re.match(rf"\s*(?!return\b|else\b|//)[\w:<>,&*\[\]\s]*?[\s&*]{re.escape(name)}\(", line):
            continue
        indent = len(line) - len(line.lstrip())
        for end in range(i, len(lines)):
            if lines[end].rstrip().endswith(";") and end - i < 6 and "{" not in "".join(lines[i:end + 1]):
                break  # a declaration
            if re.match(rf"\s{{{indent}}}\}}", lines[end]) and end > i or lines[i].rstrip().endswith("}"):
                yield Place(source.path, i + 1, end + 1, line)
                break


def recorded(finding, sources):
    """The places by `made_by`; empty where the function is not in the sources."""
    for source in sources if finding.made_by else ():
        for function in functions(source, finding.made_by):
            inside = [(999 if finding.id in literals else covered(finding.id, literals), place)
                      for place, literals in statements(source)
                      if function.first <= place.first <= function.last and re.search(r"\b(add|judge)\(", place.text)]
            most, place = max(inside, key=lambda x: x[0], default=(0, function))
            return [place if most else function]
    return []


def covered(name, literals):
    """How many characters of `name` the literals account for, as whole words between underscores."""
    left, total = name, 0
    for literal in sorted(set(literals), key=len, reverse=True):
        word = literal.split(".")[-1].strip("_")
        if len(word) < 2:
            continue
        more = "A-Za-z0-9" if word[-1].isdigit() else "A-Za-z"  # a number may follow a letter
        found = re.search(rf"(?<![A-Za-z0-9]){re.escape(word)}(?![{more}])", left)
        if found:
            total += len(word)
            left = left[: found.start()] + "|" + left[found.end():]
    return total


def guessed(finding, claims, sources):
    """The statement with the whole name, or that says most of it, and where a criterion is judged that one too."""
    known = [(bool(s.room), *x) for s in sources for x in statements(s)]
    name, judged, is_claim = finding.id.split(".")[-1], None, finding.id in claims
    for _, place, literals in known:
        for subject in literals if "judge(" in place.text and not is_claim else ():
            prefix = subject.split(".")[-1] + "_"
            if subject in claims and finding.id.startswith(prefix):
                judged = place
                name = finding.id[len(prefix):].removesuffix("_margin")
    scored = []
    for library, place, literals in known:
        adds = "add(" in place.text
        if finding.id in literals and not library:
            scored.append((1000 + (adds or "claim(" in place.text or "judge(" in place.text), place))
            continue
        score = covered(name, literals)
        if is_claim:
            score = max([len(x) for x in literals if "." in x and finding.id.startswith(x)] + [0])
        if score >= 3:
            scored.append((score + 6 * adds + (place == judged) - 4 * library, place))
    best = max(scored, key=lambda s: s[0])[1] if scored else None
    return [p for p in (best, judged if judged != best else None) if p]


def places(finding, claims, sources):
    """A condition is recorded where its criterion is judged, and made elsewhere: there both are shown."""
    found = recorded(finding, sources)
    if found and (finding.id in claims or "judge(" not in found[0].text):
        return found
    return guessed(finding, claims, sources) or found
