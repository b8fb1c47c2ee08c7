//! The growth of a deviation vector, and the angles between several, as they are sampled along an orbit.

use crate::{
    chaos::{Indicator, Verdict},
    ensemble::lane_scalars::LaneScalars,
    scalar::{
        instruction_set::InstructionSet,
        real::{Kernel, Real},
        tolerance::largest,
    },
    state::{coords::Coords, phase::Phase},
    trajectory::tangent::{BETWEEN_SCALES, Units, numbers, squares},
};
use nalgebra::DMatrix;
use std::{
    f64::consts::{LN_2, TAU},
    marker::PhantomData,
};

/// The number of samples of an orbit, unless these would be sparser than rescalings of vectors. The integral of an
/// oscillating logarithm has an error of its amplitude over the root of this number.
const SAMPLES: u64 = 128;

/// The number of steps between two samples of an orbit.
pub(super) fn steps_between_samples(steps: u64) -> u64 {
    // A power of two, so that samples are taken where vectors are divided.
    steps.div_ceil(SAMPLES).clamp(1, BETWEEN_SCALES).next_power_of_two()
}

/// Sums over samples of the length of one vector, for any distance in time.
#[derive(Clone, Debug)]
pub(super) struct Growth {
    first: f64,
    last: f64,
    highest: f64,
    /// The time since the start.
    time: f64,
    /// The integral of `t d ln|v|`.
    weighted: f64,
    /// MEGNO, and its integral over time.
    megno: f64,
    over_time: f64,
    /// The total change of the vector, in units of its length: radians where it turns.
    changed: f64,
}

impl Growth {
    /// A vector at the start with this logarithm of its length.
    pub(super) fn new(logarithm: f64) -> Self {
        let (first, last, highest) = (logarithm, logarithm, logarithm);
        Self { first, last, highest, time: 0.0, weighted: 0.0, megno: 0.0, over_time: 0.0, changed: 0.0 }
    }

    /// The vector after a time since the start.
    ///
    /// MEGNO is `Y(t) = 2/t ∫ s d ln|v(s)|` (Cincotta and Simó 2000, Astron. Astrophys. Suppl. 147, 205), by trapezoids.
    pub(super) fn sample(&mut self, time: f64, logarithm: f64) {
        // Backwards in time the integral and the time have the same sign.
        self.weighted += (time + self.time) / 2.0 * (logarithm - self.last);
        let megno = 2.0 * self.weighted / time;
        self.over_time += (megno + self.megno) / 2.0 * (time - self.time);
        self.highest = self.highest.max(logarithm);
        (self.megno, self.time, self.last) = (megno, time, logarithm);
    }

    /// The estimate of the largest exponent: the mean rate of growth.
    pub(super) fn exponent(&self) -> f64 {
        (self.last - self.first) / self.time.abs()
    }

    pub(super) fn megno(&self) -> f64 {
        self.megno
    }

    /// The mean of MEGNO over time.
    pub(super) fn mean_megno(&self) -> f64 {
        self.over_time / self.time
    }

    /// The fast Lyapunov indicator: the largest logarithm of the length so far, over that of the start (Froeschlé, Lega
    /// and Gonczi 1997, Celest. Mech. Dyn. Astron. 67, 41).
    pub(super) fn fli(&self) -> f64 {
        self.highest - self.first
    }

    /// The time since the start.
    pub(super) fn time(&self) -> f64 {
        self.time
    }

    /// Adds a change of the vector, in units of its length.
    pub(super) fn change(&mut self, by: f64) {
        self.changed += by;
    }

    /// Returns the verdict of the mean MEGNO, once a chaotic orbit would have shown itself.
    pub(super) fn verdict(&self) -> Verdict {
        let is_long_enough = self.changed >= CHANGED || self.fli() >= GROWN;
        match Verdict::of_megno(self.mean_megno()) {
            Verdict::Regular if !is_long_enough => Verdict::Undecided,
            verdict => verdict,
        }
    }

    /// An indicator that is computed from one vector.
    pub(super) fn indicator(&self, indicator: Indicator) -> f64 {
        if self.time == 0.0 {
            return f64::NAN;
        }
        match indicator {
            Indicator::Megno => self.mean_megno(),
            Indicator::Exponent => self.exponent(),
            Indicator::Fli => self.fli(),
        }
    }
}

/// The mean MEGNO tends to 2 on quasiperiodic orbits, from below or in waves of about a tenth, and to less on stable
/// periodic ones; on chaotic ones it grows like half of the exponent times the time.
pub(super) const REGULAR_BELOW: f64 = 2.5;
pub(super) const CHAOTIC_ABOVE: f64 = 4.0;

/// The conditions for a regular orbit. Either its vector has changed by 64 turns: the mean MEGNO of a chaotic orbit
/// with an exponent of a fiftieth of its frequency is 4 by then. Or it has grown by the exponential of 6: by
/// exponential growth the mean MEGNO, half of this logarithm, would be 3.
const CHANGED: f64 = 64.0 * TAU;
const GROWN: f64 = 6.0;

