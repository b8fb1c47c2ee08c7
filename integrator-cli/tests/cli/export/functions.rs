//! Systems that call every elementary function that has a kernel, and sums in the order of lanes.

use integrator_core::prelude::*;

/// A frequency of waves. It is no unit.
const UNIT: f64 = 0.5 * core::f64::consts::PI;

/// All functions.
#[derive(Clone)]
pub(crate) struct Precise {
    /// The height of all of them, in joules.
    pub(crate) scale: f64,
    /// A field that H does not read, and that C does not know.
    pub(crate) title: String,
}

#[hamiltonian]
impl Precise {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let (a, b) = (0.3 * x.sin(), 0.5 * (UNIT * y).cos());
        let smooth = a.asin() + b.acos() + a.tan() + (a * b).atan() + (1.0 + a).atan2(b + 2.0) + b.exp();
        let powers = (2.0 + a).ln() + b.ln_1p() + (a + b).cbrt() + (2.0 + b).powf(a) + (1.0 + a * a).sqrt();
        let round =
            (3.0 * y).floor() + (2.0 * y).ceil() + (2.5 * y).round() + (1.5 * y).round_ties_even() + (4.0 * y).trunc();
        let steps = (a - b).abs() + a.max(b) + a.min(0.1) + 0.01 * x * (round + x.signum() + (5.0 * y) % 0.7);
        self.scale.powi(3) * (smooth + powers + steps) + 0.5 * (x * x + y * y)
    }
}

/// The faster ones.
#[derive(Clone)]
pub(crate) struct Faster {
    pub(crate) scale: f64,
}

#[hamiltonian(functions = fast)]
impl Faster {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let (a, b) = (0.3 * x.sin(), 0.5 * y.cos());
        let smooth = a.asin() + b.acos() + a.tan() + (a * b).atan() + (1.0 + a).atan2(b + 2.0) + b.exp();
        let powers = (2.0 + a).ln() + b.ln_1p() + (a + b).cbrt() + (2.0 + b).powf(a);
        self.scale.sqrt() * (smooth + powers) + 0.5 * (x * x + y * y)
    }
}

/// A sum in lanes, over a table with a condition.
#[derive(Clone)]
pub(crate) struct Waves {
    pub(crate) height: [f64; 40],
    pub(crate) first: usize,
}

#[hamiltonian]
impl Waves {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        let mut energy = 0.5 * (x * x + y * y);
        for k in 0..40 {
            energy += self.height[(k + self.first) % 40] * ((k as f64 + 1.0) * x + y).cos() / (k as f64 + 2.0).powi(2);
        }
        energy
    }
}
