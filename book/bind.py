"""Binds what prose mentions to what made it: numbers, figures, equations, claims, headers, names."""

import html
import os
import re

import colour
import prose
from record import read_table
from source import BookError

EQUATIONS = re.compile(r"\bEqs?\.\s*\(\d+\)(?:(?:,|\s+and|\s+to|,\s+and)\s+\(\d+\))*")
FIGURE_WORD = re.compile(r"\b([Ff]igures?)\s+(x?\d\d?)\b(?:(,| and| to)\s+(x?\d\d?)\b)?")
HEADER = re.compile(r"\b((?:lattice/)?(?:\w+/)?\w+\.(?:hpp|cpp))\b")


def escape(text):
    return html.escape(str(text), quote=True)


def figure_id(text):
    """`7` and `07` are figure 07, `x1` is x01."""
    return f"x{int(text[1:]):02d}" if text.startswith("x") else f"{int(text):02d}"


def typeset_number(text):
    """`1.6e-11` as a reader wants it; other texts as they are."""
    text = re.sub(r"(?<![\w.])-(?=\d)", "−", text)
    return re.sub(r"(?<![\w.])(\d[\d.]*)e(-?)(\d+)\b",
                  lambda m: f"{'' if m[1] == '1' else m[1] + '·'}10<sup>{'−' if m[2] else ''}{m[3]}</sup>", text)


GREEK = {"pi": "π", "eps": "ε", "omega": "ω", "tau": "τ", "mu": "μ", "lambda": "λ", "beta": "β", "gamma": "γ",
         "delta": "δ", "Phi": "Φ", "Gamma": "Γ"}
SIGNS = {">=": "≥", "<=": "≤", "+-": "±", "->": "→", " - ": " − "}
WORDED = re.compile(r"\b(?P<base>[A-Za-z]+)_(?P<below>\([^)]*\)|[A-Za-z0-9]+)(?![\w.])|\^(?P<above>\([^)]*\)|-?[0-9/]+|[A-Za-z0-9]+)"
                    r"|\b(?P<greek>" + "|".join(GREEK) + r")\b|(?P<root>\bsqrt(?=\())|(?P<sign>>=|<=|\+-|->| - )"
                    r"|(?<![\w)])(?P<minus>-)(?=[A-Za-z(])")


def spelled(text):
    """What the list of claims writes for every reader, `E_PN for omega_b = 1.1`, as a page shows it."""
    def piece(m):
        if m["base"]:
            return f'{GREEK.get(m["base"], m["base"])}<sub>{worded(m["below"].strip("()"))}</sub>'
        if m["above"]:
            return f'<sup>{worded(m["above"].strip("()")).replace("-", "−")}</sup>'
        return GREEK[m["greek"]] if m["greek"] else "√" if m["root"] else "−" if m["minus"] else SIGNS[m["sign"]]

    def worded(text):
        out, done = [], 0
        for m in WORDED.finditer(text):
            out += [typeset_number(escape(text[done:m.start()])), piece(m)]
            done = m.end()
        return "".join(out) + typeset_number(escape(text[done:]))

    return worded(text)


def unit(text):
    """A unit of a table as a page shows it."""
    return escape({"um": "µm"}.get(text, text))


def agreement(tolerance):
    """A tolerance of paper/published.ecsv in words."""
    kind, _, size = tolerance.partition(" ")
    words = {"rel": "to a relative ", "abs": "to "}
    return typeset_number(words[kind] + size) if kind in words else escape(tolerance)


def broken(name):
    """A long name that may be broken behind a point, a slash or an underscore."""
    return re.sub(r"([_./])(?=\w)(?!ecsv)", r"\1<wbr>", escape(name))


def spoken(figure):
    """How a reader calls a figure."""
    return f"Figure {figure}" if figure.startswith("x") else f"Figure {int(figure)}"


def command_of(figure):
    return "make " + (figure if figure.startswith("x") else "fig" + figure)


