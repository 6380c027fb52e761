"""Figure x06: eigenvalues of the contact matrix against the edge, and what follows in time."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
folder = f"{data}/sec33_dps_stability"
BLUE, VERMILION, GREY = "#0072B2", "#D55E00", "#888888"
LOOKS = {"site": (BLUE, "o"), "bond": (VERMILION, "s"), "control": ("black", "^")}
facts = {row["quantity"]: row["value"] for row in draw.records(f"{folder}/facts.ecsv")}

figure, panels = plt.subplots(2, 2, figsize=(draw.TWO_COLUMNS, 115 * draw.MM))
(spectrum, paths), (departures, distances) = panels
zoom = spectrum.inset_axes([0.62, 0.46, 0.34, 0.48])
for case in ["site", "bond"]:
    color, marker = LOOKS[case]
    table = draw.read(f"{folder}/contacts_{case}.ecsv")
    spectrum.plot(table["k"], table["m"], marker, color=color, ms=4 if case == "site" else 6,
                  mfc="none", mew=0.9, label=f"{case}-centred")
    zoom.plot(table["k"][1], table["from_edge"][1], marker, color=color, ms=4, mfc="none", mew=0.9)
spectrum.axhline(2 / 3, color=GREY, lw=0.8, ls="--")
zoom.axhline(0, color=GREY, lw=0.8, ls="--")
zoom.set(xlim=(1.5, 2.5), ylim=(-8, 8), xticks=[2])
zoom.set_ylabel(r"$10^6(m_2/\mu-\frac{2}{3})$", fontsize=7, labelpad=1)
zoom.tick_params(labelsize=7, pad=1.5)
spectrum.set(xlabel="number $k$", ylabel=r"eigenvalue $m_k/\mu$", xlim=(0.3, 14.7), ylim=(-0.05, 1.1))
spectrum.legend(loc="lower right", bbox_to_anchor=(1, 0.12), handletextpad=0.2)

for case, dashes in [("site", "-"), ("bond", "--"), ("control", ":")]:
    color, marker = LOOKS[case]
    table = draw.read(f"{folder}/paths_{case}.ecsv")
    for seed in np.unique(table["seed"]):
        one = draw.where(table, "seed", seed)
        paths.plot(one["t"], one["X"], dashes, color=color, lw=0.7)
    paths.plot([], [], dashes, color=color, lw=1, label=case)
paths.set(xlabel="time $t$ (units of the equation)", ylabel="displacement $X$ (sites)",
          xlim=(0, 500), ylim=(-6, 5))
paths.legend(loc="lower left", ncols=3, handlelength=1.6, columnspacing=1)

site = draw.read(f"{folder}/trials_site.ecsv")
order = np.argsort(site["growing"])
departures.plot(site["growing"][order], site["pendulum"][order], "-", color="black", lw=0.8,
                label="pendulum")
departures.plot(site["growing"], site["leaves"], "o", color=BLUE, ms=4, mfc="none", mew=0.9,
                label="site-centred")
departures.set(xscale="log", xlabel="growing part of the noise", ylim=(0, 320),
               ylabel=r"time $t$ at $|X| = \frac{1}{2}$ (units of eq.)")
departures.legend(loc="upper right")

bond = draw.read(f"{folder}/trials_bond.ecsv")
distances.plot(1e3 * bond["push_size"], bond["largest"], "s", color=VERMILION, ms=4, mfc="none",
               mew=0.9, label="bond-centred")
distances.axvline(1e3 * float(facts["freeing_push"]), color="black", lw=0.9, ls="--",
                  label="depinning push")
distances.set(xlabel=r"push of the noise, $10^3|y|$", ylabel="largest $|X|$ (sites)", ylim=(0, None))
distances.legend(loc="upper left")
draw.letter(paths, "b")
departures.text(0.03, 0.03, "(c)", transform=departures.transAxes)
spectrum.text(0.03, 0.03, "(a)", transform=spectrum.transAxes)
distances.text(0.03, 0.6, "(d)", transform=distances.transAxes)
draw.save(figure, out)
