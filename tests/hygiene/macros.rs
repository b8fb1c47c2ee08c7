//! Systems that a macro of the user writes: its `self` has a hygiene of its own, in functions and in attributes.

use integrator_core::prelude::*;

macro_rules! planets {
    ($name:ident, $bodies:literal) => {
        /// Bodies that attract each other.
        #[derive(Debug)]
        pub struct $name {
            /// Their masses.
            pub mass: [f64; $bodies],
        }

        #[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction)]
        impl $name {
            fn kinetic(&self, p: [[f64; 2]; $bodies]) -> f64 {
                (0..$bodies).map(|i| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.mass[i])).sum()
            }
            fn potential(&self, q: [[f64; 2]; $bodies]) -> f64 {
                let mut energy = 0.0;
                for i in 0..$bodies {
                    for j in 0..i {
                        let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                        energy -= self.mass[i] * self.mass[j] / x.hypot(y);
                    }
                }
                energy
            }
        }
    };
}

planets!(Planet, 2);

#[test]
fn a_macro_writes_jacobi_coordinates() {
    let planet = Planet { mass: [1.0, 1e-3] };
    let mut run = planet.run(Phase::new([[0.0; 2], [1.0, 0.0]], [[0.0, -1e-3], [0.0, 1e-3]]), 0.1).expect("a run");
    let energy = run.energy();
    run.advance(100).expect("steps");
    // Kepler parts alone: some hundred roundings.
    assert!((run.energy() / energy - 1.0).abs() < 1e-12);
}
