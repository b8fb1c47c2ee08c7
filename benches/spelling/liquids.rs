//! Lennard-Jones atoms in a periodic box: images, mixtures, exclusions, cutoffs of pairs, parts.

use crate::{Group, spellings};
use integrator_core::prelude::*;
use std::collections::HashSet;

/// Atoms along an edge of the box.
const CELLS: usize = 13;
const ATOMS: usize = CELLS * CELLS * CELLS;
const STEP: f64 = 0.001;

#[derive(Clone)]
struct Atoms {
    side: f64,
    inverse: f64,
    cutoff: f64,
    kinds: Vec<usize>,
    radii: Vec<f64>,
    depths: Vec<[f64; 2]>,
    flat: Vec<f64>,
    sums: [f64; 3],
    cutoffs: Vec<[f64; 2]>,
    molecules: Vec<usize>,
    excluded: Vec<Vec<usize>>,
    bonded: HashSet<(usize, usize)>,
}

fn atoms() -> Atoms {
    let side = (ATOMS as f64 / 0.8442).cbrt();
    let kinds: Vec<usize> = (0..ATOMS).map(|i| (i * 7 + i / 3) % 5 / 4).collect();
    let molecules: Vec<usize> = (0..ATOMS).map(|i| i / 3).collect();
    let earlier = |i: usize| (i - i % 3..i).collect::<Vec<_>>();
    Atoms {
        side,
        inverse: 1.0 / side,
        cutoff: 2.5,
        radii: kinds.iter().map(|kind| [1.2, 1.0][*kind]).collect(),
        kinds,
        depths: vec![[4.0, 6.0], [6.0, 2.0]],
        flat: vec![4.0, 6.0, 6.0, 2.0],
        sums: [4.0, 6.0, 2.0],
        cutoffs: vec![[2.4, 2.2], [2.2, 2.0]],
        molecules,
        excluded: (0..ATOMS).map(earlier).collect(),
        bonded: (0..ATOMS).flat_map(|i| earlier(i).into_iter().map(move |j| (i, j))).collect(),
    }
}

/// The side of the box, and the kind of each atom.
pub(crate) fn box_and_kinds() -> (f64, Vec<usize>) {
    let Atoms { side, kinds, .. } = atoms();
    (side, kinds)
}

pub(crate) fn start() -> Phase<Vec<[f64; 3]>> {
    let spacing = atoms().side / CELLS as f64;
    let site = |i: usize| [i % CELLS, i / CELLS % CELLS, i / CELLS / CELLS].map(|at| (at as f64 + 0.5) * spacing);
    let going = |i: usize| [0, 1, 2].map(|d| ((i * 13 + d * 7) as f64 * 0.77).sin());
    Phase::new((0..ATOMS).map(site).collect(), (0..ATOMS).map(going).collect())
}

/// Atoms with an image of the displacement `x` along an axis, and the energy of a pair.
macro_rules! atoms {
    ($name:ident, |$self:ident, $x:ident| $image:expr, |$i:ident, $j:ident, $r2:ident| $energy:expr) => {
        struct $name(Atoms);

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().flatten().map(|p| 0.5 * p * p).sum()
            }
            fn potential(&$self, q: &[[f64; 3]]) -> f64 {
                let mut v = 0.0;
                for $i in 0..q.len() {
                    for $j in 0..$i {
                        let mut $r2 = 0.0;
                        for d in 0..3 {
                            let $x = q[$i][d] - q[$j][d];
                            let image = $image;
                            $r2 += image * image;
                        }
                        v += $energy;
                    }
                }
                v
            }
            #[allow(dead_code, reason = "some energies are others")]
            fn lennard_jones(&self, r2: f64, depth: f64) -> f64 {
                if r2 < self.0.cutoff * self.0.cutoff {
                    let s = (1.0 / r2).powi(3);
                    depth * (s * s - s)
                } else {
                    0.0
                }
            }
            #[allow(dead_code, reason = "some energies are others")]
            fn soft(&self, r2: f64, cutoff: f64) -> f64 {
                if r2 < cutoff * cutoff { (cutoff * cutoff - r2).powi(2) } else { 0.0 }
            }
        }
    };
    ($name:ident, |$self:ident, $i:ident, $j:ident, $r2:ident| $energy:expr) => {
        atoms!($name, |$self, x| x - $self.0.side * (x * $self.0.inverse).round(), |$i, $j, $r2| $energy);
    };
    ($name:ident, |$self:ident, $x:ident| $image:expr) => {
        atoms!($name, |$self, $x| $image, |i, j, r2| $self.lennard_jones(r2, 4.0));
    };
}

atoms!(Round, |self, x| x - self.0.side * (x / self.0.side).round());
atoms!(Inverse, |self, x| x - self.0.side * (x * self.0.inverse).round());
atoms!(Floor, |self, x| x - self.0.side * (x / self.0.side + 0.5).floor());
atoms!(Remainder, |self, x| (x + 0.5 * self.0.side).rem_euclid(self.0.side) - 0.5 * self.0.side);
atoms!(Shorter, |self, x| x.abs().min(self.0.side - x.abs()));
atoms!(Branch, |self, x| if x > 0.5 * self.0.side {
    x - self.0.side
} else if x < -0.5 * self.0.side {
    x + self.0.side
} else {
    x
});
atoms!(TiesEven, |self, x| x - self.0.side * (x / self.0.side).round_ties_even());
atoms!(Remainders, |self, x| ((x % self.0.side) + 1.5 * self.0.side) % self.0.side - 0.5 * self.0.side);
atoms!(Twice, |self, x| {
    let half = self.0.side / 2.0;
    let lowered = if x > half { x - self.0.side } else { x };
    if lowered < -half { lowered + self.0.side } else { lowered }
});

