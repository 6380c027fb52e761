"""What the pages know of numbers and figures: claims, locked and fresh values, and the lines that made them."""

import math
import re
from dataclasses import dataclass, replace
from pathlib import Path

from .. import ecsv
from ..chapters import explained_by, read_commands, read_costs, run_of
from ..claims import Judge, name_of, programs_of, read_claims
from ..findings import agrees, read_findings, read_second
from ..literature import read_literature, verdicts
from ..lock import read_fresh, read_lock
from ..refresh import read_figures
from ..tex import captions
from ..values import Finding
from ..volumes import joined, volumes
from . import origin

# A fact is called as a column of its program's tables, with what it belongs to behind: `speed_bond_compressed`.
OF_WHAT = re.compile(r"(?:_(?:\d+|[a-z]\d*|mu\d+|minus|plus|site|bond|compressed|stretched|soft|linear|hard))*")
WELLS = {"s_minus_1_6": "s = -1/6", "s_1_6": "s = -1/6", "s_0_7": "s = -0.7", "s_0": "s = 0", "s_1": "s = 1"}


def computed(root, data):
    """The volumes that a book has: the article, and what is beyond it where it was computed."""
    first, *more = volumes(root)
    return [first] + [one for one in more if any((Path(data) / program).is_dir() for program in programs_of(one))]


def worded(id):
    """A name of a fact without its underscores, a well as the article writes it."""
    for name, well in WELLS.items():
        id = re.sub(rf"(?<![^_]){name}(?![^_])", well, id)
    return id.replace("_", " ").strip()


@dataclass(frozen=True)
class Quote:
    """A number as prose names it, and all that is known about it."""
    id: str
    finding: Finding
    claim: dict  # empty for a fact
    places: list

    @property
    def table(self):
        return "results" if self.claim else "facts"


class Record:
    def __init__(self, root, data):
        self.root, self.data = Path(root), Path(data)
        all = self.volumes = computed(root, data)
        self.claims, self.figures = read_claims(root), joined(read_figures, all)
        self.locked = joined(read_lock, all)
        fresh = read_fresh(data, [program for folder in all for program in programs_of(folder)], self.claims)
        known = dict(self.locked)  # what is not locked may be quoted as it was computed
        known.update({key: replace(self.locked.get(key, f), made_by=f.made_by, row=f.row) for key, f in fresh.items()})
        self.quotable = {name_of(f, self.claims): f for f in known.values()
                         if self.claims.get(f.id, {}).get("program", f.program) == f.program}
        judge = Judge(self.claims, self.quotable.values())
        self.explained_by = {id: explained_by(id, self.claims) for id in self.claims}
        for claim in self.claims.values():
            claim.update({key: judge.said(claim[key]) for key in ("reading", "reason")})
        self.findings, self.second = joined(read_findings, all), joined(read_second, all)
        self.literature = list(verdicts(joined(read_literature, all), self.quotable))
        self.seconds, self.alone = joined(read_costs, all), joined(read_commands, all)
        self.captions = joined(captions, all)  # figure -> what its caption says after the first sentence, in TeX
        self.sources = {}  # program -> its sources, set by the weaver
        self._columns, self._quotes = {}, {}

    def cost(self, program):
        seconds = self.seconds.get(program, math.nan)
        if math.isnan(seconds):
            return ""
        return "less than a second" if seconds < 1 else f"{seconds:.0f} s"

    def second_route(self, id):
        """The number that another program has found by another method, and the method, where it agrees with ours."""
        return self.second[id] if id in self.quotable and agrees(id, self.quotable[id], self.second) else None

    def command(self, program):
        return run_of(program)

    def table_path(self, program, table):
        return self.data / program / f"{table}.ecsv"

    def columns(self, program):
        """What the columns of a program's tables mean, by name."""
        if program not in self._columns:
            self._columns[program] = {c.name: c.description for path in sorted((self.data / program).glob("*.ecsv"))
                                      for c in ecsv.header_of(ecsv.text_of(path))[0]}
        return self._columns[program]

    def title(self, finding):
        """A fact in words: those of the column that it is called after, else its name. The condition of a criterion
        says which statement it decides."""
        claim = next((c for c in self.claims.values() if c["program"] == finding.program
                      and finding.id.startswith(c["id"].split(".")[-1] + "_")), None)
        id, columns = finding.id, self.columns(finding.program)
        if claim:
            id = id.removeprefix(claim["id"].split(".")[-1] + "_")
        margin, id = id.endswith("_margin"), id.removesuffix("_margin")
        names = [n for n in columns if id.startswith(n) and OF_WHAT.fullmatch(id[len(n):]) and len(n) > 2]
        said = worded(id)
        if names:
            name = max(names, key=len)
            rest = worded(id[len(name):])
            said = worded(name) + (f" ({rest})" if rest else "") + ": " + columns[name]
        return ("margin of " if margin else "") + said + (f", a condition of {claim['id']}" if claim else "")

    def quote(self, id):
        if id not in self._quotes:
            finding = self.quotable.get(id)
            if not finding:
                raise ecsv.Fault(f"nothing is locked or computed under '{id}'")
            places = origin.places(finding, self.claims, self.sources.get(finding.program, []))
            self._quotes[id] = Quote(id, finding, self.claims.get(finding.id, {}), places)
        return self._quotes[id]
