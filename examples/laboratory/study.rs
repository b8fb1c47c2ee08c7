//! Everything that is measured of a system, as plain numbers: pictures, claims and the page come from these alone.

use crate::{
    errors::exact,
    measured::Measured,
    methods::{self, Adaptive},
    plan::Plan,
    problem::{Problem, name},
    shifted::verlet_against_leapfrog,
    systems::System,
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// The measurements of a system.
pub(crate) struct Study {
    /// The name of its row.
    pub(crate) system: &'static str,
    pub(crate) formula: &'static str,
    /// Whether its energy is conserved.
    pub(crate) autonomous: bool,
    pub(crate) freedom: usize,
    pub(crate) step: f64,
    /// What portraits show along and up.
    pub(crate) view: [String; 2],
    /// The least and the greatest of each of these on the exact orbit.
    pub(crate) extents: [[f64; 2]; 2],
    pub(crate) methods: Vec<Measured>,
    pub(crate) adaptive: Vec<Adaptive>,
    /// By how much Verlet's inner half steps differ from the leapfrog.
    pub(crate) shifted: f64,
}

impl System {
    /// Measures the system.
    pub(crate) fn study(&self, plan: &Plan) -> Result<Study, Box<dyn Error>> {
        Ok(Study { system: self.name, ..(self.measure)(plan)? })
    }
}

impl Study {
    /// The measurements of a method.
    pub(crate) fn method(&self, name: &str) -> Option<&Measured> {
        self.methods.iter().find(|measured| measured.name == name)
    }
}

/// Measures a system.
pub(crate) fn measure<H: Hamiltonian>(problem: &Problem<H>, plan: &Plan) -> Result<Study, Box<dyn Error>> {
    let freedom = problem.start.q.flat().len();
    if let Some(index) = problem.view.iter().find(|index| **index >= 2 * freedom) {
        return Err(format!("a view of coordinate {index}: there are {freedom} positions, then as many momenta").into());
    }
    let exact = exact(problem)?;
    let extent = |index: usize| {
        let numbers = exact.orbit.iter().map(|state| state[index]);
        let (least, most) =
            numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        [least, most]
    };
    Ok(Study {
        // The row knows it.
        system: "",
        formula: problem.formula,
        autonomous: H::AUTONOMOUS,
        freedom,
        step: problem.step,
        view: problem.view.map(|index| name(index, freedom)),
        extents: problem.view.map(extent),
        methods: methods::all(problem, plan, &exact)?,
        adaptive: methods::adaptive(problem, plan, &exact)?,
        shifted: verlet_against_leapfrog(problem)?,
    })
}
