#[hamiltonian(gpu)]
impl Kepler {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|x| x * x).sum::<f64>() / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -self.attraction / q.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}
