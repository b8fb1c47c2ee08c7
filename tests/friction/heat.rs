//! Heat and work against closed forms, and Metropolis steps against quadrature.

use crate::{BATH, Bodies, Oscillator, Pendulum, Warm};
use integrator_core::{Coords, EnergyBalance, Metropolised, check::configurational, prelude::*};

/// A harmonic chain of which each site has a spring to its place and to the next site.
struct Springs;

#[hamiltonian(compose = Obabo, split = kinetic + potential + friction)]
impl Springs {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = q[q.len() - 1].powi(2) / 2.0;
        for i in 0..q.len() - 1 {
            energy += q[i].powi(2) / 2.0 + (q[i + 1] - q[i]).powi(2) / 2.0;
        }
        energy
    }
    #[friction]
    fn friction(&self, i: usize) -> f64 {
        1.0 + i as f64 / 10.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.7
    }
}

/// The sum of the squares of the forces of a chain.
fn forces(q: &[f64]) -> f64 {
    let stretch = |i: usize| q[i + 1] - q[i];
    let force = |i: usize| -> f64 {
        let next = if i + 1 < q.len() { stretch(i) } else { 0.0 };
        next - q[i] - if i > 0 { stretch(i - 1) } else { 0.0 }
    };
    (0..q.len()).map(|i| force(i).powi(2)).sum()
}

/// Whether the balance of a run is that of a method whose flows of T and V conserve `H - h²|F|²/8`, as kick, drift and kick do
/// for quadratic energies. Numbers of the size 10 are rounded a few hundred times.
fn conserves_shadow<C: Coords<Leaf = f64>>(mut run: Run<C>, steps: u64, forces: impl Fn(&C) -> f64) -> bool {
    let (before, energy) = (forces(&run.state().q), run.energy());
    let EnergyBalance { heat, work } = run.advance_with_balance(steps).expect("steps");
    let expected = run.step().powi(2) / 8.0 * (forces(&run.state().q) - before);
    (work - expected).abs() < 1e-11 && (heat + work - (run.energy() - energy)).abs() < 1e-11
}

#[test]
fn work_is_the_change_of_the_shadow_energy() {
    let start = || Phase::new([1.0], [0.5]);
    assert!(conserves_shadow(Warm.run_with(Obabo, start(), 0.5).expect("a run"), 100, |q| q[0].powi(2)));
    assert!(!conserves_shadow(Warm.run_with(Baoab, start(), 0.5).expect("a run"), 100, |q| q[0].powi(2)));
    for length in [2_usize, 3, 8, 40, 300] {
        let start = Phase::new((0..length).map(|i| (i % 3) as f64 / 5.0).collect(), vec![0.1; length]);
        let run = Springs.run(start, 0.3).expect("a run").with_seed(length as u64);
        assert!(conserves_shadow(run, 20, |q| forces(q)), "{length} sites");
    }
}

#[test]
fn without_forces_that_change_all_energy_is_heat() {
    // Momenta have masses and temperatures of their own; the potential is flat where all bodies stay.
    for bodies in [2_usize, 3, 9, 20] {
        let start = Phase::new(vec![[0.0; 3]; bodies], vec![[0.1; 3]; bodies]);
        let mut run = Bodies.run(start, 1e-9).expect("a run");
        let balance = run.advance_with_balance(1).expect("a step");
        let kinetic = run.kinetic() - 0.01 * (0..bodies).map(|body| 1.5 / crate::mass(body)).sum::<f64>();
        assert!((balance.heat / kinetic - 1.0).abs() < 1e-12 && kinetic.abs() > 1e-12, "{balance:?} and {kinetic}");
    }
}

