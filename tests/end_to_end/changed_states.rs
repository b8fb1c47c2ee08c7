//! States that are changed between two steps, and watches that look after each.

use crate::{divergence::diverged, systems::HenonHeiles};
use integrator_core::{__private::Precision, Method, prelude::*, taylor::Taylor};

/// A driven pendulum, or one left alone.
struct Driven;

#[hamiltonian(taylor)]
impl Driven {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        -q[0].cos() * (1.0 + 0.3 * t.sin()) - (q[1] - q[0]).cos()
    }
}

/// The same bits as a run that begins there.
#[test]
fn a_changed_state_is_continued_like_a_start() {
    fn check<K: Precision>(method: impl Method<Driven>, start: Phase<[K; 2]>, kicked: K)
    where
        [f64; 2]: integrator_core::Coords<With<K> = [K; 2]>,
    {
        let change = |state: &mut Phase<[K; 2]>| state.p[1] = kicked;
        let mut run = Driven.run_with::<K, _>(method, start, 0.125).expect("a good start").at_time(3.0);
        run.advance(1_000).expect("bounded");
        run.map_state(change).expect("a finite state");
        let mut fresh = Driven.run_with::<K, _>(method, run.state(), 0.125).expect("a good start").at_time(run.time());
        assert_eq!((run.steps(), run.time()), (1_000, 128.0));
        assert_eq!(run.state().p[1], kicked);
        for portion in [0, 1, 7, 2_000] {
            run.advance(portion).expect("bounded");
            fresh.advance(portion).expect("bounded");
            assert_eq!((run.state(), run.time()), (fresh.state(), fresh.time()));
            assert_eq!(run.energy(), fresh.energy());
        }
    }
    let start = Phase::new([1.0, 0.5], [0.0, 0.2]);
    check(Verlet, start, 0.75);
    check(VelocityVerlet, start, 0.75);
    check(Chin4C, start, 0.75);
    check(BlanesCasasMurua8, start, 0.75);
    check(Taylor::tolerance(1e-15), start, 0.75);
    check(Yoshida4, Phase::new([1.0_f32, 0.5], [0.0, 0.2]), 0.75);
    let compensated = Phase::compensated(start.q, start.p);
    check(KahanLi8, compensated, compensated.q[1]);
}

/// Members that fill some motions and leave lanes over.
const MEMBERS: usize = 37;

/// In every precision; those that are gone before stay where they are, and those that go later are at the right step.
#[test]
fn members_are_changed_as_runs_are() {
    macro_rules! check {
        ($method:expr, $start:expr) => {
            let start = |member: usize| $start(0.02 * member as f64);
            let members = (0..MEMBERS).map(|member| (Driven, start(member)));
            let mut swarm = Ensemble::new($method, members, 0.125).expect("good starts").at_time(3.0);
            let mut runs: Vec<_> = (0..MEMBERS)
                .map(|member| Driven.run_with($method, start(member), 0.125).expect("a good start").at_time(3.0))
                .collect();
            let late = |member: usize| member % 5 == 2;
            let gone = |member: usize| member % 3 == 1;
            swarm.advance_while(100, 50, |member, _| !gone(member)).expect("bounded");
            for (member, run) in runs.iter_mut().enumerate() {
                run.advance(if gone(member) { 50 } else { 100 }).expect("bounded");
            }
            for portion in [0, 1, 7, 1_100] {
                swarm.map_states(|member, state| state.p[1] = start(member).q[1]).expect("finite states");
                swarm.advance_while(portion, 7, |member, _| !late(member)).expect("bounded");
                for (member, run) in runs.iter_mut().enumerate() {
                    if swarm.steps_of(member) > Some(run.steps()) || swarm.steps_of(member) == Some(swarm.steps()) {
                        run.map_state(|state| state.p[1] = start(member).q[1]).expect("a finite state");
                        run.advance(swarm.steps_of(member).expect("a member") - run.steps()).expect("bounded");
                    }
                    assert_eq!(swarm.state(member), Some(run.state()), "member {member} with {}", stringify!($method));
                    assert_eq!(
                        swarm.energy(member),
                        Some(run.energy()),
                        "member {member} with {}",
                        stringify!($method)
                    );
                }
            }
            assert_eq!((swarm.steps(), swarm.time()), (1_208, 154.0));
            assert_eq!(swarm.active(), (0..MEMBERS).filter(|member| !gone(*member) && !late(*member)).count());
        };
    }
    check!(Verlet, |x: f64| Phase::new([1.0, 0.5 + x], [0.0, 0.2]));
    check!(BlanesCasasMurua8, |x: f64| Phase::new([1.0, 0.5 + x], [0.0, 0.2]));
    check!(Taylor::tolerance(1e-15), |x: f64| Phase::new([1.0, 0.5 + x], [0.0, 0.2]));
    check!(Yoshida4, |x: f64| Phase::new([1.0_f32, 0.5 + x as f32], [0.0, 0.2]));
    check!(VelocityVerlet, |x: f64| Phase::compensated([1.0, 0.5 + x], [0.0, 0.2]));
}

