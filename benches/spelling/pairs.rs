//! The same pairs in other loops, and embedded atoms.

use crate::{Group, liquids};
use integrator_core::prelude::*;

const STEP: f64 = 0.001;

/// Atoms in a periodic box, and their energy.
macro_rules! atoms {
    ($name:ident, |$self:ident, $q:ident| $energy:expr) => {
        struct $name {
            side: f64,
            kinds: Vec<usize>,
            depths: [[f64; 2]; 2],
        }

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().flatten().map(|p| 0.5 * p * p).sum()
            }
            fn potential(&$self, $q: &[[f64; 3]]) -> f64 {
                $energy
            }
            fn square(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
                let image = |x: f64| x - self.side * (x / self.side).round();
                (0..3).map(|d| image(a[d] - b[d]).powi(2)).sum()
            }
            #[allow(dead_code, reason = "some energies are others")]
            fn lennard_jones(&self, square: f64, depth: f64) -> f64 {
                if square < 6.25 {
                    let s = (1.0 / square).powi(3);
                    depth * (s * s - s)
                } else {
                    0.0
                }
            }
            #[allow(dead_code, reason = "some energies are others")]
            fn density(&self, square: f64) -> f64 {
                if square < 6.25 { (6.25 - square).powi(2) } else { 0.0 }
            }
        }

        impl $name {
            fn new() -> Self {
                let (side, kinds) = liquids::box_and_kinds();
                Self { side, kinds, depths: [[4.0, 6.0], [6.0, 2.0]] }
            }
        }
    };
}

atoms!(Before, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..i {
            v += self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
    }
    v
});
atoms!(After, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            v += self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
    }
    v
});
atoms!(Twice, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            if i != j {
                v += 0.5 * self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
            }
        }
    }
    v
});
atoms!(Joined, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            let square = self.square(q[i], q[j]);
            if i == j || square >= 6.25 {
                continue;
            }
            let s = (1.0 / square).powi(3);
            v += 0.5 * self.depths[self.kinds[i]][self.kinds[j]] * (s * s - s);
        }
    }
    v
});
atoms!(Ordered, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..q.len() {
            let square = self.square(q[i], q[j]);
            if j < i && square < 6.25 {
                let s = (1.0 / square).powi(3);
                v += self.depths[self.kinds[i]][self.kinds[j]] * (s * s - s);
            }
        }
    }
    v
});
atoms!(Three, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..i {
            v += 0.25 * self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
        for j in i + 1..q.len() {
            v += 0.25 * self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
        for j in (0..q.len()).filter(|&j| j != i) {
            v += 0.25 * self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
    }
    v
});

atoms!(Embedded, |self, q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        let mut density = 0.0;
        for j in 0..q.len() {
            if j != i {
                density += self.density(self.square(q[i], q[j]));
            }
        }
        v -= density.sqrt();
        for j in i + 1..q.len() {
            v += self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]]);
        }
    }
    v
});
atoms!(EmbeddedInArray, |self, q| {
    let mut v = 0.0;
    let mut density = vec![0.0; q.len()];
    for i in 0..q.len() {
        for j in 0..i {
            let square = self.square(q[i], q[j]);
            density[i] += self.density(square);
            density[j] += self.density(square);
            v += self.lennard_jones(square, self.depths[self.kinds[i]][self.kinds[j]]);
        }
    }
    for i in 0..q.len() {
        v -= density[i].sqrt();
    }
    v
});
atoms!(EmbeddedInIterators, |self, q| {
    let density = |i: usize, j: usize| self.density(self.square(q[i], q[j]));
    let pair = |i: usize, j: usize| {
        0.5 * self.lennard_jones(self.square(q[i], q[j]), self.depths[self.kinds[i]][self.kinds[j]])
    };
    let embedded = |i: usize| (0..q.len()).filter(|&j| j != i).map(|j| density(i, j)).sum::<f64>().sqrt();
    let pairs = |i: usize| (0..q.len()).filter(|&j| j != i).map(|j| pair(i, j)).sum::<f64>();
    (0..q.len()).map(|i| pairs(i) - embedded(i)).sum()
});

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
    let mut loops = Group::new("loops_of_pairs", 8);
    add!(loops, "before" Before, "after" After, "all others" Twice, "one condition" Joined, "j < i" Ordered, "three loops" Three);
    let mut embedded = Group::new("embedded", 8);
    add!(embedded, "loops" Embedded, "an array" EmbeddedInArray, "iterators" EmbeddedInIterators);
    vec![loops, embedded]
}
