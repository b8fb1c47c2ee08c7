//! The laboratory on small runs: its claims hold and can fail, its pictures have their axes, words and curves, and its
//! page stands alone.

#![allow(dead_code, reason = "the example has more to show than the tests look at")]

mod browser;
mod can_fail;
mod files;
mod own;

#[path = "../../examples/laboratory/blob.rs"]
mod blob;
#[path = "../../examples/laboratory/claims.rs"]
mod claims;
#[path = "../../examples/laboratory/errors.rs"]
mod errors;
#[path = "../../examples/laboratory/measured.rs"]
mod measured;
#[path = "../../examples/laboratory/methods.rs"]
mod methods;
#[path = "../../examples/laboratory/notes.rs"]
mod notes;
#[path = "../../examples/laboratory/oscillator.rs"]
mod oscillator;
#[path = "../../examples/laboratory/page.rs"]
mod page;
#[path = "../../examples/laboratory/period.rs"]
mod period;
#[path = "../../examples/laboratory/pictures/mod.rs"]
mod pictures;
#[path = "../../examples/laboratory/plan.rs"]
mod plan;
#[path = "../../examples/laboratory/problem.rs"]
mod problem;
#[path = "../../examples/laboratory/section.rs"]
mod section;
#[path = "../../examples/laboratory/shifted.rs"]
mod shifted;
#[path = "../../examples/laboratory/study.rs"]
mod study;
#[path = "../../examples/laboratory/systems.rs"]
mod systems;
#[path = "../../examples/laboratory/write.rs"]
mod write;

use claims::{CLAIMS, verdicts};
use notes::notes;
use oscillator::CLOSED_FORMS;
use plan::Plan;
use std::{
    env,
    path::{Path, PathBuf},
};
use systems::SYSTEMS;

/// Enough of everything for claims to hold and for pictures to show what they show.
const SMALL: Plan = Plan { periods: 4.0, outline: 64, rungs: 5, crossings: 20 };

/// A folder of this process for pictures.
fn folder(name: &str) -> PathBuf {
    env::temp_dir().join(format!("integrator-laboratory-{}-{name}", std::process::id()))
}

/// The claims that people look for by name.
const PROMISED: [&str; 12] = [
    "forward_euler_energy_grows",
    "backward_euler_energy_decays",
    "symplectic_euler_bracket_is_one",
    "forward_euler_bracket_is_not_one",
    "leapfrog_order_2",
    "verlet_order_2",
    "midpoint_order_2",
    "rk4_order_4",
    "yoshida4_order_4",
    "oscillator_closed_forms",
    "verlet_equals_shifted_leapfrog",
    "pendulum_period",
];

#[test]
fn every_claim_holds_for_every_system() {
    let notes = notes(&SMALL).expect("measurements");
    for system in SYSTEMS {
        let study = system.study(&SMALL).expect("measurements");
        let verdicts = verdicts(&study, &notes);
        assert_eq!(verdicts.len(), CLAIMS.len());
        for verdict in &verdicts {
            assert!(verdict.holds, "{} on {}: {:e}", verdict.name, system.name, verdict.value);
        }
        for name in PROMISED {
            assert!(verdicts.iter().any(|verdict| verdict.name == name), "no claim is called {name}");
        }
    }
}

/// The closed forms are those of the methods, and the distances of one method are not those of another.
#[test]
fn the_oscillator_has_closed_forms() {
    for form in &CLOSED_FORMS {
        let distance = form.distance().expect("finite states");
        assert!(distance < claims::CLOSED, "{}: {distance:e}", form.name);
        let (growth, grows) = (form.growth(), ["forward Euler", "explicit midpoint"].contains(&form.name));
        let decays = ["backward Euler", "Runge–Kutta 4"].contains(&form.name);
        assert_eq!((growth > 1.0 + 1e-12, growth < 1.0 - 1e-12), (grows, decays), "{}: {growth}", form.name);
    }
}

/// Small angles swing like the oscillator, and the period grows with the angle as its series says.
#[test]
fn the_period_of_the_pendulum_is_the_elliptic_integral() {
    for amplitude in [1e-3, 0.1, 0.5_f64] {
        let series = 1.0 + amplitude.powi(2) / 16.0 + 11.0 * amplitude.powi(4) / 3072.0;
        let relative = period::exact(amplitude) / std::f64::consts::TAU / series - 1.0;
        // The next term is 173 a⁶ / 737280.
        assert!(relative.abs() < 3e-4 * amplitude.powi(6) + 4.0 * f64::EPSILON, "{amplitude}: {relative:e}");
    }
    // 4 K(sin 1), to fifteen digits by mpmath.
    assert!((period::exact(period::AMPLITUDE) - PERIOD).abs() < 1e-14);
}

const PERIOD: f64 = 8.349_752_926_918_495;

/// The invariant of an ellipse is its area, whatever plane it lies in.
#[test]
fn the_invariant_is_the_area() {
    let circle = |freedom: usize, plane: usize| -> Vec<Vec<f64>> {
        let point = |k: usize| {
            let (sine, cosine) = (std::f64::consts::TAU * k as f64 / 64.0).sin_cos();
            let mut state = vec![0.3; 2 * freedom];
            state[plane] += 2.0 * cosine;
            state[freedom + plane] -= 0.5 * sine;
            state
        };
        (0..64).map(point).collect()
    };
    for (freedom, plane) in [(1, 0), (2, 0), (3, 2)] {
        let area = blob::invariant(&circle(freedom, plane), freedom);
        assert!((area - std::f64::consts::PI).abs() < 1e-12, "{area}");
    }
}

#[test]
fn coordinates_have_names_however_many_there_are() {
    let names =
        [(0, 1), (1, 1), (0, 2), (3, 2), (11, 12), (23, 12)].map(|(index, freedom)| problem::name(index, freedom));
    assert_eq!(names, ["q", "p", "q₁", "p₂", "q₁₂", "p₁₂"]);
}

fn exists(file: &Path) -> bool {
    file.metadata().is_ok_and(|file| file.len() > 1_000)
}
