"""What is written into prose. Nobody types a result: a link names a cell (cells.py) or the answer to a statement, and its text is
the locked value, with as many digits as were typed and are certain; `[to](...)` asks for both ends of what is enclosed. This file
writes those texts, the sentences of findings and the tables between marks, and the costs in paper/costs.ecsv.

The quoted values are the locked ones and not the fresh ones, because another compiler may change a digit of what is
made of rounding; that fresh and locked values agree is asserted on its own."""

import re
import textwrap
from pathlib import Path

from . import ecsv
from .cells import home_of, with_links
from .chapters import command_of, costs_text, head_lines, renewed_costs
from .claims import (MARKED, by_name, check_quotations, in_plain, meanings, programs_of, read_claims, read_findings, read_literature,
                     read_verdicts, shown_at)
from .inventory import modules
from .lock import read_lock, sources
from .volumes import article, below, joined

PAGES = "README.md", "CONTRIBUTING.md", "MAINTAINING.md"


def with_numbers(text, numbers, home=""):
    """`text` with every link to a number of ours renewed; Fault for one that leads nowhere, so that a reference that dangles
    cannot be written."""
    def renewed(link, name):
        return f"[{shown_at(link, name, numbers)}]({link[2]}:{link[3]})"

    return with_links(text, renewed, home)


# The tables of the pages. What the book tells at length (assumptions, tolerances, errors) is left to it.


def printed(claim):
    """What the article prints, with a unit where it is a number."""
    text = claim["printed"]
    return f"{text} {claim['unit']}" if claim["unit"] and re.fullmatch(r"[-+.\de]+", text) else text


def here(id, row, numbers, verdicts):
    """What we have beside what is printed: an answer, or the comparisons that decide."""
    if id in numbers:
        return numbers[id].shown_like("1.000e0" if re.search(r"\de", row["printed"]) else "1.000") + numbers[id].shown_unit
    text = re.sub(r" \+- [^\s<;]+", "", verdicts[id]["found"])
    return re.sub(r"\d+\.\d+(?:e-?\d+)?", lambda number: f"{float(number[0]):.4g}", text)


def statement_rows(rows, numbers, verdicts):
    """The statements that a chapter decides, for its end; None where one of them has not been judged."""
    if any(verdicts[id]["state"] != "judged" for id in rows):
        return None
    return ["| statement | printed | here | verdict |", "|---|---|---|---|",
            *(f"| `{id}`: {row['quantity']} | {printed(row)} | {here(id, row, numbers, verdicts)} | {verdicts[id]['verdict']} |"
              for id, row in rows.items())]


def finding_lines(row, numbers):
    """The sentence of a finding as prose shows it, with its kind of evidence."""
    return textwrap.wrap(f"{in_plain(row['sentence'], numbers)} ({row['kind']})", 120, break_long_words=False, break_on_hyphens=False)


def discrepancy_rows(claims, numbers, verdicts):
    """Where the article and we differ, and why, in ten words."""
    yield "| statement | article | here | possible cause |"
    yield "|---|---|---|---|"
    for id, c in claims.items():
        if verdicts[id]["verdict"] == "discrepant":
            yield f"| {c['quantity']} | {printed(c)} | {here(id, c, numbers, verdicts) if id in numbers else 'fails'} | {c['cause']} |"


def found_rows(findings, numbers):
    """The findings of the first page."""
    return [f"- {in_plain(row['sentence'], numbers)} ({command_of(row['figure'])})" for row in findings.values() if row["front"]]


def tally(claims, verdicts):
    """How many statements hold, and the ids of those that neither hold nor are in the table of the discrepant ones."""
    of = {word: [id for id in claims if verdicts[id]["verdict"] == word] for word in meanings()}
    count = {word: len(ids) for word, ids in of.items()}
    hold = sum(count[word] for word in count if word.startswith(("reproduced", "holds")))
    open_ = count["quantified"]

    def named(word):
        return f"{count[word]} ({', '.join(f'`{id}`' for id in of[word])})"

    return [f"- {hold} of {len(claims)} statements hold: {count['reproduced']} numbers as printed, {count['reproduced, assuming']} more under a condition "
            f"that the article does not state, {count['holds']} assertions, and {count['holds, assuming']} more that assume a bound or another choice of ours.",
            f"- {count['in part']} hold in part, and {count['discrepant']} are discrepant. {named('within its own accuracy')} is missed by no more than the "
            f"accuracy that the article prints, {named('follows')} because it is computed from a number that is.",
            f"- {open_} cannot be decided: words without a number, or numbers whose method is not printed. Ours stand beside them."]


