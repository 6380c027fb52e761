"""The book as Sphinx reads it. A C++ source becomes a page in MyST: its blocks of prose `/** ... */` as they are, the code
between them with the line numbers of the file. The lists (statements, findings, numbers, figures, commands) are pages made
from tables. While Sphinx reads them, what prose mentions is bound to what made it:

    [1.62e-11](num:pn.omega11)    a number of ours: its error on hover and focus, a link to its row
    ![Caption](fig:19)            a figure with its script, program, tables and command
    [](finding:pull)              the sentence of a finding, with a link to its evidence
    Eq. (24), figure 19, well.hpp, `sec33_floquet`, `pn.omega11`    links

Nothing is judged here: verdicts are those of build/report/published.ecsv. What cannot be bound is a warning, and with -W
the end of the build."""

import base64
import json
import math
import re
import shutil
import subprocess
from collections import Counter
from dataclasses import replace
from html import escape, unescape
from pathlib import Path
from urllib.parse import unquote

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.errors import ExtensionError
from sphinx.transforms import SphinxTransform
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from lineage import ecsv, inventory, tex
from lineage.chapters import explained_by, read_commands, read_costs, run_of, shown_cost
from lineage.claims import SAID, VERDICTS, name_of, programs_of, read_claims
from lineage.findings import KINDS, agrees, in_plain, margins, read_findings, read_second, with_kind, with_sentences
from lineage.literature import OBTAINED, read_literature, verdicts
from lineage.lock import read_fresh, read_lock
from lineage.refresh import command_of, printed, read_figures
from lineage.sources import blocks_of, definitions, local_names, made_at, sources_of
from lineage.values import Finding, distance, with_digits, without_zeros
from lineage.volumes import joined, volumes
from live import live

HERE = Path(__file__).resolve().parent
KATEX = [Path("/usr/share/javascript/katex"), Path("/usr/share/nodejs/katex/dist")]
say = logging.getLogger(__name__)

# Sources

HEAD = re.compile(r"(?:(?:#\w+.*|using namespace.*|namespace \w+ \{|[ \t]*)\n){4,}")
FILLS = re.compile(r"^(?://.*\n)*(?!return\b)\w[\w:<>,&* ]*[ &*](report_\w+)\([^;{]*\{\n.*?^\}\n?", re.M | re.S)
NUMBER = re.compile(r"\[[^\]]*\]\(num:([^)\s]+)\)")
EQUATIONS = re.compile(r"\bEqs?\.\s*\(\d+\)(?:(?:,|\s+and|\s+to|,\s+and)\s+\(\d+\))*")
FIGURE = re.compile(r"!\[([^\]]*)\]\(fig:([^)]*)\)")
FIGURES = re.compile(r"\b(?:[Ff]igures?|Figs?\.)\s+x?\d\d?\b(?:(?:,| and| to)\s+x?\d\d?\b)*")
FILE = re.compile(r"\b(?:[\w-]+/)*\w+\.(?:hpp|cpp)\b")


# Words and numbers in Markdown


def plain(text):
    """A text that Markdown leaves as it is."""
    return re.sub(r"([\\`*_{}\[\]<>$|#~])", r"\\\1", str(text))


def spelled(text):
    """What a list writes for every reader, `E_PN for omega_b = 1.1`, with formulas; code, formulas and links stay."""
    pieces = re.split(r"(\$[^$]*\$|`[^`]*`|\[[^\]]*\]\([^)]*\)|\b(?!(?:omega|lambda|epsilon)_)[A-Za-z]\w{2,}_\w+)", text)
    for i in range(0, len(pieces), 2):
        said = re.sub(r"\\ensuremath\{((?:[^{}]|\{[^{}]*\})*)\}", r"$\1$", tex.worded(pieces[i]))
        said = said.replace("$$", "").replace(r"\^{}", "^").replace(r"\~{}", r"\~")
        pieces[i] = re.sub(r"([|<>*\[\]])", r"\\\1", said)
    pieces[1::2] = [piece if piece[0] in "$`[" else plain(piece) for piece in pieces[1::2]]
    return "".join(pieces).replace("$$", "$ $")


def set_number(text):
    """`1.6e-11` in HTML as a reader wants it."""
    text = re.sub(r"(?<![\w.])-(?=\d)", "−", escape(text))
    return re.sub(r"(?<![\w.])(\d[\d.]*)e(-?)(\d+)\b",
                  lambda m: f"{'' if m[1] == '1' else m[1] + '·'}10<sup>{'−' if m[2] else ''}{m[3]}</sup>", text)


def unit(text):
    return f" {'µm' if text == 'um' else text}" if text and text != "claim" else ""


def with_error(found):
    """A value with its error and unit, as text."""
    if found.unit == "claim" or not math.isfinite(found.value):
        return found.shown
    if found.kind == "residue":
        return found.shown + unit(found.unit) + " (made of rounding: only its size counts)"
    return found.shown + (unit(found.unit) + ", exact" if found.error == 0 else f" ± {found.shown_error}{unit(found.unit)}")


def table(heads, rows, kind="rows"):
    """A table in Markdown; no row, no table."""
    lines = ["| " + " | ".join(re.sub(r"\s+", " ", cell) for cell in row) + " |" for row in rows]
    head = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(["", f":::{{container}} {kind}", *head, *lines, ":::", ""]) if lines else ""


def fenced(code, language, first=0):
    """A listing, with the numbers of its lines from `first` on, if there is one."""
    number = f":lineno-start: {first}\n" if first else ""
    return f"\n``````{{code-block}} {language}\n{number}\n{code}\n``````\n"


def at(id):
    return f'<a id="{escape(id)}"></a>'


def broken(name):
    """A long name that may be broken behind a point or an underscore."""
    return re.sub(r"([._])(?=\w)", r"\1<wbr>", name)


def file_link(path):
    return f'<a href="data/{path}" download>{path}</a>'


