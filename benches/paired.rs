//! Ratios on a noisy machine: two computations run in turns, and the median of the ratios of each turn is what counts.

use std::{hint::black_box, time::Instant};

/// Turns of a comparison; odd, so that the median is one of them.
const TURNS: usize = 101;

/// Two computations compared.
pub(crate) struct Comparison {
    /// Nanoseconds per step of the first, the median over turns.
    pub(crate) first: f64,
    /// Nanoseconds per step of the second.
    pub(crate) second: f64,
    /// The first over the second, the median of the ratios of each turn.
    pub(crate) ratio: f64,
}

/// Compares two computations that each take `steps` steps.
pub(crate) fn compare<A, B>(steps: u64, first: impl Fn(u64) -> A, second: impl Fn(u64) -> B) -> Comparison {
    let turns: Vec<[f64; 2]> = (0..TURNS).map(|_| [timed(steps, &first), timed(steps, &second)]).collect();
    let median = |of: &dyn Fn(&[f64; 2]) -> f64| {
        let mut values: Vec<f64> = turns.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values[TURNS / 2]
    };
    Comparison {
        first: median(&|turn| turn[0]),
        second: median(&|turn| turn[1]),
        ratio: median(&|turn| turn[0] / turn[1]),
    }
}

/// Nanoseconds per step.
fn timed<T>(steps: u64, computation: &impl Fn(u64) -> T) -> f64 {
    let start = Instant::now();
    black_box(computation(black_box(steps)));
    start.elapsed().as_secs_f64() * 1e9 / steps as f64
}
