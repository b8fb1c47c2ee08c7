//! Taylor's method: its steps along an eccentric orbit, and the radius of convergence.
//!
//! Kepler's motion is singular where `r = a (1 − e cos E)` vanishes: at the eccentric anomalies `±i arcosh(1/e)`, which belong to the
//! complex times `±iτ` with `τ = arcosh(1/e) − sqrt(1 − e²)`, counted from a perihelion. The series about the time `t` converges up
//! to the distance of the nearest one, `sqrt(t² + τ²)`. A step by the last two terms of a series of order `K` is the share
//! `ε^(1/K)` of this radius (Jorba and Zou 2005), up to the size of the state.

use crate::{
    models::{ECCENTRICITY, Kepler, apsis},
    problem::wrapped,
};
use integrator_core::{prelude::*, taylor::Taylor};
use std::f64::consts::TAU;

/// A step of Taylor's method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// The time of its beginning, counted from a perihelion.
    pub(crate) time: f64,
    /// The position there.
    pub(crate) place: (f64, f64),
    pub(crate) length: f64,
}

/// The steps along a period.
#[derive(Clone, Debug)]
pub(crate) struct Radius {
    pub(crate) steps: Vec<Step>,
}

/// The tolerance, and the number of times at which it is seen whether a step has ended.
pub(crate) const TOLERANCE: f64 = 1e-14;
const TIMES: u32 = 1 << 15;

/// The radius of convergence of the series about a time.
pub(crate) fn of_convergence(time: f64) -> f64 {
    let away = (1.0 / ECCENTRICITY).acosh() - (1.0 - ECCENTRICITY * ECCENTRICITY).sqrt();
    wrapped(time).hypot(away)
}

impl Radius {
    /// The smallest and the largest share of the radius of convergence that a step takes.
    pub(crate) fn shares(&self) -> [f64; 2] {
        let shares = || self.steps.iter().map(|step| step.length / of_convergence(step.time));
        [shares().fold(f64::INFINITY, f64::min), shares().fold(0.0, f64::max)]
    }
}

/// Follows the steps of Taylor's method from a perihelion to the next one.
pub(crate) fn radius() -> Option<Radius> {
    let h = TAU / f64::from(TIMES);
    let mut run = Kepler.run_with(Taylor::tolerance(TOLERANCE), apsis(-1.0), h).ok()?;
    let start = run.state();
    let mut steps = Vec::new();
    let mut begin = (0.0, (start.q[0], start.q[1]));
    let mut ended = 0;
    for _ in 0..TIMES {
        run.advance(1).ok()?;
        let all = run.own_steps()?.taken;
        if all > ended {
            ended = all;
            let (time, place) = begin;
            steps.push(Step { time, place, length: run.time() - time });
            let state = run.state();
            begin = (run.time(), (state.q[0], state.q[1]));
        }
    }
    Some(Radius { steps })
}

#[cfg(test)]
mod tests {
    use super::of_convergence;

    /// The coefficients of Kepler's series fall as the radius says: those of `x(t)` at perihelion by the recurrence of
    /// `x'' = −x / r³`, whose orders are even there.
    #[test]
    fn the_radius_is_that_of_the_series() {
        let e = super::ECCENTRICITY;
        const ORDERS: usize = 120;
        // x, y, r², and s = r⁻³ by r² s' = −(3/2) (r²)' s.
        let (mut x, mut y) = (vec![1.0 - e, 0.0], vec![0.0, ((1.0 + e) / (1.0 - e)).sqrt()]);
        let (mut square, mut s): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        let product = |a: &[f64], b: &[f64], k: usize| (0..=k).map(|j| a[j] * b[k - j]).sum::<f64>();
        for k in 0..ORDERS {
            square.push(product(&x, &x, k) + product(&y, &y, k));
            s.push(if k == 0 {
                square[0].powf(-1.5)
            } else {
                let terms = (1..=k).map(|j| (1.5 * j as f64 + (k - j) as f64) * square[j] * s[k - j]);
                -terms.sum::<f64>() / (k as f64 * square[0])
            });
            let over = ((k + 1) * (k + 2)) as f64;
            let next = [&x, &y].map(|q| -product(q, &s, k) / over);
            x.push(next[0]);
            y.push(next[1]);
        }
        // Terms behave as k^(−5/3) ρ^(−k) near a singularity (t − t*)^(2/3).
        let ratio = |k: usize| (x[k] / x[k + 2]).abs().sqrt() * (k as f64 / (k + 2) as f64).powf(5.0 / 6.0);
        assert!((ratio(116) / of_convergence(0.0) - 1.0).abs() < 0.01, "{} and {}", ratio(116), of_convergence(0.0));
        assert!((of_convergence(1.0) - 1.0_f64.hypot(of_convergence(0.0))).abs() < 1e-15);
        assert!((of_convergence(std::f64::consts::TAU - 0.5) - of_convergence(0.5)).abs() < 1e-14);
    }
}
