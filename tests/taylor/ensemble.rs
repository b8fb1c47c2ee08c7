//! Members of an ensemble, each on polynomials of its own: bit for bit what they are alone.

use crate::{
    runs::{Chain, Driven, FINE, Fall, Hill, Kepler, Pendulum, pericentre},
    splits::{double_pendulum, kepler_and_interaction},
};
use integrator_core::{Coords, Error, prelude::*, taylor::Taylor};

/// More than four motions of sixteen lanes, and members that fill none.
const MANY: usize = 4 * 16 + 5;

/// A number between zero and one for each member, in no order.
fn spread(member: usize) -> f64 {
    (member * 29 % 37) as f64 / 37.0
}

/// All digits of a state.
fn written<C: Coords + std::fmt::Debug>(state: &Phase<C>) -> String {
    format!("{state:?}")
}

/// Holds members against the same systems run alone, whatever portions and threads there are. Each row is a name, a method, a
/// step, a start of the clock, and the members.
macro_rules! rows {
    ($($name:ident, $method:expr, $h:expr, $t0:expr, $member:expr;)*) => {$(
        #[test]
        fn $name() {
            let (h, t0, member) = ($h, $t0, $member);
            for (members, threads, portions) in [(1, 1, [200, 0]), (2, 1, [7, 193]), (9, 1, [1, 199]), (MANY, 2, [61, 139])] {
                let swarm = Ensemble::new($method, (0..members).map(&member), h).expect("an ensemble");
                let mut swarm = swarm.at_time(t0).with_threads(threads);
                for steps in portions {
                    swarm.advance(steps).expect("finite states");
                }
                for (number, state) in swarm.states().enumerate() {
                    let (system, start) = member(number);
                    let mut alone = system.run_with($method, start, h).expect("a start").at_time(t0);
                    alone.advance(200).expect("finite states");
                    assert_eq!(written(&state), written(&alone.state()), "member {number} of {members}");
                    assert_eq!(swarm.energy(number), Some(alone.energy()), "member {number} of {members}");
                }
            }
        }
    )*};
}

rows! {
    pendula, Taylor::tolerance(FINE), 0.25, 0.0,
        |i| (Pendulum, Phase::new([0.1 + 2.9 * spread(i)], [0.0]));
    pendula_in_short_steps, Taylor::tolerance(1e-10).with_order(12), 0.001, 0.0,
        |i| (Pendulum, Phase::new([0.1 + 2.9 * spread(i)], [0.0]));
    pendula_in_single_precision, Taylor::tolerance(1e-9), -0.25, 0.0,
        |i| (Pendulum, Phase::new([0.1 + 2.9 * spread(i) as f32], [0.0]));
    orbits, Taylor::tolerance(1e-16), 0.125, 0.0,
        |i| (Kepler, pericentre(0.9 * spread(i)));
    orbits_that_carry_their_roundings, Taylor::tolerance(FINE), 0.125, 0.0,
        |i| {
            let Phase { q, p } = pericentre(0.9 * spread(i));
            (Kepler, Phase::compensated(q, p))
        };
    constants_of_their_own, Taylor::tolerance(FINE), 0.25, 0.0,
        |i| (Hill { slope: spread(i), quartic: -0.1 - spread(i + 1) }, Phase::new([1.0], [spread(i + 2)]));
    driven_ones_from_a_time, Taylor::tolerance(1e-16), 0.25, -3.0,
        |i| (Driven, Phase::new([spread(i)], [0.0]));
    short_chains, Taylor::tolerance(1e-16), 0.125, 0.0,
        |i| (Chain, Phase::new((0..3).map(|site| spread(i + site)).collect(), vec![0.0; 3]));
    long_chains, Taylor::tolerance(1e-16), 0.03125, 0.0,
        |i| (Chain, Phase::new((0..19).map(|site| spread(i + site)).collect(), vec![0.0; 19]));
    long_chains_in_single_precision, Taylor::tolerance(1e-8), 0.03125, 0.0,
        |i| (Chain, Phase::new((0..19).map(|site| spread(i + site) as f32).collect(), vec![0.0; 19]));
    what_is_not_t_plus_v, Taylor::tolerance(FINE), 0.03125, 0.0,
        |i| (double_pendulum::System { masses: [1.0; 4] }, Phase::new([0.1 + spread(i), -0.5], [0.2, spread(i + 1)]));
    named_parts_that_carry_their_roundings, Taylor::tolerance(FINE), 0.25, 0.0,
        |i| (kepler_and_interaction::System { masses: [1.0; 4] }, Phase::compensated([1.0, 0.25], [-0.25, 0.75 + spread(i) / 4.0]));
    long_chains_that_carry_their_roundings, Taylor::tolerance(1e-16), 0.03125, 0.0,
        |i| (Chain, Phase::compensated((0..19).map(|site| spread(i + site)).collect(), vec![0.0; 19]));
}

