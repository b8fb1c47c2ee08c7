//! Benchmarks the gradient of a function of the end of a run: `cargo bench -p integrator-bench --bench gradient`.
//!
//! The last lines are medians over interleaved rounds:
//!
//! - `ratio_gradient_<problem>_<composition>=` is the time of [`Hamiltonian::gradient`] divided by that of the run; the target is
//!   2.5. `halo` has eight parameters in `sensitive(...)`, the other problems have none.
//! - `ratio_gradient_ensemble=` is the time of the gradients of 1,024 members divided by that of the ensemble alone.

use integrator_bench::{
    race::{Racer, race},
    starts::Problems,
};
use integrator_core::{Coords, Memoryless, prelude::*};

/// Approximate number of force evaluations per round.
const EVALUATIONS: u64 = 20_000;
/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 41;
/// Numbers of members and steps of the ensemble.
const MEMBERS: u32 = 1_024;
const STEPS: u64 = 100;

/// Measures the gradient of a function of the end, and the run alone. Returns a line with the ratio of their times.
fn gradient<H, X, C>(name: &str, (system, start): (&H, &Phase<C>), method: X, h: f64) -> String
where
    H: Hamiltonian<Coords = C>,
    X: Composition<H> + Memoryless<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let steps = EVALUATIONS / X::FORCE_EVALUATIONS as u64;
    let alone = || {
        let mut run = system.run_with::<f64, X>(method, start.clone(), h).expect("a start").with_threads(1);
        run.advance(steps).expect("finite states");
        run.state()
    };
    let loss = |end: &Phase<C>| (end.q.flat()[0], end.clone());
    let gradient = || system.gradient::<f64, X>(method, start.clone(), h, steps, loss).expect("a gradient");
    let racers = vec![Racer::new("alone", alone), Racer::new("gradient", gradient)];
    let times = race(ROUNDS, (steps * X::FORCE_EVALUATIONS as u64) as f64, racers);
    println!("{name} by {}: {:.1}, with its gradient {:.1} ns a force", X::NAME, times.median(0), times.median(1));
    format!("ratio_gradient_{name}_{}={:.3}", X::NAME.to_lowercase(), times.ratio(1, 0))
}

/// A galaxy: a flattened logarithmic halo, a disc and a bulge.
struct Halo {
    speed: f64,
    core: f64,
    flattening: f64,
    disc: f64,
    length: f64,
    height: f64,
    bulge: f64,
    radius: f64,
}

#[hamiltonian(sensitive(speed, core, flattening, disc, length, height, bulge, radius))]
impl Halo {
    fn kinetic(&self, [px, py, pz]: [f64; 3]) -> f64 {
        (px * px + py * py + pz * pz) / 2.0
    }
    fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
        let (square, height) = (x * x + y * y, (z * z + self.height.powi(2)).sqrt());
        let halo = (self.core.powi(2) + square + (z / self.flattening).powi(2)).ln();
        let disc = self.disc / (square + (self.length + height).powi(2)).sqrt();
        let bulge = self.bulge / (square + z * z + self.radius.powi(2)).sqrt();
        0.5 * self.speed.powi(2) * halo - disc - bulge
    }
}

/// Measures the gradients of the members of an ensemble, and the ensemble alone. Returns a line with the ratio of their times.
fn members() -> String {
    let problem = Problems::default().henon_heiles();
    let start = |number: u32| {
        let mut start = problem.start;
        start.q[0] += 1e-3 * f64::from(number) / f64::from(MEMBERS);
        start
    };
    let pairs = || (0..MEMBERS).map(|number| (problem.system, start(number)));
    let alone = || {
        let mut ensemble = Ensemble::new(KahanLi8, pairs(), 0.01).expect("starts");
        ensemble.advance(STEPS).expect("finite states");
        ensemble
    };
    let gradients = || Ensemble::gradients(KahanLi8, pairs(), 0.01, STEPS, |_, end: &Phase<[f64; 2]>| (end.q[0], *end));
    let racers = vec![Racer::new("alone", alone).in_threads(), Racer::new("gradients", gradients).in_threads()];
    let times = race(ROUNDS, f64::from(MEMBERS) * STEPS as f64, racers);
    println!("members: {:.1}, with their gradients {:.1} ns a step", times.median(0), times.median(1));
    format!("ratio_gradient_ensemble={:.3}", times.ratio(1, 0))
}

fn main() {
    let problems = Problems::default();
    let (pendulum, henon) = (problems.pendulum(), problems.henon_heiles());
    let (solar, chain) = (problems.solar(), problems.chain());
    let halo =
        Halo { speed: 1.0, core: 0.2, flattening: 0.8, disc: 1.0, length: 3.0, height: 0.3, bulge: 0.4, radius: 0.5 };
    let start = Phase::new([1.0, 0.0, 0.2], [0.0, 1.2, 0.1]);
    let ratios = [
        gradient("pendulum", (&pendulum.system, &pendulum.start), KahanLi8, 0.01),
        gradient("henon", (&henon.system, &henon.start), KahanLi8, 0.01),
        gradient("solar", (&solar.system, &solar.start), KahanLi8, 10.0),
        gradient("fput", (&chain.system, &chain.start), KahanLi8, 0.05),
        gradient("halo", (&halo, &start), KahanLi8, 0.01),
        members(),
    ];
    ratios.iter().for_each(|line| println!("{line}"));
}
