//! Sums over lists of lists, such as the neighbours of each site of a graph, against sums by hand.

use integrator_core::{System, prelude::*};

const STEP: f64 = 0.1;

#[derive(Clone)]
struct Graph {
    neighbours: Vec<Vec<u32>>,
    weights: Vec<Vec<f64>>,
    masses: Vec<f64>,
    strength: f64,
}

/// A graph in which site `i` has `i % 7` neighbours, and one weight less for some.
fn graph(sites: usize) -> Graph {
    let neighbours = |i: usize| (0..i % 7).map(|k| ((i * 5 + k * k + 3) % sites) as u32).collect::<Vec<_>>();
    let weights =
        |i: usize| (0..(i % 7).max(i % 3).saturating_sub(i % 2)).map(|k| (1.3 * (i + k) as f64).sin()).collect();
    Graph {
        neighbours: (0..sites).map(neighbours).collect(),
        weights: (0..sites).map(weights).collect(),
        masses: (0..sites).map(|i| 1.0 + 0.1 * i as f64).collect(),
        strength: 0.7,
    }
}

struct Rotors(Graph);

#[hamiltonian]
impl Rotors {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            let mut around = 0.0;
            for (&j, weight) in self.0.neighbours[i].iter().zip(&self.0.weights[i]) {
                around += weight * self.0.masses[j as usize] * (q[i] - q[j as usize]).cos();
            }
            v -= 0.5 * self.0.strength * self.0.masses[i] * around;
            v += 0.1 * q[i].powi(4);
        }
        v
    }
}

struct Points(Graph);

#[hamiltonian]
impl Points {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for &j in &self.0.neighbours[i] {
                let r2: f64 = (0..3).map(|d| (q[i][d] - q[j as usize][d]).powi(2)).sum();
                v += self.0.strength * (r2 + 1.0).sqrt();
            }
        }
        v
    }
}

/// The same rotors, whose lists are one, with the place where that of each site begins.
struct RotorsInOneList {
    offsets: Vec<usize>,
    targets: Vec<u32>,
    weights: Vec<f64>,
    masses: Vec<f64>,
    strength: f64,
}

impl From<Graph> for RotorsInOneList {
    fn from(graph: Graph) -> Self {
        let weights_of = |i: usize| graph.weights[i].iter().copied().chain(std::iter::repeat(0.0));
        let ends = graph.neighbours.iter().scan(0, |end, list| {
            *end += list.len();
            Some(*end)
        });
        Self {
            offsets: std::iter::once(0).chain(ends).collect(),
            targets: graph.neighbours.concat(),
            weights: (0..graph.neighbours.len()).flat_map(|i| weights_of(i).take(graph.neighbours[i].len())).collect(),
            masses: graph.masses,
            strength: graph.strength,
        }
    }
}

#[hamiltonian]
impl RotorsInOneList {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for k in self.offsets[i]..self.offsets[i + 1] {
                let j = self.targets[k] as usize;
                v -= 0.5 * self.strength * self.weights[k] * self.masses[i] * self.masses[j] * (q[i] - q[j]).cos();
            }
            v += 0.1 * q[i].powi(4);
        }
        v
    }
}

/// Springs in five dimensions, each with a stiffness along each of them, which no list of entries has.
struct Springs(Graph);

#[hamiltonian]
impl Springs {
    fn kinetic(&self, p: &[[f64; 5]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 5]]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for (k, &j) in self.0.neighbours[i].iter().enumerate() {
                for d in 0..5 {
                    v += 0.5 * self.0.masses[i + k + d] * (q[i][d] - q[j as usize][d]).powi(2);
                }
            }
        }
        v
    }
}

/// Entries, each with its two sites and its place in a list.
fn entries(graph: &Graph) -> impl Iterator<Item = (usize, usize, usize)> {
    let of = move |i: usize| (0..graph.neighbours[i].len()).map(move |k| (i, graph.neighbours[i][k] as usize, k));
    (0..graph.neighbours.len()).flat_map(of)
}

fn wave(k: usize) -> f64 {
    (0.37 * k as f64).sin()
}

