//! Ensembles: every member is the run that it would be alone, bit for bit, whoever its neighbours are.

use crate::systems::HenonHeiles;
use integrator_core::{CheckpointError, Progress, prelude::*};
use std::ops::ControlFlow;

#[derive(Clone)]
struct Pendulum {
    mass: f64,
    length: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.mass * self.length * q[0].cos()
    }
}

fn pendulum(member: usize) -> (Pendulum, Phase<[f64; 1]>) {
    let x = member as f64;
    (Pendulum { mass: 1.0 + x / 7.0, length: 0.5 + x / 50.0 }, Phase::new([0.1 + x / 40.0], [x / 90.0]))
}

/// More than any number of members that go together: six motions of sixteen lanes, and more of them that fill neither a
/// group nor a motion.
const MANY: usize = 6 * 16 + 21;

#[test]
fn members_are_identical_to_their_lone_runs() {
    for members in [1, 2, 9, MANY] {
        let mut swarm = Ensemble::new(Yoshida4, (0..members).map(pendulum), 0.01).expect("an ensemble");
        swarm.advance(700).expect("finite");
        swarm.advance(1300).expect("finite");
        assert_eq!((swarm.len(), swarm.active()), (members, members));
        assert_eq!((swarm.steps(), swarm.time()), (2000, 2000.0 * 0.01));
        let states: Vec<_> = swarm.states().collect();
        assert_eq!(states.len(), members);
        for (member, state) in states.into_iter().enumerate() {
            let (system, start) = pendulum(member);
            let mut alone = system.run(start, 0.01).expect("a run");
            alone.advance(2000).expect("finite");
            assert_eq!(state, alone.state(), "member {member} of {members}");
            assert_eq!(swarm.state(member), Some(alone.state()), "member {member} of {members}");
            assert_eq!(swarm.energy(member), Some(alone.energy()), "member {member} of {members}");
            assert_eq!(swarm.steps_of(member), Some(2000));
        }
        assert_eq!((swarm.state(members), swarm.energy(members), swarm.steps_of(members)), (None, None, None));
    }
}

#[test]
fn threads_change_nothing() {
    // Enough steps that other threads are started.
    let run = |threads| {
        let ensemble = Ensemble::new(KahanLi8, (0..MANY).map(pendulum), 0.05).expect("an ensemble");
        let mut ensemble = ensemble.with_threads(threads);
        ensemble.advance(1200).expect("finite");
        ensemble.states().collect::<Vec<_>>()
    };
    let alone = run(1);
    assert_eq!(alone, run(2));
    assert_eq!(alone, run(7));
}

#[test]
fn progress_is_reported_in_order_and_to_the_end() {
    for threads in [1, 2] {
        let mut swarm =
            Ensemble::new(Verlet, (0..MANY).map(pendulum), 0.01).expect("an ensemble").with_threads(threads);
        let mut told = Vec::new();
        let taken = swarm.advance_with(5000, |progress| {
            told.push(progress.done);
            ControlFlow::Continue(())
        });
        assert_eq!(taken, Ok(5000));
        assert!(told.is_sorted(), "{told:?}");
        assert!(told.iter().any(|done| (1..5000).contains(done)), "nothing on the way: {told:?}");
        assert_eq!(told.last(), Some(&5000));
        let mut quiet = Ensemble::new(Verlet, (0..MANY).map(pendulum), 0.01).expect("an ensemble");
        quiet.advance(5000).expect("finite");
        assert!(swarm.states().eq(quiet.states()));
    }
}

/// Beyond its escape energy of 1/6 a Hénon–Heiles orbit falls to infinity, the earlier the further out it begins.
fn orbit(member: usize) -> (HenonHeiles, Phase<[f64; 2]>) {
    let x = if FAR.contains(&member) { 1.0 + member as f64 } else { 0.1 };
    (HenonHeiles, Phase::new([x, 0.001 * member as f64], [0.0, 0.2]))
}

/// Some in the lanes of one motion, some in others.
const FAR: [usize; 5] = [3, 5, 12, 13, MANY - 1];

