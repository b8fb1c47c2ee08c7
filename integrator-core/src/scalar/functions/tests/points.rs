//! The points at which functions are tested.

use super::Precision;

/// The number of points in each set, for each of four scalars, or the requested one: a million for a function in
/// `.ci/run`.
fn count() -> usize {
    std::env::var("FUNCTION_POINTS").ok().and_then(|count| count.parse().ok()).unwrap_or(50_000)
}

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
    /// The first from one set and the second from another.
    Pairs(&'static Self, &'static Self),
}

impl Points {
    /// The points, rounded to a precision. Equal names give equal points.
    pub(super) fn arguments(&self, precision: Precision, name: &str) -> Vec<[f64; 2]> {
        let mut random = Random::new(name);
        (0..count()).map(|index| self.pair(index, precision, &mut random).map(|x| precision.round(x))).collect()
    }

    /// Two numbers, of which functions of one argument ignore the second.
    fn pair(&self, index: usize, precision: Precision, random: &mut Random) -> [f64; 2] {
        match self {
            Self::Pairs(first, second) => [first, second].map(|set| set.number(index, precision, random)),
            _ => [self.number(index, precision, random), 0.0],
        }
    }

    fn number(&self, index: usize, precision: Precision, random: &mut Random) -> f64 {
        match *self {
            Self::Even(low, high) => low + (high - low) * random.fraction(),
            Self::Powers(low, high) => {
                let size = (low + (high - low) * random.fraction()).exp2();
                if index.is_multiple_of(2) { size } else { -size }
            }
            Self::Pairs(first, _) => first.number(index, precision, random),
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
