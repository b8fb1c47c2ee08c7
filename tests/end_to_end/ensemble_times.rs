//! Ensembles that are shown at a time: each member as its run alone is, and the ensemble itself unchanged.

use integrator_core::{Coords, InLanes, prelude::*, taylor::Taylor};

/// A body that is attracted by `pull/r`.
#[derive(Clone, Copy)]
struct Comet {
    pull: f64,
    /// What the pace is less than the inverse square of the distance.
    slow: f64,
}

#[hamiltonian(taylor)]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.pull / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]) - self.slow
    }
}

/// Bodies on ellipses between 0.1 and 0.7, each with a pull of its own.
fn members() -> Vec<(Comet, Phase<[f64; 2]>)> {
    let member = |number: u32| {
        let e: f64 = 0.1 + 0.05 * f64::from(number);
        let start = Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()]);
        (Comet { pull: 1.0 + 0.01 * f64::from(number), slow: 0.0 }, start)
    };
    (0..13).map(member).collect()
}

/// Holds an ensemble at some times against runs alone.
fn shown<C: Coords + PartialEq>(mut swarm: Ensemble<C>, run: impl Fn(usize) -> Run<C>) {
    let mut runs: Vec<_> = (0..swarm.len()).map(&run).collect();
    let forward = runs[0].step().signum();
    for time in [0.0, 0.03, 0.5, 0.51, 4.0, 9.0].map(|time| forward * time) {
        swarm.advance_to(time).expect("a later time");
        assert_eq!(swarm.time(), time);
        for (member, (run, state)) in runs.iter_mut().zip(swarm.states()).enumerate() {
            run.advance_to(time).expect("a later time");
            assert_eq!(swarm.state(member), Some(run.state()), "member {member} at {time}");
            assert_eq!((swarm.time_of(member), swarm.energy(member)), (Some(time), Some(run.energy())));
            assert_eq!(state, run.state());
        }
    }
    // It goes on from the steps that all have taken, whatever was shown.
    let steps = swarm.steps() + 7;
    swarm.advance(7).expect("finite states");
    for member in 0..swarm.len() {
        let mut run = run(member);
        run.advance(steps).expect("finite states");
        assert_eq!((swarm.time_of(member), swarm.state(member)), (Some(run.time()), Some(run.state())));
    }
}

macro_rules! shown {
    ($method:expr, $start:expr, $h:expr) => {
        let members: Vec<_> = members().into_iter().map(|(comet, at)| (comet, $start(at.q, at.p))).collect();
        let swarm = Ensemble::new($method, members.clone(), $h).expect("members").with_threads(3);
        shown(swarm, |member| {
            let (comet, at) = members[member].clone();
            comet.run_with($method, at, $h).expect("a start")
        });
    };
}

#[test]
fn members_at_a_time_have_the_bits_of_their_runs() {
    for h in [0.05, -0.05] {
        shown!(Yoshida4, Phase::new, h);
        shown!(Logarithmic(Yoshida4), Phase::new, h);
        shown!(Paced(KahanLi8), Phase::new, h);
    }
    shown!(GaussLegendre4, Phase::new, 0.1);
    shown!(Taylor::tolerance(1e-12), Phase::new, 0.3);
    shown!(Power(0.5, Yoshida4), Phase::new, 0.05);
    shown!(Logarithmic(Yoshida4), Phase::compensated, 0.05);
    shown!(Verlet, Phase::compensated, 0.05);
}

#[test]
fn a_changed_state_is_shown_from_there_on() {
    let mut swarm = Ensemble::new(Logarithmic(Yoshida4), members(), 0.05).expect("members").at_time(2.0);
    swarm.advance_to(4.0).expect("a later time");
    let steps = swarm.steps();
    swarm.map_states(|_, state| state.p[1] *= 1.01).expect("states");
    swarm.advance_to(6.0).expect("a later time");
    for (member, (comet, at)) in members().into_iter().enumerate() {
        let mut run = comet.run_with(Logarithmic(Yoshida4), at, 0.05).expect("a start").at_time(2.0);
        run.advance(steps).expect("finite states");
        run.map_state(|state| state.p[1] *= 1.01).expect("a state");
        run.advance_to(6.0).expect("a later time");
        assert_eq!(swarm.state(member), Some(run.state()), "member {member}");
    }
}

/// Holds an ensemble whose members are lost against runs alone, and returns how many are.
fn some_lost<X: InLanes<Comet>>(method: X, members: Vec<(Comet, Phase<[f64; 2]>)>, h: f64) -> usize {
    let mut swarm = Ensemble::new(method, members.clone(), h).expect("members");
    let mut runs: Vec<_> =
        members.iter().map(|(comet, at)| comet.run_with::<f64, _>(method, *at, h).expect("a start")).collect();
    let mut gone = vec![false; runs.len()];
    for time in [0.2, 1.0, 2.0, 3.0, 6.0] {
        let lost = match swarm.advance_to(time) {
            Ok(()) => Vec::new(),
            Err(Error::Lost(lost)) => lost.members,
            Err(error) => panic!("{error}"),
        };
        let mut expected = Vec::new();
        for (member, run) in runs.iter_mut().enumerate() {
            if !gone[member] {
                gone[member] = run.advance_to(time).is_err();
                if gone[member] {
                    expected.push(member);
                }
            }
            assert_eq!(swarm.time_of(member), Some(run.time()), "member {member} at {time}");
            assert_eq!(swarm.state(member), Some(run.state()), "member {member} at {time}");
        }
        assert_eq!(lost.iter().map(|(member, _)| *member).collect::<Vec<_>>(), expected, "at {time}");
    }
    assert_eq!(swarm.active(), gone.iter().filter(|gone| !**gone).count());
    gone.iter().filter(|gone| **gone).count()
}

#[test]
fn members_that_fail_on_the_way_are_named() {
    // A pace that ends at a distance which only some of them reach, at times of their own.
    let slow = |(comet, start)| (Comet { slow: 0.8, ..comet }, start);
    let lost = some_lost(Paced(Yoshida4), members().into_iter().map(slow).collect(), 0.02);
    assert!((1..12).contains(&lost), "{lost}");
    // Those that are repelled cannot begin.
    let mut repelled = members();
    for (comet, _) in repelled.iter_mut().skip(1).step_by(3) {
        comet.pull = -1.0;
    }
    let lost = some_lost(Logarithmic(Yoshida4), repelled, 0.05);
    assert_eq!(lost, 4);
}

#[test]
fn a_time_that_is_over_is_refused() {
    let mut swarm = Ensemble::new(Yoshida4, members(), 0.01).expect("members");
    swarm.advance_to(1.005).expect("a later time");
    assert_eq!(swarm.advance_to(0.5), Err(Error::Passed { time: 0.5, present: 1.0 }));
    assert!(matches!(swarm.advance_to(f64::NAN), Err(Error::Time { .. })));
    assert_eq!(swarm.time(), 1.005);
    swarm.advance_to(1.001).expect("after the last step");
    let mut swarm = Ensemble::new(Logarithmic(Yoshida4), members(), 0.01).expect("members");
    swarm.advance(100).expect("finite states");
    let refused = swarm.advance_to(0.1);
    assert!(
        matches!(&refused, Err(Error::Member { member: 0, error }) if matches!(**error, Error::Passed { .. })),
        "{refused:?}"
    );
}
