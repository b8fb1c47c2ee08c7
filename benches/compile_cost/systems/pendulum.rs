use integrator_core::prelude::*;

pub struct System {
    pub gravity: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.gravity * q[0].cos()
    }
}

pub fn system() -> System {
    System { gravity: 1.5 }
}

pub fn start() -> Phase<[f64; 1]> {
    Phase::new([1.0], [0.0])
}
