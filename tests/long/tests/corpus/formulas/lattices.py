"""Chains, rotors and lattices."""

from sympy import Piecewise, Rational, cos, cosh, exp, pi, sin

from .common import distance, exactly, half_squares, neighbours, system


# chains


def fput_bond(r, alpha, beta):
    return r**2 / 2 + alpha * r**3 / 3 + beta * r**4 / 4


@system([0.1, -0.3, 0.25, 0.5, -0.2, 0.4], [0.3, 0.1, -0.2, 0.15, 0.05, -0.4])
def fput_alpha(q, p, t):
    alpha = exactly(0.25)
    return half_squares(p), sum(fput_bond(b - a, alpha, 0) for a, b in neighbours(q))


@system([0.1, -0.3, 0.25, 0.5, -0.2, 0.4, -0.1, 0.2], [0.3, 0.1, -0.2, 0.15, 0.05, -0.4, 0.6, -0.1])
def fput_beta(q, p, t):
    beta = exactly(1.3)
    return half_squares(p), sum(fput_bond(b - a, 0, beta) for a, b in neighbours([0, *q, 0]))


@system([0.1, -0.3, 0.25, 0.5, -0.2], [0.3, 0.1, -0.2, 0.15, 0.05])
def toda(q, p, t):
    a, b = exactly(0.8, 1.2)
    stretches = [right - left for left, right in zip(q, [*q[1:], q[0]])]
    return half_squares(p), sum(a / b * exp(-b * r) + a * r for r in stretches)


@system([0.1, 0.4, 0.9, 1.2, 1.8, 2.1], [0.3, 0.1, -0.2, 0.15, 0.05, -0.3])
def frenkel_kontorova(q, p, t):
    stiffness, depth, misfit = exactly(0.9, 1.1, 0.4)
    springs = sum((b - a - misfit) ** 2 for a, b in neighbours(q)) * stiffness / 2
    return half_squares(p), springs + sum(depth / (2 * pi) ** 2 * (1 - cos(2 * pi * x)) for x in q)


@system([0.1, 0.3, -0.05, 0.2, 0.4], [0.1, -0.2, 0.05, 0.15, -0.1], spread=0.1)
def peyrard_bishop(q, p, t):
    weak, strong, width, stiffness, gain, decay = exactly(0.05, 0.075, 4.2, 0.6, 2.0, 0.35)
    depths = [weak, strong, weak, strong, weak]
    opening = sum(depth * (exp(-width * y) - 1) ** 2 for depth, y in zip(depths, q))
    stacking = sum(stiffness / 2 * (1 + gain * exp(-decay * (a + b))) * (a - b) ** 2 for a, b in neighbours(q))
    return half_squares(p), opening + stacking


@system([0.1, -0.3, 0.25, 0.5, -0.2, 0.4], [0.3, 0.1, -0.2, 0.15, 0.05, -0.4])
def diatomic(q, p, t):
    light, heavy, alpha, beta = exactly(0.7, 1.9, 0.3, 0.9)
    kinetic = sum(x**2 / (2 * light) for x in p[::2]) + sum(x**2 / (2 * heavy) for x in p[1::2])
    return kinetic, sum(fput_bond(b - a, alpha, beta) for a, b in neighbours(q))


@system([0.0, 0.9, 2.1, 2.9], [0.3, -0.2, 0.15, -0.4], spread=0.1)
def hertz_beads(q, p, t):
    diameter, hardness = exactly(1.0, 3.1)
    overlaps = [diameter - (b - a) for a, b in neighbours(q)]
    law = [Piecewise((exactly(0.4) * hardness * x ** Rational(5, 2), x > 0), (0, True)) for x in overlaps]
    return half_squares(p), sum(law)


# rotors


@system([0.2, 1.1, -0.6, 2.0, -1.4], [0.3, -0.2, 0.1, 0.4, -0.5])
def mean_field(q, p, t):
    coupling = exactly(1.4)
    n = len(q)
    order = sum(cos(x) for x in q) ** 2 + sum(sin(x) for x in q) ** 2
    return half_squares(p), coupling / 2 * (n - order / n)


