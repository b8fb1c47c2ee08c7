//! Work–precision curves of this library.

use integrator_bench::{precision::Curve, starts::Problem};
use integrator_core::{
    Compensated, Coords, Method, Run,
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use integrator_peers::fields::distance;
use std::{hint::black_box, ops::Range};

/// Number of energy samples per run.
const LOOKS: u64 = 256;

/// Prefix of the names of Taylor curves.
pub(crate) const TAYLOR: &str = "Taylor";

/// Curves of selected methods on one problem.
pub(crate) struct Ours<'p, H: Hamiltonian> {
    problem: &'p Problem<H>,
    evaluations: u64,
    curves: Vec<Curve>,
}

impl<H: Hamiltonian> Ours<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    /// Measures a composition with plain `f64` states.
    fn plain<X: Composition<H>>(&mut self, composition: X) {
        let start = || self.problem.start.clone();
        let run = |h| self.problem.system.run_with::<f64, X>(composition, start(), h);
        let curve = self.curve(X::NAME.to_owned(), self.steps(X::FORCE_EVALUATIONS), run, |leaf| leaf);
        self.curves.push(curve);
    }

    /// Measures a composition with compensated states.
    fn compensated<X: Composition<H>>(&mut self, composition: X) {
        let start = || Phase::compensated(self.problem.start.q.clone(), self.problem.start.p.clone());
        let run = |h| self.problem.system.run_with::<Compensated<f64>, X>(composition, start(), h);
        let name = format!("{}, compensated", X::NAME);
        let curve = self.curve(name, self.steps(X::FORCE_EVALUATIONS), run, |leaf| leaf.value + leaf.carried);
        self.curves.push(curve);
    }

    /// Measures Taylor's method of one order with decreasing tolerances. It chooses its own steps between samples.
    fn taylor(&mut self, order: usize)
    where
        Taylor: Method<H>,
    {
        let Problem { system, start, span, .. } = self.problem;
        let run = |level: u32| {
            let method = Taylor::tolerance(10.0_f64.powf(-4.0 - f64::from(level))).with_order(order);
            let start = Phase::compensated(start.q.clone(), start.p.clone());
            system.run_with::<Compensated<f64>, _>(method, start, span / LOOKS as f64)
        };
        let looks = |_: u32| LOOKS;
        let curve = self
            .curve_over(format!("{TAYLOR} {order}, compensated"), 0..16, looks, run, |leaf| leaf.value + leaf.carried);
        self.curves.push(curve);
    }

    /// Returns the number of steps at each level for a composition with `forces` force evaluations per step.
    fn steps(&self, forces: usize) -> impl Fn(u32) -> u64 + use<H> {
        let coarsest = (self.evaluations / forces as u64).next_power_of_two();
        move |level| coarsest << level
    }

    fn curve<C: Coords>(
        &self,
        name: String,
        steps: impl Fn(u32) -> u64,
        start: impl Fn(f64) -> Result<Run<C>, Error>,
        number: impl Fn(C::Leaf) -> f64,
    ) -> Curve {
        let span = self.problem.span;
        self.curve_over(name, 0..14, &steps, |level| start(span / steps(level) as f64), number)
    }

    fn curve_over<C: Coords>(
        &self,
        name: String,
        levels: Range<u32>,
        steps: impl Fn(u32) -> u64,
        start: impl Fn(u32) -> Result<Run<C>, Error>,
        number: impl Fn(C::Leaf) -> f64,
    ) -> Curve {
        let reference = &self.problem.reference;
        let errors = |level| {
            let steps = steps(level);
            let run = start(level).ok()?;
            let energy = run.energy();
            let (mut worst, mut end) = (0.0_f64, None);
            let every = (steps / LOOKS).max(1);
            for sample in run.samples(every).take((steps / every) as usize + 1) {
                let sample = sample.ok()?;
                worst = worst.max((sample.energy() / energy - 1.0).abs());
                end = Some(sample.state);
            }
            let q: Vec<f64> = end?.q.flat().iter().map(|leaf| number(*leaf)).collect();
            Some([worst, distance(&q, &reference[..q.len()])])
        };
        let timed = |level| {
            let steps = steps(level);
            let mut run = start(level).expect("a start");
            // Runs that diverge were dropped above.
            black_box(run.advance(steps).is_ok());
            black_box(run.state());
        };
        Curve::measure(name, true, levels, errors, timed)
    }
}

/// Measures all curves. `evaluations` is the number of force evaluations with the longest steps.
pub(crate) fn curves<H: Hamiltonian + integrator_core::QuadraticKinetic + Recurrences>(
    problem: &Problem<H>,
    evaluations: u64,
) -> Vec<Curve>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut ours = Ours { problem, evaluations, curves: Vec::new() };
    ours.plain(Verlet);
    ours.plain(Yoshida4);
    ours.plain(BlanesMoanSrkn6);
    ours.plain(BlanesMoanSrkn11);
    ours.plain(BlanesMoanSrkn14);
    ours.plain(KahanLi8);
    ours.plain(Teloy8C);
    ours.plain(SofroniouSpaletta10);
    ours.compensated(BlanesMoanSrkn14);
    ours.compensated(Teloy8C);
    ours.compensated(SofroniouSpaletta10);
    ours.taylor(16);
    ours.taylor(20);
    ours.taylor(24);
    ours.curves
}
