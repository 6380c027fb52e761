"""Figure x34: numbers of other authors against ours, as ratios, with what their digits leave open."""

from decimal import Decimal
from pathlib import Path

import draw
import matplotlib.pyplot as plt
from lineage.claims import read_literature

# What each number is, by its id without the digits at the end, and who printed it
SHORT = {"fragment_": "Sokolow: velocity of ball {} flying back (m/s)",
         "pulse_energy": "Sokolow: energy of the pulse over the impact's",
         "pulse_amplitude": "MOOSE test: its largest velocity over the impact's",
         "pulse_slower": "MOOSE test: slower than in long-wave theory by (%)",
         "pulse_narrower": "MOOSE test: narrower than there by (%)",
         "sampled_width": "MOOSE test: its width as sampled (sites)",
         "pulse_kinetic": "Slepyan: kinetic part of its energy",
         "exponent_hertz": "Kekić: exponent that goes with 5/2",
         "exponent_four": "Kekić: exponent that goes with 4",
         "sen_c": "Sen and Manciu: slope $C_1$ of the pulse",
         "dimer_": "Jayaprakash et al.: mass ratio {} of a dimer chain"}

data, out = draw.arguments()
facts = draw.table_of(f"{data}/secB_other_numbers/facts.ecsv").by("quantity", "facts")
rows = list(read_literature(Path(__file__).resolve().parents[1]).values())

figure, axes = plt.subplots(figsize=(draw.TWO_COLUMNS, 4.6 * draw.MM * len(rows) + 16 * draw.MM), layout="constrained")
for k, row in enumerate(rows):
    theirs, half_digit = float(row["printed"]), 0.5 * 10.0 ** Decimal(row["printed"]).as_tuple().exponent
    open_by = float(row["tolerance"].removeprefix("abs ")) if row["tolerance"].startswith("abs ") else half_digit
    ours, error = float(facts[row["id"]]["value"]), float(facts[row["id"]]["error"])
    axes.plot([-open_by / abs(theirs), open_by / abs(theirs)], [k, k], "-", color="0.75", lw=6, solid_capstyle="butt", label="open by the printed digits" if k == 0 else None)
    memory = row["obtained"] == "memory"
    axes.errorbar(ours / theirs - 1, k, xerr=abs(error / theirs), fmt="s" if memory else "o", ms=4.5, color="#D55E00" if memory else "#0072B2",
                  mfc="none" if memory else None, capsize=2,
                  label={0: "ours, source read", len(rows) - 1: "ours, source not read: no verdict"}.get(k))
axes.axvline(0, color="black", lw=0.6, zorder=0)
axes.set_xscale("symlog", linthresh=1e-7, linscale=0.6)
axes.set(yticks=range(len(rows)), yticklabels=[f"{SHORT[row['id'].rstrip('0123456789')].format(row['id'].split('_')[-1])}  {row['printed']}" for row in rows], xlim=(-0.1, 0.1),
         xticks=[-1e-2, -1e-4, -1e-6, 0, 1e-6, 1e-4, 1e-2], xlabel="ours over the printed value, minus one")
axes.tick_params(axis="y", labelsize=7)
axes.invert_yaxis()
axes.legend(loc="lower center", bbox_to_anchor=(0.2, 1.0), ncols=3, fontsize=7, frameon=False)
draw.save(figure, out)
