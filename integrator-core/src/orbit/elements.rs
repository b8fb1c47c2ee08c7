//! Elements of one orbit, and the state that they describe.

use super::error::OrbitError;
use crate::flow::kepler::pericentre::{state_since, time_at};
#[cfg(not(feature = "std"))]
use crate::scalar::elementary::Elementary;
use core::f64::consts::{PI, SQRT_2, TAU};

/// The elements of a Kepler orbit around a centre: an ellipse, a parabola or a hyperbola.
///
/// Angles are in radians, the distance has the unit of the positions. Methods that need the strength of the attraction have the
/// argument `parameter`, the gravitational parameter `μ = G (M + m)` of the centre and the body.
///
/// ```
/// use integrator_core::orbit::{Anomaly, Elements};
///
/// // Halley's comet at its perihelion passage of 1986 and 100 days later, in astronomical units and days.
/// let halley = Elements {
///     inclination: 162.26_f64.to_radians(),
///     node: 58.42_f64.to_radians(),
///     argument: 111.33_f64.to_radians(),
///     ..Elements::with_pericentre(0.586, 0.967)
/// };
/// let sun = 2.959122082e-4;
/// let [position, velocity] = Elements { anomaly: Anomaly::SincePericentre(100.0), ..halley }.state(sun)?;
///
/// let found = Elements::from_state(position, velocity, sun)?;
/// assert!((found.eccentricity - 0.967).abs() < 1e-12);
/// assert!((found.period(sun) / 365.25 - 74.8).abs() < 0.1);
/// # Ok::<(), integrator_core::orbit::OrbitError>(())
/// ```
///
/// # Conventions
/// The reference plane is that of the first two axes. Rotations about the third, the first and again the third axis, by
/// `argument`, `inclination` and `node`, turn an orbit with its pericentre on the first axis into its place. [`Elements::from_state`]
/// returns angles between -π and π and sets those to 0 that are undefined:
///
/// - `node`, if the orbit is in the reference plane (inclination 0 or π). `argument` begins at the first axis then.
/// - `argument`, if the orbit is a circle. The anomaly begins at the ascending node then.
///
/// Rounding decides which angles an almost circular orbit, or one almost in the plane, has. The sum of these angles is accurate all
/// the same.
///
/// # Accuracy
/// Results are accurate to some roundings, times the effect that a rounding of the elements or of the state has on them. That effect
/// is large near eccentricity 1: a rounding of the eccentricity changes the semi-major axis by `2^-53 / |1 - e|` of itself.
///
/// Formulas: Murray and Dermott, Solar System Dynamics (1999), section 2.8; Danby, Fundamentals of Celestial Mechanics (1988), chapter
/// 6; universal variables by Battin, An Introduction to the Mathematics and Methods of Astrodynamics (1999), section 4.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elements {
    /// The distance of the pericentre from the centre, `a (1 - e)`.
    pub pericentre: f64,
    /// The eccentricity `e`: 0 of a circle, less than 1 of an ellipse, 1 of a parabola, more than 1 of a hyperbola.
    pub eccentricity: f64,
    /// The inclination `i` to the reference plane, from 0 to π.
    pub inclination: f64,
    /// The longitude `Ω` of the ascending node.
    pub node: f64,
    /// The argument `ω` of the pericentre, from the ascending node. It is `ϖ - Ω` for a longitude `ϖ` of the pericentre.
    pub argument: f64,
    /// The place of the body on its orbit.
    pub anomaly: Anomaly,
}

/// The place of a body on its orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anomaly {
    /// The true anomaly `f`: the angle from the pericentre to the body.
    True(f64),
    /// The mean anomaly `M`, which grows with time at a constant rate: `√(μ / |a|³)` on ellipses and hyperbolas, and `√(μ / 2q³)` on
    /// parabolas with the distance `q` of the pericentre, as in Barker's equation `tan(f/2) + tan³(f/2) / 3 = M`. It is `λ - ϖ` for
    /// a mean longitude `λ`.
    Mean(f64),
    /// The time since the passage of the pericentre: negative before it.
    SincePericentre(f64),
}

impl Elements {
    /// Creates an orbit in the reference plane from the semi-major axis and the eccentricity, with the body and its pericentre on the
    /// first axis. The semi-major axis of a hyperbola is negative. The other elements are fields:
    /// `Elements { inclination: 0.1, ..Elements::with_axis(5.2, 0.048) }`.
    pub fn with_axis(axis: f64, eccentricity: f64) -> Self {
        Self::with_pericentre(axis * (1.0 - eccentricity), eccentricity)
    }

