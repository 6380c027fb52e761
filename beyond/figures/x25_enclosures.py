"""Figure x25: enclosed strains of the DpS breathers, the search for others, and what the lemma needs."""

import draw
import matplotlib.pyplot as plt

data, out = draw.arguments()
folder = f"{data}/sec5_enclosures"
styles = {"site": ("#D55E00", "s", "-"), "bond": ("#0072B2", "o", "--")}

figure, (a, b, c) = plt.subplots(1, 3, figsize=(draw.TWO_COLUMNS, 62 * draw.MM),
                                 layout="constrained")
for name, (colour, mark, line) in styles.items():
    strains = draw.read(f"{folder}/strains_{name}.ecsv")
    a.semilogy(strains["n"], strains["upper"], mark, ms=4, mfc="none", mew=0.8, color=colour,
               label=f"{name}: $r_n$")
    a.semilogy(strains["n"], strains["relative"] * strains["lower"], mark, ms=2, color=colour,
               label="width")
    search = draw.read(f"{folder}/search_{name}.ecsv")
    shift = 0.12 if name == "site" else -0.12
    out_of_it, ball = (draw.where(search, "inside", k) for k in (0, 1))
    b.hlines(out_of_it["contact"] + shift, out_of_it["from"], out_of_it["to"], color=colour, lw=0.9,
             label=name)
    b.plot((ball["from"] + ball["to"]) / 2, ball["contact"] + shift, mark, ms=3, mfc="none", mew=0.5,
           color=colour, label="in the ball")
    lemma = draw.read(f"{folder}/lemma.ecsv")
    c.loglog(lemma["radius"], lemma[name], line, color=colour, lw=1, label=name)
a.set(xlabel="contact $n$", ylabel="strain, width", ylim=(1e-75, 10), xticks=range(0, 12, 2))
a.legend(fontsize=6.5, loc="lower left")
b.set(xlabel="central strain $r_0$", ylabel="decided at contact", xlim=(0.06, 0.255))
b.legend(fontsize=6.5, loc="upper right")
c.axhline(1, color="#888888", lw=0.8, ls=":")
c.set(xlabel=r"radius $\rho$ of the ball", ylabel=r"$\eta/\rho+q(\rho)$", ylim=(1e-6, 1e1))
c.legend(fontsize=7, loc="lower left")
for axes, name in zip((a, b, c), "abc"):
    draw.letter(axes, name, x=0.97 if name == "a" else 0.03)
draw.save(figure, out)
