"""What chapters cost, and the commands that compute one number. Which chapters explain a
claim stands in the README, where test_refresh.py notices a change."""

import unittest
from unittest import mock

from lineage import chapters, ecsv
from lineage.claims import by_name, programs_of, read_claims
from lineage.lock import quoted, read_lock
from lineage.volumes import joined, volumes

from common import ROOT, Scratch, table


class Chapters(Scratch):
    def test_a_cost_is_renewed_when_it_has_really_moved(self):
        """And every program has one, whether it draws a figure or not."""
        self.write("src/sec2_new.cpp", "/**\n# 2 */\n")
        self.write("paper/costs.ecsv", table(["program", "seconds"], [["sec1_demo", 10.0], ["sec0_gone", 1.0]]))
        costs = chapters.renewed_costs(self.root, {"sec1_demo": 11.0, "sec2_new": 0.412})
        self.assertEqual(costs, {"sec1_demo": 10.0, "sec2_new": 0.41})
        self.assertEqual(chapters.renewed_costs(self.root, {"sec1_demo": 19.0})["sec1_demo"], 10)
        self.assertEqual(chapters.renewed_costs(self.root, {"sec1_demo": 23.02})["sec1_demo"], 23)
        self.lineage("refresh")
        self.assertEqual(self.read("paper/costs.ecsv").splitlines()[-2:], ["sec1_demo,10", "sec2_new,nan"])
        self.assertEqual([chapters.shown_cost(s) for s in (float("nan"), 0.6, 2.5, 3.4)], ["?", "< 1", "3", "3"])
        self.write("build/report/cost/sec1_demo", "soon")
        self.refuses("refresh", "cost/sec1_demo: not a time in seconds")

    def test_the_head_of_a_chapter_says_what_it_costs_writes_and_offers(self):
        self.program()
        self.write("src/sec1_demo.cpp", "/**\n# 1 A demonstration\n\n<!-- head -->\n<!-- /head --> */\n")
        self.write("paper/full.sha256", f"# here\n{'0' * 64}  sec1_demo/a.ecsv\n{'1' * 64}  sec1_demo/b.ecsv\n{'1' * 64}  sec1_demon/b.ecsv\n")
        self.lineage("refresh")
        said = " ".join(self.read("src/sec1_demo.cpp").split())
        self.assertIn("`build/bin/sec1_demo` computes this chapter in 3 s on two cores and writes 2 tables to `build/data/sec1_demo`. "
                      "Its figures: `make fig01`. With your parameters: `one`, one thing, of two.", said)


class Here(unittest.TestCase):
    def test_every_chapter_has_a_head(self):
        for program in programs_of(ROOT):
            self.assertTrue("<!-- head -->\n" in ecsv.text_of(ROOT / f"src/{program}.cpp"), program)

    def test_commands_that_compute_one_number_exist(self):
        known = by_name(joined(read_lock, volumes(ROOT)))
        for id, (command, quantity) in joined(chapters.read_commands, volumes(ROOT)).items():
            program, subcommand = command.split()[0].split("/")[-1], command.split()[1]
            folders = [folder for volume in volumes(ROOT) for folder in [volume / "src/commands", *(volume / "src").glob("sec*/")]
                       if folder.name == "commands" or program.startswith(folder.name)]
            texts = [ROOT / chapters.chapter_of(ROOT, program), *(header for folder in folders for header in folder.glob("*.hpp"))]
            self.assertTrue(id in known and quantity and any(f'"{subcommand}"' in ecsv.text_of(path) for path in texts), id)

    def test_the_article_needs_nothing_of_the_second_volume(self):
        """Its own programs answer its claims and compute its commands, and it quotes its own numbers."""
        claims, programs, commands = read_claims(ROOT), set(programs_of(ROOT)), chapters.read_commands(ROOT)
        self.assertEqual({claim["program"] for claim in claims.values()} - programs, set())
        self.assertEqual({command.split()[0].split("/")[-1] for command, _ in commands.values()} - programs, set())
        with mock.patch("lineage.lock.volumes", lambda root: [ROOT]):
            self.assertEqual(quoted(ROOT) - set(by_name(read_lock(ROOT))), set())
