use integrator_core::prelude::*;

pub struct System {
    pub masses: Vec<f64>,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in i + 1..q.len() {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

pub fn system() -> System {
    System { masses: vec![1.0, 0.1, 0.2] }
}

pub fn start() -> Phase<Vec<[f64; 3]>> {
    Phase::new(
        vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.1]],
        vec![[0.0; 3], [0.0, 0.1, 0.0], [0.2, 0.0, 0.0]],
    )
}
