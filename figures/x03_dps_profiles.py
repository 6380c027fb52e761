"""Figure x03: static DpS breathers, their quasi-continuum profiles, tails and short chains."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
site = draw.read(f"{data}/sec32_dps_profiles/profile_site.ecsv")
bond = draw.read(f"{data}/sec32_dps_profiles/profile_bond.ecsv")
gap = abs(draw.read(f"{data}/sec32_dps_profiles/norms.ecsv")["gap"][0])
lengths = draw.read(f"{data}/sec32_dps_profiles/lengths.ecsv")
BLUE, VERMILION, GREY = "#0072B2", "#D55E00", "#888888"

figure, panels = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 110 * draw.MM))
(left, right), (moduli, errors) = panels
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
    moduli.semilogy(table["n"], abs(table["u"]), marker + "-", color=color, ms=3, lw=0.6,
                    mfc="none", mew=0.8, label=f"{name}-centred")
    moduli.semilogy(table["n"], abs(table["quasi_continuum"]), marker, color="black", ms=1.6, mew=0,
                    zorder=3)
    errors.semilogy(lengths["strains"], lengths[name], marker + "-", color=color, ms=3, lw=0.6,
                    mfc="none", mew=0.9, label=f"{name}-centred")
moduli.plot([], [], "o", color="black", ms=1.6, label="quasi-continuum")
moduli.set(xlabel="site $n$", ylabel="modulus $|u_n|$", xlim=(-9, 9), ylim=(1e-33, 1e2),
           xticks=range(-8, 9, 4), yticks=[10.0**k for k in range(-20, 1, 5)])
moduli.legend(loc="lower center", handlelength=1.6)
draw.letter(moduli, "c")
errors.axhline(gap, color=GREY, lw=0.8)
errors.text(1.6, gap / 3, "difference of the norms", color=GREY, ha="left", va="top")
errors.set(xlabel="strains in each half", ylabel="relative error of the norm", xlim=(1.5, 6.3),
           ylim=(1e-23, 1e3), yticks=[10.0**k for k in range(-20, 1, 5)])
errors.legend(loc="lower left", handlelength=1.6)
draw.letter(errors, "d")
draw.save(figure, out)
