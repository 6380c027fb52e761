"""Tests of the weaver: on texts, and on a small repository that is made, woven and broken.

    python3 book/test_book.py            what needs pandoc and katex is skipped, with a word, without them
"""

import filecmp
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path.insert(0, HERE)

import bind  # noqa: E402
import browse  # noqa: E402
import check  # noqa: E402
import colour  # noqa: E402
import pages  # noqa: E402
import prose  # noqa: E402
import record  # noqa: E402
import source  # noqa: E402
import weave  # noqa: E402

TOOLS = shutil.which("pandoc") and shutil.which("katex") and (shutil.which("node") or shutil.which("nodejs"))
needs_tools = unittest.skipUnless(TOOLS, "pandoc, katex or node is not installed (make install-book)")


class Blocks(unittest.TestCase):
    def test_prose_and_code_in_turn_with_their_lines(self):
        blocks = source.split_blocks("/**\n# T\n\nwords */\n\nint x;\n\n/** more\nwords. */\nint y;\n")
        self.assertEqual([(b.kind, b.first) for b in blocks],
                         [("prose", 1), ("code", 6), ("prose", 8), ("code", 10)])
        self.assertEqual(blocks[0].text.strip(), "# T\n\nwords")
        self.assertEqual(blocks[2].text, "more\nwords.")

    def test_a_line_of_code_keeps_its_number(self):
        with open(os.path.join(ROOT, "src/sec34_impact.cpp"), encoding="utf-8") as file:
            text = file.read()
        lines = text.split("\n")
        for block in source.split_blocks(text):
            if block.kind == "code":
                self.assertEqual(block.lines, lines[block.first - 1:block.last])

    def test_indented_prose_loses_its_indent(self):
        self.assertEqual(source.split_blocks("  /**\n  One\n    deep */\n  int x;")[0].text, "\nOne\n  deep")

    def test_other_comments_are_code(self):
        self.assertEqual([b.kind for b in source.split_blocks("/* a */ int x; /// b\n/**/ int y;")], ["code"])

    def test_a_block_without_end_is_an_error(self):
        with self.assertRaisesRegex(source.BookError, "no end"):
            source.split_blocks("/**\nwords\n")
        with self.assertRaisesRegex(source.BookError, "after the end"):
            source.split_blocks("/** words */ int x;\n")

    def test_definitions_begin_a_line(self):
        text = ("struct Well {\n  int inner() { return 1; }\n};\ntemplate <class T>\nT sup(const V<T>& x) {\n  return f(x);\n}\n"
                "using History = int;\ninline constexpr double fit_from = 20;\ntemplate <class T> struct Shot {};\n")
        self.assertEqual(source.definitions(source.split_blocks(text)),
                         {"Well": 1, "sup": 5, "History": 8, "fit_from": 9, "Shot": 10})

    def test_headers_come_after_what_they_need(self):
        a = source.Source("src/lattice/numbers/a.hpp", "", includes=["lattice/numbers/b.hpp"])
        b = source.Source("src/lattice/numbers/b.hpp", "")
        self.assertEqual([s.name for s in source.in_order_of_need([a, b])], ["b.hpp", "a.hpp"])

    def test_every_chapter_and_header_is_in_the_book(self):
        chapters, library = source.find_sources(ROOT, weave.read_order(os.path.join(HERE, "contents.txt")))
        there = {s.path for s in chapters} | {h.path for room in library.values() for h in room}
        for folder, _, names in os.walk(os.path.join(ROOT, "src")):
            for name in names:
                if name.endswith((".cpp", ".hpp")):
                    self.assertIn(os.path.relpath(os.path.join(folder, name), ROOT), there)
        pages = [s.page for s in chapters] + [h.page for room in library.values() for h in room]
        self.assertEqual(len(pages), len(set(pages)))


