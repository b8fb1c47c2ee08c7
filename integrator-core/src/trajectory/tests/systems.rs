//! One system of each kind that executors distinguish.

use crate::hamiltonian;

/// `T` is quadratic.
pub(super) struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
    }
}

/// `T` is not quadratic.
pub(super) struct Crystal;

#[hamiltonian]
impl Crystal {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        -p[0].cos() - p[1].cos()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y + x.powi(4)
    }
}

/// Both parts depend on time.
pub(super) struct Driven;

#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: [f64; 2], t: f64) -> f64 {
        (1.0 + 0.3 * t.sin()) * (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        -(q[0] - t).cos() + q[1].powi(4) / 4.0 - 0.3 * q[0] * q[1]
    }
}

/// The potential changes its formula between two steps of an eighth.
pub(super) struct Switched;

#[hamiltonian]
impl Switched {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let push = if t < 0.875 { 0.3 } else { 0.7 };
        -q[0].cos() + q[1].powi(4) / 4.0 - push * q[0] * q[1]
    }
}

/// Three parts that depend on time, the last two of which are a pair or not.
macro_rules! sheared {
    ($name:ident: $($split:tt)*) => {
        pub(super) struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn first(&self, p: [f64; 2], t: f64) -> f64 {
                (1.0 + 0.3 * t.sin()) * (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
            fn shear(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
                t.cos() * q[0].sin() * p[1]
            }
            fn last(&self, q: [f64; 2], t: f64) -> f64 {
                -(q[0] - t).cos() + q[1].powi(4) / 4.0
            }
        }
    };
}

sheared!(ThreeParts: first + shear + last);
sheared!(Paired: first + (shear + last));

/// The second part is small, and the first one is quadratic in `p`.
pub(super) struct Perturbed;

#[hamiltonian(split = free + weak)]
impl Perturbed {
    fn free(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn weak(&self, q: [f64; 2]) -> f64 {
        0.1 * ((q[0] + 0.3 * q[1]).sin() + 0.5 * (q[0] - q[1]).cos())
    }
}

/// The flow of the first part multiplies by matrices that depend on the duration.
pub(super) struct Oscillators;

#[hamiltonian(split = quadratic + rest)]
impl Oscillators {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + (q[0] - 0.4 * q[1]).powi(2) + 0.2 * q[0] * p[1] + 0.1 * q[1].powi(4)
    }
}

/// The first part moves bodies on Kepler orbits, in Jacobi coordinates.
pub(super) struct Planets;

impl Planets {
    const MASS: [f64; 3] = [1.0, 1e-3, 3e-4];
}

#[hamiltonian(coordinates = jacobi(Self::MASS), split = kepler + interaction)]
impl Planets {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * Self::MASS[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                sum -= Self::MASS[i] * Self::MASS[j] / square.sqrt();
            }
        }
        sum
    }
}

/// A lattice, whose sites are computed in vectors.
pub(super) struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            sum += stretch * stretch / 2.0 + stretch.powi(3) / 12.0;
        }
        sum
    }
}

/// Pairs of bodies, which are computed in vectors.
pub(super) struct Bodies;

#[hamiltonian]
impl Bodies {
    fn kinetic(&self, p: [[f64; 3]; 5]) -> f64 {
        (0..5).map(|i| p[i].iter().map(|p| p * p).sum::<f64>() / (1.0 + 0.1 * i as f64)).sum()
    }
    fn potential(&self, q: [[f64; 3]; 5]) -> f64 {
        let mut sum = 0.0;
        for i in 0..5 {
            for j in 0..i {
                let square: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
                sum -= 0.1 / (square + 0.05).sqrt();
            }
        }
        sum
    }
}

/// Steps move two coupled copies of the state.
pub(super) struct Mixed;

#[hamiltonian(split = symmetric(omega = 10.0))]
impl Mixed {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (q[0] * q[0] + 1.0) * (p[0] * p[0] + 1.0) / 2.0 + (p[1] * p[1] + q[1] * q[1]) / 2.0 + 0.3 * q[0] * q[1]
    }
}
