//! The elements of the orbit that a state is on.

use super::{
    elements::{Anomaly, Elements, universal, within_half},
    error::OrbitError,
};
use crate::flow::kepler::{fall::difference_of_products, pericentre::time_at};
#[cfg(not(feature = "std"))]
use crate::scalar::elementary::Elementary;
use core::array;

impl Elements {
    /// Returns the osculating elements of a body with this position and velocity relative to the centre. The anomaly is the mean
    /// anomaly. [Conventions](Elements#conventions) choose the angles that are undefined.
    ///
    /// # Errors
    /// - [`OrbitError::Parameter`]: the gravitational parameter is not positive and finite.
    /// - [`OrbitError::State`]: a component is not finite.
    /// - [`OrbitError::Radial`]: the body is at the centre, or moves on a straight line through it.
    /// - [`OrbitError::Range`]: an element is not finite.
    pub fn from_state(position: [f64; 3], velocity: [f64; 3], parameter: f64) -> Result<Self, OrbitError> {
        if !(parameter.is_finite() && parameter > 0.0) {
            return Err(OrbitError::Parameter { parameter });
        }
        for (vector, numbers) in [("position", position), ("velocity", velocity)] {
            if let Some(axis) = numbers.iter().position(|number| !number.is_finite()) {
                return Err(OrbitError::State { vector, axis, value: numbers[axis] });
            }
        }
        // Units in which the distance and the gravitational parameter are 1.
        let distance = length(position);
        let speed = (parameter / distance).sqrt();
        let (direction, velocity) = (position.map(|x| x / distance), velocity.map(|v| v / speed));
        let momentum = cross(direction, velocity);
        let turning = length(momentum);
        let latus = turning * turning;
        // The smallest angle between position and velocity that is more than a rounding of their components.
        let is_turning = distance > 0.0 && latus > 0.0 && turning > f64::EPSILON * length(velocity);
        if !is_turning {
            return Err(OrbitError::Radial);
        }
        let [hx, hy, hz] = momentum;
        let out_of_plane = hx.hypot(hy);
        let [cos_n, sin_n] = if out_of_plane > 0.0 { [-hy / out_of_plane, hx / out_of_plane] } else { [1.0, 0.0] };
        let (sin_i, cos_i) = (out_of_plane / turning, hz / turning);
        // The angle from the ascending node to the body.
        let latitude =
            dot(direction, [-cos_i * sin_n, cos_i * cos_n, sin_i]).atan2(dot(direction, [cos_n, sin_n, 0.0]));
        let radial = dot(direction, velocity);
        let [along, across] = [latus - 1.0, radial * turning];
        let eccentricity = along.hypot(across);
        let (argument, anomaly) = if eccentricity > 0.0 {
            let anomaly = across.atan2(along);
            (within_half(latitude - anomaly), anomaly)
        } else {
            (0.0, latitude)
        };
        let pericentre = latus / (1.0 + eccentricity);
        // Units in which the distance of the pericentre is 1. Near an asymptote the true anomaly is a poor variable, and on an almost
        // circular ellipse the radial velocity is.
        let radial = radial / pericentre.sqrt();
        let s = if eccentricity < 1.0 {
            universal(eccentricity, anomaly)
        } else if eccentricity > 1.0 {
            let root = (eccentricity - 1.0).sqrt();
            (root * radial / eccentricity).asinh() / root
        } else {
            radial
        };
        let elements = Self {
            pericentre: pericentre * distance,
            eccentricity,
            inclination: out_of_plane.atan2(hz),
            node: sin_n.atan2(cos_n),
            argument,
            anomaly: Anomaly::Mean(
                time_at(eccentricity, s) * Self::with_pericentre(1.0, eccentricity).mean_motion_at_unity(),
            ),
        };
        elements.checked(parameter).map_or(Err(OrbitError::Range), |_| Ok(elements))
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product, accurate also if the vectors are almost parallel: the plane of the orbit contains both.
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    array::from_fn(|d| {
        let [i, j] = [(d + 1) % 3, (d + 2) % 3];
        difference_of_products([a[i], b[j], a[j], b[i]])
    })
}

/// The length of a vector, also of one whose square overflows.
fn length([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}
