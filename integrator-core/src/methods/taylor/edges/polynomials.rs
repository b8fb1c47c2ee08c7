//! The polynomials of one member over a step, enclosed over ranges of time.

use super::{BOUNDS, Enclosure};
use crate::scalar::{interval::Interval, real::Real};
use alloc::{vec, vec::Vec};

/// The rounding error of a sum of all terms of a polynomial, relative to the sum of their absolute values.
const SUMMATION: f64 = 2.0 * f64::EPSILON;

/// The Taylor polynomials of positions and momenta, in the direction of the step.
pub(in crate::methods::taylor) struct Polynomials {
    order: usize,
    /// The number of positions and momenta together.
    count: usize,
    /// The coefficients, order by order.
    coefficients: Vec<f64>,
    /// The rounding error of a state: relative to the sum of the absolute values of all terms, and absolute.
    rounding: [f64; 2],
}

impl Polynomials {
    /// The polynomials with the coefficients `of(order, coordinate)`.
    pub(in crate::methods::taylor) fn new(
        [order, count]: [usize; 2],
        backwards: bool,
        [relative, absolute]: [f64; 2],
        of: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let mut coefficients = Vec::with_capacity((order + 1) * count);
        for k in 0..=order {
            let sign = if backwards && k % 2 == 1 { -1.0 } else { 1.0 };
            coefficients.extend((0..count).map(|coordinate| sign * of(k, coordinate)));
        }
        Self { order, count, coefficients, rounding: [relative + SUMMATION, absolute] }
    }

    /// Encloses all coordinates and their derivatives between two durations from the origin.
    pub(super) fn enclose(&self, [from, to]: [f64; 2]) -> Vec<Enclosure> {
        let zero = [0.0; BOUNDS + 2];
        // Terms and products of theirs may be too small to be numbers.
        let underflow = if to == 0.0 { 0.0 } else { f64::MIN_POSITIVE };
        // Of each coordinate the bounds of the value and of the derivative, and the sums of absolute values of both.
        let mut sums = vec![zero; self.count];
        let (mut powers, mut before) = ([1.0, 1.0], [0.0, 0.0]);
        for k in 0..=self.order {
            let numbers = &self.coefficients[k * self.count..][..self.count];
            let rates = before.map(|power| k as f64 * power);
            // In a unit far below the step, which free flights have, powers may be infinite.
            for (sums, number) in sums.iter_mut().zip(numbers).filter(|(_, number)| **number != 0.0) {
                let [[a, b], [c, d]] = [powers, rates].map(|powers| powers.map(|power| number * power));
                sums[0] += f64::min(a, b);
                sums[1] += f64::max(a, b);
                sums[2] += f64::min(c, d);
                sums[3] += f64::max(c, d);
                // Of the state at the origin nothing is rounded.
                sums[4] += if k == 0 { 0.0 } else { Real::abs(b) };
                sums[5] += Real::abs(d);
            }
            before = powers;
            powers = [powers[0] * from, powers[1] * to];
        }
        let [relative, absolute] = self.rounding;
        let numbers = &self.coefficients[..self.count];
        let enclosures = sums.into_iter().zip(numbers).map(|([low, high, least, most, size, speed], origin)| {
            let error = underflow
                + match size {
                    0.0 => 0.0,
                    size => relative * (size + Real::abs(*origin)) + absolute,
                };
            let (value, rate) = (Interval::new(low - error, high + error), relative * speed);
            let rate = Interval::new(least - rate, most + rate);
            Enclosure::state(&|lane| [value.low, rate.low, value.high, rate.high][lane])
        });
        enclosures.collect()
    }
}
