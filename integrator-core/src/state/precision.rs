//! The precision of a state: the scalars that its leaf type is computed in, and the storage of a coordinate between
//! updates.

use crate::scalar::{
    fma::{Avx512, Fused, Instructions},
    real::Real,
    simd::block::{Block, WIDEST},
};
use core::fmt::Debug;

/// The storage of a coordinate that is computed in `R`.
pub trait Slot<R: Real>: Copy + Send + Sync + 'static {
    /// The block of consecutive coordinates that are computed together.
    type Wide: Block<R>;

    /// An empty slot, to be filled.
    fn zero() -> Self;
    /// The number that flows read.
    fn value(self) -> R;
    /// Adds `d`.
    fn add(&mut self, d: R);
    /// Adds `a * b`.
    fn fma(&mut self, a: R, b: R);
    /// Adds `a * b`, where `a` is a number of the step or of parameters.
    #[inline(always)]
    fn scale_add(&mut self, a: R, b: R) {
        self.fma(a, b);
    }
    /// `a` in the lanes of `mask`, `b` in the others.
    fn select(mask: R::Mask, a: Self, b: Self) -> Self;
    /// The number that flows read, and the rounding error that it carries, where it carries one.
    #[inline(always)]
    fn parts(self) -> [R; 2] {
        [self.value(), R::of(0.0)]
    }
    /// The slot of a number and of the rounding error that it carries; of the number alone where slots carry none.
    #[inline(always)]
    fn of_parts([value, _]: [R; 2]) -> Self {
        let mut slot = Self::zero();
        slot.add(value);
        slot
    }

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
    /// Adds `a * b` to a block of slots; `a` is constant along all directions.
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
    fn scale_add(&mut self, a: R, b: R) {
        *self = a.scale_add(b, *self);
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
        b.add_multiple(a, to);
    }
}

/// The leaf type of a state: `f64`, `f32`, [`Compensated`](crate::Compensated) or [`Fixed`](crate::Fixed). It decides the precision of a
/// run.
#[diagnostic::on_unimplemented(
    message = "coordinates have to be of type `f64` or `f32`, and these are `{Self}`",
    label = "not in `f64` or `f32`",
    note = "write `1.0` in place of `1`"
)]
pub trait Precision: Copy + Debug + PartialEq + Default + Send + Sync + 'static {
    /// The scalar of flows on every machine.
    type Plain: Real;
    /// The scalar of flows where the machine has fused multiply-add.
    type Fused: Real;
    /// The scalar of flows where the machine has AVX-512 and the system gains from it.
    type Avx512: Real;
    /// The storage of a coordinate.
    type Slot<R: Real>: Slot<R>;
    /// The scalar of invariants, and of energies without sums in lanes: the same on every machine, and compiled once.
    type Energy: Real;
    /// The scalar of energies whose sums are in lanes.
    type EnergyIn<S: Instructions>: Real;

    /// The name of the scalar type in checkpoints.
    const NAME: &'static str;
    /// The number of `f64` that it is made of.
    const PARTS: usize = 1;
    /// The spacing of its values just above one.
    const EPSILON: f64;
    /// Whether every update can be undone exactly, for which the composition has to be symmetric.
    const REVERSIBLE: bool = false;
    /// Whether the scalar type carries the rounding errors of its updates.
    const COMPENSATED: bool = false;
    /// Whether a slot is the number alone, without a carried error or a grid.
    const PLAIN: bool = !Self::COMPENSATED && !Self::REVERSIBLE;

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
            type EnergyIn<S: Instructions> = Fused<$scalar, S>;

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
