//! Step-size control: the step within which a Taylor polynomial meets its tolerance.
//!
//! For each coordinate of a few, and else for all positions and for all momenta, the last coefficients add the tolerance
//! times their scale at the end of the step: `h = min (ε S / |cₘ|)^(1/m)` over the last two orders `m` (Jorba and Zou
//! 2005), with the maximum norms of the coefficients. The scale `S` is the norm itself, or what it grows to within its
//! radius of convergence where it begins near zero. So neither the units of coordinates nor that of time matter: with
//! another power of two as a unit, steps have the same digits. Roots are taken of logarithms within 0.09: steps may be off
//! by a few per cent, the same on every machine.

use super::{logarithm::Logarithm, series::COEFFICIENTS};

/// The maximum norms of the coefficients of the first two orders and of the last two.
pub(super) type Norms = [f64; 4];

/// The logarithm of a step of this order: that of infinity where the motion is a polynomial, that of zero where
/// coefficients are infinite. `norms` are those of each group of coordinates that have a scale in common, and `norm(group,
/// m)` is the norm of the coefficients of order `m`, which is seldom needed beside these.
#[inline(always)]
pub(super) fn step_size(
    order: usize,
    tolerance: f64,
    norms: &[Norms],
    norm: impl Fn(usize, usize) -> f64,
) -> Logarithm {
    let tolerance = Logarithm::of(tolerance);
    let mut least = Logarithm::OF_INFINITY;
    for (group, norms) in norms.iter().enumerate() {
        least = least.min(step_of_group(order, tolerance, *norms, |m| norm(group, m)));
    }
    least
}

/// The logarithm of the step of one group.
#[inline(always)]
fn step_of_group(order: usize, tolerance: Logarithm, norms: Norms, norm: impl Fn(usize) -> f64) -> Logarithm {
    let [value, slope, before, last] = norms.map(Logarithm::of);
    let most = before.max(last);
    if most >= Logarithm::OF_INFINITY {
        // So near to a singularity, or in a unit so far from the step, that coefficients are beyond the largest number.
        return Logarithm::OF_ZERO;
    }
    if most == Logarithm::OF_ZERO || value.max(slope) == Logarithm::OF_ZERO {
        return sparse(order, tolerance, &norm);
    }
    // The radius of convergence that late coefficients show; where one of them is zero, it is far too large.
    let radius = (slope - before).root(order - 2).min((slope - last).root(order - 1));
    let error = tolerance + value.max(slope + radius);
    // Where one of them is zero, the root is that of a number far too large.
    (error - before).root(order - 1).min((error - last).root(order))
}

/// The step by the first derivative and the last ones that do not vanish: of a polynomial there is none, and symmetries
/// leave out some orders of a series. Like [`by_first_orders`] it is seldom called, and compiled with the library.
#[cold]
fn sparse(order: usize, tolerance: Logarithm, norm: &dyn Fn(usize) -> f64) -> Logarithm {
    let norms = logarithms(order, norm);
    let is_there = |m: &usize| norms[*m] != Logarithm::OF_ZERO;
    let Some(first) = (1..=order).find(is_there) else { return Logarithm::OF_INFINITY };
    let late = |begin: usize, end: usize| (begin..end).rev().filter(is_there).filter(|m| *m > first);
    let step = |m: usize| {
        let radius = (norms[first] - norms[m]).root(m - first);
        (tolerance + norms[0].max(norms[first] + radius.power(first)) - norms[m]).root(m)
    };
    // By the last two orders, or by the highest one below.
    let step_of_last = late(order - 1, order + 1).map(step).min();
    step_of_last.or_else(|| late(order / 2, order - 1).next().map(step)).unwrap_or(Logarithm::OF_INFINITY)
}

/// The logarithms of the norms of all orders.
fn logarithms(order: usize, norm: &dyn Fn(usize) -> f64) -> [Logarithm; COEFFICIENTS] {
    let mut norms = [Logarithm::OF_ZERO; COEFFICIENTS];
    for (m, logarithm) in norms.iter_mut().enumerate().take(order + 1) {
        *logarithm = Logarithm::of(norm(m));
    }
    norms
}

/// The logarithm of a step within the radius of convergence that the orders from one half of the highest on show, but for the
/// last ones; that of infinity unless it is less than half of the step that these allow.
///
/// Next to an edge at which the first derivatives of the force vanish, a series has large coefficients at some orders, whose
/// multiples it repeats, and small ones between them.
pub(super) fn step_within_radius(
    order: usize,
    tolerance: f64,
    step: Logarithm,
    groups: usize,
    norm: impl Fn(usize, usize) -> f64,
) -> Logarithm {
    let accuracy = Logarithm::of(tolerance).root(order);
    let mut least = Logarithm::OF_INFINITY;
    for group in 0..groups {
        let [value, slope] = [0, 1].map(|m| Logarithm::of(norm(group, m)));
        for m in order / 2..order - 1 {
            let coefficient = Logarithm::of(norm(group, m));
            if coefficient != Logarithm::OF_ZERO && value.max(slope) != Logarithm::OF_ZERO {
                let scale = value.max(slope + (slope - coefficient).root(m - 1));
                least = least.min((scale - coefficient).root(m) + accuracy);
            }
        }
    }
    if least < step - Logarithm::of(2.0) { least } else { Logarithm::OF_INFINITY }
}

