//! A Hamiltonian of one's own, added as `docs/examples.md` says: the annotated impl and the row that are printed there.

use crate::{
    SMALL, claims::verdicts, notes::notes, pictures::PICTURES, problem::Problem, study::measure, systems::System,
};
use integrator_core::prelude::*;
use std::{fs, path::Path};

struct Duffing {
    stiffening: f64,
}

#[hamiltonian]
impl Duffing {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0] + 0.25 * self.stiffening * q[0].powi(4)
    }
}

const ROW: System =
    // The row, as it stands in a list.
    System {
        name: "duffing",
        measure: |plan| {
            let problem = Problem {
                system: Duffing { stiffening: 1.0 },
                formula: "H = p²/2 + q²/2 + q⁴/4, from q = 1 at rest", // what the page says of it
                start: Phase::new([1.0], [0.0]),
                period: 4.77, // about how long the slowest motion takes to come around
                step: 0.1,    // the step of portraits and energies: coarse, so that errors are seen
                blob: 0.1,    // the radius of the blob of starts
                view: [0, 1], // what portraits show: positions count first, then momenta
            };
            measure(&problem, plan)
        },
    };

/// A Hamiltonian that reads the time, of two coordinates in a list.
struct Driven;

#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        q.iter().map(|q| 0.5 * q * q - 0.1 * q.cos() * t.sin()).sum()
    }
}

fn driven(view: [usize; 2]) -> Problem<Driven> {
    Problem {
        system: Driven,
        formula: "H = Σ p²/2 + q²/2 − cos q sin t / 10",
        start: Phase::new(vec![1.0, 0.5], vec![0.0, 0.2]),
        period: 6.5,
        step: 0.1,
        blob: 0.1,
        view,
    }
}

#[test]
fn a_view_of_a_coordinate_that_there_is_not_is_refused() {
    let refusal = measure(&driven([0, 4]), &SMALL).err().expect("a refusal").to_string();
    assert_eq!(refusal, "a view of coordinate 4: there are 2 positions, then as many momenta");
}

/// Nothing is claimed of an energy that is not conserved, and the rest holds.
#[test]
fn a_hamiltonian_that_reads_the_time_has_its_page() {
    let study = measure(&driven([0, 3]), &SMALL).expect("measurements");
    let notes = notes(&SMALL).expect("measurements");
    assert_eq!((study.autonomous, study.view.clone()), (false, ["q₁".to_owned(), "p₂".to_owned()]));
    let verdicts = verdicts(&study, &notes);
    assert!(verdicts.iter().all(|verdict| !verdict.name.contains("energy")) && verdicts.len() > 10);
    for verdict in &verdicts {
        assert!(verdict.holds, "{}: {:e}", verdict.name, verdict.value);
    }
    let drawn = |name: &str| {
        PICTURES
            .iter()
            .find(|picture| picture.name == name)
            .is_some_and(|picture| (picture.draw)(&study, &notes).is_some())
    };
    assert!(drawn("portraits") && drawn("areas") && !drawn("energy") && !drawn("energy_error"));
}

#[test]
fn the_system_of_the_examples_has_its_page() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples.md");
    let page = fs::read_to_string(page).expect("a page");
    let own = include_str!("own.rs");
    let printed = own
        .split("struct Duffing")
        .nth(1)
        .and_then(|rest| rest.split("\n/// A Hamiltonian").next())
        .expect("the system");
    for line in printed
        .lines()
        .map(str::trim)
        .filter(|line| line.len() > 8 && !line.contains("ROW") && !line.contains("// The row"))
    {
        assert!(page.contains(line), "docs/examples.md lacks {line:?}");
    }
    let study = ROW.study(&SMALL).expect("measurements");
    assert_eq!(study.system, "duffing");
    for verdict in verdicts(&study, &notes(&SMALL).expect("measurements")) {
        assert!(verdict.holds, "{}: {:e}", verdict.name, verdict.value);
    }
}
