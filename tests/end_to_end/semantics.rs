//! Promises about a run that hold bit for bit: counted time, portions, samples, copies, starts elsewhere in time.

use crate::{
    catalogue::for_each_composition,
    systems::{Chain, henon_heiles, pendulum},
};
use integrator_core::prelude::*;

/// Fails to compile unless a run can be handed to another thread and stored without naming its system.
struct Stored {
    runs: Vec<Run<[f64; 2]>>,
}

fn assert_send<T: Send + Sync>(_: &T) {}

fn galaxy<X: Composition<crate::systems::HenonHeiles>>(composition: X, h: f64) -> Run<[f64; 2]> {
    let problem = henon_heiles();
    let (q, p) = problem.start;
    problem.system.run_with(composition, Phase::new(q, p), h).expect("an admissible start")
}

#[test]
fn a_run_can_be_stored_and_sent() {
    let stored = Stored { runs: vec![galaxy(Verlet, 0.01), galaxy(KahanLi8, 0.1)] };
    assert_send(&stored.runs);
    let ends: Vec<f64> = std::thread::scope(|scope| {
        let threads = stored.runs.into_iter().map(|mut run| {
            scope.spawn(move || {
                run.advance(100).expect("finite");
                run.time()
            })
        });
        threads.collect::<Vec<_>>().into_iter().map(|thread| thread.join().expect("no panic")).collect()
    });
    assert_eq!(ends, [1.0, 10.0]);
}

#[test]
fn the_annotated_composition_runs_and_verlet_where_there_is_none() {
    let problem = pendulum();
    let start = Phase::new(problem.start.0, problem.start.1);
    let mut annotated = problem.system.run(start, 0.01).expect("an admissible start");
    let mut named = problem.system.run_with(Yoshida4, start, 0.01).expect("an admissible start");
    annotated.advance(100).expect("finite");
    named.advance(100).expect("finite");
    assert_eq!(annotated.state(), named.state());

    let problem = henon_heiles();
    let start = Phase::new(problem.start.0, problem.start.1);
    let mut annotated = problem.system.run(start, 0.01).expect("an admissible start");
    let mut named = galaxy(Verlet, 0.01);
    annotated.advance(100).expect("finite");
    named.advance(100).expect("finite");
    assert_eq!(annotated.state(), named.state());
}

#[test]
fn time_is_counted_not_summed() {
    let mut run = galaxy(Euler, 0.001).at_time(0.7);
    let mut summed = 0.7;
    let mut steps = 0_u32;
    for portion in [1, 7, 10_000, 20_000] {
        run.advance(portion.into()).expect("finite");
        for _ in 0..portion {
            summed += 0.001;
        }
        steps += portion;
        assert_eq!(run.time(), 0.7 + f64::from(steps) * 0.001);
        assert_eq!(run.steps(), steps.into());
    }
    assert_ne!(run.time(), summed, "this many steps tell the two apart");
}

#[test]
fn no_steps_change_nothing() {
    let problem = henon_heiles();
    let mut run = galaxy(Yoshida6, 0.1);
    run.advance(0).expect("finite");
    assert_eq!(run.state(), Phase::new(problem.start.0, problem.start.1));
    assert_eq!((run.time(), run.steps(), run.step()), (0.0, 0, 0.1));
    run.advance(3).expect("finite");
    let before = run.state();
    run.advance(0).expect("finite");
    assert_eq!(run.state(), before);
}

/// Portions that end inside, on and behind the blocks of steps between two looks at whether the state is finite.
const PORTIONS: [&[u64]; 6] =
    [&[2500], &[1; 2500], &[1, 2499], &[2499, 1], &[1024, 1024, 452], &[0, 700, 0, 1, 1023, 776]];

#[test]
fn portions_do_not_change_a_bit() {
    fn check<X: Composition<crate::systems::HenonHeiles>>(composition: X) {
        let end = |portions: &[u64]| {
            let mut run = galaxy(composition, 0.05).at_time(0.3);
            for portion in portions {
                run.advance(*portion).expect("finite");
            }
            (run.state(), run.time(), run.energy())
        };
        for portions in PORTIONS {
            assert_eq!(portions.iter().sum::<u64>(), 2500, "the portions make the same run");
            assert_eq!(end(portions), end(&[2500]), "{} in {portions:?}", X::NAME);
        }
    }
    macro_rules! each {
        ($($composition:ident)*) => {
            $(check($composition);)*
        };
    }
    for_each_composition!(general_kinds: each!);
    for_each_composition!(quadratic_kinds: each!);
}

#[test]
fn portions_do_not_change_a_bit_of_compensated_states() {
    let problem = pendulum();
    let start = Phase::compensated(problem.start.0, problem.start.1);
    let end = |portions: &[u64]| {
        let mut run = problem.system.run(start, 0.01).expect("an admissible start");
        for portion in portions {
            run.advance(*portion).expect("finite");
        }
        run.state()
    };
    for portions in PORTIONS {
        assert_eq!(end(portions), end(&[2500]), "in {portions:?}");
    }
}