#[test]
fn a_failed_member_is_named_and_disturbs_no_other() {
    let mut swarm = Ensemble::new(Verlet, (0..MANY).map(orbit), 0.1).expect("an ensemble");
    let Err(Error::Lost(lost)) = swarm.advance(5000) else { panic!("some members escape") };
    let names: Vec<usize> = lost.members.iter().map(|(member, _)| *member).collect();
    assert_eq!(names, FAR);
    assert!(lost.to_string().contains("5 members failed (3, 5, 12"), "{lost}");
    assert_eq!(swarm.active(), MANY - FAR.len());
    swarm.advance(500).expect("those that are left are finite");
    for member in 0..MANY {
        let (system, start) = orbit(member);
        let mut alone = system.run_with(Verlet, start, 0.1).expect("a run");
        match (alone.advance(5500), lost.members.iter().find(|(name, _)| *name == member)) {
            (Ok(()), None) => {}
            (Err(Error::Diverged(expected)), Some((_, divergence))) => assert_eq!(*divergence, expected),
            (outcome, lost) => panic!("member {member}: alone {outcome:?}, in the ensemble {lost:?}"),
        }
        assert_eq!(swarm.state(member), Some(alone.state()), "member {member}");
        // Far out it is NaN.
        let energy = swarm.energy(member).map(f64::to_bits);
        assert_eq!(energy, Some(alone.energy().to_bits()), "member {member}");
        assert_eq!(swarm.steps_of(member), Some(alone.steps()), "member {member}");
    }
}

/// What a lone run does that stops where `stays` says so, which is asked after every `interval` steps.
fn alone_while(member: usize, steps: u64, interval: u64) -> (u64, Phase<[f64; 1]>) {
    let (system, start) = pendulum(member);
    let mut run = system.run(start, 0.01).expect("a run");
    while run.steps() < steps {
        run.advance(interval.min(steps - run.steps())).expect("finite");
        if run.steps().is_multiple_of(interval) && !swings_out(&run.state()) {
            break;
        }
    }
    (run.steps(), run.state())
}

/// Whether a pendulum is still on its way out.
fn swings_out(state: &Phase<[f64; 1]>) -> bool {
    state.p[0] > -0.1
}

#[test]
fn finished_members_are_removed_and_the_others_continue() {
    for (steps, interval, threads) in [(60, 7, 1), (3000, 1, 2), (2500, 2000, 1)] {
        let swarm = Ensemble::new(Yoshida4, (0..MANY).map(pendulum), 0.01).expect("an ensemble");
        let mut swarm = swarm.with_threads(threads);
        swarm.advance_while(steps, interval, |_, state| swings_out(state)).expect("finite");
        let alone: Vec<_> = (0..MANY).map(|member| alone_while(member, steps, interval)).collect();
        let gone = alone.iter().filter(|(taken, state)| *taken < steps || !swings_out(state)).count();
        assert!((1..=MANY).contains(&gone), "{gone} have left");
        for (member, (taken, state)) in alone.iter().enumerate() {
            assert_eq!(swarm.steps_of(member), Some(*taken), "member {member} every {interval}");
            assert_eq!(swarm.state(member).as_ref(), Some(state), "member {member} every {interval}");
        }
        // Those who are left go on as if nothing had been asked.
        let left: Vec<_> = (0..MANY).filter(|member| swarm.steps_of(*member) == Some(swarm.steps())).collect();
        swarm.advance(500).expect("finite");
        for (member, (taken, _)) in alone.iter().enumerate() {
            let (system, start) = pendulum(member);
            let mut run = system.run(start, 0.01).expect("a run");
            let goes_on = swarm.steps_of(member) == Some(steps + 500);
            assert!(!goes_on || left.contains(&member));
            run.advance(if goes_on { steps + 500 } else { *taken }).expect("finite");
            assert_eq!(swarm.state(member), Some(run.state()), "member {member} later");
            assert_eq!(swarm.energy(member), Some(run.energy()), "member {member} later");
        }
    }
}

