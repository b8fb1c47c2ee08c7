//! Stiff equations: Gear's backward differences, on the equation by which Curtiss and Hirschfelder (1952) introduced them.
//!
//! `y' = −λ (y − cos t)` has a slow solution near `cos t`, which all others approach within a few `1/λ`. Explicit methods have to
//! take steps for this transient, also where nothing is left of it. See Hairer and Wanner, Solving Ordinary Differential Equations
//! II (1996), sections IV.1 and V.2.

use crate::roots::{Complex, roots, turned};
use nalgebra::ComplexField;
use std::f64::consts::PI;

/// `λ`, as in Hairer and Wanner.
pub(crate) const STIFFNESS: f64 = 50.0;
/// The orders of the formulas that are stable.
pub(crate) const ORDERS: usize = 6;
/// The steps of the explicit method on either side of its limit `2/λ`, and those of Gear's, in units of `1/λ`.
pub(crate) const SHORT: f64 = 1.95;
pub(crate) const LONG: f64 = 2.1;
pub(crate) const GEAR: f64 = 5.0;
/// The time of the picture.
const END: f64 = 1.5;
/// The time after which nothing is left of the transient in Gear's steps.
const SETTLED: f64 = 3.0;

/// The angles `α` of the sectors in which the formulas are stable, in degrees (Hairer and Wanner 1996, table V.2.1).
const ANGLES: [f64; ORDERS] = [90.0, 90.0, 86.03, 73.35, 51.84, 17.84];

/// What is known of backward differences.
#[derive(Clone, Debug)]
pub(crate) struct Gear {
    /// The exact solution from 0, forward Euler in short and in long steps, and backward differences of orders 1 and 4.
    pub(crate) exact: Vec<(f64, f64)>,
    pub(crate) explicit: [Vec<(f64, f64)>; 2],
    pub(crate) implicit: [Vec<(f64, f64)>; 2],
    /// For each order the border of its region of stability, and `α` in degrees.
    pub(crate) borders: Vec<Vec<Complex>>,
    pub(crate) angles: Vec<f64>,
    /// The exponents of the errors.
    pub(crate) exponents: Vec<f64>,
    /// The error of forward Euler in long steps at the end, and the largest of backward differences after the transient.
    pub(crate) explodes: f64,
    pub(crate) stays: f64,
    /// The largest modulus of a parasitic root, of order 6 and of order 7.
    pub(crate) parasitic: [f64; 2],
}

impl Gear {
    /// The largest difference of the angles from those of the table, in degrees.
    pub(crate) fn angles_off(&self) -> f64 {
        self.angles.iter().zip(ANGLES).map(|(angle, known)| (angle - known).abs()).fold(0.0, f64::max)
    }

    /// The largest difference of the exponents from the orders.
    pub(crate) fn exponents_off(&self) -> f64 {
        self.exponents.iter().zip(1..).map(|(exponent, order)| (exponent - f64::from(order)).abs()).fold(0.0, f64::max)
    }
}

/// The coefficients of `Σⱼ ∇ʲ y / j`, of the new value first.
fn coefficients(order: usize) -> Vec<f64> {
    let mut sum = vec![0.0; order + 1];
    let mut difference = vec![1.0];
    for j in 1..=order {
        // ∇ʲ = ∇ʲ⁻¹ (1 − back).
        difference.push(0.0);
        for i in (1..difference.len()).rev() {
            difference[i] -= difference[i - 1];
        }
        sum.iter_mut().zip(&difference).for_each(|(sum, term)| *sum += term / j as f64);
    }
    sum
}

/// The solution that is `slow(0) + off` at the beginning.
fn exact(time: f64, off: f64) -> f64 {
    let l = STIFFNESS;
    (l * l * time.cos() + l * time.sin()) / (l * l + 1.0) + off * (-l * time).exp()
}

/// The solution that starts from zero.
fn from_zero(time: f64) -> f64 {
    exact(time, -exact(0.0, 0.0))
}

/// Backward differences from exact values up to an end. The equation is linear, so that it is solved for the new value.
fn backward(order: usize, h: f64, end: f64, start: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let weights = coefficients(order);
    let mut points: Vec<(f64, f64)> = (0..order).map(|n| (n as f64 * h, start(n as f64 * h))).collect();
    for n in order..=(end / h).round() as usize {
        let time = n as f64 * h;
        let past = points.iter().rev().zip(&weights[1..]).map(|((_, y), weight)| weight * y);
        let known = h * STIFFNESS * time.cos() - past.sum::<f64>();
        points.push((time, known / (weights[0] + h * STIFFNESS)));
    }
    points
}

