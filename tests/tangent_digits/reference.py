"""Writes reference.json: derivatives of the end of runs along vectors at the start and by parameters, to fifty digits.

    python3 tests/tangent_digits/reference.py

Steps of Verlet, half a drift, a kick, half a drift, with forces that are written down here, are taken from starts that are
apart by 1e-18 times the vector. Central differences of two widths err by 1e-36 and by four times as much, relative to a
third derivative; their difference is held against 1e-25 here, so that all digits that are written are right. No derivative
of any force is made use of. Starts, vectors, parameters and steps are doubles. Needs mpmath; nothing that is built or tested
runs this.
"""

import json
import pathlib
from mpmath import mp, mpf, cos, sin, sqrt

mp.dps = 60
DIGITS = 22
WIDTH = mpf(10) ** -18


def henon_heiles(parameters):
    def force(q, t):
        x, y = q
        return [-x - 2 * x * y, -y - x * x + y * y]

    return [mpf(1)] * 2, force


def pendulum(parameters):
    """A pendulum whose point of suspension is shaken."""
    length, drive = parameters

    def force(q, t):
        return [-length * (1 + drive * sin(length * t)) * sin(q[0])]

    return [1 / (length * length)], force


def chain(parameters):
    """Five sites between walls, with springs that harden."""
    (hardening,) = parameters

    def force(q, t):
        ends = [mpf(0), *q, mpf(0)]
        stretch = [b - a for a, b in zip(ends, ends[1:])]
        bond = [s + hardening * s**3 for s in stretch]
        return [after - before for before, after in zip(bond, bond[1:])]

    return [mpf(1)] * 5, force


def bodies(parameters):
    """Three bodies in a plane that attract each other."""
    gravity, softening = parameters
    mass = [mpf(1), mpf(0.5), mpf(0.25)]

    def force(q, t):
        forces = [mpf(0)] * 6
        for i in range(3):
            for j in range(3):
                if i != j:
                    d = [q[2 * i + k] - q[2 * j + k] for k in range(2)]
                    square = d[0] ** 2 + d[1] ** 2 + softening**2
                    for k in range(2):
                        forces[2 * i + k] -= gravity * mass[i] * mass[j] * d[k] / (square * sqrt(square))
        return forces

    return [1 / m for m in mass for _ in range(2)], force


def end(system, parameters, start, h, steps):
    inverse_mass, force = system(parameters)
    half = len(start) // 2
    q, p = start[:half], start[half:]
    drift = lambda q, p: [a + h / 2 * m * b for a, m, b in zip(q, inverse_mass, p)]
    for step in range(steps):
        q = drift(q, p)
        p = [b + h * f for b, f in zip(p, force(q, (step + mpf(0.5)) * h))]
        q = drift(q, p)
    return q + p


def derivative(at):
    """Of a function of one number at zero."""

    def quotient(width):
        return [(b - a) / (2 * width) for a, b in zip(at(-width), at(width))]

    fine, coarse = quotient(WIDTH), quotient(2 * WIDTH)
    assert all(abs(a - b) < mpf(10) ** -25 * (1 + abs(a)) for a, b in zip(fine, coarse))
    return fine


def written(system, parameters, start, vectors, h, steps):
    exact = lambda numbers: [mpf(x) for x in numbers]
    parameters, start, h = exact(parameters), exact(start), mpf(h)
    along = lambda vector: derivative(
        lambda s: end(system, parameters, [x + s * v for x, v in zip(start, exact(vector))], h, steps)
    )
    by = lambda which: derivative(
        lambda s: end(system, [x + s * (k == which) for k, x in enumerate(parameters)], start, h, steps)
    )
    text = lambda numbers: [mp.nstr(x, DIGITS) for x in numbers]
    return {
        "end": text(end(system, parameters, start, h, steps)),
        "along": [text(along(vector)) for vector in vectors],
        "by": [text(by(which)) for which in range(len(parameters))],
    }


RUNS = {
    "henon_heiles": (henon_heiles, [], [0.0, -0.25, 0.375, 0.125], [[1, 0, 0, 0], [0.5, -0.25, 1, 0.75]], 0.125, 400),
    "pendulum": (pendulum, [1.25, 0.375], [2.0, 0.25], [[1, 0], [0.5, -1]], 0.0625, 400),
    "chain": (
        chain,
        [0.75],
        [0.5, 0.25, -0.5, 0.125, 0.75, 0.25, -0.25, 0.5, -0.75, 0.125],
        [[1, 0, 0, 0, 0, 0, 0, 0, 0, 0], [0.5, -1, 0.25, 1, 0, -0.5, 0.75, 0, 1, -0.25]],
        0.0625,
        200,
    ),
    "bodies": (
        bodies,
        [1.5, 0.25],
        [0.0, 0.0, 1.0, 0.25, -0.5, 1.5, 0.125, -0.25, 0.0, 0.5, -0.25, 0.0],
        [[1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], [0.5, -1, 0.25, 1, 0, -0.5, 0.75, 0, 1, -0.25, 0.5, 0.125]],
        0.015625,
        200,
    ),
}

if __name__ == "__main__":
    path = pathlib.Path(__file__).parent / "reference.json"
    path.write_text(json.dumps({name: written(*run) for name, run in RUNS.items()}, indent=1) + "\n")
