"""Writes reference.txt: drawn quadratic forms, and what their flows add to a point, by mpmath with 60 digits.

Forms are sums of canonical ones in other coordinates, by a drawn symplectic matrix of small dyadic numbers: so that
eigenvalues and Jordan blocks are known, and all entries exact.

A line `form` has kind, degrees of freedom, the rows of S from the diagonal on, slopes, and how far errors of one in each
product may grow while exponentials are squared. The lines `flow` behind it have a duration, and what is added to each
component as two doubles whose sum it is.
"""

from random import Random

from mpmath import expm, eye, matrix, mnorm, mp, mpf

mp.dps = 60
draw = Random(20)
DURATIONS = [mpf(5) / 4, -mpf(1) / 2]
# Those of the group law besides.
OTHERS = [mpf(3) / 4, -mpf(5) / 4]


def dyadic():
    return draw.choice([1, 2, 3, 4, 6]) / mpf(4)


def oscillator(s, n, k, size):
    """A definite one, of either sign."""
    s[k, k] = s[n + k, n + k] = size * dyadic()


def generated(s, n, k, a):
    """p.(A q): Jordan blocks are those of A, and of its negative."""
    for i in range(a.rows):
        for j in range(a.rows):
            s[n + k + i, k + j] = s[k + j, n + k + i] = a[i, j]


def real_block(s, n, k, size):
    a = dyadic() * draw.choice([-1, 1]) * eye(size)
    for i in range(size - 1):
        a[i, i + 1] = mpf(1)
    generated(s, n, k, a)


def imaginary_block(s, n, k, size):
    a, frequency = matrix(2 * size, 2 * size), dyadic()
    for i in range(size):
        a[2 * i, 2 * i + 1], a[2 * i + 1, 2 * i] = frequency, -frequency
        for j in range(2 * min(1, size - 1 - i)):
            a[2 * i + j, 2 * i + 2 + j] = mpf(1)
    generated(s, n, k, a)


def zero_block(s, n, k, size):
    """One Jordan block of twice this size: q0 follows q1, ..., the last q its p, each p the p before it."""
    for i in range(k, k + size - 1):
        s[n + i, i + 1] = s[i + 1, n + i] = mpf(1)
    s[n + k + size - 1, n + k + size - 1] = mpf(draw.choice([-1, 1]))


def canonical(kind, n):
    s, k = matrix(2 * n, 2 * n), 0
    while k < n:
        left = n - k
        if kind == "definite":
            size = 1
            oscillator(s, n, k, 1)
        elif kind == "indefinite":
            size = 1
            # A saddle, then oscillators of either sign and saddles.
            if k == 0 or draw.random() < 0.3:
                real_block(s, n, k, 1)
            else:
                oscillator(s, n, k, draw.choice([-1, 1]))
        elif kind == "nilpotent":
            size = draw.randint(1, left)
            zero_block(s, n, k, size)
        elif left == 1:
            size = 1
            zero_block(s, n, k, 1)
        else:
            # The first is as large as there is place, up to a Jordan block of six.
            most = min(left, 6) if k == 0 else draw.randint(2, min(left, 6))
            block = draw.choice([real_block, imaginary_block] if left >= 4 else [real_block])
            if block is imaginary_block:
                size = 2 * (min(left // 2, 6) if k == 0 else max(2, most // 2))
                size = min(size, left - left % 2)
                block(s, n, k, size // 2)
            else:
                size = most
                block(s, n, k, size)
        k += size
    return s


def symplectic(n):
    """A product of shears of either half, and of a change of positions with that of momenta."""
    m = eye(2 * n)
    for _ in range(2 * n):
        kind, i, j, by = draw.randrange(3), draw.randrange(n), draw.randrange(n), draw.choice([-1, 1]) / mpf(2)
        one = eye(2 * n)
        if kind == 2 and i != j:
            one[i, j], one[n + j, n + i] = by, -by
        else:
            low = n * (kind % 2)
            one[n - low + i, low + j] = one[n - low + j, low + i] = by
        m = m * one
    return m


def growth(generator):
    """The largest over all durations: e -> 2 |P| e + |P|^2 for each squaring of P, from 24 products before."""
    largest = mpf(0)
    for duration in DURATIONS + OTHERS:
        a, halvings = duration * generator, 0
        while mnorm(a, mp.inf) > 0.25:
            a, halvings = a / 2, halvings + 1
        power, error = expm(a, method="taylor"), mpf(24)
        for _ in range(halvings):
            norm = 1 + mnorm(power - eye(a.rows), mp.inf)
            error = 2 * norm * error + norm**2
            power = power * power
        largest = max(largest, error)
    return largest


def written(exact):
    high = float(exact)
    return f"{high!r} {float(exact - high)!r}"


with open("reference.txt", "w") as out:
    for kind in ["definite", "indefinite", "nilpotent", "defective"]:
        for n in range(1, 13):
            m = symplectic(n)
            s = m.T * canonical(kind, n) * m
            slopes = [draw.randint(-4, 4) / mpf(8) for _ in range(2 * n)]
            generator = matrix(2 * n + 1, 2 * n + 1)
            for k in range(n):
                for j in range(2 * n):
                    generator[k, j], generator[n + k, j] = s[n + k, j], -s[k, j]
                generator[k, 2 * n], generator[n + k, 2 * n] = slopes[n + k], -slopes[k]
            entries = [s[i, j] for i in range(2 * n) for j in range(i, 2 * n)] + slopes
            assert all(mpf(float(entry)) == entry for entry in entries)
            numbers = (repr(float(entry)).removesuffix(".0") for entry in entries)
            print("form", kind, n, *numbers, f"{float(growth(generator)):.1e}", file=out)
            z = matrix([mpf(i + 1) / 4 for i in range(2 * n)] + [1])
            for duration in DURATIONS:
                added = expm(duration * generator, method="taylor") * z - z
                print("flow", float(duration), *(written(added[i]) for i in range(2 * n)), file=out)