#[test]
fn callbacks_get_the_indices_of_members() {
    let mut swarm = Ensemble::new(Verlet, (0..MANY).map(pendulum), 0.01).expect("an ensemble");
    swarm.advance_while(100, 10, |member, _| member % 3 != 0).expect("finite");
    assert_eq!(swarm.active(), MANY - MANY.div_ceil(3));
    swarm.advance_while(100, 10, |member, _| member % 3 != 1).expect("finite");
    swarm.advance_while(100, 10, |_, _| false).expect("finite");
    assert_eq!(swarm.active(), 0);
    swarm.advance(100).expect("nobody is left to be lost");
    assert_eq!(swarm.steps(), 400);
    for member in 0..MANY {
        assert_eq!(swarm.steps_of(member), Some([10, 110, 210][member % 3]), "member {member}");
    }
    assert_eq!(swarm.advance_while(1, 0, |_, _| true), Err(Error::SampleInterval));
}

/// Members of different sizes share no lanes.
struct Chain {
    stiffness: f64,
    bonds: usize,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum::<f64>()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for i in 0..self.bonds {
            v += 0.5 * self.stiffness * (q[i + 1] - q[i]).powi(4);
        }
        v
    }
}

#[test]
fn members_of_different_sizes_run_in_one_ensemble() {
    let member = |i: usize| {
        let bonds = 2 + i / 10;
        let q: Vec<f64> = (0..=bonds).map(|site| (site + i) as f64 / 9.0).collect();
        let p = vec![0.1; q.len()];
        (Chain { stiffness: 1.0 + i as f64, bonds }, Phase::new(q, p))
    };
    let mut swarm = Ensemble::new(Verlet, (0..25).map(member), 0.01).expect("an ensemble");
    swarm.advance(300).expect("finite");
    for i in 0..25 {
        let (system, start) = member(i);
        let mut alone = system.run(start, 0.01).expect("a run");
        alone.advance(300).expect("finite");
        assert_eq!(swarm.state(i), Some(alone.state()), "member {i}");
    }
}

/// A particle in a well of fourth order: three coordinates.
struct Well;

#[hamiltonian]
impl Well {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let r2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
        0.5 * r2 + 0.25 * r2 * r2
    }
}

/// Every member of an ensemble is its lone run, from starts that `start` names.
macro_rules! members_are_alone {
    ($system:expr, $start:expr) => {
        let mut swarm =
            Ensemble::new(Verlet, (0..MANY).map(|i| ($system, $start(i as f64))), 0.1).expect("an ensemble");
        swarm.advance(100).expect("finite");
        for i in 0..MANY {
            let mut alone = $system.run_with(Verlet, $start(i as f64), 0.1).expect("a run");
            alone.advance(100).expect("finite");
            assert_eq!(swarm.state(i), Some(alone.state()), "member {i} of {}", stringify!($system));
        }
    };
}

/// In every precision and for motions of every size that goes together, of which there are 2, 3, 4 and 6 on AVX-512.
#[test]
fn members_of_any_precision_and_size_are_identical_to_their_lone_runs() {
    members_are_alone!(HenonHeiles, |x: f64| Phase::new([0.1, 0.001 * x], [0.0, 0.2]));
    members_are_alone!(HenonHeiles, |x: f64| Phase::new([0.1_f32, 0.001 * x as f32], [0.0, 0.2]));
    members_are_alone!(HenonHeiles, |x: f64| Phase::compensated([0.1, 0.001 * x], [0.0, 0.2]));
    members_are_alone!(Well, |x: f64| Phase::new([0.1, 0.01 * x, 0.3], [0.0, 0.2, -0.1]));
    members_are_alone!(Well, |x: f64| Phase::new([0.1_f32, 0.01 * x as f32, 0.3], [0.0, 0.2, -0.1]));
    members_are_alone!(Well, |x: f64| Phase::compensated([0.1, 0.01 * x, 0.3], [0.0, 0.2, -0.1]));
}

/// Left of zero, forces are finite and energies are not numbers.
#[derive(Clone)]
struct Gamma {
    shape: f64,
}

#[hamiltonian]
impl Gamma {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] - self.shape * q[0].ln()
    }
}

