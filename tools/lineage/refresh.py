"""Numbers in prose. Nobody types a result: `[](num:pn.omega11)` names the answer to a claim and
`[](num:sec32_dps_profiles.norm_site)` a fact of a program, and the text of the link is the locked value, in a row of a
table with its error. This file writes those texts, the tables of the pages, the costs in paper/costs.ecsv, and the files that say to others what
codemeta.json says (metadata.py).

The quoted values are the locked ones and not the fresh ones, because another compiler may change a digit of a
rounding residue; that fresh and locked values agree is asserted on its own."""

import math
import re
from pathlib import Path

from . import codecheck, ecsv, metadata, modules
from .chapters import article_tests, costs_text, explained_by, read_commands, renewed_costs, run_of, shown_cost
from .claims import by_name, check_quotations, in_plain, meanings, program_of, programs_of, read_claims, read_findings, read_verdicts, said
from .lock import read_lock, sources
from .volumes import article, below, joined

LINK = re.compile(r"(\[[^\]]*\])?\(num:([^)\n]*)(\)?)")
MARK = re.compile(r"<!--num:([\w.]+)-->[^<\n]*<!--/-->")
GALLERY = 5  # pictures in a row
PAGES = ("README.md", "CONTRIBUTING.md", "DATA.md")


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
        row = text[text.rfind("\n", 0, found.start()) + 1:].startswith("|")
        return f"[{numbers[id].shown_in_table if row else numbers[id].shown_in_prose}](num:{id})"

    return LINK.sub(renewed, text)


def with_marked_numbers(text, numbers):
    """The same for a page that others show, where such a link would lead nowhere: `<!--num:id-->value<!--/-->`, of
    which a reader sees the value. Fault for a mark that is not whole, or an id that is not there."""
    if len(MARK.findall(text)) != text.count("<!--num:") or text.count("<!--num:") != text.count("<!--/-->"):
        raise ecsv.Fault("a number whose two marks do not match")
    for id in MARK.findall(text):
        if id not in numbers:
            raise ecsv.Fault(f"nothing is locked under '{id}' (a new one: make lock)")
    return MARK.sub(lambda found: f"<!--num:{found[1]}-->{numbers[found[1]].shown}<!--/-->", text)


# The tables of the pages. What the book tells at length (assumptions, tolerances, errors) is left to it.


def printed(claim):
    """What the article prints, with a unit where it is a number."""
    text = claim["printed"]
    return f"{text} {claim['unit']}" if claim["unit"] and re.fullmatch(r"[-+.\de]+", text) else text


def see(id, claims, costs, alone):
    """Where a claim that is missed is computed and explained: chapters with their commands and costs, and the command
    for the number alone."""
    chapters = ", ".join(f"[`{run_of(program)}`](src/{program}.cpp) ({shown_cost(costs.get(program, math.nan))} s)"
                         for program in explained_by(id, claims))
    return chapters + (f"; alone: `{alone[id][0]}`" if id in alone else "")


def discrepancy_rows(claims, numbers, verdicts, costs, alone):
    """Where the article and we differ, the list of claims says why."""
    yield "| claim | article | here | why | chapters |"
    yield "|---|---|---|---|---|"
    for id, c in claims.items():
        if verdicts[id]["verdict"] == "discrepant":
            ours = numbers[id].shown if id in numbers else verdicts[id]["found"]
            yield f"| `{id}` | {c['printed']} | {ours} | {said(c['reason'], numbers)} | {see(id, claims, costs, alone)} |"


def found_rows(findings, numbers):
    """The findings that have a figure, as the first page tells them."""
    return [f"- {in_plain(row['sentence'], numbers)} ({command_of(row['figure'])})" for row in findings.values() if row["figure"]]


def tally_rows(claims, verdicts):
    """How many statements have each verdict, and what it means."""
    said = [verdicts[id]["verdict"] for id in claims]
    return ["| verdict | statements | meaning |", "|---|---|---|",
            *(f"| {word} | {said.count(word)} | {text} |" for word, text in meanings().items() if word in said)]


def index_rows(root, claims, figures):
    """Every chapter with its figures, how many statements it answers, and the lines of tests/article.cpp that assert
    printed numbers of them."""
    tests = article_tests(root)
    yield "| section | chapter | figures | statements | tests of printed numbers |"
    yield "|---|---|---|---|---|"
    for program in programs_of(root):
        answered = [id for id, claim in claims.items() if program_of(claim) == program]
        lines = sorted({tests[id] for id in answered if id in tests})
        section = re.match(r"/\*\*\n# (\w[\w.]*)", ecsv.text_of(Path(root) / f"src/{program}.cpp"))[1]
        shown = ", ".join(id.lstrip("0") for id, row in figures.items() if row["program"] == program)
        links = ", ".join(f"[line {line}](tests/article.cpp#L{line})" for line in lines)
        yield f"| {section} | [`{program}`](src/{program}.cpp) | {shown} | {len(answered) or ''} | {links} |"


