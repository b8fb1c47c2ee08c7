//! Coordinates and items of every kind, each with a gradient written by hand.

use crate::{TIME, close, kicked};
use integrator_core::{Coords, prelude::*};

/// A test that one kick of length 1 from rest gives momenta of minus the gradient.
macro_rules! moves {
    ($system:expr, $start:expr, $gradient:expr) => {
        #[test]
        fn moves_by_the_hand_written_gradient() {
            let (found, _) = kicked(&$system, $start, TIME);
            close(&found, $gradient.flat());
        }
    };
}

mod numbers {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: [f64; 2]) -> f64 {
            q[0] * q[1]
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod references {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: &[f64; 2]) -> f64 {
            q[0] * q[1]
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod points {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [[f64; 3]; 2]) -> f64 {
            p.iter().map(|p| 0.5 * p[0] * p[0]).sum()
        }
        fn potential(&self, q: [[f64; 3]; 2]) -> f64 {
            q[0][2] * q[1][0]
        }
    }

    moves!(System, [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]], [[0.0, 0.0, 0.4], [0.3, 0.0, 0.0]]);
}

mod referenced_points {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[[f64; 3]; 2]) -> f64 {
            p.iter().map(|p| 0.5 * p[0] * p[0]).sum()
        }
        fn potential(&self, q: &[[f64; 3]; 2]) -> f64 {
            let [x, y, z] = q[1];
            x * y * z
        }
    }

    moves!(System, [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]], [[0.0; 3], [0.5 * 0.6, 0.4 * 0.6, 0.4 * 0.5]]);
}

mod patterns {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, [x, y]: [f64; 2]) -> f64 {
            x * y
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod referenced_patterns {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, &[x, y]: &[f64; 2]) -> f64 {
            x * y
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod nested_patterns {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [[f64; 2]; 2]) -> f64 {
            p.iter().map(|p| 0.5 * p[0] * p[0]).sum()
        }
        fn potential(&self, [[x, y], _]: [[f64; 2]; 2]) -> f64 {
            x * y
        }
    }

    moves!(System, [[0.4, -0.3], [0.1, 0.2]], [[-0.3, 0.4], [0.0, 0.0]]);
}

mod slices {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[f64]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: &[f64]) -> f64 {
            q.iter().map(|x| x * x).sum()
        }
    }

    moves!(System, vec![0.4, -0.3, 0.2], vec![0.8, -0.6, 0.4]);
}

mod slices_of_points {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
            p.iter().map(|p| 0.5 * p[0] * p[0]).sum()
        }
        fn potential(&self, q: &[[f64; 2]]) -> f64 {
            q.iter().map(|[x, y]| x * y).sum()
        }
    }

    moves!(System, vec![[0.4, -0.3], [0.1, 0.2]], vec![[-0.3, 0.4], [0.2, 0.1]]);
}

mod planes {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &[[[f64; 4]; 3]]) -> f64 {
            p.iter().flatten().flatten().map(|x| 0.5 * x * x).sum()
        }
        fn potential(&self, q: &[[[f64; 4]; 3]]) -> f64 {
            q.iter().flatten().flatten().map(|x| x * x).sum()
        }
    }

    const PLANE: [[f64; 4]; 3] = [[0.4, -0.3, 0.1, 0.2], [0.0, 0.5, 0.6, -0.7], [0.8, 0.9, 0.15, -0.25]];

    moves!(
        System,
        vec![PLANE, PLANE.map(|row| row.map(|x| -x))],
        vec![PLANE.map(|row| row.map(|x| 2.0 * x)), PLANE.map(|row| row.map(|x| -2.0 * x))]
    );
}

mod vectors_behind_references {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: &Vec<f64>) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: &Vec<f64>) -> f64 {
            q.windows(2).map(|w| w[0] * w[1]).sum()
        }
    }

    moves!(System, vec![0.4, -0.3, 0.2], vec![-0.3, 0.6, -0.3]);
}

mod constants {
    use super::*;

    const SITES: usize = 3;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; SITES]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: [f64; SITES]) -> f64 {
            let mut v = 0.0;
            for i in 0..SITES {
                v += q[i] * q[i];
            }
            v
        }
    }

    moves!(System, [0.4, -0.3, 0.2], [0.8, -0.6, 0.4]);
}

