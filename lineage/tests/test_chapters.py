"""Which chapters explain a claim, what they cost, where a claim is tested, and the commands that compute one number."""

import unittest
from unittest import mock

from lineage import chapters, ecsv, refresh
from lineage.claims import by_name, program_of, programs_of, read_claims
from lineage.lock import quoted, read_lock
from lineage.volumes import joined, volumes

from . import ROOT, VOLUME, Scratch, of_volume, table


class Chapters(Scratch):
    def test_a_cost_is_renewed_when_it_has_really_moved(self):
        """And every program has one, whether it draws a figure or not."""
        self.write("src/sec2_new.cpp", "/**\n# 2 */\n")
        self.write("paper/costs.ecsv", table(["program", "seconds"], [["sec1_demo", 10.0], ["sec0_gone", 1.0]]))
        costs = chapters.renewed_costs(self.root, {"sec1_demo": 11.0, "sec2_new": 0.412})
        self.assertEqual(costs, {"sec1_demo": 10.0, "sec2_new": 0.41})
        self.assertEqual(chapters.renewed_costs(self.root, {"sec1_demo": 13.02})["sec1_demo"], 13)
        self.lineage("refresh")
        self.assertEqual(self.read("paper/costs.ecsv").splitlines()[-2:], ["sec1_demo,10", "sec2_new,nan"])
        self.assertEqual([chapters.shown_cost(s) for s in (float("nan"), 0.6, 2.5, 3.4)], ["?", "< 1", "3", "3"])
        self.write("build/report/cost/sec1_demo", "soon")
        self.refuses("refresh", "cost/sec1_demo: no time in seconds")

    def test_what_is_missed_names_the_chapters_that_explain_it(self):
        """Those whose facts the reason quotes, or the reason of a claim that it names: nobody types them."""
        claim = {"answer": "sec1_demo.x", "criterion": "", "covered_by": "", "reason": "As {sec2_why.fact} and {a.one}, by {sec1_demo.fact}."}
        claims = {"a.one": claim, "a.o": claim | {"reason": "No a.one_more."}, "b.two": claim | {"reason": "As for a.one: so."},
                  "c.three": claim | {"answer": "", "criterion": "sec3_own.y > 1", "reason": "", "covered_by": "b.two^2"}}
        for id, programs in [("a.one", "sec1_demo sec2_why"), ("a.o", "sec1_demo"), ("b.two", "sec1_demo sec2_why"),
                             ("c.three", "sec3_own sec1_demo sec2_why")]:
            self.assertEqual(chapters.explained_by(id, claims), programs.split(), id)


class Here(unittest.TestCase):
    @of_volume
    def test_every_chapter_has_its_cost(self):
        costs = chapters.read_costs(VOLUME)
        self.assertEqual(list(costs), programs_of(VOLUME))
        self.assertTrue(all(seconds >= 0 for seconds in costs.values()))

    def test_cases_of_the_article_are_called_after_claims(self):
        """The index of the README and the book leads from a claim to the line of its test."""
        tests, lines = chapters.article_tests(ROOT), ecsv.text_of(ROOT / "tests/article.cpp").split("\n")
        self.assertEqual(sorted(set(tests) - set(read_claims(ROOT))), [])
        self.assertGreater(len(tests), 50)
        self.assertTrue(all("TEST_CASE" in lines[line - 1] for line in tests.values()))

    def test_every_discrepancy_names_its_chapters_with_command_and_cost(self):
        claims, costs, readme = read_claims(ROOT), chapters.read_costs(ROOT), ecsv.text_of(ROOT / "README.md")
        for id in (id for id, claim in claims.items() if claim["reason"]):
            see = refresh.see(id, claims, costs, chapters.read_commands(ROOT))
            if claims[id]["status"] == "discrepant":
                self.assertIn(f"{see} |", readme)
            for program in chapters.explained_by(id, claims):
                self.assertIn(f"[`build/bin/{program}`](src/{program}.cpp) ({chapters.shown_cost(costs[program])} s)", see)

    def test_commands_that_compute_one_number_exist(self):
        known = by_name(joined(read_lock, volumes(ROOT)), read_claims(ROOT))
        for id, (command, quantity) in joined(chapters.read_commands, volumes(ROOT)).items():
            program, subcommand = command.split()[0].split("/")[-1], command.split()[1]
            folders = [folder for volume in volumes(ROOT) for folder in [volume / "src/commands", *(volume / "src").glob("sec*/")]
                       if folder.name == "commands" or program.startswith(folder.name)]
            texts = [ROOT / chapters.chapter_of(ROOT, program), *(header for folder in folders for header in folder.glob("*.hpp"))]
            self.assertTrue(id in known and quantity and any(f'"{subcommand}"' in ecsv.text_of(path) for path in texts), id)

    def test_the_article_needs_nothing_of_the_second_volume(self):
        """Its own programs answer its claims and compute its commands, and it quotes its own numbers."""
        claims, programs, commands = read_claims(ROOT), set(programs_of(ROOT)), chapters.read_commands(ROOT)
        self.assertEqual(set(map(program_of, claims.values())) - programs, set())
        self.assertEqual({command.split()[0].split("/")[-1] for command, _ in commands.values()} - programs, set())
        with mock.patch("lineage.lock.volumes", lambda root: [ROOT]):
            self.assertEqual(quoted(ROOT) - set(by_name(read_lock(ROOT), claims)), set())