def verdict(name):
    return f'<span class="verdict {name}">{SAID.get(name, name)}</span>'


# What the pages know


class Book:
    """Everything that a page may mention, and the pages."""

    def __init__(self, root, build, pages):
        self.root, self.build, self.pages = Path(root), Path(build), Path(pages)
        self.data, self.drawn, self.compiled = self.build / "data", self.build / "figures", self.root / "build/live"
        first, *more = volumes(root)
        self.volumes = [first] + [one for one in more if any((self.data / program).is_dir() for program in programs_of(one))]
        self.parts = self.contents()
        self.chapters, self.rest = sources_of(self.root, self.volumes, [name for names in self.parts.values() for name in names])
        self.sources = self.chapters + [source for module in self.rest.values() for source in module]
        self.by_page, self.by_include = {s.page: s for s in self.sources}, {s.included: s for s in self.sources}
        names = Counter(name for s in self.sources if s.is_header for name in definitions(s.text))
        self.defined = {name: (s, line) for s in self.sources if s.is_header for name, line in definitions(s.text).items() if names[name] == 1}
        self.read_numbers()
        self.figures, self.captions = joined(read_figures, self.volumes), joined(tex.captions, self.volumes)
        self.equations = {int(row["number"]): row for row in ecsv.read(self.root / "book/equations.ecsv", ("number", "label", "name", "tex")).rows}
        self.labels = {row["label"]: f"Eq. ({row['number']})" for row in self.equations.values()}
        self.labels |= {row["label"]: f"Fig. {int(id)}" for id, row in self.figures.items() if row["label"]}
        self.lives = live.found(self.volumes, self.compiled)
        self.buttons = joined(live.read_buttons, [v / "book/live/figures.txt" for v in self.volumes]) if self.lives else {}
        self.formulas, self.set = {}, {}
        self.places = {}  # what -> pages that speak of it
        self.told = {s.page: "\n".join(self.woven(text) for prose, _, text in s.blocks if prose) for s in self.sources}
        for page, text in self.told.items():
            for what in NUMBER.findall(text) + [f"fig:{id}" for id in re.findall(r"^```\{fig\} (\w+)$", text, re.M)] + re.findall(
                    r"\]\((finding:[^)]+)\)", text) + [f"eq:{n}" for run in EQUATIONS.findall(text) for n in re.findall(r"\((\d+)\)", run)]:
                self.places.setdefault(what, {})[page] = True

    def contents(self):
        """The parts of the book with their chapters, from book/contents.txt."""
        parts, part = {}, ""
        for line in ecsv.text_of(self.root / "book/contents.txt").splitlines():
            if line.startswith("="):
                part = line[1:].strip()
            elif line.strip() and not line.startswith("#"):
                parts.setdefault(part, []).append(line.strip())
        return parts

    def read_numbers(self):
        """Statements with their verdicts, findings, and all numbers by name: the locked values, and where a program wrote them."""
        every = self.volumes
        self.claims, self.findings, self.second = read_claims(self.root), joined(read_findings, every), joined(read_second, every)
        self.alone, self.seconds = joined(read_commands, every), joined(read_costs, every)
        locked, fresh = joined(read_lock, every), read_fresh(self.data, [p for v in every for p in programs_of(v)], self.claims)
        known = locked | {key: replace(locked.get(key, f), made_by=f.made_by, row=f.row) for key, f in fresh.items()}
        self.numbers = {name_of(f, self.claims): f for f in known.values() if self.claims.get(f.id, {}).get("program", f.program) == f.program}
        self.stale = {name_of(fresh[key], self.claims) for key in locked.keys() & fresh.keys()
                      if self.build.name != "quick" and distance(locked[key], fresh[key]) > 1}
        report = self.build / "report/published.ecsv"
        self.published = ecsv.read(report).by("id", "claims")
        self.literature = list(verdicts(joined(read_literature, every), self.numbers))
        self.lines = {}
        for program in programs_of(self.volumes[0]) + [p for v in every[1:] for p in programs_of(v)]:
            chapter = self.by_page[program]
            near = [self.by_include[i] for i in chapter.includes if i in self.by_include]
            near += [self.by_include[i] for i in (s.included[:-4] + ".cpp" for s in near) if i in self.by_include]
            self.lines |= {name: made_at(f, [chapter, *near]) for name, f in self.numbers.items() if f.program == program}

    # Links

    def row(self, name):
        """Where a list has this number."""
        return f"published.html#{name}" if name in self.claims else f"numbers-{name.partition('.')[0]}.html#{name}"

    def file(self, text, here=""):
        """The page of a source that is named in a text, empty where the name is that of none or of several."""
        text, near = text.removeprefix("beyond/").removeprefix("src/"), self.by_page.get(here)
        found = [s for s in self.sources if s.included == text or s.included.endswith("/" + text)]
        if len(found) > 1 and near:
            found = [s for s in found if s.module == near.module or s.included in near.includes]
        return found[0].page + ".html" if len(found) == 1 and found[0].page != here else ""

    def code(self, word, here=""):
        """What a piece of code in prose refers to: a statement, a number, a chapter, a file or a name of the library."""
        if word in self.claims or word in self.numbers:
            return self.row(word)
        if (program := word.removeprefix("build/bin/").partition(" ")[0]) in self.by_page and program.startswith("sec") and program != here:
            return f"{program}.html"
        if FILE.fullmatch(word):
            return self.file(word, here)
        clear, word = word[:1].isupper() or "_" in word and len(word) > 6 or word.endswith("()"), word.removesuffix("()")
        if clear and word in self.defined and self.defined[word][0].page != here and not (here in self.by_page and word in local_names(self.by_page[here])):
            return "{0.page}.html#L-{1}".format(*self.defined[word])
        return ""

    def line_link(self, name):
        place = self.lines.get(name)
        return f'<a href="{place[0].page}.html#L-{place[1]}">line {place[1]} of {place[0].name}</a>' if place else ""

    def speaks(self, what, but=""):
        """Links to the chapters and files that speak of something."""
        found = [p for p in self.places.get(what, ()) if p != but]
        return ", ".join(f'<a href="{p}.html">{p}</a>' for p in found)

    def where(self, text):
        """A place in the article, with its numbers instead of its labels."""
        return re.sub(r"\b(?:Eqs?\.|Figs?\.?) (\w+)", lambda m: self.labels.get(m[1], m[0]), text)

    def tip(self, name):
        """What a reader sees beside a number."""
        found, claim = self.numbers[name], self.claims.get(name)
        if not claim:
            return with_error(found)
        said, row = printed(claim), self.published.get(name)
        return (("" if found.unit == "claim" else with_error(found) + "; ") + (f"the article prints {said}" if said else "a statement of the article")
                + (f": {SAID.get(row['verdict'], row['verdict'])}" if row else ""))

    def cost(self, program):
        seconds = self.seconds.get(program, math.nan)
        return "" if math.isnan(seconds) else f", {shown_cost(seconds)} s on two cores"

    # Pages

    def woven(self, text):
        """A block of prose as MyST: sentences of findings in their places, figures as directives."""
        text = re.sub(r"(```.*?```|`[^`]*`)|(\$\$?)(.+?)\2", lambda m: m[1] or m[0].replace("\n", " "),
                      with_sentences(text, self.findings, with_kind), flags=re.S)  # no line of a formula begins a list
        return FIGURE.sub(lambda m: f"\n\n```{{fig}} {m[2]}\n{m[1]}\n```\n\n", text)

    def listing(self, code, first):
        """Code between prose. What it includes, and functions that only fill tables, are folded."""
        out, done = [], 0

        def piece(start, end, summary=""):
            lines = code[start:end]
            begin = start + len(lines) - len(lines.lstrip("\n"))
            if lines.strip():
                body = fenced(code[begin:end].rstrip(), "cpp", first + code.count("\n", 0, begin))
                out.append(f'\n<details class="fold"><summary>{summary}</summary>\n{body}\n</details>\n' if summary else body)

        if (head := HEAD.match(code + "\n")) and code.startswith("#"):
            piece(0, done := min(head.end(), len(code)), "What this file includes")
        for found in FILLS.finditer(code, done):
            piece(done, found.start())
            piece(found.start(), done := found.end(), f"How a table is filled: {found[1]}")
        piece(done, len(code))
        return "".join(out)

    def source_page(self, source):
        """A chapter, a header, or what is compiled for one."""
        parts = [] if source.titled else [f"# {source.title}\n"]
        parts += [f"\n{self.woven(text)}\n" if prose else self.listing(text, first) for prose, first, text in source.blocks
                  if text.strip() != "#pragma once"]
        card = self.card(source)
        page = re.sub(r"^# .+$", lambda m: f"{m[0]}\n\n{card}\n", "".join(parts), count=1, flags=re.M)
        return ("---\norphan: true\n---\n" if source.module else "") + page + ("" if source.module else self.end_of(source))

    def card(self, source):
        """What stands below its title."""
        def links(found):
            return ", ".join(f'<a href="{s.page}.html">{s.name}</a>' for s in found)

        if not source.module:
            return (f'<p class="card">The source is <code>{source.path}</code>, the program <code>{run_of(source.stem)}</code>{self.cost(source.stem)}. '
                    f'<a href="numbers-{source.stem}.html">All its numbers and tables</a>; <a href="commands.html#{source.stem}">its options</a>.</p>')
        halves = [s for s in self.rest[source.module] if s.stem == source.stem and s is not source]
        said = [(word, links(found)) for word, found in (
            ("declared in" if not source.is_header else "compiled in", halves),
            ("needs", [self.by_include[i] for i in source.includes if i in self.by_include and self.by_include[i] not in halves]),
            ("needed by", [s for s in self.sources if source.included in s.includes and s not in halves])) if found]
        return f'<p class="card"><a href="library.html">Library</a>: <code>{source.path}</code>' + "".join(f"<br>{w} {l}" for w, l in said) + "</p>"

    def end_of(self, chapter):
        """Figures of a chapter that no prose shows, the statements that it answers, numbers of other authors."""
        program, out = chapter.stem, ""
        if left := [id for id, row in self.figures.items() if row["program"] == program and f"fig:{id}" not in self.places]:
            out += "\n\n## Further figures of this program\n\n" + "".join(f"```{{fig}} {id}\n{self.figures[id]['caption']}\n```\n\n" for id in left)
        if answers := table(["statement", "article", "here", "verdict"], [self.claim_row(row, True) for row in self.published.values() if row["program"] == program]):
            out += "\n\n## Statements answered here\n" + answers
        others = [[f"{spelled(row['quantity'])}", f"{plain(row['citation'])} {spelled(row['where'])}", spelled(printed(row)), set_number(with_error(ours)),
                   f"{verdict(said) + ', ' if said else ''}{OBTAINED[row['obtained']]}{'' if said else ': no verdict'}. {spelled(row['note'])}"]
                  for row, ours, said in self.literature if row["program"] == program]
        return out + ("\n\n## Numbers of other authors\n" + table(["number", "source", "printed", "here", "verdict"], others) if others else "") + self.script(out)

    def claim_row(self, row, short=False):
        """A statement of the article: short below its chapter, whole in the table of all."""
        id, claim = row["id"], self.claims[row["id"]]
        found = Finding(row["program"], id, row["reproduced"], row["error"], row["unit"], kind=self.numbers[id].kind if id in self.numbers else "value")
        here = "" if math.isnan(found.value) or found.shown == row["verdict"] else set_number(with_error(found))
        name = f'<a href="published.html#{id}"><code>{broken(id)}</code></a>' if short else f"{at(id)}<code>{broken(id)}</code>"
        cells = [f"{name} {spelled(row['quantity'])}" + ("" if short else f" ({plain(self.where(row['where']))})"), spelled(printed(claim)), here, verdict(row["verdict"])]
        if not short:
            cells[2] += self.second_mark(id)
            told = [f"Read: {spelled(row['reading'])}"] * bool(row["reading"]) + [spelled(row["reason"])] * bool(row["reason"])
            links = [self.line_link(id), f'<a href="{row["program"]}.html">chapter</a>' if row["program"] else "", self.speaks(id, row["program"])]
            cells[3] += " ".join(["", *told]) + (f" See {self.see(id)}" if row["reason"] else "")
            cells.append(", ".join(filter(None, links)) + (f"; alone: `{self.alone[id][0]}`" if id in self.alone else ""))
        return cells

    def see(self, id):
        return ", ".join(f'<a href="{p}.html">{p}</a>' for p in explained_by(id, self.claims) if p in self.by_page) + "."

    def second_mark(self, id):
        if id not in self.numbers or not agrees(id, self.numbers[id], self.second):
            return ""
        return f' <span class="second">✓ second route: {spelled(self.second[id][1])}</span>'

    def published_page(self):
        counts = Counter(row["verdict"] for row in self.published.values())
        meanings = {"reproduced": "a printed number, met within its tolerance", "holds": "a yes-or-no statement that a criterion confirms",
                    "within": "a printed number missed by no more than the accuracy that the article itself prints",
                    "follows": "missed only because the article computes it from another number, which has a row of its own",
                    "measured": "quantified, no verdict: the article has a word without a number",
                    "discrepant": "a printed number missed, or a statement that fails, in every natural reading",
                    "unresolved": "the error bar does not allow a verdict", "open": "not answered yet"}
        out = ["# Published against reproduced\n\nEvery number and statement of the article that can be tested. Tolerances were fixed before a "
               "result was computed. The error of a value is what computations of different resolution leave.\n",
               table(["verdict", "rows", "meaning"], [[verdict(v), str(counts[v]), meanings[v]] for v in VERDICTS if counts[v]])]
        if lost := [row for row in self.published.values() if row["verdict"] == "discrepant"]:
            out.append("\n## What does not survive\n" + table(["statement", "article", "here", "verdict"], [self.claim_row(row, True) for row in lost]))
        sections = dict.fromkeys(self.claims[id]["section"] for id in self.published)
        for section in sections:
            rows = [self.claim_row(row) for id, row in self.published.items() if self.claims[id]["section"] == section]
            out.append(f"\n## Section {section}\n" + table(["statement", "article", "here", "verdict", "see"], rows))
        return "\n".join(out)

    def findings_page(self):
        out = ["# What we found\n\nWhat this edition adds to the article. Each sentence has a range over which it was shown, conditions on computed "
               "numbers that could have failed, and what was tried to refute it. Outside of its range it claims nothing.\n",
               table(["evidence", "meaning"], [[f'<span class="evidence">{kind}</span>', meaning] for kind, meaning in KINDS.items()])]

        def limit(m):
            rest = with_digits(m.left / m.error, 1) if m.error else ""
            return (f"`{m.name}` = {set_number(with_error(m.value))} {m.side.replace('<', '&lt;')} "
                    + (f"`{m.limit}` = {set_number(with_error(m.other))}" if m.other.program else set_number(m.limit))
                    + f"; margin {set_number(without_zeros(with_digits(m.left, 2)))}" + (f", {set_number(without_zeros(rest))} error bars" if rest else ""))

        for id, row in self.findings.items():
            figure = f', <a href="fig-{row["figure"]}.html">figure {row["figure"]}</a>' if row["figure"] in self.figures else ""
            out += [f'\n{at(id)}\n\n## {id}\n\n<span class="evidence">{row["kind"]}</span> {row["sentence"]}\n',
                    f"- **Shown over** {spelled(row['range'])}",
                    f"- **Tried against it** {spelled(row['tried'])}", "- **Carried by**", *(f"  - {limit(m)}" for m in margins(row, self.numbers)),
                    f"- **Second route** {spelled(row['second'])}", f'- **Stands in** {self.speaks("finding:" + id) or "the report"}{figure}; `make show ID={id}`']
        return "\n".join(out)

    def numbers_page(self, program):
        """All numbers of a program but the answers, and its tables with their columns."""
        title = self.by_page[program].title
        rows = [[f"{at(name)}<code>{broken(f.id)}</code>", self.meaning(f), set_number(with_error(f)) + self.second_mark(name),
                 ", ".join(filter(None, [self.line_link(name), self.speaks(name, program)])) + (f"; alone: `{self.alone[name][0]}`" if name in self.alone else "")]
                for name, f in sorted(self.numbers.items()) if f.program == program and name not in self.claims]
        out = [f"---\norphan: true\n---\n# Numbers and tables of {program}\n\n*{title}*: `{program}`, computed by `{run_of(program)}`{self.cost(program)}. "
               "Answers to statements of the article are in [published against reproduced](published.md); how to read a table is told in "
               "[use the data](data.md).\n", "\n## Numbers\n" * bool(rows), table(["number", "meaning", "value", "made at"], rows), "\n## Tables\n"]
        for path in sorted((self.data / program).glob("[!.]*.ecsv")):
            out.append(f"\n### {path.stem}\n\n{file_link(f'{program}/{path.name}')}\n" + self.columns(path))
        return "\n".join(out)

    def columns(self, path):
        return table(["column", "unit", "meaning"], [[f"<code>{broken(c.name)}</code>", plain(unit(c.unit).strip()), spelled(c.description)]
                                                     for c in ecsv.header_of(ecsv.text_of(path))[0]], "columns")

    def meaning(self, found):
        """A fact in words: those of the column that it is called after, else its name."""
        if not hasattr(self, "meanings"):
            self.meanings = {}
            for c in inventory.tables(self.root, self.data):
                self.meanings.setdefault(c["program"], {})[c["column"]] = c["description"]
        names = [n for n in self.meanings.get(found.program, ()) if len(n) > 2 and re.match(rf"{n}(_|$)", found.id)]
        if not names:
            return ""
        rest = found.id[len(max(names, key=len)):].strip("_").replace("_", " ")
        return spelled(self.meanings[found.program][max(names, key=len)]) + (f" ({plain(rest)})" if rest else "")

    def figure_page(self, id):
        row, caption = self.figures[id], self.caption(id)
        script = ecsv.text_of(next(v / "figures" / row["script"] for v in self.volumes if (v / "figures" / row["script"]).exists()))
        own = "A figure of this book" if id.startswith("x") else f"A figure of the article, section {row['section']}"
        out = [f"---\norphan: true\n---\n# {spoken(id)}\n\n```{{fig}} {id}\n:whole:\n\n{caption}\n```\n\n{own}; shown in "
               f"{self.speaks('fig:' + id) or self.program_link(row['program'])}.\n\n## Tables\n"]
        for name in row["data"].split():
            path = self.data / row["program"] / f"{name}.ecsv"
            if path.exists():
                count = len(ecsv.rows_of(ecsv.text_of(path))) - 1
                out.append(f"\n### {name}\n\n{file_link(row['program'] + '/' + path.name)}, {count} rows\n" + self.columns(path))
        return "\n".join(out) + "\n\n## Script\n" + fenced(script.rstrip(), "python" if row["script"].endswith(".py") else "gnuplot", 1) + self.script("fig")

    def program_link(self, program):
        return f'<a href="{program}.html">{program}</a>'

    def caption(self, id):
        more = tex.in_markdown(self.captions[id]) if id in self.captions else ""
        return plain(self.figures[id]["caption"]).replace(r"\$", "$") + (" " + more if more else "")

    def gallery(self, ids, words):
        cells = "".join(f'<a href="fig-{id}.html"><img src="figures/{self.stem(id)}.svg" alt="{escape(self.figures[id]["caption"])}" loading="lazy">'
                        f"<span><b>{spoken(id)}.</b> {escape(words(id))}</span></a>" for id in ids)
        return f'\n<div class="gallery">{cells}</div>\n'

    def stem(self, id):
        return Path(self.figures[id]["script"]).stem

    def figures_page(self):
        return "# All figures\n" + self.gallery(self.figures, lambda id: self.figures[id]["caption"])

    def equations_page(self):
        out = ["# Equations of the article\n\nThe article's numbers, the equations in the notation of the programs, and where the book speaks of them.\n"]
        for number, row in self.equations.items():
            out.append(f"\n{at(f'eq-{number}')}\n\n## ({number}) {row['name']}\n\n$$\n{row['tex']} \\tag{{{number}}}\n$$\n\n{self.speaks(f'eq:{number}')}\n")
        return "".join(out)

    def commands_page(self):
        """What the programs say of themselves; options that all have stand once."""
        rows, common = list(inventory.commands(self.root, self.root / "build/bin")), ("--help", "--version", "--out", "--quick", "--threads", "--output")
        first = {row["option"]: row["description"].split(" (default")[0] for row in reversed(rows)}
        out = ["# All commands\n\nWhat the programs say in their own `--help`. Without a command a program computes everything that its section shows; "
               "a command computes one thing with the reader's parameters and prints a table. These options are the same everywhere:\n",
               table(["option", "meaning"], [[f"`{name}`", plain(first[name])] for name in common if name in first])]
        for row in rows:
            if row["option"]:
                continue
            name = f"{row['program']} {row['command']}".strip()
            own = [[f"`{o['option']}`", plain(o["allowed"]), plain(o["description"])] for o in rows
                   if (o["program"], o["command"]) == (row["program"], row["command"]) and o["option"] and o["option"] not in common]
            out.append(f"\n{at(name.replace(' ', '-'))}\n\n##{'#' * bool(row['command'])} `{name}`\n\n{plain(row['description'])}\n" + table(["option", "allowed", "meaning"], own))
        return "\n".join(out)

    def data_page(self):
        """DATA.md, and the tables of each program."""
        text = re.sub(r"<!--num:([^>]+)-->(.*?)<!--/-->", r"[\2](num:\1)", ecsv.text_of(self.root / "DATA.md"))
        text = re.sub(r"\[(`[^`]*`)\]\((?!http)[^)]*\)", r"\1", text)
        programs = [s.stem for s in self.chapters if (self.data / s.stem).is_dir()]
        return text + "\n## All numbers and tables\n\n" + "\n".join(
            f'- <a href="numbers-{p}.html">{p}</a>: {", ".join(path.stem for path in sorted((self.data / p).glob("[!.]*.ecsv"))).replace("_", chr(92) + "_")}' for p in programs) + "\n"

    def packages_page(self):
        rows = [[f"<code>{p['package']}</code>", p["version"] or "not installed", p["section"]] for p in inventory.packages(self.root)]
        return ("# Packages used\n\nThis book was built on a machine with these Debian packages. Every table says in its header with which compiler and "
                "which libraries its program was built.\n" + table(["package", "version", "needed for"], rows))

    def library_page(self):
        ideas = dict(re.findall(r"^\| \[`(\w+)`\]\(src/[^)]*\) \| (.*) \|$", ecsv.text_of(self.root / "README.md"), re.M))
        order = [m for m in ideas if m in self.rest] + [m for m in self.rest if m not in ideas]
        out = ["# The library\n\nThe chapters share a library whose modules build on each other from top to bottom, and what several chapters of one section need.\n"]
        for module in order:
            links = "; ".join(f'<a href="{s.page}.html">{s.name if s.is_header else s.name}</a>' + (f" {s.title}" if s.is_header and s.titled else "") for s in self.rest[module])
            out.append(f"\n## {module}\n\n{ideas.get(module, 'What one section needs')}.\n\n{links}\n")
        return "".join(out)

    def notebook_page(self, path):
        """A notebook for Python, with the outputs that it holds, which the tests of the module compare."""
        out = []
        for i, cell in enumerate(json.loads(ecsv.text_of(path))["cells"]):
            text = "".join(cell["source"])
            out.append(self.woven(text) + "\n" if cell["cell_type"] == "markdown" else fenced(text, "python"))
            for k, output in enumerate(cell.get("outputs", ())):
                if picture := output.get("data", {}).get("image/png"):
                    name = f"{path.stem}-{i}-{k}.png"
                    (self.pages / name).write_bytes(base64.b64decode(picture))
                    out.append(f"\n![What the cell above draws.]({name})\n")
                else:
                    out.append(fenced("".join(output.get("text") or output["data"]["text/plain"]).rstrip(), "none"))
        if not out[0].startswith("# "):
            raise ecsv.Fault(f"{path}: no title (a line '# ...' in its first cell)")
        return "\n".join(out) + f"\n\nThis notebook is `python/{path.name}`.\n"

    def script(self, text):
        """What a page with buttons loads."""
        return live.SCRIPT if self.lives and "fig" in text else ""

    def start_page(self, lists):
        found = [(row["figure"], in_plain(row["sentence"], {n: f.shown for n, f in self.numbers.items()})) for row in self.findings.values() if row["figure"] in self.figures]
        counts = Counter(row["verdict"] for row in self.published.values())
        tally = ", ".join(f"{counts[v]} {verdict(v)}" for v in VERDICTS if counts[v])
        out = [ecsv.text_of(self.root / "book/start.md"), f"\n## What comes out\n\n{len(self.published)} statements of the article: {tally}. The "
               "[table](published.md) has every row, and where a number does not survive a converged computation it says what does, and why. "
               "[What we found](findings.md) besides, with what was tried to refute it:\n", *(f"- {text} (<a href=\"fig-{id}.html\">figure {id}</a>)" for id, text in found)]
        names, parts = [s.stem for s in self.chapters], {}
        for i, name in enumerate(names):
            part = next((part for part, held in self.parts.items() if name in held), list(parts)[-1] if parts else "Chapters")
            parts.setdefault(part, []).append(name)
        for part, pages in [*parts.items(), ("Lists", lists)]:
            out.append(f"\n```{{toctree}}\n:hidden:\n:caption: \"{part}\"\n\n" + "\n".join(pages) + "\n```\n")
        return "\n".join(out)

    def write(self):
        """All pages that Sphinx reads, and the drawings that they show."""
        shutil.rmtree(self.pages, ignore_errors=True)
        (self.pages / "static/fonts").mkdir(parents=True)
        pages = {s.page: self.source_page(s) for s in self.sources}
        pages |= {f"fig-{id}": self.figure_page(id) for id in self.figures}
        pages |= {f"numbers-{s.stem}": self.numbers_page(s.stem) for s in self.chapters}
        lists = {name: getattr(self, f"{name}_page")() for name in ("published", "findings", "figures", "equations", "commands", "data", "packages", "library")}
        lists |= {name: ecsv.text_of(folder / f"{name}.md") + live.SCRIPT for folder, name in self.lives}
        lists |= {f"notebook-{path.stem.replace('_', '-')}": self.notebook_page(path) for path in sorted((self.root / "python").glob("*.ipynb"))}
        pages |= lists | {"index": self.start_page(list(lists))}
        for name, text in pages.items():
            (self.pages / f"{name}.md").write_text(text, encoding="utf-8")
        (self.pages / "figures").mkdir()
        for id in self.figures:
            if not (drawing := self.drawn / f"{self.stem(id)}.svg").exists():
                raise ecsv.Fault(f"{drawing} is missing: draw it first (make figures)")
            shutil.copyfile(drawing, self.pages / "figures" / drawing.name)
        katex = next((folder for folder in KATEX if (folder / "katex.min.css").exists()), None)
        if not katex:
            raise ecsv.Fault("katex.min.css is not installed (Debian: libjs-katex, fonts-katex)")
        css = re.sub(r"src:[^;}]*?url\(([^)]*?\.woff2)\)[^;}]*", r"src:url(\1) format('woff2')", ecsv.text_of(katex / "katex.min.css"))
        (self.pages / "static/katex.css").write_text(css, encoding="utf-8")
        for font in sorted(set(re.findall(r"fonts/(\w[\w-]*\.woff2)", css))):
            shutil.copyfile(katex / "fonts" / font, self.pages / "static/fonts" / font)

    def copy(self, out):
        """What pages load or offer besides: drawings, tables, the library as a script."""
        shutil.copytree(self.pages / "figures", out / "figures", dirs_exist_ok=True)
        for id in self.figures:
            if (pdf := self.drawn / f"{self.stem(id)}.pdf").exists():
                shutil.copyfile(pdf, out / "figures" / pdf.name)
        for program in (s.stem for s in self.chapters):
            for path in sorted((self.data / program).glob("[!.]*.ecsv")):
                (out / "data" / program).mkdir(parents=True, exist_ok=True)
                shutil.copyfile(path, out / "data" / program / path.name)
        live.copy(self.lives, self.compiled, self.root, out)


