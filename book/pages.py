"""The pages of the book: chapters, headers, figures, and what is listed."""

import json
import os
import re

import colour
import prose
from bind import PageBinding, broken, command_of, escape, facts, spelled, spoken, typeset_number, unit
from record import read_table

BOOK = "Breathers with Hertzian contacts"
ROOM_IDEAS = {
    "numbers": "a value with its error, wider types, fits, threads, random numbers",
    "model": "wells, contacts, masses, damping, ends: forces, energies, the inner loop",
    "stepping": "long runs: splittings, the contact-aware stepper, a stated tolerance",
    "landing": "orbit and tangent map to the last digits, landing on every switching",
    "measure": "striking and following: packets, turning points, scattering, criteria",
    "dps": "the limit of small amplitude",
    "orbits": "one Newton's method for every periodic orbit, branches, barriers",
    "report": "files, options, verdicts",
}
LISTS = [("published.html", "Published against reproduced"), ("numbers.html", "All other numbers"),
         ("equations.html", "Equations of the article"), ("figures.html", "All figures")]
VERDICTS = ["reproduced", "holds", "measured", "discrepant", "unresolved", "open"]


class Book:
    def __init__(self, record, binder, chapters, library):
        self.record, self.binder = record, binder
        self.chapters, self.rooms = chapters, library
        self.headers = [h for room in library.values() for h in room]
        self.included_by = {}
        for s in chapters + self.headers:
            for i in s.includes:
                self.included_by.setdefault(i, []).append(s)
        self.search = []

    # The frame

    def side(self, page, headings):
        """The contents beside every page, with the sections of this one."""
        def item(target, title, below=""):
            here = ' aria-current="page"' if target == page else ""
            return f'<li><a href="{target}"{here}>{escape(title)}</a>{below if here else ""}</li>'

        sections = "".join(f'<li><a href="#{anchor}">{title}</a></li>'
                           for level, title, anchor in headings if level == 2)
        sections = f"<ul>{sections}</ul>" if sections else ""
        out = "<h2>Chapters</h2><ul>" + item("index.html", "Start")
        out += "".join(item(s.page, s.title, sections) for s in self.chapters) + "</ul>"
        out += "<h2>Findings</h2><ul>" + "".join(item(t, n) for t, n in LISTS)
        live = [("strike.html", "Strike the chain (live)"), ("breather.html", "Find a breather (live)"),
                ("defect.html", "Put a defect in the way (live)")]
        out += "".join(item(t, n) for t, n in live if self.binder.live) + "</ul><h2>Library</h2>"
        for room, headers in self.rooms.items():
            inside = any(h.page == page for h in headers)
            items = "".join(item(h.page, h.title, sections) for h in headers)
            out += f'<details{" open" if inside else ""}><summary>{room}</summary><ul>{items}</ul></details>'
        return out

    def page(self, name, title, body, headings=(), before=None, after=None, scripts=""):
        pager = "".join(f'<a rel="{rel}" href="{s.page}">{arrow(rel, escape(s.title))}</a>'
                        for rel, s in (("prev", before), ("next", after)) if s)
        head = f"{escape(title)} · {BOOK}" if name != "index.html" else BOOK
        return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{head}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="katex.css">