/// A difference of logarithms of two radii that may be an error: those of three sizes within 0.09, over the orders between them.
const MOST_CONSTANT: Logarithm = Logarithm::of_sixteenths(1);

/// The logarithm of a step within which the terms of the series fall to the end; that of infinity if they do so within `step`.
///
/// Far from a barrier the force is so small that even its last coefficients meet the tolerance in steps that pass the barrier: that
/// of `exp(-x²)` at 20 has the coefficients of `exp(-400 + 40 t)`. Steps are kept to half of where the last terms exceed the ones
/// in the middle, a part of the radius of convergence.
#[inline(always)]
pub(super) fn step_of_falling_terms(
    order: usize,
    step: Logarithm,
    norms: &[Norms],
    norm: impl Fn(usize, usize) -> f64,
) -> Logarithm {
    let mut least = Logarithm::OF_INFINITY;
    for (group, norms) in norms.iter().enumerate() {
        let [_, _, before, last] = norms.map(Logarithm::of);
        // Where one of the two is zero, the other one has to be compared with those before.
        let may_rise = before.min(last) == Logarithm::OF_ZERO && before != last || step + last > before;
        if may_rise && before.max(last) < Logarithm::OF_INFINITY {
            least = least.min(falling_in_group(order, step, &|m| norm(group, m)));
        }
    }
    least
}

/// The same for one group, if the quotients of its coefficients grow with the order as those of an exponential or of a pole of a
/// high order do. A weak singularity, as at a distance of a rounding from an axis, adds no more behind than it does in front.
#[cold]
fn falling_in_group(order: usize, step: Logarithm, norm: &dyn Fn(usize) -> f64) -> Logarithm {
    // Even numbers of orders apart, as every other coefficient may be zero.
    let apart = 2 * (order / 8);
    let last = if norm(order) == 0.0 { order - 1 } else { order };
    let sizes = [3, 2, 1, 0].map(|intervals| Logarithm::of(norm(last - intervals * apart)));
    let radius = |interval: usize| (sizes[interval] - sizes[interval + 1]).root(apart);
    let grows = |interval: usize| radius(interval + 1) - radius(interval) > MOST_CONSTANT;
    let is_there = !sizes.contains(&Logarithm::OF_ZERO);
    let within = radius(2);
    if is_there && grows(0) && grows(1) && step > within { within - Logarithm::of(2.0) } else { Logarithm::OF_INFINITY }
}

/// The exponent of a power of two by which the unit of time is too short, if it is more than `near` binary digits from this
/// step, so that high coefficients may overflow or underflow.
#[inline(always)]
pub(super) fn too_short(
    step: Logarithm,
    near: i32,
    order: usize,
    groups: usize,
    norm: impl Fn(usize, usize) -> f64,
) -> Option<i32> {
    if step.floor().abs() <= near { None } else { by_first_orders(step, near, order, groups, &norm) }
}

/// The exponent of [`too_short`] for a step that is infinite, zero or far off: by the orders whose coefficients are
/// finite.
#[cold]
fn by_first_orders(
    step: Logarithm,
    near: i32,
    order: usize,
    groups: usize,
    norm: &dyn Fn(usize, usize) -> f64,
) -> Option<i32> {
    let groups = (0..groups).map(|group| logarithms(order, &|m| norm(group, m)));
    if step == Logarithm::OF_INFINITY {
        // A polynomial, unless the highest coefficient that is left is much smaller than the others.
        let exponents = groups.filter_map(|norms| {
            let m = (1..=order).rev().find(|m| norms[*m] != Logarithm::OF_ZERO)?;
            let most = norms.into_iter().max()?;
            Some((most - norms[m]).root(m).floor())
        });
        return exponents.min().filter(|exponent| *exponent > near);
    }
    if step != Logarithm::OF_ZERO {
        return Some(step.floor());
    }
    let mut least = -near - 1;
    for norms in groups {
        let Some(m) = (1..=order).find(|m| norms[*m] >= Logarithm::OF_INFINITY) else { continue };
        if m == 1 {
            // The derivative itself is no number, in any unit.
            return None;
        }
        least = least.min((norms[0].max(norms[1]) - norms[m - 1]).root(m - 1).floor());
    }
    Some(least)
}

#[cfg(test)]
mod tests {
    use super::{Logarithm, too_short};

    fn logarithm(order: usize, tolerance: f64, norm: impl Fn(usize) -> f64) -> Logarithm {
        let norms = [[0, 1, order - 1, order].map(&norm)];
        super::step_size(order, tolerance, &norms, |_, m| norm(m))
    }

