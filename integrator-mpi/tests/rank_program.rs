//! What the tests start on one rank and on several: one case each, by its name.

#[path = "systems.rs"]
mod systems;

use integrator_core::{Coords, prelude::*};
use integrator_mpi::{self as cluster, chaos::Indicator};
use mpi::traits::{Communicator, CommunicatorCollectives};
use std::process::{abort, exit};
use systems::{Bath, HenonHeiles, MEMBERS, Pendulum, STEPS, fall, pendulum};

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let universe = cluster::start().expect("the first start");
    assert!(cluster::start().is_err(), "MPI starts once");
    let world = universe.world();
    match &arguments[1][..] {
        "plain" => numbers(&world, MEMBERS, |i| (pendulum(i), Phase::new([i as f64 / 40.0], [0.1]))),
        #[cfg(feature = "gpu")]
        "on devices" => {
            // The odd ranks have a program in the place of a device, the others what there is.
            let device = if world.rank() % 2 == 1 { cluster::Device::Text } else { cluster::Device::Best };
            let members = cluster::share(&world, MEMBERS).map(|i| (pendulum(i), Phase::new([i as f64 / 40.0], [0.1])));
            let swarm = cluster::Ensemble::on(&world, device, Yoshida4, members, 0.01).expect("finite starts");
            numbers_of(swarm);
        }
        #[cfg(feature = "gpu")]
        "resume on devices" => {
            let device = cluster::Device::Text;
            match cluster::Ensemble::<_, [f64; 1]>::resume_on(&world, device, Yoshida4, fall, &arguments[2]) {
                Ok(swarm) => finish(&world, swarm),
                Err(error) => on_every_rank(&world, &error.to_string()),
            }
        }
        #[cfg(feature = "gpu")]
        "no device" => {
            let device = if world.rank() == 1 { cluster::Device::Cuda(1_000) } else { cluster::Device::Best };
            let members = cluster::share(&world, MEMBERS).map(|i| (pendulum(i), Phase::new([0.1], [0.1])));
            let refused = cluster::Ensemble::on(&world, device, Yoshida4, members, 0.01);
            on_every_rank(&world, &refused.err().map_or("accepted".to_owned(), |error| error.to_string()));
        }
        "compensated" => numbers(&world, MEMBERS, |i| (pendulum(i), Phase::compensated([i as f64 / 40.0], [0.1]))),
        "few" => numbers(&world, 2, |i| (pendulum(i), Phase::new([0.5 + i as f64], [0.1]))),
        "lists" => numbers(&world, 7, |i| (systems::Chain, Phase::new(vec![0.1; i + 1], vec![0.2; i + 1]))),
        "noise" => {
            let members = cluster::share(&world, MEMBERS).map(|i| (Bath, Phase::new([i as f64 / 40.0], [0.1])));
            let swarm = cluster::Ensemble::new(&world, Baoab, members, 0.01).expect("finite starts");
            numbers_of(swarm.with_seed(7));
        }
        "none" => {
            let none = cluster::Ensemble::new(&world, Verlet, Vec::<(Pendulum, Phase<[f64; 1]>)>::new(), 0.1);
            on_every_rank(&world, &none.err().map_or("accepted".to_owned(), |error| error.to_string()));
        }
        "refused" => {
            let member = |i: usize| (pendulum(i), Phase::new([if i % 30 == 29 { f64::NAN } else { 0.1 }], [0.0]));
            let refused = cluster::Ensemble::new(&world, Verlet, cluster::share(&world, MEMBERS).map(member), 0.1);
            on_every_rank(&world, &refused.err().map_or("accepted".to_owned(), |error| error.to_string()));
        }
        "lost" => {
            let member = |i: usize| (fall(i), Phase::new([if i % 30 == 29 { 1.0_f64 } else { 0.0 }], [0.0]));
            let members = cluster::share(&world, MEMBERS).map(member);
            let mut swarm = cluster::Ensemble::new(&world, Verlet, members, 0.5).expect("finite starts");
            let lost = swarm.advance(STEPS);
            on_every_rank(&world, &format!("{} under way: {}", swarm.active(), text(lost)));
            on_every_rank(&world, &format!("then {}, {} steps", text(swarm.advance(10)), swarm.steps()));
            on_every_rank(&world, &text(swarm.advance(u64::MAX)));
            on_every_rank(&world, &text(swarm.advance_while(10, 0, |_, _| true)));
            let tenth = swarm.advance_while(10, 1, |index, _| index % 10 == 0);
            on_every_rank(&world, &format!("{}: {} stay", text(tenth), swarm.active()));
        }
        "strayed" => {
            // Those off the top fall ever faster, until steps are too long for them.
            let member = |i: usize| (fall(i), Phase::new([if i % 30 == 29 { 1.0_f64 } else { 0.0 }], [0.0]));
            let members = cluster::share(&world, MEMBERS).map(member);
            let mut swarm = cluster::Ensemble::new(&world, Verlet, members, 0.5).expect("finite starts");
            on_every_rank(&world, &text(swarm.watch_energy(0.0)));
            on_every_rank(&world, &text(swarm.watch_energy(0.01)));
            let strayed = text(swarm.advance(STEPS));
            on_every_rank(&world, &format!("{} under way, {} steps: {strayed}", swarm.active(), swarm.steps()));
        }
        "map" => {
            let start = |i: usize| Phase::new([i as f64 / 20.0, 0.1], [0.3, 0.0]);
            let map = |count, steps| {
                cluster::chaos::map(&world, &HenonHeiles, Verlet, count, start, 0.05, steps, Indicator::Megno)
            };
            for (count, steps) in [(11, 2_000), (2, 100)] {
                let found = map(count, steps).expect("finite starts");
                assert_eq!(found.is_some(), cluster::is_root(&world));
                found.iter().for_each(|indicators| println!("{indicators:?}"));
            }
            for refused in [map(11, 1), map_of_nan(&world)] {
                on_every_rank(&world, &refused.err().map_or("accepted".to_owned(), |error| error.to_string()));
            }
        }
        "csv" => {
            let member = |i: usize| (pendulum(i), Phase::new([i as f64 / 40.0], [0.1]));
            let mut swarm = cluster::Ensemble::new(&world, Yoshida4, cluster::share(&world, MEMBERS).map(member), 0.01)
                .expect("finite starts");
            swarm.advance(STEPS).expect("pendulums stay");
            on_every_rank(&world, &text(swarm.write_csv(&arguments[2])));
        }
        "save" => {
            let mut swarm = falling(&world);
            // Twice at one step, beside files of another kind.
            for steps in [201, 0] {
                on_every_rank(&world, &text(swarm.advance(steps)));
                on_every_rank(&world, &text(swarm.checkpoint_to(&arguments[2])));
            }
            finish(&world, swarm);
        }
        "killed" => {
            let mut swarm = falling(&world);
            on_every_rank(&world, &text(swarm.advance(201)));
            on_every_rank(&world, &text(swarm.checkpoint_to(&arguments[2])));
            // The last member of all is on the last rank, for which the others wait here until MPI ends them.
            let outcome = swarm.advance_while(100, 50, |index, _| if index == MEMBERS - 1 { abort() } else { true });
            println!("{}", text(outcome));
        }
        "resume" => match cluster::Ensemble::<_, [f64; 1]>::resume(&world, Yoshida4, fall, &arguments[2]) {
            Ok(swarm) => finish(&world, swarm),
            Err(error) => on_every_rank(&world, &error.to_string()),
        },
        "panics" => {
            let member = |i: usize| (pendulum(i), Phase::new([0.1_f64], [0.0]));
            let mut swarm = cluster::Ensemble::new(&world, Verlet, cluster::share(&world, MEMBERS).map(member), 0.1)
                .expect("finite starts");
            // The last member of all is on the last rank.
            let outcome = swarm.advance_while(STEPS, 1, |index, _| match index {
                100 => panic!("the last one"),
                _ => true,
            });
            println!("{}", text(outcome));
        }
        other => {
            eprintln!("there is no case {other}");
            exit(2);
        }
    }
}

