#[hamiltonian(split = turning + potential, compose = Yoshida4)]
impl<const N: usize> Frame<N> {
    fn turning(&self, q: [[f64; 2]; N], p: [[f64; 2]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            let [[x, y], [px, py]] = [q[i], p[i]];
            energy += (px * px + py * py) / (2.0 * self.mass[i]) + self.rate * (y * px - x * py) + Self::PUSH * x;
        }
        energy
    }
    fn potential(&self, q: [[f64; 2]; N]) -> f64 {
        q.iter().map(|[x, y]| (x * x + y * y).powi(2)).sum()
    }
}
