"""The bounds of `sec5_enclosures dps` once more, in another language and with another interval arithmetic.

Nothing is shared with the program but the equation: the intervals are those of mpmath with eighty digits, the guess
comes from shooting (bisection of the central strain), existence is shown for the forces P = r^(3/2) on a window
with Krawczyk's operator componentwise, and the eigenvalues are counted by the signs of principal minors. The
intervals found here are far narrower, and each has to lie in that of the program. Repeated as well are which
eigenvalues lie above 2/3, and the radius of uniqueness. Not repeated is the search for other profiles.

Called with the folder of the programs. Where mpmath is missing it says so and ends with 77, which the tests count as skipped.
"""

import csv
import subprocess
import sys

try:
    from mpmath import iv, mp, mpf, matrix
except ImportError:
    print("skipped: there is no python3-mpmath")
    sys.exit(77)

mp.dps = iv.dps = 80
N = 11  # contacts of the half chain in the window
UNIQUE = mpf(2) ** -7  # unique_radius of sec5_enclosures/dps_breathers


def low(x):
    return mp.mpf(x.a)


def high(x):
    return mp.mpf(x.b)


def left(centre, n):
    """The contact on the left of contact n, by symmetry."""
    return n - 1 if n > 0 else (1 if centre == "bond" else 0)


def shoot(centre):
    """Forces from the centre outwards: the central one is bisected between profiles that rise and that end."""
    def profile(p):
        out, before = [p], None
        for n in range(N + 1):
            r = out[-1] ** (mpf(2) / 3)  # the strain
            after = r - 2 * out[-1] - before if n else (r - 2 * p) / 2 if centre == "bond" else r - 3 * p
            if after <= 0:
                return out, "ends"
            if after >= out[-1]:
                return out, "rises"
            before = out[-1]
            out.append(after)
        return out, "ends"

    # A larger central force leads to a steeper profile
    below, above = mpf("0.02"), mpf("0.032")
    fates = [profile(below)[1], profile(above)[1]]
    assert fates[0] != fates[1], fates
    for _ in range(280):
        middle = (below + above) / 2
        below, above = (middle, above) if profile(middle)[1] == fates[0] else (below, middle)
    # Where the digits end the tail goes on as P^(3/2)
    out = profile(below)[0][:-1]
    while len(out) < N:
        out.append(out[-1] ** mpf("1.5"))
    return out


def newton(centre, strains):
    """Newton's method for the strains of the window, in numbers without bounds."""
    x = matrix(strains)
    for _ in range(10):
        f, jacobian = equations(centre, [x[i] for i in range(N)], mp)
        x = x - mp.lu_solve(jacobian, matrix(f))
    return x


def equations(centre, r, context, tail=0, slope=None):
    """F and its derivative on the window, for numbers or for intervals; with slopes of the forces that are given, or those
    at r."""
    force = [x * context.sqrt(x) for x in r]
    slope = slope or [3 * context.sqrt(x) / 2 for x in r]
    f, derivative = [], context.matrix(N, N)
    for n in range(N):
        after = force[n + 1] if n + 1 < N else tail
        f.append(r[n] - force[left(centre, n)] - 2 * force[n] - after)
        derivative[n, n] += 1 - 2 * slope[n]
        derivative[n, left(centre, n)] -= slope[left(centre, n)]
        if n + 1 < N:
            derivative[n, n + 1] -= slope[n + 1]
    return f, derivative


def remainder(inverse, derivative):
    """1 - A F', rows of intervals."""
    return [[iv.mpf(1 if i == j else 0) - sum(iv.mpf(inverse[i, k]) * derivative[k, j] for k in range(N)) for j in range(N)]
            for i in range(N)]


def enclose(centre):
    """Strains of the window and of all behind it; the box has its own width in every contact."""
    guess = newton(centre, [p ** (mpf(2) / 3) for p in shoot(centre)[:N]])
    c = [guess[i] for i in range(N)]
    inverse = equations(centre, c, mp)[1] ** -1
    width = [x * mpf(10) ** -14 for x in c]
    box = [iv.mpf([x - w, x + w]) for x, w in zip(c, width)]
    # Behind the window the map is the sum of forces, and must lead from [0, tail] into itself
    tail = iv.mpf([0, 2 * c[N - 1] * mp.sqrt(c[N - 1])])
    tail_force = tail * iv.sqrt(tail)
    assert high(box[-1] * iv.sqrt(box[-1]) + 3 * tail_force) < high(tail)
    for attempt in range(4):
        f, _ = equations(centre, [iv.mpf(x) for x in c], iv, tail_force)
        _, derivative = equations(centre, box, iv)
        image = [iv.mpf(c[i]) + sum(rest[j] * (box[j] - c[j]) - iv.mpf(inverse[i, j]) * f[j] for j in range(N))
                 for i, rest in enumerate(remainder(inverse, derivative))]
        if attempt == 0:
            for small, large in zip(image, box):
                assert low(large) < low(small) and high(small) < high(large), "the image does not lie inside the box"
        box = [iv.mpf([max(low(a), low(b)), min(high(a), high(b))]) for a, b in zip(image, box)]
    return box, tail


