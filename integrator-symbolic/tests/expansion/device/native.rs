#[hamiltonian(gpu(functions = native))]
impl Swing {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.inertia)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.weight * (q[0].sin() + 1.0).ln() * q[0].cos().abs() + self.spring * q[0].cosh() - q[0].tanh()
    }
}
