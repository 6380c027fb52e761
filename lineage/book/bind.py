"""Binds what prose mentions to what made it: numbers, figures, equations, claims, headers, names."""

import html
import re
from pathlib import Path

from markupsafe import Markup

from .. import ecsv
from ..ecsv import Fault
from . import code, prose
from .source import definitions
from .words import short_figure

EQUATIONS = re.compile(r"\bEqs?\.\s*\(\d+\)(?:(?:,|\s+and|\s+to|,\s+and)\s+\(\d+\))*")
FIGURE_WORD = re.compile(r"\b([Ff]igures?)\s+(x?\d\d?)\b(?:(,| and| to)\s+(x?\d\d?)\b)?")
HEADER = re.compile(r"\b((?:lattice/)?(?:\w+/)?\w+\.(?:hpp|cpp))\b")


def figure_id(text):
    """`7` and `07` are figure 07, `x1` is x01."""
    return f"x{int(text[1:]):02d}" if text.startswith("x") else f"{int(text):02d}"


class Binder:
    """Knows every target of the book."""

    parts = None  # the macros of book/templates/parts.html, which ask this object

    def __init__(self, record, sources, images, live):
        self.record, self.images, self.live = record, images, live
        self.by_path, self.by_include = {s.path: s for s in sources}, {s.included: s for s in sources}
        self.by_name, self.definitions, twice = {}, {}, set()
        for s in sources:
            self.by_name.setdefault(s.name, []).append(s)
            for name, line in definitions(s.blocks).items() if s.is_header else ():
                if name in self.definitions:
                    twice.add(name)
                self.definitions[name] = (s, line)
        for name in twice:
            del self.definitions[name]
        for id in self.live:
            if id not in record.figures:
                raise Fault(f"book/live/figures.txt: there is no figure '{id}'")
        table = ecsv.read(record.root / "book/equations.ecsv", ("number", "label", "name", "tex"))
        self.equations = {int(r["number"]): r for r in table.rows}
        self.labels = {r["label"]: f"Eq. ({r['number']})" for r in table.rows}
        self.figure_labels = {f["label"]: i for i, f in record.figures.items() if f["label"]}
        self.quoted = {}  # id -> places that quote it
        self.shown = {}  # figure -> pages that show it
        self.cited = {}  # equation -> page -> first anchor

    def header(self, text, source=None):
        """The page of a header or chapter that is named in text; None where the name is not unique."""
        if text.startswith(("src/", "beyond/src/")):
            return self.by_path.get(text)
        candidates = [s for s in self.by_name.get(Path(text).name, []) if "/" not in text or s.path.endswith("/" + text)]
        if len(candidates) > 1 and source:
            candidates = [s for s in candidates if s.module == source.module or s.included in source.includes]
        return candidates[0] if len(candidates) == 1 else None

    def where(self, text):
        """The article's place with its numbers instead of its labels."""
        def figure(m):
            names = m[1].split(" and ")
            if all(n in self.figure_labels for n in names):
                return "Fig. " + " and ".join(short_figure(self.figure_labels[n]) for n in names)
            first = self.figure_labels.get(names[0])
            return f"Fig. {short_figure(first)}{m[1][len(names[0]):]}" if first else m[0]

        text = re.sub(r"\bEqs?\. (\w+)", lambda m: self.labels.get(m[1], m[0]), text)
        return re.sub(r"\bFigs?\.? (\w+(?: and \w+)?)(?= |$)", figure, text)

    # What opens beside a number, a figure, an equation is a macro of parts.html that asks for these.

    def page_of(self, place):
        return f"{self.by_path[place.path].page}#L{place.first}"

    def snippet(self, place):
        lines = place.text.split("\n")
        indent = min(len(l) - len(l.lstrip()) for l in lines if l.strip())
        return code.coloured("\n".join(l[indent:] for l in lines))

    def has_table(self, program, table):
        return self.record.table_path(program, table).exists()

    def row_of(self, name):
        """Where a list has this number."""
        return f"{'published' if name in self.record.claims else 'numbers'}.html#{name}"

    def chapter(self, program):
        return self.by_include.get(f"{program}.cpp")


def read_live(path):
    """Figures that can be computed in the page: [(words, address)] by id."""
    out = {}
    for line in ecsv.text_of(path).splitlines():
        if line.strip() and not line.startswith("#"):
            id, _, rest = line.strip().partition(" ")
            words, page, parameters = rest.split("|")
            out.setdefault(id, []).append((words, f"{page}.html?{parameters}"))
    return out


