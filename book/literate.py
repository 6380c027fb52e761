"""The book as Sphinx reads it. A C++ source becomes a page in MyST: its blocks of prose `/** ... */` as they are, the code
between them with the line numbers of the file. The lists (statements, findings, numbers, figures, commands) are pages made
from tables. While Sphinx reads them, what prose mentions is bound to what made it:

    [0.0650](cell:shares/s=-0.7/packet), [1.62e-11](statement:pn.omega11)    a number: its error on hover, a link to its row
    ![Caption](fig:19)            a figure with its script, program, tables and command
    <!-- pull --> ... <!-- /pull -->    the sentence of a finding, with a link to its evidence
    Eq. (24), figure 19, well.hpp, `sec33_floquet`, `pn.omega11`    links

Nothing is judged here: verdicts are those of build/report/claims.ecsv. What cannot be bound is a warning, and with -W
the end of the build."""

import json
import math
import re
import shutil
import subprocess
from collections import Counter
from html import escape, unescape
from pathlib import Path
from urllib.parse import unquote

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.errors import ExtensionError
from sphinx.transforms import SphinxTransform
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from lineage import ecsv, inventory, markdown as md
from lineage.cells import cited, home_of, in_full, read_cells
from lineage.chapters import command_of, explained_by, read_commands, read_costs, run_of, shown_cost
from lineage.claims import (KINDS, OBTAINED, agrees, by_name, in_plain, meanings, programs_of, read_answers, read_claims,
                            read_findings, read_literature, read_moved, read_readings, read_second, read_statements, read_verdicts, said as filled,
                            with_sentences)
from lineage.lock import quoted, read_lock
from lineage.refresh import printed, read_figures
from lineage.sources import definitions, local_names, sources_of
from lineage.values import Finding
from lineage.volumes import joined, volumes
from live import live

HERE = Path(__file__).resolve().parent
KATEX = [Path("/usr/share/javascript/katex"), Path("/usr/share/nodejs/katex/dist")]
LISTS = ("published", "findings", "figures", "equations", "commands", "library")
HEAD_OF_CHAPTER = re.compile(r"<!-- head -->\n.*?<!-- /head -->\n", re.S)
STATEMENTS = re.compile(r"<!-- statements -->\n.*?<!-- /statements -->", re.S)
ORPHAN = "---\norphan: true\n---\n"
HEAD = re.compile(r"(?:(?:#\w+.*|using namespace.*|namespace \w+ \{|[ \t]*)\n){4,}")
EQUATIONS = re.compile(r"\bEqs?\.\s*\(\d+\)(?:(?:,|\s+and|\s+to|,\s+and)\s+\(\d+\))*")
FIGURES = re.compile(r"\b(?:[Ff]igures?|Figs?\.)\s+x?\d\d?\b(?:(?:,| and| to)\s+x?\d\d?\b)*")
FILE = re.compile(r"\b(?:[\w-]+/)*\w+\.(?:hpp|cpp|ipp)\b")
NAMED = re.compile("|".join(f"(?:{one.pattern})" for one in (EQUATIONS, FIGURES, FILE)))
UNTOUCHED = (nodes.reference, nodes.strong, nodes.title, nodes.FixedTextElement, nodes.math, nodes.math_block, nodes.raw)
say = logging.getLogger(__name__)


def spoken(id):
    return f"Figure {id if id.startswith('x') else int(id)}"


