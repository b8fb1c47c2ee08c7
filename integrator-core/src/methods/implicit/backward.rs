//! The implicit method of Euler, to compare with.

use super::{
    Implicit, TakesWhole, iteration,
    tableau::{self, Tableau, one_stage},
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

implicit! {
    /// The solution of `z = y + h f(z)`. A harmonic oscillator keeps the share `1/(1 + (h·ω)²)` of its energy in each
    /// step. Stable for every step where the motion oscillates.
    BackwardEuler: order 1, symmetric false, stages one_stage(1.0);
}
