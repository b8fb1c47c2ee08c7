//! Parameters that are not finite are rejected if they affect the motion, and accepted otherwise.

use integrator_core::prelude::*;

#[test]
fn parameters_that_break_the_motion() {
    struct Pendulum {
        mass: f64,
        length: f64,
    }
    #[hamiltonian]
    impl Pendulum {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            -9.81 * self.mass * self.length * q[0].cos()
        }
    }
    let error = Pendulum { mass: 0.0, length: 1.0 }.run(Phase::new([1.0], [0.0]), 0.01).expect_err("no mass");
    assert_eq!(
        error.to_string(),
        "the equations of motion are not finite at the initial state: `1 / (mass length^2)` is inf; \
         `1 / (2 mass length^2)` is inf\nhelp: check these parameters of the system"
    );
}

/// Infinite parameters that do not affect the motion are accepted.
#[test]
fn parameters_that_are_infinite_on_purpose() {
    struct Walled {
        cutoff: f64,
        height: f64,
        stiffness: [f64; 2],
    }
    #[hamiltonian]
    impl Walled {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0
        }
        fn potential(&self, q: [f64; 2]) -> f64 {
            let mut sum = 0.0;
            for i in 0..2 {
                if q[i] < self.cutoff {
                    sum += q[i] * q[i] / self.stiffness[i];
                }
                if q[i] > 10.0 {
                    sum += self.height * q[i];
                }
            }
            sum
        }
    }
    let walled = Walled { cutoff: f64::INFINITY, height: f64::INFINITY, stiffness: [1.0, f64::INFINITY] };
    let mut run = walled.run(Phase::new([1.0, 1.0], [0.0, 1.0]), 0.01).expect("no harm is done");
    run.advance(500).expect("inside the wall");
    let outside = walled.run(Phase::new([11.0, 1.0], [0.0, 1.0]), 0.01).expect_err("in the wall");
    assert_eq!(
        outside.to_string(),
        "the equations of motion are not finite at the initial state: `cutoff` is inf; `height` is inf\nhelp: check these \
         parameters of the system"
    );
}
