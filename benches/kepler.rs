//! The time of a stage along Kepler orbits, generated against written by hand: `cargo bench -p integrator --bench kepler`.
//!
//! The outer planets about a star at rest, and a weak spring as the second part, in Verlet: a step is one solution of
//! Kepler's equation for five planets, and next to nothing else. The last line, `ratio_kepler=`, is the generated time over that of the hand-written
//! stepper, medians of interleaved rounds: 1.1 is asked.

use integrator_bench::{
    by_hand::orbits,
    plan::Plan,
    problems::GRAVITY,
    race::{Racer, race},
    starts::Problems,
};
use integrator_core::prelude::*;

/// Steps of a round, and rounds.
const STEPS: u64 = 20_000;
const ROUNDS: usize = 61;

/// Planets whose star attracts them by Newton's law and by a spring.
struct Planets {
    masses: [f64; 5],
    pull: f64,
    spring: f64,
}

#[hamiltonian(split = kepler + spring)]
impl Planets {
    fn kepler(&self, q: [[f64; 3]; 5], p: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            let ([x, y, z], [u, v, w]) = (q[i], p[i]);
            energy += (u * u + v * v + w * w) / (2.0 * self.masses[i]);
            energy -= self.pull * self.masses[i] / (x * x + y * y + z * z).sqrt();
        }
        energy
    }
    fn spring(&self, q: [[f64; 3]; 5]) -> f64 {
        0.5 * self.spring * q.iter().map(|[x, y, z]| x * x + y * y + z * z).sum::<f64>()
    }
}

fn main() {
    let solar = Problems::default().solar();
    let masses: [f64; 5] = std::array::from_fn(|planet| solar.system.masses[planet + 1]);
    let planets = Planets { masses, pull: GRAVITY * solar.system.masses[0], spring: 1e-18 };
    let relative =
        |half: &[[f64; 3]; 6]| std::array::from_fn(|planet| std::array::from_fn(|d| half[planet + 1][d] - half[0][d]));
    let velocities: [[f64; 3]; 6] =
        std::array::from_fn(|body| solar.start.p[body].map(|p| p / solar.system.masses[body]));
    let mut momenta: [[f64; 3]; 5] = relative(&velocities);
    for (p, mass) in momenta.iter_mut().zip(masses) {
        *p = p.map(|velocity| velocity * mass);
    }
    let start: Phase<[[f64; 3]; 5]> = Phase::new(relative(&solar.start.q), momenta);
    let h = 150.0;
    let plan = Plan::of::<Verlet>(h);
    let generated = || {
        let mut run = planets.run(start, h).expect("a start");
        run.advance(STEPS).expect("finite states");
        run.state()
    };
    let by_hand = || orbits::planets(masses, [planets.pull, planets.spring], start, &plan, STEPS);
    let (found, expected) = (generated(), by_hand());
    for (found, expected) in found.q.as_flattened().iter().zip(expected.q.as_flattened()) {
        assert!((found - expected).abs() < 1e-8, "both follow the same orbits: {found} {expected}");
    }
    let times = race(ROUNDS, STEPS as f64, vec![Racer::new("generated", generated), Racer::new("by hand", by_hand)]);
    println!("generated {:.1} ns per stage, by hand {:.1} ns", times.median(0), times.median(1));
    println!("ratio_kepler={:.3}", times.ratio_to_best());
}
