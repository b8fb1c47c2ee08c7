//! Each claim holds of the method that it is about, and fails for another one.

use super::{driven_study, study, verdict};
use crate::{Verdict, claims::verdicts, linear::Map, pictures::PICTURES, study::Study};

/// Each claim, and the method whose measurements it must not be content with.
const WRONG: [(&str, &str, &str); 13] = [
    ("forward_euler_energy_grows", "forward Euler", "Verlet"),
    ("backward_euler_energy_decays", "backward Euler", "forward Euler"),
    ("symplectic_euler_bracket_is_one", "symplectic Euler", "Runge–Kutta 4"),
    ("forward_euler_bracket_is_not_one", "forward Euler", "symplectic Euler"),
    ("forward_euler_bracket_leaves_one", "forward Euler", "Verlet"),
    ("forward_euler_area_is_not_preserved", "forward Euler", "Verlet"),
    ("forward_euler_does_not_come_back", "forward Euler", "Verlet"),
    ("symplectic_euler_does_not_come_back", "symplectic Euler", "Verlet"),
    ("runge_kutta_4_does_not_come_back", "Runge–Kutta 4", "implicit midpoint"),
    ("verlet_order_2", "Verlet", "symplectic Euler"),
    ("rk4_order_4", "Runge–Kutta 4", "Verlet"),
    ("yoshida4_order_4", "Yoshida 4", "Blanes–Moan 6"),
    ("gauss_legendre4_order_4", "Gauss–Legendre 4", "implicit midpoint"),
];

/// Methods that not every Hamiltonian admits have their claims where they are, and these can fail.
#[test]
fn methods_of_some_systems_have_claims_of_their_own() {
    let sound = study();
    let claims = ["chin_4a_order_4", "stoermer4_order_4", "stoermer_cowell4_order_4", "taylor_follows_its_tolerance"];
    for claim in claims {
        assert!(verdict(claim, &sound).holds(), "{claim}");
    }
    let mut wrong = sound.clone();
    for name in ["Chin 4A", "Störmer 4", "Störmer–Cowell 4"] {
        let method = wrong.methods.iter_mut().find(|measured| measured.name() == name).expect("T is quadratic");
        method.slope = sound.method("Verlet").expect("a method").slope;
    }
    let taylor = wrong.adaptive.iter_mut().find(|adaptive| adaptive.row.name == "Taylor").expect("recurrences");
    taylor.errors.iter_mut().for_each(|rung| rung.error = 1e-6);
    for claim in claims {
        assert!(!verdict(claim, &wrong).holds(), "{claim}");
    }
    // Of a system without recurrences nothing is claimed of them.
    let other = driven_study();
    assert!(other.method("Chin 4A").is_some() && other.adaptive.len() + 1 == sound.adaptive.len());
    assert!(!verdicts(&other).iter().any(|verdict| verdict.name == "taylor_follows_its_tolerance"));
}

#[test]
fn a_claim_fails_for_another_method() {
    claims_fail_for_other_methods(&study());
}

pub(super) fn claims_fail_for_other_methods(study: &Study) {
    for (claim, method, other) in WRONG.into_iter().filter(|(claim, ..)| study.resolved || !claim.contains("energy")) {
        assert!(verdict(claim, study).holds(), "{claim}");
        let without = Study {
            methods: study.methods.iter().filter(|measured| measured.name() != method).cloned().collect(),
            ..study.clone()
        };
        let mut wrong = without.clone();
        for measured in &mut wrong.methods {
            if measured.name() == other {
                measured.row.name = method;
            }
        }
        let missing = verdict(claim, &without);
        assert!(
            !missing.holds() && missing.measured.is_nan() && missing.word() == "FAILED",
            "{claim} without {method}"
        );
        let wrong = verdict(claim, &wrong);
        assert!(!wrong.holds(), "{claim} holds of {other}: {:e}", wrong.measured);
    }
}

