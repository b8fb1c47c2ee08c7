//! The φ⁴ field on a plane that is closed in both directions, stepped by Verlet.
//!
//! A step is one pass: a row is kicked by its four neighbours, and the row before it is drifted while it is in the
//! cache. The first row waits for the last one, which it is a neighbour of.

use crate::{
    enter::{Kernel, enter},
    plan::Plan,
    vector::{Row, Vector},
};

/// How many sites a row has.
const WIDTH: usize = 256;

/// A plane under way.
#[derive(Clone)]
pub struct Plane {
    /// Of the springs.
    pub stiffness: f64,
    /// Positions.
    pub q: Vec<[f64; WIDTH]>,
    /// Momenta.
    pub p: Vec<[f64; WIDTH]>,
}

impl Plane {
    /// Takes `steps` steps of Verlet, each in one pass of vectors.
    ///
    /// # Panics
    /// On a plan of another composition.
    pub fn one_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { plane: self, flows: plan.verlet(), steps, vectors: true });
    }

    /// Takes `steps` steps of Verlet in two plain loops over all sites each.
    ///
    /// # Panics
    /// On a plan of another composition.
    pub fn two_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { plane: self, flows: plan.verlet(), steps, vectors: false });
    }
}

struct March<'c> {
    plane: &'c mut Plane,
    /// The drift that opens, a kick and a drift, and the drift that closes.
    flows: [f64; 4],
    steps: usize,
    vectors: bool,
}

impl Kernel for March<'_> {
    type Out = ();
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
        let Plane { stiffness, q, p } = self.plane;
        let [opening, kick, drift, closing] = self.flows;
        let rows = q.len();
        for row in 0..rows {
            drift_row(&mut q[row], &p[row], opening);
        }
        for step in 1..=self.steps {
            let drift = if step < self.steps { drift } else { closing };
            for row in 0..rows {
                let around = [&q[(row + rows - 1) % rows], &q[row], &q[(row + 1) % rows]];
                if self.vectors {
                    kick_vectors::<V>(*stiffness, around, &mut p[row], kick);
                    if row >= 2 {
                        drift_row(&mut q[row - 1], &p[row - 1], drift);
                    }
                } else {
                    kick_plainly(*stiffness, around, &mut p[row], kick);
                }
            }
            let waiting =
                if self.vectors { [0..1.min(rows), 1.max(rows.saturating_sub(1))..rows] } else { [0..rows, 0..0] };
            for row in waiting.into_iter().flatten() {
                drift_row(&mut q[row], &p[row], drift);
            }
        }
    }
}

#[inline(always)]
fn drift_row(q: &mut [f64; WIDTH], p: &[f64; WIDTH], t: f64) {
    for (q, p) in q.iter_mut().zip(p) {
        *q = t.mul_add(*p, *q);
    }
}

/// The force on a site from the sum of its neighbours.
#[inline(always)]
fn force(stiffness: f64, here: f64, neighbours: f64) -> f64 {
    stiffness.mul_add(neighbours - 4.0 * here, (1.0 - here * here) * here)
}

#[inline(always)]
fn kick_plainly(stiffness: f64, [above, here, below]: [&[f64; WIDTH]; 3], p: &mut [f64; WIDTH], t: f64) {
    let last = WIDTH - 1;
    let at = |j: usize, left: usize, right: usize| {
        force(stiffness, here[j], (here[left] + here[right]) + (above[j] + below[j]))
    };
    p[0] = t.mul_add(at(0, last, 1), p[0]);
    for j in 1..last {
        p[j] = t.mul_add(at(j, j - 1, j + 1), p[j]);
    }
    p[last] = t.mul_add(at(last, last - 1, 0), p[last]);
}

#[inline(always)]
fn kick_vectors<V: Row>(stiffness: f64, [above, here, below]: [&[f64; WIDTH]; 3], p: &mut [f64; WIDTH], t: f64) {
    let (stiffness, one, four, t) = (V::splat(stiffness), V::splat(1.0), V::splat(4.0), V::splat(t));
    let (mut left, mut middle) = (V::load(&here[WIDTH - V::LANES..]), V::load(here));
    for j in (0..WIDTH).step_by(V::LANES) {
        let right = V::load(&here[(j + V::LANES) % WIDTH..]);
        let sides = middle.before(left) + middle.after(right);
        let neighbours = sides + (V::load(&above[j..]) + V::load(&below[j..]));
        let force = stiffness.fma(neighbours - four * middle, (one - middle * middle) * middle);
        t.fma(force, V::load(&p[j..])).store(&mut p[j..]);
        (left, middle) = (middle, right);
    }
}