class Book:
    """Everything that a page may mention, and the pages."""

    def __init__(self, root, build, pages):
        self.root, self.build, self.pages = Path(root), Path(build), Path(pages)
        self.data, self.drawn, self.compiled = self.build / "data", self.build / "figures", self.root / "build/live"
        first, *more = volumes(root)
        self.volumes = [first] + [one for one in more if any((self.data / program).is_dir() for program in programs_of(one))]
        self.read_sources()
        self.read_numbers()
        self.read_figures()
        self.lives = live.found(self.volumes, self.compiled)
        self.buttons = joined(live.read_buttons, [v / "book/live/figures.txt" for v in self.volumes]) if self.lives else {}
        self.formulas, self.set = {}, {}
        self.places = {}  # what -> pages that speak of it
        for s in self.sources:
            text = "\n".join(self.woven(text, home_of(s.path)) for prose, _, text in s.blocks if prose)
            said = [(name,) for name in cited(text)]
            said += re.findall(r"\]\((finding:[^)]+)\)|^```\{(fig\} \w+)$", text, re.M)
            said += [("eq " + n,) for run in EQUATIONS.findall(text) for n in re.findall(r"\((\d+)\)", run)]
            for what in map("".join, said):
                self.places.setdefault(what, {})[s.page] = True

    def read_sources(self):
        """The chapters under the parts of book/contents.txt, all other sources by folder, and what headers define."""
        self.parts, part = {}, "Chapters"
        for line in ecsv.lines_of(self.root / "book/contents.txt"):
            if line.startswith("="):
                part = line[1:].strip()
            else:
                self.parts.setdefault(part, []).append(line)
        order = [name for names in self.parts.values() for name in names]
        self.chapters, self.rest = sources_of(self.root, self.volumes, order)
        self.sources = self.chapters + [source for module in self.rest.values() for source in module]
        self.by_page, self.by_include = {s.page: s for s in self.sources}, {s.included: s for s in self.sources}
        self.by_path = {s.path: s for s in self.sources}
        found = [(name, s, line) for s in self.sources if s.is_header for name, line in definitions(s.text).items()]
        once = Counter(name for name, *_ in found)
        self.defined = {name: (s, f"{s.page}.html#L-{line}") for name, s, line in found if once[name] == 1}

    def read_numbers(self):
        """Statements with their verdicts, findings, and all numbers by name: locked, or as a program wrote them."""
        every = self.volumes
        self.claims, self.findings = read_claims(self.root), joined(read_findings, every)
        self.second, self.alone, self.seconds = (joined(read, every) for read in (read_second, read_commands, read_costs))
        programs = [program for v in every for program in programs_of(v)]
        locked, report = joined(read_lock, every), self.build / "report"
        cells = read_cells(self.data, programs, quoted(self.root))
        ecsv.check_all_written(self.data)
        fresh = cells | joined(lambda volume: read_answers(volume, report), every)
        self.numbers = by_name(fresh | locked)
        self.verdicts = joined(lambda volume: read_verdicts(volume, report), every)
        self.readings = joined(lambda volume: read_readings(volume, report), every)
        self.judged = joined(read_statements, every)
        self.literature = joined(read_literature, every)
        self.lines = {name: self.table_at(f.program, f.id.partition("/")[0]) for name, f in self.numbers.items() if f.what == "cell"}
        for id, (_, path, line) in self.judged.items():
            self.lines[id] = self.by_path[str(path.relative_to(self.root))], line

    def read_figures(self):
        self.figures = joined(read_figures, self.volumes)
        equations = ecsv.read(self.root / "book/equations.ecsv", ("number", "label", "name", "tex")).rows
        self.equations = {int(row["number"]): row for row in equations}
        self.labels = {row["label"]: f"Eq. ({row['number']})" for row in equations}
        self.labels |= {row["label"]: f"Fig. {int(id)}" for id, row in self.figures.items() if row["label"]}

    def table_at(self, program, table):
        """Where a chapter, or the code of its section that it includes, names a table first, as (source, line), or the longest piece
        of a name that they put together."""
        chapter = self.by_page[program]
        stems = [name.rpartition(".")[0] for name in chapter.includes if name.startswith("sec")]
        places = [chapter, *(s for s in self.sources if s.included.rpartition(".")[0] in stems)]
        said = [(len(word), -at, -k) for at, source in enumerate(places) for k, line in enumerate(source.text.split("\n"), 1)
                for word in re.findall(r'"(\w{3,})"', line) if table.startswith(word) or table.endswith(word)]
        return (places[-max(said)[1]], -max(said)[2]) if said else None

    # Links

    def row(self, name):
        """Where a list has this number."""
        return f"published.html#{name}" if name in self.claims else f"numbers-{re.match('[^./]*', name)[0]}.html#{name}"

    def file(self, text, here=""):
        """The page of a source that a text names; empty where the name is that of none or of several."""
        text, near = text.removeprefix("beyond/").removeprefix("src/"), self.by_page.get(here)
        found = [s for s in self.sources if s.included == text] or [s for s in self.sources if s.included.endswith("/" + text)]
        if len(found) > 1 and near:
            found = [s for s in found if s.module == near.module or s.included in near.includes]
        return found[0].page + ".html" if len(found) == 1 and found[0].page != here else ""

    def code(self, word, here=""):
        """What a piece of code in prose refers to: a statement, a number, a program, a file or a name of the library."""
        if word in self.claims or word in self.numbers:
            return self.row(word)
        program = word.removeprefix("build/bin/").partition(" ")[0]
        if program in self.by_page and not self.by_page[program].module and program != here:
            return f"{program}.html"
        if FILE.fullmatch(word):
            return self.file(word, here)
        clear, word = word[:1].isupper() or "_" in word and len(word) > 6 or word.endswith("()"), word.removesuffix("()")
        own = here in self.by_page and word in local_names(self.by_page[here].text)
        return self.defined[word][1] if clear and not own and word in self.defined else ""

    def line_link(self, name):
        found = self.lines.get(name)
        if not found:
            return ""
        above = re.findall(r"^## (.+)$", "\n".join(found[0].text.split("\n")[:found[1]]), re.M)
        place = f"{above[-1].strip(' */')}, line" if above and not found[0].module else "line"
        return md.link(f"{found[0].page}.html#L-{found[1]}", f"{place} {found[1]} of {found[0].name}")

    def page_link(self, page):
        return md.link(page + ".html", page)

    def figure_link(self, id):
        return md.link(f"fig-{id}.html", spoken(id))

    def speaks(self, what, but=""):
        """Links to the chapters and files that speak of something."""
        return ", ".join(self.page_link(page) for page in self.places.get(what, ()) if page != but)

    def tip(self, name):
        """What a reader sees beside a number."""
        found, claim = self.numbers[name], self.claims.get(name)
        if not claim:
            return md.with_error(found)
        return f"{md.with_error(found)}; the article prints {printed(claim)}: {self.verdicts[name]['verdict']}"

    def cost(self, program):
        seconds = self.seconds.get(program, math.nan)
        return "" if math.isnan(seconds) else f", {shown_cost(seconds)} s on two cores"

    # Chapters and other sources

    def woven(self, text, home=""):
        """A block of prose as MyST: sentences of findings in their places, figures as directives, each formula on one
        line, since a line that begins with a minus would begin a list."""
        text = in_full(with_sentences(HEAD_OF_CHAPTER.sub("", text), self.findings), home)
        text = re.sub(r"(```.*?```|`[^`]*`)|(\$\$?)(.+?)\2", lambda m: m[1] or m[0].replace("\n", " "), text, flags=re.S)
        return re.sub(r"!\[([^\]]*)\]\(fig:([^)]*)\)", lambda m: f"\n\n```{{fig}} {m[2]}\n{m[1]}\n```\n\n", text)

    def listing(self, code, first):
        """Code between prose; what a file includes at its beginning is folded."""
        if not (head := HEAD.match(code + "\n")) or not code.startswith("#"):
            return md.listing(code, "cpp", first)
        folded, rest = md.listing(head[0].rstrip(), "cpp", first), code[head.end():]
        first += head[0].count("\n") + len(rest) - len(rest.lstrip("\n"))
        fold = f'\n<details class="fold"><summary>What this file includes</summary>\n{folded}\n</details>\n'
        return fold + (md.listing(rest.strip("\n"), "cpp", first) if rest.strip() else "")

    def source_page(self, source):
        """A chapter, a header, or what is compiled for one."""
        parts = [] if source.titled else [f"# {source.title}\n"]
        parts += [f"\n{self.woven(text, home_of(source.path))}\n" if prose else self.listing(text, first) for prose, first, text in source.blocks
                  if text.strip() != "#pragma once"]
        card = self.card_of_part(source) if source.module else self.card(source.path, source.stem)
        page = re.sub(r"^# .+$", lambda m: f'{m[0]}\n\n<p class="card">{card}</p>\n', "".join(parts), count=1, flags=re.M)
        if source.module:
            return ORPHAN + page
        return STATEMENTS.sub(lambda _: self.decided(source.stem), page) + live.SCRIPT * bool(self.lives)

    def card(self, path, program):
        """What stands below the title of a chapter."""
        return (f"The source is <code>{path}</code>, the program <code>{run_of(program)}</code>{self.cost(program)}. "
                + md.link(f"numbers-{program}.html", "All its numbers and tables") + "; "
                + md.link(f"commands.html#{program}", "its options") + ".")

    def card_of_part(self, source):
        """The same of a source that is no chapter."""
        halves = [s for s in self.rest[source.module] if s.stem == source.stem and s is not source]
        said = [("compiled in" if source.is_header else "declared in", halves),
                ("needed by", [s for s in self.sources if source.included in s.includes and s not in halves])]
        lines = [f"{word} " + ", ".join(md.link(s.page + ".html", s.name) for s in found) for word, found in said if found]
        return "<br>".join([f'{md.link("library.html", "Library")}: <code>{source.path}</code>', *lines])

    def decided(self, program):
        """The statements that a chapter decides, and numbers of other authors, with links."""
        answers = [self.claim_row(id) for id, claim in self.claims.items() if claim["program"] == program]
        others = [[md.spelled(row["quantity"]), f"{md.plain(row['citation'])} {md.spelled(row['where'])}",
                   md.spelled(printed(row)), md.number(md.with_error(self.numbers[id])),
                   md.verdict(self.verdicts[id]["verdict"]), f"{OBTAINED[row['obtained']]}. {md.spelled(row['note'])}"]
                  for id, row in self.literature.items() if row["program"] == program]
        return (md.table(["statement", "article", "here", "verdict"], answers)
                + md.table(["number of others", "source", "printed", "here", "verdict", "read"], others))

    # Statements, findings, numbers

    def claim_row(self, id):
        """A statement of the article in short, below its chapter."""
        claim, found = self.claims[id], self.numbers.get(id)
        return [f"{md.link('published.html#' + id, md.name(id))} {md.spelled(claim['quantity'])}", md.spelled(printed(claim)),
                md.number(md.with_error(found)) if found else "<br>".join(map(comparison, self.verdicts[id].get("short", "").split("; "))),
                md.verdict(self.verdicts[id]["verdict"])]

    def whole_row(self, id):
        """The same in the table of all: what decides, what is assumed, why it fails, where it is told."""
        claim, (_, article, here, said) = self.claims[id], self.claim_row(id)
        where = re.sub(r"\b(?:Eqs?\.|Figs?\.?) (\w+)", lambda m: self.labels.get(m[1], m[0]), claim["where"])
        if id not in self.numbers:
            here = "<br>".join(comparison(text) for text in self.verdicts[id]["found"].split("; "))
        if claim["assumption"]:
            said += f" {md.spelled(filled(claim['assumption'], self.numbers))}"
        said += self.other_readings(id)
        if claim["reason"]:
            see = ", ".join(self.page_link(p) for p in explained_by(id, self.claims) if p in self.by_page)
            said += f" {md.spelled(filled(claim['reason'], self.numbers))} See {see}."
        program, words = claim["program"], set(re.findall(r"\w+", claim["where"]))
        chapter = md.link(program + ".html", "chapter") if program in self.by_page else ""
        figures = [self.figure_link(f) for f, row in self.figures.items() if row["label"] in words]
        source, line = self.lines[id]
        links = ", ".join(filter(None, [md.link(f"{source.page}.html#L-{line}", "judged"), chapter, *figures, self.speaks(id, program)]))
        return [f"{md.place(id)}{md.name(id)} {md.spelled(claim['quantity'])} ({md.plain(where)})", article,
                here + self.second_mark(id), said, links + self.alone_mark(id)]

    def other_readings(self, id):
        """What other choices give, and half and twice our bounds, folded."""
        def found(row):
            number = row["value"] == row["value"] and md.number(md.with_error(Finding("", "", row["value"], row["error"], row["unit"])))
            return ", ".join(filter(None, [number, row["outcome"]]))

        rows = [f"<dt>{md.spelled(row['reading'])}: {found(row)}</dt><dd>{md.spelled(row['choice'])}</dd>" for row in self.readings.get(id, ())]
        return f"<details><summary>{len(rows)} reading{'s' * (len(rows) > 1)}</summary><dl>{''.join(rows)}</dl></details>" if rows else ""

    def alone_mark(self, id):
        return f"; alone: `{self.alone[id][0]}`" if id in self.alone else ""

    def second_mark(self, id):
        if id not in self.numbers or not agrees(id, self.numbers[id], self.second):
            return ""
        return f' <span class="second">✓ second route: {md.spelled(self.second[id][1])}</span>'

    def published_page(self):
        counts = Counter(self.verdicts[id]["verdict"] for id in self.claims)
        lost = [self.claim_row(id) for id in self.claims if self.verdicts[id]["verdict"] == "discrepant"]
        part = [[*self.claim_row(id)[:2], md.spelled(claim["cause"])] for id, claim in self.claims.items()
                if self.verdicts[id]["verdict"] == "in part"]
        tally = [[md.verdict(v), str(counts[v]), text] for v, text in meanings().items() if counts[v]]
        out = [md.table(["verdict", "rows", "meaning"], tally),
               *["\n## What does not survive\n"] * bool(lost), md.table(["statement", "article", "here", "verdict"], lost),
               *["\n## What survives in part\n"] * bool(part), md.table(["statement", "article", "where not"], part)]
        for section in sorted({claim["section"] for claim in self.claims.values()}):
            rows = [self.whole_row(id) for id, claim in self.claims.items() if claim["section"] == section]
            out.append(f"\n## Section {section}\n" + md.table(["statement", "article", "here", "verdict", "see"], rows, "rows statements"))
        moved = [[md.link("#" + row["id"], md.name(row["id"])), row["date"], md.verdict(row["before"]), md.verdict(row["after"]), md.spelled(row["why"])]
                 for row in read_moved(self.root)]
        out += ["\n## Verdicts that moved\n\nEvery verdict that became another one, in the order of time, in the words of today's rule.\n",
                md.table(["statement", "day", "before", "after", "why"], moved)]
        return "\n".join(out)

    def findings_page(self):
        out = [md.table(["evidence", "meaning"], [[f'<span class="evidence">{k}</span>', text] for k, text in KINDS.items()])]
        for id, row in self.findings.items():
            figure = ", " + self.figure_link(row["figure"]) if row["figure"] in self.figures else ""
            out += [f'\n{md.place(id)}\n\n## {id}\n\n<span class="evidence">{row["kind"]}</span> {in_full(row["sentence"])}\n',
                    f"- **Shown over** {md.spelled(row['range'])}", f"- **Tried against it** {md.spelled(row['tried'])}",
                    "- **Carried by**", *(f"  - {comparison(text)}" for text in self.verdicts[id]["found"].split("; ")),
                    f"- **Second route** {md.spelled(row['second'])}",
                    f'- **Stands in** {self.speaks("finding:" + id) or "the report"}{figure}; `make show ID={id}`']
        return "\n".join(out)

    def numbers_page(self, program):
        """All numbers of a program, and its tables with their columns."""
        paths = ecsv.tables_in(self.data / program)
        means = {(path.stem, c.name): c.description for path in paths for c in ecsv.header_of(ecsv.text_of(path))[0]}
        rows = [[md.place(name) + md.name(f.id), md.spelled(means.get((f.id.partition("/")[0], f.id.rpartition("/")[2]), "")), md.number(md.with_error(f)) + self.second_mark(name),
                 ", ".join(filter(None, [self.line_link(name), self.speaks(name, program)])) + self.alone_mark(name)]
                for name, f in sorted(self.numbers.items()) if f.program == program and f.what == "cell"]
        out = [f"{ORPHAN}# Numbers and tables of {program}\n\n*{self.by_page[program].title}*: `{program}`, computed by "
               f"`{run_of(program)}`{self.cost(program)}. What they decide is in [published against "
               "reproduced](published.md); how to read a table is told in [use the data](data.md).\n",
               *["\n## Numbers\n"] * bool(rows), md.table(["number", "meaning", "value", "made at"], rows), "\n## Tables\n"]
        return "\n".join(out + [f"\n### {path.stem}\n\n{md.data(f'{program}/{path.name}')}\n{columns(path)}" for path in paths])

    # Figures, equations, commands, data

    def figure_page(self, id):
        row = self.figures[id]
        script = next(path for v in self.volumes if (path := v / "figures" / row["script"]).exists())
        own = "A figure of this book" if id[0] == "x" else f"A figure of the article, section {row['section']}"
        out = [f"{ORPHAN}# {spoken(id)}\n\n```{{fig}} {id}\n:whole:\n\n{row['caption']} {row['details']}\n```\n\n{own}; shown in "
               f"{self.speaks('fig} ' + id) or self.page_link(row['program'])}.\n\n## Tables\n"]
        for path in (path for name in row["data"].split() if (path := self.data / row["program"] / f"{name}.ecsv").exists()):
            count = len(ecsv.rows_of(ecsv.text_of(path))) - 1
            out.append(f"\n### {path.stem}\n\n{md.data(row['program'] + '/' + path.name)}, {count} rows\n{columns(path)}")
        language = "python" if row["script"].endswith(".py") else "gnuplot"
        out.append("\n## Script\n" + md.listing(ecsv.text_of(script).rstrip(), language, 1))
        return "\n".join(out) + (live.SCRIPT if self.lives else "")

    def stem(self, id):
        return Path(self.figures[id]["script"]).stem

    def figures_page(self):
        cells = [f'<a href="fig-{id}.html"><img src="figures/{self.stem(id)}.svg" alt="{escape(row["caption"])}" loading="lazy">'
                 f"<span><b>{spoken(id)}.</b> {escape(row['caption'])}</span></a>" for id, row in self.figures.items()]
        return f'\n<div class="gallery">{"".join(cells)}</div>\n'

    def equations_page(self):
        return "".join(f"\n{md.place(f'eq-{n}')}\n\n## ({n}) {row['name']}\n\n$$\n{row['tex']} \\tag{{{n}}}\n$$\n\n"
                       f"{self.speaks(f'eq {n}')}\n" for n, row in self.equations.items())

    def commands_page(self):
        """What the programs say of themselves; options that all have stand once."""
        rows = list(inventory.commands(self.root, self.root / "build/bin"))
        common = ("help", "version", "describe", "out", "quick", "threads", "output")
        first = {row["option"]: row["meaning"] for row in reversed(rows)}
        out = [md.table(["option", "meaning"], [[f"`--{name}`", md.plain(first[name])] for name in common if name in first])]
        for row in (row for row in rows if not row["option"]):
            name = f"{row['program']} {row['command']}".strip()
            own = [[f"`--{o['option']}`", *map(md.plain, (inventory.allowed(o), inventory.explained(o)))] for o in rows
                   if (o["program"], o["command"]) == (row["program"], row["command"]) and o["option"] not in ("", *common)]
            out.append(f"\n{md.place(name.replace(' ', '-'))}\n\n##{'#' * bool(row['command'])} `{name}`\n\n"
                       f"{md.plain(row['meaning'])}\n{md.table(['option', 'allowed', 'meaning'], own)}")
        return "\n".join(out)

    def data_page(self):
        """The words of data.md, and the tables of each program."""
        lists = [f"- {md.link(f'numbers-{s.stem}.html', s.stem)}: " + ", ".join(md.plain(path.stem) for path in paths)
                 for s in self.chapters if (paths := ecsv.tables_in(self.data / s.stem))]
        return "\n".join([ecsv.text_of(HERE / "data.md"), "## All numbers and tables\n", *lists, ""])

    def machines_page(self):
        """The words of machines.md, whose files a reader of the book finds in the repository."""
        return re.sub(r"\[(`[^`]*`)\]\(\.\./[^)]*\)", r"\1", ecsv.text_of(HERE / "machines.md"))

    def library_page(self):
        """The modules in the order of their list, with their files."""
        ideas = {Path(folder).name: idea for folder, idea in inventory.modules(self.root).items()}
        out = []
        for module in [m for m in ideas if m in self.rest] + [m for m in self.rest if m not in ideas]:
            files = [md.link(s.page + ".html", s.name) + f" {s.title}" * (s.is_header and s.titled) for s in self.rest[module]]
            out.append(f"\n## {module}\n\n{ideas.get(module, 'What one section needs')}.\n\n{'; '.join(files)}\n")
        return "".join(out)

    def start_page(self, lists):
        """The words of start.md, what comes out, and the contents."""
        counts = Counter(self.verdicts[id]["verdict"] for id in self.claims)
        found = [f"- {in_plain(row['sentence'], self.numbers)} ({self.figure_link(row['figure'])})"
                 for row in self.findings.values() if row["front"] and row["figure"] in self.figures]
        tally = ", ".join(f"{counts[v]} {md.verdict(v)}" for v in meanings() if counts[v])
        out = [ecsv.text_of(self.root / "book/start.md"), f"\nOf {len(self.claims)} statements: {tally}."]
        out += ["\nFound besides:\n"] * bool(found) + found
        parts, part = {}, "Chapters"
        for name in (s.stem for s in self.chapters):
            part = next((one for one, held in self.parts.items() if name in held), part)
            parts.setdefault(part, []).append(name)
        for part, pages in [*parts.items(), ("Lists", lists)]:
            out.append(f"\n```{{toctree}}\n:hidden:\n:caption: \"{part}\"\n\n" + "\n".join(pages) + "\n```\n")
        return "\n".join(out)

    def write(self):
        """All pages that Sphinx reads, and the drawings that they show."""
        for old in self.pages.glob("*.md"):
            old.unlink()
        pages = {s.page: self.source_page(s) for s in self.sources} | {f"fig-{id}": self.figure_page(id) for id in self.figures}
        pages |= {f"numbers-{s.stem}": self.numbers_page(s.stem) for s in self.chapters}
        heads = dict(zip(LISTS[1:], re.split(r"\n(?=# )", ecsv.text_of(HERE / "lists.md"))))
        heads["published"] = ecsv.text_of(HERE / "published.md")
        lists = {name: heads.get(name, "") + getattr(self, f"{name}_page")() for name in LISTS}
        lists |= {"symbols": ecsv.text_of(HERE / "symbols.md"), "python": ecsv.text_of(HERE.parent / "python/own_chain.md"),
                  "data": self.data_page(), "machines": self.machines_page()}
        lists |= {name: ecsv.text_of(folder / f"{name}.md") + live.SCRIPT for folder, name in self.lives}
        for name, text in (pages | lists | {"index": self.start_page(lists)}).items():
            (self.pages / f"{name}.md").write_text(text, encoding="utf-8")
        (self.pages / "figures").mkdir(exist_ok=True)
        (self.pages / "static/fonts").mkdir(parents=True, exist_ok=True)
        for id in self.figures:
            if not (drawing := self.drawn / f"{self.stem(id)}.svg").exists():
                raise ecsv.Fault(f"{drawing} is missing: draw it first (make figures)")
            shutil.copyfile(drawing, self.pages / "figures" / drawing.name)
        katex = next((folder for folder in KATEX if (folder / "katex.min.css").exists()), None)
        if not katex:
            raise ecsv.Fault("katex.min.css is not installed (Debian: libjs-katex, fonts-katex)")
        css = ecsv.text_of(katex / "katex.min.css")
        css = re.sub(r"src:[^;}]*?url\(([^)]*?\.woff2)\)[^;}]*", r"src:url(\1) format('woff2')", css)
        (self.pages / "static/katex.css").write_text(css, encoding="utf-8")
        for font in sorted(set(re.findall(r"fonts/(\w[\w-]*\.woff2)", css))):
            shutil.copyfile(katex / "fonts" / font, self.pages / "static/fonts" / font)

    def copy(self, out):
        """What pages load or offer besides: drawings, tables, the live pages."""
        shutil.copytree(self.pages / "figures", out / "figures", dirs_exist_ok=True)
        for path in (path for id in self.figures if (path := self.drawn / f"{self.stem(id)}.pdf").exists()):
            shutil.copyfile(path, out / "figures" / path.name)
        for path in (path for s in self.chapters for path in ecsv.tables_in(self.data / s.stem)):
            (out / "data" / path.parent.name).mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, out / "data" / path.parent.name / path.name)
        live.copy(self.lives, self.compiled, out)


