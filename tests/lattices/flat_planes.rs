//! Planes whose sites are one list of coordinates and whose width is a number at run time. They move as a loop by hand moves
//! them, and bitwise as rows whose width is one of the type; rows that are not all coordinates move as the loops say.

use integrator_core::prelude::*;

const STEP: f64 = 0.02;
const STEPS: u64 = 40;
/// Forty steps of sites of the order one: a few hundred roundings.
const NEAR: f64 = 2e-13;

/// A field on a torus.
struct Torus {
    width: usize,
    height: usize,
    coupling: f64,
}

#[hamiltonian]
impl Torus {
    fn index(&self, x: usize, y: usize) -> usize {
        y * self.width + x % self.width
    }
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for y in 0..self.height {
            for x in 0..self.width {
                let here = q[y * self.width + x];
                let right = q[self.index(x + 1, y)];
                let below = q[((y + 1) % self.height) * self.width + x];
                energy += here.powi(4) / 4.0;
                energy += self.coupling * ((right - here).powi(2) + (below - here).powi(2)) / 2.0;
            }
        }
        energy
    }
}

/// The same field on rows of the type.
struct Rows<const W: usize> {
    coupling: f64,
}

#[hamiltonian]
impl<const W: usize> Rows<W> {
    fn kinetic(&self, p: &[[f64; W]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; W]]) -> f64 {
        let mut energy = 0.0;
        for y in 0..q.len() {
            for x in 0..W {
                let here = q[y][x];
                energy += here.powi(4) / 4.0;
                energy += self.coupling
                    * ((q[y][(x + 1) % W] - here).powi(2) + (q[(y + 1) % q.len()][x] - here).powi(2))
                    / 2.0;
            }
        }
        energy
    }
}

/// A membrane with free ends and a weight of each site, as high as there are coordinates.
struct Membrane {
    width: usize,
    weights: Vec<f64>,
}

#[hamiltonian]
impl Membrane {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for y in 0..p.len() / self.width {
            for x in 0..self.width {
                energy += p[y * self.width + x].powi(2) / 2.0;
            }
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for q in q {
            energy += q.powi(2) / 2.0;
        }
        for y in 0..q.len() / self.width {
            for x in 0..self.width {
                energy += self.weights[y * self.width + x] * q[y * self.width + x].powi(4);
            }
            for x in 0..self.width - 1 {
                energy += (q[y * self.width + x + 1] - q[y * self.width + x]).powi(4);
            }
        }
        for y in 0..q.len() / self.width - 1 {
            for x in 0..self.width {
                energy += (q[(y + 1) * self.width + x] - q[y * self.width + x]).powi(2);
            }
        }
        energy
    }
}

fn start(length: usize) -> Phase<Vec<f64>> {
    let wave = |factor: f64| (0..length).map(|k| (factor * k as f64 + 0.2).sin()).collect();
    Phase::new(wave(0.37), wave(0.91))
}

/// The positions and momenta after steps of `Verlet` by hand.
fn by_hand(mut state: Phase<Vec<f64>>, steps: u64, gradient: impl Fn(&[f64]) -> Vec<f64>) -> Phase<Vec<f64>> {
    let drift = |state: &mut Phase<Vec<f64>>| {
        for (q, p) in state.q.iter_mut().zip(&state.p) {
            *q += STEP / 2.0 * p;
        }
    };
    for _ in 0..steps {
        drift(&mut state);
        for (p, slope) in state.p.iter_mut().zip(gradient(&state.q)) {
            *p -= STEP * slope;
        }
        drift(&mut state);
    }
    state
}

fn assert_near(run: &Phase<Vec<f64>>, expected: &Phase<Vec<f64>>, label: &str) {
    for (half, of_hand) in [(&run.q, &expected.q), (&run.p, &expected.p)] {
        assert_eq!(half.len(), of_hand.len());
        for (k, (a, b)) in half.iter().zip(of_hand).enumerate() {
            assert!((a - b).abs() < NEAR * b.abs().max(1.0), "{label}: coordinate {k}: {a} for {b}");
        }
    }
}

/// Compares energies whose terms are summed in lanes with the functions themselves: each addition rounds once.
fn assert_energies(run: &Run<Vec<f64>>, system: &Torus) {
    let state = run.state();
    let near = f64::EPSILON * state.q.len() as f64;
    for (a, b) in [(run.kinetic(), system.kinetic(&state.p)), (run.potential(), system.potential(&state.q))] {
        assert!((a - b).abs() <= near * b.max(1.0), "{} x {}: {a} for {b}", system.width, system.height);
    }
}

fn slope_on_torus([width, height]: [usize; 2], q: &[f64]) -> Vec<f64> {
    let mut slope = vec![0.0; q.len()];
    for y in 0..height {
        for x in 0..width {
            let at = |x: usize, y: usize| (y % height) * width + x % width;
            let around = [at(x + 1, y), at(x + width - 1, y), at(x, y + 1), at(x, y + height - 1)];
            let here = q[at(x, y)];
            slope[at(x, y)] = here.powi(3) + around.iter().map(|site| 0.4 * (here - q[*site])).sum::<f64>();
        }
    }
    slope
}

fn slope_of_membrane(width: usize, weights: &[f64], q: &[f64]) -> Vec<f64> {
    let (mut slope, height) = (q.to_vec(), q.len() / width);
    for y in 0..height {
        for x in 0..width {
            let here = y * width + x;
            slope[here] += 4.0 * weights[here] * q[here].powi(3);
            if x + 1 < width {
                let bond = 4.0 * (q[here + 1] - q[here]).powi(3);
                slope[here] -= bond;
                slope[here + 1] += bond;
            }
            if y + 1 < height {
                let bond = 2.0 * (q[here + width] - q[here]);
                slope[here] -= bond;
                slope[here + width] += bond;
            }
        }
    }
    slope
}

