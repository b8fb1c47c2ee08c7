//! Time transformations: steps that shorten by themselves.

use crate::{kepler::ellipse, measured_order::observed_order};
use integrator_core::{Coords, Method, check::certify, prelude::*};
use std::f64::consts::{PI, TAU};

/// A body that is attracted by `pull/r + twist/r³`.
#[derive(Clone, Copy)]
struct Comet {
    pull: f64,
    twist: f64,
    /// What the pace is less than the inverse square of the distance.
    slow: f64,
}

#[hamiltonian]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let square = q[0] * q[0] + q[1] * q[1];
        -self.pull / square.sqrt() - self.twist / (square * square.sqrt())
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]) - self.slow
    }
}

/// The same without the part that falls with the third power, whose kick is simpler.
struct TwoBodies;

#[hamiltonian]
impl TwoBodies {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / q[0].hypot(q[1])
    }
}

fn at_pericentre(e: f64) -> Phase<[f64; 2]> {
    Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()])
}

const TWISTED: Comet = Comet { pull: 1.0, twist: 0.005, slow: 0.0 };

#[test]
fn two_bodies_stay_on_their_orbit_whatever_the_step() {
    for e in [0.0, 0.6, 0.9, 0.99, 0.9999] {
        for h in [0.8, -0.1] {
            let mut run = TwoBodies.run_with(Logarithmic(SofroniouSpaletta8), at_pericentre(e), h).expect("a start");
            let energy = run.energy();
            run.advance(10_000).expect("finite states");
            // A rounding at the pericentre, where speeds are highest, is one of 2/(1 - e) times the energy; fifteen kicks and
            // drifts a step walk, and a factor of 8 covers the tail of the walk.
            let walk = 8.0 * f64::EPSILON * 2.0 / (1.0 - e) * (2.0 * 15.0 * 1e4_f64).sqrt();
            let moved = (run.energy() / energy - 1.0).abs();
            assert!(moved < walk, "e = {e}, h = {h}: the energy moves by {moved:e}, rounding explains {walk:e}");
        }
    }
}

#[test]
fn errors_in_time_fall_with_the_order() {
    fn order<X: Method<Comet>>(method: X) -> f64 {
        let e = 0.6;
        let ([x, y], [u, v]) = ellipse(e, 7.0);
        let comet = Comet { twist: 0.0, ..TWISTED };
        observed_order(method.facts().order, |steps| {
            let h = 7.0 / steps as f64;
            let start = at_pericentre(e);
            let mut run = comet.run_with(method, Phase::compensated(start.q, start.p), h).expect("a start");
            run.advance_to(7.0).expect("finite states");
            assert_eq!(run.time(), 7.0);
            let Phase { q, p } = run.state();
            f64::hypot(q[0].value - x, q[1].value - y) + f64::hypot(p[0].value - u, p[1].value - v)
        })
    }
    let slopes = [
        (2.0, order(Logarithmic(Verlet))),
        (4.0, order(Logarithmic(Yoshida4))),
        (8.0, order(Logarithmic(KahanLi8))),
        (4.0, order(Power(0.5, Yoshida4))),
        (2.0, order(Paced(Verlet))),
        (4.0, order(Paced(Yoshida4))),
    ];
    for (claimed, slope) in slopes {
        assert!(f64::abs(slope - claimed) < 0.3, "claimed {claimed}, observed {slope}");
    }
}

/// A fast body that is attracted by `pull/r`: its velocity is not linear in its momentum.
struct Relativistic {
    pull: f64,
}

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt()
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.pull / q[0].hypot(q[1])
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / q[0].hypot(q[1])
    }
}

