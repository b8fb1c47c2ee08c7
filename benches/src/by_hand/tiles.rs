//! Many bodies, all pairs. A tile is a vector of bodies against another vector of bodies, which is rotated until each
//! body of one has been combined with each body of the other.
//!
//! A pair is evaluated once: the forces on the second vector rotate with it.

use crate::{
    enter::{Kernel, enter},
    plan::{HandWritten, Plan},
    problems::GRAVITY,
    vector::{Row, Vector},
};

/// Potential energy of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attraction {
    /// `-G mᵢ mⱼ / r`
    Gravity,
    /// `4 (r⁻¹² - r⁻⁶)` up to a cutoff, between bodies of mass 1.
    LennardJones {
        /// Distance beyond which there is no force.
        cutoff: f64,
    },
}

/// Returns force over distance, for masses of 1, or `None` if all lanes are beyond the cutoff.
trait Pair: Copy {
    const MASSES: bool;
    fn pull<V: Row>(self, square: V) -> Option<V>;
}

#[derive(Clone, Copy)]
struct Gravity;
#[derive(Clone, Copy)]
struct LennardJones {
    reach: f64,
}

impl Pair for Gravity {
    const MASSES: bool = true;
    #[inline(always)]
    fn pull<V: Row>(self, square: V) -> Option<V> {
        Some(square.over_cube(V::splat(GRAVITY)))
    }
}

impl Pair for LennardJones {
    const MASSES: bool = false;
    #[inline(always)]
    fn pull<V: Row>(self, square: V) -> Option<V> {
        let reach = V::splat(self.reach);
        if !V::any_less(square, reach) {
            return None;
        }
        let inverse = V::splat(1.0) / square;
        let sixth = inverse * inverse * inverse;
        let pull = sixth.fnma(V::splat(48.0), V::splat(24.0)) * (sixth * inverse);
        Some(pull.where_less(square, reach))
    }
}

/// Bodies and their state, in columns.
#[derive(Clone)]
pub struct Bodies {
    attraction: Attraction,
    count: usize,
    masses: Vec<f64>,
    q: [Vec<f64>; 3],
    p: [Vec<f64>; 3],
}

impl Bodies {
    /// Creates the bodies. Massless bodies at large distances fill the last vector.
    pub fn new(attraction: Attraction, masses: &[f64], q: &[[f64; 3]], p: &[[f64; 3]]) -> Self {
        let count = q.len();
        let padded = count.next_multiple_of(8);
        let column = |of: &dyn Fn(usize) -> f64, rest: f64| {
            (0..padded).map(|i| if i < count { of(i) } else { rest * (i - count + 1) as f64 }).collect()
        };
        Self {
            attraction,
            count,
            masses: column(&|i| masses[i], 0.0),
            q: [0, 1, 2].map(|axis| column(&|i| q[i][axis], 1e8)),
            p: [0, 1, 2].map(|axis| column(&|i| p[i][axis], 0.0)),
        }
    }

    /// Takes `steps` steps.
    pub fn advance(&mut self, plan: &Plan, steps: u64) {
        enter(March { bodies: self, plan, steps });
    }

    /// Returns position and momentum of a body.
    pub fn body(&self, body: usize) -> [[f64; 3]; 2] {
        [&self.q, &self.p].map(|columns| [0, 1, 2].map(|axis| columns[axis][body]))
    }

    /// Returns the number of bodies.
    pub fn count(&self) -> usize {
        self.count
    }
}

struct March<'b> {
    bodies: &'b mut Bodies,
    plan: &'b Plan,
    steps: u64,
}

impl Kernel for March<'_> {
    type Out = ();
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
        match self.bodies.attraction {
            Attraction::Gravity => self.march::<V>(Gravity),
            Attraction::LennardJones { cutoff } => self.march::<V>(LennardJones { reach: cutoff * cutoff }),
        }
    }
}

impl March<'_> {
    #[inline(always)]
    fn march<V: Row>(self, pair: impl Pair) {
        let accelerations = [0, 1, 2].map(|_| vec![0.0; self.bodies.masses.len()]);
        let mut tiles = Tiles { bodies: self.bodies, accelerations, pair, vector: std::marker::PhantomData::<V> };
        self.plan.march(&mut tiles, self.steps);
    }
}

struct Tiles<'b, P, V> {
    bodies: &'b mut Bodies,
    accelerations: [Vec<f64>; 3],
    pair: P,
    vector: std::marker::PhantomData<V>,
}

