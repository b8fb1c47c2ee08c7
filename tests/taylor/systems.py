"""The systems whose Taylor coefficients are compared: formulas, and where their motion begins.

Starts and parameters have few binary digits, so that they are the same numbers in Rust.
"""

from sympy import (
    Piecewise, Rational, acos, acosh, asin, asinh, atan, atanh, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh,
)

ROWS = {}


def system(q, p, t=0.0):
    """Enters a function of q, p and t that returns the parts of H, with its start."""

    def entered(energies):
        name = energies.__name__.rstrip("_")
        assert name not in ROWS, name
        ROWS[name] = (energies, q, p, t)
        return energies

    return entered


def half_squares(p):
    return sum(x**2 for x in p) / 2


def well(name, at, speed, potential):
    """One coordinate with the kinetic energy p²/2."""
    assert name not in ROWS, name
    ROWS[name] = (lambda q, p, t: (half_squares(p), potential(q[0])), [at], [speed], 0.0)


def plane(name, at, speed, potential):
    """Two coordinates with the kinetic energy of a unit mass."""
    assert name not in ROWS, name
    ROWS[name] = (lambda q, p, t: (half_squares(p), potential(*q)), at, speed, 0.0)


half = Rational(1, 2)
third = Rational(1, 3)


def absolute(x):
    return Piecewise((x, x > 0), (-x, True))


def lesser(a, b):
    return Piecewise((a, a <= b), (b, True))


def greater(a, b):
    return Piecewise((b, a <= b), (a, True))


# elementary functions, by their names

well("sin", 0.75, 0.5, lambda x: 3 * sin(x) / 2)
well("cos", 2.0, -0.25, lambda x: -cos(x))
well("tan", 0.625, 0.5, tan)
well("asin", -0.5, 0.25, asin)
well("acos", 0.375, 0.25, acos)
well("atan", -1.25, 0.5, atan)
well("sinh", 0.75, -0.5, sinh)
well("cosh", 0.75, -0.5, cosh)
well("tanh", 0.875, 0.5, tanh)
well("asinh", 1.25, 0.5, asinh)
well("acosh", 1.75, 0.25, acosh)
well("atanh", -0.375, 0.25, atanh)
well("exp", 0.5, 0.75, lambda x: exp(x) - x)
well("exp2", 0.5, 0.75, lambda x: 2**x)
well("exp_m1", -0.5, 0.75, lambda x: exp(x) - 1)
well("ln", 1.5, 0.25, log)
well("ln_1p", 0.375, 0.25, lambda x: log(1 + x))
well("log2", 1.25, -0.25, lambda x: log(x) / log(2))
well("log10", 1.25, -0.25, lambda x: log(x) / log(10))
well("cbrt", 1.5, 0.5, lambda x: x**third)
well("cbrt_of_negative", -1.5, 0.5, lambda x: -((-x)**third))
well("abs", -0.75, 0.25, lambda x: absolute(x) * x**2)
plane("min", [0.75, 0.5], [0.25, -0.5], lambda x, y: lesser(sin(x), y**2))
plane("max", [0.75, 0.5], [0.25, -0.5], lambda x, y: greater(sin(x), y**2) * x)
plane("signum", [-0.75, 0.5], [0.25, -0.5], lambda x, y: Piecewise((1, x > 0), (-1, True)) * x**2 * y)
# Steps and remainders, with the whole numbers that they have near their starts.
well("floor", 2.25, 0.5, lambda x: (x - 2) ** 3)
well("ceil", 2.25, 0.5, lambda x: (x - 3) ** 3)
well("trunc", -2.25, 0.5, lambda x: -2 * x**2)
well("round", 3.25, 0.5, lambda x: (x - 4) ** 4)
plane("remainder", [3.25, -1.25], [0.25, 0.5], lambda x, y: (x + 2 * y) ** 3)
well("powf", 1.25, 0.5, lambda x: x**Rational(5, 4))
well("powf_of_parameter", 1.25, -0.5, lambda x: (x**2 + 1) ** Rational(-11, 8))
plane("powf_of_both", [1.25, 0.5], [0.25, -0.5], lambda x, y: x**y)
plane("atan2", [0.75, -0.5], [0.25, 0.5], lambda x, y: atan(y / x) * x)  # where x is positive
plane("hypot", [0.75, -0.5], [0.25, 0.5], lambda x, y: sqrt(x**2 + y**2))

