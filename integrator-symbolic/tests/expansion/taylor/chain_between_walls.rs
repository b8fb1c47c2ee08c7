#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: [f64; 32]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 32]) -> f64 {
        let mut energy = q[0].powi(4) / 4.0 + q[31].powi(4) / 4.0;
        for i in 1..32 {
            energy += (q[i] - q[i - 1]).powi(3) / 3.0;
        }
        energy
    }
}
