//! Oscillators with precomputed rotations, alternating with kicks of the anharmonic rest.

use crate::{
    enter::{Kernel, enter_scalar},
    plan::Plan,
    vector::{Row, Vector},
};

/// Increments of a rotation. Each number is split into an upper half and a remainder, so that rounding does not change
/// the radius systematically.
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
        // cos a - 1, without cancellation.
        Self { cosine: halves(-2.0 * (0.5 * angle).sin().powi(2)), sine: halves(angle.sin()) }
    }
}

/// A state, followed by deviation vectors.
struct HenonHeiles<'p, const POINTS: usize> {
    points: [[f64; 4]; POINTS],
    opening: (Turn, f64),
    cycle: &'p [(Turn, f64)],
    closing: Turn,
    steps: u64,
}

impl<const POINTS: usize> HenonHeiles<'_, POINTS> {
    #[inline(always)]
    fn turn(&mut self, Turn { cosine, sine }: Turn) {
        for [x, y, px, py] in &mut self.points {
            for (q, p) in [(x, px), (y, py)] {
                let moved = [0, 1].map(|half| sine[half].mul_add(*p, cosine[half] * *q));
                let pushed = [0, 1].map(|half| cosine[half].mul_add(*p, -sine[half] * *q));
                *q += moved[0] + moved[1];
                *p += pushed[0] + pushed[1];
            }
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let [star, vectors @ ..] = &mut self.points[..] else { return };
        let [x, y, ..] = *star;
        star[2] = (-2.0 * t * y).mul_add(x, star[2]);
        star[3] = (-t).mul_add(x.mul_add(x, -(y * y)), star[3]);
        let (by_x, by_y) = (-2.0 * t * x, -2.0 * t * y);
        for [dx, dy, dpx, dpy] in vectors {
            *dpx = by_y.mul_add(*dx, by_x.mul_add(*dy, *dpx));
            *dpy = by_x.mul_add(*dx, (-by_y).mul_add(*dy, *dpy));
        }
    }
}

impl<const POINTS: usize> Kernel for HenonHeiles<'_, POINTS> {
    type Out = [[f64; 4]; POINTS];
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(mut self) -> Self::Out {
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
        self.points
    }
}

/// Integrates the state `[x, y, p_x, p_y]` and the deviation vectors that follow it. Compositions begin with the
/// oscillators.
pub fn henon_heiles<const POINTS: usize>(points: [[f64; 4]; POINTS], plan: &Plan, steps: u64) -> [[f64; 4]; POINTS] {
    let ([opening, kick], cycle, closing) = plan.drifts_first();
    let cycle: Vec<_> = cycle.iter().map(|[drift, kick]| (Turn::by(*drift), *kick)).collect();
    let opening = (Turn::by(opening), kick);
    enter_scalar(HenonHeiles { points, opening, cycle: &cycle, closing: Turn::by(closing), steps })
}