def spoken(id):
    return f"Figure {id if id.startswith('x') else int(id)}"


# While Sphinx reads


class Number(nodes.Inline, nodes.TextElement):
    """A number of ours in prose."""


def link(text, address, title="", kind=""):
    return nodes.reference("", text, internal=True, refuri=address, **({"reftitle": title} if title else {}), **({"classes": [kind]} if kind else {}))


class Figure(SphinxDirective):
    """A figure and how it was made. On its own page (`whole`) it is no link, and its drawing is offered."""
    required_arguments, has_content = 1, True
    option_spec = {"whole": lambda text: True}

    def run(self):
        book, id = self.env.app.book, self.arguments[0]
        if id not in book.figures:
            say.warning(f"there is no figure '{id}'", location=self.get_location())
            return []
        row, whole, stem = book.figures[id], "whole" in self.options, book.stem(id)
        image = nodes.image(uri=f"figures/{stem}.svg", alt=row["caption"])
        holder = nodes.Element()
        self.state.nested_parse(StringList(list(self.content), self.get_source_info()[0]), 0, holder)
        caption = nodes.caption("", "")
        caption += [nodes.strong("", spoken(id) + "."), nodes.Text(" "), *(holder[0].children if len(holder) else [])]
        tables = ", ".join(file_link(f"{row['program']}/{name}.ecsv") for name in row["data"].split())
        script = f"<a href=\"fig-{id}.html#script\">figures/{row['script']}</a>"
        buttons = "".join(f' <a class="live" href="{address}">{words}</a>' for words, address in book.buttons.get(id, ()))
        drawing = f' As <a href="figures/{stem}.svg">SVG</a>, <a href="figures/{stem}.pdf">PDF</a>.' if whole and (book.drawn / f"{stem}.pdf").exists() else ""
        made = (f"<p class=\"made\"><code>{command_of(id)}</code>: {script} draws {tables} of {book.program_link(row['program'])}"
                f" (<code>{run_of(row['program'])}</code>{book.cost(row['program'])}).{drawing}{buttons}</p>")
        shown = nodes.figure("", image if whole else nodes.reference("", "", image, internal=True, refuri=f"fig-{id}.html"), caption,
                             nodes.legend("", nodes.raw("", made, format="html")))
        if id not in (seen := self.env.temp_data.setdefault("figures", set())):
            shown["ids"].append(f"fig-{id}")
        seen.add(id)
        return [shown]


