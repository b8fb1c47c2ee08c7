"""Writes reference.json: Taylor coefficients of the motion of every system in systems.py, from fifty digits.

    python3 tests/taylor/reference.py

SymPy differentiates the formulas. The series of a function of a series comes from the Taylor coefficients of the
function at the start, which mpmath finds by numerical differentiation, and the powers of the series: no recurrence of any
function is made use of. Integrating the gradients' series term by term gives the next coefficients of q and p
(Picard). That the result solves the equations of motion is then tried at a later time.

Beside each coefficient stands the scale of the error that an evaluation may have: to first order, what the coefficient may
be off by, in units of a rounding, if every operation on series is off by one rounding of each of its terms:

    scale(a + b) = |a| + |b| + scale(a) + scale(b)
    scale(a b) = |a| |b| + |a| scale(b) + scale(a) |b|                           with products of series
    scale(f(x)) = Σ |fₙ| |x - x₀|ⁿ + (Σ (n+1) |fₙ₊₁| |x - x₀|ⁿ) scale(x)         with the coefficients fₙ of f at x₀

where |a| is the series of absolute coefficients. Starts and the time are exact. Needs SymPy; nothing that is built or
tested runs this.
"""

import json
import pathlib
import sympy
from mpmath import mp, mpf
from systems import ROWS

mp.dps = 50
ORDER = 20
DIGITS = 22


class Series:
    """Coefficients and their scales, each found when it is asked for."""

    def __init__(self, value, scale):
        self.known = [[], []]
        self.find = [value, scale]

    def get(self, which, k):
        known = self.known[which]
        while len(known) <= k:
            known.append(self.find[which](len(known)))
        return known[k]

    def value(self, k):
        return self.get(0, k)

    def size(self, k):
        return abs(self.get(0, k))

    def scale(self, k):
        return self.get(1, k)


def convolution(a, b, k):
    return mp.fsum(a(j) * b(k - j) for j in range(k + 1))


def number(value):
    return Series(lambda k: value if k == 0 else mpf(0), lambda k: abs(value) if k == 0 else mpf(0))


def add(parts):
    return Series(
        lambda k: mp.fsum(part.value(k) for part in parts),
        lambda k: mp.fsum(part.size(k) + part.scale(k) for part in parts),
    )


def multiply(a, b):
    def scale(k):
        own = convolution(a.size, b.size, k)
        return own + convolution(a.size, b.scale, k) + convolution(a.scale, b.size, k)

    return Series(lambda k: convolution(a.value, b.value, k), scale)


def powers(of):
    """The coefficients of the powers of a series without its constant term, by power and order."""
    rest = lambda k: of(k) if k > 0 else mpf(0)
    known = {}

    def get(n, k):
        if n == 0:
            return mpf(k == 0)
        if n > k:
            return mpf(0)
        if (n, k) not in known:
            known[n, k] = rest(k) if n == 1 else mp.fsum(rest(j) * get(n - 1, k - j) for j in range(1, k - n + 2))
        return known[n, k]

    return get


def compose(function, x):
    """f(x) by the coefficients of f at the constant term of x."""
    f = mp.taylor(function, x.value(0), ORDER + 1)
    by_value, by_size = powers(x.value), powers(x.size)

    def slope(k):
        return mp.fsum((n + 1) * abs(f[n + 1]) * by_size(n, k) for n in range(k + 1))

    def scale(k):
        return mp.fsum(abs(f[n]) * by_size(n, k) for n in range(k + 1)) + convolution(slope, x.scale, k)

    return Series(lambda k: mp.fsum(f[n] * by_value(n, k) for n in range(k + 1)), scale)


def branch(node, at):
    """The expression of a Piecewise that holds at the start."""
    return next(value for value, condition in node.args if condition == True or condition.subs(at) == True)  # noqa: E712


def chosen(expression, at):
    return expression.replace(lambda node: isinstance(node, sympy.Piecewise), lambda node: branch(node, at))