def columns(path):
    """The columns of a table."""
    rows = [[md.name(c.name), md.plain(md.unit(c.unit).strip()), md.spelled(c.description)]
            for c in ecsv.header_of(ecsv.text_of(path))[0]]
    return md.table(["column", "unit", "meaning"], rows, "columns")


def comparison(text):
    """One as `verdicts` writes it, `sweep.speed (s = 0): 1.2 +- 3e-4 < 2`: what was read, and both sides."""
    what, colon, sides = text.rpartition(": ")
    if not colon:
        return md.plain(text)
    return f"{md.plain(what)}: {md.number(sides.replace('+-', '±'))}"


# While Sphinx reads


class Number(nodes.Inline, nodes.TextElement):
    """A number of ours in prose."""


def link(text, address, title="", kind=()):
    return nodes.reference("", text, internal=True, refuri=address, classes=list(kind), **({"reftitle": title} if title else {}))


def put(text, others):
    """Puts nodes in the place of a text. Docutils would take the first text that says the same."""
    at = next(i for i, node in enumerate(text.parent.children) if node is text)
    text.parent[at:at + 1] = others


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
        image, words = nodes.image(uri=f"figures/{stem}.svg", alt=row["caption"]), nodes.Element()
        self.state.nested_parse(StringList(list(self.content), self.get_source_info()[0]), 0, words)
        caption = nodes.caption("", "", nodes.strong("", spoken(id) + "."), nodes.Text(" "))
        caption += words[0].children if len(words) else []
        tables = ", ".join(md.data(f"{row['program']}/{name}.ecsv") for name in row["data"].split())
        buttons = "".join(f' <a class="live" href="{escape(address)}">{said}</a>' for said, address in book.buttons.get(id, ()))
        drawing = f' Also as <a href="figures/{stem}.svg">SVG</a>' if whole else ""
        drawing += f' and <a href="figures/{stem}.pdf">PDF</a>' if whole and (book.drawn / f"{stem}.pdf").exists() else ""
        script, program = md.link(f"fig-{id}.html#script", "figures/" + row["script"]), row["program"]
        made = (f'<p class="made"><code>{command_of(id)}</code>: {script} draws {tables} of {book.page_link(program)} '
                f"(<code>{run_of(program)}</code>{book.cost(program)}).{drawing}{buttons}</p>")
        shown = image if whole else nodes.reference("", "", image, internal=True, refuri=f"fig-{id}.html")
        figure = nodes.figure("", shown, caption, nodes.legend("", nodes.raw("", made, format="html")))
        if id not in (seen := self.env.temp_data.setdefault("figures", set())):
            figure["ids"].append(f"fig-{id}")
        seen.add(id)
        return [figure]


