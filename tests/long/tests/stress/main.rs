//! The short version of `cargo bench -p integrator-bench --bench stress`.

use integrator_bench::problems::HenonHeiles;
use integrator_core::prelude::*;
use std::{env, io, process::Command};

#[path = "../../../../benches/stress/brouwer.rs"]
mod brouwer;
#[path = "../../../../benches/stress/chaos.rs"]
mod chaos;
#[path = "../../../../benches/stress/encounters.rs"]
mod encounters;
#[path = "../../../../benches/stress/hostile.rs"]
mod hostile;
#[path = "../../../../benches/stress/interruption.rs"]
mod interruption;
#[path = "../../../../benches/stress/limits.rs"]
mod limits;
#[path = "../../../../benches/stress/reversal.rs"]
mod reversal;

use limits::Outcome;

/// Returns a function that starts this program again for one of the tests.
fn again(test: &'static str) -> impl Fn() -> io::Result<Command> {
    move || {
        let mut command = Command::new(env::current_exe()?);
        command.args(["--exact", test, "--nocapture"]);
        Ok(command)
    }
}

#[test]
fn steps_through_the_limit_are_stable_below_and_reported_above() {
    let trials = limits::trials(&[0.1, 0.7, 1.3, 1.9, 2.5], 2_000);
    let wrong: Vec<_> = trials.iter().filter(|trial| trial.is_wrong()).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
    // Beyond 2, Verlet's tangent map grows by 4 per step and overflows after 512 steps.
    let verlet = trials.iter().find(|trial| trial.composition == "Verlet" && trial.angle == 2.5);
    assert_eq!(verlet.map(|trial| trial.outcome), Some(Outcome::Reported));
}

/// In `f32`, where rounding is visible after a few thousand steps.
#[test]
fn rounding_walks() {
    let stars = (0..16).map(|member| (HenonHeiles, Phase::new([0.0_f32, 0.1 + 0.005 * member as f32], [0.3, 0.05])));
    let swarm = Ensemble::new(BlanesMoan6, stars, 0.1).expect("members");
    let growth = brouwer::growth(swarm, 1 << 14).expect("finite");
    // With sixteen walks, the relative error of the root mean square is 1/6 at each sample. Over a factor of 2^9 in the
    // number of steps, this changes the exponent by 0.04. A bias has the exponent 1; constant errors have 0.
    assert!((growth.exponent - 0.5).abs() < 0.2, "{} {:?}", growth.exponent, growth.looks);
    assert!(growth.bias.abs() < 4.0, "{}", growth.bias);
}

/// A decreasing force, so that the energy of the ensemble decreases.
#[test]
fn a_bias_is_seen() {
    struct Draining;
    #[hamiltonian]
    impl Draining {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1], t: f64) -> f64 {
            0.5 * (1.0 - 1e-9 * t) * q[0] * q[0]
        }
    }
    let members = (0..16).map(|member| (Draining, Phase::new([1.0 + 0.1 * f64::from(member)], [0.0])));
    let growth = brouwer::growth(Ensemble::new(Yoshida6, members, 0.05).expect("members"), 1 << 14).expect("finite");
    assert!((growth.exponent - 1.0).abs() < 0.2 && growth.bias.abs() > 4.0, "{} {}", growth.exponent, growth.bias);
}

#[test]
fn close_encounters_and_extreme_numbers_are_right() {
    for encounter in encounters::resolved(10_000) {
        assert!(encounter.is_right(), "{encounter}");
    }
}

#[test]
fn steps_too_long_for_an_encounter_are_reported() {
    // Certification at such a large step takes seconds, so there is one case of each kind.
    for encounter in encounters::unresolved(4_000, &[1.0 / 1024.0], &[0.01]) {
        assert!(!encounter.is_silently_wrong(), "{encounter}");
    }
}

#[test]
fn symmetric_compositions_return() {
    let returns = reversal::returns(500).expect("finite");
    for found in &returns {
        assert_eq!(found.bits_lost, 0, "{}", found.composition);
        // The orbit stretches in proportion to its time, 50; each of a thousand steps has a few dozen rounding errors.
        let bound = 50.0 * 1000.0 * 40.0 * f64::EPSILON;
        assert!(found.distance < bound, "{}: {:e}", found.composition, found.distance);
        assert!(found.distance > 0.0, "{}: or the grid would be for nothing", found.composition);
    }
    assert!(returns.len() > 20, "{}", returns.len());
}

#[test]
fn chaos_has_the_same_bits_where_they_are_promised() {
    if chaos::answer() {
        return;
    }
    assert_eq!(chaos::members_differing(300).expect("finite"), 0);
    let again = again("chaos_has_the_same_bits_where_they_are_promised");
    assert_eq!(chaos::sets_differing(10_000, again).expect("processes"), 0);
}

#[test]
fn killed_runs_resume_and_damaged_files_are_refused() {
    if interruption::answer() {
        return;
    }
    let again = again("killed_runs_resume_and_damaged_files_are_refused");
    assert_eq!(interruption::failures(10, again).expect("processes"), 0);
    assert_eq!(interruption::damaged_accepted(401).expect("finite"), 0);
}

#[test]
fn nothing_panics() {
    assert_eq!(hostile::panics(100), 0);
}
