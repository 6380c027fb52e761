"""C++ sources as a reader sees them: prose, code, and the line that names a number; then the sources, figures and pages of
this repository: nothing that they name is missing, and they keep the shape that CONTRIBUTING.md asks for."""

import re
import unittest

from lineage import ecsv, sources
from lineage.claims import read_claims
from lineage.lock import sources as sources_in
from lineage.refresh import read_figures
from lineage.volumes import below, joined, volumes

from common import ROOT, VOLUME, WHOLE, of_volume


class Sources(unittest.TestCase):
    def test_prose_and_code_in_turn_with_their_lines(self):
        self.assertEqual(sources.blocks_of("/**\n# T\n\nwords */\n\nint x;\n\n/** more\nwords. */\nint y;\n"),
                         [(True, 1, "\n# T\n\nwords"), (False, 6, "int x;"), (True, 8, "more\nwords."), (False, 10, "int y;")])
        self.assertEqual(sources.blocks_of("  /**\n  One\n    deep */\n  int x;")[0][2], "\nOne\n  deep")
        self.assertEqual([prose for prose, *_ in sources.blocks_of("/* a */ int x; /// b\n/**/ int y;")], [False])
        for wrong in ("/**\nwords\n", "/** words */ int x;\n"):
            with self.assertRaisesRegex(ecsv.Fault, "a.cpp:1: a block of prose without its own end"):
                sources.blocks_of(wrong, "a.cpp")

    def test_definitions_begin_a_line(self):
        text = ("struct Well {\n  int inner() { return 1; }\n};\ntemplate <class T>\nT sup(const V<T>& x) {\n  return f(x);\n}\n"
                "using History = int;\ninline constexpr double fit_from = 20;\ntemplate <class T> struct Shot {};\n")
        self.assertEqual(sources.definitions(text), {"Well": 1, "sup": 5, "History": 8, "fit_from": 9, "Shot": 10})

    def test_every_source_is_in_the_book(self):
        known, rest = sources.sources_of(ROOT, volumes(ROOT), ["sec1_the_chain"])
        there = known + [s for module in rest.values() for s in module]
        self.assertEqual({s.path for s in there},
                         {str(p.relative_to(ROOT)) for folder in volumes(ROOT) for p in (folder / "src").rglob("*.[chi]pp")})
        self.assertEqual(len(there), len({s.page for s in there}))


LAST_EQUATION = 39
TYPE = re.compile(r"(?:struct|class|enum class|enum|using) (\w+)(?: [^<\n]*)?(?: \{|=.*)")


def unreadable(text):
    """No page of code is without a title (40 lines without a comment of their own, or the id of a statement), no function has more than 60 lines,
    and two blocks of prose have code between them. Empty and preprocessor lines are not counted."""
    blocks = [block for block in sources.blocks_of(text) if block[0] or re.search(r"^\s*[^#\s]", block[2], re.M)]
    for (prose, line, _), (follows, *_) in zip(blocks, blocks[1:]):
        if prose and follows:
            yield f"line {line}: no code before the next block of prose"
    for _, line, code in (block for block in blocks if not block[0]):
        for piece in re.split(r"^(?:\s*//|STATEMENT\().*\n", code, flags=re.M):
            if (count := len(re.findall(r"^\s*[^#\s]", piece, re.M))) > 40:
                yield f"line {line}: {count} lines of code without a title"
    for function in re.findall(r"^(?!struct|class|enum|union|namespace|extern)\w.*\{\n(?s:.*?)^\}", text, re.M):
        if (count := len(re.findall(r"^ +(?!//|\s)", function, re.M))) > 60:
            yield f"{function.splitlines()[0]}: {count} lines"


def foreign(path, text):
    """Includes by which a file of a section reaches for the code of another one. Commands may take from every one."""
    home = path.split("/")[1]
    return [name for name in re.findall(r'^#include "(\w+)/', text, re.M) if name not in ("lattice", "report")
            and not home.startswith(name) and not (home == "commands" and name.startswith("sec"))]


