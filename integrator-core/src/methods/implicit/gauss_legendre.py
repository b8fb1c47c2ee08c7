"""Writes gauss_legendre_table.rs: nodes, weights and the numbers mu_ij = a_ij / b_j of the methods of Gauss and Legendre with
1 to 8 stages, to 34 digits. Run it in this folder; it wants mpmath."""

import mpmath as mp

mp.mp.dps = 60


def text(number):
    return mp.nstr(number, 34, strip_zeros=True, min_fixed=-mp.inf, max_fixed=mp.inf)


def lagrange(nodes, j):
    """The coefficients of the polynomial that is one at node j and zero at the others, lowest power first."""
    coefficients = [mp.mpf(1)]
    for k, node in enumerate(nodes):
        if k != j:
            shifted = [mp.mpf(0)] + coefficients
            scaled = [node * c for c in coefficients] + [mp.mpf(0)]
            coefficients = [(a - b) / (nodes[j] - node) for a, b in zip(shifted, scaled)]
    return coefficients


def integral(coefficients, end):
    return sum(c * end ** (k + 1) / (k + 1) for k, c in enumerate(coefficients))


def row(numbers):
    return "[" + ", ".join(text(number) for number in numbers) + "]"


lines = [
    "//! Written by `gauss_legendre.py`.",
    "",
    "#![allow(clippy::excessive_precision, clippy::unreadable_literal, reason = \"the digits are those of the script\")]",
    "",
    "use super::tableau::Coefficients;",
    "",
]
for stages in range(1, 9):
    legendre = [mp.mpf(1)]
    roots = mp.polyroots(mp.taylor(lambda x: mp.legendre(stages, x), 0, stages)[::-1], maxsteps=500, extraprec=400)
    nodes = sorted((1 + mp.re(root)) / 2 for root in roots)
    basis = [lagrange(nodes, j) for j in range(stages)]
    weights = [integral(polynomial, mp.mpf(1)) for polynomial in basis]
    mu = [[integral(basis[j], nodes[i]) / weights[j] for j in range(stages)] for i in range(stages)]
    for i in range(stages):
        for j in range(stages):
            assert abs(mu[i][j] + mu[j][i] - 1) < mp.mpf(10) ** -45
    pairs = [mu[i][j] for i in range(stages) for j in range(i + 1, stages)]
    lines += [
        "#[rustfmt::skip]",
        f"pub(super) const STAGES_{stages}: Coefficients<'static> = Coefficients {{",
        f"    nodes: &{row(nodes)},",
        f"    weights: &{row(weights)},",
        f"    above: &{row(pairs)},",
        "};",
        "",
    ]
with open("gauss_legendre_table.rs", "w") as file:
    file.write("\n".join(lines[:-1]) + "\n")
