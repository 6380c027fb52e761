"""Exact travelling breathers y_n(t + T) = y_{n-1}(t), T = 2 pi; growth rates of plane waves on rings; all with s = 0.

In its own time the contact between beads n - 1 and n has the compression d(t), d'' + d = F(t + T) - 2 F(t) + F(t - T)
with the force F = d_+^{3/2}.  As T is the period of the wells, the localised solution is d = K * F, K = -sin|t| for
|t| < T and 0 beyond, and bead 0 between the forces F(t) and F(t - T) moves as y(t) = int_0^T sin(x) F(t - x) dx."""
import numpy as np
from .chain import Chain, PRECISE, newton, seed

PERIOD, GRID = 2 * np.pi, 48
# waves of the ring, its sites, and eps
POINTS = ((4, 8, 1e-3), (4, 12, 1e-3), (2, 8, 1e-6), (2, 8, 1e-4), (2, 8, 1e-3), (2, 8, 1e-2))


def guess(sign, beads):
    """Newton on a coarse grid of an even d(t), t >= 0, from a modulated cosine; then beads 0, 1, ... at t = 0."""
    def rest(d):
        root = np.sqrt(np.maximum(d, 0))
        return np.column_stack([kernel @ (root * d) - d, 1.5 * kernel * root - np.eye(len(d))])
    h = PERIOD / GRID
    t = h * np.arange(beads * GRID + 1)
    kernel = sum(-h * np.sin(np.minimum(np.abs(t[:, None] + x), PERIOD)) for x in (t, -t))
    kernel[:, 0] /= 2
    d = newton(rest, sign * 0.45 * np.cos(1.5 * t) * np.cos(np.minimum(t / 3 / PERIOD, np.pi / 2))**4, 1e-8)[0]
    # d is even: the force seen by bead n at the time -nT - x is that at nT + x
    force = h * np.maximum(d, 0)[GRID * np.arange(beads)[:, None] + np.arange(GRID + 1)]**1.5
    force[:, [0, -1]] /= 2
    return np.concatenate([force @ np.sin(t[:GRID + 1]), force @ np.cos(t[:GRID + 1])])


def expand(x):
    """Beads -m ... m - 1 at t = 0 of an even wave, y_n(t) = -y_{-1-n}(-t), from y and v of the beads 0 ... m - 1."""
    y, v = np.split(x, 2)
    return np.vstack([-y[::-1], y]), np.vstack([v[::-1], v])


def breathers(level):
    """Energies of the two even waves."""
    def rest(x):  # evenness and shift: y_n = -y_{-n}, v_n = v_{-n} at T/2; the last bead is at rest
        y, v = chain.run(*expand(seed(x)), PERIOD / 2)
        return np.vstack([y[1:] + y[:0:-1], v[1:] - v[:0:-1], y[:1], v[:1]])
    chain, rows = Chain(**PRECISE[level]), []
    for sign, kind in ((-1, "lowest"), (1, "highest")):
        y, v = expand(newton(rest, guess(sign, (7, 8)[level]), 1e-12)[0][:, None])
        rows.append((f"sec5_kernel_equation/waves/k=1/sign={-sign}/energy", chain.energies(y, v).sum(), 5e-15,
                     f"energy; d even about its {kind} point; T = 2 pi"))
    return rows


def shifted(chain, start, delay):
    """Advance (y, v) by the time in which the wave moves by one site, and move it back."""
    return np.vstack([np.roll(x, 1, axis=0) for x in chain.run(*np.split(start, 2), delay)])


def plane_wave(chain, sites, eps):
    """One wavelength of the wave with mean (y_n - i v_n) e^{-iqn} = 2 eps, q = 2 pi/sites, and its delay T/sites."""
    def rest(x):
        start, delay = seed(x[:-1]), x[-1]
        end, amplitude = shifted(chain, start, delay), mode @ start
        amplitude[0] -= 2 * eps
        y, v, none = *np.split(end[:, :1], 2), np.zeros((2, 1))
        drift = np.vstack([v, chain.acceleration(y, v, 0.0), none])
        return np.hstack([np.vstack([end - start, amplitude.real, amplitude.imag]), drift])
    angle = 2 * np.pi / sites * np.arange(sites)
    mode = np.multiply.outer([1, -1j], np.exp(-1j * angle)).ravel() / sites
    x = newton(rest, np.concatenate([2 * eps * np.cos(angle), -2 * eps * np.sin(angle), angle[1:2]]), 1e-14)[0]
    return x[:-1], x[-1]


def rates(level):
    """Growth rates per unit slow time, from the multipliers of advance and shift on the whole ring."""
    chain, rows = Chain(ring=True, **PRECISE[level]), []
    for waves, ring, eps in POINTS:
        sites = ring // waves
        x, delay = plane_wave(chain, sites, eps)
        end = shifted(chain, seed(np.tile(x.reshape(2, -1), ring // sites).ravel()), delay)
        time, fastest = delay * np.sqrt(eps), np.abs(np.linalg.eigvals(end[:, 1:])).max()
        rows.append((f"sec5_experiment/chain_growth/sites={ring}/waves={waves}/eps={eps:g}/growth",
                     np.log(fastest) / time, 1e-14 / time,
                     f"fastest growth per slow time on a ring of {ring}; q = 2 pi/{sites}; eps = {eps:g}"))
    return rows
