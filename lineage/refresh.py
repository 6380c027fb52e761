"""Numbers in prose. Nobody types a result: `[](num:pn.omega11)` names the answer to a claim and
`[](num:sec32_dps_profiles.norm_site)` a fact of a program, and the text of the link is the locked value. This
file writes those texts, the tables of README.md and ARTIFACT.md, the costs in figures/figures.ecsv, and the files
that say to others what codemeta.json says (metadata.py).

The quoted values are the locked ones and not the fresh ones, because another compiler may change a digit of a
rounding residue; that fresh and locked values agree is asserted on its own."""

import csv
import math
import re
from pathlib import Path

from . import ecsv, metadata
from .claims import SAID, VERDICTS, Judge, name_of, read_claims
from .lock import read_lock, sources
from .values import with_digits, without_zeros

LINK = re.compile(r"(\[[^\]]*\])?\(num:([^)\n]*)(\)?)")
MARK = re.compile(r"<!--num:([\w.]+)-->[^<\n]*<!--/-->")
PAGES = ("README.md", "ARTIFACT.md")


def with_numbers(text, numbers):
    """`text` with every link `[...](num:id)` renewed; Fault for an id that is not there, so that a reference that
    dangles cannot be written."""
    def renewed(found):
        brackets, id, end = found.groups()
        if id == "...":
            return found[0]  # the form itself, where a comment explains it
        if brackets is None or not end:
            raise ecsv.Fault(f"a link without brackets: {found[0]}")
        if id not in numbers:
            raise ecsv.Fault(f"nothing is locked under '{id}' (a new one: make lock)")
        return f"[{numbers[id]}](num:{id})"

    return LINK.sub(renewed, text)


def with_marked_numbers(text, numbers):
    """The same for a page that others show, where such a link would lead nowhere: `<!--num:id-->value<!--/-->`, of
    which a reader sees the value. Fault for a mark that is not whole, or an id that is not there."""
    if len(MARK.findall(text)) != text.count("<!--num:") or text.count("<!--num:") != text.count("<!--/-->"):
        raise ecsv.Fault("a number whose two marks do not match")
    for id in MARK.findall(text):
        if id not in numbers:
            raise ecsv.Fault(f"nothing is locked under '{id}' (a new one: make lock)")
    return MARK.sub(lambda found: f"<!--num:{found[1]}-->{numbers[found[1]]}<!--/-->", text)


def quotable(lock, claims):
    """Every text that prose may quote, by its name."""
    return {name_of(f, claims): f.shown for f in lock.values()}


# The tables of README.md and ARTIFACT.md. Where the article and we differ, the list of claims says why.


def here(finding, said):
    """What we found, where the verdict does not say it all: a statement that holds is said once."""
    return "" if finding.shown == said else finding.shown + finding.shown_unit


def published_rows(claims, lock):
    judge = Judge(claims, lock.values())
    yield "| claim | what is claimed | article | asked | here | error | verdict |"
    yield "|---|---|---|---|---|---|---|"
    for id, c in claims.items():
        f = lock.get((c["program"], id))
        if f:
            said = judge.verdict(id)
            read = "".join(f"<br>*{word}:* {judge.said(c[key])}" for word, key in (("Read", "reading"), ("Why", "reason"))
                           if c[key] and not (key == "reason" and said == "discrepant"))
            cells = [f"`{id}`", c["quantity"] + read, printed(c), c["tolerance"], here(f, said), f.shown_error, SAID.get(said, said)]
            yield "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def printed(claim):
    """What the article prints, with a unit where it is a number."""
    text = claim["printed"]
    return f"{text} {claim['unit']}" if claim["unit"] and re.fullmatch(r"[-+.\de]+", text) else text


def discrepancy_rows(claims, lock):
    judge = Judge(claims, lock.values())
    yield "| claim | article | here | why |"
    yield "|---|---|---|---|"
    for id, c in claims.items():
        f = lock.get((c["program"], id))
        if f and c["status"] == "discrepant":
            yield f"| `{id}` | {c['printed']} | {f.shown} | {judge.said(c['reason'])} |"


def tally(statuses):
    """The verdicts counted, in the words of the summary."""
    words = SAID | {"holds": "hold", "follows": "following from another"}
    return ", ".join(f"{list(statuses).count(v)} {words.get(v, v)}" for v in VERDICTS)


def summary_rows(claims, figures):
    """What `make figures` ends with, as whoever runs it wants to know beforehand."""
    return ["```", f"figures    : {len(figures)} in build/figures (svg, pdf, png)",
            f"claims     : {tally([c['status'] for c in claims.values()])}", "```"]


def command_of(figure):
    """How a reader asks for a figure: `make fig07`, `make x03`."""
    return "make " + (figure if figure.startswith("x") else "fig" + figure)


def shown_cost(seconds):
    return "?" if math.isnan(seconds) else "< 1" if seconds < 1 else str(math.floor(seconds + 0.5))


def figure_rows(figures):
    yield "| figure | command | program | seconds | tables | shows |"
    yield "|---|---|---|---|---|---|"
    for id, f in figures.items():
        tables = ", ".join(f"`{name}`" for name in f["data"].split())
        yield (f"| {id} | `{command_of(id)}` | [`{f['program']}`](src/{f['program']}.cpp) | "
               f"{shown_cost(f['seconds'])} | {tables} | {f['caption']} |")


def gallery_rows(figures):
    """Every figure small with its title, four in a row; a picture leads to the chapter that makes it."""
    cells = [f' [<img src="figures/gallery/{Path(f["script"]).stem}.png" width="200" alt="{f["caption"]}">]'
             f"(src/{f['program']}.cpp)<br>{f['caption']} ({id}) |" for id, f in figures.items()]
    return ["| | | | |", "|---|---|---|---|"] + ["|" + "".join(cells[i:i + 4]) for i in range(0, len(cells), 4)]