#[test]
fn a_claim_fails_for_a_number_that_is_off() {
    let holds = |name: &str, study: &Study| verdict(name, study).holds();
    let sound = study();
    assert!(
        verdicts(&sound).iter().all(Verdict::holds),
        "{:#?}",
        verdicts(&sound).iter().filter(|verdict| !verdict.holds()).collect::<Vec<_>>()
    );
    let mut study = sound.clone();
    study.shifted.apart = 1e-3;
    study.brackets.iter_mut().flatten().for_each(|row| row.measured[7].1 += 1e-9);
    let extrapolation = study.extrapolation.as_mut().expect("a table");
    extrapolation.corner = 1e-9;
    // The second column gains nothing.
    extrapolation.halved[1][1] = extrapolation.errors[1][1] / 8.0;
    // The last column is worse than the one before.
    extrapolation.halved[3][3] = 1.3 * extrapolation.halved[3][2];
    study.modified[1].excess = Some(-2.0);
    let steps = study.steps.as_mut().expect("steps");
    steps.change = 1e-6;
    let models = &mut study.models;
    models.ellipse.as_mut().expect("steps").exponent = 0.0;
    // Steps of equal length.
    models.radius.as_mut().expect("steps").steps.iter_mut().for_each(|step| step.length = 0.2);
    // The eigenvalues of Verlet are those of forward Euler, and those of Runge–Kutta 4 lose nothing.
    let maps = &mut models.linear.as_mut().expect("maps").maps;
    let place = |maps: &[Map], name: &str| maps.iter().position(|map| map.name == name).expect("a map");
    let [euler, verlet, kutta] = ["forward Euler", "Verlet", "Runge–Kutta 4"].map(|name| place(maps, name));
    maps[kutta].measured = maps[verlet].measured.clone();
    maps[verlet].measured = maps[euler].measured.clone();
    let dormand = study.adaptive.iter_mut().find(|adaptive| adaptive.row.name == "Dormand–Prince 5").expect("a method");
    dormand.errors.iter_mut().for_each(|rung| rung.error = 1e-6);
    let multistep = study.models.multistep.as_mut().expect("roots");
    multistep.growth = 1.01;
    multistep.roots[3].exponent = 4.0;
    study.models.gear.explodes = 1.0;
    study.models.gear.stays = 0.1;
    study.models.gear.exponents[5] = 5.0;
    study.models.gear.angles[5] = 18.8;
    study.models.gear.parasitic.reverse();
    // Forward Euler, taken for symplectic; it is neither, and it is not symmetric.
    study.methods[0].symplectic = true;
    study.methods[0].symmetric = true;
    for claim in [
        "verlet_equals_shifted_leapfrog",
        "each_column_of_the_extrapolation_gains_two_orders",
        "each_column_of_the_extrapolation_is_more_accurate",
        "the_extrapolation_ends_in_gragg_bulirsch_stoer",
        "forward_euler_bracket_has_a_formula",
        "backward_euler_bracket_is_the_inverse",
        "dormand_prince_5_follows_its_tolerance",
        "adaptive_steps_follow_the_force",
        "adaptive_runge_kutta_energy_changes",
        "taylor_steps_are_a_share_of_the_radius",
        "eigenvalues_have_closed_forms",
        "symplectic_eigenvalues_lie_on_the_unit_circle",
        "runge_kutta_4_loses_h6_over_72",
        "a_parasitic_root_grows",
        "principal_roots_follow_the_motion",
        "explicit_steps_explode_on_a_stiff_equation",
        "backward_differences_stay_on_a_stiff_equation",
        "backward_differences_have_their_orders",
        "backward_differences_are_stable_in_sectors",
        "backward_differences_of_order_6_are_stable",
        "backward_differences_of_order_7_are_not",
        "brackets_stay_one_at_every_step",
        "maps_tell_symplectic_methods",
        "symplectic_methods_preserve_areas",
        "symmetric_methods_come_back",
        "forward_euler_energy_stays",
        "verlet_modified_energy_stays",
    ] {
        assert!(!holds(claim, &study), "{claim}");
    }
    // Verlet, taken for a method that loses energy.
    let mut study = sound;
    study.methods.iter_mut().find(|measured| measured.name() == "Verlet").expect("a method").symplectic = false;
    assert!(!holds("verlet_energy_changes", &study));
}

/// A method with a memory is judged by its own steps and not by those of its starter: the defect of the map of Adams,
/// Bashforth and Moulton is not that of Runge and Kutta.
#[test]
fn multistep_methods_are_judged_after_their_starter() {
    let study = study();
    let [abm, rk] = ["Adams–Bashforth–Moulton 4", "Runge–Kutta 4"].map(|name| study.method(name).expect("a method"));
    assert_eq!(abm.bracket(), rk.bracket(), "the first step is that of the starter");
    let apart = abm.defects.iter().zip(&rk.defects).filter(|(a, b)| a.1 > 2.0 * b.1 || b.1 > 2.0 * a.1).count();
    assert!(apart >= 4, "{:?} and {:?}", abm.defects, rk.defects);
}

/// Tests that the page of a Hamiltonian that reads the time has no claims about the energy, and all others.
#[test]
fn a_hamiltonian_that_reads_the_time_has_its_page() {
    let study = driven_study();
    assert_eq!((study.autonomous, study.view.clone()), (false, ["q₁".to_owned(), "p₂".to_owned()]));
    let verdicts = verdicts(&study);
    assert!(verdicts.iter().all(|verdict| !verdict.name.contains("energy")) && verdicts.len() > 10);
    for verdict in &verdicts {
        assert!(verdict.holds(), "{}: {:e}", verdict.name, verdict.measured);
    }
    let drawn = |name: &str| PICTURES.iter().any(|(picture, draw)| *picture == name && draw(&study).is_some());
    assert!(drawn("portraits") && drawn("areas") && !drawn("energy") && !drawn("energy_error"));
}