def command_of(figure):
    """How a reader asks for a figure: `make fig07`, `make x03`."""
    return "make " + (figure if figure.startswith("x") else "fig" + figure)


def gallery_rows(figures):
    """Every figure small with its number, GALLERY in a row; a picture leads to the chapter that makes it."""
    cells = [f' [<img src="figures/gallery/{Path(f["script"]).stem}.png" width="140" alt="{f["caption"]}" title="{f["caption"]}">]'
             f"(src/{f['program']}.cpp)<br>{id} |" for id, f in figures.items()]
    return ["|" + " |" * GALLERY, "|" + "---|" * GALLERY] + ["|" + "".join(cells[i:i + GALLERY])
                                                              for i in range(0, len(cells), GALLERY)]


def minute_rows(root):
    """How long the commands take; None where nobody has measured it."""
    if not (path := Path(root) / "tools/bench/minutes.ecsv").exists():
        return None
    rows = ecsv.read(path, ("command", "seconds", "what")).rows
    return ["| | | about |", "|---|---|---|",
            *(f"| `{row['command']}` | {row['what']} | {max(1, round(row['seconds'] / 60))} min |" for row in rows)]


def generated_tables(root, claims, numbers, costs):
    """Every table that a page may show, by the name in its marks."""
    judged, verdicts = Path(root) == article(root), read_verdicts(root)
    figures = read_figures(root)
    return {"gallery": gallery_rows(figures), "index": list(index_rows(root, claims, figures)) if judged else None, "found": found_rows(read_findings(root), numbers),
            "modules": modules.drawing(root), "minutes": minute_rows(root),
            "summary": tally_rows(claims, verdicts) if judged else None,
            "discrepant": list(discrepancy_rows(claims, numbers, verdicts, costs, read_commands(root))) if judged else None}


def fresh_page(text, tables):
    """A page as it has to look: what stands between `<!-- name -->` and `<!-- /name -->` is the table, or stays if today
    there is none."""
    def renewed(found):
        if found[1] not in tables:
            raise ecsv.Fault(f"there is no table '{found[1]}'")
        if tables[found[1]] is None:
            return found[0]
        return f"<!-- {found[1]} -->\n" + "".join(line + "\n" for line in tables[found[1]]) + f"<!-- /{found[1]} -->"

    for name in re.findall(r"<!-- (/?\w+) -->", text):
        if text.count(f"<!-- {name.strip('/')} -->\n") != 1 or text.count(f"<!-- /{name.strip('/')} -->") != 1:
            raise ecsv.Fault(f"no place for the table '{name.strip('/')}': its two marks do not match")
    return re.sub(r"<!-- (\w+) -->\n.*?<!-- /\1 -->", renewed, text, flags=re.S)


# What is stale


def read_figures(root):
    return ecsv.read(Path(root) / "figures/figures.ecsv", ("id", "program", "script", "data", "caption", "details")).by("id", "figures")


def fresh_texts(root, measured):
    """(path, fresh text) of every file that is generated, or is in part, in which something could be stale."""
    root = Path(root)
    claims = read_claims(root)
    numbers = by_name(joined(read_lock, below(root)), claims)
    check_quotations(read_findings(root), {path: ecsv.text_of(path) for path in sources(root) + sorted((root / "paper").glob("*.tex"))})

    def fresh(path, change):
        try:
            return path, change(ecsv.text_of(path))
        except ecsv.Fault as fault:
            raise ecsv.Fault(f"{path}: {str(fault).removeprefix(f'{path}: ')}") from None

    for path in sources(root):
        yield fresh(path, lambda text: with_numbers(text, numbers))
    costs = renewed_costs(root, measured)
    yield root / "paper/costs.ecsv", costs_text(costs)
    tables = generated_tables(root, claims, numbers, costs)
    for path in (root / name for name in PAGES if (root / name).exists()):
        yield fresh(path, lambda text: fresh_page(with_marked_numbers(text, numbers), tables))
    if root == article(root):
        yield from metadata.generated(root)
        yield root / "codecheck.yml", codecheck.text(root)


def renew(root, costs, check=False):
    """The verb: rewrites what has changed, and only that, so that nothing is compiled again without need. Returns
    how many files differ."""
    stale = [(path, text) for path, text in list(fresh_texts(root, costs)) if not path.exists() or text != ecsv.text_of(path)]
    for path, text in stale:
        if not check:
            ecsv.write_whole(path, text)
        print(f"  {'stale' if check else 'renewed'}  {path}")
    return len(stale)