<link rel="stylesheet" href="book.css">
<script>try {{ const t = localStorage.getItem("theme"); if (t) document.documentElement.dataset.theme = t; }} catch {{}}</script>
</head>
<body>
<a class="skip" href="#main">Skip to the text</a>
<header class="top"><a class="home" href="index.html">Breathers<span> with Hertzian contacts</span></a>
<form action="search.html" role="search"><input type="search" name="q" placeholder="Search ( / )" aria-label="Search the book"></form>
<button type="button" class="button" id="theme" hidden>Light / dark</button></header>
<div class="frame">
<nav class="side" aria-label="Contents"><details open><summary>Contents</summary><script>if (!matchMedia("(min-width: 60.01rem)").matches) document.currentScript.parentNode.open = false;</script>
{self.side(name, headings)}
</details></nav>
<main id="main">
{body}
{f'<nav class="pager" aria-label="Pages before and after">{pager}</nav>' if pager else ""}
</main>
</div>
{scripts}<script src="book.js"></script>
{'<script src="live.js"></script>' if 'class="button live"' in body or 'id="live-' in body else ""}
</body>
</html>
"""

    def note(self, page, anchor, title, section, html):
        """A piece of text that the search finds."""
        html = re.sub(r'<button type="button" class="made".*?</button>|<pre.*?</pre>', "", html, flags=re.S)
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

    def chapter_card(self, source):
        program = source.stem if source.path.endswith(".cpp") else next(
            s.stem for s in self.included_by.get(source.name, []) if s.path.endswith(".cpp"))
        cost = self.record.cost(program)
        shown = [i for i, f in self.record.figures.items() if f["program"] == program]
        links = ", ".join(f'<a href="fig-{i}.html">{int(i) if i[0] != "x" else i}</a>' for i in shown)
        lines = [f"The source of this chapter is <code>{source.path}</code>. It is compiled to the program "
                 f"<code>build/bin/{program}</code>"
                 + (f", which computes for {cost} on two cores." if cost else ".")]
        if shown:
            lines.append(f"Its figures: {links}.")
        if program in self.claims_by_program:
            count = len(self.claims_by_program[program])
            lines.append(f'It answers <a href="#answers">{count} statement{"s" if count > 1 else ""} of the article</a>.'
                         if source.path.endswith(".cpp") else "")
        return f'<p class="card">{" ".join(lines)}</p>'

    def header_card(self, source):
        def links(names):
            found = [s for s in names if s]
            return ", ".join(f'<a href="{s.page}">{s.name if s.room == source.room or not s.room else s.room + "/" + s.name}</a>'
                             for s in found)

        needs = links([self.binder.by_path.get("src/" + i) for i in source.includes])
        users = self.included_by.get(source.path[len("src/"):], [])
        out = f'<code>#include "{source.path[len("src/"):]}"</code>'
        out += f"<br>needs {needs}" if needs else ""
        out += f"<br>needed by {links(users)}" if users else ""
        return f'<p class="card">{out}</p>'

    def answers(self, program):
        """The statements that a chapter answers, linked to their rows."""
        rows = "".join(self.claim_row(c, short=True) for c in self.claims_by_program.get(program, []))
        if not rows:
            return ""
        return ('<h2 id="answers">Statements answered here</h2><div class="scroll wide" tabindex="0"><table class="rows"><thead><tr><th>statement</th>'
                "<th>article</th><th>here</th><th>verdict</th></tr></thead><tbody>" + rows + "</tbody></table></div>")

    def further_figures(self, binding, program):
        left = [i for i, f in self.record.figures.items() if f["program"] == program and i not in self.binder.shown]
        if not left:
            return ""
        caption = self.record.figures
        return '<h2 id="further-figures">Further figures of this program</h2>' + "".join(
            binding.figure(i, escape(caption[i]["caption"])) for i in left)

    def source_pages(self, bodies):
        order = self.chapters + self.headers
        claims = self.record.claims.values()
        self.claims_by_program = {}
        for claim in claims:
            if claim["program"]:
                self.claims_by_program.setdefault(claim["program"], []).append(claim)
        out = {}
        for i, source in enumerate(order):
            binding, parts = bodies[source.path]
            card = self.header_card(source) if source.room else self.chapter_card(source)
            parts[0] = re.sub(r"(</h1>)", lambda m: m[0] + card, parts[0], count=1)
            self.note_sections(source.page, source.title, "".join(p for p in parts if p.startswith('<div class="prose"')))
            extra = ""
            headings = list(binding.headings)
            if not source.room and source.path.endswith(".cpp"):
                extra = self.further_figures(binding, source.stem) + self.answers(source.stem)
                headings += [(2, "Statements answered here", "answers")] if 'id="answers"' in extra else []
            self.definitions(source)
            body = "\n".join(parts) + extra + binding.records_html()
            out[source.page] = self.page(source.page, source.title, body, headings,
                                         order[i - 1] if i else None, order[i + 1] if i + 1 < len(order) else None)
        return out

    def definitions(self, source):
        """Names that a header defines, for the search, with the remark before them."""
        lines = source.text.split("\n")
        for name, (owner, line) in self.binder.definitions.items():
            if owner is source:
                first = line - 1
                while first > 0 and re.match(r"\s*(///|template)", lines[first - 1]):
                    first -= 1
                remark = " ".join(re.sub(r"^\s*///?\s*", "", l) for l in lines[first:line])
                self.search.append([f"{source.page}#L{line}", source.title, name, remark])

    # Lists

    def claim_row(self, claim, short=False):
        id, cells = claim["id"], []
        finding = self.record.quotable.get(id)
        printed = spelled(claim["printed"]) + (f' {unit(claim["unit"])}' if claim["unit"] else "")
        quote = self.record.quote(id) if finding else None
        here = self.binder.value(quote) if quote else ""
        place = escape(self.binder.where(claim["where"]))
        link = f"published.html#{id}" if short else ""
        name = f'<a href="{link}"><code>{broken(id)}</code></a>' if short else f"<code>{broken(id)}</code>"
        reason = f'<small>{spelled(claim["reason"])}</small>' if claim["reason"] and not short else ""
        cells.append(("", f'{name}<small>{spelled(claim["quantity"])}{"" if short else " (" + place + ")"}</small>', id))
        if not short:
            cells.append(("section", escape(claim["section"]), claim["section"]))
        cells.append(("article", printed, claim["printed"]))
        cells.append(("here", here, finding.value if finding and finding.unit != "claim" else here))
        cells.append(("verdict", self.binder.verdict(claim) + reason, claim["status"]))
        if not short:
            links = []
            if quote and quote.places:
                place = quote.places[0]
                links.append(f'<a href="{self.binder.by_path[place.path].page}#L{place.first}">code</a>')
                links.append(f'<a href="{self.binder.by_path["src/" + claim["program"] + ".cpp"].page}#answers">chapter</a>')
            links += self.quotations(id)
            cells.append(("see", ", ".join(links), ""))
        body = "".join(f'<td{f""" data-label="{label}" """ if label else ""} data-key="{escape(key)}">{cell}</td>'
                       for label, cell, key in cells)
        anchor = "" if short else f' id="{id}"'
        return f'<tr{anchor} data-verdict="{claim["status"]}">{body}</tr>'

    def quotations(self, id):
        return [f'<a href="{page}#{anchor}">quoted{f" {n}" if n > 1 else ""}</a>'
                for n, (page, anchor) in enumerate(self.binder.quoted.get(id, []), 1)]

    def tally(self):
        statuses = [c["status"] for c in self.record.claims.values()]
        return '<ul class="tally">' + "".join(
            f'<li><b class="{v}">{statuses.count(v)}</b>{v}</li>' for v in VERDICTS if v in statuses) + "</ul>"

    def published(self):
        meanings = [("reproduced", "a printed number, met within its tolerance"),
                    ("holds", "a yes-or-no statement, confirmed by a criterion that stands in the chapter and can fail"),
                    ("measured", "a word without a number, such as excellent: we give the number and pass no judgement"),
                    ("discrepant", "a printed number missed, or a statement that fails; the likely cause stands beside it"),
                    ("open", "not answered yet")]
        used = {c["status"] for c in self.record.claims.values()}
        options = "".join(f'<option value="{v}">{v}</option>' for v in VERDICTS if v in used)
        rows = "".join(self.claim_row(c) for c in self.record.claims.values())
        for claim in self.record.claims.values():
            self.note("published.html", claim["id"], LISTS[0][1], claim["id"],
                      escape(f'{claim["quantity"]}; {claim["printed"]}; {claim["status"]} {claim["reason"]}'))
        body = f"""<h1>Published against reproduced</h1>
