//! The same motion in other units: coordinates, momenta and the steps of the method have the same digits, if units are powers
//! of two, and else the same sizes.

use crate::runs::FINE;
use integrator_core::{prelude::*, taylor::Taylor};

/// Exponents of the units of length, mass and time: atoms and galaxies in metres, kilograms and seconds, and all corners of
/// what doubles hold with their squares and cubes.
const SYSTEMS: [[i32; 3]; 9] = [
    [0, 0, 0],
    [-33, -100, -53],
    [-33, -86, -50],
    [66, 137, 54],
    [200, 0, 0],
    [-200, 0, 0],
    [0, 0, 230],
    [0, 0, -230],
    [-90, 60, -120],
];

/// A size in units of these powers of length, mass and time.
fn unit([length, mass, time]: [i32; 3], powers: [i32; 3]) -> f64 {
    let exponents = [length * powers[0], mass * powers[1], time * powers[2]];
    exponents.into_iter().map(|exponent| 2.0_f64.powi(exponent)).product()
}

const LENGTH: [i32; 3] = [1, 0, 0];
const MASS: [i32; 3] = [0, 1, 0];
const TIME: [i32; 3] = [0, 0, 1];
const MOMENTUM: [i32; 3] = [1, 1, -1];
const STIFFNESS: [i32; 3] = [0, 1, -2];
const CUBIC: [i32; 3] = [-1, 1, -2];
const GRAVITY: [i32; 3] = [3, -1, -2];

/// Declares systems with a test that their motion has the same digits in all systems of units. Each row is a name, the
/// parameters and the units of these, the type of coordinates, the energies, and the start.
macro_rules! systems {
    ($(
        $name:ident { $($field:ident: $powers:expr),* } $coords:ty, $reference:ty {
            kinetic($self:ident, $p:ident) { $($kinetic:tt)* }
            potential($q:ident, $t:ident) { $($potential:tt)* }
        } $positions:expr, $momenta:expr;
    )*) => {$(
        mod $name {
            use super::*;

            struct System { $($field: f64),* }

            #[hamiltonian(taylor)]
            #[allow(unused_variables, clippy::needless_range_loop, reason = "a row reads what it needs, in the language of H")]
            impl System {
                fn kinetic(&$self, $p: $reference) -> f64 { $($kinetic)* }
                fn potential(&$self, $q: $reference, $t: f64) -> f64 { $($potential)* }
            }

            /// The numbers of the state at the end over their units, and those of the steps.
            fn digits(units: [i32; 3], h: f64) -> Vec<f64> {
                let system = System { $($field: [1.0, 0.7, 0.3][$powers.1] * unit(units, $powers.0)),* };
                let scaled = |numbers: $coords, unit: f64| -> $coords {
                    let mut numbers = numbers;
                    integrator_core::Coords::flat_mut(&mut numbers).iter_mut().for_each(|x| *x *= unit);
                    numbers
                };
                let [length, momentum, time] = [LENGTH, MOMENTUM, TIME].map(|powers| unit(units, powers));
                let start = Phase::new(scaled($positions, length), scaled($momenta, momentum));
                let mut run = system.run_with(Taylor::tolerance(FINE), start, h * time).expect("a start");
                run.advance(20).expect("a regular motion");
                let own = run.own_steps().expect("steps of its own");
                let mut digits = vec![own.taken as f64, own.shortest / time, own.longest / time];
                let state = run.state();
                for (half, unit) in [(&state.q, length), (&state.p, momentum)] {
                    digits.extend(integrator_core::Coords::flat(half).iter().map(|x| x / unit));
                }
                digits
            }

            #[test]
            fn the_motion_has_the_same_digits_in_all_units() {
                for h in [0.3, -0.3] {
                    let expected = digits([0; 3], h);
                    assert!(expected[0] > 3.0 && expected.iter().all(|x| x.is_finite()), "{expected:?}");
                    for units in SYSTEMS {
                        assert_eq!(digits(units, h), expected, "units of 2^{units:?}");
                    }
                }
            }
        }
    )*};
}

