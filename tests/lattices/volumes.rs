//! Volumes, planes of rows one behind the other, against plain loops by hand.

use super::planes::hold_energies;
use integrator_core::{Coords, Error, prelude::*};

/// Planes of rows of sites.
type Planes<const L: usize, const M: usize> = Vec<[[f64; L]; M]>;

/// Closed in all directions, with constants of planes, of rows, of their sites, and of all sites; no two bonds are alike.
struct Torus<const L: usize, const M: usize> {
    stiffness: Vec<f64>,
    coupling: Vec<f64>,
    well: Vec<f64>,
    field: Vec<Vec<Vec<f64>>>,
}

#[hamiltonian]
impl<const L: usize, const M: usize> Torus<L, M> {
    fn kinetic(&self, p: &[[[f64; L]; M]]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; L]; M]]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for k in 0..n {
            for j in 0..M {
                for i in 0..L {
                    let x = q[k][j][i];
                    energy += self.stiffness[i] * ((q[k][j][(i + 1) % L] - x).cosh() - 1.0);
                    energy += self.coupling[j] * (q[k][(j + 1) % M][i] - x).powi(4) / 4.0;
                    energy += 0.5 * (q[(k + 1) % n][j][i] - x).powi(2) + self.well[k] * x.powi(4) / 4.0;
                    energy += self.field[k][j][i] * x;
                }
            }
        }
        energy
    }
}

/// Open in all directions: bonds that are numbered by the site to which they lead, across rows also aside, a front plane and a
/// left column that are held, and a corner.
struct Block<const L: usize, const M: usize>;

#[hamiltonian]
impl<const L: usize, const M: usize> Block<L, M> {
    fn kinetic(&self, p: &[[[f64; L]; M]]) -> f64 {
        let mut energy = 0.0;
        for plane in p {
            for row in plane {
                for i in 0..L {
                    energy += 0.5 * row[i] * row[i];
                }
            }
        }
        energy
    }
    fn potential(&self, q: &[[[f64; L]; M]]) -> f64 {
        let n = q.len();
        let mut energy = 0.1 * q[0][0][0].powi(4);
        for k in 0..n {
            for j in 0..M {
                energy += 0.3 * q[k][j][0].powi(2);
                for i in 1..L {
                    energy += 0.5 * (q[k][j][i] - q[k][j][i - 1]).powi(2);
                }
            }
            for j in 1..M {
                for i in 0..L - 1 {
                    energy += 0.4 * (q[k][j][i + 1] - q[k][j - 1][i]).powi(2);
                }
            }
        }
        for k in 1..n {
            for j in 0..M {
                for i in 0..L {
                    energy += 0.25 * (q[k][j][i] - q[k - 1][j][i]).powi(4);
                }
            }
        }
        for j in 0..M {
            for i in 0..L {
                energy += 0.2 * q[n - 1][j][i].powi(2);
            }
        }
        energy
    }
}

/// Planes whose ends are told by conditions, between planes a bond that goes aside too: it has a plain loop.
struct Stack;

#[hamiltonian]
impl Stack {
    fn kinetic(&self, p: &[[[f64; 8]; 3]]) -> f64 {
        let mut energy = 0.0;
        for k in 0..p.len() {
            for j in 0..3 {
                for i in 0..8 {
                    energy += 0.5 * p[k][j][i].powi(2);
                }
            }
        }
        energy
    }
    fn potential(&self, q: &[[[f64; 8]; 3]]) -> f64 {
        let mut energy = 0.0;
        for k in 0..q.len() {
            for j in 0..3 {
                for i in 0..8 {
                    let aside = if k + 1 < q.len() { q[k + 1][(j + 1) % 3][i] } else { 0.0 };
                    energy += 0.5 * (q[k][j][i] - aside).powi(2);
                }
            }
        }
        energy
    }
}

/// A system with its gradient by plain loops.
trait ByHand<const L: usize, const M: usize>: Hamiltonian<Coords = Planes<L, M>> {
    const NAME: &'static str;
    fn example() -> Self;
    fn gradient_by_loops(&self, q: &[[[f64; L]; M]]) -> Planes<L, M>;
    /// `T` and `V` by the functions themselves.
    fn energies(&self, state: &Phase<Planes<L, M>>) -> [f64; 2];
}