const SIZES: [[usize; 2]; 13] = [
    [1, 1],
    [1, 9],
    [9, 1],
    [2, 2],
    [3, 5],
    [8, 8],
    [7, 40],
    [40, 7],
    [17, 19],
    [64, 3],
    [67, 70],
    // Tiles in time, and threads.
    [130, 420],
    [2050, 40],
];

#[test]
fn a_torus_moves_as_by_hand() -> Result<(), Error> {
    for [width, height] in SIZES {
        let start = start(width * height);
        let expected = by_hand(start.clone(), STEPS, |q| slope_on_torus([width, height], q));
        let mut ends = Vec::new();
        for threads in [1, 3] {
            let mut run = Torus { width, height, coupling: 0.4 }.run(start.clone(), STEP)?.with_threads(threads);
            run.advance(STEPS)?;
            assert_near(&run.state(), &expected, &format!("{width} x {height}"));
            ends.push(run.state());
            assert_energies(&run, &Torus { width, height, coupling: 0.4 });
        }
        assert_eq!(ends[0], ends[1], "{width} x {height}");
    }
    Ok(())
}

#[test]
fn a_membrane_moves_as_by_hand() -> Result<(), Error> {
    for [width, height] in SIZES {
        let (start, weights) = (start(width * height), (0..width * height).map(|k| 0.1 + (k % 7) as f64 / 50.0));
        let weights: Vec<_> = weights.collect();
        let expected = by_hand(start.clone(), STEPS, |q| slope_of_membrane(width, &weights, q));
        let mut run = Membrane { width, weights: weights.clone() }.run(start, STEP)?;
        let potential = Membrane { width, weights: weights.clone() }.potential(&run.state().q);
        let near = f64::EPSILON * (width * height) as f64;
        assert!((run.potential() - potential).abs() <= near * potential.max(1.0), "{width} x {height}");
        run.advance(STEPS)?;
        assert_near(&run.state(), &expected, &format!("{width} x {height}"));
    }
    Ok(())
}

fn assert_as_rows<const W: usize>(height: usize) -> Result<(), Error> {
    let flat = start(W * height);
    let rows = |half: &[f64]| half.chunks(W).map(|row| std::array::from_fn(|x| row[x])).collect::<Vec<[f64; W]>>();
    let mut run = Torus { width: W, height, coupling: 0.4 }.run_with(Yoshida4, flat.clone(), STEP)?;
    let mut of_rows = Rows::<W> { coupling: 0.4 }.run_with(Yoshida4, Phase::new(rows(&flat.q), rows(&flat.p)), STEP)?;
    run.advance(STEPS)?;
    of_rows.advance(STEPS)?;
    assert_eq!([run.kinetic(), run.potential()], [of_rows.kinetic(), of_rows.potential()], "{W} x {height}");
    let (end, of_rows) = (run.state(), of_rows.state());
    assert_eq!([rows(&end.q), rows(&end.p)], [of_rows.q, of_rows.p], "{W} x {height}");
    Ok(())
}

#[test]
fn flat_planes_are_bitwise_identical_to_rows() -> Result<(), Error> {
    for height in [1, 2, 5, 33] {
        assert_as_rows::<1>(height)?;
        assert_as_rows::<2>(height)?;
        assert_as_rows::<11>(height)?;
        assert_as_rows::<64>(height)?;
    }
    assert_as_rows::<300>(200)
}

#[test]
fn members_of_an_ensemble_move_as_runs() -> Result<(), Error> {
    for height in [3, 70] {
        let system = || Torus { width: 67, height, coupling: 0.4 };
        let starts = (0..5).map(|member| {
            let mut start = start(67 * height);
            start.q[member] += 0.1;
            start
        });
        let starts: Vec<_> = starts.collect();
        let mut ensemble = Ensemble::new(Verlet, starts.iter().map(|start| (system(), start.clone())), STEP)?;
        ensemble.advance(STEPS)?;
        for (member, start) in starts.into_iter().enumerate() {
            let mut run = system().run(start, STEP)?;
            run.advance(STEPS)?;
            assert_eq!(Some(run.state()), ensemble.state(member), "member {member}");
        }
    }
    Ok(())
}

#[test]
fn coordinates_after_all_rows_move_freely() -> Result<(), Error> {
    for (width, height, length) in [(8, 8, 70), (10, 3, 31), (0, 5, 12), (5, 0, 12)] {
        let expected = by_hand(start(length), STEPS, |q| slope_on_torus([width, height], q));
        let mut run = Torus { width, height, coupling: 0.4 }.run(start(length), STEP)?;
        run.advance(STEPS)?;
        assert_near(&run.state(), &expected, &format!("{width} x {height} of {length}"));
        assert_energies(&run, &Torus { width, height, coupling: 0.4 });
    }
    Ok(())
}

#[test]
#[should_panic(expected = "index out of bounds")]
fn fewer_coordinates_than_sites_panic_in_the_users_function() {
    drop(Torus { width: 8, height: 8, coupling: 0.4 }.run(start(60), STEP));
}

#[test]
fn flat_planes_are_certified() -> Result<(), integrator_core::check::CertifyError> {
    certify(&Torus { width: 9, height: 4, coupling: 0.4 }, Yoshida4, start(36), 0.05)?;
    Ok(())
}