def series(expression, variables):
    known = {}

    def of(node):
        if node not in known:
            known[node] = found(node)
        return known[node]

    def found(node):
        if node in variables:
            return variables[node]
        if not node.free_symbols:
            return number(mpf(node.p) / node.q if node.is_Rational else mpf(node.evalf(60)))
        if node.is_Add:
            return add([of(part) for part in node.args])
        if node.is_Mul:
            first, *rest = [of(part) for part in node.args]
            for factor in rest:
                first = multiply(first, factor)
            return first
        if node.is_Pow and node.exp.free_symbols:
            logarithm = compose(mp.log, of(node.base)) if node.base.free_symbols else of(sympy.log(node.base))
            return compose(mp.exp, multiply(of(node.exp), logarithm))
        if node.is_Pow:
            exponent = of(node.exp).value(0)
            if node.exp.is_Integer:
                exponent = int(node.exp)
            return compose(lambda x: x**exponent, of(node.base))
        (argument,) = node.args
        dummy = sympy.Dummy(real=True)
        return compose(sympy.lambdify([dummy], node.func(dummy), "mpmath"), of(argument))

    return of(expression)


def coefficients(energies, q_at, p_at, t_at):
    """The series of q and p from a start."""
    q = sympy.symbols(f"q:{len(q_at)}", real=True)
    p = sympy.symbols(f"p:{len(p_at)}", real=True)
    t = sympy.Symbol("t", real=True)
    at = {symbol: sympy.Rational(value) for symbol, value in zip((*q, *p, t), (*q_at, *p_at, t_at))}
    parts = [chosen(sympy.sympify(energy), at) for energy in energies(q, p, t)]
    rates = [sum(part.diff(x) for part in parts) for x in p] + [-sum(part.diff(x) for part in parts) for x in q]

    def integral(start, rate):
        """Reads the series of its rate, which is there when the first coefficient is asked for."""
        value = lambda k: start if k == 0 else rate().value(k - 1) / k
        scale = lambda k: mpf(0) if k == 0 else (rate().size(k - 1) + rate().scale(k - 1)) / k
        return Series(value, scale)

    moving = []
    motion = [integral(mpf(start), lambda i=i: moving[i]) for i, start in enumerate((*q_at, *p_at))]
    time = Series(lambda k: [mpf(t_at), mpf(1)][k] if k < 2 else mpf(0), lambda k: mpf(0))
    variables = dict(zip((*q, *p, t), (*motion, time)))
    moving.extend(series(rate, variables) for rate in rates)
    for k in range(ORDER + 1):
        for coordinate in motion:
            coordinate.value(k), coordinate.scale(k)
    solves_the_equations(motion, rates, (*q, *p, t), t_at)
    return motion[: len(q)], motion[len(q) :]


def solves_the_equations(motion, rates, symbols, t_at):
    """Raises where the polynomials do not: what is left over is of order ORDER."""
    later = mpf(2) ** -12
    at = [mp.fsum(x.value(k) * later**k for k in range(ORDER + 1)) for x in motion] + [t_at + later]
    for x, rate in zip(motion, rates):
        velocity = mp.fsum(k * x.value(k) * later ** (k - 1) for k in range(1, ORDER + 1))
        rest = velocity - sympy.lambdify(symbols, rate, "mpmath")(*at)
        assert abs(rest) < mpf(10) ** -45 * (1 + abs(velocity)), rest


def printed(motion):
    return [
        [[mp.nstr(x.value(k), DIGITS), mp.nstr(x.scale(k), 4)] for k in range(ORDER + 1)]
        for x in motion
    ]


def main():
    lines = []
    for name, (energies, q, p, t) in ROWS.items():
        of_q, of_p = coefficients(energies, q, p, t)
        row = {"q": printed(of_q), "p": printed(of_p), "time": t}
        lines.append(f'  "{name}": {json.dumps(row, separators=(",", ":"))}')
        print(name, flush=True)
    path = pathlib.Path(__file__).with_name("reference.json")
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main()
