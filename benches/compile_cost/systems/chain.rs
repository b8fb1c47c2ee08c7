use integrator_core::prelude::*;

pub struct System {
    pub beta: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += stretch * stretch / 2.0 + self.beta * stretch.powi(4) / 4.0;
        }
        energy
    }
}

pub fn system() -> System {
    System { beta: 0.3 }
}

pub fn start() -> Phase<Vec<f64>> {
    Phase::new(vec![0.1, 0.2, 0.0, -0.1, 0.3], vec![0.0; 5])
}
