//! Silicon in a periodic box (Stillinger and Weber 1985): loops over triplets, beside a hand-written stepper with neighbour lists.

use crate::{Group, spellings};
use integrator_core::prelude::*;

/// Cells of eight atoms along an edge of the box.
const CELLS: usize = 8;
const STEP: f64 = 0.005;
const CUTOFF: f64 = 1.8;
const LAMBDA: f64 = 21.0;
const GAMMA: f64 = 1.2;

#[derive(Clone)]
struct Parameters {
    side: f64,
    cutoff: f64,
    lambda: f64,
    gamma: f64,
}

fn cell() -> f64 {
    (8.0_f64 / 0.46).cbrt()
}

fn parameters() -> Parameters {
    Parameters { side: cell() * CELLS as f64, cutoff: CUTOFF, lambda: LAMBDA, gamma: GAMMA }
}

fn start() -> Phase<Vec<[f64; 3]>> {
    let corners = [[0.0, 0.0, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.0]];
    let site = |i: usize| {
        let (number, atom) = (i / 8, i % 8);
        let origin = [number % CELLS, number / CELLS % CELLS, number / CELLS / CELLS];
        let shift = if atom < 4 { 0.0 } else { 0.25 };
        [0, 1, 2].map(|d| (origin[d] as f64 + corners[atom % 4][d] + shift) * cell())
    };
    let going = |i: usize| [0, 1, 2].map(|d| 0.2 * ((i * 13 + d * 7) as f64 * 0.77).sin());
    let atoms = 8 * CELLS * CELLS * CELLS;
    Phase::new((0..atoms).map(site).collect(), (0..atoms).map(going).collect())
}

/// Silicon with this sum over triplets, beside one over pairs or, as `whole`, with the pairs in it.
macro_rules! silicon {
    ($name:ident, |$self:ident, $q:ident, $v:ident| $triplets:block) => {
        silicon!(whole $name, |$self, $q, $v| {
            for i in 0..$q.len() {
                for j in 0..i {
                    let r = $self.length($self.leg($q[i], $q[j]));
                    if r < $self.0.cutoff {
                        $v += $self.bond(r);
                    }
                }
            }
            $triplets
        });
    };
    (whole $name:ident, |$self:ident, $q:ident, $v:ident| $energy:block) => {
        struct $name(Parameters);

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
                p.iter().flatten().map(|p| 0.5 * p * p).sum()
            }
            fn potential(&$self, $q: &[[f64; 3]]) -> f64 {
                let mut $v = 0.0;
                $energy
                $v
            }
            fn bond(&self, r: f64) -> f64 {
                7.049556277 * (0.6022245584 / r.powi(4) - 1.0) * (1.0 / (r - self.0.cutoff)).exp()
            }
            fn leg(&self, a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
                [0, 1, 2].map(|d| (b[d] - a[d]) - self.0.side * ((b[d] - a[d]) / self.0.side).round())
            }
            fn length(&self, u: [f64; 3]) -> f64 {
                (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt()
            }
            fn bend(&self, u: [f64; 3], w: [f64; 3]) -> f64 {
                let (r, s) = (self.length(u), self.length(w));
                let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (r * s);
                let damping = self.0.gamma / (r - self.0.cutoff) + self.0.gamma / (s - self.0.cutoff);
                self.0.lambda * (cosine + 1.0 / 3.0).powi(2) * damping.exp()
            }
        }
    };
}

silicon!(Skips, |self, q, v| {
    for i in 0..q.len() {
        for j in 0..q.len() {
            if j == i {
                continue;
            }
            let u = self.leg(q[i], q[j]);
            if self.length(u) >= self.0.cutoff {
                continue;
            }
            for k in j + 1..q.len() {
                let w = self.leg(q[i], q[k]);
                if k != i && self.length(w) < self.0.cutoff {
                    v += self.bend(u, w);
                }
            }
        }
    }
});
silicon!(whole Joined, |self, q, v| {
    for i in 0..q.len() {
        for j in 0..q.len() {
            let u = self.leg(q[i], q[j]);
            let r = self.length(u);
            if j == i || r >= self.0.cutoff {
                continue;
            }
            v += 0.5 * self.bond(r);
            for k in j + 1..q.len() {
                let w = self.leg(q[i], q[k]);
                if k == i || self.length(w) >= self.0.cutoff {
                    continue;
                }
                v += self.bend(u, w);
            }
        }
    }
});
silicon!(Halves, |self, q, v| {
    for i in 0..q.len() {
        for j in 0..q.len() {
            for k in 0..q.len() {
                if j != i && k != i && j != k {
                    let (u, w) = (self.leg(q[i], q[j]), self.leg(q[i], q[k]));
                    if self.length(u) < self.0.cutoff && self.length(w) < self.0.cutoff {
                        v += 0.5 * self.bend(u, w);
                    }
                }
            }
        }
    }
});
silicon!(Sums, |self, q, v| {
    v += (0..q.len())
        .map(|i| {
            (0..q.len())
                .filter(|&j| j != i && self.length(self.leg(q[i], q[j])) < self.0.cutoff)
                .map(|j| {
                    (0..j)
                        .filter(|&k| k != i && self.length(self.leg(q[i], q[k])) < self.0.cutoff)
                        .map(|k| self.bend(self.leg(q[i], q[j]), self.leg(q[i], q[k])))
                        .sum::<f64>()
                })
                .sum::<f64>()
        })
        .sum::<f64>();
});

