//! One text for all vectors: a type and its arithmetic from a table of instructions.

/// The functions that are one instruction, and the others, lane by lane.
macro_rules! unary {
    (sqrt $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($sqrt($x.0)))
    };
    (abs $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($andnot($splat(-0.0), $x.0)))
    };
    (floor $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($to_whole::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>($x.0)))
    };
    (ceil $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($to_whole::<{ _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC }>($x.0)))
    };
    (trunc $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($to_whole::<{ _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC }>($x.0)))
    };
    (round_ties_even $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        $vector(instruction!($to_whole::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>($x.0)))
    };
    // Halves away from zero: the largest number below a half, with the sign of the other one, is added before that is cut
    // off. A half itself would round 0.49999999999999994 up to one.
    (round $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {{
        let sign = instruction!($andnot($splat($scalar::from_bits(!(-0.0 as $scalar).to_bits())), $x.0));
        let half = instruction!($xor(sign, $splat(0.5 - $scalar::EPSILON / 4.0)));
        ($x + $vector(half)).trunc()
    }};
    ($function:ident $x:expr, $vector:ident of $scalar:ident, $sqrt:ident $andnot:ident $splat:ident $xor:ident $to_whole:ident) => {
        crate::scalar::functions::kernel!($function $x; $vector::of_lanes($x.lanes().map(<$scalar as Elementary>::$function)))
    };
}
pub(super) use unary;

