//! The first step from a point where a formula is singular and its derivative is not, such as `r³` with `r = √(x² + y²)` at zero.
//!
//! The series of the root begins with the power of the time that its radicand shows at a later order, so that the recurrences do
//! not find it. The motion leaves the point along its derivative. After a rounding of a step, the root is not zero.

use super::{expansion::Expansion, half::Half, segment::Segment, table::Layout};
use crate::{
    scalar::real::Real,
    state::{coords::Coords, precision::Precision},
    system::motion::Prepared,
};

/// The most steps in a row along derivatives, each four times as long: one moves positions away from the point, or momenta, and
/// positions follow.
const MOST: u8 = 5;

impl Segment {
    /// Chooses the step along the derivative, where the polynomial allows none and the derivative is finite: a rounding of the
    /// step of the run, or of the time in which a position changes by its own size. `norm(group, m)` is the norm of the
    /// coefficients of order `m` of each group, positions first, in a unit of time.
    #[cold]
    pub(super) fn along_derivative<K: Precision>(
        &mut self,
        h: f64,
        unit: f64,
        groups: usize,
        norm: impl Fn(usize, usize) -> f64,
    ) {
        if self.linear_steps == MOST || !(0..2 * groups).all(|group| norm(group, 1).is_finite()) {
            return;
        }
        let time = |group| norm(group, 0) / norm(group, 1) * unit;
        let time = (0..groups).map(time).filter(|time| *time > 0.0).fold(f64::INFINITY, f64::min);
        let time = if time.is_finite() { time.max(h.abs()) } else { h.abs() };
        let longer = f64::from(1_u32 << (2 * self.linear_steps));
        // The second order adds the square of a few roundings.
        (self.is_linear, self.step) = (true, Some((K::EPSILON * time * longer).copysign(h)));
        self.free = f64::INFINITY;
    }
}

impl<R: Real, C: Coords, P: Prepared<R>, T> Expansion<R, C, P, T> {
    /// Cuts the polynomials of the members that move along their derivative after the first order.
    #[inline(always)]
    pub(super) fn cut_linear(&mut self, layout: Layout) {
        if self.segments[..R::MEMBERS].iter().any(|segment| segment.is_linear) {
            let lines = R::parameter(&|lane| f64::from(u8::from(self.segments[lane].is_linear)));
            let keeps = lines.equal(R::of(0.0));
            Half::cut(&mut self.q, layout, keeps);
            Half::cut(&mut self.p, layout, keeps);
        }
    }
}
