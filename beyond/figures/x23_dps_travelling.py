"""Figure x23: the travelling breather of the DpS equation, its family, and the limit of the chain's."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec5_travelling_packets"
profile = draw.read(f"{folder}/dps_profiles.ecsv")
family = draw.read(f"{folder}/dps_family.ecsv")
orbits = draw.read(f"{folder}/small_orbits.ecsv")
facts = {row["quantity"]: float(row["value"]) for row in draw.records(f"{folder}/facts.ecsv")}

figure, (a, b, c) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 62 * draw.MM),
                                 layout="constrained")
a.plot(profile["n"], profile["modulus"], "-o", ms=3.5, lw=0.9, color="#0072B2", label="exact")
a.plot(profile["n"], profile["early"], "s", ms=5, mfc="none", mew=0.8, color="#D55E00",
       label="packet, site 20")
a.plot(profile["n"], profile["late"], "^", ms=5, mfc="none", mew=0.8, color="#009E73",
       label="packet, site 100")
a.set(xlabel="site $n$", ylabel="$|A_n|$", xlim=(-6, 6), xticks=range(-6, 7, 2), ylim=(-0.005, 0.16))
a.legend(loc="upper right", fontsize=6.5)
b.plot(family["phase"], family["log_V"], "-", color="#0072B2", lw=1)
b.set(xlabel=r"angle $\varphi$", ylabel=r"$\log_{10}\,|\sum A_n|\,/\,\|A\|$", xlim=(0, 3.05))
for sign, mark, colour in ((1, "+", "#0072B2"), (-1, "x", "#D55E00")):
    one = draw.where(orbits, "sign", sign)
    c.plot(one["inverse_k"], one["scaled_energy"], mark, ms=5, mew=0.9, color=colour,
           label="type I, " + ("+" if sign > 0 else "−"))
c.plot([0], [facts["dps_energy_over_c4"]], "D", ms=4, color="#009E73", clip_on=False, label="DpS")
c.set(xlabel=r"$1/k$", ylabel=r"$E\,T^4$", xlim=(0, 0.22), ylim=(60, 95))
c.legend(loc="lower right", fontsize=7)
for axes, name in zip((a, b, c), "abc"):
    draw.letter(axes, name)
draw.save(figure, out)
