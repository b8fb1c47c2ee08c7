//! Long-time comparison of a flow with the vector field of its energy.
//!
//! In: a flow, a point, a duration. Out: the difference between the displacement of the point and the integral of the
//! field along the flow. Always true: both agree only if the flow solves the equations of motion everywhere, so a flow
//! of a slightly different energy is detected. The integral is a quadrature, whose halves give its accuracy.

use crate::{
    check::{
        flow::Flow,
        property::{
            energies::{Part, gradient_tolerance},
            part_flows::Flows,
            slope::SAFETY,
        },
        statistics::{
            points::{numbers, origin},
            quadrature,
        },
    },
    scalar::tolerance::{largest, within},
    state::flat::Flat,
    system::user_energies::Digits,
};

/// The number of directions in which displacements are compared.
const DIRECTIONS: usize = 2;

/// The largest number of times that a duration is divided by four until the quadrature resolves the course.
const TRIES: usize = 5;

/// A displacement that the field along the way does not explain.
pub(super) struct Astray {
    pub(super) error: f64,
    pub(super) tolerance: f64,
    pub(super) duration: f64,
}

/// The course of a flow from a point, at a time of the clock.
pub(super) struct Course<'s> {
    pub(super) system: &'s dyn Flows,
    pub(super) part: Part,
    pub(super) flow: Flow,
    pub(super) point: &'s Flat,
    pub(super) time: f64,
}

impl Course<'_> {
    /// The displacement beside the integral of the field, in some directions, over the longest time up to `longest` in which the
    /// quadrature is exact up to rounding; empty where there is none.
    pub(super) fn compared(&self, longest: f64) -> Vec<Astray> {
        let mut duration = longest;
        for _ in 0..TRIES {
            if let Some(compared) = self.over(duration) {
                return compared;
            }
            duration /= 4.0;
        }
        Vec::new()
    }

    /// Compares displacements over a duration.
    fn over(&self, duration: f64) -> Option<Vec<Astray>> {
        let unit = gradient_tolerance(self.point.q.len());
        let end = self.end(self.point, duration);
        let [whole, halves] = [1_u32, 2].map(|panels| self.nodes(duration, panels));
        let on_the_way = || halves.iter().map(|(_, at)| at).chain([self.point, &end]);
        if !on_the_way().flat_map(numbers).all(f64::is_finite) {
            return None;
        }
        // What a flow rounds: what it is given, which grows on the way, and its result.
        let mut digits = Digits::default();
        let mut nearby = self.point.clone();
        nearby.q.iter_mut().chain(&mut nearby.p).for_each(|number| *number *= 1.0 + unit * digits.next());
        let grown = self.end(&nearby, duration);
        let sizes = (0..numbers(&end).count())
            .map(|index| unit * largest(on_the_way().filter_map(|at| numbers(at).nth(index))));
        let rounding: Vec<f64> = numbers(&grown)
            .zip(numbers(&end))
            .zip(sizes)
            .map(|((grown, end), size)| (grown - end).abs() + size)
            .collect();
        let lengths = [&self.point.q, &self.point.p].map(|half| largest(half.iter().copied()));
        let directions = (0..DIRECTIONS).map(|_| {
            let mut direction = origin(self.point);
            for (half, length) in [&mut direction.q, &mut direction.p].into_iter().zip(lengths) {
                half.iter_mut().for_each(|weight| *weight = digits.next() / if length > 0.0 { length } else { 1.0 });
            }
            self.along(&direction, (duration, &end), [&whole, &halves], &rounding)
        });
        directions.collect()
    }

    /// Compares the displacement in one direction; `None` where the quadrature is not exact up to rounding.
    fn along(
        &self,
        direction: &Flat,
        (duration, end): (f64, &Flat),
        [whole, halves]: [&[(f64, Flat)]; 2],
        rounding: &[f64],
    ) -> Option<Astray> {
        let [mut coarse, mut fine, mut of_field] = [0.0; 3];
        for (weight, at) in whole {
            coarse += weight * self.field(direction, at)[0];
        }
        for (weight, at) in halves {
            let [value, own] = self.field(direction, at);
            let mut off = at.clone();
            off.q.iter_mut().chain(&mut off.p).zip(rounding).for_each(|(number, rounding)| *number += rounding);
            fine += weight * value;
            of_field += weight.abs() * (own + (self.field(direction, &off)[0] - value).abs());
        }
        let [weights, starts, ends] = [direction, self.point, end].map(numbers);
        let displacement: f64 =
            weights.zip(ends.zip(starts)).map(|(weight, (end, start))| weight * (end - start)).sum();
        let of_ends: f64 = numbers(direction).zip(rounding).map(|(weight, rounding)| weight.abs() * rounding).sum();
        let explained = of_ends + of_field;
        within(fine - coarse, explained).then(|| Astray {
            error: (displacement - fine).abs(),
            tolerance: SAFETY * explained,
            duration,
        })
    }

    /// The component of the vector field along a direction, and a bound on its rounding.
    fn field(&self, direction: &Flat, at: &Flat) -> [f64; 2] {
        let tangent = Flat { q: direction.p.iter().map(|weight| -weight).collect(), p: direction.q.clone() };
        self.system.bounded_slope(self.part, at, &tangent, self.time)
    }

    /// The nodes of a quadrature over a duration in equal panels: their weights, and where the flow is then.
    fn nodes(&self, duration: f64, panels: u32) -> Vec<(f64, Flat)> {
        let length = duration / f64::from(panels);
        let of_panel = |panel: u32| quadrature::nodes([0, 1].map(|end| f64::from(panel + end) * length));
        let nodes = (0..panels).flat_map(of_panel);
        nodes.map(|(at, weight)| (weight, self.end(self.point, at))).collect()
    }

    fn end(&self, point: &Flat, duration: f64) -> Flat {
        self.system.carried(&[(self.flow, duration)], point, None, self.time).0
    }
}