# powers and quotients

well("sqrt", 1.25, 0.5, sqrt)
well("recip", 1.25, 0.5, lambda x: 1 / x)
well("square", 0.75, 0.5, lambda x: 2 * x**2)
well("cube", 0.75, 0.5, lambda x: x**3)
well("cube_at_zero", 0.0, 0.5, lambda x: x**3)
well("fourth", 0.75, 0.5, lambda x: x**4 / 4 - x**2 / 2)
well("fourth_at_zero", 0.0, 0.5, lambda x: x**4)
well("seventh", -0.875, 0.5, lambda x: x**7)
well("seventh_at_zero", 0.0, 1.5, lambda x: x**7)
well("inverse_square", 1.25, 0.5, lambda x: x**-2)
well("inverse_sixth", 1.25, 0.5, lambda x: x**-12 - 2 * x**-6)
well("three_halves", 1.25, 0.5, lambda x: x * sqrt(x))
well("inverse_root", 1.25, 0.5, lambda x: 1 / sqrt(x))
plane("kepler", [1.0, 0.25], [-0.25, 0.75], lambda x, y: -1 / sqrt(x**2 + y**2))
plane("henon_heiles", [0.25, -0.125], [0.125, 0.375], lambda x, y: (x**2 + y**2) / 2 + x**2 * y - y**3 / 3)
plane("quotient", [0.75, -0.5], [0.25, 0.5], lambda x, y: sin(x) / (2 + y))
plane("quotient_of_negative", [0.75, -0.5], [0.25, 0.5], lambda x, y: -x / (-(2 + x * y)))
plane("products", [0.75, -0.5], [0.25, 0.5], lambda x, y: -x * (-y) * (x - y) * (x + 2 * y))
well("rational", 0.75, 0.5, lambda x: (1 + x) / (1 + x**2))
well("nested", 0.75, 0.5, lambda x: exp(-sin(sqrt(1 + x**2)) / 2))
well("sine_and_cosine", 0.75, 0.5, lambda x: sin(x) * cos(x) + sin(x))
well("cancelling", 0.75, 0.5, lambda x: cosh(2 * x) - 2 * sinh(x) ** 2 + x**2)

# branches

plane("branch_taken", [0.75, -0.5], [0.25, 0.5], lambda x, y: Piecewise((sin(x) * y, x**2 + y**2 < 1), (0, True)) + x**2)
plane("branch_left", [0.75, -0.75], [0.25, 0.5], lambda x, y: Piecewise((sin(x) * y, x**2 + y**2 < 1), (cos(x + y), True)) + x**2)
plane(
    "in_either_branch",
    [0.75, -0.75],
    [0.25, 0.5],
    lambda x, y: Piecewise((sin(x * y), x < y), (cos(x * y) + (x + y) ** 2 * Piecewise((tan(x * y), x > half), (y, True)), True)),
)
plane("clamped", [0.75, -0.75], [0.25, 0.5], lambda x, y: x * greater(lesser(y, half), -half) + x * greater(lesser(x, 1), -1))

# kinetic energies


@system([0.75], [0.5])
def relativistic(q, p, t):
    return sqrt(1 + p[0] ** 2), -cos(q[0])


@system([0.75], [0.5])
def exponential_momenta(q, p, t):
    return cosh(p[0]) + p[0] ** 4 / 4, log(1 + q[0] ** 2)


@system([0.75, 0.25], [0.5, -0.25])
def coupled_momenta(q, p, t):
    return half_squares(p) + p[0] * p[1] / 4 + (p[0] - p[1]) ** 4, q[0] ** 2 * q[1]


# time

