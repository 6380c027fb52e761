"""The chain of oscillators with Hertzian contacts, its tangent flow, one integrator and Newton's method.

A state is a pair (y, v) of arrays of shape (beads, 1 + k): column 0 is the motion itself, the others are solutions of
the equations linearised about it.  A contact that opens or closes leaves half-integer powers of the time behind; the
steps (Gauss collocation) are therefore graded geometrically towards the opening and closing times of all contacts."""
import numpy as np
from numpy.polynomial import legendre

PRECISE = (dict(nodes=8, tol=1e-13), dict(nodes=10, tol=1e-15))  # periodic orbits and their multipliers
LONG = (dict(nodes=4, tol=1e-3, hmax=0.2), dict(nodes=4, tol=1e-4, hmax=0.1))  # long runs of long chains


def seed(x):
    """The vector x followed by a column for every perturbation of it."""
    return np.column_stack([x, np.eye(len(x))])


def newton(rest, x, tol):
    """Root of rest(x), whose column 0 is the value and whose other columns are the derivatives; the last rest too."""
    change = np.inf
    while np.max(np.abs(change)) > tol:
        last = rest(x)
        change = np.linalg.lstsq(last[:, 1:], -last[:, 0], rcond=None)[0]
        x = x + change
    return x, last


class Chain:
    """y_n'' + nu y_n' + y_n + s y_n^3 = (y_{n-1} - y_n)_+^{3/2} - (y_n - y_{n+1})_+^{3/2}; free ends, ring or piston.
    The piston is a wall before the first bead at piston[1] cos(piston[0] t), with one amplitude for every column."""

    def __init__(self, s=0.0, nu=0.0, ring=False, piston=None, nodes=10, hmax=0.2, tol=1e-15):
        self.s, self.nu, self.ring, self.piston, self.hmax, self.tol = s, nu, ring, piston, hmax, tol
        x, w = legendre.leggauss(nodes)
        self.c, self.b = (1 + x) / 2, w / 2
        # a: integrals, from 0 to every node, of the polynomial through the stages
        integrals = [legendre.legval(x, legendre.legint(row, lbnd=-1)) / 2 for row in np.eye(nodes)]
        self.a = np.array(integrals).T @ np.linalg.inv(legendre.legvander(x, nodes - 1))

    def compression(self, y, t, order=0):
        """Compressions of all the contacts (order 0) or their rates (order 1, y being the velocities)."""
        first, last = (y[..., -1:, :], y[..., :1, :]) if self.ring else (y[..., :1, :], y[..., -1:, :])
        if self.piston:
            omega, amplitude = self.piston
            first = np.multiply.outer(omega**order * np.cos(omega * t + order * np.pi / 2), amplitude[None, :])
        beads = np.concatenate((first, y, last), axis=-2)
        return beads[..., :-1, :] - beads[..., 1:, :]

    def acceleration(self, y, v, t):
        """Right-hand side in column 0, its linearisation in the others."""
        d, cubic = self.compression(y, t), self.s * y[..., :1]**2 * y
        force = np.sqrt(np.maximum(d[..., :1], 0)) * d
        force[..., 1:] *= 1.5
        cubic[..., 1:] *= 3
        return force[..., :-1, :] - force[..., 1:, :] - y - cubic - self.nu * v

    def energies(self, y, v):
        """Energy density e_n of the motion, every contact being counted with the bead before it."""
        y, v, d = y[:, 0], v[:, 0], self.compression(y, 0.0)[1:, 0]
        return v**2 / 2 + y**2 / 2 + self.s * y**4 / 4 + 0.4 * np.maximum(d, 0)**2.5

    def step(self, y, v, t, h):
        """One step of Gauss collocation, the accelerations k of the stages being iterated."""
        drift, nodes = y + h * np.multiply.outer(self.c, v), len(self.c)
        k = np.broadcast_to(self.acceleration(y, v, np.float64(t)), drift.shape).reshape(nodes, -1)
        old, change = np.abs(k).max(), np.inf
        while change**2 > 1e-15 * old * np.abs(k).max():  # then the next change would be rounding
            old, rise = min(old, change), h * (self.a @ k)
            place, speed = drift + h * (self.a @ rise).reshape(drift.shape), v + rise.reshape(drift.shape)
            new = self.acceleration(place, speed, t + h * self.c).reshape(nodes, -1)
            change, k = np.abs(new - k).max(), new
        return y + h * v + h**2 * (self.b @ self.a @ k).reshape(y.shape), v + h * (self.b @ k).reshape(y.shape)

    def steps(self, y, v, t, end):
        """Steps at most half way to the next, or half the way from the last, opening or closing of any contact."""
        while t < end:
            d, rate = (np.abs(self.compression(x, np.float64(t), i)[:, 0]) + 1e-300 for i, x in enumerate((y, v)))
            h = min(self.hmax, np.maximum(d / rate / 2, (self.tol / np.sqrt(rate))**(2 / 3)).min())
            h = end - t if t + 1.001 * h >= end else h
            new = self.step(y, v, t, h)
            yield t, h, (y, v), new
            t, (y, v) = t + h, new

    def run(self, y, v, end):
        """State at the time end, from that at 0."""
        for *_, (y, v) in self.steps(y, v, 0.0, end):
            pass
        return y, v