def preamble(lines):
    """How many lines at the start of a block only say what is needed: includes and namespaces."""
    count = 0
    while count < len(lines) and re.match(r"#\w+|using namespace|namespace \w+ \{$|\s*$", lines[count]):
        count += 1
    return count if count > 3 else 0


def drawn(found):
    """A drawing of letters with the number of its columns, by which the style makes it fit a narrow screen."""
    columns = max(len(html.unescape(re.sub(r"<[^>]+>", "", line))) for line in found[2].split("\n"))
    return f'<pre tabindex="0" style="--columns: {max(columns, 1)}">{found[1] or ""}{found[2]}</pre>'


def folded(page, summary="What this file includes"):
    return f'<details class="block"><summary>{summary}</summary>{page}</details>'


FILLS = re.compile(r"\w[\w:<>,&* ]*[ &*](report_\w+)\(")


def pieces(lines):
    """The pieces of a listing, [from, until, names]: `names` are functions that only fill tables, `report_...`, which are
    folded with the remarks above them, and is empty where the code is shown; neighbours are one piece."""
    out, at = [], 0
    while at < len(lines):
        end, names = at, []
        while end < len(lines) and (not lines[end].strip() or lines[end].startswith("//")):
            end += 1
        if end < len(lines) and (found := FILLS.match(lines[end])):
            names = [found[1]]
            while end < len(lines) and not lines[end].startswith("}"):
                end += 1
        end = min(end + 1, len(lines))
        if out and bool(out[-1][2]) == bool(names):
            out[-1][1:] = [end, out[-1][2] + names]
        else:
            out.append([at, end, names])
        at = end
    return out


