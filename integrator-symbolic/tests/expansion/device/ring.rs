#[hamiltonian(gpu)]
impl Ring {
    fn kinetic(&self, p: [f64; 16]) -> f64 {
        let mut energy = 0.0;
        for i in 0..16 {
            energy += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        energy
    }
    fn potential(&self, q: [f64; 16]) -> f64 {
        let mut energy = 0.0;
        for i in 0..16 {
            let r = q[(i + 1) % 16] - q[i];
            energy += r * r / 2.0 + self.alpha[i] * r.powi(3) / 3.0;
        }
        energy
    }
}
