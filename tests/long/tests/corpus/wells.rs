//! Systems with one degree of freedom, in wells of different shapes.

use crate::{
    chains::half_squares,
    member::{Member, Number},
};
use integrator_core::prelude::*;

/// Defines the common parts of the wells: a momentum with the mass in `T`, and a formula of `V` alone.
macro_rules! well {
    ($well:ident { $($parameter:ident: $value:expr),* }, step $step:expr, |$own:ident, $x:ident| $formula:expr) => {
        impl Member for $well {
            const STEP: f64 = $step;

            fn example() -> Self {
                Self { $($parameter: $value),* }
            }
            fn energies(&self, at: &Phase<[f64; 1]>, _: f64) -> [f64; 2] {
                [self.kinetic(at.p), self.potential(at.q)]
            }
            fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
                half_squares(p) / MASS
            }
            fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
                let ($own, $x) = (self, q[0]);
                $formula
            }
        }
    };
}

/// The mass of all particles in this file.
const MASS: f64 = 1.25;

/// A double well (Duffing 1918).
pub(crate) struct Duffing {
    linear: f64,
    cubic: f64,
}

#[hamiltonian(compose = KahanLi8)]
impl Duffing {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let square = q[0] * q[0];
        square * (self.cubic * square / 4.0 - self.linear / 2.0)
    }
}

well!(Duffing { linear: 0.9, cubic: 1.3 }, step 0.05, |own, x| {
    x.powi(4) * (own.cubic / 4.0) - x.powi(2) * (own.linear / 2.0)
});

/// A molecular bond that can break (Morse 1929).
pub(crate) struct MorseBond {
    depth: f64,
    width: f64,
}

#[hamiltonian]
impl MorseBond {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.depth * f64::exp_m1(-self.width * x).powi(2)
    }
}

well!(MorseBond { depth: 1.1, width: 0.9 }, step 0.05, |own, x| {
    let decayed = (x * -own.width).exp_m1();
    decayed * decayed * own.depth
});

/// A well with a shoulder, of hyperbolic functions (Rosen and Morse 1932); the well is that of Pöschl and Teller.
pub(crate) struct RosenMorse {
    depth: f64,
    tilt: f64,
}

#[hamiltonian]
impl RosenMorse {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0].powi(2) / MASS
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        -self.depth / x.cosh().powi(2) + self.tilt * x.tanh()
    }
}

well!(RosenMorse { depth: 2.2, tilt: 0.4 }, step 0.05, |own, x| x.tanh() * own.tilt - x.cosh().powi(-2) * own.depth);

/// Walls that rise to infinity on both sides (Pöschl and Teller 1933).
pub(crate) struct Walls {
    strength: f64,
    stretch: f64,
}

#[hamiltonian]
impl Walls {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.strength * x.tan().powi(2) + self.stretch * (x / 2.0).sinh()
    }
}

well!(Walls { strength: 0.6, stretch: 0.3 }, step 0.05, |own, x| {
    x.tan().powi(2) * own.strength + (x / 2.0).sinh() * own.stretch
});

/// The mean field of a nucleus (Woods and Saxon 1954), inside a wide cage.
pub(crate) struct WoodsSaxon {
    depth: f64,
    radius: f64,
    skin: f64,
}

#[hamiltonian]
impl WoodsSaxon {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let nucleus = -self.depth / (1.0 + ((x - self.radius) / self.skin).exp());
        nucleus + 0.05 * x.powi(2)
    }
}

well!(WoodsSaxon { depth: 1.8, radius: 1.2, skin: 0.4 }, step 0.05, |own, x| {
    -(((x - own.radius) / own.skin).exp() + 1.0).recip() * own.depth + x * x * 0.05
});

/// A polymer spring that cannot be stretched beyond its length (Warner 1972).
pub(crate) struct FiniteSpring {
    stiffness: f64,
    length: f64,
}

#[hamiltonian]
impl FiniteSpring {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let square = self.length.powi(2);
        -0.5 * self.stiffness * square * (-x * x / square).ln_1p()
    }
}

well!(FiniteSpring { stiffness: 1.4, length: 1.75 }, step 0.02, |own, x| {
    -(x * x / -own.length.powi(2)).ln_1p() * (own.stiffness * own.length.powi(2) / 2.0)
});

/// The free energy of a magnet in the mean field of its spins (Weiss 1907): entropy through `atanh`.
pub(crate) struct Magnet {
    coupling: f64,
    field: f64,
}

#[hamiltonian]
impl Magnet {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [m]: [f64; 1]) -> f64 {
        let entropy = m * m.atanh() + 0.5 * (1.0 - m * m).ln();
        entropy - 0.5 * self.coupling * m * m - self.field * m
    }
}

well!(Magnet { coupling: 0.9, field: 0.1 }, step 0.02, |own, m| {
    let entropy = m * m.atanh() + (-m * m + 1.0).ln() / 2.0;
    entropy - m * m * (own.coupling / 2.0) - m * own.field
});

/// A Josephson contact of any transparency (Beenakker 1991), biased by a current.
pub(crate) struct AndreevContact {
    gap: f64,
    transparency: f64,
    current: f64,
}

#[hamiltonian]
impl AndreevContact {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [phase]: [f64; 1]) -> f64 {
        -self.gap * (1.0 - self.transparency * (phase / 2.0).sin().powi(2)).sqrt() - self.current * phase
    }
}

well!(AndreevContact { gap: 1.6, transparency: 0.85, current: 0.1 }, step 0.05, |own, x| {
    let sine = (x / 2.0).sin();
    -(sine * sine * -own.transparency + 1.0).sqrt() * own.gap - x * own.current
});

/// Slowly growing potentials: a sum of logarithms, roots and inverse functions.
pub(crate) struct Slow {
    scales: [f64; 6],
    degrees: f64,
}

#[hamiltonian]
impl Slow {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let [binary, decimal, root, area, angle, other] = self.scales;
        let square = 1.0 + x * x;
        let grown = binary * square.log2() + decimal * square.log10() + other * square.log(3.0);
        let bent = x - self.degrees.to_radians();
        grown + root * square.cbrt() + area * x.asinh() * x + angle * bent.atan() + x.clamp(-8.0, 8.0).exp2() / 16.0
    }
}

well!(Slow { scales: [0.2, 0.7, 0.5, 0.3, 0.4, 0.1], degrees: 20.0 }, step 0.05, |own, x| {
    let [binary, decimal, root, area, angle, other] = own.scales;
    let square = x * x + 1.0;
    let grown = square.log2() * binary + square.log10() * decimal + square.ln() * (other / 3.0_f64.ln());
    let bent = (x - own.degrees.to_radians()).atan() * angle;
    grown + bent + square.cbrt() * root + x.asinh() * x * area + x.exp2() / 16.0
});

/// Rapidly growing functions: `asin` and `acosh` where they are smooth.
pub(crate) struct Elliptic {
    strength: f64,
    tilt: f64,
}

#[hamiltonian]
impl Elliptic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * MASS)
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let confocal = (1.5 + x * x).acosh();
        self.strength * confocal * confocal + self.tilt * (0.5 * x.sin()).asin()
    }
}

well!(Elliptic { strength: 0.8, tilt: 0.3 }, step 0.05, |own, x| {
    (x * x + 1.5).acosh().powi(2) * own.strength + (x.sin() / 2.0).asin() * own.tilt
});
