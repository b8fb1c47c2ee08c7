#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        q[0].powi(2) / 2.0 - self.amplitude * q[0] * (self.omega * t).cos()
    }
}
