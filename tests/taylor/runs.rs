//! Runs of the Taylor method against closed forms, and what they promise wherever they are looked at.

use crate::motions::{apart, ellipse, pendulum};
use integrator_core::{
    Coords, Error, Run, Unsolved,
    check::{CertifyError, CheckError, Shortfall, certify, observed_order, symplectic_defect_after},
    prelude::*,
    taylor::Taylor,
};

pub(crate) struct Oscillator;

#[hamiltonian(taylor)]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

pub(crate) struct Pendulum;

#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

pub(crate) struct Kepler;

#[hamiltonian(taylor)]
impl Kepler {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// A constant force, none, or a potential that is not bounded below.
pub(crate) struct Hill {
    pub(crate) slope: f64,
    pub(crate) quartic: f64,
}

#[hamiltonian(taylor)]
impl Hill {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.slope * q[0] - self.quartic * q[0].powi(4)
    }
}

/// A body that falls onto another one.
pub(crate) struct Fall;

#[hamiltonian(taylor)]
impl Fall {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -1.0 / q[0].abs()
    }
}

pub(crate) struct Driven;

#[hamiltonian(taylor)]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -q[0] * (2.0 * t).cos()
    }
}

/// A chain of as many sites as the start has.
pub(crate) struct Chain;

#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            sum += stretch * stretch / 2.0 + stretch.powi(4) / 4.0;
        }
        sum
    }
}

/// Leaves nothing but rounding.
pub(crate) const FINE: f64 = 1e-18;

fn fine() -> Taylor {
    Taylor::tolerance(FINE)
}

fn flat<C: Coords<Leaf = f64>>(run: &Run<C>) -> Vec<f64> {
    let state = run.state();
    [state.q.flat(), state.p.flat()].concat()
}

fn bits<C: Coords<Leaf = f64>>(run: &Run<C>) -> Vec<u64> {
    flat(run).iter().map(|x| x.to_bits()).collect()
}

/// The start of an ellipse at its pericentre.
pub(crate) fn pericentre(eccentricity: f64) -> Phase<[f64; 2]> {
    let [x, y, px, py] = ellipse(eccentricity, 0.0);
    Phase::new([x, y], [px, py])
}

/// For how long runs are held against closed forms. The method takes a few steps per unit of time, each of which
/// rounds a state of size one or two by 1e-16 or twice that: 1e-15 per unit of time, were they all of one sign. What rounds the
/// energy turns the phase more and more: another unit of time times the time, were they all of one sign; they are not.
pub(crate) const TIME: f64 = 100.0;
pub(crate) const PER_TIME: f64 = 1e-15;

#[test]
fn an_oscillator_is_a_sine() {
    for h in [0.125, -0.125, 3.125] {
        let mut run = Oscillator.run_with(fine(), Phase::new([0.6], [0.8]), h).expect("a start");
        for _ in 0..32 {
            run.advance(1).expect("finite states");
            let t = run.time();
            let exact = [0.6 * t.cos() + 0.8 * t.sin(), 0.8 * t.cos() - 0.6 * t.sin()];
            let error = apart(&flat(&run), &exact);
            assert!(error < PER_TIME * (1.0 + t.abs()), "{error:e} at {t}");
        }
    }
}

#[test]
fn a_pendulum_is_an_elliptic_function() {
    for (amplitude, unit) in [(0.01, PER_TIME), (1.0, PER_TIME), (2.0, 2.0 * PER_TIME)] {
        let mut run = Pendulum.run_with(fine(), Phase::new([amplitude], [0.0]), 0.25).expect("a start");
        while run.time() < TIME {
            run.advance(7).expect("finite states");
            let error = apart(&flat(&run), &pendulum(amplitude, run.time()));
            // The nearer to the top, the more a change of the energy changes the period.
            assert!(error < unit * (1.0 + run.time()), "{error:e} at {} from {amplitude}", run.time());
        }
    }
}

#[test]
fn two_bodies_move_along_ellipses() {
    for eccentricity in [0.0, 0.3, 0.6] {
        let mut run = Kepler.run_with(fine(), pericentre(eccentricity), 0.25).expect("a start");
        while run.time() < TIME {
            run.advance(7).expect("finite states");
            let error = apart(&flat(&run), &ellipse(eccentricity, run.time()));
            // At the pericentre bodies are faster and forces steeper by the square of its inverse distance. The energy walks by
            // a few 1e-16 per root of the time, and the mean motion by three times that (Kepler's third law), which turns
            // the phase with the power 3/2 of the time.
            let (unit, t) = (PER_TIME / (1.0_f64 - eccentricity).powi(2), run.time());
            assert!(error < unit * (4.0 + 4.0 * t + t.powf(1.5)), "{error:e} at {t} for {eccentricity}");
        }
    }
}

