"""Figure x36: a packet that travels and one that turns, a breather over one period, and its Floquet multipliers."""

import draw
import matplotlib.pyplot as plt
from matplotlib.colors import LogNorm

data, out = draw.arguments()
impacts = draw.read(f"{data}/sec1_the_chain/impacts.ecsv")
breather = draw.read(f"{data}/sec1_the_chain/breather.ecsv")
multipliers = draw.read(f"{data}/sec1_the_chain/multipliers.ecsv")

figure, ((travels, turns), (moves, circle)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 125 * draw.MM), layout="constrained")
for axes, s, name in zip((travels, turns), (0, 1), "ab"):
    image, extent = draw.grid(draw.where(impacts, "s", s), "t", "n", "e")
    picture = axes.imshow(draw.np.maximum(image / image.max(), 1e-5), extent=extent, origin="lower", aspect="auto", cmap="viridis",
                          norm=LogNorm(1e-4, 1), interpolation="none")
    axes.set(xlabel="time $t$", ylabel="site $n$")
    draw.letter(axes, name, "white")
figure.colorbar(picture, ax=[travels, turns], extend="min", label="energy density $e_n$ over its largest")

for n, style, color in zip((0, 1, 2, 3), ("-", "--", "-.", ":"), ("#0072B2", "#D55E00", "#009E73", "black")):
    bead = draw.where(breather, "n", n)
    moves.plot(bead["t"], 100 * bead["y"], style, color=color, label=f"$n = {n}$")
moves.set(xlabel="time $t$", ylabel="displacement $100\\,y_n$", xlim=(0, breather["t"].max()), ylim=(-1.25, 2.1))
moves.legend(ncols=2, loc="upper center", columnspacing=1.5)
draw.letter(moves, "c")

angle = draw.np.linspace(0, 2 * draw.np.pi, 200)
circle.plot(draw.np.cos(angle), draw.np.sin(angle), "-", color="0.7", linewidth=0.8)
circle.plot(multipliers["real"], multipliers["imag"], "o", color="#0072B2", markerfacecolor="none")
circle.set(xlabel="Re $\\lambda$", ylabel="Im $\\lambda$", aspect="equal", xlim=(-1.15, 1.15), ylim=(-1.15, 1.15))
draw.letter(circle, "d")
draw.save(figure, out)
