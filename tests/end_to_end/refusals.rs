//! What a run refuses, and what it says.

use crate::systems::{HenonHeiles, henon_heiles};
use integrator_core::prelude::*;

fn start() -> Phase<[f64; 2]> {
    let (q, p) = henon_heiles().start;
    Phase::new(q, p)
}

fn refused(start: Phase<[f64; 2]>, h: f64) -> String {
    HenonHeiles.run(start, h).expect_err("this cannot run").to_string()
}

#[test]
fn steps_that_lead_nowhere() {
    for (h, text) in [(0.0, "0"), (-0.0, "-0"), (f64::NAN, "NaN"), (f64::INFINITY, "inf"), (f64::NEG_INFINITY, "-inf")]
    {
        let expected =
            format!("the step h has to be finite and not zero, but it is {text}\nnote: negative steps run backwards");
        assert_eq!(refused(start(), h), expected);
    }
    assert!(HenonHeiles.run(start(), -1e-300).is_ok());
}

#[test]
fn starts_that_are_not_finite() {
    let mut bad = start();
    bad.q[1] = f64::NAN;
    bad.p[0] = f64::INFINITY;
    assert_eq!(
        refused(bad, 0.1),
        "the initial state is not finite: q[1] is NaN (index into the flattened coordinates)",
        "the first one is named"
    );
    let mut bad = start();
    bad.p[1] = f64::NEG_INFINITY;
    assert_eq!(
        refused(bad, 0.1),
        "the initial state is not finite: p[1] is -inf (index into the flattened coordinates)"
    );
}

#[test]
fn a_clock_that_starts_at_no_time() {
    let mut run = HenonHeiles.run(start(), 0.1).expect("an admissible start").at_time(f64::NAN);
    let error = run.advance(1).expect_err("no time");
    assert_eq!(error.to_string(), "the time NaN is not finite");
    assert_eq!(run.steps(), 0);
}

#[test]
fn samples_that_stay_where_they_are() {
    let mut samples = HenonHeiles.run(start(), 0.1).expect("an admissible start").samples(0);
    let error = samples.next().expect("an error").expect_err("no step between samples");
    assert_eq!(error, Error::SampleInterval);
    assert_eq!(
        error.to_string(),
        "the interval between samples is 0\nhelp: write at least one step, or an interval of time other than 0"
    );
    assert!(samples.next().is_none());
    let first = |interval: f64, h: f64| {
        let mut samples = HenonHeiles.run(start(), h).expect("an admissible start").samples_at(interval);
        let found = samples.next().expect("an error").expect_err("no time between samples");
        assert!(samples.next().is_none());
        found
    };
    assert_eq!(first(0.0, 0.1), Error::SampleInterval);
    for (interval, h, text) in [
        (
            f64::NAN,
            0.1,
            "the interval between samples is NaN, which is not finite\nhelp: write a multiple of the step, such as `samples_at(1)`",
        ),
        (
            f64::INFINITY,
            0.1,
            "the interval between samples is inf, which is not finite\nhelp: write a multiple of the step, such as `samples_at(1)`",
        ),
        (
            0.37,
            -0.1,
            "the interval between samples is 0.37, but the steps of this run are -0.1, in the opposite direction\nhelp: write `samples_at(-0.37)`",
        ),
        (
            -0.37,
            0.1,
            "the interval between samples is -0.37, but the steps of this run are 0.1, in the opposite direction\nhelp: write `samples_at(0.37)`",
        ),
    ] {
        assert_eq!(first(interval, h).to_string(), text);
    }
    let mut back = HenonHeiles.run(start(), -0.1).expect("an admissible start").samples_at(-0.37);
    assert!(back.by_ref().take(5).all(|sample| sample.is_ok()));
}

#[test]
fn more_steps_than_can_be_counted() {
    let mut run = HenonHeiles.run(start(), 0.1).expect("an admissible start");
    run.advance(2).expect("finite");
    let before = run.state();
    let error = run.advance(u64::MAX - 1).expect_err("too many");
    assert_eq!(
        error.to_string(),
        "the run has taken 2 steps, and 18446744073709551614 more exceed the largest step count, 18446744073709551615"
    );
    assert_eq!((run.state(), run.steps()), (before, 2));
}

/// Far from zero, times are too coarse for a short step: the trajectory would move and its clock would not.
#[test]
fn steps_that_the_clock_does_not_notice() {
    // The times that a double has next to 1e10 are 1.9e-6 apart, and 2^53 is where they are 2 apart.
    let rows = [(1e10, 1e-7, 1), (-1e10, 1e-7, 1), (1e10, -1e-7, 1), (0.0, 1.0, 1 << 54), (0.0, 1e300, 1 << 40)];
    for (t0, h, steps) in rows {
        let mut run = HenonHeiles.run(start(), h).expect("an admissible start").at_time(t0);
        let text = run.advance(steps).expect_err("the clock stands still").to_string();
        let time = t0 + if steps == 1 { 0.0 } else { steps as f64 * h };
        let shown = |x: f64| if (1e-5..1e6).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") };
        let expected = format!(
            "the step h = {} is too short at t = {}, where t + h rounds to t\nhelp: start the clock closer to 0, or \
             choose another unit of time",
            shown(h),
            shown(time)
        );
        assert_eq!(text, expected);
        assert_eq!((run.steps(), run.state()), (0, start()));
        run.advance(0).expect("staying is possible");

        let mut swarm = Ensemble::new(Verlet, [(HenonHeiles, start())], h).expect("an admissible start").at_time(t0);
        assert_eq!(swarm.advance(steps).expect_err("the clock stands still").to_string(), expected);
    }
    // 2^-19 is such a distance, and a shortest step at zero is one as well.
    for (t0, h) in [(1e10, 2.0_f64.powi(-19)), (0.0, f64::from_bits(1))] {
        let mut run = HenonHeiles.run(start(), h).expect("an admissible start").at_time(t0);
        run.advance(1000).expect("times that differ");
        assert_eq!(run.time() - t0, 1000.0 * h);
    }
}
