use integrator_core::prelude::*;

struct Bath;

#[hamiltonian(split = kinetic + potential + friction)]
impl Bath {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        1.0
    }
}

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

fn main() {
    let _ = Bath.metropolised(Verlet, Phase::new([1.0], [0.0]), 0.1);
    let _ = Pendulum.metropolised(Obabo, Phase::new([1.0], [0.0]), 0.1);
}