class Bind(SphinxTransform):
    """Binds the links num: and finding:, and what prose names, in one page."""
    default_priority = 5

    def apply(self, **given):
        self.book, self.page = self.env.app.book, self.env.docname
        for found in list(self.document.findall(nodes.reference)):
            kind, _, id = unquote(found.get("refuri", "")).partition(":")
            if kind == "num":
                found.replace_self(self.number(id, found))
            elif kind == "finding":
                found.replace_self(link(found.astext(), f"findings.html#{id}", kind="evidence"))
        for found in list(self.document.findall(nodes.Text)):
            above = found.parent
            while above is not None and not isinstance(above, (nodes.reference, nodes.strong, nodes.title, nodes.FixedTextElement, Number, nodes.math, nodes.math_block, nodes.raw)):
                above = above.parent
            if above is not None:
                continue
            if not isinstance(found.parent, nodes.literal):
                if "$" in found:
                    say.warning(f"a formula was left as text: {found[:60]}", location=found.parent)
                found.parent.replace(found, self.bound(str(found)))
            elif target := self.book.code(str(found), self.page):
                found.parent.replace_self(nodes.reference("", "", found.parent.deepcopy(), internal=True, refuri=target))
        for found in list(self.document.findall(nodes.math)):
            after = found.next_node(descend=False, siblings=True)
            if isinstance(after, nodes.Text) and len(found.astext()) < 35 and (sign := re.match(r"[.,;:!?)’”]+", after)):
                after.parent.replace(after, nodes.Text(str(after)[sign.end():]))
                found.replace_self(nodes.inline("", "", found.deepcopy(), nodes.Text(sign[0]), classes=["nobreak"]))
        for found in self.document.findall(nodes.literal_block):
            found["force"] = True  # what a lexer does not know is not coloured
            if self.page in self.book.by_page and "linenostart" in found.get("highlight_args", {}):
                found["highlight_args"]["lineanchors"] = "L"

    def number(self, id, found):
        if id not in self.book.numbers:
            say.warning(f"nothing is locked or computed under '{id}'", location=found)
            return nodes.Text(found.astext())
        text, known = found.astext(), self.book.numbers[id].shown
        if text and text != known or id in self.book.stale:
            say.warning(f"{id} is stale: {text} stands here, {known} is locked" if text != known else f"{id}: computed is another value than locked", location=found)
        if not self.book.lines.get(id):
            say.warning(f"no line writes '{id}'", location=found)
        return Number("", text or known, id=id)

    def bound(self, text):
        """The nodes of a text with its links."""
        out, done = [], 0
        for found in re.finditer("|".join(f"(?:{one.pattern})" for one in (EQUATIONS, FIGURES, FILE)), text):
            out.append(nodes.Text(text[done:found.start()]))
            done = found.end()
            if FILE.fullmatch(found[0]):
                target = self.book.file(found[0], self.page)
                out.append(link(found[0], target) if target else nodes.Text(found[0]))
            elif found[0].startswith("Eq"):
                out += self.split(r"\((\d+)\)", found[0], self.equation)
            else:
                out += self.split(r"\b(x?\d\d?)\b", found[0], self.figure)
        return [node for node in [*out, nodes.Text(text[done:])] if node.astext()]

    def split(self, pattern, text, made):
        done = 0
        for found in re.finditer(pattern, text):
            yield nodes.Text(text[done:found.start()])
            yield made(found)
            done = found.end()
        yield nodes.Text(text[done:])

    def equation(self, found):
        if int(found[1]) not in self.book.equations:
            say.warning(f"the article has no Eq. ({found[1]})", location=self.page)
            return nodes.Text(found[0])
        return link(found[0], f"equations.html#eq-{found[1]}", self.book.equations[int(found[1])]["name"])

    def figure(self, found):
        id = f"x{int(found[1][1:]):02d}" if found[1].startswith("x") else f"{int(found[1]):02d}"
        return link(found[0], f"fig-{id}.html", self.book.figures[id]["caption"]) if id in self.book.figures else nodes.Text(found[0])


