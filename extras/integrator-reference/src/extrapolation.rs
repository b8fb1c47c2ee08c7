//! Extrapolation: one step by finer and finer modified midpoint steps, extrapolated to step zero.

use crate::walk::{Place, Recipe, combined};
use integrator_core::{__private::Real, Described, Facts, Unsolved};

/// Into how many midpoint steps a step is divided. Errors of the modified midpoint rule have even powers alone where
/// that is even (Gragg 1965), so that each column gains two orders.
const DIVISIONS: [u32; 4] = [2, 4, 6, 8];

/// The extrapolation method of Gragg (1965) and Bulirsch and Stoer (1966), with four columns and a fixed step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GraggBulirschStoer;

impl Described for GraggBulirschStoer {
    fn facts(self) -> Facts {
        // All divisions share the field at the beginning.
        let forces = 1 + DIVISIONS.iter().map(|division| *division as usize - 1).sum::<usize>();
        facts! {
        name: "GraggBulirschStoer",
        order: 2 * DIVISIONS.len() as u32,
        forces: Some(forces),
        roundings: 2 * forces }
    }
}

impl Recipe for GraggBulirschStoer {
    type Memory<R: Real> = ();

    fn increment<R: Real>(self, _: &mut (), from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let slope = from.derivative();
        let mut row: Vec<Vec<R>> = Vec::new();
        for (j, division) in DIVISIONS.iter().enumerate() {
            // Aitken and Neville: T(j, k) = T(j, k-1) + (T(j, k-1) - T(j-1, k-1)) / ((n(j) / n(j-k))² - 1).
            let mut next = vec![midpoints(*division, &slope, from)];
            for k in 1..=j {
                let ratio = f64::from(*division) / f64::from(DIVISIONS[j - k]);
                let share = 1.0 / (ratio * ratio - 1.0);
                next.push(combined(1.0, &[(1.0 + share, &next[k - 1][..]), (-share, &row[k - 1][..])]));
            }
            row = next;
        }
        Ok(row.pop().unwrap_or_default())
    }
}

/// Returns the increment by this number of steps of the modified midpoint rule: an Euler step, then corrections over
/// two.
fn midpoints<R: Real>(division: u32, slope: &[R], from: &Place<'_, R>) -> Vec<R> {
    let step = from.h / f64::from(division);
    let mut before = combined(0.0, &[(0.0, slope)]);
    let mut increment = combined(step, &[(1.0, slope)]);
    for number in 1..division {
        let slope = from.field.derivative(&from.moved(&increment), from.time + f64::from(number) * step);
        let after = combined(1.0, &[(1.0, &before[..]), (2.0 * step, &slope[..])]);
        before = std::mem::replace(&mut increment, after);
    }
    increment
}
