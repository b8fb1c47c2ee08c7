//! The start of a measured motion: a point and a time.

use crate::state::{coords::Coords, phase::Phase, precision::Precision};

/// A point of phase space and a time: the start of the motion that a check measures.
///
/// A [`Phase`] alone begins at time 0; [`Phase::at_time`] sets another time. Checks take either.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Expanding;
///
/// #[hamiltonian(compose = Yoshida4)]
/// impl Expanding {
///     fn kinetic(&self, p: [f64; 1], t: f64) -> f64 {
///         0.5 * p[0] * p[0] / t.powi(2)
///     }
///     fn potential(&self, q: [f64; 1], t: f64) -> f64 {
///         -q[0].cos() * t
///     }
/// }
///
/// // At time 0 there is no such motion.
/// let start = Phase::new([1.0], [0.0]);
/// assert!(certify(&Expanding, Yoshida4, start, 0.01).is_err());
/// println!("{}", certify(&Expanding, Yoshida4, start.at_time(1.0), 0.01)?);
/// # Ok::<(), integrator_core::check::CertifyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start<C> {
    /// The point.
    pub phase: Phase<C>,
    /// The time.
    pub time: f64,
}

impl<C: Coords> Phase<C> {
    /// Returns this point at time `time`, as the start of a check. [`Run::at_time`](crate::Run::at_time) sets the time
    /// of a run.
    pub fn at_time(self, time: f64) -> Start<C> {
        Start { phase: self, time }
    }
}

/// An initial state with the coordinates `C` for a check: a [`Phase`] at time 0 or a [`Start`], by value or by
/// reference. It determines the precision of the measured motion.
#[diagnostic::on_unimplemented(
    message = "this system has the coordinates `{C}`, and this initial state is a `{Self}`",
    label = "not an initial state of this system",
    note = "write a `Phase<{C}>`, or one with a time, `Phase::new(q, p).at_time(t)`"
)]
pub trait IntoStart<C> {
    /// The type of one coordinate.
    type Leaf: Precision;
    /// The point and the time.
    fn into_start(self) -> Start<C>;
}

impl<C> From<Phase<C>> for Start<C> {
    fn from(phase: Phase<C>) -> Self {
        Self { phase, time: 0.0 }
    }
}

impl<C: Clone> From<&Phase<C>> for Start<C> {
    fn from(phase: &Phase<C>) -> Self {
        phase.clone().into()
    }
}

impl<C: Clone> From<&Start<C>> for Start<C> {
    fn from(start: &Start<C>) -> Self {
        start.clone()
    }
}

impl<C: Coords> IntoStart<C> for Phase<C> {
    type Leaf = C::Leaf;
    fn into_start(self) -> Start<C> {
        self.into()
    }
}

impl<C: Coords> IntoStart<C> for &Phase<C> {
    type Leaf = C::Leaf;
    fn into_start(self) -> Start<C> {
        self.into()
    }
}

impl<C: Coords> IntoStart<C> for Start<C> {
    type Leaf = C::Leaf;
    fn into_start(self) -> Self {
        self
    }
}

impl<C: Coords> IntoStart<C> for &Start<C> {
    type Leaf = C::Leaf;
    fn into_start(self) -> Start<C> {
        self.into()
    }
}
