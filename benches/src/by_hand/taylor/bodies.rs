//! The outer solar system: the fifteen pairs of six bodies in the sixteen lanes of two registers.
//!
//! Two bodies appear twice in a register of bodies, so its eight lanes are the first bodies of the pairs in either
//! register of pairs. Only the second bodies have to be permuted, and two of the five pulls on a body are already in
//! its lane.
//!
//! With the distance `r` of a pair `d`, `r² = d·d`, the pull is `d / r³`. The code computes `r` from its square by half
//! a convolution, `r³ = r r²` by one convolution, and a quotient per axis. This takes less time than a power of `r²`
//! and products with it.

use super::{
    course::{Course, Expansion, HIGHEST, Kept, follow, with_order},
    horizon::{Sizes, reach},
    weights::{INTEGRALS, Weights},
};
use crate::{
    enter::{Kernel, enter},
    problems::{GRAVITY, Solar},
    vector::{Row, Vector},
};
use integrator_core::Phase;
use std::{
    array::from_fn,
    ops::{Add, Mul},
};

/// The first body of a pair, by lane.
const FIRST: [i64; 8] = [0, 1, 2, 3, 4, 5, 0, 1];
/// The second body of a pair, by lane of the two registers. The last lane repeats the pair of bodies 4 and 1 in reverse
/// order.
const SECOND: [[i64; 8]; 2] = [[2, 0, 3, 4, 1, 1, 3, 2], [4, 3, 4, 5, 5, 2, 5, 4]];

/// One value per pair.
#[derive(Clone, Copy)]
struct Pairs<R>([R; 2]);

impl<R: Row> Pairs<R> {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([R::splat(x); 2])
    }
    #[inline(always)]
    fn fma(self, Self([a, b]): Self, Self([c, d]): Self) -> Self {
        Self([self.0[0].fma(a, c), self.0[1].fma(b, d)])
    }
    #[inline(always)]
    fn fnma(self, Self([a, b]): Self, Self([c, d]): Self) -> Self {
        Self([self.0[0].fnma(a, c), self.0[1].fnma(b, d)])
    }
}

impl<R: Row> Add for Pairs<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, Self([a, b]): Self) -> Self {
        Self([self.0[0] + a, self.0[1] + b])
    }
}

impl<R: Row> Mul for Pairs<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, Self([a, b]): Self) -> Self {
        Self([self.0[0] * a, self.0[1] * b])
    }
}

/// One value per axis.
type Axes<T> = [T; 3];

/// Lane indices for [`Row::pick`], and the strengths of the pulls in these lanes.
#[derive(Clone, Copy)]
struct Pull<R> {
    lanes: [i64; 8],
    strength: R,
}

#[derive(Clone)]
struct Bodies<R, const N: usize> {
    tolerance: f64,
    masses: R,
    /// Strengths of the pulls by the second bodies of both registers.
    ahead: [R; 2],
    /// Lanes and strengths of the other three pulls.
    others: [Pull<R>; 3],
    q: [Kept<R>; 3],
    v: [Kept<R>; 3],
    /// Coefficients of accelerations, by order.
    accelerations: [Axes<R>; HIGHEST],
    /// Coefficients of differences of positions.
    apart: [Axes<Pairs<R>>; HIGHEST],
    /// Coefficients of squared distances.
    square: [Pairs<R>; HIGHEST],
    /// Coefficients of distances.
    length: [Pairs<R>; HIGHEST],
    /// Coefficients of cubed distances.
    cube: [Pairs<R>; HIGHEST],
    /// Coefficients of the quotients of differences and cubes.
    pull: [Axes<Pairs<R>>; HIGHEST],
}

/// Returns, for the body in each lane, the lanes of its three remaining pairs and the strengths of their pulls.
fn others(masses: &[f64; 6]) -> [([i64; 8], [f64; 8]); 3] {
    let pair = |first, second| (0..15).find(|&i| FIRST[i % 8] == first && SECOND[i / 8][i % 8] == second);
    let mut found = [([0; 8], [0.0; 8]); 3];
    for lane in 0..8 {
        let body = FIRST[lane];
        let others = (0..6).filter(|other| *other != body && SECOND.iter().all(|second| second[lane] != *other));
        for (other, (lanes, strengths)) in others.zip(&mut found) {
            let pull = GRAVITY * masses[other as usize];
            let from_here = pair(body, other).map(|place| (place, pull));
            let (place, pull) = from_here.or(pair(other, body).map(|place| (place, -pull))).expect("all pairs");
            (lanes[lane], strengths[lane]) = (place as i64, pull);
        }
    }
    found
}

