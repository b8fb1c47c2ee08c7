//! The user's own variables, arguments and fields are called as those of generated code are.

use integrator_core::{Coords, prelude::*};

/// Every name that a flow or the preparation of parameters declares.
pub struct Lists {
    n: usize,
    long: Vec<f64>,
    table: Vec<f64>,
}

#[hamiltonian]
impl Lists {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|x| x * x).sum::<f64>() / 2.0
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let length = self.n;
        let step = self.long[0];
        let time = self.long[1];
        let motion = self.long[2];
        let table = &self.table;
        let lane = self.table[0];
        let parameters = 2.0 * step;
        let mut v = 0.0;
        for k in 0..3 {
            for k in 0..2 {
                v += self.long[k] * q[k] * q[k + 1] * step;
            }
            v += table[k] * q[k] * time;
        }
        for k in 0..3 {
            for k_2 in 0..2 {
                for k in 0..2 {
                    v += self.long[k + k_2] * q[k] * q[k_2] * motion * lane;
                }
            }
            v += self.long[k] * q[k].sin();
        }
        v += (0..length).map(|i| self.long[i]).sum::<f64>() * q[0] * q[0] * parameters;
        let order = self.long.iter().map(|length| length * q.len() as f64).sum::<f64>();
        let tape = (0..length).map(|length| self.long[length] * q.len() as f64 * self.table[length]).sum::<f64>();
        v + order * q[1].cos() + tape * q[2].sin()
    }
}

/// The same for what recurrences declare.
pub struct Scalar {
    step: f64,
    length: [f64; 4],
    q: f64,
    p: f64,
}

#[hamiltonian(taylor)]
impl Scalar {
    fn kinetic(&self, step: [f64; 4], time: f64) -> f64 {
        let mut length = 0.0;
        for k in 0..4 {
            length += step[k] * step[k] / 2.0 * (1.0 + self.p * time);
        }
        length
    }
    fn potential(&self, motion: [f64; 4], duration: f64) -> f64 {
        let mut gradient = 0.0;
        for step in 0..4 {
            for time in 0..step {
                gradient += self.length[step] * (motion[step] - motion[time]).powi(2) * self.length[time];
            }
        }
        for tape in 0..4 {
            let length = self.length[tape] * self.step;
            gradient += length * motion[tape].cos() * (duration * self.q).cos();
        }
        for k in 0..2 {
            for j in 0..2 {
                let k_2 = self.length[k + j];
                gradient += k_2 * motion[k] * motion[j] * self.p * self.q;
            }
        }
        gradient
    }
}

/// One kick, read off a step of Euler's method, is the slope of the user's own function.
fn assert_forces<H: Hamiltonian>(system: &H, q: H::Coords, potential: impl Fn(&H::Coords) -> f64) {
    let start = Phase::new(q.clone(), q.clone());
    let mut run = system.run_with::<f64, _>(Euler, start, 1.0).expect("an admissible start");
    run.advance(1).expect("finite");
    for k in 0..q.flat().len() {
        let moved = |by: f64| {
            let mut q = q.clone();
            q.flat_mut()[k] += by;
            potential(&q)
        };
        let force = q.flat()[k] - run.state().p.flat()[k];
        // Central differences extrapolated once: h⁴ = 1e-12 of derivatives of order one, and ε/h = 2e-13 of rounding.
        let central = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        let slope = (4.0 * central(5e-4) - central(1e-3)) / 3.0;
        assert!((force - slope).abs() < 1e-9, "coordinate {k}: {force} for {slope}");
    }
}

#[test]
fn every_variable_means_what_the_user_meant() {
    let lists = Lists { n: 3, long: vec![0.5, 0.2, 0.3, 0.7], table: vec![0.1, 0.6, 0.4, 1.0] };
    assert_forces(&lists, vec![0.3, -0.2, 0.5, 0.1], |q| lists.potential(q));
    let scalar = Scalar { step: 0.3, length: [0.1, 0.2, 0.5, 0.3], q: 0.7, p: 0.2 };
    assert_forces(&scalar, [0.3, -0.2, 0.5, 0.1], |q| scalar.potential(*q, 0.0));
}