def quantities(centre, r, tail):
    force = [x * iv.sqrt(x) for x in r]
    rest = iv.mpf([0, high(2 * tail * tail * iv.sqrt(tail))])
    outer = sum((x * p for x, p in zip(r[1:], force[1:])), rest)
    norm = r[0] * force[0] + 2 * outer if centre == "bond" else 2 * (r[0] * force[0] + outer)
    return {"u0": force[0] + force[left(centre, 0)], "norm": norm}


def count_above(s, x):
    """Eigenvalues above x of the contact matrix: sign changes of the leading principal minors, scaled."""
    sites = len(s) + 1
    before, now, count = iv.mpf(1), None, 0
    for i in range(sites):
        d = (s[i - 1] if i > 0 else 0) + (s[i] if i < len(s) else 0) - x
        before, now = (iv.mpf(1), iv.mpf(d)) if now is None else (now, d * now - s[i - 1] ** 2 * before)
        if low(now) <= 0 <= high(now):
            return None
        count += (low(now) > 0) == (low(before) > 0)
        size = abs(low(now))
        before, now = before / size, now / size
    return count


def couplings(centre, r):
    s = [iv.sqrt(x) for x in r]
    return list(reversed(s[1:] if centre == "bond" else s)) + s


def second_eigenvalue(centre, r, tail):
    s = couplings(centre, r)
    ends = [mpf("0.6"), mpf("0.9")]
    for side in (0, 1):
        good, bad = ends[side], ends[1 - side]
        for _ in range(120):
            x = (good + bad) / 2
            n = count_above(s, iv.mpf(x))
            good, bad = (x, bad) if n is not None and (n >= 2) == (side == 0) else (good, x)
        ends[side] = good
    return iv.mpf(ends) + iv.mpf([0, high(4 * iv.sqrt(tail))])


def counts_at_edge(s, tail):
    """Certain eigenvalues above 2/3, and above 2/3 less what the tail may add: the same where the edge is free."""
    edge = iv.mpf(2) / 3
    return count_above(s, edge), count_above(s, edge - 4 * iv.sqrt(iv.mpf(high(tail))))


def alone_within(centre, r, radius):
    """Whether x - A F(x) contracts the ball of this radius, and keeps it; A is the identity behind the window."""
    c = [(low(x) + high(x)) / 2 for x in r]
    inverse = equations(centre, c, mp)[1] ** -1

    def slope(x):  # of x |x|^(1/2) on the ball around x
        return 3 * iv.sqrt(iv.mpf([max(x - radius, 0), x + radius])) / 2

    steep, behind = [slope(x) for x in c], high(slope(mpf(0)))
    f, derivative = equations(centre, [iv.mpf(x) for x in c], iv, slope=steep)
    eta = max(high(sum(abs(iv.mpf(inverse[i, k])) * abs(f[k]) for k in range(N))) for i in range(N))
    eta = max(eta, high(iv.mpf(c[N - 1]) * iv.sqrt(iv.mpf(c[N - 1]))))
    q = max(4 * behind, high(steep[N - 1]) + 3 * behind)
    for i, rest in enumerate(remainder(inverse, derivative)):
        q = max(q, high(abs(iv.mpf(inverse[i, N - 1])) * behind + sum(map(abs, rest))))
    return q < 1 and eta + q * radius <= radius


def printed(programs, centre):
    text = subprocess.run([f"{programs}/sec5_enclosures", "dps", "--centre", centre], check=True,
                          capture_output=True, text=True).stdout
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return {row["quantity"]: (mpf(float(row["lower"])), mpf(float(row["upper"]))) for row in rows}


def main():
    found = {}
    for centre in ("site", "bond"):
        r, tail = enclose(centre)
        found[centre] = quantities(centre, r, tail)
        m = second_eigenvalue(centre, r, tail)
        found[centre]["second_eigenvalue"] = m
        found[centre]["exponent"] = iv.sqrt(abs((1 - m) * (3 * m / 2 - 1)))
        above = 2 if centre == "site" else 1
        assert counts_at_edge(couplings(centre, r), tail) == (above, above), f"{centre}: eigenvalues above 2/3"
        assert alone_within(centre, r, UNIQUE), f"{centre}: another solution within {UNIQUE}?"
    site, bond = found["site"]["norm"], found["bond"]["norm"]
    barriers = {"equal_mu": 2 * (site - bond) / 5,
                "equal_norm": 2 * bond * (iv.sqrt(iv.sqrt(bond / site)) - 1) / 5}
    faults = []
    for centre in found:
        theirs = printed(sys.argv[1], centre)
        for name, x in (found[centre] | barriers).items():
            lower, upper = theirs[name]
            if not lower <= low(x) <= high(x) <= upper:
                faults.append(f"{centre} {name}: {x} is not in [{lower}, {upper}]")
    print("\n".join(faults or ["all bounds hold the intervals of mpmath"]))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
