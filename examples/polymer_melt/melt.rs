//! Beads in chains, in a periodic box. Units: the well depth and the diameter of the Lennard-Jones potential, and the mass of a bead.

use integrator_core::{Error, Method, prelude::*};
use std::time::Instant;

/// Positions or momenta of the beads.
pub(crate) type Beads = Vec<[f64; 3]>;

/// Chains of beads.
#[derive(Clone)]
pub(crate) struct Chains {
    /// Side of the box.
    side: f64,
    /// Length of a bond at rest.
    length: f64,
    /// The two beads of each bond.
    bonds: Vec<[usize; 2]>,
}

/// Number of beads of a chain.
const CHAIN: usize = 10;

/// Second derivative of the energy of a bond by its length. The frequency of one bond alone is the root of twice that: 447. In a
/// straight chain of ten beads the highest frequency is 625. Beads that collide have about 40.
pub(crate) const STIFFNESS: f64 = 1e5;

/// Square of the cutoff of 2.5, the Lennard-Jones energy there, and its derivative by the square of the distance.
const CUTOFF_SQUARED: f64 = 6.25;
const SIXTH: f64 = 1.0 / (CUTOFF_SQUARED * CUTOFF_SQUARED * CUTOFF_SQUARED);
const VALUE: f64 = 4.0 * (SIXTH * SIXTH - SIXTH);
const SLOPE: f64 = (12.0 * SIXTH - 24.0 * SIXTH * SIXTH) / CUTOFF_SQUARED;

/// A Hamiltonian of the same energies, as one potential or in parts.
macro_rules! melt {
    ($(#[$words:meta])* $name:ident ($($arguments:tt)*): $($potential:tt)*) => {
        $(#[$words])*
        pub(crate) struct $name(pub(crate) Chains);

        #[hamiltonian($($arguments)*)]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])).sum()
            }
            /// Returns the Lennard-Jones energy of all pairs, minus its value and its slope at the cutoff.
            fn pairs(&self, q: &[[f64; 3]]) -> f64 {
                let mut energy = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let mut square = 0.0;
                        for d in 0..3 {
                            let x = q[i][d] - q[j][d];
                            square += (x - self.0.side * (x / self.0.side).round()).powi(2);
                        }
                        if square < CUTOFF_SQUARED {
                            let sixth = 1.0 / square.powi(3);
                            energy += 4.0 * (sixth * sixth - sixth) - VALUE - SLOPE * (square - CUTOFF_SQUARED);
                        }
                    }
                }
                energy
            }
            /// Returns the energy of harmonic bonds. Chains are not wrapped into the box, so that bonds need no nearest images.
            fn bonds(&self, q: &[[f64; 3]]) -> f64 {
                self.0
                    .bonds
                    .iter()
                    .map(|bond| {
                        let mut square = 0.0;
                        for d in 0..3 {
                            square += (q[bond[0]][d] - q[bond[1]][d]).powi(2);
                        }
                        0.5 * STIFFNESS * (square.sqrt() - self.0.length).powi(2)
                    })
                    .sum()
            }
            $($potential)*
        }
    };
}

melt!(
    /// The melt with one potential, for steps of one length.
    Melt():
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        self.pairs(q) + self.bonds(q)
    }
);
melt!(
    /// The melt in parts: eight inner steps of the bonds in each step of the pairs.
    NestedMelt(split = pairs + 8 * (bonds + kinetic)):
);

/// Creates chains along a path through a cubic lattice of `cells`³ sites, at random velocities.
pub(crate) fn crystal(cells: usize, beads: usize) -> (Chains, Phase<Beads>) {
    let length = 13.3 / 13.0;
    let back_and_forth = |index: usize, along: usize| if along.is_multiple_of(2) { index } else { cells - 1 - index };
    let place = |number: usize| {
        let (row, layer) = (number / cells, number / (cells * cells));
        let [x, y] = [back_and_forth(number % cells, row), back_and_forth(row % cells, layer)];
        [x, y, layer].map(|index| index as f64 * length)
    };
    let velocity = |number: usize| (1e4 * (number as f64).sin()).fract() * 2.0;
    let q = (0..beads).map(place).collect();
    let p = (0..beads).map(|bead| [0, 1, 2].map(|d| velocity(3 * bead + d))).collect();
    let bonds = (1..beads).filter(|bead| bead % CHAIN > 0).map(|bead| [bead - 1, bead]).collect();
    (Chains { side: cells as f64 * length, length, bonds }, Phase::new(q, p))
}

/// Creates 2,000 beads at the density 0.85. Collisions have melted the crystal.
pub(crate) fn melt() -> Result<(Chains, Phase<Beads>), Error> {
    let (chains, start) = crystal(13, 2000);
    let mut run = NestedMelt(chains.clone()).run(start, 2e-3)?;
    run.advance(1000)?;
    Ok((chains, run.state()))
}

/// Result of a run over a given time.
#[derive(Clone, Copy)]
pub(crate) struct Cost {
    /// Largest energy error.
    pub(crate) error: f64,
    /// Seconds on one core.
    pub(crate) seconds: f64,
}

impl Cost {
    /// Returns the seconds of a second-order method for another error, with other steps.
    pub(crate) fn seconds_for(self, error: f64) -> f64 {
        self.seconds * (self.error / error).sqrt()
    }
}

/// Integrates for `time`, in portions of 0.02 between samples of the energy.
pub(crate) fn cost<H: Hamiltonian<Coords = Beads>>(
    system: &H,
    method: impl Method<H>,
    start: &Phase<Beads>,
    h: f64,
    time: f64,
) -> Result<Cost, Error> {
    let mut run = system.run_with(method, start.clone(), h)?.with_threads(1);
    let (energy, steps) = (run.energy(), (0.02 / h).round() as u64);
    let mut cost = Cost { error: 0.0, seconds: 0.0 };
    for _ in 0..(time / 0.02).round() as u64 {
        let begin = Instant::now();
        run.advance(steps)?;
        cost.seconds += begin.elapsed().as_secs_f64();
        cost.error = cost.error.max((run.energy() - energy).abs());
    }
    Ok(cost)
}