#[test]
fn states_do_not_depend_on_where_a_run_is_sampled() {
    let start = || Kepler.run_with(Taylor::tolerance(1e-15), pericentre(0.5), 0.25).expect("a start");
    let mut whole = start();
    whole.advance(100).expect("finite states");

    let mut portions = start();
    for steps in [1, 0, 41, 7, 51] {
        portions.advance(steps).expect("finite states");
        let (mut copy, _) = (portions.clone(), portions.energy());
        copy.advance(3).expect("finite states");
        assert_ne!(bits(&copy), bits(&portions));
    }
    assert_eq!(bits(&portions), bits(&whole));

    // A quarter of the step looks four times as often at the same polynomials.
    let mut finer = Kepler.run_with(Taylor::tolerance(1e-15), pericentre(0.5), 0.0625).expect("a start");
    for sample in start().samples(10).take(11) {
        let sample = sample.expect("finite states");
        assert_eq!(finer.state(), sample.state);
        finer.advance(if sample.time < 25.0 { 40 } else { 0 }).expect("finite states");
    }
    assert_eq!(bits(&finer), bits(&whole));
}

#[test]
fn chains_of_any_length_do_not_depend_on_portions_either() {
    for length in [1, 2, 9] {
        let start = Phase::new((0..length).map(|i| f64::from(i % 3) / 4.0).collect(), vec![0.0; length as usize]);
        let mut whole = Chain.run_with(fine(), start.clone(), 0.5).expect("a start");
        let mut portions = whole.clone();
        whole.advance(200).expect("finite states");
        (0..20).for_each(|_| portions.advance(10).expect("finite states"));
        assert_eq!(bits(&portions), bits(&whole));
        // There are as many steps in this time as units of it; each rounds every site.
        let energy = portions.energy() - Chain.run_with(fine(), start, 0.5).expect("a start").energy();
        assert!(energy.abs() < 100.0 * f64::from(length) * f64::EPSILON, "{energy:e} for {length}");
    }
}

#[test]
fn loops_find_orders_that_are_odd_too() {
    // Two orders at a time: of an odd order, the last one is not looked at.
    let start = Phase::new((0..9).map(|i| f64::from(i % 3) / 4.0).collect(), vec![0.0; 9]);
    for order in 12..29 {
        let mut run = Chain.run_with(fine().with_order(order), start.clone(), 0.5).expect("a start");
        let energy = run.energy();
        run.advance(40).expect("finite states");
        // The lowest order takes thirty steps per unit of time, each of which rounds every site.
        let error = (run.energy() - energy).abs();
        assert!(error < 20.0 * 30.0 * 9.0 * f64::EPSILON / 2.0, "{error:e} by order {order}");
    }
}

#[test]
fn runs_come_back() {
    let mut there = Pendulum.run_with(fine(), Phase::new([2.0], [0.5]), 0.125).expect("a start");
    there.advance(400).expect("finite states");
    let mut back = Pendulum.run_with(fine(), there.state(), -0.125).expect("a start");
    back.advance(400).expect("finite states");
    let distance = apart(&flat(&back), &[2.0, 0.5]);
    assert!(distance < 2.0 * 50.0 * PER_TIME, "{distance:e}");
}

#[test]
fn the_clock_of_a_driven_system_begins_anywhere() {
    // p' = cos 2t, so that p - p₀ and q - q₀ are integrals of it.
    for (t0, h) in [(0.0, 0.5), (10.0, 0.5), (-3.0, -0.25)] {
        let mut run = Driven.run_with(fine(), Phase::new([1.0], [0.0]), h).expect("a start").at_time(t0);
        for _ in 0..20 {
            run.advance(2).expect("finite states");
            let (t, passed) = (run.time(), run.time() - t0);
            let momentum = ((2.0 * t).sin() - (2.0 * t0).sin()) / 2.0;
            let place = 1.0 - ((2.0 * t).cos() - (2.0 * t0).cos()) / 4.0 - (2.0 * t0).sin() / 2.0 * passed;
            let error = apart(&flat(&run), &[place, momentum]);
            // The time itself is rounded in units of 4e-15 beyond 16, and the place grows to 20.
            assert!(error < 16.0 * PER_TIME * (1.0 + passed.abs()), "{error:e} at {t} from {t0}");
        }
    }
}

