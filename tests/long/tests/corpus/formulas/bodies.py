"""Clusters, many bodies, and one body in a field."""

from sympy import Piecewise, Rational, acos, exp, pi, sin, sqrt

from .common import all_distances, distance, exactly, half_squares, system


# clusters


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
