//! The text for devices, as a program of this machine, does all that an ensemble on the processor does: clocks, times between
//! steps, members that leave, states that change, checkpoints in both directions.

use integrator_core::{__private::LaneScalars, Coords, Ensemble as OnProcessor, InstructionSet, prelude::*};
use integrator_gpu::{Device, Ensemble, Error as GpuError};

/// A pendulum whose weight comes and goes.
struct Driven {
    length: f64,
}

#[hamiltonian(gpu)]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -(1.0 + 0.5 * t.cos()) * self.length * q[0].cos()
    }
}

fn driven(i: usize) -> Driven {
    Driven { length: 0.25 * (1.0 + i as f64) }
}

/// Whatever is not at rest falls to infinity, each as strongly as it says.
struct Fall {
    pull: f64,
}

#[hamiltonian(gpu)]
impl Fall {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.pull * q[0].powi(4)
    }
}

fn fall(i: usize) -> Fall {
    Fall { pull: 1.0 + i as f64 / 8.0 }
}

/// The first nine of some members on both sides; `None`, with the reason said, where they cannot be compared.
fn both<H, C>(system: fn(usize) -> H, start: fn(usize) -> Phase<C>, h: f64) -> Option<(Ensemble<C>, OnProcessor<C>)>
where
    H: integrator_core::__private::DeviceText<Coords = C::With<f64>>,
    C: Coords,
    C::Leaf: LaneScalars,
    H::Coords: Coords<With<C::Leaf> = C>,
    Yoshida4: integrator_core::InLanes<H> + Composition<H>,
{
    if InstructionSet::chosen() == InstructionSet::Baseline {
        eprintln!("SKIPPED: this process computes without fused multiply-add");
        return None;
    }
    let members = || (0..9).map(|i| (system(i), start(i)));
    match Ensemble::on::<H, _>(Device::Text, Yoshida4, members(), h) {
        Err(GpuError::Program(reason)) if reason.contains("is installed") => {
            eprintln!("SKIPPED: {reason}");
            None
        }
        made => Some((made.expect("an ensemble"), OnProcessor::new::<H, _>(Yoshida4, members(), h).expect("one"))),
    }
}

/// Holds everything that both show against each other.
fn hold<C: Coords>(device: &mut Ensemble<C>, processor: &OnProcessor<C>) {
    assert_eq!(device.states().expect("states"), processor.states().collect::<Vec<_>>());
    let energies: Vec<_> = (0..9).map(|member| processor.energy(member).expect("a member").to_bits()).collect();
    let on_device: Vec<_> = device.energies().expect("energies").into_iter().map(f64::to_bits).collect();
    assert_eq!(on_device, energies);
    for member in 0..10 {
        assert_eq!(device.steps_of(member), processor.steps_of(member), "{member}");
        assert_eq!(device.time_of(member), processor.time_of(member), "{member}");
        assert_eq!(device.state(member).expect("a state"), processor.state(member), "{member}");
    }
    assert_eq!(
        (device.steps(), device.time(), device.active()),
        (processor.steps(), processor.time(), processor.active())
    );
    // Alone they have no meaning, but they are equal where all else is.
    assert!(device.checkpoint().expect("a checkpoint") == processor.checkpoint(), "other checkpoints");
}

fn lost<T>(outcome: Result<T, Error>) -> Result<T, GpuError> {
    outcome.map_err(GpuError::from)
}

#[test]
fn clocks_start_at_a_time_and_stop_between_steps() {
    let start = |i: usize| Phase::compensated([0.1 + i as f64 / 4.0], [0.1]);
    let Some((device, processor)) = both(driven, start, 0.01) else { return };
    let (mut device, mut processor) = (device.at_time(0.3), processor.at_time(0.3));
    hold(&mut device, &processor);
    for time in [1.0, 1.034, 1.069, 2.5] {
        assert_eq!(device.advance_to(time), lost(processor.advance_to(time)));
        hold(&mut device, &processor);
        assert_eq!(device.time(), time);
        device.advance(3).expect("finite");
        processor.advance(3).expect("finite");
        hold(&mut device, &processor);
    }
    for time in [1.0, f64::NAN] {
        let [on_device, expected] = [device.advance_to(time), lost(processor.advance_to(time))]
            .map(|outcome| format!("{:?}", outcome.expect_err("no time to go to")));
        assert_eq!(on_device, expected);
        hold(&mut device, &processor);
    }
    let never = both(driven, start, 0.01).map(|(device, _)| device.at_time(f64::INFINITY).advance(1));
    assert_eq!(never, Some(Err(GpuError::Core(Error::Time { time: f64::INFINITY }))));
}

