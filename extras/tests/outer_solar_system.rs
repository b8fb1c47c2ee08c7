//! The outer solar system of the examples, held against its independent reference.

#[path = "../../examples/outer_solar_system/pictures.rs"]
mod pictures;
#[path = "../../examples/outer_solar_system/system.rs"]
mod system;

use integrator_core::prelude::*;
use std::fs;
use system::{angular_momentum, measured, norm, reference, relative};

const DAYS: f64 = 999_999.0;
const STEPS: u64 = 1 << 18;

/// What is conserved stays, and the planets arrive where 113-bit arithmetic finds them.
#[test]
fn the_planets_arrive_at_the_reference() {
    let (system, start) = measured().expect("the table of the examples");
    let run = system.run(start, DAYS / STEPS as f64).expect("a run");
    let (energy, momentum) = (run.energy(), angular_momentum(&start));
    let (mut energy_error, mut momentum_error, mut end) = (0.0_f64, 0.0_f64, start);
    for sample in run.samples(1024).take((STEPS / 1024 + 1) as usize) {
        let sample = sample.expect("a finite state");
        energy_error = energy_error.max(((sample.energy() - energy) / energy).abs());
        momentum_error = momentum_error.max(relative(&angular_momentum(&sample.state), &momentum));
        end = sample.state;
    }
    // Yoshida4 with steps of 3.8 days: the energy oscillates by 6e-11. Its frequencies are off by 8e-10, which moves
    // Jupiter, the fastest, by 6e-6 AU in 230 revolutions, 1.2e-7 of the length of all positions. The limits leave room
    // for other roundings, not for another order.
    assert!(energy_error < 3e-10, "the energy changes by {energy_error:e}");
    let position_error = relative(end.q.as_flattened(), &reference().expect("a reference"));
    assert!(position_error < 1e-6, "the planets miss by {position_error:e}");
    // Drifts and kicks conserve the angular momentum exactly; each of the 1.6 million flows rounds it by an ulp or so, at
    // random, and the root of their number is 1250.
    assert!(momentum_error < 1e-11, "the angular momentum changes by {momentum_error:e}");
}

#[test]
fn the_stepper_is_certified() {
    let (system, start) = measured().expect("the table of the examples");
    let certificate = certify(&system, Yoshida4, start, DAYS / STEPS as f64).expect("a certificate");
    assert!(certificate.symplectic_defect < 1e-12, "{certificate}");
    assert!((3.9..4.1).contains(&certificate.observed_order), "{certificate}");
}

/// The later in the list of compositions, the less the error, and none rises.
#[test]
fn the_pictures_show_what_they_claim() {
    let (system, start) = measured().expect("the table of the examples");
    let folder = std::env::temp_dir().join(format!("integrator-solar-{}", std::process::id()));
    pictures::orbits(&system, start, &folder).expect("a picture");
    let curves = pictures::energies(&system, start, &folder).expect("a picture");
    let worst = |decades: &[(f64, f64)]| decades.iter().map(|(_, error)| *error).fold(0.0, f64::max);
    let mut least = f64::INFINITY;
    for (name, decades) in curves {
        assert!(worst(&decades) < 0.5 * least, "{name}: {:e} after {least:e}", worst(&decades));
        least = worst(&decades);
        let (early, late) = decades.split_at(decades.len() / 2);
        assert!(worst(late) < 2.0 * worst(early), "{name}: from {:e} to {:e}", worst(early), worst(late));
    }
    let [orbits, energy] = ["orbits", "energy"].map(|name| {
        let file = folder.join(format!("outer_solar_system_{name}"));
        assert!(fs::metadata(file.with_extension("png")).expect("a picture").len() > 10_000);
        fs::read_to_string(file.with_extension("svg")).expect("text")
    });
    for (text, words) in [(&orbits, ["Pluto", "x in AU", "Sun"]), (&energy, ["Verlet, order 2", "Teloy8C", "years"])] {
        assert!(words.iter().all(|word| text.contains(word)), "{words:?} in {text}");
        // At least a curve for each planet, and for each of the compositions.
        assert!(text.matches("<polyline").count() >= 5);
    }
    fs::remove_dir_all(folder).expect("the folder");
}

/// The table and the reference state the same measurements.
#[test]
fn the_two_files_agree() {
    let (system, start) = measured().expect("the table of the examples");
    let problems: serde_json::Value =
        serde_json::from_str(include_str!("../../examples/data/problems.json")).expect("JSON");
    let numbers = |name: &str| -> Vec<f64> {
        serde_json::from_value(problems["problems"]["solar"][name].clone()).expect("a list of numbers")
    };
    // The two files were written by different programs, each to 16 digits or more.
    let same = |a: &[f64], b: &[f64]| a.len() == b.len() && relative(a, b) < 4.0 * f64::EPSILON;
    let velocities: Vec<f64> = start.p.iter().zip(system.masses).flat_map(|(p, mass)| p.map(|p| p / mass)).collect();
    assert!(same(&system.masses, &numbers("m")));
    assert!(same(start.q.as_flattened(), &numbers("q")));
    assert!(same(&velocities, &numbers("p")));
    // Both are barycentric: the bodies together do not move.
    let total = [0, 1, 2].map(|axis| start.p.iter().map(|p| p[axis]).sum::<f64>());
    assert!(norm(&total) < 1e-12 * norm(start.p.as_flattened()), "{total:?}");
}

/// Neighbours leave the planets in proportion to time for 2,700 years: the exponent, of the order of 1e-7 a year (Sussman and Wisdom
/// 1988, Science 241, 433), does not show before millions of years.
#[test]
fn the_planets_look_regular_for_a_while() {
    let (system, start) = measured().expect("the table of the examples");
    // Jupiter, pulled ahead.
    let mut vector = Phase::new([[0.0; 3]; 6], [[0.0; 3]; 6]);
    vector.q[1] = start.p[1].map(|p| p / norm(&start.p[1]));
    let mut tangent = system.tangent(BlanesMoanSrkn11, start, [vector], 200.0).expect("a start");
    let mut length_after = |steps: u64| {
        tangent.advance(steps - tangent.steps()).expect("finite vectors");
        norm(tangent.vectors()[0].q.as_flattened())
    };
    let [early, late] = [1_250, 5_000].map(&mut length_after);
    // Four times the time; what swings with the orbits stays below as much again. An exponent of 1e-3 a year would make it
    // seven times as much.
    assert!((2.0..8.0).contains(&(late / early)), "{early} and {late}");
}
