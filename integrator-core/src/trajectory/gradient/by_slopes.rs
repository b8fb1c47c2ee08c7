//! A vector that is carried back through the flows of a composition, which add the derivatives of their energies with respect to
//! parameters: their number hardly counts.

use super::{Carrier, power};
use crate::{
    composition::{Processor, Stages},
    error::Error,
    scalar::exact::power_of_two,
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::parameter_derivatives::ParameterDerivatives,
    trajectory::{
        by_table::slopes::{Steps, StepsOf, single},
        tangent::{BETWEEN_SCALES, far_exponent, scaled},
    },
};
use alloc::{vec, vec::Vec};

/// A state and a vector between two blocks of steps.
pub(super) struct BySlopes<P, C> {
    table: (Stages, Processor),
    steps: StepsOf<P, C>,
    parameters: P,
    clock: Clock,
    state: Phase<C>,
    vector: Phase<C>,
    /// The power of two by which the vector was divided.
    exponent: i64,
    /// The derivatives with respect to parameters since the block began.
    slopes: Vec<f64>,
}

impl<P, C: Coords> BySlopes<P, C> {
    pub(super) fn new<H, K>(
        system: &H,
        table: (Stages, Processor),
        state: Phase<C>,
        vector: Phase<C>,
        clock: Clock,
    ) -> Self
    where
        H: ParameterDerivatives<Parameters<f64> = P>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        let (parameters, slopes) = (system.parameters(state.q.length()), vec![0.0; H::SENSITIVE.len()]);
        Self { table, steps: single::<H, K>(), parameters, clock, state, vector, exponent: 0, slopes }
    }
}

impl<P, C: Coords> Carrier<C> for BySlopes<P, C> {
    fn back(&mut self, mut left: u64) -> Result<(), Error> {
        while left > 0 {
            let block = left.min(BETWEEN_SCALES);
            let clock = Clock { t0: self.clock.at(self.clock.steps), steps: 0, ..self.clock };
            let (parameters, points) = ([&self.parameters; 2], [&self.state, &self.vector]);
            let Steps { points, slopes, is_finite } = (self.steps)(self.table, &parameters, &points, clock, block);
            if !is_finite {
                return Err(Error::NoGradient {
                    reason: "the way back led to a state or a derivative that is not finite\nhelp: use a smaller step",
                });
            }
            let power_of_vector = power(self.exponent);
            for (sum, slope) in self.slopes.iter_mut().zip(slopes) {
                *sum -= power_of_vector * slope;
            }
            let [state, vector] = &points[..] else { return Ok(()) };
            let exponent = far_exponent(vector);
            (self.state, self.vector) = (state.clone(), scaled(vector, power_of_two(-exponent)));
            self.exponent += i64::from(exponent);
            self.clock.steps += block;
            left -= block;
        }
        Ok(())
    }

    fn parameters(&self) -> usize {
        self.slopes.len()
    }

    fn has_blocks(&self) -> bool {
        false
    }

    fn state(&self) -> Phase<C> {
        self.state.clone()
    }

    fn vector(&self) -> (Phase<C>, f64) {
        (self.vector.clone(), power(self.exponent))
    }

    fn add_slopes(&mut self, slopes: &mut [f64]) {
        for (sum, slope) in slopes.iter_mut().zip(&mut self.slopes) {
            *sum += core::mem::take(slope);
        }
    }

    fn begin_block(&mut self, state: Option<&Phase<C>>, vector: Phase<C>) {
        if let Some(state) = state {
            self.state.clone_from(state);
        }
        self.vector = vector;
    }
}