    /// Creates an orbit in the reference plane from the distance of the pericentre and the eccentricity, with the body and its
    /// pericentre on the first axis.
    pub fn with_pericentre(distance: f64, eccentricity: f64) -> Self {
        Self {
            pericentre: distance,
            eccentricity,
            inclination: 0.0,
            node: 0.0,
            argument: 0.0,
            anomaly: Anomaly::Mean(0.0),
        }
    }

    /// Returns the semi-major axis: negative for a hyperbola, infinite for a parabola.
    pub fn axis(&self) -> f64 {
        self.pericentre / (1.0 - self.eccentricity)
    }

    /// Returns the period of an ellipse; infinite for a parabola or a hyperbola.
    pub fn period(&self, parameter: f64) -> f64 {
        if self.eccentricity >= 1.0 {
            return f64::INFINITY;
        }
        TAU / (self.mean_motion_at_unity() * self.rate(parameter))
    }

    /// Returns the true anomaly, between -π and π.
    ///
    /// # Errors
    /// Those of [`Elements::state`].
    pub fn true_anomaly(&self, parameter: f64) -> Result<f64, OrbitError> {
        if let Anomaly::True(anomaly) = self.checked(parameter)? {
            return Ok(anomaly);
        }
        let [x, y, _, _] = self.in_plane(parameter)?;
        Ok(y.atan2(x))
    }

    /// Returns the mean anomaly, between -π and π on an ellipse.
    ///
    /// # Errors
    /// Those of [`Elements::state`].
    pub fn mean_anomaly(&self, parameter: f64) -> Result<f64, OrbitError> {
        Ok(self.reduced_time(parameter)? * self.mean_motion_at_unity())
    }

    /// Returns the time since the nearest passage of the pericentre: negative before it.
    ///
    /// # Errors
    /// Those of [`Elements::state`].
    pub fn since_pericentre(&self, parameter: f64) -> Result<f64, OrbitError> {
        Ok(self.reduced_time(parameter)? / self.rate(parameter))
    }

    /// Returns position and velocity relative to the centre.
    ///
    /// # Errors
    /// - [`OrbitError::Parameter`], [`OrbitError::Eccentricity`], [`OrbitError::Pericentre`], [`OrbitError::Inclination`],
    ///   [`OrbitError::Element`]: a number is not finite or outside its range.
    /// - [`OrbitError::Asymptote`]: a parabola or hyperbola does not reach the true anomaly.
    /// - [`OrbitError::Range`]: the state is not finite.
    pub fn state(&self, parameter: f64) -> Result<[[f64; 3]; 2], OrbitError> {
        let [x, y, u, v] = self.in_plane(parameter)?;
        let [towards, across] = self.axes();
        let speed = self.rate(parameter) * self.pericentre;
        let in_space = |[a, b]: [f64; 2], unit: f64| core::array::from_fn(|d| (a * towards[d] + b * across[d]) * unit);
        let state = [in_space([x, y], self.pericentre), in_space([u, v], speed)];
        if state.as_flattened().iter().all(|number: &f64| number.is_finite()) {
            Ok(state)
        } else {
            Err(OrbitError::Range)
        }
    }

    /// The directions in the plane of the orbit towards the pericentre and a quarter of a revolution further.
    fn axes(&self) -> [[f64; 3]; 2] {
        let [(sin_i, cos_i), (sin_n, cos_n), (sin_w, cos_w)] =
            [self.inclination, self.node, self.argument].map(f64::sin_cos);
        // Those towards the ascending node and a quarter of a revolution further.
        let (node, across) = ([cos_n, sin_n, 0.0], [-cos_i * sin_n, cos_i * cos_n, sin_i]);
        [
            core::array::from_fn(|d| cos_w * node[d] + sin_w * across[d]),
            core::array::from_fn(|d| cos_w * across[d] - sin_w * node[d]),
        ]
    }

