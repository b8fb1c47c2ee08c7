//! Steps in a time of their own where the potential reads the time: a coordinate whose momentum stands alone in `T`.

use crate::measured_order::observed_order;
use integrator_core::prelude::*;

/// A comet whose star pulses, with the time as its last coordinate.
struct Pulsing;

#[hamiltonian]
impl Pulsing {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + p[2]
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -(1.0 + 0.1 * q[2].sin()) / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// The same comet with the time as an argument, for fixed steps.
struct InTime;

#[hamiltonian]
impl InTime {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        -(1.0 + 0.1 * t.sin()) / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

const SPAN: f64 = 7.0;

#[test]
fn the_time_may_be_a_coordinate() {
    // Of order 10 and in short steps: its error is far below those that are looked at, 8e-11 and more.
    let mut exact = InTime
        .run_with(SofroniouSpaletta10, Phase::compensated([0.4, 0.0], [0.0, 2.0]), 7.0 / 8192.0)
        .expect("a start");
    exact.advance(8192).expect("finite states");
    let [x, y] = exact.state().q.map(|leaf| leaf.value);
    let begin = |h| {
        let start = Phase::compensated([0.4, 0.0, 0.0], [0.0, 2.0, 0.0]);
        Pulsing.run_with(Logarithmic(Yoshida4), start, h).expect("a start")
    };
    let order = observed_order(4, |steps| {
        let mut run = begin(SPAN / steps as f64);
        run.advance_to(SPAN).expect("finite states");
        let q = run.state().q.map(|leaf| leaf.value);
        assert!((q[2] - SPAN).abs() < 1e-13, "the coordinate is the time: {}", q[2]);
        f64::hypot(q[0] - x, q[1] - y)
    });
    assert!((order - 4.0).abs() < 0.3, "observed {order}");
}

/// Members in lanes, whose coordinates of time differ, have the bits of their runs.
#[test]
fn members_have_the_bits_of_their_runs() {
    let start = |member: usize| Phase::new([0.4, 0.0, 0.3 * member as f64], [0.0, 2.0 - 0.01 * member as f64, 0.0]);
    let members = (0..19).map(|member| (Pulsing, start(member)));
    let mut swarm = Ensemble::new(Logarithmic(Yoshida4), members, 0.05).expect("members");
    for steps in [1, 62] {
        swarm.advance(steps).expect("finite states");
    }
    for member in 0..19 {
        let mut run = Pulsing.run_with(Logarithmic(Yoshida4), start(member), 0.05).expect("a start");
        run.advance(63).expect("finite states");
        assert_eq!((swarm.state(member), swarm.time_of(member)), (Some(run.state()), Some(run.time())), "{member}");
    }
}

/// The way back takes the coordinate of time back, too.
#[test]
fn the_time_runs_back() {
    let start = Phase::new([0.4, 0.0, 0.0], [0.0, 2.0, 0.0]);
    let mut there = Pulsing.run_with(Logarithmic(KahanLi8), start, 0.05).expect("a start");
    there.advance(200).expect("finite states");
    let turned = there.state();
    assert!(turned.q[2] > 5.0, "the time went on: {}", turned.q[2]);
    // The run back takes its energy from the state where it turns, a rounding of which lengthens all steps alike: it is
    // compared at the same time, not after the same steps.
    let mut back = Pulsing.run_with(Logarithmic(KahanLi8), turned, -0.05).expect("a start");
    back.advance_to(-there.time()).expect("finite states");
    let off =
        back.state().q.into_iter().zip(start.q).map(|(one, other): (f64, f64)| (one - other).abs()).fold(0.0, f64::max);
    // 400 steps of 17 stages, each with some roundings, along an orbit on which errors grow like the time.
    assert!(off < 400.0 * 17.0 * 4.0 * f64::EPSILON, "off by {off:e}");
}
