"""Figure x11: which packets turn, against impact and well, and the law of a contour."""

import draw
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.patches import Patch

data, out = draw.arguments()
cells = draw.read(f"{data}/sec34_boomeron_map/reversal_map.ecsv")
law = draw.read(f"{data}/sec34_boomeron_map/critical_s.ecsv")
contours = draw.read(f"{data}/sec34_boomeron_map/contours.ecsv")

figure, (axes, line) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 80 * draw.MM),
                                    width_ratios=[1.25, 1], layout="constrained")
vs, chis = np.unique(cells["velocity"]), np.unique(cells["chi"])


def edges(x):
    step = np.sqrt(x[1] / x[0])
    return np.append(x / step, x[-1] * step)


def image(column):
    shown = np.full((len(chis), len(vs)), np.nan)
    shown[np.searchsorted(chis, cells["chi"]), np.searchsorted(vs, cells["velocity"])] = \
        cells[column]
    return shown


fate = image("fate")
colours = ["#FFFFFF", "#FFFFFF", "#BBBBBB", "#E69F00"]
axes.pcolormesh(edges(vs), edges(chis), fate, cmap=ListedColormap(colours), vmin=-0.5, vmax=3.5,
                rasterized=True)
picture = axes.pcolormesh(edges(vs), edges(chis), np.ma.masked_invalid(image("apex")),
                          norm=LogNorm(5, 40), cmap="viridis", rasterized=True)
levels = [0.005, 0.05, 0.5, 5]
axes.contour(vs, chis, np.log10(image("s")), levels=np.log10(levels), colors="black",
             linewidths=0.6, linestyles="dotted")
for s, v in zip(levels, [33, 7.1, 1.53, 0.33]):
    axes.text(v, 0.78, f"$s={s:g}$", fontsize=6.5, rotation=72, ha="left", va="bottom")
axes.plot(law["velocity"], law["chi"], "o", ms=3, mfc="white", mec="black", mew=0.7)
axes.set(xscale="log", yscale="log", xlabel="impact velocity $v_0$", ylabel=r"$\chi = s\,v_0^{3/2}$",
         xlim=(edges(vs)[0], edges(vs)[-1]), ylim=(edges(chis)[0], edges(chis)[-1]))
axes.set_yticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
axes.minorticks_off()
axes.legend(handles=[Patch(fc=colour, ec="black", lw=0.5, label=name) for colour, name in
                     [("#FFFFFF", "escapes"), ("#BBBBBB", "stays at the end"),
                      ("#E69F00", "undecided")]], loc="upper left", fontsize=7)
axes.text(0.02, 0.03, "(a)", transform=axes.transAxes)
bar = figure.colorbar(picture, ax=axes, ticks=[5, 10, 20, 40], pad=0.01)
bar.ax.set_yticklabels(["5", "10", "20", "40"])
bar.ax.minorticks_off()
bar.set_label("turning point (site)")

line.plot(law["root_velocity"], law["chi"], "o", ms=3, mfc="white", mec="#0072B2", mew=0.8,
          label="turns at site 40")
for site, mark, colour in [(20, "^", "#009E73"), (80, "v", "#D55E00")]:
    part = draw.where(contours, "site", site)
    if len(part["chi"]):
        line.plot(np.sqrt(part["velocity"]), part["chi"], mark, ms=3.5, mfc="none", mec=colour,
                  mew=0.8, label=f"turns at site {site}")
fitted = law["velocity"] < 3
line.plot(law["root_velocity"][fitted], law["law"][fitted], color="black", lw=1,
          label=r"$\chi_0 + \chi_1 v_0^{1/2}$")
line.plot(law["root_velocity"], law["law"], color="black", lw=0.8, ls=(0, (2, 2)),
          label="beyond the fit")
line.set(xlabel=r"$v_0^{1/2}$", ylabel=r"$\chi_c = s_c v_0^{3/2}$", xlim=(0, 10.2), ylim=(0, 11))
line.legend(loc="lower right")
draw.letter(line, "b")
draw.save(figure, out)
