//! What only a device can tell: bits, lost members, errors, and how fast it is. `integrator-gpu/on_device.sh` runs it; without a
//! device every test says what was skipped, and holds what can be held without one: that the kernels by hand compile, and are
//! of the same method.

mod card;
mod speed;

use card::Card;
use integrator_core::{
    __private::{Composition, DeviceText, LaneScalars},
    Coords, Ensemble as OnProcessor, InLanes, InstructionSet,
    prelude::*,
};
use integrator_gpu::{Device, Ensemble, Error as GpuError};

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

/// The same two with the functions of the device.
struct NativePendulum {
    length: f64,
}

#[hamiltonian(gpu(functions = native))]
impl NativePendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

/// An outer solar system.
struct Planets {
    mass: [f64; 6],
}

#[hamiltonian(gpu)]
impl Planets {
    fn kinetic(&self, p: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.mass[i]);
            }
        }
        energy
    }
    fn potential(&self, q: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let mut r2 = 0.0;
                for d in 0..3 {
                    r2 += (q[i][d] - q[j][d]).powi(2);
                }
                energy -= self.mass[i] * self.mass[j] / r2.sqrt();
            }
        }
        energy
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

/// Planets on circles about a star, in units of it and of the distance of the first one.
fn systems(count: usize) -> impl Iterator<Item = (Planets, Phase<[[f64; 3]; 6]>)> {
    (0..count).map(|i| {
        let mass = [1.0, 1e-3, 3e-4, 4e-5, 5e-5, 1e-8];
        let radius = |body: usize| if body == 0 { 0.0 } else { body as f64 + i as f64 / 1e7 };
        let q = std::array::from_fn(|body| [radius(body), 0.0, 0.01 * radius(body)]);
        let p = std::array::from_fn(|body| [0.0, if body == 0 { 0.0 } else { mass[body] / radius(body).sqrt() }, 0.0]);
        (Planets { mass }, Phase::new(q, p))
    })
}

fn native_pendulums(count: usize) -> impl Iterator<Item = (NativePendulum, Phase<[f64; 1]>)> {
    pendulums(count).map(|(Pendulum { length }, start)| (NativePendulum { length }, start))
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
    holds_bits(Yoshida4, || pendulums(1_000), &[1, 10_000]);
    holds_bits(Yoshida4, || pendulums(100).map(|(system, _)| (system, Phase::new([2.0_f32], [0.1]))), &[10_000]);
    holds_bits(Chin4A, || orbits(1_000), &[10_000]);
    holds_bits(TakahashiImada4, || orbits(100), &[1, 1_000]);
    let compensated = || orbits(100).map(|(system, Phase { q, p })| (system, Phase::compensated(q, p)));
    holds_bits(BlanesMoanSrkn11, compensated, &[10_000]);
    holds_bits(Yoshida4, || systems(100), &[1_000]);
}

/// Holds states on the device against those on the processor after so many steps each.
fn holds_bits<H, X, C, M>(composition: X, members: impl Fn() -> M, portions: &[u64])
where
    H: DeviceText + Send + Sync + 'static,
    X: Composition<H> + InLanes<H> + Copy,
    C: Coords,
    C::Leaf: LaneScalars,
    H::Coords: Coords<With<C::Leaf> = C>,
    M: Iterator<Item = (H, Phase<C>)>,
{
    let Some(mut device) = on_device(Ensemble::new(composition, members(), 0.01)) else { return };
    let mut processor = OnProcessor::new(composition, members(), 0.01).expect("an ensemble");
    for steps in portions {
        device.advance(*steps).expect("finite");
        processor.advance(*steps).expect("finite");
        assert_eq!(device.states().expect("states"), processor.states().collect::<Vec<_>>(), "{}", X::NAME);
    }
}

#[test]
fn a_device_that_is_not_there_is_refused() {
    let Some(_) = on_device(Ensemble::new(Yoshida4, pendulums(1), 0.01)) else { return };
    let refused = Ensemble::on(Device::Cuda(1_000), Yoshida4, pendulums(1), 0.01).err();
    assert!(matches!(refused, Some(GpuError::NoDevice(1_000, 1..))), "{refused:?}");
}

#[test]
fn members_that_do_not_fit_are_refused() {
    let Some(card) = Card::first() else {
        return eprintln!("SKIPPED: there is no device whose memory could be filled");
    };
    let taken = card.fill(16 << 20).expect("all memory but 16 MiB");
    let refused = Ensemble::new(Yoshida4, pendulums(1_000_000), 0.01).err();
    // Two constants, twice two coordinates, and a note of who is lost, of 8 bytes each.
    assert_eq!(refused, Some(GpuError::Memory(1_000_000, 53)));
    drop(taken);
    assert_eq!(Ensemble::new(Yoshida4, pendulums(1_000_000), 0.01).err(), None);
}

#[test]
fn failed_members_are_named() {
    let members = || [1.0, 0.0].map(|q| (Runaway, Phase::new([q], [0.0])));
    let Some(mut device) = on_device(Ensemble::new(Verlet, members(), 0.01)) else { return };
    let mut processor = OnProcessor::new(Verlet, members(), 0.01).expect("an ensemble");
    let Err(Error::Lost(lost)) = processor.advance(1_000) else { panic!("somebody is lost") };
    assert_eq!(device.advance(1_000), Err(GpuError::Lost(lost)));
    assert_eq!(device.states().expect("states")[0], processor.state(0).expect("a member"));
}

#[test]
fn a_checkpoint_of_the_device_resumes_on_the_processor_and_back() {
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