/// The indices of a site: plane, row, and place in it.
type Site = [usize; 3];

/// Adds the slope of a bond at its ends.
fn pull<const L: usize, const M: usize>(gradient: &mut [[[f64; L]; M]], from: Site, to: Site, slope: f64) {
    gradient[to[0]][to[1]][to[2]] += slope;
    gradient[from[0]][from[1]][from[2]] -= slope;
}

fn sites<const L: usize, const M: usize>(planes: usize) -> impl Iterator<Item = Site> {
    (0..planes).flat_map(|k| (0..M).flat_map(move |j| (0..L).map(move |i| [k, j, i])))
}

impl<const L: usize, const M: usize> ByHand<L, M> for Torus<L, M> {
    fn energies(&self, state: &Phase<Planes<L, M>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "torus";

    fn example() -> Self {
        let table = |scale: f64, count: usize| (0..count).map(|i| 1.0 + scale * (i as f64).sin()).collect::<Vec<_>>();
        let field = |k: usize| (0..M).map(|j| table(0.1 * (1 + k + 2 * j) as f64, L)).collect();
        Self {
            stiffness: table(0.5, L),
            coupling: table(0.3, M),
            well: table(0.4, MOST),
            field: (0..MOST).map(field).collect(),
        }
    }
    fn gradient_by_loops(&self, q: &[[[f64; L]; M]]) -> Planes<L, M> {
        let mut gradient = vec![[[0.0; L]; M]; q.len()];
        for [k, j, i] in sites::<L, M>(q.len()) {
            let ([right, below, behind], x) = ([(i + 1) % L, (j + 1) % M, (k + 1) % q.len()], q[k][j][i]);
            gradient[k][j][i] += self.well[k] * x.powi(3) + self.field[k][j][i];
            let along = self.stiffness[i] * (q[k][j][right] - x).sinh();
            pull(&mut gradient, [k, j, i], [k, j, right], along);
            let across = self.coupling[j] * (q[k][below][i] - x).powi(3);
            pull(&mut gradient, [k, j, i], [k, below, i], across);
            pull(&mut gradient, [k, j, i], [behind, j, i], q[behind][j][i] - x);
        }
        gradient
    }
}

impl<const L: usize, const M: usize> ByHand<L, M> for Block<L, M> {
    fn energies(&self, state: &Phase<Planes<L, M>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "block";

    fn example() -> Self {
        Self
    }
    fn gradient_by_loops(&self, q: &[[[f64; L]; M]]) -> Planes<L, M> {
        let mut gradient = vec![[[0.0; L]; M]; q.len()];
        gradient[0][0][0] += 0.4 * q[0][0][0].powi(3);
        for [k, j, i] in sites::<L, M>(q.len()) {
            let x = q[k][j][i];
            match i {
                0 => gradient[k][j][i] += 0.6 * x,
                _ => pull(&mut gradient, [k, j, i - 1], [k, j, i], x - q[k][j][i - 1]),
            }
            if k == q.len() - 1 {
                gradient[k][j][i] += 0.4 * x;
            }
            if j >= 1 && i + 1 < L {
                pull(&mut gradient, [k, j - 1, i], [k, j, i + 1], 0.8 * (q[k][j][i + 1] - q[k][j - 1][i]));
            }
            if k >= 1 {
                pull(&mut gradient, [k - 1, j, i], [k, j, i], (x - q[k - 1][j][i]).powi(3));
            }
        }
        gradient
    }
}

impl ByHand<8, 3> for Stack {
    fn energies(&self, state: &Phase<Planes<8, 3>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "stack";

    fn example() -> Self {
        Self
    }
    fn gradient_by_loops(&self, q: &[[[f64; 8]; 3]]) -> Planes<8, 3> {
        let mut gradient = vec![[[0.0; 8]; 3]; q.len()];
        for [k, j, i] in sites::<8, 3>(q.len()) {
            gradient[k][j][i] += q[k][j][i];
            if k + 1 < q.len() {
                let aside = q[k + 1][(j + 1) % 3][i];
                gradient[k][j][i] -= aside;
                gradient[k + 1][(j + 1) % 3][i] += aside - q[k][j][i];
            }
        }
        gradient
    }
}

/// A state in which no two sites are alike.
fn start<const L: usize, const M: usize>(planes: usize) -> Phase<Planes<L, M>> {
    let wave = |speed: f64| {
        let mut wave = vec![[[0.0; L]; M]; planes];
        for (number, [k, j, i]) in sites::<L, M>(planes).enumerate() {
            wave[k][j][i] = 0.4 * (speed * number as f64 + 0.3).sin();
        }
        wave
    };
    Phase::new(wave(0.7), wave(1.3))
}

const STEP: f64 = 0.01;
const STEPS: u64 = 20;

/// The most planes of a volume here.
const MOST: usize = 5;

/// Verlet by hand.
fn by_hand<const L: usize, const M: usize, H: ByHand<L, M>>(system: &H, planes: usize) -> Phase<Planes<L, M>> {
    let Phase { mut q, mut p } = start::<L, M>(planes);
    for _ in 0..STEPS {
        for half in 0..2 {
            for [k, j, i] in sites::<L, M>(planes) {
                q[k][j][i] += 0.5 * STEP * p[k][j][i];
            }
            if half == 0 {
                let gradient = system.gradient_by_loops(&q);
                for [k, j, i] in sites::<L, M>(planes) {
                    p[k][j][i] -= STEP * gradient[k][j][i];
                }
            }
        }
    }
    Phase::new(q, p)
}

/// Where a run is after all steps.
fn end<C: Coords>(run: Result<Run<C>, Error>) -> Phase<C> {
    let mut run = run.expect("a start");
    run.advance(STEPS).expect("finite states");
    run.state()
}

fn followed<H: Hamiltonian>(system: &H, start: Phase<H::Coords>) -> Phase<H::Coords> {
    end(system.run_with::<f64, Verlet>(Verlet, start, STEP))
}

fn hold<const L: usize, const M: usize>(name: &str, state: &Phase<Planes<L, M>>, expected: &Phase<Planes<L, M>>) {
    let planes = expected.q.len();
    assert_eq!(state.q.len(), planes);
    // As in `every_length`, for half of the steps and the operations of three bonds.
    for [k, j, i] in sites::<L, M>(planes) {
        for (a, b) in [(state.q[k][j][i], expected.q[k][j][i]), (state.p[k][j][i], expected.p[k][j][i])] {
            assert!((a - b).abs() < 5e-12, "{name}, {planes} planes of {M} by {L}: {a} for {b} at {k}, {j}, {i}");
        }
    }
}

/// One system with planes of one size, any number of them.
fn any_depth<const L: usize, const M: usize, H: ByHand<L, M>>() {
    let system = H::example();
    for planes in [1, 2, 3, MOST] {
        let (state, expected) = (followed(&system, start::<L, M>(planes)), by_hand(&system, planes));
        hold(H::NAME, &state, &expected);
        let start = start::<L, M>(planes);
        let energies = system.energies(&start);
        hold_energies(&system.run(start, STEP).expect("a start"), energies);
    }
}

/// Every size takes long to compile: each system has one whose rows fill no block, and one of more than a block.
#[test]
fn volumes_of_every_kind_of_size() {
    any_depth::<3, 2, Torus<3, 2>>();
    any_depth::<19, 5, Torus<19, 5>>();
    any_depth::<16, 1, Block<16, 1>>();
    any_depth::<21, 4, Block<21, 4>>();
    any_depth::<8, 3, Stack>();
}

/// A run computes neighbouring sites side by side, an ensemble members: no bit tells.
#[test]
fn volumes_have_the_same_bits_in_lanes() {
    let members = (0..9).map(|_| (Torus::<19, 5>::example(), start(3)));
    let mut together = Ensemble::new(Verlet, members, STEP).expect("starts");
    together.advance(STEPS).expect("finite states");
    let alone = followed(&Torus::<19, 5>::example(), start::<19, 5>(3));
    assert!((0..9).all(|member| together.state(member) == Some(alone.clone())));
}

/// Springs in a box whose sizes the type knows.
#[derive(Clone, Copy)]
struct Springs;

#[hamiltonian(taylor)]
impl Springs {
    fn kinetic(&self, p: &[[[f64; 8]; 2]; 2]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; 8]; 2]; 2]) -> f64 {
        let mut energy = 0.0;
        for k in 0..2 {
            for j in 0..2 {
                for i in 0..8 {
                    let x = q[k][j][i];
                    energy += 0.5 * (q[(k + 1) % 2][j][i] - x).powi(2) + 0.1 * x.powi(4);
                    energy += 0.5 * (q[k][(j + 1) % 2][i] - x).powi(2) + 0.5 * (q[k][j][(i + 1) % 8] - x).powi(2);
                }
            }
        }
        energy
    }
}

