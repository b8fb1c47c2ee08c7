//! Planes of rows, in blocks of neighbouring sites, against plain loops by hand, at every small size.

use integrator_core::{Coords, InstructionSet, prelude::*};

/// Rows of sites.
type Rows<const W: usize> = Vec<[f64; W]>;

/// Closed in both directions, with constants of rows, of columns and of sites; no two bonds are alike.
struct Torus<const W: usize> {
    mass: Vec<Vec<f64>>,
    stiffness: Vec<f64>,
    coupling: Vec<f64>,
    well: f64,
}

#[hamiltonian]
impl<const W: usize> Torus<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            for j in 0..W {
                energy += p[i][j].powi(2) / (2.0 * self.mass[i][j]);
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..n {
            for j in 0..W {
                energy += self.stiffness[j] * ((q[i][(j + 1) % W] - q[i][j]).cosh() - 1.0);
                energy += self.coupling[i] * (q[(i + 1) % n][j] - q[i][j]).powi(4) / 4.0;
                energy += self.well * q[i][j].powi(4) / 4.0;
            }
        }
        energy
    }
}

/// Open in both directions: bonds that are numbered by the site to which they lead, along rows also to the second next
/// and across to the next row, a bottom row and a left column that are held, and a corner.
struct Sheet<const W: usize>;

#[hamiltonian]
impl<const W: usize> Sheet<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for row in p {
            for j in 0..W {
                energy += 0.5 * row[j] * row[j];
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let n = q.len();
        let mut energy = 0.1 * q[0][0].powi(4);
        for i in 0..n {
            energy += 0.3 * q[i][0].powi(2);
            for j in 2..W {
                energy += 0.5 * (q[i][j] - q[i][j - 2] + 0.1 * q[i][j - 1]).powi(2);
            }
        }
        for i in 1..n {
            for j in 0..W {
                energy += 0.25 * (q[i][j] - q[i - 1][j]).powi(4);
            }
            for j in 0..W - 1 {
                energy += 0.4 * (q[i][j + 1] - q[i - 1][j]).powi(2);
            }
        }
        for j in 0..W {
            energy += 0.2 * q[n - 1][j].powi(2);
        }
        energy
    }
}

/// Closed rows that lie open one beside the other; bonds lead back, and across to the left.
struct Tube<const W: usize> {
    torn: f64,
}

#[hamiltonian]
impl<const W: usize> Tube<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for j in 0..W {
            for i in 0..p.len() {
                energy += 0.5 * p[i][j].powi(2);
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..W {
                let stretch = q[i][j] - q[i][(j + W - 1) % W];
                if stretch < self.torn {
                    energy += 0.5 * stretch.powi(2);
                }
            }
        }
        for i in 0..q.len() - 1 {
            for j in 0..W {
                energy += 0.5 * (q[i + 1][(j + W - 1) % W] - q[i][j]).powi(2);
            }
        }
        energy
    }
}

/// Sites times what the sites around them make, with which each has a bond twice; rows end, and are closed one to the other.
struct Cross;

#[hamiltonian]
impl Cross {
    fn kinetic(&self, p: &[[f64; 21]]) -> f64 {
        p.iter().map(|row| row.iter().map(|p| 0.5 * p * p).sum::<f64>()).sum()
    }
    fn potential(&self, q: &[[f64; 21]]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..n {
            for j in 0..21 {
                let left = if j > 0 { q[i][j - 1] } else { 0.0 };
                let right = if j + 1 < 21 { q[i][j + 1] } else { 0.0 };
                let across = q[(i + n - 1) % n][j] + q[(i + 1) % n][j];
                energy += 2.0 * q[i][j].powi(4) - 0.5 * q[i][j] * (across + (left + right).powi(2));
            }
        }
        energy
    }
}

/// A system with its gradient by plain loops.
trait ByHand<const W: usize>: Hamiltonian<Coords = Rows<W>> {
    const NAME: &'static str;
    fn example(rows: usize) -> Self;
    fn mass(&self, _row: usize, _column: usize) -> f64 {
        1.0
    }
    fn gradient_by_loops(&self, q: &[[f64; W]]) -> Rows<W>;
    /// `T` and `V` by the functions themselves.
    fn energies(&self, state: &Phase<Rows<W>>) -> [f64; 2];
}

