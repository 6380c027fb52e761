"""python3 -m second [--write] [GROUP ...]: compute all or some groups of numbers; write them as the tables of their volumes."""
import argparse
import csv
import re
import time
from pathlib import Path

from . import impact, standing, waves

# a group is a function of the accuracy, 0 or 1, that gives rows (quantity, value, rounding error, method)
GROUPS = {"barrier": standing.barrier, "kappa": standing.pinning, "impact": impact.snapshot, "turning": impact.turning,
          "packet": impact.packet, "fold": impact.fold, "wave": waves.breathers, "growth": waves.rates}
COLUMNS = {"quantity": "string, description: 'name of the number'",
           "value": "float64, description: 'at the finer of two accuracies'",
           "error": "float64, description: 'difference of the two accuracies plus rounding'",
           "unit": "string, description: 'empty in the scaled units of the article'",
           "method": "string, description: 'definition'"}
UNITS = {"sec5_experiment/folds/frequency=7000/fold": "um", "sec34_boomeron/turns/velocity=1.9/apex_site": "site",
         "sec5_experiment/journeys/velocity=1/lifetime=0/sites": "site",
         "sec5_experiment/journeys/velocity=1/lifetime=10/sites": "site"}

parser = argparse.ArgumentParser(prog="second", description=__doc__)
parser.add_argument("groups", nargs="*", metavar="GROUP", help="of " + ", ".join(GROUPS))
parser.add_argument("--write", action="store_true", help="into paper/second.ecsv of each volume")
options, rows = parser.parse_args(), []
for group in options.groups or GROUPS:
    start = time.process_time()
    for (_, rough, _, _), (name, value, rounding, method) in zip(*(GROUPS[group](level) for level in (0, 1))):
        error = f"{abs(value - rough) + rounding:.1e}"
        rows.append((name, repr(float(value)), error, UNITS.get(name, ""), method))
        print(*rows[-1])
    print(f"{group}: {time.process_time() - start:.1f} s", flush=True)
# A claim, or a number of a program of the article, is of the first volume
SECOND = {path.stem for path in Path("beyond/src").glob("sec*.cpp")}
for volume in (Path("."), Path("beyond")) if options.write else ():
    mine = [row for row in rows if (re.split("[./]", row[0])[0] in SECOND) == (volume.name == "beyond")]
    types = "".join(f"# - {{name: '{name}', unit: '', datatype: {text}}}\n" for name, text in COLUMNS.items())
    with open(volume / "paper/second.ecsv", "w", encoding="ascii") as file:
        file.write("# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n" + types + "# schema: astropy-2.0\n")
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *mine])
