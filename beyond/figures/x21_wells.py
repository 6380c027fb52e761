"""Figure x21: exact travelling breathers in soft and hard wells."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
branches = draw.read(f"{data}/sec5_travelling_breathers/branches.ecsv")

figure, axes = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 60 * draw.MM), layout="constrained")
bounds = {1: (-0.03, 0.02, 0.86, 1.012), 2: (-0.15, 0.4, 1.65, 2.015), 3: (-0.5, 2.1, 2.78, 3.015)}
for panel, (k, (left, right, low, high)) in zip(axes, bounds.items()):
    for direction in (1, -1):
        way = draw.where(draw.where(branches, "k", k), "direction", direction)
        panel.plot(way["s"], way["turns"], "-", color="#0072B2", lw=1.1)
    panel.axvline(0, color="#888888", lw=0.5)
    panel.plot([0], [k], "^", ms=4, color="#009E73", label="type I")
    panel.set(xlabel="anharmonicity $s$", xlim=(left, right), ylim=(low, high))
    panel.xaxis.set_major_locator(plt.MaxNLocator(2))
axes[0].set_ylabel(r"shift time $T/2\pi$")
axes[0].legend(loc="center left", fontsize=6, handletextpad=0.1, borderpad=0)
for panel, name, k in zip(axes, "abc", bounds):
    panel.set_title(f"({name}) $k = {k}$", loc="left", pad=3)
draw.save(figure, out)