/// Members of which some are lost.
fn falling<W: Communicator>(world: &W) -> cluster::Ensemble<'_, W, [f64; 1]> {
    let member = |i: usize| (fall(i), Phase::new([if i % 30 == 29 { 1.0_f64 } else { 0.01 }], [0.0]));
    cluster::Ensemble::new(world, Yoshida4, cluster::share(world, MEMBERS).map(member), 0.01).expect("finite starts")
}

/// A map in which one start of each ten is no number.
fn map_of_nan(world: &impl Communicator) -> Result<Option<Vec<f64>>, cluster::Error> {
    let start = |i: usize| Phase::new([if i % 10 == 2 { f64::NAN } else { 0.1 }, 0.1], [0.3, 0.0]);
    cluster::chaos::map(world, &HenonHeiles, Verlet, 21, start, 0.05, 100, Indicator::Fli)
}

/// All numbers that an ensemble of so many members gives, bit by bit, printed by rank 0.
fn numbers<H, C>(world: &impl Communicator, members: usize, member: impl Fn(usize) -> (H, Phase<C>))
where
    H: Hamiltonian<Coords = C::With<f64>>,
    C: Coords,
    C::Leaf: integrator_core::__private::LaneScalars,
    H::Coords: Coords<With<C::Leaf> = C>,
    Yoshida4: integrator_core::InLanes<H>,
{
    let swarm = cluster::Ensemble::new::<H, _>(world, Yoshida4, cluster::share(world, members).map(member), 0.01);
    numbers_of(swarm.expect("finite starts"));
}

