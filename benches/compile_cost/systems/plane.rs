use integrator_core::prelude::*;

pub struct System {
    pub coupling: f64,
}

/// The φ⁴ field on a square lattice, closed in both directions.
#[hamiltonian]
impl System {
    fn kinetic(&self, p: &[[f64; 64]; 64]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 64]; 64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..64 {
            for j in 0..64 {
                energy += (q[i][(j + 1) % 64] - q[i][j]).powi(2) / 2.0 + (q[(i + 1) % 64][j] - q[i][j]).powi(2) / 2.0;
                energy += self.coupling * (q[i][j].powi(2) - 1.0).powi(2) / 4.0;
            }
        }
        energy
    }
}

pub fn system() -> System {
    System { coupling: 0.5 }
}

pub fn start() -> Phase<[[f64; 64]; 64]> {
    let mut start = Phase::new([[1.0; 64]; 64], [[0.0; 64]; 64]);
    start.q[3][5] = 0.5;
    start
}
