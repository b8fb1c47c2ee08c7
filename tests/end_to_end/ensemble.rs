//! Ensembles: every member is the run that it would be alone, bit for bit, whoever its neighbours are.

use crate::systems::HenonHeiles;
use integrator_core::prelude::*;

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

#[test]
fn members_are_the_runs_that_they_would_be_alone() {
    // Two full packs of lanes and a rest.
    let mut swarm = Ensemble::new(Yoshida4, (0..21).map(pendulum), 0.01).expect("an ensemble");
    swarm.advance(700).expect("finite");
    swarm.advance(1300).expect("finite");
    assert_eq!((swarm.len(), swarm.steps(), swarm.time()), (21, 2000, 2000.0 * 0.01));
    for member in 0..21 {
        let (system, start) = pendulum(member);
        let mut alone = system.run(start, 0.01).expect("a run");
        alone.advance(2000).expect("finite");
        assert_eq!(swarm.state(member), Some(alone.state()), "member {member}");
        assert_eq!(swarm.energy(member), Some(alone.energy()), "member {member}");
    }
    assert_eq!(swarm.states().count(), 21);
    assert_eq!((swarm.state(21), swarm.energy(21)), (None, None));
}

#[test]
fn threads_change_nothing() {
    let run = |threads| {
        let ensemble = Ensemble::new(KahanLi8, (0..50).map(pendulum), 0.05).expect("an ensemble");
        let mut ensemble = ensemble.with_threads(threads);
        ensemble.advance(100).expect("finite");
        ensemble.states().collect::<Vec<_>>()
    };
    assert_eq!(run(1), run(2));
    assert_eq!(run(1), run(7));
}

/// Beyond its escape energy of 1/6 a Hénon–Heiles orbit falls to infinity.
fn orbit(member: usize) -> (HenonHeiles, Phase<[f64; 2]>) {
    let far = member == 3 || member == 12;
    (HenonHeiles, Phase::new([if far { 3.0 } else { 0.1 }, 0.01 * member as f64], [0.0, 0.2]))
}

#[test]
fn a_member_that_is_lost_is_named_and_disturbs_nobody() {
    let mut swarm = Ensemble::new(Verlet, (0..20).map(orbit), 0.1).expect("an ensemble");
    let Err(Error::Lost(lost)) = swarm.advance(5000) else { panic!("two members escape") };
    let names: Vec<usize> = lost.members.iter().map(|(member, _)| *member).collect();
    assert_eq!(names, [3, 12]);
    assert!(lost.to_string().contains("2 members left the finite numbers (members 3, 12)"), "{lost}");
    swarm.advance(500).expect("those that are left are finite");
    for member in 0..20 {
        let (system, start) = orbit(member);
        let mut alone = system.run_with(Verlet, start, 0.1).expect("a run");
        match (alone.advance(5500), lost.members.iter().find(|(name, _)| *name == member)) {
            (Ok(()), None) => {}
            (Err(Error::Diverged(expected)), Some((_, divergence))) => assert_eq!(*divergence, expected),
            (outcome, lost) => panic!("member {member}: alone {outcome:?}, in the ensemble {lost:?}"),
        }
        assert_eq!(swarm.state(member), Some(alone.state()), "member {member}");
    }
}

/// Members of different sizes share no lanes.
struct Chain {
    stiffness: f64,
    turns: usize,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum::<f64>()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for i in 0..self.turns {
            v += 0.5 * self.stiffness * (q[i + 1] - q[i]).powi(4);
        }
        v
    }
}

#[test]
fn members_of_different_sizes_run_beside_each_other() {
    let member = |i: usize| {
        let turns = 2 + i / 10;
        let q: Vec<f64> = (0..=turns).map(|site| (site + i) as f64 / 9.0).collect();
        let p = vec![0.1; q.len()];
        (Chain { stiffness: 1.0 + i as f64, turns }, Phase::new(q, p))
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

#[test]
fn precision_is_the_state_s() {
    let member = |i: usize| (HenonHeiles, Phase::new([0.1_f32, 0.01 * i as f32], [0.0, 0.2]));
    let mut swarm = Ensemble::new(Verlet, (0..9).map(member), 0.1).expect("an ensemble");
    swarm.advance(100).expect("finite");
    let compensated = |i: usize| (HenonHeiles, Phase::compensated([0.1, 0.01 * i as f64], [0.0, 0.2]));
    let mut careful = Ensemble::new(Verlet, (0..9).map(compensated), 0.1).expect("an ensemble");
    careful.advance(100).expect("finite");
    for i in 0..9 {
        let (system, start) = member(i);
        let mut alone = system.run_with(Verlet, start, 0.1).expect("a run");
        alone.advance(100).expect("finite");
        assert_eq!(swarm.state(i), Some(alone.state()));
        let (system, start) = compensated(i);
        let mut alone = system.run_with(Verlet, start, 0.1).expect("a run");
        alone.advance(100).expect("finite");
        assert_eq!(careful.state(i), Some(alone.state()));
    }
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
