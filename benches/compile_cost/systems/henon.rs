use integrator_core::prelude::*;

pub struct System {
    pub frequency: f64,
}

/// The system of Hénon and Heiles in two parts: two oscillators, and the cubic terms that couple them.
#[hamiltonian(split = oscillators + coupling)]
impl System {
    fn oscillators(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + self.frequency * (x * x + y * y)) / 2.0
    }
    fn coupling(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        x * x * y - y.powi(3) / 3.0
    }
}

pub fn system() -> System {
    System { frequency: 1.0 }
}

pub fn start() -> Phase<[f64; 2]> {
    Phase::new([0.0, 0.1], [0.3, 0.1])
}
