//! Oscillators that turn by prepared angles between kicks of what is not harmonic.

use crate::{
    enter::{Kernel, enter_scalar},
    plan::Plan,
    vector::{Row, Vector},
};

/// What a turn adds, with each number as an upper half and the rest, so that radii neither grow nor shrink.
#[derive(Clone, Copy)]
struct Turn {
    cosine: [f64; 2],
    sine: [f64; 2],
}

impl Turn {
    fn by(angle: f64) -> Self {
        let halves = |x: f64| {
            let upper = f64::from_bits(x.to_bits() & (!0 << 27));
            [upper, x - upper]
        };
        // cos a - 1, without the digits that cancel.
        Self { cosine: halves(-2.0 * (0.5 * angle).sin().powi(2)), sine: halves(angle.sin()) }
    }
}

struct HenonHeiles<'p> {
    q: [f64; 2],
    p: [f64; 2],
    opening: (Turn, f64),
    cycle: &'p [(Turn, f64)],
    closing: Turn,
    steps: u64,
}

impl HenonHeiles<'_> {
    #[inline(always)]
    fn turn(&mut self, Turn { cosine, sine }: Turn) {
        for (q, p) in self.q.iter_mut().zip(&mut self.p) {
            let moved = [0, 1].map(|half| sine[half].mul_add(*p, cosine[half] * *q));
            let pushed = [0, 1].map(|half| cosine[half].mul_add(*p, -sine[half] * *q));
            *q += moved[0] + moved[1];
            *p += pushed[0] + pushed[1];
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [x, y] = self.q;
        self.p[0] = (-2.0 * t * y).mul_add(x, self.p[0]);
        self.p[1] = (-t).mul_add(x.mul_add(x, -(y * y)), self.p[1]);
    }
}

impl Kernel for HenonHeiles<'_> {
    type Out = [f64; 4];
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> [f64; 4] {
        self.turn(self.opening.0);
        self.kick(self.opening.1);
        for (turn, kick) in &self.cycle[1..] {
            self.turn(*turn);
            self.kick(*kick);
        }
        for _ in 1..self.steps {
            for (turn, kick) in self.cycle {
                self.turn(*turn);
                self.kick(*kick);
            }
        }
        self.turn(self.closing);
        let ([x, y], [px, py]) = (self.q, self.p);
        [x, y, px, py]
    }
}

/// A star in a galaxy, from `[x, y, p_x, p_y]`; compositions begin with the oscillators.
pub fn henon_heiles([x, y, px, py]: [f64; 4], plan: &Plan, steps: u64) -> [f64; 4] {
    let ([opening, kick], cycle, closing) = plan.drifts_first();
    let cycle: Vec<_> = cycle.iter().map(|[drift, kick]| (Turn::by(*drift), *kick)).collect();
    let opening = (Turn::by(opening), kick);
    enter_scalar(HenonHeiles { q: [x, y], p: [px, py], opening, cycle: &cycle, closing: Turn::by(closing), steps })
}
