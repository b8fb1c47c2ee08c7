//! Roots of sums of squares, from where they are zero: the motion is smooth along itself, and its series begins there.

use crate::runs::FINE;
use integrator_core::{KahanLi8, prelude::*, taylor::Taylor};

/// Potentials of the distance from an axis, and of the height along it.
#[derive(Clone, Copy)]
struct Distance {
    kind: u32,
}

const KINDS: u32 = 9;

#[hamiltonian(taylor)]
impl Distance {
    fn kinetic(&self, [a, b, c]: [f64; 3]) -> f64 {
        0.5 * (a * a + b * b + c * c)
    }
    fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
        let r = (x * x + y * y).sqrt();
        match self.kind {
            0 => r * r * r + z * z,
            1 => (x * x + y * y).powf(1.5) * (1.0 + z * z),
            2 => x.hypot(y).powi(5) + z.cos(),
            3 => x.hypot(y).hypot(z),
            4 => 1.0 - r.cos() + z * z,
            5 => x.hypot(y).cosh() + z * (r * r * r),
            6 => r * r * r * r + z * z,
            7 => 1.0 / (1.0 + r * r * r) + z * z,
            _ => z.hypot(r) * (1.0 + r * r * r),
        }
    }
}

/// Starts on the axis: across it, along it, from rest, and obliquely.
const STARTS: [[[f64; 3]; 2]; 4] = [
    [[0.0, 0.0, 0.7], [0.8, 0.0, 0.0]],
    [[0.0, 0.0, 0.7], [0.0, 0.0, 0.3]],
    [[0.0, 0.0, 0.7], [0.0, 0.0, 0.0]],
    [[0.0, 0.0, 0.7], [-0.3, 0.5, 0.2]],
];

#[test]
fn motions_leave_an_axis_as_they_do_by_small_steps() {
    for kind in 0..KINDS {
        for [q, p] in STARTS {
            for h in [0.125, -0.125] {
                let start = Phase::new(q, p);
                let mut run = Distance { kind }.run_with(Taylor::tolerance(FINE), start, h).expect("a start");
                run.advance(4).unwrap_or_else(|error| panic!("{kind} from {p:?}: {error}"));
                let mut reference = Distance { kind }.run_with(KahanLi8, start, h / 64.0).expect("a start");
                reference.advance(256).expect("a regular motion");
                for (found, expected) in run.state().q.into_iter().zip(reference.state().q) {
                    // The eighth power of the reference's step is below a rounding; it has some 4,000 stages of roundings.
                    assert!((found - expected).abs() < 1e-13, "{kind} from {p:?}, h = {h}: {found} and {expected}");
                }
                let steps = run.own_steps().expect("steps of its own").taken;
                assert!(steps < 64, "{kind} from {p:?}: {steps} steps");
            }
        }
    }
}

#[test]
fn members_of_ensembles_leave_an_axis_as_they_do_alone() {
    for kind in 0..KINDS {
        let beside = |shift: f64| STARTS.map(|[[x, y, z], p]| Phase::new([x + shift, y, z], p));
        let starts: Vec<_> = beside(0.0).into_iter().chain(beside(0.1)).chain(beside(-0.2)).collect();
        let members = starts.iter().map(|start| (Distance { kind }, *start));
        let mut swarm = Ensemble::new(Taylor::tolerance(FINE), members, 0.1).expect("members");
        swarm.advance(7).expect("finite states");
        for (number, start) in starts.into_iter().enumerate() {
            let mut alone = Distance { kind }.run_with(Taylor::tolerance(FINE), start, 0.1).expect("a start");
            for _ in 0..7 {
                alone.advance(1).expect("finite states");
            }
            assert_eq!(swarm.state(number), Some(alone.state()), "{kind}, member {number}");
        }
    }
}

/// A motion that stays where the formula has no derivative ends with an error, and does so at once.
#[test]
fn a_motion_at_a_pole_is_singular() {
    struct Pole;

    #[hamiltonian(taylor)]
    impl Pole {
        fn kinetic(&self, [a, b]: [f64; 2]) -> f64 {
            0.5 * (a * a + b * b)
        }
        fn potential(&self, [x, y]: [f64; 2]) -> f64 {
            let r = (x * x + y * y).sqrt();
            r - 1.0 / (1.0 + r)
        }
    }
    let run = Pole.run_with(Taylor::tolerance(FINE), Phase::new([0.0; 2], [0.3, 0.1]), 0.1);
    assert!(run.is_err() || run.is_ok_and(|mut run| run.advance(1).is_err()));
}
