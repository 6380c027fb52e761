"""Figure x15: mean speed against kick."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
speeds = draw.read(f"{data}/sec33_mobility/speeds.ecsv")
thresholds = draw.read(f"{data}/sec33_mobility/thresholds.ecsv")

figure, (axes, below) = plt.subplots(2, 1, sharex=True, figsize=(draw.ONE_COLUMN, 88 * draw.MM),
                                     height_ratios=[3, 1])
for centre, color, mark in [("site", "#D55E00", "s"), ("bond_stretched", "#0072B2", "o")]:
    table = draw.where(speeds, "centre", centre)
    c, speed, pendulum = table["c"], table["speed"], table["pendulum"]
    axes.loglog(c, pendulum, "x", color=color, ms=7, mew=0.7)
    axes.loglog(c, speed, mark, color=color, ms=4, mfc="white", label=centre.replace("_stretched", ""))
    below.errorbar(c, 1e4 * (speed / pendulum - 1), 1e4 * table["speed_error"] / pendulum, fmt=mark,
                   color=color, ms=3, mfc="white", elinewidth=0.7)
axes.plot([], [], "x", color="black", ms=7, mew=0.7, label="pendulum")
threshold, = draw.where(thresholds, "breather", "bond_stretched")["threshold"]
axes.axvline(threshold, color="#0072B2", lw=0.8, ls=(0, (1, 1)), label="threshold")
axes.axvline(6.19e-6, color="#888888", lw=0.8, ls=(0, (5, 2)), label="printed threshold")
axes.set(ylabel="mean speed (sites per unit of time)")
axes.legend(loc="lower right")
below.axhline(0, color="black", lw=0.5)
below.set(xlabel="size $c$ of the kick", ylabel="diff. ($10^{-4}$)", ylim=(-3, 3))
draw.save(figure, out)
