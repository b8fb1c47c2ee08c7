//! Runs, ensembles, checkpoints, deviation vectors and certificates of systems whose parts take inner steps.

use crate::derivatives;
use integrator_core::{
    Coords, Phase,
    check::{CertifyError, FlowLaw, Shortfall, certify},
    prelude::*,
};

/// A mass on a stiff spring with a slow force, driven in both.
#[derive(Clone, Copy)]
struct Stiff {
    stiffness: f64,
}

#[hamiltonian(split = well + 4 * (spring + kinetic), compose = Yoshida4)]
impl Stiff {
    fn well(&self, q: [f64; 2], t: f64) -> f64 {
        (q[0] - t).cos() + q[0] * q[1] * q[1]
    }
    fn spring(&self, q: [f64; 2], t: f64) -> f64 {
        0.5 * (self.stiffness + t.sin()) * q[0] * q[0] + q[1].powi(4)
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
}

/// Forces on three time scales.
struct Nested;

#[hamiltonian(split = far + 2 * (near + 3 * BlanesMoan4(bonds + kinetic)), compose = Yoshida4)]
impl Nested {
    fn far(&self, q: [f64; 2]) -> f64 {
        -q[0].cos()
    }
    fn near(&self, q: [f64; 2]) -> f64 {
        q[0] * q[1] * q[1]
    }
    fn bonds(&self, q: [f64; 2]) -> f64 {
        2.0 * q[0] * q[0] + q[1].powi(4)
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
}

const STIFF: Stiff = Stiff { stiffness: 30.0 };

fn start() -> Phase<[f64; 2]> {
    Phase { q: [0.4, -0.3], p: [0.2, 0.5] }
}

#[test]
fn members_have_the_bits_of_their_runs() {
    // Groups of eight members, and some that are left over.
    let members: Vec<_> = (0..21).map(|number| (Stiff { stiffness: 20.0 + f64::from(number) }, start())).collect();
    let mut swarm = Ensemble::new(Verlet.nested(3), members.clone(), 0.05).expect("members");
    let mut own = Ensemble::new(Yoshida4, members.clone(), 0.05).expect("members");
    for ensemble in [&mut swarm, &mut own] {
        ensemble.advance(13).and_then(|()| ensemble.advance(27)).expect("finite");
    }
    for ((member, swarm), own) in members.iter().zip(swarm.states()).zip(own.states()) {
        let (system, start) = member;
        let mut alone = system.run_with(Verlet.nested(3), *start, 0.05).expect("a start");
        alone.advance(40).expect("finite");
        assert_eq!(swarm, alone.state());
        let mut alone = system.run(*start, 0.05).expect("a start");
        alone.advance(40).expect("finite");
        assert_eq!(own, alone.state());
    }
}

/// The end of a run, at once and in portions.
fn portions<C: Coords>(mut run: impl FnMut() -> Result<Run<C>, Error>) {
    let (mut whole, mut parts) = (run().expect("a start"), run().expect("a start"));
    whole.advance(40).expect("finite");
    for steps in [0, 1, 25, 14] {
        parts.advance(steps).expect("finite");
        // Completes the step, and goes on from before the completion.
        let _ = parts.state();
    }
    assert_eq!(parts.state(), whole.state());
}

#[test]
fn portions_of_a_run_have_its_bits() {
    portions(|| STIFF.run_with(Verlet.nested(3), start(), 0.05));
    portions(|| STIFF.run_with(KahanLi8.nested(5), start(), 0.05));
    portions(|| Nested.run(start(), 0.05));
    portions(|| Nested.run_with(Verlet.nested(3), Phase::compensated([0.4, -0.3], [0.2, 0.5]), 0.05));
    portions(|| STIFF.run_with(Verlet.nested(3), Phase::new([0.4_f32, -0.3], [0.2, 0.5]), 0.05));
}

#[test]
fn a_resumed_run_is_the_uninterrupted_one() {
    for stop in [0, 1, 17] {
        let mut whole = STIFF.run_with(Verlet.nested(3), start(), 0.05).expect("a start").at_time(0.3);
        whole.advance(stop).expect("finite");
        let bytes = whole.checkpoint();
        let mut resumed = Run::<[f64; 2]>::resume_with(&STIFF, Verlet.nested(3), &bytes).expect("it was just made");
        whole.advance(40).expect("finite");
        resumed.advance(40).expect("finite");
        assert_eq!((resumed.state(), resumed.checkpoint()), (whole.state(), whole.checkpoint()), "after {stop} steps");
    }
}

#[test]
fn a_resumed_ensemble_is_the_uninterrupted_one() {
    let systems = (0..11).map(|number| Stiff { stiffness: 20.0 + f64::from(number) });
    let members = systems.clone().map(|system| (system, start()));
    let mut whole = Ensemble::new(Verlet.nested(3), members, 0.05).expect("members");
    whole.advance(17).expect("finite");
    let bytes = whole.checkpoint();
    let resume = |steps: u32| Ensemble::<[f64; 2]>::resume(Verlet.nested(steps), systems.clone(), &bytes);
    let mut resumed = resume(3).expect("it was just made");
    whole.advance(40).expect("finite");
    resumed.advance(40).expect("finite");
    assert!(resumed.states().eq(whole.states()));
    let refused = resume(4).expect_err("another number");
    assert_eq!(
        refused.to_string(),
        "this checkpoint was made with the composition `Verlet.nested(3)`, not `Verlet.nested(4)`"
    );
}

#[test]
fn another_number_of_inner_steps_does_not_resume_a_run() {
    let bytes = STIFF.run_with(Verlet.nested(4), start(), 0.05).expect("a start").checkpoint();
    let resume = |steps: u32| Run::<[f64; 2]>::resume_with(&STIFF, Verlet.nested(steps), &bytes);
    assert_eq!(
        resume(8).expect_err("another number").to_string(),
        "this checkpoint was made with the composition `Verlet.nested(4)`, not `Verlet.nested(8)`"
    );
    resume(4).expect("the same number");
    let refused = Run::<[f64; 2]>::resume_with(&STIFF, Verlet, &bytes).expect_err("the number of the annotation");
    assert_eq!(refused.to_string(), "this checkpoint was made with the composition `Verlet.nested(4)`, not `Verlet`");
}

#[test]
fn the_number_of_inner_steps_has_to_be_positive() {
    let refused = STIFF.run_with(Verlet.nested(0), start(), 0.05).expect_err("no inner steps");
    let message = "the number of inner steps is 0\nhelp: write, for example, `Verlet.nested(8)`";
    assert_eq!(refused.to_string(), message);
    let members = [(STIFF, start())];
    let refused = Ensemble::new(Verlet.nested(0), members, 0.05).expect_err("no inner steps");
    assert_eq!(refused.to_string(), format!("member 0: {message}"));
}

#[test]
fn deviation_vectors_are_derivatives_of_the_steps() {
    derivatives::holds("Yoshida4 over Verlet", &STIFF, Yoshida4, start(), 0.05);
    derivatives::holds("three inner steps", &STIFF, Verlet.nested(3), start(), 0.05);
    derivatives::holds("nested twice", &Nested, Yoshida4, start(), 0.05);
}

#[test]
fn inner_steps_are_certified() {
    for outcome in [
        certify(&STIFF, Verlet, start(), 0.01),
        certify(&STIFF, Verlet.nested(3), start(), 0.01),
        certify(&Nested, Aba864, start(), 0.05),
    ] {
        let certificate = outcome.unwrap_or_else(|error| panic!("{error}"));
        let claimed = f64::from(certificate.claimed_order);
        assert!(certificate.observed_order > claimed - 0.5, "{certificate}");
        assert!(certificate.symmetric, "{certificate}");
    }
}

/// A rotation whose flow the user wrote, in the parentheses.
#[derive(Clone)]
struct Own {
    frequency: f64,
}

#[hamiltonian(split = rest + 3 * (kick + oscillator))]
impl Own {
    fn rest(&self, q: [f64; 1]) -> f64 {
        q[0].cos()
    }
    fn kick(&self, q: [f64; 1]) -> f64 {
        q[0].powi(4)
    }
    fn oscillator(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        0.5 * (p[0] * p[0] + q[0] * q[0]).cosh()
    }
    #[flow(oscillator)]
    fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        let frequency = self.frequency * (p[0] * p[0] + q[0] * q[0]).sinh();
        let (sine, cosine) = (frequency * duration).sin_cos();
        (q[0], p[0]) = (cosine * q[0] + sine * p[0], cosine * p[0] - sine * q[0]);
    }
}

#[test]
fn a_wrong_flow_in_the_parentheses_is_not_certified() {
    let start = Phase { q: [0.4], p: [0.3] };
    certify(&Own { frequency: 1.0 }, Verlet, start, 0.05).unwrap_or_else(|error| panic!("{error}"));
    let Err(CertifyError::Refused { shortfalls, .. }) = certify(&Own { frequency: 1.000_001 }, Verlet, start, 0.05)
    else {
        panic!("a flow that is too fast passes")
    };
    let found = shortfalls.iter().any(|shortfall| {
        matches!(shortfall, Shortfall::Flow { part, law: FlowLaw::Generator, .. } if part.contains("oscillator"))
    });
    assert!(found, "{shortfalls:?}");
}