#[test]
fn single_precision_is_that_of_the_start() {
    let mut run = Pendulum.run_with(Taylor::tolerance(1e-9), Phase::new([2.0_f32], [0.0]), 0.25).expect("a start");
    run.advance(80).expect("finite states");
    let (state, exact) = (run.state(), pendulum(2.0, 20.0));
    let error = apart(&[state.q[0].into(), state.p[0].into()], &exact);
    // The same count of roundings as above, each of 6e-8.
    assert!(error < 20.0 * PER_TIME * f64::from(f32::EPSILON) / f64::EPSILON, "{error:e}");
    assert!(error > 1e-9, "no precision of another scalar: {error:e}");
}

#[test]
fn compensation_does_no_harm() {
    // Steps are long: an update is about as large as the state, and its own roundings, which nothing carries, are too.
    for eccentricity in [0.0, 0.25, 0.5] {
        let Phase { q, p } = pericentre(eccentricity);
        let mut run = Kepler.run_with(fine(), Phase::compensated(q, p), 0.25).expect("a start");
        run.advance(400).expect("finite states");
        let error = (run.energy() + 0.5).abs();
        assert!(error < PER_TIME * TIME, "{error:e}");
    }
}

#[test]
fn tolerances_that_are_not_positive_and_finite_are_refused() {
    for tolerance in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        let refused = Pendulum.run_with(Taylor::tolerance(tolerance), Phase::new([2.0], [0.0]), 0.1);
        assert!(matches!(refused, Err(Error::Tolerance { method: "Taylor", .. })), "{tolerance}: {refused:?}");
    }
}

#[test]
fn a_fall_onto_a_singularity_ends_in_an_error_that_keeps_the_last_state() {
    // From rest at distance 1, the time of the fall is that of half an ellipse of semimajor axis 1/2: π/√8.
    let end = std::f64::consts::PI / 8.0_f64.sqrt();
    for at in [1.0, -1.0] {
        let mut run = Fall.run_with(fine(), Phase::new([at], [0.0]), 1.0 / 64.0).expect("a start");
        let error = run.advance(1_000).expect_err("a singularity");
        let Error::NotSolved { method: "Taylor", step, time, reason: Unsolved::Singular { time: near, reach } } = error
        else {
            panic!("{error}");
        };
        assert_eq!((run.steps() + 1, run.time()), (step, time));
        assert!(time < end && end < time + 1.0 / 64.0, "{time} is the last step before {end}");
        assert!((near - end).abs() < 1e-6 && reach.abs() < 1e-6, "{near}, {reach}");
        // Half of p² is 1/q - 1.
        let [q, p] = flat(&run)[..] else { panic!("two numbers") };
        let energy = p * p / 2.0 - 1.0 / q.abs();
        assert!(q * at > 0.0 && (energy + 1.0).abs() < 1e-12, "{q}, {p}: {energy}");
        // It goes on to be an error, and the state to be kept.
        assert!(run.advance(1).is_err());
        assert_eq!(flat(&run), [q, p]);
    }
}

#[test]
fn a_motion_to_infinity_in_finite_time_ends_in_an_error() {
    let hill = Hill { slope: 0.0, quartic: 1.0 };
    let mut run = hill.run_with(fine(), Phase::new([1.0], [0.0]), 1.0 / 64.0).expect("a start");
    let error = run.advance(1_000).expect_err("infinity");
    assert!(matches!(error, Error::NotSolved { .. } | Error::Diverged(_)), "{error}");
    let [q, p] = flat(&run)[..] else { panic!("two numbers") };
    assert!(q.is_finite() && p.is_finite() && q > 10.0, "{q}, {p}");
    // p²/2 - q⁴ is -1.
    assert!((p * p / 2.0 - q.powi(4) + 1.0).abs() < 1e-12 * q.powi(4), "{q}, {p}");
}

#[test]
fn motions_that_are_polynomials_have_one() {
    for slope in [0.0, 2.0] {
        let hill = Hill { slope, quartic: 0.0 };
        let mut run = hill.run_with(fine(), Phase::new([1.0], [0.5]), 1_024.0).expect("a start");
        run.advance(1_024).expect("finite states");
        let t = 1_048_576.0;
        assert_eq!(flat(&run), [1.0 + 0.5 * t + slope * t * t / 2.0, 0.5 + slope * t]);
    }
}