impl<R: Row, const N: usize> Bodies<R, N> {
    #[inline(always)]
    fn new(system: &Solar, start: &Phase<[[f64; 3]; 6]>, tolerance: f64) -> Self {
        let masses = &system.masses;
        let (zero, none) = (R::splat(0.0), Pairs::splat(0.0));
        let bodies = FIRST.map(|body| body as usize);
        Self {
            tolerance,
            masses: R::load(&from_fn::<f64, 8, _>(|lane| if lane < 6 { masses[lane] } else { 0.0 })),
            ahead: SECOND.map(|second| R::load(&second.map(|body| GRAVITY * masses[body as usize]))),
            others: others(masses).map(|(lanes, strengths)| Pull { lanes, strength: R::load(&strengths) }),
            q: from_fn(|axis| Kept::of(R::load(&bodies.map(|body| start.q[body][axis])))),
            v: from_fn(|axis| Kept::of(R::load(&bodies.map(|body| start.p[body][axis] / masses[body])))),
            accelerations: [[zero; 3]; HIGHEST],
            apart: [[none; 3]; HIGHEST],
            square: [none; HIGHEST],
            length: [none; HIGHEST],
            cube: [none; HIGHEST],
            pull: [[none; 3]; HIGHEST],
        }
    }

    /// Computes the coefficients of pair differences from those of the bodies.
    #[inline(always)]
    fn meet(&mut self, k: usize, x: Axes<R>) {
        for axis in 0..3 {
            let [first, second] = [x[axis].pick(x[axis], &SECOND[0]), x[axis].pick(x[axis], &SECOND[1])];
            self.apart[k][axis] = Pairs([first - x[axis], second - x[axis]]);
        }
    }

    /// Computes accelerations from the pulls of order `k`, and pair differences of order `k + 2` from the
    /// accelerations.
    #[inline(always)]
    fn fall(&mut self, k: usize) {
        for axis in 0..3 {
            let Pairs([first, second]) = self.pull[k][axis];
            let [a, b, c] = &self.others;
            let late = first.pick(second, &b.lanes) * b.strength;
            let late = first.pick(second, &c.lanes).fma(c.strength, late);
            let early = first.pick(second, &a.lanes) * a.strength;
            let early = self.ahead[0].fma(first, self.ahead[1].fma(second, early));
            self.accelerations[k][axis] = early + late;
        }
        if k + 2 < N {
            let integral = R::splat(INTEGRALS.twice[k]);
            let [x, y, z] = self.accelerations[k];
            self.meet(k + 2, [x * integral, y * integral, z * integral]);
        }
    }
}

/// Returns the largest weighted absolute value of all bodies.
#[inline(always)]
fn size<R: Row>([x, y, z]: &Axes<R>, weights: R) -> f64 {
    (x.larger(*y).larger(*z) * weights).largest()
}

impl<R: Row, const N: usize> Expansion for Bodies<R, N> {
    type State = Phase<[[f64; 3]; 6]>;

    #[inline(always)]
    fn expand(&mut self) -> f64 {
        // The two lanes of a repeated body are rounded differently, so both are set to the first one.
        let (mut q, mut v) = ([R::splat(0.0); 3], [R::splat(0.0); 3]);
        for axis in 0..3 {
            q[axis] = self.q[axis].value.pick(self.q[axis].value, &FIRST);
            v[axis] = self.v[axis].value.pick(self.v[axis].value, &FIRST);
        }
        self.meet(0, q);
        self.meet(1, v);
        let inverse = self.begin();
        self.fall(0);
        self.fall(1);
        for k in (2..N).step_by(2) {
            self.two_orders(k, inverse);
            self.fall(k);
            self.fall(k + 1);
        }
        let a = &self.accelerations;
        let (one, masses) = (R::splat(1.0), self.masses);
        let positions = Sizes {
            value: size(&q, one),
            slope: size(&v, one),
            before: size(&a[N - 3], one) * INTEGRALS.twice[N - 3],
            last: size(&a[N - 2], one) * INTEGRALS.twice[N - 2],
        };
        let momenta = Sizes {
            value: size(&v, masses),
            slope: size(&a[0], masses),
            before: size(&a[N - 2], masses) * INTEGRALS.once[N - 2],
            last: size(&a[N - 1], masses) * INTEGRALS.once[N - 1],
        };
        reach::<N>(self.tolerance, [positions, momenta])
    }

    #[inline(always)]
    fn proceed(&mut self, by: f64) {
        let weights = Weights::of::<R>(by);
        let zero = R::splat(0.0);
        // Even and odd orders are summed separately, smallest terms first.
        let (mut velocity, mut position) = ([[zero; 3]; 2], [[zero; 3]; 2]);
        for k in (0..N / 2).rev() {
            for odd in [1, 0] {
                let k = 2 * k + odd;
                let (once, twice) = (R::splat(weights.once[k]), R::splat(weights.twice[k]));
                for axis in 0..3 {
                    velocity[odd][axis] = self.accelerations[k][axis].fma(once, velocity[odd][axis]);
                    if k + 2 <= N {
                        position[odd][axis] = self.accelerations[k][axis].fma(twice, position[odd][axis]);
                    }
                }
            }
        }
        for axis in 0..3 {
            let position = position[0][axis] + position[1][axis];
            self.q[axis].add(R::splat(by).fma(self.v[axis].value, position));
            self.v[axis].add(velocity[0][axis] + velocity[1][axis]);
        }
    }