/// A watched member ends at the step at which a watched run of its own does, with the same error and state, in any portions.
#[test]
fn watched_members_are_watched_runs() {
    fn same<
        H: Hamiltonian<Coords = [f64; N]> + Clone,
        X: integrator_core::Method<H> + integrator_core::InLanes<H>,
        const N: usize,
    >(
        method: X,
        bound: f64,
        member: impl Fn(usize) -> (H, Phase<[f64; N]>),
        h: f64,
    ) -> usize {
        let mut ended = 0;
        for portions in [&[100][..], &[1, 60, 39]] {
            let mut swarm = Ensemble::new(method, (0..MANY).map(&member), h).expect("an ensemble");
            swarm.watch_energy(bound).expect("energies");
            let mut errors = vec![None; MANY];
            for steps in portions {
                match swarm.advance(*steps) {
                    Ok(()) => {}
                    Err(Error::Strayed { members }) => {
                        members.into_iter().for_each(|(member, error)| errors[member] = Some(error));
                    }
                    Err(error) => panic!("{error}"),
                }
            }
            ended = errors.iter().flatten().count();
            assert_eq!((swarm.steps(), swarm.active()), (100, MANY - ended));
            for (number, error) in errors.iter().enumerate() {
                let (system, start) = member(number);
                let mut alone = system.run_with(method, start, h).expect("a run");
                alone.watch_energy(bound).expect("an energy");
                // As text, since NaN is unequal to itself.
                assert_eq!(
                    format!("{:?}", error.as_ref()),
                    format!("{:?}", alone.advance(100).err()),
                    "member {number}"
                );
                assert_eq!(swarm.state(number), Some(alone.state()), "member {number}");
                assert_eq!(swarm.steps_of(number), Some(alone.steps()));
                assert_eq!(swarm.time_of(number), Some(alone.time()));
            }
        }
        ended
    }
    let gamma = |member: usize| (Gamma { shape: 0.1 }, Phase::new([0.5], [0.1 * member as f64 - 3.0]));
    let unwatched = {
        let mut swarm = Ensemble::new(Verlet, (0..MANY).map(gamma), 0.1).expect("an ensemble");
        swarm.advance(100).expect("forces are finite");
        (0..MANY).filter(|member| !swarm.energy(*member).is_some_and(f64::is_finite)).count()
    };
    assert!(unwatched > 10, "{unwatched} go on without an energy");
    let ended = same(Verlet, f64::INFINITY, gamma, 0.1);
    assert!(ended >= unwatched && ended < MANY, "{ended}");
    let ended = same(Yoshida4, 1e-6, pendulum, 0.05);
    assert!(ended > 10 && ended < MANY, "{ended}");
}

#[test]
fn a_watch_on_an_ensemble_is_refused_as_that_of_a_run() {
    let mut swarm = Ensemble::new(Yoshida4, (0..3).map(pendulum), 0.01).expect("an ensemble");
    assert!(matches!(swarm.watch_energy(0.0), Err(Error::WatchBound { .. })));
    assert!(matches!(swarm.watch_energy(f64::NAN), Err(Error::WatchBound { .. })));
    // From a changed state on, its energy counts.
    swarm.watch_energy(1e-3).expect("energies");
    swarm.map_states(|_, state| state.p[0] += 5.0).expect("states");
    swarm.advance(100).expect("within the bound");
}

#[test]
fn all_refused_members_are_named_and_the_others_continue_on_request() {
    let start = |member: usize| match member {
        2 => (Gamma { shape: 0.1 }, Phase::new([f64::NAN], [0.0])),
        // The potential has no value there.
        5 | 7 => (Gamma { shape: 0.1 }, Phase::new([-1.0], [0.0])),
        _ => (Gamma { shape: 0.1 }, Phase::new([1.0 + member as f64], [0.0])),
    };
    let refused = Ensemble::new(Verlet, (0..9).map(start), 0.01).expect_err("three are refused");
    let text = refused.to_string();
    let Error::Members { members, count: 9 } = refused else { panic!("{text}") };
    assert_eq!(members.iter().map(|(member, _)| *member).collect::<Vec<_>>(), [2, 5, 7]);
    assert!(
        text.starts_with("3 of 9 members are invalid (2, 5, 7); member 2: the initial state is not finite"),
        "{text}"
    );
    let (mut swarm, others) = Ensemble::of_admissible(Verlet, (0..9).map(start), 0.01).expect("six are not");
    // As text, since NaN is unequal to itself.
    assert_eq!(format!("{members:?}"), format!("{others:?}"));
    swarm.advance(100).expect("finite");
    let left: Vec<_> = (0..9).filter(|member| ![2, 5, 7].contains(member)).collect();
    assert_eq!(swarm.len(), left.len());
    for (number, member) in left.into_iter().enumerate() {
        let (system, start) = start(member);
        let mut alone = system.run(start, 0.01).expect("a run");
        alone.advance(100).expect("finite");
        assert_eq!(swarm.state(number), Some(alone.state()));
    }
    let all = Ensemble::of_admissible(Verlet, [start(5), start(2)], 0.01);
    assert!(matches!(all, Err(Error::Member { member: 0, .. })), "{all:?}");
    let one = Ensemble::new(Verlet, [start(0), start(5)], 0.01);
    assert!(matches!(one, Err(Error::Member { member: 1, .. })), "{one:?}");
}