<p>Every number and statement of the article that can be tested. Tolerances were fixed before anything was
computed. A value carries the error that computations of different resolution leave.</p>
{self.tally()}
{facts([(f'<span class="verdict {v}">{v}</span>', text) for v, text in meanings if v in used])}
<div class="controls"><label>Only rows with <input type="text" id="filter" placeholder="word"></label>
<label>Verdict <select id="only"><option value="">all</option>{options}</select></label></div>
<div class="scroll wide" tabindex="0"><table class="sortable rows"><thead><tr>{heads("statement", "section", "article", "here", "verdict", "see")}</tr></thead>
<tbody>{rows}</tbody></table></div>"""
        return self.page("published.html", LISTS[0][1], body)

    def numbers(self):
        rows = []
        for id, f in sorted(self.record.quotable.items()):
            if id in self.record.claims:
                continue
            quote = self.record.quote(id)
            chapter = self.binder.by_path.get(f"src/{f.program}.cpp")
            code = [f'<a href="{self.binder.by_path[p.path].page}#L{p.first}">code</a>' for p in quote.places[:1]]
            rows.append(f'<tr id="{id}"><td><code>{broken(f.id)}</code></td>'
                        f'<td data-label="program"><a href="{chapter.page}">{f.program}</a></td>'
                        f'<td data-label="value" data-key="{f.value!r}">{self.binder.value(quote)}</td>'
                        f'<td>{", ".join(code + self.quotations(id))}</td></tr>' if chapter else "")
        body = f"""<h1>All other numbers</h1>
