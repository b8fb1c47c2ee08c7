"""Stars in galaxies."""

from sympy import Rational, atan2, cos, log, sqrt

from .common import exactly, half_squares, system


@system([0.3, -0.2], [0.1, 0.35])
def henon_heiles(q, p, t):
    x, y = q
    return half_squares(p), (x**2 + y**2) / 2 + x**2 * y - y**3 / 3


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