#[test]
fn bad_members_are_refused() {
    let none: [(HenonHeiles, Phase<[f64; 2]>); 0] = [];
    assert_eq!(Ensemble::new(Verlet, none, 0.1).err(), Some(Error::NoMembers));
    let bad = (0..3).map(|i| (HenonHeiles, Phase::new([0.1, if i == 2 { f64::NAN } else { 0.0 }], [0.0, 0.2])));
    let Err(Error::Member { member: 2, error }) = Ensemble::new(Verlet, bad, 0.1) else {
        panic!("member 2 is not finite")
    };
    assert!(matches!(*error, Error::Start { coordinate: "q", index: 1, .. }));
    let refused = Ensemble::new(Verlet, (0..3).map(orbit), 0.0);
    assert!(matches!(refused, Err(Error::Member { member: 0, .. })));
    let mut late = Ensemble::new(Verlet, (0..3).map(orbit), 0.1).expect("an ensemble").at_time(f64::NAN);
    assert!(matches!(late.advance(1), Err(Error::Time { .. })));
}

#[test]
fn the_progress_callback_can_stop_the_run() {
    let stop = |after: u64| {
        move |progress: &Progress| match progress.done < after {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        }
    };
    let mut swarm = Ensemble::new(Yoshida4, (0..MANY).map(pendulum), 0.01).expect("an ensemble");
    let (system, start) = pendulum(7);
    let mut run = system.run_with(Yoshida4, start, 0.01).expect("an admissible start");
    let [of_swarm, of_run] = [swarm.advance_with(1_000_000, stop(100)), run.advance_with(1_000_000, stop(100))]
        .map(|taken| taken.expect("finite"));
    assert!((100..1_000_000).contains(&of_swarm) && (100..1_000_000).contains(&of_run));
    assert_eq!((swarm.steps(), run.steps()), (of_swarm, of_run));
    // Both go on as if nothing had happened.
    let end = of_swarm.max(of_run);
    swarm.advance(end - of_swarm).expect("finite");
    run.advance(end - of_run).expect("finite");
    assert_eq!(swarm.state(7), Some(run.state()));
}

#[test]
fn failed_members_are_named_at_the_end() {
    let mut swarm = Ensemble::new(Verlet, (0..MANY).map(orbit), 0.1).expect("an ensemble");
    let mut calls = 0;
    let outcome = swarm.advance_with(5000, |_| {
        calls += 1;
        ControlFlow::Continue(())
    });
    let Err(Error::Lost(lost)) = outcome else { panic!("{outcome:?}") };
    assert!(calls > 1 && lost.members.iter().map(|(member, _)| *member).eq(FAR));
    assert_eq!(swarm.steps(), 5000);

    // So are members whose energies stray, in whichever portion of the steps.
    let [mut swarm, mut at_once] = [(); 2].map(|()| {
        let mut swarm = Ensemble::new(Verlet, (0..MANY).map(orbit), 0.1).expect("an ensemble");
        swarm.watch_energy(1e-3).expect("energies");
        swarm
    });
    let Err(Error::Strayed { members }) = swarm.advance_with(5000, |_| ControlFlow::Continue(())) else {
        panic!("members stray")
    };
    let Err(Error::Strayed { members: expected }) = at_once.advance(5000) else { panic!("members stray") };
    assert_eq!(format!("{members:?}"), format!("{expected:?}"));
    assert_eq!((swarm.steps(), swarm.active()), (5000, at_once.active()));
}