class Binder:
    """Knows every target of the book. `page(source)` gives the state of one page."""

    def __init__(self, record, sources, images, live=False):
        self.record, self.images = record, images
        self.live = read_live(os.path.join(record.root, "book/live/figures.txt")) if live else {}
        self.by_path = {s.path: s for s in sources}
        self.by_name, self.definitions, twice = {}, {}, set()
        for s in sources:
            self.by_name.setdefault(s.name, []).append(s)
        from source import definitions
        for s in sources:
            for name, line in definitions(s.blocks).items() if s.room else ():
                if name in self.definitions:
                    twice.add(name)
                self.definitions[name] = (s, line)
        for name in twice:
            del self.definitions[name]
        table = read_table(os.path.join(record.root, "book/equations.ecsv"))
        for id in self.live:
            if id not in record.figures:
                raise BookError(f"book/live/figures.txt: there is no figure '{id}'")
        self.equations = {int(r["number"]): r for r in table.rows}
        self.labels = {r["label"]: f"Eq. ({r['number']})" for r in table.rows}
        self.figure_labels = {f["label"]: i for i, f in record.figures.items() if f["label"]}
        self.quoted = {}  # id -> pages that quote it
        self.shown = {}  # figure -> pages that show it
        self.cited = {}  # equation -> [(page, anchor)]

    def header(self, text, source=None):
        """The page of a header or chapter that is named in text; None where the name is not unique."""
        path = text if text.startswith("src/") else None
        candidates = [s for s in self.by_name.get(os.path.basename(text), [])
                      if "/" not in text or s.path.endswith("/" + text)]
        if path:
            candidates = [self.by_path[path]] if path in self.by_path else []
        if len(candidates) > 1 and source:
            near = [s for s in candidates if s.room == source.room
                    or s.path[len("src/"):] in source.includes]
            candidates = near if len(near) == 1 else []
        return candidates[0] if len(candidates) == 1 else None

    def where(self, text):
        """The article's place with its numbers instead of its labels."""
        text = re.sub(r"\bEqs?\. (\w+)", lambda m: self.labels.get(m[1], m[0]), text)
        def figures(m):
            names = [self.figure_labels.get(w) for w in re.split(r" and ", m[1])]
            return m[0] if None in names else "Fig. " + " and ".join(str(int(n)) for n in names)
        return re.sub(r"\bFigs?\.? (\w+(?: and \w+)?)(?= |$)", lambda m: figures(m) if figures(m) != m[0]
                      else re.sub(r"\bFig\. (\w+)", lambda k: "Fig. " + str(int(self.figure_labels[k[1]]))
                                  if k[1] in self.figure_labels else k[0], m[0]), text)

    # Records: what opens beside a number, a figure, an equation.

    def place_link(self, place):
        source = self.by_path[place.path]
        lines = f"line {place.first}" if place.first == place.last else f"lines {place.first} to {place.last}"
        return f'<a href="{source.page}#L{place.first}">{lines} of {place.path}</a>'

    def places(self, quote):
        out = []
        for place in quote.places:
            lines = place.text.split("\n")
            indent = min(len(l) - len(l.lstrip()) for l in lines if l.strip())
            code = "\n".join(l[indent:] for l in lines)
            out.append(f"{self.place_link(place)}<pre><code>{colour.coloured(code)}</code></pre>")
        return "".join(out)

    def value(self, quote):
        f = quote.finding
        if f.unit == "claim":
            return f.shown
        shown, error = typeset_number(f.shown), typeset_number(f.shown_error)
        size = " " + unit(f.unit) if f.unit else ""
        if f.kind == "residue":
            return f"{shown}{size} (made of rounding: only its size counts)"
        if f.error == 0:
            return f"{shown}{size}, exact"
        return f"{shown} ± {error}{size}"

    def verdict(self, claim):
        return f'<span class="verdict {claim["status"]}">{claim["status"]}</span>'

    def data_link(self, program, table):
        name = f"data/{program}/{table}.ecsv"
        if not os.path.exists(os.path.join(self.record.data, program, table + ".ecsv")):
            return f"<code>build/{name}</code>"
        return f'<a href="{name}" download>{broken(f"{program}/{table}.ecsv")}</a>'

    def number_record(self, quote):
        f, claim, rows = quote.finding, quote.claim, []
        rows.append(("here", self.value(quote)))
        if claim:
            printed = spelled(claim["printed"]) + (" " + unit(claim["unit"]) if claim["unit"] else "")
            place = escape(self.where(claim["where"]))
            rows.append(("article", f"{printed or 'a statement'} <small>({place})</small>"))
            if claim["tolerance"]:
                rows.append(("agreement", f"asked for: {agreement(claim['tolerance'])}"))
            rows.append(("verdict", f'{self.verdict(claim)} <a href="published.html#{f.id}">in the table</a>'))
            if claim["reason"]:
                rows.append(("why", spelled(claim["reason"])))
        rows.append(("computed by", self.places(quote)))
        row = f", row {quote.row}" if quote.row else ""
        rows.append(("stored in", f"{self.data_link(f.program, quote.table)}{row}"))
        if quote.id in self.record.alone:
            command, quantity = self.record.alone[quote.id]
            rows.append(("alone", f"<code>{escape(command)}</code> prints it as <code>{escape(quantity)}</code>"))
        cost = self.record.cost(f.program)
        rows.append(("command", f"<code>{self.record.command(f.program)}</code>"
                     + (f" ({cost} on two cores)" if cost else "")))
        title = spelled(claim["quantity"]) if claim else escape(f.id.replace("_", " "))
        where = f"published.html#{f.id}" if claim else f"numbers.html#{quote.id}"
        return (f'<h3>{title} <a href="{where}"><code>{broken(quote.id)}</code></a></h3>' + facts(rows))

    def figure_record(self, id):
        return f"<h3>{spoken(id)}</h3>" + facts(self.figure_facts(id))

    def figure_facts(self, id):
        figure = self.record.figures[id]
        program = figure["program"]
        tables = ", ".join(self.data_link(program, t) for t in figure["data"].split())
        chapter = self.by_path[f"src/{program}.cpp"]
        rows = [("command", f"<code>{command_of(id)}</code>"),
                ("script", f'<a href="fig-{id}.html#script">figures/{figure["script"]}</a>'),
                ("tables" if " " in figure["data"] else "table", tables),
                ("program", f'<a href="{chapter.page}">{program}</a>: <code>{self.record.command(program)}</code>')]
        if self.record.cost(program):
            rows.append(("cost", f"{self.record.cost(program)} of computing on two cores"))
        return rows

    def image(self, id, note=""):
        name, width, height, _ = self.images[id]
        alt = escape(self.record.figures[id]["caption"])
        return f'<img src="figures/{name}.svg" alt="{alt}" width="{width}" height="{height}"{note}>'

    def live_buttons(self, id):
        buttons = "".join(f' <a class="button live" href="{escape(address)}">{escape(words)}</a>'
                          for words, address in self.live.get(id, []))
        return f'<span class="nowprint">{buttons}</span>' if buttons else ""

    def equation_record(self, number):
        e = self.equations[number]
        return (f'<h3><a href="equations.html#eq-{number}">Eq. ({number})</a> of the article: {escape(e["name"])}</h3>'
                f'<span class="math display">\\[{html.escape(e["tex"], quote=False)}\\]</span>')


