//! A second part that is integrated by steps of an inner composition: the proved orders, compared with slopes.

use crate::{
    catalogue::for_each_composition,
    many_parts::{reference, slope_of, walk},
    pairs::{AsTwo, Two},
};
use integrator_core::{__private::Scheme, Composition, prelude::*};

/// The steps of Verlet in two steps of an inner composition, as fractions of their total duration.
fn fractions(inner: u32) -> Vec<f64> {
    let outer = 1.0 / (2.0 - 2_f64.cbrt());
    let step = match inner {
        2 => vec![1.0],
        _ => vec![outer, 1.0 - 2.0 * outer, outer],
    };
    [step.as_slice(), &step].concat().iter().map(|fraction| fraction / 2.0).collect()
}

/// The measured order of a composition over the inner orders 2 and 4.
fn measured<X: Composition<Two>>(exact: [f64; 4]) -> [f64; 2] {
    [2, 4].map(|inner| {
        slope_of(X::NAME, exact, |steps| {
            let mut flows = AsTwo::start(&fractions(inner));
            walk::<Two, X>(&mut flows, steps);
            flows.state()
        })
    })
}

#[test]
fn every_composition_has_at_least_the_proved_orders() {
    let exact = reference();
    macro_rules! compare {
        ($($composition:ident)*) => {$(
            let [two, four, ..] = $composition::ORDERS_OVER_INNER;
            for (proved, slope) in [two, four].into_iter().zip(measured::<$composition>(exact)) {
                // Errors of the next order still show in steps that do not yet reach the rounding. For order 10, few steps
                // are both short enough for its slope and long enough for errors above the rounding.
                let proved = proved.min(8);
                assert!(slope > f64::from(proved) - 0.4, "{} has order {slope}, not {proved}", $composition::NAME);
            }
        )*};
    }
    for_each_composition!(general: compare!);
    for_each_composition!(near_integrable_general: compare!);
}

#[test]
fn the_proved_orders_are_no_lower_than_the_measured_ones() {
    let exact = reference();
    macro_rules! compare {
        ($($composition:ident)*) => {$(
            let [two, four, ..] = $composition::ORDERS_OVER_INNER;
            for (proved, slope) in [two, four].into_iter().zip(measured::<$composition>(exact)) {
                assert!(slope < f64::from(proved) + 0.4, "{} has order {slope}, not {proved}", $composition::NAME);
            }
        )*};
    }
    compare!(Verlet Yoshida4 BlanesMoan4 Aba864);
}

#[test]
fn the_default_is_the_lower_order() {
    assert_eq!(Euler::ORDERS_OVER_INNER, [1; 4]);
    assert_eq!(BlanesMoan4::ORDERS_OVER_INNER, [2, 4, 4, 4]);
    assert_eq!(BlanesMoan6::ORDERS_OVER_INNER, [2, 4, 6, 6]);
    assert_eq!(Teloy8A::ORDERS_OVER_INNER, [2, 4, 6, 8]);
}

#[test]
fn compositions_of_verlet_keep_their_orders() {
    assert_eq!(Yoshida6::ORDERS_OVER_INNER, [6; 4]);
    assert_eq!(KahanLi8::ORDERS_OVER_INNER, [8; 4]);
    assert_eq!(KahanLi10::ORDERS_OVER_INNER, [10; 4]);
}
