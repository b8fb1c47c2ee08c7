//! Accuracy: orders, tolerances, extrapolation, and methods that are equal.

use super::{
    CHANGED, Claim,
    advice::{KEEPS, ORDER, SAME, TOLERANCE},
};
use crate::study::Study;

/// A slope is off by a few hundredths where the next term of the error still shows, and a mistyped method by one.
const fn order(order: f64) -> [f64; 2] {
    [order - 0.15, order + 0.15]
}

/// A thousand steps whose roundings differ in two orbits: as far apart as they were after a step, times a shear that
/// grows with the steps.
const SHIFTED: f64 = 1e6 * 8.0 * f64::EPSILON;

/// An exponent from two long steps is off by the next term of the error, and by two where a column gains nothing.
const COLUMN: f64 = 1.0;

/// A column that gains two orders has errors that are smaller by orders of magnitude, one that gains nothing has the same.
const GAIN: f64 = 0.5;

/// Twenty Euler steps, each rounded a few times, in sums whose weights are below nine.
const CORNER: f64 = 20.0 * 4.0 * 9.0 * f64::EPSILON;

/// The exponent of a row.
macro_rules! orders {
    ($($name:literal $says:literal $method:literal $order:literal,)*) => {
        [$(Claim {
            name: $name,
            shown: ("errors", "", ORDER),
            says: $says,
            applies: |_| true,
            value: |study| study.method($method)?.slope,
            within: order($order),
        }),*]
    };
}

pub(super) const ORDERS: &[Claim] = &orders! {
    "leapfrog_order_2" "The leapfrog with staggered momenta has order 2: the exponent of its errors" "leapfrog" 2.0,
    "verlet_order_2" "The error of Verlet falls with the square of the step: its exponent" "Verlet" 2.0,
    "midpoint_order_2" "The explicit midpoint rule has order 2: the exponent" "explicit midpoint" 2.0,
    "implicit_midpoint_order_2" "The implicit midpoint rule has order 2: the exponent" "implicit midpoint" 2.0,
    "gauss_legendre4_order_4" "Two stages of Gauss and Legendre have order 4: the exponent" "Gauss–Legendre 4" 4.0,
    "rk4_order_4" "The classical Runge–Kutta method has order 4: the exponent" "Runge–Kutta 4" 4.0,
    "ab4_order_4" "The formula of Adams and Bashforth has order 4: the exponent" "Adams–Bashforth 4" 4.0,
    "pec4_order_4" "Without the last evaluation it keeps order 4: the exponent" "Adams PEC 4" 4.0,
    "abm4_order_4" "The predictor–corrector of Adams, Bashforth and Moulton has order 4: the exponent" "Adams–Bashforth–Moulton 4" 4.0,
    "yoshida4_order_4" "Yoshida's triple jump has order 4: the exponent" "Yoshida 4" 4.0,
    "blanes_moan6_order_6" "The composition of Blanes and Moan has order 6: the exponent" "Blanes–Moan 6" 6.0,
};

/// The claims about methods of second-order equations, where H is one.
pub(super) const OF_SECOND_ORDER: &[Claim] = &orders! {
    "stoermer4_order_4" "Störmer's formula over four positions has order 4: the exponent" "Störmer 4" 4.0,
    "stoermer_cowell4_order_4" "With Cowell's corrector it has order 4 as well: the exponent" "Störmer–Cowell 4" 4.0,
};

/// The claims about a composition with a force gradient, where there is one.
pub(super) const OF_GRADIENTS: &[Claim] = &orders! {
    "chin_4a_order_4" "Chin's composition with a force gradient has order 4 without a step back: the exponent" "Chin 4A" 4.0,
};

/// The claim about Taylor's method, where there are recurrences.
pub(super) const OF_TAYLOR: &[Claim] = &[Claim {
    name: "taylor_follows_its_tolerance",
    shown: ("work_precision", "", TOLERANCE),
    says: "The errors of Taylor's method fall with its tolerance: the exponent",
    applies: |_| true,
    value: |study| by_tolerance(study, "Taylor"),
    within: [0.5, 1.5],
}];

/// The exponent of the errors of a method against its tolerance.
fn by_tolerance(study: &Study, method: &str) -> Option<f64> {
    let adaptive = study.adaptive.iter().find(|adaptive| adaptive.row.name == method)?;
    let seen: Vec<_> = adaptive.errors.iter().filter(|rung| rung.error > ROUNDED).collect();
    let [first, .., last] = seen[..] else { return None };
    Some((first.error / last.error).ln() / (first.step / last.step).ln())
}

/// Errors below this have as much of rounding in them as of a tolerance.
const ROUNDED: f64 = 1e-12;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        name: "each_column_of_the_extrapolation_gains_two_orders",
        shown: ("extrapolation", "", ORDER),
        says: "Each column of the extrapolation gains two orders: the least excess of the exponents of its errors over 3, 5, 7, 9",
        applies: |_| true,
        value: |study| study.extrapolation.as_ref()?.least_excess(),
        within: [-COLUMN, f64::INFINITY],
    },
    Claim {
        name: "each_column_of_the_extrapolation_is_more_accurate",
        shown: ("extrapolation", "", ORDER),
        says: "Each column of the extrapolation is more accurate than the one before: the largest ratio of their errors in the finest row",
        applies: |_| true,
        value: |study| study.extrapolation.as_ref()?.largest_ratio(),
        within: [0.0, GAIN],
    },
    Claim {
        name: "the_extrapolation_ends_in_gragg_bulirsch_stoer",
        shown: ("extrapolation", "of the orbit", SAME),
        says: "The last entry of the extrapolation is the step of Gragg, Bulirsch and Stoer: the relative distance",
        applies: |_| true,
        value: |study| Some(study.extrapolation.as_ref()?.corner),
        within: [0.0, CORNER],
    },
    Claim {
        name: "verlet_equals_shifted_leapfrog",
        shown: ("shifted", "of the orbit", SAME),
        says: "Verlet is the leapfrog shifted by half a step: the largest relative distance",
        applies: |_| true,
        value: |study| Some(study.shifted.apart),
        within: [0.0, SHIFTED],
    },
    Claim {
        name: "dormand_prince_5_follows_its_tolerance",
        shown: ("adaptive", "", TOLERANCE),
        says: "The errors of the adaptive Runge–Kutta method of Dormand and Prince, order 5, fall with its tolerance: the exponent",
        applies: |_| true,
        value: |study| by_tolerance(study, "Dormand–Prince 5"),
        within: [0.5, 1.5],
    },
    Claim {
        name: "adaptive_runge_kutta_energy_changes",
        shown: ("adaptive", "K", KEEPS),
        says: "Adaptive steps do not conserve the energy: the size of its change with the loosest tolerance that follows the orbit",
        applies: |study| study.resolved,
        value: |study| Some(study.steps.as_ref()?.change.abs()),
        within: [CHANGED, f64::INFINITY],
    },
];