systems! {
    bond { mass: (MASS, 1), stiffness: (STIFFNESS, 0), cubic: (CUBIC, 2) } [f64; 1], [f64; 1] {
        kinetic(self, p) { p[0] * p[0] / (2.0 * self.mass) }
        potential(q, t) { self.stiffness * q[0] * q[0] / 2.0 + self.cubic * q[0] * q[0] * q[0] }
    } [0.0], [0.5];

    pendulum_in_a_wave { mass: (MASS, 1), stiffness: (STIFFNESS, 0), length: (LENGTH, 2), period: (TIME, 0) } [f64; 1], [f64; 1] {
        kinetic(self, p) { p[0] * p[0] / (2.0 * self.mass) }
        potential(q, t) { self.stiffness * self.length * self.length * (q[0] / self.length - t / self.period).cos() }
    } [0.2], [0.1];

    kepler { mass: (MASS, 0), gravity: (GRAVITY, 1) } [f64; 2], [f64; 2] {
        kinetic(self, p) { (p[0] * p[0] + p[1] * p[1]) / (2.0 * self.mass) }
        potential(q, t) { -self.gravity * self.mass * self.mass / (q[0] * q[0] + q[1] * q[1]).sqrt() }
    } [0.6, 0.0], [0.0, 1.1];

    velocities_with_a_limit { mass: (MASS, 0), fastest: (LENGTH_PER_TIME, 1), stiffness: (STIFFNESS, 1) } [f64; 1], [f64; 1] {
        kinetic(self, p) {
            self.mass * self.fastest * self.fastest * (1.0 + (p[0] / (self.mass * self.fastest)).powi(2)).sqrt()
        }
        potential(q, t) { self.stiffness * q[0] * q[0] / 2.0 }
    } [0.9], [0.0];

    chain { mass: (MASS, 1), stiffness: (STIFFNESS, 0), cubic: (CUBIC, 2) } [f64; 16], [f64; 16] {
        kinetic(self, p) { p.iter().map(|p| p * p / (2.0 * self.mass)).sum() }
        potential(q, t) {
            let mut energy = 0.0;
            for i in 0..15 {
                let d = q[i + 1] - q[i];
                energy += self.stiffness * d * d / 2.0 + self.cubic * d * d * d;
            }
            energy
        }
    } std::array::from_fn(|i| (i % 5) as f64 / 16.0), std::array::from_fn(|i| (i % 3) as f64 / 32.0);

    pairs { mass: (MASS, 1), stiffness: (STIFFNESS, 0), length: (LENGTH, 0) } Vec<[f64; 2]>, &[[f64; 2]] {
        kinetic(self, p) { p.iter().map(|p| (p[0] * p[0] + p[1] * p[1]) / (2.0 * self.mass)).sum() }
        potential(q, t) {
            let mut energy = 0.0;
            for i in 0..q.len() {
                for j in 0..i {
                    let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                    energy += self.stiffness * self.length.powi(3) / (self.length * self.length + x * x + y * y).sqrt();
                }
            }
            energy
        }
    } vec![[0.0, 0.1], [0.7, 0.2], [0.1, 0.9], [1.2, 1.1], [0.4, 1.6]], vec![[0.0, 0.0], [0.3, 0.1], [0.0, 0.2], [0.1, 0.0], [0.2, 0.2]];
}

const LENGTH_PER_TIME: [i32; 3] = [1, 0, -1];

/// Two coordinates, each in a unit of its own, that move each other.
struct Coupled {
    masses: [f64; 2],
    stiffness: [f64; 2],
    coupling: f64,
}

#[hamiltonian(taylor)]
impl Coupled {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] / (2.0 * self.masses[0]) + p[1] * p[1] / (2.0 * self.masses[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let springs = self.stiffness[0] * q[0] * q[0] + self.stiffness[1] * q[1] * q[1];
        springs / 2.0 + self.coupling * q[0] * q[0] * q[1]
    }
}

#[test]
fn each_coordinate_may_have_a_unit_of_its_own() {
    let steps = |exponent: i32| {
        let unit = 2.0_f64.powi(exponent);
        let system =
            Coupled { masses: [1.0, 0.7 / (unit * unit)], stiffness: [1.3, 0.9 / (unit * unit)], coupling: 0.4 / unit };
        let start = Phase::new([0.5, 0.3 * unit], [0.0, 0.4 / unit]);
        let mut run = system.run_with(Taylor::tolerance(FINE), start, 0.25).expect("a start");
        run.advance(40).expect("a regular motion");
        let ([x, y], [u, v]) = (run.state().q, run.state().p);
        (run.own_steps(), [x, y / unit, u, v * unit])
    };
    for exponent in [-60, -20, 20, 60] {
        assert_eq!(steps(exponent), steps(0), "a unit of 2^{exponent}");
    }
}

#[test]
fn states_may_be_read_at_any_distance() {
    // Some four periods. Steps of the run from a tenth of a radian to 230 periods: the first unit of time follows from
    // them, and no digit does.
    let duration = 2.0_f64.powi(-44);
    let end = |h: f64| {
        let start = Phase::new([1.1e-11], [0.0]);
        let mut run = bond_in_si().run_with(Taylor::tolerance(1e-16), start, h).expect("a start");
        run.advance_to(duration).expect("a regular motion");
        [run.state().q, run.state().p]
    };
    let expected = end(duration / 64.0);
    for exponent in [-52, -48, -44, -38] {
        assert_eq!(end(2.0_f64.powi(exponent)), expected, "h = 2^{exponent}");
    }
}

/// A bond of carbon monoxide.
struct Bond {
    mass: f64,
    stiffness: f64,
    cubic: f64,
}

#[hamiltonian(taylor)]
impl Bond {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.stiffness * q[0] * q[0] / 2.0 + self.cubic * q[0] * q[0] * q[0]
    }
}

/// In kilograms, newtons and metres.
fn bond_in_si() -> Bond {
    Bond { mass: 1.14e-26, stiffness: 1855.0, cubic: -185.5 / 1.1e-10 }
}

#[test]
fn a_bond_moves_alike_in_si_and_in_its_own_units() {
    let periods = 40.0;
    let end = |bond: Bond, length: f64, tolerance: f64| {
        let h = 0.5 * (bond.mass / bond.stiffness).sqrt();
        let start = Phase::new([0.1 * length], [0.0]);
        let mut run = bond.run_with(Taylor::tolerance(tolerance), start, h).expect("a start");
        run.advance(periods as u64).expect("a regular motion");
        run.state().q[0] / length
    };
    for tolerance in [1e-10, 1e-14, 1e-16, 1e-18] {
        let own = end(Bond { mass: 1.0, stiffness: 1.0, cubic: -0.1 }, 1.0, tolerance);
        let si = end(bond_in_si(), 1.1e-10, tolerance);
        let huge = end(Bond { mass: 1e80, stiffness: 1e-60, cubic: -1e-121 }, 1e60, tolerance);
        // Times are rounded once in each of 40 steps, states in each of some twenty steps of the method, and the tolerance
        // is that of each of these.
        for other in [si, huge] {
            assert!((other - own).abs() < 40.0 * (tolerance + 4.0 * f64::EPSILON), "{tolerance:e}: {other} and {own}");
        }
    }
}
