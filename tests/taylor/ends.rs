//! Sites that look at others behind a condition on where they are: the iterations of those that have no such neighbour are
//! in the lists of a Taylor run as well, and read and move nothing.

use integrator_core::{Coords, KahanLi8, prelude::*, taylor::Recurrences};

/// A chain, whose first site has a neighbour at the other end.
struct Chain;

#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..n {
            let before = if i > 0 { q[i - 1] } else { q[n - 1] };
            energy += (q[i] - before).powi(4);
            if i + 2 < n {
                energy += (q[i] * q[i + 2]).sin();
            }
        }
        energy
    }
}

/// A plane with open ends, whose columns are components of its rows.
struct Plane;

#[hamiltonian(taylor)]
impl Plane {
    fn kinetic(&self, p: &[[f64; 5]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 5]]) -> f64 {
        let mut energy = 0.0;
        for y in 0..q.len() {
            for x in 0..5 {
                if x + 1 < 5 {
                    energy += (q[y][x] - q[y][x + 1]).powi(4);
                }
                if y > 0 && x > 1 {
                    energy += (q[y][x] * q[y - 1][x - 2]).sin();
                }
            }
        }
        energy
    }
}

/// Layers with open ends.
struct Volume;

#[hamiltonian(taylor)]
impl Volume {
    fn kinetic(&self, p: &[[[f64; 3]; 2]]) -> f64 {
        p.iter().flatten().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[[f64; 3]; 2]]) -> f64 {
        let mut energy = 0.0;
        for z in 0..q.len() {
            for y in 0..2 {
                for x in 0..3 {
                    if x + 1 < 3 {
                        energy += (q[z][y][x] - q[z][y][x + 1]).powi(4);
                    }
                    if z + 1 < q.len() && y > 0 {
                        energy += (q[z][y][x] * q[z + 1][y - 1][x]).sin();
                    }
                }
            }
        }
        energy
    }
}

/// Holds Taylor's method against a composition for as many rows of sites as fill vectors, and for as many as do not.
fn check<H>(system: &H, width: usize)
where
    H: Hamiltonian + Recurrences,
    H::Coords: Coords<Leaf = f64>,
{
    for rows in [1, 2, 3, 5, 8, 16, 17] {
        let coordinates =
            |at: fn(usize) -> f64| H::Coords::from_flat((0..rows * width).map(at).collect()).expect("rows");
        let start =
            || Phase::new(coordinates(|i| 0.1 * (i * i % 7) as f64), coordinates(|i| 0.1 - 0.02 * (i % 5) as f64));
        let mut run = system.run_with(Taylor::tolerance(1e-16), start(), 0.01).expect("a run");
        let mut composed = system.run_with(KahanLi8, start(), 0.01).expect("a run");
        run.advance(3).expect("finite");
        composed.advance(3).expect("finite");
        let (found, expected) = (run.state(), composed.state());
        let found = found.q.flat().iter().chain(found.p.flat());
        for (found, expected) in found.zip(expected.q.flat().iter().chain(expected.p.flat())) {
            assert!((found - expected).abs() < 1e-13, "{rows} rows: {found} for {expected}");
        }
    }
}

#[test]
fn sites_without_a_neighbour_are_moved_by_the_others() {
    check(&Chain, 1);
    check(&Plane, 5);
    check(&Volume, 6);
}
