//! This library's curves.

use crate::fields::distance;
use integrator_bench::{precision::Curve, starts::Problem};
use integrator_core::{Compensated, Coords, Run, prelude::*};
use std::hint::black_box;

/// How often the energy is looked at along a run.
const LOOKS: u64 = 256;

/// The curves of a choice of the catalogue on one problem.
pub(crate) struct Ours<'p, H: Hamiltonian> {
    problem: &'p Problem<H>,
    evaluations: u64,
    curves: Vec<Curve>,
}

impl<H: Hamiltonian> Ours<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    /// Runs in doubles.
    fn plain<X: Composition<H>>(&mut self, composition: X) {
        let start = || self.problem.start.clone();
        let run = |h| self.problem.system.run_with::<f64, X>(composition, start(), h);
        let curve = self.curve(X::NAME.to_owned(), X::FORCE_EVALUATIONS, run, |leaf| leaf);
        self.curves.push(curve);
    }

    /// Runs that carry the rounding error of every update.
    fn compensated<X: Composition<H>>(&mut self, composition: X) {
        let start = || Phase::compensated(self.problem.start.q.clone(), self.problem.start.p.clone());
        let run = |h| self.problem.system.run_with::<Compensated<f64>, X>(composition, start(), h);
        let name = format!("{}, compensated", X::NAME);
        let curve = self.curve(name, X::FORCE_EVALUATIONS, run, |leaf| leaf.value + leaf.carried);
        self.curves.push(curve);
    }

    fn curve<C: Coords>(
        &self,
        name: String,
        forces: usize,
        start: impl Fn(f64) -> Result<Run<C>, Error>,
        number: impl Fn(C::Leaf) -> f64,
    ) -> Curve {
        let Problem { span, reference, .. } = self.problem;
        let steps = |level: u32| (self.evaluations / forces as u64).next_power_of_two() << level;
        let errors = |level| {
            let steps = steps(level);
            let run = start(span / steps as f64).ok()?;
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
            let mut run = start(span / steps as f64).expect("a start");
            // Runs that diverge were dropped above.
            black_box(run.advance(steps).is_ok());
            black_box(run.state());
        };
        Curve::measure(name, true, 0..14, errors, timed)
    }
}

/// `evaluations` is how many forces the longest steps take.
pub(crate) fn curves<H: integrator_core::QuadraticKinetic>(problem: &Problem<H>, evaluations: u64) -> Vec<Curve>
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
    ours.curves
}
