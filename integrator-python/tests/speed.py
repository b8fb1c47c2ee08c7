"""The speed of a module in comparison with Rust: `on_python.sh speed`."""

import time

import galaxy

Q, P, H = [1.0, 0.0, 0.0], [0.0, 0.6, 0.4], 0.01
STEPS, SAMPLES, REPEATS = 2_000_000, 1_000_000, 15
system = galaxy.Galaxy(core=0.1, flattening=0.8)


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def compared(name, rust, python):
    # Alternately, so that both have the same share of a busy machine; the fastest of each.
    pairs = [(rust(), python()) for _ in range(REPEATS)]
    in_rust, in_python = (min(column) for column in zip(*pairs))
    print(f"{name}: Rust {in_rust:.3f} s, Python {in_python:.3f} s, ratio {in_python / in_rust:.3f}")


compared(
    f"advance, {STEPS:,} steps",
    lambda: system.seconds_of_steps(Q, P, H, STEPS),
    lambda: seconds(lambda run=system.run(Q, P, H): run.advance(STEPS)),
)
compared(
    f"samples, {SAMPLES:,} of every step",
    lambda: system.seconds_of_samples(Q, P, H, SAMPLES),
    lambda: seconds(lambda run=system.run(Q, P, H): run.samples(SAMPLES)),
)
run = system.run(Q, P, H)
calls = 100_000
print(f"a call of advance(1): {seconds(lambda: [run.advance(1) for _ in range(calls)]) / calls * 1e6:.2f} µs")
