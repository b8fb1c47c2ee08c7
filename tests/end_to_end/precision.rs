//! The leaf type of the state decides the precision of a run.

use crate::systems::{henon_heiles, pendulum};
use integrator_core::prelude::*;

#[test]
fn a_run_from_f32_is_computed_in_f32() {
    let problem = henon_heiles();
    let (q, p) = problem.start;
    let double = Phase::new(q, p);
    let single = Phase::new(q.map(|x| x as f32), p.map(|x| x as f32));
    let mut exact = problem.system.run(double, 0.125).expect("an admissible start");
    let mut run = problem.system.run(single, 0.125).expect("an admissible start");
    exact.advance(40).expect("finite");
    run.advance(40).expect("finite");
    let (exact, state) = (exact.state(), run.state());
    let pairs = state.q.iter().zip(exact.q).chain(state.p.iter().zip(exact.p));
    let distance = pairs.map(|(found, exact)| (f64::from(*found) - exact).abs()).fold(0.0, f64::max);
    // 40 steps of a few roundings, which five time units of a regular orbit stretch by ten at most.
    assert!(distance < 40.0 * 4.0 * 10.0 * f64::from(f32::EPSILON), "{distance:e}");
    // Half a unit of f32 is what a single rounding at the end would lose; a random walk of 100 roundings loses more.
    assert!(distance > f64::from(f32::EPSILON) / 8.0, "as exact as f64: {distance:e}");
}

#[test]
fn samples_keep_the_scalar_type() {
    let problem = pendulum();
    let run = problem.system.run(Phase::new([2.0_f32], [0.0]), 0.01).expect("an admissible start");
    let sample = run.samples(10).nth(1).expect("a sample").expect("finite");
    let q: [f32; 1] = sample.state.q;
    assert!(q[0] < 2.0, "it falls");
}

/// A free particle: what is left of the error is rounding alone.
struct Free;

#[hamiltonian]
impl Free {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, _: [f64; 1]) -> f64 {
        0.0
    }
}

#[test]
fn compensation_keeps_the_rounding_of_every_update() {
    const STEPS: u64 = 1 << 20;
    let h = 0.1;
    // `h·p` is not rounded, so the exact position is one product away.
    let exact = 1.0 + STEPS as f64 * (h * 1.0);
    let mut plain = Free.run(Phase::new([1.0], [1.0]), h).expect("an admissible start");
    let mut compensated = Free.run(Phase::compensated([1.0], [1.0]), h).expect("an admissible start");
    plain.advance(STEPS).expect("finite");
    compensated.advance(STEPS).expect("finite");
    let (plain, compensated) = (plain.state().q[0], compensated.state().q[0]);
    let unit = exact * f64::EPSILON;
    assert!((compensated.value - exact).abs() <= unit, "{compensated:?} for {exact}");
    assert!((plain - exact).abs() > 100.0 * unit, "{plain} for {exact}");
    assert!(compensated.carried.abs() <= unit, "what is carried is below the last place: {compensated:?}");
}

#[test]
fn compensated_runs_resume_with_their_corrections() {
    let problem = pendulum();
    let start = Phase::compensated(problem.start.0, problem.start.1);
    let mut run = problem.system.run_with(Euler, start, 0.01).expect("an admissible start");
    run.advance(1000).expect("finite");
    // Where no stages merge, a closed state is all there is to a run.
    let mut resumed = problem.system.run_with(Euler, run.state(), 0.01).expect("an admissible start");
    run.advance(1000).expect("finite");
    resumed.advance(1000).expect("finite");
    assert_eq!(run.state(), resumed.state());
}

/// As many oscillators as the start has.
struct Oscillators;

#[hamiltonian]
impl Oscillators {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        q.iter().map(|q| q * q / 2.0).sum()
    }
}

#[test]
fn energies_of_compensated_states_are_summed_to_the_last_bit() {
    const COUNT: u128 = 10_000;
    // q = 2^-30 n with integers n is exact, q² is not, and integers have the sum of all of them. The first one is large, so that
    // the sums of others with it are rounded.
    let integer = |i: u128| if i == 0 { (1 << 52) + 1 } else { (1 << 30) + i };
    let q: Vec<f64> = (0..COUNT).map(|i| integer(i) as f64 / f64::from(1 << 30)).collect();
    let exact = (0..COUNT).map(|i| integer(i).pow(2)).sum::<u128>() as f64 / 2.0_f64.powi(61);
    let p = vec![0.0; q.len()];
    let plain = Oscillators.run(Phase::new(q.clone(), p.clone()), 0.1).expect("a start").energy();
    let start = Phase::compensated(q, p);
    let compensated = Oscillators.run(start.clone(), 0.1).expect("a start");
    let sample = compensated.clone().samples(1).next().expect("a sample").expect("finite").energy();
    let members = Ensemble::new(Verlet, [(Oscillators, start.clone()), (Oscillators, start)], 0.1).expect("members");
    assert_eq!([compensated.energy(), sample, members.energy(1).expect("a member")], [exact; 3]);
    assert_ne!(plain, exact);
}

/// A pendulum whose sine may be 4 ulp off.
struct Fast;

#[hamiltonian(functions = fast)]
impl Fast {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// The same with the sine as it is unasked.
struct Precise;

#[hamiltonian(functions = precise)]
impl Precise {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

#[test]
fn fast_functions_are_other_functions_within_their_bound() {
    const STEPS: u64 = 1000;
    let h = 1.0 / 64.0;
    let start = Phase::new([2.0_f64], [0.0]);
    let mut fast = Fast.run(start, h).expect("an admissible start");
    let mut precise = Precise.run(start, h).expect("an admissible start");
    let mut members = Ensemble::new(Verlet, (0..3).map(|_| (Fast, start)), h).expect("members");
    fast.advance(STEPS).expect("finite");
    precise.advance(STEPS).expect("finite");
    members.advance(STEPS).expect("finite");
    let (fast, precise) = (fast.state(), precise.state());
    let distance = (fast.q[0] - precise.q[0]).abs() + (fast.p[0] - precise.p[0]).abs();
    // Kicks of h times five units off at most, 1000 of them, which 16 time units of a pendulum stretch by less than 100.
    assert!(distance < 1000.0 * h * 5.0 * f64::EPSILON * 100.0, "{distance:e}");
    assert!(distance > 0.0, "these are the precise functions");
    assert_eq!(members.state(1), Some(fast), "a member has the bits of its lone run");
}
