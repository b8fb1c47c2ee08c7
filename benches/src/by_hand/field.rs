//! The φ⁴ field on a plane or a volume with periodic boundaries, integrated with Verlet.
//!
//! A step is one pass over layers, which are the rows of a plane or the planes of a volume. A layer is kicked by its
//! neighbours, and the layer before it is drifted while it is in the cache. The first and the last layer are
//! neighbours, so the first layer is drifted at the end of the pass.
//!
//! With time skewing, several steps pass through the layers together. Each step is two layers behind the previous step,
//! so a layer is loaded once for all of them. The layers near the periodic boundary are completed at the end.

use crate::{
    enter::{Kernel, enter},
    plan::Plan,
    vector::{Row, Vector},
};

/// Number of sites in the layers of the skewed steps. Their positions and momenta fill a quarter of an L2 cache of 1
/// MiB.
const UNDER_WAY: usize = 16 * 1024;
/// Largest number of skewed steps.
const DEPTH: usize = 32;
/// Smallest number of skewed steps, used for large layers.
const SHALLOWEST: usize = 4;

/// A row of a plane, or a plane of a volume.
pub trait Layer: Clone {
    /// Number of sites.
    const SITES: usize;
    /// Adds `t` times the momenta to the positions of the layer.
    fn drift(&mut self, p: &Self, t: f64);
    /// Adds `t` times the forces to the momenta of the layer, with vectors. `around` contains the layer between its
    /// neighbours.
    fn kick<V: Row>(&mut self, stiffness: f64, around: [&Self; 3], t: f64);
    /// The same with a plain loop.
    fn kick_plainly(&mut self, stiffness: f64, around: [&Self; 3], t: f64);
}

/// A field and its state.
#[derive(Clone)]
pub struct Field<T> {
    /// Stiffness of the springs.
    pub stiffness: f64,
    /// Positions.
    pub q: Vec<T>,
    /// Momenta.
    pub p: Vec<T>,
}

impl<T: Layer> Field<T> {
    /// Takes `steps` steps of Verlet, each in one pass with vectors.
    ///
    /// # Panics
    /// If the plan is not that of `Verlet`.
    pub fn one_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { field: self, flows: plan.verlet(), steps, pass: Pass::Vectors });
    }

    /// Takes `steps` steps of Verlet, several of them in each pass with vectors.
    ///
    /// # Panics
    /// If the plan is not that of `Verlet`.
    pub fn skewed(&mut self, plan: &Plan, steps: usize) {
        enter(March { field: self, flows: plan.verlet(), steps, pass: Pass::Skewed });
    }

    /// Takes `steps` steps of Verlet, each in two plain loops over all sites.
    ///
    /// # Panics
    /// If the plan is not that of `Verlet`.
    pub fn two_pass(&mut self, plan: &Plan, steps: usize) {
        enter(March { field: self, flows: plan.verlet(), steps, pass: Pass::Plain });
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Pass {
    Plain,
    Vectors,
    Skewed,
}

struct March<'c, T> {
    field: &'c mut Field<T>,
    /// Durations of the opening drift, the kick and the drift of the loop, and the closing drift.
    flows: [f64; 4],
    steps: usize,
    pass: Pass,
}

impl<T: Layer> Kernel for March<'_, T> {
    type Out = ();
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
        let Field { stiffness, q, p } = self.field;
        let [opening, kick, drift, closing] = self.flows;
        let layers = q.len();
        for (q, p) in q.iter_mut().zip(&*p) {
            q.drift(p, opening);
        }
        let mut done = 0;
        while self.pass == Pass::Skewed && done + 1 < self.steps {
            let depth = (UNDER_WAY / T::SITES).clamp(SHALLOWEST, DEPTH).min(layers / 4).min(self.steps - 1 - done);
            if depth < 2 {
                break;
            }
            skewed::<V, T>(*stiffness, q, p, [kick, drift], depth);
            done += depth;
        }
        let vectors = self.pass != Pass::Plain;
        for step in done + 1..=self.steps {
            let drift = if step < self.steps { drift } else { closing };
            for layer in 0..layers {
                if vectors {
                    kick_layer::<V, T>(*stiffness, q, p, layer, kick);
                    if layer >= 2 {
                        q[layer - 1].drift(&p[layer - 1], drift);
                    }
                } else {
                    p[layer].kick_plainly(*stiffness, around(q, layer), kick);
                }
            }
            let waiting =
                if vectors { [0..1.min(layers), 1.max(layers.saturating_sub(1))..layers] } else { [0..layers, 0..0] };
            for layer in waiting.into_iter().flatten() {
                q[layer].drift(&p[layer], drift);
            }
        }
    }
}

/// Takes `depth` steps, each two layers behind the previous one. Layers that depend on the periodic boundary come last.
#[inline(always)]
fn skewed<V: Row, T: Layer>(stiffness: f64, q: &mut [T], p: &mut [T], [kick, drift]: [f64; 2], depth: usize) {
    let layers = q.len();
    for front in 0..layers {
        for step in 0..depth {
            let Some(layer) = front.checked_sub(2 * step) else { break };
            if (2 * step..layers - 2 * step).contains(&layer) {
                kick_layer::<V, T>(stiffness, q, p, layer, kick);
            }
            if (2 * step + 2..layers - 2 * step).contains(&layer) {
                q[layer - 1].drift(&p[layer - 1], drift);
            }
        }
    }
    for step in 0..depth {
        for layer in layers - 2 * step..layers + 2 * step {
            kick_layer::<V, T>(stiffness, q, p, layer % layers, kick);
        }
        for layer in layers - 2 * step - 1..layers + 2 * step + 1 {
            q[layer % layers].drift(&p[layer % layers], drift);
        }
    }
}