#[test]
fn no_number_of_steps_is_too_large_for_a_tolerance() {
    // Its roundings exceed the largest step count; a shear of whole numbers of any length is symplectic all the same.
    let level = Hill { slope: 0.0, quartic: 0.0 };
    let defect = symplectic_defect_after(&level, fine(), Phase::new([0.0_f64], [1.0]), 1.0, 1 << 62);
    assert_eq!(defect, Ok(0.0));
}

#[test]
fn an_equilibrium_is_kept() {
    let mut run = Pendulum.run_with(fine(), Phase::new([0.0], [0.0]), 1e3).expect("a start");
    run.advance(1_000_000).expect("finite states");
    assert_eq!(flat(&run), [0.0, 0.0]);
    let mut run = Kepler.run_with(fine(), pericentre(0.0), 0.5).expect("a start");
    run.advance(10).expect("finite states");
}

#[test]
fn a_run_returns_the_steps_that_it_chose() {
    let begin = || Kepler.run_with(fine(), pericentre(0.6), 0.25).expect("a start");
    let mut run = begin();
    assert_eq!((run.evaluations(), run.own_steps().map(|steps| steps.taken)), (0, Some(0)));
    run.advance(400).expect("finite states");
    let steps = run.own_steps().expect("steps of its own");
    // They end somewhere in the last one.
    assert!(steps.taken as f64 * steps.shortest < TIME && TIME < (steps.taken + 1) as f64 * steps.longest, "{steps:?}");
    // Forces change more slowly by the power 3/2 of the distance, which is a factor of eight on this orbit.
    assert!((4.0..16.0).contains(&(steps.longest / steps.shortest)), "{steps:?}");
    // Each polynomial, the present one included, has all of its orders.
    assert_eq!(run.evaluations(), (steps.taken + 1) * fine().order() as u64);

    let mut portions = begin();
    for _ in 0..40 {
        portions.advance(10).expect("finite states");
        let _ = portions.state();
    }
    assert_eq!((portions.own_steps(), portions.evaluations()), (Some(steps), run.evaluations()));
    // A new state is a new beginning, and what was counted stays.
    run.map_state(|state| state.p[1] = -state.p[1]).expect("a state");
    let evaluations = run.evaluations();
    let kept = run.own_steps().map(|own| (own.taken, own.shortest, own.longest, own.under_way));
    assert_eq!(kept, Some((steps.taken, steps.shortest, steps.longest, None)));
    run.advance(40).expect("finite states");
    let later = run.own_steps().expect("steps of its own");
    assert_eq!(run.evaluations() - evaluations, (later.taken - steps.taken + 1) * fine().order() as u64);

    assert_eq!(Kepler.run(pericentre(0.6), 0.25).expect("a start").own_steps(), None);
}

struct Falling;

#[hamiltonian(taylor)]
impl Falling {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0]
    }
}

/// Displayed are steps that were taken: none, where one polynomial is the motion at all times.
#[test]
fn a_motion_that_is_a_polynomial_completes_no_step() {
    let mut run = Falling.run_with(fine(), Phase::new([0.0], [1.0]), 0.25).expect("a start");
    let own = |run: &Run<[f64; 1]>| run.own_steps().expect("steps of its own");
    assert_eq!(own(&run).to_string(), "no step completed");
    run.advance(1000).expect("finite states");
    assert_eq!((own(&run).taken, own(&run).under_way), (0, Some(f64::INFINITY)));
    assert_eq!(own(&run).to_string(), "no step completed, the current polynomial is valid at all times");

    let mut run = Pendulum.run_with(fine(), Phase::new([1.0], [0.0]), 0.25).expect("a start");
    run.advance(1000).expect("finite states");
    let steps = own(&run);
    let under_way = steps.under_way.expect("a step");
    assert!(under_way.is_finite() && !format!("{steps}").contains("inf"), "{steps}");
    assert!(steps.to_string().starts_with(&format!("{} steps of {} to ", steps.taken, steps.shortest)), "{steps}");
}

#[test]
fn no_certificate_calls_it_symplectic() {
    let refused = certify(&Pendulum, Taylor::tolerance(1e-16), Phase::new([2.0], [0.0]), 0.1);
    let Err(CertifyError::Refused { shortfalls, .. }) = refused else { panic!("{refused:?}") };
    assert!(shortfalls.contains(&Shortfall::NotSymplectic { method: "Taylor" }), "{shortfalls:?}");
    // Steps of its own have no order that shows.
    let order = observed_order(&Pendulum, Taylor::tolerance(1e-16), Phase::new([2.0], [0.0]), 0.1);
    assert_eq!(order, Err(CheckError::NoOrder { method: "Taylor" }));
}