#[test]
fn failed_members_are_reported_as_on_the_processor() {
    let start = |i: usize| Phase::new([if i % 3 == 1 { 0.5 + i as f64 / 10.0 } else { 0.0 }], [0.0]);
    let Some((mut device, mut processor)) = both(fall, start, 0.01) else { return };
    for steps in [100, 300, 1_000] {
        let reported = device.advance(steps);
        assert_eq!(reported, lost(processor.advance(steps)));
        hold(&mut device, &processor);
    }
    assert_eq!(device.lost().len(), 3);
    assert_eq!(device.advance_to(20.005), lost(processor.advance_to(20.005)));
    hold(&mut device, &processor);
    // A member that is lost in the shorter step between two of all.
    let fast = |i: usize| Phase::new([if i == 4 { 1e60 } else { 0.0 }], [0.0]);
    let Some((mut device, mut processor)) = both(fall, fast, 0.5) else { return };
    let reported = device.advance_to(0.4);
    assert!(matches!(&reported, Err(GpuError::Lost(lost)) if lost.members.len() == 1), "{reported:?}");
    assert_eq!(reported, lost(processor.advance_to(0.4)));
    hold(&mut device, &processor);
    assert_eq!(device.advance(10), lost(processor.advance(10)));
    hold(&mut device, &processor);
}

#[test]
fn members_are_removed_and_changed_as_on_the_processor() {
    let start = |i: usize| Phase::new([0.1], [0.2 + i as f64 / 5.0]);
    let Some((mut device, mut processor)) = both(driven, start, 0.01) else { return };
    let stays = |member: usize, state: &Phase<[f64; 1]>| member == 0 || state.q[0] < 0.5;
    for steps in [95, 5, 100] {
        assert_eq!(device.advance_while(steps, 10, stays), lost(processor.advance_while(steps, 10, stays)));
        hold(&mut device, &processor);
    }
    assert!((1..9).contains(&device.active()), "{} are under way", device.active());
    let turn = |member: usize, state: &mut Phase<[f64; 1]>| state.p[0] *= -1.0 - member as f64 / 16.0;
    device.map_states(turn).expect("finite");
    processor.map_states(turn).expect("finite");
    hold(&mut device, &processor);
    device.advance(100).expect("finite");
    processor.advance(100).expect("finite");
    hold(&mut device, &processor);
    let none = device.advance_while(10, 0, stays);
    assert_eq!(none, Err(GpuError::Core(Error::SampleInterval)));
}

#[test]
fn a_checkpoint_resumes_on_either_side() {
    let start = |i: usize| Phase::compensated([if i % 3 == 1 { 0.8 } else { 0.01 }], [0.0]);
    let Some((mut device, mut processor)) = both(fall, start, 0.01) else { return };
    let _ = (device.advance(200), processor.advance(200));
    let nudge = |_: usize, state: &mut Phase<[Compensated<f64>; 1]>| state.p = Phase::compensated([0.0], [0.02]).p;
    device.map_states(nudge).expect("finite");
    processor.map_states(nudge).expect("finite");
    let _ = (device.advance(150), processor.advance(150));
    let (of_device, of_processor) = (device.checkpoint().expect("a checkpoint"), processor.checkpoint());
    let systems = || (0..9).map(fall);
    let mut here = OnProcessor::resume(Yoshida4, systems(), &of_device).expect("an ensemble");
    let mut there = Ensemble::resume(Device::Text, Yoshida4, systems(), &of_processor).expect("an ensemble");
    hold(&mut there, &here);
    for ensemble in [&mut device, &mut there] {
        ensemble.advance(100).expect("finite");
    }
    for ensemble in [&mut processor, &mut here] {
        ensemble.advance(100).expect("finite");
    }
    hold(&mut device, &processor);
    hold(&mut there, &here);
    hold(&mut there, &processor);
    let other = Ensemble::<[Compensated<f64>; 1]>::resume(Device::Text, Verlet, systems(), &of_processor);
    let reason = other.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(reason.contains("composition `Yoshida4`, not `Verlet`"), "{reason}");
    let few = Ensemble::<[Compensated<f64>; 1]>::resume(Device::Text, Yoshida4, systems().take(8), &of_processor);
    assert!(matches!(few.err(), Some(GpuError::Checkpoint(_))));
}
