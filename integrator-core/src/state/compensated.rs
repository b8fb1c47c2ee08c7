//! Compensated coordinates: numbers with the accumulated rounding error of their updates (Kahan 1965).

use crate::{
    scalar::{
        double_double::DoubleDouble,
        exact::fast_two_sum,
        fma::{Avx512, Fused, Instructions},
        real::Real,
        simd::block::Block,
    },
    state::precision::{Precision, Slot},
};
use core::ops::{AddAssign, Neg, SubAssign};

/// A number together with the accumulated rounding error of its updates.
/// [`Phase::compensated`](crate::Phase::compensated) creates it.
///
/// Every update first adds the carried error, then carries the rounding error of the new addition (Kahan 1965). The
/// error of a long sum hence stays at the rounding of one addition.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compensated<F> {
    /// The number.
    pub value: F,
    /// The rounding error that is still to be added, below half a unit in the last place of the number.
    pub carried: F,
}

/// The number with what it carries, rounded.
impl From<Compensated<f64>> for f64 {
    fn from(number: Compensated<f64>) -> Self {
        number.value + number.carried
    }
}

/// The opposite number, with the opposite of what it carries.
impl Neg for Compensated<f64> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, carried: -self.carried }
    }
}

/// Adds an increment as a step does, and carries the rounding error.
impl AddAssign<f64> for Compensated<f64> {
    fn add_assign(&mut self, increment: f64) {
        let [value, carried] = fast_two_sum(self.value, increment + self.carried);
        *self = Self { value, carried };
    }
}

/// Subtracts an increment as a step does, and carries the rounding error.
impl SubAssign<f64> for Compensated<f64> {
    fn sub_assign(&mut self, increment: f64) {
        *self += -increment;
    }
}

/// The number and what it carries. An array, so that consecutive coordinates are a slice of numbers, which
/// blocks read and write without a register of fewer lanes.
impl<R: Real> Slot<R> for [R; 2] {
    type Wide = R::Block;

    #[inline(always)]
    fn zero() -> Self {
        [R::of(0.0); 2]
    }
    #[inline(always)]
    fn value(self) -> R {
        let [value, _] = self;
        value
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        let [value, carried] = *self;
        *self = fast_two_sum(value, d + carried);
    }
    #[inline(always)]
    fn fma(&mut self, a: R, b: R) {
        let [value, carried] = *self;
        *self = fast_two_sum(value, a.fma(b, carried).apart());
    }
    #[inline(always)]
    fn select(mask: R::Mask, a: Self, b: Self) -> Self {
        [R::select(mask, a[0], b[0]), R::select(mask, a[1], b[1])]
    }
    #[inline(always)]
    fn parts(self) -> [R; 2] {
        self
    }
    #[inline(always)]
    fn of_parts(parts: [R; 2]) -> Self {
        parts
    }
    #[inline(always)]
    fn read<B: Block<R>>(from: &[Self]) -> B {
        let [values, _] = deinterleaved(&from[..B::WIDTH]);
        values
    }
    #[inline(always)]
    fn update<B: Block<R>>(to: &mut [Self], a: R, b: B) {
        let to = &mut to[..B::WIDTH];
        let [values, carried] = deinterleaved(to);
        let [values, carried] = fast_two_sum(values, B::splat(a).fma(b, carried));
        let [first, second] = values.interleave(carried);
        let (first_half, second_half) = to.as_flattened_mut().split_at_mut(B::WIDTH);
        first.write(first_half);
        second.write(second_half);
    }
}

/// The values of a block of slots, and what they carry.
#[inline(always)]
fn deinterleaved<R: Real, B: Block<R>>(slots: &[[R; 2]]) -> [B; 2] {
    let (first_half, second_half) = slots.as_flattened().split_at(B::WIDTH);
    B::read(first_half).deinterleave(B::read(second_half))
}

impl Precision for Compensated<f64> {
    type Plain = f64;
    type Fused = Fused<f64>;
    type Avx512 = Fused<f64, Avx512>;
    type Slot<R: Real> = [R; 2];
    type Energy = DoubleDouble;
    type EnergyIn<S: Instructions> = DoubleDouble;

    const NAME: &'static str = "compensated f64";
    const PARTS: usize = 2;
    const EPSILON: f64 = f64::EPSILON;
    const COMPENSATED: bool = true;

    #[inline(always)]
    fn pack<R: Real>(of_lane: &dyn Fn(usize) -> Self) -> [R; 2] {
        [R::state(&|lane| of_lane(lane).value), R::state(&|lane| of_lane(lane).carried)]
    }
    #[inline(always)]
    fn unpack<R: Real>([value, carried]: [R; 2], lane: usize) -> Self {
        Self { value: value.lane(lane), carried: carried.lane(lane) }
    }
    fn to_f64(self) -> f64 {
        self.value
    }
    fn parts(self) -> [f64; 2] {
        [self.value, self.carried]
    }
    fn from_parts([value, carried]: [f64; 2]) -> Self {
        Self { value, carried }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_compensated_sum_keeps_what_a_plain_one_loses() {
        let mut plain = 1.0_f64;
        let mut compensated = [1.0_f64, 0.0];
        for _ in 0..1_000_000 {
            Slot::add(&mut plain, 1e-17);
            Slot::<f64>::add(&mut compensated, 1e-17);
        }
        let [value, _] = compensated;
        assert_eq!(plain, 1.0, "each addend is below half an ulp of one");
        // The exact sum is 1 + 1e-11; one rounding to f64 leaves at most half an ulp of one.
        assert!((value - (1.0 + 1e-11)).abs() <= f64::EPSILON, "{compensated:?}");
    }
}