/// Declares a vector, computes with it, and makes it the block of its scalar.
macro_rules! vector {
    (
        $(#[$documentation:meta])*
        $vector:ident: $lanes:literal of $scalar:ident in $register:ident, masked by $mask:ident,
        of the instructions $set:ident;
        load $load:ident, store $store:ident, splat $splat:ident,
        add $add:ident, sub $sub:ident, mul $mul:ident, div $div:ident,
        fma $fma:ident, sqrt $sqrt:ident, xor $xor:ident, andnot $andnot:ident, to whole numbers $to_whole:ident,
        compare $compare:ident, select |$of:ident, $a:ident, $b:ident| $select:expr,
        after |$low:ident, $high:ident| $after:expr, before |$lower:ident, $higher:ident| $before:expr,
        deinterleave |$one:ident, $two:ident| $deinterleave:expr,
        interleave |$evens:ident, $odds:ident| $interleave:expr,
        pick $pick:path;
        $(quotients $div_sqrt:path, $div_pow_3_2:path;)?
        unary: $($unary:ident)*; binary: $($binary:ident)*;
    ) => {
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug)]
        pub struct $vector(pub(super) $register);

        const _: () = {
            use super::real::unary;
            use crate::scalar::{
                elementary::Elementary,
                fma::{Fused, Instructions},
                functions::{elementary_functions, fast_kernels},
                real::{Kernel, Real},
                simd::{
                    block::{Block, PICKED},
                    lanes::Lanes,
                },
            };
            use core::{
                arch::x86_64::{
                    _CMP_EQ_OQ, _CMP_LE_OQ, _CMP_LT_OQ, _MM_FROUND_NO_EXC, _MM_FROUND_TO_NEAREST_INT, _MM_FROUND_TO_NEG_INF, _MM_FROUND_TO_POS_INF,
                    _MM_FROUND_TO_ZERO,
                },
                ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign},
            };

            impl $vector {
                #[inline(always)]
                pub(super) fn lanes(self) -> [$scalar; $lanes] {
                    // No instruction, which is a call where the instruction set is not that of the function around it.
                    // SAFETY: both are as many numbers, and any bits are some.
                    unsafe { core::mem::transmute::<$register, [$scalar; $lanes]>(self.0) }
                }
                #[inline(always)]
                pub(super) fn of_lanes(lanes: [$scalar; $lanes]) -> Self {
                    // SAFETY: as in `lanes`.
                    Self(unsafe { core::mem::transmute::<[$scalar; $lanes], $register>(lanes) })
                }
                /// Reads the first numbers of a slice.
                #[inline(always)]
                pub(super) fn load<S>(from: &[Fused<$scalar, S>]) -> Self {
                    let from = &from[..$lanes];
                    // SAFETY: the slice has a number for every lane, and `Fused` is transparent; for the instruction set as in
                    // `instruction!`.
                    Self(unsafe { $load(from.as_ptr().cast()) })
                }
                /// Writes the first numbers of a slice.
                #[inline(always)]
                pub(super) fn store<S>(self, to: &mut [Fused<$scalar, S>]) {
                    let to = &mut to[..$lanes];
                    // SAFETY: as in `load`.
                    unsafe { $store(to.as_mut_ptr().cast(), self.0) };
                }
            }

            vector!(operators $vector: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

            impl Neg for $vector {
                type Output = Self;
                #[inline(always)]
                fn neg(self) -> Self {
                    Self(instruction!($xor(self.0, $splat(-0.0))))
                }
            }
            impl AddAssign for $vector {
                #[inline(always)]
                fn add_assign(&mut self, other: Self) {
                    *self = *self + other;
                }
            }
            impl SubAssign for $vector {
                #[inline(always)]
                fn sub_assign(&mut self, other: Self) {
                    *self = *self - other;
                }
            }

            impl Real for $vector {
                const LANES: usize = $lanes;
                const BEYOND_BASELINE: bool = true;
                type Mask = $mask;
                type Block = Self;
                type Row<const N: usize> = Lanes<Self, N>;
                type Wide = Self;
                type Bundle = Self;
                type Pair = Lanes<Self, 2>;

                #[inline(always)]
                fn of(x: f64) -> Self {
                    Self(instruction!($splat(x as $scalar)))
                }
                #[inline(always)]
                fn lane(self, lane: usize) -> f64 {
                    f64::from(self.lanes()[lane])
                }
                #[inline(always)]
                fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
                    Self::state(of_lane)
                }
                #[inline(always)]
                fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
                    let mut lanes: [$scalar; $lanes] = [0.0; $lanes];
                    for (lane, number) in lanes.iter_mut().enumerate() {
                        *number = of_lane(lane) as $scalar;
                    }
                    Self::of_lanes(lanes)
                }
                #[inline(always)]
                fn fma(self, b: Self, c: Self) -> Self {
                    Self(instruction!($fma(self.0, b.0, c.0)))
                }
                $(
                    #[inline(always)]
                    fn div_sqrt(self, x: Self) -> Self {
                        $div_sqrt(self, x)
                    }
                    #[inline(always)]
                    fn div_pow_3_2(self, x: Self) -> Self {
                        $div_pow_3_2(self, x)
                    }
                )?
                #[inline(always)]
                fn sin_cos(self) -> (Self, Self) {
                    crate::scalar::functions::sin_cos(self)
                }
                elementary_functions!(fast ones of fast_kernels!);
                #[inline(always)]
                fn finite(self) -> bool {
                    // x - x is zero for a finite x and NaN for others.
                    !(self - self).equal(Self::of(0.0)).not().any()
                }
                #[inline(always)]
                fn less(self, other: Self) -> $mask {
                    $mask(instruction!($compare::<_CMP_LT_OQ>(self.0, other.0)))
                }
                #[inline(always)]
                fn less_or_equal(self, other: Self) -> $mask {
                    $mask(instruction!($compare::<_CMP_LE_OQ>(self.0, other.0)))
                }
                #[inline(always)]
                fn equal(self, other: Self) -> $mask {
                    $mask(instruction!($compare::<_CMP_EQ_OQ>(self.0, other.0)))
                }
                #[inline(always)]
                fn select($mask($of): $mask, Self($a): Self, Self($b): Self) -> Self {
                    Self(instruction!($select))
                }
                $(
                    #[inline(always)]
                    fn $unary(self) -> Self {
                        unary!($unary self, $vector of $scalar, $sqrt $andnot $splat $xor $to_whole)
                    }
                )*
                $(
                    #[inline(always)]
                    fn $binary(self, other: Self) -> Self {
                        crate::scalar::functions::kernel!($binary self, other; {
                            let (mut a, b) = (self.lanes(), other.lanes());
                            for lane in 0..a.len() {
                                a[lane] = <$scalar as Elementary>::$binary(a[lane], b[lane]);
                            }
                            Self::of_lanes(a)
                        })
                    }
                )*
                #[inline(always)]
                fn enter<K: Kernel>(kernel: K) -> K::Out {
                    $set::enter(kernel)
                }
            }

            impl Block<Fused<$scalar, $set>> for $vector {
                const WIDTH: usize = $lanes;

                #[inline(always)]
                fn read(from: &[Fused<$scalar, $set>]) -> Self {
                    Self::load(from)
                }
                #[inline(always)]
                fn write(self, to: &mut [Fused<$scalar, $set>]) {
                    self.store(to);
                }
                #[inline(always)]
                fn splat(x: Fused<$scalar, $set>) -> Self {
                    Self(instruction!($splat(x.0)))
                }
                #[inline(always)]
                fn less_bits(self, other: Self) -> u64 {
                    self.less(other).bits()
                }
                #[inline(always)]
                fn pick(words: &[u32; PICKED], bits: u64, to: &mut [u32; PICKED]) -> usize {
                    $pick(words, bits, to)
                }
                #[inline(always)]
                fn after(self, next: Self) -> Self {
                    let ($low, $high) = (self.0, next.0);
                    Self(instruction!($after))
                }
                #[inline(always)]
                fn before(self, previous: Self) -> Self {
                    let ($lower, $higher) = (previous.0, self.0);
                    Self(instruction!($before))
                }
                #[inline(always)]
                fn deinterleave(self, next: Self) -> [Self; 2] {
                    let ($one, $two) = (self.0, next.0);
                    let [first, second] = instruction!($deinterleave);
                    [Self(first), Self(second)]
                }
                #[inline(always)]
                fn interleave(self, odd: Self) -> [Self; 2] {
                    let ($evens, $odds) = (self.0, odd.0);
                    let [first, second] = instruction!($interleave);
                    [Self(first), Self(second)]
                }
            }
        };
    };
    (operators $vector:ident: $($trait:ident $method:ident $instruction:ident),*) => {$(
        impl $trait for $vector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(instruction!($instruction(self.0, other.0)))
            }
        }
    )*};
}
pub(super) use vector;
