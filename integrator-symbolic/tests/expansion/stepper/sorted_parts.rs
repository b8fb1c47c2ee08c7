#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl RestrictedThreeBody {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        let turning = 0.5 * (px * px + py * py) + y * px - x * py;
        let star = (1.0 - self.mass) / ((x + self.mass).powi(2) + y * y).sqrt();
        let planet = self.mass / ((x - 1.0 + self.mass).powi(2) + y * y).sqrt();
        turning - star - planet
    }
}
