//! The lattices of the tests, in the program that ranks run and in the process that compares.

use integrator_core::{Compensated, prelude::*};
use std::f64::consts::TAU;

pub(crate) const SITES: usize = 1_500;
pub(crate) const STEPS: u64 = 60;

/// The angle of a site, which no other has.
fn angle(site: usize) -> f64 {
    site as f64 * 0.3 + (site as f64 * 0.618).fract()
}

/// Fermi, Pasta, Ulam and Tsingou's ring.
#[derive(Clone)]
pub(crate) struct Ring {
    alpha: f64,
}

#[hamiltonian]
impl Ring {
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

pub(crate) fn ring(sites: &[usize]) -> (Ring, Phase<Vec<f64>>) {
    let q = sites.iter().map(|site| 0.1 * angle(*site).sin()).collect();
    (Ring { alpha: 0.25 }, Phase::new(q, vec![0.0; sites.len()]))
}

/// A chain between walls whose masses differ, with springs to the next two sites and in them a field that comes and goes.
#[derive(Clone)]
pub(crate) struct Chain {
    masses: Vec<f64>,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        (0..p.len()).map(|i| p[i] * p[i] / (2.0 * self.masses[i])).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        let n = q.len();
        let near: f64 = (0..n - 1).map(|i| (q[i + 1] - q[i]).powi(4) / 4.0).sum();
        let far: f64 = (0..n - 2).map(|i| (q[i + 2] - q[i]).powi(2) / 8.0).sum();
        let own: f64 = (0..n).map(|i| (1.0 + 0.2 * t.cos()) * q[i].powi(2) / 2.0).sum();
        near + far + own + q[0].powi(2) + q[n - 1].powi(2)
    }
}

pub(crate) fn chain(sites: &[usize]) -> (Chain, Phase<Vec<Compensated<f64>>>) {
    let masses = sites.iter().map(|site| 1.0 + (*site % 7) as f64 / 8.0).collect();
    let q: Vec<f64> = sites.iter().map(|site| 0.3 * angle(*site).cos()).collect();
    (Chain { masses }, Phase::compensated(q, sites.iter().map(|site| 0.1 * angle(*site).sin()).collect()))
}

/// A plane of rotors that is closed in both directions.
#[derive(Clone)]
pub(crate) struct Plane;

#[hamiltonian]
impl Plane {
    fn kinetic(&self, p: &[[f64; 12]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            for j in 0..12 {
                sum += p[i][j] * p[i][j] / 2.0;
            }
        }
        sum
    }
    fn potential(&self, q: &[[f64; 12]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..12 {
                sum -= (q[i][(j + 1) % 12] - q[i][j]).cos() + (q[(i + 1) % q.len()][j] - q[i][j]).cos();
            }
        }
        sum
    }
}

pub(crate) fn plane(rows: &[usize]) -> (Plane, Phase<Vec<[f64; 12]>>) {
    let row = |row: &usize| std::array::from_fn(|j| angle(12 * row + j).sin());
    (Plane, Phase::new(rows.iter().map(row).collect(), vec![[0.1; 12]; rows.len()]))
}

/// A volume of springs in wells that is closed from plane to plane.
#[derive(Clone)]
pub(crate) struct Volume;

#[hamiltonian]
impl Volume {
    fn kinetic(&self, p: &[[[f64; 8]; 3]]) -> f64 {
        p.iter().flatten().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[[f64; 8]; 3]]) -> f64 {
        let mut sum = 0.0;
        for k in 0..q.len() {
            for j in 0..3 {
                for i in 0..8 {
                    let x = q[k][j][i];
                    sum += (q[k][(j + 1) % 3][i] - x).powi(2) / 2.0 + (q[k][j][(i + 1) % 8] - x).powi(4) / 4.0;
                    sum += (q[(k + 1) % q.len()][j][i] - x).powi(2) / 2.0 + x.powi(4) / 4.0;
                }
            }
        }
        sum
    }
}

pub(crate) fn volume(planes: &[usize]) -> (Volume, Phase<Vec<[[f64; 8]; 3]>>) {
    let plane = |plane: &usize| std::array::from_fn(|j| std::array::from_fn(|i| angle(24 * plane + 8 * j + i).sin()));
    (Volume, Phase::new(planes.iter().map(plane).collect(), vec![[[0.1; 8]; 3]; planes.len()]))
}

/// Each site runs away from its neighbours, where it is not at rest with them.
#[derive(Clone)]
pub(crate) struct Runaway;

#[hamiltonian]
impl Runaway {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (0..q.len() - 1).map(|i| -(q[i + 1] - q[i]).powi(4)).sum()
    }
}

/// A pulse around one site.
pub(crate) fn runaway(sites: &[usize]) -> (Runaway, Phase<Vec<f64>>) {
    let q = sites.iter().map(|site| if *site == 1_100 { 1.0 } else { 0.0 }).collect();
    (Runaway, Phase::new(q, vec![0.0; sites.len()]))
}

/// A formula that reads how many sites there are.
#[derive(Clone)]
pub(crate) struct Spacing;

#[hamiltonian]
impl Spacing {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let stiffness = q.len() as f64 / 1e4;
        (0..q.len() - 1).map(|i| stiffness * (q[i + 1] - q[i]).powi(2)).sum()
    }
}

/// At rest, where no step tells of it.
pub(crate) fn spacing(sites: &[usize]) -> (Spacing, Phase<Vec<f64>>) {
    (Spacing, Phase::new(vec![0.0; sites.len()], vec![0.0; sites.len()]))
}

/// One of a constant number of sites.
pub(crate) struct Short;

#[hamiltonian]
impl Short {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0].powi(2) + p[1].powi(2)
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] - q[1]).powi(2)
    }
}

/// A ring of quartic springs, of sites that are driven apart.
#[derive(Clone)]
pub(crate) struct Steep {
    stiffness: f64,
    push: f64,
}

#[hamiltonian]
impl Steep {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let springs: f64 = (0..q.len()).map(|i| self.stiffness * (q[(i + 1) % q.len()] - q[i]).powi(4) / 4.0).sum();
        springs - q.iter().map(|q| self.push * q * q / 2.0).sum::<f64>()
    }
}

/// A smooth wave so high that springs between sites that are not neighbours tear them apart within a few steps.
pub(crate) fn high(sites: &[usize]) -> (Steep, Phase<Vec<f64>>) {
    let q = sites.iter().map(|site| 100.0 * (1.0 + *site as f64 * TAU / SITES as f64).sin()).collect();
    (Steep { stiffness: 1.0, push: 0.0 }, Phase::new(q, vec![0.0; sites.len()]))
}

/// A smooth wave that grows until the force of such a spring is beyond all numbers, while those between neighbours are weak.
pub(crate) fn growing(sites: &[usize]) -> (Steep, Phase<Vec<f64>>) {
    let (_, start) = high(sites);
    (Steep { stiffness: 1e-210, push: 400.0 }, start)
}
