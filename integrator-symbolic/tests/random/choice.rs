//! Random choices that a seed decides.

use std::{env, ops::Range};

/// Returns the seeds of the systems to draw: the first one and their number are variables of the environment, or 1 and `count`.
pub(crate) fn seeds([first, number]: [&str; 2], count: u64) -> Range<u64> {
    let first = set(first, 1);
    first..first + set(number, count)
}

/// Returns a number from the environment.
fn set(variable: &str, otherwise: u64) -> u64 {
    env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// SplitMix64 (Steele, Lea and Flood 2014).
#[derive(Clone)]
pub(crate) struct Choices(u64);

impl Choices {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        if count == 0 { 0 } else { (self.next() % count as u64) as usize }
    }

    /// True in so many of a hundred cases.
    pub(crate) fn percent(&mut self, share: usize) -> bool {
        self.below(100) < share
    }

    /// One of several.
    pub(crate) fn of<'a, T: ?Sized>(&mut self, from: &[&'a T]) -> &'a T {
        from[self.below(from.len())]
    }

    /// A number between two, with three decimals.
    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        let share = self.below(1_000_001) as f64 / 1e6;
        ((from + (to - from) * share) * 1e3).round() / 1e3
    }
}
