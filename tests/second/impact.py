"""A struck first bead: its packet at one instant, and one that turns; the array of cantilevers, struck or driven."""
import numpy as np
from .chain import Chain, LONG, newton, seed

# section 3.6 of the article: steel cantilevers decorated with teflon beads, in SI units
STIFFNESS = 192 * 193e9 * (5e-3 * 1e-3**3 / 12) / 25e-3**3
MASS = 0.38 * 8e3 * 5e-3 * 1e-3 * 25e-3 + 8 / 3 * np.pi * 2.2e3 * 2.38e-3**3
HERTZ = 1.46e9 * np.sqrt(2 * 2.38e-3) / (3 * (1 - 0.46**2))
LENGTH, TIME = (STIFFNESS / HERTZ)**2, np.sqrt(MASS / STIFFNESS)
DAMPING, OMEGA, MARK = TIME / 10e-3, 2 * np.pi * 7000 * TIME, 0.01
DRIVEN = (dict(nodes=6, tol=1e-10), dict(nodes=8, tol=1e-12))


def crossing(chain, state, h, f):
    """Part of the step h at which f(y, v) vanishes, by the secant rule, and the state there."""
    b, fb, following = 0.0, f(*state), h
    while abs(following - b) > 1e-13:
        a, b, fa = b, following, fb
        there = chain.step(*state, 0.0, b)
        fb = f(*there)
        following = b - fb * (b - a) / (fb - fa)
    return b, there


def contacts(chain, beads, speed, end):
    """The time of the largest compression of every contact."""
    best, when = np.full(beads - 1, MARK), np.zeros(beads - 1)
    for t, h, old, new in chain.steps(np.zeros((beads, 1)), speed * np.eye(beads, 1), 0.0, end):
        (d0, d1), (r0, r1) = [[-np.diff(x[:, 0]) for x in pair] for pair in zip(old, new)]
        for j in np.flatnonzero((r0 > 0) & (r1 <= 0) & (np.maximum(d0, d1) > 0.97 * best)):
            tau, (top, _) = crossing(chain, old, h, lambda y, v: v[j, 0] - v[j + 1, 0])
            if top[j, 0] - top[j + 1, 0] > best[j]:
                best[j], when[j] = top[j, 0] - top[j + 1, 0], t + tau
    return when


def snapshot(level):
    """Speed 1.87, s = -1/6: the velocity of bead 114, the fastest of the packet, at t = 587."""
    _, v = Chain(s=-1 / 6, **LONG[level]).run(np.zeros((160, 1)), 1.87 * np.eye(160, 1), 587.0)
    return [("sec34_impact/surface_mode_snapshot/n=114/v", v[113].item(), 1e-12,
             "velocity of bead 114 at t = 587; impact of 1.87; s = -1/6")]


def turning(level):
    """Speed 1.9, s = 1: farthest energy centre of the eleven sites about the strongest one, and its time."""
    chain, dt, beads = Chain(s=1.0, **LONG[level]), (0.2, 0.1)[level], (50, 60)[level]
    n, place, y, v = np.arange(1, beads + 1), [], np.zeros((beads, 1)), 1.9 * np.eye(beads, 1)
    while len(place) < 800 / dt:
        y, v = chain.run(y, v, dt)
        e = chain.energies(y, v)
        e[np.abs(n - 1 - np.argmax(e)) > 5] = 0
        place.append(n @ e / e.sum())
    half_width = round(7.5 / dt)
    weight = 1 + np.cos(np.pi * np.arange(-half_width, half_width + 1) / (half_width + 1))
    mean = np.convolve(place, weight / weight.sum(), "valid")
    top = np.argmax(mean)
    a, b, c = mean[top - 1:top + 2]
    shift = (a - c) / 2 / (a - 2 * b + c)
    text = "maximum up to t = 800 of the centre of eleven sites averaged with 1 + cos(2 pi t/15); impact of 1.9; s = 1"
    return [("sec34_boomeron/turns/velocity=1.9/apex_site", b - (a - c) * shift / 4, 1e-12, text),
            ("sec34_boomeron/turns/velocity=1.9/apex_time", dt * (top + 1 + half_width + shift), 1e-12, "time of the " + text)]


def packet(level):
    """Impact of 1 m/s on the array of cantilevers: contacts reached after 10 ms, without and with losses."""
    rows, target = [], 10e-3 / TIME
    for nu, lifetime in ((0.0, 0), (DAMPING, 10)):
        when = contacts(Chain(nu=nu, **LONG[level]), (50, 60)[level], TIME / LENGTH, 1.3 * target)
        reached = np.flatnonzero(when > target)[0] + 1
        rows.append((f"sec5_experiment/journeys/velocity=1/lifetime={lifetime}/sites",
                     np.interp(target, when[:reached], np.arange(reached)), 1e-13,
                     "contacts after the first; linear at 10 ms between the times of strongest force"))
    return rows


def fold(level):
    """Follow the quiet orbit x = (y, v, a) from rest by the place of bead 1 to the first maximum of the amplitude a."""
    def orbit(x):  # periodic orbit with bead 1 at this place at t = 0, and dx/d(place)
        def rest(x):
            start, n = seed(x), len(x) // 2
            chain = Chain(nu=DAMPING, piston=(OMEGA, start[-1]), **DRIVEN[level])
            y, v = chain.run(start[:n], start[n:-1], 2 * np.pi / OMEGA)
            return np.vstack([y - start[:n], v - start[n:-1], start[:1] - place * np.eye(1, len(x) + 1)])
        x, last = newton(rest, x, 1e-11)
        return x, np.linalg.inv(last[:, 1:])[:, -1]
    place = -1e-5  # the bead goes back as the amplitude grows
    x, slope = orbit(2e-4 * np.eye(2 * (9, 11)[level] + 1)[-1])
    while abs(slope[-1]) > 1e-7:  # secant rule towards the end
        move = place / 2 if slope[-1] < -0.5 else slope[-1] * (place - last) / (old - slope[-1])
        last, old, place = place, slope[-1], place + move
        x, slope = orbit(x + slope * move)
    text = "first maximum of the piston's amplitude along the orbits of its period; 7000 Hz; energy lost in 10 ms"
    return [("sec5_experiment/folds/frequency=7000/fold", x[-1] * LENGTH * 1e6, 1e-9, text)]