/// The same of an ensemble that is there.
fn numbers_of<W: Communicator, C: Coords>(mut swarm: cluster::Ensemble<'_, W, C>) {
    swarm.advance(STEPS).expect("no member is lost");
    assert_eq!(swarm.steps(), STEPS);
    let first = |member: &cluster::Member<'_, C>| Some(member.state.to_f64().q.flat()[0]);
    let odd = |member: &cluster::Member<'_, C>| (member.index % 2 == 1).then(|| member.energy());
    let moments = swarm.moments(first);
    let extremes = (swarm.minimum(first), swarm.maximum(odd), swarm.maximum(|_| None));
    let (sum, none) = (swarm.sum(odd), swarm.sum(|_| None));
    let histogram = swarm.histogram(-1.0..1.0, 8, first);
    let active = swarm.active();
    if let Some(states) = swarm.states_on_root() {
        assert_eq!(states.len(), swarm.len());
        println!("{states:?}");
        println!("{moments:?} {extremes:?} {sum:?} {none:?} {histogram:?} {active}");
    }
}

/// Advances an ensemble and prints all of it.
fn finish<W: Communicator>(world: &W, mut swarm: cluster::Ensemble<'_, W, [f64; 1]>) {
    on_every_rank(world, &format!("{}, {} steps", text(swarm.advance(100)), swarm.steps()));
    let steps = swarm.sum(|member| Some(member.steps as f64));
    if let Some(states) = swarm.states_on_root() {
        println!("end {steps} {states:?}");
    }
}

/// Prints what every rank says, which has to be the same.
fn on_every_rank(world: &impl Communicator, text: &str) {
    let own: Vec<u64> = text.bytes().map(u64::from).collect();
    let digest = own.iter().fold(7_u64, |digest, byte| digest.wrapping_mul(31).wrapping_add(*byte));
    let mut digests = vec![0; world.size() as usize];
    world.all_gather_into(&digest, &mut digests[..]);
    assert!(digests.iter().all(|other| *other == digest), "rank {} says something else: {text}", world.rank());
    if cluster::is_root(world) {
        println!("{}", text.replace('\n', " | "));
    }
}

fn text(outcome: Result<(), cluster::Error>) -> String {
    outcome.map_or_else(|error| error.to_string(), |()| "done".to_owned())
}