def in_anchor(text):
    """Whether a link in HTML is open where a text begins."""
    before = text.parent.children[:text.parent.index(text)]
    tags = [one.astext() for one in before if isinstance(one, nodes.raw) and re.match("</?a\\b", one.astext())]
    return bool(tags) and not tags[-1].startswith("</")


class Bind(SphinxTransform):
    """Binds the links cell:, statement: and finding:, and what prose names, in one page."""
    default_priority = 5

    def apply(self, **given):
        self.book, self.page = self.env.app.book, self.env.docname
        for found in list(self.document.findall(nodes.reference)):
            kind, _, id = unquote(found.get("refuri", "")).partition(":")
            if kind in ("cell", "statement"):
                found.replace_self(self.number(id, found))
            elif kind == "finding":
                found.replace_self(link(found.astext(), f"findings.html#{id}", kind=["evidence"]))
        for found in list(self.document.findall(nodes.Text)):
            above = found.parent
            while above is not None and not isinstance(above, (Number, *UNTOUCHED)):
                above = above.parent
            if in_anchor(found):
                continue
            if above is None and isinstance(found.parent, nodes.literal):
                if target := self.book.code(str(found), self.page):
                    found.parent.replace_self(nodes.reference("", "", found.parent.deepcopy(), internal=True, refuri=target))
            elif above is None:
                put(found, self.bound(found))
        for found in self.document.findall(nodes.literal_block):
            found["force"] = True  # what a lexer does not know is not coloured
            if self.page in self.book.by_page and "linenostart" in found.get("highlight_args", {}):
                found["highlight_args"]["lineanchors"] = "L"
        self.hold_signs()

    def hold_signs(self):
        """No line begins with the comma behind a short formula."""
        for found in list(self.document.findall(nodes.math)):
            after = found.next_node(descend=False, siblings=True)
            if isinstance(after, nodes.Text) and len(found.astext()) < 35 and (sign := re.match(r"[.,;:!?)’”]+", after)):
                put(after, [nodes.Text(str(after)[sign.end():])])
                found.replace_self(nodes.inline("", "", found.deepcopy(), nodes.Text(sign[0]), classes=["nobreak"]))

    def number(self, id, found):
        if id not in self.book.numbers:
            say.warning(f"'{id}' has no reference value and no computed value", location=found)
            return nodes.Text(found.astext())
        number = self.book.numbers[id]
        text, known = found.astext(), number.shown
        if text == "to":  # as the sentence of a finding has it
            text = number.shown_as_interval
        if text not in ("", known, number.shown_like(text)):
            say.warning(f"{id} is stale: the text has {text}, the reference value is {known} (make refresh)", location=found)
        if not self.book.lines.get(id):
            say.warning(f"no line of the sources names '{id}'", location=found)
        return Number("", text or number.shown_like(""), id=id)

    def bound(self, text):
        """The nodes of a text with its links."""
        if "$" in text:
            say.warning(f"a formula was left as text: {text[:60]}", location=text.parent)
        out, done = [], 0
        for found in NAMED.finditer(text):
            out.append(nodes.Text(text[done:found.start()]))
            done = found.end()
            if FILE.fullmatch(found[0]):
                target = self.book.file(found[0], self.page)
                out.append(link(found[0], target) if target else nodes.Text(found[0]))
            else:
                pattern, made = (r"\d+", self.equation) if found[0].startswith("Eq") else (r"\bx?\d\d?\b", self.figure)
                at = 0
                for one in re.finditer(pattern, found[0]):
                    out += [nodes.Text(found[0][at:one.start()]), made(one[0])]
                    at = one.end()
                out.append(nodes.Text(found[0][at:]))
        return [node for node in [*out, nodes.Text(text[done:])] if node.astext()]

    def equation(self, text):
        if int(text) not in self.book.equations:
            say.warning(f"the article has no Eq. ({text})", location=self.page)
            return nodes.Text(text)
        return link(text, f"equations.html#eq-{text}", self.book.equations[int(text)]["name"])

    def figure(self, text):
        id = f"x{int(text[1:]):02d}" if text.startswith("x") else f"{int(text):02d}"
        return link(text, f"fig-{id}.html", self.book.figures[id]["caption"]) if id in self.book.figures else nodes.Text(text)


