//! Without the prelude: `Option`, `Clone`, `Iterator` and `Vec` are not known by these names.
#![no_implicit_prelude]

use ::integrator_core::{Hamiltonian, Phase, composition, hamiltonian};

/// A system with every kind of prepared constant: numbers, tables and tables without a length.
pub struct Beads {
    /// Masses.
    pub mass: [f64; 3],
    /// Stiffness of the springs.
    pub stiffness: f64,
    /// How many of them are held by a spring.
    pub held: usize,
}

#[hamiltonian(compose = V(1/2) T(1) V(1/2))]
impl Beads {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            sum += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn potential(&self, q: [f64; 3], t: f64) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.held {
            sum += self.stiffness * q[i] * q[i] / (2.0 + self.mass[i]);
        }
        sum * (2.0 + t.sin())
    }
}

composition! {
    /// Declared without a prelude.
    pub struct Mine: order 2, symmetric = T(1/2) V(1) T(1/2);
}

#[test]
fn runs() {
    let beads = Beads { mass: [1.0, 2.0, 3.0], stiffness: 0.5, held: 2 };
    let start = || Phase::new([1.0, 0.5, -0.5], [0.0; 3]);
    let mut annotated = beads.run(start(), 0.01).expect("an admissible start");
    let mut own = beads.run_with(Mine, start(), 0.01).expect("an admissible start");
    annotated.advance(100).expect("finite");
    own.advance(100).expect("finite");
    // Two methods of order 2 with steps of 0.01 over a time of order one.
    let difference: f64 = annotated.state().q[0] - own.state().q[0];
    ::std::assert!(difference.abs() < 1e-3);
}
