use integrator_core::prelude::*;

pub struct System {
    pub cutoff: f64,
    pub types: Vec<usize>,
    pub depths: Vec<Vec<f64>>,
    pub bonds: Vec<[usize; 2]>,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let square = x * x + y * y + z * z;
                if square < self.cutoff * self.cutoff {
                    energy += self.depths[self.types[i]][self.types[j]] * (square.powi(-6) - square.powi(-3));
                }
            }
        }
        for &[a, b] in &self.bonds {
            let [x, y, z] = [q[a][0] - q[b][0], q[a][1] - q[b][1], q[a][2] - q[b][2]];
            energy += 15.0 * ((x * x + y * y + z * z).sqrt() - 1.0).powi(2);
        }
        energy
    }
}

pub fn system() -> System {
    let (types, depths) = (vec![0, 1, 0, 0, 1], vec![vec![4.0, 6.0], vec![6.0, 2.0]]);
    System { cutoff: 2.5, types, depths, bonds: (1..5).map(|i| [i - 1, i]).collect() }
}

pub fn start() -> Phase<Vec<[f64; 3]>> {
    Phase::new((0..5).map(|i| [1.2 * i as f64, 0.1 * i as f64, 0.0]).collect::<Vec<_>>(), vec![[0.0; 3]; 5])
}
