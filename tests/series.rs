//! Series that are written out term by term: they move as the loop over tables that a user could have written.
//!
//! All of it holds on every instruction set. A process uses one, so [`instruction_sets`] runs these tests again in a
//! process for each of the others.

#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use integrator_core::{check::certify, prelude::*, taylor::Taylor};

/// Defines the tables of a potential, and the potential as sums that are written out: one times a parameter, one times a function
/// of the time.
macro_rules! series {
    ($($c:literal $w:literal $a:literal),*) => {
        const TABLE: &[[f64; 3]] = &[$([$c, $w, $a]),*];
        const C: [f64; TABLE.len()] = column(0);
        const W: [f64; TABLE.len()] = column(1);
        const A: [f64; TABLE.len()] = column(2);

        #[derive(Clone)]
        struct Written {
            strength: f64,
        }

        #[hamiltonian(compose = Yoshida4, taylor, sensitive(strength))]
        impl Written {
            fn kinetic(&self, p: [f64; 2]) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
            fn potential(&self, q: [f64; 2], t: f64) -> f64 {
                let x = q[0] + 0.5 * q[1];
                let wave = 0.0 $(+ $c * ($w * x - $a).sin())*;
                q[1] * q[1] + self.strength * wave + 0.1 * t.cos() * (0.0 $(- (x * $w).cos() / $a)*)
            }
        }
    };
}

/// One column of the table.
const fn column(number: usize) -> [f64; TABLE.len()] {
    let (mut column, mut row) = ([0.0; TABLE.len()], 0);
    while row < column.len() {
        column[row] = TABLE[row][number];
        row += 1;
    }
    column
}

series!(
    0.31 2.1 0.37, -0.25 2.9 1.74, 0.11 3.3 2.91, 0.23 4.7 0.55, -0.17 5.9 1.22, 0.13 6.1 2.68, 0.12 7.3 0.19, -0.09 8.7 3.05,
    0.08 9.1 1.41, 0.07 1.9 2.29, -0.07 1.7 0.83, 0.06 1.3 1.96, 0.05 2.3 2.47, 0.05 2.7 0.64, -0.04 3.1 1.13, 0.04 3.7 2.82,
    0.03 4.1 0.46, 0.03 4.3 1.58, -0.03 5.3 3.11, 0.03 5.7 0.92, 0.02 6.7 2.05, 0.02 7.1 1.37, -0.02 7.9 0.28, 0.02 8.3 2.54,
    0.02 8.9 1.83, 0.01 9.7 0.71, -0.01 1.1 2.16, 0.01 1.5 1.02, 0.01 2.5 2.99, 0.01 3.5 0.34, -0.01 4.5 1.67, 0.01 5.5 2.38
);

/// The same, as a user would write it.
#[derive(Clone)]
struct Looped {
    strength: f64,
}

#[hamiltonian(compose = Yoshida4, taylor, sensitive(strength))]
impl Looped {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let x = q[0] + 0.5 * q[1];
        // Before the sums, as in the other form: factors are multiplied in the order in which the function names them first.
        let season = 0.1 * t.cos();
        let (mut wave, mut other) = (0.0, 0.0);
        for k in 0..C.len() {
            wave += C[k] * (W[k] * x - A[k]).sin();
            other -= (W[k] * x).cos() / A[k];
        }
        q[1] * q[1] + self.strength * wave + season * other
    }
}

const STRENGTH: f64 = 0.7;

fn systems() -> (Written, Looped) {
    (Written { strength: STRENGTH }, Looped { strength: STRENGTH })
}

fn start() -> Phase<[f64; 2]> {
    Phase::new([0.3, -0.2], [0.1, 0.4])
}

/// How far apart two sums may be whose terms are `size` in all: each addition of either order rounds once, and each term a few times
/// its size.
fn bound(size: f64) -> f64 {
    (2.0 * TABLE.len() as f64 + 20.0) * f64::EPSILON * size
}

