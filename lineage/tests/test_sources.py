"""Nothing dangles: every figure has its script, program and tables, every claim and figure named in the prose exists, and
the sources keep the shape that CONTRIBUTING.md asks for. Each rule of shape is shown texts that are wrong."""

import re
import unittest

from lineage import chapters, ecsv
from lineage.claims import programs_of, read_claims
from lineage.lock import sources
from lineage.refresh import read_figures
from lineage.volumes import below, joined

from . import ROOT, VOLUME, WHOLE, of_volume

TYPE = re.compile(r"(struct|class|enum|union|namespace|extern|using|static_assert)\b")
DEFINED = re.compile(r"^(?:(?:struct|class|enum class|enum) (\w+)(?: [^<\n]*)?|using (\w+) =.*)$", re.M)
LAST_EQUATION = 39
# What we used to call what the field calls otherwise; none of these can be mistaken for plain English.
HOUSE_WORDS = re.compile(r"\b(?:wider types?|look-out|bereft|phase pair|switch-landing|nearly free|ledger|workshop|"
                         r"reduced curvature|wanders)\b", re.I)


def unreadable(text):
    """No page of code is without a title (40 lines without a comment of their own), no function has more than 60 lines,
    and two blocks of prose have code between them. Empty and preprocessor lines are not counted."""
    out, code, function, inside, seen = [], 0, None, False, False
    for number, line in enumerate(text.split("\n") + ["// the end"], 1):
        body, at_margin = line.strip(), not line.startswith((" ", "\t"))
        if not body:
            continue
        if not inside and body.startswith(("/**", "//")):
            if code > 40:
                out.append(f"line {number}: {code} lines of code without a title")
            inside = body.startswith("/**")
            if inside and seen and code == 0:
                out.append(f"line {number}: no code between two blocks of prose")
            seen, code = inside, 0
            body = body[3:]
        elif not inside and body[0] != "#":
            code += 1
            if at_margin and body[-1] == "{" and not TYPE.match(body):
                function = -1
            if function is not None:
                function += 1
            if at_margin and body[0] == "}":
                if function and function > 61:
                    out.append(f"line {number}: a function of {function - 1} lines")
                function = None
        if inside:
            inside = "*/" not in body
    return out


def in_sentences(text):
    """How many numbers a chapter quotes outside of the rows of tables."""
    return sum(line.count("](num:") for line in text.split("\n") if not line.startswith("|"))


def misquoted(text):
    """Citations of an equation by anything but a number that the article has."""
    return re.findall(r"\bEqs?\.\s+[a-z]\w*", text) + [
        found[0] for found in re.finditer(r"\bEqs?\.\s+\((\d+)\)", text) if not 1 <= int(found[1]) <= LAST_EQUATION]


def foreign_sections(file, text):
    """Includes by which a file of a section reaches for the code of another one. Commands may take from every one."""
    return [f"{file} -> {name}" for name in re.findall(r'^#include "(\w+)/', text, re.M)
            if name not in ("lattice", "report") and not file.split("/")[0].startswith(name) and not (file.startswith("commands/") and name.startswith("sec"))]


def defined_twice(texts):
    """Types that two headers define under one name. All are in one namespace, so that whoever includes both could
    not compile; most chapters include only one, and nobody notices."""
    home = {}
    for header, text in texts.items():
        for name in (a or b for a, b in DEFINED.findall(text)):
            home.setdefault(name, set()).add(header)
    return [f"{name} in {' and '.join(sorted(where))}" for name, where in home.items() if len(where) > 1]


def without(wanted, texts):
    """Headers that include `wanted` neither by themselves nor through others."""
    reached = {wanted}
    while more := {name for name, text in texts.items() if name not in reached
                   and reached & set(re.findall(r'^#include "(.*)"', text, re.M))}:
        reached |= more
    return sorted(set(texts) - reached)


