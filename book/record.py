"""Claims, locked values, figures and tables, and what binds a number to the lines that computed it."""

import csv
import math
import os
import re
from dataclasses import dataclass

from source import BookError

COLUMN = re.compile(
    r"^# - \{name: '((?:[^']|'')*)'(?:, unit: '((?:[^']|'')*)')?, datatype: (\w+)"
    r"(?:, description: '((?:[^']|'')*)')?\}")
META = re.compile(r"^# - \{(\w[\w ]*): '((?:[^']|'')*)'\}")


@dataclass
class Column:
    name: str
    unit: str
    kind: str
    description: str


@dataclass
class Table:
    columns: list
    meta: dict
    rows: list  # dicts of strings


def read_table(path):
    """An ECSV table; values stay texts."""
    columns, meta, body = [], {}, []
    try:
        with open(path, encoding="utf-8", newline="") as file:
            for line in file:
                if not line.startswith("#"):
                    body.append(line)
                    continue
                line = line.rstrip("\n")
                if found := COLUMN.match(line):
                    name, unit, kind, text = ((g or "").replace("''", "'") for g in found.groups())
                    columns.append(Column(name, unit, kind, text))
                elif found := META.match(line):
                    meta[found.group(1)] = found.group(2).replace("''", "'")
    except FileNotFoundError:
        raise BookError(f"{path} is missing: compute it first (make figures)") from None
    rows = list(csv.DictReader(body, strict=True))
    if not columns or not body:
        raise BookError(f"{path}: no ECSV table")
    return Table(columns, meta, rows)


# The texts of values, as tools/refresh.hpp writes them into the sources. A test compares both.


def with_digits(x, digits):
    mantissa, _, exponent = ("%#.*g" % (digits, x)).partition("e")
    return mantissa.rstrip(".") + (f"e{int(exponent)}" if exponent else "")


def without_zeros(text):
    mantissa, e, exponent = text.partition("e")
    return (mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa) + e + exponent


@dataclass
class Finding:
    program: str
    id: str
    value: float
    error: float
    unit: str
    kind: str

    @property
    def shown(self):
        if self.unit == "claim":
            return "holds" if self.value == 1 else "does not hold"
        if not math.isfinite(self.value):
            return "nan" if math.isnan(self.value) else "inf" if self.value > 0 else "-inf"
        if self.value == 0:
            return "0"
        if self.kind == "residue":
            return with_digits(self.value, 1)
        if self.error == 0:
            whole = self.value == math.floor(self.value) and abs(self.value) < 1e9
            return str(int(self.value)) if whole else without_zeros(with_digits(self.value, 6))
        ratio = math.floor(math.log10(abs(self.value))) - math.floor(math.log10(abs(self.error)))
        return with_digits(self.value, int(min(max(ratio + 1, 1), 6)))

    @property
    def shown_error(self):
        if self.unit == "claim":
            return ""
        return "exact" if self.error == 0 else with_digits(self.error, 1)

    @property
    def shown_unit(self):
        return "" if self.unit == "claim" else self.unit


@dataclass
class Place:
    """Lines of a source."""
    path: str
    first: int
    last: int
    text: str


@dataclass
class Quote:
    """A number as prose names it, and all that is known about it."""
    id: str
    finding: Finding
    claim: dict  # empty for a fact
    table: str
    row: int  # the number of its row in the table, 0 where the table is not there
    places: list


STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def statements(source):
    """Statements with literal texts: (first line, last line, text, literals)."""
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
                    yield start, block.first + offset, text, literals
                start, held = None, []


def covered(name, literals):
    """How many characters of `name` the literals account for, as whole words between underscores."""
    left, total = name, 0
    for literal in sorted(set(literals), key=len, reverse=True):
        word = literal.split(".")[-1].strip("_")
        if len(word) < 2:
            continue
        more = "A-Za-z0-9" if word[-1].isdigit() else "A-Za-z"  # a number may be put behind a letter
        found = re.search(rf"(?<![A-Za-z0-9]){re.escape(word)}(?![{more}])", left)
        if found:
            total += len(word)
            left = left[: found.start()] + "|" + left[found.end():]
    return total


