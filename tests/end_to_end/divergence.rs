//! A run that leaves the finite numbers stops, says where, and stays at its last finite state.

use crate::catalogue::for_each_composition;
use integrator_core::{Divergence, prelude::*};

/// A particle on a hill that falls off ever more steeply: it is gone after a finite time.
struct Hill;

#[hamiltonian]
impl Hill {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].powi(4)
    }
}

fn fall<X: Composition<Hill>>(composition: X, h: f64) -> Run<[f64; 1]> {
    Hill.run_with(composition, Phase::new([1.0], [0.0]), h).expect("an admissible start").at_time(5.0)
}

pub(crate) fn diverged(outcome: Result<(), Error>) -> Divergence {
    match outcome {
        Err(Error::Diverged(divergence)) => divergence,
        other => panic!("not a divergence: {other:?}"),
    }
}

#[test]
fn the_error_names_the_first_bad_step_and_the_run_stays_before_it() {
    fn check<X: Composition<Hill>>(composition: X, h: f64) {
        let mut run = fall(composition, h);
        let divergence = diverged(run.advance(1_000_000));
        let last = divergence.step - 1;
        assert_eq!(divergence.time, 5.0 + divergence.step as f64 * h, "{}", X::NAME);
        assert_eq!((run.steps(), run.time()), (last, 5.0 + last as f64 * h), "{}", X::NAME);
        assert_eq!((&divergence.q[..], &divergence.p[..]), (&run.state().q[..], &run.state().p[..]), "{}", X::NAME);
        assert!(divergence.q[0].is_finite() && divergence.p[0].is_finite(), "{}: {divergence}", X::NAME);

        // Up to there nothing is wrong, and the state is the same.
        let mut shorter = fall(composition, h);
        shorter.advance(last).expect("the last finite state");
        assert_eq!(shorter.state(), run.state(), "{}", X::NAME);
        // Step by step the run ends in the same place.
        let mut single = fall(composition, h);
        let outcome = loop {
            if let Err(error) = single.advance(1) {
                break Err(error);
            }
        };
        assert_eq!(diverged(outcome), divergence, "{}", X::NAME);
        // It does not get any further, however often it is asked.
        assert_eq!(diverged(run.advance(1)), divergence, "{}", X::NAME);
        assert_eq!(run.state(), shorter.state(), "{}", X::NAME);
        run.advance(0).expect("staying is possible");
    }
    macro_rules! each {
        ($($composition:ident)*) => {
            // The fall takes about a time unit: a few steps, a few blocks of a thousand steps, and where a step is so
            // long that a finite momentum moves the position beyond all numbers.
            $(for h in [0.05, 3e-4, 1e9] {
                check($composition, h);
            })*
        };
    }
    for_each_composition!(general_kinds: each!);
    for_each_composition!(quadratic_kinds: each!);
}

#[test]
fn every_state_before_a_divergence_is_finite() {
    fn check<X: Composition<Hill>>(composition: X) {
        for exponent in 0..60 {
            let mut run = fall(composition, 10_f64.powf(f64::from(exponent) / 2.0));
            while run.advance(1).is_ok() {
                let state = run.state();
                assert!(
                    state.q[0].is_finite() && state.p[0].is_finite(),
                    "{} with {:e} after {} steps: {state:?}",
                    X::NAME,
                    run.step(),
                    run.steps()
                );
                assert!(run.steps() < 1000, "{}: the fall ends", X::NAME);
            }
        }
    }
    macro_rules! each {
        ($($composition:ident)*) => {
            $(check($composition);)*
        };
    }
    for_each_composition!(general_kinds: each!);
    for_each_composition!(quadratic_kinds: each!);
}

/// A force that is not a number left of zero, which a kernel survives where what undoes the processor does not.
struct Slide;

#[hamiltonian]
impl Slide {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].powf(1.5)
    }
}

#[test]
fn processed_runs_end_at_the_same_step_in_any_portions() {
    const STEPS: u64 = 40;
    fn check<X: Composition<Slide>>(composition: X) {
        for h in [0.05, 0.1, 0.2, 0.4] {
            let starts: Vec<_> = (0..200).map(|k| Phase::new([0.5], [-0.8 - f64::from(k) * 1.5e-3])).collect();
            let mut swarm = Ensemble::new(composition, starts.iter().map(|start| (Slide, *start)), h).expect("starts");
            let _lost = swarm.advance(STEPS);
            for (member, start) in starts.iter().enumerate() {
                let mut whole = Slide.run_with(composition, *start, h).expect("an admissible start");
                let mut single = whole.clone();
                let ends = whole.advance(STEPS);
                let ends_singly = (0..STEPS).try_for_each(|_| {
                    single.advance(1)?;
                    let state = single.state();
                    assert!(state.q[0].is_finite() && state.p[0].is_finite(), "{} shows {state:?}", X::NAME);
                    Ok(())
                });
                assert_eq!(ends, ends_singly, "{} from {start:?} by {h}", X::NAME);
                assert_eq!((whole.steps(), whole.state()), (single.steps(), single.state()), "{}", X::NAME);
                assert_eq!(swarm.steps_of(member), Some(whole.steps()), "{} from {start:?} by {h}", X::NAME);
                assert_eq!(swarm.state(member), Some(whole.state()), "{} from {start:?} by {h}", X::NAME);
            }
        }
    }
    check(BlanesCasasRos6);
    check(TakahashiImada4);
    check(BlanesCasasMurua6S11);
    check(BlanesCasasMurua6S13);
    check(BlanesCasasMurua8);
    check(VelocityVerlet);
}

#[test]
fn samples_end_with_the_error() {
    let mut samples = fall(Verlet, 0.05).samples(1);
    let mut finite = 0;
    let error = loop {
        match samples.next() {
            Some(Ok(_)) => finite += 1,
            Some(Err(error)) => break error,
            None => panic!("the error comes before the end"),
        }
    };
    let divergence = diverged(Err(error));
    assert_eq!(divergence.step, finite, "the samples are the start and the steps before");
    assert!(samples.next().is_none(), "nothing comes after the error");
}

#[test]
fn the_message_says_where_and_what_to_do() {
    let divergence = Divergence {
        step: 12,
        time: 0.6,
        limit: f64::INFINITY,
        coordinate: Some(("q", 0)),
        q: vec![1e300],
        p: vec![-2.0],
    };
    assert_eq!(
        Error::from(divergence).to_string(),
        "the state after step 12 (t = 0.6) is not finite, first in q[0]\nhelp: use a smaller step, or check the forces \
         near the last finite state\nnote: the run stays at this state, q = [1e300], p = [-2.0]"
    );
}
