"""python3 -m second [--out FILE] [GROUP ...]: compute all or some groups of numbers; write them as an ECSV table."""
import argparse
import csv
import time
from . import impact, standing, waves

# a group is a function of the accuracy, 0 or 1, that gives rows (quantity, value, rounding error, method)
GROUPS = {"barrier": standing.barrier, "kappa": standing.pinning, "impact": impact.snapshot, "turning": impact.turning,
          "packet": impact.packet, "fold": impact.fold, "wave": waves.breathers, "growth": waves.rates}
COLUMNS = {"quantity": "string, description: 'name of the number'",
           "value": "float64, description: 'at the finer of two accuracies'",
           "error": "float64, description: 'difference of the two accuracies plus rounding'",
           "unit": "string, description: 'empty in the scaled units of the article'",
           "method": "string, description: 'definition'"}
UNITS = {"sec5_driving.recipe_7000": "um", "sec34_boomeron.apex_site_190": "site",
         "sec5_experiment.sites_undamped": "sites", "sec5_experiment.sites_10ms": "sites"}

parser = argparse.ArgumentParser(prog="second", description=__doc__)
parser.add_argument("groups", nargs="*", metavar="GROUP", help="of " + ", ".join(GROUPS))
parser.add_argument("--out", metavar="FILE")
options, rows = parser.parse_args(), []
for group in options.groups or GROUPS:
    start = time.process_time()
    for (_, rough, _, _), (name, value, rounding, method) in zip(*(GROUPS[group](level) for level in (0, 1))):
        error = f"{abs(value - rough) + rounding:.1e}"
        rows.append((name, repr(float(value)), error, UNITS.get(name, ""), method))
        print(*rows[-1])
    print(f"{group}: {time.process_time() - start:.1f} s", flush=True)
if options.out:
    types = "".join(f"# - {{name: '{name}', unit: '', datatype: {text}}}\n" for name, text in COLUMNS.items())
    with open(options.out, "w", encoding="ascii") as file:
        file.write("# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n" + types + "# schema: astropy-2.0\n")
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
