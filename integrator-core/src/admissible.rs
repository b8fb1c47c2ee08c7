//! What a trajectory may begin with.

use crate::{coords::Coords, error::Error, fixed::is_power_of_two, method::Described, phase::Phase, slot::Keep};

/// Whether a run may begin at `start` with step `h`.
///
/// # Errors
/// A step that is zero or not finite; a start that is not finite, whose `q` and `p` differ in length, or that has no place on
/// its grid.
pub(crate) fn admissible<C: Coords>(start: &Phase<C>, h: f64) -> Result<(), Error> {
    if h == 0.0 || !h.is_finite() {
        return Err(Error::Step { h });
    }
    let (positions, momenta) = (start.q.flat().len(), start.p.flat().len());
    if positions != momenta {
        return Err(Error::Length { positions, momenta });
    }
    for (coordinate, leaves) in [("q", start.q.flat()), ("p", start.p.flat())] {
        for (index, leaf) in leaves.iter().enumerate() {
            let (value, limit) = (leaf.to_f64(), leaf.limit());
            if !value.is_finite() {
                return Err(Error::Start { coordinate, index, value });
            }
            let Some(spacing) = leaf.spacing() else { continue };
            if !is_power_of_two(spacing) {
                return Err(Error::Grid { coordinate, index, spacing });
            }
            if value.abs() >= limit {
                return Err(Error::GridRange { coordinate, index, value, spacing, limit });
            }
        }
    }
    Ok(())
}

/// Whether a run with a method may begin at `start` with step `h`.
///
/// # Errors
/// As [`admissible`]; a reversible start and a method that is not symmetric; what the method itself refuses.
pub(crate) fn admissible_with<C: Coords>(method: impl Described, start: &Phase<C>, h: f64) -> Result<(), Error> {
    method.admissible()?;
    let facts = method.facts();
    if C::Leaf::REVERSIBLE && !facts.symmetric {
        return Err(Error::NotSymmetric { composition: facts.name });
    }
    admissible(start, h)
}

/// Changes the state of a run under way from outside.
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
