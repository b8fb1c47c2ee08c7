//! Step-size control of implicit methods by a `rate`.

use integrator_core::{
    CheckpointError, Ensemble, Error, GaussLegendre, Hamiltonian, Method, Paced, Phase, Run, Unsolved,
    check::symplectic_defect, hamiltonian,
};

macro_rules! comet {
    ($name:ident, $($split:tt)*) => {
        /// A body that is attracted by `pull/r`, seen from axes that turn with the angular velocity `turn`.
        #[derive(Clone, Copy)]
        struct $name {
            pull: f64,
            turn: f64,
            /// What the pace is less than the inverse of the distance.
            slow: f64,
        }

        #[hamiltonian($($split)*)]
        impl $name {
            fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
                (px * px + py * py) / 2.0 + self.turn * (y * px - x * py) - self.pull / x.hypot(y)
            }
            fn rate(&self, [x, y]: [f64; 2]) -> f64 {
                1.0 / x.hypot(y) - self.slow
            }
        }
    };
}
comet!(Comet, split = none);
comet!(InParts, split = quadratic + rest);

const COMET: Comet = Comet { pull: 1.0, turn: 0.3, slow: 0.0 };

fn at_pericentre(e: f64) -> Phase<[f64; 2]> {
    Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()])
}

fn numbers(Phase { q: [x, y], p: [px, py] }: Phase<[f64; 2]>) -> [f64; 4] {
    [x, y, px, py]
}

