"""Figure 22: energy density of packets that turn round, and an ensemble of their centres."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
maps = draw.read(f"{data}/sec34_boomeron/density_maps.ecsv")
spread = draw.where(draw.read(f"{data}/sec34_boomeron/ensemble.ecsv"), "noise", 1e-6)
known = draw.read(f"{data}/sec34_boomeron/predictable.ecsv")
until = draw.where(known, "noise", 1e-6)["t"]

figure, panels = plt.subplots(4, 1, figsize=(draw.TWO_COLUMNS, 150 * draw.MM),
                              height_ratios=[1.3, 1, 1, 0.8], layout="constrained")
names = ["(a) $v_0 = 1.5$", "(b) $v_0 = 1.9$", "(c) $v_0 = 1.9$, zoom"]
for axes, panel, name in zip(panels, [1, 2, 3], names):
    picture = draw.image(axes, draw.where(maps, "panel", panel), "t", "n", "e", PowerNorm(0.5, vmin=0, vmax=0.5), cmap="magma_r")
    axes.set_ylabel("site $n$")
    axes.text(0.01, 0.94, name, transform=axes.transAxes, va="top")
for axes in (panels[1], panels[3]):
    axes.axvline(until[0], color="black", lw=0.8, ls=(0, (4, 2)))
axes = panels[3]
axes.fill_between(spread["t"], spread["low"], spread["high"], color="#56B4E9", lw=0, alpha=0.6,
                  label="10th to 90th percentile")
axes.plot(spread["t"], spread["mean"], color="#0072B2", lw=1, label="mean")
axes.set(xlabel="time $t$", ylabel="centre $X$ (site)", xlim=(0, 2500), ylim=(0, 45))
panels[1].set_xlim(0, 2500)
axes.text(0.01, 0.94, "(d) ensemble", transform=axes.transAxes, va="top")
axes.legend(loc="upper right", ncols=2)
bar = figure.colorbar(picture, ax=panels[:3], extend="max", ticks=[0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5],
                      aspect=40, pad=0.01)
bar.set_label("energy density $e_n$")
draw.save(figure, out)
