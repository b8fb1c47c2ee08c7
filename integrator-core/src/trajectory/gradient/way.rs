//! The way of a run there and back: where it began, where it is, and how large its coordinates are.

use super::{Derivatives, Gradient};
use crate::{
    error::Error,
    state::{coords::Coords, phase::Phase, precision::Precision},
    trajectory::tangent::numbers,
};
use alloc::vec::Vec;

/// The largest [`Gradient::return_error`]: the derivatives have about this relative error.
const LARGEST_RETURN_ERROR: f64 = 1e-3;

/// The beginning of a run, the state that was seen last, and the sizes of positions and momenta on the way.
pub(crate) struct Way<C> {
    begin: Phase<C>,
    pub(crate) last: Phase<C>,
    sizes: [f64; 2],
}

impl<C: Coords> Way<C> {
    pub(crate) fn from(begin: Phase<C>) -> Self {
        Self { last: begin.clone(), sizes: sizes(&begin), begin }
    }

    pub(crate) fn see(&mut self, state: Phase<C>) {
        for (largest, size) in self.sizes.iter_mut().zip(sizes(&state)) {
            *largest = largest.max(size);
        }
        self.last = state;
    }

    /// The gradient of a function with a value and derivatives, if the way back ended at the last state.
    ///
    /// # Errors
    /// [`Error::NoGradient`], [`Error::WayBack`]
    pub(crate) fn gradient(
        &self,
        value: f64,
        start: Derivatives<C>,
        parameters: Vec<f64>,
    ) -> Result<Gradient<C::With<f64>>, Error> {
        if !numbers(&start).chain(parameters.iter().copied()).all(f64::is_finite) {
            return Err(Error::NoGradient { reason: "it exceeds the range of its precision\nhelp: take fewer steps" });
        }
        match self.return_error() {
            error if error > LARGEST_RETURN_ERROR => Err(Error::WayBack { error }),
            return_error => Ok(Gradient { value, start, parameters, return_error }),
        }
    }

    /// The distance between the beginning and the last state: [`Gradient::return_error`].
    fn return_error(&self) -> f64 {
        let differences = [(&self.begin.q, &self.last.q), (&self.begin.p, &self.last.p)].map(|(begin, last)| {
            let pairs = begin.flat().iter().zip(last.flat());
            pairs.fold(0.0_f64, |largest, (a, b)| largest.max((a.to_f64() - b.to_f64()).abs()))
        });
        let relative = |half: usize| if differences[half] == 0.0 { 0.0 } else { differences[half] / self.sizes[half] };
        relative(0).max(relative(1))
    }
}

/// The largest position and the largest momentum.
fn sizes<C: Coords>(state: &Phase<C>) -> [f64; 2] {
    [&state.q, &state.p].map(|half| half.flat().iter().fold(0.0, |largest: f64, leaf| largest.max(leaf.to_f64().abs())))
}
