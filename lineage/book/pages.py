"""The pages of the book: chapters, headers, figures, and what is listed, by the templates in book/templates."""

import json
import re

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape

from .. import ecsv
from ..claims import SAID, VERDICTS
from ..findings import KINDS, in_plain, margins
from ..literature import OBTAINED
from ..refresh import command_of
from ..volumes import volumes
from . import code, notebooks, prose, words
from .bind import PageBinding
from .source import modules_of

LISTS = {"published.html": "Published against reproduced", "findings.html": "What we found", "numbers.html": "All other numbers",
         "equations.html": "Equations of the article", "figures.html": "All figures", "tables.html": "All tables and columns",
         "commands.html": "All commands", "packages.html": "Packages used"}
ENDS = {"answers": "Statements answered here", "literature": "Numbers of other authors"}
LIVE = [("strike", "Strike the chain"), ("breather", "Find a breather"), ("defect", "Put a defect in the way"),
        ("drive", "Drive the array")]


def live_in(folders):
    """The live pages of these volumes: their folder, name and title."""
    return [(folder / "book/live", name, title) for name, title in LIVE for folder in folders
            if (folder / f"book/live/{name}.cpp").exists()]


class Book:
    def __init__(self, record, binder, parts, modules, inventory):
        chapters = [s for _, sources in parts for s in sources]
        self.record, self.inventory, self.binder, self.chapters, self.modules = record, inventory, binder, chapters, modules
        self.order = chapters + [s for module in modules.values() for s in module]
        self.titles = {s.page: s.title for s in self.order}
        self.statuses = [c["status"] for c in record.claims.values()]
        self.included_by, self.search = {}, []
        for s in self.order:
            for i in s.includes:
                self.included_by.setdefault(i, []).append(s)
        self.env = Environment(loader=FileSystemLoader([v / "book/templates" for v in volumes(prose.ASSETS.parent)]), autoescape=True, trim_blocks=True,
                               undefined=StrictUndefined, keep_trailing_newline=False)
        self.env.filters.update({f.__name__: f for f in (words.number, words.short, words.spelled, words.unit, words.broken, words.value,
                                                         words.agreement, words.spoken, words.short_figure, command_of)})
        self.notebooks = notebooks.read(record.root)
        self.titles.update({page: title for page, title, *_ in self.notebooks})
        lists = [*LISTS.items()] + [(f"{page}.html", f"{title} (live)") for _, page, title in live_in(record.volumes) if binder.live]
        lists += [(page, f"{title} (Python)") for page, title, *_ in self.notebooks]
        self.env.globals.update(record=record, inventory=inventory, book=binder, parts_of_book=parts, modules=modules, titles=self.titles, lists=lists,
                                verdicts=VERDICTS, said=SAID, statuses=self.statuses)
        binder.parts = self.parts = self.env.get_template("parts.html").module

    # The frame

    def render(self, template, **given):
        return Markup(self.env.get_template(template + ".html").render(given))

    def page(self, name, title, body, headings=(), before=None, after=None):
        sections = [(level, Markup(heading), anchor) for level, heading, anchor in headings if level == 2]
        return str(self.render("base", name=name, title=title, body=body, sections=sections, before=before, after=after))

    def note(self, page, anchor, title, section, html):
        """A piece of text that the search finds."""
        html = re.sub(r'<button type="button" class="made".*?</button>|<pre.*?</pre>', "", str(html), flags=re.S)
        text = prose.plain(html)
        if text:
            self.search.append([f"{page}#{anchor}" if anchor else page, title, section, text])

    def note_sections(self, page, title, html):
        """Text by headings, without code blocks of the program."""
        pieces = re.split(r'<h[1-6] id="([^"]+)">(.*?)</h[1-6]>', html, flags=re.S)
        self.note(page, "", title, title, pieces[0])
        for anchor, heading, text in zip(pieces[1::3], pieces[2::3], pieces[3::3]):
            heading = re.sub(r'<a class="anchor".*?</a>', "", heading)
            self.note(page, anchor, title, prose.plain(heading), text)

    # Chapters and headers

    def card(self, source, program):
        """What stands below the title."""
        halves = [s for s in self.order if s.module and s.module == source.module and s.stem == source.stem and s is not source]
        return self.render("card", source=source, program=program, halves=halves,
                           needs=[s for s in map(self.binder.by_include.get, source.includes)
                                  if s and s not in halves],
                           users=[s for s in self.included_by.get(source.included, []) if s not in halves],
                           figures=[i for i, f in self.record.figures.items() if f["program"] == program],
                           count=len(self.claims_of(program)))

    def claims_of(self, program):
        return [c for c in self.record.claims.values() if program and c["program"] == program]

    def program_of(self, source):
        """A chapter's program."""
        return "" if source.module else source.stem

    def end_of(self, source, binding):
        """Figures that the prose of a chapter does not show, and its answers."""
        left = [i for i, f in self.record.figures.items() if f["program"] == source.stem and i not in self.binder.shown]
        further = [Markup(binding.figure(i, str(escape(self.record.figures[i]["caption"])))) for i in left]
        return self.render("chapter", further=further, claims=self.claims_of(source.stem), obtained=OBTAINED,
                           literature=[one for one in self.record.literature if one[0]["program"] == source.stem])

    def source_pages(self, bodies):
        out = {}
        for i, source in enumerate(self.order):
            binding, parts = bodies[source.path]
            card = str(self.card(source, self.program_of(source)))
            parts[0] = re.sub(r"(</h1>)", lambda m: m[0] + card, parts[0], count=1)
            self.note_sections(source.page, source.title, "".join(p for p in parts if p.startswith('<div class="prose"')))
            self.note_definitions(source)
            self.note_file(source)
            headings, end = list(binding.headings), ""
            if not source.module:
                end = self.end_of(source, binding)
                headings += [(2, name, anchor) for anchor, name in ENDS.items() if f'id="{anchor}"' in end]
            out[source.page] = self.page(source.page, source.title, Markup("\n".join(parts)) + end + binding.carried(), headings,
                                         self.order[i - 1] if i else None, self.order[i + 1] if i + 1 < len(self.order) else None)
        return out

    def note_definitions(self, source):
        """Names that a header defines, for the search, with the remark before them."""
        lines = source.text.split("\n")
        for name, (owner, line) in self.binder.definitions.items():
            if owner is source:
                first = line - 1
                while first > 0 and re.match(r"\s*(///|template)", lines[first - 1]):
                    first -= 1
                remark = " ".join(re.sub(r"^\s*///?\s*", "", l) for l in lines[first:line])
                self.search.append([f"{source.page}#L{line}", source.title, name, remark])

    def note_file(self, source):
        """The file's name and the options that it declares, for the search."""
        program = self.program_of(source)
        self.search.append([source.page, source.title, source.path, f"the program build/bin/{program}" if program else "the library"])
        for found in re.finditer(r'\b\w+\.add\("([a-z][a-z0-9-]*)",\s*[\w.]+,\s*"([^"]*)"', source.text):
            line = source.text.count("\n", 0, found.start()) + 1
            self.search.append([f"{source.page}#L{line}", source.title, f"--{found[1]}", f"{found[2]}, an option of {program or 'all programs'}"])

    # Lists, figures, the pages that compute

    def lists(self):
        for id, c in self.record.claims.items():
            self.note("published.html", id, LISTS["published.html"], id,
                      escape(f'{c["quantity"]}; {c["printed"]}; {c["status"]} {c["reading"]} {c["reason"]}'))
        for number, e in self.binder.equations.items():
            self.note("equations.html", f"eq-{number}", LISTS["equations.html"], f"Eq. ({number})", escape(e["name"]))
        for row in self.inventory["commands"]:
            if row["command"] and not row["option"]:
                name = f'{row["program"]} {row["command"]}'
                self.note("commands.html", name.replace(" ", "-"), LISTS["commands.html"], name, escape(row["description"]))
        return {name: self.page(name, title, self.render(name.removesuffix(".html"))) for name, title in LISTS.items()
                if name != "findings.html"}

    FOUND = ("sentence", "range", "tried", "second")

    def findings_page(self, html):
        """Every finding with its evidence; `html` has the texts of all rows in turn."""
        binding, rows = PageBinding(self.binder, page="findings.html"), []
        for i, (id, row) in enumerate(self.record.findings.items()):
            binding.anchor = id
            said, *further = [binding.prose(re.sub(r"^<p>(.*)</p>$", r"\1", text, flags=re.S))
                              for text in html[len(self.FOUND) * i:len(self.FOUND) * (i + 1)]]
            told = list(map(Markup, [said, *map(spelled_out, further)]))
            self.note("findings.html", id, LISTS["findings.html"], id, told[0])
            rows.append((id, row["kind"], dict(zip(self.FOUND, told)), list(margins(row, self.record.quotable))))
        body = self.render("findings", rows=rows, kinds=KINDS)
        return self.page("findings.html", LISTS["findings.html"], body + binding.carried())

    def captions(self):
        """Whole captions by figure: the first sentence, and what the report says after it."""
        further = {id: said for id, said in self.record.captions.items() if id in self.record.figures}
        pages = dict(zip(further, prose.to_html([prose.from_tex(said) for said in further.values()])))
        out = {}
        for id, figure in self.record.figures.items():
            said = re.sub(r"</?p>", "", pages.get(id, ""))
            said = re.sub(r"\bFig\. (x?\d\d)\b",
                          lambda m: f'<a href="fig-{m[1]}.html">Fig. {words.short_figure(m[1])}</a>', said)
            out[id] = escape(figure["caption"]) + Markup(" " + said if said else "")
        return out

    def figure_page(self, id, caption):
        figure = self.record.figures[id]
        script = ecsv.text_of(self.record.root / "figures" / figure["script"]).rstrip("\n")
        tables = [(name, ecsv.read_written(self.record.table_path(figure["program"], name))) for name in figure["data"].split()
                  if self.binder.has_table(figure["program"], name)]
        self.note(f"fig-{id}.html", "", LISTS["figures.html"], words.spoken(id),
                  caption + escape(f' Drawn by figures/{figure["script"]} from {figure["program"]}: {figure["data"]}'))
        language = "python" if figure["script"].endswith(".py") else "gnuplot"
        return self.page(f"fig-{id}.html", words.spoken(id), self.render(
            "figure", id=id, caption=caption, tables=tables, script=Markup(code.numbered(script, 1, language))))

    def live_pages(self):
        out = {}
        for _, name, title in live_in(self.record.volumes) if self.binder.live else ():
            body = self.render(name)
            self.note(name + ".html", "", title, title, body)
            out[name + ".html"] = self.page(name + ".html", title, body)
        return out

    def notebook_pages(self):
        out = {}
        for name, title, *rest in self.notebooks:
            body, binding = notebooks.page(self, name, *rest)
            self.note_sections(name, title, str(body))
            out[name] = self.page(name, title, body + binding.carried(), binding.headings)
        return out

    # Start and search

    def start(self, text):
        binding = PageBinding(self.binder, page="index.html")
        binding.anchor = "main"
        said = Markup(binding.prose(text))
        live = self.binder.live and Markup(binding.figure("21", str(escape(self.record.figures["21"]["caption"]))))
        body = self.render("index", words=said, invitation=live, lives=[name for _, name, _ in live_in(self.record.volumes)], findings=self.findings(), ideas=modules_of(self.record.root),
                           summaries={s.path: self.summary(s) for s in self.chapters})
        return self.page("index.html", "", body + binding.carried(), after=self.chapters[0])

    def findings(self):
        """The findings that have a figure: its id, and the sentence in words and formulas."""
        numbers = {id: f.shown for id, f in self.record.quotable.items()}
        return [(row["figure"], formulas(in_plain(row["sentence"], numbers))) for row in self.record.findings.values()
                if row["figure"] in self.record.figures]

    def summary(self, source):
        """The first sentences of a chapter."""
        for block in source.blocks:
            if block.kind == "prose":
                for part in re.split(r"\n\s*\n", block.text):
                    said = part.strip()
                    if said and not said.startswith(("#", "!", "|", "-")) and not part.startswith("    "):
                        return formulas(beginning(said))
        return ""

    def assemble(self, bodies):
        """All files that are text, by name."""
        told = [row[column] for row in self.record.findings.values() for column in self.FOUND]
        start, *told = prose.to_html([ecsv.text_of(self.record.root / "book/start.md"), *told])
        out = {}
        pages = self.source_pages(bodies) | self.notebook_pages()
        out["index.html"] = self.start(start)
        out["findings.html"] = self.findings_page(told)
        out.update(pages | self.lists())
        out.update({f"fig-{id}.html": self.figure_page(id, said) for id, said in self.captions().items()})
        out.update(self.live_pages())
        out["search.html"] = self.page("search.html", "Search", self.render("search"))
        rows = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in self.search)
        out["search-index.js"] = f"window.SEARCH = [\n{rows}\n];\n"
        return out


def spelled_out(page):
    """HTML in which words such as `omega_b = 1.1` and 1e-9 are spelled as the lists spell them."""
    return prose.on_text(page, lambda text, tags: text if {"code", "button"} & set(tags)
                         else str(words.spelled(Markup(text).unescape())))


def formulas(text):
    """Words with numbers and TeX between dollars, as the page sets them."""
    pieces = text.split("$")
    pieces[::2] = [words.number(piece) for piece in pieces[::2]]
    pieces[1::2] = [Markup('<span class="math inline">\\({}\\)</span>').format(tex) for tex in pieces[1::2]]
    return Markup("").join(pieces)


def beginning(paragraph):
    """The first sentences of a paragraph of Markdown, without marks, links and names of statements."""
    text = re.sub(r"\s*\((?:`[a-z0-9_.]+`(?:,? and |,\s)?)+[^)]*\)", "", re.sub(r"\s+", " ", paragraph.replace("$$", "$")))
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"(\$[^$]*\$)|[*`]", r"\1", re.sub(r":$", ".", text)))
    out = ""
    for sentence in re.split(r"(?<=[.?!]) (?=[A-Z])", text):
        if len(out) > 150 and not out.count("$") % 2:
            break
        out += " " + sentence
    return out.strip()