#[test]
fn a_pace_keeps_the_order_where_the_velocity_is_not_linear_in_the_momentum() {
    fn end<X: Method<Relativistic>>(method: X, steps: u32) -> [f64; 4] {
        let (start, h) = (Phase::compensated([1.0, 0.0], [0.0, 0.45]), 12.0 / f64::from(steps));
        let mut run = Relativistic { pull: 0.3 }.run_with(method, start, h).expect("a start");
        run.advance_to(12.0).expect("finite states");
        let Phase { q, p } = run.state();
        [q[0], q[1], p[0], p[1]].map(|slot| slot.value)
    }
    let exact = end(KahanLi8, 4_096);
    let error = |end: [f64; 4]| end.iter().zip(exact).map(|(found, exact)| (found - exact).powi(2)).sum::<f64>().sqrt();
    // With the mean of the velocities at both ends of a kick, BlanesMoan6 would be of order 2, and compositions of symmetric
    // steps would keep theirs. Errors from 1e-3 to 1e-10, far above the roundings of the variable that follows the pace, which are 1e-13.
    let slopes = [
        (2.0, end(Paced(Verlet), 384), end(Paced(Verlet), 768)),
        (4.0, end(Paced(Yoshida4), 96), end(Paced(Yoshida4), 192)),
        (6.0, end(Paced(BlanesMoan6), 24), end(Paced(BlanesMoan6), 48)),
        (8.0, end(Paced(KahanLi8), 12), end(Paced(KahanLi8), 24)),
    ];
    for (claimed, coarse, fine) in slopes {
        let slope = (error(coarse) / error(fine)).log2();
        assert!((slope - claimed).abs() < 0.1, "claimed {claimed}, observed {slope}");
    }
    // A run back from its end follows the same way.
    let (system, start) = (Relativistic { pull: 0.3 }, Phase::new([1.0, 0.0], [0.0, 0.45]));
    let mut forth = system.run_with(Paced(KahanLi8), start, 0.05).expect("a start");
    forth.advance(200).expect("finite states");
    let mut back = system.run_with(Paced(KahanLi8), forth.state(), -0.05).expect("a start");
    back.advance(200).expect("finite states");
    let Phase { q: [x, y], .. } = back.state();
    // The variable begins anew at the end, at the pace there, which it follows to the eighth order.
    assert!(f64::hypot(x - 1.0, y) < 1e-11, "{x} {y}");
}

#[test]
fn the_drift_comes_first_whatever_comes_first_in_the_composition() {
    let start = at_pericentre(0.5);
    let [drift, kick] = [
        TwoBodies.run_with::<f64, _>(Logarithmic(Verlet), start, 0.1),
        TwoBodies.run_with::<f64, _>(Logarithmic(VelocityVerlet), start, 0.1),
    ]
    .map(|run| {
        let mut run = run.expect("a start");
        run.advance(100).expect("finite states");
        (run.time(), run.state())
    });
    assert_eq!(drift, kick);
}

#[test]
fn a_time_transformation_is_symplectic_and_of_its_order() {
    let certificate = certify(&TWISTED, Logarithmic(KahanLi8), at_pericentre(0.6), 0.2).expect("a certificate");
    assert!(certificate.symplectic_defect < 1e-13);
    let refused = certify(&TWISTED, Paced(Yoshida4), at_pericentre(0.6), 0.05).expect_err("a pace is not symplectic");
    let refused = refused.to_string();
    assert!(refused.contains("Paced is not symplectic") && refused.contains("(claimed 4; "), "{refused}");
    assert!(!refused.contains("falls short of"), "{refused}");
    let certificate = certify(&TWISTED, Power(0.5, Yoshida4), at_pericentre(0.6), 0.05).expect("a certificate");
    assert!(certificate.symplectic_defect < 1e-13);
}

