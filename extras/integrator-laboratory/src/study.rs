//! All measurements of a system as plain numbers, from which pictures, claims and the page are made.

use crate::{
    adaptive::{Steps, steps},
    brackets::{Brackets, brackets},
    claims::CHANGED,
    equations::readable,
    errors::exact,
    extrapolation::{Extrapolation, extrapolation},
    measured::Measured,
    methods::{self, Adaptive},
    models::{Models, models},
    modified::Modified,
    plan::Plan,
    problem::{Problem, numbers},
    shifted::{Shifted, verlet_against_leapfrog},
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// The measurements of a system.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) system: String,
    /// Whether the energy of the system is conserved.
    pub(crate) autonomous: bool,
    /// Whether it is, and its rounding is small enough for the claims about it.
    pub(crate) resolved: bool,
    pub(crate) freedom: usize,
    /// The symbols of the coordinates, and where they start.
    pub(crate) symbols: Vec<String>,
    pub(crate) start: Vec<f64>,
    /// The energies and the equations of motion in these symbols; empty if they are long.
    pub(crate) equations: Vec<String>,
    /// The unit of energies: the largest kinetic energy.
    pub(crate) unit: f64,
    pub(crate) step: f64,
    pub(crate) period: f64,
    /// The number of oscillations of a drive in a period, one at least, and half the period of the drive.
    pub(crate) cycles: u32,
    pub(crate) half_drive: Option<f64>,
    /// The labels of the axes of portraits, horizontal and vertical.
    pub(crate) view: [String; 2],
    /// Whether they are angles.
    pub(crate) is_angle: [bool; 2],
    /// The orbit in this view, to more digits than are seen.
    pub(crate) orbit: Vec<(f64, f64)>,
    pub(crate) methods: Vec<Measured>,
    pub(crate) adaptive: Vec<Adaptive>,
    /// The quantities that symplectic compositions conserve; empty where `H` is not conserved or no `T(p) + V(q)`.
    pub(crate) modified: Vec<Modified>,
    /// One long step, extrapolated.
    pub(crate) extrapolation: Option<Extrapolation>,
    /// Verlet's inner half steps, and the leapfrog.
    pub(crate) shifted: Shifted,
    /// The steps of an adaptive method.
    pub(crate) steps: Option<Steps>,
    /// What is the same for all systems.
    pub(crate) models: Models,
    /// The brackets of single steps, and the text of `T'' V''`.
    pub(crate) brackets: Option<Vec<Brackets>>,
    pub(crate) curvature: String,
}

/// Steps of this orbit to a period, or to one of a drive.
const ORBIT: f64 = 64.0;

impl Study {
    /// `{q₁, p₁}` in the symbols of the system.
    pub(crate) fn bracket(&self) -> String {
        format!("{{{}, {}}}", self.symbols[0], self.symbols[self.freedom])
    }

    /// Whether a method was measured, with fixed steps or with steps of its own.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.method(name).is_some() || self.adaptive.iter().any(|adaptive| adaptive.row.name == name)
    }

    /// The measurements of a method.
    pub(crate) fn method(&self, name: &str) -> Option<&Measured> {
        self.methods.iter().find(|measured| measured.name() == name)
    }
}

/// Measures a system.
pub(crate) fn measure<H: Hamiltonian>(
    system: String,
    problem: &Problem<'_, H>,
    plan: &Plan,
) -> Result<Study, Box<dyn Error>> {
    let freedom = problem.freedom();
    let count = numbers(&problem.start).len();
    if let Some(index) = problem.view.iter().find(|index| **index >= count) {
        return Err(format!("a view of coordinate {index}: there are {freedom} positions, then as many momenta").into());
    }
    let exact = exact(problem)?;
    // For as long as portraits last, in steps whose error is not seen; of a fast drive as many points, and a period.
    let per_period = ORBIT * f64::from(problem.cycles());
    let points = (plan.periods * ORBIT).max(per_period) as usize + 1;
    let orbit = problem.run(KahanLi8, &problem.start, problem.period / per_period)?.samples(1).take(points);
    let methods = methods::all(problem, plan, &exact)?;
    let modified = methods::modified(problem, plan, &exact, &methods);
    Ok(Study {
        system,
        autonomous: H::AUTONOMOUS,
        resolved: H::AUTONOMOUS && exact.rounding(ORBIT as usize) < CHANGED,
        freedom,
        symbols: problem.symbols.clone(),
        start: numbers(&problem.start),
        equations: H::EQUATIONS.iter().map(|line| readable(line, &problem.symbols, H::Coords::COMPONENTS)).collect(),
        unit: exact.motion,
        step: problem.step,
        period: problem.period,
        cycles: problem.cycles(),
        half_drive: (problem.turns > 0).then(|| problem.period / problem.turns as f64),
        view: problem.view.map(|index| problem.symbols[index].clone()),
        is_angle: problem.view.map(|index| problem.angles.contains(&index)),
        orbit: orbit.map_while(Result::ok).map(|sample| problem.seen(&sample.state)).collect(),
        methods,
        adaptive: methods::adaptive(problem, plan, &exact)?,
        modified,
        extrapolation: extrapolation(problem, &exact),
        shifted: verlet_against_leapfrog(problem, &exact)?,
        steps: steps(problem, plan, &exact),
        models: models(),
        brackets: brackets(problem),
        curvature: problem.curvature.clone(),
    })
}
