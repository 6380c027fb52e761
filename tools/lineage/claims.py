"""What is claimed, beside what was found. The lists of a volume (paper/claims.ecsv, findings.ecsv, literature.ecsv) say
what is printed; a function of src/statements decides each row. The program `verdicts` judges and writes
build/report/claims.ecsv. All three are read here, for README, book and paper, and nothing is judged.

A fact goes by `program.quantity`, the answer to a statement by the statement's id."""

import math
import re
from dataclasses import replace
from pathlib import Path

from . import ecsv
from .values import Finding, distance
from .volumes import article

COLUMNS = ("id", "section", "where", "quantity", "printed", "unit", "tolerance", "assumption", "covered_by", "reason", "cause", "status")
KINDS = {"proved": "by an argument that is written out in the chapter",
         "enclosed": "by interval arithmetic: a theorem, of which a program is a part",
         "computed": "a converged number with its error",
         "observed": "seen in every run of a stated range, which the sentence names"}
OBTAINED = {"text": "read in its text", "data": "read in its data", "abstract": "read in its abstract",
            "memory": "from memory, its source not read"}
MEANT = re.compile(r"^\| ([a-z, ]+?) \| (.+?) \|$", re.M)
QUOTED = re.compile(r"\{([a-z]\w*\.\w+)\}")
NUMBERS = re.compile(r"\[[^\]]*\]\(num:([^)]+)\)")
STATEMENT = re.compile(r'^STATEMENT\("([\w.]+)"\)', re.M)
QUOTE = re.compile(r"(\[[^\]]*\])?\(finding:([^)\n]*)(\)?)")


def meanings():
    """What each verdict means, in their order: the table in src/report/verdict.hpp, where they are given."""
    header = Path(__file__).resolve().parents[2] / "src/report/verdict.hpp"
    return {word: text for word, text in MEANT.findall(ecsv.text_of(header)) if word != "verdict"}


def read_statements(root):
    """Where the statements of a volume are judged, by id: (program, path, line)."""
    out = {}
    for path in sorted((Path(root) / "src/statements").glob("*.cpp")):
        text = ecsv.text_of(path)
        out.update({found[1]: (path.stem, path, text.count("\n", 0, found.start()) + 1) for found in STATEMENT.finditer(text)})
    return out


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


def is_number(printed):
    """Whether what is printed begins as a number does; else it is words."""
    return bool(re.match(r"-?[.\d]", printed))


def report_of(root, report=None):
    return Path(report or article(root) / "build/report") / ("claims.ecsv" if Path(root) == article(root) else "claims_beyond.ecsv")


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


def read_facts(data, programs):
    """The facts of the programs that have run, by (program, "fact", id); Fault if any of their tables was changed since."""
    out = {}
    for path in (path for _, folder in runs_of(data, programs) for path in ecsv.tables_in(folder) if path.name == "facts.ecsv"):
        program = path.parent.name
        for id, row in ecsv.read_written(path, ("quantity", "value")).by("quantity", "values").items():
            error = float(row.get("error", 0))
            if error < 0:
                raise row.fault(f"{id}: the error {error:g} is negative")
            out[program, "fact", id] = Finding(program, id, float(row["value"]), error, row.get("unit", ""))
    ecsv.check_all_written(data)
    return out


def read_answers(root, report=None):
    """What statements that were judged on full runs found, by (program, answer or margin, id): numbers, and the least
    margin of comparisons."""
    out = {}
    for id, row in read_judged(root, report).items():
        for what, value, error in (("answer", "value", "error"), ("margin", "margin", "margin_error")):
            if row["state"] == "judged" and not math.isnan(row[value]):
                found = Finding(row["program"], id, row[value], row[error], row["unit"], what=what)
                out[found.key] = found
    return out


def by_name(found):
    """Facts and answers by their names."""
    return {f.name: f for f in found.values() if f.what != "margin"}


def quoted_in(row):
    """The names of all numbers of ours that a row of a list mentions."""
    texts = [str(text) for text in row.values()]
    return {name for text in texts for name in [*QUOTED.findall(text), *NUMBERS.findall(text)]}


def said(text, numbers):
    """A text of the list of claims with our numbers, by their names, in the places of these, `{pn.omega11}`."""
    def shown(m):
        if m[1] not in numbers:
            raise ecsv.Fault(f"paper/claims.ecsv: there is no number '{m[1]}' (a new number: make accept)")
        return numbers[m[1]].shown

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


# Sentences of findings stand in their list and nowhere else; chapters quote them by `[](finding:id)`, the report by
# `\finding{id}`.


def words_of(text):
    """A text without links, marks of comments and line breaks, to compare sentences."""
    text = re.sub(r"^\s*(?:\*|///?|%)+ ?", "", text, flags=re.M)
    return re.sub(r"\s+", " ", NUMBERS.sub("#", re.sub(r"\\num\{[^}]*\}", "#", text))).strip()


def with_sentences(text, rows, sentence):
    """`text` with `sentence(row)` for each `[](finding:id)`; Fault for a quotation of nothing."""
    def told(found):
        brackets, id, end = found.groups()
        if id in ("id", "..."):
            return found[0]  # the form itself, where a comment explains it
        if brackets != "[]" or not end:
            raise ecsv.Fault(f"this is not of the form [](finding:id): {found[0]}")
        if id not in rows:
            raise ecsv.Fault(f"paper/findings.ecsv has no finding '{id}'")
        return sentence(rows[id])

    return QUOTE.sub(told, text)


def with_kind(row):
    """The sentence as the book shows it: with its kind of evidence, a link to its row."""
    return f"{row['sentence']} [{row['kind']}](finding:{row['id']})"


def in_plain(sentence, numbers):
    """The sentence with its numbers as texts, by their names."""
    if lost := [name for name in NUMBERS.findall(sentence) if name not in numbers]:
        raise ecsv.Fault(f"paper/findings.ecsv: there is no reference value '{lost[0]}' (a new one: make accept)")
    return NUMBERS.sub(lambda m: numbers[m[1]].shown_as_interval if m[0].startswith("[to]") else numbers[m[1]].shown, sentence)


def check_quotations(rows, texts):
    """Fault unless every finding is quoted in one of the texts, by path, and stands in none of them word by word."""
    quoted = set()
    for path, text in texts.items():
        quoted.update(id for _, id, _ in QUOTE.findall(text))
        quoted.update(re.findall(r"\\finding\{([^}#]+)\}", text))
        try:
            with_sentences(text, rows, lambda row: "")
        except ecsv.Fault as fault:
            raise ecsv.Fault(f"{path}: {fault}") from None
        bare = words_of(text)
        for id, row in rows.items():
            if words_of(row["sentence"]) in bare:
                raise ecsv.Fault(f"{path}: the sentence of {id} is typed here; write [](finding:{id})")
    for id, row in rows.items():
        if id not in quoted:
            raise row.fault(f"{id}: it is quoted in no chapter and no page of the report")
