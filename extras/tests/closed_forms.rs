//! Motions that are known in closed form: the pendulum by Jacobi's elliptic functions, Kepler's ellipse by his
//! equation. Every method arrives there, with an error that falls as its order says. The oscillator, where every single
//! step has a closed form, is in `linear.rs` of the laboratory.

#[path = "../../tests/support/motions.rs"]
mod motions;

use integrator_core::{Method, prelude::*};
use integrator_reference::{
    AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec, BackwardEuler, ExplicitMidpoint, ForwardEuler,
    GraggBulirschStoer, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog, Stoermer4, StoermerCowell4,
};
use motions::{apart, complete, ellipse, jacobi, pendulum};

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

#[test]
fn elliptic_functions_are_those_of_others() {
    // Fifteen digits by mpmath, for m = k² = 1/2.
    let k = 0.5_f64.sqrt();
    assert!((complete(k) - 1.854_074_677_301_372).abs() < 1e-14);
    for [u, sn] in [[0.5, 0.470_750_473_655_657], [1.0, 0.803_001_824_895_644]] {
        let [found, cn, dn] = jacobi(u, k);
        assert!((found - sn).abs() < 1e-14, "sn({u}) = {found}");
        assert!((found * found + cn * cn - 1.0).abs() < 1e-15 && (dn * dn + 0.5 * found * found - 1.0).abs() < 1e-15);
    }
    // A quarter of a period is K, and without a modulus the functions are those of a circle.
    assert!(apart(&jacobi(complete(0.8), 0.8), &[1.0, 0.0, 0.6]) < 1e-14);
    assert!(apart(&jacobi(0.7, 0.0), &[0.7_f64.sin(), 0.7_f64.cos(), 1.0]) < 1e-15);
}

/// The error of a method at a time, in so many steps.
fn pendulum_error<M: Method<Pendulum>>(method: M, steps: u64) -> f64 {
    const TIME: f64 = 7.0;
    let mut run = Pendulum.run_with(method, Phase::new([2.0], [0.0]), TIME / steps as f64).expect("a start");
    run.advance(steps).expect("finite states");
    let state = run.state();
    apart(&[state.q[0], state.p[0]], &pendulum(2.0, TIME))
}

fn kepler_error<M: Method<Kepler>>(method: M, steps: u64) -> f64 {
    const TIME: f64 = 7.0;
    const ECCENTRICITY: f64 = 0.3;
    let [x, y, px, py] = ellipse(ECCENTRICITY, 0.0);
    let mut run = Kepler.run_with(method, Phase::new([x, y], [px, py]), TIME / steps as f64).expect("a start");
    run.advance(steps).expect("finite states");
    let state = run.state();
    apart(&[state.q[0], state.q[1], state.p[0], state.p[1]], &ellipse(ECCENTRICITY, TIME))
}

/// A row for each method: steps over a period and a bit from which the error falls as the order says, and the order.
macro_rules! for_each_method {
    ($check:ident) => {
        $check! {
            Euler: 4_000, 1;
            EulerAdjoint: 4_000, 1;
            ForwardEuler: 16_000, 1;
            BackwardEuler: 16_000, 1;
            StaggeredLeapfrog: 400, 2;
            ExplicitMidpoint: 1_600, 2;
            ImplicitMidpoint: 400, 2;
            RungeKutta4: 400, 4;
            AdamsBashforth4: 1_600, 4;
            AdamsBashforthMoulton4: 800, 4;
            AdamsBashforthMoulton4Pec: 1_600, 4;
            Stoermer4: 800, 4;
            StoermerCowell4: 400, 4;
            GraggBulirschStoer: 18, 8;
            Verlet: 400, 2;
            VelocityVerlet: 400, 2;
            Yoshida4: 200, 4;
            BlanesMoan6: 50, 6;
            KahanLi8: 25, 8;
        }
    };
}

/// What halving the step does to an error. Slopes are off by up to a quarter where the next term still shows,
/// as in high orders before the rounding, and by one or more for a method that is not what it should be.
fn falls(error: impl Fn(u64) -> f64, steps: u64, order: i32, name: &str) {
    let (coarse, fine) = (error(steps), error(2 * steps));
    let slope = (coarse / fine).log2();
    assert!((slope - f64::from(order)).abs() < 0.3, "{name}: {coarse:e} then {fine:e}, a slope of {slope:.2}");
}

#[test]
fn methods_approach_the_elliptic_functions_with_their_order() {
    macro_rules! check {
        ($($method:ident: $steps:literal, $order:literal;)*) => {$(
            falls(|steps| pendulum_error($method, steps), $steps, $order, stringify!($method));
        )*};
    }
    for_each_method!(check);
    // Half a thousand steps of 17 stages, each of which rounds a state of size 2: at worst 1e-11, and as a random walk
    // 1e-13.
    let error = pendulum_error(KahanLi8, 500);
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn methods_approach_the_ellipse_with_their_order() {
    macro_rules! check {
        ($($method:ident: $steps:literal, $order:literal;)*) => {$(
            falls(|steps| kepler_error($method, 2 * steps), $steps, $order, stringify!($method));
        )*};
    }
    for_each_method!(check);
    // Roundings along the orbit turn it and are multiplied by the angle gone through, hence another factor.
    let error = kepler_error(KahanLi8, 1_000);
    assert!(error < 1e-11, "{error:e}");
}
