"""Figure x36: a packet that travels and one that turns, and a breather over one period."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm

data, out = draw.arguments()
impacts = draw.read(f"{data}/sec1_the_chain/impacts.ecsv")
breather = draw.read(f"{data}/sec1_the_chain/breather.ecsv")

figure, axes = plt.subplot_mosaic([["a", "b"], ["c", "c"]], figsize=(draw.TWO_COLUMNS, 115 * draw.MM), layout="constrained")
travels, turns, moves = (axes[name] for name in "abc")
for packet, s, name in zip((travels, turns), (0, 1), "ab"):
    image, extent = draw.grid(draw.where(impacts, "s", s), "t", "n", "e")
    picture = packet.imshow(draw.np.maximum(image / image.max(), 1e-5), extent=extent, origin="lower", aspect="auto", cmap="viridis",
                          norm=LogNorm(1e-4, 1), interpolation="none")
    packet.set(xlabel="time $t$", ylabel="site $n$")
    draw.letter(packet, name, "white")
figure.colorbar(picture, ax=[travels, turns], extend="min", label="energy density $e_n$ over its largest")

for n, style, color in zip((0, 1, 2, 3), ("-", "--", "-.", ":"), ("#0072B2", "#D55E00", "#009E73", "black")):
    bead = draw.where(breather, "n", n)
    moves.plot(bead["t"], 100 * bead["y"], style, color=color, label=f"$n = {n}$")
moves.set(xlabel="time $t$", ylabel="displacement $100\\,y_n$", xlim=(0, breather["t"].max()), ylim=(-1.25, 1.6))
moves.legend(ncols=4, loc="upper center")
draw.letter(moves, "c")
draw.save(figure, out)
