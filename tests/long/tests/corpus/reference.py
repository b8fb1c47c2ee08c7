"""Writes reference.json: points, energies and gradients of every system of the corpus, with fifty digits.

    python3 tests/long/tests/corpus/reference.py

Each formula is defined here on its own, from the literature; SymPy differentiates it, mpmath evaluates it. Beside each
number stands the scale of the error that an evaluation may have: to first order, what the number may move by, in units
of the rounding, if every operand of every operation is off by one rounding of its own:

    scale(x) = |x|                                      of a coordinate or a number
    scale(a + b) = scale(a) + scale(b)
    scale(a b) = scale(a) scale(b)
    scale(f(x)) = max(|f(x)|, |f'(x)| scale(x))         of a function or a power

so a number that is the small difference of large terms has the scale of the terms. Needs SymPy; nothing that is built
or tested runs this.
"""

import json
import pathlib
import sympy
from mpmath import mp, mpf
from formulas import SYSTEMS

mp.dps = 50
DIGITS = 32


def evaluate(expression, values):
    """The value of an expression and the scale of its error."""
    known = {}

    def of(node):
        if node not in known:
            known[node] = found(node)
        return known[node]

    def found(node):
        if node in values:
            return values[node], abs(values[node])
        if node.is_number and not node.args or node.is_Rational:
            value = mpf(node.p) / node.q if node.is_Rational else node._to_mpmath(mp.prec)
            return value, abs(value)
        if node.is_Add:
            parts = [of(part) for part in node.args]
            return mp.fsum(value for value, _ in parts), mp.fsum(scale for _, scale in parts)
        if node.is_Mul:
            parts = [of(part) for part in node.args]
            return mp.fprod(value for value, _ in parts), mp.fprod(scale for _, scale in parts)
        if isinstance(node, sympy.Piecewise):
            return of(branch(node))
        arguments = [of(argument) for argument in node.args]
        moved = [position for position, argument in enumerate(node.args) if not argument.is_number]
        dummies = [sympy.Dummy(real=True) for _ in moved]
        at = [arguments[position][0] for position in moved]
        function = node.func(*(dummies[moved.index(i)] if i in moved else x for i, x in enumerate(node.args)))
        value = sympy.lambdify(dummies, function, "mpmath")(*at)
        scale = abs(value)
        for dummy, position in zip(dummies, moved):
            slope = sympy.lambdify(dummies, function.diff(dummy), "mpmath")(*at)
            scale = max(scale, abs(slope) * arguments[position][1])
        return value, scale

    def branch(node):
        for value, condition in node.args:
            if condition == True or holds(condition):  # noqa: E712
                return value
        raise ValueError(f"no branch of {node}")

    def holds(condition):
        if isinstance(condition, sympy.And):
            return all(holds(part) for part in condition.args)
        if isinstance(condition, sympy.Or):
            return any(holds(part) for part in condition.args)
        left, right = of(condition.lhs)[0], of(condition.rhs)[0]
        return {"<": left < right, "<=": left <= right, ">": left > right, ">=": left >= right}[condition.rel_op]

    return of(expression)


def printed(pair):
    value, scale = pair
    return [mp.nstr(value, DIGITS), mp.nstr(scale, 6)]


def point(system, q_at, p_at, t_at):
    q = sympy.symbols(f"q:{len(q_at)}", real=True)
    p = sympy.symbols(f"p:{len(p_at)}", real=True)
    t = sympy.Symbol("t", real=True)
    kinetic, potential = (sympy.sympify(energy) for energy in system.energies(q, p, t))
    values = {symbol: mpf(value) for symbol, value in zip((*q, *p, t), (*q_at, *p_at, t_at))}
    return {
        "q": list(q_at),
        "p": list(p_at),
        "time": t_at,
        "kinetic": printed(evaluate(kinetic, values)),
        "potential": printed(evaluate(potential, values)),
        "kinetic_gradient": [printed(evaluate(kinetic.diff(x), values)) for x in p],
        "potential_gradient": [printed(evaluate(potential.diff(x), values)) for x in q],
    }


def main():
    entries = []
    for name, system in sorted(SYSTEMS.items()):
        lines = ",\n    ".join(json.dumps(point(system, *at), separators=(",", ":")) for at in system.points())
        entries.append(f'  "{name}": [\n    {lines}\n  ]')
    path = pathlib.Path(__file__).with_name("reference.json")
    path.write_text("{\n" + ",\n".join(entries) + "\n}\n")


if __name__ == "__main__":
    main()
