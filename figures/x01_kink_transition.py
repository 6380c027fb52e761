"""Figure x01: the transition from breather to kink in pendulum wells, and two examples."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import SymLogNorm

data, out = draw.arguments()
scan = draw.read(f"{data}/sec34_kink/kink_transition.ecsv")
examples = draw.read(f"{data}/sec34_kink/kink_examples.ecsv")

figure, grid = plt.subplot_mosaic([["a", "c", "d"], ["b", "c", "d"]],
                                  figsize=(draw.TWO_COLUMNS, 72 * draw.MM),
                                  width_ratios=[1.35, 1, 1])
decided = scan["decided"] == 1
advanced = scan["advanced"] / scan["advanced"].max()
fraction, beads, low, high = grid["a"], grid["b"], grid["c"], grid["d"]
fraction.plot(scan["velocity"], advanced, color="#0072B2", lw=0.8)
fraction.plot(scan["velocity"][~decided], advanced[~decided], "o", ms=3, mfc="none",
           mew=0.6, color="black", label="undecided")
if not decided.all():
    fraction.legend(loc="center left", handlelength=1)
fraction.set(ylabel="fraction advanced", xlim=(1, 8), ylim=(-0.05, 1.12), xticklabels=[])
for column, mark, color, name in [("ejected_near", "x", "#009E73", "near end"),
                                  ("ejected_far", ".", "#D55E00", "far end")]:
    keep = decided & (scan[column] > 0)
    beads.plot(scan["velocity"][keep], scan[column][keep], mark, ms=3, mew=0.6, color=color,
               label=name)
beads.set(xlabel="impact velocity $v_0$", ylabel="beads thrown out", xlim=(1, 8), ylim=(0, 6.5))
beads.legend(loc="upper right", handlelength=1, ncols=2, columnspacing=1)
draw.letter(fraction, "a")
draw.letter(beads, "b")
for axes, velocity, name in [(low, 2.0, "c"), (high, 5.0, "d")]:
    rows, norm = draw.where(examples, "velocity", velocity), SymLogNorm(0.02, vmin=-2, vmax=2)
    picture = draw.image(axes, rows, "n", "t", "wells", norm, cmap="PuOr_r")
    axes.set(xlabel="site $n$")
    axes.text(0.97, 0.03, f"$v_0 = {velocity:g}$", transform=axes.transAxes, ha="right")
    axes.set_title(f"({name})", loc="left", pad=3)
low.set_ylabel("time $t$")
bar = figure.colorbar(picture, ax=high, extend="both", ticks=[-1, -0.1, 0, 0.1, 1])
bar.ax.set_yticklabels(["−1", "−0.1", "0", "0.1", "1"])
bar.ax.minorticks_off()
bar.set_label(r"displacement $y_n / 2\pi$")
draw.save(figure, out)
