//! The joint fit of terms to a series: weighted least squares in frequencies and amplitudes.

use super::{
    series::Series,
    term::{Term, unit},
};
use nalgebra::{DMatrix, DVector};
use rustfft::num_complex::Complex;
use std::f64::consts::PI;

/// Terms that are fitted to a series, and the rest of the series.
pub(super) struct Fit<'s> {
    series: &'s Series,
    pub(super) terms: Vec<Term>,
    /// The series without the terms.
    pub(super) rest: Vec<Complex<f64>>,
    /// Inner products of the tangent vectors of all terms, as they were when the terms were added. They change little
    /// afterwards, and the solution depends on the gradient alone.
    products: DMatrix<f64>,
}

/// The unknowns of a term: relative changes of the amplitude along itself and along `i` times itself, and the change of the
/// frequency. All are in units of the amplitude; the frequency is in radians per half of the series.
const UNKNOWNS: usize = 3;

/// The largest number of Newton steps. Quadratic convergence from a refined peak takes about four.
const STEPS: usize = 30;

/// The largest step of a frequency, in radians per half of the series: a quarter of the resolution.
const LONGEST: f64 = PI / 4.0;

impl<'s> Fit<'s> {
    /// Begins without terms.
    pub(super) fn new(series: &'s Series) -> Self {
        Self { series, terms: Vec::new(), rest: series.values.clone(), products: DMatrix::zeros(0, 0) }
    }

    /// Adds a term of a frequency and fits all terms; `false` without a change if the term is not larger than the rounding.
    pub(super) fn add(&mut self, frequency: f64) -> bool {
        let weighted = self.series.places().zip(&self.rest).zip(&self.series.weights);
        let amplitude = weighted.map(|((place, value), weight)| value * unit(-frequency * place) * weight).sum();
        let term = Term { frequency, amplitude };
        let half = self.series.half();
        let rounding: f64 = self.terms.iter().chain([&term]).map(|term| term.rounding(half)).sum();
        if amplitude.norm() <= rounding {
            return false;
        }
        self.terms.push(term);
        self.rest = self.rest_of(&self.terms);
        self.extend_products();
        self.solve();
        true
    }

    /// Returns the series without some terms.
    fn rest_of(&self, terms: &[Term]) -> Vec<Complex<f64>> {
        let without = |(place, value): (f64, &Complex<f64>)| {
            value - terms.iter().map(|term| term.at(place)).sum::<Complex<f64>>()
        };
        self.series.places().zip(&self.series.values).map(without).collect()
    }

    /// Adds the products of the last term with all terms.
    fn extend_products(&mut self) {
        let last = self.terms.len() - 1;
        let products = std::mem::replace(&mut self.products, DMatrix::zeros(0, 0));
        self.products = products.resize(UNKNOWNS * (last + 1), UNKNOWNS * (last + 1), 0.0);
        for other in 0..=last {
            let block = self.block(self.terms[other], self.terms[last]);
            for (row, column) in (0..UNKNOWNS).flat_map(|row| (0..UNKNOWNS).map(move |column| (row, column))) {
                self.products[(UNKNOWNS * other + row, UNKNOWNS * last + column)] = block[row][column];
                self.products[(UNKNOWNS * last + column, UNKNOWNS * other + row)] = block[row][column];
            }
        }
    }

    /// The real inner products of the tangent vectors `e`, `ie` and `iσe` of two terms, where `e` is the term divided by the
    /// modulus of its amplitude, and `σ` runs from -1 to 1.
    fn block(&self, a: Term, b: Term) -> [[f64; UNKNOWNS]; UNKNOWNS] {
        let frequency = b.frequency - a.frequency;
        let [zeroth, first, second] = self
            .moments(self.series.places().map(|place| unit(frequency * place)))
            .map(|moment| moment * phase(a).conj() * phase(b));
        [[zeroth.re, -zeroth.im, -first.im], [zeroth.im, zeroth.re, first.re], [first.im, first.re, second.re]]
    }

    /// The sums of values with the weights of the window, multiplied by powers of `σ`.
    fn moments(&self, values: impl Iterator<Item = Complex<f64>>) -> [Complex<f64>; 3] {
        let (mut moments, half) = ([Complex::default(); 3], self.series.half());
        for ((value, place), weight) in values.zip(self.series.places()).zip(&self.series.weights) {
            let (mut value, along) = (value * weight, place / half);
            for moment in &mut moments {
                *moment += value;
                value *= along;
            }
        }
        moments
    }

    /// Takes Newton steps as long as each is less than half of the one before, down to rounding.
    fn solve(&mut self) {
        let Some(products) = self.products.clone().cholesky() else { return };
        let (half, mut before) = (self.series.half(), f64::INFINITY);
        for _ in 0..STEPS {
            let mut step = products.solve(&self.gradient());
            let size = step.amax();
            let converges = size < before / 2.0;
            if !converges {
                break;
            }
            before = size;
            let longest = self.frequency_steps(&step).fold(0.0_f64, |longest, step| longest.max(step.abs()));
            if longest > LONGEST {
                step *= LONGEST / longest;
            }
            let changes: Vec<f64> = self.frequency_steps(&step).collect();
            let changed = |(number, term): (usize, &Term)| Term {
                frequency: term.frequency + changes[number] / half,
                amplitude: term.amplitude
                    + phase(*term) * Complex::new(step[UNKNOWNS * number], step[UNKNOWNS * number + 1]),
            };
            let terms: Vec<Term> = self.terms.iter().enumerate().map(changed).collect();
            let rest = self.rest_of(&terms);
            // A step that does not reduce the rest, up to the rounding of the sum, comes from a rest that no terms describe.
            let rounding = 1.0 + rest.len() as f64 * f64::EPSILON;
            let is_better = self.size_of(&rest) <= self.size_of(&self.rest) * rounding;
            if !is_better {
                break;
            }
            (self.terms, self.rest) = (terms, rest);
        }
    }

    /// The products of the rest with all tangent vectors.
    fn gradient(&self) -> DVector<f64> {
        let of_term = |term: &Term| {
            let turned =
                self.series.places().zip(&self.rest).map(|(place, value)| value * unit(-term.frequency * place));
            let [zeroth, first, _] = self.moments(turned).map(|moment| moment * phase(*term).conj());
            [zeroth.re, zeroth.im, first.im]
        };
        DVector::from_iterator(UNKNOWNS * self.terms.len(), self.terms.iter().flat_map(of_term))
    }

    /// The steps of all frequencies, in radians per half of the series.
    fn frequency_steps<'f>(&'f self, step: &'f DVector<f64>) -> impl Iterator<Item = f64> + 'f {
        let of_term = |(number, term): (usize, &Term)| step[UNKNOWNS * number + 2] / term.amplitude.norm();
        self.terms.iter().enumerate().map(of_term)
    }

    /// The sum of squares of a rest, with the weights of the window.
    fn size_of(&self, rest: &[Complex<f64>]) -> f64 {
        rest.iter().zip(&self.series.weights).map(|(value, weight)| weight * value.norm_sqr()).sum()
    }
}

/// The amplitude divided by its modulus.
fn phase(term: Term) -> Complex<f64> {
    term.amplitude / term.amplitude.norm()
}
