use integrator_core::prelude::*;

pub struct System {
    pub side: f64,
    pub cutoff: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let image = |x: f64| x - self.side * (x / self.side).round();
        let square_of_cutoff = self.cutoff * self.cutoff;
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if j == i {
                    continue;
                }
                let a = [image(q[j][0] - q[i][0]), image(q[j][1] - q[i][1]), image(q[j][2] - q[i][2])];
                let first = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
                if first >= square_of_cutoff {
                    continue;
                }
                let r = first.sqrt();
                energy += 3.525 * (0.602 / (first * first) - 1.0) * (1.0 / (r - self.cutoff)).exp();
                for k in j + 1..q.len() {
                    if k == i {
                        continue;
                    }
                    let b = [image(q[k][0] - q[i][0]), image(q[k][1] - q[i][1]), image(q[k][2] - q[i][2])];
                    let second = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
                    if second < square_of_cutoff {
                        let s = second.sqrt();
                        let angle = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (r * s) + 1.0 / 3.0;
                        energy += 21.0 * angle * angle * (1.2 / (r - self.cutoff) + 1.2 / (s - self.cutoff)).exp();
                    }
                }
            }
        }
        energy
    }
}

pub fn system() -> System {
    System { side: 10.0, cutoff: 1.8 }
}

pub fn start() -> Phase<Vec<[f64; 3]>> {
    Phase::new((0..5).map(|i| [1.2 * i as f64, 0.1 * i as f64, 0.0]).collect::<Vec<_>>(), vec![[0.0; 3]; 5])
}
