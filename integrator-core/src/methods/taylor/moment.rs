//! Times of expansions, in twice the precision: steps of all lengths are added up, and states are looked at where an
//! integer number of other steps leads.

use crate::scalar::exact::{fast_two_sum, two_sum};

/// A time as an unevaluated sum of two numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moment {
    high: f64,
    low: f64,
}

impl Moment {
    /// `steps · h`, exactly.
    pub(crate) fn of(steps: u64, h: f64) -> Self {
        let high = steps as f64 * h;
        // Two parts of 32 bits multiply without rounding once `h` is split as well; the differences are exact in turn.
        let [above, below] = [(steps >> 26 << 26) as f64, (steps & ((1 << 26) - 1)) as f64];
        let (upper, lower) = split(h);
        let low = (((above * upper - high) + above * lower) + below * upper) + below * lower;
        Self { high, low }
    }

    /// A little later, or earlier.
    pub(crate) fn after(self, duration: f64) -> Self {
        let [high, lost] = two_sum(self.high, duration);
        let [high, low] = fast_two_sum(high, self.low + lost);
        Self { high, low }
    }

    /// How long it is from another one to this.
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
        let exact = |moment: Moment| (moment.high / unit) as i128 + (moment.low / unit) as i128;
        for (steps, h) in [(3, 0.1), (1_000_003, 0.1), (123_456_789_012, 0.7), ((1 << 53) - 1, 0.01)] {
            let product = i128::from(steps) * ((h / unit) as i128);
            assert_eq!(exact(Moment::of(steps, h)), product, "{steps} · {h}");
        }
        let (mut moment, mut sum) = (Moment::default(), 0_i128);
        for step in 1..=1_000_u64 {
            let duration = 0.1 / step as f64;
            moment = moment.after(duration);
            sum += (duration / unit) as i128;
        }
        // Each sum of two parts is rounded at 2^-106 of it at most, and the unit cuts off as much.
        assert!((exact(moment) - sum).abs() < 2_000, "{} and {sum}", exact(moment));
        assert_eq!(Moment::of(10, 0.1).since(Moment::of(9, 0.1)), 0.1);
    }
}