impl<P: Pair, V: Row> HandWritten for Tiles<'_, P, V> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let Bodies { masses, q, p, count, .. } = &mut *self.bodies;
        for (q, p) in q.iter_mut().zip(p) {
            for ((q, p), mass) in q.iter_mut().zip(p).zip(&*masses).take(*count) {
                *q += t * *p / mass;
            }
        }
    }

    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let padded = self.bodies.masses.len();
        self.accelerations.iter_mut().for_each(|column| column.fill(0.0));
        for first in (0..padded).step_by(V::LANES) {
            let mut met = self.within(first);
            for second in (first + V::LANES..padded).step_by(V::LANES) {
                met = self.between(first, second, met);
            }
            for (column, sum) in self.accelerations.iter_mut().zip(met) {
                let column = &mut column[first..];
                (V::load(column) + sum).store(column);
            }
        }
        let Bodies { masses, p, .. } = &mut *self.bodies;
        for (p, acceleration) in p.iter_mut().zip(&self.accelerations) {
            for ((p, acceleration), mass) in p.iter_mut().zip(acceleration).zip(&*masses) {
                *p = (t * mass).mul_add(*acceleration, *p);
            }
        }
    }
}

impl<P: Pair, V: Row> Tiles<'_, P, V> {
    #[inline(always)]
    fn load(&self, at: usize) -> Tile<V> {
        let Bodies { q: [x, y, z], masses, .. } = &*self.bodies;
        Tile { q: [V::load(&x[at..]), V::load(&y[at..]), V::load(&z[at..])], mass: V::load(&masses[at..]) }
    }

    /// Returns the accelerations of the bodies of one vector by each other.
    #[inline(always)]
    fn within(&self, at: usize) -> [V; 3] {
        let own = self.load(at);
        let mut other = own;
        let mut sum = [V::splat(0.0); 3];
        for _ in 1..V::LANES {
            other.rotate_by_one();
            let apart = own.to(&other);
            if let Some(pull) = self.pair.pull(square(apart)) {
                let pull = if P::MASSES { pull * other.mass } else { pull };
                for axis in 0..3 {
                    sum[axis] = pull.fma(apart[axis], sum[axis]);
                }
            }
        }
        sum
    }

    /// Adds the accelerations between two vectors of bodies. `sum` contains the accelerations of the first vector so
    /// far.
    #[inline(always)]
    fn between(&mut self, first: usize, second: usize, mut sum: [V; 3]) -> [V; 3] {
        let own = self.load(first);
        let mut other = self.load(second);
        let mut reaction = [V::splat(0.0); 3];
        for axis in 0..3 {
            reaction[axis] = V::load(&self.accelerations[axis][second..]);
        }
        for _ in 0..V::LANES {
            let apart = own.to(&other);
            if let Some(pull) = self.pair.pull(square(apart)) {
                let (action, back) = if P::MASSES { (pull * other.mass, pull * own.mass) } else { (pull, pull) };
                for axis in 0..3 {
                    sum[axis] = action.fma(apart[axis], sum[axis]);
                    reaction[axis] = back.fnma(apart[axis], reaction[axis]);
                }
            }
            other.rotate_by_one();
            for reaction in &mut reaction {
                *reaction = reaction.rotate_by_one();
            }
        }
        for (column, reaction) in self.accelerations.iter_mut().zip(reaction) {
            reaction.store(&mut column[second..]);
        }
        sum
    }
}

/// A vector of bodies. The functions below use loops instead of closures, because a closure is compiled for the default
/// instruction set of the target.
#[derive(Clone, Copy)]
struct Tile<V> {
    q: [V; 3],
    mass: V,
}

impl<V: Row> Tile<V> {
    #[inline(always)]
    fn rotate_by_one(&mut self) {
        for q in &mut self.q {
            *q = q.rotate_by_one();
        }
        self.mass = self.mass.rotate_by_one();
    }
    #[inline(always)]
    fn to(&self, other: &Self) -> [V; 3] {
        let ([x, y, z], [other_x, other_y, other_z]) = (self.q, other.q);
        [other_x - x, other_y - y, other_z - z]
    }
}

#[inline(always)]
fn square<V: Vector>([x, y, z]: [V; 3]) -> V {
    z.fma(z, y.fma(y, x * x))
}