/// Members are lost at the step and the time of the ensemble, and a change that is refused for one of them changes none.
#[test]
fn changed_members_are_named_when_they_fail() {
    let start = |member: usize| Phase::new([0.1, 0.001 * member as f64], [0.0, 0.2]);
    let far = |member: usize| member % 9 == 4;
    let out =
        |member: usize, state: &mut Phase<[f64; 2]>| state.q[0] += if far(member) { 1.0 + member as f64 } else { 0.0 };
    let mut swarm =
        Ensemble::new(Verlet, (0..MEMBERS).map(|member| (HenonHeiles, start(member))), 0.1).expect("good starts");
    swarm.advance(100).expect("bounded");
    let before: Vec<_> = swarm.states().collect();
    let refused = swarm.map_states(|member, state| state.p[1] = if member < 20 { 0.0 } else { f64::NAN });
    let Err(Error::Member { member: 20, error }) = refused else { panic!("{refused:?}") };
    assert!(matches!(*error, Error::Start { coordinate: "p", index: 1, .. }), "{error}");
    assert_eq!(swarm.states().collect::<Vec<_>>(), before);
    swarm.map_states(out).expect("finite states");
    let Err(Error::Lost(lost)) = swarm.advance(5_000) else { panic!("some members escape") };
    assert_eq!(lost.members.len(), (0..MEMBERS).filter(|member| far(*member)).count());
    // Those that are lost stay.
    swarm.map_states(|_, state| state.p[0] += 0.001).expect("finite states");
    for member in 0..MEMBERS {
        let mut run = HenonHeiles.run_with(Verlet, start(member), 0.1).expect("a good start");
        run.advance(100).expect("bounded");
        run.map_state(|state| out(member, state)).expect("a finite state");
        match (run.advance(5_000), lost.members.iter().find(|(name, _)| *name == member)) {
            (Ok(()), None) => run.map_state(|state| state.p[0] += 0.001).expect("a finite state"),
            (Err(Error::Diverged(expected)), Some((_, divergence))) => assert_eq!(*divergence, expected),
            (outcome, lost) => panic!("member {member}: alone {outcome:?}, in the ensemble {lost:?}"),
        }
        assert_eq!(
            (swarm.state(member), swarm.steps_of(member)),
            (Some(run.state()), Some(run.steps())),
            "member {member}"
        );
    }
}

#[test]
fn a_state_that_is_refused_changes_nothing() {
    let start = || Driven.run(Phase::new([1.0, 0.5], [0.0, 0.2]), 0.01).expect("a good start");
    let (mut run, mut other) = (start(), start());
    run.advance(10).expect("bounded");
    other.advance(10).expect("bounded");
    let refused = run.map_state(|state| state.q[1] = f64::INFINITY);
    assert_eq!(refused, Err(Error::Start { coordinate: "q", index: 1, value: f64::INFINITY }));
    run.advance(10).expect("bounded");
    other.advance(10).expect("bounded");
    assert_eq!(run.state(), other.state());
}

