"""Targets of Hamiltonian Monte Carlo."""

from sympy import Rational, exp, log

from .common import exactly, half_squares, system


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


@system([0.3, 0.7, -0.4, 0.9], [0.5, 0.1, -0.2, 0.3])
def heavy_tails(q, p, t):
    scale, tie, tenth = exactly(0.8, 0.05, 0.1)
    tails = sum(log(1 + x**2 / scale**2) for x in q)
    return half_squares(p), tails + tie * (q[0] ** 2 + q[3] ** 2) + (q[1] ** 2 + Rational(3, 2)) ** (tenth * q[2])
