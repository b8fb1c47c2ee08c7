//! Tests of the laboratory on small runs.

mod claims;
mod pages;
mod pictures;
mod units;

use crate::{Laboratory, Plan, Verdict, claims::verdicts, study::Study};
use integrator_core::prelude::*;
use std::sync::OnceLock;

/// A pendulum with a zero of its energy and with units of length, mass and energy.
struct Pendulum {
    zero: f64,
    length: f64,
    mass: f64,
    weight: f64,
}

#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0] / self.mass
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.weight * (self.zero - (q[0] / self.length).cos())
    }
}

const PENDULUM: Pendulum = Pendulum { zero: 0.0, length: 1.0, mass: 1.0, weight: 1.0 };

/// A Hamiltonian that reads the time, of two coordinates in a list.
struct Driven {
    shake: f64,
    frequency: f64,
}

const DRIVEN: Driven = Driven { shake: 0.1, frequency: 1.0 };

#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        q.iter().map(|q| 0.5 * q * q - self.shake * q.cos() * (self.frequency * t).sin()).sum()
    }
}

fn pendulum() -> Laboratory<'static, Pendulum> {
    let start = Phase::new([2.0], [0.0]);
    Laboratory::new(&PENDULUM, start, 8.35).formula("H = p²/2 − cos q").step(0.1).blob(0.3).plan(Plan::SMALL)
}

fn driven(view: [usize; 2]) -> Laboratory<'static, Driven> {
    let start = Phase::new(vec![1.0, 0.5], vec![0.0, 0.2]);
    Laboratory::new(&DRIVEN, start, 6.5).step(0.1).blob(0.1).view(view).plan(Plan::SMALL)
}

/// The measurements of the pendulum, made once.
fn study() -> Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| pendulum().study().expect("measurements")).clone()
}

/// The measurements of the driven oscillators, made once.
fn driven_study() -> Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| driven([0, 3]).study().expect("measurements")).clone()
}

fn verdict(name: &str, study: &Study) -> Verdict {
    verdicts(study).into_iter().find(|verdict| verdict.name == name).expect("a claim")
}
