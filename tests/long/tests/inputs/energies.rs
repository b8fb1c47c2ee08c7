//! A run starts only if the energy of the initial state is defined at the initial time.

use integrator_core::prelude::*;

/// A system with a force but no energy at negative positions.
#[derive(Clone)]
struct Logarithmic;

#[hamiltonian]
impl Logarithmic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] - q[0].ln()
    }
}

/// Kepler's problem: without softening, the force at the centre is NaN.
#[derive(Clone)]
struct Softened {
    softening: f64,
}

#[hamiltonian(taylor)]
impl Softened {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1] + self.softening).sqrt()
    }
}

/// A particle in a well, with a mass that grows from zero at time 0.
#[derive(Clone)]
struct Growing;

#[hamiltonian]
impl Growing {
    fn kinetic(&self, p: [f64; 1], t: f64) -> f64 {
        p[0] * p[0] / (2.0 * t.sqrt())
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

fn refused<T>(outcome: Result<T, Error>, function: &str, is: &str, at: f64) {
    match outcome.map(drop) {
        Err(Error::Energy { function: found, value, time }) => {
            assert_eq!((found, value.to_string().as_str(), time), (function, is, at));
        }
        other => panic!("{other:?} where `{function}` is {is}"),
    }
}

fn member<T>(outcome: Result<T, Error>) -> (Option<usize>, Result<(), Error>) {
    match outcome.map(drop) {
        Err(Error::Member { member, error }) => (Some(member), Err(*error)),
        other => (None, other),
    }
}

#[test]
fn a_start_without_an_energy_is_refused_and_its_part_named() {
    let off = Phase::new([-1.0], [0.0]);
    refused(Logarithmic.run(off, 0.1), "potential", "NaN", 0.0);
    refused(Logarithmic.run(Phase::compensated([-1.0], [0.0]), 0.1), "potential", "NaN", 0.0);
    refused(Logarithmic.run_with(Yoshida4, Phase::new([0.0_f32], [0.0]), 0.1), "potential", "inf", 0.0);
    let centre = Phase::new([0.0, 0.0], [0.0, 1.0]);
    refused(Softened { softening: 0.0 }.run(centre, 0.1), "potential", "-inf", 0.0);
    let taylor = Taylor::tolerance(1e-12);
    refused(Softened { softening: 0.0 }.run_with(taylor, centre, 0.1), "potential", "-inf", 0.0);
    Softened { softening: 1.0 }.run(centre, 0.1).expect("finite").advance(10).expect("finite");

    let swarm = [1.0, 2.0, 3.0, -1.0, 4.0].map(|q| (Logarithmic, Phase::new([q], [0.0])));
    let (number, outcome) = member(Ensemble::new(Verlet, swarm, 0.1));
    assert_eq!(number, Some(3));
    refused(outcome, "potential", "NaN", 0.0);
}

#[test]
fn the_energy_is_that_at_the_time_the_clock_starts_at() {
    let start = Phase::new([0.0], [1.0]);
    Growing.run(start, 0.1).expect("not judged yet").at_time(1.0).advance(10).expect("a mass at time 1");
    let mut early = Growing.run(start, 0.1).expect("not judged yet");
    for _ in 0..2 {
        refused(early.advance(10), "kinetic", "inf", 0.0);
        assert_eq!(early.steps(), 0);
    }
    refused(early.at_time(-1.0).advance(1), "kinetic", "NaN", -1.0);

    let swarm = || Ensemble::new(Yoshida4, [1.0, 2.0].map(|p| (Growing, Phase::new([0.0], [p]))), 0.1);
    swarm().expect("not judged yet").at_time(1.0).advance(10).expect("masses at time 1");
    let (number, outcome) = member(swarm().expect("not judged yet").advance(1));
    assert_eq!(number, Some(0));
    refused(outcome, "kinetic", "inf", 0.0);
}