class PageBinding:
    """The links of one page: collects the records that the page must carry and its headings."""

    def __init__(self, binder, source=None, page=None):
        self.binder, self.source = binder, source
        self.page = page or source.page
        self.records, self.headings, self.ids, self.figures = {}, [], set(), []
        self.anchor, self.named = "", set()
        text = source.text if source else ""
        self.local = set(re.findall(r"\b(?:auto|double|int|bool|size_t|string)&? (\w+)\b", text))
        if source and not source.is_header:
            self.local |= set(definitions(source.blocks))

    def need(self, kind, id, make):
        key = f"{kind}-{id}"
        if key not in self.records:
            self.records[key] = None  # keeps the order of first mention
            self.records[key] = make(id)
        return key

    def note(self, where, id):
        """Remembers that this place speaks of it."""
        where.setdefault(id, {})[self.page, self.anchor] = True

    def number(self, id, text):
        quote = self.binder.record.quote(id)
        self.note(self.binder.quoted, id)
        if not quote.places:
            raise Fault(f"{self.page}: no line writes '{id}'")
        key = self.need("number", id, lambda _: self.binder.parts.number_record(quote))
        return str(self.binder.parts.number(key, Markup(text) if text else quote.finding.shown))

    def equation(self, number):
        if number not in self.binder.equations:
            raise Fault(f"{self.page}: the article has no Eq. ({number})")
        self.binder.cited.setdefault(number, {}).setdefault(self.page, self.anchor)
        key = self.need("equation", number, self.binder.parts.equation_record)
        return str(self.binder.parts.equation(key, number))

    def figure(self, id, caption):
        binder = self.binder
        if id not in binder.record.figures:
            raise Fault(f"{self.page}: there is no figure '{id}'")
        binder.shown.setdefault(id, {})[self.page] = True
        first, self.figures = id not in self.figures, self.figures + [id]
        key = self.need("figure", id, binder.parts.figure_record)
        return str(binder.parts.figure(id, Markup(caption), key, first))

    def finding(self, id, kind):
        """The kind of evidence behind the sentence of a finding, which leads to its row."""
        self.note(self.binder.quoted, id)
        return f'<a class="evidence {kind}" href="findings.html#{id}">{kind}</a>'

    def carried(self):
        """The records that open on the page."""
        return self.binder.parts.records({key: Markup(body) for key, body in self.records.items()})

    def heading(self, level, inner):
        anchor = base = prose.slug(prose.plain(inner))
        n = 2
        while anchor in self.ids:
            anchor, n = f"{base}-{n}", n + 1
        self.ids.add(anchor)
        self.headings.append((level, re.sub(r"<(?!/?span)[^>]*>", "", inner), anchor))
        if level == 1:
            return f'<h1 id="{anchor}">{inner}</h1>'
        return (f'<h{level} id="{anchor}">{inner}<a class="anchor" href="#{anchor}" '
                f'aria-label="Link to this section">#</a></h{level}>')

    # Names in text

    def linked_word(self, text):
        """What a piece of code in prose refers to: a claim, a program, a header or a definition."""
        word, binder = html.unescape(text), self.binder
        if word in binder.record.claims:
            return f"published.html#{word}"
        if chapter := binder.chapter(word):
            return chapter.page
        if HEADER.fullmatch(word):
            found = binder.header(word, self.source)
            return found.page if found and found is not self.source else None
        clear = word[:1].isupper() or ("_" in word and len(word) > 6) or word.endswith("()")
        word = word.removesuffix("()")
        if clear and word in binder.definitions and word not in self.local:
            found, line = binder.definitions[word]
            return f"{found.page}#L{line}"
        return None

    def text(self, text, tags):
        if {"a", "b", "button", "pre", "h1", "h2", "h3", "h4"} & set(tags):
            return text
        if "code" in tags:
            target = self.linked_word(text)
            return f'<a href="{target}">{text}</a>' if target else text

        def equations(match):
            return re.sub(r"\((\d+)\)", lambda m: self.equation(int(m[1])), match[0])

        def figures(match):
            word, first, joint, second = match.groups()
            links = {n: f'<a href="fig-{figure_id(n)}.html">{n}</a>' for n in (first, second)
                     if n and figure_id(n) in self.binder.record.figures}
            return f"{word} {links.get(first, first)}" + (f"{joint} {links.get(second, second)}" if second else "")

        def headers(match):
            found = self.binder.header(match[1], self.source)
            return f'<a href="{found.page}">{match[0]}</a>' if found and found is not self.source else match[0]

        text = EQUATIONS.sub(equations, text)
        pieces = re.split(r"(<[^>]+>)", text)
        for i in range(0, len(pieces), 2):
            pieces[i] = HEADER.sub(headers, FIGURE_WORD.sub(figures, pieces[i]))
        return "".join(pieces)

    def prose(self, page):
        """The HTML of a block of prose with everything bound."""
        page = re.sub(r'<figure>\s*<img src="fig:([^"]*)"[^>]*>\s*<figcaption[^>]*>(.*?)</figcaption>\s*</figure>',
                      lambda m: self.figure(m[1], m[2]), page, flags=re.S)
        page = re.sub(r"<h([1-6])>(.*?)</h\1>", lambda m: self.heading(int(m[1]), m[2]), page, flags=re.S)
        page = re.sub(r'<a href="num:([^"]*)">(.*?)</a>', lambda m: self.number(m[1], m[2]), page, flags=re.S)
        page = re.sub(r'<a href="finding:([^"]*)">(.*?)</a>', lambda m: self.finding(m[1], m[2]), page, flags=re.S)
        if left := re.search(r'"((?:num|fig|finding):[^"]*)"', page):
            raise Fault(f"{self.page}: '{left[1]}' stands where it cannot be bound")
        page = re.sub(r"<table>", '<div class="scroll" tabindex="0"><table>', page).replace("</table>", "</table></div>")
        page = re.sub(r"<pre>(<code>)?(.*?)</pre>", drawn, page, flags=re.S)
        return prose.on_text(page, self.text)

    # Names in code

    def listing(self, block):
        text = block.text

        def link(name):
            if name not in self.binder.definitions or name in self.local or len(name) < 3:
                return None
            found, line = self.binder.definitions[name]
            if found is self.source:
                return None
            called = re.search(rf"\b{name}\b\s*[(<{{]", text)
            if not (name[0].isupper() or called or ("_" in name and len(name) > 6)):
                return None
            return f"{found.page}#L{line}"

        def include(path):
            found = self.binder.by_include.get(path) or self.binder.header(path, self.source)
            return found.page if found else None

        def quiet(page):
            """The tabulator key stops at a name once a page, not at each of its hundred uses."""
            def once(match):
                first = match[1] not in self.named
                self.named.add(match[1])
                return match[0] if first else match[0][:-1] + ' tabindex="-1">'
            return re.sub(r'<a class="id" href="([^"]+)">', once, page)

        count, parts = preamble(block.lines), []
        if count:
            head = "\n".join(block.lines[:count]).rstrip()
            parts.append(folded(code.numbered(head, block.first, "cpp", link, include)))
        while count < len(block.lines) and not block.lines[count].strip():
            count += 1
        for start, end, names in pieces(block.lines[count:]):
            lines, first = block.lines[count + start:count + end], block.first + count + start
            while not lines[0].strip():
                lines, first = lines[1:], first + 1
            page = quiet(code.numbered("\n".join(lines).rstrip(), first, "cpp", link, include))
            parts.append(folded(page, f"How the tables are filled: {', '.join(names)}") if names else page)
        return "".join(parts)
