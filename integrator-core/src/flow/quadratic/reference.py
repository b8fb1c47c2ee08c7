"""Writes reference.txt: what flows of quadratic forms add to a point, by mpmath with 60 digits.

A line: kind, degrees of freedom, duration, then each component as two doubles whose sum it is.
"""

from mpmath import expm, matrix, mp, mpf

mp.dps = 60


def form(kind, n):
    """The matrix S of a form; the same formulas are in tests.rs."""
    e = lambda i, j: mpf((7 * i + 13 * j + 5 * n + 3 * i * j) % 11 - 5) / 8
    s = matrix(2 * n, 2 * n)
    pairs = [(i, j) for i in range(2 * n) for j in range(2 * n)]
    if kind == "definite":
        for i, j in pairs:
            s[i, j] = sum(e(i, k) * e(j, k) for k in range(2 * n)) + (i == j)
        return s
    if kind == "indefinite":
        for i, j in pairs:
            s[i, j] = e(i, j) + e(j, i)
        return s
    if kind == "nilpotent":
        # One Jordan block: q0 follows q1, ..., the last q its p, each p the p before it.
        for k in range(n - 1):
            s[n + k, k + 1] = s[k + 1, n + k] = mpf(1)
        s[2 * n - 1, 2 * n - 1] = mpf(1)
    else:
        # Pairs that rotate with Jordan blocks of two, and a free particle where one is left.
        for k in range(0, n - 1, 2):
            s[k, n + k + 1] = s[n + k + 1, k] = mpf(3) / 4
            s[k + 1, n + k] = s[n + k, k + 1] = -mpf(3) / 4
            s[k, k] = s[k + 1, k + 1] = mpf(1)
        if n % 2 == 1:
            s[2 * n - 1, 2 * n - 1] = mpf(1)
    shear = matrix(2 * n, 2 * n)
    for i in range(2 * n):
        shear[i, i] = mpf(1)
    for i in range(n):
        for j in range(n):
            shear[n + i, j] = mpf((i + j) % 3 - 1) / 4
    return shear.T * s * shear


def added(kind, n, duration):
    s = form(kind, n)
    generator = matrix(2 * n + 1, 2 * n + 1)
    for k in range(n):
        for j in range(2 * n):
            generator[k, j] = duration * s[n + k, j]
            generator[n + k, j] = -duration * s[k, j]
        generator[k, 2 * n] = duration * (mpf(n + k) / 8)
        generator[n + k, 2 * n] = -duration * (mpf(k) / 8)
    z = matrix([mpf(i + 1) / 4 for i in range(2 * n)] + [1])
    return (expm(generator, method="taylor") * z - z)[: 2 * n]


with open("reference.txt", "w") as out:
    for kind in ["definite", "indefinite", "nilpotent", "defective"]:
        for n in range(1, 13):
            for duration in [mpf(11) / 8, mpf(-5) / 16]:
                numbers = []
                for exact in added(kind, n, duration):
                    high = float(exact)
                    numbers += [repr(high), repr(float(exact - high))]
                print(kind, n, float(duration), *numbers, file=out)
