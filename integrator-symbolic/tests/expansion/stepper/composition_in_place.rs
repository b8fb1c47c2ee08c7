#[hamiltonian(compose = V(1/2) T(1) V(1/2))]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.stiffness * q[0] * q[0] / 2.0
    }
}
