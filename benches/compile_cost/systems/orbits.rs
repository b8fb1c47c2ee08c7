use integrator_core::prelude::*;

pub struct System {
    pub masses: [f64; 5],
}

#[hamiltonian(split = kepler + interaction)]
impl System {
    fn kepler(&self, q: [[f64; 3]; 5], p: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            let ([x, y, z], [u, v, w]) = (q[i], p[i]);
            energy += (u * u + v * v + w * w) / (2.0 * self.masses[i]);
            energy -= self.masses[i] / (x * x + y * y + z * z).sqrt();
        }
        energy
    }
    fn interaction(&self, q: [[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 1..5 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

pub fn system() -> System {
    System { masses: [1e-3, 3e-4, 4e-5, 5e-5, 1e-8] }
}

pub fn start() -> Phase<[[f64; 3]; 5]> {
    let mut start = Phase::new([[0.0; 3]; 5], [[0.0; 3]; 5]);
    for body in 0..5 {
        let radius = 1.0 + body as f64;
        start.q[body] = [radius, 0.0, 0.01 * radius];
        start.p[body] = [0.0, system().masses[body] / radius.sqrt(), 0.0];
    }
    start
}
