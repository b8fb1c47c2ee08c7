//! Hamiltonians that read the time, against their motion in closed form.

use crate::{
    catalogue::for_each_composition,
    kepler::ellipse,
    measured_order::{assert_order, observed_order},
    systems::error,
};
use integrator_core::prelude::*;

/// A planet of a sun that is shaken: `q = x + s(t)`, where `x` moves on Kepler's ellipse and `s = a sin ωt`. The sun's
/// acceleration is felt as an inertial force, which `V` undoes.
struct ShakenSun {
    amplitude: f64,
    omega: f64,
}

#[hamiltonian]
impl ShakenSun {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let s = self.amplitude * (self.omega * t).sin();
        let x = q[0] - s;
        self.omega.powi(2) * s * q[0] - 1.0 / (x * x + q[1] * q[1]).sqrt()
    }
}

/// The same in the frame that moves with the sun: `p` is the velocity relative to it, and `T` reads the time as well.
struct MovingFrame {
    amplitude: f64,
    omega: f64,
}

#[hamiltonian]
impl MovingFrame {
    fn kinetic(&self, p: [f64; 2], time: f64) -> f64 {
        let speed = self.amplitude * self.omega * (self.omega * time).cos();
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + speed * p[0]
    }
    fn potential(&self, q: [f64; 2], time: f64) -> f64 {
        let x = q[0] - self.amplitude * (self.omega * time).sin();
        -1.0 / (x * x + q[1] * q[1]).sqrt()
    }
}

/// The shaken sun with positions and momenta exchanged, `(q, p) -> (-p, q)`: the same motion, with a `T` that is neither
/// quadratic nor constant.
struct Exchanged {
    amplitude: f64,
    omega: f64,
}

#[hamiltonian]
impl Exchanged {
    fn kinetic(&self, p: [f64; 2], t: f64) -> f64 {
        let s = self.amplitude * (self.omega * t).sin();
        let x = p[0] - s;
        self.omega.powi(2) * s * p[0] - 1.0 / (x * x + p[1] * p[1]).sqrt()
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[0] + q[1] * q[1]) / 2.0
    }
}

/// A clock that does not start at 0.
const T0: f64 = 1.25;

type State = ([f64; 2], [f64; 2]);

const SHAKEN: ShakenSun = ShakenSun { amplitude: 0.3, omega: 2.0 };
const MOVING: MovingFrame = MovingFrame { amplitude: 0.3, omega: 2.0 };
const EXCHANGED: Exchanged = Exchanged { amplitude: 0.3, omega: 2.0 };

fn of_the_shaken_sun(t: f64) -> State {
    let (mut q, mut p) = ellipse(0.4, t);
    q[0] += 0.3 * (2.0 * t).sin();
    p[0] += 0.6 * (2.0 * t).cos();
    (q, p)
}

fn of_the_moving_frame(t: f64) -> State {
    let (mut q, p) = ellipse(0.4, t);
    q[0] += 0.3 * (2.0 * t).sin();
    (q, p)
}

fn of_the_exchanged_sun(t: f64) -> State {
    let (q, p) = of_the_shaken_sun(t);
    (p.map(|p| -p), q)
}

fn measure<H: Hamiltonian<Coords = [f64; 2]>, X: Composition<H>>(
    name: &str,
    system: &H,
    composition: X,
    exact: fn(f64) -> State,
) {
    let (q, p) = exact(T0);
    // The second one runs backwards.
    for span in [2.0, -1.6] {
        let states = std::array::from_fn(|look| exact(T0 + (look as f64 + 1.0) * span));
        let error = |steps: u64| {
            let run = system.run_with(composition, Phase::compensated(q, p), span / steps as f64);
            error(run.expect("an admissible start").at_time(T0), steps, &states)
        };
        let observed = observed_order(X::ORDER, error);
        assert_order(&format!("{} on {name} every {span}", X::NAME), X::ORDER, observed);
    }
}

#[test]
fn compositions_keep_their_orders_where_v_reads_the_time() {
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure("a shaken sun", &SHAKEN, $composition, of_the_shaken_sun);)*
        };
    }
    for_each_composition!(general_kinds: each!);
}

#[test]
fn every_composition_keeps_its_order_where_both_read_the_time() {
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure("a moving frame", &MOVING, $composition, of_the_moving_frame);)*
        };
    }
    for_each_composition!(general: each!);
}

#[test]
fn compositions_keep_their_orders_where_t_reads_the_time() {
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure("an exchanged sun", &EXCHANGED, $composition, of_the_exchanged_sun);)*
        };
    }
    for_each_composition!(general_kinds: each!);
}

#[test]
fn the_energy_is_that_of_the_present_time() {
    let (q, p) = of_the_moving_frame(T0);
    let mut run = MOVING.run(Phase::new(q, p), 0.01).expect("an admissible start").at_time(T0);
    for _ in 0..3 {
        let (state, t) = (run.state(), run.time());
        let parts = [MOVING.kinetic(state.p, t), MOVING.potential(state.q, t)];
        // Both are of order one and made of a dozen operations.
        assert!((run.energy() - parts[0] - parts[1]).abs() < 24.0 * f64::EPSILON, "at {t}");
        run.advance(10).expect("finite");
    }
    let sample = run.samples(10).nth(2).expect("a sample").expect("finite");
    let (state, t) = (sample.state, sample.time);
    assert!((sample.energy() - MOVING.kinetic(state.p, t) - MOVING.potential(state.q, t)).abs() < 24.0 * f64::EPSILON);
}

#[test]
fn portions_and_samples_do_not_change_a_bit() {
    macro_rules! each {
        ($($composition:ident)*) => {$({
            let (q, p) = of_the_moving_frame(T0);
            let start = || {
                let run = MOVING.run_with($composition, Phase::new(q, p), 0.01);
                run.expect("an admissible start").at_time(T0)
            };
            let mut whole = start();
            whole.advance(1500).expect("finite");
            let mut portions = start();
            for portion in [1, 1022, 2, 475] {
                portions.advance(portion).expect("finite");
            }
            let sampled = start().samples(500).nth(3).expect("a sample").expect("finite");
            let state = whole.state();
            assert_eq!((portions.state(), sampled.state), (state, state), "{}", stringify!($composition));
        })*};
    }
    for_each_composition!(general_kinds: each!);
}
