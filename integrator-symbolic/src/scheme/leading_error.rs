//! The size of the leading error terms of a step.
//!
//! All conditions up to degree `p` hold, so in degree `p + 1` the series of the step differs from that of the exact flow
//! by a Lie element `E` with the residuals as its coefficients. Written in the basis of bracketed Lyndon words, the
//! Euclidean norm of its coordinates is the leading error. For quadratic `T` the coordinates are those modulo the
//! brackets that vanish, in the basis of the first bracketed Lyndon words that are independent there.
//!
//! The norm depends on the basis: it compares methods of the same order and class, and has no other meaning.

use super::conditions::{Series, Word, general, quadratic};

/// A Lyndon word, whose bracket is an element of the basis, and the coordinate of `E` along it.
pub(super) type Term = (Word, f64);

/// The leading error for every `T(p)`, given the series of the step up to `degree` at least.
///
/// The bracket of a Lyndon word is this word plus larger ones, so the coordinates come out in lexicographic order.
pub(super) fn general_terms(series: &Series, degree: usize) -> Vec<Term> {
    let mut terms: Vec<Term> = Vec::new();
    for word in general(degree) {
        let covered: f64 = terms.iter().map(|(smaller, coordinate)| coordinate * word.in_bracket_of(*smaller)).sum();
        terms.push((word, series.residual(word) - covered));
    }
    terms
}

/// The leading error for quadratic `T`, given the series of the step up to `degree` at least.
///
/// The words that decide a degree are functionals on the quotient: a bracket is a row of its coefficients at them. Going
/// through the Lyndon words, each row is reduced by those before it; what remains joins the basis, with a pivot of 1.
pub(super) fn quadratic_terms(series: &Series, degree: usize) -> Vec<Term> {
    let words = quadratic(degree);
    let mut basis: Vec<Reduced> = Vec::new();
    for lyndon in general(degree) {
        let mut row: Vec<f64> = words.iter().map(|word| word.in_bracket_of(lyndon)).collect();
        let earlier = basis.iter().map(|reduced| reduced.take_from(&mut row)).collect();
        let largest = row.iter().enumerate().max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
        // Brackets have integer coefficients of a few digits, so what is left of a dependent one is rounding.
        if let Some((pivot, &scale)) = largest
            && scale.abs() > 1e-9
        {
            row.iter_mut().for_each(|entry| *entry /= scale);
            basis.push(Reduced { lyndon, row, pivot, scale, earlier });
        }
    }
    let mut residuals: Vec<f64> = words.iter().map(|word| series.residual(*word)).collect();
    let mut coordinates: Vec<f64> = basis.iter().map(|reduced| reduced.take_from(&mut residuals)).collect();
    for (position, reduced) in basis.iter().enumerate().rev() {
        coordinates[position] /= reduced.scale;
        let coordinate = coordinates[position];
        for (other, factor) in coordinates.iter_mut().zip(&reduced.earlier) {
            *other -= coordinate * factor;
        }
    }
    basis.iter().map(|reduced| reduced.lyndon).zip(coordinates).collect()
}

/// The row `(bracket - sum of earlier * rows before) / scale`, which is 1 at its pivot and 0 at those before.
struct Reduced {
    lyndon: Word,
    row: Vec<f64>,
    pivot: usize,
    scale: f64,
    earlier: Vec<f64>,
}

impl Reduced {
    /// Subtracts the multiple of this row after which a vector is 0 at the pivot, and returns it.
    fn take_from(&self, vector: &mut [f64]) -> f64 {
        let factor = vector[self.pivot];
        for (entry, own) in vector.iter_mut().zip(&self.row) {
            *entry -= factor * own;
        }
        factor
    }
}

/// The leading error as one number.
pub(super) fn norm(terms: &[Term]) -> f64 {
    terms.iter().map(|(_, coordinate)| coordinate * coordinate).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use crate::scheme::tests::scheme;

    /// Values found with 90 digits by a program of its own, which reduces the whole ideal for quadratic `T`.
    #[test]
    fn known_errors() {
        for (sequence, general, quadratic) in [
            ("Euler", 0.5, 0.5),
            // [T, [T, V]]/12 and [V, [T, V]]/24.
            ("VelocityVerlet", 0.093_169_499_06, 0.093_169_499_06),
            ("V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1)", 0.014_800_142_16, 0.014_640_174_35),
            ("triple_jump(Verlet)", 0.027_911_220_84, 0.027_506_734_81),
            ("suzuki(VelocityVerlet)", 0.001_838_754_176, 0.001_495_312_669),
            ("suzuki(suzuki(VelocityVerlet))", 9.222_891_678e-6, 6.297_038_041e-6),
            ("triple_jump(triple_jump(triple_jump(VelocityVerlet)))", 0.019_184_816_76, 0.019_146_439_5),
        ] {
            let proof = scheme(sequence).proof;
            for (found, expected) in [(proof.general.expect("no gradients"), general), (proof.quadratic, quadratic)] {
                let found = found.leading_error.expect("a violated condition");
                assert!((found / expected - 1.0).abs() < 1e-8, "{sequence}: {found}");
            }
        }
        let found = scheme("symmetric(V(1/6) T(1/2) V(2/3, -1/72))").proof.quadratic.leading_error;
        assert!((found.expect("a violated condition") / 1.022_194_545e-3 - 1.0).abs() < 1e-8, "{found:?}");
    }
}
