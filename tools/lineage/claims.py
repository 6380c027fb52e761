"""What is claimed, beside what was found. The lists of a volume (paper/claims.ecsv, findings.ecsv, literature.ecsv) say
what is printed; a function of src/statements decides each row. The program `verdicts` judges and writes
build/report/claims.ecsv. All three are read here, for README, book and paper, and nothing is judged.

A cell goes by its address (cells.py), the answer to a statement by the statement's id."""

import math
import re
from dataclasses import replace
from pathlib import Path

from . import ecsv
from .cells import cited, with_links
from .values import Finding, distance
from .volumes import article

COLUMNS = ("id", "section", "where", "quantity", "printed", "unit", "tolerance", "assumption", "covered_by", "reason", "cause", "status")
KINDS = {"proved": "by an argument that is written out in the chapter",
         "enclosed": "by interval arithmetic: a theorem, of which a program is a part",
         "computed": "a converged number with its error",
         "observed": "seen in every run of a stated range, which the sentence names"}
OBTAINED = {"text": "read in its text", "data": "read in its data", "abstract": "read in its abstract",
            "memory": "from memory, its source not read"}
QUOTED = re.compile(r"\{(sec[0-9A-Z]\w*/[^{}\s]+|[a-z]\w*\.\w+)\}")
STATEMENT = re.compile(r'^STATEMENT\("([\w.]+)"\)', re.M)
MARKED = re.compile(r"<!-- ([\w.]+) -->\n.*?<!-- /\1 -->", re.S)


def meanings():
    """What each verdict means, in their order."""
    verdicts = Path(__file__).resolve().parents[2] / "paper/verdicts.ecsv"
    return {row["verdict"]: row["meaning"] for row in ecsv.read(verdicts, ("verdict", "meaning")).rows}


def read_statements(root):
    """Where the statements of a volume are judged, by id: (program, path, line)."""
    out = {}
    for path in sorted((Path(root) / "src/statements").glob("*.cpp")):
        text = ecsv.text_of(path)
        out.update({found[1]: (path.stem, path, text.count("\n", 0, found.start()) + 1) for found in STATEMENT.finditer(text)})
    return out


def code_of(path, line):
    """The lines of the function that begins there, as it judges."""
    lines = ecsv.text_of(path).split("\n")[line - 1:]
    return lines[:lines.index("}") + 1]


def read_list(root, name, columns):
    """The rows of a list by id, each with the `program` whose tables decide it."""
    path = Path(root) / f"paper/{name}.ecsv"
    rows, where = ecsv.read(path, columns).by("id", name) if path.exists() else {}, read_statements(root)
    for id, row in rows.items():
        if id not in where:
            raise row.fault(f"{id}: no statement in src/statements judges it")
        row["program"] = where[id][0]
    return rows


def read_claims(root):
    """What the article states, by id."""
    return read_list(article(root), "claims", COLUMNS)


def read_findings(root):
    """What we found in this volume, by id."""
    return read_list(root, "findings", ("id", "sentence", "kind", "range", "tried", "second", "figure", "front"))


def read_literature(root):
    """Numbers that other authors have printed, by id."""
    return read_list(root, "literature", ("id", "quantity", "printed", "unit", "obtained", "citation", "where", "note"))


def read_every(root):
    """All rows of a volume's lists."""
    return (read_claims(root) if Path(root) == article(root) else {}) | read_findings(root) | read_literature(root)


def report_of(root, report=None):
    return Path(report or article(root) / "build/report") / ("claims.ecsv" if Path(root) == article(root) else "claims_beyond.ecsv")


def read_beside(root, what, columns, report=None):
    """A table that `verdicts` has written beside its own, as lists of rows by the id of the statement."""
    path, out = report_of(root, report), {}
    path = path.with_name(f"{path.stem}_{what}.ecsv")
    for row in ecsv.read(path, columns).rows if path.exists() else ():
        out.setdefault(row["id"], []).append(row)
    return out


def read_readings(root, report=None):
    """What other choices give, by statement, of those that have been judged."""
    return read_beside(root, "readings", ("id", "reading", "choice", "value", "error", "unit", "outcome"), report)


def read_comparisons(root, report=None):
    """All that decides, by statement, of those that have been judged."""
    return read_beside(root, "comparisons", ("id", "role", "cells", "small", "small_error", "large", "large_error", "outcome"), report)