#[test]
fn reading_the_state_does_not_change_a_bit() {
    fn check<X: Composition<crate::systems::HenonHeiles>>(composition: X) {
        let mut unseen = galaxy(composition, 0.05);
        unseen.advance(1200).expect("finite");

        let mut watched = galaxy(composition, 0.05);
        for _ in 0..1200 {
            watched.advance(1).expect("finite");
            let _ = (watched.state(), watched.energy(), watched.time(), watched.clone(), format!("{watched:?}"));
        }
        assert_eq!(watched.state(), unseen.state(), "{}", X::NAME);

        let samples: Vec<_> =
            galaxy(composition, 0.05).samples(300).take(5).map(|sample| sample.expect("finite")).collect();
        let last = samples.last().expect("five samples");
        assert_eq!((last.state, last.step, last.energy()), (unseen.state(), 1200, unseen.energy()), "{}", X::NAME);
        assert_eq!(samples[0].state, galaxy(composition, 0.05).state(), "the start comes first");
        assert_eq!(samples[1].time, 300.0 * 0.05);
    }
    macro_rules! each {
        ($($composition:ident)*) => {
            $(check($composition);)*
        };
    }
    for_each_composition!(general_kinds: each!);
    for_each_composition!(quadratic_kinds: each!);
}

#[test]
fn samples_return_the_run_at_the_last_sample() {
    let mut samples = galaxy(Yoshida4, 0.05).samples(10);
    let seen = samples.by_ref().take(4).last().expect("a sample").expect("finite");
    let mut run = samples.into_run();
    assert_eq!((run.state(), run.steps()), (seen.state, 30));
    run.advance(10).expect("finite");
    let mut unseen = galaxy(Yoshida4, 0.05);
    unseen.advance(40).expect("finite");
    assert_eq!(run.state(), unseen.state());
}

#[test]
fn a_copy_goes_the_same_way_and_leaves_the_original() {
    let mut original = galaxy(Suzuki4, 0.05).at_time(2.0);
    original.advance(123).expect("finite");
    let before = original.state();
    let mut copy = original.clone();
    copy.advance(77).expect("finite");
    assert_eq!((original.state(), original.steps()), (before, 123));
    original.advance(77).expect("finite");
    assert_eq!((original.state(), original.time()), (copy.state(), copy.time()));
}

#[test]
fn the_energy_is_that_of_the_users_functions() {
    let problem = pendulum();
    let mut run = problem.system.run(Phase::new(problem.start.0, problem.start.1), 0.01).expect("an admissible start");
    run.advance(100).expect("finite");
    let state = run.state();
    let (kinetic, potential) = (problem.system.kinetic(state.p), problem.system.potential(state.q));
    // Each of the two is a product of a few factors, prepared in another order: a dozen roundings of each.
    let rounding = 12.0 * f64::EPSILON * (kinetic.abs() + potential.abs());
    assert!((run.energy() - (kinetic + potential)).abs() <= rounding);
}

/// A step of `-h` with the adjoint undoes a step of `h`; a symmetric composition is its own adjoint.
#[test]
fn negative_steps_come_back() {
    fn check<X: Composition<Chain>, Y: Composition<Chain>>(forward: X, back: Y) {
        let chain = Chain { alpha: 0.25, mass: std::array::from_fn(|i| 1.0 + i as f64 / 8.0) };
        let start = Phase::new(std::array::from_fn(|i| (i as f64 + 1.0).sin()), [0.1; 8]);
        let mut run = chain.run_with(forward, start, 0.05).expect("an admissible start");
        run.advance(200).expect("finite");
        let away = run.state();
        assert!((away.q[0] - start.q[0]).abs() > 0.1, "the run goes somewhere");
        let mut run = chain.run_with(back, away, -0.05).expect("an admissible start").at_time(run.time());
        run.advance(200).expect("finite");
        let end = run.state();
        let largest = |x: [f64; 8], y: [f64; 8]| x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        let distance = largest(end.q, start.q).max(largest(end.p, start.p));
        // Coordinates are of order one. Each of the stages of 400 steps adds a rounding, which the weakly chaotic
        // motion over 10 time units stretches by less than a hundred; stages are summed as in a random walk.
        let roundings = (400.0 * X::FORCE_EVALUATIONS as f64 * 2.0).sqrt();
        assert!(distance < 100.0 * roundings * f64::EPSILON, "{}: {distance:e}", X::NAME);
        assert!(run.time().abs() <= 10.0 * f64::EPSILON, "the clock goes back as well: {}", run.time());
    }
    check(Euler, EulerAdjoint);
    check(EulerAdjoint, Euler);
    check(Verlet, Verlet);
    check(VelocityVerlet, VelocityVerlet);
    check(Yoshida4, Yoshida4);
    check(Suzuki4, Suzuki4);
    check(Yoshida6, Yoshida6);
    check(KahanLi8, KahanLi8);
}

#[test]
fn where_the_clock_starts_does_not_matter_without_explicit_time() {
    let mut early = galaxy(Yoshida4, 0.05);
    let mut late = galaxy(Yoshida4, 0.05).at_time(1e6);
    early.advance(500).expect("finite");
    late.advance(500).expect("finite");
    assert_eq!(early.state(), late.state());
    assert_eq!(late.time(), 1e6 + 500.0 * 0.05);
}
