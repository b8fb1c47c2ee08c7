//! Exact sums of numbers, bitwise identical for any order.
//!
//! Every finite `f64` is an integer multiple of 2^-1074. The sum is an integer of 68 digits of 32 bits, so it is exact
//! for any order of the addends and any distribution over ranks. It is rounded once, at the end.

use mpi::{collective::SystemOperation, traits::CommunicatorCollectives};

/// Digits of 32 bits: 2098 bits of the largest number in units of the smallest, and 78 more for the number of addends.
const DIGITS: usize = 68;

/// Bits of a digit.
const BITS: usize = 32;

/// After how many addends digits are carried: each adds less than 2^32 to a digit of 63 bits and a sign.
const CARRY_AFTER: u32 = 1 << 30;

/// The exact sum of numbers.
#[derive(Clone, Debug)]
pub(crate) struct ExactSum {
    /// Digits, lowest first, each with a sign and more bits than it needs.
    digits: [i64; DIGITS],
    /// Addends since digits were carried.
    uncarried: u32,
    /// How many addends there were, of these NaN, infinity and minus infinity.
    counts: [u64; 4],
}

impl ExactSum {
    pub(crate) const EMPTY: Self = Self { digits: [0; DIGITS], uncarried: 0, counts: [0; 4] };

    pub(crate) fn add(&mut self, x: f64) {
        let [all, nan, above, below] = &mut self.counts;
        *all += 1;
        if x.is_nan() {
            *nan += 1;
        } else if x == f64::INFINITY {
            *above += 1;
        } else if x == f64::NEG_INFINITY {
            *below += 1;
        } else {
            self.add_finite(x);
        }
    }

    fn add_finite(&mut self, x: f64) {
        let bits = x.to_bits();
        let (exponent, fraction) = ((bits >> 52 & 0x7ff) as usize, bits & ((1 << 52) - 1));
        // Subnormal numbers have the unit of the smallest normal ones, and no leading one.
        let (shift, whole) = if exponent == 0 { (0, fraction) } else { (exponent - 1, fraction | 1 << 52) };
        let mut rest = u128::from(whole) << (shift % BITS);
        let sign = if x.is_sign_negative() { -1 } else { 1 };
        for digit in &mut self.digits[shift / BITS..] {
            if rest == 0 {
                break;
            }
            *digit += sign * (rest & u128::from(u32::MAX)) as i64;
            rest >>= BITS;
        }
        self.uncarried += 1;
        if self.uncarried == CARRY_AFTER {
            self.carry();
        }
    }

    /// Brings every digit but the last into `0 .. 2^32`; the last one has the sign of all.
    fn carry(&mut self) {
        let mut carried = 0;
        for digit in &mut self.digits[..DIGITS - 1] {
            let sum = *digit + carried;
            *digit = sum & i64::from(u32::MAX);
            carried = sum >> BITS;
        }
        self.digits[DIGITS - 1] += carried;
        self.uncarried = 0;
    }

    /// The sum over all ranks, on each of them.
    pub(crate) fn over_ranks(mut self, world: &impl CommunicatorCollectives) -> Self {
        self.carry();
        let mut all = Self::EMPTY;
        world.all_reduce_into(&self.digits[..], &mut all.digits[..], SystemOperation::sum());
        world.all_reduce_into(&self.counts[..], &mut all.counts[..], SystemOperation::sum());
        all.carry();
        all
    }

    /// How many addends there were.
    pub(crate) fn count(&self) -> u64 {
        self.counts[0]
    }

    /// The sum, rounded to nearest, to even in the middle.
    pub(crate) fn value(mut self) -> f64 {
        let [_, nan, above, below] = self.counts;
        match (nan, above, below) {
            (0, 0, 0) => {}
            (0, _, 0) => return f64::INFINITY,
            (0, 0, _) => return f64::NEG_INFINITY,
            _ => return f64::NAN,
        }
        self.carry();
        let negative = self.digits[DIGITS - 1] < 0;
        if negative {
            self.digits.iter_mut().for_each(|digit| *digit = -*digit);
            self.carry();
        }
        let magnitude = self.magnitude();
        if negative { -magnitude } else { magnitude }
    }

    /// The value of carried digits that are not negative.
    fn magnitude(&self) -> f64 {
        let Some(top) = self.digits.iter().rposition(|digit| *digit != 0) else { return 0.0 };
        // The four highest digits have 97 to 128 bits, or all there are. What is below only matters in the middle between
        // two numbers, where its last bit stands for it.
        let low = top.saturating_sub(3);
        let mut leading = self.digits[low..=top].iter().rev().fold(0_u128, |sum, digit| sum << BITS | *digit as u128);
        leading |= u128::from(self.digits[..low].iter().any(|digit| *digit != 0));
        // Whole numbers are rounded by the conversion. It is the only rounding: where four digits are not all there are, the
        // result is a normal number. Powers of two below the normal ones are applied in two factors, each of them exact.
        let exponent = (low * BITS) as i32 - 1074;
        let half = exponent / 2;
        leading as f64 * power(half) * power(exponent - half)
    }
}

/// 2 to a power between -1022 and 1023.
fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::ExactSum;

    fn sum(numbers: &[f64]) -> f64 {
        let mut sum = ExactSum::EMPTY;
        numbers.iter().for_each(|x| sum.add(*x));
        sum.value()
    }

    #[test]
    fn sums_are_exact_and_rounded_once() {
        let tiny = f64::from_bits(1);
        for (numbers, expected) in [
            (&[][..], 0.0),
            (&[1e300, 1.0, -1e300], 1.0),
            (&[f64::MAX, f64::MAX, -f64::MAX], f64::MAX),
            (&[f64::MAX, f64::MAX], f64::INFINITY),
            (&[tiny, tiny, tiny], 3.0 * tiny),
            (&[f64::MIN_POSITIVE, -tiny], f64::MIN_POSITIVE - tiny),
            (&[-1.0, -2.5, 0.25], -3.25),
            // In the middle between two numbers, to the even one, and beyond it by a little.
            (&[1.0, f64::EPSILON / 2.0], 1.0),
            (&[1.0, f64::EPSILON / 2.0, tiny], 1.0 + f64::EPSILON),
            (&[-1.0, -f64::EPSILON / 2.0, -tiny], -1.0 - f64::EPSILON),
            (&[1.0 + f64::EPSILON, f64::EPSILON / 2.0], 1.0 + 2.0 * f64::EPSILON),
            (&[f64::INFINITY, 1.0], f64::INFINITY),
            (&[f64::NEG_INFINITY, 1.0], f64::NEG_INFINITY),
        ] {
            assert_eq!(sum(numbers).to_bits(), f64::to_bits(expected), "{numbers:?}");
        }
        assert!(sum(&[f64::INFINITY, f64::NEG_INFINITY]).is_nan());
        assert!(sum(&[f64::NAN]).is_nan());
    }

    #[test]
    fn no_bit_depends_on_the_order() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..200 {
            let mut numbers: Vec<f64> =
                (0..100).map(|_| (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-1070..1000))).collect();
            let forward = sum(&numbers);
            random.shuffle(&mut numbers);
            assert_eq!(sum(&numbers).to_bits(), forward.to_bits());
            // What was added and taken away again leaves nothing.
            let back: Vec<f64> = numbers.iter().map(|x| -x).collect();
            numbers.extend(back);
            random.shuffle(&mut numbers);
            assert_eq!(sum(&numbers), 0.0);
        }
    }
}
