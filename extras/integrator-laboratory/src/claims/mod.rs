//! The claims of the course, each with the number that decides it.

mod accuracy;
mod advice;
mod energies;
mod maps;
mod models;
mod verdict;

use crate::{measured::Measured, study::Study};
pub use verdict::Verdict;

/// A claim about methods, which is checked for every system.
struct Claim {
    name: &'static str,
    /// The picture, the unit of the number, and what it may mean that the claim fails.
    shown: (&'static str, &'static str, &'static str),
    says: &'static str,
    /// Whether the claim applies to the system.
    applies: fn(&Study) -> bool,
    /// The number; none where it could not be measured.
    value: fn(&Study) -> Option<f64>,
    within: [f64; 2],
}

/// An energy that has changed by less than a hundredth of the largest kinetic energy has not grown or decayed to speak of.
pub(crate) const CHANGED: f64 = 0.01;

/// The farthest of several numbers; none if one is missing.
fn farthest(mut numbers: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    numbers.try_fold(0.0, |most: f64, number| Some(most.max(number?)))
}

impl Claim {
    /// Holds the claim against what was measured.
    fn verdict(&self, study: &Study) -> Verdict {
        let (picture, unit, meaning) = self.shown;
        let says = self.says.replace("{q₁, p₁}", &study.bracket()).replace("T″V″", &study.curvature);
        let verdict = Verdict::new(self.name, says, self.within, (self.value)(study));
        Verdict { unit, ..verdict.shown_in(picture).meaning(meaning) }
    }
}

impl Measured {
    /// The name as a word of letters, digits and underscores.
    pub(crate) fn word(&self) -> String {
        word(self.name())
    }
}

fn word(name: &str) -> String {
    let letter = |letter: char| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' };
    name.replace('ö', "oe").chars().map(letter).collect()
}

/// Returns the verdicts on all claims that apply to the system.
pub(crate) fn verdicts(study: &Study) -> Vec<Verdict> {
    // Claims about a method that not every Hamiltonian admits.
    let of = |method: &str, claims: &'static [Claim]| if study.has(method) { claims } else { &[] };
    let claims = [
        energies::CLAIMS,
        maps::CLAIMS,
        accuracy::CLAIMS,
        models::CLAIMS,
        accuracy::ORDERS,
        of("Störmer 4", accuracy::OF_SECOND_ORDER),
        of("Chin 4A", accuracy::OF_GRADIENTS),
        of("Taylor", accuracy::OF_TAYLOR),
    ];
    let claims = claims.into_iter().flatten().filter(|claim| (claim.applies)(study));
    let portraits = study.methods.iter().filter(|_| study.resolved).map(energies::of_portrait);
    let modified = study.modified.iter().filter(|_| study.resolved).map(energies::of_modified);
    claims.map(|claim| claim.verdict(study)).chain(portraits).chain(modified).collect()
}
