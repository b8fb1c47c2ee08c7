//! A polymer in a periodic box: bonds along the chain, and pairs of monomers without a bond.

use crate::{Group, liquids};
use integrator_core::prelude::*;
use std::collections::HashSet;

const STEP: f64 = 0.001;

/// A polymer, the condition that a pair has no bond, and the energy of the bonds.
macro_rules! polymer {
    ($name:ident, |$self:ident, $i:ident, $j:ident| $is_free:expr, |$q:ident| $bonds:expr) => {
        #[allow(dead_code, reason = "each spelling reads some of these")]
        struct $name {
            side: f64,
            /// Bonds, the monomer after each, those that a monomer has a bond with before it, and all pairs with a bond.
            bonds: Vec<[usize; 2]>,
            next: Vec<usize>,
            before: Vec<Vec<usize>>,
            bonded: HashSet<(usize, usize)>,
        }

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().flatten().map(|p| 0.5 * p * p).sum()
            }
            fn potential(&$self, $q: &[[f64; 3]]) -> f64 {
                let mut v = 0.0;
                for $i in 0..$q.len() {
                    for $j in 0..$i {
                        let r2 = $self.square($q[$i], $q[$j]);
                        if $is_free && r2 < 6.25 {
                            let s = (1.0 / r2).powi(3);
                            v += 4.0 * (s * s - s);
                        }
                    }
                }
                v + $bonds
            }
            fn bond(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
                50.0 * (self.square(a, b).sqrt() - 1.0).powi(2)
            }
            fn square(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
                let image = |x: f64| x - self.side * (x / self.side).round();
                (0..3).map(|d| image(a[d] - b[d]).powi(2)).sum()
            }
        }

        impl $name {
            fn new() -> Self {
                let (side, kinds) = liquids::box_and_kinds();
                let bonds: Vec<_> = (1..kinds.len()).map(|i| [i - 1, i]).collect();
                Self {
                    side,
                    next: (1..=kinds.len()).collect(),
                    before: (0..kinds.len()).map(|i| i.checked_sub(1).into_iter().collect()).collect(),
                    bonded: bonds.iter().map(|[a, b]| (*a, *b)).collect(),
                    bonds,
                }
            }
        }
    };
    ($name:ident, |$self:ident, $i:ident, $j:ident| $is_free:expr) => {
        polymer!($name, |$self, $i, $j| $is_free, |q| $self.bonds.iter().map(|&[a, b]| $self.bond(q[a], q[b])).sum::<f64>());
    };
    ($name:ident, |$self:ident, $q:ident| $bonds:expr) => {
        polymer!($name, |$self, i, j| i - j > 1, |$q| $bonds);
    };
}

polymer!(Differences, |self, i, j| i - j > 1);
polymer!(Next, |self, i, j| self.next[j] != i);
polymer!(Before, |self, i, j| !self.before[i].contains(&j));
polymer!(Set, |self, i, j| !self.bonded.contains(&(j, i)));

polymer!(Bonds, |self, q| {
    let mut bonds = 0.0;
    for &[a, b] in &self.bonds {
        bonds += self.bond(q[a], q[b]);
    }
    bonds
});
polymer!(Chain, |self, q| {
    let mut bonds = 0.0;
    for i in 1..q.len() {
        bonds += self.bond(q[i - 1], q[i]);
    }
    bonds
});
polymer!(Windows, |self, q| q.windows(2).map(|pair| self.bond(pair[0], pair[1])).sum::<f64>());

/// Adds runs of these systems to a group.
macro_rules! add {
    ($group:ident, $($spelling:literal $system:ident),*) => {
        $(
            let mut run = $system::new().run(liquids::start(), STEP).expect("a good start").with_threads(1);
            $group.add($spelling, run.energy(), move |steps| run.advance(steps).expect("finite states"));
        )*
    };
}

pub(crate) fn groups() -> Vec<Group<'static>> {
    let mut free = Group::new("pairs_without_bonds", 8);
    add!(free, "differences" Differences, "next monomers" Next, "lists before" Before, "set of bonds" Set);
    let mut bonds = Group::new("bonds", 8);
    add!(bonds, "list by iterators" Differences, "list" Bonds, "loop along the chain" Chain, "windows" Windows);
    vec![free, bonds]
}
