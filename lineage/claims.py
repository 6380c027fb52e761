"""What the article states, what the programs answer, and the verdict.

`paper/published.ecsv` lists the statements, each with the tolerance that was fixed before anything was computed.
`lineage summary` writes them down; the tests judge once more, in C++ (tests/judge.hpp), and ask that both agree."""

import math
import re
from pathlib import Path

from . import ecsv
from .values import Finding
from .volumes import article

MEANINGS = {
    "reproduced": "a printed number, met within its tolerance",
    "holds": "a yes-or-no statement that our criterion confirms",
    "within": "a printed number missed by no more than the accuracy that the article itself prints",
    "measured": "the article uses a word without a number; we give the number and pass no judgement",
    "follows": "missed because the article computes it from another printed number, which is judged in its own row",
    "discrepant": "a printed number missed, or a statement that fails, in every natural reading",
    "unresolved": "the error bar does not allow a verdict, which no test accepts",
    "open": "not answered yet"}
VERDICTS = list(MEANINGS)
COLUMNS = ("id", "section", "where", "quantity", "printed", "unit", "class", "tolerance", "program", "status", "reading",
           "covered_by", "reason")
SAID = {"within": "within its own accuracy", "follows": "follows from another"}  # where one word would not do
QUOTED = re.compile(r"\{([a-z]\w*\.\w+)\}")
NUMBER = r"-?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"


def half_digit(number):
    """Half a unit in the last printed digit."""
    mantissa, _, exponent = number.lower().partition("e")
    return 0.5 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def printed_range(text):
    """What is printed, as (low, high, half a digit): a number, a range ("238 to 241"), a count of orders of
    magnitude or a multiple of pi. None for words, which are a statement."""
    found = re.fullmatch(rf"({NUMBER})(?: pi/({NUMBER}))?(?: to ({NUMBER}))?( orders)?", text)
    if not found or (found[2] and (found[3] or found[4])):
        return None
    low = float(found[1]) * (math.pi / float(found[2]) if found[2] else 1)
    high = float(found[3]) if found[3] else low
    if found[4]:
        low, high = 10 ** low, 10 ** high
    return min(low, high), max(low, high), half_digit(found[1])


def agreement(printed, tolerance):
    """The interval of values that agree with what is printed; ValueError for a tolerance that is none."""
    low, high, half = printed
    size = max(abs(low), abs(high))
    if tolerance == "at most":
        return -math.inf, high
    if tolerance == "order of magnitude":
        return low / 10, high * 10
    amount = {"": half, "exact": 1e-12 * size}.get(tolerance)
    if amount is None:
        kind, _, number = tolerance.partition(" ")
        if kind not in ("rel", "abs") or not re.fullmatch(NUMBER, number) or float(number) < 0:
            raise ValueError(tolerance)
        amount = float(number) * (size if kind == "rel" else 1)
    return low - amount, high + amount


def alone(claim, answer):
    """The verdict from the row and its answer. A yes or a no is no answer to a printed number, and a number that
    answers a word is a measurement. Where the error bar straddles an edge there is no verdict."""
    if answer is None:
        return "open"
    if not math.isfinite(answer.value) or not math.isfinite(answer.error):
        return "unresolved"
    printed = printed_range(claim["printed"])
    in_words = claim["class"] == "claim" or not printed
    if answer.unit == "claim":
        decided = in_words and answer.error == 0
        return {1: "holds", 0: "discrepant"}.get(answer.value, "unresolved") if decided else "unresolved"
    if in_words:
        return "measured"
    low, high = agreement(printed, claim["tolerance"])
    least, most = answer.value - answer.error, answer.value + answer.error
    if low <= least and most <= high:
        return "reproduced"
    return "discrepant" if most < low or least > high else "unresolved"


def covered(claim, answer, by):
    """What covers a number that is missed: `within`, if by this fact of ours the article's own accuracy is not better
    than the distance; `follows`, if the number is the article's other number to a power (`moving.c_threshold^2`) and
    ours, with that number in the place of our own, is what is printed. Else nothing, and it stays discrepant."""
    low, high, _ = printed_range(claim["printed"])
    if isinstance(by, Finding):
        apart = max(low - answer.value, answer.value - high) + answer.error
        return "within" if apart <= by.value - by.error else None
    other, found, power = by
    scale = (printed_range(other["printed"])[0] / found.value) ** power
    theirs = Finding("", "", answer.value * scale, answer.error * scale, answer.unit)
    return "follows" if alone(other, found) == "discrepant" and alone(claim, theirs) == "reproduced" else None


