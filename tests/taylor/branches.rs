//! Random potentials with branches that motions cross, by Taylor's method and by Runge and Kutta's method of order 4, whose steps
//! end at the edges.

use crate::runs::FINE;
use integrator_core::{prelude::*, taylor::Taylor};

/// Terms along lines in the plane, each of a kind, with an edge in space and in time.
#[derive(Clone, Debug)]
struct Branches {
    kinds: Vec<u32>,
    along: Vec<[f64; 2]>,
    edges: Vec<f64>,
    weights: Vec<f64>,
    times: Vec<f64>,
}

const KINDS: u32 = 11;

#[hamiltonian(taylor)]
impl Branches {
    fn kinetic(&self, [a, b]: [f64; 2]) -> f64 {
        0.5 * (a * a + b * b)
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let mut energy = 0.5 * q[0] * q[0] + 0.65 * q[1] * q[1];
        for k in 0..self.kinds.len() {
            let x = self.along[k][0] * q[0] + self.along[k][1] * q[1] - self.edges[k];
            energy += self.weights[k]
                * match self.kinds[k] {
                    0 => x.max(0.0).powi(3),
                    1 => {
                        if x > 0.0 {
                            x * x
                        } else {
                            0.0
                        }
                    }
                    2 => x.abs(),
                    3 => x.clamp(-0.5, 0.5),
                    4 => {
                        if x > 0.0 {
                            if x > 0.7 { 2.0 * x - 0.7 } else { x }
                        } else {
                            -x
                        }
                    }
                    5 => {
                        if t > self.times[k] {
                            x.sin()
                        } else {
                            0.0
                        }
                    }
                    6 => {
                        if t < self.times[k] && x > 0.0 {
                            x * x * x
                        } else if x > 0.0 {
                            x * x
                        } else {
                            -0.3 * x
                        }
                    }
                    7 => (x * x).powf(1.5),
                    8 => {
                        let least = x.min(q[1]);
                        least * least
                    }
                    // Both arguments vanish at the edge, where the angle jumps by half a turn.
                    9 => x.atan2(2.0 * x) * q[1] * q[1],
                    _ => x.floor() * x - 0.5 * x.floor() * (x.floor() + 1.0),
                };
        }
        energy
    }
}

