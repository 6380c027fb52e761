"""Figure x17: a breather spreads in ever softer wells."""

import draw
import matplotlib.pyplot as plt
import numpy as np

data, out = draw.arguments()
softer = draw.read(f"{data}/sec2_soft_wells/softer_wells.ecsv")
profiles = draw.read(f"{data}/sec2_soft_wells/softer_profiles.ecsv")

figure, (profile, width) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 60 * draw.MM))
stiffnesses = np.unique(profiles["kappa"])[::-1]
for k, mark, color in zip(stiffnesses, "os^vD",
                          ["#0072B2", "#D55E00", "#009E73", "#E69F00", "black"]):
    one = draw.where(profiles, "kappa", k)
    profile.plot(one["n"], one["force"], mark + "-", ms=2, lw=0.7, color=color,
                 label=f"$k = 1/{1 / k:.0f}$")
profile.set(xlabel="contact, from the centre", ylabel=r"mean contact force $\bar F_n$",
            xlim=(-40, 40))
profile.legend(loc="upper right", handlelength=1.2)
for column, mark, color, label in [("width", "o-", "#0072B2", "width / site"),
                                   ("amplitude", "s--", "#D55E00", "amplitude"),
                                   ("central", "^:", "#009E73", "central mean force")]:
    width.plot(softer["kappa"], softer[column], mark, ms=3, color=color, label=label)
facts = {row["quantity"]: float(row["value"])
         for row in draw.records(f"{data}/sec2_soft_wells/facts.ecsv")}
width.axhline(facts["central_theory"], color="black", ls="-.", lw=0.7, label="equal areas")
width.set(xlabel=r"stiffness $k$ of the wells", xscale="log", yscale="log", ylim=(4e-3, 1e3))
width.set_xticks(stiffnesses, [f"1/{1 / k:.0f}" for k in stiffnesses], minor=False)
width.set_xticks([], minor=True)
width.legend(loc="upper right", ncols=2, columnspacing=1)
for axes, name in [(profile, "a"), (width, "b")]:
    axes.set_title(f"({name})", loc="left", pad=3)
draw.save(figure, out)