def name_of(finding, claims):
    """How prose calls a finding: a claim by its id, a fact with its program before it."""
    return finding.id if finding.id in claims else f"{finding.program}.{finding.id}"


class Judge:
    """All verdicts on one set of findings: those of a run, or the locked ones."""

    def __init__(self, claims, findings):
        self.claims, self.found = claims, {name_of(f, claims): f for f in findings}

    def answer(self, id):
        found = self.found.get(id)
        return found if found and found.program == self.claims[id]["program"] else None

    def verdict(self, id):
        claim, answer = self.claims[id], self.answer(id)
        said = alone(claim, answer)
        if said != "discrepant" or not claim["covered_by"]:
            return said
        name, _, power = claim["covered_by"].partition("^")
        if name not in self.found:
            raise ecsv.Fault(f"{id}: nothing is known of '{name}', by which it is covered")
        by = (self.claims[name], self.found[name], float(power or 1)) if name in self.claims else self.found[name]
        return covered(claim, answer, by) or said

    def said(self, text):
        """A text of the list of claims with our numbers in the places of their names, `{pn.omega11}`."""
        def shown(m):
            if m[1] not in self.found:
                raise ecsv.Fault(f"paper/published.ecsv: nothing is known of '{m[1]}' (a new number: make lock)")
            return self.found[m[1]].shown

        return QUOTED.sub(shown, text)


def quoted_by(claims):
    """Every number of ours that the list of claims names."""
    return {name for c in claims.values() for name in QUOTED.findall(c["reading"] + c["reason"])
            } | {c["covered_by"].partition("^")[0] for c in claims.values()} - {""}


def read_claims(root):
    """The rows of paper/published.ecsv by id, each with a tolerance and a status that mean something."""
    claims = ecsv.read(article(root) / "paper/published.ecsv", COLUMNS).by("id", "claims")
    for claim in claims.values():
        try:
            agreement(printed_range(claim["printed"]) or (0, 0, 0), claim["tolerance"])
        except ValueError:
            raise claim.fault(f"{claim['id']}: the tolerance '{claim['tolerance']}' is none (allowed: rel 1e-3, "
                              "abs 1e-3, at most, exact, order of magnitude, or nothing)") from None
        if claim["status"] not in VERDICTS or claim["status"] == "unresolved":
            raise claim.fault(f"{claim['id']}: the status '{claim['status']}' is none")
        if (claim["status"] == "open") == bool(claim["program"]):
            raise claim.fault(f"{claim['id']}: a program answers what is not open, and nothing else")
        if claim["reason"] and claim["status"] not in ("within", "follows", "discrepant"):
            raise claim.fault(f"{claim['id']}: a reason, but nothing is missed")
    return claims


def programs_of(root):
    """The programs of a volume: one for each chapter in src/."""
    return sorted(path.stem for path in (Path(root) / "src").glob("sec*.cpp"))


def runs_of(data, programs):
    """The programs that have run to their end, each with its table of results."""
    paths = ((program, Path(data) / program / "results.ecsv") for program in programs)
    return [(program, path) for program, path in paths if path.exists()]


def findings_in(path, program, name):
    """The values of one table of results or facts, by id."""
    out = {}
    for id, row in ecsv.read_written(path, (name, "value")).by(name, "values").items():
        error = float(row.get("error", 0))
        if error < 0:
            raise row.fault(f"{id}: the error {error:g} is negative")
        out[id] = Finding(program, id, float(row["value"]), error, row.get("unit", ""),
                          made_by=row.get("made_by", ""), row=row.number)
    return out


def read_results(data, programs, claims):
    """The answers of the programs that have run, by claim. A claim is answered once, by the program that its row names."""
    out = {}
    for program, path in runs_of(data, programs):
        for id, answer in findings_in(path, program, "id").items():
            place = ecsv.Row({}, path, answer.row)
            if id not in claims:
                raise place.fault(f"'{id}' is no claim of paper/published.ecsv")
            if claims[id]["program"] != program:
                raise place.fault(f"'{id}' is answered by {program}, but paper/published.ecsv says by "
                                  f"{claims[id]['program'] or 'nobody'}")
            out[id] = answer
    return out


def read_facts(data, programs):
    """Their facts, by (program, id)."""
    return {(program, id): fact for program, results in runs_of(data, programs) if (path := results.with_name("facts.ecsv")).exists()
            for id, fact in findings_in(path, program, "quantity").items()}
