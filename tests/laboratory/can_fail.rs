//! A claim does not hold of another method, nor of what could not be measured.

use crate::{
    SMALL,
    claims::{CLAIMS, Verdict},
    notes::{Notes, notes},
    study::Study,
    systems::SYSTEMS,
};

fn verdict(name: &str, study: &Study, notes: &Notes) -> Verdict {
    CLAIMS.iter().find(|claim| claim.name == name).expect("a claim").verdict(study, notes)
}

/// Each claim, and the method whose measurements it must not be content with.
const WRONG: [(&str, &str, &str); 8] = [
    ("forward_euler_energy_grows", "forward Euler", "Verlet"),
    ("backward_euler_energy_decays", "backward Euler", "forward Euler"),
    ("symplectic_euler_bracket_is_one", "symplectic Euler", "Runge–Kutta 4"),
    ("forward_euler_bracket_is_not_one", "forward Euler", "symplectic Euler"),
    ("forward_euler_area_is_not_preserved", "forward Euler", "Verlet"),
    ("verlet_order_2", "Verlet", "symplectic Euler"),
    ("rk4_order_4", "Runge–Kutta 4", "Verlet"),
    ("yoshida4_order_4", "Yoshida 4", "Blanes–Moan 6"),
];

/// Gives the measurements of a method to another one.
fn rename(study: &mut Study, from: &str, to: &'static str) {
    study.methods.iter_mut().find(|measured| measured.name == from).expect("a method").name = to;
}

#[test]
fn a_claim_fails_for_another_method() {
    let notes = notes(&SMALL).expect("measurements");
    let mut study = SYSTEMS[0].study(&SMALL).expect("measurements");
    for (claim, method, other) in WRONG {
        assert!(verdict(claim, &study, &notes).holds, "{claim}");
        rename(&mut study, method, "missing");
        let missing = verdict(claim, &study, &notes);
        assert!(!missing.holds && missing.value.is_nan() && missing.word() == "FAILED", "{claim} without {method}");
        rename(&mut study, other, method);
        let wrong = verdict(claim, &study, &notes);
        assert!(!wrong.holds, "{claim} holds of {other}: {:e}", wrong.value);
        rename(&mut study, method, other);
        rename(&mut study, "missing", method);
    }
}

#[test]
fn a_claim_fails_for_a_number_that_is_off() {
    let mut notes = notes(&SMALL).expect("measurements");
    let mut study = SYSTEMS[0].study(&SMALL).expect("measurements");
    study.shifted = 1e-3;
    study.methods[0].symplectic = true;
    notes.closed_forms[0].1 = 1e-3;
    for row in &mut notes.periods {
        row.errors.retain(|(h, _)| *h > 0.3);
    }
    let claims = [
        "verlet_equals_shifted_leapfrog",
        "oscillator_closed_forms",
        "pendulum_period",
        "brackets_tell_symplectic_methods",
    ];
    for claim in claims {
        assert!(!verdict(claim, &study, &notes).holds, "{claim}");
    }
}
