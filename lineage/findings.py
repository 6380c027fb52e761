"""What we found beyond the article, held to the rule that the article is held to.

`paper/findings.ecsv` has a row for each finding. Its sentence stands there and nowhere else: chapters quote it by
`[](finding:id)`, the report by `\\finding{id}`, and README and book take it from there. Its criterion is a list of
conditions on facts, `program.fact > 0.5; program.fact < program.other`, each of which has to hold by more than the error
bars, and could fail. The kinds of evidence are

    proved     by an argument that is written out in the chapter
    enclosed   by interval arithmetic: a theorem, too, of which a program is a part
    computed   a converged number with its error
    observed   seen in all runs of a stated range, which the sentence names

`paper/second.ecsv` has what `make second` found by another way (tests/second); a number that agrees carries a mark."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

from . import ecsv
from .claims import NUMBER
from .values import Finding, distance

KINDS = {"proved": "by an argument that is written out in the chapter",
         "enclosed": "by interval arithmetic: a theorem, of which a program is a part",
         "computed": "a converged number with its error",
         "observed": "seen in every run of a stated range, which the sentence names"}
COLUMNS = ("id", "sentence", "kind", "range", "tried", "criterion", "second", "figure")
MOST = 30
NAME = r"[a-z]\w*\.\w+"
CONDITION = re.compile(rf"({NAME}) ([<>]) ({NUMBER}|{NAME})")
QUOTE = re.compile(r"(\[[^\]]*\])?\(finding:([^)\n]*)(\)?)")
NUMBERS = re.compile(r"\[[^\]]*\]\(num:([^)]+)\)")


def read_findings(root):
    """The rows by id; Fault for a row that could not be judged. None are there without the file."""
    path = Path(root) / "paper/findings.ecsv"
    if not path.exists():
        return {}
    rows = ecsv.read(path, COLUMNS).by("id", "findings")
    if len(rows) > MOST:
        raise ecsv.Fault(f"{path}: {len(rows)} findings (allowed: at most {MOST})")
    said = {}
    for id, row in rows.items():
        if row["kind"] not in KINDS:
            raise row.fault(f"{id}: the kind '{row['kind']}' is none (allowed: {', '.join(KINDS)})")
        if not row["criterion"] or not all(map(CONDITION.fullmatch, row["criterion"].split("; "))):
            raise row.fault(f"{id}: the criterion is no list of conditions such as 'program.fact > 0.5; program.a < program.b'")
        if missing := [name for name in ("sentence", "range", "tried", "second") if not row[name]]:
            raise row.fault(f"{id}: no {missing[0]}")
        named = row["range"].partition(";")[0]
        if row["kind"] == "observed" and named not in row["sentence"]:
            raise row.fault(f"{id}: observed, but its sentence does not say '{named}', with which its range begins")
        if (bare := words_of(row["sentence"])) in said:
            raise row.fault(f"{id}: says the same as {said[bare]}")
        said[bare] = id
    return rows


def conditions(row):
    """Its conditions as (fact, `<` or `>`, number or another fact)."""
    return [CONDITION.fullmatch(one).groups() for one in row["criterion"].split("; ")]


def names_in(row):
    """The numbers of ours of which its conditions speak."""
    return {name for fact, _, limit in conditions(row) for name in (fact, limit) if re.fullmatch(NAME, name)}


def quoted_in(row):
    """The names of all numbers of ours that a row mentions."""
    return names_in(row) | {name for column in ("sentence", "range", "tried", "second") for name in NUMBERS.findall(row[column])}


def named(name, row, found):
    """The number of this name; Fault if there is none."""
    if name not in found:
        raise row.fault(f"{row['id']}: nothing is known of '{name}' (a new number: make lock)")
    return found[name]


@dataclass(frozen=True)
class Margin:
    """What a condition asks, and how far the number is from its limit."""
    name: str
    value: Finding
    side: str
    limit: str  # a number or the name of one
    other: Finding
    left: float
    error: float

    @property
    def is_kept(self):
        return self.left > self.error


def margins(row, found):
    """The margins of all conditions; `found` has numbers by name."""
    for name, side, limit in conditions(row):
        value = named(name, row, found)
        other = named(limit, row, found) if re.fullmatch(NAME, limit) else Finding("", "", float(limit))
        left = (value.value - other.value) * (1 if side == ">" else -1)
        yield Margin(name, value, side, limit, other, left, value.error + other.error)


def holds(row, found):
    return all(m.is_kept for m in margins(row, found))


def tally(rows):
    """How many there are of each kind, in words."""
    kinds = [row["kind"] for row in rows.values()]
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in KINDS)


# The second route


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


# Sentences


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
            raise ecsv.Fault(f"this is no [](finding:id): {found[0]}")
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
        raise ecsv.Fault(f"paper/findings.ecsv: nothing is locked under '{lost[0]}' (a new one: make lock)")
    return NUMBERS.sub(lambda m: numbers[m[1]], sentence)


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
                raise ecsv.Fault(f"{path}: the sentence of {id} is typed here; say [](finding:{id})")
    for id, row in rows.items():
        if id not in quoted:
            raise row.fault(f"{id}: no chapter and no page of the report quotes it")