/// Kicks a layer. This is not a closure, because closures are compiled without the instruction set of their caller.
#[inline(always)]
fn kick_layer<V: Row, T: Layer>(stiffness: f64, q: &[T], p: &mut [T], layer: usize, kick: f64) {
    p[layer].kick::<V>(stiffness, around(q, layer), kick);
}

/// Returns a layer between its two neighbours.
#[inline(always)]
fn around<T>(q: &[T], layer: usize) -> [&T; 3] {
    [&q[(layer + q.len() - 1) % q.len()], &q[layer], &q[(layer + 1) % q.len()]]
}

impl<const WIDTH: usize> Layer for [f64; WIDTH] {
    const SITES: usize = WIDTH;
    #[inline(always)]
    fn drift(&mut self, p: &Self, t: f64) {
        for (q, p) in self.iter_mut().zip(p) {
            *q = t.mul_add(*p, *q);
        }
    }
    #[inline(always)]
    fn kick<V: Row>(&mut self, stiffness: f64, [above, here, below]: [&Self; 3], t: f64) {
        kick_row::<V, WIDTH, 2>(stiffness, here, [above, below], self, t);
    }
    #[inline(always)]
    fn kick_plainly(&mut self, stiffness: f64, [above, here, below]: [&Self; 3], t: f64) {
        kick_row_plainly(stiffness, here, [above, below], self, t);
    }
}

impl<const WIDTH: usize, const ROWS: usize> Layer for [[f64; WIDTH]; ROWS] {
    const SITES: usize = ROWS * WIDTH;
    #[inline(always)]
    fn drift(&mut self, p: &Self, t: f64) {
        for (q, p) in self.iter_mut().zip(p) {
            q.drift(p, t);
        }
    }
    #[inline(always)]
    fn kick<V: Row>(&mut self, stiffness: f64, [before, here, behind]: [&Self; 3], t: f64) {
        for row in 0..ROWS {
            let beside = beside(row, before, here, behind);
            kick_row::<V, WIDTH, 4>(stiffness, &here[row], beside, &mut self[row], t);
        }
    }
    #[inline(always)]
    fn kick_plainly(&mut self, stiffness: f64, [before, here, behind]: [&Self; 3], t: f64) {
        for row in 0..ROWS {
            let beside = beside(row, before, here, behind);
            kick_row_plainly(stiffness, &here[row], beside, &mut self[row], t);
        }
    }
}

/// Returns the rows adjacent to a row of a volume: two in the same plane, and two in the adjacent planes.
#[inline(always)]
fn beside<'p, T, const ROWS: usize>(
    row: usize,
    before: &'p [T; ROWS],
    here: &'p [T; ROWS],
    behind: &'p [T; ROWS],
) -> [&'p T; 4] {
    [&here[(row + ROWS - 1) % ROWS], &here[(row + 1) % ROWS], &before[row], &behind[row]]
}

/// Returns the force on a site from the sum of its neighbours.
#[inline(always)]
fn force(stiffness: f64, here: f64, neighbours: f64, count: f64) -> f64 {
    stiffness.mul_add(neighbours - count * here, (1.0 - here * here) * here)
}

/// Kicks a row by its own sites and by the adjacent rows.
#[inline(always)]
fn kick_row_plainly<const WIDTH: usize, const BESIDE: usize>(
    stiffness: f64,
    here: &[f64; WIDTH],
    beside: [&[f64; WIDTH]; BESIDE],
    p: &mut [f64; WIDTH],
    t: f64,
) {
    let (last, count) = (WIDTH - 1, (BESIDE + 2) as f64);
    let at = |j: usize, left: usize, right: usize| {
        let mut neighbours = here[left] + here[right];
        for row in beside {
            neighbours += row[j];
        }
        force(stiffness, here[j], neighbours, count)
    };
    p[0] = t.mul_add(at(0, last, 1), p[0]);
    for j in 1..last {
        p[j] = t.mul_add(at(j, j - 1, j + 1), p[j]);
    }
    p[last] = t.mul_add(at(last, last - 1, 0), p[last]);
}

/// The same with vectors.
#[inline(always)]
fn kick_row<V: Row, const WIDTH: usize, const BESIDE: usize>(
    stiffness: f64,
    here: &[f64; WIDTH],
    beside: [&[f64; WIDTH]; BESIDE],
    p: &mut [f64; WIDTH],
    t: f64,
) {
    let (stiffness, one, count, t) = (V::splat(stiffness), V::splat(1.0), V::splat((BESIDE + 2) as f64), V::splat(t));
    let (mut left, mut middle) = (V::load(&here[WIDTH - V::LANES..]), V::load(here));
    for j in (0..WIDTH).step_by(V::LANES) {
        let right = V::load(&here[(j + V::LANES) % WIDTH..]);
        let mut neighbours = middle.before(left) + middle.after(right);
        for pair in beside.as_chunks::<2>().0 {
            neighbours = neighbours + (V::load(&pair[0][j..]) + V::load(&pair[1][j..]));
        }
        let force = stiffness.fma(neighbours - count * middle, (one - middle * middle) * middle);
        t.fma(force, V::load(&p[j..])).store(&mut p[j..]);
        (left, middle) = (middle, right);
    }
}
