"""The numbers, captions and proof of the papers in TeX: what is written, and what is refused before TeX is called."""

import tempfile
import unittest

from lineage import ecsv, tex

from common import ROOT, WHOLE, Scratch, finding

GOOD = (r"\num{a.one} \both{a.one} \pub{a.one} \claimed{a.one} \num{sec1_demo/results/name=two/value} \cell{2.0}{sec1_demo/results/name=two/value} \tally{reproduced, assuming}"
        r" \meta{date} \wide{01} \gone{a.one} \cause{a.one}")


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
        self.assertEqual((tex.value("does not hold"), tex.worded("4 gamma/5")), ("does not hold", r"4 $\gamma$/5"))

    def test_a_value_and_its_error_in_one(self):
        """The digits are those of values.py, and the error counts in units of the last of them. Six digits may not reach
        it, and nothing stands in parentheses where nothing is uncertain, or nothing is known of it."""
        for one, both in [
                (finding(1.62422e-11, 3e-14), r"1.624(3)\times10^{-11}"), (finding(12345.6, 30.0), r"1.235(3)\times10^{4}"),
                (finding(16.4, 2.0), "16(2)"), (finding(9.97, 0.0961), "9.97(10)"), (finding(2e-5, 3e-4), r"2(30)\times10^{-5}"),
                (finding(1.6242247e-11, 8e-20), r"1.62422(1)\times10^{-11}"), (finding(3.0), "3"),
                (finding(0.0, 0.1), "0"), (finding(1.5, float("inf")), "2")]:
            self.assertEqual(tex.both(one), rf"\ensuremath{{{both}}}")


class Paper(Scratch):
    def test_what_the_papers_refer_to_is_defined(self):
        self.write("paper/paper.tex", GOOD + "\n% \\num{x}\n\\newcommand\\q[1]{\\num{#1}} 5\\% of \\num{a.one}\n")
        self.assertEqual(self.lineage("macros")[0], 0)
        numbers = self.read("build/paper/numbers.tex")
        for line in [r"\define{num}{a.one}{\ensuremath{1.000}}", r"\define{cell}{2.0@sec1_demo/results/name=two/value}{\ensuremath{2.0} $\pm$ \ensuremath{0.1}}", r"\define{fig}{01}{fig01}", r"\define{cause}{a.one}{their ruler}",
                     r"\define{both}{a.one}{\ensuremath{1.000(1)}}", r"\define{pub}{a.one}{1.02}", r"\define{tally}{discrepant}{1}",
                     r"\define{caption}{01}{A line. (a--c) At $t = \frac12$.}", r"\define{claimed}{a.one}{one}",
                     r"\define{source}{01}{\nolinkurl{src/sec1_demo.cpp}}"]:
            self.assertIn(line + "\n", numbers)

    def test_a_reference_to_nothing_is_named(self):
        self.write("paper/paper.tex", "\\both{a.three} \\num{a.three} 5\\% of \\pub{sec1_demo.x}\n\\own{08} \\cause{a.two}\n"
                                      "Figs.~01, x06\nand 05\n")
        self.refuses("macros", r"\num{a.three}", r"\both{a.three}", r"\pub{sec1_demo.x}", r"\cause{a.two}", "figure 05", "figure 08",
                     "figure x06")
        self.assertFalse((self.root / "build/paper").exists())
        self.write("paper/paper.tex", GOOD)
        self.change("paper/converged.ecsv", "a.one", "a.none")
        self.refuses("macros", "\\num{a.one} refers to nothing")

    def test_every_discrepant_claim_has_its_row(self):
        for text, words in [("None.", "the discrepant claim 'a.one' has no row"), (r"% \gone{a.one}", "'a.one' has no row"),
                            (r"\gone{a.one}\gone{a.two}", "'a.two' has a row \\gone but is not discrepant")]:
            self.write("paper/paper.tex", text)
            self.refuses("macros", words)

    def test_the_theorem_comes_from_its_chapter(self):
        prose = (f"/**\nA theorem.\n\n## {tex.FROM}\n\nWe *look $a_1$ up* in **L**, `a_b`, [3.1e-5](statement:a.one), 5 % – so:\n$$x*y$$\nof $x*z$. */\n"
                 "int x;\n/**\nMore.\n\n## The proof\n\n1. *One*: first,\n   still.\n2. Two.\n\n- A.\n\nThe end. $\\square$ */\nint y;\n"
                 f"/**\n## {tex.TO}\n\nWaves. */\n")
        ought = (f"\\section{{{tex.FROM}}}\nWe \\emph{{look $a_1$ up}} in \\textbf{{L}}, \\texttt{{a\\_b}}, \\ensuremath{{3.1\\times10^{{-5}}}}, 5 \\% -- so:\n"
                 "\\[x*y\\]\nof $x*z$.\n\nMore.\n\n\\section{The proof}\n"
                 "\\begin{enumerate}\n\\item \\emph{One}: first,\n   still.\n\\item Two.\n\\end{enumerate}\n\n"
                 "\\begin{itemize}\n\\item A.\n\\end{itemize}\n\nThe end. $\\square$\n")
        self.assertEqual(tex.theorem(self.root), "")  # its chapter may be left out
        self.write(f"src/{tex.THEOREM}.cpp", prose)
        self.assertEqual(tex.theorem(self.root), tex.HEAD + ought)
        for text, words in [(prose.replace(tex.TO, "Others"), "no prose from"),
                            (prose.replace("**L**", "**L"), "a mark that tools/lineage/tex.py does not know")]:
            self.write(f"src/{tex.THEOREM}.cpp", text)
            with self.assertRaisesRegex(ecsv.Fault, words):
                tex.theorem(self.root)


class Here(unittest.TestCase):
    def test_the_papers_refer_to_what_is_there(self):
        with tempfile.TemporaryDirectory() as folder:
            tex.write(ROOT, folder)  # a Fault else

    @unittest.skipUnless(WHOLE, "volume two is not there")
    def test_the_theorem_is_whole(self):
        """All steps of its proof, with their formulas, and no mark of Markdown is left."""
        text = tex.theorem(ROOT).replace(tex.HEAD, "")
        for step in ("Bounds", "No vanishing", "No dichotomy", "A maximum", "Its equation", "Smoothness and decay", "Least action"):
            self.assertIn(rf"\emph{{{step}", text)
        self.assertEqual((text.count("$") % 2, text.count("\0"), text.count("square")), (0, 0, 1))