/// `H = p²/2 + q - ln q`: beyond the pole at zero the force is finite, and the energy is not a number.
struct Pole;

#[hamiltonian]
impl Pole {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        q.iter().map(|q| q - q.ln()).sum()
    }
}

fn over_the_pole() -> Run<Vec<f64>> {
    Pole.run(Phase::new(vec![1.0], vec![-8.0]), 0.3).expect("a good start")
}

/// Oscillators that are bound to the second one, and by a condition to the sixth.
struct Bound {
    strengths: Vec<f64>,
}

#[hamiltonian]
impl Bound {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for strength in &self.strengths {
            v += strength * (q[1] - q[0]).cos();
            if q.len() > 5 {
                v += q[5] * q[5];
            }
        }
        v
    }
}

/// Generated code reads a coordinate before a loop if all iterations read the same one, even if there are none.
#[test]
fn a_start_has_the_coordinates_that_are_read_by_number() {
    for strengths in [vec![], vec![0.5, 2.0]] {
        let system = Bound { strengths };
        let start = |length| Phase::new(vec![0.5; length], vec![0.1; length]);
        let few = system.run(start(1), 0.01).map(|_| ());
        assert_eq!(few, Err(Error::FewCoordinates { least: 2, length: 1 }));
        let members = [2, 1].map(|length| (Bound { strengths: system.strengths.clone() }, start(length)));
        let few = Ensemble::new(Verlet, members, 0.01).map(|_| ());
        assert!(matches!(few, Err(Error::Member { member: 1, .. })), "{few:?}");
        for length in [2, 6] {
            let mut run = system.run(start(length), 0.01).expect("all that is read");
            run.advance(3).expect("bounded");
        }
    }
}

#[test]
fn a_state_keeps_its_coordinates_and_its_energy() {
    let mut run = Pole.run(Phase::new(vec![1.0], vec![0.1]), 0.01).expect("a good start");
    run.advance(10).expect("bounded");
    let before = run.state();
    let longer = run.map_state(|state| {
        state.q.push(1.0);
        state.p.push(0.0);
    });
    assert_eq!(longer, Err(Error::Resized { before: 1, after: 2 }));
    let unequal = run.map_state(|state| state.q.push(1.0));
    assert_eq!(unequal, Err(Error::Length { positions: 2, momenta: 1 }));
    let beyond = run.map_state(|state| state.q[0] = -1.0);
    assert!(matches!(beyond, Err(Error::Energy { function: "potential", .. })), "{beyond:?}");
    assert_eq!(run.state(), before);
    assert_eq!(run.kinetic() + run.potential(), run.energy());
}

#[test]
fn a_watch_stops_at_the_same_step_in_any_portions() {
    const STEPS: u64 = 3_000;
    let start = || {
        let mut run = Pole.run(Phase::new(vec![1.0], vec![1.5]), 0.2).expect("a good start");
        run.watch_energy(0.05).expect("a good bound");
        run
    };
    let mut single = start();
    let stop = (0..STEPS).find_map(|_| single.advance(1).err()).expect("the step is too long for this bound");
    let Error::EnergyStrayed { step, energy, before, bound, .. } = stop.clone() else { panic!("{stop}") };
    assert_eq!((single.steps(), bound, before), (step - 1, 0.05, start().energy()));
    // At the start, both T and V are above zero.
    assert!((energy - before).abs() > bound * before);
    assert!((single.energy() - before).abs() <= bound * before);
    for portion in [2, 7, STEPS] {
        let mut run = start();
        let stopped = (0..STEPS).find_map(|_| run.advance(portion).err());
        assert_eq!((stopped, run.state()), (Some(stop.clone()), single.state()), "in portions of {portion}");
    }
    // The bits are those of a run that nobody watches, and a looser watch lets it pass.
    let mut free = Pole.run(Phase::new(vec![1.0], vec![1.5]), 0.2).expect("a good start");
    free.advance(step - 1).expect("finite");
    assert_eq!(free.state(), single.state());
    single.watch_energy(f64::INFINITY).expect("a good bound");
    single.advance(1).expect("finite");
    free.advance(1).expect("finite");
    assert_eq!(free.state(), single.state());
}

