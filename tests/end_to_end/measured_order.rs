//! The measured order of a composition: how its error falls with the step.

use crate::slope::slope;

/// Measures the order of a method that claims `order`, given its error over a fixed time in so many steps per look.
///
/// The step is refined until the error has fallen below a bound, and from there on by a factor of 2 in all. The smallest
/// error belongs to a step of about 0.003 for low orders; for high ones it stands out of the rounding of compensated
/// states and of closed forms, some units of 1e-15.
pub(crate) fn observed_order(order: u32, error: impl Fn(u64) -> f64) -> f64 {
    const POINTS: usize = 6;
    const REFINEMENT: f64 = 1.15;
    let order = order as i32;
    let smallest = 0.003_f64.powi(order).max(1e-13);
    let bound = smallest * REFINEMENT.powi(order * (POINTS as i32 - 1));
    let mut points = Vec::new();
    let mut steps = 6.0;
    while points.len() < POINTS {
        assert!(steps < 1e6, "order {order}: the error does not fall below {bound:e}");
        let counted = f64::floor(steps);
        let error = error(counted as u64);
        if error < bound {
            points.push((1.0 / counted, error));
        } else {
            // An error that rises again was small by accident.
            points.clear();
        }
        steps *= REFINEMENT;
    }
    slope(&points)
}

/// Checks that an error falls no slower than with the order that was proved.
///
/// Orders are whole numbers, so half an order less would be a lower one. Methods of order 10 reach the rounding while
/// their steps are still long; they are symmetric, and orders of symmetric methods are even, so 1.5 less would be 8. An
/// error may fall faster for a while, where its leading term happens to be small.
pub(crate) fn assert_order(name: &str, proved: u32, observed: f64) {
    let lowest = f64::from(proved) - if proved < 10 { 0.5 } else { 1.5 };
    assert!(observed > lowest, "{name}: order {proved} was proved, {observed:.3} was measured");
}