@system([0.2, 1.1, -0.6, 2.0, -1.4], [0.3, -0.2, 0.1, 0.4, -0.5])
def long_range(q, p, t):
    decay = exactly(0.75)
    bonds = [(i, j) for i in range(5) for j in range(i)]
    return half_squares(p), sum((1 - cos(q[i] - q[j])) / Rational(i - j) ** decay for i, j in bonds)


@system([0.1, 0.6, 1.9, 3.0, 4.1, 5.6], [0.3, -0.2, 0.1, 0.4, -0.5, 0.2])
def sine_gordon(q, p, t):
    spacing = exactly(0.25)
    defect = Rational(13421773, 134217728)  # 0.1 in single precision
    bar = sum((b - a) ** 2 for a, b in neighbours(q)) / (2 * spacing)
    return half_squares(p) / spacing, bar + spacing * sum(1 - cos(x) for x in q) - defect * sum(map(cos, q[1::2]))


@system([0.4, -1.1, 0.8, 2.1], [0.3, -0.2, 0.6, 0.4])
def geared_pendula(q, p, t):
    inertia, gearing, *weights = exactly(0.9, 0.6, 1.0, 0.7, 1.3, 0.4)
    kinetic = half_squares(p) / inertia + gearing * sum(a * b for a, b in neighbours(p)) / (2 * inertia)
    return kinetic, -sum(weight * cos(x) for weight, x in zip(weights, q))


@system([0.4, -0.3], [0.5, 0.7])
def free_top(q, p, t):
    inertia, small = exactly(1.7, 0.1)
    a, b = p
    return (a**2 + a * b + b**2) / (2 * inertia) + small * cos(a * b), 0


# lattices


@system([0.9, 0.4, -0.5, -1.1, -0.7, 0.3], [0.3, -0.2, 0.1, 0.4, -0.5, 0.2])
def phi_four(q, p, t):
    spacing = exactly(0.5)
    slopes = sum((b - a) ** 2 for a, b in zip(q, [*q[1:], q[0]])) / (2 * spacing)
    return half_squares(p) / spacing, slopes + spacing * sum((x**2 - 1) ** 2 for x in q) / 4


@system([0.9, 0.4, -0.5, -1.1, -0.7, 2.3], [0.3, -0.2, 0.1, 0.4, -0.5, 0.2])
def planar_spins(q, p, t):
    field = exactly(0.3)
    rows = [q[:3], q[3:]]
    right = sum(cos(row[(j + 1) % 3] - row[j]) for row in rows for j in range(3))
    below = sum(2 * cos(a - b) for a, b in zip(*rows))
    return half_squares(p), -right - below - field * sum(map(cos, q))


@system([0.9, 0.4, -0.5, -1.1, -0.7], [0.3, -0.2, 0.1, 0.4, -0.5])
def network(q, p, t):
    bonds = list(zip([0, 1, 2, 3, 2], [1, 2, 0, 1, 4], exactly(1.0, 0.6, 1.4, 0.8, 0.5)))
    quartic, pinning = exactly(0.1, 0.2)
    springs = sum(k * (q[a] - q[b]) ** 2 / 2 + quartic * (q[a] - q[b]) ** 4 for a, b, k in bonds)
    return half_squares(p), springs + pinning * sum(x**4 for x in q)


@system([0, 0.1, 0, 1.1, 0, 0.3, 0.1, 0.9, -0.2, 1, 1.2, 0.2], [0.3, -0.2, 0.1, 0.4, -0.5, 0.2, 0.1, 0.3, -0.4, -0.2, 0.6, 0.1], spread=0.1)
def membrane(q, p, t):
    length, tension = exactly(0.9, 0.7)
    springs = [(0, 1), (0, 2), (1, 3), (1, 0), (2, 0), (2, 3), (3, 1), (3, 2)]
    return half_squares(p), tension * sum((distance(q, a, b, 3) - length) ** 2 for a, b in springs)


@system([0.3, -0.4, 0.5, 1.1, 0.2], [0.3, -0.2, 0.1, 0.4, -0.5])
def dimers(q, p, t):
    strong, weak, heavy = exactly(1.3, 0.6, 0.1)
    kinetic = half_squares(p) + heavy * sum(x**2 for x in p[::-2])
    bonds = sum((weak if i % 2 else strong) * (cosh(b - a) - 1) for i, (a, b) in enumerate(neighbours(q)))
    return kinetic, bonds + q[0] ** 4 / 2 + 3 * q[1] ** 4 / 2
