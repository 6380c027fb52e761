"""Figure x18: an exact travelling breather beside an impact's packet; profiles and ends."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_breathers"
profiles = draw.read(f"{folder}/profiles.ecsv")
maps = draw.read(f"{folder}/maps.ecsv")

figure, ((a, b), (c, d)) = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 115 * draw.MM),
                                        layout="constrained")
for axes, packet in ((a, 0), (b, 1)):
    image, extent = draw.grid(draw.where(maps, "packet", packet), "t", "n", "log_e")
    shown = axes.imshow(image, extent=extent, origin="lower", aspect="auto", vmin=-12, vmax=-1,
                        cmap="Greys")
    axes.set(xlabel="time", ylabel="site")
figure.colorbar(shown, ax=[a, b], label=r"$\log_{10}\,e_n$", shrink=0.9)

one = draw.where(profiles, "k", 1)
for sign, colour, dash, mark, name in [(1, "#0072B2", "-", "o", "+"), (-1, "#D55E00", "--", "s", "−")]:
    orbit = draw.where(one, "sign", sign)
    near = orbit["n"] <= 5
    n, y, v = orbit["n"][near], orbit["y"][near], orbit["v"][near]
    for part, odd, fill in ((y, -1, colour), (v, 1, "none")):
        sites = list(-n[:0:-1]) + list(n)
        values = list(odd * part[:0:-1]) + list(part)
        c.plot(sites, values, dash, marker=mark, ms=3.5, mfc=fill, mew=0.8, lw=0.8, color=colour,
               label=(r"$y_n$, " if odd < 0 else r"$\dot y_n$, ") + name)
c.axhline(0, color="#888888", lw=0.5)
c.set(xlabel="site $n$", ylabel="position, velocity", xlim=(-5.3, 5.3))
c.legend(loc="upper right", fontsize=6.5)

for k, sign, colour, dash, mark in ((1, 1, "#0072B2", "-", "o"), (1, -1, "#D55E00", "--", "s"),
                                    (3, 1, "#009E73", ":", "^")):
    orbit = draw.where(draw.where(profiles, "k", k), "sign", sign)
    d.plot(orbit["n"], orbit["log_size"], dash, marker=mark, ms=3, mfc="none", mew=0.8, lw=0.8,
           color=colour, label=f"$k={k}$, {'+' if sign > 0 else '−'}")
d.set(xlabel="distance from the centre (sites)", ylabel=r"$\log_{10}$ size", xlim=(-0.2, 8.4),
      ylim=(-24, 4))
d.legend(loc="lower left", fontsize=7)
for axes, name in zip((a, b, c, d), "abcd"):
    draw.letter(axes, name)
draw.save(figure, out)
