//! Steps that are too long for their composition are warned of, and those that are not are not.

use crate::systems::{HenonHeiles, Kepler, Pendulum, Relativistic, Skewed};
use integrator_core::{
    __private::Composition,
    Compensated, Euler, Hamiltonian, KahanLi8, Phase, Scheme, Verlet, Yoshida4,
    check::{CheckError, Stability, certify, shadow, stability},
};

const PENDULUM: Pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };

fn told<H, X, const N: usize>(system: &H, composition: X, start: Phase<[f64; N]>, h: f64) -> Stability
where
    H: Hamiltonian<Coords = [f64; N]>,
    X: Composition<H>,
{
    stability::<H, X, f64>(system, composition, &start, h).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_turn(stability: Stability, expected: f64) {
    // A frequency is the root of an eigenvalue of a product of two derivatives, each a few operations.
    assert!((stability.turn / expected - 1.0).abs() < 64.0 * f64::EPSILON, "{stability:?} for {expected}");
}

#[test]
fn frequencies_are_those_of_the_linear_motion() {
    // At rest at the bottom: √(g/l).
    assert_turn(told(&PENDULUM, Verlet, Phase::new([0.0], [0.0]), 0.01), 0.01 * (9.81_f64 / 0.5).sqrt());
    // A step backwards turns as far.
    assert_turn(told(&PENDULUM, Verlet, Phase::new([0.0], [0.0]), -0.01), 0.01 * (9.81_f64 / 0.5).sqrt());
    // Both modes of the galaxy's centre have the frequency 1.
    assert_turn(told(&HenonHeiles {}, Yoshida4, Phase::new([0.0, 0.0], [0.0, 0.0]), 0.1), 0.1);
    // T = p₀² + p₀p₁ + p₁², V = cosh q₀ - cos q₁ + q₀q₁/4: T″V″ = (2 1; 1 2)(1 1/4; 1/4 1) has 3.75 as its largest.
    assert_turn(told(&Skewed {}, Verlet, Phase::new([0.0, 0.0], [0.0, 0.0]), 0.1), 0.1 * 3.75_f64.sqrt());
    // T″ = (1 + p²)^(-3/2), which no mass tells; V″ = 3q².
    let (q, p) = (0.5_f64, 0.75_f64);
    let squared = 3.0 * q * q / (1.0 + p * p).powf(1.5);
    let at_once = told(&Relativistic {}, Verlet, Phase::new([q], [p]), 1e-9);
    assert!((at_once.turn / (1e-9 * squared.sqrt()) - 1.0).abs() < 1e-4, "{at_once:?}");
}

#[test]
fn the_fastest_point_of_an_orbit_counts() {
    // At the distance r the force restores across the line of sight with the frequency r^(-3/2), and along it, it
    // flees.
    let eccentricity: f64 = 0.9;
    let start = Phase::new([1.0 + eccentricity, 0.0], [0.0, ((1.0 - eccentricity) / (1.0 + eccentricity)).sqrt()]);
    let found = told(&Kepler { mass: 1.0, attraction: 1.0 }, KahanLi8, start, 1e-3);
    let at_pericentre = 1e-3 * (1.0 - eccentricity).powf(-1.5);
    // Between two looks, 32 steps, the distance at the pericentre changes by a few hundredths.
    assert!(found.turn < at_pericentre && found.turn > 0.95 * at_pericentre, "{found:?} for {at_pericentre}");
    assert!((found.time - std::f64::consts::PI).abs() < 0.032, "half a period: {found:?}");
}

#[test]
fn a_step_near_the_limit_is_certified_with_a_warning() {
    let start = Phase::new([0.1], [0.0]);
    let frequency = (9.81_f64 / 0.5).sqrt();
    for (share, near) in [(0.1, false), (0.45, false), (0.55, true), (0.7, true)] {
        let h = share * Verlet::STABILITY_LIMIT / frequency;
        let certificate = certify(&PENDULUM, Verlet, start, h).unwrap_or_else(|error| panic!("{error}"));
        let stability = certificate.stability.expect("a measurement");
        assert_eq!(stability.is_near(), near, "{stability}");
        assert_eq!(certificate.to_string().contains("WARNING"), near, "{certificate}");
        // The pendulum is slower where it leans.
        assert!((stability.share() - share).abs() < 0.01, "{stability}");
    }
    assert!(told(&PENDULUM, Verlet, start, 2.5 / frequency).is_near(), "a run that diverges");
}

#[test]
fn any_scalar_type_is_measured_and_bad_input_is_an_error() {
    let start = Phase::new([0.1], [0.2]);
    let plain = told(&PENDULUM, Euler, start, 0.01);
    let compensated = Phase::compensated(start.q, start.p);
    assert_eq!(stability::<_, _, Compensated<f64>>(&PENDULUM, Euler, &compensated, 0.01), Ok(plain));
    for (start, h) in [(start, 0.0), (start, f64::NAN), (Phase::new([f64::NAN], [0.0]), 0.01)] {
        assert!(matches!(stability(&PENDULUM, Euler, start, h), Err(CheckError::Run(_))));
        let twice = Phase::new([start.q[0]; 2], [start.p[0]; 2]);
        assert!(matches!(shadow(&HenonHeiles {}, Verlet, twice, h), Err(CheckError::Run(_))));
    }
}
