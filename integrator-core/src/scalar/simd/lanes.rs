//! Lanes: a vector of members of an ensemble. Every operation is the scalar's own, lane by lane.
//!
//! So a member's bits do not depend on its neighbours, nor on whether it has any; the compiler puts the lanes into the
//! vector registers of the instruction set that the scalar is made for.

use crate::scalar::{
    functions::elementary_functions,
    real::{Kernel, Mask, Real},
};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `N` scalars, or `N` vectors of the same number of lanes each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<F, const N: usize>([F; N]);

/// Calls a function with each number below `N`. Up to four calls are written out, since a loop for every operation is what
/// the compiler would spend most of its time on.
#[inline(always)]
fn each<const N: usize>(mut of: impl FnMut(usize)) {
    if N > 4 {
        for part in 0..N {
            of(part);
        }
    } else {
        if N > 0 {
            of(0);
        }
        if N > 1 {
            of(1);
        }
        if N > 2 {
            of(2);
        }
        if N > 3 {
            of(3);
        }
    }
}

impl<F: Copy, const N: usize> Lanes<F, N> {
    /// The vector of these parts.
    #[inline(always)]
    pub(crate) fn of_parts(parts: [F; N]) -> Self {
        Self(parts)
    }
    /// Returns a part of the vector.
    #[inline(always)]
    pub(crate) fn part(self, part: usize) -> F {
        self.0[part]
    }
    /// Sets a part of the vector.
    #[inline(always)]
    pub(crate) fn set_part(&mut self, part: usize, number: F) {
        self.0[part] = number;
    }
    #[inline(always)]
    fn map(self, of: impl Fn(F) -> F) -> Self {
        let Self(mut parts) = self;
        each::<N>(|part| parts[part] = of(parts[part]));
        Self(parts)
    }
    #[inline(always)]
    fn zip(self, other: Self, of: impl Fn(F, F) -> F) -> Self {
        let (Self(mut parts), Self(others)) = (self, other);
        each::<N>(|part| parts[part] = of(parts[part], others[part]));
        Self(parts)
    }
}

impl<F: Real, const N: usize> Lanes<F, N> {
    #[inline(always)]
    fn compare(self, other: Self, holds: impl Fn(F, F) -> F::Mask) -> LaneMask<F::Mask, N> {
        let (Self(parts), Self(others), mut mask) = (self, other, [F::Mask::of(false); N]);
        each::<N>(|part| mask[part] = holds(parts[part], others[part]));
        LaneMask(mask)
    }
}

/// The mask of the lanes in which a condition holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaneMask<M, const N: usize>([M; N]);

impl<M: Mask, const N: usize> LaneMask<M, N> {
    #[inline(always)]
    fn zip(self, other: Self, of: impl Fn(M, M) -> M) -> Self {
        let (Self(mut lanes), Self(others)) = (self, other);
        each::<N>(|lane| lanes[lane] = of(lanes[lane], others[lane]));
        Self(lanes)
    }
}

impl<M: Mask, const N: usize> Mask for LaneMask<M, N> {
    #[inline(always)]
    fn of(holds: bool) -> Self {
        Self([M::of(holds); N])
    }
    #[inline(always)]
    fn any(self) -> bool {
        let mut any = false;
        each::<N>(|lane| any |= self.0[lane].any());
        any
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, M::and)
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.zip(other, M::or)
    }
    #[inline(always)]
    fn not(self) -> Self {
        self.zip(self, |lane, _| lane.not())
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl<F: Real, const N: usize> $trait for Lanes<F, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, F::$method)
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl<F: Real, const N: usize> Neg for Lanes<F, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(F::neg)
    }
}
impl<F: Real, const N: usize> AddAssign for Lanes<F, N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<F: Real, const N: usize> SubAssign for Lanes<F, N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

macro_rules! fast_lanes {
    (unary: $($unary:ident $precise:ident)*; binary: $($binary:ident $other:ident)*;) => {
        $(in_turn!($unary());)*
        $(in_turn!($binary(other));)*
    };
}

/// A function of each lane in a loop without closures: a closure that contains an elementary function is too large to be inlined
/// where it is called more than once, and outside of a function with the features of an instruction set, each of its instructions
/// is a call.
macro_rules! in_turn {
    ($function:ident($($other:ident)?)) => {
        #[inline(always)]
        fn $function(self $(, $other: Self)?) -> Self {
            let Self(mut parts) = self;
            for part in 0..N {
                parts[part] = parts[part].$function($($other.0[part])?);
            }
            Self(parts)
        }
    };
}

