//! The search for the first edge that a motion crosses.
//!
//! A range of time is free of crossings where every margin is above zero on all of it: by its enclosure, or by its value
//! at the beginning and the enclosure of its derivative. Other ranges are halved, the earlier half first, down to the
//! rounding of a step.

use super::{
    Conditions, Enclosure, Observer, Polynomials,
    observer::{Margin, MarginKind},
};
use crate::{
    methods::taylor::table::{Coefficients, Layout},
    scalar::{interval::Interval, real::Real},
};
use alloc::{vec, vec::Vec};

/// The fraction of its first value to which the radicand of a root may fall within a step. The distance to the zero of a
/// sum of squares falls to a quarter: steps that the tolerance allows are shorter where the zero lies beside the real axis
/// of time and shows in the coefficients. It does not where it is too near to the axis; then this limit holds.
const LEAST_RADICAND: f64 = 1.0 / 16.0;

/// The rounding errors, relative to the first value, below which the least value of a root's argument is zero.
const ZERO: f64 = 64.0;

/// The distance from the zero at which the next step begins, in roundings of the distance at which the last one began.
const APART: f64 = 8.0;

/// The most evaluations of all conditions in a search.
const EVALUATIONS: usize = 1 << 15;

/// Too many evaluations were needed.
#[derive(Debug, PartialEq)]
pub(in crate::methods::taylor) struct Unresolved;

/// The end of a step at an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::methods::taylor) struct Edge {
    /// The duration from the origin of the polynomials.
    pub(in crate::methods::taylor) duration: f64,
    /// Whether the edge depends on the time alone, so that all neighbouring orbits cross it at the same time.
    pub(in crate::methods::taylor) is_of_time: bool,
}

/// A search along the polynomials of a step.
pub(in crate::methods::taylor) struct Search<'s> {
    pub(in crate::methods::taylor) polynomials: &'s Polynomials,
    pub(in crate::methods::taylor) layout: Layout,
    pub(in crate::methods::taylor) conditions: &'s Conditions<'s>,
    /// The time of the origin, and the unit of durations, negative where steps lead back.
    pub(in crate::methods::taylor) time: f64,
    pub(in crate::methods::taylor) unit: f64,
    /// The shortest duration of a step that ends at an edge.
    pub(in crate::methods::taylor) resolution: f64,
    /// The spacing of coordinates around one.
    pub(in crate::methods::taylor) epsilon: f64,
}

/// The margins at the origin and what follows from them.
struct Sides {
    observer: Observer,
    /// The values of radicands at the origin.
    origin: Vec<Margin>,
    /// Whether rounding decides the side at the origin.
    doubtful: Vec<bool>,
    /// Radicands whose zero the step may pass.
    passed: Vec<bool>,
    /// The rounding of each quantity in the range of a search: a change of its sign below that has no effect.
    floors: Vec<f64>,
    evaluations: usize,
}

impl Sides {
    /// Returns the difference of a quantity from the value at which a step has to end.
    fn excess(&self, number: usize, margin: &Margin) -> Interval {
        match margin.kind {
            MarginKind::Side => margin.value,
            MarginKind::Radicand => margin.value - Interval::of(LEAST_RADICAND * self.origin[number].value.low),
        }
    }
    /// Whether a quantity limits the step.
    fn limits(&self, number: usize) -> bool {
        match self.origin[number].kind {
            MarginKind::Side => !self.doubtful[number],
            MarginKind::Radicand => self.origin[number].value.low > 0.0 && !self.passed[number],
        }
    }
    /// Returns the quantities that are beyond their edges, by more than their rounding if this is requested.
    fn crossed(&self, margins: &[Margin], by_floor: bool) -> Vec<usize> {
        let is_beyond = |(number, margin): &(usize, &Margin)| {
            let floor = if by_floor { self.floors[*number] } else { 0.0 };
            self.limits(*number) && self.excess(*number, margin).middle() < -floor
        };
        margins.iter().enumerate().filter(is_beyond).map(|(number, _)| number).collect()
    }
}

