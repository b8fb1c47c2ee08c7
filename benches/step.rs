//! One Verlet step, generated against written by hand: `cargo bench --bench step`.
//!
//! The twins by hand are loops over plain numbers with the stages merged across steps and with `mul_add` written out, in
//! a function compiled for AVX2 and FMA: the same machine code that a generated stepper may use on a stock build. The
//! last lines, `ratio_<problem>_verlet=`, are generated over by hand, medians of interleaved rounds: 1.05 is the limit.

mod paired;

use criterion::{BenchmarkId, Criterion};
use integrator_core::prelude::*;
use std::hint::black_box;

const STEP: f64 = 1.0 / 128.0;

struct Pendulum {
    mass: f64,
    length: f64,
    gravity: f64,
}

#[hamiltonian(compose = Verlet)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * self.gravity * self.length * q[0].cos()
    }
}

struct HenonHeiles;

#[hamiltonian(compose = Verlet)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// The pendulum by hand: half a drift, then kicks and whole drifts, and half a drift back.
#[inline(always)]
fn pendulum_loop(system: &Pendulum, [mut q, mut p]: [f64; 2], h: f64, steps: u64) -> [f64; 2] {
    let inertia = system.mass * system.length * system.length;
    let torque = system.mass * system.gravity * system.length;
    let (drift, kick) = (h / inertia, -h * torque);
    q = (0.5 * drift).mul_add(p, q);
    for _ in 0..steps {
        p = kick.mul_add(q.sin(), p);
        q = drift.mul_add(p, q);
    }
    q = (-0.5 * drift).mul_add(p, q);
    [q, p]
}

/// Hénon–Heiles by hand, in the form with the fewest operations on the way from one kick to the next:
/// ∂V/∂x = 2x(y + ½), ∂V/∂y = y + x² - y².
#[inline(always)]
fn henon_loop([mut x, mut y, mut px, mut py]: [f64; 4], h: f64, steps: u64) -> [f64; 4] {
    x = (0.5 * h).mul_add(px, x);
    y = (0.5 * h).mul_add(py, y);
    for _ in 0..steps {
        px = (-2.0 * h * x).mul_add(y + 0.5, px);
        py = (-h).mul_add((-y).mul_add(y, x.mul_add(x, y)), py);
        x = h.mul_add(px, x);
        y = h.mul_add(py, y);
    }
    x = (-0.5 * h).mul_add(px, x);
    y = (-0.5 * h).mul_add(py, y);
    [x, y, px, py]
}

/// Enters a loop compiled for AVX2 and FMA where the machine has them, and plain code elsewhere.
fn fused<T>(body: impl FnOnce() -> T) -> T {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx2,fma")]
        fn clone<T>(body: impl FnOnce() -> T) -> T {
            body()
        }
        if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
            // SAFETY: the features that `clone` is compiled for were just detected.
            return unsafe { clone(body) };
        }
    }
    body()
}

fn run<H: Hamiltonian>(system: &H, start: Phase<H::Coords>, steps: u64) -> Phase<H::Coords>
where
    H::Coords: Copy,
{
    let mut run = system.run::<f64>(start, STEP).expect("a valid start");
    run.advance(steps).expect("finite numbers");
    run.state()
}

fn main() {
    let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 };
    let start = Phase::new([2.0], [0.0]);
    let generated = |steps| run(&pendulum, black_box(start), steps);
    let by_hand = |steps| {
        fused(
            #[inline(always)]
            || pendulum_loop(black_box(&pendulum), [2.0, 0.0], STEP, steps),
        )
    };

    let henon_start = Phase::new([0.1, 0.0], [0.0, 0.5]);
    let henon_generated = |steps| run(&HenonHeiles, black_box(henon_start), steps);
    let henon_by_hand = |steps| {
        fused(
            #[inline(always)]
            || henon_loop(black_box([0.1, 0.0, 0.0, 0.5]), STEP, steps),
        )
    };

    let steps = 200_000;
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("verlet");
    group.throughput(criterion::Throughput::Elements(steps));
    group.bench_function(BenchmarkId::new("pendulum", "generated"), |b| b.iter(|| generated(steps)));
    group.bench_function(BenchmarkId::new("pendulum", "by hand"), |b| b.iter(|| by_hand(steps)));
    group.bench_function(BenchmarkId::new("henon_heiles", "generated"), |b| b.iter(|| henon_generated(steps)));
    group.bench_function(BenchmarkId::new("henon_heiles", "by hand"), |b| b.iter(|| henon_by_hand(steps)));
    group.finish();
    criterion.final_summary();

    println!("{:<14} {:>12} {:>12}   ns per step", "", "generated", "by hand");
    let comparisons = [
        ("pendulum", paired::compare(steps, generated, by_hand)),
        ("henon", paired::compare(5 * steps, henon_generated, henon_by_hand)),
    ];
    for (name, paired::Comparison { first, second, .. }) in &comparisons {
        println!("{name:<14} {first:>12.2} {second:>12.2}");
    }
    for (name, paired::Comparison { ratio, .. }) in comparisons {
        println!("ratio_{name}_verlet={ratio:.3}");
    }
}
