#[hamiltonian]
impl Cluster {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut v = 0.0;
        for i in 0..self.masses.len() {
            for j in 0..i {
                let mut r2 = self.softening;
                for k in 0..3 {
                    r2 += (q[3 * i + k] - q[3 * j + k]).powi(2);
                }
                v -= self.masses[i] * self.masses[j] / r2.sqrt();
            }
        }
        v
    }
}