/// Returns the change of a vector from another one, in units of the length of the latter.
pub(super) fn relative_change<C: Coords>(before: &Phase<C>, after: &Phase<C>, exponents: i64) -> f64 {
    let scale = largest(numbers(before));
    let (mut change, mut length) = (0.0, 0.0);
    for (before, after) in numbers(before).zip(numbers(after)) {
        change += ((after * 2.0_f64.powf(exponents as f64) - before) / scale).powi(2);
        length += (before / scale).powi(2);
    }
    (change / length).sqrt()
}

/// The logarithm of the length in these units of a vector times a power of two. If squares overflow or underflow, the
/// vector is divided by its largest number first.
pub(super) fn logarithm<C: Coords>(vector: &Phase<C>, exponent: i64, units: Units) -> f64 {
    let square = units.square(squares(vector));
    let mut of_square = [square];
    logarithms(&mut of_square);
    of_length(square, of_square[0], exponent, || units.measured(vector.clone()))
}

/// Returns the logarithm of the length, where the sum of the squares and its logarithm are known.
pub(super) fn of_length<C: Coords>(
    square: f64,
    of_square: f64,
    exponent: i64,
    vector: impl FnOnce() -> Phase<C>,
) -> f64 {
    let logarithm = if square.is_normal() {
        0.5 * of_square
    } else {
        let vector = vector();
        let largest = largest(numbers(&vector));
        let square: f64 = numbers(&vector).map(|number| (number / largest).powi(2)).sum();
        largest.ln() + 0.5 * square.ln()
    };
    logarithm + exponent as f64 * LN_2
}

/// Replaces numbers by their logarithms, in SIMD lanes. Each is bitwise identical to that of the number alone.
pub(super) fn logarithms(numbers: &mut [f64]) {
    match InstructionSet::chosen() {
        InstructionSet::Baseline => logarithms_in_lanes::<<f64 as LaneScalars>::Plain>(numbers),
        InstructionSet::Fused => logarithms_in_lanes::<<f64 as LaneScalars>::Fused>(numbers),
        InstructionSet::Avx512 => logarithms_in_lanes::<<f64 as LaneScalars>::Avx512>(numbers),
    }
}

fn logarithms_in_lanes<R: Real>(numbers: &mut [f64]) {
    R::enter(Logarithms(numbers, PhantomData::<R>));
}

struct Logarithms<'n, R>(&'n mut [f64], PhantomData<R>);

impl<R: Real> Kernel for Logarithms<'_, R> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        for lanes in self.0.chunks_mut(R::LANES) {
            let found = R::state(&|lane| lanes.get(lane).copied().unwrap_or(1.0)).ln();
            for (lane, number) in lanes.iter_mut().enumerate() {
                *number = found.lane(lane);
            }
        }
    }
}

/// Returns the share of the length of a vector that is orthogonal to a direction, from 0 to 1. The orthogonal fast
/// Lyapunov indicator follows it (Fouchard, Lega, Froeschlé and Froeschlé 2002, Celest. Mech. Dyn. Astron. 83, 205;
/// Barrio 2005, Chaos Solitons Fractals 25, 711). Without a direction it is 1.
pub(super) fn orthogonal_part<C: Coords>(vector: &Phase<C>, direction: &[f64]) -> f64 {
    let unit = |numbers: &mut dyn Iterator<Item = f64>| {
        let numbers: Vec<f64> = numbers.collect();
        let largest = largest(numbers.iter().copied());
        let length = numbers.iter().map(|number| (number / largest).powi(2)).sum::<f64>().sqrt();
        numbers.into_iter().map(move |number| number / largest / length).collect::<Vec<f64>>()
    };
    let (vector, direction) = (unit(&mut numbers(vector)), unit(&mut direction.iter().copied()));
    if direction.iter().any(|number| !number.is_finite()) {
        return 1.0;
    }
    let along: f64 = vector.iter().zip(&direction).map(|(a, b)| a * b).sum();
    // The difference itself, since one minus a square would cancel.
    vector.iter().zip(&direction).map(|(a, b)| (a - along * b).powi(2)).sum::<f64>().sqrt()
}

/// The vectors as columns of length one.
fn directions<C: Coords>(vectors: &[Phase<C>]) -> DMatrix<f64> {
    let rows = vectors.first().map_or(0, |vector| numbers(vector).count());
    let columns = vectors.iter().flat_map(|vector| {
        let largest = largest(numbers(vector));
        numbers(vector).map(move |number| number / largest)
    });
    let mut directions = DMatrix::from_iterator(rows, vectors.len(), columns);
    for mut column in directions.column_iter_mut() {
        let length = column.norm();
        column /= length;
    }
    directions
}

/// The generalised alignment indices of the first two, three, ... vectors: the volumes that their directions span
/// (Skokos, Bountis and Antonopoulos 2007, Physica D 231, 30), by singular values, since determinants would cancel.
pub(super) fn alignment_indices<C: Coords>(vectors: &[Phase<C>]) -> Vec<f64> {
    let directions = directions(vectors);
    let volume = |count: usize| directions.columns(0, count).singular_values().iter().product();
    (2..=vectors.len()).map(volume).collect()
}

