//! The rates of friction of all coordinates, and the widths of their distributions.

use crate::{
    error::Error,
    scalar::elementary::Elementary,
    state::coords::Coords,
    system::{
        System,
        dissipation::{Dissipation, WithFriction},
        motion::Plain,
    },
};
use alloc::vec::Vec;

/// Friction and noise of the coordinates of a system at one time, in the order of `Coords::flat`. Where all are alike, each list
/// has one entry.
pub(super) struct Rates {
    /// The rates.
    rates: Vec<f64>,
    /// The variances of the momenta in equilibrium, `m kT`; nothing without a temperature.
    variances: Vec<f64>,
}

/// The factors of a coordinate for a duration.
#[derive(Clone, Copy)]
pub(super) struct Coordinate {
    /// `exp(-γt) - 1`, by which friction multiplies a momentum for its change.
    pub(super) friction: f64,
    /// `√(m kT (1 - exp(-2γt)))`, the width of the noise.
    pub(super) noise: f64,
}

/// The velocities of momenta.
fn velocities<H: WithFriction>(
    parameters: &H::Parameters<f64>,
    count: usize,
    momentum: &dyn Fn(usize) -> f64,
) -> Vec<f64> {
    read::<H>(parameters, count, momentum, &|motion| H::add_velocities::<f64, f64>(motion, 0.0)).0
}

/// The inverse masses of a system with a temperature, in the order of the coordinates.
pub(super) fn inverse_masses<H: WithFriction>(parameters: &H::Parameters<f64>, count: usize) -> Vec<f64> {
    velocities::<H>(parameters, count, &|_| 1.0)
}

/// Whether a system has a temperature.
const fn has_heat<H: WithFriction>() -> bool {
    matches!(H::DISSIPATION, Dissipation::Heat)
}

/// A momentum for each coordinate, which differs from those of its neighbours.
fn other_momentum(coordinate: usize) -> f64 {
    1.0 + (coordinate % 7) as f64 / 8.0
}

/// The plain motion of a system.
type PlainOf<H> = Plain<f64, <H as System>::Coords, <H as System>::Parameters<f64>>;

/// The positions and the momenta of a motion that begins at the origin with some momenta, after `add`.
fn read<H: WithFriction>(
    parameters: &H::Parameters<f64>,
    count: usize,
    momentum: &dyn Fn(usize) -> f64,
    add: &dyn Fn(&mut PlainOf<H>),
) -> (Vec<f64>, Vec<f64>) {
    let mut motion = Plain {
        q: H::Coords::slots_from::<f64>(count, |_| 0.0),
        p: H::Coords::slots_from::<f64>(count, momentum),
        parameters: parameters.clone(),
    };
    add(&mut motion);
    (H::Coords::slots::<f64>(&motion.q).to_vec(), H::Coords::slots::<f64>(&motion.p).to_vec())
}

impl Rates {
    /// The rates of a system with this number of coordinates.
    pub(super) fn of<H: WithFriction>(parameters: &H::Parameters<f64>, count: usize, time: f64) -> Self {
        let nothing = &|_| 0.0;
        let rates = read::<H>(parameters, count, nothing, &|motion| H::add_rates::<f64, f64>(motion, time)).1;
        if !has_heat::<H>() {
            return Self::alike(rates, Vec::new());
        }
        let add = |motion: &mut _| H::add_temperatures::<f64, f64>(motion, time);
        let mut variances = read::<H>(parameters, count, nothing, &add).1;
        let inverse_masses = inverse_masses::<H>(parameters, count);
        for coordinate in 0..variances.len() {
            variances[coordinate] /= inverse_masses[coordinate];
        }
        Self::alike(rates, variances)
    }

    /// The rates, with one entry where all are alike.
    fn alike(mut rates: Vec<f64>, mut variances: Vec<f64>) -> Self {
        if [&rates, &variances].into_iter().all(|list| list.windows(2).all(|pair| pair[0] == pair[1])) {
            rates.truncate(1);
            variances.truncate(1);
        }
        Self { rates, variances }
    }

    /// The factors of the coordinates for a duration; one, where all are alike.
    pub(super) fn over(&self, duration: f64) -> Vec<Coordinate> {
        let rates = self.rates.iter().enumerate();
        let factors = rates.map(|(coordinate, rate)| {
            let variance = self.variances.get(coordinate).copied().unwrap_or(0.0);
            Coordinate {
                friction: Elementary::exp_m1(-rate * duration),
                noise: Elementary::sqrt(variance * -Elementary::exp_m1(-2.0 * rate * duration)),
            }
        });
        factors.collect()
    }
}

/// Checks the rates, the temperatures and the masses of a system at the time zero.
///
/// # Errors
/// [`Error::Rate`] with the first rate or temperature that is negative or not a number; [`Error::MassOfNoise`], where a
/// velocity is not the momentum over a positive mass.
pub fn are_rates<H: WithFriction>(system: &H, length: usize) -> Result<(), Error> {
    for index in 0..length {
        let stated = system.stated_rates(index, 0.0);
        for (function, value) in ["friction", "temperature"].into_iter().zip(stated) {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Error::Rate { function, index, value });
            }
        }
    }
    if !has_heat::<H>() {
        return Ok(());
    }
    let (parameters, count) = (system.parameters(length), length * H::Coords::COMPONENTS.max(1));
    let others = velocities::<H>(&parameters, count, &other_momentum);
    are_masses(&inverse_masses::<H>(&parameters, count), &others)
}

/// Whether velocities are those of other momenta by these masses.
fn are_masses(inverse_masses: &[f64], velocities: &[f64]) -> Result<(), Error> {
    for (coordinate, (inverse_mass, velocity)) in inverse_masses.iter().zip(velocities).enumerate() {
        let expected = other_momentum(coordinate) * inverse_mass;
        // A few products and one division are rounded on each side.
        let rounding = 16.0 * f64::EPSILON * expected.abs();
        if !(*inverse_mass > 0.0 && (velocity - expected).abs() <= rounding) {
            return Err(Error::MassOfNoise { coordinate });
        }
    }
    Ok(())
}
