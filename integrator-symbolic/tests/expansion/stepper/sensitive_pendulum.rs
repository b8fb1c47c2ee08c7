#[hamiltonian(sensitive(mass, length))]
impl Pendulum {
    fn inertia(&self) -> f64 {
        self.mass * self.length.powi(2)
    }
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.inertia())
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let mut energy = -self.mass * self.gravity * self.length * q[0].cos();
        for k in 0..self.overtones.len() {
            energy += self.overtones[k] * (self.length + k as f64).sqrt() * (q[0] * k as f64).cos();
        }
        energy
    }
}