mod associated_constants {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        const SITES: usize = 3;
        fn kinetic(&self, p: [f64; Self::SITES]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: [f64; Self::SITES]) -> f64 {
            (0..Self::SITES).map(|i| q[i] * q[i]).sum()
        }
    }

    moves!(System, [0.4, -0.3, 0.2], [0.8, -0.6, 0.4]);
}

mod other_names {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, position: [f64; 2]) -> f64 {
            position[0] * position[1]
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod time {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: [f64; 1], t: f64) -> f64 {
            q[0] * t.cos()
        }
    }

    moves!(System, [0.4], [TIME.cos()]);
}

mod no_energy {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, _: [f64; 2]) -> f64 {
            0.0
        }
    }

    moves!(System, [0.4, -0.3], [0.0, 0.0]);
}

mod two_spellings {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn kinetic(&self, [x, y]: [f64; 2]) -> f64 {
            x * x + y * y
        }
        fn potential(&self, q: &[f64; 2]) -> f64 {
            q[0] * q[1]
        }
    }

    moves!(System, [0.4, -0.3], [-0.3, 0.4]);
}

mod const_generics {
    use super::*;

    struct Chain<const N: usize>;

    #[hamiltonian]
    impl<const N: usize> Chain<N> {
        fn kinetic(&self, p: [f64; N]) -> f64 {
            p.iter().map(|p| p * p).sum()
        }
        fn potential(&self, q: [f64; N]) -> f64 {
            q.windows(2).map(|w| w[0] * w[1]).sum()
        }
    }

    moves!(Chain::<3>, [0.4, -0.3, 0.2], [-0.3, 0.6, -0.3]);
}

mod lifetimes {
    use super::*;

    struct Borrowed<'a> {
        table: &'a [f64],
    }

    #[hamiltonian]
    impl<'a> Borrowed<'a> {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.table[0] * q[0]
        }
    }

    moves!(Borrowed { table: &[3.0] }, [0.4], [3.0]);
}

mod elided_lifetimes {
    use super::*;

    struct Borrowed<'a> {
        table: &'a [f64],
    }

    #[hamiltonian]
    impl Borrowed<'_> {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.table[0] * q[0]
        }
    }

    moves!(Borrowed { table: &[3.0] }, [0.4], [3.0]);
}

mod stated_derivative {
    use super::*;

    #[derive(Clone)]
    struct Table;

    impl Table {
        fn energy(&self, x: f64) -> f64 {
            (1..=3).map(|power| x.powi(power)).sum()
        }
        fn force(&self, x: f64) -> f64 {
            1.0 + 2.0 * x + 3.0 * x * x
        }
    }

    #[derive(Clone)]
    struct Tabulated {
        table: Table,
    }

    #[hamiltonian]
    impl Tabulated {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.law(q[0])
        }
        #[derivative(slope)]
        fn law(&self, x: f64) -> f64 {
            self.table.energy(x)
        }
        fn slope(&self, x: f64) -> f64 {
            self.table.force(x)
        }
    }

    moves!(Tabulated { table: Table }, [0.5], [2.75]);
}

mod stated_derivatives {
    use super::*;

    #[derive(Clone)]
    struct Tabulated;

    #[hamiltonian]
    impl Tabulated {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.law(q[0], 2.0)
        }
        #[derivative(by_x, by_y)]
        fn law(&self, x: f64, y: f64) -> f64 {
            x * x * y
        }
        fn by_x(&self, x: f64, y: f64) -> f64 {
            2.0 * x * y
        }
        fn by_y(&self, x: f64, _y: f64) -> f64 {
            x * x
        }
    }

    moves!(Tabulated, [0.5], [2.0]);
}

mod three_stated_derivatives {
    use super::*;

    #[derive(Clone)]
    struct Tabulated;

    #[hamiltonian]
    impl Tabulated {
        fn kinetic(&self, p: [f64; 3]) -> f64 {
            p[0] * p[1] * p[2]
        }
        fn potential(&self, q: [f64; 3]) -> f64 {
            self.law(q[0], q[1], q[2])
        }
        #[derivative(by_x, by_y, by_z)]
        fn law(&self, x: f64, y: f64, z: f64) -> f64 {
            x * y * y * z
        }
        fn by_x(&self, _x: f64, y: f64, z: f64) -> f64 {
            y * y * z
        }
        fn by_y(&self, x: f64, y: f64, z: f64) -> f64 {
            2.0 * x * y * z
        }
        fn by_z(&self, x: f64, y: f64, _z: f64) -> f64 {
            x * y * y
        }
    }

