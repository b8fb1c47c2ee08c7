//! The rates of friction of all coordinates, and the widths of their distributions.

use crate::{
    error::Error,
    state::coords::Coords,
    system::{
        dissipation::{Dissipation, WithFriction},
        motion::Plain,
    },
};
use alloc::vec::Vec;

/// Friction and noise of the coordinates of a system at one time, in the order of `Coords::flat`. Where all are alike, each list
/// has one entry.
pub(super) struct Rates {
    /// The rates.
    pub(super) rates: Vec<f64>,
    /// The variances of the momenta in equilibrium, `m kT`; nothing without a temperature.
    pub(super) variances: Vec<f64>,
}

/// The velocities of momenta at a time.
fn velocities<H: WithFriction>(
    parameters: &H::Parameters<f64>,
    count: usize,
    momentum: impl Fn(usize) -> f64,
    time: f64,
) -> Vec<f64> {
    read::<H>(parameters, count, momentum, |motion| H::add_velocities::<f64, f64>(motion, time)).0
}

/// Whether a system has a temperature.
const fn has_heat<H: WithFriction>() -> bool {
    matches!(H::DISSIPATION, Dissipation::Heat)
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
        let mut rates = read::<H>(parameters, count, |_| 0.0, |motion| H::add_rates::<f64, f64>(motion, time)).1;
        let mut variances = Vec::new();
        if has_heat::<H>() {
            variances = read::<H>(parameters, count, |_| 0.0, |motion| H::add_temperatures::<f64, f64>(motion, time)).1;
            let inverse_masses = velocities::<H>(parameters, count, |_| 1.0, time);
            variances.iter_mut().zip(inverse_masses).for_each(|(variance, inverse_mass)| *variance /= inverse_mass);
        }
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
    let of = |momentum: fn(usize) -> f64| velocities::<H>(&parameters, count, momentum, 0.0);
    let (inverse_masses, others) = (of(|_| 1.0), of(other_momentum));
    for (coordinate, (inverse_mass, velocity)) in inverse_masses.iter().zip(others).enumerate() {
        let expected = other_momentum(coordinate) * inverse_mass;
        // A few products and one division are rounded on each side.
        let rounding = 16.0 * f64::EPSILON * expected.abs();
        if !(*inverse_mass > 0.0 && (velocity - expected).abs() <= rounding) {
            return Err(Error::MassOfNoise { coordinate });
        }
    }
    Ok(())
}
