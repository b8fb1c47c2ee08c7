//! Initial states, time spans and reference states of the systems.

use crate::problems::{
    Argon, ArgonInBox, Chain32, Cluster, CoupledOscillators, GRAVITY, HenonHeiles, Kepler, Pendulum, Planets, Solar,
};
use integrator_core::prelude::*;
use serde_json::Value;
use std::f64::consts::PI;

/// A system with a known final state.
#[derive(Clone)]
pub struct Problem<H: Hamiltonian> {
    /// Name in the output lines of a bench.
    pub name: &'static str,
    /// The system.
    pub system: H,
    /// Initial state.
    pub start: Phase<H::Coords>,
    /// Duration of the integration.
    pub span: f64,
    /// Final positions followed by velocities, computed in 113-bit arithmetic.
    pub reference: Vec<f64>,
}

/// The five problems of `examples/data/problems.json`.
pub struct Problems(Value);

impl Default for Problems {
    fn default() -> Self {
        let text = include_str!("../../examples/data/problems.json");
        let mut data: Value = serde_json::from_str(text).expect("the repository's own file");
        Self(data["problems"].take())
    }
}

impl Problems {
    fn numbers(&self, problem: &str, field: &str) -> Vec<f64> {
        serde_json::from_value(self.0[problem][field].clone()).expect("numbers")
    }

    fn problem<H: Hamiltonian>(&self, name: &'static str, key: &str, system: H, start: Phase<H::Coords>) -> Problem<H> {
        let data = &self.0[key];
        let reference = serde_json::from_value(data["reference"]["z"].clone()).expect("numbers");
        Problem { name, system, start, span: data["T"].as_f64().expect("a number"), reference }
    }

    /// Oscillations of large amplitude.
    pub fn pendulum(&self) -> Problem<Pendulum> {
        let start = Phase::new(array(&self.numbers("pendulum", "q")), array(&self.numbers("pendulum", "p")));
        self.problem("pendulum", "pendulum", Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 }, start)
    }

    /// A regular orbit.
    pub fn henon_heiles(&self) -> Problem<HenonHeiles> {
        let start = Phase::new(array(&self.numbers("henon", "q")), array(&self.numbers("henon", "p")));
        self.problem("henon", "henon", HenonHeiles, start)
    }

    /// The same orbit, with the system split into coupled oscillators.
    pub fn coupled_oscillators(&self) -> Problem<CoupledOscillators> {
        let Problem { start, .. } = self.henon_heiles();
        self.problem("henon_parts", "henon", CoupledOscillators, start)
    }

    /// A thousand revolutions on an orbit of eccentricity 0.6.
    pub fn kepler(&self) -> Problem<Kepler> {
        let start = Phase::new(array(&self.numbers("kepler", "q")), array(&self.numbers("kepler", "p")));
        self.problem("kepler", "kepler", Kepler, start)
    }

    /// The outer solar system for 999,999 days. The file contains velocities; momenta are velocities times masses.
    pub fn solar(&self) -> Problem<Solar> {
        let masses: [f64; 6] = array(&self.numbers("solar", "m"));
        let q: [[f64; 3]; 6] = points(&self.numbers("solar", "q"));
        let mut p: [[f64; 3]; 6] = points(&self.numbers("solar", "p"));
        for (p, mass) in p.iter_mut().zip(masses) {
            *p = p.map(|velocity| mass * velocity);
        }
        self.problem("solar", "solar", Solar { masses }, Phase::new(q, p))
    }

    /// The outer planets orbiting a fixed Sun, with an additional weak spring.
    pub fn planets(&self) -> (Planets, Phase<[[f64; 3]; 5]>) {
        let Problem { system, start, .. } = self.solar();
        let masses: [f64; 5] = std::array::from_fn(|planet| system.masses[planet + 1]);
        let planets = Planets { masses, pull: GRAVITY * system.masses[0], spring: 1e-18 };
        let velocity = |body: usize, d: usize| start.p[body][d] / system.masses[body];
        let relative =
            |planet: usize, of: &dyn Fn(usize, usize) -> f64| std::array::from_fn(|d| of(planet + 1, d) - of(0, d));
        let q = std::array::from_fn(|planet| relative(planet, &|body, d| start.q[body][d]));
        let p = std::array::from_fn(|planet| relative(planet, &velocity).map(|v: f64| v * masses[planet]));
        (planets, Phase::new(q, p))
    }

    /// The lowest mode of a chain of 32 sites.
    ///
    /// # Panics
    /// If the file has no number `alpha`.
    pub fn chain(&self) -> Problem<Chain32> {
        let start = Phase::new(array(&self.numbers("fput32", "q")), array(&self.numbers("fput32", "p")));
        let alpha = self.0["fput32"]["alpha"].as_f64().expect("a number");
        self.problem("fput", "fput32", Chain32 { alpha }, start)
    }
}

