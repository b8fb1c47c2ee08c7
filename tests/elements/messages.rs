//! What is wrong with elements or a state: each error, its message, and that nothing panics.

use integrator_core::{
    orbit::{self, Anomaly, Elements, Frame, OrbitError},
    prelude::*,
};
use std::f64::consts::PI;

/// Elements that differ from a valid orbit.
fn but(change: impl Fn(&mut Elements)) -> Result<(), OrbitError> {
    let mut orbit = Elements::with_axis(1.0, 0.5);
    change(&mut orbit);
    orbit.state(1.0).map(|_| ())
}

fn system(masses: &[f64], orbits: &[Elements]) -> Result<(), OrbitError> {
    orbit::state::<[[f64; 3]; 2]>(Frame::Jacobi, 1.0, masses, orbits).map(|_| ())
}

#[test]
fn messages_say_what_is_wrong_and_what_to_write() {
    let valid = Elements::with_axis(1.0, 0.5);
    let inclined = Elements { inclination: 0.1, ..valid };
    let at_rest = Phase::new([[1.0; 3]; 2], [[0.0; 3]; 2]);
    let table: [(Result<(), OrbitError>, &str, &str); 22] = [
        (
            valid.state(0.0).map(|_| ()),
            "gravitational parameter",
            "but it is 0\nhelp: it is the gravitational constant times",
        ),
        (valid.state(f64::NAN).map(|_| ()), "gravitational parameter", "but it is NaN"),
        (but(|orbit| orbit.eccentricity = -0.1), "the eccentricity has to be", "but it is -0.1\nhelp: 0 is a circle"),
        (but(|orbit| orbit.eccentricity = f64::INFINITY), "the eccentricity has to be", "but it is inf"),
        (
            Elements::with_axis(-1.0, 0.5).state(1.0).map(|_| ()),
            "distance of the pericentre",
            "it is -0.5\nhelp: the semi-major axis of an ellipse is positive",
        ),
        (
            Elements::with_axis(2.0, 1.5).state(1.0).map(|_| ()),
            "distance of the pericentre",
            "it is -1\nhelp: the semi-major axis of a hyperbola is negative",
        ),
        (
            Elements::with_axis(2.0, 1.0).state(1.0).map(|_| ()),
            "distance of the pericentre",
            "write `Elements::with_pericentre(distance, 1.0)`",
        ),
        (but(|orbit| orbit.pericentre = f64::NAN), "distance of the pericentre", "but it is NaN"),
        (
            but(|orbit| orbit.inclination = 23.4),
            "the inclination",
            "between 0 and π, but it is 23.4\nhelp: angles are in radians",
        ),
        (but(|orbit| orbit.inclination = -0.1), "the inclination", "it is -0.1"),
        (but(|orbit| orbit.node = f64::NAN), "the longitude of the node has to be finite", "it is NaN"),
        (but(|orbit| orbit.argument = f64::INFINITY), "the argument of the pericentre has to be finite", "it is inf"),
        (but(|orbit| orbit.anomaly = Anomaly::Mean(f64::NAN)), "the mean anomaly has to be finite", "it is NaN"),
        (
            but(|orbit| orbit.anomaly = Anomaly::SincePericentre(f64::NEG_INFINITY)),
            "the time since the pericentre",
            "-inf",
        ),
        (
            Elements { anomaly: Anomaly::True(2.5), ..Elements::with_pericentre(1.0, 2.0) }.state(1.0).map(|_| ()),
            "eccentricity 2 does not reach the true anomaly 2.5",
            "between -2.094395102393195",
        ),
        (
            Elements::from_state([f64::NAN, 0.0, 0.0], [0.0; 3], 1.0).map(|_| ()),
            "position[0] has to be finite",
            "it is NaN",
        ),
        (Elements::from_state([1.0, 2.0, 3.0], [-2.0, -4.0, -6.0], 1.0).map(|_| ()), "a straight line", "has no plane"),
        (system(&[1.0, 0.0], &[valid]), "the mass of body 1", "it is 0\nhelp: give a test particle a tiny mass"),
        (
            system(&[1.0, 0.1], &[]),
            "2 masses require 1 orbits, but there are 0",
            "the first mass is that of the centre",
        ),
        (system(&[1.0, 0.1, 0.1], &[valid, valid]), "the state has 2 bodies, but there are 3 masses", ""),
        (
            orbit::state::<[[f64; 2]; 2]>(Frame::Jacobi, 1.0, &[1.0, 0.1], &[inclined]).map(|_| ()),
            "body 1: an orbit with the inclination 0.1",
            "3 components",
        ),
        (
            orbit::elements(Frame::Jacobi, 1.0, &[1.0, 0.1], &at_rest).map(|_| ()),
            "body 1: the orbit is a straight line",
            "",
        ),
    ];
    for (outcome, wrong, instead) in table {
        let message = outcome.expect_err(wrong).to_string();
        assert!(message.contains(wrong) && message.contains(instead), "{message}");
    }
    let flat = orbit::state::<Vec<f64>>(Frame::Jacobi, 1.0, &[1.0, 0.1], &[valid]).expect_err("flat").to_string();
    assert!(flat.contains("these have 1\nhelp: write `[[f64; 3]; N]`"), "{flat}");
}

