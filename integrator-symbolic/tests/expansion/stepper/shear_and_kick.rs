#[hamiltonian(split = twist + potential, compose = Yoshida4)]
impl Twist {
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0].sin() * p[1].powi(2) + 0.5 * p[1] * p[1]
    }

    fn potential(&self, q: [f64; 2]) -> f64 {
        0.5 * self.stiffness * (q[0] * q[0] + q[1] * q[1])
    }
}
