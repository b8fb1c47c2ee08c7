//! Sums over rows of data, matrices, graphs, planes, chains and mean fields.

use crate::{Group, of_data, spellings};
use integrator_core::prelude::*;

const ROWS: usize = 1000;
const COVARIATES: usize = 20;
const SIZE: usize = 500;
const SITES: usize = 4000;
const WIDTH: usize = 64;
const STEP: f64 = 0.001;

#[derive(Clone)]
struct Data {
    covariates: Vec<f64>,
    outcomes: Vec<f64>,
    couplings: Vec<Vec<f64>>,
    flat: Vec<f64>,
    neighbours: Vec<Vec<usize>>,
    /// The same as one list: where that of each site begins, and the neighbours.
    offsets: Vec<usize>,
    targets: Vec<usize>,
    edges: Vec<[usize; 2]>,
    width: usize,
    strength: f64,
}

fn data() -> Data {
    let coupling = |i: usize, j: usize| if i == j { 0.0 } else { 0.001 * ((i * j) as f64).cos() };
    let links = |i: usize| [1, 17, SITES - 1, SITES - 17].map(|step| (i + step) % SITES).to_vec();
    Data {
        covariates: (0..ROWS * COVARIATES).map(|k| (0.7 * k as f64).sin()).collect(),
        outcomes: (0..ROWS).map(|row| (row % 2) as f64).collect(),
        couplings: (0..SIZE).map(|i| (0..SIZE).map(|j| coupling(i, j)).collect()).collect(),
        flat: (0..SIZE * SIZE).map(|k| coupling(k / SIZE, k % SIZE)).collect(),
        neighbours: (0..SITES).map(links).collect(),
        offsets: (0..=SITES).map(|i| 4 * i).collect(),
        targets: (0..SITES).flat_map(links).collect(),
        edges: (0..SITES).flat_map(|i| [1, 17].map(|step| [i, (i + step) % SITES])).collect(),
        width: WIDTH,
        strength: 0.1,
    }
}

fn waves(length: usize) -> Phase<Vec<f64>> {
    Phase::new((0..length).map(|i| (0.37 * i as f64).sin()).collect(), vec![0.0; length])
}

of_data!(Array, [f64; 21], |self, b| {
    let mut v = 0.0;
    for row in 0..self.0.outcomes.len() {
        let mut z = b[0];
        for k in 0..20 {
            z += self.0.covariates[row * 20 + k] * b[k + 1];
        }
        v += z.exp().ln_1p() - self.0.outcomes[row] * z;
    }
    v
});
of_data!(Constants, [f64; COVARIATES + 1], |self, b| {
    let mut v = 0.0;
    for row in 0..self.0.outcomes.len() {
        let mut z = b[0];
        for k in 0..COVARIATES {
            z += self.0.covariates[row * COVARIATES + k] * b[k + 1];
        }
        v += z.exp().ln_1p() - self.0.outcomes[row] * z;
    }
    v
});
of_data!(Slice, |self, b| {
    let mut v = 0.0;
    for row in 0..self.0.outcomes.len() {
        let mut z = b[0];
        for k in 0..b.len() - 1 {
            z += self.0.covariates[row * (b.len() - 1) + k] * b[k + 1];
        }
        v += z.exp().ln_1p() - self.0.outcomes[row] * z;
    }
    v
});
of_data!(Iterators, |self, b| self
    .0
    .covariates
    .chunks_exact(20)
    .zip(&self.0.outcomes)
    .map(|(row, outcome)| {
        let z = b[0] + row.iter().zip(&b[1..]).map(|(x, b)| x * b).sum::<f64>();
        z.exp().ln_1p() - outcome * z
    })
    .sum());

of_data!(Square, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            v += 0.5 * self.0.couplings[i][j] * q[i] * q[j];
        }
    }
    v
});
of_data!(FlatSquare, |self, q| {
    let n = q.len();
    let mut v = 0.0;
    for i in 0..n {
        for j in 0..n {
            v += 0.5 * self.0.flat[i * n + j] * q[i] * q[j];
        }
    }
    v
});
of_data!(Triangle, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..i {
            v += self.0.couplings[i][j] * q[i] * q[j];
        }
    }
    v
});

of_data!(OthersThanItself, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            if i != j {
                v += 0.5 * self.0.couplings[i][j] * q[i] * q[j];
            }
        }
    }
    v
});
of_data!(SquareByIterators, |self, q| q
    .iter()
    .zip(&self.0.couplings)
    .map(|(qi, row)| 0.5 * qi * row.iter().zip(q).map(|(c, qj)| c * qj).sum::<f64>())
    .sum());

of_data!(Edges, |self, q| {
    let mut v = 0.0;
    for &[i, j] in &self.0.edges {
        v -= (q[i] - q[j]).cos();
    }
    v
});
of_data!(Neighbours, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for &j in &self.0.neighbours[i] {
            v -= 0.5 * (q[i] - q[j]).cos();
        }
    }
    v
});

of_data!(Offsets, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for k in self.0.offsets[i]..self.0.offsets[i + 1] {
            v -= 0.5 * (q[i] - q[self.0.targets[k]]).cos();
        }
    }
    v
});
of_data!(NeighboursByIterators, |self, q| {
    let around = |i: usize| self.0.neighbours[i].iter().map(|&j| (q[i] - q[j]).cos()).sum::<f64>();
    -0.5 * (0..q.len()).map(around).sum::<f64>()
});

struct Rows(Data);