/// A hyperbola is reached up to its asymptote, a parabola up to the opposite direction, an ellipse everywhere.
#[test]
fn true_anomalies_have_the_limits_of_the_conic() {
    let at = |eccentricity, anomaly| {
        let orbit = Elements { anomaly: Anomaly::True(anomaly), ..Elements::with_pericentre(1.0, eccentricity) };
        orbit.state(1.0).is_ok()
    };
    assert!(at(0.999, PI) && at(0.0, 100.0) && at(1.0, 3.1) && !at(1.0, PI) && at(1.0, 3.1 - 4.0 * PI));
    let limit = (-1.0 / 1.5_f64).acos();
    assert!(at(1.5, limit * 0.999) && !at(1.5, limit * 1.001) && !at(1.5, -PI) && at(1.5, 2.0 * PI - 1.0));
}

/// Numbers of all magnitudes, and such that are none: a state, or an error.
#[test]
fn no_number_panics() {
    let numbers = [
        0.0,
        -0.0,
        5e-324,
        1e-300,
        1e-160,
        1e-8,
        1.0,
        -1.0,
        2.5,
        1e8,
        1e160,
        1e300,
        f64::MAX,
        f64::NAN,
        f64::INFINITY,
        -f64::INFINITY,
    ];
    let mut random = fastrand::Rng::with_seed(3);
    let (mut states, mut errors) = (0, 0);
    for _ in 0..20_000 {
        let mut number = || numbers[random.usize(..numbers.len())];
        let anomaly = [Anomaly::True(number()), Anomaly::Mean(number()), Anomaly::SincePericentre(number())];
        let mut orbit =
            Elements { node: number(), argument: number(), ..Elements::with_pericentre(number(), number()) };
        let (parameter, position) = (number(), [number(), number(), number()]);
        let velocity = [number(), number(), number()];
        orbit.anomaly = anomaly[random.usize(..3)];
        match orbit.state(parameter) {
            Ok(state) => {
                assert!(state.as_flattened().iter().all(|number| number.is_finite()), "{orbit:?}");
                states += 1;
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                errors += 1;
            }
        }
        let _ = [orbit.true_anomaly(parameter), orbit.mean_anomaly(parameter), orbit.since_pericentre(parameter)];
        let _ = [orbit.axis(), orbit.period(parameter)];
        if let Ok(found) = Elements::from_state(position, velocity, parameter) {
            assert!(found.pericentre > 0.0 && found.mean_anomaly(parameter).is_ok_and(f64::is_finite), "{found:?}");
        }
    }
    assert!(states > 100 && errors > 1000, "{states} {errors}");
}
