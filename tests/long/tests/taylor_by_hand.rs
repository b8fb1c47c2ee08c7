//! Hand-written Taylor integrators agree with references in 113-bit arithmetic.
//!
//! Each polynomial has a relative error of the tolerance. If all errors had the same sign, they would add up over the
//! polynomials. A relative energy error also makes the phase error grow over the remaining angle. The bounds are
//! therefore the tolerance times the number of polynomials times the angle, for periodic motion. A wrong term would
//! give a far larger error.

use integrator_bench::{
    Instructions,
    by_hand::taylor::{self, Course, ORDERS},
    starts::{Problem, Problems},
};
use integrator_core::{Coords, Hamiltonian, Phase};

const TOLERANCE: f64 = 1e-15;

/// Tests the hand-written steppers of all orders on `problem`, a motion over `radians` radians.
#[track_caller]
fn arrives<H: Hamiltonian>(
    problem: &Problem<H>,
    radians: f64,
    by_hand: impl Fn(Course, &mut dyn FnMut(Phase<H::Coords>)) -> u64,
) where
    H::Coords: Coords<Leaf = f64>,
{
    if Instructions::chosen() == Instructions::Baseline {
        return;
    }
    for order in ORDERS {
        for looks in [1, 7] {
            let mut states = Vec::new();
            let course = Course { order, tolerance: TOLERANCE, span: problem.span, looks };
            let polynomials = by_hand(course, &mut |state| states.push(state));
            assert_eq!(states.len(), looks as usize);
            let end = states.pop().expect("an end");
            let bound = TOLERANCE * polynomials as f64 * radians;
            for (i, (q, reference)) in end.q.flat().iter().zip(&problem.reference).enumerate() {
                let largest = problem.reference.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
                let error = (q - reference).abs() / largest;
                assert!(error < bound, "{}, order {order}, coordinate {i}: {error:e} above {bound:e}", problem.name);
            }
        }
    }
}

#[test]
fn one_point_arrives() {
    let problems = Problems::default();
    let pendulum = problems.pendulum();
    // Small oscillations, which are the fastest, and revolutions of the star and the planet take 2π.
    arrives(&pendulum, pendulum.span, |course, see| taylor::pendulum(&pendulum.system, &pendulum.start, course, see));
    let henon = problems.henon_heiles();
    arrives(&henon, henon.span, |course, see| taylor::henon_heiles(&henon.start, course, see));
    let kepler = problems.kepler();
    arrives(&kepler, kepler.span, |course, see| taylor::kepler(&kepler.start, course, see));
}

#[test]
fn planets_arrive() {
    let solar = Problems::default().solar();
    // Jupiter revolves once in 4333 days.
    let radians = solar.span / 4333.0 * std::f64::consts::TAU;
    arrives(&solar, radians, |course, see| taylor::solar(&solar.system, &solar.start, course, see));
}

#[test]
fn waves_arrive() {
    let chain = Problems::default().chain();
    // The lowest mode of the chain has the frequency 2 sin(π/66).
    let radians = chain.span * 2.0 * (std::f64::consts::PI / 66.0).sin();
    arrives(&chain, radians, |course, see| taylor::chain(&chain.system, &chain.start, course, see));
}
