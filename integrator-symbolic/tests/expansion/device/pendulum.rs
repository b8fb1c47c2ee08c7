#[hamiltonian(gpu)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * self.gravity * self.length * q[0].cos()
    }
}
