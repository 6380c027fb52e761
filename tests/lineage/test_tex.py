"""The numbers, captions and proof of the report in TeX: what is written, and what is refused before TeX is called."""

import tempfile
import unittest

from lineage import ecsv, metadata, refresh, tex
from lineage.volumes import joined, volumes

from common import FIGURES, ROOT, WHOLE, Scratch, finding, table

GOOD = (r"\num{a.one} \err{a.one} \both{a.one} \about{a.one} \pub{a.one} \claimed{a.one} \num{sec1_demo.fact} \fig{01}"
        r" \tally{reproduced, assuming} \meta{code} \wide{01} \gone{a.one}{cause}")


class Words(unittest.TestCase):
    def test_numbers_and_words_become_tex(self):
        for shown, ought in [("0.000", "0.000"), ("-0.000544490", r"-5.44490\times10^{-4}"), ("-0.53", "-0.53"),
                             ("0.0002", r"2\times10^{-4}"), ("0.006542", "0.006542")]:
            self.assertEqual(tex.value(shown), rf"\ensuremath{{{ought}}}")
        for plain, ought in [("E_PN for omega_b = 1.1", r"$E_{\mathrm{PN}}$ for $\omega_{b}$ = 1.1"),
                             ("y_(1-n) = -y_n", "$y_{1-n}$ = $-y_{n}$"), ("c_c^2/2", "$c_{c}$$^{2}$/2"),
                             ("W = 1 - cos y, A(0) = -i well-known", "W = 1 $-$ cos y, A(0) = $-$i well-known"),
                             ("24 sqrt(pi), sqrt(2), n -> -n", r"24 $\sqrt{\pi}$, $\sqrt{2}$, n $\to$ $-$n"),
                             ("epsilon = .9548e-3", r"$\epsilon$ = \ensuremath{.9548\times10^{-3}}"),
                             ("O(eps^-1/2), s >= 5 %", r"O($\epsilon$$^{-1/2}$), s $\ge$ 5 \%")]:
            self.assertEqual(tex.worded(plain), ought)
        self.assertEqual((tex.value("does not hold"), tex.unit("um")), ("does not hold", r"$\mu$m"))

    def test_a_value_and_its_error_in_one(self):
        """The digits are those of values.py, and the error counts in units of the last of them. Six digits may not reach
        it, and nothing stands in parentheses where nothing is uncertain, or nothing is known of it."""
        for one, both, about in [
                (finding(1.62422e-11, 3e-14), r"1.624(3)\times10^{-11}", r"1.62\times10^{-11}"),
                (finding(12345.6, 30.0), r"1.235(3)\times10^{4}", r"1.23\times10^{4}"), (finding(16.4, 2.0), "16(2)", "16"),
                (finding(9.97, 0.0961), "9.97(10)", "9.97"), (finding(2e-5, 3e-4), r"2(30)\times10^{-5}", r"2\times10^{-5}"),
                (finding(1.6242247e-11, 8e-20), r"1.62422(1)\times10^{-11}", r"1.62\times10^{-11}"), (finding(3.0), "3", "3"),
                (finding(2e-14, 2e-14, kind="residue"), r"2\times10^{-14}", r"2\times10^{-14}"), (finding(0.0, 0.1), "0", "0"),
                (finding(1.5, float("inf")), "2", "2")]:
            self.assertEqual((tex.both(one), tex.about(one)), (rf"\ensuremath{{{both}}}", rf"\ensuremath{{{about}}}"))


