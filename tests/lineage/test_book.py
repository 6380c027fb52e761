"""The book: words that lineage/markdown.py spells, and a small repository that book/literate.py binds, and that is broken."""

import filecmp
import importlib.util
import os
import shutil
import subprocess
import sys
import unittest

from lineage import ecsv, markdown as md

from common import ROOT, Scratch, table

LACKING = [name for name in ("sphinx", "myst_parser", "furo") if not importlib.util.find_spec(name)]
LACKING += [] if shutil.which("node") or shutil.which("nodejs") else ["node"]
needs_sphinx = unittest.skipIf(LACKING, f"{', '.join(LACKING)} not installed (make book)")


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


CHAPTER = """/**
# 1 A demonstration

What we see, as in Eq. (9), is $x^2$, and it is [](statement:a.one), with [2.0 ± 0.1](cell:results/name=two/value) beside it (demo.hpp).
[1.5](cell:speeds/n=2/value) and [0.50](cell:n=1/value) were measured.
![All of $it$.](fig:01) */
#include "lattice/numbers/demo.hpp"

/**
## Results

Take $a$. And *this*. And $b$. It is
$$E = \\tfrac12 v^2
- 1.$$

<!-- statements -->
<!-- /statements --> */
int main() {
  report.table("speeds");
  report.table("results").add({"one", once(1)});
}
"""


@needs_sphinx
class Repository(Scratch):
    """The small repository with a header, a drawing, and what the book needs besides."""

    def setUp(self):
        super().setUp()
        self.write("src/sec1_demo.cpp", CHAPTER)
        self.computed("sec1_demo/speeds.ecsv", table(["n", "value", "value_error"], [["1", 0.5, 1e-3], ["2", 1.5, 1e-3]]))
        self.write("src/lattice/numbers/demo.hpp", "#pragma once\n/**\n# A header\n\nWords. */\nint once(int x) {\n}\n")
        self.write("src/lattice/numbers/demo.cpp", '#include "lattice/numbers/demo.hpp"\n/** More words. */\nint x;\n')
        self.write("figures/fig01.gp", "plot x  # a line\n")
        self.write("build/figures/fig01.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="20"><rect/></svg>')
        self.write("book/equations.ecsv", ecsv.text_of(ROOT / "book/equations.ecsv"))
        self.write("book/contents.txt", "= One\nsec1_demo\n")
        self.write("book/start.md", "# Start\n\nTake [](statement:a.one).\n")
        self.write("book/commands.txt", "a.one build/bin/sec1_demo one --exactly # one\n")
        self.write("src/modules.ecsv", table(["folder", "idea"], [["src/lattice/numbers", "what numbers are"]]))
        self.program()
        self.judged()

    def build(self, out="book"):
        """Exit code and words of Sphinx, as `make weave` calls it."""
        os.makedirs(self.root / "build/pages", exist_ok=True)
        run = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-n", "-W", "--keep-going", "-E", "-c", ROOT / "book", "-d", "build/read",
                              "-D", f"literate_root={self.root}", "-D", "literate_build=build", "build/pages", f"build/{out}"],
                             capture_output=True, text=True, check=False, env=os.environ | {"SOURCE_DATE_EPOCH": "1370000000"})
        return run.returncode, run.stderr

    def test_a_chapter_is_bound_and_twice_to_the_same_bytes(self):
        for name in ("book", "again"):
            self.assertEqual(self.build(name), (0, ""))
        book, again = self.root / "build/book", self.root / "build/again"
        names = sorted(str(path.relative_to(book)) for path in book.rglob("*") if path.is_file())
        self.assertEqual(filecmp.cmpfiles(book, again, names, shallow=False)[1:], ([], []))
        page = self.read("build/book/sec1_demo.html")
        for piece in ['href="published.html#a.one"', "1.000 ± 0.001 m; the article prints 1.02: discrepant", 'class="katex"',
                      'href="numbers-sec1_demo.html#sec1_demo/results/name=two/value"', 'href="equations.html#eq-9"', 'href="numbers-demo.html">demo.hpp</a>',
                      'id="fig-01"', "make fig01", "figures/fig01.gp", 'id="L-19"', "<em>this</em>. And", ">1.5</a> and <a"]:
            self.assertIn(piece, page)
        for name, pieces in {
                "published": ['id="a.one"', "they erred", 'statements-sec1_demo-cpp.html#L-3">judged</a>', "--exactly"],
                "numbers-sec1_demo": ['id="sec1_demo/results/name=two/value"', "sec1_demo.html#L-20", "data/sec1_demo/results.ecsv", "what name is",
                                      'id="sec1_demo/speeds/n=1/value"', 'sec1_demo.html#L-19">Results, line 19 of'],
                "fig-01": ["(a–c) At", "a line", "what name is"], "numbers-demo-cpp": ["A header: how", "declared in"],
                "commands": ['id="sec1_demo-one"', "how fast it is, in sites (default: 0.5)", "[1e-06, 1] m/s"],
                "library": ["what numbers are"], "data": ["numbers-sec1_demo.html"]}.items():
            for piece in pieces:
                self.assertIn(piece, self.read(f"build/book/{name}.html"))

    def test_what_stops_the_build(self):
        faults = [("statement:a.one", "statement:a.none", "'a.none' has no reference value and no computed value"), ("$b$", r"$\nonsense{x}$", "KaTeX.*nonsense"),
                  ("[2.0 ± 0.1]", "[3.0 ± 0.1]", "is stale: the text has 3.0"), ("[0.50]", "[0.51]", "is stale: the text has 0.51"), ("fig:01", "fig:02", "no figure '02'"),
                  ("Eq. (9)", "Eq. (99)", "no Eq. .99."), ("$x^2$", "[there](nowhere.html)", r"nowhere\.html"), ("$a$", r"it costs \$5 or", "left as text"),
                  ("*this*", '<a href="sec1_demo.html#none">x</a>', "leads nowhere")]
        # What is no warning stops at once
        for several in (faults, [('"results"', '"others"', "no line of the sources names")], [("cell:n=1", "cell:n=3", "no row of .* with n = 3")]):
            text = CHAPTER
            for old, new, _ in several:
                self.assertIn(old, text)
                text = text.replace(old, new)
            self.write("src/sec1_demo.cpp", text)
            code, said = self.build()
            self.assertTrue(code)
            for *_, message in several:
                self.assertRegex(said, message)
