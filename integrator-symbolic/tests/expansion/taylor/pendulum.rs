#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.strength * q[0].cos()
    }
}