    #[inline(always)]
    fn state(&self) -> Self::State {
        let column = |x: &[Kept<R>; 3], scale: R| {
            let lanes = x.map(|x| {
                let mut lanes = [0.0; 8];
                (x.value * scale).store(&mut lanes);
                lanes
            });
            from_fn(|body| from_fn(|axis| lanes[axis][body]))
        };
        Phase::new(column(&self.q, R::splat(1.0)), column(&self.v, self.masses))
    }
}

impl<R: Row, const N: usize> Bodies<R, N> {
    /// Computes the first two orders of the pair series. Returns the reciprocals of length and cube.
    #[inline(always)]
    fn begin(&mut self) -> [Pairs<R>; 2] {
        let [d, slope] = [self.apart[0], self.apart[1]];
        let square = d[2].fma(d[2], d[1].fma(d[1], d[0] * d[0]));
        let half = d[2].fma(slope[2], d[1].fma(slope[1], d[0] * slope[0]));
        let one = R::splat(1.0);
        let by_cube = Pairs([square.0[0].over_cube(one), square.0[1].over_cube(one)]);
        let by_length = square * by_cube;
        let length = square * by_length;
        self.square[0] = square;
        self.length[0] = length;
        self.cube[0] = square * length;
        self.square[1] = half + half;
        self.length[1] = half * by_length;
        self.cube[1] = square * self.length[1] * Pairs::splat(3.0);
        for axis in 0..3 {
            self.pull[0][axis] = d[axis] * by_cube;
            self.pull[1][axis] = self.cube[1].fnma(self.pull[0][axis], slope[axis]) * by_cube;
        }
        [by_length, by_cube]
    }

    /// Computes the even order `k` and the order `k + 1` of the pair series from the differences of these orders.
    #[inline(always)]
    fn two_orders(&mut self, k: usize, [by_length, by_cube]: [Pairs<R>; 2]) {
        let (none, half) = (Pairs::splat(0.0), Pairs::splat(0.5));
        let middle = k / 2;

        // Half of the squares, first by axis.
        let d = &self.apart;
        let (mut even, mut odd) = ([none; 3], [none; 3]);
        for axis in 0..3 {
            even[axis] = half * d[middle][axis] * d[middle][axis];
        }
        for j in (0..middle).rev() {
            for axis in 0..3 {
                odd[axis] = d[j + 1][axis].fma(d[k - j][axis], odd[axis]);
                even[axis] = d[j][axis].fma(d[k - j][axis], even[axis]);
            }
        }
        for axis in 0..3 {
            odd[axis] = d[0][axis].fma(d[k + 1][axis], odd[axis]);
        }
        let (even, odd) = (even[0] + even[1] + even[2], odd[0] + odd[1] + odd[2]);
        self.square[k] = even + even;
        self.square[k + 1] = odd + odd;

        // Lengths: the unknown coefficients follow from the square and the known products.
        let r = &mut self.length;
        let (mut even, mut odd) = (r[middle].fnma(half * r[middle], even), odd);
        for j in (1..middle).rev() {
            even = r[j].fnma(r[k - j], even);
            odd = r[j + 1].fnma(r[k - j], odd);
        }
        r[k] = even * by_length;
        r[k + 1] = r[1].fnma(r[k], odd) * by_length;

        // Cubes.
        let s = &self.square;
        let (mut even, mut odd) = (none, none);
        for j in 1..k {
            even = r[j].fma(s[k - j], even);
            odd = r[j + 1].fma(s[k - j], odd);
        }
        self.cube[k] = r[0].fma(s[k], r[k].fma(s[0], even));
        self.cube[k + 1] = r[0].fma(s[k + 1], r[k + 1].fma(s[0], r[1].fma(s[k], odd)));

        // Quotients.
        let (c, f) = (&self.cube, &mut self.pull);
        let (mut even, mut odd) = (self.apart[k], self.apart[k + 1]);
        for j in 1..k {
            for axis in 0..3 {
                even[axis] = c[j].fnma(f[k - j][axis], even[axis]);
                odd[axis] = c[j + 1].fnma(f[k - j][axis], odd[axis]);
            }
        }
        for axis in 0..3 {
            f[k][axis] = c[k].fnma(f[0][axis], even[axis]) * by_cube;
            let odd = c[k + 1].fnma(f[0][axis], odd[axis]);
            f[k + 1][axis] = c[1].fnma(f[k][axis], odd) * by_cube;
        }
    }
}

struct Trajectory<'s, const N: usize> {
    system: &'s Solar,
    start: &'s Phase<[[f64; 3]; 6]>,
    course: Course,
    see: &'s mut dyn FnMut(Phase<[[f64; 3]; 6]>),
}

impl<const N: usize> Kernel for Trajectory<'_, N> {
    type Out = u64;
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> u64 {
        let bodies = Bodies::<R, N>::new(self.system, self.start, self.course.tolerance);
        follow(self.course, bodies, self.see)
    }
}

/// Integrates the planets, passes their states to `see`, and returns the number of steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn solar(
    system: &Solar,
    start: &Phase<[[f64; 3]; 6]>,
    course: Course,
    see: &mut dyn FnMut(Phase<[[f64; 3]; 6]>),
) -> u64 {
    with_order!(course.order, N => enter(Trajectory::<N> { system, start, course, see }))
}
