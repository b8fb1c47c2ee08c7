#[hamiltonian(split = far + 2 * (near + 8 * BlanesMoan4(bonds + kinetic)), compose = Yoshida4)]
impl Nested {
    fn far(&self, q: [f64; 1]) -> f64 {
        self.depth * q[0].cos()
    }

    fn near(&self, q: [f64; 1]) -> f64 {
        q[0].powi(4)
    }

    fn bonds(&self, q: [f64; 1]) -> f64 {
        0.5 * self.stiffness * q[0] * q[0]
    }

    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
}
