"""Tables as the programs write them: ECSV 1.0, comma-separated rows under a header in comments.

Of the header's YAML we read what is written: a column on a line of its own, then the provenance. Whatever is
wrong with a file is said in one line that names the file and the row."""

import csv
import hashlib
import math
import os
import re
from dataclasses import dataclass, field
from pathlib import Path

QUOTED = r"'((?:[^']|'')*)'"
COLUMN = re.compile(rf"# - \{{name: {QUOTED}(?:, unit: {QUOTED})?, datatype: (\w+)(?:, description: {QUOTED})?\}}$")
ENTRY = re.compile(rf"# - \{{(\w[\w ]*): {QUOTED}\}}$")
SUM = re.compile(r"^([0-9a-f]{64})  (\S+)$", re.M)


class Fault(Exception):
    """What cannot be used, in one line for the person who can mend it."""
    code = 1


class Unknown(Fault):
    """A name on the command line that means nothing."""
    code = 2


@dataclass(frozen=True)
class Column:
    name: str
    kind: str = "string"  # or float64, int64
    description: str = ""
    unit: str = ""


class Row(dict):
    """Cells by the names of their columns, and where they stand: `build/data/x/speeds.ecsv: row 3`."""

    def __init__(self, cells, path, number):
        super().__init__(cells)
        self.path, self.number = path, number

    def fault(self, message):
        return Fault(f"{self.path}: row {self.number}: {message}")


@dataclass
class Table:
    columns: list
    rows: list = field(default_factory=list)
    meta: dict = field(default_factory=dict)

    def by(self, name, what="rows"):
        """The rows by their cell in column `name`, or by their cells in several, which no two may share."""
        out = {}
        for row in self.rows:
            key = row[name] if isinstance(name, str) else tuple(row[one] for one in name)
            if key in out:
                raise row.fault(f"two {what} for '{key if isinstance(name, str) else ' '.join(key)}' (the first: row {out[key].number})")
            out[key] = row
        return out


def text_of(path):
    try:
        return Path(path).read_bytes().decode("utf-8")
    except FileNotFoundError:
        raise Fault(f"{path} is missing") from None
    except (OSError, UnicodeDecodeError) as error:
        raise Fault(f"{path}: cannot be read ({getattr(error, 'strerror', None) or 'not UTF-8'})") from None


def lines_of(path):
    """The lines of a list that is no table, without remarks; none without the list."""
    lines = map(str.strip, text_of(path).splitlines() if Path(path).exists() else ())
    return [line for line in lines if line and not line.startswith("#")]


def value_of(text, column):
    """A cell as its column promises it; an empty number is nan. Raises ValueError."""
    if column.kind == "float64":
        return float(text or "nan")
    return int(text) if column.kind == "int64" else text


def row_of(cells, columns, path, number):
    row = Row({}, path, number)
    if len(cells) != len(columns):
        raise row.fault(f"{len(cells)} cells under {len(columns)} columns (is the file cut off?)")
    for cell, column in zip(cells, columns):
        try:
            row[column.name] = value_of(cell, column)
        except ValueError:
            raise row.fault(f"'{cell}' in the column '{column.name}' is not a number") from None
    return row


def header_of(text):
    """The columns and the provenance that the comments describe."""
    lines = [line for line in text.split("\n") if line.startswith("# - {")]
    unquoted = [[(group or "").replace("''", "'") for group in found.groups()] for found in map(COLUMN.match, lines) if found]
    columns = [Column(name, kind, description, unit) for name, unit, kind, description in unquoted]
    return columns, {found[1]: found[2].replace("''", "'") for found in map(ENTRY.match, lines) if found}


def read(path, needed=()):
    """The table in a file; Fault unless it is whole and has the columns `needed`."""
    return parse(text_of(path), path, needed)


def parse(text, path="<text>", needed=()):
    columns, meta = header_of(text)
    lines = [line for line in text.split("\n") if line and not line.startswith("#")]
    if not columns or not lines:
        raise Fault(f"{path}: not a table ({'it is empty' if not text.strip() else 'it ends in its header'})")
    try:
        names, *rows = csv.reader(lines, strict=True)
    except csv.Error as error:
        raise Fault(f"{path}: unbalanced quotes, or a line break in a cell ({error})") from None
    if names != [column.name for column in columns]:
        raise Fault(f"{path}: the column names above the rows differ from those of the header")
    for name in needed:
        if name not in names:
            raise Fault(f"{path}: there is no column '{name}'")
    table = Table(columns, [row_of(cells, columns, path, i) for i, cells in enumerate(rows, 1)], meta)
    if not text.endswith("\n"):
        raise Fault(f"{path}: row {len(rows)}: the file is cut off")
    return table


