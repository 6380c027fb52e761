"""Figure x13: where the site-centred breather has its pinning pair on the circle, and the curves of exchange."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch, Rectangle

data, out = draw.arguments()
folder = f"{data}/sec33_between"
chart, curves = draw.read(f"{folder}/chart.ecsv"), draw.read(f"{folder}/exchange_curves.ecsv")
windows = draw.read(f"{folder}/windows.ecsv")

figure, axes = plt.subplots(figsize=(draw.TWO_COLUMNS, 85 * draw.MM))
image, extent = draw.grid(chart, "omega", "s", "sign")
colours = ListedColormap(["#8FC6E8", "#FBEBDD"])
colours.set_bad("#FFFFFF", alpha=0)
# What no breather covers stays hatched
axes.add_patch(Rectangle((1, -1), 1, 2, fill=False, ec="#999999", lw=0, hatch="////", zorder=0))
axes.imshow(image, extent=extent, origin="lower", aspect="auto", cmap=colours, vmin=-1, vmax=1,
            interpolation="nearest")
axes.plot(curves["omega"], curves["s"], "o", color="black", ms=1.4, mew=0, label="exchange")
axes.axhline(0, color="#888888", lw=0.6, ls="--")
axes.plot(windows["omega_site"], windows["s"], "D", color="#D55E00", ms=4, mfc="none",
          label="exchange at $s=0$")
handles = axes.get_legend_handles_labels()[0] + [
    Patch(fc=colours(0), ec="black", lw=0.4, label="site-centred on the circle"),
    Patch(fc=colours(255), ec="black", lw=0.4, label="site-centred off the circle"),
    Patch(fc="white", ec="#999999", lw=0.4, hatch="////", label="no breather found")]
axes.set(xlabel=r"frequency $\omega_b$", ylabel="anharmonicity $s$", xlim=(1, 2), ylim=(-1, 1))
axes.legend(handles=handles, loc="lower right", handlelength=1.4, frameon=True, framealpha=1,
            edgecolor="none")
draw.save(figure, out)
