//! The method: an order and a tolerance.

use super::{
    Recurrences,
    expansion::{Constants, Expansion, step_functions},
    logarithm::Logarithm,
    series::HIGHEST,
};
use crate::{
    error::Error,
    hamiltonian::Shaped,
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    trajectory::{
        method::{Described, Facts, Method},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;

/// The Taylor method with a tolerance, for systems with `#[hamiltonian(taylor)]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor {
    pub(super) tolerance: f64,
    pub(super) order: usize,
}

/// The lowest order and the highest.
pub(super) const ORDERS: [usize; 2] = [4, HIGHEST];

impl Taylor {
    /// Steps whose last coefficients add at most the fraction `tolerance` of the size of a coordinate, with the order
    /// that takes the least work: `1 - ln(tolerance)/2` (Jorba and Zou 2005), from 4 to 28.
    ///
    /// Below the rounding, 1e-16, steps become shorter and no more accurate; tolerances of 1e-18 and less leave
    /// nothing but rounding.
    #[must_use]
    pub fn tolerance(tolerance: f64) -> Self {
        // `1 - ln(tolerance)/2` with the logarithm to the base of two: ln(2)/2 is 0.347.
        let order = 1.0 - 0.347 * Logarithm::of(tolerance).value();
        // Conversions saturate, and NaN becomes zero.
        Self { tolerance, order: (order + 1.0) as usize }.with_order_within()
    }

    /// The same with another order, from 4 to 28. Higher ones allow longer steps, which cost more.
    #[must_use]
    pub fn with_order(self, order: usize) -> Self {
        Self { order, ..self }.with_order_within()
    }

    fn with_order_within(self) -> Self {
        Self { order: self.order.clamp(ORDERS[0], ORDERS[1]), ..self }
    }

    /// The order.
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

impl<H: Recurrences> Method<H> for Taylor {
    /// Polynomials of one coordinate fit into the registers of any set, and those of AVX-512 make its steps no faster.
    const WIDE: bool = !matches!((H::Coords::LENGTH, H::Coords::COMPONENTS), (Some(1), 1));
    type Constants = Constants<H::Parameters<f64>>;
    type Motion<R: Real, K: Precision> = Expansion<R, Shaped<H, K>, H::Parameters<R>, H::Tape<R>>;

    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
        Arc::new(Constants { parameters, method: self, interleaved: H::INTERLEAVED })
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
        step_functions::<H, R, K>()
    }
}