#[test]
fn measuring_heat_changes_no_bit() {
    let run = || BATH.run(Phase::new([1.0], [0.0]), 0.1).expect("a run").with_seed(7);
    let (mut measured, mut plain) = (run(), run());
    measured.advance_with_balance(1_500).expect("steps");
    plain.advance(1_500).expect("steps");
    assert_eq!(measured.state(), plain.state());
    let (one, other) =
        (measured.advance_with_balance(10).expect("steps"), measured.advance_with_balance(0).expect("none"));
    assert!(one.heat != 0.0 && other == EnergyBalance::default(), "each balance is of its own steps");
    let (mut between, mut at_step) = (run(), run());
    between.advance_to(0.25).expect("a time within the third step");
    at_step.advance(2).expect("steps");
    assert_eq!(between.advance_with_balance(10), at_step.advance_with_balance(10));
    let mut damped = Oscillator { gamma: 0.1 }.run(Phase::new([1.0], [0.0]), 0.1).expect("a run");
    let refused = damped.advance_with_balance(10).expect_err("no temperature").to_string();
    assert!(refused.contains("add `#[temperature]`") && damped.steps() == 0, "{refused}");
    let mut conservative = Bead.run(Phase::new([1.0], [0.0]), 0.1).expect("a run");
    assert!(matches!(conservative.advance_with_balance(10), Err(Error::NoTemperature)));
}

#[test]
fn forces_and_laplacians_are_those_of_the_potential_in_every_layout() {
    for length in [2_usize, 3, 8, 40, 300] {
        let start = Phase::new((0..length).map(|i| (i % 3) as f64 / 5.0).collect::<Vec<_>>(), vec![0.1; length]);
        let found = configurational(&Springs, &start, 0.0).expect("T + V");
        // Sums of numbers of the size one; a site has a spring to its place and one or two to its neighbours.
        let rounding = 8.0 * f64::EPSILON * length as f64;
        assert!((found.squared_force - forces(&start.q)).abs() < rounding, "{length} sites: {found:?}");
        assert!((found.laplacian - (3 * length - 2) as f64).abs() < rounding, "{length} sites: {found:?}");
    }
    // The pairs of bodies have V = 0.01 √(1 + d²), with the Laplacian 0.02 (3 + 2 d²)/(1 + d²)^(3/2) by both bodies.
    for bodies in [2_usize, 3, 9, 20] {
        let place = |i: usize| [i as f64, (i * i % 7) as f64, (i % 3) as f64];
        let start = Phase::new((0..bodies).map(place).collect::<Vec<_>>(), vec![[0.0; 3]; bodies]);
        let found = configurational(&Bodies, &start, 0.0).expect("T + V");
        let mut expected = 0.0;
        for i in 0..bodies {
            for j in 0..i {
                let square: f64 = (0..3).map(|d| (start.q[i][d] - start.q[j][d]).powi(2)).sum();
                expected += 0.02 * (3.0 + 2.0 * square) / (1.0 + square).powf(1.5);
            }
        }
        assert!((found.laplacian / expected - 1.0).abs() < 1e-13, "{bodies} bodies: {found:?} and {expected}");
    }
    assert_eq!(configurational(&Bead, &Phase::new([1.0], [1.0]), 0.0), None);
}

/// A mass that depends on the position, without friction.
struct Bead;

#[hamiltonian(split = none)]
impl Bead {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (1.0 + q[0] * q[0]) * p[0] * p[0] / 2.0
    }
}

/// The distribution `exp(-q⁴/4)`.
struct Quartic;

#[hamiltonian(split = kinetic + potential + friction)]
impl Quartic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0].powi(4) / 4.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        1.0
    }
}

/// The distribution `1/cosh⁴ q`, of a force that no step of 0.9 makes unstable.
struct Bowl;

#[hamiltonian(split = kinetic + potential + friction)]
impl Bowl {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        4.0 * q[0].cosh().ln()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        1.0
    }
}

/// The mean of `q²` in units of its deviation from that of `1/cosh⁴ q`: the deviation is estimated from the means of 100 blocks,
/// each of which is long against the time that states take to forget, about ten steps.
fn deviation(mut next: impl FnMut() -> f64) -> f64 {
    const BLOCKS: usize = 100;
    const LENGTH: usize = 600;
    let means: Vec<f64> =
        (0..BLOCKS).map(|_| (0..LENGTH).map(|_| next().powi(2)).sum::<f64>() / LENGTH as f64).collect();
    let mean = means.iter().sum::<f64>() / BLOCKS as f64;
    let variance = means.iter().map(|block| (block - mean).powi(2)).sum::<f64>() / (BLOCKS - 1) as f64;
    // The sum over a grid of a smooth integrand that vanishes at both ends is exact to the rounding.
    let moment = |power: i32| -> f64 {
        (-1_000..=1_000).map(|i| f64::from(i) / 100.0).map(|q| q.powi(power) / q.cosh().powi(4)).sum()
    };
    (mean - moment(2) / moment(0)) / (variance / BLOCKS as f64).sqrt()
}