def read_moved(root):
    """Every verdict that ever became another one, the latest first: rows of id, version, before, after, why."""
    path = Path(root) / "paper/moved.ecsv"
    return ecsv.read(path, ("id", "date", "before", "after", "why")).rows if path.exists() else []


def read_judged(root, report=None):
    """The rows that `verdicts` has written for this volume, by id."""
    path = report_of(root, report)
    return ecsv.read(path, ("id", "verdict", "found", "state")).by("id", "verdicts") if path.exists() else {}


def read_verdicts(root, report=None):
    """The same; of what has not been judged, what the lists record."""
    every, known = read_every(root), read_judged(root, report)
    return {id: known.get(id, {"verdict": row.get("status", "holds"), "found": "not run", "state": "not run"}) for id, row in every.items()}


# Numbers by name


def programs_of(root):
    """The programs of a volume: one for each chapter in src/."""
    return sorted(path.stem for path in (Path(root) / "src").glob("sec*.cpp"))


def runs_of(data, programs):
    """The programs that have run to their end, each with the folder of its tables, which has a list of them."""
    folders = ((program, Path(data) / program) for program in programs)
    return [(program, folder) for program, folder in folders if (folder / "SHA256SUMS").exists()]


def read_answers(root, report=None):
    """What statements that were judged on full runs found, by (program, answer or failures, id): numbers, and how many
    comparisons fail if not all hold."""
    out = {}
    for id, row in read_judged(root, report).items():
        if row["state"] == "judged" and not math.isnan(row["value"]):
            out[row["program"], "answer", id] = Finding(row["program"], id, row["value"], row["error"], row["unit"], what="answer")
        if row["state"] == "judged" and row["failures"]:
            out[row["program"], "failures", id] = Finding(row["program"], id, row["failures"], what="failures")
    return out


def by_name(found):
    """Cells and answers by their names."""
    return {f.name: f for f in found.values() if f.what in ("cell", "answer")}


def quoted_in(row):
    """The names of all numbers of ours that a row of a list mentions."""
    texts = [str(text) for text in row.values()]
    return {name for text in texts for name in [*QUOTED.findall(text), *cited(text)]}


def shown_at(link, name, numbers):
    """The text of a link to a number of ours; Fault for one that leads nowhere."""
    brackets, _, _, end = link.groups()
    if brackets is None or not end:
        raise ecsv.Fault(f"a link without brackets: {link[0]}")
    if name not in numbers:
        raise ecsv.Fault(f"there is no reference value '{name}' (a new one: make accept)")
    return numbers[name].shown_like(brackets[1:-1])


def said(text, numbers):
    """A text of the list of claims with our numbers, by their names, in the places of these, `{pn.omega11}`."""
    def shown(m):
        if m[1] not in numbers:
            raise ecsv.Fault(f"paper/claims.ecsv: there is no number '{m[1]}' (a new number: make accept)")
        return numbers[m[1]].shown_like("1.000")

    return QUOTED.sub(shown, text)


def read_second(root):
    """What `make second` found, by the name of the number that it computed anew; nothing without the file."""
    path = Path(root) / "paper/second.ecsv"
    if not path.exists():
        return {}
    rows = ecsv.read(path, ("quantity", "value", "error", "unit", "method")).by("quantity", "numbers")
    return {name: (Finding("", name, row["value"], row["error"], row["unit"]), row["method"]) for name, row in rows.items()}


def agrees(name, finding, second):
    """Whether a second route has the same number within the sum of the errors."""
    return name in second and distance(finding, replace(second[name][0], unit=finding.unit)) <= 1


# Sentences of findings stand in their list. `make refresh` writes them into chapters between marks, `<!-- id -->` and
# `<!-- /id -->`; the report quotes them by `\finding{id}`.


def with_sentences(text, rows):
    """`text` as the book shows it: sentences between marks with their links, and their kind of evidence, which leads to the row."""
    def told(found):
        row = rows.get(found[1])
        return f"{row['sentence']} [{row['kind']}](finding:{row['id']})" if row else found[0]

    return MARKED.sub(told, text)


def in_plain(sentence, numbers):
    """The sentence with its numbers as texts, by their names."""
    return with_links(sentence, lambda link, name: shown_at(link, name, numbers))


def check_quotations(rows, texts):
    """Fault for a finding that none of the texts quotes."""
    quoted = {id for text in texts for id in re.findall(r"<!-- /([\w.]+) -->|\\finding\{([^}#]+)\}", text) for id in id}
    for id, row in rows.items():
        if id not in quoted:
            raise row.fault(f"{id}: it is quoted in no chapter and no page of the report")
