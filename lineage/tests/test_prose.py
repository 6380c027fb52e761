"""Numbers in prose, the tables of the pages, and the numbers of the paper."""

import re
import shutil
import subprocess
import tempfile
import unittest

from lineage import chapters, ecsv, lock, metadata, refresh, tex
from lineage.claims import program_of
from lineage.volumes import joined, volumes

from . import FIGURES, ROOT, VOLUME, WHOLE, Scratch, finding, of_volume, table


class Links(unittest.TestCase):
    def test_links_show_the_value_and_dangle_nowhere(self):
        numbers = {"pn.omega11": finding(1.62e-11, 1e-13), "p.x": finding(3)}
        prose = "is [](num:pn.omega11), and [17](num:p.x) of [these](fig:07), as `[](num:...)` says."
        ought = "is [1.62e-11](num:pn.omega11), and [3](num:p.x) of [these](fig:07), as `[](num:...)` says."
        self.assertEqual(refresh.with_numbers(prose, numbers), ought)
        self.assertEqual(refresh.with_numbers(ought, numbers), ought)
        row = "a\n| a | [](num:pn.omega11) | [](num:p.x) |\n"
        self.assertEqual(refresh.with_numbers(row, numbers), "a\n| a | [1.62e-11 ± 1e-13](num:pn.omega11) | [3](num:p.x) |\n")
        for bad in ("[](num:pn.omega12)", "](num:p.x)", "[](num:p.x"):
            with self.assertRaises(ecsv.Fault):
                refresh.with_numbers(bad, numbers)

    def test_a_page_shows_numbers_without_links(self):
        numbers = {"pn.omega11": finding(1.62e-11, 1e-13)}
        page = "It is <!--num:pn.omega11-->17<!--/-->, not 1.77e-11."
        ought = "It is <!--num:pn.omega11-->1.62e-11<!--/-->, not 1.77e-11."
        self.assertEqual(refresh.with_marked_numbers(page, numbers), ought)
        for bad in (page.replace("omega11", "omega12"), page.replace("<!--/-->", ""), page + "<!--/-->"):
            with self.assertRaises(ecsv.Fault):
                refresh.with_marked_numbers(bad, numbers)

    def test_a_page_gets_the_tables_for_which_it_has_marks(self):
        page = "a\n<!-- t -->\nold\n<!-- /t -->\nb\n"
        self.assertEqual(refresh.fresh_page(page, {"t": ["x", "y"], "u": []}), "a\n<!-- t -->\nx\ny\n<!-- /t -->\nb\n")
        for bad in (page.replace("t -->", "u -->"), page.replace("/t", "/s"), page + "<!-- /t -->", page * 2):
            with self.assertRaises(ecsv.Fault):
                refresh.fresh_page(bad, {"t": []})
        self.assertEqual(refresh.fresh_page(page, {"t": None}), page)

    def test_costs(self):
        self.assertEqual([chapters.shown_cost(s) for s in (float("nan"), 0.6, 2.5, 3.4)], ["?", "< 1", "3", "3"])