/// The force by a plain loop, and the sum of the sizes of its terms.
fn force(q: [f64; 2], t: f64) -> ([f64; 2], f64) {
    let x = q[0] + 0.5 * q[1];
    let (mut slope, mut size) = (0.0, (2.0 * q[1]).abs());
    for [c, w, a] in TABLE {
        let terms = [STRENGTH * c * w * (w * x - a).cos(), 0.1 * t.cos() * w * (w * x).sin() / a];
        slope += terms[0] + terms[1];
        // A cosine or a sine errs with its argument, by a rounding of each part of that.
        let phase = 1.0 + (w * x).abs() + a;
        size += ((STRENGTH * c * w).abs() + 0.1 * w / a) * phase;
    }
    ([-slope, -0.5 * slope - 2.0 * q[1]], size)
}

#[test]
fn forces_and_energies_are_those_of_a_plain_loop() {
    let (written, looped) = systems();
    for x in [-2.3, -0.4, 0.0, 0.9, 3.1] {
        // A kick by a step of one is the force at the start.
        let mut run = written.run_with(Euler, Phase::new([x, 0.2], [0.0; 2]), 1.0).expect("a start");
        run.advance(1).expect("a step");
        let (expected, size) = force([x, 0.2], 0.0);
        for (found, expected) in run.state().p.into_iter().zip(expected) {
            assert!((found - expected).abs() <= bound(size), "{found} and {expected} at {x}");
        }
        let (at, expected) = (Phase::new([x, 0.2], [0.0; 2]), written.potential([x, 0.2], 0.0));
        let found = written.run(at, 0.1).expect("a start").energy();
        assert!((found - expected).abs() <= bound(size), "{found} and {expected} at {x}");
        assert_eq!(looped.run(at, 0.1).expect("a start").energy(), found, "{x}");
    }
}

/// A value that is bitwise identical for both systems.
macro_rules! same {
    ($system:ident, $value:expr) => {{
        let (written, looped) = systems();
        let of_written = {
            let $system = &written;
            $value
        };
        let of_looped = {
            let $system = &looped;
            $value
        };
        assert_eq!(of_written, of_looped);
        of_written
    }};
}

#[test]
fn a_series_moves_like_the_loop_that_a_user_would_write() {
    let vectors = [Phase::new([1.0, 0.0], [0.0; 2]), Phase::new([0.0; 2], [0.0, 1.0])];
    let end = same!(system, {
        let mut run = system.run(start(), 0.05).expect("a run");
        run.advance(200).expect("finite");
        run.state()
    });
    assert_ne!(end, start());
    same!(system, {
        let mut run = system.run_with(Taylor::tolerance(1e-12), start(), 0.2).expect("a run");
        run.advance(20).expect("finite");
        run.state()
    });
    same!(system, {
        let mut tangent = system.tangent(Yoshida4, start(), vectors, 0.05).expect("vectors");
        tangent.advance(50).expect("finite");
        tangent.vectors().to_vec()
    });
    let slopes = same!(system, {
        let mut tangent = system.sensitivities(Yoshida4, start(), [], 0.05).expect("no vectors");
        tangent.advance(50).expect("finite");
        tangent.vectors().to_vec()
    });
    assert_ne!(slopes[0].q[0], 0.0);
}

#[test]
fn members_of_an_ensemble_move_like_runs() {
    let members = (0..11).map(|number| (Written { strength: 0.1 * f64::from(number) }, start()));
    let mut ensemble = Ensemble::new(Yoshida4, members.clone(), 0.05).expect("members");
    ensemble.advance(60).expect("finite");
    for (number, (system, start)) in members.enumerate() {
        let mut run = system.run(start, 0.05).expect("a run");
        run.advance(60).expect("finite");
        assert_eq!(ensemble.state(number), Some(run.state()), "member {number}");
    }
}

#[test]
fn a_series_is_certified() {
    let certificate = certify(&systems().0, Yoshida4, start(), 0.02);
    assert!(certificate.is_ok(), "{certificate:?}");
}