# A table that was changed or cut after its program had run answers for nothing. Last of all a program lists its tables with
# their SHA-256, as sha256sum does, in SHA256SUMS.


def rows_of(text):
    """The lines of a table without its header: the names of the columns, and the rows."""
    return [line for line in text.removesuffix("\n").split("\n") if not line.startswith("#")]


def sha256(text):
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def sums_of(path):
    """The sums that a list has, by the names of the files; none if there is no list."""
    return {name: known for known, name in SUM.findall(text_of(path))} if Path(path).exists() else {}


def sums_in(folder):
    """Those of the tables of a run; none if it did not end."""
    return sums_of(Path(folder) / "SHA256SUMS")


def tables_in(folder):
    """The tables of a run; none if it did not end."""
    return [Path(folder) / name for name in sums_in(folder)]


def maker_of(folder):
    """The compiler and the libraries of the program whose tables these are."""
    made = read(Path(folder) / "run.ecsv", ("what", "value")).by("what")
    return ", ".join(made[what]["value"] for what in ("build", "libraries"))


def check_written(path, text):
    """Fault if the text is not what the program wrote into the file, or if it is of a quick run and not in `quick/data`,
    where a full one does no harm."""
    quick = re.search(r"^# - \{parameters: '(?:[^'\n]*, )?quick = yes[,']", text, re.M)
    if quick and path.resolve().parents[2].name != "quick":
        raise Fault(f"{path}: from a quick run; remove {path.parent} to recompute it")
    if sums_in(path.parent).get(path.name) != sha256(text):
        raise Fault(f"{path}: not as SHA256SUMS has it; remove it to recompute it")


def faults_of(paths):
    """A Fault for each table that is not what its program wrote, or is missing."""
    for path in map(Path, paths):
        try:
            check_written(path, text_of(path))
        except Fault as fault:
            yield fault


def altered(data):
    """The same for all tables of the runs that are complete, and for those that are of no run."""
    for folder in sorted(sums.parent for sums in Path(data).glob("*/SHA256SUMS")):
        there = {path for path in folder.glob("[!.]*.ecsv") if path.name != "run.ecsv"}
        yield from faults_of(sorted(there.union(tables_in(folder))))


def check_all_written(data):
    """Fault for the first of these."""
    for fault in altered(data):
        raise fault


def forget_incomplete(data):
    """Removes the list of a run that has lost a table, so that its program runs again, and tells what is lost."""
    for sums in sorted(Path(data).glob("*/SHA256SUMS")):
        for path in (path for path in tables_in(sums.parent) if not path.exists()):
            sums.unlink(missing_ok=True)
            yield path


def read_written(path, needed=()):
    """The table in a file that a program wrote."""
    text = text_of(path)
    table = parse(text, path, needed)
    check_written(Path(path), text)
    return table


# Writing: 17 digits restore every bit, and a text is quoted only where it would be misread.


def cell_text(cell):
    if isinstance(cell, float):
        return f"{cell:.17g}"
    cell = str(cell)
    return '"' + cell.replace('"', '""') + '"' if not cell or re.search('[,"#]', cell) else cell


def to_text(table):
    def quoted(text):
        return "'" + text.replace("'", "''") + "'"

    out = ["# %ECSV 1.0", "# ---", "# delimiter: ','", "# datatype:"]
    out += [f"# - {{name: {quoted(c.name)}, unit: {quoted(c.unit)}, datatype: {c.kind}, "
            f"description: {quoted(c.description)}}}" for c in table.columns]
    out += ["# meta: !!omap"] + [f"# - {{{key}: {quoted(value)}}}" for key, value in table.meta.items()]
    out += ["# schema: astropy-2.0", ",".join(c.name for c in table.columns)]
    out += [",".join(cell_text(row[c.name]) for c in table.columns) for row in table.rows]
    return "\n".join(out) + "\n"


def write_whole(path, text):
    """Under a temporary name of its own and then renamed, so that nobody reads half a file."""
    part = Path(f"{path}.{os.getpid()}.part")
    try:
        part.parent.mkdir(parents=True, exist_ok=True)
        part.write_bytes(text.encode("utf-8"))
        os.replace(part, path)
    except OSError as error:
        part.unlink(missing_ok=True) if part.parent.is_dir() else None
        raise Fault(f"{path}: cannot be written ({error.strerror})") from None
