//! Crossings of a section: where closed forms say they are, to the order of the composition, and without a trace in the
//! run.

use integrator_core::{
    Method,
    prelude::*,
    reference::{
        AdamsBashforthMoulton4, BackwardEuler, Bdf, DormandPrince8, ForwardEuler, ImplicitMidpoint, RungeKutta4,
        StaggeredLeapfrog,
    },
};
use std::f64::consts::{FRAC_PI_2, PI};

struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// Bodies that move straight on and are lost where `wall` is zero or less.
struct Straight {
    wall: f64,
}

#[hamiltonian]
impl Straight {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            if q[i] > self.wall {
                energy += (self.wall - q[i]).sqrt();
            }
        }
        energy
    }
}

/// One body from -1 with velocity 1, in steps that binary fractions hold.
fn straight(wall: f64) -> Run<Vec<f64>> {
    Straight { wall }.run(Phase::new(vec![-1.0], vec![1.0]), 0.25).expect("a start")
}

/// The states of a section, all of them.
fn all<C: integrator_core::Coords>(crossings: Crossings<C, impl FnMut(&Phase<C>, f64) -> f64>) -> Vec<Sample<C>> {
    crossings.collect::<Result<_, _>>().expect("finite states")
}

/// The run that looked is the run that did not, whatever the coordinates are kept in.
#[test]
fn a_section_leaves_the_bits_of_the_run() {
    macro_rules! same {
        ($composition:expr, $start:expr, $section:expr) => {{
            let run = Pendulum.run_with($composition, $start, 0.05).expect("a start");
            let mut plain = run.clone();
            plain.advance(3_000).expect("finite states");
            let mut crossings = run.crossings(3_000, Direction::Either, $section);
            // 3,000 steps are 150 units of time, and a swing of this amplitude takes 10.
            assert!(crossings.by_ref().filter(Result::is_ok).count() > 25);
            let mut looked = crossings.into_run();
            assert_eq!((looked.steps(), looked.time(), looked.state()), (3_000, plain.time(), plain.state()));
            looked.advance(1_000).expect("finite states");
            plain.advance(1_000).expect("finite states");
            assert_eq!(looked.state(), plain.state());
        }};
    }
    let (q, p) = ([2.5_f64], [0.0]);
    same!(Verlet, Phase::new(q, p), |state, _| state.q[0]);
    same!(BlanesCasasMurua8, Phase::new(q, p), |state, _| state.q[0]);
    same!(Euler, Phase::new([2.5_f32], [0.0]), |state, _| f64::from(state.q[0]));
    same!(Yoshida4, Phase::compensated(q, p), |state, _| state.q[0].value);
    same!(Yoshida4, Phase::reversible(q, p, 1.0 / (1_u64 << 44) as f64), |state, _| state.q[0].value());
}

/// How far the third zero of an oscillator's position is from `5π/2`.
fn error<X: Method<Oscillator>>(method: X, h: f64) -> f64 {
    let run = Oscillator.run_with(method, Phase::new([1.0], [0.0]), h).expect("a start");
    let third = all(run.crossings((9.0 / h) as u64, Direction::Either, |state, _| state.q[0])).swap_remove(2);
    (third.time - 5.0 * FRAC_PI_2).abs()
}

#[test]
fn the_times_of_crossings_have_the_order_of_the_composition() {
    fn check<X: Composition<Oscillator>>(composition: X, h: f64) {
        let ratio = error(composition, h) / error(composition, h / 2.0);
        let order = ratio.log2();
        // What follows the leading term is smaller by h², or by h where the composition is not symmetric.
        let expected = f64::from(X::ORDER);
        assert!((order - expected).abs() < 0.15, "{}: {order} for {expected}", X::NAME);
    }
    check(Verlet, 0.1);
    check(VelocityVerlet, 0.1);
    check(Yoshida4, 0.1);
    check(Suzuki4, 0.2);
    check(Ruth3, 0.05);
    check(Yoshida6, 0.2);
    check(KahanLi8, 0.8);
}

