"""One degree of freedom, shaken systems, and beams."""

from sympy import Piecewise, Rational, asin, asinh, atan, atanh, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh

from .common import SYSTEMS, exactly, half_squares, neighbours, system


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


@system([0.4], [0.5], t=0.5)
def ramped_lattice(q, p, t):
    depth, ramp, field, tilt = exactly(0.9, 0.7, 0.2, 0.01)
    strength = Piecewise(((t / ramp) ** 2 * (3 - 2 * t / ramp), t < ramp), (1, True))
    slope = Rational(3, 2) * (field + tilt)
    return half_squares(p) * 2 / 5, strength * depth * sin(pi * q[0]) ** 2 + 2 * slope * q[0]


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
