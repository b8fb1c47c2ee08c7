//! Elements of the bodies of a system with masses, and its state.

use super::{elements::Elements, error::OrbitError};
use crate::state::{coords::Coords, phase::Phase};
use alloc::{boxed::Box, vec, vec::Vec};
use core::{array, f64::consts::PI};

/// The centre to which the elements of each body of a system refer.
///
/// The first mass is that of the central body, which has no elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The central body. The gravitational parameter of body `i` is `G (m₀ + mᵢ)`.
    Heliocentric,
    /// The barycentre of all earlier bodies of the list, as in `coordinates = jacobi(..)`. The gravitational parameter of body `i` is
    /// `G (m₀ + ... + mᵢ)`.
    Jacobi,
}

/// A position and a velocity.
type Moving = [f64; 6];

/// Returns the state of a system of bodies: positions, and momenta `m v`, relative to its barycentre at rest.
///
/// `masses` begins with the mass of the central body, which has no orbit; `orbits[i]` belongs to `masses[i + 1]`. Coordinates have the
/// shape that your Hamiltonian has: `[[f64; 3]; N]` or `Vec<[f64; 3]>`; for orbits in a plane also `[[f64; 2]; N]` or `Vec<[f64; 2]>`.
///
/// # Errors
/// - [`OrbitError::Mass`]: a mass is not positive and finite.
/// - [`OrbitError::Orbits`], [`OrbitError::Bodies`], [`OrbitError::Shape`]: the numbers of masses, orbits and coordinates do not fit.
/// - [`OrbitError::Body`]: an orbit has no state, or is not in the plane of two components.
pub fn state<C: Coords<Leaf = f64>>(
    frame: Frame,
    gravity: f64,
    masses: &[f64],
    orbits: &[Elements],
) -> Result<Phase<C>, OrbitError> {
    let dimensions = dimensions::<C>(masses)?;
    if orbits.len() + 1 != masses.len() {
        return Err(OrbitError::Orbits { masses: masses.len(), orbits: orbits.len() });
    }
    let inner = inner_masses(frame, masses);
    let whole: f64 = masses.iter().sum();
    let mut bodies: Vec<Moving> = vec![[0.0; 6]; masses.len()];
    // What the outer bodies shift the inner ones by, so that the barycentre is the origin.
    let mut shift = [0.0; 6];
    for (index, orbit) in orbits.iter().enumerate().rev() {
        let (body, inclination) = (index + 1, orbit.inclination);
        if dimensions == 2 && inclination != 0.0 && inclination != PI {
            return Err(of(body, OrbitError::Plane { inclination }));
        }
        let total = inner[index] + masses[body];
        let relative = orbit.state(gravity * total).map_err(|error| of(body, error))?;
        // In Jacobi coordinates a body and its centre move about their barycentre, which is the centre of the next body.
        let [kept, moved] = match frame {
            Frame::Heliocentric => [1.0, masses[body] / whole],
            Frame::Jacobi => [inner[index] / total, masses[body] / total],
        };
        let before = shift;
        for (d, x) in relative.as_flattened().iter().enumerate() {
            shift[d] -= moved * x;
            bodies[body][d] = kept * x + if frame == Frame::Jacobi { before[d] } else { 0.0 };
        }
    }
    for (body, moving) in bodies.iter_mut().enumerate() {
        if body == 0 || frame == Frame::Heliocentric {
            *moving = array::from_fn(|d| moving[d] + shift[d]);
        }
    }
    let flat = |first: usize, momenta: bool| {
        let factors = masses.iter().map(|mass| if momenta { *mass } else { 1.0 });
        let numbers = bodies.iter().zip(factors);
        let numbers = numbers.flat_map(|(moving, factor)| (first..first + dimensions).map(move |d| moving[d] * factor));
        C::from_flat(numbers.collect())
    };
    match (flat(0, false), flat(3, true)) {
        (Some(q), Some(p)) => Ok(Phase { q, p }),
        _ => Err(OrbitError::Bodies { masses: masses.len(), bodies: C::LENGTH.unwrap_or_default() }),
    }
}

/// Returns the osculating elements of all bodies but the first, which is the central one. They do not depend on the motion of the
/// barycentre.
///
/// # Errors
/// - [`OrbitError::Mass`]: a mass is not positive and finite.
/// - [`OrbitError::Bodies`], [`OrbitError::Shape`]: the numbers of masses and coordinates do not fit.
/// - [`OrbitError::Body`]: the state of a body has no elements.
pub fn elements<C: Coords<Leaf = f64>>(
    frame: Frame,
    gravity: f64,
    masses: &[f64],
    state: &Phase<C>,
) -> Result<Vec<Elements>, OrbitError> {
    let dimensions = dimensions::<C>(masses)?;
    for half in [&state.q, &state.p] {
        if half.length() != masses.len() {
            return Err(OrbitError::Bodies { masses: masses.len(), bodies: half.length() });
        }
    }
    let moving = |body: usize| -> Moving {
        array::from_fn(|d| match (d % 3 < dimensions, body * dimensions + d % 3) {
            (false, _) => 0.0,
            (true, at) if d < 3 => state.q.flat()[at],
            (true, at) => state.p.flat()[at] / masses[body],
        })
    };
    let inner = inner_masses(frame, masses);
    let mut centre = moving(0);
    let mut found = Vec::with_capacity(inner.len());
    for body in 1..masses.len() {
        let (mass, body_moving) = (inner[body - 1], moving(body));
        let total = mass + masses[body];
        let relative: Moving = array::from_fn(|d| body_moving[d] - centre[d]);
        let [x, y, z, u, v, w] = relative;
        found.push(Elements::from_state([x, y, z], [u, v, w], gravity * total).map_err(|error| of(body, error))?);
        if frame == Frame::Jacobi {
            centre = array::from_fn(|d| centre[d] + masses[body] / total * relative[d]);
        }
    }
    Ok(found)
}

/// The mass of the centre of each body but the first.
fn inner_masses(frame: Frame, masses: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let inner = masses.iter().map(|mass| {
        sum += mass;
        if frame == Frame::Jacobi { sum } else { masses[0] }
    });
    inner.take(masses.len().saturating_sub(1)).collect()
}

/// The number of dimensions of coordinates, if the masses are usable.
fn dimensions<C: Coords>(masses: &[f64]) -> Result<usize, OrbitError> {
    if let Some(body) = masses.iter().position(|mass| !(mass.is_finite() && *mass > 0.0)) {
        return Err(OrbitError::Mass { body, mass: masses[body] });
    }
    match (C::ROWS, C::COMPONENTS) {
        (None, components @ (2 | 3)) => Ok(components),
        (_, components) => Err(OrbitError::Shape { components }),
    }
}

fn of(body: usize, error: OrbitError) -> OrbitError {
    OrbitError::Body { body, error: Box::new(error) }
}
