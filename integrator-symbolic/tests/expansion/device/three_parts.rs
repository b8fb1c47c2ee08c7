#[hamiltonian(split = kinetic + twist + potential, compose = Yoshida4, gpu)]
impl Twisted {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * self.mass)
    }

    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0] * q[0] * p[1]
    }

    fn potential(&self, q: [f64; 2]) -> f64 {
        self.depth * q[0].cos() + 0.5 * self.stiffness * q[1] * q[1]
    }
}
