//! Vectors of numbers with `std::arch`: the arithmetic of the hand-written steppers.
//!
//! The types of `x86` are named only inside `enter`, after their instructions are detected.

use std::ops::{Add, Div, Mul, Sub};

/// A scalar type of vectors.
pub trait Number: Copy + Send + Sync + Default + PartialOrd + 'static {
    /// Rounds to this precision.
    fn of(x: f64) -> Self;
    /// Converts to `f64`.
    fn widen(self) -> f64;
    /// Returns `self · b + c`, rounded once.
    fn fma(self, b: Self, c: Self) -> Self;
    /// Returns the square root.
    fn root(self) -> Self;
    /// Returns the bits, in the low end of 64.
    fn bits(self) -> u64;
    /// Returns the number of these bits.
    fn from_bits(bits: u64) -> Self;
    /// The number of bits.
    const BITS: u32;
    /// The number of stored bits of the mantissa.
    const MANTISSA: u32;
}

macro_rules! number {
    ($scalar:ident, $bits:ident, $width:literal, $mantissa:literal) => {
        impl Number for $scalar {
            const BITS: u32 = $width;
            const MANTISSA: u32 = $mantissa;

            #[inline(always)]
            fn of(x: f64) -> Self {
                x as $scalar
            }
            #[inline(always)]
            fn widen(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            #[inline(always)]
            fn from_bits(bits: u64) -> Self {
                $scalar::from_bits(bits as $bits)
            }
        }
    };
}
number!(f64, u64, 64, 52);
number!(f32, u32, 32, 23);

/// A vector of several numbers.
pub trait Vector: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// The type of a lane.
    type Number: Number;
    /// The number of lanes.
    const LANES: usize;

    /// Returns a vector that has this number in each lane.
    fn splat(x: f64) -> Self;
    /// Loads the first `LANES` numbers.
    fn load(from: &[Self::Number]) -> Self;
    /// Stores into the first `LANES` numbers.
    fn store(self, to: &mut [Self::Number]);
    /// `self * b + c`
    fn fma(self, b: Self, c: Self) -> Self;
    /// `c - self * b`
    fn fnma(self, b: Self, c: Self) -> Self;
    /// Returns the square roots.
    fn sqrt(self) -> Self;
    /// Returns `numerator` divided by the third power of the square root of `self`, up to the last bit or two.
    fn over_cube(self, numerator: Self) -> Self;
    /// Returns `odd` in the lanes where the lowest bit of `of` is set, `even` in the others.
    fn choose(of: Self, odd: Self, even: Self) -> Self;
    /// Negates the lanes where bit `BIT` of `of` is set.
    fn negate<const BIT: u32>(self, of: Self) -> Self;
    /// Multiplies by two to the power of the integer in the lowest bits of `of`; neither may be extreme.
    fn scale(self, of: Self) -> Self;
    /// Returns `self` in the lanes where `x < y`, zero in the others.
    fn where_less(self, x: Self, y: Self) -> Self;
    /// Returns whether `x < y` in at least one lane.
    fn any_less(x: Self, y: Self) -> bool;
}

/// Vectors of `f64` with permutations of lanes.
pub trait Row: Vector<Number = f64> {
    /// Rotates the first `N` lanes by `BY` lanes towards the front.
    fn rotate<const BY: usize, const N: usize>(self) -> Self;
    /// Rotates all lanes by one towards the front.
    #[inline(always)]
    fn rotate_by_one(self) -> Self {
        self.after(self)
    }
    /// Returns the lanes from 1 on, followed by the first lane of `next`.
    fn after(self, next: Self) -> Self;
    /// Returns the last lane of `previous`, followed by all lanes but the last.
    fn before(self, previous: Self) -> Self;
    /// Selects lanes by index from `self` followed by `more`.
    fn pick(self, more: Self, lanes: &[i64; 8]) -> Self;
    /// Returns the larger absolute value in every lane.
    fn larger(self, other: Self) -> Self;
    /// Returns the largest absolute value of all lanes.
    fn largest(self) -> f64;
}

/// Two doubles.
pub(crate) trait Two: Vector<Number = f64> {
    fn of(first: f64, second: f64) -> Self;
    fn first(self) -> f64;
    /// Swaps the two lanes.
    fn swap(self) -> Self;
    /// Repeats the first lane.
    fn firsts(self) -> Self;
    /// Repeats the second lane.
    fn seconds(self) -> Self;
    /// Negates the second lane.
    fn conjugate(self) -> Self;
}

