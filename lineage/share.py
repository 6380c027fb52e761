"""How much of a chapter's code is physics, method or criteria, and how much reports it.

A line of code is one outside of `/** */` that has more than a comment, braces or an include. Lines are taken
together to statements, up to a semicolon or a brace at the end of a line. A statement *reports*, with all its
lines, if it

- declares or passes on a table, its columns, the list of quantities or a note, or fills them
  (`Table`, `Columns`, `Cells`, `Quantities`, `Answers`, `x.add(` and `x.fill(` of one of them, `facts.`, `results.`, `output.`),
- declares a command or its parameters (`Title`, `Parameters`, `UsageError`, `table() const`, `main`),
- makes a name or a text (`std::string`, `const char*`),
- or is the head of a function that returns a table or takes a report, or the call of one.

But a record or a row that computes what it records (it compares two resolutions, divides, takes a modulus,
evaluates a formula) is method, and so is `judge`, which puts a criterion to the numbers."""

import re
from pathlib import Path

WORDS = re.compile(r"""\b(Table|Columns|Cells|Quantities|Answers|Parameters|Title|UsageError|Report|Output|Results)\b
    | \b(facts|results|output)\s*\. | \b(report\.(table|output|facts|results))\b
    | \b(number|count|label|estimate)\("  | table\(\)\ const | \bmain\( | \breturn\ run\( | \bcommands<
    | \bstd::string\b | \bconst\ char\s*\* | \breport_\w+\( | \bfill\( """, re.X)
HOLDER = re.compile(r"\b(?:Table|Quantities|Answers|Parameters|Columns)\s*&?\s+(\w+)")

RECORD = re.compile(r"\.add\(|\bCells\{")
COMPUTES = re.compile(r"""[\w)\]]\s(?:[-*/])\s[\w(] | \b(compare|quotient|larger|smaller|size|std::(abs|log|sqrt|arg|asin|sin|cos|expm1))\( |
    \b(?!to_string|name_of|short_text|report_)[a-z]\w*_\w*\([^"]""", re.X)


def code_lines(text):
    """The lines of a chapter that are code, without comments."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    for line in text.split("\n"):
        line = re.sub(r"//.*", "", line).strip()
        if re.search(r"\w", line) and not line.startswith(("#", "using namespace")):
            yield line


def statements(lines):
    """Lines that belong together: up to one that ends with a semicolon or a brace, in a table with a semicolon."""
    held = []
    for line in lines:
        held.append(line)
        table = re.search(r"\bTable\s+\w*\s*\{|\breturn Table\{", held[0])
        if line.endswith(";" if table else (";", "{", "}")):
            yield held
            held = []
    if held:
        yield held


def shares(text):
    """(lines of code, those of them that report) of a chapter."""
    lines = list(code_lines(text))
    holders = set(HOLDER.findall("\n".join(lines)))
    passes = re.compile(r"\b(%s)\b\.(add|fill|columns|rows|table|numbers|texts)" % "|".join(holders or {"$"}))
    reporting = 0
    for statement in statements(lines):
        whole = " ".join(statement)
        values = re.sub(r'"(\\.|[^"\\])*"', '""', whole)
        if re.search(r"\bjudge\(", whole) and "std::string" not in whole:
            continue
        if RECORD.search(values) and COMPUTES.search(values) and not re.search(r"\bTable\b|\bp\.add", values):
            continue
        if WORDS.search(whole) or passes.search(whole):
            reporting += len(statement)
    return len(lines), reporting


def show(root):
    print(f"{'chapter':32} {'lines':>6} {'of code':>8} {'physics':>8}")
    for path in sorted((Path(root) / "src").glob("sec*.cpp")):
        text = path.read_text()
        code, reporting = shares(text)
        print(f"{path.stem:32} {text.count(chr(10)):6} {code:8} {100 * (code - reporting) / code:7.0f}%")