/// Forward Euler from zero.
fn forward(h: f64) -> Vec<(f64, f64)> {
    let (mut y, mut points) = (0.0, vec![(0.0, 0.0)]);
    for n in 0..(END / h).round() as usize {
        let time = n as f64 * h;
        y -= h * STIFFNESS * (y - time.cos());
        points.push((time + h, y));
    }
    points
}

/// The distance of the last point from a solution.
fn last_off(points: &[(f64, f64)], solution: impl Fn(f64) -> f64) -> f64 {
    points.last().map_or(f64::NAN, |(time, y)| (y - solution(*time)).abs())
}

/// The border of the region of stability: `hλ` for which a root of the formula is `exp(iθ)`, namely `Σⱼ (1 − exp(−iθ))ʲ / j`.
fn border(order: usize) -> Vec<Complex> {
    const POINTS: u32 = 4_000;
    let of = |angle: f64| {
        let back = 1.0 - turned(-angle);
        let mut power = Complex::ONE;
        (1..=order).fold(Complex::ZERO, |sum, j| {
            power *= back;
            sum + power / j as f64
        })
    };
    (0..=POINTS).map(|point| of(2.0 * PI * f64::from(point) / f64::from(POINTS))).collect()
}

/// The largest `α` in degrees for which the sector of this angle around the negative axis is free of the border.
fn angle(border: &[Complex]) -> f64 {
    // At the origin the border is the imaginary axis, up to rounding.
    let left = border.iter().filter(|point| point.re < -1e-12);
    left.map(|point| point.im.abs().atan2(-point.re).to_degrees()).fold(90.0, f64::min)
}

/// The largest modulus of a root other than 1.
fn parasitic(order: usize) -> f64 {
    let polynomial: Vec<Complex> = coefficients(order).into_iter().map(Complex::from).collect();
    let all = roots(&polynomial);
    let others = all.into_iter().filter(|root| (root - 1.0).modulus() > 1e-6);
    others.map(ComplexField::modulus).fold(0.0, f64::max)
}

/// Measures backward differences.
pub(crate) fn gear() -> Gear {
    let borders: Vec<_> = (1..=ORDERS).map(border).collect();
    let exponent = |order: usize| {
        let slow = |time: f64| exact(time, 0.0);
        let error = |h: f64| last_off(&backward(order, h, 2.4, slow), slow);
        (error(0.04) / error(0.02)).log2()
    };
    let h = GEAR / STIFFNESS;
    let settled = (1..=ORDERS).flat_map(|order| backward(order, h, 2.0 * SETTLED, from_zero));
    let settled = settled.filter(|(time, _)| *time > SETTLED).map(|(time, y)| (y - from_zero(time)).abs());
    let long = forward(LONG / STIFFNESS);
    Gear {
        exact: (0..=600).map(|n| END * f64::from(n) / 600.0).map(|time| (time, from_zero(time))).collect(),
        explodes: last_off(&long, from_zero),
        explicit: [forward(SHORT / STIFFNESS), long],
        implicit: [1, 4].map(|order| backward(order, h, END, from_zero)),
        angles: borders.iter().map(|border| angle(border)).collect(),
        borders,
        exponents: (1..=ORDERS).map(exponent).collect(),
        stays: settled.fold(0.0, f64::max),
        parasitic: [parasitic(6), parasitic(7)],
    }
}

#[cfg(test)]
mod tests {
    use super::{coefficients, exact};

    #[test]
    fn backward_differences_have_their_coefficients() {
        assert_eq!(coefficients(1), [1.0, -1.0]);
        assert_eq!(coefficients(2), [1.5, -2.0, 0.5]);
        let third = coefficients(3).iter().zip([11.0 / 6.0, -3.0, 1.5, -1.0 / 3.0]).all(|(a, b)| (a - b).abs() < 1e-15);
        assert!(third);
        // The solution solves the equation.
        let slope = (exact(0.3 + 1e-6, 0.5) - exact(0.3 - 1e-6, 0.5)) / 2e-6;
        assert!((slope + 50.0 * (exact(0.3, 0.5) - 0.3_f64.cos())).abs() < 1e-8);
    }
}
