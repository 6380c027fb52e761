"""Figure x26: the packet of an impact and breathers at rest in a damped array."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec5_experiment"
journeys = draw.read(f"{folder}/journeys.ecsv")
sights = draw.read(f"{folder}/sights.ecsv")
decay = draw.read(f"{folder}/decay.ecsv")
instability = draw.read(f"{folder}/instability.ecsv")
COLORS = ["#0072B2", "#009E73", "#D55E00"]
MARKS, DASHES = ["o", "s", "^"], ["-", "--", "-."]

figure, axes = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 125 * draw.MM))
(distance, reach), (branch, seen) = axes

for color, mark, dash, v in zip(COLORS, MARKS, DASHES, np.unique(journeys["velocity"])):
    rows = draw.where(draw.where(journeys, "velocity", v), "velocity", v)
    rows = {name: x[rows["lifetime"] > 0] for name, x in rows.items()}
    distance.semilogx(rows["lifetime"], rows["sites_law"], dash, color=color, lw=0.9)
    distance.semilogx(rows["lifetime"], rows["sites"], mark, color=color, ms=3.5, mfc="white",
                 label=f"{v:g} m/s")
distance.set(xlabel="lifetime of the energy (ms)", ylabel="sites travelled in 10 ms", ylim=(0, 24))
distance.legend(loc="lower right")
draw.letter(distance, "a")

for color, mark, dash, r in zip(COLORS, MARKS, DASHES, np.unique(sights["resolution"])):
    rows = draw.where(sights, "resolution", r)
    reach.loglog(rows["lifetime"], rows["seen_law"], dash, color=color, lw=0.9)
    reach.loglog(rows["lifetime"], rows["seen"], mark, color=color, ms=3.5, mfc="white",
                 label=f"{1000 * r:g} mm/s")
reach.set(xlabel="lifetime of the energy (ms)", ylabel="last site at which it is seen")
reach.legend(loc="lower right", title="sensor resolves")
draw.letter(reach, "b")

for color, mark, bond, name in [(COLORS[2], "s", 0, "site"), (COLORS[0], "o", 1, "bond")]:
    rows = draw.where(decay, "bond", bond)
    branch.semilogy(rows["frequency"], rows["energy"] * 1e6, mark, color=color, ms=4, mfc="white",
                    label=f"decaying, {name}")
    branch.semilogy(rows["frequency"], rows["energy_branch"] * 1e6, "+", color="black", ms=5)
branch.plot([], [], "+", color="black", label="exact breather")
branch.set(xlabel=r"frequency over that of a beam", ylabel=r"energy ($\mathrm{\mu J}$)")
branch.set_yticks([6, 10, 20, 40], ["6", "10", "20", "40"])
branch.minorticks_off()
branch.set_xticks([1.07, 1.08, 1.09])
branch.legend(loc="lower right")
draw.letter(branch, "c")

seen.semilogy(instability["omega"], instability["quality_e"], "o-", color=COLORS[0], ms=3.5, lw=0.9,
              mfc="white")
seen.set(xlabel=r"frequency at the start over that of a beam",
         ylabel=r"quality factor for an $e$-fold growth")
seen.set_yticks([20000, 50000, 100000], ["20000", "50000", "100000"])
seen.minorticks_off()
draw.letter(seen, "d", x=0.97)
draw.save(figure, out)
