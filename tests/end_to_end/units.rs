//! The same motion in other units, by compositions: where units are powers of two, states have the same digits from 1e-100 to
//! 1e100, in every layout and with every flow that the runtime solves.

use integrator_core::{Coords, prelude::*};

/// Exponents of the units of length, mass and time: the corners of what squares and cubes of coordinates leave in range.
const UNITS: [[i32; 3]; 12] = [
    [0, 0, 0],
    [100, 0, 0],
    [-100, 0, 0],
    [332, 0, 0],
    [-332, 0, 0],
    [0, 330, 0],
    [0, -330, 0],
    [0, 0, 230],
    [0, 0, -230],
    [66, 137, 54],
    [-33, -86, -50],
    [-90, 60, -120],
];

const LENGTH: [i32; 3] = [1, 0, 0];
const MASS: [i32; 3] = [0, 1, 0];
const TIME: [i32; 3] = [0, 0, 1];
const MOMENTUM: [i32; 3] = [1, 1, -1];
const ENERGY: [i32; 3] = [2, 1, -2];
const STIFFNESS: [i32; 3] = [0, 1, -2];
const FREQUENCY: [i32; 3] = [0, 0, -1];
/// Of the attraction between two bodies times their distance, over both masses.
const GRAVITY: [i32; 3] = [3, -1, -2];

fn scaled<C: Coords<Leaf = f64>>(mut numbers: C, unit: f64) -> C {
    numbers.flat_mut().iter_mut().for_each(|number| *number *= unit);
    numbers
}

/// A size in units of these powers of length, mass and time.
fn unit(units: [i32; 3], powers: [i32; 3]) -> f64 {
    powers.iter().zip(units).map(|(power, exponent)| 2.0_f64.powi(power * exponent)).product()
}

/// The numbers of the state after some steps, and the energies before and after them, over their units.
fn digits<C: Coords<Leaf = f64>>(run: Result<Run<C>, Error>, units: [i32; 3], steps: u64) -> Vec<f64> {
    let mut run = run.unwrap_or_else(|error| panic!("units of 2^{units:?}: {error}"));
    let [length, momentum, energy] = [LENGTH, MOMENTUM, ENERGY].map(|powers| unit(units, powers));
    let begin = run.energy();
    run.advance(steps).unwrap_or_else(|error| panic!("units of 2^{units:?}: {error}"));
    let state = run.state();
    let coordinates = state.q.flat().iter().map(|x| x / length).chain(state.p.flat().iter().map(|p| p / momentum));
    coordinates.chain([begin, run.energy()].map(|number| number / energy)).collect()
}

/// The longest unit of length in which the fourth power of a time over a distance is in range, as Kepler's equation needs it, and that
/// of a force.
const SOLVED: i32 = 200;
const OF_A_FORCE: i32 = 332;

fn assert_same_digits(longest: i32, digits: impl Fn([i32; 3]) -> Vec<f64>) {
    let expected = digits([0; 3]);
    assert!(expected.iter().all(|x| x.is_finite()));
    for units in UNITS.map(|[length, mass, time]| [length.clamp(-longest, longest), mass, time]) {
        assert_eq!(digits(units), expected, "units of 2^{units:?}");
    }
}

/// Declares systems with a test that their motion has the same digits in all units. Each row has a name, the annotation, the
/// parameters in units, the energies, the composition, the number of steps, and the start.
macro_rules! systems {
    (|$unit:ident| $(
        $name:ident [$($annotation:tt)*] { $($field:ident: $type:ty = $value:expr),* } { $($functions:tt)* }
            $composition:expr, $longest:ident, $steps:literal, $q:expr, $p:expr;
    )*) => {$(
        #[test]
        fn $name() {
            struct System { $($field: $type),* }

            #[hamiltonian($($annotation)*)]
            impl System { $($functions)* }

            assert_same_digits($longest, |units| {
                let $unit = |powers| unit(units, powers);
                let system = System { $($field: $value),* };
                let start = Phase::new(scaled($q, $unit(LENGTH)), scaled($p, $unit(MOMENTUM)));
                digits(system.run_with($composition, start, 0.02 * $unit(TIME)), units, $steps)
            });
        }
    )*};
}

/// Bodies on a grid with small displacements, and momenta of both signs.
fn grid(side: usize) -> Vec<[f64; 3]> {
    let wave = |n: usize| 0.1 * (1.3 * n as f64).sin();
    (0..side.pow(3))
        .map(|n| [n % side, n / side % side, n / side / side].map(|k| 1.1 * k as f64 + wave(n + 7 * k)))
        .collect()
}

fn momenta(count: usize) -> Vec<[f64; 3]> {
    (0..count).map(|n| [0, 1, 2].map(|k| 0.3 * (0.7 * n as f64 + f64::from(k)).cos())).collect()
}

