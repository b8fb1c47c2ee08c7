//! Jacobi coordinates: each body relative to the centre of mass of those before it, and first of all the centre of mass
//! of all.
//!
//! With the masses `m`, their sums `eta` and the shares `mu[i] = m[i] / eta[i]`: `Q[i] = q[i] - X[i - 1]`, where `X[i]` is
//! the centre of mass up to body `i`, and `P[i] = p[i] - mu[i] (p[0] + ... + p[i])`. Always true: the map is linear and
//! canonical whatever the shares are, hence for rounded ones too.
//!
//! The first of these bodies is the one that leads, wherever the user's order has it: a light body with the momentum `p[0]` in
//! front of a heavy one would have `P[1] = p[1] - mu[1] (p[0] + p[1])`, of which nothing but rounding errors are left.

use crate::{
    error::Error,
    scalar::{double_double::DoubleDouble, real::Real},
};
use alloc::vec::Vec;

/// Masses and attractions of the bodies, from which Jacobi coordinates follow. `#[hamiltonian]` implements it.
pub trait JacobiConstants {
    /// The number of the body that leads.
    fn leading_body(&self) -> usize;
    /// The mass of a body, and the strength `k` of the attraction `-k / |Q|` to those before it and to the one that leads.
    fn mass_and_attraction(&self, body: usize) -> [f64; 2];
    /// Returns the factor by which `kinetic` multiplies the momentum of a body, for its velocity.
    fn inverse_mass(&self, body: usize) -> f64;
}

/// The number of the body that leads: the heaviest one, if it outweighs all bodies before it together, else the first.
#[must_use]
pub fn leading_body(masses: &[f64], bodies: usize) -> usize {
    let masses = &masses[..bodies.min(masses.len())];
    let mut heaviest = 0;
    for (body, mass) in masses.iter().enumerate() {
        if *mass > masses[heaviest] {
            heaviest = body;
        }
    }
    if heaviest > 0 && masses[heaviest] > masses[..heaviest].iter().sum() { heaviest } else { 0 }
}

/// One more than the number of the leading body, for a body that comes before it in the user's order; for others, that number:
/// where a loop ends that begins with it.
#[must_use]
pub fn end_of_leader(masses: &[f64], bodies: usize, body: usize) -> usize {
    let leading = leading_body(masses, bodies);
    if body < leading { leading + 1 } else { leading }
}

/// The body at a place, where the one that leads is first and all others are in the user's order.
#[inline]
#[must_use]
pub fn body_at(leading: usize, place: usize) -> usize {
    match place {
        0 => leading,
        _ if place <= leading => place - 1,
        _ => place,
    }
}

/// Whether bodies with these masses have Jacobi coordinates.
///
/// # Errors
/// [`Error::FewMasses`], [`Error::Mass`]
pub fn are_masses(masses: &[f64], bodies: usize) -> Result<(), Error> {
    if masses.len() < bodies {
        return Err(Error::FewMasses { masses: masses.len(), bodies });
    }
    for (body, &mass) in masses[..bodies].iter().enumerate() {
        let reason = match mass {
            _ if !mass.is_finite() => "it has to be finite",
            0.0 => {
                "Jacobi coordinates require the velocity p / m\nhelp: give a test particle a mass that moves no other \
                 body, such as `2f64.powi(-100)`, and the momentum for this mass"
            }
            _ if mass < 0.0 => "a centre of mass requires positive masses",
            _ => continue,
        };
        return Err(Error::Mass { body, mass, reason });
    }
    Ok(())
}

/// The roundings between a mass and its inverse in `kinetic`, in half units of the last place: those of a few factors,
/// and as many where the user divided beforehand.
const ROUNDINGS: f64 = 16.0;

/// Whether the masses of the coordinates are those of `kinetic`: else these coordinates couple the momenta of bodies.
///
/// # Errors
/// [`Error::Mass`]
pub fn are_masses_of_kinetic(constants: &dyn JacobiConstants, bodies: usize) -> Result<(), Error> {
    for body in 0..bodies {
        let [mass, _] = constants.mass_and_attraction(body);
        let one = mass * constants.inverse_mass(body);
        let agrees = Real::abs(one - 1.0) <= ROUNDINGS * 0.5 * f64::EPSILON;
        if !agrees {
            return Err(Error::Mass { body, mass, reason: "`kinetic` has another mass for this body" });
        }
    }
    Ok(())
}

/// The part of a body in Jacobi coordinates.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    /// The share of the body in the masses up to it; none for the first body, whose coordinates are those of the centre
    /// of mass.
    pub(crate) share: f64,
    /// The inverse of its reduced mass; for the first body, of the mass of all.
    pub(crate) inverse_mass: f64,
    /// The strength of its attraction to the bodies before it.
    pub(crate) attraction: f64,
}

