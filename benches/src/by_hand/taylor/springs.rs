//! The chain of 32 sites: its 33 bonds in the lanes of four registers and one.
//!
//! Site `4 l + v` and the bond to its left are in lane `l` of register `v`. Neighbours are then in the same lane of the
//! next register, and lanes have to be shifted only from the last register to the first. The series are those of the
//! bonds; their accelerations are differences of adjacent tensions. Except between these two registers, no lane is
//! shifted from a tension to the stretch two orders higher.

use super::{
    course::{Course, Expansion, HIGHEST, Kept, follow, with_order},
    horizon::{Sizes, reach},
    weights::{INTEGRALS, Weights},
};
use crate::{
    enter::{Kernel, enter},
    problems::Chain32,
    vector::{Row, Vector},
};
use integrator_core::Phase;
use std::array::from_fn;

/// One value per bond; the last bond is alone in the last register.
type Bonds<R> = [R; 5];

/// One value per site.
type Sites<R> = [R; 4];

#[derive(Clone)]
struct Springs<R, const N: usize> {
    tolerance: f64,
    alpha: f64,
    q: Sites<Kept<R>>,
    v: Sites<Kept<R>>,
    /// Coefficients of accelerations, by order.
    accelerations: [Sites<R>; HIGHEST],
    /// Coefficients of the stretches of bonds, by order.
    stretches: [Bonds<R>; HIGHEST],
}

impl<R: Row, const N: usize> Springs<R, N> {
    #[inline(always)]
    fn new(system: &Chain32, start: &Phase<[f64; 32]>, tolerance: f64) -> Self {
        let zero = R::splat(0.0);
        let sites = |x: &[f64; 32]| from_fn(|v| Kept::of(R::load(&from_fn::<f64, 8, _>(|lane| x[4 * lane + v]))));
        Self {
            tolerance,
            alpha: system.alpha,
            q: sites(&start.q),
            v: sites(&start.p),
            accelerations: [[zero; 4]; HIGHEST],
            stretches: [[zero; 5]; HIGHEST],
        }
    }

    /// Returns the stretches of bonds from the positions of sites.
    #[inline(always)]
    fn stretches([a, b, c, d]: Sites<R>) -> Bonds<R> {
        let wall = R::splat(0.0);
        [a - d.before(wall), b - a, c - b, d - c, wall - wall.before(d)]
    }

    /// Computes accelerations from the tensions of order `k`, and stretches of order `k + 2` from the accelerations.
    #[inline(always)]
    fn pull(&mut self, k: usize, [a, b, c, d, e]: Bonds<R>) {
        let accelerations = [b - a, c - b, d - c, a.after(e) - d];
        self.accelerations[k] = accelerations;
        if k + 2 < N {
            let integral = R::splat(INTEGRALS.twice[k]);
            let [first, second, third, fourth] = accelerations;
            // The walls do not move, as if the tension beyond them were that of the last bond.
            let before = a - d.pick(a, &[8, 0, 1, 2, 3, 4, 5, 6]);
            let bonds = [first - before, second - first, third - second, fourth - third, R::splat(0.0).before(d) - e];
            for i in 0..5 {
                self.stretches[k + 2][i] = bonds[i] * integral;
            }
        }
    }

    /// Returns the tensions of the even order `k` and of the order `k + 1`.
    #[inline(always)]
    fn two_orders(&self, k: usize) -> [Bonds<R>; 2] {
        let d = &self.stretches;
        let middle = k / 2;
        let (zero, half) = (R::splat(0.0), R::splat(0.5));
        let (mut even, mut odd): (Bonds<R>, Bonds<R>) = ([zero; 5], [zero; 5]);
        for i in 0..5 {
            even[i] = half * d[middle][i] * d[middle][i];
        }
        for j in (0..middle).rev() {
            for i in 0..5 {
                odd[i] = d[j + 1][i].fma(d[k - j][i], odd[i]);
                even[i] = d[j][i].fma(d[k - j][i], even[i]);
            }
        }
        let twice = R::splat(2.0 * self.alpha);
        for i in 0..5 {
            even[i] = twice.fma(even[i], d[k][i]);
            odd[i] = twice.fma(d[0][i].fma(d[k + 1][i], odd[i]), d[k + 1][i]);
        }
        [even, odd]
    }
}

