//! The conditions on the start and the step of a trajectory.

use crate::{
    error::Error,
    state::{coords::Coords, fixed::is_power_of_two, phase::Phase, precision::Precision},
    system::{System, dissipation::Dissipation},
    trajectory::method::{Facts, Method},
};

/// Whether a run may begin at `start` with step `h`.
///
/// # Errors
/// A step that is zero or not finite; a start that is not finite, whose `q` and `p` differ in length, or that is not
/// representable on its grid.
pub(crate) fn admissible<C: Coords>(start: &Phase<C>, h: f64) -> Result<(), Error> {
    if h == 0.0 || !h.is_finite() {
        return Err(Error::Step { h });
    }
    let (positions, momenta) = (start.q.flat().len(), start.p.flat().len());
    if positions != momenta {
        return Err(Error::Length { positions, momenta });
    }
    on_their_grids("q", start.q.flat())?;
    on_their_grids("p", start.p.flat())
}

fn on_their_grids<K: Precision>(coordinate: &'static str, leaves: &[K]) -> Result<(), Error> {
    for (index, leaf) in leaves.iter().enumerate() {
        on_its_grid((coordinate, index, leaf.to_f64()), leaf.spacing(), leaf.limit())?;
    }
    Ok(())
}

/// Whether a coordinate is finite, and representable on its grid if it has one.
fn on_its_grid(
    (coordinate, index, value): (&'static str, usize, f64),
    spacing: Option<f64>,
    limit: f64,
) -> Result<(), Error> {
    if !value.is_finite() {
        return Err(Error::Start { coordinate, index, value });
    }
    match spacing {
        Some(spacing) if !is_power_of_two(spacing) => Err(Error::Grid { coordinate, index, spacing }),
        Some(spacing) if value.abs() >= limit => Err(Error::GridRange { coordinate, index, value, spacing, limit }),
        _ => Ok(()),
    }
}

/// Whether a run with a method may begin at `start` with step `h`.
///
/// # Errors
/// As [`admissible`]; a reversible start and a method that is not symmetric; what the method itself refuses; a system with
/// friction and a method without, noise in steps backwards.
pub(crate) fn admissible_with<H: System, C: Coords>(
    method: impl Method<H>,
    start: &Phase<C>,
    h: f64,
) -> Result<(), Error> {
    method.admissible()?;
    fits(&method.claims(), H::DISSIPATION, C::Leaf::REVERSIBLE, h)?;
    admissible(start, h)
}

/// Whether a method fits a system with this dissipation and this kind of start. Compiled once for all systems.
fn fits(facts: &Facts, dissipation: Dissipation, reversible: bool, h: f64) -> Result<(), Error> {
    if reversible && !facts.symmetric {
        return Err(Error::NotSymmetric { composition: facts.name });
    }
    if reversible && facts.friction {
        return Err(Error::FrictionOnGrid);
    }
    if !matches!(dissipation, Dissipation::None) && !facts.friction {
        return Err(Error::NoFriction { method: facts.name });
    }
    if matches!(dissipation, Dissipation::Heat) && (h < 0.0 || facts.negative_friction) {
        return Err(Error::NoiseBackwards { method: facts.name, h });
    }
    Ok(())
}

/// Changes the state of a run in progress from outside.
///
/// # Errors
/// As [`admissible`]; another number of coordinates.
pub(crate) fn change<C: Coords>(state: &mut Phase<C>, h: f64, map: impl FnOnce(&mut Phase<C>)) -> Result<(), Error> {
    let before = state.q.flat().len();
    map(state);
    admissible(state, h)?;
    match state.q.flat().len() {
        after if after != before => Err(Error::Resized { before, after }),
        _ => Ok(()),
    }
}