fn apart(a: [f64; 4], b: [f64; 4]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn errors_fall_with_the_order() {
    const SPAN: f64 = 20.0;
    fn end<X: Method<Comet>>(method: X, h: f64) -> [f64; 4] {
        let Phase { q, p } = at_pericentre(0.6);
        let mut run = COMET.run_with(method, Phase::compensated(q, p), h).expect("a start");
        run.advance_to(SPAN).expect("an end");
        assert_eq!(run.time(), SPAN);
        let Phase { q, p } = run.state();
        numbers(Phase::new(q.map(|x| x.value), p.map(|p| p.value)))
    }
    // Equal steps in the time: another field, and other steps.
    let exact = end(GaussLegendre::<8>, 0.02);
    let slopes = [
        (2.0, end(Paced(GaussLegendre::<1>), 0.02), end(Paced(GaussLegendre::<1>), 0.01)),
        (4.0, end(Paced(GaussLegendre::<2>), 0.1), end(Paced(GaussLegendre::<2>), 0.05)),
        (6.0, end(Paced(GaussLegendre::<3>), 0.2), end(Paced(GaussLegendre::<3>), 0.1)),
        (8.0, end(Paced(GaussLegendre::<4>), 0.2), end(Paced(GaussLegendre::<4>), 0.1)),
    ];
    for (claimed, coarse, fine) in slopes {
        let slope = (apart(coarse, exact) / apart(fine, exact)).log2();
        assert!((slope - claimed).abs() < 0.3, "claimed {claimed}, observed {slope}");
    }
    // Errors of 1e-16 times a thousand roundings, of velocities of 2 along orbits that drift apart linearly.
    assert!(apart(end(Paced(GaussLegendre::<8>), 0.4), exact) < 1e-12);
}

#[test]
fn steps_are_symplectic_at_an_energy() {
    let defect = symplectic_defect(&COMET, Paced(GaussLegendre::<3>), at_pericentre(0.3), 0.2).expect("a defect");
    // As for fixed steps: roundings of a few stages of numbers up to 2.
    assert!(defect < 1e-13, "{defect:e}");
}

#[test]
fn a_close_encounter_takes_as_many_steps_as_a_circle() {
    let start = at_pericentre(0.99);
    let mut run = COMET.run_with(Paced(GaussLegendre::<8>), start, 0.04).expect("a start");
    let energy = run.energy();
    // A period takes 2π of the fictitious time, whatever the eccentricity.
    run.advance(1_571).expect("ten periods");
    assert!((run.time() / (20.0 * std::f64::consts::PI) - 1.0).abs() < 0.01, "{}", run.time());
    // Roundings of 1/r = 100, a walk of 1571 steps of eight stages: 100 ε √12568 = 2.5e-12.
    assert!((run.energy() - energy).abs() < 2.5e-12, "{:e}", run.energy() - energy);
    let fixed = COMET.run_with(GaussLegendre::<8>, start, 0.04).expect("a start").advanced(1_571);
    assert!(fixed.is_none_or(|run| (run.energy() - energy).abs() > 1e-3), "steps of equal time miss the encounter");
}

trait Advanced: Sized {
    fn advanced(self, steps: u64) -> Option<Self>;
}

impl Advanced for Run<[f64; 2]> {
    fn advanced(mut self, steps: u64) -> Option<Self> {
        self.advance(steps).ok().map(|()| self)
    }
}

#[test]
fn members_have_the_bits_of_their_runs() {
    let members: Vec<_> = (0..9).map(|k| (COMET, at_pericentre(0.1 * f64::from(k)))).collect();
    let mut swarm = Ensemble::new(Paced(GaussLegendre::<6>), members.clone(), 0.2).expect("starts");
    let run = |member: usize| {
        let (comet, start) = members[member];
        comet.run_with(Paced(GaussLegendre::<6>), start, 0.2).expect("a start")
    };
    swarm.advance_to(3.0).expect("an end");
    for member in 0..members.len() {
        let mut run = run(member);
        run.advance_to(3.0).expect("an end");
        assert_eq!(swarm.state(member), Some(run.state()), "{member}");
    }
    swarm.advance(40).expect("an end");
    for member in 0..members.len() {
        let run = run(member).advanced(swarm.steps()).expect("an end");
        assert_eq!((swarm.state(member), swarm.time_of(member)), (Some(run.state()), Some(run.time())), "{member}");
    }
}

#[test]
fn h_in_parts_has_the_same_field() {
    let parts = InParts { pull: 1.0, turn: 0.3, slow: 0.0 };
    let mut one = COMET.run_with(Paced(GaussLegendre::<8>), at_pericentre(0.6), 0.3).expect("a start");
    let mut other = parts.run_with(Paced(GaussLegendre::<8>), at_pericentre(0.6), 0.3).expect("a start");
    one.advance_to(7.0).expect("an end");
    other.advance_to(7.0).expect("an end");
    // The energies are summed in another order: a hundred roundings of numbers up to 2.
    assert!(apart(numbers(one.state()), numbers(other.state())) < 200.0 * f64::EPSILON);
}

#[test]
fn portions_and_checkpoints_do_not_change_a_run() {
    let method = Paced(GaussLegendre::<4>);
    for steps in [0, 1, 137] {
        let begin = || COMET.run_with(method, at_pericentre(0.8), 0.1).expect("a start").at_time(0.3);
        let whole = begin().advanced(steps + 200).expect("an end");
        let mut portions = begin();
        (0..steps).for_each(|_| portions.advance(1).expect("a step"));
        let resumed = Run::resume_with(&COMET, method, &portions.checkpoint()).expect("it was just made");
        for run in [portions, resumed] {
            let run: Run<[f64; 2]> = run.advanced(200).expect("an end");
            assert_eq!((run.time(), run.state()), (whole.time(), whole.state()));
            assert_eq!(run.checkpoint(), whole.checkpoint());
        }
        let refused: Result<Run<[f64; 2]>, _> = Run::resume_with(&COMET, GaussLegendre::<4>, &whole.checkpoint());
        assert!(matches!(refused, Err(CheckpointError::Other { .. })));
    }
}

#[test]
fn a_rate_that_is_not_positive_ends_the_run_before_that_step() {
    // At the apocentre, 1/r is 1/1.6.
    let comet = Comet { slow: 0.7, ..COMET };
    let start = at_pericentre(0.6);
    let mut run = comet.run_with(Paced(GaussLegendre::<8>), start, 0.05).expect("a start");
    let error = run.advance(1_000).expect_err("a rate below zero");
    let Error::NotSolved { reason: Unsolved::Rate { value }, .. } = error else { panic!("{error}") };
    assert!(value <= 0.0, "{value}");
    let whole = comet.run_with(Paced(GaussLegendre::<8>), start, 0.05).expect("a start").advanced(run.steps());
    assert_eq!(whole.expect("an end").state(), run.state(), "the last state of which all is known");
    assert!(run.steps() > 10);
    // The other members go on, and each ends where its run does.
    let members = [comet, COMET, comet, COMET].map(|comet| (comet, start));
    let mut swarm = Ensemble::new(Paced(GaussLegendre::<8>), members, 0.05).expect("starts");
    assert!(matches!(swarm.advance(1_000), Err(Error::Lost(_))));
    assert_eq!(swarm.state(2), Some(run.state()));
    let other = COMET.run_with(Paced(GaussLegendre::<8>), start, 0.05).expect("a start").advanced(1_000);
    assert_eq!(swarm.state(3), other.map(|run| run.state()));
}
