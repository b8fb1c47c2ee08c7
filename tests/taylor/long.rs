//! A system whose recurrences are too long for code of each order: one function serves all orders.

use crate::runs::FINE;
use integrator_core::{
    KahanLi8,
    prelude::*,
    taylor::{Recurrences, Taylor},
};

/// A bar that rotates in a halo.
struct Bar {
    speed: f64,
    length: f64,
}

#[hamiltonian(taylor)]
impl Bar {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + p[1] * p[1] / 3.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let (s, c) = (self.speed * t).sin_cos();
        let (x, y) = (c * q[0] + s * q[1], c * q[1] - s * q[0]);
        let r = (x * x + y * y + 0.1).sqrt();
        let w = if r < self.length { r * r } else { self.length / r };
        let first = (w * 1.5 + x).sin() + (w + y * 0.5).exp() + (w * w + 2.1 + x * x).sqrt();
        let second = w * x * y / (3.2 + w * w) + (w + x).cos() * (w - y).sin() + (1.0 + w * w + y * y).ln();
        let third = (x * w).atan() + (y * w).tanh() + (w * 0.3 - x * y).sinh() + (2.0 + w).powf(1.3);
        0.5 * (0.1 + x * x + y * y / 0.81).ln() + 0.1 * (first + second + third)
    }
}

#[test]
fn a_long_potential_moves_as_compositions_do() {
    const { assert!(<Bar as Recurrences>::ROLLED) };
    // The bar is so long that the motion stays within it: forces are smooth.
    let bar = Bar { speed: 0.7, length: 20.0 };
    let start = Phase::new([0.5, 0.1], [0.1, 0.6]);
    let mut run = bar.run_with(Taylor::tolerance(FINE), start, 0.25).expect("a start");
    let mut reference = bar.run_with(KahanLi8, start, 1.0 / 512.0).expect("a start");
    run.advance(16).expect("a regular motion");
    reference.advance(2048).expect("a regular motion");
    let ends: [[f64; 2]; 2] = [run.state().q, reference.state().q];
    for (found, expected) in ends[0].into_iter().zip(ends[1]) {
        // The eighth power of the reference's step is below a rounding; it has some 35,000 stages of roundings.
        assert!((found - expected).abs() < 1e-12, "{found} and {expected}");
    }
}