# While Sphinx writes


def visit_number(self, node):
    book = self.builder.app.book
    tip = escape(book.tip(node["id"]))
    self.body.append(f'<a class="num" href="{book.row(node["id"])}" data-tip="{tip}" aria-label="{escape(node.astext())}: {tip}">{set_number(node.astext())}</a>')
    raise nodes.SkipNode


def visit_math(self, node):
    display = isinstance(node, nodes.math_block)
    done = self.builder.app.book.set.get((node.astext(), display), "")
    self.body.append(f'<span class="formula" tabindex="0">{done}</span>' if display else done)
    raise nodes.SkipNode


def note_formulas(app, doctree):
    for node in doctree.findall(lambda n: isinstance(n, (nodes.math, nodes.math_block))):
        app.book.formulas.setdefault((node.astext(), isinstance(node, nodes.math_block)), app.env.docname)


def typeset(app, env):
    """One run of KaTeX over all formulas; one that is refused is a warning."""
    todo = sorted(app.book.formulas)
    node = shutil.which("node") or shutil.which("nodejs") or "node"
    run = subprocess.run([node, str(HERE / "typeset.js")], input=json.dumps(todo), capture_output=True, text=True, encoding="utf-8", check=False)
    for line in run.stderr.splitlines() if run.returncode else ():
        say.warning(f"KaTeX: {line}")
    app.book.set = dict(zip(todo, json.loads(run.stdout))) if not run.returncode else {}