#[test]
fn reading_a_run_does_not_change_it() {
    fn look<C: Coords + PartialEq>(run: Run<C>) {
        let (mut alone, mut seen) = (run.clone(), run);
        alone.advance(700).expect("finite states");
        let end = alone.time();
        for part in 0..50 {
            let time = end * f64::from(part) / 50.0;
            seen.advance_to(time).expect("a later time");
            assert_eq!(seen.time(), time);
            let mut again = seen.clone();
            again.advance(0).expect("no step");
            assert!((time - again.time()) * end >= 0.0, "the run stands at the step before");
        }
        let left = 700 - seen.steps();
        seen.advance(left).expect("finite states");
        assert_eq!((seen.time(), seen.state()), (end, alone.state()));
    }
    for h in [0.03, -0.03] {
        look(TWISTED.run_with::<f64, _>(Logarithmic(Yoshida4), at_pericentre(0.6), h).expect("a start"));
        look(TWISTED.run_with::<f64, _>(Power(0.3, Yoshida4), at_pericentre(0.6), h).expect("a start"));
        look(TWISTED.run_with::<f64, _>(Paced(Yoshida4), at_pericentre(0.6), h).expect("a start"));
        look(TWISTED.run_with::<f64, _>(Yoshida4, at_pericentre(0.6), h).expect("a start"));
    }
}

#[test]
fn samples_and_crossings_are_at_times_of_the_motion() {
    let run = TwoBodies.run_with::<f64, _>(Logarithmic(SofroniouSpaletta8), at_pericentre(0.9), 0.3).expect("a start");
    // Each step is of order 8 and far below the rounding of a period here but for what it loses in time.
    let close = |found: f64, exact: f64| assert!((found - exact).abs() < 1e-8, "{found} instead of {exact}");
    for (sample, number) in run.clone().samples_at(0.75 * PI).zip(0..20) {
        let sample = sample.expect("finite states");
        assert_eq!(sample.time, f64::from(number) * 0.75 * PI);
        let ([x, y], _) = ellipse(0.9, sample.time);
        close(sample.state.q[0], x);
        close(sample.state.q[1], y);
    }
    let ends = run.crossings(200, Direction::Either, |state, _| state.q[0] * state.p[0] + state.q[1] * state.p[1]);
    for (end, number) in ends.zip(1..6) {
        close(end.expect("finite states").time, f64::from(number) * PI);
    }
}

/// At each pericentre the momenta turn around: the motion goes back on its ellipse, and the time goes on.
#[test]
fn a_state_that_is_changed_at_crossings_continues_in_time() {
    let mut run =
        TwoBodies.run_with::<f64, _>(Logarithmic(SofroniouSpaletta8), at_pericentre(0.9), 0.3).expect("a start");
    run = run.at_time(5.0);
    let mut times = Vec::new();
    let radial = |state: &Phase<[f64; 2]>, _: f64| state.q[0] * state.p[0] + state.q[1] * state.p[1];
    let turn = |state: &mut Phase<[f64; 2]>, time: f64| {
        state.p = state.p.map(|p| -p);
        times.push(time);
    };
    let found = run.on_crossing(200, Direction::Falling, radial, turn).expect("finite states");
    assert!(found > 4, "{found}");
    // The first crossing is an apocentre after half a period. Turned around there, the way in rises and the way out falls.
    for (time, number) in times.iter().zip(0..5) {
        let exact = 5.0 + PI + f64::from(number) * 2.0 * PI;
        assert!((time - exact).abs() < 1e-7, "{number}: {time} instead of {exact}");
    }
    assert!(run.time() > times[4]);
}

#[test]
fn a_changed_state_continues_in_time() {
    let mut run = TwoBodies.run_with::<f64, _>(Logarithmic(Yoshida4), at_pericentre(0.3), 0.1).expect("a start");
    run = run.at_time(5.0);
    run.advance(10).expect("finite states");
    let before = run.time();
    assert!(before > 5.0);
    run.map_state(|state| state.p[1] *= 1.1).expect("a state");
    assert_eq!(run.time(), before);
    let mut fresh = TwoBodies.run_with::<f64, _>(Logarithmic(Yoshida4), run.state(), 0.1).expect("a start");
    run.advance(10).expect("finite states");
    fresh.advance(10).expect("finite states");
    assert_eq!(run.state(), fresh.state());
    // Both sum up the same durations; one of them adds where it began.
    assert!((run.time() - (before + fresh.time())).abs() <= 4.0 * f64::EPSILON * run.time());
}

