//! Ratios of times on a noisy machine: computations are interleaved, and the median of the ratios over all rounds is
//! reported.

use cpu_time::ThreadTime;
use std::{
    hint::black_box,
    time::{Duration, Instant},
};

/// A computation in a race.
pub struct Racer<'a> {
    name: &'static str,
    run: Box<dyn FnMut() + 'a>,
    threaded: bool,
}

impl<'a> Racer<'a> {
    /// Creates a racer. The result of `run` goes through `black_box`, so that the compiler does not remove the
    /// computation.
    pub fn new<T>(name: &'static str, mut run: impl FnMut() -> T + 'a) -> Self {
        Self { name, run: Box::new(move || drop(black_box(run()))), threaded: false }
    }

    /// Measures wall-clock time instead of the CPU time of this thread, for a racer with threads of its own.
    #[must_use]
    pub fn in_threads(self) -> Self {
        Self { threaded: true, ..self }
    }

    /// Returns the duration of one run: CPU time of this thread, which other programs do not affect, or wall-clock
    /// time.
    fn timed(&mut self) -> Duration {
        if self.threaded {
            let start = Instant::now();
            (self.run)();
            start.elapsed()
        } else {
            let start = ThreadTime::now();
            (self.run)();
            start.elapsed()
        }
    }
}

/// Nanoseconds per unit of work, by racer and round.
#[derive(Clone, Debug)]
pub struct Times {
    /// The names of the racers.
    pub names: Vec<&'static str>,
    /// The times of each racer, by round.
    pub rounds: Vec<Vec<f64>>,
}

/// Runs all racers in turn, `rounds` times each, after one untimed run. Each run does `units` units of work.
pub fn race(rounds: usize, units: f64, mut racers: Vec<Racer>) -> Times {
    racers.iter_mut().for_each(|racer| (racer.run)());
    let mut times =
        Times { names: racers.iter().map(|racer| racer.name).collect(), rounds: vec![Vec::new(); racers.len()] };
    for _ in 0..rounds {
        for (racer, times) in racers.iter_mut().zip(&mut times.rounds) {
            times.push(racer.timed().as_secs_f64() * 1e9 / units);
        }
    }
    times
}

impl Times {
    /// Returns the names of the racers, in their order.
    pub fn names(&self) -> &[&'static str] {
        &self.names
    }

    /// Returns the median time of a racer.
    pub fn median(&self, racer: usize) -> f64 {
        median(self.rounds[racer].clone())
    }

    /// Returns the median over the rounds of the ratio of two racers' times.
    pub fn ratio(&self, racer: usize, other: usize) -> f64 {
        median(self.rounds[racer].iter().zip(&self.rounds[other]).map(|(time, other)| time / other).collect())
    }

    /// Returns the time of the first racer divided by that of the best other one.
    pub fn ratio_to_best(&self) -> f64 {
        (1..self.names.len()).map(|other| self.ratio(0, other)).fold(0.0, f64::max)
    }

    /// Returns the least median of all racers but the first.
    pub fn best_other(&self) -> f64 {
        (1..self.names.len()).map(|other| self.median(other)).fold(f64::INFINITY, f64::min)
    }
}

/// Returns the median; for an even number of values, the larger of the middle two.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
