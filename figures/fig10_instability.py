"""Figure 10: |v_n|^2 over site and time, perturbed, without the pinning pair, and at a bond."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
figure, panels = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 75 * draw.MM), sharey=True)
for axes, case, name in zip(panels, ["site", "control", "bond"], "abc"):
    field = draw.read(f"{data}/sec33_dps_stability/map_{case}.ecsv")
    picture = draw.image(axes, field, "n", "t", "density", PowerNorm(0.6, vmin=0, vmax=26))
    axes.set(xlabel="site $n$", xlim=(-8.5, 8.5), ylim=(0, 500))
    axes.text(0.97, 0.97, f"({name})", transform=axes.transAxes, ha="right", va="top", color="white")
panels[0].set_ylabel("time $t$ (units of the equation)")
bar = figure.colorbar(picture, ax=panels, ticks=[0, 1, 5, 10, 15, 20, 25], pad=0.01)
bar.set_label(r"$|v_n(t)|^2$")
draw.save(figure, out)
