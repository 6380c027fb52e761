"""Tables, commands and packages as they describe themselves, and the archive that has them all."""

import os
import re
import shutil
import subprocess
import tarfile
import unittest

from lineage import ecsv, inventory

from . import HELP, ROOT, Scratch


class Inventory(Scratch):
    def test_a_program_is_asked_what_it_can(self):
        self.program()
        rows = [tuple(row.values())[1:] for row in inventory.commands(self.root, self.root / "build/bin")]
        self.assertEqual(rows, [
            ("", "", "", "A demonstration (section 1)"), ("", "--help", "", "this text"), ("", "--quick", "", "coarse"),
            ("one", "", "", "one thing, of two"), ("one", "--help", "", "this text"),
            ("one", "--speed", "[0, 1]", "how fast it is, in sites (default: 0.5)"),
            ("one", "--well", "none, harmonic, quartic, pendulum", "well of every bead")])
        self.assertEqual(list(inventory.commands(self.root, self.root / "none")), [])
        self.write("build/bin/sec1_demo", HELP.replace("#!/bin/sh\n", "#!/bin/sh\nexit 3\n"))
        with self.assertRaisesRegex(ecsv.Fault, "sec1_demo: does not say what it can"):
            list(inventory.commands(self.root, self.root / "build/bin"))

    def test_a_table_describes_its_columns(self):
        rows = list(inventory.tables(self.root, self.root / "build/data"))
        self.assertEqual([(r["table"], r["column"]) for r in rows],
                         [("facts", c) for c in ("quantity", "value", "error", "unit", "made_by")])
        self.assertEqual(rows[1]["kind"] + ", " + rows[1]["description"], "float64, what value is")

    @unittest.skipUnless(shutil.which("dpkg-query"), "dpkg-query is not installed")
    def test_a_package_has_its_version(self):
        self.write("apt-packages.txt", "dpkg\n[book]\nno-such-package\n")
        self.assertEqual([p["package"] for p in inventory.packages(self.root)],
                         ["g++", "cmake", "make", "git", "dpkg", "no-such-package"])
        dpkg, none = inventory.packages(self.root)[-2:]
        self.assertRegex(dpkg["version"], r"^\d")
        self.assertEqual((dpkg["section"], none["section"], none["version"]), ("figures and tests", "book", ""))


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Archive(Scratch):
    """tools/dist.sh in a checkout of the small repository."""

    ENV = {"PATH": os.environ.get("PATH", "/usr/bin:/bin"), "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1",
           "PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1",
           "GIT_AUTHOR_DATE": "1000000000 +0000", "GIT_COMMITTER_DATE": "1000000000 +0000"}

    def run_in(self, *command):
        return subprocess.run(command, cwd=self.root, env=self.ENV, capture_output=True, text=True, check=False)

    def setUp(self):
        super().setUp()
        for script in ("dist", "revision"):
            self.write(f"tools/{script}.sh", ecsv.text_of(ROOT / f"tools/{script}.sh"))
        self.write(".gitignore", "/build/\n")
        self.write("build/figures/fig01.svg", "<svg/>\n")
        self.run_in("git", "init", "-q")
        self.run_in("git", "add", "-A")
        self.run_in("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "all")

    def dist(self):
        run = self.run_in("sh", "tools/dist.sh", "build")
        return run.returncode, run.stdout + run.stderr

    def test_twice_the_same_bytes_and_nothing_is_missing_in_silence(self):
        archive = self.root / "build/dist/breathers-1.0.0.tar.gz"
        code, said = self.dist()
        self.assertEqual(code, 0, said)
        self.assertIn("dist       : without the book, which is not there (make book)\n", said)
        first = archive.read_bytes()
        os.utime(self.root / "build/figures/fig01.svg", (5, 5))
        (self.root / "build/figures/fig01.svg").chmod(0o600)
        self.write("build/data/sec1_demo/.rows-1-of-2", "cut off\n")
        self.dist()
        self.assertEqual(archive.read_bytes(), first)
        self.write("build/book/index.html", "<p>\n")
        self.assertNotIn("without the book", self.dist()[1])
        self.assertNotEqual(archive.read_bytes(), first)
        self.assertEqual(self.run_in("sh", "-c", "cd build/dist && sha256sum -c *.sha256").returncode, 0)

    def test_what_is_in_it(self):
        self.dist()
        with tarfile.open(self.root / "build/dist/breathers-1.0.0.tar.gz") as archive:
            members = archive.getmembers()
            archive.extractall(self.root / "out")
        names = [m.name.removeprefix("breathers-1.0.0").lstrip("/") for m in members]
        for name in ("README.md", "codemeta.json", "SHA256SUMS", "build/data/sec1_demo/facts.ecsv", "build/figures/fig01.svg"):
            self.assertIn(name, names)
        self.assertEqual({(m.uid, m.gid, m.mtime) for m in members}, {(0, 0, 1000000000)})
        check = self.run_in("sh", "-c", "cd out/breathers-1.0.0 && sha256sum --quiet -c SHA256SUMS && wc -l < SHA256SUMS")
        self.assertEqual(int(check.stdout), sum(m.isfile() for m in members) - 1, check.stderr)

    def test_its_first_page_leads_to_what_is_in_it_and_to_nothing_else(self):
        self.lineage("refresh")
        self.judged()
        self.write("build/figures/fig01.pdf", "%PDF\n")
        self.write("README.md", self.read("README.md") + "It is <b>bold</b>.\n")
        self.run_in("git", "add", "-A")
        self.run_in("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "more")
        self.dist()
        with tarfile.open(self.root / "build/dist/breathers-1.0.0.tar.gz") as archive:
            archive.extractall(self.root / "out")
        inside = self.root / "out/breathers-1.0.0"
        page = ecsv.text_of(inside / "index.html")
        paths = re.findall(r'(?:href|src)="(.*?)"', page)
        self.assertEqual([path for path in paths if not (inside / path).exists()], [])
        self.assertIn("build/figures/fig01.svg", paths)
        self.assertNotIn("build/book/index.html", paths)
        self.assertRegex(page, "<td>one<td>1.02<td>1.000 m<td>0.001<td>discrepant</tr>")
        manifest = re.findall(r'- file: "(.*)"', ecsv.text_of(inside / "codecheck.yml"))
        self.assertEqual(manifest, ["build/figures/fig01.pdf", "build/report/claims.ecsv"])
        self.assertEqual([path for path in manifest if not (inside / path).exists()], [])

    def test_what_cannot_be_packed_is_one_line(self):
        shutil.rmtree(self.root / "build/figures")
        self.assertEqual(self.dist(), (1, "dist: build/data and build/figures are missing: compute them first (make figures)\n"))
        shutil.rmtree(self.root / ".git")
        self.assertEqual(self.dist(), (1, "dist: this is no checkout of the repository (allowed: a clone with its history)\n"))