# While Sphinx writes


def visit_number(self, node):
    book, text = self.builder.app.book, node.astext()
    row, tip = book.row(node["id"]), escape(book.tip(node["id"]))
    self.body.append(f'<a class="num" href="{row}" data-tip="{tip}" aria-label="{escape(text)}: {tip}">{md.number(text)}</a>')
    raise nodes.SkipNode


def visit_math(self, node):
    display = isinstance(node, nodes.math_block)
    done = self.builder.app.book.set.get((node.astext(), display), "")
    self.body.append(f'<span class="formula" tabindex="0">{done}</span>' if display else done)
    raise nodes.SkipNode


def note_formulas(app, doctree):
    for node in doctree.findall(lambda n: isinstance(n, (nodes.math, nodes.math_block))):
        app.book.formulas[node.astext(), isinstance(node, nodes.math_block)] = app.env.docname


def typeset(app, env):
    """One run of KaTeX over all formulas; one that is refused is a warning."""
    todo = sorted(app.book.formulas)
    node = shutil.which("node") or shutil.which("nodejs") or "node"
    run = subprocess.run([node, HERE / "typeset.js"], input=json.dumps(todo), capture_output=True, encoding="utf-8", check=False)
    if run.returncode:
        say.warning(f"KaTeX: {run.stderr.strip()}")
    else:
        app.book.set = dict(zip(todo, json.loads(run.stdout)))