<p>What the programs found beside the answers to the article's statements: margins of criteria, independent
routes, laws of our own.</p>
<div class="controls"><label>Only rows with <input type="text" id="filter" placeholder="word"></label></div>
<div class="scroll wide" tabindex="0"><table class="sortable rows"><thead><tr>{heads("number", "program", "value", "see")}</tr></thead>
<tbody>{"".join(rows)}</tbody></table></div>"""
        return self.page("numbers.html", LISTS[1][1], body)

    def equations(self):
        titles = {s.page: s.title for s in self.chapters + self.headers}
        items = []
        for number, e in self.binder.equations.items():
            cited = self.binder.cited.get(number, [])
            links = "; ".join(f'<a href="{page}#{anchor}">{escape(titles[page])}</a>' for page, anchor in cited if page in titles)
            items.append(f'<section id="eq-{number}"><h3>({number}) {escape(e["name"])}</h3>'
                         f'<span class="math display">\\[{escape(e["tex"])}\\tag{{{number}}}\\]</span>'
                         + (f'<p class="card">{links}</p>' if links else "") + "</section>")
            self.note("equations.html", f"eq-{number}", LISTS[2][1], f"Eq. ({number})", escape(e["name"]))
        body = ("<h1>Equations of the article</h1><p>The article's numbers, the equations in the notation of the programs, "
                "and where the book speaks of them.</p>" + "".join(items))
        return self.page("equations.html", LISTS[2][1], body)

    # Figures

    def gallery(self):
        return '<div class="gallery">' + "".join(
            f'<a href="fig-{i}.html">{self.binder.image(i, " loading=" + chr(34) + "lazy" + chr(34))}'
            f'<br><b>{spoken(i)}.</b> {escape(f["caption"])}</a>' for i, f in self.record.figures.items()) + "</div>"

    def figure_page(self, id):
        figure, binder = self.record.figures[id], self.binder
        name, _, _, has_pdf = binder.images[id]
        script = os.path.join(self.record.root, "figures", figure["script"])
        with open(script, encoding="utf-8") as file:
            code = file.read().rstrip("\n")
        language = "python" if script.endswith(".py") else "gnuplot"
        titles = {s.page: s.title for s in self.chapters + self.headers}
        shown = ", ".join(f'<a href="{p}#fig-{id}">{escape(titles[p])}</a>' for p in binder.shown.get(id, []) if p in titles)
        rows = binder.figure_facts(id)
        if shown:
            rows.append(("chapter", shown))
        files = [f'<a href="figures/{name}.svg">SVG</a>']
        if has_pdf:
            files.append(f'<a href="figures/{name}.pdf">PDF</a>')
        rows.append(("drawing", ", ".join(files)))
        tables = ""
        for table in figure["data"].split():
            path = os.path.join(self.record.data, figure["program"], table + ".ecsv")
            if not os.path.exists(path):
                continue
            read = read_table(path)
            columns = "".join(f"<tr><td><code>{broken(c.name)}</code></td><td>{unit(c.unit)}</td><td>{escape(c.description)}</td></tr>"
                              for c in read.columns)
            tables += (f'<h3 id="table-{table}">{binder.data_link(figure["program"], table)}, {len(read.rows)} rows</h3>'
                       f'<div class="scroll" tabindex="0"><table><thead><tr><th>column</th><th>unit</th><th>meaning</th></tr></thead>'
                       f"<tbody>{columns}</tbody></table></div>")
        owner = "of the article" if id[0] != "x" else "of this book"
        body = f"""<h1>{spoken(id)}</h1>
