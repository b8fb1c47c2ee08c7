#[hamiltonian(split = none, compose = GaussLegendre4)]
impl DoublePendulum {
    fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
        let (sine, cosine) = (a - b).sin_cos();
        let kinetic = (pa * pa + 2.0 * pb * pb - 2.0 * pa * pb * cosine) / (2.0 * (1.0 + sine * sine));
        kinetic - self.gravity * (2.0 * a.cos() + b.cos())
    }
}
