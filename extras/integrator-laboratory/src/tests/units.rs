//! Verdicts hold in any units and at any speed, for right methods and against wrong ones.

use super::{DRIVEN, Driven, PENDULUM, Pendulum, claims::claims_fail_for_other_methods, driven_study, pages::page};
use crate::{
    Laboratory, Plan, claims::verdicts, errors::exact, portrait::portrait, problem::Stepped, study::Study,
    tangents::defect,
};
use integrator_core::prelude::*;
use integrator_reference::{AnyReference, RungeKutta4};

/// Tests that verdicts depend neither on units nor on the zero of the energy or the amplitude, and that wrong methods fail.
#[test]
fn verdicts_hold_in_any_units() {
    let plan = Plan { periods: 6.0, outline: 16, rungs: 5, limits: 2 };
    // A length, a mass and an energy, so that positions, momenta and times have units of their own.
    let units = Pendulum { zero: 100.0, length: 2.0_f64.powi(20), mass: 2.0_f64.powi(-30), weight: 2.0_f64.powi(-6) };
    // Of an angle of 1e-8 the cosine is one, up to its rounding: nothing is said of the energy, and the rest holds.
    for (name, system, angle, unresolved) in [("units", units, 2.0, false), ("small", PENDULUM, 1e-8, true)] {
        let start = Phase::new([angle * system.length], [0.0]);
        let unit = system.length * (system.mass / system.weight).sqrt();
        let period = unit * if unresolved { std::f64::consts::TAU } else { 8.35 };
        let study = Laboratory::new(&system, start, period).plan(plan).study().expect("measurements");
        assert_ne!(study.resolved, unresolved, "{name}");
        for verdict in verdicts(&study) {
            assert!(verdict.holds(), "{name}: {} is {:e}", verdict.name, verdict.measured);
        }
        claims_fail_for_other_methods(&study);
    }
}

/// Tests that errors do not add up because a step divides the period, which is exact here.
#[test]
fn a_period_that_is_exact_is_no_resonance() {
    let (start, plan) = (Phase::new([2.5], [0.5]), Plan::SMALL);
    // The period is 4 K(sin(A/2)) of the amplitude A, by the arithmetic-geometric mean.
    let amplitude = (2.5_f64.cos() - 0.5 * 0.5 * 0.5).acos();
    let (mut a, mut b) = (1.0_f64, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let laboratory = Laboratory::new(&PENDULUM, start, std::f64::consts::TAU / a);
    let exact = exact(&laboratory.problem).expect("a reference");
    let growth = |method: Box<dyn Stepped<[f64; 1]> + '_>| {
        portrait(&laboratory.problem, &*method, &plan, &exact).expect("an orbit").growth()
    };
    let problem = &laboratory.problem;
    let growths = [growth(problem.by(KahanLi8)), growth(problem.by(BlanesMoan6)), growth(problem.by(GaussLegendre6))];
    // With a whole number of steps they are 1.83, 1.59 and 1.54.
    assert!(growths.iter().all(|growth| *growth < 1.1), "{growths:?}");
}

/// Tests that maps which stretch tangents by large factors are symplectic up to rounding, and that others are not.
#[test]
fn maps_that_stretch_are_symplectic_up_to_rounding() {
    let shaken = Driven { shake: 40.0, frequency: 20.0 };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![3.0], vec![0.0]), 12.57);
    let problem = &laboratory.problem;
    let exact = exact(problem).expect("a reference");
    let defects = |method: Box<dyn Stepped<Vec<f64>> + '_>| {
        [0.01, 0.1, 0.3, 0.6].map(|h| defect(problem, &*method, &exact, h, 8).expect("a map"))
    };
    for method in [problem.by(Euler), problem.by(Verlet), problem.by(KahanLi8)] {
        let name = method.facts().name;
        let found = defects(method);
        assert!(found.iter().all(|defect| *defect <= 1.0), "{name}: {found:?}");
    }
    let found = defects(problem.by(AnyReference::from(RungeKutta4)));
    assert!(found.iter().all(|defect| *defect > 1.0), "{found:?}");
}

/// Tests that steps resolve a drive which is faster than the motion, and that the page warns of a step that does not.
#[test]
fn steps_follow_a_fast_drive() {
    let shaken = Driven { frequency: 20.0, ..DRIVEN };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![1.0], vec![0.0]), 12.57);
    assert_eq!(laboratory.problem.cycles(), 40);
    assert!((laboratory.problem.step - 12.57 / 40.0 / 80.618).abs() < 1e-6);
    let mut study = driven_study();
    let warns = |study: &Study| page(study, &[]).contains("half the period of the drive");
    assert!(study.half_drive.is_some_and(|half| (half - 3.2).abs() < 0.1) && !warns(&study), "{:?}", study.half_drive);
    study.half_drive = Some(0.99 * study.step);
    assert!(warns(&study));
}

/// Tests that brackets by formula agree with those of steps under a drive, where the force at the end of a step is another one.
#[test]
fn brackets_of_a_shaken_pendulum_are_those_of_the_formulas() {
    let shaken = Driven { shake: 0.3, frequency: 2.0 };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![0.5], vec![0.0]), 6.3).step(0.1);
    let rows = crate::brackets::brackets(&laboratory.problem).expect("brackets");
    assert!(
        rows.len() == 2 && rows.iter().all(|row| row.off() < 1e-13),
        "{:?}",
        rows.iter().map(|row| row.off()).collect::<Vec<_>>()
    );
}

/// Kepler's problem, whose orbit of eccentricity 0.6 is fast at the perihelion.
struct Comet;

#[hamiltonian(taylor)]
impl Comet {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

/// The same motion, with the coordinates in the other order, and an oscillator that is faster beside it.
struct CometBeside;

#[hamiltonian(taylor)]
impl CometBeside {
    fn kinetic(&self, [p, py, px]: [f64; 3]) -> f64 {
        0.5 * (px * px + py * py + p * p)
    }
    fn potential(&self, [q, y, x]: [f64; 3]) -> f64 {
        2.0 * q * q - 1.0 / (x * x + y * y).sqrt()
    }
}

/// Tests that steps resolve the perihelion of a comet, so that no claim about what methods conserve fails: of the comet alone, and
/// in another order of coordinates, back in time, and beside a faster oscillator. Exponents, and changes that are to be seen, are
/// measured over more periods than these.
#[test]
fn verdicts_hold_for_a_comet() {
    let plan = Plan { periods: 2.0, outline: 16, rungs: 5, limits: 2 };
    let alone = Laboratory::new(&Comet, Phase::new([1.6, 0.0], [0.0, 0.5]), std::f64::consts::TAU);
    assert_eq!(alone.problem.haste, 3);
    let beside = Laboratory::new(&CometBeside, Phase::new([0.1, 0.0, 1.6], [0.1, -0.5, 0.0]), std::f64::consts::TAU)
        .view([2, 1]);
    let studies = [alone.blob(0.01).plan(plan).study(), beside.blob(0.01).plan(plan).study()];
    for study in studies {
        let mut verdicts = verdicts(&study.expect("measurements"));
        let conserved = ["bracket", "areas", "come_back", "energy_stays", "equals"];
        verdicts.retain(|verdict| conserved.iter().any(|word| verdict.name.contains(word)));
        assert!(!verdicts.is_empty());
        verdicts.retain(|verdict| !verdict.holds());
        assert!(verdicts.is_empty(), "{verdicts:#?}");
    }
}
