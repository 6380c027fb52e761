"""Figure x35: which static DpS breather is stable, and by how much, against the exponent of the contact."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
table = draw.read(f"{data}/secB_other_numbers/exponents.ecsv")
alpha = table["alpha"]

figure, (a, b) = plt.subplots(1, 2, figsize=(draw.TWO_COLUMNS, 70 * draw.MM), layout="constrained")
for column, sign, style, color, label in (("margin_site", 1, "o-", "#D55E00", "site: above the edge of stability"),
                                          ("margin_bond", -1, "s--", "#0072B2", "bond: below it"),
                                          ("norm_difference", -1, "^:", "#009E73", r"norms: $1-N_{\rm bond}/N_{\rm site}$")):
    a.semilogy(alpha, sign * table[column], style, ms=3.5, lw=1, color=color, label=label)
a.set(xlabel=r"exponent $\alpha$ of the contact force", ylabel=r"margin $|m_2/\mu-1/\alpha|$, difference of norms")
b.plot(alpha, table["rate_site"], "o-", ms=3.5, lw=1, color="#D55E00", label="site: growth rate")
b.plot(alpha, table["rate_bond"], "s--", ms=3.5, lw=1, color="#0072B2", label="bond: frequency")
b.set(xlabel=r"exponent $\alpha$ of the contact force", ylabel=r"of the translational pair, over $\mu$")
for axes, name in ((a, "a"), (b, "b")):
    axes.axvline(1.5, color="0.6", lw=0.7, zorder=0)
    axes.legend(loc="lower right" if name == "a" else "upper left", bbox_to_anchor=(0.1, 0.95) if name == "b" else None, fontsize=7)
    draw.letter(axes, name)
draw.save(figure, out)
