//! Fixed-point coordinates: a grid of fixed spacing, on which every update can be inverted exactly.
//!
//! Always true: adding an increment and then its negative returns the bitwise identical number. Increments are rounded
//! to the grid, symmetrically for `d` and `-d`, and sums of grid points are exact within the range of the grid.

use crate::{
    scalar::{
        fma::{Avx512, Fused, Instructions},
        real::{Mask, Real},
    },
    state::precision::{Precision, Slot},
};
use core::ops::{AddAssign, Neg, SubAssign};

/// 1.5 · 2^52: a double of this many grid spacings has neighbours one spacing apart, on both sides for 2^51 of them.
const ANCHOR: f64 = 6_755_399_441_055_744.0;

/// 2^51, the number of spacings that a coordinate may be away from zero.
const RANGE: f64 = 2_251_799_813_685_248.0;

/// A number on a grid, for bitwise reversible runs. [`Phase::reversible`](crate::Phase::reversible) creates it.
///
/// The value is a double that is a multiple of the grid spacing, a power of two. An update rounds its increment to the
/// grid by adding and subtracting 1.5 · 2^52 spacings, so the sum is exact. This is a lattice map (Earn and Tremaine
/// 1992). A coordinate that leaves the range of 2^51 spacings on either side becomes NaN and stops the run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fixed<F> {
    value: F,
    spacing: F,
}

impl Fixed<f64> {
    /// Rounds `value` to the nearest grid point.
    ///
    /// If `value` is out of the range of the grid, or `spacing` is not a power of two, it is kept unrounded and a run
    /// rejects it.
    pub fn new(value: f64, spacing: f64) -> Self {
        let on_grid = (value + ANCHOR * spacing) - ANCHOR * spacing;
        let possible = is_power_of_two(spacing) && value.abs() < RANGE * spacing;
        Self { value: if possible { on_grid } else { value }, spacing }
    }

    /// Returns the number.
    pub fn value(self) -> f64 {
        self.value
    }

    /// Returns the spacing of the grid.
    pub fn spacing(self) -> f64 {
        self.spacing
    }
}

/// Negation: the point reflected at zero.
impl Neg for Fixed<f64> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// Adds an increment as a step does: rounded to the grid.
impl AddAssign<f64> for Fixed<f64> {
    fn add_assign(&mut self, increment: f64) {
        Slot::add(self, increment);
    }
}

/// Subtracts an increment as a step does: rounded to the grid.
impl SubAssign<f64> for Fixed<f64> {
    fn sub_assign(&mut self, increment: f64) {
        Slot::add(self, -increment);
    }
}

impl From<Fixed<f64>> for f64 {
    fn from(number: Fixed<f64>) -> Self {
        number.value
    }
}

/// Whether a grid may have this spacing: a positive power of two whose multiples up to the anchor are normal doubles.
pub(crate) fn is_power_of_two(spacing: f64) -> bool {
    const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    spacing.is_normal() && spacing > 0.0 && spacing.to_bits() & MANTISSA == 0 && (ANCHOR * spacing).is_finite()
}

impl<R: Real> Fixed<R> {
    /// Adds an increment to which the anchor was added.
    #[inline(always)]
    fn add_anchored(&mut self, anchored: R, anchor: R) {
        let sum = self.value + (anchored - anchor);
        let limit = R::of(RANGE) * self.spacing;
        // An increment beyond the range is not rounded to the grid, even where the sum comes back into it.
        let inside = (anchored - anchor).abs().less(limit);
        self.value = R::select(inside.and(sum.abs().less(limit)), sum, R::of(f64::NAN));
    }
}

impl<R: Real> Slot<R> for Fixed<R> {
    /// A number and its spacing alternate in memory, so that coordinates are not contiguous.
    type Wide = R;

    #[inline(always)]
    fn zero() -> Self {
        Self { value: R::of(0.0), spacing: R::of(0.0) }
    }
    #[inline(always)]
    fn value(self) -> R {
        self.value
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        let anchor = R::of(ANCHOR) * self.spacing;
        self.add_anchored(d + anchor, anchor);
    }
    #[inline(always)]
    fn fma(&mut self, a: R, b: R) {
        let anchor = R::of(ANCHOR) * self.spacing;
        self.add_anchored(a.fma(b, anchor), anchor);
    }
    #[inline(always)]
    fn select(mask: R::Mask, a: Self, b: Self) -> Self {
        Self { value: R::select(mask, a.value, b.value), spacing: R::select(mask, a.spacing, b.spacing) }
    }
}

impl Precision for Fixed<f64> {
    type Plain = f64;
    type Fused = Fused<f64>;
    type Avx512 = Fused<f64, Avx512>;
    type Slot<R: Real> = Fixed<R>;
    type Energy = f64;
    type EnergyIn<S: Instructions> = Fused<f64, S>;

    const NAME: &'static str = "reversible f64";
    const PARTS: usize = 2;
    const EPSILON: f64 = f64::EPSILON;
    const REVERSIBLE: bool = true;

    #[inline(always)]
    fn pack<R: Real>(of_lane: &dyn Fn(usize) -> Self) -> Fixed<R> {
        Fixed { value: R::state(&|lane| of_lane(lane).value), spacing: R::parameter(&|lane| of_lane(lane).spacing) }
    }
    #[inline(always)]
    fn unpack<R: Real>(slot: Fixed<R>, lane: usize) -> Self {
        Self { value: slot.value.lane(lane), spacing: slot.spacing.lane(lane) }
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn parts(self) -> [f64; 2] {
        [self.value, self.spacing]
    }
    fn from_parts([value, spacing]: [f64; 2]) -> Self {
        Self { value, spacing }
    }
    fn spacing(self) -> Option<f64> {
        Some(self.spacing)
    }
    fn limit(self) -> f64 {
        RANGE * self.spacing
    }
}
