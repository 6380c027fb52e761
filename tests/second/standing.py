"""Standing breathers of frequency 1.1: energies, amplitudes, and the multipliers of their translation mode."""
import numpy as np
from .chain import Chain, PRECISE, newton, seed

PERIOD, BEADS = 2 * np.pi / 1.1, (16, 20)


def breather(chain, site, level):
    """Positions at the turning point t = 0, among the symmetric motions, from the article's quasi-continuum profile.

    With (Ry)_n = y_{-n} the site-centred breather has y = -Ry, v = Rv at a quarter of the period; the bond-centred one
    has y = -Ry always, and v = 0 at half the period."""
    def rest(y):
        start = seed(y)
        end, speed = chain.run(start, 0 * start, PERIOD / 4 if site else PERIOD / 2)
        return np.vstack([end + end[::-1], speed - speed[::-1]] if site else [start + start[::-1], speed])
    n = np.arange(BEADS[level] + site) - (BEADS[level] + site - 1) / 2
    g = [np.cos(np.clip(x / 3, -np.pi / 2, np.pi / 2))**6 for x in (n - 0.5, n + 0.5)]
    return newton(rest, 0.191 * 0.3**3 * (-1.0)**np.ceil(n) * (g[0] + g[1]), 1e-14)[0]


def area(chain, y, part):
    """Integral over a period of the sum of the squared velocities, which is the same in each `part` of the period."""
    start, total = y[:, None], 0.0
    for t, h, (here, speed), _ in chain.steps(start, 0 * start, 0.0, PERIOD * part):
        for c, b in zip(chain.c, chain.b):
            total += h * b * np.sum(chain.step(here, speed, t, h * c)[1]**2)
    return total / part


def barrier(level):
    """Barriers and amplitudes at s = 0."""
    chain = Chain(**PRECISE[level])
    site, bond = (breather(chain, centre, level) for centre in (True, False))
    energy = [chain.energies(y[:, None], 0 * y[:, None]).sum() for y in (site, bond)]
    areas = area(chain, site, 1 / 4) - area(chain, bond, 1 / 2)
    return [("pn.omega11", energy[0] - energy[1], 1e-17, "energy site-centred minus bond-centred; omega 1.1; s = 0"),
            ("sec32_barrier/key_pairs/s=0/omega=1.1/equal_area", energy[0] - energy[1] - areas / PERIOD, 4e-17,
             "the same minus the difference of the areas over the period (to first order in it); areas by quadrature"),
            ("sec5_enclosures/chain_breathers/centre=site/amplitude", np.abs(site).max(), 4e-17, "largest |y_n| at rest; site-centred"),
            ("sec5_enclosures/chain_breathers/centre=bond/amplitude", np.abs(bond).max(), 4e-17, "the same; bond-centred")]


def kappa(chain, site, y):
    """(lambda + 1/lambda - 2)/4 of the translation mode, for the site-centred (or bond-centred) breather.

    Let A be dy(end)/dy(0) over T/2 (or T).  That flow followed by -R (or R) keeps the orbit and is reversible: -RA (or
    RA) has the eigenvalues (mu + 1/mu)/2, lambda = mu^2 (or mu).  The translation mode has the eigenvalue of (1 - RA)/2
    next to zero; the drift in time is far from it."""
    end, _ = chain.run(seed(y), 0 * seed(y), PERIOD / 2 if site else PERIOD)
    roots = np.linalg.eigvals((np.eye(len(y)) - end[::-1, 1:]) / 2)
    near = -roots[np.argmin(np.abs(roots))].real
    return 4 * near * (1 + near) if site else near


def pinning(level):
    """kappa of both breathers at s = 0, and the s at which it vanishes, from three."""
    rows = []
    for site, kind, rounding in ((True, "site", 8e-15), (False, "bond", 2e-15)):
        grid = (0.0, 0.15, 0.155)
        chains = [Chain(s=s, **PRECISE[level]) for s in grid]
        found = [kappa(chain, site, breather(chain, site, level)) for chain in chains]
        rows.append((f"sec33_floquet/harmonic/centre={kind}/kappa", found[0], rounding,
                     "(lambda + 1/lambda - 2)/4 of the translation mode; omega 1.1; s = 0"))
        zero = np.polyval(np.polyfit(np.array(found) * 1e8, grid, 2), 0.0)
        rows.append((f"floquet.s0_{kind}", zero, rounding * 0.005 / abs(found[2] - found[1]),
                     f"s at kappa = 0; parabola through s = 0, 0.15 ({found[1]:.1e}) and 0.155 ({found[2]:.1e})"))
    return rows