def link_names(app, page, template, context, doctree):
    """Links from the code of a page to what the library defines, and from its includes to their pages."""
    source = app.book.by_page.get(page)
    if not source or "body" not in context:
        return
    local, seen = local_names(source), set()

    def name(m):
        word = m[2]
        member = re.search(r">(?:\.|-&gt;|::)</span>$", m.string[max(0, m.start() - 40):m.start()]) and not m.string[:m.start()].endswith('lattice</span><span class="o">::</span>')
        if len(word) < 3 or word in local or member or word not in app.book.defined or app.book.defined[word][0] is source:
            return m[0]
        if not (word[0].isupper() or "_" in word and len(word) > 6 or re.match(r'</span><span class="[po]">(?:\(|&lt;|\{)', m.string[m.end() - 7:m.end() + 40])):
            return m[0]
        quiet = ' tabindex="-1"' if word in seen else ""
        seen.add(word)
        return '<a class="id" href="{0.page}.html#L-{1}"{2}>{3}</a>'.format(*app.book.defined[word], quiet, m[0])

    def include(m):
        found = app.book.by_include.get(unescape(m[1]))
        return f'<a class="id" href="{found.page}.html">{m[0]}</a>' if found else m[0]

    body = re.sub(r'<span class="(n|nf|nc)">(\w+)</span>', name, context["body"])
    context["body"] = re.sub(r'<span class="cpf">&quot;([^<]*?)&quot;</span>', include, body)