class Refreshing(Scratch):
    def test_modules_are_drawn_as_cmake_links_them(self):
        self.write("CONTRIBUTING.md", "<!-- modules -->\n<!-- /modules -->\n")
        self.lineage("refresh")
        self.assertEqual(self.read("CONTRIBUTING.md").count("\n"), 2)  # nothing is configured
        self.write("build/CMakeFiles/Export/1f/lattice-targets.cmake", "".join(
            f"add_library(lattice::{name} STATIC IMPORTED)\n\n  INTERFACE_LINK_LIBRARIES \"lattice::flags;{links}\"\n"
            for name, links in [("low", "m"), ("orbit", "lattice::low;lattice::mid;lattice::mid"), ("mid", "lattice::low")]))
        self.lineage("refresh")
        self.assertIn("```\norbit  mid\n\nmid    low\n\nlow\n```", self.read("CONTRIBUTING.md"))

    def test_only_what_is_stale_is_written(self):
        self.write("paper/claims.ecsv", self.read("paper/claims.ecsv").replace("they erred", "it is {sec1_demo.fact}"))
        self.assertEqual(self.lineage("refresh", "--check")[0], 1)
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertIn("It is [1.000](num:a.one).", self.read("src/sec1_demo.cpp"))
        self.assertIn("| `a.one` | 1.02 | 1.000 | it is 2.0 | [`build/bin/sec1_demo`](src/sec1_demo.cpp) (3 s) |",
                      self.read("README.md"))
        self.assertEqual(self.lineage("refresh", "--check"), (0, "", ""))
        self.write("build/report/cost/sec1_demo", "9.1\n")
        self.assertIn("renewed", self.lineage("refresh")[1])
        self.assertIn("(9 s)", self.read("README.md"))

    def test_the_tables_of_a_page_have_the_verdicts_that_were_given(self):
        self.judged("follows")
        self.write("README.md", self.read("README.md") + "<!-- summary -->\n<!-- /summary -->\n")
        self.assertEqual(self.lineage("refresh")[0], 0)
        self.assertEqual(re.findall(r"^\| (\w+) \| (\d+) \| \w", page := self.read("README.md"), re.M), [("holds", "1"), ("follows", "1")])
        self.assertNotIn("`a.one`", page)  # no longer discrepant

    def test_a_cost_is_renewed_when_it_has_really_moved(self):
        """And every program has one, whether it draws a figure or not."""
        self.write("src/sec2_new.cpp", "/**\n# 2 */\n")
        self.write("paper/costs.ecsv", table(["program", "seconds"], [["sec1_demo", 10.0], ["sec0_gone", 1.0]]))
        costs = chapters.renewed_costs(self.root, {"sec1_demo": 11.0, "sec2_new": 0.412})
        self.assertEqual(costs, {"sec1_demo": 10.0, "sec2_new": 0.41})
        self.assertEqual(chapters.renewed_costs(self.root, {"sec1_demo": 13.02})["sec1_demo"], 13)
        self.lineage("refresh")
        self.assertEqual(self.read("paper/costs.ecsv").splitlines()[-2:], ["sec1_demo,10", "sec2_new,nan"])

    def test_what_is_missed_names_the_chapters_that_explain_it(self):
        """Those whose facts the reason quotes, or the reason of a claim that it names: nobody types them."""
        claim = {"answer": "sec1_demo.x", "criterion": "", "covered_by": "", "reason": "As {sec2_why.fact} and {a.one}, by {sec1_demo.fact}."}
        claims = {"a.one": claim, "a.o": claim | {"reason": "No a.one_more."}, "b.two": claim | {"reason": "As for a.one: so."},
                  "c.three": claim | {"answer": "", "criterion": "sec3_own.y > 1", "reason": "", "covered_by": "b.two^2"}, "d": claim | {"reason": ""}}
        for id, programs in [("a.one", "sec1_demo sec2_why"), ("a.o", "sec1_demo"), ("b.two", "sec1_demo sec2_why"),
                             ("c.three", "sec3_own sec1_demo sec2_why"), ("d", "sec1_demo")]:
            self.assertEqual(chapters.explained_by(id, claims), programs.split(), id)

    def test_what_is_quoted_must_be_locked(self):
        self.write("src/sec1_demo.cpp", "/** [](num:sec1_demo.other) */\n")
        self.refuses("refresh", "src/sec1_demo.cpp: nothing is locked under 'sec1_demo.other'")
        self.write("src/sec1_demo.cpp", "")
        self.write("build/report/cost/sec1_demo", "soon")
        self.refuses("refresh", "cost/sec1_demo: no time in seconds")