class Numbers(unittest.TestCase):
    def finding(self, value, error, unit="", kind="value"):
        return record.Finding("p", "q", value, error, unit, kind)

    def test_digits_end_where_the_error_begins(self):
        self.assertEqual(self.finding(1.62425e-11, 4e-16).shown, "1.62425e-11")
        self.assertEqual(self.finding(0.9665, 5e-4).shown, "0.9665")
        self.assertEqual(self.finding(500, 200).shown, "5e2")
        self.assertEqual(self.finding(1.75e19, 0).shown, "1.75e19")
        self.assertEqual(self.finding(7, 0).shown, "7")
        self.assertEqual(self.finding(1, 0, "claim").shown, "holds")
        self.assertEqual(self.finding(3.2e-14, 1e-14, "", "residue").shown, "3e-14")

    def test_the_texts_in_the_sources_are_those_of_the_lock(self):
        """The same rule stands in tools/refresh.hpp, which wrote them."""
        known, count = record.Record(ROOT, os.path.join(ROOT, "build/data")), 0
        for folder, _, names in os.walk(os.path.join(ROOT, "src")):
            for name in names:
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    for text, id in re.findall(r"\[([^\]]*)\]\(num:([^)]+)\)", file.read()):
                        if text and id in known.quotable:
                            count += 1
                            self.assertEqual(text, known.quotable[id].shown, f"{name}: {id}")
        self.assertGreater(count, 100)

    def test_powers_of_ten_are_set_as_such(self):
        self.assertEqual(bind.typeset_number("1.62e-11"), "1.62·10<sup>−11</sup>")
        self.assertEqual(bind.typeset_number("-5.8e3 sites"), "−5.8·10<sup>3</sup> sites")
        self.assertEqual(bind.typeset_number("sec3e4 and s_1e2"), "sec3e4 and s_1e2")

    def test_the_statement_that_writes_a_number_is_found(self):
        text = ('void f() {\n  facts.add("trapped_" + name, s.trapped);\n  facts.add("packet_" + name,\n'
                '            s.packet);\n  results.add("a.b", {1, 2});\n  judge(report, "a.slower", c);\n}\n'
                'Criterion c() {\n  return {above("speed_" + well, x, 0)};\n}\n')
        known = record.Record.__new__(record.Record)
        known.claims, known._statements = {"a.b": {}, "a.slower": {}}, {}
        known.sources = {"p": [source.Source("src/p.cpp", text, source.split_blocks(text))]}

        def lines(id, is_claim=False):
            return [(p.first, p.last) for p in known.places(record.Finding("p", id, 1, 0, "", "value"), is_claim)]

        self.assertEqual(lines("trapped_soft"), [(2, 2)])
        self.assertEqual(lines("packet_soft"), [(3, 4)])
        self.assertEqual(lines("a.b", True), [(5, 5)])
        self.assertEqual(lines("slower_speed_s_1_6"), [(9, 9), (6, 6)])
        self.assertEqual(lines("nothing_like_it"), [])

    def test_every_locked_number_has_its_lines(self):
        known = record.Record(ROOT, os.path.join(ROOT, "build/data"))
        chapters, library = source.find_sources(ROOT)
        weave.link_sources(known, chapters, library)
        without = [id for id in known.quotable if (known.quotable[id].program, known.quotable[id].id) in known.findings
                   and known.quotable[id].program in known.sources and not known.quote(id).places]
        self.assertEqual(without, [])


    def test_commands_that_compute_one_number_exist(self):
        known = record.Record(ROOT, os.path.join(ROOT, "build/data"))
        for id, (command, quantity) in known.alone.items():
            self.assertIn(id, known.quotable)
            program, subcommand = command.split()[0].split("/")[-1], command.split()[1]
            with open(os.path.join(ROOT, "src", program + ".cpp"), encoding="utf-8") as file:
                self.assertRegex(file.read(), rf'program\.command\(\s*"{subcommand}"', id)
            self.assertTrue(quantity, id)


