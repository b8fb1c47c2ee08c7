"""What a system of the corpus is in the reference: a formula, its parameters, and the points it is evaluated at."""

from dataclasses import dataclass
from typing import Callable
from sympy import Rational, sqrt

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


def distance(q, a, b, dimension):
    return sqrt(sum((q[dimension * a + d] - q[dimension * b + d]) ** 2 for d in range(dimension)))


def all_distances(q, dimension):
    count = len(q) // dimension
    return [distance(q, i, j, dimension) for i in range(count) for j in range(i)]
