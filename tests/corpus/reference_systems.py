"""The systems of the corpus as formulas, with the parameters and points that they are evaluated at."""

from dataclasses import dataclass
from typing import Callable
from sympy import Piecewise, Rational, acos, asin, asinh, atan, atan2, atanh, cos, cosh, exp, log, pi, sin, sinh
from sympy import sqrt, tan, tanh

SYSTEMS = {}


@dataclass
class System:
    energies: Callable
    q: list
    p: list
    t: float
    spread: float

    def points(self):
        """The start, and two more around it. All are multiples of 1/1024, so that they are exact in binary."""
        yield rounded(self.q), rounded(self.p), self.t
        for seed in (1, 2):
            noise = pseudo_random(seed)
            moved = [[x + self.spread * next(noise) for x in part] for part in (self.q, self.p)]
            yield rounded(moved[0]), rounded(moved[1]), self.t * (1 + seed) + 0.25 * seed * (self.t != 0)


def rounded(numbers):
    return [round(1024 * number) / 1024 for number in numbers]


def pseudo_random(seed):
    """Numbers between -1 and 1 by a linear congruence, the same on every machine."""
    state = 12345 * seed + 1
    while True:
        state = (1103515245 * state + 12345) % 2**31
        yield 2 * state / 2**31 - 1


def system(q, p, t=0.0, spread=0.25):
    """Enters a function of q, p and t that returns T and V."""

    def entered(energies):
        SYSTEMS[energies.__name__] = System(energies, q, p, t, spread)
        return energies

    return entered


def exactly(*numbers):
    """Parameters as the f64 that a Rust literal is."""
    exact = [Rational(number) for number in numbers]
    return exact[0] if len(exact) == 1 else exact


def half_squares(p):
    return sum(x**2 for x in p) / 2


def neighbours(q):
    return list(zip(q, q[1:]))


@system([0.3, -0.2], [0.1, 0.35])
def henon_heiles(q, p, t):
    x, y = q
    return half_squares(p), (x**2 + y**2) / 2 + x**2 * y - y**3 / 3


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


# galaxies


@system([1.0, 0.3, 0.4], [-0.2, 0.9, 0.3])
def logarithmic(q, p, t):
    speed, core, flattening = exactly(1.1, 0.2, 0.8)
    x, y, z = q
    return half_squares(p), speed**2 / 2 * log(core**2 + x**2 + y**2 + z**2 / flattening**2)


@system([1.0, 0.3, 0.4], [-0.2, 0.7, 0.3])
def miyamoto_nagai(q, p, t):
    strength, length, height = exactly(1.3, 0.7, 0.3)
    x, y, z = q
    return half_squares(p), -strength / sqrt(x**2 + y**2 + (length + sqrt(z**2 + height**2)) ** 2)


@system([0.8, -0.2], [0.2, 0.7])
def plummer(q, p, t):
    strength, radius = exactly(1.0, 0.6)
    return half_squares(p), -strength / sqrt(q[0] ** 2 + q[1] ** 2 + radius**2)


@system([1.1, -0.2], [0.2, 0.8])
def hernquist(q, p, t):
    strength, scale = exactly(1.5, 0.5)
    return half_squares(p), -strength / (sqrt(q[0] ** 2 + q[1] ** 2) + scale)


@system([1.1, -0.2, 0.4], [0.2, 0.8, 0.3])
def navarro_frenk_white(q, p, t):
    strength, scale = exactly(4.0, 1.7)
    r = sqrt(sum(x**2 for x in q))
    return half_squares(p), -strength / r * log(1 + r / scale)


@system([0.8, -0.2], [0.2, 0.7])
def isochrone(q, p, t):
    strength, scale = exactly(1.2, 0.4)
    return half_squares(p), -strength / (scale + sqrt(scale**2 + q[0] ** 2 + q[1] ** 2))


@system([1.2, -0.3], [0.2, 0.8], t=0.75)
def rotating_bar(q, p, t):
    disk, bulge, strength, speed = exactly(1.4, 0.3, 0.6, 0.45)
    x, y = q
    r2 = x**2 + y**2
    bar = strength * r2 / (1 + r2) ** 3 * cos(2 * (atan2(y, x) - speed * t))
    return half_squares(p), -disk / sqrt(1 + r2) - bulge / (Rational(1, 4) + sqrt(r2)) + bar


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


# clusters


def distance(q, a, b, dimension):
    return sqrt(sum((q[dimension * a + d] - q[dimension * b + d]) ** 2 for d in range(dimension)))