def complaints(folder):
    """Links that lead nowhere, ids used twice, and what would be fetched from a network, in a finished book."""
    texts = {path.name: ecsv.text_of(path) for path in sorted(folder.glob("*.html"))}
    ids = {name: Counter(re.findall(r'\sid="([^"]+)"', text)) for name, text in texts.items()}
    for name, text in texts.items():
        yield from (f"{name}: two elements have the id '{id}'" for id, count in ids[name].items() if count > 1)
        for tag, address in set(re.findall(r'<(a|link|script|img)\b[^>]*?\s(?:href|src)="([^"]*)"', text)):
            target, _, place = unescape(address).partition("#")
            target = unquote(target.partition("?")[0]) or name
            if re.match(r"\w+:", target):
                if tag != "a" and not target.startswith("data:"):
                    yield f"{name}: loads {target}"
            elif target not in texts and not (folder / target).exists() or place and target in texts and unescape(place) not in ids[target]:
                yield f"{name}: {address} leads nowhere"
        if found := re.search(r"(?:num|fig|finding):\w[\w.]*(?=[\"')])", re.sub(r"<(code|pre|script)\b.*?</\1>", "", text, flags=re.S)):
            yield f"{name}: {found[0]} was not bound"


def mend_theme(static):
    """Debian's furo takes a style sheet from a web server and a script as a module; a folder can be read with both inside."""
    for name, pattern, place in [("styles/furo.css", r"@import url\(/javascript/([^)]*)\);", Path("/usr/share/javascript")),
                                 ("scripts/furo.js", r'^import \w+ from "\./([\w-]+\.js)";', static / "scripts")]:
        text = ecsv.text_of(static / name)
        (static / name).write_text(re.sub(pattern, lambda m: ecsv.text_of(place / m[1]), text), encoding="utf-8")


