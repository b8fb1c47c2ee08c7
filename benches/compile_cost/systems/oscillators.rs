use integrator_core::prelude::*;

pub struct System {
    pub frequencies: [f64; 3],
}

#[hamiltonian(split = quadratic + rest)]
impl System {
    fn hamiltonian(&self, [x, y, z]: [f64; 3], [px, py, pz]: [f64; 3]) -> f64 {
        let [a, b, c] = self.frequencies;
        let kinetic = (px * px + py * py + pz * pz) / 2.0 + 0.2 * (x * py - y * px);
        kinetic + (a * x * x + b * y * y + c * z * z) / 2.0 + x * x * y * z - y.powi(3) / 3.0
    }
}

pub fn system() -> System {
    System { frequencies: [1.0, 1.1, 0.9] }
}

pub fn start() -> Phase<[f64; 3]> {
    Phase::new([0.1, 0.2, 0.0], [0.0, 0.1, 0.1])
}
