//! The method: an order and a tolerance.

use super::{
    Recurrences,
    expansion::{Constants, Expansion, step_functions},
    logarithm::Logarithm,
    series::HIGHEST,
};
use crate::{
    error::Error,
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    system::Shaped,
    trajectory::{
        method::{Described, Differentiable, Facts, Method},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;
use core::f64::consts::LOG10_2;

/// The Taylor method with a tolerance, for systems with `#[hamiltonian(taylor)]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor {
    pub(super) tolerance: f64,
    pub(super) order: usize,
}

/// The lowest order and the highest.
pub(super) const ORDERS: [usize; 2] = [4, HIGHEST];

/// The order of least work for a tolerance without digits; each digit adds one to it.
///
/// A polynomial of order `n` takes the time `1 + (n/17)²`, in units of what does not depend on the order, and a step that
/// meets a tolerance `ε` is as long as `ε^(1/n)`. The work `(1 + (n/17)²) ε^(-1/n)` of a span is least where `2 n³ = (n² +
/// 17²) ln(1/ε)`: at 15.4 for 1e-6, 19.9 for 1e-10, 24.1 for 1e-14 and 28.2 for 1e-18, ten more than there are digits. But at one
/// tolerance a higher order leaves out more, since its terms fall more slowly. To one error the least is two orders below,
/// which is within two per cent of it. The 17 and the two are those of five problems, with loops and without;
/// `docs/contributing/taylor.md` has the measurements.
const LOWEST_BY_WORK: f64 = 8.0;

/// The shift before rounding to even orders, which loops compute in pairs. Odd numbers round down, since lower orders
/// err less at the same tolerance; an order that is even within the error of a logarithm rounds to itself.
const DOWN: f64 = 0.25;

impl Taylor {
    /// Creates a method with a relative tolerance and the order that needs about the least work for it.
    ///
    /// The last coefficients of a step contribute at most the fraction `tolerance` of the size of a coordinate. The order is
    /// the number of digits of the tolerance plus eight, made even, and at most 28; for 1e-10 it is 18.
    ///
    /// Below rounding, 1e-16, smaller tolerances shorten steps without improving their accuracy. At 1e-18 and below, only
    /// rounding errors remain.
    #[must_use]
    pub fn tolerance(tolerance: f64) -> Self {
        let digits = -LOG10_2 * Logarithm::of(tolerance).value();
        // Conversions saturate, and NaN becomes zero.
        Self { tolerance, order: 2 * ((LOWEST_BY_WORK + digits) / 2.0 + DOWN) as usize }.with_order_within()
    }

    /// Sets the order, from 4 to 28. Higher orders allow longer steps, which cost more.
    #[must_use]
    pub fn with_order(self, order: usize) -> Self {
        Self { order, ..self }.with_order_within()
    }

    fn with_order_within(self) -> Self {
        Self { order: self.order.clamp(ORDERS[0], ORDERS[1]), ..self }
    }

    /// Returns the order.
    #[inline(always)]
    pub fn order(self) -> usize {
        // The bounds are known to hold; said here, they spare tables the question.
        self.order.clamp(ORDERS[0], ORDERS[1])
    }
}

impl Described for Taylor {
    fn facts(self) -> Facts {
        Facts {
            name: "Taylor",
            order: self.order as u32,
            adaptive: true,
            roundings: 2 * self.order,
            ..Facts::UNCLAIMED
        }
    }
    fn admissible(self) -> Result<(), Error> {
        match self.tolerance.is_finite() && self.tolerance > 0.0 {
            true => Ok(()),
            false => Err(Error::Tolerance { method: "Taylor", tolerance: self.tolerance }),
        }
    }
}

#[diagnostic::do_not_recommend]
impl<H: Recurrences> Method<H> for Taylor {
    /// Polynomials of one coordinate fit into the registers of any set, and those of AVX-512 make its steps no faster.
    const WIDE: bool = !matches!((H::Coords::LENGTH, H::Coords::COMPONENTS), (Some(1), 1));
    type Constants = Constants<H::Parameters<f64>>;
    type Motion<R: Real, K: Precision> = Expansion<R, Shaped<H, K>, H::Parameters<R>, H::Tape<R>>;

    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
        Arc::new(Constants { parameters, method: self, interleaved: H::INTERLEAVED, has_edges: H::HAS_EDGES })
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
        step_functions::<H, R, K>()
    }
}

impl<H: Recurrences> Differentiable<H> for Taylor {}

#[cfg(test)]
mod tests {
    use super::{ORDERS, Taylor};

    /// The work of a span in the model from which orders follow.
    fn work(order: usize, digits: f64) -> f64 {
        let order = order as f64;
        (1.0 + (order / 17.0).powi(2)) * (digits * std::f64::consts::LN_10 / order).exp()
    }

    #[test]
    fn orders_follow_the_digits() {
        for (tolerance, order) in
            [(1e-4, 12), (1e-8, 16), (1e-10, 18), (1e-15, 22), (1e-16, 24), (1e-18, 26), (1e-30, 28), (1.0, 8)]
        {
            assert_eq!(Taylor::tolerance(tolerance).order(), order, "{tolerance:e}");
        }
        let [lowest, highest] = ORDERS;
        assert_eq!(
            [f64::INFINITY, f64::NAN, 0.0].map(|none| Taylor::tolerance(none).order()),
            [lowest, lowest, highest]
        );
    }

    #[test]
    fn the_straight_line_is_near_the_least_work() {
        for quarter in 12..73 {
            let digits = f64::from(quarter) / 4.0;
            let chosen = work(Taylor::tolerance(10.0_f64.powf(-digits)).order(), digits);
            let least = (ORDERS[0]..=ORDERS[1]).map(|order| work(order, digits)).fold(f64::INFINITY, f64::min);
            // Two orders below the least, where the curve is flat, and rounding takes up to two more.
            assert!(chosen < 1.05 * least, "{digits} digits: {}", chosen / least);
        }
    }
}