/// The parts of this number of bodies, the leading one first.
pub(crate) fn parts(constants: &dyn JacobiConstants, bodies: usize) -> Vec<Part> {
    let (mut parts, mut sum) = (Vec::with_capacity(bodies), 0.0);
    for body in 0..bodies {
        let body = body_at(constants.leading_body(), body);
        let ([mass, attraction], before) = (constants.mass_and_attraction(body), sum);
        sum += mass;
        parts.push(Part { share: mass / sum, inverse_mass: sum / (mass * before), attraction });
    }
    if let Some(first) = parts.first_mut() {
        *first = Part { share: 0.0, inverse_mass: 1.0 / sum, attraction: 0.0 };
    }
    parts
}

/// The share of each body in the masses up to it.
pub(crate) fn shares(parts: &[Part]) -> Vec<f64> {
    parts.iter().map(|part| part.share).collect()
}

/// The map of the coordinates and momenta of bodies with these shares.
pub(crate) type Map<R, const D: usize> = fn(&[f64], &mut [[R; D]], &mut [[R; D]]);

/// Makes Jacobi coordinates of inertial ones.
pub(crate) fn to_jacobi<R: Real, const D: usize>(shares: &[f64], q: &mut [[R; D]], p: &mut [[R; D]]) {
    let (&[mut centre, ..], &[mut total, ..]) = (&*q, &*p) else { return };
    for body in 1..shares.len() {
        let share = R::of(shares[body]);
        for d in 0..D {
            q[body][d] -= centre[d];
            centre[d] = share.fma(q[body][d], centre[d]);
            total[d] += p[body][d];
            p[body][d] = (-share).fma(total[d], p[body][d]);
        }
    }
    (q[0], p[0]) = (centre, total);
}

/// Makes inertial coordinates of Jacobi ones: the inverse of [`to_jacobi`].
pub(crate) fn to_inertial<R: Real, const D: usize>(shares: &[f64], q: &mut [[R; D]], p: &mut [[R; D]]) {
    let (&[mut centre, ..], &[mut total, ..]) = (&*q, &*p) else { return };
    for body in (1..shares.len()).rev() {
        let share = R::of(shares[body]);
        for d in 0..D {
            centre[d] = (-share).fma(q[body][d], centre[d]);
            q[body][d] += centre[d];
            p[body][d] = share.fma(total[d], p[body][d]);
            total[d] -= p[body][d];
        }
    }
    (q[0], p[0]) = (centre, total);
}

/// The numbers of a state with twice the digits, in two parts each: positions and momenta of all bodies, in the user's order
/// or in that of rows.
pub(crate) type Digits = [Vec<[f64; 2]>; 2];

/// Makes Jacobi coordinates of a state's inertial ones, and sorts bodies into the order of rows.
pub(crate) fn digits_to_jacobi(parts: &[Part], leading: usize, dimensions: usize, state: &mut Digits) {
    for half in &mut *state {
        if let Some(moved) = half.get_mut(..(leading + 1) * dimensions) {
            moved.rotate_right(dimensions);
        }
    }
    map_digits(&shares(parts), dimensions, to_jacobi, state);
}

/// Makes inertial coordinates of a state's Jacobi ones, and sorts bodies into the user's order.
pub(crate) fn digits_to_inertial(shares: &[f64], leading: usize, dimensions: usize, state: &mut Digits) {
    map_digits(shares, dimensions, to_inertial, state);
    for half in state {
        if let Some(moved) = half.get_mut(..(leading + 1) * dimensions) {
            moved.rotate_left(dimensions);
        }
    }
}