#[test]
fn a_member_is_a_run_and_a_sample() {
    let mut swarm = Ensemble::new(Yoshida4, (0..MANY).map(pendulum), 0.01).expect("an ensemble").at_time(3.0);
    swarm.advance(123).expect("finite");
    let mut run = swarm.run_of(5).expect("under way");
    assert_eq!((run.time(), Some(run.state()), Some(run.energy())), (swarm.time(), swarm.state(5), swarm.energy(5)));
    run.advance(77).expect("finite");
    let last = swarm.run_of(5).expect("under way").samples(77).nth(1).expect("endless").expect("finite");
    swarm.advance(77).expect("finite");
    assert_eq!(Some(run.state()), swarm.state(5));
    assert_eq!((last.time, last.step, last.state), (run.time(), 200, run.state()));
    let mut turned = swarm.run_of(5).expect("under way");
    let (system, _) = pendulum(5);
    turned.map_state(|state| state.p[0] = -state.p[0]).expect("finite");
    let mut alone = system.run_with(Yoshida4, turned.state(), 0.01).expect("a run");
    for run in [&mut turned, &mut alone] {
        run.advance(50).expect("finite");
    }
    assert_eq!(turned.state(), alone.state());
    let present: Vec<_> = swarm.present().collect();
    assert_eq!(present.len(), MANY);
    assert_eq!((present[5].time, present[5].step, present[5].state), (run.time(), 200, run.state()));
    assert_eq!(Some(present[5].energy()), swarm.energy(5));
    assert!(swarm.run_of(MANY).is_none());
    swarm.advance_while(1, 1, |member, _| member != 5).expect("finite");
    assert!(swarm.run_of(5).is_none() && swarm.run_of(6).is_some());
    assert_eq!(swarm.present().nth(5).map(|sample| sample.step), Some(201));
}

#[test]
fn the_run_of_a_member_is_resumed_watched_and_counted() {
    let mut swarm = Ensemble::new(Yoshida4, (0..MANY).map(pendulum), 0.01).expect("an ensemble").at_time(3.0);
    swarm.advance(123).expect("finite");
    swarm.map_states(|_, state| state.p[0] *= 0.5).expect("finite");
    swarm.advance(7).expect("finite");
    let mut run = swarm.run_of(5).expect("under way");
    // Three forces for each step.
    assert_eq!(run.evaluations(), 130 * 3);
    assert!(format!("{run:?}").contains("Yoshida4"));

    let (system, _) = pendulum(5);
    let mut resumed: Run<[f64; 1]> = Run::resume_with(&system, Yoshida4, &run.checkpoint()).expect("its system");
    for run in [&mut run, &mut resumed] {
        run.watch_energy(1e-3).expect("conserved");
        run.advance(50).expect("within the bound");
    }
    assert_eq!((run.state(), run.time()), (resumed.state(), resumed.time()));
    swarm.advance(50).expect("finite");
    assert_eq!(swarm.state(5), Some(run.state()));
    let (other, _) = pendulum(6);
    let refused: Result<Run<[f64; 1]>, _> = Run::resume_with(&other, Yoshida4, &run.checkpoint());
    assert!(matches!(refused, Err(CheckpointError::Parameters { .. })), "{refused:?}");
    run.watch_energy(1e-12).expect("conserved");
    assert!(matches!(run.advance(5000), Err(Error::EnergyStrayed { .. })));
}

#[test]
fn counters_start_where_the_run_of_a_member_was_taken() {
    let mut swarm = Ensemble::new(ImplicitMidpoint, (0..MANY).map(pendulum), 0.01).expect("an ensemble");
    swarm.advance(123).expect("solved");
    let mut run = swarm.run_of(5).expect("under way");
    let (system, _) = pendulum(5);
    let mut alone = system.run_with(ImplicitMidpoint, run.state(), 0.01).expect("a run");
    let before = run.evaluations();
    for run in [&mut run, &mut alone] {
        run.advance(40).expect("solved");
    }
    assert_eq!((before, run.evaluations()), (0, alone.evaluations()));
}
