"""Figure 18: energy density of the struck chain and of the DpS approximation."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()
maps = draw.read(f"{data}/sec34_dps_impact/impact_density_maps.ecsv")

figure, both = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), sharey=True)
for axes, column, name in zip(both, ["e_lattice", "e_dps"], ["(a) chain", "(b) DpS"]):
    picture = draw.image(axes, maps, "n", "t", column, PowerNorm(0.5, vmin=0, vmax=0.6), 1e6)
    axes.set(xlabel="site $n$", xlim=(0.5, 105))
    axes.text(0.03, 0.97, name, transform=axes.transAxes, va="top", color="white")
both[0].set_ylabel("time $t$")
bar = figure.colorbar(picture, ax=both, extend="max", ticks=[0, 0.05, 0.1, 0.2, 0.4, 0.6])
bar.set_label("energy density $10^6\\,e_n$")
draw.save(figure, out)
