//! One annotated pendulum on the processor, on a device or as the text for one, and over the ranks of MPI, with the same bits:
//! without an argument, `device`, `text`, and under `mpirun` with `ranks`.

use integrator_core::{Ensemble, prelude::*};
use integrator_gpu::{self as gpu, Device};
use integrator_mpi as cluster;
use std::ops::Range;

struct Pendulum {
    length: f64,
}

#[hamiltonian(compose = Yoshida4, gpu)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

const MEMBERS: usize = 1_000;
const STEPS: u64 = 500;

fn members(range: Range<usize>) -> impl Iterator<Item = (Pendulum, Phase<[f64; 1]>)> {
    range.map(|i| (Pendulum { length: 0.5 + i as f64 / MEMBERS as f64 }, Phase::new([1.0], [0.0])))
}

/// A number that another state of any member would change.
fn digest(states: &[Phase<[f64; 1]>]) -> u64 {
    let numbers = states.iter().flat_map(|state| [state.q[0], state.p[0]]);
    numbers.fold(0, |digest: u64, number| digest.rotate_left(5) ^ number.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let states = match std::env::args().nth(1).as_deref() {
        // Each rank takes the device that it sees, and its processor where there is none.
        Some("ranks") => {
            let universe = cluster::start()?;
            let world = universe.world();
            let of_rank = members(cluster::share(&world, MEMBERS));
            let mut swarm = cluster::Ensemble::on(&world, Device::Best, Yoshida4, of_rank, 0.01)?;
            swarm.advance(STEPS)?;
            swarm.states_on_root()
        }
        Some(place @ ("device" | "text")) => {
            let device = if place == "device" { Device::Best } else { Device::Text };
            let mut swarm = gpu::Ensemble::on(device, Yoshida4, members(0..MEMBERS), 0.01)?;
            if let Some(reason) = swarm.fallback() {
                eprintln!("on the processor: {reason}");
            }
            swarm.advance(STEPS)?;
            Some(swarm.states()?)
        }
        _ => {
            let mut swarm = Ensemble::new(Yoshida4, members(0..MEMBERS), 0.01)?;
            swarm.advance(STEPS)?;
            Some(swarm.states().collect())
        }
    };
    if let Some(states) = states {
        println!("{:016x}", digest(&states));
    }
    Ok(())
}