@system([0.75], [0.5], 0.25)
def driven(q, p, t):
    return half_squares(p), q[0] * sin(3 * t / 2) + t**2 * cos(q[0])


@system([0.75], [0.5])
def driven_from_zero(q, p, t):
    return half_squares(p), q[0] ** 2 * t**3 - q[0] * t


@system([0.75], [0.5], 0.25)
def growing_mass(q, p, t):
    return p[0] ** 2 / (2 * (1 + t)), -cos(q[0] - t) * exp(-t / 2)


@system([0.75], [0.5], 0.25)
def switched(q, p, t):
    return half_squares(p), Piecewise((t * q[0] ** 3, t < half), (q[0], True))


# sums over as many coordinates as the start has

@system([0.0, 0.25, -0.5, 1.0], [0.25, 0.0, -0.125, 0.5])
def springs(q, p, t):
    bonds = [b - a for a, b in zip(q, q[1:])]
    return half_squares(p), sum(r**2 / 2 + r**4 / 4 + exp(r) / 8 for r in bonds)


SIXTEEN = [(-1) ** i * (i % 5) / 8.0 + i / 32.0 for i in range(16)]


def bond(r):
    return r**2 / 2 - r**3 / 4 + r**4 / 4


@system(SIXTEEN, SIXTEEN[::-1])
def line_between_walls(q, p, t):
    return half_squares(p), sum(bond(b - a) for a, b in zip([0, *q], [*q, 0]))


@system(SIXTEEN[:8], SIXTEEN[8:])
def line_with_ends(q, p, t):
    moving = sum(x**2 / (2 + Rational(i) / 4) for i, x in enumerate(p))
    return moving, sum(bond(b - a) for a, b in zip(q, q[1:])) - sum(cos(x) for x in q)


@system(SIXTEEN[:8], SIXTEEN[8:])
def line_from_a_wall(q, p, t):
    return half_squares(p), sum(exp(b - a) for a, b in zip([0, *q], q))


@system(SIXTEEN[:8], SIXTEEN[8:])
def line_to_a_wall(q, p, t):
    return half_squares(p), sum(sqrt(1 + (b - a) ** 2) for a, b in zip(q, [*q[1:], 0]))


@system(SIXTEEN, SIXTEEN[::-1], 0.25)
def ring(q, p, t):
    return half_squares(p), sum(t * (b - a) ** 4 + a**4 / 4 - a**2 / 2 for a, b in zip(q, [*q[1:], q[0]]))


@system([0.0, 1.0, -0.5, 0.5, 0.75, -0.75], [0.25, 0.0, -0.125, 0.5, 0.0, 0.25])
def pairs(q, p, t):
    points = list(zip(q[::2], q[1::2]))
    distances = [sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) for i, a in enumerate(points) for b in points[:i]]
    return half_squares(p), sum(-1 / r for r in distances)


