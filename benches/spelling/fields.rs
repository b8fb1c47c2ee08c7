//! Two fields in one list of coordinates, rotors on a matrix, and data models.

use crate::{Group, of_data, spellings};
use integrator_core::prelude::*;

const SITES: usize = 4000;
const ROTORS: usize = 500;
const POINTS: usize = 1000;
const STEP: f64 = 0.001;

#[derive(Clone)]
struct Data {
    couplings: Vec<Vec<f64>>,
    points: Vec<f64>,
    strength: f64,
}

fn data() -> Data {
    let coupling = |i: usize, j: usize| 0.01 * ((i * j + i + j) as f64).cos();
    Data {
        couplings: (0..ROTORS).map(|i| (0..ROTORS).map(|j| coupling(i, j)).collect()).collect(),
        points: (0..POINTS).map(|k| 2.0 * (0.7 * k as f64).sin()).collect(),
        strength: 0.1,
    }
}

fn wave(k: usize) -> f64 {
    (0.37 * k as f64).sin()
}

fn waves(length: usize) -> Phase<Vec<f64>> {
    Phase::new((0..length).map(wave).collect(), vec![0.0; length])
}

of_data!(OneAfterTheOther, |self, q| {
    let n = q.len() / 2;
    let mut v = 0.0;
    for i in 0..n {
        v += 0.5 * (q[i].powi(2) + q[n + i].powi(2)) + self.0.strength * q[i].cos() * q[n + i].powi(2);
    }
    v
});
of_data!(InTurn, |self, q| {
    let mut v = 0.0;
    for i in (0..q.len()).step_by(2) {
        v += 0.5 * (q[i].powi(2) + q[i + 1].powi(2)) + self.0.strength * q[i].cos() * q[i + 1].powi(2);
    }
    v
});
of_data!(InTurnByIndex, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() / 2 {
        let (x, y) = (q[2 * i], q[2 * i + 1]);
        v += 0.5 * (x * x + y * y) + self.0.strength * x.cos() * y * y;
    }
    v
});
of_data!(Halves, |self, q| {
    let (x, y) = q.split_at(q.len() / 2);
    x.iter().zip(y).map(|(x, y)| 0.5 * (x * x + y * y) + self.0.strength * x.cos() * y * y).sum()
});

struct AsPoints(Data);

#[hamiltonian]
impl AsPoints {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        q.iter().map(|[x, y]| 0.5 * (x * x + y * y) + self.0.strength * x.cos() * y * y).sum()
    }
}

of_data!(AllRotors, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            v -= 0.5 * self.0.couplings[i][j] * (q[i] - q[j]).cos();
        }
    }
    v
});
of_data!(RotorsBefore, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..i {
            v -= 0.5 * (self.0.couplings[i][j] + self.0.couplings[j][i]) * (q[i] - q[j]).cos();
        }
        v -= 0.5 * self.0.couplings[i][i];
    }
    v
});
of_data!(RotorsByIterators, |self, q| {
    let rows = q.iter().zip(&self.0.couplings);
    -0.5 * rows.map(|(qi, row)| row.iter().zip(q).map(|(c, qj)| c * (qi - qj).cos()).sum::<f64>()).sum::<f64>()
});

of_data!(Funnel, |self, q| {
    let scale = (-q[0]).exp();
    let mut v = q[0] * q[0] / 18.0 + 0.5 * (q.len() - 1) as f64 * q[0];
    for i in 1..q.len() {
        v += 0.5 * q[i] * q[i] * scale;
    }
    v
});
of_data!(FunnelByIterators, |self, q| {
    let squares: f64 = q[1..].iter().map(|x| x * x).sum();
    q[0].powi(2) / 18.0 + 0.5 * (q.len() - 1) as f64 * q[0] + 0.5 * squares * (-q[0]).exp()
});

of_data!(Mixture, [f64; 4], |self, q| {
    let mut v = 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for x in &self.0.points {
        v -= (q[2].exp() * (-0.5 * (x - q[0]).powi(2)).exp() + q[3].exp() * (-0.5 * (x - q[1]).powi(2)).exp()).ln();
    }
    v
});
of_data!(MixtureBySums, [f64; 4], |self, q| {
    let density = |x: f64| (0..2).map(|k| (q[2 + k] - 0.5 * (x - q[k]).powi(2)).exp()).sum::<f64>();
    let prior: f64 = q.iter().map(|q| 0.5 * q * q).sum();
    prior - self.0.points.iter().map(|&x| density(x).ln()).sum::<f64>()
});

pub(crate) fn groups() -> Vec<Group<'static>> {
    let mut two_fields = Group::new("two fields", 500);
    let points = || Phase::new((0..SITES).map(|i| [wave(i), wave(SITES + i)]).collect(), vec![[0.0; 2]; SITES]);
    let in_turn = || {
        let points: Vec<[f64; 2]> = (0..SITES).map(|i| [wave(i), wave(SITES + i)]).collect();
        Phase::new(points.as_flattened().to_vec(), vec![0.0; 2 * SITES])
    };
    spellings!(two_fields, data(), waves(2 * SITES), STEP; "one after the other" OneAfterTheOther, "halves" Halves);
    spellings!(two_fields, data(), in_turn(), STEP; "in turn" InTurn, "in turn by index" InTurnByIndex);
    spellings!(two_fields, data(), points(), STEP; "points" AsPoints);
    let mut rotors = Group::new("rotors on a matrix", 20);
    spellings!(rotors, data(), waves(ROTORS), STEP;
        "all pairs" AllRotors, "pairs before" RotorsBefore, "iterators" RotorsByIterators,
    );
    let mut funnel = Group::new("funnel", 2000);
    spellings!(funnel, data(), waves(SITES), STEP; "loop" Funnel, "iterators" FunnelByIterators);
    let mut mixture = Group::new("mixture of Gaussians", 200);
    let start = || Phase::new([-0.5, 0.6, -0.2, 0.1], [0.0; 4]);
    spellings!(mixture, data(), start(), 0.01 * STEP; "two terms" Mixture, "sums" MixtureBySums);
    vec![two_fields, rotors, funnel, mixture]
}
