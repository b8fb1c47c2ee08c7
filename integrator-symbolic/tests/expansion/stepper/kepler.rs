#[hamiltonian]
impl Kepler {
    fn kinetic(&self, p: &[f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        -self.mu / (q[0].powi(2) + q[1] * q[1]).sqrt()
    }
}