/// Maps a state, one coordinate of all bodies after the other, so that this is compiled once for any number of dimensions.
fn map_digits(shares: &[f64], dimensions: usize, map: Map<DoubleDouble, 1>, [q, p]: &mut Digits) {
    for d in 0..dimensions {
        let coordinate = |half: &[[f64; 2]]| -> Vec<_> {
            half.iter().skip(d).step_by(dimensions).map(|parts| [DoubleDouble::state(&|part| parts[part])]).collect()
        };
        let mut mapped = [coordinate(q), coordinate(p)];
        let [of_q, of_p] = &mut mapped;
        map(shares, of_q, of_p);
        for (half, mapped) in [&mut *q, &mut *p].into_iter().zip(&mapped) {
            for (parts, [number]) in half.iter_mut().skip(d).step_by(dimensions).zip(mapped) {
                *parts = [number.lane(0), number.lane(1)];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Powers of two have exact shares, so that maps of small integers do not round.
    const MASSES: [f64; 4] = [1.0, 1.0, 2.0, 4.0];

    struct Masses;

    impl JacobiConstants for Masses {
        fn leading_body(&self) -> usize {
            0
        }
        fn mass_and_attraction(&self, body: usize) -> [f64; 2] {
            [MASSES[body], 3.0]
        }
        fn inverse_mass(&self, body: usize) -> f64 {
            1.0 / MASSES[body]
        }
    }

    fn shares() -> Vec<f64> {
        super::shares(&parts(&Masses, 4))
    }

    fn point(seed: f64) -> [[f64; 2]; 4] {
        core::array::from_fn(|i| core::array::from_fn(|d| (seed * (i * 2 + d + 1) as f64 * 37.0) % 19.0 - 9.0))
    }

    fn dot(a: &[[f64; 2]; 4], b: &[[f64; 2]; 4]) -> f64 {
        a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn the_map_is_that_of_the_definition_and_its_inverse_undoes_it() {
        let (q, p) = (point(1.0), point(3.0));
        let (mut new_q, mut new_p) = (q, p);
        to_jacobi(&shares(), &mut new_q, &mut new_p);
        let centre = |last: usize, d: usize| {
            let sum: f64 = (0..=last).map(|i| MASSES[i] * q[i][d]).sum();
            sum / MASSES[..=last].iter().sum::<f64>()
        };
        for d in 0..2 {
            assert_eq!(new_q[0][d], centre(3, d));
            assert_eq!(new_p[0][d], p.iter().map(|p| p[d]).sum::<f64>());
            for i in 1..4 {
                assert_eq!(new_q[i][d], q[i][d] - centre(i - 1, d));
            }
        }
        to_inertial(&shares(), &mut new_q, &mut new_p);
        assert_eq!((new_q, new_p), (q, p));
    }

    /// A linear map keeps the symplectic form if it keeps the product of any positions with any momenta.
    #[test]
    fn the_map_is_canonical_and_makes_the_kinetic_energy_diagonal() {
        let (q, p) = (point(5.0), point(7.0));
        let (mut new_q, mut new_p) = (q, p);
        to_jacobi(&shares(), &mut new_q, &mut new_p);
        assert_eq!(dot(&new_q, &new_p), dot(&q, &p));
        let kinetic = |p: &[[f64; 2]; 4], inverse: &dyn Fn(usize) -> f64| -> f64 {
            (0..4).map(|i| p[i].iter().map(|p| p * p).sum::<f64>() * inverse(i)).sum()
        };
        let parts = parts(&Masses, 4);
        assert_eq!(kinetic(&new_p, &|i| parts[i].inverse_mass), kinetic(&p, &|i| 1.0 / MASSES[i]));
        // Wrong shares are canonical all the same, and diagonal no more.
        let (mut new_q, mut new_p) = (q, p);
        to_jacobi(&[0.0, 0.25, 0.5, 0.5], &mut new_q, &mut new_p);
        assert_eq!(dot(&new_q, &new_p), dot(&q, &p));
        assert_ne!(kinetic(&new_p, &|i| parts[i].inverse_mass), kinetic(&p, &|i| 1.0 / MASSES[i]));
    }

    #[test]
    fn the_body_that_outweighs_those_before_it_leads() {
        let leading = |masses: &[f64]| leading_body(masses, masses.len());
        assert_eq!(leading(&[]), 0);
        assert_eq!(leading(&[1.0, 1e-3, 1.0]), 0);
        assert_eq!(leading(&[1e-3, 1.0, 0.5]), 1);
        assert_eq!(leading(&[1e-3, 0.5, 1.0]), 2);
        // Two stars about each other and a third one that is heavier than either, but not than both.
        assert_eq!(leading(&[1.0, 1.0, 1.5]), 0);
        assert_eq!(leading(&[1e-3, f64::NAN]), 0);
        // Masses of bodies that are not there.
        assert_eq!(leading_body(&[1e-3, 1.0], 1), 0);
        for leading in 0..4 {
            let mut places: Vec<_> = (0..4).collect();
            places[..=leading].rotate_right(1);
            assert_eq!((0..4).map(|place| body_at(leading, place)).collect::<Vec<_>>(), places);
        }
        assert_eq!([0, 1, 2].map(|body| end_of_leader(&[1e-3, 1.0, 1e-3], 3, body)), [2, 1, 1]);
    }

    #[test]
    fn masses_are_checked_against_bodies_and_kinetic_energy() {
        assert_eq!(are_masses(&MASSES, 4), Ok(()));
        assert_eq!(are_masses(&MASSES, 3), Ok(()));
        assert_eq!(are_masses(&MASSES, 5), Err(Error::FewMasses { masses: 4, bodies: 5 }));
        let body = |masses: &[f64]| match are_masses(masses, masses.len()) {
            Err(Error::Mass { body, .. }) => Some(body),
            _ => None,
        };
        assert_eq!(
            [[0.0, 1.0], [1.0, 0.0], [2.0, -1.0], [-1.0, 2.0], [1.0, f64::NAN]].map(|masses| body(&masses)),
            [0, 1, 1, 0, 1].map(Some)
        );
        assert_eq!(are_masses_of_kinetic(&Masses, 4), Ok(()));
    }
}