@of_volume
class Here(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = {str(path.relative_to(VOLUME)): ecsv.text_of(path) for path in sources_in(VOLUME)}
        cls.headers = {path: text for path, text in cls.texts.items() if path.endswith(".hpp")}

    def none(self, found):
        self.assertEqual(list(found), [])

    def test_they_keep_their_shape(self):
        self.none(f"{path}: {what}" for path, text in self.texts.items() for what in unreadable(text))
        self.none(f"{path} -> {name}" for path, text in self.texts.items() if re.match(r"src/(sec\w+|commands)/", path)
                  for name in foreign(path, text))

    def test_every_name_that_a_header_offers_is_explained_and_no_type_has_two_homes(self):
        """All are in one namespace, so that whoever includes two headers could not compile."""
        homes = {}
        for path, text in self.headers.items():
            for name, line in sources.definitions(text).items():
                paragraph = "\n".join(text.split("\n")[:line]).rpartition("\n\n")[2]
                self.assertRegex(paragraph, r"//|\*/(\n|$)", f"{path}:{line}: {name}")
            for found in filter(None, map(TYPE.match, text.split("\n"))):
                homes.setdefault(found[1], set()).add(path)
        self.none(f"{name} in {' and '.join(sorted(where))}" for name, where in homes.items() if len(where) > 1)

    def test_every_header_of_the_library_refuses_what_changes_values(self):
        """It includes lattice/numerics/ieee.hpp by itself or through others."""
        left = {path.removeprefix("src/"): set(re.findall(r'^#include "(.*)"', text, re.M))
                for path, text in self.headers.items() if path.startswith("src/lattice/")}
        reached = {"lattice/numerics/ieee.hpp"}
        while more := {path for path, includes in left.items() if path not in reached and includes & reached}:
            reached |= more
        self.assertLessEqual(set(left), reached)

    def test_equations_have_the_articles_numbers(self):
        def these(*patterns):
            return {str(path.relative_to(VOLUME)): ecsv.text_of(path) for one in patterns for path in VOLUME.glob(one)}

        pages = self.texts | these("README.md", "figures/*.[gp]*")
        for path, text in (pages | these("tests/**/*.[ch]pp")).items():
            self.none(f"{path}: {found[0]}" for found in re.finditer(r"\bEqs?\.\s+(?:[a-z]\w*|\((\d+)\))", text)
                      if not found[1] or not 1 <= int(found[1]) <= LAST_EQUATION)

    def test_what_is_named_is_there(self):
        claims, figures = read_claims(VOLUME), joined(read_figures, below(VOLUME))
        claim = re.compile(rf"`((?:{'|'.join(sorted({id.split('.')[0] for id in claims}))})\.\w+)`")
        files = {path.name for home in below(VOLUME) for folder in ("src", "tests", "tools", "python", "book", "figures", "examples")
                 for path in (home / folder).rglob("*.*")} | {"CMakeLists.txt"}
        for path, text in self.texts.items():
            named = re.findall(r"\b[\w-]+\.(?:[hc]pp|py|sh|cmake)\b", re.sub(r"(?m)^#include <.*", "", text))
            self.none(f"{path}: there is no file {name}" for name in named if name not in files)
            self.none(f"{path}: {id}" for id in re.findall(r"\]\(fig:(\w+)\)", text) if id not in figures)
            self.none(f"{path}: {id}" for id in claim.findall(text) if id not in claims)
            self.none(f"{path}: a program names {id}" for id in re.findall(r'"(\w+\.\w+)"', text) if id in claims and "STATEMENT(" not in text)
        for page in (path for name in ("README", "CONTRIBUTING", "MAINTAINING") for path in VOLUME.glob(f"{name}.md")):
            for link in re.findall(r'(?:\]\(|src=")([^)"]+)[)"]', re.sub(r"(?ms)^```.*?^```", "", ecsv.text_of(page))):
                left_out = link.startswith("beyond/") and not WHOLE
                self.assertTrue(":" in link or link.startswith("#") or left_out or (VOLUME / link.partition("#")[0]).exists(), f"{page}: {link}")

    def test_every_figure_has_its_script_program_and_tables(self):
        for id, figure in read_figures(VOLUME).items():
            script = VOLUME / "figures" / figure["script"]
            self.assertTrue(script.exists() and f"src/{figure['program']}.cpp" in self.texts, id)
            self.assertLessEqual(set(re.findall(r"/(\w+)\.ecsv", ecsv.text_of(script))), set(figure["data"].split()), id)
            for name in figure["data"].split():
                text = ecsv.text_of(ROOT / "build/data" / figure["program"] / f"{name}.ecsv")
                columns, rows = ecsv.header_of(text)[0], ecsv.rows_of(text)
                self.assertTrue(len(rows) > 1 and all(column.description for column in columns), (id, name))