def all_distances(q, dimension):
    count = len(q) // dimension
    return [distance(q, i, j, dimension) for i in range(count) for j in range(i)]


@system([0, 0.1, 0, 1.1, 0, 0.1, 0.5, 1, 0, 1.9, 1.2, 0.6], [0.3, -0.2, 0.1, 0.2, -0.3, 0.2, 0.1, 0.3, -0.4, -0.2, 0.5, 0.1], spread=0.05)
def lennard_jones(q, p, t):
    mass, sigma, epsilon, cutoff = exactly(1.1, 1.0, 0.9, 1.9)
    pairs = [Piecewise((4 * epsilon * ((sigma / r) ** 12 - (sigma / r) ** 6), r < cutoff), (0, True))
             for r in all_distances(q, 3)]
    return half_squares(p) / mass, sum(pairs)


@system([0, 0.1, 1.1, 0, 0.5, 1, 2.3, 1.2], [0.3, -0.2, 0.1, 0.2, -0.3, 0.2, 0.1, -0.1], spread=0.05)
def morse(q, p, t):
    depth, width, length, cutoff = exactly(1.2, 1.5, 1.1, 2.25)
    pairs = [Piecewise((depth * ((1 - exp(-width * (r - length))) ** 2 - 1), r < cutoff), (0, True))
             for r in all_distances(q, 2)]
    return half_squares(p), sum(pairs)


@system([0, 0.1, 1.1, 0, 2.4, 1], [0.3, -0.2, 0.1, 0.2, -0.3, 0.2])
def colloids(q, p, t):
    strength, screening, cutoff = exactly(1.5, 0.8, 2.0)
    end = strength * exp(-screening * cutoff) / cutoff
    tangent = [end * (1 - (screening + 1 / cutoff) * (r - cutoff)) for r in all_distances(q, 2)]
    pairs = [Piecewise((strength * exp(-screening * r) / r - line, r < cutoff), (0, True))
             for r, line in zip(all_distances(q, 2), tangent)]
    return half_squares(p), sum(pairs)


@system([0, 0.1, 0, 1.1, 0, 0.1, -0.5, 1, 0], [0.3, -0.2, 0.1, 0.2, -0.3, 0.2, 0.1, 0.2, 0.1], spread=0.1)
def bond_angles(q, p, t):
    stiffness, bending = exactly(3.0, 4e-4)
    a, b = distance(q, 0, 1, 3), distance(q, 0, 2, 3)
    dot = sum((q[3 + d] - q[d]) * (q[6 + d] - q[d]) for d in range(3))
    bent = 180 / pi * (acos(dot / (a * b)) - acos(Rational(-1, 3)))
    return half_squares(p), stiffness / 2 * ((a - 1) ** 2 + (b - 1) ** 2) + bending / 2 * bent**2


# many bodies


@system([0, 0.1, 0, 1.1, 0, 0.1, -0.5, 1, 0, -1, -1, 0.5], [0.3, -0.2, 0.1, 0.2, 0.3, 0.2, -0.4, -0.1, 0, 0.1, -0.1, 0.1])
def gravity(q, p, t):
    *masses, constant, softening = exactly(1.0, 0.5, 0.8, 0.2, 0.9, 0.1)
    products = [masses[i] * masses[j] for i in range(4) for j in range(i)]
    kinetic = sum(half_squares(p[3 * i:3 * i + 3]) / masses[i] for i in range(4))
    pairs = zip(products, all_distances(q, 3))
    return kinetic, -constant * sum(m / sqrt(r**2 + softening**2) for m, r in pairs)


@system([-0.97, 0.243, 0, 0, 0.97, -0.243], [0.46, 0.43, -0.93, -0.86, 0.47, 0.44], spread=0.05)
def three_bodies(q, p, t):
    return half_squares(p), -sum(1 / r for r in all_distances(q, 2))


@system([0, 0.1, -1.1, 0.1, 0, 0.1, -0.1, 0.1, 1], [0.1, -0.2, 0.1, 0.2, 0.1, 0.2, -0.1, -0.1, 0], spread=0.1)
def coulomb_crystal(q, p, t):
    stiffness = exactly(4.0, 3.2, 0.7)
    trap = sum(stiffness[i % 3] * x**2 / 2 for i, x in enumerate(q))
    return half_squares(p), trap + sum(1 / r for r in all_distances(q, 3))


@system([-1.2, -0.3, 0.6, 1.5], [0.1, -0.2, 0.3, -0.1], spread=0.1)
def calogero_moser(q, p, t):
    coupling, frequency = exactly(0.4, 1.3)
    repulsion = sum(1 / (q[i] - q[j]) ** 2 for i in range(4) for j in range(i))
    return half_squares(p), frequency**2 * half_squares(q) + coupling * repulsion


