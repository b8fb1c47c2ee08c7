//! Crossings on the polynomials of a run: at the times that closed forms tell, and with the bits of the run.

use crate::runs::{FINE, Kepler, Oscillator, PER_TIME, Pendulum, TIME, pericentre};
use integrator_core::{Coords, prelude::*, taylor::Taylor};
use std::f64::consts::{FRAC_PI_2, PI};

fn all<C: Coords>(crossings: Crossings<C, impl FnMut(&Phase<C>, f64) -> f64>) -> Vec<Sample<C>> {
    crossings.collect::<Result<_, _>>().expect("finite states")
}

/// Steps that lie within one polynomial, and steps that take several of them.
const STEPS: [f64; 3] = [0.125, 1.25, -1.25];

#[test]
fn an_oscillator_passes_zero_after_quarters_of_a_turn() {
    for h in STEPS {
        let run = Oscillator.run_with(Taylor::tolerance(FINE), Phase::new([1.0], [0.0]), h).expect("a start");
        let passes = all(run.crossings((TIME / h.abs()) as u64, Direction::Either, |state, _| state.q[0]));
        assert_eq!(passes.len(), 32, "98.96 is the last odd quarter within 100");
        for (number, pass) in passes.iter().enumerate() {
            let exact = ((2 * number + 1) as f64 * FRAC_PI_2).copysign(h);
            let error = (pass.time - exact).abs();
            assert!(error < PER_TIME * (1.0 + exact.abs()), "{error:e} at {exact} in steps of {h}");
            assert_eq!(pass.step, (pass.time / h) as u64);
        }
    }
}

/// A quarter of the period is `K(sin(a/2))`, half of π over an arithmetic-geometric mean.
#[test]
fn a_pendulum_passes_its_lowest_point_when_the_elliptic_integral_says() {
    let amplitude = 2.0_f64;
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let quarter = PI / (2.0 * a);
    for h in STEPS {
        let run = Pendulum.run_with(Taylor::tolerance(FINE), Phase::new([amplitude], [0.0]), h).expect("a start");
        let passes = all(run.crossings((TIME / h.abs()) as u64, Direction::Either, |state, _| state.q[0]));
        assert_eq!(passes.len(), 24, "{quarter} for a quarter");
        for (number, pass) in passes.iter().enumerate() {
            let exact = ((2 * number + 1) as f64 * quarter).copysign(h);
            let error = (pass.time - exact).abs();
            // As for the states of this amplitude, which pass at a velocity of 1.7.
            assert!(error < 2.0 * PER_TIME * (1.0 + exact.abs()), "{error:e} at {exact} in steps of {h}");
        }
    }
}

#[test]
fn bodies_are_farthest_after_half_a_period() {
    for eccentricity in [0.3, 0.6] {
        for h in STEPS {
            let run = Kepler.run_with(Taylor::tolerance(FINE), pericentre(eccentricity), h).expect("a start");
            // Out there, distances shrink as the run goes, and velocities turn inwards.
            let outwards =
                |state: &Phase<[f64; 2]>, _| (state.q[0] * state.p[0] + state.q[1] * state.p[1]) * h.signum();
            let farthest = all(run.crossings((TIME / h.abs()) as u64, Direction::Falling, outwards));
            assert_eq!(farthest.len(), 16, "97.4 is the last odd half within 100");
            for (number, sample) in farthest.iter().enumerate() {
                let exact = ((2 * number + 1) as f64 * PI).copysign(h);
                let error = (sample.time - exact).abs();
                // As for the states, whose errors turn the phase.
                let unit = PER_TIME / (1.0_f64 - eccentricity).powi(2) * 4.0;
                assert!(error < unit * (1.0 + exact.abs()), "{error:e} at {exact} for {eccentricity} in steps of {h}");
                let distance = sample.state.q[0].hypot(sample.state.q[1]);
                assert!((distance - 1.0 - eccentricity).abs() < unit * (1.0 + exact.abs()));
            }
        }
    }
}

/// A crossing in the middle of a step is seen by a run of half the step as well.
#[test]
fn a_crossing_is_the_state_of_the_run_at_its_time() {
    macro_rules! check {
        ($start:expr, $h:expr) => {
            let (start, h) = ($start, $h);
            let begin = |h| Kepler.run_with(Taylor::tolerance(1e-15), start, h).expect("a start");
            let mut halves = begin(h / 2.0);
            for step in 0..40_u64 {
                halves.advance(1).expect("finite states");
                let middle = step as f64 * h + h / 2.0;
                let found = all(begin(h).crossings(step + 1, Direction::Either, |_, t| t - middle));
                assert!(found.len() == 1 && found[0].time == middle, "{found:?} instead of {middle}");
                assert_eq!(found[0].state, halves.state(), "at {middle} in steps of {h}");
                halves.advance(1).expect("finite states");
            }
        };
    }
    for h in [0.1, -0.1, 1.25, 6.25] {
        let start = pericentre(0.5);
        check!(start, h);
        check!(Phase::compensated(start.q, start.p), h);
        check!(Phase::new(start.q.map(|q| q as f32), start.p.map(|p| p as f32)), h);
    }
}

#[test]
fn a_section_leaves_the_bits_of_the_run() {
    for h in STEPS {
        let run = Pendulum.run_with(Taylor::tolerance(FINE), Phase::new([2.5], [0.0]), h).expect("a start");
        let mut plain = run.clone();
        plain.advance(600).expect("finite states");
        let mut crossings = run.crossings(600, Direction::Either, |state, _| state.q[0]);
        assert!(crossings.by_ref().filter(Result::is_ok).count() > 10);
        let mut looked = crossings.into_run();
        assert_eq!((looked.steps(), looked.state()), (600, plain.state()));
        looked.advance(100).expect("finite states");
        plain.advance(100).expect("finite states");
        assert_eq!(looked.state(), plain.state());
    }
}

/// A ball's turns of an oscillator: reflected at zero, it stays on one side, and each half of a turn ends there.
#[test]
fn polynomials_are_rebuilt_where_a_crossing_changes_the_state() {
    for h in STEPS {
        let mut run = Oscillator.run_with(Taylor::tolerance(FINE), Phase::new([1.0], [0.0]), h).expect("a start");
        let mut times = Vec::new();
        let reflect = |state: &mut Phase<[f64; 1]>, time: f64| {
            state.p[0] = -state.p[0];
            times.push(time);
        };
        let steps = (TIME / h.abs()) as u64;
        let found = run.on_crossing(steps, Direction::Either, |state, _| state.q[0], reflect).expect("finite states");
        assert_eq!((found, run.time()), (32, steps as f64 * h));
        for (number, time) in times.iter().enumerate() {
            let exact = ((2 * number + 1) as f64 * FRAC_PI_2).copysign(h);
            let error = (time - exact).abs();
            assert!(error < PER_TIME * (1.0 + exact.abs()), "{error:e} at {exact} in steps of {h}");
        }
        let mut state = run.state();
        for _ in 0..40 {
            let fresh = Oscillator.run_with(Taylor::tolerance(FINE), state, h).expect("a start");
            let next = fresh.crossings(100, Direction::Either, |state, _| state.q[0]).next();
            let next = next.expect("a turn").expect("finite states");
            assert!(next.time.abs() > 0.1, "{}", next.time);
            state = next.state;
        }
    }
}
