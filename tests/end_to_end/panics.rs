//! A panic in the user's functions that a program catches leaves runs and ensembles at their last steps.

use integrator_core::{Method, Progress, prelude::*};
use std::{
    ops::ControlFlow,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::atomic::{AtomicUsize, Ordering},
};

/// A free particle over a law that is tabulated up to `end` and panics beyond, whatever the side.
#[derive(Clone)]
struct Tabulated {
    end: f64,
}

#[hamiltonian]
impl Tabulated {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.law(q[0])
    }
    #[derivative(slope)]
    fn law(&self, x: f64) -> f64 {
        self.within(x);
        0.5 * x
    }
    #[derivative(bend)]
    fn slope(&self, x: f64) -> f64 {
        self.within(x);
        0.5
    }
    #[derivative(bend)]
    fn bend(&self, _x: f64) -> f64 {
        0.0
    }
    fn within(&self, x: f64) {
        assert!(x.abs() <= self.end, "{x} is beyond the table");
    }
}

/// Thrown at a constant force, it comes to the end of the table after some thousand steps.
const H: f64 = 0.001;
const BEYOND: u64 = 100_000;

fn thrown(p: f64) -> Phase<[f64; 1]> {
    Phase::new([0.0], [p])
}

fn panics(function: impl FnOnce()) -> bool {
    catch_unwind(AssertUnwindSafe(function)).is_err()
}

fn stays_at_its_last_step<X: Method<Tabulated>>(method: X) {
    let start = || Tabulated { end: 5.0 }.run_with(method, thrown(1.0), H).expect("a good start");
    let mut single = start();
    while !panics(|| single.advance(1).expect("finite")) {}
    let last = single.steps();
    // The table ends at the second root of t - t²/4 = -5.
    assert!((6_800..7_000).contains(&last), "{last}");
    for portion in [BEYOND, 1_000, 1_024, 7] {
        let mut run = start();
        while !panics(|| run.advance(portion).expect("finite")) {}
        assert_eq!((run.steps(), run.state()), (last, single.state()), "in portions of {portion}");
        assert!(panics(|| run.advance(1).expect("finite")), "the next step is the one that panics");
        assert_eq!((run.steps(), run.state()), (last, single.state()));
    }
    let mut exact = start();
    exact.advance(last).expect("finite");
    assert_eq!(exact.state(), single.state(), "the bits of a run that stops by itself");
}

#[test]
fn a_run_stays_at_its_last_step() {
    stays_at_its_last_step(Verlet);
    stays_at_its_last_step(VelocityVerlet);
    stays_at_its_last_step(Yoshida4);
}

/// Members with tables of several lengths, so that each halts at its own time and some do not halt at all.
fn ends() -> impl Iterator<Item = f64> {
    (0..40).map(|member| if member % 7 == 3 { 3.0 + member as f64 / 10.0 } else { 1e9 })
}

#[test]
fn failed_members_stay_at_their_last_steps_and_the_others_continue() {
    const STEPS: u64 = 9_000;
    let members = || ends().map(|end| (Tabulated { end }, thrown(1.0)));
    for threads in [1, 3] {
        let mut swarm = Ensemble::new(Yoshida4, members(), H).expect("good starts").with_threads(threads);
        assert!(panics(|| swarm.advance(STEPS).expect("nothing is lost")));
        assert_eq!((swarm.steps(), swarm.active()), (STEPS, ends().filter(|end| *end > 1e8).count()));
        for (member, end) in ends().enumerate() {
            let mut alone = Tabulated { end }.run_with(Yoshida4, thrown(1.0), H).expect("a good start");
            assert_eq!(panics(|| alone.advance(STEPS).expect("finite")), end < 1e8);
            assert_eq!(swarm.steps_of(member), Some(alone.steps()), "member {member}");
            assert_eq!(swarm.state(member), Some(alone.state()), "member {member}");
        }
        swarm.advance(STEPS).expect("those who are left go on");
        assert_eq!(swarm.steps(), 2 * STEPS);
    }
}

#[test]
fn callbacks_that_panic_stop_no_other_run() {
    let members = (0..40).map(|_| (Tabulated { end: 1e9 }, thrown(1.0)));
    let mut swarm = Ensemble::new(Verlet, members, H).expect("good starts");
    let outcome = || swarm.advance_while(500, 100, |member, _| member != 3 || panic!("asked")).expect("finite");
    assert!(panics(outcome));
    assert_eq!((swarm.steps(), swarm.active(), swarm.steps_of(3)), (500, 39, Some(100)));
    let calls = AtomicUsize::new(0);
    let outcome = || {
        let progress = |_: &Progress| {
            assert!(calls.fetch_add(1, Ordering::Relaxed) == 0, "told");
            ControlFlow::Continue(())
        };
        swarm.advance_with(500, progress).expect("finite");
    };
    assert!(panics(outcome));
    assert!((501..=1_000).contains(&swarm.steps()) && swarm.active() == 39, "{swarm:?}");
}