/// Numbers of 64 and 32 bits, arrays and lists, compensated or not, have one motion; the certificate holds of it.
#[test]
fn every_shape_and_precision_has_volumes() {
    let Phase { q, p } = start::<8, 2>(2);
    let array = |planes: &Planes<8, 2>| <[[[f64; 8]; 2]; 2]>::try_from(planes.clone()).expect("as many");
    let (q, p) = (array(&q), array(&p));
    let exact = followed(&Springs, Phase::new(q, p));
    let compensated = end(Springs.run(Phase::compensated(q, p), STEP));
    let single = |planes: [[[f64; 8]; 2]; 2]| planes.map(|plane| plane.map(|row| row.map(|x| x as f32)));
    let singles = end(Springs.run(Phase::new(single(q), single(p)), STEP));
    for [k, j, i] in sites::<8, 2>(2) {
        let (value, expected) = (compensated.q[k][j][i].value, exact.q[k][j][i]);
        assert!((value - expected).abs() < 5e-12, "{value} for {expected}");
        // The same with the rounding of a number of 32 bits, 6e-8.
        let value = f64::from(singles.q[k][j][i]);
        assert!((value - expected).abs() < 5e-12 * 6e-8 / 1.1e-16, "{value} for {expected}");
    }
    let by_series = end(Springs.run_with(Taylor::tolerance(1e-15), Phase::new(q, p), STEP));
    let eighth = end(Springs.run_with(KahanLi8, Phase::new(q, p), STEP));
    let list = |planes: [[[f64; 8]; 2]; 2]| planes.to_vec();
    let of_lists = |Phase { q, p }| Phase::new(list(q), list(p));
    hold("series", &of_lists(by_series), &of_lists(eighth));
    let certificate = certify(&Springs, TakahashiImada4, Phase::new(q, p), 0.1);
    certificate.expect("a certificate");
}

