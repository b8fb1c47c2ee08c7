//! The compositions of `integrator-core`, from the text of their declarations: each is proved again, in milliseconds.

use crate::source::Source;
use integrator_symbolic::{Proved, declared};
use std::cell::LazyCell;

/// The files of the catalogue; a test compares them with the folder.
pub(crate) const FILES: [(&str, &str); 7] = [
    ("basic", include_str!("../../integrator-core/src/composition/catalogue/basic.rs")),
    ("general", include_str!("../../integrator-core/src/composition/catalogue/general.rs")),
    ("gradient", include_str!("../../integrator-core/src/composition/catalogue/gradient.rs")),
    ("near_integrable", include_str!("../../integrator-core/src/composition/catalogue/near_integrable.rs")),
    ("nystrom", include_str!("../../integrator-core/src/composition/catalogue/nystrom.rs")),
    ("processed", include_str!("../../integrator-core/src/composition/catalogue/processed.rs")),
    ("symmetric", include_str!("../../integrator-core/src/composition/catalogue/symmetric.rs")),
];

/// All of them, lowest order first, and in each order the cheapest step; proved when the first one is requested.
pub(crate) type Catalogue = LazyCell<Vec<Proved>>;

pub(crate) fn catalogue() -> Catalogue {
    LazyCell::new(|| {
        let mut found: Vec<Proved> = FILES
            .iter()
            .filter_map(|(name, text)| Source { name: (*name).to_owned(), text: (*text).to_owned() }.seen().ok())
            .flat_map(|seen| seen.declarations)
            .filter_map(|declarations| declared(declarations).ok())
            .flatten()
            .collect();
        found.sort_by(|a, b| (a.order, a.force_evaluations, &a.name).cmp(&(b.order, b.force_evaluations, &b.name)));
        found
    })
}

#[cfg(test)]
mod tests {
    use super::{FILES, catalogue};
    use std::{collections::BTreeSet, fs, path::Path};

    #[test]
    fn every_file_is_read() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../integrator-core/src/composition/catalogue");
        let names = fs::read_dir(folder).expect("the catalogue").map(|entry| {
            let path = entry.expect("an entry").path();
            path.file_stem().expect("a name").to_string_lossy().into_owned()
        });
        assert_eq!(names.collect::<BTreeSet<_>>(), FILES.iter().map(|(name, _)| (*name).to_owned()).collect());
    }

    /// As many as the runtime lists, so that no block was left out for an error.
    #[test]
    fn every_composition_is_proved() {
        let list = include_str!("../../integrator-core/src/composition/catalogue_list.rs");
        let found = catalogue();
        assert!(found.len() > 50, "{}", found.len());
        for composition in found.iter() {
            assert!(list.contains(&composition.name), "{}", composition.name);
            assert!(!composition.citation.is_empty(), "{}", composition.name);
        }
    }
}
