"""A number in a table by its address, `sec34_impact/velocity_sweep/velocity=0.94/s=-0.7/packet`: program, table, as many keys as
make the row unique, and the column, whose error stands in `packet_error`. Within a chapter the program is left out, and of the
next cell on a line all that is as before: `cell:s=0/packet`, `cell:speed`. Prose cites results so,
`[0.0650](cell:velocity_sweep/velocity=0.94/s=-0.7/packet)`, and answers by the statement, `[0.0984](statement:impact.tail)`."""

import re
from functools import lru_cache
from pathlib import Path

from . import ecsv
from .values import Finding

LINK = re.compile(r"(\[[^\]]*\])?\((cell|statement):([^)\n]*)(\)?)")
KEY = re.compile(r"(\w+)=(-?\d+/\d+|[^/]+)")
ADDRESS = re.compile(rf"(?:(sec[0-9A-Z]\w*)/)?(\w+)((?:/{KEY.pattern})*)/(\w+)".replace("(\\w+)=(", "(?:\\w+)=(?:"))


def home_of(path):
    """The program whose chapter a file is, or nothing."""
    path = Path(path)
    return path.stem if path.parent.name == "src" and path.name.startswith("sec") else ""


def follow(address, before, home):
    """The whole address. One without a table goes on from the one `before` it on the line: other keys, or another column."""
    keys, column = KEY.findall(address), address.rpartition("/")[2]
    if not re.match(rf"(?:{KEY.pattern}/)*\w+$", address):
        return address if re.match(r"sec[0-9A-Z]\w*/", address) or not home else f"{home}/{address}"
    if not before:
        raise ecsv.Fault(f"cell:{address} goes on from no cell on its line")
    known = dict(KEY.findall(before)) | dict(keys)
    return "/".join([*before.split("/")[:2], *(f"{key}={value}" for key, value in known.items()), column])


def links(text, home=""):
    """Every link to a number of ours, with the name of that number, in turn; nothing where a comment shows the form."""
    before, end = "", 0
    for link in LINK.finditer(text):
        _, kind, id, _ = link.groups()
        if kind == "cell" and id != "...":
            before = follow(id, before if "\n" not in text[end:link.start()] else "", home)
            end = link.end()
        yield link, "" if id == "..." else before if kind == "cell" else id


def with_links(text, change, home=""):
    """`text` with `change(link, name)` in the place of each of these links."""
    out, done = "", 0
    for link, name in links(text, home):
        out += text[done:link.start()] + (change(link, name) if name else link[0])
        done = link.end()
    return out + text[done:]


def in_full(text, home=""):
    """`text` with whole addresses."""
    return with_links(text, lambda link, name: f"{link[1]}({link[2]}:{name})", home)


def cited(text, home=""):
    """The names of all numbers that a text links to."""
    return {name for _, name in links(text, home) if name}


def is_same(cell, wanted):
    """Numbers are keys to nine digits; a text is one with its spaces as underscores."""
    if isinstance(cell, str):
        return cell.replace(" ", "_") == wanted
    try:
        over, _, under = wanted.partition("/")
        number = float(over) / float(under or 1)
    except ValueError:
        return False
    return cell == number or abs(cell - number) <= max(1e-9 * abs(number), 1e-12)


@lru_cache
def written(path, _changed):
    return ecsv.read_written(path)


def read_cell(data, address):
    """The result at an address. Fault where no row, or more than one, has its keys, or the column is none of a result."""
    found = ADDRESS.fullmatch(address)
    if not found or not found[1]:
        raise ecsv.Fault(f"'{address}' is no address of a cell (program/table/key=value/column)")
    program, table, keys, column = found.groups()
    path = Path(data) / program / f"{table}.ecsv"
    read = written(path, path.stat().st_mtime_ns if path.exists() else 0)
    columns, wanted = {one.name: one for one in read.columns}, KEY.findall(keys)
    if lost := [name for name in [column, *(key for key, _ in wanted)] if name not in columns]:
        raise ecsv.Fault(f"{address}: {path} has no column '{lost[0]}'")
    rows = [row for row in read.rows if all(is_same(row[key], value) for key, value in wanted)]
    if len(rows) != 1:
        at = ", ".join(f"{key} = {value}" for key, value in wanted) or "no key"
        raise ecsv.Fault(f"{address}: {len(rows) or 'no'} row{'s' * (len(rows) > 1)} of {path} with {at}")
    kind, row = columns[column].kind, rows[0]
    if kind == "string" or kind == "float64" and f"{column}_error" not in columns:
        raise ecsv.Fault(f"{address}: the column '{column}' has no error beside it")
    error = 0.0 if kind == "int64" else row[f"{column}_error"]
    return Finding(program, address.partition("/")[2], float(row[column]), error, columns[column].unit, what="cell")


def read_cells(data, programs, names):
    """The results at those of these addresses whose programs have run, by (program, "cell", address)."""
    ran = {program for program in programs if (Path(data) / program / "SHA256SUMS").exists()}
    found = (read_cell(data, name) for name in sorted(names) if name.partition("/")[0] in ran)
    return {one.key: one for one in found}