/// A closed volume.
#[derive(Clone, Copy)]
struct Closed<const L: usize, const M: usize>;

#[hamiltonian]
impl<const L: usize, const M: usize> Closed<L, M> {
    fn kinetic(&self, p: &[[[f64; L]; M]]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; L]; M]]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for k in 0..n {
            for j in 0..M {
                for i in 0..L {
                    let x = q[k][j][i];
                    energy += 0.35 * (q[k][j][(i + 1) % L] - x).powi(2) + 0.25 * x.powi(4);
                    energy += 0.1 * (q[k][(j + 1) % M][i] - x).powi(4) + 0.2 * (q[(k + 1) % n][j][i] - x).powi(4);
                }
            }
        }
        energy
    }
}

/// Tiles of planes and threads, against members of an ensemble, which have neither.
#[test]
fn tiles_and_threads_on_planes_change_no_bit() {
    // The fewer planes are too few for chunks: threads share them flow by flow.
    for planes in [97, 29] {
        change_no_bit(planes);
    }
}

fn change_no_bit(planes: usize) {
    const ALL: u64 = 4;
    let (system, start) = (Closed::<40, 30>, start::<40, 30>(planes));
    let members = [(system, start.clone()), (system, start.clone())];
    let mut together = Ensemble::new(Yoshida4, members, STEP).expect("starts");
    together.advance(ALL).expect("finite states");
    let expected = together.state(0).expect("a member");
    for (threads, portion) in [(1, 4), (2, 4), (3, 1)] {
        let mut run = system.run_with(Yoshida4, start.clone(), STEP).expect("a start").with_threads(threads);
        for _ in 0..ALL / portion {
            run.advance(portion).expect("finite states");
        }
        assert!(run.state() == expected, "{planes} planes, {threads} threads, {portion} steps");
    }
}
