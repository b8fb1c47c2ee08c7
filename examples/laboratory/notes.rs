//! What the notes claim of three systems, measured whatever system is looked at.

use crate::{
    oscillator::CLOSED_FORMS,
    period::{self, Periods},
    plan::Plan,
    section::{ENERGIES, Section, section},
};
use std::error::Error;

/// The measurements on the oscillator, the pendulum, and the system of Hénon and Heiles.
pub(crate) struct Notes {
    /// For each method, how far it ends from its closed form.
    pub(crate) closed_forms: Vec<(&'static str, f64)>,
    /// For each method, the errors of the pendulum's period.
    pub(crate) periods: Vec<Periods>,
    pub(crate) sections: Vec<Section>,
}

/// Measures them.
pub(crate) fn notes(plan: &Plan) -> Result<Notes, Box<dyn Error>> {
    let closed_forms = CLOSED_FORMS.iter().map(|form| Ok((form.name, form.distance()?)));
    Ok(Notes {
        closed_forms: closed_forms.collect::<Result<_, Box<dyn Error>>>()?,
        periods: period::all(plan.rungs.min(7)),
        sections: ENERGIES.iter().map(|energy| section(*energy, plan.crossings)).collect::<Result<_, _>>()?,
    })
}
