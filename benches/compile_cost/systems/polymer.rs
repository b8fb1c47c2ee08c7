use integrator_core::prelude::*;

pub struct System {
    pub bonds: Vec<(usize, usize)>,
}

#[hamiltonian(split = pairs + 8 * (bonds + kinetic))]
impl System {
    fn pairs(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let square = x * x + y * y + z * z;
                if square < 6.25 {
                    energy += square.powi(-6) - square.powi(-3);
                }
            }
        }
        energy
    }
    fn bonds(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for &(i, j) in &self.bonds {
            let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
            energy += 500.0 * ((x * x + y * y + z * z).sqrt() - 1.0).powi(2);
        }
        energy
    }
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
}

pub fn system() -> System {
    System { bonds: vec![(0, 1), (1, 2), (2, 3), (3, 4)] }
}

pub fn start() -> Phase<Vec<[f64; 3]>> {
    Phase::new((0..5).map(|i| [1.2 * i as f64, 0.1 * i as f64, 0.0]).collect::<Vec<_>>(), vec![[0.0; 3]; 5])
}
