"""Tests of the book: on texts, and on a small repository that is made a book and broken."""

import filecmp
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from lineage import chapters, ecsv, markdown as md, sources, tex
from lineage.claims import by_name, read_claims
from lineage.lock import read_lock
from lineage.values import Finding
from lineage.volumes import joined, volumes

from . import ROOT, Scratch

LACKING = [name for name in ("sphinx", "myst_parser", "furo") if not importlib.util.find_spec(name)]
LACKING += [] if shutil.which("node") or shutil.which("nodejs") else ["node"]
needs_sphinx = unittest.skipIf(LACKING, f"{', '.join(LACKING)} not installed (make install-book)")


class Sources(unittest.TestCase):
    def test_prose_and_code_in_turn_with_their_lines(self):
        self.assertEqual(sources.blocks_of("/**\n# T\n\nwords */\n\nint x;\n\n/** more\nwords. */\nint y;\n"),
                         [(True, 1, "\n# T\n\nwords"), (False, 6, "int x;"), (True, 8, "more\nwords."), (False, 10, "int y;")])
        self.assertEqual(sources.blocks_of("  /**\n  One\n    deep */\n  int x;")[0][2], "\nOne\n  deep")
        self.assertEqual([prose for prose, *_ in sources.blocks_of("/* a */ int x; /// b\n/**/ int y;")], [False])
        for wrong in ("/**\nwords\n", "/** words */ int x;\n"):
            with self.assertRaisesRegex(ecsv.Fault, "a.cpp:1: a block of prose without an end"):
                sources.blocks_of(wrong, "a.cpp")

    def test_a_line_of_code_keeps_its_number(self):
        text = ecsv.text_of(ROOT / "src/sec34_impact.cpp")
        for prose, first, code in sources.blocks_of(text):
            if not prose:
                self.assertEqual(code.split("\n"), text.split("\n")[first - 1:first + code.count("\n")])

    def test_definitions_begin_a_line(self):
        text = ("struct Well {\n  int inner() { return 1; }\n};\ntemplate <class T>\nT sup(const V<T>& x) {\n  return f(x);\n}\n"
                "using History = int;\ninline constexpr double fit_from = 20;\ntemplate <class T> struct Shot {};\n")
        self.assertEqual(sources.definitions(text), {"Well": 1, "sup": 5, "History": 8, "fit_from": 9, "Shot": 10})

    def test_every_name_that_a_header_offers_is_explained(self):
        unexplained = []
        for path in sorted(path for folder in volumes(ROOT) for path in (folder / "src").rglob("*.hpp")):
            text = ecsv.text_of(path)
            lines = text.split("\n")
            for name, line in sources.definitions(text).items():
                paragraph = lines[:line]
                while "" in paragraph:
                    del paragraph[:paragraph.index("") + 1]
                if not any("//" in piece or piece.endswith("*/") for piece in paragraph):
                    unexplained.append(f"{path.relative_to(ROOT)}:{line}: {name}")
        self.assertEqual(unexplained, [])

    def test_every_source_is_in_the_book(self):
        known, rest = sources.sources_of(ROOT, volumes(ROOT), ["sec1_the_chain"])
        there = known + [s for module in rest.values() for s in module]
        self.assertEqual({s.path for s in there},
                         {str(p.relative_to(ROOT)) for folder in volumes(ROOT) for p in (folder / "src").rglob("*.[ch]pp")})
        self.assertEqual(len(there), len({s.page for s in there}))

    TEXT = ('void f() {\n  facts.add("trapped_" + name, s.trapped);\n  facts.add("packet_" + name,\n'
            '            s.packet);\n  facts.add("b", {1, 2});\n}\nvoid c() {\n  facts.add("speed_" + well, x);\n}\n')

    def test_a_number_has_the_line_of_the_function_that_made_it(self):
        source = sources.Source("src/p.cpp", self.TEXT)
        for id, made_by, line in [("b", "f", 5), ("packet_soft", "f", 3), ("unlike", "f", 1), ("slower_speed_s", "c", 8),
                                  ("trapped_soft", "f", 2)]:
            self.assertEqual(sources.made_at(Finding("p", id, 1, made_by=made_by), [source]), (source, line), id)
        self.assertIsNone(sources.made_at(Finding("p", "b", 1, made_by="none_such"), [source]))

    def test_commands_that_compute_one_number_exist(self):
        known = by_name(joined(read_lock, volumes(ROOT)), read_claims(ROOT))
        for id, (command, quantity) in joined(chapters.read_commands, volumes(ROOT)).items():
            self.assertIn(id, known)
            program, subcommand = command.split()[0].split("/")[-1], command.split()[1]
            folders = [f for v in volumes(ROOT) for f in [v / "src/commands", *(v / "src").glob("sec*/")] if f.name == "commands" or program.startswith(f.name)]
            texts = [ROOT / chapters.chapter_of(ROOT, program), *(h for folder in folders for h in folder.glob("*.hpp"))]
            self.assertTrue(any(f'"{subcommand}"' in ecsv.text_of(path) for path in texts), f"{id}: {subcommand}")
            self.assertTrue(quantity, id)


