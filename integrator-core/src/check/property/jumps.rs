//! Jumps of the energies along an orbit.
//!
//! In: consecutive states of an orbit. Out: the first jump of an energy between two of them. Always true: the
//! difference of an energy between two states is compared with the integral of its gradient along the connecting
//! segment, at fixed time. If they differ, the segment is halved; at a jump they differ in one half for every length.
//! The check hence assumes nothing about the motion, and the energy need not be conserved.

use crate::{
    check::{
        property::{
            energies::{Differentiable, Part},
            slope::SAFETY,
        },
        statistics::{points::numbers, quadrature},
    },
    state::flat::Flat,
};

/// The number of halvings of a segment. A function that is smooth on the scale of a thousand millionth of it has no
/// jump.
const HALVINGS: u32 = 30;

/// A jump of an energy.
pub(crate) struct Jump {
    pub(crate) part: Part,
    pub(crate) by: f64,
    pub(crate) time: f64,
    pub(crate) state: Flat,
}

/// The first jump of an energy between two states, at a time of the clock.
pub(crate) fn jump_between(system: &dyn Differentiable, ends: [&Flat; 2], time: f64) -> Option<Jump> {
    Part::BOTH.into_iter().find_map(|part| Segment { system, part, ends, time }.jump())
}

/// The segment between two states.
struct Segment<'s> {
    system: &'s dyn Differentiable,
    part: Part,
    ends: [&'s Flat; 2],
    time: f64,
}

impl Segment<'_> {
    fn jump(&self) -> Option<Jump> {
        let [mut from, mut to] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            // Where an energy has no value, other checks say so.
            if !self.is_suspicious([from, to]) {
                return None;
            }
            let middle = f64::midpoint(from, to);
            if self.is_suspicious([from, middle]) { to = middle } else { from = middle }
        }
        let state = self.at(to);
        let by = self.excess([from, to]);
        // Of a value that rounding may have made anything of, nothing is known.
        let rounding: f64 =
            [from, to].map(|place| self.system.bounded_energy(self.part, &self.at(place), self.time)[1]).iter().sum();
        (by.abs() > SAFETY * rounding).then_some(Jump { part: self.part, by, time: self.time, state })
    }

    /// Whether an energy changes otherwise than its gradient says, by more than half of its digits.
    fn is_suspicious(&self, places: [f64; 2]) -> bool {
        let size: f64 = places.map(|place| self.energy(place).abs()).iter().sum();
        self.excess(places).abs() > f64::EPSILON.sqrt() * size
    }

    /// The change of the energy that its gradient does not explain.
    fn excess(&self, [from, to]: [f64; 2]) -> f64 {
        let [start, end] = self.ends;
        let along = combined(end, start, |end, start| end - start);
        let slope = |at: f64| self.system.energy(self.part, &self.at(at), Some(&along), self.time);
        let explained: f64 = quadrature::nodes([from, to]).map(|(at, weight)| weight * slope(at)).iter().sum();
        self.energy(to) - self.energy(from) - explained
    }

    fn energy(&self, place: f64) -> f64 {
        self.system.energy(self.part, &self.at(place), None, self.time)
    }

    /// The state at a place between the ends.
    fn at(&self, place: f64) -> Flat {
        let [start, end] = self.ends;
        combined(start, end, |start, end| start + place * (end - start))
    }
}

/// A state made of two, number by number.
fn combined(one: &Flat, other: &Flat, of: impl Fn(f64, f64) -> f64) -> Flat {
    let mut combined = one.clone();
    let both = combined.q.iter_mut().chain(&mut combined.p).zip(numbers(other));
    both.for_each(|(number, other)| *number = of(*number, other));
    combined
}
