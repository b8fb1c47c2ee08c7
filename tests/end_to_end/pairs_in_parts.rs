//! Parts of H that are sums over pairs of many bodies: they have the layouts of pairs, and move bodies as the formulas say.

use super::beside_pairs::{Parameters, ROUNDING, are_near, narrow};
use integrator_core::prelude::*;

/// A soft sphere within a reach and a bump within a longer one, beside bonds.
macro_rules! molecules {
    ($name:ident: $($arguments:tt)*) => {
        pub(crate) struct $name(Parameters);

        #[hamiltonian($($arguments)*)]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])).sum()
            }
            fn near(&self, q: &[[f64; 3]]) -> f64 {
                let mut sum = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let square = self.square(&q[i], &q[j]);
                        if square < 1.5 {
                            sum += self.0.charges[i] * self.0.charges[j] * (1.5 - square).powi(3);
                        }
                    }
                }
                sum
            }
            fn far(&self, q: &[[f64; 3]]) -> f64 {
                let mut sum = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let square = self.square(&q[i], &q[j]);
                        if square < self.0.cutoff * self.0.cutoff {
                            sum -= (self.0.weights[i] + self.0.weights[j]) * (6.25 - square).powi(2) / 50.0;
                        }
                    }
                }
                sum
            }
            fn bonds(&self, q: &[[f64; 3]]) -> f64 {
                self.0.bonds.iter().map(|bond| {
                    let (a, b) = (&q[bond[0]], &q[bond[1]]);
                    let square = (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2);
                    5.0 * (square.sqrt() - 1.0).powi(2)
                }).sum()
            }
            fn square(&self, a: &[f64; 3], b: &[f64; 3]) -> f64 {
                let mut square = 0.0;
                for d in 0..3 {
                    let x = a[d] - b[d];
                    let x = x - self.0.side * (x / self.0.side).round();
                    square += x * x;
                }
                square
            }
        }
    };
}

molecules!(Parts: split = far + 2 * (near + 4 * (bonds + kinetic)));
molecules!(Once: split = far + 1 * (near + 1 * (bonds + kinetic)));
// The three potentials commute, and are one part.
molecules!(Together: split = kinetic + near + far + bonds, compose = VelocityVerlet);

const STEP: f64 = 0.02;

#[test]
fn they_have_the_layouts_of_pairs() {
    let run = Parts(Parameters::new()).run(Parameters::start(), STEP).expect("a start");
    let layouts: Vec<_> = run.layout().parts().collect();
    assert_eq!(layouts, [("far", "lists"), ("near", "lists"), ("bonds", "terms"), ("kinetic", "plain")]);
    assert!(run.layout().is_listed());
}

#[test]
fn one_inner_step_is_a_step_of_all_forces_together() {
    let start = Parameters::start();
    let mut once = Once(Parameters::new()).run(start.clone(), STEP).expect("a start");
    let mut together = Together(Parameters::new()).run(start, STEP).expect("a start");
    for _ in 0..3 {
        once.advance(4).expect("finite");
        together.advance(4).expect("finite");
        are_near(&once.state().p, &together.state().p, ROUNDING);
        let (energy, expected) = (once.energy(), together.energy());
        assert!((energy - expected).abs() <= ROUNDING * once.potential().abs(), "{energy} for {expected}");
    }
}

#[test]
fn a_member_of_an_ensemble_has_the_bits_of_its_run() {
    let systems = || {
        (0..5).map(|number| {
            let mut parameters = Parameters::new();
            parameters.charges[7] += 0.1 * f64::from(number);
            Parts(parameters)
        })
    };
    let start = Parameters::start();
    let mut ensemble = Ensemble::new(Verlet, systems().map(|system| (system, start.clone())), STEP).expect("starts");
    ensemble.advance(6).expect("finite");
    for (system, state) in systems().zip(ensemble.states()) {
        let mut run = system.run(start.clone(), STEP).expect("a start");
        run.advance(2).expect("finite");
        run.advance(4).expect("finite");
        assert_eq!(run.state(), state);
    }
}

#[test]
fn other_precisions_follow() {
    let start = Parameters::start();
    let system = Parts(Parameters::new());
    let mut exact = system.run(start.clone(), STEP).expect("a start");
    exact.advance(8).expect("finite");
    let mut single = system.run(narrow(&start), STEP).expect("a start");
    single.advance(8).expect("finite");
    let widened: Vec<[f64; 3]> = single.state().p.iter().map(|p| p.map(f64::from)).collect();
    are_near(&widened, &exact.state().p, ROUNDING * f64::from(f32::EPSILON) / f64::EPSILON);
    let mut compensated = system.run(Phase::compensated(start.q, start.p), STEP).expect("a start");
    compensated.advance(8).expect("finite");
    let rounded: Vec<[f64; 3]> = compensated.state().p.iter().map(|p| p.map(|p| p.value)).collect();
    are_near(&rounded, &exact.state().p, ROUNDING);
}

#[test]
fn deviation_vectors_are_derivatives() {
    let (system, start) = (Parts(Parameters::new()), Parameters::start());
    let moved = |size: f64| {
        let mut start = start.clone();
        start.q[11][1] += size;
        let mut run = system.run(start, STEP).expect("a start");
        run.advance(5).expect("finite");
        run.state().p
    };
    let mut vector = Phase::new(vec![[0.0; 3]; start.q.len()], vec![[0.0; 3]; start.q.len()]);
    vector.q[11][1] = 1.0;
    let mut tangent = system.tangent(Verlet, start.clone(), [vector], STEP).expect("a start");
    tangent.advance(5).expect("finite");
    // Differences are off by a rounding over their size, and by its square times a third derivative of about one.
    let size: f64 = 1e-5;
    let (after, before) = (moved(size), moved(-size));
    let differences: Vec<[f64; 3]> = after
        .iter()
        .zip(&before)
        .map(|(after, before)| [0, 1, 2].map(|d| (after[d] - before[d]) / (2.0 * size)))
        .collect();
    are_near(&tangent.vectors()[0].p, &differences, 1e3 * size * size + 1e3 * f64::EPSILON / size);
}