def link_includes(app, page, template, context, doctree):
    """Links from the includes of a page to theirs; and no script is a module, which a browser does not read from a folder."""
    for script in context.get("script_files", ()):
        if getattr(script, "attributes", {}).get("type") == "module":
            script.attributes.update(type="text/javascript", defer="defer")

    def include(m):
        found = app.book.by_include.get(unescape(m[1]))
        return f'<a class="id" href="{found.page}.html">{m[0]}</a>' if found else m[0]

    if page in app.book.by_page and "body" in context:
        context["body"] = re.sub(r'<span class="cpf">&quot;([^<]*?)&quot;</span>', include, context["body"])


def mend_theme(static):
    """Debian's furo takes a style sheet from a web server and a script as a module; a folder can be read with both inside."""
    for name, pattern, place in [("styles/furo.css", r"@import url\(/javascript/([^)]*)\);", Path("/usr/share/javascript")),
                                 ("scripts/furo.js", r'^import (?:\* as )?\w+ from "\./([\w-]+\.js)";', static / "scripts")]:
        text = ecsv.text_of(static / name)
        (static / name).write_text(re.sub(pattern, lambda m: ecsv.text_of(place / m[1]), text), encoding="utf-8")


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
                yield from [] if tag == "a" and target.startswith(("http", "mailto")) else [f"{name}: cannot follow {target[:60]}"]
            elif not (folder / target).exists() or place and target in texts and unescape(place) not in ids[target]:
                yield f"{name}: {address} leads nowhere"
    for path in sorted(folder.rglob("*.css")):
        for target in re.findall(r"url\(['\"]?(?!data:)([^)'\"]+)", ecsv.text_of(path)):
            yield from [] if (path.parent / target).exists() else [f"{path.name}: {target} is missing"]


