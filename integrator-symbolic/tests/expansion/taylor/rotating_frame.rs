#[hamiltonian(split = none, taylor)]
impl Frame {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + self.rate * (y * px - x * py) + x * x * py.cos()
    }
}