class Paper(Scratch):
    def test_numbers_and_words_become_tex(self):
        for shown, ought in [("1.62422e-11", r"\ensuremath{1.62422\times10^{-11}}"), ("0.000", r"\ensuremath{0.000}"),
                             ("-0.000544490", r"\ensuremath{-5.44490\times10^{-4}}"), ("-0.53", r"\ensuremath{-0.53}"),
                             ("0.0002", r"\ensuremath{2\times10^{-4}}"), ("0.006542", r"\ensuremath{0.006542}"),
                             ("does not hold", "does not hold")]:
            self.assertEqual(tex.value(shown), ought)
        for plain, ought in [("E_PN for omega_b = 1.1", r"$E_{\mathrm{PN}}$ for $\omega_{b}$ = 1.1"),
                             ("y_(1-n) = -y_n", "$y_{1-n}$ = $-y_{n}$"), ("c_c^2/2", "$c_{c}$$^{2}$/2"),
                             ("W = 1 - cos y, A(0) = -i well-known", "W = 1 $-$ cos y, A(0) = $-$i well-known"),
                             ("24 sqrt(pi), sqrt(2), n -> -n", r"24 $\sqrt{\pi}$, $\sqrt{2}$, n $\to$ $-$n"),
                             ("epsilon = .9548e-3", r"$\epsilon$ = \ensuremath{.9548\times10^{-3}}"),
                             ("O(eps^-1/2), s >= 5 %", r"O($\epsilon$$^{-1/2}$), s $\ge$ 5 \%"),
                             ("1e-14 to 1e-15", r"\ensuremath{1\times10^{-14}} to \ensuremath{1\times10^{-15}}")]:
            self.assertEqual(tex.worded(plain), ought)
        self.assertEqual(tex.unit("um"), r"$\mu$m")

    def test_a_value_and_its_error_in_one(self):
        """The digits are those of values.py, and the error counts in units of the last of them."""
        for value, error, ought in [(1.62422e-11, 3e-14, r"1.624(3)\times10^{-11}"),
                                    (0.152519, 2e-4, "0.1525(2)"), (12345.6, 30.0, r"1.235(3)\times10^{4}"),
                                    (16.4, 2.0, "16(2)"), (-0.000162, 3e-6, r"-1.62(3)\times10^{-4}"),
                                    (9.97, 0.0961, "9.97(10)"), (2e-5, 3e-4, r"2(30)\times10^{-5}")]:
            self.assertEqual(tex.both(finding(value, error)), rf"\ensuremath{{{ought}}}")
        for one, ought in [(finding(0.00162601, 3e-9), "0.00163"), (finding(24934.6, 0.2), r"2.49\times10^{4}"), (finding(5.0), "5"),
                           (finding(2e-5, 3e-4), r"2\times10^{-5}"), (finding(0.07, 0.01), "0.07")]:
            self.assertEqual(tex.about(one), rf"\ensuremath{{{ought}}}")
        self.assertEqual(tex.about(finding(float("nan"), 0.1)), "nan")
        # Six digits do not reach the error: what was rounded off is less than a unit
        self.assertEqual(tex.both(finding(1.6242247e-11, 8e-20)), r"\ensuremath{1.62422(1)\times10^{-11}}")
        # Nothing in parentheses where nothing is uncertain, or nothing is known of it
        for one, ought in [(finding(3.0), "3"), (finding(2e-14, 2e-14, kind="residue"), r"2\times10^{-14}"),
                           (finding(0.0, 0.1), "0"), (finding(1.5, float("inf")), "2"), (finding(1.5, float("nan")), "2")]:
            self.assertEqual(tex.both(one), rf"\ensuremath{{{ought}}}")
        self.assertEqual(tex.both(finding(float("nan"), 0.1)), "nan")

    def test_a_reference_to_nothing_is_named(self):
        good = (r"\num{a.one} \err{a.one} \both{a.one} \about{a.one} \pub{a.one} \claimed{a.one} \num{sec1_demo.fact} \fig{01} \tally{reproduced, assuming}"
                r" \meta{code} \wide{01} \gone{a.one}{cause}")
        self.write("paper/paper.tex", good + "\n% \\num{x}\n\\newcommand\\q[1]{\\num{#1}} 5\\% of \\num{a.one}\n")
        self.assertEqual(self.lineage("macros")[0], 0)
        numbers, claims = self.read("build/paper/numbers.tex"), self.read("build/paper/claims.tex")
        for line in [r"\define{num}{a.one}{\ensuremath{1.000}}", r"\define{err}{a.one}{\ensuremath{0.001}}",
                     r"\define{both}{a.one}{\ensuremath{1.000(1)}}", r"\define{pub}{a.one}{1.02}", r"\define{fig}{01}{fig01}", r"\define{tally}{discrepant}{1}",
                     r"\define{caption}{01}{A line.}", r"\define{chapter}{sec1_demo}{}",
                     r"\define{claimed}{a.one}{one}", r"\define{meta}{version}{1.0.0}",
                     r"\define{meta}{text}{CC-BY-4.0}",
                     r"\define{source}{01}{\href{../src/sec1_demo.cpp}{\nolinkurl{src/sec1_demo.cpp}}}"]:
            self.assertIn(line + "\n", numbers)
        self.assertNotIn(r"\claim{a.one}", claims)  # it is in the table of those that do not survive
        self.assertIn(r"\claim{a.two}{two \emph{(of 1.000, Section~\ref{wells})}}{--}{}{holds}", claims)
        shutil.rmtree(self.root / "build/paper")
        self.write("paper/paper.tex", "\\both{a.three} \\num{a.three} 5\\% of \\pub{sec1_demo.fact}\n\\fig{08} \\num{a.three}\n")
        self.refuses("macros", r"\fig{08}", r"\num{a.three}", r"\both{a.three}", r"\pub{sec1_demo.fact}")
        self.assertFalse((self.root / "build/paper").exists())
        self.write("paper/paper.tex", good)
        self.write("paper/more.tex", "% chapter: sec9_none\n\\num{a.three}\n")
        self.assertEqual(self.lineage("macros")[0], 0)
        self.write("paper/paper.tex", r"\wide{01} \gone{a.one}{cause}")
        self.write("paper/converged.ecsv", self.read("paper/converged.ecsv").replace("sec1_demo,one", "sec1_demo,none"))
        self.refuses("macros", "nothing is locked for the claim 'a.one'")

    def test_a_claim_that_agrees_has_its_row(self):
        self.judged("reproduced, assuming")
        self.write("paper/claims.ecsv", self.read("paper/claims.ecsv").replace("1.02", "1.00"))
        self.write("paper/paper.tex", r"\wide{01}")
        self.assertEqual(self.lineage("macros")[0], 0)
        self.assertIn(r"\claim{a.one}{one}{1.00}{\ensuremath{1.000(1)} m}{assuming}",
                      self.read("build/paper/claims.tex"))
        self.assertIn(r"\define{tally}{reproduced, assuming}{1}", self.read("build/paper/numbers.tex"))

    def test_what_the_paper_leaves_out_is_named(self):
        whole = "\\wide[0.6]{01}\n\\gone{a.one}{they erred}\n\\newcommand\\gone[2]{\\num{#1}} (Fig.~01).\n"
        self.write("paper/supplement.tex", whole)
        self.assertEqual(self.lineage("macros"), (0, "", ""))
        for paper, words in [(whole.replace("\\wide", "% \\wide"), "figure 01 of figures/figures.ecsv is not shown"),
                             (whole + "\\pair{01}{02}", "figure 01 is shown 2 times"),
                             (whole + "See Figs.~01, x02\nand 03.",
                              "figure 03 is cited and not in figures/figures.ecsv; figure x02"),
                             (whole.replace("\\gone{a.one}", "\\num{a.one}"), "claim 'a.one' has no row"),
                             (whole + "\\gone{a.two}{none}", "'a.two' has a row \\gone and is not discrepant")]:
            self.write("paper/supplement.tex", paper)
            self.refuses("macros", words)

    def test_every_figure_is_in_one_of_the_documents(self):
        self.write("figures/figures.ecsv", table(FIGURES, [
            [id, "", "1", "sec1_demo", f"{id}.gp", "ER", "facts", "A line."] for id in ("01", "02", "x03", "x04")]))
        good = {"paper": "\\wide{01}\\gone{a.one}{they erred} (Fig.~x03)\n\\input{numbers}",
                "supplement": "\\pair{02}{x03}\n\\input{more}\n", "more": "\\own{x04}\n", "theorem": "None here.\n"}
        gone = good | {"more": "% chapter: sec9_none\n\\own{x04}\n"}
        for texts, words in [
                (good, None), (good | {"paper": good["paper"].replace("\\wide{01}", "")}, "figure 01 of figures/figures.ecsv is not"),
                (good | {"theorem": "\\wide{02}"}, "figure 02 is shown 2 times (supplement, theorem)"),
                (good | {"supplement": good["supplement"] + "\\own{02}"}, "figure 02 is shown 2 times (supplement, supplement)"),
                (good | {"theorem": "(Fig.~x05)"}, "figure x05 is cited and not in figures/figures.ecsv"),
                (good | {"supplement": "\\pair{02}{x03}"}, "more.tex: none of paper.tex, supplement.tex, theorem.tex reads it"),
                (good | {"supplement": "\\pair{02}{x03}% \\input{more}"}, "more.tex: none of"),
                (gone, "figure x04 of figures/figures.ecsv is not shown"),
                (good | {"more": "\\own{x04}\\num{a.three}"}, "paper/more.tex: nothing is there for \\num{a.three}"),
                (good | {"supplement": good["supplement"] + "\\gone{a.two}{none}"}, "'a.two' has a row \\gone")]:
            for name, text in texts.items():
                self.write(f"paper/{name}.tex", text)
            if words:
                self.refuses("macros", words)
            else:
                self.assertEqual(self.lineage("macros"), (0, "", ""))

    def test_a_caption_links_its_chapter_where_the_repository_is(self):
        meta = metadata.read(ROOT)
        self.assertIn(r"\href{../src/sec1_demo.cpp}", tex.source("src/sec1_demo.cpp", meta | {"codeRepository": ""}))
        self.assertEqual(tex.source("src/sec1_demo.cpp", meta | {"codeRepository": "https://a.org/b"}),
                         r"\href{https://a.org/b/blob/HEAD/src/sec1_demo.cpp}{\nolinkurl{src/sec1_demo.cpp}}")

    def test_the_proof_comes_from_its_chapter(self):
        prose = ("/**\n## The proof\n\nWe *look $a_1$ up* in **L**, `a_b`, [3.1](num:a.one), 5 % – so:\n$$x*y$$\nof $x*z$.\n\n"
                 "1. *One*: first,\n   still.\n2. Two.\n\n- A.\n\nThe end. $\\square$ */\nint x;\n/** More. */\n")
        ought = ("We \\emph{look $a_1$ up} in \\textbf{L}, \\texttt{a\\_b}, \\num{a.one}, 5 \\% -- so:\n\\[x*y\\]\nof $x*z$.\n\n"
                 "\\begin{enumerate}\n\\item \\emph{One}: first,\n   still.\n\\item Two.\n\\end{enumerate}\n\n"
                 "\\begin{itemize}\n\\item A.\n\\end{itemize}\n\nThe end.\n")
        self.assertEqual(tex.proof(self.root), "")  # its chapter may be left out
        for text, words in [(prose, None), (prose.replace("$\\square$", ""), "0 blocks of prose end with"), (prose * 2, "2 blocks"),
                            (prose.replace("**L**", "**L"), "a mark that is not known"),
                            (prose.replace("[3.1]", "![a](fig:01) [3.1]"), "a mark that is not known"),
                            (prose.replace("The end", "a < b"), "a mark that is not known")]:
            self.write(f"src/{tex.PROOF}.cpp", text)
            if words:
                with self.assertRaisesRegex(ecsv.Fault, words):
                    tex.proof(self.root)
            else:
                self.assertEqual(tex.proof(self.root), tex.HEAD + ought)

    def test_captions(self):
        self.write("paper/captions.tex",
                   "% first\n\\see{01}{(a) A line of slope $\\frac{1}{2}$\nand so on.}\n\\see{x09}{Gone.}\n")
        self.assertEqual(tex.captions(self.root), {"01": r"(a) A line of slope $\frac{1}{2}$ and so on.", "x09": "Gone."})
        self.write("paper/paper.tex", "\\wide{01}\\gone{a.one}{cause}")
        for wrong, words in [("\\see{01}{One.}\n\\see{01}{Two.}\n", "figure 01 has two captions"),
                             ("\\see{01}{One.}\n\\sea{02}{Two.}\n", r"this is no \see{number}{text}: \sea{02}")]:
            self.write("paper/captions.tex", wrong)
            self.refuses("macros", words)

    @unittest.skipUnless(shutil.which("latexmk"), "latexmk is not installed (make install-paper)")
    def test_tex_stops_at_a_missing_number(self):
        tex.write(ROOT, self.root / "good")
        preamble = ecsv.text_of(ROOT / "paper/paper.tex").split(r"\begin{document}")[0] + "\\begin{document}\n"

        def typeset(sentence):
            self.write("one.tex", f"{preamble}{sentence}\n\\end{{document}}\n")
            return subprocess.run(["latexmk", "-norc", "-g", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "one.tex"],
                                  cwd=self.root, capture_output=True, text=True, errors="replace", check=False,
                                  env={"PATH": "/usr/bin:/bin", "HOME": str(self.root),
                                       "TEXINPUTS": f"{self.root}/good:{ROOT}/paper:{ROOT}/beyond/paper:"})

        run = typeset(r"It is \num{pn.omega11}.")
        self.assertEqual(run.returncode, 0, run.stdout[-2000:])
        self.assertNotEqual(typeset(r"It is \num{pn.omega12}.").returncode, 0)
        self.assertIn("nothing is there for num pn.omega12", (self.root / "one.log").read_text(errors="replace"))