/// Adds the slope of a bond at its ends.
fn pull<const W: usize>(gradient: &mut [[f64; W]], from: [usize; 2], to: [usize; 2], slope: f64) {
    gradient[to[0]][to[1]] += slope;
    gradient[from[0]][from[1]] -= slope;
}

impl<const W: usize> ByHand<W> for Torus<W> {
    fn energies(&self, state: &Phase<Rows<W>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "torus";

    fn example(rows: usize) -> Self {
        let table = |scale: f64, count: usize| (0..count).map(|i| 1.0 + scale * (i as f64).sin()).collect::<Vec<_>>();
        let mass = (0..rows).map(|i| table(0.2 + 0.01 * i as f64, W)).collect();
        Self { mass, stiffness: table(0.5, W), coupling: table(0.3, rows), well: 0.7 }
    }
    fn mass(&self, row: usize, column: usize) -> f64 {
        self.mass[row][column]
    }
    fn gradient_by_loops(&self, q: &[[f64; W]]) -> Rows<W> {
        let mut gradient: Rows<W> = q.iter().map(|row| row.map(|q| self.well * q.powi(3))).collect();
        for (i, j) in sites::<W>(q.len()) {
            let (right, below) = ((j + 1) % W, (i + 1) % q.len());
            pull(&mut gradient, [i, j], [i, right], self.stiffness[j] * (q[i][right] - q[i][j]).sinh());
            pull(&mut gradient, [i, j], [below, j], self.coupling[i] * (q[below][j] - q[i][j]).powi(3));
        }
        gradient
    }
}

impl<const W: usize> ByHand<W> for Sheet<W> {
    fn energies(&self, state: &Phase<Rows<W>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "sheet";

    fn example(_rows: usize) -> Self {
        Self
    }
    fn gradient_by_loops(&self, q: &[[f64; W]]) -> Rows<W> {
        let mut gradient = vec![[0.0; W]; q.len()];
        gradient[0][0] += 0.4 * q[0][0].powi(3);
        for (i, j) in sites::<W>(q.len()) {
            if j == 0 {
                gradient[i][j] += 0.6 * q[i][j];
            }
            if i == q.len() - 1 {
                gradient[i][j] += 0.4 * q[i][j];
            }
            if j >= 2 {
                let bend = q[i][j] - q[i][j - 2] + 0.1 * q[i][j - 1];
                pull(&mut gradient, [i, j - 2], [i, j], bend);
                gradient[i][j - 1] += 0.1 * bend;
            }
            if i >= 1 {
                pull(&mut gradient, [i - 1, j], [i, j], (q[i][j] - q[i - 1][j]).powi(3));
            }
            if i >= 1 && j + 1 < W {
                pull(&mut gradient, [i - 1, j], [i, j + 1], 0.8 * (q[i][j + 1] - q[i - 1][j]));
            }
        }
        gradient
    }
}

impl<const W: usize> ByHand<W> for Tube<W> {
    fn energies(&self, state: &Phase<Rows<W>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "tube";

    fn example(_rows: usize) -> Self {
        Self { torn: 0.3 }
    }
    fn gradient_by_loops(&self, q: &[[f64; W]]) -> Rows<W> {
        let mut gradient = vec![[0.0; W]; q.len()];
        for (i, j) in sites::<W>(q.len()) {
            let left = (j + W - 1) % W;
            let stretch = q[i][j] - q[i][left];
            if stretch < self.torn {
                pull(&mut gradient, [i, left], [i, j], stretch);
            }
            if i + 1 < q.len() {
                pull(&mut gradient, [i, j], [i + 1, left], q[i + 1][left] - q[i][j]);
            }
        }
        gradient
    }
}

impl ByHand<21> for Cross {
    fn energies(&self, state: &Phase<Rows<21>>) -> [f64; 2] {
        [self.kinetic(&state.p), self.potential(&state.q)]
    }
    const NAME: &'static str = "cross";

