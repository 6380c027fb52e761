"""Figure 24: contact forces in grey (white: no contact) for two sizes of the defect's beads."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
forces = draw.read(f"{data}/sec36_cantilever_defect/contact_forces.ecsv")

figure, both = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 80 * draw.MM), sharey=True)
for axes, ratio, name in zip(both, [1.6, 1.1], ["a", "b"]):
    norm = PowerNorm(0.5, vmin=0, vmax=3, clip=True)
    picture = draw.image(axes, draw.where(forces, "ratio", ratio), "n", "t", "force", norm, -1, cmap="gray_r")
    axes.axvline(99.5, color="#D55E00", lw=0.5, ls=(0, (4, 3)))
    axes.set(xlabel="contact $n$", xlim=(0.5, 199.5))
    axes.set_title(rf"({name}) $\tilde R_{{100}} = {ratio:g}$", loc="left")
both[0].set_ylabel("time $t$ (ms)")
bar = figure.colorbar(picture, ax=both, ticks=[0, 0.3, 1, 2, 3])
bar.ax.set_yticklabels(["0", "0.3", "1", "2", "≥ 3"])
bar.set_label("contact force $f_n$ (N)")
draw.save(figure, out)
