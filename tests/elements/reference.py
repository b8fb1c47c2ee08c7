"""Prints conics.csv: states of orbital elements, to 40 digits.

A line is an orbit: gravitational parameter, distance of the pericentre, eccentricity, inclination, node, argument, mean
anomaly; position and velocity. Then how much position and velocity change, to first order, when each element but the
eccentricity changes by the same small part of itself, and when the eccentricity changes by that part of 1 at the same time
since the pericentre. Last how much each element changes when the components of the state change by the same small part of the
distance or the speed: -1 where angles or the mean anomaly are badly defined.
"""
from mpmath import mp, mpf, sqrt, sin, cos, tan, atan, atan2, acos, sinh, cosh, tanh, asinh, cbrt, pi

mp.dps = 70


def anomaly(e, mean):
    """The true anomaly, by Kepler's equation in eccentric anomalies, or by Cardano's formula for a parabola."""
    if e == 1:
        # w - 1/w = tan(f/2) solves tan(f/2) + tan³(f/2) / 3 = M.
        w = cbrt((3 * abs(mean) + sqrt(9 * mean**2 + 4)) / 2)
        return 2 * atan(w - 1 / w) * mp.sign(mean)
    if mean == 0:
        return mean
    bound = e < 1
    late = lambda E: E - e * sin(E) - abs(mean) if bound else e * sinh(E) - E - abs(mean)
    low, high = mpf(0), (pi if bound else asinh(abs(mean) / (e - 1)) + 1)
    E = (low + high) / 2
    for _ in range(3000):
        value = late(E)
        low, high = (E, high) if value < 0 else (low, E)
        after = E - value / (1 - e * cos(E) if bound else e * cosh(E) - 1)
        if not low < after < high:
            after = (low + high) / 2
        if abs(after - E) <= mpf(10) ** -65 * abs(E):
            break
        E = after
    else:
        raise ValueError("no root")
    half = sqrt((1 + e) / (1 - e)) * tan(E / 2) if bound else sqrt((e + 1) / (e - 1)) * tanh(E / 2)
    return 2 * atan(half) * mp.sign(mean)


def state(mu, q, e, i, node, argument, mean):
    f = anomaly(e, mean)
    p = q * (1 + e)
    r, rate = p / (1 + e * cos(f)), sqrt(mu / p)
    plane = [[r * cos(f), r * sin(f)], [-rate * sin(f), rate * (e + cos(f))]]
    found = []
    for x, y in plane:
        x, y = cos(argument) * x - sin(argument) * y, sin(argument) * x + cos(argument) * y
        y, z = cos(i) * y, sin(i) * y
        found += [cos(node) * x - sin(node) * y, sin(node) * x + cos(node) * y, z]
    return found


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(a):
    return sqrt(dot(a, a))


def elements(mu, numbers):
    """By the vector towards the pericentre and the energy."""
    r, v = numbers[:3], numbers[3:]
    h = cross(r, v)
    towards = [x / mu - y / norm(r) for x, y in zip(cross(v, h), r)]
    e, line = norm(towards), [-h[1], h[0], mpf(0)]
    node, argument = atan2(line[1], line[0]), acos(dot(line, towards) / norm(line) / e)
    argument = argument if towards[2] >= 0 else -argument
    q = dot(h, h) / mu / (1 + e)
    a = 1 / (2 / norm(r) - dot(v, v) / mu)
    if e < 1:
        E = atan2(dot(r, v) / sqrt(mu * a), 1 - norm(r) / a)
        mean = E - e * sin(E)
    else:
        E = asinh(dot(r, v) / sqrt(-mu * a) / e)
        mean = e * sinh(E) - E
    return [q, e, atan2(norm(line), h[2]), node, argument, mean]


def motion(e):
    """The mean motion if the gravitational parameter and the distance of the pericentre are 1."""
    return abs(1 - e) ** mpf(1.5) if e != 1 else 1 / sqrt(mpf(2))


def difference(here, there):
    by = [y - x for x, y in zip(here, there)]
    return by[:3], by[3:]


def row(numbers):
    numbers = [mpf(float(x)) for x in numbers]
    here, part = state(*numbers), mpf(10) ** -30
    e, mean = numbers[2], numbers[6]
    changed = [[x * (1 + part) if k == j else x for j, x in enumerate(numbers)] for k in (1, 3, 4, 5, 6)]
    changes = [sum(norm(difference(here, state(*there))[h]) for there in changed) / part for h in (0, 1)]
    # The eccentricity by a small part of one, at the same time since the pericentre.
    there = [*numbers[:2], e + part, *numbers[3:6], mean * motion(e + part) / motion(e)]
    changes += [norm(half) / part for half in difference(here, state(*there))]
    generic = e > 0.01 and abs(1 - e) > mpf(10) ** -10 and 0.01 < numbers[3] < 3
    back = [mpf(-1)] * 6
    if generic:
        found, back = elements(numbers[0], here), [mpf(0)] * 6
        for k in range(6):
            size = norm(here[:3]) if k < 3 else norm(here[3:])
            there = elements(numbers[0], [x + part * size if k == j else x for j, x in enumerate(here)])
            back = [c + abs(mp.fmod(y - x + 3, 2 * pi) - 3) / part for c, x, y in zip(back, found, there)]
    print(",".join([repr(float(x)) for x in numbers + here] + [f"{float(x):.3g}" for x in changes + back]))


def main():
    near = [mpf(2) ** -53, mpf(10) ** -12, mpf(10) ** -6]
    eccentricities = [mpf(0), mpf("1e-12"), mpf("0.0167"), mpf("0.5"), mpf("0.967"), 1 - near[2], 1 - near[1], 1 - near[0]]
    eccentricities += [mpf(1), 1 + 2 * near[0], 1 + near[1], 1 + near[2], mpf("1.2"), mpf("3.36"), mpf(1000)]
    places = [("0.4", "1.1", "-2.6"), ("0", "0", "1.2"), ("1.6", "-3.1", "0.01"), (pi, "0", "-0.7"), ("2.9", "2", "3.1"), ("1e-9", "0.6", "-0.2")]
    units = [(1, 1), ("2.959122e-4", "0.586"), ("1.327e20", "1.5e11"), ("398600.4418", "6678")]
    count = 0
    for e in eccentricities:
        means = [mpf(t) * motion(e) for t in ("0", "1e-9", "0.3", "-2", "50", "-1e5")]
        means += [mpf(x) for x in (["-0.1", "1.3", "-3", str(pi)] if e < 1 else ["-0.1", "1.3", "-40", "1e6"])]
        for mean in means:
            if e >= 1 or abs(mean) <= pi:
                row([*units[count % 4], e, *places[count % 6], mean])
                count += 1
        count += 1


main()