/// Methods that are no compositions shorten their steps as well.
#[test]
fn the_times_of_crossings_have_the_order_of_any_method() {
    for (order, errors) in [
        // Of first order in the amplitude, but these turn by atan h in a step, which is h but for h³/3.
        (2.0, [0.01, 0.005].map(|h| error(ForwardEuler, h))),
        (2.0, [0.01, 0.005].map(|h| error(BackwardEuler, h))),
        (2.0, [0.1, 0.05].map(|h| error(ImplicitMidpoint, h))),
        (2.0, [0.1, 0.05].map(|h| error(StaggeredLeapfrog, h))),
        (4.0, [0.1, 0.05].map(|h| error(RungeKutta4, h))),
        (4.0, [0.05, 0.025].map(|h| error(AdamsBashforthMoulton4, h))),
    ] {
        let observed = (errors[0] / errors[1]).log2();
        assert!((observed - order).abs() < 0.25, "{observed} for {order}: {errors:?}");
    }
    // Within its tolerance, for four quarters of a period.
    let adaptive = [error(DormandPrince8 { tolerance: 1e-10 }, 0.5), error(Bdf { tolerance: 1e-8 }, 0.5)];
    assert!(adaptive[0] < 1e-8 && adaptive[1] < 1e-5, "{adaptive:?}");
}

/// A quarter of the period of a pendulum of amplitude `a` is `K(sin(a/2))`, half of π over an arithmetic-geometric
/// mean.
#[test]
fn a_pendulum_passes_its_lowest_point_when_the_elliptic_integral_says() {
    let amplitude = 2.5_f64;
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let quarter = PI / (2.0 * a);
    let run = Pendulum.run_with(KahanLi8, Phase::new([amplitude], [0.0]), 0.05).expect("a start");
    let passes = all(run.crossings(2_000, Direction::Either, |state, _| state.q[0]));
    assert_eq!(passes.len(), 19, "100 units of time, {quarter} for a quarter");
    for (number, pass) in passes.iter().enumerate() {
        let expected = quarter * (2 * number + 1) as f64;
        // 2,000 steps of a rounding each, with an unstable point nearby, where the period reacts to the energy.
        assert!((pass.time - expected).abs() < 1e-11, "pass {number}: {} for {expected}", pass.time);
        assert!((pass.energy() + amplitude.cos()).abs() < 1e-11);
        assert_eq!(pass.step, (pass.time / 0.05) as u64);
        // Time is resolved to a rounding of the step, which the velocity, 2 at most, turns into a distance.
        assert!(pass.state.q[0].abs() <= 2.0 * 0.05 * 2.0 * f64::EPSILON, "{:e}", pass.state.q[0]);
    }
    assert!(passes.iter().zip(1..).all(|(pass, number)| (pass.state.p[0] < 0.0) == (number % 2 == 1)));
}

#[test]
fn directions_are_those_of_the_run() {
    for h in [0.1, -0.1] {
        let count = |direction| {
            let run = Oscillator.run(Phase::new([1.0], [0.1]), h).expect("a start").at_time(4.0);
            all(run.crossings(126, direction, |state, _| state.q[0]))
        };
        let (rising, falling, either) = (count(Direction::Rising), count(Direction::Falling), count(Direction::Either));
        assert_eq!((rising.len(), falling.len(), either.len()), (2, 2, 4), "12.6 is two periods");
        // Back in time, the position rises where its velocity is negative.
        assert!(rising.iter().all(|sample| sample.state.p[0] * h > 0.0));
        assert!(falling.iter().all(|sample| sample.state.p[0] * h < 0.0));
        assert!(either.is_sorted_by(|a, b| (b.time - a.time) * h > 0.0));
        assert_eq!(either[0].time, falling[0].time, "it starts above zero");
    }
}

