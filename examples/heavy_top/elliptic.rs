//! Jacobi's elliptic function sn by the arithmetic-geometric mean.

use std::f64::consts::FRAC_PI_2;

/// The elliptic functions of one modulus.
pub(crate) struct Elliptic {
    /// The means `aₙ` and the half differences `cₙ` of the arithmetic-geometric mean of 1 and `k′`, from n = 1 on.
    rows: Vec<(f64, f64)>,
    /// The limit of the means.
    mean: f64,
}

impl Elliptic {
    /// Prepares the functions of the modulus `k` from its complement `k′ = √(1 - k²)`.
    pub(crate) fn new(complement: f64) -> Self {
        let (mut a, mut b) = (1.0, complement);
        let mut rows = Vec::new();
        // The number of correct digits doubles each time. The last difference is rounded.
        while a - b > 2.0 * f64::EPSILON * a {
            let c = 0.5 * (a - b);
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            rows.push((a, c));
        }
        Self { rows, mean: a }
    }

    /// Returns the quarter period `K`.
    pub(crate) fn quarter_period(&self) -> f64 {
        FRAC_PI_2 / self.mean
    }

    /// Returns `sn u` (Abramowitz and Stegun 1964, 16.4).
    pub(crate) fn sn(&self, u: f64) -> f64 {
        let last = f64::from(1_u32 << self.rows.len()) * self.mean * u;
        let amplitude = self.rows.iter().rev().fold(last, |angle, (a, c)| 0.5 * (angle + (c / a * angle.sin()).asin()));
        amplitude.sin()
    }
}
