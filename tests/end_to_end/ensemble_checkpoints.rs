//! Checkpoints of ensembles: one that is resumed is the one that was never interrupted.

use crate::systems::Pendulum;
use integrator_core::{
    __private::{LaneScalars, joined, part_of},
    CheckpointError, Coords, ResumableInLanes,
    prelude::*,
};

const MEMBERS: usize = 37;

fn pendulum(member: usize) -> Pendulum {
    Pendulum { mass: 1.0, length: 0.5 + member as f64 / 40.0, gravity: 9.81 }
}

/// A swing whose push depends on the time, of as many links as its state has.
struct Pushed;

#[hamiltonian(compose = Yoshida4)]
impl Pushed {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        q.iter().map(|q| -q.cos() - 0.1 * q * t.sin()).sum()
    }
}

/// A planet in Jacobi coordinates, whose motion has coordinates of its own.
struct Planets {
    masses: [f64; 2],
}

#[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction)]
impl Planets {
    fn kinetic(&self, p: [[f64; 2]; 2]) -> f64 {
        (0..2).map(|i| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.masses[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 2]) -> f64 {
        let mut sum = 0.0;
        for i in 0..2 {
            for j in 0..i {
                let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                sum -= self.masses[i] * self.masses[j] / (x * x + y * y).sqrt();
            }
        }
        sum
    }
}

/// What is not at rest falls out of the numbers.
struct Fall;

#[hamiltonian]
impl Fall {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].powi(6)
    }
}

/// Advances, saves, resumes and advances an ensemble beside one that is not interrupted.
fn interrupted<H, C, X>(method: X, member: impl Fn(usize) -> (H, Phase<C>), h: f64)
where
    H: Hamiltonian,
    C: Coords,
    C::Leaf: LaneScalars,
    X: ResumableInLanes<H>,
    H::Coords: Coords<With<C::Leaf> = C>,
{
    for steps in [0, 1, 137] {
        let mut whole = Ensemble::new::<H, X>(method, (0..MEMBERS).map(&member), h).unwrap().at_time(0.25);
        let outcome = whole.advance_while(steps, 1, |member, _| member % 10 != 3);
        assert!(matches!(outcome, Ok(()) | Err(Error::Lost(_))), "{outcome:?}");
        let bytes = whole.checkpoint();
        let systems = || (0..MEMBERS).map(|i| member(i).0);
        let mut resumed = Ensemble::<C>::resume::<H, X>(method, systems(), &bytes).unwrap();
        let halves = [0..11, 11..MEMBERS].map(|half| {
            let (whole, half) = part_of(&bytes, half).unwrap();
            assert_eq!(whole, MEMBERS);
            half
        });
        assert!(joined(&halves).unwrap() == bytes);
        assert_eq!(resumed.checkpoint(), bytes);
        let mut half = Ensemble::<C>::resume::<H, X>(method, systems().skip(11), &halves[1]).unwrap();
        for ensemble in [&mut whole, &mut resumed, &mut half] {
            let outcome = ensemble.advance(100);
            assert!(matches!(outcome, Ok(()) | Err(Error::Lost(_))), "{outcome:?}");
        }
        assert_eq!((whole.steps(), whole.time(), whole.active()), (resumed.steps(), resumed.time(), resumed.active()));
        assert!(whole.states().eq(resumed.states()) && whole.states().skip(11).eq(half.states()));
        for i in 0..MEMBERS {
            let of = |ensemble: &Ensemble<C>| {
                (ensemble.steps_of(i), ensemble.time_of(i), ensemble.energy(i).map(f64::to_bits))
            };
            assert_eq!(of(&whole), of(&resumed));
        }
    }
}

#[test]
fn a_resumed_ensemble_is_bitwise_identical_to_an_uninterrupted_one() {
    interrupted(Yoshida4, |i| (pendulum(i), Phase::new([i as f64 / 20.0], [0.1])), 0.01);
    interrupted(Yoshida4, |i| (pendulum(i), Phase::compensated([i as f64 / 20.0], [0.1])), 0.01);
    interrupted(ImplicitMidpoint, |i| (pendulum(i), Phase::new([i as f64 / 20.0], [0.1])), 0.01);
    interrupted(Yoshida4, |i| (Pushed, Phase::new(vec![0.1; i % 3 + 1], vec![i as f64 / 9.0; i % 3 + 1])), 0.01);
    let planets = |i: usize| {
        let start = Phase::new([[0.0, 0.0], [1.0 + i as f64 / 50.0, 0.0]], [[0.0, -1e-3], [0.0, 1e-3]]);
        (Planets { masses: [1.0, 1e-3] }, start)
    };
    interrupted(Verlet, planets, 0.05);
    interrupted(Verlet, |i| (Fall, Phase::new([if i % 9 == 4 { 1.5 } else { 0.0 }], [0.0])), 0.1);
}

#[test]
fn other_ensembles_and_bytes_are_refused() {
    let member = |i: usize| (pendulum(i), Phase::new([i as f64 / 20.0], [0.1]));
    let mut whole = Ensemble::new(Yoshida4, (0..MEMBERS).map(member), 0.01).unwrap();
    whole.advance(10).unwrap();
    let bytes = whole.checkpoint();
    let resume = |systems: usize, bytes: &[u8]| {
        Ensemble::<[f64; 1]>::resume(Yoshida4, (0..systems).map(pendulum), bytes).map(|_| ())
    };
    assert!(resume(MEMBERS, &bytes).is_ok());
    assert!(matches!(resume(5, &bytes), Err(CheckpointError::Members { stored: MEMBERS, asked: 5 })));
    let others = (0..MEMBERS).map(|i| pendulum(i + usize::from(i >= 7)));
    let refused = Ensemble::<[f64; 1]>::resume(Yoshida4, others, &bytes);
    assert!(matches!(refused, Err(CheckpointError::Member { member: 7, .. })));
    let refused = Ensemble::<[f64; 1]>::resume(Verlet, (0..MEMBERS).map(pendulum), &bytes);
    assert!(matches!(refused, Err(CheckpointError::Other { what: "composition", .. })));
    let refused = Ensemble::<[f64; 1]>::resume(Yoshida4, (0..MEMBERS).map(|_| Fall), &bytes);
    assert!(matches!(refused, Err(CheckpointError::Other { what: "system", .. })));
    let run = pendulum(0).run(Phase::new([0.1], [0.0]), 0.1).unwrap().checkpoint();
    assert!(matches!(resume(1, &run), Err(CheckpointError::Foreign)));
    for place in (0..bytes.len()).step_by(7) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 4;
        assert!(resume(MEMBERS, &damaged).is_err(), "byte {place}");
        assert!(resume(MEMBERS, &bytes[..place]).is_err(), "{place} bytes");
    }
    assert!(matches!(part_of(&bytes, 30..MEMBERS + 1), Err(CheckpointError::Members { .. })));
    assert!(joined(&[]).is_err());
    whole.advance(1).unwrap();
    assert!(matches!(joined(&[bytes, whole.checkpoint()]), Err(CheckpointError::Damaged)));
}