class Words(unittest.TestCase):
    def test_powers_of_ten_are_set_as_such(self):
        self.assertEqual(md.number("1.62e-11"), "1.62·10<sup>−11</sup>")
        self.assertEqual(md.number("-5.8e3 sites"), "−5.8·10<sup>3</sup> sites")
        self.assertEqual(md.number("sec3e4 and s_1e2 < 3"), "sec3e4 and s_1e2 &lt; 3")

    def test_lists_are_spelled(self):
        self.assertEqual(md.spelled("E_PN near omega_b = 1.01, at most 1.5e-9 | x"),
                         r"$E_{\mathrm{PN}}$ near $\omega_{b}$ = 1.01, at most $1.5\times10^{-9}$ \| x")
        self.assertEqual(md.spelled("sec34_impact.cpp, `a_b` and $c_d$, s >= 2"), r"sec34\_impact.cpp, `a_b` and $c_d$, s $\ge$ 2")
        self.assertEqual(md.name("a.b_c"), "<code>a.<wbr>b_<wbr>c</code>")

    def test_captions_are_words_and_formulas(self):
        self.assertEqual(tex.in_markdown(r"(a--c) At~$x_{1} = \frac12$."), "(a–c) At\u00a0$x_{1} = \\frac12$.")
        for wrong in (r"\num{a.one}", "5 & 6", "$x", "a_b"):
            with self.assertRaises(ecsv.Fault):
                tex.in_markdown(wrong)
        for said in joined(tex.captions, volumes(ROOT)).values():
            tex.in_markdown(said)


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
        self.assertFalse({"python3-sphinx", "clang", "[book]"} & set(self.asked_for()))
        self.assertIn("python3-sphinx", self.asked_for("book"))
        self.assertFalse({"clang", "python3-selenium"} & set(self.asked_for("book")))
        self.assertIn("python3-selenium", self.asked_for("browse"))
        self.assertIn("clang", self.asked_for("live"))


CHAPTER = """/**
# 1 A demonstration

What we see, as in Eq. (9), is $x^2$, and it is [](num:a.one), with [2.0](num:sec1_demo.fact) beside it (demo.hpp).
![All of $it$.](fig:01) */
#include "lattice/numbers/demo.hpp"

/**
## Results

Take $a$. And *this*. And $b$. It is
$$E = \\tfrac12 v^2
- 1.$$ */
int main() {
  facts.add("one", once(1));
  facts.add("fact", {2, 0.1});
}
"""


