"""Figure x03: static DpS breathers, their quasi-continuum profiles and their tails."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
site = draw.read(f"{data}/sec32_dps_profiles/profile_site.ecsv")
bond = draw.read(f"{data}/sec32_dps_profiles/profile_bond.ecsv")
BLUE, VERMILION, GREY = "#0072B2", "#D55E00", "#888888"

figure, panels = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 110 * draw.MM))
(left, right), (moduli, tails) = panels
for axes, table, color, marker, name in [(left, site, BLUE, "o", "a"),
                                         (right, bond, VERMILION, "s", "b")]:
    axes.axhline(0, color=GREY, lw=0.5)
    axes.plot(table["n"], table["quasi_continuum"], "-", color="black", lw=0.8,
              label="quasi-continuum")
    axes.plot(table["n"], table["u"], marker, color=color, ms=3.5, mfc="none", mew=0.9,
              label="breather")
    axes.set(xlabel="site $n$", ylabel="displacement $u_n$", xlim=(-8, 8), ylim=(-0.06, 0.06))
    axes.legend(loc="upper right", handlelength=1.6)
    draw.letter(axes, name)
for table, color, marker, name in [(site, BLUE, "o", "site"), (bond, VERMILION, "s", "bond")]:
    moduli.plot(table["n"], table["log10_u"], marker + "-", color=color, ms=3, lw=0.6,
                mfc="none", mew=0.8, label=f"{name}-centred")
    moduli.plot(table["n"], table["log10_quasi_continuum"], marker, color="black", ms=1.6, mew=0,
                zorder=3)
    right_half = table["n"] >= 1
    tails.plot(table["n"][right_half], table["tail_line"][right_half], "-", color=GREY, lw=0.8)
    tails.plot(table["n"][right_half], table["double_log"][right_half], marker, color=color, ms=3,
               mfc="none", mew=0.9, label=f"{name}-centred")
moduli.plot([], [], "o", color="black", ms=1.6, label="quasi-continuum")
moduli.set(xlabel="site $n$", ylabel=r"$\log_{10}|u_n|$", xlim=(-9, 9), ylim=(-33, 2),
           xticks=range(-8, 9, 4))
moduli.legend(loc="lower center", handlelength=1.6)
draw.letter(moduli, "c")
tails.plot([], [], "-", color=GREY, lw=0.8, label=r"slope $\ln\frac{3}{2}$")
tails.set(xlabel="site $n$", ylabel=r"$\ln(-\ln|u_n|)$", xlim=(0, 17),
          xticks=range(0, 17, 4))
tails.legend(loc="lower right", handlelength=1.6)
draw.letter(tails, "d")
draw.save(figure, out)
