"""Figure 20: contact forces in grey (white: no contact) for a linear and a very soft well."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
forces = draw.read(f"{data}/sec34_impact/surface_mode_forces.ecsv")

figure, both = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 75 * draw.MM), sharey=True)
for axes, s, name in zip(both, [0, -0.7], ["a", "b"]):
    picture = draw.image(axes, draw.where(forces, "s", s), "n", "t", "force", PowerNorm(0.5, vmin=0, vmax=0.4), -1, cmap="gray_r")
    axes.set(xlabel="contact $n$", xlim=(0.5, 60))
    axes.set_title(f"({name}) $s = {s:g}$", loc="left")
both[0].set_ylabel("time $t$")
bar = figure.colorbar(picture, ax=both, extend="max", ticks=[0, 0.01, 0.05, 0.1, 0.2, 0.4])
bar.set_label("contact force $f_n$")
draw.save(figure, out)