/// Numbers in an array: scalars (`N = 1`), and vectors on machines without the instructions of the other types.
#[derive(Clone, Copy)]
pub struct Many<T, const N: usize>(
    /// The lanes.
    pub [T; N],
);

impl<T: Number, const N: usize> Many<T, N> {
    #[inline(always)]
    fn zip(self, other: Self, of: impl Fn(T, T) -> T) -> Self {
        Self(std::array::from_fn(|lane| of(self.0[lane], other.0[lane])))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl<T: Number + $trait<Output = T>, const N: usize> $trait for Many<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, T::$method)
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl<T, const N: usize> Vector for Many<T, N>
where
    T: Number + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    type Number = T;
    const LANES: usize = N;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([T::of(x); N])
    }
    #[inline(always)]
    fn load(from: &[T]) -> Self {
        let from = &from[..N];
        Self(std::array::from_fn(|lane| from[lane]))
    }
    #[inline(always)]
    fn store(self, to: &mut [T]) {
        to[..N].copy_from_slice(&self.0);
    }
    #[inline(always)]
    fn fma(self, b: Self, c: Self) -> Self {
        Self(std::array::from_fn(|lane| self.0[lane].fma(b.0[lane], c.0[lane])))
    }
    #[inline(always)]
    fn fnma(self, b: Self, c: Self) -> Self {
        (Self::splat(-1.0) * self).fma(b, c)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(T::root))
    }
    #[inline(always)]
    fn over_cube(self, numerator: Self) -> Self {
        numerator / (self * self.sqrt())
    }
    #[inline(always)]
    fn choose(of: Self, odd: Self, even: Self) -> Self {
        Self(std::array::from_fn(|lane| if of.0[lane].bits() & 1 == 1 { odd.0[lane] } else { even.0[lane] }))
    }
    #[inline(always)]
    fn negate<const BIT: u32>(self, of: Self) -> Self {
        let sign = 1 << (T::BITS - 1);
        self.zip(of, |x, of| T::from_bits(x.bits() ^ (of.bits() << (T::BITS - 1 - BIT) & sign)))
    }
    #[inline(always)]
    fn scale(self, of: Self) -> Self {
        self.zip(of, |x, of| T::from_bits(x.bits().wrapping_add(of.bits() << T::MANTISSA)))
    }
    #[inline(always)]
    fn where_less(self, x: Self, y: Self) -> Self {
        Self(std::array::from_fn(|lane| if x.0[lane] < y.0[lane] { self.0[lane] } else { T::of(0.0) }))
    }
    #[inline(always)]
    fn any_less(x: Self, y: Self) -> bool {
        x.0.iter().zip(&y.0).any(|(x, y)| x < y)
    }
}

impl<const N: usize> Row for Many<f64, N> {
    #[inline(always)]
    fn rotate<const BY: usize, const RING: usize>(self) -> Self {
        Self(std::array::from_fn(|lane| if lane < RING { self.0[(lane + BY) % RING] } else { self.0[lane] }))
    }
    #[inline(always)]
    fn after(self, next: Self) -> Self {
        Self(std::array::from_fn(|lane| if lane + 1 < N { self.0[lane + 1] } else { next.0[0] }))
    }
    #[inline(always)]
    fn before(self, previous: Self) -> Self {
        Self(std::array::from_fn(|lane| if lane > 0 { self.0[lane - 1] } else { previous.0[N - 1] }))
    }
    #[inline(always)]
    fn pick(self, more: Self, lanes: &[i64; 8]) -> Self {
        let of = |lane: usize| if lane < N { self.0[lane] } else { more.0[lane % N] };
        Self(std::array::from_fn(|lane| of(lanes[lane % 8] as usize)))
    }
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.zip(other, |x, y| x.abs().max(y.abs()))
    }
    #[inline(always)]
    fn largest(self) -> f64 {
        self.0.iter().fold(0.0, |largest, x| largest.max(x.abs()))
    }
}

impl Two for Many<f64, 2> {
    #[inline(always)]
    fn of(first: f64, second: f64) -> Self {
        Self([first, second])
    }
    #[inline(always)]
    fn first(self) -> f64 {
        self.0[0]
    }
    #[inline(always)]
    fn swap(self) -> Self {
        Self([self.0[1], self.0[0]])
    }
    #[inline(always)]
    fn firsts(self) -> Self {
        Self([self.0[0]; 2])
    }
    #[inline(always)]
    fn seconds(self) -> Self {
        Self([self.0[1]; 2])
    }
    #[inline(always)]
    fn conjugate(self) -> Self {
        Self([self.0[0], -self.0[1]])
    }
}