struct Parts(Atoms);

#[hamiltonian(split = kinetic + repulsion + attraction)]
impl Parts {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn repulsion(&self, q: &[[f64; 3]]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let r2 = self.square(q[i], q[j]);
                if r2 < self.0.cutoff * self.0.cutoff {
                    v += 4.0 * (1.0 / r2).powi(6);
                }
            }
        }
        v
    }
    fn attraction(&self, q: &[[f64; 3]]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let r2 = self.square(q[i], q[j]);
                if r2 < self.0.cutoff * self.0.cutoff {
                    v -= 4.0 * (1.0 / r2).powi(3);
                }
            }
        }
        v
    }
    fn square(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        let image = |x: f64| x - self.0.side * (x * self.0.inverse).round();
        (0..3).map(|d| image(a[d] - b[d]).powi(2)).sum()
    }
}

atoms!(Table, |self, i, j, r2| self.lennard_jones(r2, self.0.depths[self.0.kinds[i]][self.0.kinds[j]]));
atoms!(Flat, |self, i, j, r2| self.lennard_jones(r2, self.0.flat[self.0.kinds[i] * 2 + self.0.kinds[j]]));
atoms!(Kinds, |self, i, j, r2| {
    let depth = if self.0.kinds[i] == 0 && self.0.kinds[j] == 0 {
        4.0
    } else if self.0.kinds[i] == 1 && self.0.kinds[j] == 1 {
        2.0
    } else {
        6.0
    };
    self.lennard_jones(r2, depth)
});
atoms!(Sums, |self, i, j, r2| self.lennard_jones(r2, self.0.sums[self.0.kinds[i] + self.0.kinds[j]]));

atoms!(Molecules, |self, i, j, r2| if self.0.molecules[i] != self.0.molecules[j] {
    self.lennard_jones(r2, 4.0)
} else {
    0.0
});
atoms!(Excluded, |self, i, j, r2| if self.0.excluded[i].contains(&j) { 0.0 } else { self.lennard_jones(r2, 4.0) });
atoms!(Bonded, |self, i, j, r2| if self.0.bonded.contains(&(i, j)) { 0.0 } else { self.lennard_jones(r2, 4.0) });
atoms!(Divided, |self, i, j, r2| if i / 3 == j / 3 { 0.0 } else { self.lennard_jones(r2, 4.0) });

atoms!(Radii, |self, i, j, r2| self.soft(r2, self.0.radii[i] + self.0.radii[j]));
atoms!(Cutoffs, |self, i, j, r2| self.soft(r2, self.0.cutoffs[self.0.kinds[i]][self.0.kinds[j]]));
atoms!(Chosen, |self, i, j, r2| {
    let cutoff = if self.0.kinds[i] == 0 && self.0.kinds[j] == 0 {
        2.4
    } else if self.0.kinds[i] == 1 && self.0.kinds[j] == 1 {
        2.0
    } else {
        2.2
    };
    self.soft(r2, cutoff)
});

/// Atoms whose number is a parameter, and the same with flat coordinates.
macro_rules! counted {
    ($name:ident, $coordinates:ty, |$p:ident| $kinetic:expr, |$q:ident, $i:ident, $j:ident, $d:ident| $displacement:expr) => {
        struct $name(Atoms);

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, $p: $coordinates) -> f64 {
                $kinetic
            }
            fn potential(&self, $q: $coordinates) -> f64 {
                let n = self.0.kinds.len();
                let mut v = 0.0;
                for $i in 0..n - 1 {
                    for $j in $i + 1..n {
                        let mut r2 = 0.0;
                        for $d in 0..3 {
                            let x = $displacement;
                            r2 += (x - self.0.side * (x / self.0.side).round()).powi(2);
                        }
                        if r2 < self.0.cutoff * self.0.cutoff {
                            let s = (1.0 / r2).powi(3);
                            v += 4.0 * (s * s - s);
                        }
                    }
                }
                v
            }
        }
    };
}

counted!(Counted, &[[f64; 3]], |p| p.iter().flatten().map(|p| 0.5 * p * p).sum(), |q, i, j, d| q[i][d] - q[j][d]);
counted!(FlatAtoms, &[f64], |p| p.iter().map(|p| 0.5 * p * p).sum(), |q, i, j, d| q[3 * i + d] - q[3 * j + d]);

pub(crate) fn groups() -> Vec<Group<'static>> {
    let flat = || Phase::new(start().q.concat(), start().p.concat());
    let mut images = Group::new("images", 8);
    spellings!(images, atoms(), start(), STEP;
        "round" Round, "round of a product" Inverse, "floor" Floor, "rem_euclid" Remainder,
        "min of both ways" Shorter, "branches" Branch, "two branches" Twice, "remainders" Remainders,
        "ties to even" TiesEven, "parts" Parts, "number of atoms" Counted,
    );
    spellings!(images, atoms(), flat(), STEP; "flat coordinates" FlatAtoms);
    let mut mixture = Group::new("mixture", 8);
    spellings!(mixture, atoms(), start(), STEP; "table" Table, "flat table" Flat, "branches" Kinds, "sum of kinds" Sums);
    let mut exclusions = Group::new("exclusions", 8);
    spellings!(exclusions, atoms(), start(), STEP;
        "molecules" Molecules, "lists of atoms" Excluded, "set of pairs" Bonded, "quotients" Divided,
    );
    let mut cutoffs = Group::new("cutoffs", 8);
    spellings!(cutoffs, atoms(), start(), STEP; "sum of radii" Radii, "table" Cutoffs, "branches" Chosen);
    vec![images, mixture, exclusions, cutoffs]
}
