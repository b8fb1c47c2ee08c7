//! How far a Taylor polynomial reaches.
//!
//! For each part of the state, the step is where the last coefficients add the share of the tolerance to it:
//! `h = min (ε S / |cₘ|)^(1/m)` over the last two orders `m` (Jorba and Zou 2005), with the largest coefficients of all
//! coordinates of the part. `S` is how large the part is, or what it grows to within its own radius of convergence where it begins
//! near zero, so that no unit and no other part matters. Powers are taken of bits: steps may be off by a few per
//! cent, the same on every machine.

/// What bits have to be divided by so that exponents are whole numbers.
const UNIT: f64 = (1_u64 << 52) as f64;

/// The logarithm to the base of two within 0.09: exponents exactly, between them along a straight line.
#[inline(always)]
pub(super) fn logarithm(x: f64) -> f64 {
    // Signed, since only those conversions are an instruction everywhere; the highest bit is a sign that is not there.
    x.to_bits() as i64 as f64 / UNIT - 1023.0
}

/// The number with this logarithm.
#[inline(always)]
fn exponential(logarithm: f64) -> f64 {
    // Conversions saturate; beyond the largest exponent a step is as good as infinite.
    f64::from_bits(((logarithm + 1023.0).clamp(0.0, 2046.0) * UNIT) as i64 as u64)
}

/// The length of a step of this order, infinite where the motion is a polynomial, zero where it is singular. `size(m)`
/// is the largest coefficient of order `m` in a part; those of the first two orders and of the last two are given, since
/// seldom others are asked for.
#[inline(always)]
pub(super) fn reach(
    order: usize,
    tolerance: f64,
    [value, slope, before, last]: [f64; 4],
    size: impl Fn(usize) -> f64,
) -> f64 {
    let most = if before > last { before } else { last };
    if !most.is_finite() {
        // So near to a singularity that coefficients are beyond the largest number: no step is short enough.
        return 0.0;
    }
    if most == 0.0 {
        return sparse(order, tolerance, &size);
    }
    let share = logarithm(tolerance) + logarithm(scale(order - 1, most, value, slope));
    let [last, before] = [(order, last), (order - 1, before)].map(|(m, size)| at(m, share, size));
    if before < last { before } else { last }
}

/// Where a coefficient of order `m` adds a share, given by its logarithm.
#[inline(always)]
fn at(m: usize, share: f64, coefficient: f64) -> f64 {
    if coefficient == 0.0 { f64::INFINITY } else { exponential((share - logarithm(coefficient)) / m as f64) }
}

/// How large a part is, or what its first derivative makes of it within the radius that a late coefficient tells.
#[inline(always)]
fn scale(m: usize, coefficient: f64, value: f64, slope: f64) -> f64 {
    if slope == 0.0 {
        return if value == 0.0 { coefficient } else { value };
    }
    let grown = slope * exponential((logarithm(slope) - logarithm(coefficient)) / m as f64);
    if grown > value { grown } else { value }
}

/// The step of a motion whose last coefficients vanish, by the highest that does not: of a polynomial there is none, and
/// symmetries leave out some orders of a series.
#[cold]
fn sparse(order: usize, tolerance: f64, size: &impl Fn(usize) -> f64) -> f64 {
    let highest = (order / 2..order - 1).rev().find(|m| size(*m) != 0.0);
    highest.map_or(f64::INFINITY, |m| {
        at(m, logarithm(tolerance) + logarithm(scale(m, size(m), size(0), size(1))), size(m))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(order: usize, tolerance: f64, size: impl Fn(usize) -> f64) -> f64 {
        super::reach(order, tolerance, [0, 1, order - 1, order].map(&size), size)
    }

    #[test]
    fn logarithms_are_near_enough() {
        for exponent in -300..300 {
            for digits in [1.0, 1.3, 1.7, 1.99] {
                let x = digits * 2.0_f64.powi(exponent);
                assert!((logarithm(x) - x.log2()).abs() < 0.0861, "{x}");
                assert!((exponential(logarithm(x)) / x - 1.0).abs() < 1e-12, "{x}");
            }
        }
    }

    #[test]
    fn a_geometric_series_is_cut_where_its_terms_are_small_whatever_the_units() {
        for (unit, radius) in [(1.0, 1.0), (1e-12, 1e6), (1e30, 1e-9)] {
            let found = reach(20, 1e-16, |m| unit * 2.0 * f64::powi(1.0 / radius, m as i32));
            // (1e-16)^(1/19) of the radius; logarithms within 0.09, three of them over 19, are within a per cent, and
            // the power of two at the end is within 0.09 of its logarithm, six per cent.
            let exact = 1e-16_f64.powf(1.0 / 19.0) * radius;
            assert!((found / exact - 1.0).abs() < 0.08, "{found} instead of {exact}");
        }
    }

    #[test]
    fn what_begins_at_zero_is_judged_by_what_it_becomes() {
        // A sine: its own size is zero, and every other coefficient is.
        let factorial = |m: usize| (1..=m).map(|i| i as f64).product::<f64>();
        let found = reach(20, 1e-16, |m| if m % 2 == 1 { 1.0 / factorial(m) } else { 0.0 });
        let last = found.powi(19) / factorial(19);
        assert!((1e-17..1e-14).contains(&last), "{found}: the last term is {last}");
    }

    #[test]
    fn a_polynomial_has_no_end_and_a_sparse_series_has_one() {
        assert_eq!(reach(20, 1e-16, |m| if m < 3 { 1.0 } else { 0.0 }), f64::INFINITY);
        let found = reach(20, 1e-16, |m| if m % 6 == 1 { 1.0 } else { 0.0 });
        assert!((0.01..0.2).contains(&found), "{found}");
        assert!(reach(20, 1e-16, |_| f64::NAN).is_nan() || reach(20, 1e-16, |_| f64::NAN) >= 0.0);
    }
}