/// A stepper as one writes it by hand: full lists with a skin, from which the neighbours within the cutoff are picked once per step.
struct ByHand {
    side: f64,
    q: Vec<[f64; 3]>,
    p: Vec<[f64; 3]>,
    force: Vec<[f64; 3]>,
    lists: Vec<Vec<u32>>,
    listed_at: Vec<[f64; 3]>,
}

const SKIN: f64 = 0.3;

impl ByHand {
    fn new() -> Self {
        let Phase { q, p, .. } = start();
        let none = || vec![[0.0; 3]; q.len()];
        let (force, listed_at) = (none(), vec![[f64::INFINITY; 3]; q.len()]);
        Self { side: parameters().side, lists: vec![Vec::new(); q.len()], q, p, force, listed_at }
    }

    fn leg(&self, i: usize, j: usize) -> ([f64; 3], f64) {
        let inverse = 1.0 / self.side;
        let leg: [f64; 3] = [0, 1, 2].map(|d: usize| {
            let x = self.q[j][d] - self.q[i][d];
            x - self.side * (x * inverse).round_ties_even()
        });
        (leg, leg[0] * leg[0] + leg[1] * leg[1] + leg[2] * leg[2])
    }

    fn renew(&mut self) {
        let has_moved = self
            .q
            .iter()
            .zip(&self.listed_at)
            .any(|(now, then)| (0..3).map(|d| (now[d] - then[d]).powi(2)).sum::<f64>() >= (0.5 * SKIN).powi(2));
        if !has_moved {
            return;
        }
        for i in 0..self.q.len() {
            let near = (0..self.q.len()).filter(|&j| j != i && self.leg(i, j).1 < (CUTOFF + SKIN).powi(2));
            self.lists[i] = near.map(|j| j as u32).collect();
        }
        self.listed_at.clone_from(&self.q);
    }

    /// The forces, and the potential energy.
    fn compute(&mut self) -> f64 {
        self.renew();
        let mut force = std::mem::take(&mut self.force);
        force.fill([0.0; 3]);
        let (mut energy, mut near) = (0.0, Vec::with_capacity(32));
        for i in 0..self.q.len() {
            near.clear();
            for &j in &self.lists[i] {
                let (leg, square) = self.leg(i, j as usize);
                if square < CUTOFF * CUTOFF {
                    let r = square.sqrt();
                    let inside = 1.0 / (r - CUTOFF);
                    near.push((j as usize, leg, r, inside, (GAMMA * inside).exp()));
                }
            }
            for (first, &(j, u, r, inside, damped)) in near.iter().enumerate() {
                if j < i {
                    let (fourth, decay) = (1.0 / r.powi(4), inside.exp());
                    let depth = 7.049556277 * (0.6022245584 * fourth - 1.0) * decay;
                    energy += depth;
                    let slope = -7.049556277 * 4.0 * 0.6022245584 * fourth / r * decay - depth * inside * inside;
                    for d in 0..3 {
                        force[i][d] += slope * u[d] / r;
                        force[j][d] -= slope * u[d] / r;
                    }
                }
                for &(k, w, s, beyond, fading) in &near[first + 1..] {
                    let cosine = (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / (r * s);
                    let (angle, factor) = (cosine + 1.0 / 3.0, LAMBDA * damped * fading);
                    energy += factor * angle * angle;
                    let (bend, damping) = (2.0 * factor * angle, factor * angle * angle * GAMMA);
                    for d in 0..3 {
                        let by_u =
                            bend * (w[d] / (r * s) - cosine * u[d] / (r * r)) - damping * inside * inside * u[d] / r;
                        let by_w =
                            bend * (u[d] / (r * s) - cosine * w[d] / (s * s)) - damping * beyond * beyond * w[d] / s;
                        force[j][d] -= by_u;
                        force[k][d] -= by_w;
                        force[i][d] += by_u + by_w;
                    }
                }
            }
        }
        self.force = force;
        energy
    }

    fn energy(&mut self) -> f64 {
        self.compute() + self.p.iter().flatten().map(|p| 0.5 * p * p).sum::<f64>()
    }

    /// Steps of Verlet: half a drift, a kick, half a drift.
    fn advance(&mut self, steps: u64) {
        for _ in 0..steps {
            self.drift(0.5 * STEP);
            self.compute();
            for (p, force) in self.p.iter_mut().flatten().zip(self.force.iter().flatten()) {
                *p += STEP * force;
            }
            self.drift(0.5 * STEP);
        }
    }

    fn drift(&mut self, step: f64) {
        for (q, p) in self.q.iter_mut().flatten().zip(self.p.iter().flatten()) {
            *q += step * p;
        }
    }
}

pub(crate) fn groups() -> Vec<Group<'static>> {
    let mut triplets = Group::new("triplets", 40);
    spellings!(triplets, parameters(), start(), STEP;
        "continue, k after j" Skips, "one condition" Joined, "half of all orders" Halves, "iterators, k before j" Sums,
    );
    let mut by_hand = ByHand::new();
    let energy = by_hand.energy();
    triplets.add("hand-written", energy, move |steps| by_hand.advance(steps));
    vec![triplets]
}
