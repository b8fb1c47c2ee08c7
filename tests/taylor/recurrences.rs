//! Coefficients of a motion, from the generated recurrences and from the reference.

use crate::{
    reference::{self, Exact, Motion},
    rows::ROWS,
};
use integrator_core::{
    __private::{COEFFICIENTS, Recurrences, Series},
    Coords, Hamiltonian,
};
use std::{array, collections::BTreeSet, fs, path::Path};

/// Up to which order coefficients are compared.
const ORDER: usize = 20;

/// The motion of a system from where it begins, by its recurrences.
pub(crate) fn expand<H: Recurrences>(system: &H, motion: &Motion) -> [Vec<Series<f64>>; 2] {
    let begin = |part: &[Vec<Exact>]| -> Vec<Series<f64>> {
        let at =
            |series: &Vec<Exact>| array::from_fn::<_, COEFFICIENTS, _>(|k| if k == 0 { series[0].value } else { -0.0 });
        part.iter().map(at).collect()
    };
    let (mut q, mut p) = (begin(&motion.q), begin(&motion.p));
    let shape = H::Coords::from_flat(q.iter().map(|series| series[0]).collect()).expect("as many as the shape has");
    let (length, mut tape) = (shape.length(), H::Tape::<f64>::default());
    let parameters = <H as Hamiltonian>::parameters(system, length);
    for k in 0..ORDER {
        H::order::<f64>(&parameters, length, &mut q, &mut p, &mut tape, k, motion.time);
        for series in q.iter_mut().chain(&mut p) {
            series[k + 1] /= (k + 1) as f64;
        }
    }
    [q, p]
}

/// By how many units of its scale a coefficient is off, at most, and where.
///
/// A sum of `k + 1` products in two halves rounds each of them `k/2 + 1` times on its way, and few functions take
/// more than four roundings beside it; so the unit is `(k/2 + 4)` roundings of the scale. What is too small for a
/// normal number is off by the smallest one.
pub(crate) fn deviation(found: &[Series<f64>], exact: &[Vec<Exact>]) -> (f64, String) {
    let mut worst = (0.0, String::new());
    for (i, (found, exact)) in found.iter().zip(exact).enumerate() {
        for (k, (found, exact)) in found.iter().zip(exact).enumerate() {
            let unit = (k as f64 / 2.0 + 4.0) * f64::EPSILON / 2.0 * exact.scale + f64::MIN_POSITIVE;
            let units = (found - exact.value).abs() / unit;
            // What is no number is farther off than anything.
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
    let mut names = ROWS.to_vec();
    names.sort_unstable();
    assert_eq!(reference::names(), names);
}

/// The names in the table of elementary functions, as the generator's source has them.
fn functions() -> BTreeSet<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("integrator-symbolic/src/graph/function.rs");
    let source = fs::read_to_string(path).expect("text");
    let table = source.split_once("const TABLE").and_then(|(_, rest)| rest.split_once("\n];")).expect("the table").0;
    let rows = ["unary(\"", "binary(\"", "name: \""].iter().flat_map(|row| table.split(row).skip(1));
    rows.filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
}

#[test]
fn every_elementary_function_has_a_row_of_its_name() {
    let functions = functions();
    assert!(functions.contains("sin") && functions.contains("hypot"), "the rows are found: {functions:?}");
    let rows = include_str!("rows.rs");
    for function in functions {
        let row = rows.lines().find(|line| line.trim_start().starts_with(&format!("{function} [")));
        let row = row.unwrap_or_else(|| panic!("no row is called `{function}`"));
        assert!(row.contains(&format!(".{function}(")), "the row does not call the function: {row}");
    }
}

#[test]
fn a_wrong_coefficient_would_be_seen() {
    let exact = vec![vec![Exact { value: 1.0, scale: 1.0 }; 3]];
    assert!(deviation(&[array::from_fn(|_| 1.0)], &exact).0 == 0.0);
    let wrong = |error: f64| deviation(&[array::from_fn(|k| if k == 2 { 1.0 + error } else { 1.0 })], &exact).0;
    // Five roundings at order two.
    assert!(wrong(2.0 * f64::EPSILON) < 1.0 && wrong(3.0 * f64::EPSILON) > 1.0 && wrong(f64::NAN) > 1.0);
}