class Rules(unittest.TestCase):
    def test_prose_and_code_are_counted(self):
        def block(n):
            return "/**\n" + "words\n" * n + "*/\n"

        x, long = "x;\n", "x;\n" * 41
        for text, count in [(block(30) + x * 40 + block(1) + x * 40, 0), (block(1) + long, 1),
                            (block(1) + long + block(1) + x, 1), (block(1) + x * 40 + "// A title\n" + x * 40, 0),
                            (block(1) + x * 40 + "y;  // a remark\n", 1), (long + "  // Late\n" + x, 1), (block(1) * 2 + x, 1),
                            (block(1) + "\n#include <x>\n\n" + block(1) + x, 1), ("#include <x>\n" * 50 + block(1) + "x;\n\n" * 40, 0),
                            ("/** one line */\nx;\n/** another\n * line */\ny;\n", 0), ("/** one line */\n/** another */\ny;\n", 1)]:
            self.assertEqual(len(unreadable(text)), count, text)

    def test_numbers_in_sentences_are_counted(self):
        self.assertEqual(in_sentences("It is [1](num:a.b), [2](num:a.c).\n| row | [3](num:a.d) |\n"), 2)

    def test_a_long_function_is_seen(self):
        def function(head, count):
            return f"{head} {{\n" + "  x;\n" * (count // 2) + "  // Half way\n" + "  y;\n" * (count - count // 2) + "}\n"

        for text, count in [(function("void f()", 60), 0), (function("void f()", 61), 1), (function("struct S", 70), 0),
                            (function("void f()", 36) + function("void g()", 36), 0)]:
            self.assertEqual(len(unreadable(text)), count, text)

    def test_an_equation_without_its_number_is_seen(self):
        eq, eqs = "Eq", "Eqs"  # or this file would misquote
        for text, count in [(f"by {eq}. (24) and {eqs}. (1) and (39)", 0), (f"by {eq}. eqm, and", 1), (f"{eqs}.\nun1 and un2", 1),
                            (f"by {eq}. (40)", 1), (f"by {eq}. (0)", 1)]:
            self.assertEqual(len(misquoted(text)), count, text)

    def test_a_section_that_uses_another_one_is_seen(self):
        for file, name, count in [("sec4/a.cpp", "lattice/model/a.hpp", 0), ("sec4/a.cpp", "sec4/b.hpp", 0),
                                  ("sec33/a.cpp", "sec3/b.hpp", 0), ("sec3/a.cpp", "sec33/b.hpp", 1), ("sec4/a.cpp", "sec5/b.hpp", 1), ("sec4/a.cpp", "commands/b.hpp", 1),
                                  ("commands/a.cpp", "sec5/b.hpp", 0), ("commands/a.cpp", "commands/b.hpp", 0)]:
            self.assertEqual(len(foreign_sections(file, f'#include "{name}"\n')), count, (file, name))

    def test_one_name_for_two_types_is_seen(self):
        part = "struct Part {\n};\n"
        for one, two, count in [(part, part, 1), (part, "using Part = int;\n", 1), ("enum class Part { a, b };\n", "class Part : Whole {\n};\n", 1),
                                (part, "struct Whole {\n  struct Part {\n  };\n};\n", 0), (part, "struct Part;\nstruct Party {\n};\n", 0),
                                (part + part, "", 0)]:
            self.assertEqual(len(defined_twice({"a.hpp": one, "b.hpp": two})), count, (one, two))


@of_volume
class Here(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = {str(path.relative_to(VOLUME)): ecsv.text_of(path) for path in sources(VOLUME)}

    def none(self, found):
        self.assertEqual(list(found), [])

    def test_cases_of_the_article_are_called_after_claims(self):
        """The index of the README and the book leads from a claim to the line of its test."""
        tests, lines = chapters.article_tests(ROOT), ecsv.text_of(ROOT / "tests/article.cpp").split("\n")
        self.assertEqual(sorted(set(tests) - set(read_claims(ROOT))), [])
        self.assertGreater(len(tests), 50)
        self.assertTrue(all("TEST_CASE" in lines[line - 1] for line in tests.values()))

    def test_every_figure_has_its_script_program_and_tables(self):
        for id, figure in read_figures(VOLUME).items():
            script = VOLUME / "figures" / figure["script"]
            self.assertTrue(script.exists() and f"src/{figure['program']}.cpp" in self.texts, id)
            self.assertLessEqual(set(re.findall(r"/(\w+)\.ecsv", ecsv.text_of(script))), set(figure["data"].split()), id)
            for name in figure["data"].split():
                text = ecsv.text_of(ROOT / "build/data" / figure["program"] / f"{name}.ecsv")
                columns, rows = ecsv.header_of(text)[0], ecsv.rows_of(text)
                self.assertTrue(len(rows) > 1 and all(column.description for column in columns), (id, name))

    def test_every_chapter_has_its_cost(self):
        costs = chapters.read_costs(VOLUME)
        self.assertEqual(list(costs), programs_of(VOLUME))
        self.assertTrue(all(seconds >= 0 for seconds in costs.values()))

    def test_the_words_are_those_of_the_field(self):
        texts = {path.relative_to(VOLUME): ecsv.text_of(path) for pattern in ("*.md", "paper/*.tex", "paper/[cf]*.ecsv", "book/**/*.md",
                 "figures/*.[gp]*") for path in VOLUME.glob(pattern)}
        self.none(f"{path}: {word}" for path, text in (self.texts | texts).items() if str(path) != "CHANGELOG.md"
                  for word in HOUSE_WORDS.findall(text))
        self.assertEqual(HOUSE_WORDS.findall("Phase pair in a wider shape, a wider type"), ["Phase pair", "wider type"])

    def test_what_the_prose_names_is_there(self):
        claims, figures = read_claims(VOLUME), joined(read_figures, below(VOLUME))
        claim = re.compile(rf"`((?:{'|'.join(sorted({id.split('.')[0] for id in claims}))})\.\w+)`")
        for path, text in self.texts.items():
            self.none(f"{path}: {id}" for id in re.findall(r"\]\(fig:(\w+)\)", text) if id not in figures)
            self.none(f"{path}: {id}" for id in claim.findall(text) if id not in claims)

    def test_few_numbers_stand_in_sentences(self):
        """At most fourteen in a chapter of the article; the others are rows of tables."""
        self.none(f"{path}: {count} numbers in prose" for path, text in self.texts.items()
                  if VOLUME == ROOT and re.match(r"src/sec\w+\.cpp$", path) and (count := in_sentences(text)) > 14)

    def test_the_sources_keep_their_shape(self):
        self.none(f"{path}: {what}" for path, text in self.texts.items() for what in unreadable(text))
        self.none(defined_twice({path: text for path, text in self.texts.items() if path.endswith(".hpp")}))
        self.none(what for path, text in self.texts.items() if re.match(r"src/(sec\w+|commands)/", path)
                  for what in foreign_sections(path.removeprefix("src/"), text))

    def test_every_header_of_the_library_refuses_what_changes_values(self):
        self.assertEqual(without("a", {"a": "", "b": '#include "a"\n', "c": '#include "b"\n', "d": '#include <a>\n'}), ["d"])
        headers = {path.removeprefix("src/"): text for path, text in self.texts.items() if re.match(r"src/lattice/.*hpp$", path)}
        if headers:
            self.assertEqual(without("lattice/numerics/ieee.hpp", headers), ["lattice/model/instances.hpp"])  # which is no header

    def test_equations_are_cited_by_the_articles_numbers(self):
        for folder in ("src", "tests", "tools", "bench", "figures"):
            for path in sorted((VOLUME / folder).rglob("*.*")) + sorted(VOLUME.glob("READ*.md")):
                if path.suffix in (".cpp", ".hpp", ".py", ".gp", ".ecsv", ".md"):
                    self.none(f"{path}: {what}" for what in misquoted(ecsv.text_of(path)))

    def test_a_program_names_no_claim(self):
        claims = read_claims(VOLUME)
        self.none(f"{path}: {id}" for path, text in self.texts.items() for id in re.findall(r'"(\w+\.\w+)"', text) if id in claims)

    def test_the_pages_link_to_files_that_exist(self):
        for page in (path for name in ("README", "CONTRIBUTING") for path in VOLUME.glob(f"{name}.md")):
            for link in re.findall(r'(?:\]\(|src=")([^)"]+)[)"]', ecsv.text_of(page)):
                left_out = link.startswith("beyond/") and not WHOLE
                self.assertTrue(":" in link or link.startswith("#") or left_out or (VOLUME / link.partition("#")[0]).exists(), f"{page}: {link}")
