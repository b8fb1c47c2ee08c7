//! Orbits of textbooks, to the digits that are printed there.

use crate::{apart, in_degrees};
use integrator_core::orbit::{Anomaly, Elements, OrbitError};

/// Vallado, Fundamentals of Astrodynamics and Applications (2013), example 2-5: an ellipse, in kilometres and seconds.
#[test]
fn an_ellipse() -> Result<(), OrbitError> {
    let earth = 398_600.441_8;
    let (position, velocity) = ([6524.834, 6862.875, 6448.296], [4.901_327, 5.533_756, -1.976_341]);
    let found = Elements::from_state(position, velocity, earth)?;
    assert!((found.axis() - 36_127.343).abs() < 5e-2, "{found:?}");
    assert!((found.eccentricity - 0.832_853).abs() < 1e-6, "{found:?}");
    let angles = [found.inclination, found.node, found.argument, found.true_anomaly(earth)?];
    for (angle, published) in angles.into_iter().zip([87.870, 227.898, 53.38, 92.335]) {
        assert!((angle.to_degrees().rem_euclid(360.0) - published).abs() < 6e-3, "{found:?}, {published}");
    }
    Ok(())
}

/// Curtis, Orbital Mechanics for Engineering Students (2014), example 4.3: an ellipse.
#[test]
fn a_retrograde_ellipse() -> Result<(), OrbitError> {
    let earth = 398_600.0;
    let found = Elements::from_state([-6045.0, -3490.0, 2500.0], [-3.457, 6.618, 2.533], earth)?;
    assert!((found.eccentricity - 0.1712).abs() < 1e-4 && (found.axis() - 8788.0).abs() < 1.0, "{found:?}");
    let angles = [found.inclination, found.node, found.argument, found.true_anomaly(earth)?];
    for (angle, published) in angles.into_iter().zip([153.2, 255.3, 20.07, 28.45]) {
        assert!((angle.to_degrees().rem_euclid(360.0) - published).abs() < 0.06, "{found:?}, {published}");
    }
    Ok(())
}

/// The same book, example 4.7: a hyperbola with the angular momentum 80,000 km²/s.
#[test]
fn a_hyperbola() -> Result<(), OrbitError> {
    let (earth, e) = (398_600.0, 1.4);
    let orbit = Elements::with_pericentre(80_000.0_f64.powi(2) / earth / (1.0 + e), e);
    let orbit = Elements { anomaly: Anomaly::True(30_f64.to_radians()), ..in_degrees(orbit, [30.0, 40.0, 60.0]) };
    let [position, velocity] = orbit.state(earth)?;
    assert!(apart(position, [-4040.0, 4815.0, 3629.0]) < 1.0, "{position:?}");
    assert!(apart(velocity, [-10.39, -4.772, 1.744]) < 6e-3, "{velocity:?}");
    Ok(())
}

/// Escape and circular speed, from the energy alone.
#[test]
fn speeds_at_the_pericentre() -> Result<(), OrbitError> {
    for (e, speed) in [(0.0, 1.0), (1.0, 2_f64.sqrt()), (3.0, 2.0)] {
        let [position, velocity] = Elements::with_pericentre(4.0, e).state(4.0)?;
        assert_eq!(position, [4.0, 0.0, 0.0]);
        assert!(apart(velocity, [0.0, speed, 0.0]) < 4.0 * f64::EPSILON, "{velocity:?}");
    }
    Ok(())
}