#[test]
fn metropolis_steps_have_no_bias_at_any_step() {
    let start = || Phase::new([0.5], [0.0]);
    let h = 0.9;
    let mut rejected = Vec::new();
    for seed in 1..=2 {
        let mut chain = Bowl.metropolised(Obabo, start(), h).expect("a chain").with_seed(seed);
        let one = deviation(|| {
            chain.advance(1).expect("a step");
            chain.run().state().q[0]
        });
        rejected.push(chain.steps() - chain.accepted());
        let mut chain = Bowl.metropolised(Baoab, start(), h).expect("a chain").with_seed(seed);
        let other = deviation(|| {
            chain.advance(1).expect("a step");
            chain.run().state().q[0]
        });
        rejected.push(chain.steps() - chain.accepted());
        assert!(one.abs() < 4.0 && other.abs() < 4.0, "{one} and {other} deviations");
    }
    assert!(rejected.iter().all(|rejected| (600..30_000).contains(rejected)), "{rejected:?} of 60,000");
    let mut run = Bowl.run_with(Obabo, start(), h).expect("a run").with_seed(1);
    let biased = deviation(|| {
        run.advance(1).expect("a step");
        run.state().q[0]
    });
    assert!(biased > 10.0, "the bias of the step without rejections is seen: {biased} deviations");
}

#[test]
fn a_chain_survives_steps_that_are_not_finite() {
    let chain = || Quartic.metropolised(Obabo, Phase::new([0.5_f64], [0.0]), 40.0).expect("a chain").with_seed(3);
    let (mut whole, mut portions) = (chain(), chain());
    whole.advance(300).expect("steps");
    portions.advance(1).expect("a step");
    portions.advance(299).expect("steps");
    assert_eq!((whole.steps(), whole.accepted()), (300, portions.accepted()));
    assert_eq!(whole.run().state(), portions.run().state());
    assert!(whole.accepted() < 300 && whole.run().state().q[0].is_finite());
    let mut far = Quartic.metropolised(Obabo, Phase::new([0.5], [0.0]), 1e80).expect("a chain");
    far.advance(20).expect("steps that are all rejected");
    assert_eq!((far.accepted(), far.run().state().q), (0, [0.5]));
}

/// An oscillator whose bath becomes warmer.
struct Warming;

#[hamiltonian(split = kinetic + potential + friction)]
impl Warming {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize, t: f64) -> f64 {
        1.0 + t
    }
}

#[test]
fn chains_without_a_canonical_distribution_are_refused() {
    let start = || Phase::new([1.0], [0.0]);
    fn is_refused<C: Coords>(chain: Result<Metropolised<C>, Error>, part: &str) {
        let text = chain.err().map(|error| error.to_string()).unwrap_or_default();
        assert!(text.contains(part), "{text}");
    }
    is_refused(BATH.metropolised(Baoa, start(), 0.1), "a symmetric composition");
    is_refused(Warming.metropolised(Obabo, start(), 0.1), "does not depend on time");
    is_refused(Pendulum { kt: 0.0, ..BATH }.metropolised(Obabo, start(), 0.1), "one positive temperature");
    let bodies = || Phase::new(vec![[0.0; 3]; 2], vec![[0.0; 3]; 2]);
    is_refused(Bodies.metropolised(Obabo, bodies(), 0.1), "one positive temperature");
    is_refused(Oscillator { gamma: 0.1 }.metropolised(Obabo, start(), 0.1), "no temperature");
    is_refused(BATH.metropolised(Obabo, start(), -0.1), "negative duration");
}
