//! Trend of a conserved quantity: whether it oscillates, walks at random, or drifts.
//!
//! In: the quantity, averaged over equal groups of samples. Out: the line through it with an uncertainty that holds for
//! scatter with and without memory, and how its scatter grows with time. Always true: a verdict of a drift takes a
//! slope that neither an oscillation nor a random walk explains; a NaN is a drift.

use crate::{
    check::statistics::least_squares::fit,
    scalar::tolerance::{ratio, within},
};
use std::fmt;

/// The number of groups over which samples are averaged: the square of the factor between the windows, in which scatter
/// is compared.
pub(crate) const GROUPS: usize = WINDOWS * WINDOWS;

/// The number of windows of groups, which show whether a short time scatters as much as a long one.
const WINDOWS: usize = 8;

/// The ratio of the squared differences of neighbours to the squares of residuals (von Neumann 1941) below which
/// scatter has a memory. Independent values have 2, and of 4000 sequences of them one in a thousand had less than 1.29;
/// walks about their own line have 15/64 on average, and one in a thousand had more than 1.04.
const MEMORY: f64 = 1.2;

/// The number of standard errors by which a slope has to differ from zero. Of 4000 random walks without a drift, one in
/// a thousand did so by 3.9.
const SIGNIFICANCE: f64 = 4.0;

/// The exponent with which scatter grows with time above which what has a memory is a walk and no slow oscillation.
/// A walk has 1/2 on average; what repeats itself four times in the run has less than 3/8 and mostly less than 1/4.
const GROWTH: f64 = 0.25;

/// The trend of a quantity that should be conserved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// The quantity oscillates or scatters about a constant value, as the energy of a symplectic step does, up to
    /// rounding.
    Bounded,
    /// The quantity deviates as the root of the time, in either direction: unbiased rounding, or the diffusion of a
    /// chaotic motion in steps that are too long for it.
    RandomWalk,
    /// The quantity changes in proportion to the time: biased rounding, or a step that is not symplectic.
    Drift,
}

impl fmt::Display for Course {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Bounded => "bounded",
            Self::RandomWalk => "random walk",
            Self::Drift => "drift",
        })
    }
}

/// The line through some values, and how they scatter about it.
pub(crate) struct Trend {
    pub(crate) slope: f64,
    /// The standard error of the slope: of a fit if the residuals are independent, of the mean step of a walk if not.
    pub(crate) uncertainty: f64,
    /// Whether residuals resemble their neighbours.
    memory: bool,
    /// The exponent with which the scatter grows with the time.
    growth: f64,
}

impl Trend {
    /// The trend of [`GROUPS`] values at equally spaced times.
    pub(crate) fn of(groups: &[(f64, f64)]) -> Self {
        let line = fit(groups);
        let residuals: Vec<f64> = groups.iter().map(|(time, value)| value - line.value * time).collect();
        let differences = residuals.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>();
        let memory = ratio(differences, residuals.len() as f64 * variance(&residuals)) < MEMORY;
        let values: Vec<f64> = groups.iter().map(|(_, value)| *value).collect();
        let window = values.len() / WINDOWS;
        let short = values.chunks_exact(window).map(variance).sum::<f64>() / WINDOWS as f64;
        let growth = (variance(&values) / short).ln() / (2.0 * (WINDOWS as f64).ln());
        // The mean of the m steps of a walk has the standard error of one step over √m; residuals keep its steps but
        // for their mean.
        let steps = (groups.len() - 1) as f64;
        let interval = (groups[groups.len() - 1].0 - groups[0].0) / steps;
        let of_walk = ratio((differences / steps).sqrt() / steps.sqrt(), interval.abs());
        Self {
            slope: line.value,
            uncertainty: if memory { of_walk.max(line.uncertainty) } else { line.uncertainty },
            memory,
            growth,
        }
    }

    /// The verdict, if the line accounts for the fraction `share` of the largest deviation. A drift accounts for more
    /// than half: what is less is buried in an oscillation, of which even a whole number of periods leaves a slope.
    pub(crate) fn course(&self, share: f64) -> Course {
        if !within(self.slope, SIGNIFICANCE * self.uncertainty) && !within(share, 0.5) {
            Course::Drift
        } else if self.memory && self.growth > GROWTH {
            Course::RandomWalk
        } else {
            Course::Bounded
        }
    }
}

/// The mean squared distance from the mean.
fn variance(values: &[f64]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Independent numbers from -1 to 1 (the generator of Marsaglia 2003).
    fn noise(seed: u64) -> impl Iterator<Item = f64> {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        std::iter::repeat_with(move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        })
    }

    fn course(values: impl Iterator<Item = f64>) -> Course {
        let groups: Vec<(f64, f64)> = values.take(GROUPS).enumerate().map(|(i, value)| (i as f64, value)).collect();
        let deviation = groups.iter().map(|(_, value)| (value - groups[0].1).abs()).fold(0.0, f64::max);
        let trend = Trend::of(&groups);
        trend.course(ratio(trend.slope * GROUPS as f64, deviation))
    }

    /// Returns the number of courses that are `expected`, out of a hundred.
    fn count(expected: Course, values: impl Fn(u64) -> Box<dyn Iterator<Item = f64>>) -> usize {
        (1..=100).filter(|seed| course(values(*seed)) == expected).count()
    }

    #[test]
    fn oscillation_walk_and_drift_differ() {
        let walk = |seed| {
            noise(seed).scan(0.0, |at, step| {
                *at += step;
                Some(*at)
            })
        };
        let line = |slope: f64| (0..).map(move |i| slope * f64::from(i));
        // Noise, and oscillations of four periods and more: never anything but bounded.
        assert_eq!(count(Course::Bounded, |seed| Box::new(noise(seed))), 100);
        for period in [3.0, 8.0, 16.0] {
            let sine = |seed: u64| (0..).map(move |i| (TAU * (f64::from(i) / period + seed as f64 / 100.0)).sin());
            let bounded = count(Course::Bounded, |seed| Box::new(sine(seed)));
            assert!(bounded >= if period < 16.0 { 100 } else { 60 }, "{bounded} of period {period}");
            assert_eq!(count(Course::Drift, |seed| Box::new(sine(seed))), 0, "period {period}");
        }
        // Walks, a few of which happen to stay at home.
        let (walks, drifts) =
            (count(Course::RandomWalk, |seed| Box::new(walk(seed))), count(Course::Drift, |seed| Box::new(walk(seed))));
        assert!(walks >= 80 && drifts <= 1, "{walks} walks, {drifts} drifts");
        // A drift of a sixth of the noise per group, that of a walk with a bias of its step's size, and a bare one.
        assert_eq!(count(Course::Drift, |seed| Box::new(noise(seed).zip(line(0.2)).map(|(a, b)| a + b))), 100);
        assert_eq!(count(Course::Drift, |seed| Box::new(walk(seed).zip(line(1.0)).map(|(a, b)| a + b))), 100);
        assert_eq!(course(line(1e-20)), Course::Drift);
    }

    #[test]
    fn constants_are_bounded_and_nan_drifts() {
        assert_eq!(course(std::iter::repeat(0.0)), Course::Bounded);
        assert_eq!(course((0..).map(|i| if i == 40 { f64::NAN } else { 0.0 })), Course::Drift);
    }
}
