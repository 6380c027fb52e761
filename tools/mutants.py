"""Would the tests notice? Puts the errors of mutants.tsv into a copy of this checkout, one at a time.

`make mutants`, or `make mutants MUTANTS='floquet sec33'` for the rows of which a file, a test or the description has one of
these words. A row names the tests that should notice, as `make test T=...` does: an error is killed if one of them fails or
no longer compiles, and survives otherwise. A row whose right text does not stand in its file exactly once is a
mistake in the list and ends the run. The copy, build/mutants, is kept: the next run compiles what has changed since."""

import os
import resource
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COPY = ROOT / "build/mutants"
MEMORY = 6 << 30  # bytes that one process may take
CORES = len(os.sched_getaffinity(0))


def read_list(selection):
    """The rows that are asked for: (file, right text, wrong text, tests, what is wrong)."""
    rows, mistakes = [], []
    for number, line in enumerate((ROOT / "tools/mutants.tsv").read_text(encoding="utf8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        file, right, wrong, tests, what = line.split("\t")
        path = ROOT / file
        if not path.exists() and file.startswith("beyond/"):
            continue  # volume two may be left out
        count = path.read_text(encoding="utf8").count(right) if path.exists() else 0
        if count != 1:
            mistakes.append(f"mutants.tsv:{number}: '{right}' stands {count} times in {file} (allowed: once)")
        elif not selection or any(word in text for word in selection for text in (file, tests, what)):
            rows.append((file, right, wrong, tests.split(), what))
    if mistakes or not rows:
        raise SystemExit("\n".join(mistakes) or f"mutants.tsv: no row has {' or '.join(selection)}")
    return rows


def copy_checkout():
    """Makes the copy like this checkout. What is the same already keeps its time, so that nothing is compiled in vain."""
    def renew(source, target):
        if not os.path.exists(target) or Path(source).read_bytes() != Path(target).read_bytes():
            shutil.copy(source, target)

    shutil.copytree(ROOT, COPY, ignore=shutil.ignore_patterns("build", ".git"), copy_function=renew, dirs_exist_ok=True)
    for path in COPY.rglob("*"):
        inside = path.relative_to(COPY)
        if path.is_file() and inside.parts[0] != "build" and not (ROOT / inside).exists():
            path.unlink()
    (COPY / "build").mkdir(exist_ok=True)
    if not (COPY / "build/data").exists() and (ROOT / "build/data").exists():
        (COPY / "build/data").symlink_to(ROOT / "build/data")  # tests read the tables that there are
    subprocess.run(["sh", "tools/configure.sh", "build"], cwd=COPY, check=True)


def failing(tests):
    """The first of these tests that notices, and how; nothing if none does."""
    for test in tests:
        run = subprocess.run(["sh", "tools/test.sh", "build", str(CORES), test], cwd=COPY, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if run.returncode == 2:
            raise SystemExit(f"mutants.tsv: {run.stdout.strip()}")
        if run.returncode:
            return f"{test} {'fails' if 'tests passed' in run.stdout else 'does not compile'}"
    return None


def main():
    rows = read_list(sys.argv[1:])
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    copy_checkout()
    if how := failing(sorted({test for _, _, _, tests, _ in rows for test in tests})):
        raise SystemExit(f"{how} without any error: nothing can be said")
    survivors = 0
    for file, right, wrong, tests, what in rows:
        text = (ROOT / file).read_text(encoding="utf8")
        (COPY / file).write_text(text.replace(right, wrong), encoding="utf8")
        try:
            how = failing(tests)
        finally:
            (COPY / file).write_text(text, encoding="utf8")
        survivors += how is None
        print(f"killed    {what} ({how})" if how else f"SURVIVES  {what}: {file} with '{wrong}' passes {' and '.join(tests)}; "
              "write the test that it asks for", flush=True)
    print(f"{len(rows) - survivors} of {len(rows)} errors killed")
    return survivors > 0


if __name__ == "__main__":
    sys.exit(main())
