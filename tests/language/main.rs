//! The language of H at work: every construct that `docs/language.md` lists as accepted moves a system as a force written
//! by hand does. That the rest is refused, and how, is tested beside the generator.
#![allow(
    clippy::explicit_iter_loop,
    dead_code,
    unused_variables,
    clippy::all,
    reason = "a row shows one construct, not the shortest way to write it, and reads what it needs"
)]

mod absent;
mod coordinates;
mod integers;
mod rows;

use integrator_core::{__private::Motion, Coords, Hamiltonian, Phase};

/// Where forces are compared; no two coordinates are alike, and every branch of the rows is decided clearly.
const START: [f64; 4] = [0.4, -0.3, 0.7, 0.2];

/// When forces are compared.
const TIME: f64 = 0.25;

/// A part of a system with values of its own.
struct Cell {
    edge: f64,
    sides: [f64; 2],
}

/// Laws of which a system has one.
enum Kind {
    Free,
    Spring(f64),
    Listed { list: Vec<f64>, at: usize },
}

/// Compares numbers that two formulas give. They are of order one (powers and degrees reach 60) and take some ten
/// roundings each, so that 64 units of the last place of the largest number are as many as both could lose.
#[track_caller]
fn close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(1.0, |largest: f64, x| largest.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let distance = (found - expected).abs();
        assert!(distance <= 64.0 * f64::EPSILON * largest, "{found} for {expected}");
    }
}

/// Returns the gradient of the potential, by one kick from rest, and the generated potential at the start.
///
/// A row shows a construct, so that it compiles the flow of a system and none of its steppers: a run of each row takes
/// rustc four times as long.
fn kicked<H: Hamiltonian>(system: &H, start: H::Coords, time: f64) -> (Vec<f64>, f64)
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut state = Phase { p: start.map(|_| 0.0), q: start };
    let parameters = system.parameters(state.q.length());
    let mut motion = H::Motion::<f64, f64>::load(&[&parameters], &[&state]);
    let energy = H::potential::<f64, f64>(&motion, time);
    H::kick::<f64, f64>(&mut motion, -1.0, time);
    motion.store(0, &mut state);
    (state.p.flat().to_vec(), energy)
}

/// What is documented is what is tested: each accepted example stands in this folder, but for white space and commas.
#[test]
fn every_accepted_example_is_run() {
    let plain = |text: &str| text.replace([' ', '\n', ','], "");
    let tested = plain(include_str!("rows.rs")) + &plain(include_str!("coordinates.rs"));
    let document = include_str!("../../docs/language.md");
    let (_, accepted) = document.split_once("## Accepted").expect("a section");
    let (accepted, _) = accepted.split_once("## Refused").expect("a section");
    let examples = accepted.lines().filter(|line| line.ends_with("` |")).map(|line| {
        let (_, example) = line.trim_end_matches("` |").split_once(" | `").expect("two columns");
        example.replace("\\|", "|")
    });
    let mut count = 0;
    for example in examples {
        assert!(tested.contains(&plain(&example)), "not tested: {example}");
        count += 1;
    }
    assert!(count > 80, "the rows are found: {count}");
}