#[hamiltonian]
impl Rows {
    fn kinetic(&self, p: &[[f64; WIDTH]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; WIDTH]]) -> f64 {
        let mut v = 0.0;
        for y in 0..q.len() {
            for x in 0..WIDTH {
                v += 0.5 * (q[y][x] - q[y][(x + 1) % WIDTH]).powi(2);
                v += 0.5 * (q[y][x] - q[(y + 1) % q.len()][x]).powi(2) + self.0.strength * q[y][x].powi(4);
            }
        }
        v
    }
}
of_data!(FlatPlane, |self, q| {
    let (w, h) = (self.0.width, q.len() / self.0.width);
    let mut v = 0.0;
    for y in 0..h {
        for x in 0..w {
            v += 0.5 * (q[y * w + x] - q[y * w + (x + 1) % w]).powi(2);
            v += 0.5 * (q[y * w + x] - q[(y + 1) % h * w + x]).powi(2) + self.0.strength * q[y * w + x].powi(4);
        }
    }
    v
});

of_data!(PlaneByIf, |self, q| {
    let (w, h) = (self.0.width, q.len() / self.0.width);
    let mut v = 0.0;
    for y in 0..h {
        for x in 0..w {
            let right = if x + 1 == w { q[y * w] } else { q[y * w + x + 1] };
            let below = if y + 1 == h { q[x] } else { q[(y + 1) * w + x] };
            let here = q[y * w + x];
            v += 0.5 * (here - right).powi(2) + 0.5 * (here - below).powi(2) + self.0.strength * here.powi(4);
        }
    }
    v
});

of_data!(Walls, |self, q| {
    let n = q.len();
    let mut v = 0.5 * (q[0] * q[0] + q[n - 1] * q[n - 1]);
    for i in 0..n - 1 {
        v += 0.5 * (q[i + 1] - q[i]).powi(2) + self.0.strength * q[i].powi(4);
    }
    v + self.0.strength * q[n - 1].powi(4)
});
of_data!(Windows, |self, q| {
    let bonds: f64 = q.windows(2).map(|pair| 0.5 * (pair[1] - pair[0]).powi(2)).sum();
    let sites: f64 = q.iter().map(|q| self.0.strength * q.powi(4)).sum();
    bonds + sites + 0.5 * (q[0].powi(2) + q[q.len() - 1].powi(2))
});
of_data!(EndsByIf, |self, q| {
    let n = q.len();
    let mut v = 0.0;
    for i in 0..=n {
        let left = if i == 0 { 0.0 } else { q[i - 1] };
        let right = if i == n { 0.0 } else { q[i] };
        v += 0.5 * (right - left).powi(2) + self.0.strength * right.powi(4);
    }
    v
});

of_data!(NeighbourByIf, |self, q| {
    let n = q.len();
    let mut v = 0.5 * q[n - 1] * q[n - 1];
    for i in 0..n {
        let left = if i == 0 { 0.0 } else { q[i - 1] };
        v += 0.5 * (q[i] - left).powi(2) + self.0.strength * q[i].powi(4);
    }
    v
});

of_data!(MeanField, |self, q| {
    let c: f64 = q.iter().map(|q| q.cos()).sum();
    let s: f64 = q.iter().map(|q| q.sin()).sum();
    -self.0.strength * (c * c + s * s) / (2.0 * q.len() as f64)
});
of_data!(MeanFieldByLoop, |self, q| {
    let (mut c, mut s) = (0.0, 0.0);
    for i in 0..q.len() {
        c += q[i].cos();
        s += q[i].sin();
    }
    -self.0.strength * (c * c + s * s) / (2.0 * q.len() as f64)
});

pub(crate) fn groups() -> Vec<Group<'static>> {
    let mut regression = Group::new("regression", 200);
    let array = || Phase::new(std::array::from_fn(|k| (0.37 * k as f64).sin()), [0.0; COVARIATES + 1]);
    spellings!(regression, data(), array(), STEP; "array" Array, "array of a constant" Constants);
    spellings!(regression, data(), waves(COVARIATES + 1), STEP; "slice" Slice, "iterators" Iterators);
    let mut matrix = Group::new("matrix", 50);
    spellings!(matrix, data(), waves(SIZE), STEP;
        "half of all entries" Square, "the same, flat" FlatSquare, "lower triangle" Triangle,
        "others than itself" OthersThanItself, "iterators" SquareByIterators,
    );
    let mut graph = Group::new("graph", 100);
    spellings!(graph, data(), waves(SITES), STEP;
        "edges" Edges, "lists of neighbours" Neighbours, "one list and offsets" Offsets,
        "neighbours by iterators" NeighboursByIterators,
    );
    let mut plane = Group::new("plane", 1000);
    let wave = |k: usize| (0.37 * k as f64).sin();
    let rows = || {
        let row = |y: usize| std::array::from_fn(|x| wave(y * WIDTH + x));
        Phase::new((0..WIDTH).map(row).collect(), vec![[0.0; WIDTH]; WIDTH])
    };
    spellings!(plane, data(), rows(), STEP; "rows" Rows);
    spellings!(plane, data(), waves(WIDTH * WIDTH), STEP; "flat coordinates" FlatPlane, "ends by if" PlaneByIf);
    let mut chain = Group::new("chain", 2000);
    spellings!(chain, data(), waves(SITES), STEP;
        "loop over bonds" Walls, "windows" Windows, "ends by if" EndsByIf, "left end by if" NeighbourByIf,
    );
    let mut mean_field = Group::new("mean field", 500);
    spellings!(mean_field, data(), waves(SITES), STEP; "iterators" MeanField, "loop" MeanFieldByLoop);
    vec![regression, matrix, graph, plane, chain, mean_field]
}
