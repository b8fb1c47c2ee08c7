//! Crossings of a section: where closed forms say they are, to the order of the composition, and without a trace in the
//! run.

use integrator_core::{Method, prelude::*};
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
fn the_times_of_crossings_have_the_order_of_implicit_methods() {
    for (order, errors) in
        [(2.0, [0.1, 0.05].map(|h| error(ImplicitMidpoint, h))), (4.0, [0.2, 0.1].map(|h| error(GaussLegendre4, h)))]
    {
        let observed = (errors[0] / errors[1]).log2();
        assert!((observed - order).abs() < 0.25, "{observed} for {order}: {errors:?}");
    }
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
fn functions_that_touch_zero_or_stay_there_do_not_cross() {
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
fn crossings_before_a_failure_are_returned() {
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

/// Turns of a pendulum that rotates, each found by a new run from the one before: none is found twice.
#[test]
fn a_run_from_a_crossing_has_left_it() {
    fn turns<X: Method<Pendulum>>(method: X, h: f64, direction: Direction) {
        let (mut state, mut time) = (Phase::new([0.3], [2.5]), 0.0);
        for turn in 0..50 {
            let run = Pendulum.run_with(method, state, h).expect("a start").at_time(time);
            let mut crossings = run.crossings(1_000, direction, |state, _| f64::sin(state.q[0]));
            let next = crossings.next().expect("it rotates").expect("finite states");
            // It turns by at most 2.5 in a unit of time, and half a turn is 3.1; the first one begins at 0.3.
            assert!((next.time - time) * h.signum() > if turn == 0 { 0.1 } else { 1.2 }, "{time}, {}", next.time);
            (state, time) = (next.state, next.time);
        }
    }
    for h in [0.05, 0.125, -0.05] {
        for direction in [Direction::Rising, Direction::Falling, Direction::Either] {
            turns(Verlet, h, direction);
            turns(Yoshida4, h, direction);
            turns(ImplicitMidpoint, h, direction);
        }
    }
}

/// A ball above a floor, whose flights every composition integrates without an error but rounding.
struct Ball;

#[hamiltonian]
impl Ball {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0]
    }
}

#[test]
fn a_ball_bounces_a_hundred_thousand_times() {
    const BOUNCES: u64 = 100_000;
    // A flight takes twice the velocity, 2 units of time and 3.2 steps.
    let h = 0.625;
    let mut run = Ball.run(Phase::new([0.0], [1.0]), h).expect("a start");
    let mut bounces = 0_u32;
    let steps = ((2 * BOUNCES + 1) as f64 / h) as u64;
    let reflect = |state: &mut Phase<[f64; 1]>, time: f64| {
        state.p[0] = -state.p[0];
        bounces += 1;
        let exact = 2.0 * f64::from(bounces);
        // Each of its steps rounds the velocity, hence the length of all later flights: n times the sum of n roundings of either
        // sign, n^(3/2) in the mean, of which ten are allowed; and the clock rounds.
        let allowed = 10.0 * f64::EPSILON * f64::from(bounces).powf(1.5) + 4.0 * f64::EPSILON * exact;
        assert!((time - exact).abs() <= allowed, "{bounces}: {time}, {:e} of {allowed:e}", time - exact);
    };
    let found = run.on_crossing(steps, Direction::Falling, |state, _| state.q[0], reflect).expect("finite states");
    assert_eq!((found, run.steps(), run.time()), (BOUNCES, steps, steps as f64 * h));
    assert!(run.state().q[0] > 0.0);
}

/// A change that leaves the function on the side where it came from, or rounds it back there, is no further crossing.
#[test]
fn an_action_may_leave_the_state_on_either_side() {
    let rotor = || Pendulum.run_with(KahanLi8, Phase::new([0.3], [2.5]), 0.25).expect("a start");
    let sine = |state: &Phase<[f64; 1]>, _: f64| state.q[0].sin();
    let undisturbed = all(rotor().crossings(2_000, Direction::Either, sine));
    type Action = fn(&mut Phase<[f64; 1]>);
    let actions: [(&str, Action); 4] = [
        ("nothing", |_| {}),
        ("wrapped", |state| state.q[0] = state.q[0].rem_euclid(std::f64::consts::TAU)),
        ("back", |state| state.q[0] -= 4e-16 * state.q[0].abs().max(1.0)),
        ("exact", |state| state.q[0] = (state.q[0] / PI).round() * PI),
    ];
    for (name, action) in actions {
        let mut times = Vec::new();
        let act = |state: &mut Phase<[f64; 1]>, time: f64| {
            action(state);
            times.push(time);
        };
        let found = rotor().on_crossing(2_000, Direction::Either, sine, act).expect("finite states");
        assert_eq!(found, undisturbed.len() as u64, "{name}");
        for (time, other) in times.iter().zip(&undisturbed) {
            // Steps of order 8 that are cut otherwise: the error of a step of a quarter, added up over 500 units of time.
            assert!((time - other.time).abs() < 1e-6, "{name}: {time} and {}", other.time);
        }
    }
    // Turned around in both directions: back through the lowest point, each time from the other side.
    let mut swing = Pendulum.run_with(KahanLi8, Phase::new([0.3], [0.5]), 0.25).expect("a start");
    let mut times = Vec::new();
    let turn = |state: &mut Phase<[f64; 1]>, time: f64| {
        state.p[0] = -state.p[0];
        times.push(time);
    };
    let found = swing.on_crossing(2_000, Direction::Either, sine, turn).expect("finite states");
    // It swings on one side alone, half a period of 6.4 for an amplitude of 0.6 between two turns.
    assert!((150..=160).contains(&found), "{found}");
    assert!(times.is_sorted_by(|a, b| b - a > 3.0));
}

/// A particle on a circle of length one, which passes its end several times within a step.
#[test]
fn crossings_that_an_action_leads_to_are_found_in_the_same_step() {
    for h in [0.3, 1.0, 2.5, 7.0] {
        let mut run = Straight { wall: 9.0 }.run(Phase::new(vec![0.0], vec![1.0]), h).expect("a start");
        let mut times = Vec::new();
        let back = |state: &mut Phase<Vec<f64>>, time: f64| {
            state.q[0] -= 1.0;
            times.push(time);
        };
        let steps = (20.5 / h) as u64;
        let found =
            run.on_crossing(steps, Direction::Rising, |state, _| state.q[0] - 1.0, back).expect("finite states");
        assert_eq!(found as f64, (h * steps as f64 - 1e-9).floor(), "{h}");
        for (time, number) in times.iter().zip(1..) {
            // A rounding of the position and one of the clock for each turn and each step.
            assert!((time - f64::from(number)).abs() <= 40.0 * 20.0 * f64::EPSILON, "{h}: {time}");
        }
        assert_eq!((run.steps(), run.time()), (steps, steps as f64 * h));
    }
}

/// Without crossings it is `advance`, and with one the steps behind it have the bits of a run from the end of that step.
#[test]
fn steps_without_a_crossing_are_those_of_the_run() {
    let run = Pendulum.run_with(Yoshida4, Phase::new([2.5], [0.0]), 0.05).expect("a start");
    let (mut plain, mut looked) = (run.clone(), run);
    plain.advance(100).expect("finite states");
    let none =
        looked.on_crossing(100, Direction::Either, |state, _| state.q[0] - 9.0, |_, _| ()).expect("finite states");
    assert_eq!((none, looked.state()), (0, plain.state()));
    let lowest = |state: &Phase<[f64; 1]>, _: f64| state.q[0];
    let one = looked.on_crossing(60, Direction::Either, lowest, |state, _| state.p[0] *= 1.5).expect("finite states");
    assert_eq!((one, looked.steps(), looked.time()), (1, 160, 160.0 * 0.05));
    let mut begun = Pendulum.run_with(Yoshida4, looked.state(), 0.05).expect("a start").at_time(looked.time());
    looked.advance(50).expect("finite states");
    begun.advance(50).expect("finite states");
    assert_eq!(looked.state(), begun.state());
}

#[test]
fn an_action_that_is_refused_leaves_the_run_at_the_step_before() {
    let mut run = straight(9.0);
    let section = |state: &Phase<Vec<f64>>, _: f64| state.q[0] - 0.1;
    let refused = run.on_crossing(100, Direction::Rising, section, |state, _| state.p[0] = f64::NAN);
    assert!(matches!(refused, Err(Error::Start { .. })), "{refused:?}");
    assert_eq!((run.steps(), run.time(), run.state().q[0]), (4, 1.0, 0.0));
    let refused = run.on_crossing(100, Direction::Rising, |_, _| f64::NAN, |_, _| ());
    assert!(matches!(refused, Err(Error::Crossing { .. })), "{refused:?}");
    // Beyond the wall, forces have no value.
    let mut lost = straight(0.6);
    let lost_at = lost.on_crossing(100, Direction::Rising, section, |state, _| state.q[0] += 1.0);
    assert!(matches!(lost_at, Err(Error::Diverged(_) | Error::Energy { .. })), "{lost_at:?}");
    assert_eq!(lost.steps(), 4);
    // Twice the velocity from there on, in the middle of a step.
    let found = run.on_crossing(4, Direction::Rising, section, |state, _| state.p[0] = 2.0).expect("finite states");
    assert_eq!((found, run.steps()), (1, 8));
    assert!((run.state().q[0] - (0.1 + 2.0 * 0.9)).abs() <= 8.0 * f64::EPSILON);
}