<figure>{binder.image(id)}<figcaption>{escape(figure["caption"])}</figcaption></figure>
<p class="card">A figure {owner}{f", section {figure['section']}" if id[0] != "x" else ""}.</p>
<h2 id="how">How it was made</h2>{facts(rows)}
<h2 id="tables">What it shows</h2>{tables}
<h2 id="script">The script that draws it</h2>{colour.numbered(code, 1, language)}"""
        self.note(f"fig-{id}.html", "", LISTS[3][1], spoken(id), escape(figure["caption"]))
        return self.page(f"fig-{id}.html", spoken(id), body)

    # The page that computes

    def strike(self):
        chapter = self.binder.by_path["src/sec34_impact.cpp"]
        body = f"""<h1>Strike the chain</h1>
<p>The first bead of a chain at rest gets an impact velocity; the chain is integrated here, in the page, by the headers
that the programs are compiled from. A run is made twice or more often, with half the step each time, until two agree to
one part in ten thousand; the map shows the latest, and the difference of the last two is the error of every number. For
quartic wells the numbers have the bits of the native program, whose command stands below.</p>
<div id="live-strike" class="panel wide"></div>
<noscript><p>This page needs JavaScript.</p></noscript>
<p>What there is to see: with <code>s = 0</code> everything runs away, with <code>s = -0.7</code> and an impact of 0.94
most of the energy stays at the first beads, with <code>s = 1</code> and an impact of 1.9 the packet turns round.
<a href="{chapter.page}">{escape(chapter.title)}</a> tells the story.</p>"""
        self.note("strike.html", "", "Strike the chain", "Strike the chain", body)
        return self.page("strike.html", "Strike the chain", body)

    def breather(self):
        chapters = [self.binder.by_path[f"src/{name}.cpp"] for name in
                    ("sec32_newton_breathers", "sec33_floquet", "sec33_mobility")]
        links = ", ".join(f'<a href="{c.page}">{escape(c.title)}</a>' for c in chapters)
        body = f"""<h1>Find a breather</h1>
<p>Newton's method finds a breather here, in the page, by the headers that the programs are compiled from. Its multipliers
say whether it is stable, and a kick shows whether it can be moved. Where the programs confirm a breather in a wider type,
which a browser does not have, this page takes a second tolerance for the error; the numbers agree with those of the
programs within their errors, not to the bit. Far from the frequency 1.1 the branch is followed first, which takes seconds.</p>
<div id="live-breather" class="panel wide"></div>
<noscript><p>This page needs JavaScript.</p></noscript>
<p>What there is to see: around a site the breather is unstable at <code>s = 0</code> and stable at <code>s = 0.3</code>,
around a bond it is the other way round; a kick of <code>2e-4</code> sets either in motion, against its direction.
The chapters: {links}.</p>"""
        self.note("breather.html", "", "Find a breather", "Find a breather", body)
        return self.page("breather.html", "Find a breather", body)

    def defect(self):
        chapter = self.binder.by_path["src/sec36_cantilever_defect.cpp"]
        body = f"""<h1>Put a defect in the way</h1>
<p>Two hundred clamped cantilevers carry beads, those of the hundredth have another radius, and the first cantilever is
struck. The map shows the contact forces as they are computed here, in the page; then two runs with different steps say how
the energy that arrives is divided.</p>
<div id="live-defect" class="panel wide"></div>
<noscript><p>This page needs JavaScript.</p></noscript>
<p>What there is to see: beads of 1.6 radii reflect almost everything, beads of 1.1 radii let a part pass, and beads that
are somewhat smaller than the others keep a few per cent. <a href="{chapter.page}">{escape(chapter.title)}</a> tells the
story.</p>"""
        self.note("defect.html", "", "Put a defect in the way", "Put a defect in the way", body)
        return self.page("defect.html", "Put a defect in the way", body)

    # Start and search

    def start(self, text):
        binding = PageBinding(self.binder, page="index.html")
        binding.anchor = "main"
        words = binding.prose(text)
        items = "".join(f'<li><a href="{s.page}">{escape(s.title)}</a><small>{self.summary(s)}</small></li>' for s in self.chapters)
        rooms = "".join(f'<li><b>{room}</b>: {escape(ROOM_IDEAS.get(room, ""))}<small>'
                        + ", ".join(f'<a href="{h.page}">{escape(h.title)}</a>' for h in headers) + "</small></li>"
                        for room, headers in self.rooms.items())
        body = f"""<h1>Breathers in oscillator chains with Hertzian interactions</h1>
