#[hamiltonian(gpu)]
impl Walls {
    fn kinetic(&self, p: [f64; 12]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 12], t: f64) -> f64 {
        let mut energy = q[0].powi(2) + q[11].powi(4);
        for i in 0..11 {
            energy += self.stiffness[i] * (q[i + 1] - q[i]).powi(4) / 4.0;
        }
        for i in 0..10 {
            energy += (1.0 + 0.2 * t.cos()) * (q[i + 2] - q[i]).powi(2) / 8.0;
        }
        energy
    }
}
