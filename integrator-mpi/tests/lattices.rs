//! Lattices that ranks share have the bits of a run of all their sites.

mod mpirun;
#[allow(dead_code, reason = "the program of the ranks needs more of them")]
#[path = "lattice_systems.rs"]
mod systems;

use integrator_core::{Composition, Coords, prelude::*};
use mpirun::Program;
use systems::*;

const LATTICES: Program = Program("lattice_program", None);

/// Holds what any number of ranks print against a run on this processor.
fn is_a_run<H, C, X>(case: &str, composition: X, sites: usize, slab: fn(&[usize]) -> (H, Phase<C>))
where
    H: Hamiltonian<Coords = C::With<f64>>,
    C: Coords,
    H::Coords: Coords<With<C::Leaf> = C>,
    X: Composition<H>,
{
    let Some(printed) = LATTICES.on_any_number(&[case]) else { return };
    let (system, start) = slab(&(0..sites).collect::<Vec<_>>());
    let mut run = system.run_with(composition, start, 0.05).expect("a run").at_time(0.5);
    let mut lines = printed.lines();
    for portion in [0, 1, STEPS / 2, STEPS - STEPS / 2 - 1] {
        run.advance(portion).expect("finite");
        assert!(lines.next() == Some(&format!("{:?}", run.state())), "{case} after {} steps", run.steps());
        let rest = lines.next().unwrap_or_default();
        let expected = format!(" {:?} {} {} {sites}", run.energy(), run.steps(), run.time());
        assert!(rest.ends_with(&expected), "{case}: {rest}, not{expected}");
    }
}

#[test]
fn a_ring_has_the_bits_of_a_run() {
    is_a_run("ring", Verlet, SITES, ring);
    is_a_run("ring, high order", SofroniouSpaletta8, SITES, ring);
    is_a_run("ring, gradient", Chin4A, SITES, ring);
    is_a_run("ring, processed", TakahashiImada4, SITES, ring);
}

#[test]
fn a_chain_of_masses_between_walls_has_the_bits_of_a_run() {
    is_a_run("chain", Yoshida4, SITES, chain);
}

#[test]
fn a_plane_has_the_bits_of_a_run() {
    is_a_run("plane", Yoshida4, 400, plane);
}

#[test]
fn a_volume_has_the_bits_of_a_run() {
    is_a_run("volume", Yoshida4, 200, volume);
}

#[test]
fn a_checkpoint_is_that_of_a_run_and_resumes_on_any_number_of_ranks() {
    let path = std::env::temp_dir().join(format!("integrator-mpi-lattice-{}.run", std::process::id()));
    let name = path.display().to_string();
    let Some(of_run) = LATTICES.printed(1, &["save a run", &name]) else { return };
    for ranks in 1..=2 {
        let Some(resumed) = LATTICES.printed(ranks, &["resume", &name]) else { return };
        assert!(resumed.lines().nth(1) == of_run.lines().next(), "{ranks} ranks");
    }
    let mut ends = Vec::new();
    for ranks in [1, 3] {
        let Some(saved) = LATTICES.printed(ranks, &["save", &name]) else { return };
        ends.push(saved.strip_prefix("Ok(()), a run: true\n").expect("the checkpoint of a run").to_owned());
    }
    let begin = format!("{} {}\n", STEPS / 2, 0.5 + 0.05 * (STEPS / 2) as f64);
    for ranks in 1..=4 {
        let Some(resumed) = LATTICES.printed(ranks, &["resume", &name]) else { return };
        let end = resumed.strip_prefix(&begin).expect("where it was");
        assert!(ends.iter().all(|other| other == end), "{ranks} ranks");
    }
    let Some(refused) = LATTICES.printed(2, &["resume another", &name]) else { return };
    let lines: Vec<_> = refused.lines().collect();
    assert!(
        lines[0].starts_with("on rank 0: ") && lines[0].contains("composition `Yoshida4`, not `Verlet`"),
        "{refused}"
    );
    assert!(lines[1].starts_with("on rank 0: ") && lines[1].ends_with("not of 1499 sites"), "{refused}");
    std::fs::remove_file(&path).expect("it is there");
    let Some(refused) = LATTICES.printed(2, &["resume", &name]) else { return };
    assert!(refused.starts_with("on rank 0: ") && refused.contains(&name), "{refused}");
}

#[test]
fn a_site_that_diverges_is_named_and_all_stay_at_the_step_before() {
    let Some(printed) = LATTICES.on_any_number(&["runaway"]) else { return };
    let (system, start) = runaway(&(0..SITES).collect::<Vec<_>>());
    let mut run = system.run_with(Verlet, start, 0.01).expect("a run");
    run.advance(40).expect("finite");
    let Err(Error::Diverged(at)) = run.advance(1_000) else { panic!("it stays") };
    let (_, site) = at.coordinate.expect("a site");
    let diverged =
        format!("Err(Diverged {{ site: {site}, step: {}, time: {:?} }}) after {} steps", at.step, at.time, run.steps());
    let lines: Vec<_> = printed.lines().collect();
    assert_eq!(lines[..3], ["Ok(()) after 40 steps", &diverged, &diverged]);
    assert!(lines[3] == format!("{:?}", run.state()));
}

#[test]
fn ends_that_diverge_are_renewed_where_that_helps() {
    is_a_run("high", Verlet, SITES, high);
    let Some(alone) = LATTICES.printed(1, &["growing"]) else { return };
    assert!(alone.starts_with("Ok(()) after 246\n"), "{}", alone.lines().next().unwrap_or_default());
    let (system, start) = growing(&(0..SITES).collect::<Vec<_>>());
    for ranks in 2..=3 {
        let Some(printed) = LATTICES.printed(ranks, &["growing"]) else { return };
        let (outcome, state) = printed.split_once('\n').unwrap_or_default();
        let (error, steps) = outcome.split_once(" after ").unwrap_or_default();
        assert!(error.starts_with("Err(HaloDiverged"), "{outcome}");
        let mut run = system.run_with(Verlet, start.clone(), 0.05).expect("a run");
        run.advance(steps.parse().expect("a number")).expect("finite");
        assert!(state.trim_end() == format!("{:?}", run.state()), "{outcome}");
    }
}

#[test]
fn systems_that_ranks_cannot_share_are_refused() {
    let Some(alone) = LATTICES.printed(1, &["refused"]) else { return };
    let accepted = alone.lines().filter(|line| *line == "accepted").count();
    assert_eq!(accepted, 2, "one rank has no neighbours: {alone}");
    for ranks in 2..=4 {
        let Some(refused) = LATTICES.printed(ranks, &["refused"]) else { return };
        let lines: Vec<_> = refused.lines().collect();
        assert!(lines[0].contains("two ranks disagree about site"), "{refused}");
        assert!(lines[1].starts_with(&format!("5 sites are too few for {ranks} ranks")), "{refused}");
        assert!(lines[2].contains("NaN") && lines[2].starts_with("on rank 0"), "{refused}");
        assert!(lines[3].contains("the initial state has 2 sites"), "{refused}");
        assert!(lines[4].contains("Short` is not a lattice that ranks can share"), "{refused}");
    }
}
