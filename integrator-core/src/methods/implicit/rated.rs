//! The vector field in a fictitious time, for step-size control by a function of the user's.
//!
//! In `(q, t)` and `(p, B)`, a system with the Hamiltonian `(H + B)/Ω(q)` has the orbits of H where `B = -H`, and its independent
//! variable `s` passes by `ds = Ω dt` (Hairer, Lubich and Wanner 2006, VIII.2.1; Hairer 1997, Appl. Numer. Math. 25, 219). It does
//! not separate, so that symplectic steps of it are implicit. B is constant, and the time an integral along the stages.

use super::{
    field::{Constants, Field, Pair, Variable},
    gauss_legendre::GaussLegendre,
};
use crate::{
    methods::pace::{Paced, transformed},
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    system::{
        MovedBy, ReadBy, System,
        motion::{Moved, Read},
    },
    trajectory::method::{Described, Facts},
};

/// A Hamiltonian that is not `T(p) + V(q)`, without an explicit time, with a pace of the user's own. Written by
/// `#[hamiltonian]`.
#[diagnostic::on_unimplemented(
    message = "`Paced<GaussLegendre<_>>` does not support `{Self}`",
    label = "has no `rate`, is T(p) + V(q), or depends on the time",
    note = "add `fn rate(&self, q: ...) -> f64` next to `hamiltonian`; a larger value shortens the steps",
    note = "for H = T(p) + V(q), use a composition: `Paced(KahanLi8)`"
)]
pub trait RatedField: System {
    /// The pace by the user's own function, as it is written.
    fn stated_rate(&self, q: &Self::Coords) -> f64;
    /// The energy at a point.
    fn energy_at<R: Real, K: Precision>(point: ReadBy<'_, Self, R, K>) -> R;
    /// The pace at a point.
    fn rate_at<R: Real, K: Precision>(point: ReadBy<'_, Self, R, K>) -> R;
    /// Adds the field of `(H + conjugate)/rate` at a point.
    fn along_rated_field<R: Real, K: Precision>(
        point: ReadBy<'_, Self, R, K>,
        field: MovedBy<'_, Self, R, K>,
        conjugate: R,
    );
}

impl<const S: usize> Described for Paced<GaussLegendre<S>> {
    fn facts(self) -> Facts {
        transformed("Paced", self.0.facts())
    }
}

/// The field of `(H + B)/Ω`, in the fictitious time.
#[derive(Clone, Copy)]
pub struct OfRate;

impl Variable for OfRate {
    const IS_FICTITIOUS: bool = true;
}

impl<H: RatedField> Field<H> for OfRate {
    const MAY_BE_TOGETHER: bool = true;

    #[inline(always)]
    fn at<R: Real>(constants: &Constants<'_, H, R>, conjugate: R, point: &Pair<H, R>, time: f64) -> Pair<H, R> {
        let mut field = Pair::zero(H::Coords::slots(&point.q).len());
        Self::add(constants.gathered, conjugate, point, &mut field, time);
        field
    }
    #[inline(always)]
    fn add<R: Real>(
        parameters: &H::Parameters<R>,
        conjugate: R,
        Pair { q, p }: &Pair<H, R>,
        field: &mut Pair<H, R>,
        _time: f64,
    ) {
        let moved = Moved { q: &mut field.q, p: &mut field.p };
        H::along_rated_field::<R, f64>(Read { q, p, parameters }, moved, conjugate);
    }
    #[inline(always)]
    fn conjugate<R: Real>(parameters: &H::Parameters<R>, Pair { q, p }: &Pair<H, R>) -> R {
        -H::energy_at::<R, f64>(Read { q, p, parameters })
    }
    #[inline(always)]
    fn rate<R: Real>(parameters: &H::Parameters<R>, Pair { q, p }: &Pair<H, R>) -> R {
        H::rate_at::<R, f64>(Read { q, p, parameters })
    }
}
