//! The flows of generated code, as values, and the image of a point under some of them.
//!
//! Always true: a flow is compiled once for a kind of number, whichever checks apply it.

use crate::{
    hamiltonian::Hamiltonian,
    scalar::real::Real,
    state::{phase::Phase, precision::Precision},
    system::motion::Motion,
};

/// A flow of the generated code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Flow {
    /// The flow of the first part.
    First,
    /// The flows of the parts between the first and the last, in their order or backwards.
    Middle { backwards: bool },
    /// The flow of the last part.
    Last,
}

impl Flow {
    /// Moves a motion.
    pub(crate) fn apply<H: Hamiltonian, R: Real, K: Precision>(
        self,
        motion: &mut H::Motion<R, K>,
        duration: f64,
        time: f64,
    ) {
        match self {
            Self::First => H::drift::<R, K>(motion, duration, time),
            Self::Middle { backwards } => H::middle::<R, K>(motion, duration, time, backwards),
            Self::Last => H::kick::<R, K>(motion, duration, time),
        }
    }
}

/// Moves a point by some flows, with a tangent in the second lane if the scalar has one.
pub(crate) fn carry<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    flows: &[(Flow, f64)],
    lanes: &mut [Phase<H::Coords>; 2],
    time: f64,
) {
    let mut motion = H::Motion::<R, f64>::load(&[parameters; 2], &[&lanes[0], &lanes[1]]);
    H::begin_step::<R, f64>(&mut motion, time);
    for &(flow, duration) in flows {
        flow.apply::<H, R, f64>(&mut motion, duration, time);
    }
    for (lane, point) in lanes.iter_mut().enumerate().take(R::LANES) {
        motion.store(lane, point);
    }
}