class Colours(unittest.TestCase):
    def test_text_survives(self):
        code = 'template <class T>\nT f(T x) {  // a < b && c\n  return x < 1e-3 ? g("<\\"\'") : \'"\';\n}'
        plain = re.sub(r"<[^>]+>", "", colour.coloured(code))
        self.assertEqual(plain.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"), code)

    def test_kinds(self):
        page = colour.coloured('return 1.5e3; // "no"', "cpp")
        self.assertEqual(page, '<span class="k">return</span> <span class="n">1.5e3</span>; <span class="c">// "no"</span>')

    def test_links_only_for_free_names(self):
        page = colour.coloured("a.sup(x); sup(x); lattice::sup(x); other::sup(x);", "cpp", lambda n: "T" if n == "sup" else None)
        self.assertEqual(page.count('href="T"'), 2)

    def test_numbers_of_lines(self):
        self.assertIn('id="L41" data-n="41"', colour.numbered("a\nb", 40))


class Check(unittest.TestCase):
    def complaints(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                with open(os.path.join(folder, name + ".html"), "w", encoding="utf-8") as file:
                    file.write(text)
            return check.complaints(folder)

    def test_a_whole_book(self):
        self.assertEqual(self.complaints(a='<a href="b.html#x">b</a>', b='<p id="x">y</p>'), [])

    def test_what_is_broken(self):
        self.assertIn("leads to no place", self.complaints(a='<a href="#x">b</a>')[0])
        self.assertIn("leads nowhere", self.complaints(a='<a href="c.html">b</a>')[0])
        self.assertIn("leads nowhere", self.complaints(a='<img src="c.svg">')[0])
        self.assertIn("two elements", self.complaints(a='<p id="x"></p><p id="x"></p>')[0])
        self.assertIn("left as text", self.complaints(a="<p>so $x$ is</p>")[0])
        self.assertIn("from a network", self.complaints(a='<script src="https://a.b/c.js"></script>')[0])
        self.assertEqual(self.complaints(a='<a href="https://a.b/c">there</a><code>$x</code>'), [])


class Packages(unittest.TestCase):
    """tools/install-deps.sh with stubs in place of the packaging tools: nothing is there, all is asked for."""

    def asked_for(self, *sections):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "log")
            for name, body in [("dpkg-query", "exit 1"), ("apt-get", f'echo "$@" >> {log}'), ("id", "echo 0")]:
                path = os.path.join(folder, name)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(f"#!/bin/sh\n{body}\n")
                os.chmod(path, 0o755)
            subprocess.run(["sh", os.path.join(ROOT, "tools/install-deps.sh"), os.path.join(ROOT, "apt-packages.txt"), *sections],
                           env={"PATH": folder + ":/usr/bin:/bin"}, check=True, capture_output=True)
            with open(log, encoding="utf-8") as file:
                return file.read().split()

    def test_figures_do_not_need_what_the_book_needs(self):
        self.assertIn("gnuplot-nox", self.asked_for())
        self.assertFalse({"pandoc", "clang-14", "[book]"} & set(self.asked_for()))
        self.assertIn("pandoc", self.asked_for("book"))
        self.assertNotIn("clang-14", self.asked_for("book"))
        self.assertIn("clang-14", self.asked_for("live"))


def table(columns, rows):
    head = "".join(f"# - {{name: '{c}', unit: '', datatype: string, description: 'what {c} is'}}\n" for c in columns)
    body = "".join(",".join(f'"{v}"' for v in row) + "\n" for row in rows)
    return "# %ECSV 1.0\n# ---\n# datatype:\n" + head + "# schema: astropy-2.0\n" + ",".join(columns) + "\n" + body


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


class Repository(unittest.TestCase):
    """A small repository with one chapter, one header, two numbers and one figure."""

    def setUp(self):
        self.root = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.root)
        self.write("src/sec1_demo.cpp", CHAPTER)
        self.write("src/lattice/numbers/demo.hpp", "#pragma once\n/**\n# A header\n\nWords. */\ninline int once(int x) {\n  return x;\n}\n")
        claims = ["id", "section", "where", "quantity", "printed", "unit", "class", "tolerance", "note", "program", "status", "reason"]
        self.write("paper/published.ecsv", table(claims, [
            ["a.one", "1", "Fig. demo", "one", "1.02", "", "converged", "rel 1e-2", "", "sec1_demo", "discrepant", "they erred"],
            ["a.two", "1", "text", "two", "yes", "", "claim", "", "", "", "open", ""]]))
        self.write("paper/converged.ecsv", table(["program", "id", "value", "error", "unit", "kind"], [
            ["sec1_demo", "a.one", "1.0000000000000002", "1e-3", "m", "value"], ["sec1_demo", "fact", "2", "0.1", "", "value"]]))
        figure = ["id", "label", "section", "program", "script", "class", "data", "caption", "seconds"]
        self.write("figures/figures.ecsv", table(figure, [["01", "demo", "1", "sec1_demo", "fig01.gp", "ER", "facts", "A line.", "3"]]))
        self.write("figures/fig01.gp", "plot x  # a line\n")
        self.write("build/data/sec1_demo/results.ecsv", table(["id", "value"], [["a.one", "1"]]))
        self.write("build/data/sec1_demo/facts.ecsv", table(["quantity", "value", "error", "unit"], [
            ["other", "1", "0", ""], ["fact", "2", "0.1", ""]]))
        self.write("build/figures/fig01.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="10mm" height="20"><rect/></svg>')
        for name in ("equations.ecsv", "start.md", "commands.txt"):
            text = "Take [](num:a.one).\n" if name == "start.md" else None
            if name == "equations.ecsv":
                with open(os.path.join(HERE, name), encoding="utf-8") as file:
                    text = file.read()
            self.write("book/" + name, text or "a.one build/bin/sec1_demo one --exactly # one\n")

    def write(self, name, text):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def weave(self, out="book"):
        build = os.path.join(self.root, "build")
        weave.make(self.root, os.path.join(build, "data"), os.path.join(build, "figures"), os.path.join(build, out))

    def page(self, name, out="book"):
        with open(os.path.join(self.root, "build", out, name), encoding="utf-8") as file:
            return file.read()

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
        self.assertIn('id="a.two"', published)
        self.assertIn("a line", self.page("fig-01.html"))
        self.assertIn("what quantity is", self.page("fig-01.html"))
        self.assertIn('["sec1_demo.html#results"', self.page("search-index.js"))

    def test_a_summary_is_whole_sentences(self):
        long = "word " * 40 + "end."
        self.assertEqual(pages.beginning(f"It is *so* (`a.b`, `c.d` and `e.f` in x.hpp) at\n$x. Y = 1$. {long} Not this."),
                         f"It is so at $x. Y = 1$. {long}")
        self.assertEqual(pages.beginning("See [Chapter](x.html) (or not):"), "See Chapter (or not).")

    def test_claims_are_spelled(self):
        self.assertEqual(bind.spelled("E_PN near omega_b = 1.01 for s = -1/6, at most 1.5e-9"),
                         "E<sub>PN</sub> near ω<sub>b</sub> = 1.01 for s = −1/6, at most 1.5·10<sup>−9</sup>")
        self.assertEqual(bind.spelled("y_(-n)(t), 1 - cos q, x^(5/2), O(eps^-1/2), s >= 2, two-way & sqrt(2)"),
                         "y<sub>−n</sub>(t), 1 − cos q, x<sup>5/2</sup>, O(ε<sup>−1/2</sup>), s ≥ 2, two-way &amp; √(2)")
        self.assertEqual(bind.spelled("see sec34_impact.cpp"), "see sec34_impact.cpp")
        self.assertEqual(bind.broken("a.b_c"), "a.<wbr>b_<wbr>c")

    @needs_tools
    def test_prose_survives(self):
        texts = ["Take Chain<double> & co.", "```\nnot closed", "> quoted", "| a | b |\n|---|---|\n| $|x|$ | `a|b` |",
                 "one\n![f](fig:01)\n![g\nh](fig:02)\ntwo"]
        pages = prose.to_html(texts)
        self.assertEqual(len(pages), len(texts))
        self.assertIn("Chain&lt;double&gt; &amp; co.", pages[0])
        self.assertEqual(prose.formulas(pages[3]), [("\\(|x|\\)", False)])
        self.assertEqual(pages[4].count("<figure>"), 2)
        self.assertEqual(prose.plain("<p>a (<b>b</b>) &lt; 10<sup>−3</sup></p><p>c</p>"), "a (b) < 10^−3 c")

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
        with self.assertRaisesRegex(source.BookError, message):
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
        self.refuses('"a.one"', '"b.two"', "no line writes 'a.one'")
        self.write("src/sec1_demo.cpp", CHAPTER)
        os.remove(os.path.join(self.root, "build/figures/fig01.svg"))
        with self.assertRaisesRegex(source.BookError, "make figures"):
            self.weave()
        self.assertEqual(self.page("sec1_demo.html"), before)

    @needs_tools
    def test_the_browser_notices(self):
        program = browse.find_browser()
        if not program:
            self.skipTest("no Chromium on this machine")
        page = '<!DOCTYPE html><meta name="viewport" content="width=device-width"><h1>T</h1>'
        tab = browse.Browser(program)
        self.addCleanup(tab.close)
        tab.size(380, 800)
        for broken, message in [
                ('<div style="width:900px">x</div>', "sideways"), ('<img src="none.png">', "no image|not loaded"),
                ("<script>throw Error('oh')</script>", "exception"), ("<script>console.error(1)</script>", "console"),
                ('<script src="http://127.0.0.1:9/x.js"></script>', "asks for"),
                ('<p class="math">x</p>', "formula"), ('<button popovertarget="x">x</button>', "opens nothing"), ("", None)]:
            self.write("pages/a.html", page + broken)
            tab.open("file://" + os.path.join(self.root, "pages/a.html"))
            found = tab.evaluate(browse.LOOK) + browse.complaints(tab.events)
            if message:
                self.assertRegex(" ".join(found), message)
            else:
                self.assertEqual(found, [])


if __name__ == "__main__":
    with open(os.devnull, "w", encoding="utf-8") as quiet:
        runner = unittest.TextTestRunner(quiet if len(sys.argv) == 1 else sys.stderr)
        result = unittest.main(exit=False, testRunner=runner).result
    for _, error in result.failures + result.errors:
        print(error)
    for reason in sorted({reason for _, reason in result.skipped}):
        print("weaver     : skipped, " + reason)
    failed = len(result.failures) + len(result.errors)
    print(f"weaver     : {result.testsRun - failed - len(result.skipped)} of {result.testsRun} tests in order")
    sys.exit(0 if result.wasSuccessful() else 1)
