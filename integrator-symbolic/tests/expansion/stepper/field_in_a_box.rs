// Planes closed one behind the other, each with open rows, in a field of its own at each site.
#[hamiltonian]
impl Field {
    fn kinetic(&self, p: &[[[f64; 32]; 16]]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; 32]; 16]]) -> f64 {
        let n = q.len();
        let mut v = 0.0;
        for k in 0..n {
            for j in 0..16 {
                for i in 0..32 {
                    v += 0.5 * (q[(k + 1) % n][j][i] - q[k][j][i]).powi(2) + self.field[k][j][i] * q[k][j][i];
                }
                for i in 1..32 {
                    v += 0.5 * (q[k][j][i] - q[k][j][i - 1]).powi(2);
                }
            }
        }
        v
    }
}