    fn step_size(order: usize, tolerance: f64, norm: impl Fn(usize) -> f64) -> f64 {
        logarithm(order, tolerance, norm).number()
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
    fn a_series_that_begins_at_zero_is_scaled_by_its_later_terms() {
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

    /// Norms of all kinds: entire functions, geometric series, those that begin late or have gaps.
    const SERIES: [fn(usize) -> f64; 6] = [
        |m| 0.7_f64.powi(m as i32),
        |m| 1.3 * 9.1_f64.powi(m as i32) / (1 + m * m) as f64,
        |m| if m == 0 { 1e-9 } else { 3.7_f64.powi(m as i32) },
        |m| if m < 2 { 0.0 } else { 5.1 * 0.3_f64.powi(m as i32) },
        |m| if m % 3 == 2 { 2.3_f64.powi(m as i32) } else { 0.0 },
        |m| if m < 5 { 0.0 } else { 1.7_f64.powi(m as i32) },
    ];

    #[test]
    fn steps_scale_with_powers_of_two_exactly() {
        for (number, series) in SERIES.into_iter().enumerate() {
            for order in [4, 18, 22, 27, 28] {
                let step = logarithm(order, 1e-13, series);
                for (size, time) in [(0, 7), (-200, 0), (90, -13), (-60, 16)] {
                    let scaled = |m: usize| series(m) * 2.0_f64.powi(size - time * m as i32);
                    let is_polynomial = step == Logarithm::OF_INFINITY;
                    let expected = if is_polynomial { step } else { step.times_power_of_two(time) };
                    assert_eq!(logarithm(order, 1e-13, scaled), expected, "series {number}, order {order}");
                }
            }
        }
    }

    #[test]
    fn a_unit_that_overflows_or_underflows_is_replaced() {
        let entire = |m: usize| 1.0 / (1..=m).map(|i| i as f64).product::<f64>();
        for begin in [-400, -90, -40, -21, 0, 21, 40, 90, 400] {
            let mut exponent = begin;
            let changes = (0..20).find(|_| {
                // Numbers as they come out in this unit.
                let norm = |m: usize| entire(m) * (0..m).fold(1.0, |power, _| power * 2.0_f64.powi(exponent));
                match too_short(logarithm(20, 1e-13, norm), 20, 20, 1, |_, m| norm(m)) {
                    Some(by) => exponent += by,
                    None => return true,
                }
                false
            });
            assert!(changes.is_some_and(|changes| changes < 6), "from 2^{begin} to 2^{exponent}: {changes:?}");
            assert!((-20..=20).contains(&exponent), "from 2^{begin} to 2^{exponent}");
        }
    }

    #[test]
    fn lines_and_singularities_keep_their_unit() {
        let line = |m: usize| [1.0, 1e-3].get(m).copied().unwrap_or(0.0);
        assert_eq!(too_short(logarithm(20, 1e-13, line), 20, 20, 1, |_, m| line(m)), None);
        let singular = |m: usize| if m == 0 { 1.0 } else { f64::INFINITY };
        assert_eq!(too_short(logarithm(20, 1e-13, singular), 20, 20, 1, |_, m| singular(m)), None);
    }

    #[test]
    fn a_step_ends_before_the_terms_of_a_tiny_force_rise() {
        let factorial = |m: usize| (1..=m).map(|i| i as f64).product::<f64>();
        let falling = |norm: &dyn Fn(usize) -> f64| {
            let step = logarithm(26, 1e-16, norm);
            let norms = [[0, 1, 25, 26].map(norm)];
            (step.number(), super::step_of_falling_terms(26, step, &norms, |_, m| norm(m)).number())
        };
        // exp(-400 + 40 t): the terms rise until order 40 t.
        let (step, least) =
            falling(&|m| if m < 2 { 1.0 } else { (-400.0_f64).exp() * 40.0_f64.powi(m as i32) / factorial(m) });
        assert!(step > 1e5 && (0.1..26.0 / 40.0).contains(&least), "{step}, {least}");
        // The same with a gap in front of the last order.
        let gap = |m: usize| if m == 25 { 0.0 } else { 1e-200 / factorial(m) };
        let (step, least) = falling(&|m| if m < 2 { 1.0 } else { gap(m) });
        assert!(step > 1e5 && (1.0..26.0).contains(&least), "{step}, {least}");
        // Series that are as large as their scale, and polynomials, are not limited.
        assert_eq!(falling(&|m| 0.7_f64.powi(m as i32)).1, f64::INFINITY);
        assert_eq!(falling(&|m| 1.0 / factorial(m)).1, f64::INFINITY);
        assert_eq!(falling(&|m| if m < 3 { 1.0 } else { 0.0 }).1, f64::INFINITY);
    }

    #[test]
    fn a_series_with_large_coefficients_at_few_orders_is_cut_within_its_radius() {
        // A wall of the power 8, entered at 1e-17 from its edge: the orders 8 and 16 are large, the last ones small.
        let norm = |_: usize, m: usize| match m {
            0 => 1.0,
            m if m % 8 == 0 => 2e4_f64.powi(m as i32 / 8),
            _ => 1e-30,
        };
        let step = Logarithm::of(0.9);
        let found = super::step_within_radius(22, 1e-15, step, 1, norm).number();
        let radius = 2e4_f64.powf(-1.0 / 8.0);
        assert!(found < 0.5 * radius && found > 0.1 * radius, "{found} within {radius}");
    }
}
