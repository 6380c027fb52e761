"""Numbers that other authors have printed, beside ours.

`paper/literature.ecsv` has a row for each: what is printed, with a tolerance from its digits, the program whose fact of the
same name answers it, the source, and how we know it. What we have read ourselves, in a text, its data or its abstract, is
judged like the article's numbers; what is quoted from memory stands beside ours without a verdict."""

from pathlib import Path

from . import ecsv
from .claims import VERDICTS, agreement, alone, printed_range

COLUMNS = ("id", "quantity", "printed", "unit", "class", "tolerance", "program", "obtained", "status", "citation", "where", "note")
OBTAINED = {"text": "read in its text", "data": "read in its data", "abstract": "read in its abstract",
            "memory": "from memory, its source not read"}


def name_of(row):
    """How prose calls our number."""
    return f"{row['program']}.{row['id']}"


def read_literature(root):
    """The rows by id. Judged is what has been read, and nothing else. None are there without the file."""
    path = Path(root) / "paper/literature.ecsv"
    rows = ecsv.read(path, COLUMNS).by("id", "numbers") if path.exists() else {}
    for row in rows.values():
        if row["obtained"] not in OBTAINED:
            raise row.fault(f"{row['id']}: obtained '{row['obtained']}' (allowed: {', '.join(OBTAINED)})")
        if (row["status"] in VERDICTS) == (row["obtained"] == "memory"):
            raise row.fault(f"{row['id']}: a verdict on what has been read, and on nothing else")
        try:
            agreement(printed_range(row["printed"]) or (0, 0, 0), row["tolerance"])
        except ValueError:
            raise row.fault(f"{row['id']}: the tolerance '{row['tolerance']}' is none") from None
    return rows


def verdicts(rows, known):
    """(row, our number, verdict) of each row whose program has run; the verdict is empty where there is none."""
    for row in rows.values():
        if found := known.get(name_of(row)):
            yield row, found, "" if row["obtained"] == "memory" else alone(row, found)


def tally(said):
    """The verdicts counted; an empty one is that of a number whose source was not read."""
    said = list(said)
    return ", ".join([f"{said.count(v)} {v}" for v in VERDICTS if v in said] + [f"{said.count('')} from memory without a verdict"])
