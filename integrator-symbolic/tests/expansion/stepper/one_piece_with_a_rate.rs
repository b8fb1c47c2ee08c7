#[hamiltonian(split = none, compose = GaussLegendre<8>)]
impl Geodesic {
    fn hamiltonian(&self, [_, r, _]: [f64; 3], [pt, pr, pphi]: [f64; 3]) -> f64 {
        let metric = 1.0 - 2.0 * self.mass / r;
        0.5 * (metric * pr * pr + pphi * pphi / (r * r) - pt * pt / metric)
    }
    fn rate(&self, [_, r, _]: [f64; 3]) -> f64 {
        1.0 / (r * r.sqrt())
    }
}
