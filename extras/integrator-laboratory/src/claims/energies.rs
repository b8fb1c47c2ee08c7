//! Energies: growth and decay, portraits, modified Hamiltonians.

use super::{
    CHANGED, Claim,
    advice::{CONVEX, DRIFT, KEEPS, SERIES},
    verdict::Verdict,
    word,
};
use crate::{
    measured::Measured,
    modified::Modified,
    numbers::plain,
    portrait::{SEEN, STAYS},
    problem::steps_per_period,
    study::Study,
};

/// A power is off by a few tenths where the next one still shows, and by one at least where a term is wrong.
const POWER: f64 = 0.4;

/// The change of the energy after a period. Later, a system may have escaped.
fn energy_change(study: &Study, method: &str) -> Option<f64> {
    let (_, change) = study.method(method)?.energies.iter().take_while(|(periods, _)| *periods <= 1.0).last()?;
    Some(*change)
}

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        name: "forward_euler_energy_grows",
        shown: ("energy", "K", CONVEX),
        says: "Forward Euler gains energy: the change after a period, in units of the largest kinetic energy",
        applies: |study| study.resolved,
        value: |study| energy_change(study, "forward Euler"),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "backward_euler_energy_decays",
        shown: ("energy", "K", CONVEX),
        says: "Backward Euler loses energy: the change after a period, in units of the largest kinetic energy",
        applies: |study| study.resolved,
        value: |study| energy_change(study, "backward Euler"),
        within: [f64::NEG_INFINITY, -CHANGED],
    },
];

/// Returns the verdict on the energy of one method, in the steps of its portrait.
pub(super) fn of_portrait(measured: &Measured) -> Verdict {
    let portrait = &measured.portrait;
    let (name, steps) = (measured.name(), plain(steps_per_period(portrait.count)));
    let word = measured.word();
    if measured.symplectic {
        let says = format!(
            "The energy of {name} oscillates and does not drift, in {steps} steps per period: its largest error in the second half over that in the first"
        );
        let verdict = Verdict::new(format!("{word}_energy_stays"), says, [0.0, STAYS], Some(portrait.growth()));
        return verdict.shown_in("portraits").meaning(DRIFT);
    }
    let periods = plain(portrait.periods);
    // A change that grows is seen before it is as large as the swings of a method that keeps its energy.
    let least = if portrait.growth() > STAYS { CHANGED } else { SEEN };
    let says = format!(
        "{name} gains or loses energy, in {steps} steps per period: the size of the change after {periods} periods, in units of the largest kinetic energy"
    );
    let verdict =
        Verdict::new(format!("{word}_energy_changes"), says, [least, f64::INFINITY], Some(portrait.change.abs()));
    Verdict { unit: "K", ..verdict.shown_in("portraits").meaning(KEEPS) }
}

/// Returns the verdict on a modified Hamiltonian.
pub(super) fn of_modified(modified: &Modified) -> Verdict {
    let name = modified.row.name;
    let [first, last] = [modified.powers.first(), modified.powers.last()].map(|power| power.copied().unwrap_or(0));
    let says = format!(
        "{name} conserves a modified Hamiltonian: with the terms of its series, the change of the energy falls with powers of the step \
         from {first} to {last}; by how much the measured ones exceed these, at least"
    );
    let verdict =
        Verdict::new(format!("{}_modified_energy_stays", word(name)), says, [-POWER, f64::INFINITY], modified.excess);
    verdict.shown_in("modified").meaning(SERIES)
}
