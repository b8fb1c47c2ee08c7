//! Jacobi coordinates of bodies in any order: the heaviest one leads wherever it is.

use integrator_core::{check::symplectic_defect, prelude::*};

#[derive(Clone)]
struct Bodies<const N: usize> {
    mass: Vec<f64>,
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
impl<const N: usize> Bodies<N> {
    fn kinetic(&self, p: &[[f64; 2]; N]) -> f64 {
        (0..N).map(|i| (0..2).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..i {
                let square = (0..2).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

/// A star and planets of these masses on nearly circular orbits at distances of 1, 2, 3, ...
fn planets<const N: usize>(mass: impl Fn(usize) -> f64) -> (Bodies<N>, Phase<[[f64; 2]; N]>) {
    let mass: Vec<f64> = (0..N).map(|i| if i == 0 { 1.0 } else { mass(i) }).collect();
    let (mut q, mut p) = ([[0.0; 2]; N], [[0.0; 2]; N]);
    for i in 1..N {
        let (radius, (sin, cos)) = (i as f64, (2.4 * i as f64).sin_cos());
        let speed = 1.05 / radius.sqrt();
        (q[i], p[i]) = ([radius * cos, radius * sin], [-mass[i] * speed * sin, mass[i] * speed * cos]);
    }
    (Bodies { mass }, Phase::new(q, p))
}

/// The same with the star at another place.
fn with_the_star_at<const N: usize>(
    place: usize,
    (system, start): &(Bodies<N>, Phase<[[f64; 2]; N]>),
) -> (Bodies<N>, Phase<[[f64; 2]; N]>) {
    let (mut system, mut start) = (system.clone(), *start);
    system.mass[..=place].rotate_left(1);
    start.q[..=place].rotate_left(1);
    start.p[..=place].rotate_left(1);
    (system, start)
}

/// How far two states are apart, each body in units of its own radius and momentum.
fn apart<const N: usize>(a: &Phase<[[f64; 2]; N]>, b: &Phase<[[f64; 2]; N]>) -> f64 {
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let far = |a: [f64; 2], b: [f64; 2], size: f64| length([a[0] - b[0], a[1] - b[1]]) / size;
    // The star is as far from its place as its planets move it.
    let sizes = |i: usize| [length(b.q[i]).max(1.0), length(b.p[i]).max(f64::MIN_POSITIVE)];
    (0..N).map(|i| far(a.q[i], b.q[i], sizes(i)[0]).max(far(a.p[i], b.p[i], sizes(i)[1]))).fold(0.0, f64::max)
}

fn end<const N: usize>(
    composition: impl Composition<Bodies<N>>,
    (system, start): &(Bodies<N>, Phase<[[f64; 2]; N]>),
    steps: u64,
) -> (Phase<[[f64; 2]; N]>, [f64; 2]) {
    let mut run = system.run_with(composition, *start, 0.05).expect("a run");
    run.advance(steps).expect("steps");
    (run.state(), [run.kinetic(), run.potential()])
}

/// The coordinates are the same wherever the star is, so that runs differ by roundings: each step rounds by some ulps, and
/// the phase sums that up twice.
fn are_alike<const N: usize>(composition: impl Composition<Bodies<N>>, mass: f64) {
    const STEPS: u64 = 400;
    let tolerance = 4.0 * f64::EPSILON * (STEPS as f64).powi(2);
    let first = planets::<N>(|i| mass * (1 + i % 3) as f64);
    let (expected, energies) = end(composition, &first, STEPS);
    for place in 1..N {
        let other = with_the_star_at(place, &first);
        let (mut found, others) = end(composition, &other, STEPS);
        found.q[..=place].rotate_right(1);
        found.p[..=place].rotate_right(1);
        let error = apart(&found, &expected);
        assert!(error < tolerance, "{N} bodies of {mass:e}, the star at {place}: {error:e}");
        for (found, expected) in others.iter().zip(energies) {
            // Energies of light bodies are of the size of their masses.
            assert!((found - expected).abs() < tolerance * N as f64 * mass, "{found:e} is not {expected:e}");
        }
    }
}

#[test]
fn the_star_may_be_anywhere() {
    for mass in [1e-3, 1e-9, 2_f64.powi(-100)] {
        are_alike::<3>(Aba1064, mass);
        are_alike::<10>(Aba1064, mass);
    }
    // Kicks along the gradient of the squared force read the Hessian in the user's order.
    are_alike::<3>(Chin4A, 1e-3);
    are_alike::<10>(Chin4A, 1e-3);
}

#[test]
fn members_move_as_they_do_alone_whichever_body_leads() {
    let first = planets::<3>(|_| 1e-3);
    let members: Vec<_> = (0..9).map(|member| with_the_star_at(member % 3, &first)).collect();
    let mut ensemble = Ensemble::new(Aba1064, members.iter().cloned(), 0.05).expect("members");
    ensemble.advance(100).expect("steps");
    for (member, state) in members.iter().zip(ensemble.states()) {
        assert_eq!(end(Aba1064, member, 100).0, state);
    }
}

#[test]
fn steps_are_symplectic_whichever_body_leads() {
    for place in 0..3 {
        let (system, start) = with_the_star_at(place, &planets::<3>(|i| 0.01 * i as f64));
        let defect = symplectic_defect(&system, Aba1064, start, 0.05).expect("a step");
        // Some hundred roundings of numbers of the size of 1 / m.
        assert!(defect < 1e-11, "the star at {place}: {defect:e}");
    }
}

#[test]
fn masses_that_are_not_above_zero_are_refused() {
    let (system, start) = planets::<3>(|_| 1e-3);
    for (body, mass) in [(0, 0.0), (1, 0.0), (2, -1e-3), (0, -1.0), (1, f64::INFINITY)] {
        let mut system = system.clone();
        system.mass[body] = mass;
        let refused = system.run(start, 0.1).expect_err("no mass");
        assert!(matches!(refused, Error::Mass { body: named, mass: found, .. } if named == body && found == mass));
        assert!(mass != 0.0 || refused.to_string().contains("2f64.powi(-100)"), "{refused}");
    }
}

/// A number between -1 and 1.
fn number(random: &mut fastrand::Rng) -> f64 {
    2.0 * random.f64() - 1.0
}

/// A system with its start, whose star is at a place and moves.
fn random_planets<const N: usize>(random: &mut fastrand::Rng, place: usize) -> (Bodies<N>, Phase<[[f64; 2]; N]>) {
    let mass: Vec<_> = (0..N).map(|_| 1e-3 * (1.5 + number(random))).collect();
    let (system, mut start) = with_the_star_at(place, &planets::<N>(|i| mass[i]));
    for coordinate in start.q.as_flattened_mut().iter_mut().chain(start.p.as_flattened_mut()) {
        *coordinate += 1e-5 * number(random);
    }
    (system, start)
}

/// Changes a coordinate of a body and all of another's momentum.
fn kick<const N: usize>(random: &mut fastrand::Rng, state: &mut Phase<[[f64; 2]; N]>) {
    state.q[random.usize(..N)][random.usize(..2)] += 1e-3 * number(random);
    let body = random.usize(..N);
    state.p[body] = state.p[body].map(|p| p * (1.0 + 0.1 * number(random)));
}

/// A run shows a state that it was given bit for bit, and goes on from there as one that starts in it, and as one that is
/// resumed, wherever the star is and however often it is kicked.
fn is_begun_anew<const N: usize>(composition: impl Composition<Bodies<N>>) {
    const STEP: f64 = 0.05;
    let mut random = fastrand::Rng::with_seed(N as u64);
    for place in 0..N {
        let (system, start) = random_planets::<N>(&mut random, place);
        let begin = |start| system.run_with(composition, start, STEP).expect("a run");
        let mut run = begin(start);
        assert_eq!(run.state(), start);
        for _ in 0..2 {
            run.advance(random.u64(..15)).expect("steps");
            let mut changed = run.state();
            kick(&mut random, &mut changed);
            run.map_state(|state| *state = changed).expect("a kick");
            assert_eq!(run.state(), changed, "{N} bodies, the star at {place}");
            let mut resumed = Run::resume_with(&system, composition, &run.checkpoint()).expect("a checkpoint");
            let mut in_portions = run.clone();
            let mut begun = begin(run.state());
            for steps in [0, 1, 12] {
                for run in [&mut run, &mut resumed, &mut begun] {
                    run.advance(steps).expect("steps");
                }
                for _ in 0..steps {
                    in_portions.advance(1).expect("a step");
                }
                for other in [&begun, &resumed, &in_portions] {
                    assert_eq!(other.state(), run.state(), "{N} bodies, the star at {place}, {steps} more steps");
                    assert_eq!(other.energy().to_bits(), run.energy().to_bits());
                }
                let again = Run::resume_with(&system, composition, &run.checkpoint()).expect("a checkpoint");
                assert_eq!((again.steps(), again.state()), (run.steps(), run.state()));
            }
        }
    }
}

#[test]
fn a_changed_state_is_a_new_start_bit_for_bit() {
    macro_rules! are_begun_anew {
        ($($bodies:literal),*) => {$(
            is_begun_anew::<$bodies>(Aba1064);
            is_begun_anew::<$bodies>(WisdomHolmanTouma3);
            is_begun_anew::<$bodies>(WisdomHolmanTouma17);
        )*};
    }
    are_begun_anew!(2, 3, 4, 5, 6);
}

#[test]
fn changed_members_restart_as_they_do_alone() {
    const STEP: f64 = 0.05;
    const METHOD: WisdomHolmanTouma3 = WisdomHolmanTouma3;
    let mut random = fastrand::Rng::with_seed(1);
    let members: Vec<_> = (0..9).map(|member| random_planets::<3>(&mut random, member % 3)).collect();
    let systems = || members.iter().map(|(system, _)| system.clone());
    let mut ensemble = Ensemble::new(METHOD, members.iter().cloned(), STEP).expect("members");
    assert!(ensemble.states().eq(members.iter().map(|(_, start)| *start)));
    for steps in [0, 17] {
        ensemble.advance(steps).expect("steps");
        let mut changed: Vec<_> = ensemble.states().collect();
        changed.iter_mut().for_each(|state| kick(&mut random, state));
        ensemble.map_states(|member, state| *state = changed[member]).expect("kicks");
        assert!(ensemble.states().eq(changed.iter().copied()));
        let mut resumed = Ensemble::resume(METHOD, systems(), &ensemble.checkpoint()).expect("a checkpoint");
        assert!(ensemble.states().eq(resumed.states()));
        for ensemble in [&mut ensemble, &mut resumed] {
            ensemble.advance(50).expect("steps");
        }
        let alone = systems().zip(&changed).map(|(system, start)| {
            let mut run = system.run_with(METHOD, *start, STEP).expect("a run");
            run.advance(50).expect("steps");
            run.state()
        });
        assert!(ensemble.states().eq(alone));
        assert!(ensemble.states().eq(resumed.states()));
    }
}

#[test]
fn other_scalar_types_and_tangents_show_their_starts() {
    let mut random = fastrand::Rng::with_seed(2);
    for place in 0..4 {
        let (system, start) = random_planets::<4>(&mut random, place);
        let single = Phase::new(start.q.map(|q| q.map(|q| q as f32)), start.p.map(|p| p.map(|p| p as f32)));
        assert_eq!(system.run(single, 0.05).expect("a run").state(), single);
        let compensated = Phase::compensated(start.q, start.p);
        assert_eq!(system.run(compensated, 0.05).expect("a run").state(), compensated);
        let vectors: Vec<_> = (0..3).map(|_| random_planets::<4>(&mut random, place).1).collect();
        let tangent = system.tangent(Aba1064, start, vectors.clone(), 0.05).expect("a tangent");
        assert_eq!((tangent.state(), tangent.vectors()), (start, vectors.clone()));
        let resumed = integrator_core::Tangent::resume(&system, Aba1064, &tangent.checkpoint()).expect("a checkpoint");
        assert_eq!((resumed.state(), resumed.vectors()), (start, vectors));
    }
}
