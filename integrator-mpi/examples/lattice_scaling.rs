//! What a ring takes with as many sites on every rank: `mpirun -n 2 target/release/examples/lattice_scaling 1000000`.

use integrator_core::prelude::*;
use integrator_mpi::{self as cluster, mpi::traits::*};
use std::{hint::black_box, time::Instant};

/// Fermi, Pasta, Ulam and Tsingou's ring.
struct Fput {
    alpha: f64,
}

#[hamiltonian]
impl Fput {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (0..q.len())
            .map(|i| {
                let r = q[(i + 1) % q.len()] - q[i];
                r * r / 2.0 + self.alpha * r.powi(3) / 3.0
            })
            .sum()
    }
}

const STEPS: u64 = 1_000;
const REPEATS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let universe = cluster::start()?;
    let world = universe.world();
    let of_rank: usize = std::env::args().nth(1).unwrap_or_default().parse().unwrap_or(1_000_000);
    let sites = of_rank * world.size() as usize;
    let slab = |sites: &[usize]| {
        let q = sites.iter().map(|site| 0.1 * (*site as f64 * 1e-3).sin()).collect();
        (Fput { alpha: 0.25 }, Phase::new(q, vec![0.0; sites.len()]))
    };
    let mut ring = cluster::Lattice::new(&world, Verlet, sites, 0.05, slab)?.with_threads(1);
    let mut seconds = Vec::with_capacity(REPEATS);
    for _ in 0..REPEATS {
        world.barrier();
        let begin = Instant::now();
        ring.advance(STEPS)?;
        world.barrier();
        seconds.push(begin.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    black_box(ring.sum(|_, q, _| Some(q[0])));
    if cluster::is_root(&world) {
        println!(
            "{} ranks of {of_rank} sites: {:.3} ns for each site and step of a rank; steps between exchanges and halos: {:?}",
            world.size(),
            1e9 * seconds[REPEATS / 2] / (of_rank as f64 * STEPS as f64),
            ring.exchanges(),
        );
    }
    Ok(())
}
