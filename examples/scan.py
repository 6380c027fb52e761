"""A scan of one's own: the speed of an impact's packet against velocity and well, on all cores granted.

    PYTHONPATH=build/python python3 examples/scan.py scan.csv

A point is a line, written as soon as it is known. Whoever calls it again computes what is missing."""

import csv
import itertools
import os
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed

import lattice


def row(velocity, s):
    """What is asked of a point. A nan says why; so does a run that fails."""
    lattice.set_threads(1)  # the processes share the cores
    try:
        speed = lattice.strike(velocity=velocity, s=s, sites=100, time=600).speed
    except RuntimeError as failure:
        return velocity, s, "nan", "nan", failure
    return velocity, s, float(speed), speed.error, speed.reason


def scan(path, points):
    cores = min(len(os.sched_getaffinity(0)), int(os.environ.get("SLURM_CPUS_PER_TASK", 1024)))
    with open(path, "a+", newline="", buffering=1) as file, ProcessPoolExecutor(cores) as pool:
        file.seek(0)
        whole = [line for line in file if line.endswith("\n")]
        file.truncate(len("".join(whole).encode()))  # a line that was cut off
        table, known = csv.writer(file, lineterminator="\n"), {tuple(cells[:2]) for cells in csv.reader(whole)}
        if not whole:
            table.writerow(["velocity", "s", "speed", "speed_error", "reason"])
        for found in as_completed([pool.submit(row, v, s) for v, s in points if (str(v), str(s)) not in known]):
            table.writerow(found.result())


if __name__ == "__main__":
    scan(sys.argv[1], itertools.product([0.5, 1.0, 1.5, 2.0], [-0.25, 0.0, 0.5, 1.0]))