/// Returns the largest absolute value of all sites.
#[inline(always)]
fn size<R: Row>([a, b, c, d]: &Sites<R>) -> f64 {
    a.larger(*b).larger(c.larger(*d)).largest()
}

impl<R: Row, const N: usize> Expansion for Springs<R, N> {
    type State = Phase<[f64; 32]>;

    #[inline(always)]
    fn expand(&mut self) -> f64 {
        let (mut q, mut v) = ([R::splat(0.0); 4], [R::splat(0.0); 4]);
        for i in 0..4 {
            (q[i], v[i]) = (self.q[i].value, self.v[i].value);
        }
        self.stretches[0] = Self::stretches(q);
        self.stretches[1] = Self::stretches(v);
        for k in (0..N).step_by(2) {
            let [even, odd] = self.two_orders(k);
            self.pull(k, even);
            self.pull(k + 1, odd);
        }
        let a = &self.accelerations;
        let (velocity, late) = (size(&v), size(&a[N - 2]));
        let positions = Sizes {
            value: size(&q),
            slope: velocity,
            before: size(&a[N - 3]) * INTEGRALS.twice[N - 3],
            last: late * INTEGRALS.twice[N - 2],
        };
        let momenta = Sizes {
            value: velocity,
            slope: size(&a[0]),
            before: late * INTEGRALS.once[N - 2],
            last: size(&a[N - 1]) * INTEGRALS.once[N - 1],
        };
        reach::<N>(self.tolerance, [positions, momenta])
    }

    #[inline(always)]
    fn proceed(&mut self, by: f64) {
        let weights = Weights::of::<R>(by);
        let zero = R::splat(0.0);
        let (mut velocity, mut position) = ([zero; 4], [zero; 4]);
        // Smallest terms first.
        for k in (0..N).rev() {
            let (once, twice) = (R::splat(weights.once[k]), R::splat(weights.twice[k]));
            for i in 0..4 {
                velocity[i] = self.accelerations[k][i].fma(once, velocity[i]);
                if k + 2 <= N {
                    position[i] = self.accelerations[k][i].fma(twice, position[i]);
                }
            }
        }
        for i in 0..4 {
            self.q[i].add(R::splat(by).fma(self.v[i].value, position[i]));
            self.v[i].add(velocity[i]);
        }
    }

    #[inline(always)]
    fn state(&self) -> Self::State {
        let column = |x: &Sites<Kept<R>>| {
            let lanes = x.map(|x| {
                let mut lanes = [0.0; 8];
                x.value.store(&mut lanes);
                lanes
            });
            from_fn(|site| lanes[site % 4][site / 4])
        };
        Phase::new(column(&self.q), column(&self.v))
    }
}

struct Trajectory<'s, const N: usize> {
    system: &'s Chain32,
    start: &'s Phase<[f64; 32]>,
    course: Course,
    see: &'s mut dyn FnMut(Phase<[f64; 32]>),
}

impl<const N: usize> Kernel for Trajectory<'_, N> {
    type Out = u64;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> u64 {
        let springs = Springs::<R, N>::new(self.system, self.start, self.course.tolerance);
        follow(self.course, springs, self.see)
    }
}

/// Integrates the chain, passes its states to `see`, and returns the number of steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn chain(system: &Chain32, start: &Phase<[f64; 32]>, course: Course, see: &mut dyn FnMut(Phase<[f64; 32]>)) -> u64 {
    with_order!(course.order, N => enter(Trajectory::<N> { system, start, course, see }))
}