class ThisRepository(unittest.TestCase):
    """Its prose quotes the locked values, its pages show today's tables, and the lock keeps to its rule."""

    @of_volume
    def test_nothing_is_stale(self):
        stale = [str(path) for path, text in refresh.fresh_texts(VOLUME, {}) if text != ecsv.text_of(path)]
        self.assertEqual(stale, [], "make refresh")

    def test_every_discrepancy_names_its_chapters(self):
        """With command and cost."""
        claims, costs = lock.read_claims(ROOT), chapters.read_costs(ROOT)
        readme, known = ecsv.text_of(ROOT / "README.md"), lock.programs_of(ROOT)
        for id in (id for id, claim in claims.items() if claim["reason"]):
            see = refresh.see(id, claims, costs, chapters.read_commands(ROOT))
            if claims[id]["status"] == "discrepant":
                self.assertIn(f"{see} |", readme)
            for program in chapters.explained_by(id, claims):
                self.assertIn(program, known)
                self.assertIn(f"[`build/bin/{program}`](src/{program}.cpp) ({chapters.shown_cost(costs[program])} s)", see)

    def test_every_table_has_a_place(self):
        claims, costs = lock.read_claims(ROOT), chapters.read_costs(ROOT)
        numbers = refresh.by_name(lock.read_lock(ROOT), claims)
        pages = "".join(ecsv.text_of(ROOT / name) for name in refresh.PAGES)
        for name in refresh.generated_tables(ROOT, claims, numbers, costs):
            self.assertIn(f"<!-- {name} -->", pages)

    def test_the_paper_refers_to_what_is_there(self):
        with tempfile.TemporaryDirectory() as folder:
            tex.write(ROOT, folder)  # a Fault else
        self.assertEqual(set(joined(tex.captions, volumes(ROOT))) - set(joined(refresh.read_figures, volumes(ROOT))), set())

    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_the_proof_is_whole(self):
        """All of its steps, with their formulas, and no mark of Markdown is left."""
        proof = tex.proof(ROOT).replace(tex.HEAD, "")
        for step in ("Bounds", "No vanishing", "No dichotomy", "A maximum", "Its equation", "Smoothness and decay"):
            self.assertIn(rf"\emph{{{step}", proof)
        self.assertEqual(proof.count("$") % 2, 0)
        self.assertNotIn("\0", proof)

    def test_what_is_claimed_and_quoted_is_locked(self):
        known = {f"{program}.{id}" for program, id in joined(lock.read_lock, volumes(ROOT))}
        self.assertEqual(lock.quoted(ROOT) - known, set())

    def test_the_article_needs_nothing_of_the_second_volume(self):
        """Its claims, findings, commands and its paper quote its own numbers, and its own programs answer."""
        claims, programs = lock.read_claims(ROOT), set(lock.programs_of(ROOT))
        own = set(refresh.by_name(lock.read_lock(ROOT), claims))
        quoted = set(chapters.read_commands(ROOT)).union(*map(lock.quoted_in, [*claims.values(), *lock.read_findings(ROOT).values()]))
        for path in (ROOT / "paper").glob("*.tex"):
            quoted |= set(re.findall(r"\\(?:num|err|both|about)\{([^}#]+)\}", lock.uncommented(ecsv.text_of(path))))
        self.assertEqual(quoted - own, set())
        self.assertEqual(set(map(program_of, claims.values())) - programs, set())
        self.assertEqual({command.split()[0].split("/")[-1] for command, _ in chapters.read_commands(ROOT).values()} - programs, set())

    @of_volume
    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_the_lock_holds_what_is_claimed_quoted_or_a_headline(self):
        locked, names = lock.read_lock(VOLUME), lock.quoted(VOLUME)
        self.assertGreater(len(locked), 100)
        self.assertEqual([key for key, f in locked.items() if not lock.is_kept(f, names)], [], "make lock")