#[test]
fn members_have_the_bits_of_their_runs_even_if_others_fail() {
    // A member that is repelled has no such time, and those of its lanes are dealt out anew.
    let members: Vec<_> = (0..13)
        .map(|member| {
            let pull = if member % 4 == 1 { -1.0 } else { 1.0 + 0.01 * f64::from(member) };
            (Comet { pull, twist: 0.0, slow: 0.0 }, at_pericentre(0.5))
        })
        .collect();
    let mut swarm = Ensemble::new(Logarithmic(KahanLi8), members.clone(), 0.1).expect("members");
    let lost = swarm.advance(100).expect_err("some are repelled");
    assert!(matches!(lost, Error::Lost(lost) if lost.members.len() == 3));
    swarm.advance(2_000).expect("the others are well");
    let mut paced = Ensemble::new(Paced(KahanLi8), members.clone(), 0.02).expect("members");
    let lost = paced.advance(2_100).expect_err("some go to where no pace is left");
    assert!(matches!(lost, Error::Lost(lost) if lost.members.len() == 3));
    for (member, (comet, start)) in members.iter().enumerate().filter(|(member, _)| member % 4 != 1) {
        let mut run = comet.run_with(Paced(KahanLi8), *start, 0.02).expect("a start");
        run.advance(2_100).expect("finite states");
        assert_eq!(paced.state(member), Some(run.state()), "member {member}");
        assert_eq!(paced.time_of(member), Some(run.time()), "member {member}");
        let mut run = comet.run_with(Logarithmic(KahanLi8), *start, 0.1).expect("a start");
        run.advance(2_100).expect("finite states");
        assert_eq!(
            (swarm.time_of(member), swarm.state(member)),
            (Some(run.time()), Some(run.state())),
            "member {member}"
        );
    }
    swarm.map_states(|_, state| state.p[1] *= 1.01).expect("states");
    swarm.advance(300).expect("finite states");
    let (comet, start) = members[2];
    let mut run = comet.run_with(Logarithmic(KahanLi8), start, 0.1).expect("a start");
    run.advance(2_100).expect("finite states");
    run.map_state(|state| state.p[1] *= 1.01).expect("a state");
    run.advance(300).expect("finite states");
    assert_eq!((swarm.time_of(2), swarm.state(2)), (Some(run.time()), Some(run.state())));
}

#[test]
fn a_time_transformation_that_does_not_apply_is_an_error() {
    let repelled = Comet { pull: -1.0, ..TWISTED };
    let mut run = repelled.run_with::<f64, _>(Logarithmic(Verlet), at_pericentre(0.1), 0.1).expect("a start");
    let error = run.advance(1).expect_err("no attraction").to_string();
    assert!(error.contains("requires V < 0") && error.contains("subtract a constant"), "{error}");
    assert_eq!((run.steps(), run.state()), (0, at_pericentre(0.1)));

    let stalled = Comet { slow: 10.0, ..TWISTED };
    let mut run = stalled.run_with::<f64, _>(Paced(Verlet), at_pericentre(0.6), 0.01).expect("a start");
    let error = run.advance(10_000).expect_err("no pace at a distance of 0.4").to_string();
    assert!(error.contains("positive everywhere"), "{error}");
    assert_eq!((run.steps(), run.state()), (0, at_pericentre(0.6)));

    let error = TwoBodies.run_with::<f64, _>(Power(0.0, Verlet), at_pericentre(0.1), 0.1).map(drop);
    assert_eq!(error, Err(Error::Exponent { exponent: 0.0 }));

    let mut run = TwoBodies.run_with::<f64, _>(Logarithmic(Verlet), at_pericentre(0.1), 0.1).expect("a start");
    run.advance_to(TAU).expect("a later time");
    assert!(matches!(run.advance_to(1.0), Err(Error::Passed { time, .. }) if time == 1.0));
    assert!(matches!(run.advance_to(f64::NAN), Err(Error::Time { .. })));
    assert_eq!(run.time(), TAU);
}
