//! The global error as `check` measures it, against the one that closed forms tell.

use crate::{
    motions::{ellipse, pendulum},
    runs::{Fall, Kepler, Pendulum, pericentre},
};
use integrator_core::{
    Coords, Error, Method,
    check::{CheckError, global_error, observed_order},
    prelude::*,
    taylor::Taylor,
};

const QUARTERS: u64 = 4;

/// The distance of a run from where `exact` says it should be, found without any reference, in units of `far` for
/// positions and for momenta.
fn distance<C: Coords<Leaf = f64>>(mut run: Run<C>, steps: u64, far: [f64; 2], exact: impl Fn(f64) -> Phase<C>) -> f64 {
    let squares = |one: &C, other: &C, unit: f64| {
        one.flat().iter().zip(other.flat()).map(|(one, other)| ((one - other) / unit).powi(2)).sum::<f64>()
    };
    let mut sum = 0.0;
    for _ in 0..QUARTERS {
        run.advance(steps / QUARTERS).expect("finite states");
        let (state, exact) = (run.state(), exact(run.time()));
        sum += squares(&state.q, &exact.q, far[0]) + squares(&state.p, &exact.p, far[1]);
    }
    (sum / QUARTERS as f64).sqrt()
}

/// Holds the distance that is measured against the one that is known, over a time without and one with whole periods.
fn check<H, X>(system: &H, method: X, start: Phase<H::Coords>, far: [f64; 2], exact: impl Fn(f64) -> Phase<H::Coords>)
where
    H: Hamiltonian,
    X: Method<H>,
{
    for (h, steps) in [(0.05, 1_024), (-0.05, 400), (std::f64::consts::TAU / 128.0, 1_024)] {
        let run = system.run_with::<f64, X>(method, start.clone(), h).expect("a start");
        let known = distance(run, steps, far, &exact);
        let measured = global_error::<H, X, f64>(system, method, start.clone(), h, steps).expect("a reference");
        // As for states: 1e-15 in a unit of time, ten times as much where pericentres are steep.
        assert!(measured.uncertainty < 1e-14 * (1.0 + measured.span.abs()), "{measured:?}");
        // Closed forms are summed in doubles, with a phase of up to 50. How far a motion goes is seen some hundred
        // times in each period, a fortieth of a radian beside its farthest point at most, where it is a parabola.
        let bound = 4.0 * measured.uncertainty + 1e-13 + 1e-3 * known;
        assert!((measured.distance - known).abs() < bound, "{known:e}, {measured:?}");
        assert_eq!(measured.span, steps as f64 * h);
    }
}

#[test]
fn the_distance_is_that_to_the_closed_form() {
    let of_pendulum = |t| {
        let [q, p] = pendulum(2.0, t);
        Phase::new([q], [p])
    };
    let of_kepler = |t| {
        let [x, y, px, py] = ellipse(0.6, t);
        Phase::new([x, y], [px, py])
    };
    macro_rules! methods {
        ($($method:expr),*) => {$(
            // From one side to the other, and the speed at the lowest point; to the apocentre, where velocities are
            // opposite.
            check(&Pendulum, $method, Phase::new([2.0], [0.0]), [4.0, 2.0 * 1.0_f64.sin()], of_pendulum);
            check(&Kepler, $method, pericentre(0.6), [2.0, 2.5], of_kepler);
        )*};
    }
    methods!(Verlet, KahanLi8, Taylor::tolerance(1e-6), Taylor::tolerance(1e-18));
}

#[test]
fn the_precision_of_a_run_is_that_of_its_start() {
    let error = |measured: Result<integrator_core::check::GlobalError, _>| measured.expect("a reference").distance;
    let single = error(global_error(&Pendulum, KahanLi8, Phase::new([2.0_f32], [0.0]), 0.1, 400));
    let double = error(global_error(&Pendulum, KahanLi8, Phase::new([2.0], [0.0]), 0.1, 400));
    assert!(single > 1e-7 && single < 1e-4 && double < 1e-8, "{single:e}, {double:e}");
}

#[test]
fn impossible_measurements_are_errors() {
    let start = Phase::new([2.0], [0.0]);
    let none = global_error(&Pendulum, Verlet, start, 0.1, 0);
    assert_eq!(none, Err(CheckError::TooFewSteps { steps: 0, needed: 1 }));
    let still = global_error(&Pendulum, Verlet, start, 0.0, 8);
    assert_eq!(still, Err(CheckError::Run(Error::Step { h: 0.0 })));
    // It falls within 1.1; in coarse steps a run passes by.
    let fallen = global_error(&Fall, Verlet, Phase::new([1.0], [0.0]), 0.07, 40);
    assert!(matches!(fallen, Err(CheckError::NoReference { .. })), "{fallen:?}");
}

/// Against the same exact motion, compositions show what they claim.
#[test]
fn orders_are_those_that_are_claimed() {
    macro_rules! claimed {
        ($($composition:ident)*) => {$(
            for h in [0.1, -0.01] {
                certify(&Pendulum, $composition, Phase::new([2.0], [0.3]), h).expect("a right stepper");
                let order = observed_order(&Kepler, $composition, pericentre(0.3), h).expect("a slope");
                let claimed = f64::from($composition::ORDER);
                assert!((order.slope - claimed).abs() < 0.5, "{order:?} of {}", $composition::NAME);
            }
        )*};
    }
    claimed!(Verlet Yoshida4 Yoshida6 KahanLi8 SofroniouSpaletta10);
}