macro_rules! lanes_real {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        impl<F: Real, const N: usize> Real for Lanes<F, N> {
            const LANES: usize = N * F::LANES;
            const BEYOND_BASELINE: bool = F::BEYOND_BASELINE;
            const MEMBERS: usize = N * F::MEMBERS;
            const LANEWISE: bool = F::LANEWISE;
            type Mask = LaneMask<F::Mask, N>;
            type Block = Self;
            type Row<const M: usize> = Lanes<Self, M>;
            type Wide = Self;
            type Bundle = Self;
            type Pair = Lanes<Self, 2>;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self([F::of(x); N])
            }
            #[inline(always)]
            fn lane(self, lane: usize) -> f64 {
                self.0[lane / F::LANES].lane(lane % F::LANES)
            }
            #[inline(always)]
            fn parameter(of_lane: &dyn Fn(usize) -> f64) -> Self {
                let mut parts = [F::of(0.0); N];
                for (number, part) in parts.iter_mut().enumerate() {
                    *part = F::parameter(&|lane| of_lane(number * F::LANES + lane));
                }
                Self(parts)
            }
            #[inline(always)]
            fn state(of_lane: &dyn Fn(usize) -> f64) -> Self {
                let mut parts = [F::of(0.0); N];
                for (number, part) in parts.iter_mut().enumerate() {
                    *part = F::state(&|lane| of_lane(number * F::LANES + lane));
                }
                Self(parts)
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                let Self(mut parts) = self;
                each::<N>(|part| parts[part] = parts[part].fma(b.0[part], c.0[part]));
                Self(parts)
            }
            #[inline]
            fn lane_by_lane<const A: usize>(
                arguments: [Self; A],
                value: impl Fn(usize, [f64; A]) -> f64,
                slopes: impl Fn(usize, [f64; A]) -> [f64; A],
            ) -> Self {
                let mut parts = arguments.first().map_or([F::of(f64::NAN); N], |argument| argument.0);
                for (number, part) in parts.iter_mut().enumerate() {
                    let first = number * F::LANES;
                    let value = |lane: usize, at: [f64; A]| value(first + lane, at);
                    let slopes = |lane: usize, at: [f64; A]| slopes(first + lane, at);
                    let mut own = [*part; A];
                    for argument in 0..A {
                        own[argument] = arguments[argument].0[number];
                    }
                    *part = F::lane_by_lane(own, value, slopes);
                }
                Self(parts)
            }
            in_turn!(div_sqrt(x));
            in_turn!(div_pow_3_2(x));
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (mut sines, mut cosines) = (self, self);
                for part in 0..N {
                    (sines.0[part], cosines.0[part]) = self.0[part].sin_cos();
                }
                (sines, cosines)
            }
            elementary_functions!(fast ones of fast_lanes!);
            #[inline(always)]
            fn finite(self) -> bool {
                let mut finite = true;
                each::<N>(|part| finite = finite && self.0[part].finite());
                finite
            }
            #[inline(always)]
            fn less(self, other: Self) -> Self::Mask {
                self.compare(other, F::less)
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> Self::Mask {
                self.compare(other, F::less_or_equal)
            }
            #[inline(always)]
            fn equal(self, other: Self) -> Self::Mask {
                self.compare(other, F::equal)
            }
            #[inline(always)]
            fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
                let Self(mut parts) = a;
                each::<N>(|part| parts[part] = F::select(mask.0[part], parts[part], b.0[part]));
                Self(parts)
            }
            $(in_turn!($unary());)*
            $(in_turn!($binary(other));)*
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                F::enter(kernel)
            }
        }
    };
}
elementary_functions!(lanes_real! {});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_lane_is_the_scalar() {
        let x = Lanes::<f64, 4>::state(&|lane| 0.3 + lane as f64);
        let y = (x.sin() * x).fma(x.exp(), x.powf(Lanes::of(1.5)));
        for lane in 0..4 {
            let x = 0.3 + lane as f64;
            let expected = Real::fma(Real::sin(x) * x, Real::exp(x), Real::powf(x, 1.5));
            assert_eq!(y.lane(lane).to_bits(), expected.to_bits(), "lane {lane}");
        }
    }

    #[test]
    fn a_mask_chooses_lane_by_lane() {
        let x = Lanes::<f64, 4>::state(&|lane| lane as f64);
        let small = x.less(Lanes::of(2.0));
        let chosen = Lanes::select(small, x, Lanes::of(-1.0));
        assert_eq!([0, 1, 2, 3].map(|lane| chosen.lane(lane)), [0.0, 1.0, -1.0, -1.0]);
        assert!(small.any() && small.not().any() && !small.and(small.not()).any());
    }
}