#[test]
fn finished_members_are_removed_and_the_others_continue_as_if_alone() {
    let member = |i| (Pendulum, Phase::new([0.1 + 2.9 * spread(i)], [0.0]));
    let stays = |state: &Phase<[f64; 1]>| state.q[0] > -1.0;
    for threads in [1, 2] {
        let swarm = Ensemble::new(Taylor::tolerance(FINE), (0..MANY).map(member), 0.125).expect("an ensemble");
        let mut swarm = swarm.with_threads(threads);
        for steps in [18, 30] {
            swarm.advance_while(steps, 3, |_, state| stays(state)).expect("finite states");
        }
        // Whoever starts below one radian never comes there.
        assert!((1..MANY).contains(&swarm.active()), "{} of {MANY}", swarm.active());
        for number in 0..MANY {
            let (system, start) = member(number);
            let mut alone = system.run_with(Taylor::tolerance(FINE), start, 0.125).expect("a start");
            while alone.steps() < 48 && (alone.steps() == 0 || stays(&alone.state())) {
                alone.advance(3).expect("finite states");
            }
            assert_eq!(swarm.steps_of(number), Some(alone.steps()), "member {number}");
            assert_eq!(swarm.state(number).as_ref().map(written), Some(written(&alone.state())), "member {number}");
        }
    }
}

#[test]
fn members_at_a_singularity_fail_and_the_others_continue_as_if_alone() {
    // From rest at a distance, the time of the fall is its power 3/2 times π/√8, from 0.1 to 3.1.
    let member = |i| (Fall, Phase::new([0.2 + 1.8 * spread(i)], [0.0]));
    let method = Taylor::tolerance(FINE);
    let mut swarm = Ensemble::new(method, (0..MANY).map(member), 1.0 / 64.0).expect("an ensemble");
    let mut gone = Vec::new();
    for steps in [40, 1, 59] {
        match swarm.advance(steps) {
            Err(Error::Lost(lost)) => gone.extend(lost.members),
            other => assert_eq!(other, Ok(()), "no other error"),
        }
    }
    assert_eq!(swarm.active() + gone.len(), MANY);
    assert!((1..MANY).contains(&gone.len()), "{} of {MANY}", gone.len());
    for number in 0..MANY {
        let (system, start) = member(number);
        let mut alone = system.run_with(method, start, 1.0 / 64.0).expect("a start");
        let fell = alone.advance(100).is_err();
        assert_eq!(swarm.steps_of(number), Some(alone.steps()), "member {number}");
        assert_eq!(swarm.state(number).as_ref().map(written), Some(written(&alone.state())), "member {number}");
        let lost = gone.iter().find(|(member, _)| *member == number);
        assert_eq!(lost.map(|(_, divergence)| divergence.step), fell.then(|| alone.steps() + 1), "member {number}");
    }
}

#[test]
fn a_tolerance_that_is_none_is_refused_with_its_member() {
    let members = [(Pendulum, Phase::new([1.0], [0.0]))];
    let refused = Ensemble::new(Taylor::tolerance(-1.0), members, 0.1).err();
    let Some(Error::Member { member: 0, error }) = refused else { panic!("{refused:?}") };
    assert!(matches!(*error, Error::Tolerance { .. }), "{error}");
}
