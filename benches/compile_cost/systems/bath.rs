use integrator_core::prelude::*;
// The composition of the capabilities, with friction.
use integrator_core::Baoab as Verlet;

pub struct System {
    pub gravity: f64,
    pub temperature: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl System {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.gravity * q[0].cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        0.1
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        self.temperature
    }
}

pub fn system() -> System {
    System { gravity: 1.5, temperature: 0.5 }
}

pub fn start() -> Phase<[f64; 1]> {
    Phase::new([1.0], [0.0])
}
