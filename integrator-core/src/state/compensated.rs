//! Compensated coordinates: numbers that carry the rounding errors of their updates (Kahan 1965).

use crate::{
    scalar::{
        double_double::DoubleDouble,
        exact::fast_two_sum,
        fma::{Avx512, Fused},
        real::Real,
    },
    state::precision::{Precision, Slot},
};

/// A number together with the rounding error that its updates have left behind.
///
/// Every update adds the carried error first and carries the rounding error of the addition (Kahan 1965), so that the
/// error of a long sum stays at the rounding of one addition. Made by
/// [`Phase::compensated`](crate::Phase::compensated).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compensated<F> {
    /// The number.
    pub value: F,
    /// The rounding error that is still to be added to it, below half a unit in its last place.
    pub carried: F,
}

/// The number with what it carries, rounded.
impl From<Compensated<f64>> for f64 {
    fn from(number: Compensated<f64>) -> Self {
        number.value + number.carried
    }
}

impl<R: Real> Slot<R> for Compensated<R> {
    /// A number and its carried error alternate in memory, so that coordinates are not contiguous.
    type Wide = R;

    #[inline(always)]
    fn zero() -> Self {
        Self { value: R::of(0.0), carried: R::of(0.0) }
    }
    #[inline(always)]
    fn value(self) -> R {
        self.value
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        [self.value, self.carried] = fast_two_sum(self.value, d + self.carried);
    }
    #[inline(always)]
    fn fma(&mut self, a: R, b: R) {
        [self.value, self.carried] = fast_two_sum(self.value, a.fma(b, self.carried));
    }
    #[inline(always)]
    fn select(mask: R::Mask, a: Self, b: Self) -> Self {
        Self { value: R::select(mask, a.value, b.value), carried: R::select(mask, a.carried, b.carried) }
    }
}

impl Precision for Compensated<f64> {
    type Plain = f64;
    type Fused = Fused<f64>;
    type Avx512 = Fused<f64, Avx512>;
    type Slot<R: Real> = Compensated<R>;
    type Energy = DoubleDouble;

    const NAME: &'static str = "compensated f64";
    const PARTS: usize = 2;
    const EPSILON: f64 = f64::EPSILON;
    const COMPENSATED: bool = true;

    #[inline(always)]
    fn pack<R: Real>(of_lane: &dyn Fn(usize) -> Self) -> Compensated<R> {
        Compensated { value: R::state(&|lane| of_lane(lane).value), carried: R::state(&|lane| of_lane(lane).carried) }
    }
    #[inline(always)]
    fn unpack<R: Real>(slot: Compensated<R>, lane: usize) -> Self {
        Self { value: slot.value.lane(lane), carried: slot.carried.lane(lane) }
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
        let mut compensated = Compensated { value: 1.0_f64, carried: 0.0 };
        for _ in 0..1_000_000 {
            Slot::add(&mut plain, 1e-17);
            Slot::<f64>::add(&mut compensated, 1e-17);
        }
        assert_eq!(plain, 1.0, "each addend is below half an ulp of one");
        // The exact sum is 1 + 1e-11; one rounding to f64 leaves at most half an ulp of one.
        assert!((compensated.value - (1.0 + 1e-11)).abs() <= f64::EPSILON, "{compensated:?}");
    }
}
