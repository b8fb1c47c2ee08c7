use integrator_core::prelude::*;

pub struct System {
    pub masses: [f64; 6],
}

#[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction)]
impl System {
    fn kinetic(&self, p: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

pub fn system() -> System {
    System { masses: [1.0, 1e-3, 3e-4, 4e-5, 5e-5, 1e-8] }
}

pub fn start() -> Phase<[[f64; 3]; 6]> {
    let mut start = Phase::new([[0.0; 3]; 6], [[0.0; 3]; 6]);
    for body in 1..6 {
        let radius = body as f64;
        start.q[body] = [radius, 0.0, 0.01 * radius];
        start.p[body] = [0.0, system().masses[body] / radius.sqrt(), 0.0];
    }
    start
}
