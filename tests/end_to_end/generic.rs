//! Code that is generic over the system: precisions follow from starts, nobody names one.

use crate::systems::{henon_heiles, pendulum};
use integrator_core::{
    Coords, Differentiable, InLanes, Memoryless, Method,
    chaos::{self, Indicator},
    check::observed_order,
    prelude::*,
};

/// The energies by a method and by the annotated one, and the first position of a compensated run.
fn sweep<H: Hamiltonian, X: Composition<H>>(
    system: &H,
    method: X,
    start: Phase<H::Coords>,
    h: f64,
) -> Result<[f64; 3], Error> {
    let mut by_method = system.run_with(method, start.clone(), h)?;
    by_method.advance(10)?;
    let mut annotated = system.run(start.clone(), h)?;
    annotated.advance(10)?;
    let mut compensated = system.run_with(method, Phase::compensated(start.q, start.p), h)?;
    compensated.advance(10)?;
    Ok([by_method.energy(), annotated.energy(), compensated.state().to_f64().q.flat()[0]])
}

/// What is measured of a method, from a point alone and from one at a time.
fn measured<H, X>(system: &H, method: X, start: &Phase<H::Coords>, h: f64) -> [f64; 2]
where
    H: Hamiltonian,
    X: Memoryless<H> + Differentiable<H>,
{
    let order = observed_order(system, method, start, h).expect("an order").slope;
    let later = observed_order(system, method, start.clone().at_time(1.0), h).expect("an order").slope;
    chaos::indicators(system, method, start, h, 1_000).expect("an orbit");
    chaos::lyapunov_spectrum(system, method, start, h, 1_000).expect("an orbit");
    chaos::map(system, method, [start.clone()], h, 1_000, Indicator::Fli).expect("an orbit");
    system.tangent(method, start.clone(), [start.clone()], h).expect("a vector").advance(10).expect("finite");
    [order, later]
}

/// The energies after ten steps of a sample, and of each member of an ensemble.
fn shown<H, X>(system: &H, method: X, start: &Phase<H::Coords>, h: f64) -> Result<[f64; 4], Error>
where
    H: Hamiltonian + Clone,
    X: InLanes<H>,
{
    let sample = system.run_with(method, start.clone(), h)?.samples(10).nth(1).expect("a run goes on")?;
    let mut swarm = Ensemble::new(method, (0..3).map(|_| (system.clone(), start.clone())), h)?;
    swarm.advance(10)?;
    let [first, second, third] = [0, 1, 2].map(|member| swarm.energy(member).expect("three members"));
    Ok([sample.energy(), first, second, third])
}

/// A run in the precision of its start, whatever this is.
fn in_any_precision<H, X, C>(system: &H, method: X, start: Phase<C>, h: f64) -> Result<Run<C>, Error>
where
    H: Hamiltonian,
    X: Method<H>,
    C: Coords,
    H::Coords: Coords<With<C::Leaf> = C>,
{
    system.run_with(method, start, h)
}

#[test]
fn precisions_follow_from_starts() -> Result<(), Error> {
    let problem = pendulum();
    let (q, p) = problem.start;
    let (system, start) = (problem.system, Phase::new(q, p));
    let [by_method, annotated, compensated] = sweep(&system, Yoshida4, start, 0.01)?;
    let mut run = system.run_with(Yoshida4, start, 0.01)?;
    run.advance(10)?;
    assert_eq!(by_method, run.energy());
    assert!((annotated - by_method).abs() < 1e-3 * by_method.abs());
    assert!((compensated - run.state().q[0]).abs() < 1e-12);
    for order in measured(&system, Verlet, &start, 0.01) {
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }
    let single = in_any_precision(&system, Verlet, Phase::new(q.map(|q| q as f32), p.map(|p| p as f32)), 0.01)?;
    assert_eq!(single.state().q[0], q[0] as f32);
    // Turbofish names the precision first, as it did before this was inferred.
    assert_eq!(system.run_with::<f64, Verlet>(Verlet, start, 0.01)?.state(), start);
    Ok(())
}

#[test]
fn samples_and_members_are_shown_alike() -> Result<(), Error> {
    #[derive(Clone)]
    struct Rotors;

    #[hamiltonian]
    impl Rotors {
        fn kinetic(&self, p: &[f64]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum::<f64>()
        }
        fn potential(&self, q: &[f64]) -> f64 {
            q.iter().map(|q| 1.0 - q.cos()).sum::<f64>()
        }
    }
    // What `collect` makes is said by the system.
    let angles = [0.5, 1.0, 1.5];
    let run = Rotors.run(Phase::new(angles.into_iter().collect(), vec![0.0; 3]), 0.1)?;
    let [sample, members @ ..] = shown(&Rotors, Verlet, &run.state(), 0.1)?;
    assert_eq!(members, [sample; 3]);
    assert_ne!(sample, run.energy(), "it moved");
    Ok(())
}

#[test]
fn a_borrowed_run_continues_with_the_same_bits() -> Result<(), Error> {
    let problem = henon_heiles();
    let (q, p) = problem.start;
    let run = problem.system.run_with(Yoshida4, Phase::new(q, p), 0.1)?;
    let section = |state: &Phase<[f64; 2]>, _: f64| state.q[0];
    let mut lent = run.clone();
    let states: Result<Vec<_>, _> = lent.by_ref().samples(7).take(5).collect();
    assert_eq!(lent.steps(), 28);
    let found = lent.by_ref().crossings(100, Direction::Either, section).next().expect("a crossing")?;
    let between = lent.steps();
    let at: Result<Vec<_>, _> = lent.by_ref().samples_at(0.25).take(3).collect();
    assert_eq!(at?[2].time, 0.1 * between as f64 + 0.5);

    let mut own = run.samples(7);
    for state in states? {
        assert_eq!(state.state, own.next().expect("a sample")?.state);
    }
    let mut own = own.into_run().crossings(100, Direction::Either, section);
    assert_eq!(own.next().expect("a crossing")?.state, found.state);
    let mut own = own.into_run();
    assert_eq!(own.steps(), between);
    let steps = 500 - between;
    own.advance(steps)?;
    lent.advance(500 - lent.steps())?;
    assert_eq!(own.state(), lent.state());
    Ok(())
}
