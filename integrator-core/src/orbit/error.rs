//! Errors of elements, and of states that have none.

use crate::error::{Number, debug_as_display};
use alloc::boxed::Box;

debug_as_display!(OrbitError);

/// The reason why elements have no state, or a state has no elements.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OrbitError {
    /// The gravitational parameter is not positive, or not finite.
    #[error(
        "the gravitational parameter has to be positive and finite, but it is {parameter}\nhelp: it is the gravitational \
         constant times the sum of the masses of the centre and of the body",
        parameter = Number(*parameter)
    )]
    Parameter {
        /// The gravitational parameter.
        parameter: f64,
    },
    /// The eccentricity is negative or not finite.
    #[error(
        "the eccentricity has to be finite and at least 0, but it is {eccentricity}\nhelp: 0 is a circle, less than 1 an \
         ellipse, 1 a parabola, more than 1 a hyperbola",
        eccentricity = Number(*eccentricity)
    )]
    Eccentricity {
        /// The eccentricity.
        eccentricity: f64,
    },
    /// The distance of the pericentre is not positive, or not finite.
    #[error(
        "the distance of the pericentre has to be positive and finite, but it is {pericentre}{}",
        of_axis(*pericentre, *eccentricity),
        pericentre = Number(*pericentre)
    )]
    Pericentre {
        /// The distance of the pericentre, `a (1 - e)`.
        pericentre: f64,
        /// The eccentricity.
        eccentricity: f64,
    },
    /// The inclination is not between 0 and π.
    #[error(
        "the inclination has to be between 0 and π, but it is {inclination}\nhelp: angles are in radians: convert degrees by \
         `to_radians()`\nnote: inclinations above π/2 are those of retrograde orbits",
        inclination = Number(*inclination)
    )]
    Inclination {
        /// The inclination.
        inclination: f64,
    },
    /// Another angle, or the time since the pericentre, is not finite.
    #[error("the {element} has to be finite, but it is {value}", value = Number(*value))]
    Element {
        /// The name of the element.
        element: &'static str,
        /// The value of the element.
        value: f64,
    },
    /// A body on a parabola or a hyperbola does not reach the true anomaly.
    #[error(
        "a body with the eccentricity {eccentricity} does not reach the true anomaly {anomaly}\nhelp: the true anomaly has to be \
         between -{limit} and {limit}, the directions of the asymptotes; write `Anomaly::SincePericentre` for a time instead",
        eccentricity = Number(*eccentricity), anomaly = Number(*anomaly), limit = Number(*limit)
    )]
    Asymptote {
        /// The true anomaly, between -π and π.
        anomaly: f64,
        /// The eccentricity.
        eccentricity: f64,
        /// The true anomaly of the asymptote, `acos(-1 / e)`.
        limit: f64,
    },
    /// A component of the position or of the velocity is not finite.
    #[error("{vector}[{axis}] has to be finite, but it is {value}", value = Number(*value))]
    State {
        /// `position` or `velocity`.
        vector: &'static str,
        /// The index of the component.
        axis: usize,
        /// The value of the component.
        value: f64,
    },
    /// The body is at its centre, or moves on a straight line through it, up to rounding.
    #[error(
        "the orbit is a straight line through the centre: position and velocity are parallel, or one of them is zero\nnote: such \
         an orbit has no plane, and its pericentre is the centre itself"
    )]
    Radial,
    /// A result is too large or too small for `f64`, or Kepler's equation could not be solved.
    #[error(
        "the orbit is beyond the range of `f64`\nhelp: choose units in which the distance, the time and the gravitational \
         parameter are closer to 1"
    )]
    Range,
    /// A mass is not positive, or not finite.
    #[error(
        "the mass of body {body} has to be positive and finite, but it is {mass}\nhelp: give a test particle a tiny mass, such as \
         `2f64.powi(-100)`, because its momentum is the mass times the velocity",
        mass = Number(*mass)
    )]
    Mass {
        /// The index of the body, from 0.
        body: usize,
        /// The mass of the body.
        mass: f64,
    },
    /// The numbers of masses and orbits do not fit.
    #[error(
        "{masses} masses require {} orbits, but there are {orbits}\nnote: the first mass is that of the centre, which has no orbit",
        masses.saturating_sub(1)
    )]
    Orbits {
        /// The number of masses.
        masses: usize,
        /// The number of orbits.
        orbits: usize,
    },
    /// The state has another number of bodies than there are masses.
    #[error("the state has {bodies} bodies, but there are {masses} masses")]
    Bodies {
        /// The number of masses.
        masses: usize,
        /// The number of bodies of the state.
        bodies: usize,
    },
    /// The coordinates of the state are not those of bodies in space or in a plane.
    #[error(
        "orbits require coordinates with 3 components for each body, or 2 in a plane, but these have {components}\nhelp: write \
         `[[f64; 3]; N]` or `Vec<[f64; 3]>`"
    )]
    Shape {
        /// The number of components of a point.
        components: usize,
    },
    /// Coordinates with two components have no room for an inclined orbit.
    #[error(
        "an orbit with the inclination {inclination} is not in the plane of coordinates with 2 components\nhelp: write the \
         inclination 0 or π, or use coordinates with 3 components",
        inclination = Number(*inclination)
    )]
    Plane {
        /// The inclination.
        inclination: f64,
    },
    /// The error of one body of a system.
    #[error("body {body}: {error}")]
    Body {
        /// The index of the body, from 0, which is the centre.
        body: usize,
        /// The error of its orbit.
        error: Box<OrbitError>,
    },
}

/// What to write for the semi-major axis, from which a wrong distance of the pericentre usually comes.
fn of_axis(pericentre: f64, eccentricity: f64) -> &'static str {
    if eccentricity == 1.0 {
        "\nhelp: a parabola has no semi-major axis: write `Elements::with_pericentre(distance, 1.0)`"
    } else if pericentre < 0.0 && eccentricity > 1.0 {
        "\nhelp: the semi-major axis of a hyperbola is negative, so that `a (1 - e)` is positive"
    } else if pericentre < 0.0 {
        "\nhelp: the semi-major axis of an ellipse is positive"
    } else {
        ""
    }
}
