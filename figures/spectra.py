"""What figures 8 and 9 share: profile and spectrum of a DpS breather at two frequencies."""

import draw
import matplotlib.pyplot as plt

BLUE, VERMILION, GREY = "#0072B2", "#D55E00", "#888888"


def profile(axes, table, mu):
    """Displacements, joined for the eye."""
    top = 0.06 * mu**2
    axes.axhline(0, color=GREY, lw=0.5)
    axes.plot(table["n"], table["u"], "o-", color=BLUE, ms=3, lw=0.7)
    axes.set(xlabel="site $n$", ylabel="profile $u_n$", xlim=(-8.5, 8.5), ylim=(-top, top),
             xticks=range(-8, 9, 4))


def plane(axes, table, mu):
    """The spectral plane; the inset enlarges the pair next to zero a hundredfold."""
    inset = axes.inset_axes([0.62, 0.68, 0.34, 0.29])
    for part, factor, marks in [(axes, 1, 3), (inset, 1e3, 4)]:
        part.axhline(0, color=GREY, lw=0.4)
        part.axvline(0, color=GREY, lw=0.4)
        part.plot(factor * table["real"], factor * table["imag"], "o", color=VERMILION, ms=marks,
                  mfc="none", mew=0.8)
    size, ticks = 3 * mu, [-2 * mu, 0, 2 * mu]
    inset.set(xlim=(-size, size), ylim=(-size, size), xticks=ticks, yticks=ticks)
    inset.set_xlabel(r"$10^3\sigma_r$", fontsize=7, labelpad=0)
    inset.set_ylabel(r"$10^3\sigma_i$", fontsize=7, labelpad=0)
    inset.tick_params(labelsize=7, pad=1.5)
    axes.set(xlabel=r"$\sigma_r$ (1 per unit of time)", ylabel=r"$\sigma_i$ (1 per unit of time)",
             xlim=(-0.3 * mu, 0.9 * mu), ylim=(-1.2 * mu, 1.2 * mu))


def main(centre, growth):
    """Two columns of two panels, and the growth rate below if there is one."""
    data, out = draw.arguments()
    folder = f"{data}/sec33_dps_stability"
    figure = plt.figure(figsize=(draw.TWO_COLUMNS, (150 if growth else 105) * draw.MM))
    cells = figure.add_gridspec(3 if growth else 2, 2)
    for column, mu in enumerate([1, 10]):
        upper, lower = (figure.add_subplot(cells[row, column]) for row in range(2))
        profile(upper, draw.read(f"{folder}/profile_{centre}_mu{mu}.ecsv"), mu)
        plane(lower, draw.read(f"{folder}/spectrum_{centre}_mu{mu}.ecsv"), mu)
        draw.letter(upper, "ab"[column])
        draw.letter(lower, "cd"[column])
        upper.text(0.97, 0.95, rf"$\mu = {mu}$", transform=upper.transAxes, ha="right", va="top")
    if growth:
        axes = figure.add_subplot(cells[2, :])
        rows = draw.where(draw.read(f"{folder}/margins.ecsv"), "centre", "site")
        mu, slope = rows["mu"], rows["exponent"]
        axes.axline((0, 0), (1, 1e3 * slope[mu == 1][0]), ls="--", color="black", lw=0.8,
                    label=r"slope at $\mu = 1$")
        axes.plot(mu, 1e3 * mu * slope, "o", color=BLUE, ms=3.5,
                  mfc="none", mew=0.9, label="computed anew at each frequency")
        axes.set(xlabel=r"frequency $\mu$", ylabel=r"$10^3\,\sigma_r$ (1 per unit of time)",
                 xlim=(0, 10.4), ylim=(0, 17))
        axes.legend(loc="lower right")
        draw.letter(axes, "e")
    draw.save(figure, out)
