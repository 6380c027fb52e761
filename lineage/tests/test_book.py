"""Tests of the weaver: on texts, and on a small repository that is made, woven and broken."""

import filecmp
import html
import importlib.util
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from lineage import chapters, ecsv, tex
from lineage.values import Finding
from lineage.volumes import joined, volumes

from . import ROOT, Scratch

BOOK = ROOT / "book"
TOOLS = shutil.which("pandoc") and shutil.which("katex") and (shutil.which("node") or shutil.which("nodejs"))
if missing := [name for name in ("jinja2", "pygments") if not importlib.util.find_spec(name)]:
    raise unittest.SkipTest(f"python3-{missing[0]} is not installed (make install-book)")

from lineage.book import bind, check, code, origin, pages, prose, source, weave, words  # noqa: E402
from lineage.book.record import Record  # noqa: E402

needs_tools = unittest.skipUnless(TOOLS, "pandoc, katex or node is not installed (make install-book)")


class Blocks(unittest.TestCase):
    def test_prose_and_code_in_turn_with_their_lines(self):
        blocks = source.split_blocks("/**\n# T\n\nwords */\n\nint x;\n\n/** more\nwords. */\nint y;\n")
        self.assertEqual([(b.kind, b.first) for b in blocks],
                         [("prose", 1), ("code", 6), ("prose", 8), ("code", 10)])
        self.assertEqual(blocks[0].text.strip(), "# T\n\nwords")
        self.assertEqual(blocks[2].text, "more\nwords.")

    def test_a_line_of_code_keeps_its_number(self):
        text = ecsv.text_of(ROOT / "src/sec34_impact.cpp")
        lines = text.split("\n")
        for block in source.split_blocks(text):
            if block.kind == "code":
                self.assertEqual(block.lines, lines[block.first - 1:block.last])

    def test_indented_prose_loses_its_indent(self):
        self.assertEqual(source.split_blocks("  /**\n  One\n    deep */\n  int x;")[0].text, "\nOne\n  deep")

    def test_other_comments_are_code(self):
        self.assertEqual([b.kind for b in source.split_blocks("/* a */ int x; /// b\n/**/ int y;")], ["code"])

    def test_functions_that_only_fill_tables_are_folded(self):
        fill = "/// Two.\nstd::array<double, 3> report_two(Report& report) {\n  x();\n}"
        lines = f"int x;\n\n{fill}\n\nvoid report_more(\n    Report& report) {{\n}}\n\nint shown() {{\n  report_two(r);\n}}".split("\n")
        self.assertEqual([("\n".join(lines[a:b]).strip(), names) for a, b, names in bind.pieces(lines)], [
            ("int x;", []), (f"{fill}\n\nvoid report_more(\n    Report& report) {{\n}}", ["report_two", "report_more"]),
            ("int shown() {\n  report_two(r);\n}", [])])

    def test_a_block_without_end_is_an_error(self):
        with self.assertRaisesRegex(ecsv.Fault, "no end"):
            source.split_blocks("/**\nwords\n")
        with self.assertRaisesRegex(ecsv.Fault, "after the end"):
            source.split_blocks("/** words */ int x;\n")

    def test_definitions_begin_a_line(self):
        text = ("struct Well {\n  int inner() { return 1; }\n};\ntemplate <class T>\nT sup(const V<T>& x) {\n  return f(x);\n}\n"
                "using History = int;\ninline constexpr double fit_from = 20;\ntemplate <class T> struct Shot {};\n")
        self.assertEqual(source.definitions(source.split_blocks(text)),
                         {"Well": 1, "sup": 5, "History": 8, "fit_from": 9, "Shot": 10})

    def test_every_name_that_a_header_offers_is_explained(self):
        unexplained = []
        for path in sorted(path for folder in volumes(ROOT) for path in (folder / "src").rglob("*.hpp")):
            text = ecsv.text_of(path)
            lines = text.split("\n")
            for name, line in source.definitions(source.split_blocks(text)).items():
                paragraph = lines[:line]
                while "" in paragraph:
                    del paragraph[:paragraph.index("") + 1]
                if not any("//" in piece or piece.endswith("*/") for piece in paragraph):
                    unexplained.append(f"{path.relative_to(ROOT)}:{line}: {name}")
        self.assertEqual(unexplained, [])

    def test_captions_are_words_and_formulas(self):
        self.assertEqual(prose.from_tex(r"(a--c) At~$x_{1} = \frac12$."), "(a–c) At\u00a0$x_{1} = \\frac12$.")
        for wrong in (r"\num{a.one}", "5 & 6", "$x", "a_b"):
            with self.assertRaises(ecsv.Fault):
                prose.from_tex(wrong)
        for said in joined(tex.captions, volumes(ROOT)).values():
            prose.from_tex(said)

    def test_headers_come_after_what_they_need(self):
        a = source.Source("src/lattice/numbers/a.hpp", "", includes=["lattice/numbers/b.hpp"])
        b = source.Source("src/lattice/numbers/b.hpp", "")
        self.assertEqual([s.name for s in source.in_order_of_need([a, b])], ["b.hpp", "a.hpp"])

    def test_every_source_is_in_the_book(self):
        chapters, library = source.find_sources(ROOT, volumes(ROOT), weave.read_order(BOOK / "contents.txt"))
        there = chapters + [s for module in library.values() for s in module]
        self.assertEqual({s.path for s in there},
                         {str(p.relative_to(ROOT)) for folder in volumes(ROOT) for p in (folder / "src").rglob("*.[ch]pp")})
        self.assertEqual(len(there), len({s.page for s in there}))
        self.assertEqual({p.name for p in (ROOT / "src/lattice").iterdir()} - set(source.modules_of(ROOT)), set(), "README.md")

    def test_chapters_stand_under_their_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "contents.txt"
            path.write_text("# a remark\n= One\nsec1_a\n= Two\nsec2_b\n", encoding="utf-8")
            chapters = [source.Source(f"src/{name}.cpp", "") for name in ("sec1_a", "sec1_new", "sec2_b")]
            self.assertEqual(weave.read_order(path), ["sec1_a", "sec2_b"])
            self.assertEqual([(title, [s.stem for s in of]) for title, of in weave.read_parts(path, chapters)],
                             [("One", ["sec1_a", "sec1_new"]), ("Two", ["sec2_b"])])

    def test_the_compiled_half_follows_its_header(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in [("src/lattice/numbers/a.hpp", "/** # A */"), ("src/lattice/numbers/a.cpp", "int x;"),
                               ("src/sec33/b.hpp", "int y;"), ("src/sec33_x.cpp", "/** # X */"),
                               ("README.md", "| [`sec33`](src/sec33) | of 3.3 |\n")]:
                ecsv.write_whole(Path(folder) / name, text)
            chapters, library = source.find_sources(folder, [folder])
            self.assertEqual((list(library), source.modules_of(folder)), (["sec33", "numbers"], {"sec33": "of 3.3"}))
        self.assertEqual([s.page for s in chapters], ["sec33_x.html"])
        self.assertEqual({module: [(s.page, s.title) for s in found] for module, found in library.items()},
                         {"numbers": [("numbers-a.html", "A"), ("numbers-a-cpp.html", "A: how")],
                          "sec33": [("sec33-b.html", "b.hpp")]})

    def test_the_live_page_offers_the_wells_of_the_list(self):
        self.assertEqual(weave.wells_of(ROOT)["quartic"], ["s"])
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "src/lattice/model/well.hpp"
            ecsv.write_whole(path, 'struct A {\n  auto* name = "a";\n};\nstruct B {\n  auto* name = "b";\n  '
                                   'Parameter<B>{"s", ""};\n};\nstruct Well : OneOf<OwnWell, B,\n                    A> {};\n')
            self.assertEqual(weave.wells_of(Path(folder)), {"b": ["s"], "a": []})
            ecsv.write_whole(path, "")
            with self.assertRaisesRegex(ecsv.Fault, "no list of wells"):
                weave.wells_of(Path(folder))


class Numbers(unittest.TestCase):
    def test_powers_of_ten_are_set_as_such(self):
        self.assertEqual(words.number("1.62e-11"), "1.62·10<sup>−11</sup>")
        self.assertEqual(words.number("-5.8e3 sites"), "−5.8·10<sup>3</sup> sites")
        self.assertEqual(words.number("sec3e4 and s_1e2 < 3"), "sec3e4 and s_1e2 &lt; 3")

    def test_claims_are_spelled(self):
        self.assertEqual(words.spelled("E_PN near omega_b = 1.01 for s = -1/6, at most 1.5e-9"),
                         "E<sub>PN</sub> near ω<sub>b</sub> = 1.01 for s = −1/6, at most 1.5·10<sup>−9</sup>")
        self.assertEqual(words.spelled("y_(-n)(t), 1 - cos q, x^(5/2), O(eps^-1/2), s >= 2, two-way & sqrt(2)"),
                         "y<sub>−n</sub>(t), 1 − cos q, x<sup>5/2</sup>, O(ε<sup>−1/2</sup>), s ≥ 2, two-way &amp; √(2)")
        self.assertEqual(words.spelled("see sec34_impact.cpp"), "see sec34_impact.cpp")
        self.assertEqual(words.broken("a.b_c"), "a.<wbr>b_<wbr>c")

    TEXT = ('void f() {\n  facts.add("trapped_" + name, s.trapped);\n  facts.add("packet_" + name,\n'
            '            s.packet);\n  results.add("a.b", {1, 2});\n  judge(report, "a.slower", c);\n}\n'
            'Criterion c() {\n  return {above("speed_" + well, x, 0)};\n}\n')

    def lines(self, id, made_by):
        sources = [source.Source("src/p.cpp", self.TEXT, source.split_blocks(self.TEXT))]
        finding = Finding("p", id, 1, made_by=made_by)
        return [(p.first, p.last) for p in origin.places(finding, {"a.b": {}, "a.slower": {}}, sources)]

    def test_a_number_has_the_statement_of_the_function_that_made_it(self):
        self.assertEqual(self.lines("a.b", "f"), [(5, 5)])
        self.assertEqual(self.lines("packet_soft", "f"), [(3, 4)])
        self.assertEqual(self.lines("unlike", "f"), [(1, 7)])
        self.assertEqual(self.lines("slower_speed_s_1_6", "f"), [(9, 9), (6, 6)])
        self.assertEqual(self.lines("packet_soft", "c"), [(8, 10)])
        self.assertEqual(self.lines("trapped_soft", "f"), [(2, 2)])
        self.assertEqual(self.lines("a.b", "none_such"), [])

    def test_every_locked_number_has_its_lines(self):
        known = Record(ROOT, ROOT / "build/data")
        chapters, library = source.find_sources(ROOT, known.volumes)
        weave.link_sources(known, chapters, library)
        without = [id for id, f in known.quotable.items()
                   if f.key in known.locked and f.program in known.sources and not known.quote(id).places]
        self.assertEqual(without, [])

    def test_commands_that_compute_one_number_exist(self):
        known = Record(ROOT, ROOT / "build/data")
        for id, (command, quantity) in known.alone.items():
            self.assertIn(id, known.quotable)
            program, subcommand = command.split()[0].split("/")[-1], command.split()[1]
            folders = [f for v in volumes(ROOT) for f in [v / "src/commands", *(v / "src").glob("sec*/")] if f.name == "commands" or program.startswith(f.name)]
            sources = [ROOT / chapters.chapter_of(ROOT, program), *(h for folder in folders for h in folder.glob("*.hpp"))]
            self.assertTrue(any(f'"{subcommand}"' in ecsv.text_of(path) for path in sources), f"{id}: {subcommand}")
            self.assertTrue(quantity, id)


class Colours(unittest.TestCase):
    def test_text_survives(self):
        text = 'template <class T>\nT f(T x) {  // a < b && c\n  return x < 1e-3 ? g("<\\"\'") : \'"\';\n}'
        for language in code.LEXERS:
            self.assertEqual(html.unescape(re.sub(r"<[^>]+>", "", code.coloured(text, language))), text)

    def test_kinds(self):
        page = code.coloured('return 1.5e3; // "no"', "cpp")
        self.assertEqual(page, '<span class="k">return</span> <span class="n">1.5e3</span>; <span class="c">// &#34;no&#34;</span>')
        self.assertIn('<a class="s" href="T">&#34;a.hpp&#34;</a>', code.coloured('#include "a.hpp"', include=lambda path: "T"))

    def test_text_stands_out_from_what_is_behind_it(self):
        """By 4.5 to 1, as WCAG asks, in the light and in the dark theme."""
        css = ecsv.text_of(ROOT / "book/book.css")
        themes = [dict(pair) for pair in zip(*[[(name, colour) for colour in two] for name, *two in
                                               re.findall(r"--(\w+): light-dark\((#\w{6}), (#\w{6})\)", css)])]

        def luminance(colour):
            parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
            return sum(w * (x / 12.92 if x <= 0.03928 else ((x + 0.055) / 1.055) ** 2.4) for w, x in zip((0.2126, 0.7152, 0.0722), parts))

        def contrast(one, other):
            low, high = sorted(map(luminance, (one, other)))
            return (high + 0.05) / (low + 0.05)

        self.assertAlmostEqual(contrast("#000000", "#ffffff"), 21)
        for colours in themes:
            for name in set(colours) - {"paper", "panel", "line", "mark"}:
                for behind in ("paper", "panel"):
                    self.assertGreater(contrast(colours[name], colours[behind]), 4.5, (name, behind))
            self.assertGreater(contrast(colours["ink"], colours["mark"]), 4.5)
        self.assertNotIn("opacity", css)

    def test_links_only_for_free_names(self):
        page = code.coloured("a.sup(x); sup(x); lattice::sup(x); other::sup(x);", "cpp", lambda n: "T" if n == "sup" else None)
        self.assertEqual(page.count('href="T"'), 2)

    def test_numbers_of_lines(self):
        self.assertIn('id="L41" data-n="41"', code.numbered("a\nb", 40))


class Check(unittest.TestCase):
    def complaints(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                ecsv.write_whole(f"{folder}/{name}.html", text)
            return check.complaints(folder)

    def test_what_is_broken(self):
        self.assertEqual(self.complaints(a='<a href="b.html#x">b</a>', b='<p id="x">y</p>'), [])
        self.assertEqual(self.complaints(a='<a href="https://a.b/c">there</a><code>$x</code>'), [])
        for page, words in [('<a href="#x">b</a>', "leads to no place"), ('<a href="c.html">b</a>', "leads nowhere"),
                            ('<img src="c.svg">', "leads nowhere"), ('<p id="x"></p><p id="x"></p>', "two elements"),
                            ("<p>so $x$ is</p>", "left as text"), ('<script src="https://a.b/c.js"></script>', "from a network")]:
            self.assertIn(words, self.complaints(a=page)[0])


class Packages(unittest.TestCase):
    """tools/install-deps.sh with stubs in place of the packaging tools: nothing is there, all is asked for."""

    def asked_for(self, *sections):
        with tempfile.TemporaryDirectory() as folder:
            for name, body in [("dpkg-query", "exit 1"), ("apt-get", f'echo "$@" >> {folder}/log'), ("id", "echo 0")]:
                ecsv.write_whole(path := f"{folder}/{name}", f"#!/bin/sh\n{body}\n")
                os.chmod(path, 0o755)
            subprocess.run(["sh", ROOT / "tools/install-deps.sh", ROOT / "apt-packages.txt", *sections],
                           env={"PATH": folder + ":/usr/bin:/bin"}, check=True, capture_output=True)
            return ecsv.text_of(f"{folder}/log").split()

    def test_figures_do_not_need_what_the_book_needs(self):
        self.assertIn("gnuplot-nox", self.asked_for())
        self.assertFalse({"pandoc", "clang", "[book]"} & set(self.asked_for()))
        self.assertIn("pandoc", self.asked_for("book"))
        self.assertFalse({"clang", "python3-selenium"} & set(self.asked_for("book")))
        self.assertIn("python3-selenium", self.asked_for("browse"))
        self.assertIn("clang", self.asked_for("live"))


CHAPTER = """/**
# 1 A demonstration

What we see, as in Eq. (9), is $x^2$, and it is [](num:a.one), with [](num:sec1_demo.fact) beside it (demo.hpp).
![All of it.](fig:01) */
#include "lattice/numbers/demo.hpp"

/**
## Results

$$E = \\tfrac12 v^2.$$ */
int main() {
  results.add("a.one", once(1));
  facts.add("fact", {2, 0.1});
}
"""


class Repository(Scratch):
    """The small repository with a header, a drawing, and what the book needs besides."""

    def setUp(self):
        super().setUp()
        self.write("src/sec1_demo.cpp", CHAPTER)
        self.write("src/lattice/numbers/demo.hpp", "#pragma once\n/**\n# A header\n\nWords. */\nint once(int x) {\n}\n")
        self.write("src/lattice/numbers/demo.cpp", '#include "lattice/numbers/demo.hpp"\n/** More words. */\nint x;\n')
        self.write("figures/fig01.gp", "plot x  # a line\n")
        self.write("build/figures/fig01.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="20"><rect/></svg>')
        self.write("book/equations.ecsv", ecsv.text_of(BOOK / "equations.ecsv"))
        self.write("book/start.md", "Take [](num:a.one).\n")
        self.write("book/live/figures.txt", "")
        self.write("book/commands.txt", "a.one build/bin/sec1_demo one --exactly # one\n")
        self.write("apt-packages.txt", "dpkg\n[book]\nno-such-package\n")

    def weave(self, out="book"):
        build = self.root / "build"
        weave.make(self.root, build / "data", build / "figures", build / out, build / "live", build / "bin")

    def page(self, name, out="book"):
        return self.read(f"build/{out}/{name}")

    @needs_tools
    def test_a_chapter_is_bound(self):
        self.weave()
        page = self.page("sec1_demo.html")
        for piece in ['<h1 id="1-a-demonstration">', 'class="num" popovertarget="number-a.one">1.000</button>',
                      "1.000 ± 0.001 m", "1.02", "they erred", "line 13 of src/sec1_demo.cpp", "results.ecsv</a>, row 1",
                      "facts.ecsv</a>, row 2", "build/bin/sec1_demo one --exactly", "3 s on two cores", 'id="fig-01"',
                      'width="38"', "make fig01", "figures/fig01.gp", 'class="katex"', "equations.html#eq-9",
                      'href="numbers-demo.html">demo.hpp</a>', 'href="numbers-demo.html#L6">once</a>', "Fig. 1"]:
            self.assertIn(piece, page)
        published = self.page("published.html")
        self.assertIn('<tr id="a.one" data-verdict="discrepant">', published)
        self.assertIn('href="sec1_demo.html#P1">quoted', published)
        self.assertIn('<small>See: <a href="sec1_demo.html">sec1_demo</a> (<code>build/bin/sec1_demo</code>, 3 s); '
                      'alone: <code>build/bin/sec1_demo one --exactly</code></small>', published)
        self.assertIn('id="a.two"', published)
        self.assertIn("a line", self.page("fig-01.html"))
        self.assertIn("what quantity is", self.page("fig-01.html"))
        half = self.page("numbers-demo-cpp.html")
        self.assertIn('<h1 id="a-header-how">A header: how</h1><p class="card">', half)
        self.assertIn('what <a href="numbers-demo.html">demo.hpp</a> declares', half)
        self.assertIn('compiled in <a href="numbers-demo-cpp.html">demo.cpp</a>', self.page("numbers-demo.html"))
        self.assertIn('["sec1_demo.html#results"', self.page("search-index.js"))

    @needs_tools
    def test_a_figure_has_the_caption_of_the_report(self):
        self.write("paper/captions.tex", "\\see{01}{(a--c) As Fig. 01, at~$t = \\frac12$.}\n")
        self.weave()
        page = self.page("fig-01.html")
        for piece in ['<figcaption>A line. (a–c) As <a href="fig-01.html">Fig. 1</a>, at\u00a0<span', 'class="katex"']:
            self.assertIn(piece, page)
        self.assertIn("A line. (a–c) As Fig. 1", self.page("search-index.js"))
        self.write("paper/captions.tex", "\\see{01}{A \\emph{word}.}\n")
        with self.assertRaisesRegex(ecsv.Fault, "captions.tex: '"):
            self.weave()

    @needs_tools
    def test_tables_commands_and_packages_have_a_page(self):
        self.program()
        self.weave()
        tables = self.page("tables.html")
        for name in ("quantity", "value", "error", "unit"):
            self.assertIn(f'<code>{name}</code></td><td data-label="table"><a href="data/sec1_demo/facts.ecsv"', tables)
        self.assertIn('data-label="meaning">what error is</td>', tables)
        commands = self.page("commands.html")
        self.assertIn('<h3 id="sec1_demo-one"><code>sec1_demo one</code></h3><p>One thing, of two.</p>', commands)
        self.assertIn("<code>--speed</code></td><td>[0, 1]</td><td>how fast it is, in sites (default: 0.5)</td>", commands)
        self.assertEqual(commands.count("<code>--help</code>"), 2)  # in the sentence, and where it is explained
        self.assertIn('["commands.html#sec1_demo-one"', self.page("search-index.js"))
        packages = self.page("packages.html")
        self.assertIn("<code>no-such-package</code></td><td>not installed</td><td>book</td>", packages)

    @needs_tools
    def test_a_notebook_is_shown(self):
        cells = [{"cell_type": "markdown", "source": ["# In Python\n", "\n", "By Eq. (9), $x^2$; [](num:a.one)."]},
                 {"cell_type": "code", "source": ["x = 1  # one"], "outputs": [
                     {"output_type": "stream", "text": ["a < b\n"]}, {"data": {"image/png": "AAAA"}}]}]
        self.write("python/a_b.ipynb", json.dumps({"cells": cells}))
        self.weave()
        page = self.page("notebook-a-b.html")
        for piece in ['<h1 id="in-python">In Python</h1><p class="card">', "equations.html#eq-9", 'class="katex"', "1.000</button>",
                      '<span class="c"># one</span>', '<pre class="said">a &lt; b</pre>', "data:image/png;base64,AAAA"]:
            self.assertIn(piece, page)
        self.assertIn("In Python (Python)", self.page("index.html"))
        self.assertIn('"notebook-a-b.html#in-python"', self.page("search-index.js"))
        self.write("python/a_b.ipynb", json.dumps({"cells": [cells[1]]}))
        with self.assertRaisesRegex(ecsv.Fault, "no title"):
            self.weave()

    def test_a_summary_is_whole_sentences(self):
        long = "word " * 40 + "end."
        self.assertEqual(pages.beginning(f"It is *so* (`a.b`, `c.d` and `e.f` in x.hpp) at\n$x. Y = 1$. {long} Not this."),
                         f"It is so at $x. Y = 1$. {long}")
        self.assertEqual(pages.beginning("See [Chapter](x.html) (or not):"), "See Chapter (or not).")
        self.assertEqual(pages.beginning("At *once* $t^*$ or $t^*$."), "At once $t^*$ or $t^*$.")
        self.assertEqual(pages.beginning("It is\n$$x,$$\nand so on."), "It is $x,$ and so on.")

    @needs_tools
    def test_prose_survives(self):
        texts = ["Take Chain<double> & co.", "```\nnot closed", "> quoted", "| a | b |\n|---|---|\n| $|x|$ | `a|b` |",
                 "one\n![f](fig:01)\n![g\nh](fig:02)\ntwo"]
        found = prose.to_html(texts)
        self.assertEqual(len(found), len(texts))
        self.assertIn("Chain&lt;double&gt; &amp; co.", found[0])
        self.assertEqual(prose.formulas(found[3]), [("\\(|x|\\)", False)])
        self.assertEqual(found[4].count("<figure>"), 2)
        self.assertEqual(prose.plain("<p>a (<b>b</b>) &lt; 10<sup>−3</sup></p><p>c</p>"), "a (b) < 10^−3 c")
        for tex, words_of_it in [(r"\frac{1}{2}\omega_b^{2}", "1/2ω_b^2"), (r"\tfrac12 x \le \infty", "1/2 x ≤ ∞"),
                                 (r"\tilde E_{\mathrm{PN}} \to 0", "E_PN → 0"), (r"\cos q", "cos q"), ("y_{n-1}", "y_(n-1)")]:
            page = f'<span class="math inline">\\({tex}\\)</span>'
            self.assertEqual(prose.plain(page), words_of_it)

    @needs_tools
    def test_twice_the_same_bytes(self):
        self.weave("one")
        self.weave("two")
        one, two = (os.path.join(self.root, "build", n) for n in ("one", "two"))
        names = sorted(os.path.relpath(os.path.join(f, n), one) for f, _, ns in os.walk(one) for n in ns)
        self.assertEqual(filecmp.cmpfiles(one, two, names, shallow=False)[1:], ([], []))

    def refuses(self, old, new, message, name="src/sec1_demo.cpp", text=CHAPTER):
        self.assertIn(old, text)
        self.write(name, text.replace(old, new))
        with self.assertRaisesRegex(ecsv.Fault, message):
            self.weave()

    @needs_tools
    def test_a_number_that_is_not_locked_yet(self):
        self.write("src/sec1_demo.cpp", CHAPTER.replace("sec1_demo.fact", "sec1_demo.other").replace('"fact"', '"other"'))
        self.weave()
        self.assertIn(">1</button>", self.page("sec1_demo.html"))

    @needs_tools
    def test_what_stops_the_build_leaves_the_old_book(self):
        self.weave()
        before = self.page("sec1_demo.html")
        self.refuses("num:a.one", "num:a.none", "nothing is locked or computed under 'a.none'")
        self.refuses("fig:01", "fig:02", "no figure '02'")
        self.refuses("Eq. (9)", "Eq. (99)", "no Eq. .99.")
        self.refuses("$x^2$", r"$\nonsense{x}$", "KaTeX.*nonsense")
        self.refuses("$x^2$", "[there](nowhere.html)", "leads nowhere")
        self.refuses("$x^2$", r"it costs \$5 or", "left as text")
        self.refuses("main()", "other()", "no line writes 'a.one'")
        self.write("src/sec1_demo.cpp", CHAPTER)
        (self.root / "build/figures/fig01.svg").unlink()
        with self.assertRaisesRegex(ecsv.Fault, "make figures"):
            self.weave()
        self.assertEqual(self.page("sec1_demo.html"), before)