def cost_rows(figures):
    costs = {f["program"]: f["seconds"] for f in figures.values()}
    yield "| program | seconds |"
    yield "|---|---|"
    for program in sorted(costs):
        yield f"| `{program}` | {shown_cost(costs[program])} |"
    yield f"| together | {shown_cost(sum(c for c in costs.values() if not math.isnan(c)))} |"


def ratio_rows(bench):
    """How our integrators compare with those of other libraries, as last measured and committed."""
    yield f"| {bench.meta['machine']}, {bench.meta['date']} | compared with | theirs over ours | settings |"
    yield "|---|---|---|---|"
    for row in bench.rows:
        if row["peer"].startswith(("GSL", "Boost")):
            reached = math.isfinite(row["ratio"])
            shown = f"{row['ratio']:.{0 if row['ratio'] >= 10 else 1}f}" if reached else "not reached"
            yield f"| {row['problem']}, {row['quantity']} | {row['peer']} | {shown} | {row['note'] if reached else ''} |"


def generated_tables(claims, lock, figures, bench):
    """Every table that a page may show, by the name in its marks."""
    return {"gallery": gallery_rows(figures), "summary": summary_rows(claims, figures),
            "discrepant": list(discrepancy_rows(claims, lock)), "published": list(published_rows(claims, lock)),
            "figures": list(figure_rows(figures)), "costs": list(cost_rows(figures)), "ratios": list(ratio_rows(bench))}


def fresh_page(text, tables):
    """A page as it has to look: what stands between `<!-- name -->` and `<!-- /name -->` is the table."""
    def renewed(found):
        if found[1] not in tables:
            raise ecsv.Fault(f"there is no table '{found[1]}'")
        return f"<!-- {found[1]} -->\n" + "".join(line + "\n" for line in tables[found[1]]) + f"<!-- /{found[1]} -->"

    for name in re.findall(r"<!-- (/?\w+) -->", text):
        if text.count(f"<!-- {name.strip('/')} -->\n") != 1 or text.count(f"<!-- /{name.strip('/')} -->") != 1:
            raise ecsv.Fault(f"no place for the table '{name.strip('/')}': its two marks do not match")
    return re.sub(r"<!-- (\w+) -->\n.*?<!-- /\1 -->", renewed, text, flags=re.S)


# The index of figures


def with_costs(text, costs):
    """figures/figures.ecsv is written by hand but for its last column, the seconds that the program takes. A row
    without it gets one. A measured time is renewed when it has moved by more than a fifth and by more than half a
    second, since a refreshed page should not show noise."""
    out, names = [], None
    for line in text.splitlines():
        if line and line[0] != "#" and names is None:
            names = line.split(",")
            if names[-1] != "seconds":
                raise ecsv.Fault("the last column is not 'seconds'")
        elif line and line[0] != "#":
            cells = next(csv.reader([line]))
            if not len(names) - 1 <= len(cells) <= len(names):
                raise ecsv.Fault(f"a row with a wrong number of cells: {line}")
            if len(cells) < len(names):
                line += ",nan"
            head, _, was = line.rpartition(",")
            now = costs.get(cells[names.index("program")])
            if now is not None and not abs(now - float(was)) < max(0.5, 0.2 * now):
                line = f"{head},{without_zeros(with_digits(now, 2))}"
        out.append(line)
    return "\n".join(out) + "\n"


def measured_costs(folder):
    """The seconds that each program took, from the files that the Makefile leaves."""
    out = {}
    for path in sorted(p for p in Path(folder).glob("*") if not p.name.startswith(".")):  # locks of running programs
        try:
            out[path.name] = float(ecsv.text_of(path))
        except ValueError:
            raise ecsv.Fault(f"{path}: no time in seconds") from None
    return out


def read_figures(root):
    return ecsv.read(Path(root) / "figures/figures.ecsv", ("id", "program", "script", "data", "seconds")).by("id", "figures")


def read_ratios(root):
    return ecsv.read(Path(root) / "bench/ratios.ecsv", ("problem", "peer", "quantity", "ratio", "note"))


def fresh_texts(root, costs):
    """(path, fresh text) of every file that is generated, or is in part, in which something could be stale."""
    root = Path(root)
    claims, lock = read_claims(root), read_lock(root)
    numbers = quotable(lock, claims)

    def fresh(path, change):
        try:
            return path, change(ecsv.text_of(path))
        except ecsv.Fault as fault:
            raise ecsv.Fault(f"{path}: {str(fault).removeprefix(f'{path}: ')}") from None

    for path in sources(root):
        yield fresh(path, lambda text: with_numbers(text, numbers))
    index, text = fresh(root / "figures/figures.ecsv", lambda text: with_costs(text, costs))
    yield index, text
    tables = generated_tables(claims, lock, ecsv.parse(text, index).by("id", "figures"), read_ratios(root))
    for name in PAGES:
        yield fresh(root / name, lambda text: fresh_page(with_marked_numbers(text, numbers), tables))
    yield from metadata.generated(root)


def renew(root, costs, check=False):
    """The verb: rewrites what has changed, and only that, so that nothing is compiled again without need. Returns
    how many files differ."""
    stale = [(path, text) for path, text in list(fresh_texts(root, costs)) if not path.exists() or text != ecsv.text_of(path)]
    for path, text in stale:
        if not check:
            ecsv.write_whole(path, text)
        print(f"  {'stale' if check else 'renewed'}  {path}")
    return len(stale)
