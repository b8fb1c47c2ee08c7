//! Recurrences of Hamiltonians that are not `T(p) + V(q)`: in one function, in named parts, in other coordinates.

use crate::recurrences::judge;
use integrator_core::prelude::*;

/// Declares a system and a test for every row: the name, the arguments of the attribute, and the functions of H.
macro_rules! rows {
    ($($name:ident ($($arguments:tt)*) { $($functions:tt)* })*) => {
        /// The names of the rows, and of the system below them.
        pub(crate) const ROWS: &[&str] = &[$(stringify!($name)),*, "jacobi"];

        $(pub(crate) mod $name {
            use super::*;

            pub(crate) struct System {
                #[allow(dead_code, reason = "a row reads what it needs")]
                pub(crate) masses: [f64; 4],
            }

            #[hamiltonian($($arguments)*)]
            impl System {
                $($functions)*
            }

            #[test]
            fn coefficients_are_those_of_the_reference() {
                judge(stringify!($name), &System { masses: [4.0, 1.0, 0.5, 0.25] });
            }
        })*
    };
}

rows! {
    double_pendulum (split = none, compose = GaussLegendre4, taylor) {
        fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
            let (sine, cosine) = (a - b).sin_cos();
            (pa * pa + 2.0 * pb * pb - 2.0 * pa * pb * cosine) / (2.0 * (1.0 + sine * sine)) - 2.0 * a.cos() - b.cos()
        }
    }
    geodesic (split = none, taylor) {
        fn hamiltonian(&self, [_, r, _]: [f64; 3], [pt, pr, pphi]: [f64; 3]) -> f64 {
            let metric = 1.0 - 2.0 / r;
            0.5 * (metric * pr * pr + pphi * pphi / (r * r) - pt * pt / metric)
        }
    }
    rotating_frame (split = quadratic + rest, taylor) {
        fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
            let mass = 1.0 / 64.0;
            let star = ((x + mass).powi(2) + y * y).sqrt();
            let planet = ((x - 1.0 + mass).powi(2) + y * y).sqrt();
            0.5 * (px * px + py * py) + y * px - x * py - (1.0 - mass) / star - mass / planet
        }
    }
    kepler_and_interaction (split = kepler + interaction, taylor) {
        fn kepler(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
        }
        fn interaction(&self, q: [f64; 2]) -> f64 {
            q[0] * q[0] * q[1] * q[1] / 8.0
        }
    }
    field_of_time (split = none, taylor) {
        fn hamiltonian(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
            ((p[0] - q[1] * t).powi(2) + (p[1] + t * t * q[0]).powi(2) + q[0] * q[0]) / 2.0
        }
    }
    twisted (split = kinetic + twist + rest, compose = Yoshida4, taylor) {
        fn kinetic(&self, p: [f64; 2]) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0
        }
        fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
            q[0].sin() * p[1].powi(2) / 4.0
        }
        fn rest(&self, q: [f64; 2]) -> f64 {
            q[0] * q[0] + q[1] * q[1]
        }
    }
    copied (split = symmetric(omega = 2.0), compose = Yoshida4, taylor) {
        fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
            let shared = 0.5 * (q[0] * q[0] + 1.0) * (p[0] * p[0] + 1.0) + 0.5 * p[1] * p[1];
            shared - q[1].cos() * (p[0] / 2.0).exp() + (4.0 + q[0] * p[1]).sqrt()
        }
    }
    heliocentric (split = kepler + (jump + interaction), taylor) {
        fn kepler(&self, q: [[f64; 2]; 3], p: [[f64; 2]; 3]) -> f64 {
            let mut sum = 0.0;
            for i in 0..3 {
                let mass = (i + 1) as f64 / 2.0;
                sum += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * mass)
                    - 4.0 * mass / (q[i][0] * q[i][0] + q[i][1] * q[i][1]).sqrt();
            }
            sum
        }
        fn jump(&self, p: [[f64; 2]; 3]) -> f64 {
            let mut sum = 0.0;
            for d in 0..2 {
                let total = p[0][d] + p[1][d] + p[2][d];
                sum += total * total / 8.0;
            }
            sum
        }
        fn interaction(&self, q: [[f64; 2]; 3]) -> f64 {
            let mut sum = 0.0;
            for i in 0..3 {
                for j in 0..i {
                    let masses = (i + 1) as f64 * (j + 1) as f64 / 4.0;
                    sum -= masses / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
                }
            }
            sum
        }
    }
    mixed_chain (split = none, taylor) {
        fn hamiltonian(&self, q: &[f64], p: &[f64]) -> f64 {
            let mut sum = 0.0;
            for i in 0..q.len() {
                sum += (1.0 + q[i] * q[i]) * p[i] * p[i] / 2.0;
            }
            for i in 1..q.len() {
                let stretch = q[i] - q[i - 1];
                sum += stretch.powi(4) / 4.0 + stretch * p[i] / 8.0;
            }
            sum
        }
    }
}

/// Outside of the rows, since the attribute names a field of `self`.
pub(crate) mod jacobi {
    use super::*;

    pub(crate) struct System {
        pub(crate) masses: [f64; 4],
    }

    #[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction, taylor)]
    impl System {
        fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 {
            (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.masses[i])).sum()
        }
        fn potential(&self, q: [[f64; 2]; 4]) -> f64 {
            let mut sum = 0.0;
            for i in 0..4 {
                for j in 0..i {
                    sum -= self.masses[i] * self.masses[j]
                        / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
                }
            }
            sum
        }
    }

    #[test]
    fn coefficients_are_those_of_the_reference() {
        judge("jacobi", &System { masses: [4.0, 1.0, 0.5, 0.25] });
    }
}
