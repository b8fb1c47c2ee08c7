//! The implicit method of Euler, to compare with.

use super::{
    TakesWhole,
    tableau::{EULER, Stages, Tableau},
};
use crate::trajectory::method::{Described, Facts};

/// The solution of `z = y + h f(z)`. A harmonic oscillator keeps the share `1/(1 + (h·ω)²)` of its energy in each
/// step. Stable for every step where the motion oscillates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BackwardEuler;

impl Described for BackwardEuler {
    fn facts(self) -> Facts {
        Facts {
            name: "BackwardEuler",
            order: 1,
            stability_limit: Some(f64::INFINITY),
            roundings: 16,
            ..Facts::UNCLAIMED
        }
    }
}

#[diagnostic::do_not_recommend]
impl TakesWhole for BackwardEuler {}

impl Stages<1> for BackwardEuler {
    const TABLEAU: Tableau<1> = EULER;
}
