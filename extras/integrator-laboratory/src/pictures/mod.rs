//! The pictures of the page, one row each.

mod adaptive;
mod areas;
mod brackets;
mod energies;
mod errors;
mod gear;
mod limits;
mod linear;
mod maps;
mod modified;
mod portraits;
mod radius;
mod reversal;
mod roots;
mod shifted;
mod style;
mod tangents;

use crate::{laboratory::Drawing, study::Study};

/// The chapters of the page: an identifier, a title, and the pictures in them.
pub(crate) const CHAPTERS: [(&str, &str, &[&str]); 7] = [
    ("euler", "Euler’s methods and the leapfrog", &["portraits", "energy", "energy_error", "shifted", "reversal"]),
    ("symplectic", "Symplectic maps", &["brackets", "maps", "areas", "tangents"]),
    ("backward", "The energy that steps conserve", &["modified"]),
    ("order", "Order, work and stability", &["errors", "work_precision", "limits", "linear", "adaptive"]),
    ("multistep", "Multistep methods", &["roots"]),
    ("series", "Series and extrapolation", &["radius"]),
    ("stiffness", "Stiff equations", &["gear", "regions"]),
];

/// A picture with the name of its files.
type Picture = (&'static str, fn(&Study) -> Option<Drawing>);

/// One row for each picture, in the order of the page; none where there is nothing to show.
pub(crate) const PICTURES: [Picture; 19] = [
    ("portraits", |study| Some(portraits::portraits(study).into())),
    ("energy_error", |study| study.resolved.then(|| energies::extremes(study).into())),
    ("energy", |study| study.resolved.then(|| energies::low_orders(study).into())),
    ("shifted", |study| Some(shifted::shifted(study).into())),
    ("brackets", |study| brackets::brackets(study).map(Drawing::from)),
    ("modified", |study| study.resolved.then(|| modified::modified(study)).flatten().map(Drawing::from)),
    ("areas", |study| Some(areas::areas(study).into())),
    ("maps", |study| Some(maps::maps(study).into())),
    ("tangents", |study| Some(tangents::tangents(study).into())),
    ("reversal", |study| study.autonomous.then(|| reversal::reversal(study).into())),
    ("limits", |study| study.resolved.then(|| limits::limits(study).into())),
    ("linear", |study| linear::linear(study).map(Drawing::from)),
    ("errors", |study| Some(errors::against_step(study).into())),
    ("work_precision", |study| Some(errors::against_work(study).into())),
    ("adaptive", |study| adaptive::adaptive(study).map(Drawing::from)),
    ("radius", |study| radius::radius(study).map(Drawing::from)),
    ("roots", |study| roots::roots(study).map(Drawing::from)),
    ("gear", |study| Some(gear::motion(study).into())),
    ("regions", |study| Some(gear::regions(study).into())),
];

/// All pictures of a study.
pub(crate) fn all(study: &Study) -> Vec<(String, Drawing)> {
    PICTURES.iter().filter_map(|(name, draw)| Some(((*name).to_owned(), draw(study)?))).collect()
}
