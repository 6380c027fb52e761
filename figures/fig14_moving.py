"""Figure 14: energy density after a kick of the bond-centred and of the site-centred breather."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import PowerNorm

data, out = draw.arguments()

figure, both = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), sharey=True)
for axes, centre, name in zip(both, ["bond", "site"], ["a", "b"]):
    table = draw.read(f"{data}/sec33_mobility/map_{centre}.ecsv")
    table["t"] *= 1e-3
    picture = draw.image(axes, table, "n", "t", "e", PowerNorm(0.5, vmin=0, vmax=5), 1e5)
    axes.set(xlabel="site $n$")
    draw.letter(axes, name, "white")
both[0].set_ylabel("time $10^{-3}\\,t$")
bar = figure.colorbar(picture, ax=both, extend="max", ticks=[0, 0.5, 1, 2, 3, 4, 5])
bar.set_label("energy density $10^5\\,e_n$")
draw.save(figure, out)
