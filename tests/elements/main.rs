//! Orbital elements: the states of all conics by 70-digit arithmetic, and back; systems of bodies; published orbits; errors.

mod bodies;
mod conics;
mod messages;
mod published;

use integrator_core::orbit::Elements;

/// The distance between two vectors.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(std::array::from_fn(|d| a[d] - b[d]))
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Elements with angles and an anomaly in degrees.
fn in_degrees(orbit: Elements, [inclination, node, argument]: [f64; 3]) -> Elements {
    let [inclination, node, argument] = [inclination, node, argument].map(f64::to_radians);
    Elements { inclination, node, argument, ..orbit }
}
