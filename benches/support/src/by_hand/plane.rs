//! The φ⁴ field on a plane that is closed in both directions, stepped by Verlet.
//!
//! A step is one pass: a row is kicked by its four neighbours, and the row before it is drifted while it is in the
//! cache. The first row waits for the last one, which it is a neighbour of. Skewed, several steps follow each other through the
//! rows, each two rows behind the one before, so that a row is fetched once for all of them; where the ends of the plane
//! meet, what they left out comes last.

use crate::{
    enter::{Kernel, enter},
    plan::Plan,
    vector::{Row, Vector},
};

/// Sites of the rows, of positions and of momenta, that steps which follow each other have under way: a quarter of a second-level
/// cache of a mebibyte.
const UNDER_WAY: usize = 16 * 1024;
/// The most steps that follow each other.
const DEPTH: usize = 32;

/// A plane under way.
#[derive(Clone)]
pub struct Plane<const WIDTH: usize> {
    /// Of the springs.
    pub stiffness: f64,
    /// Positions.
    pub q: Vec<[f64; WIDTH]>,
    /// Momenta.
    pub p: Vec<[f64; WIDTH]>,
}

impl<const WIDTH: usize> Plane<WIDTH> {
    /// Takes `steps` steps of Verlet, each in one pass of vectors.
    ///
    /// # Panics
    /// On a plan of another composition.
    pub fn one_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { plane: self, flows: plan.verlet(), steps, pass: Pass::Vectors });
    }

    /// Takes `steps` steps of Verlet, several of them in each pass of vectors.
    ///
    /// # Panics
    /// On a plan of another composition.
    pub fn skewed(&mut self, plan: &Plan, steps: usize) {
        enter(March { plane: self, flows: plan.verlet(), steps, pass: Pass::Skewed });
    }

    /// Takes `steps` steps of Verlet in two plain loops over all sites each.
    ///
    /// # Panics
    /// On a plan of another composition.
    pub fn two_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { plane: self, flows: plan.verlet(), steps, pass: Pass::Plain });
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Pass {
    Plain,
    Vectors,
    Skewed,
}

struct March<'c, const WIDTH: usize> {
    plane: &'c mut Plane<WIDTH>,
    /// The drift that opens, a kick and a drift, and the drift that closes.
    flows: [f64; 4],
    steps: usize,
    pass: Pass,
}

impl<const WIDTH: usize> Kernel for March<'_, WIDTH> {
    type Out = ();
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
        let Plane { stiffness, q, p } = self.plane;
        let [opening, kick, drift, closing] = self.flows;
        let rows = q.len();
        for row in 0..rows {
            drift_row(&mut q[row], &p[row], opening);
        }
        let mut done = 0;
        while self.pass == Pass::Skewed && done + 1 < self.steps {
            let depth = (UNDER_WAY / WIDTH).min(DEPTH).min(rows / 4).min(self.steps - 1 - done);
            if depth < 2 {
                break;
            }
            skewed::<V, WIDTH>(*stiffness, q, p, [kick, drift], depth);
            done += depth;
        }
        let vectors = self.pass != Pass::Plain;
        for step in done + 1..=self.steps {
            let drift = if step < self.steps { drift } else { closing };
            for row in 0..rows {
                if vectors {
                    kick_row::<V, WIDTH>(*stiffness, q, &mut p[row], row, kick);
                    if row >= 2 {
                        drift_row(&mut q[row - 1], &p[row - 1], drift);
                    }
                } else {
                    let around = [&q[(row + rows - 1) % rows], &q[row], &q[(row + 1) % rows]];
                    kick_plainly(*stiffness, around, &mut p[row], kick);
                }
            }
            let waiting = if vectors { [0..1.min(rows), 1.max(rows.saturating_sub(1))..rows] } else { [0..rows, 0..0] };
            for row in waiting.into_iter().flatten() {
                drift_row(&mut q[row], &p[row], drift);
            }
        }
    }
}

/// `depth` steps, each two rows behind the one before, first of the rows that do not see the ends of the plane.
#[inline(always)]
fn skewed<V: Row, const WIDTH: usize>(
    stiffness: f64,
    q: &mut [[f64; WIDTH]],
    p: &mut [[f64; WIDTH]],
    [kick, drift]: [f64; 2],
    depth: usize,
) {
    let rows = q.len();
    for front in 0..rows {
        for step in 0..depth {
            let Some(row) = front.checked_sub(2 * step) else { break };
            if (2 * step..rows - 2 * step).contains(&row) {
                kick_row::<V, WIDTH>(stiffness, q, &mut p[row], row, kick);
            }
            if (2 * step + 2..rows - 2 * step).contains(&row) {
                drift_row(&mut q[row - 1], &p[row - 1], drift);
            }
        }
    }
    for step in 0..depth {
        for row in rows - 2 * step..rows + 2 * step {
            let row = row % rows;
            kick_row::<V, WIDTH>(stiffness, q, &mut p[row], row, kick);
        }
        for row in rows - 2 * step - 1..rows + 2 * step + 1 {
            drift_row(&mut q[row % rows], &p[row % rows], drift);
        }
    }
}

/// Kicks a row by the rows around it. No closure, which would be compiled outside of the instruction set.
#[inline(always)]
fn kick_row<V: Row, const WIDTH: usize>(
    stiffness: f64,
    q: &[[f64; WIDTH]],
    p: &mut [f64; WIDTH],
    row: usize,
    kick: f64,
) {
    let around = [&q[(row + q.len() - 1) % q.len()], &q[row], &q[(row + 1) % q.len()]];
    kick_vectors::<V, WIDTH>(stiffness, around, p, kick);
}

#[inline(always)]
fn drift_row<const WIDTH: usize>(q: &mut [f64; WIDTH], p: &[f64; WIDTH], t: f64) {
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
fn kick_plainly<const WIDTH: usize>(
    stiffness: f64,
    [above, here, below]: [&[f64; WIDTH]; 3],
    p: &mut [f64; WIDTH],
    t: f64,
) {
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
fn kick_vectors<V: Row, const WIDTH: usize>(
    stiffness: f64,
    [above, here, below]: [&[f64; WIDTH]; 3],
    p: &mut [f64; WIDTH],
    t: f64,
) {
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