    fn example(_rows: usize) -> Self {
        Self
    }
    fn gradient_by_loops(&self, q: &[[f64; 21]]) -> Rows<21> {
        let (mut gradient, rows) = (vec![[0.0; 21]; q.len()], q.len());
        for (i, j) in sites::<21>(rows) {
            let across = [(i + rows - 1) % rows, (i + 1) % rows];
            let along = [j.checked_sub(1), Some(j + 1).filter(|right| *right < 21)];
            let beside: f64 = along.iter().flatten().map(|j| q[i][*j]).sum();
            let sum = across.iter().map(|i| q[*i][j]).sum::<f64>() + beside.powi(2);
            gradient[i][j] += 8.0 * q[i][j].powi(3) - 0.5 * sum;
            for k in across {
                gradient[k][j] -= 0.5 * q[i][j];
            }
            for l in along.into_iter().flatten() {
                gradient[i][l] -= q[i][j] * beside;
            }
        }
        gradient
    }
}

fn sites<const W: usize>(rows: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rows).flat_map(|i| (0..W).map(move |j| (i, j)))
}

/// A state in which no two sites are alike.
fn start<const W: usize>(rows: usize) -> Phase<Rows<W>> {
    let site = |speed: f64, i: usize, j: usize| 0.4 * (speed * (i * W + j) as f64 + 0.3).sin();
    let wave = |speed: f64| (0..rows).map(|i| std::array::from_fn(|j| site(speed, i, j))).collect();
    Phase::new(wave(0.7), wave(1.3))
}

const STEP: f64 = 0.01;
const STEPS: u64 = 40;

/// Verlet by hand.
fn by_hand<const W: usize, H: ByHand<W>>(system: &H, Phase { mut q, mut p }: Phase<Rows<W>>) -> Phase<Rows<W>> {
    let drift = |q: &mut Rows<W>, p: &Rows<W>| {
        for (i, j) in sites::<W>(p.len()) {
            q[i][j] += 0.5 * STEP * p[i][j] / system.mass(i, j);
        }
    };
    for _ in 0..STEPS {
        drift(&mut q, &p);
        let gradient = system.gradient_by_loops(&q);
        for (i, j) in sites::<W>(p.len()) {
            p[i][j] -= STEP * gradient[i][j];
        }
        drift(&mut q, &p);
    }
    Phase::new(q, p)
}

/// Compares energies whose terms are summed in lanes with sums in the order of the loops: a few hundred terms of the order ten.
pub(super) fn hold_energies<C: Coords>(run: &Run<C>, [kinetic, potential]: [f64; 2]) {
    for (a, b) in [(run.kinetic(), kinetic), (run.potential(), potential)] {
        assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{a} for {b}");
    }
}

fn followed<H: Hamiltonian>(system: &H, start: Phase<H::Coords>) -> Phase<H::Coords> {
    let mut run = system.run_with::<f64, Verlet>(Verlet, start, STEP).expect("a start");
    run.advance(STEPS).expect("finite states");
    run.state()
}

/// One system with rows of one length, any number of them.
fn any_height<const W: usize, H: ByHand<W>>() {
    for rows in [1, 2, 3, 4, 7] {
        let system = H::example(rows);
        let (state, expected) = (followed(&system, start(rows)), by_hand(&system, start(rows)));
        hold_energies(&system.run(start(rows), STEP).expect("a start"), system.energies(&start(rows)));
        // As in `every_length`: less than 40 · 20 · 20 · e · 1.1e-16 = 5e-12 with the operations of twice the bonds.
        for (i, j) in sites::<W>(rows) {
            for (a, b) in [(state.q[i][j], expected.q[i][j]), (state.p[i][j], expected.p[i][j])] {
                assert!((a - b).abs() < 5e-12, "{} of {rows} rows of {W}: {a} for {b} at {i}, {j}", H::NAME);
            }
        }
    }
}

/// Every width takes long to compile: each system has some that fill no block, one or more.
#[test]
fn planes_of_every_kind_of_width() {
    any_height::<1, Torus<1>>();
    any_height::<2, Tube<2>>();
    any_height::<3, Sheet<3>>();
    any_height::<8, Tube<8>>();
    any_height::<19, Torus<19>>();
    any_height::<21, Cross>();
    any_height::<40, Sheet<40>>();
}

/// A run computes neighbouring sites side by side, an ensemble members: no bit tells.
#[test]
fn planes_have_the_same_bits_in_lanes() {
    let members = (0..9).map(|_| (Torus::<19>::example(4), start(4)));
    let mut together = Ensemble::new(Verlet, members, STEP).expect("starts");
    together.advance(STEPS).expect("finite states");
    let alone = followed(&Torus::<19>::example(4), start(4));
    assert!((0..9).all(|member| together.state(member) == Some(alone.clone())));
    let alone = Torus::<19>::example(4).run(alone, STEP).expect("a start").energy();
    assert!((0..9).all(|member| together.energy(member) == Some(alone)));
}

/// A closed plane.
#[derive(Clone, Copy)]
struct Closed<const W: usize>;

#[hamiltonian]
impl<const W: usize> Closed<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        p.iter().map(|row| row.iter().map(|p| 0.5 * p * p).sum::<f64>()).sum()
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..W {
                energy += 0.35 * (q[i][(j + 1) % W] - q[i][j]).powi(2) + 0.25 * q[i][j].powi(4);
                energy += 0.1 * (q[(i + 1) % q.len()][j] - q[i][j]).powi(4);
            }
        }
        energy
    }
}

