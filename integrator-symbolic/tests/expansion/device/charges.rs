#[hamiltonian(gpu)]
impl Charges {
    fn kinetic(&self, p: [f64; 4]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 4], t: f64) -> f64 {
        let mut energy = 0.0;
        for i in 0..4 {
            energy += 0.5 * self.trap[i] * q[i] * q[i] * t.cos();
            for j in 0..i {
                energy += self.charge[i] * self.charge[j] / (1.0 + (q[i] - q[j]).powi(2)) + (q[i] * q[j]).sin();
            }
        }
        energy
    }
}
