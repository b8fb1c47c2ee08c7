//! The Python module of the tests, with systems of all shapes, and functions that integrate them in Rust.

use integrator_core::prelude::*;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// A flattened logarithmic potential.
#[derive(Clone, Deserialize, Serialize)]
struct Galaxy {
    core: f64,
    flattening: f64,
}

#[hamiltonian(compose = BlanesMoanSrkn11, sensitive(core, flattening))]
impl Galaxy {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        (self.core.powi(2) + q[0] * q[0] + q[1] * q[1] + (q[2] / self.flattening).powi(2)).ln() / 2.0
    }
    #[invariant]
    fn angular_momentum(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
        q[0] * p[1] - q[1] * p[0]
    }
}

impl Galaxy {
    fn circular_velocity(&self, radius: f64) -> f64 {
        radius / (self.core.powi(2) + radius.powi(2)).sqrt()
    }

    /// The columns that `samples` has to have, one after the other: t, q, p, energy.
    fn in_rust(&self, q: [f64; 3], p: [f64; 3], h: f64, count: usize, every: u64) -> Vec<Vec<f64>> {
        let run = self.run_with(KahanLi8, Phase::compensated(q, p), h).expect("a run");
        let mut columns = vec![vec![]; 4];
        for sample in run.samples(every).take(count) {
            let sample = sample.expect("a sample");
            let state = sample.state.to_f64();
            columns[0].push(sample.time);
            columns[1].extend(state.q);
            columns[2].extend(state.p);
            columns[3].push(sample.energy());
        }
        columns
    }

    /// The seconds that a number of steps takes in Rust.
    fn seconds_of_steps(&self, q: [f64; 3], p: [f64; 3], h: f64, steps: u64) -> f64 {
        let mut run = self.run(Phase::new(q, p), h).expect("a run");
        let begin = Instant::now();
        run.advance(steps).expect("the steps");
        begin.elapsed().as_secs_f64()
    }

    /// The seconds that samples take in Rust, with the columns that `samples` has.
    fn seconds_of_samples(&self, q: [f64; 3], p: [f64; 3], h: f64, count: usize) -> f64 {
        let run = self.run(Phase::new(q, p), h).expect("a run");
        let begin = Instant::now();
        let (mut t, mut energy) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let (mut positions, mut momenta) = (Vec::with_capacity(3 * count), Vec::with_capacity(3 * count));
        let mut momentum = Vec::with_capacity(count);
        for sample in run.samples(1).take(count) {
            let sample = sample.expect("a sample");
            t.push(sample.time);
            positions.extend_from_slice(&sample.state.q);
            momenta.extend_from_slice(&sample.state.p);
            energy.push(sample.energy());
            momentum.push(sample.invariant("angular_momentum").expect("an invariant"));
        }
        assert_eq!([t.len(), energy.len(), momentum.len(), positions.len() / 3, momenta.len() / 3], [count; 5]);
        begin.elapsed().as_secs_f64()
    }
}

/// Bodies that attract each other: points whose number is known at run time, and masses as an array.
#[derive(Clone, Deserialize, Serialize)]
struct Bodies {
    mass: Vec<f64>,
    #[serde(default = "one")]
    strength: f64,
}

fn one() -> f64 {
    1.0
}

#[hamiltonian]
impl Bodies {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        (0..p.len()).map(|i| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let d = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                energy -= self.strength * self.mass[i] * self.mass[j] / d;
            }
        }
        energy
    }
}

/// A system without parameters.
#[derive(Clone, Deserialize, Serialize)]
struct Rotor;

#[hamiltonian(taylor)]
impl Rotor {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// Parts of H with names, which not every composition can integrate.
#[derive(Clone, Deserialize, Serialize)]
struct Chain {
    coupling: f32,
    periodic: bool,
    label: Option<String>,
}

#[hamiltonian(split = kinetic + springs + wells)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn springs(&self, q: &[f64]) -> f64 {
        (1..q.len()).map(|i| f64::from(self.coupling) * (q[i] - q[i - 1]).powi(2) / 2.0).sum()
    }
    fn wells(&self, q: &[f64]) -> f64 {
        q.iter().map(|q| -q.cos()).sum()
    }
}

/// An oscillator in a bath.
#[derive(Clone, Deserialize, Serialize)]
struct Bath {
    temperature: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl Bath {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        self.temperature
    }
}

integrator_python::module! {
    /// A flattened logarithmic potential. Unit of velocities: the circular velocity at large radii.
    galaxy: Galaxy,
    methods = {
        /// The velocity of a circular orbit in the plane.
        fn circular_velocity(&self, radius: f64) -> f64;
        fn in_rust(&self, q: [f64; 3], p: [f64; 3], h: f64, count: usize, every: u64) -> Vec<Vec<f64>>;
        fn seconds_of_steps(&self, q: [f64; 3], p: [f64; 3], h: f64, steps: u64) -> f64;
        fn seconds_of_samples(&self, q: [f64; 3], p: [f64; 3], h: f64, count: usize) -> f64;
    };
    /// Bodies in a plane.
    Bodies, compositions = [Verlet, KahanLi8, ImplicitMidpoint];
    Rotor, compositions = [Yoshida4];
    Chain;
    Bath, compositions = [Obabo]
}
