//! A vector that a run with deviation vectors carries back, for every method and system.

use super::{Carrier, power};
use crate::{
    error::Error,
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
    system::parameter_derivatives::ParameterDerivatives,
    trajectory::{
        method::Differentiable,
        sensitive::slopes_of,
        tangent::{Beginning, Tangent, scaled},
    },
};
use alloc::{vec, vec::Vec};

/// A run with one vector, and with the derivatives of its state with respect to parameters.
pub(super) struct ByTangent<C: Coords> {
    tangent: Tangent<C>,
    parameters: usize,
}

impl<C: Coords> ByTangent<C> {
    /// The run from a state, which may begin there.
    pub(super) fn new<H, X, K>(
        system: &H,
        method: X,
        start: Phase<C>,
        vector: Phase<C>,
        Clock { t0, h, .. }: Clock,
    ) -> Result<Self, Error>
    where
        H: ParameterDerivatives,
        X: Differentiable<H>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        let (length, vectors, parameters) = (start.q.length(), vec![vector], H::SENSITIVE.len());
        let beginning = Beginning { start, vectors, parameters, h, at: None };
        // A constant, so that one of both is compiled.
        let tangent = if const { H::SENSITIVE.is_empty() } {
            Tangent::begin::<H, X, K, false>(system, method, beginning, |_| Vec::new())
        } else {
            let slopes = |vectors| slopes_of(system, length, 1, vectors);
            Tangent::begin::<H, X, K, true>(system, method, beginning, slopes)
        };
        Ok(Self { tangent: tangent?.at_time(t0), parameters })
    }

    /// The power of two that the vector has to be multiplied by.
    fn power(&self) -> f64 {
        power(self.tangent.exponents().first().copied().unwrap_or(0))
    }
}

impl<C: Coords> Carrier<C> for ByTangent<C> {
    fn back(&mut self, steps: u64) -> Result<(), Error> {
        self.tangent.advance(steps)
    }

    fn parameters(&self) -> usize {
        self.parameters
    }

    fn has_blocks(&self) -> bool {
        self.parameters > 0
    }

    fn state(&self) -> Phase<C> {
        self.tangent.state()
    }

    fn vector(&self) -> (Phase<C>, f64) {
        (self.tangent.vector(0), self.power())
    }

    /// If a step by `-h` leads to Φ(z, θ), the end of the step by `h` from Φ changes with θ by -M ∂Φ/∂θ, and the function by the
    /// scalar product of this with its derivatives there: that of -∂Φ/∂θ with those at Φ.
    fn add_slopes(&mut self, slopes: &mut [f64]) {
        if slopes.is_empty() {
            return;
        }
        let power = self.power();
        let vectors = self.tangent.vectors();
        let [vector, by_parameters @ ..] = &vectors[..] else { return };
        for (sum, slope) in slopes.iter_mut().zip(by_parameters) {
            *sum += power * (product(&vector.q, &slope.p) - product(&vector.p, &slope.q));
        }
    }

    fn begin_block(&mut self, state: Option<&Phase<C>>, vector: Phase<C>) {
        self.tangent.reopen(state, &mut |vectors| {
            let [first, by_parameters @ ..] = vectors else { return };
            first.clone_from(&vector);
            for slope in by_parameters {
                *slope = scaled(slope, 0.0);
            }
        });
    }
}

/// The scalar product of two halves of vectors.
fn product<C: Coords>(a: &C, b: &C) -> f64 {
    a.flat().iter().zip(b.flat()).map(|(a, b)| a.to_f64() * b.to_f64()).sum()
}
