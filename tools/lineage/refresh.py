"""Numbers in prose. Nobody types a result: `[](num:pn.omega11)` names the answer to a claim and
`[](num:sec32_dps_profiles.norm_site)` a fact of a program, and the text of the link is the locked value, in a row of a
table with its error; `[to](num:...)` asks for both ends of what is enclosed. This file writes those texts, the tables of the pages, and the costs in paper/costs.ecsv.

The quoted values are the locked ones and not the fresh ones, because another compiler may change a digit of a
rounding residue; that fresh and locked values agree is asserted on its own."""

import re
from pathlib import Path

from . import ecsv
from .chapters import costs_text, renewed_costs
from .claims import by_name, check_quotations, in_plain, meanings, programs_of, read_claims, read_findings, read_verdicts
from .inventory import modules
from .lock import read_lock, sources
from .volumes import article, below, joined

LINK = re.compile(r"(\[[^\]]*\])?\(num:([^)\n]*)(\)?)")
MARK = re.compile(r"<!--num:([\w.]+)-->[^<\n]*<!--/-->")
PAGES = "README.md", "CONTRIBUTING.md"


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
            raise ecsv.Fault(f"there is no reference value '{id}' (a new one: make accept)")
        if re.search(r"\bto\b", brackets):
            return f"[{numbers[id].shown_as_interval}](num:{id})"
        row = text[text.rfind("\n", 0, found.start()) + 1:].startswith("|")
        return f"[{numbers[id].shown_in_table if row else numbers[id].shown_in_prose}](num:{id})"

    return LINK.sub(renewed, text)


def with_marked_numbers(text, numbers):
    """The same for a page that others show, where such a link would lead nowhere: `<!--num:id-->value<!--/-->`, of
    which a reader sees the value. Fault for a mark that is not whole, or an id that is not there."""
    if len(MARK.findall(text)) != text.count("<!--num:") or text.count("<!--num:") != text.count("<!--/-->"):
        raise ecsv.Fault("the two marks of a number do not match")
    for id in MARK.findall(text):
        if id not in numbers:
            raise ecsv.Fault(f"there is no reference value '{id}' (a new one: make accept)")
    return MARK.sub(lambda found: f"<!--num:{found[1]}-->{numbers[found[1]].shown}<!--/-->", text)


# The tables of the pages. What the book tells at length (assumptions, tolerances, errors) is left to it.


def printed(claim):
    """What the article prints, with a unit where it is a number."""
    text = claim["printed"]
    return f"{text} {claim['unit']}" if claim["unit"] and re.fullmatch(r"[-+.\de]+", text) else text


def discrepancy_rows(claims, numbers, verdicts):
    """Where the article and we differ, and why, in ten words."""
    yield "| statement | article | here | possible cause |"
    yield "|---|---|---|---|"
    for id, c in claims.items():
        if verdicts[id]["verdict"] == "discrepant":
            ours = numbers[id].shown_in_table if id in numbers else verdicts[id]["found"]
            yield f"| {c['quantity']} | {printed(c)} | {ours} | {c['cause']} |"


def found_rows(findings, numbers):
    """The findings of the first page."""
    return [f"- {in_plain(row['sentence'], numbers)} ({command_of(row['figure'])})" for row in findings.values() if row["front"]]


def tally(claims, verdicts):
    """How many statements hold, and the ids of those that neither hold nor are in the table of the discrepant ones."""
    of = {word: [id for id in claims if verdicts[id]["verdict"] == word] for word in meanings()}
    count = {word: len(ids) for word, ids in of.items()}
    hold, open_ = count["reproduced"] + count["reproduced, assuming"] + count["holds"], count["quantified"]

    def named(word):
        return f"{count[word]} ({', '.join(f'`{id}`' for id in of[word])})"

    return [f"Of {len(claims)} statements {len(claims) - open_} can be decided. {hold} hold: {count['reproduced']} numbers as printed, "
            f"{count['reproduced, assuming']} under a natural condition that the article does not state, and {count['holds']} assertions. "
            f"{named('within its own accuracy')} is missed by no more than the accuracy that the article prints, {named('follows')} only because "
            f"it is computed from another number, and {count['discrepant']} are discrepant. The other {open_} are words without a number, or numbers "
            "whose method is not printed; ours stand beside them."]


