//! The roots of multistep methods on an oscillator: the one that follows the motion, and parasitic ones, which may grow.

use crate::{
    models::Oscillator,
    roots::{Complex, METHODS, sorted, turned},
};
use integrator_core::prelude::*;
use integrator_reference::{AdamsBashforth4, AnyReference};
use nalgebra::ComplexField;

/// The roots of a method for longer and longer steps.
#[derive(Clone, Debug)]
pub(crate) struct Roots {
    pub(crate) name: &'static str,
    /// Those that follow the motion, and the parasitic ones.
    pub(crate) principal: Vec<Complex>,
    pub(crate) parasitic: Vec<Complex>,
    /// The step `hω` from which a root lies outside of the unit circle by a thousandth.
    pub(crate) leaves: Option<f64>,
    /// The exponent by which the principal root approaches `exp(ihω)`.
    pub(crate) exponent: f64,
}

/// What is known of multistep methods.
#[derive(Clone, Debug)]
pub(crate) struct Multistep {
    pub(crate) roots: Vec<Roots>,
    /// The growth per step of Adams and Bashforth on an oscillator, in steps of [`GROWING`], relative to its largest root.
    pub(crate) growth: f64,
}

/// Values of `hω` to a unit, and the longest.
const STEPS: u32 = 100;
const LONGEST: u32 = 150;
/// A step of Adams and Bashforth whose parasitic root grows.
pub(crate) const GROWING: f64 = 0.6;

/// Follows the roots of all multistep methods.
pub(crate) fn multistep() -> Option<Multistep> {
    let roots = METHODS.iter().map(|name| follow(name)).collect::<Option<_>>()?;
    let (principal, parasitic) = sorted(METHODS[0], GROWING)?;
    let largest = principal.iter().chain(&parasitic).map(|root| root.modulus()).fold(0.0, f64::max);
    Some(Multistep { roots, growth: growth()? / largest })
}

fn follow(name: &'static str) -> Option<Roots> {
    let mut roots = Roots { name, principal: Vec::new(), parasitic: Vec::new(), leaves: None, exponent: f64::NAN };
    for step in 1..=LONGEST {
        let x = f64::from(step) / f64::from(STEPS);
        let (principal, parasitic) = sorted(name, x)?;
        let outside = principal.iter().chain(&parasitic).any(|root| root.modulus() > 1.001);
        if outside && roots.leaves.is_none() {
            roots.leaves = Some(x);
        }
        roots.principal.extend(principal);
        roots.parasitic.extend(parasitic);
    }
    let off = |x: f64| {
        let (principal, _) = sorted(name, x)?;
        principal.iter().map(|root| (root - turned(x)).modulus()).reduce(f64::min)
    };
    roots.exponent = (off(0.04)? / off(0.02)?).log2();
    Some(roots)
}

/// The growth per step of the method itself, once its largest root is all that is left.
fn growth() -> Option<f64> {
    const COUNT: u64 = 200;
    let mut run = Oscillator.run_with(AnyReference::from(AdamsBashforth4), Phase::new([1.0], [0.0]), GROWING).ok()?;
    let mut size = || {
        run.advance(COUNT).ok()?;
        let state = run.state();
        Some(f64::hypot(state.q[0], state.p[0]))
    };
    let (first, second) = (size()?, size()?);
    Some((second / first).powf(1.0 / COUNT as f64))
}