systems! {
    |unit|
    few_bodies [compose = Yoshida4] { mass: f64 = 0.7 * unit(MASS), gravity: f64 = unit(GRAVITY) } {
        fn kinetic(&self, p: [[f64; 3]; 4]) -> f64 {
            p.iter().map(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * self.mass)).sum()
        }
        fn potential(&self, q: [[f64; 3]; 4]) -> f64 {
            let mut v = 0.0;
            for i in 0..4 {
                for j in 0..i {
                    let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                    v -= self.gravity * self.mass * self.mass / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
                }
            }
            v
        }
    } Yoshida4, OF_A_FORCE, 20, [[0.0, 0.1, 0.2], [1.1, 0.0, -0.3], [-0.9, 0.4, 0.0], [0.2, -1.3, 0.5]], [[0.1, 0.0, 0.2], [0.0, 0.5, 0.0], [0.0, -0.5, 0.1], [0.3, 0.0, 0.0]];

    many_bodies [] { mass: f64 = 0.7 * unit(MASS), gravity: f64 = unit(GRAVITY), softening: f64 = 0.1 * unit(LENGTH) } {
        fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
            p.iter().map(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * self.mass)).sum()
        }
        fn potential(&self, q: &[[f64; 3]]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() {
                for j in 0..i {
                    let (x, y, z) = (q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]);
                    v -= self.gravity * self.mass * self.mass / (x * x + y * y + z * z + self.softening.powi(2)).sqrt();
                }
            }
            v
        }
    } Verlet, OF_A_FORCE, 10, grid(3), momenta(27);

    neighbours_within_a_cutoff [] { mass: f64 = 0.7 * unit(MASS), strength: f64 = unit(ENERGY), cutoff: f64 = 1.6 * unit(LENGTH) } {
        fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
            p.iter().map(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * self.mass)).sum()
        }
        fn potential(&self, q: &[[f64; 3]]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() {
                for j in 0..i {
                    let (x, y, z) = (q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]);
                    let r2 = x * x + y * y + z * z;
                    if r2 < self.cutoff * self.cutoff {
                        let near = 1.0 - r2 / (self.cutoff * self.cutoff);
                        v += self.strength * near * near * near;
                    }
                }
            }
            v
        }
    } Verlet, OF_A_FORCE, 40, grid(8), momenta(512);

    chain [] { mass: f64 = 0.7 * unit(MASS), stiffness: f64 = unit(STIFFNESS), length: f64 = 0.8 * unit(LENGTH) } {
        fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| p * p / (2.0 * self.mass)).sum() }
        fn potential(&self, q: &[f64]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() - 1 {
                let d = (q[i + 1] - q[i]) / self.length;
                v += self.stiffness * self.length * self.length * (d * d / 2.0 - d.cos());
            }
            v
        }
    } BlanesMoanSrkn11, OF_A_FORCE, 20, (0..50).map(|i| 0.4 * (0.9 * f64::from(i)).sin()).collect::<Vec<_>>(), vec![0.1; 50];

    orbit [split = kepler + interaction] { mass: f64 = unit(MASS), gravity: f64 = unit(GRAVITY), spring: f64 = 0.2 * unit(STIFFNESS) } {
        fn kepler(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
            (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * self.mass)
                - self.gravity * self.mass * self.mass / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt()
        }
        fn interaction(&self, q: [f64; 3]) -> f64 { 0.5 * self.spring * q[2] * q[2] }
    } KahanLi8, SOLVED, 20, [0.6, 0.1, 0.3], [0.0, 1.1, 0.2];

    trap [split = quadratic + rest]
        { mass: f64 = 0.7 * unit(MASS), spring: f64 = unit(STIFFNESS), field: f64 = 0.4 * unit(FREQUENCY), length: f64 = 2.0 * unit(LENGTH) } {
        fn hamiltonian(&self, [x, y]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
            (a * a + b * b) / (2.0 * self.mass) + self.field * (x * b - y * a) + self.spring * (x * x + 1.3 * y * y) / 2.0
                + self.spring * self.length * self.length * (x / self.length).cos() * (y / self.length).sin()
        }
    } Yoshida4, OF_A_FORCE, 20, [0.3, -0.6], [0.2, 0.4];

    angles [] { mass: f64 = 0.7 * unit(MASS), energy: f64 = unit(ENERGY), softening: f64 = 0.3 * unit(LENGTH) } {
        fn kinetic(&self, p: [f64; 2]) -> f64 { p[0].hypot(p[1]).powi(2) / (2.0 * self.mass) }
        fn potential(&self, q: [f64; 2]) -> f64 {
            self.energy * (q[1].atan2(q[0]).cos() - 1.0 / (1.0 + q[0].hypot(q[1]).hypot(self.softening) / self.softening))
                + self.energy * (q[0] / self.softening).abs().powf(2.3) + self.energy * (q[1] / self.softening).cbrt().powi(4)
        }
    } KahanLi8, OF_A_FORCE, 20, [0.5, 0.4], [0.2, -0.4];
}

struct Planets {
    masses: Vec<f64>,
    gravity: f64,
}

#[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction)]
impl Planets {
    fn kinetic(&self, p: [[f64; 3]; 3]) -> f64 {
        let mut t = 0.0;
        for i in 0..3 {
            t += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * self.masses[i]);
        }
        t
    }
    fn potential(&self, q: [[f64; 3]; 3]) -> f64 {
        let mut v = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let (x, y, z) = (q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]);
                v -= self.gravity * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        v
    }
}

#[test]
fn planets_in_jacobi_coordinates() {
    assert_same_digits(SOLVED, |units| {
        let unit = |powers| unit(units, powers);
        let masses = [1.0, 1e-3, 3e-4].map(|mass| mass * unit(MASS)).to_vec();
        let system = Planets { masses, gravity: unit(GRAVITY) };
        let q = scaled([[0.0; 3], [1.0, 0.0, 0.1], [0.0, 2.1, 0.0]], unit(LENGTH));
        let p = scaled([[0.0; 3], [0.0, 1e-3, 0.0], [-2e-4, 0.0, 1e-5]], unit(MOMENTUM));
        digits(system.run_with(Aba1064, Phase::new(q, p), 0.02 * unit(TIME)), units, 20)
    });
}
