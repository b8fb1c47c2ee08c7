//! Logarithms that are read off the bits of numbers.
//!
//! Always true: they are integers, so that what is found from them is the same on every machine, and found soon: sums,
//! differences and multiplications of a few cycles stand for products, quotients and roots.

use super::series::COEFFICIENTS;
use core::ops::{Add, Sub};

/// A logarithm to the base of two within 0.09: exponents exactly, between them along a straight line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Logarithm(i64);

/// The number of a mantissa's last bits that are ignored, so that sums of logarithms fit into 64. The others are: from
/// coarse logarithms follow steps of few lengths, a periodic motion takes the same ones again and again, and its errors
/// add up.
const CUT: u32 = 8;

/// The number of intervals into which a factor of two is divided.
const PARTS: i64 = 1 << (52 - CUT);

/// The exponent of zero, lower than any number's by more than products and roots of numbers make up for.
const NOTHING: i64 = -(1 << 15);

/// The number of binary digits by which reciprocals are shorter than 64; as many of the first ones of a logarithm are
/// free.
const SHORT: u32 = 2;

impl Logarithm {
    /// The logarithm of zero.
    pub(super) const OF_ZERO: Self = Self(NOTHING * PARTS);
    /// The logarithm of infinity.
    pub(super) const OF_INFINITY: Self = Self(1024 * PARTS);

    /// A number of sixteenths.
    pub(super) const fn of_sixteenths(sixteenths: i64) -> Self {
        Self(sixteenths * (PARTS / 16))
    }

    /// The logarithm of a size. For NaN it is not below that of infinity.
    #[inline(always)]
    pub(super) fn of(size: f64) -> Self {
        let bits = size.to_bits();
        if bits == 0 { Self::OF_ZERO } else { Self((bits >> CUT) as i64 - 1023 * PARTS) }
    }

    /// The logarithm of a power of this size.
    pub(super) fn power(self, exponent: usize) -> Self {
        Self(self.0 * exponent as i64)
    }

    /// The logarithm of this size times a power of two.
    #[cfg(test)]
    #[inline(always)]
    pub(super) fn times_power_of_two(self, exponent: i32) -> Self {
        Self(self.0 + i64::from(exponent) * PARTS)
    }

    /// The number with this logarithm; zero or infinity, where it would be beyond all numbers.
    #[inline(always)]
    pub(super) fn number(self) -> f64 {
        let bits = (self.0 + 1023 * PARTS).clamp(0, 2047 * PARTS);
        f64::from_bits((bits as u64) << CUT)
    }

    /// The exponent of the power of two at or below the size.
    #[inline(always)]
    pub(super) fn floor(self) -> i32 {
        (self.0 >> (52 - CUT)) as i32
    }

    /// Converts the logarithm to a floating-point number.
    pub(super) fn value(self) -> f64 {
        self.0 as f64 / PARTS as f64
    }

    /// The logarithm of the `m`-th root: the quotient rounded down, so that a factor of `2ᵐ` doubles the root exactly.
    #[inline(always)]
    pub(super) fn root(self, m: usize) -> Self {
        // The last bit makes up for what reciprocals lack, as long as logarithms are below `2^16 / m`.
        let product = i128::from(self.0 << SHORT | 1) * i128::from(const { reciprocals() }[m]);
        Self((product >> 64) as i64)
    }
}

/// `1/m` for the orders, but for the last digits.
const fn reciprocals() -> [i64; COEFFICIENTS] {
    let mut reciprocals = [0; COEFFICIENTS];
    let mut m = 1;
    while m < COEFFICIENTS {
        reciprocals[m] = (1 << (64 - SHORT)) / m as i64;
        m += 1;
    }
    reciprocals
}

impl Add for Logarithm {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Logarithm {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_near_enough() {
        for exponent in -300..300 {
            for digits in [1.0, 1.3, 1.7, 1.99] {
                let x = digits * 2.0_f64.powi(exponent);
                assert!((Logarithm::of(x).value() - x.log2()).abs() < 0.0861, "{x}");
                // Eight bits are cut off.
                assert!((Logarithm::of(x).number() / x - 1.0).abs() < 256.0 * f64::EPSILON, "{x}");
            }
        }
    }

    #[test]
    fn roots_are_those_of_numbers() {
        for m in 2..COEFFICIENTS {
            for exponent in [-4000, -300, -1, 0, 7, 1000, 4000] {
                let found = Logarithm(exponent * PARTS).root(m).value();
                let exact = exponent as f64 / m as f64;
                // A part is lost where quotients are cut off, less than one with the digits of reciprocals, and the
                // exact one is rounded.
                assert!(
                    (found - exact).abs() < 2.0 / PARTS as f64 + f64::EPSILON * exact.abs(),
                    "{exponent}/{m}: {found}"
                );
            }
        }
    }

    #[test]
    fn roots_scale_exactly() {
        for m in 1..COEFFICIENTS {
            for size in [1e-200, 0.3, 1.0, 1.5, 2.0_f64.powi(m as i32), 7e11] {
                let size = Logarithm::of(size);
                for exponent in [-40, -1, 1, 30] {
                    let scaled = size.times_power_of_two(exponent * m as i32).root(m);
                    assert_eq!(scaled, size.root(m).times_power_of_two(exponent), "{m}: {exponent}");
                }
            }
        }
    }

    #[test]
    fn numbers_end_in_zero_and_infinity() {
        for size in [0.0, f64::INFINITY] {
            assert_eq!(Logarithm::of(size).number(), size);
        }
        assert!(Logarithm::of(f64::NAN) >= Logarithm::OF_INFINITY);
        assert!(Logarithm::of(f64::MAX) < Logarithm::OF_INFINITY);
        // What a quotient by zero would be, whatever the root, is beyond those of numbers.
        let by_zero = Logarithm::of(1e-300) + Logarithm::of(1e-300) - Logarithm::OF_ZERO;
        assert!(by_zero.root(COEFFICIENTS - 1) > (Logarithm::of(1e300) - Logarithm::of(1e-300)).root(4));
    }
}
