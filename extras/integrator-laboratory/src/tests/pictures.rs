//! Pictures have axes, words and curves.

use super::study;
use crate::{Drawing, pictures::PICTURES, study::Study};
use integrator_plot::{Canvas, Picture};

/// A curve does not pass through fifteen decades where an energy that was too high is too low.
#[test]
fn curves_of_energies_are_broken_where_their_sign_changes() {
    let mut study = study();
    let pieces = |study: &Study| {
        let (_, draw) = PICTURES.iter().find(|(name, _)| *name == "energy_error").expect("a picture");
        let svg = svg(&draw(study).expect("an energy"));
        // Names at the ends have lines of their own, in grey.
        let integrator_plot::Colour(red, green, blue) = study.methods[0].row.colour;
        let colour = format!("#{red:02x}{green:02x}{blue:02x}");
        svg.split("<polyline").filter(|rest| rest.split('>').next().is_some_and(|line| line.contains(&colour))).count()
    };
    let before = pieces(&study);
    let euler = &mut study.methods[0];
    let half = euler.energies.len() / 2;
    euler.energies[half..].iter_mut().for_each(|(_, change)| *change = -*change);
    assert!(pieces(&study) > before);
}

/// Tests that visible energy changes are those of methods that are not symplectic, and how far reversals end from the
/// start.
#[test]
fn portraits_show_what_a_method_does() {
    let study = study();
    for measured in &study.methods {
        let (portrait, name) = (&measured.portrait, measured.name());
        assert_eq!(portrait.change.abs() > crate::portrait::SEEN, !measured.symplectic, "{name}: {}", portrait.change);
        let count = if measured.symplectic { 30 } else { portrait.count.min(30) };
        assert_eq!(measured.reversal.count, count, "{name}");
    }
    let apart = study.method("Runge–Kutta 4").and_then(|measured| measured.reversal.apart).expect("an end");
    assert!(apart > 0.1, "the end is seen to be another point than the start: {apart}");
}

fn svg(drawing: &Drawing) -> String {
    let of = |picture: &dyn Fn(&mut Canvas), size| {
        let mut canvas = Canvas::new(size).expect("fonts");
        picture(&mut canvas);
        canvas.svg()
    };
    match drawing {
        Drawing::Chart(chart) => of(&|canvas| chart.draw(canvas), chart.size()),
        Drawing::Panels(panels) => of(&|canvas| panels.draw(canvas), panels.size()),
    }
}

/// Words of each picture that stand on its axes or in its head, and whether all methods have their colour in it.
const SHOWN: [(&str, [&str; 3], bool); 19] = [
    ("portraits", ["Phase portraits", "symplectic", "gains energy"], true),
    ("energy_error", ["Energy error against time", "10⁻⁵", "Dormand–Prince 5"], true),
    ("energy", ["Energy in the first periods", "periods", "forward Euler"], false),
    ("shifted", ["Both sequences", "Interleaved times", "qₙ₊½ = qₙ₋½ + h T′(pₙ)"], false),
    ("brackets", ["Poisson bracket of one step", "1 + h² T″ V″", "backward Euler divides"], false),
    ("modified", ["Modified Hamiltonians", "with further terms h⁴, h⁶", "Yoshida 4"], false),
    ("areas", ["Areas", " at the end: 1 ", "preserve"], true),
    ("maps", ["Symplectic or not", "step", "implicit midpoint"], true),
    ("tangents", ["Length of a deviation", "{q, p} − 1", "Deviations evolved by"], true),
    ("reversal", ["Reversibility", "distance from the start: ", "Verlet"], false),
    ("limits", ["Energy error against step", "2/ω", "Yoshida 4"], false),
    ("linear", ["Eigenvalues", "Gain or loss of energy", "R(ih)"], false),
    ("errors", ["Error against step", "Runge–Kutta 4: ", "distance from the reference"], true),
    ("work_precision", ["Work and precision", "force evaluations", "Dormand–Prince 8"], true),
    ("adaptive", ["Adaptive Runge–Kutta", "eccentricity 0.8", "tolerance"], false),
    ("radius", ["Taylor series", "Radius and step", "eccentricity 0.8"], false),
    ("roots", ["Parasitic roots", "a root leaves the circle at hω", "Störmer 4"], false),
    ("gear", ["A stiff equation", "cos t", "backward Euler"], false),
    ("regions", ["Regions of stability", "BDF 6: 17.84°", "Re hλ"], false),
];

#[test]
fn every_picture_has_its_words_and_the_colours_of_methods() {
    let study = study();
    assert_eq!(SHOWN.map(|(name, ..)| name), PICTURES.map(|(name, _)| name));
    for ((name, words, all), (_, draw)) in SHOWN.into_iter().zip(PICTURES) {
        let svg = svg(&draw(&study).expect("a picture"));
        for word in words {
            assert!(svg.contains(word), "{name} lacks {word:?}");
        }
        for measured in study.methods.iter().filter(|_| all) {
            let integrator_plot::Colour(red, green, blue) = measured.row.colour;
            assert!(
                svg.contains(&format!("#{red:02x}{green:02x}{blue:02x}")),
                "{name} has nothing in the colour of {}",
                measured.name()
            );
        }
        // A hundredth of what a line for every step of every method would take.
        assert!(svg.len() < 1_000_000, "{name}: {} bytes", svg.len());
    }
    let adaptive = study.adaptive.iter().map(|adaptive| adaptive.row.colour);
    let colours: Vec<_> = study.methods.iter().map(|measured| measured.row.colour).chain(adaptive).collect();
    assert!((0..colours.len()).all(|i| !colours[..i].contains(&colours[i])), "one colour for each method");
    let verlet = study.method("Verlet").map(|verlet| verlet.row.colour);
    assert_eq!((crate::colour("Verlet"), crate::colour("Störmer")), (verlet, None), "for pictures of one's own");
}