@system([0.0, 1.0, -0.5, 0.5, 0.75, -0.75], [0.25, 0.0, -0.125, 0.5, 0.0, 0.25])
def pairs_within(q, p, t):
    points = list(zip(q[::2], q[1::2]))
    squares = [(a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 for i, a in enumerate(points) for b in points[:i]]
    return half_squares(p), sum(Piecewise(((s - 2) ** 2 * exp(-s), s < 2), (0, True)) for s in squares)


@system([0.0, 0.25, -0.5, 1.0], [0.25, 0.0, -0.125, 0.5])
def mean_field(q, p, t):
    along, across = sum(cos(x) for x in q), sum(sin(x) for x in q)
    return half_squares(p), -sqrt(along**2 + across**2)


@system([0.0, 0.25, -0.5, 1.0], [0.25, 0.0, -0.125, 0.5])
def sums_within_sums(q, p, t):
    inner = [sum(sin(a - b) for b in q) for a in q]
    return half_squares(p), sum(x**2 * y for x, y in zip(inner, q))


@system([0.25, -0.5, 1.0], [0.25, -0.125, 0.5])
def hoisted(q, p, t):
    return half_squares(p), sum(sin(y) * (x - y) ** 2 * exp(x) for x in q for y in q)


@system([0.25, -0.5, 1.0], [0.25, -0.125, 0.5])
def product_of_sums(q, p, t):
    return half_squares(p) + sum(p) ** 2 / 8, sum(x**2 for x in q) * sum(exp(x) for x in q)


# iterations side by side: more than eight, with numbers and conditions of their own

@system([-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0, 1.25], [0.25, 0.0, -0.125, 0.5, 0.0] * 2, 0.25)
def turns_of_their_own(q, p, t):
    alone = sum((i + 1) * x**2 * sin(x + t) for i, x in enumerate(q))
    others = sum(exp(-((x - y) ** 2)) / (i + 2) for i, x in enumerate(q) for j, y in enumerate(q) if i != j)
    return half_squares(p), alone + others / 8


@system([0.0, 1.0, 0.25, 0.5, 0.75, -0.75, 1.0, 0.25, -0.25, -1.0], [0.25, 0.0, -0.125, 0.5, 0.0] * 2)
def ring_of_points(q, p, t):
    points = list(zip(q[::2], q[1::2]))
    bonds = list(zip(points, points[1:] + points[:1]))
    ratios = [(a[0] * b[1] - a[1] * b[0]) / -(2 + a[0] ** 2 + b[1] ** 2) for a, b in bonds]
    return half_squares(p), sum(x**2 for point in points for x in point) / 2 + sum(ratios)


@system([0.5, -0.75, 1.0, 0.25, 0.0, -0.5, 0.75, 0.25, -0.25, 0.5], [0.25, 0.0, -0.125, 0.5, 0.0] * 2, 0.25)
def walls_that_move(q, p, t):
    bonds = [b - a for a, b in zip(q, q[1:])]
    walls = (q[0] - sin(2 * t)) ** 4 / 4 + t * cos(q[-1])
    return sum(x**2 / (2 * (i + 1)) for i, x in enumerate(p)), walls + sum(r**2 / 2 + r**3 / 4 for r in bonds)


@system([0.5, -0.75, 1.0, 0.25, 0.0, -0.5, 0.75, 0.25, -0.25, 0.5], [0.25, 0.0, -0.125, 0.5, 0.0] * 2)
def linear_loops(q, p, t):
    alone = sum((i + 1) * x / 8 + x**2 / 2 for i, x in enumerate(q))
    return half_squares(p), alone + sum((b - a) ** 4 for a, b in zip(q, q[1:]))


@system([0.5, -0.75, 1.0, 0.25, 0.0], [0.25, 0.0, -0.125, 0.5, 0.0])
def sum_times_products(q, p, t):
    return half_squares(p), sum(q) * sum(3 * q[0] * x for x in q[1:]) / 8


@system([0.75, -0.5], [0.25, 0.5])
def products_in_any_order(q, p, t):
    x, y = q
    return half_squares(p), Rational(3, 2) * (x**3 - y**3 / 3 + y * x**2 + x**2 * y**3) + (y - x) ** 4 + x**7 / 8


@system([0.5, -0.75, 1.0, 0.25, 0.0, -0.5, 0.75, 0.25, -0.25, 0.5] * 2, [0.25, 0.0, -0.125, 0.5, 0.0] * 4)
def lattice(q, p, t):
    rows = [q[5 * i:5 * i + 5] for i in range(4)]
    sites = sum((j + 1) * cos(x) for row in rows for j, x in enumerate(row))
    along = sum(cos(b - a) for row in rows for a, b in zip(row, row[1:]))
    across = sum(cos(b - a) for above, below in zip(rows, rows[1:]) for a, b in zip(above, below))
    return half_squares(p), q[7] * sin(q[19]) + sites - along - across / 2


# H that is not T + V: one function, named parts, bodies

@system([1.0, -0.5], [0.25, 0.375])
def double_pendulum(q, p, t):
    (a, b), (pa, pb) = q, p
    moving = (pa**2 + 2 * pb**2 - 2 * pa * pb * cos(a - b)) / (2 * (1 + sin(a - b) ** 2))
    return (moving - 2 * cos(a) - cos(b),)


@system([0.5, 8.0, -0.75], [-0.9375, 0.125, 3.75])
def geodesic(q, p, t):
    metric = 1 - 2 / q[1]
    return ((metric * p[1] ** 2 + p[2] ** 2 / q[1] ** 2 - p[0] ** 2 / metric) / 2,)


@system([0.5, 0.75], [-0.75, 0.5])
def rotating_frame(q, p, t):
    (x, y), mass = q, Rational(1, 64)
    star, planet = sqrt((x + mass) ** 2 + y**2), sqrt((x - 1 + mass) ** 2 + y**2)
    return half_squares(p) + y * p[0] - x * p[1], -(1 - mass) / star, -mass / planet


@system([1.0, 0.25], [-0.25, 0.75])
def kepler_and_interaction(q, p, t):
    return half_squares(p), -1 / sqrt(q[0] ** 2 + q[1] ** 2), q[0] ** 2 * q[1] ** 2 / 8


@system([0.75, -0.5], [0.25, 0.5], 0.25)
def field_of_time(q, p, t):
    return (p[0] - q[1] * t) ** 2 / 2 + (p[1] + t**2 * q[0]) ** 2 / 2, q[0] ** 2 / 2


@system([0.75, -0.5], [0.25, 0.5])
def twisted(q, p, t):
    return half_squares(p), sin(q[0]) * p[1] ** 2 / 4, q[0] ** 2 + q[1] ** 2


@system([0.75, -0.5], [0.25, 0.5])
def copied(q, p, t):
    return (q[0] ** 2 + 1) * (p[0] ** 2 + 1) / 2 + p[1] ** 2 / 2 - cos(q[1]) * exp(p[0] / 2), sqrt(4 + q[0] * p[1])


@system([1.0, 0.0, 0.25, 1.75, -2.5, 0.5], [0.0, 0.5, -0.375, 0.125, -0.125, -0.25])
def heliocentric(q, p, t):
    at, momenta = list(zip(q[::2], q[1::2])), list(zip(p[::2], p[1::2]))
    masses = [Rational(i + 1, 2) for i in range(3)]
    kepler = [
        (x**2 + y**2) / (2 * mass) - 4 * mass / sqrt(a**2 + b**2) for mass, (a, b), (x, y) in zip(masses, at, momenta)
    ]
    jump = [sum(momentum[d] for momentum in momenta) ** 2 / 8 for d in range(2)]
    pairs = [(i, j) for i in range(3) for j in range(i)]
    pulls = [
        -masses[i] * masses[j] / sqrt((at[i][0] - at[j][0]) ** 2 + (at[i][1] - at[j][1]) ** 2) for i, j in pairs
    ]
    return sum(kepler), sum(jump), sum(pulls)


@system([0.0, 0.25, 1.0, 0.0, -1.5, 0.75, 0.5, -2.0], [0.0, -0.5, 0.0, 0.5, 0.25, 0.0, -0.25, 0.125])
def jacobi(q, p, t):
    at, masses = list(zip(q[::2], q[1::2])), [Rational(4), Rational(1), Rational(1, 2), Rational(1, 4)]
    moving = sum((p[2 * i] ** 2 + p[2 * i + 1] ** 2) / (2 * mass) for i, mass in enumerate(masses))
    pulls = [
        -masses[i] * masses[j] / sqrt((at[i][0] - at[j][0]) ** 2 + (at[i][1] - at[j][1]) ** 2)
        for i in range(4)
        for j in range(i)
    ]
    return moving, sum(pulls)


@system([0.5, -0.75, 1.0, 0.25, 0.0, -0.5, 0.75, 0.25, -0.25, 0.5], [0.25, 0.0, -0.125, 0.5, 0.0] * 2)
def mixed_chain(q, p, t):
    alone = sum((1 + x**2) * y**2 / 2 for x, y in zip(q, p))
    return alone, sum((b - a) ** 4 / 4 + (b - a) * c / 8 for a, b, c in zip(q, q[1:], p[1:]))
