//! Lattices on one rank and on several: one case each, by its name.

#[path = "lattice_systems.rs"]
mod systems;

use integrator_core::{Compensated, Composition, Coords, prelude::*};
use integrator_mpi::{self as cluster, Lattice};
use mpi::traits::Communicator;
use std::fs;
use systems::*;

fn main() {
    let case = std::env::args().nth(1).unwrap_or_default();
    let universe = cluster::start().expect("the first start");
    let world = universe.world();
    match &case[..] {
        "ring" => overlaps(&world, numbers(&world, Verlet, SITES, ring)),
        "ring, high order" => overlaps(&world, numbers(&world, SofroniouSpaletta8, SITES, ring)),
        "ring, gradient" => overlaps(&world, numbers(&world, Chin4A, SITES, ring)),
        "ring, processed" => overlaps(&world, numbers(&world, TakahashiImada4, SITES, ring)),
        "chain" => overlaps(&world, numbers(&world, Yoshida4, SITES, chain)),
        "plane" => overlaps(&world, numbers(&world, Yoshida4, 400, plane)),
        "volume" => overlaps(&world, numbers(&world, Yoshida4, 200, volume)),
        "save" => {
            let mut lattice = Lattice::new(&world, Yoshida4, SITES, 0.05, chain).expect("a lattice").at_time(0.5);
            lattice.advance(STEPS / 2).expect("finite");
            let saved = lattice.checkpoint_to(path());
            let is_a_run = fs::read(path()).is_ok_and(|bytes| bytes == run().checkpoint());
            show(&world, &format!("{saved:?}, a run: {is_a_run}"));
            lattice.advance(STEPS).expect("finite");
            state(&lattice);
        }
        // One whose state was changed from outside.
        "save a run" => {
            let mut run = run();
            run.map_state(|state| state.q = state.q.iter().rev().copied().collect()).expect("finite");
            run.advance(3).expect("finite");
            run.checkpoint_to(path()).expect("a file");
            run.advance(STEPS).expect("finite");
            show(&world, &format!("{:?}", run.state()));
        }
        "resume" => match Lattice::resume(&world, Yoshida4, SITES, chain, path()) {
            Ok(mut lattice) => {
                show(&world, &format!("{} {}", lattice.steps(), lattice.time()));
                lattice.advance(STEPS).expect("finite");
                state(&lattice);
            }
            Err(error) => show(&world, &error.to_string()),
        },
        "resume another" => {
            for error in [
                Lattice::resume(&world, Verlet, SITES, chain, path()).err(),
                Lattice::resume(&world, Yoshida4, SITES - 1, chain, path()).err(),
            ] {
                show(&world, &error.map_or("accepted".to_owned(), |error| error.to_string()));
            }
        }
        "runaway" => {
            let mut lattice = Lattice::new(&world, Verlet, SITES, 0.01, runaway).expect("a lattice");
            for steps in [40, 1_000, 1_000] {
                let outcome = lattice.advance(steps);
                show(&world, &format!("{outcome:?} after {} steps", lattice.steps()));
            }
            state(&lattice);
        }
        // Ends that diverge leave nothing to take while messages travel.
        "high" => drop(numbers(&world, Verlet, SITES, high)),
        "growing" => {
            let mut lattice = Lattice::new(&world, Verlet, SITES, 0.05, growing).expect("a lattice");
            let outcome = lattice.advance(246);
            show(&world, &format!("{outcome:?} after {}", lattice.steps()));
            state(&lattice);
        }
        "refused" => {
            let short = |_: &[usize]| (Short, Phase::new([0.0; 2], [0.0; 2]));
            let reasons = [
                Lattice::new(&world, Verlet, SITES, 0.01, spacing).err(),
                Lattice::new(&world, Verlet, 5, 0.01, ring).err(),
                Lattice::new(&world, Verlet, SITES, f64::NAN, ring).err(),
                Lattice::new(&world, Verlet, SITES, 0.01, |_| ring(&[1, 2])).err(),
                Lattice::new(&world, Verlet, 2, 0.01, short).err(),
            ];
            reasons.iter().for_each(|reason| {
                show(&world, &reason.as_ref().map_or("accepted".to_owned(), ToString::to_string));
            });
        }
        other => panic!("there is no case {other}"),
    }
}

/// A run of the sites of the chain, half of the way.
fn run() -> Run<Vec<Compensated<f64>>> {
    let (system, start) = chain(&(0..SITES).collect::<Vec<_>>());
    let mut run = system.run_with(Yoshida4, start, 0.05).expect("a run").at_time(0.5);
    run.advance(STEPS / 2).expect("finite");
    run
}

/// The file that the second argument names.
fn path() -> String {
    std::env::args().nth(2).unwrap_or_default()
}

fn show(world: &impl Communicator, text: &str) {
    if cluster::is_root(world) {
        println!("{}", text.replace('\n', " | "));
    }
}

fn state<W: Communicator, C: Coords>(lattice: &Lattice<'_, W, C>) {
    if let Some(state) = lattice.state_on_root() {
        println!("{state:?}");
    }
}

/// All that a lattice shows after portions of steps, bit by bit, printed by rank 0; and how many were taken while messages
/// travelled.
fn numbers<H, C, X>(world: &impl Communicator, composition: X, sites: usize, slab: fn(&[usize]) -> (H, Phase<C>)) -> u64
where
    H: Hamiltonian<Coords = C::With<f64>>,
    C: Coords,
    H::Coords: Coords<With<C::Leaf> = C>,
    X: Composition<H>,
{
    let lattice = Lattice::new(world, composition, sites, 0.05, slab).expect("a lattice");
    let mut lattice = lattice.at_time(0.5);
    assert!(lattice.exchanges().is_none_or(|(steps, _)| steps < STEPS), "nothing would be exchanged");
    for portion in [0, 1, STEPS / 2, STEPS - STEPS / 2 - 1] {
        lattice.advance(portion).expect("finite");
        state(&lattice);
        let kinetic = lattice.sum(|site, _, p| (site % 3 == 1).then(|| p.iter().map(|p| p * p).sum()));
        let energy = lattice.energy().expect("an energy");
        show(world, &format!("{kinetic:?} {energy:?} {} {} {}", lattice.steps(), lattice.time(), lattice.len()));
    }
    lattice.overlapped()
}

/// Whether steps were taken while messages travelled, as there have to be where there are messages.
fn overlaps(world: &impl Communicator, steps: u64) {
    assert_eq!(steps > 0, world.size() > 1, "{steps} steps were taken while messages travelled");
}
