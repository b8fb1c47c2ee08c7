//! Coefficients of a motion, from the generated recurrences and from the reference.

use crate::{
    reference::{self, Exact, Motion},
    rows, splits,
};
use integrator_core::{
    __private::{Coefficients, Layout, Recurrences, Table},
    Coords, System,
};
use std::array;

/// Up to which order coefficients are compared.
const ORDER: usize = 20;

/// The coefficients of a coordinate.
pub(crate) type Series = [f64; ORDER + 1];

/// The motion of a system from where it begins, by its recurrences: the series of each coordinate.
pub(crate) fn expand<H: Recurrences>(system: &H, motion: &Motion) -> [Vec<Series>; 2] {
    let begin = motion.q.iter().map(|series| series[0].value).collect();
    let length = H::Coords::from_flat(begin).expect("as many as the shape has").length();
    let layout = Layout::of::<H::Coords>(length, H::INTERLEAVED);
    let place = |coordinate: &usize| layout.index_of(*coordinate);
    let coordinates: Vec<usize> = (0..motion.q.len()).collect();
    let (mut tables, mut tape) = ([Table::new(layout), Table::new(layout)], H::Tape::<f64>::default());
    let parameters = <H as System>::parameters(system, length);
    let [mut q, mut p] = tables.each_mut().map(|table| table.of(layout, 1.0));
    for i in &coordinates {
        (q[0][place(i)], p[0][place(i)]) = (motion.q[*i][0].value, motion.p[*i][0].value);
    }
    for k in (0..ORDER).step_by(H::ORDERS_PER_CALL) {
        H::order::<f64>(&parameters, length, &mut q, &mut p, &mut tape, k, motion.time);
    }
    let series = |part: &Coefficients<'_, f64>, i| array::from_fn(|k| part[k][place(i)]);
    [q, p].map(|part| coordinates.iter().map(|i| series(&part, i)).collect())
}

/// By how many units of its scale a coefficient is off, at most, and where.
///
/// A sum of `k + 1` products rounds each of them `k` times at most on its way, and few functions take more than four
/// roundings beside it; so the unit is `(k + 4)` roundings of the scale. What is too small for a normal number is off by
/// the smallest one.
pub(crate) fn deviation(found: &[Series], exact: &[Vec<Exact>]) -> (f64, String) {
    let mut worst = (0.0, String::new());
    for (i, (found, exact)) in found.iter().zip(exact).enumerate() {
        for (k, (found, exact)) in found.iter().zip(exact).enumerate() {
            let unit = (k as f64 + 4.0) * f64::EPSILON / 2.0 * exact.scale + f64::MIN_POSITIVE;
            let units = (found - exact.value).abs() / unit;
            // A NaN is farther off than anything.
            if units > worst.0 || units.is_nan() {
                worst = (
                    if units.is_nan() { f64::INFINITY } else { units },
                    format!("[{i}], order {k}: {found:e} for {exact:?}"),
                );
            }
        }
    }
    worst
}

/// Holds the recurrences of a system against the reference.
pub(crate) fn judge<H: Recurrences>(name: &str, system: &H) {
    let motion = reference::motion(name);
    let found = expand(system, &motion);
    for (part, found, exact) in [("q", &found[0], &motion.q), ("p", &found[1], &motion.p)] {
        assert_eq!(found.len(), exact.len(), "{name}: {part}");
        assert!(exact.iter().all(|series| series.len() == ORDER + 1), "{name}: {part}");
        let (units, place) = deviation(found, exact);
        // To first order, the scale is a bound.
        assert!(units <= 1.0, "{name}: {units:.1} units off at {part}{place}");
    }
}

#[test]
fn the_reference_knows_the_same_systems() {
    let mut names = [rows::ROWS, splits::ROWS].concat();
    names.sort_unstable();
    assert_eq!(reference::names(), names);
}

#[test]
fn a_wrong_coefficient_would_be_seen() {
    let exact = vec![vec![Exact { value: 1.0, scale: 1.0 }; 3]];
    assert!(deviation(&[array::from_fn(|_| 1.0)], &exact).0 == 0.0);
    let wrong = |error: f64| deviation(&[array::from_fn(|k| if k == 2 { 1.0 + error } else { 1.0 })], &exact).0;
    // Six roundings at order two.
    assert!(wrong(2.5 * f64::EPSILON) < 1.0 && wrong(3.5 * f64::EPSILON) > 1.0 && wrong(f64::NAN) > 1.0);
}
