//! The systems of the laboratory on small runs: their claims hold and can fail, their pages stand alone and have a picture
//! and a row for whatever was measured. What is common to all systems is tested in `integrator-laboratory`.

mod browser;
mod pages;

#[path = "../../../examples/laboratory/arguments.rs"]
mod arguments;
#[path = "../../../examples/laboratory/oscillator.rs"]
mod oscillator;
#[path = "../../../examples/laboratory/period.rs"]
mod period;
#[path = "../../../examples/laboratory/section.rs"]
mod section;
#[path = "../../../examples/laboratory/stiff.rs"]
mod stiff;
#[path = "../../../examples/laboratory/systems.rs"]
mod systems;

use integrator_laboratory::{Plan, Report};
use std::{env, fs, sync::OnceLock, thread};
use systems::{SYSTEMS, System};

/// What was written of a system.
struct Written {
    system: &'static str,
    report: Report,
    page: String,
}

/// The pages of all systems, written once and side by side. They are read, and no file is left.
fn written() -> &'static [Written] {
    static WRITTEN: OnceLock<Vec<Written>> = OnceLock::new();
    WRITTEN.get_or_init(|| {
        let folder = env::temp_dir().join(format!("integrator-laboratory-{}", std::process::id()));
        let write = &|system: &System| {
            let report = (system.report)(&Plan::SMALL, &folder).expect("a page");
            let page = fs::read_to_string(&report.page).expect("a page");
            Written { system: system.name, report, page }
        };
        let written = thread::scope(|scope| {
            let pages: Vec<_> = SYSTEMS.iter().map(|system| scope.spawn(move || write(system))).collect();
            pages.into_iter().map(|page| page.join().expect("no panic")).collect()
        });
        fs::remove_dir_all(&folder).expect("the folder of the pages");
        written
    })
}

/// The claims that people look for by name.
const PROMISED: [&str; 18] = [
    "forward_euler_energy_grows",
    "backward_euler_energy_decays",
    "symplectic_euler_bracket_is_one",
    "forward_euler_bracket_is_not_one",
    "leapfrog_order_2",
    "verlet_order_2",
    "midpoint_order_2",
    "rk4_order_4",
    "yoshida4_order_4",
    "verlet_equals_shifted_leapfrog",
    "runge_kutta_4_energy_changes",
    "chin_4a_order_4",
    "taylor_follows_its_tolerance",
    "each_column_of_the_extrapolation_gains_two_orders",
    "the_extrapolation_ends_in_gragg_bulirsch_stoer",
    "eigenvalues_have_closed_forms",
    "runge_kutta_4_loses_h6_over_72",
    "taylor_steps_are_a_share_of_the_radius",
];

/// Claims of one system alone, which no other page has.
const OWN: [(&str, &str); 4] = [
    ("oscillator", "verlet_stability_limit"),
    ("pendulum", "pendulum_period"),
    ("henon_heiles", "crossings_lie_on_the_section"),
    ("stiff", "implicit_midpoint_stays"),
];

#[test]
fn every_claim_is_verified_for_every_system() {
    for Written { system, report, .. } in written() {
        for claim in &report.claims {
            assert!(claim.holds(), "{} on {system}: {:e}", claim.name, claim.measured);
        }
        let has = |name: &str| report.claims.iter().any(|claim| claim.name == name);
        for name in PROMISED {
            assert_eq!(has(name), *system != "stiff", "{name} on {system}");
        }
        for (of, name) in OWN {
            assert_eq!(has(name), of == *system, "{name} on {system}");
        }
    }
}

#[test]
fn every_page_stands_alone() {
    for Written { system, report, page } in written() {
        // Names of XML are no references.
        for attribute in ["src=\"", "href=\"", "url("] {
            for reference in page.split(attribute).skip(1) {
                let inside = ["data:", "#"].iter().any(|inside| reference.trim_start_matches('"').starts_with(inside));
                assert!(inside, "{system}: {attribute}{}", reference.chars().take(60).collect::<String>());
            }
        }
        for element in ["<script", "<link", "<iframe", "@import"] {
            assert!(!page.contains(element), "{system}: {element}");
        }
        assert_eq!(page.matches("<tr id=").count(), report.claims.len(), "{system}: a row for each claim");
        assert!(page.contains("<p>H = ") && !page.contains("\"FAILED\""), "{system}: the page says what was studied");
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
    // Without short steps, the claim does not hold.
    let mut periods = period::all(5);
    periods.iter_mut().for_each(|row| row.errors.retain(|(h, _)| *h > 0.3));
    assert!(!period::claim(&periods).holds());
}

const PERIOD: f64 = 8.349_752_926_918_495;

#[test]
fn names_that_are_nearly_right_are_suggested() {
    let asked = |arguments: &[&str]| arguments::command().try_get_matches_from([&["laboratory"], arguments].concat());
    let refusal = asked(&["pendulm"]).expect_err("no such system").to_string();
    assert!(refusal.contains("'pendulum'") && refusal.contains("similar"), "{refusal}");
    let help = asked(&["--help"]).expect_err("help ends the program").to_string();
    assert!(SYSTEMS.iter().all(|system| help.contains(system.name)) && help.contains("--out"), "{help}");
    let matches = asked(&[]).expect("nothing has to be said");
    assert_eq!(matches.get_one::<String>("SYSTEM").map(String::as_str), Some("pendulum"));
}
