//! The rates of friction of all coordinates, and the widths of their distributions.

use crate::{
    error::Error,
    state::coords::Coords,
    system::{
        dissipation::{Dissipation, WithFriction},
        motion::Plain,
    },
};
use alloc::{vec, vec::Vec};

/// Friction and noise of the coordinates of a system at one time, in the order of `Coords::flat`. Where all are alike, each list
/// has one entry.
pub(super) struct Rates {
    /// The rates.
    pub(super) rates: Vec<f64>,
    /// The variances of the momenta in equilibrium, `m kT`; nothing without a temperature.
    pub(super) variances: Vec<f64>,
}

/// The numbers that the functions of a system give.
struct Given {
    rates: Vec<f64>,
    temperatures: Vec<f64>,
    inverse_masses: Vec<f64>,
    /// The velocities of other momenta than 1, and these momenta.
    velocities: Vec<f64>,
    momenta: Vec<f64>,
}

impl Given {
    fn of<H: WithFriction>(parameters: &H::Parameters<f64>, count: usize, time: f64) -> Self {
        let rates = read::<H>(parameters, count, |_| 0.0, |motion| H::add_rates::<f64, f64>(motion, time)).1;
        let has_heat = matches!(H::DISSIPATION, Dissipation::Heat);
        if !has_heat {
            return Self { rates, temperatures: vec![], inverse_masses: vec![], velocities: vec![], momenta: vec![] };
        }
        let temperatures =
            read::<H>(parameters, count, |_| 0.0, |motion| H::add_temperatures::<f64, f64>(motion, time)).1;
        let velocities = |of: fn(usize) -> f64| {
            read::<H>(parameters, count, of, |motion| H::add_velocities::<f64, f64>(motion, time)).0
        };
        Self {
            rates,
            temperatures,
            inverse_masses: velocities(|_| 1.0),
            velocities: velocities(other_momentum),
            momenta: (0..count).map(other_momentum).collect(),
        }
    }
}

/// A momentum for each coordinate, which differs from those of its neighbours.
fn other_momentum(coordinate: usize) -> f64 {
    1.0 + (coordinate % 7) as f64 / 8.0
}

/// The positions and the momenta of a motion that begins at the origin with some momenta, after `add`.
fn read<H: WithFriction>(
    parameters: &H::Parameters<f64>,
    count: usize,
    momentum: impl Fn(usize) -> f64,
    add: impl Fn(&mut Plain<f64, H::Coords, H::Parameters<f64>>),
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
        let Given { mut rates, temperatures, inverse_masses, .. } = Given::of::<H>(parameters, count, time);
        let variance = |(temperature, inverse_mass): (&f64, &f64)| temperature / inverse_mass;
        let mut variances: Vec<f64> = temperatures.iter().zip(&inverse_masses).map(variance).collect();
        if [&rates, &variances].into_iter().all(|list| list.windows(2).all(|pair| pair[0] == pair[1])) {
            rates.truncate(1);
            variances.truncate(1);
        }
        Self { rates, variances }
    }
}

/// Checks the rates, the temperatures and the masses of a system at the time zero.
///
/// # Errors
/// [`Error::Rate`] with the first rate or temperature that is negative or not a number; [`Error::MassOfNoise`], where a
/// velocity is not the momentum over a positive mass.
pub fn are_rates<H: WithFriction>(system: &H, length: usize) -> Result<(), Error> {
    let parameters = system.parameters(length);
    let components = H::Coords::COMPONENTS.max(1);
    let given = Given::of::<H>(&parameters, length * components, 0.0);
    for index in 0..length {
        let stated = system.stated_rates(index, 0.0);
        for (function, value) in ["friction", "temperature"].into_iter().zip(stated) {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Error::Rate { function, index, value });
            }
        }
    }
    for (coordinate, inverse_mass) in given.inverse_masses.iter().enumerate() {
        let (velocity, expected) = (given.velocities[coordinate], given.momenta[coordinate] * inverse_mass);
        // A few products and one division are rounded on each side.
        let rounding = 16.0 * f64::EPSILON * expected.abs();
        if !(*inverse_mass > 0.0 && (velocity - expected).abs() <= rounding) {
            return Err(Error::MassOfNoise { coordinate });
        }
    }
    Ok(())
}