def question_of(text):
    """The first question that a chapter asks, in its first paragraphs."""
    sentences = re.split(r"(?<=[.?!])\s+(?=[A-Z])", re.split(r"\*/|\n## |<!--", text, maxsplit=1)[0])
    return next((" ".join(sentence.split("\n\n")[-1].split()) for sentence in sentences if sentence.endswith("?")), "")


def index_rows(root, figures):
    """Every chapter, in the order in which the book is read, with its question and the figures of the article that it has."""
    rows, order = [], ecsv.lines_of(Path(root) / "book/contents.txt")
    for program in programs_of(root):
        text = ecsv.text_of(Path(root) / f"src/{program}.cpp")
        section, title = re.match(r"/\*\*\n# (\w[\w.]*):? (.*)", text).groups()
        shown = [id for id, row in figures.items() if row["program"] == program and id.isdigit()]
        rows.append((order.index(program) if program in order else len(order), f"| {section} | [{title[0].upper() + title[1:]}](src/{program}.cpp) | "
                     f"{question_of(text)} | {', '.join(id.lstrip('0') for id in shown)} |"))
    return ["| section | chapter | question | figures |", "|---|---|---|---|", *(row for _, row in sorted(rows))]


def module_rows(root):
    """The modules of the library, from the bottom up."""
    rows = [f"| [`{Path(folder).name}`]({folder}) | {idea} |" for folder, idea in modules(root).items()]
    return ["| module | what it is about |", "|---|---|", *rows]


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

    for name in re.findall(r"<!-- (/?[\w.]+) -->", text):
        if text.count(f"<!-- {name.strip('/')} -->\n") != 1 or text.count(f"<!-- /{name.strip('/')} -->") != 1:
            raise ecsv.Fault(f"the two marks of the table '{name.strip('/')}' do not match")
    return MARKED.sub(renewed, text)


# What is stale


def read_figures(root):
    return ecsv.read(Path(root) / "figures/figures.ecsv", ("id", "program", "script", "data", "caption", "details")).by("id", "figures")


def fresh_texts(root, measured):
    """(path, fresh text) of every file that is generated, or is in part, in which something could be stale."""
    root = Path(root)
    claims = read_claims(root)
    numbers = by_name(joined(read_lock, below(root)))
    check_quotations(read_findings(root), map(ecsv.text_of, sources(root) + sorted((root / "paper").glob("*.tex"))))

    def fresh(path, change):
        try:
            return path, change(ecsv.text_of(path))
        except ecsv.Fault as fault:
            raise ecsv.Fault(f"{path}: {str(fault).removeprefix(f'{path}: ')}") from None

    findings, verdicts, figures = read_findings(root), read_verdicts(root), read_figures(root)
    costs = renewed_costs(root, measured)
    told = {id: finding_lines(row, numbers) for id, row in findings.items()}
    printed_rows = (claims if root == article(root) else {}) | read_literature(root)
    for path in sources(root):
        home = home_of(path)
        rows = {id: row for id, row in printed_rows.items() if row["program"] == home}
        marked = told | {"statements": statement_rows(rows, numbers, verdicts)}
        if "<!-- head -->" in ecsv.text_of(path):
            marked["head"] = head_lines(root, path.stem, figures, costs)
        yield fresh(path, lambda text: fresh_page(with_numbers(text, numbers, home), marked))
    if (root / "paper/findings.ecsv").exists():
        yield fresh(root / "paper/findings.ecsv", lambda text: with_numbers(text, numbers))
    yield root / "paper/costs.ecsv", costs_text(costs)
    tables = generated_tables(root, claims, numbers)
    for page in (root / name for name in PAGES if (root / name).exists()):
        yield fresh(page, lambda text: fresh_page(text, tables))


def renew(root, costs, check=False):
    """The verb: rewrites what has changed, and only that, so that nothing is compiled again without need. Returns
    how many files differ."""
    stale = [(path, text) for path, text in list(fresh_texts(root, costs)) if not path.exists() or text != ecsv.text_of(path)]
    for path, text in stale:
        if not check:
            ecsv.write_whole(path, text)
        print(f"  {'stale' if check else 'renewed'}  {path}")
    return len(stale)