@system([0.1, 1.3, 2.6, 3.7], [0.1, -0.2, 0.3, -0.1], spread=0.1)
def sutherland(q, p, t):
    coupling, circumference = exactly(0.3, 5.0)
    wave = pi / circumference
    return half_squares(p), coupling * sum(
        (wave / sin(wave * (q[i] - q[j]))) ** 2 for i in range(4) for j in range(i))


@system([-0.9, 0.2, 1.1], [0.1, -0.2, 0.3])
def sheets(q, p, t):
    density = exactly(0.7)
    apart = [q[1] - q[0], q[2] - q[0], q[2] - q[1]]
    return half_squares(p), density * sum(Piecewise((x, x > 0), (-x, True)) for x in apart)


# one particle


@system([0.9, 0.1], [0.2, 0.7])
def kepler(q, p, t):
    mass, mu = exactly(0.8, 1.1)
    return half_squares(p) / mass, -mu / sqrt(q[0] ** 2 + q[1] ** 2)


@system([1.0, 0.1], [0.1, 0.9])
def anisotropic_kepler(q, p, t):
    heavy, light = exactly(1.2, 0.85)
    return p[0] ** 2 / (2 * heavy) + p[1] ** 2 / (2 * light), -1 / sqrt(q[0] ** 2 + q[1] ** 2)


@system([0.9, 0.1, 0.4], [0.2, 0.7, -0.1])
def quarkonium(q, p, t):
    coulomb, tension, mass = exactly(0.5, 0.9, 0.75)
    r = sqrt(sum(x**2 for x in q))
    return half_squares(p) / mass, tension * r - coulomb / r


@system([0.9, 0.4], [-0.2, 0.6])
def kratzer(q, p, t):
    depth, length = exactly(1.5, 0.9)
    ratio = length / sqrt(q[0] ** 2 + q[1] ** 2)
    return half_squares(p), depth * (ratio**2 / 2 - ratio)


@system([0.1, 1.1], [1.0, 0.1])
def fixed_centres(q, p, t):
    suns = [exactly(-0.5, 0.0, 1.0), exactly(0.5, 0.1, 0.6)]
    return half_squares(p), -sum(mass / sqrt((q[0] - x) ** 2 + (q[1] - y) ** 2) for x, y, mass in suns)


@system([0.3, -1.1], [0.4, 0.1])
def spring_pendulum(q, p, t):
    stiffness, length, weight, along, across = exactly(4.0, 0.9, 1.1, 0.6, 0.8)
    stretch = sqrt(q[0] ** 2 + q[1] ** 2) - length
    return half_squares(p), stiffness / 2 * stretch**2 + weight * (along * q[0] + across * q[1])


@system([-0.9, 1.1], [0.4, 0.1], spread=0.5)
def soft_box(q, p, t):
    half, hardness, friction = exactly(0.75, 6.0, 0.2)
    x, y = q
    wall = [Piecewise((hardness / 2 * (z - half) ** 2, z > half), (hardness / 2 * (z + half) ** 2, z < -half),
                      (0, True)) for z in q]
    cubic = Piecewise((y**3, y > 0), (-(y**3), True))
    return half_squares(p), sum(wall) + friction * (Piecewise((x, x < y), (y, True)) + cubic)


# wells


MASS = exactly(1.25)


def well(name, at, potential, spread=0.25):
    system([at], [0.35], spread=spread)(lambda q, p, t: (half_squares(p) / MASS, potential(q[0])))
    SYSTEMS[name] = SYSTEMS.pop("<lambda>")


def slow_potential(x):
    binary, decimal, root, area, angle, other, degrees = exactly(0.2, 0.7, 0.5, 0.3, 0.4, 0.1, 20.0)
    square = 1 + x**2
    logarithms = (binary / log(2) + decimal / log(10) + other / log(3)) * log(square)
    bent = angle * atan(x - degrees * pi / 180)
    return logarithms + root * square ** Rational(1, 3) + area * x * asinh(x) + bent + 2**x / 16


def acosh_of(x):
    # SymPy's derivative of acosh is written for complex arguments.
    return log(x + sqrt(x - 1) * sqrt(x + 1))


