"""Figure x13: which breather has its pinning pair on the circle, and how unstable both are."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.patches import Patch, Rectangle

data, out = draw.arguments()
folder = f"{data}/sec33_between"
chart, curves = draw.read(f"{folder}/chart.ecsv"), draw.read(f"{folder}/exchange_curves.ecsv")
windows = draw.read(f"{folder}/windows.ecsv")
multipliers = draw.read(f"{folder}/multiplier_chart.ecsv")

figure = plt.figure(figsize=(draw.TWO_COLUMNS, 150 * draw.MM))
upper, lower = figure.subfigures(2, 1, height_ratios=[85, 65])
axes = upper.subplots()


def hatch_all(axes):
    """What no breather covers stays hatched."""
    axes.add_patch(Rectangle((1, -1), 1, 2, fill=False, ec="#999999", lw=0, hatch="////", zorder=0))


image, extent = draw.grid(chart, "omega", "s", "sign")
colours = ListedColormap(["#8FC6E8", "#FBEBDD"])
colours.set_bad("#FFFFFF", alpha=0)
hatch_all(axes)
axes.imshow(image, extent=extent, origin="lower", aspect="auto", cmap=colours, vmin=-1, vmax=1,
            interpolation="nearest")
axes.plot(curves["omega"], curves["s"], "o", color="black", ms=1.4, mew=0, label="exchange")
axes.axhline(0, color="#888888", lw=0.6, ls="--")
axes.plot(windows["omega_site"], windows["s"], "D", color="#D55E00", ms=4, mfc="none",
          label="exchange at $s=0$")
handles = axes.get_legend_handles_labels()[0] + [
    Patch(fc=colours(0), ec="black", lw=0.4, label="site-centred on the circle"),
    Patch(fc=colours(255), ec="black", lw=0.4, label="bond-centred on the circle"),
    Patch(fc="white", ec="#999999", lw=0.4, hatch="////", label="no breather found")]
axes.set(xlabel=r"frequency $\omega_b$", ylabel="anharmonicity $s$", xlim=(1, 2), ylim=(-1, 1))
axes.legend(handles=handles, loc="lower right", handlelength=1.4, frameon=True, framealpha=1,
            edgecolor="none")
axes.text(0.035, 0.96, "(a)", transform=axes.transAxes, va="top")

panels = lower.subplots(1, 2, sharey=True)
shades = plt.get_cmap("viridis").copy()
shades.set_under("#FFFFFF")
shades.set_bad("#FFFFFF", alpha=0)
for axes, centre, name in zip(panels, ["site", "bond"], "bc"):
    image, extent = draw.grid(multipliers, "omega", "s", f"excess_{centre}")
    hatch_all(axes)
    picture = axes.imshow(image.clip(1e-12), extent=extent, origin="lower", aspect="auto", cmap=shades,
                          norm=LogNorm(1e-5, 1), interpolation="nearest")
    axes.contour(image.clip(1e-12), levels=[1e-3], extent=extent, origin="lower",
                 colors="#D55E00", linewidths=0.9)
    axes.axvline(1.1, color="#888888", lw=0.6, ls="--")
    axes.set(xlabel=r"frequency $\omega_b$", xlim=(1, 2), ylim=(-1, 1))
    axes.text(0.97, 0.06, f"({name}) {centre}-centred", transform=axes.transAxes, ha="right",
              bbox={"fc": "white", "ec": "none", "pad": 1.5})
panels[0].set_ylabel("anharmonicity $s$")
bar = lower.colorbar(picture, ax=panels, pad=0.01, extend="min")
bar.set_label(r"largest $|\lambda|-1$")
bar.ax.axhline(1e-3, color="#D55E00", lw=1.2)
draw.save(figure, out)
