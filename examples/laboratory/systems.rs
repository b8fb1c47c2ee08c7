//! The systems that the laboratory knows, one row each. To add your own: an annotated impl, and a row in [`SYSTEMS`].

use crate::{
    plan::Plan,
    problem::Problem,
    study::{Study, measure},
};
use integrator_core::prelude::*;
use std::{error::Error, f64::consts::TAU};

/// A name, and how the system of this name is measured.
pub(crate) struct System {
    pub(crate) name: &'static str,
    pub(crate) measure: fn(&Plan) -> Result<Study, Box<dyn Error>>,
}

/// One row for each system. The first one is taken if none is named.
pub(crate) const SYSTEMS: &[System] = &[
    System {
        name: "pendulum",
        measure: |plan| {
            let problem = Problem {
                system: Pendulum,
                formula: "H = p²/2 − cos q, from the angle 2 at rest",
                start: Phase::new([2.0], [0.0]),
                period: 8.35,
                step: 0.1,
                blob: 0.3,
                view: [0, 1],
            };
            measure(&problem, plan)
        },
    },
    System {
        name: "oscillator",
        measure: |plan| {
            let problem = Problem {
                system: Oscillator,
                formula: "H = p²/2 + q²/2, from q = 1 at rest",
                start: Phase::new([1.0], [0.0]),
                period: TAU,
                step: 0.1,
                blob: 0.3,
                view: [0, 1],
            };
            measure(&problem, plan)
        },
    },
    System {
        name: "henon_heiles",
        measure: |plan| {
            let problem = Problem {
                system: HenonHeiles,
                formula: "H = (px² + py² + x² + y²)/2 + x²y − y³/3, of energy 0.088",
                start: Phase::new([0.1, 0.1], [0.3, 0.25]),
                period: 6.5,
                step: 0.05,
                blob: 0.05,
                view: [0, 2],
            };
            measure(&problem, plan)
        },
    },
    System {
        name: "kepler",
        measure: |plan| {
            let problem = Problem {
                system: Kepler,
                formula: "H = (px² + py²)/2 − 1/r, from the aphelion of an ellipse of eccentricity 0.3",
                start: Phase::new([1.3, 0.0], [0.0, (0.7_f64 / 1.3).sqrt()]),
                period: TAU,
                step: 0.02,
                blob: 0.02,
                view: [0, 1],
            };
            measure(&problem, plan)
        },
    },
    System {
        name: "double_well",
        measure: |plan| {
            let problem = Problem {
                system: DoubleWell,
                formula: "H = p²/2 + (q² − 1)²/4, from q = 1.5 at rest, above the hill between the wells",
                start: Phase::new([1.5], [0.0]),
                period: 8.3,
                step: 0.1,
                blob: 0.03,
                view: [0, 1],
            };
            measure(&problem, plan)
        },
    },
];

pub(crate) struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

pub(crate) struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

pub(crate) struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    pub(crate) fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

struct DoubleWell;

#[hamiltonian]
impl DoubleWell {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.25 * (q[0] * q[0] - 1.0).powi(2)
    }
}
