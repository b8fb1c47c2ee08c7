"""Writes reference.txt: the Pythagorean three-body problem to fifty digits.

    python3 tests/end_to_end/pythagorean/reference.py

Taylor series of the equations of motion by the recurrences of products and powers, with steps whose last two terms are below
the tolerance. The motion is taken twice, with other orders, tolerances and precisions; what is written is what both agree
in, and nothing is written where these are fewer than fifty digits. Needs mpmath; nothing that is built or tested runs this.
"""

import pathlib
import sys
from multiprocessing import Pool
from mpmath import mp, mpf

MASSES = [3, 4, 5]
START = [[1, 3], [-2, -1], [1, -1]]
TIMES = [5, 10, 15, 20, 30, 40, 50, 60, 70]
DIGITS = 50


def series(q, v, order):
    """The coefficients of positions and velocities, each a list of coordinates of a list of bodies."""
    q = [[[x] for x in body] for body in q]
    v = [[[x] for x in body] for body in v]
    pairs = {(i, j): ([[], []], [], []) for i in range(3) for j in range(i)}
    for k in range(order):
        pull = [[mpf(0), mpf(0)] for _ in MASSES]
        for (i, j), (apart, square, weight) in pairs.items():
            for axis in range(2):
                apart[axis].append(q[j][axis][k] - q[i][axis][k])
            square.append(sum(mp.fdot(d, reversed(d)) for d in apart))
            if k == 0:
                weight.append(square[0] ** mpf("-1.5"))
            else:
                # The power of a series: its logarithmic derivative is that of the series times -3/2.
                terms = (((-3 * n - 2 * (k - n)) * square[n], weight[k - n]) for n in range(1, k + 1))
                weight.append(mp.fdot(terms) / (2 * k * square[0]))
            for axis in range(2):
                force = mp.fdot(apart[axis], reversed(weight))
                pull[i][axis] += MASSES[j] * force
                pull[j][axis] -= MASSES[i] * force
        for body in range(3):
            for axis in range(2):
                q[body][axis].append(v[body][axis][k] / (k + 1))
                v[body][axis].append(pull[body][axis] / (k + 1))
    return q, v


def states(order, digits):
    """The states at all times."""
    mp.dps = digits
    q, v = [[[mpf(x) for x in body] for body in START], [[mpf(0), mpf(0)] for _ in MASSES]]
    time, found, steps = mpf(0), [], 0
    for end in TIMES:
        while time < end:
            of_q, of_v = series(q, v, order)
            last = [max(abs(x[k]) for of in (of_q, of_v) for body in of for x in body) for k in (order - 1, order)]
            step = min((mpf(10) ** (5 - digits) / size) ** (mpf(1) / k) for size, k in zip(last, (order - 1, order)))
            step = min(mpf(float(step)), end - time)
            q, v = ([[mp.polyval(x[::-1], step) for x in body] for body in of] for of in (of_q, of_v))
            time, steps = time + step, steps + 1
        found.append([x for of in (q, v) for body in of for x in body])
        print(order, end, steps, file=sys.stderr, flush=True)
    return found


def main():
    with Pool(2) as pool:
        one, other = pool.starmap(states, [(70, 80), (84, 95)])
    lines = ["# time, x and y of the bodies of mass 3, 4 and 5, and their velocities"]
    mp.dps = 95
    for time, a, b in zip(TIMES, one, other):
        apart = max(abs(x - y) for x, y in zip(a, b))
        print(time, mp.nstr(apart, 3), file=sys.stderr)
        assert apart < mpf(10) ** -DIGITS
        lines.append(" ".join([str(time)] + [mp.nstr(x, DIGITS) for x in b]))
    pathlib.Path(__file__).with_name("reference.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