    moves!(Tabulated, [0.5, 0.4, -0.3], [-0.048, -0.12, 0.08]);
}

mod stated_gradients {
    use super::*;

    #[derive(Clone)]
    struct Tabulated;

    #[hamiltonian]
    impl Tabulated {
        fn kinetic(&self, p: [f64; 3]) -> f64 {
            p[0] * p[1] * p[2]
        }
        fn potential(&self, q: [f64; 3]) -> f64 {
            self.law(q[0], q[1], q[2])
        }
        #[derivative(gradient)]
        fn law(&self, x: f64, y: f64, z: f64) -> f64 {
            x * y * y * z
        }
        fn gradient(&self, x: f64, y: f64, z: f64) -> [f64; 3] {
            [y * y * z, 2.0 * x * y * z, x * y * y]
        }
    }

    moves!(Tabulated, [0.5, 0.4, -0.3], [-0.048, -0.12, 0.08]);
}

mod where_clauses {
    use super::*;

    trait Law {
        fn strength(&self) -> f64;
    }

    struct Constant(f64);

    impl Law for Constant {
        fn strength(&self) -> f64 {
            self.0
        }
    }

    struct Generic<L> {
        law: L,
    }

    #[hamiltonian]
    impl<L: Law> Generic<L>
    where
        L: Sync,
    {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.law.strength() * q[0]
        }
    }

    moves!(Generic { law: Constant(3.0) }, [0.4], [3.0]);
}

mod attributes {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        #[inline]
        pub(crate) fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        #[must_use]
        pub(super) fn potential(&self, q: [f64; 1]) -> f64 {
            q[0]
        }
    }

    moves!(System, [0.4], [1.0]);
}

mod whole {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn hamiltonian(&self, [x, y]: [f64; 2], p: [f64; 2]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum::<f64>() + x * x * y
        }
    }

    moves!(System, [0.4, -0.3], [-0.24, 0.16]);
}

mod whole_at_run_time {
    use super::*;

    struct System;

    #[hamiltonian]
    impl System {
        fn hamiltonian(&self, q: &[f64], p: &[f64], t: f64) -> f64 {
            let mut h = 0.0;
            for i in 0..q.len() {
                h += p[i] * p[i] / 2.0 + t * q[i] * q[i];
            }
            h
        }
    }

    moves!(System, vec![0.4, -0.3], vec![0.8 * TIME, -0.6 * TIME]);
}

mod test_particles {
    use super::*;

    struct Bodies {
        masses: [f64; 3],
    }

    #[hamiltonian]
    impl Bodies {
        fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
            p.iter().zip(&self.masses).map(|(p, m)| (p[0] * p[0] + p[1] * p[1]) / (2.0 * m)).sum()
        }
        fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
            let mut v = 0.0;
            for i in 0..3 {
                for j in 0..i {
                    let d = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                    v -= self.masses[i] * self.masses[j] / (d[0] * d[0] + d[1] * d[1]).sqrt();
                }
            }
            v
        }
    }

    /// Positions after a while, with a third body of a small mass and a velocity that does not depend on it.
    fn positions(mass: f64) -> [[f64; 2]; 3] {
        let start = Phase::new([[0.0; 2], [1.0, 0.0], [-1.5, 0.25]], [[0.0, -0.25], [0.0, 0.25], [0.0, -mass]]);
        let system = Bodies { masses: [1.0, 0.25, mass] };
        let mut run = system.run(start, 0.01).expect("a run");
        run.advance(500).expect("steps");
        run.state().q
    }

    /// A mass that is a power of two scales the momentum of its body and nothing else; that the others feel it is lost in
    /// the rounding of their forces. So it may stand for no mass at all.
    #[test]
    fn a_tiny_mass_is_no_mass() {
        let (tiny, tinier) = (positions(2.0_f64.powi(-100)), positions(2.0_f64.powi(-200)));
        assert_eq!(tiny, tinier);
        assert!(tiny[2][0] != -1.5, "the particle moves");
    }
}
