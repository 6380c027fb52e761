"""Figure x36: energy density of a pulse without wells, of a packet with wells, and of a breather."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm

data, out = draw.arguments()
table = draw.table_of(f"{data}/sec1_the_chain/motions.ecsv")

figure, three = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), sharey=True, layout="constrained",
                             width_ratios=(2, 2, 1.1))
for axes, motion, name in zip(three, ("pulse", "packet", "breather"), "abc"):
    rows = [row for row in table.rows if row["motion"] == motion]
    columns = {c: draw.np.array([float(row[c]) for row in rows]) for c in ("t", "n", "e")}
    image, extent = draw.grid(columns, "n", "t", "e")
    picture = axes.imshow(draw.np.maximum(image / image.max(), 1e-5), extent=extent, origin="lower", aspect="auto", cmap="viridis",
                          norm=LogNorm(1e-4, 1), interpolation="none")
    axes.set(xlabel="site $n$")
    draw.letter(axes, name, "white")
three[0].set_ylabel("time $t$")
figure.colorbar(picture, ax=three, extend="min", label="energy density $e_n$ over its largest value")
draw.save(figure, out)