#[test]
fn a_section_may_be_a_time() {
    let run = Oscillator.run(Phase::new([1.0], [0.0]), 0.1).expect("a start").at_time(-3.0);
    let found = all(run.crossings(100, Direction::Rising, |_, t| t - 0.7));
    // A rounding of the clock, at 3, for the beginning of the step and for the sum.
    assert!(found.len() == 1 && (found[0].time - 0.7).abs() <= 2.0 * f64::EPSILON, "{found:?}");
    assert_eq!(found[0].step, 36, "3.6 of 3.7 are whole steps");
}

#[test]
fn a_zero_after_a_step_is_the_crossing() {
    let found = all(straight(9.0).crossings(8, Direction::Either, |state, _| state.q[0]));
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].time, found[0].step, found[0].state.q[0]), (1.0, 4, 0.0));
    // What is behind the zero decides: before that step, nothing is known.
    assert_eq!(straight(9.0).crossings(4, Direction::Either, |state, _| state.q[0]).count(), 0);
    // Zero over a stretch: where it is left.
    let dead = |state: &Phase<Vec<f64>>, _| if state.q[0].abs() < 0.3 { 0.0 } else { state.q[0] };
    let found = all(straight(9.0).crossings(8, Direction::Rising, dead));
    assert_eq!((found.len(), found[0].time), (1, 1.25));
}

#[test]
fn what_touches_zero_or_stays_there_does_not_cross() {
    let touching = |state: &Phase<Vec<f64>>, _| state.q[0].powi(2);
    assert_eq!(straight(9.0).crossings(8, Direction::Either, touching).count(), 0);
    let mut nothing = straight(9.0).crossings(8, Direction::Either, |_, _| 0.0);
    assert!(nothing.next().is_none());
    assert_eq!(nothing.into_run().steps(), 8);
    let from_there = |state: &Phase<Vec<f64>>, _| state.q[0] + 1.0;
    assert_eq!(straight(9.0).crossings(8, Direction::Either, from_there).count(), 0);
    assert_eq!(straight(9.0).crossings(0, Direction::Either, from_there).count(), 0);
}

#[test]
fn a_jump_from_side_to_side_is_found_where_it_is() {
    let found = all(straight(9.0).crossings(8, Direction::Rising, |_, t| if t < 0.8 { -1.0 } else { 1.0 }));
    assert!(found.len() == 1 && (found[0].time - 0.8).abs() <= f64::EPSILON, "{found:?}");
}

#[test]
fn a_function_without_a_value_is_an_error_and_the_end() {
    let mut crossings = straight(9.0).crossings(8, Direction::Either, |state, _| state.q[0].sqrt());
    assert!(matches!(crossings.next(), Some(Err(Error::Crossing { time: 0.0, value })) if value.is_nan()));
    assert!(crossings.next().is_none());
    // Signs differ between 0.75 and 1, and between these there is a pole.
    let pole = |_: &Phase<Vec<f64>>, t: f64| if t > 0.8 && t < 0.95 { f64::INFINITY } else { t - 0.9 };
    let mut crossings = straight(9.0).crossings(8, Direction::Either, pole);
    assert!(matches!(crossings.next(), Some(Err(Error::Crossing { time, .. })) if time > 0.8 && time < 0.95));
    assert!(crossings.next().is_none());
}

#[test]
fn crossings_before_a_loss_are_seen() {
    let mut crossings = straight(0.6).crossings(100, Direction::Rising, |state, _| state.q[0] - 0.1);
    let first = crossings.next().expect("a crossing").expect("finite states");
    // Straight on for 1.1, from -1 to 0.1: a rounding of each of the five steps.
    assert!((first.time - 1.1).abs() <= 5.0 * f64::EPSILON);
    assert!(matches!(crossings.next(), Some(Err(Error::Diverged(_)))));
    assert!(crossings.next().is_none());
    assert_eq!(crossings.into_run().steps(), 6, "the wall is after 6.4 steps");
    let mut nowhere = straight(9.0).at_time(f64::NAN).crossings(8, Direction::Rising, |state, _| state.q[0]);
    assert!(matches!(nowhere.next(), Some(Err(Error::Time { .. }))));
}
