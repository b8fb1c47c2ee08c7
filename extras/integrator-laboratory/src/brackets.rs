//! The Poisson bracket after one step, along the orbit, and what it is by formula.
//!
//! A step of forward Euler has the derivative `M = 1 + h F'`, so that `{q, p} = det M = 1 + h² T'' V''`. Backward Euler is its
//! inverse from the end of the step. A kick followed by a drift is a product of two shears, whose bracket is 1. See Hairer, Lubich
//! and Wanner, Geometric Numerical Integration (2006), section VI.3.

use crate::problem::{Problem, Stepped};
use integrator_core::{check::TangentMap, prelude::*};
use integrator_reference::{AnyReference, BackwardEuler, ForwardEuler};

/// The brackets of a method after single steps from points of the orbit.
#[derive(Clone, Debug)]
pub(crate) struct Brackets {
    pub(crate) name: &'static str,
    /// The time of the point in periods, and the bracket after a step from there.
    pub(crate) measured: Vec<(f64, f64)>,
    /// The same by formula.
    pub(crate) formula: Vec<(f64, f64)>,
}

impl Brackets {
    /// The largest difference, relative to the bracket where that is large.
    pub(crate) fn off(&self) -> f64 {
        let pairs = self.measured.iter().zip(&self.formula);
        pairs
            .map(|((_, measured), (_, formula))| (measured - formula).abs() / formula.abs().max(1.0))
            .fold(0.0, f64::max)
    }
}

/// Points of a period, and of the orbit between two of them.
const POINTS: u32 = 40;

/// Measures brackets of Euler's methods; none if `H` is no `T(p) + V(q)`, or a step has no end. The formula for backward Euler is
/// that of one degree of freedom without a drive, whose force at the end of the step is another one.
pub(crate) fn brackets<H: Hamiltonian>(problem: &Problem<'_, H>) -> Option<Vec<Brackets>> {
    if !H::SEPARABLE {
        return None;
    }
    let (n, h) = (problem.freedom(), problem.step);
    let map = |method: &dyn Stepped<H::Coords>, from: &Phase<H::Coords>| -> Option<TangentMap> {
        method.maps(from, h, 1).ok()?.pop()
    };
    // h² T'' V'' from a drift and a kick at one point: blocks of the derivatives of the two symplectic Euler methods.
    let sheared = |at: &Phase<H::Coords>| -> Option<f64> {
        let [drift, kick] =
            [map(&*problem.by(EulerAdjoint), at)?, map(&*problem.by(Euler), at)?].map(|map| map.matrix());
        Some(-(0..n).map(|k| drift[k][n] * kick[n + k][0]).sum::<f64>())
    };
    let orbit = problem.run(KahanLi8, &problem.start, problem.period / f64::from(POINTS)).ok()?;
    let states: Vec<_> = orbit.samples(1).take(POINTS as usize + 1).map_while(Result::ok).collect();
    let row = |name, method: &dyn Stepped<H::Coords>, formula: &dyn Fn(&Phase<H::Coords>) -> Option<f64>| {
        let mut brackets = Brackets { name, measured: Vec::new(), formula: Vec::new() };
        for sample in &states {
            let periods = sample.time / problem.period;
            brackets.measured.push((periods, map(method, &sample.state)?.bracket(0)?));
            brackets.formula.push((periods, formula(&sample.state)?));
        }
        Some(brackets)
    };
    let backward = problem.by(BackwardEuler);
    let inverse = |from: &Phase<H::Coords>| {
        let mut run = backward.run(from, h).ok()?;
        run.advance(1).ok()?;
        Some(1.0 / (1.0 + sheared(&run.state())?))
    };
    let forward = problem.by(AnyReference::from(ForwardEuler));
    let mut rows = vec![
        row("forward Euler", &*forward, &|from| Some(1.0 + sheared(from)?))?,
        row("symplectic Euler", &*problem.by(Euler), &|_| Some(1.0))?,
    ];
    if n == 1 && H::AUTONOMOUS {
        rows.push(row("backward Euler", &*backward, &inverse)?);
    }
    Some(rows)
}
