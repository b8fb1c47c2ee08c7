#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: [f64; 32]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 32]) -> f64 {
        let mut energy = self.bond(q[0]) + self.bond(-q[31]);
        for i in 1..32 {
            energy += self.bond(q[i] - q[i - 1]);
        }
        energy
    }
    fn bond(&self, stretch: f64) -> f64 {
        stretch * stretch / 2.0 + self.alpha * stretch.powi(3) / 3.0
    }
}