def read_live(path):
    """Figures that can be computed in the page: [(words, address)] by id."""
    out = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                id, _, rest = line.strip().partition(" ")
                words, page, parameters = rest.split("|")
                out.setdefault(id, []).append((words, f"{page}.html?{parameters}"))
    return out


def facts(rows):
    return '<dl class="facts">' + "".join(f"<dt>{k}</dt><dd>{v}</dd>" for k, v in rows) + "</dl>"


def preamble(lines):
    """How many lines at the start of a block only say what is needed: includes and namespaces."""
    count = 0
    while count < len(lines) and re.match(r"#\w+|using namespace|namespace \w+ \{$|\s*$", lines[count]):
        count += 1
    return count if count > 3 else 0


def folded(page):
    return f'<details class="block"><summary>What this file includes</summary>{page}</details>'


class PageBinding:
    """The links of one page: collects the records that the page must carry and its headings."""

    def __init__(self, binder, source=None, page=None):
        self.binder, self.source = binder, source
        self.page = page or source.page
        self.records, self.headings, self.ids, self.figures = {}, [], set(), []
        self.anchor, self.named = "", set()
        text = source.text if source else ""
        self.local = set(re.findall(r"\b(?:auto|double|int|bool|size_t|string)&? (\w+)\b", text))
        if source:
            from source import definitions
            self.local |= set(definitions(source.blocks)) if not source.room else set()

    def need(self, kind, id, make):
        key = f"{kind}-{id}"
        if key not in self.records:
            self.records[key] = None  # keeps the order of first mention
            self.records[key] = make(id)
        return key

    def number(self, id, text):
        record = self.binder.record
        quote = record.quote(id)
        self.binder.quoted.setdefault(id, [])
        if (self.page, self.anchor) not in self.binder.quoted[id]:
            self.binder.quoted[id].append((self.page, self.anchor))
        if not quote.places:
            raise BookError(f"{self.page}: no line writes '{id}'")
        key = self.need("number", id, lambda _: self.binder.number_record(quote))
        return f'<button type="button" class="num" popovertarget="{key}">{typeset_number(text or quote.finding.shown)}</button>'

    def equation(self, number):
        if number not in self.binder.equations:
            raise BookError(f"{self.page}: the article has no Eq. ({number})")
        cited = self.binder.cited.setdefault(number, [])
        if not any(page == self.page for page, _ in cited):
            cited.append((self.page, self.anchor))
        key = self.need("equation", number, self.binder.equation_record)
        return f'<button type="button" class="eq" popovertarget="{key}">({number})</button>'

    def figure(self, id, caption):
        binder = self.binder
        if id not in binder.record.figures:
            raise BookError(f"{self.page}: there is no figure '{id}'")
        if self.page not in binder.shown.setdefault(id, []):
            binder.shown[id].append(self.page)
        anchor = f' id="fig-{id}"' if id not in self.figures else ""
        self.figures.append(id)
        key = self.need("figure", id, binder.figure_record)
        return (f'<figure{anchor}><a href="fig-{id}.html">{binder.image(id)}</a><figcaption><b>{spoken(id)}.</b> {caption} '
                f'<button type="button" class="made" popovertarget="{key}">How it was made</button>'
                f'{binder.live_buttons(id)}</figcaption></figure>')

    def heading(self, level, inner):
        title = prose.plain(inner)
        anchor = base = prose.slug(title)
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
        if f"src/{word}.cpp" in binder.by_path:
            return binder.by_path[f"src/{word}.cpp"].page
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
            known = [n for n in (first, second) if n and figure_id(n) in self.binder.record.figures]
            if not known or word.startswith("f") and len(first.lstrip("x")) > 2:
                return match[0]
            links = {n: f'<a href="fig-{figure_id(n)}.html">{n}</a>' for n in known}
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
        for left in re.findall(r'"((?:num|fig):[^"]*)"', page):
            raise BookError(f"{self.page}: '{left}' stands where it cannot be bound")
        page = re.sub(r"<table>", '<div class="scroll" tabindex="0"><table>', page).replace("</table>", "</table></div>")
        page = re.sub(r"<pre>", '<pre tabindex="0">', page)
        return prose.on_text(page, self.text)

    # Names in code

    def code(self, block):
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
            found = self.binder.by_path.get("src/" + path) or self.binder.header(path, self.source)
            return found.page if found else None

        def quiet(page):
            """The tabulator key stops at a name once a page, not at each of its hundred uses."""
            def once(match):
                first = match[1] not in self.named
                self.named.add(match[1])
                return match[0] if first else match[0][:-1] + ' tabindex="-1">'
            return re.sub(r'<a class="id" href="([^"]+)">', once, page)

        count = preamble(block.lines)
        parts = []
        if count:
            head = "\n".join(block.lines[:count]).rstrip()
            parts.append(folded(colour.numbered(head, block.first, "cpp", link, include)))
        while count < len(block.lines) and not block.lines[count].strip():
            count += 1
        if count < len(block.lines):
            rest = "\n".join(block.lines[count:])
            parts.append(quiet(colour.numbered(rest, block.first + count, "cpp", link, include)))
        return "".join(parts)

    def records_html(self):
        if not self.records:
            return ""
        panels = "".join(
            f'<div popover id="{key}"><button type="button" class="close" popovertarget="{key}" '
            f'popovertargetaction="hide" aria-label="Close">×</button>{body}</div>'
            for key, body in self.records.items())
        return f'<section class="records"><h2>Numbers, equations and figures of this page</h2>{panels}</section>'
