//! The systems of the course, one row each.

use crate::{oscillator, period, section, stiff};
use integrator_core::prelude::*;
use integrator_laboratory::{Laboratory, Plan, Report};
use std::{error::Error, f64::consts::TAU, path::Path};

/// Report of a page, or the error.
pub(crate) type Outcome = Result<Report, Box<dyn Error>>;

/// Name of a system and the function that writes its page.
pub(crate) struct System {
    pub(crate) name: &'static str,
    pub(crate) report: fn(&Plan, &Path) -> Outcome,
}

/// All systems; the first one is the default.
pub(crate) const SYSTEMS: [System; 6] = [
    System {
        name: "pendulum",
        report: |plan, folder| {
            let periods = period::all(plan.rungs.min(7));
            Laboratory::new(&Pendulum, Phase::new([2.0], [0.0]), 8.35)
                .called("pendulum")
                .formula("H = ω²/2 − cos θ, a pendulum in natural units, from the angle 2 at rest")
                .symbols(["θ", "ω"])
                .angle(0)
                .step(0.1)
                .blob(0.3)
                .plan(*plan)
                .claim(period::claim(&periods))
                .picture("period", period::picture(&periods))
                .report(folder)
        },
    },
    System {
        name: "oscillator",
        report: |plan, folder| {
            let laboratory = Laboratory::new(&Oscillator, Phase::new([1.0], [0.0]), TAU)
                .called("oscillator")
                .formula("H = p²/2 + q²/2, from q = 1 at rest")
                .step(0.1)
                .blob(0.3)
                .plan(*plan);
            oscillator::claims().into_iter().fold(laboratory, Laboratory::claim).report(folder)
        },
    },
    System {
        name: "henon_heiles",
        report: |plan, folder| {
            // As many crossings as the portraits have periods, up to a factor.
            let sections = section::all((60.0 * plan.periods) as usize)?;
            Laboratory::new(&HenonHeiles, Phase::new([0.1, 0.1], [0.3, 0.25]), 6.5)
                .called("henon_heiles")
                .formula("H = (px² + py² + x² + y²)/2 + x²y − y³/3, of energy 0.088")
                .step(0.05)
                .blob(0.05)
                .view([0, 2])
                .plan(*plan)
                .claim(section::claim(&sections))
                .picture("section", section::picture(&sections))
                .report(folder)
        },
    },
    System {
        name: "kepler",
        report: |plan, folder| {
            Laboratory::new(&Kepler, Phase::new([1.3, 0.0], [0.0, (0.7_f64 / 1.3).sqrt()]), TAU)
                .called("kepler")
                .formula("H = (px² + py²)/2 − 1/r, from the aphelion of an ellipse of eccentricity 0.3")
                .step(0.02)
                .blob(0.02)
                .plan(*plan)
                .report(folder)
        },
    },
    System {
        name: "double_well",
        report: |plan, folder| {
            Laboratory::new(&DoubleWell, Phase::new([1.5], [0.0]), 8.3)
                .called("double_well")
                .formula("H = p²/2 + (q² − 1)²/4, from q = 1.5 at rest, above the hill between the wells")
                .step(0.1)
                .blob(0.03)
                .plan(*plan)
                .report(folder)
        },
    },
    System { name: "stiff", report: |plan, folder| stiff::report(plan, folder) },
];

pub(crate) struct Pendulum;

#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

pub(crate) struct Oscillator;

#[hamiltonian(taylor)]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

pub(crate) struct HenonHeiles;

#[hamiltonian(taylor)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    pub(crate) fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

struct Kepler;

#[hamiltonian(taylor)]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

struct DoubleWell;

#[hamiltonian(taylor)]
impl DoubleWell {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.25 * (q[0] * q[0] - 1.0).powi(2)
    }
}