class Record:
    """All that the pages know about numbers and figures."""

    def __init__(self, root, data):
        self.root, self.data = root, data
        self.claims = {r["id"]: r for r in read_table(os.path.join(root, "paper/published.ecsv")).rows}
        self.findings, self.quotable = {}, {}
        for r in read_table(os.path.join(root, "paper/converged.ecsv")).rows:
            f = Finding(r["program"], r["id"], float(r["value"]), float(r["error"]), r["unit"], r["kind"])
            self.findings[f.program, f.id] = f
            claim = self.claims.get(f.id)
            if claim and claim["program"] != f.program:
                continue  # the lock remembers an answer that another program gives now
            self.quotable[f.id if claim else f"{f.program}.{f.id}"] = f
        self.add_fresh()
        self.figures = {r["id"]: r for r in read_table(os.path.join(root, "figures/figures.ecsv")).rows}
        self.seconds = {r["program"]: float(r["seconds"]) for r in self.figures.values()}
        self._statements, self._rows = {}, {}
        self.sources = {}  # program -> its sources, set by the weaver
        self.alone = read_commands(os.path.join(root, "book/commands.txt"))

    def add_fresh(self):
        """What was computed and is not locked yet may be quoted as it is, so that a new chapter can be
        read before it is locked."""
        for program in sorted(os.listdir(self.data)) if os.path.isdir(self.data) else ():
            for table, name in (("results", "id"), ("facts", "quantity")):
                path = os.path.join(self.data, program, table + ".ecsv")
                for r in read_table(path).rows if os.path.exists(path) else ():
                    id, claim = r[name], self.claims.get(r[name])
                    if "value" not in r or (program, id) in self.findings or (claim and claim["program"] != program):
                        continue
                    f = Finding(program, id, float(r["value"]), float(r.get("error") or 0), r.get("unit", ""), "value")
                    self.quotable.setdefault(id if claim else f"{program}.{id}", f)

    def cost(self, program):
        seconds = self.seconds.get(program, math.nan)
        if math.isnan(seconds):
            return ""
        return "less than a second" if seconds < 1 else f"{seconds:.0f} s"

    def command(self, program):
        return f"build/bin/{program} --out build/data/{program}"

    def rows_of(self, program, table):
        """Row numbers of a table of results or facts by id; empty where it was not computed."""
        key = program, table
        if key not in self._rows:
            path = os.path.join(self.data, program, table + ".ecsv")
            rows = read_table(path).rows if os.path.exists(path) else []
            name = "id" if table == "results" else "quantity"
            self._rows[key] = {r[name]: i for i, r in enumerate(rows, 1)}
        return self._rows[key]

    def places(self, finding, is_claim):
        """The statements that write a number: the one with its whole name, or that says most of it,
        and where a criterion is judged that one as well."""
        if finding.program not in self._statements:
            self._statements[finding.program] = [
                (bool(s.room), s.path, *x)
                for s in self.sources.get(finding.program, []) for x in statements(s)]
        name, judged = finding.id.split(".")[-1], None
        for library, path, first, last, text, literals in self._statements[finding.program]:
            for subject in literals if "judge(" in text and not is_claim else ():
                prefix = subject.split(".")[-1] + "_"
                if subject in self.claims and finding.id.startswith(prefix):
                    judged = Place(path, first, last, text)
                    name = finding.id[len(prefix):].removesuffix("_margin")
        scored = []
        for library, path, first, last, text, literals in self._statements[finding.program]:
            place, adds = Place(path, first, last, text), "add(" in text
            if finding.id in literals and not library:
                scored.append((1000 + (adds or "claim(" in text or "judge(" in text), place))
                continue
            score = covered(name, literals)
            if is_claim:
                score = max([len(x) for x in literals if "." in x and finding.id.startswith(x)] + [0])
            if score >= 3:
                scored.append((score + 6 * adds + (place == judged) - 4 * library, place))
        best = max(scored, key=lambda s: s[0])[1] if scored else None
        return [p for p in (best, judged if judged != best else None) if p]

    def quote(self, id):
        finding = self.quotable.get(id)
        if not finding:
            raise BookError(f"nothing is locked or computed under '{id}'")
        is_claim = finding.id in self.claims
        table = "results" if is_claim else "facts"
        row = self.rows_of(finding.program, table).get(finding.id, 0)
        return Quote(id, finding, self.claims.get(finding.id, {}), table, row,
                     self.places(finding, is_claim))


def read_commands(path):
    """Commands that compute one number alone, and what they call it, by id."""
    out = {}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            for line in file:
                if line.strip() and not line.startswith("#"):
                    id, _, command = line.strip().partition(" ")
                    command, _, quantity = command.partition("#")
                    out[id] = command.strip(), quantity.strip()
    return out
