// Closed rows that lie open one beside the other.
#[hamiltonian]
impl Rotors {
    fn kinetic(&self, p: &[[f64; 64]]) -> f64 {
        let mut t = 0.0;
        for i in 0..p.len() {
            for j in 0..64 {
                t += p[i][j].powi(2) / (2.0 * self.inertia[i][j]);
            }
        }
        t
    }
    fn potential(&self, q: &[[f64; 64]]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..64 {
                v -= self.along[j] * (q[i][(j + 1) % 64] - q[i][j]).cos();
            }
        }
        for i in 0..q.len() - 1 {
            for j in 0..64 {
                v -= self.across[i] * (q[i + 1][j] - q[i][j]).cos();
            }
        }
        v
    }
}