    /// Position and velocity in the plane of the orbit, in units in which the distance of the pericentre and the gravitational
    /// parameter are 1.
    fn in_plane(&self, parameter: f64) -> Result<[f64; 4], OrbitError> {
        let e = self.eccentricity;
        let Anomaly::True(anomaly) = self.checked(parameter)? else {
            return state_since(e, self.reduced_time(parameter)?).ok_or(OrbitError::Range);
        };
        let (sine, cosine) = anomaly.sin_cos();
        let half = (0.5 * anomaly).cos();
        // 1 + e cos f and e + cos f, without cancellation opposite of the pericentre of a long ellipse.
        let [nearness, along] = [e, 1.0].map(|factor| 2.0 * factor * half * half);
        let [nearness, along] = [(1.0 - e) + nearness, (e - 1.0) + along];
        let (distance, speed) = ((1.0 + e) / nearness, 1.0 / (1.0 + e).sqrt());
        Ok([distance * cosine, distance * sine, -sine * speed, along * speed])
    }

    /// The time since the nearest pericentre in these units.
    fn reduced_time(&self, parameter: f64) -> Result<f64, OrbitError> {
        let e = self.eccentricity;
        let motion = self.mean_motion_at_unity();
        let time = match self.checked(parameter)? {
            Anomaly::True(anomaly) => time_at(e, universal(e, anomaly)),
            Anomaly::Mean(anomaly) => anomaly / motion,
            Anomaly::SincePericentre(time) => {
                let time = time * self.rate(parameter);
                if e < 1.0 { within_half(time * motion) / motion } else { time }
            }
        };
        if time.is_finite() { Ok(time) } else { Err(OrbitError::Range) }
    }

    /// The mean motion if the distance of the pericentre and the gravitational parameter are 1.
    pub(super) fn mean_motion_at_unity(&self) -> f64 {
        let beta = (1.0 - self.eccentricity).abs();
        if beta == 0.0 { 1.0 / SQRT_2 } else { beta * beta.sqrt() }
    }

    /// One over the unit of time in which the gravitational parameter is 1, if the distance of the pericentre is.
    fn rate(&self, parameter: f64) -> f64 {
        (parameter / self.pericentre).sqrt() / self.pericentre
    }

    /// The anomaly of elements that are valid; on an ellipse and as a true anomaly, between -π and π.
    pub(super) fn checked(&self, parameter: f64) -> Result<Anomaly, OrbitError> {
        let Self { pericentre, eccentricity, inclination, node, argument, anomaly } = *self;
        let is_positive = |number: f64| number.is_finite() && number > 0.0;
        if !is_positive(parameter) {
            return Err(OrbitError::Parameter { parameter });
        }
        if !(eccentricity.is_finite() && eccentricity >= 0.0) {
            return Err(OrbitError::Eccentricity { eccentricity });
        }
        if !is_positive(pericentre) {
            return Err(OrbitError::Pericentre { pericentre, eccentricity });
        }
        if !(0.0..=PI).contains(&inclination) {
            return Err(OrbitError::Inclination { inclination });
        }
        let (name, value) = match anomaly {
            Anomaly::True(value) => ("true anomaly", value),
            Anomaly::Mean(value) => ("mean anomaly", value),
            Anomaly::SincePericentre(value) => ("time since the pericentre", value),
        };
        let others = [("longitude of the node", node), ("argument of the pericentre", argument), (name, value)];
        if let Some((element, value)) = others.into_iter().find(|(_, value)| !value.is_finite()) {
            return Err(OrbitError::Element { element, value });
        }
        let anomaly = match anomaly {
            Anomaly::True(anomaly) => Anomaly::True(within_half(anomaly)),
            Anomaly::Mean(anomaly) if eccentricity < 1.0 => Anomaly::Mean(within_half(anomaly)),
            other => other,
        };
        let limit = if eccentricity < 1.0 { f64::INFINITY } else { (-1.0 / eccentricity).acos() };
        match anomaly {
            Anomaly::True(anomaly) if anomaly.abs() >= limit => {
                Err(OrbitError::Asymptote { anomaly, eccentricity, limit })
            }
            anomaly => Ok(anomaly),
        }
    }
}

/// The universal variable at a true anomaly, in units in which the distance of the pericentre and the gravitational parameter are 1.
pub(super) fn universal(eccentricity: f64, anomaly: f64) -> f64 {
    let (sine, cosine) = (0.5 * anomaly).sin_cos();
    let (beta, opened) = (1.0 - eccentricity, (1.0 + eccentricity).sqrt());
    let root = beta.abs().sqrt();
    if beta > 0.0 {
        2.0 * (root * sine).atan2(opened * cosine) / root
    } else if beta < 0.0 {
        2.0 * (root * sine / (opened * cosine)).atanh() / root
    } else {
        2.0 * sine / (opened * cosine)
    }
}

/// An angle between -π and π.
pub(super) fn within_half(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
