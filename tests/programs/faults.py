#!/usr/bin/env python3
"""What happens to runs on a bad day: killed, out of time, out of disk, without a place to write or somebody to read.

    faults.py ROOT BIN [COUNT [SEED]]
    faults.py ROOT BIN maps           those of the maps in parts, which volume two has

COUNT is how often runs are killed, at random moments. Every fault is a function, which says what is asked. A line is printed
for each, and one that starts with `skipped` where a machine cannot show it."""

import hashlib
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT, BIN = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
MAPS = sys.argv[3:4] == ["maps"]
COUNT = int(sys.argv[3]) if len(sys.argv) > 3 and not MAPS else 6
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
QUICK = [BIN / "sec32_dps_profiles", "--quick", "--threads", "1", "--out"]  # a full run that takes a moment
MAP = [BIN / "sec34_boomeron_map", "map", "--part", "1/64", "--threads", "1", "--output", "map.ecsv"]
BAND = [BIN / "sec4_precompression_mi", "band"]
NOBODY = 65534


def check(good, what):
    if not good:
        raise AssertionError(what)


def run(command, **more):
    """A program that is not disturbed further: its exit code, what it prints and what it complains of."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False,
                          stdin=subprocess.DEVNULL, **more)
    return done.returncode, done.stdout, done.stderr


def one_line(answer, code, *words):
    """The answer is an exit code and one line that has these words."""
    got, _, said = answer
    check(got == code and said.count("\n") == 1 and all(word in said for word in words), f"{answer}, expected {code} {words}")


def rows(path):
    return "".join(line for line in path.read_text().splitlines(True) if not line.startswith("#"))


def tables(folder):
    """The list of all tables, if the folder is complete and agrees with its checksums; else nothing."""
    if not (folder / "SHA256SUMS").exists():
        return None
    paths = sorted(path for path in folder.glob("*.ecsv") if path.name != "run.ecsv")
    listed, there = (folder / "SHA256SUMS").read_text(), "".join(f"{sha256(path)}  {path.name}\n" for path in paths)
    check(listed == there, f"{folder}: complete, and not what SHA256SUMS says")
    return listed


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def debris(folder, *allowed):
    return [path.name for path in folder.rglob("*") if path.is_file() and not path.match("*.ecsv") and path.name != "SHA256SUMS"
            and not any(path.match(a) for a in allowed)]


def disturbed(command, soon, number, **more):
    """Starts a program and sends it a signal when `soon()` says so; how it ends."""
    started = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               stdin=subprocess.DEVNULL, **more)
    while started.poll() is None and not soon():
        time.sleep(0.002)
    started.send_signal(number)  # which Popen does not send to a program that has ended
    return started.wait(60)


def killed_at_random(scratch):
    """Runs killed at random moments: whole tables or none, and the next run is as if nothing had been."""
    chance, hurt = random.Random(SEED), scratch / "hurt"
    start = time.monotonic()
    check(run(QUICK + [scratch / "whole"])[0] == 0, "a run that is not disturbed fails")
    takes, whole, ended = time.monotonic() - start, tables(scratch / "whole"), 0
    for k in range(COUNT):
        number = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU][k % 5]  # the last out of time
        end = time.monotonic() + (takes * chance.uniform(0, 1.1) if k else 0)
        ended += disturbed(QUICK + [hurt], lambda: time.monotonic() > end, number) != 0
        if hurt.exists():
            check(tables(hurt) in (None, whole), "a killed run leaves tables that are not whole")
            check(not debris(hurt, "*.part"), f"a killed run leaves {debris(hurt)}")
    check(ended > 0, "no run was killed in time")
    check(run(QUICK + [hurt])[0] == 0 and tables(hurt) == whole and not debris(hurt), "the run after the killed ones is not whole")
    disturbed(QUICK + [hurt], lambda: not (hurt / "SHA256SUMS").exists(), signal.SIGKILL)
    check(tables(hurt) is None, "a killed run leaves the list of the one before")
    return f"{ended} of {COUNT} runs killed, seed {SEED}"


def interrupted_map(scratch):
    """A map that is ended again and again keeps its rows; in the end it has the bytes of one that was not."""
    check(run(MAP, cwd=scratch)[0] == 0, "a map that is not disturbed fails")
    check([path.name for path in scratch.iterdir()] == ["map.ecsv"], "a map leaves more than its table")
    whole = rows(scratch / "map.ecsv")
    (scratch / "map.ecsv").unlink()
    (scratch / "kept").mkdir()
    kept, found = MAP + ["--folder", "kept"], 0

    def rows_kept():
        return sum(len(path.read_text().splitlines()) - 1 for path in (scratch / "kept").glob(".*.rows-*[0-9]"))

    for number in (signal.SIGTERM, signal.SIGXCPU, signal.SIGKILL):
        disturbed(kept, lambda: rows_kept() > found, number, cwd=scratch)
        now = rows_kept()
        check(now >= found, f"{found} rows were kept, and then {now}")
        found = now
    check(found > 0, "no row was kept")
    # What was changed by hand or cut is computed again.
    path = next((scratch / "kept").iterdir())
    lines = path.read_text().splitlines(True)
    path.write_text(lines[0] + lines[1].replace(",", ",9", 1) + "".join(lines[2:])[:-3])
    check(run(kept, cwd=scratch)[0] == 0 and rows(scratch / "map.ecsv") == whole, "the map is not that of a quiet run")
    return f"{found} rows kept"


def array_of_tasks(scratch):
    """The parts of beyond/examples/turning_map.sbatch, each as Slurm's array calls it, make the plain map."""
    (scratch / "build").mkdir()
    (scratch / "build/bin").symlink_to(BIN)
    for task in ("1", "3", "2"):
        task_of = {**os.environ, "SIDE": "6", "PARTS": "3", "SLURM_ARRAY_TASK_ID": task}
        check(run(["sh", ROOT / "beyond/examples/turning_map.sbatch"], cwd=scratch, env=task_of)[0] == 0, f"task {task} fails")
    kept = sum(len(path.read_text().splitlines()) for path in (scratch / "build/turning-6").glob(".*.rows-*"))
    check(kept == 36 + 3, f"the tasks keep {kept - 3} of 36 rows")
    for name, more in ("plain", []), ("parts", ["--folder", "build/turning-6"]):
        run(MAP[:2] + ["--columns", "6", "--rows", "6", "--output", f"{name}.ecsv", *more], cwd=scratch)
    check(rows(scratch / "plain.ecsv") == rows(scratch / "parts.ecsv"), "a map in parts is not the plain map")