<p class="card">The executable edition</p>
{words}
{self.invitation(binding)}<h2 id="verdicts">What comes out</h2>
{self.tally()}
<p>The table <a href="published.html">published against reproduced</a> has every row, and where the article's number
does not survive a converged computation it says what does, and why.</p>
<h2 id="chapters">Chapters</h2><ul class="chapters">{items}</ul>
<h2 id="gallery">Figures</h2>{self.gallery()}
<h2 id="library">Library</h2><p>The chapters share a library whose rooms build on each other from top to bottom.</p>
<ul class="chapters">{rooms}</ul>{binding.records_html()}"""
        headings = [(2, "What comes out", "verdicts"), (2, "Chapters", "chapters"), (2, "Figures", "gallery"), (2, "Library", "library")]
        return self.page("index.html", BOOK, body, headings, after=self.chapters[0])

    def invitation(self, binding):
        """A figure that the reader can compute at once, where the book has live pages."""
        if not self.binder.live:
            return ""
        return ('<h2 id="live">Strike the chain</h2><p>A figure with a button can be computed here, in the page, by the library that '
                'the programs use. Then turn a knob.</p>' + binding.figure("21", escape(self.record.figures["21"]["caption"]))
                + '<p>Or <a href="breather.html">find a breather</a>, and see whether a kick moves it, '
                  'or <a href="defect.html">put a defect in the way</a> of a packet.</p>')

    def summary(self, source):
        """The first sentences of a chapter."""
        for block in source.blocks:
            if block.kind == "prose":
                for part in re.split(r"\n\s*\n", block.text):
                    words = part.strip()
                    if words and not words.startswith(("#", "!", "|", "-")) and not part.startswith("    "):
                        pieces = beginning(words).split("$")
                        pieces[::2] = [typeset_number(escape(piece)) for piece in pieces[::2]]
                        pieces[1::2] = [f'<span class="math inline">\\({escape(tex)}\\)</span>' for tex in pieces[1::2]]
                        return "".join(pieces)
        return ""

    def search_page(self):
        body = """<h1>Search</h1>
<p>Every word must occur in a section, a statement, a caption, or a remark of the library.</p>
<input type="search" id="query" aria-label="Search for"><p id="count" role="status"></p>
<noscript><p>The search needs JavaScript; the contents, and the search of your browser, do not.</p></noscript>
<ol class="results" id="results"></ol>"""
        return self.page("search.html", "Search", body, scripts='<script src="search-index.js"></script>\n')

    def assemble(self, bodies):
        """All files that are text, by name."""
        with open(os.path.join(self.record.root, "book/start.md"), encoding="utf-8") as file:
            start = prose.to_html([file.read()])[0]
        out = {}
        pages = self.source_pages(bodies)
        out["index.html"] = self.start(start)
        out.update(pages)
        out["published.html"] = self.published()
        out["numbers.html"] = self.numbers()
        out["equations.html"] = self.equations()
        out["figures.html"] = self.page("figures.html", LISTS[3][1], "<h1>All figures</h1>" + self.gallery())
        for id in self.record.figures:
            out[f"fig-{id}.html"] = self.figure_page(id)
        if self.binder.live:
            out["strike.html"] = self.strike()
            out["breather.html"] = self.breather()
            out["defect.html"] = self.defect()
        out["search.html"] = self.search_page()
        rows = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in self.search)
        out["search-index.js"] = f"window.SEARCH = [\n{rows}\n];\n"
        return out


def beginning(paragraph):
    """The first sentences of a paragraph of Markdown, without marks, links and names of statements."""
    text = re.sub(r"\s*\((?:`[a-z0-9_.]+`(?:,? and |,\s)?)+[^)]*\)", "", re.sub(r"\s+", " ", paragraph))
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"[*`]", "", re.sub(r":$", ".", text)))
    out = ""
    for sentence in re.split(r"(?<=[.?!]) (?=[A-Z])", text):
        if len(out) > 150 and not out.count("$") % 2:
            break
        out += " " + sentence
    return out.strip()


def arrow(rel, title):
    return f"← {title}" if rel == "prev" else f"{title} →"


def heads(*names):
    return "".join(f'<th scope="col"><button type="button">{n}</button></th>' for n in names)
