//! Step-size control: the step within which a Taylor polynomial meets its tolerance.
//!
//! For positions and for momenta, the last coefficients add the tolerance times their scale at the end of the step: `h
//! = min (ε S / |cₘ|)^(1/m)` over the last two orders `m` (Jorba and Zou 2005), with the maximum norms of the
//! coefficients. The scale `S` is the norm of the half itself, or what it grows to within its radius of convergence
//! where it begins near zero, so that neither units nor the other half matter. Roots are taken of logarithms within
//! 0.09: steps may be off by a few per cent, the same on every machine.

use super::logarithm::Logarithm;

/// The maximum norms of a half's coefficients of the first two orders and of the last two.
pub(super) type Norms = [f64; 4];

/// The length of a step of this order, infinite where the motion is a polynomial, zero where it is singular.
/// `norm(half, m)` is the norm of the coefficients of order `m`, which is seldom needed beside `norms`.
#[inline(always)]
pub(super) fn step_size<const HALVES: usize>(
    order: usize,
    tolerance: f64,
    norms: [Norms; HALVES],
    norm: impl Fn(usize, usize) -> f64,
) -> f64 {
    let tolerance = Logarithm::of(tolerance);
    let mut least = Logarithm::OF_INFINITY;
    for (half, norms) in norms.into_iter().enumerate() {
        least = least.min(logarithm_of_step(order, tolerance, norms, |m| norm(half, m)));
    }
    least.number()
}

/// The logarithm of the step of one half.
#[inline(always)]
fn logarithm_of_step(order: usize, tolerance: Logarithm, norms: Norms, norm: impl Fn(usize) -> f64) -> Logarithm {
    let [value, slope, before, last] = norms.map(Logarithm::of);
    let most = before.max(last);
    if most >= Logarithm::OF_INFINITY {
        // So near to a singularity that coefficients are beyond the largest number: no step is short enough.
        return Logarithm::OF_ZERO;
    }
    if most == Logarithm::OF_ZERO {
        return sparse(order, tolerance, [value, slope], &norm);
    }
    let error = tolerance + scale(order - 1, most, [value, slope]);
    // Where one of them is zero, the root is that of a number far too large.
    (error - before).root(order - 1).min((error - last).root(order))
}

/// The scale of a half: its norm, or that of its first derivative times the radius of convergence that a late
/// coefficient shows, whichever is larger.
#[inline(always)]
fn scale(m: usize, coefficient: Logarithm, [value, slope]: [Logarithm; 2]) -> Logarithm {
    let scale = value.max(slope + (slope - coefficient).root(m));
    if value.max(slope) == Logarithm::OF_ZERO { coefficient } else { scale }
}

/// The step of a motion whose last coefficients vanish, by the highest that does not: of a polynomial there is none,
/// and symmetries leave out some orders of a series.
#[cold]
fn sparse(order: usize, tolerance: Logarithm, begin: [Logarithm; 2], norm: &impl Fn(usize) -> f64) -> Logarithm {
    let mut norms = (order / 2..order - 1).rev().map(|m| (m, Logarithm::of(norm(m))));
    let highest = norms.find(|(_, norm)| *norm != Logarithm::OF_ZERO);
    highest.map_or(Logarithm::OF_INFINITY, |(m, norm)| (tolerance + scale(m, norm, begin) - norm).root(m))
}

#[cfg(test)]
mod tests {
    fn step_size(order: usize, tolerance: f64, norm: impl Fn(usize) -> f64) -> f64 {
        super::step_size(order, tolerance, [[0, 1, order - 1, order].map(&norm)], |_, m| norm(m))
    }

    #[test]
    fn a_geometric_series_is_cut_where_its_terms_are_small_whatever_the_units() {
        for (unit, radius) in [(1.0, 1.0), (1e-12, 1e6), (1e30, 1e-9)] {
            let found = step_size(20, 1e-16, |m| unit * 2.0 * f64::powi(1.0 / radius, m as i32));
            // (1e-16)^(1/19) of the radius; logarithms within 0.09, three of them over 19, are within a per cent, and
            // the power of two at the end is within 0.09 of its logarithm, six per cent.
            let exact = 1e-16_f64.powf(1.0 / 19.0) * radius;
            assert!((found / exact - 1.0).abs() < 0.08, "{found} instead of {exact}");
        }
    }

    #[test]
    fn what_begins_at_zero_is_judged_by_what_it_becomes() {
        // A sine: its own norm is zero, and every other coefficient is.
        let factorial = |m: usize| (1..=m).map(|i| i as f64).product::<f64>();
        let found = step_size(20, 1e-16, |m| if m % 2 == 1 { 1.0 / factorial(m) } else { 0.0 });
        let last = found.powi(19) / factorial(19);
        assert!((1e-17..1e-14).contains(&last), "{found}: the last term is {last}");
    }

    #[test]
    fn a_polynomial_has_no_end_and_a_sparse_series_has_one() {
        assert_eq!(step_size(20, 1e-16, |m| if m < 3 { 1.0 } else { 0.0 }), f64::INFINITY);
        let found = step_size(20, 1e-16, |m| if m % 6 == 1 { 1.0 } else { 0.0 });
        assert!((0.01..0.2).contains(&found), "{found}");
        assert!(step_size(20, 1e-16, |_| f64::NAN).is_nan() || step_size(20, 1e-16, |_| f64::NAN) >= 0.0);
    }
}
