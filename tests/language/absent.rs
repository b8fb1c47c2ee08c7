//! Coordinates and elements of lists that are not there, read in branches that are not taken: Rust does not evaluate these, and
//! neither do steps.

use crate::{close, kicked};
use integrator_core::{check::gradient_error, prelude::*};

/// The system of a row, or of several, whose energies are added.
macro_rules! system {
    (|$q:ident, $system:ident| $($options:ident)?: $($energy:expr),+) => {
        struct System {
            one: f64,
            first: bool,
            list: Vec<f64>,
        }

        #[hamiltonian $(($options))?]
        impl System {
            fn kinetic(&self, p: &[f64]) -> f64 {
                p.iter().map(|p| p * p / 2.0).sum()
            }
            fn potential(&self, $q: &[f64]) -> f64 {
                let $system = self;
                let energy = 0.0 $(+ $energy)+;
                energy
            }
        }

        fn system() -> System {
            System { one: 1.0, first: true, list: Vec::new() }
        }
    };
}

/// Potentials of a single coordinate `q[0]` with the number `one = 1`, the flag `first`, which holds, and a `list` without elements; their
/// derivatives at -0.5.
macro_rules! absent {
    (|$q:ident, $system:ident| $($name:ident: $energy:expr, $derivative:expr;)+) => {
        $(mod $name {
            use super::*;

            system!(|$q, $system| : $energy);

            #[test]
            fn kicks_read_only_the_elements_of_the_function() {
                let derivative: f64 = $derivative;
                let (gradient, energy) = kicked(&system(), vec![-0.5], 0.0);
                close(&[energy], &[system().potential(&[-0.5])]);
                close(&gradient, &[derivative]);
            }
        })+

        /// The sum of all of them by each kind of run.
        mod together {
            use super::*;

            system!(|$q, $system| taylor: $($energy),+);

            #[test]
            fn steps_read_only_the_elements_of_the_function() {
                let (system, start) = (system(), Phase::new(vec![-0.5], vec![0.0]));
                let derivative: f64 = [$($derivative),+].iter().sum();
                let mut run = system.run_with(Euler, start.clone(), 1.0).expect("a run");
                let energy = run.energy();
                close(&[energy], &[system.potential(&start.q)]);
                run.advance(1).expect("a step");
                close(&run.state().p, &[-derivative]);
                let mut series = system.run_with(Taylor::tolerance(1e-12), start.clone(), 0.01).expect("a run");
                series.advance(2).expect("steps");
                // The energy is conserved to the tolerance of each step.
                assert!((series.energy() - energy).abs() < 1e-11);
                let members = (0..5).map(|_| (self::system(), start.clone()));
                let mut swarm = Ensemble::new(Euler, members, 1.0).expect("members");
                swarm.advance(1).expect("a step");
                assert!(swarm.states().all(|state| state == run.state()));
                let mut tangent = system.tangent(Verlet, start.clone(), [start.clone()], 0.01).expect("a tangent");
                tangent.advance(1).expect("a step");
                assert!(gradient_error(&system, start, 0.0).is_ok_and(|error| error < 128.0 * f64::EPSILON));
            }
        }
    };
}

absent! {
    |q, system|
    behind_an_if: if q[0] < 0.0 { q[0] } else { q[1] }, 1.0;
    behind_a_flag: if system.first { q[0].sin() } else { q[0] * q[1] }, (-0.5_f64).cos();
    behind_the_length: if q.len() > 1 && q[1] > 0.0 { q[1] } else { q[0] }, 1.0;
    in_a_term_of_two: if (q[0] < 0.0 || q[1] > 0.0) && system.one > 0.0 { q[0] * q[0] } else { 0.0 }, -1.0;
    in_a_term_that_is_negated: if !(q[0] > 0.0 && q[1] > 0.0) && system.one > 0.0 { q[0] * q[0] } else { q[0] }, -1.0;
    in_two_conditions: {
        let (first, second) = (q[0] > 0.0 && q[1] > 0.0, q[0] < -5.0 && q[2] > 0.0);
        if (first || second) && system.first { q[0].cos() } else { 2.0 * q[0] }
    }, 2.0;
    in_a_chain_of_conditions: {
        let log = (q[0] * q[0]).ln();
        if q[0] < 0.0 { log } else if q[1] > 0.0 { log * log } else if q[2] > 1.0 { log.sin() } else { log.cos() * log }
    }, -4.0;
    in_conditions_of_a_value_of_several: {
        let sign = -q[0].signum();
        (if sign >= q[0] { sign * q[0] } else if 2.5 > q[1] && sign > 0.1 { sign.sin() } else { q[0] * sign }) + sign
    }, 1.0;
    in_a_value_that_is_used_twice: {
        let angle = if q[0] > 0.0 { q[1].sqrt() } else { 2.0 * q[0] };
        angle * angle + angle.cos()
    }, -4.0 + 2.0 * 1.0_f64.sin();
    in_an_argument: q[0].min(if q[0] > 0.0 { q[1] } else { 0.3 }), 1.0;
    in_a_factor_of_a_sum: {
        let mut v = q[0];
        for i in 0..q.len() {
            for j in 0..q.len() {
                if q[j] > 0.0 {
                    v += q[i] * q[i] * system.list[i + 3];
                }
            }
        }
        v
    }, 1.0;
    in_a_factor_of_a_product: {
        let mut v = q[0];
        for i in 0..q.len() {
            let mut w = 1.0;
            for j in 0..3 {
                if q[j % q.len()] > 0.0 {
                    w *= q[i].cos() * system.list[i + 3];
                }
            }
            v += w;
        }
        v
    }, 1.0;
}
