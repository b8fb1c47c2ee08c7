//! The flows of generated code, as values, and motions that some of them moved.
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
    #[inline(never)]
    pub(crate) fn apply<H: Hamiltonian, R: Real, K: Precision>(
        self,
        motion: &mut H::Motion<R, K>,
        duration: f64,
        time: f64,
    ) {
        match self {
            Self::First => H::drift::<R, K>(motion, duration, time),
            Self::Middle { backwards } => H::middle::<R, K>(motion, duration, time, backwards),
            Self::Last => H::last::<R, K>(motion, duration, time),
        }
    }
}

/// A motion from a point, with a tangent in the second lane if the scalar has one, after some flows, each for a duration.
pub(crate) fn moved<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    flows: &[(Flow, f64)],
    lanes: [&Phase<H::Coords>; 2],
    time: f64,
) -> H::Motion<R, f64> {
    let mut motion = H::Motion::<R, f64>::load(&[parameters; 2], &lanes);
    H::begin_step::<R, f64>(&mut motion, time);
    for (flow, duration) in flows {
        flow.apply::<H, R, f64>(&mut motion, *duration, time);
    }
    motion
}
