//! Helper methods that each call the next one twice, with other arguments: 2048 different calls of the last one.

use integrator_core::prelude::*;

struct System;

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.level_11(q[0])
    }
    fn level_0(&self, x: f64) -> f64 {
        x.sin() + 0.1 * x * x
    }
    fn level_1(&self, x: f64) -> f64 {
        self.level_0(x + 0.1) * self.level_0(0.9 * x)
    }
    fn level_2(&self, x: f64) -> f64 {
        self.level_1(x + 0.2) * self.level_1(0.9 * x)
    }
    fn level_3(&self, x: f64) -> f64 {
        self.level_2(x + 0.3) * self.level_2(0.9 * x)
    }
    fn level_4(&self, x: f64) -> f64 {
        self.level_3(x + 0.4) * self.level_3(0.9 * x)
    }
    fn level_5(&self, x: f64) -> f64 {
        self.level_4(x + 0.5) * self.level_4(0.9 * x)
    }
    fn level_6(&self, x: f64) -> f64 {
        self.level_5(x + 0.6) * self.level_5(0.9 * x)
    }
    fn level_7(&self, x: f64) -> f64 {
        self.level_6(x + 0.7) * self.level_6(0.9 * x)
    }
    fn level_8(&self, x: f64) -> f64 {
        self.level_7(x + 0.8) * self.level_7(0.9 * x)
    }
    fn level_9(&self, x: f64) -> f64 {
        self.level_8(x + 0.9) * self.level_8(0.9 * x)
    }
    fn level_10(&self, x: f64) -> f64 {
        self.level_9(x + 1.0) * self.level_9(0.9 * x)
    }
    fn level_11(&self, x: f64) -> f64 {
        self.level_10(x + 1.1) * self.level_10(0.9 * x)
    }
}

fn main() {
    let _ = System.run(Phase::new([0.1], [0.0]), 0.1);
}