/// The smaller alignment index of two vectors: the shorter diagonal of their directions (Skokos 2001, J. Phys. A 34,
/// 10029).
pub(super) fn smaller_alignment_index<C: Coords>(vectors: &[Phase<C>]) -> f64 {
    let directions = directions(vectors);
    let (first, second) = (directions.column(0), directions.column(1));
    (first + second).norm().min((first - second).norm())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::tolerance::within;

    #[test]
    fn exponential_and_linear_growth_are_measured() {
        let (mut exponential, mut linear) = (Growth::new(0.0), Growth::new(0.0));
        for sample in 1..=4096 {
            let time = f64::from(sample) / 8.0;
            exponential.sample(time, 0.7 * time);
            linear.sample(time, time.ln_1p());
        }
        // ∫ s·λ ds = λt²/2, so that Y = λt and its mean λt/2; trapezoids are exact here.
        assert!(within(exponential.exponent() - 0.7, 1e-13));
        assert!(within(exponential.megno() / (0.7 * 512.0) - 1.0, 1e-12));
        assert!(within(exponential.mean_megno() / (0.35 * 512.0) - 1.0, 1e-12));
        assert!(within(exponential.fli() - 0.7 * 512.0, 1e-10));
        assert_eq!(exponential.verdict(), Verdict::Chaotic);
        // ∫ s/(1+s) ds = t - ln(1+t); the trapezoids of an eighth are off by less than a hundredth of the last term.
        let exact = 2.0 * (512.0 - 513.0_f64.ln()) / 512.0;
        assert!(within(linear.megno() - exact, 1e-3), "{} is not {exact}", linear.megno());
        assert_eq!(linear.verdict(), Verdict::Regular);
    }

    #[test]
    fn an_orbit_is_regular_only_after_enough_time() {
        // A vector that turns once in a unit of time, and one that grows by e.
        for (turns, verdict) in [(0.2, Verdict::Undecided), (20.0, Verdict::Undecided), (65.0, Verdict::Regular)] {
            let mut bounded = Growth::new(0.0);
            for _ in 0..100 {
                bounded.change(turns * TAU / 100.0);
                bounded.sample(bounded.time() + turns / 100.0, 0.0);
            }
            assert_eq!(bounded.verdict(), verdict, "{turns} turns");
        }
        for (time, verdict) in
            [(0.16, Verdict::Undecided), (4.0, Verdict::Undecided), (7.0, Verdict::Undecided), (9.0, Verdict::Chaotic)]
        {
            let mut growing = Growth::new(0.0);
            for sample in 1..=100 {
                growing.change(time / 100.0);
                growing.sample(time * f64::from(sample) / 100.0, time * f64::from(sample) / 100.0);
            }
            assert_eq!(growing.verdict(), verdict, "after {time}");
        }
    }

    #[test]
    fn changes_are_measured_in_units_of_the_length() {
        let (before, after) = (Phase::new([3e200], [4e200]), Phase::new([3e190], [4e200]));
        assert!(within(relative_change(&before, &after, 0) - 0.6, 1e-9));
        let halved = Phase::new([1.5e200], [2e200]);
        assert_eq!(relative_change(&before, &halved, 1), 0.0);
    }

    #[test]
    fn aligned_vectors_span_nothing() {
        let vector = |q: [f64; 2], p: [f64; 2]| Phase::new(q, p);
        let right = [vector([3.0, 0.0], [0.0, 0.0]), vector([0.0, 0.0], [0.0, 1e200]), vector([0.0, 2.0], [0.0, 0.0])];
        // Singular values of the unit matrix, to a few roundings.
        assert!(alignment_indices(&right).iter().all(|index| within(index - 1.0, 8.0 * f64::EPSILON)));
        assert!(within(smaller_alignment_index(&right) - 2.0_f64.sqrt(), 1e-15));
        let near = [vector([1.0, 0.0], [0.0, 0.0]), vector([-1.0, 1e-12], [0.0, 0.0])];
        // Directions are rounded by an ulp of one, their difference by as much.
        assert!(within(alignment_indices(&near)[0] - 1e-12, 1e-15));
        assert!(within(smaller_alignment_index(&near) - 1e-12, 1e-15));
    }

    #[test]
    fn the_part_orthogonal_to_a_direction_is_measured() {
        let vector = Phase::new([3e200, 0.0], [0.0, 4e200]);
        assert!(within(orthogonal_part(&vector, &[1e-200, 0.0, 0.0, 0.0]) - 0.8, 1e-15));
        assert!(within(orthogonal_part(&vector, &[-3.0, 1e-9, 0.0, -4.0]) - 2e-10, 1e-15));
        assert_eq!(orthogonal_part(&vector, &[0.0; 4]), 1.0);
    }

    #[test]
    fn lengths_beyond_the_squares_of_numbers_have_logarithms() {
        let long = Phase::new([3e300, 0.0], [0.0, 4e300]);
        let units = Units::balancing([1.0; 2]);
        assert!(within(logarithm(&long, 10, units) - (5e300_f64.ln() + 10.0 * LN_2), 1e-12));
    }
}
