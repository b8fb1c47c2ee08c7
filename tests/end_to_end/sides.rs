//! A force and an energy are on the same side of a condition, also where what it compares is equal but for a rounding.
//!
//! A potential is zero unless a function of the positions is at most `edge`. Bisection finds the least `edge` at which there is an
//! energy and the least at which there is a force: two numbers that have to be equal, whichever roundings are in them.

use integrator_core::{Coords, prelude::*};

/// Numbers between 0.5 and 1.5.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        0.5 + (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The least number within `1e-9` of `near`, relative to it, for which `holds`.
fn least(near: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (near * (1.0 - 1e-9), near * (1.0 + 1e-9));
    assert!(!holds(low) && holds(high), "it changes near {near}");
    while low.next_up() < high {
        let middle = low + (high - low) / 2.0;
        *if holds(middle) { &mut high } else { &mut low } = middle;
    }
    high
}

/// Checks that a system of this `edge` has a force where it has an energy; `near` is the value that the edge is compared with.
fn agree<C: Coords>(name: &str, near: f64, at: impl Fn(f64) -> Run<C>) {
    let of_energy = least(near, |edge| at(edge).potential() != 0.0);
    let of_force = least(near, |edge| {
        let mut run = at(edge);
        run.advance(1).expect("finite");
        run.kinetic() != 0.0
    });
    assert_eq!(of_energy, of_force, "{name} near {near}");
}

/// Systems in three dimensions with a potential where `value` is at most `self.edge`.
macro_rules! in_space {
    (|$s:ident, $q:ident| $($system:ident: $value:expr, $energy:expr;)+) => {
        $(
            struct $system { edge: f64, scale: f64 }

            #[hamiltonian]
            impl $system {
                fn kinetic(&self, p: [f64; 3]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) }
                fn potential(&self, $q: [f64; 3]) -> f64 {
                    let $s = self.scale;
                    let value = $value;
                    if value <= self.edge { 70.0 + $q[0] + value * $energy } else { 0.0 }
                }
            }
        )+

        #[test]
        fn a_force_ends_where_its_energy_does() {
            let mut numbers = Numbers(1);
            for _ in 0..40 {
                let ($q, $s) = ([0; 3].map(|_| numbers.next()), numbers.next());
                $(
                    agree(stringify!($system), $value, |edge| {
                        $system { edge, scale: $s }.run_with(Euler, Phase::new($q, [0.0; 3]), 0.01).expect("a run")
                    });
                )+
            }
        }
    };
}

in_space! {
    |s, q|
    SquareOfDistance: q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + s, 1.0;
    SquaresAreUsed: q[0] * q[0] + q[1] * q[1] + s * s, q[0] * q[0] * q[1] * q[1];
    Distance: s * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt(), q[1] * q[1];
    Scaled: s * q[0] * q[0] + q[1] * q[1] / s + s, q[0] * q[1];
    Inverse: s / (q[0] * q[0] + q[1] * q[1]).sqrt() + q[2] / (q[0] * q[0] + q[1] * q[1]), q[2];
    Angle: s + q[0] / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt(), q[0].sin();
    Powers: (q[0] / s).powi(-12) - (q[0] / s).powi(-6) + 20.0, (q[0] / s).powi(-6);
    LikeTerms: s * q[0] * q[1] * q[0] + q[1] * q[0] * q[0] + q[0] * q[1] * q[0] * s, q[0] * q[0] * q[1];
    SumOverComponents: (0..3).map(|d| s * q[d] * q[d]).sum::<f64>(), q[2] * q[2];
    RootCubed: s / (q[0] * q[0] + q[1] * q[1]).powf(1.5), q[1];
}

macro_rules! bodies {
    ($system:ident, $shape:ty) => {
        struct $system {
            edge: f64,
        }

        #[hamiltonian]
        impl $system {
            fn kinetic(&self, p: $shape) -> f64 {
                let mut energy = 0.0;
                for i in 0..p.len() {
                    energy += 0.5 * (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]);
                }
                energy
            }
            fn potential(&self, q: $shape) -> f64 {
                let mut energy = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let (x, y, z) = (q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]);
                        let square = x * x + y * y + z * z;
                        if square <= self.edge {
                            energy += 1.0 + 1.0 / square + x * x;
                        }
                    }
                }
                energy
            }
        }
    };
}

bodies!(Few, [[f64; 3]; 4]);
bodies!(Many, &[[f64; 3]]);

/// So many bodies far from each other, but for two: numbers `first` and `second`.
fn bodies(count: u16, [first, second]: [usize; 2], numbers: &mut Numbers) -> (Vec<[f64; 3]>, f64) {
    let mut q: Vec<[f64; 3]> = (0..count).map(|i| [100.0 + 40.0 * f64::from(i), 0.0, 0.0]).collect();
    let pair = [0; 2].map(|_| [0; 3].map(|_| numbers.next()));
    [q[first], q[second]] = pair;
    let square = (0..3).map(|d| (pair[0][d] - pair[1][d]).powi(2)).sum();
    (q, square)
}

/// All pairs of few bodies, rows of more, and the lists of neighbours of many.
#[test]
fn a_pair_has_a_force_where_it_has_an_energy() {
    let mut numbers = Numbers(2);
    for pair in [[0, 1], [3, 1], [2, 3]].into_iter().cycle().take(60) {
        let (q, square) = bodies(4, pair, &mut numbers);
        let start = Phase::new([0, 1, 2, 3].map(|i| q[i]), [[0.0; 3]; 4]);
        agree("4 bodies", square, |edge| Few { edge }.run_with(Euler, start, 0.01).expect("a run"));
    }
    for (count, times) in [(20, 60), (400, 3)] {
        for pair in [[0, 1], [17, 2], [8, 19]].into_iter().cycle().take(times) {
            let (q, square) = bodies(count, pair, &mut numbers);
            let start = Phase::new(q, vec![[0.0; 3]; usize::from(count)]);
            let at = |edge| Many { edge }.run_with(Euler, start.clone(), 0.01).expect("a run");
            agree(&format!("{count} bodies"), square, at);
        }
    }
}

/// Bonds along a line that hold while they are short.
struct Bonds {
    edge: f64,
}

#[hamiltonian]
impl Bonds {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let apart = q[i + 1] - q[i];
            let value = apart * apart + 0.3 * q[i] * q[i] + 0.7 * q[i + 1] * q[i + 1];
            if value <= self.edge {
                energy += 3.0 + value * apart;
            }
        }
        energy
    }
}

#[test]
fn a_bond_of_a_line_has_a_force_where_it_has_an_energy() {
    let mut numbers = Numbers(3);
    for bond in (0..40).cycle().take(120) {
        let mut q: Vec<f64> = (0..41).map(|site| if site % 2 == 0 { 10.0 } else { -10.0 }).collect();
        let (a, b) = (numbers.next(), numbers.next());
        [q[bond], q[bond + 1]] = [a, b];
        let value = (b - a) * (b - a) + 0.3 * a * a + 0.7 * b * b;
        let start = Phase::new(q, vec![0.0; 41]);
        agree("a bond", value, |edge| Bonds { edge }.run_with(Euler, start.clone(), 0.01).expect("a run"));
    }
}
