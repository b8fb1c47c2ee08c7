//! A million pendulums of all lengths over the ranks of MPI: `mpirun -n 4 target/release/examples/pendulum [FOLDER]`.

use integrator_core::prelude::*;
use integrator_mpi as cluster;

struct Pendulum {
    length: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

const MEMBERS: usize = 1_000_000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let universe = cluster::start()?;
    let world = universe.world();
    let pendulum = |i: usize| (Pendulum { length: 0.5 + i as f64 / MEMBERS as f64 }, Phase::new([1.0_f64], [0.0]));
    let members = cluster::share(&world, MEMBERS).map(pendulum);
    let mut swarm = cluster::Ensemble::new(&world, Yoshida4, members, 0.01)?;
    swarm.advance(1_000)?;
    let angles = swarm.moments(|member| Some(member.state.q[0]));
    let spread = swarm.histogram(-1.0..1.0, 20, |member| Some(member.state.q[0]));
    let farthest = swarm.maximum(|member| Some(member.state.q[0].abs()));
    if let Some(folder) = std::env::args().nth(1) {
        swarm.write_csv(folder)?;
    }
    if cluster::is_root(&world) {
        println!("after {} steps: {} +- {}", swarm.steps(), angles.mean, angles.standard_deviation());
        println!("farthest {farthest:?}");
        for count in spread.counts {
            println!("{}", "*".repeat(count as usize * 400 / MEMBERS));
        }
    }
    Ok(())
}
