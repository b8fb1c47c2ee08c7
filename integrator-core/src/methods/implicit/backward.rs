//! The implicit method of Euler, to compare with.

use super::{
    TakesWhole, iteration,
    motion::Implicit,
    tableau::{EULER, Stages, Tableau},
};
use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System},
    trajectory::{
        method::{Described, Differentiable, Facts, Memoryless, Method, Resumable},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;

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

implicit!([] BackwardEuler, 1 stages);

impl Stages<1> for BackwardEuler {
    const TABLEAU: Tableau<1> = EULER;
}
