//! Operations on the bits of numbers, lane by lane, which kernels need beside arithmetic.

use crate::scalar::{
    fma::{Fused, Instructions},
    real::Real,
};

/// A scalar or vector whose bits a kernel may handle.
///
/// One text of a kernel serves scalars and vectors, so that every lane has the bits of the scalar.
pub(crate) trait Bits: Real {
    /// `f64` or `f32`.
    type Scalar: Real;

    /// Whether `fma` rounds once: then the error of a product is one operation away.
    const FUSED: bool;

    /// The number that has this pattern, in every lane; of a single the lower half of the pattern.
    fn pattern(bits: u64) -> Self;
    /// The bits that are set in both.
    fn bits_and(self, other: Self) -> Self;
    /// The bits that are set in one of them.
    fn bits_xor(self, other: Self) -> Self;
    /// The sum of the patterns as integers, without the carry beyond a lane.
    fn bits_add(self, other: Self) -> Self;
    /// The patterns shifted left, towards the sign.
    fn bits_left(self, by: u32) -> Self;
    /// The patterns shifted right, with zeros shifted in at the sign.
    fn bits_right(self, by: u32) -> Self;
    /// Whether the last bit of the pattern is set.
    fn is_odd(self) -> Self::Mask;

    /// Maps the lanes, with those of `other`, by a function of scalars.
    fn zip_scalars(self, other: Self, each: impl Fn(&mut [Self::Scalar], &[Self::Scalar])) -> Self;
    /// Maps the lanes by a function of scalars.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn map_scalars(self, each: impl Fn(&mut [Self::Scalar])) -> Self {
        self.zip_scalars(self, |lanes, _| each(lanes))
    }
}

macro_rules! scalar_bits {
    ($scalar:ident $word:ident $fused:literal: [$($generics:tt)*] $type:ty, $new:expr, |$x:ident| $number:expr) => {
        impl<$($generics)*> Bits for $type {
            type Scalar = $scalar;

            const FUSED: bool = $fused;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn pattern(bits: u64) -> Self {
                $new($scalar::from_bits(bits as $word))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits_and(self, other: Self) -> Self {
                let (a, b) = ({ let $x = self; $number }, { let $x = other; $number });
                $new($scalar::from_bits(a.to_bits() & b.to_bits()))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits_xor(self, other: Self) -> Self {
                let (a, b) = ({ let $x = self; $number }, { let $x = other; $number });
                $new($scalar::from_bits(a.to_bits() ^ b.to_bits()))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits_add(self, other: Self) -> Self {
                let (a, b) = ({ let $x = self; $number }, { let $x = other; $number });
                $new($scalar::from_bits(a.to_bits().wrapping_add(b.to_bits())))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits_left(self, by: u32) -> Self {
                let $x = self;
                $new($scalar::from_bits($number.to_bits() << by))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits_right(self, by: u32) -> Self {
                let $x = self;
                $new($scalar::from_bits($number.to_bits() >> by))
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_odd(self) -> bool {
                let $x = self;
                $number.to_bits() & 1 == 1
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn zip_scalars(self, other: Self, each: impl Fn(&mut [$scalar], &[$scalar])) -> Self {
                let (mut lane, other) = ([{ let $x = self; $number }], [{ let $x = other; $number }]);
                each(&mut lane, &other);
                $new(lane[0])
            }
        }
    };
}
scalar_bits!(f64 u64 false: [] f64, core::convert::identity, |x| x);
scalar_bits!(f32 u32 false: [] f32, core::convert::identity, |x| x);
scalar_bits!(f64 u64 true: [S: Instructions] Fused<f64, S>, Self::new, |x| x.0);
scalar_bits!(f32 u32 true: [S: Instructions] Fused<f32, S>, Self::new, |x| x.0);