well("duffing", 0.4, lambda x: exactly(1.3) * x**4 / 4 - exactly(0.9) * x**2 / 2)
well("morse_bond", 0.5, lambda x: exactly(1.1) * (exp(-exactly(0.9) * x) - 1) ** 2)
well("rosen_morse", 0.4, lambda x: -exactly(2.2) / cosh(x) ** 2 + exactly(0.4) * tanh(x))
well("walls", 0.4, lambda x: exactly(0.6) * tan(x) ** 2 + exactly(0.3) * sinh(x / 2))
well("woods_saxon", 0.7, lambda x: -exactly(1.8) / (1 + exp((x - exactly(1.2)) / exactly(0.4))) + exactly(0.05) * x**2)
well("finite_spring", 0.9, lambda x: -exactly(1.4) / 2 * exactly(1.75) ** 2 * log(1 - x**2 / exactly(1.75) ** 2))
well("magnet", 0.3, lambda m: m * atanh(m) + log(1 - m**2) / 2 - exactly(0.9) * m**2 / 2 - exactly(0.1) * m, 0.1)
well("andreev_contact", 0.9,
     lambda x: -exactly(1.6) * sqrt(1 - exactly(0.85) * sin(x / 2) ** 2) - exactly(0.1) * x)
well("slow", 0.6, slow_potential)
well("elliptic", 0.6, lambda x: exactly(0.8) * acosh_of(x**2 + Rational(3, 2)) ** 2 + exactly(0.3) * asin(sin(x) / 2))


def hermite(x):
    cell, nodes = exactly(0.75), list(zip(exactly(1.5, -0.2, -0.4, 0.3), exactly(-3.0, -1.1, 0.4, 1.2)))
    pieces = []
    for i, ((a, u), (b, v)) in enumerate(neighbours(nodes)):
        s = x / cell - i
        cubic = (2 * s**3 - 3 * s**2 + 1) * a + (s**3 - 2 * s**2 + s) * cell * u
        cubic += (3 * s**2 - 2 * s**3) * b + (s**3 - s**2) * cell * v
        pieces.append((cubic, x < (i + 1) * cell) if i < 2 else (cubic, True))
    return Piecewise(*pieces)


@system([1.3], [0.35], spread=0.6)
def tabulated(q, p, t):
    return half_squares(p), hermite(q[0]) + exactly(0.01) * q[0] ** 2


# traps


@system([0.4, -0.3, 0.2], [0.1, 0.2, -0.1], t=0.5)
def paul_trap(q, p, t):
    charge, steady, drive, frequency = exactly(0.8, 0.05, 0.9, 2.0)
    x, y, z = q
    return half_squares(p), charge / 2 * (steady + drive * cos(frequency * t)) * (x**2 + y**2 - 2 * z**2)


@system([0.4], [0.1], t=0.5)
def driven_pendulum(q, p, t):
    amplitude, frequency = exactly(0.4, 1.7)
    return half_squares(p), -cos(q[0]) - amplitude * q[0] * sin(frequency * t)


@system([0.4], [0.1], t=0.5)
def kapitza(q, p, t):
    weight, shake, frequency = exactly(1.0, 0.2, 9.0)
    return half_squares(p), -(weight + shake * frequency**2 * cos(frequency * t)) * cos(q[0])


@system([0.4], [0.5], t=0.5)
def two_waves(q, p, t):
    standing, running = exactly(0.3, 0.2)
    return half_squares(p), -standing * cos(q[0]) - running * cos(2 * (q[0] - t))


@system([0.4, -0.3], [0.5, 0.2], t=0.5)
def growing_mass(q, p, t):
    rate, stiffness = exactly(0.1, 1.3)
    spring = q[0] ** 2 + q[1] ** 2 + q[0] ** 2 * q[1]
    return exp(-rate * t) * half_squares(p), exp(rate * t) * stiffness * spring / 2


# beams


@system([0.4, -0.3], [0.1, 0.2], t=0.5)
def focusing_channel(q, p, t):
    quadrupole, sextupole, octupole, ripple = exactly(1.1, 0.7, 0.9, 0.3)
    x, y = q
    linear = quadrupole / 2 * ((1 + ripple * sin(2 * t)) * x**2 + y**2)
    cubic = sextupole / 6 * (x**3 - 3 * x * y**2)
    return half_squares(p), linear + cubic + octupole / 24 * (x**4 - 6 * x**2 * y**2 + y**4)


@system([2.6], [0.3])
def bucket(q, p, t):
    slip, voltage, synchronous = exactly(-0.8, 0.9, 0.2)
    return slip * half_squares(p), voltage * (cos(q[0]) + (q[0] - synchronous) * sin(synchronous))


