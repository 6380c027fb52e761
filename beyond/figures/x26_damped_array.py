"""Figure x26: how far the packet of an impact travels in a damped array."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
journeys = draw.read(f"{data}/sec5_experiment/journeys.ecsv")

figure, axes = plt.subplots(figsize=(draw.ONE_COLUMN, 65 * draw.MM))
for color, mark, dash, v in zip(["#0072B2", "#009E73", "#D55E00"], "os^", ["-", "--", "-."],
                                np.unique(journeys["velocity"])):
    rows = draw.where(journeys, "velocity", v)
    rows = {name: x[rows["lifetime"] > 0] for name, x in rows.items()}
    axes.semilogx(rows["lifetime"], rows["sites_law"], dash, color=color, lw=0.9)
    axes.semilogx(rows["lifetime"], rows["sites"], mark, color=color, ms=3.5, mfc="white", label=f"{v:g} m/s")
axes.set(xlabel="lifetime of the energy (ms)", ylabel="sites travelled in 10 ms", ylim=(0, 24))
axes.legend(loc="lower right")
draw.save(figure, out)