/// The force and the energy of rotors, by hand.
fn rotors(graph: &Graph, q: &[f64]) -> (Vec<f64>, f64) {
    let mut force: Vec<f64> = q.iter().map(|q| -0.4 * q.powi(3)).collect();
    let mut energy: f64 = q.iter().map(|q| 0.1 * q.powi(4)).sum();
    for (i, j, k) in entries(graph) {
        let Some(weight) = graph.weights[i].get(k) else { continue };
        let factor = 0.5 * graph.strength * graph.masses[i] * graph.masses[j] * weight;
        energy -= factor * (q[i] - q[j]).cos();
        force[i] -= factor * (q[i] - q[j]).sin();
        force[j] += factor * (q[i] - q[j]).sin();
    }
    (force, energy)
}

/// Sums of at most a hundred terms of the size of `size` in another order.
fn are_near(found: &[f64], expected: impl IntoIterator<Item = f64>, size: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 100.0 * f64::EPSILON * size, "{found} for {expected}");
    }
}

#[test]
fn lists_of_any_length_are_summed() -> Result<(), Error> {
    const { assert!(Rotors::LARGE_FLOWS && RotorsInOneList::LARGE_FLOWS, "terms share no vectors") };
    for sites in [1, 2, 5, 9, 40] {
        let (graph, start) = (graph(sites), Phase::new((0..sites).map(wave).collect::<Vec<_>>(), vec![0.0; sites]));
        let (force, energy) = rotors(&graph, &start.q);
        let mut in_one_list = RotorsInOneList::from(graph.clone()).run_with(Euler, start.clone(), STEP)?;
        are_near(&[in_one_list.energy()], [energy], 100.0);
        in_one_list.advance(1)?;
        are_near(&in_one_list.state().p, force.iter().map(|force| STEP * force), 10.0);
        let mut run = Rotors(graph.clone()).run_with(Euler, start.clone(), STEP)?;
        are_near(&[run.energy()], [energy], 100.0);
        run.advance(1)?;
        are_near(&run.state().p, force.iter().map(|force| STEP * force), 10.0);
        let members = [start.clone(), start].map(|start| (Rotors(graph.clone()), start));
        let mut ensemble = Ensemble::new(Euler, members, STEP)?;
        ensemble.advance(1)?;
        assert_eq!(ensemble.state(1), Some(run.state()));
    }
    Ok(())
}

#[test]
fn terms_of_points_are_summed() -> Result<(), Error> {
    const { assert!(Points::LARGE_FLOWS, "terms share no vectors") };
    let (graph, sites) = (graph(30), 30);
    let q: Vec<_> = (0..sites).map(|i| [0, 1, 2].map(|d| wave(3 * i + d))).collect();
    let mut force = vec![[0.0; 3]; sites];
    for (i, j, _) in entries(&graph) {
        let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
        for d in 0..3 {
            let term = graph.strength * (q[i][d] - q[j][d]) / (r2 + 1.0_f64).sqrt();
            force[i][d] -= term;
            force[j][d] += term;
        }
    }
    let mut run = Points(graph).run_with(Euler, Phase::new(q, vec![[0.0; 3]; sites]), STEP)?;
    run.advance(1)?;
    are_near(run.state().p.as_flattened(), force.as_flattened().iter().map(|force| STEP * force), 10.0);
    Ok(())
}

#[test]
fn numbers_along_components_are_read() -> Result<(), Error> {
    let (mut graph, sites) = (graph(20), 20);
    graph.masses = (0..40).map(|i| 1.0 + 0.1 * i as f64).collect();
    let q: Vec<_> = (0..sites).map(|i| [0, 1, 2, 3, 4].map(|d| wave(5 * i + d))).collect();
    let mut force = vec![[0.0; 5]; sites];
    for (i, j, k) in entries(&graph) {
        for d in 0..5 {
            let term = graph.masses[i + k + d] * (q[i][d] - q[j][d]);
            force[i][d] -= term;
            force[j][d] += term;
        }
    }
    let mut run = Springs(graph).run_with(Euler, Phase::new(q, vec![[0.0; 5]; sites]), STEP)?;
    run.advance(1)?;
    are_near(run.state().p.as_flattened(), force.as_flattened().iter().map(|force| STEP * force), 100.0);
    Ok(())
}
