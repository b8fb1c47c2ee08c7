#[hamiltonian(gpu)]
impl Picked {
    fn kinetic(&self, p: [f64; 4]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 4]) -> f64 {
        let mut energy = self.stiffness * q[self.site].powi(4) + q[FIRST].cos();
        for i in 0..self.count {
            energy += (i as f64 + 1.0) * (q[i] - q[self.partner[i % 2]]).powi(2);
        }
        energy
    }
}
