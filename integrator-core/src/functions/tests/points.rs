//! Where functions are tested.

use super::Precision;

/// How many numbers each set holds for each of four scalars: a million for a function.
const COUNT: usize = 250_000;

/// A set of points.
#[derive(Debug)]
pub(super) enum Points {
    /// Spread evenly between two numbers.
    Even(f64, f64),
    /// Of either sign, their logarithms spread evenly between two powers of two.
    Powers(f64, f64),
    /// Positive, their logarithms spread evenly between two powers of two.
    Sizes(f64, f64),
    /// The multiples of π/2 and their neighbours.
    Quarters,
}

impl Points {
    /// The points, rounded to a precision. Equal names give equal points.
    pub(super) fn numbers(&self, precision: Precision, name: &str) -> Vec<f64> {
        let mut random = Random::new(name);
        (0..COUNT).map(|index| precision.round(self.number(index, precision, &mut random))).collect()
    }

    fn number(&self, index: usize, precision: Precision, random: &mut Random) -> f64 {
        match *self {
            Self::Even(low, high) => low + (high - low) * random.fraction(),
            Self::Powers(low, high) => {
                let size = (low + (high - low) * random.fraction()).exp2();
                if index.is_multiple_of(2) { size } else { -size }
            }
            Self::Sizes(low, high) => (low + (high - low) * random.fraction()).exp2(),
            Self::Quarters => {
                let multiple = precision.round((random.fraction() * 1_048_576.0).floor() * std::f64::consts::FRAC_PI_2);
                let step = (index % 3) as f64 - 1.0;
                multiple + step * precision.unit(multiple)
            }
        }
    }
}

/// Numbers that look random and are the same everywhere (xorshift64).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(name: &str) -> Self {
        Self(
            name.bytes()
                .fold(0x9e37_79b9_7f4a_7c15, |state, byte| (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)),
        )
    }

    /// Between 0 and 1.
    fn fraction(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 * 0.5_f64.powi(53)
    }
}