/// An open plane, whose bonds lead back, and across to the left.
#[derive(Clone, Copy)]
struct Open<const W: usize>;

#[hamiltonian]
impl<const W: usize> Open<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        p.iter().map(|row| row.iter().map(|p| 0.5 * p * p).sum::<f64>()).sum()
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 1..W {
                energy += 0.5 * (q[i][j] - q[i][j - 1]).powi(2);
            }
        }
        for i in 1..q.len() {
            for j in 0..W - 1 {
                energy += 0.4 * (q[i][j + 1] - q[i - 1][j]).powi(2);
            }
        }
        energy
    }
}

/// Tiles of rows and threads, against members of an ensemble, which have neither. A portion of few steps leans little.
macro_rules! tiles_change_no_bit {
    ($system:expr, $composition:ident, $start:expr, $ways:expr) => {{
        const ALL: u64 = 4;
        let start = $start;
        let system = $system;
        let members = [(system, start.clone()), (system, start.clone())];
        let mut together = Ensemble::new($composition, members, STEP).expect("starts");
        together.advance(ALL).expect("finite states");
        let expected = together.state(0).expect("a member");
        for (threads, portion) in $ways {
            let run = system.run_with($composition, start.clone(), STEP);
            let mut run = run.expect("a start").with_threads(threads);
            for _ in 0..ALL / portion {
                run.advance(portion).expect("finite states");
            }
            let name = stringify!($system);
            assert!(run.state() == expected, "{name}, {threads} threads, {portion} steps");
        }
    }};
}

/// Rows of which many fill a tile, and of which few do, in numbers that tiles do not divide.
#[test]
fn tiles_of_rows_change_no_bit() {
    tiles_change_no_bit!(Closed::<40>, Verlet, start::<40>(2467), [(1, 4), (3, 4)]);
    tiles_change_no_bit!(Open::<40>, Yoshida4, start::<40>(2467), [(1, 4)]);
    tiles_change_no_bit!(Closed::<2051>, VelocityVerlet, start::<2051>(49), [(1, 4)]);
    let Phase { q, p } = start::<40>(2467);
    tiles_change_no_bit!(Closed::<40>, Verlet, Phase::compensated(q, p), [(1, 4)]);
}

#[test]
fn threads_on_rows_change_no_bit() {
    tiles_change_no_bit!(Open::<2051>, Verlet, start::<2051>(97), [(2, 4), (3, 2)]);
    tiles_change_no_bit!(Closed::<2051>, Yoshida4, start::<2051>(97), [(3, 4)]);
}

/// Too few rows for chunks: threads share them flow by flow.
#[test]
fn threads_on_few_rows_change_no_bit() {
    tiles_change_no_bit!(Open::<2051>, Verlet, start::<2051>(17), [(2, 4)]);
    tiles_change_no_bit!(Closed::<2051>, VelocityVerlet, start::<2051>(29), [(3, 4), (4, 2)]);
    let Phase { q, p } = start::<2051>(29);
    tiles_change_no_bit!(Closed::<2051>, Verlet, Phase::compensated(q, p), [(3, 4)]);
}

