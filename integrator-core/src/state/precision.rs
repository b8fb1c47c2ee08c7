//! The precision of a state: the scalars that its leaf type is computed in, and the storage of a coordinate between
//! updates.

use crate::scalar::{
    double_double::DoubleDouble,
    exact::fast_two_sum,
    fma::{Avx512, Fused},
    real::Real,
    simd::block::{Block, WIDEST},
};
use core::fmt::Debug;

/// The storage of a coordinate that is computed in `R`.
pub trait Slot<R: Real>: Copy + Send + Sync + 'static {
    /// The block of consecutive coordinates that are computed at once.
    type Wide: Block<R>;

    /// An empty slot, to be filled.
    fn zero() -> Self;
    /// The number that flows read.
    fn value(self) -> R;
    /// Adds `d`.
    fn add(&mut self, d: R);
    /// Adds `a * b`.
    fn fma(&mut self, a: R, b: R);
    /// `a` in the lanes of `mask`, `b` in the others.
    fn select(mask: R::Mask, a: Self, b: Self) -> Self;

    /// Reads a block of slots.
    #[inline(always)]
    fn read<B: Block<R>>(from: &[Self]) -> B {
        let from = &from[..B::WIDTH];
        let mut numbers = [from[0].value(); WIDEST];
        for index in 1..B::WIDTH {
            numbers[index] = from[index].value();
        }
        B::read(&numbers)
    }
    /// Adds `a * b` to a block of slots.
    #[inline(always)]
    fn update<B: Block<R>>(to: &mut [Self], a: R, b: B) {
        let mut numbers = [a; WIDEST];
        b.write(&mut numbers);
        for (slot, b) in to[..B::WIDTH].iter_mut().zip(numbers) {
            slot.fma(a, b);
        }
    }
}

impl<R: Real> Slot<R> for R {
    type Wide = R::Block;

    #[inline(always)]
    fn zero() -> R {
        R::of(0.0)
    }
    #[inline(always)]
    fn value(self) -> R {
        self
    }
    #[inline(always)]
    fn add(&mut self, d: R) {
        *self += d;
    }
    #[inline(always)]
    fn fma(&mut self, a: R, b: R) {
        *self = a.fma(b, *self);
    }
    #[inline(always)]
    fn select(mask: R::Mask, a: R, b: R) -> R {
        R::select(mask, a, b)
    }
    #[inline(always)]
    fn read<B: Block<R>>(from: &[Self]) -> B {
        B::read(from)
    }
    #[inline(always)]
    fn update<B: Block<R>>(to: &mut [Self], a: R, b: B) {
        B::splat(a).fma(b, B::read(to)).write(to);
    }
}

/// The leaf type of a state: `f64`, `f32`, [`Compensated`] or [`Fixed`](crate::Fixed). It decides the precision of a
/// run.
pub trait Precision: Copy + Debug + PartialEq + Default + Send + Sync + 'static {
    /// The scalar of flows on every machine.
    type Plain: Real;
    /// The scalar of flows where the machine has fused multiply-add.
    type Fused: Real;
    /// The scalar of flows where the machine has AVX-512 and the system gains from it.
    type Avx512: Real;
    /// The storage of a coordinate.
    type Slot<R: Real>: Slot<R>;
    /// The scalar of energies: the same on every machine, and compiled once.
    type Energy: Real;

    /// Its name in checkpoints.
    const NAME: &'static str;
    /// The number of `f64` that it is made of.
    const PARTS: usize = 1;
    /// The spacing of its values just above one.
    const EPSILON: f64;
    /// Whether every update can be undone exactly, for which the composition has to be symmetric.
    const REVERSIBLE: bool = false;
    /// Whether it carries the rounding errors of its updates.
    const COMPENSATED: bool = false;

    /// Fills a slot from one leaf per lane.
    fn pack<R: Real>(of_lane: &dyn Fn(usize) -> Self) -> Self::Slot<R>;
    /// One lane of a slot.
    fn unpack<R: Real>(slot: Self::Slot<R>, lane: usize) -> Self;
    /// The value, without the rounding errors that compensation carries.
    fn to_f64(self) -> f64;
    /// The numbers that it is made of: the first [`Precision::PARTS`] of these.
    fn parts(self) -> [f64; 2] {
        [self.to_f64(), 0.0]
    }
    /// The leaf made of these.
    fn from_parts(parts: [f64; 2]) -> Self;
    /// The spacing of its values where it is the same everywhere.
    fn spacing(self) -> Option<f64> {
        None
    }
    /// The bound that its values stay below, in absolute value.
    fn limit(self) -> f64 {
        f64::INFINITY
    }
}

macro_rules! plain_precision {
    ($($scalar:ty)*) => {$(
        impl Precision for $scalar {
            type Plain = $scalar;
            type Fused = Fused<$scalar>;
            type Avx512 = Fused<$scalar, Avx512>;
            type Slot<R: Real> = R;
            type Energy = $scalar;

            const NAME: &'static str = stringify!($scalar);
            const EPSILON: f64 = <$scalar>::EPSILON as f64;

            #[inline(always)]
            fn pack<R: Real>(of_lane: &dyn Fn(usize) -> Self) -> R {
                R::state(&|lane| f64::from(of_lane(lane)))
            }
            #[inline(always)]
            fn unpack<R: Real>(slot: R, lane: usize) -> Self {
                slot.lane(lane) as $scalar
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            fn from_parts([value, _]: [f64; 2]) -> Self {
                value as $scalar
            }
        }
    )*};
}
plain_precision! { f64 f32 }

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