impl Branches {
    /// The terms of a seed (SplitMix64), and a start.
    fn of_seed(seed: u64) -> (Self, Phase<[f64; 2]>) {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut next = || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (z ^ (z >> 31)) >> 11
        };
        let count = 1 + next() as usize % 5;
        let kinds = (0..count).map(|_| (next() % u64::from(KINDS)) as u32).collect();
        let mut between = |from: f64, to: f64| from + (to - from) * next() as f64 / (1_u64 << 53) as f64;
        let along = (0..count).map(|_| [between(-1.0, 1.0), between(-1.0, 1.0)]).collect();
        let mut list = |from, to| (0..count).map(|_| between(from, to)).collect::<Vec<_>>();
        let (edges, weights, times) = (list(-0.8, 0.8), list(-0.5, 1.5), list(0.1, 2.4));
        let start = Phase::new([0; 2].map(|_| between(-1.2, 1.2)), [0; 2].map(|_| between(-1.2, 1.2)));
        (Self { kinds, along, edges, weights, times }, start)
    }

    fn argument(&self, k: usize, q: [f64; 2]) -> f64 {
        self.along[k][0] * q[0] + self.along[k][1] * q[1] - self.edges[k]
    }

    /// The numbers whose signs, or whole parts, decide which formula each term has.
    fn sides(&self, q: [f64; 2], t: f64) -> Vec<i64> {
        let mut sides = Vec::new();
        for (k, kind) in self.kinds.iter().enumerate() {
            let x = self.argument(k, q);
            let of = |conditions: &[bool]| conditions.iter().fold(0, |side, holds| 2 * side + i64::from(*holds));
            sides.push(match kind {
                0..=2 | 7 | 9 => of(&[x > 0.0]),
                3 => of(&[x > -0.5, x > 0.5]),
                4 => of(&[x > 0.0, x > 0.7]),
                5 => of(&[t > self.times[k]]),
                6 => of(&[t < self.times[k], x > 0.0]),
                8 => of(&[x < q[1]]),
                _ => x.floor() as i64,
            });
        }
        sides
    }

    /// The force by the formulas of these sides.
    fn force(&self, sides: &[i64], q: [f64; 2]) -> [f64; 2] {
        let mut force = [-q[0], -1.3 * q[1]];
        for (k, (kind, side)) in self.kinds.iter().zip(sides).enumerate() {
            let x = self.argument(k, q);
            let is = |place: i64| side >> place & 1 == 1;
            let slope = match kind {
                0 => {
                    if is(0) {
                        3.0 * x * x
                    } else {
                        0.0
                    }
                }
                1 => {
                    if is(0) {
                        2.0 * x
                    } else {
                        0.0
                    }
                }
                2 => {
                    if is(0) {
                        1.0
                    } else {
                        -1.0
                    }
                }
                3 => {
                    if is(1) && !is(0) {
                        1.0
                    } else {
                        0.0
                    }
                }
                4 => [-1.0, 1.0, 2.0][(side.count_ones()) as usize],
                5 => {
                    if is(0) {
                        x.cos()
                    } else {
                        0.0
                    }
                }
                6 => match (is(1), is(0)) {
                    (_, false) => -0.3,
                    (true, true) => 3.0 * x * x,
                    (false, true) => 2.0 * x,
                },
                7 => {
                    if is(0) {
                        3.0 * x * x
                    } else {
                        -3.0 * x * x
                    }
                }
                8 => {
                    if !is(0) {
                        force[1] -= self.weights[k] * 2.0 * q[1];
                    }
                    if is(0) { 2.0 * x } else { 0.0 }
                }
                9 => {
                    let angle = 0.5_f64.atan() - if is(0) { 0.0 } else { std::f64::consts::PI };
                    force[1] -= self.weights[k] * 2.0 * angle * q[1];
                    0.0
                }
                _ => *side as f64,
            };
            for (force, along) in force.iter_mut().zip(self.along[k]) {
                *force -= self.weights[k] * slope * along;
            }
        }
        force
    }

    /// A step of Runge and Kutta by the formulas of these sides.
    fn step(&self, sides: &[i64], [q, p]: [[f64; 2]; 2], h: f64) -> [[f64; 2]; 2] {
        let add = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
        let field = |q, p| [p, self.force(sides, q)];
        let a = field(q, p);
        let b = field(add(q, a[0], h / 2.0), add(p, a[1], h / 2.0));
        let c = field(add(q, b[0], h / 2.0), add(p, b[1], h / 2.0));
        let d = field(add(q, c[0], h), add(p, c[1], h));
        let sum = |i: usize| [0, 1].map(|j| (a[i][j] + 2.0 * (b[i][j] + c[i][j]) + d[i][j]) / 6.0);
        [add(q, sum(0), h), add(p, sum(1), h)]
    }

    /// The state at a time, by steps of `h` that end just behind the first edge in them.
    fn reference(&self, start: Phase<[f64; 2]>, end: f64, h: f64) -> [[f64; 2]; 2] {
        let (mut state, mut t) = ([start.q, start.p], 0.0);
        while t < end {
            let sides = self.sides(state[0], t);
            let crosses = |duration: f64| self.sides(self.step(&sides, state, duration)[0], t + duration) != sides;
            let (mut before, mut duration) = (0.0, h.min(end - t));
            if crosses(duration) {
                while before < (before + duration) / 2.0 && (before + duration) / 2.0 < duration {
                    let middle = (before + duration) / 2.0;
                    *(if crosses(middle) { &mut duration } else { &mut before }) = middle;
                }
            }
            state = self.step(&sides, state, duration);
            t = if duration == end - t { end } else { t + duration };
        }
        state
    }
}

#[test]
fn random_branches_are_crossed_as_by_small_steps() {
    let (mut crossed, mut compared, seeds, end) = (0, 0, 150, 2.5);
    for seed in 0..seeds {
        let (system, start) = Branches::of_seed(seed);
        let [coarse, fine] = [1024.0, 2048.0].map(|steps| system.reference(start, end, end / steps));
        let apart = |a: [[f64; 2]; 2], b: [[f64; 2]; 2]| {
            a.into_iter().flatten().zip(b.into_iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let known = apart(coarse, fine);
        // The reference has no order where two edges are within one step, and no end where the motion reaches infinity.
        if !(fine[0][0].is_finite() && known < 1e-8) {
            continue;
        }
        compared += 1;
        let mut run = system.run_with(Taylor::tolerance(FINE), start, 0.25).expect("a start");
        run.advance(10).unwrap_or_else(|error| panic!("{seed}: {error}, {system:?}"));
        crossed += usize::from(system.sides(start.q, 0.0) != system.sides(fine[0], end));
        let found = apart([run.state().q, run.state().p], fine);
        // The error of the finer reference is a fifteenth of what the two are apart; thousands of its roundings add up.
        assert!(found <= known + 1e-12, "{seed}: {found:e} where references are {known:e} apart, {system:?}");
    }
    assert!(compared > seeds * 9 / 10 && crossed > seeds as usize / 2, "{compared} compared, {crossed} on other sides");
}