def full_disk(scratch):
    """Writing fails, as on a full disk: here for a limit of size."""
    for command in [MAP + ["--folder", scratch / "rows"]] if MAPS else [QUICK + [scratch / "out"], BAND + ["--output", scratch / "band.ecsv"]]:
        one_line(run(command, cwd=scratch, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))), 1, "cannot write")
    left = debris(scratch, ".*.rows-*") + [path.name for path in scratch.rglob("SHA256SUMS")]
    check(not left and not (scratch / "map.ecsv").exists(), f"left on a full disk: {left}")


def read_only(scratch):
    """Who may not write is told so before anything is computed."""
    closed = scratch / "closed"
    closed.mkdir()
    closed.chmod(0o555)
    other = {}
    if os.getuid() == 0:
        scratch.chmod(0o755)
        other = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        try:
            run([(MAP if MAPS else QUICK)[0], "--version"], **other)
        except OSError:
            return "skipped: no other user may start the programs here"
    if MAPS:
        one_line(run(MAP[:-1] + ["/dev/null", "--folder", closed / "rows"], **other), 2, "--folder: cannot write to")
    else:
        one_line(run(QUICK + [closed / "out"], **other), 2, "--out: cannot write to", "Permission denied")
        one_line(run(BAND + ["--output", closed / "x.ecsv"], **other), 2, "--output: cannot write to")
    check(not list(closed.iterdir()), "something was written into a closed folder")


def closed_channels(scratch):
    """Nobody reads, or not to the end, or there is no place for what is said."""
    def through(line):
        return run(["sh", "-c", line, "sh", *BAND], cwd=scratch)

    whole = through('"$@"')[1]
    for line in ('"$@" > /dev/full', '"$@" >&-', '"$1" --help > /dev/full', '"$1" --version > /dev/full'):
        one_line(through(line), 1, "cannot write to standard output")
    check(through('"$@" | head -n 1')[1:] == (whole.splitlines(True)[0], ""), "a closed pipe is complained of")
    check(through('"$@" --output x.ecsv 2>&- <&- >&-') == (0, "", "") and (scratch / "x.ecsv").exists(), "a table without any channel")
    check(through('"$@" --d nonsense --output y.ecsv 2>&-')[0] == 2 and not (scratch / "y.ecsv").exists(), "refused unheard")


def little_memory(scratch):
    """A long run keeps two states and not its history."""
    code, said, errors = run([BIN / "sec34_boomeron", "run", "--time", "3000"], cwd=scratch,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (150_000_000, 150_000_000)))
    check(code == 0 and said and not errors, f"a long run takes more than 150 MB, or talks: {errors}")


FAULTS = [interrupted_map, array_of_tasks, full_disk, read_only] if MAPS else [
    killed_at_random, full_disk, read_only, closed_channels, little_memory]


def main():
    bad = 0
    os.environ["LC_ALL"] = "C.UTF-8"
    for fault in FAULTS:
        with tempfile.TemporaryDirectory() as folder:
            try:
                said = fault(Path(folder)) or ""
                verdict = "survived" if not said.startswith("skipped") else ""
            except (AssertionError, subprocess.TimeoutExpired) as error:
                bad, verdict, said = bad + 1, "FAILS", str(error)
            finally:
                for path in Path(folder).rglob("*"):
                    if path.is_dir():
                        path.chmod(0o755)
        print(f"{fault.__name__.replace('_', ' '):18} {verdict:9} {said}", flush=True)
    sys.exit(bad > 0)


if __name__ == "__main__":
    main()