/// Springs on a torus whose sizes the type knows. Those across rows are of a kind whose pull is handed on.
struct Springs<const W: usize, const N: usize>;

#[hamiltonian]
impl<const W: usize, const N: usize> Springs<W, N> {
    fn kinetic(&self, p: &[[f64; W]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..W {
                energy += 0.5 * p[i][j] * p[i][j];
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; W]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..W {
                energy += 0.5 * (q[i][(j + 1) % W] - q[i][j]).powi(2) + 0.25 * (q[(i + 1) % N][j] - q[i][j]).powi(4);
            }
        }
        energy
    }
}

/// The sums in the order that a plane gives them, on every instruction set: what a site has itself, what comes along the
/// row, what comes from the row above, and to the first row from the last one at the end.
fn springs_bit_by_bit<const W: usize, const N: usize>() {
    let fma = |a: f64, b: f64, c: f64| match InstructionSet::chosen() {
        InstructionSet::Baseline => a * b + c,
        InstructionSet::Fused | InstructionSet::Avx512 => a.mul_add(b, c),
    };
    let array = |rows: Rows<W>| <[[f64; W]; N]>::try_from(rows).expect("as many");
    let Phase { q, p } = start::<W>(N);
    let mut run =
        Springs::<W, N>.run_with(Verlet, Phase::new(array(q.clone()), array(p.clone())), STEP).expect("a start");
    run.advance(STEPS).expect("finite states");

    let (mut q, mut p) = (q, p);
    let drift = |q: &mut Rows<W>, p: &Rows<W>, duration: f64| {
        for (i, j) in sites::<W>(N) {
            q[i][j] = fma(duration, p[i][j], q[i][j]);
        }
    };
    drift(&mut q, &p, 0.5 * STEP);
    for step in 1..=STEPS {
        for (i, j) in sites::<W>(N) {
            let right = |j: usize| q[i][(j + 1) % W] - q[i][j];
            let below = |i: usize| {
                let stretch = q[(i + 1) % N][j] - q[i][j];
                stretch * stretch * stretch
            };
            let (along, above) = (-(right(j) + below(i)) + right((j + W - 1) % W), below((i + N - 1) % N));
            p[i][j] = match i {
                0 => fma(-STEP, above, fma(-STEP, along, p[i][j])),
                _ => fma(-STEP, along + above, p[i][j]),
            };
        }
        drift(&mut q, &p, if step < STEPS { STEP } else { 0.5 * STEP });
    }
    let state = run.state();
    assert!(state.q[..] == q[..] && state.p[..] == p[..], "{N} rows of {W}");
}

#[test]
fn no_bit_depends_on_the_instruction_set() {
    springs_bit_by_bit::<3, 5>();
    springs_bit_by_bit::<29, 4>();
    springs_bit_by_bit::<32, 1>();
}

#[test]
fn every_precision_has_planes() {
    let exact = followed(&Torus::<19>::example(5), start(5));
    let Phase { q, p } = start::<19>(5);
    let compensated = {
        let mut run = Torus::<19>::example(5).run(Phase::compensated(q.clone(), p.clone()), STEP).expect("a start");
        run.advance(STEPS).expect("finite states");
        run.state()
    };
    let single = |rows: &Rows<19>| rows.iter().map(|row| row.map(|x| x as f32)).collect::<Vec<_>>();
    let singles = {
        let mut run = Torus::<19>::example(5).run(Phase::new(single(&q), single(&p)), STEP).expect("a start");
        run.advance(STEPS).expect("finite states");
        run.state()
    };
    for (i, j) in sites::<19>(5) {
        let (a, b) = (compensated.q[i][j].value, f64::from(singles.q[i][j]));
        assert!((a - exact.q[i][j]).abs() < 5e-12, "compensated: {a} for {} at {i}, {j}", exact.q[i][j]);
        // As above, with the rounding of a single precision number, 6e-8.
        assert!(
            (b - exact.q[i][j]).abs() < 40.0 * 20.0 * 20.0 * 2.8 * 6e-8,
            "singles: {b} for {} at {i}, {j}",
            exact.q[i][j]
        );
    }
}
