//! What only a device can tell: bits, lost members, and how fast it is. `integrator-gpu/on_device.sh` runs it; without a
//! device every test says that it was skipped.

use integrator_core::{Coords, Ensemble as OnProcessor, InstructionSet, prelude::*};
use integrator_gpu::{Device, Ensemble, Error as GpuError};
use std::time::Instant;

struct Pendulum {
    length: f64,
}

#[hamiltonian(gpu)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

struct Kepler {
    attraction: f64,
}

#[hamiltonian(gpu)]
impl Kepler {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|x| x * x).sum::<f64>() / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -self.attraction / q.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

struct Runaway;

#[hamiltonian(gpu)]
impl Runaway {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].powi(4)
    }
}

fn pendulums(count: usize) -> impl Iterator<Item = (Pendulum, Phase<[f64; 1]>)> {
    (0..count).map(|i| (Pendulum { length: 0.5 + i as f64 / 1e6 }, Phase::new([2.0], [0.1])))
}

fn orbits(count: usize) -> impl Iterator<Item = (Kepler, Phase<[f64; 3]>)> {
    (0..count).map(|i| (Kepler { attraction: 1.0 + i as f64 / 1e6 }, Phase::new([1.0, 0.1, 0.0], [0.0, 0.9, 0.1])))
}

/// The ensemble on the device, or `None` with the reason said.
fn on_device<C: Coords>(made: Result<Ensemble<C>, GpuError>) -> Option<Ensemble<C>> {
    match made {
        Ok(ensemble) => Some(ensemble),
        Err(reason @ (GpuError::Driver | GpuError::NoDevice(..) | GpuError::Compiler)) => {
            eprintln!("SKIPPED: {reason}");
            None
        }
        Err(other) => panic!("{other}"),
    }
}

/// The processor has these bits with `INTEGRATOR_ISA=avx2`, which the script sets.
#[test]
fn states_have_the_bits_of_the_processor() {
    if InstructionSet::chosen() != InstructionSet::Fused {
        eprintln!(
            "SKIPPED: this processor computes with {}, whose quotients have other bits",
            InstructionSet::chosen()
        );
        return;
    }
    let Some(mut device) = on_device(Ensemble::new(Yoshida4, pendulums(1_000), 0.01)) else { return };
    let mut processor = OnProcessor::new(Yoshida4, pendulums(1_000), 0.01).expect("an ensemble");
    for steps in [1, 10_000] {
        device.advance(steps).expect("finite");
        processor.advance(steps).expect("finite");
        assert_eq!(device.states().expect("states"), processor.states().collect::<Vec<_>>());
    }
    let Some(mut device) = on_device(Ensemble::new(Chin4A, orbits(1_000), 0.01)) else { return };
    let mut processor = OnProcessor::new(Chin4A, orbits(1_000), 0.01).expect("an ensemble");
    device.advance(10_000).expect("finite");
    processor.advance(10_000).expect("finite");
    assert_eq!(device.states().expect("states"), processor.states().collect::<Vec<_>>());
}

#[test]
fn who_is_lost_is_named() {
    let members = || [1.0, 0.0].map(|q| (Runaway, Phase::new([q], [0.0])));
    let Some(mut device) = on_device(Ensemble::new(Verlet, members(), 0.01)) else { return };
    let mut processor = OnProcessor::new(Verlet, members(), 0.01).expect("an ensemble");
    let Err(Error::Lost(lost)) = processor.advance(1_000) else { panic!("somebody is lost") };
    assert_eq!(device.advance(1_000), Err(GpuError::Lost(lost)));
    assert_eq!(device.states().expect("states")[0], processor.state(0).expect("a member"));
}

#[test]
fn a_checkpoint_of_the_device_goes_on_on_the_processor_and_back() {
    let systems = || pendulums(1_000).map(|(system, _)| system);
    let Some(mut device) = on_device(Ensemble::new(Yoshida4, pendulums(1_000), 0.01)) else { return };
    device.advance(1_000).expect("finite");
    let bytes = device.checkpoint().expect("a checkpoint");
    let mut processor = OnProcessor::<[f64; 1]>::resume(Yoshida4, systems(), &bytes).expect("an ensemble");
    let Some(mut back) = on_device(Ensemble::<[f64; 1]>::resume(Device::Cuda(0), Yoshida4, systems(), &bytes)) else {
        return;
    };
    for ensemble in [&mut device, &mut back] {
        ensemble.advance(1_000).expect("finite");
    }
    assert_eq!(device.states(), back.states());
    if InstructionSet::chosen() == InstructionSet::Fused {
        processor.advance(1_000).expect("finite");
        assert_eq!(device.states().expect("states"), processor.states().collect::<Vec<_>>());
    }
}

/// Prints members × steps per second; it holds nothing, since what a card can do depends on the card.
#[test]
fn speed_is_told() {
    const STEPS: u64 = 10_000;
    for count in [1_000, 10_000, 100_000, 1_000_000] {
        let Some(mut device) = on_device(Ensemble::new(Yoshida4, pendulums(count), 0.01)) else { return };
        // The first launch also loads the module.
        device.advance(1).expect("finite");
        let start = Instant::now();
        device.advance(STEPS).expect("finite");
        let rate = count as f64 * STEPS as f64 / start.elapsed().as_secs_f64();
        println!("pendulum, Yoshida4: {count} members, {rate:.3e} members × steps per second");
    }
}
