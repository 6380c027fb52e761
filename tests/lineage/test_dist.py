"""The archive of `make dist`: tools/dist.sh in a checkout of the small repository."""

import json
import os
import shutil
import subprocess
import tarfile
import unittest

from lineage import ecsv

from common import ROOT, Scratch

NAME = "breathers-" + json.loads(ecsv.text_of(ROOT / "codemeta.json"))["version"]
ENV = {"PATH": os.environ.get("PATH", "/usr/bin:/bin"), "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1",
       "GIT_AUTHOR_DATE": "1000000000 +0000", "GIT_COMMITTER_DATE": "1000000000 +0000", "NAME": NAME}


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Archive(Scratch):
    def run_in(self, *command):
        return subprocess.run(command, cwd=self.root, env=ENV, capture_output=True, text=True, check=False)

    def setUp(self):
        super().setUp()
        for script in ("dist", "revision"):
            self.write(f"tools/{script}.sh", ecsv.text_of(ROOT / f"tools/{script}.sh"))
        self.write(".gitignore", "/build/\n")
        self.write("build/figures/fig01.svg", "<svg/>\n")
        self.write("build/figures/fig01.pdf", "%PDF\n")
        self.lineage("refresh")
        self.judged()
        self.run_in("git", "init", "-q")
        self.run_in("git", "add", "-A")
        self.run_in("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "all")

    def dist(self):
        run = self.run_in("sh", "tools/dist.sh", "build")
        return run.returncode, run.stdout + run.stderr

    def test_it_is_the_same_twice_and_whole(self):
        archive, inside = self.root / f"build/dist/{NAME}.tar.gz", self.root / "out" / NAME
        code, said = self.dist()
        self.assertEqual(code, 0, said)
        self.assertIn("dist       : without the book, which does not exist (make book)\n", said)
        with tarfile.open(archive) as opened:
            members = opened.getmembers()
            opened.extractall(self.root / "out")
        self.assertEqual({(m.uid, m.gid, m.mtime) for m in members}, {(0, 0, 1000000000)})
        check = self.run_in("sh", "-c", "cd out/$NAME && sha256sum --quiet -c SHA256SUMS && wc -l < SHA256SUMS")
        self.assertEqual(int(check.stdout), sum(m.isfile() for m in members) - 1, check.stderr)
        files = ["codemeta.json", "build/data/sec1_demo/results.ecsv", "build/data/sec1_demo/SHA256SUMS", "build/figures/fig01.pdf", "build/report/claims.ecsv"]
        self.assertEqual([path for path in files if not (inside / path).exists()], [])
        first = archive.read_bytes()
        os.utime(self.root / "build/figures/fig01.svg", (5, 5))
        (self.root / "build/figures/fig01.svg").chmod(0o600)
        self.write("build/data/sec1_demo/.rows-1-of-2", "cut off\n")
        self.dist()
        self.assertEqual(archive.read_bytes(), first)
