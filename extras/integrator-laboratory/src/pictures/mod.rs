//! The pictures of the page, one row each.

mod areas;
mod energies;
mod errors;
mod limits;
mod maps;
mod modified;
mod portraits;
mod reversal;
mod style;
mod tangents;

use crate::{laboratory::Drawing, study::Study};

/// A picture with the name of its files.
type Picture = (&'static str, fn(&Study) -> Option<Drawing>);

/// One row for each picture, in the order of the page; none where there is nothing to show.
pub(crate) const PICTURES: [Picture; 11] = [
    ("portraits", |study| Some(portraits::portraits(study).into())),
    ("energy_error", |study| study.resolved.then(|| energies::extremes(study).into())),
    ("energy", |study| study.resolved.then(|| energies::low_orders(study).into())),
    ("modified", |study| study.resolved.then(|| modified::modified(study)).flatten().map(Drawing::from)),
    ("areas", |study| Some(areas::areas(study).into())),
    ("maps", |study| Some(maps::maps(study).into())),
    ("tangents", |study| Some(tangents::tangents(study).into())),
    ("reversal", |study| study.autonomous.then(|| reversal::reversal(study).into())),
    ("limits", |study| study.resolved.then(|| limits::limits(study).into())),
    ("errors", |study| Some(errors::against_step(study).into())),
    ("work_precision", |study| Some(errors::against_work(study).into())),
];

/// All pictures of a study.
pub(crate) fn all(study: &Study) -> Vec<(String, Drawing)> {
    PICTURES.iter().filter_map(|(name, draw)| Some(((*name).to_owned(), draw(study)?))).collect()
}