@needs_sphinx
class Repository(Scratch):
    """The small repository with a header, a drawing, and what the book needs besides."""

    def setUp(self):
        super().setUp()
        self.write("src/sec1_demo.cpp", CHAPTER)
        self.write("src/lattice/numbers/demo.hpp", "#pragma once\n/**\n# A header\n\nWords. */\nint once(int x) {\n}\n")
        self.write("src/lattice/numbers/demo.cpp", '#include "lattice/numbers/demo.hpp"\n/** More words. */\nint x;\n')
        self.write("figures/fig01.gp", "plot x  # a line\n")
        self.write("build/figures/fig01.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="20"><rect/></svg>')
        self.write("paper/captions.tex", "\\see{01}{(a--c) As Fig. 01, at~$t = \\frac12$.}\n")
        self.write("book/equations.ecsv", ecsv.text_of(ROOT / "book/equations.ecsv"))
        self.write("book/contents.txt", "= One\nsec1_demo\n")
        self.write("book/start.md", "# Start\n\nTake [](num:a.one).\n")
        self.write("book/commands.txt", "a.one build/bin/sec1_demo one --exactly # one\n")
        self.write("apt-packages.txt", "dpkg\n[book]\nno-such-package\n")
        self.write("DATA.md", "# Use the data\n\nIt is <!--num:a.one-->1.000<!--/-->.\n")
        cells = [{"cell_type": "markdown", "source": ["# In Python\n", "\n", "By Eq. (9), $x^2$; [](num:a.one)."]},
                 {"cell_type": "code", "source": ["x = 1  # one"], "outputs": [{"output_type": "stream", "text": ["a < b\n"]}]}]
        self.write("python/a_b.ipynb", json.dumps({"cells": cells}))
        self.program()
        self.judged()

    def build(self, out="book"):
        """Exit code and words of Sphinx, as `make weave` calls it."""
        os.makedirs(self.root / "build/pages", exist_ok=True)
        run = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-n", "-W", "--keep-going", "-E", "-c", ROOT / "book", "-d", "build/read",
                              "-D", f"literate_root={self.root}", "-D", "literate_build=build", "build/pages", f"build/{out}"],
                             capture_output=True, text=True, check=False, env=os.environ | {"SOURCE_DATE_EPOCH": "1370000000"})
        return run.returncode, run.stderr

    def test_a_chapter_is_bound(self):
        self.assertEqual(self.build(), (0, ""))
        page = self.read("build/book/sec1_demo.html")
        for piece in ['href="published.html#a.one"', "1.000 ± 0.001 m; the article prints 1.02: discrepant", 'class="katex"',
                      'href="numbers-sec1_demo.html#sec1_demo.fact"', 'href="equations.html#eq-9"', 'href="numbers-demo.html">demo.hpp</a>',
                      'id="fig-01"', "make fig01", "figures/fig01.gp", 'id="L-15"', "<em>this</em>. And", "Statements answered here"]:
            self.assertIn(piece, page)
        for name, pieces in {
                "published": ['id="a.one"', "they erred", 'sec1_demo.html#L-15">line 15 of sec1_demo.cpp</a>', "--exactly"],
                "numbers-sec1_demo": ['id="sec1_demo.fact"', "sec1_demo.html#L-16", "data/sec1_demo/facts.ecsv", "what quantity is"],
                "fig-01": ["(a–c) As", "a line", "what quantity is"], "numbers-demo-cpp": ["A header: how", "declared in"],
                "commands": ['id="sec1_demo-one"', "how fast it is, in sites (default: 0.5)"], "packages": ["not installed"],
                "notebook-a-b": ["equations.html#eq-9", "a &lt; b"], "data": ["numbers-sec1_demo.html"]}.items():
            for piece in pieces:
                self.assertIn(piece, self.read(f"build/book/{name}.html"))

    def test_twice_the_same_bytes(self):
        for name in ("one", "two"):
            self.assertEqual(self.build(name), (0, ""))
        one, two = self.root / "build/one", self.root / "build/two"
        names = sorted(str(path.relative_to(one)) for path in one.rglob("*") if path.is_file())
        self.assertEqual(filecmp.cmpfiles(one, two, names, shallow=False)[1:], ([], []))

    def test_what_stops_the_build(self):
        for old, new, message in [
                ("num:a.one", "num:a.none", "nothing is locked or computed under 'a.none'"), ("[2.0]", "[3.0]", "is stale: 3.0 stands here"),
                ("fig:01", "fig:02", "no figure '02'"), ("Eq. (9)", "Eq. (99)", "no Eq. .99."), ("$x^2$", r"$\nonsense{x}$", "KaTeX.*nonsense"),
                ("$x^2$", "[there](nowhere.html)", "nowhere"), ("$x^2$", r"it costs \$5 or", "left as text"), ("main()", "other()", "no line writes"),
                ("$x^2$", '<a href="sec1_demo.html#none">x</a>', "leads nowhere"), ("(num:a.one)", "(finding:none)", "no finding 'none'")]:
            with self.subTest(new):
                self.assertIn(old, CHAPTER)
                self.write("src/sec1_demo.cpp", CHAPTER.replace(old, new))
                code, said = self.build()
                self.assertTrue(code)
                self.assertRegex(said, message)