impl Search<'_> {
    /// The first crossing between two durations from the origin.
    pub(in crate::methods::taylor) fn first(&self, [begin, end]: [f64; 2]) -> Result<Option<Edge>, Unresolved> {
        let mut sides = self.sides();
        if sides.origin.is_empty() {
            return Ok(None);
        }
        self.find_floors(&mut sides, [begin, end])?;
        let mut last = self.first_decision(&mut sides, [begin, end])?;
        let (mut from, mut end) = (begin, last.unwrap_or(end));
        while let Some(crossing) = self.crossing(&mut sides, [from, end])? {
            match self.beyond_zero(&mut sides, [crossing, end])? {
                Some((number, beyond)) => {
                    sides.passed[number] = true;
                    (from, end, last) = (crossing, beyond, Some(beyond));
                }
                None => {
                    last = Some(crossing);
                    break;
                }
            }
        }
        let Some(duration) = last else { return Ok(None) };
        let margins = self.at(&mut sides, duration)?;
        let mut crossed = margins.iter().enumerate().filter(|(number, margin)| match sides.doubtful[*number] {
            true => !margin.value.contains(0.0),
            false => sides.excess(*number, margin).middle() < 0.0,
        });
        let is_of_time = crossed.all(|(_, margin)| margin.is_of_time);
        Ok(Some(Edge { duration: f64::max(duration, self.resolution), is_of_time }))
    }

    /// The sides on which the motion begins.
    fn sides(&self) -> Sides {
        let mut observer = Observer::default();
        self.observe(&mut observer, [0.0, 0.0]);
        let origin = core::mem::take(&mut observer.margins);
        let is_doubtful = |margin: &Margin| margin.kind == MarginKind::Side && margin.value.low <= 0.0;
        let doubtful = origin.iter().map(is_doubtful).collect();
        let passed = vec![false; origin.len()];
        let floors = vec![0.0; origin.len()];
        Sides { observer, origin, doubtful, passed, floors, evaluations: 0 }
    }

    /// Finds the rounding of each quantity from its sizes in a range.
    fn find_floors(&self, sides: &mut Sides, [begin, end]: [f64; 2]) -> Result<(), Unresolved> {
        for duration in [begin, 0.5 * (begin + end), end] {
            for (number, margin) in self.at(sides, duration)?.iter().enumerate() {
                let size = self.epsilon * Real::abs(sides.excess(number, margin).middle());
                if size.is_finite() {
                    sides.floors[number] = f64::max(sides.floors[number], size);
                }
            }
        }
        Ok(())
    }

    /// The shortest range that is worth halving, up to a duration.
    fn shortest(&self, duration: f64) -> f64 {
        f64::max(self.resolution, 2.0 * f64::EPSILON * duration)
    }

    fn observe(&self, observer: &mut Observer, range: [f64; 2]) {
        let mut enclosures = self.polynomials.enclose(range);
        let [from, to] = range.map(|duration| self.time + self.unit * duration);
        let error = f64::EPSILON * (Real::abs(self.time) + range[1] * Real::abs(self.unit));
        let (low, high) = (f64::min(from, to) - error, f64::max(from, to) + error);
        let time = Enclosure::state(&|lane| [low, self.unit, high, self.unit][lane]);
        let (q, p) = enclosures.split_at_mut(self.layout.coordinates());
        let [q, p] = [q, p].map(|half| self.layout.arranged(half));
        let [mut q, mut p] = [q, p];
        let (q, p) = (Coefficients::of_values(&mut q, self.layout), Coefficients::of_values(&mut p, self.layout));
        (self.conditions)(&q, &p, time, observer);
    }

    /// The margins over a range of durations.
    fn margins(&self, sides: &mut Sides, range: [f64; 2]) -> Result<Vec<Margin>, Unresolved> {
        sides.evaluations += 1;
        if sides.evaluations > EVALUATIONS {
            return Err(Unresolved);
        }
        sides.observer.restart();
        self.observe(&mut sides.observer, range);
        Ok(core::mem::take(&mut sides.observer.margins))
    }

    fn at(&self, sides: &mut Sides, duration: f64) -> Result<Vec<Margin>, Unresolved> {
        self.margins(sides, [duration, duration])
    }

    /// The first duration at which it is decided on which side a motion is that begins on an edge. Until then both sides
    /// have the same force within the rounding, or the formula jumps at the very start.
    fn first_decision(&self, sides: &mut Sides, [begin, end]: [f64; 2]) -> Result<Option<f64>, Unresolved> {
        if !sides.doubtful.contains(&true) {
            return Ok(None);
        }
        let mut before = begin;
        let mut next = f64::max(8.0 * begin, self.resolution);
        loop {
            let now = f64::min(next, end);
            if self.is_decided(sides, now)? {
                let mut range = [before, now];
                while range[1] > 1.1 * range[0] && range[1] > self.resolution {
                    let middle = f64::max(Real::sqrt(range[0] * range[1]), 0.5 * self.resolution);
                    let half = usize::from(self.is_decided(sides, middle)?);
                    range[half] = middle;
                }
                return Ok(Some(range[1]));
            }
            if now >= end {
                return Ok(None);
            }
            (before, next) = (now, 8.0 * now);
        }
    }

    fn is_decided(&self, sides: &mut Sides, duration: f64) -> Result<bool, Unresolved> {
        let margins = self.at(sides, duration)?;
        let doubtful = margins.iter().zip(&sides.doubtful).filter(|(_, doubtful)| **doubtful);
        Ok(doubtful.into_iter().any(|(margin, _)| !margin.value.contains(0.0)))
    }

    /// The first crossing of an edge that is not in doubt.
    fn crossing(&self, sides: &mut Sides, [begin, end]: [f64; 2]) -> Result<Option<f64>, Unresolved> {
        let mut left = self.at(sides, begin)?;
        let mut ranges = vec![[begin, end]];
        while let Some([from, to]) = ranges.pop() {
            let over = self.margins(sides, [from, to])?;
            let mut failing = Vec::new();
            for (number, (over, left)) in over.iter().zip(&left).enumerate() {
                if sides.limits(number) && !is_free(sides, number, over, left, to - from) {
                    failing.push(number);
                }
            }
            if failing.is_empty() {
                if !ranges.is_empty() {
                    left = self.at(sides, to)?;
                }
                continue;
            }
            let is_short = to - from <= self.shortest(to);
            let falls = |number: &usize| over[*number].rate.high < 0.0;
            if is_short || failing.iter().all(falls) {
                let right = self.at(sides, to)?;
                if !sides.crossed(&right, true).is_empty() {
                    return self.root(sides, [from, to], (&left, &right)).map(Some);
                }
                if is_short {
                    left = right;
                    continue;
                }
            }
            let middle = 0.5 * (from + to);
            ranges.extend([[middle, to], [from, middle]]);
        }
        Ok(None)
    }

    /// The first duration at which an edge is crossed, within a range in which all margins that come near theirs fall.
    fn root(
        &self,
        sides: &mut Sides,
        [mut from, mut to]: [f64; 2],
        (left, right): (&[Margin], &[Margin]),
    ) -> Result<f64, Unresolved> {
        let (mut left, mut right) = (left.to_vec(), right.to_vec());
        let mut round = 0_u32;
        while to - from > self.shortest(to) {
            round += 1;
            // The earliest root of the straight lines through both ends, then two points close to it on either side.
            let roots = sides.crossed(&right, false).into_iter().map(|number| {
                let [before, after] = [&left, &right].map(|margins| sides.excess(number, &margins[number]).middle());
                if before > 0.0 { before / (before - after) } else { 0.0 }
            });
            let part = roots.fold(1.0, f64::min);
            let aside = Real::powf(0.125, f64::from(round.div_ceil(3)));
            let part = match round % 3 {
                1 => part - aside * part,
                2 => part + aside * (1.0 - part),
                _ => 0.5,
            };
            let between = from + part * (to - from);
            if between <= from || between >= to {
                if round.is_multiple_of(3) {
                    break;
                }
                continue;
            }
            let margins = self.at(sides, between)?;
            if sides.crossed(&margins, false).is_empty() {
                (from, left) = (between, margins);
            } else {
                (to, right) = (between, margins);
            }
        }
        Ok(to)
    }

    /// If only a radicand ends the step, and falls to zero within its rounding: its number, and the duration at which it
    /// grows again.
    fn beyond_zero(&self, sides: &mut Sides, [crossing, end]: [f64; 2]) -> Result<Option<(usize, f64)>, Unresolved> {
        let margins = self.at(sides, crossing)?;
        let crossed = sides.crossed(&margins, false);
        let is_radicand = |number: &usize| sides.origin[*number].kind == MarginKind::Radicand;
        let Some(number) = crossed.first().copied().filter(|_| crossed.iter().all(is_radicand)) else {
            return Ok(None);
        };
        let origin = sides.origin[number];
        // At a constant speed the distance is zero at 4/3 of the duration at which it is a quarter.
        let (mut falls, mut grows) = (crossing, f64::min(f64::max(2.0 * crossing, self.resolution), end));
        let is_behind = self.at(sides, grows)?[number].rate.middle() > 0.0;
        if !is_behind {
            return Ok(None);
        }
        while grows - falls > self.shortest(grows) {
            let middle = 0.5 * (falls + grows);
            if self.at(sides, middle)?[number].rate.middle() > 0.0 { grows = middle } else { falls = middle }
        }
        let least = self.at(sides, grows)?[number].value.high;
        let zero = ZERO * self.epsilon;
        let is_zero = least <= zero * zero * origin.value.low;
        if !is_zero && grows > 8.0 * self.resolution {
            return Ok(None);
        }
        // As far from the zero as a few roundings of the step, so that it certainly is after it and the coefficients of
        // low orders are finite.
        let (mut further, apart) = (self.shortest(grows), APART * self.epsilon);
        while grows < end {
            let Margin { value, rate, .. } = self.at(sides, grows)?[number];
            if rate.low > 0.0 && value.low > apart * apart * origin.value.low {
                return Ok(Some((number, grows)));
            }
            grows += further;
            further *= 1.5;
        }
        Ok(None)
    }
}

/// Whether a quantity does not cross its edge within a range of this length that begins at `left`.
fn is_free(sides: &Sides, number: usize, over: &Margin, left: &Margin, length: f64) -> bool {
    let (over_all, at_left) = (sides.excess(number, over), sides.excess(number, left));
    let falls = f64::min(over.rate.low, 0.0) * length;
    let least = f64::max(over_all.low, at_left.low + if length == 0.0 { 0.0 } else { falls });
    let noise = f64::max(2.0 * (at_left.high - at_left.low), sides.floors[number]);
    least > 0.0 || least >= -noise && noise.is_finite()
}