# The extension


def prepare(app, config):
    """Writes the pages, before Sphinx looks for them."""
    try:
        app.book = Book(config.literate_root or HERE.parent, config.literate_build or HERE.parent / "build", app.srcdir)
        app.book.write()
    except ecsv.Fault as fault:
        raise ExtensionError(str(fault)) from None
    config.html_static_path = [str(HERE / "static"), str(app.book.pages / "static")]


def finish(app, error):
    if not error and app.builder.format == "html":
        app.book.copy(Path(app.outdir))
        mend_theme(Path(app.outdir) / "_static")
        if found := sorted(complaints(Path(app.outdir))):
            raise ExtensionError("\n  ".join([f"the book is not whole: {len(found)} complaints", *found[:40]]))


def setup(app):
    app.add_config_value("literate_root", "", "env")
    app.add_config_value("literate_build", "", "env")
    app.add_node(Number, html=(visit_number, None))
    app.add_directive("fig", Figure)
    app.add_transform(Bind)
    app.add_html_math_renderer("katex", (visit_math, None), (visit_math, None))
    for event, handler in [("config-inited", prepare), ("doctree-read", note_formulas),
                           ("env-updated", typeset), ("html-page-context", link_includes), ("build-finished", finish)]:
        app.connect(event, handler)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
