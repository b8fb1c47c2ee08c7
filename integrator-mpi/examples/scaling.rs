//! What an ensemble takes with as many members on every rank: `mpirun -n 2 target/release/examples/scaling 100000`.

use integrator_core::prelude::*;
use integrator_mpi::{self as cluster, mpi::traits::*};
use std::{hint::black_box, time::Instant};

struct Pendulum {
    length: f64,
}

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

const STEPS: u64 = 1_000;
const REPEATS: usize = 9;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let universe = cluster::start()?;
    let world = universe.world();
    let of_rank: usize = std::env::args().nth(1).unwrap_or_default().parse().unwrap_or(100_000);
    let members = of_rank * world.size() as usize;
    let start = |i: usize| (Pendulum { length: 1.0 + i as f64 / members as f64 }, Phase::new([1.0_f64], [0.0]));
    let mut swarm =
        cluster::Ensemble::new(&world, Verlet, cluster::share(&world, members).map(start), 0.01)?.with_threads(1);
    let median = |call: &mut dyn FnMut()| {
        let mut seconds: Vec<f64> = (0..REPEATS)
            .map(|_| {
                world.barrier();
                let begin = Instant::now();
                call();
                world.barrier();
                begin.elapsed().as_secs_f64()
            })
            .collect();
        seconds.sort_by(f64::total_cmp);
        seconds[REPEATS / 2]
    };
    let mut outcome = Ok(());
    let steps = median(&mut || outcome = swarm.advance(STEPS));
    outcome?;
    let mut agreed = Ok(());
    let agreement = median(&mut || agreed = swarm.advance(0));
    agreed?;
    let moments = median(&mut || {
        black_box(swarm.moments(|member| Some(member.state.q[0])));
    });
    let gathered = median(&mut || {
        black_box(swarm.states_on_root());
    });
    if cluster::is_root(&world) {
        println!(
            "{} ranks of {of_rank}: {:.3} ns for each member and step of a rank, {:.1} us for an agreement, {:.3} s for moments, \
             {:.3} s for all states",
            world.size(),
            1e9 * steps / (of_rank as f64 * STEPS as f64),
            1e6 * agreement,
            moments,
            gathered,
        );
    }
    Ok(())
}
