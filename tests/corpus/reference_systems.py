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
