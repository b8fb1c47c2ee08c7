//! Reductions over all members: sums, moments, extremes, histograms. They do not depend on the number of ranks.

use crate::{Ensemble, Member, exact_sum::ExactSum};
use integrator_core::Coords;
use mpi::{
    collective::SystemOperation,
    traits::{Communicator, CommunicatorCollectives},
};
use std::ops::Range;

/// The first moments of a quantity over all members.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// The number of members with this quantity.
    pub count: u64,
    /// The mean; NaN if no member has the quantity, as are all following moments.
    pub mean: f64,
    /// The mean squared deviation from the mean.
    pub variance: f64,
    /// The mean cubed deviation from the mean, in units of the standard deviation.
    pub skewness: f64,
    /// The mean fourth power of the deviation in the same units: 3 for a normal distribution.
    pub kurtosis: f64,
}

impl Moments {
    /// Returns the square root of the variance.
    pub fn standard_deviation(&self) -> f64 {
        self.variance.sqrt()
    }

    /// Returns the standard error of the mean, for statistically independent members.
    pub fn standard_error(&self) -> f64 {
        (self.variance / (self.count as f64 - 1.0)).sqrt()
    }
}

/// The numbers of members in intervals of equal width.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// The range of all intervals together.
    pub range: Range<f64>,
    /// The number of members in each interval, including its lower end.
    pub counts: Vec<u64>,
    /// The number of members below the first interval.
    pub below: u64,
    /// The number of members above the last interval, or at its end.
    pub above: u64,
    /// The number of members whose quantity is NaN.
    pub nan: u64,
}

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// Returns the sum of a quantity over all members that have it. Collective.
    ///
    /// The sum is exact before it is rounded to the nearest `f64`. It is hence bitwise identical for every order and
    /// distribution of the members.
    pub fn sum(&self, number: impl Fn(&Member<'_, C>) -> Option<f64>) -> f64 {
        let mut sum = ExactSum::EMPTY;
        self.for_each_local(|member| number(&member).into_iter().for_each(|x| sum.add(x)));
        sum.over_ranks(self.world()).value()
    }

    /// Returns the first moments of a quantity over all members that have it, each from an exact sum. Collective.
    pub fn moments(&self, number: impl Fn(&Member<'_, C>) -> Option<f64>) -> Moments {
        // The distances from the mean require the numbers once more.
        let numbers: Vec<f64> = self.members_of_rank().filter_map(|member| number(&member)).collect();
        let mut sum = ExactSum::EMPTY;
        numbers.iter().for_each(|x| sum.add(*x));
        let sum = sum.over_ranks(self.world());
        let count = sum.count();
        let mean = sum.value() / count as f64;
        let mut powers = [ExactSum::EMPTY, ExactSum::EMPTY, ExactSum::EMPTY];
        for x in numbers {
            let (distance, mut power) = (x - mean, x - mean);
            for sum in &mut powers {
                power *= distance;
                sum.add(power);
            }
        }
        let [square, cube, fourth] = powers.map(|sum| sum.over_ranks(self.world()).value() / count as f64);
        let deviation = square.sqrt();
        Moments {
            count,
            mean,
            variance: square,
            skewness: cube / (square * deviation),
            kurtosis: fourth / (square * square),
        }
    }

    /// Returns the smallest quantity of all members that have it, with the index of the first such member. Collective.
    ///
    /// NaN is ignored.
    pub fn minimum(&self, number: impl Fn(&Member<'_, C>) -> Option<f64>) -> Option<(usize, f64)> {
        self.maximum(|member| number(member).map(|x| -x)).map(|(index, x)| (index, -x))
    }

    /// Returns the largest quantity of all members that have it, with the index of the first such member. Collective.
    ///
    /// NaN is ignored.
    pub fn maximum(&self, number: impl Fn(&Member<'_, C>) -> Option<f64>) -> Option<(usize, f64)> {
        let mut own: Option<(usize, f64)> = None;
        self.for_each_local(|member| {
            if let Some(x) = number(&member).filter(|x| !x.is_nan())
                && own.is_none_or(|(_, largest)| x > largest)
            {
                own = Some((member.index, x));
            }
        });
        let ranks = self.world().size() as usize;
        let (mut indices, mut values) = (vec![0_u64; ranks], vec![0.0_f64; ranks]);
        // NaN says that a rank has none.
        let (index, value) = own.unwrap_or((0, f64::NAN));
        self.world().all_gather_into(&(index as u64), &mut indices[..]);
        self.world().all_gather_into(&value, &mut values[..]);
        let found = indices.into_iter().zip(values).filter(|(_, x)| !x.is_nan());
        // Ranks are in the order of their members.
        found.reduce(|first, next| if next.1 > first.1 { next } else { first }).map(|(index, x)| (index as usize, x))
    }

    /// Counts the members whose quantity is in each of `bins` intervals of `range`. Collective.
    ///
    /// The range and the number of intervals must be the same on every rank.
    pub fn histogram(
        &self,
        range: Range<f64>,
        bins: usize,
        number: impl Fn(&Member<'_, C>) -> Option<f64>,
    ) -> Histogram {
        // After the intervals: below, above, NaN.
        let mut own = vec![0_u64; bins + 3];
        let width = range.end - range.start;
        self.for_each_local(|member| {
            if let Some(x) = number(&member) {
                let place = match () {
                    () if x.is_nan() => bins + 2,
                    () if x < range.start => bins,
                    () if x >= range.end || bins == 0 => bins + 1,
                    // The quotient of numbers below the end may round to one.
                    () => (((x - range.start) / width * bins as f64) as usize).min(bins - 1),
                };
                own[place] += 1;
            }
        });
        let mut counts = vec![0_u64; own.len()];
        self.world().all_reduce_into(&own[..], &mut counts[..], SystemOperation::sum());
        let (below, above, nan) = (counts[bins], counts[bins + 1], counts[bins + 2]);
        counts.truncate(bins);
        Histogram { range, counts, below, above, nan }
    }
}