def finish(app, error):
    if error or app.builder.format != "html":
        return
    app.book.copy(Path(app.outdir))
    mend_theme(Path(app.outdir) / "_static")
    if found := sorted(complaints(Path(app.outdir))):
        raise ExtensionError("\n  ".join([f"the book is not whole: {len(found)} complaints", *found[:40]]))


def begin(app):
    try:
        app.book.write()
    except ecsv.Fault as fault:
        raise ExtensionError(str(fault)) from None


def prepare(app, config):
    try:
        app.book = Book(config.literate_root or HERE.parent, config.literate_build or HERE.parent / "build", app.srcdir)
    except ecsv.Fault as fault:
        raise ExtensionError(str(fault)) from None
    (app.book.pages / "static/fonts").mkdir(parents=True, exist_ok=True)  # Sphinx asks for it before it is filled
    config.html_static_path = [str(HERE / "static"), str(app.book.pages / "static")]


def setup(app):
    app.add_config_value("literate_root", "", "env")
    app.add_config_value("literate_build", "", "env")
    app.add_node(Number, html=(visit_number, None))
    app.add_directive("fig", Figure)
    app.add_transform(Bind)
    app.add_html_math_renderer("katex", (visit_math, None), (visit_math, None))
    for event, handler in [("config-inited", prepare), ("builder-inited", begin), ("doctree-read", note_formulas), ("env-updated", typeset),
                           ("html-page-context", link_names), ("build-finished", finish)]:
        app.connect(event, handler)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
