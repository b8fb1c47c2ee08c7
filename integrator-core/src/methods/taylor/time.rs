//! Times of expansions, in double-double arithmetic: steps of all lengths are added up, and runs read states at integer
//! multiples of another step.

use crate::scalar::exact::{fast_two_sum, two_sum};

/// A double-double time: the unevaluated sum of two numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Time {
    high: f64,
    low: f64,
}

impl Time {
    /// `steps · h`, exactly.
    pub(crate) fn of(steps: u64, h: f64) -> Self {
        let high = steps as f64 * h;
        // Two parts of 32 bits multiply without rounding once `h` is split as well; the differences are exact in turn.
        let [above, below] = [(steps >> 26 << 26) as f64, (steps & ((1 << 26) - 1)) as f64];
        let (upper, lower) = split(h);
        let low = (((above * upper - high) + above * lower) + below * upper) + below * lower;
        Self { high, low }
    }

    /// The time after a duration, which may be negative.
    pub(crate) fn after(self, duration: f64) -> Self {
        let [high, lost] = two_sum(self.high, duration);
        let [high, low] = fast_two_sum(high, self.low + lost);
        Self { high, low }
    }

    /// The duration from another time to this one.
    pub(crate) fn since(self, other: Self) -> f64 {
        (self.high - other.high) + (self.low - other.low)
    }

    /// The nearest number.
    pub(crate) fn nearest(self) -> f64 {
        self.high + self.low
    }
}

/// A number as the sum of two with half of its digits (Veltkamp).
fn split(x: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * x;
    let upper = scaled - (scaled - x);
    (upper, x - upper)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_sums_are_those_of_integers() {
        // In units of 2^-60, in which all of these are integers that fit into 128 bits.
        let unit = 2.0_f64.powi(-60);
        let exact = |time: Time| (time.high / unit) as i128 + (time.low / unit) as i128;
        for (steps, h) in [(3, 0.1), (1_000_003, 0.1), (123_456_789_012, 0.7), ((1 << 53) - 1, 0.01)] {
            let product = i128::from(steps) * ((h / unit) as i128);
            assert_eq!(exact(Time::of(steps, h)), product, "{steps} · {h}");
        }
        let (mut time, mut sum) = (Time::default(), 0_i128);
        for step in 1..=1_000_u64 {
            let duration = 0.1 / step as f64;
            time = time.after(duration);
            sum += (duration / unit) as i128;
        }
        // Each sum of two parts is rounded at 2^-106 of it at most, and the unit cuts off as much.
        assert!((exact(time) - sum).abs() < 2_000, "{} and {sum}", exact(time));
        assert_eq!(Time::of(10, 0.1).since(Time::of(9, 0.1)), 0.1);
    }
}
