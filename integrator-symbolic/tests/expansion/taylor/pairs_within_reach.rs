#[hamiltonian(taylor)]
impl Cluster {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|[x, y]| 0.5 * (x * x + y * y)).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                if square < self.reach {
                    energy += 1.0 / square.powi(3) - (1.0 + square).ln();
                }
            }
        }
        energy
    }
}
