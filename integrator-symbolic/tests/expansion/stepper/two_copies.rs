#[hamiltonian(split = symmetric(omega = self.coupling), compose = Yoshida4)]
impl Mixed {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        0.5 * (q[0] * q[0] + self.depth) * (p[0] * p[0] + 1.0) + 0.5 * p[1] * p[1] - q[1].cos()
    }
}
