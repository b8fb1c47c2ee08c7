"""Prints orbits.csv: Kepler motion in the plane, to 40 digits.

A line is an orbit: q, p, inverse mass, k, duration; q and p after it; how much each of these four numbers changes,
to first order, when every number that it follows from changes by the same small part of itself.
"""
from mpmath import mp, mpf, sqrt, sin, cos, sinh, cosh, asinh, pi

mp.dps = 90


def functions(beta, s):
    x = beta * s * s
    if abs(x) < mpf(10) ** -20:
        terms = [sum((-x) ** n / mp.factorial(2 * n + k) for n in range(6)) for k in (1, 2, 3)]
        return s * terms[0], s**2 * terms[1], s**3 * terms[2]
    b = sqrt(abs(beta))
    g1, g0 = (sin(b * s) / b, cos(b * s)) if beta > 0 else (sinh(b * s) / b, cosh(b * s))
    return g1, (1 - g0) / beta, (s - g1) / beta


def moved(q, p, w, k, t):
    v, mu = [w * x for x in p], k * w
    r0 = sqrt(sum(x * x for x in q))
    eta, beta = sum(x * y for x, y in zip(q, v)), 2 * mu / r0 - sum(x * x for x in v)
    zeta = mu - beta * r0
    rest = t
    if beta > 0:
        period = 2 * pi * mu / beta**1.5
        rest = t - period * mp.nint(t / period)

    def late(s):
        g1, g2, g3 = functions(beta, s)
        return r0 * s + eta * g2 + zeta * g3 - rest, r0 + eta * g1 + zeta * g2

    # The time grows with s: an interval around the root is halved wherever Newton's method leaves it.
    low, high = (mpf(0), mp.cbrt(121 * rest / abs(mu))) if rest > 0 else (-mp.cbrt(-121 * rest / abs(mu)), mpf(0))
    if beta < 0:
        # The anomalies at both ends: that of the start is on the way back where the body falls.
        far = 2 * asinh((abs(rest) * abs(beta) ** 1.5 + r0 * abs(beta)) / abs(mu) * 1000 + 1000) / sqrt(-beta) + 1
        low, high = max(low, -far), min(high, far)
    s = (low + high) / 2
    for step in range(2000):
        value, slope = late(s)
        if value < 0:
            low = s
        else:
            high = s
        after = s - value / slope
        if not low < after < high:
            after = (low + high) / 2
        if abs(after - s) < mpf(10) ** -75 * abs(s):
            break
        s = after
    else:
        raise ValueError("no root")
    g1, g2, g3 = functions(beta, s)
    r = r0 + eta * g1 + zeta * g2
    f, g = 1 - mu * g2 / r0, rest - mu * g3
    f_dot, g_dot = -mu * g1 / (r * r0), 1 - mu * g2 / r
    return [f * x + g * y for x, y in zip(q, v)] + [(f_dot * x + g_dot * y) / w for x, y in zip(q, v)]


def conditioned(numbers):
    def outcome(numbers):
        return moved(numbers[:2], numbers[2:4], *numbers[4:])

    here, part = outcome(numbers), mpf(10) ** -30
    changes = [mpf(0)] * 4
    for i in range(7):
        there = outcome([x * (1 + part) if i == j else x for j, x in enumerate(numbers)])
        changes = [c + abs(y - x) / part for c, x, y in zip(changes, here, there)]
    return here, changes


def start(e, anomaly, a=1):
    """Positions and velocities at unit strength, from the eccentric anomaly, or sqrt(2) tan(f/2) of a parabola."""
    if e == 1:
        r, x, y = 1 + anomaly**2 / 2, 1 - anomaly**2 / 2, sqrt(mpf(2)) * anomaly
        return x, y, -anomaly / r, sqrt(mpf(2)) / r
    if e < 1:
        root, c, s = sqrt(1 - e * e), cos(anomaly), sin(anomaly)
        r = 1 - e * c
        return c - e, root * s, -s / r, root * c / r
    root, c, s = sqrt(e * e - 1), cosh(anomaly), sinh(anomaly)
    r = e * c - 1
    return e - c, root * s, -s / r, root * c / r


def main():
    tiny = [mpf(10) ** -6, mpf(10) ** -12]
    eccentricities = [mpf(0), mpf("0.05"), mpf("0.6"), mpf("0.99"), 1 - tiny[0], 1 - tiny[1], mpf(1)]
    eccentricities += [1 + tiny[0], mpf("1.3"), mpf(20)]
    durations = ["1e-9", "-0.02", "0.4", "-2.9", "3.2", "45.7", "-6000.25"]
    for e in eccentricities:
        for anomaly in ["0.001", "-2.3", "3.1"]:
            for number, duration in enumerate(durations):
                x, y, u, v = start(e, mpf(anomaly))
                turn, w, k = mpf(0.7), mpf(2 if number % 2 else 1) / 4, mpf(8 if number % 2 else 3)
                rate = sqrt(w * k)
                c, s = cos(turn), sin(turn)
                q, p = [c * x - s * y, s * x + c * y], [(c * u - s * v) * rate / w, (s * u + c * v) * rate / w]
                write([*q, *p, w, k, mpf(duration) / rate])
    for q, p, k, t in [((2, 1), (-3, -1), -1, 1.5), ((0.5, 0), (0, 0.25), -2, -3), ((1, 3), (0.5, 0), -1e-6, 50)]:
        write([*map(mpf, q), *map(mpf, p), mpf(1), mpf(k), mpf(t)])
    # Falls from far away towards the pericentre of a hyperbola, to just before it, to it, and beyond; and back in time.
    for distance, speed, impact in [(1e2, 30, 1), (1e2, 3, 0.01), (1e4, 1, 0.1), (1e4, 300, 1), (1e6, 3, 0.01), (1e6, 300, 0.01)]:
        for part in ["0.1", "0.4", "0.6", "-0.99", "1", "-1.0001", "2.5"]:
            way = mpf(distance) / speed * mpf(part)
            speed_to = -speed if way > 0 else speed
            for turn, w, k in [(mpf(0), mpf(1), mpf(1)), (mpf(0.7), mpf(0.5), mpf(2)), (mpf(2.2), mpf(2), mpf(-0.5))]:
                c, s = cos(turn), sin(turn)
                x, y, u, v = mpf(distance), mpf(impact), mpf(speed_to), mpf(0)
                write([c * x - s * y, s * x + c * y, (c * u - s * v) / w, (s * u + c * v) / w, w, k, way])


def write(numbers):
    numbers = [mpf(float(x)) for x in numbers]
    here, changes = conditioned(numbers)
    print(",".join([repr(float(x)) for x in numbers + here] + [f"{float(x):.3g}" for x in changes]))


main()
