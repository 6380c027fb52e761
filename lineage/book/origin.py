"""The lines of a program that recorded a number.

The column `made_by` of a table names the function that recorded a row: the place is the statement in it that says
most of the number's name, or its first line."""

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
        if f"{name}(" not in line or not re.match(rf"\s*(?!return\b|else\b|//)[\w:<>,&*\[\]\s]*?[\s&*]{re.escape(name)}\(", line):
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
    for source in sources:
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


def condition(finding, judged, claims, sources):
    """The statement that says most of the name of a condition, where its criterion is made."""
    name = finding.id
    for subject in STRING.findall(judged.text):
        if subject in claims:
            name = name.removeprefix(subject.split(".")[-1] + "_").removesuffix("_margin")
    scored = [(covered(name, literals) + 6 * ("add(" in place.text) + (place == judged) - 4 * bool(source.module), place)
              for source in sources for place, literals in statements(source) if covered(name, literals) >= 3]
    return [max(scored, key=lambda s: s[0])[1]] if scored else []


def places(finding, claims, sources):
    """A condition is recorded where its criterion is judged, and made elsewhere: there both are shown."""
    found = recorded(finding, sources) if finding.made_by else []
    if found and finding.id not in claims and "judge(" in found[0].text:
        return list(dict.fromkeys(condition(finding, found[0], claims, sources) + found))
    return found
