//! The files that the laboratory writes.

use crate::{
    SMALL, claims::verdicts, exists, folder, notes::notes, pictures::PICTURES, systems::SYSTEMS, write::write,
};
use std::fs;

/// Words of each picture that stand on its axes or in its head, and whether all methods have a curve in it.
const SHOWN: [(&str, [&str; 3], bool); 9] = [
    ("portraits", ["Phase portraits", "symplectic", "gains energy"], true),
    ("energy", ["Energy against time", "periods", "forward Euler"], false),
    ("energy_error", ["Energy error", "largest so far", "Kahan–Li 8"], true),
    ("errors", ["Error against step", "Runge–Kutta 4: ", "distance from the reference"], true),
    ("work_precision", ["Work and precision", "evaluations of the force", "Dormand–Prince 8"], false),
    ("areas", ["A blob of starts", " at the end: 1 ", "preserve"], true),
    ("brackets", ["Poisson bracket", "step", "implicit midpoint"], true),
    ("period", ["Period of the pendulum", "exact 8.349", "relative error"], false),
    ("section", ["Hénon and Heiles", "E = 0.1250", "py"], false),
];

/// Two systems: one with two degrees of freedom, one with one.
#[test]
fn every_picture_has_its_words_and_its_curves() {
    let notes = notes(&SMALL).expect("measurements");
    for system in [&SYSTEMS[0], &SYSTEMS[2]] {
        let study = system.study(&SMALL).expect("measurements");
        let folder = folder(&format!("pictures-{}", system.name));
        let page = write(&folder, &study, &notes, &verdicts(&study, &notes)).expect("files");
        assert_eq!(SHOWN.map(|(name, ..)| name), PICTURES.map(|picture| picture.name));
        for (name, words, all) in SHOWN {
            let svg = fs::read_to_string(folder.join(name).with_extension("svg")).expect("text");
            for word in words {
                assert!(svg.contains(word), "{name} of {} lacks {word:?}", system.name);
            }
            // Axes, grids and dashes are lines as well, so that this is the least.
            let curves = svg.matches("<polyline").count();
            assert!(!all || curves >= study.methods.len(), "{name}: {curves} curves");
            assert!(exists(&folder.join(name).with_extension("png")), "{name}.png");
            // A hundredth of what a line for every step of every method would take.
            assert!(svg.len() < 2_000_000, "{name}: {} bytes", svg.len());
        }
        let text = fs::read_to_string(&page).expect("a page");
        assert_eq!(text.matches("<figure").count(), PICTURES.len());
        assert_eq!(text.matches("role=\"img\"").count(), PICTURES.len());
        assert!(text.contains(study.formula) && !text.contains("\"FAILED\""), "the page says what was studied");
        stands_alone(&text);
        fs::remove_dir_all(&folder).expect("a folder");
        fs::remove_file(page).expect("a file");
    }
}

/// Whatever the page refers to is inside of it; names of XML are no references.
fn stands_alone(page: &str) {
    for attribute in ["src=\"", "href=\"", "url("] {
        for reference in page.split(attribute).skip(1) {
            let inside = ["data:", "#"].iter().any(|inside| reference.trim_start_matches('"').starts_with(inside));
            assert!(inside, "{attribute}{}", reference.chars().take(60).collect::<String>());
        }
    }
    for element in ["<script", "<link", "<iframe", "@import"] {
        assert!(!page.contains(element), "{element}");
    }
}
