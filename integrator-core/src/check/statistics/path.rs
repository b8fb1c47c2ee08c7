//! Paths: a motion at a few equally spaced times, and the distance of two.
//!
//! Always true: positions are measured against positions and momenta against momenta, so that units cancel, and a
//! displacement against a displacement, so that the origin of the coordinates does not matter.

use crate::{
    scalar::tolerance::{largest, length, ratio},
    state::flat::Flat,
};

/// The number of equal parts of a time. Errors are taken over all of their ends, because at a single time the
/// leading error may happen to vanish, as that of a pendulum's energy does after each period.
pub(crate) const PARTS: u64 = 4;

/// A start, and the points of the motion at the ends of equal parts of a time, mostly of [`PARTS`] of them.
#[derive(Clone)]
pub(crate) struct Path {
    pub(crate) start: Flat,
    pub(crate) ends: Vec<Flat>,
}

/// A length for positions and one for momenta.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) q: f64,
    pub(crate) p: f64,
}

impl Scale {
    pub(crate) const ZERO: Self = Self { q: 0.0, p: 0.0 };

    /// The excursion of a motion that was this far before and now is at `point`. At the few ends of a path alone, a
    /// periodic motion may be back at its start.
    pub(crate) fn reaching(self, start: &Flat, point: &Flat) -> Self {
        Self {
            q: largest([self.q, separation(&point.q, &start.q)]),
            p: largest([self.p, separation(&point.p, &start.p)]),
        }
    }
}

impl Path {
    /// The path of a run, which `advance` takes to the end of one part after the other.
    ///
    /// # Errors
    /// The first one of the run.
    pub(crate) fn of_run<E>(start: Flat, parts: u64, advance: &mut dyn FnMut() -> Result<Flat, E>) -> Result<Self, E> {
        let mut ends = Vec::new();
        for _ in 0..parts {
            ends.push(advance()?);
        }
        Ok(Self { start, ends })
    }

    /// The largest distance of an end from the start.
    pub(crate) fn excursion(&self) -> Scale {
        self.ends.iter().fold(Scale::ZERO, |scale, end| scale.reaching(&self.start, end))
    }

    /// The largest distance of a point from the origin.
    pub(crate) fn magnitude(&self) -> Scale {
        let points = || self.ends.iter().chain([&self.start]);
        Scale {
            q: largest(points().map(|point| length(point.q.iter().copied()))),
            p: largest(points().map(|point| length(point.p.iter().copied()))),
        }
    }

    /// The root of the mean squared distance to `other` over the ends, in units of `scale`; NaN if one of the two has
    /// none.
    pub(crate) fn distance(&self, other: &Self, scale: Scale) -> f64 {
        let apart = self.ends.iter().zip(&other.ends).flat_map(|(one, other)| {
            [ratio(separation(&one.q, &other.q), scale.q), ratio(separation(&one.p, &other.p), scale.p)]
        });
        length(apart) / (self.ends.len().min(other.ends.len()) as f64).sqrt()
    }

    /// The distance that one rounding of every coordinate makes, in units of `scale`.
    pub(crate) fn rounding(&self, scale: Scale) -> f64 {
        let magnitude = self.magnitude();
        f64::EPSILON * (ratio(magnitude.q, scale.q) + ratio(magnitude.p, scale.p))
    }
}

/// The recorder of a path, step by step, and of the excursion.
pub(crate) struct Recorder {
    path: Path,
    scale: Scale,
    /// The steps of a part, and those so far.
    steps: u64,
    step: u64,
}

impl Recorder {
    pub(crate) fn new(start: Flat, steps: u64) -> Self {
        Self { path: Path { start, ends: Vec::new() }, scale: Scale::ZERO, steps, step: 0 }
    }

    /// The end of the next step.
    pub(crate) fn record(&mut self, point: Flat) {
        self.scale = self.scale.reaching(&self.path.start, &point);
        self.step += 1;
        if self.step.is_multiple_of(self.steps) {
            self.path.ends.push(point);
        }
    }

    pub(crate) fn finish(self) -> (Path, Scale) {
        (self.path, self.scale)
    }
}

/// The Euclidean distance of two sets of coordinates.
fn separation(one: &[f64], other: &[f64]) -> f64 {
    length(one.iter().zip(other).map(|(one, other)| one - other))
}