@system([0.2, -0.3], [0.3, 0.2], spread=0.1)
def exact_drift(q, p, t):
    deviation, focusing, cubic = exactly(0.02, 0.6, 0.1)
    kinetic = -sqrt((1 + deviation) ** 2 - p[0] ** 2 - p[1] ** 2)
    return kinetic, focusing * half_squares(q) + cubic * focusing * q[0] ** 3


@system([0.7, -0.3, 0.1], [0.3, 0.4, 0.2])
def relativistic(q, p, t):
    light, charge, core = exactly(1.5, 0.7, 0.04)
    kinetic = light * sqrt(light**2 + sum(x**2 for x in p))
    return kinetic, -charge / sqrt(core + sum(x**2 for x in q))


@system([0.7, -0.3], [0.3, 0.8])
def massless(q, p, t):
    speed, stiffness, cubic = exactly(0.8, 0.9, 0.1)
    x, y = q
    return speed * sqrt(p[0] ** 2 + p[1] ** 2), stiffness / 2 * (x**2 + y**2 / 2) + cubic * x**2 * y


@system([0.7], [0.4])
def bloch(q, p, t):
    band, field, trap = exactly(0.7, 0.3, 0.05)
    return 2 * band * (1 - cos(p[0])), field * q[0] + trap * q[0] ** 2


@system([0.7, -0.4], [0.5, 0.6])
def coupled_rotors(q, p, t):
    coupling, quartic = exactly(-0.8, 0.05)
    a, b = p
    kinetic = a**2 / 2 + b**2 + coupling * a * b + quartic * (a**4 + b**4)
    return kinetic, -2 * cos(q[0]) - cos(q[1] - q[0])


# statistics


@system([0.3, -0.4, 0.2], [0.5, 0.1, -0.3])
def logistic(q, p, t):
    rows = [[1.0, 0.5, -1.2], [1.0, -0.3, 0.8], [1.0, 1.4, 0.1], [1.0, -0.9, -0.6]]
    logits = [sum(exactly(x) * w for x, w in zip(row, q)) for row in rows]
    losses = [log(1 + exp(sign * logit)) for sign, logit in zip([-1, 1, -1, 1], logits)]
    return half_squares(p), exactly(0.25) * half_squares(q) + sum(losses)


@system([0.3, -0.4], [0.5, 0.1])
def poisson(q, p, t):
    rates = [q[0] + q[1] * exactly(x) for x in (-0.5, 0.25, 1.0, 1.5)]
    losses = [exp(rate) - count * rate for rate, count in zip(rates, (1, 0, 3, 4))]
    return half_squares(p), half_squares(q) + sum(losses)


@system([1.3, -0.4, 0.7, 0.2], [0.5, 0.1, -0.2, 0.3])
def funnel(q, p, t):
    width, *others = q
    return half_squares(p), width**2 / 18 + exp(-width) * half_squares(others) + width * len(others) / 2


@system([0.8, 0.7, -0.4, 0.1], [0.5, 0.1, -0.2, 0.3])
def rosenbrock(q, p, t):
    return half_squares(p), sum(5 * (y - x**2) ** 2 + (1 - x) ** 2 / 20 for x, y in zip(q[::2], q[1::2]))


@system([0.1, 0.4], [0.5, 0.1])
def mixture(q, p, t):
    means = [exactly(-1.0, 0.5), exactly(1.5, 0.0)]
    weight = exactly(0.3)
    modes = [exp(-((q[0] - x) ** 2 + (q[1] - y) ** 2) / 2) for x, y in means]
    return half_squares(p), -log(weight * modes[0] + (1 - weight) * modes[1])


@system([0.2, -0.5, 0.4, 0.9, 0.1], [0.5, 0.1, -0.2, 0.3, -0.1])
def schools(q, p, t):
    *z, mean, log_width = q
    effects, errors = exactly(2.8, 0.8, -0.3), exactly(1.5, 1.0, 1.6)
    schools = [mean + exp(log_width) * x for x in z]
    misfit = sum(((y - x) / e) ** 2 for x, y, e in zip(schools, effects, errors)) / 2
    return half_squares(p), (mean / 5) ** 2 / 2 + log_width**2 / 2 + half_squares(z) + misfit


@system([0.3, 0.1], [0.5, 0.1])
def student(q, p, t):
    data, freedom = exactly(0.3, -0.4, 0.9, 5.5, 0.1), exactly(3.0)
    location, log_scale = q
    tails = sum(log(1 + ((x - location) * exp(-log_scale)) ** 2 / freedom) for x in data)
    return half_squares(p), exactly(0.1) * 2 * half_squares(q) + 5 * log_scale + (freedom + 1) / 2 * tails