fn array<const N: usize>(numbers: &[f64]) -> [f64; N] {
    numbers.try_into().expect("so many numbers")
}

fn points<const N: usize>(numbers: &[f64]) -> [[f64; 3]; N] {
    let (points, rest) = numbers.as_chunks();
    assert!(rest.is_empty(), "whole points");
    points.try_into().expect("so many points")
}

/// Waves of several lengths along a chain at rest.
pub fn waves(sites: usize) -> Phase<Vec<f64>> {
    let wave = |i: usize| {
        let x = (i + 1) as f64 / (sites + 1) as f64;
        0.4 * (PI * x).sin() + 0.1 * (PI * (sites / 50).max(5) as f64 * x).sin()
    };
    Phase::new((0..sites).map(wave).collect(), vec![0.0; sites])
}

/// The same wave along all rows of a plane, one row after the other.
pub fn rows_of_waves<const W: usize>(rows: usize) -> Phase<Vec<[f64; W]>> {
    let Phase { q, p } = waves(rows * W);
    let [q, p] = [q, p].map(|sites| sites.as_chunks().0.to_vec());
    Phase::new(q, p)
}

/// The same wave along all rows of all planes of a volume.
pub fn planes_of_waves<const W: usize, const ROWS: usize>(planes: usize) -> Phase<Vec<[[f64; W]; ROWS]>> {
    let Phase { q, p } = rows_of_waves(planes * ROWS);
    let [q, p] = [q, p].map(|rows| rows.as_chunks().0.to_vec());
    Phase::new(q, p)
}

/// A cubic grid with small random displacements, and small momenta with a sum of about zero.
fn shaken_grid(count: usize, spacing: f64) -> Phase<Vec<[f64; 3]>> {
    // A linear congruential generator in integers, so that the result is the same on every machine.
    let mut state = 1_u64;
    let mut shake = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let side = (1..).find(|side| side * side * side >= count).expect("a side");
    let place = |i: usize| [i / (side * side), i / side % side, i % side];
    let q = (0..count).map(|i| place(i).map(|k| spacing * (k as f64 + 0.1 * shake()))).collect();
    Phase::new(q, (0..count).map(|_| [0, 1, 2].map(|_| 0.01 * shake())).collect())
}

/// Stars with different masses.
pub fn cluster(count: usize) -> (Cluster, Phase<Vec<[f64; 3]>>) {
    let masses = (0..count).map(|i| 0.5 + (i % 7) as f64 / 7.0).collect();
    (Cluster { masses }, shaken_grid(count, 2.0))
}

/// A drop of argon.
pub fn argon(count: usize) -> (Argon, Phase<Vec<[f64; 3]>>) {
    (Argon { cutoff: 2.5 }, shaken_grid(count, 1.12))
}

/// Density of liquid argon near its triple point, in atoms per cubed diameter.
pub const DENSITY: f64 = 0.8442;

/// Liquid argon that starts as a crystal with `cells` cells along each axis and four atoms per cell. The initial
/// temperature is twice that of the liquid, because half of the kinetic energy becomes potential energy.
pub fn liquid(cells: usize) -> (ArgonInBox, Phase<Vec<[f64; 3]>>) {
    let cell = (4.0 / DENSITY).cbrt();
    let corners = [[0.25, 0.25, 0.25], [0.75, 0.75, 0.25], [0.75, 0.25, 0.75], [0.25, 0.75, 0.75]];
    let mut state = 1_u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut q = Vec::with_capacity(4 * cells.pow(3));
    for n in 0..cells.pow(3) {
        let at = [n % cells, n / cells % cells, n / cells.pow(2)];
        q.extend(corners.map(|corner| [0, 1, 2].map(|d| cell * (at[d] as f64 + corner[d]))));
    }
    // A uniform number between -1/2 and 1/2 has the variance 1/12.
    let scale = (12.0 * 2.0 * 0.72_f64).sqrt();
    let p = q.iter().map(|_| [0, 1, 2].map(|_| scale * next())).collect();
    (ArgonInBox { side: cell * cells as f64 }, Phase::new(q, p))
}