def index_rows(root, figures):
    """Every chapter, in the article's order, with its figures and what judges its statements."""
    rows = []
    for program in programs_of(root):
        section, title = re.match(r"/\*\*\n# (\w[\w.]*):? (.*)", ecsv.text_of(Path(root) / f"src/{program}.cpp")).groups()
        shown = [id for id, row in figures.items() if row["program"] == program]
        judged = f"src/statements/{program}.cpp"
        link = f"[`{program}.cpp`]({judged})" if (Path(root) / judged).exists() else ""
        rows.append((section, min(shown, default="x"), f"| {section} | [{title[0].upper() + title[1:]}](src/{program}.cpp) | "
                     f"{', '.join(id.lstrip('0') for id in shown)} | {link} |"))
    return ["| section | chapter | figures | statements |", "|---|---|---|---|", *(row for *_, row in sorted(rows))]


def module_rows(root):
    """The modules of the library, from the bottom up."""
    rows = [f"| [`{Path(folder).name}`]({folder}) | {idea} |" for folder, idea in modules(root).items()]
    return ["| module | what it is about |", "|---|---|", *rows]


def command_of(figure):
    """How a reader asks for a figure: `make fig07`, `make x03`."""
    return "make " + (figure if figure.startswith("x") else "fig" + figure)


def generated_tables(root, claims, numbers):
    """Every table that the page may show, by the name in its marks."""
    judged, verdicts = Path(root) == article(root), read_verdicts(root)
    return {"found": found_rows(read_findings(root), numbers),
            "modules": module_rows(root) if (Path(root) / "src/modules.ecsv").exists() else None,
            "index": index_rows(root, read_figures(root)) if judged else None,
            "summary": tally(claims, verdicts) if judged else None,
            "discrepant": list(discrepancy_rows(claims, numbers, verdicts)) if judged else None}


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
            raise ecsv.Fault(f"the two marks of the table '{name.strip('/')}' do not match")
    return re.sub(r"<!-- (\w+) -->\n.*?<!-- /\1 -->", renewed, text, flags=re.S)


# What is stale


def read_figures(root):
    return ecsv.read(Path(root) / "figures/figures.ecsv", ("id", "program", "script", "data", "caption", "details")).by("id", "figures")


def fresh_texts(root, measured):
    """(path, fresh text) of every file that is generated, or is in part, in which something could be stale."""
    root = Path(root)
    claims = read_claims(root)
    numbers = by_name(joined(read_lock, below(root)))
    check_quotations(read_findings(root), {path: ecsv.text_of(path) for path in sources(root) + sorted((root / "paper").glob("*.tex"))})

    def fresh(path, change):
        try:
            return path, change(ecsv.text_of(path))
        except ecsv.Fault as fault:
            raise ecsv.Fault(f"{path}: {str(fault).removeprefix(f'{path}: ')}") from None

    for path in sources(root):
        yield fresh(path, lambda text: with_numbers(text, numbers))
    yield root / "paper/costs.ecsv", costs_text(renewed_costs(root, measured))
    tables = generated_tables(root, claims, numbers)
    for page in (root / name for name in PAGES if (root / name).exists()):
        yield fresh(page, lambda text: fresh_page(with_marked_numbers(text, numbers), tables))


def renew(root, costs, check=False):
    """The verb: rewrites what has changed, and only that, so that nothing is compiled again without need. Returns
    how many files differ."""
    stale = [(path, text) for path, text in list(fresh_texts(root, costs)) if not path.exists() or text != ecsv.text_of(path)]
    for path, text in stale:
        if not check:
            ecsv.write_whole(path, text)
        print(f"  {'stale' if check else 'renewed'}  {path}")
    return len(stale)