#[test]
fn a_watch_sees_an_energy_that_is_not_a_number() {
    let mut run = over_the_pole();
    run.advance(1).expect("the force is finite on both sides");
    assert!(run.energy().is_nan() && run.potential().is_nan() && run.kinetic().is_finite(), "{run:?}");
    let mut watched = over_the_pole();
    watched.watch_energy(f64::INFINITY).expect("a good bound");
    assert!(matches!(watched.advance(100), Err(Error::EnergyStrayed { step: 1, .. })));
    assert_eq!(watched.state(), over_the_pole().state());
}

#[test]
fn a_watch_needs_a_bound_and_an_energy_that_is_conserved() {
    for bound in [0.0, -1.0] {
        assert_eq!(over_the_pole().watch_energy(bound), Err(Error::WatchBound { bound }));
    }
    assert!(matches!(over_the_pole().watch_energy(f64::NAN), Err(Error::WatchBound { .. })));
    let mut driven = Driven.run(Phase::new([1.0, 0.5], [0.0, 0.2]), 0.01).expect("a good start");
    assert_eq!(driven.watch_energy(0.1), Err(Error::NotConserved));
}

#[test]
fn a_divergence_names_the_coordinate_and_shows_few_numbers() {
    /// Hills side by side.
    struct Hills;

    #[hamiltonian]
    impl Hills {
        fn kinetic(&self, p: &[f64]) -> f64 {
            p.iter().map(|p| 0.5 * p * p).sum()
        }
        fn potential(&self, q: &[f64]) -> f64 {
            q.iter().map(|q| -q.powi(4)).sum()
        }
    }

    let mut q = vec![0.0; 1_000];
    q[700] = 1.0;
    let hills = || Phase::new(q.clone(), vec![0.0; 1_000]);
    let mut run = Hills.run(hills(), 0.05).expect("a good start");
    let divergence = diverged(run.advance(1_000));
    assert_eq!(divergence.coordinate.map(|(_, index)| index), Some(700), "{divergence}");
    let text = divergence.to_string();
    assert!(text.contains("first in") && text.contains("q[699..703] = [0.0, ") && text.len() < 500, "{text}");
    let mut swarm = Ensemble::new(Verlet, (0..20).map(|_| (Hills, hills())), 0.05).expect("good starts");
    let Err(Error::Lost(lost)) = swarm.advance(1_000) else { panic!("{swarm:?}") };
    assert!(lost.members.iter().all(|(_, each)| *each == divergence), "{lost}");
    assert_eq!(format!("{:?}", Error::from(lost.clone())), lost.to_string(), "what `main` shows is the sentence");
}

/// A change between two steps would have been made at the step before, in silence.
#[test]
fn states_within_a_step_are_not_changed() {
    let start = Phase::new([1.0, 0.5], [0.0, 0.2]);
    let mut run = Driven.run_with(Verlet, start, 0.125).expect("a good start");
    run.advance_to(1.0).expect("bounded");
    run.map_state(|state| state.p[1] *= 1.5).expect("the end of a step");
    run.advance_to(1.1).expect("bounded");
    let shown = run.state();
    assert_eq!(run.map_state(|state| state.p[1] *= 1.5), Err(Error::WithinStep { time: 1.1, present: 1.0 }));
    assert_eq!((run.state(), run.time()), (shown, 1.1));
    run.advance(1).expect("bounded");
    run.map_state(|state| state.p[1] *= 1.5).expect("the end of a step");
}