class Paper(Scratch):
    def test_what_the_report_refers_to_is_defined(self):
        self.write("paper/paper.tex", GOOD + "\n% \\num{x}\n\\newcommand\\q[1]{\\num{#1}} 5\\% of \\num{a.one}\n")
        self.assertEqual(self.lineage("macros")[0], 0)
        numbers, claims = self.read("build/paper/numbers.tex"), self.read("build/paper/claims.tex")
        for line in [r"\define{num}{a.one}{\ensuremath{1.000}}", r"\define{err}{a.one}{\ensuremath{0.001}}", r"\define{fig}{01}{fig01}",
                     r"\define{both}{a.one}{\ensuremath{1.000(1)}}", r"\define{pub}{a.one}{1.02}", r"\define{tally}{discrepant}{1}",
                     r"\define{caption}{01}{A line.}", r"\define{chapter}{sec1_demo}{}", r"\define{claimed}{a.one}{one}",
                     r"\define{source}{01}{\href{../src/sec1_demo.cpp}{\nolinkurl{src/sec1_demo.cpp}}}"]:
            self.assertIn(line + "\n", numbers)
        self.assertNotIn(r"\claim{a.one}", claims)  # it is in the table of those that do not survive
        self.assertIn(r"\claim{a.two}{two \emph{(of 1.000, Section~\ref{wells})}}{--}{}{holds}", claims)
        self.judged("reproduced, assuming")
        self.write("paper/paper.tex", r"\wide{01}")
        self.assertEqual(self.lineage("macros")[0], 0)
        self.assertIn(r"\claim{a.one}{one}{1.02}{\ensuremath{1.000(1)} m}{assuming}", self.read("build/paper/claims.tex"))
        meta = metadata.read(ROOT) | {"codeRepository": "https://a.org/b"}
        self.assertIn(r"\href{https://a.org/b/blob/HEAD/src/sec1_demo.cpp}", tex.source("src/sec1_demo.cpp", meta))

    def test_a_reference_to_nothing_is_named(self):
        self.write("paper/paper.tex", "\\both{a.three} \\num{a.three} 5\\% of \\pub{sec1_demo.fact}\n\\fig{08} \\num{a.three}\n")
        self.refuses("macros", r"\fig{08}", r"\num{a.three}", r"\both{a.three}", r"\pub{sec1_demo.fact}")
        self.assertFalse((self.root / "build/paper").exists())
        self.write("paper/paper.tex", GOOD)
        self.change("paper/converged.ecsv", "sec1_demo,one", "sec1_demo,none")
        self.refuses("macros", "\\num{a.one} refers to nothing")
        self.write("paper/paper.tex", r"\wide{01} \gone{a.one}{cause}")
        self.refuses("macros", "there is no reference value for the claim 'a.one'")

    def test_what_the_documents_leave_out_or_show_twice_is_named(self):
        self.write("figures/figures.ecsv", table(FIGURES, [
            [id, "", "1", "sec1_demo", f"{id}.gp", "ER", "facts", "A line."] for id in ("01", "02", "x03", "x04")]))
        good = {"paper": "\\wide[0.6]{01}\\gone{a.one}{they erred} (Fig.~x03)\n\\input{numbers}\n\\newcommand\\gone[2]{\\num{#1}}",
                "supplement": "\\pair{02}{x03}\n\\input{more}\n", "more": "\\own{x04}\n", "theorem": "None here.\n"}
        for name, old, new, words in [
                ("paper", "", "", None), ("paper", "\\wide", "% \\wide", "figure 01 of figures/figures.ecsv is not shown"),
                ("more", "", "\\pair{x04}{02}", "figure 02 is shown 2 times (supplement, supplement); figure x04 is shown 2 times"),
                ("theorem", "None", "See Figs.~01, x06\nand 05.", "figure 05 is cited but not in figures/figures.ecsv; figure x06"),
                ("supplement", "\\input", "% \\input", "more.tex: it is read by none of paper.tex, supplement.tex, theorem.tex"),
                ("supplement", "\n", "\\gone{a.two}{none}\n", "'a.two' has a row \\gone but is not discrepant")]:
            for file, text in (good | {name: good[name].replace(old, new, 1)}).items():
                self.write(f"paper/{file}.tex", text)
            if words:
                self.refuses("macros", words)
            else:
                self.assertEqual(self.lineage("macros"), (0, "", ""))

    def test_the_proof_comes_from_its_chapter(self):
        prose = ("/**\n## The proof\n\nWe *look $a_1$ up* in **L**, `a_b`, [3.1](num:a.one), 5 % – so:\n$$x*y$$\nof $x*z$.\n\n"
                 "1. *One*: first,\n   still.\n2. Two.\n\n- A.\n\nThe end. $\\square$ */\nint x;\n/** More. */\n")
        ought = ("We \\emph{look $a_1$ up} in \\textbf{L}, \\texttt{a\\_b}, \\num{a.one}, 5 \\% -- so:\n\\[x*y\\]\nof $x*z$.\n\n"
                 "\\begin{enumerate}\n\\item \\emph{One}: first,\n   still.\n\\item Two.\n\\end{enumerate}\n\n"
                 "\\begin{itemize}\n\\item A.\n\\end{itemize}\n\nThe end.\n")
        self.assertEqual(tex.proof(self.root), "")  # its chapter may be left out
        self.write(f"src/{tex.PROOF}.cpp", prose)
        self.assertEqual(tex.proof(self.root), tex.HEAD + ought)
        for text, words in [(prose.replace("$\\square$", ""), "0 blocks of prose end with"), (prose * 2, "2 blocks"),
                            (prose.replace("**L**", "**L"), "a mark that tools/lineage/tex.py does not know")]:
            self.write(f"src/{tex.PROOF}.cpp", text)
            with self.assertRaisesRegex(ecsv.Fault, words):
                tex.proof(self.root)

    def test_captions(self):
        self.write("paper/captions.tex", "% first\n\\see{01}{(a--c) At~$x = \\frac{1}{2}$\nand so on.}\n\\see{x09}{Gone.}\n")
        said = tex.captions(self.root)
        self.assertEqual(said, {"01": r"(a--c) At~$x = \frac{1}{2}$ and so on.", "x09": "Gone."})
        self.assertEqual(tex.in_markdown(said["01"]), "(a–c) At\u00a0$x = \\frac{1}{2}$ and so on.")
        for wrong in (r"\num{a.one}", "5 & 6", "$x", "a_b"):
            self.assertRaises(ecsv.Fault, tex.in_markdown, wrong)
        for wrong, words in [("\\see{01}{One.}\n\\see{01}{Two.}\n", "figure 01 has two captions"),
                             ("\\see{01}{One.}\n\\sea{02}{Two.}\n", r"this is not of the form \see{number}{text}: \sea{02}")]:
            self.write("paper/captions.tex", wrong)
            self.refuses("macros", words)


class Here(unittest.TestCase):
    def test_the_report_refers_to_what_is_there(self):
        with tempfile.TemporaryDirectory() as folder:
            tex.write(ROOT, folder)  # a Fault else
        captions = joined(tex.captions, volumes(ROOT))
        self.assertEqual(set(captions) - set(joined(refresh.read_figures, volumes(ROOT))), set())
        self.assertTrue(all(map(tex.in_markdown, captions.values())))

    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_the_proof_is_whole(self):
        """All of its steps, with their formulas, and no mark of Markdown is left."""
        proof = tex.proof(ROOT).replace(tex.HEAD, "")
        for step in ("Bounds", "No vanishing", "No dichotomy", "A maximum", "Its equation", "Smoothness and decay"):
            self.assertIn(rf"\emph{{{step}", proof)
        self.assertEqual((proof.count("$") % 2, proof.count("\0")), (0, 0))
